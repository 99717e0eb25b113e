// The subcommand distances.

#include "Command.h"
#include "Command_error.h"
#include "Distance_field.h"
#include "Drawing.h"
#include "Html_page.h"
#include "Output_files.h"
#include "Location_options.h"
#include "number_arguments.h"

#include <cstddef>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace geodesics_demo {

namespace {

const Location_options source_options("source");

// More lines would hide the surface and fill the disk: on a large mesh each has thousands of points.
constexpr std::size_t largest_number_of_isolines = 1000;

void declare(Option_descriptions& options)
{
  source_options.declare(options);
  declare_seed(options);
  options.add_options()
    ("radius", positive_value("radius")->value_name("R"), "only distances up to R")
    ("isolines", count_value("isolines", 0, largest_number_of_isolines)->value_name("N"),
     "N isolines in files with geometry, evenly spaced up to the largest distance (default: 20; at "
     "most 1000)")
    ("spacing", positive_value("spacing")->value_name("D"),
     "isolines at the distances D, 2 D, 3 D, ... instead; at most 1000");
  declare_html(options);
  declare_output(options, "a table .csv (default: to standard output); the surface with colors and isolines .ply, "
                          ".vtk, .obj");
}

std::vector<double> isoline_distances(const Arguments& arguments, double largest)
{
  if(!has(arguments, "spacing"))
    return evenly_spaced(count_argument_or(arguments, "isolines", 20), largest);
  const double spacing = positive_argument_or(arguments, "spacing", largest);
  if(largest / spacing > static_cast<double>(largest_number_of_isolines))
  {
    std::ostringstream text;
    text << "--spacing: more than " << largest_number_of_isolines << " lines up to the largest distance, " << largest
         << "; give " << largest / static_cast<double>(largest_number_of_isolines) << " or more";
    throw Command_error(Exit_code::BAD_USAGE, text.str());
  }
  std::vector<double> result;
  for(int i = 1; i * spacing < largest; ++i)
    result.push_back(i * spacing);
  return result;
}

void write_table(std::ostream& os, const Distance_field& field)
{
  os << "vertex,distance,source\n";
  for(std::size_t v = 0; v < field.distance.size(); ++v)
    os << v << ',' << field.distance[v] << ',' << source_number(field.source[v]) << '\n';
}

// The surface with its distances, followed by the isolines.
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

Html_page page_of(const std::string& file_name, const Mesh& mesh, const std::vector<Location>& sources,
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
  if(has(arguments, "isolines") && has(arguments, "spacing"))
    throw Command_error(Exit_code::BAD_USAGE, "--isolines and --spacing cannot be combined");
  Output_files files(output_names(arguments, html_names(arguments)), {"csv", "ply", "vtk", "obj", "html"});
  for(const char* option : {"isolines", "spacing"})
    files.remark_on_unused(arguments, option, {"ply", "vtk", "obj", "html"}, console);
  const Mesh mesh = read_mesh(mesh_argument(arguments), console);
  const std::vector<Location> sources = source_options.required_locations(arguments, mesh, console);
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
  "distances of all vertices from the nearest source",
  "The table has a line for each vertex: its index, its distance in the unit of the mesh ('inf' if no source reaches\n"
  "it), and the index of the source, counted from 0 in the order of the options below; -1 for none. Files with\n"
  "geometry have the same numbers for each vertex; -1 replaces 'inf' there.",
  "  surface_mesh_geodesics distances bunny.off --source 0 > distances.csv\n"
  "  surface_mesh_geodesics distances bunny.off --source-point -0.1,0.1,0 -o colors.ply -o colors.vtk --isolines 30\n"
  "  surface_mesh_geodesics distances bunny.off --source-random 10 --seed 7 --radius 0.2 -o near.csv\n"
  "  surface_mesh_geodesics distances bunny.off --source 0 --html distances.html\n",
  declare, run};

} // namespace geodesics_demo
