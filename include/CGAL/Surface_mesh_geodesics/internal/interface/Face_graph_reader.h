// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_FACE_GRAPH_READER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_FACE_GRAPH_READER_H

// Reads a model of FaceListGraph: makes its intrinsic mesh, and the tables between the elements of both. This is the
// only file that walks over the mesh of a user. The mesh half is in surface/Intrinsic_mesh_builder.h.
//
// Three numberings occur. The *index* of a vertex or face is that of the user's property map; its *position* is that in
// the range vertices(tm) or faces(tm); its *id* is that in the intrinsic mesh, which the builder chooses. Indices have
// to be below num_vertices() and num_faces() and different from each other; they may have gaps at removed elements.
//
// Walls are edges that no path may cross. The intrinsic mesh is cut along them, and a vertex that they divide has
// several vertices there, its *copies*; surface/walls/Wall_cut.h says which, and why. Descriptors of the user stay what
// they are: the tables lead from a vertex of the user to all of its copies, and from each copy back to it. Without
// walls no vertex has copies, and their table is empty. Who asks for it:
//
// - sources at a vertex, or on an edge: Intrinsic_surface::add_sources_behind_walls() makes one of each copy;
// - distances of vertices, the nearest source, targets: Distance_solver takes the copy with the least distance, and
//   waits for all of them; so do Distance_matrix and Isoline_run, and Farthest_point_sampling compares these distances;
// - certificates: Distance_certifier checks all copies, of which the least has the distance of the user;
// - curves as sources: Intrinsic_surface::divide_at_walls() makes pieces of them, on all sides (curves_at_walls.h);
//   the sides of signed distances are those of the nearest copies;
// - queries and the beginnings of paths: Path_solver::query() takes the side that is nearest;
// - the end of a path needs a descriptor only, which each copy has;
// - directions at a source: Surface_with_sources::direction_at_vertex() counts them from a wall, as from a border.
//
// - diagrams: the copies of a site have its number (propagate_diagram.h); queries ask all sides, and a cell may have
//   parts that are connected nowhere (Cell_triangles.h, Cell_topology.h).
//
// What does not ask takes no walls: the named parameter does not compile for remeshing.
//
// Two ways to read. The elements of most models are met one by one, in the order of their ranges, as nothing is known
// of their indices or of what several threads may do. A Surface_mesh without removed elements, with its own index maps,
// is an array: its elements are read in blocks, in any order (Consecutive_elements.h). Both ways make the same mesh, in
// the same bits, and find the same fault first. A mesh with obstacles is read in the first way, whatever its type:
// faces to avoid are gaps as well, and walls are noted face by face.
//
// The steps of read(), and who does them:
// 1. read_faces() checks the faces, and collects their corners and neighbors. Wall_cut takes them apart along walls.
// 2. The builder numbers the faces, breadth first in each component, and drops components that are not wanted.
// 3. number_vertices() numbers the vertices in the order of the faces.
// 4. The shape reads points or lengths and chooses the unit (Face_shapes.h). The builder makes the faces with it, and
//    the intrinsic mesh finds its umbrellas and pseudo-sources.
// 5. fill_face_tables() connects these faces with those of the user.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/Consecutive_elements.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/One_block.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh_builder.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/mesh_invariants.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/walls/Vertex_copies.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/walls/Wall_cut.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The elements of a mesh of the user and those of its intrinsic mesh. Face_graph_reader fills it; the tables are
// inverse to each other. Halfedges are found by face: halfedge(f, tm) has an id, and next() is next_halfedge() on both
// sides.
//
// Faces of components that have been left out are in no table: their entry is null_id, and their vertices are isolated.
//
// All copies of a vertex have its descriptor. The first one is that of vertex_of_index.
template <typename TriangleMesh>
struct Face_graph_correspondence
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  std::vector<vertex_descriptor> vertices; // of a vertex of the intrinsic mesh
  std::vector<face_descriptor> faces;      // of a face of the intrinsic mesh
  std::vector<Vertex_id> vertex_of_index;  // by the index of the user's map, null_id if unused
  // By the index of the user's map: the halfedge of the intrinsic mesh that is halfedge(f, tm).
  std::vector<Halfedge_id> halfedge_of_face_index;
  Vertex_copies copies; // of vertices that walls divide

  std::size_t memory() const
  {
    return vertices.capacity() * sizeof(vertex_descriptor) + faces.capacity() * sizeof(face_descriptor)
         + vertex_of_index.capacity() * sizeof(Vertex_id) + copies.memory()
         + halfedge_of_face_index.capacity() * sizeof(Halfedge_id);
  }
};

// Reads a mesh once: read() moves its buffers away. Positions in messages are those in the ranges vertices(tm) and
// faces(tm).
//
// Faults are searched for in this order, and the first one that is found is thrown: face by face, whether it is a
// triangle and has a valid index, and whether its vertices differ and have valid indices; then whether vertices have
// different indices; then the points or lengths (Face_shapes.h), the triangle inequality, whether neighbors agree about
// their edge, and the sizes of components. That there are too many faces is found before or while they are read.
//
// TriangleMesh is a model of FaceListGraph. It is referred to; the maps, which are copied, have values that convert to
// std::size_t. An object serves for one call.
template <typename FT, typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Face_graph_reader
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Correspondence = Face_graph_correspondence<TriangleMesh>;
  using Builder = Intrinsic_mesh_builder<FT>;
  using Consecutive = Consecutive_elements<TriangleMesh, VertexIndexMap, FaceIndexMap>;
  using Reason = Invalid_geodesic_input::Reason;

public:
  // Faces to avoid are left out, as if they were not in faces(tm), and the mesh is cut along walls. The obstacles are
  // referred to.
  Face_graph_reader(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim, const Obstacles& obstacles)
    : m_tm(tm), m_vim(vim), m_fim(fim), m_obstacles(obstacles)
  {}

  // Builds the mesh and the tables; throws Invalid_geodesic_input. Both are incomplete then, so Intrinsic_surface
  // passes new ones. Shape is described in Face_shapes.h. Takes linear time.
  //
  // The arrays of the intrinsic mesh are filled in blocks (One_block.h). The user's mesh and maps are read by this
  // thread only, as the public functions promise, but for those that Consecutive_elements.h names.
  //
  // If the mesh has several components, wanted_vertices() is called, after all faces have been checked. It returns a
  // flag for each index of a vertex: only the components connected to marked vertices become faces of the intrinsic
  // mesh. If it returns no flags, all do.
  template <typename Shape, typename Wanted_vertices, typename Blocks>
  void read(Shape& shape, Intrinsic_mesh<FT>& mesh, Correspondence& table, Wanted_vertices wanted_vertices,
            const Blocks& blocks)
  {
    read_faces(blocks);
    std::vector<std::uint32_t> copied;
    if(!m_obstacles.walls.empty())
      copied = Wall_cut(m_connected_faces, m_walls, num_vertices(m_tm)).take_copied();
    Builder builder(m_connected_faces);
    // The builder has copied them in their new order. The first copy is freed before the mesh needs memory.
    m_connected_faces = std::vector<Connected_face>();
    if(builder.number_of_components() > 1)
    {
      std::vector<char> is_wanted = wanted_vertices();
      if(!is_wanted.empty())
      {
        for(const std::uint32_t index : copied)
          is_wanted.push_back(is_wanted[index]);
        builder.keep_components_of(is_wanted);
      }
    }
    const std::size_t number_in_faces = number_vertices(builder, copied, table, blocks);
    // The vertices are numbered before their points are read, so that points lie in the order in which faces need them.
    const int exponent = shape.prepare(table.vertices, number_in_faces, blocks);
    mesh.set_unit(FT(std::ldexp(1., exponent)));
    const auto shape_of_face = [&](std::uint32_t f, const std::array<Vertex_id, 3>& v, Intrinsic_face<FT>& face)
    { return shape.shape(m_faces[f], f, v, face); };
    if constexpr(Shape::has_points)
      builder.set_faces(shape_of_face, mesh, blocks);
    else
      builder.set_faces(shape_of_face, mesh, One_block()); // shape() reads the user's map
    builder.set_edge_components([&](std::uint32_t f) { return shape.has_length(m_faces[f]); }, mesh);
    mesh.finish(table.vertices.size(), blocks);
    // With points, no shortest path crosses a face twice (thesis, lemma 3.2). With lengths only, it may.
    if(!Shape::has_points)
      mesh.bound_faces_crossed_by_lengths();
    CGAL_expensive_assertion(are_invariants_kept(mesh));
    fill_face_tables(builder, table, blocks);
  }

private:
  // Reads the faces with their corners and neighbors, and checks them and the index maps.
  template <typename Blocks>
  void read_faces(const Blocks& blocks)
  {
    if constexpr(Consecutive::is_possible)
      if(Consecutive::has_no_gaps(m_tm) && m_obstacles.is_avoided.empty() && m_obstacles.walls.empty())
      {
        m_is_consecutive = true;
        read_consecutive_faces(blocks);
        return;
      }
    read_faces_one_by_one();
  }

  // Faces and vertices have their positions as indices, so no index needs a check, and no neighbor a second look. A
  // block writes its own faces only; of several faults, that of the first face is thrown (One_block.h).
  template <typename Blocks>
  void read_consecutive_faces(const Blocks& blocks)
  {
    const std::size_t n = num_faces(m_tm), number_of_vertices = num_vertices(m_tm);
    if(n >= maximum_number_of_faces)
      throw_for_size();
    reserve_large(m_faces, n);
    m_faces.resize(n);
    reserve_large(m_connected_faces, n);
    m_connected_faces.resize(n);
    blocks(n, [&](std::size_t first, std::size_t last)
    {
      for(std::size_t i = first; i < last; ++i)
      {
        m_faces[i] = Consecutive::face(i);
        connect(halfedges_of(m_faces[i], i), i, number_of_vertices, m_connected_faces[i]);
      }
    });
  }

  // The loop reads neighbors as indices, because a neighbor may come later in the range; its position is known behind
  // the loop. Where indices are positions, that second pass is left out.
  void read_faces_one_by_one()
  {
    // (Some models count their elements in each call.)
    const std::size_t range_of_indices = num_faces(m_tm), number_of_vertices = num_vertices(m_tm);
    reserve_large(m_faces, range_of_indices);
    reserve_large(m_connected_faces, range_of_indices);
    for(face_descriptor f : faces(m_tm))
    {
      if(is_left_out(f))
        continue;
      const std::size_t position = m_faces.size();
      const std::array<halfedge_descriptor, 3> h = halfedges_of(f, position);
      register_index(f, range_of_indices);
      m_faces.push_back(f);
      if(!m_obstacles.walls.empty())
        m_walls.push_back(m_obstacles.walls_of(index_of(f)));
      m_connected_faces.emplace_back();
      connect(h, position, number_of_vertices, m_connected_faces.back());
      if(m_faces.size() >= maximum_number_of_faces)
        throw_for_size();
    }
    if(!m_indices_are_positions)
      for(Connected_face& face : m_connected_faces)
        for(std::uint32_t& neighbor : face.neighbor)
          // An index that no face has becomes null_id, the border.
          neighbor = neighbor < m_position_of_index.size() ? m_position_of_index[neighbor] : null_id;
  }

  // A mesh with faces to avoid is read as if they had been removed: the others are met in the same order, so all
  // numbers of the intrinsic mesh are those of a filtered graph, and so are the bits of all results.
  //
  // Leaves out a face to avoid. Its neighbors find an index that no face has, so their edges become borders. The faces
  // behind it have other positions than indices. (An index that is out of range is rejected like that of any face.)
  bool is_left_out(face_descriptor f)
  {
    if(m_obstacles.is_avoided.empty())
      return false;
    const std::size_t index = index_of(f);
    const bool result = m_obstacles.avoids(index);
    m_indices_are_positions = m_indices_are_positions && !result;
    return result;
  }

  [[noreturn]] static void throw_for_size()
  {
    throw Invalid_geodesic_input(Reason::TOO_LARGE, "the mesh has too many faces");
  }

  // Throws for the face at position m_faces.size(), which is being read.
  [[noreturn]] void throw_for_index(const char* fault) const
  {
    throw Invalid_geodesic_input(Reason::INVALID_INDEX_MAP,
                                 "the index of face " + std::to_string(m_faces.size()) + fault
                                   + " (indices that a mesh stores have to be set before)", m_faces.size());
  }

  // Notes which face has an index. Throws if the index is out of range, or taken. Requires: the face is the next one,
  // at position m_faces.size().
  void register_index(face_descriptor f, std::size_t range_of_indices)
  {
    const std::size_t index = index_of(f);
    if(index >= range_of_indices)
      throw_for_index(" is out of range");
    if(index >= m_position_of_index.size())
      m_position_of_index.resize(range_of_indices, null_id);
    if(m_position_of_index[index] != null_id)
      throw_for_index(" is that of another face");
    m_position_of_index[index] = static_cast<std::uint32_t>(m_faces.size());
    m_indices_are_positions = m_indices_are_positions && index == m_faces.size();
  }

  // Returns the halfedges of the face at a position, from halfedge(f, tm) on: all tables of halfedges begin with that
  // one. Throws if the face is not a triangle. (A face with one or two halfedges is not one either.)
  std::array<halfedge_descriptor, 3> halfedges_of(face_descriptor f, std::size_t position) const
  {
    const std::array<halfedge_descriptor, 3> h = halfedges_of_triangle(f, m_tm);
    if(next(h[2], m_tm) != h[0] || h[1] == h[0] || h[2] == h[0])
      throw Invalid_geodesic_input(Reason::NOT_A_TRIANGLE, "face " + std::to_string(position) + " is not a triangle",
                                   position);
    return h;
  }

  // Finds the corners and neighbors of the face at a position, given by its halfedges. Throws if two corners are the
  // same vertex. (A halfedge data structure stores targets; a source is one step away.)
  void connect(const std::array<halfedge_descriptor, 3>& h, std::size_t position, std::size_t number_of_vertices,
               Connected_face& face) const
  {
    const vertex_descriptor v0 = target(h[2], m_tm), v1 = target(h[0], m_tm), v2 = target(h[1], m_tm);
    if(v0 == v1 || v1 == v2 || v2 == v0)
      throw Invalid_geodesic_input(Reason::NON_MANIFOLD, "face " + std::to_string(position) + " has a vertex twice",
                                   position);
    face.corner = {vertex_index(v0, number_of_vertices), vertex_index(v1, number_of_vertices),
                   vertex_index(v2, number_of_vertices)};
    face.neighbor = {neighbor(h[0]), neighbor(h[1]), neighbor(h[2])};
  }

  // Returns the index of the face across h, or null_id if there is none. (A face that is not among faces(tm) counts as
  // none, but that is not known before all faces have been read.) An index that does not fit into 32 bits becomes
  // null_id as well: no face has it.
  std::uint32_t neighbor(halfedge_descriptor h) const
  {
    const halfedge_descriptor o = opposite(h, m_tm);
    return is_border(o, m_tm) ? null_id
                              : static_cast<std::uint32_t>((std::min)(index_of(face(o, m_tm)), std::size_t(null_id)));
  }

  // Numbers the vertices in the order of the faces, so that neighbors are close in memory, and the isolated ones last.
  // Fills the tables of vertices. Returns how many are in faces. Throws if two vertices have one index, or if a corner
  // of a face is not in vertices(tm). Takes linear time.
  //
  // Corners come first: the builder gives them numbers below the result. It does so in this thread, as the number of a
  // corner depends on all faces before it. Copies are corners with indices of their own, behind those of the user.
  template <typename Blocks>
  std::size_t number_vertices(Builder& builder, const std::vector<std::uint32_t>& copied, Correspondence& table,
                              const Blocks& blocks) const
  {
    const std::size_t size = num_vertices(m_tm) + copied.size();
    table.vertex_of_index.assign(size, null_id);
    const std::size_t number_in_faces = builder.number_vertices(table.vertex_of_index);
    table.vertices.resize(size);
    if(m_is_consecutive)
      list_consecutive_vertices(number_in_faces, table, blocks);
    else
      list_vertices(number_in_faces, copied, table);
    return number_in_faces;
  }

  // Numbers the vertices that no face has, and lists all of them. (Most meshes have no such vertex; then the first
  // loop, which cannot be divided, is left out.) No corner can be missing: each was compared with the number of
  // vertices.
  template <typename Blocks>
  static void list_consecutive_vertices(std::size_t number_in_faces, Correspondence& table, const Blocks& blocks)
  {
    if constexpr(Consecutive::is_possible)
    {
      std::size_t n = number_in_faces;
      if(n < table.vertices.size())
        for(std::uint32_t index = 0; index < table.vertices.size(); ++index)
          Builder::number_of(index, table.vertex_of_index, n);
      CGAL_assertion(n == table.vertices.size()); // so each number is that of one index
      blocks(table.vertices.size(), [&](std::size_t first, std::size_t last)
      {
        for(std::size_t index = first; index < last; ++index)
          table.vertices[table.vertex_of_index[index]] = Consecutive::vertex(index);
      });
    }
  }

  // The same for indices in any order. The loop meets all vertices in the user's order, and gives the next numbers to
  // those that no face has, among them the vertices of components that were left out.
  void list_vertices(std::size_t number_in_faces, const std::vector<std::uint32_t>& copied, Correspondence& table) const
  {
    const std::size_t range_of_indices = num_vertices(m_tm);
    std::size_t n = number_in_faces, number_known = 0;
    std::vector<char> is_known(table.vertices.size(), 0);
    for(vertex_descriptor v : vertices(m_tm))
    {
      const std::uint32_t index = vertex_index(v, range_of_indices);
      const Vertex_id id = Builder::number_of(index, table.vertex_of_index, n);
      if(is_known[id] != 0)
        throw Invalid_geodesic_input(Reason::INVALID_INDEX_MAP, "two vertices have the index " + std::to_string(index));
      is_known[id] = 1;
      ++number_known;
      table.vertices[id] = v;
    }
    if(!copied.empty())
      number_known += connect_copies(copied, range_of_indices, is_known, table);
    // Each number has to be known now: the loop has met n vertices, unless a corner was not among them.
    if(number_known != n)
      throw Invalid_geodesic_input(Reason::INVALID_INDEX_MAP,
                                   "a face has a vertex that is not among those of the mesh");
    table.vertices.resize(n); // num_vertices() may count vertices that have been removed
  }

  // Gives copies the descriptor of their vertex, and connects them with it. Returns how many there are: a copy in a
  // component that was left out is none. (A vertex that is not known is not among those of the mesh, and is rejected.)
  static std::size_t connect_copies(const std::vector<std::uint32_t>& copied, std::size_t range_of_indices,
                                    const std::vector<char>& is_known, Correspondence& table)
  {
    std::size_t number = 0;
    table.copies.reset(table.vertices.size());
    for(std::size_t i = 0; i < copied.size(); ++i)
    {
      const Vertex_id copy = table.vertex_of_index[range_of_indices + i], v = table.vertex_of_index[copied[i]];
      if(copy == null_id || v == null_id || is_known[v] == 0)
        continue;
      table.vertices[copy] = table.vertices[v];
      table.copies.connect(v, copy);
      ++number;
    }
    table.vertex_of_index.resize(range_of_indices);
    return number;
  }

  // Returns the index of a vertex in the user's map; throws if it is out of range.
  std::uint32_t vertex_index(vertex_descriptor v, std::size_t number_of_vertices) const
  {
    const std::size_t index = static_cast<std::size_t>(get(m_vim, v));
    if(index >= number_of_vertices)
      throw Invalid_geodesic_input(Reason::INVALID_INDEX_MAP,
                                   "the index " + std::to_string(index) + " of a vertex is out of range");
    return static_cast<std::uint32_t>(index);
  }

  // Fills the tables of faces. The builder has reordered the faces, and turned them so that their shortest edge is
  // first. Edge 0 of a face at a position is halfedge(f, tm), as read_faces() has begun there. The entry of each face
  // is written once, so blocks do not disturb each other. What they read does not change any more.
  template <typename Blocks>
  void fill_face_tables(const Builder& builder, Correspondence& table, const Blocks& blocks) const
  {
    table.faces.resize(builder.number_of_faces());
    blocks(table.faces.size(), [&](std::size_t first, std::size_t last)
    {
      for(std::size_t f = first; f < last; ++f)
        table.faces[f] = m_faces[builder.position_of(static_cast<Face_id>(f))];
    });
    table.halfedge_of_face_index.resize(m_is_consecutive ? m_faces.size() : m_position_of_index.size());
    blocks(table.halfedge_of_face_index.size(), [&](std::size_t first, std::size_t last)
    {
      for(std::size_t index = first; index < last; ++index)
      {
        const std::uint32_t position
          = m_is_consecutive ? static_cast<std::uint32_t>(index) : m_position_of_index[index];
        table.halfedge_of_face_index[index] = position == null_id ? null_id : builder.first_halfedge_at(position);
      }
    });
  }

  std::size_t index_of(face_descriptor f) const { return static_cast<std::size_t>(get(m_fim, f)); }

  const TriangleMesh& m_tm;
  VertexIndexMap m_vim;
  FaceIndexMap m_fim;
  const Obstacles& m_obstacles;
  // While faces are met one by one, these tables are as long as the part that has been read.
  std::vector<face_descriptor> m_faces;          // by position
  std::vector<Wall_bits> m_walls;                // by position, if there are walls
  std::vector<Connected_face> m_connected_faces; // by position; corners are indices of the user's map
  // By the index of the user's map; null_id for an index that no face has.
  std::vector<std::uint32_t> m_position_of_index;
  bool m_indices_are_positions = true; // of all faces
  bool m_is_consecutive = false;       // were elements read without a look at their indices? (Consecutive_elements.h)
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_FACE_GRAPH_READER_H
