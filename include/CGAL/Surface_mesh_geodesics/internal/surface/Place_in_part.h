// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_PLACE_IN_PART_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_PLACE_IN_PART_H

// Where a point of a face is in a triangle that is a part of the face. Points and corners are given by their
// coordinates in the face; those in the part are looked for, and how much of each may be rounding.
//
// Parts may be narrow: between points on a line they have the width of rounding. There the coordinates are not well
// known, but the point that they describe has to be the one that is given. So they are improved by the coordinates of
// what is left of the difference; and a point that may be on an edge is put at the nearest point of that edge, instead
// of dropping a coordinate, which would move it along the part.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
class Place_in_part
{
public:
  using Barycentric = std::array<FT, 3>;

  // Two corners may be very near to each other. Then all is measured from one of them, without its largest coordinate:
  // the differences of the others are accurate relative to the distance of the two.
  Place_in_part(const std::array<Barycentric, 3>& corner, const Barycentric& point)
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
    m_exists = true;
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

  // false if the part has no area, or if its width is rounding: then the coordinates mean nothing.
  bool is_known() const { return m_exists && rounding() < FT(1) / 4; }

  const Barycentric& coordinates() const { return m_coordinates; }

  // the largest part of a coordinate that may be rounding.
  FT rounding() const { return *std::max_element(m_rounding.begin(), m_rounding.end()); }

  FT least_coordinate() const { return *std::min_element(m_coordinates.begin(), m_coordinates.end()); }

  // puts the point on the edge or the corner where it may be.
  void snap()
  {
    using std::abs;
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
  // Two coordinates relative to the first corner, and what rounding may have made of them.
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

  static FT rounding_of_cross(const Difference& u, const Difference& v)
  {
    using std::abs;
    return u.rounding_of_x * abs(v.y) + abs(u.x) * v.rounding_of_y + u.rounding_of_y * abs(v.x)
         + abs(u.y) * v.rounding_of_x;
  }

  // the place between corner i and corner j that is nearest to the point.
  FT parameter_on_edge(unsigned int i, unsigned int j) const
  {
    const FT x = m_corner[j].x - m_corner[i].x, y = m_corner[j].y - m_corner[i].y, square = x * x + y * y;
    return square > 0 ? FT(((m_point.x - m_corner[i].x) * x + (m_point.y - m_corner[i].y) * y) / square) : FT(0);
  }

  static FT extent(const Barycentric& a, const Barycentric& b)
  {
    using std::abs;
    return abs(FT(a[0] - b[0])) + abs(FT(a[1] - b[1])) + abs(FT(a[2] - b[2]));
  }

  unsigned int m_first = 0, m_without = 0;
  bool m_exists = false;
  std::array<Difference, 3> m_corner;
  Difference m_point;
  Barycentric m_coordinates{}, m_rounding{};
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_PLACE_IN_PART_H
