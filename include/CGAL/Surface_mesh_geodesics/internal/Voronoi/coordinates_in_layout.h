// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_COORDINATES_IN_LAYOUT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_COORDINATES_IN_LAYOUT_H

// The barycentric coordinates of a point that is given in the layout of a face, and the points of its sides. A diagram
// needs them to put nodes and arcs into space.
//
// Frame: the layout of the face (corners 0, 1 and 2 at (0,0), (length[0],0) and (apex_x,apex_y)).

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_face.h>

#include <array>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Returns the coordinates of the point of side k nearest to p: two of them are not negative and sum up to 1, the third
// one is 0. In a face without height, that is p itself if side k is a longest one. A side without length gives its
// first corner.
template <typename FT>
std::array<FT, 3> coordinates_on_side(const Intrinsic_face<FT>& face, unsigned int k, const Planar_point<FT>& p)
{
  const std::array<Planar_point<FT>, 3> corner = layout_of_face(face);
  std::array<FT, 3> result{FT(0), FT(0), FT(0)};
  result[next_corner(k)] = nearest_fraction(p, corner[k], corner[next_corner(k)]);
  result[k] = 1 - result[next_corner(k)];
  return result;
}

// Returns the coordinates of the point of the border nearest to p, on the first such side in a tie. (To set negative
// coordinates to zero instead would move the point along a narrow face.)
template <typename FT>
std::array<FT, 3> coordinates_on_border(const Intrinsic_face<FT>& face, const Planar_point<FT>& p)
{
  const std::array<Planar_point<FT>, 3> corner = layout_of_face(face);
  std::array<FT, 3> best{};
  FT smallest = std::numeric_limits<FT>::infinity();
  for(unsigned int k = 0; k < 3; ++k)
  {
    const std::array<FT, 3> b = coordinates_on_side(face, k, p);
    const FT d = distance(p, point_of_triangle(corner, b));
    if(d < smallest)
    {
      best = b;
      smallest = d;
    }
  }
  return best;
}

// Returns the barycentric coordinates of a point in the layout of a face. None of them is negative: a point outside,
// which is so by rounding, is replaced by the nearest point of the border. In a face without height the height of a
// point tells nothing; there the point is measured along the longest side, which covers the whole face.
//
// Formula: p = b0 (0,0) + b1 (length[0],0) + b2 (apex_x,apex_y) and b0 + b1 + b2 = 1, solved for b2 first. Neither
// divisor is 0 in a face with a height.
template <typename FT>
std::array<FT, 3> coordinates_in_layout(const Intrinsic_face<FT>& face, const Planar_point<FT>& p)
{
  if(has_no_height(face))
    return coordinates_on_side(face, face.length[1] < face.length[2] ? 2 : 1, p); // side 0 is the shortest
  std::array<FT, 3> b;
  b[2] = p.y / face.apex_y;
  b[1] = (p.x - b[2] * face.apex_x) / face.length[0];
  b[0] = 1 - b[1] - b[2];
  return b[0] >= 0 && b[1] >= 0 && b[2] >= 0 ? b : coordinates_on_border(face, p);
}

// Returns the point of side k of a face at a fraction of its length, from its source, given the corners in the layout.
template <typename FT>
Planar_point<FT> point_on_side(const std::array<Planar_point<FT>, 3>& corner, unsigned int k, const FT& fraction)
{
  const Planar_point<FT> a = corner[k], b = corner[next_corner(k)];
  return Planar_point<FT>{FT(a.x + fraction * (b.x - a.x)), FT(a.y + fraction * (b.y - a.y))};
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_COORDINATES_IN_LAYOUT_H
