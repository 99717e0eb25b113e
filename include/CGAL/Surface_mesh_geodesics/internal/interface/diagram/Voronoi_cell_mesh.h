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

// Adds one cell of a Voronoi complex to a mesh of the user: those triangles of the cut surface (Voronoi_cut_mesh.h)
// that lie in the cell. Each face is cut by Voronoi_face_cut, as there, so both meshes have the same triangles.
//
// Vertices and edges are made when the first triangle needs them. Those on edges of the refined mesh are known by their
// positions on these edges, as Edge_contraction counts them, so that both faces at an edge share them.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_face_cut.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/coordinates_in_layout.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Output_triangles.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The steps of build(): for each face that the cell is in, name_border() gives names to the vertices and pieces on its
// border, and add_triangle() adds the triangles of the cell; then link_border() links the halfedges without a triangle.
//
// Diagram is Lazy_Voronoi_diagram, which is built. It is referred to, like the output.
template <typename Diagram, typename OutputMesh, typename VertexPointMap>
class Voronoi_cell_mesh
{
  using Triangles = Output_triangles<OutputMesh, VertexPointMap>;
  using Points = Output_points<Diagram, typename Triangles::Point>;
  using Graph_traits = boost::graph_traits<OutputMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Mesh = Intrinsic_mesh<double>;
  using Complex = Voronoi_complex<double>;

  // A vertex of the refined mesh is (vertex, 0), a vertex on an edge (halfedge with the smaller index, position from
  // its source). The piece of an edge that begins at a position has the name of that position.
  using Name = std::pair<std::uint32_t, std::uint32_t>;

public:
  Voronoi_cell_mesh(const Diagram& diagram, OutputMesh& output, VertexPointMap vpm)
    : m_mesh(diagram.refined_mesh()), m_complex(diagram.complex()), m_points(diagram), m_output(output),
      m_triangles(output, vpm)
  {}

  // Adds the cell of the site at a vertex of the refined mesh; calls set_face(f, g) for each new face f in the face g
  // of the refined mesh. The tolerance is in the unit of the intrinsic mesh. Call it once. Takes time linear in the
  // number of faces of the mesh, plus the time of the cuts.
  template <typename SetFace>
  void build(Vertex_id site, double tolerance, SetFace set_face)
  {
    Voronoi_face_cut cut(m_mesh, m_complex);
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      if(!is_in_cell(f, site))
        continue;
      cut.cut(f, tolerance);
      name_border(f);
      CGAL_assertion(m_vertex_names.size() == cut.number_of_border_vertices());
      m_inner_vertices.clear();
      m_open.clear();
      for(const Voronoi_face_cut::Triangle& t : cut.triangles())
        if(t.site == site)
          set_face(add_triangle(f, cut, t.vertex), f);
    }
    link_border();
  }

private:
  // Returns whether a part of a face is in a cell.
  bool is_in_cell(Face_id f, Vertex_id site) const
  {
    if(m_complex.owner(m_mesh.face(f).vertex[0]) == site)
      return true;
    const std::pair<std::uint32_t, std::uint32_t> arcs = m_complex.arcs_of_face(f);
    for(std::uint32_t a = arcs.first; a < arcs.second; ++a)
      if(m_complex.arcs()[a].left_site == site || m_complex.arcs()[a].right_site == site)
        return true;
    return false;
  }

  // Names the vertices on the border of a face in the order of Voronoi_face_cut, and the pieces behind them.
  void name_border(Face_id f)
  {
    m_vertex_names.clear();
    m_piece_names.clear();
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k), o = m_mesh.opposite(h);
      const bool is_reversed = o != null_id && o < h;
      const Halfedge_id edge = is_reversed ? o : h;
      const std::uint32_t last = Edge_contraction(m_mesh, m_complex, h).last();
      for(std::uint32_t i = 0; i < last; ++i)
      {
        m_vertex_names.push_back(i == 0 ? Name(m_mesh.source(h), 0) : Name(edge, is_reversed ? last - i : i));
        m_piece_names.push_back(std::make_pair(Name(edge, is_reversed ? last - 1 - i : i), is_reversed));
      }
    }
  }

  // Returns the vertex of the output at a vertex of the cut of face f.
  vertex_descriptor vertex(Face_id f, const Voronoi_face_cut& cut, std::uint32_t i)
  {
    const bool is_on_border = i < m_vertex_names.size();
    const auto inserted = is_on_border
      ? m_border_vertices.emplace(m_vertex_names[i], vertex_descriptor())
      : m_inner_vertices.emplace(Name(i, 0), vertex_descriptor());
    if(inserted.second)
      inserted.first->second = m_triangles.new_vertex(
        is_on_border ? point_on_border(m_vertex_names[i]) : m_points.in_face(f, cut.points()[i]));
    return inserted.first->second;
  }

  // Returns the point of a vertex on an edge. It does not depend on the face, so that it is the one that cut() makes.
  typename Triangles::Point point_on_border(const Name& name) const
  {
    if(name.second == 0)
      return m_points.of_vertex(name.first);
    const Halfedge_id h = name.first;
    const double fraction = Edge_contraction(m_mesh, m_complex, h).fraction(name.second);
    return m_points.in_face(face_of(h), point_on_side(m_complex.layout(face_of(h)), index_in_face(h), fraction));
  }

  halfedge_descriptor new_edge(vertex_descriptor from, vertex_descriptor to)
  {
    m_edges.push_back(m_triangles.new_edge(from, to));
    return m_edges.back();
  }

  // Returns the halfedge between two vertices of the cut of face f, from the first to the second one. On the border of
  // the face the other face may have made its edge, inside it another triangle.
  halfedge_descriptor halfedge_between(Face_id f, const Voronoi_face_cut& cut, std::uint32_t from, std::uint32_t to)
  {
    const std::uint32_t n = static_cast<std::uint32_t>(m_vertex_names.size());
    const vertex_descriptor v = vertex(f, cut, from), w = vertex(f, cut, to);
    if(from < n && to == (from + 1) % n)
    {
      const std::pair<Name, bool>& piece = m_piece_names[from];
      const auto inserted = m_pieces.emplace(piece.first, halfedge_descriptor());
      if(inserted.second)
        inserted.first->second = piece.second ? opposite(new_edge(v, w), m_output) : new_edge(v, w);
      return piece.second ? opposite(inserted.first->second, m_output) : inserted.first->second;
    }
    const auto it = m_open.find(Name(from, to));
    if(it != m_open.end())
      return it->second;
    const halfedge_descriptor h = new_edge(v, w);
    m_open.emplace(Name(to, from), opposite(h, m_output));
    return h;
  }

  typename Triangles::face_descriptor add_triangle(Face_id f, const Voronoi_face_cut& cut,
                                                   const std::array<std::uint32_t, 3>& corner)
  {
    std::array<halfedge_descriptor, 3> h;
    for(unsigned int k = 0; k < 3; ++k)
      h[k] = halfedge_between(f, cut, corner[k], corner[next_corner(k)]);
    return m_triangles.new_triangle(h);
  }

  // Links the halfedges without a triangle. At each vertex, the one that enters along one umbrella is followed by the
  // one that leaves along the next umbrella, so that a walk around a pinched vertex meets all umbrellas that have a
  // border. Takes time linear in the number of triangles, and logarithmic in that of vertices on the border.
  void link_border()
  {
    using Umbrella = std::pair<halfedge_descriptor, halfedge_descriptor>; // entering, leaving
    std::map<vertex_descriptor, std::vector<Umbrella>> umbrellas;
    for(const halfedge_descriptor e : m_edges)
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

  const Mesh& m_mesh;
  const Complex& m_complex;
  const Points m_points;
  OutputMesh& m_output;
  Triangles m_triangles;
  std::map<Name, vertex_descriptor> m_border_vertices; // on edges of the refined mesh
  std::map<Name, halfedge_descriptor> m_pieces;        // of these edges, in the direction of their names
  std::vector<halfedge_descriptor> m_edges;            // one halfedge of each edge
  // Of the present face: the names on its border, and for each piece whether the face sees it backward.
  std::vector<Name> m_vertex_names;
  std::vector<std::pair<Name, bool>> m_piece_names;
  // Of the present face: the vertices inside, and the halfedges that wait for their triangle, by their ends.
  std::map<Name, vertex_descriptor> m_inner_vertices;
  std::map<Name, halfedge_descriptor> m_open;
};

// Adds the cell of the site at a vertex of the refined mesh to a mesh; the tolerance is in the user's unit.
// `face_map` receives the user's face that each new face is in. Requires: the diagram is built.
template <typename Diagram, typename OutputMesh, typename VertexPointMap, typename FaceMap>
void add_cell_mesh(const Diagram& diagram, Vertex_id site, double tolerance, OutputMesh& output, VertexPointMap vpm,
                   FaceMap face_map)
{
  Voronoi_cell_mesh<Diagram, OutputMesh, VertexPointMap> mesh(diagram, output, vpm);
  mesh.build(site, tolerance / diagram.unit(),
             [&](auto new_face, Face_id f) { put(face_map, new_face, diagram.user_face(f)); });
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_CELL_MESH_H
