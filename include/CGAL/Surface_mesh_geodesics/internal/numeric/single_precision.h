// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_SINGLE_PRECISION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_SINGLE_PRECISION_H

// Upper and lower bounds, in single precision, of distances that are not negative. They take half the memory of a
// double and differ from the distance by at most a millionth of it.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

struct Single_precision
{
  static constexpr double rounding = Tolerance<double>::conversion_to_float();
  static constexpr float largest = (std::numeric_limits<float>::max)();

  // A bound from above; infinity for large x. Adding the smallest normal number compensates for underflow.
  template <typename FT>
  static float not_less(const FT& x)
  {
    CGAL_assertion(x >= 0);
    const double y = static_cast<double>(x) * (1 + rounding);
    return y < static_cast<double>(largest) ? static_cast<float>(y) + (std::numeric_limits<float>::min)()
                                            : std::numeric_limits<float>::infinity();
  }

  // A bound from below; the largest finite number for large x, so that no bound from below is infinite. Subtracting the
  // smallest normal number compensates for underflow.
  template <typename FT>
  static float not_more(const FT& x)
  {
    CGAL_assertion(x >= 0);
    const double y = (std::min)(static_cast<double>(x) * (1 - rounding), static_cast<double>(largest));
    return (std::max)(static_cast<float>(y) - (std::numeric_limits<float>::min)(), 0.f);
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_SINGLE_PRECISION_H
