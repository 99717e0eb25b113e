// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_BIT_COUNTING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_BIT_COUNTING_H

// Finds the lowest and the highest bit of a word. GCC, Clang and Visual C++ use a single instruction for each. A
// loop would be slower, because the processor cannot predict its length.

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>

#if defined(_MSC_VER) && !defined(__GNUC__) && defined(_WIN64)
#include <intrin.h>
#define CGAL_SURFACE_MESH_GEODESICS_HAS_BIT_SCAN
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The number of zeros below the lowest bit that is set. Requires: word != 0.
inline std::size_t trailing_zeros(std::uint64_t word)
{
  CGAL_assertion(word != 0);
#ifdef __GNUC__
  return static_cast<std::size_t>(__builtin_ctzll(word));
#elif defined(CGAL_SURFACE_MESH_GEODESICS_HAS_BIT_SCAN)
  unsigned long position = 0;
  _BitScanForward64(&position, word);
  return position;
#else
  std::size_t n = 0;
  for(; (word & 1) == 0; word >>= 1)
    ++n;
  return n;
#endif
}

// The number of bits up to the highest one that is set. Requires: word != 0.
inline std::size_t number_of_bits(std::uint64_t word)
{
  CGAL_assertion(word != 0);
#ifdef __GNUC__
  return 64 - static_cast<std::size_t>(__builtin_clzll(word));
#elif defined(CGAL_SURFACE_MESH_GEODESICS_HAS_BIT_SCAN)
  unsigned long position = 0;
  _BitScanReverse64(&position, word);
  return position + 1;
#else
  std::size_t n = 0;
  for(; word != 0; word >>= 1)
    ++n;
  return n;
#endif
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_BIT_COUNTING_H
