// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_INTRINSIC_MESH_BUILDER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_INTRINSIC_MESH_BUILDER_H

// Builds an intrinsic mesh from the connectivity of a triangle mesh, given by positions, and a function that shapes a
// face. The mesh of a user is read elsewhere (interface/Face_graph_reader.h).
//
// Faces are numbered breadth first, and vertices in the order in which the faces meet them: the records that the
// wavefront works on at a time then lie together in memory.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/face_shape.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The faces of a triangle mesh by position: face f has the corners corners[f], which are indices of vertices, and
// neighbors[f][j] is 4 * (position of the face across edge j) + (the edge there), or null_id at the border. Edge j
// leads from corner j to corner j+1.
struct Face_connectivity
{
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::array<Halfedge_id, 3>> neighbors;
};

// Call the member functions in the order in which they stand. Throws Invalid_geodesic_input; its element() is the
// position of a face.
template <typename FT>
class Intrinsic_mesh_builder
{
  using Reason = Invalid_geodesic_input::Reason;

public:
  // Numbers the faces. Takes linear time.
  explicit Intrinsic_mesh_builder(Face_connectivity connectivity) : m_connectivity(std::move(connectivity))
  {
    number_faces();
  }

  // Numbers the vertices of the faces, in the order of the faces: sets vertex_of_index[index] to their numbers, and
  // returns how many there are.
  // Requires: all entries are null_id, and each corner is smaller than the size.
  std::size_t number_vertices(std::vector<Vertex_id>& vertex_of_index)
  {
    std::size_t n = 0;
    for(const std::uint32_t position : m_order)
      for(std::uint32_t& corner : m_connectivity.corners[position])
        corner = number_of(corner, vertex_of_index, n);
    return n;
  }

  // Returns the number of the vertex with an index, which is n if it has none yet; n grows then.
  static Vertex_id number_of(std::uint32_t index, std::vector<Vertex_id>& vertex_of_index, std::size_t& n)
  {
    CGAL_assertion(index < vertex_of_index.size());
    Vertex_id& id = vertex_of_index[index];
    const bool is_new = id == null_id;
    id = is_new ? static_cast<Vertex_id>(n) : id;
    n += is_new;
    return id;
  }

  // Makes the faces. shape(position, vertices, face) sets the lengths and the layout of a face, and returns which of
  // its edges becomes halfedge 0. Throws if two faces disagree about the ends of their edge.
  template <typename Shape>
  void set_faces(Shape shape, Intrinsic_mesh<FT>& mesh)
  {
    const Face_id n = static_cast<Face_id>(m_order.size());
    mesh.reset(n);
    for(Face_id i = 0; i < n; ++i)
    {
      const std::uint32_t f = m_order[i];
      Intrinsic_face<FT>& face = mesh.face(i);
      const std::array<Vertex_id, 3>& v = m_connectivity.corners[f];
      const unsigned int shift = shape(f, v, face);
      for(unsigned int k = 0; k < 3; ++k)
        face.vertex[k] = v[corner_after(k, shift)];
      m_name[f] = halfedge_of(i, corners_to_first(shift));
    }
    for(Face_id i = 0; i < n; ++i)
      link_face(i, mesh);
  }

  // Stores the sizes of edge components, if there are several. Throws if a component would vanish beside the others, as
  // all lengths have one unit; has_length(position) tells whether a face has an edge with a length before scaling. (A
  // component may have no lengths at all.)
  template <typename Has_length>
  void set_edge_components(Has_length has_length, Intrinsic_mesh<FT>& mesh) const
  {
    const std::size_t n = m_first_of_component.size();
    if(n < 2)
      return;
    std::vector<typename Intrinsic_mesh<FT>::Edge_component> components;
    components.reserve(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      const Face_id first = m_first_of_component[i],
                    last = i + 1 < n ? m_first_of_component[i + 1] : static_cast<Face_id>(m_order.size());
      FT longest = 0;
      for(Face_id f = first; f < last; ++f)
        longest = (std::max)(longest, longest_side(mesh.face(f)));
      if(longest < smallest_component())
        refuse_lengths(has_length, first, last);
      components.push_back({first, longest});
    }
    mesh.set_edge_components(components);
  }

  // Returns the position of a face of the mesh.
  std::uint32_t position_of(Face_id f) const { return m_order[f]; }

  // Returns the halfedge of the mesh that is 4 * position + edge in the connectivity; null_id for null_id.
  // Requires: the faces are set.
  Halfedge_id halfedge_at(Halfedge_id h) const
  {
    if(h == null_id)
      return null_id;
    CGAL_assertion(face_of(h) < m_name.size());
    const Halfedge_id first = m_name[face_of(h)];
    return halfedge_of(face_of(first), corner_after(index_in_face(h), index_in_face(first)));
  }

private:
  // Numbers breadth first; each component starts from its first face.
  void number_faces()
  {
    const std::size_t n = m_connectivity.corners.size();
    m_order.resize(n + 1); // one more: append() may write an entry that does not count
    m_name.assign(n, null_id);
    std::size_t end = 0, next = 0; // of m_order; of what has been visited
    for(std::uint32_t first = 0; first < n; ++first)
    {
      append(first, end);
      if(next < end)
        m_first_of_component.push_back(static_cast<Face_id>(next));
      for(; next < end; ++next)
        for(const Halfedge_id o : m_connectivity.neighbors[m_order[next]])
          if(o != null_id)
            append(face_of(o), end);
    }
    m_order.resize(n);
  }

  // Appends the face at a position to the order, unless it is there. (Without a branch, as none could be predicted.)
  void append(std::uint32_t position, std::size_t& end)
  {
    const bool is_new = m_name[position] == null_id;
    m_order[end] = position;
    m_name[position] = is_new ? static_cast<Face_id>(end) : m_name[position];
    end += is_new;
  }

  void link_face(Face_id i, Intrinsic_mesh<FT>& mesh) const
  {
    const std::uint32_t f = m_order[i];
    const unsigned int first = index_in_face(m_name[f]);
    for(unsigned int j = 0; j < 3; ++j)
    {
      const Halfedge_id h = halfedge_of(i, corner_after(j, first)), o = halfedge_at(m_connectivity.neighbors[f][j]);
      if(o != null_id && (mesh.source(o) != mesh.target(h) || mesh.target(o) != mesh.source(h)))
        throw Invalid_geodesic_input(Reason::NON_MANIFOLD,
                                     "face " + std::to_string(f) + " and its neighbor disagree about the ends of "
                                       + "their edge", f);
      mesh.face(i).opposite[index_in_face(h)] = o;
    }
  }

  template <typename Has_length>
  void refuse_lengths(Has_length has_length, Face_id first, Face_id last) const
  {
    for(Face_id i = first; i < last; ++i)
      if(has_length(m_order[i]))
        throw Invalid_geodesic_input(Reason::TOO_SMALL,
                                     "face " + std::to_string(m_order[i]) + " is in a component that is too small "
                                       + "beside the mesh", m_order[i]);
  }

  Face_connectivity m_connectivity; // the corners become vertices in number_vertices()
  std::vector<std::uint32_t> m_order; // the position of a face of the mesh
  // By position: the number of the face; after set_faces(), the halfedge of the mesh that is edge 0.
  std::vector<std::uint32_t> m_name;
  std::vector<Face_id> m_first_of_component;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_INTRINSIC_MESH_BUILDER_H
