// Distances from curves: closed forms in the plane and on surfaces that unfold, curves of strange shapes; offsets,
// mixtures with points, feet, limits, invalid input.

#include "curves_in_plane.h"
#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
using SMG::Invalid_geodesic_input;
using Solver = SMG::Geodesic_distance_solver<Mesh>;

namespace {

// --- the plane ---

void border_of_square(const Mesh& tm, double size)
{
  const std::vector<Curve> curves = SMG::border_curves(tm);
  CHECK_EQUAL(curves.size(), std::size_t(1));
  CHECK(curves[0].is_closed());
  CHECK_CLOSE(curves[0].length(tm), 4 * size, 1e-14);
  const Distances d = distances(tm, curves);
  for(const vertex_descriptor v : vertices(tm))
  {
    const Point_2 p = in_plane(tm, v);
    CHECK_NEAR(d.at(v), (std::min)({p[0], size - p[0], p[1], size - p[1]}), 1e-14 * size);
  }
}

// Random polygons, open and closed, that cross themselves; convex domain.
void polygons_in_square(const Mesh& tm, double size, test_support::Random& random)
{
  std::vector<Point_2> corners;
  for(std::size_t i = 2 + random.index(5); i > 0; --i)
    corners.push_back({random.uniform(.01, .99) * size, random.uniform(.01, .99) * size});
  const bool is_closed = random.index(2) == 0;
  std::vector<Location> locations;
  const std::size_t n = corners.size(), number_of_sides = is_closed ? n : n - 1;
  for(std::size_t i = 0; i < number_of_sides; ++i)
    append_crossings(tm, corners[i], corners[(i + 1) % n], locations);
  if(!is_closed)
    locations.push_back(location_in_plane(corners.back()[0], corners.back()[1], tm));
  const Distances d = distances(tm, {Curve(tm, locations, is_closed)});
  for(const vertex_descriptor v : vertices(tm))
  {
    double expected = infinity;
    for(std::size_t i = 0; i < number_of_sides; ++i)
      expected = (std::min)(expected, distance_to_segment(in_plane(tm, v), corners[i], corners[(i + 1) % n]));
    CHECK_NEAR(d.at(v), expected, 1e-13 * size);
  }
}

void test_plane()
{
  test_support::Random random(3);
  for(std::uint64_t seed = 1; seed <= 12; ++seed)
  {
    const test_support::Scope scope("square " + std::to_string(seed));
    // A square of size n; every third one has faces that are up to a thousand times as wide as high.
    const std::size_t n = 3 + seed, m = seed % 3 == 0 ? 1 : n;
    Indexed_mesh indexed = flat_patch(m, n, .3, true, seed);
    const double size = static_cast<double>(n);
    for(Coordinates& p : indexed.points)
    {
      p[0] *= size / static_cast<double>(m);
      if(m == 1)
        p[1] = p[1] < size ? 1e-2 * p[1] : size;
    }
    const Mesh tm = to_face_graph(indexed);
    border_of_square(tm, size);
    for(int i = 0; i < 6; ++i)
      polygons_in_square(tm, size, random);
  }
}

// --- surfaces that unfold ---

void test_tube()
{
  const double height = 3;
  const Mesh tm = to_face_graph(prism_tube(7, 9, 1., height));
  const std::vector<Curve> curves = SMG::border_curves(tm);
  CHECK_EQUAL(curves.size(), std::size_t(2));
  const Distances both = distances(tm, curves), lower = distances(tm, {curves[0]});
  double least = infinity;
  for(const vertex_descriptor v : vertices(tm))
    least = (std::min)(least, tm.point(v).z());
  const bool is_first_at_bottom
    = tm.point(source(halfedge(curves[0].segments()[0].face, tm), tm)).z() < least + height / 2;
  for(const vertex_descriptor v : vertices(tm))
  {
    const double z = tm.point(v).z() - least;
    CHECK_NEAR(both.at(v), (std::min)(z, height - z), 1e-13);
    CHECK_NEAR(lower.at(v), is_first_at_bottom ? z : height - z, 1e-13);
  }
}

// A loop around a cube, halfway up: paths go straight up or down, and from the edges at the top and the bottom inward.
void test_cube()
{
  const double size = 6;
  const Mesh tm = to_face_graph(cube_grid(6));
  std::vector<std::pair<double, vertex_descriptor>> loop; // by the way around
  for(const vertex_descriptor v : vertices(tm))
  {
    const double x = tm.point(v).x(), y = tm.point(v).y();
    if(tm.point(v).z() == size / 2)
      loop.emplace_back(y == 0 ? x : x == size ? size + y : y == size ? 3 * size - x : 4 * size - y, v);
  }
  std::sort(loop.begin(), loop.end());
  std::vector<vertex_descriptor> corners;
  for(const auto& entry : loop)
    corners.push_back(entry.second);
  const Curve curve(tm, corners, true);
  CHECK_CLOSE(curve.length(tm), 4 * size, 1e-14);
  const Distances d = distances(tm, {curve});
  for(const vertex_descriptor v : vertices(tm))
  {
    const double x = tm.point(v).x(), y = tm.point(v).y(), z = tm.point(v).z();
    CHECK_NEAR(d.at(v), std::abs(z - size / 2) + (std::min)({x, size - x, y, size - y}), 1e-14 * size);
  }
}

// The apex of a cone of isosceles triangles has the distance of their height; and that from the rim of a saddle, whose
// angle at the center exceeds a full turn.
void test_cones()
{
  for(const Indexed_mesh& indexed : {cone_fan(5), cone_fan(12), saddle_fan(8)})
  {
    const test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    const Distances d = distances(tm, SMG::border_curves(tm));
    for(const vertex_descriptor v : vertices(tm))
    {
      double expected = is_border(v, tm) ? 0. : infinity;
      if(!is_border(v, tm))
        for(const auto h : halfedges_around_target(v, tm))
        {
          const auto a = tm.point(source(h, tm)), b = tm.point(target(next(h, tm), tm));
          expected = (std::min)(expected,
                                std::sqrt(CGAL::squared_distance(tm.point(v), Kernel::Segment_3(a, b))));
        }
      CHECK_NEAR(d.at(v), expected, 1e-14);
    }
  }
}

// --- strange curves ---

void test_strange_curves()
{
  const Mesh tm = to_face_graph(flat_patch(6, 6, .3, true, 4));
  const vertex_descriptor v(24);
  const face_descriptor f = face(halfedge(v, tm), tm), g = *faces(tm).begin();
  const Location inside(f, {.2, .3, .5}), other(f, {.7, .1, .2}), third(f, {.1, .8, .1}), fourth(f, {.3, .05, .65});
  const auto at = [&](std::size_t k)
  {
    Location l(f, {0, 0, 0});
    l.second[k] = 1;
    return l;
  };
  const auto same = [&](const std::vector<Curve>& a, const std::vector<Curve>& b)
  {
    const Distances x = distances(tm, a), y = distances(tm, b);
    for(const vertex_descriptor u : vertices(tm))
      CHECK_NEAR(x.at(u), y.at(u), 1e-14);
  };
  // A point, in many ways.
  Distances from_vertex;
  SMG::geodesic_distances(tm, boost::make_assoc_property_map(from_vertex), v);
  CHECK(distances(tm, {Curve(tm, v)}) == from_vertex);
  CHECK(distances(tm, {Curve(tm, std::vector<vertex_descriptor>{v, v, v})}) == from_vertex);
  CHECK(distances(tm, {Curve(tm, std::vector<vertex_descriptor>{v, v}, true)}) == from_vertex);
  same({Curve(tm, inside)}, {Curve(tm, std::vector<Location>{inside, inside})});
  // There and back; a segment in pieces; pieces of no length; the same edge twice; crossing; touching.
  same({Curve(tm, std::vector<Location>{inside, other})}, {Curve(tm, std::vector<Location>{inside, other, inside})});
  const Location middle(f, {.45, .2, .35});
  same({Curve(tm, std::vector<Location>{inside, other})},
       {Curve(tm, std::vector<Location>{inside, middle, middle, other}),
        Curve(tm, std::vector<Location>{middle, other})});
  same({Curve(tm, std::vector<Location>{at(0), at(1), at(2)}, true)},
       {Curve(tm, std::vector<Location>{at(0), at(2), at(1), at(0), at(1)})});
  same({Curve(tm, std::vector<Location>{inside, other, third, fourth})},
       {Curve(tm, std::vector<Location>{fourth, third}), Curve(tm, std::vector<Location>{other, third}),
        Curve(tm, std::vector<Location>{other, inside})});
  CHECK(!Curve(tm, std::vector<Location>{inside, other}).is_closed());
#if !defined(CGAL_NO_PRECONDITIONS) && !defined(CGAL_NDEBUG)
  CHECK(throws<CGAL::Precondition_exception>([&] { Curve(tm, v).location(0, 0); }));
  CHECK(throws<CGAL::Precondition_exception>([&] { Curve(tm, std::vector<Location>{inside, other}).location(1, 0); }));
  for(const double parameter : {-.5, 1.5, std::numeric_limits<double>::quiet_NaN()})
    CHECK(throws<CGAL::Precondition_exception>(
      [&] { Curve(tm, std::vector<Location>{inside, other}).location(0, parameter); }));
#endif
  CHECK(throws_reason(Invalid_geodesic_input::Reason::INVALID_CURVE,
                      [&] { Curve(tm, std::vector<Location>{inside, Location(g, {.2, .3, .5})}); }));
}

// --- offsets, mixtures, feet, limits ---

void test_offsets_and_feet()
{
  const std::size_t n = 12;
  const Mesh tm = to_face_graph(flat_patch(n, n, .3, true, 9));
  std::vector<Curve> curves = SMG::border_curves(tm);
  const vertex_descriptor center(84);
  CHECK(!is_border(center, tm));
  curves.emplace_back(tm, center);
  const std::vector<double> offsets{.5, 1.25};
  Solver solver(tm);
  CHECK_EQUAL(solver.nearest_curve_point(center).curve, Solver::no_source);
  solver.compute_distances(curves, CGAL::parameters::source_offsets(offsets));
  std::size_t from_curve = 0;
  for(const vertex_descriptor v : vertices(tm))
  {
    const Point_2 p = in_plane(tm, v), q = in_plane(tm, center);
    const double size = n, to_border = (std::min)({p[0], size - p[0], p[1], size - p[1]}) + .5;
    const double to_center = std::hypot(p[0] - q[0], p[1] - q[1]) + 1.25;
    CHECK_NEAR(solver.distance(v), (std::min)(to_border, to_center), 1e-13);
    if(std::abs(to_border - to_center) < 1e-9)
      continue;
    CHECK_EQUAL(solver.nearest_source(v), std::size_t(to_border < to_center ? 0 : 1));
    const SMG::Surface_curve_point foot = solver.nearest_curve_point(v);
    CHECK_EQUAL(foot.curve, solver.nearest_source(v));
    if(foot.curve == 1)
      continue;
    ++from_curve;
    const Coordinates at = coordinates(curves[0].location(foot.segment, foot.parameter), tm);
    CHECK_NEAR(std::hypot(p[0] - at[0], p[1] - at[1]) + .5, solver.distance(v), 1e-13);
  }
  CHECK(from_curve > num_vertices(tm) / 3);
  // Offsets that leave a curve no vertex; of curves at one place, the first one with the smallest offset.
  curves = {curves[0], curves[0], Curve(tm, center)};
  solver.compute_distances(curves, CGAL::parameters::source_offsets(std::vector<double>{100., 100., 0.}));
  for(const vertex_descriptor v : vertices(tm))
    CHECK_EQUAL(solver.nearest_source(v), std::size_t(2));
  solver.compute_distances(curves, CGAL::parameters::source_offsets(std::vector<double>{1., .5, 100.}));
  for(const vertex_descriptor v : vertices(tm))
  {
    const Point_2 p = in_plane(tm, v);
    const double size = n;
    CHECK_EQUAL(solver.nearest_source(v), std::size_t(1));
    CHECK_NEAR(solver.distance(v), (std::min)({p[0], size - p[0], p[1], size - p[1]}) + .5, 1e-13);
  }
}

// A point of a curve that is nearer than the rest of it is a source in all directions.
void points_on_farther_curves()
{
  const std::size_t n = 12;
  const Mesh tm = to_face_graph(flat_patch(n, n, 0., true, 5));
  std::vector<vertex_descriptor> row(n + 1);
  for(const vertex_descriptor v : vertices(tm))
    if(in_plane(tm, v)[1] == 6)
      row[static_cast<std::size_t>(in_plane(tm, v)[0])] = v;
  Solver solver(tm);
  for(const std::size_t at : {0u, 3u, 6u})
  {
    const std::vector<Curve> curves{Curve(tm, row), Curve(tm, row[at])};
    solver.compute_distances(curves, CGAL::parameters::source_offsets(std::vector<double>{1., .25}));
    for(const vertex_descriptor v : vertices(tm))
    {
      const Point_2 p = in_plane(tm, v);
      const double to_row = std::abs(p[1] - 6) + 1;
      CHECK_NEAR(solver.distance(v), (std::min)(to_row, std::hypot(p[0] - double(at), p[1] - 6) + .25), 1e-13);
    }
  }
}

struct Canceling_visitor
  : CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
  std::size_t calls = 0;
  bool go_further() { return ++calls < 3; }
};

struct Throwing_visitor
  : CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
  bool go_further() { throw std::runtime_error("no"); }
};

void test_limits()
{
  namespace np = CGAL::parameters;
  const Mesh tm = to_face_graph(noisy_sphere(3, .2, 5));
  const std::vector<Curve> curves{Curve(tm, std::vector<vertex_descriptor>{
    source(halfedge(face_descriptor(7), tm), tm), target(halfedge(face_descriptor(7), tm), tm)})};
  Distances all = distances(tm, curves);
  Solver solver(tm);
  const double radius = .7;
  solver.compute_distances(curves, np::maximum_distance(radius));
  for(const vertex_descriptor v : vertices(tm))
    CHECK_EQUAL(solver.distance(v), all[v] <= radius ? all[v] : infinity);
  for(const Mesh::size_type i : {3u, 100u, 200u})
    CHECK_EQUAL(solver.compute_distance(curves, vertex_descriptor(i)), all[vertex_descriptor(i)]);
  const std::vector<vertex_descriptor> targets{vertex_descriptor(3), vertex_descriptor(200)};
  Distances of_targets;
  SMG::geodesic_distances(tm, boost::make_assoc_property_map(of_targets), curves, np::targets(targets));
  for(const vertex_descriptor v : vertices(tm)) // those that are farther away may be left out
    CHECK(of_targets[v] == all[v] || (of_targets[v] == infinity && v != targets[0] && v != targets[1]));
  // Nothing is left of runs that ended early, failed or were canceled; points come after curves, and the other way.
  Canceling_visitor visitor;
  CHECK(!solver.compute_distances(curves, np::visitor(std::ref(visitor))));
  CHECK_EQUAL(solver.distance(vertex_descriptor(0)), infinity);
  solver.compute_distances(curves);
  CHECK(throws<Invalid_geodesic_input>(
    [&] { solver.compute_distances(curves, np::source_offsets(std::vector<double>{1., 2.})); }));
  for(const vertex_descriptor v : vertices(tm))
    CHECK_EQUAL(solver.distance(v), all[v]);
  Solver fresh(tm);
  fresh.compute_distances(vertex_descriptor(5));
  solver.compute_distances(vertex_descriptor(5));
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(solver.distance(v), fresh.distance(v));
    CHECK_EQUAL(solver.nearest_source(v), std::size_t(0));
  }
  // The parallel tag gives the same, by one thread; so does a single curve.
  Distances parallel;
  SMG::geodesic_distances<CGAL::Parallel_if_available_tag>(tm, boost::make_assoc_property_map(parallel), curves[0]);
  CHECK(parallel == all);
}

// One solver after the other curves, which divide the mesh into more faces or fewer, near and far: nothing is left of
// the runs before, whether they were complete, within a radius, canceled or ended by an exception.
void test_many_runs()
{
  namespace np = CGAL::parameters;
  test_support::Random random(9);
  const Mesh tm = to_face_graph(noisy_sphere(2, .2, 6));
  Solver solver(tm);
  for(int i = 0; i < 40; ++i)
  {
    const std::vector<Curve> curves{Curve(tm, random_locations(tm, 1 + random.index(12), random))};
    Canceling_visitor canceling;
    if(random.index(4) == 0)
      CHECK(!solver.compute_distances(curves, np::visitor(std::ref(canceling))));
    if(random.index(4) == 0)
      CHECK(throws<std::runtime_error>([&] { solver.compute_distances(curves, np::visitor(Throwing_visitor())); }));
    if(random.index(4) == 0)
      solver.compute_distances(vertex_descriptor(0));
    const double radius = random.index(2) == 0 ? .3 : infinity;
    solver.compute_distances(curves, np::maximum_distance(radius));
    Solver fresh(tm);
    fresh.compute_distances(curves);
    for(const vertex_descriptor v : vertices(tm))
    {
      const double expected = fresh.distance(v) <= radius ? fresh.distance(v) : infinity;
      CHECK_EQUAL(solver.distance(v), expected);
      if(expected < infinity)
        CHECK_EQUAL(solver.nearest_curve_point(v).segment, fresh.nearest_curve_point(v).segment);
    }
  }
}

// --- scales, numbers, lengths, obstacles ---

void test_invariance()
{
  test_support::Random random(8);
  for(const Indexed_mesh& indexed : small_collection(4))
  {
    const test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    const std::vector<Curve> curves = random_curves(tm, random);
    const Distances d = distances(tm, curves);
    Mesh scaled = tm;
    for(const vertex_descriptor v : vertices(tm))
      scaled.point(v) = Kernel::Point_3(1024 * tm.point(v).x(), 1024 * tm.point(v).y(), 1024 * tm.point(v).z());
    for(const auto& entry : distances(scaled, curves))
      CHECK_EQUAL(entry.second, 1024 * d.at(entry.first));
    std::vector<Curve> reversed(curves.rbegin(), curves.rend());
    for(const auto& entry : distances(tm, reversed))
      CHECK_CLOSE(entry.second, d.at(entry.first), 1e-14);
    std::map<Mesh::Edge_index, double> length;
    for(const auto e : edges(tm))
      length[e] = std::sqrt(CGAL::squared_distance(tm.point(source(e, tm)), tm.point(target(e, tm))));
    Distances by_length;
    SMG::geodesic_distances_from_edge_lengths(tm, boost::make_assoc_property_map(length),
                                              boost::make_assoc_property_map(by_length), curves);
    Solver from_lengths = Solver::from_edge_lengths(tm, boost::make_assoc_property_map(length));
    from_lengths.compute_distances(curves);
    for(const auto& entry : by_length)
    {
      CHECK_NEAR(entry.second, d.at(entry.first), 1e-12 * extent(tm));
      CHECK_EQUAL(from_lengths.distance(entry.first), entry.second);
    }
  }
}

void test_obstacles()
{
  namespace np = CGAL::parameters;
  const Mesh tm = to_face_graph(flat_patch(4, 4, 0., false, 1));
  // The faces right of the line x = 2 are avoided; the line itself is the rim.
  std::vector<face_descriptor> avoided;
  face_descriptor inner;
  std::vector<vertex_descriptor> rim(5);
  for(const face_descriptor f : faces(tm))
  {
    bool is_right = true;
    for(const vertex_descriptor v : vertices_around_face(halfedge(f, tm), tm))
      is_right = is_right && tm.point(v).x() > 1.9;
    if(is_right)
      avoided.push_back(inner = f);
  }
  for(const vertex_descriptor v : vertices(tm))
    if(std::abs(tm.point(v).x() - 2) < 1e-9)
      rim[static_cast<std::size_t>(std::lround(tm.point(v).y()))] = v;
  for(const bool is_reversed : {false, true})
  {
    if(is_reversed)
      std::reverse(rim.begin(), rim.end());
    Distances d;
    SMG::geodesic_distances(tm, boost::make_assoc_property_map(d), Curve(tm, rim), np::faces_to_avoid(avoided));
    for(const vertex_descriptor v : vertices(tm))
      CHECK_NEAR(d[v] < infinity ? d[v] : -1, tm.point(v).x() > 2.1 ? -1 : 2 - tm.point(v).x(), 1e-14);
  }
  Distances d;
  const std::vector<Location> inside{Location(inner, {.2, .3, .5}), Location(inner, {.3, .2, .5})};
  CHECK(throws_reason(Invalid_geodesic_input::Reason::INVALID_LOCATION, [&] {
    SMG::geodesic_distances(tm, boost::make_assoc_property_map(d), Curve(tm, inside), np::faces_to_avoid(avoided));
  }));
}

// --- invalid curves ---

// Halfedges that the mesh does not have: beyond its last one, and of a face that has been removed.
void test_invalid_halfedges()
{
  using Halfedges = std::vector<Mesh::Halfedge_index>;
  Mesh tm = to_face_graph(icosphere(1));
  const auto h = halfedge(face_descriptor(0), tm), border = opposite(h, tm);
  const auto is_rejected_at = [&](std::size_t position, const Halfedges& halfedges)
  {
    try
    {
      Curve::along_halfedges(tm, halfedges);
    }
    catch(const Invalid_geodesic_input& e)
    {
      return e.reason() == Invalid_geodesic_input::Reason::INVALID_CURVE && e.element() == position;
    }
    return false;
  };
  CHECK(is_rejected_at(0, Halfedges{boost::graph_traits<Mesh>::null_halfedge()}));
  CHECK(is_rejected_at(0, Halfedges{Mesh::Halfedge_index(12345678)}));
  CHECK(is_rejected_at(1, Halfedges{h, Mesh::Halfedge_index(12345678)}));
  CHECK(!is_rejected_at(1, Halfedges{border, h}));
  // Two faces that share an edge: only that edge is gone.
  CGAL::Euler::remove_face(h, tm);
  CGAL::Euler::remove_face(border, tm);
  CHECK(tm.has_garbage());
  CHECK(is_rejected_at(0, Halfedges{h}));
  CHECK(is_rejected_at(0, Halfedges{border, h}));
}

void test_invalid_curves()
{
  const auto reason = Invalid_geodesic_input::Reason::INVALID_CURVE;
  const Mesh tm = to_face_graph(icosphere(1));
  const auto null_vertex = boost::graph_traits<Mesh>::null_vertex();
  const auto null_face = boost::graph_traits<Mesh>::null_face();
  const vertex_descriptor v(0);
  CHECK(throws_reason(reason, [&] { Curve(tm, std::vector<vertex_descriptor>()); }));
  CHECK(throws_reason(reason, [&] { Curve(tm, null_vertex); }));
  CHECK(throws_reason(reason, [&] { Curve(tm, Location(null_face, {1, 0, 0})); }));
  CHECK(throws_reason(reason, [&] { Curve(tm, Location(face_descriptor(0), {2, 0, -1})); }));
  CHECK(throws_reason(reason, [&] { Curve::along_halfedges(tm, std::vector<Mesh::Halfedge_index>()); }));
  const auto h = halfedge(v, tm);
  CHECK(throws_reason(reason, [&] {
    Curve::along_halfedges(tm, std::vector<Mesh::Halfedge_index>{h, h});
  }));
  CHECK(Curve::along_halfedges(tm, std::vector<Mesh::Halfedge_index>{h, opposite(h, tm)}).is_closed());
  vertex_descriptor far_vertex = v;
  for(const vertex_descriptor u : vertices(tm))
    if(CGAL::squared_distance(tm.point(u), tm.point(v)) > 3)
      far_vertex = u;
  CHECK(throws_reason(reason, [&] { Curve(tm, std::vector<vertex_descriptor>{v, far_vertex}); }));
  // A curve of another mesh.
  const Mesh small = to_face_graph(regular_tetrahedron());
  Distances d;
  CHECK(throws_reason(Invalid_geodesic_input::Reason::INVALID_DESCRIPTOR, [&] {
    SMG::geodesic_distances(small, boost::make_assoc_property_map(d),
                            Curve(tm, Location(face_descriptor(9), {1, 0, 0})));
  }));
  // An isolated vertex is a source, too; an empty range of curves reaches nothing.
  Mesh isolated = small;
  const vertex_descriptor alone = isolated.add_vertex(Kernel::Point_3(5, 5, 5));
  const Distances from_alone = distances(isolated, {Curve(isolated, alone)});
  CHECK_EQUAL(from_alone.at(alone), 0.);
  CHECK_EQUAL(from_alone.at(v), infinity);
  CHECK_EQUAL(distances(small, {}).at(v), infinity);
}

} // namespace

int main()
{
  test_plane();
  test_tube();
  test_cube();
  test_cones();
  test_strange_curves();
  test_offsets_and_feet();
  points_on_farther_curves();
  test_limits();
  test_many_runs();
  test_invariance();
  test_obstacles();
  test_invalid_halfedges();
  test_invalid_curves();
  return test_result();
}
