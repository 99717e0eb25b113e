// Diagrams of curves whose points are those of a lattice, on flat grids: curves share points and segments, cross and
// continue each other, and run along the edges of the mesh. Cells end in points of the border of a face, have no width,
// or meet four at a time; weights are often the distance of two ends, so that bisectors are rays. The distances from
// segments in the plane tell which site is nearest.

#include "lattice_diagrams.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

using namespace lattice_diagrams;

namespace {

// No site is nearer to a point than the one that the diagram names (for_each_query()).
void check_nearest_sites(const Mesh& tm, const Sites& sites, const Voronoi& diagram, test_support::Random& random)
{
  const auto check = [&](const Location& l)
  {
    const Point_2 p = point(tm, l);
    const auto distance = [&](std::size_t i) { return distance_from(tm, sites.curves[i], p) - sites.weights[i]; };
    double smallest = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < sites.curves.size(); ++i)
      smallest = std::min(smallest, distance(i));
    CHECK_NEAR(distance(diagram.nearest_site(l)), smallest, 1e-12);
  };
  for_each_query(tm, random, check);
}

void check_case(const Lattice& lattice, std::uint64_t seed, bool is_to_be_certified = false)
{
  const test_support::Scope scope("lattice of " + std::to_string(lattice.parts) + ", seed " + std::to_string(seed));
  Lattice_case c(lattice, seed);
  Voronoi diagram(c.mesh);
  c.add_sites_to(diagram);
  check_nearest_sites(c.mesh, c.sites, diagram, c.random);
  if(is_to_be_certified)
    CHECK(CGAL::Surface_mesh_geodesics::certify_geodesic_Voronoi_diagram(diagram).is_certified());
}

// Diagrams that were wrong by so little that samples do not show it, and right ones that the certificate refused.
void certified_cases()
{
  check_case(Lattice{4, 0., false}, 7244, true);     // four cells meet in one point, and two bisectors touch
  check_case(Lattice{8, 0., false}, 5812, true);     // a wedge between two fronts that start at one corner
  check_case(Lattice{3, 0., true, 4}, 4430, true);   // a cell of which a face has the edge only
  check_case(Lattice{2, 0., true}, 19502, true);     // all rays of two curves tie
  check_case(Lattice{2, 0., false}, 15511, true);    // two fronts that start at one corner, and no wedge
  for(const unsigned int seed : {1964u, 9433u})      // distances that rounding makes negative
    check_case(Lattice{4, 0., false}, seed, true);
  for(const unsigned int seed : {52u, 103u, 398u, 9880u}) // an image that belongs to both sites of an arc
    check_case(Lattice{4, 0., false}, seed, true);
  check_case(Lattice{3, 0., true, 4}, 6134, true);   // distances as small as the rounding of rays
  check_case(Lattice{2, 0., true}, 39994, true);     // a vertex of the diagram on a ray
  for(const unsigned int seed : {22298u, 33726u})    // weights that differ by a distance: sites tie on one ray
    check_case(Lattice{2, 0., true}, seed, true);
  for(const unsigned int seed : {11242u, 25584u, 33023u, 37513u}) // the same, in thirds
    check_case(Lattice{3, 0., true, 4}, seed, true);
}

void random_cases()
{
  for(const Lattice& lattice : {Lattice{4, 0., false}, Lattice{4, 0., true}, Lattice{8, 0., false},
                                Lattice{4, .2, false}, Lattice{2, 0., true}, Lattice{4, 0., true, 1}})
    for(std::uint64_t seed = 0; seed < 1000; ++seed)
      check_case(lattice, seed);
}

// Cases that show what is rare among random ones: cells that end in a point, or have no width.
void rare_cases()
{
  for(const unsigned int seed : {668u, 1787u, 4202u, 7247u, 10002u, 12449u, 13954u, 14416u, 15105u,
                                 17195u, 17196u, 18859u})
    check_case(Lattice{4, 0., false}, seed);
  for(const unsigned int seed : {2176u, 2378u, 2479u, 6037u, 9178u, 9190u, 9783u, 10502u, 17885u})
    check_case(Lattice{4, 0., true}, seed);
  for(const unsigned int seed : {1547u, 1770u, 2176u, 2378u, 2479u, 4794u, 9178u, 9783u})
    check_case(Lattice{4, 0., true, 1}, seed);
  for(const unsigned int seed : {3242u, 8767u, 17266u})
    check_case(Lattice{8, 0., false}, seed);
  for(const unsigned int seed : {1704u, 3565u, 12860u})
    check_case(Lattice{4, .2, false}, seed);
  for(const unsigned int seed : {2176u, 2378u, 2479u, 3966u, 5198u, 9178u, 9783u, 9843u, 14134u, 18657u, 19453u})
    check_case(Lattice{2, 0., true}, seed);
}

// A ray that ends at a breakpoint of another curve of the same two sites: the difference of the weights is the distance
// of two ends, so that one site has a cell without width behind its end.
void ray_to_a_breakpoint()
{
  const Mesh tm = to_face_graph(flat_patch(4, 4, 0., true, 1));
  const auto at = [](double a, double b, double c) { return Location(Face(3), {a, b, c}); };
  const Sites sites{{{at(0, 0, 1), at(0, 1, 0), at(.5, .25, .25)}, {at(0, 1, 0), at(.25, .5, .25)}}, {0., .25}};
  Voronoi diagram(tm);
  for(std::size_t i = 0; i < 2; ++i)
    diagram.add_site(Curve(tm, sites.curves[i]), sites.weights[i]);
  test_support::Random random(1);
  for(int i = 0; i < 20; ++i)
    check_nearest_sites(tm, sites, diagram, random);
  CHECK(CGAL::Surface_mesh_geodesics::certify_geodesic_Voronoi_diagram(diagram).is_certified());
}

} // namespace

int main()
{
  ray_to_a_breakpoint();
  rare_cases();
  certified_cases();
  random_cases();
  return test_result();
}
