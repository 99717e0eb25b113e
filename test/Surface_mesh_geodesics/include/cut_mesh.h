#ifndef SURFACE_MESH_GEODESICS_TEST_CUT_MESH_H
#define SURFACE_MESH_GEODESICS_TEST_CUT_MESH_H

// A mesh that has really been cut along walls: vertices at walls are there once for each side. Written apart from the
// package, with one union of corners for the whole mesh.
//
// Each face is divided into four first: the edge of a wall with two free ends would stay one edge otherwise, as both
// of its ends stay one vertex. Its middle is two vertices.

#include "Indexed_mesh.h"

#include <CGAL/Kernel/global_functions.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_meshes {

using edge_descriptor = boost::graph_traits<Mesh>::edge_descriptor;
using halfedge_descriptor = boost::graph_traits<Mesh>::halfedge_descriptor;
using Walls = std::set<edge_descriptor>;

class Cut_mesh
{
public:
  // Faces that are `removed` are left out. Requires: no element of tm has been removed.
  Cut_mesh(const Mesh& tm, const Walls& walls, const std::set<face_descriptor>& removed = {})
    : m_vertices(4 * num_faces(tm)), m_sector(12 * num_faces(tm)), m_umbrella(m_sector), copies(num_vertices(tm))
  {
    std::iota(m_sector.begin(), m_sector.end(), std::size_t(0));
    std::iota(m_umbrella.begin(), m_umbrella.end(), std::size_t(0));
    for(const face_descriptor f : tm.faces())
      divide(tm, f);
    // The corners on both sides of an inner edge are united, half by half.
    for(const edge_descriptor e : edges(tm))
    {
      const auto h = halfedge(e, tm), o = opposite(h, tm);
      if(is_border(h, tm) || is_border(o, tm) || removed.count(face(h, tm)) != 0 || removed.count(face(o, tm)) != 0)
        continue;
      const std::size_t f = face(h, tm), g = face(o, tm), i = number(tm, h), j = number(tm, o);
      const std::size_t i1 = (i + 1) % 3, j1 = (j + 1) % 3;
      const bool is_wall = walls.count(e) != 0;
      unite(corner(4 * f + i, 0), corner(4 * g + j1, 0), is_wall);   // the source of h
      unite(corner(4 * f + i, 1), corner(4 * g + j1, 2), is_wall);   // the middle, from both halves
      unite(corner(4 * f + i1, 2), corner(4 * g + j, 1), is_wall);
      unite(corner(4 * f + i1, 0), corner(4 * g + j, 0), is_wall);   // the target of h
    }
    make(tm, removed);
  }

  // The number of the sector of the face f at its vertex v: equal numbers are on one side of the walls there.
  std::size_t sector(face_descriptor f, vertex_descriptor v) const
  {
    std::size_t k = 0;
    while(m_vertices[4 * std::size_t(f) + k][0] != std::size_t(v))
      ++k;
    return root(m_sector, corner(4 * std::size_t(f) + k, 0));
  }

  // The same point in the cut mesh.
  Face_location location(face_descriptor f, const std::array<double, 3>& b) const { return location(f, b, b); }

  // The same in the part of the face that has another point, where both are in one part.
  Face_location location(face_descriptor f, const std::array<double, 3>& b, const std::array<double, 3>& inside) const
  {
    std::size_t part = 3;
    std::array<double, 3> c{1 - 2 * b[2], 1 - 2 * b[0], 1 - 2 * b[1]};
    for(std::size_t k = 0; k < 3; ++k)
      if(inside[k] >= .5)
      {
        part = k;
        c = {2 * b[k] - 1, 2 * b[(k + 1) % 3], 2 * b[(k + 2) % 3]};
      }
    const std::size_t s = 4 * std::size_t(f) + part;
    Face_location result(m_face.at(s), {0, 0, 0});
    for(std::size_t k = 0; k < 3; ++k)
    {
      auto g = halfedge(result.first, mesh);
      for(std::size_t i = 0; i < 3; ++i, g = next(g, mesh))
        if(source(g, mesh) == m_vertex_of_corner.at(corner(s, k)))
          result.second[i] = c[k];
    }
    return result;
  }

private:
  static std::size_t root(const std::vector<std::size_t>& sets, std::size_t i)
  {
    while(sets[i] != i)
      i = sets[i];
    return i;
  }

  static std::size_t corner(std::size_t part, std::size_t k) { return 3 * part + k; }

  void unite(std::size_t a, std::size_t b, bool is_wall)
  {
    m_umbrella[root(m_umbrella, a)] = root(m_umbrella, b);
    if(!is_wall)
      m_sector[root(m_sector, a)] = root(m_sector, b);
  }

  // The number of a halfedge in its face.
  static std::size_t number(const Mesh& tm, halfedge_descriptor h)
  {
    std::size_t k = 0;
    for(auto g = halfedge(face(h, tm), tm); g != h; g = next(g, tm))
      ++k;
    return k;
  }

  // Part k of a face is at its corner k, with the middles of the edges k and k - 1; part 3 has the three middles.
  // Vertices of the divided mesh: those of the mesh, then the middles of its edges.
  void divide(const Mesh& tm, face_descriptor f)
  {
    std::array<std::size_t, 3> v, m;
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, tm), tm))
    {
      v[number(tm, h)] = source(h, tm);
      m[number(tm, h)] = num_vertices(tm) + std::size_t(edge(h, tm));
    }
    const std::size_t first = 4 * std::size_t(f);
    m_vertices[first + 3] = m;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t before = (k + 2) % 3;
      m_vertices[first + k] = {v[k], m[k], m[before]};
      // Between part k and the part in the middle is the edge from m[k] to m[before].
      unite(corner(first + k, 1), corner(first + 3, k), false);
      unite(corner(first + k, 2), corner(first + 3, before), false);
    }
  }

  static Kernel::Point_3 point(const Mesh& tm, std::size_t v)
  {
    if(v < num_vertices(tm))
      return tm.point(vertex_descriptor(static_cast<Mesh::size_type>(v)));
    const edge_descriptor e(static_cast<Mesh::size_type>(v - num_vertices(tm)));
    return CGAL::midpoint(tm.point(source(e, tm)), tm.point(target(e, tm)));
  }

  void make(const Mesh& tm, const std::set<face_descriptor>& removed)
  {
    std::map<std::size_t, std::set<std::size_t>> umbrellas, sectors; // by vertex
    for(std::size_t s = 0; s < m_vertices.size(); ++s)
      for(std::size_t k = 0; k < 3; ++k)
        if(removed.count(face_descriptor(static_cast<Mesh::size_type>(s / 4))) == 0)
        {
          umbrellas[m_vertices[s][k]].insert(root(m_umbrella, corner(s, k)));
          sectors[m_vertices[s][k]].insert(root(m_sector, corner(s, k)));
        }
    for(const vertex_descriptor v : tm.vertices())
      if(sectors[v].empty())
        copies[v].push_back(mesh.add_vertex(tm.point(v)));
    std::map<std::pair<std::size_t, std::size_t>, vertex_descriptor> made;
    for(std::size_t s = 0; s < m_vertices.size(); ++s)
    {
      if(removed.count(face_descriptor(static_cast<Mesh::size_type>(s / 4))) != 0)
        continue;
      std::array<vertex_descriptor, 3> v;
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t w = m_vertices[s][k];
        const std::size_t side = sectors[w].size() > umbrellas[w].size() ? root(m_sector, corner(s, k)) : 0;
        const auto found = made.emplace(std::make_pair(w, side), vertex_descriptor());
        if(found.second)
        {
          found.first->second = mesh.add_vertex(point(tm, w));
          if(w < copies.size())
            copies[w].push_back(found.first->second);
        }
        v[k] = m_vertex_of_corner[corner(s, k)] = found.first->second;
      }
      m_face[s] = mesh.add_face(v[0], v[1], v[2]);
      if(m_face[s] == Mesh::null_face())
        throw std::logic_error("the cut mesh is no manifold");
    }
  }

  std::vector<std::array<std::size_t, 3>> m_vertices; // of the parts of faces
  std::vector<std::size_t> m_sector, m_umbrella;      // by corner of a part: the one before it in its set
  std::map<std::size_t, vertex_descriptor> m_vertex_of_corner;
  std::map<std::size_t, face_descriptor> m_face; // of a part

public:
  Mesh mesh;
  std::vector<std::vector<vertex_descriptor>> copies; // in the cut mesh, of each vertex
};

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_TEST_CUT_MESH_H
