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

// The windows that start at a pseudo-source. lanes/window_splitting.h makes their children.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Sets w to the window on the whole edge opposite to a pseudo-source in one face. `c` is the frame of that edge with
// the pseudo-source as its apex; the window belongs to the opposite halfedge, which runs from c.target to c.origin. A
// pseudo-source on the line of the edge gets an image of a small positive depth, Tolerance::depth().
// The apex lies above the edge in the frame `c`, so the image lies below it in that of the opposite halfedge, whose
// abscissas count from the other end.
//
// Requires: root_distance <= target_distance, origin_distance, the distances of the ends of the edge along the window.
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
