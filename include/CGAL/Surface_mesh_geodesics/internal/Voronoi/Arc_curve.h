// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_ARC_CURVE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_ARC_CURVE_H

// An arc of the diagram as a parametric curve over [0, 1], its length, and the integrals along it from which areas and
// centroids are computed.
//
// Frame: the layout of the arc's face. Error: integrals are exact up to Tolerance::quadrature() of those over the
// chord.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/arcs_and_nodes.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Integrals along a part of the border of a region that is on its left. Summed over the whole border, they are the area
// and the integrals of x and y over the region (Green's theorem):
//   area = 1/2 of the integral of (x dy - y dx), and 1/3 of the integrals of x (x dy - y dx) and y (x dy - y dx).
struct Border_integrals
{
  double area = 0, x = 0, y = 0;

  void add(const Border_integrals& other, double factor = 1)
  {
    area += factor * other.area;
    x += factor * other.x;
    y += factor * other.y;
  }
};

// Returns the integrals along the segment from p to q, where x dy - y dx is constant: the cross product of p and q,
// times the differential of a parameter that runs from 0 to 1.
inline Border_integrals segment_integrals(const Planar_point<double>& p, const Planar_point<double>& q)
{
  const double cross = p.x * q.y - p.y * q.x;
  return Border_integrals{cross / 2, cross * (p.x + q.x) / 6, cross * (p.y + q.y) / 6};
}

// The same for the integrals of x^2, xy and y^2: 1/4 of the integrals of these times (x dy - y dx).
struct Second_integrals
{
  double xx = 0, xy = 0, yy = 0;

  void add(const Second_integrals& other, double factor = 1)
  {
    xx += factor * other.xx;
    xy += factor * other.xy;
    yy += factor * other.yy;
  }
};

inline Second_integrals second_segment_integrals(const Planar_point<double>& p, const Planar_point<double>& q)
{
  const double cross = (p.x * q.y - p.y * q.x) / 12;
  return Second_integrals{cross * (p.x * p.x + p.x * q.x + q.x * q.x),
                          cross * (p.x * p.y + (p.x * q.y + q.x * p.y) / 2 + q.x * q.y),
                          cross * (p.y * p.y + p.y * q.y + q.y * q.y)};
}

// A part of a bisector from its first to its last point, or a segment. Face_partition decides which one an arc is
// meant to be; the constructor may still choose the segment, where rounding hides the bisector.
//
// Requires: the ends of the arc are on the bisector of its images up to rounding, if the arc says that it is a
// bisector.
class Arc_curve
{
public:
  using Point = Planar_point<double>;
  using Arc = Voronoi_arc<double>;

  // The curve is the segment between the ends of the arc if the arc is straight up to rounding: it is not a bisector,
  // both weights are equal (of points), both points are at infinity, or the bisector does not lead from one end to the
  // other. The arc is not referred to afterwards.
  explicit Arc_curve(const Arc& a)
    : m_first(a.first), m_last(a.last), m_curve(a.left, a.right, a.first)
  {
    using std::abs;
    const double d = a.left.distance_to(a.first);
    const bool are_points = !a.left.is_at_infinity() && !a.right.is_at_infinity();
    m_is_segment = !a.is_bisector || !m_curve.is_curved()
                || (are_points && abs(a.left.weight - a.right.weight) <= Tolerance<double>::curvature() * d);
    m_end = m_is_segment ? 0 : m_curve.angle_near(a.last);
    m_is_segment = m_is_segment || !(m_end > 0) || !is_better_than_segment(a);
  }

  bool is_segment() const { return m_is_segment; }

  // Returns the point at parameter t: exactly the ends of the arc at 0 and 1, and outside of [0, 1]. Parameters are
  // proportional to the angle at the focus (Weighted_bisector), not to the length.
  Point point(double t) const
  {
    if(t <= 0)
      return m_first;
    if(t >= 1)
      return m_last;
    if(!m_is_segment)
      return m_curve.point_at_angle(t * m_end);
    return point_of_segment(t);
  }

  // Returns the length of the arc: the integral of |dp| over the angle.
  double length() const
  {
    if(m_is_segment)
      return distance(m_first, m_last);
    return integrals_of<1>([](const Point&, const Point& d) { return Values<1>{norm(d.x, d.y)}; },
                           {distance(m_first, m_last)})[0];
  }

  // Returns the integrals over the region between the arc and its chord, relative to the first point; zero for a
  // segment. Nothing is lost where the arc is short, since with that origin x dy - y dx vanishes along the chord, and
  // the integrals along the curve alone are those over the region.
  Border_integrals bulge() const
  {
    if(m_is_segment)
      return Border_integrals();
    const double chord = distance(m_first, m_last);
    const Values<3> moments = integrals_of<3>([this](const Point& p, const Point& d)
    {
      const double x = p.x - m_first.x, y = p.y - m_first.y, cross = x * d.y - y * d.x;
      return Values<3>{0.5 * cross, x / 3 * cross, y / 3 * cross};
    }, {chord * chord, chord * chord * chord, chord * chord * chord});
    return Border_integrals{moments[0], moments[1], moments[2]};
  }

  // Returns the integrals along the arc relative to `origin`: those of the chord, plus the bulge, which is bulge(). A
  // shift of the origin adds the area times the first point to the integrals of x and y.
  Border_integrals integrals(const Border_integrals& bulge, const Point& origin) const
  {
    const Point first{m_first.x - origin.x, m_first.y - origin.y}, last{m_last.x - origin.x, m_last.y - origin.y};
    Border_integrals result = segment_integrals(first, last);
    result.area += bulge.area;
    result.x += bulge.x + bulge.area * first.x;
    result.y += bulge.y + bulge.area * first.y;
    return result;
  }

  // Returns the integrals of x^2, xy and y^2 along the arc.
  Second_integrals second_integrals() const
  {
    if(m_is_segment)
      return second_segment_integrals(m_first, m_last);
    const double size = norm(m_first.x, m_first.y) + distance(m_first, m_last), scale = size * size * size * size;
    const Values<3> moments = integrals_of<3>([](const Point& p, const Point& d)
    {
      const double cross = (p.x * d.y - p.y * d.x) / 4;
      return Values<3>{p.x * p.x * cross, p.x * p.y * cross, p.y * p.y * cross};
    }, {scale, scale, scale});
    return Second_integrals{moments[0], moments[1], moments[2]};
  }

  // Calls visit(point) for points of the curve in their order, without the first point and including the last one. The
  // segments between them are at most `tolerance` away from the curve, unless `number_of_halvings` do not suffice. A
  // segment has its last point only.
  template <typename Visit>
  void sample(double tolerance, Visit visit, int number_of_halvings = 24) const
  {
    if(!m_is_segment)
      refine(0, 1, m_first, m_last, tolerance, number_of_halvings, visit);
    visit(m_last);
  }

private:
  // Returns whether the curve is closer than the segment to the points of equal distance. Where the two images are so
  // close to each other that rounding moves the curve as a whole, the curve may miss the last point of the arc. Three
  // points of both are compared only if it does; a curve that leaves the surroundings of the arc is not better. Ties:
  // the segment, if the difference of its distances is rounding; it leads to the last point.
  bool is_better_than_segment(const Arc& a) const
  {
    const double chord = distance(m_first, m_last);
    if(distance(m_curve.point_at_angle(m_end), m_last) <= Tolerance<double>::touching() * chord)
      return true;
    const double rounding = Tolerance<double>::tie() * a.left.distance_to(m_first);
    double of_curve = 0, of_segment = 0;
    for(const double t : {0.125, 0.5, 0.875})
    {
      const Point on_curve = m_curve.point_at_angle(t * m_end), on_segment = point_of_segment(t);
      if(!(distance(m_first, on_curve) <= 2 * chord))
        return false;
      of_curve = (std::max)(of_curve, std::abs(a.left.distance_to(on_curve) - a.right.distance_to(on_curve)));
      of_segment = (std::max)(of_segment,
                              std::abs(a.left.distance_to(on_segment) - a.right.distance_to(on_segment)));
    }
    return of_curve < of_segment && of_segment > rounding;
  }

  Point point_of_segment(double t) const
  {
    return Point{m_first.x + t * (m_last.x - m_first.x), m_first.y + t * (m_last.y - m_first.y)};
  }

  // Several integrands, which are computed together (the curve is evaluated once for all), or their integrals.
  template <std::size_t n>
  using Values = std::array<double, n>;

  // Returns the integrals over the curve of f(point, derivative by the angle). Intervals are halved until the sums
  // change by at most Tolerance::quadrature() of `scale`; a relative criterion would fail where f is only rounding.
  // Each integral keeps the value at which it stops changing. After 1024 parts the last sums are returned as they are.
  // So the curve is evaluated at 7 * 2047 points at most.
  // Requires: the curve is not a segment.
  template <std::size_t n, typename Function>
  Values<n> integrals_of(Function f, const Values<n>& scale) const
  {
    Values<n> result{};
    std::array<bool, n> is_known{};
    for(int parts = 1; parts <= 1024; parts *= 2)
    {
      Values<n> sum{};
      for(int i = 0; i < parts; ++i)
        add_Gauss_sums(f, m_end * i / parts, m_end * (i + 1) / parts, sum);
      bool are_all_known = parts > 1;
      for(std::size_t k = 0; k < n; ++k)
      {
        if(is_known[k])
          continue;
        is_known[k] = parts > 1 && std::abs(sum[k] - result[k]) <= Tolerance<double>::quadrature() * scale[k];
        result[k] = sum[k];
        are_all_known = are_all_known && is_known[k];
      }
      if(are_all_known)
        break;
    }
    return result;
  }

  // Adds the integrals from one angle to another by Gauss' formula with seven points, which is enough for most curves,
  // as they bend little. All values are computed together, since evaluating the curve is the expensive part.
  template <typename Function, std::size_t n>
  void add_Gauss_sums(Function f, double from, double to, Values<n>& sum) const
  {
    using Gauss = boost::math::quadrature::gauss<double, 7>;
    const double middle = (from + to) / 2, scale = (to - from) / 2;
    Values<n> part{};
    const auto add = [&](double weight, const Values<n>& a, const Values<n>& b)
    {
      for(std::size_t k = 0; k < n; ++k)
        part[k] += (a[k] + b[k]) * weight;
    };
    add(Gauss::weights()[0], values_at(f, middle), Values<n>{});
    for(std::size_t i = 1; i < Gauss::weights().size(); ++i)
      add(Gauss::weights()[i], values_at(f, middle + scale * Gauss::abscissa()[i]),
          values_at(f, middle - scale * Gauss::abscissa()[i]));
    for(std::size_t k = 0; k < n; ++k)
      sum[k] += scale * part[k];
  }

  // Returns f at an angle. The curve is parametrized by the tangent t of the angle, whose derivative is 1 + t^2.
  template <typename Function>
  auto values_at(Function f, double angle) const
  {
    const double t = std::tan(angle);
    const Point d = m_curve.derivative(t);
    return f(m_curve.point(t), Point{(1 + t * t) * d.x, (1 + t * t) * d.y});
  }

  // Visits points between the parameters t and u, at which the curve is at p and q: halves until the middle is close to
  // the chord, at most `depth` times. The ends are not visited, so that each point is visited once.
  template <typename Visit>
  void refine(double t, double u, const Point& p, const Point& q, double tolerance, int depth,
              Visit& visit) const
  {
    const double middle = (t + u) / 2;
    const Point m = point(middle);
    const Half_plane<double> side = Half_plane<double>::left_of(p, q);
    if(depth == 0 || 2 * std::abs(side(m)) <= tolerance) // the largest distance is less than twice that of m
      return;
    refine(t, middle, p, m, tolerance, depth - 1, visit);
    visit(m);
    refine(middle, u, m, q, tolerance, depth - 1, visit);
  }

  Point m_first, m_last;
  Weighted_bisector<double> m_curve; // starts at m_first; read only if m_is_segment is not set
  bool m_is_segment;
  double m_end = 0; // Weighted_bisector::angle() of the last point, positive unless m_is_segment is set
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_ARC_CURVE_H
