// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_DISTANCE_CHECKS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_DISTANCE_CHECKS_H

// Checks conditions that only exact distances of the vertices satisfy. Together with the lower bound
// (Lower_bound_check.h) they prove the distances. Nothing here depends on how the distances were found. A path counts
// only after its length has been measured.
//
// With d for the given values, the conditions are:
//   check_reach()           d(v) is a number, not negative, and finite exactly where faces lead to a source
//   check_sources()         d(s) <= offset of s, for each source s at a vertex with a value
//   check_edges()           d(w) <= d(v) + |vw| along each edge, in both directions
//   check_pairs_of_faces()  the same for the vertices opposite to an edge, if the segment between them crosses it
//   check_paths()           d(v) = the measured length of a path to a source + the offset of that source; the path to a
//                           curve ends at a vertex of it, or on an edge
//   check_lower_bounds()    d(v) <= u(v), the lower bound that Lower_bound_check proves
//   check_reverse()         d(v) = the smallest offset + distance of a source, computed from v
// check_paths() shows that no value is too short, check_lower_bounds() that none is too long.
//
// The last vertices of the mesh may be sources inside faces and on edges. No distance is given for them, but the
// conditions hold for paths through them.
//
// A violation is relative to the right value plus the longest edge of the faces around the vertex. Conditions that stem
// from an inequality d(v) <= d(w) + |vw| are computed with one addition and one subtraction, so rounding causes
// violations of a few epsilon. The length of a path errs by about one epsilon for each face that it crosses.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Straight_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Worst_violation.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Component_extents.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/path_tracing.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Each check returns the worst violation of one condition, and the number of its checks. Under a limit, a vertex whose
// right value is beyond it may have the value infinity (is_beyond()). All checks take linear time, except
// check_paths(), which takes the time to trace the paths, and check_reverse(), which is for one vertex.
template <typename FT_>
class Distance_checks
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Violation = Worst_violation<FT>;

  // `values` has the distances to be checked, by vertex, in the unit of the intrinsic mesh; offsets, limits and bounds
  // have the same unit. Vertices without a value come last. The mesh is referred to, not copied; the sources are
  // vertices of it already. Takes linear time.
  Distance_checks(const Mesh& mesh, std::vector<FT> values)
    : m_mesh(mesh), m_values(std::move(values)), m_offsets(mesh.number_of_vertices(), infinity()),
      m_scale(mesh.number_of_vertices(), FT(0)), m_extents(extents_of_components(mesh))
  {
    CGAL_assertion(m_values.size() <= mesh.number_of_vertices());
    for(Face_id f = 0; f < mesh.number_of_faces(); ++f)
      for(const Vertex_id v : mesh.face(f).vertex)
        m_scale[v] = (std::max)(m_scale[v], longest_side(m_mesh.face(f)));
  }

  // Adds a source at a vertex, which need not have a value. The smallest offset of the sources at a vertex counts. Call
  // it before any check.
  void add_source(Vertex_id v, const FT& offset) { m_offsets[v] = (std::min)(m_offsets[v], offset); }

  // Adds the points of an edge of a curve as sources. Its ends are added apart. One edge is added once.
  void add_source_edge(Halfedge_id h, const FT& offset)
  {
    m_offset_on_edge[h] = offset;
    if(m_mesh.opposite(h) != null_id)
      m_offset_on_edge[m_mesh.opposite(h)] = offset;
  }

  // --- conditions; `limit` is the radius up to which distances were computed, infinity if all were ---

  // No value is greater than the offset of a source at its vertex.
  Violation check_sources(const FT& limit) const
  {
    Violation worst;
    for(Vertex_id v = 0; v < m_values.size(); ++v)
      if(m_offsets[v] < infinity() && !is_beyond(v, m_offsets[v], limit))
        record(m_values[v] - m_offsets[v], m_values[v], v, worst);
    return worst;
  }

  // Values are numbers and not negative. They are finite where faces lead to a source and infinite elsewhere; with a
  // limit they may be infinite anywhere, and none is beyond the limit.
  Violation check_reach(const FT& limit) const
  {
    const std::vector<char> is_connected = vertices_connected_to_sources();
    Violation worst;
    for(Vertex_id v = 0; v < m_values.size(); ++v)
    {
      const bool is_infinite = m_values[v] == infinity();
      const bool is_finite = m_values[v] >= 0 && m_values[v] <= limit * (1 + Tolerance<FT>::path()) && !is_infinite;
      const bool is_right
        = is_connected[v] != 0 ? (is_finite || (is_infinite && limit < infinity())) : is_infinite;
      // The condition holds or fails: the violation is 0 or infinite, whatever the scale is.
      worst.record(is_right ? FT(0) : infinity(), FT(1), FT(1), v);
    }
    return worst;
  }

  // Along an edge, values grow by at most its length. Each face checks its edges in both directions, so an edge inside
  // the mesh counts up to four times as a check.
  Violation check_edges(const FT& limit) const
  {
    Violation worst;
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
      {
        const Halfedge_id h = halfedge_of(f, k);
        check_way(m_mesh.source(h), m_mesh.target(h), m_mesh.length(h), limit, worst);
        check_way(m_mesh.target(h), m_mesh.source(h), m_mesh.length(h), limit, worst);
      }
    return worst;
  }

  // Between the two vertices opposite to an edge, values grow by at most the length of the segment between them, in the
  // common plane of both faces, if it crosses the edge. (Otherwise the segment is not a path on the surface.) A
  // halfedge checks the way into its own face; its opposite checks the way back.
  Violation check_pairs_of_faces(const FT& limit) const
  {
    Violation worst;
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
      {
        const Halfedge_id h = halfedge_of(f, k), o = m_mesh.opposite(h);
        if(o == null_id)
          continue;
        const Face_frame<FT> above = m_mesh.face_frame(h), below = m_mesh.face_frame(o);
        // In the frame of h, the vertex of the other face is at (x, -below.apex_y): o runs from B to A, so that its
        // abscissas count from B. The segment meets the edge where y is 0, at the abscissa `crossing`. Two faces
        // without height have no such segment.
        const FT x = below.apex_rest, height = above.apex_y + below.apex_y;
        if(!(height > 0))
          continue;
        const FT crossing = x + (above.apex_x - x) * (below.apex_y / height);
        if(crossing >= 0 && crossing <= above.length)
          check_way(below.apex, above.apex, norm<FT>(above.apex_x - x, height), limit, worst);
      }
    return worst;
  }

  // No value is greater than the lower bound that Lower_bound_check proves. `bounds` has one for each vertex of the
  // mesh; infinity says that the witness reaches no source from there, which is left to check_reach().
  Violation check_lower_bounds(const std::vector<FT>& bounds, const FT& limit) const
  {
    CGAL_assertion(bounds.size() >= m_values.size());
    Violation worst;
    for(Vertex_id v = 0; v < m_values.size(); ++v)
      if(!is_beyond(v, bounds[v], limit) && bounds[v] < infinity())
        record(m_values[v] - bounds[v], bounds[v], v, worst);
    return worst;
  }

  // Each value is the length of a path to a source plus the offset of the source. The field proposes the paths; each is
  // measured here, in the faces that it names. A vertex that the field does not reach is left to check_reach(). If no
  // path is found, or it does not end at a source, the violation is infinite.
  // The loop over the vertices is that of `chunks` (Chunk_team.h). Before each path, go_on() is called; the check is
  // interrupted if it returns false. The result does not depend on the number of threads.
  // Requires: the field is that of a complete propagation on the same mesh, and has images (Path_tracer); `curves` has
  // what the propagation knows of curves, and is null if all sources are points.
  template <typename Chunks, typename GoOn>
  Violation check_paths(const Chunks& chunks, const Vertex_distance_field<FT>& field, const FT& limit, GoOn go_on,
                        const Curve_arrivals<FT>* curves = nullptr) const
  {
    const Path_tracer<FT> tracer(m_mesh, field, curves);
    const std::size_t n = m_values.size();
    std::vector<Violation> of_chunks(chunks.number_of_chunks(n));
    const bool is_complete
      = chunks(n, go_on, [&](std::size_t c, std::size_t first, std::size_t last, const auto& ask)
        {
          Path_steps<FT> path;
          Violation worst;
          for(std::size_t v = first; v < last && ask(); ++v)
            check_path(static_cast<Vertex_id>(v), tracer, field.distance[v], limit, path, worst);
          of_chunks[c] = worst;
        });
    return merged(of_chunks, is_complete);
  }

  // For each vertex, the longest edge of its component.
  const std::vector<FT>& extents() const { return m_extents; }

  // Checks that the value of v equals its distance from the sources, computed in reverse: `field_of_v` has the
  // distances from v, which are final at all sources. Distances are symmetric; offsets are added at the other end.
  // `to_edges` is the least distance from v to the edges of curves, with their offsets. A vertex that is reached in
  // neither way is left to check_reach(). Takes linear time.
  void check_reverse(Vertex_id v, const Vertex_distance_field<FT>& field_of_v, const FT& limit, Violation& worst,
                     const FT& to_edges = infinity()) const
  {
    FT reverse = to_edges;
    for(Vertex_id s = 0; s < m_offsets.size(); ++s)
      if(m_offsets[s] < infinity())
        reverse = (std::min)(reverse, FT(m_offsets[s] + field_of_v.distance[s]));
    if(is_beyond(v, reverse, limit) || (!(m_values[v] < infinity()) && !(reverse < infinity())))
      return;
    record(reverse < m_values[v] ? FT(m_values[v] - reverse) : FT(reverse - m_values[v]), reverse, v, worst);
  }

  // Returns the length of a path from its first vertex to a source, plus the offset of the source. Returns infinity if
  // the path does not start at a vertex, if its end is not a source, or if a piece of it is not in the face that the
  // path names for it. The lengths that the path itself states (Path_step::gap) are not read. Takes linear
  // time.
  FT length_to_source(const Path_steps<FT>& path) const
  {
    if(path.empty() || path.front().vertex == null_id)
      return infinity();
    FT length = 0;
    for(std::size_t i = 1; i < path.size(); ++i)
    {
      const Face_id f = path[i].face;
      std::array<FT, 2> from, to;
      if(!is_in_face(path[i - 1], f, from) || !is_in_face(path[i], f, to))
        return infinity();
      length += norm<FT>(to[0] - from[0], to[1] - from[1]);
    }
    return length + offset_at(path.back());
  }

private:
  static FT infinity() { return std::numeric_limits<FT>::infinity(); }

  // Returns the offset of the source at the end of a path; infinity if there is none.
  FT offset_at(const Path_step<FT>& end) const
  {
    if(end.vertex != null_id)
      return m_offsets[end.vertex];
    const auto it = m_offset_on_edge.find(end.halfedge);
    return it == m_offset_on_edge.end() ? infinity() : it->second;
  }

  // Checks the path of one vertex. `distance` is that of the field, and `path` is reused memory.
  void check_path(Vertex_id v, const Path_tracer<FT>& tracer, const FT& distance, const FT& limit,
                  Path_steps<FT>& path, Violation& worst) const
  {
    if(!(distance < infinity()))
      return;
    path.clear();
    const FT length = tracer.trace_from_vertex(v, path) ? length_to_source(path) : infinity();
    if(!is_beyond(v, length, limit))
      record(length < m_values[v] ? FT(m_values[v] - length) : FT(length - m_values[v]), length, v, worst);
  }

  // Returns whether v rightly has no value because its distance is beyond the limit. A distance within
  // Tolerance::path() of the limit may be on either side of it, and the vertex may have a value or none.
  bool is_beyond(Vertex_id v, const FT& distance, const FT& limit) const
  {
    return limit < infinity() && distance > limit * (1 - Tolerance<FT>::path()) && m_values[v] == infinity();
  }

  // Returns the distance with which a path continues at v; infinity if it is unknown. A source without a value has its
  // offset, which its distance does not exceed; so the condition on the way from there is never too strict.
  FT value_on_the_way(Vertex_id v) const
  {
    return v < m_values.size() ? m_values[v] : m_offsets[v];
  }

  // Checks a condition on the value of v that is violated by `excess`; `number` is the right value.
  void record(const FT& excess, const FT& number, Vertex_id v, Violation& worst) const
  {
    worst.record(excess, number + m_scale[v], m_extents[v], v);
  }

  // Checks that the value grows by at most `length` along a path between two vertices. Nothing is checked for a target
  // without a value, or from a vertex whose value is infinite or not a number: check_reach() looks at these.
  void check_way(Vertex_id from, Vertex_id to, const FT& length, const FT& limit, Violation& worst) const
  {
    const FT value = value_on_the_way(from), d = value + length;
    if(to >= m_values.size() || !(value >= 0 && value < infinity()) || is_beyond(to, d, limit))
      return;
    record(m_values[to] - d, d, to, worst);
  }

  // Returns, for each vertex, whether faces lead from it to a source.
  std::vector<char> vertices_connected_to_sources() const
  {
    std::vector<char> is_connected(m_mesh.number_of_vertices(), 0);
    std::vector<Vertex_id> sources;
    for(Vertex_id v = 0; v < m_offsets.size(); ++v)
      if(m_offsets[v] < infinity())
        sources.push_back(v);
    for_each_connected_vertex(m_mesh, std::move(sources), is_connected, [](Vertex_id) {});
    return is_connected;
  }

  // Computes the coordinates of a point of a path in the plane of a face, in its layout; returns false if the point is
  // not on the face's border. A point of an edge is named by either of the two halfedges, whose abscissas run against
  // each other.
  bool is_in_face(const Path_step<FT>& point, Face_id f, std::array<FT, 2>& p) const
  {
    if(f >= m_mesh.number_of_faces())
      return false;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k);
      if(point.vertex != null_id ? m_mesh.source(h) == point.vertex : point.halfedge == h)
        return position_in_plane(f, k, point.vertex != null_id ? FT(0) : point.x, p);
      if(point.vertex == null_id && m_mesh.opposite(h) == point.halfedge)
        return position_in_plane(f, k, m_mesh.length(h) - point.x, p);
    }
    return false;
  }

  // Computes the coordinates of the point with the abscissa x on halfedge k of a face; false if it is not between its
  // ends.
  bool position_in_plane(Face_id f, unsigned int k, const FT& x, std::array<FT, 2>& p) const
  {
    const Intrinsic_face<FT>& face = m_mesh.face(f);
    const std::array<Planar_point<FT>, 3> corner = layout_of_face(face);
    const Planar_point<FT>&a = corner[k], &b = corner[next_corner(k)];
    if(!(x >= 0) || !(x <= face.length[k]))
      return false;
    const FT share = x > 0 ? FT(x / face.length[k]) : FT(0);
    p = {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    return true;
  }

  const Mesh& m_mesh;
  std::vector<FT> m_values;  // by vertex with a value
  std::vector<FT> m_offsets; // by vertex; infinity where no source is
  std::unordered_map<Halfedge_id, FT> m_offset_on_edge; // by halfedge on an edge of a curve
  std::vector<FT> m_scale;   // the longest edge of the faces around a vertex
  std::vector<FT> m_extents; // the longest edge of the component of a vertex
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_DISTANCE_CHECKS_H
