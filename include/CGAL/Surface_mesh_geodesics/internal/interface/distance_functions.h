// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DISTANCE_FUNCTIONS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DISTANCE_FUNCTIONS_H

// What the free functions for distances and for matrices of distances do behind their documentation: read the named
// parameters, read the mesh, compute, and write to the user's maps. The room parameters/ knows which parameters there
// are; here their values are used.

#include <CGAL/Surface_mesh_geodesics/internal/interface/Distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Available_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/rows/Distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/rows/peeling_order.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// --- distances ---

// Writes the distances of a solver to a map of the user, in the user's unit, infinity for vertices that are not
// reached. Takes linear time.
template <typename TriangleMesh, typename Solver, typename VertexDistanceMap>
void write_distances(const TriangleMesh& tm, const Solver& solver, VertexDistanceMap distance_map)
{
  using Value = typename boost::property_traits<VertexDistanceMap>::value_type;
  static_assert(std::numeric_limits<Value>::has_infinity,
                "the value type of the distance map must be a floating point type");
  for(const auto v : vertices(tm))
    put(distance_map, v, static_cast<Value>(solver.distance(v)));
}

// Writes the numbers of the nearest sources to a map of the user; the largest std::size_t where no source reaches.
// Takes linear time: the solver remembers the sources of vertices at which paths bend. The overload below is chosen if
// the options have no map.
template <typename TriangleMesh, typename Solver, typename NearestSourceMap>
void write_nearest_sources(const TriangleMesh& tm, const Solver& solver, NearestSourceMap map)
{
  auto source_of = solver.sources_of_vertices();
  for(const auto v : vertices(tm))
    put(map, v, solver.nearest_source(v, source_of));
}

template <typename TriangleMesh, typename Solver>
void write_nearest_sources(const TriangleMesh&, const Solver&, No_nearest_source_map)
{}

// For a point that no path from the source reaches: throws if it is a vertex all of whose faces are avoided. (Sources
// and locations are rejected anyway, when the mesh is read; so both ends of a path are treated alike. Where many
// distances are asked for, vertices inside are simply not reached.) Linear in the number of faces, if faces are to be
// avoided. Requires: the vertex is one of the mesh.
template <typename TriangleMesh, typename Place, typename NamedParameters>
void reject_unreached_inside(const TriangleMesh& tm, const Place& place, const NamedParameters& np)
{
  if constexpr(Has_parameter<NamedParameters, internal_np::faces_to_avoid_t>::value
               && Is_vertex<TriangleMesh, Place>::value)
  {
    using Graph_traits = boost::graph_traits<TriangleMesh>;
    const typename Graph_traits::vertex_descriptor v = place;
    if(halfedge(v, tm) == Graph_traits::null_halfedge())
      return;
    auto fim = CGAL::get_initialized_face_index_map(tm, np);
    const Obstacles avoided{avoided_faces(tm, fim, np), {}};
    for(const auto f : faces_around_target(halfedge(v, tm), tm))
      if(f != Graph_traits::null_face() && !avoided.avoids(static_cast<std::size_t>(get(fim, f))))
        return;
    reject_avoided("the point", Invalid_geodesic_input::no_element);
  }
}

// Computes the distances from sources with given options (parameter_values.h). `shape` tells where the lengths come
// from (Face_shapes.h), `visitor` is told of the progress. Rules and FT, the pruning rules and the number type of the
// computation, are the defaults except in tests and measurements. Checks the numbers in the options before it reads the
// mesh. Returns false if the visitor cancels.
//
// The maps are written last: if an exception or the visitor ends the computation, they are unchanged. Index maps come
// from the named parameters or the mesh; those that CGAL makes itself take linear time and memory.
template <typename ConcurrencyTag, typename Rules = All_pruning_rules, typename FT = double, typename TriangleMesh,
          typename VertexDistanceMap, typename Sources, typename Options, typename Shape, typename Visitor,
          typename NamedParameters>
bool compute_geodesic_distances(const TriangleMesh& tm, VertexDistanceMap vertex_distance_map, const Sources& sources,
                                const Options& options, Shape shape, Visitor& visitor, const NamedParameters& np)
{
  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  check_numbers(options);
  Distance_solver<ConcurrencyTag, FT, TriangleMesh, decltype(vim), decltype(fim), Rules> solver(
    tm, vim, fim, std::move(shape), sources, obstacles(tm, fim, np));
  if(!solver.run(sources, options, visitor))
    return false;
  write_distances(tm, solver, vertex_distance_map);
  write_nearest_sources(tm, solver, options.nearest_source_map);
  return true;
}

// Does the same for the functions of geodesic_distances.h, with the options and the visitor among the named parameters
// of a user. The values of ranges are copied once, which takes linear time; the maps are those of the user.
template <typename ConcurrencyTag, typename TriangleMesh, typename VertexDistanceMap, typename Sources, typename Shape,
          typename NamedParameters>
bool compute_distances_with_parameters(const TriangleMesh& tm, VertexDistanceMap vertex_distance_map,
                                       const Sources& sources, Shape shape, const NamedParameters& np)
{
  // A user who swaps the map and the sources reads this first; the errors that follow are about iterators.
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  static_assert(Is_map_for<VertexDistanceMap, vertex_descriptor, double>::value,
                "distances cannot be written to this argument; it is a property map from the vertices of the mesh to "
                "floating-point numbers, and comes before the sources");
  Visitor_parameter<NamedParameters> visitor_parameter(np);
  auto& visitor = visitor_parameter.visitor();
  return compute_geodesic_distances<ConcurrencyTag>(tm, vertex_distance_map, sources,
                                                    distance_options<TriangleMesh>(np), std::move(shape), visitor, np);
}

// The sides of all vertices are known before the propagation starts: curves that do not separate the surface are
// rejected at once. The sign of a distance of zero would mean nothing, so it has none.
//
// Writes the signed distances from curves; see signed_geodesic_distances(). The map is unchanged if this throws or
// returns false.
//
// The sides are found before the propagation, while the curves are in the mesh: so curves that do not separate the
// surface cost no propagation. A vertex on a curve has the distance 0, whatever side its flag tells. Infinite distances
// get the sign of their side as well.
template <typename TriangleMesh, typename VertexDistanceMap, typename Curves, typename Shape, typename NamedParameters>
bool compute_signed_distances(const TriangleMesh& tm, VertexDistanceMap vertex_distance_map, const Curves& curves,
                              Shape shape, const NamedParameters& np)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  static_assert(Is_map_for<VertexDistanceMap, vertex_descriptor, double>::value,
                "distances cannot be written to this argument; it is a property map from the vertices of the mesh to "
                "floating-point numbers, and comes before the curves");
  static_assert(Are_curves<Curves>::value, "signed distances are measured from curves");
  using Value = typename boost::property_traits<VertexDistanceMap>::value_type;
  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  const auto options = distance_options<TriangleMesh>(np);
  check_numbers(options);
  Visitor_parameter<NamedParameters> visitor_parameter(np);
  Distance_solver<Sequential_tag, double, TriangleMesh, decltype(vim), decltype(fim)> solver(
    tm, vim, fim, std::move(shape), curves, obstacles(tm, fim, np));
  std::vector<char> is_negative; // by vertex of the intrinsic mesh, whose numbers are not those of the user
  if(!solver.run_with_sides(curves, options, visitor_parameter.visitor(), is_negative))
    return false;
  for(const auto v : vertices(tm))
  {
    const double d = solver.distance(v);
    const bool has_minus = d > 0 && is_negative[solver.nearest_copy(v)] != 0;
    put(vertex_distance_map, v, static_cast<Value>(has_minus ? -d : d));
  }
  return true;
}

// Returns the shape of the faces from the point map among the named parameters, or from the points of the mesh if there
// is none. The map is copied, and the mesh referred to. Takes constant time: points are read when the mesh is.
template <typename FT, typename TriangleMesh, typename NamedParameters>
auto shape_from_points(const TriangleMesh& tm, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                              get_const_property_map(CGAL::vertex_point, tm));
  return Shape_from_points<FT, TriangleMesh, decltype(vpm)>(tm, vpm);
}

// --- matrices of distances ---

// Reads a mesh with the maps among the named parameters, and returns use(surface). The surface ends with the call. So
// what is computed from it has to be copied, or written where the caller finds it.
//
// All components are read, as each row may start in another one. With Parallel_tag, threads share the work of reading.
//
// obstacles_of(face index map) returns what is avoided. It is a function, as index maps that CGAL makes itself cost
// linear time, and are made once.
template <typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters, typename ObstaclesOf,
          typename Use>
bool with_surface_without(const TriangleMesh& tm, const NamedParameters& np, const ObstaclesOf& obstacles_of, Use use)
{
  using Blocks = typename Blocks_for_tag<typename Available_tag<ConcurrencyTag>::type>::type;
  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  const Intrinsic_surface<double, TriangleMesh, decltype(vim), decltype(fim)> surface(
    tm, vim, fim, shape_from_points<double>(tm, np), Blocks(), obstacles_of(fim));
  return use(surface);
}

// The same without the faces and edges to avoid among the named parameters.
template <typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters, typename Use>
bool with_surface(const TriangleMesh& tm, const NamedParameters& np, Use use)
{
  return with_surface_without<ConcurrencyTag>(
    tm, np, [&](const auto& fim) { return obstacles(tm, fim, np); }, use);
}

// The functions below compute the rows of a matrix and pass them to `output`; they return false if `output` ends the
// computation. All sources and targets are checked before the first row, and Invalid_geodesic_input is thrown.
//
// `surface` is an Intrinsic_surface, which they only read: sources in faces are inserted into copies of its mesh
// (Matrix_worker). So several threads may use one surface at once. Distance_matrix.h says what a row holds and in which
// order rows come.
template <typename ConcurrencyTag, typename Surface, typename Sources, typename Targets, typename RowOutput>
bool put_distance_matrix(const Surface& surface, const Sources& sources, const Targets& targets, RowOutput& output)
{
  const Distance_matrix<double> matrix(surface.mesh(), surface.source_set(sources), surface.copies());
  return matrix.put_dense_rows(typename Available_tag<ConcurrencyTag>::type(),
                               surface.checked_ids(targets, "target"), output);
}

// The vertices of `range` are sources and targets. Row i ends with the distance to the last of them, and begins with
// that to itself.
template <typename ConcurrencyTag, typename Surface, typename Vertices, typename RowOutput>
bool put_symmetric_distance_matrix(const Surface& surface, const Vertices& range, RowOutput& output)
{
  const Distance_matrix<double> matrix(surface.mesh(), surface.source_set_of_vertices(range, "source"),
                                       surface.copies());
  return matrix.put_triangular_rows(typename Available_tag<ConcurrencyTag>::type(), output);
}

// Returns the vertices of `range` in the order of peeling_order.h; none if go_further() returns false. The order is a
// means to save time only, so of a vertex that walls divide the first copy decides.
template <typename Surface, typename Vertices, typename GoFurther>
auto peeled_vertices(const Surface& surface, const Vertices& range, const GoFurther& go_further)
{
  std::vector<typename Surface::vertex_descriptor> vertices, result;
  // The message for a range of something else is in checked_ids().
  if constexpr(Is_range_of<Vertices, typename Surface::vertex_descriptor>::value)
    for(const auto v : range)
      vertices.push_back(v); // NOLINT(performance-inefficient-vector-operation): a range need not know its size
  result.reserve(vertices.size());
  for(const std::size_t i : peeling_order(surface.mesh(), surface.checked_ids(range, "vertex"), go_further))
    result.push_back(vertices[i]);
  return result;
}

// `maximum_distance` is in the user's unit. Requires: check_maximum_distance(maximum_distance) does not throw.
template <typename ConcurrencyTag, typename Surface, typename Sources, typename Targets, typename RowOutput>
bool put_sparse_distance_matrix(const Surface& surface, const Sources& sources, const Targets& targets,
                                double maximum_distance, RowOutput& output)
{
  const Distance_matrix<double> matrix(surface.mesh(), surface.source_set(sources), surface.copies());
  return matrix.put_sparse_rows(typename Available_tag<ConcurrencyTag>::type(),
                                surface.checked_ids(targets, "target"), maximum_distance, output);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DISTANCE_FUNCTIONS_H
