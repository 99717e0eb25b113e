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

// Isolines: the lines of all points at one distance, which separate nearer points from farther ones.
//
// Crossings of edges. Along an edge the distance is known at every point, and it is 1-Lipschitz: it changes by no more
// than the length walked. So a part of an edge between two points with known distances is either discarded, because it
// cannot hold a point of the line, or halved. A crossing that separates nearer points from farther ones is found down
// to the resolution, whatever the number of windows is. Pairs of crossings are searched for only down to a coarser
// width, because an edge that the line touches would be halved without end.
//
// Lines. Segments join the crossings in a face. Where a face has more than two, the distance at their centroid decides
// which belong together. A closed line inside one face, around a point farther than all its edges, is not found.
//
// Rounding. Whether an edge is crossed is decided by comparing the distances of its ends with the value, never by a
// bound. So each face has an even number of crossings, and lines end at the border only, regardless of rounding. A
// vertex exactly at the value counts as farther: the crossings of its edges to nearer neighbors are the vertex itself.

#include <CGAL/Surface_mesh_geodesics/internal/paths/distance_at_location.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A point of a line: at t of a halfedge of the mesh, 0 at its source and 1 at its target.
template <typename FT>
struct Isoline_point
{
  Halfedge_id halfedge;
  FT t;
};

// Invariants, when all faces have been looked at: each point has two neighbors, one in each face at its edge, or one at
// the border of the mesh; so points and neighbors form lines and closed lines. The number of crossings around a face is
// even, because each edge has an odd number of them if and only if its ends are on different sides of the value.
//
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

  // Calls line(points, is_closed) for each line of points at the distance `value`, first for those that end at the
  // border. A line has at least two points, no vertex twice in a row, and points that follow each other share a face.
  // There is no line for a value that is negative, infinite or not a number.
  // Complexity: linear in the number of faces, plus for each crossing a number of distance queries that is logarithmic
  // in the resolution.
  template <typename Line>
  void trace(const FT& value, Line line)
  {
    m_points.clear();
    m_neighbors.clear();
    m_first_point.clear();
    if(!(value < Field::infinity()))
      return;
    for(Face_id f = 0; f < m_mesh.number_of_faces(); ++f)
      if(may_hold(f, value))
        connect_in_face(f, value);
    collect_lines(line);
  }

private:
  using Point_index = std::uint32_t;

  struct Edge_points
  {
    Point_index first;
    std::uint32_t size;
  };

  // Returns whether a part of an edge may hold a point of the line. The part has this length, its ends the distances d
  // and e. By the Lipschitz bound the distances on the part are between (d + e - length) / 2 and (d + e + length) / 2.
  // Error: three epsilon of the sum. So of two crossings within that error of each other both may be missed, but none
  // that separates the ends.
  static bool may_hold(const FT& length, const FT& d, const FT& e, const FT& value)
  {
    if((d < value) != (e < value))
      return true;
    const FT nearest = (d + e - length) / 2, farthest = (d + e + length) / 2;
    return nearest < value && value <= farthest;
  }

  // The same for all edges of a face. Both faces of an edge decide alike for that edge.
  bool may_hold(Face_id f, const FT& value) const
  {
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = edge_of(halfedge_of(f, k));
      if(may_hold(m_mesh.length(h), m_field.distance[m_mesh.source(h)], m_field.distance[m_mesh.target(h)], value))
        return true;
    }
    return false;
  }

  // Returns the halfedge that stands for the edge of h.
  Halfedge_id edge_of(Halfedge_id h) const
  {
    const Halfedge_id o = m_mesh.opposite(h);
    return o == null_id ? h : (std::min)(h, o);
  }

  // Return the distance of a point of a face, and of the point at t of a halfedge, from the nearest source.
  FT distance_at(Face_id f, const std::array<FT, 3>& b) const
  {
    return arrival_at_location(m_mesh, m_field, m_windows, f, b, m_strips).distance;
  }

  FT distance_on_edge(Halfedge_id h, const FT& t) const
  {
    std::array<FT, 3> b;
    b[index_in_face(h)] = 1 - t;
    b[next_corner(index_in_face(h))] = t;
    b[previous_corner(index_in_face(h))] = 0;
    return distance_at(face_of(h), b);
  }

  // Appends the crossings between the positions s < t of h, in order. Their distances are ds and dt. Positions are
  // fractions of the edge, in [0, 1].
  // The recursion halves t - s, so it ends after -log2(resolution) steps, 41 for doubles.
  void find_crossings(Halfedge_id h, const FT& value, const FT& s, const FT& ds, const FT& t, const FT& dt)
  {
    CGAL_expensive_assertion(s < t);
    if(!may_hold(FT((t - s) * m_mesh.length(h)), ds, dt, value))
      return;
    const FT middle = (s + t) / 2;
    const bool is_crossed = (ds < value) != (dt < value);
    if(t - s <= (is_crossed ? m_resolution : Tolerance<FT>::isoline_touching()))
    {
      if(is_crossed)
        m_points.push_back(Point{h, ds == value ? s : dt == value ? t : middle});
      return;
    }
    const FT dm = distance_on_edge(h, middle);
    find_crossings(h, value, s, ds, middle, dm);
    find_crossings(h, value, middle, dm, t, dt);
  }

  // Returns the points on the edge of h. The first of its two faces that asks finds them.
  Edge_points points_on_edge(Halfedge_id h, const FT& value)
  {
    const Halfedge_id edge = edge_of(h);
    const auto known = m_first_point.find(edge);
    if(known != m_first_point.end())
      return known->second;
    Edge_points e;
    e.first = static_cast<Point_index>(m_points.size());
    find_crossings(edge, value, FT(0), m_field.distance[m_mesh.source(edge)], FT(1),
                   m_field.distance[m_mesh.target(edge)]);
    e.size = static_cast<std::uint32_t>(m_points.size() - e.first);
    m_neighbors.resize(m_points.size(), {null_id, null_id});
    m_first_point[edge] = e;
    return e;
  }

  // Joins the crossings around a face in pairs. They divide its boundary into arcs that are nearer and farther in turn;
  // after the first crossing the arc is on the other side of the value than corner 0. With more than two crossings the
  // distance at their centroid decides whether the segments cut off the nearer arcs or the farther ones: those that are
  // not on the side of the centroid. A shift of 0 cuts off the arcs behind points with even numbers, a shift of 1 the
  // others.
  void connect_in_face(Face_id f, const FT& value)
  {
    const std::vector<Point_index> around = points_around(f, value);
    const std::size_t n = around.size();
    CGAL_assertion(n % 2 == 0);
    if(n == 0)
      return;
    const bool starts_near = m_field.distance[m_mesh.face(f).vertex[0]] < value;
    const bool middle_is_near = n > 2 && distance_at(f, middle_of(f, around)) < value;
    const bool even_arcs_are_near = !starts_near; // those behind the points with even numbers
    const std::size_t shift = n > 2 && even_arcs_are_near == middle_is_near ? 1 : 0;
    for(std::size_t i = 0; i < n; i += 2)
      join(around[(i + shift) % n], around[(i + shift + 1) % n]);
  }

  // Returns the crossings of the edges of a face, in their order around it from corner 0 on.
  std::vector<Point_index> points_around(Face_id f, const FT& value)
  {
    std::vector<Point_index> around;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k);
      const Edge_points e = points_on_edge(h, value);
      const bool is_reversed = edge_of(h) != h;
      for(std::uint32_t i = 0; i < e.size; ++i)
        around.push_back(e.first + (is_reversed ? e.size - 1 - i : i));
    }
    return around;
  }

  // Returns the barycentric coordinates of the centroid of some crossings of a face. A crossing that belongs to the
  // halfedge of the neighbor is turned to that of f, which runs the other way.
  std::array<FT, 3> middle_of(Face_id f, const std::vector<Point_index>& around) const
  {
    std::array<FT, 3> b{};
    for(const Point_index i : around)
    {
      Halfedge_id h = m_points[i].halfedge;
      FT t = m_points[i].t;
      if(face_of(h) != f)
      {
        h = m_mesh.opposite(h);
        t = 1 - t;
      }
      b[index_in_face(h)] += (1 - t) / FT(around.size());
      b[next_corner(index_in_face(h))] += t / FT(around.size());
    }
    return b;
  }

  // Makes two points neighbors on a line.
  // Requires: each has at most one neighbor so far.
  void join(Point_index a, Point_index b)
  {
    m_neighbors[a][m_neighbors[a][0] == null_id ? 0 : 1] = b;
    m_neighbors[b][m_neighbors[b][0] == null_id ? 0 : 1] = a;
  }

  // Passes the lines on: first those that end at the border, each from its end with the smaller index, then the closed
  // ones, each from its point with the smallest index.
  template <typename Line>
  void collect_lines(Line line)
  {
    std::vector<char> is_done(m_points.size(), 0);
    for(const bool is_closed : {false, true})
      for(Point_index i = 0; i < m_points.size(); ++i)
      {
        const bool is_end = m_neighbors[i][1] == null_id;
        if(is_done[i] || m_neighbors[i][0] == null_id || (!is_closed && !is_end))
          continue;
        std::vector<Point> points = line_from(i, is_done);
        if(is_closed && points.size() > 1 && is_same_vertex(points.back(), points.front()))
          points.pop_back();
        if(points.size() > 1) // not a vertex alone that is farther than all around it
          line(points, is_closed);
      }
  }

  // Returns the points of the line from point i on, without a vertex twice in a row, and marks them. The walk ends
  // where a point has no second neighbor, or where it meets a point that is marked: the first one of a closed line.
  std::vector<Point> line_from(Point_index i, std::vector<char>& is_done) const
  {
    std::vector<Point> points;
    Point_index previous = null_id, current = i;
    while(current != null_id && !is_done[current])
    {
      is_done[current] = 1;
      if(points.empty() || !is_same_vertex(points.back(), m_points[current]))
        points.push_back(m_points[current]);
      const std::array<Point_index, 2>& next = m_neighbors[current];
      const Point_index step = next[0] != previous ? next[0] : next[1];
      previous = current;
      current = step;
    }
    return points;
  }

  // Returns the vertex at which a point lies, or null_id. (find_crossings() gives such a point exactly 0 or 1.)
  Vertex_id vertex_at(const Point& p) const
  {
    return p.t == 0 ? m_mesh.source(p.halfedge) : p.t == 1 ? m_mesh.target(p.halfedge) : null_id;
  }

  bool is_same_vertex(const Point& p, const Point& q) const
  {
    const Vertex_id v = vertex_at(p);
    return v != null_id && v == vertex_at(q);
  }

  const Mesh& m_mesh;
  const Field& m_field;
  const Windows& m_windows;
  const Edge_strip_field<FT>* m_strips;
  FT m_resolution;
  std::vector<Point> m_points;
  std::vector<std::array<Point_index, 2>> m_neighbors;        // of each point, on its line; null_id if missing
  std::unordered_map<Halfedge_id, Edge_points> m_first_point; // of each edge, by the halfedge that stands for it
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_TRACING_H
