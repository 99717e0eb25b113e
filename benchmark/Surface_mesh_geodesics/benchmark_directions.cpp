// The logarithmic map beside the distances: for each mesh and level of midpoint subdivision, the time of
// geodesic_distances() from vertex 0, that of an object for paths which computes the distances, and that of
// directions_at_source(). Prints one line of comma separated values; the ratios are the medians of those of runs in
// turn. Processor times, without reading the mesh from its file.

#include "benchmark_surface.h"
#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <vector>

namespace {

using Vertex = Benchmark_mesh::Vertex_index;
using Traits = CGAL::Surface_mesh_shortest_path_traits<CGAL::Kernel_traits<Benchmark_mesh::Point>::Kernel,
                                                       Benchmark_mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

void print_row(const Settings& settings, const std::string& file, std::size_t level, Benchmark_mesh& mesh)
{
  const auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  const auto direction = mesh.add_property_map<Vertex, double>("v:direction").first;
  const Vertex source = *mesh.vertices().begin();
  std::vector<double> distances, builds, directions, both;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    distances.push_back(milliseconds_of(
      settings.clock_id(), [&]() { CGAL::Surface_mesh_geodesics::geodesic_distances(mesh, distance, source); }));
    Paths paths(mesh);
    paths.add_source_point(source);
    builds.push_back(milliseconds_of(settings.clock_id(), [&]() { paths.build_sequence_tree(); }));
    directions.push_back(milliseconds_of(settings.clock_id(), [&]() { paths.directions_at_source(direction); }));
    both.push_back(builds.back() + directions.back());
  }
  std::cout << file_name(file) << ',' << level << ',' << mesh.number_of_faces() << ',' << cell(median(distances), 3)
            << ',' << cell(median(builds), 3) << ',' << cell(median(directions), 3) << ','
            << cell(median_ratio(directions, distances), 3) << ',' << cell(median_ratio(both, distances), 3)
            << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
    return usage(argv[0], " mesh...   (--subdivide K: levels up to K)");
  print_head(settings, "distances and directions of all vertices from vertex 0, processor times",
             "mesh,subdivisions,faces,distances_ms,build_ms,directions_ms,directions_ratio,both_ratio");
  return print_rows_by_level(settings, [&](const std::string& file, std::size_t level, Benchmark_mesh& mesh)
  { print_row(settings, file, level, mesh); });
}
