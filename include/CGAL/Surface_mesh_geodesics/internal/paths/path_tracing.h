// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_TRACING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_TRACING_H

// Shortest paths, from their end back to the source. A path is a chain of straight pieces; each of them
// ends at a vertex, from where the path goes on as it arrived there. No windows are needed, only how the
// path arrives at each vertex (Vertex_distance_field.h, with images).
//
// The length of the path is checked against the distance, piece by piece. If rounding has led the line
// astray, it is followed once more, and runs through vertices from which it was just told apart before. If that
// fails as well, the path is looked for by its length alone (Path_search.h).

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Path_search.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Straight_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/distance_at_location.h>

#include <array>
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
    if(trace_onwards(v, path))
      return true;
    path.resize(1);
    return search(m_field.distance[v], [&](Path_search<FT>& s, const FT& tolerance)
    { return s.from_vertex(v, tolerance, path); });
  }

  // appends the path from the point of face f with the coordinates b, which does not belong to it itself.
  bool trace_from_location(Face_id f, const std::array<FT, 3>& b, const Location_arrival<FT>& arrival,
                           Steps& path) const
  {
    if(trace_along(f, arrival, path))
      return true;
    path.clear();
    return search(arrival.distance, [&](Path_search<FT>& s, const FT& tolerance)
    { return s.from_location(f, b, arrival.root, arrival.distance, tolerance, path); });
  }

private:
  // the path from a point of face f as it arrives there.
  bool trace_along(Face_id f, const Location_arrival<FT>& arrival, Steps& path) const
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
      v = trace_piece({arrival.halfedge, arrival.x, arrival.y, arrival.abscissa, arrival.image_x,
                       arrival.image_depth, arrival.root, arrival.distance},
                      path);
    return v != null_id && trace_onwards(v, path);
  }

  // looks for a path of the length `distance`, first for one that is as near to it as rounding lets hope: relative to
  // the distance, then to the lengths of the mesh, of which the longest is about 1.
  template <typename Search>
  bool search(const FT& distance, Search search_with) const
  {
    const FT relative = Tolerance<FT>::path() * distance, absolute = Tolerance<FT>::lengthwise();
    Path_search<FT> s(m_mesh, m_field);
    for(const FT& tolerance : {FT(relative / 64), relative, FT(relative + absolute), FT(64 * relative + 8 * absolute)})
      if(search_with(s, tolerance))
        return true;
    return false;
  }

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
    const Face_frame<FT> c = m_mesh.face_frame(arrival.halfedge);
    return {arrival.halfedge, c.apex_x, c.apex_y, arrival.abscissa, image.x, image.depth, arrival.root,
            m_field.distance[v]};
  }

  // appends a piece; returns the vertex where it ends, or null_id if no way of following the line gives the
  // right length. The first attempt takes only lengths for rounded that it meets itself; but the distance
  // and the image may come from farther away, so the next one takes all lengths of the mesh.
  Vertex_id trace_piece(const Piece_start<FT>& start, Steps& path) const
  {
    const std::size_t size = path.size();
    for(const int smallest_scale : {0, 1})
    {
      Straight_piece<FT> piece(m_mesh, m_field, FT(smallest_scale), path);
      const Vertex_id end = piece.trace(start);
      if(end != null_id)
        return end;
      path.resize(size);
    }
    return null_id;
  }

  const Mesh& m_mesh;
  const Field& m_field;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_TRACING_H
