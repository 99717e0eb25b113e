// geodesic_isolines(): the lines of given levels from one run, whose windows are released behind the wavefront, are
// those that the class for paths traces from all windows. Compared on all kinds of meshes, with several sources,
// offsets, radius, obstacles and threads, also for levels at the distances of vertices.

#include "expected_exceptions.h"
#include "numbered_lines.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_isolines.h>

#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace numbered_lines;
using namespace test_meshes;

namespace {

using Point = Kernel::Point_3;
using Location = Geodesic_paths::Face_location;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

const double infinity = std::numeric_limits<double>::infinity();

// Random levels up to the largest distance, in any order, and the distances of some vertices.
std::vector<double> levels_for(const Mesh& tm, const Geodesic_paths& paths, test_support::Random& random)
{
  const double farthest = paths.farthest_vertex().second;
  std::vector<double> levels{0., farthest, -1., infinity, std::numeric_limits<double>::quiet_NaN()};
  for(std::size_t i = 0; i < 12; ++i)
    levels.push_back(random.uniform(0., 1.) * farthest);
  std::size_t i = 0;
  for(const Vertex v : tm.vertices())
    if(++i % (tm.number_of_vertices() / 4 + 1) == 0)
      levels.push_back(paths.shortest_distance_to_source_points(v).first);
  levels.push_back(levels[6]); // a level twice
  return levels;
}

// From a vertex, and from points in faces and on an edge.
template <typename Tag>
void lines_are_those_of_the_class(const Mesh& tm, const std::string& name, std::uint64_t seed)
{
  test_support::Scope scope(name);
  test_support::Random random(seed);
  Geodesic_paths from_vertex(tm), from_faces(tm);
  const Vertex v = *tm.vertices().begin();
  from_vertex.add_source_point(v);
  std::vector<Location> locations{Location(*tm.faces().begin(), {{.2, .3, .5}}),
                                  Location(*(--tm.faces().end()), {{.5, .5, 0.}})};
  for(const Location& l : locations)
    from_faces.add_source_point(l);
  const std::vector<double> levels = levels_for(tm, from_vertex, random);
  const double size = size_of(tm);
  Numbered_lines lines;
  CHECK(CGAL::Surface_mesh_geodesics::geodesic_isolines<Tag>(tm, v, levels, std::back_inserter(lines)));
  check_same_lines(lines, lines_of_class(from_vertex, levels), 1e-11 * size);
  lines.clear();
  std::vector<double> distances(tm.number_of_vertices());
  CHECK(CGAL::Surface_mesh_geodesics::geodesic_isolines<Tag>(
    tm, locations, levels, std::back_inserter(lines),
    CGAL::parameters::vertex_distance_map(
      boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, tm)))));
  check_same_lines(lines, lines_of_class(from_faces, levels), 1e-11 * size);
  for(const Vertex w : tm.vertices())
  {
    const double d = from_faces.shortest_distance_to_source_points(w).first;
    CHECK_CLOSE(distances[w], d < 0 ? infinity : d, 1e-13);
  }
}

// Threads compute the same lines, up to rounding.
void threads_find_the_same_lines(const Mesh& tm, const std::string& name, std::uint64_t seed)
{
#ifdef CGAL_LINKED_WITH_TBB
  lines_are_those_of_the_class<CGAL::Parallel_tag>(tm, name + ", threads", seed);
#else
  static_cast<void>(tm), static_cast<void>(name), static_cast<void>(seed);
#endif
}

// The only source has an offset: its lines are those of smaller levels.
void an_offset_shifts_the_levels(const Mesh& tm)
{
  test_support::Scope scope("offset");
  Geodesic_paths paths(tm);
  const Vertex v = *tm.vertices().begin();
  paths.add_source_point(v);
  const double farthest = paths.farthest_vertex().second;
  const std::vector<double> levels{.3 * farthest, .7 * farthest}, offsets{.25 * farthest};
  std::vector<double> shifted;
  for(const double level : levels)
    shifted.push_back(level + offsets[0]);
  Numbered_lines lines;
  CGAL::Surface_mesh_geodesics::geodesic_isolines(tm, v, shifted, std::back_inserter(lines),
                                                  CGAL::parameters::source_offsets(offsets));
  CHECK(!lines.empty());
  check_same_lines(lines, lines_of_class(paths, levels), 1e-11 * size_of(tm));
}

// Up to the radius, with and without distances, lines are the same; beyond it there are none.
void a_radius_ends_the_run(const Mesh& tm, const std::string& name)
{
  test_support::Scope scope("radius, " + name);
  Geodesic_paths paths(tm);
  const Vertex v = *tm.vertices().begin();
  paths.add_source_point(v);
  const double farthest = paths.farthest_vertex().second;
  for(const double part : {.01, .2, .4, .6, .8, .95})
  {
    const double radius = part * farthest;
    const std::vector<double> levels{.7 * radius, radius, 1.001 * radius};
    const Numbered_lines expected = lines_of_class(paths, {levels[0], levels[1]});
    Numbered_lines lines, lines_alone, last_levels;
    std::vector<double> distances(tm.number_of_vertices());
    std::vector<std::size_t> sources(tm.number_of_vertices());
    const auto index = get(boost::vertex_index, tm);
    CGAL::Surface_mesh_geodesics::geodesic_isolines(
      tm, v, levels, std::back_inserter(lines),
      CGAL::parameters::maximum_distance(radius)
        .vertex_distance_map(boost::make_iterator_property_map(distances.begin(), index))
        .nearest_source_map(boost::make_iterator_property_map(sources.begin(), index)));
    check_same_lines(lines, expected, 1e-11 * size_of(tm));
    CGAL::Surface_mesh_geodesics::geodesic_isolines(tm, v, levels, std::back_inserter(lines_alone),
                                                    CGAL::parameters::maximum_distance(radius));
    check_same_lines(lines_alone, expected, 1e-11 * size_of(tm));
    CGAL::Surface_mesh_geodesics::geodesic_isolines(tm, v, std::vector<double>{levels[0], levels[1]},
                                                    std::back_inserter(last_levels));
    check_same_lines(last_levels, expected, 1e-11 * size_of(tm));
    for(const Vertex w : tm.vertices())
    {
      const double d = paths.shortest_distance_to_source_points(w).first;
      const bool is_reached = d >= 0 && distances[w] < infinity;
      CHECK_EQUAL(is_reached, d >= 0 && d <= radius * (1 + (is_reached ? 1e-13 : -1e-13)));
      CHECK_EQUAL(sources[w], is_reached ? 0 : (std::numeric_limits<std::size_t>::max)());
      if(is_reached)
        CHECK_CLOSE(distances[w], d, 1e-13);
    }
  }
}

// A short run propagates through a small part of the mesh only.
void a_run_ends_behind_the_last_level(const Mesh& tm)
{
  test_support::Scope scope("end of the run");
  using Statistics = CGAL::Surface_mesh_geodesics::Propagation_statistics;
  const Vertex v = *tm.vertices().begin();
  Numbered_lines lines;
  Statistics near, all;
  std::vector<double> distances(tm.number_of_vertices());
  const auto map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, tm));
  const std::vector<double> levels{.2};
  CGAL::Surface_mesh_geodesics::geodesic_isolines(tm, v, levels, std::back_inserter(lines),
                                                  CGAL::parameters::statistics(&near));
  CGAL::Surface_mesh_geodesics::geodesic_isolines(tm, v, levels, std::back_inserter(lines),
                                                  CGAL::parameters::statistics(&all).vertex_distance_map(map));
  CHECK_EQUAL(lines.size(), 2u);
  CHECK(2 * near.windows_propagated < all.windows_propagated);
}

// They are those of the mesh in which the faces to avoid are really missing.
void lines_lead_around_obstacles(const Mesh& tm)
{
  test_support::Scope scope("obstacles");
  std::vector<Face> avoided, rest;
  std::size_t i = 0;
  for(const Face f : tm.faces())
    (++i % 7 == 3 ? avoided : rest).push_back(f);
  Geodesic_paths paths(tm);
  paths.avoid_faces(avoided);
  const Vertex v = *tm.vertices().begin();
  paths.add_source_point(v);
  test_support::Random random(8);
  const std::vector<double> levels = levels_for(tm, paths, random);
  Numbered_lines lines;
  CGAL::Surface_mesh_geodesics::geodesic_isolines(tm, v, levels, std::back_inserter(lines),
                                                  CGAL::parameters::faces_to_avoid(avoided));
  CHECK(!lines.empty());
  check_same_lines(lines, lines_of_class(paths, levels), 1e-11 * size_of(tm));
  const CGAL::Face_filtered_graph<Mesh> without(tm, rest);
  Numbered_lines expected;
  CGAL::Surface_mesh_geodesics::geodesic_isolines(without, v, levels, std::back_inserter(expected));
  check_same_lines(lines, expected, 1e-11 * size_of(tm));
}

struct Canceling_visitor : CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
  bool go_further() { return false; }
};

// Nothing is written then, and no map changes.
void nothing_is_written_without_a_result(const Mesh& tm)
{
  test_support::Scope scope("no result");
  Numbered_lines lines;
  std::vector<double> distances(tm.number_of_vertices(), 7.);
  const auto map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, tm));
  const std::vector<double> levels{.5}, offsets{1., 2.};
  const auto np = CGAL::parameters::vertex_distance_map(map);
  const Vertex v = *tm.vertices().begin();
  const auto run = [&](const auto& source, const auto& parameters)
  {
    return CGAL::Surface_mesh_geodesics::geodesic_isolines(tm, source, levels, std::back_inserter(lines), parameters);
  };
  CHECK(!run(v, np.visitor(Canceling_visitor())));
  CHECK(throws_reason(Reason::INVALID_DESCRIPTOR, [&] { run(Mesh::null_vertex(), np); }));
  CHECK(throws_reason(Reason::INVALID_RADIUS, [&] { run(v, np.maximum_distance(-1.)); }));
  CHECK(throws_reason(Reason::INVALID_OFFSET, [&] { run(v, np.source_offsets(offsets)); }));
  CHECK(lines.empty());
  CHECK(std::all_of(distances.begin(), distances.end(), [](double d) { return d == 7.; }));
  // without sources, no vertex is reached
  CHECK(run(std::vector<Vertex>(), np));
  CHECK(lines.empty());
  CHECK(std::all_of(distances.begin(), distances.end(), [](double d) { return d == infinity; }));
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261126);
  for(const Indexed_mesh& indexed :
      {noisy_sphere(3, .1, seed), cube_grid(3), rough_terrain(14, 1.5, seed), saddle_patch(8), square_with_holes(2),
       genus_2_polycube(), flat_patch(9, 9, 0., false, 1), flat_patch(14, 14, .3, true, 7), icosphere(3),
       torus(2, .7, 24, 12), wavy_tube(12, 10), two_components_and_an_isolated_vertex()})
  {
    const Mesh tm = to_face_graph(indexed);
    lines_are_those_of_the_class<CGAL::Sequential_tag>(tm, indexed.name, seed);
    threads_find_the_same_lines(tm, indexed.name, seed);
    a_radius_ends_the_run(tm, indexed.name);
  }
  for(const char* name : {"needle_dup_position", "cap_zero_area", "sliver_1e-12", "needle_1e-12", "pinched_vertex",
                          "isolated_vertex", "two_components", "two_tri_square", "grid5"})
    lines_are_those_of_the_class<CGAL::Sequential_tag>(load_data(name), name, seed);
  an_offset_shifts_the_levels(to_face_graph(noisy_sphere(3, .1, seed)));
  a_run_ends_behind_the_last_level(to_face_graph(icosphere(4)));
  lines_lead_around_obstacles(to_face_graph(rough_terrain(14, 1.5, seed)));
  nothing_is_written_without_a_result(to_face_graph(icosphere(2)));
  return test_result();
}
