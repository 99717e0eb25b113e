// Diagrams of 1 to 30 sites on many meshes. The first part runs all checks and compares the distances from each site at
// a vertex with CGAL::Surface_mesh_shortest_path. The second part has sites at vertices only; that class is its
// only referee.

#include "Voronoi_test_helpers.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

std::size_t number_of_points = 0, number_of_comparisons = 0;

void check_sites(const Mesh& tm, std::size_t number, std::size_t points, bool compares, test_support::Random& random)
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

void diagrams_agree_with_distances(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  check_sites(tm, 1, 50, true, random);
  check_sites(tm, 2 + random.index(4), 150, true, random);
  check_sites(tm, 6 + random.index(8), 150, false, random);
  if(indexed.faces.size() <= 300)
  {
    check_sites(tm, 30, 100, false, random);
  }
}

// Holds one object of CGAL's class for each site at a vertex.
class Referee
{
public:
  Referee(const Mesh& tm, const std::vector<vertex_descriptor>& sites)
  {
    for(const vertex_descriptor v : sites)
    {
      m_of_site.push_back(std::make_unique<Shortest_path>(tm));
      m_of_site.back()->add_source_point(v);
    }
  }

  // Returns infinity for sites that do not reach the point.
  std::vector<double> distances(const Face_location& q)
  {
    std::vector<double> result;
    for(const std::unique_ptr<Shortest_path>& p : m_of_site)
    {
      const double d = p->shortest_distance_to_source_points(q.first, q.second).first;
      result.push_back(d < 0. ? infinity : d);
    }
    return result;
  }

private:
  std::vector<std::unique_ptr<Shortest_path>> m_of_site;
};

// Checks that the owner of a point is the nearest site, up to ties.
void check_owner(const Voronoi& diagram, Referee& referee, const Face_location& q)
{
  test_support::Scope scope(description(Surface_point(q)));
  const std::vector<double> all = referee.distances(q);
  const double nearest = *std::min_element(all.begin(), all.end());
  const std::size_t owner = diagram.nearest_site(q);
  if(nearest == infinity)
  {
    CHECK_EQUAL(owner, null_site);
    return;
  }
  if(CHECK(owner < all.size()))
  {
    CHECK_NEAR(all[owner], nearest, 1e-10 * nearest);
  }
  CHECK_NEAR(diagram.distance_to_nearest_site(q), nearest, 1e-10 * nearest);
}

// Checks random points of faces. Keeps away from sides, where CGAL's class may be wrong. Returns the number of points
// that a site reaches.
std::size_t check_owners(const Mesh& tm, std::size_t number_of_sites, std::size_t points, test_support::Random& random)
{
  test_support::Scope scope(std::to_string(number_of_sites) + " sites at vertices");
  std::vector<vertex_descriptor> sites;
  for(std::size_t i = 0; i < number_of_sites; ++i)
  {
    sites.push_back(random_vertex(tm, random));
  }
  Voronoi diagram(tm);
  diagram.add_sites(sites);
  Referee referee(tm, sites);
  std::size_t number_of_owned = 0;
  for(std::size_t k = 0; k < points; ++k)
  {
    const Face_location q = random_location(tm, random);
    check_owner(diagram, referee, q);
    number_of_owned += diagram.nearest_site(q) != null_site ? 1 : 0;
  }
  return number_of_owned;
}

void owners_agree_with_shortest_paths(std::uint64_t seed)
{
  test_support::Scope scope("Surface_mesh_shortest_path alone");
  test_support::Random random(seed + 1);
  std::size_t number_of_meshes = 0, number_of_owned = 0;
  for(const Indexed_mesh& indexed : collection(seed))
  {
    if(indexed.faces.size() <= 800)
    {
      test_support::Scope scope_of_mesh(indexed.name);
      const Mesh tm = to_face_graph(indexed);
      number_of_owned += check_owners(tm, 2 + random.index(3), 200, random);
      number_of_owned += check_owners(tm, 5 + random.index(6), 300, random);
      ++number_of_meshes;
    }
  }
  std::cout << number_of_meshes << " meshes, " << number_of_owned
            << " points whose owner Surface_mesh_shortest_path alone confirms" << std::endl;
  CHECK(number_of_meshes >= 12 && number_of_owned >= 10000);
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260602);
  owners_agree_with_shortest_paths(seed);
  test_support::Random random(seed);
  std::size_t number_of_meshes = 0;
  for(const Indexed_mesh& indexed : collection(seed))
  {
    if(indexed.faces.size() <= 800)
    {
      diagrams_agree_with_distances(indexed, random);
      ++number_of_meshes;
    }
  }
  std::cout << number_of_meshes << " meshes, " << number_of_points << " points, " << number_of_comparisons
            << " comparisons with Surface_mesh_shortest_path" << std::endl;
  CHECK(number_of_meshes >= 12 && number_of_points >= 10000 && number_of_comparisons >= 10000);
  return test_result();
}
