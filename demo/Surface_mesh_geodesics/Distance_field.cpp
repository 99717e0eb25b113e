#include "Distance_field.h"

#include "Command_error.h"
#include "Path_finder.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_isolines.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

namespace geodesics_demo {

double Distance_field::largest() const
{
  double result = 0;
  for(const double d : distance)
    result = std::isfinite(d) ? (std::max)(result, std::abs(d)) : result;
  return result;
}

namespace {

using CGAL::Surface_mesh_geodesics::Invalid_geodesic_input;
using Solver = CGAL::Surface_mesh_geodesics::Geodesic_distance_solver<Mesh>;

Distance_field field_of(const Mesh& mesh, const Solver& solver)
{
  Distance_field field;
  field.distance.reserve(mesh.number_of_vertices());
  field.source.reserve(mesh.number_of_vertices());
  for(const Vertex v : mesh.vertices())
  {
    field.distance.push_back(solver.distance(v));
    field.source.push_back(solver.nearest_source(v));
  }
  return field;
}

// The nearest point of the curves: a vertex if it is at one, and nowhere if no curve reaches v.
Location foot_of(const Mesh& mesh, const Solver& solver, const std::vector<Curve>& curves, Vertex v)
{
  Location result{Mesh::null_vertex(), Face_location(Mesh::null_face(), {0, 0, 0})};
  const auto foot = solver.nearest_curve_point(v);
  if(foot.curve == Solver::no_source)
    return result;
  const Curve& curve = curves[foot.curve];
  if(curve.segments().empty())
    result.vertex = curve.vertex();
  else
    result = as_location(curve.location(foot.segment, foot.parameter), mesh);
  return result;
}

} // namespace

Distance_field distances_from(const Mesh& mesh, const Obstacles& avoided, const std::vector<Location>& sources,
                              double radius, const Console& console)
{
  Solver solver = Solver::avoiding_edges(mesh, avoided.walls, avoided.faces);
  Progress_visitor visitor(console, "distances");
  const auto np = CGAL::parameters::maximum_distance(radius).visitor(std::ref(visitor));
  const std::vector<Vertex> vertices = as_vertices(sources);
  if(!vertices.empty())
    solver.compute_distances(vertices, np);
  else
    solver.compute_distances(as_face_locations(sources, mesh), np);
  return field_of(mesh, solver);
}

Distance_field distances_from(const Mesh& mesh, const Obstacles& avoided, const std::vector<Curve>& sources,
                              double radius, const Console& console)
{
  Solver solver = Solver::avoiding_edges(mesh, avoided.walls, avoided.faces);
  Progress_visitor visitor(console, "distances");
  solver.compute_distances(sources, CGAL::parameters::maximum_distance(radius).visitor(std::ref(visitor)));
  Distance_field field = field_of(mesh, solver);
  for(const Vertex v : mesh.vertices())
    field.foot.push_back(foot_of(mesh, solver, sources, v));
  return field;
}

Distance_field signed_distances_from(const Mesh& mesh, const Obstacles& avoided, const std::vector<Curve>& curves,
                                     double radius, const Console& console)
{
  Distance_field field;
  field.distance.resize(mesh.number_of_vertices());
  const auto map = boost::make_iterator_property_map(field.distance.begin(), get(boost::vertex_index, mesh));
  Progress_visitor visitor(console, "distances");
  try
  {
    CGAL::Surface_mesh_geodesics::signed_geodesic_distances(
      mesh, map, curves,
      CGAL::parameters::maximum_distance(radius).visitor(std::ref(visitor)).faces_to_avoid(avoided.faces)
        .edges_to_avoid(avoided.walls));
  }
  catch(const Invalid_geodesic_input& error)
  {
    if(error.reason() != Invalid_geodesic_input::Reason::INVALID_CURVE)
      throw;
    throw Command_error(Exit_code::BAD_INPUT, std::string("--signed: ") + error.what());
  }
  return field;
}

Distance_run::~Distance_run() = default;

Distance_run::Distance_run(const Mesh& mesh, const Obstacles& avoided, const std::vector<Location>& sources,
                           double radius, const Console& console)
  : m_mesh(mesh), m_console(console), m_avoided(avoided), m_is_avoided(flags_of_faces(mesh, avoided.faces)),
    m_radius(radius), m_paths(new Paths(mesh))
{
  run(sources);
}

Distance_run::Distance_run(const Mesh& mesh, const Obstacles& avoided, const std::vector<Curve>& sources,
                           double radius, const Console& console)
  : m_mesh(mesh), m_console(console), m_avoided(avoided), m_is_avoided(flags_of_faces(mesh, avoided.faces)),
    m_radius(radius), m_paths(new Paths(mesh))
{
  run(sources);
  const Location nowhere{Mesh::null_vertex(), Face_location(Mesh::null_face(), {0, 0, 0})};
  for(const Vertex v : mesh.vertices())
    m_field.foot.push_back(m_field.source[v] == Distance_field::no_source
                             ? nowhere
                             : as_location(m_paths->finder.nearest_location_of_sources(v), mesh));
}

Distance_run::Distance_run(const Mesh& mesh, const Obstacles& avoided, const std::vector<Location>& sources,
                           double radius, const std::vector<double>& levels, const Console& console)
  : m_mesh(mesh), m_console(console), m_avoided(avoided), m_is_avoided(flags_of_faces(mesh, avoided.faces)),
    m_radius(radius)
{
  m_field.distance.resize(mesh.number_of_vertices());
  m_field.source.resize(mesh.number_of_vertices());
  const auto index = get(boost::vertex_index, mesh);
  Progress_visitor visitor(console, "distances and isolines");
  const auto np = CGAL::parameters::maximum_distance(radius).visitor(std::ref(visitor)).faces_to_avoid(avoided.faces)
                    .edges_to_avoid(avoided.walls)
                    .vertex_distance_map(boost::make_iterator_property_map(m_field.distance.begin(), index))
                    .nearest_source_map(boost::make_iterator_property_map(m_field.source.begin(), index));
  const auto output = boost::make_function_output_iterator([&](std::pair<std::size_t, std::vector<Point>> line)
  { m_isolines.push_back(Isoline{levels[line.first], std::move(line.second)}); });
  using CGAL::Surface_mesh_geodesics::geodesic_isolines;
  const std::vector<Vertex> vertices = as_vertices(sources);
  if(!vertices.empty())
    geodesic_isolines(mesh, vertices, levels, output, np);
  else
    geodesic_isolines(mesh, as_face_locations(sources, mesh), levels, output, np);
}

template <typename Source>
void Distance_run::run(const std::vector<Source>& sources)
{
  Path_finder& finder = m_paths->finder;
  finder.avoid_faces(m_avoided.faces);
  finder.avoid_edges(m_avoided.walls);
  add_sources(finder, sources);
  {
    Progress_visitor visitor(m_console, "distances");
    finder.build_sequence_tree_for_faces(visitor);
  }
  for(const Vertex v : m_mesh.vertices())
  {
    const double d = finder.shortest_distance_to_source_points(v).first;
    const bool is_reached = d >= 0 && d <= m_radius; // -1: no source reaches the vertex
    m_field.distance.push_back(is_reached ? d : std::numeric_limits<double>::infinity());
    m_field.source.push_back(is_reached ? finder.nearest_source_point(v) : Distance_field::no_source);
  }
}

std::vector<Isoline> Distance_run::isolines(const std::vector<double>& distances) const
{
  if(m_paths == nullptr)
  {
    std::vector<Isoline> result;
    for(const Isoline& line : m_isolines)
      if(std::find(distances.begin(), distances.end(), line.distance) != distances.end())
        result.push_back(line);
    return result;
  }
  return found_isolines(distances, [this](double d, std::vector<std::vector<Point>>& lines)
                        { m_paths->finder.isolines(d, std::back_inserter(lines)); });
}

std::vector<Isoline> Distance_run::signed_isolines(const std::vector<double>& distances) const
{
  std::vector<double> with_sign;
  for(auto d = distances.rbegin(); d != distances.rend(); ++d)
    with_sign.push_back(-*d);
  with_sign.insert(with_sign.end(), distances.begin(), distances.end());
  return found_isolines(with_sign, [this](double d, std::vector<std::vector<Point>>& lines)
                        { m_paths->finder.signed_isolines(d, std::back_inserter(lines)); });
}

// Calls find(distance, lines) for each distance.
template <typename Find>
std::vector<Isoline> Distance_run::found_isolines(const std::vector<double>& distances, Find find) const
{
  std::vector<Isoline> result;
  Progress_bar bar(m_console, "isolines", 1);
  for(std::size_t i = 0; i < distances.size(); ++i)
  {
    bar.show(static_cast<double>(i) / static_cast<double>(distances.size()));
    std::vector<std::vector<Point>> lines;
    find(distances[i], lines);
    for(std::vector<Point>& line : lines)
      result.push_back(Isoline{distances[i], std::move(line)});
  }
  return result;
}

// The faces around the target of a halfedge of a wall, in groups that are not divided by walls, by the border, or by
// faces that paths avoid.
std::vector<std::vector<Face>> Distance_run::sectors(Mesh::Halfedge_index on_wall,
                                                     const std::vector<char>& is_wall) const
{
  std::vector<std::vector<Face>> result;
  bool begins = true;
  for(const Mesh::Halfedge_index h : halfedges_around_target(on_wall, m_mesh))
  {
    begins = begins || is_wall[m_mesh.edge(h)] != 0;
    if(m_mesh.is_border(h) || is_avoided(m_mesh.face(h)))
    {
      begins = true;
      continue;
    }
    if(begins)
      result.emplace_back();
    result.back().push_back(m_mesh.face(h));
    begins = false;
  }
  return result;
}

// Gives the triangles of each sector of a vertex at a wall a point of their own.
void Distance_run::divide_at_walls(Html_surface& surface) const
{
  std::vector<char> is_wall(m_mesh.number_of_edges(), 0), is_done(m_mesh.number_of_vertices(), 0);
  for(const Mesh::Edge_index e : m_avoided.walls)
    is_wall[e] = 1;
  for(const Mesh::Edge_index e : m_avoided.walls)
    for(const Mesh::Halfedge_index h : {m_mesh.halfedge(e, 0), m_mesh.halfedge(e, 1)})
    {
      const Vertex v = m_mesh.target(h);
      if(std::exchange(is_done[v], 1) != 0)
        continue;
      const std::vector<std::vector<Face>> groups = sectors(h, is_wall);
      for(std::size_t i = 0; groups.size() > 1 && i < groups.size(); ++i)
      {
        const std::size_t point = i == 0 ? v.idx() : surface.points.size();
        surface.points.resize((std::max)(surface.points.size(), point + 1), m_mesh.point(v));
        for(const Face f : groups[i])
          std::replace(surface.triangles[f].begin(), surface.triangles[f].end(), std::size_t(v.idx()), point);
        std::array<double, 3> b;
        for(std::size_t k = 0; k < 3; ++k)
          b[k] = surface.triangles[groups[i].front()][k] == point ? 1 : 0;
        const double d = distance_within(groups[i].front(), b);
        surface.distances.resize(surface.points.size());
        surface.distances[point] = d <= m_radius ? d : std::numeric_limits<double>::infinity();
      }
    }
}

// A query on a wall answers for its nearest side. A point that has been moved into the face by a part of 10^-9 is on
// the side of this face, and its distance has changed by less than the numbers of a page can tell.
//
// Returns the distance of a point on the side of a face; infinity if no source reaches it.
double Distance_run::distance_within(Face f, std::array<double, 3> b) const
{
  constexpr double moved = 1e-9;
  if(!m_avoided.walls.empty())
    for(double& x : b)
      x = (1 - moved) * x + moved / 3;
  const double d = is_avoided(f) ? -1 : m_paths->finder.shortest_distance_to_source_points(f, b).first;
  return d >= 0 ? d : std::numeric_limits<double>::infinity();
}

Html_surface Distance_run::surface() const
{
  Html_surface surface;
  for(const Vertex v : m_mesh.vertices())
    surface.points.push_back(m_mesh.point(v));
  surface.distances = m_field.distance;
  for(const Face f : m_mesh.faces())
  {
    const Mesh::Halfedge_index h = m_mesh.halfedge(f);
    surface.triangles.push_back({m_mesh.source(h).idx(), m_mesh.target(h).idx(), m_mesh.target(m_mesh.next(h)).idx()});
  }
  surface.is_avoided = m_is_avoided;
  divide_at_walls(surface);
  if(!is_refined(surface.triangles.size()))
    return surface;
  return refined(surface, [&](std::size_t t, const std::array<double, 3>& b)
  {
    // beyond --radius, or no source reaches it
    const auto is_missing = [&](std::size_t v) { return !std::isfinite(surface.distances[v]); };
    const std::array<std::size_t, 3>& corners = surface.triangles[t];
    return std::any_of(corners.begin(), corners.end(), is_missing)
             ? std::numeric_limits<double>::infinity()
             : distance_within(Face(static_cast<Mesh::size_type>(t)), b);
  });
}

Html_lines Distance_run::lines_on(const Html_surface& surface, const std::vector<double>& distances) const
{
  // isolines are curved inside large faces, but files hold segments
  if(is_refined(m_mesh.number_of_faces()))
    return lines_between_bands(surface, distances);
  Html_lines result{"isoline", {}};
  for(const Isoline& line : isolines(distances))
    result.lines.push_back(line.points);
  return result;
}

double source_number(std::size_t source)
{
  return source == Distance_field::no_source ? -1. : static_cast<double>(source);
}

std::string source_text(std::size_t source)
{
  return source == Distance_field::no_source ? "-1" : std::to_string(source);
}

} // namespace geodesics_demo
