// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// The text of the loops over the windows of a list. The rules are a part of it, but for one lane: one_lane.h has
// included them.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES
#if CGAL_SURFACE_MESH_GEODESICS_LANES > 1
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/rules.h>
#endif
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/Window_lanes.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/window_splitting.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/List_loops.h>
#endif
