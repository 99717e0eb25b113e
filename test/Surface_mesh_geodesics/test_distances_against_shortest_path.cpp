// Compares with CGAL::Surface_mesh_shortest_path where that class is reliable: one source at a vertex or strictly
// inside a face, queries at vertices. For several sources the reference is the minimum over runs with one source; for a
// source on an edge it is a mesh with a vertex at that point.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <vector>

using namespace test_meshes;

namespace {

using Shortest_path_traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Shortest_path = CGAL::Surface_mesh_shortest_path<Shortest_path_traits>;

const double tolerance = 1e-12;

std::vector<double> read_off(Shortest_path& shortest_path, const Mesh& tm)
{
  std::vector<double> result;
  for(const vertex_descriptor v : vertices(tm))
  {
    if(tm.is_isolated(v))
    {
      result.push_back(infinity);
      continue;
    }
    const double d = shortest_path.shortest_distance_to_source_points(v).first;
    result.push_back(d < 0. ? infinity : d);
  }
  return result;
}

std::vector<double> expected_distances(const Mesh& tm, vertex_descriptor source)
{
  Shortest_path shortest_path(tm);
  shortest_path.add_source_point(source);
  return read_off(shortest_path, tm);
}

std::vector<double> expected_distances(const Mesh& tm, const Face_location& source)
{
  Shortest_path shortest_path(tm);
  shortest_path.add_source_point(source.first, source.second);
  return read_off(shortest_path, tm);
}

void vertex_sources_agree(const Mesh& tm, std::size_t number, test_support::Random& random)
{
  test_support::Scope scope("vertex source");
  const bool take_all = number >= num_vertices(tm);
  for(std::size_t i = 0; i < (take_all ? num_vertices(tm) : number); ++i)
  {
    const vertex_descriptor source = take_all ? vertex(i) : random_vertex(tm, random);
    if(tm.is_isolated(source))
    {
      continue;
    }
    test_support::Scope source_scope("source " + std::to_string(std::size_t(source)));
    CHECK_FIELDS_CLOSE(distances(tm, source), expected_distances(tm, source), tolerance);
  }
}

void face_sources_agree(const Mesh& tm, std::size_t number, test_support::Random& random)
{
  test_support::Scope scope("face source");
  for(std::size_t i = 0; i < number; ++i)
  {
    const Face_location source = random_location(tm, random, i % 3 == 2 ? 1e-5 : 1e-2);
    test_support::Scope source_scope("face " + std::to_string(std::size_t(source.first)));
    CHECK_FIELDS_CLOSE(distances(tm, source), expected_distances(tm, source), tolerance);
  }
}

void edge_sources_agree(const Indexed_mesh& indexed, const Mesh& tm, std::size_t number, test_support::Random& random)
{
  test_support::Scope scope("edge source");
  std::vector<Mesh::Edge_index> all_edges(edges(tm).begin(), edges(tm).end());
  for(std::size_t i = 0; i < number; ++i)
  {
    const auto h = halfedge(all_edges[random.index(all_edges.size())], tm);
    const double t = random.uniform(.02, .98);
    const std::size_t a = std::size_t(source(h, tm));
    const std::size_t b = std::size_t(target(h, tm));
    const Indexed_mesh split = with_point_on_edge(indexed, a, b, t);
    const Mesh split_tm = to_face_graph(split);
    std::vector<double> expected = expected_distances(split_tm, vertex(split.points.size() - 1));
    expected.pop_back();
    test_support::Scope source_scope("edge " + std::to_string(a) + " " + std::to_string(b));
    for(const auto& side : {std::make_pair(h, t), std::make_pair(opposite(h, tm), 1. - t)})
    {
      if(!is_border(side.first, tm))
      {
        CHECK_FIELDS_CLOSE(distances(tm, location_on_halfedge(side.first, side.second, tm)), expected, tolerance);
      }
    }
  }
}

template <class Source>
void several_sources_give_the_minimum(const Mesh& tm, const std::vector<Source>& sources,
                                      const std::vector<double>& offsets)
{
  test_support::Scope scope(std::to_string(sources.size()) + " sources" +
                            (offsets.empty() ? "" : " with offsets"));
  std::vector<std::vector<double>> single_fields;
  for(std::size_t i = 0; i < sources.size(); ++i)
  {
    single_fields.push_back(expected_distances(tm, sources[i]));
    if(!offsets.empty())
    {
      for(double& d : single_fields.back())
      {
        d += offsets[i];
      }
    }
  }
  std::vector<double> expected = single_fields.front();
  for(const std::vector<double>& field : single_fields)
  {
    for(std::size_t v = 0; v < field.size(); ++v)
    {
      expected[v] = (std::min)(expected[v], field[v]);
    }
  }

  auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
  auto options = options_with_map<Mesh>(nearest);
  options.source_offsets = offsets;
  const std::vector<double> result = distances_with_options(tm, sources, options);
  CHECK_FIELDS_CLOSE(result, expected, tolerance);
  if(offsets.empty())
  {
    CHECK(distances(tm, sources) == result);
  }

  std::size_t i = 0;
  for(const vertex_descriptor v : vertices(tm))
  {
    const std::size_t id = get(nearest, v);
    if(expected[i] == infinity)
    {
      CHECK_EQUAL(id, no_source);
    }
    else if(CHECK(id < sources.size()))
    {
      CHECK_CLOSE(single_fields[id][i], expected[i], tolerance);
    }
    ++i;
  }
}

void all_kinds_of_sources_agree(const Indexed_mesh& indexed, std::size_t effort, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  vertex_sources_agree(tm, effort, random);
  face_sources_agree(tm, effort, random);
  edge_sources_agree(indexed, tm, effort / 2, random);

  double size = 0.;
  for(const double d : expected_distances(tm, random_vertex(tm, random)))
  {
    if(d != infinity)
    {
      size = (std::max)(size, d);
    }
  }
  for(std::size_t number = 2; number <= 5 && number <= effort; ++number)
  {
    std::vector<vertex_descriptor> vertex_sources;
    std::vector<Face_location> face_sources;
    std::vector<double> offsets;
    for(std::size_t i = 0; i < number; ++i)
    {
      vertex_sources.push_back(random_vertex(tm, random));
      face_sources.push_back(random_location(tm, random));
      offsets.push_back(i == 1 ? 0. : random.uniform(0., .5 * size));
    }
    several_sources_give_the_minimum(tm, vertex_sources, {});
    several_sources_give_the_minimum(tm, vertex_sources, offsets);
    several_sources_give_the_minimum(tm, face_sources, {});
    several_sources_give_the_minimum(tm, face_sources, offsets);
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260101);
  test_support::Random random(seed);
  std::size_t number_of_meshes = 0;
  for(const Indexed_mesh& indexed : collection(seed))
  {
    all_kinds_of_sources_agree(indexed, indexed.faces.size() < 700 ? 12 : 3, random);
    ++number_of_meshes;
  }
  all_kinds_of_sources_agree(Schwarz_lantern(24, 160), 1, random);
  all_kinds_of_sources_agree(wavy_tube(60, 56), 1, random);
  number_of_meshes += 2;
  std::cout << number_of_meshes << " meshes" << std::endl;
  return test_result();
}
