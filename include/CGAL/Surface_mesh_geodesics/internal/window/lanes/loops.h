// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// The part of the text for one number of lanes that needs lists and faces: the loops over the windows of a list.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/Window_lanes.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/window_splitting.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/List_loops.h>
#endif
