// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DUAL_MESH_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DUAL_MESH_H

// The dual of a geodesic Voronoi diagram as a mesh: a triangle for each vertex of the diagram, with the sites as
// vertices. The triangles form a manifold of the topology of the surface only if the cells are small enough; Dual_check
// finds what is in the way.

#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Report` is Geodesic_dual_report, where the conditions are explained. If the cells are disks, and two or three of
// them meet in one piece at most, the dual is homeomorphic to the surface (Edelsbrunner and Shah, Triangulating
// topological spaces, 1997).
//
// report() takes four steps: check_triangles() counts what the others look up, check_cells() looks at each cell,
// check_edges() at each edge and check_vertices() at each vertex of the diagram. `Diagram` is the public class. It is
// referred to, and must outlive the object; cells are named by the numbers of their sites.
template <typename Diagram, typename Report>
class Dual_check
{
  using Pair = std::pair<std::size_t, std::size_t>;
  using Triple = std::array<std::size_t, 3>;

public:
  // Builds the diagram if that is not done. Throws what build() throws.
  explicit Dual_check(const Diagram& diagram) : m_diagram(diagram) { diagram.dual(std::back_inserter(m_triangles)); }

  const std::vector<Triple>& triangles() const { return m_triangles; }

  // Call it once. Takes O(k log k) time for k arcs and edges of the diagram.
  Report report()
  {
    Report r;
    check_triangles(r);
    check_cells(r);
    check_edges(r);
    check_vertices(r);
    // CGAL takes no triangles at all for a polygon mesh; the dual of a diagram without vertices is not one.
    r.is_polygon_mesh = !m_triangles.empty() && Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(m_triangles);
    return r;
  }

private:
  // Counts the triangles of each three sites, and the uses of each halfedge. Two triangles with the same halfedge mean
  // that two cells have two edges in common: triangles are oriented like the surface, so the two triangles at one edge
  // use it in opposite directions.
  //
  // Each finding is recorded when its count reaches 2, so that it is recorded once.
  void check_triangles(Report& r)
  {
    std::map<Triple, int> number_of_triangles;
    for(Triple t : m_triangles)
    {
      for(std::size_t k = 0; k < 3; ++k)
      {
        m_is_in_triangle.insert(t[k]);
        if(++m_halfedges[Pair(t[k], t[(k + 1) % 3])] == 2)
          m_pairs_with_several_edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
      }
      std::sort(t.begin(), t.end());
      if(++number_of_triangles[t] == 2)
        r.triples_with_several_vertices.push_back(t);
    }
  }

  // Finds cells that are not disks, have several boundaries, or are corners of no triangle; empty ones do not count.
  // Requires: check_triangles() has been called. Takes the time to follow the boundaries of all cells.
  void check_cells(Report& r) const
  {
    CGAL_assertion(m_is_in_triangle.empty() == m_triangles.empty());
    for(std::size_t i = 0; i < m_diagram.number_of_sites(); ++i)
    {
      if(m_diagram.is_empty(i))
        continue;
      if(!m_diagram.is_disk(i))
        r.cells_that_are_not_disks.push_back(i);
      else if(m_diagram.boundary(i).size() > 1)
        r.cells_with_several_boundaries.push_back(i);
      if(m_is_in_triangle.count(i) == 0)
        r.cells_without_triangle.push_back(i);
    }
  }

  // Finds cells with several edges in common, and edges whose dual is in no triangle: those from border to border.
  // Requires: check_triangles() has been called.
  void check_edges(Report& r)
  {
    CGAL_assertion(m_halfedges.empty() == m_triangles.empty());
    std::map<Pair, int> number_of_edges;
    for(const auto& e : m_diagram.edges())
    {
      const Pair s = e.sites(), pair = std::minmax(s.first, s.second);
      const int n = ++number_of_edges[pair];
      if(n == 2)
        m_pairs_with_several_edges.insert(pair);
      // A triangle uses the dual edge in one of two directions, depending on its side.
      if(n == 1 && m_halfedges.count(s) == 0 && m_halfedges.count(Pair(s.second, s.first)) == 0)
        r.pairs_without_triangle.push_back(pair);
    }
    r.pairs_with_several_edges.assign(m_pairs_with_several_edges.begin(), m_pairs_with_several_edges.end());
  }

  // Finds the vertices where more than three cells meet, whose triangles are one choice of several.
  void check_vertices(Report& r) const
  {
    for(const auto& v : m_diagram.vertices())
      if(v.sites().size() > 3)
        r.vertices_of_many_cells.push_back(v.sites());
  }

  const Diagram& m_diagram;
  std::vector<Triple> m_triangles;
  std::set<std::size_t> m_is_in_triangle;
  std::map<Pair, int> m_halfedges; // of the triangles, and how often each occurs
  std::set<Pair> m_pairs_with_several_edges;
};

// Adds the triangles to the output, with a vertex at each site that is in a triangle, in the order in which the
// triangles name them. What the output has held before stays.
// Requires: the triangles form a polygon mesh. OutputMesh is a model of MutableFaceGraph with an internal property for
// CGAL::vertex_point_t, whose points are made from three doubles.
template <typename OutputMesh, typename Diagram>
void add_dual_triangles(const Diagram& diagram, const std::vector<std::array<std::size_t, 3>>& triangles,
                        OutputMesh& output)
{
  using Point = typename boost::property_traits<
    typename boost::property_map<OutputMesh, CGAL::vertex_point_t>::type>::value_type;
  static_assert(!Is_of_the_plane<Point>::value, "the points of the output are points of the plane");
  CGAL_expensive_assertion(Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(triangles));
  std::vector<Point> points;
  std::vector<std::size_t> index_of_point(diagram.number_of_sites(), Diagram::null_site());
  std::vector<std::array<std::size_t, 3>> faces = triangles;
  for(std::array<std::size_t, 3>& f : faces)
    for(std::size_t& i : f)
    {
      if(index_of_point[i] == Diagram::null_site())
      {
        // A site in a triangle has a face, so its location has a point.
        const auto p = diagram.point(diagram.site(i));
        index_of_point[i] = points.size();
        points.push_back(Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
      }
      i = index_of_point[i];
    }
  Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, output);
}

// Adds the dual to the output if it is manifold; the output is not changed otherwise. Throws what Dual_check throws,
// before the output changes.
template <typename Report, typename Diagram, typename OutputMesh>
Report add_dual_mesh(const Diagram& diagram, OutputMesh& output)
{
  Dual_check<Diagram, Report> check(diagram);
  const Report report = check.report();
  if(report.is_manifold())
    add_dual_triangles(diagram, check.triangles(), output);
  return report;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DUAL_MESH_H
