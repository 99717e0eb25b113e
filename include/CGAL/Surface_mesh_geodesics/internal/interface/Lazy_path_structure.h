// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_LAZY_PATH_STRUCTURE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_LAZY_PATH_STRUCTURE_H

// What the class of shortest paths knows, and when it is computed: the source points, the solver, and whether what
// the solver knows still fits the source points. What is asked through a const reference computes nothing, and
// throws std::logic_error where something would have to be computed first.

#include <CGAL/Surface_mesh_geodesics/internal/interface/Path_solver.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Source_point_list.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Surface_locations.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/path_visitors.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename Traits, typename VertexIndexMap, typename FaceIndexMap, typename VertexPointMap>
class Lazy_path_structure
{
public:
  using Locations = Surface_locations<Traits, VertexPointMap>;
  using Triangle_mesh = typename Locations::Triangle_mesh;
  using Graph_traits = typename Locations::Graph_traits;
  using vertex_descriptor = typename Locations::vertex_descriptor;
  using halfedge_descriptor = typename Locations::halfedge_descriptor;
  using face_descriptor = typename Locations::face_descriptor;
  using FT = typename Locations::FT;
  using Barycentric_coordinates = typename Locations::Barycentric_coordinates;
  using Face_location = typename Locations::Face_location;
  using Coordinates = typename Locations::Coordinates;
  using Sources = Source_point_list<Face_location, vertex_descriptor>;
  using Source_point_iterator = typename Sources::Iterator;
  using Result = std::pair<FT, Source_point_iterator>;
  using Solver = Path_solver<Triangle_mesh, VertexIndexMap, FaceIndexMap>;
  using Query = typename Solver::Query;

  static constexpr std::size_t no_source = (std::numeric_limits<std::size_t>::max)();

  Lazy_path_structure(const Triangle_mesh& tm, VertexIndexMap vertex_index_map, FaceIndexMap face_index_map,
                      VertexPointMap vertex_point_map, const Traits& traits)
    : m_traits(traits), m_tm(tm), m_vertex_index_map(vertex_index_map), m_vertex_point_map(vertex_point_map),
      m_solver(tm, vertex_index_map, face_index_map)
  {}

  Lazy_path_structure(const Lazy_path_structure&) = delete;
  Lazy_path_structure& operator=(const Lazy_path_structure&) = delete;

  const Traits& traits() const { return m_traits; }
  const Triangle_mesh& mesh() const { return m_tm; }
  const VertexPointMap& vertex_point_map() const { return m_vertex_point_map; }
  const Sources& sources() const { return m_sources; }
  Sources& sources() { return m_sources; }
  const Solver& solver() const { return m_solver; }
  Coordinates weights(const Barycentric_coordinates& location) const { return Locations::weights(location, m_traits); }

  // --- source points ---

  // A vertex that is none is refused when the structure is built.
  Source_point_iterator add_source(vertex_descriptor v)
  {
    const bool is_vertex = is_vertex_of(v, m_tm, m_vertex_index_map);
    return m_sources.add(
      {is_vertex ? Locations::location(v, m_tm, m_traits) : Locations::null_location(m_traits), v});
  }

  Source_point_iterator add_source(const Face_location& location)
  {
    return m_sources.add({location, Graph_traits::null_vertex()});
  }

  // --- building ---

  // Without sources nothing is ever built.
  bool is_built() const { return m_solver.state() != Solver::State::EMPTY; }

  // builds if source points have changed, or if windows are wanted that have not been kept. Returns false if the
  // visitor cancelled; whatever ends it early, the source points are still to be built then.
  template <typename Visitor>
  bool build(bool wants_windows, Visitor& visitor)
  {
    const bool lacks_windows = wants_windows && is_built() && m_solver.state() != Solver::State::WINDOWS;
    if(!m_sources.has_changed() && !lacks_windows)
      return true;
    m_sources.mark_changed();
    give_sources_to_solver();
    const bool is_complete
      = run_with_visitor(visitor, num_vertices(m_tm), [&](auto go_on) { return m_solver.run(wants_windows, go_on); });
    if(is_complete)
      m_sources.mark_built();
    return is_complete;
  }

  template <typename EdgeLengthMap>
  void use_edge_lengths(EdgeLengthMap edge_length_map)
  {
    if(m_sources.size() > 0)
      m_sources.mark_changed();
    m_solver.build_mesh(Shape_from_edge_lengths<double, Triangle_mesh, EdgeLengthMap>(m_tm, edge_length_map));
  }

  void clear()
  {
    m_sources.clear();
    m_solver.forget();
  }

  void check_built() const
  {
    if(m_sources.has_changed())
      throw std::logic_error("Surface_mesh_geodesic_paths: build_sequence_tree() has not been called "
                             "since source points were changed");
  }

  // for what is built
  void check_windows() const
  {
    if(m_solver.state() != Solver::State::WINDOWS)
      throw std::logic_error("Surface_mesh_geodesic_paths: build_sequence_tree_for_faces() has not been "
                             "called since source points were changed");
  }

  // --- places of queries ---

  Query query(vertex_descriptor v) const
  {
    check_built();
    if(is_built())
      return m_solver.query(v);
    m_solver.check_query(v);
    return Query();
  }

  Query query(face_descriptor f, const Barycentric_coordinates& location) const
  {
    check_built();
    if(!is_built())
    {
      m_solver.check_query(f, weights(location));
      return Query();
    }
    const Query q = m_solver.query(f, weights(location));
    if(m_solver.needs_windows(q))
      check_windows();
    return q;
  }

  // The same, and what the query needs is built first.
  template <typename Visitor>
  Query built_query(Visitor& visitor, vertex_descriptor v)
  {
    build(false, visitor);
    return std::as_const(*this).query(v);
  }

  template <typename Visitor>
  Query built_query(Visitor& visitor, face_descriptor f, const Barycentric_coordinates& location)
  {
    build(!is_at_vertex(weights(location)), visitor);
    if(!is_built())
      return std::as_const(*this).query(f, location);
    const Query q = m_solver.query(f, weights(location));
    if(m_solver.needs_windows(q))
      build(true, visitor);
    return q;
  }

  // --- answers ---

  // infinity if v is not reached
  double distance(vertex_descriptor v) const
  {
    return is_built() ? m_solver.distance(v) : std::numeric_limits<double>::infinity();
  }

  Result result(const Query& q) const { return is_built() ? result_of(m_solver.arrival(q)) : no_result(); }

  std::size_t nearest_source(const Query& q) const
  {
    if(!is_built())
      return no_source;
    const Arrival a = m_solver.arrival(q);
    return is_reached(a) ? m_solver.source_number(a) : no_source;
  }

  template <typename Visitor>
  Result sequence(const Query& q, Visitor& visitor) const
  {
    return sequence(q, visitor, [] {});
  }

  // The visitor is told of the query first, as it was asked.
  template <typename Visitor>
  Result sequence(const Query& q, face_descriptor f, const Barycentric_coordinates& location, Visitor& visitor) const
  {
    return sequence(q, visitor, [&] { visitor(f, location); });
  }

private:
  using Arrival = typename Solver::Arrival;

  static bool is_at_vertex(Coordinates b)
  {
    snap_coordinates(b);
    return b[0] == 1 || b[1] == 1 || b[2] == 1;
  }

  static bool is_reached(const Arrival& a) { return a.root != null_id; }

  void give_sources_to_solver()
  {
    if(!m_solver.has_mesh())
      m_solver.build_mesh(Shape_from_points<double, Triangle_mesh, VertexPointMap>(m_tm, m_vertex_point_map));
    m_solver.begin_sources();
    for(const auto& s : m_sources.sources())
      if(s.vertex != Graph_traits::null_vertex())
        m_solver.add_source(s.vertex);
      else
        m_solver.add_source_location(std::make_pair(s.location.first, weights(s.location.second)));
  }

  Result no_result() const { return Result(FT(-1), m_sources.end()); }

  Result result_of(const Arrival& a) const
  {
    return is_reached(a) ? Result(FT(a.distance * m_solver.unit()), m_sources.by_number(m_solver.source_number(a)))
                         : no_result();
  }

  // A path that cannot be traced throws before the visitor has heard of anything.
  template <typename Visitor, typename TellQuery>
  Result sequence(const Query& q, Visitor& visitor, TellQuery tell_query) const
  {
    if(!is_built())
      return no_result();
    const Arrival a = m_solver.arrival(q);
    if(is_reached(a))
    {
      const auto path = m_solver.path(q, a);
      tell_query();
      Path_sequence_sink<Lazy_path_structure, Visitor> sink(*this, visitor);
      m_solver.tell(q, a, path, sink);
    }
    return result_of(a);
  }

  const Traits m_traits;
  const Triangle_mesh& m_tm;
  VertexIndexMap m_vertex_index_map;
  VertexPointMap m_vertex_point_map;
  Sources m_sources;
  Solver m_solver;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_LAZY_PATH_STRUCTURE_H
