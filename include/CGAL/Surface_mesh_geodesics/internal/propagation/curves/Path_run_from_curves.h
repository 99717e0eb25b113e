// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_PATH_RUN_FROM_CURVES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_PATH_RUN_FROM_CURVES_H

// A run from curves whose results are for paths and for queries at any point: it keeps windows, strips and feet.
//
// Why there is an abstract class: the loop of a propagation with strips is a large text. Programs whose paths start at
// points only know the abstract class, and do not compile it. The first curve that a program adds brings the other one.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/curves/Strip_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Curve_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// go_on(number of visits, distance reached) ends the run if it returns false. It is type-erased, as virtual functions
// have no template parameters; a call of it is nothing beside a visit.
template <typename FT>
class Path_run_from_curves
{
public:
  using Go_on = std::function<bool(std::size_t, FT)>;

  virtual ~Path_run_from_curves() = default;

  // Inserts curves into the mesh, and notes them in `arrivals`. Throws Invalid_geodesic_input (Curve_insertion.h).
  virtual void insert(const Intrinsic_mesh<FT>& mesh, Source_insertion<FT>& insertion,
                      const std::vector<Located_curve<FT>>& curves, Curve_arrivals<FT>& arrivals) const = 0;

  // Propagates from `arrivals.curves`, which are inserted into the mesh, into the field. If the keeper keeps windows,
  // strips are kept as well. Returns whether the run is complete. Feet are written unless the run is a repetition: then
  // other threads may be reading those of the first run, which are the same.
  virtual bool run(const Intrinsic_mesh<FT>& mesh, Vertex_distance_field<FT>& field, const Window_keeper<FT>& keeper,
                   Curve_arrivals<FT>& arrivals, bool is_repetition, const Go_on& go_on,
                   Propagation_statistics& statistics) const = 0;
};

// The run itself. It has no state: the tables of a propagation live as long as a call. A second run on the same mesh
// meets the same strips in the same order, so its strips fit the feet of the first one, bit by bit.
template <typename FT>
class Strip_path_run : public Path_run_from_curves<FT>
{
public:
  using Go_on = typename Path_run_from_curves<FT>::Go_on;

  void insert(const Intrinsic_mesh<FT>& mesh, Source_insertion<FT>& insertion,
              const std::vector<Located_curve<FT>>& curves, Curve_arrivals<FT>& arrivals) const override
  {
    // What was known of other curves is void: their edges and vertices are gone.
    arrivals.set_curves(Curve_insertion<FT>(mesh, insertion).insert(curves));
  }

  bool run(const Intrinsic_mesh<FT>& mesh, Vertex_distance_field<FT>& field, const Window_keeper<FT>& keeper,
           Curve_arrivals<FT>& arrivals, bool is_repetition, const Go_on& go_on,
           Propagation_statistics& statistics) const override
  {
    Distance_propagation<FT, All_pruning_rules, Window_keeper<FT>, Strip_front<FT>> propagation(mesh, field, keeper);
    if(keeper.keeps_windows())
    {
      arrivals.strips.reset(mesh.number_of_faces());
      propagation.strips().keep_in(&arrivals.strips);
    }
    propagation.add_curves(arrivals.curves);
    const bool is_complete = propagation.run(go_on);
    statistics = propagation.statistics();
    if(!is_repetition)
      arrivals.foot = propagation.strips().feet();
    return is_complete;
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_PATH_RUN_FROM_CURVES_H
