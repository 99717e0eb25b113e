// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_VORONOI_FACE_CUT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_VORONOI_FACE_CUT_H

// Cuts a face along its arcs into triangles that belong to one cell each, in the layout of the face.
//
// The complex is generic, the cut is not: an arc without length there becomes one vertex here. Nodes on an edge that
// are at a vertex of the mesh up to rounding, or at each other, are contracted; this is decided for the edge, so that
// both of its faces agree (Edge_contraction). Inside a face, nodes are contracted along arcs without length.
//
// The rest is combinatorics. A part of a cell is a closed walk along the border and along curves. Each walk is divided
// into cycles without repeated vertices; cycles of two vertices (an arc along an edge) are dropped; the others are
// triangulated. So the cut of all faces fits together regardless of rounding.
//
// Curves are sampled. If segments cross where curves are close to each other, the face is sampled more finely, as long
// as it gets few vertices: the time is cubic in their number.
//
// Steps for a divided face: collect_border(), find_vertices_of_nodes(), collect_curves(), collect_regions(), and for
// each walk divide_into_cycles() and triangulate().

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Arc_curve.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Edge_contraction.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Polygon_triangulation.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Cuts one face after another; the results are those of the last call of cut(). The mesh and the complex are referred
// to.
//
// Invariants of a cut: the triangles of a cell form a disk for each part of the cell (divide_into_cycles()); each side
// of the face is covered by sides of triangles between consecutive border vertices (walk_along_border()). Both hold
// regardless of rounding. No two vertices have more than one edge, as long as triangulate() can avoid such diagonals;
// badness() counts those that it cannot avoid, and triangles that rounding has made degenerate or clockwise.
//
// Frame: the layout of the face. Lengths are in the unit of the intrinsic mesh.
class Voronoi_face_cut
{
public:
  using Complex = Voronoi_complex<double>;
  using Mesh = Intrinsic_mesh<double>;
  using Point = Planar_point<double>;

  struct Triangle
  {
    std::array<std::uint32_t, 3> vertex;
    Vertex_id site;
  };

  Voronoi_face_cut(const Mesh& mesh, const Complex& complex) : m_mesh(mesh), m_complex(complex) {}

  // Cuts face f. The segments are at most `tolerance` away from the arcs, in the unit of the intrinsic mesh: half of it
  // for the samples of the arcs, half for those that are left out. They may be farther away where `number_of_halvings`
  // ends the sampling of an arc; such a segment spans 1/1024 of the parameters of the arc.
  // Triangles of a face that no site reaches have the site null_id.
  // Requires: the complex is finished.
  void cut(Face_id f, double tolerance)
  {
    CGAL_assertion(f < m_mesh.number_of_faces());
    m_face = f;
    m_largest_number_of_vertices = 0;
    collect_border();
    if(m_border_nodes.empty() || m_complex.has_one_cell(f))
      cut_undivided();
    else
      cut_until_valid(tolerance);
  }

  // Returns the vertices: first those on the border, counterclockwise from corner 0, then those inside.
  const std::vector<Point>& points() const { return m_points; }
  std::size_t number_of_border_vertices() const { return m_border_points.size(); }

  // Returns the triangles, counterclockwise in the layout, each with the site of its cell.
  const std::vector<Triangle>& triangles() const { return m_triangles; }

  // Returns 0 if no triangle is degenerate or clockwise in the layout of the face and no diagonal is a second edge
  // between its vertices, a larger number otherwise.
  std::uint64_t badness() const { return m_badness; }

  // Returns the largest number of vertices that the face had in an attempt, also in one that gave no better result. The
  // time of the cut depends on it.
  std::size_t largest_number_of_vertices() const { return m_largest_number_of_vertices; }

  // Returns how many vertices a face may have when it is cut again after a cut of the given badness. Triangles that lie
  // on others are worth more time than those without area: they do no harm, and often stay however fine the curves are.
  static std::size_t limit_of_further_attempts(std::uint64_t badness)
  {
    return Polygon_triangulation::has_overlap(badness) ? 256 : 64;
  }

private:
  // Triangulates a face in one cell, which may have vertices on its border.
  void cut_undivided()
  {
    start();
    std::vector<std::uint32_t> all(m_points.size());
    for(std::uint32_t i = 0; i < all.size(); ++i)
      all[i] = i;
    triangulate(all, m_complex.owner(m_mesh.face(m_face).vertex[0]));
  }

  // Cuts a divided face with finer and finer curves until no triangle is bad, and keeps the best result. Finer curves
  // help where curves cross, but some triangles are bad at any tolerance: those between a curve and a side that it
  // touches. So the number of attempts is bounded, and so are the vertices of each but the first, which has the user's
  // tolerance. They are counted before they are triangulated, as there may be four times as many as before.
  void cut_until_valid(double tolerance)
  {
    const int number_of_attempts = 6;
    collect_vertices(tolerance);
    collect_regions();
    for(int i = 1; i < number_of_attempts && m_badness > 0; ++i)
    {
      const std::vector<Point> points = m_points;
      const std::vector<Triangle> triangles = m_triangles;
      const std::uint64_t badness = m_badness;
      tolerance /= 16;
      collect_vertices(tolerance);
      const bool is_small = m_points.size() <= limit_of_further_attempts(badness);
      if(is_small)
      {
        collect_regions();
        if(m_badness < badness)
          continue;
      }
      m_points = points;
      m_triangles = triangles;
      m_badness = badness;
      if(!is_small)
        return;
    }
  }

  // A node of the complex on the border, and the border vertex at which it is. For nodes at the end of the last side,
  // which is corner 0, `position` is the number of border vertices, so that positions ascend along the border.
  //
  // Invariant of m_border_nodes: in the order of the border, the same as that of the breakpoints of the face.
  struct Border_node
  {
    std::uint32_t node, position;
  };

  // A curve between the same two cells from vertex to vertex of the cut, as a polyline: `vertices` begins with the
  // vertex of first_node and ends with that of last_node, which may be one. The cell of left_site is on its left.
  struct Cut_curve
  {
    Vertex_id left_site, right_site;
    std::uint32_t first_node, last_node;
    std::vector<std::uint32_t> vertices;
  };

  // --- the border ---

  // Makes the vertices on the border of the face, and the list of nodes on it, counterclockwise from corner 0.
  void collect_border()
  {
    const std::array<Point, 3> corner = m_complex.layout(m_face);
    m_border_points.clear();
    m_sides.clear();
    m_border_nodes.clear();
    for(unsigned int k = 0; k < 3; ++k)
    {
      const unsigned char side = static_cast<unsigned char>(1u << k);
      const Halfedge_id h = halfedge_of(m_face, k);
      const Edge_contraction edge(m_mesh, m_complex, h);
      const std::uint32_t first = static_cast<std::uint32_t>(m_border_points.size());
      m_border_points.push_back(corner[k]);
      m_sides.push_back(static_cast<unsigned char>(side | (1u << previous_corner(k))));
      const Point a = corner[k], b = corner[next_corner(k)];
      for(std::uint32_t i = 1; i < edge.last(); ++i)
      {
        const double t = edge.fraction(i);
        m_border_points.push_back(Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        m_sides.push_back(side);
      }
      for(std::uint32_t i = 0; i < edge.number_of_nodes(); ++i)
        m_border_nodes.push_back(Border_node{edge.node(i), first + edge.position(i)});
    }
  }

  // --- curves ---

  // Starts a cut from the vertices on the border, without those that earlier attempts have added inside.
  void start()
  {
    m_points = m_border_points;
    m_sides.resize(m_points.size());
    m_triangles.clear();
    m_edges.clear();
    m_badness = 0;
  }

  // Starts a cut of a divided face, and makes all vertices that it will have.
  void collect_vertices(double tolerance)
  {
    start();
    find_vertices_of_nodes();
    collect_curves(tolerance);
  }

  // Gives vertices to the nodes of the face. Those on the border have vertices already. An inner node where three cells
  // meet shares the vertex at the other end of an arc without length, if there is one; otherwise it gets a new one.
  //
  // The border goes first and vertices spread from it until nothing changes: what touches the border is contracted to
  // the border, whose vertices both faces know. Inner nodes of two cells get no vertex; they are samples of a curve.
  void find_vertices_of_nodes()
  {
    m_vertex_of_node.clear();
    for(const Border_node& b : m_border_nodes)
      m_vertex_of_node.emplace(b.node, b.position % static_cast<std::uint32_t>(m_border_points.size()));
    const std::pair<std::uint32_t, std::uint32_t> range = m_complex.arcs_of_face(m_face);
    for(bool has_changed = true; has_changed;)
    {
      has_changed = false;
      for(std::uint32_t a = range.first; a < range.second; ++a)
      {
        const Complex::Arc& arc = m_complex.arcs()[a];
        if(!m_complex.has_length(arc))
          has_changed = share_vertex(arc.first_node, arc.last_node) || has_changed;
      }
    }
    for(std::uint32_t a = range.first; a < range.second; ++a)
      for(std::uint32_t node : {m_complex.arcs()[a].first_node, m_complex.arcs()[a].last_node})
        if(m_complex.nodes()[node].is_vertex() && m_vertex_of_node.find(node) == m_vertex_of_node.end())
        {
          const std::uint32_t vertex = add_vertex(m_complex.nodes()[node].point);
          m_vertex_of_node.emplace(node, vertex);
          spread(node, vertex);
        }
  }

  // Gives one of two nodes the vertex of the other one, and returns true, if exactly one of them has a vertex.
  bool share_vertex(std::uint32_t a, std::uint32_t b)
  {
    const auto at_a = m_vertex_of_node.find(a), at_b = m_vertex_of_node.find(b);
    const bool has_a = at_a != m_vertex_of_node.end(), has_b = at_b != m_vertex_of_node.end();
    if(has_a == has_b)
      return false;
    const std::uint32_t vertex = has_a ? at_a->second : at_b->second;
    m_vertex_of_node.emplace(has_a ? b : a, vertex);
    return true;
  }

  // Gives the vertex of a node to all nodes that arcs without length connect with it. Linear in the number of these
  // nodes times that of arcs; a face has few of both.
  void spread(std::uint32_t node, std::uint32_t vertex)
  {
    std::vector<std::uint32_t> waiting{node};
    const std::pair<std::uint32_t, std::uint32_t> range = m_complex.arcs_of_face(m_face);
    while(!waiting.empty())
    {
      const std::uint32_t n = waiting.back();
      waiting.pop_back();
      for(std::uint32_t a = range.first; a < range.second; ++a)
      {
        const Complex::Arc& arc = m_complex.arcs()[a];
        if(m_complex.has_length(arc) || (arc.first_node != n && arc.last_node != n))
          continue;
        const std::uint32_t other = arc.first_node == n ? arc.last_node : arc.first_node;
        if(m_vertex_of_node.emplace(other, vertex).second)
          waiting.push_back(other);
      }
    }
  }

  std::uint32_t add_vertex(const Point& p)
  {
    m_points.push_back(p);
    m_sides.push_back(0);
    return static_cast<std::uint32_t>(m_points.size() - 1);
  }

  // Returns whether curves end at a node: at vertices of the diagram, and on the border.
  bool ends_curve(std::uint32_t node) const
  {
    return m_complex.nodes()[node].is_vertex() || is_on_border(node);
  }

  bool is_on_border(std::uint32_t node) const
  {
    return std::any_of(m_border_nodes.begin(), m_border_nodes.end(),
                       [node](const Border_node& b) { return b.node == node; });
  }

  // Makes all curves of the face, whose segments are edges before any cell is triangulated. Each of them starts at a
  // node where curves end, as no curve in a face is closed (the curves are a forest, see Face_partition.h).
  void collect_curves(double tolerance)
  {
    m_curves.clear();
    const std::pair<std::uint32_t, std::uint32_t> range = m_complex.arcs_of_face(m_face);
    std::vector<char> is_used(range.second - range.first, 0);
    for(std::uint32_t a = range.first; a < range.second; ++a)
      for(std::uint32_t node : {m_complex.arcs()[a].first_node, m_complex.arcs()[a].last_node})
        if(is_used[a - range.first] == 0 && ends_curve(node))
          add_curve(a, node, tolerance, is_used);
    for(const Cut_curve& c : m_curves)
      for(std::size_t i = 1; i < c.vertices.size(); ++i)
        m_edges.insert(std::minmax(c.vertices[i - 1], c.vertices[i]));
  }

  // Adds the curve that leaves a node by an arc: follows arcs to the next node where a curve ends, samples them, and
  // keeps the samples that the tolerance needs. The ends of the curve move to the vertices of their nodes, which
  // contraction may have put elsewhere, up to rounding. Marks the arcs as used.
  void add_curve(std::uint32_t arc, std::uint32_t node, double tolerance, std::vector<char>& is_used)
  {
    const std::pair<std::uint32_t, std::uint32_t> range = m_complex.arcs_of_face(m_face);
    Cut_curve curve;
    const Complex::Arc& begin = m_complex.arcs()[arc];
    const bool starts_backwards = begin.first_node != node;
    curve.left_site = starts_backwards ? begin.right_site : begin.left_site;
    curve.right_site = starts_backwards ? begin.left_site : begin.right_site;
    curve.first_node = node;
    m_samples.clear();
    m_samples.push_back(starts_backwards ? begin.last : begin.first);
    while(true)
    {
      const Complex::Arc& a = m_complex.arcs()[arc];
      is_used[arc - range.first] = 1;
      sample(a, a.first_node != node, tolerance / 2);
      node = a.first_node == node ? a.last_node : a.first_node;
      if(ends_curve(node))
        break;
      const auto& next = m_complex.nodes()[node].arc;
      arc = next[0] == arc ? next[1] : next[0];
      if(arc == null_id || is_used[arc - range.first] != 0)
        break;
    }
    curve.last_node = node;
    const std::uint32_t first = m_vertex_of_node.at(curve.first_node), last = m_vertex_of_node.at(node);
    m_samples.front() = m_points[first];
    m_samples.back() = m_points[last];
    curve.vertices.push_back(first);
    if(first != last)
      simplify(0, m_samples.size() - 1, tolerance / 2, has_to_leave_side(first, last), curve.vertices);
    curve.vertices.push_back(last);
    m_curves.push_back(std::move(curve));
  }

  // At most 1024 segments for an arc, whatever the tolerance: the time for a face is cubic in the number of vertices.
  static constexpr int number_of_halvings = 10;

  // Appends samples of an arc, from behind its start to its end; the start has been sampled before.
  void sample(const Complex::Arc& a, bool is_backward, double tolerance)
  {
    const std::size_t first = m_samples.size();
    const Arc_curve curve(a);
    curve.sample(tolerance, [&](const Point& p) { m_samples.push_back(p); }, number_of_halvings);
    if(m_samples.size() == first + 1) // a curve along a side may need a vertex inside (has_to_leave_side())
      m_samples.insert(m_samples.end() - 1, curve.point(0.5));
    if(!is_backward)
      return;
    std::reverse(m_samples.begin() + static_cast<std::ptrdiff_t>(first), m_samples.end() - 1);
    m_samples.back() = a.first;
  }

  // Returns whether a curve between two vertices of one side must not become a segment, as other vertices are between
  // them.
  bool has_to_leave_side(std::uint32_t a, std::uint32_t b) const
  {
    const std::uint32_t n = static_cast<std::uint32_t>(m_border_points.size());
    return (m_sides[a] & m_sides[b]) != 0 && (a + 1) % n != b && (b + 1) % n != a;
  }

  // Adds vertices for those samples between i and j that the tolerance needs, in their order; at least one if
  // `is_forced` and there are samples between them (the algorithm of D. H. Douglas and T. K. Peucker, 1973). Of samples
  // that are equally far from the segment, the first one becomes a vertex.
  void simplify(std::size_t i, std::size_t j, double tolerance, bool is_forced, std::vector<std::uint32_t>& vertices)
  {
    std::size_t best = i;
    double largest = -1;
    for(std::size_t k = i + 1; k < j; ++k)
    {
      const double d = distance_from_segment(m_samples[k], m_samples[i], m_samples[j]);
      if(d > largest)
      {
        best = k;
        largest = d;
      }
    }
    if(best == i || (!is_forced && largest <= tolerance))
      return;
    simplify(i, best, tolerance, false, vertices);
    vertices.push_back(add_vertex(m_samples[best]));
    simplify(best, j, tolerance, false, vertices);
  }

  // --- pieces of cells ---

  // Walks around each part of a cell once: along the border from node to node, and along curves back to the border. The
  // part is on the left of its walk. Each piece of the border is in one walk, each curve in two, one for each side.
  // Takes time cubic in the number of vertices.
  void collect_regions()
  {
    m_largest_number_of_vertices = (std::max)(m_largest_number_of_vertices, m_points.size());
    const std::size_t n = m_border_nodes.size();
    std::vector<char> is_seen(n, 0);
    std::vector<std::uint32_t> walk;
    for(std::size_t start = 0; start < n; ++start)
    {
      if(is_seen[start])
        continue;
      const Vertex_id site = site_behind(start);
      walk.clear();
      std::size_t i = start;
      while(!is_seen[i])
      {
        is_seen[i] = 1;
        walk_along_border(i, (i + 1) % n, walk);
        i = walk_along_curves((i + 1) % n, site, walk);
      }
      divide_into_cycles(walk, site);
    }
  }

  // Returns the cell on the border behind a border node, according to this face: that on the right of a curve that
  // starts here. The node itself may list its two cells in the order of the other face.
  Vertex_id site_behind(std::size_t border_node) const
  {
    const std::uint32_t node = m_border_nodes[border_node].node;
    for(const Cut_curve& s : m_curves)
      if(s.first_node == node)
        return s.right_site;
      else if(s.last_node == node)
        return s.left_site;
    return m_complex.nodes()[node].sites[1];
  }

  // Appends the border vertices from one border node to the next one, both included. Positions run on past corner 0,
  // so that the last piece of the border does not run backward.
  void walk_along_border(std::size_t from, std::size_t to, std::vector<std::uint32_t>& walk) const
  {
    const std::uint32_t n = static_cast<std::uint32_t>(m_border_points.size());
    const std::uint32_t end = m_border_nodes[to].position + (to > from ? 0 : n);
    for(std::uint32_t i = m_border_nodes[from].position; i <= end; ++i)
      walk.push_back(i % n);
  }

  // Walks along the curves with the cell on the left, from a border node to the next border node, which is returned. At
  // each vertex of the diagram one curve leads on, because the three cells there differ.
  std::size_t walk_along_curves(std::size_t border_node, Vertex_id site, std::vector<std::uint32_t>& walk) const
  {
    std::uint32_t node = m_border_nodes[border_node].node;
    for(std::size_t steps = 0; steps <= m_curves.size(); ++steps)
    {
      const auto it = std::find_if(m_curves.begin(), m_curves.end(), [&](const Cut_curve& s)
      { return (s.first_node == node && s.left_site == site) || (s.last_node == node && s.right_site == site); });
      if(it == m_curves.end())
        break;
      if(it->first_node == node && it->left_site == site)
      {
        walk.insert(walk.end(), it->vertices.begin(), it->vertices.end());
        node = it->last_node;
      }
      else
      {
        walk.insert(walk.end(), it->vertices.rbegin(), it->vertices.rend());
        node = it->first_node;
      }
      for(std::size_t i = 0; i < m_border_nodes.size(); ++i)
        if(m_border_nodes[i].node == node)
          return i;
    }
    CGAL_assertion_msg(false, "a curve in a face has no end");
    return border_node;
  }

  // Triangulates the cycles of a walk: when a vertex is met again, the vertices since the last time are a cycle. A walk
  // meets a vertex twice where contraction has closed a part of the cell, or where curves share their vertex.
  void divide_into_cycles(const std::vector<std::uint32_t>& walk, Vertex_id site)
  {
    std::vector<std::uint32_t> open;
    for(std::uint32_t v : walk)
    {
      const auto it = std::find(open.begin(), open.end(), v);
      if(it == open.end())
      {
        open.push_back(v);
        continue;
      }
      triangulate(std::vector<std::uint32_t>(it, open.end()), site);
      open.erase(it + 1, open.end());
    }
    triangulate(open, site);
  }

  // Adds the triangles of a cycle of vertices. A cycle of two vertices has none.
  void triangulate(const std::vector<std::uint32_t>& cycle, Vertex_id site)
  {
    if(cycle.size() < 3)
      return;
    m_polygon.clear();
    for(std::uint32_t v : cycle)
      m_polygon.push_back(m_points[v]);
    // A diagonal along a side of the face, or one between the ends of an edge, would be a second edge between them.
    m_triangulation.build(m_polygon, [&](std::size_t i, std::size_t j)
    {
      const std::uint32_t a = cycle[i], b = cycle[j];
      return (m_sides[a] & m_sides[b]) == 0 && m_edges.count(std::minmax(a, b)) == 0;
    });
    m_badness += m_triangulation.badness();
    for(const Polygon_triangulation::Triangle& t : m_triangulation.triangles())
    {
      m_triangles.push_back(Triangle{{cycle[t[0]], cycle[t[1]], cycle[t[2]]}, site});
      for(unsigned int k = 0; k < 3; ++k)
      {
        const std::uint32_t a = cycle[t[k]], b = cycle[t[next_corner(k)]];
        m_edges.insert(std::minmax(a, b));
      }
    }
  }

  const Mesh& m_mesh;
  const Complex& m_complex;
  Face_id m_face = null_id;
  // The vertices on the border, and all vertices, which begin with these; indices of vertices refer to them.
  std::vector<Point> m_border_points, m_points;
  std::vector<unsigned char> m_sides; // the sides on which a vertex is, one bit for each
  std::vector<Border_node> m_border_nodes;
  std::vector<Triangle> m_triangles;
  std::uint64_t m_badness = 0;
  std::size_t m_largest_number_of_vertices = 0;
  std::unordered_map<std::uint32_t, std::uint32_t> m_vertex_of_node;
  std::vector<Cut_curve> m_curves;
  std::vector<Point> m_samples, m_polygon;
  std::set<std::pair<std::uint32_t, std::uint32_t>> m_edges; // segments of curves, sides of triangles
  Polygon_triangulation m_triangulation;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_VORONOI_FACE_CUT_H
