// The subcommand voronoi.

#include "Command.h"
#include "Command_error.h"
#include "Curve_options.h"
#include "Distance_field.h"
#include "Distance_levels.h"
#include "Face_tree.h"
#include "Html_page.h"
#include "Location_columns.h"
#include "Location_options.h"
#include "Obstacle_option.h"
#include "Output_files.h"
#include "Program_mesh.h"
#include "Reachability.h"
#include "number_arguments.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_cell_colors.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesics/write_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace geodesics_demo {

namespace {

using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

const Location_options site_options("site", Location_options::Kind::PLACES_AND_CURVES);

void declare(Option_descriptions& options)
{
  site_options.declare(options);
  declare_curves(options, "site");
  declare_seed(options);
  options.add_options()
    ("weight", numbers_value("weight")->value_name("W[,W...]"),
     "a weight for each site, subtracted from its distances (default: the column weight of a table, or 0)")
    ("vertices", "the table has a line for each vertex of the mesh, with its site")
    ("tolerance", positive_value("tolerance")->value_name("T"),
     "the largest distance between lines in files and the curves (default: 1e-4 times the diagonal of the bounding "
     "box; at least 1e-9 times)")
    ("cell", count_value("cell", 0)->value_name("I"), "files .off and .polylines.txt hold the cell of this site alone")
    ("along-border", "boundaries in files .polylines.txt go on along the border of the mesh, and along walls");
  declare_obstacles(options);
  declare_walls(options);
  declare_html(options);
  declare_output(options, "a table .csv (default: to standard output); cells with colors and their boundaries .ply, "
                          ".vtk; boundaries alone .obj; the mesh cut along them .off; boundaries of one cell after "
                          "the other .polylines.txt");
}

std::vector<double> weights(const Arguments& arguments, const std::vector<Location>& sites)
{
  std::vector<double> result = number_arguments(arguments, "weight");
  if(!result.empty() && result.size() != sites.size())
    throw Command_error(Exit_code::BAD_USAGE, "--weight: " + std::to_string(result.size()) + " weights for "
                                                + std::to_string(sites.size()) + " sites");
  if(result.empty())
    std::transform(sites.begin(), sites.end(), std::back_inserter(result), [](const Location& p) { return p.weight; });
  return result;
}

// The sites: points, then curves. Tables show the first point of a curve.
struct Sites
{
  std::vector<Location> locations;
  std::vector<Curve> curves; // all sites as curves, if there are curves
};

Sites sites_of(const Arguments& arguments, const Mesh& mesh, const Obstacles& avoided, const Console& console)
{
  Sites sites;
  if(!are_curves_given(arguments, "site"))
  {
    sites.locations = site_options.required_locations(arguments, mesh, console);
    return sites;
  }
  sites.locations = site_options.locations(arguments, mesh, console);
  sites.curves = curves_of("site", arguments, mesh, sites.locations, avoided, console);
  for(std::size_t i = sites.locations.size(); i < sites.curves.size(); ++i)
  {
    const Curve& c = sites.curves[i];
    sites.locations.push_back(c.segments().empty() ? Location{c.vertex(), {}}
                                                   : as_location(c.location(0, 0), mesh));
  }
  return sites;
}

void add_sites(Diagram& diagram, const Sites& all, const std::vector<double>& weights)
{
  const std::vector<Location>& sites = all.locations;
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    if(!all.curves.empty())
      diagram.add_site(all.curves[i], weights[i]);
    else if(sites[i].is_vertex())
      diagram.add_site(sites[i].vertex, weights[i]);
    else
      diagram.add_site(sites[i].face_location, weights[i]);
  }
}

void write_cells_table(std::ostream& os, const Mesh& mesh, const std::vector<Location>& sites, const Diagram& diagram)
{
  const Location_columns columns("", sites);
  os << "site" << columns.names() << ",x,y,z,weight,area,is_disk,neighbors\n";
  for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
  {
    const Point p = point_of(sites[i], mesh);
    os << i << columns.cells(i) << ',' << p.x() << ',' << p.y() << ',' << p.z() << ',' << diagram.weight(i)
       << ',' << diagram.area(i) << ',' << (diagram.is_disk(i) ? 1 : 0) << ',';
    const char* separator = "";
    for(const std::size_t j : diagram.adjacent_sites(i))
    {
      os << separator << j;
      separator = " ";
    }
    os << '\n';
  }
}

void write_vertices_table(std::ostream& os, const Mesh& mesh, const std::vector<Location>& sites,
                          const Diagram& diagram)
{
  const Location_columns columns("site_", sites);
  os << "vertex,site,distance" << columns.names() << '\n';
  for(const Vertex v : mesh.vertices())
  {
    const std::size_t site = diagram.nearest_site(v);
    os << v.idx() << ',';
    if(site == Diagram::null_site())
      os << "-1,inf" << columns.cells(sites.size()) << '\n';
    else
      os << site << ',' << diagram.distance_to_nearest_site(v) << columns.cells(site) << '\n';
  }
}

// The same table.
void write_labels_table(std::ostream& os, const Mesh& mesh, const std::vector<Location>& sites,
                        const std::vector<std::size_t>& labels, const std::vector<double>& distances)
{
  const Location_columns columns("site_", sites);
  os << "vertex,site,distance" << columns.names() << '\n';
  for(const Vertex v : mesh.vertices())
  {
    os << v.idx() << ',';
    if(labels[v] == Diagram::null_site())
      os << "-1,inf" << columns.cells(sites.size()) << '\n';
    else
      os << labels[v] << ',' << distances[v] << columns.cells(labels[v]) << '\n';
  }
}

// The cell of a site, or all of them, as a mesh.
void write_cells_mesh(std::ostream& os, const Diagram& diagram, const std::optional<std::size_t>& cell,
                      double tolerance)
{
  Mesh mesh;
  if(cell)
    diagram.cell_mesh(*cell, mesh, mesh.add_property_map<Face, Face>("f:face").first, tolerance);
  else
    diagram.cut(mesh, mesh.add_property_map<Face, std::size_t>("f:site").first, tolerance);
  CGAL::IO::write_OFF(os, mesh, CGAL::parameters::stream_precision(17));
}

// CGAL's format: one line per curve, with the number of points and the points.
void write_polylines(std::ostream& os, const Diagram& diagram, const std::optional<std::size_t>& cell, double tolerance,
                     bool along_border)
{
  for(std::size_t i = cell.value_or(0); i < (cell ? *cell + 1 : diagram.number_of_sites()); ++i)
    for(const Diagram::Boundary_polyline& line : diagram.boundary_polylines(i, tolerance, along_border))
    {
      os << line.locations.size();
      for(const Diagram::Face_location& location : line.locations)
        os << ' ' << diagram.point(location);
      os << '\n';
    }
}

void write_geometry(std::ostream& os, const std::string& format, const Diagram& diagram, double tolerance)
{
  namespace Geodesics = CGAL::Surface_mesh_geodesics;
  if(format != "obj")
    CGAL::IO::set_binary_mode(os); // the files are opened for bytes
  if(format == "ply")
    Geodesics::write_geodesic_Voronoi_diagram_PLY(os, diagram, tolerance);
  else if(format == "vtk")
    Geodesics::write_geodesic_Voronoi_diagram_VTK(os, diagram, tolerance);
  else
    Geodesics::write_geodesic_Voronoi_diagram_OBJ(os, diagram, tolerance);
}

// Adds the faces that paths avoid to a surface without them.
void add_avoided_faces(const Mesh& mesh, const std::vector<Face>& avoided, Html_surface& surface)
{
  const std::vector<char> is_avoided = flags_of_faces(mesh, avoided);
  surface.is_avoided.resize(avoided.empty() ? 0 : surface.triangles.size(), 0);
  for(std::size_t f = 0; f < is_avoided.size(); ++f)
  {
    if(is_avoided[f] == 0)
      continue;
    const std::size_t n = surface.points.size();
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(Face(static_cast<Mesh::size_type>(f)))))
      surface.points.push_back(mesh.point(v));
    surface.triangles.push_back({n, n + 1, n + 2});
    surface.cells.push_back(Diagram::null_site());
    surface.is_avoided.push_back(1);
  }
}

// The distances from the nearest site at points of the cut mesh.
class Distances_on_cut
{
public:
  Distances_on_cut(const Mesh& mesh, const Diagram& diagram, const Obstacles& avoided, const Html_surface& surface)
    : m_diagram(diagram), m_surface(surface),
      m_tree(mesh, avoided.faces), // at the rim of what paths avoid, the face that has a distance
      m_moved(avoided.walls.empty() ? 0. : 1e-8)
  {}

  double at(const Point& p) const
  {
    const Face_location location = m_tree.nearest_location(p);
    return m_diagram.nearest_site(location) == Diagram::null_site() ? std::numeric_limits<double>::infinity()
                                                                    : m_diagram.distance_to_nearest_site(location);
  }

  // A query on a wall answers for its nearest side. A point that has been moved into its triangle by a part of 10^-8 is
  // on the side of the triangle, and its distance has changed by less than the numbers of a page can tell.
  //
  // Returns the distance at barycentric coordinates of a triangle, on its side of walls.
  double within(std::size_t t, std::array<double, 3> b) const
  {
    for(double& x : b)
      x = (1 - m_moved) * x + m_moved / 3;
    const std::array<std::size_t, 3>& corner = m_surface.triangles[t];
    return at(CGAL::barycenter(m_surface.points[corner[0]], b[0], m_surface.points[corner[1]], b[1],
                               m_surface.points[corner[2]], b[2]));
  }

  // Returns the distances of the first points, which have the first triangles. Without walls a point tells its
  // distance, with walls its last triangle.
  std::vector<double> of_points(std::size_t number_of_points, std::size_t number_of_triangles) const
  {
    std::vector<double> result;
    for(std::size_t v = 0; m_moved == 0 && v < number_of_points; ++v)
      result.push_back(at(m_surface.points[v]));
    result.resize(number_of_points, std::numeric_limits<double>::infinity());
    for(std::size_t t = 0; m_moved > 0 && t < number_of_triangles; ++t)
      for(std::size_t k = 0; k < 3; ++k)
      {
        std::array<double, 3> b{};
        b[k] = 1;
        result[m_surface.triangles[t][k]] = within(t, b);
      }
    return result;
  }

private:
  const Diagram& m_diagram;
  const Html_surface& m_surface;
  Face_tree m_tree;
  double m_moved;
};

// The mesh cut along the arcs, with the distance from the nearest site at each point. The diagram has no faces that
// paths avoid; they come last, so that they are drawn all the same.
Html_surface cut_surface(const Mesh& mesh, const Diagram& diagram, const Obstacles& avoided, double tolerance)
{
  Mesh cut;
  auto site = cut.add_property_map<Face, std::size_t>("f:site").first;
  diagram.cut(cut, site, tolerance);
  Html_surface surface;
  for(const Vertex v : cut.vertices())
    surface.points.push_back(cut.point(v));
  for(const Face f : cut.faces())
  {
    const Mesh::Halfedge_index h = cut.halfedge(f);
    surface.triangles.push_back({cut.source(h).idx(), cut.target(h).idx(), cut.target(cut.next(h)).idx()});
    surface.cells.push_back(site[f]);
  }
  const Distances_on_cut distances(mesh, diagram, avoided, surface);
  const std::size_t first_avoided = surface.triangles.size(), first_point = surface.points.size();
  add_avoided_faces(mesh, avoided.faces, surface);
  if(!is_refined(surface.triangles.size()))
  {
    surface.distances = distances.of_points(first_point, first_avoided);
    surface.distances.resize(surface.points.size(), std::numeric_limits<double>::infinity());
    return surface;
  }
  return refined(surface, [&](std::size_t t, const std::array<double, 3>& b)
  {
    return t >= first_avoided ? std::numeric_limits<double>::infinity() : distances.within(t, b);
  });
}

Html_page page_of(const std::string& file_name, const Mesh& mesh, const Sites& sites, const Diagram& diagram,
                  const Obstacles& avoided, double tolerance)
{
  Html_page page;
  page.title = "Geodesic Voronoi diagram";
  page.subtitle = description_of(file_name, mesh);
  page.mesh = &mesh;
  page.avoided = avoided;
  page.surface = cut_surface(mesh, diagram, avoided, tolerance);
  page.cell_colors = CGAL::Surface_mesh_geodesics::geodesic_Voronoi_cell_colors(diagram);
  Distance_field field;
  field.distance = page.surface.distances;
  page.band_limits = at_round_distances(9, field.largest());
  Html_lines arcs{"arc", {}};
  for(const Diagram::Edge& edge : diagram.edges())
  {
    arcs.lines.emplace_back();
    edge.polyline(tolerance, std::back_inserter(arcs.lines.back()));
  }
  page.lines = {arcs, lines_of_walls(avoided.walls, mesh)};
  if(!sites.curves.empty())
    page.lines.push_back(lines_along(sites.curves, mesh));
  page.dots = {dots_at("site", sites.locations, mesh)};
  return page;
}

// The number of points of a curve grows with the square root of 1 / tolerance: the limit prevents huge files.
double tolerance_of(const Arguments& arguments, const Mesh& mesh)
{
  const double size = diagonal(mesh), smallest = 1e-9 * size, usual = 1e-4 * size;
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

// The number of a site that is given, if one is.
std::optional<std::size_t> cell_of(const Arguments& arguments, std::size_t number_of_sites)
{
  if(!has(arguments, "cell"))
    return std::nullopt;
  const std::size_t cell = count_argument_or(arguments, "cell", 0);
  if(cell >= number_of_sites)
    throw Command_error(Exit_code::BAD_USAGE, "--cell: there is no site " + std::to_string(cell) + ", but "
                                                + std::to_string(number_of_sites) + ", counted from 0");
  return cell;
}

// Writes the table of vertices without a diagram, which would take longer.
void write_labels(const Mesh& mesh, const Obstacles& avoided, const Sites& all,
                  const std::vector<double>& weights, Output_files& files, const Console& console)
{
  const std::vector<Location>& sites = all.locations;
  std::vector<std::size_t> labels(mesh.number_of_vertices());
  std::vector<double> distances(mesh.number_of_vertices());
  const auto index = get(boost::vertex_index, mesh);
  const auto label_map = boost::make_iterator_property_map(labels.begin(), index);
  const auto distance_map = boost::make_iterator_property_map(distances.begin(), index);
  const std::vector<Vertex> vertices = as_vertices(sites);
  Progress_visitor visitor(console, "distances");
  const auto np = CGAL::parameters::vertex_distance_map(distance_map).site_weights(weights)
                    .faces_to_avoid(avoided.faces).edges_to_avoid(avoided.walls).visitor(std::ref(visitor));
  if(!all.curves.empty())
    CGAL::Surface_mesh_geodesics::geodesic_Voronoi_labels(mesh, label_map, all.curves, np);
  else if(!vertices.empty())
    CGAL::Surface_mesh_geodesics::geodesic_Voronoi_labels(mesh, label_map, vertices, np);
  else
    CGAL::Surface_mesh_geodesics::geodesic_Voronoi_labels(mesh, label_map, as_face_locations(sites, mesh), np);
  files.write([&](std::ostream& os, const std::string&) { write_labels_table(os, mesh, sites, labels, distances); });
  const std::size_t n = static_cast<std::size_t>(std::count(labels.begin(), labels.end(), Diagram::null_site()));
  remark_on_unreached(mesh, n, !avoided.faces.empty() || !avoided.walls.empty(), console);
}

std::size_t number_of_unreached(const Mesh& mesh, const Diagram& diagram)
{
  std::size_t n = 0;
  for(const Vertex v : mesh.vertices())
    n += diagram.nearest_site(v) == Diagram::null_site() ? 1 : 0;
  return n;
}

void run(const Arguments& arguments, const Console& console)
{
  const std::vector<std::string> formats_with_curves{"ply", "vtk", "obj", "off", "polylines.txt", "html"};
  Output_files files(output_names(arguments, html_names(arguments)),
                     {"csv", "ply", "vtk", "obj", "off", "polylines.txt", "html"});
  files.remark_on_unused(arguments, "tolerance", formats_with_curves, console);
  files.remark_on_unused(arguments, "vertices", {"csv"}, console);
  files.remark_on_unused(arguments, "cell", {"off", "polylines.txt"}, console);
  files.remark_on_unused(arguments, "along-border", {"polylines.txt"}, console);
  const Mesh mesh = read_mesh(arguments, console);
  const double tolerance = tolerance_of(arguments, mesh);
  const Obstacles avoided = obstacles(arguments, mesh);
  const Sites all_sites = sites_of(arguments, mesh, avoided, console);
  const std::vector<Location>& sites = all_sites.locations;
  const std::optional<std::size_t> cell = cell_of(arguments, sites.size());
  const std::vector<double> weights_of_sites = weights(arguments, sites);
  if(has(arguments, "vertices") && !files.have(formats_with_curves))
    return write_labels(mesh, avoided, all_sites, weights_of_sites, files, console);
  Diagram diagram(mesh);
  diagram.avoid_faces(avoided.faces);
  diagram.avoid_edges(avoided.walls);
  add_sites(diagram, all_sites, weights_of_sites);
  {
    Progress_visitor visitor(console, "diagram");
    diagram.build(visitor);
  }
  remark_on_unreached(mesh, number_of_unreached(mesh, diagram), has_obstacles(arguments), console);
  const Work_sign sign(console, "output");
  files.write([&](std::ostream& os, const std::string& format)
  {
    if(format == "html")
      write_html_page(os, page_of(mesh_argument(arguments), mesh, all_sites, diagram, avoided, tolerance),
                      console);
    else if(format == "off")
      write_cells_mesh(os, diagram, cell, tolerance);
    else if(format == "polylines.txt")
      write_polylines(os, diagram, cell, tolerance, has(arguments, "along-border"));
    else if(format != "csv")
      write_geometry(os, format, diagram, tolerance);
    else if(has(arguments, "vertices"))
      write_vertices_table(os, mesh, sites, diagram);
    else
      write_cells_table(os, mesh, sites, diagram);
  });
}

} // namespace

const Command voronoi_command{
  "voronoi",
  "the geodesic Voronoi diagram of sites",
  "The table has a line for each site, counted from 0 in the order of the options below: its vertex (or its face\n"
  "and barycentric coordinates), its point, its weight, the area of its cell, whether the cell is a disk (1) or not\n"
  "(0), and the sites of the neighboring cells. With --vertices, it lists the nearest site of each vertex and the\n"
  "distance from that site minus the weight. With --site-border or --site-curve, curves are sites, after the others;\n"
  "the table has the first point of each.",
  "  surface_mesh_geodesics voronoi bunny.off --site-random 30 -o cells.ply -o cells.csv\n"
  "  surface_mesh_geodesics voronoi bunny.off --site 0,100,200 --weight 0,0.01,0.02 --vertices\n"
  "  surface_mesh_geodesics voronoi bunny.off --site-file locations.txt -o boundaries.obj\n"
  "  surface_mesh_geodesics voronoi scan.off --site-border --site-curve cuts.obj -o cells.ply -o boundaries.obj\n"
  "  surface_mesh_geodesics voronoi bunny.off --site-random 30 --cell 7 -o cell.off -o boundary.polylines.txt\n"
  "  surface_mesh_geodesics voronoi bunny.off --site-random 30 --html cells.html\n",
  declare, run};

} // namespace geodesics_demo
