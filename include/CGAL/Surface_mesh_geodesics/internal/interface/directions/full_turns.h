// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIRECTIONS_FULL_TURNS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIRECTIONS_FULL_TURNS_H

// Angles of users, in radians, without full turns.

#include <cmath>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// (The nearest doubles; twice the half turn is the full turn exactly.)
constexpr double full_turn = 6.283185307179586;
constexpr double half_turn = full_turn / 2;

// Returns the same angle in [0, period). A negative angle within rounding of 0 would become the period itself, and
// gives 0 instead; what is not a number stays so. std::fmod() is exact, so many turns cost no digits. Requires:
// period > 0.
inline double reduced_angle(double angle, double period)
{
  const double r = std::fmod(angle, period), reduced = r < 0 ? r + period : r;
  return reduced >= period ? 0. : reduced;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIRECTIONS_FULL_TURNS_H
