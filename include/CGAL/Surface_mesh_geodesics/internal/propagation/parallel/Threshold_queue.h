// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_THRESHOLD_QUEUE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_THRESHOLD_QUEUE_H

// The queue of a part of the wavefront. It gives out all vertices with keys up to a threshold at once, in no order.
//
// So it needs no heap: its entries lie in a row, and are looked at one after the other. A batch is a third or a sixth
// of a wavefront (Batch_threshold.h), so that costs three to six comparisons for each vertex of the batch, on memory
// that the processor loads in advance. A heap moves several entries for each one, and each move writes to the record of
// another vertex, somewhere in memory.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Vertex_records.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// An entry of a queue, in a batch or on its way to a queue. The order is that of Wavefront_queue.
template <typename FT>
struct Queued_vertex
{
  FT key;
  Vertex_id vertex;

  bool operator<(const Queued_vertex& other) const
  {
    return key < other.key || (!(other.key < key) && vertex < other.vertex);
  }
};

// Invariant: the record of each vertex in the queue has its position here. The records of vertices that are in no queue
// have the position null_id. Several queues share the records; no two contain the same vertex.
template <typename FT>
class Threshold_queue
{
public:
  using Entry = Queued_vertex<FT>;

  // Begins with records. Requires: the queue is empty.
  void begin(Vertex_records<FT>& records)
  {
    CGAL_assertion(m_entries.empty());
    m_records = &records;
  }

  // Removes all entries. Linear in their number.
  void clear()
  {
    CGAL_expensive_assertion(is_valid());
    for(const Entry& q : m_entries)
      (*m_records)[q.vertex].position = null_id;
    m_entries.clear();
    m_largest_key = 0;
  }

  std::size_t size() const { return m_entries.size(); }

  // An upper bound of all keys in the queue: the largest one that has been pushed since clear().
  const FT& largest_key() const { return m_largest_key; }

  // The smallest key, or infinity. Linear in the number of entries.
  FT nearest_key() const
  {
    FT key = Vertex_distance_field<FT>::infinity();
    for(const Entry& q : m_entries)
      key = (std::min)(key, q.key);
    return key;
  }

  // Inserts v, or decreases its key. Ignores a key that is not smaller than that of v. Takes constant time. Nothing has
  // changed if it throws.
  void push_or_decrease(Vertex_id v, const FT& key)
  {
    CGAL_expensive_assertion(v < m_records->size() && key == key);
    std::uint32_t& position = (*m_records)[v].position;
    if(position == null_id)
    {
      m_entries.push_back({key, v});
      position = static_cast<std::uint32_t>(m_entries.size() - 1);
    }
    else
      m_entries[position].key = (std::min)(m_entries[position].key, key);
    m_largest_key = (std::max)(m_largest_key, key); // also of a key that is ignored: the order does not matter then
  }

  // Moves all entries with keys up to a limit to the end of a batch. The last entry takes the place of one that leaves.
  // Linear in the number of entries.
  void move_up_to(const FT& limit, std::vector<Entry>& batch)
  {
    CGAL_expensive_assertion(is_valid());
    for(std::size_t i = 0; i < m_entries.size();)
    {
      if(limit < m_entries[i].key)
      {
        ++i;
        continue;
      }
      batch.push_back(m_entries[i]);
      m_entries[i] = m_entries.back();
      (*m_records)[m_entries[i].vertex].position = static_cast<std::uint32_t>(i);
      (*m_records)[batch.back().vertex].position = null_id; // (it may have been the last one)
      m_entries.pop_back();
    }
  }

  // Does the invariant hold for the entries? Linear in their number.
  bool is_valid() const
  {
    for(std::size_t i = 0; i < m_entries.size(); ++i)
      if((*m_records)[m_entries[i].vertex].position != i)
        return false;
    return true;
  }

private:
  std::vector<Entry> m_entries;
  FT m_largest_key = 0;
  Vertex_records<FT>* m_records = nullptr;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_THRESHOLD_QUEUE_H
