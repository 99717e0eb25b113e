// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_FARTHEST_POINT_SAMPLING_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_FARTHEST_POINT_SAMPLING_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_parameters.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

writes vertices that are spread over a triangle mesh: each is the vertex that is farthest from all samples before, by
exact geodesic distances.

A vertex that no sample reaches is farther than all others, so each component gets a sample first. Vertices without
faces are never samples. Of vertices that are equally far, the first one of the mesh becomes the sample.

There is one propagation for all samples. A new sample sends windows over the part of the surface that becomes its
Voronoi cell, and hardly farther; the rest is unchanged. So the first sample takes the time of a run of
`geodesic_distances()`, and each further one takes time proportional to its cell. The memory is that of such a run.

<b>Thread safety.</b> The function uses one thread. Several threads may call it at once, also on the same mesh, if each
call writes to an output of its own; see `geodesic_distances()`.

<b>Relaxation.</b> `geodesic_Lloyd_relaxation()` moves samples to the centers of their cells. With the same
`first_curves` it keeps them away from these curves; otherwise it ignores borders.
`geodesic_remeshing()` keeps those on a border in place.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam OutputIterator a model of `OutputIterator` that holds vertex descriptors of `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param n the number of samples, including those in `first_samples`
\param output receives the samples, in the order in which they are found; fewer than `n` if every vertex is a sample, or
       has a sample within `covering_radius`
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
    \cgalParamDescription{a visitor that follows one propagation for each sample, and one for all first samples.
                          Distances start from 0 in each, and the number of visits continues. If the visitor
                          cancels one, the function writes no more samples.}
    \cgalParamType{a class model of `GeodesicPropagationVisitor`}
    \cgalParamDefault{`Geodesic_default_visitor`}
    \cgalParamExtra{The visitor is not copied if it is passed with `std::ref()`.}
  \cgalParamNEnd
  \cgalParamNBegin{first_samples}
    \cgalParamDescription{vertices that are samples already. The function does not write them, but counts them among the
                          samples. If there are neither samples nor curves, the first vertex of the mesh that has
                          a face becomes the first sample.}
    \cgalParamType{a range of vertex descriptors of `TriangleMesh`}
    \cgalParamDefault{an empty range}
  \cgalParamNEnd
  \cgalParamNBegin{first_curves}
    \cgalParamDescription{curves from which the samples keep away, such as the border. They are sites, too: each sample
                          is the vertex that is farthest from all samples and curves. They are not counted among the
                          samples, and the covering radius is that of samples and curves. `Surface_curve` makes
                          curves, `border_curves()` returns borders.}
    \cgalParamType{a `Surface_curve` on `tm`, or a range of these}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{covering_radius}
    \cgalParamDescription{the sampling ends as soon as no vertex is farther from its nearest sample than this, in the
                          unit of the mesh; not negative}
    \cgalParamType{a number that converts to `double`}
    \cgalParamDefault{`0`}
  \cgalParamNEnd
  \cgalParamNBegin{statistics}
    \cgalParamDescription{if not null, the function <em>adds</em> the counts of the propagation to the object.}
    \cgalParamType{a pointer to `Propagation_statistics`}
    \cgalParamDefault{`nullptr`}
  \cgalParamNEnd
  \cgalParamNBegin{faces_to_avoid}
    \cgalParamDescription{the faces through which no path may lead, as for `geodesic_distances()`. Vertices whose faces
                          are all to be avoided have no face that counts, and are never samples.}
    \cgalParamType{a range of face descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   face descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
  \cgalParamNBegin{edges_to_avoid}
    \cgalParamDescription{the edges that no path may cross, as for `geodesic_distances()`. A sample on such an
                          edge is on both sides, and the distance of a vertex is the least of its sides.}
    \cgalParamType{a range of edge descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   edge descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
\cgalNamedParamsEnd

How to write sequences of parameters, and which one comes first: \ref Surface_mesh_geodesics_named_parameters.

\return the covering radius: the largest distance of a vertex from its nearest sample, in the unit of the mesh. It is
        infinite if no sample reaches some vertex that has a face. If the visitor canceled a propagation, the function
        returns the radius of the samples before that one, infinity if it was the first.

\throws Invalid_geodesic_input if the mesh is invalid, as for `geodesic_distances()`, if a first sample is not a
        vertex of `tm`, a curve is not one of `tm`, or the radius is negative or not a number. Nothing has been written
        then.
*/
template <typename TriangleMesh, typename OutputIterator, typename CGAL_NP_TEMPLATE_PARAMETERS>
double geodesic_farthest_point_sampling(const TriangleMesh& tm, std::size_t n, OutputIterator output,
                                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Sampling_parameters>(tm, np);
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  static_assert(internal::Checked_output_iterator<OutputIterator, vertex_descriptor>::value,
                "always true, if it compiles");
  return internal::sample_farthest_points(tm, n, output, internal::sampling_options<TriangleMesh>(np), np);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_FARTHEST_POINT_SAMPLING_H
