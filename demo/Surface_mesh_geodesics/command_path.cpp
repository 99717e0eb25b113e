// The subcommand path.

#include "Command.h"
#include "Command_error.h"
#include "Distance_field.h"
#include "Distance_levels.h"
#include "Drawing.h"
#include "Html_page.h"
#include "Location_columns.h"
#include "Location_options.h"
#include "Number_text.h"
#include "Obstacle_option.h"
#include "Output_files.h"
#include "Path_finder.h"
#include "Reachability.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
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
  declare_obstacles(options);
  declare_walls(options);
  declare_html(options);
  declare_output(options, "a table .csv (default: to standard output); the paths as lines .obj, .ply, .vtk, "
                          ".vtu, .polylines.txt");
}

struct Path
{
  double length; // -1 if no source reaches the target
  std::size_t source;
  std::vector<Point> points; // from the target to the source
};

Path path_to(const Path_finder& paths, const Location& target)
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

std::vector<Path> find_paths(const Path_finder& finder, const std::vector<Location>& targets, const Console& console)
{
  Progress_bar bar(console, "paths");
  std::vector<Path> paths;
  for(const Location& target : targets)
  {
    paths.push_back(path_to(finder, target));
    bar.show(static_cast<double>(paths.size()) / static_cast<double>(targets.size()));
  }
  return paths;
}

// A path finder that answers for the targets.
std::unique_ptr<Path_finder> finder_for(const Mesh& mesh, const Obstacles& avoided,
                                        const std::vector<Location>& sources,
                                        const std::vector<Location>& targets, const Console& console)
{
  std::unique_ptr<Path_finder> finder(new Path_finder(mesh));
  finder->avoid_faces(avoided.faces);
  finder->avoid_edges(avoided.walls);
  add_sources(*finder, sources);
  Progress_visitor visitor(console, "distances");
  if(as_vertices(targets).empty())
    finder->build_sequence_tree_for_faces(visitor);
  else
    finder->build_sequence_tree(visitor);
  return finder;
}

// Remarks on targets that no source reaches. If there is no other target, the question has no answer.
void check_reached(const Mesh& mesh, const std::vector<Location>& targets, const std::vector<Path>& paths,
                   bool avoids_faces, const Console& console)
{
  std::size_t n = 0, first = 0;
  for(std::size_t i = paths.size(); i-- > 0;)
    if(paths[i].length < 0)
    {
      ++n;
      first = i;
    }
  if(n == 0)
    return;
  const std::string text = n == 1 ? "no source reaches " + description_of(targets[first])
                                  : "no source reaches " + std::to_string(n) + " of " + std::to_string(targets.size())
                                      + " targets; the first one is " + description_of(targets[first]);
  if(n == targets.size())
    throw Command_error(Exit_code::NO_RESULT, text + reason_for_unreached(mesh, avoids_faces));
  console.note(text + reason_for_unreached(mesh, avoids_faces));
}

// A path from a source to itself is a point. Files of lines leave it out; if there is nothing else, they are empty.
void note_missing_lines(const std::vector<Path>& paths, const Console& console)
{
  if(std::none_of(paths.begin(), paths.end(), [](const Path& path) { return path.points.size() > 1; }))
    console.note("all paths are single points, which only tables have");
}

void write_paths_table(std::ostream& os, const std::vector<Location>& sources, const std::vector<Location>& targets,
                       const std::vector<Path>& paths)
{
  const Location_columns of_targets("target_", targets), of_sources("source_", sources);
  os << "target,source,length,points" << of_targets.names() << of_sources.names() << '\n';
  for(std::size_t i = 0; i < paths.size(); ++i)
  {
    os << i << ',' << source_text(paths[i].source) << ',';
    if(paths[i].length < 0)
      os << "inf";
    else
      os << Number_text(paths[i].length);
    os << ',' << paths[i].points.size() << of_targets.cells(i) << of_sources.cells(paths[i].source) << '\n';
  }
}

void write_points_table(std::ostream& os, const std::vector<Location>& sources, const std::vector<Location>& targets,
                        const std::vector<Path>& paths)
{
  const Location_columns of_targets("target_", targets), of_sources("source_", sources);
  os << "target,source,point,x,y,z" << of_targets.names() << of_sources.names() << '\n';
  for(std::size_t i = 0; i < paths.size(); ++i)
    for(std::size_t j = 0; j < paths[i].points.size(); ++j)
    {
      const Point& p = paths[i].points[j];
      os << i << ',' << source_text(paths[i].source) << ',' << j << ',' << Number_text(p.x()) << ','
         << Number_text(p.y()) << ',' << Number_text(p.z()) << of_targets.cells(i)
         << of_sources.cells(paths[i].source) << '\n';
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

// The vertex of a location; -1 for a point of a face.
double vertex_number(const std::vector<Location>& locations, std::size_t i)
{
  return locations[i].is_vertex() ? static_cast<double>(locations[i].vertex.idx()) : -1.;
}

// A path of length zero, from a source to itself, is not a line.
Drawing drawing_of(const std::vector<Location>& sources, const std::vector<Location>& targets,
                   const std::vector<Path>& paths)
{
  Drawing drawing;
  Drawing_column target{"target", true, {}}, source{"source", true, {}}, length{"length", false, {}};
  Drawing_column target_vertex{"target_vertex", true, {}}, source_vertex{"source_vertex", true, {}};
  for(std::size_t i = 0; i < paths.size(); ++i)
  {
    if(paths[i].points.size() < 2)
      continue;
    drawing.add_line(paths[i].points);
    target.values.push_back(static_cast<double>(i));
    source.values.push_back(static_cast<double>(paths[i].source));
    length.values.push_back(paths[i].length);
    target_vertex.values.push_back(vertex_number(targets, i));
    source_vertex.values.push_back(vertex_number(sources, paths[i].source));
  }
  drawing.line_columns = {target, source, length, target_vertex, source_vertex};
  return drawing;
}

// Draws the paths on bands of distance, which they cross at right angles.
Html_page page_of(const std::string& file_name, const Mesh& mesh, const std::vector<Location>& sources,
                  const std::vector<Location>& targets, const std::vector<Path>& paths, const Obstacles& avoided,
                  const Distance_run& run)
{
  Html_page page;
  page.title = "Shortest paths";
  page.subtitle = description_of(file_name, mesh);
  page.mesh = &mesh;
  page.avoided = avoided;
  page.surface = run.surface();
  page.band_limits = at_round_distances(20, run.field().largest());
  Html_lines lines{"path", {}};
  for(const Path& path : paths)
    if(path.points.size() > 1)
      lines.lines.push_back(path.points);
  page.lines = {run.lines_on(page.surface, page.band_limits), lines_of_walls(avoided.walls, mesh), lines};
  page.dots = {dots_at("target", targets, mesh), dots_at("source", sources, mesh)};
  return page;
}

void run(const Arguments& arguments, const Console& console)
{
  Output_files files(output_names(arguments, html_names(arguments)),
                     {"csv", "obj", "ply", "vtk", "vtu", "polylines.txt", "html"});
  files.remark_on_unused(arguments, "points", {"csv"}, console);
  const Mesh mesh = read_mesh(arguments, console);
  const std::vector<Location> sources = source_options.required_locations(arguments, mesh, console);
  const std::vector<Location> targets = target_options.required_locations(arguments, mesh, console);
  const Obstacles avoided = obstacles(arguments, mesh);
  // One propagation: that of the page answers for the targets, too.
  std::unique_ptr<Distance_run> distances;
  if(files.have({"html"}))
    distances.reset(new Distance_run(mesh, avoided, sources, std::numeric_limits<double>::infinity(), console));
  const std::unique_ptr<Path_finder> finder
    = distances == nullptr ? finder_for(mesh, avoided, sources, targets, console) : std::unique_ptr<Path_finder>();
  const std::vector<Path> paths
    = find_paths(finder == nullptr ? distances->paths().finder : *finder, targets, console);
  check_reached(mesh, targets, paths, has_obstacles(arguments), console);
  if(files.have({"obj", "ply", "vtk", "vtu", "polylines.txt"}))
    note_missing_lines(paths, console);
  const Drawing drawing = drawing_of(sources, targets, paths);
  files.write([&](std::ostream& os, const std::string& format)
  {
    if(format == "csv")
      has(arguments, "points") ? write_points_table(os, sources, targets, paths)
                               : write_paths_table(os, sources, targets, paths);
    else if(format == "polylines.txt")
      write_polylines(os, paths);
    else if(format == "html")
      write_html_page(os, page_of(mesh_argument(arguments), mesh, sources, targets, paths, avoided, *distances),
                      console);
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
  "reaches the target), the number of its points, and the vertices of target and source, or their faces and\n"
  "barycentric coordinates. With --points, it lists all points instead, from the target to the source. If no source\n"
  "reaches any target, the exit status is 1, and nothing is written.",
  "  surface_mesh_geodesics path bunny.off --source 0 --target 100,200 -o paths.obj -o paths.csv\n"
  "  surface_mesh_geodesics path bunny.off --source 0 --target-point -0.1,0.1,0 --snap --points\n"
  "  surface_mesh_geodesics path bunny.off --source-random 3 --target-file locations.txt -o paths.polylines.txt\n"
  "  surface_mesh_geodesics path bunny.off --source 0 --target-random 20 --html paths.html\n",
  declare, run};

} // namespace geodesics_demo
