#include "Html_page.h"

#include "Command_error.h"
#include "Output_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace geodesics_demo {

namespace po = boost::program_options;

// Embedded by embed_page.cmake. Without three.js, the script and its license are empty.
extern const unsigned char page_template[], page_three[], page_license[], page_surface[], page_solver[],
  page_drawing[], page_script[];
extern const std::size_t page_template_size, page_three_size, page_license_size, page_surface_size, page_solver_size,
  page_drawing_size, page_script_size;

namespace {

// --- numbers as text -------------------------------------------------------------------------------------------------

// Four bytes for each number, the lowest one first, in base 64: a browser converts them to an array in one step, and
// they take half the space of digits.
class Base64_writer
{
public:
  explicit Base64_writer(std::ostream& os) : m_os(os) { m_os << '"'; }

  void add(std::uint32_t x)
  {
    for(int shift = 0; shift < 32; shift += 8)
      add_byte((x >> shift) & 0xffu);
  }

  void add(float x)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof(x));
    add(bits);
  }

  void finish()
  {
    if(m_number_of_bytes == 1)
      m_os << digit(m_bytes << 16, 18) << digit(m_bytes << 16, 12) << "==";
    else if(m_number_of_bytes == 2)
      m_os << digit(m_bytes << 8, 18) << digit(m_bytes << 8, 12) << digit(m_bytes << 8, 6) << '=';
    m_os << '"';
  }

private:
  static char digit(std::uint32_t bytes, int shift)
  {
    return "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"[(bytes >> shift) & 63u];
  }

  void add_byte(std::uint32_t byte)
  {
    m_bytes = m_bytes << 8 | byte;
    if(++m_number_of_bytes < 3)
      return;
    for(const int shift : {18, 12, 6, 0})
      m_os << digit(m_bytes, shift);
    m_bytes = 0;
    m_number_of_bytes = 0;
  }

  std::ostream& m_os;
  std::uint32_t m_bytes = 0; // not written yet
  int m_number_of_bytes = 0;
};

template <typename Range, typename Convert>
void write_array(std::ostream& os, const Range& range, Convert convert)
{
  Base64_writer writer(os);
  for(const auto& x : range)
    convert(writer, x);
  writer.finish();
}

void write_indices(std::ostream& os, const std::vector<std::size_t>& indices)
{
  write_array(os, indices, [](Base64_writer& w, std::size_t i) { w.add(static_cast<std::uint32_t>(i)); });
}

// A JSON string that is safe inside a script element: no character ends the element.
void write_string(std::ostream& os, const std::string& text)
{
  static const char* const digits = "0123456789abcdef";
  os << '"';
  for(const char c : text)
  {
    const unsigned char u = static_cast<unsigned char>(c);
    if(u < 0x20 || c == '"' || c == '\\' || c == '<' || c == '>' || c == '&')
      os << "\\u00" << digits[u >> 4] << digits[u & 15];
    else
      os << c;
  }
  os << '"';
}

// As in style sheets: #rrggbb.
std::string hexadecimal(const CGAL::IO::Color& color)
{
  static const char* const digits = "0123456789abcdef";
  std::string result = "#";
  for(const unsigned char c : {color.red(), color.green(), color.blue()})
    result += {digits[c >> 4], digits[c & 15]};
  return result;
}

std::string escaped(const std::string& text)
{
  static const std::map<char, std::string> names{{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}};
  std::string result;
  for(const char c : text)
  {
    const auto name = names.find(c);
    result += name == names.end() ? std::string(1, c) : name->second;
  }
  return result;
}

// With quotes where a shell needs them.
std::string& command_line()
{
  static std::string line;
  return line;
}

// --- the data of a page ----------------------------------------------------------------------------------------------

// Coordinates are relative to the center of the surface, so that `float` is precise enough far from the origin.
class Page_data_writer
{
public:
  Page_data_writer(std::ostream& os, const Html_page& page) : m_os(os), m_page(page)
  {
    CGAL::Bbox_3 box;
    for(const Point& p : page.surface.points)
      box += p.bbox();
    m_center = Point((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
    m_radius = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()) / 2;
  }

  void write()
  {
    m_os << "{\"title\":";
    write_string(m_os, m_page.title);
    m_os << ",\"subtitle\":";
    write_string(m_os, m_page.subtitle);
    m_os << ",\"center\":[" << m_center.x() << ',' << m_center.y() << ',' << m_center.z()
         << "],\"radius\":" << m_radius;
    m_os << ",\"command\":";
    write_string(m_os, command_line());
    write_surface();
    write_mesh();
    write_walls();
    write_groups();
    m_os << '}';
  }

private:
  void write_points(const std::vector<Point>& points)
  {
    write_array(m_os, points, [this](Base64_writer& w, const Point& p)
    {
      const auto v = p - m_center;
      w.add(static_cast<float>(v.x()));
      w.add(static_cast<float>(v.y()));
      w.add(static_cast<float>(v.z()));
    });
  }

  void write_surface()
  {
    const Html_surface& surface = m_page.surface;
    m_os << ",\"points\":";
    write_points(surface.points);
    m_os << ",\"triangles\":";
    write_array(m_os, surface.triangles, [](Base64_writer& w, const std::array<std::size_t, 3>& t)
    {
      for(const std::size_t v : t)
        w.add(static_cast<std::uint32_t>(v));
    });
    m_os << ",\"distances\":";
    write_array(m_os, surface.distances, [](Base64_writer& w, double d) { w.add(static_cast<float>(d)); });
    double largest = 0;
    for(const double d : surface.distances)
      largest = std::isfinite(d) ? (std::max)(largest, d) : largest;
    m_os << ",\"largest\":" << largest << ",\"isolines\":[";
    for(std::size_t i = 0; i < m_page.band_limits.size(); ++i)
      m_os << (i == 0 ? "" : ",") << m_page.band_limits[i];
    m_os << ']';
    if(!surface.cells.empty())
    {
      m_os << ",\"cells\":"; // "no cell" is the largest number of 32 bits
      write_indices(m_os, surface.cells);
    }
    write_avoided(surface.is_avoided);
    m_os << ",\"cellColors\":[";
    for(std::size_t i = 0; i < m_page.cell_colors.size(); ++i)
      m_os << (i == 0 ? "" : ",") << '"' << hexadecimal(m_page.cell_colors[i]) << '"';
    m_os << ']';
  }

  // Left out if it is what is drawn.
  void write_mesh()
  {
    const Html_surface& surface = m_page.surface;
    if(m_page.mesh == nullptr
       || (surface.cells.empty() && surface.points.size() == m_page.mesh->number_of_vertices()
           && surface.triangles.size() == m_page.mesh->number_of_faces()))
      return;
    std::vector<Point> points;
    for(const Vertex v : m_page.mesh->vertices())
      points.push_back(m_page.mesh->point(v));
    std::vector<std::size_t> corners;
    for(const Face f : m_page.mesh->faces())
    {
      const Mesh::Halfedge_index h = m_page.mesh->halfedge(f);
      for(const Vertex v : {m_page.mesh->source(h), m_page.mesh->target(h),
                            m_page.mesh->target(m_page.mesh->next(h))})
        corners.push_back(v.idx());
    }
    m_os << ",\"mesh\":{\"points\":";
    write_points(points);
    m_os << ",\"triangles\":";
    write_indices(m_os, corners);
    write_avoided(flags_of_faces(*m_page.mesh, m_page.avoided.faces));
    m_os << '}';
  }

  // The triangles that paths avoid, if there are any.
  void write_avoided(const std::vector<char>& is_avoided)
  {
    std::vector<std::size_t> triangles;
    for(std::size_t t = 0; t < is_avoided.size(); ++t)
      if(is_avoided[t] != 0)
        triangles.push_back(t);
    if(triangles.empty())
      return;
    m_os << ",\"avoided\":";
    write_indices(m_os, triangles);
  }

  // Pairs of vertices of the file.
  void write_walls()
  {
    if(m_page.avoided.walls.empty())
      return;
    std::vector<std::size_t> ends;
    for(const Mesh::Edge_index e : m_page.avoided.walls)
      for(const Vertex v : {m_page.mesh->vertex(e, 0), m_page.mesh->vertex(e, 1)})
        ends.push_back(v.idx());
    m_os << ",\"walls\":";
    write_indices(m_os, ends);
  }

  void write_groups()
  {
    m_os << ",\"lines\":[";
    const char* separator = "";
    for(const Html_lines& group : m_page.lines)
    {
      std::vector<Point> points;
      std::vector<std::size_t> lengths;
      for(const std::vector<Point>& line : group.lines)
      {
        points.insert(points.end(), line.begin(), line.end());
        lengths.push_back(line.size());
      }
      if(lengths.empty())
        continue; // the legend names what is there
      m_os << std::exchange(separator, ",") << "{\"role\":\"" << group.role << "\",\"lengths\":";
      write_indices(m_os, lengths);
      m_os << ",\"points\":";
      write_points(points);
      m_os << '}';
    }
    m_os << "],\"dots\":[";
    for(std::size_t i = 0; i < m_page.dots.size(); ++i)
    {
      m_os << (i == 0 ? "" : ",") << "{\"role\":\"" << m_page.dots[i].role << "\",\"points\":";
      write_points(m_page.dots[i].points);
      m_os << '}';
    }
    m_os << ']';
  }

  std::ostream& m_os;
  const Html_page& m_page;
  Point m_center;
  double m_radius;
};

// Bytes; a scan with half a million faces has a smaller page.
constexpr std::size_t largest_silent_page = 50000000;

// A surface with fewer triangles is refined.
constexpr std::size_t triangles_wanted = 40000;

// The number of parts into which each side of a triangle is divided.
std::size_t number_of_parts(std::size_t number_of_triangles)
{
  std::size_t k = 1;
  while(k < 64 && number_of_triangles * (k + 1) * (k + 1) <= triangles_wanted)
    ++k;
  return k;
}

void check_pages_are_available()
{
  if(page_three_size == 0)
    throw Command_error(Exit_code::BAD_USAGE, "this program was built without three.js (Debian: libjs-three) and "
                                              "cannot write pages for browsers");
}

} // namespace

Html_dots dots_at(const std::string& role, const std::vector<Location>& locations, const Mesh& mesh)
{
  Html_dots result{role, {}};
  for(const Location& p : locations)
    result.points.push_back(point_of(p, mesh));
  return result;
}

Html_lines lines_of_walls(const std::vector<Mesh::Edge_index>& walls, const Mesh& mesh)
{
  Html_lines result{"wall", {}};
  for(const Mesh::Edge_index e : walls)
    result.lines.push_back({mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))});
  return result;
}

std::string description_of(const std::string& file_name, const Mesh& mesh)
{
  return std::filesystem::path(file_name).filename().string() + ": " + std::to_string(mesh.number_of_vertices())
       + " vertices, " + counted_faces(mesh.number_of_faces());
}

bool is_refined(std::size_t number_of_triangles)
{
  return number_of_parts(number_of_triangles) > 1;
}

Html_surface refined(const Html_surface& surface, const Distance_in_triangle& distance)
{
  const std::size_t k = number_of_parts(surface.triangles.size());
  if(k == 1)
    return surface;
  Html_surface result;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    // row i holds the points with the first coordinate i / k, from left to right
    const auto [p, q, r] = surface.triangles[t];
    std::vector<std::size_t> row_before;
    for(std::size_t i = 0; i <= k; ++i)
    {
      std::vector<std::size_t> row;
      for(std::size_t j = 0; j + i <= k; ++j)
      {
        const double whole = static_cast<double>(k), b0 = static_cast<double>(i) / whole,
                     b1 = static_cast<double>(j) / whole, b2 = static_cast<double>(k - i - j) / whole;
        row.push_back(result.points.size());
        result.points.push_back(
          CGAL::barycenter(surface.points[p], b0, surface.points[q], b1, surface.points[r], b2));
        result.distances.push_back(distance(t, {b0, b1, b2}));
      }
      for(std::size_t j = 0; i > 0 && j < row.size(); ++j)
      {
        result.triangles.push_back({row[j], row_before[j + 1], row_before[j]});
        if(j + 1 < row.size())
          result.triangles.push_back({row[j], row[j + 1], row_before[j + 1]});
      }
      row_before = row;
    }
    if(!surface.cells.empty())
      result.cells.resize(result.triangles.size(), surface.cells[t]);
    if(!surface.is_avoided.empty())
      result.is_avoided.resize(result.triangles.size(), surface.is_avoided[t]);
  }
  return result;
}

Html_lines lines_between_bands(const Html_surface& surface, const std::vector<double>& limits)
{
  Html_lines result{"isoline", {}};
  for(const std::array<std::size_t, 3>& t : surface.triangles)
  {
    const auto [nearest, farthest] = std::minmax(
      {surface.distances[t[0]], surface.distances[t[1]], surface.distances[t[2]]});
    if(!std::isfinite(farthest))
      continue;
    const auto end = std::upper_bound(limits.begin(), limits.end(), farthest);
    for(auto limit = std::lower_bound(limits.begin(), end, nearest); limit != end; ++limit)
    {
      std::vector<Point> ends;
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t v = t[k], w = t[(k + 1) % 3];
        const double d = surface.distances[v], e = surface.distances[w];
        if((d < *limit) != (e < *limit))
          ends.push_back(surface.points[v] + (*limit - d) / (e - d) * (surface.points[w] - surface.points[v]));
      }
      if(ends.size() == 2)
        result.lines.push_back(ends);
    }
  }
  return result;
}

void declare_html(Option_descriptions& options)
{
  options.add_options()("html", po::value<std::vector<std::string>>()->value_name("FILE.html")->composing(),
                        "a page that shows the result in a browser, without a network");
}

std::vector<std::string> html_names(const Arguments& arguments)
{
  std::vector<std::string> names = all_values(arguments, "html");
  if(!names.empty())
    check_pages_are_available();
  for(const std::string& name : names)
    if(!has_format(name, "html"))
      throw Command_error(Exit_code::BAD_USAGE, "--html: the name '" + name + "' does not end with .html");
  return names;
}

void set_command_line(const std::vector<std::string>& words)
{
  static const char* const letters
    = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+.,:/@%";
  std::string line = "surface_mesh_geodesics";
  for(const std::string& word : words)
    line += word.empty() || word.find_first_not_of(letters) != std::string::npos ? " '" + word + "'" : " " + word;
  command_line() = line;
}

void write_html_page(std::ostream& os, const Html_page& page, const Console& console)
{
  check_pages_are_available(); // -o x.html requests a page, too
  const auto embedded = [](const unsigned char* bytes, std::size_t size)
  { return std::string(reinterpret_cast<const char*>(bytes), size); };
  std::string rest = embedded(page_template, page_template_size);
  // Writes the template up to a mark, without the mark.
  const auto write_up_to = [&](const std::string& mark)
  {
    const std::size_t position = rest.find(mark);
    os << rest.substr(0, position);
    rest.erase(0, position + mark.size());
  };
  write_up_to("@TITLE@");
  os << escaped(page.title);
  write_up_to("@LICENSE@");
  os << escaped(embedded(page_license, page_license_size));
  write_up_to("@THREE@");
  os << embedded(page_three, page_three_size);
  write_up_to("@cut_surface.js@");
  os << embedded(page_surface, page_surface_size);
  write_up_to("@exact_path.js@");
  os << embedded(page_solver, page_solver_size);
  write_up_to("@drawing.js@");
  os << embedded(page_drawing, page_drawing_size);
  write_up_to("@DATA@");
  std::ostringstream numbers;
  numbers.precision(os.precision());
  Page_data_writer(numbers, page).write();
  const std::string text = numbers.str();
  os << text;
  if(text.size() > largest_silent_page)
    console.note("the page has " + std::to_string(text.size() / 1000000)
                 + " MB, which many browsers show slowly; fewer paths, isolines or faces make it smaller");
  write_up_to("@page.js@");
  os << embedded(page_script, page_script_size) << rest;
}

} // namespace geodesics_demo
