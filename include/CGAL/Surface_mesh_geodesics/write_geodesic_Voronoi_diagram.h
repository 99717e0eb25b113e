// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_WRITE_GEODESIC_VORONOI_DIAGRAM_H
#define CGAL_SURFACE_MESH_GEODESICS_WRITE_GEODESIC_VORONOI_DIAGRAM_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_cell_colors.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

namespace internal {

// What is written of a diagram: triangles with their sites, and the edges as polylines.
struct Voronoi_drawing
{
  using Point = Simple_cartesian<double>::Point_3;
  using Sites = std::pair<std::size_t, std::size_t>;

  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> site_of_triangle;
  std::vector<std::vector<std::size_t>> polylines;
  std::vector<Sites> sites_of_polyline;

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
  }

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

  std::size_t number_of_segments() const
  {
    std::size_t n = 0;
    for(const auto& line : polylines)
      n += line.size() - 1;
    return n;
  }
};

// Site numbers in files; -1 for none.
inline long site_number(std::size_t i)
{
  return i == (std::numeric_limits<std::size_t>::max)() ? -1l : static_cast<long>(i);
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

writes the edges of a geodesic Voronoi diagram as polylines in the OBJ format: a group with the name `edge_i_j` for each
edge between the cells of the sites `i` and `j`, with one line.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param os the stream, with the precision that is wanted (17 digits lose nothing)
\param diagram the diagram, which is computed if that has not been done
\param tolerance the largest distance of the polylines from the arcs, in the unit of the mesh

\return whether all has been written. What has not may have been written in part.

\pre `tolerance > 0` and finite

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid. Nothing has been
        written then.

<b>Complexity.</b> Time and memory are linear in the number of points that are written.

<b>Thread safety.</b> The function may be called by several threads at once, on the same diagram as well, if each has a
stream of its own.
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram_OBJ(std::ostream& os, const Diagram& diagram, double tolerance)
{
  internal::Voronoi_drawing drawing;
  drawing.add_edges(diagram, tolerance);
  for(const auto& p : drawing.points)
    os << "v " << p << '\n';
  for(std::size_t i = 0; i < drawing.polylines.size(); ++i)
  {
    os << "g edge_" << drawing.sites_of_polyline[i].first << '_' << drawing.sites_of_polyline[i].second << "\nl";
    for(const std::size_t v : drawing.polylines[i])
      os << ' ' << v + 1; // OBJ counts from 1
    os << '\n';
  }
  return static_cast<bool>(os.flush());
}

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

writes a geodesic Voronoi diagram in the PLY format (ASCII): the mesh, cut along the arcs as by
`Surface_mesh_geodesic_Voronoi_diagram::cut()`, each face with a color and the number of its `site` (-1 for none); and
the edges of the diagram as elements `edge`, one for each segment, with the sites on the left and on the right. The
colors are those of `geodesic_Voronoi_cell_colors()`, and gray where no site reaches; the header has a comment with the
color of each site.

The precondition, the exception and thread safety are those of `write_geodesic_Voronoi_diagram_OBJ()`; the time is that
of `Surface_mesh_geodesic_Voronoi_diagram::cut()`.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param os the stream, with the precision that is wanted (17 digits lose nothing)
\param diagram the diagram, which is computed if that has not been done
\param tolerance the largest distance of the polylines from the arcs, in the unit of the mesh

\return whether all has been written
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram_PLY(std::ostream& os, const Diagram& diagram, double tolerance)
{
  internal::Voronoi_drawing drawing;
  drawing.add_cells(diagram, tolerance);
  drawing.add_edges(diagram, tolerance);
  const std::vector<IO::Color> colors = geodesic_Voronoi_cell_colors(diagram);
  const auto write_color = [&](const IO::Color& c)
  { os << int(c.red()) << ' ' << int(c.green()) << ' ' << int(c.blue()); };
  os << "ply\nformat ascii 1.0\n";
  for(std::size_t i = 0; i < colors.size(); ++i)
  {
    os << "comment site " << i << " color ";
    write_color(colors[i]);
    os << '\n';
  }
  os << "element vertex " << drawing.points.size()
     << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << drawing.triangles.size()
     << "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue"
     << "\nproperty int site\nelement edge " << drawing.number_of_segments()
     << "\nproperty int vertex1\nproperty int vertex2\nproperty int left_site\nproperty int right_site\nend_header\n";
  for(const auto& p : drawing.points)
    os << p << '\n';
  for(std::size_t i = 0; i < drawing.triangles.size(); ++i)
  {
    const std::array<std::size_t, 3>& t = drawing.triangles[i];
    const std::size_t site = drawing.site_of_triangle[i];
    os << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << ' ';
    write_color(site < colors.size() ? colors[site] : IO::Color(128, 128, 128));
    os << ' ' << internal::site_number(site) << '\n';
  }
  for(std::size_t i = 0; i < drawing.polylines.size(); ++i)
    for(std::size_t j = 1; j < drawing.polylines[i].size(); ++j)
      os << drawing.polylines[i][j - 1] << ' ' << drawing.polylines[i][j] << ' ' << drawing.sites_of_polyline[i].first
         << ' ' << drawing.sites_of_polyline[i].second << '\n';
  return static_cast<bool>(os.flush());
}

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

writes a geodesic Voronoi diagram as polygonal data in the legacy VTK format (ASCII): first the edges as polylines, then
the faces of the mesh, cut along the arcs. The cell data `site` is the site of a face and -1 for edges (and for faces
that no site reaches); `left_site` and `right_site` are the sites beside an edge, and those of
its face for a face.

The precondition, the exception and thread safety are those of `write_geodesic_Voronoi_diagram_OBJ()`; the time is that
of `Surface_mesh_geodesic_Voronoi_diagram::cut()`.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param os the stream, with the precision that is wanted (17 digits lose nothing)
\param diagram the diagram, which is computed if that has not been done
\param tolerance the largest distance of the polylines from the arcs, in the unit of the mesh

\return whether all has been written
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram_VTK(std::ostream& os, const Diagram& diagram, double tolerance)
{
  internal::Voronoi_drawing drawing;
  drawing.add_cells(diagram, tolerance);
  drawing.add_edges(diagram, tolerance);
  const std::size_t number_of_lines = drawing.polylines.size(), number_of_faces = drawing.triangles.size();
  os << "# vtk DataFile Version 3.0\ngeodesic Voronoi diagram\nASCII\nDATASET POLYDATA\nPOINTS "
     << drawing.points.size() << " double\n";
  for(const auto& p : drawing.points)
    os << p << '\n';
  if(number_of_lines > 0)
    os << "LINES " << number_of_lines << ' ' << 2 * number_of_lines + drawing.number_of_segments() << '\n';
  for(const std::vector<std::size_t>& line : drawing.polylines)
  {
    os << line.size();
    for(const std::size_t v : line)
      os << ' ' << v;
    os << '\n';
  }
  os << "POLYGONS " << number_of_faces << ' ' << 4 * number_of_faces << '\n';
  for(const std::array<std::size_t, 3>& t : drawing.triangles)
    os << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  os << "CELL_DATA " << number_of_lines + number_of_faces << '\n';
  const auto write_sites = [&](const char* name, auto site_of_line)
  {
    os << "SCALARS " << name << " int 1\nLOOKUP_TABLE default\n";
    for(const auto& sites : drawing.sites_of_polyline)
      os << site_of_line(sites) << '\n';
    for(const std::size_t site : drawing.site_of_triangle)
      os << internal::site_number(site) << '\n';
  };
  using Sites = internal::Voronoi_drawing::Sites;
  write_sites("site", [](const Sites&) { return -1l; });
  write_sites("left_site", [](const Sites& s) { return internal::site_number(s.first); });
  write_sites("right_site", [](const Sites& s) { return internal::site_number(s.second); });
  return static_cast<bool>(os.flush());
}

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

writes a geodesic Voronoi diagram to a file, with 17 digits, in the format that the end of its name tells: `.obj`,
`.ply` or `.vtk` (in lower case).

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param filename the name of the file, which is overwritten if it exists
\param diagram the diagram, which is computed if that has not been done
\param tolerance the largest distance of the polylines from the arcs, in the unit of the mesh

\return whether all has been written; `false` also if the end of the name is another one: then there is no file.

\pre `tolerance > 0` and finite

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid. The file is not
        touched then.

\sa `write_geodesic_Voronoi_diagram_OBJ()`, `write_geodesic_Voronoi_diagram_PLY()`,
    `write_geodesic_Voronoi_diagram_VTK()`
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram(const std::string& filename, const Diagram& diagram, double tolerance)
{
  const std::size_t n = filename.size();
  const std::string end = n < 4 ? std::string() : filename.substr(n - 4);
  if(end != ".obj" && end != ".ply" && end != ".vtk")
    return false;
  diagram.build(); // or throws, before the file is opened
  std::ofstream os(filename);
  os.precision(17);
  if(end == ".obj")
    return write_geodesic_Voronoi_diagram_OBJ(os, diagram, tolerance);
  return end == ".ply" ? write_geodesic_Voronoi_diagram_PLY(os, diagram, tolerance)
                       : write_geodesic_Voronoi_diagram_VTK(os, diagram, tolerance);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_WRITE_GEODESIC_VORONOI_DIAGRAM_H
