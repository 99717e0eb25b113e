// How the time depends on the number of sources: distances of all vertices from the nearest of 1, 10, 100 and 1000
// random vertices. Prints one line of comma separated values per mesh and number; processor times.

#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    return usage(argv[0], " mesh...");
  }
  print_head(settings, "distances of all vertices from the nearest of random sources, processor times",
             "mesh,faces,sources," + spread_columns("run_ms") + ",windows,ns_per_window");
  for(const std::string& file : settings.meshes)
  {
    Benchmark_mesh mesh;
    if(!read_mesh(file, settings.subdivisions, mesh))
    {
      return EXIT_FAILURE;
    }
    Geodesics::Geodesic_distance_solver<Benchmark_mesh> solver(mesh);
    for(const std::size_t number : {1u, 10u, 100u, 1000u})
    {
      const std::vector<Benchmark_vertex> sources = random_vertices(mesh, number);
      Geodesics::Propagation_statistics statistics;
      const Spread run = repeated(settings, settings.clock_id(), [&]() {
        statistics = Geodesics::Propagation_statistics();
        solver.compute_distances(sources, CGAL::parameters::statistics(&statistics));
      });
      std::cout << file_name(file) << ',' << mesh.number_of_faces() << ',' << number << ',' << run << ','
                << statistics.windows_propagated << ','
                << cell(1e6 * run.middle / static_cast<double>(statistics.windows_propagated), 2) << std::endl;
    }
  }
  return EXIT_SUCCESS;
}
