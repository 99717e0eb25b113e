// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_SOURCE_COMPONENTS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_SOURCE_COMPONENTS_H

// Which sources are in the same component of the surface, and runs in all components at once.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Repeated_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
class Source_components
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Runner = Repeated_propagation<Distance_propagation<FT, All_pruning_rules>>;

  // The mesh and the sources are referred to. Requires: the sources are vertices of the mesh.
  Source_components(const Mesh& mesh, const std::vector<Vertex_id>& sources)
    : m_mesh(mesh), m_sources(sources), m_runner(mesh)
  {}

  // Finds the components; the first source of each is its root. A run from a root reaches exactly its component, so all
  // components together cost one run. Returns false if go_further() does.
  template <typename GoFurther>
  bool find(const GoFurther& go_further)
  {
    const std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> component_of_vertex(m_mesh.number_of_vertices(), none);
    for(std::size_t i = 0; i < m_sources.size(); ++i)
    {
      const Vertex_id v = m_sources[i];
      if(component_of_vertex[v] == none)
      {
        m_roots.vertices.assign(1, v);
        if(!run(go_further))
          return false;
        for(const Vertex_id w : m_runner.vertices_reached())
          component_of_vertex[w] = m_positions.size();
        m_positions.emplace_back();
      }
      m_component_of_source.push_back(component_of_vertex[v]);
      m_positions[component_of_vertex[v]].push_back(i);
    }
    m_roots.vertices.clear();
    for(const std::vector<std::size_t>& positions : m_positions)
      m_roots.vertices.push_back(m_sources[positions.front()]);
    return true;
  }

  // Computes the distances of all vertices from the roots of their components, in one run. Returns false if
  // go_further() does.
  // The result does not depend on the order of the roots: each reaches its own component only.
  template <typename GoFurther>
  bool run(const GoFurther& go_further)
  {
    return m_runner.run(m_roots, Run_limits<FT>(), [&](std::size_t, const FT&) { return go_further(); });
  }

  // The distances of the last run(). After find(), those of one component only.
  const Runner& runner() const { return m_runner; }

  // In each component, makes the source with the largest distance(source) the root; of equal ones the first.
  template <typename Distance>
  void move_roots_to_farthest(const Distance& distance)
  {
    for(std::size_t c = 0; c < m_positions.size(); ++c)
    {
      std::size_t farthest = m_positions[c].front();
      for(const std::size_t i : m_positions[c])
        if(distance(m_sources[i]) > distance(m_sources[farthest]))
          farthest = i;
      m_roots.vertices[c] = m_sources[farthest];
    }
  }

  // The positions of the sources of each component, in ascending order.
  const std::vector<std::vector<std::size_t>>& positions() const { return m_positions; }

  // The component of the source at a position.
  std::size_t component_of_source(std::size_t i) const { return m_component_of_source[i]; }

private:
  const Mesh& m_mesh;
  const std::vector<Vertex_id>& m_sources; // the caller's
  Runner m_runner;
  Source_set<FT> m_roots; // by component, without offsets; during find(), the one of the component that is found
  std::vector<std::vector<std::size_t>> m_positions;
  std::vector<std::size_t> m_component_of_source;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_SOURCE_COMPONENTS_H
