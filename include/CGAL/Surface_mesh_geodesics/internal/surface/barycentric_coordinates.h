// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_BARYCENTRIC_COORDINATES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_BARYCENTRIC_COORDINATES_H

// Barycentric coordinates of a point in a face: validity, rounding to the edges, and combinations.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The coordinates of a point with respect to the corners 0, 1, 2 of a face. They sum up to 1.
template <typename FT>
using Barycentric = std::array<FT, 3>;

// Returns the coordinates of the point at t of a halfedge, 0 at its source and 1 at its target, in its face.
template <typename FT>
Barycentric<FT> coordinates_on_halfedge(Halfedge_id h, const FT& t)
{
  Barycentric<FT> b{};
  b[index_in_face(h)] = 1 - t;
  b[next_corner(index_in_face(h))] = t;
  return b;
}

// Returns whether b are the coordinates of a point of a face: none is below 0 or above 1, and the sum is 1, up to
// Tolerance::location(). NaN is not valid.
template <typename FT>
bool are_valid_coordinates(const std::array<FT, 3>& b)
{
  using std::abs;
  const FT tolerance = Tolerance<FT>::location();
  for(const FT& x : b)
    if(!(x >= -tolerance) || !(x <= 1 + tolerance))
      return false;
  return abs(FT(b[0] + b[1] + b[2] - 1)) <= tolerance;
}

// Sets coordinates up to Tolerance::barycentric() to zero, and divides the others by their sum. The point moves to an
// edge or a corner if it is that near to it. Requires: are_valid_coordinates(b). Then the largest coordinate is about
// 1/3 at least, and the sum is positive. Afterwards no coordinate is negative, and that of a corner is exactly 1.
template <typename FT>
void snap_coordinates(std::array<FT, 3>& b)
{
  CGAL_assertion(are_valid_coordinates(b));
  FT sum = 0;
  for(FT& x : b)
  {
    if(x <= Tolerance<FT>::barycentric())
      x = 0;
    sum = sum + x;
  }
  for(FT& x : b)
    x = x / sum;
}

// Returns the first corner with the largest coordinate.
template <typename FT>
unsigned int nearest_corner(const std::array<FT, 3>& b)
{
  return static_cast<unsigned int>(std::max_element(b.begin(), b.end()) - b.begin());
}

// Returns the coordinates of the point b of a triangle whose corners have the coordinates c in a larger face. Formula:
// b[0] c[0] + b[1] c[1] + b[2] c[2]. Zeros stay exact: a point of a side that lies on an edge of the larger face has a
// coordinate 0 there.
template <typename FT>
std::array<FT, 3> combination(const std::array<std::array<FT, 3>, 3>& c, const std::array<FT, 3>& b)
{
  std::array<FT, 3> r;
  for(std::size_t i = 0; i < 3; ++i)
    r[i] = b[0] * c[0][i] + b[1] * c[1][i] + b[2] * c[2][i];
  return r;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_BARYCENTRIC_COORDINATES_H
