// The colors of the cells of a Voronoi diagram: adjacent cells have different colors.

#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_cell_colors.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/drawing/Cell_coloring.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

using namespace test_meshes;
namespace Geodesics = CGAL::Surface_mesh_geodesics;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
using Neighbors = Geodesics::internal::Neighbors_of_cells;

void connect(Neighbors& neighbors, std::size_t i, std::size_t j)
{
  neighbors[i].push_back(j);
  neighbors[j].push_back(i);
}

std::size_t number_of_conflicts(const Neighbors& neighbors, const std::vector<std::size_t>& color)
{
  std::size_t n = 0;
  for(std::size_t i = 0; i < neighbors.size(); ++i)
    for(const std::size_t j : neighbors[i])
      n += i < j && color[i] == color[j] ? 1 : 0;
  return n;
}

// how often each color is used
std::vector<std::size_t> uses(const std::vector<std::size_t>& color, std::size_t number_of_colors)
{
  std::vector<std::size_t> result(number_of_colors, 0);
  for(const std::size_t c : color)
    ++result.at(c);
  return result;
}

void no_cells_need_no_color()
{
  CHECK(Geodesics::internal::coloring({}, 12).empty());
}

// Three colors are enough for a hub with an even ring around it, in any order of the cells.
void three_colors_are_enough_for_a_wheel()
{
  const std::size_t n = 40;
  for(const std::size_t hub : {std::size_t(0), n / 2, n})
  {
    Neighbors neighbors(n + 1);
    std::vector<std::size_t> rim;
    for(std::size_t i = 0; i <= n; ++i)
      if(i != hub)
        rim.push_back(i);
    for(std::size_t i = 0; i < n; ++i)
    {
      connect(neighbors, hub, rim[i]);
      connect(neighbors, rim[i], rim[(i + 1) % n]);
    }
    CHECK_EQUAL(number_of_conflicts(neighbors, Geodesics::internal::coloring(neighbors, 4)), std::size_t(0));
    // all colors are used about equally often
    const std::vector<std::size_t> number = uses(Geodesics::internal::coloring(neighbors, 12), 12);
    CHECK(*std::min_element(number.begin(), number.end()) >= 1);
    CHECK(*std::max_element(number.begin(), number.end()) <= 6);
  }
}

// Each cell touches every other cell. If one color is missing, there is one conflict.
void one_missing_color_makes_one_conflict()
{
  for(const std::size_t n : {std::size_t(12), std::size_t(13)})
  {
    Neighbors neighbors(n);
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t j = 0; j < i; ++j)
        connect(neighbors, i, j);
    CHECK_EQUAL(number_of_conflicts(neighbors, Geodesics::internal::coloring(neighbors, 12)), n - 12);
  }
}

void adjacent_cells_have_different_colors(std::size_t number_of_sites)
{
  const Mesh mesh = to_face_graph(noisy_sphere(3, .02, 8));
  Voronoi voronoi(mesh);
  const std::size_t step = mesh.number_of_faces() / number_of_sites;
  for(std::size_t i = 0; i < number_of_sites; ++i)
    voronoi.add_site(Voronoi::Face_location(face_descriptor(static_cast<Mesh::size_type>(step * i)), {.2, .3, .5}));
  const std::vector<CGAL::IO::Color> color = Geodesics::geodesic_Voronoi_cell_colors(voronoi);
  CHECK_EQUAL(color.size(), number_of_sites);
  std::size_t number_of_pairs = 0;
  for(std::size_t i = 0; i < number_of_sites; ++i)
    for(const std::size_t j : voronoi.adjacent_sites(i))
    {
      ++number_of_pairs;
      CHECK(!(color[i] == color[j]));
    }
  CHECK(number_of_pairs >= 2 * number_of_sites);
  for(std::size_t i = 0; number_of_sites <= 12 && i < number_of_sites; ++i)
    for(std::size_t j = 0; j < i; ++j)
      CHECK(!(color[i] == color[j]));
  CHECK(color == Geodesics::geodesic_Voronoi_cell_colors(voronoi));
}

} // namespace

int main()
{
  no_cells_need_no_color();
  three_colors_are_enough_for_a_wheel();
  one_missing_color_makes_one_conflict();
  adjacent_cells_have_different_colors(12);
  adjacent_cells_have_different_colors(80);
  return test_result();
}
