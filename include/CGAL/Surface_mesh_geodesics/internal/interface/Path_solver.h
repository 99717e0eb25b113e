// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PATH_SOLVER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PATH_SOLVER_H

// What the class of shortest paths does, in terms of the user's descriptors and of double: the
// intrinsic mesh is built once; a run computes the distances of the vertices, and keeps the windows if
// points inside faces or on edges will be asked for; queries only read.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Path_thinning.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/distance_at_location.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/equal_sources.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/intrinsic_mesh_from_face_graph.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/isoline_tracing.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/path_tracing.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Path_solver
{
public:
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Arrival = Location_arrival<double>;
  using Coordinates = std::array<double, 3>;

  // A point asked for: a vertex, or a point of a face of the refined mesh. What has been asked for as a location
  // inside a face is not on the edges of the first mesh, even if rounding has moved it there in the refined one.
  struct Query
  {
    Vertex_id vertex = null_id;
    Face_id face = null_id;
    Coordinates coordinates{};
    bool is_location = false; // it has been asked for as such
    bool is_in_face = false;  // as one that is not a vertex of the first mesh
    bool is_on_edge = false;  // but on an edge of it
  };

  Path_solver(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim)
    : m_tm(tm), m_vim(vim), m_fim(fim), m_insertion(m_mesh)
  {}

  Path_solver(const Path_solver&) = delete;
  Path_solver& operator=(const Path_solver&) = delete;

  bool has_mesh() const { return m_has_mesh; }

  // Whether the distances of the vertices are known: the last run was complete.
  bool has_run() const { return m_has_run; }

  // reads the user's mesh; throws Invalid_geodesic_input.
  template <typename Shape>
  void build_mesh(Shape shape)
  {
    m_insertion.undo();
    m_has_mesh = false;
    m_has_run = false;
    Intrinsic_mesh_builder<double, TriangleMesh, VertexIndexMap, FaceIndexMap>(m_tm, m_vim, m_fim)
      .build(shape, m_mesh, m_table);
    m_insertion.restart();
    m_has_mesh = true;
  }

  void clear()
  {
    m_insertion.undo();
    m_field = Vertex_distance_field<double>();
    m_field.keeps_images = true;
    m_windows = Edge_window_field<double>();
    m_has_run = false;
  }

  // forgets the mesh as well.
  void forget()
  {
    clear();
    m_has_mesh = false;
    m_statistics = Propagation_statistics();
  }

  // Sources are added after begin_sources(), in the order in which they are numbered.
  void begin_sources()
  {
    clear();
    m_source_vertices.clear();
    m_source_offsets.clear();
    m_located.clear();
  }

  // The distances from a source begin with its offset, which is not negative.
  void add_source(vertex_descriptor v, double offset = 0)
  {
    m_source_vertices.push_back(finder().vertex(v, "source", m_source_vertices.size()));
    m_source_offsets.push_back(offset);
  }

  template <typename FaceLocation>
  void add_source_location(const FaceLocation& location, double offset = 0)
  {
    m_located.push_back(locate_source<double>(finder(), location, m_source_vertices.size()));
    m_source_vertices.push_back(null_id);
    m_source_offsets.push_back(offset);
  }

  // Propagates from the sources. Returns false, and forgets all results, if go_on() does.
  template <typename GoOn>
  bool run(bool keeps_windows, GoOn go_on)
  {
    return keeps_windows ? run_with_keeper([this] { return Window_keeper<double>(m_windows); }, go_on)
                         : run_with_keeper([] { return No_window_keeper(); }, go_on);
  }

  // The same, where make_keeper() returns the keeper. It is called when the sources are in the mesh.
  template <typename MakeKeeper, typename GoOn>
  bool run_with_keeper(MakeKeeper make_keeper, GoOn go_on)
  {
    m_has_run = false;
    insert_sources();
    m_has_run = propagate(m_field, m_number_of_source, make_keeper(), go_on);
    if(!m_has_run)
      clear();
    return m_has_run;
  }

  // Repeats the last run and keeps its windows. Returns false if go_on() does; the windows are unknown then.
  //
  // Results of vertices are not written, only windows and statistics. So other threads may ask for distances and paths
  // at vertices meanwhile. The second run computes the same distances once more, in a field of its own.
  // Requires: has_run().
  template <typename GoOn>
  bool add_windows(GoOn go_on)
  {
    Vertex_distance_field<double> field;
    std::vector<std::uint32_t> number_of_source;
    return propagate(field, number_of_source, Window_keeper<double>(m_windows), go_on);
  }

  const Propagation_statistics& statistics() const { return m_statistics; }

  // the mesh with the sources as vertices, and what is known of its vertices.
  const Intrinsic_mesh<double>& mesh() const { return m_mesh; }
  const Vertex_distance_field<double>& field() const { return m_field; }

  // calls visit(v, u) for vertices v of sources that tie everywhere with an earlier one, at u.
  template <typename Visitor>
  void for_each_equal_source(Visitor visit) const
  {
    std::vector<double> offset;
    for(const double x : m_source_offsets)
      offset.push_back(x / m_mesh.unit());
    internal::for_each_equal_source(m_mesh, m_source_vertices, offset, visit);
  }

  // the vertex at which source i is, and the number of the first source at a vertex.
  Vertex_id source_vertex(std::size_t i) const { return m_source_vertices[i]; }
  std::size_t source_at(Vertex_id v) const { return m_number_of_source[v]; }

  // the user's face, and the coordinates in it, in the order of the user, of a point of a face of the mesh.
  std::pair<face_descriptor, Coordinates> user_location(Face_id f, Coordinates b) const
  {
    const face_descriptor face = m_table.faces[m_insertion.coordinates_in_whole(f, b)];
    const Halfedge_id first = m_table.halfedge_of_face_index[static_cast<std::size_t>(get(m_fim, face))];
    Coordinates user;
    for(unsigned int j = 0; j < 3; ++j)
      user[j] = b[(index_in_face(first) + j) % 3];
    return {face, user};
  }

  // the user's vertex, or the null vertex for a source that is none.
  vertex_descriptor user_vertex(Vertex_id v) const
  {
    return v < m_table.vertices.size() ? m_table.vertices[v] : Graph_traits::null_vertex();
  }

  // the user's face of which a face of the mesh is a part.
  face_descriptor user_face(Face_id f) const { return m_table.faces[m_insertion.whole(f)]; }

  // --- queries: they throw Invalid_geodesic_input for what is not in the mesh ---

  Query query(vertex_descriptor v) const
  {
    Query q;
    q.vertex = finder().vertex(v, "query", 0);
    return q;
  }

  // The same checks before the mesh has been read, as far as indices tell.
  void check_query(vertex_descriptor v) const
  {
    if(!is_vertex_of(v, m_tm, m_vim))
      refuse_vertex("query", 0);
  }

  template <typename BarycentricCoordinates>
  void check_query(face_descriptor f, const BarycentricCoordinates& b) const
  {
    if(f == Graph_traits::null_face())
      refuse_null_face("query", 0);
    if(!(static_cast<std::size_t>(get(m_fim, f)) < num_faces(m_tm))
       || Removed_elements<TriangleMesh>::contain(f, m_tm))
      refuse_face("query", 0);
    intrinsic_coordinates<double>(halfedge_of(0, 0), b, "query", 0);
  }

  // A location with coordinates that are nearly those of a vertex becomes that vertex.
  template <typename BarycentricCoordinates>
  Query query(face_descriptor f, const BarycentricCoordinates& b) const
  {
    const Halfedge_id h = finder().halfedge(f, "query", 0);
    Coordinates c = intrinsic_coordinates<double>(h, b, "query", 0);
    Source_insertion<double>::snap(c);
    Query q;
    q.is_location = true;
    for(unsigned int k = 0; k < 3; ++k)
      if(c[k] == 1)
        q.vertex = corner_vertex(face_of(h), k);
    if(q.vertex != null_id)
      return q;
    q.is_in_face = true;
    q.is_on_edge = c[0] == 0 || c[1] == 0 || c[2] == 0;
    q.face = m_insertion.part_with(face_of(h), c);
    q.coordinates = c;
    for(unsigned int k = 0; k < 3; ++k) // at another source
      if(c[k] == 1)
        q.vertex = m_mesh.face(q.face).vertex[k];
    return q;
  }

  bool needs_windows(const Query& q) const { return q.vertex == null_id; }

  // The arrival at the point; root is null_id if no source reaches it. Knows the windows if it needs
  // them.
  Arrival arrival(const Query& q) const
  {
    if(q.vertex == null_id)
      return arrival_at_location(m_mesh, m_field, m_windows, q.face, q.coordinates);
    Arrival a;
    a.distance = m_field.distance[q.vertex];
    a.root = m_field.arrival[q.vertex].root == null_id ? null_id : q.vertex;
    return a;
  }

  double unit() const { return m_mesh.unit(); }

  // the number of the source from which a path comes.
  std::size_t source_number(const Arrival& a) const
  {
    return m_number_of_source[m_field.source_of(a.root)];
  }

  double distance(vertex_descriptor v) const
  {
    return m_field.distance[m_table.vertex_of_index[static_cast<std::size_t>(get(m_vim, v))]]
         * m_mesh.unit();
  }

  // the path from a point, which is reached, to its source. Throws std::runtime_error if none of the length of the
  // distance has been found.
  Path_steps<double> path(const Query& q, const Arrival& a) const
  {
    Path_steps<double> steps;
    const Path_tracer<double> tracer(m_mesh, m_field);
    const bool is_found = q.vertex != null_id ? tracer.trace_from_vertex(q.vertex, steps)
                                              : tracer.trace_from_location(q.face, q.coordinates, a, steps);
    if(!is_found)
      throw std::runtime_error("Surface_mesh_geodesic_paths: rounding hides the shortest path; the mesh is too "
                               "degenerate");
    return steps;
  }

  // tells a sink of the path from a point, without the point itself if it is a location: vertex(vertex_descriptor),
  // edge(halfedge_descriptor, double t) with t from source to target, source(number) at the end if it is not a
  // vertex, and face(face_descriptor) before each of them but the first if it wants_faces.
  template <typename Sink>
  void tell(const Query& q, const Arrival& a, const Path_steps<double>& steps, Sink& sink) const
  {
    auto tell_item = [&](const Path_item<double>& item)
    {
      if(Sink::wants_faces && item.face != null_id)
        sink.face(m_table.faces[m_insertion.whole(item.face)]);
      if(item.vertex == null_id)
        sink.edge(user_halfedge(item.halfedge), item.t);
      else if(item.vertex < m_table.vertices.size())
        sink.vertex(m_table.vertices[item.vertex]);
      else
        sink.source(source_number(a));
    };
    Path_thinning<double, decltype(tell_item)> thinning(m_mesh, m_insertion, extent_around(steps), tell_item);
    if(q.is_location)
      thinning.begin_behind(place(q));
    for(const Path_step<double>& step : steps)
      thinning.add(step);
    thinning.finish();
  }

  // calls line(points, is_closed) for each line of points at a distance; a point is a pair of a face of
  // the user and three coordinates, in the order of the user's corners. Knows the windows.
  template <typename Line>
  void trace_isolines(double distance, double resolution, Line line) const
  {
    Isoline_tracer<double> tracer(m_mesh, m_field, m_windows, resolution);
    tracer.trace(distance / m_mesh.unit(),
                 [&](const std::vector<Isoline_point<double>>& points, bool is_closed)
    {
      std::vector<std::pair<face_descriptor, Coordinates>> located;
      located.reserve(points.size());
      for(const Isoline_point<double>& p : points)
        located.push_back(user_location(p));
      line(located, is_closed);
    });
  }

private:
  // The extent of the component where a path runs; of no path without faces there is more than one point.
  double extent_around(const Path_steps<double>& steps) const
  {
    const auto it = std::find_if(steps.begin(), steps.end(),
                                 [](const Path_step<double>& step) { return step.face != null_id; });
    return it == steps.end() ? 1 : m_mesh.extent_around(m_insertion.whole(it->face));
  }

  std::pair<face_descriptor, Coordinates> user_location(const Isoline_point<double>& p) const
  {
    Coordinates b{};
    const unsigned int k = index_in_face(p.halfedge);
    b[k] = 1 - p.t;
    b[next_corner(k)] = p.t;
    return user_location(face_of(p.halfedge), b);
  }

  // makes vertices of the sources that are none.
  void insert_sources()
  {
    m_insertion.undo();
    insert_located_sources(m_located, m_insertion, m_source_vertices);
  }

  // the place of a point that has been asked for as a location.
  Path_item<double> place(const Query& q) const
  {
    Path_item<double> item;
    item.face = q.face;
    if(!q.is_in_face)
      item.vertex = q.vertex;
    else if(q.is_on_edge && q.vertex == null_id)
      for(unsigned int k = 0; k < 3; ++k)
        if(q.coordinates[previous_corner(k)] == 0)
          item.local_halfedge = halfedge_of(q.face, k);
    return item;
  }

  Element_finder<double, TriangleMesh, VertexIndexMap, FaceIndexMap> finder() const
  {
    return Element_finder<double, TriangleMesh, VertexIndexMap, FaceIndexMap>(m_table, m_vim, m_fim);
  }

  // the vertex at corner k of a face of the mesh as it was before sources were inserted.
  Vertex_id corner_vertex(Face_id f, unsigned int k) const
  {
    Coordinates c{};
    c[k] = 1;
    const Face_id part = m_insertion.part_with(f, c);
    return m_mesh.face(part).vertex[static_cast<std::size_t>(
      std::max_element(c.begin(), c.end()) - c.begin())];
  }

  // the user's halfedge for a halfedge of the mesh as it was at first.
  halfedge_descriptor user_halfedge(Halfedge_id h) const
  {
    const face_descriptor f = m_table.faces[face_of(h)];
    const Halfedge_id first = m_table.halfedge_of_face_index[static_cast<std::size_t>(get(m_fim, f))];
    halfedge_descriptor result = halfedge(f, m_tm);
    for(unsigned int k = index_in_face(first); k != index_in_face(h); k = next_corner(k))
      result = next(result, m_tm);
    return result;
  }

  // Propagates into a field, and numbers the sources by vertex.
  template <typename Keeper, typename GoOn>
  bool propagate(Vertex_distance_field<double>& field, std::vector<std::uint32_t>& number_of_source, Keeper keeper,
                 GoOn go_on)
  {
    m_windows.reset(keeps(keeper) ? m_mesh.number_of_faces() : 0);
    Distance_propagation<double, All_pruning_rules, Keeper> propagation(m_mesh, field, keeper);
    number_of_source.assign(m_mesh.number_of_vertices(), null_id);
    for(std::size_t i = 0; i < m_source_vertices.size(); ++i)
    {
      const Vertex_id v = m_source_vertices[i];
      const double offset = m_source_offsets[i] / m_mesh.unit();
      if(!(offset < field.distance[v])) // of several at a vertex the nearest counts, or the first one
        continue;
      propagation.add_source(v, offset);
      number_of_source[v] = static_cast<std::uint32_t>(i);
    }
    const double unit = m_mesh.unit();
    const bool is_complete = propagation.run(
      [&](std::size_t visits, double reached) { return go_on(visits, unit * reached); });
    m_statistics = propagation.statistics();
    m_statistics.intrinsic_mesh_bytes += m_mesh.memory() + m_table.memory() + field.memory();
    m_statistics.maximum_window_bytes += keeps(keeper) ? m_windows.memory() : 0;
    return is_complete;
  }

  static constexpr bool keeps(const Window_keeper<double>&) { return true; }
  template <typename Keeper>
  static constexpr bool keeps(const Keeper&)
  {
    return false;
  }

  const TriangleMesh& m_tm;
  VertexIndexMap m_vim;
  FaceIndexMap m_fim;
  Intrinsic_mesh<double> m_mesh;
  Face_graph_correspondence<TriangleMesh> m_table;
  Source_insertion<double> m_insertion;
  std::vector<Vertex_id> m_source_vertices;
  std::vector<double> m_source_offsets;
  std::vector<Located_source<double>> m_located;
  std::vector<std::uint32_t> m_number_of_source; // by vertex of the refined mesh
  Vertex_distance_field<double> m_field;
  Edge_window_field<double> m_windows;
  Propagation_statistics m_statistics;
  bool m_has_mesh = false;
  bool m_has_run = false;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PATH_SOLVER_H
