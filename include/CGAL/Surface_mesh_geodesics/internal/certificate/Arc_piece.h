// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_ARC_PIECE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_ARC_PIECE_H

// A piece of an arc between two points, and the points of it at which a comparison with a third image is decided.
//
// Theorem. Let F be the left image of the piece, d the vector from F to the right image, s the weight of F minus that
// of the right image, and 2 A = d^2 - s^2. The point of the bisector in the direction of the unit vector e from F is at
// the distance r(e) = A / D(e) with D(e) = s + e d > 0 (Weighted_bisector.h). For another image Q let d', s', A' and D'
// be the same. Then Q is nowhere nearer to the bisector than F where f(e) = A' D(e) - A D'(e) is not negative: this
// says A' / r >= D', which is |x - Q|^2 >= (r + s')^2 at x = F + r e, so that |x - Q| >= r + s'. Conversely, Q is
// nearer where f(e) < 0 and r + s' > 0; and where f(e) < 0, the sign of r + s' does not change, as r + s' = 0 makes f
// positive. f(e) is a number plus e v with v = A' d - A d'. So its minimum over the directions between those of the
// ends of the piece is at an end, or at -v / |v| if that is one of them. In the same way, a line n x = m meets the
// bisector where e (n A - m' d) = m' s, with m' = m - n F; and the bisector leaves one side of the line, if it does
// between its ends, where e is opposite to A n - m' d. So nothing has to be searched for.
//
// Directions from F are less than half a turn apart on a piece: it is in a face, and F is not inside.
//
// All of this holds for an image at infinity in place of the right one, and of Q, with the value of its linear function
// at F, less the weight of F, for A, with 1 for s, and with the vector against its rays for d (Weighted_bisector.h):
// the bisector is a parabola then. If the left image is at infinity, F is the right one; if both are, the piece is a
// segment.

#include <CGAL/Surface_mesh_geodesics/internal/certificate/Edge_distance_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// All points are in one plane. `left` and `right` are the images from which the distances on the piece are measured.
// The piece is the segment between its ends, or the bisector of both images. (It is the segment, too, if the images are
// too close to each other for a bisector.)
//
// Each for_each function calls visit(point) for few points of the piece between its ends. Takes constant time.
template <typename FT_>
class Arc_piece
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Image = Additively_weighted_point<FT>;

  Arc_piece(const Point& first, const Point& last, const Image& left, const Image& right, bool is_segment)
    : m_first(first), m_last(last), m_left(left), m_right(right), m_focus(left.is_at_infinity() ? right : left),
      m_is_segment(is_segment || m_focus.is_at_infinity())
  {
    if(m_is_segment)
      return;
    const Bisector b = bisector_with(left.is_at_infinity() ? left : right);
    m_difference = b.difference;
    m_to_right = b.to_other;
    m_size = b.size;
    m_is_segment = !(m_size > 0);
    m_to_first = {FT(first.x - m_focus.x), FT(first.y - m_focus.y)};
    m_to_last = {FT(last.x - m_focus.x), FT(last.y - m_focus.y)};
  }

  bool is_segment() const { return m_is_segment; }

  const Point& first() const { return m_first; }
  const Point& last() const { return m_last; }

  // The distance that is claimed for a point of the piece. Both images have the same one there, up to rounding.
  FT value(const Point& p) const { return (std::min)(m_left.distance_to(p), m_right.distance_to(p)); }

  // How far the distances from both images differ at a point.
  FT difference(const Point& p) const
  {
    using std::abs;
    return abs(m_left.distance_to(p) - m_right.distance_to(p));
  }

  // The points where the distance from an image, minus the distance that is claimed, may be least. If it is negative
  // anywhere on the piece, it is so at one of them or at an end.
  template <typename Visit>
  void for_each_extremum(const Image& q, Visit visit) const
  {
    if(m_is_segment)
    {
      visit_turning_points(m_left, q, visit);
      visit_turning_points(m_right, q, visit);
      return;
    }
    const Bisector b = bisector_with(q);
    visit_direction({FT(m_size * b.to_other.x - b.size * m_to_right.x),
                     FT(m_size * b.to_other.y - b.size * m_to_right.y)}, visit);
  }

  // The points where the distances from the two images of the piece may differ most: none on the bisector, where they
  // do not differ.
  template <typename Visit>
  void for_each_extremum_of_difference(Visit visit) const
  {
    if(m_is_segment)
      visit_turning_points(m_left, m_right, visit);
  }

  // The points where the piece meets the line through a and b.
  template <typename Visit>
  void for_each_crossing(const Point& a, const Point& b, Visit visit) const
  {
    const Point n = {FT(a.y - b.y), FT(b.x - a.x)};
    if(m_is_segment)
    {
      const FT at_first = n.x * (m_first.x - a.x) + n.y * (m_first.y - a.y),
               at_last = n.x * (m_last.x - a.x) + n.y * (m_last.y - a.y);
      if((at_first < 0) != (at_last < 0))
        visit(point_of_segment(at_first / (at_first - at_last)));
      return;
    }
    const FT m = n.x * (a.x - m_focus.x) + n.y * (a.y - m_focus.y);
    const Point w = {FT(n.x * m_size - m * m_to_right.x), FT(n.y * m_size - m * m_to_right.y)};
    const FT k = m * m_difference, square = w.x * w.x + w.y * w.y, root_of = square - k * k;
    if(!(root_of >= 0))
      return;
    using std::sqrt;
    const FT root = sqrt(root_of);
    visit_direction({FT(k * w.x - root * w.y), FT(k * w.y + root * w.x)}, visit);
    visit_direction({FT(k * w.x + root * w.y), FT(k * w.y - root * w.x)}, visit);
  }

  // The point that may be farthest to the right of the line from a to b, where it is not an end.
  template <typename Visit>
  void for_each_extremum_from_line(const Point& a, const Point& b, Visit visit) const
  {
    if(m_is_segment)
      return;
    const Point n = {FT(a.y - b.y), FT(b.x - a.x)};
    const FT m = n.x * (a.x - m_focus.x) + n.y * (a.y - m_focus.y);
    visit_direction({FT(m * m_to_right.x - n.x * m_size), FT(m * m_to_right.y - n.y * m_size)}, visit);
  }

private:
  // The bisector of F and another image: s, d and A.
  struct Bisector
  {
    FT difference;
    Point to_other;
    FT size;
  };

  Bisector bisector_with(const Image& q) const
  {
    if(q.is_at_infinity())
      return {FT(1), {FT(-q.x), FT(-q.y)}, FT(q.weight + q.x * m_focus.x + q.y * m_focus.y - m_focus.weight)};
    const Point d = {FT(q.x - m_focus.x), FT(q.y - m_focus.y)};
    const FT s = m_focus.weight - q.weight;
    return {s, d, half_of_squares(d, s)};
  }

  // Returns (d^2 - s^2) / 2, without loss where the two nearly cancel.
  static FT half_of_squares(const Point& d, const FT& s)
  {
    const FT length = norm<FT>(d.x, d.y);
    return (length - s) * (length + s) / 2;
  }

  Point point_of_segment(const FT& t) const
  {
    return {FT(m_first.x + t * (m_last.x - m_first.x)), FT(m_first.y + t * (m_last.y - m_first.y))};
  }

  // Visits the point of the bisector in a direction from the left image, if that is between those of the ends. The
  // vector need not have a length, and may be none.
  //
  // Let a and b be the ends, seen from the image, and c = p a + q b with p + q = 1 the point of the segment between
  // them in that direction. As 1 / r is a number plus a linear function of the direction, 1 / r = 1 / |c| - s x / A
  // with x |c| = p |a| + q |b| - |c|, which is computed from the square of the cross product, without a difference. So
  // the point is near the segment also where rounding hides the direction, and where the images are known less well
  // than the ends.
  //
  // An end may be so near to the image that rounding hides its direction. It may turn the curve beside it by an angle
  // that makes up 1 / r of the farther end; then the ends tell nothing, and the point is at r = A / D. If that is
  // farther than both ends, rounding has put the direction between theirs.
  template <typename Visit>
  void visit_direction(const Point& direction, Visit visit) const
  {
    const Point &a = m_to_first, &b = m_to_last;
    const FT turn = cross(a, b), from_first = cross(a, direction), to_last = cross(direction, b);
    const bool is_between = turn > 0 ? from_first > 0 && to_last > 0 : from_first < 0 && to_last < 0;
    if(!is_between)
      return;
    const FT q = from_first / (from_first + to_last), p = 1 - q;
    const Point c = {FT(p * a.x + q * b.x), FT(p * a.y + q * b.y)};
    const FT size_a = norm<FT>(a.x, a.y), size_b = norm<FT>(b.x, b.y), size_c = norm<FT>(c.x, c.y);
    const FT sum = p * size_a + q * size_b, width = size_a * size_b + a.x * b.x + a.y * b.y;
    if(!(size_c > 0) || !(width > 0))
      return;
    if(is_end_lost(size_a, size_b))
    {
      const FT d = m_difference + (c.x * m_to_right.x + c.y * m_to_right.y) / size_c, r = m_size / d;
      if(d > 0 && r < (std::max)(size_a, size_b))
        visit(Point{FT(m_focus.x + r * c.x / size_c), FT(m_focus.y + r * c.y / size_c)});
      return;
    }
    const FT excess = 2 * p * q * (turn / width) * (turn / (sum + size_c)) / size_c;
    const FT stretch = 1 - m_difference * excess * size_c / m_size; // |c| / r
    if(stretch > 0)
      visit(Point{FT(m_focus.x + c.x / stretch), FT(m_focus.y + c.y / stretch)});
  }

  // Is the nearer one of two ends, at these distances from the left image, known so badly that 1 / r of the farther one
  // is lost? Its direction is known up to the rounding of points over its distance, and d times that, over A, is the
  // error of 1 / r.
  bool is_end_lost(const FT& a, const FT& b) const
  {
    using std::abs;
    const FT least = (std::min)(a, b), most = (std::max)(a, b);
    const FT rounding = std::numeric_limits<FT>::epsilon() * (most + abs(m_focus.x) + abs(m_focus.y));
    return 64 * least < most && rounding * norm<FT>(m_to_right.x, m_to_right.y) * most > m_size * least;
  }

  // Visits the points of the segment where the difference of the distances from two images turns.
  template <typename Visit>
  void visit_turning_points(const Image& p, const Image& q, Visit visit) const
  {
    using std::abs;
    const FT length = distance(m_first, m_last);
    if(!(length > 0))
      return;
    const Point unit = {FT((m_last.x - m_first.x) / length), FT((m_last.y - m_first.y) / length)};
    const auto piece = [&](const Image& i)
    {
      const FT x = i.is_at_infinity() ? i.x : FT(i.x - m_first.x), y = i.is_at_infinity() ? i.y : FT(i.y - m_first.y);
      return Distance_piece<FT>{FT(0), length, FT(x * unit.x + y * unit.y), FT(abs(y * unit.x - x * unit.y)),
                                i.weight, i.is_at_infinity()};
    };
    for(const FT& t : turning_points(piece(p), piece(q)))
      if(t > 0 && t < length)
        visit(Point{FT(m_first.x + t * unit.x), FT(m_first.y + t * unit.y)});
  }

  Point m_first, m_last;
  Image m_left, m_right, m_focus;   // F is one of both
  bool m_is_segment;
  // Of a piece that is no segment.
  FT m_difference = 0;              // s
  Point m_to_right;                 // d
  FT m_size = 0;                    // A, positive
  Point m_to_first, m_to_last;      // from F
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_ARC_PIECE_H
