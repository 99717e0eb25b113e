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

// The solver that answers at any point of the surface: it keeps windows if they are wanted, and traces paths and
// isolines. Surface_mesh_geodesic_paths and Surface_mesh_geodesic_Voronoi_diagram are built on it. (Distance_solver,
// for Geodesic_distance_solver, computes distances of vertices alone, again and again.)
//
// The order of use is: build_mesh(), begin_sources(), add_source() for each source, run(), queries. Queries only read;
// several threads may call them at once.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Surface_with_sources.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Path_thinning.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/distance_at_location.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/isoline_tracing.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/path_tracing.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Available_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/curves/Path_run_from_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Propagation_for_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `ConcurrencyTag` tells whether each run uses several threads. All computing is in double, whatever the kernel of the
// user is. Lengths and distances inside are in the unit of the intrinsic mesh; where a parameter or a result is in the
// user's unit, its comment says so.
//
// What is valid when:
// - the mesh from build_mesh() to forget(), with its sources as vertices from run() to the next change of sources;
// - the field while has_run() is true;
// - the windows after a run(), or a call of add_windows(), that was told to keep them and has returned true, until the
//   next run. The caller remembers whether that was done; the class does not check it.
//
// If run() throws (std::bad_alloc, or what go_on() throws), has_run() is false; the mesh and the sources stay. If
// add_windows() throws, the results of vertices stay as well.
template <typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap,
          typename ConcurrencyTag = Sequential_tag>
class Path_solver
{
public:
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Arrival = Location_arrival<double>;
  using Coordinates = std::array<double, 3>;

  using Query = Surface_query;

  Path_solver(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim)
    : m_surface(tm, vim, fim)
  {
    forget_results();
  }

  Path_solver(const Path_solver&) = delete;
  Path_solver& operator=(const Path_solver&) = delete;

  bool has_mesh() const { return user_surface().is_read(); }

  // Returns whether the distances of the vertices are known: the last run was complete.
  bool has_run() const { return m_has_run; }

  // --- building ---

  // Reads the user's mesh, and forgets the sources and the results. Throws Invalid_geodesic_input; then nothing
  // changes.
  template <typename Shape>
  void build_mesh(Shape shape)
  {
    m_surface.read(std::move(shape), typename Blocks_for_tag<Tag>::type());
    m_has_run = false;
  }

  // Avoids faces and edges when the mesh is read the next time (Intrinsic_surface). The mesh that has been read does
  // not change: the caller forgets it first. Requires: !has_mesh().
  void avoid(Obstacles obstacles) { m_surface.avoid(std::move(obstacles)); }
  const Obstacles& obstacles() const { return user_surface().obstacles(); }
  bool is_avoided(face_descriptor f) const { return user_surface().is_avoided(f); }

  // Forgets the mesh, the sources and all results.
  void forget()
  {
    forget_results();
    m_surface.forget();
    m_statistics = Propagation_statistics();
  }

  // Forgets the sources and the results. Sources are numbered in the order in which they are added from now on.
  void begin_sources()
  {
    forget_results();
    m_surface.clear_sources();
    m_curves.clear();
  }

  // Adds a source; throws Invalid_geodesic_input, with `what` in the message. The distances from it begin with its
  // offset, which is finite and not negative, in the user's unit. If it throws, begin_sources() has to follow.
  void add_source(vertex_descriptor v, double offset = 0, const char* what = "source")
  {
    m_surface.add_source(v, offset, what);
  }

  template <typename FaceLocation>
  void add_source_location(const FaceLocation& location, double offset = 0, const char* what = "source")
  {
    m_surface.add_source(location, offset, what);
  }

  // Adds a curve. The results are then those of a single thread, as strips and windows share one wavefront.
  template <typename Curve>
  void add_source_curve(const Curve& curve, double offset, const char* what = "curve")
  {
    m_surface.add_source_curve(curve, offset, what);
    if(m_curve_run == nullptr)
      m_curve_run.reset(new Strip_path_run<double>());
  }

  // Are there curves among the sources? The tests for it are at the level of calls, never inside loops: what points
  // cost does not change.
  bool has_curves() const { return m_surface.has_curves(); }

  // Propagates from the sources, and keeps the windows if they are wanted. Returns false, and forgets all results, if
  // go_on(number of visits, distance in the user's unit) does. Requires: has_mesh(). Without sources, no vertex is
  // reached.
  template <typename GoOn>
  bool run(bool keeps_windows, GoOn go_on)
  {
    return run_with_keeper([&] { return window_keeper(keeps_windows); }, go_on);
  }

  // Does the same with the keeper that make_keeper() returns. Calls it when the sources are vertices of the mesh. A
  // diagram needs the sources as vertices when it starts its keeper. Its keeper has windows of its own, so that queries
  // which need windows have to call add_windows() first.
  template <typename MakeKeeper, typename GoOn>
  bool run_with_keeper(MakeKeeper make_keeper, GoOn go_on)
  {
    m_has_run = false;
    insert_sources();
    m_has_run = propagate(m_field, make_keeper(), Go_on_reference(go_on, unit()));
    if(!m_has_run)
      forget_results();
    return m_has_run;
  }

  // Repeats the last run and keeps its windows. Returns false if go_on() does. If it does or an exception ends the run,
  // the windows are unknown, and the statistics are those of the run before.
  //
  // Results of vertices are not written, only windows and statistics. So other threads may ask for distances and paths
  // at vertices meanwhile. The second run computes the same distances once more, in a field of its own.
  // Requires: has_run().
  template <typename GoOn>
  bool add_windows(GoOn go_on)
  {
    CGAL_assertion(m_has_run);
    const Propagation_statistics statistics = m_statistics; // propagate() replaces them, also if it ends early
    Vertex_distance_field<double> field; // of a second run, which propagate() tells by it
    const bool is_complete = propagate(field, window_keeper(true), Go_on_reference(go_on, unit()));
    if(!is_complete)
      m_statistics = statistics;
    return is_complete;
  }

  // Propagates until the distance of one point is final, and all that its path needs. Returns the query for it, which
  // is make_query(), called when the sources are vertices of the mesh. Only this query may be asked afterwards.
  //
  // A vertex is a target of the propagation. A point of a face waits for the corners of its face first. Their distances
  // bound its own one, and no window beyond that bound leads to it. The margin is that of ties, so that the answer has
  // the same bits as after run(). A vertex of a wall waits for its copies, a point on its edge for everything.
  // Takes time for the area that is nearer to the sources than the point and the corners of its face.
  // Requires: has_mesh(). Throws what make_query() throws.
  template <typename MakeQuery>
  Query run_to(MakeQuery make_query)
  {
    CGAL_assertion(!has_curves());
    m_has_run = false;
    m_surface.insert_sources();
    const Query q = make_query();
    std::vector<Vertex_id> copies(1, q.vertex);
    m_surface.for_each_other_side(q, [&](const Query& other) { copies.push_back(other.vertex); });
    // Rounding may find the vertex of a source on one side of a wall only.
    const bool is_vertex = std::count(copies.begin(), copies.end(), Vertex_id(null_id)) == 0;
    propagate_with(m_field, window_keeper(!is_vertex), [&](auto& propagation)
    {
      Goes_on_always go_on;
      const Go_on_reference always(go_on, 1);
      if(!is_vertex)
        return copies.size() > 1 ? propagation.run(always) : run_to_location(propagation, q, always);
      propagation.set_targets(copies.data(), copies.data() + copies.size());
      return propagation.run(always);
    });
    m_has_run = true;
    const Query nearest = nearest_side(q);
    m_field.final_distance = arrival(nearest).distance;
    return nearest;
  }

  const Propagation_statistics& statistics() const { return m_statistics; }

  // --- the mesh with the sources as vertices, and what is known of its vertices ---

  const Intrinsic_mesh<double>& mesh() const { return m_surface.mesh(); }
  const Vertex_distance_field<double>& field() const { return m_field; }
  // What a run has kept that was told to keep windows.
  const Edge_window_field<double>& windows() const { return m_windows; }
  const Curve_arrivals<double>& curve_arrivals() const { return m_curves; }

  // The factor from lengths inside to those of the user: a power of two.
  double unit() const { return mesh().unit(); }

  // The sources with their vertices; those at walls are listed once more for each other side.
  const Source_set<double>& sources() const { return m_surface.sources(); }

  // Returns the number of the source at v: the first one of those with the smallest offset.
  // Requires: there is a source at v.
  std::size_t source_at(Vertex_id v) const { return m_surface.source_at(v); }

  // Returns the user's face, and the coordinates there in the order of the user's corners.
  std::pair<face_descriptor, Coordinates> user_location(Face_id f, const Coordinates& b) const
  {
    return m_surface.user_location(f, b);
  }

  // Returns the null vertex for a source that is not a vertex of the user.
  vertex_descriptor user_vertex(Vertex_id v) const { return user_surface().descriptor_or_null(v); }

  // Returns the user's face of which a face of the mesh is a part.
  face_descriptor user_face(Face_id f) const { return m_surface.user_face(f); }

  // --- queries: they throw Invalid_geodesic_input for a point that is not on the mesh ---

  Query query(vertex_descriptor v) const { return nearest_side(m_surface.query(v)); }

  // A location at a wall is on one of its sides; nearest_side() may change that.
  template <typename BarycentricCoordinates>
  Query query(face_descriptor f, const BarycentricCoordinates& b) const
  {
    return m_surface.query(f, b);
  }

  // The point of a wall belongs to all of its sides, and a path to it comes on the one that is nearest.
  //
  // Returns the query for the same point on the side of a wall that is nearest to the sources. Requires: the windows
  // are known if needs_windows(q) and there is a run.
  Query nearest_side(const Query& q) const
  {
    Query nearest = q;
    if(m_has_run)
      m_surface.for_each_other_side(q, [&](const Query& other)
      { nearest = arrival(other).distance < arrival(nearest).distance ? other : nearest; });
    return nearest;
  }

  // Calls visit(q) for the same point on each other side of a wall.
  template <typename Visit>
  void for_each_other_side(const Query& q, Visit visit) const { m_surface.for_each_other_side(q, visit); }

  // Make the same checks before the mesh has been read, by indices alone.
  void check_query(vertex_descriptor v) const
  {
    user_surface().check_vertex(v, "the query", Invalid_geodesic_input::no_element);
  }

  template <typename BarycentricCoordinates>
  void check_query(face_descriptor f, const BarycentricCoordinates& b) const
  {
    user_surface().check_location(f, b, "the query", Invalid_geodesic_input::no_element);
  }

  // A point that is not a vertex of the refined mesh: the path to it may come through a window.
  bool needs_windows(const Query& q) const { return q.vertex == null_id; }

  // Returns the arrival at the point, which may not be reached.
  // Requires: the windows are known if needs_windows(q). Takes time linear in the number of windows around the point.
  Arrival arrival(const Query& q) const
  {
    if(q.vertex == null_id)
      return arrival_at_location(mesh(), m_field, m_windows, q.face, q.coordinates, strips());
    Arrival a;
    a.distance = m_field.distance[q.vertex];
    a.root = m_field.arrival[q.vertex].root == null_id ? null_id : q.vertex;
    return a;
  }

  // Returns the number of the source from which a path comes, in the order of addition. Requires: a.is_reached().
  std::size_t source_number(const Arrival& a) const
  {
    return has_curves() ? curve_point(a).curve : source_at(m_field.source_of(a.root));
  }

  // The point of a source from which a path comes, and its place in curves. Require: a.is_reached(), and has_curves().
  Curve_point<double> curve_point(const Arrival& a) const { return curve_point_at(m_curves.curves, curve_place(a)); }
  Curve_place<double> curve_place(const Arrival& a) const
  {
    return a.side != null_id ? place_of_foot(m_curves.curves, Strip_foot<double>{a.side, a.foot})
                             : m_curves.place_of(m_field, a.root);
  }

  // Returns the distance of a vertex of the mesh, in the user's unit. Requires: has_run(). Infinity if no source
  // reaches it. The vertex is not checked.
  double distance(vertex_descriptor v) const
  {
    const auto distance_of = [this](Vertex_id c) { return m_field.distance[c]; };
    return distance_of(user_surface().nearest_copy(v, distance_of)) * unit();
  }

  // Returns the path from a point to its source. Throws std::runtime_error if no path with the length of the distance
  // is found. Requires: the point is reached; `a` is arrival(q). Takes time linear in the number of faces that the path
  // crosses, unless rounding makes a search necessary (Path_tracer).
  Path_steps<double> path(const Query& q, const Arrival& a) const
  {
    Path_steps<double> steps;
    const Path_tracer<double> tracer(mesh(), m_field, has_curves() ? &m_curves : nullptr);
    const bool is_found = q.vertex != null_id ? tracer.trace_from_vertex(q.vertex, steps)
                                              : tracer.trace_from_location(q.face, q.coordinates, a, steps);
    if(!is_found)
      throw std::runtime_error("Surface_mesh_geodesic_paths: the path cannot be traced: rounding error");
    return steps;
  }

  // The next two functions are for paths from points, which have a direction at their source. Requires: !has_curves().
  //
  // Returns the first vertex behind the source at which the path to a vertex bends, or the vertex itself if the path is
  // straight. The paths to both leave the source in the same direction, as the first piece of a shortest path is one,
  // too. Requires: v is reached. Takes time linear in the number of bends.
  Vertex_id end_of_first_piece(Vertex_id v) const
  {
    while(!m_field.is_source(v) && !m_field.is_source(m_field.arrival[v].root))
      v = m_field.arrival[v].root;
    return v;
  }

  // Returns the direction of a departure from a source, in the tangent frame of the source; 0 for a path of no length.
  // It is linear in the angle of the departure, which may be any number. f is the face of the user in which the source
  // lies; it does not matter if the source is a vertex of the mesh. Takes time linear in the degree of the source.
  Direction_at_source direction_of_departure(const Departure<double>& d, face_descriptor f) const
  {
    if(d.halfedge == null_id)
      return {};
    return mesh().source(d.halfedge) < user_surface().number_of_vertices() ? m_surface.direction_at_vertex(d)
                                                                           : m_surface.direction_in_face(d, f);
  }

  // Reports the path from a point to a sink, without the point itself if it is a location. Calls
  // sink.vertex(vertex_descriptor); sink.edge(halfedge_descriptor, t) with t from source to target; at the end, unless
  // the path ends at a vertex or on an edge of the user, sink.source(number) or, on a curve, sink.location(pair of a
  // face and coordinates); and, if Sink::wants_faces, sink.face(face_descriptor) before each of them but the first.
  // Requires: `steps` is path(q, a). (Of sources without offsets only the last one is met, as no shortest path passes
  // them. A path may run through the corners of a curve with a larger offset; they are reported where they are.)
  template <typename Sink>
  void report(const Query& q, const Arrival& a, const Path_steps<double>& steps, Sink& sink) const
  {
    auto report_item = [&](const Path_item<double>& item)
    {
      if(Sink::wants_faces && item.face != null_id)
        sink.face(user_face(item.face));
      if(item.vertex == null_id)
        sink.edge(user_surface().descriptor_of_halfedge(item.halfedge), item.t);
      else if(item.vertex < user_surface().number_of_vertices())
        sink.vertex(user_surface().descriptor(item.vertex));
      else if(has_curves())
        sink.location(location_of_vertex(item.vertex));
      else
        sink.source(source_number(a));
    };
    Path_thinning<double, decltype(report_item)> thinning(mesh(), m_surface.parts(), extent_around(steps), report_item);
    if(q.is_location)
      thinning.begin_behind(m_surface.path_item(q));
    for(const Path_step<double>& step : steps)
      thinning.add(step);
    thinning.finish();
    report_foot(q, steps, sink);
  }

  // Returns the user's location of the point of the sources at which a path ends. Requires: `steps` is path(q, a).
  std::pair<face_descriptor, Coordinates> end_of_path(const Path_steps<double>& steps) const
  {
    const Path_step<double>& end = steps.back();
    if(end.vertex != null_id)
      return location_of_vertex(end.vertex);
    return m_surface.user_location_on_edge(end.halfedge, end.x / mesh().length(end.halfedge));
  }

  // Calls line(points, is_closed) for each line of points at a distance, in the user's unit. A point is a pair of a
  // face of the user and three coordinates, in the order of the user's corners. Requires: the windows are known.
  // `resolution` is the largest error of a point, as a part of the length of its edge. is_wanted(point) tells whether
  // the line of a point is written, which is given as an Isoline_point of the refined mesh.
  template <typename Line, typename IsWanted>
  void trace_isolines(double distance, double resolution, const IsWanted& is_wanted, Line line) const
  {
    Isoline_tracer<double> tracer(mesh(), m_field, m_windows, resolution, strips());
    tracer.trace(distance / mesh().unit(),
                 [&](const std::vector<Isoline_point<double>>& points, bool is_closed)
    {
      if(!is_wanted(points.front()))
        return;
      std::vector<std::pair<face_descriptor, Coordinates>> located;
      located.reserve(points.size());
      for(const Isoline_point<double>& p : points)
        located.push_back(m_surface.user_location_on_edge(p.halfedge, p.t));
      line(located, is_closed);
    });
  }

private:
  using Surface = Surface_with_sources<TriangleMesh, VertexIndexMap, FaceIndexMap>;
  using Tag = typename Available_tag<ConcurrencyTag>::type;

  // The strips of the last run that kept windows; null if there are no curves.
  const Edge_strip_field<double>* strips() const { return has_curves() ? &m_curves.strips : nullptr; }

  // Makes vertices of all sources, and edges of curves.
  void insert_sources()
  {
    if(!has_curves())
      return m_surface.insert_sources();
    m_surface.insert_curves([&](const auto& curves, Source_insertion<double>& insertion)
    { m_curve_run->insert(mesh(), insertion, curves, m_curves); });
  }

  // Ends of paths need it: corners of curves are vertices of the refined mesh that the user does not know.
  //
  // A vertex of the refined mesh as a location of the user. The null face for a vertex without faces.
  std::pair<face_descriptor, Coordinates> location_of_vertex(Vertex_id v) const
  {
    const Halfedge_id h = mesh().halfedge(v);
    if(h == null_id)
      return {Graph_traits::null_face(), Coordinates{}};
    Coordinates b{};
    b[index_in_face(h)] = 1;
    return user_location(face_of(h), b);
  }

  // Reports the end of a path that is at a foot inside of a face of the user: Path_thinning passes over edges that the
  // user does not know, and takes the length of what it passes over for the next point, which is this one. A path
  // without length ends where it begins.
  template <typename Sink>
  void report_foot(const Query& q, const Path_steps<double>& steps, Sink& sink) const
  {
    const Path_step<double>& end = steps.back();
    Halfedge_id h = end.halfedge;
    double t = 0;
    if(end.vertex != null_id || m_surface.parts().find_on_whole_edge(h, t))
      return;
    if(q.is_location && !(length_of(steps) > Tolerance<double>::gap() * extent_around(steps)))
      return;
    if(Sink::wants_faces)
      sink.face(user_face(face_of(end.halfedge)));
    sink.location(end_of_path(steps));
  }

  // The surface as the user knows it: descriptors and their indices.
  const typename Surface::Surface& user_surface() const { return m_surface.surface(); }

  // Returns the extent of the component where a path runs. A path without faces is a single point; any extent will do.
  double extent_around(const Path_steps<double>& steps) const
  {
    const auto it = std::find_if(steps.begin(), steps.end(),
                                 [](const Path_step<double>& step) { return step.face != null_id; });
    return it == steps.end() ? 1 : mesh().extent_around(m_surface.parts().whole(it->face));
  }

  // Frees the memory of the results. Paths need the images of arrivals, so the field is told to keep them.
  void forget_results()
  {
    m_field = Vertex_distance_field<double>();
    m_field.keeps_images = true;
    m_windows.clear();
    m_curves.forget_paths();
    m_has_run = false;
  }

  struct Goes_on_always // of run_to(), which no visitor follows
  {
    bool operator()(std::size_t, double) const { return true; }
  };

  template <typename Propagation>
  bool run_to_location(Propagation& propagation, const Query& q, const Go_on_reference& always)
  {
    const std::array<Vertex_id, 3> corners = mesh().face(q.face).vertex;
    propagation.set_targets(corners.data(), corners.data() + corners.size());
    propagation.run(always);
    propagation.set_targets(nullptr, nullptr);
    const double bound = arrival_at_location(mesh(), m_field, m_windows, q.face, q.coordinates).distance;
    if(!(bound < Vertex_distance_field<double>::infinity()))
      return true; // no source reaches the face
    propagation.set_maximum_distance(bound * (1 + Tolerance<double>::tie()));
    return propagation.run(always);
  }

  // Propagates into a field over all that the sources reach, as long as go_on() wants it. Returns whether it is
  // complete. See run_and_count() for what is reset and counted.
  template <typename Keeper>
  bool propagate(Vertex_distance_field<double>& field, Keeper keeper, const Go_on_reference& go_on)
  {
    if constexpr(std::is_same<Keeper, Window_keeper<double>>::value)
      if(has_curves())
        return propagate_from_curves(field, keeper, go_on);
    return propagate_with(field, keeper, [&](auto& propagation) { return propagation.run(go_on); });
  }

  // Propagates into a field: run(propagation) does so, and returns whether it is complete.
  template <typename Keeper, typename Run>
  bool propagate_with(Vertex_distance_field<double>& field, Keeper keeper, Run run)
  {
    return run_and_count(field, keeper, [&]
    {
      const Source_set<double>& sources = m_surface.sources();
      typename Propagation_for_tag<Tag, double, All_pruning_rules, Keeper>::type propagation(mesh(), field, keeper);
      for(std::size_t i = 0; i < sources.size(); ++i)
        propagation.add_source(sources.vertices[i], sources.offset(i));
      const bool is_complete = run(propagation);
      m_statistics = propagation.statistics();
      return is_complete;
    });
  }

  // The same from curves. The second run of two has a field of its own, so the feet of the first one stay: other
  // threads may be reading them. Nobody reads strips, as windows, before the second run is complete.
  bool propagate_from_curves(Vertex_distance_field<double>& field, const Window_keeper<double>& keeper,
                             const Go_on_reference& go_on)
  {
    return run_and_count(field, keeper, [&]
    { return m_curve_run->run(mesh(), field, keeper, m_curves, &field != &m_field, go_on, m_statistics); });
  }

  // Calls run(), which propagates into the field and sets the statistics. The windows are reset before, as the keeper
  // may not keep any. The memory of mesh and results counts for intrinsic_mesh_bytes, that of kept windows for
  // maximum_window_bytes.
  template <typename Keeper, typename Run>
  bool run_and_count(const Vertex_distance_field<double>& field, const Keeper& keeper, Run run)
  {
    m_windows.reset(keeps(keeper) ? mesh().number_of_faces() : 0);
    const bool is_complete = run();
    m_statistics.intrinsic_mesh_bytes += user_surface().memory() + field.memory() + m_curves.memory();
    m_statistics.maximum_window_bytes += keeps(keeper) ? m_windows.memory() : 0;
    return is_complete;
  }

  // The keeper of all runs but those of a diagram. It has the same type whether it keeps windows or not: the loop of
  // the propagation is a large text, and would be compiled once for each type of keeper.
  Window_keeper<double> window_keeper(bool keeps_windows)
  {
    return keeps_windows ? Window_keeper<double>(m_windows) : Window_keeper<double>();
  }

  // Whether a keeper fills m_windows.
  static bool keeps(const Window_keeper<double>& keeper) { return keeper.keeps_windows(); }
  template <typename Keeper>
  static constexpr bool keeps(const Keeper&)
  {
    return false;
  }

  Surface m_surface;
  Vertex_distance_field<double> m_field;
  Edge_window_field<double> m_windows;
  Curve_arrivals<double> m_curves; // as inserted, and what is known of paths from them
  std::unique_ptr<Path_run_from_curves<double>> m_curve_run; // set if there have been curves
  Propagation_statistics m_statistics;
  bool m_has_run = false;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PATH_SOLVER_H
