// Straightest geodesics from a location: closed forms in the plane and on cones, cylinders and the cube; walks back to
// the start on all meshes; vertices, borders, degenerate faces and invalid input.

#include "Counting_mesh.h"
#include "expected_exceptions.h"
#include "hostile_meshes.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

using namespace test_meshes;
using hostile_meshes::hostile_mesh;
using hostile_meshes::is_surface;
using CGAL::Surface_mesh_geodesics::geodesic_direction;
using CGAL::Surface_mesh_geodesics::geodesic_direction_vector;
using CGAL::Surface_mesh_geodesics::trace_geodesic;
using CGAL::Surface_mesh_geodesics::trace_geodesic_from_edge_lengths;
using Traced = CGAL::Surface_mesh_geodesics::Traced_geodesic<Mesh>;

static_assert(std::is_same<Traced::Face_location,
                           CGAL::Polygon_mesh_processing::Face_location<Mesh, double>>::value,
              "locations are those of CGAL's functions");

namespace {

double distance_of(const Coordinates& a, const Coordinates& b) { return length(a - b); }

Coordinates point_of(const Mesh& tm, const Traced::Face_location& l)
{
  Coordinates p{0, 0, 0};
  auto h = halfedge(l.first, tm);
  for(std::size_t k = 0; k < 3; ++k)
  {
    const auto& q = tm.point(source(h, tm));
    p = p + l.second[k] * Coordinates{q.x(), q.y(), q.z()};
    h = next(h, tm);
  }
  return p;
}

Face_location random_location(const Mesh& tm, test_support::Random& random)
{
  const double a = random.uniform(.05, .9), b = random.uniform(.05, .95 - a);
  return {face_descriptor(static_cast<Mesh::size_type>(random.index(num_faces(tm)))), {a, b, 1 - a - b}};
}

// The segments of the geodesic add up to its length, and each of them is in a face.
void check_polyline(const Mesh& tm, const Traced& g)
{
  CHECK_EQUAL(g.points.size(), g.locations.size());
  double sum = 0;
  for(std::size_t i = 0; i < g.locations.size(); ++i)
  {
    CHECK(distance_of(g.points[i], point_of(tm, g.locations[i])) < 1e-12);
    if(i > 0)
      sum += distance_of(g.points[i], g.points[i - 1]);
  }
  CHECK_NEAR(sum, g.length, 1e-11 * (1 + g.length));
}

// --- the plane ---

void test_plane()
{
  const test_support::Scope scope("plane");
  const Mesh tm = to_face_graph(flat_patch(20, 20, .15, true, 3));
  test_support::Random random(4);
  for(int i = 0; i < 2000; ++i)
  {
    const bool is_vertex = i % 4 == 0;
    Face_location from = random_location(tm, random);
    if(is_vertex)
      from.second = {0, 1, 0};
    else if(i % 4 == 1)
      from.second = {.3, 0, .7};
    const double a = random.uniform(0, 7);
    const Coordinates v{std::cos(a), std::sin(a), 0};
    const double direction = geodesic_direction(tm, from, v);
    CHECK(direction >= 0 && direction < 2 * pi);
    const Traced g = trace_geodesic(tm, from, direction, .4);
    check_polyline(tm, g);
    CHECK(distance_of(g.points.front(), point_of(tm, from)) < 1e-14);
    CHECK(distance_of(g.points.back(), g.points.front() + g.length * v) < 1e-13);
    CHECK(g.end == Traced::AT_LENGTH ? g.length == .4 : g.length < .4);
    if(g.length > 0)
    {
      CHECK(distance_of(geodesic_direction_vector(tm, g.locations.back(), g.direction).second, v) < 1e-11);
      CHECK(distance_of(geodesic_direction_vector(tm, from, direction).second, v) < 1e-13);
    }
  }
}

// --- cones: a vertex is passed with equal angles on both sides ---

void test_cones()
{
  for(const bool is_cone : {true, false})
  {
    const test_support::Scope scope(is_cone ? "cone" : "saddle");
    const std::size_t n = 10;
    const Mesh tm = to_face_graph(is_cone ? cone_fan(n) : saddle_fan(n));
    const vertex_descriptor apex(0);
    // From vertex i along the edge to the apex, and on: n is even, so straight on is the opposite edge.
    for(std::size_t i = 1; i <= n; ++i)
    {
      const vertex_descriptor v(static_cast<Mesh::size_type>(i));
      const auto h = halfedge(v, apex, tm).first;
      const auto p = tm.point(v), o = tm.point(apex);
      const double side = std::sqrt(CGAL::squared_distance(p, o));
      std::array<double, 3> corner{0, 0, 0};
      auto first = halfedge(face(h, tm), tm);
      for(std::size_t k = 0; k < 3; ++k, first = next(first, tm))
        corner[k] = source(first, tm) == v ? 1 : 0;
      const Face_location from(face(h, tm), corner);
      const double direction = geodesic_direction(tm, from, Coordinates{o.x() - p.x(), o.y() - p.y(), o.z() - p.z()});
      const Traced g = trace_geodesic(tm, from, direction, 1.5 * side);
      const auto q = tm.point(vertex_descriptor(static_cast<Mesh::size_type>((i + n / 2 - 1) % n + 1)));
      CHECK_EQUAL(g.locations.size(), 3u);
      CHECK(g.end == Traced::AT_LENGTH);
      CHECK(distance_of(g.points.back(), {(o.x() + q.x()) / 2, (o.y() + q.y()) / 2, (o.z() + q.z()) / 2}) < 1e-12);
      // The end is at the border after the whole side.
      CHECK(trace_geodesic(tm, from, direction, 3 * side).end == Traced::AT_BORDER);
      CHECK_NEAR(trace_geodesic(tm, from, direction, 3 * side).length, 2 * side, 1e-12);
    }
    // At the apex, n edges have equally spaced directions.
    for(std::size_t i = 0; i < n; ++i)
    {
      const double step = 2 * pi / static_cast<double>(n);
      const auto a = trace_geodesic(tm, apex, static_cast<double>(i) * step, 1e-3);
      const auto first = tm.point(target(opposite(halfedge(apex, tm), tm), tm));
      const auto v = geodesic_direction_vector(tm, apex, static_cast<double>(i) * step).second;
      if(i == 0)
        CHECK(distance_of(v, (1 / std::sqrt(CGAL::squared_distance(first, tm.point(apex))))
                               * Coordinates{first.x(), first.y(), first.z()}) < 1e-12);
      CHECK_EQUAL(a.locations.size(), 2u);
      const auto& b = a.locations.back().second;
      CHECK(std::count(b.begin(), b.end(), 0.) == 1); // on the edge
    }
  }
}

// --- the cube: around four faces, a geodesic at a right angle to the edges closes ---

void test_cube()
{
  const test_support::Scope scope("cube");
  Indexed_mesh cube;
  cube.name = "cube";
  cube.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  add_quadrilateral(cube, 0, 3, 2, 1);
  add_quadrilateral(cube, 4, 5, 6, 7);
  add_quadrilateral(cube, 0, 1, 5, 4);
  add_quadrilateral(cube, 1, 2, 6, 5);
  add_quadrilateral(cube, 2, 3, 7, 6);
  add_quadrilateral(cube, 3, 0, 4, 7);
  const Mesh tm = to_face_graph(cube);
  test_support::Random random(5);
  for(int i = 0; i < 200; ++i)
  {
    const Face_location from = random_location(tm, random);
    const Coordinates p = point_of(tm, from);
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      Coordinates v{0, 0, 0};
      v[axis] = 1;
      if(std::abs(p[axis]) < 1e-9 || std::abs(p[axis] - 1) < 1e-9) // a normal of the face
        continue;
      const double direction = geodesic_direction(tm, from, v);
      const Traced g = trace_geodesic(tm, from, direction, 4.);
      check_polyline(tm, g);
      CHECK(distance_of(g.points.back(), p) < 1e-13);
      CHECK(distance_of(geodesic_direction_vector(tm, g.locations.back(), g.direction).second, v) < 1e-12);
      CHECK(g.locations.size() >= 9);
    }
    // Any direction: the way back.
    const double direction = random.uniform(0, 6);
    const Traced there = trace_geodesic(tm, from, direction, 10.);
    const Traced back = trace_geodesic(tm, there.locations.back(), there.direction + pi, 10.);
    CHECK(there.end == Traced::AT_LENGTH && back.end == Traced::AT_LENGTH);
    CHECK(distance_of(back.points.back(), p) < 1e-11);
  }
}

// --- the cylinder, by lengths only: a helix ---

void test_cylinder()
{
  const test_support::Scope scope("cylinder");
  const std::size_t m = 12, n = 8;
  const double width = 2 * pi / static_cast<double>(m), height = .5;
  const Indexed_mesh indexed
    = open_tube("cylinder", m, n, [&](std::size_t i, std::size_t j)
                { return Coordinates{std::cos(width * static_cast<double>(i)), std::sin(width * static_cast<double>(i)),
                                     height * static_cast<double>(j)}; });
  const Mesh tm = to_face_graph(indexed);
  // The lengths of the unrolled cylinder.
  const auto lengths = boost::make_function_property_map<boost::graph_traits<Mesh>::edge_descriptor>(
    [&](boost::graph_traits<Mesh>::edge_descriptor e)
    {
      const auto p = tm.point(source(e, tm)), q = tm.point(target(e, tm));
      const double turn = std::remainder(std::atan2(p.y(), p.x()) - std::atan2(q.y(), q.x()), 2 * pi);
      return std::hypot(turn, p.z() - q.z());
    });
  const vertex_descriptor v(0);
  const bool is_at_bottom = tm.point(v).z() == 0;
  CHECK(is_at_bottom);
  for(int i = 1; i < 30; ++i)
  {
    const double slope = pi * i / 30;
    const double l = 2.5;
    // At the border, directions count from the border edge, counterclockwise.
    const Traced g = trace_geodesic_from_edge_lengths(tm, lengths, v, slope, l);
    CHECK(g.points.empty());
    if(l * std::sin(slope) > height * static_cast<double>(n - 1))
      continue;
    CHECK(g.end == Traced::AT_LENGTH);
    CHECK_NEAR(point_of(tm, g.locations.back())[2], l * std::sin(slope), 1e-12);
  }
}

// --- the way back, on closed and open surfaces ---

void test_way_back()
{
  for(const Indexed_mesh& indexed : collection(1))
  {
    const test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    test_support::Random random(6);
    for(int i = 0; i < 40; ++i)
    {
      Face_location from = random_location(tm, random);
      if(i % 3 == 0)
        from.second = {0, .25, .75};
      const Traced there = trace_geodesic(tm, from, random.uniform(-10, 10), 2.);
      check_polyline(tm, there);
      CHECK(there.end != Traced::AT_SINGULARITY);
      if(there.end != Traced::AT_LENGTH)
        continue;
      const Traced back = trace_geodesic(tm, there.locations.back(), there.direction + pi, 2.);
      CHECK(back.end == Traced::AT_LENGTH || i % 3 == 0); // the start may be on the border
      CHECK(distance_of(back.points.back(), point_of(tm, from)) < 1e-9);
    }
  }
}

// --- along edges, through vertices of total angle 2 pi ---

void test_along_edges()
{
  const test_support::Scope scope("along edges");
  const std::size_t n = 8;
  const Mesh tm = to_face_graph(flat_patch(n, n, 0., false, 1));
  for(const vertex_descriptor v : vertices(tm))
  {
    std::array<double, 3> corner{0, 0, 0};
    for(const auto h : halfedges_around_target(v, tm))
    {
      if(is_border(h, tm))
        continue;
      auto g = halfedge(face(h, tm), tm);
      for(std::size_t k = 0; k < 3; ++k, g = next(g, tm))
        corner[k] = source(g, tm) == v ? 1 : 0;
      const Face_location from(face(h, tm), corner);
      const auto p = tm.point(v), q = tm.point(target(next(h, tm), tm));
      const Coordinates d{q.x() - p.x(), q.y() - p.y(), 0};
      const Traced t = trace_geodesic(tm, from, geodesic_direction(tm, from, d), 20.);
      CHECK(t.end == Traced::AT_BORDER);
      CHECK(distance_of(t.points.back(), t.points.front() + (t.length / length(d)) * d) < 1e-12);
      for(std::size_t i = 1; i + 1 < t.locations.size(); ++i)
        CHECK(std::count(t.locations[i].second.begin(), t.locations[i].second.end(), 0.) == 2);
    }
  }
}

// --- the faces of the mesh are not counted on the way ---

void test_number_of_faces()
{
  const test_support::Scope scope("number of faces");
  const Counting_mesh tm(to_face_graph(noisy_sphere(3, .1, 3)));
  const std::pair<face_descriptor, std::array<double, 3>> from(face_descriptor(7), {.2, .3, .5});
  const auto g = trace_geodesic(tm, from, 1., 20.);
  CHECK(g.locations.size() > 200);
  CHECK_EQUAL(tm.counts, 0u);
}

// --- hostile meshes: it ends, with a length that is that of its segments ---

// A length for which no geodesic crosses many faces: around a spike, each turn may be as short as a face is thin.
double short_length(const Mesh& tm)
{
  double least = 1;
  for(const face_descriptor f : faces(tm))
  {
    double longest = 0, shortest = 1e9;
    for(const auto h : halfedges_around_face(halfedge(f, tm), tm))
    {
      const double l = std::sqrt(CGAL::squared_distance(tm.point(source(h, tm)), tm.point(target(h, tm))));
      longest = (std::max)(longest, l);
      shortest = (std::min)(shortest, l);
    }
    const double area = CGAL::Polygon_mesh_processing::face_area(f, tm);
    for(const double x : {shortest, longest > 0 ? 2 * area / longest : 0.})
      least = x > 0 ? (std::min)(least, x) : least;
  }
  return 300 * least;
}

void test_hostile_meshes()
{
  std::size_t singular = 0, at_border = 0, at_length = 0, counted = 0;
  for(std::uint64_t seed = 0; seed < 2000; ++seed)
  {
    const test_support::Scope scope("hostile " + std::to_string(seed));
    test_support::Random random(seed);
    Mesh tm;
    if(!is_surface(hostile_mesh(random), tm))
      continue;
    const double l = short_length(tm);
    const Counting_mesh counting(tm);
    for(int i = 0; i < 4; ++i)
    {
      const Face_location from = random_location(tm, random);
      const double direction = random.uniform(0, 2 * pi);
      const Traced g = trace_geodesic(tm, from, direction, l);
      // Where rounding leaves no length in faces, their number ends a walk; it is asked for once.
      counting.counts = 0;
      CHECK(trace_geodesic(counting, from, direction, l).locations == g.locations);
      CHECK(counting.counts <= 1);
      counted += counting.counts;
      check_polyline(tm, g);
      ++(g.end == Traced::AT_LENGTH ? at_length : g.end == Traced::AT_BORDER ? at_border : singular);
      CHECK(g.end != Traced::AT_LENGTH || std::abs(g.length - l) < 1e-12 * l);
      CHECK(g.direction >= 0 && g.direction < 2 * pi);
      // A geodesic without length has got there wherever it begins.
      CHECK(trace_geodesic(tm, from, direction, 0.).end == Traced::AT_LENGTH);
      CHECK(trace_geodesic(tm, target(halfedge(from.first, tm), tm), direction, 0.).end == Traced::AT_LENGTH);
    }
  }
  CHECK(at_length > 1000 && at_border > 100 && counted > 10);
  std::cout << "hostile: " << at_length << " at length, " << at_border << " at border, " << singular << " singular, "
            << counted << " counted\n";
}

// --- all scales, by powers of two, give the same bits ---

void test_scales()
{
  const test_support::Scope scope("scales");
  const Indexed_mesh indexed = noisy_sphere(2, .1, 3);
  const Mesh tm = to_face_graph(indexed);
  for(const int exponent : {-900, -600, 600, 900})
  {
    Indexed_mesh scaled = indexed;
    for(Coordinates& p : scaled.points)
      p = std::ldexp(1., exponent) * p;
    const Mesh other = to_face_graph(scaled);
    const Face_location from(face_descriptor(7), {.2, .3, .5});
    const Traced a = trace_geodesic(tm, from, 1., 5.), b = trace_geodesic(other, from, 1., std::ldexp(5., exponent));
    CHECK(a.locations == b.locations);
    CHECK_EQUAL(a.direction, b.direction);
  }
}

// --- invalid input ---

void test_invalid_input()
{
  const test_support::Scope scope("invalid input");
  Mesh tm = to_face_graph(icosphere(1));
  const vertex_descriptor isolated = tm.add_vertex(Kernel::Point_3(0, 0, 0));
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Face_location good(face_descriptor(3), {.2, .3, .5});
  using Invalid = CGAL::Surface_mesh_geodesics::Invalid_geodesic_input;
  const auto rejects = [&](const auto& location, double direction, double l, Invalid::Reason reason)
  {
    try
    {
      trace_geodesic(tm, location, direction, l);
    }
    catch(const Invalid& error)
    {
      return error.reason() == reason && std::string(error.what()).size() > 10;
    }
    return false;
  };
  using Reason = Invalid::Reason;
  CHECK(rejects(good, nan, 1., Reason::INVALID_DIRECTION));
  CHECK(rejects(good, inf, 1., Reason::INVALID_DIRECTION));
  CHECK(rejects(good, 0., -1., Reason::INVALID_DIRECTION));
  CHECK(rejects(good, 0., nan, Reason::INVALID_DIRECTION));
  CHECK(rejects(good, 0., inf, Reason::INVALID_DIRECTION));
  CHECK(rejects(Face_location(face_descriptor(3), {.2, .3, .6}), 0., 1., Reason::INVALID_LOCATION));
  CHECK(rejects(Face_location(face_descriptor(3), {nan, .3, .6}), 0., 1., Reason::INVALID_LOCATION));
  CHECK(rejects(Face_location(Mesh::null_face(), {.2, .3, .5}), 0., 1., Reason::INVALID_LOCATION));
  CHECK(rejects(Face_location(face_descriptor(12345), {.2, .3, .5}), 0., 1., Reason::INVALID_DESCRIPTOR));
  CHECK(rejects(Mesh::null_vertex(), 0., 1., Reason::INVALID_DESCRIPTOR));
  CHECK(rejects(vertex_descriptor(12345), 0., 1., Reason::INVALID_DESCRIPTOR));
  CHECK(rejects(isolated, 0., 1., Reason::INVALID_DESCRIPTOR));
  CHECK(throws<Invalid>([&] { geodesic_direction(tm, good, Coordinates{0, 0, 0}); }));
  CHECK(throws<Invalid>([&] { geodesic_direction(tm, good, Coordinates{nan, 0, 0}); }));
  const auto normal = CGAL::Polygon_mesh_processing::compute_face_normal(good.first, tm);
  CHECK(throws<Invalid>([&] { geodesic_direction(tm, good, normal); }));
  CHECK(throws<Invalid>([&] { geodesic_direction_vector(tm, good, nan); }));
  const Traced none = trace_geodesic(tm, good, 1., 0.);
  CHECK_EQUAL(none.locations.size(), 1u);
  CHECK_EQUAL(none.length, 0.);
  CHECK_CLOSE(none.direction, 1., 1e-14);
  CHECK(none.end == Traced::AT_LENGTH);
  tm.point(vertex_descriptor(0)) = Kernel::Point_3(nan, 0, 0);
  CHECK(rejects(vertex_descriptor(0), 0., 1., Reason::NON_FINITE_POINT));
  const auto lengths = boost::make_function_property_map<boost::graph_traits<Mesh>::edge_descriptor>(
    [](boost::graph_traits<Mesh>::edge_descriptor) { return -1.; });
  CHECK(throws<Invalid>([&] { trace_geodesic_from_edge_lengths(tm, lengths, good, 0., 1.); }));
}

// At the border, the directions of the first and of the last neighbor lead along it, also where a thousand angles have
// been summed up from the other end.
void test_border_of_large_fans()
{
  test_support::Random random(20261129);
  for(const std::size_t n : {3u, 300u, 3000u})
    for(std::size_t k = 0; k < 10; ++k)
    {
      const test_support::Scope scope("fan of " + std::to_string(n) + " faces, " + std::to_string(k));
      std::vector<double> angle(1, 0.);
      while(angle.size() <= n)
        angle.push_back(angle.back() + random.uniform(.2, 1.2));
      const double factor = random.uniform(1., 5.5) / angle.back();
      Mesh tm;
      const vertex_descriptor apex = tm.add_vertex(Kernel::Point_3(0, 0, 0));
      std::vector<vertex_descriptor> rim;
      for(const double a : angle)
      {
        const double r = random.uniform(1., 1.3);
        rim.push_back(tm.add_vertex(
          Kernel::Point_3(r * std::cos(factor * a), r * std::sin(factor * a), random.uniform(0., .3))));
      }
      double total = 0;
      for(std::size_t i = 0; i < n; ++i)
      {
        tm.add_face(apex, rim[i], rim[i + 1]);
        const auto u = tm.point(rim[i]) - CGAL::ORIGIN, w = tm.point(rim[i + 1]) - CGAL::ORIGIN;
        total += std::atan2(std::sqrt(CGAL::cross_product(u, w).squared_length()), u * w);
      }
      // The sum from the other end, and what rounding may make of it.
      const double rounding = 1e-16 * static_cast<double>(n);
      for(const double direction : {total, total * (1 + rounding), -rounding})
      {
        const Traced t = trace_geodesic(tm, apex, direction, .5);
        CHECK(t.end == Traced::AT_LENGTH);
        CHECK_CLOSE(t.length, .5, 1e-14);
      }
    }
}

// An edge without faces may be linked into the border beside a vertex.
void test_vertex_with_edge_without_faces()
{
  Mesh tm;
  const vertex_descriptor p = tm.add_vertex(Kernel::Point_3(0, 0, 0)), x = tm.add_vertex(Kernel::Point_3(-1, 0, 0));
  tm.add_face(p, tm.add_vertex(Kernel::Point_3(1, 0, 0)), tm.add_vertex(Kernel::Point_3(.4, 1, 0)));
  Mesh::Halfedge_index into;
  for(const auto h : tm.halfedges())
    if(tm.is_border(h) && tm.target(h) == p)
      into = h;
  const auto out = tm.next(into), away = tm.add_edge(p, x), back = tm.opposite(away);
  for(const auto h : {away, back})
    tm.set_face(h, Mesh::null_face());
  tm.set_next(into, away);
  tm.set_next(away, back);
  tm.set_next(back, out);
  tm.set_halfedge(x, away);
  for(const auto h : {into, back})
  {
    tm.set_halfedge(p, h);
    CHECK_CLOSE(trace_geodesic(tm, p, .3, .2).length, .2, 1e-14);
  }
}

} // namespace

int main()
{
  test_border_of_large_fans();
  test_vertex_with_edge_without_faces();
  test_plane();
  test_cones();
  test_cube();
  test_cylinder();
  test_way_back();
  test_along_edges();
  test_number_of_faces();
  test_hostile_meshes();
  test_scales();
  test_invalid_input();
  return test_result();
}
