// Isolines. Each point of a line has the requested distance, according to the original class and to planar geometry.
// Lines cross each edge whose ends are on different sides of the value. They are closed or end at the border.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

using Point = Kernel::Point_3;
using Line = std::vector<Point>;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
using AABB_traits = CGAL::AABB_traits_3<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>;
#else
using AABB_traits = CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>;
#endif
using Original = CGAL::Surface_mesh_shortest_path<Paths_traits>;

bool is_closed(const Line& line)
{
  return line.size() > 2 && line.front() == line.back();
}

double distance_between(const Point& a, const Point& b)
{
  return std::sqrt(CGAL::squared_distance(a, b));
}

double distance_to_segment(const Point& p, const Point& a, const Point& b)
{
  return std::sqrt(CGAL::squared_distance(p, Kernel::Segment_3(a, b)));
}

bool is_on_border(const Mesh& tm, const Point& p, double tolerance)
{
  for(const Mesh::Edge_index e : tm.edges())
  {
    if(tm.is_border(e)
       && distance_to_segment(p, tm.point(tm.vertex(e, 0)), tm.point(tm.vertex(e, 1))) <= tolerance)
    {
      return true;
    }
  }
  return false;
}

// Checks that each point has the distance `value` for both classes.
void check_distances(const std::vector<Point>& points, double value, const Geodesic_paths& paths, Original& original,
                     const CGAL::AABB_tree<AABB_traits>& tree, const Mesh& tm, double size)
{
  const std::size_t step = points.size() / 150 + 1; // the original is slow
  for(std::size_t i = 0; i < points.size(); i += step)
  {
    auto location = paths.locate(points[i], tree);
    double sum = 0; // the original needs an exact zero for points on edges
    for(std::size_t k = 0; k < 3; ++k)
    {
      location.second[k] = location.second[k] < 1e-9 ? 0. : location.second[k];
      sum += location.second[k];
    }
    for(std::size_t k = 0; k < 3; ++k)
    {
      location.second[k] /= sum;
    }
    if(!is_on_border(tm, points[i], 1e-9 * size)) // there the answers of the original are random
    {
      CHECK_NEAR(original.shortest_distance_to_source_points(location.first, location.second).first, value,
                 1e-10 * size);
    }
    CHECK_NEAR(paths.shortest_distance_to_source_points(location.first, location.second).first, value, 1e-10 * size);
  }
}

// Checks that each edge whose ends are on different sides of `value` has a point.
void check_edges_are_crossed(const std::vector<Point>& points, double value, const Geodesic_paths& paths,
                             const Mesh& tm, double size)
{
  for(const Mesh::Edge_index e : tm.edges())
  {
    const Mesh::Vertex_index a = tm.vertex(e, 0), b = tm.vertex(e, 1);
    const double da = paths.shortest_distance_to_source_points(a).first;
    const double db = paths.shortest_distance_to_source_points(b).first;
    if(da < 0 || db < 0 || (da < value) == (db < value))
    {
      continue;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for(const Point& p : points)
    {
      nearest = (std::min)(nearest, distance_to_segment(p, tm.point(a), tm.point(b)));
    }
    CHECK_NEAR(nearest, 0., 1e-12 * size);
  }
}

// Checks the lines of some values on a mesh from one source vertex against the original class.
void lines_have_the_distances_of_the_original(const Indexed_mesh& indexed, std::size_t source)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  const double size = size_of(tm);
  const Mesh::Vertex_index s(static_cast<Mesh::size_type>(source));
  Geodesic_paths paths(tm);
  paths.add_source_point(s);
  Original original(tm);
  original.add_source_point(s);
  CGAL::AABB_tree<AABB_traits> tree;
  paths.build_aabb_tree(tree);
  const double farthest = paths.farthest_vertex().second;

  for(const double part : {.07, .31, .5, .83, .97})
  {
    const double value = part * farthest;
    std::vector<Line> lines;
    paths.isolines(value, std::back_inserter(lines));
    CHECK(!lines.empty());
    std::vector<Point> points;
    for(const Line& line : lines)
    {
      CHECK(line.size() >= 2);
      if(!is_closed(line))
      {
        CHECK(is_on_border(tm, line.front(), 1e-12 * size));
        CHECK(is_on_border(tm, line.back(), 1e-12 * size));
      }
      points.insert(points.end(), line.begin(), line.end());
    }
    check_distances(points, value, paths, original, tree, tm, size);
    check_edges_are_crossed(points, value, paths, tm, size);
  }
}

// In a plane without obstacles the isolines are circles.
void lines_around_a_source_in_the_plane_are_circles()
{
  test_support::Scope scope("circles");
  const Mesh tm = to_face_graph(flat_patch(14, 14, .3, true, 7));
  const double size = size_of(tm);
  Geodesic_paths paths(tm);
  Point center(0, 0, 0);
  for(const Mesh::Vertex_index v : tm.vertices())
  {
    center = Point(center.x() + tm.point(v).x() / static_cast<double>(tm.number_of_vertices()),
                   center.y() + tm.point(v).y() / static_cast<double>(tm.number_of_vertices()), 0);
  }
  const auto location = paths.locate<AABB_traits>(center);
  paths.add_source_point(location);
  center = paths.point(location.first, location.second);
  double border = std::numeric_limits<double>::infinity();
  for(const Mesh::Edge_index e : tm.edges())
  {
    if(tm.is_border(e))
    {
      border = (std::min)(border, distance_to_segment(center, tm.point(tm.vertex(e, 0)), tm.point(tm.vertex(e, 1))));
    }
  }
  for(const double part : {.2, .5, .9})
  {
    std::vector<Line> lines;
    paths.isolines(part * border, std::back_inserter(lines));
    CHECK_EQUAL(lines.size(), std::size_t(1));
    double length = 0;
    for(const Line& line : lines)
    {
      CHECK(is_closed(line));
      for(std::size_t i = 0; i < line.size(); ++i)
      {
        CHECK_NEAR(distance_between(line[i], center), part * border, 1e-11 * size);
        length += i == 0 ? 0. : distance_between(line[i - 1], line[i]);
      }
    }
    // the polygon is inscribed in the circle
    const double circumference = 2 * CGAL_PI * part * border;
    CHECK(length < circumference);
    CHECK(length > .9 * circumference);
  }
  // circles that cross the border: arcs that end there
  std::vector<Line> lines;
  paths.isolines(1.15 * border, std::back_inserter(lines));
  CHECK(!lines.empty());
  for(const Line& line : lines)
  {
    CHECK(!is_closed(line));
    for(const Point& p : line)
    {
      CHECK_NEAR(distance_between(p, center), 1.15 * border, 1e-11 * size);
    }
  }
}

// Near the two sources, each has a line of its own. Farther away, one line surrounds both.
void lines_of_two_sources_join()
{
  test_support::Scope scope("two sources");
  const Mesh tm = to_face_graph(flat_patch(20, 10, .2, true, 3));
  Geodesic_paths paths(tm);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(tm);
  const double w = box.xmax() - box.xmin(), y = (box.ymin() + box.ymax()) / 2;
  const Point a(box.xmin() + .35 * w, y, 0), b(box.xmin() + .65 * w, y, 0);
  for(const Point& p : {a, b})
  {
    paths.add_source_point(paths.locate<AABB_traits>(p));
  }
  const auto number_of_lines = [&](double value)
  {
    std::vector<Line> lines;
    paths.isolines(value, std::back_inserter(lines));
    for(const Line& line : lines)
    {
      CHECK(is_closed(line));
      for(const Point& p : line)
      {
        CHECK_NEAR((std::min)(distance_between(p, a), distance_between(p, b)), value, 1e-10 * w);
      }
    }
    return lines.size();
  };
  CHECK_EQUAL(number_of_lines(.1 * w), std::size_t(2));
  CHECK_EQUAL(number_of_lines(.17 * w), std::size_t(1));
}

void some_values_have_no_line()
{
  test_support::Scope scope("no lines");
  const Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  Geodesic_paths paths(tm);
  std::vector<Line> lines;
  paths.isolines(1., std::back_inserter(lines)); // no source
  CHECK(lines.empty());
  paths.add_source_point(*tm.vertices().begin());
  const double infinity = std::numeric_limits<double>::infinity();
  for(const double value : {-1., 1e9, infinity, std::numeric_limits<double>::quiet_NaN()})
  {
    paths.isolines(value, std::back_inserter(lines));
    CHECK(lines.empty());
  }
  // the distance of each vertex: the line runs through the vertex, or near it
  for(const Mesh::Vertex_index v : tm.vertices())
  {
    const double d = paths.shortest_distance_to_source_points(v).first;
    if(d > 0)
    {
      lines.clear();
      paths.isolines(d, std::back_inserter(lines));
      for(const Line& line : lines)
      {
        for(const Point& p : line)
        {
          const auto location = paths.locate<AABB_traits>(p);
          CHECK_NEAR(paths.shortest_distance_to_source_points(location.first, location.second).first, d,
                     1e-9 * size_of(tm));
        }
      }
    }
  }
}

// Checks the lines of any mesh: no point comes twice in a row, lines end at the border only, and cross each edge whose
// ends are on different sides of the value.
void check_lines(const Mesh& tm, const Geodesic_paths& paths, double value, const std::vector<Line>& lines)
{
  const double tolerance = 1e-9 * size_of(tm);
  for(const Line& line : lines)
  {
    CHECK(line.size() >= 2);
    CHECK(is_closed(line) || (is_on_border(tm, line.front(), tolerance) && is_on_border(tm, line.back(), tolerance)));
    for(std::size_t i = 1; i < line.size(); ++i)
    {
      CHECK(line[i] != line[i - 1]);
    }
  }
  for(const Mesh::Edge_index e : tm.edges())
  {
    const Mesh::Vertex_index a = tm.vertex(e, 0), b = tm.vertex(e, 1);
    const double da = paths.shortest_distance_to_source_points(a).first;
    const double db = paths.shortest_distance_to_source_points(b).first;
    // no line leads to a vertex that is farther than everything around it
    const double margin = 1e-9 * (1. + value);
    if(da < 0 || db < 0 || (std::min)(da, db) > value - margin || (std::max)(da, db) < value + margin)
    {
      continue;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for(const Line& line : lines)
    {
      for(const Point& p : line)
      {
        nearest = (std::min)(nearest, distance_to_segment(p, tm.point(a), tm.point(b)));
      }
    }
    CHECK_NEAR(nearest, 0., tolerance);
  }
}

std::size_t times_on_lines(const Point& p, const std::vector<Line>& lines, double tolerance)
{
  std::size_t n = 0;
  for(const Line& line : lines)
  {
    for(std::size_t i = is_closed(line) ? 1 : 0; i < line.size(); ++i)
    {
      n += distance_between(line[i], p) <= tolerance ? 1 : 0;
    }
  }
  return n;
}

// Takes the distance of a vertex. Lines run through the vertex, once for each sector of nearer points around it, or the
// vertex is an isolated point of the isoline.
void lines_at_distances_of_vertices_are_valid(const Indexed_mesh& indexed)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  Geodesic_paths paths(tm);
  paths.add_source_point(*tm.vertices().begin());
  paths.add_source_point(*(--tm.faces().end()), {.2, .3, .5});
  paths.build_sequence_tree_for_faces();
  for(const Mesh::Vertex_index v : tm.vertices())
  {
    const double value = paths.shortest_distance_to_source_points(v).first;
    if(value <= 0)
    {
      continue;
    }
    test_support::Scope vertex_scope("vertex " + std::to_string(std::size_t(v)));
    std::vector<Line> lines;
    paths.isolines(value, std::back_inserter(lines));
    check_lines(tm, paths, value, lines);
    // the nearer points around the vertex, on its edges
    std::size_t nearer = 0, farther = 0;
    for(const Mesh::Halfedge_index h : halfedges_around_target(v, tm))
    {
      const auto location = paths.face_location(h, 1. - 1. / 1024.);
      ++(paths.shortest_distance_to_source_points(location.first, location.second).first < value ? nearer : farther);
    }
    const std::size_t times = times_on_lines(tm.point(v), lines, 0.);
    CHECK_EQUAL(times > 0, nearer > 0 && farther > 0);
    CHECK(times <= (std::min)(nearer, farther));
  }
}

// A square of two triangles: from a corner the line through the two neighbors is a border-to-border line of three
// points. The opposite corner is an isolated point.
void a_line_crosses_a_square_of_two_triangles()
{
  test_support::Scope scope("square");
  const Mesh tm = load_data("two_tri_square");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  std::vector<Line> lines;
  paths.isolines(1., std::back_inserter(lines));
  CHECK_EQUAL(lines.size(), 1u);
  for(const Line& line : lines)
  {
    CHECK_EQUAL(line.size(), 3u);
    CHECK((line.front() == tm.point(vertex(1)) && line.back() == tm.point(vertex(3))) ||
          (line.front() == tm.point(vertex(3)) && line.back() == tm.point(vertex(1))));
    CHECK_NEAR(distance_between(line[1], Point(std::sqrt(.5), std::sqrt(.5), 0.)), 0., 1e-11);
  }
  lines.clear();
  paths.isolines(paths.shortest_distance_to_source_points(vertex(2)).first, std::back_inserter(lines));
  CHECK(lines.empty());
}

// Two discs that touch each other at a vertex, and touch the border at other vertices.
void lines_on_discs_that_touch_are_separate()
{
  test_support::Scope scope("touching discs");
  const Mesh tm = load_data("grid5");
  Geodesic_paths paths(tm);
  for(const double x : {.25, .75})
  {
    paths.add_source_point(paths.locate<AABB_traits>(Point(x, .5, 0.)));
  }
  std::vector<Line> lines;
  paths.isolines(.25, std::back_inserter(lines));
  check_lines(tm, paths, .25, lines);
  CHECK_EQUAL(lines.size(), 2u);
  for(const Line& line : lines)
  {
    CHECK(is_closed(line));
  }
  CHECK_EQUAL(times_on_lines(Point(.5, .5, 0.), lines, 0.), 2u);
  for(const Point& p : {Point(0., .5, 0.), Point(1., .5, 0.), Point(.25, .25, 0.), Point(.75, .75, 0.)})
  {
    CHECK_EQUAL(times_on_lines(p, lines, 0.), 1u);
  }
}

// Far from the source the rounding of distances is more than the resolution on an edge.
void lines_far_from_the_source_end()
{
  test_support::Scope scope("far from the source");
  const std::size_t n = 30000;
  const Mesh tm = to_face_graph(strip(n));
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  test_support::Random random(3);
  std::size_t number_of_lines = 0, number_of_ends = 0;
  // the errors of all faces on the way add up, and here all squares have the same errors
  const double rounding = 2. * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  for(std::size_t i = 0; i < 200; ++i)
  {
    const double value = random.uniform(.9, .99) * static_cast<double>(n);
    std::vector<Line> lines;
    paths.isolines(value, std::back_inserter(lines));
    number_of_lines += lines.size();
    for(const Line& line : lines)
    {
      for(const Point& p : {line.front(), line.back()})
      {
        number_of_ends += std::abs(p.y() - .5) > .499999 ? 1 : 0; // the strip has the width 1
      }
      for(const Point& p : line)
      {
        CHECK_CLOSE(distance_between(p, tm.point(vertex(0))), value, rounding);
      }
    }
  }
  CHECK_EQUAL(number_of_lines, 200u);
  CHECK_EQUAL(number_of_ends, 400u);
}

// Edges without length and faces without area.
void degenerate_faces_have_lines()
{
  for(const char* name : {"needle_dup_position", "cap_zero_area", "sliver_1e-12", "needle_1e-12", "pinched_vertex",
                          "isolated_vertex", "two_components"})
  {
    test_support::Scope scope(name);
    const Mesh tm = load_data(name);
    Geodesic_paths paths(tm);
    paths.add_source_point(vertex(0));
    const double farthest = paths.farthest_vertex().second;
    test_support::Random random(5);
    for(std::size_t i = 0; i < 60; ++i)
    {
      const double value = random.uniform(0., 1.) * farthest;
      std::vector<Line> lines;
      paths.isolines(value, std::back_inserter(lines));
      check_lines(tm, paths, value, lines);
    }
  }
}

// A const object gives the same lines after any earlier build.
void const_objects_give_the_same_lines()
{
  test_support::Scope scope("const");
  const Mesh tm = to_face_graph(icosphere(2));
  std::vector<Line> expected;
  Geodesic_paths paths(tm);
  paths.add_source_point(*tm.vertices().begin());
  paths.isolines(.5, std::back_inserter(expected));
  CHECK_EQUAL(expected.size(), std::size_t(1));
  for(std::size_t stages_built = 0; stages_built < 3; ++stages_built)
  {
    test_support::Scope stage_scope(std::to_string(stages_built) + " stages built");
    Geodesic_paths other(tm);
    other.add_source_point(*tm.vertices().begin());
    if(stages_built > 0)
    {
      stages_built == 1 ? other.build_sequence_tree() : other.build_sequence_tree_for_faces();
    }
    const Geodesic_paths& constant = other;
    std::vector<Line> lines;
    constant.isolines(.5, std::back_inserter(lines));
    CHECK(lines == expected);
    CHECK(constant.nearest_source_point(*tm.vertices().begin()) == 0);
    CHECK(constant.farthest_vertex() == paths.farthest_vertex());
    std::vector<Line> again;
    other.isolines(.5, std::back_inserter(again));
    CHECK(lines == again);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260512);
  lines_around_a_source_in_the_plane_are_circles();
  lines_of_two_sources_join();
  some_values_have_no_line();
  const_objects_give_the_same_lines();
  a_line_crosses_a_square_of_two_triangles();
  lines_on_discs_that_touch_are_separate();
  lines_far_from_the_source_end();
  degenerate_faces_have_lines();
  for(const Indexed_mesh& indexed :
      {noisy_sphere(2, .1, seed), cube_grid(2), rough_terrain(6, 1.5, seed), saddle_patch(6), square_with_holes(1),
       genus_2_polycube(), flat_patch(7, 7, 0., false, 1), icosphere(2), two_components_and_an_isolated_vertex()})
  {
    lines_at_distances_of_vertices_are_valid(indexed);
  }
  lines_have_the_distances_of_the_original(noisy_sphere(3, .05, seed), 5);
  lines_have_the_distances_of_the_original(torus(2, .7, 24, 12), 17);
  lines_have_the_distances_of_the_original(rough_terrain(12, 1.5, seed), 40);
  lines_have_the_distances_of_the_original(square_with_holes(2), 3);
  lines_have_the_distances_of_the_original(genus_2_polycube(), 1);
  lines_have_the_distances_of_the_original(saddle_patch(10), 30);
  lines_have_the_distances_of_the_original(wavy_tube(12, 10), 8);
  return test_result();
}
