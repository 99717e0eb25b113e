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

// The directions in which a pseudo-source emits windows.
//
// A shortest path that passes a vertex has an angle of at least pi on both sides (thesis, lemma 3.1). Of the faces
// around a pseudo-source, only those that reach into such directions are needed, as seen from the path that arrives at
// the vertex. The thesis emits into all faces (4.3.2, "Saddle Vertices"); leaving faces out changes no distance, since
// no shortest path runs through the windows that are not made.
//
// A vertex of a source curve, at which no path arrives, has another sector (Sector_between_normals.h).

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Angle_sum.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Sector_between_normals.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The sector of one vertex at a time: the buffers are reused. Invariant: after find(star) there is a flag for each face
// of the star, until the next call of find().
template <typename FT>
class Emission_sector
{
  using Mesh = Intrinsic_mesh<FT>;
  using Star = Vertex_star<FT>;

public:
  explicit Emission_sector(const Mesh& mesh) : m_mesh(mesh), m_between_normals(mesh) {}

  // The sectors of vertices of curves. It is told the edges of the curves.
  Sector_between_normals<FT>& between_normals() { return m_between_normals; }

  // Finds the sector of the vertex of a star. Linear in the number of faces. Requires: star.emits.
  //
  // Four kinds of vertices emit into all faces:
  // - a source that is on no curve: no path arrives at it;
  // - a pinched vertex: angles are measured within one umbrella only;
  // - a degenerate vertex: paths that miss it tie with those through it, whatever its angles are;
  // - a vertex that has emitted before: an improvement of its distance by little more than rounding may come with an
  //   almost arbitrary direction. This is rare.
  //
  // Ties: a face stays in the sector unless it lies outside by more than the direction of arrival is uncertain.
  void find(const Star& star)
  {
    CGAL_expensive_assertion(star.emits);
    m_is_in_sector.assign(star.faces.size(), 1);
    m_is_between_normals = false;
    if(star.has_emitted || star.is_degenerate || m_mesh.has(star.vertex, Mesh::PINCHED))
      return;
    if(star.arrival.halfedge != null_id)
      take_out_hidden(star);
    else if(!m_between_normals.empty())
    {
      m_is_between_normals = true;
      m_between_normals.find(star, m_is_in_sector);
    }
  }

  // Is a face of the star in the sector? The face is given by its index in the star of the last call of find().
  bool contains(std::size_t face) const
  {
    CGAL_expensive_assertion(face < m_is_in_sector.size());
    return m_is_in_sector[face] != 0;
  }

  // Trims a window of the vertex to its sector, and returns whether there is any of it. The window lies on the whole
  // edge, of the given length, opposite to the vertex in the face. Only vertices of curves trim their windows: other
  // sectors are made of whole faces.
  bool trim(std::size_t face, const FT& length, Window<FT>& w) const
  {
    return !m_is_between_normals || m_between_normals.trim(face, length, w);
  }

private:
  // The index of the face whose halfedge is h, or the number of faces.
  static std::size_t find_face(const Star& star, Halfedge_id h)
  {
    std::size_t f = 0;
    while(f < star.faces.size() && star.faces[f].halfedge != h)
      ++f;
    return f;
  }

  // Takes out the faces that lie wholly within an angle of pi from the direction of arrival, counterclockwise or
  // clockwise. The path of arrival crosses the edge AB; the vertex is its apex C. At a border the walk ends: each face
  // lies on one side of the path only.
  void take_out_hidden(const Star& star)
  {
    const std::size_t first = find_face(star, previous_halfedge(star.arrival.halfedge));
    if(first == star.faces.size())
      return;
    const Face_frame<FT> c = m_mesh.face_frame(star.arrival.halfedge);
    const FT uncertainty = uncertainty_of_direction(c, star);
    if(!(uncertainty < 1))
      return;
    m_slope = uncertainty + uncertainty * uncertainty * uncertainty; // >= tan(uncertainty)
    // Cross and dot product of the directions from C to A and to the crossing of the path with AB; then to B.
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
      add_corner(m_mesh, star.faces[f].halfedge, angle);
    }
    angle = Angle_sum<FT>();
    angle.add(dot_left, cross_left);
    for(f = star.faces[first].previous; f != null_id && f != first; f = star.faces[f].previous)
    {
      add_corner(m_mesh, star.faces[f].halfedge, angle);
      if(is_beyond(angle))
        break;
      m_is_in_sector[f] = 0;
    }
  }

  // Is the angle at least pi - t, where tan t = m_slope? Requires: the angle is less than 2 pi. It is the sum of an
  // angle that was not beyond pi and of one corner.
  //
  // Formula: an angle in (pi, 2 pi) has a negative sine. An angle in (pi/2, pi] is at least pi - t if its tangent is at
  // least -tan t. Frame: the tangent plane at the vertex. Ties: an angle of exactly pi - t is beyond. Error: a sum of
  // up to two thousand angles (Angle_sum) errs by less than Tolerance::direction(), which is a part of t. So a face is
  // taken out only if it lies within pi of the direction of arrival. Laws: scaling all lengths by a power of two keeps
  // the answer, because the sum depends on ratios of lengths.
  bool is_beyond(const Angle_sum<FT>& angle) const
  {
    return angle.sine < 0 || (angle.cosine < 0 && angle.sine <= -angle.cosine * m_slope);
  }

  // The angle by which the direction of arrival is uncertain. Paths whose directions of arrival differ by less have the
  // same length up to rounding: turning the last straight piece, of length l, by an angle t makes a path longer by
  // l t^2 / 2. Hence t = sqrt(2 rounding / l), with a factor of 2 sqrt 2 to spare, plus the error of a sum of angles.
  //
  // The lengths that are compared are those of paths beyond the vertex, at the edges and corners of the star: there the
  // vertex wins ties, so it has to emit wherever rounding makes one. A source that is much nearer to the vertex than
  // the edges are long has a small distance, but ties as far as the edges reach.
  FT uncertainty_of_direction(const Face_frame<FT>& c, const Star& star) const
  {
    using std::sqrt;
    const FT piece = norm<FT>(c.apex_x - star.arrival.abscissa, c.apex_y);
    if(!(piece > 0))
      return 1;
    FT reach = 0; // the longest edge around the vertex
    for(const auto& face : star.faces)
      reach = (std::max)(reach, m_mesh.length(face.halfedge));
    const FT rounding = Tolerance<FT>::distance() * (star.distance + reach);
    return 4 * sqrt(FT(rounding / piece)) + Tolerance<FT>::direction();
  }

  const Mesh& m_mesh;
  std::vector<unsigned char> m_is_in_sector; // by face of the star
  Sector_between_normals<FT> m_between_normals;
  bool m_is_between_normals = false;         // is the sector that of a vertex of a curve?
  FT m_slope = 0;                            // tangent of the uncertainty
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_EMISSION_SECTOR_H
