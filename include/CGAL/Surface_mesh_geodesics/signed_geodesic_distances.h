// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_SIGNED_GEODESIC_DISTANCES_H
#define CGAL_SURFACE_MESH_GEODESICS_SIGNED_GEODESIC_DISTANCES_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_parameters.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

computes the signed geodesic distance of each vertex from curves that separate the surface: the exact distance from the
nearest point of a curve, as `geodesic_distances()` computes it, negative on one side of the curves.

Curves <em>separate</em> the surface if every way from one side of a curve to the other crosses a curve: closed
curves around a region do, and so does an open one from border to border. The side changes where a curve is crossed, so
that a region inside of a region is on the outer side again. A point, and a part of a curve that is run along twice (or
another even number of times), have no sides: they separate nothing, and if there is nothing else, all distances are
positive.

The negative side is on the left of the first segment of the first curve, as seen on the outside of the surface; in each
component without that segment, on the left of the first one there. Parts of segments without sides do not count; where
curves run along another part several times, the first time counts. A vertex on a curve has the distance 0. Vertices of
components without a curve have the distance infinity, and those beyond the radius infinity with the sign of their side.

Edges to avoid cut the surface like borders: no way crosses them, so a curve from one of them to another may separate
it, and parts that they cut off are components. A vertex that they divide has the sign of its nearest side. All other
vertices in the component of the first segment keep the sign that they have without these edges, if the curves separate
the surface then.

Takes the time of `geodesic_distances()`, in a single thread, plus time linear in the size of the mesh.

<b>Thread safety.</b> As for `geodesic_distances()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexDistanceMap a model of `WritablePropertyMap` with the vertex descriptor of
        `TriangleMesh` as key type and a floating point type as value type
\tparam Curves a `Surface_curve` or a range of these
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param vertex_distance_map receives the signed distance of each vertex, in the unit of the points
\param curves the curve or curves
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_index_map`,
       `face_index_map`, `visitor`, `maximum_distance`, `statistics`, `faces_to_avoid` and `edges_to_avoid`, as for
       `geodesic_distances()`

\return `true`, or `false` if the visitor canceled the computation; only the statistics have changed then.

\throws Invalid_geodesic_input for the input that `geodesic_distances()` rejects; with the reason `INVALID_CURVE` also
        if the curves do not separate the surface. The map is unchanged then.

\sa `Surface_curve`
*/
template <typename TriangleMesh, typename VertexDistanceMap, typename Curves,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
bool signed_geodesic_distances(const TriangleMesh& tm, VertexDistanceMap vertex_distance_map, const Curves& curves,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Signed_distance_parameters>(tm, np);
  return internal::compute_signed_distances(tm, vertex_distance_map, curves,
                                            internal::shape_from_points<double>(tm, np), np);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_SIGNED_GEODESIC_DISTANCES_H
