// The subcommand distances.

#include "Command.h"
#include "Command_error.h"
#include "Curve_options.h"
#include "Distance_field.h"
#include "Distance_levels.h"
#include "Drawing.h"
#include "Html_page.h"
#include "Location_columns.h"
#include "Location_options.h"
#include "Number_text.h"
#include "Obstacle_option.h"
#include "Output_files.h"
#include "Reachability.h"
#include "number_arguments.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace geodesics_demo {

namespace {

const Location_options source_options("source", Location_options::Kind::PLACES_AND_CURVES);

// More lines would hide the surface and fill the disk: on a large mesh each has thousands of points.
constexpr std::size_t largest_number_of_isolines = 1000;

void declare(Option_descriptions& options)
{
  source_options.declare(options);
  declare_curves(options, "source");
  declare_seed(options);
  options.add_options()
    ("signed", "negative distances on the left of the first curve; the curves have to separate the surface")
    ("radius", positive_value("radius")->value_name("R"), "only distances up to R")
    ("isolines", count_value("isolines", 0, largest_number_of_isolines)->value_name("N"),
     "isolines at about N distances in files of --lines and pages, at multiples of a round distance up to the largest "
     "one (at most 1000; default: 20)")
    ("spacing", positive_value("spacing")->value_name("D"),
     "isolines at the distances D, 2 D, 3 D, ... instead; at most 1000")
    ("lines", boost::program_options::value<std::vector<std::string>>()->value_name("FILE")->composing(),
     "the isolines in a file of their own, with --signed those on both sides: .obj, .ply, .vtk, .vtu");
  declare_obstacles(options);
  declare_walls(options);
  declare_html(options);
  declare_output(options, "a table .csv (default: to standard output); the surface with colors and distances .ply, "
                          ".vtu, .vtk, .obj");
}

// The distances of the isolines, of which none is needed beyond `largest`. Where this is an upper bound that is known
// before the run, a user who asks for too many lines learns it before the run, too.
std::vector<double> isoline_distances(const Arguments& arguments, double largest)
{
  if(!has(arguments, "spacing"))
    return at_round_distances(count_argument_or(arguments, "isolines", 20), largest);
  const double spacing = positive_argument_or(arguments, "spacing", largest);
  if(largest / spacing > static_cast<double>(largest_number_of_isolines))
  {
    std::ostringstream text;
    text << "--spacing: more than " << largest_number_of_isolines << " lines up to the distance " << largest
         << "; give " << largest / static_cast<double>(largest_number_of_isolines) << " or more";
    throw Command_error(Exit_code::BAD_USAGE, text.str());
  }
  std::vector<double> result;
  for(int i = 1; i * spacing < largest; ++i)
    result.push_back(i * spacing);
  return result;
}

void write_table(std::ostream& os, const Distance_field& field, const std::vector<Location>& sources)
{
  const bool has_sources = !field.source.empty(), has_feet = !field.foot.empty();
  const Location_columns columns("source_", has_feet ? field.foot : sources);
  os << "vertex,distance" << (has_sources ? ",source" + columns.names() : "") << '\n';
  for(std::size_t v = 0; v < field.distance.size(); ++v)
  {
    os << v << ',' << Number_text(field.distance[v]);
    if(has_sources)
      os << ',' << source_text(field.source[v]) << columns.cells(has_feet ? v : field.source[v]);
    os << '\n';
  }
}

// Distances with a sign take the colors from the largest one on the negative side to the largest one on the other.
Drawing drawing_of_surface(const Mesh& mesh, const Distance_field& field)
{
  Drawing drawing;
  drawing.add_mesh(mesh);
  Drawing_column source{"source", true, {}};
  source.values.reserve(field.source.size());
  for(const std::size_t s : field.source)
    source.values.push_back(source_number(s));
  const double largest = field.largest(), least = field.source.empty() ? -largest : 0;
  drawing.colors.reserve(field.distance.size());
  for(const double d : field.distance)
    drawing.colors.push_back(color_of_distance(d - least, largest - least));
  drawing.point_columns = {Drawing_column{"distance", false, field.distance}};
  if(!field.source.empty())
    drawing.point_columns.push_back(std::move(source));
  return drawing;
}

Drawing drawing_of_lines(const std::vector<Isoline>& isolines)
{
  Drawing drawing;
  Drawing_column distance{"distance", false, {}};
  for(const Isoline& line : isolines)
  {
    drawing.add_line(line.points);
    distance.values.push_back(line.distance);
  }
  drawing.line_columns = {distance};
  return drawing;
}

Html_page page_of(const std::string& file_name, const Mesh& mesh, const std::vector<Location>& sources,
                  const std::vector<Curve>& curves, const Obstacles& avoided, const Distance_run& run,
                  const std::vector<double>& limits)
{
  Html_page page;
  page.title = "Geodesic distances";
  page.subtitle = description_of(file_name, mesh);
  page.mesh = &mesh;
  page.avoided = avoided;
  page.surface = run.surface();
  page.band_limits = limits;
  page.lines = {run.lines_on(page.surface, limits), lines_of_walls(avoided.walls, mesh), lines_along(curves, mesh)};
  page.dots = {dots_at("source", sources, mesh)};
  return page;
}

// Pages show distances without a sign.
void check_curves(const Arguments& arguments, bool has_page)
{
  if(!has(arguments, "signed"))
    return;
  if(!are_curves_given(arguments, "source"))
    throw Command_error(Exit_code::BAD_USAGE, "--signed needs curves: --source-border or --source-curve");
  if(has_page)
    throw Command_error(Exit_code::BAD_USAGE,
                        "--signed cannot be combined with a page .html, which shows distances without a sign");
}

void run(const Arguments& arguments, const Console& console)
{
  const double radius = positive_argument_or(arguments, "radius", std::numeric_limits<double>::infinity());
  if(has(arguments, "isolines") && has(arguments, "spacing"))
    throw Command_error(Exit_code::BAD_USAGE, "--isolines and --spacing cannot be combined");
  const std::vector<std::string> line_names = all_values(arguments, "lines");
  const std::vector<std::string> pages = html_names(arguments);
  const bool has_output = has(arguments, "output") || !pages.empty() || line_names.empty();
  Output_files files(has_output ? output_names(arguments, pages) : std::vector<std::string>(),
                     {"csv", "ply", "vtu", "vtk", "obj", "html"});
  check_curves(arguments, files.have({"html"}));
  Output_files line_files(line_names, {"obj", "ply", "vtk", "vtu"});
  const bool has_lines = !line_names.empty() || files.have({"html"});
  for(const char* option : {"isolines", "spacing"})
    if(has(arguments, option) && !has_lines)
      console.note(std::string("--") + option + " has no effect without --lines or a page .html");
  const Mesh mesh = read_mesh(arguments, console);
  const bool has_curves = are_curves_given(arguments, "source"), is_signed = has(arguments, "signed");
  const std::vector<Location> sources = has_curves ? source_options.locations(arguments, mesh, console)
                                                   : source_options.required_locations(arguments, mesh, console);
  const Obstacles avoided = obstacles(arguments, mesh);
  // One propagation. From points, the lines are chosen before it and found on its way. Lines from curves, and pages of
  // surfaces that are refined, need distances inside of faces afterwards; between walls, the bound does not hold.
  const std::vector<Curve> curves
    = has_curves ? curves_of("source", arguments, mesh, sources, avoided, console) : std::vector<Curve>();
  const bool are_lines_chosen_before = has_lines && !has_curves && avoided.walls.empty();
  std::vector<double> limits;
  if(are_lines_chosen_before)
    limits = isoline_distances(arguments, (std::min)(radius, bound_of_distances(mesh, avoided.faces, sources)));
  // Signed distances are computed at first: if the curves do not separate the surface, nothing else is.
  std::unique_ptr<Distance_run> run;
  Distance_field without_lines;
  if(is_signed)
    without_lines = signed_distances_from(mesh, avoided, curves, radius, console);
  if(has_lines && has_curves)
    run.reset(new Distance_run(mesh, avoided, curves, radius, console));
  else if(has_lines && (!are_lines_chosen_before || (files.have({"html"}) && is_refined(mesh.number_of_faces()))))
    run.reset(new Distance_run(mesh, avoided, sources, radius, console));
  else if(has_lines)
    run.reset(new Distance_run(mesh, avoided, sources, radius, limits, console));
  else if(!is_signed)
    without_lines = has_curves ? distances_from(mesh, avoided, curves, radius, console)
                               : distances_from(mesh, avoided, sources, radius, console);
  const Distance_field& field = has_lines && !is_signed ? run->field() : without_lines;
  if(!has(arguments, "radius"))
    remark_on_unreached(mesh, field, has_obstacles(arguments), console);
  if(has_lines && !are_lines_chosen_before)
    limits = isoline_distances(arguments, field.largest());
  limits.erase(std::lower_bound(limits.begin(), limits.end(), field.largest()), limits.end());
  if(!line_names.empty())
  {
    const Drawing lines = drawing_of_lines(is_signed ? run->signed_isolines(limits) : run->isolines(limits));
    line_files.write([&](std::ostream& os, const std::string& format) { write_drawing(os, format, lines); });
  }
  files.write([&](std::ostream& os, const std::string& format)
  {
    if(format == "csv")
      write_table(os, field, sources);
    else if(format == "html")
      write_html_page(os, page_of(mesh_argument(arguments), mesh, sources, curves, avoided, *run, limits),
                      console);
    else
    {
      Drawing drawing = drawing_of_surface(mesh, field);
      if(format == "ply")
        drawing.add_quality(field.distance);
      write_drawing(os, format, drawing);
    }
  });
}

} // namespace

const Command distances_command{
  "distances",
  "distances of all vertices from the nearest source",
  "The table has a line for each vertex: its index, its distance in the unit of the mesh ('inf' if no source reaches\n"
  "it), the index of the source, counted from 0 in the order of the options below (-1 for none), and the vertex of\n"
  "the source, or its face and barycentric coordinates. Files with geometry have the distances, too; unreached is\n"
  "NaN. Where sources are curves, vertex and face are those of the nearest point of the curve. With --signed there\n"
  "are distances only, and '-inf' stands for vertices beyond the radius on the left.",
  "  surface_mesh_geodesics distances bunny.off --source 0 > distances.csv\n"
  "  surface_mesh_geodesics distances bunny.off --source-point -0.1,0.1,0 --snap -o colors.ply --lines lines.obj\n"
  "  surface_mesh_geodesics distances bunny.off --source-random 10 --seed 7 --radius 0.2 -o near.csv\n"
  "  surface_mesh_geodesics distances bunny.off --source 0 --html distances.html\n"
  "  surface_mesh_geodesics distances scan.off --source-border --source-curve cuts.obj -o colors.ply\n"
  "  surface_mesh_geodesics distances scan.off --source-border --spacing 0.01 --lines parallels.obj\n"
  "  surface_mesh_geodesics distances scan.off --source-curve loop.polylines.txt --signed --lines both_sides.ply\n",
  declare, run};

} // namespace geodesics_demo
