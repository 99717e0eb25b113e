// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATH_TRACING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATH_TRACING_H

// level: 5 (readers)
//
// Shortest paths, from their end back to the source. A path is a chain of straight pieces; each of them
// ends at a vertex, from where the path goes on as it arrived there. No windows are needed, only how the
// path arrives at each vertex (Vertex_distance_field.h, with images).
//
// The length of the path is checked against the distance, piece by piece. If rounding has led the line
// astray, it is followed once more, and runs through vertices from which it was just told apart before.

#include <CGAL/Surface_mesh_geodesics/internal/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/Straight_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/distance_at_location.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
class Path_tracer
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;
  using Steps = Path_steps<FT>;

  Path_tracer(const Mesh& mesh, const Field& field) : m_mesh(mesh), m_field(field) {}

  // appends the path from v, which is reached, to its source; both belong to it. Returns false if no path
  // of the right length has been found.
  bool trace_from_vertex(Vertex_id v, Steps& path) const
  {
    Path_step<FT> first;
    first.vertex = v;
    path.push_back(first);
    return trace_onwards(v, path);
  }

  // appends the path from a point of face f, which does not belong to it itself.
  bool trace_from_location(Face_id f, const Location_arrival<FT>& arrival, Steps& path) const
  {
    Vertex_id v = arrival.root;
    if(arrival.halfedge == null_id)
    {
      Path_step<FT> step;
      step.vertex = v;
      step.face = f;
      step.gap = arrival.inside;
      path.push_back(step);
    }
    else
      v = trace_piece({arrival.halfedge, arrival.x, arrival.y, arrival.crossing, arrival.image_x,
                       arrival.image_depth, arrival.root, arrival.distance},
                      path);
    return v != null_id && trace_onwards(v, path);
  }

private:
  // appends the path from v, which itself has been appended. The distances along the chain of vertices
  // decrease; each vertex may come once where they are all the same.
  bool trace_onwards(Vertex_id v, Steps& path) const
  {
    for(std::size_t i = 0; i <= m_mesh.number_of_vertices() && v != null_id; ++i)
    {
      if(m_field.is_source(v))
        return true;
      v = trace_piece(piece_to(v), path);
    }
    return false;
  }

  Piece_start<FT> piece_to(Vertex_id v) const
  {
    const Vertex_arrival<FT>& arrival = m_field.arrival[v];
    const Arrival_image<FT>& image = m_field.image[v];
    const Crossing<FT> c = m_mesh.crossing(arrival.halfedge);
    return {arrival.halfedge, c.apex_x, c.apex_y, arrival.crossing, image.x, image.depth, arrival.root,
            m_field.distance[v]};
  }

  // appends a piece; returns the vertex where it ends, or null_id if no way of following the line gives the
  // right length. The first attempt takes only lengths for rounded that it meets itself; but the distance
  // and the image may come from farther away, so the next one takes all lengths of the mesh. The last one
  // lets a path run through vertices that it passes at 1e-5 of its length, if it becomes no longer than by 6e-11
  // of its length.
  Vertex_id trace_piece(const Piece_start<FT>& start, Steps& path) const
  {
    const std::size_t size = path.size();
    Line_tolerance<FT> tolerance{Tolerance<FT>::sideways(), Tolerance<FT>::lengthwise(), FT(0), FT(0), false};
    for(int attempt = 0; attempt < 6; ++attempt)
    {
      Straight_piece<FT> piece(m_mesh, m_field, tolerance, path);
      const Vertex_id end = piece.trace(start);
      if(end != null_id)
        return end;
      path.resize(size);
      if(attempt > 0)
      {
        tolerance.lengthwise = 8 * Tolerance<FT>::lengthwise();
        tolerance.sideways = 64 * tolerance.sideways;
        tolerance.may_change_source = true; // two sources in one place
        tolerance.detour = (std::max)(Tolerance<FT>::path(), FT(4 * tolerance.detour));
      }
      tolerance.smallest_scale = 1;
    }
    return null_id;
  }

  const Mesh& m_mesh;
  const Field& m_field;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATH_TRACING_H
