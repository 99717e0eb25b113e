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

// What a check of a condition finds: how many times it looked, and the worst that it saw.

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
  FT size = 0;               // relative; infinite if a number is NaN or infinite that must not be
  Vertex_id vertex = null_id; // where it is; null_id if nothing is violated
  std::size_t number_of_checks = 0;

  // a condition that is violated by `excess` if that is positive, where lengths are about `scale`. What cannot be told
  // from zero beside the extent of the component is no violation.
  void look_at(const FT& excess, const FT& scale, const FT& extent, Vertex_id v)
  {
    ++number_of_checks;
    if(excess <= Tolerance<FT>::gap() * extent)
      return;
    const FT relative = excess / scale;
    // (also where the excess is not a number)
    if(relative <= size)
      return;
    size = relative < infinity() ? relative : infinity();
    vertex = v;
  }

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
