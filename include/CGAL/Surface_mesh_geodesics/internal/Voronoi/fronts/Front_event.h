// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_EVENT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_EVENT_H

// The first event along a bisector: where a piece of a front ends. Events are where the curve leaves the face, where it
// leaves the cone of one of its two images, where a third image becomes nearer, and where its parameters lose
// precision.
//
// Each candidate is a quadratic polynomial of the curve's parameter t (Weighted_bisector.h), positive on one side of
// the event. Candidates are given one by one; each search ends at the first event known so far, so that the order of
// candidates matters for the time, and for events at the same t: the one that was given first stays.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Site_image.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// What ends a piece, and where. BORDER: the curve leaves the face; UNTIL: it leaves the half-plane of the trace;
// LEFT_CONE, RIGHT_CONE: it leaves the cone of its left or right image; NEARER: another image becomes nearer;
// IMPRECISE: the curve has to be described anew from here. With NOTHING, t is where the search ends, if it is bounded.
//
// t is the parameter of the curve (Weighted_bisector::point()): 0 at its start, ascending along it.
template <typename FT>
struct Front_event
{
  enum Kind { NOTHING, BORDER, UNTIL, LEFT_CONE, RIGHT_CONE, NEARER, IMPRECISE } kind = NOTHING;
  FT t = std::numeric_limits<FT>::infinity();
  std::size_t index = 0;   // of the image for NEARER, of the side for BORDER; for a cone 0 (left side) or 1
  Half_plane<FT> line{};   // that the curve leaves: for BORDER, UNTIL and the cones only
  FT reach = std::numeric_limits<FT>::infinity(); // no point of the curve before t is farther from its start

  bool is_bounded() const { return t < std::numeric_limits<FT>::infinity(); }
};

// Use: start(), leave() and its like, find_reach(), take_over() for images, event(). One object serves many searches.
//
// Invariant: no candidate that has been given has an event before event().t, up to the tolerances of leave() and
// take_over().
template <typename FT_>
class First_event
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Image = Site_image<FT>;
  using Event = Front_event<FT>;
  using Bisector = Weighted_bisector<FT>;

  // Starts a search along a curve up to the parameter `end`, which may be infinite. `width` is the rounding of lengths
  // in the face, `slack` the distance by which the start of the curve may be outside of half-planes that it is to
  // leave. The curve is referred to, until the next start().
  void start(const Bisector& curve, const FT& end, const FT& width, const FT& slack)
  {
    CGAL_assertion(width >= 0 && slack >= 0);
    m_curve = &curve;
    m_width = width;
    m_slack = slack;
    m_event = Event();
    m_event.t = end;
  }

  // The same up to where the curve ends or its parameters lose precision; the latter is an event.
  void start(const Bisector& curve, const FT& width, const FT& slack)
  {
    start(curve, (std::min)(curve.end(), curve.end_of_precision()), width, slack);
    if(m_event.t < curve.end())
      m_event.kind = Event::IMPRECISE;
  }

  const Event& event() const { return m_event; }

  // Bounds the part of the curve before the event. Call it after the half-planes and before the images: the bound
  // rejects most images at once. Without it, all images are tested.
  void find_reach()
  {
    if(m_event.is_bounded())
      m_event.reach = m_curve->reach(m_event.t);
  }

  // Finds the first parameter behind which the curve is outside of a half-plane. Requires: the values of h are signed
  // distances, since they are compared with lengths.
  //
  // A curve that starts on the line may be outside by rounding, and so may be one that touches it or runs along it.
  // Therefore a bounded part of the curve is outside only if it is so by more than `slack` next to its start, and by
  // more than `width` farther on.
  //
  // The roots of the quadratic divide the curve up to the event into at most three intervals, on each of which it is on
  // one side of the line; the sign at the middle tells which. The event is the start of the first interval outside.
  void leave(const Half_plane<FT>& h, typename Event::Kind kind, std::size_t index)
  {
    const Quadratic<FT> q = m_curve->side(h);
    if(m_event.is_bounded() && q.is_positive_until(m_event.t))
      return;
    const std::array<FT, 2> root = q.positive_roots();
    FT from = 0;
    for(unsigned int i = 0; i < 3; ++i)
    {
      const FT to = i < 2 ? (std::min)(root[i], m_event.t) : m_event.t;
      if(from < to)
      {
        const bool is_bounded = to < std::numeric_limits<FT>::infinity();
        const FT middle = is_bounded ? FT(from + (to - from) / 2) : FT(2 * from + 1);
        if(q(middle) < 0 && !is_outside_by_rounding(h, from, middle, to))
          return set(kind, from, index, h);
      }
      if(!(to < m_event.t))
        return;
      from = to;
    }
  }

  // Finds where the curve leaves the cone of an image: one of its two sides. Without a cone, it never does.
  void leave_cone(const Image& image, typename Event::Kind kind)
  {
    if(!image.has_cone)
      return;
    leave(image.left, kind, 0);
    leave(image.right, kind, 1);
  }

  // Finds where the curve leaves a half-plane that it may have to enter first. From outside, it enters at the first
  // root and leaves at the second one; if it has fewer roots, it does not leave.
  void enter_and_leave(const Half_plane<FT>& h)
  {
    if(h(m_curve->start()) >= -m_width)
      return leave(h, Event::UNTIL, 0);
    const FT t = m_curve->side(h).positive_roots()[1];
    if(t < m_event.t)
      set(Event::UNTIL, t, m_event.index, h);
  }

  // Finds where the image g, of index `index`, becomes nearer than `left`, one of the two images of the curve, at
  // points that g sees. `at_start` is the distance by `left` at the start of the curve. g has to be nearer beyond
  // rounding (Tolerance::nearer()), on a part of the curve longer than `width`. If `has_been_left` is set, g does not
  // become nearer at the start of the curve, but farther on (first_clear_parameter()): otherwise rounding could lead
  // from one image to the other and back.
  //
  // The roots of the polynomials of g (Challenge) divide the curve up to the event; g takes over at the start of the
  // first part that is_taken_over_between() accepts. Takes constant time; most images are rejected by may_take_over()
  // before a root is computed.
  void take_over(const Image& left, const FT& at_start, const Image& g, std::size_t index, bool has_been_left)
  {
    Challenge c;
    if(!may_take_over(at_start, g, c) || !find_roots(g, c))
      return;
    std::sort(m_roots.begin(), m_roots.end());
    const FT last = m_event.is_bounded() ? m_event.t : FT(m_roots.empty() ? FT(1) : FT(2 * m_roots.back() + 1));
    m_roots.push_back(last);
    FT from = 0;
    for(const FT& to : m_roots)
      if(from < to)
      {
        if(is_taken_over_between(from, to, left, g, c))
        {
          const FT t = from > 0 || !has_been_left ? from : first_clear_parameter(to, left, g);
          set(Event::NEARER, t, index, m_event.line);
          m_event.reach = m_curve->reach(t);
          return;
        }
        from = to;
      }
  }

private:
  // A third image along the curve, as polynomials of its parameter: positive where the image is nearer than the two of
  // the curve, and where the curve is inside of each side of its cone.
  struct Challenge
  {
    Quadratic<FT> nearer{}, in_left{}, in_right{};
  };

  void set(typename Event::Kind kind, const FT& t, std::size_t index, const Half_plane<FT>& line)
  {
    m_event.kind = kind;
    m_event.t = t;
    m_event.index = index;
    m_event.line = line;
  }

  // Returns whether rounding may be what puts the part of the curve from `from` to `to`, with the given middle, outside
  // of a half-plane. A part behind the last root leads away from the line; only where the curve starts on the line, and
  // so may run along it, is that uncertain. Then the end of the part speaks as well.
  bool is_outside_by_rounding(const Half_plane<FT>& h, const FT& from, const FT& middle, const FT& to) const
  {
    if(!(from > 0))
      return h(m_curve->point(middle)) >= -m_slack;
    const bool is_last = !(to < m_event.t);
    if(is_last && (!m_event.is_bounded() || h(m_curve->start()) > m_width))
      return false;
    return h(m_curve->point(middle)) >= -m_width && (!is_last || h(m_curve->point(to)) >= -m_width);
  }

  // Returns false if g does not take over before the event; sets c otherwise. The cheap tests come first: distances
  // change by at most the length of the way, for g as for the images of the curve. So up to the distance `reach` from
  // the start, g is not nearer unless (distance by g) - reach < at_start + reach. The others look at the coefficients
  // in Bernstein form (Quadratic): they may fail to reject an image, but reject none that takes over.
  bool may_take_over(const FT& at_start, const Image& g, Challenge& c) const
  {
    const Point& p = m_curve->start();
    const FT to_g = g.point.way_to(p);
    if(g.point.weight + to_g > at_start + 2 * m_event.reach)
      return false;
    const bool is_bounded = m_event.is_bounded();
    if(g.has_cone)
    {
      c.in_left = m_curve->side(g.left);
      if(is_bounded && c.in_left.is_negative_until(m_event.t))
        return false;
      c.in_right = m_curve->side(g.right);
      if(is_bounded && c.in_right.is_negative_until(m_event.t))
        return false;
    }
    c.nearer = m_curve->nearer(g.point, to_g);
    return !(is_bounded && c.nearer.is_negative_until(m_event.t));
  }

  // Collects the parameters where g may become or cease to be nearer or visible. Returns false if g is not nearer
  // anywhere.
  bool find_roots(const Image& g, const Challenge& c)
  {
    m_roots.clear();
    add_roots(c.nearer);
    if(m_roots.empty() && !(c.nearer((std::min)(FT(1), FT(m_event.t / 2))) > 0))
      return false;
    if(g.has_cone)
    {
      add_roots(c.in_left);
      add_roots(c.in_right);
    }
    return true;
  }

  // Collects the roots of q before the event; none if q is positive up to there, beyond the rounding of its values.
  void add_roots(const Quadratic<FT>& q)
  {
    if(m_event.is_bounded() && q.is_positive_until(m_event.t))
      return;
    for(const FT& r : q.positive_roots())
      if(r < m_event.t)
        m_roots.push_back(r);
  }

  // Returns whether g is nearer between two parameters, with no root between them, so that the middle speaks for all of
  // the interval. The polynomials may err near double roots, so the distances themselves are compared as well.
  //
  // Formula: at the middle, the polynomials of c are positive, and is_nearer() holds for g and `left`; and both ends
  // are farther apart than the width of a face's rounding. Frame: that of the bisector. Ties: an image that ties, or is
  // nearer on no more than `width`, does not take over.
  // Error: if the result is true, g is nearer than `left` at the middle by 23 u of the distance (is_nearer()), where
  // u = epsilon() / 2; it sees the middle up to the rounding of a polynomial. A take-over on a part that is not wider
  // than m_width is missed. No bound is known for the middle as a point of the bisector (Weighted_bisector.h).
  // Laws: no image takes over from itself; scaling all lengths by a power of two keeps the answer.
  bool is_taken_over_between(const FT& from, const FT& to, const Image& left, const Image& g, const Challenge& c) const
  {
    const FT middle = from + (to - from) / 2;
    return c.nearer(middle) > 0 && (!g.has_cone || (c.in_left(middle) > 0 && c.in_right(middle) > 0))
        && is_nearer(g.point, left.point, m_curve->point(middle))
        && distance(m_curve->point(from), m_curve->point(to)) > m_width;
  }

  // Returns a parameter between the start of the curve and `to` at which g is nearer than `left` beyond rounding, while
  // at half of it g is not, or has not moved from the start. So the images err by little more than rounding where they
  // are used up to there. Requires: is_taken_over_between() holds from 0 to `to`.
  FT first_clear_parameter(const FT& to, const Image& left, const Image& g) const
  {
    FT t = to / 2;
    for(Point p = m_curve->point(t / 2);
        distance(p, m_curve->start()) > m_width && is_nearer(g.point, left.point, p); p = m_curve->point(t / 2))
      t = t / 2;
    return t;
  }

  const Bisector* m_curve = nullptr;
  FT m_width = 0, m_slack = 0;
  Event m_event; // the first one of the candidates so far
  std::vector<FT> m_roots; // a buffer of take_over()
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_EVENT_H
