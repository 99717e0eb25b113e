// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_CERTIFY_GEODESIC_DISTANCES_H
#define CGAL_SURFACE_MESH_GEODESICS_CERTIFY_GEODESIC_DISTANCES_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_certificate.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_parameters.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Distance_certifier.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

checks that given distances are the geodesic distances from a source, or from the nearest of several sources, to the
vertices of a triangle mesh.

The function does not compare the distances with other computed distances. It constructs a proof that they are right
and checks each step of the proof:

- No distance is too short, because a path of this length leads from each vertex to a source. Paths are measured piece
  by piece; each piece must lie in one face, and the last one must end at a source.
- No distance is too long. The proof is a function on all edges of the mesh that grows, between any two points on the
  border of one face, by at most their distance in the plane of the face. Then it grows along no path by more than the
  length of the path, so its value at a vertex is a lower bound of the distance. The condition is checked for all pairs
  of points of all faces (see \ref Surface_mesh_geodesics_certification).

A propagation proposes the paths and the function; if it errs, the proof fails. In addition, the function checks some
conditions that need no propagation (`REACH`, `SOURCES`, `EDGES`, `PAIRS_OF_FACES`), and computes some distances in
reverse. It trusts the edge lengths that it has read, and the insertion of sources that are not vertices: faces that a
curve crosses are divided along it. All points of a curve count as sources in the proof.

If no condition is violated by more than \f$ \delta \f$, a distance is too short by at most \f$ \delta \f$, and too long
by at most \f$ (2 m + 3) \delta \f$, relative to the sum of the distance and the longest edge of the mesh, where
\f$ m \f$ is the number of faces that a shortest path crosses.

<b>Complexity.</b> Takes the time and the memory of a propagation that keeps its windows. In addition it takes time at
most quadratic in the number of windows of an edge, for each edge, and linear in the number of faces that a path
crosses, for each vertex. With curves, each of the propagations in reverse keeps its windows, too, and goes on to the
end.

<b>Parallelism.</b> With `Parallel_tag`, threads share the checks of paths and of lower bounds, which take most of the
time; the propagations and the reading of the mesh and the maps stay in the calling thread, which alone calls the
functions of the visitor. The result is the same with any tag and any number of threads.

<b>Thread safety.</b> Several threads may call the function at once, on the same mesh and the same map as well, if
no thread modifies them; see `geodesic_distances()`.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`, as for `geodesic_distances()`
\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexDistanceMap a model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh` as key type and
        a number type that `CGAL::to_double()` takes as value type
\tparam Sources a source or a range of sources, points or curves, as for `geodesic_distances()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param vertex_distance_map the distances, in the unit of the points. Any number is accepted, also an infinite one and
       NaN.
\param sources the source or sources, as for `geodesic_distances()`
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
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the number of vertices from which distances are computed in reverse; not negative}
    \cgalParamType{unsigned int}
    \cgalParamDefault{`4`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{a visitor that follows each propagation. The first one (with edges to avoid, the second
                          one) includes the checks of paths and of lower bounds, during which the numbers do not
                          change. If the visitor cancels, the function returns at once, and the conditions that it
                          has not checked to the end are violated infinitely.}
    \cgalParamType{a model of `GeodesicPropagationVisitor`}
    \cgalParamDefault{`Geodesic_default_visitor`}
    \cgalParamExtra{The visitor is not copied if it is passed with `std::ref()`.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_distance}
    \cgalParamDescription{the radius with which the distances were computed, in the unit of the mesh; not negative.
                          Vertices beyond it must have an infinite distance.}
    \cgalParamType{a number that converts to `double`}
    \cgalParamDefault{infinity}
  \cgalParamNEnd
  \cgalParamNBegin{source_offsets}
    \cgalParamDescription{empty, or the offset of each source with which the distances were computed; see
                          `geodesic_distances()`}
    \cgalParamType{a range of numbers that convert to `double`}
    \cgalParamDefault{an empty range: all offsets are 0}
  \cgalParamNEnd
  \cgalParamNBegin{faces_to_avoid}
    \cgalParamDescription{the faces through which no path may lead, with which the distances were computed; see
                          `geodesic_distances()`. The proof is one for the mesh without these faces.}
    \cgalParamType{a range of face descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   face descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
  \cgalParamNBegin{edges_to_avoid}
    \cgalParamDescription{the edges that no path may cross, as for `geodesic_distances()`. The distance of a
                          vertex on such an edge is the least of its sides. The certificate checks all of them, and
                          an extra propagation proposes those that are not the least.}
    \cgalParamType{a range of edge descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   edge descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
\cgalNamedParamsEnd

How to write sequences of parameters, and which one comes first: \ref Surface_mesh_geodesics_named_parameters.

\return for each condition, how far it is violated and where. The function does not throw because distances are wrong.

\throws Invalid_geodesic_input if the mesh, a source, a curve, the radius, an offset, or a face or an edge to avoid is
        invalid, as `geodesic_distances()` does
\throws std::bad_alloc if there is not enough memory for the windows
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename VertexDistanceMap, typename Sources,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Geodesic_distance_certificate<TriangleMesh>
certify_geodesic_distances(const TriangleMesh& tm, VertexDistanceMap vertex_distance_map, const Sources& sources,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Distance_certificate_parameters>(tm, np);
  return internal::certify_distances<ConcurrencyTag, Geodesic_distance_certificate<TriangleMesh>>(
    tm, vertex_distance_map, sources, [&]() { return internal::shape_from_points<double>(tm, np); }, np);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

checks distances on a surface that is given by its edge lengths. Complexity, parallelism and thread safety are those of
`certify_geodesic_distances()`.

\tparam ConcurrencyTag as for `certify_geodesic_distances()`
\tparam TriangleMesh a model of `FaceListGraph` and `EdgeListGraph`
\tparam VertexDistanceMap as for `certify_geodesic_distances()`
\tparam Sources as for `geodesic_distances()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam EdgeLengthMap see `geodesic_distances_from_edge_lengths()`

\param tm the triangle mesh
\param edge_length_map the lengths
\param vertex_distance_map the distances
\param sources the source or sources
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
       `certify_geodesic_distances()`, except `vertex_point_map`

\return for each condition, how far it is violated and where

\throws Invalid_geodesic_input as `geodesic_distances_from_edge_lengths()` does
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename EdgeLengthMap,
          typename VertexDistanceMap, typename Sources, typename CGAL_NP_TEMPLATE_PARAMETERS>
Geodesic_distance_certificate<TriangleMesh>
certify_geodesic_distances_from_edge_lengths(const TriangleMesh& tm, EdgeLengthMap edge_length_map,
                                             VertexDistanceMap vertex_distance_map, const Sources& sources,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Edge_length_certificate_parameters>(tm, np);
  return internal::certify_distances<ConcurrencyTag, Geodesic_distance_certificate<TriangleMesh>>(
    tm, vertex_distance_map, sources,
    [&]()
    {
      return internal::Shape_from_edge_lengths<double, TriangleMesh, EdgeLengthMap>(tm, edge_length_map);
    },
    np);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_CERTIFY_GEODESIC_DISTANCES_H
