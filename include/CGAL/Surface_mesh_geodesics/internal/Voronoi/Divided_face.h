// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_DIVIDED_FACE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_DIVIDED_FACE_H

// A face that lies in several cells, with all that is needed to divide it. The removal of redundant windows
// (Redundant_window_removal.h) fills it and hands it over, after which the windows of the face are released; the
// complex (Voronoi_complex.h) reads it. Neither of them knows the other one.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Edge_partition.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Site_image.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The struct is reused from face to face, so that its vectors are allocated a few times only. A consumer copies what it
// needs: the content is valid during Consumer::add() only.
template <typename FT>
struct Divided_face
{
  Face_id face = null_id;

  // Where cells begin and end on side k, in the order of that halfedge of the edge that has the smaller index, and with
  // abscissas from its source; none if the side is in one cell. Both faces at an edge get the same breakpoints.
  std::array<std::vector<Edge_breakpoint<FT>>, 3> breakpoints;

  // In the layout of the face: its corners first, then the windows that are left (for_each_site_image()).
  std::vector<Site_image<FT>> images;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_DIVIDED_FACE_H
