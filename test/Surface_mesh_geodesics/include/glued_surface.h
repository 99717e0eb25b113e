#ifndef SURFACE_MESH_GEODESICS_GLUED_SURFACE_H
#define SURFACE_MESH_GEODESICS_GLUED_SURFACE_H

// Triangles with given lengths, glued along their sides in any way: two sides of one triangle with each other, or two
// triangles along several sides. A triangle mesh is the special case in which a face has three different vertices, and
// two vertices have at most one edge. Points can be inserted as vertices, in any number type.

#include "test_meshes.h"

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_meshes {

const std::size_t no_side = (std::numeric_limits<std::size_t>::max)();

// The sides of one edge have the same index in `edges`. An edge has one side on the border, else two of opposite
// direction. Side k leads from corner k of its face to the next corner. The points of the mesh are ignored.
template <class FT>
struct Glued_surface
{
  Indexed_mesh mesh;
  std::vector<std::array<std::size_t, 3>> edges;
  std::vector<FT> lengths; // by edge

  const FT& length(std::size_t f, std::size_t k) const { return lengths[edges[f][k % 3]]; }

  // For each side, 3 * face + side of the side glued to it, or no_side.
  std::vector<std::array<std::size_t, 3>> neighbors() const
  {
    std::vector<std::array<std::size_t, 3>> result(edges.size(), {no_side, no_side, no_side});
    std::vector<std::size_t> first(lengths.size(), no_side);
    for(std::size_t s = 0; s < 3 * edges.size(); ++s)
    {
      std::size_t& other = first[edges[s / 3][s % 3]];
      if(other != no_side)
      {
        result[s / 3][s % 3] = other;
        result[other / 3][other % 3] = s;
      }
      else
      {
        other = s;
      }
    }
    return result;
  }

  // Returns whether this is a triangle mesh: two vertices have at most one edge, a face has three different vertices,
  // and the two faces of an edge have the same orientation.
  bool is_triangle_mesh() const
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> edge_of_ends;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> side_of;
    for(std::size_t s = 0; s < 3 * edges.size(); ++s)
    {
      const std::size_t a = mesh.faces[s / 3][s % 3], b = mesh.faces[s / 3][(s % 3 + 1) % 3];
      const std::size_t e = edges[s / 3][s % 3];
      if(a == b || edge_of_ends.insert({std::minmax(a, b), e}).first->second != e
         || !side_of.insert({{a, b}, s}).second)
      {
        return false;
      }
    }
    return true;
  }
};

// The surface of a mesh in space. Edges are identified by their ends.
template <class FT>
Glued_surface<FT> glued_surface(const Indexed_mesh& mesh)
{
  using std::sqrt;
  Glued_surface<FT> surface;
  surface.mesh = mesh;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> edge_of_ends;
  for(const Triangle& t : mesh.faces)
  {
    surface.edges.push_back({});
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t a = t[k], b = t[(k + 1) % 3];
      const auto inserted = edge_of_ends.insert({std::minmax(a, b), surface.lengths.size()});
      if(inserted.second)
      {
        FT square(0);
        for(std::size_t i = 0; i < 3; ++i)
        {
          const FT d = FT(mesh.points[a][i]) - FT(mesh.points[b][i]);
          square += d * d;
        }
        surface.lengths.push_back(FT(sqrt(square)));
      }
      surface.edges.back()[k] = inserted.first->second;
    }
  }
  return surface;
}

inline bool has_vertex_twice_in_face(const Indexed_mesh& mesh)
{
  return std::any_of(mesh.faces.begin(), mesh.faces.end(),
                     [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

// Splits every triangle into four, without rounding any length.
template <class FT>
Glued_surface<FT> midpoint_subdivision(const Glued_surface<FT>& surface)
{
  Glued_surface<FT> result;
  result.mesh.name = surface.mesh.name;
  result.mesh.points = surface.mesh.points;
  result.mesh.points.resize(surface.mesh.points.size() + surface.lengths.size());
  for(const FT& length : surface.lengths) // the halves of edge e are 2 e and 2 e + 1
  {
    result.lengths.insert(result.lengths.end(), 2, FT(length / 2));
  }
  std::vector<bool> is_met(surface.lengths.size(), false);
  for(std::size_t f = 0; f < surface.edges.size(); ++f)
  {
    std::array<std::size_t, 3> middle{}, first{}, second{}, inner{};
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t e = surface.edges[f][k];
      middle[k] = surface.mesh.points.size() + e;
      first[k] = is_met[e] ? 2 * e + 1 : 2 * e;
      second[k] = is_met[e] ? 2 * e : 2 * e + 1;
      is_met[e] = true;
      inner[k] = result.lengths.size(); // from the midpoint of side k to the midpoint of the next side
      result.lengths.push_back(FT(surface.length(f, k + 2) / 2));
    }
    for(std::size_t k = 0; k < 3; ++k)
    {
      result.mesh.faces.push_back({surface.mesh.faces[f][k], middle[k], middle[(k + 2) % 3]});
      result.edges.push_back({first[k], inner[(k + 2) % 3], second[(k + 2) % 3]});
    }
    result.mesh.faces.push_back(middle);
    result.edges.push_back(inner);
  }
  return result;
}

// Inserts a point of a face as a vertex, unless it is a vertex. Returns the vertex. `coordinates` are barycentric.
template <class FT>
class Point_insertion
{
public:
  explicit Point_insertion(Glued_surface<FT>& surface) : m_surface(surface) {}

  std::size_t insert(std::size_t f, std::array<FT, 3> coordinates)
  {
    const FT sum = coordinates[0] + coordinates[1] + coordinates[2];
    std::size_t number_of_zeros = 0, zero = 0, largest = 0;
    for(std::size_t k = 0; k < 3; ++k)
    {
      coordinates[k] /= sum;
      largest = coordinates[k] > coordinates[largest] ? k : largest;
      if(!(coordinates[k] > FT(0)))
      {
        zero = k;
        ++number_of_zeros;
      }
    }
    if(number_of_zeros >= 2)
    {
      return m_surface.mesh.faces[f][largest];
    }
    if(number_of_zeros == 1)
    {
      return split_edge(f, (zero + 1) % 3, coordinates[(zero + 2) % 3]);
    }
    return split_face(f, coordinates);
  }

private:
  struct Point
  {
    FT x, y;
  };

  std::size_t add_vertex()
  {
    m_surface.mesh.points.push_back({0., 0., 0.});
    return m_surface.mesh.points.size() - 1;
  }

  std::size_t add_edge(const FT& length)
  {
    m_surface.lengths.push_back(length);
    return m_surface.lengths.size() - 1;
  }

  static FT distance(const Point& a, const Point& b)
  {
    using std::sqrt;
    return sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
  }

  // The corners in the plane: k at the origin, the next one on the axis.
  std::array<Point, 3> layout(std::size_t f, std::size_t k) const
  {
    using std::sqrt;
    const FT base = m_surface.length(f, k), right = m_surface.length(f, k + 1), left = m_surface.length(f, k + 2);
    const FT x = base > FT(0) ? FT((base + (left - right) * (left + right) / base) / 2) : FT(0);
    const FT square = (left - x) * (left + x);
    return {Point{FT(0), FT(0)}, Point{base, FT(0)}, Point{x, square > FT(0) ? FT(sqrt(square)) : FT(0)}};
  }

  std::size_t split_face(std::size_t f, const std::array<FT, 3>& c)
  {
    const std::array<Point, 3> p = layout(f, 0);
    const Point new_vertex = {c[1] * p[1].x + c[2] * p[2].x, c[2] * p[2].y};
    const std::size_t v = add_vertex();
    std::array<std::size_t, 3> spoke{};
    for(std::size_t k = 0; k < 3; ++k)
    {
      spoke[k] = add_edge(distance(new_vertex, p[k]));
    }
    const Triangle t = m_surface.mesh.faces[f];
    const std::array<std::size_t, 3> e = m_surface.edges[f];
    m_surface.mesh.faces[f] = {t[0], t[1], v};
    m_surface.edges[f] = {e[0], spoke[1], spoke[0]};
    m_surface.mesh.faces.push_back({t[1], t[2], v});
    m_surface.edges.push_back({e[1], spoke[2], spoke[1]});
    m_surface.mesh.faces.push_back({t[2], t[0], v});
    m_surface.edges.push_back({e[2], spoke[0], spoke[2]});
    return v;
  }

  // `share` is the parameter in [0, 1] of the point between corner k of f and the next corner
  std::size_t split_edge(std::size_t f, std::size_t k, const FT& share)
  {
    const std::size_t e = m_surface.edges[f][k], v = add_vertex();
    const std::size_t first = add_edge(share * m_surface.lengths[e]),
                      second = add_edge((FT(1) - share) * m_surface.lengths[e]);
    split_side(f, k, v, share, first, second);
    for(std::size_t g = 0; g < m_surface.edges.size(); ++g)
    {
      for(std::size_t j = 0; j < 3; ++j)
      {
        if(m_surface.edges[g][j] == e)
        {
          split_side(g, j, v, FT(1) - share, second, first);
        }
      }
    }
    return v;
  }

  void split_side(std::size_t f, std::size_t k, std::size_t v, const FT& share, std::size_t first, std::size_t second)
  {
    const std::array<Point, 3> p = layout(f, k);
    const std::size_t middle = add_edge(distance({share * p[1].x, FT(0)}, p[2]));
    const Triangle t = m_surface.mesh.faces[f];
    const std::array<std::size_t, 3> e = m_surface.edges[f];
    const std::size_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    m_surface.mesh.faces[f] = {a, v, c};
    m_surface.edges[f] = {first, middle, e[(k + 2) % 3]};
    m_surface.mesh.faces.push_back({v, b, c});
    m_surface.edges.push_back({second, e[(k + 1) % 3], middle});
  }

  Glued_surface<FT>& m_surface;
};

// A halfedge data structure with the same vertices and faces, in the same order; halfedge(f) is side 0. Stores the edge
// of each side in `edge_of_side`.
inline Mesh to_face_graph(const Glued_surface<double>& surface,
                          std::vector<std::array<Mesh::Edge_index, 3>>& edge_of_side)
{
  Mesh tm;
  for(const Coordinates& p : surface.mesh.points)
  {
    tm.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  }
  const std::vector<std::array<std::size_t, 3>> neighbors = surface.neighbors();
  std::vector<Mesh::Halfedge_index> halfedge_of_side(3 * surface.edges.size());
  edge_of_side.assign(surface.edges.size(), {});
  for(std::size_t s = 0; s < halfedge_of_side.size(); ++s)
  {
    const std::size_t other = neighbors[s / 3][s % 3];
    const bool is_second = other != no_side && other < s;
    halfedge_of_side[s] = is_second ? tm.opposite(halfedge_of_side[other]) : tm.add_edge();
    edge_of_side[s / 3][s % 3] = tm.edge(halfedge_of_side[s]);
  }
  for(std::size_t f = 0; f < surface.edges.size(); ++f)
  {
    const face_descriptor face = tm.add_face();
    tm.set_halfedge(face, halfedge_of_side[3 * f]);
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Mesh::Halfedge_index h = halfedge_of_side[3 * f + k];
      const auto number = [&](std::size_t corner)
      { return vertex_descriptor(static_cast<Mesh::size_type>(surface.mesh.faces[f][corner % 3])); };
      tm.set_face(h, face);
      tm.set_target(h, number(k + 1));
      tm.set_target(tm.opposite(h), number(k));
      tm.set_next(h, halfedge_of_side[3 * f + (k + 1) % 3]);
      tm.set_halfedge(number(k + 1), h);
    }
  }
  // Along the border, the next halfedge is found by going around the vertex.
  for(const Mesh::Halfedge_index h : tm.halfedges())
  {
    if(tm.face(h) == Mesh::null_face())
    {
      Mesh::Halfedge_index next = tm.opposite(h);
      while(tm.face(next) != Mesh::null_face())
      {
        next = tm.opposite(tm.prev(next));
      }
      tm.set_next(h, next);
      tm.set_halfedge(tm.target(h), h);
    }
  }
  return tm;
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_GLUED_SURFACE_H
