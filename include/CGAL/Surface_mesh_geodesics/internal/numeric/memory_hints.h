// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_MEMORY_HINTS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_MEMORY_HINTS_H

// What the processor and the operating system are told about memory that will be needed. Results do not depend on it.
//
// *Prefetching.* The processor is asked for the memory of the next step while it works on this one.
//
// *Large pages.* The wavefront reads a mesh here and there, and on a large mesh nearly every step comes to another page
// of memory. The processor knows the places of some thousand pages only, and looks up the others in memory. With pages
// of 2 MB instead of 4 KB it knows them all. The operating system is asked to use them, not told to: Linux may do so,
// elsewhere nothing happens.

#if defined(_MSC_VER) && !defined(__GNUC__) && (defined(_M_X64) || defined(_M_IX86))
#include <intrin.h>
#define CGAL_SURFACE_MESH_GEODESICS_HAS_MM_PREFETCH
#endif

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

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

// Asks for large pages for a part of the memory that holds no data yet. Only pages that lie in it as a whole count, so
// a small part changes nothing. Constant time.
inline void prefer_large_pages(void* first, std::size_t number_of_bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t page = std::uintptr_t(1) << 21;
  const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(first) + page - 1) / page * page;
  const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(first) + number_of_bytes) / page * page;
  const int error = errno; // the caller's; a kernel without large pages sets another one
  if(begin < end)
    static_cast<void>(::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE));
  errno = error;
#else
  static_cast<void>(first);
  static_cast<void>(number_of_bytes);
#endif
}

// Reserves memory for n elements of an empty table, and asks for large pages if that is new memory. A table with
// elements is left as it is: it grows by more than one step needs, so that few steps move it.
template <typename T>
void reserve_large(std::vector<T>& table, std::size_t n)
{
  if(!table.empty() || n <= table.capacity())
    return;
  table.reserve(n);
  prefer_large_pages(table.data(), table.capacity() * sizeof(T));
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_MEMORY_HINTS_H
