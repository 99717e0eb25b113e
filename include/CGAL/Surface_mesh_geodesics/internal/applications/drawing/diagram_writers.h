// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_DIAGRAM_WRITERS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_DIAGRAM_WRITERS_H

// Writes the drawing of a diagram in the formats OBJ, PLY and legacy VTK. What each file holds is documented at the
// public functions of write_geodesic_Voronoi_diagram.h. Functions that write a whole file flush the stream and return
// whether it is still good. Numbers are text, with the precision of the stream; in PLY and VTK they are bytes if the
// mode of the stream is BINARY (Number_writer.h).
//
// Three formats, as no one of them is enough: OBJ has the edges as smooth polylines, for other programs that draw them
// over the mesh; PLY has the cut mesh in colors, for viewers of meshes; VTK has both, with the numbers of the sites,
// for programs that select and compute.
//
// `Diagram` is the public class; `tolerance` is positive, in the unit of the mesh. All writers compute the whole
// drawing before they write its first line: what building throws leaves the stream as it was.

#include <CGAL/Surface_mesh_geodesics/internal/applications/drawing/Cell_coloring.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/drawing/Number_writer.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/drawing/Voronoi_drawing.h>

#include <CGAL/IO/Color.h>
#include <CGAL/IO/io.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ios>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Indices in files have 32 bits. A stream fails before anything is written if the points of a drawing have larger ones;
// sites are fewer than points.
inline bool has_indices_in_file(std::ostream& os, const Voronoi_drawing& drawing)
{
  if(drawing.points.size() > static_cast<std::size_t>((std::numeric_limits<std::int32_t>::max)()))
    os.setstate(std::ios::failbit);
  return static_cast<bool>(os);
}

inline std::int32_t index_in_file(std::size_t i) { return static_cast<std::int32_t>(i); }

// The number of a site in a file, -1 for no site, which diagrams name by the largest std::size_t.
inline std::int32_t site_number(std::size_t i)
{
  return i == (std::numeric_limits<std::size_t>::max)() ? -1 : index_in_file(i);
}

// Returns the triangles of the cells and the polylines of the edges, which VTK shows together. Their points are apart:
// the sides of triangles are chords of the arcs that the polylines follow.
template <typename Diagram>
Voronoi_drawing drawing_with_cells(const Diagram& diagram, double tolerance)
{
  Voronoi_drawing drawing;
  drawing.add_cells(diagram, tolerance);
  drawing.add_edges(diagram, tolerance);
  return drawing;
}

// Writes each point as a record.
inline void write_points(Number_writer& out, const Voronoi_drawing& drawing)
{
  for(const Voronoi_drawing::Point& p : drawing.points)
  {
    for(const double x : {p.x(), p.y(), p.z()})
      out.write(x);
    out.end_record();
  }
}

// --- OBJ ---

// Writes a group with one polyline for each edge. OBJ has neither colors nor sites, so the names of the groups tell
// them.
template <typename Diagram>
bool write_diagram_OBJ(std::ostream& os, const Diagram& diagram, double tolerance)
{
  Voronoi_drawing drawing;
  drawing.add_edges(diagram, tolerance);
  for(const Voronoi_drawing::Point& p : drawing.points)
    os << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
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

// Writes the header, with a comment for each site, since PLY has no element for sites. Segments are elements of type
// `edge`, between vertices of the faces: viewers complain of points without a face. The order of properties is that in
// which write_diagram_PLY() writes the numbers of each line.
inline void write_header_PLY(std::ostream& os, const Voronoi_drawing& drawing, const std::vector<IO::Color>& colors)
{
  os << "ply\nformat " << (IO::is_binary(os) ? "binary_little_endian" : "ascii") << " 1.0\n";
  for(std::size_t i = 0; i < colors.size(); ++i)
  {
    const IO::Color& c = colors[i];
    os << "comment site " << i << " color " << int(c.red()) << ' ' << int(c.green()) << ' ' << int(c.blue()) << '\n';
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
  if(!has_indices_in_file(os, drawing))
    return false;
  const std::vector<IO::Color> colors = cell_colors(diagram);
  write_header_PLY(os, drawing, colors);
  Number_writer out(os, Number_writer::Byte_order::LOWEST_FIRST);
  write_points(out, drawing);
  for(std::size_t i = 0; i < drawing.triangles.size(); ++i)
  {
    const std::size_t site = drawing.site_of_triangle[i];
    const IO::Color color = site < colors.size() ? colors[site] : IO::Color(128, 128, 128);
    out.write(std::uint8_t(3));
    for(const std::size_t v : drawing.triangles[i])
      out.write(index_in_file(v));
    for(const std::uint8_t c : {color.red(), color.green(), color.blue()})
      out.write(c);
    out.write(site_number(site));
    out.end_record();
  }
  for(std::size_t i = 0; i < drawing.segments.size(); ++i)
  {
    for(const std::size_t v : drawing.segments[i])
      out.write(index_in_file(v));
    out.write(site_number(drawing.sites_of_segment[i].first));
    out.write(site_number(drawing.sites_of_segment[i].second));
    out.end_record();
  }
  out.flush();
  return static_cast<bool>(os.flush());
}

// --- VTK ---

// Writes a field of the cell data: `site_of_line(sites)` for the polylines, then the sites of the triangles. Each field
// is a number for each cell of the file.
template <typename SiteOfLine>
void write_sites_VTK(std::ostream& os, const Voronoi_drawing& drawing, const char* name, SiteOfLine site_of_line)
{
  os << "SCALARS " << name << " int 1\nLOOKUP_TABLE default\n";
  Number_writer out(os, Number_writer::Byte_order::HIGHEST_FIRST);
  const auto write = [&out](std::int32_t i)
  {
    out.write(i);
    out.end_record();
  };
  for(const Voronoi_drawing::Sites& sites : drawing.sites_of_polyline)
    write(site_of_line(sites));
  for(const std::size_t site : drawing.site_of_triangle)
    write(site_number(site));
  out.end_block();
}

// Writes the cells of one kind, as a size and the points of each. Without cells there is no such section.
// `number_of_numbers` counts all numbers of the section.
template <typename Cells>
void write_cells_VTK(std::ostream& os, const char* kind, const Cells& cells, std::size_t number_of_numbers)
{
  if(cells.empty())
    return;
  os << kind << ' ' << cells.size() << ' ' << number_of_numbers << '\n';
  Number_writer out(os, Number_writer::Byte_order::HIGHEST_FIRST);
  for(const auto& cell : cells)
  {
    out.write(index_in_file(cell.size()));
    for(const std::size_t v : cell)
      out.write(index_in_file(v));
    out.end_record();
  }
  out.end_block();
}

// Writes polylines, then triangles: legacy VTK numbers the cells of a file in this order, and the cell data follow it.
// A polyline of s segments has s + 1 points and takes s + 2 numbers, and a triangle takes 4.
template <typename Diagram>
bool write_diagram_VTK(std::ostream& os, const Diagram& diagram, double tolerance)
{
  using Sites = Voronoi_drawing::Sites;
  const Voronoi_drawing drawing = drawing_with_cells(diagram, tolerance);
  if(!has_indices_in_file(os, drawing))
    return false;
  os << "# vtk DataFile Version 3.0\ngeodesic Voronoi diagram\n" << (IO::is_binary(os) ? "BINARY" : "ASCII")
     << "\nDATASET POLYDATA\nPOINTS " << drawing.points.size() << " double\n";
  {
    Number_writer out(os, Number_writer::Byte_order::HIGHEST_FIRST);
    write_points(out, drawing);
    out.end_block();
  }
  write_cells_VTK(os, "LINES", drawing.polylines, 2 * drawing.polylines.size() + drawing.number_of_segments());
  write_cells_VTK(os, "POLYGONS", drawing.triangles, 4 * drawing.triangles.size());
  os << "CELL_DATA " << drawing.polylines.size() + drawing.triangles.size() << '\n';
  write_sites_VTK(os, drawing, "site", [](const Sites&) { return std::int32_t(-1); });
  write_sites_VTK(os, drawing, "left_site", [](const Sites& s) { return site_number(s.first); });
  write_sites_VTK(os, drawing, "right_site", [](const Sites& s) { return site_number(s.second); });
  return static_cast<bool>(os.flush());
}

// --- files ---

// The file is opened last, so that a diagram that cannot be built leaves an older file in place. CGAL's functions for
// files write in binary as well if they are not told otherwise.
//
// Writes in the format that the extension of the name stands for: PLY and VTK in binary, OBJ with 17 digits. Returns
// false for another extension, and does not touch the file then. Returns false also if the file cannot be opened or
// written; it may hold a part then. Extensions are in lower case.
template <typename Diagram>
bool write_diagram_file(const std::string& filename, const Diagram& diagram, double tolerance)
{
  const std::size_t n = filename.size();
  const std::string extension = n < 4 ? std::string() : filename.substr(n - 4);
  if(extension != ".obj" && extension != ".ply" && extension != ".vtk")
    return false;
  diagram.build(); // may throw, which must happen before the file is overwritten
  std::ofstream os(filename, extension == ".obj" ? std::ios::out : std::ios::out | std::ios::binary);
  if(extension == ".obj")
  {
    os.precision(17);
    return write_diagram_OBJ(os, diagram, tolerance);
  }
  IO::set_binary_mode(os);
  return extension == ".ply" ? write_diagram_PLY(os, diagram, tolerance) : write_diagram_VTK(os, diagram, tolerance);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_DIAGRAM_WRITERS_H
