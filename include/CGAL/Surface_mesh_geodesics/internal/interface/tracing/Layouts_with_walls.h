// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_LAYOUTS_WITH_WALLS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_LAYOUTS_WITH_WALLS_H

// Walls for a walk: edges that it does not cross. A wall is like a border: the walk ends there, and the frame of a
// vertex begins at the wall.

#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Does the surface end at h, for a walk that comes from the other side, or around the source of h? It does at a border,
// at a wall, and where the face of h is avoided. The layouts of a mesh without obstacles know none (Face_layout.h).
template <typename TriangleMesh, typename Layouts>
bool is_end_of_surface(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, const TriangleMesh& tm,
                       const Layouts& layouts)
{
  return is_border(h, tm) || layouts.is_wall(h) || layouts.is_avoided(face(h, tm));
}

// A walk asks for few edges, but in no order, so they are sorted once. They are sorted as halfedges: the order of edge
// descriptors may depend on the halfedge from which an edge was made, as in a linear cell complex.
//
// A range of edges, made ready for questions. Takes the time of sorting. Throws Invalid_geodesic_input for an edge that
// is not one of the mesh, as far as the mesh can tell: no index map is needed for a walk.
template <typename TriangleMesh>
class Edge_set
{
  using edge_descriptor = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  template <typename Edges>
  Edge_set(const TriangleMesh& tm, const Edges& edges)
  {
    for(const edge_descriptor e : edges)
    {
      if(!is_edge_of(e, tm))
        reject_edge("the edge to avoid", m_halfedges.size() / 2);
      const halfedge_descriptor h = halfedge(e, tm);
      m_halfedges.push_back(h); // NOLINT(performance-inefficient-vector-operation): a range need not know its size
      m_halfedges.push_back(opposite(h, tm));
    }
    std::sort(m_halfedges.begin(), m_halfedges.end());
  }

  bool contains(halfedge_descriptor h, const TriangleMesh&) const
  {
    return std::binary_search(m_halfedges.begin(), m_halfedges.end(), h);
  }

private:
  std::vector<halfedge_descriptor> m_halfedges; // sorted, both of each edge
};

// The edges for which a map of the user is true. The map is asked where the walk is, so its size does not matter.
template <typename EdgeMap>
class Edge_map_set
{
public:
  template <typename TriangleMesh>
  Edge_map_set(const TriangleMesh&, const EdgeMap& map) : m_map(map)
  {}

  template <typename Halfedge, typename TriangleMesh>
  bool contains(Halfedge h, const TriangleMesh& tm) const
  {
    return get(m_map, edge(h, tm));
  }

private:
  EdgeMap m_map;
};

// The walk asks its layouts for all that depends on the data of the user, so walls come with them.
//
// Layouts of faces that know walls besides.
template <typename TriangleMesh, typename Layouts, typename Walls>
class Layouts_with_walls : public Layouts
{
public:
  template <typename Edges>
  Layouts_with_walls(const TriangleMesh& tm, Layouts layouts, const Edges& edges)
    : Layouts(std::move(layouts)), m_mesh(tm), m_walls(tm, edges)
  {}

  bool is_wall(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h) const
  {
    return m_walls.contains(h, m_mesh);
  }

private:
  const TriangleMesh& m_mesh;
  Walls m_walls;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_LAYOUTS_WITH_WALLS_H
