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

// The record of one condition that is checked at many vertices: the number of checks, the size of the worst violation
// and the vertex where it is.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A new record has no checks and no violation. `excess`, `scale` and `extent` are lengths in one unit, that of the
// intrinsic mesh; `size` has no unit, so that records of different conditions and components can be compared.
template <typename FT>
struct Worst_violation
{
  FT size = 0;                // relative; infinite if a number is NaN, or wrongly infinite
  Vertex_id vertex = null_id; // where the worst violation is; null_id if there is none
  std::size_t number_of_checks = 0;

  // Records a check at v. `excess` is the amount by which the condition fails, not positive if it holds; `extent` is
  // the longest edge of the component. An excess of at most gap() times `extent` is not a violation, because the
  // package does not distinguish points that close. Otherwise the size of the violation is excess / scale, or infinity
  // if that is NaN, as for a value that is not a number, or for infinity / infinity. Ties: the first of equal
  // violations stays, except that NaN displaces an infinite one.
  void record(const FT& excess, const FT& scale, const FT& extent, Vertex_id v)
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

  // Adds the checks of another record: a condition may have two parts, as the proof has (on faces, and at sources).
  // Ties: this record keeps its violation.
  void record(const Worst_violation& other)
  {
    number_of_checks += other.number_of_checks;
    if(!(other.size > size))
      return;
    size = other.size;
    vertex = other.vertex;
  }

  // Records that a check has been interrupted: nothing is proved.
  void record_interruption() { size = infinity(); }

  static FT infinity() { return std::numeric_limits<FT>::infinity(); }
};

// Returns the record of a check that has been divided: the parts in their order, so that the first of equal violations
// stays. If the check is not complete, nothing is proved.
template <typename FT>
Worst_violation<FT> merged(const std::vector<Worst_violation<FT>>& parts, bool is_complete)
{
  Worst_violation<FT> worst;
  for(const Worst_violation<FT>& part : parts)
    worst.record(part);
  if(!is_complete)
    worst.record_interruption();
  return worst;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_WORST_VIOLATION_H
