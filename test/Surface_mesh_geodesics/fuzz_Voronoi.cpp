// test_Voronoi_random.cpp with many more diagrams. Arguments: the number of diagrams, and the first seed.

#include "random_Voronoi_diagram.h"

#include <cstdlib>

int main(int argc, char* argv[])
{
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 10000;
  const std::uint64_t first = test_support::announce_seed(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 20270000);
  for(std::size_t i = 0; i < number; ++i)
  {
    test_meshes::check_random_diagram(first + i);
  }
  return test_result();
}
