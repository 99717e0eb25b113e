// The subcommand remesh.

#include "Command.h"
#include "Command_error.h"
#include "Console.h"
#include "Face_tree.h"
#include "Location_options.h"
#include "Obstacle_option.h"
#include "Output_files.h"
#include "Program_mesh.h"
#include "number_arguments.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace geodesics_demo {

namespace {

void declare(Option_descriptions& options)
{
  options.add_options()
    ("number,n", count_value("number", 3)->value_name("N")->required(),
     "the number of vertices of the new mesh; more are added where the shape needs them")
    ("iterations", count_value("iterations", 0, 1000000)->value_name("K")->default_value("10"),
     "how often the vertices are moved to the centers of their cells, at most; up to 1000000");
  declare_obstacles(options);
  declare_output(options, "the new mesh .off, .obj, .ply (default: OFF to standard output)");
}

void write_mesh(std::ostream& os, const std::string& format, const Mesh& mesh)
{
  const auto digits = CGAL::parameters::stream_precision(17);
  if(format == "off")
    CGAL::IO::write_OFF(os, mesh, digits);
  else if(format == "obj")
    CGAL::IO::write_OBJ(os, mesh, digits);
  else
    CGAL::IO::write_PLY(os, mesh, digits);
}

using Report = CGAL::Surface_mesh_geodesics::Geodesic_remeshing_report;

// Shows the fraction of the work that is done. The samples share a few propagations: the k-th one takes 1 / k of the
// first. Then each diagram takes about as long as the one before it. How many diagrams follow the relaxation is not
// known, so the bar moves more slowly after the expected ones.
class Remeshing_visitor
  : public CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
public:
  Remeshing_visitor(const Console& console, std::size_t number_of_samples, std::size_t number_of_iterations)
    : m_bar(console, "remeshing"), m_number_of_samples(number_of_samples),
      m_work_of_samples(1 + std::log(1. + static_cast<double>(number_of_samples))),
      m_number_of_diagrams(static_cast<double>(number_of_iterations) + 3)
  {}

  void on_propagation_begin(std::size_t number_of_vertices)
  {
    ++m_number_begun;
    m_number_of_vertices = static_cast<double>(number_of_vertices);
  }

  void on_progress(std::size_t number_of_visits, double)
  {
    const double diagrams = work_of_diagram * m_number_of_diagrams, whole = m_work_of_samples + diagrams;
    if(m_number_begun <= m_number_of_samples)
      return m_bar.show(std::log(static_cast<double>(m_number_begun)) / whole);
    const double done = static_cast<double>(m_number_begun - m_number_of_samples) - 1
                      + (std::min)(1., static_cast<double>(number_of_visits) / m_number_of_vertices);
    const double expected = m_number_of_diagrams - 1;
    const double part = done < expected ? done : expected + 1 - 1 / (1 + done - expected);
    m_bar.show((m_work_of_samples + work_of_diagram * part) / whole);
  }

private:
  static constexpr double work_of_diagram = 3; // propagations

  Progress_bar m_bar;
  std::size_t m_number_of_samples, m_number_begun = 0;
  double m_work_of_samples, m_number_of_diagrams, m_number_of_vertices = 1;
};

// The largest distance, in space, of a vertex or a center of a face of one mesh from the other mesh.
double distance_from(const Mesh& mesh, const Face_tree& tree, const Mesh& mesh_of_tree)
{
  double largest = 0;
  const auto add = [&](const Point& p)
  {
    const Point q = point_of(tree.nearest_location(p), mesh_of_tree);
    largest = (std::max)(largest, std::sqrt(CGAL::squared_distance(p, q)));
  };
  for(const Vertex v : mesh.vertices())
    if(!mesh.is_isolated(v))
      add(mesh.point(v));
  for(const Face f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    add(CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))));
  }
  return largest;
}

std::string short_number(double x)
{
  std::ostringstream text;
  text.precision(3);
  text << x;
  return text.str();
}

// The surface without some faces, for measuring: each face has vertices of its own, which no other face shares.
Mesh mesh_without(const Mesh& mesh, const std::vector<Face>& avoided)
{
  const std::set<Face> is_avoided(avoided.begin(), avoided.end());
  Mesh rest;
  for(const Face f : mesh.faces())
    if(is_avoided.count(f) == 0)
    {
      std::vector<Vertex> corners;
      for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
        corners.push_back(rest.add_vertex(mesh.point(v)));
      rest.add_face(corners);
    }
  return rest;
}

// Says what differs from what was asked for: numbers of vertices, and components that keep their faces.
void explain(const Report& report, const Console& console)
{
  if(report.number_of_split_vertices > 0)
    console.note("the surface touches itself at vertices; " + std::to_string(report.number_of_split_vertices)
                 + " vertices were added, so that the new mesh does not");
  if(report.number_of_added_samples > 0)
    console.note("with " + std::to_string(report.number_of_samples) + " vertices, cells would not be disks or would "
                 "meet several times; added " + std::to_string(report.number_of_added_samples));
  if(report.number_of_components_of_samples > 0)
    console.note(std::to_string(report.number_of_components_of_samples) + " of "
                 + std::to_string(report.number_of_components)
                 + " components have no more vertices than --number gives them; they stay as they are");
  const std::size_t number_of_lines = 5;
  for(std::size_t i = 0; i < report.kept_components.size() && i < number_of_lines; ++i)
  {
    const auto& c = report.kept_components[i];
    console.note("the component at " + short_number(c.point[0]) + "," + short_number(c.point[1]) + ","
                 + short_number(c.point[2]) + " stays as it is, with " + counted_faces(c.number_of_faces)
                 + ": its shape needs as many vertices as it has");
  }
  if(report.kept_components.size() > number_of_lines)
    console.note("so do " + std::to_string(report.kept_components.size() - number_of_lines) + " further components");
}

void run(const Arguments& arguments, const Console& console)
{
  const std::size_t n = count_argument_or(arguments, "number", 3);
  const unsigned int iterations = static_cast<unsigned int>(count_argument_or(arguments, "iterations", 10));
  Output_files files(output_names(arguments), {"off", "obj", "ply"});
  Mesh mesh = read_mesh(arguments, console);
  const std::vector<Face> avoided = avoided_faces(arguments, mesh);
  Mesh coarse;
  const Report report = [&]
  {
    Remeshing_visitor visitor(console, (std::min<std::size_t>)(n, mesh.number_of_vertices()), iterations);
    const auto np = CGAL::parameters::faces_to_avoid(avoided).number_of_iterations(iterations)
                      .visitor(std::ref(visitor));
    return CGAL::Surface_mesh_geodesics::geodesic_remeshing(mesh, n, coarse, np);
  }();
  if(coarse.is_empty())
    throw Command_error(Exit_code::NO_RESULT, "--avoid leaves no face");
  explain(report, console);
  console.note("from " + std::to_string(mesh.number_of_vertices()) + " to "
               + std::to_string(coarse.number_of_vertices()) + " vertices, " + counted_faces(coarse.number_of_faces()));
  files.write([&](std::ostream& os, const std::string& format) { write_mesh(os, format, coarse); });
  if(!console.shows_notes())
    return;
  const Work_sign sign(console, "measuring the distance of the two surfaces");
  if(!avoided.empty())
    mesh = mesh_without(mesh, avoided);
  const double distance = (std::max)(distance_from(mesh, Face_tree(coarse), coarse),
                                     distance_from(coarse, Face_tree(mesh), mesh));
  if(distance <= 1e-12 * diagonal(mesh))
    return console.note("the two surfaces are the same, up to rounding, at vertices and centers of faces");
  console.note("the two surfaces are at most " + short_number(distance) + " apart, "
               + short_number(100 * distance / diagonal(mesh))
               + " % of the diagonal of the mesh, measured at vertices and centers of faces");
}

} // namespace

const Command remesh_command{
  "remesh",
  "a coarser mesh with even triangles",
  "Spreads vertices over the surface and moves them to the centers of their geodesic Voronoi cells. Three vertices\n"
  "whose cells meet form a triangle. Where that gives no surface with the handles and borders of the given one, there\n"
  "are more vertices than asked for. Vertices on a border stay there. A component with few vertices stays as it is.",
  "  surface_mesh_geodesics remesh bunny.off --number 1000 -o coarse.off\n"
  "  surface_mesh_geodesics remesh bunny.off --number 500 --iterations 30 -o coarse.ply\n",
  declare, run};

} // namespace geodesics_demo
