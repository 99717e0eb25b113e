// Edges to avoid on other types of meshes: edges that order themselves by a halfedge, and graphs that lack elements of
// the graph below them.

#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
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

} // namespace

int main()
{
  test_edges_ordered_by_a_halfedge();
  test_filtered_graph();
  return test_result();
}
