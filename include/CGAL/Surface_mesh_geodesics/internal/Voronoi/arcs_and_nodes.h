// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_ARCS_AND_NODES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_ARCS_AND_NODES_H

// The elements that a Voronoi complex (Voronoi_complex.h) is made of, and a table of the counts of cells. Arcs, nodes
// and chains refer to each other by their indices in the complex; faces and sites are faces and vertices of the refined
// mesh.
//
// Lengths are in the unit of the intrinsic mesh; distances and weights include the offsets of the sites.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_table.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The index of an arc or a chain, and whether it is passed backward.
using Oriented_index = std::pair<std::uint32_t, bool>;

// A piece of the curve between two cells in one face; its points are in the layout of the face.
//
// All points are as far from `left` as from `right`, the images of the two sites that the paths come from. From `first`
// to `last`, the cell of left_site is on the left. Unless is_bisector is set, the arc is the segment between its ends,
// where rounding hides the true curve. Then both images may be the same one: where two cells meet along an edge, the
// paths of one of them may come from the other face only (Front_completion).
//
// The two sites differ. A curve may consist of several arcs in one face: a node is between two of them where another
// image of one of the sites takes over.
template <typename FT>
struct Voronoi_arc
{
  Face_id face;
  Vertex_id left_site, right_site;
  Additively_weighted_point<FT> left, right;
  Planar_point<FT> first, last;
  std::uint32_t first_node, last_node;
  bool is_bisector;
};

// A point where arcs end: two arcs of the same two cells meet, or three cells do, or an arc ends at the border.
template <typename FT>
struct Voronoi_node
{
  Face_id face; // a face that the node is in, and its point in the layout of that face
  Planar_point<FT> point;
  FT abscissa = 0; // on its edge if it is on one, from the source of the halfedge with the smaller index
  FT distance = 0; // from the nearest sites; set with the arcs
  // Counterclockwise; the last one is null_id unless three cells meet. On an edge: the site before the node and the one
  // behind it, along the halfedge with the smaller index.
  std::array<Vertex_id, 3> sites;
  // The arcs that end here, in the order in which they were added; null_id follows the last one. A node with one arc is
  // at the border of the mesh, once all faces have been added.
  std::array<std::uint32_t, 3> arc{null_id, null_id, null_id};

  Voronoi_node(Face_id f, const Planar_point<FT>& p, const std::array<Vertex_id, 3>& its_sites)
    : face(f), point(p), sites(its_sites)
  {}

  bool is_vertex() const { return sites[2] != null_id; }
};

// An edge of the diagram: the arcs between the same two cells, from face to face and from end to end, with the cell of
// left_site on the left. The two end nodes are vertices or points of the border; they are the same if the chain is
// closed.
struct Voronoi_chain
{
  Vertex_id left_site, right_site;
  std::vector<Oriented_index> arcs;
  std::uint32_t first_node, last_node;
  bool is_closed;
  bool has_length; // false if all arcs are shorter than rounding tells
};

// The chains along a connected part of the boundary of a cell, in order, with the cell on the left. A part that the
// border of the mesh interrupts is not closed.
struct Voronoi_boundary_part
{
  std::vector<Oriented_index> chains;
  bool is_closed = false;
};

// The numbers of mesh vertices, of parts of mesh edges, and of parts of faces in a cell, without those on its boundary.
// They give its Euler characteristic. Pinched vertices are among the vertices. `vertex` is one of the vertices, null_id
// if there is none.
struct Voronoi_cell_elements
{
  std::size_t vertices = 0, edge_intervals = 0, face_regions = 0, pinched_vertices = 0;
  Vertex_id vertex = null_id;
};

// The counts of all cells, by site. Requires of all functions: the site is not null_id.
class Elements_of_cells
{
public:
  void clear()
  {
    m_cell_of_site.clear();
    m_cells.clear();
    m_last_site = null_id;
  }

  // Returns the counts of a cell, zeros if it has none so far.
  Voronoi_cell_elements find(Vertex_id site) const
  {
    const std::uint32_t* const cell = m_cell_of_site.find(site);
    return cell == nullptr ? Voronoi_cell_elements() : m_cells[*cell];
  }

  // Returns the counts of a cell, to be changed: the reference is valid until the next call. The last site is
  // remembered, as most calls repeat it.
  Voronoi_cell_elements& of(Vertex_id site)
  {
    if(site != m_last_site)
    {
      const std::uint32_t* const found = m_cell_of_site.find(site);
      const std::uint32_t cell = found == nullptr ? static_cast<std::uint32_t>(m_cells.size()) : *found;
      if(found == nullptr)
      {
        m_cells.emplace_back();
        m_cell_of_site.insert(site, cell);
      }
      m_last_site = site;
      m_last_cell = cell;
    }
    return m_cells[m_last_cell];
  }

private:
  Index_table<std::uint32_t> m_cell_of_site; // the index in m_cells
  std::vector<Voronoi_cell_elements> m_cells;
  Vertex_id m_last_site = null_id; // null_id if m_last_cell means nothing
  std::uint32_t m_last_cell = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_ARCS_AND_NODES_H
