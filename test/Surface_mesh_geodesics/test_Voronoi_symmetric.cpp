// On symmetric surfaces with symmetric sites, arcs run along edges and meet in corners, in the middles of edges and of
// faces. The tests locate these points, and points very close to them, with and without weights.

#include "Voronoi_test_helpers.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <vector>

using namespace test_meshes;

namespace {

std::size_t number_of_points = 0;

// Barycentric coordinates of middles, quarters and corners, and of points next to them.
std::vector<std::array<double, 3>> special_coordinates()
{
  std::vector<std::array<double, 3>> result;
  for(const std::array<double, 3>& b :
      {std::array<double, 3>{1., 1., 1.}, {2., 1., 1.}, {1., 1., 0.}, {3., 1., 0.}, {1., 3., 0.}, {1., 0., 0.},
       {5., 2., 1.}})
  {
    for(std::size_t k = 0; k < 3; ++k)
    {
      for(const double shift : {0., 1e-9, 1e-11})
      {
        const double sum = b[0] + b[1] + b[2] + 2. * shift;
        result.push_back({(b[k] + 2. * shift) / sum, b[(k + 1) % 3] / sum, b[(k + 2) % 3] / sum});
      }
    }
  }
  return result;
}

void check_sites(const Mesh& tm, const Weighted_sites& sites)
{
  Voronoi diagram(tm);
  add_sites(diagram, sites);
  Distances_of_sites distances(tm, sites);
  for(const face_descriptor f : faces(tm))
  {
    for(const std::array<double, 3>& b : special_coordinates())
    {
      const Face_location q{f, {b[0], b[1], b[2]}};
      const std::vector<double> all = distances.all(Surface_point(q));
      const double nearest = *std::min_element(all.begin(), all.end());
      const std::size_t site = diagram.nearest_site(q);
      test_support::Scope scope(description(Surface_point(q)));
      CHECK(site < all.size() && all[site] - nearest <= 1e-11);
      CHECK_NEAR(diagram.distance_to_nearest_site(q), nearest, 1e-11);
      ++number_of_points;
    }
  }
}

void special_points_have_the_nearest_site(const Indexed_mesh& indexed, double weight)
{
  const Mesh tm = to_face_graph(indexed);
  for(const std::size_t step : {1u, 2u, 3u, 5u})
  {
    for(std::size_t first = 0; first < (std::min)(step, std::size_t(2)); ++first)
    {
      test_support::Scope scope(indexed.name + ", each of " + std::to_string(step) + " vertices, from "
                                + std::to_string(first) + ", weight " + std::to_string(weight));
      Weighted_sites sites;
      for(std::size_t v = first; v < num_vertices(tm); v += step)
      {
        sites.emplace_back(vertex_descriptor(static_cast<Mesh::size_type>(v)), sites.size() % 2 == 0 ? 0. : weight);
      }
      check_sites(tm, sites);
    }
  }
}

// Two sites at opposite points of a sphere have one closed edge and congruent cells.
void antipodal_sites_have_congruent_cells()
{
  test_support::Scope scope("antipodal sites");
  const Mesh tm = to_face_graph(icosphere(3));
  const vertex_descriptor first(0);
  const auto gap = [&](vertex_descriptor v) { return CGAL::squared_distance(tm.point(first), tm.point(v)); };
  const vertex_descriptor last = *std::max_element(vertices(tm).begin(), vertices(tm).end(),
                                                   [&](auto v, auto w) { return gap(v) < gap(w); });
  Voronoi diagram(tm);
  diagram.add_site(first);
  diagram.add_site(last);
  CHECK_EQUAL(diagram.edges().size(), 1u);
  CHECK(diagram.edges()[0].is_closed() && diagram.vertices().empty());
  CHECK_CLOSE(diagram.area(0), diagram.area(1), 1e-11);
  CHECK(diagram.is_disk(0) && diagram.is_disk(1));
}

// Sites at all vertices and at thousands of points in faces. Each site is in its cell, the cells cover the sphere, and
// the diagram has the Euler characteristic of a sphere.
void many_cells_cover_the_sphere()
{
  test_support::Scope scope("many sites");
  const Mesh tm = to_face_graph(noisy_sphere(4, .02, 1));
  double area = 0.;
  for(const face_descriptor f : faces(tm))
  {
    const auto corner = corners_of_face(f, tm);
    const Coordinates p = coordinates(corner[0], tm);
    area += length(cross(coordinates(corner[1], tm) - p, coordinates(corner[2], tm) - p)) / 2.;
  }
  test_support::Random random(11);
  for(const bool is_at_vertices : {true, false})
  {
    Voronoi diagram(tm);
    if(is_at_vertices)
    {
      diagram.add_sites(vertices(tm));
    }
    for(int i = 0; i < 5000 && !is_at_vertices; ++i)
    {
      diagram.add_site(random_location(tm, random));
    }
    double sum = 0.;
    for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
    {
      CHECK_EQUAL(diagram.nearest_site(diagram.site(i)), i);
      CHECK(diagram.is_disk(i));
      sum += diagram.area(i);
    }
    CHECK_CLOSE(sum, area, 1e-10);
    CHECK_EQUAL(static_cast<long>(diagram.vertices().size()) - static_cast<long>(diagram.edges().size())
                  + static_cast<long>(diagram.number_of_sites()), 2);
  }
}

} // namespace

int main()
{
  antipodal_sites_have_congruent_cells();
  many_cells_cover_the_sphere();
  for(const Indexed_mesh& indexed :
      {cube_grid(1), cube_grid(2), cube_grid(3), regular_tetrahedron(), octahedron(), icosahedron(), icosphere(1),
       flat_patch(4, 4, 0., false, 1), genus_2_polycube(), torus(2., 1., 6, 8), square_with_holes(1)})
  {
    for(const double weight : {0., .25})
    {
      special_points_have_the_nearest_site(indexed, weight);
    }
  }
  std::cout << number_of_points << " points" << std::endl;
  return test_result();
}
