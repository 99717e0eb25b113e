// Concurrent queries give the same bits as queries one after the other. First, four threads query an object that is
// built, some of them through a const reference. Then eight threads query a const object of which nothing is built, or
// only the distances of vertices: the first query that needs more computes it, while the others continue or wait.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <atomic>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

// The answers of all members to one query, as numbers.
template <class Paths> // const or not
std::vector<double> everything(Paths& paths, const Surface_point& query)
{
  std::vector<double> result;
  const Answer answer = ask(paths, query);
  result.push_back(answer.distance);
  result.push_back(static_cast<double>(answer.source));
  Path_recorder<Geodesic_paths> visitor;
  result.push_back(ask_sequence(paths, query, visitor).distance);
  for(const auto& item : visitor.items)
  {
    result.push_back(item.kind);
    result.push_back(item.t);
    for(const double x : point_of_item(item, paths))
    {
      result.push_back(x);
    }
  }
  std::vector<Kernel::Point_3> points;
  result.push_back(ask_points(paths, query, std::back_inserter(points)).distance);
  for(const Kernel::Point_3& p : points)
  {
    for(const double x : to_coordinates(p))
    {
      result.push_back(x);
    }
  }
  std::vector<std::pair<Kernel::Point_3, Mesh::Face_index>> polyline;
  if(query.is_vertex())
  {
    result.push_back(static_cast<double>(paths.nearest_source_point(query.vertex)));
    paths.shortest_path_polyline_to_source_points(query.vertex, std::back_inserter(polyline));
    result.push_back(paths.farthest_vertex().second);
    result.push_back(to_coordinates(paths.point(query.vertex))[0]);
    result.push_back(paths.face_location(query.vertex).second[0]);
  }
  else
  {
    result.push_back(static_cast<double>(paths.nearest_source_point(query.location.first, query.location.second)));
    paths.shortest_path_polyline_to_source_points(query.location.first, query.location.second,
                                                  std::back_inserter(polyline));
  }
  for(const auto& item : polyline)
  {
    result.push_back(item.first.x());
    result.push_back(static_cast<double>(item.second.idx()));
  }
  result.push_back(static_cast<double>(paths.number_of_source_points()));
  result.push_back(paths.changed_since_last_build() ? 1. : 0.);
  return result;
}

// The answers for the whole mesh, as numbers.
template <class Paths>
std::vector<double> everything_at_once(Paths& paths, const Mesh& tm)
{
  std::vector<double> distances(num_vertices(tm));
  paths.shortest_distances_to_source_points(
    boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, tm)));
  std::vector<std::vector<Kernel::Point_3>> lines;
  paths.isolines(paths.farthest_vertex().second / 2., std::back_inserter(lines));
  std::vector<double> result = distances;
  for(const auto& line : lines)
  {
    for(const Kernel::Point_3& p : line)
    {
      for(const double x : to_coordinates(p))
      {
        result.push_back(x);
      }
    }
  }
  return result;
}

// Makes all queries, beginning with the given one. The queries for the whole mesh come first or last.
template <class Paths>
std::vector<std::vector<double>> all_answers(Paths& paths, const Mesh& tm, const std::vector<Surface_point>& queries,
                                             std::size_t first, bool whole_mesh_first)
{
  std::vector<std::vector<double>> results(queries.size() + 1);
  if(whole_mesh_first)
  {
    results.back() = everything_at_once(paths, tm);
  }
  for(std::size_t i = 0; i < queries.size(); ++i)
  {
    const std::size_t q = (i + first) % queries.size();
    results[q] = everything(paths, queries[q]);
  }
  if(!whole_mesh_first)
  {
    results.back() = everything_at_once(paths, tm);
  }
  return results;
}

using All_answers = std::vector<std::vector<double>>;

// Runs ask(t) for t from 0 to number_of_threads - 1, each in a thread.
template <class Ask>
void run_in_threads(std::size_t number_of_threads, Ask ask)
{
  std::vector<std::thread> threads;
  for(std::size_t t = 0; t < number_of_threads; ++t)
  {
    threads.emplace_back([ask, t] { ask(t); });
  }
  for(std::thread& thread : threads)
  {
    thread.join();
  }
}

void threads_ask_a_built_object(Geodesic_paths& built, const Mesh& tm, const std::vector<Surface_point>& queries,
                                const All_answers& expected)
{
  test_support::Scope scope("built");
  const std::size_t number_of_threads = 4;
  const Geodesic_paths& constant = built;
  std::vector<All_answers> results(number_of_threads);
  run_in_threads(number_of_threads, [&](std::size_t t)
  {
    const std::size_t first = t * queries.size() / number_of_threads; // each thread begins with another query
    results[t] = t < 2 ? all_answers(constant, tm, queries, first, t % 2 == 0)
                       : all_answers(built, tm, queries, first, t % 2 == 0);
  });
  for(const All_answers& result : results)
  {
    CHECK(result == expected);
  }
}

// All threads begin at once, with queries of different kinds.
void threads_ask_an_object_that_is_not_built(const std::vector<Surface_point>& sources, bool has_vertices,
                                             const Mesh& tm, const std::vector<Surface_point>& queries,
                                             const All_answers& expected)
{
  test_support::Scope scope(has_vertices ? "built for vertices" : "never built");
  const std::size_t number_of_threads = 8;
  Geodesic_paths paths(tm);
  for(const Surface_point& source : sources)
  {
    add(paths, source);
  }
  if(has_vertices)
  {
    paths.build_sequence_tree();
  }
  const Geodesic_paths& constant = paths;
  std::vector<All_answers> results(number_of_threads);
  std::atomic<std::size_t> number_waiting{number_of_threads};
  run_in_threads(number_of_threads, [&](std::size_t t)
  {
    --number_waiting;
    while(number_waiting > 0)
    {
      std::this_thread::yield();
    }
    // the first query of a thread is at a vertex, at a point of a face, or for the whole mesh
    results[t] = all_answers(constant, tm, queries, t, t % 4 == 3);
  });
  for(All_answers& result : results)
  {
    CHECK(result == expected);
  }
  CHECK(!paths.changed_since_last_build());
}

// If the first query finds an invalid source, every thread gets the exception. The object is usable again without the
// source.
void threads_get_the_exception_of_a_build(const Mesh& tm, const std::vector<Surface_point>& queries)
{
  test_support::Scope scope("bad source");
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  const auto bad = paths.add_source_point(Mesh::Face_index(0), {.7, .7, .7});
  const Geodesic_paths& constant = paths;
  std::atomic<std::size_t> number_of_exceptions{0};
  run_in_threads(8, [&](std::size_t t)
  {
    try
    {
      ask(constant, queries[t]);
    }
    catch(const std::invalid_argument&)
    {
      ++number_of_exceptions;
    }
  });
  CHECK_EQUAL(number_of_exceptions.load(), 8u);
  CHECK(paths.changed_since_last_build());
  paths.remove_source_point(bad);
  CHECK_EQUAL(ask(constant, Surface_point(vertex(0))).distance, 0.);
}

void queries_of_several_threads_agree(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  Geodesic_paths paths(tm);
  std::vector<Surface_point> sources, queries;
  for(std::size_t i = 0; i < 5; ++i)
  {
    sources.push_back(random_vertex_or_location(i % 2 == 0, tm, random));
    add(paths, sources.back());
  }
  for(std::size_t i = 0; i < 600; ++i)
  {
    queries.push_back(random_vertex_or_location(i % 3 == 0, tm, random));
  }
  paths.build_sequence_tree_for_faces();
  const All_answers expected = all_answers(std::as_const(paths), tm, queries, 0, false);
  threads_ask_a_built_object(paths, tm, queries, expected);
  for(const bool has_vertices : {false, true})
  {
    threads_ask_an_object_that_is_not_built(sources, has_vertices, tm, queries, expected);
  }
  threads_get_the_exception_of_a_build(tm, queries);
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260406);
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : {noisy_sphere(3, .05, seed), rough_terrain(12, 1.5, seed), genus_3_polycube(),
                                     two_components_and_an_isolated_vertex()})
  {
    queries_of_several_threads_agree(indexed, random);
  }
  return test_result();
}
