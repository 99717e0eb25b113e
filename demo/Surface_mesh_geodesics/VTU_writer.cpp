#include "VTU_writer.h"

#include "Byte_writer.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace geodesics_demo {

namespace {

// Types of cells in VTK.
constexpr std::uint8_t vertex_type = 1, line_type = 4, triangle_type = 5; // a line may have any number of points

// One array of the file: its description in the header, and how its bytes are written.
struct VTU_array
{
  std::string name, type;
  int components;
  std::uint64_t bytes;
  std::function<void(Byte_writer&)> write;
};

class VTU_file
{
public:
  explicit VTU_file(const Drawing& drawing) : m_drawing(drawing)
  {
    m_has_points_only = drawing.lines.empty() && drawing.triangles.empty();
    m_number_of_cells = m_has_points_only ? drawing.points.size() : drawing.lines.size() + drawing.triangles.size();
  }

  void write(std::ostream& os)
  {
    os << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
          "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
       << m_drawing.points.size() << "\" NumberOfCells=\"" << m_number_of_cells << "\">\n";
    const auto section = [&](const char* name, const std::function<void()>& contents)
    {
      os << '<' << name << ">\n";
      contents();
      for(; m_announced < m_arrays.size(); ++m_announced)
        announce(os, m_arrays[m_announced]);
      os << "</" << name << ">\n";
    };
    section("Points", [&] { add_points(); });
    section("Cells", [&] { add_cells(); });
    section("PointData", [&]
    {
      for(const Drawing_column& column : m_drawing.point_columns)
        add_column(column, 0);
      add_colors();
    });
    section("CellData", [&]
    {
      for(const Drawing_column& column : m_drawing.line_columns)
        add_column(column, m_drawing.triangles.size());
    });
    os << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    {
      Byte_writer out(os, Byte_order::LOWEST_FIRST);
      for(const VTU_array& array : m_arrays)
      {
        out.add(array.bytes);
        array.write(out);
      }
    }
    os << "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  // The offset of an array counts the bytes of those before it, each with its length in eight bytes.
  void announce(std::ostream& os, const VTU_array& array)
  {
    os << "<DataArray type=\"" << array.type << "\" Name=\"" << array.name << "\" NumberOfComponents=\""
       << array.components << "\" format=\"appended\" offset=\"" << m_offset << "\"/>\n";
    m_offset += 8 + array.bytes;
  }

  void add_points()
  {
    m_arrays.push_back({"Points", "Float64", 3, 24 * m_drawing.points.size(), [this](Byte_writer& out)
    {
      for(const Point& p : m_drawing.points)
        for(int k = 0; k < 3; ++k)
          out.add(p[k]);
    }});
  }

  void add_cells()
  {
    std::uint64_t size = 3 * m_drawing.triangles.size() + (m_has_points_only ? m_drawing.points.size() : 0);
    for(const std::vector<std::size_t>& line : m_drawing.lines)
      size += line.size();
    m_arrays.push_back({"connectivity", "Int64", 1, 8 * size, [this](Byte_writer& out)
    {
      for_each_cell([&](const std::size_t* first, std::size_t n, std::uint8_t)
      {
        for(std::size_t k = 0; k < n; ++k)
          out.add(static_cast<std::int64_t>(first[k]));
      });
    }});
    m_arrays.push_back({"offsets", "Int64", 1, 8 * m_number_of_cells, [this](Byte_writer& out)
    {
      std::int64_t end = 0;
      for_each_cell([&](const std::size_t*, std::size_t n, std::uint8_t)
      {
        end += static_cast<std::int64_t>(n);
        out.add(end);
      });
    }});
    m_arrays.push_back({"types", "UInt8", 1, m_number_of_cells, [this](Byte_writer& out)
    { for_each_cell([&](const std::size_t*, std::size_t, std::uint8_t type) { out.add(type); }); }});
  }

  template <typename Function>
  void for_each_cell(const Function& function) const
  {
    for(std::size_t i = 0; m_has_points_only && i < m_drawing.points.size(); ++i)
      function(&i, 1, vertex_type);
    for(const std::vector<std::size_t>& line : m_drawing.lines)
      function(line.data(), line.size(), line_type);
    for(const auto& triangle : m_drawing.triangles)
      function(triangle.data(), 3, triangle_type);
  }

  void add_column(const Drawing_column& column, std::size_t number_of_others)
  {
    const std::uint64_t n = column.values.size() + number_of_others;
    m_arrays.push_back({column.name, column.is_integer ? "Int32" : "Float64", 1, (column.is_integer ? 4 : 8) * n,
                        [&column, number_of_others](Byte_writer& out)
    {
      const auto add = [&](double x)
      {
        if(column.is_integer)
          out.add(std::isfinite(x) ? static_cast<std::int32_t>(x) : std::int32_t(-1));
        else
          out.add(std::isfinite(x) ? x : std::numeric_limits<double>::quiet_NaN());
      };
      for(const double x : column.values)
        add(x);
      for(std::size_t i = 0; i < number_of_others; ++i)
        add(std::numeric_limits<double>::infinity());
    }});
  }

  void add_colors()
  {
    if(!m_drawing.colors.empty())
      m_arrays.push_back({"color", "UInt8", 3, 3 * m_drawing.colors.size(), [this](Byte_writer& out)
      {
        for(const Color& color : m_drawing.colors)
          for(const unsigned char c : color)
            out.add(c);
      }});
  }

  const Drawing& m_drawing;
  bool m_has_points_only;
  std::size_t m_number_of_cells, m_announced = 0;
  std::uint64_t m_offset = 0;
  std::vector<VTU_array> m_arrays;
};

} // namespace

void write_VTU(std::ostream& os, const Drawing& drawing)
{
  VTU_file(drawing).write(os);
}

} // namespace geodesics_demo
