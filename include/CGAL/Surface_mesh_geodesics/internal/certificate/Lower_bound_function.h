// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_LOWER_BOUND_FUNCTION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_LOWER_BOUND_FUNCTION_H

// The function on the edges that proves lower bounds of distances (Lower_bound_check.h). On each edge it consists of
// pieces, each the distance from one image, or linear.
//
// It is made of the windows and strips that a propagation has kept: add_paths() collects the corners of a face, and the
// windows and strips on its three sides, Edge_distance_function takes the minimum. They are only a proposal, and may be
// wrong.

#include <CGAL/Surface_mesh_geodesics/internal/certificate/Edge_distance_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// An edge in the frame of another edge: from `origin` in the direction `unit`. at() is the point at an abscissa;
// along() and across() are the abscissa of the foot of a point, and its signed distance from the line, positive on
// the left.
template <typename FT>
struct Side_line
{
  using Point = Planar_point<FT>;

  Point origin, unit;
  FT length;

  Point at(const FT& t) const { return {origin.x + t * unit.x, origin.y + t * unit.y}; }
  FT along(const Point& p) const { return (p.x - origin.x) * unit.x + (p.y - origin.y) * unit.y; }
  FT across(const Point& p) const { return unit.x * (p.y - origin.y) - unit.y * (p.x - origin.x); }
};

// The sides AC and BC in the frame of AB. Require: the side has a length.
template <typename FT>
Side_line<FT> left_side_line(const Face_frame<FT>& c)
{
  const Side_angle<FT> angle = left_angle(c);
  return {{FT(0), FT(0)}, {angle.cosine, angle.sine}, c.left_length};
}

template <typename FT>
Side_line<FT> right_side_line(const Face_frame<FT>& c)
{
  const Side_angle<FT> angle = right_angle(c);
  return {{c.length, FT(0)}, {-angle.cosine, angle.sine}, c.right_length};
}

// The same line in the other direction.
template <typename FT>
Side_line<FT> reversed(const Side_line<FT>& l)
{
  return {l.at(l.length), {-l.unit.x, -l.unit.y}, l.length};
}

// The rays of a strip as a piece. The proof relies on a direction of length 1, which is not taken for granted.
template <typename FT>
Distance_piece<FT> piece_of_strip(const Strip<FT>& s)
{
  using std::abs;
  const FT size = norm<FT>(s.direction_x, s.direction_y);
  return {s.begin, s.end, s.direction_x / size, FT(abs(s.direction_y)) / size, s.distance, true};
}

// Frames: a point, an image or a side is given in the frame of the halfedge whose face is looked at (Face_frame): A is
// the origin, B lies on the x axis, the face lies above. Functions on a side count from its `origin` (Side_line).
// Lengths are in the unit of the intrinsic mesh.
//
// Threads may make parts of a function at the same time, and read it when all of it is made.
template <typename FT_>
class Lower_bound_function
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Piece = Distance_piece<FT>;

  // `distance` has the values at the vertices, infinity where no path is known, `windows` the windows for the values
  // between them, and `strips` those from curves; null if all sources are points. All are referred to, not copied.
  // Requires: the intervals of windows and strips are parts of their edges. Nothing else about them is taken for
  // granted.
  Lower_bound_function(const Mesh& mesh, const std::vector<FT>& distance, const Edge_window_field<FT>& windows,
                       const Edge_strip_field<FT>* strips = nullptr)
    : m_mesh(mesh), m_distance(distance), m_windows(windows), m_strips(strips)
  {}

  const Mesh& mesh() const { return m_mesh; }
  const std::vector<FT>& values() const { return m_distance; }

  // Makes the function on all edges, in a loop of `chunks` (Chunk_team.h) over the faces. Each edge is made in the face
  // of the halfedge for which is_first_of_edge() holds. Returns false if go_on() does. Takes time linear in the number
  // of windows, times the number of pieces of an edge.
  template <typename Chunks, typename GoOn>
  bool make(const Chunks& chunks, GoOn go_on)
  {
    CGAL_assertion(m_distance.size() == m_mesh.number_of_vertices());
    const std::size_t n = m_mesh.number_of_faces();
    m_begin.assign(3 * n, 0);
    m_size.assign(3 * n, 0);
    m_chunk_size = Chunks::chunk_size;
    m_pieces.assign(chunks.number_of_chunks(n), {});
    return chunks(n, go_on, [&](std::size_t c, std::size_t first, std::size_t last, const auto& ask)
    {
      Edge_distance_function<FT> function;
      for(std::size_t f = first; f < last && ask(); ++f)
        for(unsigned int k = 0; k < 3; ++k)
          if(m_mesh.is_first_of_edge(halfedge_of(static_cast<Face_id>(f), k)))
            make_function(halfedge_of(static_cast<Face_id>(f), k), function, m_pieces[c]);
    });
  }

  // Reads the function on the edge of h: in the direction of h, or against it. `pieces` ascend in that direction; they
  // are none if nothing reaches the edge, or if it has no length.
  void read(Halfedge_id h, bool is_backward, std::vector<Piece>& pieces) const
  {
    const bool is_first = m_mesh.is_first_of_edge(h);
    const std::size_t e = dense_index(is_first ? h : m_mesh.opposite(h));
    const std::vector<Piece>& all = m_pieces[e / 3 / m_chunk_size];
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(m_begin[e]);
    pieces.assign(first, first + static_cast<std::ptrdiff_t>(m_size[e]));
    if(is_first != is_backward) // the direction in which the function is stored
      return;
    std::reverse(pieces.begin(), pieces.end());
    for(Piece& p : pieces)
      p = p.backward(m_mesh.length(h));
  }

  // Returns the least value on the edge of h; infinity if nothing reaches it. The function need not have been made: it
  // is made on this edge, with the given memory. Requires: the edge has a length.
  FT least_value(Halfedge_id h, Edge_distance_function<FT>& function) const
  {
    make_function(m_mesh.is_first_of_edge(h) ? h : m_mesh.opposite(h), function);
    FT least = std::numeric_limits<FT>::infinity();
    for(const Piece& p : function.pieces())
      least = (std::min)(least, p.at(p.nearest()));
    return least;
  }

private:
  using Point = Planar_point<FT>;

  // Makes u on one edge: the minimum over the paths that reach it through its two faces, in the direction of h.
  // `function` is reused memory, and `pieces` are those of the chunk. Requires: is_first_of_edge(h).
  void make_function(Halfedge_id h, Edge_distance_function<FT>& function, std::vector<Piece>& pieces)
  {
    make_function(h, function);
    m_begin[dense_index(h)] = pieces.size();
    m_size[dense_index(h)] = function.pieces().size();
    pieces.insert(pieces.end(), function.pieces().begin(), function.pieces().end());
  }

  // The same without keeping the pieces.
  void make_function(Halfedge_id h, Edge_distance_function<FT>& function) const
  {
    function.restart(m_mesh.length(h));
    add_paths(h, false, function);
    if(m_mesh.opposite(h) != null_id)
      add_paths(m_mesh.opposite(h), true, function);
  }

  // Adds the paths that reach the edge of h from its face: from a corner, and through a window or a strip on one of the
  // three edges. (One across h itself comes from the other face, but is known in the frame of h.) If `is_backward`, the
  // function runs against h.
  void add_paths(Halfedge_id h, bool is_backward, Edge_distance_function<FT>& function) const
  {
    const Face_frame<FT> c = m_mesh.face_frame(h);
    auto add = [&](const Piece& p)
    { function.add(is_backward ? p.backward(c.length) : p); };
    auto add_three = [&](const Piece& before, const Piece& p, const Piece& behind)
    {
      if(is_backward)
        function.add(p.backward(c.length), behind.backward(c.length), before.backward(c.length));
      else
        function.add(p, before, behind);
    };
    const std::pair<Vertex_id, Point> corners[3]
      = {{c.origin, {FT(0), FT(0)}}, {c.target, {c.length, FT(0)}}, {c.apex, {c.apex_x, c.apex_y}}};
    for(const std::pair<Vertex_id, Point>& corner : corners)
      if(m_distance[corner.first] < std::numeric_limits<FT>::infinity())
        add({FT(0), c.length, corner.second.x, corner.second.y, m_distance[corner.first]});
    m_windows.for_each_window(h, [&](const Kept_window<FT>& w)
    { add({w.begin, w.end, w.image_x, w.image_depth, m_distance[w.root]}); });
    if(m_strips != nullptr)
      m_strips->for_each_strip(h, [&](const Strip<FT>& s) { add(piece_of_strip(s)); });
    if(c.right_length > 0)
      add_paths_through(next_halfedge(h), right_side_line(c), c.length, add_three);
    if(c.left_length > 0)
      add_paths_through(previous_halfedge(h), reversed(left_side_line(c)), c.length, add_three);
  }

  template <typename Add>
  void add_paths_through(Halfedge_id g, const Side_line<FT>& side, const FT& length, Add add) const
  {
    add_windows_through(g, side, length, add);
    if(m_strips != nullptr)
      m_strips->for_each_strip(g, [&](const Strip<FT>& s) { add_strip_through(piece_of_strip(s), side, length, add); });
  }

  // Does for the rays of a strip on the side what add_windows_through() does for those of a window.
  template <typename Add>
  static void add_strip_through(const Piece& rays, const Side_line<FT>& side, const FT& length, Add add)
  {
    // The face is on the left of the side, where the rays go.
    const Point direction = {rays.x * side.unit.x - rays.depth * side.unit.y,
                             rays.x * side.unit.y + rays.depth * side.unit.x};
    // No ray leads down to the base if they do not fall.
    if(!(direction.y < 0))
      return;
    const Point left = side.at(rays.end), right = side.at(rays.begin);
    const auto seen_on_base = [&](const Point& p)
    { return p.y > 0 ? FT(p.x - p.y * (direction.x / direction.y)) : p.x; };
    const FT first = (std::max)(seen_on_base(left), FT(0)), last = (std::min)(seen_on_base(right), length);
    add(Piece{FT(0), first, left.x, left.y, rays.at(rays.end)},
        Piece{first, last, direction.x, -direction.y,
              rays.offset - (direction.x * side.origin.x + direction.y * side.origin.y), true},
        Piece{last, length, right.x, right.y, rays.at(rays.begin)});
  }

  // Adds the paths of the windows on another side of the face, the halfedge g, to the base, which has the given length.
  // The base is the x axis; `side` is the edge of g in the direction of g, and the windows enter the face across it.
  template <typename Add>
  void add_windows_through(Halfedge_id g, const Side_line<FT>& side, const FT& length, Add add) const
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

  const Mesh& m_mesh;
  const std::vector<FT>& m_distance;
  const Edge_window_field<FT>& m_windows;
  const Edge_strip_field<FT>* m_strips;     // or null
  std::size_t m_chunk_size = 1;             // the number of faces of a chunk
  std::vector<std::vector<Piece>> m_pieces; // by chunk
  std::vector<std::size_t> m_begin, m_size; // of the pieces of an edge, by its first halfedge (dense_index)
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_LOWER_BOUND_FUNCTION_H
