// Distances from curves on cones, which unfold: in the development, a straight curve has a copy for each turn around
// the apex, and the distance of a point is that to the nearest copy that it sees past the apex. If the total angle of
// the apex is more than a full turn, some points see none, and their paths lead through the apex.

#include "curves_in_plane.h"
#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using namespace curve_cases;
using test_meshes::pi;

namespace {

// A cone of plane sides around an apex, with rings of vertices on the lines between the sides: the radii of vertices on
// each line, and the angle of a side at the apex.
struct Cone
{
  std::vector<std::vector<double>> radii; // by line and ring
  double angle_of_side;

  std::size_t number_of_sides() const { return radii.size(); }
  double total_angle() const { return angle_of_side * static_cast<double>(number_of_sides()); }
};

Cone random_cone(std::size_t sides, std::size_t rings, double total_angle, test_support::Random& random)
{
  Cone cone;
  cone.angle_of_side = total_angle / static_cast<double>(sides);
  for(std::size_t i = 0; i < sides; ++i)
  {
    cone.radii.emplace_back();
    for(std::size_t k = 1; k <= rings; ++k)
      cone.radii.back().push_back((static_cast<double>(k) + (k < rings ? random.uniform(-.4, .4) : 0.))
                                  / static_cast<double>(rings));
  }
  return cone;
}

// The vertices of line i, at the given direction from the apex, behind those of the lines before it.
void add_line(const std::vector<double>& radii, const Coordinates& direction, Indexed_mesh& mesh)
{
  for(const double r : radii)
    mesh.points.push_back({r * direction[0], r * direction[1], r * direction[2]});
}

// The faces between two lines. The apex is vertex 0.
void add_side(std::size_t line, std::size_t next_line, std::size_t rings, Indexed_mesh& mesh)
{
  const std::size_t a = 1 + line * rings, b = 1 + next_line * rings;
  mesh.faces.push_back({0, a, b});
  for(std::size_t k = 0; k + 1 < rings; ++k)
    add_quadrilateral(mesh, a + k, a + k + 1, b + k + 1, b + k, k % 2 == 0);
}

// Lines go down from the apex; or down and up in turn, if the sides are wider than their part of a full turn.
Indexed_mesh in_space(const Cone& cone)
{
  const std::size_t n = cone.number_of_sides();
  const double turn = 2 * pi / static_cast<double>(n);
  const bool is_saddle = cone.angle_of_side > turn;
  const double s = is_saddle ? std::cos(cone.angle_of_side / 2) / std::cos(turn / 2)
                             : std::sin(cone.angle_of_side / 2) / std::sin(turn / 2);
  Indexed_mesh mesh;
  mesh.name = "cone";
  mesh.points.push_back({0, 0, 0});
  for(std::size_t i = 0; i < n; ++i)
  {
    const double phi = turn * static_cast<double>(i), z = std::sqrt(1 - s * s);
    add_line(cone.radii[i], {s * std::cos(phi), s * std::sin(phi), is_saddle && i % 2 == 1 ? z : -z}, mesh);
  }
  for(std::size_t i = 0; i < n; ++i)
    add_side(i, (i + 1) % n, cone.radii[i].size(), mesh);
  return mesh;
}

// The development, cut along the first line, whose vertices come a second time. Its faces are those of the cone.
Indexed_mesh developed(const Cone& cone)
{
  const std::size_t n = cone.number_of_sides();
  Indexed_mesh mesh;
  mesh.name = "development of a cone";
  mesh.points.push_back({0, 0, 0});
  for(std::size_t i = 0; i <= n; ++i)
  {
    const double phi = cone.angle_of_side * static_cast<double>(i);
    add_line(cone.radii[i % n], {std::cos(phi), std::sin(phi), 0}, mesh);
  }
  for(std::size_t i = 0; i < n; ++i)
    add_side(i, i + 1, cone.radii[i].size(), mesh);
  return mesh;
}

struct Polar
{
  double radius, angle;

  Point_2 cartesian() const { return {radius * std::cos(angle), radius * std::sin(angle)}; }
};

// Requires: the ends of the segment differ by less than .3 pi in their angles, and have the same angle if the total
// angle is more than a full turn. A copy that turns by pi or more from the point is hidden behind the apex; then
// another copy is nearer, or the way through the apex.
double distance_on_cone(const Polar& p, const Polar& a, const Polar& b, double total_angle)
{
  double d = p.radius + distance_to_segment({0, 0}, a.cartesian(), b.cartesian());
  for(int k = -8; k <= 8; ++k)
  {
    const Polar first{a.radius, a.angle + k * total_angle}, last{b.radius, b.angle + k * total_angle};
    if(std::abs(first.angle - p.angle) < pi && std::abs(last.angle - p.angle) < pi)
      d = (std::min)(d, distance_to_segment(p.cartesian(), first.cartesian(), last.cartesian()));
  }
  return d;
}

void test_cone(std::size_t sides, std::size_t rings, double total_angle, test_support::Random& random)
{
  const Cone cone = random_cone(sides, rings, total_angle, random);
  const Mesh tm = to_face_graph(in_space(cone)), plane = to_face_graph(developed(cone));
  for(int trial = 0; trial < 6; ++trial)
  {
    const double width = random.uniform(0., (std::min)(.3 * pi, .9 * total_angle));
    const double angle = random.uniform(0., total_angle - width);
    // Inside the rim, which is at least as far from the apex as the middle of a side.
    const double rim = std::cos(cone.angle_of_side / 2);
    const Polar a{random.uniform(.05, .95) * rim, angle}, b{random.uniform(.05, .95) * rim, angle + width};
    const Distances d = distances(tm, {Curve(tm, segment_in_plane(plane, a.cartesian(), b.cartesian()))});
    CHECK_NEAR(d.at(vertex_descriptor(0)), distance_to_segment({0, 0}, a.cartesian(), b.cartesian()), 1e-13);
    for(std::size_t i = 0; i < sides; ++i)
      for(std::size_t k = 0; k < rings; ++k)
      {
        const vertex_descriptor v(static_cast<Mesh::size_type>(1 + i * rings + k));
        const Polar p{cone.radii[i][k], cone.angle_of_side * static_cast<double>(i)};
        CHECK_NEAR(d.at(v), distance_on_cone(p, a, b, total_angle), 1e-13);
      }
  }
}

// The curve is a part of the first line, so that it needs no development.
void test_saddle(std::size_t sides, std::size_t rings, double total_angle, test_support::Random& random)
{
  const Cone cone = random_cone(sides, rings, total_angle, random);
  const Mesh tm = to_face_graph(in_space(cone));
  const std::size_t first = random.index(rings), last = first + random.index(rings - first);
  std::vector<vertex_descriptor> vertices_of_curve;
  for(std::size_t k = first; k <= last; ++k)
    vertices_of_curve.emplace_back(static_cast<Mesh::size_type>(1 + k));
  const Polar a{cone.radii[0][first], 0}, b{cone.radii[0][last], 0};
  const Distances d = distances(tm, {Curve(tm, vertices_of_curve, false)});
  std::size_t through_apex = 0;
  for(std::size_t i = 0; i < sides; ++i)
    for(std::size_t k = 0; k < rings; ++k)
    {
      const vertex_descriptor v(static_cast<Mesh::size_type>(1 + i * rings + k));
      const Polar p{cone.radii[i][k], cone.angle_of_side * static_cast<double>(i)};
      CHECK_NEAR(d.at(v), distance_on_cone(p, a, b, total_angle), 1e-13);
      through_apex += p.angle >= pi && total_angle - p.angle >= pi;
    }
  CHECK(through_apex > 0);
}

} // namespace

int main()
{
  test_support::Random random(20261126);
  for(const double total_angle : {.3 * pi, .8 * pi, 1.3 * pi})
    for(const std::size_t sides : {std::size_t(5), std::size_t(9), std::size_t(24)})
      for(const std::size_t rings : {std::size_t(1), std::size_t(4), std::size_t(11)})
      {
        const test_support::Scope scope(std::to_string(total_angle) + ", " + std::to_string(sides) + " sides, "
                                        + std::to_string(rings) + " rings");
        test_cone(sides, rings, total_angle, random);
      }
  for(const double total_angle : {2.3 * pi, 3.2 * pi})
    for(const std::size_t sides : {std::size_t(8), std::size_t(20)})
      for(const std::size_t rings : {std::size_t(1), std::size_t(5), std::size_t(11)})
        for(int trial = 0; trial < 4; ++trial)
        {
          const test_support::Scope scope(std::to_string(total_angle) + ", " + std::to_string(sides) + " sides, "
                                          + std::to_string(rings) + " rings");
          test_saddle(sides, rings, total_angle, random);
        }
  return test_result();
}
