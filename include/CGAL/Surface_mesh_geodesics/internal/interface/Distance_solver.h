// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DISTANCE_SOLVER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DISTANCE_SOLVER_H

// The solver for distances of vertices: it reads the user's mesh once, and then propagates from other sources again and
// again. It keeps no windows; Path_solver is the one that does, and answers at any point. The free functions for
// distances make a Distance_solver for one run; the public class Geodesic_distance_solver keeps one.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Available_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Repeated_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/curves/Curve_run.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Propagation_for_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Curve_sides.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariant between runs: the intrinsic mesh has no inserted sources (Repeated_propagation removes them), so that each
// run starts from the mesh as it was read. The answers are those of the last run until the next one begins; after a run
// that was canceled or failed, no vertex is reached.
//
// TriangleMesh is a model of FaceListGraph, which is referred to and must outlive the object; the index maps are
// copied. ConcurrencyTag is the tag of the user, which does not compile if it asks for threads that are not available
// (Available_tag.h). FT and Rules differ from double and All_pruning_rules in tests and measurements only.
//
// Two kinds of runs. m_runner propagates from points, in the tables that it keeps from run to run. A run from curves
// has a runner of its own, which lives until the next run: m_curve_run is set exactly if the last run was one from
// curves, and then all answers come from it. Both refine the same intrinsic mesh and leave it as it was.
//
// Objects cannot be copied or moved: m_insertion and m_runner refer to the mesh in m_surface. Const functions only
// read, so several threads may call them; run() needs the object for itself.
template <typename ConcurrencyTag, typename FT, typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap,
          typename Rules = All_pruning_rules>
class Distance_solver
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Tag = typename Available_tag<ConcurrencyTag>::type;
  using Propagation = typename Propagation_for_tag<Tag, FT, Rules>::type;
  using Blocks = typename Blocks_for_tag<Tag>::type;

public:
  using Surface = Intrinsic_surface<FT, TriangleMesh, VertexIndexMap, FaceIndexMap>;

  static constexpr std::size_t no_source = Source_numbers::none;

  // `obstacles` are faces that are left out, and walls (Intrinsic_surface).

  // Reads the whole mesh, for runs from any sources; throws Invalid_geodesic_input. Takes linear time.
  template <typename Shape>
  Distance_solver(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim, Shape shape,
                  Obstacles obstacles = {})
    : m_surface(tm, vim, fim, std::move(shape), Blocks(), std::move(obstacles)), m_insertion(m_surface.mesh()),
      m_runner(m_surface.mesh(), m_insertion)
  {}

  // Reads what the sources of the only run can reach (Intrinsic_surface). A run from other sources would not get beyond
  // the components that these reach. Invalid sources are ignored here, and rejected by run(). The range may be read
  // twice, here and by run(), so it must allow several passes.
  template <typename Shape, typename Sources>
  Distance_solver(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim, Shape shape, const Sources& sources,
                  Obstacles obstacles)
    : m_surface(tm, vim, fim, std::move(shape), sources, Blocks(), std::move(obstacles)),
      m_insertion(m_surface.mesh()), m_runner(m_surface.mesh(), m_insertion)
  {}

  Distance_solver(const Distance_solver&) = delete;
  Distance_solver& operator=(const Distance_solver&) = delete;

  const Surface& surface() const { return m_surface; }

  // Propagates from the sources. Returns false if the visitor canceled: no vertex has been reached then. Throws
  // Invalid_geodesic_input, before anything changes, if a source, a target or the number of offsets is invalid.
  // `options` are Distance_options, in the user's unit (parameter_values.h). Requires: check_numbers(options) does not
  // throw. Takes time for the area that the run reaches, if there are limits.
  //
  // If the visitor or the propagation throws, no vertex is reached, and the next run is right. Statistics count a run
  // that was canceled, but none that has thrown.
  template <typename Sources, typename Options, typename Visitor>
  bool run(const Sources& sources, const Options& options, Visitor& visitor)
  {
    if constexpr(Are_curves<Sources>::value)
      return run_from_curves(sources, options, visitor, [](const auto&) {});
    else
    {
      Source_set<FT> set = m_surface.source_set(sources, options.source_offsets);
      const bool is_complete = run_with_options(m_runner, options, visitor, [&](const auto& limits, auto go_on)
                                                { return m_runner.run(set, limits, go_on); });
      // The runner has removed the inserted vertices from the mesh. The set still has their numbers, and so has the
      // field until the next run, which is enough to find the source of a vertex.
      m_numbers.assign(set);
      m_curve_run.reset();
      return is_complete;
    }
  }

  // The same from curves, or from a single curve. Calls look(curves in the refined mesh) before the propagation; if
  // that throws, the curves are taken out of the mesh again. Always sequential: strips and windows share one wavefront.
  // The runner is made for the first run from curves, as its tables would double the memory of a solver that never sees
  // a curve. It serves all runs until one from points follows.
  template <typename Curves, typename Options, typename Visitor, typename Look>
  bool run_from_curves(const Curves& curves, const Options& options, Visitor& visitor, Look look)
  {
    // Input is checked before anything changes, and a new runner takes its place when it has succeeded.
    const std::vector<Located_curve<FT>> located
      = m_surface.located_curves(curves, options.source_offsets);
    std::unique_ptr<Curve_runner> first;
    if(!m_curve_run)
      first.reset(new Curve_runner(m_surface.mesh(), m_insertion));
    Curve_runner& runner = first ? *first : *m_curve_run;
    const bool is_complete
      = run_with_options(runner, options, visitor, [&](const auto& limits, auto go_on)
                         { return runner.run(located, limits, go_on, look); });
    if(first)
      m_curve_run = std::move(first);
    return is_complete;
  }

  // The same, and sets a flag for each vertex of the intrinsic mesh: is it on the negative side of the curves? Throws
  // before the propagation if the curves do not separate the surface.
  template <typename Curves, typename Options, typename Visitor>
  bool run_with_sides(const Curves& curves, const Options& options, Visitor& visitor, std::vector<char>& is_negative)
  {
    return run_from_curves(curves, options, visitor, [&](const Source_curves<FT>& inserted)
    {
      const Curve_sides<FT> sides(m_surface.mesh(), inserted);
      is_negative.resize(m_surface.number_of_vertices());
      for(Vertex_id v = 0; v < is_negative.size(); ++v)
        is_negative[v] = sides.sign(v) < 0;
    });
  }

  // Does the same with the options and the visitor among the named parameters of a user, whose ranges are copied.
  // Checks the numbers first, so that it throws Invalid_geodesic_input before it asks the mesh for anything.
  template <typename Sources, typename NamedParameters>
  bool run_with_parameters(const Sources& sources, const NamedParameters& np)
  {
    const Distance_options<TriangleMesh> options = distance_options<TriangleMesh>(np);
    check_numbers(options);
    Visitor_parameter<NamedParameters> visitor_parameter(np);
    auto& visitor = visitor_parameter.visitor();
    return run(sources, options, visitor);
  }

  // Returns the distance of a vertex of the mesh in the user's unit, infinity if it was not reached. Requires: v is a
  // vertex of the mesh (not checked).
  FT distance(vertex_descriptor v) const { return distance_of(nearest_copy(v)) * m_surface.unit(); }

  // Returns the number of the source from which the distance of v is measured, or no_source if v is not reached. Takes
  // time logarithmic in the number of sources, and linear in the number of vertices where the path bends. Requires: v
  // is a vertex of the mesh (not checked).
  std::size_t nearest_source(vertex_descriptor v) const
  {
    const Vertex_id i = nearest_copy(v);
    return is_reached(i) ? number_of_source(field().source_of(i)) : no_source;
  }

  // The same for many vertices, which take linear time together: all calls get one object from sources_of_vertices().
  std::size_t nearest_source(vertex_descriptor v, Sources_of_vertices<FT>& source_of) const
  {
    const Vertex_id i = nearest_copy(v);
    return is_reached(i) ? number_of_source(source_of(i)) : no_source;
  }

  // The object is valid until the next run.
  Sources_of_vertices<FT> sources_of_vertices() const { return Sources_of_vertices<FT>(field()); }

  // The curves are no part of the mesh any more, but their numbers and parameters are kept with the result.
  // Returns the foot of the shortest path to v. Requires: the last run was one from curves, and v is reached.
  Curve_point<FT> foot(vertex_descriptor v) const
  {
    CGAL_precondition(m_curve_run != nullptr);
    return m_curve_run->foot(nearest_copy(v));
  }

  // Was the last run one from curves?
  // Then every vertex that is reached has a foot on one of the curves.
  bool has_curves() const { return m_curve_run != nullptr; }

  // Calls visit(vertex_descriptor, distance) for all vertices that have been reached, each once, in no particular
  // order. Takes time linear in the number of vertices that the last run touched. That list also has inserted sources,
  // which are not vertices of the user, and vertices whose distances are not final; both are passed over.
  template <typename Visit>
  void for_each_vertex_reached(Visit visit) const
  {
    for(const Vertex_id v : m_curve_run ? m_curve_run->vertices_reached() : m_runner.vertices_reached())
      if(v < m_surface.number_of_vertices() && distance_of(v) < Vertex_distance_field<FT>::infinity()
         // A vertex with several copies that have been reached is visited by the nearest one.
         && (!m_surface.has_walls() || nearest_copy(m_surface.descriptor(v)) == v))
        visit(m_surface.descriptor(v), FT(distance_of(v) * m_surface.unit()));
  }

  // All answers about v come from one copy, so that its distance, its source, its foot and its side belong together.
  //
  // The vertex of the intrinsic mesh at v; where walls divide v, the one that is nearest to the sources.
  Vertex_id nearest_copy(vertex_descriptor v) const
  {
    return m_surface.nearest_copy(v, [this](Vertex_id c) { return distance_of(c); });
  }

private:
  using Runner = Repeated_propagation<Propagation>;
  using Curve_runner = Curve_run<FT, Rules>;

  // That of the last run, of either kind.
  const Vertex_distance_field<FT>& field() const { return m_curve_run ? m_curve_run->field() : m_runner.field(); }

  bool is_reached(Vertex_id i) const { return distance_of(i) < Vertex_distance_field<FT>::infinity(); }

  // The number of the source at a vertex. Paths from the inside of a segment have no source there, but the vertex of
  // their first bend, which has the same foot.
  std::size_t number_of_source(Vertex_id source) const
  {
    return m_curve_run ? m_curve_run->foot(source).curve : m_numbers.number_at(source);
  }

  // The distance of a vertex of the intrinsic mesh, in its unit, after the last run of either kind. Before the first
  // run and after one that failed no vertex is reached.
  FT distance_of(Vertex_id v) const { return m_curve_run ? m_curve_run->distance(v) : m_runner.distance(v); }

  // What runs of both kinds have in common: limits, the visitor, the statistics, and what happens if something throws.
  // Calls run(limits, go_on) for a runner, with the options of the user, and adds its statistics. Throws for an invalid
  // target.
  template <typename AnyRunner, typename Options, typename Visitor, typename Run>
  bool run_with_options(AnyRunner& runner, const Options& options, Visitor& visitor, Run run)
  {
    // Any copy may be the nearest one, so all have to be final.
    std::vector<Vertex_id> targets;
    for(const Vertex_id v : m_surface.checked_ids(options.targets, "target"))
      m_surface.for_each_copy(v, [&](Vertex_id c) { targets.push_back(c); });
    Run_limits<FT> limits;
    limits.maximum_distance = FT(options.maximum_distance) / m_surface.unit();
    limits.first_target = targets.data();
    limits.last_target = targets.data() + targets.size();

    // All input is valid: from here on, the results of the run before are lost.
    Unfinished_run unfinished{this};
    const double unit = static_cast<double>(m_surface.unit());
    const bool is_complete = run_with_visitor(visitor, m_surface.number_of_vertices(), [&](auto go_on)
    {
      return run(limits, [&](std::size_t visits, const FT& d) { return go_on(visits, unit * static_cast<double>(d)); });
    });
    if(options.statistics != nullptr)
    {
      Propagation_statistics statistics = runner.statistics();
      statistics.intrinsic_mesh_bytes += m_surface.memory() + runner.field_memory();
      if constexpr(!std::is_same<AnyRunner, Runner>::value) // the tables for points stay
        statistics.intrinsic_mesh_bytes += m_runner.statistics().intrinsic_mesh_bytes + m_runner.field_memory();
      options.statistics->add(statistics);
    }
    unfinished.solver = nullptr;
    return is_complete;
  }

  // Forgets the distances if an exception ends the run, whether the propagation or the visitor throws it.
  struct Unfinished_run
  {
    Distance_solver* solver;

    ~Unfinished_run()
    {
      if(solver == nullptr)
        return;
      solver->m_runner.forget();
      solver->m_curve_run.reset();
    }
  };

  // In this order, as each member refers to those above it.
  Surface m_surface;
  Source_insertion<FT> m_insertion;
  Runner m_runner;
  Source_numbers m_numbers; // of the sources of the last run
  // A run from points resets it, and the next one from curves makes a new one: results are those of the last run of
  // either kind.
  std::unique_ptr<Curve_runner> m_curve_run; // if that was one from curves
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DISTANCE_SOLVER_H
