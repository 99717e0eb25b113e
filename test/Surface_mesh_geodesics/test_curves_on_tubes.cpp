// Distances from oblique curves on tubes of plane sides, which unfold: in the development, a straight curve has a copy
// for each turn around the tube, and the distance of a point is that to the nearest copy.

#include "curves_in_plane.h"
#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace curve_cases;
using test_meshes::pi;

namespace {

// The heights of the vertices on each of the lines between the sides, by line and ring. Sides have the width 1.
using Heights = std::vector<std::vector<double>>;

Heights random_heights(std::size_t sides, std::size_t rings, test_support::Random& random)
{
  Heights heights(sides);
  for(std::vector<double>& line : heights)
    for(std::size_t k = 0; k < rings; ++k)
      line.push_back(static_cast<double>(k) + (k > 0 && k + 1 < rings ? random.uniform(-.4, .4) : 0.));
  return heights;
}

// Adds the faces between two lines of vertices.
void add_side(std::size_t line, std::size_t next_line, std::size_t rings, Indexed_mesh& mesh)
{
  for(std::size_t k = 0; k + 1 < rings; ++k)
    add_quadrilateral(mesh, line * rings + k, next_line * rings + k, next_line * rings + k + 1, line * rings + k + 1,
                      (line + k) % 2 == 0);
}

Indexed_mesh in_space(const Heights& heights)
{
  const std::size_t n = heights.size();
  const double turn = 2 * pi / static_cast<double>(n), radius = .5 / std::sin(turn / 2);
  Indexed_mesh mesh;
  mesh.name = "tube";
  for(std::size_t i = 0; i < n; ++i)
    for(const double z : heights[i])
      mesh.points.push_back({radius * std::cos(turn * static_cast<double>(i)),
                             radius * std::sin(turn * static_cast<double>(i)), z});
  for(std::size_t i = 0; i < n; ++i)
    add_side(i, (i + 1) % n, heights[i].size(), mesh);
  return mesh;
}

// The development, cut along the first line, whose vertices come a second time. Its faces are those of the tube.
Indexed_mesh developed(const Heights& heights)
{
  const std::size_t n = heights.size();
  Indexed_mesh mesh;
  mesh.name = "development of a tube";
  for(std::size_t i = 0; i <= n; ++i)
    for(const double z : heights[i % n])
      mesh.points.push_back({static_cast<double>(i), z, 0});
  for(std::size_t i = 0; i < n; ++i)
    add_side(i, i + 1, heights[i % n].size(), mesh);
  return mesh;
}

void test_tube(std::size_t sides, std::size_t rings, test_support::Random& random)
{
  const Heights heights = random_heights(sides, rings, random);
  const Mesh tm = to_face_graph(in_space(heights)), plane = to_face_graph(developed(heights));
  const double perimeter = static_cast<double>(sides), height = static_cast<double>(rings - 1);
  for(int trial = 0; trial < 6; ++trial)
  {
    const Point_2 a{random.uniform(.01, .99) * perimeter, random.uniform(.01, .99) * height};
    const Point_2 b{random.uniform(.01, .99) * perimeter, random.uniform(.01, .99) * height};
    const Distances d = distances(tm, {Curve(tm, segment_in_plane(plane, a, b))});
    for(std::size_t i = 0; i < sides; ++i)
      for(std::size_t k = 0; k < rings; ++k)
      {
        double expected = infinity;
        for(const double shift : {-perimeter, 0., perimeter})
          expected = (std::min)(expected, distance_to_segment({static_cast<double>(i) + shift, heights[i][k]}, a, b));
        CHECK_NEAR(d.at(vertex_descriptor(static_cast<Mesh::size_type>(i * rings + k))), expected, 1e-13 * perimeter);
      }
  }
}

} // namespace

int main()
{
  test_support::Random random(20261127);
  for(const std::size_t sides : {std::size_t(3), std::size_t(8), std::size_t(25)})
    for(const std::size_t rings : {std::size_t(2), std::size_t(5), std::size_t(14)})
    {
      const test_support::Scope scope(std::to_string(sides) + " sides, " + std::to_string(rings) + " rings");
      for(int i = 0; i < 3; ++i)
        test_tube(sides, rings, random);
    }
  return test_result();
}
