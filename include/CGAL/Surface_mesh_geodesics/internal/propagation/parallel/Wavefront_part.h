// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WAVEFRONT_PART_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WAVEFRONT_PART_H

// A part of the wavefront: some of the vertices, with their queue. Between two batches of visits each part is brought
// up to date by one thread, and parts by different threads at the same time.
//
// The vertices are dealt out to the parts in blocks, in turn, so that each part has its share of any region. Visits do
// not touch the parts. They leave messages for them (Wavefront_messages): distances that they improve, and vertices
// that must be queued. The result does not depend on the order of messages, nor on the number of parts:
// - Of several improvements of a vertex the smallest counts; of equal ones, that of the star with the smallest vertex.
// - A vertex is queued with the smallest of its keys.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront_queue.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>

#include <CGAL/assertions.h>

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

// A shorter path to a vertex, found in the star of another one, `star`: the arguments of Wavefront::improve().
template <typename FT>
struct Vertex_improvement
{
  Vertex_id vertex, star;
  FT distance;
  Vertex_arrival<FT> arrival;
  Arrival_image<FT> image;

  // Does it win against another improvement of the same vertex? Of equal ones of one star neither wins: they come from
  // one thread, in the order of the links.
  bool wins(const Vertex_improvement& other) const
  {
    return distance < other.distance || (!(other.distance < distance) && star < other.star);
  }
};

// What the visits of one thread leave for one part. That thread appends during the visits. The thread that updates the
// part reads and clears them between the visits, so they need no lock.
template <typename FT>
struct Wavefront_messages
{
  std::vector<Vertex_improvement<FT>> improvements;
  std::vector<Queued_vertex<FT>> queued;

  void clear()
  {
    improvements.clear();
    queued.clear();
  }
};

// The parts are numbered. Their number is a power of 2, so that a vertex and its number in its part are found by
// shifts.
//
// The bits of a vertex from the highest on: the number of its block in the part, the part (m_bits of them), the place
// in the block (block_bits). The number of the vertex in its part leaves out those in the middle.
class Part_numbering
{
public:
  // Makes at least n parts. Requires: n > 0.
  void set_number(std::size_t n)
  {
    m_bits = 0;
    while((std::size_t(1) << m_bits) < n)
      ++m_bits;
  }

  std::size_t number() const { return std::size_t(1) << m_bits; }
  std::size_t part_of(Vertex_id v) const { return (v >> block_bits) & (number() - 1); }

  // The number of a vertex in its part, and the vertex with a number in a part. Order is kept.
  Vertex_id number_in_part(Vertex_id v) const
  {
    return ((v >> (block_bits + m_bits)) << block_bits) | (v & ((Vertex_id(1) << block_bits) - 1));
  }
  Vertex_id vertex(Vertex_id number, std::size_t part) const
  {
    const Vertex_id block = ((number >> block_bits) << m_bits) | static_cast<Vertex_id>(part);
    return (block << block_bits) | (number & ((Vertex_id(1) << block_bits) - 1));
  }

  // More than number_in_part() for any vertex of a mesh with this number of vertices: the size of tables by that
  // number.
  std::size_t largest_part(std::size_t number_of_vertices) const
  {
    return ((number_of_vertices >> (block_bits + m_bits)) + 1) << block_bits;
  }

private:
  static constexpr unsigned int block_bits = 6; // a block fills a few cache lines of each table

  unsigned int m_bits = 0;
};

// Invariant, after take_over(): all vertices of the part that must be visited are in the queue or in batch().
//
// Threads: one at a time updates a part (take_over(), fill_batch()), which writes distances of its own vertices only.
// The other functions are for the conductor, while no other thread is at work.
template <typename FT>
class Wavefront_part
{
public:
  using Messages = Wavefront_messages<FT>;
  using Improvement = Vertex_improvement<FT>;

  // Empties the part, for a mesh with this number of vertices. Linear in the number of queued vertices and of vertices
  // that are new; linear in the size of the part if an exception has ended take_over().
  void restart(const Part_numbering& numbering, std::size_t part, std::size_t number_of_vertices)
  {
    m_numbering = numbering;
    m_part = part;
    const std::size_t n = numbering.largest_part(number_of_vertices);
    m_queue.restart(n);
    if(m_is_taking_over)
      m_best.clear();
    m_is_taking_over = false;
    m_best.resize(n, nullptr);
    m_batch.clear();
    has_stale_windows = false;
  }

  // Takes over the messages that all threads have left for this part, and clears them. `messages` is a range of
  // pointers.
  //
  // Three passes over the messages: the first finds the best improvement of each vertex, the second applies it and
  // queues vertices, the third forgets. Only the best one is applied: after a worse one, a better one within rounding
  // would be ignored (is_improvement()), so the result would depend on the order of the messages. Takes linear time,
  // plus that of the queue.
  template <typename RangeOfMessages>
  void take_over(const RangeOfMessages& messages, Wavefront<FT>& wavefront)
  {
    m_is_taking_over = true;
    for(const Messages* m : messages)
      for(const Improvement& i : m->improvements)
        consider(i);
    for(const Messages* m : messages)
    {
      for(const Improvement& i : m->improvements)
        if(m_best[m_numbering.number_in_part(i.vertex)] == &i)
          improve(i, wavefront);
      for(const Queued_vertex<FT>& q : m->queued)
        push(q.vertex, q.key);
    }
    for(Messages* m : messages)
    {
      for(const Improvement& i : m->improvements)
        m_best[m_numbering.number_in_part(i.vertex)] = nullptr;
      m->clear();
    }
    m_is_taking_over = false;
  }

  // Moves the vertices that had no distance before to the end of `reached`.
  void move_reached(std::vector<Vertex_id>& reached)
  {
    reached.insert(reached.end(), m_reached.begin(), m_reached.end());
    m_reached.clear();
  }

  // Moves all vertices with keys up to a limit from the queue into the batch. Requires: the batch is empty.
  void fill_batch(const FT& limit)
  {
    CGAL_expensive_assertion(m_batch.empty());
    while(!m_queue.empty() && m_queue.top_key() <= limit)
    {
      m_batch.push_back({m_queue.top_key(), m_numbering.vertex(m_queue.top(), m_part)});
      m_queue.pop();
    }
  }

  // The vertices to be visited, nearest first.
  const std::vector<Queued_vertex<FT>>& batch() const { return m_batch; }
  void clear_batch() { m_batch.clear(); }

  // Moves the vertices of the batch back into the queue.
  void give_back_batch()
  {
    for(const Queued_vertex<FT>& q : m_batch)
      push(q.vertex, q.key);
    m_batch.clear();
  }

  // Requires: the vertex belongs to this part.
  void push(Vertex_id v, const FT& key) { m_queue.push_or_decrease(m_numbering.number_in_part(v), key); }

  // The number of vertices that are queued or in the batch, and the smallest key of these, or infinity.
  std::size_t size() const { return m_queue.size() + m_batch.size(); }
  FT nearest_key() const
  {
    return !m_batch.empty() ? m_batch.front().key
         : m_queue.empty()  ? Vertex_distance_field<FT>::infinity()
                            : m_queue.top_key();
  }

  // An upper bound of the keys of all vertices that are queued or in the batch.
  const FT& largest_key() const { return m_queue.largest_key(); }

  std::size_t table_memory() const { return m_queue.table_memory() + m_best.capacity() * sizeof(m_best[0]); }

  bool has_stale_windows = false; // a vertex that had emitted windows was improved; the owner resets it

private:
  // Keeps the best improvement of each vertex in mind.
  void consider(const Improvement& i)
  {
    const Improvement*& best = m_best[m_numbering.number_in_part(i.vertex)];
    if(best == nullptr || i.wins(*best))
      best = &i;
  }

  void improve(const Improvement& i, Wavefront<FT>& wavefront)
  {
    if(wavefront.improve(i.vertex, i.distance, i.arrival, i.image, m_reached,
                         [this](Vertex_id v, const FT& key) { push(v, key); }))
      has_stale_windows = true;
  }

  Part_numbering m_numbering;
  std::size_t m_part = 0;
  Wavefront_queue<FT> m_queue{0};          // of numbers in the part
  std::vector<const Improvement*> m_best;  // by number in the part; null between calls
  std::vector<Queued_vertex<FT>> m_batch;
  std::vector<Vertex_id> m_reached; // since the last move_reached()
  bool m_is_taking_over = false;    // outside take_over() only if an exception has ended it
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WAVEFRONT_PART_H
