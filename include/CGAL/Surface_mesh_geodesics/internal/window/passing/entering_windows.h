// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_ENTERING_WINDOWS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_ENTERING_WINDOWS_H

// What a list of windows that enters a face tells about the distances on the edge that it crosses. All functions read
// the list, the mesh and the field, and nothing else, so the threads of a propagation may call them during visits. They
// take time linear in the number of windows.
//
// Passed_faces makes upper bounds of them that tell when a face is inactive (thesis, 5.1). Distances only
// shrink while they are propagated, so a bound that has been true once stays true.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Returns whether the intervals of the windows of a list are parts of an edge of the given length. (They may overlap
// and leave gaps.)
template <typename FT>
bool are_on_edge(const Window_list<FT>& list, const FT& length)
{
  for(std::size_t i = 0; i < list.size; ++i)
    if(!(0 <= list.columns.begin()[i] && list.columns.begin()[i] <= list.columns.end()[i]
         && list.columns.end()[i] <= length))
      return false;
  return true;
}

// Returns the smallest distance at an end of a window. Inside an interval there may be a smaller one; but any point of
// the list will do as the first part of a path whose length is a bound. Requires: the list is not empty.
template <typename FT>
FT smallest_distance(const Window_list<FT>& list)
{
  const FT *const at_begin = list.columns.begin_distance(), *const at_end = list.columns.end_distance();
  FT nearest = (std::min)(at_begin[0], at_end[0]);
  for(std::size_t i = 1; i < list.size; ++i)
    nearest = (std::min)({nearest, at_begin[i], at_end[i]});
  return nearest;
}

// Returns a distance that no point between two points on an edge exceeds: the paths by the two points have this length
// on average, so one of them is not longer. For a point at x behind the first one, they are at_first + x and at_last +
// length - x long. Infinity if one of both is not reached.
template <typename FT>
FT bound_between(const FT& at_first, const FT& at_last, const FT& length)
{
  return FT((at_first + at_last + length) / 2);
}

// Returns a distance that no point on the edge of h exceeds, by the windows of a list on that edge. The distance by a
// window is convex along the edge, so that it is largest at an end of the interval; gaps between windows are bounded by
// bound_between(). (Windows that overlap may be out of order; then the bound is larger than need be.) It is infinite if
// a gap at an end of the edge has no path from that end.
template <typename FT>
FT bound_by_windows(const Intrinsic_mesh<FT>& mesh, const Vertex_distance_field<FT>& field, Halfedge_id h,
                    const Window_list<FT>& list)
{
  const auto& columns = list.columns;
  FT bound = 0, x = 0, at_x = field.distance[mesh.source(h)]; // the edge is done up to x
  for(std::size_t i = 0; i < list.size; ++i)
  {
    const FT &begin = columns.begin()[i], &end = columns.end()[i];
    const FT &at_begin = columns.begin_distance()[i], &at_end = columns.end_distance()[i];
    if(x < begin)
      bound = (std::max)(bound, bound_between(at_x, at_begin, FT(begin - x)));
    bound = (std::max)({bound, at_begin, at_end});
    if(x < end)
    {
      x = end;
      at_x = at_end;
    }
  }
  const FT& length = mesh.length(h);
  if(x < length)
    bound = (std::max)(bound, bound_between(at_x, field.distance[mesh.target(h)], FT(length - x)));
  return bound;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_ENTERING_WINDOWS_H
