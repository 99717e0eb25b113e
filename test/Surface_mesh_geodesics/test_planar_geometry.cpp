// The basic formulas of the plane, where rounding matters: sums of angles around a vertex, triangles from their sides,
// comparison of distances.

#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Angle_sum.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using Angle_sum = internal::Angle_sum<double>;

const double pi = std::acos(-1.);

// --- angles ----------------------------------------------------------------------------------------------------------

void add_angle(Angle_sum& sum, double angle, double scale)
{
  sum.add(scale * std::cos(angle), scale * std::sin(angle));
}

// The sum of n random parts of an angle. Requires: each part is less than pi.
Angle_sum divided(double angle, std::size_t n, test_support::Random& random)
{
  std::vector<double> parts;
  double total = 0;
  for(std::size_t i = 0; i < n; ++i)
  {
    parts.push_back(random.uniform(.5, 1.));
    total += parts.back();
  }
  Angle_sum sum;
  for(const double p : parts)
  {
    add_angle(sum, angle * p / total, random.uniform(1e-6, 1e6));
  }
  return sum;
}

// Sums of many parts that are pi or 2 pi, or differ from that by the margin.
void angles_next_to_flat_ones_are_not_flat(test_support::Random& random)
{
  const double margin = 1e-9; // far above rounding, far below the angles of meshes
  for(std::size_t n = 6; n < 200; n += 1 + n / 4)
  {
    CHECK(!divided(2 * pi, n, random).is_more_than_full());
    CHECK(!divided(2 * pi - margin, n, random).is_more_than_full());
    CHECK(divided(2 * pi + margin, n, random).is_more_than_full());
    CHECK(!divided(pi, n, random).is_more_than_half());
    CHECK(!divided(pi - margin, n, random).is_more_than_half());
    CHECK(divided(pi + margin, n, random).is_more_than_half());
  }
}

void sums_of_angles_are_compared_with_half_and_full_turns(test_support::Random& random)
{
  for(std::size_t n = 16; n < 100; n += 7)
  {
    for(const double angle : {.001, 1., 3., pi, 4., 5.})
    {
      CHECK(!divided(angle, n, random).is_more_than_full());
      CHECK_EQUAL(divided(angle, n, random).is_more_than_half(), angle > 3.5);
    }
    for(const double half_turns : {2.5, 2.99, 3., 3.01, 3.5, 4., 4.5, 5., 6., 7.})
    {
      for(const double rounding : {-1e-14, 0., 1e-14})
      {
        const Angle_sum sum = divided(half_turns * pi + rounding, n, random);
        CHECK(sum.is_more_than_full());
        CHECK(sum.is_more_than_half());
      }
    }
  }
  CHECK(!Angle_sum().is_more_than_full());
  CHECK(!Angle_sum().is_more_than_half());
}

// Right angles are exact.
void sums_of_right_angles_are_exact()
{
  Angle_sum sum;
  for(int n = 1; n <= 12; ++n)
  {
    sum.add(0., 2.);
    CHECK_EQUAL(sum.is_more_than_half(), n > 2);
    CHECK_EQUAL(sum.is_more_than_full(), n > 4);
  }
}

// --- triangles -------------------------------------------------------------------------------------------------------

// Compares a triangle with the same triangle in more digits. The sides are exact in both.
void check_triangle(double a, double b, double c)
{
  const internal::Planar_triangle<double> found = internal::planar_triangle_from_lengths(a, b, c);
  const internal::Planar_triangle<long double> expected = internal::planar_triangle_from_lengths<long double>(a, b, c);
  CHECK_EQUAL(found.base, a);
  CHECK_CLOSE(found.apex_y, static_cast<double>(expected.apex_y), 1e-14);
  CHECK_NEAR(found.apex_x, static_cast<double>(expected.apex_x), 4e-16 * (std::max)(a, c));
  // The distances of the corners are the given sides.
  CHECK_CLOSE(internal::norm<double>(found.apex_x, found.apex_y), c, 1e-15);
  CHECK_CLOSE(internal::norm<double>(found.apex_x - a, found.apex_y), b, 1e-15);
}

void triangles_have_the_given_sides(test_support::Random& random)
{
  for(std::size_t i = 0; i < 2000; ++i)
  {
    const double a = std::pow(10., random.uniform(-9., 0.));
    // The angle at the first corner, and the side from there to the apex.
    const double angle = random.uniform(.01, 3.13), c = random.uniform(1., 2.);
    const double b = std::hypot(c * std::cos(angle) - a, c * std::sin(angle));
    if(a <= b)
    {
      check_triangle(a, b, c);
    }
  }
}

void triangles_without_area_have_no_height()
{
  const internal::Planar_triangle<double> cap = internal::planar_triangle_from_lengths(1., 2., 3.);
  CHECK_EQUAL(cap.apex_y, 0.);
  CHECK_EQUAL(cap.apex_x, 3.);
  const internal::Planar_triangle<double> needle = internal::planar_triangle_from_lengths(0., 2., 2.);
  CHECK_EQUAL(needle.apex_y, 0.);
  CHECK_EQUAL(needle.apex_x, 2.);
}

// The rule is relative to the longest side, so it does not depend on the unit of length.
void heights_below_rounding_count_as_zero()
{
  for(const double longest : {1e-70, 1., 1e70})
  {
    for(const double height : {0., 1e-16, 1e-12})
    {
      CHECK(internal::is_without_height(height * longest * longest, longest));
    }
    for(const double height : {1e-10, 1e-6, 1.})
    {
      CHECK(!internal::is_without_height(height * longest * longest, longest));
    }
  }
}

// --- comparison ------------------------------------------------------------------------------------------------------

void distances_that_differ_by_rounding_tie()
{
  for(const double d : {1e-150, 1e-3, 1., 7., 1e150})
  {
    const double next = std::nextafter(d, 2 * d);
    CHECK(!internal::is_clearly_less(d, d));
    CHECK(!internal::is_clearly_less(d, next));
    CHECK(!internal::is_clearly_less(next, d));
    CHECK(internal::is_clearly_less(d, d * (1 + 1e-14)));
    CHECK(!internal::is_clearly_less(d * (1 + 1e-14), d));
  }
  CHECK(internal::is_clearly_less(0., 1e-300));
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20261122));
  angles_next_to_flat_ones_are_not_flat(random);
  sums_of_angles_are_compared_with_half_and_full_turns(random);
  sums_of_right_angles_are_exact();
  triangles_have_the_given_sides(random);
  triangles_without_area_have_no_height();
  heights_below_rounding_count_as_zero();
  distances_that_differ_by_rounding_tie();
  return test_support::test_result();
}
