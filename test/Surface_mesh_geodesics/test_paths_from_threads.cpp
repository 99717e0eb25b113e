// Queries of a built object from four threads at once give the same bits as one after the other. Some threads know the
// object as const; the others call the functions that would build it if that were not done.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <cstddef>
#include <iterator>
#include <thread>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

// what one query says, as numbers
template <class Paths> // const or not
std::vector<double> everything(Paths& paths, const Place& query)
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

// what is asked once for the whole mesh, as numbers
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

// All queries, beginning with the given one. What is asked once for the whole mesh comes first or last.
template <class Paths>
std::vector<std::vector<double>> all_answers(Paths& paths, const Mesh& tm, const std::vector<Place>& queries,
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

void test_mesh(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  Geodesic_paths building(tm);
  std::vector<Place> queries;
  for(std::size_t i = 0; i < 5; ++i)
  {
    add(building, i % 2 == 0 ? Place(random_vertex(tm, random)) : Place(random_location(tm, random)));
  }
  for(std::size_t i = 0; i < 600; ++i)
  {
    queries.push_back(i % 3 == 0 ? Place(random_vertex(tm, random)) : Place(random_location(tm, random)));
  }
  building.build_sequence_tree_for_faces();
  const Geodesic_paths& paths = building;
  const std::vector<std::vector<double>> expected = all_answers(paths, tm, queries, 0, false);

  const std::size_t number_of_threads = 4;
  std::vector<std::vector<std::vector<double>>> results(number_of_threads);
  std::vector<std::thread> threads;
  for(std::size_t t = 0; t < number_of_threads; ++t)
  {
    threads.emplace_back(
      [&, t]
      {
        // each thread begins somewhere else
        const std::size_t first = t * queries.size() / number_of_threads;
        results[t] = t < 2 ? all_answers(paths, tm, queries, first, t % 2 == 0)
                           : all_answers(building, tm, queries, first, t % 2 == 0);
      });
  }
  for(std::thread& thread : threads)
  {
    thread.join();
  }
  for(const auto& result : results)
  {
    CHECK(result == expected);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260406);
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : {noisy_sphere(3, .05, seed), rough_terrain(12, 1.5, seed), genus_3_polycube(),
                                     two_components_and_an_isolated_vertex()})
  {
    test_mesh(indexed, random);
  }
  return test_result();
}
