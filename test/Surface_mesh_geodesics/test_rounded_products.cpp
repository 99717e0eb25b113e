// Products that are rounded before they enter a sum (rounded_product()): no compiler fuses the two, even where it may
// and the processor can. The operations on pairs of doubles (Double_pair.h) are those on two single numbers.

// This file may fuse, whatever the flags say, and is optimized enough to do so. (The pragma comes before all headers,
// so that their functions may be inlined.)
#if defined(__clang__)
#pragma clang fp contract(fast)
#elif defined(__GNUC__)
#pragma GCC optimize("O2", "fp-contract=fast")
#endif

#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/window/Double_pair.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_loops.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <limits>
#include <string>

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using One = internal::One_lane<double>;

// --- products --------------------------------------------------------------------------------------------------------

// Functions for one kind of lanes that may use the instruction sets of TARGET: what is left of a product, rounded or
// plain, when the rounded product is subtracted. That is zero, unless the compiler fuses the two. (One function each:
// compilers fuse no product that is also used elsewhere.)
#define DEFINE_RESTS(NAME, TARGET)                                                                  \
  template <class L>                                                                                \
  TARGET double NAME##_rounded(double a, double b, double product)                                  \
  {                                                                                                 \
    double rest[8];                                                                                 \
    L::store(rest, L::rounded_product(L::all(a), L::all(b)) - L::all(product));                     \
    return rest[L::size - 1];                                                                       \
  }                                                                                                 \
  template <class L>                                                                                \
  TARGET double NAME##_plain(double a, double b, double product)                                    \
  {                                                                                                 \
    double rest[8];                                                                                 \
    L::store(rest, L::all(a) * L::all(b) - L::all(product));                                        \
    return rest[L::size - 1];                                                                       \
  }

#if defined(__x86_64__) && defined(CGAL_SURFACE_MESH_GEODESICS_HAS_VECTORS)
DEFINE_RESTS(rest, __attribute__((target("fma"), flatten)))
#else
DEFINE_RESTS(rest, )
#endif
#if CGAL_SURFACE_MESH_GEODESICS_MOST_LANES > 2
DEFINE_RESTS(rest_of_four, __attribute__((target("avx2,fma"), flatten)))
DEFINE_RESTS(rest_of_eight, __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,fma"), flatten)))
#endif

using Rest = double (*)(double a, double b, double product);

void check_products(const std::string& lanes, Rest rest_of_rounded, Rest rest_of_plain)
{
  test_support::Scope scope(lanes);
  test_support::Random random(20260411);
  int number_fused = 0;
  for(int k = 0; k < 1000; ++k)
  {
    const double a = random.uniform(1., 2.), b = random.uniform(-2., 2.);
    volatile double product = a * b;
    CHECK_EQUAL(rest_of_rounded(a, b, product), 0.);
    number_fused += rest_of_plain(a, b, product) != 0. ? 1 : 0;
  }
  std::cout << lanes << ": the compiler has fused " << number_fused << " of 1000 plain products" << std::endl;
}

void products_are_rounded()
{
#if defined(__x86_64__) && defined(CGAL_SURFACE_MESH_GEODESICS_HAS_VECTORS)
  if(!__builtin_cpu_supports("fma"))
  {
    std::cout << "this processor has no fused operations" << std::endl;
    return;
  }
#endif
  check_products("one lane", rest_rounded<One>, rest_plain<One>);
#if defined(__x86_64__) || defined(_M_X64)
  using internal::Double_pair_lanes;
  check_products("pairs", rest_rounded<Double_pair_lanes>, rest_plain<Double_pair_lanes>);
#endif
#if CGAL_SURFACE_MESH_GEODESICS_MOST_LANES > 1
  using Two = internal::two_lanes::Lanes<double>;
  check_products("two lanes", rest_rounded<Two>, rest_plain<Two>);
#endif
#if CGAL_SURFACE_MESH_GEODESICS_MOST_LANES > 2
  using Four = internal::avx2_lanes::Lanes<double>;
  if(__builtin_cpu_supports("avx2"))
    check_products("four lanes", rest_of_four_rounded<Four>, rest_of_four_plain<Four>);
  using Eight = internal::avx512_lanes::Lanes<double>;
  if(__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
    check_products("eight lanes", rest_of_eight_rounded<Eight>, rest_of_eight_plain<Eight>);
#endif
}

// --- pairs -----------------------------------------------------------------------------------------------------------

#if defined(__x86_64__) || defined(_M_X64)

using Pairs = internal::Double_pair_lanes;

// Equal bits, or both NaN: the sign of a NaN that an operation makes is not specified.
bool same(double a, double b)
{
  std::uint64_t x, y;
  std::memcpy(&x, &a, sizeof x);
  std::memcpy(&y, &b, sizeof y);
  return x == y || (a != a && b != b);
}

void check_numbers(Pairs::Number found, double expected_0, double expected_1)
{
  double numbers[2];
  Pairs::store(numbers, found);
  CHECK(same(numbers[0], expected_0));
  CHECK(same(numbers[1], expected_1));
}

void check_words(Pairs::Word found, std::uint64_t expected_0, std::uint64_t expected_1)
{
  std::uint64_t words[2];
  Pairs::store(words, found);
  CHECK_EQUAL(words[0], expected_0);
  CHECK_EQUAL(words[1], expected_1);
}

void check_mask(Pairs::Mask found, One::Mask expected_0, One::Mask expected_1)
{
  CHECK_EQUAL(Pairs::bits(found), One::bits(expected_0) | One::bits(expected_1) << 1);
}

// All operations on the pairs (a[0], a[1]) and (b[0], b[1]).
void check_operations(const double* a, const double* b)
{
  const Pairs::Number x = Pairs::load(a), y = Pairs::load(b);
  check_numbers(x + y, a[0] + b[0], a[1] + b[1]);
  check_numbers(x - y, a[0] - b[0], a[1] - b[1]);
  check_numbers(x * y, a[0] * b[0], a[1] * b[1]);
  check_numbers(x / y, a[0] / b[0], a[1] / b[1]);
  check_numbers(a[0] * y, a[0] * b[0], a[0] * b[1]);
  check_numbers(Pairs::all(a[1]), a[1], a[1]);
  check_numbers(Pairs::minimum(x, y), One::minimum(a[0], b[0]), One::minimum(a[1], b[1]));
  check_numbers(Pairs::maximum(x, y), One::maximum(a[0], b[0]), One::maximum(a[1], b[1]));
  check_numbers(Pairs::square_root(x), One::square_root(a[0]), One::square_root(a[1]));
  check_numbers(Pairs::rounded_product(x, y), a[0] * b[0], a[1] * b[1]);
  check_numbers(Pairs::shift_in(x, y), a[1], b[0]);
  const Pairs::Mask less = Pairs::less(x, y), not_more = Pairs::less_equal(x, y);
  const One::Mask less_0 = One::less(a[0], b[0]), less_1 = One::less(a[1], b[1]);
  const One::Mask not_more_0 = One::less_equal(a[0], b[0]), not_more_1 = One::less_equal(a[1], b[1]);
  check_mask(less, less_0, less_1);
  check_mask(not_more, not_more_0, not_more_1);
  check_mask(less & not_more, less_0 & not_more_0, less_1 & not_more_1);
  check_mask(less | Pairs::less(y, x), less_0 | One::less(b[0], a[0]), less_1 | One::less(b[1], a[1]));
  check_mask(Pairs::except(not_more, less), One::except(not_more_0, less_0), One::except(not_more_1, less_1));
  check_mask(Pairs::except(less, not_more), One::except(less_0, not_more_0), One::except(less_1, not_more_1));
  check_numbers(Pairs::select(less, x, y), One::select(less_0, a[0], b[0]), One::select(less_1, a[1], b[1]));
  const std::uint64_t p[2] = {3, std::uint64_t(1) << 63}, q[2] = {~std::uint64_t(0), 5};
  check_words(Pairs::select_word(less, Pairs::load(p), Pairs::load(q)), One::select_word(less_0, p[0], q[0]),
              One::select_word(less_1, p[1], q[1]));
  if(a[0] == a[0] && a[1] == a[1])
    CHECK_EQUAL(Pairs::least(x), a[0] < a[1] ? a[0] : a[1]);
}

void pairs_are_two_numbers()
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const double numbers[] = {0, -0., 1, -1.5, 1e-310, 1e300, infinity, -infinity, not_a_number};
  for(const double a_0 : numbers)
    for(const double a_1 : numbers)
      for(const double b_0 : numbers)
        for(const double b_1 : numbers)
        {
          const double a[2] = {a_0, a_1}, b[2] = {b_0, b_1};
          check_operations(a, b);
        }
}

void pairs_of_words_are_two_words()
{
  const std::uint64_t p[2] = {7, std::uint64_t(1) << 40};
  const Pairs::Word x = Pairs::load(p);
  check_words(x | 8, p[0] | 8, p[1] | 8);
  check_words(x + ~std::uint64_t(0), p[0] - 1, p[1] - 1);
  check_words(x >> 2, p[0] >> 2, p[1] >> 2);
  check_words(Pairs::count_from(5), 5, 6);
  CHECK_EQUAL(Pairs::least(x, 1), p[0]);
  CHECK_EQUAL(Pairs::least(x, 2), p[1]);
  CHECK_EQUAL(Pairs::least(x, 3), p[0]);
  const std::uint64_t q[2] = {9, 4};
  CHECK_EQUAL(Pairs::least(Pairs::load(q), 3), q[1]);
  CHECK_EQUAL(Pairs::least(Pairs::load(q), 1), q[0]);
  // How many lanes of a last step count: none if the number, read as a signed one, is negative.
  check_mask(Pairs::first(0), 0, 0);
  check_mask(Pairs::first(1), 1, 0);
  check_mask(Pairs::first(2), 1, 1);
  check_mask(Pairs::first(100), 1, 1);
  check_mask(Pairs::first(std::size_t(0) - 1), 0, 0);
}

#endif

} // namespace

int main()
{
  products_are_rounded();
#if defined(__x86_64__) || defined(_M_X64)
  pairs_are_two_numbers();
  pairs_of_words_are_two_words();
#endif
  return test_result();
}
