// Right diagrams of curves are certified, distances and whole arcs included, and faults are found: between the points
// at which arcs are sampled, too. test_certification_of_Voronoi_diagrams.cpp does the same for points.

#include "Voronoi_test_helpers.h"
#include "curve_cases.h"
#include "hostile_meshes.h"
#include "test_meshes.h"
#include "test_support.h"
#include "wrong_Voronoi_diagram.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

using namespace curve_cases;

namespace {

using Condition = Certificate::Condition;

// Random curves, and sometimes a point among them, with and without weights.
void add_random_sites(Voronoi& diagram, std::uint64_t seed, test_support::Random& random)
{
  const Mesh& tm = diagram.triangle_mesh();
  for(const Curve& c : random_curves(tm, random))
    diagram.add_site(c, seed % 3 == 0 ? random.uniform() / 4 : 0.);
  diagram.add_site(random_curve(tm, random));
  if(seed % 4 == 0)
    diagram.add_site(random_vertex(tm, random));
}

// The areas of needles have half of the digits.
double tolerance(Condition condition, bool is_hostile)
{
  return is_hostile && condition == Condition::AREAS ? 0x1p-26 : Certificate::default_tolerance;
}

void right_diagrams_are_certified()
{
  std::size_t number = 0, number_of_curved = 0, not_certified = 0;
  for(std::uint64_t seed = 201; seed <= 260; ++seed)
  {
    const test_support::Scope scope(std::to_string(seed));
    test_support::Random random(seed);
    const bool is_hostile = seed % 2 == 0;
    Mesh tm;
    if(!is_hostile)
    {
      const std::vector<Indexed_mesh> meshes = small_collection(seed);
      tm = to_face_graph(meshes[random.index(meshes.size())]);
    }
    else if(!hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), tm))
      continue;
    Voronoi diagram(tm);
    try
    {
      add_random_sites(diagram, seed, random);
      diagram.build();
    }
    catch(const CGAL::Surface_mesh_geodesics::Invalid_geodesic_input&) // segments that nearly coincide
    {
      continue;
    }
    const Certificate c = SMG::certify_geodesic_Voronoi_diagram(diagram);
    bool is_certified = true;
    for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
    {
      const Condition condition = static_cast<Condition>(i);
      const test_support::Scope condition_scope(Certificate::name(condition));
      is_certified = is_certified && c.worst_violation(condition) <= tolerance(condition, is_hostile);
      CHECK(is_hostile || is_certified);
    }
    not_certified += is_certified ? 0 : 1;
    CHECK(c.number_of_checks(Condition::DISTANCES) > num_vertices(tm));
    CHECK(c.number_of_checks(Condition::CURVES) >= diagram.arcs().size());
    ++number;
    for(const auto& arc : diagram.arcs())
      number_of_curved += arc.is_segment() ? 0 : 1;
  }
  CHECK(number > 50 && number_of_curved > 300 && not_certified <= 1);
  std::cout << number << " diagrams, " << number_of_curved << " curved arcs" << std::endl;
}

struct Faulty
{
  explicit Faulty(const Indexed_mesh& indexed, std::uint64_t seed)
    : random(seed), tm(to_face_graph(indexed)), diagram(tm)
  {
    for(int i = 0; i < 3; ++i)
      diagram.add_site(Curve(tm, random_locations(tm, 4, random)));
    diagram.add_site(random_vertex(tm, random));
    CHECK(certificate_of(diagram).is_certified());
  }

  test_support::Random random;
  const Mesh tm;
  Wrong_diagram diagram;
};

void faults_are_found(const Indexed_mesh& indexed, std::uint64_t seed)
{
  const test_support::Scope scope(indexed.name);
  Faulty faulty(indexed, seed);
  Wrong_diagram& diagram = faulty.diagram;
  for(const double factor : {1 - 1e-9, 1 + 1e-9})
  {
    diagram.factor_of_distance = factor;
    CHECK(certificate_of(diagram).worst_violation(Condition::DISTANCES) > Certificate::default_tolerance);
    diagram.factor_of_distance = 1;
  }
  diagram.shift_of_weight = 1e-8;
  CHECK(certificate_of(diagram).worst_violation(Condition::DISTANCES) > Certificate::default_tolerance);
  CHECK(certificate_of(diagram).worst_violation(Condition::NEAREST) > Certificate::default_tolerance);
  diagram.shift_of_weight = 0;
  diagram.shift_of_points = 1e-6;
  CHECK(certificate_of(diagram).worst_violation(Condition::ARCS) > 1e-9);
  diagram.shift_of_points = 0;
  // Parabolas that are taken for segments are no arcs.
  diagram.are_arcs_straight = true;
  CHECK(certificate_of(diagram).worst_violation(Condition::CURVES) > 1e-9);
  diagram.are_arcs_straight = false;
  CHECK(certificate_of(diagram).is_certified());
}

// A site with a tiny cell between two samples of an arc, which the diagram has overlooked: a point, or a short curve.
// No sample of an arc shows it.
void hidden_sites_are_found(const Indexed_mesh& indexed, std::uint64_t seed)
{
  const test_support::Scope scope(indexed.name + ", hidden");
  Faulty faulty(indexed, seed);
  Wrong_diagram& diagram = faulty.diagram;
  std::size_t number = 0;
  const auto arcs = diagram.Voronoi::arcs();
  for(std::size_t a = 0; a < arcs.size(); a += 1 + arcs.size() / 16)
  {
    if(arcs[a].length() < .02 || arcs[a].distance(.25) < .02)
      continue;
    const auto place = [&](double t)
    {
      const auto l = arcs[a].point(t);
      return Location(l.first, {l.second[0], l.second[1], l.second[2]});
    };
    const Curve curve(faulty.tm, std::vector<Location>{place(.249), place(.251)});
    diagram.has_hidden_site = true;
    diagram.hidden_site = arcs[a].point(.25);
    diagram.hidden_curve = a % 2 == 0 ? &curve : nullptr;
    diagram.hidden_weight = -arcs[a].distance(.25) + 1e-2 * arcs[a].length();
    const Certificate c = certificate_of(diagram);
    CHECK(c.worst_violation(Condition::CURVES) > 1e-5);
    CHECK(c.worst_violation(Condition::NEAREST) > 1e-5); // the site itself is a sample
    number += c.worst_violation(Condition::ARCS) <= Certificate::default_tolerance ? 1 : 0;
    diagram.has_hidden_site = false;
    diagram.hidden_curve = nullptr;
  }
  CHECK(number > 3);
}

// A curve that another one crosses twice, like a V, in one face. The diagram has lost the part of its cell between the
// crossings, with all arcs around it: it belongs to the V.
struct Diagram_without_part : Voronoi
{
  Diagram_without_part(const Mesh& tm, std::size_t corner) : Voronoi(tm), corner_of_x(corner), paths_to_V(tm) {}

  bool is_between(const Face_location& l) const { return l.second[corner_of_x] > .31 && l.second[corner_of_x] < .33; }
  bool is_lost(const Face_location& l) const { return is_between(l) && Voronoi::nearest_site(l) == 0; }

  std::size_t nearest_site(vertex_descriptor v) const { return Voronoi::nearest_site(v); }
  std::size_t nearest_site(const Face_location& l) const { return is_lost(l) ? 1 : Voronoi::nearest_site(l); }
  double distance_to_nearest_site(vertex_descriptor v) const { return Voronoi::distance_to_nearest_site(v); }
  double distance_to_nearest_site(const Face_location& l) const
  {
    return is_lost(l) ? paths_to_V.shortest_distance_to_source_points(l.first, l.second).first
                      : Voronoi::distance_to_nearest_site(l);
  }

  std::vector<Arc> arcs(face_descriptor) const { return arcs(); }
  std::vector<Arc> arcs() const
  {
    std::vector<Arc> result;
    for(const Arc& a : Voronoi::arcs())
      if(!is_between(a.point(.5)))
        result.push_back(a);
    return result;
  }

  std::size_t corner_of_x;
  mutable Paths paths_to_V;
};

void lost_part_of_curve_is_found()
{
  const test_support::Scope scope("part between crossings");
  Mesh tm;
  const auto a = tm.add_vertex({0, 0, 0}), b = tm.add_vertex({1, 0, 0}), c = tm.add_vertex({0, 1, 0});
  const face_descriptor f = tm.add_face(a, b, c);
  const auto place = [&](double x, double y)
  {
    Location l(f, {0, 0, 0});
    auto h = halfedge(f, tm);
    for(std::size_t k = 0; k < 3; ++k, h = next(h, tm))
      l.second[k] = source(h, tm) == a ? 1 - x - y : source(h, tm) == b ? x : y;
    return l;
  };
  const Curve straight(tm, std::vector<Location>{place(.2, .3), place(.68, .3)});
  const Curve V(tm, std::vector<Location>{place(.3, .35), place(.32, .25), place(.34, .35)});
  const Location at_b = place(1, 0);
  Diagram_without_part diagram(tm, at_b.second[0] == 1 ? 0 : at_b.second[1] == 1 ? 1 : 2);
  diagram.add_site(straight);
  diagram.add_site(V);
  diagram.paths_to_V.add_source_curve(V);
  CHECK(certificate_of(static_cast<const Voronoi&>(diagram)).is_certified());
  const Certificate c_of_part = certificate_of(diagram);
  CHECK(c_of_part.worst_violation(Condition::NEAREST) > 1e-3);
  CHECK(c_of_part.worst_violation(Condition::ARCS) <= Certificate::default_tolerance);
  CHECK(c_of_part.worst_violation(Condition::CURVES) <= Certificate::default_tolerance);
}

} // namespace

int main()
{
  right_diagrams_are_certified();
  faults_are_found(saddle_patch(6), 1);
  faults_are_found(torus(2., 1., 12, 8), 2);
  hidden_sites_are_found(saddle_patch(6), 3);
  hidden_sites_are_found(icosphere(1), 4);
  lost_part_of_curve_is_found();
  return test_result();
}
