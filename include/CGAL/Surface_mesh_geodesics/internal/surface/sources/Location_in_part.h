// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_LOCATION_IN_PART_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_LOCATION_IN_PART_H

// The location of a point of a face in a triangle that is a part of the face. The point and the corners of the part are
// given by barycentric coordinates in the face; the class computes the coordinates in the part, and a bound on the
// rounding error of each.
//
// Parts may be narrow: between points on a line they are as wide as rounding makes them. The coordinates are uncertain
// then, but the point that they describe must be the given one. So one step of iterative refinement adds the
// coordinates of the residual; and a point that may be on an edge moves to the nearest point of that edge. Dropping a
// coordinate instead would move it along the part.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// All lengths and areas here are those of barycentric coordinates, not of the surface. coordinates() and rounding() are
// in the order of the corners given, and mean something if is_known().
template <typename FT>
class Location_in_part
{
public:
  using Barycentric = std::array<FT, 3>;

  // Measures from a corner of the shortest side and leaves out the largest coordinate of that corner. If two corners
  // are very near to each other, differences of the other coordinates are accurate relative to their distance.
  //
  // Formula (Cramer's rule): with u and v the differences of the two other corners and p that of the point from the
  // first corner, p = s u + t v has s = (p x v) / (u x v) and t = (u x p) / (u x v). The same for p - s u - t v
  // corrects s and t once. The coordinates are 1 - s - t at the first corner, s and t at the others.
  Location_in_part(const std::array<Barycentric, 3>& corner, const Barycentric& point)
  {
    using std::abs;
    for(unsigned int i = 1; i < 3; ++i)
      if(extent(corner[i], corner[(i + 1) % 3]) < extent(corner[m_first], corner[(m_first + 1) % 3]))
        m_first = i;
    const Barycentric& origin = corner[m_first];
    m_without = static_cast<unsigned int>(std::max_element(origin.begin(), origin.end()) - origin.begin());
    for(unsigned int i = 0; i < 3; ++i)
      m_corner[i] = difference(corner[i], origin);
    m_point = difference(point, origin);
    const unsigned int i = (m_first + 1) % 3, j = (m_first + 2) % 3;
    const Difference &u = m_corner[i], &v = m_corner[j];
    const FT area = cross(u, v);
    if(area == 0)
      return;
    m_has_area = true;
    FT s = cross(m_point, v) / area, t = cross(u, m_point) / area;
    const Difference rest{FT(m_point.x - s * u.x - t * v.x), FT(m_point.y - s * u.y - t * v.y), FT(0), FT(0)};
    s += cross(rest, v) / area;
    t += cross(u, rest) / area;
    m_coordinates[m_first] = 1 - s - t;
    m_coordinates[i] = s;
    m_coordinates[j] = t;
    m_rounding[i] = rounding_of_cross(m_point, v) / abs(area);
    m_rounding[j] = rounding_of_cross(u, m_point) / abs(area);
    m_rounding[m_first] = m_rounding[i] + m_rounding[j];
  }

  // Returns whether the coordinates mean anything: the part has an area, and no coordinate is uncertain by
  // Tolerance::known_coordinate() or more, as it is if rounding makes up the width of the part.
  bool is_known() const { return m_has_area && rounding() < Tolerance<FT>::known_coordinate(); }

  const Barycentric& coordinates() const { return m_coordinates; }

  // Returns the largest of the error bounds of the coordinates: Tolerance::placement() times the magnitudes of the
  // terms of the cross products, over the area. The rounding of the products themselves is not included.
  FT rounding() const { return *std::max_element(m_rounding.begin(), m_rounding.end()); }

  FT least_coordinate() const { return *std::min_element(m_coordinates.begin(), m_coordinates.end()); }

  // Moves the point to the edge or the corner on which it may be, given the error bounds. Requires: is_known(). Then
  // the largest coordinate, at least 1/3, exceeds its bound, so at least one is kept. On an edge the result may still
  // have a negative coordinate: it tells that the point is not in this part.
  void snap()
  {
    using std::abs;
    CGAL_assertion(is_known());
    std::array<unsigned int, 3> kept{0, 0, 0};
    unsigned int number = 0;
    for(unsigned int k = 0; k < 3; ++k)
      if(abs(m_coordinates[k]) > m_rounding[k])
        kept[number++] = k;
    if(number == 3)
      return;
    m_coordinates = Barycentric{FT(0), FT(0), FT(0)};
    const FT t = number == 2 ? parameter_on_edge(kept[0], kept[1]) : FT(0);
    m_coordinates[kept[0]] = 1 - t;
    if(number == 2)
      m_coordinates[kept[1]] = t;
  }

private:
  // Two coordinates relative to the first corner, and bounds on their rounding errors.
  struct Difference
  {
    FT x, y, rounding_of_x, rounding_of_y;
  };

  Difference difference(const Barycentric& p, const Barycentric& origin) const
  {
    using std::abs;
    const unsigned int i = (m_without + 1) % 3, j = (m_without + 2) % 3;
    return Difference{FT(p[i] - origin[i]), FT(p[j] - origin[j]),
                      FT(Tolerance<FT>::placement() * (abs(p[i]) + abs(origin[i]))),
                      FT(Tolerance<FT>::placement() * (abs(p[j]) + abs(origin[j])))};
  }

  static FT cross(const Difference& u, const Difference& v) { return u.x * v.y - u.y * v.x; }

  // Returns a bound of the error of cross(u, v), to first order in the bounds of the four coordinates.
  static FT rounding_of_cross(const Difference& u, const Difference& v)
  {
    using std::abs;
    return u.rounding_of_x * abs(v.y) + abs(u.x) * v.rounding_of_y + u.rounding_of_y * abs(v.x)
         + abs(u.y) * v.rounding_of_x;
  }

  // Returns the fraction of the side from corner i to corner j at which the line is nearest to the point; 0 if the side
  // has no length.
  FT parameter_on_edge(unsigned int i, unsigned int j) const
  {
    const FT x = m_corner[j].x - m_corner[i].x, y = m_corner[j].y - m_corner[i].y, square = x * x + y * y;
    return square > 0 ? FT(((m_point.x - m_corner[i].x) * x + (m_point.y - m_corner[i].y) * y) / square) : FT(0);
  }

  // Returns the distance of two corners as the sum of the differences of their coordinates.
  static FT extent(const Barycentric& a, const Barycentric& b)
  {
    using std::abs;
    return abs(FT(a[0] - b[0])) + abs(FT(a[1] - b[1])) + abs(FT(a[2] - b[2]));
  }

  // The corner from which differences are measured, and the coordinate that they leave out.
  unsigned int m_first = 0, m_without = 0;
  bool m_has_area = false;
  std::array<Difference, 3> m_corner;
  Difference m_point;
  Barycentric m_coordinates{}, m_rounding{};
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_LOCATION_IN_PART_H
