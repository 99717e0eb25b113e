// The cost of long thin triangles: a torus of 40,000 faces, stretched along one axis by 1, 2, 4, 8 and 16. Prints one
// line of comma separated values per stretch: distances of all vertices from vertex 0, processor times.

#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>

#include <cmath>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

// A torus around the z axis with m times n vertices.
Benchmark_mesh stretched_torus(std::size_t m, std::size_t n, double stretch)
{
  Benchmark_mesh mesh;
  const double turn = 2 * std::acos(-1.);
  const auto vertex = [&](std::size_t i, std::size_t j) {
    return Benchmark_vertex(static_cast<Benchmark_mesh::size_type>((i % m) * n + j % n));
  };
  for(std::size_t i = 0; i < m; ++i)
  {
    for(std::size_t j = 0; j < n; ++j)
    {
      const double a = turn * static_cast<double>(i) / static_cast<double>(m);
      const double b = turn * static_cast<double>(j) / static_cast<double>(n);
      const double r = 1 + 0.4 * std::cos(b);
      mesh.add_vertex(Benchmark_kernel::Point_3(stretch * r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)));
    }
  }
  for(std::size_t i = 0; i < m; ++i)
  {
    for(std::size_t j = 0; j < n; ++j)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
  return mesh;
}

int main(int argc, char* argv[])
{
  Settings settings;
  settings.meshes = {"torus"};
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    return usage(argv[0], "");
  }
  print_head(settings, "a torus stretched along one axis, processor times",
             "stretch,faces," + spread_columns("run_ms") + ",windows,lists,ns_per_window");
  for(const double stretch : {1., 2., 4., 8., 16.})
  {
    const Benchmark_mesh mesh = stretched_torus(200, 100, stretch);
    Geodesics::Geodesic_distance_solver<Benchmark_mesh> solver(mesh);
    Geodesics::Propagation_statistics statistics;
    const Spread run = repeated(settings, settings.clock_id(), [&]() {
      statistics = Geodesics::Propagation_statistics();
      solver.compute_distances(*mesh.vertices().begin(), CGAL::parameters::statistics(&statistics));
    });
    std::cout << stretch << ',' << mesh.number_of_faces() << ',' << run << ',' << statistics.windows_propagated << ','
              << statistics.window_lists << ','
              << cell(1e6 * run.middle / static_cast<double>(statistics.windows_propagated), 2) << std::endl;
  }
  return EXIT_SUCCESS;
}
