// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_MESH_INVARIANTS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_MESH_INVARIANTS_H

// The invariants of an intrinsic mesh, as functions that check them. They hold from Intrinsic_mesh::finish() on,
// before and after each insertion of a source (Source_insertion.h), but not during one. The checks are for
// CGAL_expensive_assertion and for tests.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Returns whether the layout is valid: side 0 is a shortest side, lengths are not negative, the apex is not below the
// base. A length that is not a number is not valid.
template <typename FT>
bool is_layout_valid(const Intrinsic_face<FT>& f)
{
  return f.length[0] >= 0 && f.length[0] <= f.length[1] && f.length[0] <= f.length[2] && f.apex_y >= 0;
}

// Returns whether h and its opposite belong together: each is the opposite of the other, they run in opposite
// directions, and their lengths are the same bits (if numbers are rounded to nearest).
template <typename FT>
bool is_opposite_valid(const Intrinsic_mesh<FT>& mesh, Halfedge_id h)
{
  const Halfedge_id o = mesh.opposite(h);
  return o == null_id
      || (mesh.opposite(o) == h && mesh.source(o) == mesh.target(h) && mesh.target(o) == mesh.source(h)
          && mesh.length(o) == mesh.length(h));
}

// Returns whether the halfedge of v leaves v, begins its umbrella, and the kinds of v agree: a pinched or degenerate
// vertex is a pseudo-source. A walk that begins at the border ends at the border; only a pinched vertex may also have
// umbrellas of the other kind.
template <typename FT>
bool is_vertex_valid(const Intrinsic_mesh<FT>& mesh, Vertex_id v)
{
  using Mesh = Intrinsic_mesh<FT>;
  if((mesh.has(v, Mesh::PINCHED) || mesh.has(v, Mesh::DEGENERATE)) && !mesh.has(v, Mesh::PSEUDO_SOURCE))
    return false;
  const Halfedge_id first = mesh.halfedge(v);
  if(first == null_id)
    return true;
  bool leaves_v = true, ends_at_border = false;
  mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
  {
    leaves_v = leaves_v && mesh.source(h) == v;
    ends_at_border = ends_at_border || mesh.next_around_source(h) == null_id;
  });
  return leaves_v && (mesh.has(v, Mesh::PINCHED) || ends_at_border == (mesh.opposite(first) == null_id));
}

// Checks all faces, halfedges and vertices. Takes linear time.
template <typename FT>
bool are_invariants_kept(const Intrinsic_mesh<FT>& mesh)
{
  for(Face_id f = 0; f < mesh.number_of_faces(); ++f)
  {
    if(!is_layout_valid(mesh.face(f)))
      return false;
    for(unsigned int k = 0; k < 3; ++k)
      if(!is_opposite_valid(mesh, halfedge_of(f, k)))
        return false;
  }
  for(Vertex_id v = 0; v < mesh.number_of_vertices(); ++v)
    if(!is_vertex_valid(mesh, v))
      return false;
  return true;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_MESH_INVARIANTS_H
