#include "Location_options.h"

#include "Command_error.h"
#include "Input_file.h"
#include "Location_table.h"
#include "Point_projection.h"
#include "number_arguments.h"

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <random>
#include <utility>

namespace geodesics_demo {

namespace po = boost::program_options;

namespace {

Location at_vertex(Vertex v)
{
  return Location{v, Face_location(Mesh::null_face(), {0, 0, 0}), 0};
}

Location at_face_location(const Face_location& location)
{
  return Location{Mesh::null_vertex(), location, 0};
}

bool parse_point(const std::vector<std::string>& coordinates, std::array<double, 3>& x)
{
  bool is_point = coordinates.size() == 3;
  for(std::size_t k = 0; is_point && k < 3; ++k)
    is_point = parse_number(coordinates[k], x[k]);
  return is_point;
}

// The parts of a value between commas, without the blanks around them.
std::vector<std::string> values_of(const std::string& value)
{
  std::vector<std::string> parts = split(value, ',');
  for(std::string& part : parts)
  {
    const std::size_t first = part.find_first_not_of(" \t");
    part = first == std::string::npos ? std::string() : part.substr(first, part.find_last_not_of(" \t") - first + 1);
  }
  return parts;
}

[[noreturn]] void complain_of_vertex(const std::string& text, const std::string& where, Exit_code code)
{
  throw Command_error(code, where + ": '" + text + "' is not a vertex index");
}

[[noreturn]] void complain_of_point(const std::string& where, Exit_code code)
{
  throw Command_error(code, where + ": a point consists of three finite numbers");
}

// Checks of values that need no mesh.
void check_vertices(const std::vector<std::string>& values, const std::string& option)
{
  std::size_t v = 0;
  for(const std::string& value : values)
    for(const std::string& text : values_of(value))
      if(text != "all" && !parse_index(text, v))
        complain_of_vertex(text, option, Exit_code::BAD_USAGE);
}

void check_points(const std::vector<std::string>& values, const std::string& option)
{
  std::array<double, 3> x{};
  for(const std::string& value : values)
    if(!parse_point(values_of(value), x))
      complain_of_point(std::string(option).append(" ").append(value), Exit_code::BAD_USAGE);
}

// Lists the vertices from locations[first] on; a long list is cut.
std::string list_of_vertices(const std::vector<Location>& locations, std::size_t first)
{
  const std::size_t most = 20, n = locations.size() - first;
  std::string text = n == 1 ? "vertex " : "vertices ";
  for(std::size_t i = 0; i < (std::min)(n, most); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(locations[first + i].vertex.idx());
  return n > most ? text + " and " + std::to_string(n - most) + " more, which a table .csv names" : text;
}

// Reads locations from the command line and from files. Messages begin with `where`, the origin of a text.
class Location_reader
{
public:
  Location_reader(const Mesh& mesh, Location_options::Kind kind, bool may_snap, const Console& console)
    : m_mesh(mesh), m_kind(kind), m_projection(mesh, may_snap, console)
  {}

  std::vector<Location> locations;

  void add_vertex(const std::string& text, const std::string& where, Exit_code code)
  {
    std::size_t i = 0;
    if(!parse_index(text, i))
      complain_of_vertex(text, where, code);
    if(i >= m_mesh.number_of_vertices())
      throw Command_error(code, where + ": there is no vertex " + text + "; the vertices of the mesh are 0 to "
                                  + std::to_string(m_mesh.number_of_vertices() - 1));
    locations.push_back(at_vertex(Vertex(static_cast<Mesh::size_type>(i))));
  }

  void add_all_vertices()
  {
    for(const Vertex v : m_mesh.vertices())
      locations.push_back(at_vertex(v));
  }

  void add_nearest_location(const std::vector<std::string>& coordinates, const std::string& where, Exit_code code)
  {
    std::array<double, 3> x;
    if(!parse_point(coordinates, x))
      complain_of_point(where, code);
    locations.push_back(at_face_location(m_projection.nearest_location(x, where, code)));
  }

  void remark_on_snaps() const { m_projection.remark_on_snaps(); }

  // Reads one location per line: a vertex (one number), a point (three numbers), or a face with barycentric coordinates
  // (four numbers). A # begins a comment. A table that a command has written is such a file, too: its first line has
  // the names of its columns.
  void add_file(const std::string& file_name, const std::string& role)
  {
    std::ifstream is = opened_text_file(file_name);
    const std::size_t number_before = locations.size();
    Location_table table(role);
    std::string line;
    for(std::size_t number = 1; std::getline(is, line); ++number)
    {
      const std::string where = file_name + ", line " + std::to_string(number);
      const std::vector<std::string> words = table.words_of(line, where);
      if(words.empty())
        continue;
      add_line(words, where);
      if(role == "site" && !table.weight().empty() && !parse_number(table.weight(), locations.back().weight))
        throw Command_error(Exit_code::BAD_INPUT, where + ": '" + table.weight() + "' is not a weight");
    }
    if(is.bad())
      throw Command_error(Exit_code::BAD_INPUT, file_name + ": the file cannot be read");
    if(locations.size() == number_before)
      throw Command_error(Exit_code::BAD_INPUT, file_name + ": the file contains no location");
  }

  // Chooses vertices with faces, each at most once. The same seed gives the same vertices on every machine; the
  // distributions of the standard library do not guarantee that.
  void add_random_vertices(std::size_t n, std::uint64_t seed, const std::string& option)
  {
    std::vector<Vertex> pool;
    for(const Vertex v : m_mesh.vertices())
      if(!m_mesh.is_isolated(v))
        pool.push_back(v);
    if(n > pool.size())
      throw Command_error(Exit_code::BAD_USAGE, option + ": there are only " + std::to_string(pool.size())
                                                  + " vertices with faces in the mesh");
    std::mt19937_64 random(seed);
    for(std::size_t i = 0; i < n; ++i)
    {
      std::swap(pool[i], pool[i + random() % (pool.size() - i)]);
      locations.push_back(at_vertex(pool[i]));
    }
  }

private:
  void add_line(const std::vector<std::string>& words, const std::string& where)
  {
    if(words.size() == 1)
      add_vertex(words[0], where, Exit_code::BAD_INPUT);
    else if(m_kind == Location_options::Kind::VERTICES)
      throw Command_error(Exit_code::BAD_INPUT, where + ": only a vertex index is allowed here");
    else if(words.size() == 4)
      add_face_location(words, where);
    else
      add_nearest_location(words, where, Exit_code::BAD_INPUT);
  }

  void add_face_location(const std::vector<std::string>& words, const std::string& where)
  {
    std::size_t f = 0;
    std::array<double, 3> b{};
    if(!parse_index(words[0], f) || f >= m_mesh.number_of_faces())
      throw Command_error(Exit_code::BAD_INPUT, where + ": '" + words[0] + "' is not a face index");
    double sum = 0;
    for(std::size_t k = 0; k < 3; ++k)
    {
      if(!parse_number(words[k + 1], b[k]) || b[k] < 0)
        throw Command_error(Exit_code::BAD_INPUT, where + ": '" + words[k + 1] + "' is not a barycentric coordinate");
      sum += b[k];
    }
    if(std::abs(sum - 1) > 1e-6) // allows for rounded digits; the sum is normalized below
      throw Command_error(Exit_code::BAD_INPUT, where + ": the sum of the barycentric coordinates is not 1");
    for(double& x : b)
      x /= sum;
    locations.push_back(at_face_location(Face_location(Face(static_cast<Mesh::size_type>(f)), b)));
  }

  const Mesh& m_mesh;
  Location_options::Kind m_kind;
  Point_projection m_projection;
};

} // namespace

void Location_options::declare(Option_descriptions& options) const
{
  using Texts = std::vector<std::string>;
  const std::string point = m_role + "-point", file = m_role + "-file", random = m_role + "-random";
  const bool are_vertices = m_kind == Kind::VERTICES;
  options.add_options()
    (m_role.c_str(),
     po::value<Texts>()->value_name("V[,V...]")->composing()->notifier(
       [option = "--" + m_role](const Texts& values) { check_vertices(values, option); }),
     "vertex indices, counted from 0, or 'all'");
  if(!are_vertices)
    options.add_options()
      (point.c_str(),
       po::value<Texts>()->value_name("X,Y,Z")->composing()->notifier(
         [option = "--" + point](const Texts& values) { check_points(values, option); }),
       "the location on the surface that is nearest to a point");
  if(!are_vertices && options.find_nothrow("snap", false) == nullptr) // the roles of a command share it
    options.add_options()("snap", "points may be farther from the surface than 1 % of the diagonal of the mesh");
  options.add_options()
    (file.c_str(), po::value<Texts>()->value_name("FILE")->composing(),
     are_vertices ? "a file with one vertex index per line, or a table of this program"
                  : "a file with one location per line: V, or X Y Z, or FACE B0 B1 B2 with barycentric coordinates; or "
                    "a table of this program")
    (random.c_str(), count_value(random, 1)->value_name("N"), "N different random vertices");
}

void declare_seed(Option_descriptions& options)
{
  options.add_options()("seed", count_value("seed", 0)->value_name("S")->default_value("0"),
                        "the seed of random choices");
}

bool is_seed_unused(const Arguments& arguments)
{
  return has(arguments, "seed") && !arguments["seed"].defaulted()
      && std::none_of(arguments.begin(), arguments.end(),
                      [](const auto& option) { return ends_with(option.first, "-random"); });
}

bool Location_options::are_given(const Arguments& arguments) const
{
  for(const char* ending : {"", "-point", "-file", "-random"})
    if(has(arguments, m_role + ending))
      return true;
  return false;
}

std::vector<Location> Location_options::locations(const Arguments& arguments, const Mesh& mesh,
                                                  const Console& console) const
{
  Location_reader reader(mesh, m_kind, has(arguments, "snap"), console);
  for(const std::string& value : all_values(arguments, m_role))
    for(const std::string& text : values_of(value))
    {
      if(text == "all")
        reader.add_all_vertices();
      else
        reader.add_vertex(text, "--" + m_role, Exit_code::BAD_USAGE);
    }
  for(const std::string& value : all_values(arguments, m_role + "-point"))
    reader.add_nearest_location(values_of(value), "--" + m_role + "-point " + value, Exit_code::BAD_USAGE);
  for(const std::string& file_name : all_values(arguments, m_role + "-file"))
    reader.add_file(file_name, m_role);
  reader.remark_on_snaps();
  if(has(arguments, m_role + "-random"))
  {
    const std::size_t n = count_argument_or(arguments, m_role + "-random", 1);
    // Targets should differ from the sources: each role draws from its own sequence.
    const std::uint64_t seed = count_argument_or(arguments, "seed", 0);
    const std::size_t first = reader.locations.size();
    reader.add_random_vertices(n, m_role == "target" ? ~seed : seed, "--" + m_role + "-random");
    console.note("--" + m_role + "-random: " + list_of_vertices(reader.locations, first));
  }
  return reader.locations;
}

std::vector<Location> Location_options::required_locations(const Arguments& arguments, const Mesh& mesh,
                                                  const Console& console) const
{
  if(!are_given(arguments))
    throw Command_error(Exit_code::BAD_USAGE, "no " + m_role + " is given; use --" + m_role + ", "
                                                + (m_kind == Kind::VERTICES ? "" : "--" + m_role + "-point, ")
                                                + "--" + m_role + "-file"
                                                + (m_kind == Kind::PLACES_AND_CURVES
                                                     ? ", --" + m_role + "-border, --" + m_role + "-curve"
                                                     : "")
                                                + " or --" + m_role + "-random");
  return locations(arguments, mesh, console);
}

std::vector<Vertex> Location_options::vertices(const Arguments& arguments, const Mesh& mesh,
                                               const Console& console) const
{
  return as_vertices(locations(arguments, mesh, console));
}

Point point_of(const Location& location, const Mesh& mesh)
{
  return location.is_vertex() ? mesh.point(location.vertex) : point_of(location.face_location, mesh);
}

Point point_of(const Face_location& location, const Mesh& mesh)
{
  const Mesh::Halfedge_index h = mesh.halfedge(location.first); // its source has the first coordinate
  const std::array<double, 3>& b = location.second;
  return CGAL::barycenter(mesh.point(mesh.source(h)), b[0], mesh.point(mesh.target(h)), b[1],
                          mesh.point(mesh.target(mesh.next(h))), b[2]);
}

Location as_location(const Face_location& location, const Mesh& mesh)
{
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon(); // as the package snaps coordinates
  Mesh::Halfedge_index h = mesh.halfedge(location.first);
  for(std::size_t k = 0; k < 3; ++k, h = mesh.next(h))
    if(location.second[k] >= 1 - rounding)
      return at_vertex(mesh.source(h));
  return at_face_location(location);
}

std::vector<Vertex> as_vertices(const std::vector<Location>& locations)
{
  std::vector<Vertex> result;
  for(const Location& p : locations)
  {
    if(!p.is_vertex())
      return {};
    result.push_back(p.vertex);
  }
  return result;
}

std::vector<Face_location> as_face_locations(const std::vector<Location>& locations, const Mesh& mesh)
{
  std::vector<Face_location> result;
  for(const Location& p : locations)
  {
    if(!p.is_vertex())
    {
      result.push_back(p.face_location);
      continue;
    }
    // the halfedge of an isolated vertex is null; that of a border vertex may have no face
    Mesh::Halfedge_index h = mesh.halfedge(p.vertex);
    if(!h.is_valid())
      throw Command_error(Exit_code::BAD_USAGE, "vertex " + std::to_string(p.vertex.idx())
                                                  + " has no face: it cannot be combined with points");
    if(mesh.is_border(h))
      h = mesh.prev(mesh.opposite(h));
    Face_location location(mesh.face(h), {0, 0, 0});
    Mesh::Halfedge_index corner = mesh.prev(mesh.halfedge(location.first)); // its target is the first corner
    for(std::size_t k = 0; k < 3; ++k, corner = mesh.next(corner))
      location.second[k] = mesh.target(corner) == p.vertex ? 1 : 0;
    result.push_back(location);
  }
  return result;
}

} // namespace geodesics_demo
