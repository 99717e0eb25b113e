#include "Command_error.h"
#include "Mesh_readers.h"
#include "OBJ_indices.h"
#include "Text_scanner.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace geodesics_demo {

namespace {

// Reads the statements of an OBJ file one after the other.
class OBJ_reader
{
public:
  OBJ_reader(const std::string& file_name, std::string_view bytes, const Console& console)
    : m_file_name(file_name), m_in(file_name, bytes, '#', true), m_console(console)
  {}

  Polygon_soup read()
  {
    while(m_in.find_line())
    {
      const std::string_view keyword = m_in.word();
      if(keyword == "v")
        read_vertex();
      else if(keyword == "f" || keyword == "fo") // fo: of old files
        read_face();
      else if(!is_ignored(keyword))
        remember_unknown(keyword);
      m_in.skip_line();
    }
    m_indices.check_largest(m_file_name, m_soup.points.size());
    if(m_unknown_line > 0)
      m_console.note(m_file_name + ", line " + std::to_string(m_unknown_line) + ": '" + m_unknown
                     + "' is not a statement of OBJ that the program knows; such lines are ignored");
    return std::move(m_soup);
  }

private:
  // Statements without a meaning for distances: normals, texture, lines, points, groups, materials, free-form curves.
  static bool is_ignored(std::string_view keyword)
  {
    static const std::array<std::string_view, 43> known{
      "vn", "vt", "vp", "l", "p", "g", "o", "s", "mg", "usemtl", "mtllib", "usemap", "maplib", "bevel", "c_interp",
      "d_interp", "lod", "shadow_obj", "trace_obj", "ctech", "stech", "cstype", "deg", "bmat", "step", "curv", "curv2",
      "surf", "parm", "trim", "hole", "scrv", "sp", "end", "con", "call", "csh", "bsp", "bzp", "cdc", "cdp", "res",
      "vc"};
    return std::find(known.begin(), known.end(), keyword) != known.end();
  }

  // A color or a weight may follow the coordinates.
  void read_vertex()
  {
    const double x = m_in.number("a coordinate"), y = m_in.number("a coordinate"), z = m_in.number("a coordinate");
    if(static_cast<std::int64_t>(m_soup.points.size()) == most_points)
      m_in.complain("there are too many vertices");
    m_soup.points.emplace_back(x, y, z);
  }

  void read_face()
  {
    m_soup.lines.push_back(m_in.line());
    while(m_in.has_word())
      m_soup.corners.push_back(static_cast<Polygon_soup::Index>(
        m_indices.read(m_in, m_soup.points.size(), "a corner of a face, such as 7, 7/7 or 7/7/7")));
    m_soup.end_face();
  }

  void remember_unknown(std::string_view keyword)
  {
    if(m_unknown_line > 0)
      return;
    m_unknown_line = m_in.line();
    for(const char c : keyword.substr(0, 20))
      m_unknown += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  }

  std::string m_file_name;
  Text_scanner m_in;
  const Console& m_console;
  Polygon_soup m_soup;
  OBJ_indices m_indices;
  std::uint32_t m_unknown_line = 0;
  std::string m_unknown;
};

} // namespace

Polygon_soup read_OBJ(const std::string& file_name, std::string_view bytes, const Console& console)
{
  return OBJ_reader(file_name, bytes, console).read();
}

} // namespace geodesics_demo
