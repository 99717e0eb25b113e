// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_KEPT_WINDOW_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_KEPT_WINDOW_H

// The part of a window that is kept for queries (Edge_window_field.h) and for diagrams (Face_windows.h). It has no
// distance of the pseudo-source: the final distance of the root counts, and the root may have become nearer since.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// All lengths are in the frame of the halfedge that the window has crossed (Window.h).
template <typename FT>
struct Kept_window
{
  FT begin, end;           // the interval, as abscissas
  FT image_x, image_depth; // the image lies at (image_x, -image_depth)
  Vertex_id root;
};

// Returns what is kept of window i of a list. The lower half of a Window_history is the root.
template <typename FT>
Kept_window<FT> kept_window(const Window_list<FT>& list, std::size_t i)
{
  const auto& columns = list.columns;
  return Kept_window<FT>{columns.begin()[i], columns.end()[i], columns.image_x()[i], columns.image_depth()[i],
                         static_cast<Vertex_id>(columns.history()[i])};
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_KEPT_WINDOW_H
