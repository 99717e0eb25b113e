// Every member of Surface_mesh_shortest_path, named for both classes by the same code at compile time, and called with
// the same result; then what only the new class has: states, exceptions, cancelling, edge lengths, const queries,
// further members.

#include "interface_of_shortest_path.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <boost/iterator/transform_iterator.hpp>

#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

using Shortest_path = CGAL::Surface_mesh_shortest_path<Paths_traits>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
using AABB_traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
using AABB_traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif
using Tree = CGAL::AABB_tree<AABB_traits>;
using Invalid_input = CGAL::Surface_mesh_geodesics::Invalid_geodesic_input;
using Reason = Invalid_input::Reason;

// the same by name, at compile time
using interface_of_shortest_path::has_interface_of_shortest_path;
static_assert(
  has_interface_of_shortest_path<Shortest_path, Paths_traits, AABB_traits, Path_recorder<Shortest_path>>(), "");
static_assert(
  has_interface_of_shortest_path<Geodesic_paths, Paths_traits, AABB_traits, Path_recorder<Geodesic_paths>>(), "");

// --- both classes ---

// the numbers that a run of the calls below gives
struct Log
{
  std::vector<double> numbers;

  void add(double x) { numbers.push_back(x); }
  void add(const Kernel::Point_3& p)
  {
    for(const double x : to_coordinates(p))
    {
      numbers.push_back(x);
    }
  }
  template <class Barycentric_coordinates>
  void add(face_descriptor f, const Barycentric_coordinates& b)
  {
    numbers.push_back(f == boost::graph_traits<Mesh>::null_face() ? -1. : double(std::size_t(f)));
    numbers.insert(numbers.end(), b.begin(), b.end());
  }
};

template <class Paths>
void log_path(Log& log, const std::vector<Path_item<Paths>>& items, const Mesh& tm)
{
  for(const auto& item : items)
  {
    log.add(item.kind);
    if(item.kind == Path_item<Paths>::VERTEX)
    {
      log.add(double(std::size_t(item.vertex)));
    }
    else if(item.kind == Path_item<Paths>::EDGE)
    {
      log.add(double(std::size_t(item.halfedge))); // its direction counts
      log.add(Paths::point(item.halfedge, item.t, tm));
    }
    else
    {
      log.add(item.face, item.coordinates);
    }
  }
}

template <class Paths>
Log call_every_member(const Mesh& tm, std::uint64_t seed)
{
  Log log;
  test_support::Random random(seed);
  const Paths_traits traits{};

  typename Paths::Vertex_index_map vertex_index_map = get(boost::vertex_index, tm);
  typename Paths::Halfedge_index_map halfedge_index_map = get(boost::halfedge_index, tm);
  typename Paths::Face_index_map face_index_map = get(boost::face_index, tm);
  typename Paths::Vertex_point_map vertex_point_map = get(CGAL::vertex_point, tm);

  // constructors
  Paths paths(tm);
  Paths with_traits(tm, traits);
  Paths with_maps(tm, vertex_index_map, halfedge_index_map, face_index_map, vertex_point_map);
  Paths with_all(tm, vertex_index_map, halfedge_index_map, face_index_map, vertex_point_map, traits);
  for(Paths* p : {&paths, &with_traits, &with_maps, &with_all})
  {
    CHECK_EQUAL(p->number_of_source_points(), 0u);
    CHECK(p->source_points_begin() == p->source_points_end());
    p->add_source_point(vertex(0));
    log.add(p->changed_since_last_build());
    log.add(p->shortest_distance_to_source_points(vertex(5)).first);
    log.add(p->changed_since_last_build());
    p->clear();
    CHECK_EQUAL(p->number_of_source_points(), 0u);
  }

  // one source after the other, and queries
  typename Paths::Source_point_iterator it;
  for(std::size_t round = 0; round < 20; ++round)
  {
    if(round % 3 == 0)
    {
      it = paths.add_source_point(random_vertex(tm, random));
    }
    else
    {
      const Face_location l = random_location(tm, random);
      it = round % 3 == 1 ? paths.add_source_point(l.first, l.second) : paths.add_source_point(l);
    }
    CHECK_EQUAL(paths.number_of_source_points(), 1u);
    CHECK(paths.source_points_begin() == it);
    CHECK(++paths.source_points_begin() == paths.source_points_end() && --paths.source_points_end() == it);
    log.add(it->first, (*it).second);
    CHECK(paths.changed_since_last_build());
    if(round % 2 == 0)
    {
      paths.build_sequence_tree();
      CHECK(!paths.changed_since_last_build());
    }
    for(std::size_t j = 0; j < 10; ++j)
    {
      const vertex_descriptor v = random_vertex(tm, random);
      const Face_location l = random_location(tm, random);
      const typename Paths::Shortest_path_result result = paths.shortest_distance_to_source_points(v);
      CHECK(result.second == paths.source_points_begin());
      log.add(result.first);
      log.add(paths.shortest_distance_to_source_points(l.first, l.second).first);
      Path_recorder<Paths> visitor;
      log.add(paths.shortest_path_sequence_to_source_points(l.first, l.second, visitor).first);
      log_path(log, visitor.items, tm);
      visitor.items.clear();
      log.add(paths.shortest_path_sequence_to_source_points(v, visitor).first);
      log_path(log, visitor.items, tm);
      std::vector<Kernel::Point_3> points;
      log.add(paths.shortest_path_points_to_source_points(v, std::back_inserter(points)).first);
      log.add(paths.shortest_path_points_to_source_points(l.first, l.second, std::back_inserter(points)).first);
      for(const Kernel::Point_3& p : points)
      {
        log.add(p);
      }
    }
    if(round % 2 == 0)
    {
      paths.remove_source_point(it);
    }
    else
    {
      paths.remove_all_source_points();
    }
    CHECK_EQUAL(paths.number_of_source_points(), 0u);
  }

  // ranges
  std::vector<vertex_descriptor> some_vertices;
  std::vector<typename Paths::Face_location> some_locations;
  for(std::size_t i = 0; i < 4; ++i)
  {
    some_vertices.push_back(random_vertex(tm, random));
    const Face_location l = random_location(tm, random);
    some_locations.push_back(l);
  }
  const typename Paths::Source_point_iterator first =
    paths.add_source_points(some_locations.begin(), some_locations.end());
  CHECK(first == paths.source_points_begin());
  const typename Paths::Source_point_iterator second =
    paths.add_source_points(some_vertices.begin(), some_vertices.end());
  CHECK_EQUAL(number_of(second, paths), 4u);
  CHECK_EQUAL(paths.number_of_source_points(), 8u);
  for(auto i = paths.source_points_begin(); i != paths.source_points_end(); i++)
  {
    log.add(i->first, i->second);
  }
  // removal of all but one, and adding again
  for(auto i = paths.source_points_begin(); i != paths.source_points_end();)
  {
    const auto here = i++;
    if(here != second)
    {
      paths.remove_source_point(here);
    }
  }
  CHECK_EQUAL(paths.number_of_source_points(), 1u);
  for(const vertex_descriptor v : vertices(tm))
  {
    log.add(paths.shortest_distance_to_source_points(v).first);
  }

  // points
  const Paths& constant = paths;
  for(std::size_t j = 0; j < 30; ++j)
  {
    const vertex_descriptor v = random_vertex(tm, random);
    const Face_location l = random_location(tm, random);
    const auto h = next(halfedge(l.first, tm), tm);
    const double t = random.uniform();
    static_assert(std::is_same<decltype(constant.point(v)), decltype(get(vertex_point_map, v))>::value, "");
    CHECK(constant.point(v) == Paths::point(v, tm));
    log.add(constant.point(v));
    log.add(constant.point(l.first, l.second));
    log.add(Paths::point(l.first, l.second, tm));
    log.add(Paths::point(l.first, l.second, tm, traits));
    log.add(Paths::point(l.first, l.second, tm, vertex_point_map));
    log.add(Paths::point(l.first, l.second, tm, vertex_point_map, traits));
    log.add(constant.point(h, t));
    log.add(Paths::point(h, t, tm));
    log.add(Paths::point(h, t, tm, traits));
    log.add(Paths::point(h, t, tm, vertex_point_map));
    log.add(Paths::point(h, t, tm, vertex_point_map, traits));

    // locations
    for(const typename Paths::Face_location& f :
        {constant.face_location(v), Paths::face_location(v, tm), Paths::face_location(v, tm, traits),
         constant.face_location(h, t), Paths::face_location(h, t, tm), Paths::face_location(h, t, tm, traits)})
    {
      log.add(f.first, f.second);
    }
    CHECK_NEAR(length(to_coordinates(constant.point(h, t)) -
                      coordinates(Face_location(constant.face_location(h, t)), tm)), 0., 1e-13);
  }

  // locate
  Tree tree, tree_of_map, static_tree, static_tree_of_map;
  constant.build_aabb_tree(tree);
  constant.build_aabb_tree(tree_of_map, vertex_point_map);
  Paths::template build_aabb_tree<AABB_traits>(tm, static_tree, vertex_point_map);
  Paths::build_aabb_tree(tm, static_tree_of_map, vertex_point_map);
  for(std::size_t j = 0; j < 15; ++j)
  {
    const Kernel::Point_3 p(random.uniform(-2., 2.), random.uniform(-2., 2.), random.uniform(-2., 2.));
    const Kernel::Point_3 target(random.uniform(-.3, .3), random.uniform(-.3, .3), random.uniform(-.3, .3));
    const Kernel::Ray_3 ray(p, target);
    for(const Tree* t : {&tree, &tree_of_map, &static_tree, &static_tree_of_map})
    {
      const auto a = constant.locate(p, *t);
      const auto b = constant.locate(ray, *t);
      const auto c = Paths::locate(p, *t, tm, vertex_point_map);
      const auto d = Paths::locate(ray, *t, tm, vertex_point_map, traits);
      CHECK(a == c && b == d);
      log.add(a.first, a.second);
      log.add(b.first, b.second);
    }
    for(const auto& l : {constant.template locate<AABB_traits>(p), constant.template locate<AABB_traits>(ray),
                         Paths::template locate<AABB_traits>(p, tm, vertex_point_map),
                         Paths::template locate<AABB_traits>(ray, tm, vertex_point_map, traits)})
    {
      log.add(l.first, l.second);
    }
  }
  const Kernel::Ray_3 away(Kernel::Point_3(9., 9., 9.), Kernel::Point_3(10., 10., 10.));
  CHECK(constant.locate(away, tree).first == boost::graph_traits<Mesh>::null_face());
  CHECK(constant.template locate<AABB_traits>(away).first == boost::graph_traits<Mesh>::null_face());

  paths.clear();
  CHECK_EQUAL(paths.number_of_source_points(), 0u);
  const auto unreached = paths.shortest_distance_to_source_points(vertex(0));
  CHECK_EQUAL(unreached.first, -1.);
  CHECK(unreached.second == paths.source_points_end());
  return log;
}

void both_classes_agree(std::uint64_t seed)
{
  for(const Indexed_mesh& indexed : {noisy_sphere(2, .1, seed), jittered(midpoint_subdivision(cube_grid(2)), .1, seed),
                                     rough_terrain(8, 1.5, seed)})
  {
    test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    const Log a = call_every_member<Geodesic_paths>(tm, seed + 1);
    const Log b = call_every_member<Shortest_path>(tm, seed + 1);
    if(!CHECK_EQUAL(a.numbers.size(), b.numbers.size()))
    {
      continue;
    }
    for(std::size_t i = 0; i < a.numbers.size(); ++i)
    {
      test_support::Scope number_scope("number " + std::to_string(i));
      CHECK_NEAR(a.numbers[i], b.numbers[i], 1e-11);
    }
  }
}

// --- states and iterators ---

void states_and_iterators()
{
  test_support::Scope scope("states");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  Geodesic_paths paths(tm);
  const Geodesic_paths& constant = paths;
  CHECK(!paths.changed_since_last_build());
  paths.build_sequence_tree(); // without sources
  CHECK(!paths.changed_since_last_build());
  CHECK_EQUAL(constant.shortest_distance_to_source_points(vertex(1)).first, -1.);
  CHECK_EQUAL(constant.shortest_distance_to_source_points(face(1), {.2, .3, .5}).first, -1.);
  paths.remove_all_source_points(); // nothing to remove
  CHECK(!paths.changed_since_last_build());

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
  CHECK(a->first == paths.face_location(vertex(0)).first); // until the structure is built again
  bool is_refused = false;
  try
  {
    paths.remove_source_point(a);
  }
  catch(const CGAL::Precondition_exception&)
  {
    is_refused = true;
  }
#if defined(CGAL_NO_PRECONDITIONS) || defined(CGAL_NDEBUG)
  CHECK(!is_refused);
#else
  CHECK(is_refused);
#endif
  CHECK_EQUAL(paths.number_of_source_points(), 1u); // whether it is refused or not
  CHECK(paths.source_points_begin() == b);
  CHECK(paths.shortest_distance_to_source_points(vertex(7)).second == b);
  CHECK(!paths.changed_since_last_build());
  CHECK(paths.shortest_distance_to_source_points(face(3), {.2, .3, .5}).first == 0.);
  const auto c = paths.add_source_point(vertex(9));
  paths.build_sequence_tree();
  CHECK(std::next(b) == c && ++Geodesic_paths::Source_point_iterator(c) == paths.source_points_end());
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

  std::vector<vertex_descriptor> none;
  CHECK(paths.add_source_points(none.begin(), none.end()) == paths.source_points_end());
  Geodesic_paths::Source_point_iterator it;
  it = paths.add_source_point(vertex(9));
  CHECK(it == paths.source_points_begin());
  static_assert(!std::is_copy_constructible<Geodesic_paths>::value, "");
  static_assert(std::is_convertible<const Mesh&, Geodesic_paths>::value, ""); // as with the original

  // the original documents this one, and does not have it
  Tree tree;
  Geodesic_paths::build_aabb_tree(tm, tree);
  CHECK_EQUAL(tree.size(), num_faces(tm));
}

template <class Exception, class Function>
bool throws(Function function)
{
  try
  {
    function();
  }
  catch(const Exception&)
  {
    return true;
  }
  return false;
}

template <class Function>
bool throws_reason(Reason reason, Function function)
{
  try
  {
    function();
  }
  catch(const Invalid_input& e)
  {
    return e.reason() == reason;
  }
  return false;
}

// What the queries of an object write, in words that compare.
struct Answers
{
  std::vector<double> numbers;
  std::vector<std::vector<Kernel::Point_3>> lines;
  std::vector<std::pair<Kernel::Point_3, face_descriptor>> polyline;
  std::vector<Kernel::Point_3> points;
  Path_recorder<Geodesic_paths> visitor;

  bool empty() const { return lines.empty() && polyline.empty() && points.empty() && visitor.items.empty(); }
};

// A query member: what it needs, and a call. `Paths` may be const.
template <class Paths>
struct Query_member
{
  bool needs_faces;
  std::function<void(Paths&, Answers&)> call;
};

const Geodesic_paths::Barycentric_coordinates inside{.2, .3, .5}, corner{0., 1., 0.};

template <class Paths>
std::vector<Query_member<Paths>> all_query_members(const Mesh& tm)
{
  const auto add = [](const Geodesic_paths::Shortest_path_result& r, Answers& a) { a.numbers.push_back(r.first); };
  auto distances = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  return {
    {false, [=](Paths& p, Answers& a) { add(p.shortest_distance_to_source_points(vertex(3)), a); }},
    {false, [=](Paths& p, Answers& a) { add(p.shortest_distance_to_source_points(face(3), corner), a); }},
    {true, [=](Paths& p, Answers& a) { add(p.shortest_distance_to_source_points(face(3), inside), a); }},
    {false, [=](Paths& p, Answers& a) { a.numbers.push_back(double(p.nearest_source_point(vertex(3)))); }},
    {false, [=](Paths& p, Answers& a) { a.numbers.push_back(double(p.nearest_source_point(face(3), corner))); }},
    {true, [=](Paths& p, Answers& a) { a.numbers.push_back(double(p.nearest_source_point(face(3), inside))); }},
    {false,
     [=](Paths& p, Answers& a)
     {
       p.shortest_distances_to_source_points(distances);
       a.numbers.push_back(get(distances, vertex(7)));
     }},
    {false, [=](Paths& p, Answers& a) { a.numbers.push_back(p.farthest_vertex().second); }},
    {false, [=](Paths& p, Answers& a) { add(p.shortest_path_sequence_to_source_points(vertex(3), a.visitor), a); }},
    {true,
     [=](Paths& p, Answers& a) { add(p.shortest_path_sequence_to_source_points(face(3), inside, a.visitor), a); }},
    {false,
     [=](Paths& p, Answers& a)
     { add(p.shortest_path_points_to_source_points(vertex(3), std::back_inserter(a.points)), a); }},
    {true,
     [=](Paths& p, Answers& a)
     { add(p.shortest_path_points_to_source_points(face(3), inside, std::back_inserter(a.points)), a); }},
    {false,
     [=](Paths& p, Answers& a)
     { add(p.shortest_path_polyline_to_source_points(vertex(3), std::back_inserter(a.polyline)), a); }},
    {true,
     [=](Paths& p, Answers& a)
     { add(p.shortest_path_polyline_to_source_points(face(3), inside, std::back_inserter(a.polyline)), a); }},
    {true, [=](Paths& p, Answers& a) { p.isolines(.5, std::back_inserter(a.lines)); }}};
}

// Asks one member of a const object, and of an object that builds everything beforehand: the answers are the same.
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

// Asks each member as the first query of an object, after a build that may be less than it needs.
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
    of_const[i].call(paths, answers); // once more
    of_other[i].call(asked_without_const, of_other_answers);
    CHECK(answers.numbers == of_other_answers.numbers && answers.points == of_other_answers.points);
    CHECK(answers.polyline == of_other_answers.polyline && answers.lines == of_other_answers.lines);
    CHECK_EQUAL(answers.visitor.items.size(), of_other_answers.visitor.items.size());
  }
}

// Each query member of a const object computes what it needs, whatever has been built before.
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

// One object, asked through a const reference, while its sources change.
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
  check(); // without sources nothing has to be built
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

// A bad source is found by the first query, and no query writes anything until it has been removed.
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

// A member that is no query builds nothing.
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
    checked_path(constant, Place(v), tm, 1.);
  }
  for(const face_descriptor f : faces(tm))
  {
    checked_path(constant, Place(Face_location(f, inside)), tm, 1.);
  }
  CHECK(!constant.changed_since_last_build());
}

// Vertices and edges without faces have no location; border halfedges have one.
void locations_without_faces()
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
  const auto h = halfedge(CGAL::add_edge(tm), tm); // an edge alone
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

// A range that can be read once, and iterators through builds.
void source_points_of_input_iterators()
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

void bad_input_is_refused()
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
    CHECK_EQUAL(ask(paths, Place(Face_location(face(4), {.2, .3, .5}))).source, 0u);
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

  // meshes
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
  {
    Mesh bad = tm;
    bad.point(vertex(7)) = Kernel::Point_3(0., nan, 0.);
    Geodesic_paths p(bad);
    p.add_source_point(vertex(0));
    CHECK(throws_reason(Reason::NON_FINITE_POINT, [&] { p.build_sequence_tree_for_faces(); }));
    // the mesh is mended
    bad.point(vertex(7)) = tm.point(vertex(7));
    p.clear();
    p.add_source_point(vertex(0));
    CHECK_EQUAL(p.shortest_distance_to_source_points(vertex(5)).first, expected);
  }
}

// without sources nothing is built, and descriptors are checked all the same.
void bad_queries_without_sources_are_refused()
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

// --- vertices without faces ---

void vertices_without_faces_have_a_null_location()
{
  test_support::Scope scope("vertices without faces");
  Mesh tm = to_face_graph(fan("fan", 5, .1, -.2));
  const vertex_descriptor isolated = tm.add_vertex(Kernel::Point_3(3., 0., 0.));
  CHECK(Geodesic_paths::face_location(vertex(0), tm).first != boost::graph_traits<Mesh>::null_face());
  // the edges of the faces are left, with a border on both sides
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

// --- the mesh changes ---

void clear_takes_the_mesh_as_it_is()
{
  test_support::Scope scope("clear");
  Mesh tm = load_data("grid5");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  CHECK_CLOSE(ask(paths, Place(vertex(24))).distance, std::sqrt(2.), 1e-12);
  for(const vertex_descriptor v : vertices(tm))
  {
    const Coordinates p = coordinates(v, tm);
    tm.point(v) = Kernel::Point_3(3. * p[0], p[1], p[2]);
  }
  const auto first_face = *faces(tm).begin();
  CGAL::Euler::add_center_vertex(halfedge(first_face, tm), tm);
  paths.clear();
  paths.add_source_point(vertex(0));
  CHECK_CLOSE(ask(paths, Place(vertex(24))).distance, std::sqrt(10.), 1e-12);
  CHECK_EQUAL(ask(paths, Place(vertex(25))).source, 0u);
}

// --- edge lengths ---

void edge_lengths_replace_points()
{
  test_support::Scope scope("edge lengths");
  Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  const auto lengths = add_edge_lengths(tm);
  Geodesic_paths by_points(tm);
  Mesh flat = tm; // its points mean nothing
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
    const Place source = i % 2 == 0 ? Place(random_vertex(tm, random)) : Place(random_location(tm, random));
    add(by_points, source);
    add(by_lengths, source);
    for(std::size_t j = 0; j < 40; ++j)
    {
      const Place query = j % 2 == 0 ? Place(random_vertex(tm, random)) : Place(random_location(tm, random));
      CHECK_CLOSE(ask(by_lengths, query).distance, ask(by_points, query).distance, 1e-12);
      Path_recorder<Geodesic_paths> a, b;
      ask_sequence(by_points, query, a);
      ask_sequence(by_lengths, query, b);
      if(CHECK_EQUAL(a.items.size(), b.items.size()))
      {
        for(std::size_t k = 0; k < a.items.size(); ++k)
        {
          CHECK_EQUAL(a.items[k].kind, b.items[k].kind);
          CHECK(a.items[k].vertex == b.items[k].vertex && a.items[k].halfedge == b.items[k].halfedge);
          CHECK_NEAR(a.items[k].t, b.items[k].t, 1e-10);
        }
      }
    }
  }
  // all over again with other lengths
  auto doubled = tm.add_property_map<Mesh::Edge_index, double>("e:doubled", 0.).first;
  for(const auto e : edges(tm))
  {
    doubled[e] = 2. * lengths[e];
  }
  by_lengths.use_edge_lengths(doubled);
  CHECK(by_lengths.changed_since_last_build());
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_CLOSE(ask(by_lengths, Place(v)).distance, 2. * ask(by_points, Place(v)).distance, 1e-13);
  }
  // bad lengths
  const auto e = *edges(tm).begin();
  for(const std::pair<double, Reason>& bad :
      {std::make_pair(-1., Reason::NEGATIVE_LENGTH), std::make_pair(infinity, Reason::NON_FINITE_LENGTH),
       std::make_pair(100., Reason::TRIANGLE_INEQUALITY)})
  {
    const double right = doubled[e];
    doubled[e] = bad.first;
    CHECK(throws_reason(bad.second, [&] { by_lengths.use_edge_lengths(doubled); }));
    doubled[e] = right;
  }
  by_lengths.use_edge_lengths(doubled);
  CHECK_CLOSE(ask(by_lengths, Place(vertex(3))).distance, 2. * ask(by_points, Place(vertex(3))).distance, 1e-13);
}

// --- progress and cancelling ---

struct Cancelling_visitor : CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
  std::size_t steps_left = 0;
  std::size_t begins = 0, ends = 0, vertices_announced = 0;
  double distance_reached = 0.;

  void on_propagation_begin(std::size_t number_of_vertices)
  {
    ++begins;
    vertices_announced = number_of_vertices;
  }
  void on_progress(std::size_t, double distance)
  {
    CHECK(distance >= distance_reached);
    distance_reached = distance;
  }
  bool go_further() { return steps_left == 0 ? false : (--steps_left, true); }
  void on_propagation_end() { ++ends; }
};

void building_can_be_cancelled()
{
  test_support::Scope scope("cancelling");
  const Mesh tm = to_face_graph(noisy_sphere(3, .05, 5));
  Geodesic_paths expected(tm);
  expected.add_source_point(vertex(0));
  expected.add_source_point(face(77), {.2, .3, .5});
  Geodesic_paths paths(tm);
  const auto first = paths.add_source_point(vertex(0));
  paths.add_source_point(face(77), {.2, .3, .5});
  bool was_cancelled = false, was_complete = false;
  for(std::size_t steps = 0; steps < 100000; steps = 3 * steps + 1)
  {
    for(const bool for_faces : {false, true})
    {
      paths.remove_source_point(paths.add_source_point(vertex(5))); // it has to be built again
      Cancelling_visitor visitor;
      visitor.steps_left = steps;
      const bool is_complete =
        for_faces ? paths.build_sequence_tree_for_faces(visitor) : paths.build_sequence_tree(visitor);
      was_cancelled = was_cancelled || !is_complete;
      was_complete = was_complete || is_complete;
      CHECK_EQUAL(visitor.begins, 1u);
      CHECK_EQUAL(visitor.ends, 1u);
      CHECK_EQUAL(visitor.vertices_announced, num_vertices(tm));
      CHECK_EQUAL(paths.changed_since_last_build(), !is_complete);
      CHECK_EQUAL(paths.number_of_source_points(), 2u);
      CHECK(first == paths.source_points_begin());
      if(!is_complete)
      {
        const Geodesic_paths& constant = paths; // its first query builds
        CHECK_EQUAL(constant.shortest_distance_to_source_points(vertex(3)).first,
                    expected.shortest_distance_to_source_points(vertex(3)).first);
        CHECK(!paths.changed_since_last_build());
      }
      for(const Place& q : {Place(vertex(3)), Place(Face_location(face(12), {.2, .3, .5}))})
      {
        CHECK_EQUAL(ask(paths, q).distance, ask(expected, q).distance);
        CHECK_EQUAL(ask(paths, q).source, ask(expected, q).source);
      }
    }
  }
  CHECK(was_cancelled && was_complete);
  Cancelling_visitor visitor; // nothing to do
  CHECK(paths.build_sequence_tree_for_faces(visitor));
  CHECK_EQUAL(visitor.begins, 0u);
  CHECK(paths.statistics().vertices_visited > 0);
  paths.clear();
  CHECK_EQUAL(paths.statistics().vertices_visited, 0u);
}

// a visitor that throws leaves the object valid as well
struct Throwing_visitor : CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
  void on_progress(std::size_t, double) { throw std::runtime_error("enough"); }
};

void visitors_may_throw()
{
  test_support::Scope scope("throwing visitor");
  const Mesh tm = to_face_graph(noisy_sphere(3, .05, 5));
  Geodesic_paths expected(tm), paths(tm);
  expected.add_source_point(face(77), {.2, .3, .5});
  paths.add_source_point(face(77), {.2, .3, .5});
  Throwing_visitor visitor;
  CHECK(throws<std::runtime_error>([&] { paths.build_sequence_tree_for_faces(visitor); }));
  CHECK(paths.changed_since_last_build());
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(ask(paths, Place(v)).distance, ask(expected, Place(v)).distance);
  }
}

// --- further members ---

void further_members()
{
  test_support::Scope scope("further members");
  test_support::Random random(11);
  for(const Indexed_mesh& indexed : {noisy_sphere(2, .1, 7), two_components_and_an_isolated_vertex()})
  {
    const Mesh tm = to_face_graph(indexed);
    const double size = size_of(tm);
    Geodesic_paths paths(tm);
    auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
    auto float_map = get(CGAL::dynamic_vertex_property_t<float>(), tm);
    paths.shortest_distances_to_source_points(map);
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK_EQUAL(get(map, v), -1.);
    }
    CHECK(paths.farthest_vertex().first == boost::graph_traits<Mesh>::null_vertex());
    CHECK_EQUAL(paths.farthest_vertex().second, -1.);
    CHECK_EQUAL(paths.nearest_source_point(vertex(0)), Geodesic_paths::no_source);
    CHECK_EQUAL(paths.nearest_source_point(face(0), {.2, .3, .5}), Geodesic_paths::no_source);
    for(std::size_t i = 0; i < 4; ++i)
    {
      if(i % 2 == 0)
      {
        paths.add_source_point(vertex(10 * i));
      }
      else
      {
        paths.add_source_point(face(10 * i), {.2, .3, .5});
      }
      paths.shortest_distances_to_source_points(map);
      paths.shortest_distances_to_source_points(float_map);
      double largest = -1.;
      for(const vertex_descriptor v : vertices(tm))
      {
        const Answer answer = ask(paths, Place(v));
        CHECK_EQUAL(get(map, v), answer.distance);
        CHECK_EQUAL(get(float_map, v), float(answer.distance));
        CHECK_EQUAL(paths.nearest_source_point(v), answer.source);
        largest = (std::max)(largest, answer.distance);
        checked_path(paths, Place(v), tm, size);
      }
      const auto farthest = paths.farthest_vertex();
      CHECK_EQUAL(farthest.second, largest);
      CHECK_EQUAL(ask(paths, Place(farthest.first)).distance, largest);
      for(std::size_t j = 0; j < 50; ++j)
      {
        const Place query = random_location(tm, random);
        CHECK_EQUAL(paths.nearest_source_point(query.location.first, query.location.second),
                    ask(paths, query).source);
        checked_path(paths, query, tm, size);
      }
    }
  }
}

// The coordinates in a face with nearly no height are lost in rounding.
void points_of_flat_faces_are_located()
{
  test_support::Scope scope("locate in a sliver");
  const Mesh tm = load_data("sliver_1e-12");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  Tree tree;
  paths.build_aabb_tree(tree);
  test_support::Random random(13);
  for(std::size_t i = 0; i < 200; ++i)
  {
    const Face_location l = random_location(tm, random);
    const Geodesic_paths::Face_location q = paths.locate(paths.point(l.first, l.second), tree);
    CHECK_NEAR(paths.shortest_distance_to_source_points(q.first, q.second).first,
               paths.shortest_distance_to_source_points(l.first, l.second).first, 1e-11);
  }
}

// Removed elements are still in the range of the indices, and their links lead anywhere.
void removed_elements_are_refused()
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

// Points of space are located right, or not at all.
void points_are_located_or_refused(std::uint64_t seed)
{
  test_support::Scope scope("locate");
  const Indexed_mesh indexed = rough_terrain(6, .5, seed);
  const Mesh tm = to_face_graph(indexed);
  for(const int exponent : {-800, -300, -240, -100, 0, 100, 240, 300, 480})
  {
    test_support::Scope exponent_scope("2^" + std::to_string(exponent));
    const double unit = std::ldexp(1., exponent);
    const Mesh other = to_face_graph(transformed(indexed, "scaled", [unit](const Coordinates& c) { return unit * c; }));
    const Geodesic_paths paths(other);
    for(const face_descriptor f : faces(tm))
    {
      const Kernel::Point_3 p = CGAL::centroid(tm.point(tm.source(tm.halfedge(f))), tm.point(tm.target(tm.halfedge(f))),
                                         tm.point(tm.target(tm.next(tm.halfedge(f)))));
      const Kernel::Point_3 q(unit * p.x(), unit * p.y(), unit * p.z());
      bool is_refused = false;
      try
      {
        const Face_location location = paths.locate<AABB_traits>(q);
        const Kernel::Point_3 found = paths.point(location.first, location.second);
        CHECK(std::abs(found.x() - q.x()) <= 1e-12 * unit && std::abs(found.y() - q.y()) <= 1e-12 * unit
              && std::abs(found.z() - q.z()) <= 1e-12 * unit);
      }
      catch(const SMG::Invalid_geodesic_input& e)
      {
        is_refused = e.reason() == SMG::Invalid_geodesic_input::Reason::NON_FINITE_POINT;
      }
      CHECK_EQUAL(is_refused, std::abs(exponent) > 260);
    }
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260403);
  both_classes_agree(seed);
  states_and_iterators();
  const_queries_build_what_they_need();
  const_queries_follow_changes_of_the_sources();
  const_queries_report_bad_sources();
  other_const_members_do_not_build();
  locations_without_faces();
  source_points_of_input_iterators();
  bad_input_is_refused();
  bad_queries_without_sources_are_refused();
  vertices_without_faces_have_a_null_location();
  clear_takes_the_mesh_as_it_is();
  edge_lengths_replace_points();
  building_can_be_cancelled();
  visitors_may_throw();
  further_members();
  points_of_flat_faces_are_located();
  removed_elements_are_refused();
  points_are_located_or_refused(seed);
  return test_result();
}
