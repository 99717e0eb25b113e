// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_EMISSION_SECTOR_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_EMISSION_SECTOR_H

// The faces around a pseudo-source into which it sends windows. A shortest path that arrives at a vertex may
// go on only with an angle of at least pi on both sides (thesis, lemma 3.1), so only the faces that
// reach into those directions are needed, as far as the direction of arrival is known.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
class Emission_sector
{
  using Mesh = Intrinsic_mesh<FT>;
  using Star = Vertex_star<FT>;

public:
  explicit Emission_sector(const Mesh& mesh) : m_mesh(mesh) {}

  // finds the sector of the vertex of a star.
  //
  // A source sends windows through all its faces. So does a vertex with several umbrellas, one whose angles
  // say nothing, and one that has sent windows before: its distance may have shrunk by next to nothing, in
  // exchange for a direction that is next to arbitrary, which is rare.
  void find(const Star& star)
  {
    const Halfedge_id across = star.arrival.halfedge;
    const std::size_t first = across == null_id || star.has_emitted || star.is_degenerate
                                  || m_mesh.has(star.vertex, Mesh::PINCHED)
                                ? star.faces.size()
                                : find_face(star, previous_halfedge(across));
    m_is_in_sector.assign(star.faces.size(), 1);
    if(first == star.faces.size())
      return;
    const Face_frame<FT> c = m_mesh.face_frame(across);
    const FT uncertainty = uncertainty_of_direction(c, star);
    if(!(uncertainty < 1))
      return;
    m_slope = uncertainty + uncertainty * uncertainty * uncertainty; // not less than the tangent
    take_out_hidden(star, first, c);
  }

  bool contains(std::size_t face) const { return m_is_in_sector[face] != 0; }

private:
  static std::size_t find_face(const Star& star, Halfedge_id h)
  {
    std::size_t f = 0;
    while(f < star.faces.size() && star.faces[f].halfedge != h)
      ++f;
    return f;
  }

  // takes the faces out that lie wholly within pi of the direction of arrival, counterclockwise or clockwise.
  // At the border each face lies on one side only.
  void take_out_hidden(const Star& star, std::size_t first, const Face_frame<FT>& c)
  {
    // as seen from C, the vertex: directions to A, to the point where the path crosses AB, and to B
    const FT& x = star.arrival.abscissa;
    const FT cross_left = c.apex_y * x, dot_left = c.apex_x * (c.apex_x - x) + c.apex_y * c.apex_y;
    const FT cross_right = c.apex_y * (c.length - x);
    const FT dot_right = (x - c.apex_x) * c.apex_rest + c.apex_y * c.apex_y;

    Angle_sum<FT> angle;
    angle.add(dot_right, cross_right);
    std::uint32_t f = static_cast<std::uint32_t>(first);
    while(!is_beyond(angle))
    {
      m_is_in_sector[f] = 0;
      f = star.faces[f].next;
      if(f == first || f == null_id)
        break;
      add_corner(star, f, angle);
    }
    angle = Angle_sum<FT>();
    angle.add(dot_left, cross_left);
    for(f = star.faces[first].previous; f != null_id && f != first; f = star.faces[f].previous)
    {
      add_corner(star, f, angle);
      if(is_beyond(angle))
        break;
      m_is_in_sector[f] = 0;
    }
  }

  void add_corner(const Star& star, std::uint32_t f, Angle_sum<FT>& angle) const
  {
    const Halfedge_id h = star.faces[f].halfedge;
    const std::pair<FT, FT> corner = angle_direction(m_mesh.face(face_of(h)), index_in_face(h));
    angle.add(corner.first, corner.second);
  }

  // is the angle greater than pi, or nearly? It is less than 2 pi, the sum of one that was not and of a corner.
  bool is_beyond(const Angle_sum<FT>& angle) const
  {
    return angle.sine < 0 || (angle.cosine < 0 && angle.sine <= -angle.cosine * m_slope);
  }

  // Paths that arrive at v from directions that differ by this angle have the same length in the precision
  // of the computation: turning the last piece of length l by an angle t makes a path longer by l t^2 / 2.
  static FT uncertainty_of_direction(const Face_frame<FT>& c, const Star& star)
  {
    using std::sqrt;
    const FT piece = norm<FT>(c.apex_x - star.arrival.abscissa, c.apex_y);
    if(!(piece > 0))
      return 1;
    const FT rounding = Tolerance<FT>::distance() * star.distance;
    return 4 * sqrt(FT(rounding / piece)) + 8 * Tolerance<FT>::angle();
  }

  const Mesh& m_mesh;
  std::vector<unsigned char> m_is_in_sector; // by face of the star
  FT m_slope = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_EMISSION_SECTOR_H
