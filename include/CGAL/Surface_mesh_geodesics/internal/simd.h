// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SIMD_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SIMD_H

// level: 0 (numbers)
//
// Several numbers at a time. Loops over columns of numbers are written once, in terms of Lanes<FT>:
// lanes are processed together, `size` of them. For most number types there is one lane, and a number
// of lanes is just a number. For double there are as many as the instruction set of the compilation
// offers: 8 with AVX-512, 4 with AVX, 2 with SSE2 or NEON. The vectors are those of the language
// extension of GCC and Clang, so that +, -, * and / work as usual, also with a bare number for all
// lanes; other compilers get one lane.
//
// What is loaded or stored need not be aligned. No operation here depends on its neighbours' lanes, so
// lanes behind the end of a column may hold anything.
//
// CGAL_SURFACE_MESH_GEODESICS_NO_SIMD, if defined, makes it one lane for double too. It has to be the
// same in all files of a program that include this one, as have the flags that choose an instruction
// set.

#if !defined(CGAL_SURFACE_MESH_GEODESICS_NO_SIMD) && defined(__GNUC__) \
  && (defined(__SSE2__) || defined(__aarch64__))
#define CGAL_SURFACE_MESH_GEODESICS_HAS_VECTORS
#ifdef __SSE2__
#include <immintrin.h>
#endif
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>

// For a function whose arguments or results are many vectors: a call would put them all in memory.
#ifdef __GNUC__
#define CGAL_SURFACE_MESH_GEODESICS_INLINE __attribute__((always_inline)) inline
#else
#define CGAL_SURFACE_MESH_GEODESICS_INLINE inline
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
struct One_lane
{
  using Number = FT;
  using Word = std::uint64_t;
  using Mask = int; // 0 or 1: masks are combined by & and |, which compilers distrust between truth values
  static constexpr std::size_t size = 1;

  static const Number& all(const FT& x) { return x; }

  static const Number& load(const FT* p) { return *p; }
  static Word load(const std::uint64_t* p) { return *p; }
  static void store(FT* p, const Number& x) { *p = x; }
  static void store(std::uint64_t* p, Word x) { *p = x; }

  // the numbers begin, begin + 1, ...
  static Word count_from(std::size_t begin) { return begin; }

  static std::uint64_t lane(Word x, std::size_t) { return x; }
  static const FT& least(const Number& x) { return x; } // of the lanes

  // the lanes one place on, where the last lane of `previous` enters.
  static const Number& shift_in(const Number& previous, const Number&) { return previous; }

  static Mask less(const Number& a, const Number& b) { return a < b; }
  static Mask less_equal(const Number& a, const Number& b) { return a <= b; }
  static Mask first(std::size_t n) { return n != 0; }
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

template <typename FT>
struct Lanes : One_lane<FT>
{};

#ifdef CGAL_SURFACE_MESH_GEODESICS_HAS_VECTORS

template <>
struct Lanes<double>
{
#if defined(__AVX512F__)
  static constexpr std::size_t size = 8;
#elif defined(__AVX__)
  static constexpr std::size_t size = 4;
#else
  static constexpr std::size_t size = 2;
#endif

  typedef double Number __attribute__((vector_size(8 * size)));
  typedef std::uint64_t Word __attribute__((vector_size(8 * size)));
  typedef std::int64_t Mask __attribute__((vector_size(8 * size))); // of zeros and minus ones

  static Number all(double x)
  {
#if defined(__AVX512F__)
    return Number{x, x, x, x, x, x, x, x};
#elif defined(__AVX__)
    return Number{x, x, x, x};
#else
    return Number{x, x};
#endif
  }

  static Number load(const double* p) { return *reinterpret_cast<const Numbers_anywhere*>(p); }
  static Word load(const std::uint64_t* p) { return *reinterpret_cast<const Words_anywhere*>(p); }
  static void store(double* p, Number x) { *reinterpret_cast<Numbers_anywhere*>(p) = x; }
  static void store(std::uint64_t* p, Word x) { *reinterpret_cast<Words_anywhere*>(p) = x; }

  static Word count_from(std::size_t begin)
  {
    Word x;
    for(std::size_t k = 0; k < size; ++k)
      x[k] = k;
    return x + begin;
  }

  static std::uint64_t lane(Word x, std::size_t k) { return x[k]; }

  static double least(Number x)
  {
#if defined(__AVX512F__)
    x = minimum(x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3));
    x = minimum(x, __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5));
    x = minimum(x, __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6));
#elif defined(__AVX__)
    x = minimum(x, __builtin_shufflevector(x, x, 2, 3, 0, 1));
    x = minimum(x, __builtin_shufflevector(x, x, 1, 0, 3, 2));
#else
    x = minimum(x, __builtin_shufflevector(x, x, 1, 0));
#endif
    return x[0];
  }

  static Number shift_in(Number previous, Number x)
  {
#if defined(__AVX512F__)
    return __builtin_shufflevector(previous, x, 7, 8, 9, 10, 11, 12, 13, 14);
#elif defined(__AVX__)
    return __builtin_shufflevector(previous, x, 3, 4, 5, 6);
#else
    return __builtin_shufflevector(previous, x, 1, 2);
#endif
  }

  // (The extension knows comparisons, but makes of them what it cannot keep in registers of SSE2.)
#if defined(__SSE2__) && !defined(__AVX__)
  static Mask less(Number a, Number b) { return (Mask)_mm_cmplt_pd(a, b); }
  static Mask less_equal(Number a, Number b) { return (Mask)_mm_cmple_pd(a, b); }
#else
  static Mask less(Number a, Number b) { return a < b; }
  static Mask less_equal(Number a, Number b) { return a <= b; }
#endif

  static Mask first(std::size_t n)
  {
    static constexpr double places[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    return less(load(places), all(static_cast<double>(static_cast<std::int64_t>(n))));
  }

  static Mask except(Mask a, Mask b) { return a & ~b; }

  static unsigned int bits(Mask m)
  {
#if defined(__AVX512F__)
    return _mm512_cmplt_epi64_mask((__m512i)m, _mm512_setzero_si512());
#elif defined(__AVX__)
    return static_cast<unsigned int>(_mm256_movemask_pd((__m256d)m));
#elif defined(__SSE2__)
    return static_cast<unsigned int>(_mm_movemask_pd((__m128d)m));
#else
    return static_cast<unsigned int>((m[0] & 1) | (m[1] & 2));
#endif
  }

#if defined(__SSE2__) && !defined(__AVX__)
  static Number select(Mask m, Number a, Number b)
  {
    return (Number)(((Mask)a & m) | ((Mask)b & ~m));
  }
  static Word select_word(Mask m, Word a, Word b) { return (a & (Word)m) | (b & ~(Word)m); }
#else
  static Number select(Mask m, Number a, Number b) { return m ? a : b; }
  static Word select_word(Mask m, Word a, Word b) { return m ? a : b; }
#endif

  static Number minimum(Number a, Number b) { return a < b ? a : b; }
  static Number maximum(Number a, Number b) { return a < b ? b : a; }

  static Number square_root(Number x)
  {
#if defined(__AVX512F__)
    return _mm512_maskz_sqrt_pd(0xff, x);
#elif defined(__AVX__)
    return _mm256_sqrt_pd(x);
#elif defined(__SSE2__)
    return _mm_sqrt_pd(x);
#else
    for(std::size_t k = 0; k < size; ++k)
      x[k] = std::sqrt(x[k]);
    return x;
#endif
  }

private:
  typedef double Numbers_anywhere __attribute__((vector_size(8 * size), aligned(8), may_alias));
  typedef std::uint64_t Words_anywhere __attribute__((vector_size(8 * size), aligned(8), may_alias));
};

#endif // CGAL_SURFACE_MESH_GEODESICS_HAS_VECTORS

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SIMD_H
