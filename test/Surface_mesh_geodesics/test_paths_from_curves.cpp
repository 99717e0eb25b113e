// Paths, queries at any point, and isolines from curves: closed forms in the plane, right angles at the foot, lengths
// of paths on hostile meshes, mixtures with points, changes of sources, visitors, threads.

#include "curve_cases.h"
#include "expected_exceptions.h"
#include "hostile_meshes.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
using SMG::Invalid_geodesic_input;
using Point = Mesh::Point;

namespace {

double distance_in_space(const Point& a, const Point& b) { return std::sqrt(CGAL::squared_distance(a, b)); }

double length_of(const std::vector<Point>& points)
{
  double length = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    length += distance_in_space(points[i - 1], points[i]);
  return length;
}

Paths::Barycentric_coordinates in_traits(const std::array<double, 3>& b) { return {{b[0], b[1], b[2]}}; }

// Checks the path from a place, a vertex or a face and coordinates: its length, its ends. Returns its points.
template <typename... Place>
std::vector<Point> checked_path(const Paths& paths, double size, const Place&... place)
{
  std::vector<Point> points;
  const auto result = paths.shortest_path_points_to_source_points(place..., std::back_inserter(points));
  if(result.first < 0)
  {
    CHECK(points.empty());
    CHECK(paths.nearest_location_of_sources(place...).first == boost::graph_traits<Mesh>::null_face());
    return points;
  }
  CHECK(!points.empty());
  CHECK_NEAR(length_of(points), result.first, 1e-12 * size);
  CHECK_NEAR(distance_in_space(points.front(), paths.point(place...)), 0., 1e-14 * size);
  const auto end = paths.nearest_location_of_sources(place...);
  CHECK_NEAR(distance_in_space(points.back(), paths.point(end.first, end.second)), 0., 1e-12 * size);
  return points;
}

// --- the plane ---

double distance_to_border(const Point& p, double size)
{
  return (std::min)({p.x(), size - p.x(), p.y(), size - p.y()});
}

// From the border of a square: paths are straight and end at the border at a right angle, and isolines are squares.
void border_of_square()
{
  test_support::Scope scope("border of a square");
  const double size = 9;
  const Mesh tm = to_face_graph(flat_patch(9, 9, .3, true, 1));
  Paths paths(tm);
  const std::vector<Curve> border = SMG::border_curves(tm);
  const auto source = paths.add_source_curve(border[0]);
  test_support::Random random(7);
  for(int i = 0; i < 300; ++i)
  {
    const auto l = random_location(tm, random);
    const auto b = in_traits(l.second);
    const Point p = paths.point(l.first, b);
    const auto found = paths.shortest_distance_to_source_points(l.first, b);
    CHECK_NEAR(found.first, distance_to_border(p, size), 1e-14 * size);
    CHECK(found.second == source);
    const std::vector<Point> points = checked_path(paths, size, l.first, b);
    CHECK_NEAR(distance_to_border(points.back(), size), 0., 1e-14 * size);
    CHECK_NEAR(distance_in_space(points.front(), points.back()), found.first, 1e-14 * size);
  }
  for(const vertex_descriptor v : vertices(tm))
    CHECK_NEAR(checked_path(paths, size, v).size() > 0 ? paths.shortest_distance_to_source_points(v).first : -1,
               distance_to_border(tm.point(v), size), 1e-14 * size);
  for(const double value : {.25, 1., 2.75, 4.4})
  {
    std::vector<std::vector<Point>> lines;
    paths.isolines(value, std::back_inserter(lines));
    CHECK_EQUAL(lines.size(), std::size_t(1));
    for(const Point& p : lines[0])
      CHECK_NEAR(distance_to_border(p, size), value, 1e-11 * size);
    CHECK(lines[0].front() == lines[0].back());
    CHECK_NEAR(length_of(lines[0]), 4 * (size - 2 * value), 1.2); // corners are cut off inside faces
  }
}

// A segment inside of one face, and its neighborhood: feet on both sides, at its ends, and a place on it.
void segment_in_face()
{
  test_support::Scope scope("segment in a face");
  const Mesh tm = to_face_graph(flat_patch(3, 3, .3, true, 1));
  const Location a = location_in_plane(1.6, 1.2, tm);
  Location b = a;
  b.second = {a.second[0] - .1, a.second[1] + .05, a.second[2] + .05};
  const Curve curve(tm, std::vector<Location>{a, b});
  Paths paths(tm);
  paths.add_source_curve(curve);
  const Point p = paths.point(a.first, in_traits(a.second)), q = paths.point(b.first, in_traits(b.second));
  test_support::Random random(11);
  bool is_foot_inside = false;
  for(int i = 0; i < 300; ++i)
  {
    const auto l = random_location(tm, random);
    const std::vector<Point> points = checked_path(paths, 3, l.first, in_traits(l.second));
    const CGAL::Vector_3<Kernel> along = q - p, way = points.front() - points.back();
    const double t = along * (points.front() - p) / along.squared_length();
    const Point foot = p + (std::min)(1., (std::max)(0., t)) * along;
    CHECK_NEAR(distance_in_space(points.back(), foot), 0., 1e-13);
    if(t > 0 && t < 1)
    {
      CHECK_NEAR(along * way, 0., 1e-13); // the right angle
      is_foot_inside = true;
    }
  }
  CHECK(is_foot_inside);
  const auto middle = curve.location(0, .5);
  CHECK_NEAR(paths.shortest_distance_to_source_points(middle.first, in_traits(middle.second)).first, 0., 1e-15);
  CHECK(checked_path(paths, 3, middle.first, in_traits(middle.second)).size() <= 2);
  for(const vertex_descriptor v : vertices(tm))
    CHECK(std::isnan(paths.direction_at_source(v)));
}

// --- surfaces ---

// The distances are those of the solver, bit by bit, and paths have their lengths.
void check_paths_from_curves(const Mesh& tm, const std::vector<Curve>& curves, test_support::Random& random)
{
  const double size = size_of(tm);
  SMG::Geodesic_distance_solver<Mesh> solver(tm);
  try
  {
    solver.compute_distances(curves);
  }
  catch(const Invalid_geodesic_input& error)
  {
    CHECK(error.reason() == Invalid_geodesic_input::Reason::INVALID_CURVE);
    return;
  }
  Paths paths(tm);
  for(const Curve& c : curves)
    paths.add_source_curve(c);
  for(const vertex_descriptor v : vertices(tm))
  {
    const auto found = paths.shortest_distance_to_source_points(v);
    const bool is_reached = solver.distance(v) < infinity;
    CHECK(is_reached ? found.first == solver.distance(v) : found.first == -1);
    CHECK_EQUAL(paths.nearest_source_point(v), is_reached ? solver.nearest_source(v) : Paths::no_source);
    checked_path(paths, size, v);
  }
  for(int i = 0; i < 20; ++i)
  {
    const auto l = random_location(tm, random);
    const double d = paths.shortest_distance_to_source_points(l.first, in_traits(l.second)).first;
    const std::vector<Point> points = checked_path(paths, size, l.first, in_traits(l.second));
    // A corner is not farther away than by way of the point, nor the point than by way of the corner.
    auto h = halfedge(l.first, tm);
    for(int k = 0; k < 3 && !points.empty(); ++k, h = next(h, tm))
      CHECK(std::abs(d - solver.distance(target(h, tm)))
            <= distance_in_space(points.front(), tm.point(target(h, tm))) + 1e-13 * size);
  }
}

void hostile_meshes_and_curves()
{
  for(std::uint64_t seed = 1; seed <= 150; ++seed)
  {
    const test_support::Scope scope("hostile " + std::to_string(seed));
    test_support::Random random(seed);
    Mesh tm;
    if(hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), tm))
      check_paths_from_curves(tm, random_curves(tm, random), random);
  }
}

void curves_on_sphere()
{
  const test_support::Scope scope("sphere");
  const Mesh tm = to_face_graph(icosphere(3));
  for(std::uint64_t seed = 1; seed <= 8; ++seed)
  {
    test_support::Random random(seed);
    check_paths_from_curves(tm, random_curves(tm, random), random);
  }
}

// --- sources ---

// Points beside curves are points; without the curve, the bits are those of an object that never saw it.
void mixtures_and_changes()
{
  const test_support::Scope scope("mixtures");
  const Mesh tm = to_face_graph(icosphere(2));
  test_support::Random random(3);
  const Curve curve(tm, random_vertices_along_edges(tm, 4, random));
  const Location inside(*faces(tm).begin(), {.2, .3, .5});
  const vertex_descriptor v = *std::next(vertices(tm).begin(), 40);
  Paths paths(tm), points(tm);
  const auto at_location = paths.add_source_point(inside.first, in_traits(inside.second));
  const auto at_curve = paths.add_source_curve(curve);
  const auto at_vertex = paths.add_source_point(v);
  points.add_source_point(inside.first, in_traits(inside.second));
  points.add_source_point(v);
  CHECK_EQUAL(paths.number_of_source_points(), std::size_t(3));
  SMG::Geodesic_distance_solver<Mesh> solver(tm);
  solver.compute_distances(
    std::vector<Curve>{Curve(tm, std::vector<Location>{inside}), curve, Curve(tm, std::vector{v})});
  bool are_met[3] = {false, false, false};
  for(const vertex_descriptor u : vertices(tm))
  {
    const auto found = paths.shortest_distance_to_source_points(u);
    CHECK_EQUAL(found.first, solver.distance(u));
    const std::size_t i = paths.nearest_source_point(u);
    CHECK(found.second == (i == 0 ? at_location : i == 1 ? at_curve : at_vertex));
    are_met[i] = true;
    checked_path(paths, 2, u);
  }
  CHECK(are_met[0] && are_met[1] && are_met[2]);
  paths.remove_source_point(at_curve);
  for(const vertex_descriptor u : vertices(tm))
    CHECK_EQUAL(paths.shortest_distance_to_source_points(u).first, points.shortest_distance_to_source_points(u).first);
  // A vertex as a curve is a vertex.
  paths.clear();
  paths.add_source_curve(Curve(tm, std::vector{v}));
  points.remove_all_source_points();
  points.add_source_point(v);
  for(const vertex_descriptor u : vertices(tm))
    CHECK_CLOSE(paths.shortest_distance_to_source_points(u).first, points.shortest_distance_to_source_points(u).first,
                1e-14);
  CHECK(points.nearest_location_of_sources(v) == *points.source_points_begin());
  CHECK(!std::isnan(points.direction_at_source(*vertices(tm).begin())));
}

struct Cancelling_visitor : SMG::Geodesic_default_visitor
{
  bool go_further() const { return ++count < 10; }
  mutable int count = 0;
};

// A canceled run, a curve of another mesh, and what comes after them.
void ends_of_runs()
{
  const test_support::Scope scope("ends of runs");
  const Mesh tm = to_face_graph(icosphere(2)), large = to_face_graph(icosphere(4));
  test_support::Random random(5);
  const Curve curve(tm, random_vertices_along_edges(tm, 5, random));
  Paths paths(tm);
  paths.add_source_curve(curve);
  Cancelling_visitor visitor;
  CHECK(!paths.build_sequence_tree_for_faces(visitor));
  CHECK(paths.changed_since_last_build());
  const Location l(*faces(tm).begin(), {.2, .3, .5});
  const double d = paths.shortest_distance_to_source_points(l.first, in_traits(l.second)).first;
  Paths other(tm); // distances of vertices first, windows and strips later
  other.add_source_curve(curve);
  other.build_sequence_tree();
  std::vector<std::vector<Point>> before, after;
  CHECK_EQUAL(other.shortest_distance_to_source_points(l.first, in_traits(l.second)).first, d);
  paths.isolines(d / 2, std::back_inserter(before));
  other.isolines(d / 2, std::back_inserter(after));
  CHECK(before == after);
  CHECK(paths.statistics().intrinsic_mesh_bytes > 0 && paths.statistics().windows_created > 0);
  // A curve of a larger mesh has faces that this one does not have.
  const auto wrong = paths.add_source_curve(Curve(large, std::vector{*std::prev(vertices(large).end())}));
  CHECK(throws_reason(Invalid_geodesic_input::Reason::INVALID_DESCRIPTOR,
                      [&] { paths.shortest_distance_to_source_points(*vertices(tm).begin()); }));
  paths.remove_source_point(wrong);
  CHECK_EQUAL(paths.shortest_distance_to_source_points(l.first, in_traits(l.second)).first, d);
}

// Obstacles and lengths of edges.
void avoided_faces_and_lengths()
{
  const test_support::Scope scope("obstacles and lengths");
  const Mesh tm = to_face_graph(flat_patch(6, 6, .3, true, 1));
  const std::vector<Curve> border = SMG::border_curves(tm);
  Paths paths(tm);
  paths.add_source_curve(border[0]);
  std::vector<face_descriptor> avoided;
  for(const face_descriptor f : faces(tm))
  {
    const auto h = halfedge(f, tm);
    const Point p = CGAL::centroid(tm.point(source(h, tm)), tm.point(target(h, tm)), tm.point(target(next(h, tm), tm)));
    if(p.x() > 1 && p.x() < 5 && p.y() > 1 && p.y() < 2)
      avoided.push_back(f);
  }
  paths.avoid_faces(avoided);
  SMG::Geodesic_distance_solver<Mesh> solver = SMG::Geodesic_distance_solver<Mesh>::avoiding_faces(tm, avoided);
  solver.compute_distances(border);
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(paths.shortest_distance_to_source_points(v).first, solver.distance(v));
    checked_path(paths, 6, v);
  }
  // Twice the lengths: twice the distances.
  Paths scaled(tm);
  scaled.add_source_curve(border[0]);
  Mesh copy = tm; // the map is one of its edges, which have the same numbers
  auto map = copy.add_property_map<Mesh::Edge_index, double>("e:length").first;
  for(const auto e : edges(tm))
    map[e] = 2 * distance_in_space(tm.point(source(e, tm)), tm.point(target(e, tm)));
  scaled.use_edge_lengths(map);
  for(const vertex_descriptor v : vertices(tm))
    CHECK_NEAR(scaled.shortest_distance_to_source_points(v).first, 2 * distance_to_border(tm.point(v), 6), 1e-14);
}

// Several threads may ask one constant object, which builds in two steps.
void threads()
{
  const test_support::Scope scope("threads");
  const Mesh tm = to_face_graph(icosphere(3));
  test_support::Random random(9);
  const Curve curve(tm, random_vertices_along_edges(tm, 9, random));
  Paths paths(tm), expected(tm);
  paths.add_source_curve(curve);
  expected.add_source_curve(curve);
  expected.build_sequence_tree_for_faces();
  std::vector<std::thread> team;
  std::array<std::size_t, 4> wrong{};
  for(std::size_t t = 0; t < wrong.size(); ++t)
    team.emplace_back([&, t]
    {
      const Paths& shared = paths;
      for(const face_descriptor f : faces(tm))
      {
        const auto b = in_traits({.2, .3, .5});
        const vertex_descriptor v = target(halfedge(f, tm), tm);
        std::vector<Point> points;
        const bool is_right
          = t % 2 == 0 ? shared.shortest_path_points_to_source_points(v, std::back_inserter(points)).first
                           == expected.shortest_distance_to_source_points(v).first
                       : shared.shortest_distance_to_source_points(f, b).first
                           == expected.shortest_distance_to_source_points(f, b).first;
        wrong[t] += is_right ? 0 : 1;
      }
    });
  for(std::thread& t : team)
    t.join();
  for(const std::size_t w : wrong)
    CHECK_EQUAL(w, std::size_t(0));
}

} // namespace

int main()
{
  border_of_square();
  segment_in_face();
  curves_on_sphere();
  hostile_meshes_and_curves();
  mixtures_and_changes();
  ends_of_runs();
  avoided_faces_and_lengths();
  threads();
  return test_result();
}
