// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_VERTEX_FAN_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_VERTEX_FAN_H

// The faces around a vertex with their angles: the tangent frame of the vertex. Angles count counterclockwise from the
// first halfedge of the fan. trace_geodesic.h documents which one that is, and how users see these angles.

#include <CGAL/Surface_mesh_geodesics/internal/interface/directions/full_turns.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/Face_layout.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/Layouts_with_walls.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The umbrella of a vertex that contains a given face. Invariant: the angles ascend from 0 to total_angle().
//
// Error: each angle errs by a few epsilon of itself, as layouts are accurate in needles and caps, too; so do the sums.
// The sum is the same for all halfedges from which the fan may be read, up to rounding.
template <typename TriangleMesh>
class Vertex_fan
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

public:
  // A face of the fan: the halfedge that leaves the vertex with the face on its left, and its angle.
  struct Sector
  {
    halfedge_descriptor halfedge;
    double angle;
  };

  // Reads the faces around the source of h, counterclockwise from the first halfedge. The next halfedge around a vertex
  // is opposite to the one that enters it in the same face. Linear in their number. Requires: h has a face.
  template <typename Layouts>
  Vertex_fan(halfedge_descriptor h, const TriangleMesh& tm, const Layouts& layouts)
  {
    const halfedge_descriptor first = first_halfedge(h, tm, layouts);
    halfedge_descriptor g = first;
    do
    {
      const Face_layout layout = layouts(g);
      m_sectors.push_back({g, m_total_angle});
      m_total_angle += layout.angle(0);
      m_has_angles = m_has_angles && layout.has_angles();
      g = opposite(next(next(g, tm), tm), tm);
    } while(g != first && !is_end_of_surface(g, tm, layouts));
    m_is_closed = g == first && !is_end_of_surface(opposite(first, tm), tm, layouts);
    m_has_angles = m_has_angles && m_total_angle > 0;
  }

  // The sum of the angles of the faces at the vertex: 2 pi where the surface is flat.
  double total_angle() const { return m_total_angle; }

  // Does the umbrella surround the vertex, without a border?
  bool is_closed() const { return m_is_closed; }

  // Do the angles mean something? They do not if an edge of a face has no length: the vertex and its neighbor are one
  // point then, and the faces around this point are in two fans.
  bool has_angles() const { return m_has_angles; }

  // The angle of a halfedge of the fan. Linear in the degree. Requires: the halfedge leaves the vertex in this
  // umbrella.
  double angle(halfedge_descriptor h) const
  {
    return std::find_if(m_sectors.begin(), m_sectors.end(), [&](const Sector& s) { return s.halfedge == h; })->angle;
  }

  // The angle of users, which is scaled to a full turn where the umbrella is closed. Requires: has_angles().
  double scaled(double angle) const
  {
    return m_is_closed ? reduced_angle(angle / m_total_angle * full_turn, full_turn) : angle;
  }

  // The inverse of scaled(). Users may add full turns. At the border, an angle in [0, total_angle()] stays as it is,
  // and one that leads along the border up to rounding leads along it: the direction of a path along the border would
  // lead out of the surface otherwise. An angle that leads out is greater than total_angle().
  double unscaled(double direction) const
  {
    if(m_is_closed)
      return reduced_angle(reduced_angle(direction, full_turn) / full_turn * m_total_angle, m_total_angle);
    const double tolerance = rounding_of_sums();
    if(direction >= -tolerance && direction <= m_total_angle + tolerance)
      return (std::min)((std::max)(direction, 0.), m_total_angle);
    const double reduced = reduced_angle(direction, full_turn);
    if(full_turn - reduced <= tolerance)
      return 0;
    return std::abs(reduced - m_total_angle) <= tolerance ? m_total_angle : reduced;
  }

  // The last sector that begins at an angle or before it: the angle leads into its face, or along its halfedge. An
  // angle of total_angle() is in the last sector. Logarithmic in the degree. Requires: angle >= 0.
  const Sector& sector_at(double angle) const
  {
    const auto behind = std::upper_bound(m_sectors.begin() + 1, m_sectors.end(), angle,
                                         [](double a, const Sector& s) { return a < s.angle; });
    return *(behind - 1);
  }

private:
  // By how much two sums of the angles of the fan may differ, from whatever layouts they come: each angle rounds the
  // sum once. (At the border, a direction may have been summed up from the other end.)
  double rounding_of_sums() const
  {
    const double faces = static_cast<double>(m_sectors.size());
    return Tolerance<double>::barycentric() * (std::max)(1., faces / 16) * (std::max)(1., m_total_angle);
  }

  // Walks clockwise, until it is at the border or back at h. Users know the result as the halfedge with the direction
  // 0.
  //
  // The first halfedge of the fan: at the border, or at a wall, the one with no face on its right; else
  // opposite(halfedge(v, tm), tm) for the source v of h. If that one is in another umbrella, h itself.
  template <typename Layouts>
  static halfedge_descriptor first_halfedge(halfedge_descriptor h, const TriangleMesh& tm, const Layouts& layouts)
  {
    const halfedge_descriptor wanted = opposite(halfedge(source(h, tm), tm), tm);
    halfedge_descriptor g = h;
    bool has_wanted = false;
    do
    {
      if(is_end_of_surface(opposite(g, tm), tm, layouts))
        return g;
      has_wanted = has_wanted || g == wanted;
      g = next(opposite(g, tm), tm);
    } while(g != h);
    return has_wanted ? wanted : h;
  }

  std::vector<Sector> m_sectors; // counterclockwise
  double m_total_angle = 0;
  bool m_is_closed = false, m_has_angles = true;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_VERTEX_FAN_H
