#ifndef SURFACE_MESH_GEODESICS_HOSTILE_MESHES_H
#define SURFACE_MESH_GEODESICS_HOSTILE_MESHES_H

// Small random meshes with caps and needles of all heights down to the rounding of coordinates, nearly equal points,
// and vertices of all scales. Checks of what every path on them must satisfy.

#include "expected_exceptions.h"
#include "path_test_helpers.h"
#include "paths_near_vertices.h"
#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hostile_meshes {

using namespace test_meshes;

// A small number of any scale from 10^first to 10^last.
inline double of_any_scale(double first, double last, test_support::Random& random)
{
  return std::pow(10., random.uniform(first, last));
}

inline Coordinates random_vector(double size, test_support::Random& random)
{
  const double x = random.uniform(-size, size), y = random.uniform(-size, size), z = random.uniform(-size, size);
  return {x, y, z};
}

// A small shift: in space, along one axis, so that flat meshes stay flat, or zero.
inline Coordinates small_shift(test_support::Random& random)
{
  const double size = of_any_scale(-16., -6., random);
  switch(random.index(4))
  {
  case 0:
    return {0., 0., 0.};
  case 1:
    return {random.uniform(-size, size), random.uniform(-size, size), 0.};
  default:
    return random_vector(size, random);
  }
}

// Moves a vertex almost onto another vertex of its face, or almost onto the opposite edge.
inline void collapse_almost(Indexed_mesh& mesh, test_support::Random& random)
{
  const Triangle t = mesh.faces[random.index(mesh.faces.size())];
  const std::size_t k = random.index(3);
  const Coordinates a = mesh.points[t[(k + 1) % 3]], b = mesh.points[t[(k + 2) % 3]];
  double abscissa = 0.;
  if(random.index(3) != 0)
  {
    abscissa = random.index(2) == 0 ? random.uniform() : of_any_scale(-15., -1., random);
  }
  mesh.points[t[k]] = a + abscissa * (b - a) + small_shift(random);
}

// Splits a face at a point very near a corner or an edge, or anywhere.
inline void split_somewhere(Indexed_mesh& mesh, test_support::Random& random)
{
  const double a = random.index(2) == 0 ? random.uniform() : of_any_scale(-15., -1., random);
  const double b = (1. - a) * (random.index(2) == 0 ? random.uniform() : of_any_scale(-15., -1., random));
  std::array<double, 3> c{1. - a - b, a, b};
  std::rotate(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(random.index(3)), c.end());
  mesh = with_point_in_face(mesh, random.index(mesh.faces.size()), c);
  mesh.points.back() = mesh.points.back() + small_shift(random);
}

// Replaces the edge of two faces by the other diagonal, unless that edge exists.
inline void flip_some_edge(Indexed_mesh& mesh, test_support::Random& random)
{
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for(const Triangle& t : mesh.faces)
  {
    for(std::size_t k = 0; k < 3; ++k)
    {
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
  }
  Triangle& first = mesh.faces[random.index(mesh.faces.size())];
  const std::size_t k = random.index(3);
  const std::size_t a = first[k], b = first[(k + 1) % 3], c = first[(k + 2) % 3];
  for(Triangle& second : mesh.faces)
  {
    for(std::size_t j = 0; j < 3; ++j)
    {
      if(second[j] != b || second[(j + 1) % 3] != a)
      {
        continue;
      }
      const std::size_t d = second[(j + 2) % 3];
      if(d != c && edges.count(std::minmax(c, d)) == 0)
      {
        first = {a, d, c};
        second = {d, b, c};
      }
      return;
    }
  }
}

// Faces around a vertex, all or a part of them, whose angles and sides are of all scales.
inline Indexed_mesh fan_of_slivers(test_support::Random& random)
{
  Indexed_mesh mesh;
  mesh.name = "fan of slivers";
  const std::size_t n = 3 + random.index(8);
  const bool is_closed = random.index(2) == 0;
  std::vector<double> angle(n);
  double sum = 0.;
  for(double& a : angle)
  {
    a = of_any_scale(random.index(2) == 0 ? -12. : -2., 0., random);
    sum += a;
  }
  const double total = is_closed ? 2. * pi : random.uniform(1., 7.);
  const double height = random.index(2) == 0 ? 0. : 1.;
  const double smallest = random.index(2) == 0 ? -10. : 0.;
  mesh.points.push_back({0., 0., 0.});
  double at = 0.;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double r = of_any_scale(smallest, 0., random);
    mesh.points.push_back({r * std::cos(at), r * std::sin(at), height * r * random.uniform(-1., 1.)});
    at += total * angle[i] / sum;
    if(is_closed || i + 1 < n)
    {
      mesh.faces.push_back({0, i + 1, (i + 1) % n + 1});
    }
  }
  return mesh;
}

inline Indexed_mesh plain_mesh(test_support::Random& random)
{
  const std::size_t m = 1 + random.index(5), n = 1 + random.index(5);
  const std::uint64_t seed = random.index(1000000);
  switch(random.index(7))
  {
  case 0:
    return flat_patch(m, n, .15, true, seed);
  case 1:
    return rough_terrain((std::max)(m, n), of_any_scale(-3., 1., random), seed);
  case 2:
    return noisy_sphere(random.index(2), .1, seed);
  case 3:
    return torus(1., .4, 3 + m, 3 + n);
  case 4:
    return tetrahedral_ogre(3 + m * n, seed);
  case 5:
    return fan_of_slivers(random);
  default:
    return random_cuts(noisy_sphere(1, .1, seed), .2, seed + 1);
  }
}

// Squeezes a mesh along an axis, or moves each vertex toward the origin by another factor.
inline void change_scales(Indexed_mesh& mesh, test_support::Random& random)
{
  const std::size_t axis = random.index(4);
  const double factor = of_any_scale(-12., 0., random);
  for(Coordinates& p : mesh.points)
  {
    if(axis < 3)
    {
      p[axis] *= factor;
    }
    else
    {
      p = of_any_scale(-6., 0., random) * p;
    }
  }
}

inline Indexed_mesh hostile_mesh(test_support::Random& random)
{
  Indexed_mesh mesh = plain_mesh(random);
  if(mesh.faces.empty())
  {
    mesh = icosphere(0);
  }
  if(random.index(3) == 0)
  {
    change_scales(mesh, random);
  }
  for(std::size_t i = random.index(6); i > 0; --i)
  {
    flip_some_edge(mesh, random);
  }
  for(std::size_t i = random.index(8); i > 0; --i)
  {
    split_somewhere(mesh, random);
  }
  for(std::size_t i = random.index(8); i > 0; --i)
  {
    collapse_almost(mesh, random);
  }
  return mesh;
}

// Converts a hostile mesh. Returns false if it is not a 2-manifold, because some of its faces were cut away.
inline bool is_surface(const Indexed_mesh& mesh, Mesh& tm)
{
  return !throws<std::logic_error>([&] { tm = to_face_graph(mesh); });
}

// A vertex, or a point of a face: anywhere, on an edge, or very near a corner or an edge.
inline Surface_point hostile_point(const Mesh& tm, test_support::Random& random)
{
  if(random.index(3) == 0)
  {
    return Surface_point(random_vertex(tm, random));
  }
  Geodesic_paths::Face_location location = random_location(tm, random);
  const std::size_t kind = random.index(4);
  if(kind != 0)
  {
    const double a = kind == 1 ? 0. : of_any_scale(-15., 0., random) / 2.;
    const double b = kind == 2 ? of_any_scale(-15., 0., random) / 2. : random.uniform(0., .5);
    std::array<double, 3> c{1. - a - b, a, b};
    paths_near_vertices::clear_small_coordinates(c);
    std::rotate(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(random.index(3)), c.end());
    location.second = {c[0], c[1], c[2]};
  }
  return Surface_point(location);
}

// Counts of faults.
struct Path_faults
{
  std::size_t queries = 0, unreached = 0, no_path = 0, no_common_face = 0, wrong_length = 0;
  double worst_error = 0.;
};

// Returns whether two consecutive items of a path have no face in common.
inline bool has_gap(const std::vector<Path_item<Geodesic_paths>>& items, const Mesh& tm)
{
  bool result = false;
  for(std::size_t j = 1; j < items.size(); ++j)
  {
    const auto before = faces_of_item(items[j - 1], tm), after = faces_of_item(items[j], tm);
    result = result || std::find_first_of(before.begin(), before.end(), after.begin(), after.end()) == before.end();
  }
  return result;
}

// Checks a path on a mesh of the given size: it leads from face to face, and is as long as the distance.
inline void check_path_on(const Mesh& tm, double size, const Geodesic_paths& paths,
                          const std::vector<Path_item<Geodesic_paths>>& items, double distance, Path_faults& faults)
{
  using Item = Path_item<Geodesic_paths>;
  std::vector<Coordinates> points;
  for(const Item& item : items)
  {
    points.push_back(point_of_item(item, paths));
    CHECK(item.kind != Item::EDGE || (item.t >= 0. && item.t <= 1.));
  }
  if(!CHECK(!has_gap(items, tm)))
  {
    ++faults.no_common_face;
  }
  const double error = std::abs(polyline_length(points) - distance);
  // the points are rounded, and so are their locations in faces, by 64 units of the extent
  const double rounding = 128 * std::numeric_limits<double>::epsilon() * size;
  faults.worst_error = (std::max)(faults.worst_error, (error - rounding) / distance);
  if(!CHECK(error <= 1e-10 * distance + rounding))
  {
    ++faults.wrong_length;
  }
}

// Queries paths from one or two sources. Checks that each exists, leads from face to face, and is as long as the
// distance.
inline void check_paths_on(const Mesh& tm, std::size_t number_of_queries, test_support::Random& random,
                           Path_faults& faults)
{
  const double size = size_of(tm);
  Geodesic_paths paths(tm);
  const std::size_t number_of_sources = random.index(3) == 0 ? 2 : 1;
  for(std::size_t i = 0; i < number_of_sources; ++i)
  {
    add(paths, hostile_point(tm, random));
  }
  for(std::size_t i = 0; i < number_of_queries; ++i)
  {
    const Surface_point q = hostile_point(tm, random);
    test_support::Scope scope(description(q));
    ++faults.queries;
    Path_recorder<Geodesic_paths> recorder;
    Answer answer{};
    bool is_found = true;
    try
    {
      answer = ask_sequence(paths, q, recorder);
    }
    catch(const std::runtime_error&)
    {
      is_found = false;
    }
    if(!CHECK(is_found))
    {
      ++faults.no_path;
      continue;
    }
    if(answer.distance < 0.)
    {
      CHECK(recorder.items.empty());
      ++faults.unreached;
      continue;
    }
    check_path_on(tm, size, paths, recorder.items, answer.distance, faults);
  }
}

// Mesh number i depends only on the seed plus i.
inline Path_faults paths_on_hostile_meshes(std::size_t number, std::uint64_t seed, std::size_t number_of_queries)
{
  Path_faults faults;
  for(std::size_t i = 0; i < number; ++i)
  {
    test_support::Random random(seed + i);
    const Indexed_mesh mesh = hostile_mesh(random);
    std::ostringstream name;
    name << mesh.name << ", seed " << seed + i;
    test_support::Scope scope(name.str());
    Mesh tm;
    if(!is_surface(mesh, tm))
    {
      continue;
    }
    check_paths_on(tm, number_of_queries, random, faults);
  }
  std::cout << number << " hostile meshes, " << faults.queries << " queries, " << faults.unreached << " unreached, "
            << faults.no_path << " without path, " << faults.no_common_face << " with a gap, " << faults.wrong_length
            << " of another length, relative error beyond rounding " << faults.worst_error << "\n";
  return faults;
}

} // namespace hostile_meshes

#endif // SURFACE_MESH_GEODESICS_HOSTILE_MESHES_H
