// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_HANDLES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_HANDLES_H

// The vertices, arcs and edges that users see, made from the Voronoi complex. The complex may hold arcs and chains
// without length, where the diagram is degenerate; users see none of them, and the nodes that such chains connect are
// one vertex. This table has the handles of all elements, and leads from each element to the complex and back.
//
// Elements are numbered in the order of the complex. In the names below, arcs, *edges* and
// *vertices* are those of the user; the complex has arcs, *chains* and *nodes*.
//
// collect() calls collect_arcs(), collect_edges() and collect_vertices(), in this order: an edge refers to its arcs by
// their numbers.

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Diagram` has the handle types Vertex, Arc and Edge, which are constructible from a pointer to it and a number.
//
// Invariants, from collect() to clear(): elements have the numbers 0, 1, ... in their vectors; each one leads to one
// element of the complex (complex_arc(), chain_of_edge(), node_of_vertex()), chains and nodes back to edges and
// vertices. A chain or arc without length has no handle; nodes that such chains connect have one vertex in common.
// Handles hold a pointer to the diagram, which therefore must not move. Const functions only read, so that several
// threads may call them; collect() and clear() need the object for themselves (Lazy_Voronoi_diagram makes sure of
// that). Numbers are not checked.
template <typename Diagram>
class Voronoi_handles
{
public:
  using Vertex = typename Diagram::Vertex;
  using Arc = typename Diagram::Arc;
  using Edge = typename Diagram::Edge;
  using Boundary = typename Diagram::Boundary;
  using Directed_arc = std::pair<Arc, bool>; // and whether it runs from its end to its start

  // Stands for "no element".
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  explicit Voronoi_handles(const Diagram& diagram) : m_diagram(&diagram) {}

  // Removes the elements. The tables keep old entries, so only collect() may be called next.
  void clear()
  {
    m_vertices.clear();
    m_arcs.clear();
    m_edges.clear();
  }

  // Makes the elements of a complex, in place of those before. `site_at(v)` gives the number of the site at a vertex of
  // the refined mesh, `face_index(f)` the user's index of a face of the refined mesh. If it throws std::bad_alloc,
  // clear() has to follow. Takes time linear in the size of the complex, and O(n log n) for the n runs of arcs, which
  // are sorted by face.
  template <typename Complex, typename SiteAt, typename FaceIndex>
  void collect(const Complex& complex, SiteAt site_at, FaceIndex face_index)
  {
    collect_edges(complex, collect_arcs(complex, face_index));
    collect_vertices(complex, site_at);
  }

  // --- elements, by number ---

  const std::vector<Vertex>& vertices() const { return m_vertices; }
  const std::vector<Arc>& arcs() const { return m_arcs; }
  const std::vector<Edge>& edges() const { return m_edges; }

  // Returns the arcs of an edge, from its start to its end. There is at least one.
  const std::vector<Directed_arc>& arcs_of_edge(std::size_t e) const { return m_edge_arcs[e]; }

  // Returns the sites whose cells meet at a vertex, in ascending order: three, or more where nodes became one vertex.
  const std::vector<std::size_t>& sites_of_vertex(std::size_t v) const { return m_vertex_sites[v]; }

  // Returns the arcs in a face of the user, which is given by its index. Takes O(log n + k) time for n arcs in all and
  // k in the face.
  std::vector<Arc> arcs_in_face(std::size_t face_index) const
  {
    std::vector<Arc> result;
    auto it = std::lower_bound(m_arcs_by_face.begin(), m_arcs_by_face.end(), Run_of_arcs{face_index, 0, 0});
    for(; it != m_arcs_by_face.end() && it->face_index == face_index; ++it)
      result.insert(result.end(), m_arcs.begin() + it->first, m_arcs.begin() + it->last);
    return result;
  }

  // --- along elements ---

  // Writes the points of a polyline along edge e, which is at most `tolerance` away from its arcs. Takes time linear in
  // the number of points. The points come from Diagram::point(). Where an arc without length has been left out, the
  // ends of its neighbors differ by rounding; the first one of the two is written.
  template <typename OutputIterator>
  OutputIterator write_polyline(std::size_t e, double tolerance, OutputIterator output) const
  {
    std::vector<typename Diagram::Face_location> locations;
    bool is_first = true;
    for(const Directed_arc& a : arcs_of_edge(e))
    {
      locations.clear();
      a.first.sample(tolerance, std::back_inserter(locations));
      if(a.second)
        std::reverse(locations.begin(), locations.end());
      for(std::size_t i = is_first ? 0 : 1; i < locations.size(); ++i) // arcs share their ends
        *output++ = m_diagram->point(locations[i]);
      is_first = false;
    }
    return output;
  }

  // Translates the curves of the boundary of a cell, which are chains of the complex. Users see neither the chains
  // without length nor the curves that consist of these alone. `curves` is the result of Voronoi_complex::boundary().
  // Takes linear time.
  template <typename Curves>
  std::vector<Boundary> boundary(const Curves& curves) const
  {
    std::vector<Boundary> result;
    for(const auto& curve : curves)
    {
      Boundary b;
      b.is_closed = curve.is_closed;
      for(const auto& c : curve.chains)
        if(edge_of_chain(c.first) != none)
          b.edges.emplace_back(m_edges[edge_of_chain(c.first)], c.second);
      if(!b.edges.empty())
        result.push_back(b);
    }
    return result;
  }

  // Returns the arcs of a boundary, in its order.
  static std::vector<Arc> arcs_along(const std::vector<Boundary>& boundary)
  {
    std::vector<Arc> result;
    for(const Boundary& b : boundary)
      for(const std::pair<Edge, bool>& e : b.edges)
        for(const Directed_arc& a : e.first.arcs())
          result.push_back(a.first);
    return result;
  }

  // Returns the sites on the other side of a boundary, in ascending order. The cell is on the left of its boundary, so
  // the other site is that on the right: the second one of an edge, or the first one if the boundary runs through it
  // backward.
  static std::vector<std::size_t> sites_beyond(const std::vector<Boundary>& boundary)
  {
    std::vector<std::size_t> result;
    for(const Boundary& b : boundary)
      for(const std::pair<Edge, bool>& e : b.edges)
      {
        const std::pair<std::size_t, std::size_t> s = e.first.sites();
        result.push_back(e.second ? s.first : s.second);
      }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // --- from elements to the complex and back ---

  std::size_t node_of_vertex(std::size_t v) const { return m_node_of_vertex[v]; }
  std::size_t complex_arc(std::size_t a) const { return m_arc_ids[a]; }
  std::size_t chain_of_edge(std::size_t e) const { return m_chain_ids[e]; }

  // Returns none for a node that is not a vertex of the diagram.
  std::size_t vertex_of_node(std::size_t n) const { return m_vertex_of_node[n]; }

  // Returns none for a chain without length.
  std::size_t edge_of_chain(std::size_t c) const { return m_edge_of_chain[c]; }

private:
  // Consecutive arcs in one face. A face that holds sites may have several such runs. The arcs are m_arcs[first], ...,
  // m_arcs[last - 1].
  struct Run_of_arcs
  {
    std::size_t face_index;
    std::ptrdiff_t first, last;

    bool operator<(const Run_of_arcs& other) const
    {
      return face_index != other.face_index ? face_index < other.face_index : first < other.first;
    }
  };

  // Makes the arcs that have a length. Returns the number of the arc for each arc of the complex, or none.
  template <typename Complex, typename FaceIndex>
  std::vector<std::size_t> collect_arcs(const Complex& complex, FaceIndex face_index)
  {
    const auto& arcs = complex.arcs();
    m_arcs.clear();
    m_arc_ids.clear();
    m_arcs_by_face.clear();
    std::vector<std::size_t> number(arcs.size(), none);
    for(std::size_t a = 0; a < arcs.size(); ++a)
    {
      if(!complex.has_length(arcs[a]))
        continue;
      number[a] = m_arcs.size();
      const auto position = static_cast<std::ptrdiff_t>(m_arcs.size());
      // A new run begins where the face of the refined mesh changes, also if both are parts of one face of the user.
      if(m_arcs.empty() || arcs[a].face != arcs[m_arc_ids.back()].face)
        m_arcs_by_face.push_back(Run_of_arcs{face_index(arcs[a].face), position, position});
      m_arcs_by_face.back().last = position + 1;
      m_arcs.push_back(Arc(m_diagram, m_arcs.size()));
      m_arc_ids.push_back(a);
    }
    std::sort(m_arcs_by_face.begin(), m_arcs_by_face.end());
    return number;
  }

  // Makes an edge of each chain that has a length. The arcs of the edge that have no length are left out: the others
  // still follow each other, up to rounding. Requires: the arcs have been collected.
  template <typename Complex>
  void collect_edges(const Complex& complex, const std::vector<std::size_t>& number_of_arc)
  {
    const auto& chains = complex.chains();
    m_edges.clear();
    m_edge_arcs.clear();
    m_chain_ids.clear();
    m_edge_of_chain.assign(chains.size(), none);
    for(std::size_t c = 0; c < chains.size(); ++c)
    {
      if(!chains[c].has_length)
        continue;
      m_edge_of_chain[c] = m_edges.size();
      m_edges.push_back(Edge(m_diagram, m_edges.size()));
      m_chain_ids.push_back(c);
      m_edge_arcs.emplace_back();
      for(const std::pair<std::uint32_t, bool>& a : chains[c].arcs)
        if(number_of_arc[a.first] != none)
          m_edge_arcs.back().emplace_back(m_arcs[number_of_arc[a.first]], a.second);
    }
  }

  // Makes one vertex of all nodes that chains without length connect. Its node is the one with the smallest index; its
  // sites are those of all of them. Takes almost linear time. Nodes on the border of the mesh are not vertices; a chain
  // without length from such a node to a vertex unites nothing.
  template <typename Complex, typename SiteAt>
  void collect_vertices(const Complex& complex, SiteAt site_at)
  {
    const auto& nodes = complex.nodes();
    std::vector<std::size_t> rank(nodes.size()), parent(nodes.size());
    boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
    for(std::size_t n = 0; n < nodes.size(); ++n)
      sets.make_set(n);
    for(const auto& c : complex.chains())
      if(!c.has_length && nodes[c.first_node].is_vertex() && nodes[c.last_node].is_vertex())
        sets.union_set(c.first_node, c.last_node);
    m_vertices.clear();
    m_node_of_vertex.clear();
    m_vertex_sites.clear();
    m_vertex_of_node.assign(nodes.size(), none);
    for(std::size_t n = 0; n < nodes.size(); ++n)
    {
      if(!nodes[n].is_vertex())
        continue;
      std::size_t& v = m_vertex_of_node[sets.find_set(n)];
      if(v == none)
        v = add_vertex_at(n);
      for(const auto s : nodes[n].sites)
        m_vertex_sites[v].push_back(site_at(s));
      m_vertex_of_node[n] = v;
    }
    for(std::vector<std::size_t>& s : m_vertex_sites)
    {
      std::sort(s.begin(), s.end());
      s.erase(std::unique(s.begin(), s.end()), s.end());
    }
  }

  // Adds a vertex that stands at a node, and returns its number.
  std::size_t add_vertex_at(std::size_t node)
  {
    const std::size_t v = m_vertices.size();
    m_vertices.push_back(Vertex(m_diagram, v));
    m_node_of_vertex.push_back(node);
    m_vertex_sites.emplace_back();
    return v;
  }

  const Diagram* m_diagram;
  std::vector<Vertex> m_vertices;
  // By vertex, and by node of the complex: none if that is not a vertex.
  std::vector<std::size_t> m_node_of_vertex, m_vertex_of_node;
  std::vector<std::vector<std::size_t>> m_vertex_sites;
  std::vector<Arc> m_arcs;
  std::vector<std::size_t> m_arc_ids;                    // arcs of the complex, by number
  std::vector<Run_of_arcs> m_arcs_by_face;               // sorted
  std::vector<Edge> m_edges;
  std::vector<std::size_t> m_chain_ids, m_edge_of_chain; // chains of the complex
  std::vector<std::vector<Directed_arc>> m_edge_arcs;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_HANDLES_H
