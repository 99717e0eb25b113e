// One source, 1, 2, ... threads: geodesic_distances() from vertex 0 with the parallel tag, compared with the sequential
// tag. Prints one line of comma separated values per mesh, level of midpoint subdivision and number of threads. Times
// are elapsed times of the whole call, with reading the mesh: the machine must be idle. Runs with different numbers of
// threads alternate, and the speedup is the median of the ratios of adjacent runs. Without TBB (CGAL_LINKED_WITH_TBB),
// only the sequential tag is measured.

#include "runs_in_process.h"
#include "thread_counts.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

namespace Geodesics = CGAL::Surface_mesh_geodesics;

int main(int argc, char* argv[])
{
  Settings settings;
  settings.subdivisions = 2;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
  {
    return usage(argv[0], " mesh...   (--subdivide K: levels up to K, default 2)");
  }
  print_head(settings, "distances of all vertices from vertex 0 by several threads, clock times",
             "mesh,subdivisions,faces,threads," + spread_columns("call_ms") + ",speedup,windows");
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
      auto distances = mesh.add_property_map<Benchmark_vertex, double>("v:distance", 0.).first;
      std::size_t windows[2] = {0, 0}; // of the sequential and the parallel runs
      const Scaling scaling(settings, [&](std::size_t threads) {
        Geodesics::Propagation_statistics statistics;
        const auto np = CGAL::parameters::statistics(&statistics);
        if(threads == 0)
          Geodesics::geodesic_distances(mesh, distances, source, np);
        else
          Geodesics::geodesic_distances<Parallel>(mesh, distances, source, np);
        windows[threads == 0 ? 0 : 1] = statistics.windows_propagated;
      });
      for(const auto& entry : scaling.entries())
      {
        std::cout << file_name(file) << ',' << level << ',' << mesh.number_of_faces() << ',' << entry.name << ','
                  << entry.time << ',' << cell(entry.speedup, 3) << ','
                  << windows[entry.name == "sequential" ? 0 : 1] << std::endl;
      }
    }
  }
  return EXIT_SUCCESS;
}
