// Every member of Surface_mesh_shortest_path: the same code names it for both classes at compile time, and calls it for
// both with the same result. Then the members that only the new class has, and locate() where the original fails.

#include "expected_exceptions.h"
#include "interface_of_shortest_path.h"
#include "path_interface_helpers.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

using namespace test_meshes;

namespace {

using Shortest_path = CGAL::Surface_mesh_shortest_path<Paths_traits>;

// The interface by name, at compile time.
using interface_of_shortest_path::has_interface_of_shortest_path;
static_assert(
  has_interface_of_shortest_path<Shortest_path, Paths_traits, AABB_traits, Path_recorder<Shortest_path>>(), "");
static_assert(
  has_interface_of_shortest_path<Geodesic_paths, Paths_traits, AABB_traits, Path_recorder<Geodesic_paths>>(), "");

static_assert(!std::is_copy_constructible<Geodesic_paths>::value, "");
static_assert(std::is_convertible<const Mesh&, Geodesic_paths>::value, ""); // as with the original

// --- both classes ---

// The numbers that the calls return.
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
      log.add(double(std::size_t(item.halfedge))); // the direction of the halfedge is part of the result
      log.add(Paths::point(item.halfedge, item.t, tm));
    }
    else
    {
      log.add(item.face, item.coordinates);
    }
  }
}

// Calls every public member of a class, and logs what it returns.
template <class Paths>
class Member_calls
{
public:
  Member_calls(const Mesh& tm, std::uint64_t seed)
    : m_tm(tm), m_random(seed), m_vertex_point_map(get(CGAL::vertex_point, tm)), m_paths(tm)
  {}

  Log run()
  {
    constructors();
    for(std::size_t round = 0; round < 20; ++round)
    {
      one_source(round);
    }
    ranges_of_sources();
    for(std::size_t i = 0; i < 30; ++i)
    {
      points_and_locations();
    }
    locations_of_points_of_space();
    nothing_is_reached_after_clear();
    return m_log;
  }

private:
  using Iterator = typename Paths::Source_point_iterator;

  void constructors()
  {
    typename Paths::Vertex_index_map vertex_index_map = get(boost::vertex_index, m_tm);
    typename Paths::Halfedge_index_map halfedge_index_map = get(boost::halfedge_index, m_tm);
    typename Paths::Face_index_map face_index_map = get(boost::face_index, m_tm);
    Paths paths(m_tm);
    Paths with_traits(m_tm, m_traits);
    Paths with_maps(m_tm, vertex_index_map, halfedge_index_map, face_index_map, m_vertex_point_map);
    Paths with_all(m_tm, vertex_index_map, halfedge_index_map, face_index_map, m_vertex_point_map, m_traits);
    for(Paths* p : {&paths, &with_traits, &with_maps, &with_all})
    {
      CHECK_EQUAL(p->number_of_source_points(), 0u);
      CHECK(p->source_points_begin() == p->source_points_end());
      p->add_source_point(vertex(0));
      m_log.add(p->changed_since_last_build());
      m_log.add(p->shortest_distance_to_source_points(vertex(5)).first);
      m_log.add(p->changed_since_last_build());
      p->clear();
      CHECK_EQUAL(p->number_of_source_points(), 0u);
    }
  }

  void one_source(std::size_t round)
  {
    const Iterator it = add_source(round);
    CHECK_EQUAL(m_paths.number_of_source_points(), 1u);
    CHECK(m_paths.source_points_begin() == it);
    CHECK(++m_paths.source_points_begin() == m_paths.source_points_end() && --m_paths.source_points_end() == it);
    m_log.add(it->first, (*it).second);
    CHECK(m_paths.changed_since_last_build());
    if(round % 2 == 0)
    {
      m_paths.build_sequence_tree();
      CHECK(!m_paths.changed_since_last_build());
    }
    for(std::size_t i = 0; i < 10; ++i)
    {
      queries();
    }
    if(round % 2 == 0)
    {
      m_paths.remove_source_point(it);
    }
    else
    {
      m_paths.remove_all_source_points();
    }
    CHECK_EQUAL(m_paths.number_of_source_points(), 0u);
  }

  Iterator add_source(std::size_t round)
  {
    if(round % 3 == 0)
    {
      return m_paths.add_source_point(random_vertex(m_tm, m_random));
    }
    const Face_location l = random_location(m_tm, m_random);
    return round % 3 == 1 ? m_paths.add_source_point(l.first, l.second) : m_paths.add_source_point(l);
  }

  void queries()
  {
    const vertex_descriptor v = random_vertex(m_tm, m_random);
    const Face_location l = random_location(m_tm, m_random);
    const typename Paths::Shortest_path_result result = m_paths.shortest_distance_to_source_points(v);
    CHECK(result.second == m_paths.source_points_begin());
    m_log.add(result.first);
    m_log.add(m_paths.shortest_distance_to_source_points(l.first, l.second).first);
    Path_recorder<Paths> visitor;
    m_log.add(m_paths.shortest_path_sequence_to_source_points(l.first, l.second, visitor).first);
    log_path(m_log, visitor.items, m_tm);
    visitor.items.clear();
    m_log.add(m_paths.shortest_path_sequence_to_source_points(v, visitor).first);
    log_path(m_log, visitor.items, m_tm);
    std::vector<Kernel::Point_3> points;
    m_log.add(m_paths.shortest_path_points_to_source_points(v, std::back_inserter(points)).first);
    m_log.add(m_paths.shortest_path_points_to_source_points(l.first, l.second, std::back_inserter(points)).first);
    for(const Kernel::Point_3& p : points)
    {
      m_log.add(p);
    }
  }

  // Adds two ranges, removes all sources but one, and asks for all distances.
  void ranges_of_sources()
  {
    std::vector<vertex_descriptor> some_vertices;
    std::vector<typename Paths::Face_location> some_locations;
    for(std::size_t i = 0; i < 4; ++i)
    {
      some_vertices.push_back(random_vertex(m_tm, m_random));
      some_locations.push_back(random_location(m_tm, m_random));
    }
    const Iterator first = m_paths.add_source_points(some_locations.begin(), some_locations.end());
    CHECK(first == m_paths.source_points_begin());
    const Iterator second = m_paths.add_source_points(some_vertices.begin(), some_vertices.end());
    CHECK_EQUAL(number_of(second, m_paths), 4u);
    CHECK_EQUAL(m_paths.number_of_source_points(), 8u);
    for(auto i = m_paths.source_points_begin(); i != m_paths.source_points_end(); i++)
    {
      m_log.add(i->first, i->second);
    }
    for(auto i = m_paths.source_points_begin(); i != m_paths.source_points_end();)
    {
      const auto here = i++;
      if(here != second)
      {
        m_paths.remove_source_point(here);
      }
    }
    CHECK_EQUAL(m_paths.number_of_source_points(), 1u);
    for(const vertex_descriptor v : vertices(m_tm))
    {
      m_log.add(m_paths.shortest_distance_to_source_points(v).first);
    }
  }

  void points_and_locations()
  {
    const Paths& constant = m_paths;
    const vertex_descriptor v = random_vertex(m_tm, m_random);
    const Face_location l = random_location(m_tm, m_random);
    const auto h = next(halfedge(l.first, m_tm), m_tm);
    const double t = m_random.uniform();
    static_assert(std::is_same<decltype(constant.point(v)), decltype(get(m_vertex_point_map, v))>::value, "");
    CHECK(constant.point(v) == Paths::point(v, m_tm));
    m_log.add(constant.point(v));
    m_log.add(constant.point(l.first, l.second));
    m_log.add(Paths::point(l.first, l.second, m_tm));
    m_log.add(Paths::point(l.first, l.second, m_tm, m_traits));
    m_log.add(Paths::point(l.first, l.second, m_tm, m_vertex_point_map));
    m_log.add(Paths::point(l.first, l.second, m_tm, m_vertex_point_map, m_traits));
    m_log.add(constant.point(h, t));
    m_log.add(Paths::point(h, t, m_tm));
    m_log.add(Paths::point(h, t, m_tm, m_traits));
    m_log.add(Paths::point(h, t, m_tm, m_vertex_point_map));
    m_log.add(Paths::point(h, t, m_tm, m_vertex_point_map, m_traits));
    for(const typename Paths::Face_location& f :
        {constant.face_location(v), Paths::face_location(v, m_tm), Paths::face_location(v, m_tm, m_traits),
         constant.face_location(h, t), Paths::face_location(h, t, m_tm), Paths::face_location(h, t, m_tm, m_traits)})
    {
      m_log.add(f.first, f.second);
    }
    CHECK_NEAR(length(to_coordinates(constant.point(h, t)) -
                      coordinates(Face_location(constant.face_location(h, t)), m_tm)), 0., 1e-13);
  }

  void locations_of_points_of_space()
  {
    const Paths& constant = m_paths;
    Tree tree, tree_of_map, static_tree, static_tree_of_map;
    constant.build_aabb_tree(tree);
    constant.build_aabb_tree(tree_of_map, m_vertex_point_map);
    Paths::template build_aabb_tree<AABB_traits>(m_tm, static_tree, m_vertex_point_map);
    Paths::build_aabb_tree(m_tm, static_tree_of_map, m_vertex_point_map);
    for(std::size_t i = 0; i < 15; ++i)
    {
      locate_with({&tree, &tree_of_map, &static_tree, &static_tree_of_map});
    }
    const Kernel::Ray_3 away(Kernel::Point_3(9., 9., 9.), Kernel::Point_3(10., 10., 10.));
    CHECK(constant.locate(away, tree).first == boost::graph_traits<Mesh>::null_face());
    CHECK(constant.template locate<AABB_traits>(away).first == boost::graph_traits<Mesh>::null_face());
  }

  // Locates a random point and a random ray, with each tree and without one.
  void locate_with(const std::vector<const Tree*>& trees)
  {
    const Paths& constant = m_paths;
    const Kernel::Point_3 p(m_random.uniform(-2., 2.), m_random.uniform(-2., 2.), m_random.uniform(-2., 2.));
    const Kernel::Point_3 target(m_random.uniform(-.3, .3), m_random.uniform(-.3, .3), m_random.uniform(-.3, .3));
    const Kernel::Ray_3 ray(p, target);
    for(const Tree* t : trees)
    {
      const auto a = constant.locate(p, *t);
      const auto b = constant.locate(ray, *t);
      const auto c = Paths::locate(p, *t, m_tm, m_vertex_point_map);
      const auto d = Paths::locate(ray, *t, m_tm, m_vertex_point_map, m_traits);
      CHECK(a == c && b == d);
      m_log.add(a.first, a.second);
      m_log.add(b.first, b.second);
    }
    for(const auto& l : {constant.template locate<AABB_traits>(p), constant.template locate<AABB_traits>(ray),
                         Paths::template locate<AABB_traits>(p, m_tm, m_vertex_point_map),
                         Paths::template locate<AABB_traits>(ray, m_tm, m_vertex_point_map, m_traits)})
    {
      m_log.add(l.first, l.second);
    }
  }

  void nothing_is_reached_after_clear()
  {
    m_paths.clear();
    CHECK_EQUAL(m_paths.number_of_source_points(), 0u);
    const auto unreached = m_paths.shortest_distance_to_source_points(vertex(0));
    CHECK_EQUAL(unreached.first, -1.);
    CHECK(unreached.second == m_paths.source_points_end());
  }

  const Mesh& m_tm;
  test_support::Random m_random;
  const Paths_traits m_traits{};
  typename Paths::Vertex_point_map m_vertex_point_map;
  Paths m_paths;
  Log m_log;
};

void both_classes_agree(std::uint64_t seed)
{
  for(const Indexed_mesh& indexed : {noisy_sphere(2, .1, seed), jittered(midpoint_subdivision(cube_grid(2)), .1, seed),
                                     rough_terrain(8, 1.5, seed)})
  {
    test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    const Log a = Member_calls<Geodesic_paths>(tm, seed + 1).run();
    const Log b = Member_calls<Shortest_path>(tm, seed + 1).run();
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

// --- members of the new class only ---

// Without sources nothing is reached.
template <class Map>
void check_members_without_sources(const Geodesic_paths& paths, const Mesh& tm, Map map)
{
  paths.shortest_distances_to_source_points(map);
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(get(map, v), -1.);
  }
  CHECK(paths.farthest_vertex().first == boost::graph_traits<Mesh>::null_vertex());
  CHECK_EQUAL(paths.farthest_vertex().second, -1.);
  CHECK_EQUAL(paths.nearest_source_point(vertex(0)), Geodesic_paths::no_source);
  CHECK_EQUAL(paths.nearest_source_point(face(0), {.2, .3, .5}), Geodesic_paths::no_source);
}

// The members for all vertices, and the numbers of sources, agree with single queries.
template <class Map, class Float_map>
void check_members_with_sources(Geodesic_paths& paths, const Mesh& tm, Map map, Float_map float_map,
                                test_support::Random& random)
{
  const double size = size_of(tm);
  paths.shortest_distances_to_source_points(map);
  paths.shortest_distances_to_source_points(float_map);
  double largest = -1.;
  for(const vertex_descriptor v : vertices(tm))
  {
    const Answer answer = ask(paths, Surface_point(v));
    CHECK_EQUAL(get(map, v), answer.distance);
    CHECK_EQUAL(get(float_map, v), float(answer.distance));
    CHECK_EQUAL(paths.nearest_source_point(v), answer.source);
    largest = (std::max)(largest, answer.distance);
    checked_path(paths, Surface_point(v), tm, size);
  }
  const auto farthest = paths.farthest_vertex();
  CHECK_EQUAL(farthest.second, largest);
  CHECK_EQUAL(ask(paths, Surface_point(farthest.first)).distance, largest);
  for(std::size_t j = 0; j < 50; ++j)
  {
    const Surface_point query = random_location(tm, random);
    CHECK_EQUAL(paths.nearest_source_point(query.location.first, query.location.second), ask(paths, query).source);
    checked_path(paths, query, tm, size);
  }
}

void further_members_agree_with_queries()
{
  test_support::Scope scope("further members");
  test_support::Random random(11);
  for(const Indexed_mesh& indexed : {noisy_sphere(2, .1, 7), two_components_and_an_isolated_vertex()})
  {
    const Mesh tm = to_face_graph(indexed);
    Geodesic_paths paths(tm);
    auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
    auto float_map = get(CGAL::dynamic_vertex_property_t<float>(), tm);
    check_members_without_sources(paths, tm, map);
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
      check_members_with_sources(paths, tm, map, float_map, random);
    }
  }
}

// The original documents this overload but does not have it.
void trees_are_built_without_a_point_map()
{
  test_support::Scope scope("tree");
  const Mesh tm = to_face_graph(noisy_sphere(1, .1, 3));
  Tree tree;
  Geodesic_paths::build_aabb_tree(tm, tree);
  CHECK_EQUAL(tree.size(), num_faces(tm));
}

// In a face with nearly no height, rounding destroys the coordinates of points.
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

// locate() is right, or throws because the mesh is too large or too small.
void points_are_located_or_rejected(std::uint64_t seed)
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
      bool is_rejected = false;
      try
      {
        const Face_location location = paths.locate<AABB_traits>(q);
        const Kernel::Point_3 found = paths.point(location.first, location.second);
        CHECK(std::abs(found.x() - q.x()) <= 1e-12 * unit && std::abs(found.y() - q.y()) <= 1e-12 * unit
              && std::abs(found.z() - q.z()) <= 1e-12 * unit);
      }
      catch(const Invalid_input& e)
      {
        is_rejected = e.reason() == Reason::NON_FINITE_POINT;
      }
      CHECK_EQUAL(is_rejected, std::abs(exponent) > 260);
    }
  }
  const Geodesic_paths paths(tm);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const Kernel::Point_3& p : {Kernel::Point_3(nan, 0, 0), Kernel::Point_3(0, nan, 0), Kernel::Point_3(0, 0, nan)})
  {
    CHECK(throws_reason(Reason::NON_FINITE_POINT, [&] { paths.locate<AABB_traits>(p); }));
  }
  // Rays, whose directions have to be numbers as well.
  const double infinity = std::numeric_limits<double>::infinity();
  const Kernel::Point_3 above(2.2, 2.3, 10.);
  for(const double down : {-1e-6, -1., -1e60})
  {
    const Face_location location = paths.locate<AABB_traits>(Kernel::Ray_3(above, Kernel::Vector_3(0, 0, down)));
    CHECK(location.first != Mesh::null_face());
  }
  for(const double bad : {nan, infinity, -infinity, 1e200})
  {
    for(const Kernel::Vector_3& v : {Kernel::Vector_3(bad, 0, -1), Kernel::Vector_3(0, 0, bad)})
    {
      const Kernel::Ray_3 ray(above, v);
      CHECK(throws_reason(Reason::NON_FINITE_POINT, [&] { paths.locate<AABB_traits>(ray); }));
    }
  }
}

// CGAL's trees would assert, or hold boxes of other points.
void vertices_without_a_place_are_rejected()
{
  for(const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    Mesh tm = to_face_graph(octahedron());
    tm.point(vertex(3)) = Kernel::Point_3(0., x, 0.);
    const Geodesic_paths paths(tm);
    CHECK(throws_reason(Reason::NON_FINITE_POINT, [&] { paths.locate<AABB_traits>(Kernel::Point_3(0., 0., 0.)); }));
    Tree tree;
    CHECK(throws_reason(Reason::NON_FINITE_POINT, [&] { paths.build_aabb_tree(tree); }));
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260403);
  both_classes_agree(seed);
  further_members_agree_with_queries();
  trees_are_built_without_a_point_map();
  points_of_flat_faces_are_located();
  points_are_located_or_rejected(seed);
  vertices_without_a_place_are_rejected();
  return test_result();
}
