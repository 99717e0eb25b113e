// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_DISTANCE_PROPAGATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_DISTANCE_PROPAGATION_H

// VTP by several threads from one set of sources. Up to K vertices are visited at the same time. The thesis is
// sequential; wavefront, star and visit are those of Distance_propagation.
//
// What can be visited at the same time. A visit reads and writes its star only (Vertex_star.h): the lists that enter
// the faces around the vertex, and copies of the distances of its neighbors. Stars of vertices that are not neighbors
// have no list in common, though they may share vertices and edges.
//
// Order. One thread, the conductor, takes stars out of the wavefront and puts them back, strictly in turn: it takes
// star i + K right after it has put star i back. It takes the nearest vertex whose neighbors' stars are all in the
// wavefront; a vertex next to a star that is out is deferred until that star is back. So the contents of a star, and
// with them every bit of the result, depend on K but neither on the number of threads nor on their speed. With K = 1
// they are those of Distance_propagation. In between, any thread propagates any star, and the conductor does so instead
// of waiting: there is no barrier, and progress does not rely on other threads.
//
// What is shared. The mesh does not change. Each thread allocates windows from its own pool and returns blocks to its
// own pool, whoever allocated them. Only the conductor writes distances. Other threads read the distances of
// pseudo-sources that have emitted windows; before one of these shrinks, which is rare, the conductor waits until all
// stars that are out have been propagated.
//
// Exactness. Visiting a vertex that is not the nearest creates windows that would have been pruned otherwise. It
// changes no distance beyond rounding: a window is pruned only if some path is shorter, and all other windows are
// propagated in the end.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Star_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Stopping_criterion.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Waits for another thread: spins at first, then gives the processor away.
class Spin_wait
{
public:
  void wait()
  {
    if(++m_count < 1024)
    {
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
      __builtin_ia32_pause();
#endif
    }
    else
      std::this_thread::yield();
  }

  void reset() { m_count = 0; }

private:
  unsigned int m_count = 0;
};

// `Team` is a team of threads: see Worker_team.h.
//
// Visits are numbered across all runs. Invariants, in the conductor's thread:
// - The stars of the visits [m_first, m_last) are out; m_last - m_first <= K. Visit i uses the slot i % K.
// - m_first <= m_last == m_published and m_claimed <= m_published; visits below m_claimed are propagated or under way.
// - No two stars that are out belong to neighbors.
// - A vertex that the wavefront needs is in the queue, or in the `deferred` list of a star that is out.
// Outside run(), no thread works; stars are out only if the last run was interrupted.
template <typename FT_, typename Rules_, typename Team>
class Parallel_distance_propagation
{
public:
  using FT = FT_;
  using Rules = Rules_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // Few enough that the stars that are out fit into the nearest cache; more than the threads that one conductor can
  // keep busy.
  static constexpr std::size_t default_number_of_stars = 8;

  // Resets the field, which receives the result. Mesh and field must outlive this object.
  // Requires: number_of_stars, the K above, is at least 1.
  Parallel_distance_propagation(const Mesh& mesh, Field& field,
                                std::size_t number_of_stars = default_number_of_stars, const Team& team = Team())
    : m_mesh(mesh), m_field(field), m_team(team), m_wavefront(mesh, field), m_flights(number_of_stars),
      m_last_visit_near(mesh.number_of_vertices(), 0), m_maximum_distance(Field::infinity())
  {
    CGAL_assertion(number_of_stars > 0);
    m_workers.push_back(std::make_unique<Worker>(mesh, field.distance));
  }

  Parallel_distance_propagation(const Parallel_distance_propagation&) = delete;
  Parallel_distance_propagation& operator=(const Parallel_distance_propagation&) = delete;

  // Removes the sources, distances, limits and statistics of the last run, and stars that an interrupted run has left.
  // The mesh may have changed since. Linear in the area that the last run reached.
  void restart()
  {
    for(; m_first != m_last; ++m_first)
      abandon(flight(m_first));
    m_begin = m_published = m_claimed = m_last; // numbers are unique: m_last_visit_near stays valid
    m_wavefront.restart(m_workers.front()->pool());
    for(const std::unique_ptr<Worker>& worker : m_workers)
      worker->restart();
    release_surplus();
    m_last_visit_near.resize(m_mesh.number_of_vertices(), 0);
    m_maximum_distance = Field::infinity();
    m_end = Stopping_criterion<FT>();
  }

  // Adds a source. Ignores a source that is not nearer to its vertex than earlier ones.
  // Requires: v is a vertex of the mesh; offset >= 0 and finite; no run since restart().
  void add_source(Vertex_id v, const FT& offset) { m_wavefront.add_source(v, offset); }

  // Does not propagate windows beyond d. Requires: d >= 0.
  void set_maximum_distance(const FT& d)
  {
    m_maximum_distance = d;
    m_end.set_maximum_distance(d);
  }

  // Ends the run when the distances of the vertices in [first, last) are final. The range is not copied.
  void set_targets(const Vertex_id* first, const Vertex_id* last) { m_end.set_targets(first, last); }

  // Propagates until nothing waits or a limit is reached, and returns true. Calls go_on(number of visits, distance
  // reached) every few visits, in the calling thread; if that returns false, stops at once and returns false.
  // Rethrows the first exception of any thread. Requires: restart() was called after a run that was interrupted.
  template <typename GoOn>
  bool run(GoOn go_on)
  {
    const std::size_t number_of_threads = (std::min)(m_team.size(), m_flights.size());
    while(m_workers.size() < number_of_threads)
      m_workers.push_back(std::make_unique<Worker>(m_mesh, m_field.distance));
    for(const std::unique_ptr<Worker>& worker : m_workers)
      worker->set_maximum_distance(m_maximum_distance);
    m_is_over = false;
    m_has_failed = false;
    bool is_complete = false;
    m_team.run(number_of_threads, [&](std::size_t i)
    {
      try
      {
        if(i > 0)
          help(*m_workers[i]);
        else
          is_complete
            = conduct([&]() { return go_on(static_cast<std::size_t>(m_first - m_begin), reached_distance()); });
      }
      catch(...)
      {
        fail();
      }
      if(i == 0)
        m_is_over = true;
    });
    if(m_failure != nullptr)
    {
      const std::exception_ptr failure = m_failure;
      m_failure = nullptr;
      std::rethrow_exception(failure);
    }
    return is_complete;
  }

  // Distances up to this one are final; infinity when the propagation is complete.
  const FT& reached_distance() const { return m_end.reached_distance(); }

  Propagation_statistics statistics() const
  {
    Propagation_statistics sum;
    for(const std::unique_ptr<Worker>& worker : m_workers)
    {
      sum.add(worker->statistics());
      sum.maximum_window_bytes += worker->memory();
    }
    sum.maximum_windows_alive = m_wavefront.maximum_windows_alive();
    sum.maximum_window_bytes += m_wavefront.memory();
    sum.intrinsic_mesh_bytes = m_wavefront.table_memory(); // the caller adds the mesh and the results
    return sum;
  }

private:
  using Worker = Star_propagation<FT, Rules>;
  using Number = std::uint64_t; // of a visit, counted over all runs

  // Thrown in the conductor's thread when another thread has failed.
  struct Interruption
  {};

  // A star that has been taken out of the wavefront.
  struct alignas(64) Flight
  {
    Vertex_star<FT> star;
    FT key;                                         // that its vertex had in the queue
    std::vector<std::pair<FT, Vertex_id>> deferred; // neighbors that wait for its return, with their keys
    std::atomic<Number> done{0};                    // 1 + the number of the last visit that is done in this slot
  };

  Flight& flight(Number i) { return m_flights[i % m_flights.size()]; }

  // Takes stars out and puts them back until nothing waits or a limit is reached. Returns false as soon as go_on()
  // does.
  template <typename GoOn>
  bool conduct(GoOn go_on)
  {
    for(;;)
    {
      while(m_last - m_first < m_flights.size() && take_out(m_last))
      {
        ++m_last;
        m_published.store(m_last, std::memory_order_release);
      }
      if(m_first == m_last)
      {
        if(m_maximum_distance < Field::infinity() || !m_wavefront.start_beside_unreached_vertices())
          break;
        m_end.go_back_to(m_wavefront.queue().top_key());
        continue;
      }
      if((m_first - m_begin) % visits_between_checks == 0)
      {
        if(m_end.is_reached_at(nearest_key(), m_field.distance))
          return true;
        if(!m_team.isolate(go_on))
          return false;
      }
      put_back(m_first);
      ++m_first;
    }
    CGAL_assertion(m_wavefront.empty());
    m_end.set_complete();
    return true;
  }

  // Takes out the star of the nearest vertex that is not next to a star that is out, as visit i, and defers those that
  // are. Returns false if there is none. Requires: the slot of visit i is free.
  bool take_out(Number i)
  {
    Wavefront_queue<FT>& queue = m_wavefront.queue();
    while(!queue.empty())
    {
      const Vertex_id v = queue.top();
      const FT key = queue.top_key();
      queue.pop();
      const Number last = m_last_visit_near[v];
      if(last > m_first) // visits end in ascending order: if the last one near v has ended, all have
      {
        flight(last - 1).deferred.emplace_back(key, v);
        continue;
      }
      Flight& f = flight(i);
      f.key = key;
      f.star.surround(m_mesh, v);
      CGAL_expensive_assertion(is_apart_from_stars_out(f.star));
      m_wavefront.take(f.star);
      m_last_visit_near[v] = i + 1;
      for(const Link_vertex<FT>& link : f.star.links)
        m_last_visit_near[link.vertex] = i + 1;
      return true;
    }
    return false;
  }

  // Puts the star of visit i back, once it has been propagated. Other threads read the distances of vertices that have
  // emitted windows: they must be at rest before one of these changes.
  void put_back(Number i)
  {
    Flight& f = flight(i);
    wait_for(i);
    if(m_wavefront.makes_windows_stale(f.star))
      for(Number j = i + 1; j < m_last; ++j)
        wait_for(j);
    m_wavefront.put_back(f.star, m_workers.front()->pool());
    release(f);
  }

  // Queues again the neighbors of a star that is back.
  void release(Flight& f)
  {
    for(const auto& neighbor : f.deferred)
      m_wavefront.queue().push_or_decrease(neighbor.second, neighbor.first);
    f.deferred.clear();
  }

  // Drops the windows of a star that an interrupted run has left.
  void abandon(Flight& f)
  {
    for(Star_face<FT>& face : f.star.faces)
      for(Window_list<FT>* list : {&face.counterclockwise, &face.clockwise, &face.outward})
        m_workers.front()->pool().release(*list);
    release(f);
  }

  // Frees the memory of all pools when it exceeds twice that of the first run, plus a constant. Blocks of windows
  // migrate between pools: some pools gain blocks in each run, and the others would allocate new ones without end.
  // Requires: no block is in use.
  void release_surplus()
  {
    std::size_t memory = 0;
    for(const std::unique_ptr<Worker>& worker : m_workers)
      memory += worker->memory();
    if(m_memory_of_run == 0)
      m_memory_of_run = memory;
    if(memory <= 2 * m_memory_of_run + least_surplus)
      return;
    for(const std::unique_ptr<Worker>& worker : m_workers)
      worker->pool().clear();
    m_memory_of_run = 0;
  }

  // Propagates stars until visit i is done. Throws Interruption if another thread has failed.
  void wait_for(Number i)
  {
    Spin_wait spin;
    while(flight(i).done.load(std::memory_order_acquire) != i + 1)
    {
      if(m_has_failed.load(std::memory_order_relaxed))
        throw Interruption();
      if(!work(*m_workers.front()))
        spin.wait();
    }
  }

  // The smallest key of a vertex that must be visited or whose star is out: what waits is not nearer.
  FT nearest_key()
  {
    FT key = m_wavefront.queue().empty() ? Field::infinity() : m_wavefront.queue().top_key();
    for(Number i = m_first; i < m_last; ++i)
    {
      key = (std::min)(key, flight(i).key);
      for(const auto& neighbor : flight(i).deferred)
        key = (std::min)(key, neighbor.first);
    }
    return key;
  }

  // The loop of a thread other than the conductor's: propagates stars until the run is over.
  void help(Worker& worker)
  {
    Spin_wait spin;
    while(!m_is_over.load(std::memory_order_relaxed))
      if(work(worker))
        spin.reset();
      else
        spin.wait();
  }

  // Keeps the exception that is being handled, if it is the first one of the run.
  void fail()
  {
    if(!m_has_failed.exchange(true))
      m_failure = std::current_exception();
  }

  // Claims and propagates one star. Returns false if all stars that are out are claimed.
  bool work(Worker& worker)
  {
    Number i = m_claimed.load(std::memory_order_relaxed);
    do
    {
      if(i >= m_published.load(std::memory_order_acquire))
        return false;
    } while(!m_claimed.compare_exchange_weak(i, i + 1, std::memory_order_relaxed));
    Flight& f = flight(i);
    worker.propagate(f.star);
    f.done.store(i + 1, std::memory_order_release);
    return true;
  }

  // Is a star free of vertices whose stars are out?
  bool is_apart_from_stars_out(const Vertex_star<FT>& star)
  {
    for(Number i = m_first; i < m_last; ++i)
    {
      const Vertex_id v = flight(i).star.vertex;
      if(v == star.vertex || std::any_of(star.links.begin(), star.links.end(),
                                         [v](const Link_vertex<FT>& link) { return link.vertex == v; }))
        return false;
    }
    return true;
  }

  static constexpr Number visits_between_checks = 16; // of the stopping criterion and of go_on()
  static constexpr std::size_t least_surplus = std::size_t(1) << 18; // bytes

  const Mesh& m_mesh;
  Field& m_field;
  Team m_team;
  Wavefront<FT> m_wavefront;
  std::vector<std::unique_ptr<Worker>> m_workers; // the first one is the conductor's
  std::vector<Flight> m_flights;                  // K slots
  // For each vertex, 1 + the number of the last visit of the vertex or of a neighbor. The star of that visit is out if
  // this is greater than m_first.
  std::vector<Number> m_last_visit_near;
  Stopping_criterion<FT> m_end;
  FT m_maximum_distance;
  std::size_t m_memory_of_run = 0; // bytes of the pools after the first run since they were last cleared; 0: unknown
  Number m_first = 0, m_last = 0;  // the stars of the visits [m_first, m_last) are out
  Number m_begin = 0;              // first visit of this run
  // On cache lines of their own: threads poll them.
  alignas(64) std::atomic<Number> m_published{0};
  alignas(64) std::atomic<Number> m_claimed{0};
  alignas(64) std::atomic<bool> m_is_over{false};
  std::atomic<bool> m_has_failed{false};
  std::exception_ptr m_failure;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_DISTANCE_PROPAGATION_H
