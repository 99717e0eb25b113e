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

// A straight piece of a shortest path, followed from its end back to its pseudo-source. The faces on the way are laid
// out in one plane (unfolding, thesis 3.3.1): the image of the pseudo-source is carried from face to face, and the line
// to the image shows which edge comes next. As soon as the pseudo-source is a corner of the face that the line enters,
// the piece ends there, by the straight way in that face. On a surface with points no way is shorter, as this one is a
// segment in space. If lengths are given, the path may leave the face and come to the corner through others
// (Intrinsic_mesh::most_faces_crossed()). Then the piece is too long, trace() finds that out, and path_tracing.h looks
// for the path by its length.
//
// The image is turned as in surface/unfolding.h, but by other operations and so with other bits: this file multiplies
// by the inverse of the length, and takes the right side from B to C.
//
// Rounding. On which side of a vertex the line passes cannot always be decided, and on the wrong side of a vertex that
// is not flat the line never meets its end. Where the line passes so near to a vertex, the distance of the vertex shows
// whether the path may as well run through it: if that makes the path no longer, the piece ends at the vertex. This
// needs no decision about sides, and is right on whichever side the line lies. (In exact numbers, a path through a
// vertex at the distance s from the line is longer than the line by the order of s squared.)
//
// The distance of each vertex that the line passes is compared with the rest of the way, so a wrong line is detected at
// once. Straight_piece promises this: if trace() returns a vertex, the points that it has appended lie on the surface,
// points that follow each other share a face, and the length is right up to Tolerance::path() and
// Tolerance::lengthwise().

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A point of a path: a vertex, or, if `vertex` is null_id, the point at the abscissa x of a halfedge.
//
// Invariants: 0 < x < length of the halfedge; gap >= 0. The gap may be zero where edges have no length or faces no
// area.
template <typename FT>
struct Path_step
{
  Vertex_id vertex = null_id;
  Halfedge_id halfedge = null_id;
  Face_id face = null_id; // through which the path arrives; null_id for the first point
  FT x = 0;
  FT gap = 0; // the length of the path from the point before
};

template <typename FT>
using Path_steps = std::vector<Path_step<FT>>;

// Returns the sum of the gaps.
template <typename FT>
FT length_of(const Path_steps<FT>& steps)
{
  FT length = 0;
  for(const Path_step<FT>& step : steps)
    length = length + step.gap;
  return length;
}

// Returns the point at the abscissa x of h, at which the path arrives through the face of h. An abscissa at or beyond
// an end of the edge gives the vertex there.
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

// Where a piece begins: at the point (x, y) of the face of `halfedge`, in the frame of that halfedge. The piece runs
// through the point `abscissa` of the halfedge to the image of `root` at (image_x, -image_depth). `distance` is the
// distance of the point from its source. If `side` is not null_id, there is no root: the piece runs to the foot of a
// ray, and ends where it leaves the face on that side of a source edge.
//
// Invariants: y >= 0, image_depth >= 0, distance is finite; one of `root` and `side` is null_id.
template <typename FT>
struct Piece_start
{
  Halfedge_id halfedge;
  FT x, y, abscissa, image_x, image_depth;
  Vertex_id root;
  FT distance;
  std::uint32_t side = null_id;
};

// Names the source of a path: a vertex, or, if curves are among the sources, the number of a curve; null_id if the root
// is not reached. If `side` is not null_id, the path ends on that side of a source edge, and has no root.
template <typename FT>
std::uint32_t source_of_path(const Vertex_distance_field<FT>& field, const Curve_arrivals<FT>* curves, Vertex_id root,
                             std::uint32_t side = null_id)
{
  if(side != null_id)
    return curves->edge_of_side(side).curve;
  const Vertex_id v = field.source_of(root);
  return curves == nullptr || v == null_id ? v : curves->point_of(field, v).curve;
}

// Where a piece has ended: at a vertex, or at the foot of a ray on a source edge, where the path ends, too. If neither,
// the line was wrong. The foot itself is the last step: the point where the line meets the edge. It need not be where
// the propagation has noted it, as the line is the better known one of both.
struct Piece_end
{
  Vertex_id vertex = null_id;
  bool is_at_foot = false;

  bool is_found() const { return vertex != null_id || is_at_foot; }
};

template <typename FT>
class Straight_piece
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // Points are appended to `steps`. Tolerances are relative to the longest length on the way, but at least to
  // `smallest_scale`. `curves` is null if all sources are points.
  Straight_piece(const Mesh& mesh, const Field& field, const FT& smallest_scale, Path_steps<FT>& steps,
                 const Curve_arrivals<FT>* curves = nullptr)
    : m_mesh(mesh), m_field(field), m_curves(curves), m_smallest_scale(smallest_scale), m_steps(steps)
  {}

  // Follows a piece. Returns where it ends: at the root or another vertex of the path, or at the foot. If the line is
  // wrong, the steps that were appended are meaningless. Call it once.
  // Complexity: linear in the number of faces crossed, of which there are at most mesh.most_faces_crossed() + 1.
  Piece_end trace(const Piece_start<FT>& start)
  {
    CGAL_assertion(start.halfedge != null_id && (start.root == null_id) != (start.side == null_id));
    CGAL_assertion(start.side == null_id || m_curves != nullptr);
    CGAL_assertion(start.y >= 0 && start.image_depth >= 0 && start.distance < Field::infinity());
    m_start = start;
    m_length = 0;
    m_scale = m_smallest_scale;
    m_last_halfedge = start.side == null_id ? null_id : halfedge_of_side(m_curves->curves, start.side);
    State s = first_state();
    for(std::size_t i = 0; i <= m_mesh.most_faces_crossed(); ++i)
    {
      if(m_end != null_id || s.halfedge == m_last_halfedge)
        return end_of_right_length();
      const Halfedge_id o = m_mesh.opposite(s.halfedge);
      if(o == null_id)
        return {};
      const Face_frame<FT> c = m_mesh.face_frame(o);
      turn(c, s);
      if(!pass_apex(o, c, s))
        return {};
      if(m_end != null_id)
        return end_of_right_length();
      s = next_state(o, c, s);
      add_crossing(s.halfedge, s.abscissa);
    }
    return {};
  }

private:
  // Where the line is: at the point `abscissa` of `halfedge`, about to leave the face of the halfedge across it. The
  // image of the pseudo-source is at (image_x, image_y) in the frame of the halfedge.
  // Invariant: image_y <= 0. After turn(), in the frame of the opposite halfedge, image_y >= 0.
  struct State
  {
    Halfedge_id halfedge;
    FT abscissa, image_x, image_y;
  };

  // Changes to the frame of the opposite halfedge: a rotation by pi about the middle of the edge.
  static void turn(const Face_frame<FT>& c, State& s)
  {
    s.abscissa = c.length - s.abscissa;
    s.image_x = c.length - s.image_x;
    s.image_y = -s.image_y;
  }

  // Returns the state in which the line leaves the first face. The piece may end in that face already; then m_end is
  // set.
  State first_state()
  {
    const Halfedge_id h = m_start.halfedge;
    const FT length = m_mesh.length(h);
    const State s{h, m_start.abscissa, m_start.image_x, -m_start.image_depth};
    const FT inside = norm<FT>(m_start.x - s.abscissa, m_start.y);
    const FT outside = norm<FT>(s.image_x - s.abscissa, s.image_y);
    use_length((std::max)(inside + outside, (std::max)(length, m_start.distance)));
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

  // Looks at the apex C of the face that the line enters. The piece ends there if C is the root, or if the line passes
  // within sideways() of C and may run through it. Returns false if the distance of C shows that the line is
  // wrong: it differs from the rest of the way by more than the gap between the line and C.
  //
  // The distance of C from the line from P to the image I is |(C-P) x (I-P)| / |I-P|; both sides are multiplied by
  // |I-P| and squared, which needs no root. sideways() stands for the error of the image: Tolerance::distance() derives
  // its bound, and Tolerance::sideways() says how many faces it covers.
  bool pass_apex(Halfedge_id o, const Face_frame<FT>& c, const State& s)
  {
    using std::abs;
    const FT dx = c.apex_x - s.abscissa, ix = s.image_x - s.abscissa;
    const FT squared_gap = dx * dx + c.apex_y * c.apex_y;
    use_length((std::max)(c.left_length, c.right_length));
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

  // Moves through the face of o, to its left side if C lies on the right of the line, and else to its right side. A
  // line through C goes right. Very near to the image this sign is nearly unknown; if the image then lies above the
  // line of the side, the other side counts if it has the lower image.
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
    CGAL_expensive_assertion(n.abscissa >= 0 && n.abscissa <= m_mesh.length(n.halfedge) && n.image_y <= 0);
    return n;
  }

  // The point (x, y) where the line is, and the image, in the frame of one of the two next edges.
  struct Edge_view
  {
    FT length, x, y, image_x, image_y;
  };

  // Returns zero where no edge of a face has a length.
  static FT inverse_of(const FT& length) { return length > 0 ? FT(1 / length) : FT(0); }

  // The frame of the left side, from C to A. It differs from the text of unfolding.h in two ways that show in the bits:
  // the axis is multiplied by the inverse of the length, which exists for a length of zero as well, and the right side
  // is not the mirror image of the left one.
  static Edge_view left_view(const Face_frame<FT>& c, const State& s)
  {
    const FT inverse = inverse_of(c.left_length);
    return edge_view(c.left_length, c.apex_x, c.apex_y, -c.apex_x * inverse, -c.apex_y * inverse, s);
  }

  // The frame of the right side, from B to C.
  static Edge_view right_view(const Face_frame<FT>& c, const State& s)
  {
    const FT inverse = inverse_of(c.right_length);
    return edge_view(c.right_length, c.length, FT(0), -c.apex_rest * inverse, c.apex_y * inverse, s);
  }

  // Changes to the frame with the origin (x, y) and the axis (cosine, sine).
  static Edge_view edge_view(const FT& length, const FT& x, const FT& y, const FT& cosine, const FT& sine,
                             const State& s)
  {
    const FT px = s.abscissa - x, ix = s.image_x - x, iy = s.image_y - y;
    return {length, FT(px * cosine - y * sine), FT(-px * sine - y * cosine), FT(ix * cosine + iy * sine),
            FT(iy * cosine - ix * sine)};
  }

  // Returns whether the path may run through v, which the line passes very near and which is at the distance `gap`: its
  // distance makes the path no longer, up to slack(). Where several sources are equally far, v must have the source
  // that is reported.
  //
  // Formula: gap + distance(v) <= rest() + slack(), and distance(v) < the distance of the start, so that the path comes
  // nearer to the source with each piece. Frame: none; it compares distances. Ties: a path that is equally long runs
  // through v; a vertex as far away as the start is rejected. Error: rest() is a difference of sums, which round once
  // for each step; slack() covers the rounding of one image and one frame, not that of all steps. No bound is known for
  // many steps. A wrong answer cannot give a wrong path: has_right_length() compares the sum of the pieces with the
  // distance.
  // Laws: monotone in gap; scaling all lengths by a power of two keeps the answer.
  bool may_run_through(Vertex_id v, const FT& gap) const
  {
    return m_field.distance[v] < m_start.distance && gap + m_field.distance[v] <= rest() + slack()
        && source_of_path(m_field, m_curves, v)
             == source_of_path(m_field, m_curves, m_start.root, m_start.side);
  }

  // The rest of the way, from the last step to the source.
  FT rest() const { return m_start.distance - m_length - m_gap; }

  // Below this distance a line and a vertex count as one.
  FT sideways() const { return Tolerance<FT>::sideways() * m_scale; }

  // Notes a length that enters the computation.
  void use_length(const FT& length) { m_scale = (std::max)(m_scale, length); }

  // The error that rounding may cause in lengths and distances.
  FT slack() const { return Tolerance<FT>::lengthwise() * m_scale; }

  Piece_end end_of_right_length() const
  {
    return has_right_length() ? Piece_end{m_end, m_end == null_id} : Piece_end();
  }

  bool has_right_length() const
  {
    using std::abs;
    const FT behind = m_end != null_id ? m_field.distance[m_end] : m_curves->edge_of_side(m_start.side).offset;
    const FT error = m_length + behind - m_start.distance;
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
    CGAL_expensive_assertion(m_gap >= 0);
    step.gap = m_gap;
    m_length = m_length + m_gap;
    m_gap = 0;
    m_steps.push_back(step);
  }

  const Mesh& m_mesh;
  const Field& m_field;
  const Curve_arrivals<FT>* m_curves;
  FT m_smallest_scale;
  Path_steps<FT>& m_steps;
  Piece_start<FT> m_start{};
  Halfedge_id m_last_halfedge = null_id; // where a piece to a foot ends
  FT m_scale = 0;  // the longest length that has been rounded
  FT m_length = 0; // of the piece, so far
  FT m_gap = 0;    // from the last step to the line
  Vertex_id m_end = null_id;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_STRAIGHT_PIECE_H
