// test_fuzz_distances.cpp with many more surfaces. Arguments: the number of surfaces, the seed, and the folder into
// the program writes failing cases. With --case and the name of such a case, without .off, checks that case again.

#include "distance_fuzzing.h"
#include "test_support.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

namespace {

int examine_file(const std::string& stem)
{
  const distance_fuzzing::Findings findings = distance_fuzzing::examine(test_meshes::read_case(stem));
  CHECK(findings.is_surface);
  CHECK_EQUAL(findings.fault, "");
  std::cout << "relative error " << findings.worst_error << ", violation " << findings.worst_violation << "\n";
  return test_result();
}

} // namespace

int main(int argc, char** argv)
{
  if(argc > 2 && std::string(argv[1]) == "--case")
  {
    return examine_file(argv[2]);
  }
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100000;
  const std::uint64_t seed = test_support::announce_seed(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1);
  const std::size_t number_not_oriented = (std::min)(number, std::size_t(1000));
  CHECK_EQUAL(distance_fuzzing::number_rejected(number_not_oriented, seed), number_not_oriented);
  distance_fuzzing::distances_on_hostile_surfaces(number, seed, argc > 3 ? argv[3] : ".");
  return test_result();
}
