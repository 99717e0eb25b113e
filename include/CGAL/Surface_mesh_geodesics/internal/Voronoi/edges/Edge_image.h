// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_EDGE_IMAGE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_EDGE_IMAGE_H

// An image as an edge sees it: how far the points of the edge are by it, and where two images are equally far.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// An image as an edge sees it: the distances weight + |(x - image_x, depth)| at the points x from `begin` to `end`. Of
// an image at infinity (Additively_weighted_point), these are weight + image_x * x: image_x is the slope.
template <typename FT>
struct Edge_image
{
  FT begin, end;
  FT image_x, depth, weight;
  Vertex_id site;
  bool is_at_infinity = false;

  FT distance_at(const FT& x) const
  {
    if(is_at_infinity)
      return (std::max)(FT(0), FT(weight + image_x * x)); // rounding may make it negative beside the curve
    return weight + norm<FT>(x - image_x, depth);
  }

  // Returns the derivative of the distance, 0 at the image itself.
  FT slope_at(const FT& x) const
  {
    if(is_at_infinity)
      return image_x;
    const FT n = norm<FT>(x - image_x, depth);
    return n > 0 ? FT((x - image_x) / n) : FT(0);
  }
};

// Returns the abscissa where the distances by two images have the same slope, or `otherwise` if there is none, or
// more than one. Seen from there, both images are in the same direction.
template <typename FT>
FT equal_slopes(const Edge_image<FT>& g, const Edge_image<FT>& c, const FT& otherwise)
{
  using std::sqrt;
  if(g.is_at_infinity && c.is_at_infinity)
    return otherwise;
  if(c.is_at_infinity)
    return equal_slopes(c, g, otherwise);
  if(g.is_at_infinity)
  {
    const FT square = (1 - g.image_x) * (1 + g.image_x);
    return square > 0 ? FT(c.image_x + c.depth * (g.image_x / sqrt(square))) : otherwise;
  }
  return g.depth != c.depth ? FT((g.image_x * c.depth - c.image_x * g.depth) / (c.depth - g.depth)) : otherwise;
}

// Returns the roots of qa y^2 + 2 qb y + qc, as abscissas: y counts from x. `root` is that of the discriminant.
template <typename FT>
std::array<FT, 2> roots_of_quadratic(const FT& qa, const FT& qb, const FT& qc, const FT& root, const FT& x)
{
  const FT infinity = std::numeric_limits<FT>::infinity();
  std::array<FT, 2> r{infinity, infinity};
  const FT q = -(qb + (qb < 0 ? FT(-root) : root));
  if(qa != 0)
    r[0] = x + q / qa;
  if(q != 0)
    r[1] = x + qc / q;
  if(r[1] < r[0])
    std::swap(r[0], r[1]);
  return r;
}

// Returns where an image l at infinity and any image c are equally far, as equal_points() does. With y measured from
// the image of c, a the slope, and s the distance by l there less the weight of c, the equation is
// |(y, depth of c)| = s + a y, squared (1 - a^2) y^2 - 2 a s y + (depth of c)^2 - s^2 = 0. Both distances are linear if
// c is at infinity, too.
template <typename FT>
std::array<FT, 2> equal_points_with_rays(const Edge_image<FT>& l, const Edge_image<FT>& c)
{
  using std::sqrt;
  const FT infinity = std::numeric_limits<FT>::infinity(), a = l.image_x;
  if(c.is_at_infinity)
    return {a != c.image_x ? FT((c.weight - l.weight) / (a - c.image_x)) : infinity, infinity};
  const FT s = l.weight + a * c.image_x - c.weight;
  const FT qa = (1 - a) * (1 + a), qb = -a * s, qc = (c.depth - s) * (c.depth + s);
  const FT square = s * s - qa * c.depth * c.depth;
  const FT root = square > 0 ? FT(sqrt(square)) : FT(0);
  return roots_of_quadratic(qa, qb, qc, root, c.image_x);
}

// Returns the abscissas where the distances of two images are equal, in ascending order, infinity in place of those
// that do not exist. A root may be one of the squared equation only; it divides the edge once more, which does no
// harm.
//
// With y measured from the image of c, and s the weight of c minus that of g, the equation is
// |(y - d, depth of g)| = |(y, depth of c)| + s. Squared, it becomes a y + b = s |(y, depth of c)|; squared again,
// qa y^2 + 2 qb y + qc = 0.
template <typename FT>
std::array<FT, 2> equal_points(const Edge_image<FT>& g, const Edge_image<FT>& c)
{
  using std::sqrt;
  if(g.is_at_infinity || c.is_at_infinity)
    return g.is_at_infinity ? equal_points_with_rays(g, c) : equal_points_with_rays(c, g);
  const FT s = c.weight - g.weight, d = g.image_x - c.image_x;
  const FT a = -d;
  const FT b = ((d - s) * (d + s) + (g.depth - c.depth) * (g.depth + c.depth)) / 2;
  const FT qa = (a - s) * (a + s), qb = a * b, qc = (b - s * c.depth) * (b + s * c.depth);
  const FT square = b * b + qa * c.depth * c.depth;
  const FT root = square > 0 ? FT(sqrt(square) * (s < 0 ? FT(-s) : s)) : FT(0);
  return roots_of_quadratic(qa, qb, qc, root, c.image_x);
}

// Returns the abscissa within an interval at which the distance by an image is smallest.
template <typename FT>
FT foot_of(const Edge_image<FT>& g, const FT& first, const FT& last)
{
  if(g.is_at_infinity)
    return g.image_x > 0 ? first : last;
  return (std::min)((std::max)(g.image_x, first), last);
}

// Improves an abscissa x where two distances are equal by at most two steps of Newton's method. Returns the last one
// that made their difference smaller.
template <typename FT>
FT polished_abscissa(const Edge_image<FT>& g, const Edge_image<FT>& c, FT x)
{
  using std::abs;
  for(int i = 0; i < 2; ++i)
  {
    const FT slope = g.slope_at(x) - c.slope_at(x), f = g.distance_at(x) - c.distance_at(x);
    const FT next = slope != 0 ? FT(x - f / slope) : x;
    if(!(abs(g.distance_at(next) - c.distance_at(next)) < abs(f)))
      return x;
    x = next;
  }
  return x;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_EDGE_IMAGE_H
