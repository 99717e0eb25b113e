// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_VORONOI_COMPLEX_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_VORONOI_COMPLEX_H

// The curves between the cells of the sources, on the whole surface: from vertices (whose nearest source is
// known) to edges (Edge_partition.h) to faces (Face_partition.h). Each step takes over what the one before
// has decided, so the pieces fit together over the edges.
//
// The complex is generic: three arcs meet in each vertex, no arc runs through a vertex of the mesh or along
// an edge. Where the surface is symmetric, ties are decided one way or the other, and arcs without length
// result; they are marked, and those who show the complex leave them out.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Face_partition.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_table.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Redundant_window_removal.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/site_images_of_face.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A piece of the curve between two cells in one face; points in the layout of the face.
template <typename FT>
struct Voronoi_arc
{
  Face_id face;
  Vertex_id left_site, right_site;
  Additively_weighted_point<FT> left, right;
  Planar_point<FT> first, last;
  std::uint32_t first_node, last_node;
  bool is_bisector;
};

// A point where arcs meet: of two arcs of the same cells, or of three cells, which are in counterclockwise
// order then. `face` and `point` are one place where it is.
template <typename FT>
struct Voronoi_node
{
  Face_id face;
  Planar_point<FT> point;
  FT abscissa = 0; // on its edge, if it is on one (Edge_partition.h)
  FT distance;
  std::array<Vertex_id, 3> sites; // the last one is null_id unless three cells meet
  std::array<std::uint32_t, 3> arc{null_id, null_id, null_id};

  bool is_vertex() const { return sites[2] != null_id; }
};

// Arcs of two cells from end to end, each with `left` on its left. `first_node` and `last_node` are vertices
// or points of the border; they are the same if the chain is closed.
struct Voronoi_chain
{
  Vertex_id left_site, right_site;
  std::vector<std::pair<std::uint32_t, bool>> arcs; // and whether it is run through backwards
  std::uint32_t first_node, last_node;
  bool is_closed;
  bool has_length;
};

// What there is of a cell, to count with.
struct Voronoi_cell_elements
{
  std::size_t vertices = 0, edge_intervals = 0, face_regions = 0;
};

template <typename FT_>
class Voronoi_complex
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;
  using Removal = Redundant_window_removal<FT, Voronoi_complex>;
  using Point = Planar_point<FT>;
  using Arc = Voronoi_arc<FT>;
  using Node = Voronoi_node<FT>;
  using Chain = Voronoi_chain;
  using Image = Site_image<FT>;

  // Sites are numbered as vertices of the mesh. Faces are added by the removal of redundant windows while
  // distances are propagated; finish() is called when that has finished.
  void start(const Mesh& mesh, const Field& field, Removal& removal)
  {
    clear();
    m_mesh = &mesh;
    m_field = &field;
    m_removal = &removal;
  }

  void add_divided_face(Face_id f)
  {
    m_breakpoint_nodes.clear();
    m_partition.start(layout(f));
    for(unsigned int k = 0; k < 3; ++k)
      add_breakpoints(halfedge_of(f, k));
    for_each_site_image(*m_mesh, *m_field, m_removal->windows(),
                            [this](Vertex_id v) { return m_removal->owner(v); }, f,
                            [this](const Image& g) { m_partition.add(g); });
    m_partition.build();
    add_partition(f);
  }

  void finish()
  {
    m_owner.resize(m_mesh->number_of_vertices());
    for(Vertex_id v = 0; v < m_owner.size(); ++v)
    {
      m_owner[v] = m_removal->owner(v);
      if(m_owner[v] != null_id)
        ++elements(m_owner[v]).vertices;
    }
    count_edges_and_faces();
    link_chains();
    m_removal = nullptr;
  }

  void clear()
  {
    m_owner.clear();
    m_edge_nodes.clear();
    m_chains_of_cell.clear();
    m_nodes.clear();
    m_arcs.clear();
    m_chains.clear();
    m_arcs_of_face.clear();
    m_cells.clear();
    m_last_site = null_id;
    m_number_of_joints = 0;
  }

  const std::vector<Arc>& arcs() const { return m_arcs; }
  const std::vector<Node>& nodes() const { return m_nodes; }
  const std::vector<Chain>& chains() const { return m_chains; }

  // the nearest source of a vertex; null_id if none reaches it.
  Vertex_id owner(Vertex_id v) const { return m_owner[v]; }

  // the numbers of the arcs in a face are first, ..., last - 1.
  std::pair<std::uint32_t, std::uint32_t> arcs_of_face(Face_id f) const
  {
    const std::pair<std::uint32_t, std::uint32_t>* const arcs = m_arcs_of_face.find(f);
    return arcs == nullptr ? std::pair<std::uint32_t, std::uint32_t>(0, 0) : *arcs;
  }

  // The nodes on the edge of a halfedge, in the order from its source to its target: node(i) for i < number.
  struct Nodes_on_edge
  {
    std::uint32_t first = 0, number = 0;
    bool is_reversed = false;

    std::uint32_t node(std::uint32_t i) const { return first + (is_reversed ? number - 1 - i : i); }
  };

  Nodes_on_edge nodes_on_edge(Halfedge_id h) const
  {
    const Halfedge_id o = m_mesh->opposite(h);
    Nodes_on_edge result;
    result.is_reversed = o != null_id && o < h;
    const Breakpoint_range* const nodes = m_edge_nodes.find(result.is_reversed ? o : h);
    if(nodes != nullptr)
    {
      result.first = nodes->first;
      result.number = nodes->size;
    }
    return result;
  }

  // the nearest source of a face that no arc runs through.
  Vertex_id owner_of_undivided(Face_id f) const { return m_owner[m_mesh->face(f).vertex[0]]; }

  bool has_one_cell(Face_id f) const { return m_arcs_of_face.find(f) == nullptr; }

  Voronoi_cell_elements cell(Vertex_id site) const
  {
    const auto it = m_cells.find(site);
    return it == m_cells.end() ? Voronoi_cell_elements() : it->second;
  }

  // calls visit(site, p, q) for the segments of the border of a face, counterclockwise, cut where cells end.
  template <typename Visitor>
  void for_each_border_interval(Face_id f, Visitor visit) const
  {
    const std::array<Point, 3> corner = layout(f);
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k);
      Vertex_id site = m_owner[m_mesh->source(h)];
      if(site == null_id)
        return;
      Point from = corner[k];
      const Nodes_on_edge nodes = nodes_on_edge(h);
      for(std::uint32_t i = 0; i < nodes.number; ++i)
      {
        const Node& node = m_nodes[nodes.node(i)];
        const Point to = point_on_edge(h, nodes.is_reversed ? FT(m_mesh->length(h) - node.abscissa) : node.abscissa);
        visit(site, from, to);
        site = node.sites[nodes.is_reversed ? 0 : 1];
        from = to;
      }
      visit(site, from, corner[next_corner(k)]);
    }
  }

  // The chains around a cell, with the cell on the left: the number of the chain and whether it is run through
  // backwards; and whether they close.
  std::vector<std::pair<std::vector<std::pair<std::uint32_t, bool>>, bool>> boundary(Vertex_id site) const
  {
    std::vector<std::pair<std::vector<std::pair<std::uint32_t, bool>>, bool>> result;
    const auto around = m_chains_of_cell.find(site);
    if(around == m_chains_of_cell.end())
      return result;
    // where the chains of the cell begin
    std::unordered_map<std::uint32_t, std::uint32_t> starting;
    std::unordered_map<std::uint32_t, char> is_entered;
    for(const std::pair<std::uint32_t, bool>& c : around->second)
    {
      starting.emplace(start_of(c), static_cast<std::uint32_t>(&c - around->second.data()));
      is_entered[end_of(c)] = 1;
    }
    std::vector<char> is_used(around->second.size(), 0);
    // parts that are interrupted by the border first, from their beginnings
    for(int round = 0; round < 2; ++round)
      for(std::uint32_t i = 0; i < around->second.size(); ++i)
      {
        const std::uint32_t start = start_of(around->second[i]);
        const bool is_open = !m_nodes[start].is_vertex() && is_entered.find(start) == is_entered.end();
        if(is_used[i] || (round == 0 && !is_open))
          continue;
        result.emplace_back();
        std::uint32_t j = i;
        while(true)
        {
          is_used[j] = 1;
          result.back().first.push_back(around->second[j]);
          const std::uint32_t end = end_of(around->second[j]);
          result.back().second = end == start;
          const auto next = starting.find(end);
          if(end == start || next == starting.end() || is_used[next->second])
            break;
          j = next->second;
        }
      }
    return result;
  }

  // of a cell with its boundary.
  int Euler_characteristic(Vertex_id site) const
  {
    const Voronoi_cell_elements n = cell(site);
    int open = 0; // an open part of the boundary has one point more than arcs
    for(const auto& part : boundary(site))
      open += part.second ? 0 : 1;
    return static_cast<int>(n.vertices + n.face_regions) - static_cast<int>(n.edge_intervals) + open;
  }

  // how many curves had to be joined where numbers did not tell how (see Face_partition).
  std::size_t number_of_joints() const { return m_number_of_joints; }

  std::array<Point, 3> layout(Face_id f) const { return layout_of_face(m_mesh->face(f)); }

  // the barycentric coordinates of a point in the layout of a face.
  std::array<FT, 3> coordinates(Face_id f, const Point& p) const
  {
    const typename Mesh::Face& face = m_mesh->face(f);
    if(has_no_height(face))
      return coordinates_on_edge(f, face.length[1] < face.length[2] ? 2 : 1, p);
    std::array<FT, 3> b;
    b[2] = p.y / face.apex_y;
    b[1] = (p.x - b[2] * face.apex_x) / face.length[0];
    b[0] = 1 - b[1] - b[2];
    return b[0] >= 0 && b[1] >= 0 && b[2] >= 0 ? b : coordinates_on_border(f, p);
  }

private:
  // of the point of the border that is nearest to p, which is outside by rounding. (In a narrow face, to cut negative
  // coordinates off would move the point along the face.)
  std::array<FT, 3> coordinates_on_border(Face_id f, const Point& p) const
  {
    const std::array<Point, 3> corner = layout(f);
    std::array<FT, 3> best{};
    FT smallest = std::numeric_limits<FT>::infinity();
    for(unsigned int k = 0; k < 3; ++k)
    {
      const std::array<FT, 3> b = coordinates_on_edge(f, k, p);
      const Point q{FT(b[0] * corner[0].x + b[1] * corner[1].x + b[2] * corner[2].x),
                    FT(b[0] * corner[0].y + b[1] * corner[1].y + b[2] * corner[2].y)};
      const FT d = distance(p, q);
      if(d < smallest)
      {
        best = b;
        smallest = d;
      }
    }
    return best;
  }

  // of the point of edge k that is nearest to p: in a face without height, that is p itself.
  std::array<FT, 3> coordinates_on_edge(Face_id f, unsigned int k, const Point& p) const
  {
    const std::array<Point, 3> corner = layout(f);
    const Point &a = corner[k], &b = corner[next_corner(k)];
    const FT x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    const FT t = square > 0 ? FT(((p.x - a.x) * x + (p.y - a.y) * y) / square) : FT(0);
    std::array<FT, 3> result{FT(0), FT(0), FT(0)};
    result[next_corner(k)] = (std::min)((std::max)(t, FT(0)), FT(1));
    result[k] = 1 - result[next_corner(k)];
    return result;
  }

  std::uint32_t start_of(const std::pair<std::uint32_t, bool>& c) const
  {
    return c.second ? m_chains[c.first].last_node : m_chains[c.first].first_node;
  }

  std::uint32_t end_of(const std::pair<std::uint32_t, bool>& c) const
  {
    return c.second ? m_chains[c.first].first_node : m_chains[c.first].last_node;
  }

  // --- edges ---

  // the number of the first node of an edge, whose halfedge with the smaller number is h.
  std::uint32_t first_node(Halfedge_id h, const Breakpoint_range& breakpoints)
  {
    const std::uint32_t first = static_cast<std::uint32_t>(m_nodes.size());
    if(!m_edge_nodes.insert(h, Breakpoint_range{first, breakpoints.size}))
      return m_edge_nodes.find(h)->first;
    for(std::uint32_t i = 0; i < breakpoints.size; ++i)
    {
      const Edge_breakpoint<FT>& e = m_removal->breakpoint(breakpoints.first + i);
      Node node;
      node.face = face_of(h);
      node.point = point_on_edge(h, e.x);
      node.abscissa = e.x;
      node.distance = 0; // set with the arcs
      node.sites = {e.before, e.after, null_id};
      m_nodes.push_back(node);
    }
    return first;
  }

  // the point at x of the edge of h, in the layout of the face of h.
  Point point_on_edge(Halfedge_id h, const FT& x) const
  {
    const std::array<Point, 3> corner = layout(face_of(h));
    const Point a = corner[index_in_face(h)], b = corner[next_corner(index_in_face(h))];
    const FT length = m_mesh->length(h), t = length > 0 ? FT(x / length) : FT(0);
    return Point{FT(a.x + t * (b.x - a.x)), FT(a.y + t * (b.y - a.y))};
  }

  // The elements of the cell of a site, which is the same again and again.
  Voronoi_cell_elements& elements(Vertex_id site)
  {
    if(site != m_last_site)
    {
      m_last_elements = &m_cells[site];
      m_last_site = site;
    }
    return *m_last_elements;
  }

  void count_edges_and_faces()
  {
    for(Face_id f = 0; f < m_mesh->number_of_faces(); ++f)
    {
      const typename Mesh::Face& face = m_mesh->face(f);
      if(m_owner[face.vertex[0]] == null_id)
        continue;
      const bool is_whole = has_one_cell(f);
      if(is_whole)
        ++elements(m_owner[face.vertex[0]]).face_regions;
      for(unsigned int k = 0; k < 3; ++k)
      {
        const Halfedge_id h = halfedge_of(f, k), o = face.opposite[k];
        if(o != null_id && o < h)
          continue;
        ++elements(m_owner[face.vertex[k]]).edge_intervals;
        if(is_whole)
          continue;
        const Breakpoint_range breakpoints = m_removal->breakpoints(h);
        for(std::uint32_t i = 0; i < breakpoints.size; ++i)
          ++elements(m_removal->breakpoint(breakpoints.first + i).after).edge_intervals;
      }
    }
  }

  // --- faces ---

  void add_breakpoints(Halfedge_id h)
  {
    const Breakpoint_range breakpoints = m_removal->breakpoints(h);
    if(breakpoints.size == 0)
      return;
    const Halfedge_id o = m_mesh->opposite(h);
    const bool is_reversed = o != null_id && o < h;
    const std::uint32_t first = first_node(is_reversed ? o : h, breakpoints);
    for(std::uint32_t i = 0; i < breakpoints.size; ++i)
    {
      const std::uint32_t j = is_reversed ? breakpoints.size - 1 - i : i;
      const Edge_breakpoint<FT>& e = m_removal->breakpoint(breakpoints.first + j);
      typename Face_partition<FT>::Breakpoint b;
      b.p = point_on_edge(h, is_reversed ? FT(m_mesh->length(h) - e.x) : e.x);
      b.left = is_reversed ? e.after : e.before;
      b.right = is_reversed ? e.before : e.after;
      m_partition.add(b);
      m_breakpoint_nodes.push_back(first + j);
    }
  }

  void add_partition(Face_id f)
  {
    m_number_of_joints += m_partition.number_of_joints();
    const auto& nodes = m_partition.nodes();
    std::vector<std::uint32_t>& node_of = m_node_of;
    node_of.assign(m_breakpoint_nodes.begin(), m_breakpoint_nodes.end());
    for(std::size_t i = node_of.size(); i < nodes.size(); ++i)
    {
      node_of.push_back(static_cast<std::uint32_t>(m_nodes.size()));
      Node node;
      node.face = f;
      node.point = nodes[i].p;
      node.sites = nodes[i].sites;
      node.distance = 0;
      m_nodes.push_back(node);
    }
    const std::uint32_t first = static_cast<std::uint32_t>(m_arcs.size());
    for(const Face_arc<FT>& a : m_partition.arcs())
    {
      const std::uint32_t n = static_cast<std::uint32_t>(m_arcs.size());
      m_arcs.push_back(Arc{f, a.left_site, a.right_site, a.left, a.right, a.first, a.last,
                           node_of[a.first_node], node_of[a.last_node], a.is_bisector});
      add_arc_to_node(node_of[a.first_node], n);
      add_arc_to_node(node_of[a.last_node], n);
      m_nodes[node_of[a.first_node]].distance = a.left.distance_to(a.first);
      m_nodes[node_of[a.last_node]].distance = a.left.distance_to(a.last);
    }
    m_arcs_of_face.insert(f, std::make_pair(first, static_cast<std::uint32_t>(m_arcs.size())));
    count_regions();
  }

  void add_arc_to_node(std::uint32_t node, std::uint32_t arc)
  {
    for(std::uint32_t& a : m_nodes[node].arc)
      if(a == null_id)
      {
        a = arc;
        return;
      }
  }

  // Each piece of a cell in the face is run around once, along the border and the arcs: is_seen tells of the
  // part of the border behind each leaf whether that has been done.
  void count_regions()
  {
    const std::size_t n = m_breakpoint_nodes.size();
    std::vector<char>& is_seen = m_is_seen;
    is_seen.assign(n, 0);
    for(std::size_t start = 0; start < n; ++start)
    {
      if(is_seen[start])
        continue;
      const Vertex_id site = m_partition.nodes()[start].sites[1];
      ++elements(site).face_regions;
      std::size_t i = start;
      while(!is_seen[i])
      {
        is_seen[i] = 1;
        i = follow_in_face((i + 1) % n, site);
      }
    }
  }

  // from a leaf along the arcs with the cell on the left to the next breakpoint.
  std::size_t follow_in_face(std::size_t node, Vertex_id site) const
  {
    const std::vector<Face_arc<FT>>& arcs = m_partition.arcs();
    const std::size_t n = m_breakpoint_nodes.size();
    for(std::size_t steps = 0; steps <= arcs.size(); ++steps)
    {
      for(const Face_arc<FT>& a : arcs)
        if(a.first_node == node && a.left_site == site)
        {
          node = a.last_node;
          break;
        }
        else if(a.last_node == node && a.right_site == site)
        {
          node = a.first_node;
          break;
        }
      if(node < n)
        break;
    }
    return node < n ? node : 0;
  }

  // --- chains ---

  void link_chains()
  {
    std::vector<char> is_linked(m_arcs.size(), 0);
    for(std::uint32_t n = 0; n < m_nodes.size(); ++n)
      if(m_nodes[n].is_vertex() || m_nodes[n].arc[1] == null_id)
        for(std::uint32_t a : m_nodes[n].arc)
          if(a != null_id && !is_linked[a])
            link_chain(n, a, is_linked);
    for(std::uint32_t a = 0; a < m_arcs.size(); ++a)
      if(!is_linked[a])
        link_chain(m_arcs[a].first_node, a, is_linked);
  }

  // the chain that leaves a node by an arc.
  void link_chain(std::uint32_t node, std::uint32_t arc, std::vector<char>& is_linked)
  {
    Chain chain;
    chain.first_node = node;
    chain.has_length = false;
    const bool starts_backwards = m_arcs[arc].first_node != node;
    chain.left_site = starts_backwards ? m_arcs[arc].right_site : m_arcs[arc].left_site;
    chain.right_site = starts_backwards ? m_arcs[arc].left_site : m_arcs[arc].right_site;
    while(true)
    {
      const Arc& a = m_arcs[arc];
      const bool is_backwards = a.first_node != node;
      is_linked[arc] = 1;
      chain.arcs.emplace_back(arc, is_backwards);
      chain.has_length = chain.has_length || has_length(a);
      node = is_backwards ? a.first_node : a.last_node;
      const Node& n = m_nodes[node];
      if(n.is_vertex() || n.arc[1] == null_id || node == chain.first_node)
        break;
      arc = n.arc[0] == arc ? n.arc[1] : n.arc[0];
    }
    chain.last_node = node;
    chain.is_closed = node == chain.first_node && !m_nodes[node].is_vertex() && m_nodes[node].arc[1] != null_id;
    const std::uint32_t number = static_cast<std::uint32_t>(m_chains.size());
    m_chains_of_cell[chain.left_site].emplace_back(number, false);
    m_chains_of_cell[chain.right_site].emplace_back(number, true);
    m_chains.push_back(chain);
  }

public:
  // is an arc longer than rounding can make it?
  bool has_length(const Arc& a) const
  {
    const typename Mesh::Face& face = m_mesh->face(a.face);
    const FT size = longest_side(face);
    return distance(a.first, a.last)
         > Tolerance<FT>::interval() * (size + m_nodes[a.first_node].distance / 8);
  }

private:
  const Mesh* m_mesh = nullptr;
  const Field* m_field = nullptr;
  Removal* m_removal = nullptr; // until the complex is finished
  std::vector<Vertex_id> m_owner;
  Index_table<Breakpoint_range> m_edge_nodes; // of divided edges
  std::unordered_map<Vertex_id, std::vector<std::pair<std::uint32_t, bool>>> m_chains_of_cell;
  std::vector<Node> m_nodes;
  std::vector<Arc> m_arcs;
  std::vector<Chain> m_chains;
  Index_table<std::pair<std::uint32_t, std::uint32_t>> m_arcs_of_face;
  std::unordered_map<Vertex_id, Voronoi_cell_elements> m_cells;
  Vertex_id m_last_site = null_id;
  Voronoi_cell_elements* m_last_elements = nullptr;
  std::size_t m_number_of_joints = 0;
  Face_partition<FT> m_partition;
  std::vector<std::uint32_t> m_breakpoint_nodes, m_node_of; // of the face that is added
  std::vector<char> m_is_seen;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_VORONOI_COMPLEX_H
