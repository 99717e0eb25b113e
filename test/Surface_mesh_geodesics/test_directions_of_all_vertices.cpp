// The directions of all vertices, which share what their paths cross, against the direction of each vertex by a path of
// its own; in the plane and on a doubled plane against the angle of a vector.

#include "hostile_meshes.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

double difference_of_angles(double a, double b) { return std::abs(std::remainder(a - b, 2 * CGAL_PI)); }

std::map<vertex_descriptor, double> directions(const Paths& paths)
{
  std::map<vertex_descriptor, double> result;
  paths.directions_at_source(boost::make_assoc_property_map(result));
  return result;
}

// Is the direction that of another shortest path? A geodesic next to it leads to the vertex, too. (Both run through a
// saddle, so the geodesic in that very direction goes on between them.)
bool is_tie(const Mesh& tm, const Paths& paths, vertex_descriptor v, double direction)
{
  const auto found = paths.shortest_distance_to_source_points(v);
  for(const double turn : {-1e-7, 0., 1e-7})
  {
    const auto g = CGAL::Surface_mesh_geodesics::trace_geodesic(tm, *found.second, direction + turn, found.first);
    const auto& p = g.points.back();
    if(CGAL::squared_distance(Kernel::Point_3(p[0], p[1], p[2]), tm.point(v)) < 1e-10 * size_of(tm) * size_of(tm))
      return true;
  }
  return false;
}

// Returns the largest difference from the direction of a vertex alone, except for ties. Next to a source, where a
// direction is known up to the rounding of the mesh only, differences are relative to the distance.
double check(const Mesh& tm, const Paths& paths)
{
  const std::map<vertex_descriptor, double> all = directions(paths);
  CHECK_EQUAL(all.size(), num_vertices(tm));
  const double size = size_of(tm);
  double worst = 0;
  for(const vertex_descriptor v : vertices(tm))
  {
    const double alone = paths.direction_at_source(v), together = all.at(v);
    CHECK_EQUAL(std::isnan(alone), std::isnan(together));
    if(std::isnan(alone))
      continue;
    CHECK(together >= 0 && together <= 2 * CGAL_PI);
    const double d = paths.shortest_distance_to_source_points(v).first;
    const double error = difference_of_angles(alone, together) * (std::min)(1., d / size);
    if(error > 1e-9 && is_tie(tm, paths, v, together))
      continue;
    worst = (std::max)(worst, error);
  }
  return worst;
}

void add_random_sources(const Mesh& tm, Paths& paths, std::size_t n, test_support::Random& random)
{
  const auto all = faces(tm);
  const std::vector<face_descriptor> list(all.begin(), all.end());
  for(std::size_t i = 0; i < n; ++i)
  {
    const face_descriptor f = list[random.index(list.size())];
    const double a = random.uniform(), b = random.uniform() * (1 - a);
    if(random.index(2) == 0)
      paths.add_source_point(f, {{a, b, 1 - a - b}});
    else if(random.index(3) == 0)
      paths.add_source_point(f, {{a, 1 - a, 0}});
    else
      paths.add_source_point(target(halfedge(f, tm), tm));
  }
}

void against_single_directions()
{
  double worst = 0;
  std::vector<Indexed_mesh> meshes = small_collection(4);
  meshes.push_back(noisy_sphere(4, .05, 1));
  meshes.push_back(icosphere(4));
  meshes.push_back(flat_patch(30, 30, .3, true, 2));
  meshes.push_back(flat_patch(20, 20, 0., false, 2));
  for(const Indexed_mesh& indexed : meshes)
  {
    const test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    test_support::Random random(num_vertices(tm));
    for(const std::size_t n : {1u, 1u, 1u, 3u, 20u})
    {
      Paths paths(tm);
      add_random_sources(tm, paths, n, random);
      const double error = check(tm, paths);
      CHECK(error < 1e-11);
      worst = (std::max)(worst, error);
    }
  }
  std::cout << "largest difference from single directions: " << worst << "\n";
}

// Around faces to avoid, paths bend often, and all vertices behind a bend have one direction.
void behind_bends()
{
  const test_support::Scope scope("bends");
  const Mesh tm = to_face_graph(flat_patch(24, 24, .3, true, 5));
  for(std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    test_support::Random random(seed);
    std::vector<face_descriptor> avoided;
    for(const face_descriptor f : faces(tm))
      if(random.uniform() < .15)
        avoided.push_back(f);
    Paths paths(tm);
    paths.avoid_faces(avoided);
    vertex_descriptor source(300);
    paths.add_source_point(source);
    try
    {
      paths.build_sequence_tree();
    }
    catch(const CGAL::Surface_mesh_geodesics::Invalid_geodesic_input&)
    {
      continue;
    }
    CHECK(check(tm, paths) < 1e-11);
  }
}

// In a convex part of the plane: the angle of the vector, from that of the first halfedge.
void in_the_plane()
{
  const test_support::Scope scope("plane");
  const Mesh tm = to_face_graph(flat_patch(60, 60, .3, true, 7));
  test_support::Random random(2);
  const double size = size_of(tm);
  for(int k = 0; k < 6; ++k)
  {
    const face_descriptor f(static_cast<Mesh::size_type>(random.index(num_faces(tm))));
    Paths paths(tm);
    paths.add_source_point(f, {{.25, .35, .4}});
    const auto p = paths.point(f, {{.25, .35, .4}});
    const auto h = halfedge(f, tm);
    const auto axis = tm.point(target(h, tm)) - tm.point(source(h, tm));
    const std::map<vertex_descriptor, double> all = directions(paths);
    for(const vertex_descriptor v : vertices(tm))
    {
      const auto way = tm.point(v) - p;
      const double angle = std::atan2(way.y(), way.x()) - std::atan2(axis.y(), axis.x());
      CHECK_NEAR(difference_of_angles(angle, all.at(v)), 0.,
                 1e-12 * (std::max)(1., size / std::sqrt(way.squared_length())));
    }
  }
}

void hostile_surfaces()
{
  for(std::uint64_t seed = 1; seed <= 150; ++seed)
  {
    const test_support::Scope scope("hostile " + std::to_string(seed));
    test_support::Random random(seed);
    Mesh tm;
    if(!hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), tm))
      continue;
    Paths paths(tm);
    add_random_sources(tm, paths, 1 + random.index(3), random);
    const std::map<vertex_descriptor, double> all = directions(paths);
    for(const vertex_descriptor v : vertices(tm))
      CHECK_EQUAL(std::isnan(all.at(v)), paths.shortest_distance_to_source_points(v).first < 0);
  }
}

// A source beside an edge of its face has thin faces around it. A single direction leads straight on to its vertex all
// the same, and is that of all vertices.
void beside_edges()
{
  const Mesh tm = to_face_graph(flat_patch(8, 8, .15, true, 5));
  std::size_t number = 0;
  for(const double b : {1e-3, 1e-6, 1e-9, 1e-11})
  {
    const test_support::Scope scope("coordinate " + std::to_string(std::log10(b)));
    const Paths::Face_location source(*std::next(faces(tm).begin(), 61), {{b, .3, .7 - b}});
    Paths paths(tm);
    paths.add_source_point(source);
    const std::map<vertex_descriptor, double> all = directions(paths);
    for(const vertex_descriptor v : vertices(tm))
    {
      const double distance = paths.shortest_distance_to_source_points(v).first;
      const double in_plane = std::sqrt(CGAL::squared_distance(tm.point(v), paths.point(source.first, source.second)));
      if(distance < 1 || distance > in_plane * (1 + 1e-12)) // the border bends others
        continue;
      const double alone = paths.direction_at_source(v);
      CHECK(difference_of_angles(alone, all.at(v)) < 1e-12);
      const auto g = CGAL::Surface_mesh_geodesics::trace_geodesic(tm, source, alone, distance);
      const auto& p = g.points.back();
      CHECK(CGAL::squared_distance(Kernel::Point_3(p[0], p[1], p[2]), tm.point(v)) < 1e-24);
      ++number;
    }
  }
  CHECK(number > 200);
}

} // namespace

int main()
{
  beside_edges();
  against_single_directions();
  behind_bends();
  in_the_plane();
  hostile_surfaces();
  return test_result();
}
