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

// The vertex with the largest distance, while distances shrink: a heap of distances as they were when they were put in.
// One that is found to have shrunk when it comes to the top is put in again, so each call of farthest() costs no more
// than the changes since the last one, but for a logarithm.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
class Farthest_vertex_queue
{
public:
  // `rank[v]` decides between vertices with the same distance: the smaller one wins. Vertices are 0, 1, ...
  Farthest_vertex_queue(const std::vector<FT>& distance, const std::vector<Vertex_id>& rank, std::size_t n)
    : m_distance(distance), m_rank(rank)
  {
    for(Vertex_id v = 0; v < n; ++v)
      m_heap.push_back(Entry(distance[v], v));
    std::make_heap(m_heap.begin(), m_heap.end(), less());
  }

  // null_id if there are no vertices.
  Vertex_id farthest()
  {
    while(!m_heap.empty())
    {
      const Entry top = m_heap.front();
      if(!(m_distance[top.second] < top.first))
        return top.second;
      std::pop_heap(m_heap.begin(), m_heap.end(), less());
      m_heap.back().first = m_distance[top.second];
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

  const std::vector<FT>& m_distance;
  const std::vector<Vertex_id>& m_rank;
  std::vector<Entry> m_heap;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_FARTHEST_VERTEX_QUEUE_H
