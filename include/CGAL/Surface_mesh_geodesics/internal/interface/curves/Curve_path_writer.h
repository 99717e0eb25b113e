// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_CURVE_PATH_WRITER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_CURVE_PATH_WRITER_H

// Makes segments of a curve out of shortest paths, for shortest_path_curve(). Lazy_path_structure traces the paths and
// tells their vertices, edges and faces; here each piece becomes a segment of the face that it crosses.

#include <CGAL/Surface_mesh_geodesics/internal/interface/curves/curve_segments.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/path_visitors.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Appends a path to a curve: a visitor of the elements of the path, which is told the face of each segment. The face
// decides where several faces have both ends of a segment, as at pinched vertices. The first element is the end of the
// curve so far. `position` is that of the first point, for rejections.
//
// A segment is kept in the face through which the path runs, so that it avoids the faces that the path avoids. All
// arguments are referred to.
template <typename Paths, typename Segment>
class Curve_path_writer
{
  using Triangle_mesh = typename Paths::Triangle_mesh;
  using Point = Point_of_faces<Triangle_mesh>;
  using Segments = std::vector<Segment>;

public:
  using vertex_descriptor = typename Paths::vertex_descriptor;
  using halfedge_descriptor = typename Paths::halfedge_descriptor;
  using face_descriptor = typename Paths::face_descriptor;

  Curve_path_writer(const Paths& paths, std::size_t position, Segments& segments)
    : m_paths(paths), m_position(position), m_segments(segments)
  {}

  // The next piece runs through the face f.
  void enter(face_descriptor f) { m_face = f; }

  // The path is at a vertex, at a point of a halfedge, or at a point of a face; a piece leads there from the element
  // before.
  void operator()(vertex_descriptor v) { append(Point(m_paths.mesh(), v, m_position)); }

  void operator()(halfedge_descriptor h, const typename Paths::FT& t)
  {
    append(Point(m_paths.mesh(), Paths::Locations::location(h, t, m_paths.mesh(), m_paths.traits()), m_position));
  }

  void operator()(face_descriptor f, const typename Paths::Barycentric_coordinates& b)
  {
    append(Point(m_paths.mesh(), std::make_pair(f, m_paths.weights(b)), m_position));
  }

private:
  // Rounding may move a point of an edge to a vertex, but never out of the face of its segment.
  void append(const Point& q)
  {
    if(m_last != nullptr)
      append_segment(m_paths.mesh(), *m_last, q, m_position, m_segments, m_face);
    m_last.reset(new Point(q));
  }

  const Paths& m_paths;
  std::size_t m_position;
  Segments& m_segments;
  face_descriptor m_face = boost::graph_traits<Triangle_mesh>::null_face();
  std::unique_ptr<Point> m_last; // null before the first element
};

template <typename Paths, typename Segment>
struct Wants_faces_of_segments<Curve_path_writer<Paths, Segment>> : std::true_type
{};

// Appends the shortest path from one place to another. Reads the mesh if `paths` has not read it yet, and propagates no
// farther than the places are apart. Appends nothing if they are one point. Throws Invalid_geodesic_input, with the
// position of the first place, if no path connects them.
// `paths` is a Lazy_path_structure, whose sources are replaced; places are vertices, or locations of its type.
template <typename Paths, typename Place, typename Segment>
void append_path(Paths& paths, const Place& from, const Place& to, std::size_t position,
                 std::vector<Segment>& segments)
{
  paths.remove_all_sources();
  paths.add_source(to);
  Curve_path_writer<Paths, Segment> writer(paths, position, segments);
  if(paths.single_sequence(from, writer).first < 0)
    reject_curve(position, "and the next one are not connected by a path");
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_CURVE_PATH_WRITER_H
