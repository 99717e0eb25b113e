// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_CORNER_EMISSION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_CORNER_EMISSION_H

// The windows that a vertex of a curve emits.
//
// No shortest path leaves a vertex of the curve at an angle of less than a right angle to an edge of the curve: going a
// little way along that edge would make it shorter. These paths belong to strips. So each window is trimmed to the
// directions between the normals of the edges around, and at most vertices of a smooth curve hardly a window is left.
//
// Proof. Let the path leave the vertex v at an angle of less than a right angle to the edge vw of the curve, measured
// through the faces between them. For a point p of the edge near v, and a point q of the path near v, the straight line
// from p to q in these faces is shorter than vq if |vp| is small enough (law of cosines). The rest of the path is the
// same, and p is a point of the curve with the offset of the edge. So the path is not the shortest from the curve, if
// the offset of the edge is not greater than that of v.
//
// The directions at exactly a right angle belong to both: the strip of the edge has a ray along the normal, and so has
// a window that ends there. Where no gap between the normals is left, the strips on both sides meet at their first
// rays.
//
// The sum of angles in front of a vertex counts, whatever the angles are; umbrellas of a pinched vertex do not know of
// each other. The directions of a degenerate vertex carry no information: it emits like any other source.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_of_pseudo_source.h>

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

// An object serves all vertices of a run; it keeps buffers only.
template <typename FT>
class Corner_emission
{
  using Mesh = Intrinsic_mesh<FT>;

public:
  // The mesh has to outlive this object.
  explicit Corner_emission(const Mesh& mesh) : m_mesh(mesh) {}

  // Sets the edges of all curves. Takes the time of sorting them.
  void set_edges(const std::vector<Source_edge<FT>>& edges)
  {
    m_edges.clear();
    for(const Source_edge<FT>& e : edges)
      for(const Halfedge_id h : {e.left, e.right})
        if(h != null_id)
          m_edges.emplace_back(h, e.offset);
    std::sort(m_edges.begin(), m_edges.end());
  }

  // Does an edge of a curve with an offset of at most d begin or end at v? Edges with a larger one leave paths alone.
  bool is_on_edge(Vertex_id v, const FT& d) const
  {
    bool is_on = false;
    m_mesh.for_each_halfedge_around(
      v, [&](Halfedge_id h) { is_on = is_on || is_source_edge(h, d) || is_source_edge(previous_halfedge(h), d); });
    return is_on;
  }

  // Calls emit(h, window) for each window that v emits, with the halfedge that it is about to enter. d is the distance
  // of v. Takes time linear in the degree, and logarithmic in the number of edges of curves.
  template <typename Emit>
  void for_each_window(Vertex_id v, const FT& d, Emit emit)
  {
    m_mesh.for_each_umbrella(v, [&](Halfedge_id first)
    {
      find_corners(first, d);
      for(const Corner& c : m_corners)
        emit_into(c, d, emit);
    });
  }

private:
  // A face around the vertex. `before` and `after` are the angles from its two edges at the vertex to the next edge of
  // a curve, clockwise and counterclockwise; infinite if there is none.
  struct Corner
  {
    Halfedge_id halfedge;
    FT angle, before, after;
  };

  static FT right_angle() { return FT(1.57079632679489661923); }

  // Directions that rounding may have moved across a normal: the square root of rounding, as where a path that turns by
  // such an angle has the same length.
  static FT margin() { return 16 * Tolerance<FT>::closeness(); }

  // Is h a halfedge of an edge of a curve with an offset of at most d?
  bool is_source_edge(Halfedge_id h, const FT& d) const
  {
    const auto it = std::lower_bound(m_edges.begin(), m_edges.end(), h,
                                     [](const std::pair<Halfedge_id, FT>& e, Halfedge_id g) { return e.first < g; });
    return it != m_edges.end() && it->first == h && it->second <= d;
  }

  // Finds the corners of the umbrella that begins with a halfedge, counterclockwise. An umbrella with a border is not
  // closed: beyond the border there is no edge, and no direction. The sums of angles are those of a few corners, and
  // the margin is far above their rounding.
  void find_corners(Halfedge_id first, const FT& d)
  {
    using std::atan2;
    const FT infinity = std::numeric_limits<FT>::infinity();
    m_corners.clear();
    Halfedge_id h = first;
    do
    {
      const std::pair<FT, FT> direction = angle_direction(m_mesh.face(face_of(h)), index_in_face(h));
      m_corners.push_back(Corner{h, FT(atan2(direction.second, direction.first)), infinity, infinity});
      h = m_mesh.next_around_source(h);
    } while(h != first && h != null_id);
    // Twice around a closed umbrella, so that angles across its beginning are counted as well.
    const std::size_t n = m_corners.size(), steps = h == null_id ? n : 2 * n;
    FT angle = infinity;
    for(std::size_t i = 0; i < steps; ++i)
    {
      Corner& c = m_corners[i % n];
      angle = is_source_edge(c.halfedge, d) ? FT(0) : angle;
      c.before = angle;
      angle += c.angle;
    }
    angle = infinity;
    for(std::size_t i = steps; i-- > 0;)
    {
      Corner& c = m_corners[i % n];
      angle = is_source_edge(previous_halfedge(c.halfedge), d) ? FT(0) : angle;
      c.after = angle;
      angle += c.angle;
    }
  }

  // A gap between two normals that is narrower than rounding holds the normals themselves only: it is left to the
  // strips. Emits the window onto the edge opposite to a corner, trimmed to the directions from `first` to `last`,
  // which count from the first edge of the corner.
  template <typename Emit>
  void emit_into(const Corner& corner, const FT& d, Emit emit) const
  {
    const Halfedge_id va = corner.halfedge, beyond = m_mesh.opposite(next_halfedge(va));
    const Face_frame<FT> c = m_mesh.face_frame(next_halfedge(va)); // of the edge ab; the apex is the vertex
    if(beyond == null_id || !(c.length > 0))
      return;
    FT first = right_angle() - corner.before, last = corner.angle - (right_angle() - corner.after);
    if((first > 0 || last < corner.angle) && !(last - first > Tolerance<FT>::direction()))
      return;
    first = first - margin();
    last = last + margin();
    Window<FT> w;
    window_of_pseudo_source<FT>(c, d, FT(d + c.right_length), FT(d + c.left_length), w);
    // On the halfedge ba, abscissas count from b, the last direction.
    if(last < corner.angle)
      trim_begin(w, c.length * (1 - fraction(c, corner.angle, last)));
    if(first > 0)
      trim_end(w, c.length * (1 - fraction(c, corner.angle, first)));
    if(w.begin < w.end)
      emit(beyond, w);
  }

  // Move an end of the interval inwards to x, with its distance. An x outside changes nothing.
  static void trim_begin(Window<FT>& w, const FT& x)
  {
    if(!(x > w.begin))
      return;
    w.begin = x;
    w.begin_distance = w.distance_at(x);
  }

  static void trim_end(Window<FT>& w, const FT& x)
  {
    if(!(x < w.end))
      return;
    w.end = x;
    w.end_distance = w.distance_at(x);
  }

  // Returns the fraction of the edge from a at which a direction from the vertex meets it. Formula: the areas of the
  // two triangles that the direction cuts off. Requires: 0 <= direction <= angle.
  static FT fraction(const Face_frame<FT>& c, const FT& angle, const FT& direction)
  {
    using std::sin;
    const FT t = (std::min)((std::max)(direction, FT(0)), angle);
    const FT to_a = c.left_length * sin(t), to_b = c.right_length * sin(angle - t);
    return to_a + to_b > 0 ? FT(to_a / (to_a + to_b)) : FT(0);
  }

  const Mesh& m_mesh;
  std::vector<std::pair<Halfedge_id, FT>> m_edges; // the halfedges of all source edges with their offsets, sorted
  std::vector<Corner> m_corners;                   // of the umbrella that is looked at
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_CORNER_EMISSION_H
