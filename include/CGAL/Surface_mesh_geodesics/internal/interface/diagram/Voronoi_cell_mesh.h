// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_CELL_MESH_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_CELL_MESH_H

// Adds the triangles of one cell to a mesh of the user.

#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Cell_triangles.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Output_triangles.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Links the halfedges that have no triangle. At each vertex, the one that enters along one umbrella is followed by the
// one that leaves along the next umbrella, so that a walk around a pinched vertex meets all umbrellas that have a
// border. The output is referred to.
template <typename OutputMesh>
class Output_border
{
  using Graph_traits = boost::graph_traits<OutputMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  explicit Output_border(OutputMesh& output) : m_output(output) {}

  // Links the border halfedges among the given edges. Requires: these are all edges at their ends, and the triangles
  // have been added. Takes time linear in the number of triangles, times the logarithm of the number of vertices.
  void link(const std::vector<halfedge_descriptor>& edges)
  {
    using Umbrella = std::pair<halfedge_descriptor, halfedge_descriptor>; // entering, leaving
    std::map<vertex_descriptor, std::vector<Umbrella>> umbrellas;
    for(const halfedge_descriptor e : edges)
      for(const halfedge_descriptor h : {e, opposite(e, m_output)})
        if(is_border(h))
          umbrellas[target(h, m_output)].emplace_back(h, leaving(h));
    for(const auto& at_vertex : umbrellas)
    {
      const std::vector<Umbrella>& u = at_vertex.second;
      for(std::size_t i = 0; i < u.size(); ++i)
        set_next(u[i].first, u[(i + 1) % u.size()].second, m_output);
      set_halfedge(at_vertex.first, u.front().first, m_output);
    }
  }

private:
  bool is_border(halfedge_descriptor h) const { return face(h, m_output) == Graph_traits::null_face(); }

  // Returns the border halfedge that leaves the umbrella along which a border halfedge enters: turns around the target
  // from triangle to triangle.
  halfedge_descriptor leaving(halfedge_descriptor entering) const
  {
    halfedge_descriptor h = opposite(entering, m_output);
    while(!is_border(h))
      h = opposite(next(next(h, m_output), m_output), m_output);
    return h;
  }

  OutputMesh& m_output;
};

// Adds the cell of a site, which is not empty, to a mesh; the tolerance is in the user's unit. `face_map` receives the
// user's face that each new face is in. Requires: the diagram is built. Takes the time of Cell_triangles.
template <typename Diagram, typename OutputMesh, typename VertexPointMap, typename FaceMap>
void add_cell_mesh(const Diagram& diagram, std::size_t site, double tolerance, OutputMesh& output, VertexPointMap vpm,
                   FaceMap face_map)
{
  using Triangles = Output_triangles<OutputMesh, VertexPointMap>;
  Cell_triangles cell(diagram.refined_mesh(), diagram.complex());
  cell.build(diagram.cell_of_site(site), tolerance / diagram.unit(), diagram.parts_of_cell(site));
  const Output_points<Diagram, typename Triangles::Point> points(diagram);
  Triangles triangles(output, vpm);
  std::vector<typename Triangles::vertex_descriptor> vertices;
  for(const Cell_triangles::Vertex& v : cell.vertices())
    vertices.push_back(
      triangles.new_vertex(v.of_mesh != null_id ? points.of_vertex(v.of_mesh) : points.in_face(v.face, v.point)));
  std::vector<typename Triangles::halfedge_descriptor> edges;
  for(const Cell_triangles::Edge& e : cell.edges())
    edges.push_back(triangles.new_edge(vertices[e.first], vertices[e.second]));
  for(const Cell_triangles::Triangle& t : cell.triangles())
  {
    std::array<typename Triangles::halfedge_descriptor, 3> h;
    for(unsigned int k = 0; k < 3; ++k)
      h[k] = t.edges[k].second ? opposite(edges[t.edges[k].first], output) : edges[t.edges[k].first];
    put(face_map, triangles.new_triangle(h), diagram.user_face(t.face));
  }
  Output_border<OutputMesh>(output).link(edges);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_CELL_MESH_H
