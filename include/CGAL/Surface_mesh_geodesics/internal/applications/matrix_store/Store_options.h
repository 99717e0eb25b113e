// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_OPTIONS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_OPTIONS_H

// What is stored of a matrix, and how: the named parameters of store_geodesic_distance_matrix() as plain values.

#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/Parameter_sequence.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <limits>
#include <string>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The defaults are those that users know; store_geodesic_distance_matrix() documents the values.
struct Store_options
{
  // Full rows of double precision, unless these say otherwise. They decide about the numbers in the folder: all calls
  // for one folder need the same values.
  bool use_float32 = false;
  bool use_symmetry = false;
  double maximum_distance = std::numeric_limits<double>::infinity();

  // These may change from call to call.
  std::size_t rows_per_shard = 0; // 0: by size; an old folder keeps its number
  std::size_t first_row = 0;
  std::size_t end_row = (std::numeric_limits<std::size_t>::max)();
  // The rows of all threads that wait for being written, in bytes; a thread has room for one row at least.
  std::size_t memory_limit = std::size_t(1) << 26;
  std::string mesh_name;
  // Of shards that are done. Processes that have just seen each other write them need not read them again.
  bool compare_checksums = true;
};

// Reads the parameters. Throws for values that are wrong for any mesh: Invalid_geodesic_input for the radius, and
// Geodesic_matrix_store_error for the others.
template <typename NamedParameters>
Store_options store_options(const NamedParameters& np)
{
  using Reason = Geodesic_matrix_store_error::Reason;
  const Store_options defaults;
  Store_options options;
  options.use_float32 = value_parameter(np, internal_np::use_float32, defaults.use_float32);
  options.use_symmetry = value_parameter(np, internal_np::use_symmetry, defaults.use_symmetry);
  options.maximum_distance = number_parameter(np, internal_np::maximum_distance, defaults.maximum_distance);
  options.rows_per_shard = value_parameter(np, internal_np::rows_per_shard, defaults.rows_per_shard);
  options.first_row = value_parameter(np, internal_np::first_row, defaults.first_row);
  options.end_row = value_parameter(np, internal_np::end_row, defaults.end_row);
  options.memory_limit = value_parameter(np, internal_np::memory_limit, defaults.memory_limit);
  options.mesh_name = value_parameter(np, internal_np::mesh_name, defaults.mesh_name);
  options.compare_checksums = value_parameter(np, internal_np::compare_checksums, defaults.compare_checksums);
  check_maximum_distance(options.maximum_distance);
  if(options.use_symmetry && options.maximum_distance < defaults.maximum_distance)
    throw Geodesic_matrix_store_error(Reason::INVALID_OPTION,
                                      "a matrix within a radius stores all rows whole: symmetry cannot be used");
  if(options.first_row > options.end_row)
    throw Geodesic_matrix_store_error(Reason::INVALID_OPTION, "the first row is behind the last one");
  return options;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_OPTIONS_H
