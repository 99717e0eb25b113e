// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_UNFOLDING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_UNFOLDING_H

// From the frame of a halfedge AB to the frames of the two other sides of its face, AC on the left and CB on the right
// (Face_frame in Intrinsic_face.h). An image that lies below AB is turned about A, or about B, until the side is the x
// axis. This is one step of unfolding (thesis 3.3.1), for one image.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The angle between AB and a side: of AC with AB at A, or of BC with BA at B. Both are in [0, pi], so sine >= 0.
// Error: half an epsilon for each quotient, beyond the error of the frame (set_apex()). That is relative to the sides,
// also for needles; the sum of squares is 1 up to the same error. Tolerance::distance() adds it up for many faces.
template <typename FT>
struct Side_angle
{
  FT cosine, sine;
};

// Requires: c.left_length > 0.
template <typename FT>
Side_angle<FT> left_angle(const Face_frame<FT>& c)
{
  CGAL_expensive_assertion(c.left_length > 0);
  return {c.apex_x / c.left_length, c.apex_y / c.left_length};
}

// Requires: c.right_length > 0.
template <typename FT>
Side_angle<FT> right_angle(const Face_frame<FT>& c)
{
  CGAL_expensive_assertion(c.right_length > 0);
  return {c.apex_rest / c.right_length, c.apex_y / c.right_length};
}

// An image below an edge: `x` is its abscissa, `depth` its distance from the line of the edge.
template <typename FT>
struct Image_below_edge
{
  FT x, depth;
};

// Returns the image in the frame of a side with this angle at the common corner. `x` counts from that corner, for the
// given image and for the result: along AB from A and along AC for the left side, along BA from B and along BC for the
// right one. The depth is negative if the image lies above the line of the side, from where the side is not seen.
// Formula: a rotation by the angle, (x cos - depth sin, x sin + depth cos).
// Error: at most two epsilon of |x| + depth per step beyond that of the angle.
// Law: a rotation keeps the distance from the corner, up to that error.
template <typename FT>
Image_below_edge<FT> image_below_side(const Side_angle<FT>& angle, const FT& x, const FT& depth)
{
  return {x * angle.cosine - depth * angle.sine, x * angle.sine + depth * angle.cosine};
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_UNFOLDING_H
