// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_NEWTON_REFINEMENT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_NEWTON_REFINEMENT_H

// Refines points that satisfy two conditions on distances: the vertex of three cells, the intersection of a bisector
// and a line. Newton's method reduces their error to the rounding of the distances.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Improves a solution p of f(p) = g(p) = 0 by at most four steps of Newton's method, and returns the last point at
// which |f| + |g| became smaller. residuals(p) returns f, g, and their gradients as (f, g, fx, fy, gx, gy). `size` is
// the size of the face; a step longer than Tolerance::newton_step() of it is not made. Neither is one longer than
// radius(p), the distance from p to the nearest point that distances are measured from: beyond it, the gradients point
// elsewhere.
// Requires: both sizes are not negative.
//
// f is the difference of the distances from two points. If these are close to each other, the gradient of f vanishes:
// then f tells nothing about the position, and g decides it alone.
//
// Formula: a step is x times the unit gradient of f (`across`) plus y times its normal (`along`). With n the length of
// the gradient of f, f + n x = 0 gives x, and then g + x (grad g) across + y (grad g) along = 0 gives y. If grad g has
// nearly no component along (`slope`), the curves f = 0 and g = 0 are nearly parallel, and p is the answer.
//
// Error: where the method converges, |f| + |g| is at most the rounding of the distances (`precision`). No bound is
// known for the position, since the two curves may touch.
template <typename FT, typename Residuals, typename Radius>
Planar_point<FT> polished_point(Planar_point<FT> p, const FT& size_of_distances, const FT& size, Residuals residuals,
                                Radius radius)
{
  using std::abs;
  CGAL_assertion(size_of_distances >= 0 && size >= 0);
  const FT precision = Tolerance<FT>::epsilon() * (size_of_distances + size);
  std::array<FT, 6> r = residuals(p); // the values, and their gradients
  for(int i = 0; i < 4 && abs(r[0]) + abs(r[1]) > precision; ++i)
  {
    const FT n = norm<FT>(r[2], r[3]);
    if(!(n > 0))
      return p;
    const Planar_point<FT> across{FT(r[2] / n), FT(r[3] / n)}, along{FT(-across.y), across.x};
    const FT slope = r[4] * along.x + r[5] * along.y;
    if(!(abs(slope) > Tolerance<FT>::slope()))
      return p;
    const FT x = n > Tolerance<FT>::closeness() ? FT(-r[0] / n) : FT(0);
    const FT y = -(r[1] + x * (r[4] * across.x + r[5] * across.y)) / slope;
    const Planar_point<FT> q{FT(p.x + x * across.x + y * along.x), FT(p.y + x * across.y + y * along.y)};
    const std::array<FT, 6> s = residuals(q);
    const FT longest = (std::min)(FT(Tolerance<FT>::newton_step() * size), FT(radius(p)));
    if(!(abs(s[0]) + abs(s[1]) < abs(r[0]) + abs(r[1])) || distance(p, q) > longest)
      return p;
    p = q;
    r = s;
  }
  return p;
}

// Returns the unit vector from a weighted point to a point, zero if they are equal: the gradient of the distance.
template <typename FT>
Planar_point<FT> direction_from(const Additively_weighted_point<FT>& from, const Planar_point<FT>& to)
{
  if(from.is_at_infinity())
    return Planar_point<FT>{from.x, from.y};
  const FT dx = to.x - from.x, dy = to.y - from.y, n = norm(dx, dy);
  return n > 0 ? Planar_point<FT>{FT(dx / n), FT(dy / n)} : Planar_point<FT>();
}

// Returns the point close to p that is as far from a as from b and from c.
template <typename FT>
Planar_point<FT> polished_vertex(const Additively_weighted_point<FT>& a, const Additively_weighted_point<FT>& b,
                                 const Additively_weighted_point<FT>& c, const Planar_point<FT>& p, const FT& size)
{
  return polished_point<FT>(p, a.distance_to(p), size, [&](const Planar_point<FT>& q)
  {
    const Planar_point<FT> ua = direction_from(a, q), ub = direction_from(b, q), uc = direction_from(c, q);
    const FT d = a.distance_to(q);
    return std::array<FT, 6>{FT(d - b.distance_to(q)), FT(d - c.distance_to(q)), FT(ua.x - ub.x),
                             FT(ua.y - ub.y), FT(ua.x - uc.x), FT(ua.y - uc.y)};
  }, [&](const Planar_point<FT>& q)
  { return (std::min)({a.planar_distance_to(q), b.planar_distance_to(q), c.planar_distance_to(q)}); });
}

// Returns the point close to p at which the bisector of a and b intersects the line of h.
template <typename FT>
Planar_point<FT> polished_intersection(const Additively_weighted_point<FT>& a, const Additively_weighted_point<FT>& b,
                                       const Half_plane<FT>& h, const Planar_point<FT>& p, const FT& size)
{
  return polished_point<FT>(p, a.distance_to(p), size, [&](const Planar_point<FT>& q)
  {
    const Planar_point<FT> ua = direction_from(a, q), ub = direction_from(b, q);
    return std::array<FT, 6>{FT(a.distance_to(q) - b.distance_to(q)), h(q), FT(ua.x - ub.x),
                             FT(ua.y - ub.y), h.a, h.b};
  }, [&](const Planar_point<FT>& q) { return (std::min)(a.planar_distance_to(q), b.planar_distance_to(q)); });
}

// Returns the line through p perpendicular to the bisector of a and b: its direction is the gradient of the difference
// of the distances. Where that vanishes, the result is zero everywhere.
template <typename FT>
Half_plane<FT> line_across(const Additively_weighted_point<FT>& a, const Additively_weighted_point<FT>& b,
                           const Planar_point<FT>& p)
{
  const Planar_point<FT> ua = direction_from(a, p), ub = direction_from(b, p);
  const FT x = ua.y - ub.y, y = ub.x - ua.x, n = norm(x, y);
  return n > 0 ? Half_plane<FT>{FT(x / n), FT(y / n), FT(-(x * p.x + y * p.y) / n)}
               : Half_plane<FT>{FT(0), FT(0), FT(0)};
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_NEWTON_REFINEMENT_H
