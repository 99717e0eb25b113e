#ifndef SURFACE_MESH_GEODESICS_TEST_MESHES_H
#define SURFACE_MESH_GEODESICS_TEST_MESHES_H

// Meshes made by programs, as indexed triangles, and their conversion into any
// mutable face graph. The i-th vertex that the conversion adds is the i-th point.

#include "test_support.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_meshes {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using face_descriptor = boost::graph_traits<Mesh>::face_descriptor;
using Face_location = std::pair<face_descriptor, std::array<double, 3>>;

using Coordinates = std::array<double, 3>;
using Triangle = std::array<std::size_t, 3>;

const double pi = 3.14159265358979323846;

struct Indexed_mesh
{
  std::string name;
  std::vector<Coordinates> points;
  std::vector<Triangle> faces;
};

// ---------------------------------------------------------------------------
// small vector arithmetic
// ---------------------------------------------------------------------------

inline Coordinates operator+(const Coordinates& a, const Coordinates& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Coordinates operator-(const Coordinates& a, const Coordinates& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Coordinates operator*(double s, const Coordinates& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}

inline double length(const Coordinates& a)
{
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

inline Coordinates cross(const Coordinates& a, const Coordinates& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// ---------------------------------------------------------------------------
// conversion
// ---------------------------------------------------------------------------

// Adds the vertices and faces of `indexed` to `tm`; returns the vertex descriptors
// in the order of the points and, if asked for, the faces in theirs.
template <class FaceGraph>
std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor>
add_to_face_graph(const Indexed_mesh& indexed, FaceGraph& tm,
                  std::vector<typename boost::graph_traits<FaceGraph>::face_descriptor>* faces_of_triangles = nullptr)
{
  using Point = typename boost::property_traits<
    typename boost::property_map<FaceGraph, CGAL::vertex_point_t>::type>::value_type;
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;

  auto vertex_point_map = get(CGAL::vertex_point, tm);
  std::vector<Vertex> vertices_of_points;
  vertices_of_points.reserve(indexed.points.size());
  for(const Coordinates& p : indexed.points)
  {
    const Vertex v = add_vertex(tm);
    put(vertex_point_map, v, Point(p[0], p[1], p[2]));
    vertices_of_points.push_back(v);
  }
  for(const Triangle& triangle : indexed.faces)
  {
    const std::array<Vertex, 3> corners{vertices_of_points[triangle[0]], vertices_of_points[triangle[1]],
                                        vertices_of_points[triangle[2]]};
    const auto f = CGAL::Euler::add_face(corners, tm);
    if(f == boost::graph_traits<FaceGraph>::null_face())
    {
      throw std::logic_error("test mesh " + indexed.name + " is not a 2-manifold");
    }
    if(faces_of_triangles != nullptr)
    {
      faces_of_triangles->push_back(f);
    }
  }
  return vertices_of_points;
}

template <class FaceGraph = Mesh>
FaceGraph to_face_graph(const Indexed_mesh& indexed)
{
  FaceGraph tm;
  add_to_face_graph(indexed, tm);
  return tm;
}

inline Indexed_mesh to_indexed_mesh(const Mesh& tm, const std::string& name)
{
  Indexed_mesh indexed;
  indexed.name = name;
  std::map<vertex_descriptor, std::size_t> index_of;
  for(const vertex_descriptor v : vertices(tm))
  {
    index_of[v] = indexed.points.size();
    const auto& p = tm.point(v);
    indexed.points.push_back({p.x(), p.y(), p.z()});
  }
  for(const face_descriptor f : faces(tm))
  {
    const auto h = halfedge(f, tm);
    indexed.faces.push_back(
      {index_of[source(h, tm)], index_of[target(h, tm)], index_of[target(next(h, tm), tm)]});
  }
  return indexed;
}

// ---------------------------------------------------------------------------
// operations on meshes
// ---------------------------------------------------------------------------

// Every triangle becomes four; old vertices keep their indices.
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

// Vertex i moves to place new_index[i]; the order of the faces and the first
// corner of every face change too.
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

// Splits face `face` at the point with the given barycentric coordinates (in the
// order of its corners); the point becomes the last vertex.
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

// Splits the edge ab, and its one or two faces, at the point a + t (b - a); the
// point becomes the last vertex.
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

// Splits the face at the point a + t (b - a) of its side k = (a, b), but not the
// neighbour: a cap, a face of area zero, fills the slit. The point becomes the last
// vertex; the surface stays what it was.
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

// Removes every face for which the predicate holds; vertices stay, also isolated ones.
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

// ---------------------------------------------------------------------------
// generators
// ---------------------------------------------------------------------------

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
      mesh.faces.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.faces.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return mesh;
}

// m columns around, n rows; point(i, j) gives the vertex of column i, row j
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
      mesh.faces.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.faces.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
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

// An open prism with m sides; a twist turns its long faces into needles.
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
                     // every row is turned by half a column against the one below
                     const double s =
                       2. * pi * (static_cast<double>(i) - .5 * static_cast<double>(j)) / static_cast<double>(m);
                     return Coordinates{std::cos(s), std::sin(s),
                                        static_cast<double>(j) / static_cast<double>(n)};
                   });
}

// (m + 1) x (n + 1) vertices (index i (n + 1) + j); `diagonal(i, j)` chooses one of
// the two diagonals of a cell
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
      if(diagonal(i, j))
      {
        mesh.faces.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
        mesh.faces.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
      }
      else
      {
        mesh.faces.push_back({id(i, j), id(i + 1, j), id(i, j + 1)});
        mesh.faces.push_back({id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
      }
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

// a flat convex patch; interior vertices move in the plane by at most `jitter`
// times the size of a cell; below 1/6 no face turns over
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

// rows of characters; each '#' is a unit square of the plane (row r, column c:
// [c, c+1] x [r, r+1]) cut into n x n squares of two triangles each
inline Indexed_mesh plane_cells(const std::string& name, const std::vector<std::string>& rows, std::size_t n = 1)
{
  Indexed_mesh mesh;
  mesh.name = name;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> index_of;
  auto id = [&](std::size_t x, std::size_t y) {
    const auto inserted = index_of.insert({{x, y}, mesh.points.size()});
    if(inserted.second)
    {
      mesh.points.push_back(
        {static_cast<double>(x) / static_cast<double>(n), static_cast<double>(y) / static_cast<double>(n), 0.});
    }
    return inserted.first->second;
  };
  for(std::size_t y = 0; y < rows.size() * n; ++y)
  {
    for(std::size_t x = 0; x < rows[y / n].size() * n; ++x)
    {
      if(rows[y / n][x / n] != '#')
      {
        continue;
      }
      const std::size_t a = id(x, y);
      const std::size_t b = id(x + 1, y);
      const std::size_t c = id(x + 1, y + 1);
      const std::size_t d = id(x, y + 1);
      if((x + y) % 2 == 0)
      {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
      }
      else
      {
        mesh.faces.push_back({a, b, d});
        mesh.faces.push_back({b, c, d});
      }
    }
  }
  return mesh;
}

// layers[z][y][x] == '#' is a solid unit cube; the result is the boundary of the solid
inline Indexed_mesh voxel_surface(const std::string& name, const std::vector<std::vector<std::string>>& layers)
{
  using Lattice_point = std::array<int, 3>;
  Indexed_mesh mesh;
  mesh.name = name;
  std::map<std::tuple<int, int, int>, std::size_t> index_of;
  auto id = [&](const Lattice_point& p) {
    const auto inserted = index_of.insert({std::make_tuple(p[0], p[1], p[2]), mesh.points.size()});
    if(inserted.second)
    {
      mesh.points.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    }
    return inserted.first->second;
  };
  auto is_solid = [&](int x, int y, int z) {
    if(z < 0 || z >= static_cast<int>(layers.size()))
    {
      return false;
    }
    const std::vector<std::string>& layer = layers[static_cast<std::size_t>(z)];
    if(y < 0 || y >= static_cast<int>(layer.size()))
    {
      return false;
    }
    const std::string& row = layer[static_cast<std::size_t>(y)];
    return x >= 0 && x < static_cast<int>(row.size()) && row[static_cast<std::size_t>(x)] == '#';
  };
  for(int z = 0; z < static_cast<int>(layers.size()); ++z)
  {
    for(int y = 0; y < static_cast<int>(layers[static_cast<std::size_t>(z)].size()); ++y)
    {
      const std::string& row = layers[static_cast<std::size_t>(z)][static_cast<std::size_t>(y)];
      for(int x = 0; x < static_cast<int>(row.size()); ++x)
      {
        if(!is_solid(x, y, z))
        {
          continue;
        }
        for(std::size_t axis = 0; axis < 3; ++axis)
        {
          for(int side = 0; side < 2; ++side)
          {
            Lattice_point neighbor{x, y, z};
            neighbor[axis] += side == 1 ? 1 : -1;
            if(is_solid(neighbor[0], neighbor[1], neighbor[2]))
            {
              continue;
            }
            const std::size_t first_axis = (axis + 1) % 3;
            const std::size_t second_axis = (axis + 2) % 3;
            std::array<Lattice_point, 4> corners;
            corners.fill({x, y, z});
            for(Lattice_point& corner : corners)
            {
              corner[axis] += side;
            }
            corners[1][first_axis] += 1;
            corners[2][first_axis] += 1;
            corners[2][second_axis] += 1;
            corners[3][second_axis] += 1;
            if(side == 0)
            {
              std::swap(corners[1], corners[3]);
            }
            mesh.faces.push_back({id(corners[0]), id(corners[1]), id(corners[2])});
            mesh.faces.push_back({id(corners[0]), id(corners[2]), id(corners[3])});
          }
        }
      }
    }
  }
  return mesh;
}

inline Indexed_mesh cube()
{
  return voxel_surface("cube", {{"#"}});
}

// the cube [0, n]^3 with n x n cells per side
inline Indexed_mesh cube_grid(std::size_t n)
{
  return voxel_surface("cube grid", std::vector<std::vector<std::string>>(
                                      n, std::vector<std::string>(n, std::string(n, '#'))));
}

inline Indexed_mesh genus_2_polycube()
{
  return voxel_surface("genus 2 polycube", {{"#####", "#.#.#", "#####"}});
}

inline Indexed_mesh genus_3_polycube()
{
  return voxel_surface("genus 3 polycube", {{"#######", "#.#.#.#", "#######"}});
}

// a cube with three crossing tunnels, genus 5, all angles and most distances tied
inline Indexed_mesh Menger_sponge()
{
  return voxel_surface("Menger sponge", {{"###", "#.#", "###"}, {"#.#", "...", "#.#"}, {"###", "#.#", "###"}});
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

// m meridians, n parallels: many meridians give needles, and caps at the poles
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
      mesh.faces.push_back({id(i, j), id(i, j + 1), id(i + 1, j + 1)});
      mesh.faces.push_back({id(i, j), id(i + 1, j + 1), id(i + 1, j)});
    }
    mesh.faces.push_back({south, id(i + 1, n - 1), id(i, n - 1)});
  }
  return mesh;
}

// A tetrahedron whose faces are split again and again at random points, often
// close to an edge, some of them pulled far out: spikes, needles and caps.
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

// n triangles around vertex 0 at the origin, in one plane up or down each: with
// slope 0 flat, with `radius_z` alternating a saddle, with constant z a cone
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

// two apices over a regular polygon: valence n at both
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

inline Indexed_mesh strip(std::size_t n)
{
  return plane_cells("strip", {std::string(n, '#')});
}

inline Indexed_mesh spiral_corridor(std::size_t n = 1)
{
  return plane_cells("spiral corridor",
                     {"#########",
                      "........#",
                      "#######.#",
                      "#.....#.#",
                      "#.###.#.#",
                      "#.#...#.#",
                      "#.#####.#",
                      "#.......#",
                      "#########"},
                     n);
}

inline Indexed_mesh square_with_holes(std::size_t n = 1)
{
  return plane_cells("square with holes", {"#######", "#.###.#", "###.###", "#.###.#", "#######"}, n);
}

// adds a mesh to another one; its vertex `common`, if it has one of this number, becomes vertex `of` of the first.
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

// Two meshes as one, which has no vertex that both share.
inline Indexed_mesh side_by_side(const Indexed_mesh& first, const Indexed_mesh& second, const std::string& name)
{
  Indexed_mesh mesh = first;
  join(mesh, second);
  mesh.name = name;
  return mesh;
}

inline Indexed_mesh two_components_and_an_isolated_vertex()
{
  Indexed_mesh mesh = side_by_side(icosphere(1), saddle_patch(4), "two components and an isolated vertex");
  mesh.points.push_back({9, 9, 9});
  return mesh;
}

// A mesh with random faces taken away: borders everywhere, pinched and isolated
// vertices, several components.
inline Indexed_mesh random_cuts(const Indexed_mesh& mesh, double share, std::uint64_t seed)
{
  test_support::Random random(seed);
  return without_faces(mesh, mesh.name + ", random cuts", [&](std::size_t) { return random.uniform() < share; });
}

// The collection for comparisons with other programs: each mesh has at most a few
// thousand faces, no zero-length edge and no face of area zero.
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

// the smaller ones, for tests that run many times on each mesh
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
