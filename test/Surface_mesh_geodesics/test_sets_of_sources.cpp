// Sets of sources that are unusual but allowed: none, duplicates, several in one face or on one edge, any range.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <array>
#include <list>
#include <set>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

const double tolerance = 1e-12;

void an_empty_range_leaves_all_at_infinity(const Mesh& tm)
{
  test_support::Scope scope("empty range");
  for(const double d : distances(tm, std::vector<vertex_descriptor>()))
  {
    CHECK_EQUAL(d, infinity);
  }
  auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
  auto options = options_with_map<Mesh>(nearest);
  options.targets.push_back(vertex(0));
  for(const double d : distances_with_options(tm, std::vector<Face_location>(), options))
  {
    CHECK_EQUAL(d, infinity);
  }
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(get(nearest, v), no_source);
  }
}

void an_empty_mesh_has_no_distances()
{
  test_support::Scope scope("empty mesh");
  const Mesh tm;
  CHECK(distances(tm, std::vector<vertex_descriptor>()).empty());
}

void any_range_or_single_source_is_accepted(const Mesh& tm, test_support::Random& random)
{
  test_support::Scope scope("kinds of ranges");
  const vertex_descriptor s = random_vertex(tm, random);
  const vertex_descriptor t = random_vertex(tm, random);
  const std::vector<double> single = distances(tm, s);
  CHECK(distances(tm, std::vector<vertex_descriptor>{s}) == single);
  CHECK(distances(tm, std::list<vertex_descriptor>{s}) == single);
  CHECK(distances(tm, std::array<vertex_descriptor, 1>{s}) == single);
  const std::vector<double> both = distances(tm, std::vector<vertex_descriptor>{s, t});
  CHECK(distances(tm, std::set<vertex_descriptor>{s, t}) == both);
  CHECK(distances(tm, std::list<vertex_descriptor>{t, s}) == both);
  const Face_location location = random_location(tm, random);
  CHECK(distances(tm, std::list<Face_location>{location}) == distances(tm, location));
  // barycentric coordinates of another type
  const std::pair<face_descriptor, std::array<float, 3>> quarter(location.first, {.5f, .25f, .25f});
  CHECK(distances(tm, quarter) == distances(tm, Face_location(location.first, {.5, .25, .25})));
  // all vertices
  for(const double d : distances(tm, vertices(tm)))
  {
    CHECK_EQUAL(d, 0.);
  }
}

void duplicate_and_adjacent_sources_are_harmless(const Mesh& tm, test_support::Random& random)
{
  test_support::Scope scope("duplicate and adjacent sources");
  const vertex_descriptor s = random_vertex(tm, random);
  const std::vector<double> single = distances(tm, s);
  CHECK(distances(tm, std::vector<vertex_descriptor>(4, s)) == single);

  const auto h = halfedge(s, tm);
  const vertex_descriptor neighbor = source(h, tm);
  const std::vector<double> other = distances(tm, neighbor);
  auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
  const std::vector<double> both = distances_with_options(tm, std::vector<vertex_descriptor>{s, neighbor, s},
                                                          options_with_map<Mesh>(nearest));
  for(std::size_t i = 0; i < both.size(); ++i)
  {
    CHECK_CLOSE(both[i], (std::min)(single[i], other[i]), tolerance);
  }
  CHECK(get(nearest, s) == 0u || get(nearest, s) == 2u);
  CHECK_EQUAL(get(nearest, neighbor), 1u);
}

void several_sources_in_one_face_and_on_one_edge_are_all_found(const Mesh& tm, test_support::Random& random)
{
  test_support::Scope scope("one face, one edge");
  const face_descriptor f = random_location(tm, random).first;
  std::vector<Face_location> sources{{f, {.2, .3, .5}}, {f, {.6, .2, .2}}, {f, {.1, .85, .05}}};
  auto h = halfedge(f, tm);
  sources.push_back(location_on_halfedge(h, .25, tm));
  sources.push_back(location_on_halfedge(h, .75, tm));
  if(!is_border(opposite(h, tm), tm))
  {
    sources.push_back(location_on_halfedge(opposite(h, tm), .5, tm));
    sources.push_back(location_on_halfedge(opposite(h, tm), .25, tm)); // the point at .75 again
  }
  sources.push_back(location_on_halfedge(h, 1., tm)); // a vertex
  std::vector<double> expected(num_vertices(tm), infinity);
  std::vector<std::vector<double>> fields;
  for(const Face_location& s : sources)
  {
    fields.push_back(distances(tm, s));
    for(std::size_t i = 0; i < expected.size(); ++i)
    {
      expected[i] = (std::min)(expected[i], fields.back()[i]);
    }
  }
  auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
  const std::vector<double> result =
    distances_with_options(tm, sources, options_with_map<Mesh>(nearest));
  CHECK_FIELDS_CLOSE(result, expected, tolerance);
  for(std::size_t i = 0; i < expected.size(); ++i)
  {
    const std::size_t id = get(nearest, vertex(i));
    if(expected[i] != infinity && CHECK(id < sources.size()))
    {
      CHECK_CLOSE(fields[id][i], expected[i], tolerance);
    }
  }
}

// A source on an edge gives the same distances from both faces, also on the border.
void edge_sources_are_the_same_from_both_faces(const Mesh& tm)
{
  test_support::Scope scope("edge sources");
  std::size_t i = 0;
  for(const auto e : edges(tm))
  {
    if(++i % 7 != 0)
    {
      continue;
    }
    const auto h = halfedge(e, tm);
    for(const double t : {0., .125, .5, .8125, 1.})
    {
      std::vector<std::vector<double>> fields;
      if(!is_border(h, tm))
      {
        fields.push_back(distances(tm, location_on_halfedge(h, t, tm)));
      }
      if(!is_border(opposite(h, tm), tm))
      {
        fields.push_back(distances(tm, location_on_halfedge(opposite(h, tm), 1. - t, tm)));
      }
      CHECK_FIELDS_CLOSE(fields.front(), fields.back(), tolerance);
      const double length_of_edge =
        length(coordinates(source(h, tm), tm) - coordinates(target(h, tm), tm));
      // The distance is at most the distance along the edge.
      CHECK(fields.front()[std::size_t(source(h, tm))] <= t * length_of_edge * (1. + tolerance));
      CHECK(fields.front()[std::size_t(target(h, tm))] <= (1. - t) * length_of_edge * (1. + tolerance));
      if(t == 0.)
      {
        CHECK(fields.front() == distances(tm, source(h, tm)));
      }
      if(t == 1.)
      {
        CHECK(fields.front() == distances(tm, target(h, tm)));
      }
    }
  }
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260105);
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : meshes_of_many_kinds(seed))
  {
    test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    an_empty_range_leaves_all_at_infinity(tm);
    any_range_or_single_source_is_accepted(tm, random);
    duplicate_and_adjacent_sources_are_harmless(tm, random);
    several_sources_in_one_face_and_on_one_edge_are_all_found(tm, random);
    edge_sources_are_the_same_from_both_faces(tm);
  }
  an_empty_mesh_has_no_distances();
  return test_result();
}
