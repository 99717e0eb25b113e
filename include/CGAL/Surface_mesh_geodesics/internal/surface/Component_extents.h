// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_COMPONENT_EXTENTS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_COMPONENT_EXTENTS_H

// The extent of each component of a mesh: the length of its longest edge. Where components differ in size, rounding is
// relative to the extent of the component, as the others may be far larger.
//
// Components are connected across vertices: faces that share a pinched vertex are in one. (The
// *edge components* of Intrinsic_mesh::extent_around() are connected across edges.)

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/assertions.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Components from the faces of any mesh whose vertices have the indices 0 .. n-1. Call add_face() for all faces, then
// finish(), then the queries. Takes almost linear time in all, and constant time for a query. The result does not
// depend on the order of the faces, except which vertex represents a component. All lengths are in one unit, that of
// the caller.
template <typename FT>
class Component_extents
{
public:
  explicit Component_extents(std::size_t number_of_vertices)
    : m_component(number_of_vertices), m_rank(number_of_vertices), m_longest_edge(number_of_vertices, FT(0))
  {
    Sets all = sets();
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      all.make_set(v);
  }

  // Adds a face with its corners and its longest edge, which is kept at corner 0 until finish() knows the components.
  void add_face(const std::array<std::size_t, 3>& corner, const FT& longest_edge)
  {
    Sets all = sets();
    all.union_set(corner[0], corner[1]);
    all.union_set(corner[0], corner[2]);
    m_longest_edge[corner[0]] = (std::max)(m_longest_edge[corner[0]], longest_edge);
  }

  // Finds the component of each vertex and its longest edge.
  void finish()
  {
    Sets all = sets();
    for(std::size_t v = 0; v < m_component.size(); ++v)
    {
      m_component[v] = all.find_set(v);
      FT& longest = m_longest_edge[m_component[v]];
      longest = (std::max)(longest, m_longest_edge[v]);
    }
  }

  // Returns the representative of the component of a vertex: the same vertex for all vertices of the component.
  // Requires: finish() has been called.
  std::size_t component(std::size_t v) const
  {
    CGAL_assertion(m_component[m_component[v]] == m_component[v]);
    return m_component[v];
  }

  // Returns the longest edge of the component of a vertex, 0 for an isolated one. Requires: finish() has been called.
  const FT& extent(std::size_t v) const { return m_longest_edge[component(v)]; }

private:
  using Sets = boost::disjoint_sets<std::size_t*, std::size_t*>;

  // A view of the two arrays, which hold the whole state. (boost::disjoint_sets owns nothing.)
  Sets sets() { return Sets(m_rank.data(), m_component.data()); }

  std::vector<std::size_t> m_component, m_rank; // the parents in the forest of disjoint sets; after finish(), the roots
  std::vector<FT> m_longest_edge;               // of the faces added at a vertex; after finish(), valid at the roots
};

// Returns, for each vertex of a mesh, the extent of its component, in the unit of the mesh. Takes almost linear time.
template <typename FT>
std::vector<FT> extents_of_components(const Intrinsic_mesh<FT>& mesh)
{
  Component_extents<FT> components(mesh.number_of_vertices());
  for(Face_id f = 0; f < mesh.number_of_faces(); ++f)
  {
    const Intrinsic_face<FT>& face = mesh.face(f);
    components.add_face({face.vertex[0], face.vertex[1], face.vertex[2]}, longest_side(face));
  }
  components.finish();
  std::vector<FT> extents(mesh.number_of_vertices());
  for(std::size_t v = 0; v < extents.size(); ++v)
    extents[v] = components.extent(v);
  return extents;
}

// Calls visit(v) for each vertex that is connected with one of `stack` through faces, including these. The order is
// unspecified. Marks each vertex in `is_known`. Takes time linear in the number of faces of these components. The
// caller owns the marks because it may visit one component after another, and clearing them each time would take time
// linear in the size of the mesh.
// Requires: is_known[v] is 0 for all vertices of these components; `stack` has no vertex twice.
template <typename FT, typename Visit>
void for_each_connected_vertex(const Intrinsic_mesh<FT>& mesh, std::vector<Vertex_id> stack,
                               std::vector<char>& is_known, Visit visit)
{
  CGAL_assertion(is_known.size() == mesh.number_of_vertices());
  for(const Vertex_id v : stack)
    is_known[v] = 1;
  const auto add = [&](Vertex_id v)
  {
    if(is_known[v] == 0)
      stack.push_back(v);
    is_known[v] = 1;
  };
  while(!stack.empty())
  {
    const Vertex_id v = stack.back();
    stack.pop_back();
    visit(v);
    mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
    {
      add(mesh.target(h));
      add(mesh.source(previous_halfedge(h)));
    });
  }
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_COMPONENT_EXTENTS_H
