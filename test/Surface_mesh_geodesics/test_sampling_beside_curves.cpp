// Samples that keep away from curves: each is the vertex that is farthest from all curves and samples before, by the
// distances of geodesic_distances(), and in a square by the distance from its border.

#include "curve_cases.h"
#include "expected_exceptions.h"
#include "hostile_meshes.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;
using SMG::Invalid_geodesic_input;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The distances of all vertices from curves and samples, and the largest one of a vertex that has a face.
std::map<vertex_descriptor, double> distances_from(const Mesh& tm, std::vector<Curve> sites,
                                                   const std::vector<vertex_descriptor>& samples, double& largest)
{
  for(const vertex_descriptor v : samples)
    sites.push_back(Curve(tm, std::vector<vertex_descriptor>{v}));
  std::map<vertex_descriptor, double> d;
  SMG::geodesic_distances(tm, boost::make_assoc_property_map(d), sites);
  largest = 0;
  for(const vertex_descriptor v : vertices(tm))
    if(!tm.is_isolated(v))
      largest = (std::max)(largest, d[v]);
  return d;
}

// Each sample is a farthest vertex, up to rounding, which decides ties; the radius is that of the last ones.
void check_samples(const Mesh& tm, const std::vector<Curve>& curves, std::size_t n)
{
  const double size = size_of(tm);
  std::vector<vertex_descriptor> samples;
  double radius = 0;
  try
  {
    radius = SMG::geodesic_farthest_point_sampling(tm, n, std::back_inserter(samples), np::first_curves(curves));
  }
  catch(const Invalid_geodesic_input& error)
  {
    CHECK(error.reason() == Invalid_geodesic_input::Reason::INVALID_CURVE);
    CHECK(samples.empty());
    return;
  }
  std::vector<vertex_descriptor> before;
  double largest = 0;
  for(const vertex_descriptor v : samples)
  {
    const auto d = distances_from(tm, curves, before, largest);
    CHECK(largest == infinite ? d.at(v) == infinite : d.at(v) >= largest - 1e-11 * size);
    before.push_back(v);
  }
  distances_from(tm, curves, samples, largest);
  CHECK(largest == infinite ? radius == infinite : std::abs(radius - largest) <= 1e-11 * size);
  CHECK(samples.size() == n || radius <= 1e-11 * size);
}

void samples_on_surfaces()
{
  {
    const test_support::Scope scope("sphere");
    const Mesh tm = to_face_graph(noisy_sphere(3, .1, 2));
    for(std::uint64_t seed = 1; seed <= 4; ++seed)
    {
      test_support::Random random(seed);
      check_samples(tm, random_curves(tm, random), 12);
    }
  }
  for(std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    const test_support::Scope scope("hostile " + std::to_string(seed));
    test_support::Random random(seed);
    Mesh tm;
    if(hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), tm))
      check_samples(tm, random_curves(tm, random), 5);
  }
}

// The first sample is the center of the largest circle in the square, as far as there are vertices.
void samples_in_a_square()
{
  const test_support::Scope scope("square");
  const double size = 20;
  const Mesh tm = to_face_graph(flat_patch(20, 20, .3, true, 1));
  const std::vector<Curve> border = SMG::border_curves(tm);
  std::vector<vertex_descriptor> samples;
  const double radius = SMG::geodesic_farthest_point_sampling(tm, 10, std::back_inserter(samples),
                                                              np::first_curves(border));
  CHECK_EQUAL(samples.size(), std::size_t(10));
  const auto distance = [&](vertex_descriptor v, std::size_t number)
  {
    const auto p = tm.point(v);
    double d = (std::min)({p.x(), size - p.x(), p.y(), size - p.y()});
    for(std::size_t i = 0; i < number; ++i)
      d = (std::min)(d, std::sqrt(CGAL::squared_distance(p, tm.point(samples[i]))));
    return d;
  };
  for(std::size_t i = 0; i <= samples.size(); ++i)
  {
    double largest = 0;
    for(const vertex_descriptor v : vertices(tm))
      largest = (std::max)(largest, distance(v, i));
    CHECK_NEAR(i < samples.size() ? distance(samples[i], i) : radius, largest, 1e-13 * size);
  }
  // One curve instead of a range, by reference; and the border counts for the radius at which sampling ends.
  std::vector<vertex_descriptor> again;
  CHECK_EQUAL(SMG::geodesic_farthest_point_sampling(tm, 10, std::back_inserter(again),
                                                    np::first_curves(std::cref(border[0]))), radius);
  CHECK(again == samples);
  again.clear();
  CHECK_NEAR(SMG::geodesic_farthest_point_sampling(tm, 10, std::back_inserter(again),
                                                   np::first_curves(border).covering_radius(10.5)),
             distance(samples[0], 0), 1e-13 * size);
  CHECK(again.empty());
}

// Samples that are there already are counted, curves are not.
void first_samples()
{
  const test_support::Scope scope("first samples");
  const Mesh tm = to_face_graph(flat_patch(12, 12, .3, true, 4));
  const std::vector<Curve> border = SMG::border_curves(tm);
  std::vector<vertex_descriptor> all, rest;
  SMG::Propagation_statistics statistics;
  const double radius
    = SMG::geodesic_farthest_point_sampling(tm, 8, std::back_inserter(all), np::first_curves(border));
  const std::vector<vertex_descriptor> first(all.begin(), all.begin() + 3);
  CHECK_NEAR(SMG::geodesic_farthest_point_sampling(
               tm, 8, std::back_inserter(rest),
               np::first_curves(border).first_samples(first).statistics(&statistics)), radius, 1e-12);
  CHECK(rest == std::vector<vertex_descriptor>(all.begin() + 3, all.end()));
  CHECK(statistics.windows_created > 0);
  // No curves: the samples are the usual ones.
  std::vector<vertex_descriptor> usual, without;
  CHECK_EQUAL(SMG::geodesic_farthest_point_sampling(tm, 6, std::back_inserter(usual)),
              SMG::geodesic_farthest_point_sampling(tm, 6, std::back_inserter(without),
                                                    np::first_curves(std::vector<Curve>())));
  CHECK(usual == without && usual.size() == 6);
  // Around faces to avoid: a slot on the way from one side of the border to the other.
  std::vector<face_descriptor> avoided;
  for(const face_descriptor f : faces(tm))
  {
    const auto p = tm.point(target(halfedge(f, tm), tm));
    if(p.x() > 4 && p.x() < 6 && p.y() > 2 && p.y() < 10)
      avoided.push_back(f);
  }
  std::vector<vertex_descriptor> around;
  SMG::geodesic_farthest_point_sampling(tm, 4, std::back_inserter(around),
                                        np::first_curves(border).faces_to_avoid(avoided));
  std::map<vertex_descriptor, double> d;
  std::vector<Curve> sites = border;
  for(const vertex_descriptor v : around)
  {
    SMG::geodesic_distances(tm, boost::make_assoc_property_map(d), sites, np::faces_to_avoid(avoided));
    for(const vertex_descriptor u : vertices(tm))
      CHECK(d[u] == infinite || d[u] <= d[v] + 1e-12);
    sites.push_back(Curve(tm, std::vector<vertex_descriptor>{v}));
  }
}

struct Canceling_visitor : SMG::Geodesic_default_visitor
{
  void on_propagation_begin(std::size_t) { ++begun; }
  bool go_further() const { return begun < most; }
  int begun = 0, most = 0;
};

void bad_input_and_ends()
{
  const test_support::Scope scope("bad input");
  const Mesh tm = to_face_graph(flat_patch(6, 6, .3, true, 1)), large = to_face_graph(flat_patch(30, 30, .3, true, 1));
  const std::vector<Curve> other = SMG::border_curves(large), border = SMG::border_curves(tm);
  std::vector<vertex_descriptor> samples;
  const auto sample = [&](const auto& parameters)
  { return SMG::geodesic_farthest_point_sampling(tm, 5, std::back_inserter(samples), parameters); };
  CHECK(throws<Invalid_geodesic_input>([&] { sample(np::first_curves(other)); }));
  CHECK(throws<Invalid_geodesic_input>([&] { sample(np::first_curves(border).covering_radius(-1)); }));
  CHECK(throws<Invalid_geodesic_input>(
    [&] { sample(np::first_curves(border).first_samples(std::vector<vertex_descriptor>{vertex_descriptor(7777)})); }));
  CHECK(samples.empty());
  // The first propagation is that of the curves, and each sample has another one.
  Canceling_visitor visitor;
  visitor.most = 1;
  CHECK_EQUAL(sample(np::first_curves(border).visitor(std::ref(visitor))), infinite);
  CHECK(samples.empty());
  visitor.begun = 0;
  visitor.most = 3;
  sample(np::first_curves(border).visitor(std::ref(visitor)));
  CHECK_EQUAL(samples.size(), std::size_t(1));
  CHECK_EQUAL(visitor.begun, 3);
}

} // namespace

int main()
{
  samples_in_a_square();
  first_samples();
  samples_on_surfaces();
  bad_input_and_ends();
  return test_result();
}
