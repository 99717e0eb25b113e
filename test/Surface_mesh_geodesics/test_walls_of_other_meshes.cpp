// Edges to avoid on other types of meshes: edges that order themselves by a halfedge, graphs that lack elements of the
// graph below them, and graphs that count their elements in each call.

#include "Counting_mesh.h"
#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace test_meshes;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;
using SMG::Invalid_geodesic_input;

namespace {

// A range of walls is known by each halfedge of an edge, and ends a geodesic where a map of the same walls does.
void test_edges_ordered_by_a_halfedge()
{
  const test_support::Scope scope("linear cell complex");
  using Complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;
  using Graph_traits = boost::graph_traits<Complex>;
  const Complex tm = to_face_graph<Complex>(noisy_sphere(2, .2, 5));
  test_support::Random random(1);
  std::set<Graph_traits::halfedge_descriptor> halfedges_of_walls;
  std::vector<Graph_traits::edge_descriptor> walls, other_way;
  for(const auto e : edges(tm))
    if(random.index(4) == 0)
    {
      const auto h = halfedge(e, tm), o = opposite(h, tm);
      halfedges_of_walls.insert({h, o});
      walls.push_back(edge(h, tm));
      other_way.push_back(edge(o, tm));
    }
  const auto is_wall = boost::make_function_property_map<Graph_traits::edge_descriptor>(
    [&](Graph_traits::edge_descriptor e) { return halfedges_of_walls.count(halfedge(e, tm)) != 0; });
  std::size_t ended = 0;
  for(const auto f : faces(tm))
  {
    const std::pair<Graph_traits::face_descriptor, std::array<double, 3>> start(f, {.2, .3, .5});
    const double direction = random.uniform(0, 6.28);
    const auto expected = SMG::trace_geodesic(tm, start, direction, 5., np::edges_to_avoid(is_wall));
    ended += expected.length < 5 ? 1 : 0;
    CHECK_EQUAL(SMG::trace_geodesic(tm, start, direction, 5., np::edges_to_avoid(walls)).length, expected.length);
    CHECK_EQUAL(SMG::trace_geodesic(tm, start, direction, 5., np::edges_to_avoid(other_way)).length, expected.length);
  }
  CHECK(ended > 100);
}

// Elements of the graph below that are not in the filtered graph, and those of neither.
void test_filtered_graph()
{
  const test_support::Scope scope("filtered graph");
  using Filtered = CGAL::Face_filtered_graph<Mesh>;
  using edge_descriptor = boost::graph_traits<Mesh>::edge_descriptor;
  const Mesh tm = to_face_graph(flat_patch(4, 4, .1, true, 3));
  const std::vector<face_descriptor> part(faces(tm).begin(), std::next(faces(tm).begin(), 10));
  const Filtered filtered(tm, part);
  const vertex_descriptor source = *vertices(filtered).begin();
  const auto rejects = [&](const auto& parameters)
  {
    std::map<vertex_descriptor, double> distance;
    return throws<Invalid_geodesic_input>([&]
    { SMG::geodesic_distances(filtered, boost::make_assoc_property_map(distance), source, parameters); });
  };
  edge_descriptor outside = Mesh::null_edge();
  for(const edge_descriptor e : edges(tm))
    if(!filtered.is_in_cc(e))
      outside = e;
  CHECK(outside != Mesh::null_edge());
  for(const edge_descriptor e : {Mesh::null_edge(), edge_descriptor(12345), outside})
  {
    const std::vector<edge_descriptor> walls{e};
    CHECK(rejects(np::edges_to_avoid(walls)));
    CHECK(throws<Invalid_geodesic_input>([&]
    { SMG::trace_geodesic(filtered, source, 0., 1., np::edges_to_avoid(walls)); }));
  }
  const face_descriptor last(static_cast<Mesh::size_type>(num_faces(tm) - 1));
  for(const face_descriptor f : {Mesh::null_face(), face_descriptor(12345), last})
    CHECK(rejects(np::faces_to_avoid(std::vector<face_descriptor>{f})));
  const std::vector<edge_descriptor> inside{*edges(filtered).begin()};
  CHECK(!rejects(np::edges_to_avoid(inside)));
}

// Two components, so that the sources are looked at before the mesh is read. The number of elements is asked for as
// often for many obstacles and sources as for two.
void test_counting_graph()
{
  const test_support::Scope scope("counting graph");
  using Curve = SMG::Surface_curve<Counting_mesh>;
  using edge_descriptor = boost::graph_traits<Mesh>::edge_descriptor;
  Counting_mesh tm(to_face_graph(flat_patch(10, 10, .1, true, 3)));
  tm.add_face(tm.add_vertex({20, 0, 0}), tm.add_vertex({21, 0, 0}), tm.add_vertex({20, 1, 0}));
  const auto counts = [&](const auto& sources, const auto& parameters)
  {
    std::map<vertex_descriptor, double> distance;
    tm.counts = 0;
    SMG::geodesic_distances(tm, boost::make_assoc_property_map(distance), sources, parameters);
    CHECK_EQUAL(distance.size(), tm.number_of_vertices());
    return tm.counts;
  };
  const auto all_counts = [&](std::size_t n)
  {
    const auto face_at = [](std::size_t i) { return face_descriptor(static_cast<Mesh::size_type>(i)); };
    const auto first = vertices(tm).begin();
    const std::vector<vertex_descriptor> corners(first, std::next(first, static_cast<std::ptrdiff_t>(n)));
    std::vector<Face_location> locations, polyline;
    std::vector<Curve> curves;
    std::vector<face_descriptor> avoided;
    std::vector<edge_descriptor> walls;
    for(std::size_t i = 0; i < n; ++i)
    {
      locations.emplace_back(face_at(i), std::array<double, 3>{.2, .3, .5});
      const double t = .1 + .5 * static_cast<double>(i) / static_cast<double>(n);
      polyline.emplace_back(face_at(0), std::array<double, 3>{.2, t, .8 - t});
      curves.emplace_back(tm, locations.back());
      avoided.push_back(face_at(100 + i));
      walls.push_back(edge(halfedge(avoided.back(), tm), tm));
    }
    const std::set<face_descriptor> faces_of_map(avoided.begin(), avoided.end());
    const std::set<edge_descriptor> edges_of_map(walls.begin(), walls.end());
    const auto face_map = boost::make_function_property_map<face_descriptor>(
      [&](face_descriptor f) { return faces_of_map.count(f) != 0; });
    const auto edge_map = boost::make_function_property_map<edge_descriptor>(
      [&](edge_descriptor e) { return edges_of_map.count(e) != 0; });
    return std::vector<std::size_t>{
      counts(corners, np::default_values()), counts(locations, np::faces_to_avoid(avoided)),
      counts(locations, np::faces_to_avoid(face_map)), counts(corners, np::edges_to_avoid(walls)),
      counts(corners, np::edges_to_avoid(edge_map)), counts(Curve(tm, polyline), np::faces_to_avoid(avoided)),
      counts(curves, np::faces_to_avoid(avoided))};
  };
  const std::vector<std::size_t> few = all_counts(2), many = all_counts(40);
  for(std::size_t i = 0; i < few.size(); ++i)
    CHECK_EQUAL(few[i], many[i]);
  CHECK(few.front() > 0);
}

} // namespace

int main()
{
  test_edges_ordered_by_a_halfedge();
  test_filtered_graph();
  test_counting_graph();
  return test_result();
}
