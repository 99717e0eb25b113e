// The subcommand voronoi.

#include "Command.h"
#include "Command_error.h"
#include "Distance_field.h"
#include "Face_tree.h"
#include "Html_page.h"
#include "Output_files.h"
#include "Location_options.h"
#include "Program_mesh.h"
#include "number_arguments.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_cell_colors.h>
#include <CGAL/Surface_mesh_geodesics/write_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace geodesics_demo {

namespace {

using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

const Location_options site_options("site");

void declare(Option_descriptions& options)
{
  site_options.declare(options);
  declare_seed(options);
  options.add_options()
    ("weight", numbers_value("weight")->value_name("W[,W...]"),
     "a weight for each site, subtracted from its distances (default: 0)")
    ("vertices", "the table has a line for each vertex of the mesh, with its site")
    ("tolerance", positive_value("tolerance")->value_name("T"),
     "the largest distance between lines in files and the curves (default: 1e-4 times the diagonal of the bounding "
     "box; at least 1e-9 times)");
  declare_html(options);
  declare_output(options, "a table .csv (default: to standard output); cells with colors and their boundaries .ply, "
                          ".vtk; boundaries alone .obj");
}

std::vector<double> weights(const Arguments& arguments, std::size_t number_of_sites)
{
  std::vector<double> result = number_arguments(arguments, "weight");
  if(!result.empty() && result.size() != number_of_sites)
    throw Command_error(Exit_code::BAD_USAGE, "--weight: " + std::to_string(result.size()) + " weights for "
                                                + std::to_string(number_of_sites) + " sites");
  result.resize(number_of_sites, 0);
  return result;
}

void add_sites(Diagram& diagram, const std::vector<Location>& sites, const std::vector<double>& weights)
{
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    if(sites[i].is_vertex())
      diagram.add_site(sites[i].vertex, weights[i]);
    else
      diagram.add_site(sites[i].face_location, weights[i]);
  }
}

void write_cells_table(std::ostream& os, const Mesh& mesh, const std::vector<Location>& sites, const Diagram& diagram)
{
  os << "site,x,y,z,weight,area,is_disk,neighbors\n";
  for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
  {
    const Point p = point_of(sites[i], mesh);
    os << i << ',' << p.x() << ',' << p.y() << ',' << p.z() << ',' << diagram.weight(i) << ',' << diagram.area(i)
       << ',' << (diagram.is_disk(i) ? 1 : 0) << ',';
    const char* separator = "";
    for(const std::size_t j : diagram.adjacent_sites(i))
    {
      os << separator << j;
      separator = " ";
    }
    os << '\n';
  }
}

void write_vertices_table(std::ostream& os, const Mesh& mesh, const Diagram& diagram)
{
  os << "vertex,site,distance\n";
  for(const Vertex v : mesh.vertices())
  {
    const std::size_t site = diagram.nearest_site(v);
    os << v.idx() << ',';
    if(site == Diagram::null_site())
      os << "-1,inf\n";
    else
      os << site << ',' << diagram.distance_to_nearest_site(v) << '\n';
  }
}

void write_geometry(std::ostream& os, const std::string& format, const Diagram& diagram, double tolerance)
{
  namespace Geodesics = CGAL::Surface_mesh_geodesics;
  if(format == "ply")
    Geodesics::write_geodesic_Voronoi_diagram_PLY(os, diagram, tolerance);
  else if(format == "vtk")
    Geodesics::write_geodesic_Voronoi_diagram_VTK(os, diagram, tolerance);
  else
    Geodesics::write_geodesic_Voronoi_diagram_OBJ(os, diagram, tolerance);
}

// The mesh cut along the arcs, with the distance from the nearest site at each point.
Html_surface cut_surface(const Mesh& mesh, const Diagram& diagram, double tolerance)
{
  Mesh cut;
  auto site = cut.add_property_map<Face, std::size_t>("f:site").first;
  diagram.cut(cut, site, tolerance);
  const Face_tree tree(mesh);
  const auto distance_at = [&](const Point& p)
  {
    const Face_location location = tree.nearest_location(p);
    return diagram.nearest_site(location) == Diagram::null_site() ? std::numeric_limits<double>::infinity()
                                                                  : diagram.distance_to_nearest_site(location);
  };
  Html_surface surface;
  for(const Vertex v : cut.vertices())
    surface.points.push_back(cut.point(v));
  for(const Face f : cut.faces())
  {
    const Mesh::Halfedge_index h = cut.halfedge(f);
    surface.triangles.push_back({cut.source(h).idx(), cut.target(h).idx(), cut.target(cut.next(h)).idx()});
    surface.cells.push_back(site[f]);
  }
  if(!is_refined(surface.triangles.size()))
  {
    for(const Point& p : surface.points)
      surface.distances.push_back(distance_at(p));
    return surface;
  }
  return refined(surface, [&](std::size_t t, const std::array<double, 3>& b)
  {
    const auto [p, q, r] = surface.triangles[t];
    return distance_at(CGAL::barycenter(surface.points[p], b[0], surface.points[q], b[1], surface.points[r], b[2]));
  });
}

Html_page page_of(const std::string& file_name, const Mesh& mesh, const std::vector<Location>& sites,
                  const Diagram& diagram, double tolerance)
{
  Html_page page;
  page.title = "Geodesic Voronoi diagram";
  page.subtitle = description_of(file_name, mesh);
  page.surface = cut_surface(mesh, diagram, tolerance);
  page.cell_colors = CGAL::Surface_mesh_geodesics::geodesic_Voronoi_cell_colors(diagram);
  Distance_field field;
  field.distance = page.surface.distances;
  page.band_limits = evenly_spaced(9, field.largest());
  Html_lines arcs{"arc", {}};
  for(const Diagram::Edge& edge : diagram.edges())
  {
    arcs.lines.emplace_back();
    edge.polyline(tolerance, std::back_inserter(arcs.lines.back()));
  }
  page.lines = {arcs};
  page.dots = {dots_at("site", sites, mesh)};
  return page;
}

// The number of points of a curve grows with the square root of 1 / tolerance: the limit prevents huge files.
double tolerance_of(const Arguments& arguments, const Mesh& mesh)
{
  const double size = extent(mesh), smallest = 1e-9 * size, usual = 1e-4 * size;
  const double result
    = positive_argument_or(arguments, "tolerance", usual > 0 ? usual : 1); // a mesh of size zero accepts any tolerance
  if(result < smallest)
  {
    std::ostringstream text;
    text << "--tolerance: " << result << " is too small for a mesh of this size; give " << smallest << " or more";
    throw Command_error(Exit_code::BAD_USAGE, text.str());
  }
  return result;
}

void run(const Arguments& arguments, const Console& console)
{
  Output_files files(output_names(arguments, html_names(arguments)), {"csv", "ply", "vtk", "obj", "html"});
  files.remark_on_unused(arguments, "tolerance", {"ply", "vtk", "obj", "html"}, console);
  files.remark_on_unused(arguments, "vertices", {"csv"}, console);
  const Mesh mesh = read_mesh(mesh_argument(arguments), console);
  const double tolerance = tolerance_of(arguments, mesh);
  const std::vector<Location> sites = site_options.required_locations(arguments, mesh, console);
  Diagram diagram(mesh);
  add_sites(diagram, sites, weights(arguments, sites.size()));
  {
    Progress_visitor visitor(console, "diagram");
    diagram.build(visitor);
  }
  const Work_sign sign(console, "output");
  files.write([&](std::ostream& os, const std::string& format)
  {
    if(format == "html")
      write_html_page(os, page_of(mesh_argument(arguments), mesh, sites, diagram, tolerance));
    else if(format != "csv")
      write_geometry(os, format, diagram, tolerance);
    else if(has(arguments, "vertices"))
      write_vertices_table(os, mesh, diagram);
    else
      write_cells_table(os, mesh, sites, diagram);
  });
}

} // namespace

const Command voronoi_command{
  "voronoi",
  "the geodesic Voronoi diagram of sites",
  "The table has a line for each site, counted from 0 in the order of the options below: its point, its weight, the\n"
  "area of its cell, whether the cell is a disk (1) or not (0), and the sites of the neighboring cells. With\n"
  "--vertices, it lists the nearest site of each vertex and the distance from that site minus the weight.",
  "  surface_mesh_geodesics voronoi bunny.off --site-random 30 -o cells.ply -o cells.csv\n"
  "  surface_mesh_geodesics voronoi bunny.off --site 0,100,200 --weight 0,0.01,0.02 --vertices\n"
  "  surface_mesh_geodesics voronoi bunny.off --site-file locations.txt -o boundaries.obj\n"
  "  surface_mesh_geodesics voronoi bunny.off --site-random 30 --html cells.html\n",
  declare, run};

} // namespace geodesics_demo
