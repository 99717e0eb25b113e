// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// The part of the text for one number of lanes that knows neither lists nor meshes: numbers, windows, rules.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/Lanes.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/Window_numbers.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/lane_pruning.h>
#endif
