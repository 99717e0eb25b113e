// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_SECTOR_BETWEEN_NORMALS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_SECTOR_BETWEEN_NORMALS_H

// The directions in which a vertex of a source curve emits windows.
//
// No shortest path leaves such a vertex at less than a right angle to an edge of the curve, because points of that edge
// are nearer (manual, Theory, "Corners"). What is left lies between the normals of the curve: where the angle on a side
// of the curve is less than pi, nothing, and otherwise as much as it is more than pi. The strips of the edges have all
// the rest, so the windows end at the normals, too, and a little behind them (Tolerance::beside_normal()).

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Angle_sum.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_halfedges.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Adds the angle of the face of h at the source of h. (Inlined by force: where no sum exceeds a full turn, the compiler
// leaves out how turns are counted.)
template <typename FT>
BOOST_FORCEINLINE void add_corner(const Intrinsic_mesh<FT>& mesh, Halfedge_id h, Angle_sum<FT>& angle)
{
  const std::pair<FT, FT> corner = angle_direction(mesh.face(face_of(h)), index_in_face(h));
  angle.add(corner.first, corner.second);
}

// The sector of one vertex at a time: the buffer is reused. Invariant: after find(star) there is a part of the opposite
// edge for each face of the star, until the next call of find(). Complexity: each vertex of a curve is looked at once,
// so all calls together are linear in the number of faces that touch the curves, times a logarithm.
template <typename FT>
class Sector_between_normals
{
  using Mesh = Intrinsic_mesh<FT>;
  using Star = Vertex_star<FT>;
  using Flags = std::vector<unsigned char>; // by face of a star

public:
  explicit Sector_between_normals(const Mesh& mesh) : m_mesh(mesh) {}

  // Tells the edges of all curves. The last call counts.
  void set_source_edges(const std::vector<Source_edge<FT>>& edges) { m_source_halfedges.set(edges); }

  // Is there no curve?
  bool empty() const { return m_source_halfedges.empty(); }

  // Finds the sector of the vertex of a star, and clears the flags of the faces that are outside. Takes time linear in
  // the number of faces, and logarithmic in that of edges of curves for each. Requires: the vertex is a source and not
  // pinched; all flags are set.
  //
  // Directions a little beyond a normal stay, if there are any between the normals (Tolerance::beside_normal()). Where
  // the curve is straight, the two normals are one ray, and the strips on both sides meet there.
  void find(const Star& star, Flags& is_in_sector)
  {
    m_slope = -Tolerance<FT>::angle();
    take_out_quarters(star, is_in_sector);
    if(is_empty(star, is_in_sector))
    {
      is_in_sector.assign(star.faces.size(), 0);
      return;
    }
    is_in_sector.assign(star.faces.size(), 1);
    m_slope = Tolerance<FT>::beside_normal();
    take_out_quarters(star, is_in_sector);
  }

  // Trims a window of the vertex to its sector, and returns whether there is any of it. The window lies on the whole
  // edge, of the given length, opposite to the vertex in a face, which is given by its index in the star.
  bool trim(std::size_t face, const FT& length, Window<FT>& w) const
  {
    if(is_too_close_to_trim(w, length))
      return true;
    // An end that is moved gets the distance of the ray there; the other ones keep theirs, which are those along the
    // sides of the face.
    const Edge_part& part = m_parts[face];
    const FT begin = part.begin, end = (std::min)(w.end, FT(length - part.rest));
    if(!(begin < end))
      return false;
    if(begin > 0)
    {
      w.begin = begin;
      w.begin_distance = w.distance_at(begin);
    }
    if(end < w.end)
    {
      w.end = end;
      w.end_distance = w.distance_at(end);
    }
    return true;
  }

private:
  // The part of the edge ba, opposite to the vertex, that is in the sector: from the abscissa `begin` to where `rest`
  // is left up to its end.
  struct Edge_part
  {
    FT begin = 0, rest = 0;
  };

  // Is a halfedge on a curve whose points are as near as the vertex? A vertex that is nearer than the curve, because
  // another source is there, emits in all directions.
  bool is_source_edge(Halfedge_id h, const Star& star) const
  {
    const FT* const offset = m_source_halfedges.offset(h);
    return offset != nullptr && !(star.distance < *offset);
  }

  // Takes out the directions within a right angle of each edge of a curve at the vertex, less the slope. Quarters may
  // overlap: of two that end in one face, the larger part counts.
  void take_out_quarters(const Star& star, Flags& is_in_sector)
  {
    m_parts.assign(star.faces.size(), Edge_part());
    for(std::uint32_t f = 0; f < star.faces.size(); ++f)
    {
      const Halfedge_id va = star.faces[f].halfedge;
      if(is_source_edge(va, star))
        take_out_quarter(star, f, &Star_face<FT>::next, is_in_sector);
      if(is_source_edge(previous_halfedge(va), star))
        take_out_quarter(star, f, &Star_face<FT>::previous, is_in_sector);
    }
  }

  // Takes out the directions within a right angle of a side of the face `first`, on the side of this face: faces that
  // lie there wholly, and a part of the next one. `next` leads counterclockwise from va, or clockwise from vb.
  void take_out_quarter(const Star& star, std::uint32_t first, std::uint32_t Star_face<FT>::*next, Flags& is_in_sector)
  {
    Angle_sum<FT> before; // of the side of face f that is met first
    std::uint32_t f = first;
    do
    {
      Angle_sum<FT> behind = before;
      add_corner(m_mesh, star.faces[f].halfedge, behind);
      if(!(behind.sine >= 0 && behind.cosine > m_slope * behind.sine))
      {
        take_out_part(star.faces[f].halfedge, before, next == &Star_face<FT>::next, m_parts[f]);
        return;
      }
      is_in_sector[f] = 0;
      before = behind;
      f = star.faces[f].*next;
    } while(f != null_id && f != first && !begins_at_source_edge(star, f, next));
  }

  // Is the side of face f that is met first on a curve? What lies beyond is in the quarter of that side, so that each
  // face is met once in each direction.
  bool begins_at_source_edge(const Star& star, std::uint32_t f, std::uint32_t Star_face<FT>::*next) const
  {
    const Halfedge_id va = star.faces[f].halfedge;
    return is_source_edge(next == &Star_face<FT>::next ? va : previous_halfedge(va), star);
  }

  // Takes out the part of a face up to the normal, which is pi/2 from the curve. `before` is the angle of the first
  // side of the face; `is_counterclockwise` tells whether that is va or vb.
  //
  // Formula: let L be the length of the first side, p and y the coordinates of its other end on the edge ab, seen from
  // the foot of the vertex. The ray at the angle t from the side meets ab at L^2 sin t / (p sin t + y cos t) from that
  // end. Here t = pi/2 - before, less the slope.
  //
  // Where the vertex lies on the edge ab itself, in front of a flat face, all rays meet ab at one point up to rounding,
  // and nothing is taken out: the window of this face is not trimmed (trim()), and points of ab tell no directions.
  void take_out_part(Halfedge_id va, const Angle_sum<FT>& before, bool is_counterclockwise, Edge_part& part) const
  {
    const FT sine = before.cosine - m_slope * before.sine, cosine = before.sine + m_slope * before.cosine;
    const Face_frame<FT> c = m_mesh.face_frame(next_halfedge(va)); // of ab; the apex is the vertex
    if(c.apex_y <= Tolerance<FT>::closeness() * c.length && c.apex_x > 0 && c.apex_rest > 0)
      return;
    const FT& p = is_counterclockwise ? c.apex_x : c.apex_rest;
    const FT& side = is_counterclockwise ? c.left_length : c.right_length;
    const FT divisor = p * sine + c.apex_y * cosine;
    if(!(divisor > 0))
      return;
    const FT x = side * (side * sine / divisor);
    FT& taken = is_counterclockwise ? part.rest : part.begin;
    taken = (std::max)(taken, x);
  }

  // Is nothing left in any face? A part that is empty by itself counts for nothing.
  bool is_empty(const Star& star, const Flags& is_in_sector) const
  {
    for(std::size_t f = 0; f < star.faces.size(); ++f)
      if(is_in_sector[f] != 0
         && m_parts[f].begin + m_parts[f].rest < m_mesh.length(next_halfedge(star.faces[f].halfedge)))
        return false;
    return true;
  }

  const Mesh& m_mesh;
  Source_halfedges<FT> m_source_halfedges;
  std::vector<Edge_part> m_parts;   // by face of the star
  FT m_slope = 0; // tangent of the angle by which the sector is wider than it has to be
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_SECTOR_BETWEEN_NORMALS_H
