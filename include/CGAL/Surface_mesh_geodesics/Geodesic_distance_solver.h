// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_SOLVER_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_SOLVER_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_parameters.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Private_access.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_distance_solver` computes exact geodesic distances on one triangle mesh again and again,
each time from another source or other sources.

It gives the distances of `geodesic_distances()` with the same tag, to the same bits if the mesh is connected. (That
function reads only what is connected to the sources. On other meshes the last digits may differ, and this class waits
also for sides of targets on walls that no source reaches.) The constructor reads the mesh once, and each computation
reuses the memory of the one before. A computation that ends early, at a radius or when the distances of some targets
are final, takes time proportional to the number of windows in the area that it reaches, and none for the rest of the
mesh. Curves have tables of their own, which have the size of the mesh: a computation from curves makes them if the one
before was from points, and the next one from points frees them.

\code
Geodesic_distance_solver<Mesh> solver(tm);
std::cout << solver.compute_distance(v, w) << "\n";                   // one to one

solver.compute_distances(v, CGAL::parameters::maximum_distance(0.1)); // one to all within a radius
solver.vertices_reached(std::back_inserter(nearby));
\endcode

<b>Thread safety.</b> Several threads may call `const` member functions at once. While a thread calls another member
function, no other thread may use the object. Each thread may have an object of its own on the same mesh;
`geodesic_distance_matrix()` does the same with less memory.

<b>Validity.</b> An object refers to the mesh and stores copies of the maps. The mesh must not change and must outlive
the object; the constructor reads points and lengths, and nothing reads them later. Objects can be moved, but not
copied. An object that has been moved from may only be assigned to or destroyed.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: whether each computation
        uses several threads, as for `geodesic_distances()`
\tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh` as key type
        and `std::size_t` as value type, which gives each vertex a unique index between `0` and
        `num_vertices(tm) - 1`. The default is an automatically indexed internal map.
\tparam FaceIndexMap the same for faces

\sa `geodesic_distances()`
\sa `geodesic_distance_matrix()`
*/
template <typename TriangleMesh, typename ConcurrencyTag = Sequential_tag, typename VertexIndexMap = Default,
          typename FaceIndexMap = Default>
class Geodesic_distance_solver
{
  static_assert(internal::Checked_mesh<TriangleMesh>::value, "always true, if it compiles");
  using Default_np = parameters::Default_named_parameters;

public:
  /// \name Types
  /// @{

  /// the triangle mesh type.
  using Triangle_mesh = TriangleMesh;

  /// the vertex descriptor type.
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// what `nearest_source()` returns if no source reaches a vertex: the largest `std::size_t`.
  static constexpr std::size_t no_source = (std::numeric_limits<std::size_t>::max)();

#ifndef DOXYGEN_RUNNING
  using Vertex_index_map = typename Default::Get<
    VertexIndexMap, decltype(CGAL::get_initialized_vertex_index_map(std::declval<const TriangleMesh&>(),
                                                                    std::declval<const Default_np&>()))>::type;
  using Face_index_map = typename Default::Get<
    FaceIndexMap, decltype(CGAL::get_initialized_face_index_map(std::declval<const TriangleMesh&>(),
                                                                std::declval<const Default_np&>()))>::type;
#else
  /// the vertex index map.
  using Vertex_index_map = VertexIndexMap;

  /// the face index map.
  using Face_index_map = FaceIndexMap;
#endif

  /// @}

private:
  using Solver = internal::Distance_solver<ConcurrencyTag, double, TriangleMesh, Vertex_index_map, Face_index_map>;

public:
  /// \name Creation
  /// All of them read the whole mesh, in linear time.
  ///
  /// \throws Invalid_geodesic_input for the same meshes as `geodesic_distances()`, or
  ///         `geodesic_distances_from_edge_lengths()`; also for faults of components that sources will not reach
  /// @{

  /// reads a mesh with its default maps.
  ///
  /// \param tm the triangle mesh
  explicit Geodesic_distance_solver(const TriangleMesh& tm)
    : Geodesic_distance_solver(tm, get_const_property_map(CGAL::vertex_point, tm))
  {}

  /// reads a mesh with the points of a map.
  ///
  /// \tparam VertexPointMap a model of `ReadablePropertyMap` with the vertex descriptor as key type and a 3D
  ///         point type with the members `x()`, `y()`, `z()` as value type
  ///
  /// \param tm the triangle mesh
  /// \param vertex_point_map gives the point of each vertex
  template <typename VertexPointMap>
  Geodesic_distance_solver(const TriangleMesh& tm, VertexPointMap vertex_point_map)
    : Geodesic_distance_solver(tm, vertex_point_map,
                               CGAL::get_initialized_vertex_index_map(tm, parameters::default_values()),
                               CGAL::get_initialized_face_index_map(tm, parameters::default_values()))
  {}

  /// reads a mesh with the points and the indices of the given maps.
  ///
  /// \tparam VertexPointMap as above
  ///
  /// \param tm the triangle mesh
  /// \param vertex_point_map gives the point of each vertex
  /// \param vertex_index_map gives each vertex a unique index from 0 to `num_vertices(tm) - 1`
  /// \param face_index_map gives each face a unique index from 0 to `num_faces(tm) - 1`
  template <typename VertexPointMap>
  Geodesic_distance_solver(const TriangleMesh& tm, VertexPointMap vertex_point_map,
                           Vertex_index_map vertex_index_map, Face_index_map face_index_map)
    : m_solver(new Solver(tm, vertex_index_map, face_index_map,
                          internal::Shape_from_points<double, TriangleMesh, VertexPointMap>(tm,
                                                                                            vertex_point_map)))
  {}

  /// reads a mesh with named parameters.
  ///
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param tm the triangle mesh
  /// \param np a sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_index_map`,
  ///        `face_index_map`, `faces_to_avoid` and `edges_to_avoid`, as for `geodesic_distances()`. Index maps have the
  ///        types `VertexIndexMap` and `FaceIndexMap`. How to write the sequence:
  ///        \ref Surface_mesh_geodesics_named_parameters.
  ///
  /// \throws Invalid_geodesic_input also if an edge or a face to avoid is not one of the mesh
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  Geodesic_distance_solver(const TriangleMesh& tm, const CGAL_NP_CLASS& np)
    : m_solver(make_solver(tm, internal::shape_from_points<double>(tm, np), np))
  {
    internal::check_parameters<internal::Surface_parameters>(tm, np);
  }

  /// returns a solver that leaves faces out: no path leads through them, as with the parameter `faces_to_avoid` of
  /// `geodesic_distances()`.
  ///
  /// \tparam Faces a range of face descriptors, or a model of `ReadablePropertyMap` with the face descriptor as
  ///         key type and `bool` as value type
  ///
  /// \param tm the triangle mesh
  /// \param faces_to_avoid the faces
  ///
  /// \throws Invalid_geodesic_input also if a face of the range is not one of the mesh
  template <typename Faces>
  static Geodesic_distance_solver avoiding_faces(const TriangleMesh& tm, const Faces& faces_to_avoid)
  {
    return Geodesic_distance_solver(tm, parameters::faces_to_avoid(faces_to_avoid));
  }

  /// returns a solver that leads no path across some edges, as with the parameter `edges_to_avoid` of
  /// `geodesic_distances()`, and leaves faces out.
  ///
  /// \tparam Edges a range of edge descriptors, or a model of `ReadablePropertyMap` with the edge descriptor as
  ///         key type and `bool` as value type
  /// \tparam Faces as for `avoiding_faces()`
  ///
  /// \param tm the triangle mesh
  /// \param edges_to_avoid the edges
  /// \param faces_to_avoid the faces
  ///
  /// \throws Invalid_geodesic_input also if an edge or a face of the ranges is not one of the mesh.
  template <typename Edges, typename Faces = std::array<typename boost::graph_traits<TriangleMesh>::face_descriptor, 0>>
  static Geodesic_distance_solver avoiding_edges(const TriangleMesh& tm, const Edges& edges_to_avoid,
                                                 const Faces& faces_to_avoid = Faces())
  {
    return Geodesic_distance_solver(tm, parameters::edges_to_avoid(edges_to_avoid).faces_to_avoid(faces_to_avoid));
  }

  /// returns a solver for a surface that is given by the lengths of its edges. `TriangleMesh` is a model of
  /// `EdgeListGraph`, too.
  ///
  /// \tparam EdgeLengthMap a model of `ReadablePropertyMap` with the edge descriptor as key type and a number
  ///         type that `CGAL::to_double()` takes as value type
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param tm the triangle mesh
  /// \param edge_length_map the lengths, as for `geodesic_distances_from_edge_lengths()`
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_index_map`,
  ///        `face_index_map`, `faces_to_avoid` and `edges_to_avoid`, as for `geodesic_distances()`. Index maps have the
  ///        types `VertexIndexMap` and `FaceIndexMap`.
  ///
  /// \throws Invalid_geodesic_input also if an edge or a face of the ranges is not one of the mesh
  template <typename EdgeLengthMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
  static Geodesic_distance_solver from_edge_lengths(const TriangleMesh& tm, EdgeLengthMap edge_length_map,
                                                    const CGAL_NP_CLASS& np = parameters::default_values())
  {
    internal::check_parameters<internal::Edge_length_surface_parameters>(tm, np);
    using Shape = internal::Shape_from_edge_lengths<double, TriangleMesh, EdgeLengthMap>;
    return Geodesic_distance_solver(make_solver(tm, Shape(tm, edge_length_map), np));
  }

  /// returns a solver for a surface that is given by the lengths of its edges, with the indices of the
  /// given maps.
  ///
  /// \tparam EdgeLengthMap as above
  ///
  /// \param tm the triangle mesh
  /// \param edge_length_map the lengths, as for `geodesic_distances_from_edge_lengths()`
  /// \param vertex_index_map gives each vertex a unique index from 0 to `num_vertices(tm) - 1`
  /// \param face_index_map gives each face a unique index from 0 to `num_faces(tm) - 1`
  template <typename EdgeLengthMap>
  static Geodesic_distance_solver from_edge_lengths(const TriangleMesh& tm, EdgeLengthMap edge_length_map,
                                                    Vertex_index_map vertex_index_map,
                                                    Face_index_map face_index_map)
  {
    return Geodesic_distance_solver(std::unique_ptr<Solver>(
      new Solver(tm, vertex_index_map, face_index_map,
                 internal::Shape_from_edge_lengths<double, TriangleMesh, EdgeLengthMap>(tm, edge_length_map))));
  }

  /// @}

  /// \name Computation
  /// A computation replaces the results of the one before, unless its input is invalid. It takes the time of a
  /// propagation over the area that it reaches; see `geodesic_distances()`.
  /// @{

  /// computes the distances from a source or from the nearest of several sources.
  ///
  /// \tparam Sources a source or a range of sources
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param sources the source or sources, as for `geodesic_distances()`
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `maximum_distance`, `targets`,
  ///        `source_offsets`, `statistics` and `visitor`, as for `geodesic_distances()`. What the visitor throws is
  ///        passed on; no vertex has been reached then.
  ///
  /// \return `true`, or `false` if the visitor canceled: no vertex has been reached then
  ///
  /// \throws Invalid_geodesic_input for a source, a target or a number that `geodesic_distances()` rejects. The
  ///         results of the computation before are unchanged then; but no vertex has been reached if segments of
  ///         curves nearly coincide (`INVALID_CURVE`), as that is found last.
  template <typename Sources, typename CGAL_NP_TEMPLATE_PARAMETERS>
  bool compute_distances(const Sources& sources, const CGAL_NP_CLASS& np = parameters::default_values())
  {
    internal::check_parameters<internal::Solver_parameters>(np);
    return m_solver->run_with_parameters(sources, np);
  }

  /// computes the distances up to that of a vertex.
  ///
  /// \tparam Sources a source or a range of sources
  ///
  /// \param sources the source or sources, as for `geodesic_distances()`
  /// \param target a vertex of the mesh
  ///
  /// \return the distance of `target`, in the unit of the mesh, or infinity if no source reaches it
  ///
  /// \throws Invalid_geodesic_input if a source or the target is invalid
  template <typename Sources>
  double compute_distance(const Sources& sources, vertex_descriptor target)
  {
    compute_distances(sources, parameters::targets(std::array<vertex_descriptor, 1>{{target}}));
    return distance(target);
  }

  /// @}

  /// \name Results of the Last Computation
  /// Before the first one, no vertex has been reached.
  /// @{

  /// returns the distance of a vertex, in the unit of the mesh. It is infinity if no source reaches the vertex, or if
  /// the computation ended before the distance was final. Takes constant time.
  ///
  /// \param v a vertex
  /// \pre `v` is a vertex of the mesh (this is not checked).
  double distance(vertex_descriptor v) const { return m_solver->distance(v); }

  /// returns the position in the range of sources of a source from which the distance of `v` is measured,
  /// counted from 0, or `no_source` if the distance is infinity. Takes time logarithmic in the number of
  /// sources, and linear in the number of vertices at which the path bends.
  ///
  /// \param v a vertex
  /// \pre `v` is a vertex of the mesh (this is not checked).
  std::size_t nearest_source(vertex_descriptor v) const { return m_solver->nearest_source(v); }

  /// returns the foot of a shortest path to `v`: the point of a curve from which the distance of `v` is measured. Takes
  /// time linear in the number of vertices at which the path bends, and logarithmic in the number of those on curves.
  ///
  /// \param v a vertex
  /// \return the position of the curve in the range of sources, the number of its segment, and where it is on that one;
  ///         `Surface_curve::location()` turns them into a location. Of several such points, it is one of them. The
  ///         curve is `no_source` if the last computation had no curves among its sources, or if the distance is
  ///         infinity.
  /// \pre `v` is a vertex of the mesh (this is not checked).
  Surface_curve_point nearest_curve_point(vertex_descriptor v) const
  {
    if(!m_solver->has_curves() || !(distance(v) < std::numeric_limits<double>::infinity()))
      return {no_source, 0, 0};
    const auto foot = m_solver->foot(v);
    return {foot.curve, foot.segment, foot.parameter};
  }

  /// writes the vertices whose distance is not infinity to an output iterator, each once and in no particular order.
  /// Takes time proportional to the number of vertices that the wavefront has touched.
  ///
  /// \tparam VertexOutputIterator a model of `OutputIterator` that holds vertex descriptors of `TriangleMesh`
  /// \param output receives the vertices
  /// \return the new position of `output`
  template <typename VertexOutputIterator>
  VertexOutputIterator vertices_reached(VertexOutputIterator output) const
  {
    static_assert(internal::Checked_output_iterator<VertexOutputIterator, vertex_descriptor&>::value,
                  "always true, if it compiles");
    if constexpr(internal::Is_output_iterator<VertexOutputIterator, vertex_descriptor&>::value)
      m_solver->for_each_vertex_reached([&output](vertex_descriptor v, double) { *output++ = v; });
    return output;
  }

  /// @}

private:
  friend internal::Private_access;
  explicit Geodesic_distance_solver(std::unique_ptr<Solver> solver) : m_solver(std::move(solver)) {}

  // Reads the mesh with the index maps and the obstacles among the named parameters.
  template <typename Shape, typename NamedParameters>
  static std::unique_ptr<Solver> make_solver(const TriangleMesh& tm, Shape shape, const NamedParameters& np)
  {
    const auto faces = CGAL::get_initialized_face_index_map(tm, np);
    return std::unique_ptr<Solver>(new Solver(tm, CGAL::get_initialized_vertex_index_map(tm, np), faces,
                                              std::move(shape), internal::obstacles(tm, faces, np)));
  }

  const typename Solver::Surface& surface() const { return m_solver->surface(); }

  std::unique_ptr<Solver> m_solver; // refers to itself, so it must not move
};

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_SOLVER_H
