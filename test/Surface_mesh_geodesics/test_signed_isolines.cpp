// Isolines of curves with a sign for each side: closed forms in the plane and on a tube, curves inside of a face,
// regions in regions, lines that are nearer to the curve than any vertex, and what is rejected.

#include "curve_cases.h"
#include "curves_in_plane.h"
#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
using Point = Mesh::Point;
using Lines = std::vector<std::vector<Point>>;

namespace {

Lines lines_at(const Paths& paths, double value)
{
  Lines lines;
  paths.signed_isolines(value, std::back_inserter(lines));
  return lines;
}

Curve polygon(const Mesh& tm, const std::vector<Point_2>& corners)
{
  std::vector<Location> locations;
  for(std::size_t i = 0; i < corners.size(); ++i)
    append_crossings(tm, corners[i], corners[(i + 1) % corners.size()], locations);
  return Curve(tm, locations, true);
}

// The lines on both sides are those of the distance without a sign, in their order: each is on one side.
void check_sides_are_all(const Paths& paths, double distance)
{
  Lines all, rest;
  paths.isolines(distance, std::back_inserter(all));
  const Lines negative = lines_at(paths, -distance), positive = lines_at(paths, distance);
  CHECK_EQUAL(negative.size() + positive.size(), all.size());
  std::size_t i = 0, j = 0;
  for(const std::vector<Point>& line : all)
    if(i < negative.size() && negative[i] == line)
      ++i;
    else
      CHECK(j < positive.size() && positive[j++] == line);
}

// Checks the lines of a signed distance, which signed_distance(point) tells, and returns their number.
template <typename Signed_distance>
std::size_t check_lines(const Paths& paths, double value, double tolerance, const Signed_distance& signed_distance)
{
  const Lines lines = lines_at(paths, value);
  for(const std::vector<Point>& line : lines)
    for(const Point& p : line)
      CHECK_NEAR(signed_distance(p), value, tolerance);
  check_sides_are_all(paths, std::abs(value));
  return lines.size();
}

// --- the plane ---

// Negative inside of the box, whose corners are a and b on a diagonal.
double distance_to_box(const Point& p, const Point_2& a, const Point_2& b)
{
  const double x = (std::max)({a[0] - p.x(), p.x() - b[0], 0.}), y = (std::max)({a[1] - p.y(), p.y() - b[1], 0.});
  return x > 0 || y > 0 ? std::hypot(x, y) : -(std::min)({p.x() - a[0], b[0] - p.x(), p.y() - a[1], b[1] - p.y()});
}

// The curve runs through faces. One line inside, a ring outside, and four arcs where the ring meets the border.
void square_in_square()
{
  test_support::Scope scope("square in a square");
  const double size = 9, a = 3.1, b = 6.1;
  const Mesh tm = to_face_graph(flat_patch(9, 9, .3, true, 1));
  const std::vector<Point_2> counterclockwise{{a, a}, {b, a}, {b, b}, {a, b}};
  Paths paths(tm);
  paths.add_source_curve(polygon(tm, counterclockwise));
  const auto closed_form = [&](const Point& p) { return distance_to_box(p, {a, a}, {b, b}); };
  for(const double d : {1e-9, 1e-4, .2, 1., 1.3})
  {
    CHECK_EQUAL(check_lines(paths, -d, 1e-11 * size, closed_form), std::size_t(1));
    CHECK_EQUAL(check_lines(paths, d, 1e-11 * size, closed_form), std::size_t(1));
  }
  CHECK_EQUAL(check_lines(paths, -1.6, 1e-11 * size, closed_form), std::size_t(0));
  CHECK_EQUAL(check_lines(paths, 3.3, 1e-11 * size, closed_form), std::size_t(4));
  // the other way round, the outside is on the left
  Paths clockwise(tm);
  clockwise.add_source_curve(polygon(tm, {counterclockwise.rbegin(), counterclockwise.rend()}));
  CHECK_EQUAL(check_lines(clockwise, 1., 1e-11 * size, [&](const Point& p) { return -closed_form(p); }),
              std::size_t(1));
  CHECK(lines_at(clockwise, -3.3).size() == 4);
}

// No vertex of the user is inside, and all lines on that side are within one face.
void box_in_face()
{
  test_support::Scope scope("box in a face");
  const Mesh tm = to_face_graph(flat_patch(1, 1, 0., false, 1));
  const Point_2 a{.5, .05}, b{.7, .25};
  std::vector<Location> corners;
  for(const Point_2& p : {a, Point_2{b[0], a[1]}, b, Point_2{a[0], b[1]}})
    corners.push_back(location_in_plane(p[0], p[1], tm));
  CHECK(corners[0].first == corners[2].first);
  Paths paths(tm);
  paths.add_source_curve(Curve(tm, corners, true));
  const auto closed_form = [&](const Point& p) { return distance_to_box(p, a, b); };
  for(const double d : {1e-6, .03, .09})
  {
    CHECK_EQUAL(check_lines(paths, -d, 1e-11, closed_form), std::size_t(1));
    CHECK_EQUAL(check_lines(paths, d, 1e-11, closed_form), std::size_t(1));
  }
}

// Triangles, one inside the other: negative in the ring between them only, and a point source there changes no side.
void ring_of_triangles()
{
  test_support::Scope scope("triangles");
  const Mesh tm = to_face_graph(flat_patch(9, 9, .3, true, 12));
  const std::vector<Point_2> outer{{.71, .83}, {8.13, 1.17}, {4.21, 8.09}}, inner{{3.3, 2.2}, {5.7, 2.4}, {4.1, 4.6}};
  const Point_2 dot{4., 6.};
  Paths paths(tm);
  for(const auto& triangle : {outer, inner})
    paths.add_source_curve(polygon(tm, triangle));
  const Location l = location_in_plane(dot[0], dot[1], tm);
  paths.add_source_point(l.first, {{l.second[0], l.second[1], l.second[2]}});
  const auto closed_form = [&](const Point& point)
  {
    const Point_2 p{point.x(), point.y()};
    double distance = std::hypot(p[0] - dot[0], p[1] - dot[1]);
    bool is_negative = true;
    for(const auto& t : {outer, inner})
    {
      bool is_inside = true;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Point_2 &a = t[i], &b = t[(i + 1) % 3];
        distance = (std::min)(distance, distance_to_segment(p, a, b));
        is_inside = is_inside && (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0;
      }
      is_negative = is_negative == is_inside;
    }
    return (is_negative ? 1 : -1) * distance;
  };
  for(const double d : {.05, .2})
  {
    // three lines and two, unless segments join them otherwise in a face that several of them cross
    CHECK(check_lines(paths, -d, 1e-10, closed_form) >= 2);
    CHECK(check_lines(paths, d, 1e-10, closed_form) >= 2);
  }
}

// --- a tube ---

// Around the tube along edges. Some levels are those of rings of edges, where the line is the ring.
void around_tube()
{
  test_support::Scope scope("tube");
  const std::size_t m = 12, n = 8;
  const double height = 4, z = 2;
  const Mesh tm = to_face_graph(prism_tube(m, n, 1., height));
  std::vector<vertex_descriptor> ring;
  for(const vertex_descriptor v : vertices(tm))
    if(tm.point(v).z() == z)
      ring.push_back(v); // in their order around the tube
  CHECK_EQUAL(ring.size(), m);
  Paths paths(tm);
  paths.add_source_curve(Curve(tm, ring, true));
  // counterclockwise as seen from above, the upper part of the tube is on the left
  const auto closed_form = [&](const Point& p) { return z - p.z(); };
  for(const double d : {1e-8, .3, .8, 1.77})
    for(const double value : {d, -d})
      CHECK_EQUAL(check_lines(paths, value, 1e-11, closed_form), std::size_t(1));
  for(const double d : {.5, 1., 1.5})
    for(const double value : {d, -d})
    {
      CHECK_EQUAL(check_lines(paths, value, 1e-11, closed_form), std::size_t(1));
      const auto lines = lines_at(paths, value);
      CHECK_EQUAL(lines.at(0).size(), m + 1); // the vertices of the ring
    }
  for(const double none : {0., -0., 2.5, -2.5, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()})
    CHECK(lines_at(paths, none).empty());
}

// --- what is rejected ---

void rejected()
{
  test_support::Scope scope("rejected");
  const Mesh tm = to_face_graph(prism_tube(12, 8, 1., 4.));
  Paths paths(tm);
  CHECK(lines_at(paths, 1.).empty()); // as isolines() without sources
  const auto is_rejected = [&](Reason reason)
  {
    Lines lines;
    const bool result = throws_reason(reason, [&] { paths.signed_isolines(.1, std::back_inserter(lines)); });
    return result && lines.empty();
  };
  std::vector<vertex_descriptor> upward, ring;
  for(const vertex_descriptor v : vertices(tm))
  {
    if(tm.point(v).y() == 0 && tm.point(v).x() > 0)
      upward.push_back(v);
    if(tm.point(v).z() == 2)
      ring.push_back(v);
  }
  paths.add_source_point(upward[0]);
  CHECK(is_rejected(Reason::INVALID_CURVE)); // no curve
  paths.add_source_curve(Curve(tm, upward));
  CHECK(is_rejected(Reason::INVALID_CURVE)); // from rim to rim, but the way around the tube joins both sides
  paths.remove_all_source_points();
  const auto with_offset = paths.add_source_curve(Curve(tm, ring, true), .25);
  CHECK(is_rejected(Reason::INVALID_OFFSET));
  paths.remove_source_point(with_offset);
  CHECK(lines_at(paths, 1.).empty()); // no sources again
  paths.add_source_curve(Curve(tm, ring, true));
  CHECK(lines_at(paths, .1).size() == 1);
}

} // namespace

int main()
{
  square_in_square();
  box_in_face();
  ring_of_triangles();
  around_tube();
  rejected();
  return test_result();
}
