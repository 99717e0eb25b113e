#include "Distance_field.h"

#include "Path_finder.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

namespace geodesics_demo {

double Distance_field::largest() const
{
  double result = 0;
  for(const double d : distance)
    result = std::isfinite(d) ? (std::max)(result, d) : result;
  return result;
}

Distance_field distances_from(const Mesh& mesh, const std::vector<Location>& sources, double radius,
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
    solver.compute_distances(as_face_locations(sources, mesh), options, visitor);
  Distance_field field;
  for(const Vertex v : mesh.vertices())
  {
    field.distance.push_back(solver.distance(v));
    field.source.push_back(solver.nearest_source(v));
  }
  return field;
}

std::vector<Isoline> isolines_around(const Mesh& mesh, const std::vector<Location>& sources,
                                     const std::vector<double>& distances, const Console& console)
{
  std::vector<Isoline> result;
  if(distances.empty())
    return result;
  Path_finder paths(mesh);
  add_sources(paths, sources);
  {
    Progress_visitor visitor(console, "distances in faces");
    paths.build_sequence_tree_for_faces(visitor);
  }
  Progress_bar bar(console, "isolines", 1);
  for(std::size_t i = 0; i < distances.size(); ++i)
  {
    const double d = distances[i];
    bar.show(static_cast<double>(i) / static_cast<double>(distances.size()));
    std::vector<std::vector<Point>> lines;
    paths.isolines(d, std::back_inserter(lines));
    for(std::vector<Point>& line : lines)
      result.push_back(Isoline{d, std::move(line)});
  }
  return result;
}

std::vector<double> evenly_spaced(std::size_t n, double largest)
{
  std::vector<double> result;
  for(std::size_t i = 1; i <= n && largest > 0; ++i)
    result.push_back(largest * (static_cast<double>(i) / static_cast<double>(n + 1)));
  return result;
}

Html_surface surface_with_distances(const Mesh& mesh, const std::vector<Location>& sources, const Distance_field& field)
{
  Html_surface surface;
  for(const Vertex v : mesh.vertices())
    surface.points.push_back(mesh.point(v));
  surface.distances = field.distance;
  for(const Face f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    surface.triangles.push_back({mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  if(!is_refined(surface.triangles.size()))
    return surface;
  Path_finder paths(mesh);
  add_sources(paths, sources);
  paths.build_sequence_tree_for_faces();
  return refined(surface, [&](std::size_t t, const std::array<double, 3>& b)
  {
    const Face f(static_cast<Mesh::size_type>(t));
    const double d = paths.shortest_distance_to_source_points(f, b).first;
    // beyond --radius, or no source reaches it
    const auto is_missing = [&](std::size_t v) { return !std::isfinite(field.distance[v]); };
    const std::array<std::size_t, 3>& corners = surface.triangles[t];
    return std::any_of(corners.begin(), corners.end(), is_missing) ? std::numeric_limits<double>::infinity() : d;
  });
}

Html_lines lines_on(const Html_surface& surface, const Mesh& mesh, const std::vector<Location>& sources,
                    const std::vector<double>& distances, const Console& console)
{
  // isolines are curved inside large faces, but files hold segments
  if(is_refined(mesh.number_of_faces()))
    return lines_between_bands(surface, distances);
  Html_lines result{"isoline", {}};
  for(const Isoline& line : isolines_around(mesh, sources, distances, console))
    result.lines.push_back(line.points);
  return result;
}

double source_number(std::size_t source)
{
  return source == Distance_field::no_source ? -1. : static_cast<double>(source);
}

} // namespace geodesics_demo
