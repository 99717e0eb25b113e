// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_VORONOI_CELL_MEASURES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_VORONOI_CELL_MEASURES_H

// Areas and centroids of cells. Each face adds its parts to the cells that it lies in, by integrals along the borders
// of these parts: along the border of the face from breakpoint to breakpoint, and along each arc once for both of its
// sides. So the areas of all cells add up to the area that is reached, up to rounding.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Arc_curve.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Use: clear(), then add_face() for each face that is reached. Takes time proportional to the number of faces and arcs.
// Areas are in the squared unit of the intrinsic mesh, centroids in the unit of the given positions. Moments are summed
// up for positions in a frame of their own, near 1, because products of very small or large numbers leave the range of
// double.
// Formula: the centroid of a cell is the integral of the position over it, divided by its area. The moment is the
// integral of (position - origin) / unit.
// Error: rounding, and that of Arc_curve::integrals(). An arc adds to the cell on its left what it takes from the cell
// on its right, so its error cancels in the sum of all areas.
class Voronoi_cell_measures
{
public:
  using Space_point = std::array<double, 3>;

  // Removes all sums. `origin` is a point near the corners, `unit` a power of two about as large as their largest
  // difference from it.
  void clear(const Space_point& origin, double unit)
  {
    m_sums.clear();
    m_last_sum = nullptr;
    m_origin = origin;
    m_unit = unit;
  }

  // Adds a face, given the positions of its corners in space. By Green's theorem, each part of the face gets the
  // integrals along its border: an arc counts for the cell on its left, and backward for the cell on its right. A face
  // that no site reaches adds nothing. Requires: the complex is finished.
  void add_face(const Voronoi_complex<double>& complex, Face_id f, const std::array<Space_point, 3>& corner)
  {
    const auto layout = complex.layout(f);
    m_parts.clear();
    complex.for_each_border_interval(
      f, [&](Vertex_id site, const Planar_point<double>& p, const Planar_point<double>& q)
    { part(site).add(segment_integrals(p, q)); });
    const auto arcs = complex.arcs_of_face(f);
    for(std::uint32_t a = arcs.first; a < arcs.second; ++a)
    {
      const Voronoi_arc<double>& arc = complex.arcs()[a];
      const Border_integrals i = Arc_curve(arc).integrals();
      part(arc.left_site).add(i);
      part(arc.right_site).add(i, -1);
    }
    for(const Part& p : m_parts)
      add_part(sum(p.site), p.integrals, layout, corner);
  }

  // Returns the area of a cell, 0 if it is empty. (Rounding may make the sum of a tiny cell negative.)
  double area(Vertex_id site) const
  {
    const auto it = m_sums.find(site);
    return it == m_sums.end() ? 0 : (std::max)(it->second.area, 0.);
  }

  // Returns the centroid of a cell in space, which need not lie on the surface. It is not finite if the cell has no
  // area.
  Space_point centroid(Vertex_id site) const
  {
    Sum s;
    const auto it = m_sums.find(site);
    if(it != m_sums.end())
      s = it->second;
    Space_point p;
    for(unsigned int k = 0; k < 3; ++k)
      p[k] = m_origin[k] + s.moment[k] / s.area * m_unit;
    return p;
  }

private:
  struct Sum
  {
    double area = 0;
    Space_point moment{};
  };

  // The part of a face in a cell, with the integrals over it in the layout of the face.
  struct Part
  {
    Vertex_id site;
    Border_integrals integrals;
  };

  // Returns the part of the current face in a cell. Few cells share a face, so a linear search is fastest.
  Border_integrals& part(Vertex_id site)
  {
    for(Part& p : m_parts)
      if(p.site == site)
        return p.integrals;
    m_parts.push_back(Part{site, Border_integrals()});
    return m_parts.back().integrals;
  }

  // Returns the sums of a cell. The last one is remembered, as adjacent faces mostly share it.
  Sum& sum(Vertex_id site)
  {
    if(m_last_sum == nullptr || m_last_site != site)
    {
      m_last_sum = &m_sums[site];
      m_last_site = site;
    }
    return *m_last_sum;
  }

  // Adds a part of a face to the sums of its cell. Barycentric coordinates carry the integrals from the layout to
  // space, since both maps are affine. A face without height has no area, and no moment either.
  void add_part(Sum& s, const Border_integrals& integrals, const std::array<Planar_point<double>, 3>& layout,
                const std::array<Space_point, 3>& corner) const
  {
    s.area += integrals.area;
    if(!(layout[1].x > 0) || !(layout[2].y > 0))
      return;
    // The integrals of the three barycentric coordinates over the part: y / apex_y, (x - b2 apex_x) / length[0], and
    // what is missing to 1, integrated.
    const double b2 = integrals.y / layout[2].y, b1 = (integrals.x - b2 * layout[2].x) / layout[1].x,
                 b0 = integrals.area - b1 - b2;
    const auto scaled = [&](unsigned int i, unsigned int k) { return (corner[i][k] - m_origin[k]) / m_unit; };
    for(unsigned int k = 0; k < 3; ++k)
      s.moment[k] += b0 * scaled(0, k) + b1 * scaled(1, k) + b2 * scaled(2, k);
  }

  std::unordered_map<Vertex_id, Sum> m_sums; // by the vertex of the site; its elements do not move
  Vertex_id m_last_site = null_id;           // means nothing if m_last_sum is null
  Sum* m_last_sum = nullptr;
  Space_point m_origin{};
  double m_unit = 1;
  std::vector<Part> m_parts; // of a face
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_VORONOI_CELL_MEASURES_H
