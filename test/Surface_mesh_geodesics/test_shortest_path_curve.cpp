// Curves and shortest paths: shortest_path_curve() makes curves of paths, and paths lead to the nearest point of a
// curve.

#include "curve_cases.h"
#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>
#include <CGAL/Surface_mesh_geodesics/shortest_path_curve.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
using SMG::Invalid_geodesic_input;
using Point = Kernel::Point_3;

namespace {

Point point_of(const Mesh& tm, const Location& location)
{
  const auto h = halfedge(location.first, tm);
  const auto& b = location.second;
  return CGAL::barycenter(tm.point(source(h, tm)), b[0], tm.point(target(h, tm)), b[1],
                          tm.point(target(next(h, tm), tm)), b[2]);
}

Point point_of(const Mesh& tm, vertex_descriptor v) { return tm.point(v); }

double gap(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// Each segment begins where the one before ends; the curve begins and ends where it should, and passes all points. Its
// length is that of the paths.
template <typename Place>
void check_curve(const Mesh& tm, const std::vector<Place>& places, bool is_closed)
{
  const Curve curve = SMG::shortest_path_curve(tm, places, is_closed);
  CHECK_EQUAL(curve.is_closed(), is_closed && places.size() > 1);
  const auto& segments = curve.segments();
  const double size = extent(tm);
  double sum = 0;
  for(std::size_t i = 0; i + 1 < places.size() + (curve.is_closed() ? 1 : 0); ++i)
    sum += SMG::geodesic_distance(tm, places[i], places[(i + 1) % places.size()]);
  CHECK_NEAR(curve.length(tm), sum, 1e-12 * (sum + size));
  if(segments.empty())
    return;
  for(std::size_t i = 0; i + 1 < segments.size(); ++i)
    CHECK(gap(point_of(tm, curve.location(i, 1)), point_of(tm, curve.location(i + 1, 0))) <= 1e-12 * size);
  const Point first = point_of(tm, curve.location(0, 0)), last = point_of(tm, curve.location(segments.size() - 1, 1));
  CHECK(gap(first, point_of(tm, places.front())) <= 1e-12 * size);
  CHECK(gap(last, point_of(tm, is_closed ? places.front() : places.back())) <= 1e-12 * size);
  for(const Place& p : places)
  {
    double nearest = gap(first, point_of(tm, p));
    for(std::size_t i = 0; i < segments.size(); ++i)
      nearest = (std::min)(nearest, gap(point_of(tm, curve.location(i, 1)), point_of(tm, p)));
    CHECK(nearest <= 1e-12 * size);
  }
}

bool are_connected(const Mesh& tm, const std::vector<Location>& places)
{
  return std::all_of(places.begin(), places.end(), [&](const Location& p)
                     { return SMG::geodesic_distance(tm, places[0], p) < infinity; });
}

void curves_are_as_long_as_paths(const Indexed_mesh& indexed, test_support::Random& random)
{
  const test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  for(int k = 0; k < 6; ++k)
  {
    std::vector<Location> locations;
    std::vector<vertex_descriptor> corners;
    for(std::size_t i = 1 + random.index(5); i > 0; --i)
    {
      locations.emplace_back(random_location(tm, random).first, random_coordinates(random));
      const auto h = halfedge(locations.back().first, tm);
      corners.push_back(target(h, tm));
    }
    if(!are_connected(tm, locations))
      continue;
    check_curve(tm, locations, k % 2 == 0);
    check_curve(tm, corners, k % 2 == 0);
  }
}

// In the plane the curve is the polygon, and distances from it are those from its sides.
void polygons_in_the_plane()
{
  const Mesh tm = to_face_graph(flat_patch(9, 7, .3, true, 4));
  const std::vector<std::array<double, 2>> corners{{.5, .5}, {8.25, 1.75}, {4, 6.5}, {3.5, 2}};
  std::vector<Location> places;
  for(const auto& p : corners)
    places.push_back(location_in_plane(p[0], p[1], tm));
  const Curve curve = SMG::shortest_path_curve(tm, places, true);
  CHECK(curve.segments().size() > 20);
  const Distances d = distances(tm, {curve});
  Distances with_sign;
  SMG::signed_geodesic_distances(tm, boost::make_assoc_property_map(with_sign), curve);
  std::size_t number_inside = 0;
  for(const vertex_descriptor v : vertices(tm))
  {
    const Point& p = tm.point(v);
    double expected = infinity;
    bool is_inside = false;
    for(std::size_t i = 0; i < corners.size(); ++i)
    {
      const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
      const double x = b[0] - a[0], y = b[1] - a[1];
      const double t = ((p.x() - a[0]) * x + (p.y() - a[1]) * y) / (x * x + y * y);
      const double s = (std::min)(1., (std::max)(0., t));
      expected = (std::min)(expected, std::hypot(p.x() - a[0] - s * x, p.y() - a[1] - s * y));
      if((a[1] > p.y()) != (b[1] > p.y()) && p.x() < a[0] + x * (p.y() - a[1]) / y)
        is_inside = !is_inside;
    }
    number_inside += is_inside ? 1 : 0;
    CHECK_NEAR(d.at(v), expected, 1e-12);
    CHECK_EQUAL(with_sign.at(v), is_inside ? -d.at(v) : d.at(v)); // counterclockwise: the inside is on the left
  }
  CHECK(number_inside > 5);
}

template <typename Function>
bool throws_at(Invalid_geodesic_input::Reason reason, std::size_t position, Function function)
{
  try
  {
    function();
  }
  catch(const Invalid_geodesic_input& e)
  {
    return e.reason() == reason && e.element() == position;
  }
  return false;
}

void faces_are_avoided()
{
  const Mesh tm = to_face_graph(flat_patch(6, 6, 0, false, 1));
  std::vector<face_descriptor> middle;
  for(const face_descriptor f : faces(tm))
  {
    const Point p = point_of(tm, Location(f, {1. / 3, 1. / 3, 1. / 3}));
    if(p.x() > 2 && p.x() < 4 && p.y() > 2 && p.y() < 4)
      middle.push_back(f);
  }
  CHECK_EQUAL(middle.size(), std::size_t(8));
  const std::vector<Location> places{location_in_plane(.5, 3, tm), location_in_plane(5.5, 3, tm)};
  const auto np = CGAL::parameters::faces_to_avoid(middle);
  CHECK_CLOSE(SMG::shortest_path_curve(tm, places).length(tm), 5, 1e-12);
  const Curve around = SMG::shortest_path_curve(tm, places, false, np);
  CHECK_CLOSE(around.length(tm), 2 + 2 * std::hypot(1.5, 1), 1e-12);
  for(const Curve::Segment& s : around.segments())
    CHECK(std::find(middle.begin(), middle.end(), s.face) == middle.end());

  // One point three times.
  CHECK_EQUAL(SMG::shortest_path_curve(tm, std::vector<Location>(3, places[0]), true, np).length(tm), 0.);

  // Two points on the rim, which have faces to avoid in common.
  const std::vector<Location> on_rim{location_in_plane(2, 2, tm), location_in_plane(2.5, 2, tm)};
  const Curve along = SMG::shortest_path_curve(tm, on_rim, false, np);
  CHECK_CLOSE(along.length(tm), .5, 1e-12);
  for(const Curve::Segment& s : along.segments())
    CHECK(std::find(middle.begin(), middle.end(), s.face) == middle.end());

  // Two points on both sides of a corner of the rim. At two corners they have a face in common, which is avoided.
  std::size_t with_common_face = 0;
  for(const double x : {2., 4.})
    for(const double y : {2., 4.})
    {
      const std::vector<Location> at_corner{location_in_plane(3 + (x - 3) / 2, y, tm),
                                            location_in_plane(x, 3 + (y - 3) / 2, tm)};
      with_common_face += SMG::shortest_path_curve(tm, at_corner).segments().size() == 1 ? 1 : 0;
      CHECK_CLOSE(SMG::shortest_path_curve(tm, at_corner, false, np).length(tm), 1, 1e-12);
    }
  CHECK_EQUAL(with_common_face, std::size_t(2));
}

// Wherever a point inside of the faces to avoid is in the range, its position is told, and no path is computed.
// Vertices, and points of edges and faces; a range of faces and a map.
void points_inside_of_faces_to_avoid_are_rejected()
{
  const auto reason = Invalid_geodesic_input::Reason::INVALID_CURVE;
  const Mesh tm = to_face_graph(flat_patch(6, 6, 0, false, 1));
  std::map<face_descriptor, bool> is_avoided;
  std::vector<face_descriptor> avoided;
  for(const face_descriptor f : faces(tm))
  {
    const Point p = point_of(tm, Location(f, {1. / 3, 1. / 3, 1. / 3}));
    is_avoided[f] = p.x() > 2 && p.x() < 4 && p.y() > 2 && p.y() < 4;
    if(is_avoided[f])
      avoided.push_back(f);
  }
  SMG::Propagation_statistics statistics;
  const auto np = CGAL::parameters::faces_to_avoid(avoided).statistics(&statistics);
  const auto map = CGAL::parameters::faces_to_avoid(boost::make_assoc_property_map(is_avoided));
  const auto check = [&](const auto& places, std::size_t position)
  {
    CHECK(throws_at(reason, position, [&] { SMG::shortest_path_curve(tm, places, false, np); }));
    CHECK(throws_at(reason, position, [&] { SMG::shortest_path_curve(tm, places, true, map); }));
  };
  const auto at = [&](double x, double y) { return location_in_plane(x, y, tm); };
  for(const Location& inside : {at(2.25, 3.5), at(3, 2.5), at(3, 3)})
  {
    check(std::vector<Location>{at(1, .25), at(5, 5.5), inside}, 2);
    check(std::vector<Location>{at(1, .25), inside, at(5, 5.5)}, 1);
    check(std::vector<Location>{inside, at(1, .25), at(5, 5.5)}, 0);
    check(std::vector<Location>{inside}, 0);
    check(std::vector<Location>(2, inside), 0);
  }
  const auto vertex = [&](double x, double y)
  {
    return *std::find_if(vertices(tm).begin(), vertices(tm).end(),
                         [&](vertex_descriptor v) { return tm.point(v) == Point(x, y, 0); });
  };
  check(std::vector<vertex_descriptor>{vertex(0, 1), vertex(2, 2), vertex(3, 3)}, 2);
  check(std::vector<vertex_descriptor>{vertex(0, 1), vertex(3, 3), vertex(5, 5)}, 1);
  check(std::vector<vertex_descriptor>{vertex(3, 3), vertex(2, 3), vertex(5, 5)}, 0);
  CHECK_EQUAL(statistics.windows_created, std::size_t(0));
  // Points of the rim are not inside, and a face to avoid that is none of the mesh has its own position.
  CHECK_CLOSE(SMG::shortest_path_curve(tm, std::vector<Location>{at(2, 2.5), at(2, 3.5)}, false, np).length(tm), 1,
              1e-12);
  CHECK_EQUAL(SMG::shortest_path_curve(tm, std::vector<Location>{at(2, 2.5)}, false, np).length(tm), 0.);
  avoided.push_back(face_descriptor(12345));
  CHECK(throws_at(Invalid_geodesic_input::Reason::INVALID_DESCRIPTOR, avoided.size() - 1, [&] {
    SMG::shortest_path_curve(tm, std::vector<Location>{at(3, 3)}, false, CGAL::parameters::faces_to_avoid(avoided));
  }));
}

void wrong_input_is_rejected()
{
  using R = Invalid_geodesic_input::Reason;
  const Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  std::vector<vertex_descriptor> one_of_each, isolated;
  for(const vertex_descriptor v : vertices(tm))
    if(tm.is_isolated(v))
      isolated.push_back(v);
    else if(one_of_each.empty() || !(SMG::geodesic_distance(tm, one_of_each[0], v) < infinity))
      one_of_each.push_back(v);
  one_of_each.insert(one_of_each.begin(), one_of_each[0]);
  CHECK(one_of_each.size() > 2);
  CHECK(throws_at(R::INVALID_CURVE, 1, [&] { SMG::shortest_path_curve(tm, one_of_each); }));
  CHECK_EQUAL(isolated.size(), std::size_t(1));
  CHECK(SMG::shortest_path_curve(tm, isolated).vertex() == isolated[0]);
  CHECK(SMG::shortest_path_curve(tm, std::vector<vertex_descriptor>(3, isolated[0])).vertex() == isolated[0]);
  isolated.insert(isolated.begin(), one_of_each[0]);
  CHECK(throws_at(R::INVALID_CURVE, 0, [&] { SMG::shortest_path_curve(tm, isolated); }));
  CHECK(throws_reason(R::INVALID_CURVE,
                      [&] { SMG::shortest_path_curve(tm, std::vector<vertex_descriptor>()); }));
  const face_descriptor f = *faces(tm).begin();
  const std::vector<Location> outside{Location(f, {1, 0, 0}), Location(f, {2, -1, 0})};
  CHECK(throws_at(R::INVALID_CURVE, 1, [&] { SMG::shortest_path_curve(tm, outside); }));
  // Elements that the mesh does not have.
  const std::vector<vertex_descriptor> beyond{one_of_each[0], vertex_descriptor(12345)};
  CHECK(throws_at(R::INVALID_CURVE, 1, [&] { SMG::shortest_path_curve(tm, beyond); }));
  const std::vector<Location> in_no_face{Location(face_descriptor(12345), {1, 0, 0})};
  CHECK(throws_at(R::INVALID_CURVE, 0, [&] { SMG::shortest_path_curve(tm, in_no_face); }));
}

// Only pairs without a common face cost a propagation.
void straight_parts_cost_no_propagation()
{
  const Mesh tm = to_face_graph(icosphere(3));
  CGAL::Surface_mesh_geodesics::Propagation_statistics statistics;
  const auto np = CGAL::parameters::statistics(&statistics);
  const auto h = halfedge(*faces(tm).begin(), tm);
  std::vector<vertex_descriptor> triangle{source(h, tm), target(h, tm), target(next(h, tm), tm)};
  CHECK_EQUAL(SMG::shortest_path_curve(tm, triangle, true, np).segments().size(), std::size_t(3));
  CHECK_EQUAL(statistics.windows_created, std::size_t(0));
  triangle.push_back(target(next(opposite(next(opposite(next(h, tm), tm), tm), tm), tm), tm));
  SMG::shortest_path_curve(tm, triangle, false, np);
  CHECK(statistics.windows_created > 0);
}

// The way to get a path to a curve: one to the nearest point. It has the length of the distance, and ends there at a
// right angle. Returns how many paths end inside a segment.
std::size_t paths_end_at_right_angles(const Indexed_mesh& indexed, test_support::Random& random)
{
  const test_support::Scope scope("feet: " + indexed.name);
  const Mesh tm = to_face_graph(indexed);
  std::vector<Location> places;
  for(int i = 0; i < 4; ++i)
    places.emplace_back(random_location(tm, random).first, std::array<double, 3>{.5, .25, .25});
  if(!are_connected(tm, places))
    return 0;
  const std::vector<Curve> curves{SMG::shortest_path_curve(tm, places)};
  SMG::Geodesic_distance_solver<Mesh> solver(tm);
  solver.compute_distances(curves);
  std::size_t result = 0;
  for(int k = 0; k < 12; ++k)
  {
    const vertex_descriptor v = random_vertex(tm, random);
    const SMG::Surface_curve_point p = solver.nearest_curve_point(v);
    if(p.curve != 0)
      continue; // in another component
    std::vector<Point> path;
    const double d = SMG::geodesic_path(tm, v, curves[0].location(p.segment, p.parameter), std::back_inserter(path));
    const double tolerance = 1e-12 * (d + extent(tm));
    CHECK_NEAR(d, solver.distance(v), tolerance);
    double length = 0;
    for(std::size_t i = 1; i < path.size(); ++i)
      length += gap(path[i - 1], path[i]);
    CHECK_NEAR(length, d, tolerance);
    CHECK(gap(path.back(), point_of(tm, curves[0].location(p.segment, p.parameter))) <= tolerance);
    if(path.size() < 2 || p.parameter < .05 || p.parameter > .95)
      continue;
    const auto last = path.back() - path[path.size() - 2];
    const auto along = point_of(tm, curves[0].location(p.segment, 1)) - point_of(tm, curves[0].location(p.segment, 0));
    const double lengths = std::sqrt(last.squared_length() * along.squared_length());
    if(!(lengths > 1e-4 * extent(tm) * extent(tm)))
      continue; // rounding turns short pieces
    CHECK_NEAR(last * along / lengths, 0, 1e-7);
    ++result;
  }
  return result;
}

} // namespace

int main()
{
  test_support::Random random(31);
  for(const Indexed_mesh& mesh : small_collection(7))
    curves_are_as_long_as_paths(mesh, random);
  polygons_in_the_plane();
  faces_are_avoided();
  points_inside_of_faces_to_avoid_are_rejected();
  wrong_input_is_rejected();
  straight_parts_cost_no_propagation();
  std::size_t right_angles = 0;
  for(const Indexed_mesh& mesh : small_collection(7))
    right_angles += paths_end_at_right_angles(mesh, random);
  CHECK(right_angles > 50);
  return test_result();
}
