// Edges to avoid: distances and paths are those of a mesh that has really been cut along these edges. Walls of all
// shapes, sources and queries on them, faces to avoid beside them, invalid input.

#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"
#include "walls_and_places.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>
#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>

#include <CGAL/Surface_mesh_shortest_path.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;
using SMG::Invalid_geodesic_input;

namespace {

using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;
using Solver = SMG::Geodesic_distance_solver<Mesh>;

constexpr double infinity = not_reached;

double or_infinity(double d) { return d < 0 ? infinity : d; }

double distance_of(const Paths& paths, vertex_descriptor v)
{
  return or_infinity(paths.shortest_distance_to_source_points(v).first);
}

double distance_of(const Paths& paths, const Face_location& l)
{
  return or_infinity(
    paths.shortest_distance_to_source_points(l.first, {{l.second[0], l.second[1], l.second[2]}}).first);
}

void add(Paths& paths, const Place& p)
{
  if(p.is_vertex)
    paths.add_source_point(p.vertex);
  else
    paths.add_source_point(p.location.first, {{p.location.second[0], p.location.second[1], p.location.second[2]}});
}

// --- paths ---

// Records what a path crosses.
struct Crossings
{
  std::vector<halfedge_descriptor> edges;

  void operator()(halfedge_descriptor h, double) { edges.push_back(h); }
  void operator()(vertex_descriptor) {}
  void operator()(face_descriptor, const Traits::Barycentric_coordinates&) {}
};

// The path to a vertex crosses no wall, stays in one sector where it passes a vertex, and has the right length.
void check_path(const Mesh& tm, const Paths& paths, const Cut_mesh& cut, const Walls& walls, const Faces& removed,
                vertex_descriptor v)
{
  Crossings crossings;
  paths.shortest_path_sequence_to_source_points(v, crossings);
  // A source on a wall is met on the wall, at the end.
  for(std::size_t i = 0; i + 1 < crossings.edges.size(); ++i)
    CHECK(walls.count(edge(crossings.edges[i], tm)) == 0);
  std::vector<std::pair<Kernel::Point_3, face_descriptor>> line;
  paths.shortest_path_polyline_to_source_points(v, std::back_inserter(line));
  double length = 0;
  for(std::size_t i = 1; i < line.size(); ++i)
  {
    length += std::sqrt(CGAL::squared_distance(line[i - 1].first, line[i].first));
    CHECK(removed.count(line[i].second) == 0);
    if(i + 1 < line.size())
      for(const vertex_descriptor w : vertices_around_face(halfedge(line[i].second, tm), tm))
        if(line[i].first == tm.point(w) && cut.copies[w].size() > 1)
          CHECK_EQUAL(cut.sector(line[i].second, w), cut.sector(line[i + 1].second, w));
  }
  if(distance_of(paths, v) < infinity)
    CHECK_CLOSE(length, distance_of(paths, v), 1e-12);
}

// --- everything against the cut mesh ---

void check_distances(const std::map<vertex_descriptor, double>& found,
                     const std::map<vertex_descriptor, double>& expected)
{
  for(const auto& d : expected)
    CHECK_CLOSE(found.at(d.first), d.second, 1e-12);
}

// All vertices from one place: the free function, a solver that has run before, and paths.
void check_vertices(const Case& c, const Place& p, Solver& solver, Paths& paths)
{
  const auto expected = c.expected({p});
  std::map<vertex_descriptor, double> found;
  const auto parameters = np::faces_to_avoid(c.avoided).edges_to_avoid(std::cref(c.walls));
  with_place(p, [&](const auto& s)
  {
    SMG::geodesic_distances(c.tm, boost::make_assoc_property_map(found), s, parameters);
    return solver.compute_distances(s);
  });
  check_distances(found, expected);
  paths.remove_all_source_points();
  add(paths, p);
  std::vector<vertex_descriptor> reached;
  solver.vertices_reached(std::back_inserter(reached));
  CHECK_EQUAL(std::set<vertex_descriptor>(reached.begin(), reached.end()).size(), reached.size());
  CHECK_EQUAL(static_cast<std::ptrdiff_t>(reached.size()),
              std::count_if(expected.begin(), expected.end(), [](const auto& d) { return d.second < infinity; }));
  for(const auto& d : expected)
  {
    CHECK_EQUAL(solver.distance(d.first), found.at(d.first));
    CHECK_EQUAL(solver.nearest_source(d.first), d.second < infinity ? 0 : Solver::no_source);
    CHECK_CLOSE(distance_of(paths, d.first), d.second, 1e-12);
    check_path(c.tm, paths, c.cut, c.walls, c.removed, d.first);
  }
}

double expected_distance(const Case& c, const Place& p, const Place& q)
{
  if(q.is_vertex)
    return c.expected({p}).at(q.vertex);
  Paths in_cut(c.cut.mesh);
  for(const Face_location& s : sides(c.tm, c.cut, c.removed, p))
    in_cut.add_source_point(s.first, {{s.second[0], s.second[1], s.second[2]}});
  double result = infinity;
  for(const Face_location& s : sides(c.tm, c.cut, c.removed, q))
    result = (std::min)(result, distance_of(in_cut, s));
  return result;
}

// One pair of places: runs that end early. `paths` are those from p.
void check_pair(const Case& c, const Place& p, const Place& q, Solver& solver, const Paths& paths)
{
  const double expected = expected_distance(c, p, q);
  const auto parameters = np::faces_to_avoid(c.avoided).edges_to_avoid(c.range);
  if(q.is_vertex)
    CHECK_CLOSE(with_place(p, [&](const auto& s) { return solver.compute_distance(s, q.vertex); }), expected, 1e-12);
  else
    CHECK_CLOSE(distance_of(paths, q.location), expected, 1e-12);
  std::vector<Kernel::Point_3> line;
  double distance = 0;
  const double way = with_place(p, [&](const auto& a)
  {
    return with_place(q, [&](const auto& b)
    {
      distance = SMG::geodesic_distance(c.tm, a, b, parameters);
      return SMG::geodesic_path(c.tm, a, b, std::back_inserter(line), parameters);
    });
  });
  CHECK_CLOSE(distance, expected, 1e-12);
  CHECK_CLOSE(way, expected, 1e-12);
  double length = 0;
  for(std::size_t i = 1; i < line.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(line[i - 1], line[i]));
  CHECK_CLOSE(line.empty() ? infinity : length, expected, 1e-11);
}

// Several sources: the nearest one has the number of the user, also if others are listed on both sides of a wall.
void check_nearest_source(const Case& c, const std::vector<Place>& places, Solver& solver)
{
  std::vector<Face_location> sources;
  std::vector<std::map<vertex_descriptor, double>> distance;
  for(const Place& p : places)
  {
    sources.push_back(p.location);
    distance.push_back(c.expected({{p.vertex, p.location, false}}));
  }
  solver.compute_distances(sources);
  for(const vertex_descriptor v : vertices(c.tm))
  {
    double least_distance = infinity;
    for(const auto& d : distance)
      least_distance = (std::min)(least_distance, d.at(v));
    CHECK_CLOSE(solver.distance(v), least_distance, 1e-12);
    const std::size_t nearest = solver.nearest_source(v);
    CHECK_EQUAL(nearest == Solver::no_source, least_distance == infinity);
    if(nearest < sources.size())
      CHECK_CLOSE(distance[nearest].at(v), least_distance, 1e-12);
  }
}

void check_walls(const Mesh& tm, const Walls& walls, const Faces& removed, test_support::Random& random)
{
  const Case c{tm, walls, removed};
  std::vector<Place> places;
  for(std::size_t i = 0; i < 3; ++i)
    places.push_back(random_place(tm, removed, random));
  auto solver = Solver::avoiding_edges(tm, c.range, c.avoided);
  Paths paths(tm);
  paths.avoid_faces(c.avoided);
  paths.avoid_edges(c.range);
  for(const Place& p : places)
  {
    check_vertices(c, p, solver, paths);
    check_pair(c, p, random_place(tm, removed, random), solver, paths);
  }
  check_nearest_source(c, places, solver);
}

void test_against_cut_mesh()
{
  test_support::Random random(1);
  for(const Indexed_mesh& indexed :
      {irregular_tetrahedron(), icosahedron(), icosphere(1), noisy_sphere(2, .2, 3), torus(2, .7, 8, 6),
       wavy_tube(6, 4), flat_patch(5, 5, .15, true, 2), rough_terrain(5, .4, 3), saddle_fan(7),
       two_components_and_an_isolated_vertex()})
  {
    const Mesh tm = to_face_graph(indexed);
    const Faces star = star_to_avoid(tm);
    std::size_t number = 0;
    for(const Walls& walls : all_walls(tm, random))
    {
      const test_support::Scope scope(indexed.name + ", walls " + std::to_string(number++));
      check_walls(tm, walls, {}, random);
      if(!star.empty())
        check_walls(tm, walls, star, random);
    }
  }
}

// --- other ways to give walls, and to take them back ---

void test_ways_to_give_walls()
{
  const test_support::Scope scope("ways to give walls");
  test_support::Random random(4);
  const Mesh tm = to_face_graph(noisy_sphere(2, .2, 5));
  const Walls walls = random_walls(tm, .2, random);
  const auto is_wall = boost::make_function_property_map<edge_descriptor>([&](edge_descriptor e)
                                                                           { return walls.count(e) != 0; });
  std::vector<edge_descriptor> twice(walls.begin(), walls.end());
  twice.insert(twice.end(), walls.begin(), walls.end());
  const auto distances = [&](const auto& parameters)
  {
    std::map<vertex_descriptor, double> result;
    SMG::geodesic_distances(tm, boost::make_assoc_property_map(result), vertex_descriptor(7), parameters);
    return result;
  };
  const auto expected = distances(np::edges_to_avoid(walls)), free = distances(np::maximum_distance(1e9));
  CHECK(expected != free);
  CHECK(distances(np::edges_to_avoid(is_wall)) == expected);
  CHECK(distances(np::edges_to_avoid(twice)) == expected);
  CHECK(distances(np::edges_to_avoid(std::vector<edge_descriptor>())) == free);
  // Lengths instead of points; and walls that are replaced and taken back, beside faces.
  const auto lengths = boost::make_function_property_map<edge_descriptor>([&](edge_descriptor e)
  { return std::sqrt(CGAL::squared_distance(tm.point(source(e, tm)), tm.point(target(e, tm)))); });
  std::map<vertex_descriptor, double> by_lengths;
  SMG::geodesic_distances_from_edge_lengths(tm, lengths, boost::make_assoc_property_map(by_lengths),
                                            vertex_descriptor(7), np::edges_to_avoid(walls));
  check_distances(by_lengths, expected);
  Paths paths(tm);
  paths.add_source_point(vertex_descriptor(7));
  paths.avoid_edges(tree(tm, random));
  paths.avoid_edges(is_wall);
  paths.use_edge_lengths(lengths);
  for(const auto& d : expected)
    CHECK_CLOSE(distance_of(paths, d.first), d.second, 1e-12);
  paths.avoid_faces(std::vector<face_descriptor>()); // leaves the walls as they are
  for(const auto& d : expected)
    CHECK_EQUAL(distance_of(paths, d.first), d.second);
  paths.avoid_edges(Walls());
  for(const auto& d : free)
    CHECK_EQUAL(distance_of(paths, d.first), d.second);
  paths.avoid_edges(walls);
  paths.clear(); // forgets them
  paths.add_source_point(vertex_descriptor(7));
  for(const auto& d : free)
    CHECK_EQUAL(distance_of(paths, d.first), d.second);
}

// --- straightest geodesics end at walls ---

// Traces against the cut mesh, from places in faces and at vertices of walls: the same length, end and points.
void check_trace(const Case& c, const Place& p, double direction)
{
  if(p.is_vertex && c.cut.copies[p.vertex].size() > 1)
    return; // the frame counts from the face of the location: see below
  const auto q = sides(c.tm, c.cut, {}, p)[0];
  const auto a = with_place(p, [&](const auto& s)
  { return SMG::trace_geodesic(c.tm, s, direction, 3., np::edges_to_avoid(c.range)); });
  const auto h = halfedge(p.location.first, c.tm);
  const auto v = c.tm.point(target(h, c.tm)) - c.tm.point(source(h, c.tm));
  if(p.is_vertex)
    return;
  // The same direction in the cut mesh, whose faces may begin with another halfedge.
  const double turn = SMG::geodesic_direction(c.cut.mesh, q, v);
  const auto b = SMG::trace_geodesic(c.cut.mesh, q, direction + turn, 3.);
  CHECK_CLOSE(a.length, b.length, 1e-9);
  CHECK_EQUAL(int(a.end), int(b.end));
  for(std::size_t k = 0; k < 3; ++k)
    CHECK_NEAR(a.points.back()[k], b.points.back()[k], 1e-9);
}

void test_traces()
{
  test_support::Random random(6);
  const Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  std::size_t ended = 0;
  for(const Walls& walls : all_walls(tm, random))
  {
    const Case c{tm, walls, {}};
    for(std::size_t i = 0; i < 40; ++i)
      check_trace(c, random_place(tm, {}, random), random.uniform(0, 6.28));
    const auto is_wall = boost::make_function_property_map<edge_descriptor>([&](edge_descriptor e)
                                                                             { return walls.count(e) != 0; });
    // The exponential map: back along the first piece of a path, also where it begins at a vertex of a wall.
    const vertex_descriptor s = source(*walls.begin(), tm);
    Paths paths(tm);
    paths.avoid_edges(walls);
    paths.add_source_point(s);
    for(const face_descriptor f : faces(tm))
    {
      const auto d = paths.shortest_distance_to_source_points(f, {{.3, .3, .4}}).first;
      std::vector<Kernel::Point_3> line;
      paths.shortest_path_points_to_source_points(f, {{.3, .3, .4}}, std::back_inserter(line));
      if(d <= 0)
        continue;
      // The face in which the path arrives tells the sector.
      std::vector<std::pair<Kernel::Point_3, face_descriptor>> with_faces;
      paths.shortest_path_polyline_to_source_points(f, {{.3, .3, .4}}, std::back_inserter(with_faces));
      const face_descriptor last = with_faces.back().second;
      Face_location start(last, {0, 0, 0});
      std::size_t k = 0;
      for(const halfedge_descriptor h : halfedges_around_face(halfedge(last, tm), tm))
        start.second[k++] = source(h, tm) == s ? 1 : 0;
      const auto bend = with_faces[with_faces.size() - 2].first;
      const double direction = paths.direction_at_source(f, {{.3, .3, .4}});
      const auto t = SMG::trace_geodesic(tm, start, direction, 1e-3, np::edges_to_avoid(is_wall));
      const auto end = Kernel::Point_3(t.points.back()[0], t.points.back()[1], t.points.back()[2]);
      const auto way = bend - tm.point(s);
      const auto expected = tm.point(s) + (1e-3 / std::sqrt(way.squared_length())) * way;
      CHECK(CGAL::squared_distance(end, expected) < 1e-20);
      ++ended;
    }
  }
  CHECK(ended > 500);
}

void test_invalid_input()
{
  const test_support::Scope scope("invalid input");
  Mesh tm = to_face_graph(flat_patch(3, 3, .1, true, 1));
  const auto is_rejected = [&](edge_descriptor e)
  {
    const std::vector<edge_descriptor> range{*edges(tm).begin(), e};
    try
    {
      Solver::avoiding_edges(tm, range);
    }
    catch(const Invalid_geodesic_input& error)
    {
      return error.reason() == Invalid_geodesic_input::Reason::INVALID_DESCRIPTOR && error.element() == 1;
    }
    return false;
  };
  CHECK(is_rejected(Mesh::null_edge()));
  CHECK(is_rejected(edge_descriptor(12345)));
  const edge_descriptor last = *std::next(edges(tm).begin(), static_cast<std::ptrdiff_t>(num_edges(tm) - 1));
  CHECK(!is_rejected(last));
  // The border is no wall between faces.
  std::vector<edge_descriptor> border;
  for(const edge_descriptor e : edges(tm))
    if(is_border(e, tm))
      border.push_back(e);
  auto solver = Solver::avoiding_edges(tm, border);
  Solver free(tm);
  solver.compute_distances(vertex_descriptor(0));
  free.compute_distances(vertex_descriptor(0));
  for(const vertex_descriptor v : vertices(tm))
    CHECK_EQUAL(solver.distance(v), free.distance(v));
}

} // namespace

int main()
{
  test_against_cut_mesh();
  test_ways_to_give_walls();
  test_traces();
  test_invalid_input();
  return test_result();
}
