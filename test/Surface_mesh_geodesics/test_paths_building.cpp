// When Surface_mesh_geodesic_paths computes what: states, iterators that survive builds, const queries, edge lengths.

#include "path_interface_helpers.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/iterator/transform_iterator.hpp>

#include <cmath>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

// --- states and iterators ---

// Adds and removes sources, and builds in between.
void sources_come_and_go()
{
  test_support::Scope scope("states");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  Geodesic_paths paths(tm);
  const Geodesic_paths& constant = paths;
  const auto a = paths.add_source_point(vertex(0));
  CHECK(paths.changed_since_last_build());
  paths.build_sequence_tree();
  CHECK(!paths.changed_since_last_build());
  const auto b = paths.add_source_point(face(3), {.2, .3, .5});
  CHECK(paths.changed_since_last_build());
  CHECK(a != b && std::next(a) == b && std::prev(b) == a && a->first == paths.face_location(vertex(0)).first);
  paths.build_sequence_tree_for_faces();
  CHECK(!paths.changed_since_last_build());
  paths.build_sequence_tree();
  CHECK(!paths.changed_since_last_build());
  // the windows are still there
  CHECK(constant.shortest_distance_to_source_points(face(5), {.2, .3, .5}).first > 0.);
  paths.remove_source_point(a);
  CHECK(paths.changed_since_last_build());
  CHECK(paths.source_points_begin() == b);
  CHECK(b->first == face(3));
  CHECK(a->first == paths.face_location(vertex(0)).first); // until the next build
  const bool is_rejected = throws<CGAL::Precondition_exception>([&] { paths.remove_source_point(a); });
#if defined(CGAL_NO_PRECONDITIONS) || defined(CGAL_NDEBUG)
  CHECK(!is_rejected);
#else
  CHECK(is_rejected);
#endif
  CHECK_EQUAL(paths.number_of_source_points(), 1u); // with or without the assertion
  CHECK(paths.source_points_begin() == b);
  CHECK(paths.shortest_distance_to_source_points(vertex(7)).second == b);
  CHECK(!paths.changed_since_last_build());
  CHECK(paths.shortest_distance_to_source_points(face(3), {.2, .3, .5}).first == 0.);
  const auto c = paths.add_source_point(vertex(9));
  paths.build_sequence_tree();
  CHECK(std::next(b) == c && ++Geodesic_paths::Source_point_iterator(c) == paths.source_points_end());
}

void nothing_is_reached_without_sources()
{
  test_support::Scope scope("no sources");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  Geodesic_paths paths(tm);
  const Geodesic_paths& constant = paths;
  CHECK(!paths.changed_since_last_build());
  paths.build_sequence_tree();
  CHECK(!paths.changed_since_last_build());
  CHECK_EQUAL(constant.shortest_distance_to_source_points(vertex(1)).first, -1.);
  CHECK_EQUAL(constant.shortest_distance_to_source_points(face(1), {.2, .3, .5}).first, -1.);
  paths.remove_all_source_points(); // nothing to remove
  CHECK(!paths.changed_since_last_build());
  paths.add_source_point(vertex(9));
  paths.build_sequence_tree();
  paths.remove_all_source_points();
  CHECK(paths.changed_since_last_build());
  CHECK_EQUAL(paths.shortest_distance_to_source_points(vertex(7)).first, -1.);
  CHECK(!paths.changed_since_last_build());
  CHECK_EQUAL(paths.shortest_distance_to_source_points(face(5), {.2, .3, .5}).first, -1.);
  paths.remove_source_point(paths.add_source_point(vertex(9)));
  paths.build_sequence_tree();
  CHECK_EQUAL(paths.shortest_distance_to_source_points(face(5), {.2, .3, .5}).first, -1.);
  paths.build_sequence_tree_for_faces();
  CHECK_EQUAL(constant.shortest_distance_to_source_points(face(5), {.2, .3, .5}).first, -1.);
  CHECK_EQUAL(constant.shortest_distance_to_source_points(vertex(5)).first, -1.);
  paths.add_source_point(vertex(9));
  paths.clear();
  CHECK(!paths.changed_since_last_build());
  CHECK_EQUAL(paths.shortest_distance_to_source_points(vertex(9)).first, -1.);
}

void an_empty_range_adds_nothing()
{
  test_support::Scope scope("empty range");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  Geodesic_paths paths(tm);
  std::vector<vertex_descriptor> none;
  CHECK(paths.add_source_points(none.begin(), none.end()) == paths.source_points_end());
  CHECK(!paths.changed_since_last_build());
  Geodesic_paths::Source_point_iterator it;
  it = paths.add_source_point(vertex(9));
  CHECK(it == paths.source_points_begin());
}

// Adds a range that can be read only once; its iterators survive builds.
void input_iterators_add_sources()
{
  test_support::Scope scope("input iterators");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  Geodesic_paths paths(tm);
  std::istringstream numbers("3 5 8");
  using Number = std::istream_iterator<std::size_t>;
  const auto to_vertex = [](std::size_t i) { return vertex(i); };
  const auto first = paths.add_source_points(boost::make_transform_iterator(Number(numbers), to_vertex),
                                             boost::make_transform_iterator(Number(), to_vertex));
  CHECK(first == paths.source_points_begin());
  CHECK_EQUAL(paths.number_of_source_points(), 3u);
  const auto second = std::next(first), third = std::next(second);
  paths.build_sequence_tree();
  paths.remove_source_point(second);
  paths.build_sequence_tree_for_faces();
  CHECK(std::next(first) == third && std::next(third) == paths.source_points_end());
  CHECK(paths.shortest_distance_to_source_points(vertex(8)).second == third);
  CHECK(Geodesic_paths::Source_point_iterator() == Geodesic_paths::Source_point_iterator());
  CHECK_EQUAL(std::distance(paths.source_points_begin(), paths.source_points_end()), 2);
}

// --- const queries ---

// The results and the output of queries, in types that can be compared.
struct Answers
{
  std::vector<double> numbers;
  std::vector<std::vector<Kernel::Point_3>> lines;
  std::vector<std::pair<Kernel::Point_3, face_descriptor>> polyline;
  std::vector<Kernel::Point_3> points;
  Path_recorder<Geodesic_paths> visitor;

  bool empty() const { return lines.empty() && polyline.empty() && points.empty() && visitor.items.empty(); }
};

// A call of a query member. `Paths` may be const.
template <class Paths>
struct Query_member
{
  std::function<void(Paths&, Answers&)> call;
};

const Geodesic_paths::Barycentric_coordinates inside{.2, .3, .5}, corner{0., 1., 0.};

template <class Paths>
std::vector<Query_member<Paths>> all_query_members(const Mesh& tm)
{
  const auto add = [](const Geodesic_paths::Shortest_path_result& r, Answers& a) { a.numbers.push_back(r.first); };
  auto distances = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  return {
    {[=](Paths& p, Answers& a) { add(p.shortest_distance_to_source_points(vertex(3)), a); }},
    {[=](Paths& p, Answers& a) { add(p.shortest_distance_to_source_points(face(3), corner), a); }},
    {[=](Paths& p, Answers& a) { add(p.shortest_distance_to_source_points(face(3), inside), a); }},
    {[=](Paths& p, Answers& a) { a.numbers.push_back(double(p.nearest_source_point(vertex(3)))); }},
    {[=](Paths& p, Answers& a) { a.numbers.push_back(double(p.nearest_source_point(face(3), corner))); }},
    {[=](Paths& p, Answers& a) { a.numbers.push_back(double(p.nearest_source_point(face(3), inside))); }},
    {[=](Paths& p, Answers& a)
     {
       p.shortest_distances_to_source_points(distances);
       a.numbers.push_back(get(distances, vertex(7)));
     }},
    {[=](Paths& p, Answers& a) { a.numbers.push_back(p.farthest_vertex().second); }},
    {[=](Paths& p, Answers& a) { add(p.shortest_path_sequence_to_source_points(vertex(3), a.visitor), a); }},
    {[=](Paths& p, Answers& a) { add(p.shortest_path_sequence_to_source_points(face(3), inside, a.visitor), a); }},
    {[=](Paths& p, Answers& a)
     { add(p.shortest_path_points_to_source_points(vertex(3), std::back_inserter(a.points)), a); }},
    {[=](Paths& p, Answers& a)
     { add(p.shortest_path_points_to_source_points(face(3), inside, std::back_inserter(a.points)), a); }},
    {[=](Paths& p, Answers& a)
     { add(p.shortest_path_polyline_to_source_points(vertex(3), std::back_inserter(a.polyline)), a); }},
    {[=](Paths& p, Answers& a)
     { add(p.shortest_path_polyline_to_source_points(face(3), inside, std::back_inserter(a.polyline)), a); }},
    {[=](Paths& p, Answers& a) { p.isolines(.5, std::back_inserter(a.lines)); }}};
}

// Calls one member of a const object, and of an object that has built everything. Checks that the answers are the same.
void check_query_member(const Query_member<const Geodesic_paths>& member, const Geodesic_paths& paths, const Mesh& tm)
{
  Geodesic_paths built(tm);
  for(auto it = paths.source_points_begin(); it != paths.source_points_end(); ++it)
  {
    built.add_source_point(*it);
  }
  built.build_sequence_tree_for_faces();
  Answers answers, expected;
  member.call(paths, answers);
  member.call(built, expected);
  CHECK(!paths.changed_since_last_build());
  CHECK(answers.numbers == expected.numbers && answers.points == expected.points);
  CHECK(answers.polyline == expected.polyline && answers.lines == expected.lines);
  CHECK_EQUAL(answers.visitor.items.size(), expected.visitor.items.size());
  CHECK(paths.number_of_source_points() == 0 || !answers.numbers.empty() || !answers.lines.empty());
}

enum Build
{
  NOTHING,
  VERTICES,
  EVERYTHING
};

// Calls each member as the first query of an object, after a build that may be less than the query needs.
void check_first_queries(const Mesh& tm, const std::vector<std::size_t>& sources, Build build)
{
  const auto of_const = all_query_members<const Geodesic_paths>(tm);
  const auto of_other = all_query_members<Geodesic_paths>(tm);
  for(std::size_t i = 0; i < of_const.size(); ++i)
  {
    test_support::Scope member_scope("query member " + std::to_string(i));
    Geodesic_paths paths(tm), asked_without_const(tm);
    for(Geodesic_paths* p : {&paths, &asked_without_const})
    {
      for(const std::size_t s : sources)
      {
        p->add_source_point(vertex(s));
      }
      CHECK_EQUAL(p->changed_since_last_build(), !sources.empty());
      if(build != NOTHING)
      {
        build == VERTICES ? p->build_sequence_tree() : p->build_sequence_tree_for_faces();
      }
    }
    check_query_member(of_const[i], paths, tm);
    Answers answers, of_other_answers;
    of_const[i].call(paths, answers); // again
    of_other[i].call(asked_without_const, of_other_answers);
    CHECK(answers.numbers == of_other_answers.numbers && answers.points == of_other_answers.points);
    CHECK(answers.polyline == of_other_answers.polyline && answers.lines == of_other_answers.lines);
    CHECK_EQUAL(answers.visitor.items.size(), of_other_answers.visitor.items.size());
  }
}

// Each query member of a const object computes what it needs, after any earlier build.
void const_queries_build_what_they_need()
{
  test_support::Scope scope("const queries");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  for(const std::vector<std::size_t>& sources : {std::vector<std::size_t>{}, {0}, {0, 1}, {0, 1, 2}})
  {
    for(const Build build : {NOTHING, VERTICES, EVERYTHING})
    {
      check_first_queries(tm, sources, build);
    }
  }
}

// Queries of one object through a const reference, while its sources change.
void const_queries_follow_changes_of_the_sources()
{
  test_support::Scope scope("const queries, changes");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  const auto members = all_query_members<const Geodesic_paths>(tm);
  Geodesic_paths paths(tm);
  const Geodesic_paths& constant = paths;
  const auto check = [&]
  {
    for(const auto& member : members)
    {
      check_query_member(member, constant, tm);
    }
  };
  check(); // without sources there is nothing to build
  for(std::size_t round = 0; round < 3; ++round)
  {
    paths.add_source_point(vertex(round));
    CHECK(constant.changed_since_last_build());
    check();
    paths.build_sequence_tree();
    check();
    paths.build_sequence_tree_for_faces();
    check();
  }
  paths.remove_source_point(paths.source_points_begin());
  CHECK(constant.changed_since_last_build());
  check();
  paths.remove_all_source_points();
  CHECK(constant.changed_since_last_build());
  check();
  paths.build_sequence_tree();
  check();
  paths.build_sequence_tree_for_faces();
  check();
}

// The first query finds a bad source. No query writes anything until the source is removed.
void const_queries_report_bad_sources()
{
  test_support::Scope scope("const queries, bad source");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  const auto members = all_query_members<const Geodesic_paths>(tm);
  Geodesic_paths paths(tm);
  const Geodesic_paths& constant = paths;
  paths.add_source_point(vertex(0));
  const auto bad = paths.add_source_point(face(2), {.7, .7, .7});
  for(std::size_t i = 0; i < members.size(); ++i)
  {
    test_support::Scope member_scope("query member " + std::to_string(i));
    Answers answers;
    CHECK(throws_reason(Reason::INVALID_LOCATION, [&] { members[i].call(constant, answers); }));
    CHECK(answers.empty() && answers.numbers.empty());
    CHECK(constant.changed_since_last_build());
  }
  paths.remove_source_point(bad);
  for(const auto& member : members)
  {
    check_query_member(member, constant, tm);
  }
}

// Members other than queries build nothing.
void other_const_members_do_not_build()
{
  test_support::Scope scope("const members that are no queries");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  Geodesic_paths paths(tm);
  const Geodesic_paths& constant = paths;
  paths.add_source_point(vertex(1));
  CHECK_EQUAL(constant.number_of_source_points(), 1u);
  CHECK(constant.source_points_begin() != constant.source_points_end());
  CHECK(constant.point(vertex(1)) == tm.point(vertex(1)));
  CHECK(constant.locate<AABB_traits>(tm.point(vertex(1))).first != boost::graph_traits<Mesh>::null_face());
  CHECK_EQUAL(constant.statistics().vertices_visited, 0u);
  CHECK(constant.changed_since_last_build());
  for(const vertex_descriptor v : vertices(tm))
  {
    checked_path(constant, Surface_point(v), tm, 1.);
  }
  for(const face_descriptor f : faces(tm))
  {
    checked_path(constant, Surface_point(Face_location(f, inside)), tm, 1.);
  }
  CHECK(!constant.changed_since_last_build());
}

// --- the mesh or its lengths change ---

void clear_reads_the_changed_mesh()
{
  test_support::Scope scope("clear");
  Mesh tm = load_data("grid5");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  CHECK_CLOSE(ask(paths, Surface_point(vertex(24))).distance, std::sqrt(2.), 1e-12);
  for(const vertex_descriptor v : vertices(tm))
  {
    const Coordinates p = coordinates(v, tm);
    tm.point(v) = Kernel::Point_3(3. * p[0], p[1], p[2]);
  }
  const auto first_face = *faces(tm).begin();
  const auto ends = corners_of_face(first_face, tm);
  const Kernel::Point_3 middle = CGAL::centroid(tm.point(ends[0]), tm.point(ends[1]), tm.point(ends[2]));
  tm.point(target(CGAL::Euler::add_center_vertex(halfedge(first_face, tm), tm), tm)) = middle;
  paths.clear();
  paths.add_source_point(vertex(0));
  CHECK_CLOSE(ask(paths, Surface_point(vertex(24))).distance, std::sqrt(10.), 1e-12);
  CHECK_EQUAL(ask(paths, Surface_point(vertex(25))).source, 0u);
}

// Checks that two objects give the same path, element by element.
void check_equal_paths(Geodesic_paths& first, Geodesic_paths& second, const Surface_point& query)
{
  Path_recorder<Geodesic_paths> a, b;
  ask_sequence(first, query, a);
  ask_sequence(second, query, b);
  if(!CHECK_EQUAL(a.items.size(), b.items.size()))
  {
    return;
  }
  for(std::size_t k = 0; k < a.items.size(); ++k)
  {
    CHECK_EQUAL(a.items[k].kind, b.items[k].kind);
    CHECK(a.items[k].vertex == b.items[k].vertex && a.items[k].halfedge == b.items[k].halfedge);
    CHECK_NEAR(a.items[k].t, b.items[k].t, 1e-10);
  }
}

void edge_lengths_replace_points()
{
  test_support::Scope scope("edge lengths");
  Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  const auto lengths = add_edge_lengths(tm);
  Geodesic_paths by_points(tm);
  Mesh flat = tm; // its points are meaningless
  for(const vertex_descriptor v : vertices(flat))
  {
    flat.point(v) = Kernel::Point_3(0., 0., double(std::size_t(v)));
  }
  Geodesic_paths by_lengths(flat);
  by_lengths.use_edge_lengths(lengths);
  CHECK(!by_lengths.changed_since_last_build());
  test_support::Random random(5);
  for(std::size_t i = 0; i < 6; ++i)
  {
    const Surface_point source = random_vertex_or_location(i % 2 == 0, tm, random);
    add(by_points, source);
    add(by_lengths, source);
    for(std::size_t j = 0; j < 40; ++j)
    {
      const Surface_point query = random_vertex_or_location(j % 2 == 0, tm, random);
      CHECK_CLOSE(ask(by_lengths, query).distance, ask(by_points, query).distance, 1e-12);
      check_equal_paths(by_points, by_lengths, query);
    }
  }
}

// Twice the lengths give twice the distances. Invalid lengths are rejected.
void other_edge_lengths_replace_the_first_ones()
{
  test_support::Scope scope("other edge lengths");
  Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  const auto lengths = add_edge_lengths(tm);
  auto doubled = tm.add_property_map<Mesh::Edge_index, double>("e:doubled", 0.).first;
  for(const auto e : edges(tm))
  {
    doubled[e] = 2. * lengths[e];
  }
  Geodesic_paths by_points(tm), by_lengths(tm);
  by_lengths.use_edge_lengths(lengths);
  const Face_location in_face(face(20), {.2, .3, .5});
  for(const Surface_point& source : {Surface_point(vertex(11)), Surface_point(in_face), Surface_point(vertex(50))})
  {
    add(by_points, source);
    add(by_lengths, source);
  }
  const Surface_point query(vertex(3));
  CHECK_CLOSE(ask(by_lengths, query).distance, ask(by_points, query).distance, 1e-13);
  by_lengths.use_edge_lengths(doubled);
  CHECK(by_lengths.changed_since_last_build());
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_CLOSE(ask(by_lengths, Surface_point(v)).distance, 2. * ask(by_points, Surface_point(v)).distance, 1e-13);
  }
  const auto e = *edges(tm).begin();
  for(const std::pair<double, Reason>& bad :
      {std::make_pair(-1., Reason::NEGATIVE_LENGTH), std::make_pair(infinity, Reason::NON_FINITE_LENGTH),
       std::make_pair(100., Reason::TRIANGLE_INEQUALITY)})
  {
    const double right = doubled[e];
    doubled[e] = bad.first;
    CHECK(throws_reason(bad.second, [&] { by_lengths.use_edge_lengths(doubled); }));
    doubled[e] = right;
    // The object keeps the lengths before, and the results.
    CHECK(!by_lengths.changed_since_last_build());
    CHECK_CLOSE(ask(by_lengths, query).distance, 2. * ask(by_points, query).distance, 1e-13);
    by_lengths.remove_source_point(by_lengths.add_source_point(vertex(3)));
    CHECK(by_lengths.changed_since_last_build());
    for(const Surface_point& point : {query, Surface_point(Face_location(face(5), {.5, .3, .2}))})
    {
      CHECK_CLOSE(ask(by_lengths, point).distance, 2. * ask(by_points, point).distance, 1e-13);
    }
  }
  by_lengths.use_edge_lengths(doubled);
  CHECK_CLOSE(ask(by_lengths, query).distance, 2. * ask(by_points, query).distance, 1e-13);
}

// New lengths make the results of a build without sources stale, though they leave nothing to compute.
void edge_lengths_change_without_sources()
{
  test_support::Scope scope("edge lengths without sources");
  Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  const auto lengths = add_edge_lengths(tm);
  const Surface_point source(vertex(11)), in_face(Face_location(face(20), {.2, .3, .5}));
  Geodesic_paths by_lengths(tm), expected(tm);
  for(const bool for_faces : {false, true})
  {
    add(by_lengths, Surface_point(vertex(2)));
    by_lengths.remove_all_source_points();
    for_faces ? by_lengths.build_sequence_tree_for_faces() : by_lengths.build_sequence_tree();
    for(const auto e : edges(tm))
    {
      lengths[e] *= 3.;
    }
    by_lengths.use_edge_lengths(lengths);
    CHECK(!by_lengths.changed_since_last_build());
    CHECK_EQUAL(ask(by_lengths, in_face).distance, -1.);
    add(by_lengths, source);
    expected.clear();
    expected.use_edge_lengths(lengths);
    add(expected, source);
    for(const Surface_point& point : {Surface_point(vertex(3)), in_face})
    {
      CHECK_EQUAL(ask(by_lengths, point).distance, ask(expected, point).distance);
    }
  }
}

// A range may consist of the source points of the object. A loop that removes them advances first.
void source_points_of_the_object_are_a_range()
{
  test_support::Scope scope("own source points");
  const Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  Geodesic_paths paths(tm);
  add(paths, Surface_point(vertex(11)));
  add(paths, Surface_point(Face_location(face(20), {.2, .3, .5})));
  const auto added = paths.add_source_points(paths.source_points_begin(), paths.source_points_end());
  CHECK_EQUAL(paths.number_of_source_points(), 4u);
  CHECK(added == std::next(paths.source_points_begin(), 2));
  CHECK(*added == *paths.source_points_begin());
  for(auto it = paths.source_points_begin(); it != paths.source_points_end();)
  {
    paths.remove_source_point(it++);
  }
  CHECK_EQUAL(paths.number_of_source_points(), 0u);
}

} // namespace

int main()
{
  test_support::announce_seed(20260403);
  sources_come_and_go();
  nothing_is_reached_without_sources();
  an_empty_range_adds_nothing();
  input_iterators_add_sources();
  const_queries_build_what_they_need();
  const_queries_follow_changes_of_the_sources();
  const_queries_report_bad_sources();
  other_const_members_do_not_build();
  clear_reads_the_changed_mesh();
  edge_lengths_replace_points();
  other_edge_lengths_replace_the_first_ones();
  edge_lengths_change_without_sources();
  source_points_of_the_object_are_a_range();
  return test_result();
}
