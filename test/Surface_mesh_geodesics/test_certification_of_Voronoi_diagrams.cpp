// Right diagrams are certified, on meshes of all kinds, with and without weights. Each fault is found, and the
// certificate names its site.

#include "Voronoi_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_certifier.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Location_separation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace test_meshes;

namespace {

namespace SMG = CGAL::Surface_mesh_geodesics;
using Certificate = SMG::Geodesic_Voronoi_certificate;
using Condition = Certificate::Condition;

// Only a check makes a certificate.
static_assert(!std::is_default_constructible<Certificate>::value, "a certificate without a check");
static_assert(std::is_copy_constructible<Certificate>::value && std::is_copy_assignable<Certificate>::value,
              "a certificate is a value");

void check_certified(const Certificate& c)
{
  for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
  {
    const Condition condition = static_cast<Condition>(i);
    test_support::Scope scope(Certificate::name(condition));
    CHECK(c.worst_violation(condition) <= Certificate::default_tolerance);
    if(c.worst_violation(condition) == 0)
    {
      CHECK_EQUAL(c.worst_site(condition), Certificate::null_site());
    }
  }
  CHECK(c.is_certified());
}

void right_diagrams_are_certified(std::uint64_t seed)
{
  test_support::Random random(seed);
  double worst = 0;
  std::size_t number_of_diagrams = 0;
  for(const Indexed_mesh& indexed : collection(seed))
  {
    test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    for(const double largest_weight : {0., .5})
    {
      Voronoi diagram(tm);
      add_sites(diagram, random_sites(tm, 2 + random.index(6), largest_weight, random));
      const Certificate c = SMG::certify_geodesic_Voronoi_diagram(diagram);
      check_certified(c);
      CHECK_EQUAL(c.number_of_checks(Condition::ARCS), 14 * diagram.arcs().size());
      CHECK(c.number_of_checks(Condition::OWNERS) >= num_faces(tm) / 4);
      CHECK(c.number_of_checks(Condition::AREAS) >= diagram.number_of_sites() + 1);
      worst = (std::max)(worst, c.worst_violation());
      ++number_of_diagrams;
    }
  }
  CHECK(number_of_diagrams >= 30);
  std::cout << number_of_diagrams << " diagrams, worst violation " << worst << std::endl;
}

void special_cases_are_certified(std::uint64_t seed)
{
  test_support::Scope scope("special cases");
  test_support::Random random(seed);
  {
    const Mesh tm = to_face_graph(octahedron());
    Voronoi diagram(tm);
    check_certified(SMG::certify_geodesic_Voronoi_diagram(diagram)); // no sites
    diagram.add_site(vertex(0));
    check_certified(SMG::certify_geodesic_Voronoi_diagram(diagram)); // no arcs
    diagram.add_site(vertex(0));
    diagram.add_site(vertex(3), 100.);
    check_certified(SMG::certify_geodesic_Voronoi_diagram(diagram)); // empty cells
    check_certified(SMG::certify_geodesic_Voronoi_diagram(diagram, CGAL::parameters::vertex_point_map(tm.points())));
    CHECK(diagram.is_empty(0));
  }
  {
    const Mesh tm = to_face_graph(two_components_and_an_isolated_vertex());
    Voronoi diagram(tm);
    diagram.add_site(vertex(0));
    diagram.add_site(vertex(5));
    diagram.add_site(vertex(num_vertices(tm) - 1)); // a component is not reached
    check_certified(SMG::certify_geodesic_Voronoi_diagram(diagram));
  }
  {
    Mesh tm = to_face_graph(torus(2., 1., 12, 8));
    auto lengths = add_edge_lengths(tm);
    for(const auto e : edges(tm))
    {
      lengths[e] = random.uniform(1., 1.9);
    }
    Voronoi diagram(tm);
    diagram.use_edge_lengths(lengths);
    add_sites(diagram, random_sites(tm, 5, 0., random));
    check_certified(SMG::certify_geodesic_Voronoi_diagram_from_edge_lengths(diagram, lengths));
    CHECK(!SMG::certify_geodesic_Voronoi_diagram(diagram).is_certified(1e-3));
  }
}

// An arc with changed points and distances.
struct Moved_arc
{
  Voronoi::Arc arc;
  double shift_of_points, shift_of_distance;

  std::pair<std::size_t, std::size_t> sites() const { return arc.sites(); }
  double distance(double t) const { return arc.distance(t) + shift_of_distance; }

  Face_location point(double t) const
  {
    Face_location l = arc.point(t);
    std::array<double, 3> b = {l.second[0], l.second[1], l.second[2]};
    const std::size_t k = static_cast<std::size_t>(std::max_element(b.begin(), b.end()) - b.begin());
    b[k] -= shift_of_points;
    b[(k + 1) % 3] += shift_of_points;
    return {l.first, {b[0], b[1], b[2]}};
  }
};

// A diagram with wrong answers. An answer that concerns a single site is wrong for the site `culprit`.
struct Wrong_diagram : Voronoi
{
  using Voronoi::Voronoi;

  std::size_t culprit = 0;
  double shift_of_weight = 0., shift_of_points = 0., shift_of_distance = 0., factor_of_area = 1.;
  vertex_descriptor vertex_of_culprit = boost::graph_traits<Mesh>::null_vertex();
  std::function<void(std::vector<Boundary>&)> spoil_boundary;

  double weight(std::size_t i) const { return Voronoi::weight(i) + (i == culprit ? shift_of_weight : 0.); }
  double area(std::size_t i) const { return Voronoi::area(i) * (i == culprit ? factor_of_area : 1.); }

  std::size_t nearest_site(vertex_descriptor v) const
  {
    return v == vertex_of_culprit ? culprit : Voronoi::nearest_site(v);
  }
  std::size_t nearest_site(const Face_location& l) const { return Voronoi::nearest_site(l); }

  std::vector<Arc> arcs(face_descriptor f) const { return Voronoi::arcs(f); }
  std::vector<Moved_arc> arcs() const
  {
    std::vector<Moved_arc> result;
    for(const Arc& a : Voronoi::arcs())
    {
      const bool is_moved = a.sites().first == culprit || a.sites().second == culprit;
      result.push_back({a, is_moved ? shift_of_points : 0., is_moved ? shift_of_distance : 0.});
    }
    return result;
  }

  std::vector<Boundary> boundary(std::size_t i) const
  {
    std::vector<Boundary> result = Voronoi::boundary(i);
    if(i == culprit && spoil_boundary)
    {
      spoil_boundary(result);
    }
    return result;
  }
};

Certificate certificate_of(const Wrong_diagram& diagram, const Mesh& tm)
{
  const auto length = [&](halfedge_descriptor h)
  { return std::sqrt((tm.point(target(h, tm)) - tm.point(source(h, tm))).squared_length()); };
  using Point_map = Mesh::Property_map<vertex_descriptor, Kernel::Point_3>;
  using Separation = SMG::internal::Separation_in_space<Wrong_diagram, Point_map>;
  const auto vertex_index_map = get(boost::vertex_index, tm);
  SMG::internal::Diagram_certifier<Wrong_diagram, decltype(vertex_index_map), decltype(length), Separation>
    certifier(diagram, vertex_index_map, length, Separation(diagram, tm.points()));
  return SMG::internal::Private_access::make<Certificate>(
    certifier.run([&] { return std::make_unique<Geodesic_paths>(tm); }));
}

void check_violated(const Certificate& c, Condition condition, std::size_t culprit)
{
  test_support::Scope scope(Certificate::name(condition));
  CHECK(!c.is_certified());
  CHECK(c.worst_violation(condition) > Certificate::default_tolerance);
  CHECK_EQUAL(c.worst_site(condition), culprit);
}

void wrong_distances_are_found(Wrong_diagram& diagram, const Mesh& tm)
{
  const std::size_t i = diagram.culprit;
  diagram.shift_of_weight = 1e-8;
  check_violated(certificate_of(diagram, tm), Condition::ARCS, i);
  check_violated(certificate_of(diagram, tm), Condition::OWNERS, i);
  check_violated(certificate_of(diagram, tm), Condition::NEAREST, i);
  diagram.shift_of_weight = 0.;

  diagram.shift_of_points = 1e-6;
  CHECK(certificate_of(diagram, tm).worst_violation(Condition::ARCS) > Certificate::default_tolerance);
  diagram.shift_of_points = 0.;
  diagram.shift_of_distance = 1e-8;
  CHECK(certificate_of(diagram, tm).worst_violation(Condition::ARCS) > Certificate::default_tolerance);
  diagram.shift_of_distance = 0.;
}

void wrong_areas_are_found(Wrong_diagram& diagram, const Mesh& tm)
{
  diagram.factor_of_area = 1. + 1e-6;
  CHECK(certificate_of(diagram, tm).worst_violation(Condition::AREAS) > Certificate::default_tolerance);
  diagram.factor_of_area = -1.;
  CHECK(certificate_of(diagram, tm).worst_violation(Condition::AREAS) > Certificate::default_tolerance);
  diagram.factor_of_area = 1.;
}

void wrong_owners_are_found(Wrong_diagram& diagram, const Mesh& tm)
{
  const std::size_t i = diagram.culprit;
  const auto range = vertices(tm);
  diagram.vertex_of_culprit = *std::find_if(range.begin(), range.end(), [&](vertex_descriptor v)
  { return static_cast<const Voronoi&>(diagram).nearest_site(v) != i; });
  check_violated(certificate_of(diagram, tm), Condition::OWNERS, i);
  diagram.vertex_of_culprit = boost::graph_traits<Mesh>::null_vertex();
}

void wrong_boundaries_are_found(Wrong_diagram& diagram, const Mesh& tm)
{
  using Boundaries = std::vector<Voronoi::Boundary>;
  const std::vector<std::function<void(Boundaries&)>> spoils
    = {[](Boundaries& b) { b.clear(); },
       [](Boundaries& b) { b.push_back(b.front()); },
       [](Boundaries& b) { b.front().is_closed = !b.front().is_closed; },
       [](Boundaries& b) { b.front().edges.front().second = !b.front().edges.front().second; },
       [](Boundaries& b) { b.front().edges.push_back(b.front().edges.front()); }};
  for(std::size_t k = 0; k < spoils.size(); ++k)
  {
    test_support::Scope spoil_scope("boundary " + std::to_string(k));
    diagram.spoil_boundary = spoils[k];
    CHECK(certificate_of(diagram, tm).worst_violation(Condition::BOUNDARIES) > 1e-3);
  }
  diagram.spoil_boundary = nullptr;
}

void each_fault_is_found(const Indexed_mesh& indexed, std::uint64_t seed)
{
  test_support::Scope scope(indexed.name);
  test_support::Random random(seed);
  const Mesh tm = to_face_graph(indexed);
  Wrong_diagram diagram(tm);
  add_sites(diagram, random_sites(tm, 6, .1, random));
  check_certified(certificate_of(diagram, tm));
  for(std::size_t i = 0; i < 6; ++i)
  {
    test_support::Scope site_scope("site " + std::to_string(i));
    diagram.culprit = i;
    if(diagram.boundary(i).empty())
    {
      continue;
    }
    wrong_distances_are_found(diagram, tm);
    wrong_areas_are_found(diagram, tm);
    wrong_owners_are_found(diagram, tm);
    wrong_boundaries_are_found(diagram, tm);
  }
  check_certified(certificate_of(diagram, tm));
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20260702);
  right_diagrams_are_certified(seed);
  special_cases_are_certified(seed);
  each_fault_is_found(icosphere(2), seed);
  each_fault_is_found(saddle_patch(10), seed + 1);
  each_fault_is_found(torus(2., 1., 12, 8), seed + 2);
  // A fault in a component that is much smaller than the other one.
  each_fault_is_found(side_by_side(icosphere(2), scaled(regular_tetrahedron(), 1e9), "small and large"), seed + 3);
  return test_result();
}
