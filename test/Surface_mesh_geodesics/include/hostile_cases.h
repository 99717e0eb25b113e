#ifndef SURFACE_MESH_GEODESICS_HOSTILE_CASES_H
#define SURFACE_MESH_GEODESICS_HOSTILE_CASES_H

// Families of hostile surfaces with sources of every kind. A case depends only on the seed of the random number
// generator.

#include "distance_case.h"
#include "hostile_meshes.h"
#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace hostile_cases {

using namespace test_meshes;
using hostile_meshes::of_any_scale;
using test_support::Random;

// --- surfaces ---

inline Distance_case needles_and_caps(Random& random)
{
  return case_of_mesh(hostile_meshes::hostile_mesh(random));
}

inline Indexed_mesh plain_mesh_with_faces(Random& random)
{
  const Indexed_mesh mesh = hostile_meshes::plain_mesh(random);
  return mesh.faces.empty() ? icosphere(0) : mesh;
}

// Moves vertices onto others, mostly onto neighbors. The result has edges without length, faces without area, and parts
// that coincide.
inline Distance_case duplicate_points(Random& random)
{
  Indexed_mesh mesh = plain_mesh_with_faces(random);
  for(std::size_t i = 1 + random.index(1 + mesh.points.size() / 2); i > 0; --i)
  {
    const Triangle t = mesh.faces[random.index(mesh.faces.size())];
    const std::size_t other = random.index(4) == 0 ? random.index(mesh.points.size()) : t[1];
    mesh.points[t[0]] = mesh.points[other];
  }
  return case_of_mesh(mesh);
}

inline Distance_case exact_ties(Random& random)
{
  const std::size_t m = 1 + random.index(4), n = 1 + random.index(4);
  switch(random.index(9))
  {
  case 0:
    return case_of_mesh(octahedron());
  case 1:
    return case_of_mesh(icosphere(random.index(2)));
  case 2:
    return case_of_mesh(cube_grid(1 + random.index(2)));
  case 3:
    return case_of_mesh(flat_patch(m, n, 0., random.index(2) == 0, random.index(1000)));
  case 4:
    return case_of_mesh(bipyramid(3 + m * n, static_cast<double>(random.index(3))));
  case 5:
    return case_of_mesh(midpoint_subdivision(regular_tetrahedron(), random.index(3)));
  case 6:
    return case_of_mesh(Schwarz_lantern(3 + m, n));
  case 7:
    return case_of_mesh(genus_2_polycube());
  default:
    return case_of_mesh(torus(2., 1., 2 + m, 2 + n));
  }
}

// A plane with heights of about 1e-12: its saddles hardly differ from flat vertices.
inline Distance_case nearly_flat(Random& random)
{
  Indexed_mesh mesh = flat_patch(2 + random.index(4), 2 + random.index(4), random.index(2) == 0 ? 0. : .15,
                                 random.index(2) == 0, random.index(1000000));
  const double height = random.index(2) == 0 ? 1e-12 : of_any_scale(-16., -5., random);
  for(Coordinates& p : mesh.points)
  {
    p[2] = height * static_cast<double>(random.index(3)) - height;
  }
  mesh.name = "nearly flat patch";
  return case_of_mesh(mesh);
}

// Parts that meet in single vertices. The former vertex `common` stays as an isolated vertex.
inline Distance_case pinched_vertices(Random& random)
{
  Indexed_mesh mesh = hostile_meshes::fan_of_slivers(random);
  for(std::size_t i = 1 + random.index(3); i > 0; --i)
  {
    Indexed_mesh other = random.index(2) == 0 ? hostile_meshes::fan_of_slivers(random)
                                              : flat_patch(2, 2, .1, true, random.index(1000));
    const std::size_t of = random.index(mesh.points.size()), common = random.index(other.points.size());
    const Coordinates shift = mesh.points[of] - other.points[common];
    for(Coordinates& p : other.points)
    {
      p = p + shift;
    }
    other.points[common] = mesh.points[of];
    join(mesh, other, of, common);
  }
  mesh.name = "pinched vertices";
  return case_of_mesh(mesh);
}

inline Distance_case holes(Random& random)
{
  const std::size_t n = 1 + random.index(2);
  Indexed_mesh mesh = random.index(4) == 0 ? square_with_holes(n) : plain_mesh_with_faces(random);
  const Indexed_mesh cut = random_cuts(mesh, random.uniform(0., .4), random.index(1000000));
  return case_of_mesh(cut.faces.empty() ? mesh : cut);
}

// their sizes may differ much
inline Distance_case several_components(Random& random)
{
  Indexed_mesh mesh = hostile_meshes::hostile_mesh(random);
  const double factor = random.index(2) == 0 ? 1. : of_any_scale(-40., 40., random);
  join(mesh, scaled(hostile_meshes::hostile_mesh(random), factor));
  mesh.points.push_back({1., 2., 3.}); // an isolated vertex
  mesh.name = "several components";
  return case_of_mesh(mesh);
}

// Scales a mesh to units of any size, or moves it far from the origin.
inline Distance_case any_scale(Random& random)
{
  Indexed_mesh mesh = hostile_meshes::hostile_mesh(random);
  const double factor = of_any_scale(-150., 150., random);
  const double shift = random.index(2) == 0 ? 0. : of_any_scale(0., 6., random);
  for(Coordinates& p : mesh.points)
  {
    p = factor * (p + Coordinates{shift, -shift, shift});
  }
  return case_of_mesh(mesh);
}

// Lengths between 1 and 2, any three of which are the sides of a triangle: uniform, or such that triangles have no
// height or nearly none.
inline double random_length(bool is_extreme, Random& random)
{
  if(!is_extreme)
  {
    return random.uniform(1., 2.);
  }
  switch(random.index(5))
  {
  case 0:
    return 1. + of_any_scale(-15., 0., random);
  case 1:
    return 2. - of_any_scale(-15., 0., random);
  case 2:
    return 2.;
  default:
    return 1.;
  }
}

inline void set_random_lengths(Distance_case& c, bool is_extreme, Random& random)
{
  for(double& length : c.surface.lengths)
  {
    length = random_length(is_extreme, random);
  }
  c.has_points = false;
}

inline Distance_case random_lengths(Random& random)
{
  Distance_case c = case_of_mesh(plain_mesh_with_faces(random));
  set_random_lengths(c, false, random);
  c.name += ", random lengths";
  return c;
}

// Many faces have no height or nearly none, because 1 + 1 = 2. No mesh with points has so many of them.
inline Distance_case faces_without_height(Random& random)
{
  Distance_case c = case_of_mesh(plain_mesh_with_faces(random));
  set_random_lengths(c, true, random);
  c.name += ", faces without height";
  return c;
}

// Returns whether two sides of one triangle are glued to each other.
inline bool is_glued_to_itself(const std::vector<std::size_t>& sides, std::size_t number_of_pairs)
{
  for(std::size_t i = 0; i < number_of_pairs; ++i)
  {
    if(sides[2 * i] / 3 == sides[2 * i + 1] / 3)
    {
      return true;
    }
  }
  return false;
}

// Triangles whose sides are glued in pairs at random: many handles, few vertices. If a face has a vertex twice, the
// surface is subdivided: halfedges can express such a face, but functions for triangle meshes do not expect it. Two
// vertices may have several edges.
inline Distance_case random_gluing(Random& random)
{
  const std::size_t n = 2 * (1 + random.index(random.index(4) == 0 ? 20 : 5)); // the genus is about n / 4
  std::vector<std::size_t> sides(3 * n), vertex_of_corner(3 * n);
  std::iota(sides.begin(), sides.end(), std::size_t(0));
  std::iota(vertex_of_corner.begin(), vertex_of_corner.end(), std::size_t(0));
  const std::size_t number_of_pairs = random.index(3) == 0 ? random.index(3 * n / 2 + 1) : 3 * n / 2;
  do
  {
    random.shuffle(sides);
  } while(is_glued_to_itself(sides, number_of_pairs));
  Distance_case c;
  c.name = "random gluing";
  c.surface.edges.resize(n);
  const auto unite = [&](std::size_t a, std::size_t b)
  {
    const std::size_t from = vertex_of_corner[a], to = vertex_of_corner[b];
    std::replace(vertex_of_corner.begin(), vertex_of_corner.end(), from, to);
  };
  const auto head = [](std::size_t s) { return s - s % 3 + (s + 1) % 3; };
  std::size_t number_of_edges = 0;
  for(std::size_t i = 0; i < sides.size(); ++i)
  {
    const bool is_second = i % 2 == 1 && i < 2 * number_of_pairs;
    number_of_edges += !is_second;
    c.surface.edges[sides[i] / 3][sides[i] % 3] = number_of_edges - 1;
    if(is_second)
    {
      unite(sides[i], head(sides[i - 1]));
      unite(head(sides[i]), sides[i - 1]);
    }
  }
  std::vector<std::size_t> classes = vertex_of_corner;
  std::sort(classes.begin(), classes.end());
  classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
  c.surface.mesh.points.assign(classes.size(), {0., 0., 0.});
  for(std::size_t f = 0; f < n; ++f)
  {
    Triangle t{};
    for(std::size_t k = 0; k < 3; ++k)
    {
      const auto found = std::lower_bound(classes.begin(), classes.end(), vertex_of_corner[3 * f + k]);
      t[k] = static_cast<std::size_t>(found - classes.begin());
    }
    c.surface.mesh.faces.push_back(t);
  }
  c.surface.lengths.resize(number_of_edges);
  set_random_lengths(c, false, random);
  if(has_vertex_twice_in_face(c.surface.mesh))
  {
    c.surface = midpoint_subdivision(c.surface);
  }
  return c;
}

struct Family
{
  const char* name;
  Distance_case (*make)(Random&);
};

using Families = std::vector<Family>;

inline Families families()
{
  return {{"needles and caps", needles_and_caps}, {"duplicate points", duplicate_points},
          {"exact ties", exact_ties},             {"nearly flat", nearly_flat},
          {"pinched vertices", pinched_vertices}, {"holes", holes},
          {"components", several_components},     {"scales", any_scale},
          {"random lengths", random_lengths},     {"random gluings", random_gluing},
          {"no height", faces_without_height}};
}

// A rectangle whose sides are identified, one pair of them reversed: a Moebius strip, a Klein bottle, or a projective
// plane. These surfaces have no orientation.
inline Indexed_mesh not_orientable(Random& random)
{
  const std::size_t m = 4 + random.index(4), n = 4 + random.index(4), kind = random.index(3);
  Indexed_mesh mesh;
  mesh.name = "not orientable";
  const auto id = [&](std::size_t i, std::size_t j)
  {
    if(i == m)
    {
      i = 0;
      j = n - j;
    }
    if(kind != 0 && j == n) // top and bottom
    {
      j = 0;
      i = kind == 1 ? i : (m - i) % m;
    }
    return i * (n + 1) + j;
  };
  for(std::size_t i = 0; i < m; ++i)
  {
    for(std::size_t j = 0; j <= n; ++j)
    {
      mesh.points.push_back(hostile_meshes::random_vector(1., random));
    }
  }
  for(std::size_t i = 0; i < m; ++i)
  {
    for(std::size_t j = 0; j < n; ++j)
    {
      add_quadrilateral(mesh, id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1), false);
    }
  }
  return mesh;
}

// --- sources ---

// A vertex with faces around it, or a location on an edge or in a face, mostly near corners and edges.
inline Numbered_source random_source(const Distance_case& c, Random& random)
{
  Numbered_source s;
  s.face = random.index(c.surface.edges.size());
  const std::size_t k = random.index(3), kind = random.index(6);
  if(kind < 2)
  {
    s.vertex = c.surface.mesh.faces[s.face][k];
    return s;
  }
  const double a = kind == 2 ? 0. : kind == 3 ? random.uniform(0., .5) : of_any_scale(-15., 0., random) / 2.;
  const double b = kind == 4 ? of_any_scale(-15., 0., random) / 2. : random.uniform(0., .5);
  s.coordinates = {1. - a - b, a, b};
  paths_near_vertices::clear_small_coordinates(s.coordinates);
  std::rotate(s.coordinates.begin(), s.coordinates.begin() + static_cast<std::ptrdiff_t>(k), s.coordinates.end());
  return s;
}

inline void add_sources(Distance_case& c, Random& random)
{
  for(std::size_t i = random.index(2) == 0 ? 1 : 2 + random.index(4); i > 0; --i)
  {
    const bool is_repeated = !c.sources.empty() && random.index(4) == 0;
    c.sources.push_back(is_repeated ? c.sources[random.index(c.sources.size())] : random_source(c, random));
  }
  if(random.index(3) == 0)
  {
    const double unit = c.surface.lengths[random.index(c.surface.lengths.size())];
    for(Numbered_source& s : c.sources)
    {
      s.offset = unit * (random.index(3) == 0 ? of_any_scale(-15., 1., random) : static_cast<double>(random.index(3)));
    }
  }
}

} // namespace hostile_cases

#endif // SURFACE_MESH_GEODESICS_HOSTILE_CASES_H
