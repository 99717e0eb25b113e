// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// The whole text for one number of lanes. Window_list_loops.h includes it once for each number above one, which it
// has defined as CGAL_SURFACE_MESH_GEODESICS_LANES, together with a namespace.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/loops.h>
#undef CGAL_SURFACE_MESH_GEODESICS_LANES
#undef CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
#endif
