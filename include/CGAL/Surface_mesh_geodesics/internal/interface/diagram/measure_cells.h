// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_MEASURE_CELLS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_MEASURE_CELLS_H

// Adds up areas and centroids face by face. Corners are taken from the user's mesh by location, since a face of the
// refined mesh may be a part of one of the user's.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_cell_measures.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/distance_in_space.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/face_shape.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Gives the measures the first point of the mesh as origin and, as unit, the power of two above the largest difference
// of a coordinate from it. The unit of lengths need not fit: lengths may be given apart from the points.
template <typename TriangleMesh, typename VertexPointMap>
void clear_measures(const TriangleMesh& tm, const VertexPointMap& vertex_point_map, Voronoi_cell_measures& measures)
{
  std::array<double, 3> origin{};
  double largest = 0;
  bool is_first = true;
  for(const auto v : vertices(tm))
  {
    const std::array<double, 3> p = coordinates_in_space(get(vertex_point_map, v));
    if(is_first)
      origin = p;
    is_first = false;
    for(std::size_t k = 0; k < 3; ++k)
      largest = (std::max)(largest, std::abs(p[k] - origin[k]));
  }
  const int exponent = std::isfinite(largest) ? scaling_exponent(largest) : 0;
  measures.clear(origin, std::ldexp(1., (std::min)(exponent, std::numeric_limits<double>::max_exponent - 1)));
}

// Measures all cells of a Lazy_Voronoi_diagram that is built. Takes linear time.
template <typename Diagram>
void measure_cells(const Diagram& diagram, Voronoi_cell_measures& measures)
{
  clear_measures(diagram.mesh(), diagram.vertex_point_map(), measures);
  const std::size_t n = diagram.sites().empty() ? 0 : diagram.refined_mesh().number_of_faces();
  for(Face_id f = 0; f < n; ++f)
  {
    std::array<std::array<double, 3>, 3> corner;
    for(unsigned int k = 0; k < 3; ++k)
      corner[k] = coordinates_in_space(diagram.point(diagram.location_of_corner(f, k)));
    measures.add_face(diagram.complex(), f, corner);
  }
}

// Returns the vertex in the cell of site i that is nearest to the centroid in space, the first of several; the null
// vertex if the cell has no vertex. Takes time linear in the number of vertices of the mesh. A vertex on a wall is in
// the cell that nearest_site() tells.
template <typename Diagram>
typename Diagram::vertex_descriptor central_vertex(const Diagram& diagram, std::size_t i)
{
  using Point = typename Diagram::Point_3;
  const Point c = diagram.centroid(i);
  typename Diagram::vertex_descriptor best = boost::graph_traits<typename Diagram::Triangle_mesh>::null_vertex();
  double best_distance = std::numeric_limits<double>::infinity();
  for(const auto v : vertices(diagram.mesh()))
  {
    if(diagram.nearest_site(v) != i)
      continue;
    const double d = distance_in_space<Point>(c, get(diagram.vertex_point_map(), v));
    if(d < best_distance)
    {
      best = v;
      best_distance = d;
    }
  }
  return best;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_MEASURE_CELLS_H
