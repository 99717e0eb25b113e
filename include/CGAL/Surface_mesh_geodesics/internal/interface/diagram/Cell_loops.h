// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_LOOPS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_LOOPS_H

// The boundary of a cell as closed loops. Voronoi_complex::boundary() gives the chains around a cell, and ends where
// the border of the mesh begins. Here the way goes on along the border of the mesh, to the next chain of the cell.
//
// The way along the border: the cell is on the left, and so is the mesh. Where a chain of the cell ends at the border,
// the part of the border behind that node belongs to the cell; it ends at the next node, where another chain of the
// cell begins, or the same one. At a vertex of the mesh the way stays in one umbrella: it takes the other border edge
// of the umbrella that it comes from. So at a pinched vertex a loop does not change from one umbrella to another.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A piece of a loop: an arc, or a part of a border edge of the mesh.
struct Cell_loop_piece
{
  bool is_arc;
  Oriented_index arc; // if is_arc

  // Otherwise the border halfedge, and the nodes on it where the piece begins and ends; null_id for the source and the
  // target of the halfedge.
  Halfedge_id border;
  std::uint32_t first_node, last_node;
};

// The pieces follow each other with the cell on their left. A loop that is not closed begins and ends at the border of
// the mesh.
struct Cell_loop
{
  std::vector<Cell_loop_piece> pieces;
  bool is_closed;
};

// Finds the loops of one cell. The mesh and the complex are referred to. Requires: the complex is finished.
class Cell_loops
{
public:
  using Mesh = Intrinsic_mesh<double>;
  using Complex = Voronoi_complex<double>;

  Cell_loops(const Mesh& mesh, const Complex& complex) : m_mesh(mesh), m_complex(complex) {}

  // Returns the parts of the boundary that consist of arcs alone, as the complex has them. Takes time linear in the
  // number of arcs around the cell.
  std::vector<Cell_loop> without_border(Vertex_id site) const
  {
    std::vector<Cell_loop> result;
    for(const Voronoi_boundary_part& part : m_complex.boundary(site))
    {
      result.push_back(Cell_loop{{}, part.is_closed});
      add_arcs(part, result.back());
    }
    return result;
  }

  // Returns the loops with arcs, closed along the border of the mesh. Takes time linear in the number of their pieces,
  // and of faces around the vertices of the border where they pass.
  std::vector<Cell_loop> with_arcs(Vertex_id site) const
  {
    const std::vector<Voronoi_boundary_part> parts = m_complex.boundary(site);
    std::unordered_map<std::uint32_t, std::size_t> starting; // node of the border -> the part that begins there
    for(std::size_t i = 0; i < parts.size(); ++i)
      if(!parts[i].is_closed)
        starting.emplace(m_complex.start_of(parts[i].chains.front()), i);
    std::vector<Cell_loop> result;
    std::vector<char> is_used(parts.size(), 0);
    for(std::size_t first = 0; first < parts.size(); ++first)
    {
      if(is_used[first])
        continue;
      result.push_back(Cell_loop{{}, true});
      for(std::size_t i = first; !is_used[i];)
      {
        is_used[i] = 1;
        add_arcs(parts[i], result.back());
        if(!parts[i].is_closed)
          i = starting.at(follow_border(m_complex.end_of(parts[i].chains.back()), site, result.back()));
      }
    }
    return result;
  }

  // Returns the loops that consist of border edges alone: whole curves of the border of the mesh in the cell. Takes
  // time linear in the number of faces of the mesh.
  std::vector<Cell_loop> of_border(Vertex_id site) const
  {
    std::vector<Cell_loop> result;
    std::unordered_set<Halfedge_id> seen;
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
      {
        const Halfedge_id first = halfedge_of(f, k);
        if(!is_whole_border_edge(first, site) || seen.count(first) != 0)
          continue;
        Cell_loop loop{{}, true};
        Halfedge_id h = first;
        while(is_whole_border_edge(h, site) && seen.insert(h).second)
        {
          loop.pieces.push_back(Cell_loop_piece{false, {}, h, null_id, null_id});
          h = m_mesh.next_on_border(h);
        }
        // Otherwise an arc ends on this curve of the border, now or where the loop has been given up before.
        if(h == first)
          result.push_back(loop);
      }
    return result;
  }

private:
  // Returns whether h is at the border, and wholly in a cell.
  bool is_whole_border_edge(Halfedge_id h, Vertex_id site) const
  {
    return m_mesh.opposite(h) == null_id && m_complex.owner(m_mesh.source(h)) == site
        && m_complex.nodes_on_edge(h).number == 0;
  }

  void add_arcs(const Voronoi_boundary_part& part, Cell_loop& loop) const
  {
    for(const Oriented_index& c : part.chains)
    {
      const auto& arcs = m_complex.chains()[c.first].arcs;
      for(std::size_t i = 0; i < arcs.size(); ++i)
      {
        const Oriented_index& a = arcs[c.second ? arcs.size() - 1 - i : i];
        loop.pieces.push_back(Cell_loop_piece{true, Oriented_index(a.first, a.second != c.second), null_id, null_id,
                                              null_id});
      }
    }
  }

  // Adds the pieces of the border from a node to the next one, and returns that. Requires: the part of the border
  // behind the node is in the cell of the site.
  std::uint32_t follow_border(std::uint32_t node, Vertex_id site, Cell_loop& loop) const
  {
    Halfedge_id h = border_edge_of(node);
    std::uint32_t from = node, next = node - m_complex.nodes_on_edge(h).first + 1;
    CGAL_assertion(m_complex.nodes()[node].sites[1] == site);
    static_cast<void>(site);
    while(true)
    {
      const auto nodes = m_complex.nodes_on_edge(h);
      const std::uint32_t to = next < nodes.number ? nodes.node(next) : std::uint32_t(null_id);
      loop.pieces.push_back(Cell_loop_piece{false, {}, h, from, to});
      if(to != null_id)
        return to;
      h = m_mesh.next_on_border(h);
      from = null_id;
      next = 0;
    }
  }

  // Returns the border halfedge on which a node is. Requires: there is one. (Its nodes are in its own order, as it has
  // no opposite.)
  Halfedge_id border_edge_of(std::uint32_t node) const
  {
    const Face_id f = m_complex.nodes()[node].face;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k);
      const auto nodes = m_complex.nodes_on_edge(h);
      if(m_mesh.opposite(h) == null_id && nodes.first <= node && node < nodes.first + nodes.number)
        return h;
    }
    CGAL_assertion_msg(false, "a curve ends inside the mesh");
    return null_id;
  }

  const Mesh& m_mesh;
  const Complex& m_complex;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_LOOPS_H
