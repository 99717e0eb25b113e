// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SURFACE_WITH_SOURCES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SURFACE_WITH_SOURCES_H

// A surface of the user on which sources are vertices, or, if there are curves among them, vertices and edges. Sources
// inside faces and on edges refine the intrinsic mesh; the class translates between the user's faces and the parts of
// the refined ones. All runs of a Path_solver from the same sources use one object, also when it repeats a run to keep
// the windows.

#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/directions/full_turns.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Departure.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Path_thinning.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Face_parts.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A point of a query: a vertex, or a point of a face of the refined mesh. `face` and `coordinates` are set if the point
// is not a vertex of the first mesh; `vertex` is then set as well if a source is there. Coordinates are those in
// `face`, a part, not in the face that the user has named. A query refers to the sources that are inserted when it is
// made; it becomes void when they change.
struct Surface_query
{
  Vertex_id vertex = null_id;
  Face_id face = null_id;
  Barycentric<double> coordinates{};
  bool is_location = false; // the user gave a location, not a vertex
  bool is_in_face = false;  // a location that is not a vertex of the first mesh
  bool is_on_edge = false;  // a location on an edge of the first mesh. Rounding may move other ones there, too.
};

// Use: read(), add_source() for each source, insert_sources(), then the queries; clear_sources() or read() begins anew.
// Invariant between calls: the mesh is refined only while m_are_inserted is set.
// The sources stay inserted, since queries at any point need the refined mesh. (Distance_solver removes them after each
// run.) Const functions only read, so several threads may query at once. The object cannot be copied or moved, as
// m_insertion refers to the mesh in m_surface.
template <typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Surface_with_sources
{
public:
  using Surface = Intrinsic_surface<double, TriangleMesh, VertexIndexMap, FaceIndexMap>;
  using vertex_descriptor = typename Surface::vertex_descriptor;
  using halfedge_descriptor = typename Surface::halfedge_descriptor;
  using face_descriptor = typename Surface::face_descriptor;
  using Coordinates = typename Surface::Coordinates;
  using Query = Surface_query;

  Surface_with_sources(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim)
    : m_surface(tm, vim, fim), m_insertion(m_surface.mesh())
  {}

  Surface_with_sources(const Surface_with_sources&) = delete;
  Surface_with_sources& operator=(const Surface_with_sources&) = delete;

  const Surface& surface() const { return m_surface; }

  // The mesh with the sources as vertices, once they are inserted.
  const Intrinsic_mesh<double>& mesh() const { return m_surface.mesh(); }

  // --- building ---

  // Avoids faces and edges when the mesh is read the next time (Intrinsic_surface). Sources and the mesh that has been
  // read stay as they are until then.
  void avoid(Obstacles obstacles) { m_surface.avoid(std::move(obstacles)); }

  // Reads the user's mesh, and removes all sources. Throws Invalid_geodesic_input; then nothing changes.
  template <typename Shape, typename Blocks>
  void read(Shape shape, Blocks blocks)
  {
    m_surface.read(std::move(shape), blocks);
    // In this order: restart() lets the insertion forget the faces of the former mesh. Otherwise clear_sources() would
    // write them into the new one.
    m_insertion.restart();
    clear_sources();
  }

  // Forgets sources and mesh, and frees their memory. The sources go first, while their mesh is still there.
  void forget()
  {
    clear_sources();
    m_surface.forget();
  }

  // Removes all sources, and restores the mesh. Vertices and faces of the first mesh get the same bits as before.
  // Sources that have been added, but not inserted, are forgotten as well.
  void clear_sources()
  {
    m_insertion.undo();
    m_are_inserted = false;
    m_sources = Source_set<double>();
    m_curves.clear();
  }

  // Appends a source; throws Invalid_geodesic_input, with `what` in the message. The offset is in the user's unit,
  // finite and not negative.
  // Requires: the sources are not inserted. If it throws, clear_sources() has to follow: the set of sources may be
  // incomplete.
  template <typename Source>
  void add_source(const Source& source, double offset, const char* what)
  {
    CGAL_assertion(!m_are_inserted);
    m_surface.add_source(source, m_sources, what);
    m_surface.add_offset(offset, m_sources);
  }

  // Appends a curve. Throws and requires what add_source() does.
  template <typename Curve>
  void add_source_curve(const Curve& curve, double offset, const char* what)
  {
    CGAL_assertion(!m_are_inserted);
    m_curves.emplace_back(m_sources.size(), m_surface.located_curve(curve, m_sources.size(), what));
    m_sources.vertices.push_back(null_id);
    m_surface.add_offset(offset, m_sources);
  }

  // Are there curves among the sources? The list tells, whether it is inserted or not.
  bool has_curves() const { return !m_curves.empty(); }

  // Inserts curves and points unless that is done: insert(curves, insertion) makes edges and vertices of them. Throws
  // what it throws; then nothing is inserted. Requires: has_curves().
  template <typename Insert>
  void insert_curves(Insert insert)
  {
    if(m_are_inserted)
      return;
    try // a part of the curves may be in the mesh when rounding shows that they cannot be told apart
    {
      insert(sources_as_curves(), m_insertion);
    }
    catch(...)
    {
      m_insertion.undo();
      throw;
    }
    m_are_inserted = true;
  }

  // Makes vertices of all sources, unless they are vertices already. Does nothing if they are inserted, so that a run
  // may be repeated. Sources at one point become one vertex. Requires: !has_curves().
  void insert_sources()
  {
    if(m_are_inserted)
      return;
    // The list of sources is complete only now. (If an exception has ended an insertion, they are listed already.)
    if(m_sources.behind_walls.empty())
      m_surface.add_sources_behind_walls(m_sources);
    insert_located_sources(m_sources.located, m_insertion, m_sources.vertices);
    m_numbers.assign(m_sources);
    m_are_inserted = true;
  }

  // --- sources, once they are inserted ---

  const Source_set<double>& sources() const { return m_sources; }

  // Returns the number of the source that counts at v. Requires: there is a source at v.
  std::size_t source_at(Vertex_id v) const { return m_numbers.number_at(v); }

  // --- from the refined mesh to the user ---

  // Returns the user's face, and the coordinates in the order of its corners, of a point of a face of the refined mesh.
  // Takes expected constant time.
  std::pair<face_descriptor, Coordinates> user_location(Face_id f, Coordinates b) const
  {
    const Face_id whole = m_insertion.parts().coordinates_in_whole(f, b);
    return m_surface.location(whole, b);
  }

  // The same for the point at fraction t of a halfedge of the refined mesh.
  std::pair<face_descriptor, Coordinates> user_location_on_edge(Halfedge_id h, double t) const
  {
    return user_location(face_of(h), coordinates_on_halfedge(h, t));
  }

  // Returns the user's face of which a face is a part.
  face_descriptor user_face(Face_id f) const { return m_surface.descriptor_of_face(m_insertion.parts().whole(f)); }

  const Face_parts<double>& parts() const { return m_insertion.parts(); }

  // --- the tangent frame of a source; trace_geodesic.h documents it ---

  // Returns the direction of a departure from a source that is a vertex of the user: the angle from
  // opposite(halfedge(v, tm), tm), scaled to a full turn, or at the border the angle from the first halfedge. Linear in
  // the degree.
  Direction_at_source direction_at_vertex(const Departure<double>& d) const
  {
    const Halfedge_id wanted = m_surface.halfedge_of_frame(mesh().source(d.halfedge));
    Angle_around<double> a = angle_around(mesh(), d, [&](Halfedge_id h)
    {
      double t = 0;
      return wanted != null_id && parts().find_on_whole_edge(h, t) && h == wanted;
    });
    // The user's halfedge is the first one at a border of most meshes, but anywhere in the umbrella where faces have
    // been removed or are avoided, and between walls.
    if(!a.is_closed)
      a = angle_around(mesh(), d, [](Halfedge_id) { return false; });
    return {a.is_closed && a.total > 0 ? a.angle / a.total * full_turn : a.angle, !a.is_closed};
  }

  // Returns the direction of a departure from a source in the face f of the user, or on an edge of it: the angle from
  // halfedge(f, tm). If f is avoided, or lies across a wall from the path, the face that the path enters first stands
  // for it. Of the parts of the face around the source, the largest one knows best where that halfedge is. Linear in
  // the degree.
  Direction_at_source direction_in_face(const Departure<double>& d, face_descriptor f) const
  {
    Direction_at_source result{0, false};
    const Halfedge_id first = m_surface.first_halfedge(f);
    if(first == null_id || !find_direction_in_face(d, first, result))
      find_direction_in_face(d, m_surface.first_halfedge(user_face(face_of(d.halfedge))), result);
    return result;
  }
  // --- queries: they throw Invalid_geodesic_input ---

  Query query(vertex_descriptor v) const
  {
    Query q;
    q.vertex = m_surface.checked_id(v, "the query", Invalid_geodesic_input::no_element);
    return q;
  }

  // A location with coordinates that are nearly those of a vertex is that vertex. Takes time linear in the number of
  // parts of the face.
  template <typename BarycentricCoordinates>
  Query query(face_descriptor f, const BarycentricCoordinates& b) const
  {
    const std::size_t no_element = Invalid_geodesic_input::no_element;
    const auto at = m_surface.location_beside_avoided_faces(f, b, "the query", no_element);
    const Halfedge_id h = at.first;
    Coordinates c = at.second;
    snap_coordinates(c);
    return query_at(face_of(h), c);
  }

  // A vertex has its copies in a table; a location is looked up in the face across, as only the user's mesh knows that
  // face.
  //
  // Calls visit(Query) for the same point on each other side of the walls there. Linear in the number of sides, and in
  // the number of parts of a face.
  template <typename Visit>
  void for_each_other_side(const Query& q, Visit visit) const
  {
    if(q.vertex < m_surface.number_of_vertices())
      m_surface.for_each_copy(q.vertex, [&](Vertex_id c)
      {
        Query other = q;
        other.vertex = c;
        if(c != q.vertex)
          visit(other);
      });
    else if(q.is_on_edge && m_surface.has_walls())
    {
      Coordinates c = q.coordinates;
      const Face_id whole = parts().coordinates_in_whole(q.face, c);
      const auto behind = m_surface.location_behind_wall(whole, c);
      if(behind.first != null_id)
        visit(query_at(face_of(behind.first), behind.second));
    }
  }

  // Returns the query, a location, as a point of a path.
  static Path_item<double> path_item(const Query& q)
  {
    Path_item<double> item;
    item.face = q.face;
    if(!q.is_in_face)
      item.vertex = q.vertex;
    else if(q.is_on_edge && q.vertex == null_id)
      for(unsigned int k = 0; k < 3; ++k)
        if(q.coordinates[previous_corner(k)] == 0)
          item.local_halfedge = halfedge_of(q.face, k);
    return item;
  }

private:
  // Finds the same from the halfedge `first` of a face of the first mesh. Returns false if the source has no part of
  // that face around it.
  bool find_direction_in_face(const Departure<double>& d, Halfedge_id first, Direction_at_source& result) const
  {
    Halfedge_id reference = null_id;
    double angle = 0, largest = 0;
    mesh().for_each_halfedge_around(mesh().source(d.halfedge), [&](Halfedge_id h)
    {
      const Face_part<double>* const part = parts().find_part_of(face_of(h));
      if(part == nullptr || part->whole != face_of(first))
        return;
      const auto a = angle_to_side_of_part(mesh().face(face_of(h)), part->corner, index_in_face(h),
                                           index_in_face(first));
      if(a[1] > largest)
      {
        reference = h;
        angle = a[0];
        largest = a[1];
      }
    });
    if(reference != null_id)
      result.angle = angle + angle_around(mesh(), d, [&](Halfedge_id h) { return h == reference; }).angle;
    return reference != null_id;
  }

  // Queries of users come here, and the other sides of walls.
  //
  // Returns the query for the point c of a face of the first mesh. Requires: the coordinates are snapped.
  Query query_at(Face_id f, Coordinates c) const
  {
    Query q;
    q.is_location = true;
    for(unsigned int k = 0; k < 3; ++k)
      if(c[k] == 1)
        q.vertex = corner_vertex(f, k);
    if(q.vertex != null_id)
      return q;
    q.is_in_face = true;
    // The edges of the face as a whole count here. part_with() changes c to the coordinates in a part.
    q.is_on_edge = c[0] == 0 || c[1] == 0 || c[2] == 0;
    q.face = parts().part_with(mesh(), f, c);
    q.coordinates = c;
    for(unsigned int k = 0; k < 3; ++k) // at a source
      if(c[k] == 1)
        q.vertex = mesh().face(q.face).vertex[k];
    return q;
  }

  // Strips and windows need one numbering of all sources, so points beside curves are curves without length. Walls
  // divide both alike: a piece keeps the number of its source, so queries know nothing of pieces.
  std::vector<Located_curve<double>> sources_as_curves() const
  {
    std::vector<Located_curve<double>> result(m_sources.size());
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i].vertex = m_sources.vertices[i];
    for(const Located_source<double>& s : m_sources.located)
      result[s.position].segments.push_back({s.face, s.coordinates, s.coordinates});
    for(const auto& c : m_curves)
      result[c.first] = c.second;
    for(std::size_t i = 0; i < result.size(); ++i)
    {
      result[i].offset = m_sources.offset(i);
      result[i].number = static_cast<std::uint32_t>(i);
    }
    m_surface.divide_at_walls(result);
    return result;
  }

  // Returns the vertex at corner k of a face of the mesh as it was before sources were inserted. After insertions, f is
  // the number of one of the parts of that face, whose corners may be others.
  Vertex_id corner_vertex(Face_id f, unsigned int k) const
  {
    Coordinates c{};
    c[k] = 1;
    const Face_id part = parts().part_with(mesh(), f, c);
    return mesh().face(part).vertex[nearest_corner(c)];
  }

  // The mesh of m_surface is the one that m_insertion changes.
  Surface m_surface;
  Source_insertion<double> m_insertion;
  // As added; vertices are known once they are inserted. A curve has its number here, but neither a vertex nor a place.
  Source_set<double> m_sources;
  std::vector<std::pair<std::size_t, Located_curve<double>>> m_curves; // with their numbers
  Source_numbers m_numbers;
  bool m_are_inserted = false;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SURFACE_WITH_SOURCES_H
