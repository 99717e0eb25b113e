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

// The curves between the cells of all sites on the whole surface. The nearest site is decided for vertices first, then
// for edges (Edge_partition.h), then for faces (Face_partition.h). Each step keeps what the one before has decided, so
// that the pieces fit together across edges.
//
// The complex is generic: three arcs meet at each vertex of the diagram, and no arc runs through a vertex of the mesh
// or along an edge. On symmetric surfaces ties are decided one way or the other, which yields arcs without length;
// has_length() tells, and readers of the complex leave them out.
//
// Steps: add() divides a face (divide()) and copies its nodes and arcs (add_breakpoint_nodes(), add_division()), and
// counts the parts of cells in it. finish() counts the other elements of cells (count_edges_and_faces()), and links
// arcs to chains (link_chains()).

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Divided_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Face_partition.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/arcs_and_nodes.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/coordinates_in_layout.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_table.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Use: start(), add() for each divided face while distances are propagated, finish(). The queries are valid after that,
// and until clear() or start(). Several threads may call them at once.
//
// Invariants after finish():
// - Each node has one arc (at the border of the mesh), two, or three (at a vertex of the diagram). Face_partition gives
//   one arc to each breakpoint of a face; an edge inside the mesh gets a second one from its other face, because
//   Edge_partition divides the edge once for both.
// - Each arc is in one chain; each chain is in the boundary of the cells on its two sides, once in each direction
//   (link_chain()).
// - The three sites of a vertex differ, so a cell has at most one chain that begins at a node. boundary() relies on it.
//
// Frame: a point of an arc or node is in the layout of its face. A node on an edge belongs to the face of the halfedge
// with the smaller index; the other face finds the same point by the abscissa.
template <typename FT_>
class Voronoi_complex
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Point = Planar_point<FT>;
  using Arc = Voronoi_arc<FT>;
  using Node = Voronoi_node<FT>;
  using Chain = Voronoi_chain;

  // Removes all elements, and starts a complex. Then the divided faces are added in any order, each once, and finish()
  // is called. The mesh is referred to, not copied. A site is the vertex where it is, or, if one may be at several
  // vertices, a number.
  void start(const Mesh& mesh, bool has_numbers_of_sites = false)
  {
    clear();
    m_mesh = &mesh;
    m_has_numbers_of_sites = has_numbers_of_sites;
  }

  // Are sites numbers, and not vertices? (The complex itself does not care.)
  bool has_numbers_of_sites() const { return m_has_numbers_of_sites; }

  // Adds the curves in a face that lies in several cells. Requires: the breakpoints of a side are those that the other
  // face at the edge gets; a cell that begins at one breakpoint ends at the next one.
  void add(const Divided_face<FT>& divided)
  {
    divide(divided, m_partition);
    add(divided, m_partition.division());
  }

  // The first step of add(), which takes nearly all of the time: finds the curves. Reads the mesh only, so several
  // threads may divide faces, each with its own partition, and one may add others meanwhile.
  void divide(const Divided_face<FT>& divided, Face_partition<FT>& partition) const
  {
    partition.start(layout(divided.face));
    for(unsigned int k = 0; k < 3; ++k)
      add_breakpoints(halfedge_of(divided.face, k), divided.breakpoints[k], partition);
    for(const Site_image<FT>& image : divided.images)
      partition.add(image);
    partition.build();
  }

  // The second step of add(): copies the nodes and arcs into the complex. The first nodes of the division are the
  // breakpoints, whose nodes may exist already, from the other face at the edge; the others are new.
  void add(const Divided_face<FT>& divided, const Face_division<FT>& division)
  {
    m_breakpoint_nodes.clear();
    for(unsigned int k = 0; k < 3; ++k)
      add_breakpoint_nodes(halfedge_of(divided.face, k), divided.breakpoints[k]);
    add_division(divided.face, division);
  }

  // Completes the complex, given the nearest site of each vertex of the mesh, null_id where none arrives. Takes time
  // linear in the sizes of mesh and complex.
  // Requires: on each edge, the sites of its ends are those with which its breakpoints begin and end.
  void finish(std::vector<Vertex_id> owners)
  {
    CGAL_precondition(owners.size() == m_mesh->number_of_vertices());
    m_owner = std::move(owners);
    for(Vertex_id v = 0; v < m_owner.size(); ++v)
    {
      if(m_owner[v] == null_id)
        continue;
      ++m_cells.of(m_owner[v]).vertices;
      m_cells.of(m_owner[v]).vertex = v;
      m_cells.of(m_owner[v]).pinched_vertices += m_mesh->has(v, Mesh::PINCHED) ? 1 : 0;
    }
    count_edges_and_faces();
    link_chains();
  }

  // Removes all elements; the memory is kept.
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
    m_number_of_joints = 0;
  }

  // The elements; indices in other elements refer to these arrays. Arcs of one face are consecutive; faces follow each
  // other in the order of add(), not by their indices.
  const std::vector<Arc>& arcs() const { return m_arcs; }
  const std::vector<Node>& nodes() const { return m_nodes; }
  const std::vector<Chain>& chains() const { return m_chains; }

  // Returns the nearest site of a vertex, null_id if none reaches it.
  Vertex_id owner(Vertex_id v) const { return m_owner[v]; }

  // Returns (first, last): the arcs in a face are first, ..., last - 1. It is (0, 0) for a face in one cell.
  std::pair<std::uint32_t, std::uint32_t> arcs_of_face(Face_id f) const
  {
    const std::pair<std::uint32_t, std::uint32_t>* const arcs = m_arcs_of_face.find(f);
    return arcs == nullptr ? std::pair<std::uint32_t, std::uint32_t>(0, 0) : *arcs;
  }

  // The nodes on the edge of a halfedge, from its source to its target: node(i) for i < number.
  struct Nodes_on_edge
  {
    std::uint32_t first = 0, number = 0;
    bool is_reversed = false;

    std::uint32_t node(std::uint32_t i) const { return first + (is_reversed ? number - 1 - i : i); }
  };

  // Returns the nodes on the edge of h, none if the edge is in one cell. Takes constant time.
  Nodes_on_edge nodes_on_edge(Halfedge_id h) const
  {
    Nodes_on_edge result;
    result.is_reversed = !m_mesh->is_first_of_edge(h);
    const Index_range* const nodes = m_edge_nodes.find(result.is_reversed ? m_mesh->opposite(h) : h);
    if(nodes != nullptr)
    {
      result.first = nodes->first;
      result.number = nodes->size;
    }
    return result;
  }

  // Returns the nearest site of a face that no arc runs through: that of any corner, as all of them agree.
  // Requires: has_one_cell(f).
  Vertex_id owner_of_undivided(Face_id f) const
  {
    CGAL_assertion(has_one_cell(f));
    return owner_of_face(f);
  }

  // Returns whether no arc runs through a face.
  bool has_one_cell(Face_id f) const { return m_arcs_of_face.find(f) == nullptr; }

  // Returns the number of mesh elements in the cell of a site, zeros if the cell is empty.
  Voronoi_cell_elements cell(Vertex_id site) const { return m_cells.find(site); }

  // Calls visit(site, p, q) for the segments of the border of a face, counterclockwise, cut where cells end. Visits
  // nothing in a face that no site reaches. p and q are in the layout of the face; a segment may have no length.
  template <typename Visit>
  void for_each_border_interval(Face_id f, Visit visit) const
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

  // Return the nodes where an oriented chain starts and ends.
  std::uint32_t start_of(const Oriented_index& c) const
  {
    return c.second ? m_chains[c.first].last_node : m_chains[c.first].first_node;
  }

  std::uint32_t end_of(const Oriented_index& c) const
  {
    return c.second ? m_chains[c.first].first_node : m_chains[c.first].last_node;
  }

  // Returns the parts of the boundary of a cell; none if the cell is empty, or if it is all that its site reaches. The
  // parts that the border of the mesh interrupts come first, each from its beginning. Takes time proportional to the
  // number of chains.
  std::vector<Voronoi_boundary_part> boundary(Vertex_id site) const
  {
    std::vector<Voronoi_boundary_part> result;
    const auto around = m_chains_of_cell.find(site);
    if(around == m_chains_of_cell.end())
      return result;
    const std::vector<Oriented_index>& chains = around->second;
    std::unordered_map<std::uint32_t, std::uint32_t> starting; // node -> the chain that begins there
    std::unordered_set<std::uint32_t> entered; // nodes where a chain ends
    for(std::uint32_t i = 0; i < chains.size(); ++i)
    {
      starting.emplace(start_of(chains[i]), i);
      entered.insert(end_of(chains[i]));
    }
    std::vector<char> is_used(chains.size(), 0);
    // Round 0 starts where no chain of the cell ends, which is at the border; what is left for round 1 is closed.
    for(int round = 0; round < 2; ++round)
      for(std::uint32_t i = 0; i < chains.size(); ++i)
      {
        const std::uint32_t start = start_of(chains[i]);
        const bool is_open = !m_nodes[start].is_vertex() && entered.find(start) == entered.end();
        if(!is_used[i] && (round != 0 || is_open))
          result.push_back(boundary_part(chains, starting, i, is_used));
      }
    return result;
  }

  // Returns the Euler characteristic of a cell together with its boundary: vertices - edges + faces. It is 1 for a disk
  // and 0 for an annulus. Nodes and arcs of a closed part of the boundary cancel each other, so they need not be
  // counted.
  int Euler_characteristic(Vertex_id site) const
  {
    const Voronoi_cell_elements n = cell(site);
    int open = 0; // an open part of the boundary has one node more than arcs
    for(const Voronoi_boundary_part& part : boundary(site))
      open += part.is_closed ? 0 : 1;
    return static_cast<int>(n.vertices + n.face_regions) - static_cast<int>(n.edge_intervals) + open;
  }

  // Returns how often fronts were joined although no computed distance tells how they meet (see Face_partition). 0 for
  // a diagram in general position.
  std::size_t number_of_joints() const { return m_number_of_joints; }

  // Returns the corners of a face in its layout: the frame of all points in that face.
  std::array<Point, 3> layout(Face_id f) const { return layout_of_face(m_mesh->face(f)); }

  // Returns the barycentric coordinates of a point in the layout of a face; see coordinates_in_layout().
  std::array<FT, 3> coordinates(Face_id f, const Point& p) const { return coordinates_in_layout(m_mesh->face(f), p); }

private:
  // Follows the boundary of a cell from chain i on, and marks the chains of that part as used. The part ends where it
  // closes, or at a node of the border, where no chain of the cell begins. `starting` leads from a node to the chain of
  // the cell that begins there (its index in `chains`).
  Voronoi_boundary_part boundary_part(const std::vector<Oriented_index>& chains,
                                      const std::unordered_map<std::uint32_t, std::uint32_t>& starting,
                                      std::uint32_t i, std::vector<char>& is_used) const
  {
    Voronoi_boundary_part part;
    const std::uint32_t start = start_of(chains[i]);
    while(true)
    {
      is_used[i] = 1;
      part.chains.push_back(chains[i]);
      const std::uint32_t end = end_of(chains[i]);
      part.is_closed = end == start;
      const auto next = starting.find(end);
      if(part.is_closed || next == starting.end() || is_used[next->second])
        return part;
      i = next->second;
    }
  }

  // --- edges ---

  // Returns the index of the first node on an edge; the nodes of an edge are consecutive, in the order of h. Makes them
  // when the first face at the edge is added, so that both faces share them.
  // Requires: h is the halfedge of the edge with the smaller index; `breakpoints` are the same in both calls.
  std::uint32_t first_node(Halfedge_id h, const std::vector<Edge_breakpoint<FT>>& breakpoints)
  {
    CGAL_assertion(h < m_mesh->opposite(h)); // (null_id is the largest index)
    const std::uint32_t first = static_cast<std::uint32_t>(m_nodes.size());
    if(!m_edge_nodes.insert(h, Index_range{first, static_cast<std::uint32_t>(breakpoints.size())}))
      return m_edge_nodes.find(h)->first;
    for(const Edge_breakpoint<FT>& e : breakpoints)
    {
      m_nodes.emplace_back(face_of(h), point_on_edge(h, e.x), std::array<Vertex_id, 3>{e.before, e.after, null_id});
      m_nodes.back().abscissa = e.x;
    }
    return first;
  }

  // Returns the point at abscissa x of the edge of h, in the layout of the face of h.
  Point point_on_edge(Halfedge_id h, const FT& x) const
  {
    const std::array<Point, 3> corner = layout(face_of(h));
    const Point a = corner[index_in_face(h)], b = corner[next_corner(index_in_face(h))];
    const FT length = m_mesh->length(h), t = length > 0 ? FT(x / length) : FT(0);
    return Point{FT(a.x + t * (b.x - a.x)), FT(a.y + t * (b.y - a.y))};
  }

  // Counts the faces in one cell each, and the parts into which cells divide edges: one more than the edge has nodes.
  // (add() has counted the parts of faces in several cells.) Each edge is counted once, by its halfedge with the
  // smaller index. All faces and edges count as undivided first. Then the counts of those that are divided are
  // corrected: their tables are small.
  void count_edges_and_faces()
  {
    for(Face_id f = 0; f < m_mesh->number_of_faces(); ++f)
    {
      const typename Mesh::Face& face = m_mesh->face(f);
      if(m_owner[face.vertex[0]] == null_id)
        continue;
      ++m_cells.of(m_owner[face.vertex[0]]).face_regions;
      for(unsigned int k = 0; k < 3; ++k)
        if(m_mesh->is_first_of_edge(halfedge_of(f, k)))
          ++m_cells.of(m_owner[face.vertex[k]]).edge_intervals;
    }
    m_arcs_of_face.for_each([this](Face_id f, const std::pair<std::uint32_t, std::uint32_t>&)
    {
      if(owner_of_face(f) != null_id)
        --m_cells.of(owner_of_face(f)).face_regions;
    });
    m_edge_nodes.for_each([this](Halfedge_id h, const Index_range& nodes)
    {
      if(owner_of_face(face_of(h)) == null_id)
        return;
      for(std::uint32_t n = nodes.first; n < nodes.first + nodes.size; ++n)
        ++m_cells.of(m_nodes[n].sites[1]).edge_intervals;
    });
  }

  // The site of the first corner of a face.
  Vertex_id owner_of_face(Face_id f) const { return m_owner[m_mesh->face(f).vertex[0]]; }

  // --- faces ---

  // Adds the breakpoints on the side of h to the partition, from the source of h on. They come in the order of the
  // first halfedge of the edge; if that is the opposite of h, they are reversed, and so are the cells on both sides.
  void add_breakpoints(Halfedge_id h, const std::vector<Edge_breakpoint<FT>>& breakpoints,
                       Face_partition<FT>& partition) const
  {
    const bool is_reversed = !m_mesh->is_first_of_edge(h);
    for(std::size_t i = 0; i < breakpoints.size(); ++i)
    {
      const Edge_breakpoint<FT>& e = breakpoints[is_reversed ? breakpoints.size() - 1 - i : i];
      const Point p = point_on_edge(h, is_reversed ? FT(m_mesh->length(h) - e.x) : e.x);
      partition.add(Border_breakpoint<FT>{p, is_reversed ? e.after : e.before, is_reversed ? e.before : e.after});
    }
  }

  // Notes the nodes of the same breakpoints.
  void add_breakpoint_nodes(Halfedge_id h, const std::vector<Edge_breakpoint<FT>>& breakpoints)
  {
    if(breakpoints.empty())
      return;
    const bool is_reversed = !m_mesh->is_first_of_edge(h);
    const std::uint32_t size = static_cast<std::uint32_t>(breakpoints.size());
    const std::uint32_t first = first_node(is_reversed ? m_mesh->opposite(h) : h, breakpoints);
    for(std::uint32_t i = 0; i < size; ++i)
      m_breakpoint_nodes.push_back(first + (is_reversed ? size - 1 - i : i));
  }

  // Copies the nodes and arcs in face f into the complex, behind those of its breakpoints.
  void add_division(Face_id f, const Face_division<FT>& division)
  {
    m_number_of_joints += division.number_of_joints;
    std::vector<std::uint32_t>& node_of = m_node_of;
    node_of = m_breakpoint_nodes;
    for(std::size_t i = node_of.size(); i < division.nodes.size(); ++i)
    {
      node_of.push_back(static_cast<std::uint32_t>(m_nodes.size()));
      m_nodes.emplace_back(f, division.nodes[i].p, division.nodes[i].sites);
    }
    const std::uint32_t first = static_cast<std::uint32_t>(m_arcs.size());
    for(const Face_arc<FT>& a : division.arcs)
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
    count_regions(division);
  }

  // Notes that an arc ends at a node. Requires: the node has fewer than three arcs, which it has because the complex is
  // generic.
  void add_arc_to_node(std::uint32_t node, std::uint32_t arc)
  {
    for(std::uint32_t& a : m_nodes[node].arc)
      if(a == null_id)
      {
        a = arc;
        return;
      }
  }

  // Counts the pieces of cells in the face: walks around each piece once, along the border and the arcs. No piece is
  // missed, since each one touches the border (Face_partition). is_seen[i] tells whether the part of the border behind
  // breakpoint i has been walked along.
  void count_regions(const Face_division<FT>& division)
  {
    const std::size_t n = m_breakpoint_nodes.size();
    std::vector<char>& is_seen = m_is_seen;
    is_seen.assign(n, 0);
    for(std::size_t start = 0; start < n; ++start)
    {
      if(is_seen[start])
        continue;
      const Vertex_id site = division.nodes[start].sites[1];
      ++m_cells.of(site).face_regions;
      std::size_t i = start;
      while(!is_seen[i])
      {
        is_seen[i] = 1;
        i = follow_in_face(division.arcs, (i + 1) % n, site);
      }
    }
  }

  // Follows the arcs from a breakpoint, with the cell of `site` on the left, and returns the breakpoint where they end.
  // At each node one arc leads on, as the other arcs there have `site` on the other side or not at all. Nodes have
  // their numbers in the partition: those below n are breakpoints.
  std::size_t follow_in_face(const std::vector<Face_arc<FT>>& arcs, std::size_t node, Vertex_id site) const
  {
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
    return node < n ? node : 0; // 0 only if the arcs are not a forest; the caller's walk ends nevertheless
  }

  // --- chains ---

  // Links the arcs to chains: first those that end at a vertex or the border, from there, then the closed ones, from an
  // arbitrary node. (What the first round leaves runs through nodes of two arcs only, so it is closed.) Takes linear
  // time.
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

  // Adds the chain that leaves a node by an arc, and marks its arcs as linked. The cell on the left stays the same from
  // arc to arc, as two arcs that meet at a node of two sites separate the same cells. The chain ends at a vertex, at
  // the border, or where it began.
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
      const bool is_backward = a.first_node != node;
      is_linked[arc] = 1;
      chain.arcs.emplace_back(arc, is_backward);
      chain.has_length = chain.has_length || has_length(a);
      node = is_backward ? a.first_node : a.last_node;
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
    m_chains.push_back(std::move(chain));
  }

public:
  // Returns whether an arc is longer than rounding can make it. Arcs without length come from ties: where four cells
  // meet in a point, the complex has two vertices and such an arc between them.
  bool has_length(const Arc& a) const
  {
    const typename Mesh::Face& face = m_mesh->face(a.face);
    const FT size = longest_side(face);
    return distance(a.first, a.last) > rounding_at(a.first_node, size);
  }

  // Returns the length by which rounding may move a node, in a face or on an edge of a given size: the rounding of
  // coordinates there, plus that of the images, which are as far away as the sites and err by a smaller part of that.
  // An estimate, not a proved bound (see Tolerance::interval()); it decides what readers leave out, not what is found.
  FT rounding_at(std::uint32_t node, const FT& size) const
  {
    return Tolerance<FT>::interval() * (size + m_nodes[node].distance / 8);
  }

private:
  const Mesh* m_mesh = nullptr;
  bool m_has_numbers_of_sites = false;
  std::vector<Vertex_id> m_owner; // the nearest site, by vertex
  Index_table<Index_range> m_edge_nodes; // the nodes on divided edges, by the halfedge with the smaller index
  // By site: each chain of its boundary, oriented so that the cell is on the left.
  std::unordered_map<Vertex_id, std::vector<Oriented_index>> m_chains_of_cell;
  std::vector<Node> m_nodes;
  std::vector<Arc> m_arcs;
  std::vector<Chain> m_chains;
  Index_table<std::pair<std::uint32_t, std::uint32_t>> m_arcs_of_face; // (first, last); divided faces only
  Elements_of_cells m_cells;
  std::size_t m_number_of_joints = 0;
  Face_partition<FT> m_partition;
  // For the face that is added: the node of each breakpoint, and of each node of the partition. (Breakpoints are the
  // first nodes of the partition, in the same order.)
  std::vector<std::uint32_t> m_breakpoint_nodes, m_node_of;
  std::vector<char> m_is_seen;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_VORONOI_COMPLEX_H
