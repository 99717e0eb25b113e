#include "Distance_field.h"

#include "Path_finder.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace geodesics_app {

double Distance_field::largest() const
{
  double result = 0;
  for(const double d : distance)
    result = std::isfinite(d) ? (std::max)(result, d) : result;
  return result;
}

Distance_field distances_from(const Mesh& mesh, const std::vector<Place>& sources, double radius,
                              const Console& console)
{
  using Solver = CGAL::Surface_mesh_geodesics::Geodesic_distance_solver<Mesh>;
  Solver solver(mesh);
  Solver::Options options;
  options.maximum_distance = radius;
  Progress_visitor visitor(console, "distances");
  const std::vector<Vertex> vertices = as_vertices(sources);
  if(!vertices.empty())
    solver.compute_distances(vertices, options, visitor);
  else
    solver.compute_distances(as_locations(sources, mesh), options, visitor);
  Distance_field field;
  for(const Vertex v : mesh.vertices())
  {
    field.distance.push_back(solver.distance(v));
    field.source.push_back(solver.nearest_source(v));
  }
  return field;
}

std::vector<Isoline> isolines_around(const Mesh& mesh, const std::vector<Place>& sources,
                                     const std::vector<double>& distances, const Console& console)
{
  std::vector<Isoline> result;
  if(distances.empty())
    return result;
  Path_finder paths(mesh);
  add_sources(paths, sources);
  Progress_visitor visitor(console, "isolines");
  paths.build_sequence_tree_for_faces(visitor);
  for(const double d : distances)
  {
    std::vector<std::vector<Point>> lines;
    paths.isolines(d, std::back_inserter(lines));
    for(std::vector<Point>& line : lines)
      result.push_back(Isoline{d, std::move(line)});
  }
  return result;
}

double source_number(std::size_t source)
{
  return source == Distance_field::no_source ? -1. : static_cast<double>(source);
}

} // namespace geodesics_app
