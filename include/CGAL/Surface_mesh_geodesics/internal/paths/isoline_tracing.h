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

// The line of all points at one distance, which separates what is nearer from what is not. Along an edge the distance
// is known at every point, and it changes by at most the length that one walks (it is 1-Lipschitz). So a part of an
// edge between two points with known distances either cannot hold a point of the line, or is halved: a crossing that
// separates nearer points from farther ones is found down to the resolution, whatever the number of windows. Pairs of
// crossings are looked for down to a coarser width only, since an edge that the line touches would be halved without
// end. Inside a face the points are joined by segments; where a face has more than two, the distance in their middle
// tells which belong together. A closed line inside one face, around a point farther than all its edges, is not found.
//
// Whether an edge is crossed is decided by comparing the distances of its ends with the value, never by a bound: so
// each face has an even number of crossings, and lines end at the border only, whatever rounding does. A vertex exactly
// at the value is not nearer: all crossings of its edges with nearer neighbours are the vertex itself.

#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/distance_at_location.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A point of the line: at t (from 0 to 1) of a halfedge of the mesh.
template <typename FT>
struct Isoline_point
{
  Halfedge_id halfedge;
  FT t;
};

template <typename FT_>
class Isoline_tracer
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;
  using Windows = Edge_window_field<FT>;
  using Point = Isoline_point<FT>;

  // Points are found with an error of `resolution` times the length of their edge.
  Isoline_tracer(const Mesh& mesh, const Field& field, const Windows& windows, const FT& resolution)
    : m_mesh(mesh), m_field(field), m_windows(windows), m_resolution(resolution)
  {}

  // calls line(points, is_closed) for each line of points with the given distance.
  template <typename Line>
  void trace(const FT& value, Line line)
  {
    m_points.clear();
    m_neighbours.clear();
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

  // May a part of an edge of this length hold a point of the line, between points with these distances?
  static bool may_hold(const FT& length, const FT& d, const FT& e, const FT& value)
  {
    if((d < value) != (e < value))
      return true;
    const FT nearest = (d + e - length) / 2, farthest = (d + e + length) / 2; // by the Lipschitz bound
    return nearest < value && value <= farthest;
  }

  // Both faces of an edge give the same answer.
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

  // the halfedge that stands for the edge of h
  Halfedge_id edge_of(Halfedge_id h) const
  {
    const Halfedge_id o = m_mesh.opposite(h);
    return o == null_id ? h : (std::min)(h, o);
  }

  FT distance_at(Face_id f, const std::array<FT, 3>& b) const
  {
    return arrival_at_location(m_mesh, m_field, m_windows, f, b).distance;
  }

  FT distance_on_edge(Halfedge_id h, const FT& t) const
  {
    std::array<FT, 3> b;
    b[index_in_face(h)] = 1 - t;
    b[next_corner(index_in_face(h))] = t;
    b[previous_corner(index_in_face(h))] = 0;
    return distance_at(face_of(h), b);
  }

  // Relative to an edge: two crossings that are nearer to each other may be missed.
  static FT touching_width() { return FT(1) / 16384; }

  // finds the crossings between s and t, in order.
  void find_crossings(Halfedge_id h, const FT& value, const FT& s, const FT& ds, const FT& t, const FT& dt)
  {
    if(!may_hold(FT((t - s) * m_mesh.length(h)), ds, dt, value))
      return;
    const FT middle = (s + t) / 2;
    const bool is_crossed = (ds < value) != (dt < value);
    if(t - s <= (is_crossed ? m_resolution : touching_width()))
    {
      if(is_crossed)
        m_points.push_back(Point{h, ds == value ? s : dt == value ? t : middle});
      return;
    }
    const FT dm = distance_on_edge(h, middle);
    find_crossings(h, value, s, ds, middle, dm);
    find_crossings(h, value, middle, dm, t, dt);
  }

  // the points on the edge of h, found once from either side.
  Edge_points points_on_edge(Halfedge_id h, const FT& value)
  {
    const Halfedge_id key = edge_of(h);
    const auto known = m_first_point.find(key);
    if(known != m_first_point.end())
      return known->second;
    Edge_points e;
    e.first = static_cast<Point_index>(m_points.size());
    find_crossings(key, value, FT(0), m_field.distance[m_mesh.source(key)], FT(1),
                   m_field.distance[m_mesh.target(key)]);
    e.size = static_cast<std::uint32_t>(m_points.size() - e.first);
    m_neighbours.resize(m_points.size(), {null_id, null_id});
    m_first_point[key] = e;
    return e;
  }

  // The points around a face come in pairs; after the first one along the border of the face, the
  // distance is on the other side of the value than at corner 0.
  void connect_in_face(Face_id f, const FT& value)
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
    const std::size_t n = around.size();
    if(n == 0)
      return;
    const bool starts_near = m_field.distance[m_mesh.face(f).vertex[0]] < value;
    // the arcs behind the points with even numbers are near if corner 0 is not
    const bool middle_is_near = n > 2 && distance_at(f, middle_of(f, around)) < value;
    const bool even_arcs_are_near = !starts_near;
    const std::size_t shift = n > 2 && even_arcs_are_near == middle_is_near ? 1 : 0;
    for(std::size_t i = 0; i < n; i += 2)
      join(around[(i + shift) % n], around[(i + shift + 1) % n]);
  }

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

  void join(Point_index a, Point_index b)
  {
    m_neighbours[a][m_neighbours[a][0] == null_id ? 0 : 1] = b;
    m_neighbours[b][m_neighbours[b][0] == null_id ? 0 : 1] = a;
  }

  // lines that end at the border first, then the closed ones.
  template <typename Line>
  void collect_lines(Line line)
  {
    std::vector<char> is_done(m_points.size(), 0);
    for(int pass = 0; pass < 2; ++pass)
      for(Point_index i = 0; i < m_points.size(); ++i)
      {
        const bool is_end = m_neighbours[i][1] == null_id;
        if(is_done[i] || m_neighbours[i][0] == null_id || (pass == 0 && !is_end))
          continue;
        std::vector<Point> points;
        Point_index previous = null_id, current = i;
        while(current != null_id && !is_done[current])
        {
          is_done[current] = 1;
          if(points.empty() || !is_same_vertex(points.back(), m_points[current]))
            points.push_back(m_points[current]);
          const std::array<Point_index, 2>& next = m_neighbours[current];
          const Point_index step = next[0] != previous ? next[0] : next[1];
          previous = current;
          current = step;
        }
        const bool is_closed = pass == 1;
        if(is_closed && points.size() > 1 && is_same_vertex(points.back(), points.front()))
          points.pop_back();
        if(points.size() > 1) // not a vertex alone that is farther than all around it
          line(points, is_closed);
      }
  }

  // the vertex at which a point is, or null_id
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
  FT m_resolution;
  std::vector<Point> m_points;
  std::vector<std::array<Point_index, 2>> m_neighbours; // on the line
  std::unordered_map<Halfedge_id, Edge_points> m_first_point; // by the smaller halfedge of the edge
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_TRACING_H
