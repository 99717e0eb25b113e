// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_INTRINSIC_FACE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_INTRINSIC_FACE_H

// One face of an intrinsic mesh, and its layout in the plane.
//
// A record holds all there is to know of a face, in 64 bytes (a cache line) for double: its three lengths, its layout,
// its vertices and its neighbors. The shortest edge of a face is its halfedge 0 and the base of the layout. The
// coordinates of the two other corners are then accurate relative to every edge, for needles and for caps; a layout on
// a long edge would lose the direction of a short one.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The alignment of a face: a cache line for double, which a face fills; that of its members for other number types.
#ifdef _MSC_VER
#pragma warning(push)
#pragma warning(disable : 4324) // an empty class is padded to its alignment
#endif
struct alignas(64) Cache_line_alignment
{};
#ifdef _MSC_VER
#pragma warning(pop)
#endif

struct Alignment_of_members
{};

// A face: halfedge k leads from vertex[k] to vertex[k+1], has length[k], and opposite[k] is the halfedge of the
// neighbor, or null_id at the border. Corners 0, 1 and 2 are laid out counterclockwise at (0,0), (length[0],0) and
// (apex_x, apex_y).
//
// Invariants, from the moment at which the shape is set: length[0] is not greater than length[1] and length[2], and
// apex_y is not negative. mesh_invariants.h checks them.
template <typename FT>
struct Intrinsic_face : std::conditional<sizeof(FT) == 8, Cache_line_alignment, Alignment_of_members>::type
{
  std::array<FT, 3> length;
  FT apex_x, apex_y;
  std::array<Vertex_id, 3> vertex;
  std::array<Halfedge_id, 3> opposite;

  // Leaves the members uninitialized. (Without this constructor, a vector of faces would be zeroed before it is set.)
  Intrinsic_face() {}
};

// Returns the positions of the corners in the layout.
template <typename FT>
std::array<Planar_point<FT>, 3> layout_of_face(const Intrinsic_face<FT>& face)
{
  return {Planar_point<FT>{FT(0), FT(0)}, Planar_point<FT>{face.length[0], FT(0)},
          Planar_point<FT>{face.apex_x, face.apex_y}};
}

// Returns the length of the longest side. (Side 0 is the shortest.)
template <typename FT>
FT longest_side(const Intrinsic_face<FT>& f)
{
  return (std::max)(f.length[1], f.length[2]);
}

// Returns whether the corners lie on one line up to rounding: twice the area, apex_y * length[0], is at most
// Tolerance::length() times the square of the longest side. Ties count as flat.
template <typename FT>
bool has_no_height(const Intrinsic_face<FT>& f)
{
  return is_without_height<FT>(f.apex_y * f.length[0], longest_side(f));
}

// The same with Tolerance::narrow_face(): paths that cross the face nearly along its longest side tie, up to rounding,
// with those through its corners.
template <typename FT>
bool is_narrow(const Intrinsic_face<FT>& f)
{
  return is_without_height<FT>(f.apex_y * f.length[0], longest_side(f), Tolerance<FT>::narrow_face());
}

// Returns the dot product and the cross product of the two sides at corner k of a face. They have the direction of the
// angle, in [0, pi]; both are zero if the face has no size.
template <typename FT>
std::pair<FT, FT> angle_direction(const Intrinsic_face<FT>& f, unsigned int k)
{
  // (Computes all three: a branch on k would be hard to predict.)
  const FT& base = f.length[0];
  const FT rest = base - f.apex_x;
  const FT dot[3] = {base * f.apex_x, base * rest, f.apex_y * f.apex_y - f.apex_x * rest};
  return {dot[k], base * f.apex_y};
}

// The face on the left of a halfedge AB in the frame of the halfedge: A = (0,0), B = (length,0), and the third vertex
// is C = (apex_x, apex_y) with apex_y >= 0. apex_rest is length - apex_x, computed without cancellation if C is near B.
// The windows that enter the face across AB leave it across the left edge AC or the right edge CB.
template <typename FT>
struct Face_frame
{
  FT length, apex_x, apex_rest, apex_y, left_length, right_length;
  Vertex_id origin, target, apex;
  Halfedge_id left, right; // the halfedges AC and CB of the neighbors, or null_id
};

// Sets the position of the apex in the frame of halfedge k, by similar triangles: each side of the frame is the side of
// the layout times length[0] / length[k].
//
// Error bound, to first order in u = epsilon() / 2, relative to either side that ends at the apex. The ratio, the part
// and their product add 3 u to the foot and 2 u to the height; the foot in the layout errs by 6.5 u of the side and the
// height by 10.5 u of itself (planar_triangle_from_lengths()). As the ratio times a side of the layout is at most
// length[0], and with u for the rest, the apex errs by sqrt((7.5 + 3 c)^2 + (12.5 s)^2) u for an angle with the cosine
// c and the sine s: less than 15 u, that is, 8 epsilon() in each frame. From points: set_shape_from_sides().
// Laws: scaling all lengths by a power of two scales the result exactly.
template <typename FT>
void set_apex(const Intrinsic_face<FT>& f, unsigned int k, Face_frame<FT>& c)
{
  // (One formula for all three halfedges, as a branch would be hard to predict. For k = 0 the ratio is 1.)
  const FT& base = f.length[0];
  const FT& side = f.length[k];
  const FT part[3] = {f.apex_x, base - f.apex_x, f.apex_x};
  const FT ratio = side > 0 ? FT(base / side) : FT(k == 0 ? 1 : 0); // 0: all edges of the face have no length
  FT end[2]; // of the sides below the apex
  end[0] = part[k] * ratio;
  end[1] = side - end[0];
  c.apex_x = end[k >> 1];
  c.apex_rest = end[1 - (k >> 1)];
  c.apex_y = f.apex_y * ratio;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_INTRINSIC_FACE_H
