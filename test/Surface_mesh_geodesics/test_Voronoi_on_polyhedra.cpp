// Diagrams of curves whose points are those of a lattice, on closed polyhedra and other meshes with few faces:
// bisectors run along edges, and cells of one curve meet behind the polyhedron. The class for paths tells the distances
// from each curve alone.

#include "Voronoi_test_helpers.h"
#include "curve_cases.h"
#include "lattice_curves.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

using namespace curve_cases;
using namespace lattice_curves;

namespace {

Indexed_mesh polyhedron(std::uint64_t kind)
{
  switch(kind)
  {
  case 0:
    return octahedron();
  case 1:
    return regular_tetrahedron();
  case 2:
    return icosahedron();
  case 3:
    return prism_tube(4, 2, 1., 2.);
  case 4:
    return saddle_patch(3);
  default:
    return bipyramid(4, .5);
  }
}

void check_case(std::uint64_t seed, bool has_weights, bool is_to_be_certified = false)
{
  const test_support::Scope scope("polyhedron, seed " + std::to_string(seed));
  test_support::Random random(seed);
  const Mesh tm = to_face_graph(polyhedron(seed % 6));
  const std::vector<std::vector<Location>> curves = random_curves(tm, 4, 3, random);
  const std::size_t n = curves.size();
  Voronoi diagram(tm);
  std::vector<std::unique_ptr<Paths>> paths;
  std::vector<double> weights;
  for(const std::vector<Location>& curve : curves)
  {
    weights.push_back(has_weights ? static_cast<double>(random.index(4)) / 16 : 0.);
    diagram.add_site(Curve(tm, curve), weights.back());
    paths.push_back(std::make_unique<Paths>(tm));
    paths.back()->add_source_curve(Curve(tm, curve));
  }
  for_each_query(tm, random,
                 [&](const Location& l)
                 {
                   double smallest = std::numeric_limits<double>::infinity();
                   const auto distance = [&](std::size_t i)
                   { return paths[i]->shortest_distance_to_source_points(l.first, l.second).first - weights[i]; };
                   for(std::size_t i = 0; i < n; ++i)
                     smallest = std::min(smallest, distance(i));
                   CHECK_NEAR(distance(diagram.nearest_site(l)), smallest, 1e-12);
                 });
  if(is_to_be_certified)
    CHECK(CGAL::Surface_mesh_geodesics::certify_geodesic_Voronoi_diagram(diagram).is_certified());
}

// Rounding led the bisector along an edge out of the face half-way to the edge on which it ends.
void bisectors_along_edges()
{
  check_case(151, false, true);
  check_case(1877, false, true);
}

// Edges from which the distances of two sites touch, bisectors whose images are on one ray, and an image on the line of
// its interval. (2147 and 5967 are of the second kind, 3307 is of the first one.)
void touching_distances()
{
  for(const std::uint64_t seed : {1418u, 2147u, 3074u, 4146u, 5967u})
    check_case(seed, false, true);
  check_case(3307, true, true);
}

void random_cases()
{
  for(const bool has_weights : {false, true})
    for(std::uint64_t seed = 0; seed < 600; ++seed)
      check_case(seed, has_weights);
}

} // namespace

int main()
{
  bisectors_along_edges();
  touching_distances();
  random_cases();
  return test_result();
}
