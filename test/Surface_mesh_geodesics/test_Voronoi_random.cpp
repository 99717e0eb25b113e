// Random small cases of diagrams. The number of cases and the seed of the first one may be given as arguments.

#include "random_Voronoi_diagram.h"

#include <cstdlib>

int main(int argc, char* argv[])
{
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 600;
  const std::uint64_t first = test_support::announce_seed(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 20260601);
  for(std::size_t i = 0; i < number; ++i)
  {
    test_meshes::test_random_diagram(first + i);
  }
  // A curve along an edge at a vertex, found to end at the vertex: from there it was drawn on to its other end with the
  // paths through the vertex, though others are shorter.
  test_meshes::test_random_diagram(20274790);
  return test_result();
}
