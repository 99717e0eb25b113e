// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_NUMBER_CHECKS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_NUMBER_CHECKS_H

// Whether the numbers among the parameters of a public function are valid. They are checked before a mesh is read.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Throws unless the radius is a number that is not negative. Infinity is valid and means no radius.
inline void check_maximum_distance(double maximum_distance)
{
  if(!(maximum_distance >= 0))
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_RADIUS,
                                 "the maximum distance is negative or not a number");
}

// Throws unless all offsets are finite and not negative.
inline void check_offsets(const std::vector<double>& offsets)
{
  for(std::size_t i = 0; i < offsets.size(); ++i)
    if(!(offsets[i] >= 0) || !std::isfinite(offsets[i]))
      throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_OFFSET,
                                   "the offset of source " + std::to_string(i)
                                     + " is negative or not finite", i);
}

// Throws unless the numbers among the parameters of a public function are valid. Needs no mesh: each public function
// calls this once, before it reads a mesh.
template <typename Options>
void check_numbers(const Options& options)
{
  check_maximum_distance(options.maximum_distance);
  check_offsets(options.source_offsets);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_NUMBER_CHECKS_H
