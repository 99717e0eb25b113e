// The class for paths and the class of diagrams with Parallel_tag. Their bits do not depend on the number of threads,
// and they agree with the sequential classes.

#include "Voronoi_sites.h"
#include "expected_exceptions.h"
#include "impatient_visitor.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"
#include "with_threads.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

using CGAL::Default;

template <class Tag>
using Tagged_paths = CGAL::Surface_mesh_geodesic_paths<Paths_traits, Default, Default, Default, Default, Tag>;
template <class Tag>
using Tagged_diagram
  = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Paths_traits, Default, Default, Default, Default, Tag>;

static_assert(std::is_same<Tagged_paths<CGAL::Sequential_tag>, Geodesic_paths>::value
                && std::is_same<Tagged_diagram<CGAL::Sequential_tag>, Voronoi>::value,
              "the sequential tag is the default");

const std::vector<std::size_t> numbers_of_threads{1, 2, 3, 5, 64};

using Tag = CGAL::Parallel_if_available_tag;
using Parallel_paths = Tagged_paths<Tag>;
using Parallel_diagram = Tagged_diagram<Tag>;

std::vector<Surface_point> random_points(const Mesh& tm, std::size_t number, test_support::Random& random)
{
  std::vector<Surface_point> points;
  for(std::size_t i = 0; i < number; ++i)
  {
    points.push_back(random_point(tm, random));
  }
  return points;
}

template <class Paths>
void add_source_points(Paths& paths, const std::vector<Surface_point>& sources)
{
  for(const Surface_point& s : sources)
  {
    s.is_vertex() ? paths.add_source_point(s.vertex) : paths.add_source_point(s.location);
  }
}

// --- paths ---

// Distances of all vertices, and distances and paths of some points, as numbers.
template <class Paths>
std::vector<double> answers(const Paths& paths, const Mesh& tm, const std::vector<Surface_point>& queries)
{
  std::vector<double> numbers;
  for(const vertex_descriptor v : vertices(tm))
  {
    numbers.push_back(ask(paths, Surface_point(v)).distance);
  }
  for(const Surface_point& q : queries)
  {
    std::vector<Kernel::Point_3> points;
    const Answer answer = ask_points(paths, q, std::back_inserter(points));
    numbers.push_back(answer.distance);
    numbers.push_back(static_cast<double>(answer.source));
    for(const Kernel::Point_3& p : points)
    {
      numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
    }
  }
  return numbers;
}

void threads_do_not_change_the_paths(const Mesh& tm, test_support::Random& random)
{
  test_support::Scope scope("paths");
  const std::vector<Surface_point> sources = random_points(tm, 1 + random.index(4), random);
  const std::vector<Surface_point> queries = random_points(tm, 30, random);
  Geodesic_paths sequential(tm);
  add_source_points(sequential, sources);
  std::vector<double> first;
  for(const std::size_t number : numbers_of_threads)
  {
    test_support::Scope scope_of_threads(std::to_string(number) + " threads");
    for(const bool is_built : {false, true}) // by the queries in two stages, or all at once
    {
      Parallel_paths paths(tm);
      add_source_points(paths, sources);
      with_threads(number, [&]
      {
        if(is_built)
        {
          paths.build_sequence_tree_for_faces();
        }
        const std::vector<double> found = answers(paths, tm, queries);
        first = first.empty() ? found : first;
        CHECK(found == first);
      });
      if(number > 1 || is_built)
      {
        continue;
      }
      for(const vertex_descriptor v : vertices(tm))
      {
        CHECK_CLOSE(ask(paths, Surface_point(v)).distance, ask(sequential, Surface_point(v)).distance, 1e-12);
      }
      for(const Surface_point& q : queries)
      {
        CHECK_CLOSE(ask(paths, q).distance, ask(sequential, q).distance, 1e-12);
        checked_path(paths, q, tm, 1., 1e-12);
      }
    }
  }
}

// --- diagrams ---

// All arcs, vertices, edges and areas as numbers, in their order, and the distances of some points.
std::vector<double> numbers_of(const Parallel_diagram& diagram, const Mesh& tm,
                               const std::vector<Surface_point>& queries)
{
  std::vector<double> numbers;
  for(const auto& arc : diagram.arcs())
  {
    for(const double t : {0., .5, 1.})
    {
      const Kernel::Point_3 p = diagram.point(arc.point(t));
      numbers.insert(numbers.end(), {p.x(), p.y(), p.z(), arc.distance(t)});
    }
    numbers.insert(numbers.end(), {static_cast<double>(arc.sites().first), static_cast<double>(arc.sites().second)});
  }
  for(const auto& v : diagram.vertices())
  {
    numbers.insert(numbers.end(), {v.point().x(), v.point().y(), v.point().z(), v.distance()});
  }
  for(const auto& e : diagram.edges())
  {
    numbers.push_back(static_cast<double>(e.arcs().size()));
  }
  for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
  {
    numbers.push_back(diagram.area(i));
  }
  for(const vertex_descriptor v : vertices(tm))
  {
    numbers.push_back(diagram.distance_to_nearest_site(v));
  }
  for(const Surface_point& q : queries)
  {
    numbers.push_back(q.is_vertex()
                        ? diagram.distance_to_nearest_site(q.vertex)
                        : diagram.distance_to_nearest_site(q.location.first, q.location.second));
  }
  numbers.push_back(static_cast<double>(diagram.number_of_kept_windows().first));
  numbers.push_back(static_cast<double>(diagram.number_of_kept_windows().second));
  return numbers;
}

// Compares a diagram with the sequential one.
void check_agreement(const Parallel_diagram& diagram, const Voronoi& sequential, const Mesh& tm)
{
  double size = 0.;
  for(std::size_t i = 0; i < sequential.number_of_sites(); ++i)
  {
    size += sequential.area(i);
  }
  for(std::size_t i = 0; i < sequential.number_of_sites(); ++i)
  {
    CHECK_NEAR(diagram.area(i), sequential.area(i), 1e-11 * size);
    CHECK_EQUAL(diagram.is_empty(i), sequential.is_empty(i));
    CHECK(diagram.adjacent_sites(i) == sequential.adjacent_sites(i));
    CHECK_EQUAL(diagram.Euler_characteristic(i), sequential.Euler_characteristic(i));
  }
  CHECK_EQUAL(diagram.vertices().size(), sequential.vertices().size());
  CHECK_EQUAL(diagram.edges().size(), sequential.edges().size());
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(diagram.nearest_site(v), sequential.nearest_site(v));
    CHECK_NEAR(diagram.distance_to_nearest_site(v), sequential.distance_to_nearest_site(v), 1e-12);
  }
}

double threads_do_not_change_the_diagrams(const Mesh& tm, double largest_weight, test_support::Random& random)
{
  test_support::Scope scope("diagrams");
  const Weighted_sites sites = random_sites(tm, 2 + random.index(20), largest_weight, random);
  const std::vector<Surface_point> queries = random_points(tm, 20, random);
  Voronoi sequential(tm);
  add_sites(sequential, sites);
  double worst = 0;
  std::vector<double> first;
  for(const std::size_t number : numbers_of_threads)
  {
    test_support::Scope scope_of_threads(std::to_string(number) + " threads");
    Parallel_diagram diagram(tm);
    add_sites(diagram, sites);
    with_threads(number, [&]
    {
      diagram.build();
      const std::vector<double> found = numbers_of(diagram, tm, queries);
      first = first.empty() ? found : first;
      CHECK(found == first);
    });
    if(number == 1)
    {
      check_agreement(diagram, sequential, tm);
      const auto certificate = SMG::certify_geodesic_Voronoi_diagram(diagram);
      CHECK(certificate.is_certified());
      worst = certificate.worst_violation();
    }
  }
  return worst;
}

// --- visitors, invalid input, queries from threads ---

struct Visitor : Impatient_visitor
{
  std::size_t begins = 0, ends = 0;
  double reached = -infinity;

  void on_propagation_begin(std::size_t) { ++begins; }
  void on_propagation_end() { ++ends; }
  void on_progress(std::size_t, double distance)
  {
    CHECK(distance >= reached);
    reached = distance;
  }
};

// Builds with visitors that cancel or throw, and with one that does neither. is_built() tells whether the object that
// is built knows its answers.
template <class Build, class Is_built>
void build_with_visitors(Build build, Is_built is_built)
{
  for(const std::size_t steps : {std::size_t(0), std::size_t(3), std::size_t(12)})
  {
    Visitor canceling;
    canceling.steps_left = steps;
    CHECK(!build(canceling));
    CHECK_EQUAL(canceling.begins, 1u);
    CHECK_EQUAL(canceling.ends, 1u);
    CHECK(!is_built());
    Visitor throwing;
    throwing.steps_left = steps;
    throwing.throws = true;
    CHECK(throws<std::range_error>([&] { build(throwing); }));
    CHECK(!is_built());
  }
  Visitor patient;
  patient.steps_left = (std::numeric_limits<std::size_t>::max)();
  CHECK(build(patient));
  CHECK(is_built());
}

void visitors_can_cancel_or_throw(std::uint64_t seed)
{
  test_support::Scope scope("visitors");
  const Mesh tm = to_face_graph(noisy_sphere(3, .1, seed));
  Geodesic_paths expected(tm);
  expected.add_source_point(vertex(0));
  for(const std::size_t number : numbers_of_threads)
  {
    with_threads(number, [&]
    {
      Parallel_paths paths(tm);
      paths.add_source_point(vertex(0));
      build_with_visitors([&](Visitor& visitor) { return paths.build_sequence_tree_for_faces(visitor); },
                          [&] { return !paths.changed_since_last_build(); });
      const Surface_point query(Face_location(face(12), {.2, .3, .5}));
      CHECK_CLOSE(ask(paths, query).distance, ask(expected, query).distance, 1e-12);
      Parallel_diagram diagram(tm);
      diagram.add_site(vertex(0));
      diagram.add_site(vertex(100));
      build_with_visitors([&](Visitor& visitor) { return diagram.build(visitor); },
                          [&] { return diagram.is_built(); });
      CHECK(!diagram.arcs().empty());
    });
  }
}

void invalid_input_is_rejected()
{
  test_support::Scope scope("invalid input");
  const Mesh tm = to_face_graph(icosphere(1));
  with_threads(2, [&]
  {
    Parallel_paths paths(tm);
    paths.add_source_point(vertex(num_vertices(tm)));
    CHECK(throws<Invalid_input>([&] { paths.build_sequence_tree(); }));
    CHECK(throws<Invalid_input>([&] { paths.shortest_distance_to_source_points(vertex(0)); }));
    paths.remove_all_source_points();
    paths.add_source_point(vertex(1));
    CHECK(throws<Invalid_input>([&] { paths.shortest_distance_to_source_points(face(0), {2., -1., 0.}); }));
    CHECK(ask(paths, Surface_point(vertex(0))).distance > 0.);
    Parallel_diagram diagram(tm);
    diagram.add_site(Face_location(face(0), {2., -1., 0.}));
    CHECK(throws<Invalid_input>([&] { diagram.build(); }));
    diagram.clear();
    diagram.add_site(vertex(0));
    CHECK_EQUAL(diagram.nearest_site(vertex(1)), 0u);
    CHECK(throws<Invalid_input>([&] { diagram.nearest_site(vertex(num_vertices(tm))); }));
  });
}

#ifdef CGAL_LINKED_WITH_TBB

// Tasks query objects of which nothing is built. The one that builds waits for its helpers while it holds a mutex. It
// must not start another query meanwhile.
void tasks_may_query_what_is_not_built(std::uint64_t seed)
{
  test_support::Scope scope("queries from tasks");
  const Mesh tm = to_face_graph(noisy_sphere(3, .1, seed));
  Geodesic_paths expected(tm);
  expected.add_source_point(vertex(0));
  const Surface_point query(Face_location(face(12), {.2, .3, .5}));
  for(const std::size_t number : numbers_of_threads)
  {
    with_threads(number, [&]
    {
      for(std::size_t repetition = 0; repetition < 3; ++repetition)
      {
        Parallel_paths paths(tm);
        paths.add_source_point(vertex(0));
        Parallel_diagram diagram(tm);
        diagram.add_site(vertex(0));
        diagram.add_site(vertex(100));
        std::vector<double> distances(64), owners(64);
        tbb::parallel_for(std::size_t(0), distances.size(), [&](std::size_t i)
        {
          distances[i] = ask(paths, query).distance;
          owners[i] = static_cast<double>(diagram.nearest_site(vertex(100)));
        });
        CHECK_CLOSE(distances[0], ask(expected, query).distance, 1e-12);
        CHECK(distances == std::vector<double>(64, distances[0]));
        CHECK(owners == std::vector<double>(64, 1.));
      }
    });
  }
}

#endif // CGAL_LINKED_WITH_TBB

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260612);
  test_support::Random random(seed);
  double worst = 0;
  for(const Indexed_mesh& indexed :
      {noisy_sphere(3, .1, seed), rough_terrain(16, 2., seed),
       midpoint_subdivision(jittered(genus_2_polycube(), .15, seed), 1), tetrahedral_ogre(60, seed),
       random_cuts(noisy_sphere(2, .1, seed + 2), .15, seed + 3), irregular_tetrahedron(),
       two_components_and_an_isolated_vertex()})
  {
    test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    threads_do_not_change_the_paths(tm, random);
    for(const double largest_weight : {0., .1})
    {
      worst = (std::max)(worst, threads_do_not_change_the_diagrams(tm, largest_weight, random));
    }
  }
  std::cout << "largest violation of a certificate: " << worst << std::endl;
  visitors_can_cancel_or_throw(seed);
  invalid_input_is_rejected();
#ifdef CGAL_LINKED_WITH_TBB
  tasks_may_query_what_is_not_built(seed);
#else
  std::cout << "TBB is not there: nothing is parallel" << std::endl;
#endif
  return test_result();
}
