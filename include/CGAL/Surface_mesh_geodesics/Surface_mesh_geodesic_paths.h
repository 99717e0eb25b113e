// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_SURFACE_MESH_GEODESIC_PATHS_H
#define CGAL_SURFACE_MESH_GEODESICS_SURFACE_MESH_GEODESIC_PATHS_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Lazy_path_structure.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Surface_locations.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/isolines/Isoline_choice.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/path_visitors.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Default.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Surface_mesh_geodesic_paths` computes exact geodesic distances and shortest paths from one or
more source points, which may be any points of a triangle mesh, to any of its points.

It replaces `Surface_mesh_shortest_path`: it has all types, constructors, member functions and static member functions
that are documented there (in the versions 5.5 to 6.2 of \cgal, which agree), with the same meaning. A program changes
the include and the name of the class, and nothing else.

\code
typedef CGAL::Surface_mesh_shortest_path_traits<Kernel, Triangle_mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_paths<Traits> Surface_mesh_geodesic_paths;

Surface_mesh_geodesic_paths paths(tm);
paths.add_source_point(source);
std::cout << paths.shortest_distance_to_source_points(target).first << "\n";
\endcode

Lengths and distances have the unit of the coordinates of the points, or of the edge lengths.

<b>What is computed when.</b> A query computes what it needs if it is missing, so no program has to call a function that
builds. There are two stages. The first query after source points have changed computes the distances of all vertices
and the paths from them. The first query at a point that is not a vertex also computes the windows on all edges, in
some 40 bytes each. Each stage takes the time of one propagation, which grows with the number of windows, in the worst
case with the square of the number of vertices; see \ref Surface_mesh_geodesics_performance. `build_sequence_tree()`
computes the first stage, `build_sequence_tree_for_faces()` both of them in one propagation. Call one of them to decide
when the time is spent, or to watch the progress. Call the second one before the first query at a vertex if queries at
other points will follow: it saves a propagation.

<b>Thread safety.</b> Queries are `const`. Member functions that are `const`, and static ones, may be called from
several threads at once. If a result is missing, one thread computes it and the others that need it wait. A query whose
results are there takes no lock. Member functions that are not `const` must not run at the same time as any other one,
and a visitor must not call functions of the object that is being built. (This is a precondition, which is checked where
the visitor would compute anew.)

<b>Parallel propagation.</b> With `Parallel_tag` as `ConcurrencyTag`, each propagation runs in the threads of the task
arena of the calling thread, as in `Surface_mesh_geodesics::geodesic_distances()`; queries are answered in the calling
thread. Distances and points of paths do not depend on the number of threads, down to the last
bit. From those with `Sequential_tag` they may differ by rounding; of several equally short paths, the other tag may
report another one. Some more windows are kept than with `Sequential_tag`. The calling thread calls the functions of a
visitor, less often than with `Sequential_tag`. `Parallel_tag` needs TBB.

\code
CGAL::Surface_mesh_geodesic_paths<Traits, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default,
                                  CGAL::Parallel_tag> paths(tm);
\endcode

<b>Exception safety.</b> A build, and so a query that builds, throws what `build_sequence_tree()` throws. Source points
and the iterators to them stay as they were, and so do the results that are there. If an exception or a visitor ends the
first stage early, or the propagation that computes both, `changed_since_last_build()` still returns `true`, and the
next query or build begins anew. If the second stage ends early, the results of the first one stay.

<b>Without source points.</b> A query checks its vertex or location, and answers that no source point reaches it.

<b>Differences from `Surface_mesh_geodesic_Voronoi_diagram`.</b> Both classes follow one rule: `const` functions compute
what is missing under a mutex, and every other function needs the object for itself. This class keeps to the interface
of `Surface_mesh_shortest_path` where that differs from the diagram: its functions that build are not `const`, and a new
object, which has nothing to compute, does not read the mesh. `use_edge_lengths()` reads the lengths and throws at once,
whereas a diagram reads them in its next build. `avoid_faces()` and `avoid_edges()` take the lengths from the points
again here, and keep given lengths in a diagram; `clear()` forgets obstacles here, and keeps them there. Lengths that
are rejected leave this object as it was; a diagram rejects each build until it gets other lengths, or the points by
`use_points()`. `statistics()` builds nothing. The number that stands for "no source point" is the
constant `no_source`; for "no site" it is the function `null_site()`.

<b>Differences from `Surface_mesh_shortest_path`.</b> All of them are intended.

- <em>Answers.</em> Source points on edges lie where they have been put, for each parameter `t`. Several sources in
  faces, queries on border edges, edges without length, isolated vertices and two sources at vertices give the right
  distances.
- <em>Ties.</em> Where several paths are equally short, one of them is reported, with its source point. The original may
  report another one of the same length. Of several source points at one point of the surface the first one is reported.
- <em>Snapping.</em> Barycentric coordinates of source points and queries that are not greater than \f$ 64
  \epsilon \approx 1.4 \cdot 10^{-14} \f$ are taken for zero, and their sum for one. So a location that `locate()` has
  computed for a point at a vertex, or nearer to it than this tolerance, is that vertex, in whichever face it has been
  found.
- <em>Invalid input</em> throws `Surface_mesh_geodesics::Invalid_geodesic_input` from the build or the query, also if
  assertions are switched off. The original asserts, or does not notice. Invalid are: a face that is not a
  triangle; a coordinate of a point that is not finite; a descriptor that is null or not in the mesh; a location
  outside its face, with a coordinate less than \f$ -\delta \f$ or greater than \f$ 1 + \delta \f$ or coordinates
  whose sum differs from one by more than \f$ \delta = \sqrt\epsilon / 16 \approx 9.3 \cdot 10^{-10} \f$. Small
  negative coordinates are valid, and so is the second of two source points at vertices, where the original asserts.
- <em>Paths.</em> A path has at least one point and no point twice in a row. A source point on an edge or at a vertex,
  given as a location, is reported to the visitor as the edge or the vertex. A path that cannot be traced because of
  rounding throws `std::runtime_error`; see the section on path queries.
- <em>Isolated vertices.</em> An isolated vertex may be a source, and is then the only point that it reaches. The
  iterator to it dereferences to a location with a null face. `face_location()` also returns such a location for a
  vertex or an edge without faces. `face_location()` accepts border halfedges.
- <em>Numbers.</em> All computations use `double`, whatever the number type of the traits is. Coordinates are rounded
  with `CGAL::to_double()`, and results are numbers of type `double`, converted to `FT`. The points of a path are
  constructed with the traits. For a face whose height is lost in rounding, `locate()` returns a point of the longest
  side instead of coordinates that are not numbers. `locate()` computes with the trees and the kernel of \cgal, which
  multiply four lengths. Therefore it needs a mesh whose size is between \f$ 10^{-75} \f$ and \f$ 10^{75} \f$, and a
  point that is not farther away; a ray needs a direction that is not larger. If the number type of the kernel is a
  floating point type, it throws `Surface_mesh_geodesics::Invalid_geodesic_input` otherwise. Scale such a mesh by a
  power of two; no bit of a location changes.
- <em>Iterators to source points</em> stay valid when the structure is built again, unless their point has been
  removed. Their types `pointer` and `reference` are those of constants, as the operators return them, and there is a
  `difference_type`. `add_source_points()` takes input iterators, and returns `source_points_end()` for an empty
  range.
- <em>Queries are `const`</em>, see above.
- <em>One more template parameter</em>, the last one: the concurrency tag.
- <em>More members:</em> `build_sequence_tree_for_faces()`, visitors of the progress that may cancel,
  `use_edge_lengths()`, `statistics()`, `nearest_source_point()`, `shortest_distances_to_source_points()`,
  `farthest_vertex()`, `shortest_path_polyline_to_source_points()`, `isolines()`, `signed_isolines()`,
  `add_source_curve()`, `nearest_location_of_sources()`, `direction_at_source()`, `directions_at_source()`,
  `avoid_faces()`, `avoid_edges()`, and the static overload of `build_aabb_tree()` for a mesh and
  a tree, which the original documents but does not have. As `build_sequence_tree()` has an overload for a visitor, a
  program that takes its address has to name the type of the pointer, or to use a lambda.
- <em>Fewer members:</em> objects cannot be copied (copies of the original share memory that each of them frees). The
  undocumented members for debugging do not exist: `m_debugOutput`, and, with assertions, `peak_node_count()`,
  `current_node_count()`, `peak_queue_size()`, `peak_memory_usage()`, `current_memory_usage()`.

\tparam Traits a model of `SurfaceMeshShortestPathTraits` whose points have the members `x()`, `y()` and `z()`,
        which `CGAL::to_double()` accepts, a default constructor, and `operator!=`
\tparam VIM a model of `ReadablePropertyMap` with `vertex_descriptor` as key and `unsigned int` as value type.
        The default is `boost::property_map<Triangle_mesh, boost::vertex_index_t>::%const_type`.
\tparam HIM a model of `ReadablePropertyMap` with `halfedge_descriptor` as key and `unsigned int` as value
        type. It is not used. The default is
        `boost::property_map<Triangle_mesh, boost::halfedge_index_t>::%const_type`.
\tparam FIM a model of `ReadablePropertyMap` with `face_descriptor` as key and `unsigned int` as value type.
        The default is `boost::property_map<Triangle_mesh, boost::face_index_t>::%const_type`.
\tparam VPM a model of `ReadablePropertyMap` with `vertex_descriptor` as key and `Traits::Point_3` as value
        type. The default is `boost::property_map<Triangle_mesh, CGAL::vertex_point_t>::%const_type`.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: whether each propagation uses
        several threads, see above

\sa `Surface_mesh_geodesics::geodesic_distances()`
*/
template <typename Traits, typename VIM = Default, typename HIM = Default, typename FIM = Default,
          typename VPM = Default, typename ConcurrencyTag = Sequential_tag>
class Surface_mesh_geodesic_paths
{
  static_assert(Surface_mesh_geodesics::internal::Checked_traits_class<Traits>::value, "always true, if it compiles");

public:
  /// \name Types
  /// @{

  /// the triangle mesh type.
  using Triangle_mesh = typename Traits::Triangle_mesh;

  /// the graph traits of the triangle mesh.
  using Graph_traits = boost::graph_traits<Triangle_mesh>;

  /// the vertex descriptor type.
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;

  /// the halfedge descriptor type.
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

  /// the face descriptor type.
  using face_descriptor = typename Graph_traits::face_descriptor;

#ifndef DOXYGEN_RUNNING
  using Vertex_index_map = typename Default::Get<
    VIM, typename boost::property_map<Triangle_mesh, boost::vertex_index_t>::const_type>::type;
  using Halfedge_index_map = typename Default::Get<
    HIM, typename boost::property_map<Triangle_mesh, boost::halfedge_index_t>::const_type>::type;
  using Face_index_map = typename Default::Get<
    FIM, typename boost::property_map<Triangle_mesh, boost::face_index_t>::const_type>::type;
  using Vertex_point_map = typename Default::Get<
    VPM, typename boost::property_map<Triangle_mesh, CGAL::vertex_point_t>::const_type>::type;
#else
  /// the vertex index map.
  using Vertex_index_map = VIM;

  /// the halfedge index map.
  using Halfedge_index_map = HIM;

  /// the face index map.
  using Face_index_map = FIM;

  /// the vertex point map.
  using Vertex_point_map = VPM;
#endif

  /// the number type of the traits.
  using FT = typename Traits::FT;

  /// the point type of the traits.
  using Point_3 = typename Traits::Point_3;

  /// an ordered triple of barycentric coordinates.
  using Barycentric_coordinates = typename Traits::Barycentric_coordinates;

#ifndef CGAL_NO_DEPRECATED_CODE
  /// \deprecated use `Barycentric_coordinates`
  using Barycentric_coordinate = Barycentric_coordinates;
#endif

  /// a point of a face: the coordinates are those of `source(halfedge(f,tm),tm)`,
  /// `target(halfedge(f,tm),tm)` and `target(next(halfedge(f,tm),tm),tm)` for the face `f`, in this order.
  using Face_location = std::pair<face_descriptor, Barycentric_coordinates>;

private:
  static_assert(Surface_mesh_geodesics::internal::Maps_of_class<Triangle_mesh, Point_3, Vertex_index_map,
                                                                Face_index_map, Vertex_point_map>::value,
                "always true, if it compiles");

  using Structure
    = Surface_mesh_geodesics::internal::Lazy_path_structure<Traits, Vertex_index_map, Face_index_map, Vertex_point_map,
                                                            ConcurrencyTag>;
  using Locations = Surface_mesh_geodesics::internal::Surface_locations<Traits, Vertex_point_map>;
  using Stage = typename Structure::Stage;
  using Ray_3 = typename Traits::Ray_3;

public:
#ifndef DOXYGEN_RUNNING
  using Source_point_iterator = typename Structure::Source_point_iterator;
#else
  /// a model of `BidirectionalIterator` to access the source points, with `Face_location` as value type;
  /// dereferencing gives a `const Face_location&`. An iterator is valid until `clear()`, and until its point is removed
  /// and the structure built after that.
  class Source_point_iterator
  {};
#endif

  /// the result of a query: the distance and the source point that it is measured from; -1 and
  /// `source_points_end()` if no source point reaches the query point.
  using Shortest_path_result = std::pair<FT, Source_point_iterator>;

  /// the number that stands for "no source point" where source points are numbered.
  static constexpr std::size_t no_source = Structure::no_source;

  /// @}

  /// \name Constructors
  /// They take constant time.
  /// @{

  /// creates an object for a mesh, with the index maps and the point map of the mesh.
  ///
  /// \param tm the mesh, which is referred to, not copied, and must not change before `clear()`. Nothing may be
  ///        assigned to a `Surface_mesh`, as that invalidates the maps that the object keeps.
  /// \param traits an instance of the traits class, which is copied
  /// \pre The faces of `tm` are triangles. (The first build throws otherwise.)
  Surface_mesh_geodesic_paths(const Triangle_mesh& tm, const Traits& traits = Traits())
    : Surface_mesh_geodesic_paths(tm, get(boost::vertex_index, tm), get(boost::halfedge_index, tm),
                                  get(boost::face_index, tm), get(CGAL::vertex_point, tm), traits)
  {}

  /// creates an object for a mesh with maps.
  ///
  /// \param tm the mesh, which is referred to, not copied, and must not change before `clear()`. Nothing may be
  ///        assigned to a `Surface_mesh`, as that invalidates the maps that the object keeps.
  /// \param vertex_index_map gives each vertex an index from 0 to `num_vertices(tm) - 1`
  /// \param halfedge_index_map is not used
  /// \param face_index_map gives each face an index from 0 to `num_faces(tm) - 1`
  /// \param vertex_point_map gives the point of each vertex
  /// \param traits an instance of the traits class, which is copied
  /// \pre The faces of `tm` are triangles. (The first build throws otherwise.)
  Surface_mesh_geodesic_paths(const Triangle_mesh& tm, Vertex_index_map vertex_index_map,
                              Halfedge_index_map halfedge_index_map, Face_index_map face_index_map,
                              Vertex_point_map vertex_point_map, const Traits& traits = Traits())
    : m_structure(tm, vertex_index_map, face_index_map, vertex_point_map, traits)
  {
    static_cast<void>(halfedge_index_map);
  }

  Surface_mesh_geodesic_paths(const Surface_mesh_geodesic_paths&) = delete;
  Surface_mesh_geodesic_paths& operator=(const Surface_mesh_geodesic_paths&) = delete;

  /// @}

  /// \name Addition and Removal of Source Points
  /// The next query or build checks the source points; these functions compute nothing, and check offsets of curves
  /// only. Each source point takes constant time; a curve is copied. Iterators to other source points stay valid.
  /// @{

  /// adds a vertex.
  ///
  /// \param v a vertex of the mesh
  /// \return the iterator to the source point
  Source_point_iterator add_source_point(vertex_descriptor v) { return m_structure.add_source(v); }

  /// adds a point of a face.
  ///
  /// \param f a face of the mesh
  /// \param location the barycentric coordinates of the point in `f`, in the order of `Face_location`
  /// \return the iterator to the source point
  Source_point_iterator add_source_point(face_descriptor f, const Barycentric_coordinates& location)
  {
    return add_source_point(Face_location(f, location));
  }

  /// adds a point of a face.
  ///
  /// \param location a face of the mesh and coordinates in it
  /// \return the iterator to the source point
  Source_point_iterator add_source_point(const Face_location& location) { return m_structure.add_source(location); }

  /// adds all points of a range.
  ///
  /// \tparam InputIterator a model of `InputIterator` with value type `vertex_descriptor` or `Face_location`
  /// \param begin the first point; the range may consist of source points of this object
  /// \param end past the last point
  /// \return the iterator to the first source point that was added, `source_points_end()` if the range is empty
  template <typename InputIterator>
  Source_point_iterator add_source_points(InputIterator begin, InputIterator end)
  {
    return m_structure.add_sources(begin, end);
  }

  /// adds a curve: all of its points are sources. Distances, paths and isolines are then those of the nearest point of
  /// the curve, and exact. A path from the inside of a segment leaves the curve at a right angle. Curves and points may
  /// be mixed. If there is a curve among the source points, a single thread computes, whatever the tag.
  ///
  /// The distances from the curve begin with its offset, as those from a source of `geodesic_distances()`. Queries and
  /// isolines tell distances with offsets; the length of a path is the distance without the offset of the curve at its
  /// end. A path may cross curves whose offset is larger. (A curve of one point is a point with an offset.)
  ///
  /// \tparam Curve `Surface_mesh_geodesics::Surface_curve<Triangle_mesh>`
  /// \param curve a curve on the mesh; it is copied
  /// \param offset the distance of the points of the curve, in the unit of the mesh; finite and not negative
  /// \return the iterator to the source point, whose location is the first point of the curve
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the offset is negative or not finite; nothing changes
  ///         then. (`build_sequence_tree()` throws it if the offset is more than about \f$ 10^{12} \f$ times the extent
  ///         of the mesh.)
  template <typename Curve>
  Source_point_iterator add_source_curve(const Curve& curve, double offset = 0)
  {
    static_assert(Surface_mesh_geodesics::internal::Is_curve<Curve>::value, "the argument is not a Surface_curve");
    static_assert(Surface_mesh_geodesics::internal::Checked_curve<Triangle_mesh, Curve>::value,
                  "always true, if it compiles");
    return m_structure.add_source_curve(curve, offset);
  }

  /// removes a source point. Its iterator may be dereferenced until the next build, but it no longer leads to the next
  /// source point: a loop that removes source points advances its iterator first.
  ///
  /// \param it the iterator to the source point
  /// \pre `it` is an iterator to a source point of this object that has not been removed. (Without the checks of
  /// preconditions, removing a source point twice before the next build has no effect.)
  void remove_source_point(Source_point_iterator it) { m_structure.remove_source(it); }

  /// removes all source points. Their iterators may be dereferenced until the next build.
  void remove_all_source_points() { m_structure.remove_all_sources(); }

  /// @}

  /// \name Building
  /// Queries build what they need; these functions decide when. They compute nothing if nothing is missing. The
  /// iterators to source points that have been removed become invalid when a build has succeeded, by one of these
  /// functions or by a query.
  /// @{

  /// computes what queries at vertices need, if it is missing. Takes the time of a propagation.
  ///
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a source point is invalid
  /// \throws std::bad_alloc if there is not enough memory
  void build_sequence_tree() { m_structure.build(Stage::AT_VERTICES); }

  /// does the same, and reports the progress to a visitor.
  ///
  /// \tparam Visitor a model of `GeodesicPropagationVisitor`
  /// \param visitor is called if there is anything to compute
  /// \return `false` if the visitor canceled
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a source point is invalid; what the visitor
  ///         throws is passed on
  template <typename Visitor>
  bool build_sequence_tree(Visitor& visitor)
  {
    return m_structure.build_with_visitor(Stage::AT_VERTICES, visitor);
  }

  /// computes what queries at any point need, if it is missing. Takes the time of a propagation, and some 40 bytes for
  /// each window.
  ///
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a source point is invalid
  /// \throws std::bad_alloc if there is not enough memory
  void build_sequence_tree_for_faces() { m_structure.build(Stage::EVERYWHERE); }

  /// does the same, and reports the progress to a visitor.
  ///
  /// \tparam Visitor a model of `GeodesicPropagationVisitor`
  /// \param visitor is called if there is anything to compute
  /// \return `false` if the visitor canceled
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a source point is invalid; what the visitor
  ///         throws is passed on
  template <typename Visitor>
  bool build_sequence_tree_for_faces(Visitor& visitor)
  {
    return m_structure.build_with_visitor(Stage::EVERYWHERE, visitor);
  }

  /// takes the lengths of the edges from a map instead of from points. Distances and sequences then need no points;
  /// the points of paths are those of the point map at the same locations. (The object reads the point map of the
  /// constructor only when it needs a point, so any map will do.) All results are dropped, source points are kept. The
  /// lengths are read at once, and used until `clear()`. Takes time linear in the size of the mesh. If the lengths are
  /// rejected, nothing changes: lengths and results stay as they were.
  ///
  /// \tparam EdgeLengthMap a model of `ReadablePropertyMap` with the edge descriptor as key type and a number
  ///         type as value type. The mesh is a model of `EdgeListGraph`, too.
  /// \param edge_length_map gives the length of each edge
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if a length is negative or not finite, or an edge is longer
  ///         than the two others of a face, or a face is not a triangle
  template <typename EdgeLengthMap>
  void use_edge_lengths(EdgeLengthMap edge_length_map)
  {
    m_structure.use_edge_lengths(edge_length_map);
  }

  /// leaves faces out: paths may run along the rim of these faces, not through them, as if the faces were not in the
  /// mesh. Distances are infinite (that is, -1 in queries) where no way leads around them. All else keeps its
  /// descriptors and indices. Source points stay. They and queries may be at the rim, also if their location is given
  /// in a face to avoid; a source point inside is rejected, and so is a location inside. No path leads to a vertex
  /// inside, which may be asked for.
  ///
  /// Call this function before `use_edge_lengths()`: it takes the lengths from the points again.
  ///
  /// \tparam Faces a range of face descriptors, or a model of `ReadablePropertyMap` with the face descriptor as
  ///         key type and `bool` as value type
  /// \param faces_to_avoid the faces, in place of those of the last call; none if the range is empty
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if a face of the range is not one of the mesh; nothing
  ///         changes then
  template <typename Faces>
  void avoid_faces(const Faces& faces_to_avoid)
  {
    m_structure.avoid_faces(faces_to_avoid);
  }

  /// avoids edges: paths may run along these edges, also around the free end of a chain of them, but do not pass from
  /// one side to the other, not even at a vertex inside of the chain. Source points and queries on such an edge belong
  /// to both sides, and so do points of curves; the nearest side counts. All else is as for `avoid_faces()`, and both
  /// may be in use.
  ///
  /// \tparam Edges a range of edge descriptors, or a model of `ReadablePropertyMap` with the edge descriptor as
  ///         key type and `bool` as value type
  /// \param edges_to_avoid the edges, in place of those of the last call; none if the range is empty
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if an edge of the range is not one of the mesh; nothing
  ///         changes then
  template <typename Edges>
  void avoid_edges(const Edges& edges_to_avoid)
  {
    m_structure.avoid_edges(edges_to_avoid);
  }

  /// removes all source points and drops all results; the object is as it was after construction. Call it if the mesh
  /// has changed. All iterators to source points become invalid. Edge lengths are taken from the points
  /// again, and faces and edges to avoid are forgotten.
  ///
  /// The maps of the constructor must still be valid. An assignment to a `Surface_mesh` invalidates its point map; then
  /// construct a new object instead.
  void clear() { m_structure.clear(); }

  /// @}

  /// \name Accessors
  /// They take constant time.
  /// @{

  /// returns an iterator to the first source point. Source points have the order in which they were added.
  Source_point_iterator source_points_begin() const { return m_structure.sources().begin(); }

  /// returns the iterator past the last source point. It stays valid as long as the object.
  Source_point_iterator source_points_end() const { return m_structure.sources().end(); }

  /// returns the number of source points, without those that have been removed.
  std::size_t number_of_source_points() const { return m_structure.sources().size(); }

  /// returns whether the next query at a vertex has to build: source points have been added or removed, or
  /// `use_edge_lengths()`, `avoid_faces()` or `avoid_edges()` has been called while there were source points, and
  /// neither a build function nor a query has computed the distances since. A query that builds resets this, also one
  /// on a constant object. A build that ends early does not.
  bool changed_since_last_build() const { return m_structure.has_changed(); }

  /// @}

  /// \name Statistics
  /// @{

  /// returns what the last propagation that counts did; zeros if there was none since construction, or since the last
  /// call of `clear()`, `avoid_faces()` or `avoid_edges()`. A propagation that computes distances counts if it is
  /// complete and if a visitor cancels it. One that only adds the second stage counts if it is complete. One that an
  /// exception ends does not count. Takes constant time. Waits while a query in another thread computes. Must not run
  /// during a build function.
  Surface_mesh_geodesics::Propagation_statistics statistics() const { return m_structure.statistics(); }

  /// @}

  /// \name Shortest Distance Queries
  /// The distance is the length of the shortest path: a program that wants the length does not need the path.
  /// Queries at a vertex take time linear in the number of vertices at which the path bends, and logarithmic in the
  /// number of source points. Queries at other points take time linear in the number of windows on the three edges of
  /// the face, too. The first query may build, see the class comment.
  ///
  /// The iterators that queries return are valid as long as those of `add_source_point()`.
  /// @{

  /// returns the distance from a vertex to the nearest source point, and that source point.
  ///
  /// \param v a vertex of the mesh
  /// \return the distance and the iterator to the source point, or -1 and `source_points_end()`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v`, the mesh or a source point is invalid
  Shortest_path_result shortest_distance_to_source_points(vertex_descriptor v) const { return m_structure.distance(v); }

  /// returns the distance from a point of a face to the nearest source point, and that source point.
  ///
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \return the distance and the iterator to the source point, or -1 and `source_points_end()`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the location, the mesh or a source point is invalid
  Shortest_path_result shortest_distance_to_source_points(face_descriptor f,
                                                          const Barycentric_coordinates& location) const
  {
    return m_structure.distance(f, location);
  }

  /// returns the number of the source point that is nearest to a vertex, counted from `source_points_begin()`.
  ///
  /// \param v a vertex of the mesh
  /// \return the number, or `no_source` if no source point reaches `v`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v`, the mesh or a source point is invalid
  std::size_t nearest_source_point(vertex_descriptor v) const { return m_structure.nearest_source(v); }

  /// returns the number of the source point that is nearest to a point of a face, counted from `source_points_begin()`.
  ///
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \return the number, or `no_source` if no source point reaches the point
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the location, the mesh or a source point is invalid
  std::size_t nearest_source_point(face_descriptor f, const Barycentric_coordinates& location) const
  {
    return m_structure.nearest_source(f, location);
  }

  /// writes the distances of all vertices to a map, -1 where no source point reaches. Takes time linear in the number
  /// of vertices.
  ///
  /// \tparam VertexDistanceMap a model of `WritablePropertyMap` with `vertex_descriptor` as key type and a number type
  ///         as value type, to which `double` is converted
  /// \param vertex_distance_map gets the distances
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a source point is invalid; nothing is
  ///         written then
  template <typename VertexDistanceMap>
  void shortest_distances_to_source_points(VertexDistanceMap vertex_distance_map) const
  {
    constexpr bool is_map
      = Surface_mesh_geodesics::internal::Is_map_for_numbers<VertexDistanceMap, vertex_descriptor>::value;
    static_assert(is_map, "distances cannot be written to this argument; it is a property map from the vertices of the "
                          "mesh to numbers");
    if constexpr(is_map)
      m_structure.write_distances(vertex_distance_map);
  }

  /// returns the vertex that is farthest from the source points among those that they reach, and its
  /// distance. Takes time linear in the number of vertices.
  ///
  /// \return the vertex, the first one in the order of `vertices(tm)` if several are equally far, and its distance; the
  ///         null vertex and -1 if no vertex is reached
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a source point is invalid
  std::pair<vertex_descriptor, FT> farthest_vertex() const { return m_structure.farthest_vertex(); }

  /// returns where the shortest path from a vertex ends: the point of the source points and curves that is nearest.
  /// Takes the time of the path.
  ///
  /// \param v a vertex of the mesh
  /// \return a face and coordinates in it; the null face if no source point reaches the vertex
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v`, the mesh or a source point is invalid
  /// \throws std::runtime_error if rounding hides the path
  Face_location nearest_location_of_sources(vertex_descriptor v) const { return m_structure.end_of_path(v); }

  /// returns where the shortest path from a point of a face ends.
  ///
  /// \param f a face of the mesh
  /// \param location the barycentric coordinates of the point in `f`
  /// \return a face and coordinates in it; the null face if no source point reaches the point
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the point, the mesh or a source point is invalid
  /// \throws std::runtime_error if rounding hides the path
  Face_location nearest_location_of_sources(face_descriptor f, const Barycentric_coordinates& location) const
  {
    return m_structure.end_of_path(f, location);
  }

  /// @}

  /// \name Shortest Path Sequence Queries
  /// A path is reported from the query point to the source point. Nothing is reported if there is none. Tracing it
  /// takes time linear in the number of edges that it crosses, beyond the time of a distance query.
  ///
  /// The length of the path is the distance that is returned, up to \f$ 10^{-10} \f$ of it, or up to the
  /// rounding of the largest extent of the mesh (64 epsilon) if that is more. This is checked while the path is traced.
  /// Two points that follow each other lie in a common face. On faces whose height or whose sides are lost in the
  /// rounding of coordinates, rounding can lead the straight line astray. Then the path is searched for among all paths
  /// through the faces nearby, which takes longer. If that search finds no path of the right length, or has to give
  /// up, path queries throw `std::runtime_error` before they report anything. No such mesh is known.
  /// @{

  /// reports the vertices, edges and faces of the shortest path from a vertex.
  ///
  /// \tparam Visitor a model of `SurfaceMeshShortestPathVisitor`
  /// \param v a vertex of the mesh
  /// \param visitor is called for `v` first, for the source point last
  /// \return the distance and the iterator to the source point, or -1 and `source_points_end()`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v`, the mesh or a source point is invalid
  /// \throws std::runtime_error if rounding hides the path
  template <typename Visitor>
  Shortest_path_result shortest_path_sequence_to_source_points(vertex_descriptor v, Visitor& visitor) const
  {
    return m_structure.sequence(v, visitor);
  }

  /// reports the vertices, edges and faces of the shortest path from a point of a face.
  ///
  /// \tparam Visitor a model of `SurfaceMeshShortestPathVisitor`
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \param visitor is called as `visitor(f, location)` first, for the source point last
  /// \return the distance and the iterator to the source point, or -1 and `source_points_end()`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the location, the mesh or a source point is invalid
  /// \throws std::runtime_error if rounding hides the path
  template <typename Visitor>
  Shortest_path_result shortest_path_sequence_to_source_points(face_descriptor f,
                                                               const Barycentric_coordinates& location,
                                                               Visitor& visitor) const
  {
    return m_structure.sequence(f, location, visitor);
  }

  /// @}

  /// \name Shortest Path Point Queries
  /// The points are those of the elements that a visitor gets, in the same order, without a point that rounding
  /// makes equal to the one before. The time is that of the sequence. Nothing is written if there is no path.
  /// @{

  /// writes the points of the shortest path from a vertex.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` that takes `Point_3`
  /// \param v a vertex of the mesh
  /// \param output gets the points
  /// \return the distance and the iterator to the source point, or -1 and `source_points_end()`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v`, the mesh or a source point is invalid
  /// \throws std::runtime_error if rounding hides the path
  template <typename OutputIterator>
  Shortest_path_result shortest_path_points_to_source_points(vertex_descriptor v, OutputIterator output) const
  {
    Point_writer<OutputIterator> writer(*this, output);
    return m_structure.sequence(v, writer);
  }

  /// writes the points of the shortest path from a point of a face.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` that takes `Point_3`
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \param output gets the points
  /// \return the distance and the iterator to the source point, or -1 and `source_points_end()`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the location, the mesh or a source point is invalid
  /// \throws std::runtime_error if rounding hides the path
  template <typename OutputIterator>
  Shortest_path_result shortest_path_points_to_source_points(face_descriptor f,
                                                             const Barycentric_coordinates& location,
                                                             OutputIterator output) const
  {
    Point_writer<OutputIterator> writer(*this, output);
    return m_structure.sequence(f, location, writer);
  }

  /// writes the shortest path from a vertex as points with faces: each point with the face of the segment that leads to
  /// it, the first one with the null face.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` that takes `std::pair<Point_3, face_descriptor>`
  /// \param v a vertex of the mesh
  /// \param output gets the points
  /// \return the distance and the iterator to the source point, or -1 and `source_points_end()`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v`, the mesh or a source point is invalid
  /// \throws std::runtime_error if rounding hides the path
  template <typename OutputIterator>
  Shortest_path_result shortest_path_polyline_to_source_points(vertex_descriptor v, OutputIterator output) const
  {
    Polyline_writer<OutputIterator> writer(*this, output);
    return m_structure.sequence(v, writer);
  }

  /// writes the shortest path from a point of a face in the same way.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` that takes `std::pair<Point_3, face_descriptor>`
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \param output gets the points
  /// \return the distance and the iterator to the source point, or -1 and `source_points_end()`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the location, the mesh or a source point is invalid
  /// \throws std::runtime_error if rounding hides the path
  template <typename OutputIterator>
  Shortest_path_result shortest_path_polyline_to_source_points(face_descriptor f,
                                                               const Barycentric_coordinates& location,
                                                               OutputIterator output) const
  {
    Polyline_writer<OutputIterator> writer(*this, output);
    return m_structure.sequence(f, location, writer);
  }

  /// @}

#ifndef DOXYGEN_RUNNING
  // The queries of Surface_mesh_shortest_path are not const. These overloads have its signatures, for programs that
  // take the address of a member. Each calls the const query.
  Shortest_path_result shortest_distance_to_source_points(vertex_descriptor v)
  {
    return std::as_const(*this).shortest_distance_to_source_points(v);
  }

  Shortest_path_result shortest_distance_to_source_points(face_descriptor f, const Barycentric_coordinates& location)
  {
    return std::as_const(*this).shortest_distance_to_source_points(f, location);
  }

  template <typename Visitor>
  Shortest_path_result shortest_path_sequence_to_source_points(vertex_descriptor v, Visitor& visitor)
  {
    return std::as_const(*this).shortest_path_sequence_to_source_points(v, visitor);
  }

  template <typename Visitor>
  Shortest_path_result shortest_path_sequence_to_source_points(face_descriptor f,
                                                               const Barycentric_coordinates& location,
                                                               Visitor& visitor)
  {
    return std::as_const(*this).shortest_path_sequence_to_source_points(f, location, visitor);
  }

  template <typename OutputIterator>
  Shortest_path_result shortest_path_points_to_source_points(vertex_descriptor v, OutputIterator output)
  {
    return std::as_const(*this).shortest_path_points_to_source_points(v, output);
  }

  template <typename OutputIterator>
  Shortest_path_result shortest_path_points_to_source_points(face_descriptor f,
                                                             const Barycentric_coordinates& location,
                                                             OutputIterator output)
  {
    return std::as_const(*this).shortest_path_points_to_source_points(f, location, output);
  }
#endif

  /// \name Directions at the Source
  /// With the distance, the direction is the logarithmic map. Directions are those of
  /// `Surface_mesh_geodesics::trace_geodesic()`, which documents them. At a pinched vertex, and at a source on a wall,
  /// the direction is that at the location of the source in the face into which the path leaves. Tracing from there in
  /// that direction, by the distance, leads back to the point if the path bends nowhere; a path that bends at a vertex
  /// is left there.
  /// @{

  /// returns the direction in which the shortest path from a vertex to its source point arrives there, seen from the
  /// source: the direction in which the path leaves the source. The time is that of the straight piece of the path that
  /// begins at the source.
  ///
  /// \param v a vertex of the mesh
  /// \return the angle, in \f$ [0, 2\pi) \f$, or, if the source is a vertex of the border, from 0 to the angle of the
  ///         faces there; 0 at the source itself, and not a number (NaN) if no source point reaches `v`, or if there is
  ///         a curve among the source points
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v`, the mesh or a source point is invalid
  /// \throws std::runtime_error if rounding hides the path
  double direction_at_source(vertex_descriptor v) const { return m_structure.direction_at_source(v); }

  /// returns the same for the shortest path from a point of a face.
  ///
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \return the angle, as above
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the location, the mesh or a source point is invalid
  /// \throws std::runtime_error if rounding hides the path
  double direction_at_source(face_descriptor f, const Barycentric_coordinates& location) const
  {
    return m_structure.direction_at_source(f, location);
  }

  /// writes the direction at the source for each vertex of the mesh: the values of one call for each vertex, up to
  /// rounding (1e-12; more where the mesh has faces with nearly no height); of several shortest paths, another one may
  /// count. All paths behind a bend share the straight piece that begins at the source, and where the surface is flat,
  /// these pieces share what they cross. So the time is usually less than that of the distances. All values are not a
  /// number (NaN) if there is a curve among the source points.
  ///
  /// \tparam VertexDirectionMap a model of `WritablePropertyMap` with `vertex_descriptor` as key type and a floating
  ///         point type as value type
  /// \param vertex_direction_map gets the directions
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a source point is invalid
  /// \throws std::runtime_error if rounding hides a path
  template <typename VertexDirectionMap>
  void directions_at_source(VertexDirectionMap vertex_direction_map) const
  {
    constexpr bool is_map
      = Surface_mesh_geodesics::internal::Is_map_for_numbers<VertexDirectionMap, vertex_descriptor>::value;
    static_assert(is_map, "directions cannot be written to this argument; it is a property map from the vertices of "
                          "the mesh to numbers");
    if constexpr(is_map)
      m_structure.write_directions(vertex_direction_map);
  }

  /// @}

  /// \name Lines of Equal Distance
  /// @{

  /// writes the lines of all points at the distance `value` from the source points as polylines. No point comes twice
  /// in a row. A closed line ends with its first point; any other one begins and ends at the border. Nearer points are
  /// on the left of a line.
  ///
  /// The points on edges have an error of at most \f$ 10^{-12} \f$ of the length of the edge, or of the rounding of the
  /// distance if that is more. Chords in the faces join them: a chord of length c is nearer than the line by up to
  /// about c<sup>2</sup> / (8 r), where r is the distance of the line from the vertex at which its paths begin or bend
  /// last, and by nothing where paths are parallel. Where paths from two sides meet in a face, the chord cuts off the
  /// corner of the line. A vertex at the distance `value` is a point of the lines that separate nearer points from
  /// farther ones there. If all points around it are nearer, it is a point by itself and is not written. Two crossings
  /// of an edge that are nearer to each other than \f$ 10^{-4} \f$ of its length may be left out. So may a closed line
  /// that meets no edge, around a point that is farther than all edges of its face.
  /// There is no line where no source point reaches, and none for a value that is zero, negative, infinite or not a
  /// number. Takes time linear in the number of faces, and a number of face queries around each point.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` that takes `std::vector<Point_3>`
  /// \param value the distance, in the unit of the mesh
  /// \param output gets a polyline for each line
  /// \return the output iterator past the last polyline
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a source point is invalid
  template <typename OutputIterator>
  OutputIterator isolines(const FT& value, OutputIterator output) const
  {
    return m_structure.write_isolines(CGAL::to_double(value), Surface_mesh_geodesics::internal::All_isolines(), output);
  }

  /// writes those isolines of curves that lie on one side: the lines of all points with the signed distance `value`, as
  /// `Surface_mesh_geodesics::signed_geodesic_distances()` defines it. A negative value stands for the lines at the
  /// distance `-value` on the left of the first curve, a positive one for those on the other side. The curves have to
  /// separate the surface, so that each line is on one side.
  ///
  /// The lines are those of `isolines()` for the distance without its sign, in the same order and direction: points
  /// nearer to the curves are on the left of a line. The side of a line is exact: the faces that it runs through decide
  /// it, and no distance. There is no line for 0, which is that of the curves. Takes the time of `isolines()`.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` that takes `std::vector<Point_3>`
  /// \param value the signed distance, in the unit of the mesh
  /// \param output gets a polyline for each line
  /// \return the output iterator past the last polyline
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a source point is invalid; if there are
  ///         source points, but no curve among them, or the curves do not separate the surface (`INVALID_CURVE`); if a
  ///         source point has an offset other than 0 (`INVALID_OFFSET`). Nothing is written then.
  template <typename OutputIterator>
  OutputIterator signed_isolines(const FT& value, OutputIterator output) const
  {
    const double distance = CGAL::to_double(value);
    return m_structure.write_isolines(
      std::abs(distance), Surface_mesh_geodesics::internal::Isolines_on_side{distance < 0}, output);
  }

  /// @}

  /// \name Surface Point Constructions
  /// They take constant time.
  /// @{

  /// returns the point with the given coordinates in a face.
  ///
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \pre `f` is a triangle of the mesh (this is not checked, here and below).
  Point_3 point(face_descriptor f, const Barycentric_coordinates& location) const
  {
    return point(f, location, m_structure.mesh(), m_structure.vertex_point_map(), m_structure.traits());
  }

  /// does the same without an object, with the point map of the mesh.
  ///
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \param tm the mesh
  /// \param traits an instance of the traits class
  /// \pre `f` is a triangle of the mesh.
  static Point_3 point(face_descriptor f, const Barycentric_coordinates& location, const Triangle_mesh& tm,
                       const Traits& traits = Traits())
  {
    return point(f, location, tm, get(CGAL::vertex_point, tm), traits);
  }

  /// does the same without an object, with a point map.
  ///
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \param tm the mesh
  /// \param vertex_point_map gives the point of each vertex
  /// \param traits an instance of the traits class
  /// \pre `f` is a triangle of the mesh.
  static Point_3 point(face_descriptor f, const Barycentric_coordinates& location, const Triangle_mesh& tm,
                       Vertex_point_map vertex_point_map, const Traits& traits = Traits())
  {
    return Locations::point(f, location, tm, vertex_point_map, traits);
  }

  /// returns a point of a halfedge.
  ///
  /// \param he a halfedge of the mesh
  /// \param t the position of the point: 0 for the source of `he`, 1 for its target
  Point_3 point(halfedge_descriptor he, const FT t) const
  {
    return point(he, t, m_structure.mesh(), m_structure.vertex_point_map(), m_structure.traits());
  }

  /// does the same without an object, with the point map of the mesh.
  ///
  /// \param he a halfedge of the mesh
  /// \param t the position of the point: 0 for the source of `he`, 1 for its target
  /// \param tm the mesh
  /// \param traits an instance of the traits class
  static Point_3 point(halfedge_descriptor he, const FT t, const Triangle_mesh& tm, const Traits& traits = Traits())
  {
    return point(he, t, tm, get(CGAL::vertex_point, tm), traits);
  }

  /// does the same without an object, with a point map.
  ///
  /// \param he a halfedge of the mesh
  /// \param t the position of the point: 0 for the source of `he`, 1 for its target
  /// \param tm the mesh
  /// \param vertex_point_map gives the point of each vertex
  /// \param traits an instance of the traits class
  static Point_3 point(halfedge_descriptor he, const FT t, const Triangle_mesh& tm, Vertex_point_map vertex_point_map,
                       const Traits& traits = Traits())
  {
    return Locations::point(he, t, tm, vertex_point_map, traits);
  }

  /// returns the point of a vertex, with the type that `get()` has for the point map.
  ///
  /// \param v a vertex of the mesh
  decltype(auto) point(vertex_descriptor v) const { return get(m_structure.vertex_point_map(), v); }

  /// does the same without an object, with the point map of the mesh.
  ///
  /// \param v a vertex of the mesh
  /// \param tm the mesh
  static decltype(auto) point(vertex_descriptor v, const Triangle_mesh& tm) { return get(CGAL::vertex_point, tm, v); }

  /// @}

  /// \name Surface Face Location Constructions
  /// They take time linear in the number of faces around the vertex, constant time for a point of a halfedge.
  /// @{

  /// returns the location of a vertex, in a face around it.
  ///
  /// \param v a vertex of the mesh
  /// \return the location; its face is the null face if there is no face around `v`
  Face_location face_location(vertex_descriptor v) const
  {
    return face_location(v, m_structure.mesh(), m_structure.traits());
  }

  /// does the same without an object.
  ///
  /// \param v a vertex of the mesh
  /// \param tm the mesh
  /// \param traits an instance of the traits class
  /// \return the location; its face is the null face if there is no face around `v`
  static Face_location face_location(vertex_descriptor v, const Triangle_mesh& tm, const Traits& traits = Traits())
  {
    return Locations::location(v, tm, traits);
  }

  /// returns the location of a point of a halfedge, in the face of the halfedge, or in that of its opposite if it
  /// is a border halfedge.
  ///
  /// \param he a halfedge of the mesh
  /// \param t the position of the point: 0 for the source of `he`, 1 for its target
  /// \return the location; its face is the null face if there is no face on either side
  Face_location face_location(halfedge_descriptor he, const FT t) const
  {
    return face_location(he, t, m_structure.mesh(), m_structure.traits());
  }

  /// does the same without an object.
  ///
  /// \param he a halfedge of the mesh
  /// \param t the position of the point: 0 for the source of `he`, 1 for its target
  /// \param tm the mesh
  /// \param traits an instance of the traits class
  /// \return the location; its face is the null face if there is no face on either side
  static Face_location face_location(halfedge_descriptor he, const FT t, const Triangle_mesh& tm,
                                     const Traits& traits = Traits())
  {
    return Locations::location(he, t, tm, traits);
  }

  /// @}

  /// \name Nearest Face Location Queries
  /// Functions without a tree as parameter build one at each call, in \cgalBigO{n \log n} time for \f$ n \f$ faces; a
  /// query of a tree takes \cgalBigO{\log n} time in practice. A tree does not depend on source points, and is valid as
  /// long as the mesh does not change. It has all faces, also those to avoid: a location inside of these is rejected by
  /// the query that gets it.
  ///
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the number type of the kernel is a floating point type
  ///         and the mesh, the point or the ray is too large or too small for it, see above (`NON_FINITE_POINT`)
  /// @{

  /// returns the location on the mesh that is nearest to a point.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param p a point
  /// \pre The mesh has a face.
  template <typename AABBTraits>
  Face_location locate(const Point_3& p) const
  {
    return locate<AABBTraits>(p, m_structure.mesh(), m_structure.vertex_point_map(), m_structure.traits());
  }

  /// does the same without an object.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param p a point
  /// \param tm the mesh
  /// \param vertex_point_map gives the point of each vertex
  /// \param traits an instance of the traits class
  /// \pre The mesh has a face.
  template <typename AABBTraits>
  static Face_location locate(const Point_3& p, const Triangle_mesh& tm, Vertex_point_map vertex_point_map,
                              const Traits& traits = Traits())
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tm, tree, vertex_point_map);
    return locate(p, tree, tm, vertex_point_map, traits);
  }

  /// returns the location on the mesh that is nearest to a point, with a tree of the faces.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param p a point
  /// \param tree a tree that `build_aabb_tree()` has built
  /// \pre The mesh has a face.
  template <typename AABBTraits>
  Face_location locate(const Point_3& p, const AABB_tree<AABBTraits>& tree) const
  {
    return locate(p, tree, m_structure.mesh(), m_structure.vertex_point_map(), m_structure.traits());
  }

  /// does the same without an object.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param p a point
  /// \param tree a tree that `build_aabb_tree()` has built
  /// \param tm the mesh
  /// \param vertex_point_map gives the point of each vertex
  /// \param traits an instance of the traits class
  /// \pre The mesh has a face.
  template <typename AABBTraits>
  static Face_location locate(const Point_3& p, const AABB_tree<AABBTraits>& tree, const Triangle_mesh& tm,
                              Vertex_point_map vertex_point_map, const Traits& traits = Traits())
  {
    return Locations::locate(p, tree, tm, vertex_point_map, traits);
  }

  /// returns the location where a ray meets the mesh first. Faces in whose plane the ray lies do not count.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param ray a ray
  /// \return the location; its face is the null face if the ray does not meet the mesh
  template <typename AABBTraits>
  Face_location locate(const Ray_3& ray) const
  {
    return locate<AABBTraits>(ray, m_structure.mesh(), m_structure.vertex_point_map(), m_structure.traits());
  }

  /// does the same without an object.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param ray a ray
  /// \param tm the mesh
  /// \param vertex_point_map gives the point of each vertex
  /// \param traits an instance of the traits class
  /// \return the location; its face is the null face if the ray does not meet the mesh
  template <typename AABBTraits>
  static Face_location locate(const Ray_3& ray, const Triangle_mesh& tm, Vertex_point_map vertex_point_map,
                              const Traits& traits = Traits())
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tm, tree, vertex_point_map);
    return locate(ray, tree, tm, vertex_point_map, traits);
  }

  /// returns the location where a ray meets the mesh first, with a tree of the faces. Faces in whose plane the ray lies
  /// do not count.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param ray a ray
  /// \param tree a tree that `build_aabb_tree()` has built
  /// \return the location; its face is the null face if the ray does not meet the mesh
  template <typename AABBTraits>
  Face_location locate(const Ray_3& ray, const AABB_tree<AABBTraits>& tree) const
  {
    return locate(ray, tree, m_structure.mesh(), m_structure.vertex_point_map(), m_structure.traits());
  }

  /// does the same without an object.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param ray a ray
  /// \param tree a tree that `build_aabb_tree()` has built
  /// \param tm the mesh
  /// \param vertex_point_map gives the point of each vertex
  /// \param traits an instance of the traits class
  /// \return the location; its face is the null face if the ray does not meet the mesh
  template <typename AABBTraits>
  static Face_location locate(const Ray_3& ray, const AABB_tree<AABBTraits>& tree, const Triangle_mesh& tm,
                              Vertex_point_map vertex_point_map, const Traits& traits = Traits())
  {
    return Locations::locate(ray, tree, tm, vertex_point_map, traits);
  }

  /// builds a tree of the faces for `locate()`.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param tree is built anew
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if a corner of a face has a coordinate that is not finite,
  ///         as do the functions below
  template <typename AABBTraits>
  void build_aabb_tree(AABB_tree<AABBTraits>& tree) const
  {
    build_aabb_tree(m_structure.mesh(), tree, m_structure.vertex_point_map());
  }

  /// builds a tree of the faces with the points of another map.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param tree is built anew
  /// \param vertex_point_map gives the point of each vertex
  template <typename AABBTraits>
  void build_aabb_tree(AABB_tree<AABBTraits>& tree, Vertex_point_map vertex_point_map) const
  {
    build_aabb_tree(m_structure.mesh(), tree, vertex_point_map);
  }

  /// does the same without an object, with the point map of the mesh.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param tm the mesh
  /// \param tree is built anew
  template <typename AABBTraits>
  static void build_aabb_tree(const Triangle_mesh& tm, AABB_tree<AABBTraits>& tree)
  {
    build_aabb_tree(tm, tree, get(CGAL::vertex_point, tm));
  }

  /// does the same without an object, with a point map.
  ///
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree` of the faces
  /// \param tm the mesh
  /// \param tree is built anew
  /// \param vertex_point_map gives the point of each vertex
  template <typename AABBTraits>
  static void build_aabb_tree(const Triangle_mesh& tm, AABB_tree<AABBTraits>& tree, Vertex_point_map vertex_point_map)
  {
    Locations::build_tree(tm, tree, vertex_point_map);
  }

  /// @}

private:
  template <typename OutputIterator>
  using Point_writer = Surface_mesh_geodesics::internal::Path_point_writer<Surface_mesh_geodesic_paths, OutputIterator>;

  template <typename OutputIterator>
  using Polyline_writer
    = Surface_mesh_geodesics::internal::Path_polyline_writer<Surface_mesh_geodesic_paths, OutputIterator>;

  Structure m_structure;
};

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_SURFACE_MESH_GEODESIC_PATHS_H
