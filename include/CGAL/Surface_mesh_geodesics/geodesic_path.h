// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_PATH_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_PATH_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Lazy_path_structure.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/path_visitors.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <limits>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_geodesics {

#ifndef DOXYGEN_RUNNING
namespace internal {

// Returns whether all types are those of points of the surface; if not, the compiler says what they have to be. (Where
// the result is false, callers are compiled without their work, which would give a hundred more messages.)
template <typename TriangleMesh, typename... Places>
constexpr bool are_places()
{
  constexpr bool result
    = ((Is_vertex<TriangleMesh, Places>::value || Is_face_location<TriangleMesh, Places>::value) && ...);
  static_assert(result, "a point of the surface is a vertex descriptor, or a pair of a face descriptor and three "
                        "barycentric coordinates");
  return result;
}

// The distance of a vertex: a run that ends there.
template <typename TriangleMesh, typename Source, typename Vertex, typename NamedParameters>
double distance_of_vertex(const TriangleMesh& tm, const Source& source, const Vertex& target, const NamedParameters& np)
{
  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  Distance_solver<Sequential_tag, double, TriangleMesh, decltype(vim), decltype(fim)> solver(
    tm, vim, fim, shape_from_points<double>(tm, np), source, obstacles(tm, fim, np));
  Distance_options<TriangleMesh> options;
  options.targets.push_back(target);
  options.statistics = statistics_parameter(np);
  Geodesic_default_visitor visitor;
  solver.run(source, options, visitor);
  const double result = solver.distance(target);
  if(!(result < std::numeric_limits<double>::infinity()))
    reject_unreached_inside(tm, target, np);
  return result;
}

// A point as the structure for paths wants it: a vertex descriptor, or a location with its number type.
template <typename Paths, typename TriangleMesh, typename Place>
auto place_of(const Place& place)
{
  using FT = typename Paths::FT;
  if constexpr(Is_vertex<TriangleMesh, Place>::value)
    return typename Paths::vertex_descriptor(place);
  else
  {
    const auto& b = place.second;
    const Barycentric<double> c = coordinates_in_double(b[0], b[1], b[2]);
    return typename Paths::Face_location{place.first, {{FT(c[0]), FT(c[1]), FT(c[2])}}};
  }
}

// Calls use(paths) with a structure for paths that has the maps among the named parameters, and leads around the faces
// and edges to avoid; it has no sources yet. Returns what use() returns.
template <typename TriangleMesh, typename NamedParameters, typename Use>
auto with_path_structure(const TriangleMesh& tm, const NamedParameters& np, const Use& use)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                              get_const_property_map(CGAL::vertex_point, tm));
  using Kernel = typename Kernel_traits<typename boost::property_traits<decltype(vpm)>::value_type>::Kernel;
  using Traits = Surface_mesh_shortest_path_traits<Kernel, TriangleMesh>;
  using Paths = Lazy_path_structure<Traits, decltype(vim), decltype(fim), decltype(vpm)>;
  Paths paths(tm, vim, fim, vpm, Traits());
  if constexpr(Has_parameter<NamedParameters, internal_np::faces_to_avoid_t>::value)
    paths.avoid_faces(parameters::get_parameter_reference(np, internal_np::faces_to_avoid));
  if constexpr(Has_parameter<NamedParameters, internal_np::edges_to_avoid_t>::value)
    paths.avoid_edges(parameters::get_parameter_reference(np, internal_np::edges_to_avoid));
  return use(paths);
}

// Calls query(paths) with a structure for paths from one source. Returns the distance that it answers, and infinity
// for -1.
template <typename TriangleMesh, typename Source, typename NamedParameters, typename Query>
double query_paths(const TriangleMesh& tm, const Source& source, const NamedParameters& np, const Query& query)
{
  const double result = with_path_structure(tm, np, [&](auto& paths)
  {
    paths.add_source(place_of<std::decay_t<decltype(paths)>, TriangleMesh>(source));
    const double distance = CGAL::to_double(query(paths).first);
    if(Propagation_statistics* const statistics = statistics_parameter(np))
      statistics->add(paths.statistics());
    return distance;
  });
  return result < 0 ? std::numeric_limits<double>::infinity() : result;
}

} // namespace internal
#endif

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

returns the exact geodesic distance between two points of a triangle mesh.

For the distances from one point to many, call `geodesic_distances()`; for many pairs, use a
`Geodesic_distance_solver`, `geodesic_distance_matrix()` or `Surface_mesh_geodesic_paths`.

<b>Complexity.</b> The function reads the mesh, or only the component if one of the points is a vertex. Then it
propagates from one point until the distance of the other one is final: a near pair costs little more than reading. If
neither point is a vertex, the point type of the mesh must be that of a kernel of \cgal.

<b>Thread safety.</b> As for `geodesic_distances()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point1 a vertex descriptor, or a location: a pair of a face descriptor and three barycentric coordinates, of
        `source(halfedge(f, tm), tm)`, `target(halfedge(f, tm), tm)` and `target(next(halfedge(f, tm), tm), tm)`, of any
        number type that `CGAL::to_double()` takes. Between two locations they are rounded to the number type of the
        points.
\tparam Point2 as `Point1`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param a a point of the surface
\param b a point of the surface
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh`
                   as key type and a 3D point type with the members `x()`, `y()`, `z()` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of `tm` a unique index between `0`
                          and `num_vertices(tm) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh`
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{a property map associating to each face of `tm` a unique index between `0`
                          and `num_faces(tm) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the face descriptor of `TriangleMesh`
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{faces_to_avoid}
    \cgalParamDescription{the faces through which no path may lead, as for `geodesic_distances()`}
    \cgalParamType{a range of face descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   face descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
  \cgalParamNBegin{edges_to_avoid}
    \cgalParamDescription{the edges that no path may cross, as for `geodesic_distances()`. If one of the points is on
                          such an edge, the function may propagate over the whole component.}
    \cgalParamType{a range of edge descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   edge descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
  \cgalParamNBegin{statistics}
    \cgalParamDescription{if not null, the computation <em>adds</em> its counts to the object}
    \cgalParamType{a pointer to `Propagation_statistics`}
    \cgalParamDefault{`nullptr`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the distance in the unit of the points; infinity if no path leads from one point to the other. Between two
        locations, it is rounded to the number type of the points.

\throws Invalid_geodesic_input if the mesh or a point is one that `geodesic_distances()` rejects. Its message and
        `element()` do not tell which of both points is at fault
*/
template <typename TriangleMesh, typename Point1, typename Point2, typename CGAL_NP_TEMPLATE_PARAMETERS>
double geodesic_distance(const TriangleMesh& tm, const Point1& a, const Point2& b,
                         const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Pair_parameters>(tm, np);
  if constexpr(!internal::are_places<TriangleMesh, Point1, Point2>())
    return 0;
  else if constexpr(internal::Is_vertex<TriangleMesh, Point2>::value)
    return internal::distance_of_vertex(tm, a, b, np);
  else if constexpr(internal::Is_vertex<TriangleMesh, Point1>::value)
    return internal::distance_of_vertex(tm, b, a, np);
  else
    return internal::query_paths(tm, a, np, [&](auto& paths)
    { return paths.single_distance(internal::place_of<std::decay_t<decltype(paths)>, TriangleMesh>(b)); });
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

writes the points of an exact shortest path from one point of a triangle mesh to another one, and returns its length.

The points are `a`, where the path crosses edges or passes vertices, and `b`; a single one if `a` and `b` are one
point. For many paths, use `Surface_mesh_geodesic_paths`, which computes once for all paths from its source points.

<b>Complexity.</b> The function reads the mesh, propagates from `b` until the distance of `a` is final, and traces the
path in time linear in the number of its points. A near pair costs little more than reading.

<b>Thread safety.</b> As for `geodesic_distances()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point1 as for `geodesic_distance()`
\tparam Point2 as for `geodesic_distance()`
\tparam OutputIterator a model of `OutputIterator` that takes the value type of the point map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param a the point where the path begins
\param b the point where it ends
\param output gets the points, in the order from `a` to `b`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of `geodesic_distance()`

\pre the value type of the point map is `Kernel::Point_3` for a kernel of \cgal

\return the length of the path, rounded to the number type of the points; infinity if there is none. Then nothing is
        written.

\throws Invalid_geodesic_input if the mesh or a point is one that `geodesic_distances()` rejects. Its message and
        `element()` do not tell which of both points is at fault
\throws std::runtime_error if rounding hides the path
*/
template <typename TriangleMesh, typename Point1, typename Point2, typename OutputIterator,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
double geodesic_path(const TriangleMesh& tm, const Point1& a, const Point2& b, OutputIterator output,
                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Pair_parameters>(tm, np);
  if constexpr(!internal::are_places<TriangleMesh, Point1, Point2>())
    return 0;
  else // the structure writes paths to their source
    return internal::query_paths(tm, b, np, [&](auto& paths)
    {
      using Paths = std::decay_t<decltype(paths)>;
      using Points = internal::Points_of_elements<Paths>;
      const Points points(paths);
      internal::Path_point_writer<Points, OutputIterator> writer(points, output);
      const auto result = paths.single_sequence(internal::place_of<Paths, TriangleMesh>(a), writer);
      if(result.first < 0)
        internal::reject_unreached_inside(tm, a, np);
      return result;
    });
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_PATH_H
