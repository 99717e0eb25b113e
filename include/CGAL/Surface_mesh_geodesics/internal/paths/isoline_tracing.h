// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_TRACING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_TRACING_H

// Isolines from the windows of a propagation that has ended: the lines of all points at one distance, which separate
// nearer points from farther ones. isoline_crossings.h finds their points on edges, Isoline_graph.h joins them.
// (Isoline_sweep traces the lines of given distances while the propagation runs, which takes less memory.)

#include <CGAL/Surface_mesh_geodesics/internal/paths/Face_distances.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Isoline_graph.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/isoline_crossings.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>

#include <CGAL/assertions.h>

#include <array>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// An object may trace the lines of one value after the other, in one thread: it keeps its buffers. It changes nothing
// that it reads.
template <typename FT_>
class Isoline_tracer
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;
  using Windows = Edge_window_field<FT>;
  using Point = Isoline_point<FT>;

  // The error of a point is at most `resolution` times the length of its edge, beyond that of the distances.
  // Requires: `windows` holds those of the propagation that has filled `field`; resolution > 0.
  // `strips` are those of the same propagation if curves are among its sources, else null.
  Isoline_tracer(const Mesh& mesh, const Field& field, const Windows& windows, const FT& resolution,
                 const Edge_strip_field<FT>* strips = nullptr)
    : m_mesh(mesh), m_field(field), m_windows(windows), m_strips(strips), m_resolution(resolution)
  {
    CGAL_assertion(resolution > 0);
  }

  // Calls line(points, is_closed) for each line of points at the distance `value_of_line`, as
  // Isoline_graph::for_each_line() does. There is no line for a value that is zero, negative, infinite or not a number.
  // Complexity: linear in the number of faces, plus for each crossing a number of distance queries that is logarithmic
  // in the resolution.
  //
  // An edge is looked at with its first halfedge, whose face is not behind the other one.
  template <typename Line>
  void trace(const FT& value_of_line, Line line)
  {
    m_graph.reset(m_mesh);
    if(!(value_of_line > 0 && value_of_line < Field::infinity()))
      return;
    const FT value = dividing_value(value_of_line);
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
      if(may_hold(f, value))
      {
        for(unsigned int k = 0; k < 3; ++k)
          if(m_mesh.is_first_of_edge(halfedge_of(f, k)))
            find_points(halfedge_of(f, k), value);
        m_graph.connect(f, 0, m_field.distance[m_mesh.face(f).vertex[0]] < value,
                        [&](const std::array<FT, 3>& b)
        {
          start(f);
          return m_distances.at(b) < value;
        });
      }
    m_graph.for_each_line(0, line);
  }

private:
  using Distances = Face_distances<FT, Edge_strip_field<FT>>;

  // Returns whether an edge of a face may hold a point of the line. Both faces of an edge decide alike for that edge.
  bool may_hold(Face_id f, const FT& value) const
  {
    for(unsigned int k = 0; k < 3; ++k)
    {
      Halfedge_id h = halfedge_of(f, k);
      h = m_mesh.is_first_of_edge(h) ? h : m_mesh.opposite(h);
      if(may_hold_isoline(m_mesh.length(h), m_field.distance[m_mesh.source(h)], m_field.distance[m_mesh.target(h)],
                          value))
        return true;
    }
    return false;
  }

  // Reads what the distances in a face are made of, unless that has been done for this face.
  void start(Face_id f)
  {
    if(f != m_face)
      m_distances.start(m_mesh, m_field, m_windows, m_strips != nullptr ? *m_strips : m_no_strips, f);
    m_face = f;
  }

  void find_points(Halfedge_id h, const FT& value)
  {
    const FT length = m_mesh.length(h), d = m_field.distance[m_mesh.source(h)], e = m_field.distance[m_mesh.target(h)];
    m_graph.begin_edge(h);
    if(may_hold_isoline(length, d, e, value))
    {
      start(face_of(h));
      m_distances.start_edge(h);
      const auto add = [&](const FT& t) { m_graph.add(0, t); };
      Isoline_crossings<FT, Distances>(length, value, m_resolution, m_distances).find(FT(0), d, FT(1), e, add);
    }
    m_graph.end_edge();
  }

  const Mesh& m_mesh;
  const Field& m_field;
  const Windows& m_windows;
  const Edge_strip_field<FT>* m_strips;
  const Edge_strip_field<FT> m_no_strips;
  FT m_resolution;
  Isoline_graph<FT> m_graph;
  Face_id m_face = null_id; // the one that m_distances has read last
  Distances m_distances;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_TRACING_H
