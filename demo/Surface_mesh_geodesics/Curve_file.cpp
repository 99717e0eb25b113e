#include "Curve_file.h"

#include "Command_error.h"
#include "File_bytes.h"
#include "Input_file.h"
#include "OBJ_indices.h"
#include "Polygon_soup.h"
#include "Text_scanner.h"
#include "number_arguments.h"

#include <cctype>
#include <cstdint>
#include <utility>

namespace geodesics_demo {

namespace {

std::array<double, 3> read_point(Text_scanner& in)
{
  std::array<double, 3> x{};
  for(double& coordinate : x)
    coordinate = in.number("a coordinate");
  return x;
}

// A statement l may precede its vertices, so the points are looked up at the end.
std::vector<Polyline> read_OBJ_lines(const std::string& file_name, const std::string& bytes)
{
  Text_scanner in(file_name, bytes, '#', true);
  OBJ_indices indices;
  std::vector<std::array<double, 3>> points;
  std::vector<std::size_t> lines_of_points;
  std::vector<std::vector<std::size_t>> corners;
  for(; in.find_line(); in.skip_line())
  {
    const std::string_view keyword = in.word();
    if(keyword == "v")
    {
      lines_of_points.push_back(in.line());
      points.push_back(read_point(in));
    }
    if(keyword != "l")
      continue;
    corners.emplace_back();
    do
      corners.back().push_back(indices.read(in, points.size(), "a point of a line, such as 7 or 7/7"));
    while(in.has_word());
  }
  indices.check_largest(file_name, points.size());
  std::vector<Polyline> result(corners.size());
  for(std::size_t i = 0; i < corners.size(); ++i)
    for(const std::size_t v : corners[i])
    {
      result[i].points.push_back(points[v]);
      result[i].lines.push_back(lines_of_points[v]);
    }
  return result;
}

std::vector<Polyline> read_CGAL_polylines(const std::string& file_name, const std::string& bytes)
{
  Text_scanner in(file_name, bytes, '#');
  std::vector<Polyline> result;
  for(; in.find_line(); in.skip_line())
  {
    result.emplace_back();
    for(std::int64_t n = in.integer("a number of points", 1, most_points); n > 0; --n)
    {
      result.back().points.push_back(read_point(in));
      result.back().lines.push_back(in.line());
    }
    if(in.has_word())
      in.complain_of(in.peek_word(), "follows after the last point of the line");
  }
  return result;
}

bool has_ending(std::string name, const std::string& ending)
{
  for(char& c : name)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ends_with(name, ending);
}

} // namespace

std::vector<Polyline> read_polylines(const std::string& file_name)
{
  const bool is_OBJ = has_ending(file_name, ".obj");
  if(!is_OBJ && !has_ending(file_name, ".polylines.txt"))
    reject_file(file_name, "the name of a file of curves must end with one of .obj, .polylines.txt");
  check_is_readable(file_name);
  const std::string bytes = bytes_of(file_name);
  std::vector<Polyline> result = is_OBJ ? read_OBJ_lines(file_name, bytes) : read_CGAL_polylines(file_name, bytes);
  if(result.empty())
    reject_file(file_name, is_OBJ ? "the file contains no curve: it has no statement 'l'"
                                  : "the file contains no curve");
  for(Polyline& p : result)
    if(p.points.size() > 1 && p.points.front() == p.points.back())
    {
      p.is_closed = true;
      p.points.pop_back();
      p.lines.pop_back();
    }
  return result;
}

} // namespace geodesics_demo
