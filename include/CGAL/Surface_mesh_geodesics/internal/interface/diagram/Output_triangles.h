// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_OUTPUT_TRIANGLES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_OUTPUT_TRIANGLES_H

// Adds vertices, edges and triangles to a mesh of the user, and makes its points. The builders of meshes share it
// (Voronoi_cut_mesh.h, Voronoi_cell_mesh.h); they decide which halfedges a triangle has.
//
// Halfedges are linked one by one, without Euler operations: these reject pinched vertices and two edges with the same
// ends, both of which a surface may have.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The points of the output: of vertices of the refined mesh, and of points in its faces. They are made in the number
// type of the traits and converted to double. `Diagram` is Lazy_Voronoi_diagram, which is referred to.
template <typename Diagram, typename OutputPoint>
class Output_points
{
public:
  explicit Output_points(const Diagram& diagram) : m_diagram(diagram) {}

  OutputPoint of_vertex(Vertex_id v) const { return converted(m_diagram.point_of_vertex(v)); }

  OutputPoint in_face(Face_id f, const Planar_point<double>& p) const
  {
    return converted(m_diagram.point(m_diagram.location(f, p)));
  }

private:
  static OutputPoint converted(const typename Diagram::Point_3& p)
  {
    return OutputPoint(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  const Diagram& m_diagram;
};

// OutputMesh is a model of MutableFaceGraph, which is referred to. `VertexPointMap` is writable, with the points of the
// output as values; it is copied. The builder links the border halfedges that are left.
template <typename OutputMesh, typename VertexPointMap>
class Output_triangles
{
  using Graph_traits = boost::graph_traits<OutputMesh>;

public:
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

  Output_triangles(OutputMesh& output, VertexPointMap vpm) : m_output(output), m_vpm(vpm) {}

  // Adds an isolated vertex to the output.
  vertex_descriptor new_vertex(const Point& p)
  {
    const vertex_descriptor v = add_vertex(m_output);
    put(m_vpm, v, p);
    set_halfedge(v, Graph_traits::null_halfedge(), m_output);
    return v;
  }

  // Adds an edge with both halfedges on the border and not linked yet; returns the halfedge that leads to `to`.
  halfedge_descriptor new_edge(vertex_descriptor from, vertex_descriptor to)
  {
    const halfedge_descriptor h = halfedge(add_edge(m_output), m_output), o = opposite(h, m_output);
    set_target(h, to, m_output);
    set_target(o, from, m_output);
    set_face(h, Graph_traits::null_face(), m_output);
    set_face(o, Graph_traits::null_face(), m_output);
    return h;
  }

  // Adds a face with three halfedges, given counterclockwise, and links these.
  face_descriptor new_triangle(const std::array<halfedge_descriptor, 3>& h)
  {
    const face_descriptor f = add_face(m_output);
    for(unsigned int k = 0; k < 3; ++k)
    {
      set_face(h[k], f, m_output);
      set_next(h[k], h[next_corner(k)], m_output);
      // Any halfedge will do inside; at the border, a border halfedge replaces it when that is linked.
      set_halfedge(target(h[k], m_output), h[k], m_output);
    }
    set_halfedge(f, h[0], m_output);
    return f;
  }

private:
  OutputMesh& m_output;
  VertexPointMap m_vpm;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_OUTPUT_TRIANGLES_H
