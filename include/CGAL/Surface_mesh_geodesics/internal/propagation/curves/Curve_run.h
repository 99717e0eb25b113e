// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_CURVE_RUN_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_CURVE_RUN_H

// Runs from sources that are curves, one set after the other, on one mesh: inserts the curves, propagates, and removes
// them again. Repeated_propagation.h does the same from points.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Repeated_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/curves/Strip_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Curve_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The tables of an object grow with the mesh, as those of any propagation do. A run clears what the one before has left
// in the area that it reached.
//
// Invariant: outside run() no curve is inserted. Results are those of the last run that returned true.
template <typename FT, typename Rules = All_pruning_rules>
class Curve_run
{
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;
  using Propagation = Distance_propagation<FT, Rules, No_window_keeper, Strip_front<FT>>;

public:
  // On a mesh that no other thread reads during a run.
  Curve_run(const Mesh& mesh, Source_insertion<FT>& insertion)
    : m_mesh(mesh), m_insertion(insertion), m_propagation(mesh, m_field)
  {}

  Curve_run(const Curve_run&) = delete;
  Curve_run& operator=(const Curve_run&) = delete;

  // Propagates from the curves. Calls look(curves in the refined mesh) as long as they are inserted, and before the
  // propagation. Returns false if go_on(number of visits, distance) does; no vertex has been reached then.
  template <typename GoOn, typename Look>
  bool run(const std::vector<Located_curve<FT>>& curves, const Run_limits<FT>& limits, GoOn go_on, Look look)
  {
    m_limit = -1; // until the run is complete
    // The propagation restarts when the curves are inserted: its tables have the size of the refined mesh. They keep it
    // when the curves are removed, so that the foot of a path can still be found.
    const Removal removal{m_insertion};
    m_curves = Curve_insertion<FT>(m_mesh, m_insertion).insert(curves);
    look(m_curves);
    m_propagation.restart();
    m_propagation.set_maximum_distance(limits.maximum_distance);
    m_propagation.add_curves(m_curves);
    if(limits.first_target != limits.last_target)
      m_propagation.set_targets(limits.first_target, limits.last_target);
    if(!m_propagation.run(go_on))
      return false;
    m_limit = (std::min)(m_propagation.reached_distance(), limits.maximum_distance);
    return true;
  }

  // Forgets the result: no vertex has been reached. For a run that an exception has ended, in this class or in the
  // visitor.
  void forget() { m_limit = -1; }

  // Returns the distance of a vertex; infinity if it was not reached, or if the distance is not final. As for points,
  // distances beyond the limit may still shrink, so nobody sees them.
  FT distance(Vertex_id v) const
  {
    return m_field.distance[v] <= m_limit ? m_field.distance[v] : Field::infinity();
  }

  // Returns the foot of the shortest path to a vertex: a point of a curve. Takes time linear in the number of vertices
  // at which the path bends, and logarithmic in that of vertices on curves. Requires: v has been reached.
  Curve_point<FT> foot(Vertex_id v) const
  {
    return curve_point_of_vertex(m_curves, m_field, [this](Vertex_id u) { return m_propagation.strips().foot(u); }, v);
  }

  // Tells at which vertex the last bend of a path from the curves is; its foot is that of the path.
  const Field& field() const { return m_field; }

  // Returns all vertices that the last run touched, each once; also those of the refined mesh. For results of runs that
  // reach little of a large mesh.
  const std::vector<Vertex_id>& vertices_reached() const { return m_field.reached; }

  Propagation_statistics statistics() const { return m_propagation.statistics(); }
  std::size_t field_memory() const { return m_field.memory(); }

private:
  // Removes the inserted curves, also if an exception ends the run.
  struct Removal
  {
    Source_insertion<FT>& insertion;

    ~Removal() { insertion.undo(); }
  };

  const Mesh& m_mesh;
  Source_insertion<FT>& m_insertion;
  Field m_field;
  Propagation m_propagation;
  Source_curves<FT> m_curves;
  FT m_limit = -1; // distances beyond it are not final; -1 if there is no result
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_CURVE_RUN_H
