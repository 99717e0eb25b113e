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
// The function u is made of the windows that a propagation has kept. They are only a proposal: a wrong window makes
// some u(p) wrong, and the condition fails there. The condition is checked for all pairs of points, not for samples. On
// each edge u consists of pieces, each the distance from one image. For a piece q and a point p, the least u(q) + |pq|
// over the points of the piece is the distance of p from the image of the piece, reflected into the plane of the face,
// if the line from there to p passes through the piece, and leads through an end of the piece otherwise. So both sides
// of the condition are distances from images, and the extrema of their difference are at known abscissas.
//
// Steps:
// - make_functions() makes u on each edge: add_paths() collects the corners of a face and the windows on its three
//   sides, Edge_distance_function takes the minimum.
// - run() takes each halfedge as the place of q, for the face on its left. check_ends() and check_continuity() are for
//   p on the same edge, check_pieces() for p on the two other sides. check_pair() divides the side of p by the ends of
//   the piece of q, check_part() compares two distances from images.
// - Not here: u(s) <= offset of s. The caller checks that for each source (Distance_certifier).
//
// Rounding. Let e be the largest violation found; a violation is the excess, so u(p) <= u(q) + |pq| + e. A path that
// crosses m faces gives u(v) <= u(s) + length + m e. The values at both ends of the path may differ by e from the
// function on the edges. So the distance is at least u(v) - (m + 2) e.

#include <CGAL/Surface_mesh_geodesics/internal/certificate/Edge_distance_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Worst_violation.h>

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

// Checks the condition on all faces.
//
// Frames: a point, an image or a side is given in the frame of the halfedge whose face is looked at (Face_frame): A is
// the origin, B lies on the x axis, the face lies above. Functions on a side count from its `origin` (Line). Lengths
// are in the unit of the intrinsic mesh.
template <typename FT_>
class Lower_bound_check
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Piece = Distance_piece<FT>;

  // `distance` has the values of u at the vertices, infinity where no path is known, `extents` the longest edge of the
  // component of each vertex, and `windows` the windows for u between them. All are referred to, not copied.
  // Requires: the intervals of the windows are parts of their edges. Nothing else about the windows is taken for
  // granted.
  Lower_bound_check(const Mesh& mesh, const std::vector<FT>& distance, const std::vector<FT>& extents,
                    const Edge_window_field<FT>& windows)
    : m_mesh(mesh), m_distance(distance), m_extents(extents), m_windows(windows)
  {
    CGAL_assertion(distance.size() == mesh.number_of_vertices());
    CGAL_assertion(extents.size() == mesh.number_of_vertices());
  }

  // Returns the worst violation of u(p) <= u(q) + |pq| over all points on the border of one face. Before each face, and
  // each step towards it, go_on() is called; the check is interrupted if it returns false. Takes time linear in the
  // number of windows, times the number of pieces of an edge, and quadratic in the number of pieces around a face.
  template <typename GoOn>
  Worst_violation<FT> run(GoOn go_on)
  {
    m_worst = Worst_violation<FT>();
    bool is_complete = make_functions(go_on);
    for(Face_id f = 0; f < m_mesh.number_of_faces() && is_complete; ++f)
    {
      is_complete = go_on();
      for(unsigned int k = 0; k < 3 && is_complete; ++k)
        check_beyond(halfedge_of(f, k));
    }
    if(!is_complete)
      m_worst.record_interruption();
    return m_worst;
  }

private:
  using Point = Planar_point<FT>;

  // The values of a linear function at the ends of a piece: on which side of a ray they are (turn()).
  struct Ends
  {
    FT first, last;
  };

  // An edge in the frame of another edge: from `origin` in the direction `unit`. at() is the point at an abscissa;
  // along() and across() are the abscissa of the foot of a point, and its signed distance from the line, positive on
  // the left.
  struct Line
  {
    Point origin, unit;
    FT length;

    Point at(const FT& t) const { return {origin.x + t * unit.x, origin.y + t * unit.y}; }
    FT along(const Point& p) const { return (p.x - origin.x) * unit.x + (p.y - origin.y) * unit.y; }
    FT across(const Point& p) const { return unit.x * (p.y - origin.y) - unit.y * (p.x - origin.x); }
  };

  // --- the functions on the edges ---

  static bool is_finite(const FT& d) { return d < std::numeric_limits<FT>::infinity(); }

  // Makes u on all edges: on each one the minimum over the paths that reach it through its two faces, along the
  // halfedge for which is_first_of_edge() holds. Returns false if go_on() does.
  template <typename GoOn>
  bool make_functions(GoOn go_on)
  {
    m_begin.assign(3 * m_mesh.number_of_faces(), 0);
    m_size.assign(3 * m_mesh.number_of_faces(), 0);
    Edge_distance_function<FT> function;
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      if(!go_on())
        return false;
      for(unsigned int k = 0; k < 3; ++k)
        if(m_mesh.is_first_of_edge(halfedge_of(f, k)))
          make_function(halfedge_of(f, k), function);
    }
    return true;
  }

  // `function` is reused memory. Requires: is_first_of_edge(h).
  void make_function(Halfedge_id h, Edge_distance_function<FT>& function)
  {
    function.restart(m_mesh.length(h));
    add_paths(h, false, function);
    if(m_mesh.opposite(h) != null_id)
      add_paths(m_mesh.opposite(h), true, function);
    m_begin[dense_index(h)] = m_pieces.size();
    m_size[dense_index(h)] = function.pieces().size();
    m_pieces.insert(m_pieces.end(), function.pieces().begin(), function.pieces().end());
  }

  // Adds the paths that reach the edge of h from its face: from a corner, and through a window on one of the three
  // edges. (A window across h itself comes from the other face, but is known in the frame of h.) If `is_backward`, the
  // function runs against h.
  void add_paths(Halfedge_id h, bool is_backward, Edge_distance_function<FT>& function) const
  {
    const Face_frame<FT> c = m_mesh.face_frame(h);
    auto add = [&](const Piece& p)
    { function.add(is_backward ? backward(p, c.length) : p); };
    auto add_three = [&](const Piece& before, const Piece& p, const Piece& behind)
    {
      if(is_backward)
        function.add(backward(p, c.length), backward(behind, c.length), backward(before, c.length));
      else
        function.add(p, before, behind);
    };
    const std::pair<Vertex_id, Point> corners[3]
      = {{c.origin, {FT(0), FT(0)}}, {c.target, {c.length, FT(0)}}, {c.apex, {c.apex_x, c.apex_y}}};
    for(const std::pair<Vertex_id, Point>& corner : corners)
      if(is_finite(m_distance[corner.first]))
        add({FT(0), c.length, corner.second.x, corner.second.y, m_distance[corner.first]});
    m_windows.for_each_window(h, [&](const Kept_window<FT>& w)
    { add({w.begin, w.end, w.image_x, w.image_depth, m_distance[w.root]}); });
    if(c.right_length > 0)
      add_windows_through(next_halfedge(h), right_side(c), c.length, add_three);
    if(c.left_length > 0)
      add_windows_through(previous_halfedge(h), reversed(left_side(c)), c.length, add_three);
  }

  // Adds the paths of the windows on another side of the face, the halfedge g, to the base, which has the given length.
  // The base is the x axis; `side` is the edge of g in the direction of g, and the windows enter the face across it.
  template <typename Add>
  void add_windows_through(Halfedge_id g, const Line& side, const FT& length, Add add) const
  {
    const FT infinity = std::numeric_limits<FT>::infinity();
    m_windows.for_each_window(g, [&](const Kept_window<FT>& w)
    {
      // The image lies on the right of the side, outside the face.
      const Point image = {side.at(w.image_x).x + w.image_depth * side.unit.y,
                           side.at(w.image_x).y - w.image_depth * side.unit.x};
      // No straight path leads down to the base from an image that is not above its line.
      if(!(image.y > 0))
        return;
      // On both sides, the ray through the end of the window meets the base further left than the ray through its
      // begin. The points of the base beyond these rays are reached around an end of the window. A ray that rises meets
      // the base nowhere. As a ray turns upward to it, the point on the base moves away without bound: to the left
      // behind the right side of the face, to the right behind the left side. `rising` is that limit.
      const Point left = side.at(w.end), right = side.at(w.begin);
      const FT rising = side.unit.y > 0 ? -infinity : infinity;
      const FT first = (std::max)(seen_on_base(image, left, rising), FT(0)),
               last = (std::min)(seen_on_base(image, right, rising), length);
      const FT offset = m_distance[w.root];
      add(Piece{FT(0), first, left.x, left.y, offset + distance(image, left)},
          Piece{first, last, image.x, image.y, offset},
          Piece{last, length, right.x, right.y, offset + distance(image, right)});
    });
  }

  static FT distance(const Point& a, const Point& b) { return norm<FT>(b.x - a.x, b.y - a.y); }

  // Returns the abscissa where the ray from the image through p meets the line of the base, or `rising` if it does not.
  // A point p on the base is that point itself. Requires: image.y > 0.
  static FT seen_on_base(const Point& image, const Point& p, const FT& rising)
  {
    if(!(p.y > 0))
      return p.x;
    return p.y < image.y ? FT(image.x + (p.x - image.x) * (image.y / (image.y - p.y))) : rising;
  }

  // Returns the piece in the direction against an edge of this length.
  static Piece backward(const Piece& p, const FT& length)
  {
    return {length - p.end, length - p.begin, length - p.x, p.depth, p.offset};
  }

  // The sides AC and BC in the frame of AB. Require: the side has a length.
  static Line left_side(const Face_frame<FT>& c)
  {
    const Side_angle<FT> angle = left_angle(c);
    return {{FT(0), FT(0)}, {angle.cosine, angle.sine}, c.left_length};
  }

  static Line right_side(const Face_frame<FT>& c)
  {
    const Side_angle<FT> angle = right_angle(c);
    return {{c.length, FT(0)}, {-angle.cosine, angle.sine}, c.right_length};
  }

  static Line reversed(const Line& l)
  {
    return {l.at(l.length), {-l.unit.x, -l.unit.y}, l.length};
  }

  // Reads the function on the edge of h: in the direction of h, or against it. `pieces` ascend in that direction; they
  // are none if nothing reaches the edge, or if it has no length.
  void read_function(Halfedge_id h, bool is_backward, std::vector<Piece>& pieces) const
  {
    pieces.clear();
    const bool is_first = m_mesh.is_first_of_edge(h);
    const std::size_t e = dense_index(is_first ? h : m_mesh.opposite(h));
    const auto first = m_pieces.begin() + static_cast<std::ptrdiff_t>(m_begin[e]);
    pieces.assign(first, first + static_cast<std::ptrdiff_t>(m_size[e]));
    if(is_first != is_backward) // the direction in which the function is stored
      return;
    std::reverse(pieces.begin(), pieces.end());
    for(Piece& p : pieces)
      p = backward(p, m_mesh.length(h));
  }

  // --- the condition ---

  // Checks the condition from the points q on the edge of h to the points p on the two other sides of its face, and to
  // the ends of the edge. Both sides are read away from the edge: AC from A, against its halfedge, and BC from B. If a
  // side with a length has no function, no corner of the face is reached, and check_continuity() finds that the edge
  // has one nevertheless.
  void check_beyond(Halfedge_id h)
  {
    const Face_frame<FT> c = m_mesh.face_frame(h);
    m_scale = (std::max)(c.length, (std::max)(c.left_length, c.right_length));
    check_ends(c);
    read_function(h, false, m_from);
    if(m_from.empty()) // the edge is not reached, or has no length
      return;
    check_continuity(c);
    if(c.left_length > 0)
    {
      read_function(previous_halfedge(h), true, m_to);
      check_pieces(left_side(c), {c.origin, c.apex});
    }
    if(c.right_length > 0)
    {
      read_function(next_halfedge(h), false, m_to);
      check_pieces(right_side(c), {c.target, c.apex});
    }
  }

  // Checks that the function has no jumps, and is not less than the values at the ends of the edge. (It is not greater
  // by more than rounding, as add_paths() has added the paths from both ends.) A piece is a distance from an image,
  // which grows by at most the length of the way. So a function without jumps satisfies the condition for two points of
  // the edge itself, and no other check is needed for them.
  // Requires: m_from is not empty.
  void check_continuity(const Face_frame<FT>& c)
  {
    for(std::size_t i = 0; i + 1 < m_from.size(); ++i)
      record(abs_difference(m_from[i].at(m_from[i].end), m_from[i + 1].at(m_from[i].end)),
             m_from[i].at(m_from[i].end), c.origin);
    record(m_distance[c.origin] - m_from.front().at(FT(0)), m_distance[c.origin], c.origin);
    record(m_distance[c.target] - m_from.back().at(c.length), m_distance[c.target], c.target);
  }

  // Checks the condition for the ends of the edge alone. An edge without length has no other points.
  void check_ends(const Face_frame<FT>& c)
  {
    const FT& d = m_distance[c.origin];
    const FT& e = m_distance[c.target];
    if(!is_finite(d) && !is_finite(e))
      return;
    record(d - e - c.length, d, c.origin);
    record(e - d - c.length, e, c.target);
  }

  static FT abs_difference(const FT& a, const FT& b) { return a < b ? FT(b - a) : FT(a - b); }

  void record(const FT& excess, const FT& value, Vertex_id v)
  {
    m_worst.record(excess, value + m_scale, m_extents[v], v);
  }

  // The vertices at the start and at the end of a side; a violation is reported at the nearer one.
  using Ends_of_side = std::pair<Vertex_id, Vertex_id>;

  // Checks each piece of the edge (m_from) against each piece of the side (m_to).
  void check_pieces(const Line& side, const Ends_of_side& ends)
  {
    for(const Piece& q : m_from)
      for(const Piece& p : m_to)
        check_pair(q, p, side, ends);
  }

  // Checks the condition from the points of q, on the edge, to the points of p, on the side. The points of p that are
  // seen from the image of q through q form an interval; to those on either side of it, the shortest way is through an
  // end of q. If the image lies on the edge, all ways are through the point of q that is nearest to it. The image is
  // taken below the edge, opposite to p, wherever its paths come from: its distances on the edge are the same.
  void check_pair(const Piece& q, const Piece& p, const Line& side, const Ends_of_side& ends)
  {
    const Point begin = {q.begin, FT(0)}, end = {q.end, FT(0)}, image = {q.x, -q.depth};
    if(q.depth <= 0)
    {
      const Point nearest = {(std::min)((std::max)(q.x, q.begin), q.end), FT(0)};
      check_part(p, p.begin, p.end, nearest, q.at(nearest.x), side, ends);
      return;
    }
    // Positive on the left of the ray through an end of q, negative on its right.
    const Ends left = {turn(image, begin, side.at(p.begin)), turn(image, begin, side.at(p.end))};
    const Ends right = {turn(image, end, side.at(p.begin)), turn(image, end, side.at(p.end))};
    if(left.first > 0 && left.last > 0)
      return check_part(p, p.begin, p.end, begin, q.at(q.begin), side, ends);
    if(right.first < 0 && right.last < 0)
      return check_part(p, p.begin, p.end, end, q.at(q.end), side, ends);
    FT first = p.begin, last = p.end; // of the visible interval
    if(left.first > 0 || left.last > 0)
    {
      const FT zero = abscissa_of_zero(p, left);
      (left.first > 0 ? first : last) = zero;
      check_part(p, left.first > 0 ? p.begin : zero, left.first > 0 ? zero : p.end, begin, q.at(q.begin), side, ends);
    }
    if(right.first < 0 || right.last < 0)
    {
      const FT zero = abscissa_of_zero(p, right);
      FT& limit = right.first < 0 ? first : last;
      limit = right.first < 0 ? (std::max)(limit, zero) : (std::min)(limit, zero);
      check_part(p, right.first < 0 ? p.begin : zero, right.first < 0 ? zero : p.end, end, q.at(q.end), side, ends);
    }
    check_part(p, first, last, image, q.offset, side, ends);
  }

  // Returns twice the signed area of the triangle abc: positive if c is on the left of the line from a to b.
  static FT turn(const Point& a, const Point& b, const Point& c)
  {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  // Returns the abscissa in p where a linear function with these values at the ends is 0.
  // Requires: exactly one of the values is positive, or exactly one is negative.
  static FT abscissa_of_zero(const Piece& p, const Ends& value)
  {
    const FT t = p.begin + (p.end - p.begin) * (value.first / (value.first - value.last));
    return (std::min)((std::max)(t, p.begin), p.end);
  }

  // Checks that the function of p is at most the distance from an image plus an offset, at all abscissas from `first`
  // to `last` on the side. The difference is largest at an end or at a turning point.
  void check_part(const Piece& p, const FT& first, const FT& last, const Point& image, const FT& offset,
                  const Line& side, const Ends_of_side& ends)
  {
    if(!(first <= last))
      return;
    using std::abs;
    const Piece limit = {first, last, side.along(image), FT(abs(side.across(image))), offset};
    const std::array<FT, 2> turns = turning_points(p.x, p.depth, limit.x, limit.depth);
    for(const FT& t : {first, last, turns[0], turns[1]})
      if(t >= first && t <= last)
      {
        const FT value = p.at(t);
        record(value - limit.at(t), value, 2 * t < side.length ? ends.first : ends.second);
      }
  }

  const Mesh& m_mesh;
  const std::vector<FT>& m_distance;
  const std::vector<FT>& m_extents;
  const Edge_window_field<FT>& m_windows;
  std::vector<Piece> m_pieces;
  std::vector<std::size_t> m_begin, m_size; // of the pieces of an edge, by its first halfedge (dense_index)
  std::vector<Piece> m_from, m_to; // the functions on the edge and on the side that are checked
  FT m_scale = 0;                  // the longest edge of the face that is checked
  Worst_violation<FT> m_worst;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_LOWER_BOUND_CHECK_H
