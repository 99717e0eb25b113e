#ifndef SURFACE_MESH_GEODESICS_MESH_OPERATIONS_H
#define SURFACE_MESH_GEODESICS_MESH_OPERATIONS_H

// Operations that make new indexed meshes of old ones: subdivision, permutation, splits, cuts and unions.

#include "Indexed_mesh.h"
#include "test_support.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

// Splits every triangle into four, `times` times. Old vertices keep their indices.
inline Indexed_mesh midpoint_subdivision(const Indexed_mesh& mesh, std::size_t times = 1)
{
  Indexed_mesh result = mesh;
  for(std::size_t step = 0; step < times; ++step)
  {
    Indexed_mesh finer;
    finer.name = result.name + ", subdivided";
    finer.points = result.points;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
    auto midpoint = [&](std::size_t a, std::size_t b) {
      const auto key = std::minmax(a, b);
      const auto inserted = midpoints.insert({{key.first, key.second}, finer.points.size()});
      if(inserted.second)
      {
        finer.points.push_back(0.5 * (result.points[a] + result.points[b]));
      }
      return inserted.first->second;
    };
    for(const Triangle& t : result.faces)
    {
      const std::size_t m01 = midpoint(t[0], t[1]);
      const std::size_t m12 = midpoint(t[1], t[2]);
      const std::size_t m20 = midpoint(t[2], t[0]);
      finer.faces.push_back({t[0], m01, m20});
      finer.faces.push_back({t[1], m12, m01});
      finer.faces.push_back({t[2], m20, m12});
      finer.faces.push_back({m01, m12, m20});
    }
    result = finer;
  }
  return result;
}

// Renumbers the vertices at random: vertex i becomes vertex new_index[i]. Shuffles the faces and the first corner of
// each face too.
inline Indexed_mesh permuted(const Indexed_mesh& mesh, test_support::Random& random,
                             std::vector<std::size_t>& new_index)
{
  new_index.resize(mesh.points.size());
  for(std::size_t i = 0; i < new_index.size(); ++i)
  {
    new_index[i] = i;
  }
  random.shuffle(new_index);
  Indexed_mesh result;
  result.name = mesh.name + ", permuted";
  result.points.resize(mesh.points.size());
  for(std::size_t i = 0; i < new_index.size(); ++i)
  {
    result.points[new_index[i]] = mesh.points[i];
  }
  for(const Triangle& t : mesh.faces)
  {
    const std::size_t shift = random.index(3);
    result.faces.push_back(
      {new_index[t[shift]], new_index[t[(shift + 1) % 3]], new_index[t[(shift + 2) % 3]]});
  }
  random.shuffle(result.faces);
  return result;
}

template <class Function>
Indexed_mesh transformed(const Indexed_mesh& mesh, const std::string& name, const Function& function)
{
  Indexed_mesh result = mesh;
  result.name = name;
  for(Coordinates& p : result.points)
  {
    p = function(p);
  }
  return result;
}

inline Indexed_mesh scaled(const Indexed_mesh& mesh, double factor)
{
  return transformed(mesh, mesh.name + ", scaled", [factor](const Coordinates& p) { return factor * p; });
}

// Splits a face at the point with the given barycentric coordinates, in the order of its corners. The point becomes the
// last vertex.
inline Indexed_mesh with_point_in_face(const Indexed_mesh& mesh, std::size_t face,
                                       const std::array<double, 3>& barycentric)
{
  Indexed_mesh result = mesh;
  const Triangle t = mesh.faces[face];
  const std::size_t v = mesh.points.size();
  result.points.push_back(barycentric[0] * mesh.points[t[0]] + barycentric[1] * mesh.points[t[1]] +
                          barycentric[2] * mesh.points[t[2]]);
  result.faces[face] = {t[0], t[1], v};
  result.faces.push_back({t[1], t[2], v});
  result.faces.push_back({t[2], t[0], v});
  return result;
}

// Splits the edge ab, and its one or two faces, at the point a + t (b - a). The point becomes the last vertex.
inline Indexed_mesh with_point_on_edge(const Indexed_mesh& mesh, std::size_t a, std::size_t b, double t)
{
  Indexed_mesh result = mesh;
  const std::size_t v = mesh.points.size();
  result.points.push_back((1. - t) * mesh.points[a] + t * mesh.points[b]);
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const Triangle& corners = mesh.faces[f];
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t first = corners[k];
      const std::size_t second = corners[(k + 1) % 3];
      const std::size_t apex = corners[(k + 2) % 3];
      if((first == a && second == b) || (first == b && second == a))
      {
        result.faces[f] = {first, v, apex};
        result.faces.push_back({v, second, apex});
      }
    }
  }
  return result;
}

// Splits a face at the point a + t (b - a) of its side k = (a, b), but not its neighbor: a cap, a face of area zero,
// fills the slit. The point becomes the last vertex. The surface does not change.
inline Indexed_mesh with_cap(const Indexed_mesh& mesh, std::size_t face, std::size_t k, double t)
{
  Indexed_mesh result = mesh;
  const std::size_t a = mesh.faces[face][k];
  const std::size_t b = mesh.faces[face][(k + 1) % 3];
  const std::size_t c = mesh.faces[face][(k + 2) % 3];
  const std::size_t v = mesh.points.size();
  result.points.push_back((1. - t) * mesh.points[a] + t * mesh.points[b]);
  result.faces[face] = {a, v, c};
  result.faces.push_back({v, b, c});
  result.faces.push_back({a, b, v});
  return result;
}

// Removes every face for which the predicate holds. All vertices stay, isolated ones too.
template <class Predicate>
Indexed_mesh without_faces(const Indexed_mesh& mesh, const std::string& name, const Predicate& is_removed)
{
  Indexed_mesh result;
  result.name = name;
  result.points = mesh.points;
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    if(!is_removed(f))
    {
      result.faces.push_back(mesh.faces[f]);
    }
  }
  return result;
}

inline Indexed_mesh jittered(const Indexed_mesh& mesh, double jitter, std::uint64_t seed)
{
  test_support::Random random(seed);
  return transformed(mesh, mesh.name + ", jittered", [&](const Coordinates& p) {
    const double dx = random.uniform(-jitter, jitter);
    const double dy = random.uniform(-jitter, jitter);
    const double dz = random.uniform(-jitter, jitter);
    return p + Coordinates{dx, dy, dz};
  });
}

// Removes random faces: the result has many borders, pinched and isolated vertices, and several components.
inline Indexed_mesh random_cuts(const Indexed_mesh& mesh, double share, std::uint64_t seed)
{
  test_support::Random random(seed);
  return without_faces(mesh, mesh.name + ", random cuts", [&](std::size_t) { return random.uniform() < share; });
}

// Adds a mesh to another one. Vertex `common` of the second mesh, if it exists, becomes vertex `of` of the first.
inline void join(Indexed_mesh& mesh, const Indexed_mesh& other, std::size_t of = 0,
                 std::size_t common = (std::numeric_limits<std::size_t>::max)())
{
  const std::size_t shift = mesh.points.size();
  const auto number = [&](std::size_t i) { return i == common ? of : i + shift; };
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for(const Triangle& t : other.faces)
  {
    mesh.faces.push_back({number(t[0]), number(t[1]), number(t[2])});
  }
}

// The disjoint union of two meshes.
inline Indexed_mesh side_by_side(const Indexed_mesh& first, const Indexed_mesh& second, const std::string& name)
{
  Indexed_mesh mesh = first;
  join(mesh, second);
  mesh.name = name;
  return mesh;
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_MESH_OPERATIONS_H
