// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// The numbers of a window, or of several windows, one in each lane; and the distances that follow from them.
//
// Included once for each number of lanes; see README.md.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {
namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE {

// Window.h says what these numbers mean and which invariants they satisfy.
template <typename FT>
struct Window_numbers
{
  using Number = typename Lanes<FT>::Number;

  Number begin, end;
  Number image_x, image_depth;
  Number begin_distance, end_distance;
  Number root_distance;

  // The distance at the point (x,0) along the line from the image, whether the interval contains x or not:
  //   root_distance + sqrt((x - image_x)^2 + image_depth^2).
  //
  // Error bound, to first order in u = epsilon() / 2, if x and the members are exact: the difference errs by u,
  // its square by 3 u, the sum of squares by 4 u, the root by 3 u, the result by 4 u = 2 epsilon(), all relative.
  // Laws: multiplying all lengths by a power of two multiplies the result, bit by bit; mirroring x and image_x at one
  // point keeps it if the mirror images are exact.
  Number distance_at(const Number& x) const
  {
    using L = Lanes<FT>;
    const Number dx = x - image_x;
    return root_distance + L::square_root(L::rounded_product(dx, dx) + L::rounded_product(image_depth, image_depth));
  }

  // The smallest distance at a point of the interval. If the foot of the image is an end, the distance is that of the
  // end.
  Number minimum_distance() const
  {
    using L = Lanes<FT>;
    const Number inside = root_distance + image_depth;
    return L::select(L::less_equal(image_x, begin), begin_distance,
                     L::select(L::less_equal(end, image_x), end_distance, inside));
  }
};

} // namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_LANES
