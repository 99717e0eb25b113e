// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_VERTEX_RIVAL_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_VERTEX_RIVAL_H

// A vertex that competes with windows: the paths through it may be shorter than those of a window.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The vertex beats a path of length d if its own path is shorter than factor * d.
//
// Ties. A window stays, unless windows start at the vertex in all directions: these windows carry everything that goes
// on from a tie. The tie has to be decided there, because the neighborhood of such a vertex may be so small that all
// distances tie, and no path would ever end.
template <typename FT>
struct Vertex_rival
{
  FT distance;
  FT factor; // of the distance of a window, before the two are compared

  // d may be infinite: such a vertex beats nothing. Vertices that win ties are the DEGENERATE ones (Intrinsic_mesh.h).
  Vertex_rival(const FT& d, bool wins_ties)
    : distance(d),
      factor(wins_ties ? 1 + Tolerance<FT>::distance() : 1 - Tolerance<FT>::distance())
  {}
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_VERTEX_RIVAL_H
