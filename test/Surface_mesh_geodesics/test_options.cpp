// What the named parameters of geodesic_distances() do, the visitor and the statistics. Sets of sources:
// test_sets_of_sources.cpp. Sequences of parameters and types of values: test_named_parameters.cpp.

#include "distance_test_helpers.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

using namespace test_meshes;

namespace {

const double tolerance = 1e-12;

using Options = Distance_options<Mesh>;

std::vector<double> sorted_finite(const std::vector<double>& field)
{
  std::vector<double> result;
  for(const double d : field)
  {
    if(d != infinity)
    {
      result.push_back(d);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

// ---------------------------------------------------------------------------
// radius
// ---------------------------------------------------------------------------

template <class Sources>
void distances_up_to_the_radius_are_exact(const Mesh& tm, const Sources& sources)
{
  test_support::Scope scope("radius");
  const std::vector<double> full = distances(tm, sources);
  const std::vector<double> sorted = sorted_finite(full);
  const double largest = sorted.back();
  // includes radii that equal the distance of a vertex, which is then within the radius
  std::vector<double> radii{0., .1 * largest, .37 * largest, .8 * largest, 2. * largest, infinity,
                            sorted[sorted.size() / 3], sorted[sorted.size() / 2], largest};
  for(const double radius : radii)
  {
    Options options;
    options.maximum_distance = radius;
    const std::vector<double> result = distances_with_options(tm, sources, options);
    for(std::size_t i = 0; i < full.size(); ++i)
    {
      if(full[i] <= radius)
      {
        CHECK_EQUAL(result[i], full[i]);
      }
      else
      {
        CHECK_EQUAL(result[i], infinity);
      }
    }
    // The radius does not affect the next run.
    CHECK(distances(tm, sources) == full);
  }
}

void a_radius_saves_work()
{
  test_support::Scope scope("radius saves work");
  const Mesh tm = to_face_graph(icosphere(4));
  SMG::Propagation_statistics all;
  SMG::Propagation_statistics few;
  Options options;
  options.statistics = &all;
  distances_with_options(tm, vertex(0), options);
  options.statistics = &few;
  options.maximum_distance = .3;
  distances_with_options(tm, vertex(0), options);
  CHECK(few.vertices_visited * 10 < all.vertices_visited);
  CHECK(few.windows_propagated * 10 < all.windows_propagated);
}

// ---------------------------------------------------------------------------
// targets
// ---------------------------------------------------------------------------

template <class Sources>
void targets_get_their_exact_distances(const Mesh& tm, const Sources& sources, test_support::Random& random)
{
  test_support::Scope scope("targets");
  const std::vector<double> full = distances(tm, sources);
  for(const std::size_t number : std::vector<std::size_t>{1, 1, 2, 5})
  {
    Options options;
    for(std::size_t i = 0; i < number; ++i)
    {
      options.targets.push_back(random_vertex(tm, random));
    }
    if(number == 5)
    {
      options.targets.push_back(options.targets.front()); // twice
    }
    SMG::Propagation_statistics statistics;
    options.statistics = &statistics;
    const std::vector<double> result = distances_with_options(tm, sources, options);
    for(const vertex_descriptor target : options.targets)
    {
      CHECK_EQUAL(result[std::size_t(target)], full[std::size_t(target)]);
    }
    // every other vertex: exact or left out
    for(std::size_t i = 0; i < full.size(); ++i)
    {
      CHECK(result[i] == full[i] || result[i] == infinity);
    }
    CHECK(distances(tm, sources) == full);
  }
}

void targets_and_radius_work_together(const Mesh& tm, test_support::Random& random)
{
  test_support::Scope scope("targets and radius");
  const vertex_descriptor s = random_vertex(tm, random);
  const std::vector<double> full = distances(tm, s);
  for(std::size_t i = 0; i < 6; ++i)
  {
    Options options;
    options.targets = {random_vertex(tm, random), random_vertex(tm, random)};
    options.maximum_distance = random.uniform(0., 1.2) * sorted_finite(full).back();
    const std::vector<double> result = distances_with_options(tm, s, options);
    for(const vertex_descriptor target : options.targets)
    {
      const double d = full[std::size_t(target)];
      CHECK_EQUAL(result[std::size_t(target)], d <= options.maximum_distance ? d : infinity);
    }
    for(std::size_t v = 0; v < full.size(); ++v)
    {
      CHECK(result[v] == infinity || (result[v] == full[v] && full[v] <= options.maximum_distance));
    }
  }
}

void an_unreachable_target_is_at_infinity()
{
  test_support::Scope scope("unreachable target");
  const Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  Options options;
  options.targets = {vertex(num_vertices(tm) - 1), vertex(num_vertices(tm) - 2), vertex(3)};
  const std::vector<double> full = distances(tm, vertex(0));
  CHECK(distances_with_options(tm, vertex(0), options) == full);
}

void a_near_target_saves_work()
{
  test_support::Scope scope("target saves work");
  const Mesh tm = to_face_graph(icosphere(4));
  SMG::Propagation_statistics all;
  Options options;
  options.statistics = &all;
  const std::vector<double> full = distances_with_options(tm, vertex(0), options);
  std::size_t near = 0;
  for(std::size_t i = 0; i < full.size(); ++i)
  {
    if(full[i] > .2 && full[i] < .25)
    {
      near = i;
    }
  }
  SMG::Propagation_statistics few;
  options.statistics = &few;
  options.targets = {vertex(near)};
  const std::vector<double> result = distances_with_options(tm, vertex(0), options);
  CHECK_EQUAL(result[near], full[near]);
  CHECK(few.vertices_visited * 10 < all.vertices_visited);
}

// ---------------------------------------------------------------------------
// visitor
// ---------------------------------------------------------------------------

struct Recording_visitor : SMG::Geodesic_default_visitor
{
  std::size_t begins = 0;
  std::size_t ends = 0;
  std::size_t calls_of_progress = 0;
  std::size_t announced_vertices = 0;
  std::size_t last_visited = 0;
  double last_distance = 0.;
  bool is_monotone = true;
  bool is_in_order = true;
  std::size_t questions = 0;
  std::size_t questions_until_stop = (std::numeric_limits<std::size_t>::max)();

  void on_propagation_begin(std::size_t number_of_vertices)
  {
    ++begins;
    announced_vertices = number_of_vertices;
  }

  void on_progress(std::size_t vertices_visited, double distance_reached)
  {
    is_in_order = is_in_order && begins == 1 && ends == 0;
    is_monotone = is_monotone && vertices_visited >= last_visited && distance_reached >= last_distance;
    last_visited = vertices_visited;
    last_distance = distance_reached;
    ++calls_of_progress;
  }

  bool go_further() { return ++questions <= questions_until_stop; }

  void on_propagation_end() { ++ends; }
};

void the_visitor_follows_the_progress(const Mesh& tm, test_support::Random& random)
{
  test_support::Scope scope("visitor");
  const vertex_descriptor s = random_vertex(tm, random);
  const std::vector<double> full = distances(tm, s);
  Recording_visitor visitor;
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances(tm, map, s, CGAL::parameters::visitor(std::ref(visitor))));
  CHECK(values_at_vertices(tm, map) == full);
  CHECK_EQUAL(visitor.begins, 1u);
  CHECK_EQUAL(visitor.ends, 1u);
  CHECK_EQUAL(visitor.announced_vertices, static_cast<std::size_t>(tm.number_of_vertices()));
  CHECK(visitor.calls_of_progress > 0);
  CHECK(visitor.questions > 0);
  CHECK(visitor.is_monotone);
  CHECK(visitor.is_in_order);
}

// Has exactly the members that the concept GeodesicPropagationVisitor requires: no base class, no copies.
class Minimal_visitor
{
public:
  explicit Minimal_visitor(int&) {}
  Minimal_visitor(const Minimal_visitor&) = delete;
  Minimal_visitor& operator=(const Minimal_visitor&) = delete;

  void on_propagation_begin(std::size_t) {}
  void on_progress(std::size_t, double) {}
  bool go_further() { return ++number_of_questions > 0; }
  void on_propagation_end() {}

  std::size_t number_of_questions = 0;
};

void a_minimal_visitor_is_enough(const Mesh& tm, test_support::Random& random)
{
  test_support::Scope scope("minimal visitor");
  int something = 0;
  Minimal_visitor visitor(something);
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances(tm, map, random_vertex(tm, random), CGAL::parameters::visitor(std::ref(visitor))));
  const std::size_t asked = visitor.number_of_questions;
  CHECK(asked > 0);
  Geodesic_paths paths(tm);
  paths.add_source_point(random_vertex(tm, random));
  CHECK(paths.build_sequence_tree(visitor));
  CHECK(visitor.number_of_questions > asked);
}

void a_canceled_run_writes_nothing(const Mesh& tm, test_support::Random& random)
{
  test_support::Scope scope("cancel");
  const vertex_descriptor s = random_vertex(tm, random);
  const std::vector<double> full = distances(tm, s);
  Recording_visitor probe;
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances(tm, map, s, CGAL::parameters::visitor(std::ref(probe))));

  for(const std::size_t allowed : {std::size_t(0), std::size_t(1), probe.questions / 2, probe.questions - 1})
  {
    if(allowed >= probe.questions)
    {
      continue;
    }
    Recording_visitor visitor;
    visitor.questions_until_stop = allowed;
    auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
    for(const vertex_descriptor v : vertices(tm))
    {
      put(map, v, -7.);
      put(nearest, v, std::size_t(77));
    }
    const bool is_complete =
      SMG::geodesic_distances(tm, map, s,
                              CGAL::parameters::nearest_source_map(nearest).visitor(std::ref(visitor)));
    CHECK(!is_complete);
    CHECK_EQUAL(visitor.questions, allowed + 1);
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK_EQUAL(get(map, v), -7.);
      CHECK_EQUAL(get(nearest, v), 77u);
    }
  }
  CHECK(distances(tm, s) == full);
}

// ---------------------------------------------------------------------------
// statistics
// ---------------------------------------------------------------------------

void statistics_are_consistent(const Mesh& tm, test_support::Random& random)
{
  test_support::Scope scope("statistics");
  const Face_location s = random_location(tm, random);
  SMG::Propagation_statistics statistics;
  Options options;
  options.statistics = &statistics;
  const std::vector<double> result = distances_with_options(tm, s, options);
  CHECK(result == distances(tm, s));
  CHECK(statistics.windows_created >= statistics.windows_propagated);
  CHECK(statistics.windows_created >= statistics.maximum_windows_alive);
  CHECK(statistics.vertices_visited >= 1);
  CHECK(statistics.intrinsic_mesh_bytes > 0);
  const bool has_windows = statistics.windows_created > 0;
  CHECK((statistics.maximum_windows_alive > 0) == has_windows);
  CHECK((statistics.maximum_window_bytes > 0) >= has_windows);
  SMG::Propagation_statistics again;
  options.statistics = &again;
  distances_with_options(tm, s, options);
  CHECK_EQUAL(statistics.windows_created, again.windows_created);
  CHECK_EQUAL(statistics.windows_propagated, again.windows_propagated);
  CHECK_EQUAL(statistics.windows_removed_by_rule_1, again.windows_removed_by_rule_1);
  CHECK_EQUAL(statistics.windows_removed_by_rules_2_and_3, again.windows_removed_by_rules_2_and_3);
  CHECK_EQUAL(statistics.windows_removed_by_vertices, again.windows_removed_by_vertices);
  // A second run adds its counts. Maxima do not change.
  distances_with_options(tm, s, options);
  CHECK_EQUAL(again.windows_created, 2 * statistics.windows_created);
  CHECK_EQUAL(again.vertices_visited, 2 * statistics.vertices_visited);
  CHECK_EQUAL(again.maximum_windows_alive, statistics.maximum_windows_alive);
  CHECK_EQUAL(again.intrinsic_mesh_bytes, statistics.intrinsic_mesh_bytes);
}

// ---------------------------------------------------------------------------
// offsets and the nearest source
// ---------------------------------------------------------------------------

void a_beaten_source_owns_nothing(const Mesh& tm, test_support::Random& random)
{
  test_support::Scope scope("offsets");
  const std::vector<vertex_descriptor> sources{random_vertex(tm, random), random_vertex(tm, random),
                                               random_vertex(tm, random)};
  std::vector<std::vector<double>> fields;
  for(const vertex_descriptor s : sources)
  {
    fields.push_back(distances(tm, s));
  }
  auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
  auto options = options_with_map<Mesh>(nearest);
  // If the wave of the first source reaches the middle source, it does so before the middle source starts.
  const double way = fields[0][std::size_t(sources[1])];
  const double delay = way == infinity ? 0. : 1.5 * way + 1e-3;
  options.source_offsets = {0., delay, .25};
  const std::vector<double> result = distances_with_options(tm, sources, options);
  std::size_t i = 0;
  for(const vertex_descriptor v : vertices(tm))
  {
    const double expected =
      (std::min)({fields[0][i], fields[1][i] + delay, fields[2][i] + .25});
    CHECK_CLOSE(result[i], expected, tolerance);
    if(way != infinity)
    {
      CHECK(get(nearest, v) != 1u);
    }
    if(expected == infinity)
    {
      CHECK_EQUAL(get(nearest, v), no_source);
    }
    ++i;
  }
  // The same offset of all sources is added to all distances.
  Options constant;
  constant.source_offsets = {2., 2., 2.};
  const std::vector<double> shifted = distances_with_options(tm, sources, constant);
  const std::vector<double> plain = distances(tm, sources);
  for(std::size_t j = 0; j < plain.size(); ++j)
  {
    CHECK_CLOSE(shifted[j], plain[j] + 2., tolerance);
  }
  // Offsets of zero change nothing.
  Options zero;
  zero.source_offsets = {0., 0., 0.};
  CHECK(distances_with_options(tm, sources, zero) == plain);
  // The radius applies to distances that include the offset.
  Options bounded;
  bounded.source_offsets = {2., 2., 2.};
  bounded.maximum_distance = 2. + .5 * sorted_finite(plain).back();
  const std::vector<double> inside = distances_with_options(tm, sources, bounded);
  for(std::size_t j = 0; j < plain.size(); ++j)
  {
    CHECK_EQUAL(inside[j], shifted[j] <= bounded.maximum_distance ? shifted[j] : infinity);
  }
}

void a_source_inside_a_face_may_be_beaten()
{
  test_support::Scope scope("offset of a source in a face");
  const Mesh tm = to_face_graph(flat_patch(3, 3, 0., false, 1));
  const std::vector<Face_location> sources{Face_location(face(4), {.2, .3, .5}), Face_location(face(4), {.5, .3, .2}),
                                           Face_location(face(9), {.1, .1, .8})};
  auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
  auto options = options_with_map<Mesh>(nearest);
  options.source_offsets = {0., 5., 0.};
  const std::vector<double> result = distances_with_options(tm, sources, options);
  std::set<std::size_t> owners;
  for(const vertex_descriptor v : vertices(tm))
  {
    owners.insert(get(nearest, v));
    const double expected = (std::min)(length(coordinates(v, tm) - coordinates(sources[0], tm)),
                                       length(coordinates(v, tm) - coordinates(sources[2], tm)));
    CHECK_CLOSE(result[std::size_t(v)], expected, tolerance);
  }
  CHECK(owners == (std::set<std::size_t>{0, 2}));
}

// ---------------------------------------------------------------------------
// edge lengths
// ---------------------------------------------------------------------------

void options_work_with_edge_lengths_too()
{
  test_support::Scope scope("options with edge lengths");
  Mesh tm = to_face_graph(icosphere(2));
  const auto lengths = add_edge_lengths(tm);
  const std::vector<vertex_descriptor> sources{vertex(0), vertex(5)};
  auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
  auto options = options_with_map<Mesh>(nearest);
  options.maximum_distance = 1.;
  options.source_offsets = {0., .2};
  const std::vector<double> expected = distances_with_options(tm, sources, options);
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances_from_edge_lengths(tm, lengths, map, sources, parameters_of(options)));
  CHECK_FIELDS_CLOSE(values_at_vertices(tm, map), expected, tolerance);
  Recording_visitor visitor;
  visitor.questions_until_stop = 0;
  CHECK(!SMG::geodesic_distances_from_edge_lengths(tm, lengths, map, sources,
                                                   parameters_of(options).visitor(std::ref(visitor))));
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
    distances_up_to_the_radius_are_exact(tm, random_vertex(tm, random));
    distances_up_to_the_radius_are_exact(
      tm, std::vector<Face_location>{random_location(tm, random), random_location(tm, random)});
    targets_get_their_exact_distances(tm, random_vertex(tm, random), random);
    targets_get_their_exact_distances(
      tm, std::vector<Face_location>{random_location(tm, random), random_location(tm, random)}, random);
    targets_and_radius_work_together(tm, random);
    the_visitor_follows_the_progress(tm, random);
    a_minimal_visitor_is_enough(tm, random);
    a_canceled_run_writes_nothing(tm, random);
    statistics_are_consistent(tm, random);
    a_beaten_source_owns_nothing(tm, random);
  }
  a_radius_saves_work();
  a_near_target_saves_work();
  an_unreachable_target_is_at_infinity();
  a_source_inside_a_face_may_be_beaten();
  options_work_with_edge_lengths_too();
  return test_result();
}
