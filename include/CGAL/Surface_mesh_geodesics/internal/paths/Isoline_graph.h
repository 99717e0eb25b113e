// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_GRAPH_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_GRAPH_H

// The points of isolines on the edges, and how they are joined to lines in the faces.
//
// Where a face has more than two crossings of one line, the distance at their centroid decides which belong together.
// A closed line inside one face, around a point farther than all its edges, is not found.
//
// The points of all levels are in one graph: a level is the number of a line's distance. Edges come in any order; what
// the lines are does not depend on it, if sort() is called before them.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_table.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
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

// Lines have the nearer points on their left. Where the boundary of a face, counterclockwise, goes over from nearer to
// farther points, a line comes into the face; where it goes back, a line leaves it. The face across sees the boundary
// the other way, so a line that leaves one face comes into the other.
//
// Invariants, when all faces have been connected: each point has a successor in one of the faces at its edge, and a
// predecessor in the other one; at the border of the mesh one of them is missing. So points form lines and closed
// lines. The number of crossings around a face is even, because each edge has an odd number of them if and only if its
// ends are on different sides of the value.
//
// The points of an edge belong to the first halfedge of the edge (Intrinsic_mesh::is_first_of_edge()).
template <typename FT>
class Isoline_graph
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Point = Isoline_point<FT>;

  // Removes all points, and keeps the memory. The mesh is referred to.
  void reset(const Mesh& mesh)
  {
    m_mesh = &mesh;
    m_points.clear();
    m_of_edge.clear();
  }

  // Begins the points of an edge. Requires: h is the first halfedge of its edge, which has not been begun before.
  void begin_edge(Halfedge_id h)
  {
    CGAL_assertion(m_mesh->is_first_of_edge(h));
    m_edge = h;
    m_first_of_edge = m_points.size();
  }

  // Appends a point of the edge that was begun. Requires: levels ascend along the calls for an edge, and t ascends for
  // each level.
  void add(std::uint32_t level, const FT& t)
  {
    m_points.push_back(Node{m_edge, level, t, null_id, null_id});
  }

  // Returns whether the edge has points.
  bool end_edge()
  {
    if(m_first_of_edge == m_points.size())
      return false;
    m_of_edge.insert(m_edge, Index_range{static_cast<std::uint32_t>(m_first_of_edge),
                                         static_cast<std::uint32_t>(m_points.size() - m_first_of_edge)});
    return true;
  }

  // Joins the crossings of a level around a face in pairs. They divide its boundary into arcs that are nearer and
  // farther in turn; after the first crossing the arc is on the other side of the value than corner 0. With more than
  // two crossings the distance at their centroid decides whether the segments cut off the nearer arcs or the farther
  // ones: those that are not on the side of the centroid. A shift of 0 cuts off the arcs behind points with even
  // numbers, a shift of 1 the others. (From a to b, counterclockwise, the arc that is cut off is on the right of ab.)
  // `starts_near` tells whether corner 0 is nearer than the level, is_near(b) whether the point of the face with the
  // barycentric coordinates b is; it is called at most once. Requires: the edges of the face have ended.
  template <typename IsNear>
  void connect(Face_id f, std::uint32_t level, bool starts_near, IsNear is_near)
  {
    find_points_around(f, level);
    const std::size_t n = m_around.size();
    CGAL_assertion(n % 2 == 0);
    if(n == 0)
      return;
    const bool middle_is_near = n > 2 && is_near(middle_of(f));
    const bool even_arcs_are_near = !starts_near; // those behind the points with even numbers
    const std::size_t shift = n > 2 && even_arcs_are_near == middle_is_near ? 1 : 0;
    const bool are_near_cut_off = even_arcs_are_near == (shift == 0);
    for(std::size_t i = 0; i < n; i += 2)
    {
      const std::uint32_t a = m_around[(i + shift) % n], b = m_around[(i + shift + 1) % n];
      are_near_cut_off ? join(b, a) : join(a, b);
    }
  }

  // Puts the points in an order of their own: by level, then by halfedge, then along it. Connections stay. No edges are
  // added afterwards. Takes O(n log n) time for n points.
  void sort()
  {
    std::vector<std::uint32_t> order(m_points.size()), place(m_points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [this](std::uint32_t i, std::uint32_t j)
    {
      const Node &p = m_points[i], &q = m_points[j];
      return p.level != q.level ? p.level < q.level : p.halfedge != q.halfedge ? p.halfedge < q.halfedge : i < j;
    });
    std::vector<Node> sorted;
    sorted.reserve(m_points.size());
    for(const std::uint32_t i : order)
    {
      place[i] = static_cast<std::uint32_t>(sorted.size());
      sorted.push_back(m_points[i]);
    }
    for(Node& p : sorted)
      for(std::uint32_t* neighbor : {&p.previous, &p.next})
        *neighbor = *neighbor == null_id ? null_id : place[*neighbor];
    m_points.swap(sorted);
    m_of_edge.clear();
  }

  // Calls line(points, is_closed) for each line of a level, in its direction: first those that end at the border, by
  // the number of their first point, then the closed ones, each from its point with the smallest number. A line has at
  // least two points, no vertex twice in a row, and points that follow each other share a face.
  // Requires: all faces have been connected, and sort() was called, or the faces came in ascending order and there is
  // one level only.
  template <typename Line>
  void for_each_line(std::uint32_t level, Line& line) const
  {
    const auto first = first_of_level(m_points.begin(), m_points.end(), level);
    const auto last = first_of_level(first, m_points.end(), level + 1);
    const std::uint32_t begin = static_cast<std::uint32_t>(first - m_points.begin());
    const std::uint32_t end = static_cast<std::uint32_t>(last - m_points.begin());
    std::vector<char> is_done(end - begin, 0);
    for(const bool is_closed : {false, true})
      for(std::uint32_t i = begin; i < end; ++i)
      {
        const Node& p = m_points[i];
        if(is_done[i - begin] || p.next == null_id || (!is_closed && p.previous != null_id))
          continue;
        std::vector<Point> points = line_from(i, begin, is_done);
        if(is_closed && points.size() > 1 && is_same_vertex(points.back(), points.front()))
          points.pop_back();
        if(points.size() > 1) // not a vertex alone that is farther than all around it
          line(points, is_closed);
      }
  }

  // The memory of points and of their lists, in bytes. (The table has a few numbers for each edge with points.)
  std::size_t memory() const { return m_points.capacity() * sizeof(Node); }

private:
  // A point, and the points before and after it on its line, null_id if missing.
  struct Node
  {
    Halfedge_id halfedge;
    std::uint32_t level;
    FT t;
    std::uint32_t previous, next;
  };

  // The first point of a level, or of the first one behind it, among points that are sorted by level.
  template <typename Iterator>
  static Iterator first_of_level(Iterator begin, Iterator end, std::uint32_t level)
  {
    return std::lower_bound(begin, end, level, [](const Node& p, std::uint32_t l) { return p.level < l; });
  }

  // Finds the crossings of a level on the edges of a face, in their order around it from corner 0 on. Those of an edge
  // are sorted by level, so that it does not matter how many levels cross the face.
  void find_points_around(Face_id f, std::uint32_t level)
  {
    m_around.clear();
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k);
      const bool is_reversed = !m_mesh->is_first_of_edge(h);
      const Index_range* const range = m_of_edge.find(is_reversed ? m_mesh->opposite(h) : h);
      if(range == nullptr)
        continue;
      const std::size_t first = m_around.size();
      const auto begin = m_points.begin() + static_cast<std::ptrdiff_t>(range->first), end = begin + range->size;
      for(auto it = first_of_level(begin, end, level); it != end && it->level == level; ++it)
        m_around.push_back(static_cast<std::uint32_t>(it - m_points.begin()));
      if(is_reversed)
        std::reverse(m_around.begin() + static_cast<std::ptrdiff_t>(first), m_around.end());
    }
  }

  // Returns the barycentric coordinates of the centroid of the crossings around a face. A crossing that belongs to the
  // halfedge of the neighbor is turned to that of f, which runs the other way.
  std::array<FT, 3> middle_of(Face_id f) const
  {
    std::array<FT, 3> b{};
    for(const std::uint32_t i : m_around)
    {
      Halfedge_id h = m_points[i].halfedge;
      FT t = m_points[i].t;
      if(face_of(h) != f)
      {
        h = m_mesh->opposite(h);
        t = 1 - t;
      }
      b[index_in_face(h)] += (1 - t) / FT(m_around.size());
      b[next_corner(index_in_face(h))] += t / FT(m_around.size());
    }
    return b;
  }

  // Lets b follow a on a line.
  void join(std::uint32_t a, std::uint32_t b)
  {
    CGAL_assertion(m_points[a].next == null_id && m_points[b].previous == null_id);
    m_points[a].next = b;
    m_points[b].previous = a;
  }

  // Returns the points of the line from point i on, without a vertex twice in a row, and marks them. The walk ends
  // where a point has no successor, or where it meets a point that is marked: the first one of a closed line.
  // The marks begin with that of point `begin`.
  std::vector<Point> line_from(std::uint32_t i, std::uint32_t begin, std::vector<char>& is_done) const
  {
    std::vector<Point> points;
    for(std::uint32_t current = i; current != null_id && !is_done[current - begin]; current = m_points[current].next)
    {
      is_done[current - begin] = 1;
      const Point p{m_points[current].halfedge, m_points[current].t};
      if(points.empty() || !is_same_vertex(points.back(), p))
        points.push_back(p);
    }
    return points;
  }

  // Returns the vertex at which a point lies, or null_id. (Isoline_crossings gives such a point exactly 0 or 1.)
  Vertex_id vertex_at(const Point& p) const
  {
    return p.t == 0 ? m_mesh->source(p.halfedge) : p.t == 1 ? m_mesh->target(p.halfedge) : null_id;
  }

  bool is_same_vertex(const Point& p, const Point& q) const
  {
    const Vertex_id v = vertex_at(p);
    return v != null_id && v == vertex_at(q);
  }

  const Mesh* m_mesh = nullptr;
  std::vector<Node> m_points;
  Index_table<Index_range> m_of_edge; // the points of each edge that has any, by its first halfedge
  Halfedge_id m_edge = null_id;       // the edge that was begun, and its first point
  std::size_t m_first_of_edge = 0;
  std::vector<std::uint32_t> m_around; // the crossings around the face that is connected
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_GRAPH_H
