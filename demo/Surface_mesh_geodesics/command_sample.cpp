// The subcommand sample.

#include "Command.h"
#include "Command_error.h"
#include "Curve_options.h"
#include "Drawing.h"
#include "Location_options.h"
#include "Obstacle_option.h"
#include "Output_files.h"
#include "Reachability.h"
#include "number_arguments.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace geodesics_demo {

namespace {

const Location_options first_options("first", Location_options::Kind::VERTICES);

void declare(Option_descriptions& options)
{
  options.add_options()
    ("number,n", count_value("number", 1)->value_name("N"), "the number of samples, including the first ones")
    ("radius", positive_value("radius")->value_name("R"),
     "stop when no vertex is farther than R from its nearest sample")
    ("iterations", count_value("iterations", 0, 1000000)->value_name("K")->default_value("0"),
     "how often samples are moved to the centers of their cells afterwards, at most; first ones stay");
  first_options.declare(options);
  declare_curves(options, "first");
  declare_seed(options);
  declare_obstacles(options);
  declare_walls(options);
  declare_output(options, "a table .csv (default: to standard output); points .ply, .vtu, .vtk, .obj");
}

void write_table(std::ostream& os, const Mesh& mesh, const std::vector<Vertex>& samples)
{
  os << "sample,vertex,x,y,z\n";
  for(std::size_t i = 0; i < samples.size(); ++i)
  {
    const Point& p = mesh.point(samples[i]);
    os << i << ',' << samples[i].idx() << ',' << p.x() << ',' << p.y() << ',' << p.z() << '\n';
  }
}

Drawing drawing_of(const Mesh& mesh, const std::vector<Vertex>& samples)
{
  Drawing drawing;
  Drawing_column vertex{"vertex", true, {}};
  for(const Vertex v : samples)
  {
    drawing.points.push_back(mesh.point(v));
    vertex.values.push_back(static_cast<double>(v.idx()));
  }
  drawing.point_columns = {vertex};
  return drawing;
}

// Moves the samples behind the first ones to the centers of their cells. First samples stay, as curves of one location.
// Returns the covering radius of the samples then: a sampling that is complete already tells it.
double relax(const Mesh& mesh, std::size_t iterations, std::size_t number_of_first, const std::vector<Curve>& curves,
             const Obstacles& avoided, const Console& console, std::vector<Vertex>& samples)
{
  const auto behind_first = samples.begin() + static_cast<std::ptrdiff_t>(number_of_first);
  std::vector<Curve> fixed = curves;
  for(auto i = samples.begin(); i != behind_first; ++i)
    fixed.emplace_back(mesh, *i);
  {
    Run_counting_visitor visitor(console, "relaxation", iterations); // one propagation for each diagram
    CGAL::Surface_mesh_geodesics::geodesic_Lloyd_relaxation(
      mesh, std::vector<Vertex>(behind_first, samples.end()), behind_first,
      CGAL::parameters::first_curves(fixed).number_of_iterations(static_cast<unsigned int>(iterations))
        .faces_to_avoid(avoided.faces).edges_to_avoid(avoided.walls).visitor(std::ref(visitor)));
  }
  std::vector<Vertex> none;
  return CGAL::Surface_mesh_geodesics::geodesic_farthest_point_sampling(
    mesh, samples.size(), std::back_inserter(none),
    CGAL::parameters::first_samples(samples).first_curves(curves).faces_to_avoid(avoided.faces)
      .edges_to_avoid(avoided.walls));
}

// Returns the samples, and prints the covering radius.
std::vector<Vertex> samples_of(const Mesh& mesh, std::size_t n, double radius, std::size_t iterations,
                               const std::vector<Vertex>& first, const std::vector<Curve>& curves,
                               const Obstacles& avoided, const Console& console)
{
  std::vector<Vertex> samples = first;
  double covering_radius = 0;
  {
    Progress_bar bar(console, "samples", 1);
    const auto output = boost::make_function_output_iterator([&](Vertex v)
    {
      samples.push_back(v);
      bar.show(static_cast<double>(samples.size()) / static_cast<double>(n));
    });
    using CGAL::Surface_mesh_geodesics::geodesic_farthest_point_sampling;
    const auto np = CGAL::parameters::first_samples(first).covering_radius(radius).faces_to_avoid(avoided.faces)
                      .edges_to_avoid(avoided.walls);
    covering_radius = curves.empty() ? geodesic_farthest_point_sampling(mesh, n, output, np)
                                     : geodesic_farthest_point_sampling(mesh, n, output, np.first_curves(curves));
  }
  if(iterations > 0)
    covering_radius = relax(mesh, iterations, first.size(), curves, avoided, console, samples);
  if(samples.size() < n && !(radius > 0))
    console.note("--number: there are only " + counted_vertices(samples.size()));
  std::ostringstream text;
  text << samples.size() << (samples.size() == 1 ? " sample" : " samples");
  if(std::isfinite(covering_radius))
    text << "; the farthest vertex is " << covering_radius << " from its nearest one"
         << (curves.empty() ? "" : " or the nearest curve");
  else
    text << (samples.size() == 1 ? " does" : " do") << " not reach all vertices" 
         << reason_for_unreached(mesh, !avoided.faces.empty() || !avoided.walls.empty());
  console.note(text.str());
  return samples;
}

void run(const Arguments& arguments, const Console& console)
{
  if(!has(arguments, "number") && !has(arguments, "radius"))
    throw Command_error(Exit_code::BAD_USAGE, "neither --number nor --radius is given");
  const double radius = positive_argument_or(arguments, "radius", 0);
  Output_files files(output_names(arguments), {"csv", "ply", "vtu", "vtk", "obj"});
  const Mesh mesh = read_mesh(arguments, console);
  const std::size_t n = count_argument_or(arguments, "number", mesh.number_of_vertices());
  const std::vector<Vertex> first = first_options.vertices(arguments, mesh, console);
  if(first.size() > n)
    throw Command_error(Exit_code::BAD_USAGE, "there are more first samples than --number");
  const Obstacles avoided = obstacles(arguments, mesh);
  const std::vector<Curve> curves
    = are_curves_given(arguments, "first") ? curves_of("first", arguments, mesh, {}, avoided, console)
                                           : std::vector<Curve>();
  const std::vector<Vertex> samples
    = samples_of(mesh, n, radius, count_argument_or(arguments, "iterations", 0), first, curves, avoided, console);
  const Drawing drawing = drawing_of(mesh, samples);
  files.write([&](std::ostream& os, const std::string& format)
  {
    if(format == "csv")
      write_table(os, mesh, samples);
    else
      write_drawing(os, format, drawing);
  });
}

} // namespace

const Command sample_command{
  "sample",
  "vertices spread evenly over the surface",
  "Each sample is the vertex that is farthest from all samples before it. The table has a line for each sample: its\n"
  "index, its vertex, and its point; options such as --source-file accept it. The error stream shows the distance of\n"
  "the farthest vertex. With --first-border or --first-curve, samples keep away from the border or from curves.\n"
  "With --iterations, samples are moved to the centers of their geodesic Voronoi cells, so that these become similar.",
  "  surface_mesh_geodesics sample bunny.off --number 100 > samples.csv\n"
  "  surface_mesh_geodesics sample bunny.off --radius 0.1 --first 0 -o samples.ply\n"
  "  surface_mesh_geodesics sample scan.off --number 100 --first-border --iterations 20 > inside.csv\n",
  declare, run};

} // namespace geodesics_demo
