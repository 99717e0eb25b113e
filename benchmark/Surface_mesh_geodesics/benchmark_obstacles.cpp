// What obstacles cost: for each mesh and level of midpoint subdivision, the time of geodesic_distances() from vertex 0
// with no faces to avoid, with an empty range of them, and with a tenth of the faces, in 20 patches; then that on the
// rest of the mesh, once as a Face_filtered_graph, once as a mesh of its own. Prints one line of comma separated
// values; the ratios are the medians of those of runs in turn. Processor times of whole calls; making the rest is not
// counted.

#include "benchmark_surface.h"
#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace {

using Vertex = Benchmark_mesh::Vertex_index;
using Face = Benchmark_mesh::Face_index;

// Patches of the same size, around faces that are evenly spread over the numbers. Patches do not share faces; a patch
// ends early where others surround it.
std::vector<Face> patches(const Benchmark_mesh& mesh, std::size_t number, std::size_t faces_in_all)
{
  std::vector<bool> is_taken(mesh.number_of_faces(), false);
  std::vector<Face> result;
  for(std::size_t i = 1; i <= number; ++i)
  {
    Face seed(static_cast<Benchmark_mesh::size_type>(i * mesh.number_of_faces() / (number + 1)));
    while(is_taken[seed])
      seed = Face((seed + 1) % static_cast<Benchmark_mesh::size_type>(mesh.number_of_faces()));
    is_taken[seed] = true;
    std::vector<Face> patch{seed};
    for(std::size_t k = 0; k < patch.size() && patch.size() < faces_in_all / number; ++k)
      for(const Face f : faces_around_face(mesh.halfedge(patch[k]), mesh))
        if(f != Benchmark_mesh::null_face() && !is_taken[f])
        {
          is_taken[f] = true;
          patch.push_back(f);
        }
    result.insert(result.end(), patch.begin(), patch.end());
  }
  return result;
}

// The vertex of the rest at the place of vertex 0; the null vertex if that is inside of a patch.
Vertex first_vertex(const Benchmark_mesh& mesh, const Benchmark_mesh& rest)
{
  for(const Vertex v : rest.vertices())
    if(rest.point(v) == mesh.point(Vertex(0)))
      return v;
  return Benchmark_mesh::null_vertex();
}

void print_row(const Settings& settings, const std::string& file, std::size_t level, Benchmark_mesh& mesh)
{
  const auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  const std::vector<Face> none, avoided = patches(mesh, 20, mesh.number_of_faces() / 10);
  const auto is_avoided = mesh.add_property_map<Face, int>("f:avoided", 0).first;
  for(const Face f : avoided)
    is_avoided[f] = 1;
  const CGAL::Face_filtered_graph<Benchmark_mesh> filtered(mesh, 0, is_avoided);
  Benchmark_mesh rest;
  CGAL::copy_face_graph(filtered, rest);
  const auto distance_in_rest = rest.add_property_map<Vertex, double>("v:distance").first;
  const Vertex source(0), source_in_rest = first_vertex(mesh, rest);
  if(source_in_rest == Benchmark_mesh::null_vertex())
  {
    std::cerr << file << ": vertex 0 is inside of a patch" << std::endl;
    return;
  }
  std::vector<double> alone, with_none, with_avoided, on_filtered, on_rest;
  for(std::size_t i = 0; i < settings.repetitions; ++i)
  {
    namespace Geodesics = CGAL::Surface_mesh_geodesics;
    const auto time = [&](auto call) { return milliseconds_of(settings.clock_id(), call); };
    alone.push_back(time([&]() { Geodesics::geodesic_distances(mesh, distance, source); }));
    with_none.push_back(time([&]() {
      Geodesics::geodesic_distances(mesh, distance, source, CGAL::parameters::faces_to_avoid(none));
    }));
    with_avoided.push_back(time([&]() {
      Geodesics::geodesic_distances(mesh, distance, source, CGAL::parameters::faces_to_avoid(avoided));
    }));
    on_filtered.push_back(time([&]() { Geodesics::geodesic_distances(filtered, distance, source); }));
    on_rest.push_back(time([&]() { Geodesics::geodesic_distances(rest, distance_in_rest, source_in_rest); }));
  }
  std::cout << file_name(file) << ',' << level << ',' << mesh.number_of_faces() << ',' << avoided.size() << ','
            << cell(median(alone), 1) << ',' << cell(median(with_none), 1) << ',' << cell(median(with_avoided), 1)
            << ',' << cell(median(on_filtered), 1) << ',' << cell(median(on_rest), 1) << ','
            << cell(median_ratio(with_none, alone), 3) << ',' << cell(median_ratio(with_avoided, on_rest), 3) << ','
            << cell(median_ratio(on_filtered, on_rest), 3) << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  Settings settings;
  if(!read_settings(argc, argv, settings, [](const std::string&, const std::string&) { return false; }))
    return usage(argv[0], " mesh...   (--subdivide K: levels up to K)");
  print_head(settings, "distances of all vertices from vertex 0 with faces to avoid, processor times of whole calls",
             "mesh,subdivisions,faces,faces_avoided,distances_ms,none_avoided_ms,avoided_ms,filtered_ms,rest_ms,"
             "none_ratio,avoided_ratio,filtered_ratio");
  return print_rows_by_level(settings, [&](const std::string& file, std::size_t level, Benchmark_mesh& mesh)
  { print_row(settings, file, level, mesh); });
}
