// Geodesic_distance_solver: each computation gives the same bits as geodesic_distances(), after any earlier
// computations, and takes time proportional to the area that it reaches.

#include "distance_test_helpers.h"
#include "expected_exceptions.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>

#include <CGAL/Polyhedron_3.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

using Solver = SMG::Geodesic_distance_solver<Mesh>;
using Options = Distance_options<Mesh>;

template <class Any_solver, class TriangleMesh>
std::vector<double> results(const Any_solver& solver, const TriangleMesh& tm)
{
  std::vector<double> values;
  for(const auto v : vertices(tm))
  {
    values.push_back(solver.distance(v));
  }
  return values;
}

// The vertices reached are those with a finite distance, each once.
void check_vertices_reached(const Solver& solver, const Mesh& tm)
{
  std::vector<vertex_descriptor> reached;
  solver.vertices_reached(std::back_inserter(reached));
  const std::set<vertex_descriptor> as_set(reached.begin(), reached.end());
  CHECK_EQUAL(as_set.size(), reached.size());
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(as_set.count(v) == 1, solver.distance(v) < infinity);
    CHECK_EQUAL(solver.nearest_source(v) == Solver::no_source, solver.distance(v) == infinity);
  }
}

template <class Sources>
void check_against_function(Solver& solver, const Mesh& tm, const Sources& sources, const Options& options)
{
  solver.compute_distances(sources, parameters_of(options));
  CHECK(results(solver, tm) == distances_with_options(tm, sources, options));
  auto nearest = get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm);
  auto with_map = options_with_map<Mesh>(nearest);
  with_map.maximum_distance = options.maximum_distance;
  with_map.targets = options.targets;
  with_map.source_offsets = options.source_offsets;
  distances_with_options(tm, sources, with_map);
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(solver.nearest_source(v), get(nearest, v));
  }
  check_vertices_reached(solver, tm);
}

struct Canceling_visitor : SMG::Geodesic_default_visitor
{
  bool go_further() { return ++m_calls < 5; }
  int m_calls = 0;
};

struct Throwing_visitor : SMG::Geodesic_default_visitor
{
  bool go_further()
  {
    if(++m_calls == 7)
    {
      throw std::runtime_error("thrown by the visitor");
    }
    return true;
  }
  int m_calls = 0;
};

struct Visitor_that_throws_at_an_end : SMG::Geodesic_default_visitor
{
  explicit Visitor_that_throws_at_an_end(bool is_first) : m_is_first(is_first) {}
  void on_propagation_begin(std::size_t) const { throw_if(m_is_first); }
  void on_propagation_end() const { throw_if(!m_is_first); }
  static void throw_if(bool is_here)
  {
    if(is_here)
    {
      throw std::runtime_error("thrown at an end");
    }
  }
  bool m_is_first;
};

// After an exception of the visitor the solver has no results, even if it had some before.
void visitors_throw_before_and_after_the_run()
{
  const Mesh tm = to_face_graph(icosphere(1));
  for(const bool is_first : {true, false})
  {
    for(const bool has_results : {true, false})
    {
      Solver solver(tm);
      if(has_results)
      {
        solver.compute_distances(vertex(3));
      }
      Visitor_that_throws_at_an_end visitor(is_first);
      const auto np = CGAL::parameters::visitor(std::ref(visitor));
      CHECK(throws<std::runtime_error>([&] { solver.compute_distances(vertex(0), np); }));
      CHECK(results(solver, tm) == std::vector<double>(num_vertices(tm), infinity));
      check_vertices_reached(solver, tm);
      for(const vertex_descriptor v : vertices(tm))
      {
        CHECK_EQUAL(solver.nearest_source(v), Solver::no_source);
      }
      solver.compute_distances(vertex(1));
      CHECK_EQUAL(solver.distance(vertex(1)), 0.);
      CHECK_EQUAL(solver.nearest_source(vertex(2)), 0u);
    }
  }
}

// If a visitor ends a computation, the solver has no results.
void check_canceled_computations(Solver& solver, const Mesh& tm, test_support::Random& random)
{
  const Face_location location = random_location(tm, random);
  Canceling_visitor canceling;
  CHECK(!solver.compute_distances(location, CGAL::parameters::visitor(std::ref(canceling))));
  CHECK(results(solver, tm) == std::vector<double>(num_vertices(tm), infinity));
  check_vertices_reached(solver, tm);

  Throwing_visitor throwing;
  const auto np = CGAL::parameters::visitor(std::ref(throwing));
  CHECK(throws<std::runtime_error>([&] { solver.compute_distances(location, np); }));
  CHECK(results(solver, tm) == std::vector<double>(num_vertices(tm), infinity));
}

// The solver rejects invalid input and keeps the results of the last computation.
void check_rejected_computations(Solver& solver, const Mesh& tm)
{
  const vertex_descriptor foreign(static_cast<Mesh::size_type>(num_vertices(tm) + 5));
  CHECK(throws_reason(Reason::INVALID_DESCRIPTOR, [&] { solver.compute_distance(vertex(0), foreign); }));
  check_vertices_reached(solver, tm);

  solver.compute_distances(vertex(0));
  const std::vector<double> before = results(solver, tm);
  const auto wrong_number = CGAL::parameters::source_offsets(std::vector<double>{0., 0.});
  const auto negative_radius = CGAL::parameters::maximum_distance(-1.);
  const std::vector<std::function<void()>> invalid = {[&] { solver.compute_distances(foreign); },
                                                      [&] { solver.compute_distance(vertex(1), foreign); },
                                                      [&] { solver.compute_distances(vertex(1), wrong_number); },
                                                      [&] { solver.compute_distances(vertex(1), negative_radius); }};
  for(const auto& compute : invalid)
  {
    CHECK(throws<Invalid_input>(compute));
    CHECK(results(solver, tm) == before);
    check_vertices_reached(solver, tm);
  }
}

void each_computation_agrees_with_the_function(const Indexed_mesh& indexed, test_support::Random& random)
{
  test_support::Scope scope(indexed.name);
  const Mesh tm = to_face_graph(indexed);
  Solver solver(tm);
  CHECK(results(solver, tm) == std::vector<double>(num_vertices(tm), infinity));
  for(std::size_t round = 0; round < 4; ++round)
  {
    const vertex_descriptor v = random_vertex(tm, random);
    check_against_function(solver, tm, v, Options());
    const std::vector<double> full = results(solver, tm);
    double largest = 0;
    for(const double d : full)
    {
      largest = d < infinity ? (std::max)(largest, d) : largest;
    }

    Options radius;
    radius.maximum_distance = random.uniform(0., .6) * largest;
    check_against_function(solver, tm, v, radius);
    check_against_function(solver, tm, random_location(tm, random), radius);

    Options target;
    target.targets = {random_vertex(tm, random)};
    check_against_function(solver, tm, random_location(tm, random), target);

    Options offsets;
    offsets.source_offsets = {0., .1 * largest, 0.};
    check_against_function(solver, tm,
                           std::vector<Face_location>{random_location(tm, random), random_location(tm, random),
                                                      random_location(tm, random)},
                           offsets);
    check_against_function(solver, tm, std::vector<vertex_descriptor>{v, v, random_vertex(tm, random)}, offsets);
    check_against_function(solver, tm, std::vector<vertex_descriptor>(), Options());
    check_canceled_computations(solver, tm, random);
    check_rejected_computations(solver, tm);

    const vertex_descriptor w = random_vertex(tm, random);
    CHECK_EQUAL(solver.compute_distance(v, w), full[std::size_t(w)]);
  }
}

void work_depends_on_the_area_reached()
{
  test_support::Scope scope("area reached");
  const Mesh tm = to_face_graph(icosphere(5));
  Solver solver(tm);
  SMG::Propagation_statistics all;
  SMG::Propagation_statistics near;
  Options options;
  options.statistics = &all;
  solver.compute_distances(vertex(0), parameters_of(options));
  options.statistics = &near;
  options.targets = {*vertices_around_target(halfedge(vertex(0), tm), tm).first};
  solver.compute_distances(vertex(0), parameters_of(options));
  CHECK(near.vertices_visited * 500 < all.vertices_visited);
  CHECK(near.windows_propagated * 500 < all.windows_propagated);
  std::vector<vertex_descriptor> reached;
  solver.vertices_reached(std::back_inserter(reached));
  CHECK(reached.size() * 100 < num_vertices(tm));
  CHECK(reached.size() >= 2);
}

// Runs on one of n squares up to the farthest corner; returns the shortest processor time of several tries.
double time_on_one_component(std::size_t n)
{
  Mesh tm;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double x = 2 * static_cast<double>(i);
    const vertex_descriptor a = tm.add_vertex(Kernel::Point_3(x, 0, 0));
    const vertex_descriptor b = tm.add_vertex(Kernel::Point_3(x + 1, 0, 0));
    const vertex_descriptor c = tm.add_vertex(Kernel::Point_3(x + 1, 1, 0));
    const vertex_descriptor d = tm.add_vertex(Kernel::Point_3(x, 1, 0));
    tm.add_face(a, b, d);
    tm.add_face(b, c, d);
  }
  Solver solver(tm);
  std::clock_t least = 0;
  for(std::size_t k = 0; k < 10; ++k)
  {
    const std::clock_t start = std::clock();
    for(std::size_t i = 0; i < 100; ++i)
    {
      CHECK_CLOSE(solver.compute_distance(vertex(4 * i), vertex(4 * i + 2)), std::sqrt(2.), 1e-15);
    }
    const std::clock_t time = std::clock() - start;
    least = k == 0 ? time : (std::min)(least, time);
  }
  return static_cast<double>(least) / CLOCKS_PER_SEC;
}

// A run does not visit components without a source. (An earlier version visited all faces, and took 200 times as long
// here.)
void work_does_not_depend_on_other_components()
{
  test_support::Scope scope("many components");
  CHECK(time_on_one_component(100000) < 20 * time_on_one_component(100) + .005);
}

void solvers_from_edge_lengths_can_be_moved(const Indexed_mesh& indexed)
{
  test_support::Scope scope("edge lengths");
  Mesh tm = to_face_graph(indexed);
  const auto lengths = add_edge_lengths(tm);
  Solver from_lengths = Solver::from_edge_lengths(tm, lengths);
  from_lengths.compute_distances(vertex(3));
  CHECK(results(from_lengths, tm) == distances_from_edge_lengths(tm, lengths, vertex(3)));

  Solver moved(std::move(from_lengths));
  CHECK(results(moved, tm) == distances_from_edge_lengths(tm, lengths, vertex(3)));
  moved.compute_distances(vertex(4));
  CHECK(results(moved, tm) == distances_from_edge_lengths(tm, lengths, vertex(4)));
}

void points_and_indices_may_come_from_other_maps(const Indexed_mesh& indexed)
{
  test_support::Scope scope("other maps");
  Mesh tm = to_face_graph(indexed);
  auto points = tm.add_property_map<vertex_descriptor, Kernel::Point_3>("v:test_point").first;
  std::vector<std::size_t> index_of_vertex(num_vertices(tm)), index_of_face(num_faces(tm));
  for(const vertex_descriptor v : vertices(tm))
  {
    points[v] = Kernel::Point_3(tm.point(v).x(), 2 * tm.point(v).y(), tm.point(v).z());
    index_of_vertex[v] = num_vertices(tm) - 1 - v;
  }
  for(const face_descriptor f : faces(tm))
  {
    index_of_face[f] = num_faces(tm) - 1 - f;
  }
  const auto vim = CGAL::make_property_map(index_of_vertex);
  const auto fim = CGAL::make_property_map(index_of_face);
  SMG::Geodesic_distance_solver<Mesh, CGAL::Sequential_tag, decltype(vim), decltype(fim)> stretched(tm, points, vim,
                                                                                                  fim);
  stretched.compute_distances(vertex(3));
  CHECK(results(stretched, tm)
        == distances_with_parameters(tm, vertex(3), CGAL::parameters::vertex_point_map(points)));
  namespace np = CGAL::parameters;
  const std::vector<face_descriptor> avoided{face_descriptor(10), face_descriptor(11), face_descriptor(40)};
  const auto all = np::faces_to_avoid(avoided).vertex_point_map(points).vertex_index_map(vim).face_index_map(fim);
  decltype(stretched) around(tm, all);
  around.compute_distances(vertex(3));
  CHECK(results(around, tm) == distances_with_parameters(tm, vertex(3), all));
  CHECK(results(around, tm) != results(stretched, tm));
  const auto no_points = np::faces_to_avoid(avoided).vertex_index_map(vim).face_index_map(fim);
  const auto lengths = add_edge_lengths(tm);
  decltype(stretched) from_lengths = decltype(stretched)::from_edge_lengths(tm, lengths, no_points);
  from_lengths.compute_distances(vertex(3));
  decltype(stretched) from_points(tm, no_points);
  from_points.compute_distances(vertex(3));
  CHECK_FIELDS_CLOSE(results(from_lengths, tm), results(from_points, tm), 1e-13);
  Solver stretched_too(tm, points);
  stretched_too.compute_distances(vertex(3));
  CHECK(results(stretched_too, tm) == results(stretched, tm));
}

void a_mesh_needs_no_indices(const Indexed_mesh& indexed)
{
  test_support::Scope scope("polyhedron");
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Polyhedron polyhedron = to_face_graph<Polyhedron>(indexed);
  SMG::Geodesic_distance_solver<Polyhedron> of_polyhedron(polyhedron);
  of_polyhedron.compute_distances(*vertices(polyhedron).begin());
  CHECK(results(of_polyhedron, polyhedron) == distances(to_face_graph(indexed), vertex(0)));
}

void the_constructor_rejects_a_mesh_of_quadrangles()
{
  Mesh square;
  square.add_vertex(Kernel::Point_3(0, 0, 0));
  square.add_vertex(Kernel::Point_3(1, 0, 0));
  square.add_vertex(Kernel::Point_3(1, 1, 0));
  square.add_vertex(Kernel::Point_3(0, 1, 0));
  square.add_face(vertex(0), vertex(1), vertex(2), vertex(3));
  CHECK(throws_reason(Reason::NOT_A_TRIANGLE, [&] { const Solver solver(square); }));
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260501);
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed :
      {noisy_sphere(2, .1, seed), rough_terrain(10, 2., seed), genus_2_polycube(), spiral_corridor(),
       random_cuts(noisy_sphere(2, .1, seed + 2), .15, seed + 3), two_components_and_an_isolated_vertex(),
       tetrahedral_ogre(60, seed + 1)})
  {
    each_computation_agrees_with_the_function(indexed, random);
  }
  work_depends_on_the_area_reached();
  work_does_not_depend_on_other_components();
  visitors_throw_before_and_after_the_run();
  const Indexed_mesh sphere = noisy_sphere(2, .1, seed);
  solvers_from_edge_lengths_can_be_moved(sphere);
  points_and_indices_may_come_from_other_maps(sphere);
  a_mesh_needs_no_indices(sphere);
  the_constructor_rejects_a_mesh_of_quadrangles();
  return test_result();
}
