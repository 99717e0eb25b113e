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

// Plane geometry on bare numbers, and every tolerance of the package. No tolerance is absolute:
// each one is multiplied by the length, the distance or the angle that its comment names.

#include <limits>
#include <utility>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
struct Planar_point
{
  FT x = 0, y = 0;
};

// Tolerances, in units of the rounding error of the number type.
template <typename FT>
struct Tolerance
{
  static FT unit_roundoff() { return std::numeric_limits<FT>::epsilon(); }

  // What the user gives is a double, whatever the precision of the computation.
  static FT input_roundoff() { return FT(std::numeric_limits<double>::epsilon()); }

  // Relative to a distance: two distances that differ by less are not told apart when the longer
  // one would be pruned. Each is the result of one square root and a few sums, which err by less
  // than four units.
  static FT distance() { return 4 * unit_roundoff(); }

  // Relative to the extent of the mesh: the length of an edge whose ends are pseudo-sources whatever
  // their angles. The direction of a path from a point so near to a vertex is known with an error of
  // unit_roundoff / length only, and the path is longer by the square of that; paths through the vertex
  // itself are longer by the length. Here both errors are about the same. If the edge is lost in the
  // rounding of distances altogether, paths could run around in its neighbourhood without growing.
  static FT length()
  {
    using std::sqrt;
    return sqrt(unit_roundoff()) / 1024;
  }

  // Relative to the extent of a component: points of a path that are nearer to each other are one.
  static FT gap() { return 8 * unit_roundoff(); }

  // Relative to the length of an edge: a narrower interval is a product of rounding (a ray that
  // meets a vertex) and is dropped. The gap is not lost: distances are also measured along paths
  // that bend at the end of an interval, and a lateral shift of this size makes them longer by its
  // square only.
  static FT interval() { return 512 * unit_roundoff(); }

  // Relative to the distance of an image, or the longest side of the face if that is longer: a path that
  // passes a vertex at a smaller distance may pass it on either side, or run through it, as far as one can
  // tell. Images err by some units for each face that the path has crossed.
  static FT sideways() { return 512 * unit_roundoff(); }

  // Relative to the same lengths: what the rounding of images and frames may make of a distance.
  static FT lengthwise() { return 8 * unit_roundoff(); }

  // Relative to a distance: a path that differs from it by more is not the one that has been looked for.
  // Distances err by some units for each face that the path has crossed.
  static FT path() { return 4096 * unit_roundoff(); }

  // Relative to pi: the excess of a vertex angle above which a shortest path may bend at the vertex. It
  // is above the rounding of a sum of angles, so that flat vertices stay flat, and below the angles of all
  // faces that are not flat themselves (length()), so that no face is hidden behind a vertex for ever.
  static FT angle() { return 1024 * unit_roundoff(); }

  // Relative to the length of an edge: the distance from an image to its window below which the ends of the
  // interval are too coarse to tell directions, so that the interval must not be trimmed.
  static FT closeness()
  {
    using std::sqrt;
    return sqrt(unit_roundoff()) / 16;
  }

  // Relative to a distance: two images of one source tie, of which each errs by some units for each face that the path
  // has crossed. Relative to the extent of the mesh: so do all images of two sources that are as near to each other.
  static FT tie() { return 64 * distance(); }

  // Relative to the size of a face: where a curve touches a line, its place is known to the square root of rounding.
  static FT touching() { return 64 * closeness(); }

  // Relative to what is integrated along a curve, if its chord were all of it: below, intervals are not halved any
  // more.
  static FT quadrature() { return 512 * unit_roundoff(); }

  // Relative to the length of an edge: how exactly the crossings of isolines are found.
  static FT isoline() { return 4096 * unit_roundoff(); }

  // Relative to 1: a barycentric coordinate below is taken for zero, so that a location with
  // rounded coordinates is the vertex or the edge point that was meant. It shifts a source by at
  // most this part of the longest edge of its face.
  static FT barycentric() { return 64 * input_roundoff(); }

  // Relative to barycentric coordinates: how far a point may be from where they put it, by the rounding of its
  // coordinates, and of those of the corners of a part of its face.
  static FT placement() { return 4 * input_roundoff(); }

  // Relative to 1: how far barycentric coordinates may be from coordinates of a point of the face.
  static FT location()
  {
    using std::sqrt;
    return sqrt(input_roundoff()) / 16;
  }

  // Relative to the longest side: the amount by which it may exceed the sum of the two others.
  static FT triangle_inequality() { return 64 * input_roundoff(); }

  // Relative to the length of an edge: the depth at which the image of a pseudo-source is placed
  // that lies on the edge itself (the apex of a triangle without area). Its square vanishes
  // against the square of the length.
  static FT depth()
  {
    using std::sqrt;
    const FT e = unit_roundoff();
    return e * e;
  }
};

// is a < b beyond doubt, for two distances?
template <typename FT>
bool is_clearly_less(const FT& a, const FT& b)
{
  return a < b * (1 - Tolerance<FT>::distance());
}

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

// A sum of angles, each in [0, pi], kept as a direction and a number of full turns: sums without
// trigonometry. Directions are not normalised to unit length.
template <typename FT>
struct Angle_sum
{
  FT cosine = 1, sine = 0;
  int turns = 0;

  bool is_in_second_half() const
  {
    // (numbers, combined by & and |: no branch, as none of it can be predicted)
    const int is_below = sine < 0, is_on_axis = sine == 0, is_on_left = cosine < 0;
    return (is_below | (is_on_axis & is_on_left)) != 0;
  }

  // adds the angle between (1,0) and (dot, cross), where cross >= 0; nothing if both are zero.
  void add(const FT& dot, const FT& cross)
  {
    using std::abs;
    const FT size = FT(abs(dot)) + cross;
    if(!(size > 0))
      return;
    const FT scale = FT(1) / size;
    const FT c = dot * scale, s = cross * scale;
    const bool was_in_second_half = is_in_second_half();
    const FT rotated = cosine * c - sine * s;
    sine = cosine * s + sine * c;
    cosine = rotated;
    turns += was_in_second_half & !is_in_second_half();
  }

  // is the sum greater than 2 pi by more than the tolerance?
  bool is_more_than_full() const
  {
    if(turns != 1)
      return turns > 1;
    return is_in_second_half() || !is_near_axis();
  }

  // is the sum greater than pi by more than the tolerance?
  bool is_more_than_half() const
  {
    if(turns > 0)
      return true;
    return is_in_second_half() && (cosine >= 0 || !is_near_axis());
  }

private:
  // is the direction within the tolerance of the x axis, on the side it points to?
  bool is_near_axis() const
  {
    using std::abs;
    const FT width = 4 * Tolerance<FT>::angle();
    const FT c = abs(cosine), s = abs(sine);
    return s <= width * c && (turns == 0 || cosine > 0);
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_PLANAR_GEOMETRY_H
