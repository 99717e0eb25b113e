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

// How far a propagation has come, and whether that is far enough: at a maximum distance, or when the distances of all
// targets are final.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_pruning.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariant: a vertex whose distance is not greater than reached_distance() has its final distance, up to rounding.
// It holds because a window never has a descendant that is nearer (thesis, 3.3.2.2: continuous Dijkstra), provided
// that the owner calls is_reached_at() with the smallest key that waits, and go_back_to() with each new source.
//
// reached_distance() ascends from call to call of is_reached_at(); only go_back_to() decreases it.
template <typename FT>
class Stopping_criterion
{
public:
  // Stops the propagation beyond d. Requires: d >= 0; infinity means no limit, the default.
  void set_maximum_distance(const FT& d)
  {
    CGAL_assertion(d >= 0);
    m_maximum_distance = d;
  }

  const FT& maximum_distance() const { return m_maximum_distance; }

  // Stops the propagation when the distances of the vertices in [first, last) are final. The range is not copied: it
  // must live as long as it is in use. Without targets the propagation goes on to the maximum distance.
  void set_targets(const Vertex_id* first, const Vertex_id* last)
  {
    CGAL_assertion(first <= last);
    m_first_target = first;
    m_last_target = last;
  }

  // Advances to `key`, and returns whether the propagation may stop. Requires: no window that waits is nearer than
  // `key`; `distance` are the current distances of the vertices. Amortized cost: constant, plus each target once.
  // Ties: a key at the maximum distance does not end the run, as vertices at that distance may still be reached from
  // it.
  bool is_reached_at(const FT& key, const std::vector<FT>& distance)
  {
    m_reached = (std::max)(m_reached, key); // rounding may let a window be nearer than its parent
    return m_reached > m_maximum_distance || targets_are_final(distance);
  }

  // Takes back what was reached beyond d, because something new starts there.
  void go_back_to(const FT& d) { m_reached = (std::min)(m_reached, d); }

  // Declares all distances final, because nothing waits.
  void set_complete() { m_reached = std::numeric_limits<FT>::infinity(); }

  // Distances up to this one are final.
  const FT& reached_distance() const { return m_reached; }

private:
  // Skips the targets that are final; the margin of is_clearly_less() makes their distances the same, bit by bit, as
  // those of a propagation without targets.
  bool targets_are_final(const std::vector<FT>& distance)
  {
    if(m_first_target == nullptr)
      return false;
    while(m_first_target != m_last_target && is_clearly_less<FT>(distance[*m_first_target], m_reached))
      ++m_first_target;
    return m_first_target == m_last_target;
  }

  FT m_maximum_distance = std::numeric_limits<FT>::infinity();
  FT m_reached = 0;
  const Vertex_id* m_first_target = nullptr; // the first one not known to be final; null if there are no targets
  const Vertex_id* m_last_target = nullptr;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_STOPPING_CRITERION_H
