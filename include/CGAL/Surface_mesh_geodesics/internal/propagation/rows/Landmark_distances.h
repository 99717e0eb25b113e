// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_LANDMARK_DISTANCES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_LANDMARK_DISTANCES_H

// The distances of all vertices from a few landmarks. With them, the triangle inequality bounds any distance from both
// sides: |d(l, x) - d(l, t)| <= d(x, t) <= d(l, x) + d(l, t). Target_region.h prunes with these bounds. (Landmarks come
// from shortest paths in road networks: Goldberg and Harrelson, Computing the shortest path: A* search meets graph
// theory, 2005.)
//
// The landmarks are sources far from each other: each next one is the farthest from those before. Every component has
// its own, which one run computes for all components at once.
//
// Distances are in single precision and in the unit of the mesh: the users add a margin.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/rows/Source_components.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
class Landmark_distances
{
public:
  using Mesh = Intrinsic_mesh<FT>;

  static constexpr std::size_t number = 15;

  // What is known of a vertex, in one line of the cache: the distances from the landmarks of its component, infinity if
  // that has no source. The last number is the radius of its star: the length of the longest edge around it.
  using Entry = std::array<float, number + 1>;

  // Computes the distances from landmarks among the sources, in as many runs as there are landmarks, and one to find
  // the components. Returns false if go_further() does; all other functions have no meaning then.
  // Requires: the sources are vertices of the mesh.
  template <typename GoFurther>
  bool compute(const Mesh& mesh, const std::vector<Vertex_id>& sources, const GoFurther& go_further)
  {
    m_entries.resize(mesh.number_of_vertices());
    m_nearest.assign(mesh.number_of_vertices(), 0);
    for(std::size_t v = 0; v < m_entries.size(); ++v)
    {
      m_entries[v].fill(std::numeric_limits<float>::infinity());
      m_entries[v].back() = radius_of_star(mesh, static_cast<Vertex_id>(v));
    }
    Source_components<FT> components(mesh, sources);
    if(!components.find(go_further))
      return false;
    for(std::size_t k = 0; k < number; ++k)
    {
      if(!components.run(go_further))
        return false;
      for(const Vertex_id v : components.runner().vertices_reached())
        set_distance(v, k, static_cast<float>(components.runner().distance(v)));
      components.move_roots_to_farthest([&](Vertex_id v) { return m_entries[v][m_nearest[v]]; });
    }
    for(std::size_t i = 0; i < sources.size(); ++i)
      m_component_of_source.push_back(components.component_of_source(i));
    m_positions = components.positions();
    for(std::vector<std::size_t>& positions : m_positions)
      std::sort(positions.begin(), positions.end(),
                [&](std::size_t i, std::size_t j) { return sources[i] < sources[j]; });
    return true;
  }

  const Entry& operator[](Vertex_id v) const { return m_entries[v]; }

  // Returns the number of the nearest landmark.
  std::size_t nearest(Vertex_id v) const { return m_nearest[v]; }

  // Returns the positions of the sources in the component of source i, in the order of their vertices in memory.
  const std::vector<std::size_t>& component_of(std::size_t i) const { return m_positions[m_component_of_source[i]]; }

private:
  // Any point of the star is so near to the vertex: a face is nowhere farther from a corner than at the other corners.
  static float radius_of_star(const Mesh& mesh, Vertex_id v)
  {
    FT radius = 0;
    mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
    {
      radius = (std::max)({radius, mesh.length(h), mesh.length(previous_halfedge(h))});
    });
    return static_cast<float>(radius);
  }

  // Enters the distance from landmark k, and keeps track of the nearest one.
  void set_distance(Vertex_id v, std::size_t k, float distance)
  {
    m_entries[v][k] = distance;
    if(distance < m_entries[v][m_nearest[v]])
      m_nearest[v] = static_cast<unsigned char>(k);
  }

  std::vector<Entry> m_entries;         // by vertex
  std::vector<unsigned char> m_nearest; // by vertex
  std::vector<std::size_t> m_component_of_source;
  std::vector<std::vector<std::size_t>> m_positions; // by component
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_LANDMARK_DISTANCES_H
