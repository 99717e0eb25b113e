// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// The vector operations of one inclusion: they process one number at a time for most number types, and for double as
// many as this inclusion has lanes. One_lane (simd.h) documents the operations. The vectors are those of the language
// extension of GCC and Clang, or Double_pair: +, -, * and / work as usual, also between a vector and a number.
//
// The few instructions of AVX2 and AVX-512 that the extension does not have are built-in functions of the compilers,
// those that their header <immintrin.h> calls. That header has fifty thousand lines, and every program would pay for
// them; the header for SSE2 is short, and CGAL includes it, too.
//
// Included once for each number of lanes; see README.md.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {
namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE {

// The number types other than double have one lane in every inclusion.
template <typename FT>
struct Lanes : One_lane<FT>
{};

#if CGAL_SURFACE_MESH_GEODESICS_LANES > 1 && defined(CGAL_SURFACE_MESH_GEODESICS_HAS_PAIRS)

// Without the extension: two lanes in a class.
template <>
struct Lanes<double> : Double_pair_lanes
{};

#elif CGAL_SURFACE_MESH_GEODESICS_LANES > 1

template <>
struct Lanes<double>
{
  static constexpr std::size_t size = CGAL_SURFACE_MESH_GEODESICS_LANES;

  // A lane of a mask has all bits set, or none, so an instruction that looks at its sign alone sees all of it.
  typedef double Number __attribute__((vector_size(8 * size)));
  typedef std::uint64_t Word __attribute__((vector_size(8 * size)));
  typedef std::int64_t Mask __attribute__((vector_size(8 * size))); // of zeros and minus ones

  static Number all(double x)
  {
#if CGAL_SURFACE_MESH_GEODESICS_LANES == 8
    return Number{x, x, x, x, x, x, x, x};
#elif CGAL_SURFACE_MESH_GEODESICS_LANES == 4
    return Number{x, x, x, x};
#else
    return Number{x, x};
#endif
  }

  // (Vectors of the extension are aligned to their size by themselves; those below may start at any number.)
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

  // The smallest word of the lanes whose bits are set. Requires: bits != 0.
  static std::uint64_t least(Word x, unsigned int bits)
  {
    std::uint64_t result = x[__builtin_ctz(bits)];
    while((bits &= bits - 1) != 0)
      result = (std::min)(result, static_cast<std::uint64_t>(x[__builtin_ctz(bits)]));
    return result;
  }

  // The smallest number of all lanes, by halves. Requires: no lane is a NaN. Each step takes the minima of lanes whose
  // distance is half of that in the step before; after the last one, all lanes have the result.
  static double least(Number x)
  {
#if CGAL_SURFACE_MESH_GEODESICS_LANES == 8
    x = minimum(x, CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(x, x, 4, 5, 6, 7, 0, 1, 2, 3));
    x = minimum(x, CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(x, x, 2, 3, 0, 1, 6, 7, 4, 5));
    x = minimum(x, CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(x, x, 1, 0, 3, 2, 5, 4, 7, 6));
#elif CGAL_SURFACE_MESH_GEODESICS_LANES == 4
    x = minimum(x, CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(x, x, 2, 3, 0, 1));
    x = minimum(x, CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(x, x, 1, 0, 3, 2));
#else
    x = minimum(x, CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(x, x, 1, 0));
#endif
    return x[0];
  }

  static Number shift_in(Number previous, Number x)
  {
#if CGAL_SURFACE_MESH_GEODESICS_LANES == 8
    return CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(previous, x, 7, 8, 9, 10, 11, 12, 13, 14);
#elif CGAL_SURFACE_MESH_GEODESICS_LANES == 4
    return CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(previous, x, 3, 4, 5, 6);
#else
    return CGAL_SURFACE_MESH_GEODESICS_SHUFFLE(previous, x, 1, 2);
#endif
  }

  // A comparison with a NaN is false.
  // (The comparisons of the extension produce code that does not stay in the registers of SSE2.)
#if CGAL_SURFACE_MESH_GEODESICS_LANES == 2 && defined(__x86_64__)
  static Mask less(Number a, Number b) { return reinterpret_cast<Mask>(_mm_cmplt_pd(a, b)); }
  static Mask less_equal(Number a, Number b) { return reinterpret_cast<Mask>(_mm_cmple_pd(a, b)); }
#else
  static Mask less(Number a, Number b) { return a < b; }
  static Mask less_equal(Number a, Number b) { return a <= b; }
#endif

  // (Compared as numbers, since SSE2 has no comparison of 64-bit integers. The conversion is exact for every size of a
  // list.)
  static Mask first(std::size_t n)
  {
    static constexpr double numbers[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    return less(load(numbers), all(static_cast<double>(static_cast<std::int64_t>(n))));
  }

  static Mask except(Mask a, Mask b) { return a & ~b; }

  static unsigned int bits(Mask m)
  {
#if CGAL_SURFACE_MESH_GEODESICS_LANES == 8
    // (By halves: GCC 12 assumes that the registers of AVX-512's masks are zero behind their eight bits, which they are
    // not.)
    const Number all_lanes = reinterpret_cast<Number>(m);
#ifdef __clang__
    const Half lower = __builtin_shufflevector(all_lanes, all_lanes, 0, 1, 2, 3),
               upper = __builtin_shufflevector(all_lanes, all_lanes, 4, 5, 6, 7);
#else
    const Half lower = __builtin_ia32_extractf64x4_mask(all_lanes, 0, Half{}, -1),
               upper = __builtin_ia32_extractf64x4_mask(all_lanes, 1, Half{}, -1);
#endif
    return static_cast<unsigned int>(__builtin_ia32_movmskpd256(lower) | __builtin_ia32_movmskpd256(upper) << 4);
#elif CGAL_SURFACE_MESH_GEODESICS_LANES == 4
    return static_cast<unsigned int>(__builtin_ia32_movmskpd256(reinterpret_cast<Number>(m)));
#elif defined(__x86_64__)
    return static_cast<unsigned int>(_mm_movemask_pd(reinterpret_cast<__m128d>(m)));
#else
    return static_cast<unsigned int>((m[0] & 1) | (m[1] & 2));
#endif
  }

#if CGAL_SURFACE_MESH_GEODESICS_LANES == 4
  // (The operator ?: would first compare the mask with zero.)
  static Number select(Mask m, Number a, Number b)
  {
    return __builtin_ia32_blendvpd256(b, a, reinterpret_cast<Number>(m));
  }
  static Word select_word(Mask m, Word a, Word b)
  {
    return reinterpret_cast<Word>(select(m, reinterpret_cast<Number>(a), reinterpret_cast<Number>(b)));
  }
#elif CGAL_SURFACE_MESH_GEODESICS_LANES == 2 && defined(__x86_64__)
  static Number select(Mask m, Number a, Number b)
  {
    return reinterpret_cast<Number>((reinterpret_cast<Mask>(a) & m) | (reinterpret_cast<Mask>(b) & ~m));
  }
  static Word select_word(Mask m, Word a, Word b)
  {
    return (a & reinterpret_cast<Word>(m)) | (b & ~reinterpret_cast<Word>(m));
  }
#else
  static Number select(Mask m, Number a, Number b) { return m ? a : b; }
  static Word select_word(Mask m, Word a, Word b) { return m ? a : b; }
#endif

  // If one of the two is a NaN, minimum() returns b, and maximum() returns a. Left_child relies on the former.
  static Number minimum(Number a, Number b) { return a < b ? a : b; }
  static Number maximum(Number a, Number b) { return a < b ? b : a; }

  static Number square_root(Number x)
  {
#if CGAL_SURFACE_MESH_GEODESICS_LANES > 2 && defined(CGAL_SURFACE_MESH_GEODESICS_HAS_SQUARE_ROOT_OF_VECTORS)
    return __builtin_elementwise_sqrt(x);
#elif CGAL_SURFACE_MESH_GEODESICS_LANES == 8 && defined(__clang__)
    return __builtin_ia32_sqrtpd512(x, 4); // 4: the rounding mode that is set
#elif CGAL_SURFACE_MESH_GEODESICS_LANES == 8
    return __builtin_ia32_sqrtpd512_mask(x, Number{}, -1, 4);
#elif CGAL_SURFACE_MESH_GEODESICS_LANES == 4
    return __builtin_ia32_sqrtpd256(x);
#elif defined(__x86_64__)
    return _mm_sqrt_pd(x);
#else
    return reinterpret_cast<Number>(vsqrtq_f64(reinterpret_cast<float64x2_t>(x)));
#endif
  }

  // a * b for a vector or a number b, rounded before it is added to anything.
  template <typename Factor>
  static Number rounded_product(Number a, Factor b)
  {
    Number product = a * b;
    CGAL_SURFACE_MESH_GEODESICS_KEEP_ROUNDED(product);
    return product;
  }

private:
#if CGAL_SURFACE_MESH_GEODESICS_LANES == 8
  typedef double Half __attribute__((vector_size(32)));
#endif
  // They may alias, as the memory that they read was written as plain numbers.
  typedef double Numbers_anywhere __attribute__((vector_size(8 * size), aligned(8), may_alias));
  typedef std::uint64_t Words_anywhere __attribute__((vector_size(8 * size), aligned(8), may_alias));
};

#endif

} // namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_LANES
