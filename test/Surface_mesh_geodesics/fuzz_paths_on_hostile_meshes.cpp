// test_paths_on_hostile_meshes.cpp with many more meshes. Arguments: the number of meshes, and the seed.

#include "hostile_meshes.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>

int main(int argc, char** argv)
{
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100000;
  const std::uint64_t seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  std::cout << "seed " << seed << "\n";
  hostile_meshes::paths_on_hostile_meshes(number, seed, 20);
  return test_support::test_result();
}
