// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_PREFETCH_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_PREFETCH_H

#if defined(_MSC_VER) && !defined(__GNUC__) && (defined(_M_X64) || defined(_M_IX86))
#include <intrin.h>
#define CGAL_SURFACE_MESH_GEODESICS_HAS_MM_PREFETCH
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Asks the processor to load the memory at p into its caches. This never faults: p may be any address.
inline void prefetch(const void* p)
{
#ifdef __GNUC__
  __builtin_prefetch(p);
  // For g++ a prefetch is no effect: it removes loops and calls that do nothing else. The empty statement is one.
  __asm__ volatile("");
#elif defined(CGAL_SURFACE_MESH_GEODESICS_HAS_MM_PREFETCH)
  _mm_prefetch(static_cast<const char*>(p), _MM_HINT_T0);
#else
  static_cast<void>(p);
#endif
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_PREFETCH_H
