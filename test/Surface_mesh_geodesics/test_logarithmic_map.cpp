// The direction in which shortest paths leave their source: with the distance it is the logarithmic map, which tracing
// inverts. From vertices, points of edges and of faces, to all vertices and to points of faces.

#include "expected_exceptions.h"
#include "hostile_meshes.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>

#include <CGAL/Surface_mesh_shortest_path.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;
using CGAL::Surface_mesh_geodesics::geodesic_direction;
using CGAL::Surface_mesh_geodesics::trace_geodesic;
using CGAL::Surface_mesh_geodesics::trace_geodesic_from_edge_lengths;

namespace {

using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;
using Traced = CGAL::Surface_mesh_geodesics::Traced_geodesic<Mesh>;

Coordinates coordinates_of(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

Face_location random_location(const Mesh& tm, test_support::Random& random)
{
  const double a = random.uniform(.05, .9), b = random.uniform(.05, .95 - a);
  return {face_descriptor(static_cast<Mesh::size_type>(random.index(num_faces(tm)))), {a, b, 1 - a - b}};
}

// Which vertices and points of edges and faces a path has.
struct Bends
{
  std::size_t number_of_vertices = 0;

  void operator()(boost::graph_traits<Mesh>::halfedge_descriptor, double) {}
  void operator()(vertex_descriptor) { ++number_of_vertices; }
  void operator()(face_descriptor, const Traits::Barycentric_coordinates&) {}
};

struct Counts
{
  std::size_t straight = 0, bent = 0;
  double worst = 0;
};

// Traces from the location of a source by the direction and the distance of the path to each vertex, and to some points
// of faces. If the path meets no vertex between its ends, it must come back to the point.
template <typename Location>
void check_from(const Mesh& tm, const Paths& paths, const Location& from, bool is_vertex, double extent,
                test_support::Random& random, Counts& counts)
{
  for(const vertex_descriptor v : vertices(tm))
  {
    const double d = paths.shortest_distance_to_source_points(v).first;
    const double direction = paths.direction_at_source(v);
    if(d < 0)
    {
      CHECK(std::isnan(direction));
      continue;
    }
    CHECK(direction >= 0 && direction < 2 * pi);
    Bends bends;
    paths.shortest_path_sequence_to_source_points(v, bends);
    if(bends.number_of_vertices > (is_vertex ? 2u : 1u))
    {
      ++counts.bent;
      continue;
    }
    ++counts.straight;
    const Traced g = trace_geodesic(tm, from, direction, d);
    const double error = length(g.points.back() - coordinates_of(tm.point(v)));
    counts.worst = (std::max)(counts.worst, error / extent);
    CHECK(error <= 1e-9 * extent);
    CHECK(g.length >= d - 1e-9 * extent); // it may end at a vertex of the border
  }
  for(int i = 0; i < 10; ++i)
  {
    const Face_location to = random_location(tm, random);
    const Paths::Barycentric_coordinates b{{to.second[0], to.second[1], to.second[2]}};
    const double d = paths.shortest_distance_to_source_points(to.first, b).first;
    Bends bends;
    if(d >= 0)
      paths.shortest_path_sequence_to_source_points(to.first, b, bends);
    if(d < 0 || bends.number_of_vertices > (is_vertex ? 1u : 0u))
      continue;
    ++counts.straight;
    const Traced g = trace_geodesic(tm, from, paths.direction_at_source(to.first, b), d);
    const double error = length(g.points.back() - coordinates_of(paths.point(to.first, b)));
    counts.worst = (std::max)(counts.worst, error / extent);
    CHECK(error <= 1e-9 * extent);
  }
}

void check_mesh(const Indexed_mesh& indexed, std::uint64_t seed, int number_of_sources, Counts& counts)
{
  const test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  test_support::Random random(seed);
  double extent = 0;
  for(const Coordinates& p : indexed.points)
    extent = (std::max)(extent, length(p - indexed.points.front()));
  for(int i = 0; i < number_of_sources; ++i)
  {
    Paths paths(tm);
    Face_location from = random_location(tm, random);
    if(i % 3 == 0)
    {
      const vertex_descriptor v = target(halfedge(from.first, tm), tm);
      const auto around = halfedges_around_target(v, tm);
      if(std::count_if(around.begin(), around.end(), [&](auto h) { return is_border(h, tm); }) > 1)
        continue; // each umbrella of a pinched vertex has a frame of its own
      paths.add_source_point(v);
      check_from(tm, paths, v, true, extent, random, counts);
      continue;
    }
    if(i % 3 == 1)
      from.second = {from.second[0] + from.second[1], 0, from.second[2]};
    paths.add_source_point(from.first, {{from.second[0], from.second[1], from.second[2]}});
    check_from(tm, paths, from, false, extent, random, counts);
  }
}

void test_collection()
{
  Counts counts;
  std::uint64_t seed = 1;
  for(const Indexed_mesh& indexed : small_collection(2))
    check_mesh(indexed, ++seed, 6, counts);
  std::cout << counts.straight << " straight paths, " << counts.bent << " bent ones, worst error " << counts.worst
            << " of the extent\n";
  CHECK(counts.straight > 1000 && counts.bent > 100);
}

// In the plane, the logarithmic map of a vertex inside is the difference of the points, up to a rotation.
void test_plane()
{
  const test_support::Scope scope("plane");
  const Mesh tm = to_face_graph(flat_patch(9, 9, .15, true, 3));
  test_support::Random random(4);
  for(int i = 0; i < 30; ++i)
  {
    Paths paths(tm);
    Face_location from = random_location(tm, random);
    if(i % 3 == 1)
      from.second = {0, .25, .75};
    if(i % 3 == 2)
      from.second = {0, 0, 1};
    paths.add_source_point(from.first, {{from.second[0], from.second[1], from.second[2]}});
    const Coordinates p = coordinates_of(paths.point(from.first, {{from.second[0], from.second[1], from.second[2]}}));
    const double zero = geodesic_direction(tm, from, Coordinates{1, 0, 0});
    for(const vertex_descriptor v : vertices(tm))
    {
      const Coordinates q = coordinates_of(tm.point(v)) - p;
      if(length(q) < 1e-9)
      {
        CHECK_EQUAL(paths.direction_at_source(v), 0.);
        continue;
      }
      CHECK(std::abs(std::remainder(paths.direction_at_source(v) - zero - std::atan2(q[1], q[0]), 2 * pi)) < 1e-12);
    }
  }
}

// At the apex of a cone, the edges to its n neighbors divide the full turn evenly.
void test_cone()
{
  for(const std::size_t n : {3u, 5u, 8u, 24u})
  {
    const Mesh tm = to_face_graph(cone_fan(n));
    Paths paths(tm);
    paths.add_source_point(vertex_descriptor(0));
    std::vector<double> directions;
    for(std::size_t i = 1; i <= n; ++i)
      directions.push_back(paths.direction_at_source(vertex_descriptor(static_cast<Mesh::size_type>(i))));
    for(std::size_t i = 0; i < n; ++i)
      CHECK_NEAR(std::remainder(directions[(i + 1) % n] - directions[i] - 2 * pi / static_cast<double>(n), 2 * pi), 0.,
                 1e-13);
  }
}

// Several sources, some in one face and on one edge: the direction is in the frame of the nearest one.
void test_several_sources()
{
  const test_support::Scope scope("several sources");
  const Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  test_support::Random random(6);
  for(int i = 0; i < 10; ++i)
  {
    Paths paths(tm);
    const face_descriptor f(static_cast<Mesh::size_type>(random.index(num_faces(tm))));
    std::vector<Face_location> sources;
    for(int k = 0; k < 6; ++k)
    {
      const double a = random.uniform(.1, .8), b = random.uniform(.02, .9 - a);
      sources.push_back({f, {a, k < 2 ? 1 - a : b, k < 2 ? 0 : 1 - a - b}});
    }
    sources.push_back({face_descriptor(3), {0, 0, 1}});
    sources.push_back(random_location(tm, random));
    for(const Face_location& s : sources)
      paths.add_source_point(s.first, {{s.second[0], s.second[1], s.second[2]}});
    for(const vertex_descriptor v : vertices(tm))
    {
      const auto d = paths.shortest_distance_to_source_points(v);
      const std::size_t number = paths.nearest_source_point(v);
      Bends bends;
      paths.shortest_path_sequence_to_source_points(v, bends);
      if(bends.number_of_vertices > (number == 6 ? 2u : 1u))
        continue;
      const Traced g = trace_geodesic(tm, sources[number], paths.direction_at_source(v), d.first);
      CHECK(length(g.points.back() - coordinates_of(tm.point(v))) < 1e-9);
    }
  }
}

// Surfaces that are given by lengths: a cylinder of lengths only.
void test_edge_lengths()
{
  const test_support::Scope scope("edge lengths");
  const Mesh tm = to_face_graph(noisy_sphere(2, .1, 5));
  // Twice the length of each edge: the same directions.
  const auto lengths = boost::make_function_property_map<boost::graph_traits<Mesh>::edge_descriptor>(
    [&](boost::graph_traits<Mesh>::edge_descriptor e)
    { return 2 * std::sqrt(CGAL::squared_distance(tm.point(source(e, tm)), tm.point(target(e, tm)))); });
  Paths by_points(tm), by_lengths(tm);
  by_lengths.use_edge_lengths(lengths);
  std::map<vertex_descriptor, double> all;
  by_points.add_source_point(vertex_descriptor(7));
  by_lengths.add_source_point(vertex_descriptor(7));
  by_points.directions_at_source(boost::make_assoc_property_map(all));
  CHECK_EQUAL(all.size(), num_vertices(tm));
  for(const vertex_descriptor v : vertices(tm))
    CHECK_NEAR(all[v], by_points.direction_at_source(v), 1e-12);
  for(const vertex_descriptor v : vertices(tm))
    CHECK_NEAR(std::remainder(by_points.direction_at_source(v) - by_lengths.direction_at_source(v), 2 * pi), 0., 1e-9);
}

// Hostile meshes: each vertex that is reached has a direction.
void test_hostile_meshes()
{
  std::size_t number = 0;
  for(std::uint64_t seed = 0; seed < 400; ++seed)
  {
    const test_support::Scope scope("hostile " + std::to_string(seed));
    test_support::Random random(seed);
    Mesh tm;
    if(!hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), tm))
      continue;
    Paths paths(tm);
    const Face_location from = random_location(tm, random);
    paths.add_source_point(from.first, {{from.second[0], from.second[1], from.second[2]}});
    for(const vertex_descriptor v : vertices(tm))
    {
      const double direction = paths.direction_at_source(v);
      const bool is_reached = paths.shortest_distance_to_source_points(v).first >= 0;
      CHECK(is_reached ? direction >= 0 && direction < 2 * pi : std::isnan(direction));
      number += is_reached;
    }
  }
  CHECK(number > 3000);
}

// From a point in a face along its first halfedge: rounding makes directions slightly negative, which are 0 then, not
// a full turn.
void test_directions_next_to_a_full_turn()
{
  test_support::Random random(20261130);
  std::size_t zeros = 0;
  for(std::size_t i = 0; i < 100; ++i)
  {
    Mesh tm;
    const auto f = tm.add_face(
      tm.add_vertex(Kernel::Point_3(0, 0, 0)),
      tm.add_vertex(Kernel::Point_3(random.uniform(1., 2.), random.uniform(-.5, .5), random.uniform())),
      tm.add_vertex(Kernel::Point_3(random.uniform(), random.uniform(.2, 1.2), random.uniform())));
    Paths paths(tm);
    const double a = random.uniform(.1, .6), b = random.uniform(.1, .3);
    paths.add_source_point(f, {1 - a - b, a, b});
    for(std::size_t k = 1; k < 40; ++k)
    {
      const double way = (1 - a - b) * static_cast<double>(k) / 40;
      const double direction = paths.direction_at_source(f, {1 - a - b - way, a + way, b});
      CHECK(direction >= 0 && direction < 2 * pi);
      CHECK_NEAR(std::sin(direction), 0., 1e-12);
      zeros += direction == 0;
    }
  }
  CHECK(zeros > 500);
}

} // namespace

int main()
{
  test_directions_next_to_a_full_turn();
  test_plane();
  test_cone();
  test_several_sources();
  test_edge_lengths();
  test_hostile_meshes();
  test_collection();
  return test_result();
}
