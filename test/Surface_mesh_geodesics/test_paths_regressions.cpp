// Situations in which other programs are wrong or crash: sources on edges, with noise, on the border, several in a
// face, vertices without faces, edges without length. Then each file of the folder data/.

#include "path_test_helpers.h"
#include "surface_points.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

const double tolerance = 1e-12;

void edge_sources_are_not_mirrored()
{
  {
    test_support::Scope scope("single_triangle");
    const Mesh tm = load_data("single_triangle");
    const std::vector<double> expected{.75, 2.25, std::sqrt(16.5625)};
    for(const Surface_point& source : with_noise(on_edge(0, 1, .25, tm)))
    {
      Geodesic_paths paths(tm);
      add(paths, source);
      check_paths_of_vertices(paths, tm, expected, 4., tolerance);
    }
  }
  test_support::Scope scope("two_tri_square");
  const Mesh tm = load_data("two_tri_square");
  for(const Surface_point source : on_edge(0, 1, .25, tm))
  {
    Geodesic_paths paths(tm);
    add(paths, source);
    const std::vector<double> expected{.25, .75, 1.25, std::sqrt(1.0625)};
    for(std::size_t i = 0; i < 4; ++i)
    {
      CHECK_CLOSE(ask(paths, Surface_point(vertex(i))).distance, expected[i], tolerance);
    }
    for(const Surface_point query : on_edge(0, 1, .75, tm))
    {
      CHECK_CLOSE(ask(paths, query).distance, .5, tolerance);
      CHECK_EQUAL(checked_path(paths, query, tm, 1.).size(), 2u);
    }
  }
  for(const Surface_point source : on_edge(0, 2, .25, tm))
  {
    Geodesic_paths paths(tm);
    add(paths, source);
    for(const Surface_point query : on_edge(0, 2, .75, tm))
    {
      CHECK_CLOSE(ask(paths, query).distance, std::sqrt(.5), tolerance);
      CHECK_EQUAL(checked_path(paths, query, tm, 1.).size(), 2u);
    }
  }
}

void noise_at_a_corner_changes_nothing()
{
  test_support::Scope scope("noise at a corner of grid5");
  const Mesh tm = load_data("grid5");
  const vertex_descriptor corner = corners_of_face(face(6), tm)[2];
  Geodesic_paths expected(tm);
  expected.add_source_point(corner);
  CHECK_EQUAL(std::size_t(corner), 4u);
  for(const Surface_point& source : at_vertex(4, tm))
  {
    Geodesic_paths paths(tm);
    add(paths, source);
    CHECK_EQUAL(ask(paths, Surface_point(corner)).distance, 0.);
    CHECK_EQUAL(ask(paths, source).distance, 0.);
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK_EQUAL(ask(paths, Surface_point(v)).distance, ask(expected, Surface_point(v)).distance);
    }
    CHECK_EQUAL(checked_path(paths, Surface_point(corner), tm, 1.).size(), 1u);
  }
}

void queries_on_border_edges_are_answered()
{
  test_support::Scope scope("two_tri_square_b, queries on the border");
  const Mesh tm = load_data("two_tri_square_b");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(1));
  CHECK_CLOSE(ask(paths, in_plane(0., .5, tm)).distance, .5, tolerance);
  CHECK_CLOSE(ask(paths, in_plane(0., .25, tm)).distance, .75, tolerance);
  CHECK_EQUAL(checked_path(paths, in_plane(0., .25, tm), tm, 1.).size(), 2u);
}

void two_vertices_may_be_sources()
{
  test_support::Scope scope("two_tri_square_b, two vertices");
  const Mesh tm = load_data("two_tri_square_b");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  paths.add_source_point(vertex(1));
  const std::vector<double> expected{0., 0., 1., 1.};
  for(std::size_t i = 0; i < 4; ++i)
  {
    const Answer answer = ask(paths, Surface_point(vertex(i)));
    CHECK_CLOSE(answer.distance, expected[i], tolerance);
    CHECK_EQUAL(answer.source, i % 2);
  }
}

void two_sources_may_be_in_one_face()
{
  test_support::Scope scope("two_tri_square_b, two sources in one face");
  const Mesh tm = load_data("two_tri_square_b");
  Geodesic_paths paths(tm);
  add(paths, in_plane(.75, .125, tm));
  add(paths, in_plane(.625, .125, tm));
  const Answer answer = ask(paths, in_plane(.625, .5, tm));
  CHECK_CLOSE(answer.distance, .375, tolerance);
  CHECK_EQUAL(answer.source, 1u);
  checked_path(paths, in_plane(.625, .5, tm), tm, 1.);
}

// Adds random points, points of one line, and repeated points. Returns their positions.
std::vector<Coordinates> add_random_sources(Geodesic_paths& paths, const Mesh& grid, std::size_t number,
                                            test_support::Random& random)
{
  std::vector<Coordinates> positions;
  for(std::size_t i = 0; i < number; ++i)
  {
    std::vector<Surface_point> spot = random_spot(grid, random);
    Surface_point source = spot[random.index(spot.size())];
    if(i > 0 && random.index(3) == 0)
    {
      const Coordinates p = positions[random.index(i)];
      source = in_plane(p[0], random.index(3) == 0 ? p[1] : random.uniform(), grid);
    }
    add(paths, source);
    positions.push_back(position(source, grid));
  }
  return positions;
}

// Queries the nearest of some sources in a plane square.
void check_nearest_source(Geodesic_paths& paths, const Mesh& grid, const std::vector<Coordinates>& positions,
                          const Surface_point& query)
{
  double expected = infinity;
  for(const Coordinates& p : positions)
  {
    expected = (std::min)(expected, length(p - position(query, grid)));
  }
  test_support::Scope query_scope("to " + description(query));
  const Answer answer = ask(paths, query);
  CHECK_NEAR(answer.distance, expected, tolerance);
  if(CHECK(answer.source < positions.size()))
  {
    CHECK_NEAR(length(positions[answer.source] - position(query, grid)), expected, tolerance);
  }
  checked_path(paths, query, grid, 1.);
}

void several_sources_in_faces_are_all_found(test_support::Random& random)
{
  for(const std::string name : {"two_tri_square", "grid4", "grid6", "grid9"})
  {
    test_support::Scope scope(name + ", several sources");
    const Mesh grid = load_data(name);
    Geodesic_paths paths(grid);
    for(std::size_t round = 0; round < 40; ++round)
    {
      const std::size_t number = 2 + random.index(12);
      paths.remove_all_source_points();
      const std::vector<Coordinates> positions = add_random_sources(paths, grid, number, random);
      for(std::size_t j = 0; j < 30; ++j)
      {
        const std::vector<Surface_point> spot = random_spot(grid, random);
        check_nearest_source(paths, grid, positions,
                             j < number ? in_plane(positions[j][0], positions[j][1], grid)
                                        : spot[random.index(spot.size())]);
      }
    }
  }
}

void isolated_vertices_are_reached_by_themselves_only()
{
  test_support::Scope scope("isolated_vertex");
  const Mesh tm = load_data("isolated_vertex");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  const std::vector<double> expected{0., 1., std::sqrt(2.), 1., -1.};
  for(std::size_t i = 0; i < 5; ++i)
  {
    CHECK_CLOSE(ask(paths, Surface_point(vertex(i))).distance, expected[i], tolerance);
    CHECK_EQUAL(checked_path(paths, Surface_point(vertex(i)), tm, 1.).empty(), i == 4);
  }
  paths.remove_all_source_points();
  const auto isolated = paths.add_source_point(vertex(4));
  for(std::size_t i = 0; i < 5; ++i)
  {
    CHECK_EQUAL(ask(paths, Surface_point(vertex(i))).distance, i == 4 ? 0. : -1.);
    CHECK_EQUAL(checked_path(paths, Surface_point(vertex(i)), tm, 1.).size(), i == 4 ? 1u : 0u);
  }
  CHECK(isolated->first == Geodesic_paths::Graph_traits::null_face());
  CHECK_EQUAL(ask(paths, Surface_point(location_of_vertex(vertex(2), face(0), tm))).distance, -1.);
  CHECK_EQUAL(ask(paths, in_plane(.25, .5, tm)).distance, -1.);
  CHECK(checked_path(paths, in_plane(.25, .5, tm), tm, 1.).empty());
  paths.add_source_point(vertex(1));
  CHECK_EQUAL(ask(paths, Surface_point(vertex(4))).source, 0u);
  CHECK_EQUAL(ask(paths, Surface_point(vertex(3))).source, 1u);
  CHECK_CLOSE(ask(paths, in_plane(.5, .5, tm)).distance, std::sqrt(.5), tolerance);
}

void other_components_are_not_reached()
{
  test_support::Scope scope("two_components");
  const Mesh tm = load_data("two_components");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  for(std::size_t i = 0; i < 6; ++i)
  {
    CHECK_EQUAL(ask(paths, Surface_point(vertex(i))).distance, i > 2 ? -1. : i == 0 ? 0. : 1.);
  }
  CHECK(checked_path(paths, Surface_point(Face_location(face(1), {.25, .25, .5})), tm, 1.).empty());
  paths.add_source_point(vertex(3));
  for(std::size_t i = 0; i < 6; ++i)
  {
    CHECK_EQUAL(ask(paths, Surface_point(vertex(i))).distance, i % 3 == 0 ? 0. : 1.);
    CHECK_EQUAL(ask(paths, Surface_point(vertex(i))).source, i / 3);
  }
  checked_path(paths, Surface_point(Face_location(face(1), {.25, .25, .5})), tm, 1.);
}

void points_of_paths_are_not_repeated()
{
  {
    test_support::Scope scope("grid6");
    const Mesh tm = load_data("grid6");
    Geodesic_paths paths(tm);
    paths.add_source_point(vertex(0));
    CHECK_EQUAL(checked_path(paths, Surface_point(vertex(5)), tm, 1.).size(), 6u);
    for(const vertex_descriptor s : vertices(tm))
    {
      paths.remove_all_source_points();
      paths.add_source_point(s);
      for(const vertex_descriptor v : vertices(tm))
      {
        CHECK_NEAR(ask(paths, Surface_point(v)).distance, length(coordinates(s, tm) - coordinates(v, tm)), tolerance);
        checked_path(paths, Surface_point(v), tm, 1.);
      }
    }
  }
  test_support::Scope scope("cap_zero_area");
  const Mesh tm = load_data("cap_zero_area");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(4));
  const double r2 = std::sqrt(2.);
  const std::vector<double> expected{r2, r2, 1., 2., 0.};
  check_paths_of_vertices(paths, tm, expected, 1., tolerance);
}

void edges_may_have_no_length()
{
  test_support::Scope scope("needle_dup_position");
  const Mesh tm = load_data("needle_dup_position");
  const std::vector<double> expected{0., 1., std::sqrt(2.), 1., 1., 2., std::sqrt(5.)};
  for(const Surface_point& source : at_vertex(0, tm))
  {
    Geodesic_paths paths(tm);
    add(paths, source);
    check_paths_of_vertices(paths, tm, expected, 2., tolerance);
    for(const double t : {.25, .5})
    {
      for(const Surface_point query : on_edge(1, 4, t, tm))
      {
        CHECK_CLOSE(ask(paths, query).distance, 1., tolerance);
        checked_path(paths, query, tm, 2.);
      }
    }
  }
  for(const Surface_point source : on_edge(1, 4, .25, tm))
  {
    Geodesic_paths paths(tm);
    add(paths, source);
    for(const vertex_descriptor v : vertices(tm))
    {
      const double expected_distance = length(coordinates(v, tm) - Coordinates{1., 0., 0.});
      CHECK_NEAR(ask(paths, Surface_point(v)).distance, expected_distance, tolerance);
      checked_path(paths, Surface_point(v), tm, 2.);
    }
  }
}

void broken_files_are_rejected()
{
  for(const std::string name : {"edge_three_faces", "index_out_of_range"})
  {
    test_support::Scope scope(name);
    bool is_rejected = false;
    try
    {
      Mesh tm;
      is_rejected = !read_data(name, tm);
      if(!is_rejected && num_vertices(tm) > 0)
      {
        Geodesic_paths paths(tm);
        paths.add_source_point(vertex(0));
        paths.build_sequence_tree_for_faces();
      }
    }
    catch(const std::exception&)
    {
      is_rejected = true;
    }
    CHECK(is_rejected);
  }
}

// Reads every file of the folder, so none is forgotten. From each vertex and from points of faces, the distances are
// those of geodesic_distances(), and each path is as long as its distance.
void every_file_has_right_distances(test_support::Random& random)
{
  std::size_t number_of_meshes = 0;
  for(const auto& entry : std::filesystem::directory_iterator("data"))
  {
    const std::string name = entry.path().stem().string();
    Mesh tm;
    if(entry.path().extension() != ".off" || name == "edge_three_faces" || name == "index_out_of_range")
    {
      continue;
    }
    test_support::Scope scope(name);
    if(!CHECK(read_data(name, tm)))
    {
      continue;
    }
    ++number_of_meshes;
    const double size = size_of(tm);
    auto expected = get(CGAL::dynamic_vertex_property_t<double>(), tm);
    for(std::size_t i = 0; i < num_vertices(tm) + 5; ++i)
    {
      const bool is_vertex = i < num_vertices(tm);
      const Surface_point point = is_vertex ? Surface_point(vertex(i)) : Surface_point(random_location(tm, random));
      test_support::Scope source_scope("source " + description(point));
      Geodesic_paths paths(tm);
      add(paths, point);
      if(is_vertex)
      {
        CGAL::Surface_mesh_geodesics::geodesic_distances(tm, expected, point.vertex);
      }
      else
      {
        CGAL::Surface_mesh_geodesics::geodesic_distances(tm, expected, point.location);
      }
      for(const vertex_descriptor v : vertices(tm))
      {
        const double distance = ask(paths, Surface_point(v)).distance;
        CHECK_EQUAL(distance < 0. ? infinity : distance, get(expected, v));
        checked_path(paths, Surface_point(v), tm, size);
      }
      checked_path(paths, point, tm, size);
    }
  }
  CHECK(number_of_meshes >= 37);
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260402);
  test_support::Random random(seed);
  edge_sources_are_not_mirrored();
  noise_at_a_corner_changes_nothing();
  queries_on_border_edges_are_answered();
  two_vertices_may_be_sources();
  two_sources_may_be_in_one_face();
  several_sources_in_faces_are_all_found(random);
  isolated_vertices_are_reached_by_themselves_only();
  other_components_are_not_reached();
  points_of_paths_are_not_repeated();
  edges_may_have_no_length();
  broken_files_are_rejected();
  every_file_has_right_distances(random);
  return test_result();
}
