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

// Distances in terms of the user's mesh: it is read once, and then asked from many sources. What the free
// functions build and drop, and what the public solver keeps.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Available_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Repeated_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Parallel_distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Worker_team.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/intrinsic_mesh_from_face_graph.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

inline void check_maximum_distance(double maximum_distance)
{
  if(!(maximum_distance >= 0))
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_RADIUS,
                                 "the maximum distance is negative or not a number");
}

inline void check_offsets(const std::vector<double>& offsets)
{
  for(std::size_t i = 0; i < offsets.size(); ++i)
    if(!(offsets[i] >= 0) || !std::isfinite(offsets[i]))
      throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_OFFSET,
                                   "the offset of source " + std::to_string(i)
                                     + " is negative or not finite", i);
}

// The intrinsic mesh of a mesh of the user, and the way from the user's descriptors to its elements.
template <typename FT, typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Intrinsic_surface
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

public:
  // reads the mesh; throws Invalid_geodesic_input.
  template <typename Shape>
  Intrinsic_surface(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim, Shape shape)
    : m_vim(vim), m_fim(fim)
  {
    Intrinsic_mesh_builder<FT, TriangleMesh, VertexIndexMap, FaceIndexMap>(tm, m_vim, m_fim)
      .build(shape, m_mesh, m_table);
  }

  const Intrinsic_mesh<FT>& mesh() const { return m_mesh; }
  Intrinsic_mesh<FT>& mesh() { return m_mesh; }
  const FT& unit() const { return m_mesh.unit(); }

  std::size_t number_of_vertices() const { return m_table.vertices.size(); }
  vertex_descriptor descriptor(Vertex_id v) const { return m_table.vertices[v]; }

  // of a vertex of the mesh.
  Vertex_id id(vertex_descriptor v) const
  {
    return m_table.vertex_of_index[static_cast<std::size_t>(get(m_vim, v))];
  }

  // checks the descriptor; `what` and `position` name the culprit in the exception.
  Vertex_id checked_id(vertex_descriptor v, const char* what, std::size_t position) const
  {
    return finder().vertex(v, what, position);
  }

  // `offsets`, in the user's unit, are none or one for each source.
  template <typename Sources>
  Source_set<FT> source_set(const Sources& sources, const std::vector<double>& offsets = {}) const
  {
    check_offsets(offsets);
    Source_set<FT> set;
    for_each_source<TriangleMesh>(sources, [&](std::size_t position, const auto& source)
    {
      set.vertices.push_back(null_id);
      if constexpr(Is_vertex<TriangleMesh, std::decay_t<decltype(source)>>::value)
        set.vertices.back() = finder().vertex(source, "source", position);
      else
        set.located.push_back(locate_source<FT>(finder(), source, position));
    });
    if(!offsets.empty() && offsets.size() != set.vertices.size())
      throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_OFFSET,
                                   std::to_string(offsets.size()) + " offsets for "
                                     + std::to_string(set.vertices.size()) + " sources");
    for(const double offset : offsets)
    {
      set.offsets.push_back(FT(FT(offset) / unit()));
      if(!(set.offsets.back() < Vertex_distance_field<FT>::infinity()))
        throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_OFFSET,
                                     "the offset of source " + std::to_string(set.offsets.size() - 1)
                                       + " is too large for a mesh of this extent", set.offsets.size() - 1);
    }
    return set;
  }

  // The vertices of a range, which are called `what` in the exception.
  template <typename Vertices>
  std::vector<Vertex_id> checked_ids(const Vertices& range, const char* what) const
  {
    std::vector<Vertex_id> result;
    for(const vertex_descriptor v : range)
      // NOLINTNEXTLINE(performance-inefficient-vector-operation): a range need not know its size
      result.push_back(checked_id(v, what, result.size()));
    return result;
  }

  std::size_t memory() const { return m_mesh.memory() + m_table.memory(); }

private:
  Element_finder<FT, TriangleMesh, VertexIndexMap, FaceIndexMap> finder() const
  {
    return Element_finder<FT, TriangleMesh, VertexIndexMap, FaceIndexMap>(m_table, m_vim, m_fim);
  }

  VertexIndexMap m_vim;
  FaceIndexMap m_fim;
  Intrinsic_mesh<FT> m_mesh;
  Face_graph_correspondence<TriangleMesh> m_table;
};

template <typename Tag, typename FT, typename Rules>
struct Propagation_for_tag
{
  using type = Distance_propagation<FT, Rules>;
};

#ifdef CGAL_LINKED_WITH_TBB
template <typename FT, typename Rules>
struct Propagation_for_tag<Parallel_tag, FT, Rules>
{
  using type = Parallel_distance_propagation<FT, Rules, Tbb_team>;
};
#endif

template <typename ConcurrencyTag, typename Rules, typename FT, typename TriangleMesh, typename VertexIndexMap,
          typename FaceIndexMap>
class Distance_solver
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Propagation =
    typename Propagation_for_tag<typename Available_tag<ConcurrencyTag>::type, FT, Rules>::type;

public:
  using Surface = Intrinsic_surface<FT, TriangleMesh, VertexIndexMap, FaceIndexMap>;

  static constexpr std::size_t no_source = (std::numeric_limits<std::size_t>::max)();

  template <typename Shape>
  Distance_solver(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim, Shape shape)
    : m_surface(tm, vim, fim, std::move(shape)), m_insertion(m_surface.mesh()),
      m_runner(m_surface.mesh(), m_insertion)
  {}

  Distance_solver(const Distance_solver&) = delete;
  Distance_solver& operator=(const Distance_solver&) = delete;

  const Surface& surface() const { return m_surface; }

  // Returns false if the visitor cancelled: no vertex has been reached then.
  template <typename Sources, typename Options, typename Visitor>
  bool run(const Sources& sources, const Options& options, Visitor& visitor)
  {
    check_maximum_distance(options.maximum_distance);
    Source_set<FT> set = m_surface.source_set(sources, options.source_offsets);
    const std::vector<Vertex_id> targets = m_surface.checked_ids(options.targets, "target");
    Run_limits<FT> limits;
    limits.maximum_distance = FT(options.maximum_distance) / m_surface.unit();
    limits.first_target = targets.data();
    limits.last_target = targets.data() + targets.size();

    Unfinished_run unfinished{&m_runner};
    const double unit = static_cast<double>(m_surface.unit());
    const bool is_complete = run_with_visitor(visitor, m_surface.number_of_vertices(), [&](auto go_on)
    {
      return m_runner.run(set, limits, [&](std::size_t visits, const FT& d)
      { return go_on(visits, unit * static_cast<double>(d)); });
    });
    if(options.statistics != nullptr)
    {
      Propagation_statistics statistics = m_runner.statistics();
      statistics.intrinsic_mesh_bytes += m_surface.memory() + m_runner.field_memory();
      add_statistics(statistics, *options.statistics);
    }
    find_positions_of_sources(set);
    unfinished.runner = nullptr;
    return is_complete;
  }

  // The distance of a vertex of the mesh in the user's unit, infinity if it was not reached.
  FT distance(vertex_descriptor v) const { return m_runner.distance(m_surface.id(v)) * m_surface.unit(); }

  // The position of the source from which the distance of v is measured, or no_source.
  std::size_t nearest_source(vertex_descriptor v) const
  {
    const Vertex_id i = m_surface.id(v);
    if(!(m_runner.distance(i) < Vertex_distance_field<FT>::infinity()))
      return no_source;
    const auto first = std::lower_bound(m_positions.begin(), m_positions.end(),
                                        std::make_pair(m_runner.source_of(i), std::size_t(0)));
    return first->second;
  }

  // calls visit(vertex_descriptor, distance) for all vertices that have been reached.
  template <typename Visit>
  void for_each_vertex_reached(Visit visit) const
  {
    for(const Vertex_id v : m_runner.vertices_reached())
      if(v < m_surface.number_of_vertices() && m_runner.distance(v) < Vertex_distance_field<FT>::infinity())
        visit(m_surface.descriptor(v), FT(m_runner.distance(v) * m_surface.unit()));
  }

private:
  using Runner = Repeated_propagation<Propagation>;

  // No vertex has been reached if a run is left by an exception, whatever part of it or of the visitor throws.
  struct Unfinished_run
  {
    Runner* runner;

    ~Unfinished_run()
    {
      if(runner != nullptr)
        runner->forget();
    }
  };

  // Of the sources at one vertex, the first of those with the smallest offset counts.
  void find_positions_of_sources(const Source_set<FT>& set)
  {
    m_positions.clear();
    for(std::size_t i = 0; i < set.vertices.size(); ++i)
      m_positions.emplace_back(set.vertices[i], i);
    const auto offset = [&](std::size_t i) { return set.offsets.empty() ? FT(0) : set.offsets[i]; };
    using Entry = std::pair<Vertex_id, std::size_t>;
    std::stable_sort(m_positions.begin(), m_positions.end(), [&](const Entry& a, const Entry& b)
                     { return a.first < b.first
                           || (a.first == b.first && offset(a.second) < offset(b.second)); });
    m_positions.erase(std::unique(m_positions.begin(), m_positions.end(),
                                  [](const Entry& a, const Entry& b) { return a.first == b.first; }),
                      m_positions.end());
  }

  Surface m_surface;
  Source_insertion<FT> m_insertion;
  Runner m_runner;
  std::vector<std::pair<Vertex_id, std::size_t>> m_positions; // of sources, sorted by vertex
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DISTANCE_SOLVER_H
