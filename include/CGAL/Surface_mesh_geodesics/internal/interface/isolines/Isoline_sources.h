// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_ISOLINES_ISOLINE_SOURCES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_ISOLINES_ISOLINE_SOURCES_H

// The sources of a run that finds isolines on its way, points or curves: how they get into the refined mesh, which
// propagation starts there, and which of them is the nearest one. A user whose sources are points does not compile the
// propagation from curves, which is a large text.
//
// The order of calls in a run: the sources are checked and inserted, then the sweep is reset for the refined mesh, then
// the propagation is made and started, and it is gone when the lines are read.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Isoline_sweep.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Available_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/curves/Strip_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Propagation_for_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Curve_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/Deferred_window_keeper.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Both classes have the same types and functions, for Isoline_run. The sweep keeps what the propagation carries across
// faces, and releases it behind the wavefront. The constructor inserts the sources, start() adds them to the
// propagation, finish() follows its run, and number() tells which source is the nearest one.

// Points: vertices of the refined mesh.
template <typename ConcurrencyTag>
class Isoline_points
{
public:
  using Tag = typename Available_tag<ConcurrencyTag>::type;
  using Sweep = Isoline_sweep<double>;
  using Keeper = Deferred_window_keeper<Sweep>;
  using Propagation = typename Propagation_for_tag<Tag, double, All_pruning_rules, Keeper>::type;

  // Checks the sources of the user and inserts them. `insertion` refines the mesh of the surface, an Intrinsic_surface.
  // Throws Invalid_geodesic_input, before anything is inserted.
  template <typename Surface, typename Sources>
  Isoline_points(const Surface& surface, const Sources& sources, const std::vector<double>& offsets,
                 Source_insertion<double>& insertion)
    : m_set(surface.source_set(sources, offsets))
  {
    insert_located_sources(m_set.located, insertion, m_set.vertices);
    m_numbers.assign(m_set);
  }

  // Adds the sources to a new propagation, which ends at a distance in the unit of the mesh. Sources at walls are
  // listed once for each side.
  void start(Propagation& propagation, double limit, Sweep&) const
  {
    for(std::size_t i = 0; i < m_set.size(); ++i)
      propagation.add_source(m_set.vertices[i], m_set.offset(i));
    propagation.set_maximum_distance(limit);
  }

  void finish(const Propagation&) {}

  // Returns the number of the source of all paths whose first vertex is v, as Vertex_distance_field::source_of() and
  // Sources_of_vertices find it.
  std::size_t number(const Vertex_distance_field<double>&, Vertex_id v) const { return m_numbers.number_at(v); }

private:
  Source_set<double> m_set; // all of them are vertices
  Source_numbers m_numbers; // by vertex
};

// Curves, also points among them: vertices and edges of the refined mesh. Strips and windows share one wavefront, so a
// single thread computes.
class Isoline_curves
{
public:
  using Tag = Sequential_tag;
  using Sweep = Isoline_sweep<double, Edge_strip_field<double>>;
  using Keeper = Deferred_window_keeper<Sweep>;
  using Propagation = Distance_propagation<double, All_pruning_rules, Keeper, Strip_front<double, Sweep>>;

  // Throws Invalid_geodesic_input also if rounding cannot tell curves apart (Curve_insertion.h); the mesh must not be
  // used then.
  template <typename Surface, typename Curves>
  Isoline_curves(const Surface& surface, const Curves& curves, const std::vector<double>& offsets,
                 Source_insertion<double>& insertion)
    : m_curves(Curve_insertion<double>(surface.mesh(), insertion).insert(surface.located_curves(curves, offsets)))
  {}

  // The limit comes first: strips that start beyond it are not made.
  void start(Propagation& propagation, double limit, Sweep& sweep) const
  {
    propagation.strips().keep_in(&sweep);
    propagation.set_maximum_distance(limit);
    propagation.add_curves(m_curves);
  }

  // Notes the feet of paths: they are known as long as the propagation is there.
  void finish(const Propagation& propagation) { m_foot = propagation.strips().feet(); }

  // The same as for points, but a path from the inside of a segment has its first bend at v. Where curves meet, the
  // first one counts of those with the smallest offset.
  std::size_t number(const Vertex_distance_field<double>& field, Vertex_id v) const
  {
    return curve_point_of_vertex(m_curves, field, [this](Vertex_id u) { return m_foot[u]; }, v).curve;
  }

private:
  Source_curves<double> m_curves;
  std::vector<Strip_foot<double>> m_foot; // by vertex
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_ISOLINES_ISOLINE_SOURCES_H
