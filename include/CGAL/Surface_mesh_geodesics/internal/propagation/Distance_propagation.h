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

// VTP, the vertex-oriented triangle propagation (thesis, chapter 4, algorithm 2): windows start at
// the sources and at the vertices where shortest paths bend, wait in lists on the edges of the
// wavefront, and are carried, list by list, through the faces around the vertex that is nearest.
//
// An object may be used for many runs: restart() undoes what the last one did, and no more, so that a run
// that ends early costs nothing beyond the area that it reaches.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Stopping_criterion.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Star_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT_, typename Rules_ = All_pruning_rules, typename Keeper_ = No_window_keeper>
class Distance_propagation
{
public:
  using FT = FT_;
  using Rules = Rules_;
  using Keeper = Keeper_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // The field is reset; it holds the result. The keeper is given each list that is propagated, and the
  // distance reached before each visit of a vertex.
  Distance_propagation(const Mesh& mesh, Field& field, Keeper keeper = Keeper(), Lane_choice lanes = Lane_choice::BEST)
    : m_mesh(mesh), m_wavefront(mesh, field), m_stars(mesh, field.distance, keeper, lanes)
  {}

  // forgets the last run: its sources, distances, targets and statistics. The mesh may have been changed.
  void restart()
  {
    m_wavefront.restart(m_stars.pool());
    m_stars.restart();
    m_stars.set_maximum_distance(Field::infinity());
    m_end = Stopping_criterion<FT>();
  }

  // adds a source; one that is not nearer to its vertex than those before is ignored.
  //
  // Sources may also be added when the propagation has finished, and run() called again: it ends with the distances
  // from all sources, and carries windows of the new ones only, hardly farther than the new distances reach. Why:
  // - Windows are removed because some path on the surface is shorter, and the distances of vertices that are kept are
  //   lengths of paths. So no window is removed along a shortest path from a new source, as all its points are
  //   nearer to that source than to all others; the path arrives, and its pseudo-sources emit windows as usual.
  // - What is not reached by a new source has its distance already, and none of its windows is needed again.
  // - The flags of emission are right: a vertex with HAS_EMITTED that is improved makes its windows again, for all its
  //   faces, and what still waits of the old ones is stale.
  void add_source(Vertex_id v, const FT& offset)
  {
    m_wavefront.add_source(v, offset);
    m_end.go_back_to(offset);
  }

  // Windows that begin farther away are not propagated.
  void set_maximum_distance(const FT& d)
  {
    m_stars.set_maximum_distance(d);
    m_end.set_maximum_distance(d);
  }

  // The run ends when the distances of all these vertices are final. They are not copied.
  void set_targets(const Vertex_id* first, const Vertex_id* last) { m_end.set_targets(first, last); }

  // propagates until nothing waits. Calls go_on(number of visits, distance reached) before each visit
  // of a vertex, and returns false as soon as that does.
  template <typename GoOn>
  bool run(GoOn go_on)
  {
    while(!m_wavefront.queue().empty() || goes_on_beside_unreached_vertices())
    {
      if(m_end.is_reached_at(m_wavefront.queue().top_key(), m_wavefront.distances()))
        return true;
      if(!go_on(m_stars.statistics().vertices_visited, m_end.reached_distance()))
        return false;
      m_stars.keeper().advance(m_end.reached_distance());
      m_star.surround(m_mesh, m_wavefront.queue().top());
      m_wavefront.queue().pop();
      m_wavefront.take(m_star);
      // The vertex that will probably be next is far from this one if there are many sources.
      const Vertex_id next = m_wavefront.queue().empty() ? m_star.vertex : m_wavefront.queue().top();
      m_mesh.prefetch_star(next);
      m_stars.propagate(m_star);
      m_mesh.prefetch_faces_of_star(next);
      m_wavefront.put_back(m_star, m_stars.pool());
    }
    m_end.set_complete();
    return true;
  }

  // Distances up to this one are final.
  const FT& reached_distance() const { return m_end.reached_distance(); }

  Propagation_statistics statistics() const
  {
    Propagation_statistics s = m_stars.statistics();
    s.maximum_windows_alive = m_wavefront.maximum_windows_alive();
    s.maximum_window_bytes = m_stars.memory() + m_wavefront.memory();
    s.intrinsic_mesh_bytes = m_wavefront.table_memory(); // those of the mesh and of the results are added elsewhere
    return s;
  }

private:
  // Nothing waits: should there be more, see Wavefront?
  bool goes_on_beside_unreached_vertices()
  {
    if(m_end.maximum_distance() < Field::infinity() || !m_wavefront.start_beside_unreached_vertices())
      return false;
    m_end.go_back_to(m_wavefront.queue().top_key());
    return true;
  }

  const Mesh& m_mesh;
  Wavefront<FT> m_wavefront;
  Star_propagation<FT, Rules, Keeper> m_stars;
  Stopping_criterion<FT> m_end;
  Vertex_star<FT> m_star; // of the vertex that is visited
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_DISTANCE_PROPAGATION_H
