// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_CUT_MESH_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_CUT_MESH_H

// Adds the surface, cut along the arcs of a Voronoi complex, to a mesh of the user. The connectivity is that of the
// refined intrinsic mesh: each of its edges becomes a chain of edges that both faces share, and each face is filled
// with the triangles that Voronoi_face_cut makes of it.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Edge_contraction.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_face_cut.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/coordinates_in_layout.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Output_triangles.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// OutputMesh is a model of MutableFaceGraph. `VertexPointMap` is writable, with the points of the output as values.
// Mesh, complex and output are referred to, the map is copied.
//
// The steps of build():
// 1. new_vertex() for each vertex of the refined mesh, so that these come first in the output;
// 2. add_edge_pieces() for each edge of the refined mesh, so that both faces find the same pieces;
// 3. fill_face() for each face: collect_border() gathers the pieces around it, add_triangle() adds triangles;
// 4. link_border_at() and link_border_inside_edges() for the halfedges that have got no triangle.
//
// How halfedges are linked: new_edge() makes border halfedges without a next one; add_triangle() links those inside;
// link_border_at() and link_border_inside_edges() link what has stayed on the border. So each halfedge gets its next
// one exactly once. Takes time linear in the size of the output, plus the time of the cuts.
//
// If memory runs out, the output has halfedges that are not linked, and is not a valid mesh.
template <typename OutputMesh, typename VertexPointMap>
class Voronoi_cut_mesh
{
  using Graph_traits = boost::graph_traits<OutputMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Mesh = Intrinsic_mesh<double>;
  using Complex = Voronoi_complex<double>;

public:
  Voronoi_cut_mesh(const Mesh& mesh, const Complex& complex, OutputMesh& output, VertexPointMap vpm)
    : m_mesh(mesh), m_complex(complex), m_output(output), m_triangles(output, vpm)
  {}

  // Adds the cut surface to the output. `point_of_vertex(v)` gives the point of a vertex of the refined mesh,
  // `point_in_face(f, p)` the point at p in the plane of a face; `set_site(f, s)` is called for each new face and the
  // vertex of its site, or null_id. Tolerances are in the unit of the intrinsic mesh. Call it once. What the output has
  // held before is not touched. Requires: tolerance > 0.
  template <typename PointOfVertex, typename PointInFace, typename SetSite>
  void build(double tolerance, PointOfVertex point_of_vertex, PointInFace point_in_face, SetSite set_site)
  {
    for(Vertex_id v = 0; v < m_mesh.number_of_vertices(); ++v)
      m_vertices.push_back(m_triangles.new_vertex(point_of_vertex(v)));
    m_first_piece.assign(4 * m_mesh.number_of_faces(), null_id);
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
        if(m_mesh.is_first_of_edge(halfedge_of(f, k)))
          add_edge_pieces(halfedge_of(f, k), point_in_face);
    Voronoi_face_cut cut(m_mesh, m_complex);
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      cut.cut(f, tolerance);
      fill_face(f, cut, point_in_face, set_site);
    }
    for(Vertex_id v = 0; v < m_mesh.number_of_vertices(); ++v)
      link_border_at(v);
    link_border_inside_edges();
  }

private:
  // Divides the edge of h where arcs end on it, and adds the pieces from its source to its target. The cut of both
  // faces divides the edge in the same way (Edge_contraction). Requires: is_first_of_edge(h). Takes time linear in the
  // number of nodes on the edge.
  template <typename PointInFace>
  void add_edge_pieces(Halfedge_id h, PointInFace point_in_face)
  {
    const Edge_contraction edge(m_mesh, m_complex, h);
    const auto corner = m_complex.layout(face_of(h));
    vertex_descriptor from = m_vertices[m_mesh.source(h)];
    m_first_piece[h] = static_cast<std::uint32_t>(m_pieces.size());
    for(std::uint32_t i = 1; i <= edge.last(); ++i)
    {
      vertex_descriptor to = m_vertices[m_mesh.target(h)];
      if(i < edge.last())
        to = m_triangles.new_vertex(
          point_in_face(face_of(h), point_on_side(corner, index_in_face(h), edge.fraction(i))));
      m_pieces.push_back(m_triangles.new_edge(from, to));
      from = to;
    }
    m_pieces.push_back(Graph_traits::null_halfedge()); // ends the pieces of this edge
  }

  // Appends the pieces along h to the border of its face. They run along h, counterclockwise around the face: the
  // pieces of the opposite halfedge are reversed, one by one and in their order.
  void collect_border(Halfedge_id h)
  {
    const bool is_reversed = !m_mesh.is_first_of_edge(h);
    const std::size_t begin = m_border.size();
    for(std::size_t i = m_first_piece[is_reversed ? m_mesh.opposite(h) : h];
        m_pieces[i] != Graph_traits::null_halfedge(); ++i)
      m_border.push_back(is_reversed ? opposite(m_pieces[i], m_output) : m_pieces[i]);
    if(is_reversed)
      std::reverse(m_border.begin() + static_cast<std::ptrdiff_t>(begin), m_border.end());
  }

  // Adds the triangles of a face. They fill the polygon that the pieces of its edges form, so each halfedge is used
  // once. m_open holds the halfedges that still need a triangle on their left: at first the border of the polygon, at
  // the end none. It finds them by their two vertices, which relies on Voronoi_face_cut making one edge between two.
  template <typename PointInFace, typename SetSite>
  void fill_face(Face_id f, const Voronoi_face_cut& cut, PointInFace point_in_face, SetSite set_site)
  {
    m_border.clear();
    for(unsigned int k = 0; k < 3; ++k)
      collect_border(halfedge_of(f, k));
    // Border vertex i of the cut is the source of halfedge i here, as both begin at corner 0 and divide edges alike.
    const std::uint32_t n = static_cast<std::uint32_t>(m_border.size());
    CGAL_assertion(n == cut.number_of_border_vertices());
    m_local.clear();
    m_open.clear();
    for(std::uint32_t i = 0; i < n; ++i)
    {
      m_local.push_back(source(m_border[i], m_output));
      m_open[std::make_pair(i, (i + 1) % n)] = m_border[i];
    }
    for(std::size_t i = n; i < cut.points().size(); ++i)
      m_local.push_back(m_triangles.new_vertex(point_in_face(f, cut.points()[i])));
    for(const Voronoi_face_cut::Triangle& t : cut.triangles())
      set_site(add_triangle(t.vertex), t.site);
    CGAL_assertion_msg(m_open.empty(), "a face is not filled");
  }

  // Returns the halfedge between two vertices of the face whose triangle on the left is not made yet; adds the edge if
  // it is the first one of its two triangles. The second one finds the opposite halfedge among those that are open.
  halfedge_descriptor take_halfedge(std::uint32_t from, std::uint32_t to)
  {
    const auto it = m_open.find(std::make_pair(from, to));
    if(it != m_open.end())
    {
      const halfedge_descriptor h = it->second;
      m_open.erase(it);
      return h;
    }
    const halfedge_descriptor h = m_triangles.new_edge(m_local[from], m_local[to]);
    const bool is_new = m_open.emplace(std::make_pair(to, from), opposite(h, m_output)).second;
    CGAL_assertion_msg(is_new, "two edges of a face have the same vertices");
    static_cast<void>(is_new);
    return h;
  }

  // Adds a triangle, given its vertices in m_local counterclockwise, and links its halfedges.
  face_descriptor add_triangle(const std::array<std::uint32_t, 3>& vertex)
  {
    std::array<halfedge_descriptor, 3> h;
    for(unsigned int k = 0; k < 3; ++k)
      h[k] = take_halfedge(vertex[k], vertex[next_corner(k)]);
    return m_triangles.new_triangle(h);
  }

  // Return the first and the last piece along h. Requires: is_first_of_edge(h), which holds on the border of the mesh.
  halfedge_descriptor first_piece(Halfedge_id h) const
  {
    return m_pieces[m_first_piece[h]];
  }

  halfedge_descriptor last_piece(Halfedge_id h) const
  {
    std::size_t i = m_first_piece[h];
    while(m_pieces[i + 1] != Graph_traits::null_halfedge())
      ++i;
    return m_pieces[i];
  }

  // Links the border halfedges at a vertex. The one that enters along one umbrella is followed by the one that leaves
  // along the next umbrella, so that a walk around a pinched vertex meets all umbrellas.
  // A border halfedge of the output is the opposite of a piece along a border edge, and runs clockwise around the face.
  // So at the first halfedge h of an umbrella one enters v, along h; at the last one, one leaves v along the halfedge
  // before. Takes time linear in the number of faces around v, and of pieces of one edge for each umbrella.
  void link_border_at(Vertex_id v)
  {
    std::vector<halfedge_descriptor> entering, leaving;
    m_mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
    {
      if(m_mesh.opposite(h) == null_id)
        entering.push_back(opposite(first_piece(h), m_output));
      if(m_mesh.opposite(previous_halfedge(h)) == null_id)
        leaving.push_back(opposite(last_piece(previous_halfedge(h)), m_output));
    });
    for(std::size_t i = 0; i < entering.size(); ++i)
    {
      set_next(entering[i], leaving[(i + 1) % leaving.size()], m_output);
      set_halfedge(m_vertices[v], entering[i], m_output);
    }
  }

  // Links the border halfedges at the vertices that divide a border edge. There the piece that enters from one side is
  // followed by the piece that leaves on the other side, in the direction opposite to h.
  void link_border_inside_edges()
  {
    for(Halfedge_id h = 0; h < m_first_piece.size(); ++h)
    {
      if(m_first_piece[h] == null_id || m_mesh.opposite(h) != null_id)
        continue;
      for(std::size_t i = m_first_piece[h]; m_pieces[i + 1] != Graph_traits::null_halfedge(); ++i)
      {
        const halfedge_descriptor entering = opposite(m_pieces[i + 1], m_output);
        set_next(entering, opposite(m_pieces[i], m_output), m_output);
        set_halfedge(target(entering, m_output), entering, m_output);
      }
    }
  }

  const Mesh& m_mesh;
  const Complex& m_complex;
  OutputMesh& m_output;
  Output_triangles<OutputMesh, VertexPointMap> m_triangles;
  std::vector<vertex_descriptor> m_vertices;   // of the output, by vertex of the refined mesh
  std::vector<std::uint32_t> m_first_piece;    // index in m_pieces, by halfedge; null_id if it is not the first one
  std::vector<halfedge_descriptor> m_pieces;   // of each edge, from its source on, then the null halfedge
  std::vector<halfedge_descriptor> m_border;   // of the present face
  std::vector<vertex_descriptor> m_local;      // of the output, by vertex of the cut of the present face
  // Halfedges of the present face without a triangle, by their ends in m_local.
  std::map<std::pair<std::uint32_t, std::uint32_t>, halfedge_descriptor> m_open;
};

// Adds the cut surface of a lazy diagram to a mesh; the tolerance is in the user's unit. `face_site_map` receives the
// number of the site of each new face. Requires: the diagram is built. A face that no site reaches gets
// Diagram::no_site.
template <typename Diagram, typename OutputMesh, typename VertexPointMap, typename FaceSiteMap>
void add_cut_mesh(const Diagram& diagram, double tolerance, OutputMesh& output, VertexPointMap vpm,
                  FaceSiteMap face_site_map)
{
  const Output_points<Diagram, typename boost::property_traits<VertexPointMap>::value_type> points(diagram);
  const auto point_of_vertex = [&](Vertex_id v) { return points.of_vertex(v); };
  const auto point_in_face = [&](Face_id f, const Planar_point<double>& p) { return points.in_face(f, p); };
  const auto set_site = [&](typename boost::graph_traits<OutputMesh>::face_descriptor f, Vertex_id s)
  { put(face_site_map, f, diagram.site_at(s)); };
  Voronoi_cut_mesh<OutputMesh, VertexPointMap> cut_mesh(diagram.refined_mesh(), diagram.complex(), output, vpm);
  cut_mesh.build(tolerance / diagram.unit(), point_of_vertex, point_in_face, set_site);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_CUT_MESH_H
