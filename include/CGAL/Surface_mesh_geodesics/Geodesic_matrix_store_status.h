// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_MATRIX_STORE_STATUS_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_MATRIX_STORE_STATUS_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_matrix_store_status` says how much of a matrix, or of a range of its rows, is stored.

\sa `Geodesic_distance_matrix_store`
*/
struct Geodesic_matrix_store_status
{
  /// the number of rows.
  std::size_t rows = 0;
  /// the number of rows in shards that are done.
  std::size_t rows_done = 0;
  /// the number of shards.
  std::size_t shards = 0;
  /// the number of shards that are done.
  std::size_t shards_done = 0;
  /// the number of shards that are not done and that a process has locked.
  std::size_t shards_in_work = 0;

  /// returns whether all rows are stored.
  bool is_complete() const { return rows_done == rows; }
};

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_matrix_store_check` is the result of `check_geodesic_distance_matrix()`. Violations are relative to
the larger side of the inequality, or to the longest edge of the mesh if that is larger. Of exact distances in 64 bits
they are a few units of 2<sup>-53</sup>, in 32 bits of 2<sup>-24</sup>.

\sa `check_geodesic_distance_matrix()`
*/
struct Geodesic_matrix_store_check
{
  /// the number of rows that were computed anew.
  std::size_t rows_compared = 0;
  /// the number of these that differ from the stored ones in any bit.
  std::size_t rows_different = 0;
  /// the number of pairs of distances there and back.
  std::size_t pairs_compared = 0;
  /// the largest difference of such a pair.
  double worst_asymmetry = 0;
  /// the number of triangle inequalities.
  std::size_t triangles_checked = 0;
  /// by how much an inequality is violated at most.
  double worst_triangle_violation = 0;
};

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_MATRIX_STORE_STATUS_H
