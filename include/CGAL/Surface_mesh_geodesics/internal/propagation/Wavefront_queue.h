// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WAVEFRONT_QUEUE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WAVEFRONT_QUEUE_H

// The priority queue of the wavefront (thesis, 4.3.2): vertices ordered by the smallest distance that waits at them.
//
// An indexed heap with four children per node: the children of entry i are 4 i + 1, ..., 4 i + 4. It stores the
// position of each vertex in the heap, so that a key can be decreased in place and a vertex has at most one entry. Four
// children make the heap half as deep as two, and the children of a node lie in a row, in one cache line or in two.
//
// Ties: equal keys are ordered by vertex index. The order of visits, and with it every bit of the result, therefore
// depends on the keys alone and not on the history of the heap.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariants, between calls of public members:
// - m_position[m_heap[i].vertex] == i for each entry i, and m_position[v] == null_id for each vertex not in the queue;
// - no entry is before its parent, the entry (i - 1) / 4.
//
// Debug builds with CGAL_CHECK_EXPENSIVE check the neighborhood of each entry that moves, and the whole queue in
// restart().
template <typename FT>
class Wavefront_queue
{
public:
  // An empty queue for the vertices 0 .. number_of_vertices - 1.
  explicit Wavefront_queue(std::size_t number_of_vertices)
    : m_position(number_of_vertices, null_id)
  {}

  // Empties the queue, for the vertices 0 .. number_of_vertices - 1. Linear in the number of entries and of vertices
  // that are new; independent of the size of the mesh otherwise.
  void restart(std::size_t number_of_vertices)
  {
    clear();
    m_position.resize(number_of_vertices, null_id);
  }

  // Removes all entries. Linear in their number.
  void clear()
  {
    CGAL_expensive_assertion(is_valid());
    for(const Entry& entry : m_heap)
      m_position[entry.vertex] = null_id;
    m_heap.clear();
    m_largest_key = 0;
  }

  bool empty() const { return m_heap.empty(); }
  std::size_t size() const { return m_heap.size(); }
  bool contains(Vertex_id v) const { return m_position[v] != null_id; }

  // The vertex with the smallest key, and its key. Requires: !empty().
  Vertex_id top() const
  {
    CGAL_expensive_assertion(!empty());
    return m_heap.front().vertex;
  }

  const FT& top_key() const
  {
    CGAL_expensive_assertion(!empty());
    return m_heap.front().key;
  }

  // An upper bound of all keys in the queue: the largest one since restart().
  const FT& largest_key() const { return m_largest_key; }

  // Inserts v, or decreases its key. Ignores a key that is not smaller than that of v. O(log n).
  // Requires: v is a vertex of the mesh; the key is a number.
  void push_or_decrease(Vertex_id v, const FT& key)
  {
    CGAL_expensive_assertion(v < m_position.size() && key == key);
    const Entry entry{key, v};
    if(!contains(v))
    {
      m_largest_key = (std::max)(m_largest_key, key);
      m_heap.push_back(entry);
      sift_up(m_heap.size() - 1, entry);
    }
    else if(is_before(entry, m_heap[m_position[v]]))
      sift_up(m_position[v], entry);
    CGAL_expensive_assertion(is_in_order(m_position[v]));
  }

  // Removes the top. O(log n). Requires: !empty().
  void pop()
  {
    CGAL_expensive_assertion(!empty());
    m_position[m_heap.front().vertex] = null_id;
    const Entry last = m_heap.back();
    m_heap.pop_back();
    if(!m_heap.empty())
    {
      sift_down(last);
      CGAL_expensive_assertion(is_in_order(0) && is_in_order(m_position[last.vertex]));
    }
  }

  // Do the invariants hold? Linear in the number of entries.
  bool is_valid() const
  {
    for(std::size_t i = 0; i < m_heap.size(); ++i)
      if(!is_in_order(i))
        return false;
    return true;
  }

  // Bytes of the table of positions, which has an entry for each vertex of the mesh.
  std::size_t table_memory() const { return m_position.capacity() * sizeof(m_position[0]); }

private:
  struct Entry
  {
    FT key;
    Vertex_id vertex;
  };

  // A strict total order on entries with different vertices.
  static bool is_before(const Entry& a, const Entry& b)
  {
    // Integers combined by & and | keep this free of branches: the processor could not predict the outcome.
    const int is_less = a.key < b.key, is_not_greater = !(b.key < a.key), is_first = a.vertex < b.vertex;
    return (is_less | (is_not_greater & is_first)) != 0;
  }

  // Do the invariants hold for entry i, its parent and its children?
  bool is_in_order(std::size_t i) const
  {
    if(m_position[m_heap[i].vertex] != i || (i > 0 && is_before(m_heap[i], m_heap[(i - 1) / 4])))
      return false;
    const std::size_t last = (std::min)(4 * i + 5, m_heap.size());
    for(std::size_t child = 4 * i + 1; child < last; ++child)
      if(is_before(m_heap[child], m_heap[i]))
        return false;
    return true;
  }

  void put(std::size_t i, const Entry& entry)
  {
    m_heap[i] = entry;
    m_position[entry.vertex] = static_cast<std::uint32_t>(i);
  }

  // Moves the vacancy at i toward the root until the entry fits there. Each entry on the way moves once; no two are
  // exchanged.
  void sift_up(std::size_t i, const Entry& entry)
  {
    while(i > 0)
    {
      const std::size_t parent = (i - 1) / 4;
      if(!is_before(entry, m_heap[parent]))
        break;
      put(i, m_heap[parent]);
      i = parent;
    }
    put(i, entry);
  }

  // Moves the vacancy at the root toward the leaves until the entry fits there. Each step finds the least of up to four
  // children, without a branch for the same reason as is_before().
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
      put(i, m_heap[best]);
      i = best;
    }
    put(i, entry);
  }

  std::vector<Entry> m_heap;
  FT m_largest_key = 0;
  std::vector<std::uint32_t> m_position; // in m_heap, by vertex
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WAVEFRONT_QUEUE_H
