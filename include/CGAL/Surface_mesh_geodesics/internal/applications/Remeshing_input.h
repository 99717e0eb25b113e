// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_REMESHING_INPUT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_REMESHING_INPUT_H

// The surface that is remeshed: a copy of the user's mesh in which each vertex has one umbrella of faces. Where the
// mesh is pinched, the copy has several vertices at one point, as no manifold mesh could follow it there. Faces to
// avoid are not in the copy: it has a border where they were.

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The copy keeps the order of vertices and faces, so ties are decided as on the user's mesh. All users' meshes become
// the same type here, so a program compiles the remeshing once. Splitting changes distances: no path passes a pinched
// vertex any more. That is right here, as samples on the other side of such a vertex are no neighbors in the new mesh.
//
// An object is constant, and may be read by several threads.
class Remeshing_input
{
public:
  using Kernel = Simple_cartesian<double>;
  using Mesh = Surface_mesh<Kernel::Point_3>;
  using Vertex = Mesh::Vertex_index;
  using Face = Mesh::Face_index;

  // A connected part of the copy. It has at least one face: vertices without faces are in no component.
  struct Component
  {
    std::size_t number_of_vertices = 0;
    std::vector<Face> faces;
  };

  // Copies a mesh, with its vertices and faces in their order. `is_avoided` has a flag for each face, in that order, or
  // is empty; faces with a flag are left out. Requires: the other faces are triangles, and no two faces contradict each
  // other. Takes linear time.
  template <typename TriangleMesh, typename VertexPointMap>
  Remeshing_input(const TriangleMesh& tm, VertexPointMap vpm, const std::vector<char>& is_avoided)
  {
    copy_face_graph(tm, m_mesh, parameters::vertex_point_map(vpm));
    // CGAL removes a vertex when the last face of an umbrella goes, so vertices are split before faces are removed.
    std::vector<std::vector<Vertex>> split;
    m_number_of_splits = Polygon_mesh_processing::duplicate_non_manifold_vertices(
      m_mesh, parameters::output_iterator(std::back_inserter(split)));
    if(!is_avoided.empty())
      remove(is_avoided, split);
    collect_components();
  }

  Remeshing_input(const Remeshing_input&) = delete;
  Remeshing_input& operator=(const Remeshing_input&) = delete;

  const Mesh& mesh() const { return m_mesh; }

  // The number of vertices that were added where the mesh is pinched.
  std::size_t number_of_splits() const { return m_number_of_splits; }

  // The components in the order of their first faces.
  const std::vector<Component>& components() const { return m_components; }

  // The index of the component that a face belongs to. Takes constant time.
  std::size_t component_of(Face f) const { return m_component_of_face[f]; }

  // The component of one of its faces, as all of them are in one component. Requires: the vertex has a face.
  std::size_t component_of(Vertex v) const
  {
    const auto h = m_mesh.halfedge(v);
    return component_of(m_mesh.face(m_mesh.is_border(h) ? m_mesh.opposite(h) : h));
  }

private:
  // Removes the faces that have a flag, and the vertices that have no face then. Vertices have one umbrella before and
  // after that: the faces that are left around a vertex may touch there only. `split` has each vertex that was split
  // before, and its copies; copies that are left beside another one count.
  void remove(const std::vector<char>& is_avoided, const std::vector<std::vector<Vertex>>& split)
  {
    for(std::size_t f = 0; f < is_avoided.size(); ++f)
      if(is_avoided[f] != 0)
        Euler::remove_face(m_mesh.halfedge(Face(static_cast<Mesh::size_type>(f))), m_mesh);
    m_number_of_splits = 0;
    for(const std::vector<Vertex>& copies : split)
    {
      const std::size_t left = static_cast<std::size_t>(
        std::count_if(copies.begin(), copies.end(), [this](Vertex v) { return !m_mesh.is_removed(v); }));
      m_number_of_splits += left > 1 ? left - 1 : 0;
    }
    // Removed elements leave gaps; those that are left keep their order.
    Mesh rest;
    copy_face_graph(m_mesh, rest);
    m_mesh = std::move(rest);
    m_number_of_splits += Polygon_mesh_processing::duplicate_non_manifold_vertices(m_mesh);
  }

  // Faces are in one component if a way leads from face to face across edges. As vertices have one umbrella, a way
  // across vertices leads no farther. Takes linear time.
  void collect_components()
  {
    auto map = m_mesh.add_property_map<Face, std::size_t>("f:component").first;
    m_components.resize(Polygon_mesh_processing::connected_components(m_mesh, map));
    for(const Face f : m_mesh.faces())
    {
      m_component_of_face.push_back(map[f]);
      m_components[map[f]].faces.push_back(f);
    }
    // Copies of the mesh and its users need no map.
    m_mesh.remove_property_map(map);
    for(const Vertex v : m_mesh.vertices())
      if(!m_mesh.is_isolated(v))
        ++m_components[component_of(v)].number_of_vertices;
  }

  // Indices of faces and vertices have no gaps, as the copy leaves out what is removed.
  Mesh m_mesh;
  std::vector<std::size_t> m_component_of_face;
  std::vector<Component> m_components;
  std::size_t m_number_of_splits = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_REMESHING_INPUT_H
