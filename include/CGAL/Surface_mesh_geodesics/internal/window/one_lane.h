// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_ONE_LANE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_ONE_LANE_H

// Instantiates the formulas and rules of lanes/ for one lane, which serves single windows.
//
// Each formula is written once, for any number of lanes. One lane is a plain number, so the code reads and works like
// code for a single window.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Vertex_rival.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/simd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#define CGAL_SURFACE_MESH_GEODESICS_LANES 1
#define CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE one_lane
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/rules.h>
#undef CGAL_SURFACE_MESH_GEODESICS_LANES
#undef CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_ONE_LANE_H
