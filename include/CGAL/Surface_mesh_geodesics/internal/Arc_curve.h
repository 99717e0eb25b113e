// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_ARC_CURVE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_ARC_CURVE_H

// level: 5 (queries)
//
// The curve of an arc of the diagram as a function of a parameter from 0 to 1, its length, and the integrals
// along it that areas and centroids are made of.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/Weighted_bisector.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// For a region on the left of its border: integrated along the border they add up to the area, and to the
// integrals of x and y over the region.
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

// along the segment from p to q.
inline Border_integrals segment_integrals(const Planar_point<double>& p, const Planar_point<double>& q)
{
  const double cross = p.x * q.y - p.y * q.x;
  return Border_integrals{cross / 2, cross * (p.x + q.x) / 6, cross * (p.y + q.y) / 6};
}

class Arc_curve
{
public:
  using Point = Planar_point<double>;
  using Arc = Voronoi_arc<double>;

  explicit Arc_curve(const Arc& a)
    : m_first(a.first), m_last(a.last), m_curve(a.left, a.right, a.first)
  {
    using std::abs;
    const double d = a.left.distance_to(a.first);
    m_is_segment = !a.is_bisector || !m_curve.is_curved()
                || abs(a.left.weight - a.right.weight) <= 4 * Tolerance<double>::distance() * d;
    m_end = m_is_segment ? 0 : m_curve.angle(a.last);
    m_is_segment = m_is_segment || !(m_end > 0) || !is_better_than_segment(a);
  }

  bool is_segment() const { return m_is_segment; }

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

  double length() const
  {
    if(m_is_segment)
      return distance(m_first, m_last);
    return integral([this](double t)
    {
      const Point d = derivative(t);
      return norm(d.x, d.y);
    }, distance(m_first, m_last));
  }

  // All are taken from the first point, so that no digits are lost.
  Border_integrals integrals() const
  {
    if(m_is_segment)
      return segment_integrals(m_first, m_last);
    // the segment, and what is between it and the curve
    Border_integrals result = segment_integrals(m_first, m_last);
    const double chord = distance(m_first, m_last);
    const auto moment = [&](auto weight, double scale)
    {
      return integral([&](double t)
      {
        const Point p = m_curve.point_at_angle(t), d = derivative(t);
        const double x = p.x - m_first.x, y = p.y - m_first.y;
        return weight(x, y) * (x * d.y - y * d.x);
      }, scale);
    };
    const double area = moment([](double, double) { return 0.5; }, chord * chord);
    const double x = moment([](double px, double) { return px / 3; }, chord * chord * chord);
    const double y = moment([](double, double py) { return py / 3; }, chord * chord * chord);
    result.area += area;
    result.x += x + area * m_first.x;
    result.y += y + area * m_first.y;
    return result;
  }

  // calls visit(point) for points from behind the first one to the last one, between which the curve is not
  // farther than `tolerance` from the segments.
  template <typename Visitor>
  void sample(double tolerance, Visitor visit) const
  {
    if(!m_is_segment)
      refine(0, 1, m_first, m_last, tolerance, 24, visit);
    visit(m_last);
  }

private:
  // Where the generators are so near to each other that rounding moves the curve as a whole, it may end before the last
  // point. Then the segment may be nearer to where the distances are equal.
  bool is_better_than_segment(const Arc& a) const
  {
    const double chord = distance(m_first, m_last);
    if(distance(m_curve.point_at_angle(m_end), m_last) <= Tolerance<double>::touching() * chord)
      return true;
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
    return of_curve < of_segment;
  }

  Point point_of_segment(double t) const
  {
    return Point{m_first.x + t * (m_last.x - m_first.x), m_first.y + t * (m_last.y - m_first.y)};
  }

  // by the angle
  Point derivative(double angle) const
  {
    const double t = std::tan(angle);
    const Point d = m_curve.derivative(t);
    return Point{(1 + t * t) * d.x, (1 + t * t) * d.y};
  }

  // The integral over the curve, with an error that is small in comparison with `scale`: what is integrated may be
  // nothing but rounding. The intervals are halved until the sum does not change.
  template <typename Function>
  double integral(Function f, double scale) const
  {
    double previous = 0;
    for(int n = 1; n <= 1024; n *= 2)
    {
      double sum = 0;
      for(int i = 0; i < n; ++i)
        sum += boost::math::quadrature::gauss<double, 15>::integrate(f, m_end * i / n, m_end * (i + 1) / n);
      if(n > 1 && std::abs(sum - previous) <= Tolerance<double>::quadrature() * scale)
        return sum;
      previous = sum;
    }
    return previous;
  }

  template <typename Visitor>
  void refine(double t, double u, const Point& p, const Point& q, double tolerance, int depth,
              Visitor& visit) const
  {
    const double middle = (t + u) / 2;
    const Point m = point(middle);
    const Half_plane<double> side = Half_plane<double>::left_of(p, q);
    if(depth == 0 || 2 * std::abs(side(m)) <= tolerance) // the largest distance is less than twice this one
      return;
    refine(t, middle, p, m, tolerance, depth - 1, visit);
    visit(m);
    refine(middle, u, m, q, tolerance, depth - 1, visit);
  }

  Point m_first, m_last;
  Weighted_bisector<double> m_curve;
  bool m_is_segment;
  double m_end = 0; // the angle of the last point (Weighted_bisector)
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_ARC_CURVE_H
