// Matrices of distances: for any number of threads, rows are bitwise equal to single runs and come in order.

#include "distance_test_helpers.h"
#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"
#include "thread_team.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/rows/Ordered_rows.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

using Rows = std::vector<std::vector<double>>;
using Sparse_row = std::vector<std::pair<std::size_t, double>>;
using Solver = SMG::Geodesic_distance_solver<Mesh>;

// Calls test(tag) with all tags, and in parallel with several numbers of threads.
template <class Test>
void with_all_tags(const Test& test)
{
  {
    test_support::Scope scope("sequential");
    test(CGAL::Sequential_tag());
  }
  {
    test_support::Scope scope("parallel if available");
    test(CGAL::Parallel_if_available_tag());
  }
#ifdef CGAL_LINKED_WITH_TBB
  for(const int number_of_threads : {1, 2, 5})
  {
    test_support::Scope scope(std::to_string(number_of_threads) + " threads");
    tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                static_cast<std::size_t>(number_of_threads));
    tbb::task_arena arena(number_of_threads);
    arena.execute([&]() { test(CGAL::Parallel_tag()); });
  }
#endif
}

// Collects rows, and checks that they come in order and never two at a time.
struct Row_collector
{
  template <class Row>
  void take(std::size_t i, const Row& row)
  {
    CHECK(!is_busy.exchange(true));
    CHECK_EQUAL(i, count);
    ++count;
    rows.emplace_back();
    put(row, rows.back());
    is_busy = false;
  }

  static void put(const std::vector<double>& row, std::vector<double>& to) { to = row; }
  static void put(const Sparse_row& row, std::vector<double>& to)
  {
    for(const auto& entry : row)
    {
      to.push_back(static_cast<double>(entry.first));
      to.push_back(entry.second);
    }
  }

  Rows rows;
  std::size_t count = 0;
  std::atomic<bool> is_busy{false};
};

template <class Sources>
Rows expected_rows(const Mesh& tm, const Sources& sources, const std::vector<vertex_descriptor>& targets)
{
  Rows rows;
  for(const auto& source : sources)
  {
    const std::vector<double> all = distances(tm, source);
    rows.emplace_back();
    for(const vertex_descriptor t : targets)
    {
      rows.back().push_back(all[std::size_t(t)]);
    }
  }
  return rows;
}

template <class Sources>
void check_dense_matrix(const Mesh& tm, const Solver& solver, const Sources& sources,
                        const std::vector<vertex_descriptor>& targets, const Rows& expected)
{
  with_all_tags(
    [&](auto tag)
    {
      using Tag = decltype(tag);
      Row_collector collector;
      CHECK(SMG::geodesic_distance_matrix<Tag>(tm, sources, targets, [&](std::size_t i, const std::vector<double>& row)
                                               { collector.take(i, row); }));
      CHECK(collector.rows == expected);
      Row_collector from_solver;
      CHECK(SMG::geodesic_distance_matrix<Tag>(solver, sources, targets, [&](std::size_t i, const auto& row)
                                               {
                                                 from_solver.take(i, row);
                                                 return true;
                                               }));
      CHECK(from_solver.rows == expected);
    });

  for(const std::size_t number_of_threads : {1u, 3u})
  {
    const auto& surface = SMG::internal::Private_access::surface(solver);
    const SMG::internal::Distance_matrix<double> matrix(surface.mesh(), surface.source_set(sources),
                                                       surface.copies());
    Row_collector collector;
    auto output = [&](std::size_t i, const std::vector<double>& row) { collector.take(i, row); };
    CHECK(matrix.put_dense_rows(Thread_team(number_of_threads), surface.checked_ids(targets, "target"),
                                output));
    CHECK(collector.rows == expected);
  }
}

// Returns the rows of a sparse matrix: the entries of a dense matrix within a radius, with their positions.
Rows entries_within(const Rows& rows, double radius)
{
  Rows entries;
  for(const std::vector<double>& row : rows)
  {
    entries.emplace_back();
    for(std::size_t j = 0; j < row.size(); ++j)
    {
      if(row[j] <= radius && row[j] < infinity)
      {
        entries.back().push_back(static_cast<double>(j));
        entries.back().push_back(row[j]);
      }
    }
  }
  return entries;
}

template <class Sources>
void check_sparse_matrix(const Mesh& tm, const Solver& solver, const Sources& sources,
                         const std::vector<vertex_descriptor>& targets, const Rows& expected)
{
  for(const double radius : {0., .5, 1.5, infinity})
  {
    const Rows expected_entries = entries_within(expected, radius);
    with_all_tags(
      [&](auto tag)
      {
        using Tag = decltype(tag);
        Row_collector collector;
        CHECK(SMG::sparse_geodesic_distance_matrix<Tag>(tm, sources, targets, radius,
                                                        [&](std::size_t i, const Sparse_row& row)
                                                        { collector.take(i, row); }));
        CHECK(collector.rows == expected_entries);
        Row_collector from_solver;
        CHECK(SMG::sparse_geodesic_distance_matrix<Tag>(solver, sources, targets, radius,
                                                        [&](std::size_t i, const Sparse_row& row)
                                                        { from_solver.take(i, row); }));
        CHECK(from_solver.rows == expected_entries);
      });
  }
}

template <class Sources>
void check_matrix(const Mesh& tm, const Sources& sources, const std::vector<vertex_descriptor>& targets)
{
  const Rows expected = expected_rows(tm, sources, targets);
  const Solver solver(tm);
  check_dense_matrix(tm, solver, sources, targets, expected);
  check_sparse_matrix(tm, solver, sources, targets, expected);
}

void check_symmetric_matrix(const Mesh& tm, const std::vector<vertex_descriptor>& range)
{
  Rows expected = expected_rows(tm, range, range);
  for(std::size_t i = 0; i < expected.size(); ++i)
  {
    expected[i].erase(expected[i].begin(), expected[i].begin() + static_cast<std::ptrdiff_t>(i));
  }
  const Solver solver(tm);
  with_all_tags(
    [&](auto tag)
    {
      using Tag = decltype(tag);
      Row_collector collector;
      CHECK(SMG::symmetric_geodesic_distance_matrix<Tag>(tm, range, [&](std::size_t i, const auto& row)
                                                         { collector.take(i, row); }));
      CHECK(collector.rows == expected);
      Row_collector from_solver;
      CHECK(SMG::symmetric_geodesic_distance_matrix<Tag>(solver, range, [&](std::size_t i, const auto& row)
                                                         { from_solver.take(i, row); }));
      CHECK(from_solver.rows == expected);
    });
}

void rows_are_those_of_single_runs(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  std::vector<vertex_descriptor> sources, targets;
  std::vector<Face_location> locations;
  for(std::size_t i = 0; i < 12; ++i)
  {
    sources.push_back(random_vertex(tm, random));
    targets.push_back(random_vertex(tm, random));
    locations.push_back(random_location(tm, random));
  }
  targets.push_back(targets[3]); // twice
  sources.push_back(sources[5]);
  check_matrix(tm, sources, targets);
  check_matrix(tm, locations, targets);
  check_matrix(tm, sources, std::vector<vertex_descriptor>(vertices(tm).begin(), vertices(tm).end()));
  check_matrix(tm, std::vector<vertex_descriptor>(), targets);
  check_matrix(tm, sources, std::vector<vertex_descriptor>());
  check_symmetric_matrix(tm, sources);
  check_symmetric_matrix(tm, {});
}

std::vector<vertex_descriptor> vertices_of(const Mesh& tm)
{
  return {vertices(tm).begin(), vertices(tm).end()};
}

// Rows of a triangle that are pruned with landmarks have the bits of single runs, in any order of the vertices.
void pruned_rows_are_those_of_single_runs(const Mesh& tm, const std::vector<vertex_descriptor>& range)
{
  const Solver solver(tm);
  const auto& surface = SMG::internal::Private_access::surface(solver);
  const SMG::internal::Distance_matrix<double> matrix(surface.mesh(), surface.source_set_of_vertices(range, "source"),
                                                     surface.copies());
  for(const std::size_t number_of_threads : {1u, 3u})
  {
    Row_collector collector;
    auto output = [&](std::size_t i, const std::vector<double>& row) { collector.take(i, row); };
    CHECK(matrix.put_triangular_rows(Thread_team(number_of_threads), output, 0));
    for(std::size_t i = 0; i < range.size(); ++i)
    {
      const std::vector<double> all = distances(tm, range[i]);
      for(std::size_t k = i; k < range.size(); ++k)
      {
        CHECK_EQUAL(collector.rows[i][k - i], all[std::size_t(range[k])]);
      }
    }
  }
}

void rows_are_pruned(const Indexed_mesh& indexed, std::mt19937& random)
{
  test_support::Scope scope("pruned rows of " + indexed.name);
  const Mesh tm = to_face_graph(indexed);
  std::vector<vertex_descriptor> range = SMG::geodesic_peeling_order(tm, vertices(tm));
  pruned_rows_are_those_of_single_runs(tm, range);
  range.resize(range.size() / 3); // the part that is left is not a ball
  range.push_back(range.front()); // twice
  pruned_rows_are_those_of_single_runs(tm, range);
  std::shuffle(range.begin(), range.end(), random);
  pruned_rows_are_those_of_single_runs(tm, range);
}

// In the order of peeling, the bounds leave out much of what the distances to the targets alone need.
void pruning_saves_visits()
{
  test_support::Scope scope("visits");
  const Mesh tm = to_face_graph(icosphere(4));
  const Solver solver(tm);
  const auto& surface = SMG::internal::Private_access::surface(solver);
  using Matrix = SMG::internal::Distance_matrix<double>;
  const Matrix matrix(surface.mesh(), surface.source_set_of_vertices(
                                        SMG::geodesic_peeling_order(solver, vertices(tm)), "source"),
                      surface.copies());
  std::unique_ptr<const Matrix::Landmarks> landmarks;
  std::size_t visits = 0;
  const auto count = [&]()
  {
    ++visits;
    return true;
  };
  CHECK(matrix.find_landmarks(landmarks, count, 0));
  const auto worker = matrix.make_worker();
  const auto visits_of_rows = [&](const Matrix::Landmarks* used)
  {
    std::size_t sum = 0;
    std::vector<double> row;
    for(std::size_t i = 0; i < num_vertices(tm); i += 100)
    {
      visits = 0;
      matrix.fill_triangular_row(*worker, i, i, used, row, count);
      sum += visits;
    }
    return sum;
  };
  const std::size_t without = visits_of_rows(nullptr), with = visits_of_rows(landmarks.get());
  CHECK(with < without - without / 10);
}

// Cancels after some visits.
struct Canceling_visitor : SMG::Geodesic_default_visitor
{
  explicit Canceling_visitor(std::size_t number) : most(number) {}
  void on_progress(std::size_t number, double) { visits = number; }
  bool go_further() const { return visits < most; }

  std::size_t most, visits = 0;
};

// A visitor sees the visits of all three runs, and ends any of them.
void peeling_can_be_canceled()
{
  test_support::Scope scope("order of peeling, canceled");
  const Mesh tm = to_face_graph(icosphere(3));
  Canceling_visitor all((std::numeric_limits<std::size_t>::max)());
  CHECK(SMG::geodesic_peeling_order(tm, vertices(tm), CGAL::parameters::visitor(std::ref(all)))
        == SMG::geodesic_peeling_order(tm, vertices(tm)));
  CHECK(all.visits >= 3 * num_vertices(tm));
  for(const std::size_t most : {std::size_t(1), all.visits / 2, all.visits - 1})
  {
    Canceling_visitor some(most);
    CHECK(SMG::geodesic_peeling_order(tm, vertices(tm), CGAL::parameters::visitor(std::ref(some))).empty());
    CHECK_EQUAL(some.visits, most);
  }
}

// Components stay together, and in each of them distances from an end descend.
void peeling_orders_components_by_distance()
{
  test_support::Scope scope("order of peeling");
  const Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  const std::vector<vertex_descriptor> order = SMG::geodesic_peeling_order(tm, vertices(tm));
  std::vector<vertex_descriptor> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  CHECK(sorted == vertices_of(tm));
  for(std::size_t begin = 0; begin < order.size();)
  {
    const std::vector<double> from_first = distances(tm, order[begin]);
    std::size_t end = begin;
    while(end < order.size() && from_first[std::size_t(order[end])] < infinity)
    {
      ++end;
    }
    CHECK_EQUAL(static_cast<std::size_t>(std::count_if(from_first.begin(), from_first.end(),
                                                       [](double d) { return d < infinity; })), end - begin);
    const std::vector<double> from_last = distances(tm, order[end - 1]);
    for(std::size_t i = begin; i + 1 < end; ++i)
    {
      CHECK(from_last[std::size_t(order[i])] >= from_last[std::size_t(order[i + 1])]);
    }
    begin = end;
  }
  CHECK(SMG::geodesic_peeling_order(tm, std::vector<vertex_descriptor>()).empty());
  CHECK(throws<Invalid_input>([&] { SMG::geodesic_peeling_order(tm, std::vector<vertex_descriptor>{vertex(9999)}); }));
}

// If the output of a row returns false or throws, the computation ends without another row.
void rows_may_end_early()
{
  test_support::Scope scope("early end");
  const Mesh tm = to_face_graph(icosphere(3));
  const std::vector<vertex_descriptor> all(vertices(tm).begin(), vertices(tm).end());
  with_all_tags(
    [&](auto tag)
    {
      using Tag = decltype(tag);
      for(const std::size_t last : {std::size_t(0), std::size_t(1), std::size_t(17)})
      {
        std::size_t count = 0;
        CHECK(!SMG::geodesic_distance_matrix<Tag>(tm, all, all, [&](std::size_t i, const std::vector<double>&)
                                                  {
                                                    ++count;
                                                    return i < last;
                                                  }));
        CHECK_EQUAL(count, last + 1);

        count = 0;
        const auto output = [&](std::size_t i, const std::vector<double>&)
        {
          ++count;
          if(i == last)
          {
            throw std::out_of_range("thrown by the output");
          }
        };
        CHECK(throws<std::out_of_range>([&] { SMG::symmetric_geodesic_distance_matrix<Tag>(tm, all, output); }));
        CHECK_EQUAL(count, last + 1);
      }
    });
}

// An output that ends the computation when all threads together have asked it so often.
struct Ending_output
{
  bool go_further() { return ++number_of_questions <= most; }

  template <class Row>
  void operator()(std::size_t, const Row& row)
  {
    ++number_of_rows;
    for(const auto& element : row)
      CHECK(is_finite(element));
  }

  static bool is_finite(double d) { return std::isfinite(d); }
  static bool is_finite(const std::pair<std::size_t, double>& element) { return std::isfinite(element.second); }

  std::atomic<std::size_t>& number_of_questions;
  std::size_t most;
  std::size_t& number_of_rows;
};

// An output that has go_further() ends rows that have begun: those are not passed on, and the others are complete.
void rows_that_have_begun_end()
{
  test_support::Scope scope("rows that have begun");
  const Mesh tm = to_face_graph(icosphere(4));
  const std::vector<vertex_descriptor> sources{vertex(3), vertex(99), vertex(500), vertex(501)};
  const auto end_after = [&](std::size_t most, const auto& compute)
  {
    std::atomic<std::size_t> number_of_questions{0};
    std::size_t number_of_rows = 0;
    const bool is_complete = compute(Ending_output{number_of_questions, most, number_of_rows});
    CHECK_EQUAL(is_complete, number_of_questions <= most);
    return number_of_rows;
  };
  with_all_tags(
    [&](auto tag)
    {
      using Tag = decltype(tag);
      const auto dense = [&](Ending_output output)
      { return SMG::geodesic_distance_matrix<Tag>(tm, sources, vertices(tm), output); };
      const auto sparse = [&](Ending_output output)
      { return SMG::sparse_geodesic_distance_matrix<Tag>(tm, sources, vertices(tm), 9., output); };
      const auto symmetric
        = [&](Ending_output output) { return SMG::symmetric_geodesic_distance_matrix<Tag>(tm, sources, output); };
      const std::size_t never = std::size_t(-1);
      CHECK_EQUAL(end_after(never, dense), 4u);
      CHECK_EQUAL(end_after(never, sparse), 4u);
      CHECK_EQUAL(end_after(never, symmetric), 4u);
      // A run from one source asks at each of more than a thousand visits.
      for(const std::size_t most : {0u, 1u, 100u, 1000u})
      {
        CHECK_EQUAL(end_after(most, dense), 0u);
        CHECK_EQUAL(end_after(most, sparse), 0u);
      }
      CHECK(end_after(5000, dense) < 4u);
    });
}

// A user's output may end the search for landmarks, before the first row.
void landmarks_end_early()
{
  test_support::Scope scope("landmarks");
  const Mesh tm = to_face_graph(icosphere(4)); // enough vertices for landmarks
  with_all_tags(
    [&](auto tag)
    {
      std::atomic<std::size_t> number_of_questions{0};
      std::size_t number_of_rows = 0;
      CHECK(!SMG::symmetric_geodesic_distance_matrix<decltype(tag)>(
        tm, vertices(tm), Ending_output{number_of_questions, 3000, number_of_rows}));
      CHECK_EQUAL(number_of_rows, 0u);
      CHECK(number_of_questions < 4000u);
    });
}

template <class Call>
void expect_rejection(Reason reason, std::size_t element, const Call& call)
{
  bool is_caught = false, has_row = false;
  try
  {
    call([&](std::size_t, const auto&) { has_row = true; });
  }
  catch(const Invalid_input& e)
  {
    is_caught = true;
    CHECK(e.reason() == reason);
    CHECK_EQUAL(e.element(), element);
  }
  CHECK(is_caught);
  CHECK(!has_row);
}

void invalid_input_is_rejected()
{
  test_support::Scope scope("bad input");
  const Mesh tm = to_face_graph(icosphere(1));
  const std::vector<vertex_descriptor> good{vertex(0), vertex(5)};
  const std::vector<vertex_descriptor> bad{vertex(1), vertex(9999)};
  const std::vector<vertex_descriptor> null{boost::graph_traits<Mesh>::null_vertex()};
  const std::vector<Face_location> outside{{face(0), {.5, .5, .5}}};
  with_all_tags(
    [&](auto tag)
    {
      using Tag = decltype(tag);
      const auto none = Reason::INVALID_DESCRIPTOR;
      expect_rejection(none, 1, [&](auto output) { SMG::geodesic_distance_matrix<Tag>(tm, bad, good, output); });
      expect_rejection(none, 1, [&](auto output) { SMG::geodesic_distance_matrix<Tag>(tm, good, bad, output); });
      expect_rejection(none, 0, [&](auto output) { SMG::geodesic_distance_matrix<Tag>(tm, good, null, output); });
      expect_rejection(none, 1, [&](auto output) { SMG::symmetric_geodesic_distance_matrix<Tag>(tm, bad, output); });
      expect_rejection(Reason::INVALID_LOCATION, 0,
                     [&](auto output) { SMG::geodesic_distance_matrix<Tag>(tm, outside, good, output); });
      const std::size_t no_element = Invalid_input::no_element;
      for(const double radius : {-1., std::numeric_limits<double>::quiet_NaN()})
      {
        expect_rejection(Reason::INVALID_RADIUS, no_element, [&](auto output)
                       { SMG::sparse_geodesic_distance_matrix<Tag>(tm, good, good, radius, output); });
      }
    });
}

// Points that are not those of the mesh, and a single source instead of a range.
void parameters_are_used()
{
  test_support::Scope scope("parameters");
  Mesh tm = to_face_graph(icosphere(2));
  auto points = tm.add_property_map<vertex_descriptor, Kernel::Point_3>("v:test_point").first;
  for(const vertex_descriptor v : vertices(tm))
  {
    points[v] = Kernel::Point_3(3 * tm.point(v).x(), tm.point(v).y(), tm.point(v).z());
  }
  const auto np = CGAL::parameters::vertex_point_map(points);
  const std::vector<double> expected = distances_with_parameters(tm, vertex(7), np);
  std::size_t count = 0;
  SMG::geodesic_distance_matrix(tm, vertex(7), vertices(tm), [&](std::size_t, const std::vector<double>& row)
                                {
                                  ++count;
                                  CHECK(row == expected);
                                }, np);
  CHECK_EQUAL(count, 1u);
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260502);
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : {noisy_sphere(2, .1, seed), rough_terrain(8, 2., seed), genus_2_polycube(),
                                     two_components_and_an_isolated_vertex()})
  {
    rows_are_those_of_single_runs(indexed, random);
  }
  std::mt19937 generator(static_cast<std::mt19937::result_type>(seed));
  for(const Indexed_mesh& indexed : {noisy_sphere(3, .1, seed), wavy_tube(30, 8), rough_terrain(16, 2., seed),
                                     flat_patch(15, 15, 0., false, seed), genus_2_polycube(),
                                     two_components_and_an_isolated_vertex()})
  {
    rows_are_pruned(indexed, generator);
  }
  pruning_saves_visits();
  peeling_orders_components_by_distance();
  peeling_can_be_canceled();
  landmarks_end_early();
  rows_may_end_early();
  rows_that_have_begun_end();
  invalid_input_is_rejected();
  parameters_are_used();
  return test_result();
}
