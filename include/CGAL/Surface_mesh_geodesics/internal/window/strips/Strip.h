// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_H

// A strip: parallel rays from a part of a source edge, all across the same edges. It is to a segment what a window is
// to a point. From the inside of a segment, shortest paths leave at a right angle, to both sides; unfolded into one
// plane they are parallel, and their lengths are a linear function.
//
// Error. Direction, distance and foot of a child come from those of its parent by one rotation, as an image does, and
// add the error of one frame (Tolerance::distance()). Errors of the ends of an interval are errors across the rays: a
// ray that passes a vertex on the wrong side by so little is longer by the square of it only. Where rays graze an edge,
// abscissas on it are uncertain, but the distances and the feet of the rays are not.
//
// Frame: that of Window.h. A strip belongs to the halfedge AB of the face ABC that it is about to enter. A is the
// origin, AB the positive x axis, C lies above.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Vertex_rival.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The ray through (x,0) comes from the direction -(direction_x, direction_y), a unit vector; its length from the source
// is distance + direction_x * x, the offset included. `side` is the source edge times two, plus 1 for the rays to the
// right of the curve. The foot of the ray is at foot + direction_y * x on that edge, in the frame of its halfedge on
// that side.
//
// Invariants: 0 <= begin < end <= |AB|, and direction_y > 0.
template <typename FT>
struct Strip
{
  FT begin, end, direction_x, direction_y, distance, foot;
  std::uint32_t side, faces_crossed;

  FT distance_at(const FT& x) const { return distance + direction_x * x; }
  FT foot_at(const FT& x) const { return foot + direction_y * x; }
  FT minimum_distance() const { return distance_at(direction_x >= 0 ? begin : end); }
};

// Where the ray through (x, y) crosses AB.
template <typename FT>
FT crossing_of_ray(const Strip<FT>& s, const FT& x, const FT& y)
{
  return x - y * (s.direction_x / s.direction_y);
}

// The value of the linear function at (x, y). No ray of the strip leads there with a bend at AB in a shorter way.
template <typename FT>
FT distance_of_ray(const Strip<FT>& s, const FT& x, const FT& y)
{
  return s.distance_at(x) + s.direction_y * y;
}

// How a path along a ray arrives at a point above AB: through `abscissa` of AB, from the image of the foot of the ray
// at (image_x, -image_depth). (The image is farther away where the source edge has an offset; directions are the same.)
template <typename FT>
struct Ray_arrival
{
  FT distance, abscissa, image_x, image_depth;
};

// The shortest of these paths: along the ray through (x, y), or, if that one passes beside the strip, along the nearest
// ray with a bend at AB. The bend keeps a point reached where rounding has moved the end of the interval past its ray.
// Beside a curve, rounding may be larger than the distance: a negative one would beat the curve itself, and queries
// would take it for that of a point that no source reaches. Requires: y >= 0.
template <typename FT>
Ray_arrival<FT> arrival_of_ray(const Strip<FT>& s, const FT& x, const FT& y)
{
  const FT crossing = crossing_of_ray(s, x, y), abscissa = (std::min)(s.end, (std::max)(s.begin, crossing));
  const FT up_to_edge = (std::max)(FT(0), s.distance_at(abscissa));
  const FT distance = abscissa == crossing ? (std::max)(FT(0), distance_of_ray(s, x, y))
                                           : FT(up_to_edge + norm<FT>(x - abscissa, y));
  return {distance, abscissa, FT(abscissa - s.direction_x * up_to_edge), FT(s.direction_y * up_to_edge)};
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_H
