// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_REPEATED_PROPAGATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_REPEATED_PROPAGATION_H

// Runs of the propagation, one after the other, on the same mesh. The runs share all buffers, and each takes time
// proportional to what it reaches (see Distance_propagation::restart()). An object holds all that one thread needs to
// compute distances of vertices. It does not know the user's mesh.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Where a run may end early: at the maximum distance and, if there are targets, when their distances are final. An
// empty range of targets is no limit. The distance is in the unit of the mesh; the range must live until the run has
// ended.
template <typename FT>
struct Run_limits
{
  FT maximum_distance = Vertex_distance_field<FT>::infinity();
  const Vertex_id* first_target = nullptr;
  const Vertex_id* last_target = nullptr;
};

// `Propagation` is Distance_propagation or Parallel_distance_propagation.
//
// The field keeps the result after the sources are removed from the mesh: vertices of inserted sources are then numbers
// behind those of the mesh, which no face has. They are valid for the queries below until the next run.
template <typename Propagation>
class Repeated_propagation
{
public:
  using FT = typename Propagation::FT;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // On a mesh that other threads may read at the same time. All sources have to be vertices.
  explicit Repeated_propagation(const Mesh& mesh)
    : m_mesh(mesh), m_insertion(nullptr), m_propagation(mesh, m_field)
  {}

  // On a mesh that no other thread reads during a run, which inserts sources in faces and removes them at its end.
  Repeated_propagation(const Mesh& mesh, Source_insertion<FT>& insertion)
    : m_mesh(mesh), m_insertion(&insertion), m_propagation(mesh, m_field)
  {}

  // Propagates from the sources, and sets the vertices of those in faces. Returns false if go_on(number of visits,
  // distance) does; no vertex has been reached then. The result does not depend on the order of the sources.
  //
  // Requires: no source is in a face if the object was made without an insertion.
  template <typename GoOn>
  bool run(Source_set<FT>& sources, const Run_limits<FT>& limits, GoOn go_on)
  {
    return propagate(sources, limits, [&go_on](Propagation& propagation) { return propagation.run(go_on); });
  }

  // The same, but visits a vertex only if is_needed() says so, as Distance_propagation::run() does. The caller knows
  // which distances are final then: distance() takes those of vertices that are not needed for final, too.
  template <typename GoOn, typename IsNeeded>
  bool run(Source_set<FT>& sources, const Run_limits<FT>& limits, GoOn go_on, IsNeeded&& is_needed)
  {
    return propagate(sources, limits, [&](Propagation& propagation) { return propagation.run(go_on, is_needed); });
  }

  // Forgets the result: no vertex has been reached.
  void forget() { m_limit = -1; }

  // Returns the distance of a vertex; infinity if it was not reached, or if the distance is not final.
  FT distance(Vertex_id v) const
  {
    return m_field.distance[v] <= m_limit ? m_field.distance[v] : Field::infinity();
  }

  // Tells from which source the distance of a vertex is measured, if the vertex has been reached.
  const Field& field() const { return m_field; }

  // Returns all vertices that the last run touched, each once; those of sources in faces are among them. Some may have
  // distances that are not final: distance() is infinite for these.
  const std::vector<Vertex_id>& vertices_reached() const { return m_field.reached; }

  Propagation_statistics statistics() const { return m_propagation.statistics(); }
  std::size_t field_memory() const { return m_field.memory(); }

private:
  // Removes the inserted sources, also if an exception ends the run.
  struct Removal_of_sources
  {
    Source_insertion<FT>* insertion;

    ~Removal_of_sources()
    {
      if(insertion != nullptr)
        insertion->undo();
    }
  };

  // The propagation restarts when the sources are inserted: restart() sizes its tables by the refined mesh. The sources
  // are removed in any case, also by an exception; m_limit is set only by a run that returns true.
  template <typename RunPropagation>
  bool propagate(Source_set<FT>& sources, const Run_limits<FT>& limits, const RunPropagation& run_propagation)
  {
    m_limit = -1;
    Removal_of_sources removal{m_insertion};
    if(m_insertion != nullptr)
      insert_located_sources(sources.located, *m_insertion, sources.vertices);
    m_propagation.restart();
    for(std::size_t i = 0; i < sources.vertices.size(); ++i)
      m_propagation.add_source(sources.vertices[i], sources.offsets.empty() ? FT(0) : sources.offsets[i]);
    m_propagation.set_maximum_distance(limits.maximum_distance);
    if(limits.first_target != limits.last_target)
      m_propagation.set_targets(limits.first_target, limits.last_target);
    if(!run_propagation(m_propagation))
      return false;
    m_limit = (std::min)(m_propagation.reached_distance(), limits.maximum_distance);
    return true;
  }

  const Mesh& m_mesh;
  Source_insertion<FT>* m_insertion;
  Field m_field;
  Propagation m_propagation;
  FT m_limit = -1; // distances beyond it are not final; -1 if there is no result
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_REPEATED_PROPAGATION_H
