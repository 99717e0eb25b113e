// Right diagrams are certified, on meshes of all kinds, with and without weights. Each fault is found, and the
// certificate names its site.

#include "Voronoi_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"
#include "wrong_Voronoi_diagram.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_certifier.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Location_separation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
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

void check_violated(const Certificate& c, Condition condition, std::size_t culprit)
{
  test_support::Scope scope(Certificate::name(condition));
  CHECK(!c.is_certified());
  CHECK(c.worst_violation(condition) > Certificate::default_tolerance);
  CHECK_EQUAL(c.worst_site(condition), culprit);
}

void wrong_distances_are_found(Wrong_diagram& diagram)
{
  const std::size_t i = diagram.culprit;
  diagram.shift_of_weight = 1e-8;
  check_violated(certificate_of(diagram), Condition::ARCS, i);
  check_violated(certificate_of(diagram), Condition::OWNERS, i);
  check_violated(certificate_of(diagram), Condition::NEAREST, i);
  diagram.shift_of_weight = 0.;

  diagram.shift_of_points = 1e-6;
  CHECK(certificate_of(diagram).worst_violation(Condition::ARCS) > Certificate::default_tolerance);
  diagram.shift_of_points = 0.;
  diagram.shift_of_distance = 1e-8;
  CHECK(certificate_of(diagram).worst_violation(Condition::ARCS) > Certificate::default_tolerance);
  diagram.shift_of_distance = 0.;
}

// All distances are shrunk or grown.
void wrong_fields_are_found(Wrong_diagram& diagram)
{
  for(const double sign : {-1., 1.})
  {
    test_support::Scope scope(sign > 0 ? "grown" : "shrunk");
    diagram.factor_of_distance = 1. + sign * 1e-9;
    const Certificate c = certificate_of(diagram);
    CHECK(c.worst_violation(Condition::DISTANCES) > Certificate::default_tolerance);
    CHECK(c.worst_violation(Condition::ARCS) > Certificate::default_tolerance);
  }
  diagram.factor_of_distance = 1.;
}

void wrong_vertices_are_found(Wrong_diagram& diagram)
{
  for(const double shift : {-1e-9, 1e-9})
  {
    diagram.shift_of_vertices = shift;
    CHECK(diagram.vertices().empty()
          || certificate_of(diagram).worst_violation(Condition::VERTICES) > Certificate::default_tolerance);
  }
  diagram.shift_of_vertices = 0.;
}

void wrong_arcs_are_found(Wrong_diagram& diagram)
{
  diagram.missing_arc = diagram.boundary(diagram.culprit).front().edges.front().first.arcs().front().first.index();
  CHECK(certificate_of(diagram).worst_violation(Condition::BOUNDARIES) == infinity);
  diagram.missing_arc = Voronoi::null_site();

  // An arc of the culprit names a site that has no arc with it.
  std::vector<bool> is_neighbor(diagram.number_of_sites(), false);
  for(const auto& arc : diagram.Voronoi::arcs())
  {
    const auto sites = arc.sites();
    if(sites.first == diagram.culprit || sites.second == diagram.culprit)
    {
      is_neighbor[sites.first] = is_neighbor[sites.second] = true;
    }
  }
  const auto other = std::find(is_neighbor.begin(), is_neighbor.end(), false);
  if(other == is_neighbor.end())
  {
    return;
  }
  diagram.site_of_arcs = static_cast<std::size_t>(other - is_neighbor.begin());
  CHECK(certificate_of(diagram).worst_violation(Condition::ARCS) > 1e-6);
  diagram.site_of_arcs = Voronoi::null_site();
}

void wrong_areas_are_found(Wrong_diagram& diagram)
{
  diagram.factor_of_area = 1. + 1e-6;
  CHECK(certificate_of(diagram).worst_violation(Condition::AREAS) > Certificate::default_tolerance);
  diagram.factor_of_area = -1.;
  CHECK(certificate_of(diagram).worst_violation(Condition::AREAS) > Certificate::default_tolerance);
  diagram.factor_of_area = 1.;
}

void wrong_owners_are_found(Wrong_diagram& diagram, const Mesh& tm)
{
  const std::size_t i = diagram.culprit;
  const auto range = vertices(tm);
  diagram.vertex_of_culprit = *std::find_if(range.begin(), range.end(), [&](vertex_descriptor v)
  { return static_cast<const Voronoi&>(diagram).nearest_site(v) != i; });
  check_violated(certificate_of(diagram), Condition::OWNERS, i);
  diagram.vertex_of_culprit = boost::graph_traits<Mesh>::null_vertex();
}

void wrong_boundaries_are_found(Wrong_diagram& diagram)
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
    CHECK(certificate_of(diagram).worst_violation(Condition::BOUNDARIES) > 1e-3);
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
  check_certified(certificate_of(diagram));
  wrong_fields_are_found(diagram);
  for(std::size_t i = 0; i < 6; ++i)
  {
    test_support::Scope site_scope("site " + std::to_string(i));
    diagram.culprit = i;
    if(diagram.boundary(i).empty())
    {
      continue;
    }
    wrong_distances_are_found(diagram);
    wrong_vertices_are_found(diagram);
    wrong_arcs_are_found(diagram);
    wrong_areas_are_found(diagram);
    wrong_owners_are_found(diagram, tm);
    wrong_boundaries_are_found(diagram);
  }
  check_certified(certificate_of(diagram));
}

// A site with a tiny cell between two samples of an arc, which the diagram has overlooked. No sample of an arc shows
// it.
void hidden_sites_are_found(const Indexed_mesh& indexed, std::uint64_t seed)
{
  test_support::Scope scope("hidden sites");
  test_support::Random random(seed);
  const Mesh tm = to_face_graph(indexed);
  Wrong_diagram diagram(tm);
  add_sites(diagram, random_sites(tm, 4, 0., random));
  std::size_t number = 0;
  const auto arcs = diagram.Voronoi::arcs();
  for(std::size_t a = 0; a < arcs.size(); a += 1 + arcs.size() / 12)
  {
    if(arcs[a].length() < 0.01)
    {
      continue;
    }
    diagram.has_hidden_site = true;
    diagram.hidden_site = arcs[a].point(0.25);
    diagram.hidden_weight = -arcs[a].distance(0.25) + 1e-3 * arcs[a].length();
    const Certificate c = certificate_of(diagram);
    CHECK(c.worst_violation(Condition::CURVES) > 1e-6);
    CHECK(c.worst_violation(Condition::NEAREST) > 1e-6); // the site itself is a sample
    number += c.worst_violation(Condition::ARCS) <= Certificate::default_tolerance ? 1 : 0;
    diagram.has_hidden_site = false;
  }
  CHECK(number >= 5);
}

// Arcs that are called straight, and are not.
void straight_arcs_are_found(const Indexed_mesh& indexed, std::uint64_t seed)
{
  test_support::Scope scope("straight arcs");
  test_support::Random random(seed);
  const Mesh tm = to_face_graph(indexed);
  Wrong_diagram diagram(tm);
  add_sites(diagram, random_sites(tm, 5, .3, random));
  check_certified(certificate_of(diagram));
  diagram.are_arcs_straight = true;
  CHECK(certificate_of(diagram).worst_violation(Condition::CURVES) > 1e-6);
}

// Of two sites at one point, the first one has the cell.
void lost_ties_are_found(const Indexed_mesh& indexed)
{
  test_support::Scope scope("ties");
  const Mesh tm = to_face_graph(indexed);
  Wrong_diagram diagram(tm);
  for(const std::size_t v : {0u, 0u, 5u})
  {
    diagram.add_site(vertex(v));
  }
  check_certified(certificate_of(diagram));
  diagram.is_tie_lost = true;
  const Certificate c = certificate_of(diagram);
  CHECK(c.worst_violation(Condition::OWNERS) == infinity);
  CHECK_EQUAL(c.worst_site(Condition::OWNERS), 1u);
  CHECK(c.worst_violation(Condition::DISTANCES) <= Certificate::default_tolerance);
}

// Answers that are rounded to float violate conditions by that rounding.
void diagrams_of_float_are_certified()
{
  test_support::Scope scope("kernel of float");
  using Float_kernel = CGAL::Simple_cartesian<float>;
  using Float_mesh = CGAL::Surface_mesh<Float_kernel::Point_3>;
  Float_mesh tm;
  add_to_face_graph(noisy_sphere(2, .05, 7), tm);
  CGAL::Surface_mesh_geodesic_Voronoi_diagram<CGAL::Surface_mesh_shortest_path_traits<Float_kernel, Float_mesh>>
    diagram(tm);
  for(unsigned int i = 0; i < 6; ++i)
    diagram.add_site(vertex_descriptor(20 * i));
  const Certificate certificate = SMG::certify_geodesic_Voronoi_diagram(diagram);
  std::cout << "kernel of float: worst violation " << certificate.worst_violation() << std::endl;
  CHECK(certificate.is_certified(0x1p-20));
  CHECK(!certificate.is_certified());
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
  hidden_sites_are_found(icosphere(2), seed + 4);
  hidden_sites_are_found(saddle_patch(10), seed + 5);
  straight_arcs_are_found(torus(2., 1., 12, 8), seed + 6);
  lost_ties_are_found(icosphere(2));
  diagrams_of_float_are_certified();
  return test_result();
}
