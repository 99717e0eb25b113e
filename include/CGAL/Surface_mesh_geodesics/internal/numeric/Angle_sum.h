// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_ANGLE_SUM_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_ANGLE_SUM_H

// The sum of the angles around a vertex, and its comparison with pi and 2 pi, without trigonometry.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

#include <CGAL/assertions.h>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A sum of angles, each in [0, pi], as a direction and a number of full turns.
//
// The direction (cosine, sine) is not normalized. An angle t is scaled by |dot| + |cross|, which shortens the direction
// to 1 / (|cos t| + |sin t|), at least 1 / sqrt(2), of its length: it takes two thousand angles of 45 degrees, 250 full
// turns, to underflow, while small angles hardly shorten it.
//
// Error bound, to first order in u = epsilon() / 2: the products with the scale round each coordinate by u, which
// turns the angle by u at most; the rotation rounds each coordinate by 2 u of the length of the direction, which turns
// it by 3 u at most. If dot and cross turn the angle by another 4 u, n angles err by 8 n u = 4 n epsilon().
// is_near_axis() absorbs the error of a thousand faces around a vertex.
template <typename FT>
struct Angle_sum
{
  FT cosine = 1, sine = 0;
  int turns = 0;

  // Is the direction in [pi, 2 pi)?
  bool is_in_second_half() const
  {
    // Integers combined by & and |: branches on the direction cannot be predicted.
    const int is_below = sine < 0, is_on_axis = sine == 0, is_on_left = cosine < 0;
    return (is_below | (is_on_axis & is_on_left)) != 0;
  }

  // Adds the angle between (1,0) and (dot, cross). Adds nothing if both are zero.
  // Requires: cross >= 0.
  void add(const FT& dot, const FT& cross)
  {
    using std::abs;
    CGAL_assertion(cross >= 0);
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

  // Is the sum greater than 2 pi by more than the tolerance?
  bool is_more_than_full() const
  {
    if(turns != 1)
      return turns > 1;
    return is_in_second_half() || !is_near_axis();
  }

  // Is the sum 2 pi, up to the tolerance?
  bool is_full() const { return (turns == 1 || (turns == 0 && sine < 0)) && cosine > 0 && is_near_axis(); }

  // Is the sum greater than pi by more than the tolerance?
  bool is_more_than_half() const
  {
    if(turns > 0)
      return true;
    return is_in_second_half() && (cosine >= 0 || !is_near_axis());
  }

private:
  // Is the direction that of the x axis or, before the first full turn, its opposite?
  //
  // The tolerance is angle() times pi. The factor is 4, the next power of two, so that the product is exact; near the
  // axis, the quotient of sine and cosine is the angle up to its cube.
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

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_ANGLE_SUM_H
