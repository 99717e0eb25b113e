// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_MATRIX_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_MATRIX_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Private_access.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

computes the exact geodesic distances from each of several sources to each of several target vertices.

The function passes the rows of the matrix on one by one, so the matrix need not fit in memory: it calls
`row_output(i, row)` for each source, where `i` is the position of the source and `row[j]` is the distance of the target
at position `j`. Rows come one after the other, in the order of the sources, whatever the number of threads that compute
them. The calls may come from different threads, but never two at a time. A row has the bits that `geodesic_distances()`
computes from its source alone, whatever the tag and the number of threads are.

<b>Complexity.</b> Each row takes the time of a propagation up to the farthest target. The function reads the mesh once;
each thread reuses its memory for all its rows, and at most four rows for each thread are in memory. If there are
sources in faces, each thread also has a copy of the intrinsic mesh.

<b>Thread safety.</b> As for `geodesic_distances()`. One thread at a time calls `row_output`, and each call sees the
effects of those before. `row_output` must not change the mesh.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: whether rows are computed in
        parallel. The number of threads is that of \tbb, which may be limited with `tbb::task_arena` or
        `tbb::global_control`.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam Sources a source or a range of sources, as for `geodesic_distances()`: vertices, or locations in faces
\tparam Targets a range of vertex descriptors of `TriangleMesh`; it may contain a vertex several times
\tparam RowOutput a function object that takes a `std::size_t` and a `const std::vector<double>&`, which is valid during
        the call only. If it returns a value, the value is converted to `bool`, and `false` ends the computation.
        If it also has a member function `go_further()` without parameters, all threads call it while they compute
        rows, several at a time. The computation ends once it returns `false`; from then on it has to return `false`.
        Rows that have begun are not passed on.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param sources the sources
\param targets the targets; for all vertices `vertices(tm)`
\param row_output is called for each row. Distances are in the unit of the points, infinity where the source does not
       reach.
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
    \cgalParamDescription{the edges that no path may cross, as for `geodesic_distances()`. The distance of a
                          target on such an edge is the least of its sides.}
    \cgalParamType{a range of edge descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   edge descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `true`, or `false` if `row_output` ended the computation

\throws Invalid_geodesic_input for a mesh, a source or a target that `geodesic_distances()` rejects, before the first
        call of `row_output`. What `row_output` throws ends the computation and is passed on.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Sources, typename Targets,
          typename RowOutput, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool geodesic_distance_matrix(const TriangleMesh& tm, const Sources& sources, const Targets& targets,
                              RowOutput row_output, const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Matrix_parameters>(tm, np);
  return internal::with_surface<ConcurrencyTag>(tm, np, [&](const auto& surface)
  {
    return internal::put_distance_matrix<ConcurrencyTag>(surface, sources, targets, row_output);
  });
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

computes a matrix of distances as the function above does, on the mesh that a solver has read. The results of the last
computation of the solver are unchanged. Use this function for surfaces that are given by edge lengths.

<b>Thread safety.</b> That of a `const` member function of `Geodesic_distance_solver`.

\tparam ConcurrencyTag as above; that of the solver, `SolverTag`, has no effect
\tparam Sources as above
\tparam Targets as above
\tparam RowOutput as above

\param solver the solver
\param sources the sources
\param targets the targets
\param row_output is called for each row, as above

\return `true`, or `false` if `row_output` ended the computation

\throws Invalid_geodesic_input if a source or a target is invalid, before the first call of `row_output`
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename SolverTag,
          typename VertexIndexMap, typename FaceIndexMap, typename Sources, typename Targets, typename RowOutput>
bool geodesic_distance_matrix(
  const Geodesic_distance_solver<TriangleMesh, SolverTag, VertexIndexMap, FaceIndexMap>& solver,
  const Sources& sources, const Targets& targets, RowOutput row_output)
{
  return internal::put_distance_matrix<ConcurrencyTag>(internal::Private_access::surface(solver),
                                                       sources, targets, row_output);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

computes the exact geodesic distances between all pairs of several vertices.

It does what `geodesic_distance_matrix()` does, with the vertices as sources and targets, but computes the distance of
each pair once: `row[k]` is the distance from the vertex at position `i` to the one at position `i + k`, for `k = 0`,
..., `n - 1 - i` if there are `n` vertices. So the computation of row `i` ends as soon as the distances of all later
vertices are final. (Distances there and back may differ in the last digits.)

<b>The order</b> of the vertices decides about the time. In the order of `geodesic_peeling_order()`, the vertices that
are left lie near to each other, and rows leave out the rest of the surface: windows that cannot lead to one of them are
removed, by the triangle inequality with some landmarks. The rows keep their bits. \ref Surface_mesh_geodesics_rows
has measured times.

<b>Complexity.</b> As above. With 512 vertices or more, 16 rows are added for the landmarks, and 64 bytes for each
vertex of the mesh.

\tparam ConcurrencyTag as for `geodesic_distance_matrix()`
\tparam TriangleMesh a model of `FaceListGraph`
\tparam Vertices a range of vertex descriptors of `TriangleMesh`
\tparam RowOutput as for `geodesic_distance_matrix()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param vertices the vertices
\param row_output is called as `row_output(i, row)` for each vertex
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
       `geodesic_distance_matrix()`

\return `true`, or `false` if `row_output` ended the computation

\throws Invalid_geodesic_input if the mesh or a vertex is invalid, before the first call of `row_output`; also if a
        vertex is inside of the faces to avoid: leave such vertices out, or call `geodesic_distance_matrix()` with them
        as targets only
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Vertices, typename RowOutput,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
bool symmetric_geodesic_distance_matrix(const TriangleMesh& tm, const Vertices& vertices, RowOutput row_output,
                                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Matrix_parameters>(tm, np);
  return internal::with_surface<ConcurrencyTag>(tm, np, [&](const auto& surface)
  {
    return internal::put_symmetric_distance_matrix<ConcurrencyTag>(surface, vertices, row_output);
  });
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

computes the distances between all pairs of several vertices as the function above does, on the mesh that a solver has
read. The results of the last computation of the solver are unchanged.

\tparam ConcurrencyTag as above; that of the solver, `SolverTag`, has no effect
\tparam Vertices as above
\tparam RowOutput as above

\param solver the solver
\param vertices the vertices
\param row_output is called for each vertex, as above

\return `true`, or `false` if `row_output` ended the computation

\throws Invalid_geodesic_input if a vertex is invalid, before the first call of `row_output`
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename SolverTag,
          typename VertexIndexMap, typename FaceIndexMap, typename Vertices, typename RowOutput>
bool symmetric_geodesic_distance_matrix(
  const Geodesic_distance_solver<TriangleMesh, SolverTag, VertexIndexMap, FaceIndexMap>& solver,
  const Vertices& vertices, RowOutput row_output)
{
  return internal::put_symmetric_distance_matrix<ConcurrencyTag>(internal::Private_access::surface(solver),
                                                                 vertices, row_output);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

returns vertices in an order in which `symmetric_geodesic_distance_matrix()` takes less time than in most others: the
surface is peeled from its far end. In each component, the vertex that is farthest from the first one is an end; the
vertices are sorted by descending distance from it. Components keep the order of their first vertices.

<b>Complexity.</b> Three propagations over the components of the vertices, and the sorting.

<b>Thread safety.</b> As for `geodesic_distances()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Vertices a range of vertex descriptors of `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param vertices the vertices
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
       `geodesic_distance_matrix()`, and a `visitor` as for `geodesic_distances()`, which sees one propagation with the
       visits of all three

\return a `std::vector` of vertex descriptors: the same ones in the new order. A vertex that occurs several times still
        does. It is empty if the visitor has canceled.

\throws Invalid_geodesic_input if the mesh or a vertex is invalid
*/
template <typename TriangleMesh, typename Vertices, typename CGAL_NP_TEMPLATE_PARAMETERS>
auto geodesic_peeling_order(const TriangleMesh& tm, const Vertices& vertices,
                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Peeling_parameters>(tm, np);
  internal::Visitor_parameter<CGAL_NP_CLASS> parameter(np);
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> result;
  internal::with_surface<Sequential_tag>(tm, np, [&](const auto& surface)
  {
    return internal::run_with_visitor(parameter.visitor(), 3 * num_vertices(tm), [&](const auto& go_on)
    {
      std::size_t visits = 0;
      result = internal::peeled_vertices(surface, vertices, [&]() { return go_on(++visits, 0.); });
      return true;
    });
  });
  return result;
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

returns vertices in the order of the function above, on the mesh that a solver has read. The results of the last
computation of the solver are unchanged.

\tparam Vertices as above

\param solver the solver
\param vertices the vertices

\return a `std::vector` of vertex descriptors: the same ones in the new order

\throws Invalid_geodesic_input if a vertex is invalid
*/
template <typename TriangleMesh, typename SolverTag, typename VertexIndexMap, typename FaceIndexMap, typename Vertices>
auto geodesic_peeling_order(
  const Geodesic_distance_solver<TriangleMesh, SolverTag, VertexIndexMap, FaceIndexMap>& solver,
  const Vertices& vertices)
{
  return internal::peeled_vertices(internal::Private_access::surface(solver), vertices, []() { return true; });
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

computes the exact geodesic distances from each of several sources to those of several target vertices that are within
a radius.

It does what `geodesic_distance_matrix()` does, but a row is a `const std::vector<std::pair<std::size_t, double>>&`: the
positions of the targets whose distance is at most `maximum_distance`, in ascending order, with their distances. The
time for a row depends on the area within the radius, not on the number of targets or on the size of the mesh.

\tparam ConcurrencyTag as for `geodesic_distance_matrix()`
\tparam TriangleMesh a model of `FaceListGraph`
\tparam Sources as for `geodesic_distance_matrix()`
\tparam Targets as for `geodesic_distance_matrix()`
\tparam RowOutput as for `geodesic_distance_matrix()`, except for the type of a row
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param sources the sources
\param targets the targets; for all vertices `vertices(tm)`
\param maximum_distance the radius, in the unit of the mesh; not negative
\param row_output is called for each row
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
       `geodesic_distance_matrix()`

\return `true`, or `false` if `row_output` ended the computation

\throws Invalid_geodesic_input also if the radius is negative or not a number
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Sources, typename Targets,
          typename RowOutput, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool sparse_geodesic_distance_matrix(const TriangleMesh& tm, const Sources& sources, const Targets& targets,
                                     double maximum_distance, RowOutput row_output,
                                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_maximum_distance(maximum_distance);
  internal::check_parameters<internal::Matrix_parameters>(tm, np);
  return internal::with_surface<ConcurrencyTag>(tm, np, [&](const auto& surface)
  {
    return internal::put_sparse_distance_matrix<ConcurrencyTag>(surface, sources, targets, maximum_distance,
                                                                row_output);
  });
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

computes the distances within a radius as the function above does, on the mesh that a solver has read. The results of
the last computation of the solver are unchanged.

\tparam ConcurrencyTag as above; that of the solver, `SolverTag`, has no effect
\tparam Sources as above
\tparam Targets as above
\tparam RowOutput as above

\param solver the solver
\param sources the sources
\param targets the targets
\param maximum_distance the radius, in the unit of the mesh; not negative
\param row_output is called for each row, as above

\return `true`, or `false` if `row_output` ended the computation

\throws Invalid_geodesic_input if a source, a target or the radius is invalid, before the first call of `row_output`
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename SolverTag,
          typename VertexIndexMap, typename FaceIndexMap, typename Sources, typename Targets, typename RowOutput>
bool sparse_geodesic_distance_matrix(
  const Geodesic_distance_solver<TriangleMesh, SolverTag, VertexIndexMap, FaceIndexMap>& solver, const Sources& sources,
  const Targets& targets, double maximum_distance, RowOutput row_output)
{
  internal::check_maximum_distance(maximum_distance);
  return internal::put_sparse_distance_matrix<ConcurrencyTag>(internal::Private_access::surface(solver),
                                                              sources, targets, maximum_distance,
                                                              row_output);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_MATRIX_H
