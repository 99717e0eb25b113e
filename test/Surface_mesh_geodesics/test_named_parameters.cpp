// Sequences of named parameters: orders and mixtures with parameters of CGAL, sequences of CGAL that are appended, and
// the types that values may have. What the parameters do: test_options.cpp. What does not compile: the folder rejected.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>

#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <list>
#include <set>
#include <vector>

namespace {

using namespace test_meshes;
namespace np = CGAL::parameters;

// A range that cannot be copied: the parameters refer to it.
struct Fixed_range
{
  explicit Fixed_range(std::vector<vertex_descriptor> values) : m_values(std::move(values)) {}
  Fixed_range(const Fixed_range&) = delete;
  Fixed_range& operator=(const Fixed_range&) = delete;

  auto begin() const { return m_values.begin(); }
  auto end() const { return m_values.end(); }

private:
  std::vector<vertex_descriptor> m_values;
};

// Counts its calls. A copy counts for itself.
struct Counting_visitor : SMG::Geodesic_default_visitor
{
  int calls = 0;
  bool go_further() { return ++calls > 0; }
};

struct Fixture
{
  Mesh tm = to_face_graph(icosphere(2));
  std::vector<vertex_descriptor> sources{vertex(0), vertex(40)};
  std::vector<vertex_descriptor> targets{vertex(3), vertex(17)};
  std::vector<double> offsets{.25, 0.};
  Mesh::Property_map<vertex_descriptor, double> distance
    = tm.add_property_map<vertex_descriptor, double>("v:test_distance", -7.).first;
  Mesh::Property_map<vertex_descriptor, std::size_t> nearest
    = tm.add_property_map<vertex_descriptor, std::size_t>("v:test_nearest", 77).first;
  SMG::Propagation_statistics statistics;

  // The distances and nearest sources with all parameters, as a program without sequences would compute them.
  std::vector<double> expected;
  std::vector<std::size_t> expected_nearest;

  Fixture()
  {
    auto options = options_with_map<Mesh>(nearest);
    options.maximum_distance = 1.5;
    options.targets = targets;
    options.source_offsets = offsets;
    SMG::Geodesic_default_visitor visitor;
    CHECK(SMG::internal::compute_geodesic_distances<CGAL::Sequential_tag>(
      tm, distance, sources, options, SMG::internal::shape_from_points<double>(tm, np::default_values()), visitor,
      np::default_values()));
    for(const vertex_descriptor v : vertices(tm))
    {
      expected.push_back(distance[v]);
      expected_nearest.push_back(nearest[v]);
    }
  }

  // Computes with a sequence that has all parameters, and compares.
  template <class NamedParameters>
  void check(const char* what, const NamedParameters& sequence)
  {
    test_support::Scope scope(what);
    for(const vertex_descriptor v : vertices(tm))
    {
      distance[v] = -7.;
      nearest[v] = 77;
    }
    statistics = SMG::Propagation_statistics();
    CHECK(SMG::geodesic_distances(tm, distance, sources, sequence));
    CHECK(values_at_vertices(tm, distance) == expected);
    for(const vertex_descriptor v : vertices(tm))
    {
      CHECK_EQUAL(nearest[v], expected_nearest[std::size_t(v)]);
    }
    CHECK(statistics.windows_created > 0);
  }
};

void parameters_come_in_any_order()
{
  Fixture f;
  Counting_visitor visitor;
  f.check("own first", np::maximum_distance(1.5)
                         .targets(f.targets)
                         .source_offsets(f.offsets)
                         .nearest_source_map(f.nearest)
                         .statistics(&f.statistics)
                         .visitor(std::ref(visitor)));
  CHECK(visitor.calls > 0);
  f.check("reverse", np::statistics(&f.statistics)
                       .nearest_source_map(f.nearest)
                       .source_offsets(f.offsets)
                       .targets(f.targets)
                       .maximum_distance(1.5));
  f.check("mixed", np::source_offsets(f.offsets)
                     .vertex_point_map(f.tm.points())
                     .maximum_distance(1.5)
                     .geom_traits(Kernel())
                     .face_index_map(get(boost::face_index, f.tm))
                     .targets(f.targets)
                     .vertex_index_map(get(boost::vertex_index, f.tm))
                     .halfedge_index_map(get(boost::halfedge_index, f.tm))
                     .nearest_source_map(f.nearest)
                     .statistics(&f.statistics));
}

// A function that receives parameters of CGAL adds some of this package.
// A sequence that starts with a parameter of the package may be one for a function of CGAL.
void sequences_go_on_with_all_parameters_of_cgal()
{
  const auto sequence = np::maximum_distance(4.).do_project(false).number_of_relaxation_steps(7u);
  CHECK_EQUAL(np::get_parameter(sequence, CGAL::internal_np::number_of_relaxation_steps), 7u);
  CHECK(!np::get_parameter(sequence, CGAL::internal_np::do_project));
}

// With CGAL 6, a function of CGAL has the same name.
void radii_of_any_type()
{
  Fixture f;
  const double radius = 2;
  const std::vector<double> expected = distances_with_parameters(f.tm, f.sources, np::maximum_distance(radius));
  const auto check = [&](const auto& value)
  {
    CHECK(distances_with_parameters(f.tm, f.sources, np::maximum_distance(value).targets(f.targets).targets(
                                                       std::vector<vertex_descriptor>())) == expected);
  };
  check(2.f);
  check(2);
  check(2u);
  check(short(2));
  check(std::cref(radius));
}

void sequences_are_combined()
{
  Fixture f;
  const auto of_cgal = np::vertex_point_map(f.tm.points()).face_index_map(get(boost::face_index, f.tm));
  const auto own = np::maximum_distance(1.5).targets(f.targets);
  f.check("one sequence", own.combine(of_cgal)
                         .source_offsets(f.offsets)
                         .nearest_source_map(f.nearest)
                         .statistics(&f.statistics));
  f.check("two sequences", own.combine(of_cgal, np::source_offsets(f.offsets).nearest_source_map(f.nearest))
                          .statistics(&f.statistics));
  f.check("default values", own.combine(np::default_values(), np::source_offsets(f.offsets),
                                        np::nearest_source_map(f.nearest).statistics(&f.statistics)));

  // A point map that is appended is used: here all lengths are twice as long.
  auto points = f.tm.add_property_map<vertex_descriptor, Kernel::Point_3>("v:test_point").first;
  for(const vertex_descriptor v : vertices(f.tm))
  {
    const Coordinates p = coordinates(v, f.tm);
    points[v] = Kernel::Point_3(2 * p[0], 2 * p[1], 2 * p[2]);
  }
  const std::vector<double> once = distances_with_parameters(f.tm, f.sources, np::maximum_distance(2.));
  const std::vector<double> twice
    = distances_with_parameters(f.tm, f.sources, np::maximum_distance(4.).combine(np::vertex_point_map(points)));
  for(std::size_t v = 0; v < once.size(); ++v)
  {
    CHECK_EQUAL(2 * once[v], twice[v]);
  }
}

void any_range_is_accepted()
{
  Fixture f;
  const auto rest = np::nearest_source_map(f.nearest).statistics(&f.statistics);
  const std::list<vertex_descriptor> list(f.targets.begin(), f.targets.end());
  const std::set<vertex_descriptor> set(f.targets.begin(), f.targets.end());
  const vertex_descriptor array[] = {f.targets[0], f.targets[1]};
  const Fixed_range fixed(f.targets);
  const float floats[2] = {.25f, 0.f};
  const std::array<double, 2> two{{.25, 0}};
  f.check("list and std::array", rest.maximum_distance(1.5f).targets(list).source_offsets(two));
  f.check("set and array of float", rest.maximum_distance(1.5).targets(set).source_offsets(floats));
  f.check("array and list", rest.maximum_distance(1.5l).targets(array).source_offsets(std::list<double>{.25, 0.}));
  f.check("range that is not copied", rest.maximum_distance(1.5).targets(fixed).source_offsets(std::cref(f.offsets)));

  // Any number is a radius, as the first parameter as well. Vertices of the mesh are a range.
  for(const std::vector<double>& d : {distances_with_parameters(f.tm, f.sources, np::maximum_distance(1)),
                                      distances_with_parameters(f.tm, f.sources, np::maximum_distance(1u)),
                                      distances_with_parameters(f.tm, f.sources, np::maximum_distance(1.f)),
                                      distances_with_parameters(f.tm, f.sources, np::maximum_distance(1ll))})
  {
    CHECK(d == distances_with_parameters(f.tm, f.sources, np::maximum_distance(1.)));
  }
  CHECK(distances_with_parameters(f.tm, f.sources, np::targets(vertices(f.tm))) == distances(f.tm, f.sources));
}

// Sequences that start with a parameter of CGAL and have no other ones are those of CGAL.
void sequences_of_cgal_are_unchanged()
{
  Fixture f;
  CHECK(distances_with_parameters(f.tm, f.sources, np::vertex_point_map(f.tm.points()))
        == distances(f.tm, f.sources));
  CHECK(distances_with_parameters(f.tm, f.sources, np::default_values()) == distances(f.tm, f.sources));
  // Functions of CGAL take a sequence of this package, and find what they know.
  CHECK_EQUAL(CGAL::Polygon_mesh_processing::area(f.tm, np::maximum_distance(1.).vertex_point_map(f.tm.points())),
              CGAL::Polygon_mesh_processing::area(f.tm));
}

// A visitor is copied unless it is passed with std::ref().
void visitors_are_copied_or_referred_to()
{
  Fixture f;
  Counting_visitor visitor;
  distances_with_parameters(f.tm, f.sources, np::maximum_distance(1.).visitor(visitor));
  CHECK_EQUAL(visitor.calls, 0);
  distances_with_parameters(f.tm, f.sources, np::maximum_distance(1.).visitor(std::ref(visitor)));
  CHECK(visitor.calls > 0);
}

// Other functions with parameters of this package, each with one of CGAL behind it.
void each_function_takes_its_parameters()
{
  Fixture f;
  const auto points = f.tm.points();
  SMG::Geodesic_distance_solver<Mesh> solver(f.tm);
  CHECK(solver.compute_distances(f.sources, np::maximum_distance(1.5).targets(f.targets).source_offsets(f.offsets)));
  for(const vertex_descriptor v : vertices(f.tm))
  {
    CHECK_EQUAL(solver.distance(v), f.expected[std::size_t(v)]);
  }

  SMG::geodesic_distances(f.tm, f.distance, f.sources, np::source_offsets(f.offsets));
  CHECK(SMG::certify_geodesic_distances(f.tm, f.distance, f.sources,
                                        np::source_offsets(f.offsets).vertex_point_map(points).number_of_iterations(1))
          .is_certified());

  const auto lengths = add_edge_lengths(f.tm);
  CHECK(SMG::geodesic_distances_from_edge_lengths(
    f.tm, lengths, f.distance, f.sources,
    np::source_offsets(f.offsets).face_index_map(get(boost::face_index, f.tm)).nearest_source_map(f.nearest)));

  std::vector<vertex_descriptor> samples;
  const auto sequence = np::covering_radius(.75f).vertex_point_map(points).first_samples(f.sources);
  const double radius = SMG::geodesic_farthest_point_sampling(f.tm, 100, std::back_inserter(samples), sequence);
  CHECK(radius <= .75 && !samples.empty());

  auto site = f.tm.add_property_map<vertex_descriptor, std::size_t>("v:test_site", 77).first;
  CHECK(SMG::geodesic_Voronoi_labels(
    f.tm, site, f.sources,
    np::site_weights(std::array<float, 2>{{-.25f, 0.f}}).vertex_point_map(points).vertex_distance_map(f.distance)));
  for(const vertex_descriptor v : vertices(f.tm))
  {
    CHECK(site[v] < 2 && f.distance[v] < infinity);
  }
}

} // namespace

int main()
{
  parameters_come_in_any_order();
  sequences_go_on_with_all_parameters_of_cgal();
  radii_of_any_type();
  sequences_are_combined();
  any_range_is_accepted();
  sequences_of_cgal_are_unchanged();
  visitors_are_copied_or_referred_to();
  each_function_takes_its_parameters();
  return test_result();
}
