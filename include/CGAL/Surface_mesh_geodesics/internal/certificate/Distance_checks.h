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

// Conditions that hold for the distances of the vertices of a surface, and for no others. Nothing here depends on
// how the distances were found; paths are only believed when they have been measured.
//
// The vertices from `number_of_values` on are sources that have been made vertices: the distances are not asked there,
// but no distance may be greater than by way of them.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Straight_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Worst_violation.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Component_extents.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/path_tracing.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT_>
class Distance_checks
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Violation = Worst_violation<FT>;

  // `values` are the distances to be checked, by vertex, in the unit of the mesh; `offsets` the smallest offset of the
  // sources at each vertex, or infinity. Both are set by the caller before any check.
  Distance_checks(const Mesh& mesh, std::size_t number_of_values)
    : values(mesh.number_of_vertices(), infinity()), offsets(mesh.number_of_vertices(), infinity()), m_mesh(mesh),
      m_number_of_values(number_of_values), m_scale(mesh.number_of_vertices(), FT(0)),
      m_extents(extents_of_components(mesh))
  {
    for(Face_id f = 0; f < mesh.number_of_faces(); ++f)
      for(const Vertex_id v : mesh.face(f).vertex)
        m_scale[v] = (std::max)(m_scale[v], longest_side(m_mesh.face(f)));
  }

  std::vector<FT> values, offsets;

  // No value is greater than the offset of a source there.
  Violation check_sources() const
  {
    Violation worst;
    for(Vertex_id v = 0; v < m_number_of_values; ++v)
      if(offsets[v] < infinity())
        look_at(values[v] - offsets[v], values[v], v, worst);
    return worst;
  }

  // Values are numbers, not negative, and finite exactly where faces lead to a source, but none is beyond `limit`.
  Violation check_reach(const FT& limit) const
  {
    const std::vector<char> is_connected = vertices_connected_to_sources();
    Violation worst;
    for(Vertex_id v = 0; v < m_number_of_values; ++v)
    {
      const bool is_infinite = values[v] == infinity();
      const bool is_finite = values[v] >= 0 && values[v] <= limit * (1 + Tolerance<FT>::path()) && !is_infinite;
      const bool is_right
        = is_connected[v] != 0 ? (is_finite || (is_infinite && limit < infinity())) : is_infinite;
      worst.look_at(is_right ? FT(0) : infinity(), FT(1), FT(1), v);
    }
    return worst;
  }

  // No value is greater than that of the other end of an edge by more than the length of the edge. Beyond `limit` there
  // are no values.
  Violation check_edges(const FT& limit) const
  {
    Violation worst;
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
      {
        const Halfedge_id h = halfedge_of(f, k);
        look_at_way(m_mesh.source(h), m_mesh.target(h), m_mesh.length(h), limit, worst);
        look_at_way(m_mesh.target(h), m_mesh.source(h), m_mesh.length(h), limit, worst);
      }
    return worst;
  }

  // The same along the straight line between the vertices opposite to an edge, where it crosses the edge.
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
        // the other vertex of the face of o, in the frame of h
        const FT x = below.apex_rest, height = above.apex_y + below.apex_y;
        if(!(height > 0))
          continue;
        const FT crossing = x + (above.apex_x - x) * (below.apex_y / height);
        if(crossing >= 0 && crossing <= above.length)
          look_at_way(below.apex, above.apex, norm<FT>(above.apex_x - x, height), limit, worst);
      }
    return worst;
  }

  // No value is greater than a lower bound.
  Violation check_lower_bounds(const std::vector<FT>& bounds, const FT& limit) const
  {
    Violation worst;
    for(Vertex_id v = 0; v < m_number_of_values; ++v)
      if(!is_beyond(v, bounds[v], limit) && bounds[v] < infinity())
        look_at(values[v] - bounds[v], bounds[v], v, worst);
    return worst;
  }

  // Each value is the length of a path to a source, with the offset of that.
  Violation check_paths(const Vertex_distance_field<FT>& field, const FT& limit) const
  {
    const Path_tracer<FT> tracer(m_mesh, field);
    Path_steps<FT> path;
    Violation worst;
    for(Vertex_id v = 0; v < m_number_of_values; ++v)
    {
      if(!(field.distance[v] < infinity()))
        continue;
      path.clear();
      const FT length = tracer.trace_from_vertex(v, path) ? length_to_source(path) : infinity();
      if(is_beyond(v, length, limit))
        continue;
      look_at(length < values[v] ? FT(values[v] - length) : FT(length - values[v]), length, v, worst);
    }
    return worst;
  }

  // For each vertex, the longest edge of its component.
  const std::vector<FT>& extents() const { return m_extents; }

  // The value of v against its distance from the sources, computed the other way round.
  void look_at_reverse(Vertex_id v, const Vertex_distance_field<FT>& field_of_v, const FT& limit,
                       Violation& worst) const
  {
    FT reverse = infinity();
    for(Vertex_id s = 0; s < offsets.size(); ++s)
      if(offsets[s] < infinity())
        reverse = (std::min)(reverse, FT(offsets[s] + field_of_v.distance[s]));
    if(is_beyond(v, reverse, limit) || (!(values[v] < infinity()) && !(reverse < infinity())))
      return;
    look_at(reverse < values[v] ? FT(values[v] - reverse) : FT(reverse - values[v]), reverse, v, worst);
  }

  // The length of a path on the surface, from its first vertex to a source, and the offset of the source; infinity if
  // it does not end at a source, or a piece of it is in no face.
  FT length_to_source(const Path_steps<FT>& path) const
  {
    if(path.empty() || path.front().vertex == null_id || path.back().vertex == null_id)
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
    return length + offsets[path.back().vertex];
  }

private:
  static FT infinity() { return std::numeric_limits<FT>::infinity(); }

  // is there rightly no value for a vertex at this distance?
  bool is_beyond(Vertex_id v, const FT& distance, const FT& limit) const
  {
    return limit < infinity() && distance > limit * (1 - Tolerance<FT>::path()) && values[v] == infinity();
  }

  // the length of a path by way of v, as far as v tells; infinity if it tells nothing.
  FT value_on_the_way(Vertex_id v) const
  {
    return v < m_number_of_values ? values[v] : offsets[v];
  }

  // a condition on the value of v, where the right number is `number`.
  void look_at(const FT& excess, const FT& number, Vertex_id v, Violation& worst) const
  {
    worst.look_at(excess, number + m_scale[v], m_extents[v], v);
  }

  void look_at_way(Vertex_id from, Vertex_id to, const FT& length, const FT& limit, Violation& worst) const
  {
    const FT value = value_on_the_way(from), d = value + length;
    if(to >= m_number_of_values || !(value >= 0 && value < infinity()) || is_beyond(to, d, limit))
      return;
    look_at(values[to] - d, d, to, worst);
  }

  std::vector<char> vertices_connected_to_sources() const
  {
    std::vector<char> is_connected(m_mesh.number_of_vertices(), 0);
    std::vector<Vertex_id> sources;
    for(Vertex_id v = 0; v < offsets.size(); ++v)
      if(offsets[v] < infinity())
        sources.push_back(v);
    for_each_connected_vertex(m_mesh, std::move(sources), is_connected, [](Vertex_id) {});
    return is_connected;
  }

  // finds the coordinates of a point of a path in the layout of a face; false if it is not on the border of the face.
  bool is_in_face(const Path_step<FT>& point, Face_id f, std::array<FT, 2>& p) const
  {
    if(f >= m_mesh.number_of_faces())
      return false;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k);
      if(point.vertex != null_id ? m_mesh.source(h) == point.vertex : point.halfedge == h)
        return place_in_layout(f, k, point.vertex != null_id ? FT(0) : point.x, p);
      if(point.vertex == null_id && m_mesh.opposite(h) == point.halfedge)
        return place_in_layout(f, k, m_mesh.length(h) - point.x, p);
    }
    return false;
  }

  // the point at x of halfedge k of f.
  bool place_in_layout(Face_id f, unsigned int k, const FT& x, std::array<FT, 2>& p) const
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
  std::size_t m_number_of_values;
  std::vector<FT> m_scale;   // the longest edge of the faces around a vertex
  std::vector<FT> m_extents; // the longest edge of the component of a vertex
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_DISTANCE_CHECKS_H
