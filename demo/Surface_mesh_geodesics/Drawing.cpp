#include "Drawing.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace geodesics_demo {

namespace {

double finite_or_minus_one(double x)
{
  return std::isfinite(x) ? x : -1;
}

// --- PLY ------------------------------------------------------------------------------------------------------------

// Numbers with the lowest byte first, on any machine.
template <typename Unsigned>
void write_bytes(std::ostream& os, Unsigned x)
{
  char bytes[sizeof(Unsigned)];
  for(std::size_t i = 0; i < sizeof(Unsigned); ++i)
    bytes[i] = static_cast<char>(static_cast<unsigned char>(x >> (8 * i)));
  os.write(bytes, sizeof(Unsigned));
}

void write_double(std::ostream& os, double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(x));
  write_bytes(os, bits);
}

void write_integer(std::ostream& os, std::int64_t x)
{
  write_bytes(os, static_cast<std::uint32_t>(static_cast<std::int32_t>(x)));
}

void write_index(std::ostream& os, std::size_t i)
{
  write_integer(os, static_cast<std::int64_t>(i));
}

void write_columns(std::ostream& os, const std::vector<Drawing_column>& columns, std::size_t i)
{
  for(const Drawing_column& column : columns)
  {
    const double x = finite_or_minus_one(column.values[i]);
    if(column.is_integer)
      write_integer(os, static_cast<std::int64_t>(x));
    else
      write_double(os, x);
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
  for(std::size_t i = 0; i < drawing.points.size(); ++i)
  {
    for(int k = 0; k < 3; ++k)
      write_double(os, drawing.points[i][k]);
    if(!drawing.colors.empty())
      for(const unsigned char c : drawing.colors[i])
        os.put(static_cast<char>(c));
    write_columns(os, drawing.point_columns, i);
  }
  for(const std::array<std::size_t, 3>& t : drawing.triangles)
  {
    os.put(3);
    for(const std::size_t v : t)
      write_index(os, v);
  }
  for(std::size_t l = 0; l < drawing.lines.size(); ++l)
    for(std::size_t i = 1; i < drawing.lines[l].size(); ++i)
    {
      write_index(os, drawing.lines[l][i - 1]);
      write_index(os, drawing.lines[l][i]);
      write_columns(os, drawing.line_columns, l);
    }
}

// --- VTK ------------------------------------------------------------------------------------------------------------

void write_scalars(std::ostream& os, const Drawing_column& column, std::size_t number_of_other_cells)
{
  os << "SCALARS " << column.name << (column.is_integer ? " int 1" : " double 1") << "\nLOOKUP_TABLE default\n";
  for(const double x : column.values)
    os << finite_or_minus_one(x) << '\n';
  for(std::size_t i = 0; i < number_of_other_cells; ++i)
    os << "-1\n";
}

// The cells of a drawing: lines, then triangles; its points if it has neither.
void write_VTK(std::ostream& os, const Drawing& drawing)
{
  os << "# vtk DataFile Version 3.0\nsurface_mesh_geodesics\nASCII\nDATASET POLYDATA\nPOINTS " << drawing.points.size()
     << " double\n";
  for(const Point& p : drawing.points)
    os << p << '\n';
  if(drawing.lines.empty() && drawing.triangles.empty())
  {
    os << "VERTICES " << drawing.points.size() << ' ' << 2 * drawing.points.size() << '\n';
    for(std::size_t i = 0; i < drawing.points.size(); ++i)
      os << "1 " << i << '\n';
  }
  if(!drawing.lines.empty())
  {
    std::size_t size = drawing.lines.size();
    for(const std::vector<std::size_t>& line : drawing.lines)
      size += line.size();
    os << "LINES " << drawing.lines.size() << ' ' << size << '\n';
    for(const std::vector<std::size_t>& line : drawing.lines)
    {
      os << line.size();
      for(const std::size_t v : line)
        os << ' ' << v;
      os << '\n';
    }
  }
  if(!drawing.triangles.empty())
  {
    os << "POLYGONS " << drawing.triangles.size() << ' ' << 4 * drawing.triangles.size() << '\n';
    for(const std::array<std::size_t, 3>& t : drawing.triangles)
      os << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  }
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
  else
    write_OBJ(os, drawing);
}

} // namespace geodesics_demo
