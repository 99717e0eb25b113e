// Distances by several threads from one set of sources. Their bits depend neither on the number of threads nor on
// timing.

#include "distance_test_helpers.h"
#include "expected_exceptions.h"
#include "impatient_visitor.h"
#include "intrinsic_mesh_helpers.h"
#include "several_threads.h"
#include "test_meshes.h"
#include "test_support.h"
#include "thread_team.h"
#include "with_threads.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Parallel_distance_propagation.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

using namespace test_meshes;

namespace {

using Options = Distance_options<Mesh>;

template <class Tag, class Sources>
std::vector<double> tagged_distances(const Mesh& tm, const Sources& sources, const Options& options = Options())
{
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances<Tag>(tm, map, sources, parameters_of(options)));
  return values_at_vertices(tm, map);
}

// The tag that needs no library.
void the_available_tag_gives_the_same_distances(std::uint64_t seed)
{
  test_support::Scope scope("parallel if available");
  const Mesh tm = to_face_graph(noisy_sphere(3, .1, seed));
  const std::vector<double> expected = distances(tm, vertex(3));
  CHECK_FIELDS_CLOSE(tagged_distances<CGAL::Parallel_if_available_tag>(tm, vertex(3)), expected, 1e-13);
  SMG::Geodesic_distance_solver<Mesh, CGAL::Parallel_if_available_tag> solver(tm);
  solver.compute_distances(vertex(3));
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_CLOSE(solver.distance(v), expected[std::size_t(v)], 1e-13);
  }
}

namespace internal = SMG::internal;
using Intrinsic_mesh = internal::Intrinsic_mesh<double>;
using Field = internal::Vertex_distance_field<double>;
using Parallel_propagation =
  internal::Parallel_distance_propagation<double, internal::All_pruning_rules, Thread_team>;
using Vertices = std::vector<internal::Vertex_id>;

const std::vector<std::size_t> sizes_of_batches{1, 7, 64, 1000};
const std::vector<std::size_t> numbers_of_threads{1, 2, 5};

// The input of a run.
struct Task
{
  Vertices sources;
  std::vector<double> offsets;
  double maximum_distance = infinity;
  Vertices targets;
};

// The final distances.
template <class Propagation>
std::vector<double> run(Propagation& propagation, const Field& field, const Task& task)
{
  propagation.restart();
  for(std::size_t i = 0; i < task.sources.size(); ++i)
  {
    propagation.add_source(task.sources[i], task.offsets.empty() ? 0. : task.offsets[i]);
  }
  propagation.set_maximum_distance(task.maximum_distance);
  if(!task.targets.empty())
  {
    propagation.set_targets(task.targets.data(), task.targets.data() + task.targets.size());
  }
  CHECK(propagation.run([](std::size_t, double) { return true; }));
  const double limit = (std::min)(propagation.reached_distance(), task.maximum_distance);
  std::vector<double> result = field.distance;
  for(double& d : result)
  {
    d = d <= limit ? d : infinity;
  }
  return result;
}

// Checks that distances are `close` to the expected ones, where both are final.
void check_close(const std::vector<double>& found, const std::vector<double>& expected, const Task& task)
{
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    if(task.targets.empty() || (found[i] < infinity && expected[i] < infinity))
    {
      CHECK_CLOSE(found[i], expected[i], 1e-13);
    }
  }
  for(const internal::Vertex_id t : task.targets)
  {
    CHECK_CLOSE(found[t], expected[t], 1e-13);
  }
}

void check_task(const Intrinsic_mesh& mesh, const Task& task)
{
  Field field;
  internal::Distance_propagation<double> sequential(mesh, field);
  const std::vector<double> expected = run(sequential, field, task);
  for(const std::size_t batch_size : sizes_of_batches)
  {
    test_support::Scope scope("batches of " + std::to_string(batch_size));
    std::vector<double> first;
    SMG::Propagation_statistics first_statistics;
    for(const std::size_t number_of_threads : numbers_of_threads)
    {
      Field parallel_field;
      Parallel_propagation parallel(mesh, parallel_field, batch_size, Thread_team(number_of_threads));
      const std::vector<double> found = run(parallel, parallel_field, task);
      const SMG::Propagation_statistics statistics = parallel.statistics();
      if(first.empty())
      {
        first = found;
        first_statistics = statistics;
      }
      CHECK(found == first);
      if(task.targets.empty() && task.maximum_distance == infinity) // else superfluous visits may be counted
      {
        CHECK_EQUAL(statistics.windows_propagated, first_statistics.windows_propagated);
        CHECK_EQUAL(statistics.vertices_visited, first_statistics.vertices_visited);
      }
      CHECK(run(parallel, parallel_field, task) == first); // again
    }
    check_close(first, expected, task);
  }
}

void threads_do_not_change_the_distances(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  const Intrinsic_mesh mesh = intrinsic_mesh(tm);
  const auto random_id = [&]() { return static_cast<internal::Vertex_id>(random.index(mesh.number_of_vertices())); };
  Task task;
  task.sources = {random_id()};
  check_task(mesh, task);
  task.maximum_distance = random.uniform(.1, .7);
  check_task(mesh, task);
  task.maximum_distance = infinity;
  task.targets = {random_id(), random_id()};
  check_task(mesh, task);
  task.targets.clear();
  task.sources = {random_id(), random_id(), random_id(), random_id()};
  task.offsets = {0., .05, .2, 1e-3};
  check_task(mesh, task);
  task.sources.clear();
  task.offsets.clear();
  check_task(mesh, task);
}

// All vertices are sources, so all keys are the same at first. They do not wait for each other one after the other.
void ties_take_few_batches(std::uint64_t seed)
{
  test_support::Scope scope("ties");
  const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(noisy_sphere(5, .1, seed)));
  Field field;
  Parallel_propagation propagation(mesh, field, Parallel_propagation::default_batch_size, Thread_team(1));
  for(internal::Vertex_id v = 0; v < mesh.number_of_vertices(); ++v)
  {
    propagation.add_source(v, 0.);
  }
  std::size_t batches = 0; // it asks before each one whether to go on
  CHECK(propagation.run([&](std::size_t, double) { return ++batches > 0; }));
  CHECK(batches < 100);
}

// The edges of this mesh differ by many orders of magnitude. A batch does not reach far beyond the short ones, where
// vertices would be visited long before their turn.
void long_and_short_edges_make_few_superfluous_windows(std::uint64_t seed)
{
  test_support::Scope scope("long and short edges");
  const Indexed_mesh sphere = noisy_sphere(5, .1, seed);
  const Indexed_mesh graded = transformed(sphere, "graded",
                                          [](const Coordinates& p)
                                          {
                                            const double f = std::exp(12. * p[0]);
                                            return Coordinates{f * p[0], f * p[1], f * p[2]};
                                          });
  const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(graded));
  Field field, expected;
  internal::Distance_propagation<double> sequential(mesh, expected);
  Parallel_propagation propagation(mesh, field, Parallel_propagation::default_batch_size, Thread_team(1));
  std::size_t windows = 0, windows_of_sequential = 0;
  for(const internal::Vertex_id source : {0u, 1000u, 5000u})
  {
    Task task;
    task.sources = {source};
    check_close(run(propagation, field, task), run(sequential, expected, task), task);
    windows += propagation.statistics().windows_propagated;
    windows_of_sequential += sequential.statistics().windows_propagated;
  }
  CHECK(static_cast<double>(windows) < 1.15 * static_cast<double>(windows_of_sequential));
}

// A run that is canceled or ends by an exception does not influence the next one.
void broken_off_runs_leave_no_trace(std::uint64_t seed)
{
  test_support::Scope scope("broken off");
  const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(noisy_sphere(3, .1, seed)));
  Task task;
  task.sources = {5};
  for(const std::size_t number_of_threads : numbers_of_threads)
  {
    Field field;
    Parallel_propagation propagation(mesh, field, 64, Thread_team(number_of_threads));
    const std::vector<double> expected = run(propagation, field, task);
    for(const std::size_t last : {std::size_t(0), std::size_t(3), std::size_t(20)})
    {
      propagation.restart();
      propagation.add_source(17, 0.);
      std::size_t calls = 0;
      double reached = 0;
      CHECK(!propagation.run(
        [&](std::size_t, double d)
        {
          CHECK(d >= reached);
          reached = d;
          return ++calls <= last;
        }));
      CHECK_EQUAL(calls, last + 1);
      CHECK(run(propagation, field, task) == expected);

      bool is_caught = false;
      propagation.restart();
      propagation.add_source(17, 0.);
      try
      {
        propagation.run(
          [&](std::size_t, double) -> bool
          {
            if(calls-- == 0)
            {
              throw std::range_error("thrown by the visitor");
            }
            return true;
          });
      }
      catch(const std::range_error&)
      {
        is_caught = true;
      }
      CHECK(is_caught);
      CHECK(run(propagation, field, task) == expected);
    }
  }
}

// More threads than any machine here has, and a number that changes from run to run.
void more_threads_than_processors_change_no_distance(std::uint64_t seed)
{
  test_support::Scope scope("many threads");
  const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(rough_terrain(24, 1., seed)));
  Task task;
  task.sources = {1, 100};
  Field expected_field;
  Parallel_propagation alone(mesh, expected_field, 8, Thread_team(1));
  const std::vector<double> expected = run(alone, expected_field, task);
  for(const std::size_t number_of_threads : std::vector<std::size_t>{3, 64})
  {
    Field field;
    Parallel_propagation propagation(mesh, field, 8, Thread_team(number_of_threads));
    for(std::size_t i = 0; i < 3; ++i)
      CHECK(run(propagation, field, task) == expected);
  }
}

// Blocks of memory migrate between threads. This must not make each run allocate new ones.
void memory_does_not_grow_from_run_to_run()
{
  test_support::Scope scope("memory of many runs");
  const Intrinsic_mesh mesh = intrinsic_mesh(to_face_graph(rough_terrain(60, .5, 1)));
  Task task;
  task.sources = {0};
  Field field;
  Parallel_propagation propagation(mesh, field, Parallel_propagation::default_batch_size, Thread_team(5));
  const std::vector<double> expected = run(propagation, field, task);
  const std::size_t first = propagation.statistics().maximum_window_bytes;
  std::size_t greatest = 0;
  for(std::size_t k = 0; k < 300; ++k)
  {
    CHECK(run(propagation, field, task) == expected);
    greatest = (std::max)(greatest, propagation.statistics().maximum_window_bytes);
  }
  std::cout << "memory of windows in the first run: " << first << ", in 300 more: " << greatest << std::endl;
  CHECK(greatest < 10 * first + (std::size_t(1) << 20));
}

// With the parallel tag, one thread computes on a small mesh, as with the sequential tag. A source in a face adds
// faces, and may make the mesh large enough for several threads.
void small_meshes_are_left_to_one_thread(std::uint64_t seed)
{
  test_support::Scope scope("small meshes");
  const Mesh tm = to_face_graph(flat_patch(90, 91, .2, true, seed));
  using Choice = internal::Propagation_by_size<double, internal::All_pruning_rules, internal::Calling_thread>;
  const std::size_t smallest = Choice::smallest_shared_mesh;
  CHECK(num_faces(tm) < smallest && num_faces(tm) + 6 >= smallest);
  const auto location = [&](Mesh::size_type f) { return Face_location(face_descriptor(f), {.2, .3, .5}); };
  const std::vector<Face_location> three{location(10), location(5000), location(12000)};
  const std::vector<double> from_vertex = distances(tm, vertex(3)), from_faces = distances(tm, three);
  SMG::Geodesic_distance_solver<Mesh, test_support::Propagation_of_size> solver(tm);
  SMG::Geodesic_distance_solver<Mesh> sequential_solver(tm);
  const auto visits = [](auto& s, const auto& sources)
  {
    SMG::Propagation_statistics statistics;
    CHECK(s.compute_distances(sources, CGAL::parameters::statistics(&statistics)));
    return statistics.vertices_visited;
  };
  for(std::size_t i = 0; i < 2; ++i)
  {
    CHECK_EQUAL(visits(solver, vertex(3)), visits(sequential_solver, vertex(3)));
    for(const vertex_descriptor v : vertices(tm))
      CHECK_EQUAL(solver.distance(v), from_vertex[std::size_t(v)]);
    CHECK(visits(solver, three) != visits(sequential_solver, three)); // in batches
    for(const vertex_descriptor v : vertices(tm))
      CHECK_CLOSE(solver.distance(v), from_faces[std::size_t(v)], 1e-13);
  }
}

#ifdef CGAL_LINKED_WITH_TBB

// The public functions with TBB, with sources in faces and nearest sources.
template <class Tag>
void public_functions_agree_with_sequential_ones(std::uint64_t seed, test_support::Random& random)
{
  test_support::Scope scope("public functions");
  const Mesh tm = to_face_graph(rough_terrain(16, 1.5, seed));
  const std::vector<Face_location> sources{random_location(tm, random), random_location(tm, random)};
  const std::vector<double> expected = distances(tm, sources);
  std::vector<double> first;
  for(const std::size_t number_of_threads : numbers_of_threads)
  {
    with_threads(number_of_threads,
                 [&]()
                 {
                   const std::vector<double> found = tagged_distances<Tag>(tm, sources);
                   first = first.empty() ? found : first;
                   CHECK(found == first);
                   SMG::Geodesic_distance_solver<Mesh, Tag> solver(tm);
                   for(std::size_t i = 0; i < 3; ++i)
                   {
                     CHECK(solver.compute_distance(vertex(1), vertex(30)) > 0);
                     solver.compute_distances(sources);
                     for(const vertex_descriptor v : vertices(tm))
                     {
                       CHECK_EQUAL(solver.distance(v), first[std::size_t(v)]);
                       CHECK(solver.nearest_source(v) < 2);
                     }
                   }
                 });
  }
  CHECK_FIELDS_CLOSE(first, expected, 1e-13);
}

// With a radius or targets, several threads find the distances that one finds.
template <class Tag>
void limits_hold_with_threads(std::uint64_t seed)
{
  test_support::Scope scope("limits");
  const Mesh tm = to_face_graph(noisy_sphere(4, .1, seed));
  Options within_radius, to_targets;
  within_radius.maximum_distance = 1.;
  to_targets.targets = {vertex(7), vertex(40)};
  const std::vector<double> expected = distances(tm, vertex(3));
  const std::vector<double> expected_within = tagged_distances<CGAL::Sequential_tag>(tm, vertex(3), within_radius);
  for(const std::size_t number_of_threads : numbers_of_threads)
  {
    with_threads(number_of_threads, [&]
    {
      CHECK_FIELDS_CLOSE(tagged_distances<Tag>(tm, vertex(3), within_radius), expected_within, 1e-13);
      const std::vector<double> found = tagged_distances<Tag>(tm, vertex(3), to_targets);
      SMG::Geodesic_distance_solver<Mesh, Tag> solver(tm);
      solver.compute_distances(vertex(3), parameters_of(within_radius));
      std::vector<double> within;
      for(const vertex_descriptor v : vertices(tm))
      {
        within.push_back(solver.distance(v));
      }
      CHECK_FIELDS_CLOSE(within, expected_within, 1e-13);
      for(const vertex_descriptor v : to_targets.targets)
      {
        CHECK_CLOSE(found[std::size_t(v)], expected[std::size_t(v)], 1e-13);
      }
    });
  }
}

// A run that a visitor ends leaves objects that can be used again.
template <class Tag>
void visitors_end_runs_with_threads(std::uint64_t seed)
{
  test_support::Scope scope("visitors");
  const Mesh tm = to_face_graph(noisy_sphere(4, .1, seed));
  const std::vector<double> expected = distances(tm, vertex(3));
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  for(const std::size_t number_of_threads : numbers_of_threads)
  {
    with_threads(number_of_threads, [&]
    {
      SMG::Geodesic_distance_solver<Mesh, Tag> solver(tm);
      for(const std::size_t steps : {std::size_t(0), std::size_t(1), std::size_t(20)})
      {
        Impatient_visitor visitor;
        visitor.steps_left = steps;
        const auto np = CGAL::parameters::visitor(std::ref(visitor));
        CHECK(!SMG::geodesic_distances<Tag>(tm, map, vertex(3), np));
        visitor.steps_left = steps;
        CHECK(!solver.compute_distances(vertex(3), np));
        visitor.throws = true;
        visitor.steps_left = steps;
        CHECK(throws<std::range_error>(
          [&] { SMG::geodesic_distances<Tag>(tm, map, vertex(3), np); }));
        visitor.steps_left = steps;
        CHECK(throws<std::range_error>([&] { solver.compute_distances(vertex(3), np); }));
        CHECK(solver.compute_distances(vertex(3)));
        for(const vertex_descriptor v : vertices(tm))
        {
          CHECK_CLOSE(solver.distance(v), expected[std::size_t(v)], 1e-13);
        }
      }
    });
  }
}

#endif // CGAL_LINKED_WITH_TBB

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260503);
  test_support::Random random(seed);
  the_available_tag_gives_the_same_distances(seed);
  for(const Indexed_mesh& indexed :
      {noisy_sphere(3, .1, seed), rough_terrain(16, 2., seed), wavy_tube(20, 24), genus_3_polycube(),
       midpoint_subdivision(genus_2_polycube(), 2), tetrahedral_ogre(60, seed), spiral_corridor(),
       random_cuts(noisy_sphere(2, .1, seed + 2), .15, seed + 3), two_components_and_an_isolated_vertex(),
       irregular_tetrahedron(), needle_sphere(12, 16), fan("flat saddle", 600, 1e-3, 0.), bipyramid(500, .01)})
  {
    threads_do_not_change_the_distances(indexed, random);
  }
  ties_take_few_batches(seed);
  long_and_short_edges_make_few_superfluous_windows(seed);
  broken_off_runs_leave_no_trace(seed);
  more_threads_than_processors_change_no_distance(seed);
  memory_does_not_grow_from_run_to_run();
  small_meshes_are_left_to_one_thread(seed);
#ifdef CGAL_LINKED_WITH_TBB
  public_functions_agree_with_sequential_ones<CGAL::Parallel_tag>(seed, random);
  public_functions_agree_with_sequential_ones<test_support::Several_threads>(seed, random);
  limits_hold_with_threads<CGAL::Parallel_tag>(seed);
  limits_hold_with_threads<test_support::Several_threads>(seed);
  visitors_end_runs_with_threads<CGAL::Parallel_tag>(seed);
  visitors_end_runs_with_threads<test_support::Several_threads>(seed);
#else
  std::cout << "TBB is not there: the public functions are not parallel" << std::endl;
#endif
  return test_result();
}
