#ifndef SURFACE_MESH_GEODESICS_VORONOI_TEST_HELPERS_H
#define SURFACE_MESH_GEODESICS_VORONOI_TEST_HELPERS_H

// Checks a geodesic Voronoi diagram against distances from one site at a time, and its combinatorics by itself: what
// is equidistant and nearest, who owns random points, areas, how arcs, edges and boundaries hang together, Euler's
// formula, connected cells.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Paths_traits>;
using Shortest_path = CGAL::Surface_mesh_shortest_path<Paths_traits>;
using halfedge_descriptor = boost::graph_traits<Mesh>::halfedge_descriptor;
using Edge_lengths = Mesh::Property_map<Mesh::Edge_index, double>;

const std::size_t null_site = Voronoi::null_site();

struct Weighted_site
{
  Place place;
  double weight = 0.;

  Weighted_site(const Place& p, double w = 0.) : place(p), weight(w) {}
  Weighted_site(vertex_descriptor v, double w = 0.) : place(v), weight(w) {}
  Weighted_site(const Face_location& l, double w = 0.) : place(l), weight(w) {}
};

using Weighted_sites = std::vector<Weighted_site>;

template <typename Diagram>
void add_sites(Diagram& diagram, const Weighted_sites& sites)
{
  for(const Weighted_site& s : sites)
  {
    if(s.place.is_vertex())
    {
      diagram.add_site(s.place.vertex, s.weight);
    }
    else
    {
      diagram.add_site(s.place.location, s.weight);
    }
  }
}

inline double area_of_face(const Mesh& tm, face_descriptor f)
{
  const auto corner = corners_of_face(f, tm);
  const Coordinates p = coordinates(corner[0], tm);
  return length(cross(coordinates(corner[1], tm) - p, coordinates(corner[2], tm) - p)) / 2.;
}

// The distances from each site alone, less its weight: by Surface_mesh_geodesic_paths, and for sites at vertices by
// Surface_mesh_shortest_path as well, if that is wanted.
class Distances_of_sites
{
public:
  Distances_of_sites(const Mesh& tm, const Weighted_sites& sites, const Edge_lengths* lengths = nullptr,
                     bool compares_with_shortest_path = false)
    : m_sites(sites)
  {
    for(const Weighted_site& s : sites)
    {
      m_paths.push_back(std::make_unique<Geodesic_paths>(tm));
      if(lengths != nullptr)
      {
        m_paths.back()->use_edge_lengths(*lengths);
      }
      add(*m_paths.back(), s.place);
      m_paths.back()->build_sequence_tree_for_faces();
      m_originals.emplace_back();
      if(compares_with_shortest_path && s.place.is_vertex())
      {
        m_originals.back() = std::make_unique<Shortest_path>(tm);
        m_originals.back()->add_source_point(s.place.vertex);
      }
    }
  }

  // infinity where the site does not reach
  double without_weight(std::size_t i, const Place& q)
  {
    const Geodesic_paths& paths = *m_paths[i];
    const double d = ask(paths, q).distance;
    if(m_originals[i] != nullptr && is_safe(q))
    {
      const double expected = ask(*m_originals[i], q).distance;
      ++m_number_of_comparisons;
      CHECK_NEAR(d, expected, 1e-11 * (std::max)(d, expected));
    }
    return d < 0. ? infinity : d;
  }

  double operator()(std::size_t i, const Place& q) { return without_weight(i, q) - m_sites[i].weight; }

  std::vector<double> all(const Place& q)
  {
    std::vector<double> result;
    for(std::size_t i = 0; i < m_paths.size(); ++i)
    {
      result.push_back((*this)(i, q));
    }
    return result;
  }

  std::size_t number_of_comparisons() const { return m_number_of_comparisons; }

private:
  // Surface_mesh_shortest_path errs at places that are on an edge up to rounding.
  static bool is_safe(const Place& q)
  {
    const auto& b = q.location.second;
    return q.is_vertex() || (std::min)({b[0], b[1], b[2]}) > 1e-5;
  }

  Weighted_sites m_sites;
  std::vector<std::unique_ptr<Geodesic_paths>> m_paths;
  std::vector<std::unique_ptr<Shortest_path>> m_originals;
  std::size_t m_number_of_comparisons = 0;
};

// Sets of elements that are joined step by step.
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

// Numbers for places on the surface; places that differ by rounding only have the same one. Places are added first.
class Place_numbers
{
public:
  explicit Place_numbers(const Mesh& tm) : m_tm(tm)
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

  // the one of the two halfedges of an edge whose source the parameters on the edge are counted from
  static halfedge_descriptor first_of(halfedge_descriptor h, const Mesh& tm) { return (std::min)(h, opposite(h, tm)); }

  // the places on an edge between its ends, with their parameters
  std::vector<std::pair<double, std::size_t>> on_edge(halfedge_descriptor h) const
  {
    const auto it = m_on_edge.find(first_of(h, m_tm));
    return it == m_on_edge.end() ? std::vector<std::pair<double, std::size_t>>() : it->second;
  }

  bool is_on_border(std::size_t place) const { return m_border.count(place) != 0; }
  std::size_t size() const { return m_size; }

private:
  struct Element
  {
    int dimension;
    vertex_descriptor vertex;
    halfedge_descriptor halfedge; // first_of() the edge
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
  std::map<halfedge_descriptor, std::vector<std::pair<double, std::size_t>>> m_on_edge; // the key is `first_of` it
  std::map<face_descriptor, std::vector<std::pair<Coordinates, std::size_t>>> m_in_face;
  std::set<std::size_t> m_border;
  std::size_t m_size = 0;
};

class Voronoi_validator
{
public:
  // `diagram` has the sites given. If there are `lengths`, it uses them.
  Voronoi_validator(const Mesh& tm, const Voronoi& diagram, const Weighted_sites& sites,
                    const Edge_lengths* lengths = nullptr, bool compares_with_shortest_path = false)
    : m_tm(tm), m_diagram(diagram), m_sites(sites), m_lengths(lengths),
      m_distances(tm, sites, lengths, compares_with_shortest_path), m_numbers(tm)
  {
    for(const Weighted_site& s : sites)
    {
      m_largest_weight = (std::max)(m_largest_weight, std::abs(s.weight));
    }
  }

  void check_all(test_support::Random& random, std::size_t number_of_points)
  {
    check_sites();
    check_points(random, number_of_points);
    check_arcs();
    check_vertices();
    check_edges();
    check_boundaries();
    check_areas();
    check_joints();
    check_connected_cells();
    check_Euler();
  }

  // Who has a cell?
  void check_sites()
  {
    test_support::Scope scope("sites");
    CHECK_EQUAL(m_diagram.number_of_sites(), m_sites.size());
    for(std::size_t i = 0; i < m_sites.size(); ++i)
    {
      const Place place = place_of(i);
      const double own = -m_sites[i].weight, tolerance = 1e-10 * scale(i, place);
      double best = infinity;
      for(std::size_t j = 0; j < m_sites.size(); ++j)
      {
        best = j == i ? best : (std::min)(best, m_distances(j, place));
      }
      if(best < own - tolerance)
      {
        CHECK(m_diagram.is_empty(i));
      }
      else if(best > own + tolerance)
      {
        CHECK(!m_diagram.is_empty(i));
      }
      if(m_diagram.is_empty(i))
      {
        CHECK_EQUAL(m_diagram.area(i), 0.);
        CHECK_EQUAL(m_diagram.Euler_characteristic(i), 0);
        CHECK(m_diagram.boundary(i).empty());
        CHECK(m_diagram.adjacent_sites(i).empty());
      }
    }
  }

  // Random points and all vertices: who owns them, and how far it is.
  void check_points(test_support::Random& random, std::size_t number)
  {
    test_support::Scope scope("points");
    std::map<face_descriptor, std::vector<std::vector<double>>> seen; // the distances of all sites
    for(std::size_t k = 0; k < number; ++k)
    {
      const Place p(random_location(m_tm, random, random.index(8) == 0 ? 1e-6 : 1e-3));
      seen[p.location.first].push_back(check_point(p));
    }
    for(const vertex_descriptor v : vertices(m_tm))
    {
      const std::vector<double> all = check_point(Place(v));
      for(const face_descriptor f : faces_around(v, m_tm))
      {
        seen[f].push_back(all);
      }
    }
    for(const auto& in_face : seen)
    {
      if(have_two_owners(in_face.second, 1e-8 * (size_of_face(in_face.first) + m_largest_weight)))
      {
        CHECK(!m_diagram.arcs(in_face.first).empty());
      }
    }
  }

  void check_arcs()
  {
    test_support::Scope scope("arcs");
    std::set<std::size_t> in_faces;
    for(const face_descriptor f : faces(m_tm))
    {
      for(const Voronoi::Arc& a : m_diagram.arcs(f))
      {
        CHECK(a.face() == f);
        CHECK(in_faces.insert(a.index()).second);
      }
    }
    CHECK_EQUAL(in_faces.size(), m_diagram.arcs().size());
    for(const Voronoi::Arc& a : m_diagram.arcs())
    {
      CHECK(a.sites().first != a.sites().second);
      for(const double t : {0., .25, .5, 1.})
      {
        check_equidistant({a.sites().first, a.sites().second}, Place(a.point(t)), a.distance(t));
      }
      check_sides(a);
    }
  }

  void check_vertices()
  {
    test_support::Scope scope("vertices");
    for(const Voronoi::Vertex& v : m_diagram.vertices())
    {
      CHECK(v.sites().size() >= 3);
      CHECK(std::is_sorted(v.sites().begin(), v.sites().end()));
      check_equidistant(v.sites(), Place(v.location()), v.distance());
    }
    check_places_of_vertices();
    std::vector<std::array<std::size_t, 3>> triangles;
    m_diagram.dual(std::back_inserter(triangles));
    for(const std::array<std::size_t, 3>& t : triangles)
    {
      CHECK(std::any_of(m_diagram.vertices().begin(), m_diagram.vertices().end(), [&](const Voronoi::Vertex& v)
      {
        return std::all_of(t.begin(), t.end(), [&](std::size_t s)
        { return std::binary_search(v.sites().begin(), v.sites().end(), s); });
      }));
    }
  }

  // Where more than three cells meet is one vertex: no two of them are at one place.
  void check_places_of_vertices()
  {
    number_places();
    std::map<std::size_t, std::size_t> first_at; // of a place
    for(const Voronoi::Vertex& v : m_diagram.vertices())
    {
      const auto inserted = first_at.insert({m_numbers.of(v.location()), v.index()});
      test_support::Scope scope("vertices " + std::to_string(inserted.first->second) + " and "
                                + std::to_string(v.index()) + " at " + description(Place(v.location())));
      CHECK(inserted.second);
    }
  }

  // Edges are arcs one behind the other, and each arc is in one of them.
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
          check_same_place(end_of(e.arcs()[k - 1]), start_of(a));
        }
      }
      CHECK_CLOSE(e.length(), sum, 1e-13);
      if(e.is_closed())
      {
        check_same_place(end_of(e.arcs().back()), start_of(e.arcs().front()));
      }
      check_end(e.source_vertex(), start_of(e), e.is_closed());
      check_end(e.target_vertex(), end_of(e), e.is_closed());
    }
    CHECK_EQUAL(used.size(), m_diagram.arcs().size());
  }

  // Boundaries are edges one behind the other with the cell on the left; each edge is in two of them.
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
        for(std::size_t k = 0; k < b.edges.size(); ++k)
        {
          const auto& e = b.edges[k];
          ++uses[e.first.index()][e.second ? 1 : 0];
          sum += e.first.length();
          const auto sites = e.first.sites();
          CHECK_EQUAL(e.second ? sites.second : sites.first, i);
          if(k > 0)
          {
            check_same_place(end_of(b.edges[k - 1]), start_of(e));
          }
        }
        const Face_location first = start_of(b.edges.front()), last = end_of(b.edges.back());
        if(b.is_closed)
        {
          check_same_place(first, last);
        }
        else
        {
          CHECK(is_on_border(first));
          CHECK(is_on_border(last));
        }
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

  // The cells cover what is reached.
  void check_areas()
  {
    test_support::Scope scope("areas");
    double sum = 0., expected = 0.;
    for(std::size_t i = 0; i < m_sites.size(); ++i)
    {
      const double area = m_diagram.area(i);
      CHECK(area >= -1e-12 * expected);
      sum += area;
    }
    for(const face_descriptor f : faces(m_tm))
    {
      expected += is_reached(f) ? area_of_face(f) : 0.;
    }
    CHECK_CLOSE(sum, expected, 1e-10);
  }

  // Around each place where arcs end, cells alternate: in the interior each one has an even number of sides there.
  // Where three cells meet is a vertex of the diagram.
  void check_joints()
  {
    test_support::Scope scope("joints");
    number_places();
    std::map<std::size_t, std::map<std::size_t, int>> sides; // of a place, of a site
    for(const Voronoi::Arc& a : m_diagram.arcs())
    {
      const std::size_t first = m_numbers.of(a.point(0.)), last = m_numbers.of(a.point(1.));
      for(const std::size_t place : {first, last})
      {
        if(first != last)
        {
          ++sides[place][a.sites().first];
          ++sides[place][a.sites().second];
        }
      }
    }
    std::map<std::size_t, std::set<std::size_t>> at_vertices;
    for(const Voronoi::Vertex& v : m_diagram.vertices())
    {
      at_vertices[m_numbers.of(v.location())].insert(v.sites().begin(), v.sites().end());
    }
    for(const auto& at_place : sides)
    {
      for(const auto& s : at_place.second)
      {
        CHECK(s.second % 2 == 0 || m_numbers.is_on_border(at_place.first));
      }
      // (cells that touch themselves or the border there need none)
      const bool is_simple = std::all_of(at_place.second.begin(), at_place.second.end(),
                                         [](const std::pair<const std::size_t, int>& s) { return s.second == 2; });
      if(at_place.second.size() >= 3 && is_simple && !m_numbers.is_on_border(at_place.first))
      {
        const std::set<std::size_t>& known = at_vertices[at_place.first];
        for(const auto& s : at_place.second)
        {
          CHECK(known.count(s.first) != 0);
        }
      }
    }
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

  // calls join(site, place of an arc, place of a corner) for edges that are closed inside of a face: on the surface
  // nothing but the cell itself joins them to the rest.
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

  // Each cell is in one piece: its vertices, its parts of edges and its sides of arcs hang together.
  void check_connected_cells()
  {
    test_support::Scope scope("connected cells");
    number_places();
    Disjoint_sets sets;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> element; // of a site at a place
    const auto at = [&](std::size_t site, std::size_t place)
    {
      const auto found = element.find({site, place});
      return found != element.end() ? found->second : (element[{site, place}] = sets.add());
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
    for(const Mesh::Edge_index e : edges(m_tm))
    {
      const halfedge_descriptor h = Place_numbers::first_of(halfedge(e, m_tm), m_tm);
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
          sets.join(at(site, before), at(site, p.second));
        }
        from = p.first;
        before = p.second;
      }
    }
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

  // The cells without the curves, and the curves, add up to what is reached, in each component of the mesh.
  void check_Euler()
  {
    test_support::Scope scope("Euler's formula");
    Disjoint_sets components; // of the vertices, by the numbers of their places
    for(std::size_t i = 0; i < num_vertices(m_tm); ++i)
    {
      components.add();
    }
    for(const Mesh::Edge_index e : edges(m_tm))
    {
      const halfedge_descriptor h = halfedge(e, m_tm);
      components.join(m_numbers.of(source(h, m_tm)), m_numbers.of(target(h, m_tm)));
    }
    const auto component_of = [&](const Place& p)
    { return components.root(m_numbers.of(p.is_vertex() ? p.vertex : corners_of_face(p.location.first, m_tm)[0])); };
    std::map<std::size_t, long> sums = characteristics_of_diagram(component_of);
    for(const auto& of_component : characteristics_of_mesh(component_of))
    {
      CHECK_EQUAL(sums[of_component.first], of_component.second);
    }
    for(std::size_t i = 0; i < m_sites.size(); ++i)
    {
      CHECK_EQUAL(m_diagram.is_disk(i), m_diagram.Euler_characteristic(i) == 1);
    }
  }

  Distances_of_sites& distances() { return m_distances; }

private:
  Place place_of(std::size_t i) const { return m_sites[i].place; }

  // Euler's characteristic of what is reached, by component
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
      result[component_of(corners_of_face(f, m_tm)[0])] += is_reached(f) ? 1 : 0;
    }
    return result;
  }

  // the same from cells, edges and vertices of the diagram
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
      long& sum = result[component_of(place_of(i))];
      sum += m_diagram.Euler_characteristic(i);
      for(const Voronoi::Boundary& b : m_diagram.boundary(i))
      {
        sum -= b.is_closed ? 0 : 1;
      }
    }
    return result;
  }

  double length_of_edge(halfedge_descriptor h) const
  {
    return m_lengths != nullptr ? (*m_lengths)[m_tm.edge(h)]
                                : length(coordinates(source(h, m_tm), m_tm) - coordinates(target(h, m_tm), m_tm));
  }

  double size_of_face(face_descriptor f) const
  {
    double size = 0.;
    for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_tm), m_tm))
    {
      size = (std::max)(size, length_of_edge(h));
    }
    return size;
  }

  double area_of_face(face_descriptor f) const
  {
    if(m_lengths == nullptr)
    {
      return test_meshes::area_of_face(m_tm, f);
    }
    const halfedge_descriptor h = halfedge(f, m_tm);
    const double a = length_of_edge(h), b = length_of_edge(next(h, m_tm)), c = length_of_edge(prev(h, m_tm));
    return std::sqrt((a + b + c) * (b + c - a) * (c + a - b) * (a + b - c)) / 4.;
  }

  bool is_reached(face_descriptor f) const
  {
    return m_diagram.nearest_site(corners_of_face(f, m_tm)[0]) != null_site;
  }

  // what errors of the distance of site i are to be compared with
  double scale(std::size_t i, const Place& p)
  {
    const double d = m_distances.without_weight(i, p);
    return (d < infinity ? d : 0.) + m_largest_weight
         + (p.is_vertex() ? 0. : size_of_face(p.location.first));
  }

  std::vector<double> check_point(const Place& p)
  {
    const std::vector<double> all = m_distances.all(p);
    const double best = all.empty() ? infinity : *std::min_element(all.begin(), all.end());
    const std::size_t owner
      = p.is_vertex() ? m_diagram.nearest_site(p.vertex) : m_diagram.nearest_site(p.location);
    const double d = p.is_vertex() ? m_diagram.distance_to_nearest_site(p.vertex)
                                   : m_diagram.distance_to_nearest_site(p.location);
    test_support::Scope scope(description(p));
    if(best == infinity)
    {
      CHECK_EQUAL(owner, null_site);
      CHECK_EQUAL(d, -1.);
    }
    else if(CHECK(owner < m_sites.size()))
    {
      CHECK_NEAR(all[owner], best, 1e-10 * scale(owner, p));
      CHECK_NEAR(d, best, 1e-12 * scale(owner, p));
      CHECK(!m_diagram.is_empty(owner));
    }
    return all;
  }

  static bool have_two_owners(const std::vector<std::vector<double>>& distances, double margin)
  {
    std::set<std::size_t> owners;
    for(const std::vector<double>& all : distances)
    {
      for(std::size_t i = 0; i < all.size(); ++i)
      {
        bool is_owner = all[i] < infinity;
        for(std::size_t j = 0; j < all.size(); ++j)
        {
          is_owner = is_owner && (j == i || all[i] + margin + 1e-8 * std::abs(all[i]) < all[j]);
        }
        if(is_owner)
        {
          owners.insert(i);
        }
      }
    }
    return owners.size() >= 2;
  }

  void check_equidistant(const std::vector<std::size_t>& sites, const Place& p, double distance)
  {
    const std::vector<double> all = m_distances.all(p);
    const double best = *std::min_element(all.begin(), all.end());
    for(const std::size_t s : sites)
    {
      if(CHECK(s < m_sites.size()))
      {
        test_support::Scope scope("site " + std::to_string(s) + " at " + description(p));
        const double tolerance = 1e-10 * scale(s, p);
        CHECK_NEAR(all[s], best, tolerance);
        CHECK_NEAR(distance, best, tolerance);
      }
    }
  }

  // Near to the middle of an arc, the left site is the nearer one on the left of the arc.
  void check_sides(const Voronoi::Arc& a)
  {
    const Coordinates p = a.point(.5).second, q = a.point(.5 + 1. / 64.).second, r = a.point(.5 - 1. / 64.).second;
    const double step = .05;
    // a quarter turn in the plane of two of the coordinates, in which the face has its orientation
    const double dx = step * (q[1] - r[1]), dy = step * (q[2] - r[2]);
    for(const int side : {1, -1})
    {
      const Coordinates c{p[0] + side * (dy - dx), p[1] - side * dy, p[2] + side * dx};
      if(!(c[0] > 0. && c[1] > 0. && c[2] > 0.))
      {
        continue;
      }
      const Place x(Face_location(a.face(), c));
      const double left = m_distances(a.sites().first, x), right = m_distances(a.sites().second, x);
      CHECK(side * (left - right) <= 1e-10 * scale(a.sites().first, x));
    }
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

  void number_places()
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

  void check_same_place(const Face_location& a, const Face_location& b)
  {
    number_places();
    test_support::Scope scope(description(Place(a)) + " and " + description(Place(b)));
    CHECK_EQUAL(m_numbers.of(a), m_numbers.of(b));
  }

  bool is_on_border(const Face_location& l)
  {
    number_places();
    return m_numbers.is_on_border(m_numbers.of(l));
  }

  void check_end(std::size_t v, const Face_location& l, bool is_closed)
  {
    if(v != null_site)
    {
      CHECK(v < m_diagram.vertices().size() && !is_closed);
      check_same_place(m_diagram.vertices()[v].location(), l);
    }
    else
    {
      CHECK(is_closed || is_on_border(l));
    }
  }

  const Mesh& m_tm;
  const Voronoi& m_diagram;
  Weighted_sites m_sites;
  const Edge_lengths* m_lengths;
  Distances_of_sites m_distances;
  Place_numbers m_numbers;
  bool m_has_numbers = false;
  double m_largest_weight = 0.;
};

// Sites at vertices, on edges and in faces, in turn by chance.
inline Place random_place(const Mesh& tm, test_support::Random& random)
{
  const std::size_t kind = random.index(3);
  if(kind == 0)
  {
    return Place(random_vertex(tm, random));
  }
  Face_location l = random_location(tm, random);
  if(kind == 1)
  {
    const std::size_t k = random.index(3);
    l.second[k] = random.uniform(.05, .95);
    l.second[(k + 1) % 3] = 1. - l.second[k];
    l.second[(k + 2) % 3] = 0.;
  }
  return Place(l);
}

inline Weighted_sites random_sites(const Mesh& tm, std::size_t number, double largest_weight,
                                   test_support::Random& random)
{
  Weighted_sites sites;
  for(std::size_t i = 0; i < number; ++i)
  {
    const Place p = random_place(tm, random);
    sites.emplace_back(p, largest_weight == 0. ? 0. : random.uniform(-largest_weight, largest_weight));
  }
  return sites;
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_VORONOI_TEST_HELPERS_H
