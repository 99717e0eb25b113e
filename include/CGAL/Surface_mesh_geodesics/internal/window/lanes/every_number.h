// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// Includes a text once for each number of lanes that may pay (simd.h), each time in another namespace and for another
// instruction set: the file that CGAL_SURFACE_MESH_GEODESICS_LANES_TEXT names. The text sees the number as
// CGAL_SURFACE_MESH_GEODESICS_LANES.
//
// Included once for each text.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES_TEXT

// One lane: for all number types, and for comparison.
#define CGAL_SURFACE_MESH_GEODESICS_LANES 1
#define CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE one_lane
#include CGAL_SURFACE_MESH_GEODESICS_LANES_TEXT
#undef CGAL_SURFACE_MESH_GEODESICS_LANES
#undef CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE

// Two lanes: SSE2 or NEON, or pairs of doubles.
#if CGAL_SURFACE_MESH_GEODESICS_MOST_LANES > 1
#define CGAL_SURFACE_MESH_GEODESICS_LANES 2
#define CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE two_lanes
#include CGAL_SURFACE_MESH_GEODESICS_LANES_TEXT
#undef CGAL_SURFACE_MESH_GEODESICS_LANES
#undef CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
#endif

#if CGAL_SURFACE_MESH_GEODESICS_MOST_LANES > 2
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
#define CGAL_SURFACE_MESH_GEODESICS_LANES 4
#define CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE avx2_lanes
#include CGAL_SURFACE_MESH_GEODESICS_LANES_TEXT
#undef CGAL_SURFACE_MESH_GEODESICS_LANES
#undef CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx512f,avx512bw,avx512dq,avx512vl"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f,avx512bw,avx512dq,avx512vl")
#endif
#define CGAL_SURFACE_MESH_GEODESICS_LANES 8
#define CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE avx512_lanes
#include CGAL_SURFACE_MESH_GEODESICS_LANES_TEXT
#undef CGAL_SURFACE_MESH_GEODESICS_LANES
#undef CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

#endif // CGAL_SURFACE_MESH_GEODESICS_LANES_TEXT
