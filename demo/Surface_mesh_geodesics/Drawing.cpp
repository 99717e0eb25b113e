#include "Drawing.h"

#include "Byte_writer.h"
#include "VTU_writer.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace geodesics_demo {

namespace {

// Whole numbers have no NaN: -1 stands for none.
std::int32_t whole(double x)
{
  return std::isfinite(x) ? static_cast<std::int32_t>(x) : -1;
}

double finite_or_nan(double x)
{
  return std::isfinite(x) ? x : std::numeric_limits<double>::quiet_NaN();
}

// --- PLY ------------------------------------------------------------------------------------------------------------

void write_columns(Byte_writer& out, const std::vector<Drawing_column>& columns, std::size_t i)
{
  for(const Drawing_column& column : columns)
  {
    if(column.is_integer)
      out.add(whole(column.values[i]));
    else
      out.add(finite_or_nan(column.values[i]));
  }
}

void write_column_properties(std::ostream& os, const std::vector<Drawing_column>& columns)
{
  for(const Drawing_column& column : columns)
    os << "property " << (column.is_integer ? "int " : "double ") << column.name << '\n';
}

void write_PLY_header(std::ostream& os, const Drawing& drawing)
{
  std::size_t number_of_segments = 0;
  for(const std::vector<std::size_t>& line : drawing.lines)
    number_of_segments += line.size() - 1;
  os << "ply\nformat binary_little_endian 1.0\nelement vertex " << drawing.points.size()
     << "\nproperty double x\nproperty double y\nproperty double z\n";
  if(!drawing.colors.empty())
    os << "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  write_column_properties(os, drawing.point_columns);
  os << "element face " << drawing.triangles.size() << "\nproperty list uchar int vertex_indices\n";
  if(number_of_segments > 0)
  {
    os << "element edge " << number_of_segments << "\nproperty int vertex1\nproperty int vertex2\n";
    write_column_properties(os, drawing.line_columns);
  }
  os << "end_header\n";
}

void write_PLY(std::ostream& os, const Drawing& drawing)
{
  write_PLY_header(os, drawing);
  Byte_writer out(os, Byte_order::LOWEST_FIRST);
  for(std::size_t i = 0; i < drawing.points.size(); ++i)
  {
    for(int k = 0; k < 3; ++k)
      out.add(drawing.points[i][k]);
    if(!drawing.colors.empty())
      for(const unsigned char c : drawing.colors[i])
        out.add(c);
    write_columns(out, drawing.point_columns, i);
  }
  for(const std::array<std::size_t, 3>& t : drawing.triangles)
  {
    out.add(std::uint8_t(3));
    for(const std::size_t v : t)
      out.add(static_cast<std::uint32_t>(v));
  }
  for(std::size_t l = 0; l < drawing.lines.size(); ++l)
    for(std::size_t i = 1; i < drawing.lines[l].size(); ++i)
    {
      out.add(static_cast<std::uint32_t>(drawing.lines[l][i - 1]));
      out.add(static_cast<std::uint32_t>(drawing.lines[l][i]));
      write_columns(out, drawing.line_columns, l);
    }
}

// --- VTK ------------------------------------------------------------------------------------------------------------

// Writes the numbers of a section: a line of text precedes them, and an end of line follows.
template <typename Write>
void write_section(std::ostream& os, const Write& write)
{
  Byte_writer out(os, Byte_order::HIGHEST_FIRST); // as legacy files of VTK have it
  write(out);
  out.flush();
  os << '\n';
}

// Triangles have no value of a line.
void write_scalars(std::ostream& os, const Drawing_column& column, std::size_t number_of_triangles)
{
  os << "SCALARS " << column.name << (column.is_integer ? " int 1" : " double 1") << "\nLOOKUP_TABLE default\n";
  write_section(os, [&](Byte_writer& out)
  {
    const auto add = [&](double x)
    {
      if(column.is_integer)
        out.add(whole(x));
      else
        out.add(finite_or_nan(x));
    };
    for(const double x : column.values)
      add(x);
    for(std::size_t i = 0; i < number_of_triangles; ++i)
      add(std::numeric_limits<double>::infinity());
  });
}

// Cells as the number of their points, and the points.
template <typename Cells>
void write_cells(std::ostream& os, const char* name, const Cells& cells)
{
  std::size_t size = cells.size();
  for(const auto& cell : cells)
    size += cell.size();
  os << name << ' ' << cells.size() << ' ' << size << '\n';
  write_section(os, [&](Byte_writer& out)
  {
    for(const auto& cell : cells)
    {
      out.add(static_cast<std::uint32_t>(cell.size()));
      for(const std::size_t v : cell)
        out.add(static_cast<std::uint32_t>(v));
    }
  });
}

// The cells of a drawing: lines, then triangles; its points if it has neither.
void write_VTK(std::ostream& os, const Drawing& drawing)
{
  os << "# vtk DataFile Version 3.0\nsurface_mesh_geodesics\nBINARY\nDATASET POLYDATA\nPOINTS "
     << drawing.points.size() << " double\n";
  write_section(os, [&](Byte_writer& out)
  {
    for(const Point& p : drawing.points)
      for(int k = 0; k < 3; ++k)
        out.add(p[k]);
  });
  if(drawing.lines.empty() && drawing.triangles.empty())
  {
    std::vector<std::array<std::size_t, 1>> points;
    for(std::size_t i = 0; i < drawing.points.size(); ++i)
      points.push_back({i});
    write_cells(os, "VERTICES", points);
  }
  if(!drawing.lines.empty())
    write_cells(os, "LINES", drawing.lines);
  if(!drawing.triangles.empty())
    write_cells(os, "POLYGONS", drawing.triangles);
  if(!drawing.line_columns.empty() && !drawing.lines.empty())
  {
    os << "CELL_DATA " << drawing.lines.size() + drawing.triangles.size() << '\n';
    for(const Drawing_column& column : drawing.line_columns)
      write_scalars(os, column, drawing.triangles.size());
  }
  if(!drawing.point_columns.empty())
  {
    os << "POINT_DATA " << drawing.points.size() << '\n';
    for(const Drawing_column& column : drawing.point_columns)
      write_scalars(os, column, 0);
  }
}

// --- OBJ ------------------------------------------------------------------------------------------------------------

void write_OBJ(std::ostream& os, const Drawing& drawing)
{
  for(std::size_t i = 0; i < drawing.points.size(); ++i)
  {
    os << "v " << drawing.points[i];
    if(!drawing.colors.empty())
      for(const unsigned char c : drawing.colors[i])
        os << ' ' << c / 255.;
    os << '\n';
  }
  for(const std::array<std::size_t, 3>& t : drawing.triangles)
    os << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n'; // OBJ counts from 1
  for(const std::vector<std::size_t>& line : drawing.lines)
  {
    os << 'l';
    for(const std::size_t v : line)
      os << ' ' << v + 1;
    os << '\n';
  }
  if(drawing.triangles.empty() && drawing.lines.empty())
    for(std::size_t i = 0; i < drawing.points.size(); ++i)
      os << "p " << i + 1 << '\n';
}

} // namespace

void Drawing::add_mesh(const Mesh& mesh)
{
  for(const Vertex v : mesh.vertices())
    points.push_back(mesh.point(v));
  for(const Face f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    triangles.push_back({mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
}

void Drawing::add_quality(const std::vector<double>& values)
{
  point_columns.push_back({"quality", false, values});
}

void Drawing::add_line(const std::vector<Point>& line)
{
  lines.emplace_back();
  for(const Point& p : line)
  {
    lines.back().push_back(points.size());
    points.push_back(p);
  }
}

void write_drawing(std::ostream& os, const std::string& format, const Drawing& drawing)
{
  if(format == "ply")
    write_PLY(os, drawing);
  else if(format == "vtk")
    write_VTK(os, drawing);
  else if(format == "vtu")
    write_VTU(os, drawing);
  else
    write_OBJ(os, drawing);
}

} // namespace geodesics_demo
