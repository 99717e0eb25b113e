// Meshes with duplicate points, hence with edges of length zero and faces of area zero. The nearest site has the
// smallest of all distances, and areas add up.

#include "random_Voronoi_diagram.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

std::size_t number_of_points = 0;

void check_point(const Mesh& tm, const Voronoi& diagram, const Weighted_sites& sites, Distances_of_sites& distances,
                 const Face_location& q)
{
  test_support::Scope scope(description(Surface_point(q)));
  const std::size_t site = diagram.nearest_site(q);
  const double nearest = diagram.distance_to_nearest_site(q);
  if(site == null_site)
  {
    CHECK_EQUAL(nearest, -1.);
    return;
  }
  CHECK(site < sites.size());
  CHECK_NEAR(distances(site, Surface_point(q)), nearest, 1e-12 * longest_edge(tm));
  ++number_of_points;
}

void check_diagram(const Mesh& tm, const Weighted_sites& sites, const std::vector<Face_location>& points)
{
  Voronoi diagram(tm);
  add_sites(diagram, sites);
  Distances_of_sites distances(tm, sites);
  for(const Face_location& q : points)
  {
    check_point(tm, diagram, sites, distances, q);
  }
  double sum = 0.;
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    sum += diagram.area(i);
    const auto c = diagram.centroid(i);
    CHECK(std::isfinite(c.x()) && std::isfinite(c.y()) && std::isfinite(c.z()));
  }
  double area = 0.;
  for(const face_descriptor f : faces(tm))
  {
    const halfedge_descriptor h = halfedge(f, tm);
    const Coordinates p = coordinates(source(h, tm), tm);
    const Coordinates normal = cross(coordinates(target(h, tm), tm) - p, coordinates(target(next(h, tm), tm), tm) - p);
    area += diagram.nearest_site(target(h, tm)) == null_site ? 0. : length(normal) / 2.;
  }
  CHECK_NEAR(sum, area, 1e-12 * (1. + area));
}

void a_face_without_area_beside_a_site_is_divided()
{
  test_support::Scope scope("three faces");
  const Mesh tm = to_face_graph({"three faces",
                                 {{0., 0., .83915596268977755}, {0., 0., 1.1866535582799729},
                                   {0., 0., .46528433071275471},
                                  {0., 0., 1.9768203538464548}, {1., 0., .49397079944796679}},
                                 {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}}});
  const Weighted_sites sites{
    {Face_location(face_descriptor(2), {2.7619778392142518e-10, .487320793875339, .51267920584846327}), 0.},
    {Face_location(face_descriptor(1), {.41568276576702878, .52841267209789544, .055904562135075775}), 0.}};
  check_diagram(tm, sites, {Face_location(face_descriptor(0), {.2, .3, .5})});
}

void points_near_an_edge_have_the_nearest_site()
{
  test_support::Scope scope("square with duplicate points");
  const Mesh tm = to_face_graph({"square with duplicate points",
                                 {{0., 0., 0.}, {1., 0., 0.}, {0., 0., 0.}, {1., 1., 0.}, {0., 1., 0.}, {0., 1., 0.},
                                  {1., 1., 0.}, {1., 1., 0.}},
                                 {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}, {3, 6, 5}, {3, 7, 6}}});
  const Weighted_sites sites{
    {Face_location(face_descriptor(5), {.3803000045781495, 4.4298893653746232e-06, .61969556553248517}), 0.},
    {Face_location(face_descriptor(0), {.15391409751603724, .4370640413627972, .40902186112116556}), 0.},
    {Face_location(face_descriptor(4), {9.9943292730165516e-14, .3808295113458775, .61917048865402258}), 0.}};
  std::vector<Face_location> points;
  for(const double c : {1.0874328151276937e-13, 1e-13, 5e-14, 1e-12, 1e-11, 1e-9, 1e-6, 1e-3})
  {
    points.emplace_back(face_descriptor(1), std::array<double, 3>{.14327977064050046, c, 1. - .14327977064050046 - c});
  }
  check_diagram(tm, sites, points);
}

// A grid whose points are rounded so coarsely that many of them are equal.
void grids_with_equal_points_are_divided(std::uint64_t seed)
{
  test_support::Scope scope("grid " + std::to_string(seed));
  test_support::Random random(seed);
  Indexed_mesh indexed = flat_patch(2 + random.index(3), 2 + random.index(3), .3, true, seed);
  for(Coordinates& p : indexed.points)
  {
    for(double& x : p)
    {
      x = random.index(3) == 0 ? x : std::round(x * .7);
    }
  }
  const Mesh tm = to_face_graph(indexed);
  const Weighted_sites sites = random_sites(tm, 1 + random.index(5), 0., random);
  std::vector<Face_location> points;
  for(const face_descriptor f : faces(tm))
  {
    const double a = random.uniform(0., 1.), b = random.uniform(0., 1. - a);
    points.emplace_back(f, std::array<double, 3>{a, b, 1. - a - b});
  }
  check_diagram(tm, sites, points);
}

// Meshes on which diagrams of former versions were wrong, with sites at vertices and in a face.
void cells_in_caps_and_at_equal_points_are_certified()
{
  {
    // Close to a site, distances are smaller than the rounding of abscissas on the edge of a face without height.
    test_support::Scope scope("cells in a flat cap");
    const Mesh tm = load_data("cells_in_flat_cap");
    Voronoi diagram(tm);
    diagram.add_site(vertex(11));
    diagram.add_site(vertex(8));
    diagram.add_site(Face_location(face(16), {0.15908345952465353, 0, 0.84091654047534647}));
    CHECK(SMG::certify_geodesic_Voronoi_diagram(diagram).is_certified());
  }
  {
    // Sites at different vertices with the same point: arcs between them lie in faces without area.
    test_support::Scope scope("sites at one point");
    const Mesh tm = load_data("sites_at_one_point");
    Voronoi diagram(tm);
    diagram.add_site(vertex(8));
    diagram.add_site(Face_location(face(21), {0.41494522565178216, 0.0084301875672685694, 0.5766245867809493}));
    diagram.add_site(vertex(6));
    diagram.add_site(vertex(10));
    CHECK(SMG::certify_geodesic_Voronoi_diagram(diagram).is_certified());
  }
}

} // namespace

int main()
{
  cells_in_caps_and_at_equal_points_are_certified();

  a_face_without_area_beside_a_site_is_divided();
  points_near_an_edge_have_the_nearest_site();
  const std::uint64_t seed = test_support::announce_seed(20261121);
  for(std::uint64_t i = 0; i < 400; ++i)
  {
    grids_with_equal_points_are_divided(seed + i);
  }
  std::cout << number_of_points << " points" << std::endl;
  return test_result();
}
