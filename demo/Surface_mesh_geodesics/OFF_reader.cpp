#include "Byte_scanner.h"
#include "Mesh_readers.h"
#include "Text_scanner.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace geodesics_demo {

namespace {

// What the first word of a file says, such as STCN4OFF: textures, colors, normals, homogeneous coordinates.
struct OFF_kind
{
  bool is_valid = false, is_homogeneous = false, has_dimension = false, has_normals = false, has_textures = false;
};

OFF_kind kind_of(std::string_view word)
{
  OFF_kind kind;
  const auto has_prefix = [&](std::string_view prefix)
  {
    const bool result = word.substr(0, prefix.size()) == prefix;
    word.remove_prefix(result ? prefix.size() : 0);
    return result;
  };
  kind.has_textures = has_prefix("ST");
  has_prefix("C"); // colors are ignored
  kind.has_normals = has_prefix("N");
  kind.is_homogeneous = has_prefix("4");
  kind.has_dimension = has_prefix("n");
  kind.is_valid = word == "OFF" || word == "SKEL";
  return kind;
}

Point point_of(double x, double y, double z, double w)
{
  return Point(x / w, y / w, z / w);
}

// --- text -----------------------------------------------------------------------------------------------------------

struct Counts
{
  std::size_t vertices = 0, faces = 0;
};

// The numbers of vertices and of faces; each may have a line of its own. The number of edges may be missing.
Counts read_counts(Text_scanner& in, const OFF_kind& kind)
{
  const auto next = [&](const char* what, std::int64_t least, std::int64_t most)
  {
    if(!in.find_line())
      in.complain(std::string("the file ends, but ") + what + " is needed");
    return static_cast<std::size_t>(in.integer(what, least, most));
  };
  if(kind.has_dimension)
    next("a dimension (the program reads surfaces in space)", 3, 3);
  Counts counts;
  counts.vertices = next("a number of vertices", 0, most_points);
  counts.faces = next("a number of faces", 0, most_points);
  in.skip_line(); // the number of edges, which follows from the faces
  return counts;
}

void read_vertices(Text_scanner& in, const OFF_kind& kind, std::size_t n, Polygon_soup& soup)
{
  soup.points.reserve((std::min)(n, in.rest() / 6)); // three digits and three blanks at least
  for(std::size_t i = 0; i < n; ++i)
  {
    if(!in.find_line())
      in.complain("the file ends after " + std::to_string(i) + " of " + std::to_string(n) + " vertices");
    const double x = in.number("a coordinate"), y = in.number("a coordinate"), z = in.number("a coordinate");
    soup.points.push_back(point_of(x, y, z, kind.is_homogeneous ? in.number("a fourth coordinate") : 1));
    in.skip_line(); // normals, colors, textures
  }
}

void read_faces(Text_scanner& in, std::size_t n, Polygon_soup& soup)
{
  const std::int64_t number_of_points = static_cast<std::int64_t>(soup.points.size());
  soup.corners.reserve((std::min)(3 * n, in.rest() / 2));
  soup.ends.reserve((std::min)(n, in.rest() / 2));
  soup.lines.reserve((std::min)(n, in.rest() / 2));
  for(std::size_t f = 0; f < n; ++f)
  {
    if(!in.find_line())
      in.complain("the file ends after " + std::to_string(f) + " of " + std::to_string(n) + " faces");
    soup.lines.push_back(in.line());
    const std::int64_t size = in.integer("a number of corners", 0, number_of_points);
    for(std::int64_t k = 0; k < size; ++k)
      soup.corners.push_back(
        static_cast<Polygon_soup::Index>(in.integer("an index of a vertex", 0, number_of_points - 1)));
    soup.end_face();
    in.skip_line(); // colors
  }
}

// --- binary ---------------------------------------------------------------------------------------------------------

// Numbers have four bytes, the highest one first.
Polygon_soup read_binary(const std::string& file_name, std::string_view bytes, const OFF_kind& kind)
{
  Byte_scanner in(file_name, bytes, Byte_order::HIGHEST_FIRST);
  const auto next_count = [&](const char* what)
  {
    const std::int32_t n = in.next<std::int32_t>();
    if(n < 0)
      reject_file(file_name, std::to_string(n) + " is not " + what);
    return static_cast<std::size_t>(n);
  };
  if(kind.has_dimension && next_count("a dimension") != 3)
    reject_file(file_name, "the program reads surfaces in space only");
  const std::size_t vertices = next_count("a number of vertices"), faces = next_count("a number of faces");
  in.skip(4); // the number of edges
  Polygon_soup soup;
  const std::size_t coordinates = kind.is_homogeneous ? 4 : 3;
  const std::size_t others = 4 * ((kind.has_normals ? coordinates : 0) + (kind.has_textures ? coordinates - 1 : 0));
  for(std::size_t i = 0; i < vertices; ++i)
  {
    const float x = in.next<float>(), y = in.next<float>(), z = in.next<float>();
    soup.points.push_back(point_of(x, y, z, kind.is_homogeneous ? in.next<float>() : 1));
    in.skip(others);
  }
  for(std::size_t f = 0; f < faces; ++f)
  {
    const std::size_t size = next_count("a number of corners");
    for(std::size_t k = 0; k < size; ++k)
    {
      const std::size_t v = next_count("an index of a vertex");
      if(v >= vertices)
        reject_file(file_name, "face " + std::to_string(f) + " has the vertex " + std::to_string(v)
                                 + ", but there are only " + std::to_string(vertices) + " vertices");
      soup.corners.push_back(static_cast<Polygon_soup::Index>(v));
    }
    soup.end_face();
    const std::size_t colors = next_count("a number of color components");
    in.skip(4 * colors);
  }
  return soup;
}

} // namespace

Polygon_soup read_OFF(const std::string& file_name, std::string_view bytes)
{
  Text_scanner in(file_name, bytes, '#');
  if(!in.find_line())
    in.complain("the file ends, but the word OFF is needed");
  const std::string_view first = in.word();
  const OFF_kind kind = kind_of(first);
  if(!kind.is_valid)
    in.complain_of(first, "is not the beginning of an OFF file, such as OFF or COFF");
  if(in.peek_word() == "BINARY")
  {
    in.skip_line();
    return read_binary(file_name, std::string_view(in.position(), in.rest()), kind);
  }
  Polygon_soup soup;
  const Counts counts = read_counts(in, kind);
  read_vertices(in, kind, counts.vertices, soup);
  read_faces(in, counts.faces, soup);
  return soup;
}

} // namespace geodesics_demo
