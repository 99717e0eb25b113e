// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_OF_PSEUDO_SOURCE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_OF_PSEUDO_SOURCE_H

// The windows that start at a pseudo-source. How windows go on is told in lanes/window_splitting.h.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The window on the whole edge e of the face in front of a pseudo-source v, where `c` is the
// crossing of the halfedge opposite to v, which has v as its apex. It belongs to the opposite
// halfedge, which runs from c.target to c.origin.
template <typename FT>
void window_of_pseudo_source(const Face_frame<FT>& c, const FT& root_distance,
                             const FT& target_distance, const FT& origin_distance, Window<FT>& w)
{
  w.begin = 0;
  w.end = c.length;
  w.image_x = c.length - c.apex_x;
  w.image_depth = (std::max)(c.apex_y, FT(Tolerance<FT>::depth() * c.length));
  w.begin_distance = target_distance;
  w.end_distance = origin_distance;
  w.root_distance = root_distance;
  w.root = c.apex;
  w.steps = 0;
  w.key = initial_window_key;
  CGAL_expensive_assertion(is_valid(w, c.length));
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_OF_PSEUDO_SOURCE_H
