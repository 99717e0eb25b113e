// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_TOPOLOGY_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_TOPOLOGY_H

// Whether a cell, with its boundary, is a topological disk.
//
// The complex is generic: there the boundary of a cell never touches itself, and the Euler characteristic decides. What
// users see is not: where four cells meet, one of them may come to the point from two sides, and the mesh may be
// pinched at a vertex in the cell. Both need a node or a vertex in a special place. If a cell has none, the
// characteristic decides. Otherwise its triangles decide (Cell_triangles.h): nodes at one point are one vertex of them.
//
// Why this is enough: let two parts of the boundary meet at a point. If that is a vertex of the diagram, or on an edge
// of the mesh, their nodes there are contracted to one vertex of the cut (Voronoi_face_cut.h), along an arc without
// length or on an edge. That arc or edge is in a face that has an arc of the boundary. Inside a face, four images are
// equally near at the point, two of each of two sites, as two images have one bisector only, and the bisectors of three
// make one curve with a kink. So each of the two parts has a kink there, which is a node between two arcs.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Edge_contraction.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_face_cut.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Cell_triangles.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The mesh and the complex are referred to. Requires: the complex is finished.
//
// What "touches" means is a matter of rounding. The rule is that of the cut and of the vertices that users see: points
// that rounding may have made from one point are one point (Voronoi_complex::rounding_at()). So a cell that nearly
// touches itself, closer than that, is not a disk either.
class Cell_topology
{
public:
  using Mesh = Intrinsic_mesh<double>;
  using Complex = Voronoi_complex<double>;

  Cell_topology(const Mesh& mesh, const Complex& complex) : m_mesh(mesh), m_complex(complex) {}

  // Returns whether the cell of a site is a disk. A cell without a part of a face is not. Takes time linear in the
  // number of arcs around the cell; in a special case the time of Cell_triangles. The characteristics of a disk and of
  // an annulus have the sum of a disk, so if the cell may have several parts, its triangles decide.
  bool is_disk(Vertex_id site, Cell_parts parts) const
  {
    const Voronoi_cell_elements elements = m_complex.cell(site);
    if(elements.face_regions == 0)
      return false;
    if(m_complex.Euler_characteristic(site) != 1 || has_equal_kinks(site))
      return false;
    if(elements.pinched_vertices == 0 && is_connected(site, parts) && !has_contraction(site))
      return true;
    Cell_triangles cell(m_mesh, m_complex);
    const double unit_of_mesh = 1; // any tolerance gives the same combinatorics
    cell.build(site, unit_of_mesh, parts);
    return are_disk(cell);
  }

private:
  // Returns true only if the cell is known to have one part. A disk has one boundary; if each part has arcs on its
  // boundary, a second part would have a second one. (A disk at the border of the mesh may have several, too: then the
  // triangles decide.)
  bool is_connected(Vertex_id site, Cell_parts parts) const
  {
    return parts == Cell_parts::ONE || (parts == Cell_parts::WITH_ARCS && m_complex.boundary(site).size() < 2);
  }

  // Calls is_special(f) for the faces that the boundary of a cell runs through, until it returns true; returns whether
  // it did. Arcs of one face that follow each other are one call.
  template <typename IsSpecial>
  bool any_face(Vertex_id site, IsSpecial is_special) const
  {
    Face_id last = null_id; // a boundary often crosses a face in several arcs, one after the other
    for(const Voronoi_boundary_part& part : m_complex.boundary(site))
      for(const Oriented_index& c : part.chains)
        for(const Oriented_index& a : m_complex.chains()[c.first].arcs)
        {
          const Face_id f = m_complex.arcs()[a.first].face;
          if(f != last && is_special(f))
            return true;
          last = f;
        }
    return false;
  }

  // Returns whether nodes are contracted in a face that the boundary of the cell runs through.
  bool has_contraction(Vertex_id site) const
  {
    return any_face(site, [this](Face_id f) { return has_contraction_in(f); });
  }

  // Returns whether two parts of the boundary have kinks at one point of a face.
  bool has_equal_kinks(Vertex_id site) const
  {
    return any_face(site, [&](Face_id f) { return has_equal_kinks_in(f, site); });
  }

  // Kinks that arcs without length join count as one: they are on one part of the boundary.
  bool has_equal_kinks_in(Face_id f, Vertex_id site) const
  {
    const std::pair<std::uint32_t, std::uint32_t> arcs = m_complex.arcs_of_face(f);
    // Most faces of a boundary have one arc, and cells have thousands of them: the test has to be cheap for these.
    if(arcs.second - arcs.first < 3) // the arcs of two kinks, which may have one in common
      return false;
    const double size = longest_side(m_mesh.face(f));
    std::vector<std::uint32_t> kinks;
    for(std::uint32_t a = arcs.first; a < arcs.second; ++a)
    {
      const auto& arc = m_complex.arcs()[a];
      if(arc.left_site == site || arc.right_site == site)
        for(const std::uint32_t node : {arc.first_node, arc.last_node})
          if(is_kink(f, node) && std::find(kinks.begin(), kinks.end(), node) == kinks.end())
            kinks.push_back(node);
    }
    for(std::size_t i = 0; i < kinks.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        if(distance(m_complex.nodes()[kinks[i]].point, m_complex.nodes()[kinks[j]].point)
             <= m_complex.rounding_at(kinks[i], size)
           && !are_joined(kinks[i], kinks[j]))
          return true;
    return false;
  }

  // Returns whether a node is inside the face and between two arcs.
  bool is_kink(Face_id f, std::uint32_t node) const
  {
    if(m_complex.nodes()[node].is_vertex())
      return false;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const auto nodes = m_complex.nodes_on_edge(halfedge_of(f, k));
      if(nodes.first <= node && node < nodes.first + nodes.number)
        return false;
    }
    return true;
  }

  // Returns whether arcs without length lead from one node to another one, so that both are on one part of a curve.
  bool are_joined(std::uint32_t from, std::uint32_t to) const
  {
    std::vector<std::uint32_t> reached{from};
    for(std::size_t i = 0; i < reached.size(); ++i)
      for(const std::uint32_t a : m_complex.nodes()[reached[i]].arc)
      {
        if(a == null_id || m_complex.has_length(m_complex.arcs()[a]))
          continue;
        for(const std::uint32_t end : {m_complex.arcs()[a].first_node, m_complex.arcs()[a].last_node})
          if(std::find(reached.begin(), reached.end(), end) == reached.end())
            reached.push_back(end);
      }
    return std::find(reached.begin(), reached.end(), to) != reached.end();
  }

  // Returns whether a face has an arc without length, or a node at a vertex or at another node of its edge.
  bool has_contraction_in(Face_id f) const
  {
    const std::pair<std::uint32_t, std::uint32_t> arcs = m_complex.arcs_of_face(f);
    for(std::uint32_t a = arcs.first; a < arcs.second; ++a)
      if(!m_complex.has_length(m_complex.arcs()[a]))
        return true;
    for(unsigned int k = 0; k < 3; ++k)
    {
      if(Edge_contraction(m_mesh, m_complex, halfedge_of(f, k)).contracts_nodes())
        return true;
    }
    return false;
  }

  // Returns whether triangles form one surface without pinched vertices that has the Euler characteristic 1. The
  // surface is oriented, so it is a disk then.
  //
  // Corners of triangles at an edge are in the same umbrella of their vertex. A vertex is pinched if there are more
  // umbrellas than vertices.
  static bool are_disk(const Cell_triangles& cell)
  {
    const std::size_t n = cell.triangles().size();
    Sets triangles(n), corners(3 * n);
    struct Side
    {
      std::size_t triangle = none;
      unsigned int k = 0;
    };
    std::vector<Side> first_side(cell.edges().size()); // by edge
    for(std::size_t t = 0; t < n; ++t)
      for(unsigned int k = 0; k < 3; ++k)
      {
        Side& other = first_side[cell.triangles()[t].edges[k].first];
        if(other.triangle == none)
        {
          other = Side{t, k};
          continue;
        }
        // The two triangles pass the edge in opposite directions.
        triangles.join(t, other.triangle);
        corners.join(3 * t + k, 3 * other.triangle + next_corner(other.k));
        corners.join(3 * t + next_corner(k), 3 * other.triangle + other.k);
      }
    return triangles.number == 1 && corners.number == cell.vertices().size()
        && cell.vertices().size() + n == cell.edges().size() + 1;
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // Disjoint sets of the numbers below `number`, which counts the sets.
  struct Sets
  {
    explicit Sets(std::size_t n) : number(n), m_rank(n), m_parent(n), m_sets(m_rank.data(), m_parent.data())
    {
      for(std::size_t i = 0; i < n; ++i)
        m_sets.make_set(i);
    }

    Sets(const Sets&) = delete;
    Sets& operator=(const Sets&) = delete;

    void join(std::size_t a, std::size_t b)
    {
      number -= m_sets.find_set(a) != m_sets.find_set(b) ? 1 : 0;
      m_sets.union_set(a, b);
    }

    std::size_t number;

  private:
    std::vector<std::size_t> m_rank, m_parent;
    boost::disjoint_sets<std::size_t*, std::size_t*> m_sets;
  };

  const Mesh& m_mesh;
  const Complex& m_complex;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_CELL_TOPOLOGY_H
