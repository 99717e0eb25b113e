// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_PLANAR_GEOMETRY_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_PLANAR_GEOMETRY_H

// Plane geometry on bare numbers: points, norms, and triangles that are laid out from their lengths.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

#include <cmath>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
struct Planar_point
{
  FT x = 0, y = 0;
};

// Are the corners of a triangle on one line as far as numbers tell? `longest` is its longest side.
template <typename FT>
bool is_without_height(const FT& twice_the_area, const FT& longest)
{
  return twice_the_area <= Tolerance<FT>::length() * longest * longest;
}

// A triangle laid out in the plane: the corners 0, 1, 2 are at (0,0), (base,0), (apex_x, apex_y)
// with apex_y >= 0.
template <typename FT>
struct Planar_triangle
{
  FT base, apex_x, apex_y;
};

// lays out the triangle whose sides are a (from corner 0 to 1), b (1 to 2) and c (2 to 0), where a
// is not longer than b and c.
//
// The area is computed after W. Kahan ("Miscalculating area and angles of a needle-like triangle",
// 2014), whose order of operations is accurate for needles; a side that exceeds the sum of the
// others by rounding gives a triangle without area.
template <typename FT>
Planar_triangle<FT> planar_triangle_from_lengths(const FT& a, const FT& b, const FT& c)
{
  using std::sqrt;
  Planar_triangle<FT> t;
  t.base = a;
  if(!(a > 0))
  {
    t.apex_x = c;
    t.apex_y = 0;
    return t;
  }
  FT x = b, y = c;
  if(x < y)
    std::swap(x, y);
  // x >= y >= a
  // in units of the longest side, so that nothing underflows
  const FT product = ((x + (y + a)) / x) * ((a - (x - y)) / x) * ((a + (x - y)) / x) * ((x + (y - a)) / x);
  t.apex_y = product > 0 ? FT(x * (sqrt(product) * (x / (2 * a)))) : FT(0);
  t.apex_x = (a + (c - b) * (c + b) / a) / 2;
  return t;
}

// The norm of a vector of the plane. The coordinates of an intrinsic mesh are normalised, so that
// the squares neither overflow nor vanish.
template <typename FT>
FT norm(const FT& x, const FT& y)
{
  using std::sqrt;
  return sqrt(x * x + y * y);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_PLANAR_GEOMETRY_H
