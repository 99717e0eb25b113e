// The subcommand remesh.

#include "Command.h"
#include "Command_error.h"
#include "Output_files.h"
#include "Program_mesh.h"
#include "number_arguments.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <functional>
#include <string>
#include <vector>

namespace geodesics_demo {

namespace {

void declare(Option_descriptions& options)
{
  options.add_options()
    ("number,n", count_value("number", 3)->value_name("N")->required(), "the number of vertices of the new mesh")
    ("iterations", count_value("iterations", 0, 1000000)->value_name("K")->default_value("10"),
     "how often the vertices are moved to the centers of their cells, at most; up to 1000000");
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

std::string reasons(const CGAL::Surface_mesh_geodesics::Geodesic_dual_report& report)
{
  std::string text;
  const auto add = [&](std::size_t n, const std::string& what)
  {
    if(n > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + what;
  };
  add(report.cells_that_are_not_disks.size(), "cells are not disks");
  add(report.cells_with_several_boundaries.size(), "cells have several boundary curves");
  add(report.cells_without_triangle.size(), "cells have no triangle");
  add(report.pairs_with_several_edges.size(), "pairs of cells share several edges");
  add(report.pairs_without_triangle.size(), "pairs of cells have no triangle");
  add(report.triples_with_several_vertices.size(), "triples of cells meet several times");
  return text.empty() ? "they do not form a surface" : text;
}

void run(const Arguments& arguments, const Console& console)
{
  const std::size_t n = count_argument_or(arguments, "number", 3);
  const unsigned int iterations = static_cast<unsigned int>(count_argument_or(arguments, "iterations", 10));
  Output_files files(output_names(arguments), {"off", "obj", "ply"});
  const Mesh mesh = read_mesh(mesh_argument(arguments), console);
  Mesh coarse;
  const CGAL::Surface_mesh_geodesics::Geodesic_dual_report report = [&]
  {
    Run_counting_visitor visitor(console, "remeshing", n + iterations + 1); // samples, iterations, the final diagram
    const auto np = CGAL::parameters::number_of_iterations(iterations).visitor(std::ref(visitor));
    return CGAL::Surface_mesh_geodesics::geodesic_remeshing(mesh, n, coarse, np);
  }();
  if(!report.is_manifold())
    throw Command_error(Exit_code::NO_RESULT, "the triangles between " + std::to_string(n)
                                                + " vertices form no mesh: " + reasons(report)
                                                + "; a larger --number helps");
  console.note("from " + std::to_string(mesh.number_of_vertices()) + " to "
               + std::to_string(coarse.number_of_vertices()) + " vertices, " + counted_faces(coarse.number_of_faces()));
  files.write([&](std::ostream& os, const std::string& format) { write_mesh(os, format, coarse); });
}

} // namespace

const Command remesh_command{
  "remesh",
  "a coarser mesh with even triangles",
  "Spreads vertices over the surface and moves them to the centers of their geodesic Voronoi cells. Three vertices\n"
  "whose cells meet form a triangle. The new mesh ends before a border of the surface.",
  "  surface_mesh_geodesics remesh bunny.off --number 1000 -o coarse.off\n"
  "  surface_mesh_geodesics remesh bunny.off --number 500 --iterations 30 -o coarse.ply\n",
  declare, run};

} // namespace geodesics_demo
