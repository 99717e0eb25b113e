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
#include <CGAL/Surface_mesh_geodesics/internal/Geodesic_solver.h>
#include <CGAL/Surface_mesh_geodesics/internal/cgal_compatibility.h>
#include <CGAL/Surface_mesh_geodesics/internal/intrinsic_mesh_from_face_graph.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Default.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <list>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Surface_mesh_geodesic_paths` computes exact geodesic distances and shortest paths from one or
more source points, which may be any points of a triangle mesh, to any of its points.

It replaces `Surface_mesh_shortest_path`: all types, member functions and static member functions of that
class are here, with the same meaning. A program changes the include and the name of the class, and nothing
else.

\code
typedef CGAL::Surface_mesh_shortest_path_traits<Kernel, Triangle_mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_paths<Traits> Surface_mesh_geodesic_paths;

Surface_mesh_geodesic_paths paths(tm);
paths.add_source_point(source);
std::cout << paths.shortest_distance_to_source_points(target).first << "\n";
\endcode

<b>Differences from `Surface_mesh_shortest_path`</b>

- Source points on edges are where they have been put, for each parameter `t`; several sources in faces,
  queries on border edges, edges without length, isolated vertices and two sources at vertices give the right
  distances.
- Barycentric coordinates, of source points and of queries, that are not greater than
  \f$ 64 \epsilon \approx 1.4 \cdot 10^{-14} \f$ are taken for zero, and their sum for one. So a location that
  `locate()` has computed for a point at a vertex is that vertex, in whichever face it has been found. A location
  is outside its face if a coordinate is less than \f$ -\delta \f$ or greater than \f$ 1 + \delta \f$, or if the
  sum of its coordinates differs from one by more than \f$ \delta = \sqrt\epsilon / 16 \approx 9.3 \cdot 10^{-10} \f$.
- `locate()` returns a point of the longest side for a face whose height is lost in rounding, instead of coordinates
  that are not numbers.
- All is computed in `double`, whatever the number type of the traits is: coordinates are rounded with
  `CGAL::to_double()`, and results are numbers of type `double`, converted to `FT`. The points of a path are
  constructed with the traits.
- Input that makes no sense (a face that is not a triangle, a coordinate that is not finite, a location
  outside its face, a descriptor that is not in the mesh) throws
  `Surface_mesh_geodesics::Invalid_geodesic_input`, from `build_sequence_tree()` or from the query.
- A path has at least one point and no point twice in a row. A source point on an edge or at a vertex, given
  as a location, is reported to the visitor as the edge or the vertex.
- An isolated vertex may be a source, and is then the only point that it reaches. The iterator to it
  dereferences to a location with a null face.
- Two source points at the same place: the first one is reported.
- Queries of a `const` object exist, see below. Objects cannot be copied, and the members for debugging, which are
  not documented there, do not exist.

<b>What is computed when.</b> `build_sequence_tree()` computes what queries at vertices need, distances
and paths, and keeps no windows. The first query at a point that is not a vertex computes what such queries
need: the windows of each edge are kept then, in some 40 bytes each. Call `build_sequence_tree_for_faces()` if
such queries will come. Both take the time of one propagation; see the chapter on performance.

<b>Thread safety.</b> Member functions of a `const` object may be called from several threads at once. A
query of a `const` object does not compute anything first: it throws `std::logic_error` if
`build_sequence_tree()`, or `build_sequence_tree_for_faces()` for a point that is not a vertex, has not been
called since sources were changed. Queries of an object that is not `const` may build, and are safe under the same
condition only.

\tparam Traits a model of `SurfaceMeshShortestPathTraits` whose points have the members `x()`, `y()` and `z()`,
        which `CGAL::to_double()` takes, a default constructor, and `operator!=`
\tparam VIM a model of `ReadablePropertyMap` with `vertex_descriptor` as key and `unsigned int` as value type.
        The default is `boost::property_map<Triangle_mesh, boost::vertex_index_t>::%const_type`.
\tparam HIM a model of `ReadablePropertyMap` with `halfedge_descriptor` as key and `unsigned int` as value
        type, not used. The default is
        `boost::property_map<Triangle_mesh, boost::halfedge_index_t>::%const_type`.
\tparam FIM a model of `ReadablePropertyMap` with `face_descriptor` as key and `unsigned int` as value type.
        The default is `boost::property_map<Triangle_mesh, boost::face_index_t>::%const_type`.
\tparam VPM a model of `ReadablePropertyMap` with `vertex_descriptor` as key and `Traits::Point_3` as value
        type. The default is `boost::property_map<Triangle_mesh, CGAL::vertex_point_t>::%const_type`.

\sa `Surface_mesh_geodesics::geodesic_distances()`
*/
template <typename Traits, typename VIM = Default, typename HIM = Default, typename FIM = Default,
          typename VPM = Default>
class Surface_mesh_geodesic_paths
{
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

  /// \deprecated use `Barycentric_coordinates`
  using Barycentric_coordinate = Barycentric_coordinates;

  /// a point of a face: the coordinates are those of `source(halfedge(f,tm),tm)`,
  /// `target(halfedge(f,tm),tm)` and `target(next(halfedge(f,tm),tm),tm)` for the face `f`, in this order.
  using Face_location = std::pair<face_descriptor, Barycentric_coordinates>;

private:
  // A source point; `vertex` is the null vertex unless it was given as a vertex.
  struct Source_point
  {
    Face_location location;
    vertex_descriptor vertex;
  };

  using Source_point_list = std::list<Source_point>;
  using Ray_3 = typename Traits::Ray_3;
  using Triangle_3 = typename Traits::Triangle_3;
  using Solver
    = Surface_mesh_geodesics::internal::Geodesic_solver<Triangle_mesh, Vertex_index_map, Face_index_map>;

public:
  /// a model of `BidirectionalIterator` to access the source points; dereferencing gives a
  /// `const Face_location&`. An iterator is valid until the point is removed and the structure rebuilt
  /// after that, or until `clear()`.
  class Source_point_iterator
  {
  public:
    using iterator_category = std::bidirectional_iterator_tag;
    using value_type = Face_location;
    using difference_type = std::ptrdiff_t;
    using pointer = const Face_location*;
    using reference = const Face_location&;

    /// default constructor.
    Source_point_iterator() = default;

    reference operator*() const { return m_iterator->location; }
    pointer operator->() const { return &m_iterator->location; }

    Source_point_iterator& operator++()
    {
      ++m_iterator;
      return *this;
    }

    Source_point_iterator operator++(int)
    {
      const Source_point_iterator before(*this);
      ++m_iterator;
      return before;
    }

    Source_point_iterator& operator--()
    {
      --m_iterator;
      return *this;
    }

    Source_point_iterator operator--(int)
    {
      const Source_point_iterator before(*this);
      --m_iterator;
      return before;
    }

    bool operator==(const Source_point_iterator& other) const { return m_iterator == other.m_iterator; }
    bool operator!=(const Source_point_iterator& other) const { return m_iterator != other.m_iterator; }

  private:
    friend class Surface_mesh_geodesic_paths;

    using Underlying = typename Source_point_list::const_iterator;
    explicit Source_point_iterator(Underlying iterator) : m_iterator(iterator) {}

    Underlying m_iterator;
  };

  /// the result of a query: the distance and the source point that it is measured from; -1 and
  /// `source_points_end()` if no source point reaches the query point.
  using Shortest_path_result = std::pair<FT, Source_point_iterator>;

  /// the number that stands for "no source point" where source points are numbered.
  static constexpr std::size_t no_source = (std::numeric_limits<std::size_t>::max)();

  /// @}

  /// \name Constructors
  /// @{

  /// creates an object for `tm`, which is referred to, not copied, and must not change before `clear()`. The
  /// index maps and the point map of `tm` are used.
  Surface_mesh_geodesic_paths(const Triangle_mesh& tm, const Traits& traits = Traits())
    : Surface_mesh_geodesic_paths(tm, get(boost::vertex_index, tm), get(boost::halfedge_index, tm),
                                  get(boost::face_index, tm), get(CGAL::vertex_point, tm), traits)
  {}

  /// creates an object for `tm` with the maps given: indices from 0 to `num_vertices(tm) - 1`,
  /// `num_halfedges(tm) - 1` and `num_faces(tm) - 1`, and points.
  Surface_mesh_geodesic_paths(const Triangle_mesh& tm, Vertex_index_map vertex_index_map,
                              Halfedge_index_map halfedge_index_map, Face_index_map face_index_map,
                              Vertex_point_map vertex_point_map, const Traits& traits = Traits())
    : m_traits(traits), m_tm(tm), m_vertex_index_map(vertex_index_map),
      m_face_index_map(face_index_map), m_vertex_point_map(vertex_point_map),
      m_solver(tm, vertex_index_map, face_index_map)
  {
    static_cast<void>(halfedge_index_map);
  }

  Surface_mesh_geodesic_paths(const Surface_mesh_geodesic_paths&) = delete;
  Surface_mesh_geodesic_paths& operator=(const Surface_mesh_geodesic_paths&) = delete;

  /// @}

  /// \name Addition and Removal of Source Points
  /// Nothing is computed before the next query, or call of `build_sequence_tree()`.
  /// @{

  /// adds a vertex; returns the iterator to it.
  Source_point_iterator add_source_point(vertex_descriptor v)
  {
    return insert_source(Source_point{is_in_range(v) ? face_location(v) : null_location(), v});
  }

  /// adds a point of a face.
  Source_point_iterator add_source_point(face_descriptor f, const Barycentric_coordinates& location)
  {
    return add_source_point(Face_location(f, location));
  }

  /// adds a point of a face.
  Source_point_iterator add_source_point(const Face_location& location)
  {
    return insert_source(Source_point{location, Graph_traits::null_vertex()});
  }

  /// adds all points of a range of `vertex_descriptor` or `Face_location`; returns the iterator to the first
  /// one, `source_points_end()` if the range is empty.
  template <typename InputIterator>
  Source_point_iterator add_source_points(InputIterator begin, InputIterator end)
  {
    Source_point_iterator first = source_points_end();
    for(bool is_first = true; begin != end; ++begin, is_first = false)
    {
      const Source_point_iterator added = add_source_point(*begin);
      if(is_first)
        first = added;
    }
    return first;
  }

  /// removes a source point.
  /// \pre `it` is an iterator to a source point that has not been removed.
  void remove_source_point(Source_point_iterator it)
  {
    m_removed.splice(m_removed.begin(), m_sources, it.m_iterator);
    m_has_changed = true;
  }

  /// removes all source points.
  void remove_all_source_points()
  {
    if(m_sources.empty())
      return;
    m_removed.splice(m_removed.begin(), m_sources);
    m_has_changed = true;
  }

  /// @}

  /// \name Building
  /// @{

  /// computes what queries at vertices need, if source points have changed.
  ///
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a source point is invalid; the
  /// source points are then as they were before, and still to be built.
  void build_sequence_tree()
  {
    Surface_mesh_geodesics::Geodesic_default_visitor visitor;
    build(false, visitor);
  }

  /// computes what queries at vertices need, and tells a model of `GeodesicPropagationVisitor` of the
  /// progress. Returns `false` if the visitor cancelled; the source points are then still to be built.
  template <typename Visitor>
  bool build_sequence_tree(Visitor& visitor)
  {
    return build(false, visitor);
  }

  /// computes what queries at any point need, if that has not been done since source points were changed.
  void build_sequence_tree_for_faces()
  {
    Surface_mesh_geodesics::Geodesic_default_visitor visitor;
    build(true, visitor);
  }

  /// computes what queries at any point need, and tells a visitor of the progress. Returns `false` if the
  /// visitor cancelled.
  template <typename Visitor>
  bool build_sequence_tree_for_faces(Visitor& visitor)
  {
    return build(true, visitor);
  }

  /// takes the lengths of the edges from a map instead of from points: distances and sequences then need no
  /// points, and the points of paths are those of the point map at the same places. (The point map that the
  /// constructor takes is not read before a point is asked for, so that any map will do.) All that was computed
  /// is forgotten; the lengths are used until `clear()`.
  ///
  /// \tparam EdgeLengthMap a model of `ReadablePropertyMap` with the edge descriptor as key type and a number
  ///         type as value type
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if a length is negative or not finite, or an edge
  ///         is longer than the two others of a face; lengths are then taken from the points again
  template <typename EdgeLengthMap>
  void use_edge_lengths(EdgeLengthMap edge_length_map)
  {
    m_has_changed = m_has_changed || !m_sources.empty();
    m_solver.build_mesh(
      Surface_mesh_geodesics::internal::Shape_from_edge_lengths<double, Triangle_mesh, EdgeLengthMap>(
        m_tm, edge_length_map));
  }

  /// removes all source points and all that was computed; the object is as it was after construction. To be
  /// called if the mesh has changed.
  void clear()
  {
    m_sources.clear();
    m_removed.clear();
    m_source_by_number.clear();
    m_solver.forget();
    m_has_changed = false;
  }

  /// @}

  /// \name Accessors
  /// @{

  /// returns an iterator to the first source point; they come in the order in which they were added.
  Source_point_iterator source_points_begin() const { return Source_point_iterator(m_sources.begin()); }

  /// returns the iterator past the last source point.
  Source_point_iterator source_points_end() const { return Source_point_iterator(m_sources.end()); }

  /// returns the number of source points.
  std::size_t number_of_source_points() const { return m_sources.size(); }

  /// returns whether source points have been added or removed since the last build.
  bool changed_since_last_build() const { return m_has_changed; }

  /// returns what the last propagation did.
  const Surface_mesh_geodesics::Propagation_statistics& statistics() const
  {
    return m_solver.statistics();
  }

  /// @}

  /// \name Shortest Distance Queries
  /// The distance is the length of the shortest path: nobody who wants the length needs to ask for the path.
  /// Queries at a vertex take constant time. Queries at other points take time linear in the number of windows
  /// on the three edges of the face, some tens.
  /// @{

  /// returns the distance from a vertex to the nearest source point, and that source point.
  Shortest_path_result shortest_distance_to_source_points(vertex_descriptor v)
  {
    build_sequence_tree();
    return result(query(v));
  }

  /// does the same without building.
  Shortest_path_result shortest_distance_to_source_points(vertex_descriptor v) const
  {
    return result(query(v));
  }

  /// returns the distance from a point of a face to the nearest source point, and that source point.
  Shortest_path_result shortest_distance_to_source_points(face_descriptor f,
                                                          const Barycentric_coordinates& location)
  {
    return result(built_query(f, location));
  }

  /// does the same without building.
  Shortest_path_result shortest_distance_to_source_points(face_descriptor f,
                                                          const Barycentric_coordinates& location) const
  {
    return result(query(f, location));
  }

  /// returns the number of the source point that is nearest to `v`, counted from `source_points_begin()`, or
  /// `no_source`.
  std::size_t nearest_source_point(vertex_descriptor v)
  {
    build_sequence_tree();
    return nearest(query(v));
  }

  /// does the same without building.
  std::size_t nearest_source_point(vertex_descriptor v) const { return nearest(query(v)); }

  /// returns the number of the source point that is nearest to a point of a face.
  std::size_t nearest_source_point(face_descriptor f, const Barycentric_coordinates& location)
  {
    return nearest(built_query(f, location));
  }

  /// does the same without building.
  std::size_t nearest_source_point(face_descriptor f, const Barycentric_coordinates& location) const
  {
    return nearest(query(f, location));
  }

  /// writes the distances of all vertices to a map, -1 where no source point reaches.
  /// \tparam VertexDistanceMap a model of `WritablePropertyMap` with `vertex_descriptor` as key type
  template <typename VertexDistanceMap>
  void shortest_distances_to_source_points(VertexDistanceMap vertex_distance_map)
  {
    build_sequence_tree();
    std::as_const(*this).shortest_distances_to_source_points(vertex_distance_map);
  }

  /// does the same without building.
  template <typename VertexDistanceMap>
  void shortest_distances_to_source_points(VertexDistanceMap vertex_distance_map) const
  {
    using Value = typename boost::property_traits<VertexDistanceMap>::value_type;
    check_built();
    for(vertex_descriptor v : vertices(m_tm))
    {
      const double d = is_built() ? m_solver.distance(v) : -1.;
      put(vertex_distance_map, v, d < std::numeric_limits<double>::infinity() ? Value(d) : Value(-1));
    }
  }

  /// returns the vertex that is farthest from the source points among those that they reach, and its
  /// distance; the null vertex and -1 if there is none. Takes time linear in the number of vertices.
  std::pair<vertex_descriptor, FT> farthest_vertex()
  {
    build_sequence_tree();
    return std::as_const(*this).farthest_vertex();
  }

  /// does the same without building.
  std::pair<vertex_descriptor, FT> farthest_vertex() const
  {
    check_built();
    std::pair<vertex_descriptor, double> farthest(Graph_traits::null_vertex(), -1.);
    if(is_built())
      for(vertex_descriptor v : vertices(m_tm))
      {
        const double d = m_solver.distance(v);
        if(d > farthest.second && d < std::numeric_limits<double>::infinity())
          farthest = {v, d};
      }
    return {farthest.first, FT(farthest.second)};
  }

  /// @}

  /// \name Shortest Path Sequence Queries
  /// A path is reported from the query point to the source point. Nothing is reported if there is none.
  ///
  /// The length of the path is the distance that is returned, up to \f$ 10^{-10} \f$ of it, or up to the
  /// rounding of the largest extent of the mesh (64 units) if that is more; it is checked while the path is traced.
  /// Two points that follow each other are in a common face. Where rounding leads the straight line astray, on faces
  /// whose height or whose sides are lost in the rounding of coordinates, the path is looked for among all paths
  /// through the faces nearby, which takes longer. If that search finds none of the right length, or has to be given
  /// up, queries of paths throw `std::runtime_error` before they report anything. No such mesh is known.
  /// @{

  /// reports the vertices, edges and faces of the shortest path from `v` to a model of
  /// `SurfaceMeshShortestPathVisitor`.
  template <typename Visitor>
  Shortest_path_result shortest_path_sequence_to_source_points(vertex_descriptor v, Visitor& visitor)
  {
    build_sequence_tree();
    return sequence(query(v), visitor);
  }

  /// does the same without building.
  template <typename Visitor>
  Shortest_path_result shortest_path_sequence_to_source_points(vertex_descriptor v,
                                                               Visitor& visitor) const
  {
    return sequence(query(v), visitor);
  }

  /// reports the shortest path from a point of a face; the first call is `visitor(f, location)`.
  template <typename Visitor>
  Shortest_path_result shortest_path_sequence_to_source_points(face_descriptor f,
                                                               const Barycentric_coordinates& location,
                                                               Visitor& visitor)
  {
    return sequence(built_query(f, location), f, location, visitor);
  }

  /// does the same without building.
  template <typename Visitor>
  Shortest_path_result shortest_path_sequence_to_source_points(face_descriptor f,
                                                               const Barycentric_coordinates& location,
                                                               Visitor& visitor) const
  {
    return sequence(query(f, location), f, location, visitor);
  }

  /// @}

  /// \name Shortest Path Point Queries
  /// @{

  /// writes the points of the shortest path from `v` to an output iterator that takes `Point_3`.
  template <typename OutputIterator>
  Shortest_path_result shortest_path_points_to_source_points(vertex_descriptor v, OutputIterator output)
  {
    Point_visitor<OutputIterator> visitor{*this, output};
    return shortest_path_sequence_to_source_points(v, visitor);
  }

  /// does the same without building.
  template <typename OutputIterator>
  Shortest_path_result shortest_path_points_to_source_points(vertex_descriptor v,
                                                             OutputIterator output) const
  {
    Point_visitor<OutputIterator> visitor{*this, output};
    return shortest_path_sequence_to_source_points(v, visitor);
  }

  /// writes the points of the shortest path from a point of a face.
  template <typename OutputIterator>
  Shortest_path_result shortest_path_points_to_source_points(face_descriptor f,
                                                             const Barycentric_coordinates& location,
                                                             OutputIterator output)
  {
    Point_visitor<OutputIterator> visitor{*this, output};
    return shortest_path_sequence_to_source_points(f, location, visitor);
  }

  /// does the same without building.
  template <typename OutputIterator>
  Shortest_path_result shortest_path_points_to_source_points(face_descriptor f,
                                                             const Barycentric_coordinates& location,
                                                             OutputIterator output) const
  {
    Point_visitor<OutputIterator> visitor{*this, output};
    return shortest_path_sequence_to_source_points(f, location, visitor);
  }

  /// writes the shortest path from `v` as `std::pair<Point_3, face_descriptor>`: the points, each with the
  /// face of the segment that leads to it (the null face for the first point).
  template <typename OutputIterator>
  Shortest_path_result shortest_path_polyline_to_source_points(vertex_descriptor v, OutputIterator output)
  {
    build_sequence_tree();
    return std::as_const(*this).shortest_path_polyline_to_source_points(v, output);
  }

  /// does the same without building.
  template <typename OutputIterator>
  Shortest_path_result shortest_path_polyline_to_source_points(vertex_descriptor v,
                                                               OutputIterator output) const
  {
    Polyline_visitor<OutputIterator> visitor{*this, output};
    return sequence(query(v), visitor);
  }

  /// writes the shortest path from a point of a face in the same way.
  template <typename OutputIterator>
  Shortest_path_result shortest_path_polyline_to_source_points(face_descriptor f,
                                                               const Barycentric_coordinates& location,
                                                               OutputIterator output)
  {
    Polyline_visitor<OutputIterator> visitor{*this, output};
    return sequence(built_query(f, location), f, location, visitor);
  }

  /// does the same without building.
  template <typename OutputIterator>
  Shortest_path_result shortest_path_polyline_to_source_points(face_descriptor f,
                                                               const Barycentric_coordinates& location,
                                                               OutputIterator output) const
  {
    Polyline_visitor<OutputIterator> visitor{*this, output};
    return sequence(query(f, location), f, location, visitor);
  }

  /// @}

  /// \name Lines of Equal Distance
  /// @{

  /// writes the lines of all points at the distance `value` from the source points as polylines, one
  /// `std::vector<Point_3>` for each; a closed one ends with its first point. The points on edges are found with
  /// an error of \f$ 10^{-12} \f$ of the length of the edge, and joined by segments in the faces. Two crossings of
  /// an edge that are nearer to each other than \f$ 10^{-4} \f$ of its length may be left out, and so may be a
  /// closed line that meets no edge, around a point that is farther than all edges of its face.
  /// Takes time linear in the number of faces, and face queries around each point.
  template <typename OutputIterator>
  OutputIterator isolines(const FT& value, OutputIterator output)
  {
    build_sequence_tree_for_faces();
    return std::as_const(*this).isolines(value, output);
  }

  /// does the same without building.
  template <typename OutputIterator>
  OutputIterator isolines(const FT& value, OutputIterator output) const
  {
    check_built();
    if(!is_built())
      return output;
    check_windows();
    using Locations = std::vector<std::pair<face_descriptor, std::array<double, 3>>>;
    m_solver.trace_isolines(CGAL::to_double(value), 1e-12, [&](const Locations& locations, bool is_closed)
    {
      std::vector<Point_3> line;
      for(const auto& l : locations)
        line.push_back(point(l.first, coordinates(l.second)));
      if(is_closed)
        line.push_back(line.front());
      *output++ = line;
    });
    return output;
  }

  /// @}

  /// \name Surface Point Constructions
  /// @{

  /// returns the point with the given coordinates in a face.
  Point_3 point(face_descriptor f, const Barycentric_coordinates& location) const
  {
    return point(f, location, m_tm, m_vertex_point_map, m_traits);
  }

  /// does the same without an object.
  static Point_3 point(face_descriptor f, const Barycentric_coordinates& location,
                       const Triangle_mesh& tm, const Traits& traits = Traits())
  {
    return point(f, location, tm, get(CGAL::vertex_point, tm), traits);
  }

  /// does the same without an object, with a point map.
  static Point_3 point(face_descriptor f, const Barycentric_coordinates& location,
                       const Triangle_mesh& tm, Vertex_point_map vertex_point_map,
                       const Traits& traits = Traits())
  {
    const Triangle_3 t = triangle(f, tm, vertex_point_map, traits);
    auto weight = traits.construct_barycentric_coordinates_weight_object();
    auto vertex = traits.construct_vertex_3_object();
    return traits.construct_barycenter_3_object()(vertex(t, 0), weight(location, 0), vertex(t, 1),
                                                  weight(location, 1), vertex(t, 2),
                                                  weight(location, 2));
  }

  /// returns the point at `t` of a halfedge, 0 for its source and 1 for its target.
  Point_3 point(halfedge_descriptor he, const FT t) const
  {
    return point(he, t, m_tm, m_vertex_point_map, m_traits);
  }

  /// does the same without an object.
  static Point_3 point(halfedge_descriptor he, const FT t, const Triangle_mesh& tm,
                       const Traits& traits = Traits())
  {
    return point(he, t, tm, get(CGAL::vertex_point, tm), traits);
  }

  /// does the same without an object, with a point map.
  static Point_3 point(halfedge_descriptor he, const FT t, const Triangle_mesh& tm,
                       Vertex_point_map vertex_point_map, const Traits& traits = Traits())
  {
    return traits.construct_barycenter_3_object()(get(vertex_point_map, target(he, tm)), t,
                                                  get(vertex_point_map, source(he, tm)));
  }

  /// returns the point of a vertex.
  decltype(auto) point(vertex_descriptor v) const { return get(m_vertex_point_map, v); }

  /// does the same without an object.
  static decltype(auto) point(vertex_descriptor v, const Triangle_mesh& tm)
  {
    return get(CGAL::vertex_point, tm, v);
  }

  /// @}

  /// \name Surface Face Location Constructions
  /// @{

  /// returns the location of a vertex, in a face around it; a location with a null face if it has none.
  /// \pre `v` is a vertex of the mesh.
  Face_location face_location(vertex_descriptor v) const { return face_location(v, m_tm, m_traits); }

  /// does the same without an object.
  static Face_location face_location(vertex_descriptor v, const Triangle_mesh& tm,
                                     const Traits& traits = Traits())
  {
    const halfedge_descriptor h = halfedge_with_face(v, tm);
    return h == Graph_traits::null_halfedge() ? null_location(traits)
                                              : corner_location(next(h, tm), FT(0), tm, traits);
  }

  /// returns the location at `t` of a halfedge, in the face of the halfedge, or in that of its opposite if it
  /// is a border halfedge.
  Face_location face_location(halfedge_descriptor he, const FT t) const
  {
    return face_location(he, t, m_tm, m_traits);
  }

  /// does the same without an object.
  static Face_location face_location(halfedge_descriptor he, const FT t, const Triangle_mesh& tm,
                                     const Traits& traits = Traits())
  {
    if(is_border(he, tm))
      return corner_location(opposite(he, tm), FT(FT(1) - t), tm, traits);
    return corner_location(he, t, tm, traits);
  }

  /// @}

  /// \name Nearest Face Location Queries
  /// Functions without a tree as parameter build one at each call.
  /// @{

  /// returns the location on the mesh that is nearest to a point.
  /// \tparam AABBTraits a model of `AABBTraits` that defines a \cgal `AABB_tree`
  template <typename AABBTraits>
  Face_location locate(const Point_3& p) const
  {
    return locate<AABBTraits>(p, m_tm, m_vertex_point_map, m_traits);
  }

  /// does the same without an object.
  template <typename AABBTraits>
  static Face_location locate(const Point_3& p, const Triangle_mesh& tm,
                              Vertex_point_map vertex_point_map, const Traits& traits = Traits())
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tm, tree, vertex_point_map);
    return locate(p, tree, tm, vertex_point_map, traits);
  }

  /// returns the location on the mesh that is nearest to a point, with a tree of the faces.
  template <typename AABBTraits>
  Face_location locate(const Point_3& p, const AABB_tree<AABBTraits>& tree) const
  {
    return locate(p, tree, m_tm, m_vertex_point_map, m_traits);
  }

  /// does the same without an object.
  template <typename AABBTraits>
  static Face_location locate(const Point_3& p, const AABB_tree<AABBTraits>& tree,
                              const Triangle_mesh& tm, Vertex_point_map vertex_point_map,
                              const Traits& traits = Traits())
  {
    const auto nearest = tree.closest_point_and_primitive(p);
    return location_of(nearest.second, nearest.first, tm, vertex_point_map, traits);
  }

  /// returns the location where a ray meets the mesh first; its face is the null face if there is none.
  template <typename AABBTraits>
  Face_location locate(const Ray_3& ray) const
  {
    return locate<AABBTraits>(ray, m_tm, m_vertex_point_map, m_traits);
  }

  /// does the same without an object.
  template <typename AABBTraits>
  static Face_location locate(const Ray_3& ray, const Triangle_mesh& tm,
                              Vertex_point_map vertex_point_map, const Traits& traits = Traits())
  {
    AABB_tree<AABBTraits> tree;
    build_aabb_tree(tm, tree, vertex_point_map);
    return locate(ray, tree, tm, vertex_point_map, traits);
  }

  /// returns the location where a ray meets the mesh first, with a tree of the faces.
  template <typename AABBTraits>
  Face_location locate(const Ray_3& ray, const AABB_tree<AABBTraits>& tree) const
  {
    return locate(ray, tree, m_tm, m_vertex_point_map, m_traits);
  }

  /// does the same without an object.
  template <typename AABBTraits>
  static Face_location locate(const Ray_3& ray, const AABB_tree<AABBTraits>& tree,
                              const Triangle_mesh& tm, Vertex_point_map vertex_point_map,
                              const Traits& traits = Traits())
  {
    using Intersection =
      typename AABB_tree<AABBTraits>::template Intersection_and_primitive_id<Ray_3>::Type;
    std::vector<Intersection> intersections;
    tree.all_intersections(ray, std::back_inserter(intersections));

    auto squared_distance = traits.compute_squared_distance_3_object();
    const Point_3* nearest = nullptr;
    face_descriptor nearest_face = Graph_traits::null_face();
    for(const Intersection& i : intersections)
    {
      const Point_3* p = Surface_mesh_geodesics::internal::held_value<Point_3>(i.first);
      if(p != nullptr
         && (nearest == nullptr
             || squared_distance(*p, ray.source()) < squared_distance(*nearest, ray.source())))
      {
        nearest = p;
        nearest_face = i.second;
      }
    }
    return nearest == nullptr ? null_location(traits)
                              : location_of(nearest_face, *nearest, tm, vertex_point_map, traits);
  }

  /// builds a tree of the faces for `locate()`.
  template <typename AABBTraits>
  void build_aabb_tree(AABB_tree<AABBTraits>& tree) const
  {
    build_aabb_tree(m_tm, tree, m_vertex_point_map);
  }

  /// builds a tree of the faces with the points of another map.
  template <typename AABBTraits>
  void build_aabb_tree(AABB_tree<AABBTraits>& tree, Vertex_point_map vertex_point_map) const
  {
    build_aabb_tree(m_tm, tree, vertex_point_map);
  }

  /// does the same without an object.
  template <typename AABBTraits>
  static void build_aabb_tree(const Triangle_mesh& tm, AABB_tree<AABBTraits>& tree)
  {
    build_aabb_tree(tm, tree, get(CGAL::vertex_point, tm));
  }

  /// does the same without an object, with a point map.
  template <typename AABBTraits>
  static void build_aabb_tree(const Triangle_mesh& tm, AABB_tree<AABBTraits>& tree,
                              Vertex_point_map vertex_point_map)
  {
    const auto range = faces(tm);
    tree.rebuild(range.begin(), range.end(), tm, vertex_point_map);
    tree.build();
  }

  /// @}

private:
  using Query = typename Solver::Query;
  using Arrival = typename Solver::Arrival;
  using State = typename Solver::State;

  // A visitor of a path that writes its points, without those that rounding makes equal to the one before.
  template <typename OutputIterator>
  struct Point_visitor
  {
    const Surface_mesh_geodesic_paths& paths;
    OutputIterator output;
    bool is_first = true;
    Point_3 last = Point_3();

    void operator()(halfedge_descriptor he, FT t) { write(paths.point(he, t)); }
    void operator()(vertex_descriptor v) { write(paths.point(v)); }
    void operator()(face_descriptor f, const Barycentric_coordinates& location)
    {
      write(paths.point(f, location));
    }

    void write(const Point_3& p)
    {
      if(is_first || p != last)
        *output++ = p;
      is_first = false;
      last = p;
    }
  };

  // A visitor of a path that writes its points with the faces of its segments, which enter() tells.
  template <typename OutputIterator>
  struct Polyline_visitor
  {
    const Surface_mesh_geodesic_paths& paths;
    OutputIterator output;
    face_descriptor face = Graph_traits::null_face();
    bool is_first = true;
    Point_3 last = Point_3();

    void enter(face_descriptor f) { face = f; }
    void operator()(halfedge_descriptor he, FT t) { write(paths.point(he, t)); }
    void operator()(vertex_descriptor v) { write(paths.point(v)); }
    void operator()(face_descriptor f, const Barycentric_coordinates& location)
    {
      write(paths.point(f, location));
    }

    void write(const Point_3& p)
    {
      if(is_first || p != last)
        *output++ = std::make_pair(p, face);
      is_first = false;
      last = p;
    }
  };

  template <typename Visitor>
  struct Is_polyline_visitor : std::false_type
  {};

  template <typename OutputIterator>
  struct Is_polyline_visitor<Polyline_visitor<OutputIterator>> : std::true_type
  {};

  // From what the solver tells of a path to the calls of a SurfaceMeshShortestPathVisitor.
  template <typename Visitor>
  struct Sequence_sink
  {
    const Surface_mesh_geodesic_paths& paths;
    Visitor& visitor;

    void vertex(vertex_descriptor v) { visitor(v); }
    void edge(halfedge_descriptor he, double t) { visitor(he, FT(t)); }

    static constexpr bool wants_faces = Is_polyline_visitor<Visitor>::value;

    void face(face_descriptor f)
    {
      static_cast<void>(f);
      if constexpr(wants_faces)
        visitor.enter(f);
    }

    // a source point that is not a vertex
    void source(std::size_t number)
    {
      const Face_location& location = paths.m_source_by_number[number]->location;
      auto weight = paths.m_traits.construct_barycentric_coordinates_weight_object();
      std::array<double, 3> b;
      for(std::size_t k = 0; k < 3; ++k)
        b[k] = CGAL::to_double(weight(location.second, k));
      Surface_mesh_geodesics::internal::Source_insertion<double>::snap(b);
      halfedge_descriptor h = halfedge(location.first, paths.m_tm);
      for(std::size_t k = 0; k < 3; ++k, h = next(h, paths.m_tm))
        if(b[(k + 2) % 3] == 0)
        {
          visitor(h, FT(b[(k + 1) % 3]));
          return;
        }
      visitor(location.first, location.second);
    }
  };

  Source_point_iterator insert_source(const Source_point& source)
  {
    m_has_changed = true;
    return Source_point_iterator(m_sources.insert(m_sources.end(), source));
  }

  // is v, as far as its index tells, a vertex of the mesh?
  bool is_in_range(vertex_descriptor v) const
  {
    return v != Graph_traits::null_vertex()
        && static_cast<std::size_t>(get(m_vertex_index_map, v)) < num_vertices(m_tm);
  }

  // a halfedge with a face and the target v, or the null halfedge: edges may have no face on either side.
  static halfedge_descriptor halfedge_with_face(vertex_descriptor v, const Triangle_mesh& tm)
  {
    const halfedge_descriptor first = halfedge(v, tm);
    halfedge_descriptor h = first;
    while(h != Graph_traits::null_halfedge() && is_border(h, tm))
    {
      h = opposite(next(h, tm), tm);
      if(h == first)
        h = Graph_traits::null_halfedge();
    }
    return h;
  }

  Face_location null_location() const { return null_location(m_traits); }

  static Face_location null_location(const Traits& traits)
  {
    return Face_location(Graph_traits::null_face(), traits.construct_barycentric_coordinates_object()(
                                                      FT(0), FT(0), FT(0)));
  }

  // the location at t of a halfedge with a face.
  static Face_location corner_location(halfedge_descriptor he, const FT& t, const Triangle_mesh& tm,
                                       const Traits& traits)
  {
    const face_descriptor f = face(he, tm);
    std::size_t k = 0;
    for(halfedge_descriptor h = halfedge(f, tm); h != he; h = next(h, tm))
      ++k;
    std::array<FT, 3> c = {FT(0), FT(0), FT(0)};
    c[k] = FT(1) - t;
    c[(k + 1) % 3] = t;
    return Face_location(f, traits.construct_barycentric_coordinates_object()(c[0], c[1], c[2]));
  }

  static Triangle_3 triangle(face_descriptor f, const Triangle_mesh& tm, Vertex_point_map vertex_point_map,
                             const Traits& traits)
  {
    const halfedge_descriptor h = halfedge(f, tm);
    return traits.construct_triangle_3_object()(get(vertex_point_map, source(h, tm)),
                                                get(vertex_point_map, target(h, tm)),
                                                get(vertex_point_map, target(next(h, tm), tm)));
  }

  static Face_location location_of(face_descriptor f, const Point_3& p, const Triangle_mesh& tm,
                                   Vertex_point_map vertex_point_map, const Traits& traits)
  {
    const Face_location location(f, traits.construct_barycentric_coordinates_in_triangle_3_object()(
                                      triangle(f, tm, vertex_point_map, traits), p));
    auto weight = traits.construct_barycentric_coordinates_weight_object();
    if(Surface_mesh_geodesics::internal::Source_insertion<double>::is_valid(
         {CGAL::to_double(weight(location.second, 0)), CGAL::to_double(weight(location.second, 1)),
          CGAL::to_double(weight(location.second, 2))}))
      return location;

    // The face has nearly no height, and its coordinates are lost in rounding: the point is on the longest side.
    halfedge_descriptor longest = halfedge(f, tm), h = longest;
    double squared_length = -1., t = 0.;
    for(int k = 0; k < 3; ++k, h = next(h, tm))
    {
      const Point_3 a = get(vertex_point_map, source(h, tm)), b = get(vertex_point_map, target(h, tm));
      const double x = CGAL::to_double(b.x()) - CGAL::to_double(a.x());
      const double y = CGAL::to_double(b.y()) - CGAL::to_double(a.y());
      const double z = CGAL::to_double(b.z()) - CGAL::to_double(a.z());
      const double l = x * x + y * y + z * z;
      if(l > squared_length)
      {
        longest = h;
        squared_length = l;
        t = (x * (CGAL::to_double(p.x()) - CGAL::to_double(a.x())) + y * (CGAL::to_double(p.y()) - CGAL::to_double(a.y()))
             + z * (CGAL::to_double(p.z()) - CGAL::to_double(a.z())));
      }
    }
    t = squared_length > 0 ? (std::min)((std::max)(t / squared_length, 0.), 1.) : 0.;
    return corner_location(longest, FT(t), tm, traits);
  }

  bool is_built() const { return m_solver.state() != State::EMPTY; }

  // builds if source points have changed, or if windows are wanted that have not been kept.
  template <typename Visitor>
  bool build(bool wants_windows, Visitor& visitor)
  {
    const bool lacks_windows = wants_windows && is_built() && m_solver.state() != State::WINDOWS;
    if(!m_has_changed && !lacks_windows)
      return true;
    m_has_changed = true; // until all is done: something may throw, or cancel
    if(!m_solver.has_mesh())
      m_solver.build_mesh(
        Surface_mesh_geodesics::internal::Shape_from_points<double, Triangle_mesh, Vertex_point_map>(
          m_tm, m_vertex_point_map));
    m_solver.begin_sources();
    for(const Source_point& s : m_sources)
      if(s.vertex != Graph_traits::null_vertex())
        m_solver.add_source(s.vertex);
      else
        m_solver.add_source_location(std::make_pair(s.location.first, weights(s.location.second)));
    visitor.on_propagation_begin(num_vertices(m_tm));
    const bool is_complete = m_solver.run(wants_windows, [&](std::size_t visits, double reached)
    {
      visitor.on_progress(visits, reached);
      return visitor.go_further();
    });
    visitor.on_propagation_end();
    if(!is_complete)
      return false;
    m_source_by_number.clear();
    for(auto it = m_sources.cbegin(); it != m_sources.cend(); ++it)
      m_source_by_number.push_back(it);
    m_removed.clear();
    m_has_changed = false;
    return true;
  }

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

  // builds what the query needs.
  Query built_query(face_descriptor f, const Barycentric_coordinates& location)
  {
    if(!m_has_changed && !is_built())
      return query(f, location);
    if(!is_at_vertex(weights(location)))
      build_sequence_tree_for_faces();
    else
      build_sequence_tree();
    if(!is_built())
      return Query();
    Query q = m_solver.query(f, weights(location));
    if(m_solver.needs_windows(q) && m_solver.state() != State::WINDOWS)
      build_sequence_tree_for_faces();
    return q;
  }

  std::array<double, 3> weights(const Barycentric_coordinates& location) const
  {
    auto weight = m_traits.construct_barycentric_coordinates_weight_object();
    return {CGAL::to_double(weight(location, 0)), CGAL::to_double(weight(location, 1)),
            CGAL::to_double(weight(location, 2))};
  }

  Barycentric_coordinates coordinates(const std::array<double, 3>& b) const
  {
    return m_traits.construct_barycentric_coordinates_object()(FT(b[0]), FT(b[1]), FT(b[2]));
  }

  static bool is_at_vertex(std::array<double, 3> b)
  {
    Surface_mesh_geodesics::internal::Source_insertion<double>::snap(b);
    return b[0] == 1 || b[1] == 1 || b[2] == 1;
  }

  void check_windows() const
  {
    if(m_solver.state() != State::WINDOWS)
      throw std::logic_error("Surface_mesh_geodesic_paths: build_sequence_tree_for_faces() has not been "
                             "called since source points were changed");
  }

  void check_built() const
  {
    if(m_has_changed)
      throw std::logic_error("Surface_mesh_geodesic_paths: build_sequence_tree() has not been called "
                             "since source points were changed");
  }

  std::size_t nearest(const Query& q) const
  {
    if(!is_built())
      return no_source;
    const Arrival a = m_solver.arrival(q);
    return a.root == Surface_mesh_geodesics::internal::null_id ? no_source : m_solver.source_number(a);
  }

  Shortest_path_result result(const Query& q) const
  {
    if(!is_built())
      return Shortest_path_result(FT(-1), source_points_end());
    return result(m_solver.arrival(q));
  }

  Shortest_path_result result(const Arrival& a) const
  {
    if(a.root == Surface_mesh_geodesics::internal::null_id)
      return Shortest_path_result(FT(-1), source_points_end());
    return Shortest_path_result(FT(a.distance * m_solver.unit()),
                                Source_point_iterator(m_source_by_number[m_solver.source_number(a)]));
  }

  template <typename Visitor>
  Shortest_path_result sequence(const Query& q, Visitor& visitor) const
  {
    if(!is_built())
      return Shortest_path_result(FT(-1), source_points_end());
    const Arrival a = m_solver.arrival(q);
    Sequence_sink<Visitor> sink{*this, visitor};
    if(a.root != Surface_mesh_geodesics::internal::null_id)
      m_solver.tell(q, a, m_solver.path(q, a), sink);
    return result(a);
  }

  template <typename Visitor>
  Shortest_path_result sequence(const Query& q, face_descriptor f, const Barycentric_coordinates& location,
                                Visitor& visitor) const
  {
    if(!is_built())
      return Shortest_path_result(FT(-1), source_points_end());
    const Arrival a = m_solver.arrival(q);
    Sequence_sink<Visitor> sink{*this, visitor};
    if(a.root != Surface_mesh_geodesics::internal::null_id)
    {
      const auto path = m_solver.path(q, a);
      visitor(f, location);
      m_solver.tell(q, a, path, sink);
    }
    return result(a);
  }

  const Traits m_traits;
  const Triangle_mesh& m_tm;
  Vertex_index_map m_vertex_index_map;
  Face_index_map m_face_index_map;
  Vertex_point_map m_vertex_point_map;
  Source_point_list m_sources;
  Source_point_list m_removed; // since the last build
  bool m_has_changed = false;
  std::vector<typename Source_point_list::const_iterator> m_source_by_number; // as they were built
  Solver m_solver;
};

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_SURFACE_MESH_GEODESIC_PATHS_H
