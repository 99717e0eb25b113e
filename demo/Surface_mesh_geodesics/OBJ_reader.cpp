#include "Command_error.h"
#include "Mesh_readers.h"
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
    check_largest_index();
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
      read_corner();
    m_soup.end_face();
  }

  // V, V/T, V//N or V/T/N. A negative index counts from the last vertex back.
  void read_corner()
  {
    const std::string_view word = m_in.peek_word();
    const std::int64_t i = m_in.integer_before_slash(), n = static_cast<std::int64_t>(m_soup.points.size());
    const std::string_view others = m_in.position() == word.data() + word.size() ? std::string_view() : m_in.word();
    if(i == 0 || (!others.empty() && (others[0] != '/' || others.find_first_not_of("/-0123456789") != others.npos)))
      m_in.complain_of(word, word == "0" || word.substr(0, 2) == "0/"
                               ? "is not an index of a vertex: OBJ counts from 1"
                               : "is not a corner of a face, such as 7, 7/7 or 7/7/7");
    if(i < -n || i > most_points)
      m_in.complain_of(word, "is not an index of a vertex: there are " + std::to_string(n) + " before this line");
    if(i > m_largest)
    {
      m_largest = i;
      m_line_of_largest = m_in.line();
    }
    m_soup.corners.push_back(static_cast<Polygon_soup::Index>(i > 0 ? i - 1 : n + i));
  }

  // A face may precede its vertices.
  void check_largest_index() const
  {
    if(m_largest > static_cast<std::int64_t>(m_soup.points.size()))
      reject_line(m_file_name, m_line_of_largest, "there is no vertex " + std::to_string(m_largest) + "; the file has "
                                                    + std::to_string(m_soup.points.size()));
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
  std::int64_t m_largest = 0;
  std::uint32_t m_line_of_largest = 0, m_unknown_line = 0;
  std::string m_unknown;
};

} // namespace

Polygon_soup read_OBJ(const std::string& file_name, std::string_view bytes, const Console& console)
{
  return OBJ_reader(file_name, bytes, console).read();
}

} // namespace geodesics_demo
