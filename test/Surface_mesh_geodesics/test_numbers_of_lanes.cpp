// Loops process as many windows at a time as the processor has lanes. The results of a propagation are bitwise equal
// for all numbers of lanes, also if the compiler may fuse multiplications and additions.

#include "distance_test_helpers.h"
#include "intrinsic_mesh_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/curves/Strip_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_loops.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

namespace internal = SMG::internal;
using Intrinsic_mesh = internal::Intrinsic_mesh<double>;
using Field = internal::Vertex_distance_field<double>;
using Sources = std::vector<std::pair<internal::Vertex_id, double>>; // with offsets

// The results of a propagation, and the counts of operations on windows.
struct Outcome
{
  Field field;
  SMG::Propagation_statistics statistics;
};

template <class Rules>
Outcome propagate(const Intrinsic_mesh& mesh, const Sources& sources, internal::Lane_choice choice)
{
  Outcome outcome;
  outcome.field.keeps_images = true;
  internal::Distance_propagation<double, Rules> propagation(mesh, outcome.field, internal::No_window_keeper(), choice);
  for(const auto& source : sources)
  {
    propagation.add_source(source.first, source.second);
  }
  CHECK(propagation.run([](std::size_t, double) { return true; }));
  outcome.statistics = propagation.statistics();
  return outcome;
}

// The same from edges of the mesh: strips, and windows from the ends of the edges.
Outcome propagate(const Intrinsic_mesh& mesh, const internal::Source_curves<double>& curves,
                  internal::Lane_choice choice)
{
  Outcome outcome;
  outcome.field.keeps_images = true;
  internal::Distance_propagation<double, internal::All_pruning_rules, internal::No_window_keeper,
                                 internal::Strip_front<double>>
    propagation(mesh, outcome.field, internal::No_window_keeper(), choice);
  propagation.restart();
  propagation.add_curves(curves);
  CHECK(propagation.run([](std::size_t, double) { return true; }));
  outcome.statistics = propagation.statistics();
  return outcome;
}

void check_same(const Outcome& found, const Outcome& expected)
{
  CHECK(found.field.distance == expected.field.distance);
  CHECK(found.field.reached == expected.field.reached);
  for(std::size_t v = 0; v < expected.field.distance.size(); ++v)
  {
    CHECK(found.field.arrival[v].root == expected.field.arrival[v].root);
    CHECK(found.field.arrival[v].halfedge == expected.field.arrival[v].halfedge);
    if(expected.field.distance[v] < infinity)
    {
      CHECK(found.field.arrival[v].abscissa == expected.field.arrival[v].abscissa);
      CHECK(found.field.image[v].x == expected.field.image[v].x);
      CHECK(found.field.image[v].depth == expected.field.image[v].depth);
    }
  }
  const SMG::Propagation_statistics &a = found.statistics, &b = expected.statistics;
  CHECK_EQUAL(a.vertices_visited, b.vertices_visited);
  CHECK_EQUAL(a.window_lists, b.window_lists);
  CHECK_EQUAL(a.windows_created, b.windows_created);
  CHECK_EQUAL(a.windows_propagated, b.windows_propagated);
  CHECK_EQUAL(a.windows_removed_by_rule_1, b.windows_removed_by_rule_1);
  CHECK_EQUAL(a.windows_removed_by_rules_2_and_3, b.windows_removed_by_rules_2_and_3);
  CHECK_EQUAL(a.windows_removed_by_vertices, b.windows_removed_by_vertices);
  CHECK_EQUAL(a.windows_removed_as_slivers, b.windows_removed_as_slivers);
  CHECK_EQUAL(a.ambiguous_pairs, b.ambiguous_pairs);
  CHECK_EQUAL(a.maximum_windows_alive, b.maximum_windows_alive);
}

struct Without_vertex_rule : internal::All_pruning_rules
{
  static constexpr bool vertex_rule = false;
};

// propagate_with(choice) returns the outcome with a number of lanes.
template <class PropagateWith>
void check_that_lanes_agree(PropagateWith propagate_with)
{
  const Outcome expected = propagate_with(internal::Lane_choice::ONE);
  {
    test_support::Scope scope("at most two lanes");
    check_same(propagate_with(internal::Lane_choice::TWO), expected);
  }
  {
    test_support::Scope scope("at most four lanes");
    check_same(propagate_with(internal::Lane_choice::FOUR), expected);
  }
  {
    test_support::Scope scope("the lanes of the processor");
    check_same(propagate_with(internal::Lane_choice::BEST), expected);
  }
}

template <class Rules>
void check_that_lanes_agree(const Intrinsic_mesh& mesh, const Sources& sources)
{
  check_that_lanes_agree([&](internal::Lane_choice choice) { return propagate<Rules>(mesh, sources, choice); });
}

// Up to n edges without common vertices. Every edge has its own offset: where one edge is nearer, it beats a part of
// the strips of another one.
internal::Source_curves<double> random_edges(const Intrinsic_mesh& mesh, std::size_t n, test_support::Random& random)
{
  internal::Source_curves<double> curves;
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t f = random.index(mesh.number_of_faces());
    const internal::Halfedge_id h
      = internal::halfedge_of(static_cast<internal::Face_id>(f), static_cast<unsigned int>(random.index(3)));
    const double offset = i == 0 ? 0. : random.uniform(0., .1);
    const auto is_taken = [&](const internal::Source_vertex<double>& v)
    { return v.vertex == mesh.source(h) || v.vertex == mesh.target(h); };
    if(std::any_of(curves.vertices.begin(), curves.vertices.end(), is_taken))
      continue;
    curves.edges.push_back(internal::Source_edge<double>{h, mesh.opposite(h), mesh.source(h), mesh.target(h),
                                                         mesh.length(h), offset, 0, static_cast<std::uint32_t>(i), 0,
                                                         1});
    for(const internal::Vertex_id v : {mesh.source(h), mesh.target(h)})
      curves.vertices.push_back(internal::Source_vertex<double>{v, offset, {0, static_cast<std::uint32_t>(i), 0}});
  }
  return curves;
}

void all_numbers_of_lanes_give_the_same_results(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(indexed));
  Sources sources;
  for(std::size_t i = 0; i < 3; ++i)
  {
    sources.emplace_back(static_cast<internal::Vertex_id>(random.index(mesh.number_of_vertices())),
                         random.uniform(0., .1));
    check_that_lanes_agree<internal::All_pruning_rules>(mesh, sources);
  }
  const internal::Source_curves<double> curves = random_edges(mesh, 5, random);
  {
    test_support::Scope scope_of_curves("from edges");
    check_that_lanes_agree([&](internal::Lane_choice choice) { return propagate(mesh, curves, choice); });
  }
  if(mesh.number_of_faces() <= 400)
  {
    check_that_lanes_agree<Without_vertex_rule>(mesh, sources);
  }
}

// Prints the numbers of lanes: which ones are tested depends on the machine.
void print_lanes()
{
  const auto lanes = [](internal::Lane_choice choice)
  { return internal::window_list_loops<double, internal::All_pruning_rules>(choice).lanes; };
  std::cout << "lanes: at most two: " << lanes(internal::Lane_choice::TWO)
            << ", at most four: " << lanes(internal::Lane_choice::FOUR)
            << ", of the processor: " << lanes(internal::Lane_choice::BEST) << std::endl;
  CHECK_EQUAL(lanes(internal::Lane_choice::ONE), std::size_t(1));
  CHECK(lanes(internal::Lane_choice::TWO) <= std::size_t(2));
  CHECK(lanes(internal::Lane_choice::FOUR) <= std::size_t(4));
  CHECK(lanes(internal::Lane_choice::FOUR) >= lanes(internal::Lane_choice::TWO));
  CHECK(lanes(internal::Lane_choice::BEST) >= lanes(internal::Lane_choice::FOUR));
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260321);
  test_support::Random random(seed);
  print_lanes();
  for(const Indexed_mesh& indexed : collection(seed))
  {
    all_numbers_of_lanes_give_the_same_results(indexed, random);
  }
  all_numbers_of_lanes_give_the_same_results(noisy_sphere(5, .01, seed), random); // long lists
  // Flat faces: ties everywhere.
  all_numbers_of_lanes_give_the_same_results(midpoint_subdivision(voxel_surface("L", {{"##", "#."}}), 4), random);
  return test_result();
}
