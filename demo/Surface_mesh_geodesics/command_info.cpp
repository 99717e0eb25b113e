// The subcommand info.

#include "Command.h"
#include "Output_files.h"
#include "Program_mesh.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace geodesics_demo {

namespace {

namespace Processing = CGAL::Polygon_mesh_processing;

using Table = std::vector<std::pair<std::string, std::string>>;

void declare(Option_descriptions& options)
{
  declare_output(options, "a table .csv (default: to standard output)");
}

template <typename Number>
void add(Table& table, const std::string& name, const Number& value)
{
  std::ostringstream text;
  text.precision(17);
  text << value;
  table.emplace_back(name, text.str());
}

void add_counts(Table& table, Mesh& mesh)
{
  std::size_t isolated = 0;
  for(const Vertex v : mesh.vertices())
    isolated += mesh.is_isolated(v) ? 1 : 0;
  auto component = mesh.add_property_map<Face, std::size_t>("f:component").first;
  std::vector<Mesh::Halfedge_index> borders;
  Processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  const long euler = static_cast<long>(mesh.number_of_vertices() - isolated)
                   - static_cast<long>(mesh.number_of_edges()) + static_cast<long>(mesh.number_of_faces());
  add(table, "vertices", mesh.number_of_vertices());
  add(table, "edges", mesh.number_of_edges());
  add(table, "faces", mesh.number_of_faces());
  add(table, "isolated_vertices", isolated);
  add(table, "components", Processing::connected_components(mesh, component));
  add(table, "borders", borders.size());
  add(table, "euler_characteristic", euler);
}

void add_lengths(Table& table, const Mesh& mesh)
{
  double shortest = std::numeric_limits<double>::infinity(), longest = 0, sum = 0;
  for(const Mesh::Edge_index e : mesh.edges())
  {
    const double length = Processing::edge_length(mesh.halfedge(e), mesh);
    shortest = (std::min)(shortest, length);
    longest = (std::max)(longest, length);
    sum += length;
  }
  add(table, "shortest_edge", shortest);
  add(table, "mean_edge", sum / static_cast<double>(mesh.number_of_edges()));
  add(table, "longest_edge", longest);
}

void add_measures(Table& table, const Mesh& mesh)
{
  double area = 0;
  std::size_t flat = 0;
  for(const Face f : mesh.faces())
  {
    const double a = Processing::face_area(f, mesh);
    area += a;
    flat += a > 0 ? 0 : 1;
  }
  const CGAL::Bbox_3 box = Processing::bbox(mesh);
  add(table, "faces_without_area", flat);
  add(table, "area", area);
  for(const auto& side : {std::make_pair("x", 0), std::make_pair("y", 1), std::make_pair("z", 2)})
  {
    add(table, std::string(side.first) + "_min", (box.min)(side.second));
    add(table, std::string(side.first) + "_max", (box.max)(side.second));
  }
}

void run(const Arguments& arguments, const Console& console)
{
  Output_files files(output_names(arguments), {"csv"});
  Mesh mesh = read_mesh(arguments, console);
  // Reject what the other subcommands reject.
  const CGAL::Surface_mesh_geodesics::Geodesic_distance_solver<Mesh> solver(mesh);
  Table table;
  add_counts(table, mesh);
  add_lengths(table, mesh);
  add_measures(table, mesh);
  files.write([&](std::ostream& os, const std::string&)
  {
    os << "property,value\n";
    for(const std::pair<std::string, std::string>& line : table)
      os << line.first << ',' << line.second << '\n';
  });
}

} // namespace

const Command info_command{
  "info",
  "statistics of a mesh: elements, components, borders, lengths, area",
  "Lengths and areas are in the unit of the mesh. The Euler characteristic does not count isolated vertices.",
  "  surface_mesh_geodesics info bunny.off\n"
  "  surface_mesh_geodesics info bunny.off -o bunny.csv\n",
  declare, run};

} // namespace geodesics_demo
