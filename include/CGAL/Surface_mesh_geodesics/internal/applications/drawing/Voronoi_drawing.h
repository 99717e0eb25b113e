// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_VORONOI_DRAWING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_VORONOI_DRAWING_H

// What the writers put into a file: the triangles of the cut mesh with their sites, the edges of this mesh between two
// cells, and the edges of the diagram as polylines. All refer to one list of points.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Triangles and segments share points. Polylines have points of their own: they follow the arcs by themselves, with
// another set of samples. Points are in the user's unit. Members of the same index belong together: triangles and
// site_of_triangle, segments and sites_of_segment, polylines and sites_of_polyline.
struct Voronoi_drawing
{
  using Point = Simple_cartesian<double>::Point_3;
  using Sites = std::pair<std::size_t, std::size_t>; // on the left and on the right

  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;  // indices in `points`
  std::vector<std::size_t> site_of_triangle;          // the largest number if no site reaches the triangle
  std::vector<std::array<std::size_t, 2>> segments;   // indices in `points`
  std::vector<Sites> sites_of_segment;
  std::vector<std::vector<std::size_t>> polylines;    // indices in `points`
  std::vector<Sites> sites_of_polyline;

  // Adds the mesh, cut along the arcs, and its edges between two cells. No such edge is farther from its arc than
  // `tolerance`, in the unit of the mesh, unless Voronoi_face_cut ends the sampling of an arc before. The mesh is cut
  // into a Surface_mesh first, which is freed at the end. Requires: tolerance > 0. Takes the time of Diagram::cut(),
  // which builds the diagram if that is not done.
  template <typename Diagram>
  void add_cells(const Diagram& diagram, double tolerance)
  {
    using Mesh = CGAL::Surface_mesh<Point>;
    Mesh mesh;
    auto site = mesh.template add_property_map<Mesh::Face_index, std::size_t>("f:site").first;
    diagram.cut(mesh, site, tolerance);
    const std::size_t first = points.size();
    for(const Mesh::Vertex_index v : mesh.vertices())
      points.push_back(mesh.point(v));
    for(const Mesh::Face_index f : mesh.faces())
    {
      const auto h = mesh.halfedge(f);
      triangles.push_back({first + mesh.source(h), first + mesh.target(h), first + mesh.target(mesh.next(h))});
      site_of_triangle.push_back(site[f]);
    }
    // The face of h is on its left. There is no boundary between cells along the border, nor where no site reaches, as
    // behind faces to avoid.
    constexpr std::size_t no_site = (std::numeric_limits<std::size_t>::max)();
    for(const Mesh::Edge_index e : mesh.edges())
    {
      const auto h = mesh.halfedge(e);
      if(mesh.is_border(e))
        continue;
      const Sites sites(site[mesh.face(h)], site[mesh.face(mesh.opposite(h))]);
      if(sites.first == sites.second || sites.first == no_site || sites.second == no_site)
        continue;
      segments.push_back({first + mesh.source(h), first + mesh.target(h)});
      sites_of_segment.push_back(sites);
    }
  }

  // Adds one polyline for each edge of the diagram, with points of its own. `tolerance` is that of Edge::polyline(),
  // which halves arcs further than add_cells() does. Takes time linear in the number of points.
  template <typename Diagram>
  void add_edges(const Diagram& diagram, double tolerance)
  {
    std::vector<decltype(diagram.point(diagram.site(0)))> polyline;
    for(const auto& e : diagram.edges())
    {
      polyline.clear();
      e.polyline(tolerance, std::back_inserter(polyline));
      polylines.emplace_back();
      for(const auto& p : polyline)
      {
        polylines.back().push_back(points.size());
        points.push_back(Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
      }
      sites_of_polyline.push_back(e.sites());
    }
  }

  // The number of segments of all polylines. (A polyline has two points at least.)
  std::size_t number_of_segments() const
  {
    std::size_t n = 0;
    for(const auto& line : polylines)
      n += line.size() - 1;
    return n;
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_VORONOI_DRAWING_H
