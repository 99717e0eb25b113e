// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WINDOW_RELAY_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WINDOW_RELAY_H

// Passes the windows that several threads propagate to one keeper, which only one thread may call at a time.
//
// Each thread logs the windows of its visits. While the next batch is visited, one thread gives the logs to the keeper,
// in the order of the visits in their batch, and tells it the distance that is reached now. So the keeper sees the same
// calls for any number of threads, and taking windows over is one more unit beside the visits. The keeper may read what
// does not change during visits: the mesh and the field of distances.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// What the visits of a batch need to keep windows. `Keeper` is a policy: see Parallel_distance_propagation. Where a
// function has a parameter `keepers`, keepers(i) is the Thread_keeper of thread i.
//
// If the keeper is deferred, its Thread_keeper is a log: position() is the end of the log, swap() and clear() are those
// of a container. keeper.take_over(log, first, last, reached) takes the lists between two positions; distances up to
// `reached` are final. It may have units of its own in each batch: keeper.begin_batch() returns their number, at most a
// thousand, and keeper.do_unit(i, thread) does one of them, in any thread and beside everything else. In each batch
// that follows visits, keeper.advance() is called once. The units of the last batch, which finish() begins, are not
// done: the owner of such a keeper does what is left, and calls restart() before the next run.
//
// Invariant, when a batch begins: m_last_spans tells where in m_last_logs the windows of the batch before are, which
// the keeper has not seen.
//
// There are two logs for each thread, which change places in begin_batch(): the thread writes one of them while the
// keeper reads the other. Threads: the conductor calls all functions but do_unit(), while no unit is being done.
template <typename Keeper, bool is_deferred = Keeper::is_deferred>
class Window_relay
{
public:
  using Log = typename Keeper::Thread_keeper;

  explicit Window_relay(Keeper keeper) : m_keeper(keeper) {}

  // Forgets all windows, for a run with this number of threads.
  template <typename Keepers>
  void restart(std::size_t number_of_threads, Keepers keepers)
  {
    m_spans.clear();
    m_last_spans.clear();
    m_keeper.restart(number_of_threads);
    while(m_last_logs.size() < number_of_threads)
      m_last_logs.push_back(m_keeper.thread_keeper());
    for(std::size_t i = 0; i < number_of_threads; ++i)
    {
      m_last_logs[i].clear();
      keepers(i).clear();
    }
  }

  // Begins a batch with this number of units of visits. The relay may add units of its own. The logs of the last batch
  // come here; the threads go on with those of the batch before it, emptied. Takes time linear in the numbers of units
  // and of threads.
  template <typename Keepers>
  void begin_batch(std::size_t number_of_visit_units, Keepers keepers)
  {
    for(std::size_t i = 0; i < m_last_logs.size(); ++i)
    {
      m_last_logs[i].swap(keepers(i));
      keepers(i).clear();
    }
    m_last_spans.swap(m_spans);
    m_spans.assign(number_of_visit_units, Span());
    m_takes_over = m_last_spans.empty() ? 0 : 1;
    m_number_of_own_units = m_takes_over + m_keeper.begin_batch();
  }

  // The units that are not visits. If the keeper has to take over windows during the batch, that unit comes first, as
  // it may take longest.
  std::size_t number_of_own_units() const { return m_number_of_own_units; }
  static constexpr std::size_t maximum_number_of_own_units = 1001;

  // In any thread: does a unit of a batch, with the keeper of that thread. visit(i) does unit i of the visits. Each
  // unit notes its part of the log in a span of its own: it may be done by any thread, after any others.
  // Requires: all windows of paths that are shorter than `reached` were propagated before this batch.
  template <typename FT, typename Visit>
  void do_unit(std::size_t unit, std::size_t thread, const Log& log, const FT& reached, Visit visit)
  {
    if(unit < m_takes_over)
    {
      take_over(reached); // first: the keeper may act on a distance only when it has the windows of shorter paths
      m_keeper.advance(reached);
      return;
    }
    if(unit < m_number_of_own_units)
    {
      m_keeper.do_unit(unit - m_takes_over, thread);
      return;
    }
    const std::size_t i = unit - m_number_of_own_units;
    m_spans[i].thread = static_cast<std::uint32_t>(thread);
    m_spans[i].first = log.position();
    visit(i);
    m_spans[i].last = log.position();
  }

  // Gives the keeper the windows of the last batch of a run that has reached a distance. As no unit follows that could
  // do this, the conductor does it alone.
  template <typename FT, typename Keepers>
  void finish(const FT& reached, Keepers keepers)
  {
    begin_batch(0, keepers);
    take_over(reached);
  }

  std::size_t memory() const
  {
    std::size_t n = m_keeper.memory() + (m_spans.capacity() + m_last_spans.capacity()) * sizeof(Span);
    for(const Log& log : m_last_logs)
      n += 2 * log.memory(); // the log that the thread writes is about as large
    return n;
  }

private:
  // The windows of one unit: those between two positions of the log of a thread. Spans are in the order of the visits,
  // whatever thread has made them when; this order is what the keeper sees.
  struct Span
  {
    typename Log::Position first, last;
    std::uint32_t thread = 0;
  };

  template <typename FT>
  void take_over(const FT& reached)
  {
    for(const Span& span : m_last_spans)
      m_keeper.take_over(m_last_logs[span.thread], span.first, span.last, reached);
  }

  Keeper m_keeper;
  std::vector<Log> m_last_logs; // by thread
  std::vector<Span> m_spans, m_last_spans; // by unit of visits
  std::size_t m_takes_over = 0; // 1 or 0: the number of units in which the keeper takes over windows
  std::size_t m_number_of_own_units = 0;
};

// There is nothing to relay if threads keep windows at once: no logs, no unit of its own, no memory.
template <typename Keeper>
class Window_relay<Keeper, false>
{
public:
  explicit Window_relay(const Keeper&) {}

  template <typename Keepers>
  void restart(std::size_t, Keepers) const
  {}

  template <typename Keepers>
  void begin_batch(std::size_t, Keepers) const
  {}

  static constexpr std::size_t number_of_own_units() { return 0; }
  static constexpr std::size_t maximum_number_of_own_units = 0;

  template <typename FT, typename Visit>
  void do_unit(std::size_t unit, std::size_t, const typename Keeper::Thread_keeper&, const FT&, Visit visit) const
  {
    visit(unit);
  }

  template <typename FT, typename Keepers>
  void finish(const FT&, Keepers) const
  {}

  static constexpr std::size_t memory() { return 0; }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_WINDOW_RELAY_H
