// The subcommand path.

#include "Command.h"
#include "Command_error.h"
#include "Distance_field.h"
#include "Drawing.h"
#include "Html_page.h"
#include "Output_files.h"
#include "Path_finder.h"
#include "Location_options.h"

#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace geodesics_demo {

namespace {

const Location_options source_options("source"), target_options("target");

void declare(Option_descriptions& options)
{
  source_options.declare(options);
  target_options.declare(options);
  declare_seed(options);
  options.add_options()("points", "the table has a line for each point of each path");
  declare_html(options);
  declare_output(options, "a table .csv (default: to standard output); the paths as lines .obj, .ply, .vtk, "
                          ".polylines.txt");
}

struct Path
{
  double length; // -1 if no source reaches the target
  std::size_t source;
  std::vector<Point> points; // from the target to the source
};

Path path_to(Path_finder& paths, const Location& target)
{
  Path path{-1, Path_finder::no_source, {}};
  const auto output = std::back_inserter(path.points);
  if(target.is_vertex())
  {
    path.length = paths.shortest_path_points_to_source_points(target.vertex, output).first;
    path.source = paths.nearest_source_point(target.vertex);
  }
  else
  {
    const auto& [face, b] = target.face_location;
    path.length = paths.shortest_path_points_to_source_points(face, b, output).first;
    path.source = paths.nearest_source_point(face, b);
  }
  return path;
}

std::vector<Path> find_paths(const Mesh& mesh, const std::vector<Location>& sources,
                             const std::vector<Location>& targets, const Console& console)
{
  Path_finder finder(mesh);
  add_sources(finder, sources);
  {
    Progress_visitor visitor(console, "distances");
    if(as_vertices(targets).empty())
      finder.build_sequence_tree_for_faces(visitor);
    else
      finder.build_sequence_tree(visitor);
  }
  Progress_bar bar(console, "paths");
  std::vector<Path> paths;
  for(const Location& target : targets)
  {
    paths.push_back(path_to(finder, target));
    bar.show(static_cast<double>(paths.size()) / static_cast<double>(targets.size()));
  }
  return paths;
}

std::string source_name(const Path& path)
{
  return path.source == Path_finder::no_source ? "-1" : std::to_string(path.source);
}

void write_paths_table(std::ostream& os, const std::vector<Path>& paths)
{
  os << "target,source,length,points\n";
  for(std::size_t i = 0; i < paths.size(); ++i)
  {
    os << i << ',' << source_name(paths[i]) << ',';
    if(paths[i].length < 0)
      os << "inf";
    else
      os << paths[i].length;
    os << ',' << paths[i].points.size() << '\n';
  }
}

void write_points_table(std::ostream& os, const std::vector<Path>& paths)
{
  os << "target,source,point,x,y,z\n";
  for(std::size_t i = 0; i < paths.size(); ++i)
    for(std::size_t j = 0; j < paths[i].points.size(); ++j)
    {
      const Point& p = paths[i].points[j];
      os << i << ',' << source_name(paths[i]) << ',' << j << ',' << p.x() << ',' << p.y() << ',' << p.z() << '\n';
    }
}

// CGAL's format: one line per path, with the number of points and the points.
void write_polylines(std::ostream& os, const std::vector<Path>& paths)
{
  for(const Path& path : paths)
  {
    if(path.points.size() < 2)
      continue;
    os << path.points.size();
    for(const Point& p : path.points)
      os << ' ' << p;
    os << '\n';
  }
}

// A path of length zero, from a source to itself, is not a line.
Drawing drawing_of(const std::vector<Path>& paths)
{
  Drawing drawing;
  Drawing_column target{"target", true, {}}, source{"source", true, {}}, length{"length", false, {}};
  for(std::size_t i = 0; i < paths.size(); ++i)
  {
    if(paths[i].points.size() < 2)
      continue;
    drawing.add_line(paths[i].points);
    target.values.push_back(static_cast<double>(i));
    source.values.push_back(static_cast<double>(paths[i].source));
    length.values.push_back(paths[i].length);
  }
  drawing.line_columns = {target, source, length};
  return drawing;
}

// Draws the paths on bands of distance, which they cross at right angles.
Html_page page_of(const std::string& file_name, const Mesh& mesh, const std::vector<Location>& sources,
                  const std::vector<Location>& targets, const std::vector<Path>& paths, const Console& console)
{
  const Distance_field field
    = distances_from(mesh, sources, std::numeric_limits<double>::infinity(), console);
  Html_page page;
  page.title = "Shortest paths";
  page.subtitle = description_of(file_name, mesh);
  page.surface = surface_with_distances(mesh, sources, field);
  page.band_limits = evenly_spaced(20, field.largest());
  Html_lines lines{"path", {}};
  for(const Path& path : paths)
    if(path.points.size() > 1)
      lines.lines.push_back(path.points);
  page.lines = {lines_on(page.surface, mesh, sources, page.band_limits, console), lines};
  page.dots = {dots_at("target", targets, mesh), dots_at("source", sources, mesh)};
  return page;
}

void run(const Arguments& arguments, const Console& console)
{
  Output_files files(output_names(arguments, html_names(arguments)),
                     {"csv", "obj", "ply", "vtk", "polylines.txt", "html"});
  files.remark_on_unused(arguments, "points", {"csv"}, console);
  const Mesh mesh = read_mesh(mesh_argument(arguments), console);
  const std::vector<Location> sources = source_options.required_locations(arguments, mesh, console);
  const std::vector<Location> targets = target_options.required_locations(arguments, mesh, console);
  const std::vector<Path> paths = find_paths(mesh, sources, targets, console);
  const Drawing drawing = drawing_of(paths);
  files.write([&](std::ostream& os, const std::string& format)
  {
    if(format == "csv")
      has(arguments, "points") ? write_points_table(os, paths) : write_paths_table(os, paths);
    else if(format == "polylines.txt")
      write_polylines(os, paths);
    else if(format == "html")
      write_html_page(os, page_of(mesh_argument(arguments), mesh, sources, targets, paths, console));
    else
      write_drawing(os, format, drawing);
  });
}

} // namespace

const Command path_command{
  "path",
  "shortest paths from targets to their nearest sources",
  "The table has a line for each target: the indices of the target and of its nearest source, counted from 0 in the\n"
  "order of the options below, the length of the path in the unit of the mesh ('inf', and the source -1, if no source\n"
  "reaches the target), and the number of its points. With --points, it lists all points instead, from the target to\n"
  "the source.",
  "  surface_mesh_geodesics path bunny.off --source 0 --target 100,200 -o paths.obj -o paths.csv\n"
  "  surface_mesh_geodesics path bunny.off --source 0 --target-point -0.1,0.1,0 --points\n"
  "  surface_mesh_geodesics path bunny.off --source-random 3 --target-file locations.txt -o paths.polylines.txt\n"
  "  surface_mesh_geodesics path bunny.off --source 0 --target-random 20 --html paths.html\n",
  declare, run};

} // namespace geodesics_demo
