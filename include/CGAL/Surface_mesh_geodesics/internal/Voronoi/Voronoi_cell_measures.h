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
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <algorithm>
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
// Error: rounding, and that of Arc_curve::bulge(). An arc adds to the cell on its left what it takes from the cell on
// its right, so its error cancels in the sum of all areas. In the layout of a face, the area of a part errs by the
// rounding of the face: all digits of a tiny cell are lost. So each part of a face has an origin of its own, on its
// border, and so has each cell, for centroids and for the areas of tiny cells. (Areas in the layout cancel better.)
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
    {
      Part& of_site = part(site, p);
      of_site.area += segment_integrals(p, q).area;
      of_site.local.add(segment_integrals(difference(p, of_site.origin), difference(q, of_site.origin)));
    });
    const auto arcs = complex.arcs_of_face(f);
    for(std::uint32_t a = arcs.first; a < arcs.second; ++a)
    {
      const Voronoi_arc<double>& arc = complex.arcs()[a];
      const Arc_curve curve(arc);
      const Border_integrals bulge = curve.bulge();
      const double area = curve.integrals(bulge, Point()).area;
      for(const bool is_left : {true, false})
      {
        Part& of_site = part(is_left ? arc.left_site : arc.right_site, arc.first);
        const double factor = is_left ? 1 : -1;
        of_site.area += factor * area;
        of_site.local.add(curve.integrals(bulge, of_site.origin), factor);
      }
    }
    for(const Part& p : m_parts)
      add_part(sum(p.site), p, layout, corner);
  }

  // Returns the area of a cell, 0 if it is empty. (Rounding may make the sum of a tiny cell negative.)
  double area(Vertex_id site) const
  {
    const auto it = m_sums.find(site);
    if(it == m_sums.end())
      return 0;
    const double area = it->second.area;
    return (std::max)(area < Tolerance<double>::tiny_area() ? it->second.local_area : area, 0.);
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
      p[k] = m_origin[k] + (s.origin[k] + s.moment[k] / s.local_area) * m_unit;
    return p;
  }

private:
  using Point = Planar_point<double>;

  // The origin is a point of the border of the cell, which the moment is relative to; both are scaled. `area` sums up
  // in the layouts of faces, `local_area` relative to the origins of the parts.
  struct Sum
  {
    double area = 0, local_area = 0;
    Space_point origin{}, moment{};
    bool has_origin = false;
  };

  // The part of a face in a cell: its area, and the integrals over it relative to an origin, both in the layout.
  struct Part
  {
    Vertex_id site;
    Point origin;
    double area;
    Border_integrals local;
  };

  // Returns the part of the current face in a cell; if it is new, `origin` becomes its origin. Few cells share a face,
  // so a linear search is fastest.
  Part& part(Vertex_id site, const Point& origin)
  {
    for(Part& p : m_parts)
      if(p.site == site)
        return p;
    m_parts.push_back(Part{site, origin, 0, Border_integrals()});
    return m_parts.back();
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
  void add_part(Sum& s, const Part& p, const std::array<Point, 3>& layout, const std::array<Space_point, 3>& corner)
    const
  {
    s.area += p.area;
    if(!(layout[1].x > 0) || !(layout[2].y > 0))
      return;
    // The linear part of the map from the layout to space, in terms of the sides that leave corner 0.
    const auto in_space = [&](double x, double y)
    {
      const double b2 = y / layout[2].y, b1 = (x - b2 * layout[2].x) / layout[1].x;
      Space_point v{};
      for(unsigned int k = 0; k < 3; ++k)
        v[k] = b1 * ((corner[1][k] - corner[0][k]) / m_unit) + b2 * ((corner[2][k] - corner[0][k]) / m_unit);
      return v;
    };
    Space_point origin = in_space(p.origin.x, p.origin.y);
    for(unsigned int k = 0; k < 3; ++k)
      origin[k] += (corner[0][k] - m_origin[k]) / m_unit;
    if(!s.has_origin)
      s.origin = origin;
    s.has_origin = true;
    s.local_area += p.local.area;
    const Space_point moment = in_space(p.local.x, p.local.y);
    for(unsigned int k = 0; k < 3; ++k)
      s.moment[k] += moment[k] + p.local.area * (origin[k] - s.origin[k]);
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
