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

// VTP by several threads from one set of sources. Up to K vertices are visited at the same time.
//
// What can be visited at the same time. A visit reads and writes its star only (Vertex_star.h): the lists that enter
// the faces around the vertex, and copies of the distances of its neighbours. Stars of vertices that are
// not neighbours have no list in common, though they may share vertices and edges.
//
// Order. One thread, the conductor, takes stars out of the wavefront and puts them back, strictly in turn: star
// i + K is taken out just after star i has been put back. It takes the nearest vertex that is not next to a
// vertex whose star is out; those that are have to wait until that star is back. So what is in a star when it is
// taken out, and with it every bit of the result, depends on K but not on the number of threads or on their
// speed; with K = 1 it is that of Distance_propagation. In between, any thread carries windows through any
// star, the conductor too when it would have to wait: there is no barrier, and progress does not rely on other
// threads.
//
// What is shared. The mesh does not change. A thread allocates windows from a pool of its own, and gives blocks
// back to its own pool, whoever made them. Distances are written by the conductor only. Other threads
// read those of pseudo-sources from which windows have started; before one of these shrinks, which is rare, the
// conductor waits until all stars that are out have been worked on.
//
// Exactness. Visiting vertices that are not the nearest costs windows, which would have been pruned later,
// but no digit: what is pruned is longer than some path, and whatever waits is propagated in the end.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Stopping_criterion.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Star_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront.h>

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

// A thread waits for another one, at first without giving its processor away.
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

// `Team` is a team of threads, as in Worker_team.h.
template <typename FT_, typename Rules_, typename Team>
class Parallel_distance_propagation
{
public:
  using FT = FT_;
  using Rules = Rules_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // Few enough that what is out stays in the nearest cache, and more than the threads that one conductor can keep busy.
  static constexpr std::size_t default_number_of_stars = 8;

  // The field is reset; it holds the result.
  Parallel_distance_propagation(const Mesh& mesh, Field& field,
                                std::size_t number_of_stars = default_number_of_stars, const Team& team = Team())
    : m_mesh(mesh), m_field(field), m_team(team), m_wavefront(mesh, field), m_flights(number_of_stars),
      m_last_visit_near(mesh.number_of_vertices(), 0), m_maximum_distance(Field::infinity())
  {
    m_workers.push_back(std::make_unique<Worker>(mesh, field.distance));
  }

  Parallel_distance_propagation(const Parallel_distance_propagation&) = delete;
  Parallel_distance_propagation& operator=(const Parallel_distance_propagation&) = delete;

  // forgets the last run: its sources, distances, targets and statistics. The mesh may have been changed.
  void restart()
  {
    for(; m_first != m_last; ++m_first)
      abandon(flight(m_first));
    m_begin = m_published = m_claimed = m_last; // numbers are not used again: those of vertices need not be cleared
    m_wavefront.restart(m_workers.front()->pool());
    for(const std::unique_ptr<Worker>& worker : m_workers)
      worker->restart();
    release_surplus();
    m_last_visit_near.resize(m_mesh.number_of_vertices(), 0);
    m_maximum_distance = Field::infinity();
    m_end = Stopping_criterion<FT>();
  }

  // adds a source; one that is not nearer to its vertex than those before is ignored.
  void add_source(Vertex_id v, const FT& offset) { m_wavefront.add_source(v, offset); }

  // Windows that begin farther away are not propagated.
  void set_maximum_distance(const FT& d)
  {
    m_maximum_distance = d;
    m_end.set_maximum_distance(d);
  }

  // The run ends when the distances of all these vertices are final. They are not copied.
  void set_targets(const Vertex_id* first, const Vertex_id* last) { m_end.set_targets(first, last); }

  // propagates until nothing waits. Calls go_on(number of visits, distance reached) from time to time, in the
  // calling thread, and returns false as soon as that does.
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

  // Distances up to this one are final.
  const FT& reached_distance() const { return m_end.reached_distance(); }

  Propagation_statistics statistics() const
  {
    Propagation_statistics sum;
    for(const std::unique_ptr<Worker>& worker : m_workers)
    {
      add_statistics(worker->statistics(), sum);
      sum.maximum_window_bytes += worker->memory();
    }
    sum.maximum_windows_alive = m_wavefront.maximum_windows_alive();
    sum.maximum_window_bytes += m_wavefront.memory();
    sum.intrinsic_mesh_bytes = m_wavefront.table_memory(); // those of the mesh and of the results are added elsewhere
    return sum;
  }

private:
  using Worker = Star_propagation<FT, Rules>;
  using Number = std::uint64_t; // of a visit, from the first one of all runs on

  // Ends the work of the conductor when another thread has failed.
  struct Interruption
  {};

  // A star that has been taken out of the wavefront.
  struct alignas(64) Flight
  {
    Vertex_star<FT> star;
    FT key;                                         // in the queue
    std::vector<std::pair<FT, Vertex_id>> deferred; // neighbours that wait for it, with their keys
    std::atomic<Number> done{0};                    // the number of the visit plus 1, when it is done
  };

  Flight& flight(Number i) { return m_flights[i % m_flights.size()]; }

  // takes stars out and puts them back until nothing waits; returns false if go_on() does.
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
    m_end.set_complete();
    return true;
  }

  // takes the star of the nearest vertex out that is not next to one whose star is out, as visit i. Returns false if
  // there is none.
  bool take_out(Number i)
  {
    Vertex_front_queue<FT>& queue = m_wavefront.queue();
    while(!queue.empty())
    {
      const Vertex_id v = queue.top();
      const FT key = queue.top_key();
      queue.pop();
      const Number last = m_last_visit_near[v];
      if(last > m_first) // visits end in their order: if this one has ended, all near to v have
      {
        flight(last - 1).deferred.emplace_back(key, v);
        continue;
      }
      Flight& f = flight(i);
      f.key = key;
      f.star.surround(m_mesh, v);
      m_wavefront.take(f.star);
      m_last_visit_near[v] = i + 1;
      for(const Link_vertex<FT>& link : f.star.links)
        m_last_visit_near[link.vertex] = i + 1;
      return true;
    }
    return false;
  }

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

  // lets the neighbours of a star that is not out any more be visited.
  void release(Flight& f)
  {
    for(const auto& neighbour : f.deferred)
      m_wavefront.queue().push_or_decrease(neighbour.second, neighbour.first);
    f.deferred.clear();
  }

  void abandon(Flight& f)
  {
    for(Star_face<FT>& face : f.star.faces)
      for(Window_list<FT>* list : {&face.counterclockwise, &face.clockwise, &face.outward})
        m_workers.front()->pool().release(*list);
    release(f);
  }

  // Blocks of windows wander from pool to pool, and more of them to some than back: the others would ask for new memory
  // in each run, without end. So all is given back when it is more than twice that of a run. No block is in use.
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

  // works until the visit i is done.
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

  // The nearest vertex that has to be visited, or whose star is out.
  FT nearest_key()
  {
    FT key = m_wavefront.queue().empty() ? Field::infinity() : m_wavefront.queue().top_key();
    for(Number i = m_first; i < m_last; ++i)
    {
      key = (std::min)(key, flight(i).key);
      for(const auto& neighbour : flight(i).deferred)
        key = (std::min)(key, neighbour.first);
    }
    return key;
  }

  // What a helping thread does.
  void help(Worker& worker)
  {
    Spin_wait spin;
    while(!m_is_over.load(std::memory_order_relaxed))
      if(work(worker))
        spin.reset();
      else
        spin.wait();
  }

  // keeps the exception that is being handled, if it is the first one.
  void fail()
  {
    if(!m_has_failed.exchange(true))
      m_failure = std::current_exception();
  }

  // carries windows through one star that nobody else has; returns false if there is none.
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

  static constexpr Number visits_between_checks = 16;
  static constexpr std::size_t least_surplus = std::size_t(1) << 18; // bytes

  const Mesh& m_mesh;
  Field& m_field;
  Team m_team;
  Wavefront<FT> m_wavefront;
  std::vector<std::unique_ptr<Worker>> m_workers; // the first one is the conductor's
  std::vector<Flight> m_flights;
  // For each vertex, the number plus 1 of the last visit of it or of a neighbour; the star of that visit is out if this
  // is greater than m_first.
  std::vector<Number> m_last_visit_near;
  Stopping_criterion<FT> m_end;
  FT m_maximum_distance;
  std::size_t m_memory_of_run = 0; // the first one since all memory was given back, in bytes
  Number m_first = 0, m_last = 0; // of the stars that are out
  Number m_begin = 0;             // of this run
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
