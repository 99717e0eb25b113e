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
// double, there are as many lanes as the instruction set has: 8 with AVX-512, 4 with AVX, 2 with SSE2 or NEON, and one
// for compilers other than GCC and Clang.
//
// Loads and stores need no alignment. Lanes are independent of each other, except in the operations that say otherwise;
// so lanes behind the end of a column may hold anything. Each lane goes through the operations of a single number. So
// the results are the same bits for any number of lanes, unless the compiler fuses multiplications and additions. GCC
// does so, without -ffp-contract=off, for instruction sets that have fused operations (-march=native, ARM).
//
// The instruction set is that of the compilation; for x86-64 without flags it is chosen at run time
// (Window_list_loops.h), unless CGAL_SURFACE_MESH_GEODESICS_ONE_INSTRUCTION_SET is defined.
//
// If CGAL_SURFACE_MESH_GEODESICS_NO_SIMD is defined, double has one lane, too. These macros, and the flags that choose
// an instruction set, must be the same in all files of a program that include this one.

// The number of lanes of double in the instruction set of the compilation.
#if !defined(CGAL_SURFACE_MESH_GEODESICS_NO_SIMD) && defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__))
#ifdef __SSE2__
#include <immintrin.h>
#else
#include <arm_neon.h>
#endif
#if defined(__AVX512F__)
#define CGAL_SURFACE_MESH_GEODESICS_COMPILED_LANES 8
#define CGAL_SURFACE_MESH_GEODESICS_COMPILED_NAMESPACE lanes_8
#elif defined(__AVX__)
#define CGAL_SURFACE_MESH_GEODESICS_COMPILED_LANES 4
#define CGAL_SURFACE_MESH_GEODESICS_COMPILED_NAMESPACE lanes_4
#elif defined(CGAL_SURFACE_MESH_GEODESICS_ONE_INSTRUCTION_SET)
// A name of its own, as window_list_loops() is another function here.
#define CGAL_SURFACE_MESH_GEODESICS_COMPILED_LANES 2
#define CGAL_SURFACE_MESH_GEODESICS_COMPILED_NAMESPACE lanes_2_only
#else
#define CGAL_SURFACE_MESH_GEODESICS_COMPILED_LANES 2
#define CGAL_SURFACE_MESH_GEODESICS_COMPILED_NAMESPACE lanes_2
#endif
#endif
#ifndef CGAL_SURFACE_MESH_GEODESICS_COMPILED_LANES
#define CGAL_SURFACE_MESH_GEODESICS_COMPILED_LANES 1
#define CGAL_SURFACE_MESH_GEODESICS_COMPILED_NAMESPACE one_lane
#endif

// May one program contain code for AVX2 and AVX-512 as well as for SSE2? (Stacks on Windows are not aligned for it.)
#if CGAL_SURFACE_MESH_GEODESICS_COMPILED_LANES == 2 && defined(__x86_64__) && !defined(_WIN32) \
  && !defined(__EDG__) && !defined(CGAL_SURFACE_MESH_GEODESICS_ONE_INSTRUCTION_SET)
#define CGAL_SURFACE_MESH_GEODESICS_HAS_WIDE_CODE
#endif

// A vector of some numbers of the vectors a and b, which are counted from the first number of a. (GCC before 12 has
// another function, whose indices are a vector, a Mask.)
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 12
#define CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(a, b, ...) __builtin_shuffle(a, b, Mask{__VA_ARGS__})
#else
#define CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>

// For functions with many vectors as arguments or results: a call would pass all of them through memory.
#ifdef __GNUC__
#define CGAL_SURFACE_MESH_GEODESICS_INLINE __attribute__((always_inline)) inline
#else
#define CGAL_SURFACE_MESH_GEODESICS_INLINE inline
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

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
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_SIMD_H
