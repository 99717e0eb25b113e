// Diagrams of 1 to 30 sites on many meshes, checked in all ways, where the distances from single sites are compared
// with CGAL::Surface_mesh_shortest_path for sites at vertices.

#include "Voronoi_test_helpers.h"

#include <iostream>

using namespace test_meshes;

namespace {

std::size_t number_of_points = 0, number_of_comparisons = 0;

void test_sites(const Mesh& tm, std::size_t number, std::size_t points, bool compares, test_support::Random& random)
{
  test_support::Scope scope(std::to_string(number) + " sites");
  const Weighted_sites sites = random_sites(tm, number, 0., random);
  Voronoi diagram(tm);
  add_sites(diagram, sites);
  Voronoi_validator validator(tm, diagram, sites, nullptr, compares);
  validator.check_all(random, points);
  number_of_points += points;
  number_of_comparisons += validator.distances().number_of_comparisons();
}

void test_mesh(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  test_sites(tm, 1, 50, true, random);
  test_sites(tm, 2 + random.index(4), 150, true, random);
  test_sites(tm, 6 + random.index(8), 150, false, random);
  if(indexed.faces.size() <= 300)
  {
    test_sites(tm, 30, 100, false, random);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260602);
  test_support::Random random(seed);
  std::size_t number_of_meshes = 0;
  for(const Indexed_mesh& indexed : collection(seed))
  {
    if(indexed.faces.size() <= 800)
    {
      test_mesh(indexed, random);
      ++number_of_meshes;
    }
  }
  std::cout << number_of_meshes << " meshes, " << number_of_points << " points, " << number_of_comparisons
            << " comparisons with Surface_mesh_shortest_path" << std::endl;
  CHECK(number_of_meshes >= 12 && number_of_points >= 10000 && number_of_comparisons >= 10000);
  return test_result();
}
