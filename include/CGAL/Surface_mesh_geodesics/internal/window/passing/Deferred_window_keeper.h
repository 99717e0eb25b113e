// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_DEFERRED_WINDOW_KEEPER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_DEFERRED_WINDOW_KEEPER_H

// What a propagation calls a keeper, for a collector that one thread at a time may call: it passes lists of windows and
// the distance reached on. The parallel propagation logs the lists in each thread, and has one thread at a time pass
// them on (propagation/parallel/Window_relay.h).

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Kept_window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/entering_windows.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The lists that one thread has carried across halfedges, in their order, with what a collector asks of them. Keeping a
// list takes time linear in its size; the log has memory for the largest number of windows that it has had.
//
// The bounds are computed when a list is logged, not when it is passed on: a Kept_window has no distances at the ends
// of its interval, and the list is gone by then.
//
// Invariant: the windows of list i are those from m_lists[i].first_window up to those of the next list.
template <typename FT>
class Entering_window_log
{
public:
  // A place in the log: the number of lists before it. Valid until clear().
  using Position = std::size_t;

  // Requires: mesh and field outlive the log, and do not change during keep().
  Entering_window_log(const Intrinsic_mesh<FT>& mesh, const Vertex_distance_field<FT>& field)
    : m_mesh(&mesh), m_field(&field)
  {}

  // Logs a list that the propagation carries across h. Requires: the list is not empty.
  void keep(Halfedge_id h, const Window_list<FT>& list)
  {
    CGAL_expensive_assertion(are_on_edge(list, m_mesh->length(h)));
    m_lists.push_back(Entering_list{h, m_windows.size(), list.size, bound_by_windows(*m_mesh, *m_field, h, list),
                                    smallest_distance(list)});
    for(std::size_t i = 0; i < list.size; ++i)
      m_windows.push_back(kept_window(list, i));
  }

  Position position() const { return m_lists.size(); }

  // Passes the lists between two positions on to a collector. The log does not change, and other threads may write logs
  // of their own meanwhile. Requires: first <= last <= position().
  template <typename Collector>
  void pass_on(Position first, Position last, Collector& collector) const
  {
    for(Position i = first; i < last; ++i)
    {
      const Entering_list& list = m_lists[i];
      collector.keep(list.halfedge, list.size, [&](std::size_t k) { return m_windows[list.first_window + k]; },
                     [&] { return list.bound; }, [&] { return list.smallest; });
    }
  }

  void clear()
  {
    m_lists.clear();
    m_windows.clear();
  }

  void swap(Entering_window_log& other) { std::swap(*this, other); }

  std::size_t memory() const
  {
    return m_lists.capacity() * sizeof(Entering_list) + m_windows.capacity() * sizeof(Kept_window<FT>);
  }

private:
  struct Entering_list
  {
    Halfedge_id halfedge;
    std::size_t first_window, size;
    FT bound, smallest; // bound_by_windows() and smallest_distance() when the list entered
  };

  const Intrinsic_mesh<FT>* m_mesh;
  const Vertex_distance_field<FT>* m_field;
  std::vector<Entering_list> m_lists;
  std::vector<Kept_window<FT>> m_windows;
};

// `Collector` decides which windows stay, and for how long: Redundant_window_removal or Isoline_sweep. It must outlive
// this object, and has been reset for the mesh before the object is used. Copies serve the same collector.
// `is_deferred` tells the parallel propagation that threads log windows first; a keeper that is not deferred keeps
// windows in several threads at once (Window_keeper).
template <typename Collector>
class Deferred_window_keeper
{
public:
  using FT = typename Collector::FT;
  using Thread_keeper = Entering_window_log<FT>;
  static constexpr bool is_deferred = true;

  explicit Deferred_window_keeper(Collector& collector) : m_collector(&collector) {}

  // --- for a propagation in one thread ---

  void keep(Halfedge_id h, const Window_list<FT>& list) { m_collector->keep(h, list); }
  void advance(const FT& reached) { m_collector->advance(reached); }

  // --- for the parallel propagation: one thread at a time calls these functions, except do_unit() ---

  Thread_keeper thread_keeper() const { return Thread_keeper(m_collector->mesh(), m_collector->field()); }

  // Keeps the lists between two positions of a log. Distances up to `reached` are final; those of the roots of these
  // windows may be greater. The caller goes through the logs in the order of the visits in their batch; then, while the
  // propagation runs, it calls advance(reached).
  void take_over(const Thread_keeper& log, typename Thread_keeper::Position first,
                 typename Thread_keeper::Position last, const FT& reached)
  {
    m_collector->set_final_distance(reached);
    log.pass_on(first, last, *m_collector);
  }

  // The keeper has no work for several threads: see Dividing_window_keeper in the room Voronoi.
  void restart(std::size_t /*number_of_threads*/) {}
  std::size_t begin_batch() { return 0; }
  void do_unit(std::size_t /*unit*/, std::size_t /*thread*/) {}
  std::size_t memory() const { return 0; }

private:
  Collector* m_collector;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_DEFERRED_WINDOW_KEEPER_H
