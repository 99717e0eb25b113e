// Certifies random diagrams of curves on lattices, as in test_Voronoi_on_lattices.cpp. Two curves may tie on a segment
// or a ray, and the certificate may refuse what is undetermined: the program prints how many diagrams it refuses, and
// fails if these are more than one in 20,000, and one more. Arguments: the number of diagrams, and the first seed.

#include "lattice_diagrams.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  using namespace lattice_diagrams;
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 240000;
  const std::uint64_t first = test_support::announce_seed(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0);
  const Lattice lattices[] = {{2, 0., true}, {3, 0., true, 4}, {3, 0., false, 4},
                              {4, 0., true}, {8, 0., false},   {4, .2, false}};
  std::size_t refused = 0;
  for(std::size_t i = 0; i < number; ++i)
  {
    const Lattice& lattice = lattices[i % 6];
    const Lattice_case c(lattice, first + i / 6);
    Voronoi diagram(c.mesh);
    c.add_sites_to(diagram);
    const double violation
      = CGAL::Surface_mesh_geodesics::certify_geodesic_Voronoi_diagram(diagram).worst_violation();
    if(violation > CGAL::Surface_mesh_geodesics::Geodesic_Voronoi_certificate::default_tolerance)
    {
      ++refused;
      std::cout << "lattice of " << lattice.parts << ", seed " << first + i / 6 << ": violation " << violation << '\n';
    }
  }
  std::cout << refused << " of " << number << " diagrams refused\n";
  CHECK(refused <= 1 + number / 20000);
  return test_result();
}
