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

// Traces shortest paths from their end back to the source. A path is a chain of straight pieces. Each of them ends at a
// vertex, from where the path goes on in the direction in which it arrived there. Tracing needs no windows, only how
// the shortest path arrives at each vertex (Vertex_distance_field.h, with images); so the memory is that of the
// distances (thesis 3.3.3.1).
//
// The length of the path is checked against the distance, piece by piece. If rounding has made a line wrong, the line
// is followed a second time with wider tolerances: now it may run through vertices that the first pass has left on one
// side of it. If that fails as well, the path is searched for by its length alone (Path_search.h).

#include <CGAL/Surface_mesh_geodesics/internal/paths/Path_search.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Straight_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/distance_at_location.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

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

  // `curves` is null if all sources are points.
  Path_tracer(const Mesh& mesh, const Field& field, const Curve_arrivals<FT>* curves = nullptr)
    : m_mesh(mesh), m_field(field), m_curves(curves)
  {}

  // Appends the path from v to its source, both included. Returns false if no path of the right length has been found;
  // `path` is meaningless then.
  // Requires: v is reached, `path` is empty, the field has images. If it returns true: points that follow each other
  // share a face, the last one is a source or a point of a source edge, and the sum of the gaps plus the offset of the
  // source is the distance of v, up to Tolerance::path() of the distance for each piece.
  // Complexity: linear in the number of faces crossed, unless the search is needed.
  bool trace_from_vertex(Vertex_id v, Steps& path) const
  {
    CGAL_assertion(m_field.distance[v] < Field::infinity() && path.empty() && m_field.keeps_images);
    Path_step<FT> first;
    first.vertex = v;
    path.push_back(first);
    bool is_found = trace_onwards(v, path);
    if(!is_found)
    {
      path.resize(1);
      is_found = search(m_field.distance[v], [&](Path_search<FT>& s, const FT& tolerance)
      { return s.from_vertex(v, tolerance, path); });
    }
    CGAL_expensive_assertion(!is_found || is_path_of_length(path, m_field.distance[v]));
    return is_found;
  }

  // The same from the point of face f with the barycentric coordinates b, which is not appended.
  // Requires: `arrival` is that of the point, which is reached.
  bool trace_from_location(Face_id f, const std::array<FT, 3>& b, const Location_arrival<FT>& arrival,
                           Steps& path) const
  {
    CGAL_assertion(arrival.is_reached() && path.empty() && m_field.keeps_images);
    bool is_found = trace_along(f, arrival, path);
    if(!is_found)
    {
      path.clear();
      const std::uint32_t source = source_of_path(m_field, m_curves, arrival.root, arrival.side);
      is_found = search(arrival.distance, [&](Path_search<FT>& s, const FT& tolerance)
      { return s.from_location(f, b, source, arrival.distance, tolerance, path); });
    }
    CGAL_expensive_assertion(!is_found || is_path_of_length(path, arrival.distance));
    return is_found;
  }

private:
  // Follows the path from a point of face f as it arrives there: straight from a corner, or through an edge.
  bool trace_along(Face_id f, const Location_arrival<FT>& arrival, Steps& path) const
  {
    Piece_end end{arrival.root};
    if(arrival.halfedge == null_id)
    {
      Path_step<FT> step;
      step.vertex = arrival.root;
      step.face = f;
      step.gap = arrival.inside;
      path.push_back(step);
    }
    else
      end = trace_piece({arrival.halfedge, arrival.x, arrival.y, arrival.abscissa, arrival.image_x,
                         arrival.image_depth, arrival.root, arrival.distance, arrival.side},
                        path);
    return end.is_at_foot || (end.vertex != null_id && trace_onwards(end.vertex, path));
  }

  // Searches for a path whose length is `distance`, with wider and wider tolerances: the first search should not stop
  // at a path that is longer than necessary. Distances err by some epsilon for each face, relative to themselves and,
  // on small distances, to the lengths of the mesh, of which the longest is about 1.
  // - The first one suits a path through few faces.
  // - Tolerance::path(), with and without the error along one piece, is what Straight_piece accepts for one piece.
  // - The last one suits a path of many pieces.
  template <typename Search>
  bool search(const FT& distance, Search search_with) const
  {
    using T = Tolerance<FT>;
    const FT relative = T::path() * distance;
    Path_search<FT> s(m_mesh, m_field, m_curves);
    for(const FT& tolerance :
        {FT(T::path_through_few_faces() * distance), relative, FT(relative + T::lengthwise()),
         FT(T::path_of_many_pieces() * distance + T::lengthwise_of_many_pieces())})
      if(search_with(s, tolerance))
        return true;
    return false;
  }

  // Appends the path from v; the caller has appended v itself. Returns false if a piece is wrong. The distances do
  // not increase along the chain of vertices, so a chain longer than the number of vertices is wrong.
  bool trace_onwards(Vertex_id v, Steps& path) const
  {
    for(std::size_t i = 0; i <= m_mesh.number_of_vertices() && v != null_id; ++i)
    {
      if(m_field.is_source(v))
        return true;
      const Piece_end end = trace_piece(piece_to(v), path);
      if(end.is_at_foot)
        return true;
      v = end.vertex;
    }
    return false;
  }

  // Returns the last piece of the path to v, as the propagation has recorded it.
  // Requires: v is reached and is not a source.
  Piece_start<FT> piece_to(Vertex_id v) const
  {
    CGAL_assertion(m_field.arrival[v].halfedge != null_id);
    const Vertex_arrival<FT>& arrival = m_field.arrival[v];
    const Arrival_image<FT>& image = m_field.image[v];
    const Face_frame<FT> c = m_mesh.face_frame(arrival.halfedge);
    const bool comes_from_foot = arrival.root == v; // a strip has reached it last
    return {arrival.halfedge, c.apex_x, c.apex_y, arrival.abscissa, image.x, image.depth,
            comes_from_foot ? Vertex_id(null_id) : arrival.root, m_field.distance[v],
            comes_from_foot ? m_curves->foot[v].side : std::uint32_t(null_id)};
  }

  // Appends a piece and returns where it ends; if no attempt gives the right length, nothing is appended. The
  // tolerances of the first attempt are relative to the lengths on the way of the line. But the distance and the image
  // may come from farther away, so those of the second one are relative to the longest length of the mesh, 1.
  Piece_end trace_piece(const Piece_start<FT>& start, Steps& path) const
  {
    const std::size_t size = path.size();
    for(const int smallest_scale : {0, 1})
    {
      Straight_piece<FT> piece(m_mesh, m_field, FT(smallest_scale), path, m_curves);
      const Piece_end end = piece.trace(start);
      if(end.is_found())
        return end;
      path.resize(size);
    }
    return {};
  }

  // Checks what the trace functions promise: a source at the end, and the length, with a tolerance for each step. (Each
  // piece, and the search, has checked its own length; the errors of the pieces add up. The search accepts 64 times the
  // tolerance of a piece, so a path of few steps gets twice that.)
  bool is_path_of_length(const Steps& path, const FT& distance) const
  {
    using std::abs;
    const FT one = Tolerance<FT>::path() * distance + Tolerance<FT>::lengthwise() * (std::max)(FT(1), distance);
    const std::size_t for_search = 2 * 64;
    const FT number = FT(static_cast<double>(path.size() + for_search));
    return abs(FT(length_of(path) + offset_at_end(path) - distance)) <= number * one;
  }

  // A path to a foot ends inside of a source edge of the refined mesh; no other step of a path may end it there.
  //
  // Returns the offset of the source at which a path ends; infinity if it ends somewhere else.
  FT offset_at_end(const Steps& path) const
  {
    const Path_step<FT>& end = path.back();
    if(end.vertex != null_id)
      return m_field.is_source(end.vertex) ? m_field.distance[end.vertex] : Field::infinity();
    const std::uint32_t side = m_curves != nullptr ? m_curves->side_of(end.halfedge) : std::uint32_t(null_id);
    return side != null_id ? m_curves->edge_of_side(side).offset : Field::infinity();
  }

  const Mesh& m_mesh;
  const Field& m_field;
  const Curve_arrivals<FT>* m_curves;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_TRACING_H
