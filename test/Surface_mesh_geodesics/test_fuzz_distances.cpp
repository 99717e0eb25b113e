// Distances on 500 small random surfaces of the worst kinds, each checked by the certificate and by referees. Many
// more of them: fuzz_distances.cpp.

#include "distance_fuzzing.h"
#include "test_support.h"

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <vector>

using namespace test_meshes;
using namespace distance_fuzzing;

namespace {

void distances_are_right(std::size_t number, std::uint64_t seed)
{
  const std::vector<Counts> all = distances_on_hostile_surfaces(number, seed);
  std::size_t number_of_surfaces = 0, number_compared = 0, number_certified = 0;
  for(const Counts& c : all)
  {
    CHECK_EQUAL(c.faults, std::size_t(0));
    CHECK(c.surfaces > c.no_surfaces);
    CHECK(c.compared > 0);
    CHECK(c.worst_error <= tolerance);
    number_of_surfaces += c.surfaces;
    number_compared += c.compared;
    number_certified += c.certified;
  }
  CHECK(2 * number_compared > number_of_surfaces);
  CHECK(number_certified * 100 >= 99 * number_of_surfaces);
}

void surfaces_without_orientation_are_refused(std::size_t number, std::uint64_t seed)
{
  CHECK_EQUAL(number_refused(number, seed), number);
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261101);
  surfaces_without_orientation_are_refused(50, seed);
  distances_are_right(500, seed);
  return test_result();
}
