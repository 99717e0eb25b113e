// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_STOPPING_CRITERION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_STOPPING_CRITERION_H

// How far a propagation has come, and whether that is far enough.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_pruning.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
class Stopping_criterion
{
public:
  void set_maximum_distance(const FT& d) { m_maximum_distance = d; }
  const FT& maximum_distance() const { return m_maximum_distance; }

  // The end is reached when the distances of all these vertices are final. They are not copied.
  void set_targets(const Vertex_id* first, const Vertex_id* last)
  {
    m_first_target = first;
    m_last_target = last;
  }

  // Everything that is still to come is not nearer than `key`: has the end been reached?
  bool is_reached_at(const FT& key, const std::vector<FT>& distance)
  {
    m_reached = (std::max)(m_reached, key); // rounding may let a child be nearer
    return m_reached > m_maximum_distance || targets_are_final(distance);
  }

  // Something comes from this distance on.
  void go_back_to(const FT& d) { m_reached = (std::min)(m_reached, d); }

  // Nothing is to come.
  void set_complete() { m_reached = std::numeric_limits<FT>::infinity(); }

  // Distances up to this one are final.
  const FT& reached_distance() const { return m_reached; }

private:
  bool targets_are_final(const std::vector<FT>& distance)
  {
    if(m_first_target == nullptr)
      return false;
    // the margin makes the result the same as without targets, bit by bit
    while(m_first_target != m_last_target && is_clearly_less<FT>(distance[*m_first_target], m_reached))
      ++m_first_target;
    return m_first_target == m_last_target;
  }

  FT m_maximum_distance = std::numeric_limits<FT>::infinity();
  FT m_reached = 0;
  const Vertex_id* m_first_target = nullptr; // of those that are not known to be final; null if none were set
  const Vertex_id* m_last_target = nullptr;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_STOPPING_CRITERION_H
