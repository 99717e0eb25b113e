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
// Visits do not touch the parts. They leave messages for them (Wavefront_messages): distances that they improve, and
// vertices that must be queued. The result depends neither on the order of messages, nor on the number of parts, nor on
// which part has a vertex (Wavefront_division.h):
// - Of several improvements of a vertex the smallest counts; of equal ones, that of the star with the smallest vertex.
// - A vertex is queued with the smallest of its keys.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Threshold_queue.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Vertex_records.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// Visual C++ warns of classes that are padded to cache lines. They are, on purpose: several threads change them at the
// same time, and two on one line would wait for each other.
#ifdef _MSC_VER
#pragma warning(push)
#pragma warning(disable : 4324)
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

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
//
// Messages and parts have cache lines of their own, as they change all the time.
template <typename FT>
struct alignas(64) Wavefront_messages
{
  std::vector<Vertex_improvement<FT>> improvements;
  std::vector<Queued_vertex<FT>> queued;

  void clear()
  {
    improvements.clear();
    queued.clear();
  }
};

// Invariant, after take_over(): all vertices of the part that must be visited are in the queue or in batch().
//
// Threads: one at a time updates a part (take_over(), fill_batch()), which writes distances of its own vertices only.
// The other functions are for the conductor, while no other thread is at work.
template <typename FT>
class alignas(64) Wavefront_part
{
public:
  using Messages = Wavefront_messages<FT>;
  using Improvement = Vertex_improvement<FT>;

  // Removes all entries of the queue, and puts the batch away. The tables are those of the last begin().
  void clear()
  {
    m_queue.clear();
    m_batch.clear();
    has_stale_windows = false;
  }

  // Begins with tables for the vertices of a mesh, whose entries are null_id and nullptr. Requires: clear() was called.
  void begin(Vertex_records<FT>& records)
  {
    m_queue.begin(records);
    m_records = &records;
    m_is_taking_over = false;
  }

  // Has an exception ended take_over()? Then the table of the best improvements must be cleared.
  bool is_taking_over() const { return m_is_taking_over; }

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
        if(best_of(i) == &i)
          improve(i, wavefront);
      for(const Queued_vertex<FT>& q : m->queued)
        push(q.vertex, q.key);
    }
    for(Messages* m : messages)
    {
      for(const Improvement& i : m->improvements)
        best_of(i) = nullptr;
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

  // Moves all vertices with keys up to a limit from the queue into the batch. Linear in the number of both. Requires:
  // the batch is empty.
  void fill_batch(const FT& limit)
  {
    CGAL_expensive_assertion(m_batch.empty());
    m_queue.move_up_to(limit, m_batch);
    m_nearest_key = m_batch.empty() ? m_queue.nearest_key() : m_batch.front().key;
    m_farthest_key = 0;
    for(const Queued_vertex<FT>& q : m_batch)
    {
      m_nearest_key = (std::min)(m_nearest_key, q.key);
      m_farthest_key = (std::max)(m_farthest_key, q.key);
    }
  }

  // The vertices to be visited. The division of the wavefront may move vertices from one batch to another.
  std::vector<Queued_vertex<FT>>& batch() { return m_batch; }
  const std::vector<Queued_vertex<FT>>& batch() const { return m_batch; }

  // Requires: the vertex belongs to this part.
  void push(Vertex_id v, const FT& key) { m_queue.push_or_decrease(v, key); }

  // The number of vertices that are queued.
  std::size_t size_of_queue() const { return m_queue.size(); }

  // As fill_batch() has found them: the smallest key of the vertices that are queued or in the batch, or infinity, and
  // the largest key of the batch, or 0.
  const FT& nearest_key() const { return m_nearest_key; }
  const FT& farthest_key() const { return m_farthest_key; }

  // An upper bound of the keys of all vertices that are queued or in the batch.
  const FT& largest_key() const { return m_queue.largest_key(); }

  bool has_stale_windows = false; // a vertex that had emitted windows was improved; the division resets it

private:
  // Keeps the best improvement of each vertex in mind.
  void consider(const Improvement& i)
  {
    const Improvement*& best = best_of(i);
    if(best == nullptr || i.wins(*best))
      best = &i;
  }

  void improve(const Improvement& i, Wavefront<FT>& wavefront)
  {
    if(wavefront.improve(i.vertex, i.distance, i.arrival, i.image, m_reached,
                         [this](Vertex_id v, const FT& key) { push(v, key); }))
      has_stale_windows = true;
  }

  const Improvement*& best_of(const Improvement& i) { return (*m_records)[i.vertex].best; }

  Threshold_queue<FT> m_queue;
  Vertex_records<FT>* m_records = nullptr;
  std::vector<Queued_vertex<FT>> m_batch;
  FT m_nearest_key = 0, m_farthest_key = 0;
  std::vector<Vertex_id> m_reached; // since the last move_reached()
  bool m_is_taking_over = false;    // outside take_over() only if an exception has ended it
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#ifdef _MSC_VER
#pragma warning(pop)
#endif

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WAVEFRONT_PART_H
