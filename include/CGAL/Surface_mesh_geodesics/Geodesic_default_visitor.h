// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DEFAULT_VISITOR_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DEFAULT_VISITOR_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_default_visitor` does nothing at each event of a propagation, and never cancels
it. A visitor may derive from it and hide the functions that it needs.

\cgalModels{GeodesicPropagationVisitor}
*/
struct Geodesic_default_visitor
{
  /// is called before the propagation over a mesh with `number_of_vertices` vertices.
  void on_propagation_begin(std::size_t /* number_of_vertices */) {}

  /// is called before each visit of a vertex by the wavefront. All distances up to
  /// `distance_reached`, which never decreases, are final. A vertex may be visited more than once.
  void on_progress(std::size_t /* number_of_visits */, double /* distance_reached */) {}

  /// is called after each `on_progress()`; the propagation is cancelled if it returns `false`.
  bool go_further() { return true; }

  /// is called after the propagation, also if it was cancelled.
  void on_propagation_end() {}
};

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DEFAULT_VISITOR_H
