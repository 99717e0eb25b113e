// Small random diagrams. Arguments: the number of diagrams, and the seed of the first one.

#include "random_Voronoi_diagram.h"

#include <cstdlib>

int main(int argc, char* argv[])
{
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 600;
  const std::uint64_t first = test_support::announce_seed(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 20260601);
  for(std::size_t i = 0; i < number; ++i)
  {
    test_meshes::check_random_diagram(first + i);
  }
  // A curve along an edge ends at a vertex. A former version continued it with the paths through the vertex, although
  // other paths are shorter.
  test_meshes::check_random_diagram(20274790);
  return test_result();
}
