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

// What `Surface_mesh_geodesic_paths` knows, and when it computes it: the source points, the solver, and how much of
// what the solver knows still fits the source points.
//
// One rule holds for all queries. A query is const, and computes what it needs under a mutex if that is missing. Once
// it is there, a query reads one atomic number and takes no lock, so any number of threads may ask one object.
// Functions that are not const (sources, building, lengths, clear()) need the object for themselves.
//
// Results appear in two steps. The first one gives the distances of all vertices and the paths from them; it runs while
// nobody reads. The second one adds the windows on the edges, which queries at other points read; it writes nothing
// that queries at vertices read, as those may be running in other threads.
//
// Who computes: a query calls prepare(), a build function build(). Both end in compute(), which decides between three
// propagations: of the first stage, of both stages at once, or of the second stage on top of the first one. Path_solver
// runs them.
//
// With Parallel_tag, the thread that computes has helpers. It holds the mutex, so while it waits for them it must not
// start a query of the user (Tbb_team::run()).

#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Path_solver.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Source_point_list.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Surface_locations.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/directions/path_directions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/path_visitors.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariants, between the calls of functions that are not const:
// - m_ready is NOWHERE if the sources, or with sources the lengths, have changed since the last build that succeeded.
// - From AT_VERTICES on, the solver has the results of the vertices for the present sources and lengths, and m_sources
//   the numbers of the sources. An object without sources whose solver has no run is an exception: it is ready and has
//   no results.
// - At EVERYWHERE the solver has the windows as well.
// A const function only raises m_ready, and only under the mutex. A reader loads m_ready with `acquire` before it reads
// anything that a build writes; the build stores it with `release` after the last write.
//
// Traits is a model of SurfaceMeshShortestPathTraits; an object of it is copied, and so are the maps. The mesh is
// referred to. Mesh and maps must be valid as long as the object, and must not change before clear(): writing a path
// reads points from the map. All distances of the interface are in the user's unit.
template <typename Traits, typename VertexIndexMap, typename FaceIndexMap, typename VertexPointMap,
          typename ConcurrencyTag = Sequential_tag>
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
  using Point_3 = typename Locations::Point_3;
  using Barycentric_coordinates = typename Locations::Barycentric_coordinates;
  using Face_location = typename Locations::Face_location;
  using Coordinates = typename Locations::Coordinates;
  using Sources = Source_point_list<Face_location, vertex_descriptor>;
  using Source_point_iterator = typename Sources::Iterator;
  using Result = std::pair<FT, Source_point_iterator>;
  using Solver = Path_solver<Triangle_mesh, VertexIndexMap, FaceIndexMap, ConcurrencyTag>;

  // The stage of the results: where queries can be answered at once. Each value includes those before it.
  enum class Stage { NOWHERE, AT_VERTICES, EVERYWHERE };

  static constexpr std::size_t no_source = (std::numeric_limits<std::size_t>::max)();

  Lazy_path_structure(const Triangle_mesh& tm, VertexIndexMap vertex_index_map, FaceIndexMap face_index_map,
                      VertexPointMap vertex_point_map, const Traits& traits)
    : m_traits(traits), m_tm(tm), m_vertex_index_map(vertex_index_map), m_face_index_map(face_index_map),
      m_vertex_point_map(vertex_point_map), m_solver(tm, vertex_index_map, face_index_map)
  {}

  Lazy_path_structure(const Lazy_path_structure&) = delete;
  Lazy_path_structure& operator=(const Lazy_path_structure&) = delete;

  const Traits& traits() const { return m_traits; }
  const Triangle_mesh& mesh() const { return m_tm; }
  const VertexPointMap& vertex_point_map() const { return m_vertex_point_map; }
  const Sources& sources() const { return m_sources; }
  Coordinates weights(const Barycentric_coordinates& location) const { return Locations::weights(location, m_traits); }

  // --- source points: nothing is rejected here but by build(), as the mesh need not have been read ---

  // Returns whether the results at vertices are missing: source points or lengths have changed, and no build or query
  // has computed them since. Nothing is missing in a new object, as it has no sources.
  bool has_changed() const { return m_ready.load(std::memory_order_acquire) == Stage::NOWHERE; }

  // Add a vertex, or a point of a face. build() rejects an invalid one.
  Source_point_iterator add_source(vertex_descriptor v) { return add_source_point({location_of(v), true, v}); }
  Source_point_iterator add_source(const Face_location& location)
  {
    return add_source_point({location, false, Graph_traits::null_vertex()});
  }

  // Adds a curve, which is copied once, and its offset in the user's unit. build() rejects one of another mesh.
  // The list keeps a function: programs without curves do not compile what runs from curves need.
  template <typename Curve>
  Source_point_iterator add_source_curve(const Curve& curve, double offset)
  {
    check_offsets({offset});
    const auto& s = curve.segments();
    const auto copy = std::make_shared<const Curve>(curve);
    return add_source_point(
      {s.empty() ? location_of(curve.vertex())
                 : Face_location(s[0].face, Locations::coordinates(s[0].source, m_traits)), false,
       Graph_traits::null_vertex(), [this, copy, offset] { m_solver.add_source_curve(*copy, offset); }});
  }

  // Adds vertices or locations. Returns the iterator to the first of them, end() if the range is empty. Copies the
  // range first, as it may consist of sources of this object.
  template <typename InputIterator>
  Source_point_iterator add_sources(InputIterator begin, InputIterator end)
  {
    std::vector<std::decay_t<decltype(*begin)>> range;
    for(; begin != end; ++begin)
      range.push_back(*begin);
    Source_point_iterator first = m_sources.end();
    for(const auto& source : range)
    {
      const Source_point_iterator added = add_source(source);
      if(first == m_sources.end())
        first = added;
    }
    return first;
  }

  // Keeps the source point until the next build, for those who hold its iterator.
  void remove_source(Source_point_iterator it)
  {
    if(m_sources.remove(it))
      set_changed();
  }

  void remove_all_sources()
  {
    while(m_sources.size() > 0)
      remove_source(m_sources.begin());
  }

  // --- building ---

  // Computes what queries in `wanted` need, if it is missing. `run(propagate)` calls propagate(go_on) and returns its
  // result. Returns false if that is false: go_on() has ended the propagation. If building ends early, by that or by an
  // exception, the stage stays as it was, as in a query. Takes no lock, as the object is not shared then.
  template <typename Run>
  bool build(Stage wanted, Run run)
  {
    return is_ready(wanted) || compute(wanted, run);
  }

  bool build(Stage wanted) { return build(wanted, Run_to_the_end()); }

  // Builds, and reports the progress to a visitor that may cancel. The visitor is not called if nothing is missing.
  template <typename Visitor>
  bool build_with_visitor(Stage wanted, Visitor& visitor)
  {
    return build(wanted,
                 [&](auto propagate) { return run_with_visitor(visitor, num_vertices(m_tm), propagate); });
  }

  // Reads the lengths of the edges at once, and forgets all results. Throws Invalid_geodesic_input; then nothing
  // changes. Takes linear time.
  template <typename EdgeLengthMap>
  void use_edge_lengths(EdgeLengthMap edge_length_map)
  {
    m_solver.build_mesh(Shape_from_edge_lengths<double, Triangle_mesh, EdgeLengthMap>(m_tm, edge_length_map));
    set_without_results();
  }

  // Avoid faces or edges from now on, in place of those before, and forget results, mesh and lengths. If they throw
  // Invalid_geodesic_input, nothing changes.
  template <typename Faces>
  void avoid_faces(const Faces& avoided)
  { avoid({flags_of_avoided_faces(m_tm, m_face_index_map, avoided), m_solver.obstacles().walls}); }
  template <typename Edges>
  void avoid_edges(const Edges& avoided)
  { avoid({m_solver.obstacles().is_avoided, walls_of_edges(m_tm, m_face_index_map, avoided)}); }

  // Is a face one of those to avoid? Not if it is none of the mesh.
  bool avoids_face(face_descriptor f) const { return m_solver.is_avoided(f); }

  // Forgets sources, results, mesh and edge lengths. The next build reads points, also if lengths have been in use. The
  // object is ready, as without sources there is nothing to compute.
  void clear()
  {
    m_sources.clear();
    m_solver.forget();
    m_solver.avoid({});
    set_ready(Stage::EVERYWHERE);
  }

  // --- a single query, by a propagation that ends at its point ---

  // Does what sequence() does, for the same results, bit by bit. Takes time for the area that is nearer to the sources
  // than the point. The results are not good for any other query: the stage stays NOWHERE, and so a later query
  // computes. Takes no lock, as the object is not shared. Requires: there are sources; has_changed().
  template <typename Visitor>
  Result single_sequence(vertex_descriptor v, Visitor& visitor)
  {
    return sequence(propagate_to([&] { return m_solver.query(v); }), visitor, [] {});
  }

  template <typename Visitor>
  Result single_sequence(const Face_location& location, Visitor& visitor)
  {
    const Coordinates b = weights(location.second);
    return sequence(propagate_to([&] { return m_solver.query(location.first, b); }), visitor,
                    [&] { visitor(location.first, location.second); });
  }

  // The same without the path.
  Result single_distance(const Face_location& location)
  {
    const Coordinates b = weights(location.second);
    return result(propagate_to([&] { return m_solver.query(location.first, b); }));
  }

  // Returns the statistics of the last propagation. One that only adds windows counts if it is complete. One that an
  // exception has ended does not count. Waits while a query in another thread computes.
  Propagation_statistics statistics() const
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_solver.statistics();
  }

  // --- queries ---

  // All of them throw Invalid_geodesic_input for a vertex or location that is not on the mesh, and what a build throws.
  // If the results are there, a vertex takes constant time (and time for the chain of pseudo-sources that leads to its
  // source), and a location takes time linear in the number of windows around its face.

  // A place is a vertex, or a face and coordinates.
  // Returns the distance and the source point; -1 and end() if no source reaches it.
  template <typename... Place>
  Result distance(const Place&... place) const
  {
    return result(query(place...));
  }

  // Returns the number of the source point, in the order of the list, or no_source.
  template <typename... Place>
  std::size_t nearest_source(const Place&... place) const
  {
    return nearest_source_of(query(place...));
  }

  // Calls the visitor for the vertices, edges and faces of the shortest path. Throws std::runtime_error if rounding
  // hides the path; the visitor has not been called then.
  template <typename Visitor>
  Result sequence(vertex_descriptor v, Visitor& visitor) const
  {
    return sequence(query(v), visitor, [] {});
  }

  // The same from a point of a face. The first call passes the location as it was given.
  template <typename Visitor>
  Result sequence(face_descriptor f, const Barycentric_coordinates& location, Visitor& visitor) const
  {
    return sequence(query(f, location), visitor, [&] { visitor(f, location); });
  }

  // Returns the direction in which the shortest path leaves its source; not a number if no source reaches the point.
  // May throw as sequence() does.
  template <typename... Place>
  double direction_at_source(const Place&... place) const
  {
    return direction_of_path(m_solver, query(place...),
                             [this](std::size_t i) { return m_sources.by_number(i)->first; });
  }

  // Writes the directions of all vertices, not a number for those that no source reaches.
  template <typename VertexDirectionMap>
  void write_directions(VertexDirectionMap vertex_direction_map) const
  {
    prepare(Stage::AT_VERTICES);
    put_directions(m_tm, m_solver, [this](std::size_t i) { return m_sources.by_number(i)->first; },
                   vertex_direction_map);
  }

  // Returns where the shortest path ends; the null face if no source reaches the point. May throw as sequence() does.
  template <typename... Place>
  Face_location end_of_path(const Place&... place) const
  {
    return end_of_path_from(query(place...));
  }

  // Writes the distances of all vertices; -1 for those that no source reaches. (-1 as in the queries, since the value
  // type may be one without infinity.)
  template <typename VertexDistanceMap>
  void write_distances(VertexDistanceMap vertex_distance_map) const
  {
    using Value = typename boost::property_traits<VertexDistanceMap>::value_type;
    prepare(Stage::AT_VERTICES);
    for(const vertex_descriptor v : vertices(m_tm))
    {
      const double d = distance_or_infinity(v);
      put(vertex_distance_map, v, d < std::numeric_limits<double>::infinity() ? Value(d) : Value(-1));
    }
  }

  // Returns the reached vertex with the largest distance, the first of several, and the distance; the null vertex and
  // -1 if no vertex is reached.
  std::pair<vertex_descriptor, FT> farthest_vertex() const
  {
    prepare(Stage::AT_VERTICES);
    std::pair<vertex_descriptor, double> farthest(Graph_traits::null_vertex(), -1.);
    for(const vertex_descriptor v : vertices(m_tm))
    {
      const double d = distance_or_infinity(v);
      if(d > farthest.second && d < std::numeric_limits<double>::infinity())
        farthest = {v, d};
    }
    return {farthest.first, FT(farthest.second)};
  }

  // Writes a polyline for each line of points at the distance `value`, in the user's unit, that is chosen
  // (Isoline_choice.h); see isoline_tracing.h. Returns the output iterator past the last one.
  template <typename Choice, typename OutputIterator>
  OutputIterator write_isolines(double value, const Choice& choice, OutputIterator output) const
  {
    prepare(Stage::EVERYWHERE);
    if(has_results() && m_sources.size() > 0)
    {
      Isoline_writer<Lazy_path_structure, OutputIterator> writer(*this, output);
      m_solver.trace_isolines(value, Tolerance<double>::isoline(), choice(m_solver), std::ref(writer));
      output = writer.output();
    }
    return output;
  }

  // The point of a location given by numbers, for Isoline_writer.
  Point_3 point(face_descriptor f, const Coordinates& b) const
  {
    return Locations::point(f, Locations::coordinates(b, m_traits), m_tm, m_vertex_point_map, m_traits);
  }

private:
  using Query = typename Solver::Query;
  using Arrival = typename Solver::Arrival;

  // For build(): a propagation without a visitor.
  struct Run_to_the_end
  {
    template <typename Propagate>
    bool operator()(Propagate propagate) const
    {
      return propagate([](std::size_t, double) { return true; });
    }
  };

  // --- building ---

  bool is_ready(Stage wanted) const { return m_ready.load(std::memory_order_acquire) >= wanted; }
  void set_ready(Stage stage) const { m_ready.store(stage, std::memory_order_release); }
  void set_changed() { set_ready(Stage::NOWHERE); }

  // The solver has no results now. Without sources none are needed; after sources were removed, a build is still due.
  void set_without_results()
  {
    set_ready(m_sources.size() > 0 || has_changed() ? Stage::NOWHERE : Stage::EVERYWHERE);
  }

  void avoid(Obstacles obstacles)
  {
    m_solver.forget();
    m_solver.avoid(std::move(obstacles));
    set_without_results();
  }

  // Invalid vertices have the null location; build() rejects them.
  Face_location location_of(vertex_descriptor v) const
  {
    return is_vertex_of(v, m_tm, m_vertex_index_map) ? Locations::location(v, m_tm, m_traits)
                                                     : Locations::null_location(m_traits);
  }

  Source_point_iterator add_source_point(const typename Sources::Source& source)
  {
    const Source_point_iterator added = m_sources.add(source);
    set_changed();
    return added;
  }

  // Begins each query: computes what queries in `wanted` need, if it is missing.
  void prepare(Stage wanted) const
  {
    if(is_ready(wanted))
      return;
    // Only const functions hold the mutex, and none of them has a visitor, which could query this object and wait here
    // forever. (In Lazy_Voronoi_diagram, visitors run under the mutex.)
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(!is_ready(wanted)) // another thread may have computed it meanwhile
      compute(wanted, Run_to_the_end());
  }

  // Requires: !is_ready(wanted), and nobody computes, neither another thread nor this one: a visitor must not call the
  // object. If it ends early, what was ready stays ready. The caller holds the mutex, or has the object for itself.
  template <typename Run>
  bool compute(Stage wanted, Run run) const
  {
    CGAL_precondition_msg(!m_computing_thread.is_this(), "a visitor has called the object that is being built");
    const Computing_thread::Scope scope(m_computing_thread);
    const bool adds_windows = is_ready(Stage::AT_VERTICES);
    if(!adds_windows)
      give_sources_to_solver();
    const bool is_complete = run([&](auto go_on)
    { return adds_windows ? m_solver.add_windows(go_on) : m_solver.run(wanted == Stage::EVERYWHERE, go_on); });
    if(!is_complete)
      return false;
    // Numbers and windows have to be complete before a reader learns that they are. The second stage leaves the numbers
    // alone, as readers of the first one may be using them.
    if(!adds_windows)
      m_sources.set_built();
    set_ready(wanted);
    return true;
  }

  // Reads the mesh if that has not been done, and checks all sources. Throws Invalid_geodesic_input. Source points get
  // their numbers in the solver here: their positions in the list. If one is rejected, the results of the build before
  // are lost, which nobody may read any more.
  void give_sources_to_solver() const
  {
    if(!m_solver.has_mesh())
      m_solver.build_mesh(Shape_from_points<double, Triangle_mesh, VertexPointMap>(m_tm, m_vertex_point_map));
    m_solver.begin_sources();
    for(const auto& s : m_sources.sources())
    {
      if(s.add_curve != nullptr)
        s.add_curve();
      else if(s.is_vertex)
        m_solver.add_source(s.vertex);
      else
        m_solver.add_source_location(std::make_pair(s.location.first, weights(s.location.second)));
    }
  }

  template <typename MakeQuery>
  Query propagate_to(MakeQuery make_query)
  {
    CGAL_precondition(has_changed() && m_sources.size() > 0);
    give_sources_to_solver();
    const Query q = m_solver.run_to(make_query);
    m_sources.set_built();
    return q;
  }

  // An object without sources may be ready without results: when it is new, cleared, or has got new lengths.
  // Requires: is_ready(Stage::AT_VERTICES).
  bool has_results() const { return m_solver.has_run(); }

  // --- queries ---

  // Prepares the object for a query at v, and checks v. Without results the mesh need not have been read, so that there
  // is no table to look v up in; its index alone is checked then.
  Query query(vertex_descriptor v) const
  {
    prepare(Stage::AT_VERTICES);
    if(has_results())
      return m_solver.query(v);
    m_solver.check_query(v);
    return Query();
  }

  // The same for a point of a face. A location at a vertex, or at a source that has become one, needs no windows. The
  // first prepare() decides by the coordinates alone whether one propagation shall do for both stages.
  Query query(face_descriptor f, const Barycentric_coordinates& location) const
  {
    const Coordinates b = weights(location);
    prepare(is_at_corner(b) ? Stage::AT_VERTICES : Stage::EVERYWHERE);
    if(!has_results())
    {
      m_solver.check_query(f, b);
      return Query();
    }
    const Query q = m_solver.query(f, b);
    if(m_solver.needs_windows(q))
      prepare(Stage::EVERYWHERE);
    return m_solver.nearest_side(q);
  }

  // Returns whether the location is a vertex of its face, after snapping. Returns false for an invalid
  // location; the query rejects it.
  static bool is_at_corner(Coordinates b)
  {
    if(!are_valid_coordinates(b))
      return false;
    snap_coordinates(b);
    return b[0] == 1 || b[1] == 1 || b[2] == 1;
  }

  static bool is_reached(const Arrival& a) { return a.is_reached(); }

  double distance_or_infinity(vertex_descriptor v) const
  {
    return has_results() ? m_solver.distance(v) : std::numeric_limits<double>::infinity();
  }

  Result result(const Query& q) const { return has_results() ? result_of(m_solver.arrival(q)) : no_result(); }

  Result no_result() const { return Result(FT(-1), m_sources.end()); }

  Result result_of(const Arrival& a) const
  {
    return is_reached(a) ? Result(FT(a.distance * m_solver.unit()), m_sources.by_number(m_solver.source_number(a)))
                         : no_result();
  }

  std::size_t nearest_source_of(const Query& q) const
  {
    if(!has_results())
      return no_source;
    const Arrival a = m_solver.arrival(q);
    return is_reached(a) ? m_solver.source_number(a) : no_source;
  }

  // A source point that is no curve is the end itself, also a vertex without faces.
  Face_location end_of_path_from(const Query& q) const
  {
    Arrival a;
    if(has_results())
      a = m_solver.arrival(q);
    if(!is_reached(a))
      return Locations::null_location(m_traits);
    if(!m_solver.has_curves())
      return *m_sources.by_number(m_solver.source_number(a));
    const auto end = m_solver.end_of_path(m_solver.path(q, a));
    return Face_location(end.first, Locations::coordinates(end.second, m_traits));
  }

  // Traces the path before it calls the visitor, because tracing may throw.
  template <typename Visitor, typename ReportQuery>
  Result sequence(const Query& q, Visitor& visitor, ReportQuery report_query) const
  {
    if(!has_results())
      return no_result();
    const Arrival a = m_solver.arrival(q);
    if(is_reached(a))
    {
      const auto path = m_solver.path(q, a);
      report_query();
      Path_sequence_sink<Lazy_path_structure, Visitor> sink(*this, visitor);
      m_solver.report(q, a, path, sink);
    }
    return result_of(a);
  }

  const Traits m_traits;
  const Triangle_mesh& m_tm;
  VertexIndexMap m_vertex_index_map;
  FaceIndexMap m_face_index_map;
  VertexPointMap m_vertex_point_map;
  // What const queries may compute, under the mutex. m_ready says what readers may read without it.
  mutable std::mutex m_mutex;
  mutable Computing_thread m_computing_thread;
  mutable std::atomic<Stage> m_ready{Stage::EVERYWHERE}; // nothing is missing as long as there are no sources
  mutable Sources m_sources;                               // a build numbers them, and frees those that were removed
  mutable Solver m_solver;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_LAZY_PATH_STRUCTURE_H
