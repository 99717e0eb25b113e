// The subcommand matrix.

#include "Command.h"
#include "Command_error.h"
#include "Output_files.h"
#include "Location_options.h"
#include "number_arguments.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/tags.h>

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
  declare_output(options, "a table .csv (default: to standard output)");
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

template <typename Sources>
void write_matrix(std::ostream& os, const Solver& solver, const Sources& sources, const std::vector<Vertex>& targets,
                  Progress_bar& bar)
{
  for(std::size_t j = 0; j < targets.size(); ++j)
    os << (j == 0 ? "" : ",") << targets[j].idx();
  os << '\n';
  const auto write_row = [&](std::size_t i, const std::vector<double>& row)
  {
    for(std::size_t j = 0; j < row.size(); ++j)
      os << (j == 0 ? "" : ",") << row[j];
    os << '\n';
    bar.show(static_cast<double>(i + 1) / static_cast<double>(sources.size()));
    return static_cast<bool>(os); // stops when the disk is full
  };
  CGAL::Surface_mesh_geodesics::geodesic_distance_matrix<Tag>(solver, sources, targets, write_row);
}

template <typename Sources>
void write_near_pairs(std::ostream& os, const Solver& solver, const Sources& sources,
                      const std::vector<Vertex>& targets, double radius, Progress_bar& bar)
{
  os << "source,target,distance\n";
  const auto write_row = [&](std::size_t i, const std::vector<std::pair<std::size_t, double>>& row)
  {
    for(const std::pair<std::size_t, double>& entry : row)
      os << i << ',' << targets[entry.first].idx() << ',' << entry.second << '\n';
    bar.show(static_cast<double>(i + 1) / static_cast<double>(sources.size()));
    return static_cast<bool>(os);
  };
  CGAL::Surface_mesh_geodesics::sparse_geodesic_distance_matrix<Tag>(solver, sources, targets, radius, write_row);
}

template <typename Sources>
void write(const Arguments& arguments, const Mesh& mesh, const Sources& sources, const std::vector<Vertex>& targets,
           Output_files& files, const Console& console)
{
  const double radius = positive_argument_or(arguments, "radius", std::numeric_limits<double>::infinity());
  const Solver solver(mesh);
  files.write([&](std::ostream& os, const std::string&)
  {
    Progress_bar bar(console, "rows", 1);
    if(radius < std::numeric_limits<double>::infinity())
      write_near_pairs(os, solver, sources, targets, radius, bar);
    else
      write_matrix(os, solver, sources, targets, bar);
  });
}

void run(const Arguments& arguments, const Console& console)
{
  Output_files files(output_names(arguments), {"csv"});
  const Mesh mesh = read_mesh(mesh_argument(arguments), console);
  const std::vector<Location> sources = source_options.required_locations(arguments, mesh, console);
  const std::vector<Vertex> target_vertices = targets(arguments, mesh, sources, console);
  const std::vector<Vertex> source_vertices = as_vertices(sources);
  if(!source_vertices.empty())
    write(arguments, mesh, source_vertices, target_vertices, files, console);
  else
    write(arguments, mesh, as_face_locations(sources, mesh), target_vertices, files, console);
}

} // namespace

const Command matrix_command{
  "matrix",
  "distances between all sources and all targets",
  "The first line has the indices of the target vertices, and each further line the distances from one source ('inf'\n"
  "if there is no path), in the order of the options below. Without targets, the sources are the targets.",
  "  surface_mesh_geodesics matrix bunny.off --source 0,100,200 > matrix.csv\n"
  "  surface_mesh_geodesics matrix bunny.off --source-random 50 --target all -o matrix.csv\n"
  "  surface_mesh_geodesics matrix bunny.off --source all --radius 0.03 -o neighbors.csv\n",
  declare, run};

} // namespace geodesics_demo
