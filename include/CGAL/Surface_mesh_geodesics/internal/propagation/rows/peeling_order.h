// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_PEELING_ORDER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_PEELING_ORDER_H

// An order of sources in which the rows of a triangular matrix take little time: each component is peeled from its far
// end. Row i needs the distances of the sources behind i. In this order they are those nearer to the other end, a ball
// that shrinks: its sources are near to each other, and Target_region.h prunes what leads away from it.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/rows/Source_components.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Returns the positions of the sources, sorted by component, and in a component by descending distance from an end of
// it: the source that is farthest from the first one. Equal distances keep their order. Takes three runs over what the
// sources reach, which ask go_further() after each visit; returns nothing if it returns false.
// Requires: the sources are vertices of the mesh.
template <typename FT, typename GoFurther>
std::vector<std::size_t> peeling_order(const Intrinsic_mesh<FT>& mesh, const std::vector<Vertex_id>& sources,
                                       const GoFurther& go_further)
{
  std::vector<std::size_t> order;
  Source_components<FT> components(mesh, sources);
  const auto distance = [&](Vertex_id v) { return components.runner().distance(v); };
  if(!components.find(go_further) || !components.run(go_further))
    return order;
  components.move_roots_to_farthest(distance);
  if(!components.run(go_further))
    return order;
  order.reserve(sources.size());
  std::vector<std::pair<FT, std::size_t>> keys;
  // Pairs are sorted by position where distances are equal.
  for(const std::vector<std::size_t>& positions : components.positions())
  {
    keys.clear();
    for(const std::size_t i : positions)
      keys.emplace_back(-distance(sources[i]), i);
    std::sort(keys.begin(), keys.end());
    for(const auto& key : keys)
      order.push_back(key.second);
  }
  return order;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_PEELING_ORDER_H
