// Curves that other results give: isolines by polyline_curve(), arcs and boundaries of cells by their locations. Points
// beside the surface; wrong input.

#include "curve_cases.h"
#include "curves_in_plane.h"
#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_isolines.h>
#include <CGAL/Surface_mesh_geodesics/polyline_curve.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
using SMG::Invalid_geodesic_input;

namespace {

using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;
using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
using Point = Kernel::Point_3;
using Polyline = std::vector<Point>;

double length_of(const Polyline& line)
{
  double length = 0;
  for(std::size_t i = 0; i + 1 < line.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(line[i], line[i + 1]));
  return length;
}

// Is a polygon of the plane on the left of its sides?
bool is_counterclockwise(const Polyline& line)
{
  double area = 0;
  for(std::size_t i = 0; i + 1 < line.size(); ++i)
    area += line[i].x() * line[i + 1].y() - line[i].y() * line[i + 1].x();
  return area > 0;
}

double distance_to_line(const Point_2& p, const Polyline& line)
{
  double nearest = infinity;
  for(std::size_t i = 0; i + 1 < line.size(); ++i)
    nearest = (std::min)(nearest, distance_to_segment(p, Point_2{line[i].x(), line[i].y()},
                                                      Point_2{line[i + 1].x(), line[i + 1].y()}));
  return nearest;
}

// The line at the distance h from the border of a square is a square, less corners inside faces. Its points lie on
// edges, up to rounding.
void offsets_of_a_square(std::size_t n, double h)
{
  const Mesh tm = to_face_graph(flat_patch(n, n, .3, true, n));
  const double low = h, high = static_cast<double>(n) - h;
  Paths paths(tm);
  for(const Curve& c : SMG::border_curves(tm))
    paths.add_source_curve(c);
  std::vector<Polyline> lines;
  paths.isolines(h, std::back_inserter(lines));
  if(!CHECK_EQUAL(lines.size(), std::size_t(1)))
    return;
  const Curve curve = SMG::polyline_curve(tm, lines[0]);
  CHECK(curve.is_closed());
  CHECK_CLOSE(curve.length(tm), length_of(lines[0]), 1e-12);
  // (The curve cuts the corners of the square.)
  CHECK(curve.length(tm) <= 4 * (high - low) + 1e-12 && curve.length(tm) > 4 * (high - low) - 2);
  const double cut = 1.5; // no corner is cut so far away from it
  Distances with_sign;
  SMG::signed_geodesic_distances(tm, boost::make_assoc_property_map(with_sign), curve);
  for(const vertex_descriptor v : vertices(tm))
  {
    const Point_2 p = in_plane(tm, v);
    const bool is_inside = low < p[0] && p[0] < high && low < p[1] && p[1] < high;
    CHECK_NEAR(std::abs(with_sign.at(v)), distance_to_line(p, lines[0]), 1e-12);
    const double to_corner = std::hypot((std::min)(std::abs(p[0] - low), std::abs(p[0] - high)),
                                        (std::min)(std::abs(p[1] - low), std::abs(p[1] - high)));
    CHECK(std::abs(with_sign.at(v)) < 1e-12 || to_corner < cut
          || (with_sign.at(v) < 0) == (is_inside == is_counterclockwise(lines[0])));
  }
}

// Far from the origin, points of lines are beside their edges by rounding; they count as points of the edges.
void lines_far_from_the_origin()
{
  for(const double away : {30., 1e3})
  {
    const Mesh tm = to_face_graph(transformed(flat_patch(9, 9, .3, true, 2), "away", [&](const auto& p)
    { return std::array<double, 3>{p[0] + away, p[1] - away, p[2] + away}; }));
    std::vector<std::pair<std::size_t, Polyline>> lines;
    SMG::geodesic_isolines(tm, *vertices(tm).begin(), std::vector<double>{2., 5.5, 8.25}, std::back_inserter(lines));
    CHECK_EQUAL(lines.size(), std::size_t(3));
    for(const auto& line : lines)
    {
      const Curve curve = SMG::polyline_curve(tm, line.second);
      CHECK_EQUAL(curve.segments().size(), line.second.size() - 1);
      CHECK_NEAR(curve.length(tm), length_of(line.second), 1e-15 * away * static_cast<double>(line.second.size()));
    }
  }
}

// A point above a region to avoid moves to its rim.
void regions_to_avoid()
{
  const Mesh tm = to_face_graph(flat_patch(6, 6, 0., false, 1));
  std::vector<face_descriptor> avoided;
  for(const face_descriptor f : faces(tm))
  {
    const Point_2 p = in_plane(tm, source(halfedge(f, tm), tm)), q = in_plane(tm, target(halfedge(f, tm), tm));
    const Point_2 r = in_plane(tm, target(next(halfedge(f, tm), tm), tm));
    if((std::min)({p[0], q[0], r[0]}) >= 2 && (std::max)({p[0], q[0], r[0]}) <= 4)
      avoided.push_back(f);
  }
  CHECK_EQUAL(avoided.size(), std::size_t(24));
  const Polyline line{Point(0, 3, 1), Point(2.25, 3, 1)};
  CHECK_CLOSE(SMG::polyline_curve(tm, line).length(tm), 2.25, 1e-12);
  CHECK_CLOSE(SMG::polyline_curve(tm, line, CGAL::parameters::faces_to_avoid(avoided)).length(tm), 2., 1e-12);
  std::vector<face_descriptor> all;
  for(const face_descriptor f : faces(tm))
    all.push_back(f);
  CHECK(throws_reason(Invalid_geodesic_input::Reason::INVALID_CURVE,
                      [&] { SMG::polyline_curve(tm, line, CGAL::parameters::faces_to_avoid(all)); }));
}

// Isolines on a bumpy surface: the curve is the polyline.
void isolines_of_a_sphere()
{
  const Mesh tm = to_face_graph(noisy_sphere(3, .1, 5));
  std::vector<std::pair<std::size_t, Polyline>> lines;
  SMG::geodesic_isolines(tm, *vertices(tm).begin(), std::vector<double>{.3, .9, 1.6}, std::back_inserter(lines));
  CHECK(lines.size() >= 3);
  std::vector<Curve> curves;
  for(const auto& line : lines)
  {
    curves.push_back(SMG::polyline_curve(tm, line.second));
    CHECK(curves.back().is_closed());
    CHECK_CLOSE(curves.back().length(tm), length_of(line.second), 1e-12);
  }
  const Distances d = distances(tm, curves);
  for(const vertex_descriptor v : vertices(tm))
    CHECK(d.at(v) < infinity);
}

// The arcs between two sites of a square are its middle line; so is a part of the boundary of each cell.
void arcs_and_boundaries()
{
  const Mesh tm = to_face_graph(flat_patch(6, 6, .2, true, 3));
  Voronoi diagram(tm);
  for(const double x : {1., 4.})
  {
    const Location at = location_in_plane(x, 3, tm);
    diagram.add_site(Voronoi::Face_location(at.first, {at.second[0], at.second[1], at.second[2]}));
  }
  diagram.build();
  std::vector<Curve> arcs;
  for(const Voronoi::Arc& a : diagram.arcs())
  {
    arcs.emplace_back(tm, std::array<Voronoi::Face_location, 2>{a.point(0), a.point(1)});
  }
  const Distances from_arcs = distances(tm, arcs);
  for(const vertex_descriptor v : vertices(tm))
    CHECK_NEAR(from_arcs.at(v), std::abs(in_plane(tm, v)[0] - 2.5), 1e-12);

  std::vector<Curve> boundary;
  for(const auto& line : diagram.boundary_polylines(0))
    boundary.emplace_back(tm, line.locations, line.is_closed);
  CHECK_EQUAL(boundary.size(), std::size_t(1));
  CHECK(!boundary[0].is_closed()); // it ends at the border
  const Distances from_boundary = distances(tm, boundary);
  for(const vertex_descriptor v : vertices(tm))
  {
    const Point_2 p = in_plane(tm, v);
    CHECK_NEAR(from_boundary.at(v), std::abs(p[0] - 2.5), 1e-12);
  }
}

// Points above the surface move down; far neighbors are joined by shortest paths; so is one point.
void points_beside_the_surface()
{
  const Mesh tm = to_face_graph(flat_patch(5, 5, .2, true, 8));
  const Polyline line{Point(.5, 1, 3), Point(4.5, 1, -2), Point(2.5, 4, 1), Point(.5, 1, 3)};
  const Curve curve = SMG::polyline_curve(tm, line);
  CHECK(curve.is_closed());
  const double side = std::hypot(2., 3.);
  CHECK_CLOSE(curve.length(tm), 4 + 2 * side, 1e-12);
  const Polyline open(line.begin(), line.end() - 1);
  CHECK(!SMG::polyline_curve(tm, open).is_closed());
  CHECK_CLOSE(SMG::polyline_curve(tm, open).length(tm), 4 + side, 1e-12);
  const Curve point = SMG::polyline_curve(tm, Polyline(1, Point(2, 2, 7)));
  CHECK_EQUAL(point.length(tm), 0.);
  for(const auto& entry : distances(tm, {point}))
    CHECK_NEAR(entry.second, std::hypot(in_plane(tm, entry.first)[0] - 2, in_plane(tm, entry.first)[1] - 2), 1e-12);
}

void wrong_input_is_rejected()
{
  using R = Invalid_geodesic_input::Reason;
  const Mesh tm = to_face_graph(flat_patch(2, 2, 0., false, 1));
  const auto make = [](const Mesh& mesh, const Polyline& line)
  { return [&mesh, line] { SMG::polyline_curve(mesh, line); }; };
  CHECK(throws_reason(R::INVALID_CURVE, make(tm, Polyline())));
  const Mesh nothing;
  CHECK(throws_reason(R::INVALID_CURVE, make(nothing, Polyline(1, Point(0, 0, 0)))));
  Mesh quadrangle;
  const auto v = [&](double x, double y) { return quadrangle.add_vertex(Point(x, y, 0)); };
  quadrangle.add_face(v(0, 0), v(1, 0), v(1, 1), v(0, 1));
  CHECK(throws_reason(R::NOT_A_TRIANGLE, make(quadrangle, Polyline(1, Point(0, 0, 0)))));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const double x : {nan, infinity, 1e200})
    CHECK(throws_reason(R::NON_FINITE_POINT, make(tm, Polyline{Point(0, 0, 0), Point(x, 0, 0)})));
  Mesh without_place = tm;
  without_place.point(*vertices(tm).begin()) = Point(nan, 0, 0);
  CHECK(throws_reason(R::NON_FINITE_POINT, make(without_place, Polyline(1, Point(0, 0, 0)))));
}

} // namespace

int main()
{
  offsets_of_a_square(4, .75);
  offsets_of_a_square(7, 2.5);
  offsets_of_a_square(9, 1.);
  isolines_of_a_sphere();
  lines_far_from_the_origin();
  regions_to_avoid();
  arcs_and_boundaries();
  points_beside_the_surface();
  wrong_input_is_rejected();
  return test_result();
}
