// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_DOUBLE_PAIR_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_DOUBLE_PAIR_H

// Two lanes of double for compilers without the vector extension of GCC and Clang, such as Visual C++: classes with the
// operators of that extension. They hold vectors of SSE2, which every processor of x86-64 has, and each operator is one
// or two instructions.
//
// Elsewhere such compilers have one lane. Classes of arrays, whose loops compilers are expected to turn into vectors,
// took about an eighth longer than one lane when they were measured with g++ 12. std::experimental::simd would not
// help: only the library of GCC has it, whose compilers have the extension.
//
// Each lane goes through the operations of a single number, so the results are the same bits as for one lane.

#include <CGAL/Surface_mesh_geodesics/internal/window/simd.h>

#include <cstddef>
#include <cstdint>

#if defined(__x86_64__) || defined(_M_X64)
#include <emmintrin.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A mask: each lane has all bits set, or none.
struct Mask_pair
{
  __m128d v;

  friend Mask_pair operator&(Mask_pair a, Mask_pair b) { return {_mm_and_pd(a.v, b.v)}; }
  friend Mask_pair operator|(Mask_pair a, Mask_pair b) { return {_mm_or_pd(a.v, b.v)}; }
};

// Two words of 64 bits.
struct Word_pair
{
  __m128i v;

  static Word_pair all(std::uint64_t x) { return {_mm_set1_epi64x(static_cast<long long>(x))}; }
  static Word_pair load(const std::uint64_t* p) { return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))}; }
  void store(std::uint64_t* p) const { _mm_storeu_si128(reinterpret_cast<__m128i*>(p), v); }

  friend Word_pair operator|(Word_pair a, std::uint64_t b) { return {_mm_or_si128(a.v, all(b).v)}; }
  friend Word_pair operator+(Word_pair a, std::uint64_t b) { return {_mm_add_epi64(a.v, all(b).v)}; }
  friend Word_pair operator>>(Word_pair a, int n) { return {_mm_srli_epi64(a.v, n)}; }
};

// Two numbers. A single number becomes a pair of equal ones, so that the operators also take single numbers.
struct Double_pair
{
  __m128d v;

  Double_pair() = default;
  Double_pair(__m128d x) : v(x) {}
  Double_pair(double x) : v(_mm_set1_pd(x)) {}
  static Double_pair load(const double* p) { return _mm_loadu_pd(p); }
  void store(double* p) const { _mm_storeu_pd(p, v); }

  friend Double_pair operator+(Double_pair a, Double_pair b) { return _mm_add_pd(a.v, b.v); }
  friend Double_pair operator-(Double_pair a, Double_pair b) { return _mm_sub_pd(a.v, b.v); }
  friend Double_pair operator*(Double_pair a, Double_pair b) { return _mm_mul_pd(a.v, b.v); }
  friend Double_pair operator/(Double_pair a, Double_pair b) { return _mm_div_pd(a.v, b.v); }
};

// The operations of Lanes<double> on pairs; One_lane (simd.h) documents them.
struct Double_pair_lanes
{
  using Number = Double_pair;
  using Word = Word_pair;
  using Mask = Mask_pair;
  static constexpr std::size_t size = 2;

  static Number all(double x) { return Number(x); }

  static Number load(const double* p) { return Number::load(p); }
  static Word load(const std::uint64_t* p) { return Word::load(p); }
  static void store(double* p, Number x) { x.store(p); }
  static void store(std::uint64_t* p, Word x) { x.store(p); }

  static Word count_from(std::size_t begin)
  {
    const std::uint64_t words[2] = {begin, begin + 1};
    return load(words);
  }

  // Requires: bits != 0.
  static std::uint64_t least(Word x, unsigned int bits)
  {
    std::uint64_t words[2];
    store(words, x);
    return bits == 1 || (bits == 3 && words[0] < words[1]) ? words[0] : words[1];
  }

  // Requires: no lane is a NaN.
  static double least(Number x)
  {
    double numbers[2];
    store(numbers, x);
    return numbers[0] < numbers[1] ? numbers[0] : numbers[1];
  }

  static Number shift_in(Number previous, Number x) { return _mm_shuffle_pd(previous.v, x.v, 1); }

  static Mask less(Number a, Number b) { return {_mm_cmplt_pd(a.v, b.v)}; }
  static Mask less_equal(Number a, Number b) { return {_mm_cmple_pd(a.v, b.v)}; }

  // (Compared as numbers, as in Lanes.h.)
  static Mask first(std::size_t n)
  {
    const double numbers[2] = {0, 1};
    return less(load(numbers), Number(static_cast<double>(static_cast<std::int64_t>(n))));
  }

  static Mask except(Mask a, Mask b) { return {_mm_andnot_pd(b.v, a.v)}; }
  static unsigned int bits(Mask m) { return static_cast<unsigned int>(_mm_movemask_pd(m.v)); }

  static Number select(Mask m, Number a, Number b)
  {
    return _mm_or_pd(_mm_and_pd(m.v, a.v), _mm_andnot_pd(m.v, b.v));
  }
  static Word select_word(Mask m, Word a, Word b)
  {
    const __m128i mask = _mm_castpd_si128(m.v);
    return {_mm_or_si128(_mm_and_si128(mask, a.v), _mm_andnot_si128(mask, b.v))};
  }

  // If one of the two is a NaN, the minimum is b and the maximum is a.
  static Number minimum(Number a, Number b) { return _mm_min_pd(a.v, b.v); }
  static Number maximum(Number a, Number b) { return _mm_max_pd(b.v, a.v); }
  static Number square_root(Number x) { return _mm_sqrt_pd(x.v); }

  // a * b, rounded before it is added to anything.
  static Number rounded_product(Number a, Number b)
  {
    Number product = a * b;
    CGAL_SURFACE_MESH_GEODESICS_KEEP_ROUNDED(product.v);
    return product;
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_DOUBLE_PAIR_H
