// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_LOWER_BOUND_CHECK_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_LOWER_BOUND_CHECK_H

// Proves that given distances are not too long. The proof does not depend on how they were found.
//
// Theorem. Let u be a function on the edges of the surface such that u(p) <= u(q) + |pq| for any two points p and q on
// the border of one face, and u(s) <= offset of s for each source s. Then u(v) is a lower bound of the distance of each
// vertex v. Proof: the edges cut a path from s to v into pieces, each of them in one face. Along each piece, u grows by
// at most the length of the piece. The sum over the pieces is u(v) <= u(s) + length of the path.
//
// The points s of a curve lie on edges as well: faces that a curve crosses have been divided along it. So the theorem
// holds for curves as it stands, if u(s) <= offset for all points s of the edges that are parts of curves.
//
// The function u is made of the windows and the strips that a propagation has kept. They are only a proposal: a wrong
// one makes some u(p) wrong, and the condition fails there. The condition is checked for all pairs of points, not for
// samples. On each edge u consists of pieces, each the distance from one image. For a piece q and a point p, the least
// u(q) + |pq| over the points of the piece is the distance of p from the image of the piece, reflected into the plane
// of the face, if the line from there to p passes through the piece, and leads through an end of the piece otherwise.
// The same is true of a linear piece, whose image is infinitely far away: with rays of the unit vector (k, n), u(q) is
// a number plus k q, and the sum grows with q where the line from q to p has a smaller component along the edge than
// (k, n). So it is least at the ray through p, where it is the same linear function of the plane, or at an end of the
// piece. So both sides of the condition are distances from images, and the extrema of their difference are at known
// abscissas.
//
// For one point p and the whole edge, u(q) + |pq| is convex on each piece. If it is least at the begin of a piece, the
// piece before is not greater there; so its least value is no greater, unless u jumps. Such a way needs a check of its
// own only if the piece before is least at its end, or if there is none. The same holds for ends. So each point p is
// checked against the pieces that see it, and against few ends: nearly linear in the number of pieces, as they see
// different points. The proof goes along the edge in one direction; all jumps in that direction count as one violation.
//
// Steps:
// - Lower_bound_function makes u on each edge.
// - check_face() takes each halfedge as the place of q, for the face on its left. check_ends() and check_continuity()
//   are for p on the same edge, check_side() for p on the two other sides. ways_through() divides a side by the ends of
//   the piece of q, check_part() compares two distances from images.
// - prove_lower_bounds() does both, in one thread or in several.
// - record_excess_on_edge() checks u(s) <= offset of s on an edge of a curve. A piece is convex, so its ends decide.
// - Not here: the same for sources at vertices, which the caller checks (Distance_certifier).
//
// Rounding. Let e be the largest violation found; a violation is the excess, so u(p) <= u(q) + |pq| + e for the points
// that are checked, and with 2 e for all others, because of jumps. A path that crosses m faces gives
// u(v) <= u(s) + length + 2 m e. The values at both ends of the path may differ by e from the function on the edges. So
// the distance is at least u(v) - 2 (m + 1) e.

#include <CGAL/Surface_mesh_geodesics/internal/certificate/Edge_distance_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Lower_bound_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Worst_violation.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Checks the condition on single faces. Threads have objects of their own, and share the function. Frames are those of
// Lower_bound_function.
template <typename FT_>
class Lower_bound_check
{
public:
  using FT = FT_;
  using Function = Lower_bound_function<FT>;
  using Piece = Distance_piece<FT>;

  // `extents` has the longest edge of the component of each vertex. Both are referred to, not copied.
  Lower_bound_check(const Function& function, const std::vector<FT>& extents)
    : m_function(function), m_extents(extents)
  {
    CGAL_assertion(extents.size() == function.mesh().number_of_vertices());
  }

  // The worst violation on the faces that have been checked.
  const Worst_violation<FT>& worst() const { return m_worst; }

  // Records the violations of u(p) <= u(q) + |pq| over all points on the border of a face. Takes time O(n log n) for n
  // pieces around the face, plus time linear in the number of pairs of which one sees the other.
  void check_face(Face_id f)
  {
    for(unsigned int k = 0; k < 3; ++k)
      check_beyond(halfedge_of(f, k));
  }

private:
  using Point = Planar_point<FT>;

  // The values of a linear function at the ends of a side: on which side of a ray they are (turn()).
  struct Ends
  {
    FT first, last;
  };

  // A part of a side, empty if last < first.
  struct Part
  {
    FT first = 0, last = -1;
  };

  // For each point of a side, the shortest way from a piece leads through the begin of the piece, is straight from its
  // image, or leads through its end. (By rounding, the first and the last part may have points in common.)
  struct Ways
  {
    Part through_begin, straight, through_end;
  };

  static bool is_finite(const FT& d) { return d < std::numeric_limits<FT>::infinity(); }

  const FT& distance(Vertex_id v) const { return m_function.values()[v]; }

  // Checks the condition from the points q on the edge of h to the points p on the two other sides of its face, and to
  // the ends of the edge. Both sides are read away from the edge: AC from A, against its halfedge, and BC from B. If a
  // side with a length has no function, no corner of the face is reached, and check_continuity() finds that the edge
  // has one nevertheless.
  void check_beyond(Halfedge_id h)
  {
    const Face_frame<FT> c = m_function.mesh().face_frame(h);
    m_scale = (std::max)(c.length, (std::max)(c.left_length, c.right_length));
    check_ends(c);
    m_function.read(h, false, m_from);
    if(m_from.empty()) // the edge is not reached, or has no length
      return;
    check_continuity(c);
    if(c.left_length > 0)
    {
      m_function.read(previous_halfedge(h), true, m_to);
      check_side(left_side_line(c), {c.origin, c.apex});
    }
    if(c.right_length > 0)
    {
      m_function.read(next_halfedge(h), false, m_to);
      check_side(right_side_line(c), {c.target, c.apex});
    }
  }

  // Checks that the function has no jumps, which count together, and is not less than the values at the ends of the
  // edge. (It is not greater by more than rounding, as add_paths() has added the paths from both ends.) A piece is a
  // distance from an image, or along rays, which grows by at most the length of the way. So a function without jumps
  // satisfies the condition for two points of the edge itself, and no other check is needed for them.
  // Requires: m_from is not empty.
  void check_continuity(const Face_frame<FT>& c)
  {
    FT up = 0, down = 0, least = (std::min)(m_from.front().at(FT(0)), m_from.back().at(c.length));
    for(std::size_t i = 0; i + 1 < m_from.size(); ++i)
    {
      const FT before = m_from[i].at(m_from[i].end), behind = m_from[i + 1].at(m_from[i].end);
      up += (std::max)(FT(behind - before), FT(0));
      down += (std::max)(FT(before - behind), FT(0));
      least = (std::min)(least, (std::min)(before, behind));
    }
    record((std::max)(up, down), least, c.origin);
    record(distance(c.origin) - m_from.front().at(FT(0)), distance(c.origin), c.origin);
    record(distance(c.target) - m_from.back().at(c.length), distance(c.target), c.target);
  }

  // Checks the condition for the ends of the edge alone. An edge without length has no other points.
  void check_ends(const Face_frame<FT>& c)
  {
    const FT& d = distance(c.origin);
    const FT& e = distance(c.target);
    if(!is_finite(d) && !is_finite(e))
      return;
    record(d - e - c.length, d, c.origin);
    record(e - d - c.length, e, c.target);
  }

  void record(const FT& excess, const FT& value, Vertex_id v)
  {
    m_worst.record(excess, value + m_scale, m_extents[v], v);
  }

  // The vertices at the start and at the end of a side; a violation is reported at the nearer one.
  using Ends_of_side = std::pair<Vertex_id, Vertex_id>;

  // Checks the condition from the points of the edge (m_from) to those of the side (m_to).
  void check_side(const Side_line<FT>& side, const Ends_of_side& ends)
  {
    Part through_end; // of the piece before
    for(std::size_t i = 0; i < m_from.size(); ++i)
    {
      const Piece& q = m_from[i];
      const Ways ways = ways_through(q, side);
      check_straight_ways(q, ways.straight, side, ends);
      FT at_begin = q.at(q.begin);
      if(i == 0)
        through_end = ways.through_begin; // there is no piece that the way could come through instead
      else
        at_begin = (std::min)(at_begin, m_from[i - 1].at(q.begin));
      check_ways_through(Point{q.begin, FT(0)}, at_begin, common_part(through_end, ways.through_begin), side, ends);
      through_end = ways.through_end;
    }
    const Piece& last = m_from.back();
    check_ways_through(Point{last.end, FT(0)}, last.at(last.end), through_end, side, ends);
  }

  static Part common_part(const Part& a, const Part& b)
  {
    return {(std::max)(a.first, b.first), (std::min)(a.last, b.last)};
  }

  // Divides a side by the ways from the points of q, on the edge. If the image lies on the edge, all ways lead through
  // the point of q that is nearest to it. Else the image is taken below the edge, opposite to the side, wherever its
  // paths come from: its distances on the edge are the same. Rays along the edge come from an end of q.
  Ways ways_through(const Piece& q, const Side_line<FT>& side) const
  {
    const Part all = {FT(0), side.length};
    Ways ways;
    if(q.depth <= 0)
    {
      const FT nearest = q.nearest();
      (nearest <= q.begin ? ways.through_begin : nearest >= q.end ? ways.through_end : ways.straight) = all;
      return ways;
    }
    // Positive on the left of the ray through an end of q, negative on its right.
    const Point begin = {q.begin, FT(0)}, end = {q.end, FT(0)}, first = side.at(FT(0)), last = side.at(side.length);
    ways.straight = all;
    divide({turn(q, begin, first), turn(q, begin, last)}, side.length, ways.straight, ways.through_begin);
    divide({-turn(q, end, first), -turn(q, end, last)}, side.length, ways.straight, ways.through_end);
    return ways;
  }

  // Moves the part of a side of this length where a linear function with these values at the ends is positive from the
  // straight ways to others.
  static void divide(const Ends& value, const FT& length, Part& straight, Part& others)
  {
    if(!(value.first > 0) && !(value.last > 0))
      return;
    if(value.first > 0 && value.last > 0)
    {
      straight = Part();
      others = {FT(0), length};
      return;
    }
    const FT zero = (std::min)((std::max)(FT(length * (value.first / (value.first - value.last))), FT(0)), length);
    if(value.first > 0)
    {
      straight.first = (std::max)(straight.first, zero);
      others = {FT(0), zero};
    }
    else
    {
      straight.last = (std::min)(straight.last, zero);
      others = {zero, length};
    }
  }

  // Checks the points of a part of the side against straight ways from the image of q.
  void check_straight_ways(const Piece& q, const Part& part, const Side_line<FT>& side, const Ends_of_side& ends)
  {
    if(q.depth <= 0)
      return check_ways_through(Point{q.nearest(), FT(0)}, q.at(q.nearest()), part, side, ends);
    if(!q.is_linear)
      return check_ways_through(Point{q.x, -q.depth}, q.offset, part, side, ends);
    for_each_piece(part, [&](const Piece& p, const FT& first, const FT& last)
    { check_part(p, rays_on_side(q, first, last, side), ends, side.length); });
  }

  // Checks the points of a part of the side against the distance from a point plus an offset.
  void check_ways_through(const Point& image, const FT& offset, const Part& part, const Side_line<FT>& side,
                          const Ends_of_side& ends)
  {
    for_each_piece(part, [&](const Piece& p, const FT& first, const FT& last)
    { check_part(p, first, last, image, offset, side, ends); });
  }

  // Calls visit(piece, first, last) for the pieces of the side that meet a part, with the interval that they share.
  template <typename Visit>
  void for_each_piece(const Part& part, Visit visit) const
  {
    const auto ends_before = [](const Piece& p, const FT& t) { return p.end < t; };
    if(part.first <= part.last)
      for(auto p = std::lower_bound(m_to.begin(), m_to.end(), part.first, ends_before);
          p != m_to.end() && p->begin <= part.last; ++p)
        visit(*p, (std::max)(p->begin, part.first), (std::min)(p->end, part.last));
  }

  // Positive if c is on the left of the ray of q through its point b, negative on the right.
  static FT turn(const Piece& q, const Point& b, const Point& c)
  {
    if(q.is_linear)
      return q.x * (c.y - b.y) - q.depth * (c.x - b.x);
    return turn(Point{q.x, -q.depth}, b, c);
  }

  // Returns twice the signed area of the triangle abc: positive if c is on the left of the line from a to b.
  static FT turn(const Point& a, const Point& b, const Point& c)
  {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  // The linear function that the rays of q, on the edge, have on an interval of the side.
  static Piece rays_on_side(const Piece& q, const FT& first, const FT& last, const Side_line<FT>& side)
  {
    using std::abs;
    return {first, last, q.x * side.unit.x + q.depth * side.unit.y,
            FT(abs(q.depth * side.unit.x - q.x * side.unit.y)),
            q.offset + (q.x * side.origin.x + q.depth * side.origin.y), true};
  }

  // Checks that the function of p is at most the distance from an image plus an offset, at all abscissas from `first`
  // to `last` on the side. The difference is largest at an end or at a turning point.
  void check_part(const Piece& p, const FT& first, const FT& last, const Point& image, const FT& offset,
                  const Side_line<FT>& side, const Ends_of_side& ends)
  {
    using std::abs;
    check_part(p, {first, last, side.along(image), FT(abs(side.across(image))), offset}, ends, side.length);
  }

  // The same for a limit that is given on the interval of a side with this length.
  void check_part(const Piece& p, const Piece& limit, const Ends_of_side& ends, const FT& length)
  {
    const FT &first = limit.begin, &last = limit.end;
    if(!(first <= last))
      return;
    if(is_greater_everywhere(limit, p, first, last))
    {
      m_worst.number_of_checks += 1;
      return;
    }
    const std::array<FT, 2> turns = turning_points(p, limit);
    for(const FT& t : {first, last, turns[0], turns[1]})
      if(t >= first && t <= last)
      {
        const FT value = p.at(t);
        record(value - limit.at(t), value, 2 * t < length ? ends.first : ends.second);
      }
  }

  const Function& m_function;
  const std::vector<FT>& m_extents;
  std::vector<Piece> m_from, m_to; // the functions on the edge and on the side that are checked
  FT m_scale = 0;                  // the longest edge of the face that is checked
  Worst_violation<FT> m_worst;
};

// Makes a function, and returns the worst violation on all faces. The loops over the faces are those of `chunks`
// (Chunk_team.h). Before each face, and each step towards it, go_on() is called; the check is interrupted if it returns
// false. The result does not depend on the number of threads. If nothing is violated, the function is a lower bound of
// the distance on all edges.
template <typename FT, typename Chunks, typename GoOn>
Worst_violation<FT> prove_lower_bounds(const Chunks& chunks, Lower_bound_function<FT>& function,
                                       const std::vector<FT>& extents, GoOn go_on)
{
  const std::size_t n = function.mesh().number_of_faces();
  std::vector<Worst_violation<FT>> of_chunks(chunks.number_of_chunks(n));
  bool is_complete = function.make(chunks, go_on);
  if(is_complete)
    is_complete = chunks(n, go_on, [&](std::size_t c, std::size_t first, std::size_t last, const auto& ask)
    {
      Lower_bound_check<FT> check(function, extents);
      for(std::size_t f = first; f < last && ask(); ++f)
        check.check_face(static_cast<Face_id>(f));
      of_chunks[c] = check.worst();
    });
  return merged(of_chunks, is_complete);
}

// Records the excess of a function that has been made over the offset on an edge of a curve, which must not be
// positive. A violation is relative to the value.
template <typename FT>
void record_excess_on_edge(const Lower_bound_function<FT>& function, Halfedge_id h, const FT& offset,
                           const std::vector<FT>& extents, Worst_violation<FT>& worst)
{
  std::vector<Distance_piece<FT>> pieces;
  function.read(h, false, pieces);
  const Vertex_id v = function.mesh().source(h);
  for(const Distance_piece<FT>& p : pieces)
    for(const FT& t : {p.begin, p.end})
      worst.record(p.at(t) - offset, p.at(t), extents[v], v);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_LOWER_BOUND_CHECK_H
