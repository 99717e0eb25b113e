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
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/face_shape.h>

#include <CGAL/assertions.h>

#include <boost/pending/disjoint_sets.hpp>

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

// A face of a triangle mesh: the indices of its corners and of the faces across its edges. A neighbor that is not
// the index of a face stands for the border. Edge j leads from corner j to corner j+1. Corners are indices of the
// caller; number_vertices() replaces them by vertices of the mesh.
struct Connected_face
{
  std::array<std::uint32_t, 3> corner, neighbor;

  // Leaves the members uninitialized. (Without this constructor, a vector of faces would be zeroed before it is set.)
  Connected_face() {}
};

// Call the member functions in the order in which they stand; keep_components_of() may be left out. Throws
// Invalid_geodesic_input; its element() is the position of a face.
//
// The faces come in any order, and a neighbor may be anywhere in memory. They are put into their new order once, at the
// beginning. Everything after that reads memory from front to back.
template <typename FT>
class Intrinsic_mesh_builder
{
  using Reason = Invalid_geodesic_input::Reason;

public:
  // Numbers the faces. They are given by position, and their neighbors are positions as well. Takes linear time.
  explicit Intrinsic_mesh_builder(const std::vector<Connected_face>& faces) { number_faces(faces); }

  // Sets of faces that are connected across edges.
  std::size_t number_of_components() const { return m_first_of_component.size(); }

  // Drops the components from which no path leads to a wanted vertex, also through vertices that components share. The
  // numbers of the other faces stay in order. A component moves as a whole, to numbers that have become free before it,
  // so one shift serves all its faces and their neighbors. Takes almost linear time.
  // Requires: is_wanted has an entry for each index of a corner.
  void keep_components_of(const std::vector<char>& is_wanted)
  {
    const std::vector<char> is_kept = components_connected_to(is_wanted);
    std::vector<Face_id> first_of_component;
    Face_id end = 0;
    for(std::size_t c = 0; c < is_kept.size(); ++c)
    {
      const Face_id first = first_face(c), shift = first - end;
      if(is_kept[c] != 0)
        first_of_component.push_back(end);
      for(Face_id f = first; f < first_face(c + 1); ++f)
        if(is_kept[c] != 0)
          move_face(f, shift, end++);
        else
          m_name[m_order[f]] = null_id;
    }
    m_faces.resize(end);
    m_order.resize(end);
    m_first_of_component = std::move(first_of_component);
  }

  // Numbers the vertices of the faces, in the order of the faces: sets vertex_of_index[index] to their numbers, and
  // returns how many there are.
  // Requires: all entries are null_id, and each corner is smaller than the size.
  std::size_t number_vertices(std::vector<Vertex_id>& vertex_of_index)
  {
    std::size_t n = 0;
    for(Connected_face& face : m_faces)
      for(std::uint32_t& corner : face.corner)
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

  // Makes the faces, in blocks (One_block.h). shape(position, vertices, face) sets the lengths and the layout of a
  // face, and returns which of its edges becomes halfedge 0. Throws if two faces disagree about their edge.
  // Requires: the corners of each face are three different vertices.
  //
  // The second loop begins when the first one has ended: the halfedge opposite to an edge has its number only when the
  // face across knows its first edge. A block writes its own faces only.
  template <typename Shape, typename Blocks>
  void set_faces(const Shape& shape, Intrinsic_mesh<FT>& mesh, const Blocks& blocks)
  {
    const std::size_t n = m_faces.size();
    mesh.reset(n);
    m_first_edge.resize(n);
    blocks(n, [&](std::size_t first, std::size_t last)
    {
      for(Face_id i = static_cast<Face_id>(first); i < last; ++i)
        set_face(i, shape, mesh.face(i));
    });
    blocks(n, [&](std::size_t first, std::size_t last)
    {
      for(Face_id i = static_cast<Face_id>(first); i < last; ++i)
        for(unsigned int j = 0; j < 3; ++j)
          mesh.face(i).opposite[index_in_face(halfedge(i, j))] = opposite(i, j);
    });
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
      const Face_id first = first_face(i), last = first_face(i + 1);
      FT longest = 0;
      for(Face_id f = first; f < last; ++f)
        longest = (std::max)(longest, longest_side(mesh.face(f)));
      if(longest < smallest_component())
        reject_lengths(has_length, first, last);
      components.push_back({first, longest});
    }
    mesh.set_edge_components(components);
  }

  std::size_t number_of_faces() const { return m_faces.size(); }

  // Returns the position of a face of the mesh.
  std::uint32_t position_of(Face_id f) const { return m_order[f]; }

  // Returns the halfedge of the mesh that is edge 0 of the face at a position; null_id if the face was dropped.
  // Requires: the faces are set.
  Halfedge_id first_halfedge_at(std::uint32_t position) const
  {
    CGAL_assertion(position < m_name.size());
    return m_name[position] == null_id ? null_id : halfedge(m_name[position], 0);
  }

private:
  // Numbers breadth first; each component starts from its first face.
  //
  // Invariant: m_order[0 .. end-1] are the faces that have numbers. m_faces has the first of them, whose neighbors have
  // numbers as well; the others are the queue of the search.
  void number_faces(const std::vector<Connected_face>& faces)
  {
    const std::size_t n = faces.size();
    reserve_large(m_order, n + 1);
    m_order.resize(n + 1); // one more: append() may write an entry that does not count
    reserve_large(m_name, n);
    m_name.assign(n, null_id);
    reserve_large(m_faces, n);
    std::size_t end = 0; // of m_order
    for(std::uint32_t first = 0; first < n; ++first)
    {
      append(first, end);
      if(m_faces.size() < end)
        m_first_of_component.push_back(static_cast<Face_id>(m_faces.size()));
      while(m_faces.size() < end)
      {
        prefetch_names(faces, end);
        m_faces.push_back(faces[m_order[m_faces.size()]]);
        for(std::uint32_t& neighbor : m_faces.back().neighbor)
          if(neighbor < n)
            neighbor = append(neighbor, end);
          else
            neighbor = null_id;
      }
    }
    m_order.resize(n);
  }

  // Asks for the face that comes 2 * faces_ahead steps later. The face that comes faces_ahead steps later has arrived
  // by now, so its neighbors are known: asks for their numbers.
  void prefetch_names(const std::vector<Connected_face>& faces, std::size_t end) const
  {
    const std::size_t next = m_faces.size(), last = faces.size() - 1;
    prefetch(&faces[m_order[(std::min)(next + 2 * faces_ahead, end - 1)]]);
    for(const std::uint32_t neighbor : faces[m_order[(std::min)(next + faces_ahead, end - 1)]].neighbor)
      prefetch(&m_name[(std::min)(std::size_t(neighbor), last)]);
  }

  // Appends the face at a position to the order, unless it is there, and returns its number. (Without a branch, as none
  // could be predicted.)
  Face_id append(std::uint32_t position, std::size_t& end)
  {
    Face_id& name = m_name[position];
    const bool is_new = name == null_id;
    m_order[end] = position;
    name = is_new ? static_cast<Face_id>(end) : name;
    end += is_new;
    return name;
  }

  // Makes face i, but for its neighbors. Corner k of the face is corner k + shift of the caller, modulo 3.
  template <typename Shape>
  void set_face(Face_id i, const Shape& shape, Intrinsic_face<FT>& face)
  {
    const std::array<Vertex_id, 3>& v = m_faces[i].corner;
    const unsigned int shift = shape(m_order[i], v, face);
    for(unsigned int k = 0; k < 3; ++k)
      face.vertex[k] = v[corner_after(k, shift)];
    m_first_edge[i] = static_cast<unsigned char>(shift);
  }

  // The first face of a component, or the number of faces behind the last one.
  Face_id first_face(std::size_t component) const
  {
    return component < m_first_of_component.size() ? m_first_of_component[component]
                                                   : static_cast<Face_id>(m_faces.size());
  }

  // Which components have a wanted vertex, or share vertices with such a component, directly or through others? A set
  // of components is connected across vertices. Its representative learns of a wanted vertex first, then all others do.
  std::vector<char> components_connected_to(const std::vector<char>& is_wanted) const
  {
    const std::size_t n = number_of_components();
    boost::disjoint_sets_with_storage<> sets(n);
    std::vector<std::uint32_t> component_of_vertex(is_wanted.size(), null_id);
    std::vector<char> has_wanted(n, 0), result(n, 0);
    for(std::size_t c = 0; c < n; ++c)
      for(Face_id f = first_face(c); f < first_face(c + 1); ++f)
        for(const std::uint32_t v : m_faces[f].corner)
        {
          has_wanted[c] |= is_wanted[v];
          if(component_of_vertex[v] == null_id)
            component_of_vertex[v] = static_cast<std::uint32_t>(c);
          else if(component_of_vertex[v] != c)
            sets.union_set(std::size_t(component_of_vertex[v]), c);
        }
    for(std::size_t c = 0; c < n; ++c)
      result[sets.find_set(c)] |= has_wanted[c];
    for(std::size_t c = 0; c < n; ++c)
      result[c] = result[sets.find_set(c)];
    return result;
  }

  // Gives face f the number `to`. Its neighbors move by the same number, `shift`. Requires: to == f - shift, which
  // is f itself, or the number of a face that has been moved or dropped.
  void move_face(Face_id f, Face_id shift, Face_id to)
  {
    m_faces[to] = m_faces[f];
    for(std::uint32_t& neighbor : m_faces[to].neighbor)
      neighbor = neighbor == null_id ? null_id : neighbor - shift;
    m_order[to] = m_order[f];
    m_name[m_order[to]] = to;
  }

  // The halfedge of the mesh that is edge j of face i. Requires: the shape of the face is set.
  Halfedge_id halfedge(Face_id i, unsigned int j) const
  {
    return halfedge_of(i, corner_after(j, corners_to_first(m_first_edge[i])));
  }

  // The halfedge opposite to edge j of face i: the one between the same vertices in the face across. Throws unless that
  // face has it, and face i across it. k is the corner of that face where edge j ends, or 0 if it has no such corner.
  Halfedge_id opposite(Face_id i, unsigned int j) const
  {
    const Face_id g = m_faces[i].neighbor[j];
    if(g == null_id)
      return null_id;
    const Connected_face &face = m_faces[i], &across = m_faces[g];
    // (Without branches, as none could be predicted.)
    const Vertex_id to = face.corner[next_corner(j)];
    const unsigned int k = 1u * (across.corner[1] == to) + 2u * (across.corner[2] == to);
    if(across.corner[k] != to || across.corner[next_corner(k)] != face.corner[j] || across.neighbor[k] != i)
      throw Invalid_geodesic_input(Reason::NON_MANIFOLD,
                                   "face " + std::to_string(m_order[i]) + " and its neighbor disagree about the ends "
                                     + "of their edge", m_order[i]);
    return halfedge(g, k);
  }

  // Throws for the first face of a component that has a length. A component without lengths is valid: all its points
  // are one.
  template <typename Has_length>
  void reject_lengths(Has_length has_length, Face_id first, Face_id last) const
  {
    for(Face_id i = first; i < last; ++i)
      if(has_length(m_order[i]))
        throw Invalid_geodesic_input(Reason::TOO_SMALL,
                                     "face " + std::to_string(m_order[i]) + " is in a component that is too small "
                                       + "beside the mesh", m_order[i]);
  }

  static constexpr std::size_t faces_ahead = 12; // see prefetch_names()

  std::vector<Connected_face> m_faces; // by number; the corners become vertices in number_vertices()
  std::vector<std::uint32_t> m_order;  // by number: the position of the face
  std::vector<Face_id> m_name;         // by position: the number of the face
  std::vector<unsigned char> m_first_edge; // by number: the edge that is halfedge 0
  std::vector<Face_id> m_first_of_component;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_INTRINSIC_MESH_BUILDER_H
