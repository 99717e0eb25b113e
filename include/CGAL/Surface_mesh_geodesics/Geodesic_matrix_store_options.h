// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_MATRIX_STORE_OPTIONS_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_MATRIX_STORE_OPTIONS_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <cstddef>
#include <limits>
#include <string>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_matrix_store_options` says what `store_geodesic_distance_matrix()` stores, and how.

The first three members decide about the numbers in the folder: all calls for one folder need the same values. The
others may change from call to call.

\sa `store_geodesic_distance_matrix()`
*/
struct Geodesic_matrix_store_options
{
  /// whether distances are stored in 32 bits, which saves half of the space. They are rounded to the nearest number of
  /// type `float`, to the even one in a tie: the relative error is at most 2<sup>-24</sup> for distances above
  /// 2<sup>-126</sup>.
  bool use_float32 = false;

  /// whether only distances between different sources are stored, each once: row `i` has those to the sources `i + 1`,
  /// `i + 2`, ... Sources and targets must be the same vertices, and the radius infinite.
  bool use_symmetry = false;

  /// the radius, in the unit of the mesh: only distances up to it are stored, as a sparse matrix, unless it is
  /// infinite.
  double maximum_distance = std::numeric_limits<double>::infinity();

  /// the number of rows of a shard; 0 lets the function choose it. A folder that has a manifest keeps its own number.
  std::size_t rows_per_shard = 0;

  /// the first row that this call computes. A call computes the shards whose first row is in
  /// [`first_row`, `end_row`).
  std::size_t first_row = 0;

  /// the row behind the last one.
  std::size_t end_row = (std::numeric_limits<std::size_t>::max)();

  /// the number of bytes for rows that are not written yet, of all threads together. There are never more threads than
  /// rows of `double` that fit, but at least one. The mesh and the wavefronts are not counted.
  std::size_t memory = std::size_t(1) << 26;

  /// the name of the mesh in the manifest, such as that of its file.
  std::string mesh_name;
};

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_MATRIX_STORE_OPTIONS_H
