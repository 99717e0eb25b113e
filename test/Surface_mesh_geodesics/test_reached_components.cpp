// geodesic_distances() processes the components that a source can reach, and no others. Its answers are those of
// Geodesic_distance_solver, which processes all of them.

#include "distance_test_helpers.h"
#include "mesh_operations.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

namespace SMG = CGAL::Surface_mesh_geodesics;
using Location = std::pair<face_descriptor, std::array<double, 3>>;
using Distances = Mesh::Property_map<vertex_descriptor, double>;
using Numbers = Mesh::Property_map<vertex_descriptor, std::size_t>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Compares with the solver. Returns the number of vertices that are reached.
template <typename Sources>
std::size_t compare_with_solver(Mesh& tm, const Sources& sources)
{
  const Distances distances = tm.add_property_map<vertex_descriptor, double>("v:distance", -1.).first;
  const Numbers numbers = tm.add_property_map<vertex_descriptor, std::size_t>("v:source", 0).first;
  CHECK(SMG::geodesic_distances(tm, distances, sources, CGAL::parameters::nearest_source_map(numbers)));
  SMG::Geodesic_distance_solver<Mesh> solver(tm);
  solver.compute_distances(sources);
  std::size_t number_reached = 0;
  for(const vertex_descriptor v : vertices(tm))
  {
    const double expected = solver.distance(v);
    CHECK((distances[v] == infinity) == (expected == infinity));
    CHECK((numbers[v] == no_source) == (expected == infinity));
    if(expected < infinity)
    {
      CHECK_CLOSE(distances[v], expected, 1e-13 * (1 + expected));
      ++number_reached;
    }
  }
  return number_reached;
}

// Meshes out of which random faces have been removed have many components; some share vertices.
void random_components_agree_with_solver(test_support::Random& random)
{
  std::size_t number_of_partial_runs = 0;
  for(std::size_t i = 0; i < 60; ++i)
  {
    const Indexed_mesh whole = i % 2 == 0 ? icosphere(2) : flat_patch(12, 12, .2, false, i);
    const Indexed_mesh mesh = random_cuts(whole, random.uniform(.5, .9), i);
    test_support::Scope scope(mesh.name + ", number " + std::to_string(i));
    Mesh tm = to_face_graph(mesh);
    std::vector<vertex_descriptor> sources;
    for(std::size_t k = 0; k <= i % 3; ++k)
    {
      sources.push_back(vertex(random.index(mesh.points.size())));
    }
    const std::size_t reached = compare_with_solver(tm, sources);
    number_of_partial_runs += reached > 1 && 10 * reached < 9 * mesh.points.size();
    const face_descriptor f(static_cast<Mesh::size_type>(random.index(mesh.faces.size())));
    compare_with_solver(tm, Location(f, {{.2, .5, .3}}));
    compare_with_solver(tm, Location(f, {{.5, 0., .5}}));
  }
  CHECK(number_of_partial_runs > 10);
}

// A chain of triangles, each of which shares one vertex with the next. Paths lead through the shared vertices.
void paths_lead_from_component_to_component_through_vertices()
{
  Indexed_mesh chain;
  chain.name = "chain of triangles";
  const std::size_t n = 7;
  for(std::size_t i = 0; i <= n; ++i)
  {
    chain.points.push_back({double(i), 0, 0});
  }
  // The faces come in such an order that the chain is joined last in its middle.
  for(const std::size_t i : std::vector<std::size_t>{0, 6, 2, 4, 1, 5, 3})
  {
    chain.points.push_back({double(i) + .5, 1, 0});
    chain.faces.push_back({i, i + 1, chain.points.size() - 1});
  }
  const std::size_t first_beside = chain.points.size();
  const Indexed_mesh both = side_by_side(chain, icosphere(0), "chain and sphere");
  Mesh tm = to_face_graph(both);
  for(std::size_t i = 0; i <= n; ++i)
  {
    CHECK_EQUAL(compare_with_solver(tm, vertex(i)), first_beside);
    const Distances distances = tm.add_property_map<vertex_descriptor, double>("v:distance", -1.).first;
    for(std::size_t j = 0; j <= n; ++j)
    {
      CHECK_CLOSE(distances[vertex(j)], std::abs(double(i) - double(j)), 1e-14);
    }
  }
  CHECK_EQUAL(compare_with_solver(tm, vertex(first_beside)), both.points.size() - first_beside);
}

void isolated_vertices_and_no_sources_reach_nothing_else()
{
  Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  const std::size_t n = num_vertices(tm);
  CHECK_EQUAL(compare_with_solver(tm, vertex(n - 1)), std::size_t(1));
  CHECK_EQUAL(compare_with_solver(tm, std::vector<vertex_descriptor>()), std::size_t(0));
  CHECK(compare_with_solver(tm, std::vector<vertex_descriptor>{vertex(n - 1), vertex(0)}) < n);
  CHECK_EQUAL(compare_with_solver(tm, std::vector<vertex_descriptor>{vertex(0), vertex(n - 1), vertex(n - 2)}), n);
}

// A target that no source can reach does not end the computation before all others are final.
void targets_may_be_in_other_components()
{
  Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  const Distances distances = tm.add_property_map<vertex_descriptor, double>("v:distance", -1.).first;
  Distance_options<Mesh> options;
  options.targets = {vertex(num_vertices(tm) - 2)};
  CHECK(SMG::geodesic_distances(tm, distances, vertex(0), parameters_of(options)));
  std::size_t number_reached = 0;
  for(const vertex_descriptor v : vertices(tm))
  {
    number_reached += distances[v] < infinity;
  }
  CHECK_EQUAL(number_reached, icosphere(1).points.size());
}

// What no source can reach may be too small beside the mesh: the other components are not in the way.
void sizes_of_other_components_do_not_matter()
{
  const Indexed_mesh small = saddle_patch(4), large = icosphere(1);
  for(const double unit : {1e-70, 1e-150, 1e-300})
  {
    test_support::Scope scope("unit " + std::to_string(std::log10(unit)));
    Mesh tm = to_face_graph(side_by_side(large, scaled(small, unit), "both"));
    Mesh alone = to_face_graph(small);
    const Distances distances = tm.add_property_map<vertex_descriptor, double>("v:distance", -1.).first;
    const Distances expected = alone.add_property_map<vertex_descriptor, double>("v:distance", -1.).first;
    CHECK(SMG::geodesic_distances(alone, expected, vertex(0)));
    CHECK(SMG::geodesic_distances(tm, distances, vertex(large.points.size())));
    for(std::size_t i = 0; i < small.points.size(); ++i)
    {
      CHECK_CLOSE(distances[vertex(large.points.size() + i)] / unit, expected[vertex(i)], 1e-13);
    }
    CHECK(distances[vertex(0)] == infinity);
    CHECK(SMG::geodesic_distances(tm, distances, vertex(0)));
    CHECK(distances[vertex(0)] == 0 && distances[vertex(large.points.size())] == infinity);
  }
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20261123));
  random_components_agree_with_solver(random);
  paths_lead_from_component_to_component_through_vertices();
  isolated_vertices_and_no_sources_reach_nothing_else();
  targets_may_be_in_other_components();
  sizes_of_other_components_do_not_matter();
  return test_result();
}
