// geodesic_distance() and geodesic_path(): one pair of points, in any mix of vertices and locations.

#include "distance_test_helpers.h"
#include "expected_exceptions.h"
#include "hostile_meshes.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

using Point = Kernel::Point_3;

double length(const std::vector<Point>& points)
{
  double sum = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
  return sum;
}

Point point_of(const Mesh& tm, vertex_descriptor v)
{
  return tm.point(v);
}

Point point_of(const Mesh& tm, const Face_location& location)
{
  const auto h = halfedge(location.first, tm);
  const auto &b = location.second;
  return CGAL::barycenter(tm.point(source(h, tm)), b[0], tm.point(target(h, tm)), b[1],
                          tm.point(target(next(h, tm), tm)), b[2]);
}

// The path begins and ends where it should, has the length that is returned, and this is the distance, there and back.
template <typename A, typename B>
double check_pair(const Mesh& tm, const A& a, const B& b)
{
  std::vector<Point> points;
  const double d = SMG::geodesic_path(tm, a, b, std::back_inserter(points));
  CHECK(points.size() >= 2 || d == 0);
  CHECK_CLOSE(length(points), d, 1e-12);
  CHECK_CLOSE(SMG::geodesic_distance(tm, a, b), d, 1e-12);
  CHECK_CLOSE(SMG::geodesic_distance(tm, b, a), d, 1e-12);
  CHECK(std::sqrt(CGAL::squared_distance(points.front(), point_of(tm, a))) <= 1e-12);
  CHECK(std::sqrt(CGAL::squared_distance(points.back(), point_of(tm, b))) <= 1e-12);
  return d;
}

void all_kinds_of_pairs_agree(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  for(int k = 0; k < 8; ++k)
  {
    const vertex_descriptor v = random_vertex(tm, random), w = random_vertex(tm, random);
    const Face_location p = random_location(tm, random), q = random_location(tm, random);
    CHECK_EQUAL(SMG::geodesic_distance(tm, v, w), distances(tm, v)[std::size_t(w)]);
    CHECK_EQUAL(SMG::geodesic_distance(tm, p, w), distances(tm, p)[std::size_t(w)]);
    check_pair(tm, v, w);
    check_pair(tm, v, p);
    check_pair(tm, p, w);
    check_pair(tm, p, q);
    check_pair(tm, v, v);
  }
}

// The propagation ends early, and the path is the one of a propagation over the whole surface, bit by bit.
template <typename Paths, typename A, typename... Place>
void check_bits(const Mesh& tm, const Paths& paths, const A& a, const A& b, const Place&... place)
{
  std::vector<Point> whole, early;
  const auto expected = paths.shortest_path_points_to_source_points(place..., std::back_inserter(whole));
  const double none = std::numeric_limits<double>::infinity();
  const double d = SMG::geodesic_path(tm, a, b, std::back_inserter(early));
  CHECK_EQUAL(d, expected.first < 0 ? none : expected.first);
  CHECK(early == whole);
}

void early_ends_keep_bits(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope("bits: " + indexed.name);
  const Mesh tm = to_face_graph(indexed);
  using Paths = CGAL::Surface_mesh_geodesic_paths<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;
  for(int k = 0; k < 3; ++k)
  {
    const vertex_descriptor v = random_vertex(tm, random);
    const Face_location p = random_location(tm, random);
    Paths from_vertex(tm), from_location(tm);
    from_vertex.add_source_point(v);
    from_location.add_source_point(p);
    for(int l = 0; l < 4; ++l)
    {
      const vertex_descriptor w = random_vertex(tm, random);
      const Face_location q = random_location(tm, random);
      check_bits(tm, from_vertex, w, v, w);
      check_bits(tm, from_location, q, p, q.first, q.second);
      const double d = from_location.shortest_distance_to_source_points(q.first, q.second).first;
      CHECK_EQUAL(SMG::geodesic_distance(tm, p, q), d < 0 ? std::numeric_limits<double>::infinity() : d);
    }
  }
}

// Calls use() with a vertex or a location.
template <typename Use>
void use_place(const Surface_point& p, Use use)
{
  if(p.is_vertex())
    use(p.vertex);
  else
    use(p.location);
}

// Paths that rounding hides are searched for by distances, of which only some are final where the propagation ends
// early. The lengths are those of paths over the whole surface.
void hostile_meshes_have_paths()
{
  for(std::uint64_t seed = 1; seed <= 600; ++seed)
  {
    test_support::Scope scope("hostile mesh, seed " + std::to_string(seed));
    test_support::Random random(seed);
    Mesh tm;
    if(!hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), tm))
      continue;
    const double size = size_of(tm);
    for(int k = 0; k < 6; ++k)
    {
      const Surface_point a = hostile_meshes::hostile_point(tm, random), b = hostile_meshes::hostile_point(tm, random);
      use_place(a, [&](const auto& p) { use_place(b, [&](const auto& q)
      {
        std::vector<Point> points;
        double d = 0;
        CHECK(!throws<std::runtime_error>([&] { d = SMG::geodesic_path(tm, p, q, std::back_inserter(points)); }));
        if(points.empty())
          return;
        CHECK_NEAR(length(points), d, 1e-10 * d + 1e-13 * size);
        CHECK_NEAR(SMG::geodesic_distance(tm, q, p), d, 1e-11 * d + 1e-13 * size);
      }); });
    }
  }
}

// The visits that a pair costs, of a distance and of a path.
template <typename A, typename B>
std::size_t visits_of_pair(const Mesh& tm, const A& a, const B& b)
{
  CGAL::Surface_mesh_geodesics::Propagation_statistics of_distance, of_path;
  std::vector<Point> points;
  SMG::geodesic_distance(tm, a, b, CGAL::parameters::statistics(&of_distance));
  SMG::geodesic_path(tm, a, b, std::back_inserter(points), CGAL::parameters::statistics(&of_path));
  CHECK(of_distance.vertices_visited > 0 && of_path.vertices_visited > 0);
  return (std::max)(of_distance.vertices_visited, of_path.vertices_visited);
}

// A pair is paid for by the area around it, not by the surface.
void near_pairs_cost_little()
{
  test_support::Scope scope("near pairs");
  const Mesh tm = to_face_graph(icosphere(5));
  const std::size_t n = num_vertices(tm);
  const auto h = *halfedges(tm).begin();
  const vertex_descriptor v = source(h, tm), w = target(h, tm);
  const Face_location p{face(h, tm), {.2, .3, .5}}, q{face(opposite(h, tm), tm), {.6, .3, .1}};
  CHECK(visits_of_pair(tm, v, w) < n / 100);
  CHECK(visits_of_pair(tm, v, q) < n / 100);
  CHECK(visits_of_pair(tm, p, w) < n / 100);
  CHECK(visits_of_pair(tm, p, q) < n / 100);
  const std::vector<double> d = distances(tm, v);
  const auto last = static_cast<Mesh::size_type>(std::max_element(d.begin(), d.end()) - d.begin());
  CHECK(visits_of_pair(tm, v, vertex_descriptor(last)) > n / 2);
}

// In a square, distances are those of the plane; with faces to avoid, paths lead around.
void plane()
{
  test_support::Scope scope("plane");
  const Mesh tm = to_face_graph(flat_patch(6, 6, 0., false, 1));
  const Face_location p{*faces(tm).begin(), {.2, .3, .5}};
  const vertex_descriptor last(static_cast<Mesh::size_type>(num_vertices(tm) - 1));
  const double straight = std::sqrt(CGAL::squared_distance(point_of(tm, p), tm.point(last)));
  CHECK_CLOSE(check_pair(tm, p, last), straight, 1e-12);

  std::vector<face_descriptor> avoided;
  for(const face_descriptor f : faces(tm))
    if(f != p.first && std::size_t(f) % 3 == 0)
      avoided.push_back(f);
  const auto np = CGAL::parameters::faces_to_avoid(std::cref(avoided));
  std::vector<Point> points;
  const double around = SMG::geodesic_path(tm, p, last, std::back_inserter(points), np);
  CHECK_CLOSE(length(points), around, 1e-12);
  CHECK(around > straight * (1 + 1e-6));
  CHECK_CLOSE(SMG::geodesic_distance(tm, p, last, np), around, 1e-12);
}

void points_without_a_path()
{
  test_support::Scope scope("no path");
  const Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  const std::vector<double> from_first = distances(tm, vertex(0));
  const double none = std::numeric_limits<double>::infinity();
  for(const vertex_descriptor v : vertices(tm))
    if(!(from_first[std::size_t(v)] < none))
    {
      std::vector<Point> points;
      CHECK_EQUAL(SMG::geodesic_distance(tm, vertex(0), v), none);
      CHECK_EQUAL(SMG::geodesic_path(tm, vertex(0), v, std::back_inserter(points)), none);
      CHECK(points.empty());
    }
}

void bad_points_are_rejected()
{
  test_support::Scope scope("bad points");
  const Mesh tm = to_face_graph(icosphere(1));
  const vertex_descriptor bad = vertex(9999);
  const Face_location outside{face(0), {.5, .5, .5}};
  std::vector<Point> points;
  const auto output = std::back_inserter(points);
  CHECK(throws<Invalid_input>([&] { SMG::geodesic_distance(tm, vertex(0), bad); }));
  CHECK(throws<Invalid_input>([&] { SMG::geodesic_distance(tm, bad, vertex(0)); }));
  CHECK(throws<Invalid_input>([&] { SMG::geodesic_distance(tm, outside, vertex(0)); }));
  CHECK(throws<Invalid_input>([&] { SMG::geodesic_distance(tm, vertex(0), outside); }));
  CHECK(throws<Invalid_input>([&] { SMG::geodesic_distance(tm, outside, outside); }));
  CHECK(throws<Invalid_input>([&] { SMG::geodesic_path(tm, vertex(0), bad, output); }));
  CHECK(throws<Invalid_input>([&] { SMG::geodesic_path(tm, outside, vertex(0), output); }));
  CHECK(points.empty());
}

// Coordinates of another number type are those of double.
void other_number_types()
{
  test_support::Scope scope("number types");
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel::FT;
  const Mesh tm = to_face_graph(icosphere(2));
  const auto exact = [](const Face_location& l)
  {
    return std::make_pair(l.first, std::array<Exact, 3>{{Exact(l.second[0]), Exact(l.second[1]), Exact(l.second[2])}});
  };
  const Face_location a(face(3), {.25, .25, .5}), b(face(90), {.5, .125, .375});
  CHECK_EQUAL(SMG::geodesic_distance(tm, exact(a), exact(b)), SMG::geodesic_distance(tm, a, b));
  std::vector<Point> points, exact_points;
  const double d = SMG::geodesic_path(tm, a, b, std::back_inserter(points));
  CHECK_EQUAL(SMG::geodesic_path(tm, exact(a), exact(b), std::back_inserter(exact_points)), d);
  CHECK(exact_points == points);
}

// Another mesh, and points that are not those of the mesh.
void other_meshes_and_maps()
{
  test_support::Scope scope("maps");
  CGAL::Polyhedron_3<Kernel> polyhedron;
  polyhedron.make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1));
  const auto first = polyhedron.vertices_begin(), second = std::next(first);
  std::vector<Point> points;
  const double edge = SMG::geodesic_path(polyhedron, first, second, std::back_inserter(points));
  CHECK_CLOSE(edge, std::sqrt(CGAL::squared_distance(first->point(), second->point())), 1e-15);
  CHECK_EQUAL(points.size(), 2u);

  Mesh tm = to_face_graph(icosphere(2));
  auto doubled = tm.add_property_map<vertex_descriptor, Point>("v:doubled").first;
  for(const vertex_descriptor v : vertices(tm))
    doubled[v] = CGAL::ORIGIN + 2 * (tm.point(v) - CGAL::ORIGIN);
  const auto np = CGAL::parameters::vertex_point_map(doubled);
  CHECK_CLOSE(SMG::geodesic_distance(tm, vertex(0), vertex(70), np),
              2 * SMG::geodesic_distance(tm, vertex(0), vertex(70)), 1e-14);
  points.clear();
  const double d = SMG::geodesic_path(tm, vertex(0), vertex(70), std::back_inserter(points), np);
  CHECK_CLOSE(length(points), d, 1e-13);
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261124);
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : {noisy_sphere(2, .1, seed), rough_terrain(8, 2., seed), genus_2_polycube(),
                                     torus(1., .4, 20, 10)})
    all_kinds_of_pairs_agree(indexed, random);
  for(const Indexed_mesh& indexed : collection(seed))
    early_ends_keep_bits(indexed, random);
  hostile_meshes_have_paths();
  near_pairs_cost_little();
  plane();
  points_without_a_path();
  bad_points_are_rejected();
  other_number_types();
  other_meshes_and_maps();
  return test_result();
}
