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

// Plane geometry on bare numbers: points, norms, and triangles that are laid out from their lengths. Each formula
// states its error bound; test_laws_in_faces compares it with a hundred digits.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

#include <CGAL/assertions.h>

#include <array>
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

// Returns the point of a triangle with barycentric coordinates b.
template <typename FT>
Planar_point<FT> point_of_triangle(const std::array<Planar_point<FT>, 3>& corner, const std::array<FT, 3>& b)
{
  return {FT(b[0] * corner[0].x + b[1] * corner[1].x + b[2] * corner[2].x),
          FT(b[0] * corner[0].y + b[1] * corner[1].y + b[2] * corner[2].y)};
}

// Points are vectors, too: from the origin.
//
// Returns the vector from q to p.
template <typename FT>
Planar_point<FT> difference(const Planar_point<FT>& p, const Planar_point<FT>& q)
{
  return {FT(p.x - q.x), FT(p.y - q.y)};
}

template <typename FT>
FT dot(const Planar_point<FT>& u, const Planar_point<FT>& v)
{
  return u.x * v.x + u.y * v.y;
}

// Returns the cross product, which is positive if v is on the left of u.
template <typename FT>
FT cross(const Planar_point<FT>& u, const Planar_point<FT>& v)
{
  return u.x * v.y - u.y * v.x;
}

// Is the height of a triangle over its longest side at most `ratio` times that side? For the default, the corners are
// on one line, up to rounding. The answer does not depend on the unit of length.
template <typename FT>
bool is_without_height(const FT& twice_the_area, const FT& longest, const FT& ratio = Tolerance<FT>::length())
{
  return twice_the_area <= ratio * longest * longest;
}

// A triangle laid out in the plane. Its corners are (0,0), (base,0) and (apex_x, apex_y), where apex_y >= 0.
template <typename FT>
struct Planar_triangle
{
  FT base, apex_x, apex_y;
};

// Lays out the triangle with the sides a (from corner 0 to corner 1), b (1 to 2) and c (2 to 0). Sides that violate the
// triangle inequality by rounding give a triangle without area.
// Requires: 0 <= a <= b, a <= c.
//
// Formula: twice the area is the root of (x + y + a) (a - x + y) (a + x - y) (x + y - a) / 4 with x = max(b,c),
// y = min(b,c), in the order of operations of W. Kahan ("Miscalculating area and angles of a needle-like triangle",
// 2014).
//
// Error bound, to first order in u = epsilon() / 2, for exact sides. x - y and c - b are exact (Sterbenz's lemma:
// no side is longer than the sum of the others, and a is the shortest). The four factors err by 3, 2, 2 and 3 u, their
// product by 13 u, its root by 7.5 u, and apex_y by 10.5 u of itself: less than 6 epsilon(). The summand of a in
// apex_x errs by 3 u of b + c at most, and apex_x by 5.5 u of c or 6.5 u of b: less than 3 and 4 epsilon(). So
// the directions of all sides are accurate in needles, too.
// Laws: scaling all lengths by a power of two scales the result exactly.
template <typename FT>
Planar_triangle<FT> planar_triangle_from_lengths(const FT& a, const FT& b, const FT& c)
{
  using std::sqrt;
  CGAL_assertion(0 <= a && a <= b && a <= c);
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
  // Relative to the longest side, so that nothing underflows.
  const FT product = ((x + (y + a)) / x) * ((a - (x - y)) / x) * ((a + (x - y)) / x) * ((x + (y - a)) / x);
  t.apex_y = product > 0 ? FT(x * (sqrt(product) * (x / (2 * a)))) : FT(0);
  t.apex_x = (a + (c - b) * (c + b) / a) / 2;
  return t;
}

// The length of a vector. The lengths of an intrinsic mesh are about 1, so that squares neither overflow nor vanish.
// Errs by at most 2 u = epsilon() of itself if x and y are exact.
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
