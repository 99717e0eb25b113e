// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_CERTIFY_GEODESIC_VORONOI_DIAGRAM_H
#define CGAL_SURFACE_MESH_GEODESICS_CERTIFY_GEODESIC_VORONOI_DIAGRAM_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_Voronoi_certificate.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_certifier.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Private_access.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

checks a geodesic Voronoi diagram.

The function reads the mesh once more, propagates from all sites at once, and proves the result as
`certify_geodesic_distances()` does. It uses nothing of the diagram but its answers, and compares them with paths, and
with the lower bound that is proved:

- The vertices of the mesh have the distances that the proof allows, no smaller and no greater ones.
- Points of an arc and vertices of the diagram have the stated distance from their sites: a path from each site is as
  long.
- No other site is nearer to any of them: the lower bound is not less.
- The same holds between the points of an arc: both sites have an image that all points of the piece of a hyperbola,
  parabola or line between two points see, and the lower bound is not less anywhere on it.
- Each vertex of the mesh has the stated nearest site and distance, and so have the sites, and points of all faces: one
  point in each face, and eight in a face that arcs cross. Of a site that is a curve, points in each part along which no
  other site is as near are looked at.
- Of several sites at one point, the one with the largest weight has the cell, and of equal ones the one with the lowest
  index. The same holds for sites that are equal up to rounding (see `Surface_mesh_geodesic_Voronoi_diagram`).
- The edges around a cell meet end to end, have the cell on their left, and are closed or end at the border of the mesh;
  each edge has one cell on each side, and each arc is in one edge.
- Areas are not negative, and add up to the area of the components that have a site. Where the area of a component is
  no normal number of type `double` (edges shorter than about 1e-154 or longer than 1e154), its last digits or all of
  them are unknown, and count for nothing.

Faces that the diagram avoids (`avoid_faces()`) count as if the mesh did not have them. Walls (`avoid_edges()`) are
borders of the mesh. Points of arcs and vertices of the diagram on a wall are not compared, as their distances there are
those on one side, and paths know the least one.

\ref Surface_mesh_geodesics_certification says what this proves.

If there are walls, nothing is proved: samples are compared with distances that are computed from one site at a time,
and `DISTANCES` and `CURVES` are not checked (their numbers of checks are 0). The time is then that of a propagation for
each site.

<b>Complexity.</b> Time and memory are those of `certify_geodesic_distances()` with all sites as sources and without
computations in reverse, and time linear in the number of points and arcs, times that of the windows of a face. They do
not grow with the number of sites otherwise. For a site that ties with others, paths may be missing in the propagation
from all sites; then one propagation from this site alone is added. With `Parallel_tag` as `ConcurrencyTag` of the
diagram, threads share the proof. The diagram is computed first if that is not done yet.

<b>Thread safety.</b> Several threads may call the function at once, on the same diagram as well; see
`geodesic_distances()`.

\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param diagram the diagram, of a mesh with points
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of the mesh: the map of the diagram}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of the mesh as key type and
                   the point type of the traits as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of the mesh a unique index between `0`
                          and `num_vertices(tm) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of the mesh
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{a property map associating to each face of the mesh a unique index between `0`
                          and `num_faces(tm) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the face descriptor of the mesh
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{halfedge_index_map}
    \cgalParamDescription{a property map associating to each halfedge of the mesh a unique index between `0`
                          and `num_halfedges(tm) - 1`. It is not read.}
    \cgalParamType{a class model of `ReadablePropertyMap` with the halfedge descriptor of the mesh
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return for each condition, how far it is violated and where. The function does not throw because a diagram is wrong.

\throws Invalid_geodesic_input if the mesh or a site is invalid
*/
template <typename Traits, typename VIM, typename HIM, typename FIM, typename VPM, typename ConcurrencyTag,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Geodesic_Voronoi_certificate certify_geodesic_Voronoi_diagram(
  const Surface_mesh_geodesic_Voronoi_diagram<Traits, VIM, HIM, FIM, VPM, ConcurrencyTag>& diagram,
  const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Mesh_parameters>(diagram.triangle_mesh(), np);
  return internal::Private_access::make<Geodesic_Voronoi_certificate>(
    internal::certify_diagram_with_points<Surface_mesh_geodesic_paths, Traits, ConcurrencyTag>(diagram, np));
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

checks a geodesic Voronoi diagram of a surface that is given by the lengths of its edges. Locations are compared by
their barycentric coordinates, as there are no points. Otherwise the function is the same as the one above.

\tparam EdgeLengthMap see `geodesic_distances_from_edge_lengths()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param diagram the diagram
\param edge_length_map the lengths that the diagram was told to use, see
       `Surface_mesh_geodesic_Voronoi_diagram::use_edge_lengths()`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", as above

\return for each condition, how far it is violated and where

\throws Invalid_geodesic_input if the mesh, a length or a site is invalid
*/
template <typename Traits, typename VIM, typename HIM, typename FIM, typename VPM, typename ConcurrencyTag,
          typename EdgeLengthMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Geodesic_Voronoi_certificate certify_geodesic_Voronoi_diagram_from_edge_lengths(
  const Surface_mesh_geodesic_Voronoi_diagram<Traits, VIM, HIM, FIM, VPM, ConcurrencyTag>& diagram,
  EdgeLengthMap edge_length_map, const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Mesh_parameters>(diagram.triangle_mesh(), np);
  return internal::Private_access::make<Geodesic_Voronoi_certificate>(
    internal::certify_diagram_with_edge_lengths<Surface_mesh_geodesic_paths, Traits, ConcurrencyTag>(
      diagram, edge_length_map, np));
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_CERTIFY_GEODESIC_VORONOI_DIAGRAM_H
