// geodesic_isolines() from curves: closed forms in the plane and on a tube; the lines of the class for paths, which
// keeps all windows and strips, on all kinds of meshes; vertices that are put on the lines, whose distances
// geodesic_distances() finds on the other mesh; obstacles, offsets, radius, and what is rejected.

#include "curve_cases.h"
#include "curves_and_walls.h"
#include "curves_in_plane.h"
#include "expected_exceptions.h"
#include "numbered_lines.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_isolines.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;
using namespace numbered_lines;
using Point = Mesh::Point;

namespace {

template <typename Curves, typename Parameters>
Numbered_lines isolines(const Mesh& tm, const Curves& curves, const std::vector<double>& levels,
                        const Parameters& parameters)
{
  Numbered_lines lines;
  CHECK(SMG::geodesic_isolines(tm, curves, levels, std::back_inserter(lines), parameters));
  return lines;
}

template <typename Curves>
Numbered_lines isolines(const Mesh& tm, const Curves& curves, const std::vector<double>& levels)
{
  return isolines(tm, curves, levels, np::default_values());
}

double length(const Line& line)
{
  double sum = 0;
  for(std::size_t i = 1; i < line.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(line[i - 1], line[i]));
  return sum;
}

// --- closed forms ---

// Both sides and both ends at once: two segments and two half circles.
void stadium()
{
  const test_support::Scope scope("stadium");
  const Mesh tm = to_face_graph(flat_patch(30, 30, .15, true, 1));
  const Point_2 a{11.3, 12.2}, b{18.1, 16.4};
  const std::vector<double> levels{4., 1e-7, .5, 2., 10.5};
  const Numbered_lines lines = isolines(tm, Curve(tm, segment_in_plane(tm, a, b)), levels);
  CHECK_EQUAL(lines.size(), levels.size());
  for(const auto& line : lines)
  {
    const double level = levels[line.first];
    for(const Point& p : line.second)
      CHECK_NEAR(distance_to_segment({p.x(), p.y()}, a, b), level, 1e-11 * 30);
    CHECK(is_closed(line.second));
    const double expected = 2 * std::hypot(b[0] - a[0], b[1] - a[1]) + 2 * std::acos(-1.) * level;
    CHECK(length(line.second) <= expected * (1 + 1e-12));
    CHECK(length(line.second) >= expected * .98); // chords are shorter than arcs
  }
}

// The border of a square: squares inside of it, and nothing beyond their center.
void inner_squares()
{
  const test_support::Scope scope("inner squares");
  const double n = 9;
  const Mesh tm = to_face_graph(flat_patch(9, 9, .3, true, 2));
  const std::vector<double> levels{.3, 1., 1e-8, 3.7, 4.4, 4.51};
  const Numbered_lines lines = isolines(tm, SMG::border_curves(tm), levels);
  CHECK_EQUAL(lines.size(), levels.size() - 1);
  for(const auto& line : lines)
  {
    for(const Point& p : line.second)
      CHECK_NEAR((std::min)({p.x(), n - p.x(), p.y(), n - p.y()}), levels[line.first], 1e-11 * n);
    CHECK(is_closed(line.second));
    // the corners of a square are inside of faces, where a segment cuts them off
    CHECK_NEAR(length(line.second), 4 * (n - 2 * levels[line.first]), 4.);
  }
}

// A ring of edges around a tube, and a point of the tube as a curve with an offset: rings on both sides.
void rings_of_tube()
{
  const test_support::Scope scope("tube");
  const std::size_t m = 12, n = 8;
  const Mesh tm = to_face_graph(prism_tube(m, n, 1., 4.));
  std::vector<vertex_descriptor> ring;
  for(const vertex_descriptor v : vertices(tm))
    if(tm.point(v).z() == 2.)
      ring.push_back(v);
  const std::vector<Curve> curves{Curve(tm, ring, true), Curve(tm, *vertices(tm).begin())};
  const std::vector<double> levels{.3, 1e-8, .5, 1.5, 1.77, 2.5}, offsets{0., 50.};
  const Numbered_lines lines = isolines(tm, curves, levels, np::source_offsets(offsets));
  CHECK_EQUAL(lines.size(), 2 * (levels.size() - 1));
  for(const auto& line : lines)
  {
    CHECK(is_closed(line.second));
    for(const Point& p : line.second)
      CHECK_NEAR(std::abs(p.z() - 2.), levels[line.first], 1e-11);
  }
}

// --- the class for paths ---

// Levels up to the largest distance, in any order, and the distances of some vertices.
std::vector<double> levels_for(const Distances& distance, test_support::Random& random)
{
  double farthest = 0;
  for(const auto& d : distance)
    farthest = d.second < infinity ? (std::max)(farthest, d.second) : farthest;
  std::vector<double> levels{0., farthest, -1., infinity, 1e-3 * farthest};
  for(std::size_t i = 0; i < 4; ++i)
    levels.push_back(random.uniform(0., 1.) * farthest);
  std::size_t i = 0;
  for(const auto& d : distance)
    if(++i % (distance.size() / 2 + 1) == 0)
      levels.push_back(d.second);
  levels.push_back(levels[6]); // a level twice
  return levels;
}

// Lines, distances and nearest curves, with given obstacles and random offsets.
template <typename Parameters>
void check_run(const Mesh& tm, const std::vector<Curve>& curves, Paths& paths, const Parameters& obstacles,
               test_support::Random& random)
{
  std::vector<double> offsets;
  for(std::size_t i = 0; i < curves.size(); ++i)
  {
    offsets.push_back(random.index(2) == 0 ? 0. : random.uniform(0., .2) * extent(tm));
    paths.add_source_curve(curves[i], offsets.back());
  }
  Distances expected, found, found_alone;
  std::map<vertex_descriptor, std::size_t> expected_nearest, nearest;
  const auto with_offsets = obstacles.source_offsets(offsets);
  SMG::geodesic_distances(tm, boost::make_assoc_property_map(expected), curves,
                          with_offsets.nearest_source_map(boost::make_assoc_property_map(expected_nearest)));
  const std::vector<double> levels = levels_for(expected, random);
  const Numbered_lines lines
    = isolines(tm, curves, levels,
               with_offsets.vertex_distance_map(boost::make_assoc_property_map(found))
                 .nearest_source_map(boost::make_assoc_property_map(nearest)));
  check_same_lines(lines, lines_of_class(paths, levels), 1e-11 * extent(tm));
  CHECK(found == expected && nearest == expected_nearest); // the same bits
  // Without maps, the run ends behind the last level.
  std::vector<double> few(levels.begin() + 5, levels.begin() + 7);
  check_same_lines(isolines(tm, curves, few, with_offsets), lines_of_class(paths, few), 1e-11 * extent(tm));
}

void lines_are_those_of_the_class(const Mesh& tm, const std::string& name, std::uint64_t seed)
{
  const test_support::Scope scope(name);
  test_support::Random random(seed);
  const std::vector<face_descriptor> nothing;
  for(int i = 0; i < 2; ++i)
  {
    Paths paths(tm);
    check_run(tm, random_curves(tm, random), paths, np::faces_to_avoid(nothing), random);
  }
  if(SMG::border_curves(tm).empty())
    return;
  Paths paths(tm);
  check_run(tm, SMG::border_curves(tm), paths, np::faces_to_avoid(nothing), random);
}

// Curves along walls and across them, on all sides of these.
void lines_end_at_obstacles()
{
  test_support::Random random(11);
  for_each_case(random, [&](const Case& c, std::size_t i)
  {
    if(i % 3 != 1) // random walls, walls from border to border, and those around a face
      return;
    for(const std::vector<Curve>& curves : all_curves(c, random))
    {
      Paths paths(c.tm);
      paths.avoid_faces(c.avoided);
      paths.avoid_edges(c.range);
      check_run(c.tm, curves, paths, np::edges_to_avoid(c.range).faces_to_avoid(c.avoided), random);
    }
  });
}

// --- vertices on the lines ---

// The edge that is nearest to a point.
edge_descriptor edge_at(const Mesh& tm, const Point& p)
{
  edge_descriptor best;
  double least = infinity;
  for(const edge_descriptor e : edges(tm))
  {
    const double d = CGAL::squared_distance(
      p, CGAL::Segment_3<Kernel>(tm.point(source(e, tm)), tm.point(target(e, tm))));
    if(d < least)
    {
      least = d;
      best = e;
    }
  }
  return best;
}

// The mesh with some points of lines as vertices; their edges are split. `vertex` gets these vertices with the levels
// of the lines.
Indexed_mesh with_points_of_lines(const Indexed_mesh& mesh, const Numbered_lines& lines,
                                  const std::vector<double>& levels,
                                  std::vector<std::pair<std::size_t, double>>& vertex)
{
  Indexed_mesh result = mesh;
  for(const auto& line : lines)
    for(std::size_t i = 0; i < line.second.size(); i += 1 + line.second.size() / 4)
    {
      const Mesh tm = to_face_graph(result);
      const edge_descriptor e = edge_at(tm, line.second[i]);
      const Point &a = tm.point(source(e, tm)), &b = tm.point(target(e, tm));
      const double t = ((line.second[i] - a) * (b - a)) / CGAL::squared_distance(a, b);
      if(t > 1e-6 && t < 1 - 1e-6)
      {
        result = with_point_on_edge(result, source(e, tm), target(e, tm), t);
        vertex.emplace_back(result.points.size() - 1, levels[line.first]);
      }
    }
  return result;
}

// Another mesh of the same surface, which has vertices on the lines: their distances are the levels. The curve runs
// along edges that are not split, as a line has no point of it.
void distances_on_the_lines(const Indexed_mesh& mesh)
{
  const test_support::Scope scope("vertices on the lines, " + mesh.name);
  const Mesh tm = to_face_graph(mesh);
  test_support::Random random(3);
  const std::vector<vertex_descriptor> along = random_vertices_along_edges(tm, 6, random);
  const std::vector<Curve> curve{Curve(tm, along)};
  const std::vector<double> levels = {.05 * extent(tm), .6 * extent(tm), 1.1 * extent(tm), 2.3 * extent(tm)};
  std::vector<std::pair<std::size_t, double>> vertex;
  const Mesh finer = to_face_graph(with_points_of_lines(mesh, isolines(tm, curve, levels), levels, vertex));
  CHECK(vertex.size() >= 10);
  const Distances found = distances(finer, {Curve(finer, along)});
  for(const auto& v : vertex)
    CHECK_NEAR(found.at(vertex_descriptor(static_cast<Mesh::size_type>(v.first))), v.second, 1e-10 * extent(tm));
}

// Each line is closed, or begins and ends at the border.
void lines_end_at_the_border(const Mesh& tm, std::uint64_t seed)
{
  const test_support::Scope scope("ends of lines");
  test_support::Random random(seed);
  const std::vector<Curve> curves = random_curves(tm, random);
  const std::vector<double> levels{.2, 1., 2.5, 4.};
  std::size_t number_of_open_lines = 0;
  for(const auto& line : isolines(tm, curves, levels))
    if(!is_closed(line.second))
    {
      ++number_of_open_lines;
      for(const Point& end : {line.second.front(), line.second.back()})
        CHECK(is_border(edge_at(tm, end), tm));
    }
  CHECK(number_of_open_lines > 0);
}

// --- the other parameters ---

struct Canceling_visitor : SMG::Geodesic_default_visitor
{
  bool go_further() { return false; }
};

void parameters_and_rejected_input()
{
  const test_support::Scope scope("parameters");
  const Mesh tm = to_face_graph(icosphere(3));
  const Curve curve(tm, Location(*faces(tm).begin(), {.2, .3, .5}));
  const std::vector<double> levels{.1, .2, .4};
  const Numbered_lines all = isolines(tm, curve, levels);
  CHECK_EQUAL(all.size(), 3u);
  SMG::Propagation_statistics near, everywhere;
  Distances distance;
  CHECK_EQUAL(isolines(tm, curve, levels, np::maximum_distance(.3).statistics(&near)).size(), 2u);
  isolines(tm, curve, levels,
           np::statistics(&everywhere).vertex_distance_map(boost::make_assoc_property_map(distance)));
  CHECK(2 * near.windows_propagated < everywhere.windows_propagated);
  // The tag asks for threads that a run from curves does not have: the same bits.
  Numbered_lines in_parallel;
  SMG::geodesic_isolines<CGAL::Parallel_if_available_tag>(tm, curve, levels, std::back_inserter(in_parallel));
  CHECK(in_parallel == all);
  Numbered_lines lines;
  const auto run = [&](const auto& curves, const auto& parameters)
  { return SMG::geodesic_isolines(tm, curves, levels, std::back_inserter(lines), parameters); };
  CHECK(!run(curve, np::visitor(Canceling_visitor())));
  CHECK(throws_reason(Reason::INVALID_OFFSET, [&] { run(curve, np::source_offsets(levels)); }));
  CHECK(throws_reason(Reason::INVALID_RADIUS, [&] { run(curve, np::maximum_distance(-1.)); }));
  const Mesh larger = to_face_graph(icosphere(4));
  const Curve elsewhere(larger, Location(*(--faces(larger).end()), {.2, .3, .5}));
  CHECK(throws_reason(Reason::INVALID_DESCRIPTOR, [&] { run(elsewhere, np::default_values()); }));
  std::vector<face_descriptor> around{*faces(tm).begin()};
  CHECK(throws_reason(Reason::INVALID_LOCATION, [&] { run(curve, np::faces_to_avoid(around)); }));
  CHECK(lines.empty());
  CHECK(run(std::vector<Curve>(), np::default_values()));
  CHECK(lines.empty());
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261126);
  stadium();
  inner_squares();
  rings_of_tube();
  for(const Indexed_mesh& mesh :
      {noisy_sphere(2, .1, seed), cube_grid(3), rough_terrain(9, 1.5, seed), saddle_patch(8), square_with_holes(2),
       genus_2_polycube(), flat_patch(9, 9, 0., false, 1), flat_patch(14, 14, .3, true, 7), torus(2, .7, 24, 12),
       wavy_tube(12, 10), two_components_and_an_isolated_vertex()})
    lines_are_those_of_the_class(to_face_graph(mesh), mesh.name, seed);
  for(const char* name : {"needle_dup_position", "cap_zero_area", "sliver_1e-12", "pinched_vertex", "two_tri_square"})
    lines_are_those_of_the_class(load_data(name), name, seed);
  lines_end_at_obstacles();
  for(const Indexed_mesh& mesh : {noisy_sphere(2, .1, seed), rough_terrain(8, 1.5, seed), torus(2, .7, 16, 8)})
    distances_on_the_lines(mesh);
  lines_end_at_the_border(to_face_graph(rough_terrain(9, 1.5, seed)), seed);
  parameters_and_rejected_input();
  return test_result();
}
