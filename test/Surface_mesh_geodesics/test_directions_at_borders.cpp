// Directions at sources that are vertices of a border or of a rim: angles from the first edge, also where faces have
// been removed or are avoided, and where the angle of all faces exceeds a full circle. Tracing in the direction of a
// straight path leads back to its end. Sources on edges of a rim and on walls, and directions of vectors there.

#include "faces_to_avoid.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/squared_distance_3.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using namespace test_meshes;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;

namespace {

using Paths = CGAL::Surface_mesh_geodesic_paths<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;
using Avoided = std::vector<face_descriptor>;

// Counts the vertices that a path passes.
struct Vertices_of_path
{
  std::size_t number = 0;

  void operator()(boost::graph_traits<Mesh>::halfedge_descriptor, double) {}
  void operator()(vertex_descriptor) { ++number; }
  void operator()(face_descriptor, const Paths::Barycentric_coordinates&) {}
};

// Does a path pass no vertex but its ends? `number_of_ends` says how many of them are vertices.
bool is_straight(const Paths& paths, vertex_descriptor v, std::size_t number_of_ends)
{
  Vertices_of_path passed;
  paths.shortest_path_sequence_to_source_points(v, passed);
  return passed.number <= number_of_ends;
}

double distance_to(const Mesh& tm, vertex_descriptor u, const std::array<double, 3>& p)
{
  return std::sqrt(CGAL::squared_distance(tm.point(u), Kernel::Point_3(p[0], p[1], p[2])));
}

// Traces to all vertices to which straight paths lead from v. Returns their number.
std::size_t check_source(const Mesh& tm, vertex_descriptor v, const Avoided& avoided)
{
  Paths paths(tm);
  paths.avoid_faces(avoided);
  paths.add_source_point(v);
  std::vector<double> all(num_vertices(tm));
  paths.directions_at_source(boost::make_iterator_property_map(all.begin(), get(boost::vertex_index, tm)));
  std::size_t n = 0;
  for(const vertex_descriptor u : vertices(tm))
  {
    const double d = paths.shortest_distance_to_source_points(u).first;
    if(u == v || d < 0 || !is_straight(paths, u, 2))
      continue;
    const double direction = paths.direction_at_source(u);
    CHECK(direction >= 0);
    CHECK_NEAR(direction, all[std::size_t(u)], 1e-9);
    const auto traced = SMG::trace_geodesic(tm, v, direction, d, np::faces_to_avoid(avoided));
    CHECK_NEAR(distance_to(tm, u, traced.points.back()), 0., 1e-9);
    ++n;
  }
  return n;
}

// The same with faces that are removed from the mesh.
std::size_t check_removed(Mesh tm, vertex_descriptor v, const Avoided& removed)
{
  for(const face_descriptor f : removed)
    CGAL::Euler::remove_face(halfedge(f, tm), tm);
  return tm.has_valid_index(v) && !tm.is_removed(v) && !tm.is_isolated(v) ? check_source(tm, v, {}) : 0;
}

// n faces around vertex 0. Every other vertex is raised and lowered by z.
Mesh fan(std::size_t n, double z)
{
  Mesh tm;
  const vertex_descriptor center = tm.add_vertex(Kernel::Point_3(0, 0, 0));
  std::vector<vertex_descriptor> rim;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2 * pi * double(i) / double(n);
    rim.push_back(tm.add_vertex(Kernel::Point_3(std::cos(angle), std::sin(angle), i % 2 == 0 ? z : -z)));
  }
  for(std::size_t i = 0; i < n; ++i)
    tm.add_face(center, rim[i], rim[(i + 1) % n]);
  return tm;
}

// One face of a fan is missing. The directions of its neighbors are the sums of the angles before them.
void fans()
{
  for(const double z : {0., 1.2})
    for(const std::size_t n : {6u, 10u})
      for(std::size_t gap = 0; gap < n; ++gap)
      {
        const test_support::Scope scope("fan of " + std::to_string(n) + ", face " + std::to_string(gap));
        const Mesh tm = fan(n, z);
        const vertex_descriptor center(0);
        const Avoided avoided{face_descriptor(static_cast<unsigned int>(gap))};
        CHECK_EQUAL(check_source(tm, center, avoided), n);
        CHECK_EQUAL(check_removed(tm, center, avoided), n);
        Paths paths(tm);
        paths.avoid_faces(avoided);
        paths.add_source_point(center);
        const double side = std::sqrt(1 + z * z);
        const double chord = std::sqrt(2 - 2 * std::cos(2 * pi / double(n)) + 4 * z * z);
        const double corner = 2 * std::asin(chord / 2 / side);
        for(std::size_t k = 0; k < n; ++k)
        {
          const vertex_descriptor u(static_cast<unsigned int>(1 + (gap + 1 + k) % n));
          CHECK_NEAR(paths.direction_at_source(u), double(k) * corner, 1e-12);
        }
      }
}

// Holes at random; every vertex is a source.
void random_holes()
{
  std::size_t n = 0;
  for(std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    const test_support::Scope scope("holes, seed " + std::to_string(seed));
    test_support::Random random(seed);
    const Mesh tm = to_face_graph(noisy_sphere(1, .3, seed));
    const Avoided avoided = random_faces(tm, .2, random);
    for(const vertex_descriptor v : vertices(tm))
    {
      // A vertex with several umbrellas has a frame for each.
      std::size_t gaps = 0;
      const auto is_left = [&](auto h)
      { return std::count(avoided.begin(), avoided.end(), face(h, tm)) == 0; };
      for(const auto h : halfedges_around_target(v, tm))
        gaps += is_left(h) && !is_left(opposite(h, tm)) ? 1 : 0;
      if(gaps != 1)
        continue;
      const std::size_t straight = check_source(tm, v, avoided);
      CHECK_EQUAL(check_removed(tm, v, avoided), straight);
      n += straight;
    }
  }
  CHECK(n > 1000);
}

// Calls visit(u, direction, distance) for all vertices to which straight paths lead.
template <typename Visit>
void for_each_straight_path(const Mesh& tm, const Paths& paths, Visit visit)
{
  for(const vertex_descriptor u : vertices(tm))
  {
    const double d = paths.shortest_distance_to_source_points(u).first;
    if(d > 0 && is_straight(paths, u, 1))
      visit(u, paths.direction_at_source(u), d);
  }
}

// The point of side k of a face.
Face_location on_side(face_descriptor f, std::size_t k)
{
  Face_location l(f, {0, 0, 0});
  l.second[k] = .4;
  l.second[(k + 1) % 3] = .6;
  return l;
}

// A source on an edge at the rim may be given in the face to avoid. Tracing takes it there as well.
void sources_on_rims()
{
  const test_support::Scope scope("rims");
  std::size_t n = 0;
  const Mesh tm = to_face_graph(noisy_sphere(1, .3, 2));
  for(const face_descriptor f : faces(tm))
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Face_location source = on_side(f, k);
      const Avoided avoided{f};
      Paths paths(tm);
      paths.avoid_faces(avoided);
      paths.add_source_point(source.first, source.second);
      for_each_straight_path(tm, paths, [&](vertex_descriptor u, double direction, double d)
      {
        const auto traced = SMG::trace_geodesic(tm, source, direction, d, np::faces_to_avoid(avoided));
        CHECK_NEAR(distance_to(tm, u, traced.points.back()), 0., 1e-9);
        ++n;
      });
    }
  CHECK(n > 1000);
}

// A source on a wall: directions are those of its location in the face into which the path leaves.
void sources_on_walls()
{
  const test_support::Scope scope("walls");
  const Mesh tm = to_face_graph(noisy_sphere(1, .3, 2));
  for(const face_descriptor f : faces(tm))
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Face_location source = on_side(f, k);
      auto h = halfedge(f, tm);
      for(std::size_t i = 0; i < k; ++i)
        h = next(h, tm);
      const auto o = opposite(h, tm);
      Face_location across(face(o, tm), {0, 0, 0});
      auto g = halfedge(across.first, tm);
      for(std::size_t i = 0; i < 3; ++i, g = next(g, tm))
        across.second[i] = g == o ? .6 : g == next(o, tm) ? .4 : 0;
      const std::vector<boost::graph_traits<Mesh>::edge_descriptor> walls{edge(h, tm)};
      Paths paths(tm);
      paths.avoid_edges(walls);
      paths.add_source_point(source.first, source.second);
      std::size_t here = 0, there = 0;
      for_each_straight_path(tm, paths, [&](vertex_descriptor u, double direction, double d)
      {
        const auto error = [&](const Face_location& l)
        {
          const auto traced = SMG::trace_geodesic(tm, l, direction, d, np::edges_to_avoid(walls));
          return distance_to(tm, u, traced.points.back());
        };
        const bool is_here = error(source) < 1e-9;
        CHECK(is_here || error(across) < 1e-9);
        ++(is_here ? here : there);
      });
      CHECK(here > 0 && there > 0);
    }
}

// Vectors in the faces around a vertex of the border whose faces fill more than a full turn.
void vectors_beyond_a_full_turn()
{
  const test_support::Scope scope("vectors");
  const std::size_t n = 10;
  const Mesh tm = fan(n, 1.2);
  const Avoided avoided{face_descriptor(0)};
  double last = 0;
  for(std::size_t k = 1; k < n; ++k)
  {
    Face_location center(face_descriptor(static_cast<unsigned int>(k)), {0, 0, 0});
    auto h = halfedge(center.first, tm);
    std::size_t corner = 0;
    for(; source(h, tm) != vertex_descriptor(0); h = next(h, tm))
      ++corner;
    center.second[corner] = 1;
    const Kernel::Point_3 middle = CGAL::midpoint(tm.point(target(h, tm)), tm.point(target(next(h, tm), tm)));
    const double direction = SMG::geodesic_direction(tm, center, middle - CGAL::ORIGIN, np::faces_to_avoid(avoided));
    CHECK(direction > last);
    last = direction;
    const auto back = SMG::geodesic_direction_vector(tm, center, direction, np::faces_to_avoid(avoided));
    CHECK_EQUAL(back.first, center.first);
    const double length = std::sqrt(CGAL::squared_distance(middle, Kernel::Point_3(CGAL::ORIGIN)));
    for(int i = 0; i < 3; ++i)
      CHECK_NEAR(back.second[std::size_t(i)], middle[i] / length, 1e-12);
  }
  CHECK(last > 2 * pi);
}

} // namespace

int main()
{
  fans();
  random_holes();
  sources_on_rims();
  sources_on_walls();
  vectors_beyond_a_full_turn();
  return test_result();
}
