// The subcommand distances.

#include "Command.h"
#include "Command_error.h"
#include "Distance_field.h"
#include "Drawing.h"
#include "Html_page.h"
#include "Output_files.h"
#include "Place_options.h"
#include "number_arguments.h"

#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace geodesics_app {

namespace po = boost::program_options;

namespace {

const Place_options source_options("source");

void declare(Option_descriptions& options)
{
  source_options.declare(options);
  declare_seed(options);
  options.add_options()
    ("radius", po::value<std::string>()->value_name("R"), "only distances up to R")
    ("isolines", po::value<std::string>()->value_name("N"),
     "N lines of equal distance in files with geometry, evenly spaced up to the largest distance (default: 20)")
    ("spacing", po::value<std::string>()->value_name("D"), "lines at the distances D, 2 D, 3 D, ... instead");
  declare_html(options);
  declare_output(options, "a table .csv (default: to standard output); the surface with colours and isolines .ply, "
                          ".vtk, .obj");
}

// More lines than this would hide the surface, and are a mistake in the spacing.
constexpr double largest_number_of_isolines = 10000;

std::vector<double> isoline_distances(const Arguments& arguments, double largest)
{
  std::vector<double> result;
  if(has(arguments, "spacing"))
  {
    if(has(arguments, "isolines"))
      throw Command_error(Exit_code::BAD_USAGE, "--isolines and --spacing cannot be given together");
    const double spacing = positive_argument("spacing", arguments["spacing"].as<std::string>());
    if(largest / spacing > largest_number_of_isolines)
      throw Command_error(Exit_code::BAD_USAGE, "--spacing: more than 10000 lines up to the largest distance "
                                                  + std::to_string(largest));
    for(int i = 1; i * spacing < largest; ++i)
      result.push_back(i * spacing);
    return result;
  }
  const std::size_t n
    = has(arguments, "isolines") ? count_argument("isolines", arguments["isolines"].as<std::string>(), 0) : 20;
  if(static_cast<double>(n) > largest_number_of_isolines)
    throw Command_error(Exit_code::BAD_USAGE, "--isolines: more than 10000 lines");
  return evenly_spaced(n, largest);
}

void write_table(std::ostream& os, const Distance_field& field)
{
  os << "vertex,distance,source\n";
  for(std::size_t v = 0; v < field.distance.size(); ++v)
    os << v << ',' << field.distance[v] << ',' << source_number(field.source[v]) << '\n';
}

// the surface with its distances, and the isolines behind it.
Drawing drawing_of(const Mesh& mesh, const Distance_field& field, const std::vector<Isoline>& isolines)
{
  Drawing drawing;
  drawing.add_mesh(mesh);
  Drawing_column distance{"distance", false, field.distance}, source{"source", true, {}};
  Drawing_column line_distance{"distance", false, {}};
  for(const std::size_t s : field.source)
    source.values.push_back(source_number(s));
  const double largest = field.largest();
  for(const double d : field.distance)
    drawing.colors.push_back(color_of_distance(d, largest));
  for(const Isoline& line : isolines)
  {
    drawing.add_line(line.points);
    line_distance.values.push_back(line.distance);
  }
  for(const Isoline& line : isolines)
    distance.values.insert(distance.values.end(), line.points.size(), line.distance);
  drawing.colors.resize(drawing.points.size(), Color{0, 0, 0});
  source.values.resize(drawing.points.size(), -1);
  drawing.point_columns = {distance, source};
  drawing.line_columns = {line_distance};
  return drawing;
}

Html_page page_of(const std::string& file_name, const Mesh& mesh, const std::vector<Place>& sources,
                  const Distance_field& field, const std::vector<double>& limits, const Console& console)
{
  Html_page page;
  page.title = "Geodesic distances";
  page.subtitle = description_of(file_name, mesh);
  page.surface = surface_with_distances(mesh, sources, field);
  page.band_limits = limits;
  page.lines = {lines_on(page.surface, mesh, sources, limits, console)};
  page.dots = {dots_at("source", sources, mesh)};
  return page;
}

void run(const Arguments& arguments, const Console& console)
{
  const double radius = positive_argument_or(arguments, "radius", std::numeric_limits<double>::infinity());
  Output_files files(output_names(arguments, html_names(arguments)), {"csv", "ply", "vtk", "obj", "html"});
  const Mesh mesh = read_mesh(mesh_argument(arguments), console);
  const std::vector<Place> sources = source_options.required_places(arguments, mesh);
  const Distance_field field = distances_from(mesh, sources, radius, console);
  const std::vector<double> limits = isoline_distances(arguments, field.largest());
  Drawing drawing;
  if(files.have({"ply", "vtk", "obj"}))
    drawing = drawing_of(mesh, field, isolines_around(mesh, sources, limits, console));
  files.write([&](std::ostream& os, const std::string& format)
  {
    if(format == "csv")
      write_table(os, field);
    else if(format == "html")
      write_html_page(os, page_of(mesh_argument(arguments), mesh, sources, field, limits, console));
    else
      write_drawing(os, format, drawing);
  });
}

} // namespace

const Command distances_command{
  "distances",
  "distances of all vertices from the nearest of several sources",
  "The table has a line for each vertex: its number, its distance in the unit of the mesh ('inf' if no source\n"
  "reaches it), and the number of the source, counted from 0 in the order of the options below; -1 for none.\n"
  "Files with geometry have the numbers of the vertices; -1 stands for 'inf' there.",
  "  surface_mesh_geodesics distances bunny.off --source 0 > distances.csv\n"
  "  surface_mesh_geodesics distances bunny.off --source-point -0.1,0.1,0 -o colours.ply -o colours.vtk --isolines 30\n"
  "  surface_mesh_geodesics distances bunny.off --source-random 10 --seed 7 --radius 0.2 -o near.csv\n"
  "  surface_mesh_geodesics distances bunny.off --source 0 --html distances.html\n",
  declare, run};

} // namespace geodesics_app
