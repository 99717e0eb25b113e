// Paths on surfaces in space whose distances are known by hand: cubes, saddles, cones, regular polyhedra.

#include "path_test_helpers.h"
#include "surface_points.h"
#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

const double tolerance = 1e-12;

// --- the cube, by rolling it over a plane ---

// Rolls the cube in all ways with at most three turns. Where the face of q comes to lie on the plane, which holds p,
// the distance of p and q is a candidate for the shortest one.
void find_shortest_by_rolling(Coordinates q, std::vector<Coordinates> centers, double x, double y,
                              const Coordinates& p, double& best)
{
  if(std::abs(q[2]) < 1e-14)
  {
    best = (std::min)(best, length(q - p));
  }
  if(centers.size() == 4)
  {
    return;
  }
  // `centers` are the centers of the faces that have lain on the plane. They move with the cube.
  for(std::size_t direction = 0; direction < 4; ++direction)
  {
    auto turn = [&](const Coordinates& c) -> Coordinates
    {
      switch(direction)
      {
      case 0:
        return {x + 1. + c[2], c[1], x + 1. - c[0]};
      case 1:
        return {x - c[2], c[1], c[0] - x};
      case 2:
        return {c[0], y + 1. + c[2], y + 1. - c[1]};
      default:
        return {c[0], y - c[2], c[1] - y};
      }
    };
    const double dx = direction == 0 ? 1. : direction == 1 ? -1. : 0.;
    const double dy = direction == 2 ? 1. : direction == 3 ? -1. : 0.;
    std::vector<Coordinates> carried;
    bool comes_back = false;
    for(const Coordinates& c : centers)
    {
      carried.push_back(turn(c));
      comes_back = comes_back || std::abs(carried.back()[2]) < 1e-14;
    }
    if(comes_back)
    {
      continue;
    }
    carried.push_back({x + dx + .5, y + dy + .5, 0.});
    find_shortest_by_rolling(turn(q), carried, x + dx, y + dy, p, best);
  }
}

double cube_distance(const Coordinates& p, const Coordinates& q)
{
  double best = infinity;
  for(std::size_t axis = 0; axis < 3; ++axis)
  {
    for(const double side : {0., 1.})
    {
      if(std::abs(p[axis] - side) > 1e-14)
      {
        continue;
      }
      // Turns the cube so that this face is at the bottom. It may be reflected too, which changes no distance.
      auto turned = [axis, side](Coordinates c) -> Coordinates
      {
        std::swap(c[axis], c[2]);
        c[2] = std::abs(c[2] - side);
        return c;
      };
      find_shortest_by_rolling(turned(q), {{.5, .5, 0.}}, 0., 0., turned(p), best);
    }
  }
  return best;
}

void distances_on_a_cube_are_those_of_the_rolled_cube(test_support::Random& random)
{
  CHECK_CLOSE(cube_distance({0., 0., 0.}, {1., 1., 1.}), std::sqrt(5.), tolerance);
  CHECK_CLOSE(cube_distance({.5, .5, 0.}, {.5, .5, 1.}), 2., tolerance);
  CHECK_CLOSE(cube_distance({.5, 0., .5}, {1., .5, .5}), 1., tolerance);
  Indexed_mesh indexed = to_indexed_mesh(load_data("cube"), "cube");
  for(std::size_t round = 0; round < 3; ++round)
  {
    test_support::Scope scope("cube, subdivided " + std::to_string(round) + " times");
    const Mesh tm = to_face_graph(indexed);
    Geodesic_paths paths(tm);
    for(std::size_t i = 0; i < 60; ++i)
    {
      const std::vector<Surface_point> spot = random_spot(tm, random);
      const Surface_point source = spot[random.index(spot.size())];
      paths.remove_all_source_points();
      add(paths, source);
      for(std::size_t j = 0; j < 12; ++j)
      {
        const std::vector<Surface_point> other = random_spot(tm, random);
        const Surface_point query = other[random.index(other.size())];
        CHECK_NEAR(ask(paths, query).distance, cube_distance(position(source, tm), position(query, tm)), tolerance);
        checked_path(paths, query, tm, 1.);
      }
    }
    indexed = midpoint_subdivision(indexed);
  }
}

void corners_of_a_cube_have_known_distances()
{
  test_support::Scope scope("corners of a cube");
  const Mesh tm = load_data("cube");
  Geodesic_paths paths(tm);
  const std::vector<double> expected{
    0., 1., 1., std::sqrt(2.), 1., std::sqrt(2.), std::sqrt(2.), std::sqrt(5.)};
  for(const Surface_point& source : at_vertex(0, tm))
  {
    paths.remove_all_source_points();
    add(paths, source);
    check_paths_of_vertices(paths, tm, expected, 1., tolerance);
  }
}

// --- other surfaces ---

// Congruent triangles around a vertex, with a total angle of more than a full turn. Unfolded around the vertex, the rim
// is a part of a regular polygon. The path is a chord, or passes the vertex if both angles there are at least pi.
void paths_on_a_saddle_are_chords_or_pass_its_vertex()
{
  for(const double z : {.1, .3, .7})
  {
    for(const std::size_t n : {6u, 8u, 10u, 16u})
    {
      test_support::Scope scope("saddle vertex, " + std::to_string(n) + " faces, z " + std::to_string(z));
      const Mesh tm = to_face_graph(fan("saddle", n, z, -z));
      const double radius = std::sqrt(1. + z * z);
      const double angle = 2. * std::asin(std::hypot(std::sin(pi / static_cast<double>(n)), z) / radius);
      CHECK(angle * static_cast<double>(n) > 2. * pi);
      Geodesic_paths paths(tm);
      paths.add_source_point(vertex(1));
      for(std::size_t i = 0; i < n; ++i)
      {
        const std::size_t steps = (std::min)(i, n - i);
        const double turn = angle * static_cast<double>(steps);
        const Surface_point query(vertex(1 + i));
        CHECK_CLOSE(ask(paths, query).distance, 2. * radius * (turn < pi ? std::sin(turn / 2.) : 1.), tolerance);
        const auto points = checked_path(paths, query, tm, radius);
        CHECK_EQUAL(points.size(), turn < pi ? steps + 1 : 3u);
        CHECK_EQUAL(std::count(points.begin(), points.end(), Coordinates{0., 0., 0.}), turn < pi ? 0 : 1);
      }
    }
  }
}

void corners_of_a_tetrahedron_have_known_distances()
{
  test_support::Scope scope("tetra");
  const Mesh tm = load_data("tetra");
  Geodesic_paths paths(tm);
  add(paths, Surface_point(Face_location(face(0), {1. / 3., 1. / 3., 1. / 3.})));
  const double d = std::sqrt(8. / 3.);
  check_paths_of_vertices(paths, tm, {d, d, d, 2. * d}, 3., tolerance);
}

void sources_given_twice_or_together_are_exact_on_an_octahedron()
{
  test_support::Scope scope("octahedron");
  const Mesh tm = load_data("octahedron");
  Geodesic_paths single(tm);
  single.add_source_point(vertex(0));
  CHECK_CLOSE(ask(single, Surface_point(vertex(1))).distance, std::sqrt(6.), tolerance);
  Geodesic_paths twice(tm);
  twice.add_source_point(vertex(0));
  for(const Surface_point& same : at_vertex(0, tm))
  {
    add(twice, same);
  }
  Geodesic_paths three(tm);
  const std::vector<vertex_descriptor> sources{vertex(0), vertex(2), vertex(4)};
  const auto first = three.add_source_points(sources.begin(), sources.end());
  CHECK(first == three.source_points_begin());
  for(std::size_t v = 0; v < 6; ++v)
  {
    CHECK_EQUAL(ask(twice, Surface_point(vertex(v))).distance, ask(single, Surface_point(vertex(v))).distance);
    CHECK_EQUAL(ask(twice, Surface_point(vertex(v))).source, 0u);
    checked_path(twice, Surface_point(vertex(v)), tm, 1.);
    CHECK_CLOSE(ask(three, Surface_point(vertex(v))).distance, v % 2 == 0 ? 0. : std::sqrt(2.), tolerance);
    checked_path(three, Surface_point(vertex(v)), tm, 1.);
  }
}

void paths_bend_at_the_corner_of_an_L()
{
  test_support::Scope scope("L_shape");
  const Mesh tm = load_data("L_shape");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(7));
  const auto points = checked_path(paths, Surface_point(vertex(2)), tm, 2.);
  CHECK_CLOSE(polyline_length(points), 1. + std::sqrt(2.), tolerance);
  CHECK(std::find(points.begin(), points.end(), coordinates(vertex(4), tm)) != points.end());
}

void paths_in_a_saddle_fan_bend_at_its_center()
{
  test_support::Scope scope("saddle_fan8");
  const Mesh tm = load_data("saddle_fan8");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(1));
  for(std::size_t v = 0; v < 9; ++v)
  {
    const double expected = v == 0 ? 1. : v == 1 ? 0. : v == 2 || v == 8 ? 1.6645969834 : 2.;
    CHECK_CLOSE(ask(paths, Surface_point(vertex(v))).distance, expected, 1e-10);
    const auto points = checked_path(paths, Surface_point(vertex(v)), tm, 1.);
    if(expected == 2.)
    {
      CHECK_EQUAL(points.size(), 3u);
    }
  }
}

void paths_around_a_cone_unroll()
{
  test_support::Scope scope("cone64");
  const Mesh tm = load_data("cone64");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(1));
  const double r2 = std::sqrt(2.);
  const double sector = 2. * std::asin(std::sin(pi / 64.) / r2);
  for(std::size_t i = 0; i < 64; ++i)
  {
    const std::size_t steps = (std::min)(i, 64 - i);
    CHECK_CLOSE(ask(paths, Surface_point(vertex(1 + i))).distance,
                2. * r2 * std::sin(.5 * sector * static_cast<double>(steps)), tolerance);
    CHECK_EQUAL(checked_path(paths, Surface_point(vertex(1 + i)), tm, r2).size(), 1 + steps);
  }
  // along a line through the apex of the cone, as a location in either face
  for(const double t : {.25, .5})
  {
    for(const Surface_point query : on_edge(17, 0, t, tm))
    {
      const double a = 16. * sector, r = r2 * (1. - t);
      CHECK_CLOSE(ask(paths, query).distance, std::sqrt(2. + r * r - 2. * r2 * r * std::cos(a)), tolerance);
      checked_path(paths, query, tm, r2);
    }
  }
}

void paths_pass_a_pinched_vertex()
{
  test_support::Scope scope("pinched_vertex");
  const Mesh tm = load_data("pinched_vertex");
  const double r2 = std::sqrt(2.);
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(2));
  const std::vector<double> expected{r2, 1., 0., 1. + r2, 2. * r2};
  check_paths_of_vertices(paths, tm, expected, 1., tolerance);
  for(const face_descriptor f : faces(tm))
  {
    checked_path(paths, Surface_point(Face_location(f, {.25, .25, .5})), tm, 1.);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260402);
  test_support::Random random(seed);
  distances_on_a_cube_are_those_of_the_rolled_cube(random);
  corners_of_a_cube_have_known_distances();
  paths_on_a_saddle_are_chords_or_pass_its_vertex();
  corners_of_a_tetrahedron_have_known_distances();
  sources_given_twice_or_together_are_exact_on_an_octahedron();
  paths_bend_at_the_corner_of_an_L();
  paths_in_a_saddle_fan_bend_at_its_center();
  paths_around_a_cone_unroll();
  paths_pass_a_pinched_vertex();
  return test_result();
}
