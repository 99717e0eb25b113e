// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// Nothing by itself: Window_list_loops.h includes this file once for each number of lanes.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/Lanes.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/Window_lanes.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/lane_pruning.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/window_splitting.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/List_loops.h>
#undef CGAL_SURFACE_MESH_GEODESICS_LANES
#undef CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
#endif
