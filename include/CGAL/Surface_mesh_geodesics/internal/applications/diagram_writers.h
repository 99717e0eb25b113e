// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_WRITERS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_WRITERS_H

// Writes the drawing of a diagram as text in the formats OBJ, PLY and legacy VTK. What each file holds is documented at
// the public functions of write_geodesic_Voronoi_diagram.h. Functions that write a whole file flush the stream and
// return whether it is still good. Numbers are written with the precision of the stream.
//
// `Diagram` is the public class; `tolerance` is positive, in the unit of the mesh. All writers compute the whole
// drawing before they write its first line: what building throws leaves the stream as it was.

#include <CGAL/Surface_mesh_geodesics/internal/applications/Cell_coloring.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Voronoi_drawing.h>

#include <CGAL/IO/Color.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The number of a site in a file, -1 for no site, which diagrams name by the largest std::size_t.
inline long site_number(std::size_t i)
{
  return i == (std::numeric_limits<std::size_t>::max)() ? -1l : static_cast<long>(i);
}

// Returns the triangles of the cells and the polylines of the edges, which VTK shows together.
template <typename Diagram>
Voronoi_drawing drawing_with_cells(const Diagram& diagram, double tolerance)
{
  Voronoi_drawing drawing;
  drawing.add_cells(diagram, tolerance);
  drawing.add_edges(diagram, tolerance);
  return drawing;
}

// Writes each point on its own line, after a prefix.
inline void write_points(std::ostream& os, const Voronoi_drawing& drawing, const char* prefix = "")
{
  for(const Voronoi_drawing::Point& p : drawing.points)
    os << prefix << p << '\n';
}

// --- OBJ ---

// Writes a group with one polyline for each edge. OBJ has neither colors nor sites, so the names of the groups tell
// them.
template <typename Diagram>
bool write_diagram_OBJ(std::ostream& os, const Diagram& diagram, double tolerance)
{
  Voronoi_drawing drawing;
  drawing.add_edges(diagram, tolerance);
  write_points(os, drawing, "v ");
  for(std::size_t i = 0; i < drawing.polylines.size(); ++i)
  {
    os << "g edge_" << drawing.sites_of_polyline[i].first << '_' << drawing.sites_of_polyline[i].second << "\nl";
    for(const std::size_t v : drawing.polylines[i])
      os << ' ' << v + 1; // OBJ counts from 1
    os << '\n';
  }
  return static_cast<bool>(os.flush());
}

// --- PLY ---

inline void write_color(std::ostream& os, const IO::Color& c)
{
  os << int(c.red()) << ' ' << int(c.green()) << ' ' << int(c.blue());
}

// Writes the header, with a comment for each site, since PLY has no element for sites. Segments are elements of type
// `edge`, between vertices of the faces: viewers complain of points without a face. The order of properties is that in
// which write_diagram_PLY() writes the numbers of each line. Indices are of type int, so readers expect fewer than 2^31
// points; this is not checked.
inline void write_header_PLY(std::ostream& os, const Voronoi_drawing& drawing, const std::vector<IO::Color>& colors)
{
  os << "ply\nformat ascii 1.0\n";
  for(std::size_t i = 0; i < colors.size(); ++i)
  {
    os << "comment site " << i << " color ";
    write_color(os, colors[i]);
    os << '\n';
  }
  os << "element vertex " << drawing.points.size()
     << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << drawing.triangles.size()
     << "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue"
     << "\nproperty int site\nelement edge " << drawing.segments.size()
     << "\nproperty int vertex1\nproperty int vertex2\nproperty int left_site\nproperty int right_site\nend_header\n";
}

// Writes triangles in the colors of their cells, gray where no site reaches, and the segments between cells. The sites
// on both sides of a segment are those of its triangles, seen on the way from its first vertex to the second. Sites
// with an empty cell have a comment, too.
template <typename Diagram>
bool write_diagram_PLY(std::ostream& os, const Diagram& diagram, double tolerance)
{
  Voronoi_drawing drawing;
  drawing.add_cells(diagram, tolerance);
  const std::vector<IO::Color> colors = cell_colors(diagram);
  write_header_PLY(os, drawing, colors);
  write_points(os, drawing);
  for(std::size_t i = 0; i < drawing.triangles.size(); ++i)
  {
    const std::array<std::size_t, 3>& t = drawing.triangles[i];
    const std::size_t site = drawing.site_of_triangle[i];
    os << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << ' ';
    write_color(os, site < colors.size() ? colors[site] : IO::Color(128, 128, 128));
    os << ' ' << site_number(site) << '\n';
  }
  for(std::size_t i = 0; i < drawing.segments.size(); ++i)
    os << drawing.segments[i][0] << ' ' << drawing.segments[i][1] << ' ' << drawing.sites_of_segment[i].first << ' '
       << drawing.sites_of_segment[i].second << '\n';
  return static_cast<bool>(os.flush());
}

// --- VTK ---

// Writes a field of the cell data: `site_of_line(sites)` for the polylines, then the sites of the triangles. Each field
// is a number for each cell of the file.
template <typename SiteOfLine>
void write_sites_VTK(std::ostream& os, const Voronoi_drawing& drawing, const char* name, SiteOfLine site_of_line)
{
  os << "SCALARS " << name << " int 1\nLOOKUP_TABLE default\n";
  for(const Voronoi_drawing::Sites& sites : drawing.sites_of_polyline)
    os << site_of_line(sites) << '\n';
  for(const std::size_t site : drawing.site_of_triangle)
    os << site_number(site) << '\n';
}

// Writes the polylines. The second number of the header counts all numbers that follow: a size and the points of each.
// A polyline of s segments has s + 1 points, so these are s + 2 numbers. Without polylines there is no such section.
inline void write_lines_VTK(std::ostream& os, const Voronoi_drawing& drawing)
{
  const std::size_t number_of_lines = drawing.polylines.size();
  if(number_of_lines > 0)
    os << "LINES " << number_of_lines << ' ' << 2 * number_of_lines + drawing.number_of_segments() << '\n';
  for(const std::vector<std::size_t>& line : drawing.polylines)
  {
    os << line.size();
    for(const std::size_t v : line)
      os << ' ' << v;
    os << '\n';
  }
}

// Writes polylines, then triangles: legacy VTK numbers the cells of a file in this order, and the cell data follow it.
// A triangle takes four numbers: its size, 3, and three points.
template <typename Diagram>
bool write_diagram_VTK(std::ostream& os, const Diagram& diagram, double tolerance)
{
  using Sites = Voronoi_drawing::Sites;
  const Voronoi_drawing drawing = drawing_with_cells(diagram, tolerance);
  const std::size_t number_of_faces = drawing.triangles.size();
  os << "# vtk DataFile Version 3.0\ngeodesic Voronoi diagram\nASCII\nDATASET POLYDATA\nPOINTS "
     << drawing.points.size() << " double\n";
  write_points(os, drawing);
  write_lines_VTK(os, drawing);
  os << "POLYGONS " << number_of_faces << ' ' << 4 * number_of_faces << '\n';
  for(const std::array<std::size_t, 3>& t : drawing.triangles)
    os << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  os << "CELL_DATA " << drawing.polylines.size() + number_of_faces << '\n';
  write_sites_VTK(os, drawing, "site", [](const Sites&) { return -1l; });
  write_sites_VTK(os, drawing, "left_site", [](const Sites& s) { return site_number(s.first); });
  write_sites_VTK(os, drawing, "right_site", [](const Sites& s) { return site_number(s.second); });
  return static_cast<bool>(os.flush());
}

// --- files ---

// Writes with 17 digits, in the format that the extension of the name stands for. Returns false for another extension,
// and does not touch the file then. Returns false also if the file cannot be opened or written; it may hold a part of
// the text then. Extensions are in lower case.
template <typename Diagram>
bool write_diagram_file(const std::string& filename, const Diagram& diagram, double tolerance)
{
  const std::size_t n = filename.size();
  const std::string extension = n < 4 ? std::string() : filename.substr(n - 4);
  if(extension != ".obj" && extension != ".ply" && extension != ".vtk")
    return false;
  diagram.build(); // may throw, which must happen before the file is overwritten
  std::ofstream os(filename);
  os.precision(17);
  if(extension == ".obj")
    return write_diagram_OBJ(os, diagram, tolerance);
  return extension == ".ply" ? write_diagram_PLY(os, diagram, tolerance) : write_diagram_VTK(os, diagram, tolerance);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_WRITERS_H
