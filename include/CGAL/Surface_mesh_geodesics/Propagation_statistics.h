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

The class `Propagation_statistics` counts what one propagation did, or several.

- An object that `Geodesic_distance_options::statistics` points to is <em>added to</em>, by `geodesic_distances()`,
  `geodesic_distances_from_edge_lengths()` and `Geodesic_distance_solver`, so that it may be used for several runs:
  counts are summed up, maxima and bytes are those of the largest run. The other functions that take these options do
  not look at the pointer.
- An object that `Geodesic_sampling_options::statistics` points to is <em>assigned</em> the counts of the call.
- `Surface_mesh_geodesic_paths::statistics()` and `Surface_mesh_geodesic_Voronoi_diagram::statistics()` return those of
  the last propagation alone.

A propagation that a visitor has cancelled is counted as far as it went, and none that has ended by an exception.

\sa `Geodesic_distance_options`
*/
struct Propagation_statistics
{
  /// number of times that a vertex was taken from the wavefront.
  std::size_t vertices_visited = 0;

  /// number of windows that were put on an edge.
  std::size_t windows_created = 0;

  /// number of windows that were propagated across a face, after pruning.
  std::size_t windows_propagated = 0;

  /// number of propagated windows left without a child: by Rule 1 (\ref Surface_mesh_geodesics_rules), at a border, or
  /// because their children were removed by another rule.
  std::size_t windows_removed_by_rule_1 = 0;

  /// number of windows removed by Rules 2 and 3 (pairs of windows of one edge; \ref Surface_mesh_geodesics_rules).
  std::size_t windows_removed_by_rules_2_and_3 = 0;

  /// number of windows removed because a path through a vertex is shorter.
  std::size_t windows_removed_by_vertices = 0;

  /// number of windows dropped because their interval was a product of rounding.
  std::size_t windows_removed_as_slivers = 0;

  /// number of window lists propagated across a face.
  std::size_t window_lists = 0;

  /// number of pairs of neighbouring windows to which no rule was applied because their order
  /// is not known.
  std::size_t ambiguous_pairs = 0;

  /// largest number of windows that waited on the wavefront at a time.
  std::size_t maximum_windows_alive = 0;

  /// memory of the windows, in bytes.
  std::size_t maximum_window_bytes = 0;

  /// memory of the intrinsic mesh, of the results, and of what else there is for each vertex and each edge, in bytes.
  std::size_t intrinsic_mesh_bytes = 0;
};

namespace internal {

// adds the counts of a run to those of others.
inline void add_statistics(const Propagation_statistics& from, Propagation_statistics& to)
{
  to.vertices_visited += from.vertices_visited;
  to.windows_created += from.windows_created;
  to.windows_propagated += from.windows_propagated;
  to.windows_removed_by_rule_1 += from.windows_removed_by_rule_1;
  to.windows_removed_by_rules_2_and_3 += from.windows_removed_by_rules_2_and_3;
  to.windows_removed_by_vertices += from.windows_removed_by_vertices;
  to.windows_removed_as_slivers += from.windows_removed_as_slivers;
  to.window_lists += from.window_lists;
  to.ambiguous_pairs += from.ambiguous_pairs;
  to.maximum_windows_alive = (std::max)(to.maximum_windows_alive, from.maximum_windows_alive);
  to.maximum_window_bytes = (std::max)(to.maximum_window_bytes, from.maximum_window_bytes);
  to.intrinsic_mesh_bytes = (std::max)(to.intrinsic_mesh_bytes, from.intrinsic_mesh_bytes);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_PROPAGATION_STATISTICS_H
