// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_VERTEX_FRONT_QUEUE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_VERTEX_FRONT_QUEUE_H

// The vertices of the wavefront, nearest first (thesis, 4.3.2): a heap with four children a node and
// the place of each vertex, so that a key can be decreased. Equal keys are ordered by vertex, so that
// the order does not depend on the history of the heap.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
class Vertex_front_queue
{
public:
  explicit Vertex_front_queue(std::size_t number_of_vertices)
    : m_place(number_of_vertices, null_id)
  {}

  // empties the queue, in time proportional to what is in it, for the vertices 0 .. n-1.
  void restart(std::size_t number_of_vertices)
  {
    for(const Entry& entry : m_heap)
      m_place[entry.vertex] = null_id;
    m_heap.clear();
    m_place.resize(number_of_vertices, null_id);
  }

  bool empty() const { return m_heap.empty(); }
  bool contains(Vertex_id v) const { return m_place[v] != null_id; }
  Vertex_id top() const { return m_heap.front().vertex; }
  const FT& top_key() const { return m_heap.front().key; }

  // inserts v, or decreases its key; a key that is not smaller is ignored.
  void push_or_decrease(Vertex_id v, const FT& key)
  {
    const Entry entry{key, v};
    if(!contains(v))
    {
      m_heap.push_back(entry);
      sift_up(m_heap.size() - 1, entry);
    }
    else if(is_before(entry, m_heap[m_place[v]]))
      sift_up(m_place[v], entry);
  }

  void pop()
  {
    m_place[m_heap.front().vertex] = null_id;
    const Entry last = m_heap.back();
    m_heap.pop_back();
    if(!m_heap.empty())
      sift_down(last);
  }

  // of what there is for each vertex of the mesh.
  std::size_t table_memory() const { return m_place.capacity() * sizeof(m_place[0]); }

private:
  struct Entry
  {
    FT key;
    Vertex_id vertex;
  };

  static bool is_before(const Entry& a, const Entry& b)
  {
    // (numbers, combined by & and |: no branch, as the outcome cannot be predicted)
    const int is_less = a.key < b.key, is_not_greater = !(b.key < a.key), is_first = a.vertex < b.vertex;
    return (is_less | (is_not_greater & is_first)) != 0;
  }

  void place(std::size_t i, const Entry& entry)
  {
    m_heap[i] = entry;
    m_place[entry.vertex] = static_cast<std::uint32_t>(i);
  }

  void sift_up(std::size_t i, const Entry& entry)
  {
    while(i > 0)
    {
      const std::size_t parent = (i - 1) / 4;
      if(!is_before(entry, m_heap[parent]))
        break;
      place(i, m_heap[parent]);
      i = parent;
    }
    place(i, entry);
  }

  // puts an entry in at the root, which is vacant.
  void sift_down(const Entry& entry)
  {
    std::size_t i = 0;
    for(;;)
    {
      const std::size_t first = 4 * i + 1;
      if(first >= m_heap.size())
        break;
      const std::size_t last = (std::min)(first + 4, m_heap.size());
      std::size_t best = first;
      for(std::size_t child = first + 1; child < last; ++child)
        best += is_before(m_heap[child], m_heap[best]) * (child - best);
      if(!is_before(m_heap[best], entry))
        break;
      place(i, m_heap[best]);
      i = best;
    }
    place(i, entry);
  }

  std::vector<Entry> m_heap;
  std::vector<std::uint32_t> m_place;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_VERTEX_FRONT_QUEUE_H
