// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_OPTIONS_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_OPTIONS_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_distance_options` holds the options of `geodesic_distances()` and
`geodesic_distances_from_edge_lengths()` for which \cgal has no named parameter.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NearestSourceMap a model of `WritablePropertyMap` with the vertex descriptor of `TriangleMesh`
        as key type and `std::size_t` as value type, if `nearest_source_map` is used

Objects can be copied, and used for any number of calls. A function reads and checks them during its call only.

\sa `make_geodesic_distance_options()`
*/
template <typename TriangleMesh
#ifdef DOXYGEN_RUNNING
          , typename NearestSourceMap = unspecified_type
#else
          , typename NearestSourceMap = internal::No_nearest_source_map
#endif
          >
struct Geodesic_distance_options
{
  /// the type of the targets.
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// the value of `nearest_source_map` at a vertex that no source reaches.
  static constexpr std::size_t no_source = (std::numeric_limits<std::size_t>::max)();

  /// the radius, in the unit of the mesh. Vertices that are farther away get infinity. Faces that are farther away cost
  /// nothing in the propagation. Not negative; infinite by default.
  double maximum_distance = std::numeric_limits<double>::infinity();

  /// if not empty, the computation stops as soon as the distances of all these vertices are final. Vertices whose
  /// distances are not final then get infinity. If no source reaches one of the targets, all distances are computed.
  std::vector<vertex_descriptor> targets;

  /// empty, or one number for each source, which is added to all distances from that source. In the unit of the mesh,
  /// not negative, and finite, also as a multiple of the extent of the mesh. A source that another
  /// source reaches with a smaller distance than its offset is the nearest source of no vertex.
  std::vector<double> source_offsets;

  /// receives, for each vertex, the position in the range of sources, counted from 0, of a source from which its
  /// distance is measured, or `no_source`. If several sources have this distance, it is the position of one of them; of
  /// those at the same point with the same offset, the first. The map is unchanged if the visitor cancels or the input
  /// is invalid.
  NearestSourceMap nearest_source_map = NearestSourceMap();

  /// if not null, the computation <em>adds</em> its counts to `*statistics`, also if the visitor canceled it. The
  /// object is not owned. Computations that run at the same time must not share one.
  Propagation_statistics* statistics = nullptr;
};

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

returns default options with the given `nearest_source_map`. The caller names the type of the mesh:
`make_geodesic_distance_options<Mesh>(map)`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NearestSourceMap a model of `WritablePropertyMap` with the vertex descriptor of `TriangleMesh` as key type and
        `std::size_t` as value type

\param nearest_source_map the map, which is copied

\return the options; all members except the map have their default values
*/
template <typename TriangleMesh, typename NearestSourceMap>
Geodesic_distance_options<TriangleMesh, NearestSourceMap>
make_geodesic_distance_options(NearestSourceMap nearest_source_map)
{
  Geodesic_distance_options<TriangleMesh, NearestSourceMap> options;
  options.nearest_source_map = nearest_source_map;
  return options;
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_OPTIONS_H
