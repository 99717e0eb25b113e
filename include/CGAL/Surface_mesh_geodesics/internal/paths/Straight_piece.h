// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_STRAIGHT_PIECE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_STRAIGHT_PIECE_H

// A straight piece of a shortest path, followed from its end to its pseudo-source by unfolding: the image
// of the pseudo-source is carried from face to face, and the line to the image tells which edge comes next.
// As soon as the pseudo-source is a corner of the face that the line enters, the piece ends there: no
// shortest path passes through a face of its own end to reach it from another side.
//
// Rounding. On which side of a vertex the line passes cannot always be told, and on the wrong side of one
// that is not flat the line never meets its end. But where the line passes so near to a vertex, the distance
// of the vertex tells whether the path may just as well run through it: if that makes it no longer, the
// piece ends at the vertex. This needs no decision about sides, and is right wherever the line may be. (The
// path through the vertex is longer than the straight one by the square of the shift, in theory.)
//
// The distances of all vertices that the line passes are compared with what remains of the way. So a line
// that has gone astray is found out at once.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A point of a path: a vertex, or the point at the length x from the source of a halfedge. The path comes
// there in `face` (null_id for the first point), and `gap` is its length from the point before, which may be
// zero where edges have no length or faces no area.
template <typename FT>
struct Path_step
{
  Vertex_id vertex = null_id;
  Halfedge_id halfedge = null_id;
  Face_id face = null_id;
  FT x = 0, gap = 0;
};

template <typename FT>
using Path_steps = std::vector<Path_step<FT>>;

// the point at the length x from the source of h, to which the path comes in the face of h.
template <typename FT>
Path_step<FT> step_on_edge(const Intrinsic_mesh<FT>& mesh, Halfedge_id h, const FT& x)
{
  Path_step<FT> step;
  if(x > 0 && x < mesh.length(h))
  {
    step.halfedge = h;
    step.x = x;
  }
  else
    step.vertex = x > 0 ? mesh.target(h) : mesh.source(h);
  step.face = face_of(h);
  return step;
}

// Where a piece begins: at the point (x, y) in the frame of a halfedge, in the face of it. The piece runs
// through the point `abscissa` of the halfedge to the image of `root` at (image_x, -image_depth); `distance`
// is that of the point.
template <typename FT>
struct Piece_start
{
  Halfedge_id halfedge;
  FT x, y, abscissa, image_x, image_depth;
  Vertex_id root;
  FT distance;
};

template <typename FT>
class Straight_piece
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // Points are appended to `steps`. Tolerances are relative to the longest length that the line meets, which is
  // taken to be at least smallest_scale.
  Straight_piece(const Mesh& mesh, const Field& field, const FT& smallest_scale, Path_steps<FT>& steps)
    : m_mesh(mesh), m_field(field), m_smallest_scale(smallest_scale), m_steps(steps)
  {}

  // follows a piece to the vertex where it ends, which is returned; null_id if it goes astray.
  Vertex_id trace(const Piece_start<FT>& start)
  {
    m_start = start;
    m_length = 0;
    m_scale = m_smallest_scale;
    State s = first_state();
    if(m_end != null_id)
      return has_right_length() ? m_end : null_id;
    for(std::size_t i = 0; i <= m_mesh.most_faces_crossed(); ++i)
    {
      const Halfedge_id o = m_mesh.opposite(s.halfedge);
      if(o == null_id)
        return null_id;
      const Face_frame<FT> c = m_mesh.face_frame(o);
      turn(c, s);
      if(!pass_apex(o, c, s))
        return null_id;
      if(m_end != null_id)
        return has_right_length() ? m_end : null_id;
      s = next_state(o, c, s);
      add_crossing(s.halfedge, s.abscissa);
    }
    return null_id;
  }

private:
  // Where the line is: at the point `abscissa` of `halfedge`, about to leave the face of the halfedge
  // across it; the image of the pseudo-source is at (image_x, image_y) in its frame, with image_y <= 0.
  // turn() turns it into the frame of the opposite halfedge.
  struct State
  {
    Halfedge_id halfedge;
    FT abscissa, image_x, image_y;
  };

  static void turn(const Face_frame<FT>& c, State& s)
  {
    s.abscissa = c.length - s.abscissa;
    s.image_x = c.length - s.image_x;
    s.image_y = -s.image_y;
  }

  // the state where the line leaves the first face. The piece may end in that face already.
  State first_state()
  {
    const Halfedge_id h = m_start.halfedge;
    const FT length = m_mesh.length(h);
    const State s{h, m_start.abscissa, m_start.image_x, -m_start.image_depth};
    const FT inside = norm<FT>(m_start.x - s.abscissa, m_start.y);
    const FT outside = norm<FT>(s.image_x - s.abscissa, s.image_y);
    meet((std::max)(inside + outside, (std::max)(length, m_start.distance)));
    // the sine of the smaller one of the angles at which the line meets the edge
    const FT sine = (std::min)(inside > 0 ? FT(m_start.y / inside) : FT(0),
                               outside > 0 ? FT(-s.image_y / outside) : FT(0));
    for(const Vertex_id v : {m_mesh.source(h), m_mesh.target(h)})
    {
      using std::abs;
      const FT x = v == m_mesh.source(h) ? FT(0) : length, gap = norm<FT>(m_start.x - x, m_start.y);
      const bool is_near = abs(FT(x - s.abscissa)) * sine <= sideways();
      if(v == m_start.root || (is_near && may_run_through(v, gap)))
      {
        end_at(v, face_of(h), gap);
        return s;
      }
    }
    m_gap = inside;
    add_crossing(h, s.abscissa);
    return s;
  }

  // looks at the third corner of the face that the line enters. The piece may end there. Returns false if
  // its distance tells that the line has gone astray.
  bool pass_apex(Halfedge_id o, const Face_frame<FT>& c, const State& s)
  {
    using std::abs;
    const FT dx = c.apex_x - s.abscissa, ix = s.image_x - s.abscissa;
    const FT squared_gap = dx * dx + c.apex_y * c.apex_y;
    meet((std::max)(c.left_length, c.right_length));
    const FT area = dx * s.image_y - c.apex_y * ix;
    const FT reach = sideways();
    if(c.apex == m_start.root || area * area <= reach * reach * (ix * ix + s.image_y * s.image_y))
    {
      using std::sqrt;
      const FT gap = sqrt(squared_gap);
      if(c.apex == m_start.root || may_run_through(c.apex, gap))
      {
        end_at(c.apex, face_of(o), gap);
        return true;
      }
    }
    const FT excess = abs(FT(m_field.distance[c.apex] - rest())) - slack();
    return excess <= 0 || excess * excess <= squared_gap;
  }

  // from the edge to the next one, through the face of o. The image lies on this side of C, and beyond the edge.
  // Very near to the image the first is next to unknown, and the second decides.
  State next_state(Halfedge_id o, const Face_frame<FT>& c, const State& s)
  {
    const bool has_left = c.left_length > 0, has_right = c.right_length > 0;
    const bool is_left = has_left
                      && (!has_right
                          || (c.apex_x - s.abscissa) * s.image_y - c.apex_y * (s.image_x - s.abscissa) > 0);
    Edge_view view = is_left ? left_view(c, s) : right_view(c, s);
    State n;
    n.halfedge = is_left ? previous_halfedge(o) : next_halfedge(o);
    if(view.image_y > 0 && has_left && has_right)
    {
      const Edge_view other = is_left ? right_view(c, s) : left_view(c, s);
      if(other.image_y < view.image_y)
      {
        view = other;
        n.halfedge = is_left ? next_halfedge(o) : previous_halfedge(o);
      }
    }
    n.image_x = view.image_x;
    n.image_y = (std::min)(view.image_y, FT(0));
    const FT height = view.y - n.image_y;
    const FT abscissa = height > 0 ? FT(view.x + (n.image_x - view.x) * (view.y / height)) : n.image_x;
    n.abscissa = (std::min)((std::max)(abscissa, FT(0)), view.length);
    m_gap = m_gap + norm<FT>(view.x - n.abscissa, view.y);
    return n;
  }

  // The point where the line is and the image, in the frame of one of the two next edges.
  struct Edge_view
  {
    FT length, x, y, image_x, image_y;
  };

  // zero where all edges of a face have no length
  static FT inverse_of(const FT& length) { return length > 0 ? FT(1 / length) : FT(0); }

  // from C to A
  static Edge_view left_view(const Face_frame<FT>& c, const State& s)
  {
    const FT inverse = inverse_of(c.left_length);
    return edge_view(c.left_length, c.apex_x, c.apex_y, -c.apex_x * inverse, -c.apex_y * inverse, s);
  }

  // from B to C
  static Edge_view right_view(const Face_frame<FT>& c, const State& s)
  {
    const FT inverse = inverse_of(c.right_length);
    return edge_view(c.right_length, c.length, FT(0), -c.apex_rest * inverse, c.apex_y * inverse, s);
  }

  // in the frame with the origin (x, y) and the axis (cosine, sine)
  static Edge_view edge_view(const FT& length, const FT& x, const FT& y, const FT& cosine, const FT& sine,
                             const State& s)
  {
    const FT px = s.abscissa - x, ix = s.image_x - x, iy = s.image_y - y;
    return {length, FT(px * cosine - y * sine), FT(-px * sine - y * cosine), FT(ix * cosine + iy * sine),
            FT(iy * cosine - ix * sine)};
  }

  // May the line run through a vertex that it passes very near, without becoming longer? The vertex is at the
  // distance `gap`. Where several sources are at the same distance, the path has to go on to the one that is reported.
  bool may_run_through(Vertex_id v, const FT& gap) const
  {
    return m_field.distance[v] < m_start.distance && gap + m_field.distance[v] <= rest() + slack()
        && m_field.source_of(v) == m_field.source_of(m_start.root);
  }

  // what remains of the way
  FT rest() const { return m_start.distance - m_length - m_gap; }

  // the distance at which the line cannot be told from a vertex
  FT sideways() const { return Tolerance<FT>::sideways() * m_scale; }

  void meet(const FT& length) { m_scale = (std::max)(m_scale, length); }

  // what rounding may make of lengths and distances
  FT slack() const { return Tolerance<FT>::lengthwise() * m_scale; }

  bool has_right_length() const
  {
    using std::abs;
    const FT error = m_length + m_field.distance[m_end] - m_start.distance;
    return abs(error) <= Tolerance<FT>::path() * m_start.distance + slack();
  }

  void add_crossing(Halfedge_id h, const FT& x)
  {
    Path_step<FT> step = step_on_edge(m_mesh, h, x);
    add(step);
  }

  void end_at(Vertex_id v, Face_id f, const FT& gap)
  {
    Path_step<FT> step;
    step.vertex = v;
    step.face = f;
    m_gap = gap;
    add(step);
    m_end = v;
  }

  void add(Path_step<FT>& step)
  {
    step.gap = m_gap;
    m_length = m_length + m_gap;
    m_gap = 0;
    m_steps.push_back(step);
  }

  const Mesh& m_mesh;
  const Field& m_field;
  FT m_smallest_scale;
  Path_steps<FT>& m_steps;
  Piece_start<FT> m_start{};
  FT m_scale = 0;  // of the lengths that have been rounded
  FT m_length = 0; // of the piece, so far
  FT m_gap = 0;    // from the last step
  Vertex_id m_end = null_id;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_STRAIGHT_PIECE_H
