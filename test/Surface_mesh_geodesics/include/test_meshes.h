#ifndef SURFACE_MESH_GEODESICS_TEST_MESHES_H
#define SURFACE_MESH_GEODESICS_TEST_MESHES_H

// The meshes of the tests: polyhedra, spheres, tubes, patches and fans, all computed, and two collections of them.
// Types and conversions are in Indexed_mesh.h.

#include "Indexed_mesh.h"
#include "mesh_operations.h"
#include "meshes_of_cells.h"
#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

inline Indexed_mesh irregular_tetrahedron()
{
  return {"irregular tetrahedron",
          {{0, 0, 0}, {1, 0, 0}, {.2, .8, 0}, {.3, .4, 1.3}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

inline Indexed_mesh regular_tetrahedron()
{
  return {"regular tetrahedron",
          {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

inline Indexed_mesh octahedron()
{
  return {"octahedron",
          {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

inline Indexed_mesh icosahedron()
{
  const double a = (1. + std::sqrt(5.)) / 2.;
  return {"icosahedron",
          {{-1, a, 0}, {1, a, 0}, {-1, -a, 0}, {1, -a, 0}, {0, -1, a}, {0, 1, a},
           {0, -1, -a}, {0, 1, -a}, {a, 0, -1}, {a, 0, 1}, {-a, 0, -1}, {-a, 0, 1}},
          {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8},
           {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}}};
}

inline Indexed_mesh icosphere(std::size_t subdivisions)
{
  Indexed_mesh mesh = midpoint_subdivision(icosahedron(), subdivisions);
  return transformed(mesh, "icosphere " + std::to_string(subdivisions),
                     [](const Coordinates& p) { return (1. / length(p)) * p; });
}

inline Indexed_mesh noisy_sphere(std::size_t subdivisions, double noise, std::uint64_t seed)
{
  test_support::Random random(seed);
  return transformed(icosphere(subdivisions), "noisy sphere",
                     [&](const Coordinates& p) { return (1. + random.uniform(-noise, noise)) * p; });
}

inline Indexed_mesh torus(double major_radius, double minor_radius, std::size_t m, std::size_t n)
{
  Indexed_mesh mesh;
  mesh.name = "torus";
  for(std::size_t i = 0; i < m; ++i)
  {
    const double u = 2. * pi * static_cast<double>(i) / static_cast<double>(m);
    for(std::size_t j = 0; j < n; ++j)
    {
      const double v = 2. * pi * static_cast<double>(j) / static_cast<double>(n);
      const double r = major_radius + minor_radius * std::cos(v);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), minor_radius * std::sin(v)});
    }
  }
  auto id = [m, n](std::size_t i, std::size_t j) { return (i % m) * n + j % n; };
  for(std::size_t i = 0; i < m; ++i)
  {
    for(std::size_t j = 0; j < n; ++j)
    {
      add_quadrilateral(mesh, id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
    }
  }
  return mesh;
}

// A tube of m columns around and n rows. point(i, j) returns the vertex in column i, row j.
template <class Point_of_column_and_row>
Indexed_mesh open_tube(const std::string& name, std::size_t m, std::size_t n, const Point_of_column_and_row& point)
{
  Indexed_mesh mesh;
  mesh.name = name;
  for(std::size_t j = 0; j <= n; ++j)
  {
    for(std::size_t i = 0; i < m; ++i)
    {
      mesh.points.push_back(point(i, j));
    }
  }
  auto id = [m](std::size_t i, std::size_t j) { return j * m + i % m; };
  for(std::size_t j = 0; j < n; ++j)
  {
    for(std::size_t i = 0; i < m; ++i)
    {
      add_quadrilateral(mesh, id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
    }
  }
  return mesh;
}

inline Indexed_mesh wavy_tube(std::size_t m, std::size_t n)
{
  return open_tube("wavy tube", m, n, [m, n](std::size_t i, std::size_t j) {
    const double s = 2. * pi * static_cast<double>(i) / static_cast<double>(m);
    const double z = 6. * static_cast<double>(j) / static_cast<double>(n);
    const double r = 1. + .25 * std::sin(3. * z) + .1 * std::cos(5. * s + z);
    return Coordinates{r * std::cos(s), r * std::sin(s), z};
  });
}

// An open prism with m sides. A twist turns its long faces into needles.
inline Indexed_mesh prism_tube(std::size_t m, std::size_t n, double radius, double height, double twist = 0.)
{
  return open_tube("prism tube", m, n, [=](std::size_t i, std::size_t j) {
    const double t = static_cast<double>(j) / static_cast<double>(n);
    const double s = 2. * pi * static_cast<double>(i) / static_cast<double>(m) + twist * t;
    return Coordinates{radius * std::cos(s), radius * std::sin(s), height * t};
  });
}

inline Indexed_mesh Schwarz_lantern(std::size_t m, std::size_t n)
{
  return open_tube("Schwarz lantern " + std::to_string(m) + "x" + std::to_string(n), m, n,
                   [m, n](std::size_t i, std::size_t j) {
                     // each row is turned by half a column relative to the row below
                     const double s =
                       2. * pi * (static_cast<double>(i) - .5 * static_cast<double>(j)) / static_cast<double>(m);
                     return Coordinates{std::cos(s), std::sin(s),
                                        static_cast<double>(j) / static_cast<double>(n)};
                   });
}

// A grid of (m + 1) x (n + 1) vertices; point(i, j) returns the vertex of index i (n + 1) + j, and diagonal(i, j)
// chooses one of the two diagonals of a cell.
template <class Height, class Diagonal>
Indexed_mesh graph_patch(const std::string& name, std::size_t m, std::size_t n, const Height& point,
                         const Diagonal& diagonal)
{
  Indexed_mesh mesh;
  mesh.name = name;
  for(std::size_t i = 0; i <= m; ++i)
  {
    for(std::size_t j = 0; j <= n; ++j)
    {
      mesh.points.push_back(point(i, j));
    }
  }
  auto id = [n](std::size_t i, std::size_t j) { return i * (n + 1) + j; };
  for(std::size_t i = 0; i < m; ++i)
  {
    for(std::size_t j = 0; j < n; ++j)
    {
      add_quadrilateral(mesh, id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1), diagonal(i, j));
    }
  }
  return mesh;
}

inline Indexed_mesh saddle_patch(std::size_t n)
{
  return graph_patch(
    "saddle z = xy", n, n,
    [n](std::size_t i, std::size_t j) {
      const double x = 2. * static_cast<double>(i) / static_cast<double>(n) - 1.;
      const double y = 2. * static_cast<double>(j) / static_cast<double>(n) - 1.;
      return Coordinates{x, y, x * y};
    },
    [](std::size_t, std::size_t) { return true; });
}

inline Indexed_mesh rough_terrain(std::size_t n, double roughness, std::uint64_t seed)
{
  test_support::Random random(seed);
  return graph_patch(
    "rough terrain", n, n,
    [&](std::size_t i, std::size_t j) {
      return Coordinates{static_cast<double>(i), static_cast<double>(j), random.uniform(0., roughness)};
    },
    [&](std::size_t, std::size_t) { return random.index(2) == 0; });
}

// A flat convex patch. Interior vertices move in the plane by at most `jitter` times the size of a cell; below 1/6 no
// face turns over.
inline Indexed_mesh flat_patch(std::size_t m, std::size_t n, double jitter, bool random_diagonals, std::uint64_t seed)
{
  test_support::Random random(seed);
  return graph_patch(
    "flat patch", m, n,
    [&](std::size_t i, std::size_t j) {
      const bool inside = i > 0 && i < m && j > 0 && j < n;
      const double dx = random.uniform(-jitter, jitter);
      const double dy = random.uniform(-jitter, jitter);
      return Coordinates{static_cast<double>(i) + (inside ? dx : 0.), static_cast<double>(j) + (inside ? dy : 0.),
                         0.};
    },
    [&](std::size_t, std::size_t) { return !random_diagonals || random.index(2) == 0; });
}

// A sphere with m meridians and n parallels. Many meridians make needles, and caps at the poles.
inline Indexed_mesh needle_sphere(std::size_t m, std::size_t n)
{
  Indexed_mesh mesh;
  mesh.name = "needle sphere";
  mesh.points.push_back({0, 0, 1});
  for(std::size_t j = 1; j <= n; ++j)
  {
    const double t = pi * static_cast<double>(j) / static_cast<double>(n + 1);
    for(std::size_t i = 0; i < m; ++i)
    {
      const double s = 2. * pi * static_cast<double>(i) / static_cast<double>(m);
      mesh.points.push_back({std::sin(t) * std::cos(s), std::sin(t) * std::sin(s), std::cos(t)});
    }
  }
  mesh.points.push_back({0, 0, -1});
  const std::size_t south = mesh.points.size() - 1;
  auto id = [m](std::size_t i, std::size_t j) { return 1 + j * m + i % m; };
  for(std::size_t i = 0; i < m; ++i)
  {
    mesh.faces.push_back({0, id(i, 0), id(i + 1, 0)});
    for(std::size_t j = 0; j + 1 < n; ++j)
    {
      add_quadrilateral(mesh, id(i, j), id(i, j + 1), id(i + 1, j + 1), id(i + 1, j));
    }
    mesh.faces.push_back({south, id(i + 1, n - 1), id(i, n - 1)});
  }
  return mesh;
}

// A tetrahedron whose faces are split repeatedly at random points, often close to an edge; some points are pulled far
// out. The result has spikes, needles and caps.
inline Indexed_mesh tetrahedral_ogre(std::size_t splits, std::uint64_t seed)
{
  test_support::Random random(seed);
  Indexed_mesh mesh = irregular_tetrahedron();
  for(std::size_t i = 0; i < splits; ++i)
  {
    const std::size_t face = random.index(mesh.faces.size());
    const Triangle t = mesh.faces[face];
    const double a = random.index(3) == 0 ? random.uniform(1e-3, 1e-2) : random.uniform(.1, .4);
    const double b = random.uniform(.1, .5);
    const Coordinates normal =
      cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
    const double heights[5] = {0., 0., .05, .5, 6.};
    const double height = heights[random.index(5)] / std::sqrt((std::max)(length(normal), 1e-30));
    mesh = with_point_in_face(mesh, face, {a, b, 1. - a - b});
    mesh.points.back() = mesh.points.back() + height * normal;
  }
  mesh.name = "tetrahedral ogre";
  return mesh;
}

// n triangles around vertex 0 at the origin. The vertices around it alternate between the heights z_even and z_odd:
// zero makes a flat fan, a constant a cone, opposite heights a saddle.
inline Indexed_mesh fan(const std::string& name, std::size_t n, double z_even, double z_odd)
{
  Indexed_mesh mesh;
  mesh.name = name;
  mesh.points.push_back({0, 0, 0});
  for(std::size_t i = 0; i < n; ++i)
  {
    const double s = 2. * pi * static_cast<double>(i) / static_cast<double>(n);
    mesh.points.push_back({std::cos(s), std::sin(s), i % 2 == 0 ? z_even : z_odd});
    mesh.faces.push_back({0, i + 1, (i + 1) % n + 1});
  }
  return mesh;
}

inline Indexed_mesh cone_fan(std::size_t n)
{
  return fan("cone fan", n, -1., -1.);
}

inline Indexed_mesh saddle_fan(std::size_t n)
{
  return fan("saddle fan", n, .7, -.7);
}

// Two squares of the plane that share vertex 0 only.
inline Indexed_mesh bow_tie()
{
  Indexed_mesh mesh;
  mesh.name = "bow tie";
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 6}};
  return mesh;
}

// Two apices of degree n, above and below a regular polygon.
inline Indexed_mesh bipyramid(std::size_t n, double height)
{
  Indexed_mesh mesh;
  mesh.name = "bipyramid";
  mesh.points.push_back({0, 0, height});
  mesh.points.push_back({0, 0, -height});
  for(std::size_t i = 0; i < n; ++i)
  {
    const double s = 2. * pi * static_cast<double>(i) / static_cast<double>(n);
    mesh.points.push_back({std::cos(s), std::sin(s), 0.});
    mesh.faces.push_back({0, 2 + i, 2 + (i + 1) % n});
    mesh.faces.push_back({1, 2 + (i + 1) % n, 2 + i});
  }
  return mesh;
}

inline Indexed_mesh two_components_and_an_isolated_vertex()
{
  Indexed_mesh mesh = side_by_side(icosphere(1), saddle_patch(4), "two components and an isolated vertex");
  mesh.points.push_back({9, 9, 9});
  return mesh;
}

// The meshes for comparisons with other programs: each has at most a few thousand faces, no edge of length zero and no
// face of area zero.
inline std::vector<Indexed_mesh> collection(std::uint64_t seed)
{
  auto stretched = [](const Indexed_mesh& mesh, double factor) {
    return transformed(mesh, mesh.name + ", stretched",
                       [factor](const Coordinates& p) { return Coordinates{factor * p[0], p[1], p[2]}; });
  };
  std::vector<Indexed_mesh> meshes;
  meshes.push_back(irregular_tetrahedron());
  meshes.push_back(midpoint_subdivision(regular_tetrahedron(), 2));
  meshes.push_back(octahedron());
  meshes.push_back(cube());
  meshes.push_back(cube_grid(4));
  meshes.push_back(icosphere(2));
  meshes.push_back(torus(1., .4, 24, 12));
  meshes.push_back(midpoint_subdivision(genus_2_polycube()));
  meshes.push_back(genus_3_polycube());
  meshes.push_back(midpoint_subdivision(jittered(genus_3_polycube(), .2, seed + 1)));
  meshes.push_back(midpoint_subdivision(Menger_sponge()));
  meshes.push_back(wavy_tube(20, 24));
  meshes.push_back(Schwarz_lantern(8, 20));
  meshes.push_back(Schwarz_lantern(12, 60));
  meshes.push_back(saddle_patch(14));
  meshes.push_back(rough_terrain(12, 1.5, seed + 2));
  meshes.push_back(rough_terrain(10, 20., seed + 3));
  meshes.push_back(noisy_sphere(2, .1, seed + 4));
  meshes.push_back(noisy_sphere(3, .03, seed + 5));
  meshes.push_back(stretched(icosphere(2), 16.));
  meshes.push_back(stretched(torus(1., .4, 20, 10), 16.));
  meshes.push_back(needle_sphere(96, 6));
  meshes.push_back(tetrahedral_ogre(30, seed + 6));
  meshes.push_back(tetrahedral_ogre(80, seed + 7));
  meshes.push_back(prism_tube(3, 2, .05, 20., 3.));
  meshes.push_back(prism_tube(5, 8, 1., 30., 9.));
  meshes.push_back(square_with_holes(2));
  meshes.push_back(spiral_corridor());
  meshes.push_back(random_cuts(noisy_sphere(2, .1, seed + 8), .15, seed + 9));
  meshes.push_back(random_cuts(torus(1., .4, 24, 12), .1, seed + 10));
  meshes.push_back(random_cuts(flat_patch(10, 10, .3, true, seed + 11), .2, seed + 12));
  meshes.push_back(cone_fan(64));
  meshes.push_back(saddle_fan(10));
  meshes.push_back(bipyramid(40, .02));
  meshes.push_back(bipyramid(12, 10.));
  meshes.push_back(strip(12));
  meshes.push_back(prism_tube(12, 10, 1., 4.));
  meshes.push_back(two_components_and_an_isolated_vertex());
  return meshes;
}

// The meshes of the collection with at most 400 faces, for tests that run many times on each mesh.
inline std::vector<Indexed_mesh> small_collection(std::uint64_t seed)
{
  std::vector<Indexed_mesh> meshes;
  for(Indexed_mesh& mesh : collection(seed))
  {
    if(mesh.faces.size() <= 400)
    {
      meshes.push_back(std::move(mesh));
    }
  }
  return meshes;
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_TEST_MESHES_H
