// Visitors of Surface_mesh_geodesic_paths that follow a build, cancel it or throw: the object stays valid, and the next
// query computes what is missing.

#include "expected_exceptions.h"
#include "impatient_visitor.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>

#include <CGAL/assertions.h>
#include <CGAL/exceptions.h>

#include <cstddef>
#include <stdexcept>

using namespace test_meshes;

namespace {

struct Canceling_visitor : Impatient_visitor
{
  std::size_t begins = 0, ends = 0, vertices_announced = 0;
  double distance_reached = 0.;

  void on_propagation_begin(std::size_t number_of_vertices)
  {
    ++begins;
    vertices_announced = number_of_vertices;
  }
  void on_progress(std::size_t, double distance)
  {
    CHECK(distance >= distance_reached);
    distance_reached = distance;
  }
  void on_propagation_end() { ++ends; }
};

void building_can_be_canceled()
{
  test_support::Scope scope("canceling");
  const Mesh tm = to_face_graph(noisy_sphere(3, .05, 5));
  Geodesic_paths expected(tm);
  expected.add_source_point(vertex(0));
  expected.add_source_point(face(77), {.2, .3, .5});
  Geodesic_paths paths(tm);
  const auto first = paths.add_source_point(vertex(0));
  paths.add_source_point(face(77), {.2, .3, .5});
  bool was_canceled = false, was_complete = false;
  for(std::size_t steps = 0; steps < 100000; steps = 3 * steps + 1)
  {
    for(const bool for_faces : {false, true})
    {
      paths.remove_source_point(paths.add_source_point(vertex(5))); // makes the next build necessary
      Canceling_visitor visitor;
      visitor.steps_left = steps;
      const bool is_complete =
        for_faces ? paths.build_sequence_tree_for_faces(visitor) : paths.build_sequence_tree(visitor);
      was_canceled = was_canceled || !is_complete;
      was_complete = was_complete || is_complete;
      CHECK_EQUAL(visitor.begins, 1u);
      CHECK_EQUAL(visitor.ends, 1u);
      CHECK_EQUAL(visitor.vertices_announced, num_vertices(tm));
      CHECK_EQUAL(paths.changed_since_last_build(), !is_complete);
      CHECK_EQUAL(paths.number_of_source_points(), 2u);
      CHECK(first == paths.source_points_begin());
      if(!is_complete)
      {
        const Geodesic_paths& constant = paths; // its first query builds
        CHECK_EQUAL(constant.shortest_distance_to_source_points(vertex(3)).first,
                    expected.shortest_distance_to_source_points(vertex(3)).first);
        CHECK(!paths.changed_since_last_build());
      }
      for(const Surface_point& q : {Surface_point(vertex(3)), Surface_point(Face_location(face(12), {.2, .3, .5}))})
      {
        CHECK_EQUAL(ask(paths, q).distance, ask(expected, q).distance);
        CHECK_EQUAL(ask(paths, q).source, ask(expected, q).source);
      }
    }
  }
  CHECK(was_canceled && was_complete);
  Canceling_visitor visitor; // nothing left to build
  CHECK(paths.build_sequence_tree_for_faces(visitor));
  CHECK_EQUAL(visitor.begins, 0u);
  CHECK(paths.statistics().vertices_visited > 0);
  paths.clear();
  CHECK_EQUAL(paths.statistics().vertices_visited, 0u);
}

// The distances of vertices stay if a visitor ends the build that adds the windows.
void canceling_the_second_stage_keeps_the_first()
{
  test_support::Scope scope("canceling the second stage");
  const Mesh tm = to_face_graph(noisy_sphere(3, .05, 5));
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  const double distance = paths.shortest_distance_to_source_points(vertex(3)).first;
  Canceling_visitor canceling;
  CHECK(!paths.build_sequence_tree_for_faces(canceling));
  CHECK(!paths.changed_since_last_build());
  const std::size_t visits = paths.statistics().vertices_visited;
  CHECK_EQUAL(paths.shortest_distance_to_source_points(vertex(3)).first, distance);
  CHECK_EQUAL(paths.statistics().vertices_visited, visits); // the query has not propagated
  Canceling_visitor visitor; // the first stage is ready
  CHECK(paths.build_sequence_tree(visitor));
  CHECK_EQUAL(visitor.begins, 0u);
  Geodesic_paths expected(tm);
  expected.add_source_point(vertex(0));
  const Surface_point query(Face_location(face(12), {.2, .3, .5}));
  CHECK_EQUAL(ask(paths, query).distance, ask(expected, query).distance);
}

struct Throwing_visitor : CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
  void on_progress(std::size_t, double) { throw std::runtime_error("enough"); }
};

void exceptions_of_visitors_keep_the_object_valid()
{
  test_support::Scope scope("throwing visitor");
  const Mesh tm = to_face_graph(noisy_sphere(3, .05, 5));
  Geodesic_paths expected(tm), paths(tm);
  expected.add_source_point(face(77), {.2, .3, .5});
  paths.add_source_point(face(77), {.2, .3, .5});
  Throwing_visitor visitor;
  CHECK(throws<std::runtime_error>([&] { paths.build_sequence_tree_for_faces(visitor); }));
  CHECK(paths.changed_since_last_build());
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK_EQUAL(ask(paths, Surface_point(v)).distance, ask(expected, Surface_point(v)).distance);
  }
  const std::size_t visits = paths.statistics().vertices_visited;
  CHECK(throws<std::runtime_error>([&] { paths.build_sequence_tree_for_faces(visitor); }));
  CHECK(!paths.changed_since_last_build()); // the distances of vertices remain valid
  CHECK_EQUAL(paths.statistics().vertices_visited, visits);
}

// A canceled propagation counts if it computes distances, not if it only adds windows. None counts that throws.
void statistics_count_what_the_documentation_says()
{
  test_support::Scope scope("statistics");
  const Mesh tm = to_face_graph(noisy_sphere(3, .05, 5));
  Geodesic_paths paths(tm);
  paths.add_source_point(vertex(0));
  Throwing_visitor throwing;
  CHECK(throws<std::runtime_error>([&] { paths.build_sequence_tree(throwing); }));
  CHECK_EQUAL(paths.statistics().vertices_visited, 0u);
  Canceling_visitor first;
  first.steps_left = 5;
  CHECK(!paths.build_sequence_tree(first));
  const std::size_t of_first = paths.statistics().vertices_visited;
  paths.build_sequence_tree();
  const std::size_t of_complete = paths.statistics().vertices_visited;
  CHECK(0 < of_first && of_first < of_complete);
  Canceling_visitor second;
  CHECK(!paths.build_sequence_tree_for_faces(second));
  CHECK_EQUAL(paths.statistics().vertices_visited, of_complete);
}

// A visitor that asks the object that is being built would compute inside the computation.
template <class Ask>
struct Asking_visitor : CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
  explicit Asking_visitor(Ask ask_object) : m_ask(ask_object) {}

  void on_progress(std::size_t, double) { m_ask(); }

private:
  Ask m_ask;
};

void visitors_must_not_ask_the_object()
{
#if !defined(CGAL_NO_PRECONDITIONS) && !defined(CGAL_NDEBUG)
  test_support::Scope scope("visitors that ask the object");
  const Mesh tm = to_face_graph(noisy_sphere(2, .05, 5));
  Geodesic_paths paths(tm), expected(tm);
  paths.add_source_point(vertex(0));
  expected.add_source_point(vertex(0));
  auto ask_paths = [&] { paths.shortest_distance_to_source_points(vertex(3)); };
  Asking_visitor<decltype(ask_paths)> visitor(ask_paths);
  CHECK(throws<CGAL::Precondition_exception>([&] { paths.build_sequence_tree(visitor); }));
  CHECK(paths.changed_since_last_build());
  CHECK_EQUAL(ask(paths, Surface_point(vertex(3))).distance, ask(expected, Surface_point(vertex(3))).distance);
  CGAL::Surface_mesh_geodesic_Voronoi_diagram<Paths_traits> diagram(tm);
  diagram.add_site(vertex(0));
  auto ask_diagram = [&] { diagram.nearest_site(vertex(3)); };
  Asking_visitor<decltype(ask_diagram)> visitor_of_diagram(ask_diagram);
  CHECK(throws<CGAL::Precondition_exception>([&] { diagram.build(visitor_of_diagram); }));
  CHECK(!diagram.is_built());
  CHECK_EQUAL(diagram.nearest_site(vertex(3)), 0u);
#endif
}

} // namespace

int main()
{
  building_can_be_canceled();
  canceling_the_second_stage_keeps_the_first();
  exceptions_of_visitors_keep_the_object_valid();
  statistics_count_what_the_documentation_says();
  visitors_must_not_ask_the_object();
  return test_result();
}
