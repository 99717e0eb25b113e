// How Surface_mesh_geodesic_paths treats bad input: invalid sources, queries and meshes, removed elements, vertices and
// edges without faces.

#include "path_interface_helpers.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <limits>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

// Vertices and edges without faces have no location; border halfedges have one.
void vertices_and_edges_without_faces_have_no_location()
{
  test_support::Scope scope("locations without faces");
  const face_descriptor none = boost::graph_traits<Mesh>::null_face();
  Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(Geodesic_paths::face_location(v, tm).first == none, tm.is_isolated(v));
  }
  const vertex_descriptor a = tm.add_vertex(Kernel::Point_3(0., 0., 9.));
  const vertex_descriptor b = tm.add_vertex(Kernel::Point_3(1., 0., 9.));
  const auto h = halfedge(CGAL::add_edge(tm), tm); // a single edge
  set_target(h, b, tm);
  set_target(opposite(h, tm), a, tm);
  set_next(h, opposite(h, tm), tm);
  set_next(opposite(h, tm), h, tm);
  set_halfedge(b, h, tm);
  set_halfedge(a, opposite(h, tm), tm);
  set_face(h, none, tm);
  set_face(opposite(h, tm), none, tm);
  CHECK(Geodesic_paths::face_location(a, tm).first == none && Geodesic_paths::face_location(b, tm).first == none);
  CHECK(Geodesic_paths::face_location(h, .5, tm).first == none);
  for(const auto border : halfedges(tm))
  {
    if(is_border(border, tm) && !is_border(opposite(border, tm), tm))
    {
      const auto l = Geodesic_paths::face_location(border, .25, tm);
      CHECK(l.first == face(opposite(border, tm), tm));
      CHECK_NEAR(length(to_coordinates(Geodesic_paths::point(l.first, l.second, tm)) -
                        to_coordinates(Geodesic_paths::point(border, .25, tm))), 0., 1e-13);
    }
  }
}

void vertices_without_faces_have_a_null_location()
{
  test_support::Scope scope("vertices without faces");
  Mesh tm = to_face_graph(fan("fan", 5, .1, -.2));
  const vertex_descriptor isolated = tm.add_vertex(Kernel::Point_3(3., 0., 0.));
  CHECK(Geodesic_paths::face_location(vertex(0), tm).first != boost::graph_traits<Mesh>::null_face());
  // the edges of the faces remain, with the border on both sides
  for(const auto h : tm.halfedges())
  {
    tm.set_face(h, boost::graph_traits<Mesh>::null_face());
  }
  for(const vertex_descriptor v : {vertex(0), vertex(1), isolated})
  {
    CHECK(Geodesic_paths::face_location(v, tm).first == boost::graph_traits<Mesh>::null_face());
    Geodesic_paths paths(tm);
    CHECK(paths.face_location(v).first == boost::graph_traits<Mesh>::null_face());
    CHECK(paths.add_source_point(v)->first == boost::graph_traits<Mesh>::null_face());
  }
}

void bad_sources_and_queries_are_rejected()
{
  test_support::Scope scope("exceptions");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  const std::size_t n = num_vertices(tm);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  const double expected = paths.shortest_distance_to_source_points(vertex(5)).first;
  auto object_is_valid = [&]
  {
    paths.remove_all_source_points();
    paths.add_source_point(vertex(0));
    CHECK_EQUAL(paths.shortest_distance_to_source_points(vertex(5)).first, expected);
    CHECK_EQUAL(ask(paths, Surface_point(Face_location(face(4), {.2, .3, .5}))).source, 0u);
  };

  // sources
  for(const Geodesic_paths::Barycentric_coordinates& b :
      {Geodesic_paths::Barycentric_coordinates{.5, .5, .5}, {-.1, .5, .6}, {nan, .5, .5}, {0., 0., 0.}, {2., -1., 0.}})
  {
    paths.add_source_point(face(2), b);
    CHECK(throws_reason(Reason::INVALID_LOCATION, [&] { paths.build_sequence_tree(); }));
    CHECK(paths.changed_since_last_build());
    CHECK(throws_reason(Reason::INVALID_LOCATION,
                        [&] { static_cast<void>(paths.shortest_distance_to_source_points(vertex(5))); }));
    object_is_valid();
    // queries
    CHECK(throws_reason(Reason::INVALID_LOCATION,
                        [&] { static_cast<void>(paths.shortest_distance_to_source_points(face(2), b)); }));
    object_is_valid();
  }
  paths.add_source_point(face(num_faces(tm)), {.2, .3, .5});
  CHECK(throws_reason(Reason::INVALID_DESCRIPTOR, [&] { paths.build_sequence_tree_for_faces(); }));
  object_is_valid();
  paths.add_source_point(boost::graph_traits<Mesh>::null_face(), {.2, .3, .5});
  CHECK(throws_reason(Reason::INVALID_LOCATION, [&] { paths.build_sequence_tree(); }));
  object_is_valid();
  CHECK(throws_reason(Reason::INVALID_DESCRIPTOR,
                      [&] { static_cast<void>(paths.shortest_distance_to_source_points(vertex(n))); }));
  CHECK(throws_reason(Reason::INVALID_DESCRIPTOR, [&]
  {
    static_cast<void>(paths.shortest_distance_to_source_points(face(num_faces(tm)), {.2, .3, .5}));
  }));
  object_is_valid();
}

void bad_meshes_are_rejected()
{
  test_support::Scope scope("bad meshes");
  {
    Mesh quadrangle;
    const auto a = quadrangle.add_vertex(Kernel::Point_3(0., 0., 0.));
    const auto b = quadrangle.add_vertex(Kernel::Point_3(1., 0., 0.));
    const auto c = quadrangle.add_vertex(Kernel::Point_3(1., 1., 0.));
    const auto d = quadrangle.add_vertex(Kernel::Point_3(0., 1., 0.));
    quadrangle.add_face(a, b, c, d);
    Geodesic_paths p(quadrangle);
    p.add_source_point(a);
    CHECK(throws_reason(Reason::NOT_A_TRIANGLE, [&] { p.build_sequence_tree(); }));
    CHECK(throws_reason(Reason::NOT_A_TRIANGLE,
                        [&] { static_cast<void>(p.shortest_distance_to_source_points(b)); }));
  }
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  Geodesic_paths right(tm);
  right.add_source_point(vertex(0));
  Mesh bad = tm;
  bad.point(vertex(7)) = Kernel::Point_3(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  Geodesic_paths p(bad);
  p.add_source_point(vertex(0));
  CHECK(throws_reason(Reason::NON_FINITE_POINT, [&] { p.build_sequence_tree_for_faces(); }));
  // repairs the mesh
  bad.point(vertex(7)) = tm.point(vertex(7));
  p.clear();
  p.add_source_point(vertex(0));
  CHECK_EQUAL(p.shortest_distance_to_source_points(vertex(5)).first,
              right.shortest_distance_to_source_points(vertex(5)).first);
}

// Without sources nothing is built, but queries still check their descriptors.
void bad_queries_without_sources_are_rejected()
{
  test_support::Scope scope("queries without sources");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  const vertex_descriptor no_vertex = boost::graph_traits<Mesh>::null_vertex();
  const face_descriptor no_face = boost::graph_traits<Mesh>::null_face();
  const face_descriptor foreign(static_cast<Mesh::size_type>(num_faces(tm)));
  Geodesic_paths paths(tm);
  const Geodesic_paths& constant = paths;
  Path_recorder<Geodesic_paths> recorder;
  for(const bool had_sources : {false, true})
  {
    if(had_sources)
    {
      paths.add_source_point(vertex(0));
      paths.build_sequence_tree();
      paths.remove_all_source_points();
      paths.build_sequence_tree_for_faces();
    }
    for(const vertex_descriptor bad : {no_vertex, vertex(num_vertices(tm))})
    {
      CHECK(throws_reason(Reason::INVALID_DESCRIPTOR,
                          [&] { static_cast<void>(paths.shortest_distance_to_source_points(bad)); }));
      CHECK(throws_reason(Reason::INVALID_DESCRIPTOR,
                          [&] { static_cast<void>(constant.shortest_distance_to_source_points(bad)); }));
      CHECK(throws_reason(Reason::INVALID_DESCRIPTOR,
                          [&] { static_cast<void>(constant.nearest_source_point(bad)); }));
      CHECK(throws_reason(Reason::INVALID_DESCRIPTOR,
                          [&] { paths.shortest_path_sequence_to_source_points(bad, recorder); }));
    }
    const auto refuses_location
      = [&](Reason reason, face_descriptor f, const Geodesic_paths::Barycentric_coordinates& b)
    {
      return throws_reason(reason, [&] { static_cast<void>(paths.shortest_distance_to_source_points(f, b)); })
          && throws_reason(reason, [&] { static_cast<void>(constant.nearest_source_point(f, b)); })
          && throws_reason(reason, [&] { paths.shortest_path_sequence_to_source_points(f, b, recorder); });
    };
    CHECK(refuses_location(Reason::INVALID_LOCATION, no_face, {.2, .3, .5}));
    CHECK(refuses_location(Reason::INVALID_DESCRIPTOR, foreign, {.2, .3, .5}));
    CHECK(refuses_location(Reason::INVALID_LOCATION, face(0), {.2, .3, .6}));
    CHECK_EQUAL(paths.shortest_distance_to_source_points(vertex(1)).first, -1.);
    CHECK_EQUAL(paths.shortest_distance_to_source_points(face(0), {.2, .3, .5}).first, -1.);
  }
  CHECK(recorder.items.empty());
}

// Returns the message of the exception that f() throws.
template <class Function>
std::string message_of(Function f)
{
  try
  {
    f();
  }
  catch(const CGAL::Surface_mesh_geodesics::Invalid_geodesic_input& e)
  {
    return e.what();
  }
  return std::string();
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A source has its number in the message. A query has none.
void messages_name_the_culprit()
{
  test_support::Scope scope("messages");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  const vertex_descriptor no_vertex = boost::graph_traits<Mesh>::null_vertex();
  for(const vertex_descriptor bad : {no_vertex, vertex(num_vertices(tm))})
  {
    Geodesic_paths paths(tm);
    paths.add_source_point(vertex(0));
    paths.add_source_point(bad);
    CHECK(has(message_of([&] { paths.build_sequence_tree(); }), "source 1 is not a vertex of the mesh"));
    CGAL::Surface_mesh_geodesic_Voronoi_diagram<Paths_traits> diagram(tm);
    diagram.add_site(vertex(0));
    diagram.add_site(bad);
    CHECK(has(message_of([&] { diagram.build(); }), "site 1 is not a vertex of the mesh"));
  }
  const std::vector<face_descriptor> avoided{face(0), face(num_faces(tm))};
  CHECK(has(message_of(
              [&]
              {
                CGAL::Surface_mesh_geodesics::geodesic_distance(tm, vertex(0), vertex(1),
                                                                CGAL::parameters::faces_to_avoid(avoided));
              }),
            "the face to avoid 1 is not a face of the mesh"));
  for(const bool has_source : {false, true})
  {
    Geodesic_paths paths(tm);
    if(has_source)
    {
      paths.add_source_point(vertex(0));
    }
    CHECK(has(message_of([&] { paths.shortest_distance_to_source_points(no_vertex); }), "the query is not a vertex"));
    CHECK(has(message_of([&] { paths.shortest_distance_to_source_points(face(0), {.2, .3, .6}); }),
              "the query is not in its face"));
    CHECK(has(message_of([&] { paths.shortest_distance_to_source_points(face(num_faces(tm)), {.2, .3, .5}); }),
              "the query has a face that is not one of the mesh"));
  }
}

// Removed elements keep their indices, and their links are meaningless.
void removed_elements_are_rejected()
{
  test_support::Scope scope("removed elements");
  Mesh tm = to_face_graph(flat_patch(6, 6, 0., false, 1));
  for(std::size_t f = 0; f < 24; ++f)
  {
    CGAL::Euler::remove_face(halfedge(face(f), tm), tm);
  }
  std::size_t number = 0;
  for(std::size_t i = 0; i < num_vertices(tm); ++i)
  {
    const vertex_descriptor v = vertex(i);
    if(!tm.is_removed(v))
    {
      continue;
    }
    ++number;
    Geodesic_paths paths(tm);
    CHECK(throws_reason(Reason::INVALID_DESCRIPTOR,
                        [&] { static_cast<void>(paths.shortest_distance_to_source_points(v)); }));
    paths.add_source_point(v);
    CHECK(throws_reason(Reason::INVALID_DESCRIPTOR, [&] { paths.build_sequence_tree(); }));
    paths.remove_all_source_points();
    paths.add_source_point(face(30), {.2, .3, .5});
    CHECK(throws_reason(Reason::INVALID_DESCRIPTOR,
                        [&] { static_cast<void>(paths.shortest_distance_to_source_points(v)); }));
    CHECK(throws_reason(Reason::INVALID_DESCRIPTOR, [&]
                        { static_cast<void>(paths.shortest_distance_to_source_points(face(3), {.2, .3, .5})); }));
  }
  CHECK(number >= 6);
}

} // namespace

int main()
{
  messages_name_the_culprit();
  test_support::announce_seed(20260403);
  vertices_and_edges_without_faces_have_no_location();
  vertices_without_faces_have_a_null_location();
  bad_sources_and_queries_are_rejected();
  bad_meshes_are_rejected();
  bad_queries_without_sources_are_rejected();
  removed_elements_are_rejected();
  return test_result();
}
