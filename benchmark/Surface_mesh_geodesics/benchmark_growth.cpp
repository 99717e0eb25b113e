// How time and memory grow with the mesh: a mesh and its midpoint subdivisions, distances of all vertices from
// vertex 0. Prints one line of comma separated values per level. Reading the user's mesh is timed on its own; it
// is the construction of a solver. Times are processor times.
//
// Several threads read the mesh, too, as many as the processor has: the speedup is the median of the ratios of elapsed
// times of adjacent runs. Without TBB (CGAL_LINKED_WITH_TBB), it is about 1.

#include "runs_in_process.h"
#include "thread_counts.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>

#include <memory>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

template <typename Tag>
void read_with(const Benchmark_mesh& mesh)
{
  const Geodesics::Geodesic_distance_solver<Benchmark_mesh, Tag> solver(mesh);
}

// How many times as fast all threads read a mesh.
double reading_speedup(const Settings& settings, const Benchmark_mesh& mesh)
{
  const Scaling scaling(settings, [&](std::size_t threads) {
    threads == 0 ? read_with<CGAL::Sequential_tag>(mesh) : read_with<Parallel>(mesh);
  });
  return scaling.entries().back().speedup;
}

int main(int argc, char* argv[])
{
  Settings settings;
  settings.subdivisions = 2;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    return usage(argv[0], " mesh...   (--subdivide K: levels up to K, default 2)");
  }
  print_head(settings, "distances of all vertices from vertex 0, processor times",
             "mesh,subdivisions,faces,vertices," + spread_columns("read_ms") + ',' + spread_columns("run_ms")
               + ",read_share,reading_speedup,windows,lists,visits,windows_per_face,ns_per_window,mesh_bytes_per_face,"
                 "window_mb");
  for(const std::string& file : settings.meshes)
  {
    for(std::size_t level = 0; level <= settings.subdivisions; ++level)
    {
      Benchmark_mesh mesh;
      if(!read_mesh(file, level, mesh))
      {
        return EXIT_FAILURE;
      }
      std::unique_ptr<Geodesics::Geodesic_distance_solver<Benchmark_mesh>> solver;
      const Spread read = repeated(settings, settings.clock_id(), [&]() {
        solver.reset();
        solver = std::make_unique<Geodesics::Geodesic_distance_solver<Benchmark_mesh>>(mesh);
      });
      Geodesics::Propagation_statistics statistics;
      const Spread run = repeated(settings, settings.clock_id(), [&]() {
        statistics = Geodesics::Propagation_statistics();
        solver->compute_distances(*mesh.vertices().begin(), CGAL::parameters::statistics(&statistics));
      });
      const double faces = static_cast<double>(mesh.number_of_faces());
      const double windows = static_cast<double>(statistics.windows_propagated);
      std::cout << file_name(file) << ',' << level << ',' << mesh.number_of_faces() << ',' << mesh.number_of_vertices()
                << ',' << read << ',' << run << ',' << cell(read.middle / (read.middle + run.middle), 3) << ','
                << cell(reading_speedup(settings, mesh), 2) << ','
                << statistics.windows_propagated << ',' << statistics.window_lists << ','
                << statistics.vertices_visited << ',' << cell(windows / faces, 2) << ','
                << cell(1e6 * run.middle / windows, 2) << ','
                << cell(static_cast<double>(statistics.intrinsic_mesh_bytes) / faces, 1) << ','
                << cell(static_cast<double>(statistics.maximum_window_bytes) / (1 << 20), 2) << std::endl;
    }
  }
  return EXIT_SUCCESS;
}
