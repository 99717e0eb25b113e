// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_WEIGHTED_BISECTOR_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_WEIGHTED_BISECTOR_H

// Bisectors of additively weighted points of a plane: the curves of equal distance from two of them, which are branches
// of hyperbolas, or lines. Along a bisector, the questions "which of three points is nearer" and "on which side of a
// line" become signs of quadratic polynomials.
//
// Let F be one of the two points (a focus), d the vector to the other one, s the weight of F minus that of the other
// one, and u the unit vector from F to a point of the curve at distance r. Squaring r + s = |r u - d| gives 1/r = (s +
// u d) / K with 2 K = d^2 - s^2: an affine function of u. The same holds for the bisector of F and a third point, and
// 1/r is affine in u along a line, too. So both questions are linear inequalities in u.
//
// Directions are measured from that of a point p0 of the curve. The parameter t is the tangent of half the angle from
// it: u is a quotient of quadratic polynomials in t, the point of the curve is one, and each inequality becomes one for
// a quadratic polynomial. Everything is written as a difference from p0, so that no digits are lost where the foci are
// far away in comparison with the relevant piece of the curve.
//
// A point at infinity stands for a bundle of parallel rays, whose distances are a linear function with the gradient n.
// Let K be its value at F less the weight of F. Then K = r (1 - u n) on the bisector, so 1/r = (1 - u n) / K: the
// formula above with s = 1 and d = -n. That bisector is a parabola, and all else stays as it is. Two bundles have a
// line as bisector.
//
// Error: no bound is known for points of a bisector in general. Newton_refinement.h refines those that matter; tests
// sample arcs and compare both distances.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
FT distance(const Planar_point<FT>& p, const Planar_point<FT>& q)
{
  return norm<FT>(p.x - q.x, p.y - q.y);
}

template <typename FT>
Planar_point<FT> midpoint(const Planar_point<FT>& p, const Planar_point<FT>& q)
{
  return {FT((p.x + q.x) / 2), FT((p.y + q.y) / 2)};
}

// Returns the fraction t in [0, 1] of the segment from a to b at which its point nearest to p lies; 0 if a equals b.
template <typename FT>
FT nearest_fraction(const Planar_point<FT>& p, const Planar_point<FT>& a, const Planar_point<FT>& b)
{
  const FT dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const FT t = square > 0 ? FT(((p.x - a.x) * dx + (p.y - a.y) * dy) / square) : FT(0);
  return (std::min)((std::max)(t, FT(0)), FT(1));
}

// Returns the distance of p from the nearest point of the segment from a to b, which may be a single point.
template <typename FT>
FT distance_from_segment(const Planar_point<FT>& p, const Planar_point<FT>& a, const Planar_point<FT>& b)
{
  const FT t = nearest_fraction(p, a, b);
  return distance(p, Planar_point<FT>{FT(a.x + t * (b.x - a.x)), FT(a.y + t * (b.y - a.y))});
}

// A point with a distance of its own: the distance of p from it is `weight` plus the distance in the plane.
//
// The point may be at infinity: then its rays are parallel, (x, y) is the unit vector along them, and `weight` is the
// distance of the origin. So distances are weight + x p.x + y p.y, where that is not negative by rounding. They err by
// the rounding of the numbers that they are differences of, even where they are small: `scale` is the size of these.
template <typename FT>
struct Additively_weighted_point
{
  FT x = 0, y = 0, weight = 0;
  FT scale = 0; // positive for a point at infinity only

  bool is_at_infinity() const { return scale > 0; }

  // The distance without the weight. (The one of a point at infinity may be negative.)
  FT way_to(const Planar_point<FT>& p) const
  {
    return is_at_infinity() ? FT(x * p.x + y * p.y) : norm<FT>(p.x - x, p.y - y);
  }

  FT distance_to(const Planar_point<FT>& p) const
  {
    const FT d = weight + way_to(p);
    return is_at_infinity() && d < 0 ? FT(0) : d;
  }

  // The distance in the plane, which is infinite for a point at infinity.
  FT planar_distance_to(const Planar_point<FT>& p) const
  {
    return is_at_infinity() ? std::numeric_limits<FT>::infinity() : norm<FT>(p.x - x, p.y - y);
  }
};

// Returns whether the distance a is smaller than b beyond the rounding of images: stricter than is_clearly_less().
//
// Formula: a < b (1 - margin). Requires: a, b >= 0; the margin is small. Ties: neither of two distances that tie is
// nearer, so that the current image stays.
// Laws: antisymmetric and transitive; no distance is nearer than itself; scaling both by a power of two keeps the
// answer.
template <typename FT>
bool is_nearer(const FT& a, const FT& b, const FT& margin = Tolerance<FT>::nearer())
{
  return a < b * (1 - margin);
}

// The same for the distances of p from a and from b. Frame: any in which the three points are given. A point at
// infinity has to be nearer, or to be farther, by the rounding of its scale as well.
//
// Error bound, to first order in u = epsilon() / 2, for exact points: each distance errs by 4 u of itself, as in
// Window_numbers::distance_at(), and the right side rounds once. So a is nearer only if its exact distance is less than
// that of b by 23 u of it or more, and is nearer wherever it is less by 41 u, that is, by 20.5 epsilon(). Images have
// errors of their own (Tolerance::distance()).
// Laws: those above; mirroring all points at an axis keeps the answer.
template <typename FT>
bool is_nearer(const Additively_weighted_point<FT>& a, const Additively_weighted_point<FT>& b,
               const Planar_point<FT>& p)
{
  return is_nearer<FT>(a.distance_to(p) + Tolerance<FT>::nearer() * (a.scale + b.scale), b.distance_to(p));
}

// One side of a line: a x + b y + c >= 0.
template <typename FT>
struct Half_plane
{
  FT a, b, c;

  FT operator()(const Planar_point<FT>& p) const { return a * p.x + b * p.y + c; }

  // Returns the points on the left of the line from p to q. Values are signed distances from the line.
  static Half_plane left_of(const Planar_point<FT>& p, const Planar_point<FT>& q)
  {
    return along(FT(q.x - p.x), FT(q.y - p.y), p);
  }

  // Returns the points on the left of the line through p in the direction (dx, dy). Values are zero everywhere if the
  // direction is zero.
  static Half_plane along(const FT& dx, const FT& dy, const Planar_point<FT>& p)
  {
    const FT n = norm(dx, dy);
    const FT a = n > 0 ? FT(-dy / n) : FT(0), b = n > 0 ? FT(dx / n) : FT(0);
    return Half_plane{a, b, FT(-(a * p.x + b * p.y))};
  }

  Half_plane opposite() const { return Half_plane{FT(-a), FT(-b), FT(-c)}; }
};

// The polynomial c0 + 2 c1 t + c2 t^2.
template <typename FT>
struct Quadratic
{
  FT c0, c1, c2;

  FT operator()(const FT& t) const { return c0 + t * (2 * c1 + t * c2); }

  // Returns true only if the polynomial is negative from 0 to t: its coefficients in Bernstein form are.
  bool is_negative_until(const FT& t) const
  {
    const FT b1 = c0 + c1 * t;
    return c0 < 0 && b1 < 0 && b1 + t * (c1 + c2 * t) < 0;
  }

  // Returns true only if the polynomial is positive from 0 to t by more than the rounding of its value.
  bool is_positive_until(const FT& t) const
  {
    using std::abs;
    const FT rounding = Tolerance<FT>::polynomial() * (abs(c0) + t * (2 * abs(c1) + t * abs(c2)));
    const FT b1 = c0 + c1 * t;
    return c0 > rounding && b1 > rounding && b1 + t * (c1 + c2 * t) > rounding;
  }

  // Returns the positive roots in ascending order, infinity in place of those that do not exist. Neither root is
  // computed as a difference of nearly equal numbers.
  std::array<FT, 2> positive_roots() const
  {
    using std::sqrt;
    const FT infinity = std::numeric_limits<FT>::infinity();
    std::array<FT, 2> r{infinity, infinity};
    const FT discriminant = c1 * c1 - c0 * c2;
    if(!(discriminant >= 0))
      return r;
    const FT q = -(c1 + (c1 < 0 ? FT(-sqrt(discriminant)) : FT(sqrt(discriminant))));
    if(c2 != 0 && q / c2 > 0)
      r[0] = q / c2;
    if(q != 0 && c0 / q > 0)
      r[1] = c0 / q;
    if(r[1] < r[0])
      std::swap(r[0], r[1]);
    return r;
  }
};

// Frame: that of the two points given. Ties: none, since a bisector is the set of ties. Degenerate cases are decided by
// the constructor: is_valid(), is_ray(), is_curved().
template <typename FT_>
class Weighted_bisector
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Focus = Additively_weighted_point<FT>;

  // Makes the bisector of `left` and `right` from p on, in the direction that has the points nearer to `left` on its
  // left. Requires: p is on the bisector up to rounding.
  //
  // The names are those of the beginning of this file: F is m_focus, d the distance of the foci here, s the difference
  // of the weights, k is K. The bisector is a curve if |s| < d, which is K > 0; a ray if |s| = d; else it does not
  // exist. All three are decided beyond the rounding of the distances.
  Weighted_bisector(const Focus& left, const Focus& right, const Point& p)
    : m_p(p)
  {
    if(left.is_at_infinity() || right.is_at_infinity())
    {
      if(left.is_at_infinity() && right.is_at_infinity())
        find_line_between_rays(left, right);
      else
        find_parabola(left, right);
      return;
    }
    const FT to_left = norm<FT>(p.x - left.x, p.y - left.y);
    const FT to_right = norm<FT>(p.x - right.x, p.y - right.y);
    // the nearer focus, unless the curve starts there
    m_is_left_focus = to_left > 0 && (to_left <= to_right || !(to_right > 0));
    m_focus = m_is_left_focus ? left : right;
    const Focus& other = m_is_left_focus ? right : left;
    const FT r = m_is_left_focus ? to_left : to_right;
    const FT dx = other.x - m_focus.x, dy = other.y - m_focus.y;
    const FT d = norm(dx, dy), s = m_focus.weight - other.weight;
    const FT k = (d - s) * (d + s) / 2;
    // Where one point is on the way from the other one, the bisector is a ray.
    const FT rounding = Tolerance<FT>::bisector() * (m_focus.weight + r);
    m_is_valid = r > 0 && k > Tolerance<FT>::curvature() * d * d && d - s > rounding && d + s > rounding;
    if(!m_is_valid)
    {
      find_ray(left, right);
      return;
    }
    m_radius = r;
    m_ux = (p.x - m_focus.x) / r;
    m_uy = (p.y - m_focus.y) / r;
    if(d <= Tolerance<FT>::closeness() * r)
    {
      find_line(left, right);
      return;
    }
    const FT nx = (to_right > 0 ? FT((p.x - right.x) / to_right) : FT(0))
                - (to_left > 0 ? FT((p.x - left.x) / to_left) : FT(0));
    const FT ny = (to_right > 0 ? FT((p.y - right.y) / to_right) : FT(0))
                - (to_left > 0 ? FT((p.y - left.y) / to_left) : FT(0));
    describe(dx, dy, k, nx, ny);
  }

  const Point& start() const { return m_p; }

  // Returns false where the two distances do not differ beyond rounding, or no curve exists.
  bool is_valid() const { return m_is_valid; }

  // Returns whether the bisector is a ray: paths from one point run through the other one, and all points behind that
  // one are equally far from both. The other functions are then those of the ray, and the parameter is the length.
  // (The first point may be at infinity.)
  bool is_ray() const { return m_is_straight && !m_is_valid; }

  // Returns whether the focus F is `left`. For a ray, F is the point where paths bend. (False for a ray between two
  // points at infinity: none bends.)
  bool is_left_focus() const { return m_is_left_focus; }

  // Returns the point at parameter t >= 0: the start at 0. Behind end(), it is on the other branch.
  // Formula, unless it is straight: p0 + 2 t (T - t b u) / w(t), with the tangent T at p0, the direction u of p0 from
  // F, b = m_bend and w = denominator().
  Point point(const FT& t) const
  {
    if(m_is_straight)
      return Point{FT(m_p.x + t * m_tx), FT(m_p.y + t * m_ty)};
    const FT factor = 2 * t / m_denominator(t), g = t * m_bend;
    return Point{FT(m_p.x + factor * (m_tx - g * m_ux)), FT(m_p.y + factor * (m_ty - g * m_uy))};
  }

  // Returns a distance from the start that no point of the curve from 0 to t exceeds: point() with the norms of both
  // vectors, and with the smallest coefficient in Bernstein form as a lower bound of w. Infinity if that is not
  // positive.
  FT reach(const FT& t) const
  {
    using std::abs;
    if(m_is_straight)
      return t;
    const Quadratic<FT>& w = m_denominator;
    const FT smallest = (std::min)({w.c0, FT(w.c0 + w.c1 * t), w(t)});
    if(!(smallest > 0))
      return std::numeric_limits<FT>::infinity();
    return 2 * t * (norm(m_tx, m_ty) + t * abs(m_bend)) / smallest;
  }

  // Returns whether the curve bends. One that is straight up to rounding has no angles and no derivative.
  bool is_curved() const { return m_is_valid && !m_is_straight; }

  // Returns half the angle of a point: the arc tangent of its parameter. Requires: is_curved().
  FT angle(const Point& p) const
  {
    using std::atan2;
    CGAL_assertion(is_curved());
    const FT x = p.x - m_focus.x, y = p.y - m_focus.y;
    const FT along = x * m_ux + y * m_uy, across = x * m_vx + y * m_vy;
    return atan2(across, FT(norm(along, across) + along));
  }

  // Returns half the angle of the point of the curve that is in the direction of p from F, or as far from F as p is:
  // of the one nearer to p. For p on the curve, both are p. But where the two foci are close to each other and p is far
  // away, the curve runs nearly toward F: all of it has nearly one direction, and only the distance tells where p is.
  // (At d from each other and r from p, an angle that errs by epsilon() moves the point by epsilon() r^2 / d.)
  // Formula: 1 + t^2 - |p - F| w(t) = 0, where the constant term is (r - |p - F|) / r. Ties: the direction, also
  // if its point is p up to Tolerance::interval(). Requires: is_curved().
  FT angle_near(const Point& p) const
  {
    using std::atan;
    using std::tan;
    FT best = angle(p);
    FT smallest = distance(p, point(tan(best)));
    const FT radius = distance(p, Point{m_focus.x, m_focus.y});
    if(!(smallest > Tolerance<FT>::interval() * radius))
      return best;
    const Quadratic<FT>& w = m_denominator;
    for(const FT& t : Quadratic<FT>{FT((m_radius - radius) / m_radius), FT(-radius * w.c1), FT(1 - radius * w.c2)}
                        .positive_roots())
    {
      const FT d = t < std::numeric_limits<FT>::infinity() ? distance(p, point(t)) : smallest;
      if(d < smallest)
      {
        best = atan(t);
        smallest = d;
      }
    }
    return best;
  }

  // Returns the point at half an angle, the inverse of angle().
  Point point_at_angle(const FT& angle) const
  {
    using std::tan;
    return point(tan(angle));
  }

  // Returns dp/dt. Requires: is_curved().
  Point derivative(const FT& t) const
  {
    CGAL_assertion(is_curved());
    // p - p0 = n / w
    const Quadratic<FT>& w = m_denominator;
    const FT g = m_bend, wt = w(t), dw = 2 * (w.c1 + t * w.c2), square = wt * wt;
    const FT nx = 2 * t * (m_tx - t * g * m_ux), ny = 2 * t * (m_ty - t * g * m_uy);
    const FT mx = 2 * m_tx - 4 * t * g * m_ux, my = 2 * m_ty - 4 * t * g * m_uy;
    return Point{FT((mx * wt - nx * dw) / square), FT((my * wt - ny * dw) / square)};
  }

  // The polynomial w(t) = (1 + t^2) / r(t), with r the distance of the point from F. Positive where the curve exists.
  const Quadratic<FT>& denominator() const { return m_denominator; }

  // Returns the parameter at which the curve goes to infinity. Behind it, point() is on the other branch.
  FT end() const { return denominator().positive_roots()[0]; }

  // Returns the parameter from which the curve should be described anew, infinity if there is none. Parameters lose
  // their digits far away from the focus, where all of them are close to end(), and after more than half a turn around
  // it. Formula: the first root of 1 + t^2 - reach r w(t), where the curve is `reach` times as far from F as p0 is, but
  // no more than half_turn().
  FT end_of_precision() const
  {
    if(m_is_straight)
      return std::numeric_limits<FT>::infinity();
    const FT reach = Tolerance<FT>::precise_reach();
    const FT t = Quadratic<FT>{FT(1 - reach), FT(-reach * m_radius * m_b), FT(1 - reach + 2 * reach * m_a * m_radius)}
                   .positive_roots()[0];
    return (std::min)(t, Tolerance<FT>::half_turn());
  }

  // Returns a polynomial in the parameter that is positive where the curve is in the half-plane.
  Quadratic<FT> side(const Half_plane<FT>& h) const
  {
    const FT h0 = h(m_p);
    if(m_is_straight)
      return Quadratic<FT>{h0, FT((h.a * m_tx + h.b * m_ty) / 2), 0};
    const Quadratic<FT>& w = m_denominator;
    const FT along_tangent = h.a * m_tx + h.b * m_ty, along_u = h.a * m_ux + h.b * m_uy;
    return Quadratic<FT>{FT(h0 * w.c0), FT(h0 * w.c1 + along_tangent),
                         FT(h0 * w.c2 - 2 * m_bend * along_u)};
  }

  // Returns a polynomial in the parameter that is positive where a third point g is nearer than the two; it is negative
  // everywhere if g never is. `to_g` is the distance of g from the start in the plane, way_to().
  //
  // Formula: (1 + t^2) (s + u d) - K w(t), with s, d and K those of F and g. It is the inequality K / r < s + u d,
  // multiplied by 1 + t^2. The value at p0 is ((r + s)^2 - to_g^2) / (2 r), computed as a product (`gain`), so that it
  // keeps its digits where g is about as near as F.
  Quadratic<FT> nearer(const Focus& g, const FT& to_g) const
  {
    if(m_is_straight)
      return nearer_on_line(g, to_g);
    if(g.is_at_infinity())
      return nearer_along_rays(g, to_g);
    const FT dx = g.x - m_focus.x, dy = g.y - m_focus.y, d = norm(dx, dy);
    const FT s = m_focus.weight - g.weight;
    if(s <= -d)
      return Quadratic<FT>{-1, 0, -1};
    const FT k = (d - s) * (d + s) / 2;
    const FT gain = (m_radius - to_g) + s; // at p0
    const FT g0 = gain * (to_g + gain / 2) / m_radius;
    const FT du = dx * m_ux + dy * m_uy, dv = dx * m_vx + dy * m_vy;
    return Quadratic<FT>{g0, FT(dv - k * m_b), FT(g0 - 2 * du + 2 * k * m_a)};
  }

  // Returns the unit tangent at the start, zero if there is none.
  Point tangent() const
  {
    const FT n = norm(m_tx, m_ty);
    return n > 0 ? Point{FT(m_tx / n), FT(m_ty / n)} : Point();
  }

private:
  // Describes the curve 1/r = c + (dx, dy) u / k for any c that lets it pass p0. Requires: m_ux, m_uy and m_radius are
  // set.
  //
  // Turns the parameter so that `left` is nearer on the left: the gradient (nx, ny) of the difference of the two
  // distances, right minus left, has to point to the left of the tangent.
  void describe(const FT& dx, const FT& dy, const FT& k, const FT& nx, const FT& ny)
  {
    m_vx = -m_uy;
    m_vy = m_ux;
    m_a = (dx * m_ux + dy * m_uy) / k;
    m_b = (dx * m_vx + dy * m_vy) / k;
    set_tangent();
    if(m_tx * ny - m_ty * nx < 0)
    {
      m_vx = -m_vx;
      m_vy = -m_vy;
      m_b = -m_b;
      set_tangent();
    }
    const FT rho = 1 / m_radius;
    m_denominator = Quadratic<FT>{rho, m_b, FT(rho - 2 * m_a)};
    m_bend = 1 - m_a * m_radius;
  }

  // Makes the bisector of a point, which is the focus, and a point at infinity. It is a ray from the focus, along the
  // other rays, if one of these leads through the focus with its distance: the inside of a segment then takes over from
  // its end. If the focus is nowhere nearer, there is no curve.
  void find_parabola(const Focus& left, const Focus& right)
  {
    m_is_left_focus = right.is_at_infinity();
    m_focus = m_is_left_focus ? left : right;
    const Focus& rays = m_is_left_focus ? right : left;
    const FT x = m_p.x - m_focus.x, y = m_p.y - m_focus.y, r = norm(x, y);
    const FT k = advantage_over_rays(rays);
    const FT rounding = Tolerance<FT>::bisector() * (m_focus.weight + r + rays.scale);
    m_radius = r;
    m_is_valid = r > 0 && k > rounding;
    if(m_is_valid)
    {
      m_ux = x / r;
      m_uy = y / r;
      const FT sign = m_is_left_focus ? 1 : -1;
      return describe(-rays.x, -rays.y, k, sign * (rays.x - m_ux), sign * (rays.y - m_uy));
    }
    if(k < -rounding)
      return;
    m_tx = rays.x;
    m_ty = rays.y;
    m_is_straight = r <= rounding || x * m_tx + y * m_ty >= r / 2;
    m_at_start = m_focus.weight + r;
  }

  // Makes the line on which two bundles of parallel rays are equally long. If their directions are the same up to
  // rounding, both are equally long everywhere, as both are at p0. Then the bisector is a ray along them: the last ray
  // of one bundle, which is the first one of the other. (Where curves lie on one line.)
  void find_line_between_rays(const Focus& left, const Focus& right)
  {
    const FT nx = right.x - left.x, ny = right.y - left.y, n = norm(nx, ny);
    m_focus = left;
    m_is_left_focus = false;
    m_is_straight = true;
    m_is_valid = n > Tolerance<FT>::bisector();
    m_tx = m_is_valid ? FT(ny / n) : left.x;
    m_ty = m_is_valid ? FT(-nx / n) : left.y;
    m_at_start = left.distance_to(m_p);
    m_slope = left.x * m_tx + left.y * m_ty;
  }

  // The value K of the focus and parallel rays: how much nearer than these the focus is at its own place.
  FT advantage_over_rays(const Focus& rays) const
  {
    return rays.weight + rays.way_to(Point{m_focus.x, m_focus.y}) - m_focus.weight;
  }

  // Returns nearer() for a point at infinity: (1 + t^2) (1 - u n) - K w(t), whose value at p0 is the difference of the
  // two distances over r.
  Quadratic<FT> nearer_along_rays(const Focus& g, const FT& to_g) const
  {
    const FT k = advantage_over_rays(g), g0 = ((m_radius - to_g) + (m_focus.weight - g.weight)) / m_radius;
    const FT du = -(g.x * m_ux + g.y * m_uy), dv = -(g.x * m_vx + g.y * m_vy);
    return Quadratic<FT>{g0, FT(dv - k * m_b), FT(g0 - 2 * du + 2 * k * m_a)};
  }

  // Finds the ray behind the point with the larger weight, if that point is on the way from the other one.
  void find_ray(const Focus& left, const Focus& right)
  {
    m_is_left_focus = right.weight < left.weight;
    m_focus = m_is_left_focus ? left : right;
    const Focus& other = m_is_left_focus ? right : left;
    const FT dx = m_focus.x - other.x, dy = m_focus.y - other.y, d = norm(dx, dy);
    m_radius = norm<FT>(m_p.x - m_focus.x, m_p.y - m_focus.y);
    const FT detour = other.weight + d - m_focus.weight, size = m_focus.weight + m_radius;
    const FT rounding = Tolerance<FT>::bisector() * size;
    if(!(d > Tolerance<FT>::closeness() * size) || !(detour <= rounding && -detour <= rounding))
      return;
    m_tx = dx / d;
    m_ty = dy / d;
    const FT along = (m_p.x - m_focus.x) * m_tx + (m_p.y - m_focus.y) * m_ty;
    m_is_straight = m_radius <= rounding || along >= m_radius / 2;
    m_at_start = m_focus.weight + m_radius;
  }

  // Makes the curve the line through p and the focus. Seen from p, the two points count as one.
  void find_line(const Focus& left, const Focus& right)
  {
    m_is_straight = true;
    const bool is_outward = m_ux * (right.y - left.y) - m_uy * (right.x - left.x) < 0;
    m_tx = is_outward ? m_ux : FT(-m_ux);
    m_ty = is_outward ? m_uy : FT(-m_uy);
    m_at_start = m_focus.weight + m_radius;
    m_slope = is_outward ? 1 : -1;
  }

  // Returns nearer() for a line, along which the common distance of the two is linear, with the slope m: the
  // inequality |p + t (tx, ty) - g| < s + m t, squared. For a point at infinity both sides are linear.
  Quadratic<FT> nearer_on_line(const Focus& g, const FT& d) const
  {
    const FT s = m_at_start - g.weight;
    if(g.is_at_infinity())
      return Quadratic<FT>{FT(s - d), FT((m_slope - (g.x * m_tx + g.y * m_ty)) / 2), 0};
    const FT dx = m_p.x - g.x, dy = m_p.y - g.y;
    if(s <= -d)
      return Quadratic<FT>{-1, 0, 0};
    return Quadratic<FT>{FT((s - d) * (s + d)), FT(m_slope * s - (dx * m_tx + dy * m_ty)),
                         FT((m_slope - 1) * (m_slope + 1))};
  }

  // Sets the tangent at p0: dp/dt over twice the radius.
  void set_tangent()
  {
    m_tx = m_vx - m_b * m_radius * m_ux;
    m_ty = m_vy - m_b * m_radius * m_uy;
  }

  Point m_p;
  Focus m_focus;
  bool m_is_left_focus = true, m_is_valid = false, m_is_straight = false;
  FT m_at_start = 0, m_slope = 1; // of a straight curve: the distance at p0, and how it grows
  FT m_radius = 0;                // from the focus to p0
  FT m_ux = 0, m_uy = 0;          // the direction from the focus to p0
  FT m_vx = 0, m_vy = 0;          // across, to the side of growing parameters
  FT m_a = 0, m_b = 0;            // d / K along u and v
  FT m_tx = 0, m_ty = 0;          // the tangent at p0
  Quadratic<FT> m_denominator{1, 0, 0};
  FT m_bend = 1;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_WEIGHTED_BISECTOR_H
