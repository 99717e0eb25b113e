// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PROPAGATION_WORKERS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PROPAGATION_WORKERS_H

// The workers of a parallel propagation: what each thread has for itself, with its memory from run to run.
//
// Each worker allocates windows from its own pool and returns blocks to its own pool, whoever allocated them. So blocks
// migrate between pools, and some pools gain blocks in each run, while others would allocate new ones without end.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Star_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Wavefront_part.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>

#include <cstddef>
#include <memory>
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

// What one thread needs for visits. `Thread_keeper` keeps its windows (Star_propagation.h).
template <typename FT, typename Rules, typename Thread_keeper>
struct alignas(64) Propagation_worker
{
  const std::size_t number;
  Star_propagation<FT, Rules, Thread_keeper> stars;
  Vertex_star<FT> star; // of the vertex that is visited; a buffer between visits
  Window_list_slots own_slots;
  std::vector<Wavefront_messages<FT>> messages; // by part

  Propagation_worker(std::size_t i, const Intrinsic_mesh<FT>& mesh, const std::vector<FT>& distance,
                     const Thread_keeper& keeper)
    : number(i), stars(mesh, distance, keeper)
  {}
};

// The first worker is that of the calling thread. One thread at a time calls an object; each worker may be used in a
// thread of its own.
template <typename FT, typename Rules, typename Thread_keeper>
class Propagation_workers
{
public:
  using Worker = Propagation_worker<FT, Rules, Thread_keeper>;

  // Makes workers until there are n. They refer to the mesh and to the distances. make_keeper() makes a Thread_keeper.
  template <typename MakeKeeper>
  void make(std::size_t n, const Intrinsic_mesh<FT>& mesh, const std::vector<FT>& distance, MakeKeeper make_keeper)
  {
    while(m_workers.size() < n)
      m_workers.push_back(std::make_unique<Worker>(m_workers.size(), mesh, distance, make_keeper()));
  }

  std::size_t size() const { return m_workers.size(); }
  Worker& operator[](std::size_t i) const { return *m_workers[i]; }

  // Calls function(worker) for each of them.
  template <typename Function>
  void for_each(Function function) const
  {
    for(const std::unique_ptr<Worker>& worker : m_workers)
      function(*worker);
  }

  std::vector<Window_list_slots*> own_slots() const
  {
    std::vector<Window_list_slots*> result;
    for_each([&](Worker& w) { result.push_back(&w.own_slots); });
    return result;
  }

  // The number of windows that wait. (That of one worker may be negative: it takes what others have put.)
  std::size_t number_of_windows() const
  {
    std::ptrdiff_t n = 0;
    for_each([&](const Worker& w) { n += w.own_slots.number_of_windows; });
    return static_cast<std::size_t>(n);
  }

  std::size_t number_of_visits() const
  {
    std::size_t n = 0;
    for_each([&](const Worker& w) { n += w.stars.statistics().vertices_visited; });
    return n;
  }

  // The counts and the memory of all workers.
  Propagation_statistics statistics() const
  {
    Propagation_statistics sum;
    for_each([&](const Worker& w)
    {
      sum.add(w.stars.statistics());
      sum.maximum_window_bytes += w.stars.memory();
    });
    return sum;
  }

  // Drops what a run that did not end has left: messages, and windows of stars that an exception has left.
  void drop_stars_and_messages()
  {
    for_each([](Worker& w)
    {
      for(Star_face<FT>& face : w.star.faces)
        for(Window_list<FT>* list : {&face.counterclockwise, &face.clockwise, &face.outward})
          w.stars.pool().release(*list);
      for(Wavefront_messages<FT>& messages : w.messages)
        messages.clear();
    });
  }

  // Frees the memory of all pools when it exceeds twice that of the first run, plus a constant. Requires: no block is
  // in use.
  void release_surplus()
  {
    std::size_t memory = 0;
    for_each([&](const Worker& w) { memory += w.stars.memory(); });
    if(m_memory_of_run == 0)
      m_memory_of_run = memory;
    if(memory <= 2 * m_memory_of_run + least_surplus)
      return;
    for_each([](Worker& w) { w.stars.pool().clear(); });
    m_memory_of_run = 0;
  }

private:
  static constexpr std::size_t least_surplus = std::size_t(1) << 18; // bytes

  std::vector<std::unique_ptr<Worker>> m_workers;
  std::size_t m_memory_of_run = 0; // bytes of the pools after the first run since they were last cleared; 0: unknown
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#ifdef _MSC_VER
#pragma warning(pop)
#endif

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PROPAGATION_WORKERS_H
