// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_INTRINSIC_SURFACE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_INTRINSIC_SURFACE_H

// A mesh of the user as all computations see it: its intrinsic mesh, and the way from descriptors of the user to
// elements of that mesh and back. Each computation has one; a Voronoi diagram, a solver or a certifier that needs a
// second run on the same mesh shares it.
//
// Here sources become a Source_set: they are numbered, their descriptors, coordinates and offsets are checked, and
// offsets are divided by the unit. No other file does that. The weights of sites are checked by Weighted_site_list.h,
// which makes valid offsets of them.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_graph_reader.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/number_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/One_block.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/curves_at_walls.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/walls/Vertex_copies.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/walls/Wall_cut.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/walls/sources_at_walls.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Refers to the user's mesh, which must outlive the object, and copies the index maps; keeps no map of points or
// lengths. Functions that take a descriptor to be checked throw Invalid_geodesic_input; `what` and `position` name the
// culprit. All other functions take constant time and require is_read(), unless they say otherwise.
//
// FT is the number type of the computation, which is double for users. Lengths, distances and offsets inside are
// given as multiples of unit().
//
// Const functions only read, so several threads may call them at once. The address of mesh() stays the same when the
// mesh is read again, so others may refer to it as long as the object does not move.
template <typename FT, typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Intrinsic_surface
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Coordinates = Barycentric<FT>;

  // --- reading ---

  // A surface that has not been read. `obstacles` are what is left out, and the walls along which it is cut.
  Intrinsic_surface(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim, Obstacles obstacles = {})
    : m_tm(tm), m_vim(vim), m_fim(fim), m_obstacles(std::move(obstacles))
  {}

  // Reads the mesh; throws Invalid_geodesic_input. Shape is described in Face_shapes.h, Blocks in One_block.h. Takes
  // linear time.
  template <typename Shape, typename Blocks = One_block>
  Intrinsic_surface(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim, Shape shape, Blocks blocks = Blocks(),
                    Obstacles obstacles = {})
    : Intrinsic_surface(tm, vim, fim, std::move(obstacles))
  {
    read(std::move(shape), blocks);
  }

  // Reads what the sources can reach: the vertices of other components become isolated, and their faces are left out.
  // Only lengths of faces that are read are checked. If lengths are given, reads all: their unit is that of the mesh.
  // Sources that are not on the mesh are ignored here, and rejected by source_set(). The range is read here and by
  // source_set(), so it must allow several passes.
  template <typename Shape, typename Sources, typename Blocks>
  Intrinsic_surface(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim, Shape shape, const Sources& sources,
                    Blocks blocks, Obstacles obstacles = {})
    : Intrinsic_surface(tm, vim, fim, std::move(obstacles))
  {
    read_components(std::move(shape), blocks,
                    [&]() { return Shape::has_points ? marked_sources(sources) : std::vector<char>(); });
  }

  // Reads the mesh, or reads it again. If that throws, nothing changes: until the new mesh is complete, both are in
  // memory. Sources that have been inserted into the mesh before are gone with it.
  template <typename Shape, typename Blocks = One_block>
  void read(Shape shape, Blocks blocks = Blocks())
  {
    read_components(std::move(shape), blocks, []() { return std::vector<char>(); });
  }

  bool is_read() const { return m_is_read; }

  // Other obstacles when the mesh is read the next time, in place of those of the constructor.
  void avoid(Obstacles obstacles) { m_obstacles = std::move(obstacles); }
  const Obstacles& obstacles() const { return m_obstacles; }
  bool has_walls() const { return !m_obstacles.walls.empty(); }

  // Is a face one of those to avoid? Not if it is none of the mesh, which checked_halfedge() rejects. Each has a
  // flag, so the mesh need not count them.
  bool is_avoided(face_descriptor f) const
  {
    const std::size_t n = f == Graph_traits::null_face() ? 0 : m_obstacles.is_avoided.size();
    return n > 0 && is_face_of(f, m_tm, m_fim, n) && m_obstacles.avoids(static_cast<std::size_t>(get(m_fim, f)));
  }

  // Frees the memory of mesh and tables. read() may follow.
  void forget()
  {
    m_mesh = Intrinsic_mesh<FT>();
    m_table = Face_graph_correspondence<TriangleMesh>();
    m_is_read = false;
  }

  const Intrinsic_mesh<FT>& mesh() const { return m_mesh; }
  // For Source_insertion, which adds vertices behind those of the user and removes them.
  Intrinsic_mesh<FT>& mesh() { return m_mesh; }
  // The factor from lengths inside to those of the user, a power of two.
  const FT& unit() const { return m_mesh.unit(); }
  // In bytes, of the arrays that grow with the mesh.
  std::size_t memory() const { return m_mesh.memory() + m_table.memory(); }

  // --- vertices ---

  // The vertices of the user, with their copies (Face_graph_reader.h); those of inserted sources do not count.
  std::size_t number_of_vertices() const { return m_table.vertices.size(); }

  // Requires: v < number_of_vertices().
  vertex_descriptor descriptor(Vertex_id v) const { return m_table.vertices[v]; }

  // Which vertices are one vertex of the user, as walls divide it.
  const Vertex_copies& copies() const { return m_table.copies; }

  // Calls visit(c) for all copies of the vertex of the user to which v belongs: for v alone, if there are no walls.
  template <typename Visit>
  void for_each_copy(Vertex_id v, Visit visit) const { m_table.copies.for_each(v, visit); }

  // Returns the copy of the vertex v of the user with the least d(copy), the first one of several.
  template <typename Distance>
  Vertex_id nearest_copy(vertex_descriptor v, const Distance& d) const { return copies().nearest(id(v), d); }

  // Returns the null vertex for an inserted source.
  vertex_descriptor descriptor_or_null(Vertex_id v) const
  {
    return v < number_of_vertices() ? descriptor(v) : Graph_traits::null_vertex();
  }

  // Returns the first copy. Requires: v is a vertex of the mesh. This is not checked: the index of v is looked up in a
  // table without a test of its range.
  Vertex_id id(vertex_descriptor v) const
  {
    return m_table.vertex_of_index[static_cast<std::size_t>(get(m_vim, v))];
  }

  // Returns the same, but throws unless v is a vertex of the mesh that was read: its index leads to a descriptor in the
  // table, which has to equal v. (Descriptors that are mere indices are the same in all meshes.)
  Vertex_id checked_id(vertex_descriptor v, const char* what, std::size_t position) const
  {
    if(v != Graph_traits::null_vertex())
    {
      const std::size_t index = static_cast<std::size_t>(get(m_vim, v));
      if(index < m_table.vertex_of_index.size())
      {
        const Vertex_id id = m_table.vertex_of_index[index];
        if(id != null_id && m_table.vertices[id] == v)
          return id;
      }
    }
    reject_vertex(what, position);
  }

  // Does the same for each vertex of a range. Takes linear time. A range of something else does not compile, with one
  // message; so do locations, which are sources but no targets.
  template <typename Vertices>
  std::vector<Vertex_id> checked_ids(const Vertices& range, const char* what) const
  {
    std::vector<Vertex_id> result;
    static_assert(Checked_vertices<Vertices, vertex_descriptor>::value, "always true, if it compiles");
    if constexpr(Is_range_of<Vertices, vertex_descriptor>::value)
      for(const vertex_descriptor v : range)
        // NOLINTNEXTLINE(performance-inefficient-vector-operation): a range need not know its size
        result.push_back(checked_id(v, what, result.size()));
    return result;
  }

  // --- faces and halfedges; those of the intrinsic mesh are faces and halfedges of the mesh as it was read ---

  face_descriptor descriptor_of_face(Face_id f) const { return m_table.faces[f]; }

  // Returns the halfedge of the intrinsic mesh that is halfedge(f, tm). Throws unless f is a face of the mesh that was
  // read, in the same way as checked_id(). The faces of components that have not been read are rejected as well.
  Halfedge_id checked_halfedge(face_descriptor f, const char* what, std::size_t position) const
  {
    if(f == Graph_traits::null_face())
      reject_null_face(what, position);
    const std::size_t index = static_cast<std::size_t>(get(m_fim, f));
    if(index < m_table.halfedge_of_face_index.size())
    {
      const Halfedge_id h = m_table.halfedge_of_face_index[index];
      if(h != null_id && m_table.faces[face_of(h)] == f)
        return h;
    }
    reject_face_of_location(what, position);
  }

  // Returns the halfedge of the intrinsic mesh that is halfedge(f, tm). Requires: f is a face of the mesh as it was
  // read.
  Halfedge_id first_halfedge(face_descriptor f) const
  {
    return m_table.halfedge_of_face_index[static_cast<std::size_t>(get(m_fim, f))];
  }

  // Returns the halfedge of the intrinsic mesh, as it was read, from which directions at a vertex of the user count: it
  // is opposite(halfedge(v, tm), tm). Returns null_id if that one has no face, or one that was not read.
  Halfedge_id halfedge_of_frame(Vertex_id v) const
  {
    const halfedge_descriptor into = halfedge(descriptor(v), m_tm);
    const halfedge_descriptor h = into == Graph_traits::null_halfedge() ? into : opposite(into, m_tm);
    if(h == Graph_traits::null_halfedge() || is_border(h, m_tm))
      return null_id;
    const face_descriptor f = face(h, m_tm);
    Halfedge_id result = first_halfedge(f);
    if(result == null_id) // a face to avoid
      return null_id;
    for(halfedge_descriptor g = halfedge(f, m_tm); g != h; g = next(g, m_tm))
      result = next_halfedge(result);
    return result;
  }

  // Returns the user's halfedge that is h. Walks around the face from halfedge(f, tm), as only that one is in a table.
  halfedge_descriptor descriptor_of_halfedge(Halfedge_id h) const
  {
    const face_descriptor f = m_table.faces[face_of(h)];
    halfedge_descriptor result = halfedge(f, m_tm);
    for(unsigned int k = index_in_face(first_halfedge(f)); k != index_in_face(h); k = next_corner(k))
      result = next(result, m_tm);
    return result;
  }

  // Returns the coordinates of a point of a face in the order of the user's corners, which begins at the source of
  // halfedge(f, tm); the order of the intrinsic face begins at its shortest edge. (Face_parts leads from a part of a
  // face to the face as a whole.)
  std::pair<face_descriptor, Coordinates> location(Face_id f, const Coordinates& b) const
  {
    const face_descriptor face = m_table.faces[f];
    const unsigned int first = index_in_face(first_halfedge(face));
    Coordinates user;
    for(unsigned int j = 0; j < 3; ++j)
      user[j] = b[(first + j) % 3];
    return {face, user};
  }

  // --- sources ---

  // Returns the sources of a range, or the single source. `offsets` are in the user's unit: none, or one for each
  // source. Throws if a source or the number of offsets is invalid, or if an offset is too large for the mesh.
  // Requires: check_offsets(offsets) does not throw. Takes linear time. Located sources stay as they are;
  // insert_located_sources() makes vertices of them. Sources at walls are on all of their sides.
  template <typename Sources>
  Source_set<FT> source_set(const Sources& sources, const std::vector<double>& offsets = {}) const
  {
    Source_set<FT> set;
    for_each_source<TriangleMesh>(sources, [&](const auto& source) { add_source(source, set); });
    add_offsets(offsets, set);
    add_sources_behind_walls(set);
    return set;
  }

  // Returns the vertices of a range as sources without offsets. Throws if one of them is not a vertex of the mesh, or
  // inside of the faces to avoid; `what` names it in the message. Takes linear time.
  template <typename Vertices>
  Source_set<FT> source_set_of_vertices(const Vertices& range, const char* what) const
  {
    Source_set<FT> set;
    static_assert(Checked_vertices<Vertices, vertex_descriptor>::value, "always true, if it compiles");
    if constexpr(Is_range_of<Vertices, vertex_descriptor>::value)
      for(const vertex_descriptor v : range)
        add_source(v, set, what);
    add_sources_behind_walls(set);
    return set;
  }

  // Appends a source, whose number is the number of those before it. `what` names it in the message of a rejection. If
  // the source is rejected, the set has not changed.
  template <typename Source>
  void add_source(const Source& source, Source_set<FT>& set, const char* what = "source") const
  {
    static_assert(!Is_curve<Source>::value, "this function takes points as sources, no curves");
    const std::size_t position = set.size();
    if constexpr(Is_vertex<TriangleMesh, Source>::value)
      set.vertices.push_back(checked_source(source, what, position));
    else
    {
      const auto at = location_beside_avoided_faces(source.first, source.second, what, position);
      set.located.push_back(Located_source<FT>{face_of(at.first), at.second, position});
      set.vertices.push_back(null_id);
    }
  }

  // Throws also if all faces around the vertex are avoided.
  Vertex_id checked_source(vertex_descriptor source, const char* what, std::size_t position) const
  {
    const Vertex_id v = checked_id(source, what, position);
    if(!m_obstacles.is_avoided.empty() && m_mesh.halfedge(v) == null_id
       && halfedge(source, m_tm) != Graph_traits::null_halfedge())
      reject_avoided(what, position);
    return v;
  }

  // Lists the sources at walls once more for each other side (sources_at_walls.h). Call it when all sources have been
  // added, before they are inserted. Takes linear time.
  void add_sources_behind_walls(Source_set<FT>& set) const
  {
    if(has_walls())
      list_sources_behind_walls(
        m_mesh, set, [this](Vertex_id v, auto visit) { this->for_each_copy(v, visit); },
        [this](Face_id f, const Coordinates& c) { return location_behind_wall(f, c); });
  }

  // Returns the same point on the other side of a wall: a halfedge of the face there, and coordinates; null_id if the
  // point is on no wall, or at a vertex. Requires: the coordinates are snapped, f is a face of the mesh as it was read.
  std::pair<Halfedge_id, Coordinates> location_behind_wall(Face_id f, const Coordinates& c) const
  {
    for(unsigned int k = 0; k < 3 && has_walls(); ++k)
      if(c[k] != 0 && c[next_corner(k)] != 0 && c[previous_corner(k)] == 0)
      {
        const halfedge_descriptor o = opposite(descriptor_of_halfedge(halfedge_of(f, k)), m_tm);
        if(is_border(o, m_tm) || first_halfedge(face(o, m_tm)) == null_id)
          continue;
        const std::size_t index = static_cast<std::size_t>(get(m_fim, face(o, m_tm)));
        if(is_wall(m_obstacles.walls_of(index), number_in_face(o, m_tm)))
          return location_on_halfedge(o, c[next_corner(k)], c[k]);
      }
    return {null_id, c};
  }

  // Sources and queries both come here, so the rim has one meaning.
  //
  // Returns a location of the user: the halfedge of the intrinsic mesh that is halfedge(f, tm), and the coordinates in
  // the order of the intrinsic face. A location in a face to avoid is given in a neighbor that is not avoided: an edge
  // or a vertex at the rim belongs to both. Throws Invalid_geodesic_input for a location that is not on the mesh, or
  // inside of what is avoided. Linear in the degree for a vertex at the rim, else constant.
  template <typename BarycentricCoordinates>
  std::pair<Halfedge_id, Coordinates> location_beside_avoided_faces(face_descriptor f, const BarycentricCoordinates& b,
                                                                    const char* what, std::size_t position) const
  {
    if(!is_avoided(f))
    {
      const Halfedge_id h = checked_halfedge(f, what, position);
      return {h, intrinsic_coordinates<FT>(h, b, what, position)};
    }
    const auto p = open_place(f, snapped_coordinates<FT>(b, what, position), what, position);
    return location_on_halfedge(p.first, p.second[0], p.second[1]);
  }

  // Returns a curve or a range of curves, with all pieces that walls make of them. `offsets` are in the user's unit:
  // none, or one for each curve. Throws if a curve is not one of the mesh that was read, or as source_set() does.
  // Linear in the number of segments. Curves stay polylines here; Curve_insertion.h makes edges of them.
  template <typename Curves>
  std::vector<Located_curve<FT>> located_curves(const Curves& curves, const std::vector<double>& offsets) const
  {
    std::vector<Located_curve<FT>> result;
    for_each_source<TriangleMesh>(curves, [&](const auto& curve)
    { result.push_back(located_curve(curve, result.size())); });
    // Offsets are checked and converted as those of points are.
    Source_set<FT> set; // of as many sources, for their offsets
    set.vertices.resize(result.size(), null_id);
    add_offsets(offsets, set);
    for(std::size_t i = 0; i < offsets.size(); ++i)
      result[i].offset = set.offsets[i];
    divide_at_walls(result);
    return result;
  }

  // Returns a single curve, whose number is `position`, without an offset and not divided. Throws as located_curves().
  template <typename Curve>
  Located_curve<FT> located_curve(const Curve& curve, std::size_t position, const char* what = "curve") const
  {
    Located_curve<FT> located;
    located.number = static_cast<std::uint32_t>(position);
    located.is_closed = curve.is_closed();
    for(const auto& segment : curve.segments())
    {
      located.segments.push_back(curve_segment(segment, what, position));
      located.segments.back().number = static_cast<std::uint32_t>(located.segments.size() - 1);
    }
    if(located.segments.empty())
      located.vertex = checked_source(curve.vertex(), what, position);
    return located;
  }

  // Replaces curves by their pieces between walls, on all sides of these (curves_at_walls.h). Linear in the number of
  // segments.
  void divide_at_walls(std::vector<Located_curve<FT>>& curves) const
  {
    const auto behind = [this](Face_id f, const Coordinates& c) { return location_behind_wall(f, c); };
    if(has_walls())
      divide_curves_at_walls(m_mesh, copies(), behind, curves);
  }

  // Returns a segment of a curve in the order of the intrinsic face. A segment along the rim of what is avoided is
  // given in the neighbor that is not avoided: then both of its ends are on one edge, as zero coordinates tell; one
  // without length as a point is. A segment through an avoided face is rejected. `position` is that of the curve.
  template <typename Segment>
  Curve_segment<FT> curve_segment(const Segment& s, const char* what, std::size_t position) const
  {
    if(!is_avoided(s.face))
    {
      const Halfedge_id h = checked_halfedge(s.face, what, position);
      return {face_of(h), intrinsic_coordinates<FT>(h, s.source, what, position),
              intrinsic_coordinates<FT>(h, s.target, what, position)};
    }
    const Coordinates from = snapped_coordinates<FT>(s.source, what, position);
    const Coordinates to = snapped_coordinates<FT>(s.target, what, position);
    const auto point = [&] { return location_beside_avoided_faces(s.face, s.source, what, position); };
    if(from == to)
      return {face_of(point().first), point().second, point().second};
    halfedge_descriptor h = halfedge(s.face, m_tm);
    for(unsigned int k = 0; k < 3; ++k, h = next(h, m_tm))
      if(from[previous_corner(k)] == 0 && to[previous_corner(k)] == 0 && is_open(opposite(h, m_tm)))
      {
        const halfedge_descriptor o = opposite(h, m_tm);
        return {face_of(first_halfedge(face(o, m_tm))), location_on_halfedge(o, from[next_corner(k)], from[k]).second,
                location_on_halfedge(o, to[next_corner(k)], to[k]).second};
      }
    reject_avoided(what, position);
  }

  // Appends the offset of the source with the number set.offsets.size(). Throws if it is too large in the unit of the
  // intrinsic mesh (Tolerance::largest_offset()). Requires: it is finite and not negative. If it throws, the set has
  // one offset too many, and must not be used any more.
  void add_offset(double offset, Source_set<FT>& set) const
  {
    CGAL_assertion(offset >= 0);
    const std::size_t position = set.offsets.size();
    set.offsets.push_back(FT(FT(offset) / unit()));
    if(!(set.offsets.back() <= Tolerance<FT>::largest_offset()))
      throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_OFFSET,
                                   "the offset of source " + std::to_string(position)
                                     + " is too large for a mesh of this extent", position);
  }

  // --- checks that need no mesh that is read; they see no more than indices tell ---

  // They answer queries of objects without sources, which need not read the mesh. A descriptor of another mesh passes
  // if its index fits, although checked_id() and checked_halfedge() may reject it.

  void check_vertex(vertex_descriptor v, const char* what, std::size_t position) const
  {
    if(!is_vertex_of(v, m_tm, m_vim))
      reject_vertex(what, position);
  }

  template <typename BarycentricCoordinates>
  void check_location(face_descriptor f, const BarycentricCoordinates& b, const char* what, std::size_t position) const
  {
    if(f == Graph_traits::null_face())
      reject_null_face(what, position);
    if(!is_face_of(f, m_tm, m_fim))
      reject_face_of_location(what, position);
    const Coordinates c = snapped_coordinates<FT>(b, what, position);
    if(is_avoided(f))
      open_place(f, c, what, position);
  }

private:
  // `wanted_vertices` is described in Face_graph_reader.h. The members change when all has been read, so an exception
  // leaves them as they were.
  template <typename Shape, typename Blocks, typename Wanted_vertices>
  void read_components(Shape shape, const Blocks& blocks, Wanted_vertices wanted_vertices)
  {
    Intrinsic_mesh<FT> mesh;
    Face_graph_correspondence<TriangleMesh> table;
    Face_graph_reader<FT, TriangleMesh, VertexIndexMap, FaceIndexMap>(m_tm, m_vim, m_fim, m_obstacles)
      .read(shape, mesh, table, wanted_vertices, blocks);
    m_mesh = std::move(mesh);
    m_table = std::move(table);
    m_is_read = true;
  }

  // Returns a flag for each index of a vertex, set for the vertices of sources and for the corners of their faces. The
  // reader calls it after it has checked that all faces are triangles.
  template <typename Sources>
  std::vector<char> marked_sources(const Sources& sources) const
  {
    std::vector<char> is_marked(num_vertices(m_tm), 0);
    const std::size_t n = num_faces(m_tm);
    for_each_source<TriangleMesh>(sources, [&](const auto& source) { mark_source(source, n, is_marked); });
    return is_marked;
  }

  // Ignores a source that is not in the mesh: it is rejected when the mesh has been read.
  template <typename Source>
  void mark_source(const Source& source, std::size_t number_of_faces, std::vector<char>& is_marked) const
  {
    if constexpr(Is_vertex<TriangleMesh, Source>::value)
    {
      if(is_vertex_of(source, m_tm, m_vim, is_marked.size()))
        is_marked[static_cast<std::size_t>(get(m_vim, vertex_descriptor(source)))] = 1;
    }
    else if constexpr(Is_curve<Source>::value)
    {
      if(source.vertex() != Graph_traits::null_vertex())
        mark_source(source.vertex(), number_of_faces, is_marked);
      for(const auto& s : source.segments())
        mark_face(s.face, number_of_faces, is_marked);
    }
    else
      mark_face(source.first, number_of_faces, is_marked);
  }

  // Marks the corners of the face of a source, so that its component is read. Ignores what is no face of the mesh.
  void mark_face(face_descriptor f, std::size_t number_of_faces, std::vector<char>& is_marked) const
  {
    if(f != Graph_traits::null_face() && is_face_of(f, m_tm, m_fim, number_of_faces))
      for(const halfedge_descriptor h : halfedges_of_triangle(f, m_tm))
        is_marked[static_cast<std::size_t>(get(m_vim, target(h, m_tm)))] = 1;
  }

  // place_at_rim() with the faces that this surface avoids.
  auto open_place(face_descriptor f, const Coordinates& c, const char* what, std::size_t position) const
  {
    return place_at_rim(f, c, m_tm, [this](halfedge_descriptor h) { return is_open(h); }, what, position);
  }

  // Has a halfedge a face that is not avoided? Only then has that face a number in the intrinsic mesh. Requires: there
  // are flags.
  bool is_open(halfedge_descriptor h) const
  {
    return !is_border(h, m_tm) && !m_obstacles.avoids(static_cast<std::size_t>(get(m_fim, face(h, m_tm))));
  }

  // The location on a halfedge with a face, by the coordinates of its source and its target. The third coordinate is an
  // exact zero, so that the location stays on the edge, or at the vertex, when it is inserted or asked for.
  std::pair<Halfedge_id, Coordinates> location_on_halfedge(halfedge_descriptor h, const FT& a, const FT& b) const
  {
    const Halfedge_id first = first_halfedge(face(h, m_tm));
    Halfedge_id i = first;
    for(halfedge_descriptor g = halfedge(face(h, m_tm), m_tm); g != h; g = next(g, m_tm))
      i = next_halfedge(i);
    Coordinates c{};
    c[index_in_face(i)] = a;
    c[next_corner(index_in_face(i))] = b;
    return {first, c};
  }

  // Appends an offset for each source of the set, or none. Throws if their number is neither. Serves points and curves:
  // of the set of curves only the number counts.
  void add_offsets(const std::vector<double>& offsets, Source_set<FT>& set) const
  {
    if(!offsets.empty() && offsets.size() != set.size())
      throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_OFFSET,
                                   std::to_string(offsets.size()) + " offsets or weights for "
                                     + std::to_string(set.size()) + " sources or sites");
    for(const double offset : offsets)
      add_offset(offset, set);
  }

  const TriangleMesh& m_tm;
  VertexIndexMap m_vim;
  FaceIndexMap m_fim;
  Intrinsic_mesh<FT> m_mesh;
  Face_graph_correspondence<TriangleMesh> m_table;
  bool m_is_read = false;
  Obstacles m_obstacles;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_INTRINSIC_SURFACE_H
