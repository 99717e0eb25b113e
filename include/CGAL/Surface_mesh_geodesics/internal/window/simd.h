// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_SIMD_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_SIMD_H

// Several numbers at a time. Loops over columns of numbers are written once, in terms of Lanes<FT> (lanes/Lanes.h),
// which processes `size` lanes together. Most number types have one lane, which is a plain number: One_lane below. For
// double there are two lanes, with NEON and SSE2, also where the compiler has no vectors (Double_pair.h). Programs
// for x86-64 also hold the text for four lanes (AVX2) and eight (AVX-512), and choose when they run
// (Window_list_loops.h).
//
// Loads and stores need no alignment. Lanes are independent of each other, except in the operations that say otherwise;
// so lanes behind the end of a column may hold anything. Each lane goes through the operations of a single number, and
// products are rounded before they are added (rounded_product()). So the results are the same bits for any number of
// lanes.
//
// Which lanes there are depends on the processor family and the compiler, never on flags such as -mavx2: files of one
// program that are compiled with different flags have the same text (one-definition rule). Two macros change it, and
// must be the same in all files of a program that include this one:
// - CGAL_SURFACE_MESH_GEODESICS_ONE_INSTRUCTION_SET: two lanes, and no choice when the program runs;
// - CGAL_SURFACE_MESH_GEODESICS_NO_SIMD: double has one lane, like all other number types.
// (CGAL_SURFACE_MESH_GEODESICS_NO_VECTOR_EXTENSION, for tests: the lanes of a compiler without vectors.)

// How double gets its lanes: vectors of the language extension of GCC and Clang, pairs of SSE2, or not at all.
// (Compilers with the front end of EDG define __GNUC__ but do not have all of the extension. The double of 32-bit x86
// may keep more digits in one operation than in another one, so that lanes would have other bits.)
#if defined(__GNUC__) && !defined(__EDG__) && !defined(CGAL_SURFACE_MESH_GEODESICS_NO_VECTOR_EXTENSION)
#define CGAL_SURFACE_MESH_GEODESICS_HAS_VECTORS
#endif
#if defined(CGAL_SURFACE_MESH_GEODESICS_NO_SIMD)
#define CGAL_SURFACE_MESH_GEODESICS_MOST_LANES 1
#elif defined(__x86_64__) && defined(CGAL_SURFACE_MESH_GEODESICS_HAS_VECTORS)
#include <emmintrin.h>
// (Stacks on Windows are not aligned for wider vectors.)
#if defined(CGAL_SURFACE_MESH_GEODESICS_ONE_INSTRUCTION_SET) || defined(_WIN32)
#define CGAL_SURFACE_MESH_GEODESICS_MOST_LANES 2
#else
#define CGAL_SURFACE_MESH_GEODESICS_MOST_LANES 8
#endif
#elif defined(__aarch64__) && defined(CGAL_SURFACE_MESH_GEODESICS_HAS_VECTORS)
#include <arm_neon.h>
#define CGAL_SURFACE_MESH_GEODESICS_MOST_LANES 2
#elif defined(__x86_64__) || (defined(_M_X64) && !defined(_M_ARM64EC))
#define CGAL_SURFACE_MESH_GEODESICS_MOST_LANES 2
#define CGAL_SURFACE_MESH_GEODESICS_HAS_PAIRS
#else
#define CGAL_SURFACE_MESH_GEODESICS_MOST_LANES 1
#endif

// A vector of some numbers of the vectors a and b, which are counted from the first number of a. (GCC before 12 has
// another function, whose indices are a vector, a Mask.)
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 12
#define CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(a, b, ...) __builtin_shuffle(a, b, Mask{__VA_ARGS__})
#else
#define CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#endif

// The square root of a vector, which newer versions of Clang have in the place of functions for each instruction set.
#if defined(__clang__) && defined(__has_builtin)
#if __has_builtin(__builtin_elementwise_sqrt)
#define CGAL_SURFACE_MESH_GEODESICS_HAS_SQUARE_ROOT_OF_VECTORS
#endif
#endif

#include <CGAL/Surface_mesh_geodesics/internal/numeric/bit_counting.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

// For functions with many vectors as arguments or results: a call would pass all of them through memory.
#if defined(__GNUC__)
#define CGAL_SURFACE_MESH_GEODESICS_INLINE __attribute__((always_inline)) inline
#elif defined(_MSC_VER)
#define CGAL_SURFACE_MESH_GEODESICS_INLINE __forceinline
#else
#define CGAL_SURFACE_MESH_GEODESICS_INLINE inline
#endif

// A number or vector x as it is, but compilers do not fuse the product that computes it with a sum that it enters. Such
// a fused operation rounds once, not twice, which would change the last digits. (AVX-512 and ARM have fused operations,
// and GCC uses them unless -ffp-contract=off is given; Visual C++ does not, under CGAL's /fp:strict.)
#if defined(__GNUC__) && !defined(__clang__) && !defined(__EDG__) && __GNUC__ >= 12
#define CGAL_SURFACE_MESH_GEODESICS_KEEP_ROUNDED(x) x = __builtin_assoc_barrier(x)
#elif defined(__GNUC__) && !defined(__EDG__) && defined(__x86_64__)
#define CGAL_SURFACE_MESH_GEODESICS_KEEP_ROUNDED(x) asm("" : "+x"(x))
#elif defined(__GNUC__) && !defined(__EDG__) && defined(__aarch64__)
#define CGAL_SURFACE_MESH_GEODESICS_KEEP_ROUNDED(x) asm("" : "+w"(x))
#else
#define CGAL_SURFACE_MESH_GEODESICS_KEEP_ROUNDED(x) static_cast<void>(x)
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Closes the gaps in one step of rows: moves the rows whose bits are set to consecutive ones from `first` on, in their
// order. Returns the end of these rows.
template <typename Columns>
std::size_t keep_rows(Columns& columns, std::size_t first, unsigned int useful)
{
  if((useful & (useful + 1)) == 0) // most often: no gaps
    return first + trailing_zeros(std::uint64_t(useful) + 1);
  std::size_t end = first;
  for(std::size_t i = first; useful != 0; ++i, useful >>= 1)
    if((useful & 1) != 0)
    {
      if(end != i)
        columns.copy_row(i, end);
      ++end;
    }
  return end;
}

// One lane, which is a plain number: the operations that Lanes<FT> has for any number of lanes.
template <typename FT>
struct One_lane
{
  using Number = FT;
  using Word = std::uint64_t;
  using Mask = int; // 0 or 1, not bool: compilers warn of & and | of bool
  static constexpr std::size_t size = 1;

  static const Number& all(const FT& x) { return x; }

  static const Number& load(const FT* p) { return *p; }
  static Word load(const std::uint64_t* p) { return *p; }
  static void store(FT* p, const Number& x) { *p = x; }
  static void store(std::uint64_t* p, Word x) { *p = x; }

  // The numbers begin, begin + 1, ...
  static Word count_from(std::size_t begin) { return begin; }

  static std::uint64_t least(Word x, unsigned int) { return x; } // among the lanes whose bits are set
  static const FT& least(const Number& x) { return x; } // among all lanes

  // The lanes shifted up by one. The last lane of `previous` enters at lane 0.
  static const Number& shift_in(const Number& previous, const Number&) { return previous; }

  static Mask less(const Number& a, const Number& b) { return a < b; }
  static Mask less_equal(const Number& a, const Number& b) { return a <= b; }
  // The first n lanes, as a mask; none if n, read as a signed number, is negative.
  static Mask first(std::size_t n) { return static_cast<std::int64_t>(n) > 0; }
  static Mask except(Mask a, Mask b) { return a && !b; } // a and not b
  static unsigned int bits(Mask m) { return m ? 1u : 0u; }

  static Number select(Mask m, const Number& a, const Number& b) { return m ? a : b; }
  static Word select_word(Mask m, Word a, Word b) { return m ? a : b; }
  static Number minimum(const Number& a, const Number& b) { return a < b ? a : b; }
  static Number maximum(const Number& a, const Number& b) { return a < b ? b : a; }

  static Number square_root(const Number& x)
  {
    using std::sqrt;
    return sqrt(x);
  }

  // a * b, rounded before it is added to anything.
  static Number rounded_product(const Number& a, const Number& b)
  {
    Number product = a * b;
    if constexpr(std::is_same<FT, double>::value)
      CGAL_SURFACE_MESH_GEODESICS_KEEP_ROUNDED(product);
    return product;
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_SIMD_H
