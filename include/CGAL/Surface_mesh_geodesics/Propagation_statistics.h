// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_PROPAGATION_STATISTICS_H
#define CGAL_SURFACE_MESH_GEODESICS_PROPAGATION_STATISTICS_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Propagation_statistics` counts the work of one propagation or of several.

- All functions that take the named parameter `statistics`, and `Geodesic_distance_solver`, <em>add</em> to the object
  to which it points, so that it may serve for several runs; see `add()`.
- `Surface_mesh_geodesic_paths::statistics()` and `Surface_mesh_geodesic_Voronoi_diagram::statistics()` return those of
  the last propagation alone.

A propagation that a visitor canceled counts up to that point. One that an exception ended does not count.

\sa `geodesic_distances()`
*/
struct Propagation_statistics
{
  /// number of times that a vertex left the wavefront.
  std::size_t vertices_visited = 0;

  /// number of windows made on an edge.
  std::size_t windows_created = 0;

  /// number of windows propagated across a face, after pruning.
  std::size_t windows_propagated = 0;

  /// number of propagated windows left without a child: by Rule 1 (\ref Surface_mesh_geodesics_rules), at a border, or
  /// because their children were removed by another rule.
  std::size_t windows_removed_by_rule_1 = 0;

  /// number of windows removed by Rules 2 and 3 (pairs of windows of one edge; \ref Surface_mesh_geodesics_rules).
  std::size_t windows_removed_by_rules_2_and_3 = 0;

  /// number of windows removed because a path through a vertex is shorter, because their pseudo-source has become
  /// nearer since they were made, or because they have crossed more faces than a shortest path can cross.
  std::size_t windows_removed_by_vertices = 0;

  /// number of windows removed because their interval was as narrow as rounding makes it.
  std::size_t windows_removed_as_slivers = 0;

  /// number of window lists propagated across a face.
  std::size_t window_lists = 0;

  /// number of pairs of neighboring windows to which no rule was applied because their order is not known.
  std::size_t ambiguous_pairs = 0;

  /// largest number of windows that waited on the wavefront at one time.
  std::size_t maximum_windows_alive = 0;

  /// memory of the windows, in bytes.
  std::size_t maximum_window_bytes = 0;

  /// memory of the intrinsic mesh, of the results, and of other data for each vertex and each edge, in bytes.
  std::size_t intrinsic_mesh_bytes = 0;

  /// adds the counts of other runs: numbers are summed up; of maxima and of bytes the larger one remains.
  ///
  /// \param other the counts of the other runs
  void add(const Propagation_statistics& other)
  {
    vertices_visited += other.vertices_visited;
    windows_created += other.windows_created;
    windows_propagated += other.windows_propagated;
    windows_removed_by_rule_1 += other.windows_removed_by_rule_1;
    windows_removed_by_rules_2_and_3 += other.windows_removed_by_rules_2_and_3;
    windows_removed_by_vertices += other.windows_removed_by_vertices;
    windows_removed_as_slivers += other.windows_removed_as_slivers;
    window_lists += other.window_lists;
    ambiguous_pairs += other.ambiguous_pairs;
    maximum_windows_alive = (std::max)(maximum_windows_alive, other.maximum_windows_alive);
    maximum_window_bytes = (std::max)(maximum_window_bytes, other.maximum_window_bytes);
    intrinsic_mesh_bytes = (std::max)(intrinsic_mesh_bytes, other.intrinsic_mesh_bytes);
  }
};

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_PROPAGATION_STATISTICS_H
