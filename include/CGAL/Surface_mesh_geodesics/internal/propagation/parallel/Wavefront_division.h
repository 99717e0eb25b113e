// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WAVEFRONT_DIVISION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WAVEFRONT_DIVISION_H

// The wavefront divided into parts, one for each thread. A part has a region of the surface, so that its thread works
// where it has worked before, on data that is in its cache. That decides how much several threads gain: it takes long
// to read what another thread has just written, on some machines half as long as a visit.
//
// How regions arise. A vertex that a visit meets for the first time belongs to the part of the vertex that is visited.
// So regions grow outward with the wavefront. If one part has many more visits than another one, some of its vertices
// change their part. They are those with the largest or smallest numbers: vertices are numbered breadth first
// (Intrinsic_mesh_builder.h), so these lie at one end of the region, and regions stay in one piece, more or less.
//
// The result does not depend on the division (Wavefront_part.h).

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Vertex_records.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Wavefront_part.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariant, while no thread is at work: each vertex that is queued, or in a batch, or in a message, belongs to a part.
// A queued vertex is in the queue of its part. A batch that sort_batches() has filled may have vertices of other parts.
//
// Threads: any may call part_of(), and one at a time may update a part. The other functions are for the conductor,
// while no other thread is at work: all of them are serial work between the phases, which no thread can help with. They
// take time linear in the number of parts; those that move vertices also in the size of the batch.
template <typename FT>
class Wavefront_division
{
public:
  using Part = Wavefront_part<FT>;
  using Batch = std::vector<Queued_vertex<FT>>;

  static constexpr std::size_t maximum_number_of_parts = Vertex_records<FT>::maximum_number_of_parts;

  // Empties all parts. Linear in the number of queued vertices, and of vertices that are new; linear in the mesh if an
  // exception has ended the update of a part. Requires: 0 < n <= maximum_number_of_parts.
  void restart(std::size_t n, std::size_t number_of_vertices)
  {
    bool is_interrupted = false;
    for(Part& part : m_parts)
    {
      part.clear();
      is_interrupted = is_interrupted || part.is_taking_over();
    }
    if(is_interrupted)
      m_records.clear_best();
    m_parts.resize(n);
    m_records.restart(number_of_vertices);
    for(Part& part : m_parts)
      part.begin(m_records);
  }

  std::size_t number_of_parts() const { return m_parts.size(); }
  Part& part(std::size_t i) { return m_parts[i]; }
  const Part& part(std::size_t i) const { return m_parts[i]; }

  // What is known of each vertex. Requires of a vertex: it belongs to the mesh of the last restart().
  Vertex_records<FT>& records() { return m_records; }
  const Vertex_records<FT>& records() const { return m_records; }

  // The part of a vertex that a visit in the given part has met.
  std::size_t part_of(Vertex_id v, std::size_t part) { return m_records.part_of(v, part); }

  // Queues a vertex; one that belongs to no part belongs to the given one from now on.
  void push(Vertex_id v, const FT& key, std::size_t part = 0) { m_parts[part_of(v, part)].push(v, key); }

  // The number of vertices in batches, and that of all vertices of the wavefront.
  std::size_t size_of_batch() const
  {
    std::size_t n = 0;
    for(const Part& part : m_parts)
      n += part.batch().size();
    return n;
  }
  std::size_t size() const
  {
    std::size_t n = size_of_batch();
    for(const Part& part : m_parts)
      n += part.size_of_queue();
    return n;
  }

  // After all parts have filled their batches: the smallest key of the wavefront, and the largest one in a batch.
  FT nearest_key() const
  {
    FT key = m_parts.front().nearest_key();
    for(const Part& part : m_parts)
      key = (std::min)(key, part.nearest_key());
    return key;
  }
  FT farthest_key() const
  {
    FT key = 0;
    for(const Part& part : m_parts)
      key = (std::max)(key, part.farthest_key());
    return key;
  }

  // An upper bound of the keys of all vertices that are queued or in a batch.
  FT largest_key() const
  {
    FT key = 0;
    for(const Part& part : m_parts)
      key = (std::max)(key, part.largest_key());
    return key;
  }

  // The smallest key in a queue. Requires: all batches are empty.
  FT nearest_queued_key()
  {
    for(Part& part : m_parts)
      part.fill_batch(FT(-1));
    return nearest_key();
  }

  // Returns up to which key a batch should reach for half of it to be visited, if n vertices of this one were: the key
  // that is larger than 2 n others in the batch. Returns infinity if half of it was visited.
  FT key_to_go_back_to(std::size_t n)
  {
    if(2 * n >= size_of_batch())
      return Vertex_distance_field<FT>::infinity();
    gather_batches();
    const auto at = m_buffer.begin() + static_cast<std::ptrdiff_t>(2 * n);
    std::nth_element(m_buffer.begin(), at, m_buffer.end());
    return at->key;
  }

  // Has a part improved a vertex that had emitted windows, since the last call?
  bool forget_stale_windows()
  {
    bool is_any = false;
    for(Part& part : m_parts)
    {
      is_any |= part.has_stale_windows;
      part.has_stale_windows = false;
    }
    return is_any;
  }

  // Moves the vertices that the parts have reached for the first time to the end of `reached`.
  void move_reached(std::vector<Vertex_id>& reached)
  {
    for(Part& part : m_parts)
      part.move_reached(reached);
  }

  void clear_batches()
  {
    for(Part& part : m_parts)
      part.batch().clear();
  }

  // Moves the vertices of all batches back into the queues.
  void give_back_batches()
  {
    for(Part& part : m_parts)
    {
      for(const Queued_vertex<FT>& q : part.batch())
        push(q.vertex, q.key);
      part.batch().clear();
    }
  }

  // Lets each part have about as many visits, if one has a quarter more than its share. What moves is handed from part
  // to part: the largest numbers up, the smallest ones down.
  void balance()
  {
    const std::size_t n = size_of_batch(), parts = m_parts.size();
    std::size_t largest = 0;
    for(const Part& part : m_parts)
      largest = (std::max)(largest, part.batch().size());
    if(4 * largest * parts <= 5 * n + 4 * parts)
      return;
    for(std::size_t i = 0; i + 1 < parts; ++i) // fills each part up from those behind it, or hands on what it has
    {
      const std::size_t share = n * (i + 1) / parts - n * i / parts;
      move_up(i, share);
      for(std::size_t k = i + 1; k < parts && m_parts[i].batch().size() < share; ++k)
        move_down(k, i, share - m_parts[i].batch().size());
    }
  }

  // Sorts the vertices of all batches by key, and deals them out to the batches in this order, evenly.
  void sort_batches()
  {
    gather_batches();
    std::sort(m_buffer.begin(), m_buffer.end());
    const std::size_t n = m_buffer.size(), parts = m_parts.size();
    const auto at = [&](std::size_t i) { return m_buffer.begin() + static_cast<std::ptrdiff_t>(n * i / parts); };
    for(std::size_t i = 0; i < parts; ++i)
      m_parts[i].batch().assign(at(i), at(i + 1));
  }

  std::size_t table_memory() const
  {
    return m_records.memory();
  }

private:
  // Copies the vertices of all batches to the buffer.
  void gather_batches()
  {
    m_buffer.clear();
    for(const Part& part : m_parts)
      m_buffer.insert(m_buffer.end(), part.batch().begin(), part.batch().end());
  }

  static bool has_smaller_number(const Queued_vertex<FT>& a, const Queued_vertex<FT>& b) { return a.vertex < b.vertex; }
  static bool has_larger_number(const Queued_vertex<FT>& a, const Queued_vertex<FT>& b) { return b.vertex < a.vertex; }

  // Moves the vertices with the largest numbers from batch i to batch i + 1, until n are left.
  void move_up(std::size_t i, std::size_t n)
  {
    Batch& batch = m_parts[i].batch();
    if(batch.size() > n)
      move(batch, batch.size() - n, i + 1, has_larger_number);
  }

  // Moves n vertices with the smallest numbers, or all if there are fewer, from batch i to batch `to`.
  void move_down(std::size_t i, std::size_t to, std::size_t n)
  {
    Batch& batch = m_parts[i].batch();
    move(batch, (std::min)(n, batch.size()), to, has_smaller_number);
  }

  // Moves the first n vertices in some order to the end of another batch.
  template <typename Order>
  void move(Batch& batch, std::size_t n, std::size_t to, Order order)
  {
    if(n == 0)
      return;
    const auto end = batch.begin() + static_cast<std::ptrdiff_t>(n);
    std::nth_element(batch.begin(), end - 1, batch.end(), order);
    for(auto q = batch.begin(); q != end; ++q)
      m_records.set_part(q->vertex, to);
    m_parts[to].batch().insert(m_parts[to].batch().end(), batch.begin(), end);
    batch.erase(batch.begin(), end);
  }

  std::vector<Part> m_parts;
  Vertex_records<FT> m_records;
  Batch m_buffer;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WAVEFRONT_DIVISION_H
