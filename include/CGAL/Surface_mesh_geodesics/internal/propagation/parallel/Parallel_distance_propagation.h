// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PARALLEL_DISTANCE_PROPAGATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PARALLEL_DISTANCE_PROPAGATION_H

// VTP by several threads from one set of sources. The thesis visits one vertex at a time; here all vertices of a batch
// are visited at the same time. Wavefront, star and visit are those of Distance_propagation.
//
// A round has two phases, whose units any thread may do (Work_sharing.h):
// 1. Parts. Each part of the wavefront takes over what the last visits have left for its vertices, and moves its
//    vertices with keys up to a threshold into the batch (Wavefront_part.h, Batch_threshold.h).
// 2. Visits. Of neighbors in the batch only the nearest one is visited; the others are queued again. A visit takes its
//    lists, propagates them and puts them back by itself: no two visits of a batch use the same list (Wavefront.h).
//    What concerns vertices is left as messages for the parts.
//
// A keeper sees the windows (Star_propagation.h). Either each thread keeps the windows of its visits, with a keeper of
// its own. Or the keeper cannot be divided; then one thread gives it the windows of the last batch while the others
// visit the next one (Window_relay.h).
//
// Each thread has a part of its own, and a region of the surface with it (Wavefront_division.h). It does the update and
// the visits of this part, and most of what these read is in its cache. A thread that has no more to do helps the
// others.
//
// The batches depend on the keys and the numbers of vertices only. So no bit of the result depends on the number of
// threads or on their speed. What no other thread can help with is little per round: the threshold, the visitor, and
// the division of a batch into units, which a keeper that needs the order of visits makes a sort.
// Rounds that are too small to share are done by the calling thread alone.
//
// What is shared. The mesh does not change. Distances change in the phase of the parts only, each by the part of its
// vertex. Each thread has windows and messages of its own (Propagation_workers.h).
//
// Exactness. Visiting a vertex that is not the nearest creates windows that would have been pruned otherwise. It
// changes no distance beyond rounding: a window is pruned only if some path is shorter, and all other windows are
// propagated in the end.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Stopping_criterion.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Batch_threshold.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Propagation_workers.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Vertex_records.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Wavefront_division.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Wavefront_part.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Window_relay.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Work_sharing.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Measures nothing: see Parallel_distance_propagation.
struct No_phase_clock
{
  void begin_phase(bool /*of_visits*/, bool /*is_worth_sharing*/) {}
  void end_unit() {}
  void end_phase() {}
};

// `Team` is a team of threads: see Worker_team.h. `Clock` is for benchmarks that run one thread: it learns when a phase
// of parts or of visits begins and ends, whether more threads would share it, and when one part or visit is done.
//
// `Keeper` is a policy: keeper.thread_keeper() makes what keeps the windows of one thread, a Thread_keeper. If
// Keeper::is_deferred is false, threads keep windows at once, and that is all. If it is true, Thread_keeper is a log
// for Window_relay; all that was logged is taken over when run() returns true.
//
// Invariants, outside run() and at the beginning of each round:
// - No star is taken out, and each list waits on a halfedge or not at all.
// - A vertex that the wavefront needs is in the queue of its part, or in a message to it.
// - The mark of a vertex has the round m_round exactly if the vertex is in the batch of the last round.
template <typename FT_, typename Rules_, typename Team, typename Keeper_ = No_window_keeper,
          typename Clock = No_phase_clock>
class Parallel_distance_propagation
{
public:
  using FT = FT_;
  using Rules = Rules_;
  using Keeper = Keeper_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // Vertices per batch while the wavefront is small.
  static constexpr std::size_t default_batch_size = 16;

  // Resets the field, which receives the result. Mesh and field must outlive this object. The result depends on the
  // smallest aim for the size of a batch within rounding. Requires: it is at least 1.
  Parallel_distance_propagation(const Mesh& mesh, Field& field, std::size_t smallest_batch_size = default_batch_size,
                                const Team& team = Team(), Keeper keeper = Keeper())
    : m_mesh(mesh), m_field(field), m_team(team), m_keeper(keeper), m_relay(keeper), m_wavefront(mesh, field),
      m_threshold(smallest_batch_size), m_maximum_distance(Field::infinity())
  {
    restart();
  }

  Parallel_distance_propagation(const Mesh& mesh, Field& field, Keeper keeper)
    : Parallel_distance_propagation(mesh, field, default_batch_size, Team(), keeper)
  {}

  Parallel_distance_propagation(const Parallel_distance_propagation&) = delete;
  Parallel_distance_propagation& operator=(const Parallel_distance_propagation&) = delete;

  // Removes the sources, distances, limits and statistics of the last run. The mesh may have changed since. Linear in
  // the area that the last run reached; linear in the mesh if an exception of a thread ended that run, or the number of
  // threads has changed. The blocks of all lists, those in stars and those that wait, go back to the pools before
  // surplus memory is freed.
  void restart()
  {
    // Workers stay when the team shrinks. Threads that join it later have none before the next restart(), so a run does
    // not use them.
    m_workers.make((std::max)(m_team.size(), std::size_t(1)), m_mesh, m_field.distance,
                   [this]() { return m_keeper.thread_keeper(); });
    m_workers.drop_stars_and_messages();
    m_division.move_reached(m_wavefront.reached()); // if the last run has not done it
    m_wavefront.restart(m_workers[0].stars.pool(), m_workers.own_slots());
    m_workers.for_each([](Worker& w) { w.stars.restart(); });
    m_relay.restart(m_workers.size(), keepers());
    m_workers.release_surplus();
    make_parts();
    m_maximum_distance = Field::infinity();
    m_maximum_windows_alive = 0;
    m_end = Stopping_criterion<FT>();
  }

  // Adds a source. Ignores a source that is not nearer to its vertex than earlier ones.
  // Requires: v is a vertex of the mesh; offset >= 0 and finite; no run since restart().
  void add_source(Vertex_id v, const FT& offset) { m_wavefront.add_source(v, offset, pusher()); }

  // Does not propagate windows beyond d. Requires: d >= 0.
  void set_maximum_distance(const FT& d)
  {
    m_maximum_distance = d;
    m_end.set_maximum_distance(d);
  }

  // Ends the run when the distances of the vertices in [first, last) are final. The range is not copied.
  void set_targets(const Vertex_id* first, const Vertex_id* last) { m_end.set_targets(first, last); }

  // Propagates until nothing waits or a limit is reached, and returns true. Calls go_on(number of visits, distance
  // reached) before each batch of visits, in the calling thread; if that returns false, stops at once and returns
  // false. Rethrows the first exception of any thread. Requires: restart() was called after a run that did not return
  // true.
  template <typename GoOn>
  bool run(GoOn go_on)
  {
    m_workers.for_each([this](Worker& w) { w.stars.set_maximum_distance(m_maximum_distance); });
    bool is_complete = false;
    std::exception_ptr failure;
    m_number_of_threads = (std::min)(m_team.size(), m_workers.size());
    m_sharing.begin(m_number_of_threads);
    m_team.run(m_number_of_threads, [&](std::size_t i)
    {
      if(i > 0)
      {
        m_sharing.help(i, [&](bool is_part, std::uint32_t unit)
        { is_part ? update_part(unit) : do_unit(m_workers[i], unit); });
        return;
      }
      try
      {
        is_complete = conduct([&]() { return go_on(m_workers.number_of_visits(), reached_distance()); });
        if(is_complete)
          m_relay.finish(reached_distance(), keepers());
      }
      catch(...)
      {
        failure = std::current_exception();
      }
      m_sharing.end();
    });
    if(failure != nullptr)
      std::rethrow_exception(failure);
    return is_complete;
  }

  // Of the last run. Requires: the team has one thread, unless the clock measures nothing.
  Clock& clock() { return m_clock; }

  // Distances up to this one are final; infinity when the propagation is complete.
  const FT& reached_distance() const { return m_end.reached_distance(); }

  Propagation_statistics statistics() const
  {
    Propagation_statistics sum = m_workers.statistics();
    sum.maximum_windows_alive = m_maximum_windows_alive;
    sum.maximum_window_bytes += m_wavefront.memory() + m_relay.memory();
    sum.intrinsic_mesh_bytes = m_wavefront.table_memory() + m_division.table_memory(); // the caller adds the rest
    return sum;
  }

private:
  using Messages = Wavefront_messages<FT>;
  using Thread_keeper = typename Keeper::Thread_keeper;
  using Workers = Propagation_workers<FT, Rules, Thread_keeper>;
  using Worker = typename Workers::Worker;

  // The visits [first, last) of the batch of a part, which one thread does one after the other.
  struct Unit
  {
    std::uint32_t part, first, last;
  };

 // --- the conductor: the calling thread ---

  // Visits batches until nothing waits or a limit is reached. Returns false as soon as go_on() does. Each turn of the
  // loop is a round. A batch is empty if the threshold is below the nearest key; then only the threshold moves. go_on()
  // is isolated, as it calls the user's visitor, which may use TBB.
  template <typename GoOn>
  bool conduct(GoOn go_on)
  {
    m_threshold.start();
    for(;;)
    {
      update_parts();
      const std::size_t front = m_division.size();
      if(front == 0)
      {
        m_division.move_reached(m_wavefront.reached());
        if(m_maximum_distance < Field::infinity() || !m_wavefront.start_beside_unreached_vertices(pusher()))
          break;
        m_end.go_back_to(m_division.nearest_queued_key());
        m_threshold.start();
        continue;
      }
      const FT nearest = m_division.nearest_key(), farthest = m_division.farthest_key();
      const std::size_t size = m_division.size_of_batch();
      const bool is_reached = m_end.is_reached_at(nearest, m_field.distance);
      if(is_reached || !m_team.isolate(go_on))
      {
        m_division.give_back_batches();
        m_division.move_reached(m_wavefront.reached());
        return is_reached;
      }
      if(size == 0)
        m_threshold.go_on_from(nearest);
      else
      {
        const std::size_t n = visit_batch(size);
        m_threshold.go_on({size, nearest, farthest, m_division.key_to_go_back_to(n), front});
        m_division.clear_batches();
      }
    }
    CGAL_assertion(m_workers.number_of_windows() == 0);
    m_end.set_complete();
    return true;
  }

  // Phase 1. The last batch tells how much there is to do.
  void update_parts()
  {
    begin_round();
    m_ends.assign(m_number_of_threads, 0);
    const std::size_t parts = m_division.number_of_parts();
    for(std::size_t t = 0; t < m_number_of_threads; ++t)
      m_ends[t] = static_cast<std::uint32_t>((t + 1) * parts / m_number_of_threads);
    share(true, m_size_of_batch >= smallest_shared_update, [this](std::uint32_t i) { update_part(i); });
    if(m_division.forget_stale_windows())
      m_wavefront.expect_stale_windows(m_division.largest_key());
  }

  // Marks of earlier rounds become void. (If the number of the round overflows, they are removed.)
  void begin_round()
  {
    if(m_round == (std::numeric_limits<std::uint32_t>::max)())
    {
      m_division.records().clear_marks();
      m_round = 0;
    }
    ++m_round;
  }

  // Phase 2. Returns how many vertices were visited. A keeper that depends on the order of visits gets them in the
  // order of their keys.
  std::size_t visit_batch(std::size_t n)
  {
    m_size_of_batch = n;
    const std::size_t visits_before = m_workers.number_of_visits();
    const bool is_worth_it = n >= smallest_shared_batch;
    if(Keeper::is_deferred)
      m_division.sort_batches();
    else if(is_worth_it && m_number_of_shared_batches++ % batches_per_balance == 0)
      m_division.balance();
    make_units(n);
    m_relay.begin_batch(m_units.size(), keepers());
    for(std::uint32_t& end : m_ends)
      end += static_cast<std::uint32_t>(m_relay.number_of_own_units());
    share(false, n + m_relay.number_of_own_units() >= smallest_shared_batch,
          [this](std::uint32_t i) { do_unit(m_workers[0], i); });
    m_maximum_windows_alive = (std::max)(m_maximum_windows_alive, m_workers.number_of_windows());
    m_workers.for_each([this](Worker& w) { m_wavefront.lists().share_surplus(w.own_slots); });
    return m_workers.number_of_visits() - visits_before;
  }

  // Divides the batches of all parts, n vertices, into units. Each thread gets those of its parts.
  void make_units(std::size_t n)
  {
    std::size_t size = visits_per_unit(n, m_number_of_threads);
    while(n / size + m_division.number_of_parts() + m_relay.maximum_number_of_own_units
          >= Work_sharing::maximum_number_of_units)
      size *= 2;
    m_units.clear();
    for(std::size_t i = 0, t = 0; i < m_division.number_of_parts(); ++i)
    {
      const std::size_t end = m_division.part(i).batch().size();
      for(std::size_t first = 0; first < end; first += size)
        m_units.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(first),
                           static_cast<std::uint32_t>((std::min)(first + size, end))});
      while(t < m_number_of_threads && (t + 1) * m_division.number_of_parts() / m_number_of_threads <= i + 1)
        m_ends[t++] = static_cast<std::uint32_t>(m_units.size());
    }
  }

  // Does the units of a phase, with the other threads if that is worth it. Those of thread t end before m_ends[t].
  template <typename Work>
  void share(bool is_part, bool is_worth_it, Work work)
  {
    m_clock.begin_phase(!is_part, is_worth_it);
    m_is_shared = is_worth_it && m_ends.back() > 1 && m_number_of_threads > 1;
    if(m_is_shared)
      m_sharing.share(is_part, m_ends, work);
    else
      for(std::uint32_t i = 0; i < m_ends.back(); ++i)
        work(i);
    m_clock.end_phase();
  }

  // --- any thread ---

  // Brings a part up to date, and marks the vertices of its batch. Other threads update other parts at the same time;
  // distances and marks of different parts are different numbers in memory.
  void update_part(std::size_t i)
  {
    Wavefront_part<FT>& part = m_division.part(i);
    part.take_over(m_messages_of_part[i], m_wavefront);
    part.fill_batch((std::min)(m_threshold.limit(), m_maximum_distance));
    for(const Queued_vertex<FT>& q : part.batch())
      m_division.records()[q.vertex].mark = Batch_mark{m_round, static_cast<float>(q.key)};
    m_clock.end_unit();
  }

  // Does a unit of phase 2, visits or a unit of the relay, with the worker of the thread that runs.
  void do_unit(Worker& worker, std::size_t unit)
  {
    m_relay.do_unit(unit, worker.number, worker.stars.keeper(), reached_distance(),
                    [&](std::size_t i) { visit_unit(worker, i); });
  }

  // Visits some vertices of the batch, one after the other.
  void visit_unit(Worker& worker, std::size_t unit)
  {
    const Unit u = m_units[unit];
    const std::vector<Queued_vertex<FT>>& batch = m_division.part(u.part).batch();
    for(std::size_t i = u.first; i < u.last; ++i)
    {
      const Vertex_id next = batch[i + 1 < u.last ? i + 1 : i].vertex;
      m_mesh.prefetch_star(next);
      visit(worker, batch[i], next);
      prefetch_records_around(next);
      m_clock.end_unit();
    }
  }

  // Asks for what is_nearest_of_links() reads, unless that is more than a cache holds.
  void prefetch_records_around(Vertex_id v) const
  {
    if(m_mesh.has_small_star(v))
      for(const Halfedge_id* h = m_mesh.star_begin(v); h != m_mesh.star_end(v); ++h)
        prefetch(&m_division.records()[m_mesh.target(*h)]);
  }

  // Visits a vertex of the batch, or queues it again. Lists are put back at once, and improvements become messages: see
  // Wavefront.h about what visits may do at the same time. `next` is visited next; its faces are requested meanwhile.
  void visit(Worker& worker, const Queued_vertex<FT>& q, Vertex_id next)
  {
    const std::size_t part = m_division.part_of(q.vertex, 0);
    if(is_known_to_wait(q.vertex))
      return push(q.vertex, q.key, part, worker);
    worker.star.surround(m_mesh, q.vertex);
    if(!is_nearest_of_links(worker.star))
      return push(q.vertex, q.key, part, worker);
    m_wavefront.take(worker.star, q.key, worker.own_slots);
    worker.stars.propagate(worker.star);
    m_mesh.prefetch_faces_of_star(next);
    m_wavefront.for_each_improved_link(worker.star, [&](const Link_vertex<FT>& link)
    {
      worker.messages[m_division.part_of(link.vertex, part)].improvements.push_back(
        {link.vertex, q.vertex, link.distance, link.arrival, link.image});
    });
    m_wavefront.put_lists(worker.star, worker.stars.pool(), worker.own_slots,
                          [&](Vertex_id v, const FT& key) { push(v, key, part, worker); });
  }

  // Is the vertex of a star nearer than all its neighbors in the batch, or as near and first of a tie? Then no neighbor
  // is visited. (All marks are read, without a branch: each is a different place in memory, and the processor asks for
  // all of them at once.) Requires: star.surround() was called.
  bool is_nearest_of_links(const Vertex_star<FT>& star) const
  {
    bool is_nearest = true;
    for(const Link_vertex<FT>& link : star.links)
    {
      const bool is_nearer = is_before(link.vertex, star.vertex);
      is_nearest = is_nearest && !(m_division.records()[link.vertex].mark.round == m_round && is_nearer);
    }
    return is_nearest;
  }

  // The same, asked before the star is surrounded. A vertex with thousands of links may have to wait for many of them,
  // one in each round: on a fan, those of the rim leave one after the other. To look at all links in each round would
  // take time quadratic in their number, so the batch is searched for links if it is the smaller one. Returns false if
  // it is not known.
  bool is_known_to_wait(Vertex_id v) const
  {
    if(m_mesh.has_small_star(v) || m_mesh.size_of_star(v) <= 8 * m_size_of_batch)
      return false;
    const auto has_nearer_link = [&](const std::vector<Queued_vertex<FT>>& batch)
    {
      return std::any_of(batch.begin(), batch.end(), [&](const Queued_vertex<FT>& q)
      { return is_before(q.vertex, v) && is_link(v, q.vertex); });
    };
    for(std::size_t i = 0; i < m_division.number_of_parts(); ++i)
      if(has_nearer_link(m_division.part(i).batch()))
        return true;
    return false;
  }

  // Is u visited before v, if both are in the batch and links of each other? The nearer one is, of a tie the first one.
  bool is_before(Vertex_id u, Vertex_id v) const
  {
    const Batch_mark &a = m_division.records()[u].mark, &b = m_division.records()[v].mark;
    const std::uint32_t factor = m_threshold.factor_of_ties();
    return a.key < b.key || (!(b.key < a.key) && factor * u < factor * v);
  }

  // Is v a link of u? False if u has many links, too, or no star in the table of stars: then it is not known.
  bool is_link(Vertex_id v, Vertex_id u) const
  {
    const auto leads_to_v = [&](Halfedge_id h)
    { return m_mesh.target(h) == v || m_mesh.source(previous_halfedge(h)) == v; };
    return m_mesh.has_small_star(u) && std::any_of(m_mesh.star_begin(u), m_mesh.star_end(u), leads_to_v);
  }

  // Queues a vertex that a visit in a part has met: at once if no other thread is at work, else by a message. The next
  // batch is the same.
  void push(Vertex_id v, const FT& key, std::size_t part, Worker& worker)
  {
    if(m_is_shared)
      worker.messages[m_division.part_of(v, part)].queued.push_back({key, v});
    else
      m_division.push(v, key, part);
  }

  // --- preparation ---

  // Empties the parts, one for each worker.
  void make_parts()
  {
    const std::size_t n = (std::min)(m_workers.size(), m_division.maximum_number_of_parts);
    m_division.restart(n, m_mesh.number_of_vertices());
    m_messages_of_part.assign(n, {});
    m_workers.for_each([&](Worker& w)
    {
      w.messages.resize(n);
      for(std::size_t i = 0; i < n; ++i)
        m_messages_of_part[i].push_back(&w.messages[i]);
    });
    m_size_of_batch = 0;
    m_number_of_shared_batches = 0;
  }

  // The keeper of each thread.
  auto keepers()
  {
    return [this](std::size_t thread) -> Thread_keeper& { return m_workers[thread].stars.keeper(); };
  }

  auto pusher()
  {
    return [this](Vertex_id v, const FT& key) { m_division.push(v, key); };
  }

  // Regions drift apart slowly. Until they are balanced again, threads help each other.
  static constexpr std::size_t batches_per_balance = 8;

  static constexpr std::size_t smallest_shared_update = 16; // visits that have left messages
  static constexpr std::size_t smallest_shared_batch = 6;   // visits

  const Mesh& m_mesh;
  Field& m_field;
  Team m_team;
  Keeper m_keeper;
  Window_relay<Keeper> m_relay;
  Wavefront<FT> m_wavefront;
  Workers m_workers; // the first one is the conductor's
  Wavefront_division<FT> m_division;
  std::vector<std::vector<Messages*>> m_messages_of_part; // those of all workers, by part
  std::uint32_t m_round = 0;
  std::size_t m_number_of_threads = 1;            // of the run
  std::size_t m_size_of_batch = 0; // of the last one, or of that which is visited
  std::size_t m_number_of_shared_batches = 0;     // of the run
  std::vector<Unit> m_units;                      // of the visits
  std::vector<std::uint32_t> m_ends;              // of the units of the phase, by thread
  bool m_is_shared = false; // do other threads take part in the phase?
  Batch_threshold<FT> m_threshold;
  Work_sharing m_sharing;
  Clock m_clock;
  Stopping_criterion<FT> m_end;
  FT m_maximum_distance;
  std::size_t m_maximum_windows_alive = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PARALLEL_DISTANCE_PROPAGATION_H
