// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DISTANCE_CERTIFIER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DISTANCE_CERTIFIER_H

// Checks distances given by the user. A propagation of its own proposes a proof: paths, which show that no distance is
// too short, and windows, from curves also strips, which show that none is too long. Distance_checks and
// Lower_bound_check judge the proposal and know nothing of the propagation.
//
// Who does what:
// - the constructor reads the mesh, and set_sources() makes vertices of the sources, and edges of curves;
// - run() checks the conditions in the order of Checked_condition: those that need no propagation itself, paths and
//   lower bounds in check_with_witness(), distances in the opposite direction in check_reverse();
// - certify_distances() does all of this for the public functions, and makes the certificate.
//
// Curves are edges of the refined mesh, all points of which are sources. So three steps differ from those for points:
// paths may end inside of these edges, the lower bound has to be checked on all of them, and a distance in the opposite
// direction is the least one to any of their points. The propagation is that of Path_run_from_curves.h, which is type
// erased: a program that certifies distances from points only does not compile it.

#include <CGAL/Surface_mesh_geodesics/internal/certificate/Checked_conditions.h>
#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Distance_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Edge_distance_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Lower_bound_check.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Lower_bound_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Worst_violation.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Private_access.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/One_block.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Available_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/curves/Path_run_from_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Propagation_for_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Reads the user's mesh when it is constructed. Call set_sources() once, then run().
//
// What the proof rests on. The values are the user's. The propagation here may be wrong, too: its paths are measured
// face by face, and its windows and strips only propose a lower bound on each edge, which Lower_bound_check verifies.
// So a fault of the propagation can make right distances fail, but not wrong ones pass. What is trusted is where the
// sources are: that the vertices and edges which have been made of them are those of the user.
//
// The mesh is referred to and must outlive the object, the index maps are copied. FT is double for users. The
// propagations run in the calling thread; run() says what other threads share.
template <typename FT, typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Distance_certifier
{
public:
  using Surface = Intrinsic_surface<FT, TriangleMesh, VertexIndexMap, FaceIndexMap>;
  using Field = Vertex_distance_field<FT>;

  // Shape is described in Face_shapes.h. Reads all components, and throws Invalid_geodesic_input for a fault in any of
  // them. Faces to avoid are left out, as if they were not in the mesh, and the mesh is cut along walls.
  template <typename Shape>
  Distance_certifier(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim, Shape shape, Obstacles obstacles)
    : m_surface(tm, vim, fim, std::move(shape), One_block(), std::move(obstacles)),
      m_insertion(m_surface.mesh())
  {}

  Distance_certifier(const Distance_certifier&) = delete;
  Distance_certifier& operator=(const Distance_certifier&) = delete;

  const Surface& surface() const { return m_surface; }

  // Numbers the sources and makes vertices of them, and edges of curves. `offsets` has one for each source, or none, in
  // the user's unit. Throws Invalid_geodesic_input. Requires: check_offsets(offsets) does not throw.
  // The vertices that are made stay in the mesh as long as the object. They have the last numbers, behind the vertices
  // of the user, and no distance is given for them.
  template <typename Sources>
  void set_sources(const Sources& sources, const std::vector<double>& offsets)
  {
    if constexpr(Are_curves<Sources>::value)
    {
      const auto curves = m_surface.located_curves(sources, offsets);
      m_curve_run.reset(new Strip_path_run<FT>());
      m_curve_run->insert(m_surface.mesh(), m_insertion, curves, m_curves);
      for(const Source_vertex<FT>& v : m_curves.curves.vertices)
        m_sources.emplace_back(v.vertex, v.offset);
    }
    else
    {
      Source_set<FT> set = m_surface.source_set(sources, offsets);
      insert_located_sources(set.located, m_insertion, set.vertices);
      for(std::size_t i = 0; i < set.vertices.size(); ++i)
        m_sources.emplace_back(set.vertices[i], set.offsets.empty() ? FT(0) : set.offsets[i]);
    }
  }

  // Checks all conditions. `value(v)` is the distance of a vertex descriptor v, in the user's unit. `user_limit` is the
  // radius up to which distances were computed, infinity if all were. Distances are computed in reverse from
  // `number_of_reverse_runs` vertices. Takes the time and memory of a propagation that keeps its windows, and that of
  // the checks. `value` may return any number: check_reach() reports infinity where it is wrong, negative numbers and
  // NaN. The visitor follows each propagation; the first one includes the checks of what it proposes. If the visitor
  // cancels, the conditions that are not checked to the end are violated infinitely: nothing is proved.
  // The checks of paths and of the proof are divided into `chunks` (Chunk_team.h).
  template <typename Chunks, typename Value, typename Visitor>
  Checked_conditions<FT> run(const Chunks& chunks, Value value, const FT& user_limit,
                             std::size_t number_of_reverse_runs, Visitor& visitor)
  {
    // From here on all lengths are in the unit of the intrinsic mesh. Violations are relative, so they need no
    // conversion back.
    const FT limit = user_limit / m_surface.unit();
    std::vector<FT> values;
    values.reserve(m_surface.number_of_vertices());
    for(Vertex_id v = 0; v < m_surface.number_of_vertices(); ++v)
      values.push_back(FT(value(m_surface.descriptor(v))) / m_surface.unit());
    Visitor_of_several_runs<Visitor> visitor_of_runs(visitor);
    propose_values_of_copies(values, limit, visitor_of_runs);
    Distance_checks<FT> checks(m_surface.mesh(), std::move(values));
    for(const std::pair<Vertex_id, FT>& s : m_sources)
      checks.add_source(s.first, s.second);
    m_curves.curves.for_each_edge_with_length([&](Halfedge_id h, const FT& offset)
    { checks.add_source_edge(h, offset); });

    Checked_conditions<FT> result;
    result[CHECKED_REACH] = checks.check_reach(limit);
    result[CHECKED_SOURCES] = checks.check_sources(limit);
    result[CHECKED_EDGES] = checks.check_edges(limit);
    result[CHECKED_PAIRS_OF_FACES] = checks.check_pairs_of_faces(limit);
    check_with_witness(chunks, checks, limit, visitor_of_runs, result);
    result[CHECKED_REVERSE] = check_reverse(checks, limit, number_of_reverse_runs, visitor_of_runs);
    return result;
  }

private:
  // Of a vertex that walls divide, the user gives one value, the least distance of its copies. All checks need one for
  // each copy. A propagation proposes them: the copy that it finds nearest gets the value of the user, and the others
  // what the propagation says. All of these are checked then as if the user had given them, in the mesh that is cut; so
  // nothing rests on the proposal. If all are right, then no copy is nearer than the one with the value of the user,
  // as the proposal says so. A copy beyond the limit has no value, and a run that is canceled proposes none.
  //
  // Wrong distances of the user cannot hide behind the proposal: one that is too large exceeds the lower bound of its
  // copy, and one that is too small has no path. If a wrong propagation puts a right distance at a copy that is not the
  // nearest, a condition of that copy fails: then right distances are refused, as with any fault of the witness.
  //
  // Does nothing without such vertices.
  template <typename Visitor>
  void propose_values_of_copies(std::vector<FT>& values, const FT& limit, Visitor& visitor)
  {
    if(m_surface.copies().empty())
      return;
    Field field;
    if(!run_with_visitor(visitor, m_surface.number_of_vertices(), [&](auto go_on)
                         { return run_from_sources(field, nullptr, go_on); }))
      return;
    const auto distance = [&field](Vertex_id c) { return field.distance[c]; };
    for(Vertex_id v = 0; v < values.size(); ++v)
      if(m_surface.copies().is_divided(v) && m_surface.nearest_copy(m_surface.descriptor(v), distance) != v)
        values[v] = distance(v) <= limit ? distance(v) : Field::infinity();
  }

  // Propagates, and checks the paths and the lower bounds that come from it. The propagation has no limit: whether a
  // vertex may be without a value depends on its distance, which must be known for that. The windows are freed before
  // the reverse runs start.
  template <typename Chunks, typename Visitor>
  void check_with_witness(const Chunks& chunks, const Distance_checks<FT>& checks, const FT& limit, Visitor& visitor,
                          Checked_conditions<FT>& result)
  {
    Edge_window_field<FT> windows;
    windows.reset(m_surface.mesh().number_of_faces());
    Field field;
    // Paths are traced by images, which the field keeps if it is told so before the propagation resets it.
    field.keeps_images = true;
    // The function is made after the run. Until then it refers to what the run is about to fill.
    const Curve_arrivals<FT>* const curves = has_curves() ? &m_curves : nullptr;
    Lower_bound_function<FT> function(m_surface.mesh(), field.distance, windows,
                                      has_curves() ? &m_curves.strips : nullptr);
    const bool is_complete = run_with_visitor(visitor, m_surface.number_of_vertices(), [&](auto go_on)
    {
      std::size_t visits = 0;
      double reached = 0;
      const auto count = [&](std::size_t number_of_visits, double distance)
      {
        visits = number_of_visits;
        reached = distance;
        return go_on(visits, reached);
      };
      if(!run_from_sources(field, &windows, count))
        return false;
      const auto go_on_checking = [&]() { return go_on(visits, reached); };
      result[CHECKED_PATHS] = checks.check_paths(chunks, field, limit, go_on_checking, curves);
      if(visitor.is_canceled())
        return false;
      result[CHECKED_LOWER_BOUNDS] = checks.check_lower_bounds(field.distance, limit);
      result[CHECKED_PROOF] = prove_lower_bounds(chunks, function, checks.extents(), go_on_checking);
      return true;
    });
    if(is_complete)
      result[CHECKED_PROOF].record(check_bounds_at_sources(function, checks));
    else
      for(const Checked_condition c : {CHECKED_PATHS, CHECKED_LOWER_BOUNDS, CHECKED_PROOF})
        result[c].record_interruption();
    m_curves.forget_paths();
  }

  // Checks that the lower bound of a source is not greater than its offset, which the proof requires: at vertices, and
  // on all edges of curves. A violation is relative to the bound, which is positive where it is too large, as offsets
  // are not negative.
  Worst_violation<FT> check_bounds_at_sources(const Lower_bound_function<FT>& function,
                                              const Distance_checks<FT>& checks) const
  {
    Worst_violation<FT> worst;
    for(const std::pair<Vertex_id, FT>& s : m_sources)
      worst.record(function.values()[s.first] - s.second, function.values()[s.first], checks.extents()[s.first],
                   s.first);
    m_curves.curves.for_each_edge_with_length([&](Halfedge_id h, const FT& offset)
    { record_excess_on_edge(function, h, offset, checks.extents(), worst); });
    return worst;
  }

  // Computes distances from some vertices to the sources, and compares them. Such a run meets other windows than the
  // one that has computed the distances, so an error that depends on the direction shows.
  //
  // The vertices are spread over all numbers: the reader numbers vertices by their distance from a face, so these are
  // near it, far from it, and in between. (With one run, the vertex in the middle of the numbers.)
  //
  // Each run ends as soon as the distances of all sources are final. With curves it goes on to the end, and keeps its
  // windows, as the nearest point may be inside an edge.
  template <typename Visitor>
  Worst_violation<FT> check_reverse(const Distance_checks<FT>& checks, const FT& limit, std::size_t wanted_number,
                                    Visitor& visitor) const
  {
    std::vector<Vertex_id> targets;
    for(const std::pair<Vertex_id, FT>& s : m_sources)
      targets.push_back(s.first);
    Field field;
    Distance_propagation<FT> propagation(m_surface.mesh(), field);
    Worst_violation<FT> worst;
    const std::size_t n = m_surface.number_of_vertices();
    const std::size_t number = (std::min)(wanted_number, n);
    for(std::size_t i = 0; i < number; ++i)
    {
      const Vertex_id v = static_cast<Vertex_id>(number > 1 ? (n - 1) * i / (number - 1) : n / 2);
      if(has_curves())
      {
        if(!check_reverse_to_curves(v, checks, limit, visitor, worst))
          break;
        continue;
      }
      propagation.restart();
      propagation.add_source(v, FT(0));
      propagation.set_targets(targets.data(), targets.data() + targets.size());
      if(!run_to_sources(propagation, visitor))
      {
        worst.record_interruption();
        break;
      }
      checks.check_reverse(v, field, limit, worst);
    }
    return worst;
  }

  // The same from one vertex to curves. The least distance to an edge is that of the function on the edge, which is
  // made as for the proof, of the windows from the vertex. Returns false, and records it, if the visitor cancels.
  template <typename Visitor>
  bool check_reverse_to_curves(Vertex_id v, const Distance_checks<FT>& checks, const FT& limit, Visitor& visitor,
                               Worst_violation<FT>& worst) const
  {
    Field field;
    Edge_window_field<FT> windows;
    windows.reset(m_surface.mesh().number_of_faces());
    Keeping_propagation propagation(m_surface.mesh(), field, Window_keeper<FT>(windows));
    propagation.add_source(v, FT(0));
    if(!run_to_sources(propagation, visitor))
    {
      worst.record_interruption();
      return false;
    }
    const Lower_bound_function<FT> function(m_surface.mesh(), field.distance, windows);
    Edge_distance_function<FT> on_edge;
    FT to_edges = std::numeric_limits<FT>::infinity();
    m_curves.curves.for_each_edge_with_length([&](Halfedge_id h, const FT& offset)
    { to_edges = (std::min)(to_edges, FT(function.least_value(h, on_edge) + offset)); });
    checks.check_reverse(v, field, limit, worst, to_edges);
    return true;
  }

  // Runs a propagation that has its sources and targets, and lets the visitor follow it. Returns false if the visitor
  // cancels, or has canceled before: then the condition that needed the run counts as violated, as nobody has checked
  // it.
  template <typename Propagation, typename Visitor>
  bool run_to_sources(Propagation& propagation, Visitor& visitor) const
  {
    return !visitor.is_canceled()
        && run_with_visitor(visitor, m_surface.number_of_vertices(),
                            [&](auto go_on) { return run(propagation, go_on); });
  }

  // Runs a propagation. It calls go_on(number of visits, distance in the user's unit), and ends if that returns false.
  // (The propagation computes in the unit of the intrinsic mesh, a power of two; what a visitor sees is in the user's.)
  template <typename Propagation, typename GoOn>
  bool run(Propagation& propagation, GoOn go_on) const
  {
    return propagation.run([&](std::size_t number_of_visits, const FT& distance)
    {
      return go_on(number_of_visits, static_cast<double>(distance * m_surface.unit()));
    });
  }

  // Propagates from all sources, points or curves. Keeps windows if there is a field for them, and from curves also
  // strips and feet. Returns false if go_on() does.
  template <typename GoOn>
  bool run_from_sources(Field& field, Edge_window_field<FT>* windows, GoOn go_on)
  {
    const auto run_from_points = [&](auto&& propagation)
    {
      for(const std::pair<Vertex_id, FT>& s : m_sources)
        propagation.add_source(s.first, s.second);
      return run(propagation, go_on);
    };
    if(!has_curves())
      return windows != nullptr
               ? run_from_points(Keeping_propagation(m_surface.mesh(), field, Window_keeper<FT>(*windows)))
               : run_from_points(Distance_propagation<FT>(m_surface.mesh(), field));
    Propagation_statistics statistics;
    return m_curve_run->run(m_surface.mesh(), field,
                            windows != nullptr ? Window_keeper<FT>(*windows) : Window_keeper<FT>(), m_curves, false,
                            [&](std::size_t number_of_visits, const FT& distance)
                            { return go_on(number_of_visits, static_cast<double>(distance * m_surface.unit())); },
                            statistics);
  }

  // Are the sources curves? Points beside curves are curves of one location, so there is no mixture.
  bool has_curves() const { return m_curve_run != nullptr; }

  using Keeping_propagation = Distance_propagation<FT, All_pruning_rules, Window_keeper<FT>>;

  Surface m_surface;
  Source_insertion<FT> m_insertion;
  std::vector<std::pair<Vertex_id, FT>> m_sources; // with offsets; the vertices of curves, if there are any
  Curve_arrivals<FT> m_curves;                     // if there are curves
  // Set if there are curves: programs whose sources are points do not compile it.
  std::unique_ptr<Path_run_from_curves<FT>> m_curve_run;
};

// Checks distances and returns a Certificate, which is Geodesic_distance_certificate<TriangleMesh>. `make_shape()`
// tells where the lengths of edges come from (Face_shapes.h). The named parameters are those of the public functions:
// number_of_iterations is the number of reverse runs, and the visitor follows all runs. The radius and the offsets are
// those with which the distances were computed; targets would make distances incomplete, and are not accepted.
// Throws Invalid_geodesic_input for invalid input, never because a distance is wrong. Numbers among the parameters are
// checked before the mesh is read.
template <typename ConcurrencyTag, typename Certificate, typename TriangleMesh, typename VertexDistanceMap,
          typename Sources, typename MakeShape, typename NamedParameters>
Certificate certify_distances(const TriangleMesh& tm, VertexDistanceMap vertex_distance_map, const Sources& sources,
                              MakeShape make_shape, const NamedParameters& np)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  // Numbers of any type will do: the distances may come from a program with another kernel. Where the map is wrong, it
  // is not read below, as the errors of reading it would hide the message.
  constexpr bool are_distances = Is_map_of_numbers<VertexDistanceMap, vertex_descriptor>::value;
  static_assert(are_distances, "distances cannot be read from this argument; it is a property map from the vertices of "
                               "the mesh to numbers, and comes before the sources");

  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  const auto options = distance_options<TriangleMesh>(np);
  check_numbers(options);
  Distance_certifier<double, TriangleMesh, decltype(vim), decltype(fim)> certifier(tm, vim, fim, make_shape(),
                                                                                   obstacles(tm, fim, np));
  certifier.set_sources(sources, options.source_offsets);
  Visitor_parameter<NamedParameters> visitor_parameter(np);
  const auto conditions = certifier.run(
    typename Chunks_for_tag<typename Available_tag<ConcurrencyTag>::type>::type(),
    [&](vertex_descriptor v)
    {
      if constexpr(are_distances)
        return CGAL::to_double(get(vertex_distance_map, v));
      else
        return 0.;
    },
    options.maximum_distance,
    value_parameter<std::size_t>(np, internal_np::number_of_iterations, 4),
    visitor_parameter.visitor());
  return Private_access::make<Certificate>(
    conditions, [&](Vertex_id v) { return certifier.surface().descriptor_or_null(v); });
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DISTANCE_CERTIFIER_H
