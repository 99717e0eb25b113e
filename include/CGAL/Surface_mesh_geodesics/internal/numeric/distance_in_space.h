// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_DISTANCE_IN_SPACE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_DISTANCE_IN_SPACE_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The Euclidean distance of two points of any kernel, as a double. std::hypot() lets no square overflow or vanish. The
// coordinates are subtracted in the numbers of the kernel: only their differences are rounded to double.
template <typename Point>
double distance_in_space(const Point& p, const Point& q)
{
  return std::hypot(CGAL::to_double(q.x() - p.x()), CGAL::to_double(q.y() - p.y()), CGAL::to_double(q.z() - p.z()));
}

// The coordinates of a point of any kernel, as doubles.
template <typename Point>
std::array<double, 3> coordinates_in_space(const Point& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

// The length of the diagonal of the bounding box of the points of a mesh. Infinite if there are none, or if one is
// infinite. Takes linear time.
template <typename Graph, typename VertexPointMap>
double diagonal_of_bounding_box(const Graph& tm, VertexPointMap vpm)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> least{infinity, infinity, infinity}, greatest{-infinity, -infinity, -infinity};
  for(const auto v : vertices(tm))
  {
    const std::array<double, 3> p = coordinates_in_space(get(vpm, v));
    for(std::size_t k = 0; k < 3; ++k)
    {
      least[k] = (std::min)(least[k], p[k]);
      greatest[k] = (std::max)(greatest[k], p[k]);
    }
  }
  return std::hypot(greatest[0] - least[0], greatest[1] - least[1], greatest[2] - least[2]);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_DISTANCE_IN_SPACE_H
