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

  // Is the strip so narrow that rounding makes up its width, on an edge of this length? Its rays graze that edge, or a
  // vertex. No path is lost: each strip improves the apex of the face, also by a path that bends at its end.
  bool is_sliver(const FT& length) const { return !((end - begin) * direction_y > Tolerance<FT>::interval() * length); }
};

// Takes those rays away that an end of the edge beats, and returns whether any are left.
//
// Proof. Let P be a point of the ray through x, at the distance s beyond the edge. By way of A it is reached within
// d(A) + x + s, the ray has the length D(x) + s. So A beats the ray where d(A) + x < D(x). As D grows by at most 1,
// this holds up to some x, and from there on no more; the formula solves the equation, with the factor of Vertex_rival
// on D. B is the mirror image. The order of visits does not matter: d(A) is the length of a path at any time.
template <typename FT>
bool trim(Strip<FT>& s, const FT& length, const Vertex_rival<FT>& left, const Vertex_rival<FT>& right)
{
  const FT from_left = left.factor * s.distance - left.distance, slope_left = 1 - left.factor * s.direction_x;
  if(from_left > slope_left * s.begin)
  {
    if(!(slope_left * s.end >= from_left))
      return false;
    s.begin = (std::max)(s.begin, FT(from_left / slope_left));
  }
  const FT from_right = right.distance + length - right.factor * s.distance;
  const FT slope_right = 1 + right.factor * s.direction_x;
  if(from_right < slope_right * s.end)
  {
    if(!(slope_right * s.begin <= from_right))
      return false;
    s.end = (std::min)(s.end, FT(from_right / slope_right));
  }
  return s.begin < s.end;
}

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

// Turns a strip into the part of it that crosses AB up to `last` and then AC. Returns whether there is any. `angle` is
// left_angle(c).
// Requires: last <= apex, the abscissa of the ray through C. Then apex > 0 tells that rays cross AC at all. AC has a
// length.
//
// Formulas. The direction turns by the angle of AC. Abscissas on AC are those on AB times |AC| / apex (parallel
// projection). That factor is also the inverse ratio of the heights of the directions, which is right to the last
// digits beside sides that are much shorter than AB; there the difference of two abscissas on AB is not.
template <typename FT>
bool turn_left(Strip<FT>& s, const Face_frame<FT>& c, const Side_angle<FT>& angle, const FT& apex, const FT& last)
{
  const FT end = (std::min)(s.end, last);
  if(!(apex > 0) || !(s.begin < end))
    return false;
  const FT height = s.direction_y * angle.cosine - s.direction_x * angle.sine;
  if(!(height > 0))
    return false;
  const FT ratio = s.direction_y / height;
  s.begin = (std::min)(c.left_length, FT(s.begin * ratio));
  s.end = end >= apex ? c.left_length : (std::min)(c.left_length, FT(end * ratio));
  s.direction_x = s.direction_x * angle.cosine + s.direction_y * angle.sine;
  s.direction_y = height;
  ++s.faces_crossed;
  return s.begin < s.end;
}

// The mirror image: the part that crosses AB from `first` on, and then CB. `angle` is right_angle(c).
// Requires: first >= apex; CB has a length.
template <typename FT>
bool turn_right(Strip<FT>& s, const Face_frame<FT>& c, const Side_angle<FT>& angle, const FT& apex, const FT& first)
{
  const FT begin = (std::max)(s.begin, first);
  const FT height = s.direction_y * angle.cosine + s.direction_x * angle.sine;
  if(!(height > 0) || !(c.length > apex) || !(begin < s.end))
    return false;
  const FT ratio = s.direction_y / height;
  const FT at_target = s.distance_at(c.length), foot_of_target = s.foot_at(c.length);
  s.begin = begin <= apex ? FT(0) : (std::max)(FT(0), FT(c.right_length - (c.length - begin) * ratio));
  s.end = (std::max)(FT(0), FT(c.right_length - (c.length - s.end) * ratio));
  s.direction_x = s.direction_x * angle.cosine - s.direction_y * angle.sine;
  s.direction_y = height;
  s.distance = at_target - s.direction_x * c.right_length;
  s.foot = foot_of_target - s.direction_y * c.right_length;
  ++s.faces_crossed;
  return s.begin < s.end;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_H
