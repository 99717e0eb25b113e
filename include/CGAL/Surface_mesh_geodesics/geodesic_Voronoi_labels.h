// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_LABELS_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_LABELS_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_parameters.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Voronoi_labels.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

finds, for each vertex of a triangle mesh, the site in whose geodesic Voronoi cell it is.

The function writes to `vertex_site_map`, for each vertex of `tm`, the number of the nearest site: its position in the
range `sites`, counted from 0. These are the answers of `Surface_mesh_geodesic_Voronoi_diagram::nearest_site()` for
vertices, at the price of `geodesic_distances()`: there is one propagation from all sites, and no curves between cells
are computed. Use the diagram if you need these curves, or the sites of points that are not vertices.

A vertex that no site reaches gets the largest number of type `std::size_t`; so do all vertices if the range of sites is
empty. If several sites are equally near, a vertex gets one of them; of several sites at one point, the first. A vertex
on several curves with the same weight gets the first of them.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`, as for `geodesic_distances()`
\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexSiteMap a model of `WritablePropertyMap` with the vertex descriptor of `TriangleMesh` as key type and
        `std::size_t` as value type
\tparam Sites a site or a range of sites: vertex descriptors, locations in faces, or curves
        (`CGAL::Surface_mesh_geodesics::Surface_curve`). These are the types that `geodesic_distances()` takes for
        sources.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param vertex_site_map receives the number of the nearest site of each vertex
\param sites the site or sites
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
  \cgalParamNBegin{visitor}
    \cgalParamDescription{a visitor that follows the progress and may cancel the computation}
    \cgalParamType{a class model of `GeodesicPropagationVisitor`}
    \cgalParamDefault{`Geodesic_default_visitor`}
    \cgalParamExtra{The visitor is not copied if it is passed with `std::ref()`.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_distance_map}
    \cgalParamDescription{a property map that receives the distance of each vertex from its nearest site, in the unit of
                          the points; infinity where no site reaches it}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertex descriptor of `TriangleMesh` as key type and
                   a floating point type as value type, passed by value}
    \cgalParamDefault{none: distances are not written}
  \cgalParamNEnd
  \cgalParamNBegin{site_weights}
    \cgalParamDescription{empty, or the weight of each site, in the unit of the points. The distance of a vertex from a
                          site is the geodesic distance minus the weight of the site, as in
                          `Surface_mesh_geodesic_Voronoi_diagram`. It may be negative.}
    \cgalParamType{a range of numbers that convert to `double`}
    \cgalParamDefault{an empty range: all weights are 0}
  \cgalParamNEnd
  \cgalParamNBegin{statistics}
    \cgalParamDescription{if not null, the computation <em>adds</em> its counts to the object, also if the visitor
                          canceled it.}
    \cgalParamType{a pointer to `Propagation_statistics`}
    \cgalParamDefault{`nullptr`}
  \cgalParamNEnd
  \cgalParamNBegin{faces_to_avoid}
    \cgalParamDescription{the faces through which no path may lead, as for `geodesic_distances()`}
    \cgalParamType{a range of face descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   face descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
  \cgalParamNBegin{edges_to_avoid}
    \cgalParamDescription{the edges that no path may cross, as for `geodesic_distances()`. A site on such an edge
                          is on both sides, and a vertex has the site that is nearest to one of its sides.}
    \cgalParamType{a range of edge descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   edge descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
\cgalNamedParamsEnd

How to write sequences of parameters, and which one comes first: \ref Surface_mesh_geodesics_named_parameters.

\return `true`, or `false` if the visitor canceled the computation; the maps are unchanged then.

\throws Invalid_geodesic_input if the mesh or a site is invalid, as for `geodesic_distances()`, if a weight is not
        finite or differs too much from the largest one, or if there is not one weight for each site. The maps are
        unchanged then.

Complexity and thread safety are those of `geodesic_distances()`.

\sa `Surface_mesh_geodesic_Voronoi_diagram`
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename VertexSiteMap, typename Sites,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
bool geodesic_Voronoi_labels(const TriangleMesh& tm, VertexSiteMap vertex_site_map, const Sites& sites,
                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Label_parameters>(tm, np);
  return internal::compute_Voronoi_labels<ConcurrencyTag>(tm, vertex_site_map, sites, np);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_LABELS_H
