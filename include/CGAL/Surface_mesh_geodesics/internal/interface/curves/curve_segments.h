// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_CURVE_SEGMENTS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_CURVE_SEGMENTS_H

// The segments of a curve from its locations: for two locations in a row, a face that has both, and their coordinates
// there. A location may be given in any face around it. So the faces of both points are compared, not those in which
// they are given: a point on an edge is in two faces, a vertex in all around it. Weights of the ends of an edge are
// carried from one of its faces to the other as they are, so that both see the same point.
//
// The corners of a face are in the user's order, which begins at the source of halfedge(f, tm).

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Is a type a point of the surface, or a range of such points? A curve is neither, although it is a source. Those who
// make curves or sites of an argument ask first, and leave the loop out if it would not compile: then the only message
// says what the argument has to be. (A type that is both counts as a point, as for sources.)
template <typename TriangleMesh, typename Sources>
struct Kind_of_places
{
  static constexpr bool is_place
    = Is_vertex<TriangleMesh, Sources>::value || Is_face_location<TriangleMesh, Sources>::value;
  static constexpr bool are_places
    = Is_range_of_sources<TriangleMesh, Sources>::value && !Are_curves<Sources>::value;
};

// Throws for a curve that is none. `position` is that of the location in the range of the user; `fault` ends the
// sentence.
[[noreturn]] inline void reject_curve(std::size_t position, const char* fault)
{
  throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_CURVE,
                               "location " + std::to_string(position) + " of the curve " + fault, position);
}

// A point of the surface with all faces that have it: a vertex, a point inside an edge, or inside a face.
template <typename TriangleMesh>
class Point_of_faces
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

public:
  using Coordinates = std::array<double, 3>;

  // Reads the point number `position` of a curve. Throws Invalid_geodesic_input. A vertex gets some face around it,
  // for a curve that is a single vertex; an isolated vertex has none.
  template <typename Location>
  Point_of_faces(const TriangleMesh& tm, const Location& location, std::size_t position)
  {
    if constexpr(Is_vertex<TriangleMesh, Location>::value)
    {
      m_vertex = location;
      if(m_vertex == Graph_traits::null_vertex())
        reject_curve(position, "is a null vertex");
      if(Removed_elements<TriangleMesh>::contain(m_vertex, tm))
        reject_curve(position, "is not a vertex of the mesh");
      const halfedge_descriptor h = halfedge(m_vertex, tm);
      if(h != Graph_traits::null_halfedge())
        for(const halfedge_descriptor g : halfedges_around_target(h, tm))
          if(!is_border(g, tm))
            m_face = face(g, tm);
    }
    else
      set_location(tm, location.first, location.second, position);
  }

  // The vertex, or the null vertex. A location with the coordinates of a corner, up to rounding, is a vertex, too.
  vertex_descriptor vertex() const { return m_vertex; }
  // The face in which the location is given, so that segments stay in the faces that the user has named; for a vertex,
  // some face around it, null if it is isolated.
  face_descriptor own_face() const { return m_face; }

  // Faces are those of the user's mesh, also where some of them are avoided: that is checked when the mesh is read.
  // Returns whether the face f has the point, at a corner, on an edge or inside, and sets its coordinates there.
  bool find_in(const TriangleMesh& tm, face_descriptor f, Coordinates& b) const
  {
    if(f == Graph_traits::null_face())
      return false;
    b = Coordinates{};
    halfedge_descriptor h = halfedge(f, tm);
    for(unsigned int k = 0; k < 3; ++k, h = next(h, tm))
      if(m_vertex != Graph_traits::null_vertex())
      {
        if(source(h, tm) == m_vertex)
        {
          b[k] = 1;
          return true;
        }
      }
      else if(m_edge != Graph_traits::null_halfedge() && (h == m_edge || h == opposite(m_edge, tm)))
      {
        b[k] = h == m_edge ? m_source_weight : m_target_weight;
        b[next_corner(k)] = h == m_edge ? m_target_weight : m_source_weight;
        return true;
      }
    b = m_coordinates;
    return m_vertex == Graph_traits::null_vertex() && m_edge == Graph_traits::null_halfedge() && f == m_face;
  }

  // Calls visit(face) for each face that has the point, the one in which it is given first; some faces may come twice.
  // Only the faces around a vertex may be many.
  // A border has no face, so it is passed over. The search for a common face ends with the first one that has both
  // points, but the walk around the vertex goes on; it is short.
  template <typename Visit>
  void for_each_face(const TriangleMesh& tm, Visit visit) const
  {
    visit(m_face);
    if(m_edge != Graph_traits::null_halfedge() && !is_border(opposite(m_edge, tm), tm))
      visit(face(opposite(m_edge, tm), tm));
    if(m_vertex != Graph_traits::null_vertex() && halfedge(m_vertex, tm) != Graph_traits::null_halfedge())
      for(const halfedge_descriptor g : halfedges_around_target(halfedge(m_vertex, tm), tm))
        if(!is_border(g, tm))
          visit(face(g, tm));
  }

private:
  // Finds out where a location is: coordinates that are zero up to rounding tell. Coordinates in the face itself stay
  // as they are given, those in a neighbor follow from the weights of the two ends of the edge. Both ends have a
  // positive weight inside an edge.
  template <typename BarycentricCoordinates>
  void set_location(const TriangleMesh& tm, face_descriptor f, const BarycentricCoordinates& b, std::size_t position)
  {
    m_face = f;
    if(f == Graph_traits::null_face())
      reject_curve(position, "has a null face");
    if(Removed_elements<TriangleMesh>::contain(f, tm))
      reject_curve(position, "has a face that is not in the mesh");
    m_coordinates = coordinates_in_double(b[0], b[1], b[2]);
    if(!are_valid_coordinates(m_coordinates))
      reject_curve(position, "is not in its face");
    snap_coordinates(m_coordinates);
    halfedge_descriptor h = halfedge(f, tm);
    for(unsigned int k = 0; k < 3; ++k, h = next(h, tm))
    {
      if(m_coordinates[k] == 1)
        m_vertex = source(h, tm);
      if(m_coordinates[previous_corner(k)] == 0 && m_coordinates[k] != 0 && m_coordinates[next_corner(k)] != 0)
      {
        m_edge = h;
        m_source_weight = m_coordinates[k];
        m_target_weight = m_coordinates[next_corner(k)];
      }
    }
  }

  vertex_descriptor m_vertex = Graph_traits::null_vertex();
  halfedge_descriptor m_edge = Graph_traits::null_halfedge(); // if the point is inside an edge, with its weights
  double m_source_weight = 0, m_target_weight = 0;
  face_descriptor m_face = Graph_traits::null_face();
  Coordinates m_coordinates{}; // in m_face, if the point is given by a location
};

// Throws for the first of the points all of whose faces are avoided: no path reaches it. A point at the rim has another
// face; an isolated vertex has none, and is none of these. is_avoided(f) tells of a face. Linear in the degrees of
// vertices.
template <typename TriangleMesh, typename IsAvoided>
void reject_points_inside(const TriangleMesh& tm, const std::vector<Point_of_faces<TriangleMesh>>& points,
                          const IsAvoided& is_avoided)
{
  const auto null_face = boost::graph_traits<TriangleMesh>::null_face();
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    bool is_inside = points[i].own_face() != null_face;
    points[i].for_each_face(tm, [&](auto f) { is_inside = is_inside && is_avoided(f); });
    if(is_inside)
      reject_curve(i, "is inside of the faces to avoid");
  }
}

// Returns the segment along the halfedge h in its face, or against its direction. Throws Invalid_geodesic_input with
// the given position if that face is not a triangle. Requires: h has a face.
template <typename Segment, typename TriangleMesh>
Segment segment_of_halfedge(const TriangleMesh& tm, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                            bool is_reversed, std::size_t position)
{
  if(!is_triangle(h, tm))
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::NOT_A_TRIANGLE,
                                 "the face of halfedge " + std::to_string(position)
                                   + " of the curve does not have three edges", position);
  Segment s{face(h, tm), {}, {}};
  unsigned int k = 0;
  for(auto g = halfedge(s.face, tm); g != h; g = next(g, tm))
    ++k;
  (is_reversed ? s.target : s.source)[k] = 1;
  (is_reversed ? s.source : s.target)[next_corner(k)] = 1;
  return s;
}

// Two vertices may be in several common faces: both sides of their edge. Then the segment runs along that edge, in
// whatever face it is given. (Where several edges join them, the first face decides; halfedges tell exactly.)
//
// Appends the segment from the point p to the point q, and returns true, if some face has both. Prefers the face
// `preferred`, which may be null, and then the faces in which the points are given. Linear in the degrees of vertices.
template <typename Segment, typename TriangleMesh>
bool find_segment(const TriangleMesh& tm, const Point_of_faces<TriangleMesh>& p, const Point_of_faces<TriangleMesh>& q,
                  std::vector<Segment>& segments,
                  typename boost::graph_traits<TriangleMesh>::face_descriptor preferred
                  = boost::graph_traits<TriangleMesh>::null_face())
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  Segment segment;
  bool is_found = false;
  const auto try_face = [&](face_descriptor f)
  {
    if(is_found || !p.find_in(tm, f, segment.source) || !q.find_in(tm, f, segment.target))
      return;
    segment.face = f;
    is_found = true;
  };
  try_face(preferred);
  try_face(p.own_face());
  try_face(q.own_face());
  p.for_each_face(tm, try_face);
  if(is_found)
    segments.push_back(segment);
  return is_found;
}

// Does the same for point number `position` of a curve and the next one, and throws if no face has both.
template <typename Segment, typename TriangleMesh>
void append_segment(const TriangleMesh& tm, const Point_of_faces<TriangleMesh>& p,
                    const Point_of_faces<TriangleMesh>& q, std::size_t position, std::vector<Segment>& segments,
                    typename boost::graph_traits<TriangleMesh>::face_descriptor preferred
                    = boost::graph_traits<TriangleMesh>::null_face())
{
  if(!find_segment(tm, p, q, segments, preferred))
    reject_curve(position, "and the next one are in no common face");
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_CURVE_SEGMENTS_H
