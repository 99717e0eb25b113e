#include "Byte_scanner.h"
#include "Mesh_readers.h"
#include "Text_scanner.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace geodesics_demo {

namespace {

// Gives equal points one index, in the order of their first occurrence. A table with open addressing: half of its
// places are empty, so that a search ends after two places on average.
class Point_welder
{
public:
  Point_welder(std::vector<Point>& points, std::size_t expected_points) : m_points(points)
  {
    std::size_t size = 64;
    while(size < 2 * expected_points)
      size *= 2;
    m_places.assign(size, no_index);
  }

  Polygon_soup::Index index_of(const Point& p)
  {
    if(2 * m_points.size() >= m_places.size())
      enlarge();
    const std::size_t place = place_of(p);
    if(m_places[place] == no_index)
    {
      m_places[place] = static_cast<Polygon_soup::Index>(m_points.size());
      m_points.push_back(p);
    }
    return m_places[place];
  }

private:
  static constexpr Polygon_soup::Index no_index = (std::numeric_limits<Polygon_soup::Index>::max)();

  // The place with an equal point, or an empty one.
  std::size_t place_of(const Point& p) const
  {
    const std::size_t mask = m_places.size() - 1;
    std::size_t place = hash(p) & mask;
    while(m_places[place] != no_index && m_points[m_places[place]] != p)
      place = (place + 1) & mask;
    return place;
  }

  static std::size_t hash(const Point& p)
  {
    std::uint64_t result = 0;
    for(int k = 0; k < 3; ++k)
    {
      const double x = p[k] + 0.; // -0 becomes 0: both are equal
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof(x));
      result = (result ^ bits) * 0x9e3779b97f4a7c15u;
      result ^= result >> 32;
    }
    return static_cast<std::size_t>(result);
  }

  void enlarge()
  {
    m_places.assign(2 * m_places.size(), no_index);
    for(std::size_t i = 0; i < m_points.size(); ++i)
      m_places[place_of(m_points[i])] = static_cast<Polygon_soup::Index>(i);
  }

  std::vector<Point>& m_points;
  std::vector<Polygon_soup::Index> m_places;
};

// --- text -----------------------------------------------------------------------------------------------------------

bool is_equal(std::string_view word, std::string_view small_letters)
{
  return word.size() == small_letters.size()
      && std::equal(word.begin(), word.end(), small_letters.begin(), [](char a, char b)
                    { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

class STL_text_reader
{
public:
  STL_text_reader(const std::string& file_name, std::string_view bytes)
    : m_in(file_name, bytes, 0), m_welder(m_soup.points, bytes.size() / 300)
  {}

  Polygon_soup read()
  {
    while(m_in.find_line())
    {
      const std::string_view word = m_in.word();
      if(is_equal(word, "facet"))
        read_face();
      else if(!is_equal(word, "solid") && !is_equal(word, "endsolid"))
        m_in.complain_of(word, "is not a statement of STL: solid, facet or endsolid is needed");
      m_in.skip_line(); // the name of a solid
    }
    return std::move(m_soup);
  }

private:
  void read_face()
  {
    m_soup.lines.push_back(m_in.line());
    m_in.skip_line(); // the normal: its direction follows from the corners, and its length means nothing
    require("outer");
    require("loop");
    for(int k = 0; k < 3; ++k)
    {
      require("vertex");
      const double x = m_in.number("a coordinate"), y = m_in.number("a coordinate"), z = m_in.number("a coordinate");
      m_soup.corners.push_back(m_welder.index_of(Point(x, y, z)));
    }
    require("endloop");
    require("endfacet");
    m_soup.end_face();
  }

  void require(const char* keyword)
  {
    if(!m_in.find_line())
      m_in.complain(std::string("the file ends, but the word '") + keyword + "' is needed");
    const std::string_view word = m_in.word();
    if(!is_equal(word, keyword))
      m_in.complain_of(word, std::string("is not the word '") + keyword + "', which is needed here");
  }

  Text_scanner m_in;
  Polygon_soup m_soup;
  Point_welder m_welder;
};

// --- binary ---------------------------------------------------------------------------------------------------------

constexpr std::size_t size_of_header = 80, size_of_face = 50;

std::size_t announced_faces(const std::string& file_name, std::string_view bytes)
{
  return Byte_scanner(file_name, bytes.substr((std::min)(size_of_header, bytes.size())), Byte_order::LOWEST_FIRST)
    .next<std::uint32_t>();
}

Polygon_soup read_binary(const std::string& file_name, std::string_view bytes)
{
  Byte_scanner in(file_name, bytes, Byte_order::LOWEST_FIRST);
  in.skip(size_of_header);
  const std::size_t n = in.next<std::uint32_t>();
  if(n > in.rest() / size_of_face)
    reject_file(file_name, "the file announces " + std::to_string(n) + " faces, but has room for "
                             + std::to_string(in.rest() / size_of_face) + " only");
  Polygon_soup soup;
  soup.points.reserve(n / 2 + 3);
  soup.corners.reserve(3 * n);
  soup.ends.reserve(n);
  Point_welder welder(soup.points, n / 2);
  for(std::size_t f = 0; f < n; ++f)
  {
    in.skip(12); // the normal
    for(int k = 0; k < 3; ++k)
    {
      const float x = in.next<float>(), y = in.next<float>(), z = in.next<float>();
      if(!(x - x == 0) || !(y - y == 0) || !(z - z == 0)) // infinite, or not a number
        reject_file(file_name, "a coordinate of face " + std::to_string(f) + " is not a finite number");
      soup.corners.push_back(welder.index_of(Point(x, y, z)));
    }
    in.skip(2); // attributes
    soup.end_face();
  }
  return soup;
}

// Many binary files begin with the word of text files, `solid`. So the size decides, then the words of a text.
bool is_text(const std::string& file_name, std::string_view bytes)
{
  if(bytes.size() >= size_of_header + 4
     && bytes.size() == size_of_header + 4 + size_of_face * announced_faces(file_name, bytes))
    return false;
  const std::string_view text = without_mark_of_byte_order(file_name, bytes);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if(first == std::string_view::npos || !is_equal(text.substr(first, 5), "solid"))
    return false;
  return text.substr(0, 2000).find('\0') == std::string_view::npos;
}

} // namespace

Polygon_soup read_STL(const std::string& file_name, std::string_view bytes)
{
  return is_text(file_name, bytes) ? STL_text_reader(file_name, bytes).read() : read_binary(file_name, bytes);
}

} // namespace geodesics_demo
