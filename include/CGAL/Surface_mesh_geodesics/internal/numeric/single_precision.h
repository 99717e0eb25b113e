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

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

struct Single_precision
{
  // Of a distance: four times the largest relative error of a conversion to float (2^-24), so that the bounds hold in
  // every rounding mode.
  static constexpr double rounding = 0x1p-22;
  static constexpr float largest = (std::numeric_limits<float>::max)();

  // A bound from above; infinity for large x. The smallest normal number makes up for what underflow loses.
  template <typename FT>
  static float not_less(const FT& x)
  {
    const double y = static_cast<double>(x) * (1 + rounding);
    return y < static_cast<double>(largest) ? static_cast<float>(y) + (std::numeric_limits<float>::min)()
                                            : std::numeric_limits<float>::infinity();
  }

  // A bound from below.
  template <typename FT>
  static float not_more(const FT& x)
  {
    return static_cast<float>((std::min)(static_cast<double>(x) * (1 - rounding), static_cast<double>(largest)));
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_SINGLE_PRECISION_H
