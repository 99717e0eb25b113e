// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_TRIANGLES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_TRIANGLES_H

// The triangles of one cell: those of the cut surface (Voronoi_cut_mesh.h) that lie in the cell. Each face is cut by
// Voronoi_face_cut, as there, so both have the same triangles. Voronoi_cell_mesh.h makes a mesh of them, and
// Cell_topology.h asks whether they are a disk.
//
// Vertices and edges get numbers when the first triangle needs them. Those on edges of the refined mesh are known by
// their positions on these edges, as Edge_contraction counts them, so that both faces at an edge share them.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Edge_contraction.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_face_cut.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/coordinates_in_layout.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Which parts of a cell that meet nowhere there may be. The cell of a point is connected, as the shortest paths to it
// stay in the cell; they may lead through vertices. The cell of a curve has several parts where other sites own points
// of the curve; each of them has arcs on its boundary. Between walls, a part may have none.
enum class Cell_parts { ONE, WITH_ARCS, ANY };

// Invariants after build(): each edge is in one triangle or in two, which pass it in opposite directions. The triangles
// of one face fill the parts of the cell in it. A vertex may have several umbrellas: where the mesh is pinched, and
// where the cell touches itself.
//
// The lists are valid after build(), which is called once. The mesh and the complex are referred to. Requires: the
// complex is finished.
class Cell_triangles
{
public:
  using Mesh = Intrinsic_mesh<double>;
  using Complex = Voronoi_complex<double>;

  // A vertex of the refined mesh, or a point in the layout of a face if `of_mesh` is null_id. The point of a vertex on
  // an edge does not depend on the face that needs it first.
  struct Vertex
  {
    Vertex_id of_mesh;
    Face_id face;
    Planar_point<double> point;
  };

  // Edges from first to second; both are numbers of vertices. Two edges may have the same ends.
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  // The edges counterclockwise, each with whether the triangle passes it from its second to its first vertex; the
  // vertices where they begin; the face of the refined mesh.
  struct Triangle
  {
    std::array<Oriented_index, 3> edges;
    std::array<std::uint32_t, 3> vertices;
    Face_id face;
  };

  Cell_triangles(const Mesh& mesh, const Complex& complex) : m_mesh(mesh), m_complex(complex) {}

  // Cuts all faces that the cell of a site is in, in ascending order. The tolerance is in the unit of the intrinsic
  // mesh. Takes time for the faces of the cell and those around it, plus the time of the cuts; linear time if the cell
  // may have any parts.
  void build(Vertex_id site, double tolerance, Cell_parts parts)
  {
    Voronoi_face_cut cut(m_mesh, m_complex);
    for(const Face_id f : parts == Cell_parts::ANY ? all_faces_of_cell(site) : faces_of_cell(site))
    {
      cut.cut(f, tolerance);
      name_border(f);
      CGAL_assertion(m_vertex_names.size() == cut.number_of_border_vertices());
      m_inner_vertices.clear();
      m_open.clear();
      for(const Voronoi_face_cut::Triangle& t : cut.triangles())
        if(t.site == site)
          add_triangle(f, cut, t.vertex);
    }
  }

  const std::vector<Vertex>& vertices() const { return m_vertices; }
  const std::vector<Edge>& edges() const { return m_edges; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
  // A vertex of the refined mesh is (vertex, 0), a vertex on an edge (halfedge with the smaller index, position from
  // its source). The piece of an edge that begins at a position has the name of that position.
  using Name = std::pair<std::uint32_t, std::uint32_t>;

  // Returns the faces that the cell of a site is in, ascending. The faces of the boundary come first, as each part of
  // the cell has some of them. One face after the other is found around the corners of those before.
  // Requires: the cell is connected, or each of its parts has arcs on its boundary.
  std::vector<Face_id> faces_of_cell(Vertex_id site) const
  {
    // Sets, not a flag for each face: of many cells, each costs what its own faces cost.
    std::vector<Face_id> found;
    std::unordered_set<Face_id> seen;
    std::unordered_set<Vertex_id> seen_around;
    const auto look_at = [&](Face_id f)
    {
      if(seen.insert(f).second && is_in_cell(f, site))
        found.push_back(f);
    };
    const auto look_around = [&](Vertex_id v)
    {
      if(seen_around.insert(v).second)
        m_mesh.for_each_halfedge_around(v, [&](Halfedge_id h) { look_at(face_of(h)); });
    };
    if(m_complex.cell(site).vertex != null_id)
      look_around(m_complex.cell(site).vertex);
    for(const Voronoi_boundary_part& part : m_complex.boundary(site))
      for(const Oriented_index& c : part.chains)
        for(const Oriented_index& a : m_complex.chains()[c.first].arcs)
          look_at(m_complex.arcs()[a.first].face);
    for(std::size_t k = 0; k < found.size(); ++k)
      for(const Vertex_id v : m_mesh.face(found[k]).vertex)
        look_around(v);
    // The numbers of vertices and triangles depend on the order of the faces.
    std::sort(found.begin(), found.end());
    CGAL_expensive_assertion(found == all_faces_of_cell(site));
    return found;
  }

  // The same for any cell. Takes time linear in the number of faces of the mesh.
  std::vector<Face_id> all_faces_of_cell(Vertex_id site) const
  {
    std::vector<Face_id> found;
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
      if(is_in_cell(f, site))
        found.push_back(f);
    return found;
  }

  // Returns whether a part of a face is in a cell: its first corner is, or an arc of the face bounds the cell. Takes
  // time linear in the number of arcs of the face.
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

  // Names the vertices on the border of a face in the order of Voronoi_face_cut, and the pieces behind them. Fractions
  // are kept for vertices that are new: an Edge_contraction takes time linear in the number of nodes on the edge, so it
  // is made once for each edge.
  void name_border(Face_id f)
  {
    m_vertex_names.clear();
    m_piece_names.clear();
    m_fractions.clear();
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k);
      const bool is_reversed = !m_mesh.is_first_of_edge(h);
      const Halfedge_id edge = is_reversed ? m_mesh.opposite(h) : h;
      const Edge_contraction contraction(m_mesh, m_complex, edge);
      const std::uint32_t last = contraction.last();
      for(std::uint32_t i = 0; i < last; ++i)
      {
        const std::uint32_t position = is_reversed ? last - i : i;
        m_vertex_names.push_back(i == 0 ? Name(m_mesh.source(h), 0) : Name(edge, position));
        m_fractions.push_back(i == 0 ? 0 : contraction.fraction(position));
        m_piece_names.push_back(std::make_pair(Name(edge, is_reversed ? last - 1 - i : i), is_reversed));
      }
    }
  }

  // Returns the number of vertex i of the cut of face f.
  std::uint32_t vertex(Face_id f, const Voronoi_face_cut& cut, std::uint32_t i)
  {
    const bool is_on_border = i < m_vertex_names.size();
    const std::uint32_t number = static_cast<std::uint32_t>(m_vertices.size());
    const auto inserted = is_on_border ? m_border_vertices.emplace(m_vertex_names[i], number)
                                       : m_inner_vertices.emplace(Name(i, 0), number);
    if(inserted.second)
      m_vertices.push_back(is_on_border ? vertex_on_border(i) : Vertex{null_id, f, cut.points()[i]});
    return inserted.first->second;
  }

  // Returns vertex i of the border of the present face: a vertex of the refined mesh, or one on an edge of it. Its
  // point is found from the halfedge with the smaller index, as cut() does, so that both meshes have the same bits.
  Vertex vertex_on_border(std::uint32_t i) const
  {
    const Name& name = m_vertex_names[i];
    if(name.second == 0)
      return Vertex{name.first, null_id, Planar_point<double>()};
    const Halfedge_id h = name.first;
    return Vertex{null_id, face_of(h), point_on_side(m_complex.layout(face_of(h)), index_in_face(h), m_fractions[i])};
  }

  // Returns the edge between two vertices of the cut of the present face, which have the numbers v and w. On the border
  // of the face, the other face may have made it; inside, another triangle.
  Oriented_index edge(std::uint32_t from, std::uint32_t to, std::uint32_t v, std::uint32_t w)
  {
    const std::uint32_t n = static_cast<std::uint32_t>(m_vertex_names.size());
    const bool is_on_border = from < n && to == (from + 1) % n;
    const bool is_reversed = is_on_border && m_piece_names[from].second;
    if(!is_on_border)
    {
      const auto it = m_open.find(Name(to, from));
      if(it != m_open.end())
        return Oriented_index(it->second, true);
    }
    const std::uint32_t number = static_cast<std::uint32_t>(m_edges.size());
    const auto inserted = is_on_border ? m_pieces.emplace(m_piece_names[from].first, number)
                                       : m_open.emplace(Name(from, to), number);
    if(inserted.second)
      m_edges.push_back(is_reversed ? Edge(w, v) : Edge(v, w));
    return Oriented_index(inserted.first->second, is_reversed);
  }

  // Adds a triangle of the cut of face f, given its vertices there counterclockwise. Vertices and edges that other
  // triangles have made already, in this face or across its border, are found by their names.
  void add_triangle(Face_id f, const Voronoi_face_cut& cut, const std::array<std::uint32_t, 3>& corner)
  {
    Triangle t;
    t.face = f;
    for(unsigned int k = 0; k < 3; ++k)
      t.vertices[k] = vertex(f, cut, corner[k]);
    for(unsigned int k = 0; k < 3; ++k)
      t.edges[k] = edge(corner[k], corner[next_corner(k)], t.vertices[k], t.vertices[next_corner(k)]);
    m_triangles.push_back(t);
  }

  const Mesh& m_mesh;
  const Complex& m_complex;
  std::vector<Vertex> m_vertices;
  std::vector<Edge> m_edges;
  std::vector<Triangle> m_triangles;
  std::map<Name, std::uint32_t> m_border_vertices, m_pieces; // on edges of the refined mesh
  // Of the present face: the names on its border, for each vertex its fraction of its edge as the halfedge with the
  // smaller index sees it, and for each piece whether the face sees it backward.
  std::vector<Name> m_vertex_names;
  std::vector<double> m_fractions;
  std::vector<std::pair<Name, bool>> m_piece_names;
  // Of the present face: the vertices inside, and the edges inside by the ends that their first triangle sees.
  std::map<Name, std::uint32_t> m_inner_vertices, m_open;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_TRIANGLES_H
