// Arguments that are unusual but allowed, as their concepts ask for no more: checks at compile time must let them pass.

#include "test_meshes.h"
#include "test_support.h"
#include "unusual_arguments.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>

#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/iterator.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

namespace {

using namespace unusual;
namespace Geodesics = CGAL::Surface_mesh_geodesics;
using Kernel = test_meshes::Kernel;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;
using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;

// A class that converts to a location.
struct Place
{
  Face face;
  operator Voronoi::Face_location() const { return Voronoi::Face_location(face, {.5, .25, .25}); }
};

// A visitor of paths that takes coordinates as a temporary object.
struct Path_visitor
{
  std::size_t number_of_elements = 0;
  void operator()(Vertex) { ++number_of_elements; }
  void operator()(Mesh::Halfedge_index, double) { ++number_of_elements; }
  void operator()(Face, Paths::Barycentric_coordinates&&) { ++number_of_elements; }
};

struct Any_visitor
{
  std::size_t number_of_elements = 0;
  template <typename... Element>
  auto operator()(Element&&...)
  {
    return ++number_of_elements;
  }
};

void meshes_and_maps()
{
  const Mesh mesh = test_meshes::to_face_graph(test_meshes::icosphere(1));
  const Face_graph graph(mesh);
  const Vertex v(3);
  CHECK(std::isfinite(Geodesics::geodesic_direction(graph, v, std::array<double, 3>{.3, 1., .2})));
  std::vector<double> distances(num_vertices(mesh), -1.);
  std::size_t number_of_puts = 0;
  Counting_map map;
  map.distances = &distances;
  map.number_of_puts = &number_of_puts;
  Geodesics::geodesic_distances(mesh, map, v);
  CHECK_EQUAL(number_of_puts, num_vertices(mesh));
  CHECK_EQUAL(distances[v], 0.);
  Paths paths(mesh);
  paths.add_source_point(v);
  paths.shortest_distances_to_source_points(map);
  CHECK_EQUAL(number_of_puts, 2 * num_vertices(mesh));
  Mesh copy(mesh);
  const auto numbers = copy.add_property_map<Vertex, Number>("v:number").first;
  paths.shortest_distances_to_source_points(numbers);
  for(const Vertex u : vertices(mesh))
    CHECK_EQUAL(numbers[u].value, distances[u]);
  paths.use_edge_lengths(boost::make_function_property_map<Mesh::Edge_index>([](Mesh::Edge_index) { return 1.f; }));
  CHECK(paths.farthest_vertex().second > 2.);
}

void ranges_and_output()
{
  const Mesh mesh = test_meshes::to_face_graph(test_meshes::icosphere(1));
  Voronoi diagram(mesh);
  diagram.add_sites(Range<Vertex>{{Vertex(0), Vertex(7)}});
  diagram.add_sites(std::vector<Place>{Place{Face(9)}});
  CHECK_EQUAL(diagram.number_of_sites(), 3u);
  diagram.avoid_faces(Range<Face>{{Face(3), Face(4)}});
  CHECK(diagram.avoids_face(Face(4)) && !diagram.avoids_face(Face(5)));
  diagram.avoid_faces(boost::make_function_property_map<Face>([](Face f) { return f == Face(5); }));
  CHECK(diagram.avoids_face(Face(5)) && !diagram.avoids_face(Face(4)));
  std::size_t number = 0;
  diagram.nearest_sites(Vertex(7), CGAL::Counting_output_iterator(&number));
  CHECK_EQUAL(number, 1u);
  diagram.dual(CGAL::Emptyset_iterator());
  Mesh cut;
  diagram.cut(cut, boost::dummy_property_map());
  CHECK(num_faces(cut) > num_faces(mesh));
  const std::array<Vertex, 1> site{Vertex(0)};
  CHECK(Geodesics::geodesic_Lloyd_relaxation(mesh, site, CGAL::Emptyset_iterator()) > 0);
}

void visitors_and_points_of_paths()
{
  const Mesh mesh = test_meshes::to_face_graph(test_meshes::icosphere(1));
  Paths paths(mesh);
  paths.add_source_point(Vertex(0));
  Path_visitor visitor;
  paths.shortest_path_sequence_to_source_points(Vertex(20), visitor);
  Any_visitor any;
  auto reference = std::ref(any);
  paths.shortest_path_sequence_to_source_points(Vertex(20), reference);
  CHECK(visitor.number_of_elements > 1);
  CHECK_EQUAL(any.number_of_elements, visitor.number_of_elements);
  std::size_t number = 0, called = 0;
  std::ostringstream text;
  paths.shortest_path_points_to_source_points(Vertex(20), Counting_output<Kernel::Point_3>{&number});
  paths.shortest_path_points_to_source_points(
    Vertex(20), boost::make_function_output_iterator([&called](const auto&) { ++called; }));
  paths.shortest_path_points_to_source_points(Vertex(20), std::ostream_iterator<Kernel::Point_3>(text));
  paths.shortest_path_points_to_source_points(Vertex(20), CGAL::Emptyset_iterator());
  CHECK_EQUAL(number, any.number_of_elements);
  CHECK_EQUAL(called, number);
  CHECK(!text.str().empty());
}

} // namespace

int main()
{
  meshes_and_maps();
  ranges_and_output();
  visitors_and_points_of_paths();
  return test_result();
}
