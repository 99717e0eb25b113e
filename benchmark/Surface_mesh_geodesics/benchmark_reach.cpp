// The cost of a computation that ends early, with a solver that is used again and again: distances within a radius, and
// up to one target. Prints one line of comma separated values per mesh, level of midpoint subdivision and reach, which
// is given as a part of the largest distance; processor times. The cost should depend on the area reached, not on the
// size of the mesh: compare the times per vertex reached.

#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>

#include <iterator>
#include <vector>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

using Solver = Geodesics::Geodesic_distance_solver<Benchmark_mesh>;

// The vertex whose distance is nearest to the given one.
Benchmark_vertex vertex_at(const Benchmark_mesh& mesh, const std::vector<double>& distances, double distance)
{
  return *std::min_element(mesh.vertices().begin(), mesh.vertices().end(), [&](Benchmark_vertex v, Benchmark_vertex w) {
    return std::abs(distances[v] - distance) < std::abs(distances[w] - distance);
  });
}

// `limits` are the named parameters that end a computation early.
template <class NamedParameters>
void print_reach(const Settings& settings, const std::string& name, Solver& solver, const Benchmark_mesh& mesh,
                 Benchmark_vertex source, const std::string& kind, double part, const NamedParameters& limits)
{
  Geodesics::Propagation_statistics statistics;
  const auto np = limits.statistics(&statistics);
  solver.compute_distances(source, np); // clears the results of a run with another reach
  const Spread run = repeated(settings, settings.clock_id(), [&]() {
    statistics = Geodesics::Propagation_statistics();
    solver.compute_distances(source, np);
  });
  std::vector<Benchmark_vertex> reached;
  solver.vertices_reached(std::back_inserter(reached));
  std::cout << name << ',' << mesh.number_of_faces() << ',' << kind << ',' << part << ',' << run << ','
            << reached.size() << ',' << statistics.windows_propagated << ','
            << cell(1e3 * run.middle / static_cast<double>(reached.size()), 3) << std::endl;
}

int main(int argc, char* argv[])
{
  Settings settings;
  settings.subdivisions = 1;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    return usage(argv[0], " mesh...   (--subdivide K: levels up to K, default 1)");
  }
  print_head(settings, "computations that end early, processor times",
             "mesh,faces,end,part_of_largest_distance," + spread_columns("run_ms")
               + ",vertices_reached,windows,us_per_vertex");
  for(const std::string& file : settings.meshes)
  {
    for(std::size_t level = 0; level <= settings.subdivisions; ++level)
    {
      Benchmark_mesh mesh;
      if(!read_mesh(file, level, mesh))
      {
        return EXIT_FAILURE;
      }
      const Benchmark_vertex source = *mesh.vertices().begin();
      Solver solver(mesh);
      solver.compute_distances(source);
      std::vector<double> distances;
      double largest = 0;
      for(const Benchmark_vertex v : mesh.vertices())
      {
        distances.push_back(solver.distance(v));
        largest = std::isfinite(distances.back()) ? (std::max)(largest, distances.back()) : largest;
      }
      for(const double part : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.})
      {
        print_reach(settings, file_name(file), solver, mesh, source, "radius", part,
                    CGAL::parameters::maximum_distance(part * largest));
        const std::vector<Benchmark_vertex> target = {vertex_at(mesh, distances, part * largest)};
        print_reach(settings, file_name(file), solver, mesh, source, "target", part, CGAL::parameters::targets(target));
      }
    }
  }
  return EXIT_SUCCESS;
}
