// The subcommand check.

#include "Command.h"
#include "Command_error.h"
#include "Curve_options.h"
#include "Distance_field.h"
#include "Input_file.h"
#include "Output_files.h"
#include "Location_options.h"
#include "Obstacle_option.h"
#include "Program_mesh.h"
#include "number_arguments.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace geodesics_demo {

namespace po = boost::program_options;

namespace {

using Certificate = CGAL::Surface_mesh_geodesics::Geodesic_distance_certificate<Mesh>;
using Condition = Certificate::Condition;
using Tag = CGAL::Parallel_if_available_tag; // the result does not depend on the tag

const Location_options source_options("source", Location_options::Kind::PLACES_AND_CURVES);

void declare(Option_descriptions& options)
{
  source_options.declare(options);
  declare_curves(options, "source");
  declare_seed(options);
  options.add_options()
    ("distances", po::value<std::string>()->value_name("FILE"),
     "a table with the columns 'vertex' and 'distance' (default: the distances that 'distances' computes)")
    ("radius", positive_value("radius")->value_name("R"), "distances above R are infinite")
    ("tolerance", positive_value("tolerance")->value_name("T"),
     "the largest violation, relative to distance and longest edge (default: 2^-40)");
  declare_obstacles(options);
  declare_walls(options);
  declare_output(options, "a table .csv (default: to standard output)");
}

// Reads a table of distances in the format of the subcommand distances.
class Distance_table
{
public:
  Distance_table(const std::string& file_name, std::size_t number_of_vertices)
    : m_file_name(file_name), m_distance(number_of_vertices, 0), m_is_known(number_of_vertices, false)
  {
    std::ifstream is = opened_text_file(file_name);
    std::string line;
    std::getline(is, line);
    read_names(line);
    for(m_line = 2; std::getline(is, line); ++m_line)
      if(!without_blanks(line).empty())
        read_distance(cells_of_row(line, ','));
    const auto missing = std::find(m_is_known.begin(), m_is_known.end(), false);
    if(missing != m_is_known.end())
      throw Command_error(Exit_code::BAD_INPUT, file_name + ": there is no distance for vertex "
                                                  + std::to_string(missing - m_is_known.begin()));
  }

  const std::vector<double>& distances() const { return m_distance; }

private:
  [[noreturn]] void complain(const std::string& what) const
  {
    throw Command_error(Exit_code::BAD_INPUT, m_file_name + ", line " + std::to_string(m_line) + ": " + what);
  }

  void read_names(const std::string& line)
  {
    const std::vector<std::string> names = cells_of_row(line, ',');
    for(const auto& [name, column] : {std::make_pair("vertex", &m_vertex_column),
                                      std::make_pair("distance", &m_distance_column)})
    {
      *column = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
      if(*column == names.size())
        complain(std::string("there is no column '") + name + "'");
    }
  }

  void read_distance(const std::vector<std::string>& row)
  {
    if(row.size() <= (std::max)(m_vertex_column, m_distance_column))
      complain("a value is missing");
    std::size_t v = 0;
    if(!parse_index(row[m_vertex_column], v) || v >= m_distance.size())
      complain("there is no vertex '" + row[m_vertex_column] + "'");
    if(m_is_known[v])
      complain("vertex " + std::to_string(v) + " occurs twice");
    m_is_known[v] = true;
    const std::string& text = row[m_distance_column];
    if(text == "inf" || text == "nan") // the certificate decides whether that is right
      m_distance[v] = text == "inf" ? std::numeric_limits<double>::infinity()
                                    : std::numeric_limits<double>::quiet_NaN();
    else if(!parse_number(text, m_distance[v]))
      complain("'" + text + "' is not a distance");
  }

  std::string m_file_name;
  std::size_t m_line = 1, m_vertex_column = 0, m_distance_column = 0;
  std::vector<double> m_distance;
  std::vector<bool> m_is_known;
};

// The sources are the curves, if there are any.
Certificate certificate_of(Mesh& mesh, const std::vector<double>& distances, const std::vector<Location>& sources,
                           const std::vector<Curve>& curves, const Obstacles& avoided, double radius)
{
  const auto map = mesh.add_property_map<Vertex, double>("v:checked_distance", 0).first;
  for(const Vertex v : mesh.vertices())
    map[v] = distances[v];
  const auto np = CGAL::parameters::maximum_distance(radius).faces_to_avoid(avoided.faces)
                    .edges_to_avoid(avoided.walls);
  const std::vector<Vertex> vertices = as_vertices(sources);
  using CGAL::Surface_mesh_geodesics::certify_geodesic_distances;
  if(!curves.empty())
    return certify_geodesic_distances<Tag>(mesh, map, curves, np);
  return vertices.empty() ? certify_geodesic_distances<Tag>(mesh, map, as_face_locations(sources, mesh), np)
                          : certify_geodesic_distances<Tag>(mesh, map, vertices, np);
}

void write_table(std::ostream& os, const Certificate& certificate)
{
  os << "condition,checks,worst_violation,vertex\n";
  for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
  {
    const Condition c = static_cast<Condition>(i);
    os << Certificate::name(c) << ',' << certificate.number_of_checks(c) << ',' << certificate.worst_violation(c)
       << ',';
    if(certificate.worst_vertex(c) != Mesh::null_vertex())
      os << certificate.worst_vertex(c).idx();
    os << '\n';
  }
}

const char* meaning_of_violation(Condition c)
{
  switch(c)
  {
  case Condition::REACH:
    return "the distance must be finite if and only if faces connect the vertex with a source";
  case Condition::SOURCES:
    return "the distance of a source is not zero";
  case Condition::EDGES:
    return "the distance is too long compared with that of a neighbor";
  case Condition::PAIRS_OF_FACES:
    return "the distance is too long compared with that of a vertex across an edge";
  case Condition::PATHS:
    return "the distance is not the length of a path to a source";
  case Condition::LOWER_BOUNDS:
    return "the distance is too long";
  case Condition::PROOF:
    return "the proof of the lower bounds fails at this vertex";
  case Condition::REVERSE:
    return "the distance in the reverse direction differs";
  }
  return "";
}

std::string complaint(const Certificate& certificate)
{
  std::ostringstream os;
  for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
  {
    const Condition c = static_cast<Condition>(i);
    if(!(certificate.worst_violation(c) >= certificate.worst_violation()))
      continue;
    os << "the distances are not certified: " << Certificate::name(c) << " is violated by "
       << certificate.worst_violation(c);
    if(certificate.worst_vertex(c) != Mesh::null_vertex())
      os << " at vertex " << certificate.worst_vertex(c).idx();
    os << ": " << meaning_of_violation(c);
    break;
  }
  return os.str();
}

void run(const Arguments& arguments, const Console& console)
{
  const double radius = positive_argument_or(arguments, "radius", std::numeric_limits<double>::infinity());
  const double tolerance = positive_argument_or(arguments, "tolerance", Certificate::default_tolerance);
  Output_files files(output_names(arguments), {"csv"});
  Mesh mesh = read_mesh(arguments, console);
  const bool has_curves = are_curves_given(arguments, "source");
  const std::vector<Location> sources = has_curves ? source_options.locations(arguments, mesh, console)
                                                   : source_options.required_locations(arguments, mesh, console);
  const Obstacles avoided = obstacles(arguments, mesh);
  const std::vector<Curve> curves
    = has_curves ? curves_of("source", arguments, mesh, sources, avoided, console) : std::vector<Curve>();
  const std::vector<double> distances
    = has(arguments, "distances")
        ? Distance_table(arguments["distances"].as<std::string>(), mesh.number_of_vertices()).distances()
      : has_curves ? distances_from(mesh, avoided, curves, radius, console).distance
                   : distances_from(mesh, avoided, sources, radius, console).distance;
  const Certificate certificate = [&]
  {
    const Work_sign sign(console, "certificate");
    return certificate_of(mesh, distances, sources, curves, avoided, radius);
  }();
  files.write([&](std::ostream& os, const std::string&) { write_table(os, certificate); });
  if(!certificate.is_certified(tolerance))
    throw Command_error(Exit_code::NO_RESULT, complaint(certificate));
}

} // namespace

const Command check_command{
  "check",
  "prove that distances are exact, without trusting them",
  "Certifies the distances of all vertices: a path proves that a distance is not too short, lower bounds prove that\n"
  "it is not too long. The table has a line for each condition: the number of checks, the worst violation (relative\n"
  "to distance and longest edge), and its vertex. The exit status is 1 if a violation is larger than the tolerance.\n"
  "\n"
  "conditions:\n"
  "  REACH           a distance is finite exactly where faces connect the vertex with a source\n"
  "  SOURCES         the distance of a source is not greater than zero\n"
  "  EDGES           along an edge, the distance grows by at most the length of the edge\n"
  "  PAIRS_OF_FACES  along a segment through two faces, it grows by at most the length of the segment\n"
  "  PATHS           a path of this length leads to a source: the distance is not too short\n"
  "  LOWER_BOUNDS    the distance is not greater than a lower bound: it is not too long\n"
  "  PROOF           the lower bounds are proved\n"
  "  REVERSE         the distances from some vertices to the sources are the same in reverse",
  "  surface_mesh_geodesics check bunny.off --source 0\n"
  "  surface_mesh_geodesics check bunny.off --source 0 --distances other_program.csv --tolerance 1e-9\n"
  "  surface_mesh_geodesics check scan.off --source-border\n",
  declare, run};

} // namespace geodesics_demo
