#ifndef SURFACE_MESH_GEODESICS_LOCATION_NUMBERS_H
#define SURFACE_MESH_GEODESICS_LOCATION_NUMBERS_H

// Numbers for locations on a surface, equal if and only if the locations are equal up to rounding; and disjoint sets.

#include "Voronoi_sites.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test_meshes {

// Disjoint sets of elements. Joins sets step by step.
class Disjoint_sets
{
public:
  std::size_t add()
  {
    m_parent.push_back(m_parent.size());
    return m_parent.size() - 1;
  }

  std::size_t root(std::size_t i)
  {
    while(m_parent[i] != i)
    {
      i = m_parent[i] = m_parent[m_parent[i]];
    }
    return i;
  }

  void join(std::size_t i, std::size_t j) { m_parent[root(i)] = root(j); }

private:
  std::vector<std::size_t> m_parent;
};

// Numbers the locations on a surface. Locations that differ only by rounding get the same number.
// Requires: call add() for all locations, then number(), and only then the queries.
class Location_numbers
{
public:
  explicit Location_numbers(const Mesh& tm) : m_tm(tm)
  {
    for(const vertex_descriptor v : vertices(tm))
    {
      m_vertex[v] = m_size++;
    }
  }

  void add(const Face_location& l)
  {
    const Element e = element_of(l);
    if(e.dimension == 1)
    {
      m_on_edge[e.halfedge].emplace_back(e.t, 0);
    }
    else if(e.dimension == 2)
    {
      m_in_face[l.first].emplace_back(l.second, 0);
    }
  }

  void number()
  {
    for(auto& on_edge : m_on_edge)
    {
      std::sort(on_edge.second.begin(), on_edge.second.end());
      for(std::size_t i = 0; i < on_edge.second.size(); ++i)
      {
        const bool is_new = i == 0 || on_edge.second[i].first - on_edge.second[i - 1].first > tolerance();
        on_edge.second[i].second = is_new ? m_size++ : on_edge.second[i - 1].second;
      }
    }
    for(auto& in_face : m_in_face)
    {
      for(std::size_t i = 0; i < in_face.second.size(); ++i)
      {
        std::size_t j = 0;
        while(gap(in_face.second[i].first, in_face.second[j].first) > tolerance())
        {
          ++j;
        }
        in_face.second[i].second = j == i ? m_size++ : in_face.second[j].second;
      }
    }
    for(const vertex_descriptor v : vertices(m_tm))
    {
      if(CGAL::is_border(v, m_tm))
      {
        m_border.insert(m_vertex[v]);
      }
    }
    for(const auto& on_edge : m_on_edge)
    {
      if(is_border(m_tm.edge(on_edge.first), m_tm))
      {
        for(const auto& p : on_edge.second)
        {
          m_border.insert(p.second);
        }
      }
    }
  }

  std::size_t of(vertex_descriptor v) const { return m_vertex.at(v); }

  std::size_t of(const Face_location& l) const
  {
    const Element e = element_of(l);
    if(e.dimension == 0)
    {
      return m_vertex.at(e.vertex);
    }
    if(e.dimension == 1)
    {
      const auto& all = m_on_edge.at(e.halfedge);
      return nearest(all, [&](double t) { return std::abs(t - e.t); });
    }
    return nearest(m_in_face.at(l.first), [&](const Coordinates& b) { return gap(b, l.second); });
  }

  // Returns the halfedge of an edge from whose source the parameters along the edge are measured.
  static halfedge_descriptor first_of(halfedge_descriptor h, const Mesh& tm) { return (std::min)(h, opposite(h, tm)); }

  // Returns the locations between the ends of an edge, with their parameters.
  std::vector<std::pair<double, std::size_t>> on_edge(halfedge_descriptor h) const
  {
    const auto it = m_on_edge.find(first_of(h, m_tm));
    return it == m_on_edge.end() ? std::vector<std::pair<double, std::size_t>>() : it->second;
  }

  bool is_on_border(std::size_t location) const { return m_border.count(location) != 0; }
  std::size_t size() const { return m_size; }

private:
  struct Element
  {
    int dimension;
    vertex_descriptor vertex;
    halfedge_descriptor halfedge; // first_of() this edge
    double t;
  };

  static double tolerance() { return 1e-9; }

  static double gap(const Coordinates& a, const Coordinates& b)
  {
    return (std::max)({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
  }

  template <class Numbered, class Gap>
  static std::size_t nearest(const Numbered& all, const Gap& gap_of)
  {
    std::size_t best = 0;
    for(std::size_t i = 0; i < all.size(); ++i)
    {
      if(gap_of(all[i].first) < gap_of(all[best].first))
      {
        best = i;
      }
    }
    return all[best].second;
  }

  Element element_of(const Face_location& l) const
  {
    std::vector<halfedge_descriptor> sides;
    for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(l.first, m_tm), m_tm))
    {
      sides.push_back(h);
    }
    for(std::size_t k = 0; k < 3; ++k)
    {
      if(l.second[k] >= 1. - 2. * tolerance())
      {
        return Element{0, source(sides[k], m_tm), {}, 0.};
      }
    }
    for(std::size_t k = 0; k < 3; ++k)
    {
      if(l.second[(k + 2) % 3] <= tolerance())
      {
        const double t = l.second[(k + 1) % 3] / (l.second[k] + l.second[(k + 1) % 3]);
        const halfedge_descriptor h = first_of(sides[k], m_tm);
        return Element{1, {}, h, h == sides[k] ? t : 1. - t};
      }
    }
    return Element{2, {}, {}, 0.};
  }

  const Mesh& m_tm;
  std::map<vertex_descriptor, std::size_t> m_vertex;
  std::map<halfedge_descriptor, std::vector<std::pair<double, std::size_t>>> m_on_edge; // keys: first_of() the edge
  std::map<face_descriptor, std::vector<std::pair<Coordinates, std::size_t>>> m_in_face;
  std::set<std::size_t> m_border;
  std::size_t m_size = 0;
};

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_LOCATION_NUMBERS_H
