// trace_geodesic() with faces and edges to avoid: the same bits as on the mesh from which the faces have really been
// removed, and on its filtered graph; a floor with a pillar by hand; starts at the rim and inside; other meshes.

#include "distance_test_helpers.h"
#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"
#include "walls_and_places.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <string>
#include <vector>

using namespace test_meshes;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;

namespace {

using Traced = SMG::Traced_geodesic<Mesh>;
using Face_vector = std::vector<face_descriptor>;

// Bit for bit.
template <typename Other>
void check_same(const Traced& a, const Other& b)
{
  CHECK_EQUAL(int(a.end), int(b.end));
  CHECK_EQUAL(a.length, b.length);
  CHECK_EQUAL(a.direction, b.direction);
  CHECK(a.locations == b.locations);
  CHECK(a.points == b.points);
}

// --- the mesh without the faces ---

Mesh without(const Mesh& tm, const Faces& removed)
{
  Mesh result = tm;
  for(const face_descriptor f : removed)
    CGAL::Euler::remove_face(halfedge(f, result), result);
  return result;
}

// A place that is left: inside of a face, on one of its edges, or at a corner, also at the rim.
Face_location random_start(const Mesh& tm, const Faces& removed, test_support::Random& random)
{
  Face_location l = random_place(tm, removed, random).location;
  if(random.index(3) == 0)
  {
    l.second = {0, 0, 0};
    l.second[random.index(3)] = 1;
  }
  return l;
}

Faces random_obstacles(const Mesh& tm, test_support::Random& random)
{
  Faces removed;
  const double part = random.uniform(.02, .3);
  for(const face_descriptor f : faces(tm))
    if(random.uniform() < part)
      removed.insert(f);
  return removed;
}

// Counts the traces that end at what is avoided, not at the border of the mesh.
std::size_t check_traces(const Mesh& tm, std::size_t n, test_support::Random& random)
{
  const Faces removed = random_obstacles(tm, random);
  const Face_vector avoided(removed.begin(), removed.end());
  Face_vector rest;
  for(const face_descriptor f : faces(tm))
    if(removed.count(f) == 0)
      rest.push_back(f);
  const Mesh less = without(tm, removed);
  const CGAL::Face_filtered_graph<Mesh> filtered(tm, rest);
  const Walls walls = random_walls(tm, .05, random);
  const std::vector<edge_descriptor> range(walls.begin(), walls.end());
  const auto is_wall = boost::make_function_property_map<edge_descriptor>([&](edge_descriptor e)
                                                                           { return walls.count(e) != 0; });
  const auto is_avoided = boost::make_function_property_map<face_descriptor>([&](face_descriptor f)
                                                                              { return removed.count(f) != 0; });
  const auto edge_length = boost::make_function_property_map<edge_descriptor>(
    [&](edge_descriptor e)
    { return std::sqrt(CGAL::squared_distance(tm.point(source(e, tm)), tm.point(target(e, tm)))); });
  std::size_t ended = 0;
  for(std::size_t i = 0; i < n; ++i)
  {
    const Face_location start = random_start(tm, removed, random);
    const double direction = random.uniform(-7., 7.), length = random.uniform(0., 3.);
    const Traced t = SMG::trace_geodesic(tm, start, direction, length, np::faces_to_avoid(avoided));
    check_same(t, SMG::trace_geodesic(less, start, direction, length));
    check_same(t, SMG::trace_geodesic(filtered, start, direction, length));
    check_same(t, SMG::trace_geodesic(tm, start, direction, length, np::faces_to_avoid(is_avoided)));
    for(const Face_location& l : t.locations)
      CHECK(removed.count(l.first) == 0);
    ended += t.end == Traced::AT_BORDER && SMG::trace_geodesic(tm, start, direction, length).end != t.end ? 1 : 0;
    check_same(SMG::trace_geodesic(tm, start, direction, length,
                                   np::faces_to_avoid(is_avoided).edges_to_avoid(range)),
               SMG::trace_geodesic(less, start, direction, length, np::edges_to_avoid(is_wall)));
    check_same(SMG::trace_geodesic_from_edge_lengths(tm, edge_length, start, direction, length,
                                                     np::edges_to_avoid(range).faces_to_avoid(avoided)),
               SMG::trace_geodesic_from_edge_lengths(less, edge_length, start, direction, length,
                                                     np::edges_to_avoid(is_wall)));
  }
  return ended;
}

void on_random_meshes(std::uint64_t seed)
{
  test_support::Random random(seed);
  std::size_t ended = 0;
  for(const Indexed_mesh& indexed : {noisy_sphere(2, .1, seed), rough_terrain(10, 1.5, seed), torus(2, .7, 16, 10),
                                     flat_patch(9, 9, .15, true, seed), saddle_patch(8), irregular_tetrahedron()})
  {
    const test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    for(int i = 0; i < 9; ++i)
      ended += check_traces(tm, 20, random);
  }
  CHECK(ended > 200);
}

// --- by hand ---

Face_location at(const Mesh& tm, double x, double y) { return location_in_plane(x, y, tm); }

// The faces of a grid with corners in the box, and directions of space.
struct Floor
{
  Mesh tm = to_face_graph(flat_patch(9, 9, 0., false, 1));
  Face_vector pillar; // from (3,3) to (6,6)

  Floor()
  {
    for(const face_descriptor f : faces(tm))
    {
      double x = 0, y = 0;
      for(const vertex_descriptor v : vertices_around_face(halfedge(f, tm), tm))
      {
        x += tm.point(v).x() / 3;
        y += tm.point(v).y() / 3;
      }
      if(x > 3 && x < 6 && y > 3 && y < 6)
        pillar.push_back(f);
    }
  }

  vertex_descriptor vertex(double x, double y) const
  {
    for(const vertex_descriptor v : vertices(tm))
      if(tm.point(v).x() == x && tm.point(v).y() == y)
        return v;
    return Mesh::null_vertex();
  }

  template <typename Location>
  Traced trace(const Location& l, double dx, double dy, double length) const
  {
    const auto around = np::faces_to_avoid(pillar);
    const double direction = SMG::geodesic_direction(tm, l, std::array<double, 3>{dx, dy, 0}, around);
    return SMG::trace_geodesic(tm, l, direction, length, around);
  }
};

void check_end(const Traced& t, Traced::End end, double x, double y)
{
  CHECK_EQUAL(int(t.end), int(end));
  CHECK_NEAR(t.points.back()[0], x, 1e-12);
  CHECK_NEAR(t.points.back()[1], y, 1e-12);
}

void on_a_floor()
{
  const test_support::Scope scope("floor");
  const Floor floor;
  CHECK_EQUAL(floor.pillar.size(), std::size_t(18));
  // Into the pillar, across a corner of it, past it, and along it.
  check_end(floor.trace(at(floor.tm, .5, 4.25), 1, 0, 8.), Traced::AT_BORDER, 3, 4.25);
  check_end(floor.trace(at(floor.tm, 1.5, 1.5), 1, 1, 9.), Traced::AT_BORDER, 3, 3);
  check_end(floor.trace(at(floor.tm, .5, 2.75), 1, 0, 8.), Traced::AT_LENGTH, 8.5, 2.75);
  check_end(floor.trace(at(floor.tm, 7.25, 8.5), -1, -2, 8.), Traced::AT_BORDER, 6, 6);
  // From the rim: away from the pillar, into it, and along it to its next vertex. The location is given in both faces
  // of its edge, among them one to avoid.
  for(const double y : {3., 6.})
    for(const double side : {-1., 1.})
    {
      Face_location rim = at(floor.tm, 4.25, y + side * 1e-3);
      const bool is_inside = (y == 3) == (side == 1);
      CHECK_EQUAL(is_inside, std::count(floor.pillar.begin(), floor.pillar.end(), rim.first) == 1);
      for(double& b : rim.second)
        b = std::round(4 * b) / 4; // now it is on the edge
      const double away = y == 3 ? -1 : 1;
      check_end(floor.trace(rim, 0, away, 2.), Traced::AT_LENGTH, 4.25, y + 2 * away);
      check_end(floor.trace(rim, 0, -away, 2.), Traced::AT_BORDER, 4.25, y);
      check_end(floor.trace(rim, 1, 0, 2.), Traced::AT_BORDER, 5, y);
    }
  // From a corner of the pillar, as a vertex, and as a location in a face to avoid.
  const vertex_descriptor corner = floor.vertex(6, 6);
  check_end(floor.trace(corner, 1, 1, 2.), Traced::AT_LENGTH, 6 + std::sqrt(2.), 6 + std::sqrt(2.));
  check_end(floor.trace(corner, -1, -1.5, 2.), Traced::AT_BORDER, 6, 6);
  std::size_t tried = 0;
  for(const face_descriptor f : floor.pillar)
  {
    Face_location l(f, {0, 0, 0});
    std::size_t k = 0;
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, floor.tm), floor.tm))
      l.second[k++] = source(h, floor.tm) == corner ? 1 : 0;
    if(*std::max_element(l.second.begin(), l.second.end()) == 0)
      continue;
    ++tried;
    check_end(floor.trace(l, 1, 1, 2.), Traced::AT_LENGTH, 6 + std::sqrt(2.), 6 + std::sqrt(2.));
    // A vector of a direction leads back to the direction.
    const auto around = np::faces_to_avoid(floor.pillar);
    const auto vector = SMG::geodesic_direction_vector(floor.tm, l, 1.25, around);
    CHECK(std::count(floor.pillar.begin(), floor.pillar.end(), vector.first) == 0);
    CHECK_NEAR(SMG::geodesic_direction(floor.tm, l, vector.second, around), 1.25, 1e-12);
  }
  CHECK(tried > 0);
}

void rejected()
{
  const test_support::Scope scope("rejected");
  const Floor floor;
  const auto trace = [&](const auto& l, const auto& parameters)
  { return SMG::trace_geodesic(floor.tm, l, 0., 1., parameters); };
  const auto around = np::faces_to_avoid(floor.pillar);
  const Face_location inside(floor.pillar[0], {.2, .3, .5});
  CHECK(throws_reason(Reason::INVALID_LOCATION, [&] { trace(inside, around); }));
  CHECK(throws_reason(Reason::INVALID_LOCATION, [&] { trace(floor.vertex(4, 5), around); }));
  CHECK(throws_reason(Reason::INVALID_LOCATION, [&] { trace(at(floor.tm, 4.5, 4.5), around); }));
  CHECK(throws_reason(Reason::INVALID_LOCATION, [&]
  { SMG::geodesic_direction(floor.tm, inside, std::array<double, 3>{1, 0, 0}, around); }));
  CHECK_EQUAL(trace(floor.vertex(3, 3), around).locations.size(), std::size_t(2)); // along the rim
  Mesh removed = floor.tm;
  CGAL::Euler::remove_face(halfedge(floor.pillar[0], removed), removed);
  for(const face_descriptor f : {Mesh::null_face(), face_descriptor(12345), floor.pillar[0]})
  {
    const Face_vector range{floor.pillar[1], f};
    try
    {
      SMG::trace_geodesic(removed, floor.vertex(0, 0), 0., 1., np::faces_to_avoid(range));
      CHECK(false);
    }
    catch(const SMG::Invalid_geodesic_input& error)
    {
      CHECK(error.reason() == Reason::INVALID_DESCRIPTOR && error.element() == 1);
    }
  }
}

// Faces that are handles.
void on_a_polyhedron()
{
  const test_support::Scope scope("Polyhedron_3");
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  using Face = boost::graph_traits<Polyhedron>::face_descriptor;
  const Polyhedron tm = to_face_graph<Polyhedron>(icosphere(2));
  std::vector<Face> range;
  std::size_t i = 0;
  for(const Face f : faces(tm))
    if(++i % 5 == 0)
      range.push_back(f);
  const std::set<Face> set(range.begin(), range.end());
  const auto is_avoided = boost::make_function_property_map<Face>([&](Face f) { return set.count(f) != 0; });
  std::size_t ended = 0;
  for(const Face f : faces(tm))
    if(set.count(f) == 0)
    {
      const std::pair<Face, std::array<double, 3>> start(f, {.2, .3, .5});
      const auto t = SMG::trace_geodesic(tm, start, 1., 2., np::faces_to_avoid(range));
      CHECK_EQUAL(t.length, SMG::trace_geodesic(tm, start, 1., 2., np::faces_to_avoid(is_avoided)).length);
      ended += t.length < 2 ? 1 : 0;
    }
  CHECK(ended > 100);
}

} // namespace

int main()
{
  on_random_meshes(test_support::announce_seed(20261127));
  on_a_floor();
  rejected();
  on_a_polyhedron();
  return test_result();
}
