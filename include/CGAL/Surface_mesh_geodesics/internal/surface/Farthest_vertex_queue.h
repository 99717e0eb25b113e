// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_FARTHEST_VERTEX_QUEUE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_FARTHEST_VERTEX_QUEUE_H

// Finds the vertex with the largest distance while distances shrink. A heap holds distances as they were when they
// entered it. If a distance has shrunk when it reaches the top, it enters again, so farthest() takes time proportional
// to the number of changes since the last call, times a logarithm.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariant: each of the vertices has one entry, whose key is not smaller than its distance. So an entry at the top
// whose key is its distance is the farthest: no other distance exceeds the key of its own entry.
//
// Vertices that no source reaches have the distance infinity; they are the farthest.
//
// Distance is a function from vertices to numbers: where walls divide a vertex of the user, all of its copies have the
// least distance of them.
template <typename Distance>
class Farthest_vertex_queue
{
  using FT = std::decay_t<decltype(std::declval<const Distance&>()(Vertex_id(0)))>;

public:
  // Contains the vertices 0 .. n-1. Requires: the vector has entries for them. Of vertices with the same distance(v),
  // the one with the smallest rank[v] is the farthest. The vector is referred to, not copied; distances may shrink, but
  // not grow. Takes linear time.
  Farthest_vertex_queue(const Distance& distance, const std::vector<Vertex_id>& rank, std::size_t n)
    : m_distance(distance), m_rank(rank)
  {
    CGAL_assertion(n <= rank.size());
    for(Vertex_id v = 0; v < n; ++v)
      m_heap.push_back(Entry(distance(v), v));
    std::make_heap(m_heap.begin(), m_heap.end(), less());
  }

  // Returns the vertex with the largest distance; null_id if there are no vertices. The vertex stays in the queue.
  Vertex_id farthest()
  {
    while(!m_heap.empty())
    {
      const Entry top = m_heap.front();
      const FT distance = m_distance(top.second);
      if(!(distance < top.first))
        return top.second;
      std::pop_heap(m_heap.begin(), m_heap.end(), less());
      m_heap.back().first = distance;
      std::push_heap(m_heap.begin(), m_heap.end(), less());
    }
    return null_id;
  }

private:
  using Entry = std::pair<FT, Vertex_id>;

  auto less() const
  {
    return [this](const Entry& a, const Entry& b)
    { return a.first != b.first ? a.first < b.first : m_rank[a.second] > m_rank[b.second]; };
  }

  Distance m_distance;
  const std::vector<Vertex_id>& m_rank;
  std::vector<Entry> m_heap;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_FARTHEST_VERTEX_QUEUE_H
