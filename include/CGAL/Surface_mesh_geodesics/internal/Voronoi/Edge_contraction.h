// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGE_CONTRACTION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGE_CONTRACTION_H

// Where arcs divide an edge of the mesh, when the mesh is cut along them. Nodes at one point, up to rounding, are one
// vertex. This is decided for the edge, so that both of its faces agree.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The vertices of a cut edge by their positions from the source of a halfedge: 0 is the source, last() the target, and
// 1, ..., last() - 1 are nodes of the complex. Several nodes may have one position. An edge without nodes that would
// enclose a hole with one other edge has a vertex in its middle, as faces of meshes, and holes, have three edges: the
// two sides of a wall between two vertices that are on no other wall.
//
// Invariants: positions do not descend along the edge; each position between 0 and last() has a node, or is that
// middle. Both halfedges of an edge get the same vertices in reverse order, because the constructor contracts in the
// order of the one with the smaller index, whichever is given. So the cuts of both faces match.
class Edge_contraction
{
public:
  using Complex = Voronoi_complex<double>;
  using Mesh = Intrinsic_mesh<double>;

  Edge_contraction(const Mesh& mesh, const Complex& complex, Halfedge_id h) : m_nodes(complex.nodes_on_edge(h))
  {
    // Positions are found as the halfedge with the smaller index sees them. A node near both ends goes to the nearer
    // one, the source in a tie. null_id stands for last(), which is not known yet.
    const double length = mesh.length(h);
    const auto is_rounding = [&](std::uint32_t node, double gap) { return gap <= complex.rounding_at(node, length); };
    m_position.resize(m_nodes.number);
    double last_abscissa = 0; // of the vertex at m_last
    for(std::uint32_t i = 0; i < m_nodes.number; ++i)
    {
      const std::uint32_t node = m_nodes.first + i;
      const double x = complex.nodes()[node].abscissa;
      if(is_rounding(node, length - x) && length - x < x)
      {
        m_position[i] = null_id;
        continue;
      }
      if(!is_rounding(node, x - last_abscissa))
      {
        ++m_last;
        last_abscissa = x;
        m_fraction.push_back(x / length);
      }
      m_position[i] = m_last;
    }
    if(m_last == 0 && encloses_hole_of_two(mesh, h))
    {
      ++m_last;
      m_has_middle = true;
      m_fraction.push_back(.5);
    }
    ++m_last;
    std::replace(m_position.begin(), m_position.end(), std::uint32_t(null_id), m_last);
  }

  std::uint32_t last() const { return m_last; }
  std::uint32_t number_of_nodes() const { return m_nodes.number; }

  // Are nodes at an end of the edge, or several at one vertex?
  bool contracts_nodes() const { return m_last != m_nodes.number + (m_has_middle ? 2 : 1); }

  // Returns the i-th node from the source of the halfedge, and its position.
  std::uint32_t node(std::uint32_t i) const { return m_nodes.node(i); }
  std::uint32_t position(std::uint32_t i) const
  {
    return m_nodes.is_reversed ? m_last - m_position[m_nodes.number - 1 - i] : m_position[i];
  }

  // Returns where a position is, as a fraction of the edge from the source of the halfedge: that of the first of its
  // nodes along the halfedge with the smaller index. Requires: 0 < position < last().
  double fraction(std::uint32_t position) const
  {
    CGAL_assertion(0 < position && position < m_last);
    return m_nodes.is_reversed ? 1 - m_fraction[m_last - position - 1] : m_fraction[position - 1];
  }

private:
  // Do h and another edge of the border enclose a hole?
  static bool encloses_hole_of_two(const Mesh& mesh, Halfedge_id h)
  {
    if(mesh.opposite(h) != null_id)
      return false;
    const Halfedge_id other = mesh.next_on_border(h);
    return other != h && mesh.next_on_border(other) == h;
  }

  typename Complex::Nodes_on_edge m_nodes;
  std::vector<std::uint32_t> m_position;
  std::vector<double> m_fraction;
  std::uint32_t m_last = 0;
  bool m_has_middle = false;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGE_CONTRACTION_H
