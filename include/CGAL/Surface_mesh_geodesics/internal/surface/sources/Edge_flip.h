// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_EDGE_FLIP_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_EDGE_FLIP_H

// An edge between two flat faces, and the other diagonal of their quadrangle: whether it should take its place, so that
// faces become those of a Delaunay triangulation (Lawson, 1977), and the vectors of the faces that it makes.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The edge h = (a, b) is between the faces (a, b, v) and (b, a, d). A flip makes the edge (v, d) of it, between the
// faces (v, a, d) and (d, b, v).
//
// Frame: the layout of the first face. Vectors of the second one are turned, as the two layouts see the edge in
// opposite directions.
// Error: each vector errs by the rounding of its own length, and (v, d) by that of the shorter way along two sides:
// their sum. No vector is the difference of two positions that are far away, so a cluster of vertices keeps its digits.
template <typename FT_>
class Edge_flip
{
public:
  using FT = FT_;
  using Vector = Planar_point<FT>;

  Vector va, ad, db, bv, vd; // from the first to the second vertex
  FT vd_length;

  // Turns the second face into the layout of the first one, around the edge, and adds up (v, d) along the shorter way.
  // Requires: the edge has two different faces.
  Edge_flip(const Intrinsic_mesh<FT>& mesh, Halfedge_id h)
  {
    const Halfedge_id o = mesh.opposite(h);
    const std::array<Vector, 3> p = layout_of_face(mesh.face(face_of(h))), q = layout_of_face(mesh.face(face_of(o)));
    const unsigned int a = index_in_face(h), b = next_corner(a), v = previous_corner(a);
    const unsigned int b2 = index_in_face(o), a2 = next_corner(b2), d = previous_corner(b2);
    const Turn_to_first turned(difference(p[a], p[b]), difference(q[a2], q[b2]));
    va = difference(p[a], p[v]);
    bv = difference(p[v], p[b]);
    ad = turned(difference(q[d], q[a2]));
    db = turned(difference(q[b2], q[d]));
    const FT way_by_a = length(va) + length(ad), way_by_b = length(bv) + length(db);
    m_way = (std::min)(way_by_a, way_by_b);
    vd = way_by_a <= way_by_b ? Vector{FT(va.x + ad.x), FT(va.y + ad.y)} : Vector{FT(-bv.x - db.x), FT(-bv.y - db.y)};
    vd_length = length(vd);
  }

  // Returns whether the angles at v and d have a sum of more than pi, by a margin: then the circle through the corners
  // of one face contains the fourth vertex. The new faces have to have an area, and the new edge is not much shorter
  // than the sides that it is the sum of.
  // Formula: sin(v + d) < -margin, times the lengths of the four sides. Ties: the edge stays.
  bool is_wanted() const
  {
    const FT sine_v = cross(bv, va), cosine_v = -dot(va, bv), sine_d = cross(ad, db), cosine_d = -dot(ad, db);
    const FT at_a = length(va) * length(ad), at_b = length(bv) * length(db), least = Tolerance<FT>::angle_of_flip();
    return sine_v * cosine_d + cosine_v * sine_d < -Tolerance<FT>::flip() * at_a * at_b
        && vd_length > Tolerance<FT>::shortest_flip() * m_way
        && cross(va, ad) > least * at_a && cross(db, bv) > least * at_b;
  }

private:
  // The rotation that takes one direction to another one. If one of the two has no length, it turns nothing.
  struct Turn_to_first
  {
    FT cosine = 1, sine = 0;

    Turn_to_first(const Vector& to, const Vector& from)
    {
      const FT lengths = length(to) * length(from);
      if(!(lengths > 0))
        return;
      cosine = dot(to, from) / lengths;
      sine = cross(from, to) / lengths;
    }

    Vector operator()(const Vector& w) const
    {
      return Vector{FT(cosine * w.x - sine * w.y), FT(sine * w.x + cosine * w.y)};
    }
  };

  static FT length(const Vector& w) { return norm(w.x, w.y); }

  // From v to d along two sides, the shorter way. If (v, d) is much shorter, these sides nearly cancel in their sum,
  // and its direction would not be known to enough digits.
  FT m_way;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_EDGE_FLIP_H
