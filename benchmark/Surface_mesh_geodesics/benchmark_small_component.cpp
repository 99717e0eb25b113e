// A source on a small component beside a large mesh: what geodesic_distances() pays for the part that the source does
// not reach. Each mesh gets a component of 80 faces, an icosahedron whose faces are divided once. Prints one line of
// comma separated values per mesh: the same call with a source on the large part, with one on the small component, and
// on that component as a mesh of its own; and CGAL::Surface_mesh_shortest_path with the source on the small component.
// Times are processor times. Fails if the methods disagree.

#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/generators.h>

#include <limits>

namespace {

namespace Geodesics = CGAL::Surface_mesh_geodesics;

Benchmark_mesh small_component()
{
  Benchmark_mesh result;
  CGAL::make_icosahedron(result, Benchmark_kernel::Point_3(0, 0, 0), 1.);
  return midpoint_subdivision(result);
}

// Writes the distances by the original: infinity where there is no path.
void original_distances(const Benchmark_mesh& mesh, Benchmark_vertex source, Benchmark_distance_map distances)
{
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Benchmark_kernel, Benchmark_mesh>;
  CGAL::Surface_mesh_shortest_path<Traits> paths(mesh);
  paths.add_source_point(source);
  for(const Benchmark_vertex v : mesh.vertices())
  {
    const double d = paths.shortest_distance_to_source_points(v).first;
    distances[v] = d < 0 ? std::numeric_limits<double>::infinity() : d;
  }
}

// Returns false if the methods disagree.
bool print_row(const Settings& settings, const std::string& file, Benchmark_mesh& mesh)
{
  const Benchmark_mesh small = small_component();
  const std::size_t faces_of_rest = mesh.number_of_faces();
  const Benchmark_vertex on_large = *mesh.vertices().begin();
  const Benchmark_vertex on_small(static_cast<Benchmark_mesh::size_type>(mesh.number_of_vertices()));
  mesh += small;
  Benchmark_mesh alone = small;
  const Benchmark_distance_map distance = mesh.add_property_map<Benchmark_vertex, double>("v:distance").first;
  const Benchmark_distance_map by_original = mesh.add_property_map<Benchmark_vertex, double>("v:by_original").first;
  const Benchmark_distance_map distance_alone = alone.add_property_map<Benchmark_vertex, double>("v:distance").first;
  const auto spread = [&](const auto& function) { return repeated(settings, settings.clock_id(), function); };
  const Spread large_ms = spread([&]() { Geodesics::geodesic_distances(mesh, distance, on_large); });
  const Spread alone_ms
    = spread([&]() { Geodesics::geodesic_distances(alone, distance_alone, *alone.vertices().begin()); });
  const Spread original_ms = spread([&]() { original_distances(mesh, on_small, by_original); });
  const Spread small_ms = spread([&]() { Geodesics::geodesic_distances(mesh, distance, on_small); });
  std::cout << file_name(file) << ',' << faces_of_rest << ',' << small.number_of_faces() << ',' << large_ms << ','
            << small_ms << ',' << alone_ms << ',' << original_ms << ','
            << cell(original_ms.middle / small_ms.middle, 2) << std::endl;
  return largest_relative_difference(values_of(distance, mesh), values_of(by_original, mesh)) <= 1e-12;
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
    return usage(argv[0], " mesh...");
  print_head(settings, "distances of all vertices from a vertex of a small component, processor times",
             "mesh,faces,component_faces," + spread_columns("large_ms") + ',' + spread_columns("small_ms") + ','
               + spread_columns("alone_ms") + ',' + spread_columns("original_ms") + ",ratio");
  for(const std::string& file : settings.meshes)
  {
    Benchmark_mesh mesh;
    if(!read_mesh(file, settings.subdivisions, mesh))
      return EXIT_FAILURE;
    if(!print_row(settings, file, mesh))
    {
      std::cerr << "the methods disagree on " << file << std::endl;
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}
