// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_WORST_VIOLATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_WORST_VIOLATION_H

// The result of checking one condition at many vertices: the number of checks, and the worst violation.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
struct Worst_violation
{
  FT size = 0;                // relative; infinite if a number is infinite or NaN that must not be
  Vertex_id vertex = null_id; // where the worst violation is; null_id if there is none
  std::size_t number_of_checks = 0;

  // Counts a check at v. The condition is violated if `excess` is positive or not a number; the size of the violation
  // is the quotient of the excess and `scale`, infinite if that is not a number. An excess of at most gap() times
  // `extent`, the longest edge of the component, is no violation, as points so close to each other are not
  // distinguished. Of equal violations the first one is kept.
  void look_at(const FT& excess, const FT& scale, const FT& extent, Vertex_id v)
  {
    ++number_of_checks;
    if(excess <= Tolerance<FT>::gap() * extent)
      return;
    const FT relative = excess / scale;
    if(relative <= size) // false if the excess is not a number
      return;
    size = relative < infinity() ? relative : infinity();
    vertex = v;
  }

  // Adds the checks of another result.
  void look_at(const Worst_violation& other)
  {
    number_of_checks += other.number_of_checks;
    if(!(other.size > size))
      return;
    size = other.size;
    vertex = other.vertex;
  }

  static FT infinity() { return std::numeric_limits<FT>::infinity(); }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_WORST_VIOLATION_H
