// Certification of distances: right distances are certified, on meshes and from sources of all kinds. Each wrong
// distance is found, and the certificate tells where it is. test_certificate_checks.cpp tests the checks one by one.

#include "distance_test_helpers.h"
#include "expected_exceptions.h"
#include "hostile_meshes.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

using Certificate = SMG::Geodesic_distance_certificate<Mesh>;
using Condition = Certificate::Condition;
using Options = Distance_options<Mesh>;
using Distance_map = Mesh::Property_map<vertex_descriptor, double>;

// Only a check makes a certificate.
static_assert(!std::is_default_constructible<Certificate>::value, "a certificate without a check");
static_assert(std::is_copy_constructible<Certificate>::value && std::is_copy_assignable<Certificate>::value,
              "a certificate is a value");

Distance_map add_distances(Mesh& tm)
{
  return tm.add_property_map<vertex_descriptor, double>("v:test_distance", 0.).first;
}

void check_certified(const Certificate& c)
{
  for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
  {
    const Condition condition = static_cast<Condition>(i);
    test_support::Scope scope(Certificate::name(condition));
    CHECK(c.worst_violation(condition) <= Certificate::default_tolerance);
    if(c.worst_violation(condition) == 0)
    {
      CHECK(c.worst_vertex(condition) == boost::graph_traits<Mesh>::null_vertex());
    }
  }
  CHECK(c.is_certified());
}

template <class Sources>
Certificate certificate_of_right_distances(Mesh& tm, const Sources& sources, const Options& options = Options())
{
  Distance_map map = add_distances(tm);
  SMG::geodesic_distances(tm, map, sources, parameters_of(options));
  return SMG::certify_geodesic_distances(tm, map, sources, certificate_parameters_of(options));
}

// Returns the number of vertices with a finite distance.
std::size_t number_reached(const Mesh& tm, const Distance_map& map)
{
  std::size_t n = 0;
  for(const auto v : vertices(tm))
  {
    n += std::isfinite(map[v]);
  }
  return n;
}

void right_distances_are_certified(std::uint64_t seed)
{
  test_support::Random random(seed);
  std::size_t number_of_meshes = 0;
  double worst = 0;
  for(const Indexed_mesh& indexed : collection(seed))
  {
    test_support::Scope scope(indexed.name);
    Mesh tm = to_face_graph(indexed);
    const vertex_descriptor v = random_vertex(tm, random);
    const Certificate from_vertex = certificate_of_right_distances(tm, v);
    check_certified(from_vertex);
    const std::size_t reached = number_reached(tm, add_distances(tm));
    CHECK_EQUAL(from_vertex.number_of_checks(Condition::REACH), num_vertices(tm));
    CHECK_EQUAL(from_vertex.number_of_checks(Condition::SOURCES), std::size_t(1));
    CHECK_EQUAL(from_vertex.number_of_checks(Condition::PATHS), reached);
    CHECK_EQUAL(from_vertex.number_of_checks(Condition::LOWER_BOUNDS), reached);
    CHECK(from_vertex.number_of_checks(Condition::PROOF) > num_faces(tm) / 3);

    const std::vector<Face_location> locations = {random_location(tm, random), random_location(tm, random),
                                                  location_of_vertex(v, faces_around(v, tm).front(), tm)};
    Options options;
    options.source_offsets = {0.125, 0., 0.25};
    const Certificate from_locations = certificate_of_right_distances(tm, locations, options);
    check_certified(from_locations);
    worst = (std::max)(worst, (std::max)(from_vertex.worst_violation(), from_locations.worst_violation()));
    ++number_of_meshes;
  }
  CHECK(number_of_meshes >= 15);
  std::cout << number_of_meshes << " meshes, worst violation " << worst << std::endl;
}

void edge_lengths_are_certified(std::uint64_t seed)
{
  test_support::Scope scope("edge lengths");
  test_support::Random random(seed);
  for(const Indexed_mesh& indexed : {torus(2., 1., 12, 8), octahedron(), flat_patch(6, 6, .2, true, seed)})
  {
    Mesh tm = to_face_graph(indexed);
    auto lengths = add_edge_lengths(tm);
    for(const auto e : edges(tm)) // lengths of another surface than that of the points
    {
      lengths[e] = random.uniform(1., 1.9);
    }
    Distance_map map = add_distances(tm);
    const vertex_descriptor source = random_vertex(tm, random);
    SMG::geodesic_distances_from_edge_lengths(tm, lengths, map, source);
    check_certified(SMG::certify_geodesic_distances_from_edge_lengths(tm, lengths, map, source));
    CHECK(!SMG::certify_geodesic_distances(tm, map, source).is_certified());
  }
}

void distances_up_to_a_radius_are_certified()
{
  test_support::Scope scope("radius");
  Mesh tm = to_face_graph(icosphere(2));
  Options options;
  options.maximum_distance = 1.;
  Distance_map map = add_distances(tm);
  SMG::geodesic_distances(tm, map, vertex(0), parameters_of(options));
  CHECK(number_reached(tm, map) < num_vertices(tm));
  check_certified(SMG::certify_geodesic_distances(tm, map, vertex(0), certificate_parameters_of(options)));
  const Certificate without_radius = SMG::certify_geodesic_distances(tm, map, vertex(0));
  CHECK(without_radius.worst_violation(Condition::REACH) == infinity);
  // A distance that exceeds the radius is wrong, and so is a missing distance within it.
  SMG::geodesic_distances(tm, map, vertex(0));
  CHECK(SMG::certify_geodesic_distances(tm, map, vertex(0)).is_certified());
  CHECK(!SMG::certify_geodesic_distances(tm, map, vertex(0), certificate_parameters_of(options)).is_certified());
  SMG::geodesic_distances(tm, map, vertex(0), parameters_of(options));
  const auto nearest = *std::min_element(vertices(tm).begin(), vertices(tm).end(),
                                         [&](vertex_descriptor a, vertex_descriptor b)
  { return (map[a] > 0 ? map[a] : infinity) < (map[b] > 0 ? map[b] : infinity); });
  map[nearest] = infinity;
  const Certificate missing = SMG::certify_geodesic_distances(tm, map, vertex(0), certificate_parameters_of(options));
  CHECK(missing.worst_violation(Condition::PATHS) == infinity);
  CHECK(missing.worst_vertex(Condition::PATHS) == nearest);
}

void special_cases_are_certified()
{
  test_support::Scope scope("special cases");
  Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
  check_certified(certificate_of_right_distances(tm, vertex(0)));
  check_certified(certificate_of_right_distances(tm, std::vector<vertex_descriptor>()));
  Mesh empty;
  check_certified(certificate_of_right_distances(empty, std::vector<vertex_descriptor>()));
  // another source is nearer to this one
  Options options;
  options.source_offsets = {0., 100.};
  Mesh cubes = to_face_graph(cube_grid(3));
  const std::vector<vertex_descriptor> sources = {vertex(0), vertex(20)};
  check_certified(certificate_of_right_distances(cubes, sources, options));

  // a mesh without indices, with distances in single precision
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Polyhedron polyhedron = to_face_graph<Polyhedron>(icosahedron());
  auto map = get(CGAL::dynamic_vertex_property_t<float>(), polyhedron);
  const auto source = *vertices(polyhedron).begin();
  SMG::geodesic_distances(polyhedron, map, source);
  CHECK(SMG::certify_geodesic_distances(polyhedron, map, source, CGAL::parameters::number_of_iterations(2))
          .is_certified(1e-6));
  CHECK(!SMG::certify_geodesic_distances(polyhedron, map, source).is_certified(1e-10));
  CHECK_EQUAL(SMG::certify_geodesic_distances(polyhedron, map, source, CGAL::parameters::number_of_iterations(2))
                .number_of_checks(SMG::Geodesic_distance_certificate<Polyhedron>::Condition::REVERSE),
              std::size_t(2));
}

// The same surface in other units, and far from the origin.
void meshes_of_all_scales_are_certified()
{
  test_support::Scope scope("scales");
  const Indexed_mesh indexed = noisy_sphere(2, .1, 5);
  Mesh tm = to_face_graph(indexed);
  const Certificate expected = certificate_of_right_distances(tm, vertex(3));
  for(const double factor : {0x1p-500, 0x1p+500, 1e-150, 1e-9, 1e9, 1e150})
  {
    Mesh other = to_face_graph(scaled(indexed, factor));
    const Certificate c = certificate_of_right_distances(other, vertex(3));
    check_certified(c);
    if(factor == 0x1p-500 || factor == 0x1p+500)
    {
      CHECK_EQUAL(c.worst_violation(), expected.worst_violation());
    }
    Distance_map map = add_distances(other);
    map[vertex(11)] *= 1 + 1e-9;
    CHECK(SMG::certify_geodesic_distances(other, map, vertex(3)).worst_vertex(Condition::PATHS) == vertex(11));
  }
  Indexed_mesh moved = indexed;
  for(Coordinates& p : moved.points)
  {
    p = p + Coordinates{1e6, -1e6, 1e6};
  }
  Mesh far_away = to_face_graph(moved);
  check_certified(certificate_of_right_distances(far_away, vertex(3)));
}

// Needles and caps of all heights, and nearly equal vertices. The distances of vertices are right. The function that
// proves this may be inaccurate between nearly equal vertices.
void hostile_meshes_are_certified(std::size_t number, std::uint64_t seed)
{
  test_support::Scope scope("hostile meshes");
  test_support::Random random(seed);
  std::size_t number_of_meshes = 0, number_certified = 0;
  double worst = 0;
  while(number_of_meshes < number)
  {
    const Indexed_mesh indexed = hostile_meshes::hostile_mesh(random);
    Mesh tm;
    if(!hostile_meshes::is_surface(indexed, tm))
    {
      continue;
    }
    test_support::Scope mesh_scope("mesh " + std::to_string(number_of_meshes) + ", " + indexed.name);
    const Certificate c = certificate_of_right_distances(tm, random_vertex(tm, random));
    for(const Condition condition : {Condition::REACH, Condition::SOURCES, Condition::EDGES, Condition::PAIRS_OF_FACES,
                                     Condition::PATHS, Condition::LOWER_BOUNDS, Condition::REVERSE})
    {
      test_support::Scope condition_scope(Certificate::name(condition));
      CHECK(c.worst_violation(condition) <= Certificate::default_tolerance);
    }
    CHECK(c.worst_violation(Condition::PROOF) <= 1e-8);
    worst = (std::max)(worst, c.worst_violation());
    number_certified += c.is_certified();
    ++number_of_meshes;
  }
  CHECK(number_certified * 100 >= 99 * number_of_meshes);
  std::cout << number_certified << " of " << number_of_meshes << " hostile meshes certified, worst violation " << worst
            << std::endl;
}

// A fault: how it changes a distance, and which conditions then name the vertex.
struct Fault
{
  std::string name;
  std::function<double(double)> spoil;
  std::vector<Condition> conditions;
};

std::vector<Fault> faults()
{
  return {{"too long by 1e-9", [](double d) { return d * (1 + 1e-9); }, {Condition::PATHS, Condition::LOWER_BOUNDS}},
          {"too short by 1e-9", [](double d) { return d * (1 - 1e-9); }, {Condition::PATHS}},
          {"far too short", [](double d) { return d / 2; }, {Condition::PATHS}},
          {"zero", [](double) { return 0.; }, {Condition::PATHS}},
          {"far too long", [](double d) { return 3 * d; },
           {Condition::PATHS, Condition::LOWER_BOUNDS, Condition::EDGES}},
          {"negative", [](double d) { return -d; }, {Condition::REACH, Condition::PATHS}},
          {"not a number", [](double) { return std::numeric_limits<double>::quiet_NaN(); },
           {Condition::REACH, Condition::PATHS, Condition::LOWER_BOUNDS, Condition::EDGES}},
          {"infinite", [](double) { return infinity; },
           {Condition::REACH, Condition::PATHS, Condition::LOWER_BOUNDS, Condition::EDGES}}};
}

void each_fault_is_found_at_its_vertex(std::uint64_t seed)
{
  test_support::Scope scope("faults");
  test_support::Random random(seed);
  std::size_t number_of_faults = 0;
  for(const Indexed_mesh& indexed : small_collection(seed))
  {
    test_support::Scope mesh_scope(indexed.name);
    Mesh tm = to_face_graph(indexed);
    const vertex_descriptor source = random_vertex(tm, random);
    Distance_map map = add_distances(tm);
    SMG::geodesic_distances(tm, map, source);
    for(const Fault& fault : faults())
    {
      test_support::Scope fault_scope(fault.name);
      const vertex_descriptor v = random_vertex(tm, random);
      const double right = map[v];
      if(v == source || !std::isfinite(right))
      {
        continue;
      }
      map[v] = fault.spoil(right);
      const Certificate c = SMG::certify_geodesic_distances(tm, map, source);
      CHECK(!c.is_certified());
      for(const Condition condition : fault.conditions)
      {
        test_support::Scope condition_scope(Certificate::name(condition));
        CHECK(c.worst_violation(condition) > Certificate::default_tolerance);
        CHECK(c.worst_vertex(condition) == v);
      }
      CHECK(c.worst_violation(Condition::PROOF) <= Certificate::default_tolerance);
      map[v] = right;
      ++number_of_faults;
    }
    CHECK(SMG::certify_geodesic_distances(tm, map, source).is_certified());
  }
  CHECK(number_of_faults >= 40);
  std::cout << number_of_faults << " faults at single vertices" << std::endl;
}

// A torus with two sources, the right distances, and a map with wrong ones.
struct Torus_with_faults
{
  Torus_with_faults()
    : tm(to_face_graph(torus(2., 1., 16, 10))), map(add_distances(tm)), sources({vertex(0), vertex(37)})
  {
    SMG::geodesic_distances(tm, map, sources);
    right = values_at_vertices(tm, map);
  }

  void restore()
  {
    for(const auto v : vertices(tm))
    {
      map[v] = right[v];
    }
  }

  Certificate certificate() const { return SMG::certify_geodesic_distances(tm, map, sources); }

  Mesh tm;
  Distance_map map;
  std::vector<vertex_descriptor> sources;
  std::vector<double> right;
};

void exchanged_distances_are_found()
{
  test_support::Scope scope("exchanged distances");
  Torus_with_faults torus;
  CHECK(torus.certificate().is_certified());
  const vertex_descriptor a = vertex(50), b = vertex(93);
  CHECK(std::abs(torus.map[a] - torus.map[b]) > 1e-3);
  std::swap(torus.map[a], torus.map[b]);
  const Certificate c = torus.certificate();
  CHECK(c.worst_violation(Condition::PATHS) > 1e-6);
  CHECK(c.worst_vertex(Condition::PATHS) == a || c.worst_vertex(Condition::PATHS) == b);
}

void wrong_scale_is_found()
{
  test_support::Scope scope("wrong scale");
  Torus_with_faults torus;
  for(const double factor : {1 + 1e-9, 1 - 1e-9, 0., 2.})
  {
    for(const auto v : vertices(torus.tm))
    {
      torus.map[v] *= factor;
    }
    const Certificate c = torus.certificate();
    CHECK(c.worst_violation(Condition::PATHS) > 1e-10);
    CHECK(c.worst_violation(Condition::REVERSE) > 1e-10);
    CHECK((c.worst_violation(Condition::LOWER_BOUNDS) > 1e-10) == (factor > 1));
    CHECK((c.worst_violation(Condition::EDGES) > 1e-10) == (factor > 1));
    torus.restore();
  }
}

// The map has the distances from one of two sources, or the call of the certifier lacks a source.
void missing_source_is_found()
{
  test_support::Scope scope("missing source");
  Torus_with_faults torus;
  SMG::geodesic_distances(torus.tm, torus.map, vertex(0));
  const Certificate c = torus.certificate();
  CHECK(c.worst_violation(Condition::SOURCES) > 1e-3);
  CHECK(c.worst_vertex(Condition::SOURCES) == vertex(37));
  CHECK(c.worst_violation(Condition::LOWER_BOUNDS) > 1e-3);
  torus.restore();
  CHECK(SMG::certify_geodesic_distances(torus.tm, torus.map, vertex(0)).worst_vertex(Condition::PATHS) == vertex(37));
}

void distances_along_edges_are_found()
{
  test_support::Scope scope("distances along edges");
  Torus_with_faults torus;
  const Mesh& tm = torus.tm;
  std::vector<double> along_edges(num_vertices(tm), infinity);
  along_edges[0] = along_edges[37] = 0;
  for(std::size_t i = 0; i < num_vertices(tm); ++i)
  {
    for(const auto h : halfedges(tm))
    {
      const double length = std::sqrt((tm.point(source(h, tm)) - tm.point(target(h, tm))).squared_length());
      along_edges[target(h, tm)] = (std::min)(along_edges[target(h, tm)], along_edges[source(h, tm)] + length);
    }
  }
  for(const auto v : vertices(tm))
  {
    torus.map[v] = along_edges[v];
  }
  const Certificate c = torus.certificate();
  CHECK(c.worst_violation(Condition::EDGES) <= Certificate::default_tolerance);
  CHECK(c.worst_violation(Condition::PAIRS_OF_FACES) > 1e-3);
  CHECK(c.worst_violation(Condition::LOWER_BOUNDS) > 1e-3);
}

// An error that is negligible in one component may be as large as another component.
void faults_in_small_components_are_found()
{
  test_support::Scope scope("small component");
  Indexed_mesh both = flat_patch(6, 6, .2, true, 3);
  const Indexed_mesh other = flat_patch(6, 6, .2, true, 4);
  const std::size_t n = both.points.size();
  for(const Coordinates& p : other.points)
  {
    both.points.push_back(1e20 * (p + Coordinates{0., 0., 5.}));
  }
  for(const Triangle& t : other.faces)
  {
    both.faces.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  Mesh tm = to_face_graph(both);
  Distance_map map = add_distances(tm);
  SMG::geodesic_distances(tm, map, vertex(0));
  check_certified(SMG::certify_geodesic_distances(tm, map, vertex(0)));
  for(const double factor : {2., .5, 0.})
  {
    for(std::size_t v = 0; v < n; ++v)
    {
      map[vertex(v)] *= factor;
    }
    CHECK(!SMG::certify_geodesic_distances(tm, map, vertex(0)).is_certified());
    SMG::geodesic_distances(tm, map, vertex(0));
  }
}

// Sources with an offset beyond the radius reach nothing, not even their own vertices.
void sources_beyond_the_radius_are_certified()
{
  test_support::Scope scope("offset beyond the radius");
  Mesh tm = to_face_graph(noisy_sphere(2, .2, 5));
  Distance_map map = add_distances(tm);
  const std::vector<vertex_descriptor> sources{vertex(0), vertex(50)};
  Options options;
  options.source_offsets = {0., 3.5};
  options.maximum_distance = .5;
  SMG::geodesic_distances(tm, map, sources, parameters_of(options));
  CHECK(map[vertex(50)] == infinity);
  check_certified(SMG::certify_geodesic_distances(tm, map, sources, certificate_parameters_of(options)));
  options.source_offsets = {0., .25};
  CHECK(!SMG::certify_geodesic_distances(tm, map, sources, certificate_parameters_of(options)).is_certified());
}

// A visitor that is passed by value is copied.
void visitors_may_be_values()
{
  test_support::Scope scope("visitor by value");
  Mesh tm = to_face_graph(icosphere(1));
  Distance_map map = add_distances(tm);
  SMG::Geodesic_default_visitor visitor;
  SMG::geodesic_distances(tm, map, vertex(0), CGAL::parameters::visitor(SMG::Geodesic_default_visitor()));
  SMG::geodesic_distances(tm, map, vertex(0), CGAL::parameters::visitor(visitor));
  SMG::geodesic_distances(tm, map, vertex(0), CGAL::parameters::visitor(std::ref(visitor)));
  check_certified(SMG::certify_geodesic_distances(tm, map, vertex(0), CGAL::parameters::visitor(visitor)));
}

// Cancels at its n-th call of go_further().
struct Canceling_visitor : SMG::Geodesic_default_visitor
{
  explicit Canceling_visitor(std::size_t n) : calls_left(n) {}

  void on_propagation_begin(std::size_t n)
  {
    CHECK_EQUAL(n, number_of_vertices);
    ++begun;
    visits = 0;
    distance = 0;
  }

  void on_progress(std::size_t v, double d)
  {
    ++progressed;
    CHECK(v >= visits && d >= distance && d <= largest_distance * (1 + 1e-12));
    visits = v;
    distance = d;
  }

  bool go_further()
  {
    CHECK(calls_left > 0); // it is not asked again
    ++calls;
    return --calls_left > 0;
  }

  void on_propagation_end() { ++ended; }

  std::size_t calls_left, calls = 0, progressed = 0, begun = 0, ended = 0, visits = 0, number_of_vertices = 0;
  double distance = 0, largest_distance = infinity;
};

void canceled_checks_prove_nothing()
{
  test_support::Scope scope("visitor");
  Mesh tm = to_face_graph(transformed(noisy_sphere(2, .2, 5), "scaled", [](const Coordinates& c) { return 100. * c; }));
  Distance_map map = add_distances(tm);
  SMG::geodesic_distances(tm, map, vertex(0));
  const auto certify = [&](Canceling_visitor& visitor)
  {
    visitor.number_of_vertices = num_vertices(tm);
    return SMG::certify_geodesic_distances(tm, map, vertex(0), CGAL::parameters::visitor(std::ref(visitor)));
  };
  Canceling_visitor patient((std::numeric_limits<std::size_t>::max)());
  patient.largest_distance = 700;
  check_certified(certify(patient));
  CHECK_EQUAL(patient.begun, std::size_t(5)); // the proof, and four vertices in reverse
  CHECK_EQUAL(patient.ended, std::size_t(5));
  CHECK(patient.calls > num_vertices(tm) + 2 * num_faces(tm));
  for(std::size_t n = 1; n <= patient.calls; n += (std::max)(patient.calls / 40, std::size_t(1)))
  {
    test_support::Scope call_scope("call " + std::to_string(n));
    Canceling_visitor visitor(n);
    const Certificate c = certify(visitor);
    CHECK_EQUAL(visitor.calls, n);
    CHECK_EQUAL(visitor.begun, visitor.ended);
    CHECK_EQUAL(c.worst_violation(), infinity);
    CHECK_EQUAL(c.worst_violation(Condition::REVERSE), infinity);
    CHECK_EQUAL(visitor.progressed, visitor.calls);
    CHECK(c.worst_violation(Condition::EDGES) <= Certificate::default_tolerance);
  }
}

// More reverse runs than vertices start at each vertex once.
void each_vertex_starts_one_reverse_run_at_most()
{
  test_support::Scope scope("reverse runs");
  Mesh tm = to_face_graph(octahedron());
  Distance_map map = add_distances(tm);
  SMG::geodesic_distances(tm, map, vertex(0));
  for(std::size_t v = 0; v < num_vertices(tm); ++v)
  {
    const double right = map[vertex(v)];
    map[vertex(v)] = right * 1.01 + .01;
    const Certificate c
      = SMG::certify_geodesic_distances(tm, map, vertex(0), CGAL::parameters::number_of_iterations(1000));
    CHECK_EQUAL(c.number_of_checks(Condition::REVERSE), num_vertices(tm));
    CHECK(c.worst_vertex(Condition::REVERSE) == vertex(v));
    map[vertex(v)] = right;
  }
}

void invalid_input_throws()
{
  test_support::Scope scope("invalid input");
  Mesh tm = to_face_graph(octahedron());
  Distance_map map = add_distances(tm);
  CHECK(throws_reason(Reason::INVALID_DESCRIPTOR, [&] { SMG::certify_geodesic_distances(tm, map, vertex(100)); }));
  Options options;
  options.source_offsets = {1., 2.};
  const auto np = certificate_parameters_of(options);
  CHECK(throws_reason(Reason::INVALID_OFFSET, [&] { SMG::certify_geodesic_distances(tm, map, vertex(0), np); }));
  tm.point(vertex(3)) = Kernel::Point_3(0, 0, infinity);
  CHECK(throws_reason(Reason::NON_FINITE_POINT, [&] { SMG::certify_geodesic_distances(tm, map, vertex(0)); }));
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260701);
  right_distances_are_certified(seed);
  edge_lengths_are_certified(seed);
  distances_up_to_a_radius_are_certified();
  special_cases_are_certified();
  meshes_of_all_scales_are_certified();
  hostile_meshes_are_certified(1000, seed);
  each_fault_is_found_at_its_vertex(seed);
  exchanged_distances_are_found();
  wrong_scale_is_found();
  missing_source_is_found();
  distances_along_edges_are_found();
  faults_in_small_components_are_found();
  sources_beyond_the_radius_are_certified();
  visitors_may_be_values();
  canceled_checks_prove_nothing();
  each_vertex_starts_one_reverse_run_at_most();
  invalid_input_throws();
  return test_result();
}
