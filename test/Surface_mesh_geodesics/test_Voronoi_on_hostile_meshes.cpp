// Diagrams of weighted and of equal sites on meshes with needles, caps, nearly equal points and vertices of all scales.
// Where sites tie, or faces are thinner, within rounding, the certificate may find a fault; more than one diagram of a
// hundred is more than is known of. Those with faults are printed. The number of meshes, and the seed, may be given as
// arguments.

#include "Voronoi_test_helpers.h"
#include "hostile_meshes.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

using namespace test_meshes;
using Certificate = CGAL::Surface_mesh_geodesics::Geodesic_Voronoi_certificate;
using Condition = Certificate::Condition;

// Areas of faces are computed from lengths: that of a face whose height is rounding is known to the square root of
// rounding only, and so is the sum.
double tolerance_of(Condition condition)
{
  return condition == Condition::AREAS ? 0x1p-26 : Certificate::default_tolerance;
}

bool is_right(const Mesh& tm, const Weighted_sites& sites, const std::string& name)
{
  Voronoi diagram(tm);
  add_sites(diagram, sites);
  const Certificate certificate = CGAL::Surface_mesh_geodesics::certify_geodesic_Voronoi_diagram(diagram);
  bool is_right = true;
  for(std::size_t k = 0; k < Certificate::number_of_conditions; ++k)
  {
    const Condition condition = static_cast<Condition>(k);
    if(certificate.worst_violation(condition) > tolerance_of(condition))
    {
      is_right = false;
      std::cout << name << ": " << Certificate::name(condition) << " " << certificate.worst_violation(condition) << "\n";
    }
  }
  return is_right;
}

} // namespace

int main(int argc, char* argv[])
{
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 600;
  const std::uint64_t seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 8;
  std::cout << "seed " << seed << "\n";
  test_support::Random random(seed);
  std::size_t number_of_diagrams = 0, number_with_faults = 0;
  for(std::size_t i = 0; i < number; ++i)
  {
    const Indexed_mesh mesh = hostile_meshes::hostile_mesh(random);
    const double largest_weight = random.index(2) == 0 ? 0. : 0.3;
    Mesh tm;
    try
    {
      tm = to_face_graph(mesh);
    }
    catch(const std::logic_error&) // where faces were cut away
    {
      continue;
    }
    const Weighted_sites sites = random_sites(tm, 4, largest_weight, random);
    number_with_faults += is_right(tm, sites, mesh.name + ", number " + std::to_string(i)) ? 0 : 1;
    ++number_of_diagrams;
  }
  std::cout << number_of_diagrams << " diagrams, " << number_with_faults << " with faults\n";
  CHECK(number_of_diagrams > number / 2);
  CHECK(100 * number_with_faults <= number_of_diagrams);
  return test_result();
}
