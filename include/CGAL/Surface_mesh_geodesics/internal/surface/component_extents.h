// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_COMPONENT_EXTENTS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_COMPONENT_EXTENTS_H

// What rounding is relative to, where a mesh has components of very different sizes.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// calls visit(v) for all vertices to which faces lead from those of a list, which are among them.
template <typename FT, typename Visit>
void for_each_connected_vertex(const Intrinsic_mesh<FT>& mesh, std::vector<Vertex_id> stack,
                               std::vector<char>& is_known, Visit visit)
{
  for(const Vertex_id v : stack)
    is_known[v] = 1;
  const auto add = [&](Vertex_id v)
  {
    if(is_known[v] == 0)
      stack.push_back(v);
    is_known[v] = 1;
  };
  while(!stack.empty())
  {
    const Vertex_id v = stack.back();
    stack.pop_back();
    visit(v);
    mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
    {
      add(mesh.target(h));
      add(mesh.source(previous_halfedge(h)));
    });
  }
}

// for each vertex, the longest edge of its component.
template <typename FT>
std::vector<FT> component_extents(const Intrinsic_mesh<FT>& mesh)
{
  std::vector<FT> extents(mesh.number_of_vertices(), FT(0));
  std::vector<char> is_known(mesh.number_of_vertices(), 0);
  std::vector<Vertex_id> component;
  for(Vertex_id first = 0; first < mesh.number_of_vertices(); ++first)
  {
    if(is_known[first] != 0)
      continue;
    component.clear();
    FT longest = 0;
    for_each_connected_vertex(mesh, {first}, is_known, [&](Vertex_id v)
    {
      component.push_back(v);
      mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
      { longest = (std::max)(longest, (std::max)(mesh.length(h), mesh.length(previous_halfedge(h)))); });
    });
    for(const Vertex_id v : component)
      extents[v] = longest;
  }
  return extents;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_COMPONENT_EXTENTS_H
