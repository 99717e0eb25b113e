#include "Command_error.h"
#include "Mesh_readers.h"
#include "Text_scanner.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>

namespace geodesics_demo {

namespace {

// Reads the surfaces of a GOCAD file. A file may hold several objects, one after the other, each of which numbers its
// vertices by itself, in any order. (CGAL's reader takes vertices in the order of the file, whatever their numbers.)
class TS_reader
{
public:
  TS_reader(const std::string& file_name, std::string_view bytes) : m_in(file_name, bytes, '#') {}

  Polygon_soup read()
  {
    bool is_in_object = false;
    while(m_in.find_line())
    {
      const std::string_view keyword = m_in.word();
      if(!is_in_object)
        start_object(keyword);
      else if(keyword == "VRTX" || keyword == "PVRTX")
        read_vertex();
      else if(keyword == "ATOM" || keyword == "PATOM")
        read_atom();
      else if(keyword == "TRGL")
        read_triangle();
      else if(keyword == "HEADER" || keyword == "GOCAD_ORIGINAL_COORDINATE_SYSTEM")
        skip_block(keyword);
      is_in_object = keyword != "END"; // other statements, such as TFACE, BSTONE and properties, do not matter
      m_in.skip_line();
    }
    if(is_in_object)
      m_in.complain("the file ends before END");
    return std::move(m_soup);
  }

private:
  void start_object(std::string_view keyword)
  {
    if(keyword != "GOCAD")
      m_in.complain_of(keyword, "where an object should begin with GOCAD TSurf");
    const std::string_view kind = m_in.word();
    if(kind != "TSurf" && kind != "TSURF")
      m_in.complain_of(kind, "is not a kind of object that the program reads, which is TSurf");
    m_index.clear();
  }

  // The lines up to the end of a block: a name may be a keyword.
  void skip_block(std::string_view keyword)
  {
    const bool is_header = keyword == "HEADER";
    if(is_header && m_in.peek_word().substr(0, 1) != "{")
      return;
    do
    {
      while(m_in.has_word())
      {
        const std::string_view word = m_in.word();
        if(is_header ? word.back() == '}' : word == "END_ORIGINAL_COORDINATE_SYSTEM")
          return;
      }
      m_in.skip_line();
    }
    while(m_in.find_line());
  }

  std::int64_t number()
  {
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    return m_in.integer("the number of a vertex", 0, most);
  }

  // Properties of the vertex may follow.
  void read_vertex()
  {
    const std::int64_t id = number();
    const double x = m_in.number("a coordinate"), y = m_in.number("a coordinate"), z = m_in.number("a coordinate");
    if(static_cast<std::int64_t>(m_soup.points.size()) == most_points)
      m_in.complain("there are too many vertices");
    add(id, static_cast<Polygon_soup::Index>(m_soup.points.size()));
    m_soup.points.emplace_back(x, y, z);
  }

  // Another number of a vertex.
  void read_atom()
  {
    const std::int64_t id = number();
    add(id, vertex());
  }

  void add(std::int64_t id, Polygon_soup::Index vertex)
  {
    if(!m_index.emplace(id, vertex).second)
      m_in.complain("there are two vertices with the number " + std::to_string(id));
  }

  void read_triangle()
  {
    m_soup.lines.push_back(m_in.line());
    for(int k = 0; k < 3; ++k)
      m_soup.corners.push_back(vertex());
    m_soup.end_face();
  }

  Polygon_soup::Index vertex()
  {
    const std::int64_t id = number();
    const auto found = m_index.find(id);
    if(found == m_index.end())
      m_in.complain("there is no vertex with the number " + std::to_string(id) + " before");
    return found->second;
  }

  Text_scanner m_in;
  std::unordered_map<std::int64_t, Polygon_soup::Index> m_index; // by the number of a vertex of the object
  Polygon_soup m_soup;
};

} // namespace

Polygon_soup read_TS(const std::string& file_name, std::string_view bytes)
{
  return TS_reader(file_name, bytes).read();
}

} // namespace geodesics_demo
