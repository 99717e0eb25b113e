// Certification of distances from curves: right distances are certified, those that a formula gives and those that the
// package computes; wrong ones are refused. test_certification_of_distances.cpp does the same for points.

#include "curve_cases.h"
#include "curves_in_plane.h"
#include "expected_exceptions.h"
#include "hostile_meshes.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;

namespace {

using Certificate = SMG::Geodesic_distance_certificate<Mesh>;
using Condition = Certificate::Condition;
using edge_descriptor = Mesh::Edge_index;
using Distance_map = Mesh::Property_map<vertex_descriptor, double>;

Distance_map add_distances(Mesh& tm) { return tm.add_property_map<vertex_descriptor, double>("v:distance", 0.).first; }

void check_certified(const Certificate& c)
{
  for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
  {
    const test_support::Scope scope(Certificate::name(static_cast<Condition>(i)));
    // A curve that runs beside all vertices is the source of none.
    CHECK(c.number_of_checks(static_cast<Condition>(i)) > 0 || static_cast<Condition>(i) == Condition::SOURCES);
    CHECK(c.worst_violation(static_cast<Condition>(i)) <= Certificate::default_tolerance);
  }
}

bool is_reported(const Certificate& c, Condition condition, vertex_descriptor v)
{
  return c.worst_violation(condition) > 1e-8 && c.worst_vertex(condition) == v;
}

// --- distances that a formula gives: the certificate has nothing to compare them with but its own proof ---

// Certifies the distances distance(point); with one of them, or all, wrong by 1e-6 they are refused.
template <typename Distance>
void check_formula(Mesh& tm, const std::vector<Curve>& curves, const Distance& distance)
{
  Distance_map map = add_distances(tm);
  for(const vertex_descriptor v : vertices(tm))
    map[v] = distance(tm.point(v));
  const Certificate right = SMG::certify_geodesic_distances(tm, map, curves);
  check_certified(right);
  CHECK(right.worst_violation() < 1e-13);
  CHECK_EQUAL(right.number_of_checks(Condition::PATHS), num_vertices(tm));
  std::size_t number = 0;
  for(const vertex_descriptor v : vertices(tm))
  {
    const double d = map[v];
    if(!(d > .01) || v.idx() % 7 != 0)
      continue;
    ++number;
    map[v] = d * (1 + 1e-6);
    const Certificate too_long = SMG::certify_geodesic_distances(tm, map, curves);
    CHECK(is_reported(too_long, Condition::LOWER_BOUNDS, v) && is_reported(too_long, Condition::PATHS, v));
    CHECK(too_long.worst_violation(Condition::PROOF) < 1e-13);
    map[v] = d * (1 - 1e-6);
    const Certificate too_short = SMG::certify_geodesic_distances(tm, map, curves);
    CHECK(is_reported(too_short, Condition::PATHS, v));
    CHECK(too_short.worst_violation(Condition::LOWER_BOUNDS) < 1e-13);
    map[v] = d;
  }
  CHECK(number > 1);
}

double distance_to_polyline(const Kernel::Point_3& p, const std::vector<Point_2>& corners)
{
  double d = infinity;
  for(std::size_t i = 1; i < corners.size(); ++i)
    d = (std::min)(d, distance_to_segment({p.x(), p.y()}, corners[i - 1], corners[i]));
  return d;
}

Curve polyline_in_plane(const Mesh& tm, const std::vector<Point_2>& corners)
{
  std::vector<Location> locations;
  for(std::size_t i = 1; i < corners.size(); ++i)
    append_crossings(tm, corners[i - 1], corners[i], locations);
  locations.push_back(location_in_plane(corners.back()[0], corners.back()[1], tm));
  return Curve(tm, locations);
}

void polylines_in_the_plane_are_certified()
{
  Mesh tm = to_face_graph(flat_patch(5, 5, .15, true, 3));
  {
    const test_support::Scope scope("border");
    check_formula(tm, SMG::border_curves(tm), [](const Kernel::Point_3& p)
    { return (std::min)({p.x(), 5 - p.x(), p.y(), 5 - p.y()}); });
  }
  // A segment; one that is run along there and back; a polyline with blunt and sharp corners; one that crosses itself.
  const std::vector<std::vector<Point_2>> polylines
    = {{{1.23, 1.34}, {3.87, 3.41}},
       {{1.23, 1.34}, {3.87, 3.41}, {1.23, 1.34}},
       {{.53, .61}, {3.31, 1.17}, {2.93, 4.19}, {2.71, .83}, {4.61, 4.37}},
       {{.77, .71}, {4.13, 4.43}, {4.39, .87}, {.83, 4.11}, {.77, .71}}};
  for(const std::vector<Point_2>& corners : polylines)
  {
    const test_support::Scope scope(std::to_string(corners.size()) + " corners");
    check_formula(tm, {polyline_in_plane(tm, corners)},
                  [&](const Kernel::Point_3& p) { return distance_to_polyline(p, corners); });
  }
  // Curves that touch and cross, among them one that is a point.
  check_formula(tm, {polyline_in_plane(tm, polylines[0]), polyline_in_plane(tm, polylines[3]),
                     Curve(tm, location_in_plane(.21, 4.77, tm))},
                [&](const Kernel::Point_3& p)
  {
    return (std::min)({distance_to_polyline(p, polylines[0]), distance_to_polyline(p, polylines[3]),
                       std::hypot(p.x() - .21, p.y() - 4.77)});
  });
}

void developable_surfaces_are_certified()
{
  {
    const test_support::Scope scope("prism");
    Mesh tm = to_face_graph(prism_tube(7, 4, 1., 3.));
    check_formula(tm, SMG::border_curves(tm),
                  [](const Kernel::Point_3& p) { return (std::min)(p.z(), 3 - p.z()); });
  }
  {
    // The rim of one side of a cube. Its points see the others along the edges, or straight across.
    const test_support::Scope scope("cube");
    Mesh tm = to_face_graph(cube_grid(4));
    std::vector<vertex_descriptor> rim;
    const auto add = [&](double x, double y)
    {
      for(const vertex_descriptor v : vertices(tm))
        if(tm.point(v) == Kernel::Point_3(x, y, 0))
          rim.push_back(v);
    };
    for(int i = 0; i < 16; ++i)
    {
      const int side = i / 4, t = i % 4;
      add(side == 0 ? t : side == 1 ? 4 : side == 2 ? 4 - t : 0,
          side == 0 ? 0 : side == 1 ? t : side == 2 ? 4 : 4 - t);
    }
    check_formula(tm, {Curve(tm, rim, true)}, [](const Kernel::Point_3& p)
    {
      const double to_side = (std::min)({p.x(), 4 - p.x(), p.y(), 4 - p.y()});
      return p.z() == 0 || p.z() == 4 ? p.z() + to_side : p.z();
    });
  }
}

// --- distances that the package computes ---

void hostile_meshes_are_certified()
{
  const test_support::Scope scope("hostile meshes");
  std::size_t number = 0, not_certified = 0;
  for(std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    const test_support::Scope seed_scope(std::to_string(seed));
    test_support::Random random(seed);
    Mesh tm;
    if(!hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), tm))
      continue;
    const std::vector<Curve> curves = random_curves(tm, random);
    std::vector<double> offsets;
    for(std::size_t i = 0; seed % 3 == 0 && i < curves.size(); ++i)
      offsets.push_back(random.uniform() / 4);
    Distance_map map = add_distances(tm);
    try
    {
      SMG::geodesic_distances(tm, map, curves, np::source_offsets(offsets));
    }
    catch(const SMG::Invalid_geodesic_input&) // segments that nearly coincide
    {
      continue;
    }
    const Certificate c = SMG::certify_geodesic_distances(tm, map, curves, np::source_offsets(offsets));
    for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
    {
      const bool is_proof = static_cast<Condition>(i) == Condition::PROOF;
      CHECK(c.worst_violation(static_cast<Condition>(i)) <= (is_proof ? 1e-8 : Certificate::default_tolerance));
    }
    ++number;
    not_certified += c.is_certified() ? 0 : 1;
  }
  CHECK(number > 190 && 100 * not_certified <= number);
}

// On surfaces that bend both ways, paths from curves bend at vertices, too. A computed distance that is changed, a
// curve or a segment that is left out, and another offset are found.
void faults_are_found(const Indexed_mesh& indexed, std::uint64_t seed)
{
  const test_support::Scope scope(indexed.name);
  test_support::Random random(seed);
  Mesh tm = to_face_graph(indexed);
  Distance_map map = add_distances(tm);
  const std::vector<Location> locations = random_locations(tm, 8, random);
  const std::vector<Curve> curves{Curve(tm, locations), Curve(tm, random_vertices_along_edges(tm, 3, random)),
                                  Curve(tm, random_vertex(tm, random))};
  const std::vector<double> offsets{0., .0625, .03125};
  SMG::geodesic_distances(tm, map, curves, np::source_offsets(offsets));
  const auto certificate
    = [&] { return SMG::certify_geodesic_distances(tm, map, curves, np::source_offsets(offsets)); };
  check_certified(certificate());
  for(int i = 0; i < 8; ++i)
  {
    const vertex_descriptor v = random_vertex(tm, random);
    const double d = map[v];
    if(!(d > 1e-3))
      continue;
    map[v] = d * (1 + 1e-6);
    CHECK(is_reported(certificate(), Condition::LOWER_BOUNDS, v));
    map[v] = d * (1 - 1e-6);
    CHECK(is_reported(certificate(), Condition::PATHS, v));
    map[v] = std::numeric_limits<double>::quiet_NaN();
    CHECK(!certificate().is_certified());
    map[v] = d;
  }
  const auto check_refused = [&](const std::vector<Curve>& others, const std::vector<double>& other_offsets)
  {
    const Certificate c = SMG::certify_geodesic_distances(tm, map, others, np::source_offsets(other_offsets));
    // The distances are right from other sources: what does not fit is a path, or a bound.
    CHECK(c.worst_violation(Condition::PATHS) > 1e-6);
    CHECK(c.worst_violation(Condition::PROOF) <= Certificate::default_tolerance);
    CHECK(c.worst_violation(Condition::REVERSE) > 0);
  };
  std::vector<Location> shorter = locations;
  shorter.resize(4);
  check_refused({Curve(tm, shorter), curves[1], curves[2]}, offsets);
  check_refused(curves, {.001, .0625, .03125});
  // The other way around: distances from less than all curves are too long.
  SMG::geodesic_distances(tm, map, std::vector<Curve>{curves[1], curves[2]});
  const Certificate too_long = SMG::certify_geodesic_distances(tm, map, curves);
  CHECK(too_long.worst_violation(Condition::LOWER_BOUNDS) > 1e-6);
  CHECK(!(too_long.worst_violation(Condition::PROOF) > Certificate::default_tolerance));
}

// --- options ---

void options_are_those_of_the_distances()
{
  const test_support::Scope scope("options");
  test_support::Random random(5);
  Mesh tm = to_face_graph(saddle_patch(8));
  Distance_map map = add_distances(tm);
  const std::vector<Curve> curves{Curve(tm, random_locations(tm, 5, random))};

  SMG::geodesic_distances(tm, map, curves, np::maximum_distance(.5));
  CHECK(SMG::certify_geodesic_distances(tm, map, curves, np::maximum_distance(.5)).is_certified());
  CHECK(!SMG::certify_geodesic_distances(tm, map, curves).is_certified());

  std::vector<face_descriptor> avoided;
  std::vector<edge_descriptor> walls;
  const face_descriptor first = curves[0].segments()[0].face;
  for(const face_descriptor f : faces(tm))
    if(f != first && random.index(6) == 0)
      avoided.push_back(f);
  for(const edge_descriptor e : edges(tm))
    if(random.index(4) == 0)
      walls.push_back(e);
  const std::vector<Location> locations{{first, {.5, .25, .25}}, {first, {.125, .125, .75}}};
  const std::vector<Curve> inside{Curve(tm, locations)};
  SMG::geodesic_distances(tm, map, inside, np::faces_to_avoid(avoided).edges_to_avoid(walls));
  const auto around = SMG::certify_geodesic_distances(tm, map, inside,
                                                      np::faces_to_avoid(avoided).edges_to_avoid(walls));
  check_certified(around);
  CHECK(!SMG::certify_geodesic_distances(tm, map, inside).is_certified());
  const auto parallel = SMG::certify_geodesic_distances<CGAL::Parallel_if_available_tag>(
    tm, map, inside, np::faces_to_avoid(avoided).edges_to_avoid(walls).number_of_iterations(7));
  check_certified(parallel);
  CHECK_EQUAL(parallel.worst_violation(Condition::PROOF), around.worst_violation(Condition::PROOF));
  CHECK_EQUAL(parallel.number_of_checks(Condition::PROOF), around.number_of_checks(Condition::PROOF));

  // A single curve, in place of a range, and lengths without points. The side of a wall that a curve runs along.
  SMG::geodesic_distances(tm, map, curves[0]);
  check_certified(SMG::certify_geodesic_distances(tm, map, curves[0]));
  auto lengths = tm.add_property_map<edge_descriptor, double>("e:length", 0.).first;
  for(const edge_descriptor e : edges(tm))
    lengths[e] = std::sqrt(CGAL::squared_distance(tm.point(source(e, tm)), tm.point(target(e, tm))))
               * (1 + random.uniform() / 8);
  const Curve along(tm, random_vertices_along_edges(tm, 6, random));
  SMG::geodesic_distances_from_edge_lengths(tm, lengths, map, along, np::edges_to_avoid(walls));
  check_certified(
    SMG::certify_geodesic_distances_from_edge_lengths(tm, lengths, map, along, np::edges_to_avoid(walls)));
  CHECK(!SMG::certify_geodesic_distances_from_edge_lengths(tm, lengths, map, curves[0]).is_certified());

  CHECK(throws_reason(SMG::Invalid_geodesic_input::Reason::INVALID_OFFSET, [&]
  { SMG::certify_geodesic_distances(tm, map, curves, np::source_offsets(std::vector<double>{1., 2.})); }));
}

// A visitor that cancels after some visits: nothing is certified.
struct Canceling_visitor : SMG::Geodesic_default_visitor
{
  std::size_t number_of_calls = 0, last = 0;

  bool go_further() { return number_of_calls++ < last; }
};

void canceled_checks_prove_nothing()
{
  const test_support::Scope scope("cancel");
  Mesh tm = to_face_graph(saddle_patch(6));
  Distance_map map = add_distances(tm);
  const std::vector<Curve> curves = SMG::border_curves(tm);
  SMG::geodesic_distances(tm, map, curves);
  Canceling_visitor counting;
  counting.last = (std::numeric_limits<std::size_t>::max)();
  CHECK(SMG::certify_geodesic_distances(tm, map, curves, np::visitor(std::ref(counting))).is_certified());
  const std::size_t all = counting.number_of_calls;
  for(const std::size_t last : {std::size_t(0), all / 4, all / 2, all - 1})
  {
    Canceling_visitor visitor;
    visitor.last = last;
    CHECK(!SMG::certify_geodesic_distances(tm, map, curves, np::visitor(std::ref(visitor))).is_certified());
  }
}

} // namespace

int main()
{
  polylines_in_the_plane_are_certified();
  developable_surfaces_are_certified();
  hostile_meshes_are_certified();
  faults_are_found(saddle_patch(8), 1);
  faults_are_found(torus(2., 1., 14, 9), 2);
  faults_are_found(noisy_sphere(2, .1, 3), 3);
  options_are_those_of_the_distances();
  canceled_checks_prove_nothing();
  return test_result();
}
