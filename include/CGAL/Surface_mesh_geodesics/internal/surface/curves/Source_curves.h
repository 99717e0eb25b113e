// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_SOURCE_CURVES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_SOURCE_CURVES_H

// Curves that are sources: as polylines in faces of the mesh as it was read, and as edges and vertices of the refined
// mesh, once they are inserted (Curve_insertion.h).

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A straight segment in a face, from one of its points to another. The coordinates are valid (are_valid_coordinates())
// and in the order of the corners of the face. Results name points of it by the number of the segment in the curve of
// the user, and by a parameter, which is that of `from`: 0, but for a point at the end of a segment.
template <typename FT>
struct Curve_segment
{
  Face_id face;
  Barycentric<FT> from, to;
  std::uint32_t number = 0;
  FT parameter = 0;
};

// A curve: each segment begins at the point where the one before ends, and that of a closed curve at last returns to
// the first point. A curve without segments is the point at `vertex`. The offset is in the unit of the mesh. Walls
// divide a curve into several, which have one number (curves_at_walls.h).
template <typename FT>
struct Located_curve
{
  std::vector<Curve_segment<FT>> segments;
  Vertex_id vertex = null_id;
  bool is_closed = false;
  FT offset = 0;
  std::uint32_t number = 0; // of the curve of the user
};

// A point of a curve, as results name it: curves are numbered from 0, and so are the segments of each. The parameter is
// 0 at the beginning of the segment and 1 at its end.
template <typename FT>
struct Curve_point
{
  std::uint32_t curve, segment;
  FT parameter;
};

// An edge of the refined mesh that is a part of a segment. Along the curve, the face of `left` is on the left, and that
// of `right` on the right; null_id stands for the border. `left` runs along the curve, `right` against it. The
// vertices and parameters are those of the ends. A curve may run along the edge several times: the direction and the
// segment are those of the first time, in the order of the user, whatever pieces walls make of the curve.
template <typename FT>
struct Source_edge
{
  Halfedge_id left, right;
  Vertex_id first, last;
  FT length, offset;
  std::uint32_t curve, segment;
  FT first_parameter, last_parameter;
  std::uint32_t copies = 1; // how often curves run along the edge, in either direction
};

// A vertex of the refined mesh on a curve.
template <typename FT>
struct Source_vertex
{
  Vertex_id vertex;
  FT offset;
  Curve_point<FT> point;
};

// One more curve that has an edge or a vertex, with the offset of the curve that counts there. An edge is named by the
// smaller of its halfedges.
struct Further_curve
{
  std::uint32_t element, curve;
};

// All curves of a propagation in the refined mesh. Invariants: each edge and each vertex is there once, with the
// smallest offset of the curves that it is a part of; of curves with the same offset, the first one. The others with
// this offset are listed apart, in the order of elements; a curve may be there twice. Both ends of each edge are among
// the vertices.
template <typename FT>
struct Source_curves
{
  std::vector<Source_edge<FT>> edges;
  std::vector<Source_vertex<FT>> vertices;
  std::vector<Further_curve> further_curves_of_edges, further_curves_of_vertices;

  // Calls visit(halfedge, offset) for one halfedge of each edge that has a length. (The ends of an edge without length
  // are sources as well.)
  template <typename Visit>
  void for_each_edge_with_length(Visit visit) const
  {
    for(const Source_edge<FT>& e : edges)
      if(e.length > 0)
        visit(e.left != null_id ? e.left : e.right, e.offset);
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_SOURCE_CURVES_H
