// Compares the class with CGAL::Surface_mesh_shortest_path where that class is reliable: one source at a vertex or
// strictly inside a face, queries at vertices and strictly inside faces. The reference for several sources is the
// minimum over objects with one source each. The reference for a point on an edge is a mesh with a vertex at that
// point. Each path is checked by itself too: length, points, elements, end.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <memory>
#include <vector>

using namespace test_meshes;

namespace {

using Shortest_path = CGAL::Surface_mesh_shortest_path<Paths_traits>;

const double tolerance = 1e-12;

std::size_t number_of_queries = 0;
std::size_t queries_with_one_source = 0;

Surface_point random_point(const Mesh& tm, test_support::Random& random)
{
  if(random.index(2) == 0)
  {
    return Surface_point(random_vertex(tm, random));
  }
  return Surface_point(random_location(tm, random, random.index(4) == 0 ? 1e-5 : 1e-2));
}

void check_distance(double d, double expected, double size)
{
  ++number_of_queries;
  if(std::abs(d - expected) > 1e-14 * size)
  {
    CHECK_CLOSE(d, expected, tolerance);
  }
}

void one_source(const Mesh& tm, double size, std::size_t sources, std::size_t queries, test_support::Random& random)
{
  test_support::Scope scope("one source");
  Geodesic_paths paths(tm);
  for(std::size_t i = 0; i < sources; ++i)
  {
    const Surface_point source = random_point(tm, random);
    Shortest_path original(tm);
    add(original, source);
    paths.remove_all_source_points();
    add(paths, source);
    for(std::size_t j = 0; j < queries; ++j)
    {
      const Surface_point query = random_point(tm, random);
      check_distance(ask(paths, query).distance, ask(original, query).distance, size);
      checked_path(paths, query, tm, size);
    }
    if(!source.is_vertex())
    {
      // from the same face, and from the source itself
      Surface_point query = source;
      CHECK_EQUAL(ask(paths, query).distance, 0.);
      CHECK_EQUAL(checked_path(paths, query, tm, size).size(), 1u);
      const double a = random.uniform(.1, .4), b = random.uniform(.1, .4);
      query.location.second = {a, b, 1. - a - b};
      check_distance(ask(paths, query).distance, ask(original, query).distance, size);
      checked_path(paths, query, tm, size);
    }
  }
}

void several_sources(const Mesh& tm, double size, std::size_t number, std::size_t queries,
                     test_support::Random& random)
{
  test_support::Scope scope(std::to_string(number) + " sources");
  Geodesic_paths paths(tm);
  std::vector<std::unique_ptr<Shortest_path>> originals;
  for(std::size_t i = 0; i < number; ++i)
  {
    const Surface_point source = random_point(tm, random);
    originals.push_back(std::make_unique<Shortest_path>(tm));
    add(*originals.back(), source);
    add(paths, source);
  }
  paths.build_sequence_tree_for_faces();
  const Geodesic_paths& built = paths;
  for(std::size_t j = 0; j < queries; ++j)
  {
    const Surface_point query = random_point(tm, random);
    std::vector<double> expected;
    for(const auto& original : originals)
    {
      const double d = ask(*original, query).distance;
      expected.push_back(d < 0. ? infinity : d);
    }
    const double minimum = *std::min_element(expected.begin(), expected.end());
    const Answer answer = ask(built, query);
    check_distance(answer.distance, minimum == infinity ? -1. : minimum, size);
    if(minimum != infinity && CHECK(answer.source < number))
    {
      CHECK_NEAR(expected[answer.source], minimum, tolerance * size);
    }
    checked_path(paths, query, tm, size);
    CHECK_EQUAL(query.is_vertex() ? paths.nearest_source_point(query.vertex)
                                  : paths.nearest_source_point(query.location.first, query.location.second),
                answer.source);
  }
}

// Splits the mesh at a point of an edge. The point is source or query, as a location in both faces.
void points_of_edges(const Indexed_mesh& indexed, const Mesh& tm, double size, std::size_t number,
                     test_support::Random& random)
{
  test_support::Scope scope("points of edges");
  const std::vector<Mesh::Edge_index> all_edges(edges(tm).begin(), edges(tm).end());
  Geodesic_paths from_edge(tm), from_vertex(tm);
  for(std::size_t i = 0; i < number; ++i)
  {
    const auto h = halfedge(all_edges[random.index(all_edges.size())], tm);
    const double t = random.uniform(.02, .98);
    const Indexed_mesh split = with_point_on_edge(indexed, std::size_t(source(h, tm)), std::size_t(target(h, tm)), t);
    const Mesh split_tm = to_face_graph(split);
    Shortest_path original(split_tm);
    original.add_source_point(vertex(split.points.size() - 1));
    for(const auto& side : {std::make_pair(h, t), std::make_pair(opposite(h, tm), 1. - t)})
    {
      if(is_border(side.first, tm))
      {
        continue;
      }
      const Surface_point point(location_on_halfedge(side.first, side.second, tm));
      from_edge.remove_all_source_points();
      add(from_edge, point);
      for(std::size_t j = 0; j < 5; ++j)
      {
        const Surface_point v(random_vertex(tm, random));
        const double expected = ask(original, v).distance;
        check_distance(ask(from_edge, v).distance, expected, size);
        checked_path(from_edge, v, tm, size);
        from_vertex.remove_all_source_points();
        add(from_vertex, v);
        check_distance(ask(from_vertex, point).distance, expected, size);
        checked_path(from_vertex, point, tm, size);
      }
    }
  }
}

void all_kinds_of_queries_agree(const Indexed_mesh& indexed, std::size_t effort, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  const double size = size_of(tm);
  const std::size_t queries_before = number_of_queries;
  one_source(tm, size, effort, 30, random);
  queries_with_one_source += number_of_queries - queries_before;
  points_of_edges(indexed, tm, size, effort, random);
  for(std::size_t number = 2; number <= effort / 2 + 1; ++number)
  {
    several_sources(tm, size, number, 25, random);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260401);
  test_support::Random random(seed);
  std::size_t number_of_meshes = 0;
  for(const Indexed_mesh& indexed : collection(seed))
  {
    all_kinds_of_queries_agree(indexed, indexed.faces.size() < 700 ? 10 : 6, random);
    ++number_of_meshes;
  }
  std::cout << number_of_meshes << " meshes, " << number_of_queries << " queries, " << queries_with_one_source
            << " of them with one source and no point of an edge" << std::endl;
  // with one source, the original itself gives the expected answers
  CHECK(number_of_meshes >= 20 && queries_with_one_source >= 10000);
  CHECK(number_of_queries > queries_with_one_source);
  return test_result();
}
