#ifndef SURFACE_MESH_GEODESICS_CURVES_IN_PLANE_H
#define SURFACE_MESH_GEODESICS_CURVES_IN_PLANE_H

// Points and polygons of the plane, for meshes that lie in it, and a square of cells.

#include "curve_cases.h"
#include "test_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace curve_cases {

inline double square(double x) { return x * x; }

using Point_2 = std::array<double, 2>;

inline Point_2 in_plane(const Mesh& tm, vertex_descriptor v) { return {tm.point(v).x(), tm.point(v).y()}; }

// The point of the segment from a to b that is nearest to p.
inline Point_2 foot_on_segment(const Point_2& p, const Point_2& a, const Point_2& b)
{
  const double x = b[0] - a[0], y = b[1] - a[1], length = square(x) + square(y);
  const double t = length > 0 ? ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / length : 0;
  const double s = (std::min)(1., (std::max)(0., t));
  return {a[0] + s * x, a[1] + s * y};
}

inline double distance_to_segment(const Point_2& p, const Point_2& a, const Point_2& b)
{
  const Point_2 foot = foot_on_segment(p, a, b);
  return std::hypot(p[0] - foot[0], p[1] - foot[1]);
}

// A square of n x n cells with the corner at the origin, its vertices by their coordinates.
struct Square
{
  explicit Square(std::size_t n) : tm(to_face_graph(flat_patch(n, n, 0., true, 1))), size(static_cast<double>(n)) {}

  vertex_descriptor at(double x, double y) const
  {
    for(const vertex_descriptor v : vertices(tm))
      if(std::abs(tm.point(v).x() - x) < 1e-9 && std::abs(tm.point(v).y() - y) < 1e-9)
        return v;
    return Mesh::null_vertex();
  }

  // The curve through the vertices at points that are joined by edges.
  Curve line(const std::vector<Point_2>& points) const
  {
    std::vector<vertex_descriptor> result;
    for(const Point_2& p : points)
      result.push_back(at(p[0], p[1]));
    return Curve(tm, result);
  }

  // The curve through the vertices of a grid line, from one point to another at integer distance.
  Curve line(double x, double y, double to_x, double to_y) const
  {
    const double n = (std::max)(std::abs(to_x - x), std::abs(to_y - y));
    std::vector<Point_2> points;
    for(double i = 0; i <= n; ++i)
      points.push_back({x + i * (to_x - x) / n, y + i * (to_y - y) / n});
    return line(points);
  }

  Curve bottom() const { return line(0, 0, size, 0); }
  Curve top() const { return line(0, size, size, size); }
  Curve left() const { return line(0, 0, 0, size); }
  Curve right() const { return line(size, 0, size, size); }

  Mesh tm;
  double size;
};

// The locations where a segment of the plane begins and crosses edges, in its order. The mesh lies in the plane; the
// segment runs through none of its vertices.
inline void append_crossings(const Mesh& tm, const Point_2& a, const Point_2& b, std::vector<Location>& locations)
{
  std::vector<std::pair<double, Location>> crossings{{0., location_in_plane(a[0], a[1], tm)}};
  for(const auto e : edges(tm))
  {
    auto h = halfedge(e, tm);
    if(is_border(h, tm))
      h = opposite(h, tm);
    const Point_2 p = in_plane(tm, source(h, tm)), q = in_plane(tm, target(h, tm));
    const double x = b[0] - a[0], y = b[1] - a[1];
    const double at_p = x * (p[1] - a[1]) - y * (p[0] - a[0]), at_q = x * (q[1] - a[1]) - y * (q[0] - a[0]);
    if((at_p > 0) == (at_q > 0))
      continue;
    const double s = at_p / (at_p - at_q);
    const double t = ((p[0] + s * (q[0] - p[0]) - a[0]) * x + (p[1] + s * (q[1] - p[1]) - a[1]) * y)
                   / (square(x) + square(y));
    if(t <= 0 || t >= 1)
      continue;
    Location l(face(h, tm), {0, 0, 0});
    auto g = halfedge(l.first, tm);
    for(std::size_t i = 0; i < 3; ++i, g = next(g, tm))
    {
      if(g == h)
        l.second[i] = 1 - s;
      if(prev(g, tm) == h)
        l.second[i] = s;
    }
    crossings.emplace_back(t, l);
  }
  std::sort(crossings.begin(), crossings.end());
  for(const auto& c : crossings)
    locations.push_back(c.second);
}

// The straight curve from a to b.
inline std::vector<Location> segment_in_plane(const Mesh& tm, const Point_2& a, const Point_2& b)
{
  std::vector<Location> locations;
  append_crossings(tm, a, b, locations);
  locations.push_back(location_in_plane(b[0], b[1], tm));
  return locations;
}

} // namespace curve_cases

#endif // SURFACE_MESH_GEODESICS_CURVES_IN_PLANE_H
