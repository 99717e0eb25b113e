#ifndef SURFACE_MESH_GEODESICS_VORONOI_STRUCTURE_CHECKS_H
#define SURFACE_MESH_GEODESICS_VORONOI_STRUCTURE_CHECKS_H

// Checks the combinatorics of a geodesic Voronoi diagram: how arcs, edges, vertices and boundaries are connected, that
// cells are connected, and Euler's formula.

#include "Voronoi_distance_checks.h"
#include "location_numbers.h"
#include "test_support.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

class Voronoi_structure_checks
{
public:
  Voronoi_structure_checks(const Mesh& tm, const Voronoi& diagram, const Weighted_sites& sites)
    : m_tm(tm), m_diagram(diagram), m_sites(sites), m_numbers(tm)
  {}

  // Checks that no two vertices have the same location: where more than three cells meet, there is a single vertex.
  void check_locations_of_vertices()
  {
    number_locations();
    std::map<std::size_t, std::size_t> first_at; // the first vertex at each location
    for(const Voronoi::Vertex& v : m_diagram.vertices())
    {
      const auto inserted = first_at.insert({m_numbers.of(v.location()), v.index()});
      test_support::Scope scope("vertices " + std::to_string(inserted.first->second) + " and "
                                + std::to_string(v.index()) + " at " + description(Surface_point(v.location())));
      CHECK(inserted.second);
    }
  }

  // Checks that each edge is a chain of arcs, and that each arc is in exactly one edge.
  void check_edges()
  {
    test_support::Scope scope("edges");
    std::set<std::size_t> used;
    for(const Voronoi::Edge& e : m_diagram.edges())
    {
      CHECK(!e.arcs().empty());
      double sum = 0.;
      for(std::size_t k = 0; k < e.arcs().size(); ++k)
      {
        const auto& a = e.arcs()[k];
        CHECK(used.insert(a.first.index()).second);
        sum += a.first.length();
        const auto sites = a.first.sites();
        CHECK(e.sites() == (a.second ? std::make_pair(sites.second, sites.first) : sites));
        if(k > 0)
        {
          check_same_location(end_of(e.arcs()[k - 1]), start_of(a));
        }
      }
      CHECK_CLOSE(e.length(), sum, 1e-13);
      if(e.is_closed())
      {
        check_same_location(end_of(e.arcs().back()), start_of(e.arcs().front()));
      }
      check_end(e.source_vertex(), start_of(e), e.is_closed());
      check_end(e.target_vertex(), end_of(e), e.is_closed());
    }
    CHECK_EQUAL(used.size(), m_diagram.arcs().size());
  }

  // Checks that each boundary is a chain of edges with the cell on the left, and that each edge is in two boundaries.
  void check_boundaries()
  {
    test_support::Scope scope("boundaries");
    std::map<std::size_t, std::array<int, 2>> uses;
    double sum = 0., expected = 0.;
    for(std::size_t i = 0; i < m_sites.size(); ++i)
    {
      for(const Voronoi::Boundary& b : m_diagram.boundary(i))
      {
        if(!CHECK(!b.edges.empty()))
        {
          continue;
        }
        sum += check_boundary(i, b, uses);
      }
      for(const std::size_t j : m_diagram.adjacent_sites(i))
      {
        const std::vector<std::size_t> back = m_diagram.adjacent_sites(j);
        CHECK(j != i && std::binary_search(back.begin(), back.end(), i));
      }
    }
    for(const Voronoi::Edge& e : m_diagram.edges())
    {
      expected += 2. * e.length();
      CHECK((uses[e.index()] == std::array<int, 2>{1, 1}));
    }
    CHECK_CLOSE(sum, expected, 1e-12);
  }

  // Checks the locations where arcs end. In the interior of the mesh, each cell has an even number of sides there. If
  // three cells meet, the diagram has a vertex there.
  void check_joints()
  {
    test_support::Scope scope("joints");
    number_locations();
    std::map<std::size_t, std::map<std::size_t, int>> sides; // by location, then by site
    for(const Voronoi::Arc& a : m_diagram.arcs())
    {
      const std::size_t first = m_numbers.of(a.point(0.)), last = m_numbers.of(a.point(1.));
      for(const std::size_t location : {first, last})
      {
        if(first != last)
        {
          ++sides[location][a.sites().first];
          ++sides[location][a.sites().second];
        }
      }
    }
    std::map<std::size_t, std::set<std::size_t>> at_vertices;
    for(const Voronoi::Vertex& v : m_diagram.vertices())
    {
      at_vertices[m_numbers.of(v.location())].insert(v.sites().begin(), v.sites().end());
    }
    for(const auto& at_location : sides)
    {
      for(const auto& s : at_location.second)
      {
        CHECK(s.second % 2 == 0 || m_numbers.is_on_border(at_location.first));
      }
      // cells that touch themselves or the border there need no vertex
      const bool is_simple = std::all_of(at_location.second.begin(), at_location.second.end(),
                                         [](const std::pair<const std::size_t, int>& s) { return s.second == 2; });
      if(at_location.second.size() >= 3 && is_simple && !m_numbers.is_on_border(at_location.first))
      {
        const std::set<std::size_t>& known = at_vertices[at_location.first];
        for(const auto& s : at_location.second)
        {
          CHECK(known.count(s.first) != 0);
        }
      }
    }
  }

  // Checks that each cell is connected, by its vertices, its parts of edges and its sides of arcs.
  void check_connected_cells()
  {
    test_support::Scope scope("connected cells");
    number_locations();
    Disjoint_sets sets;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> element; // by site and location
    const auto at = [&](std::size_t site, std::size_t location)
    {
      const auto found = element.find({site, location});
      return found != element.end() ? found->second : (element[{site, location}] = sets.add());
    };
    for(const vertex_descriptor v : vertices(m_tm))
    {
      at(m_diagram.nearest_site(v), m_numbers.of(v));
    }
    for(const Voronoi::Arc& a : m_diagram.arcs())
    {
      for(const std::size_t site : {a.sites().first, a.sites().second})
      {
        sets.join(at(site, m_numbers.of(a.point(0.))), at(site, m_numbers.of(a.point(1.))));
      }
    }
    join_parts_of_edges([&](std::size_t site, std::size_t p, std::size_t q) { sets.join(at(site, p), at(site, q)); });
    join_islands([&](std::size_t site, std::size_t p, std::size_t q) { sets.join(at(site, p), at(site, q)); });
    std::map<std::size_t, std::set<std::size_t>> pieces;
    for(const auto& e : element)
    {
      pieces[e.first.first].insert(sets.root(e.second));
    }
    for(const auto& p : pieces)
    {
      if(p.first != null_site)
      {
        test_support::Scope scope_of_site("site " + std::to_string(p.first));
        CHECK_EQUAL(p.second.size(), 1u);
        CHECK(!m_diagram.is_empty(p.first));
      }
    }
  }

  // Checks that in each component the Euler characteristics of cells, edges and vertices add up to that of the part
  // that sites reach.
  void check_Euler()
  {
    test_support::Scope scope("Euler's formula");
    Disjoint_sets components; // of the mesh, as sets of location numbers of vertices
    for(std::size_t i = 0; i < num_vertices(m_tm); ++i)
    {
      components.add();
    }
    for(const Mesh::Edge_index e : edges(m_tm))
    {
      const halfedge_descriptor h = halfedge(e, m_tm);
      components.join(m_numbers.of(source(h, m_tm)), m_numbers.of(target(h, m_tm)));
    }
    const auto component_of = [&](const Surface_point& p)
    { return components.root(m_numbers.of(p.is_vertex() ? p.vertex : corners_of_face(p.location.first, m_tm)[0])); };
    std::map<std::size_t, long> sums = characteristics_of_diagram(component_of);
    for(const auto& of_component : characteristics_of_mesh(component_of))
    {
      CHECK_EQUAL(sums[of_component.first], of_component.second);
    }
    for(std::size_t i = 0; i < m_sites.size(); ++i)
    {
      // A cell with the characteristic 1 may still touch itself at a point.
      CHECK(!m_diagram.is_disk(i) || m_diagram.Euler_characteristic(i) == 1);
    }
  }

private:

  // Checks one part of the boundary of cell i, counts how its edges are used, and returns its length.
  double check_boundary(std::size_t i, const Voronoi::Boundary& b, std::map<std::size_t, std::array<int, 2>>& uses)
  {
    double sum = 0.;
    for(std::size_t k = 0; k < b.edges.size(); ++k)
    {
      const auto& e = b.edges[k];
      ++uses[e.first.index()][e.second ? 1 : 0];
      sum += e.first.length();
      const auto sites = e.first.sites();
      CHECK_EQUAL(e.second ? sites.second : sites.first, i);
      if(k > 0)
      {
        check_same_location(end_of(b.edges[k - 1]), start_of(e));
      }
    }
    const Face_location first = start_of(b.edges.front()), last = end_of(b.edges.back());
    if(b.is_closed)
    {
      check_same_location(first, last);
    }
    else
    {
      CHECK(is_on_border(first));
      CHECK(is_on_border(last));
    }
    return sum;
  }

  // Is the segment from an arc to a corner of its face in the cell of a site?
  bool is_way_in_cell(const Face_location& from, std::size_t corner, std::size_t site) const
  {
    const int n = 64;
    for(int i = 1; i <= n; ++i)
    {
      Face_location q = from;
      for(std::size_t k = 0; k < 3; ++k)
      {
        q.second[k] += ((k == corner ? 1. : 0.) - q.second[k]) * i / n;
      }
      if(m_diagram.nearest_site(q) != site)
      {
        return false;
      }
    }
    return true;
  }

  // Calls join(site, location of an arc, location of a corner) for each edge that is a closed curve inside a face. Only
  // the cell itself connects such an edge with the rest of the surface.
  template <class Join>
  void join_islands(const Join& join)
  {
    for(const Voronoi::Edge& e : m_diagram.edges())
    {
      for(const auto& a : e.arcs())
      {
        if(!e.is_closed())
        {
          break;
        }
        const Face_location p = a.first.point(0.);
        for(std::size_t k = 0; k < 3; ++k)
        {
          Face_location corner = p;
          corner.second = {k == 0 ? 1. : 0., k == 1 ? 1. : 0., k == 2 ? 1. : 0.};
          for(const std::size_t site : {e.sites().first, e.sites().second})
          {
            if(is_way_in_cell(p, k, site))
            {
              join(site, m_numbers.of(p), m_numbers.of(corner));
            }
          }
        }
      }
    }
  }

  // Calls join(site, location, location) for the two ends of each part of an edge of the mesh in one cell.
  template <class Join>
  void join_parts_of_edges(const Join& join)
  {
    for(const Mesh::Edge_index e : edges(m_tm))
    {
      const halfedge_descriptor h = Location_numbers::first_of(halfedge(e, m_tm), m_tm);
      double from = 0.;
      std::size_t before = m_numbers.of(source(h, m_tm));
      std::vector<std::pair<double, std::size_t>> all = m_numbers.on_edge(h);
      all.emplace_back(1., m_numbers.of(target(h, m_tm)));
      for(const auto& p : all)
      {
        if(p.second != before)
        {
          const double t = (from + p.first) / 2.;
          const Face_location middle = is_border(h, m_tm) ? location_on_halfedge(opposite(h, m_tm), 1. - t, m_tm)
                                                          : location_on_halfedge(h, t, m_tm);
          const std::size_t site = m_diagram.nearest_site(middle);
          join(site, before, p.second);
        }
        from = p.first;
        before = p.second;
      }
    }
  }

  // Returns the Euler characteristic of the part that sites reach, by component.
  template <class Component_of>
  std::map<std::size_t, long> characteristics_of_mesh(const Component_of& component_of) const
  {
    std::map<std::size_t, long> result;
    for(const vertex_descriptor v : vertices(m_tm))
    {
      result[component_of(v)] += m_diagram.nearest_site(v) != null_site ? 1 : 0;
    }
    for(const Mesh::Edge_index e : edges(m_tm))
    {
      const vertex_descriptor v = source(halfedge(e, m_tm), m_tm);
      result[component_of(v)] -= m_diagram.nearest_site(v) != null_site ? 1 : 0;
    }
    for(const face_descriptor f : faces(m_tm))
    {
      result[component_of(corners_of_face(f, m_tm)[0])] += is_reached(m_tm, m_diagram, f) ? 1 : 0;
    }
    return result;
  }

  // Returns the same from cells, edges and vertices of the diagram.
  template <class Component_of>
  std::map<std::size_t, long> characteristics_of_diagram(const Component_of& component_of) const
  {
    std::map<std::size_t, long> result;
    for(const Voronoi::Vertex& v : m_diagram.vertices())
    {
      ++result[component_of(v.location())];
    }
    for(const Voronoi::Edge& e : m_diagram.edges())
    {
      if(!e.is_closed())
      {
        result[component_of(start_of(e))]
          += (e.source_vertex() == null_site ? 1 : 0) + (e.target_vertex() == null_site ? 1 : 0) - 1;
      }
    }
    for(std::size_t i = 0; i < m_sites.size(); ++i)
    {
      long& sum = result[component_of(m_sites[i].point)];
      sum += m_diagram.Euler_characteristic(i);
      for(const Voronoi::Boundary& b : m_diagram.boundary(i))
      {
        sum -= b.is_closed ? 0 : 1;
      }
    }
    return result;
  }

  static Face_location start_of(const std::pair<Voronoi::Arc, bool>& a) { return a.first.point(a.second ? 1. : 0.); }
  static Face_location end_of(const std::pair<Voronoi::Arc, bool>& a) { return a.first.point(a.second ? 0. : 1.); }
  static Face_location start_of(const Voronoi::Edge& e) { return start_of(e.arcs().front()); }
  static Face_location end_of(const Voronoi::Edge& e) { return end_of(e.arcs().back()); }

  static Face_location start_of(const std::pair<Voronoi::Edge, bool>& e)
  {
    return e.second ? end_of(e.first) : start_of(e.first);
  }

  static Face_location end_of(const std::pair<Voronoi::Edge, bool>& e)
  {
    return e.second ? start_of(e.first) : end_of(e.first);
  }

  void number_locations()
  {
    if(m_has_numbers)
    {
      return;
    }
    m_has_numbers = true;
    for(const Voronoi::Arc& a : m_diagram.arcs())
    {
      m_numbers.add(a.point(0.));
      m_numbers.add(a.point(1.));
    }
    for(const Voronoi::Vertex& v : m_diagram.vertices())
    {
      m_numbers.add(v.location());
    }
    m_numbers.number();
  }

  void check_same_location(const Face_location& a, const Face_location& b)
  {
    number_locations();
    test_support::Scope scope(description(Surface_point(a)) + " and " + description(Surface_point(b)));
    CHECK_EQUAL(m_numbers.of(a), m_numbers.of(b));
  }

  bool is_on_border(const Face_location& l)
  {
    number_locations();
    return m_numbers.is_on_border(m_numbers.of(l));
  }

  void check_end(std::size_t v, const Face_location& l, bool is_closed)
  {
    if(v != null_site)
    {
      CHECK(v < m_diagram.vertices().size() && !is_closed);
      check_same_location(m_diagram.vertices()[v].location(), l);
    }
    else
    {
      CHECK(is_closed || is_on_border(l));
    }
  }

  const Mesh& m_tm;
  const Voronoi& m_diagram;
  Weighted_sites m_sites;
  Location_numbers m_numbers;
  bool m_has_numbers = false;
};

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_VORONOI_STRUCTURE_CHECKS_H
