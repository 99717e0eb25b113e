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

// A proof that distances are not too long, which does not depend on how they were found.
//
// Let u be a function on the edges of the surface such that u(p) <= u(q) + |pq| for any two points p and q on the
// border of one face, and that is not greater than the offset at each source. Then u is not greater than the distance
// at any vertex: a path from a source to the vertex is cut by the edges into pieces that cross one face each, and along
// each piece u grows by no more than its length. Here u is made of the windows that a propagation has kept, whatever
// they are worth, and the condition is checked for all pairs of points: u consists of pieces, the least of u(q) + |pq|
// over the points q of a piece is the distance from an image, reflected into the plane of the face, or from an end of
// the piece; and the difference of two such distances has its extrema at known places.
//
// With rounding, u(p) <= u(q) + |pq| + e holds for the largest e that is found, and the distance is not less than
// u - (m + 2) e, where m is the number of faces that a shortest path crosses, as u may also err by e at both ends.

#include <CGAL/Surface_mesh_geodesics/internal/certificate/Edge_distance_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Worst_violation.h>

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

template <typename FT_>
class Lower_bound_check
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Piece = Distance_piece<FT>;

  // `distance` and `extents`, the longest edges of components, are those of all vertices. Nothing is copied.
  Lower_bound_check(const Mesh& mesh, const std::vector<FT>& distance, const std::vector<FT>& extents,
                    const Edge_window_field<FT>& windows)
    : m_mesh(mesh), m_distance(distance), m_extents(extents), m_windows(windows)
  {
    make_functions();
  }

  // u(p) <= u(q) + |pq|, for all points on the borders of faces.
  Worst_violation<FT> run()
  {
    m_worst = Worst_violation<FT>();
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
        check_beyond(halfedge_of(f, k));
    return m_worst;
  }

private:
  struct Point
  {
    FT x, y;
  };

  // The values of a function at the ends of a piece.
  struct Ends
  {
    FT first, last;
  };

  // An edge in the frame of another one: from `origin` in direction `unit`.
  struct Line
  {
    Point origin, unit;
    FT length;

    Point at(const FT& t) const { return {origin.x + t * unit.x, origin.y + t * unit.y}; }
    FT along(const Point& p) const { return (p.x - origin.x) * unit.x + (p.y - origin.y) * unit.y; }
    FT across(const Point& p) const { return unit.x * (p.y - origin.y) - unit.y * (p.x - origin.x); }
  };

  // --- the functions on the edges ---

  bool is_first_of_edge(Halfedge_id h) const { return m_mesh.opposite(h) == null_id || h < m_mesh.opposite(h); }

  static bool is_finite(const FT& d) { return d < std::numeric_limits<FT>::infinity(); }

  void make_functions()
  {
    m_begin.assign(3 * m_mesh.number_of_faces(), 0);
    m_size.assign(3 * m_mesh.number_of_faces(), 0);
    Edge_distance_function<FT> function;
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
      {
        const Halfedge_id h = halfedge_of(f, k);
        if(!is_first_of_edge(h))
          continue;
        function.restart(m_mesh.length(h));
        add_paths(h, false, function);
        if(m_mesh.opposite(h) != null_id)
          add_paths(m_mesh.opposite(h), true, function);
        m_begin[dense_index(h)] = m_pieces.size();
        m_size[dense_index(h)] = function.pieces().size();
        m_pieces.insert(m_pieces.end(), function.pieces().begin(), function.pieces().end());
      }
  }

  // adds the paths that come to the edge of h, straight from a corner of the face of h or through one of its edges.
  void add_paths(Halfedge_id h, bool is_backwards, Edge_distance_function<FT>& function) const
  {
    const Face_frame<FT> c = m_mesh.face_frame(h);
    auto add = [&](const Piece& p)
    { function.add(is_backwards ? backwards(p, c.length) : p); };
    auto add_three = [&](const Piece& before, const Piece& p, const Piece& behind)
    {
      if(is_backwards)
        function.add(backwards(p, c.length), backwards(behind, c.length), backwards(before, c.length));
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

  // adds what the windows that have entered the face across g see of the base, which has the given length.
  template <typename Add>
  void add_windows_through(Halfedge_id g, const Line& side, const FT& length, Add add) const
  {
    const FT infinity = std::numeric_limits<FT>::infinity();
    m_windows.for_each_window(g, [&](const Kept_window<FT>& w)
    {
      // the image lies to the right of the side
      const Point image = {side.at(w.image_x).x + w.image_depth * side.unit.y,
                           side.at(w.image_x).y - w.image_depth * side.unit.x};
      if(!(image.y > 0))
        return;
      // From the end of an interval on the right side, which rises from the base, to its begin one looks at the base
      // from left to right; so one does on the left side, which falls to it. A ray that rises goes on forever.
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

  // where the ray from the image through p meets the base, or `rising` if it rises.
  static FT seen_on_base(const Point& image, const Point& p, const FT& rising)
  {
    if(!(p.y > 0))
      return p.x;
    return p.y < image.y ? FT(image.x + (p.x - image.x) * (image.y / (image.y - p.y))) : rising;
  }

  static Piece backwards(const Piece& p, const FT& length)
  {
    return {length - p.end, length - p.begin, length - p.x, p.depth, p.offset};
  }

  // the sides from A to C and from B to C in the frame of AB; they have a length.
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

  // the function on the edge of h along h, or against it.
  void read_function(Halfedge_id h, bool is_backwards, std::vector<Piece>& pieces) const
  {
    pieces.clear();
    const bool is_first = is_first_of_edge(h);
    const std::size_t e = dense_index(is_first ? h : m_mesh.opposite(h));
    const auto first = m_pieces.begin() + static_cast<std::ptrdiff_t>(m_begin[e]);
    pieces.assign(first, first + static_cast<std::ptrdiff_t>(m_size[e]));
    if(is_first != is_backwards)
      return;
    std::reverse(pieces.begin(), pieces.end());
    for(Piece& p : pieces)
      p = backwards(p, m_mesh.length(h));
  }

  // --- the condition ---

  // from the points q on the edge of h to the points p on the two other edges of its face, and to the ends of the edge.
  void check_beyond(Halfedge_id h)
  {
    const Face_frame<FT> c = m_mesh.face_frame(h);
    m_scale = (std::max)(c.length, (std::max)(c.left_length, c.right_length));
    check_ends(c);
    read_function(h, false, m_from);
    if(m_from.empty()) // not reached, or without length
      return;
    for(std::size_t i = 0; i + 1 < m_from.size(); ++i) // where u jumps by rounding
      look_at(abs_difference(m_from[i].at(m_from[i].end), m_from[i + 1].at(m_from[i].end)),
              m_from[i].at(m_from[i].end), c.origin);
    look_at(m_distance[c.origin] - m_from.front().at(FT(0)), m_distance[c.origin], c.origin);
    look_at(m_distance[c.target] - m_from.back().at(c.length), m_distance[c.target], c.target);
    if(c.left_length > 0)
    {
      read_function(previous_halfedge(h), true, m_to);
      check_pieces(left_side(c), c.origin, c.apex);
    }
    if(c.right_length > 0)
    {
      read_function(next_halfedge(h), false, m_to);
      check_pieces(right_side(c), c.target, c.apex);
    }
  }

  // the condition for the ends of the edge alone: all that there is to an edge without length.
  void check_ends(const Face_frame<FT>& c)
  {
    const FT& d = m_distance[c.origin];
    const FT& e = m_distance[c.target];
    if(!is_finite(d) && !is_finite(e))
      return;
    look_at(d - e - c.length, d, c.origin);
    look_at(e - d - c.length, e, c.target);
  }

  static FT abs_difference(const FT& a, const FT& b) { return a < b ? FT(b - a) : FT(a - b); }

  void look_at(const FT& excess, const FT& value, Vertex_id v)
  {
    m_worst.look_at(excess, value + m_scale, m_extents[v], v);
  }

  void check_pieces(const Line& side, Vertex_id near, Vertex_id far)
  {
    for(const Piece& q : m_from)
      for(const Piece& p : m_to)
        check_pair(q, p, side, near, far);
  }

  // The points of the side that are seen from the image of q through q are one interval; the way to those before and
  // behind it is shortest through an end of q.
  void check_pair(const Piece& q, const Piece& p, const Line& side, Vertex_id near, Vertex_id far)
  {
    const Point begin = {q.begin, FT(0)}, end = {q.end, FT(0)}, image = {q.x, -q.depth};
    if(q.depth <= 0)
    {
      const Point nearest = {(std::min)((std::max)(q.x, q.begin), q.end), FT(0)};
      check_part(p, p.begin, p.end, nearest, q.at(nearest.x), side, near, far);
      return;
    }
    // positive to the left of the ray through an end of q, negative to the right of it
    const Ends left = {turn(image, begin, side.at(p.begin)), turn(image, begin, side.at(p.end))};
    const Ends right = {turn(image, end, side.at(p.begin)), turn(image, end, side.at(p.end))};
    if(left.first > 0 && left.last > 0)
      return check_part(p, p.begin, p.end, begin, q.at(q.begin), side, near, far);
    if(right.first < 0 && right.last < 0)
      return check_part(p, p.begin, p.end, end, q.at(q.end), side, near, far);
    FT first = p.begin, last = p.end; // of what is seen
    if(left.first > 0 || left.last > 0)
    {
      const FT place = place_of_zero(p, left);
      (left.first > 0 ? first : last) = place;
      check_part(p, left.first > 0 ? p.begin : place, left.first > 0 ? place : p.end, begin, q.at(q.begin), side, near,
                 far);
    }
    if(right.first < 0 || right.last < 0)
    {
      const FT place = place_of_zero(p, right);
      FT& limit = right.first < 0 ? first : last;
      limit = right.first < 0 ? (std::max)(limit, place) : (std::min)(limit, place);
      check_part(p, right.first < 0 ? p.begin : place, right.first < 0 ? place : p.end, end, q.at(q.end), side, near,
                 far);
    }
    check_part(p, first, last, image, q.offset, side, near, far);
  }

  // twice the area of the triangle: positive if c is to the left of the line from a to b.
  static FT turn(const Point& a, const Point& b, const Point& c)
  {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  // the place in p where a linear function is zero; it has the given values at the ends, of which one is positive and
  // one is not, or one is negative and one is not.
  static FT place_of_zero(const Piece& p, const Ends& value)
  {
    const FT t = p.begin + (p.end - p.begin) * (value.first / (value.first - value.last));
    return (std::min)((std::max)(t, p.begin), p.end);
  }

  // p against the distance from an image, to which the offset is added, for the places from first to last.
  void check_part(const Piece& p, const FT& first, const FT& last, const Point& image, const FT& offset,
                  const Line& side, Vertex_id near, Vertex_id far)
  {
    if(!(first <= last))
      return;
    using std::abs;
    const Piece limit = {first, last, side.along(image), FT(abs(side.across(image))), offset};
    const std::array<FT, 2> turns = turning_places(p.x, p.depth, limit.x, limit.depth);
    for(const FT& t : {first, last, turns[0], turns[1]})
      if(t >= first && t <= last)
      {
        const FT value = p.at(t);
        look_at(value - limit.at(t), value, 2 * t < side.length ? near : far);
      }
  }

  const Mesh& m_mesh;
  const std::vector<FT>& m_distance;
  const std::vector<FT>& m_extents;
  const Edge_window_field<FT>& m_windows;
  std::vector<Piece> m_pieces;
  std::vector<std::size_t> m_begin, m_size; // by halfedge: the first one of an edge has its pieces
  std::vector<Piece> m_from, m_to;
  FT m_scale = 0; // the longest edge of the face that is checked
  Worst_violation<FT> m_worst;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_LOWER_BOUND_CHECK_H
