// The subcommand matrix.

#include "Command.h"
#include "Command_error.h"
#include "Location_columns.h"
#include "Location_options.h"
#include "Matrix_store.h"
#include "Number_text.h"
#include "Obstacle_option.h"
#include "Output_files.h"
#include "Reachability.h"
#include "number_arguments.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace geodesics_demo {

namespace {

using Solver = CGAL::Surface_mesh_geodesics::Geodesic_distance_solver<Mesh>;
using Tag = CGAL::Parallel_if_available_tag; // the rows do not depend on the tag

const Location_options source_options("source"), target_options("target", Location_options::Kind::VERTICES);

void declare(Option_descriptions& options)
{
  source_options.declare(options);
  target_options.declare(options);
  declare_seed(options);
  options.add_options()("radius", positive_value("radius")->value_name("R"),
                        "only distances up to R: the table has a line for each, with the index of the source, "
                        "counted from 0, the target vertex, and the distance");
  declare_obstacles(options);
  declare_walls(options);
  declare_output(options, "a table .csv (default: to standard output)");
  declare_matrix_store(options);
}

// Targets are vertices. Without targets, the sources are the targets.
std::vector<Vertex> targets(const Arguments& arguments, const Mesh& mesh, const std::vector<Location>& sources,
                            const Console& console)
{
  if(target_options.are_given(arguments))
    return target_options.vertices(arguments, mesh, console);
  const std::vector<Vertex> result = as_vertices(sources);
  if(result.empty())
    throw Command_error(Exit_code::BAD_USAGE, "sources that are not vertices cannot be targets: use --target");
  return result;
}

// Counts the entries without a path, for a remark.
struct Unreached_pairs
{
  std::size_t number = 0;
};

// The first row has the target vertices, and the first column the sources.
template <typename Sources>
void write_matrix(std::ostream& os, const Solver& solver, const Sources& sources,
                  const std::vector<Location>& locations, const std::vector<Vertex>& targets,
                  Unreached_pairs& unreached, Progress_bar& bar)
{
  os << "source";
  for(const Vertex v : targets)
    os << ',' << v.idx();
  os << '\n';
  const auto write_row = [&](std::size_t i, const std::vector<double>& row)
  {
    os << name_of(locations[i]);
    for(const double d : row)
    {
      os << ',' << Number_text(d);
      unreached.number += d < std::numeric_limits<double>::infinity() ? 0 : 1;
    }
    os << '\n';
    bar.show(static_cast<double>(i + 1) / static_cast<double>(sources.size()));
    return static_cast<bool>(os); // stops when the disk is full
  };
  CGAL::Surface_mesh_geodesics::geodesic_distance_matrix<Tag>(solver, sources, targets, write_row);
}

template <typename Sources>
void write_near_pairs(std::ostream& os, const Solver& solver, const Sources& sources,
                      const std::vector<Location>& locations, const std::vector<Vertex>& targets, double radius,
                      Progress_bar& bar)
{
  const Location_columns columns("source_", locations);
  os << "source,target,distance" << columns.names() << '\n';
  const auto write_row = [&](std::size_t i, const std::vector<std::pair<std::size_t, double>>& row)
  {
    for(const std::pair<std::size_t, double>& entry : row)
      os << i << ',' << targets[entry.first].idx() << ',' << Number_text(entry.second) << columns.cells(i)
         << '\n';
    bar.show(static_cast<double>(i + 1) / static_cast<double>(sources.size()));
    return static_cast<bool>(os);
  };
  CGAL::Surface_mesh_geodesics::sparse_geodesic_distance_matrix<Tag>(solver, sources, targets, radius, write_row);
}

template <typename Sources>
void write(const Arguments& arguments, const Mesh& mesh, const Sources& sources, const std::vector<Location>& locations,
           const std::vector<Vertex>& targets, Output_files& files, const Console& console)
{
  Unreached_pairs unreached;
  const std::size_t sources_times_targets = sources.size() * targets.size();
  const double radius = positive_argument_or(arguments, "radius", std::numeric_limits<double>::infinity());
  const Obstacles avoided = obstacles(arguments, mesh);
  const Solver solver = Solver::avoiding_edges(mesh, avoided.walls, avoided.faces);
  files.write([&](std::ostream& os, const std::string&)
  {
    Progress_bar bar(console, "rows", 1);
    if(radius < std::numeric_limits<double>::infinity())
      write_near_pairs(os, solver, sources, locations, targets, radius, bar);
    else
      write_matrix(os, solver, sources, locations, targets, unreached = Unreached_pairs(), bar);
  });
  if(unreached.number > 0 && unreached.number == sources_times_targets)
    throw Command_error(Exit_code::NO_RESULT, "no source reaches any target"
                                                + reason_for_unreached(mesh, has_obstacles(arguments)));
  if(unreached.number > 0)
    console.note(std::to_string(unreached.number) + " of " + std::to_string(sources_times_targets)
                 + " pairs have no path" + reason_for_unreached(mesh, has_obstacles(arguments)));
}

bool needs_mesh(const Arguments& arguments)
{
  return !has(arguments, "meshes") && !has(arguments, "status") && !has(arguments, "verify");
}

void run(const Arguments& arguments, const Console& console)
{
  check_matrix_store_options(arguments);
  if(works_on_stored_matrix(arguments))
  {
    run_on_stored_matrix(arguments, [&](const Mesh& mesh)
    {
      Matrix_places places;
      places.sources = source_options.required_locations(arguments, mesh, console);
      places.targets = targets(arguments, mesh, places.sources, console);
      return places;
    }, console);
    return;
  }
  Output_files files(output_names(arguments), {"csv"});
  const Mesh mesh = read_mesh(arguments, console);
  const std::vector<Location> sources = source_options.required_locations(arguments, mesh, console);
  const std::vector<Vertex> target_vertices = targets(arguments, mesh, sources, console);
  const std::vector<Vertex> source_vertices = as_vertices(sources);
  if(!source_vertices.empty())
    write(arguments, mesh, source_vertices, sources, target_vertices, files, console);
  else
    write(arguments, mesh, as_face_locations(sources, mesh), sources, target_vertices, files, console);
}

} // namespace

const Command matrix_command{
  "matrix",
  "distances between all sources and all targets",
  "The first line has the indices of the target vertices. Each further line begins with a source: a vertex, or a face\n"
  "and barycentric coordinates. The distances from it follow ('inf' if there is no path). Sources and targets are in\n"
  "the order of the options below. Without targets, the sources are the targets. If no source reaches any target,\n"
  "the exit status is 1.\n\n"
  "--store writes rows into a folder instead, as NumPy files in which other calls and other machines compute what is\n"
  "missing: after Ctrl-C, in array jobs, and with mpirun. The manual (Planning Bigger) describes the folder.",
  "  surface_mesh_geodesics matrix bunny.off --source 0,100,200 > matrix.csv\n"
  "  surface_mesh_geodesics matrix bunny.off --source-random 50 --target all -o matrix.csv\n"
  "  surface_mesh_geodesics matrix bunny.off --source all --radius 0.03 -o neighbors.csv\n"
  "  surface_mesh_geodesics matrix bunny.off --source all --store distances --float32\n"
  "  surface_mesh_geodesics matrix --status distances\n",
  declare, run, needs_mesh};

} // namespace geodesics_demo
