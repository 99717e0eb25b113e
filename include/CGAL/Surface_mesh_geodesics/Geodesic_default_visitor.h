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

The class `Geodesic_default_visitor` is a visitor that does nothing and never cancels.

A user's visitor may derive from it, declare the functions that it needs, and inherit the others. No function is
virtual: the type of the visitor that is passed decides which functions are called. All functions take constant time,
throw nothing, and may be called by several threads at once, as the class has no data.

\cgalModels{GeodesicPropagationVisitor}
*/
struct Geodesic_default_visitor
{
  /// does nothing.
  void on_propagation_begin(std::size_t /* number_of_vertices */) {}

  /// does nothing.
  void on_progress(std::size_t /* number_of_visits */, double /* distance_reached */) {}

  /// returns `true`: the propagation goes on.
  bool go_further() { return true; }

  /// does nothing.
  void on_propagation_end() {}
};

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DEFAULT_VISITOR_H
