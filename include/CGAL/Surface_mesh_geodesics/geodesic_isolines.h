// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_ISOLINES_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_ISOLINES_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_parameters.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/isolines/Isoline_run.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

writes the isolines of given distances from a source, or from the nearest of several sources, as polylines.

The lines are those of `Surface_mesh_geodesic_paths::isolines()`: no point comes twice in a row, a closed line ends with
its first point, and any other one begins and ends at the border. Nearer points are on the left of a line. Its points
are on edges and exact: their distances are the value, up to 1024 \f$ \epsilon \f$ of it. Inside a face a chord joins
two of them: a chord of length c is nearer than the line by up to about c<sup>2</sup> / (8 r), where r is the distance
of the line from the vertex at which its paths begin or bend last. Where paths from two sides meet in a face, the chord
cuts off the corner of the line.

That class keeps all windows, so that lines of any distance may be asked for later. Here, the distances are known from
the start: the lines are found while the wavefront passes, which takes little more memory than `geodesic_distances()`
(see \ref Surface_mesh_geodesics_isolines). The distances of the vertices are computed on the way, and are written if
`vertex_distance_map` is among the named parameters; without it and without `nearest_source_map`, the propagation ends
behind the largest level.

The sources may be curves. Then the lines are the curves parallel to them, on both sides; those at the distance 0 are
the curves themselves, and are not written. (`Surface_mesh_geodesic_paths::signed_isolines()` chooses one side.)

With `Parallel_tag`, several threads propagate from points. The lines do not depend on their number; their points may
differ from those of `Sequential_tag` by rounding. From curves, a single thread propagates.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`, as for `geodesic_distances()`
\tparam TriangleMesh a model of `FaceListGraph`
\tparam Sources a source or a range of sources, as for `geodesic_distances()`: vertex descriptors, locations in faces,
        or curves of the type `Surface_curve`. A point among curves is a curve of one location.
\tparam Levels a range of numbers that convert to `double`
\tparam OutputIterator a model of `OutputIterator` that takes `std::pair<std::size_t, std::vector<Point_3>>`, where
        `Point_3` is the value type of the point map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param sources the source or sources
\param levels the distances of the lines, in the unit of the points, in any order. There is no line for a level that is
       zero, negative, infinite or not a number.
\param output gets each line as a pair: the position of its distance in `levels`, counted from 0, and its points. Lines
       come in the order of the levels.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\pre the value type of the point map is `Kernel::Point_3` for a kernel of \cgal

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
  \cgalParamNBegin{maximum_distance}
    \cgalParamDescription{the radius, in the unit of the mesh; not negative. Levels that are larger have no lines, and
                          vertices that are farther away get infinity.}
    \cgalParamType{a number that converts to `double`}
    \cgalParamDefault{infinity}
  \cgalParamNEnd
  \cgalParamNBegin{source_offsets}
    \cgalParamDescription{empty, or one number for each source, which is added to all distances from that source, as for
                          `geodesic_distances()`}
    \cgalParamType{a range of numbers that convert to `double`}
    \cgalParamDefault{an empty range: all offsets are 0}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_distance_map}
    \cgalParamDescription{a property map that receives the distance of each vertex, in the unit of the points; infinity
                          beyond the radius and where no source reaches it}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertex descriptor of `TriangleMesh` as key type and
                   a floating point type as value type, passed by value}
    \cgalParamDefault{none: distances are not written}
  \cgalParamNEnd
  \cgalParamNBegin{nearest_source_map}
    \cgalParamDescription{a property map that receives, for each vertex, the position of its nearest source in the range
                          of sources, as for `geodesic_distances()`}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertex descriptor of `TriangleMesh` as key type and
                   `std::size_t` as value type, passed by value}
    \cgalParamDefault{none: the nearest sources are not computed}
  \cgalParamNEnd
  \cgalParamNBegin{statistics}
    \cgalParamDescription{if not null, the computation <em>adds</em> its counts to the object, also if the visitor
                          canceled it}
    \cgalParamType{a pointer to `Propagation_statistics`}
    \cgalParamDefault{`nullptr`}
  \cgalParamNEnd
  \cgalParamNBegin{faces_to_avoid}
    \cgalParamDescription{the faces through which no path may lead, as for `geodesic_distances()`. Lines end at their
                          rim.}
    \cgalParamType{a range of face descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   face descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
  \cgalParamNBegin{edges_to_avoid}
    \cgalParamDescription{the edges that no path may cross, as for `geodesic_distances()`. Lines end at
                          them; behind such an edge another line may begin.}
    \cgalParamType{a range of edge descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   edge descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
\cgalNamedParamsEnd

How to write sequences of parameters, and which one comes first: \ref Surface_mesh_geodesics_named_parameters.

\return `true`, or `false` if the visitor canceled the computation; nothing is written then, and the maps are unchanged.

\throws Invalid_geodesic_input if the mesh, a source, an offset or the radius is invalid, as for `geodesic_distances()`.
        Nothing is written then, and the maps are unchanged.

<b>Complexity.</b> That of `geodesic_distances()`, plus for each point of a line a number of operations that is linear
in the number of windows in its face. The memory of the windows along the wavefront comes to that of the distances.
From curves, the parallel rays that cross a face count like windows.

<b>Thread safety.</b> As for `geodesic_distances()`.

\sa `Surface_mesh_geodesic_paths::isolines()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Sources, typename Levels,
          typename OutputIterator, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool geodesic_isolines(const TriangleMesh& tm, const Sources& sources, const Levels& levels, OutputIterator output,
                       const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Isoline_parameters>(tm, np);
  constexpr bool are_levels = internal::Is_range_of<Levels, double>::value;
  static_assert(are_levels, "the levels are a range of numbers");
  std::vector<double> distances;
  if constexpr(are_levels) // else the errors of the loop would follow the message
    for(const auto& level : levels)
      distances.push_back(static_cast<double>(level)); // NOLINT(performance-inefficient-vector-operation)
  return internal::compute_isolines<ConcurrencyTag>(tm, sources, distances, output, np);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_ISOLINES_H
