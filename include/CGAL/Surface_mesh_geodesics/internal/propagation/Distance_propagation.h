// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_DISTANCE_PROPAGATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_DISTANCE_PROPAGATION_H

// VTP, the vertex-oriented triangle propagation (thesis, chapter 4, algorithm 2): exact distances from sources to all
// vertices. Windows start at sources and at other pseudo-sources, and wait in lists on edges. The nearest vertex of the
// wavefront is visited; the visit propagates the lists around it through the faces of its star.
//
// An object serves many runs. restart() undoes what the last run did, and nothing else, so a run that ends early costs
// no more than the area that it reaches.
//
// Complexity: O(n^2) time in the worst case for a mesh with n vertices (thesis, 4.4), plus O(log n) for each visit;
// near linear in practice. Memory: the windows of the widest wavefront, and tables of O(n).

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Star_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Stopping_criterion.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront_queue.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The policy of a propagation from points.
struct No_strips
{
  static constexpr bool exist = false;

  template <typename Mesh, typename Field>
  No_strips(const Mesh&, const Field&, Lane_choice)
  {}
};

// States: ready (after construction or restart()), where sources and limits are set; running; complete or interrupted,
// where the field and statistics() are read. From complete, add_source() and run() continue; from any state restart()
// leads back to ready.
//
// Invariants, outside run(): those of Wavefront with no star taken out. After a run that has returned true, a distance
// is final if it is not greater than reached_distance() and than the maximum distance.
//
// `Keeper` is a policy that sees the windows (see Star_propagation): it is also told the distance that is reached.
// `Strips` is the policy for sources that are curves (curves/Strip_front.h).
template <typename FT_, typename Rules_ = All_pruning_rules, typename Keeper_ = No_window_keeper,
          typename Strips_ = No_strips>
class Distance_propagation
{
public:
  using FT = FT_;
  using Rules = Rules_;
  using Keeper = Keeper_;
  using Strips = Strips_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // Resets the field, which receives the result. Mesh and field must outlive this object. The keeper is given each list
  // that is propagated, and the distance reached before each visit of a vertex.
  Distance_propagation(const Mesh& mesh, Field& field, Keeper keeper = Keeper(), Lane_choice lanes = Lane_choice::BEST)
    : m_mesh(mesh), m_wavefront(mesh, field), m_queue(mesh.number_of_vertices()),
      m_stars(mesh, field.distance, keeper, lanes), m_strips(mesh, field, lanes)
  {}

  // Removes the sources, distances, limits and statistics of the last run. The mesh may have changed since.
  // Linear in the area that the last run reached.
  void restart()
  {
    const std::array<Window_list_slots*, 1> own_slots{&m_slots};
    m_wavefront.restart(m_stars.pool(), own_slots);
    m_queue.restart(m_mesh.number_of_vertices());
    m_maximum_windows_alive = 0;
    m_stars.restart();
    m_stars.set_maximum_distance(Field::infinity());
    m_end = Stopping_criterion<FT>();
    if constexpr(Strips::exist)
    {
      m_stars.set_source_edges(std::vector<Source_edge<FT>>());
      m_strips.restart();
    }
  }

  // Adds a source. Ignores a source that is not nearer to its vertex than earlier ones.
  // Requires: v is a vertex of the mesh; offset >= 0 and finite.
  //
  // Sources may also be added to a complete propagation. The next run() then computes the distances from all sources,
  // and propagates windows of the new sources only, little farther than their distances are the smallest. Proof:
  // - A window is removed only because some path on the surface is shorter, and distances that are kept are lengths of
  //   paths. All points of a shortest path from a new source are nearer to that source than to any other. So none of
  //   its windows is removed; the path arrives, and its pseudo-sources emit windows as usual.
  // - A vertex that no new source improves has its distance already, and none of its windows is needed again.
  // - A vertex that has emitted windows and is improved emits again, into all its faces; waiting windows of its former
  //   distance are recognized as stale.
  void add_source(Vertex_id v, const FT& offset)
  {
    m_wavefront.add_source(v, offset, pusher());
    m_end.go_back_to(offset);
  }

  // Adds curves: edges and vertices of the mesh (surface/curves/Source_curves.h). Requires: no run has begun since
  // restart(), and the maximum distance is set.
  template <typename Curves>
  void add_curves(const Curves& curves)
  {
    static_assert(Strips::exist, "curves need a propagation with strips");
    m_stars.set_source_edges(curves.edges);
    m_strips.start(curves, m_wavefront, pusher());
  }

  // The strips, and what they know of paths. They may be told to keep themselves before a run: that is no matter of the
  // propagation.
  const Strips& strips() const { return m_strips; }
  Strips& strips() { return m_strips; }

  // Does not propagate windows beyond d. Requires: d >= 0. Smaller distances are the same, bit by bit, as without
  // limit.
  void set_maximum_distance(const FT& d)
  {
    m_stars.set_maximum_distance(d);
    m_end.set_maximum_distance(d);
    if constexpr(Strips::exist)
      m_strips.set_maximum_distance(d);
  }

  // Ends the run when the distances of the vertices in [first, last) are final. The range is not copied.
  void set_targets(const Vertex_id* first, const Vertex_id* last) { m_end.set_targets(first, last); }

  // Propagates until nothing waits or a limit is reached, and returns true. Calls go_on(number of visits, distance
  // reached) before each visit of a vertex; if that returns false, stops at once and returns false. Restart the
  // propagation then, or continue it with run().
  template <typename GoOn>
  bool run(GoOn go_on)
  {
    return run(go_on, Every_visit());
  }

  // The same, but visits a vertex only if is_needed(vertex, queue key, distances found so far). What waits in a star
  // that is not visited goes on waiting: until restart(), or until another window brings a visit there. That visit
  // takes old windows along, so keys need not ascend then. The distance reached does; all distances up to it are final
  // whose paths lead through no window of a visit that was skipped.
  template <typename GoOn, typename IsNeeded>
  bool run(GoOn go_on, IsNeeded&& is_needed)
  {
    constexpr bool is_pruned = !std::is_same<std::decay_t<IsNeeded>, Every_visit>::value;
    while(!m_queue.empty() || (!is_pruned && goes_on_beside_unreached_vertices()))
    {
      if(m_end.is_reached_at(m_queue.top_key(), m_wavefront.distances()))
        return true;
      if(!go_on(m_stars.statistics().vertices_visited, m_end.reached_distance()))
        return false;
      CGAL_expensive_assertion(is_pruned || ascends(m_queue.top_key()));
      if(!is_needed(m_queue.top(), m_queue.top_key(), m_wavefront.distances()))
      {
        m_queue.pop();
        continue;
      }
      m_stars.keeper().advance(m_end.reached_distance());
      m_star.surround(m_mesh, m_queue.top());
      const FT key = m_queue.top_key();
      m_queue.pop();
      cross_strips();
      m_wavefront.take(m_star, key, m_slots);
      // The vertex that will probably be next is far away, with many sources or on a large mesh: fetch its star
      // meanwhile. (A visit pushes vertices behind itself, so that it hardly ever is another one.)
      const Vertex_id next = m_queue.empty() ? m_star.vertex : m_queue.top();
      m_mesh.prefetch_star(next);
      m_stars.propagate(m_star);
      m_mesh.prefetch_faces_of_star(next);
      if constexpr(Strips::exist)
        m_strips.prefetch_star(next);
      put_back();
      CGAL_expensive_assertion(is_pruned || m_wavefront.is_queued_around(m_star, m_queue));
    }
    CGAL_assertion(is_pruned || m_slots.number_of_windows == 0);
    if constexpr(Strips::exist)
      CGAL_assertion(m_strips.empty());
    m_end.set_complete();
    return true;
  }

  // Distances up to this one are final; infinity when the propagation is complete.
  const FT& reached_distance() const { return m_end.reached_distance(); }

  Propagation_statistics statistics() const
  {
    Propagation_statistics s = m_stars.statistics();
    s.maximum_windows_alive = m_maximum_windows_alive;
    s.maximum_window_bytes = m_stars.memory() + m_wavefront.memory();
    // The caller adds the mesh and the results.
    s.intrinsic_mesh_bytes = m_wavefront.table_memory() + m_queue.table_memory();
    if constexpr(Strips::exist)
    {
      s.windows_created += m_strips.number_created();
      s.windows_propagated += m_strips.number_crossed();
      s.maximum_window_bytes += m_strips.memory();
      s.intrinsic_mesh_bytes += m_strips.table_memory();
    }
    return s;
  }

private:
  // The answer of a run without pruning; its type tells so.
  struct Every_visit
  {
    bool operator()(Vertex_id, const FT&, const std::vector<FT>&) const { return true; }
  };

  auto pusher()
  {
    return [this](Vertex_id v, const FT& key) { m_queue.push_or_decrease(v, key); };
  }

  // Takes over the distances and the lists of the star. The maximum number of windows is that between visits: those
  // that a visit makes and removes again do not count.
  void put_back()
  {
    bool are_windows_stale = false;
    m_wavefront.for_each_improved_link(m_star, [&](const Link_vertex<FT>& link)
    {
      are_windows_stale |= m_wavefront.improve(link.vertex, link.distance, link.arrival, link.image,
                                               m_wavefront.reached(), pusher());
    });
    m_wavefront.put_lists(m_star, m_stars.pool(), m_slots, pusher());
    if(are_windows_stale)
      m_wavefront.expect_stale_windows(m_queue.largest_key());
    m_maximum_windows_alive =
      (std::max)(m_maximum_windows_alive, static_cast<std::size_t>(m_slots.number_of_windows));
  }

  // Lets the strips around the vertex cross its star, before the windows do: they improve vertices, and windows are
  // compared with these.
  void cross_strips()
  {
    if constexpr(Strips::exist)
      if(m_strips.cross_star(m_star, m_wavefront, pusher()))
        m_wavefront.expect_stale_windows(m_queue.largest_key());
  }

  // Starts once more beside vertices that rounding has left without a distance (see Wavefront); not under a maximum
  // distance, which leaves vertices unreached on purpose. Requires: nothing waits.
  bool goes_on_beside_unreached_vertices()
  {
    if(m_end.maximum_distance() < Field::infinity() || !m_wavefront.start_beside_unreached_vertices(pusher()))
      return false;
    m_end.go_back_to(m_queue.top_key());
    return true;
  }

  // Is a key not smaller than those of the visits before, up to the error of images (Tolerance.h)? It is relative to
  // the distance and to the lengths of the mesh, the longest of which is about 1.
  bool ascends(const FT& key) const
  {
    const FT& reached = m_end.reached_distance();
    return reached - key <= Tolerance<FT>::tie() * (reached + 1) || !(reached < std::numeric_limits<FT>::infinity());
  }

  const Mesh& m_mesh;
  Wavefront<FT> m_wavefront;
  Wavefront_queue<FT> m_queue;
  Window_list_slots m_slots;
  Star_propagation<FT, Rules, Keeper> m_stars;
  Strips m_strips;
  Stopping_criterion<FT> m_end;
  std::size_t m_maximum_windows_alive = 0;
  Vertex_star<FT> m_star; // of the vertex that is visited; a buffer between visits
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_DISTANCE_PROPAGATION_H
