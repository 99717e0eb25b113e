#ifndef SURFACE_MESH_GEODESICS_VORONOI_DISTANCE_CHECKS_H
#define SURFACE_MESH_GEODESICS_VORONOI_DISTANCE_CHECKS_H

// Checks a geodesic Voronoi diagram against the distances from one site at a time: which sites have cells, which site
// owns a random point, whether arcs and vertices are equidistant from the nearest sites, areas.

#include "Voronoi_sites.h"
#include "test_support.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test_meshes {

// Returns whether a site reaches a face.
inline bool is_reached(const Mesh& tm, const Voronoi& diagram, face_descriptor f)
{
  return diagram.nearest_site(corners_of_face(f, tm)[0]) != null_site;
}

class Voronoi_distance_checks
{
public:
  // `diagram` has the given sites, and uses `lengths` unless that is nullptr.
  Voronoi_distance_checks(const Mesh& tm, const Voronoi& diagram, const Weighted_sites& sites,
                          const Edge_lengths* lengths, bool compares_with_shortest_path)
    : m_tm(tm), m_diagram(diagram), m_sites(sites), m_lengths(lengths),
      m_distances(tm, sites, lengths, compares_with_shortest_path)
  {
    for(const Weighted_site& s : sites)
    {
      m_largest_weight = (std::max)(m_largest_weight, std::abs(s.weight));
    }
  }

  // Checks which sites have cells.
  void check_sites()
  {
    test_support::Scope scope("sites");
    CHECK_EQUAL(m_diagram.number_of_sites(), m_sites.size());
    for(std::size_t i = 0; i < m_sites.size(); ++i)
    {
      const Surface_point location = m_sites[i].point;
      const double own = -m_sites[i].weight, tolerance = 1e-10 * scale(i, location);
      double best = infinity;
      for(std::size_t j = 0; j < m_sites.size(); ++j)
      {
        best = j == i ? best : (std::min)(best, m_distances(j, location));
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

  // Checks the owner and the distance of random points and of all vertices.
  void check_points(test_support::Random& random, std::size_t number)
  {
    test_support::Scope scope("points");
    std::map<face_descriptor, std::vector<std::vector<double>>> seen; // the distances of all sites
    for(std::size_t k = 0; k < number; ++k)
    {
      const Surface_point p(random_location(m_tm, random, random.index(8) == 0 ? 1e-6 : 1e-3));
      seen[p.location.first].push_back(check_point(p));
    }
    for(const vertex_descriptor v : vertices(m_tm))
    {
      const std::vector<double> all = check_point(Surface_point(v));
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
        check_equidistant({a.sites().first, a.sites().second}, Surface_point(a.point(t)), a.distance(t));
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
      check_equidistant(v.sites(), Surface_point(v.location()), v.distance());
    }
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

  // Checks that the cells cover the part of the mesh that sites reach.
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
      expected += is_reached(m_tm, m_diagram, f) ? area_of_face(f) : 0.;
    }
    CHECK_CLOSE(sum, expected, 1e-10);
  }

  Distances_of_sites& distances() { return m_distances; }

private:

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

  // Returns the magnitude to which errors of the distance from site i are relative.
  double scale(std::size_t i, const Surface_point& p)
  {
    const double d = m_distances.without_weight(i, p);
    return (d < infinity ? d : 0.) + m_largest_weight
         + (p.is_vertex() ? 0. : size_of_face(p.location.first));
  }

  std::vector<double> check_point(const Surface_point& p)
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

  void check_equidistant(const std::vector<std::size_t>& sites, const Surface_point& p, double distance)
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

  // Checks that close to the middle of an arc, the left site is the nearer one on the left of the arc.
  void check_sides(const Voronoi::Arc& a)
  {
    const Coordinates p = a.point(.5).second, q = a.point(.5 + 1. / 64.).second, r = a.point(.5 - 1. / 64.).second;
    const double step = .05;
    // a quarter turn in the plane of two coordinates in which the face keeps its orientation
    const double dx = step * (q[1] - r[1]), dy = step * (q[2] - r[2]);
    for(const int side : {1, -1})
    {
      const Coordinates c{p[0] + side * (dy - dx), p[1] - side * dy, p[2] + side * dx};
      if(!(c[0] > 0. && c[1] > 0. && c[2] > 0.))
      {
        continue;
      }
      const Surface_point x(Face_location(a.face(), c));
      const double left = m_distances(a.sites().first, x), right = m_distances(a.sites().second, x);
      CHECK(side * (left - right) <= 1e-10 * scale(a.sites().first, x));
    }
  }

  const Mesh& m_tm;
  const Voronoi& m_diagram;
  Weighted_sites m_sites;
  const Edge_lengths* m_lengths;
  Distances_of_sites m_distances;
  double m_largest_weight = 0.;
};

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_VORONOI_DISTANCE_CHECKS_H
