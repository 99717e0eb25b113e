// test_paths_near_vertices.cpp with many more meshes. Arguments: the number of rectangles (a tenth as many other
// meshes follow), and the seed.

#include "paths_near_vertices.h"

#include <cstdint>
#include <cstdlib>
#include <iostream>

int main(int argc, char** argv)
{
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
  const std::uint64_t seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  std::cout << "seed " << seed << "\n";
  test_support::Random random(seed);
  paths_near_vertices::paths_in_rectangles_of_long_faces_are_found(number, random);
  paths_near_vertices::paths_on_squeezed_meshes_are_found(number / 10, random);
  return test_support::test_result();
}
