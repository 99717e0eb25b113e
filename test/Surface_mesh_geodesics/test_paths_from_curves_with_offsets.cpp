// Paths, nearest points and isolines from curves with offsets: in the plane against formulas, on surfaces against the
// free function. Paths that cross curves whose offset is larger.

#include "curve_cases.h"
#include "expected_exceptions.h"
#include "hostile_meshes.h"
#include "path_test_helpers.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/shortest_path_curve.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
using SMG::Invalid_geodesic_input;
using Point = Mesh::Point;

namespace {

double distance_in_space(const Point& a, const Point& b) { return std::sqrt(CGAL::squared_distance(a, b)); }

Paths::Barycentric_coordinates in_traits(const std::array<double, 3>& b) { return {{b[0], b[1], b[2]}}; }

// A curve with its offset, and the same as a polyline in the plane.
struct Site
{
  std::vector<Point> polyline;
  double offset;

  // The nearest point of the polyline.
  Point foot(const Point& p) const
  {
    Point best = polyline[0];
    for(std::size_t i = 1; i < polyline.size(); ++i)
    {
      const CGAL::Vector_3<Kernel> along = polyline[i] - polyline[i - 1];
      const double t = (p - polyline[i - 1]) * along / along.squared_length();
      const Point q = polyline[i - 1] + (std::min)(1., (std::max)(0., t)) * along;
      if(CGAL::squared_distance(p, q) < CGAL::squared_distance(p, best))
        best = q;
    }
    return best;
  }

  double distance(const Point& p) const { return offset + distance_in_space(p, foot(p)); }
};

// The straight polyline through the points, on a flat mesh.
Curve curve_in_plane(const Mesh& tm, const std::vector<Point>& points)
{
  std::vector<Location> places;
  for(const Point& p : points)
    places.push_back(location_in_plane(p.x(), p.y(), tm));
  if(places.size() == 1)
    return Curve(tm, places);
  return SMG::shortest_path_curve(tm, places, false);
}

// Compares all queries with the formula. Returns how many of the places are nearest to each site.
std::vector<std::size_t> check_in_plane(const Mesh& tm, const std::vector<Site>& sites, double size)
{
  Paths paths(tm);
  for(const Site& s : sites)
    paths.add_source_curve(curve_in_plane(tm, s.polyline), s.offset);
  const auto nearest = [&](const Point& p)
  {
    std::size_t best = 0;
    for(std::size_t i = 1; i < sites.size(); ++i)
      if(sites[i].distance(p) < sites[best].distance(p))
        best = i;
    return best;
  };
  std::vector<std::size_t> number(sites.size(), 0);
  test_support::Random random(5);
  for(int k = 0; k < 400; ++k)
  {
    const auto l = random_location(tm, random);
    const auto b = in_traits(l.second);
    const Point p = paths.point(l.first, b);
    const std::size_t i = nearest(p);
    const double d = sites[i].distance(p);
    CHECK_NEAR(paths.shortest_distance_to_source_points(l.first, b).first, d, 1e-13 * size);
    // Near ties, either site is right.
    double second = std::numeric_limits<double>::infinity();
    for(std::size_t j = 0; j < sites.size(); ++j)
      second = j == i ? second : (std::min)(second, sites[j].distance(p));
    if(second < d + 1e-9 * size)
      continue;
    ++number[i];
    CHECK_EQUAL(paths.nearest_source_point(l.first, b), i);
    std::vector<Point> points;
    paths.shortest_path_points_to_source_points(l.first, b, std::back_inserter(points));
    const Point foot = sites[i].foot(p);
    CHECK_NEAR(distance_in_space(points.front(), p), 0., 1e-13 * size);
    CHECK_NEAR(distance_in_space(points.back(), foot), 0., 1e-12 * size);
    // All points are on the segment to the foot, in its direction.
    double length = 0;
    for(std::size_t m = 1; m < points.size(); ++m)
      length += distance_in_space(points[m - 1], points[m]);
    CHECK_NEAR(length, d - sites[i].offset, 1e-12 * size);
    for(const Point& q : points)
      CHECK_NEAR(distance_in_space(p, q) + distance_in_space(q, foot), distance_in_space(p, foot), 1e-12 * size);
    const auto end = paths.nearest_location_of_sources(l.first, b);
    CHECK_NEAR(distance_in_space(paths.point(end.first, end.second), foot), 0., 1e-12 * size);
  }
  for(const double value : {.1, .6, .9, 1.5, 2.2})
  {
    std::vector<std::vector<Point>> lines;
    paths.isolines(value, std::back_inserter(lines));
    for(const auto& line : lines)
      for(const Point& p : line)
        CHECK_NEAR(sites[nearest(p)].distance(p), value, 1e-11 * size);
    const bool is_below = std::all_of(sites.begin(), sites.end(), [&](const Site& s) { return value < s.offset; });
    CHECK_EQUAL(lines.empty(), is_below);
  }
  return number;
}

void parallel_segments()
{
  const test_support::Scope scope("parallel segments");
  const Mesh tm = to_face_graph(flat_patch(9, 9, .3, true, 1));
  const std::vector<Site> sites{{{Point(1.3, 2.1, 0), Point(7.8, 2.1, 0)}, .5},
                                {{Point(1.3, 6.4, 0), Point(7.8, 6.4, 0)}, 1.25}};
  const auto number = check_in_plane(tm, sites, 9);
  CHECK(number[0] > 150 && number[1] > 80);
  // A curve whose offset is so large that the others are nearer everywhere: paths cross it, also at its corners.
  std::vector<Site> three = sites;
  three.push_back({{Point(1, 3, 0), Point(3, 4.5, 0), Point(5, 3.25, 0), Point(8, 4, 0)}, 20.});
  const auto number_of_three = check_in_plane(tm, three, 9);
  CHECK(number_of_three[0] == number[0] && number_of_three[1] == number[1] && number_of_three[2] == 0);
}

// Rays from a point through the corners of curves with larger offsets: the paths run through the corners.
void paths_through_corners()
{
  const test_support::Scope scope("corners");
  const Mesh tm = to_face_graph(flat_patch(6, 6, .3, true, 3));
  const Point center(3.1, 2.9, 0);
  std::vector<Site> sites{{{center}, .25}};
  std::vector<Point> corners;
  for(int k = 0; k < 7; ++k)
    corners.push_back(Point(3.1 + 1.2 * std::cos(.9 * k), 2.9 + 1.2 * std::sin(.9 * k), 0));
  sites.push_back({corners, 7.});
  check_in_plane(tm, sites, 6);
  Paths paths(tm);
  for(const Site& s : sites)
    paths.add_source_curve(curve_in_plane(tm, s.polyline), s.offset);
  for(const Point& c : corners)
  {
    const Point behind = c + .8 * (c - center);
    const Location l = location_in_plane(behind.x(), behind.y(), tm);
    std::vector<Point> points;
    paths.shortest_path_points_to_source_points(l.first, in_traits(l.second), std::back_inserter(points));
    CHECK_NEAR(distance_in_space(points.back(), center), 0., 1e-12);
    for(std::size_t m = 1; m < points.size(); ++m)
      CHECK(distance_in_space(points[m], center) <= distance_in_space(points[m - 1], center) + 1e-12);
  }
}

// A polygon that is nearly a circle, and its center as a point with an offset.
void circle_and_center()
{
  const test_support::Scope scope("circle");
  const Mesh tm = to_face_graph(flat_patch(8, 8, .3, true, 2));
  std::vector<Point> circle;
  for(int k = 0; k <= 24; ++k)
    circle.push_back(Point(4.05 + 2.5 * std::cos(k * CGAL_PI / 12), 3.95 + 2.5 * std::sin(k * CGAL_PI / 12), 0));
  const auto number = check_in_plane(tm, {{circle, .7}, {{Point(4.05, 3.95, 0)}, .3}}, 8);
  CHECK(number[0] > 200 && number[1] > 15);
}

// --- surfaces ---

// The distances of the free function, bit by bit, and lengths of paths without the offsets.
void check_on_surface(const Mesh& tm, const std::vector<Curve>& curves, const std::vector<double>& offsets)
{
  const double size = size_of(tm);
  std::map<vertex_descriptor, double> expected;
  std::map<vertex_descriptor, std::size_t> nearest;
  try
  {
    SMG::geodesic_distances(tm, boost::make_assoc_property_map(expected), curves,
                            CGAL::parameters::source_offsets(offsets)
                              .nearest_source_map(boost::make_assoc_property_map(nearest)));
  }
  catch(const Invalid_geodesic_input& error)
  {
    CHECK(error.reason() == Invalid_geodesic_input::Reason::INVALID_CURVE);
    return;
  }
  Paths paths(tm);
  for(std::size_t i = 0; i < curves.size(); ++i)
    paths.add_source_curve(curves[i], offsets[i]);
  for(const vertex_descriptor v : vertices(tm))
  {
    std::vector<Point> points;
    const auto found = paths.shortest_path_points_to_source_points(v, std::back_inserter(points));
    if(found.first < 0)
    {
      CHECK(expected[v] == std::numeric_limits<double>::infinity());
      continue;
    }
    CHECK_EQUAL(found.first, expected[v]);
    CHECK_EQUAL(paths.nearest_source_point(v), nearest[v]);
    double length = offsets[nearest[v]];
    for(std::size_t m = 1; m < points.size(); ++m)
      length += distance_in_space(points[m - 1], points[m]);
    CHECK_NEAR(length, found.first, 1e-12 * (size + found.first));
    const auto end = paths.nearest_location_of_sources(v);
    CHECK_NEAR(distance_in_space(points.back(), paths.point(end.first, end.second)), 0., 1e-12 * size);
  }
}

void surfaces()
{
  for(std::uint64_t seed = 1; seed <= 160; ++seed)
  {
    const test_support::Scope scope("surface " + std::to_string(seed));
    test_support::Random random(seed);
    Mesh tm;
    if(seed % 10 == 0)
      tm = to_face_graph(noisy_sphere(3, .1, seed));
    else if(!hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), tm))
      continue;
    const std::vector<Curve> curves = random_curves(tm, random);
    std::vector<double> offsets;
    for(std::size_t i = 0; i < curves.size(); ++i)
      offsets.push_back(random.index(3) == 0 ? 0. : random.uniform() * size_of(tm) * (random.index(4) == 0 ? 3 : .3));
    check_on_surface(tm, curves, offsets);
  }
}

// --- the interface ---

void interface()
{
  const test_support::Scope scope("interface");
  const Mesh tm = to_face_graph(icosphere(2));
  test_support::Random random(3);
  const Curve curve(tm, random_vertices_along_edges(tm, 5, random));
  Paths with_zero(tm), without(tm), mixed(tm);
  with_zero.add_source_curve(curve, 0);
  without.add_source_curve(curve);
  for(const vertex_descriptor v : vertices(tm))
    CHECK_EQUAL(with_zero.shortest_distance_to_source_points(v).first,
                without.shortest_distance_to_source_points(v).first);
  // Points beside curves have no offset, whatever the curves have.
  const vertex_descriptor v = *std::next(vertices(tm).begin(), 40);
  mixed.add_source_point(v);
  const auto it = mixed.add_source_curve(curve, .75);
  std::map<vertex_descriptor, double> d;
  SMG::geodesic_distances(tm, boost::make_assoc_property_map(d), std::vector<Curve>{Curve(tm, std::vector{v}), curve},
                          CGAL::parameters::source_offsets(std::vector<double>{0, .75}));
  bool are_met[2] = {false, false};
  for(const vertex_descriptor u : vertices(tm))
  {
    CHECK_EQUAL(mixed.shortest_distance_to_source_points(u).first, d[u]);
    are_met[mixed.nearest_source_point(u)] = true;
  }
  CHECK(are_met[0] && are_met[1]);
  // Offsets that are no numbers are rejected at once, and nothing changes.
  for(const double bad : {-1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK(throws<Invalid_geodesic_input>([&] { mixed.add_source_curve(curve, bad); }));
  CHECK_EQUAL(mixed.number_of_source_points(), std::size_t(2));
  CHECK_EQUAL(mixed.shortest_distance_to_source_points(v).first, 0.);
  mixed.remove_source_point(it);
  CHECK(mixed.shortest_distance_to_source_points(*vertices(tm).begin()).first > .75);
}

} // namespace

int main()
{
  parallel_segments();
  paths_through_corners();
  circle_and_center();
  surfaces();
  interface();
  return test_result();
}
