// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_ENERGY_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_ENERGY_H

// The energy that Lloyd's method lowers: the sum over all cells of the integral of the squared distance in space from
// the site. (Its step moves each site toward the centroid of the cell in space, not to a geodesic center.) Cells of
// curves do not count: a curve has no point in space to measure from, and the step does not move it.
//
// Formula: in a face, a point (x, y) of the layout is at O + x U + y V, seen from the site. So the squared distance is
//   O.O + 2 O.U x + 2 O.V y + U.U x^2 + 2 U.V x y + V.V y^2,
// and its integral follows from those of 1, x, y, x^2, xy and y^2 over the part of the cell in the face. These are
// integrals along the border of that part, as for areas (Voronoi_cell_measures.h).

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Arc_curve.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/distance_in_space.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Diagram` is Lazy_Voronoi_diagram, which is built and is referred to.
//
// Integrals are in the unit of the intrinsic mesh, in the layout of a face; U and V carry them to the user's unit, but
// for the unit of the area, which sum() multiplies at the end.
//
// Error: rounding, and that of Arc_curve. An arc adds to the cell on its left what it takes from the one on its right.
// No digits are lost far from the origin of space, because all vectors begin at the site.
template <typename Diagram>
class Cell_energy
{
  using Space_vector = std::array<double, 3>;
  using Point = Planar_point<double>;

public:
  explicit Cell_energy(const Diagram& diagram) : m_diagram(diagram) {}

  // Returns the energy of the cells of points, in the fourth power of the user's unit. Takes time linear in the number
  // of faces and arcs. Call it once.
  double sum()
  {
    double result = 0;
    for(Face_id f = 0; f < m_diagram.refined_mesh().number_of_faces(); ++f)
      result += of_face(f);
    return result * m_diagram.unit() * m_diagram.unit();
  }

private:
  // The part of a face in a cell, with the integrals over it in the layout of the face.
  struct Part
  {
    Vertex_id site;
    Border_integrals first;
    Second_integrals second;
  };

  // Returns the energy of the parts of a face; 0 for a face without height, without a site, or of curves alone.
  double of_face(Face_id f)
  {
    const auto layout = m_diagram.complex().layout(f);
    if(!(layout[1].x > 0) || !(layout[2].y > 0))
      return 0;
    collect_parts(f);
    m_parts.erase(std::remove_if(m_parts.begin(), m_parts.end(),
                                 [this](const Part& p) { return m_diagram.is_cell_of_curve(p.site); }),
                  m_parts.end());
    if(m_parts.empty())
      return 0;
    std::array<Space_vector, 3> corner;
    for(unsigned int k = 0; k < 3; ++k)
      corner[k] = coordinates_in_space(m_diagram.point(m_diagram.location(f, layout[k])));
    Space_vector u, v;
    for(unsigned int i = 0; i < 3; ++i)
    {
      u[i] = (corner[1][i] - corner[0][i]) / layout[1].x;
      v[i] = (corner[2][i] - corner[0][i] - layout[2].x * u[i]) / layout[2].y;
    }
    double result = 0;
    for(const Part& p : m_parts)
    {
      Space_vector o = coordinates_in_space(m_diagram.point_of_cell(p.site));
      for(unsigned int i = 0; i < 3; ++i)
        o[i] = corner[0][i] - o[i];
      result += dot(o, o) * p.first.area + 2 * dot(o, u) * p.first.x + 2 * dot(o, v) * p.first.y
              + dot(u, u) * p.second.xx + 2 * dot(u, v) * p.second.xy + dot(v, v) * p.second.yy;
    }
    return result;
  }

  // Finds the parts of a face. An arc counts for the cell on its left, and backward for the cell on its right.
  void collect_parts(Face_id f)
  {
    const auto& complex = m_diagram.complex();
    m_parts.clear();
    complex.for_each_border_interval(f, [&](Vertex_id site, const Point& p, const Point& q)
    {
      part(site).first.add(segment_integrals(p, q));
      part(site).second.add(second_segment_integrals(p, q));
    });
    const auto arcs = complex.arcs_of_face(f);
    for(std::uint32_t a = arcs.first; a < arcs.second; ++a)
    {
      const auto& arc = complex.arcs()[a];
      const Arc_curve curve(arc);
      const Border_integrals first = curve.integrals(curve.bulge(), Point());
      const Second_integrals second = curve.second_integrals();
      part(arc.left_site).first.add(first);
      part(arc.left_site).second.add(second);
      part(arc.right_site).first.add(first, -1);
      part(arc.right_site).second.add(second, -1);
    }
  }

  // Returns the part of the present face in a cell. Few cells share a face.
  Part& part(Vertex_id site)
  {
    for(Part& p : m_parts)
      if(p.site == site)
        return p;
    m_parts.push_back(Part{site, Border_integrals(), Second_integrals()});
    return m_parts.back();
  }

  static double dot(const Space_vector& a, const Space_vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  const Diagram& m_diagram;
  std::vector<Part> m_parts; // of the present face
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_ENERGY_H
