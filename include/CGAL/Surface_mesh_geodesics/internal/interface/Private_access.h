// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PRIVATE_ACCESS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PRIVATE_ACCESS_H

// The one friend of public classes. They have something for the functions of this package and not for users: the
// functions that check construct certificates, those for matrices use the surface that a solver has read, and
// shortest_path_curve() and border_curves() make curves of segments.
//
// Friends that are functions would have to be declared with all their template parameters, before the classes. So the
// classes name one struct, which lets the rooms above in: Geodesic_distance_certificate, Geodesic_Voronoi_certificate,
// Geodesic_distance_solver and Surface_curve do so.

#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

struct Private_access
{
  // Constructs an object by a private constructor. Requires: Private_access is a friend of Object.
  template <typename Object, typename... Arguments>
  static Object make(Arguments&&... arguments)
  {
    return Object(std::forward<Arguments>(arguments)...);
  }

  // Returns the surface of a Geodesic_distance_solver. It is valid as long as the solver.
  template <typename Solver>
  static const auto& surface(const Solver& solver)
  {
    return solver.surface();
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PRIVATE_ACCESS_H
