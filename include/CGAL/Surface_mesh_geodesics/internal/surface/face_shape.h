// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_FACE_SHAPE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_FACE_SHAPE_H

// The shape of a face from bare numbers: three lengths, or three points. Here lengths are ordered so that the shortest
// one is the base, and scaled so that their squares stay within the range of numbers.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_face.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The largest length of a user for which distances, which are sums of lengths, stay finite: 2^960 leaves a factor of
// 2^63 to the largest double.
inline double largest_extent() { return std::ldexp(1., 960); }

// The minimum extent of a component (its longest edge), relative to the unit of its mesh. Products of four such lengths
// are 2^-800, above the least normal double 2^-1022.
inline double smallest_component() { return std::ldexp(1., -200); }

// Returns the exponent of a power of two that is about as large as the extent of a mesh, and whose inverse is finite.
inline int scaling_exponent(double extent)
{
  int exponent = 0;
  std::frexp(extent, &exponent);
  return (std::max)(exponent, -960);
}

// Sets the lengths of a face such that the shortest of the given ones becomes length[0]; returns which one that is. Of
// equal lengths, the earlier one counts as shorter.
template <typename FT>
unsigned int set_lengths(const std::array<FT, 3>& length, Intrinsic_face<FT>& f)
{
  // (A table instead of branches: no processor predicts which edge is the shortest.)
  constexpr unsigned int shortest[8] = {2, 1, 2, 1, 2, 2, 0, 0};
  const unsigned int shift = shortest[4u * (length[0] <= length[1]) + 2u * (length[0] <= length[2])
                                      + 1u * (length[1] <= length[2])];
  for(unsigned int k = 0; k < 3; ++k)
    f.length[k] = length[corner_after(k, shift)];
  return shift;
}

// Sets the lengths and the layout of a face with the given lengths; returns which of them became length[0]. An edge
// that is longer than the two others together gives a face without height.
template <typename FT>
unsigned int set_shape_from_lengths(const std::array<FT, 3>& length, Intrinsic_face<FT>& f)
{
  const unsigned int shift = set_lengths(length, f);
  const Planar_triangle<FT> t = planar_triangle_from_lengths(f.length[0], f.length[1], f.length[2]);
  f.apex_x = t.apex_x;
  f.apex_y = t.apex_y;
  return shift;
}

// Returns whether one edge of a face exceeds the sum of the two others by more than Tolerance::triangle_inequality()
// times its length.
template <typename FT>
bool violates_triangle_inequality(const Intrinsic_face<FT>& f)
{
  const FT longest = longest_side(f);
  const FT others = f.length[0] + (std::min)(f.length[1], f.length[2]);
  return longest - others > Tolerance<FT>::triangle_inequality() * longest;
}

// A vector of space, on bare numbers.
template <typename FT>
struct Space_vector
{
  FT x, y, z;

  FT length() const
  {
    using std::sqrt;
    return sqrt(dot(*this, *this));
  }

  friend FT dot(const Space_vector& a, const Space_vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

  friend Space_vector cross(const Space_vector& a, const Space_vector& b)
  {
    return {FT(a.y * b.z - a.z * b.y), FT(a.z * b.x - a.x * b.z), FT(a.x * b.y - a.y * b.x)};
  }
};

// Sets the lengths and the layout of a face from its sides, where side[k] leads from vertex k to vertex k+1; returns
// which of them became side 0. Both faces of an edge compute its length to the same bits, as only signs differ.
//
// In the layout, apex_x is the projection of the third side on the base, and apex_y twice the area over the base: the
// cross product is accurate also for needles, as the base is their short side.
//
// Error bound, to first order in u = epsilon() / 2, for exact sides whose sum is 0. A length errs by 2.5 u of itself.
// With a = length[0] and c = length[2], the dot product errs by 3 u a c and the cross product by 2 sqrt(4/3) u a c (the
// norm of the sums |a_y c_z| + |a_z c_y|, ...), its length by another 2.5 u. Dividing by lengths gives a foot and a
// height in the frame of side k (set_apex()). Take the worst sign of each rounding error: for triangles of all shapes,
// the apex errs by less than 19.5 u of either side that ends there, that is, by 10 epsilon(). test_laws_in_faces
// measures less than 5.
//
// Inlined by force: it runs once per face, and reading a mesh is a fifth of the time of a call. GCC 12 would not inline
// it by itself.
template <typename FT>
BOOST_FORCEINLINE unsigned int set_shape_from_sides(const std::array<Space_vector<FT>, 3>& side, Intrinsic_face<FT>& f)
{
  const unsigned int shift = set_lengths<FT>({side[0].length(), side[1].length(), side[2].length()}, f);
  if(!(f.length[0] > 0))
  {
    f.apex_x = f.length[2];
    f.apex_y = 0;
    return shift;
  }
  const Space_vector<FT>& base = side[shift];
  const Space_vector<FT>& from_apex = side[previous_corner(shift)]; // to corner 0
  f.apex_x = -dot(base, from_apex) / f.length[0];
  f.apex_y = cross(base, from_apex).length() / f.length[0];
  return shift;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_FACE_SHAPE_H
