// Relaxation of sites beside curves, which do not move: in the plane against Lloyd's method on a fine grid of points;
// on surfaces, also beside obstacles, each step against the diagram of curves and sites, and against distances.

#include "Voronoi_sites.h"
#include "curve_cases.h"
#include "curves_and_walls.h"
#include "distance_test_helpers.h"
#include "expected_exceptions.h"
#include "walls_and_places.h"
#include "with_threads.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <CGAL/tags.h>

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

using namespace test_meshes;
namespace SMG = CGAL::Surface_mesh_geodesics;
namespace np = CGAL::parameters;

namespace {

using Sites = std::vector<vertex_descriptor>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;
using Point = Kernel::Point_2;

struct Iterations : SMG::Geodesic_default_visitor
{
  void on_iteration(std::size_t, double, double energy) { energies.push_back(energy); }
  std::vector<double> energies;
};

template <typename NamedParameters>
Sites relaxed(const Mesh& tm, const Sites& sites, const NamedParameters& parameters)
{
  Sites moved;
  SMG::geodesic_Lloyd_relaxation(tm, sites, std::back_inserter(moved), parameters);
  CHECK_EQUAL(moved.size(), sites.size());
  return moved;
}

Point in_plane(const Mesh& tm, vertex_descriptor v) { return Point(tm.point(v).x(), tm.point(v).y()); }

vertex_descriptor nearest_vertex(const Mesh& tm, const Point& p)
{
  return *std::min_element(vertices(tm).begin(), vertices(tm).end(), [&](auto a, auto b)
  { return CGAL::squared_distance(in_plane(tm, a), p) < CGAL::squared_distance(in_plane(tm, b), p); });
}

// --- the plane ---

// The centroids of the cells of points among a grid of points, in a domain in which `distance_to_curve` is not
// negative; a point that is nearer to the curve is in no cell.
template <typename DistanceToCurve>
std::vector<Point> centroids(const std::vector<Point>& sites, double low, double high, const DistanceToCurve& to_curve)
{
  const std::size_t n = 160;
  std::vector<double> x(sites.size(), 0.), y(sites.size(), 0.), number(sites.size(), 0.);
  for(std::size_t k = 0; k < n * n; ++k)
  {
    const auto coordinate = [&](std::size_t i) { return low + (high - low) * (static_cast<double>(i) + .5) / n; };
    const Point p(coordinate(k / n), coordinate(k % n));
    double best = to_curve(p);
    std::size_t nearest = sites.size();
    for(std::size_t i = 0; i < sites.size(); ++i)
    {
      const double d = std::sqrt(CGAL::squared_distance(p, sites[i]));
      if(d < best)
      {
        best = d;
        nearest = i;
      }
    }
    if(nearest == sites.size())
      continue;
    x[nearest] += p.x();
    y[nearest] += p.y();
    number[nearest] += 1;
  }
  std::vector<Point> result;
  for(std::size_t i = 0; i < sites.size(); ++i)
    result.push_back(Point(x[i] / number[i], y[i] / number[i]));
  return result;
}

// One site goes to the middle of a square if the border is a curve, each step to the vertex nearest to the centroid.
void one_site_in_a_square()
{
  const test_support::Scope scope("square");
  const double size = 20;
  const Mesh tm = to_face_graph(flat_patch(20, 20, .15, true, 1));
  const std::vector<Curve> border = SMG::border_curves(tm);
  const auto to_border = [&](const Point& p) { return (std::min)({p.x(), size - p.x(), p.y(), size - p.y()}); };
  Sites site{nearest_vertex(tm, Point(3, 5))};
  for(int i = 0; i < 12; ++i)
  {
    const Point c = centroids({in_plane(tm, site[0])}, 0, size, to_border)[0];
    const Sites next = relaxed(tm, site, np::first_curves(border).number_of_iterations(1));
    CHECK(CGAL::squared_distance(in_plane(tm, next[0]), in_plane(tm, nearest_vertex(tm, c))) < .01 * .01
          || std::sqrt(CGAL::squared_distance(in_plane(tm, next[0]), c))
               < std::sqrt(CGAL::squared_distance(in_plane(tm, nearest_vertex(tm, c)), c)) + .02);
    site = next;
  }
  CHECK(CGAL::squared_distance(in_plane(tm, site[0]), Point(size / 2, size / 2)) < 1.5 * 1.5);
  // One curve instead of a range, by reference, and all iterations in one call.
  const Sites first{nearest_vertex(tm, Point(3, 5))};
  CHECK(relaxed(tm, first, np::first_curves(border).number_of_iterations(12)) == site);
  CHECK(relaxed(tm, first, np::first_curves(std::cref(border[0])).number_of_iterations(12)) == site);
}

// Three sites in a strip: between curves at its ends there are four equal gaps, without curves the outer two are half
// as wide as the inner ones. A site rests where its centroid is within half an edge: so much off that the second
// differences of positions are at most two edges.
void sites_in_a_strip()
{
  const test_support::Scope scope("strip");
  const double length = 120;
  const Mesh tm = to_face_graph(flat_patch(120, 2, 0, false, 1));
  std::vector<Sites> ends(2);
  for(const vertex_descriptor v : vertices(tm))
    for(std::size_t k = 0; k < 2; ++k)
      if(tm.point(v).x() == (k == 0 ? 0 : length))
        ends[k].push_back(v);
  const std::vector<Curve> curves{Curve(tm, ends[0]), Curve(tm, ends[1])};
  const Sites sites{nearest_vertex(tm, Point(13, 1)), nearest_vertex(tm, Point(22, 1)),
                    nearest_vertex(tm, Point(110, 1))};
  const Sites beside = relaxed(tm, sites, np::first_curves(curves).number_of_iterations(200));
  const Sites free = relaxed(tm, sites, np::number_of_iterations(200));
  for(std::size_t i = 0; i < 3; ++i)
  {
    CHECK_NEAR(tm.point(beside[i]).x(), length * (static_cast<double>(i) + 1) / 4, 4);
    CHECK_NEAR(tm.point(free[i]).x(), length * (2 * static_cast<double>(i) + 1) / 6, 4);
  }
}

Mesh flat_disk(std::size_t n)
{
  return to_face_graph(graph_patch(
    "disk", n, n,
    [n](std::size_t i, std::size_t j)
    {
      const double x = 2 * static_cast<double>(i) / static_cast<double>(n) - 1,
                   y = 2 * static_cast<double>(j) / static_cast<double>(n) - 1;
      return Coordinates{x * std::sqrt(1 - y * y / 2), y * std::sqrt(1 - x * x / 2), 0};
    },
    [n](std::size_t i, std::size_t j) { return (2 * i < n) == (2 * j < n); }));
}

// The mean distance from the unit circle.
double mean_gap(const std::vector<Point>& sites)
{
  double sum = 0;
  for(const Point& p : sites)
    sum += 1 - std::sqrt(CGAL::squared_distance(p, Point(0, 0)));
  return sum / static_cast<double>(sites.size());
}

// Seven sites in a disk are as far from its border as Lloyd's method on a grid of points tells.
void sites_in_a_disk()
{
  const test_support::Scope scope("disk");
  const Mesh tm = flat_disk(40);
  const std::vector<Curve> border = SMG::border_curves(tm);
  Sites sites;
  std::vector<Point> start;
  for(const Point& p : {Point(0, 0), Point(.8, 0), Point(.4, .7), Point(-.3, .7), Point(-.6, .1), Point(-.5, -.6),
                        Point(.4, -.6)})
  {
    sites.push_back(nearest_vertex(tm, p));
    start.push_back(in_plane(tm, sites.back()));
  }
  double gap[2];
  for(const bool has_curves : {false, true})
  {
    std::vector<Point> expected = start, found;
    for(int i = 0; i < 40; ++i)
      expected = centroids(expected, -1, 1, [&](const Point& p)
      {
        const double d = 1 - std::sqrt(CGAL::squared_distance(p, Point(0, 0)));
        return has_curves || d < 0 ? d : std::numeric_limits<double>::infinity();
      });
    for(const vertex_descriptor v :
        relaxed(tm, sites, np::first_curves(has_curves ? border : std::vector<Curve>()).number_of_iterations(40)))
      found.push_back(in_plane(tm, v));
    gap[has_curves] = mean_gap(found);
    CHECK_NEAR(mean_gap(found), mean_gap(expected), .05);
  }
  CHECK(gap[1] > 1.2 * gap[0]);
}

// --- surfaces ---

// The sum of the integrals of |p - s|^2 over the cells of the sites behind the curves, in the cut mesh.
double energy_of_cut(const Voronoi& voronoi, std::size_t number_of_curves, const Mesh& tm, const Sites& sites)
{
  Mesh cut;
  auto site = cut.add_property_map<face_descriptor, std::size_t>("f:site").first;
  voronoi.cut(cut, site, 1e-5);
  double sum = 0;
  for(const face_descriptor f : faces(cut))
  {
    if(site[f] < number_of_curves)
      continue;
    const auto s = tm.point(sites[site[f] - number_of_curves]);
    const auto h = halfedge(f, cut);
    const auto a = cut.point(source(h, cut)) - s, b = cut.point(target(h, cut)) - s,
               c = cut.point(target(next(h, cut), cut)) - s;
    sum += area_of_face(cut, f) / 12 * (a * a + b * b + c * c + (a + b + c) * (a + b + c));
  }
  return sum;
}

// Three iterations, each against the diagram of curves and sites. The energy is that of the cells of the sites, and the
// move of the sites does not raise it.
void steps_on_surfaces()
{
  for(std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    const test_support::Scope scope("sphere " + std::to_string(seed));
    test_support::Random random(seed);
    const Mesh tm = to_face_graph(noisy_sphere(2, .1, seed));
    std::vector<Curve> curves;
    while(curves.size() < 2) // curves of one location are points
    {
      const Curve curve = curve_cases::random_curve(tm, random);
      if(curve.segments().size() > 1)
        curves.push_back(curve);
    }
    Sites sites;
    for(int i = 0; i < 6; ++i)
      sites.push_back(random_vertex(tm, random));
    sites.push_back(sites[0]); // its cell is empty until the other one has moved
    const Sites start = sites;
    std::vector<double> energies;
    for(int iteration = 0; iteration < 3; ++iteration)
    {
      Voronoi voronoi(tm, curves);
      voronoi.add_sites(sites);
      Sites expected = sites;
      for(std::size_t i = 0; i < sites.size(); ++i)
      {
        const vertex_descriptor v = voronoi.central_vertex(curves.size() + i);
        expected[i] = v == boost::graph_traits<Mesh>::null_vertex() ? sites[i] : v;
      }
      if(iteration == 0)
        CHECK(voronoi.is_empty(curves.size() + 6) && expected.back() == sites.back() && expected != sites);
      energies.push_back(voronoi.energy());
      const double before = energy_of_cut(voronoi, curves.size(), tm, sites);
      CHECK_CLOSE(energies.back(), before, 1e-4);
      CHECK(energy_of_cut(voronoi, curves.size(), tm, expected) <= before * (1 + 1e-9));
      sites = expected;
    }
    Iterations visitor;
    CHECK(relaxed(tm, start, np::first_curves(curves).number_of_iterations(3).visitor(std::ref(visitor))) == sites);
    CHECK(visitor.energies == energies);
  }
}

// Sites on a curve have empty cells and stay, also at its corners; so nothing moves, and the energy is 0.
void curves_cover_sites()
{
  const test_support::Scope scope("covered");
  const Mesh tm = to_face_graph(flat_patch(8, 8, .15, true, 3));
  const std::vector<Curve> border = SMG::border_curves(tm);
  Sites sites;
  for(const vertex_descriptor v : vertices(tm))
    if(is_border(v, tm))
      sites.push_back(v);
  Iterations visitor;
  CHECK(relaxed(tm, sites, np::first_curves(border).visitor(std::ref(visitor))) == sites);
  CHECK(visitor.energies == std::vector<double>{0.});
  // Others move as if they were not there.
  Sites inside{nearest_vertex(tm, Point(2, 2)), nearest_vertex(tm, Point(6, 3))}, all = inside;
  all.insert(all.begin() + 1, sites.begin(), sites.end());
  const Sites expected = relaxed(tm, inside, np::first_curves(border)),
              found = relaxed(tm, all, np::first_curves(border));
  CHECK(found.front() == expected.front() && found.back() == expected.back() && expected != inside);
  CHECK(Sites(found.begin() + 1, found.end() - 1) == sites);
}

// No curves: the sites and the energies of a call without the parameter.
void no_curves()
{
  const test_support::Scope scope("no curves");
  const Mesh tm = to_face_graph(noisy_sphere(2, .1, 1));
  const Sites sites{vertex_descriptor(0), vertex_descriptor(1), vertex_descriptor(2), vertex_descriptor(70)};
  Iterations usual, without;
  CHECK(relaxed(tm, sites, np::visitor(std::ref(usual)))
        == relaxed(tm, sites, np::first_curves(std::vector<Curve>()).visitor(std::ref(without))));
  CHECK(usual.energies == without.energies && usual.energies.size() > 1);
}

// --- obstacles ---

Sites random_sites(const Case& c, std::size_t n, test_support::Random& random)
{
  Sites sites;
  while(sites.size() < n)
    sites.push_back(target(halfedge(random_place(c.tm, c.removed, random).location.first, c.tm), c.tm));
  return sites;
}

// One step: each site is at the central vertex of its cell, and no other site and no curve is nearer in the mesh that
// has been cut.
void check_step(const Case& c, const Curves& curves, test_support::Random& random)
{
  const Sites sites = random_sites(c, 4, random);
  const Sites moved = relaxed(c.tm, sites, np::first_curves(curves).edges_to_avoid(c.range).faces_to_avoid(c.avoided)
                                             .number_of_iterations(1));
  Voronoi voronoi(c.tm, curves);
  voronoi.avoid_faces(c.avoided);
  voronoi.avoid_edges(c.range);
  voronoi.add_sites(sites);
  std::map<vertex_descriptor, double> in_cut;
  SMG::geodesic_distances(c.cut.mesh, boost::make_assoc_property_map(in_cut), parts_of(c, curves));
  std::vector<std::map<vertex_descriptor, double>> from_site;
  for(const vertex_descriptor v : sites)
    from_site.push_back(c.expected({{v, {}, true}}));
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    const vertex_descriptor center = voronoi.central_vertex(curves.size() + i);
    CHECK(moved[i] == (center == boost::graph_traits<Mesh>::null_vertex() ? sites[i] : center));
    if(voronoi.is_empty(curves.size() + i))
      continue;
    const double d = from_site[i].at(moved[i]);
    CHECK(d <= least(in_cut, c.cut.copies[moved[i]]) + 1e-12);
    for(const auto& other : from_site)
      CHECK(d <= other.at(moved[i]) + 1e-12);
  }
}

void obstacles()
{
  test_support::Random random(5);
  for_each_case(random, [&](const Case& c, std::size_t)
  {
    for(const Curves& curves : all_curves(c, random))
      check_step(c, curves, random);
  });
}

// --- threads, visitors, bad input ---

void threads_do_not_matter()
{
  const test_support::Scope scope("threads");
  const Mesh tm = to_face_graph(rough_terrain(16, 1., 4));
  const std::vector<Curve> border = SMG::border_curves(tm);
  Sites sites;
  for(std::size_t i = 0; i < 8; ++i)
    sites.push_back(vertex_descriptor(static_cast<Mesh::size_type>(20 + i * 30)));
  std::vector<Sites> results;
  for(const std::size_t threads : {1u, 2u})
    with_threads(threads, [&]
    {
      results.emplace_back();
      SMG::geodesic_Lloyd_relaxation<CGAL::Parallel_if_available_tag>(
        tm, sites, std::back_inserter(results.back()), np::first_curves(border).number_of_iterations(4));
    });
  CHECK(results[0] == results[1] && results[0] != sites);
}

struct Canceling_visitor : SMG::Geodesic_default_visitor
{
  void on_propagation_begin(std::size_t) { ++begun; }
  bool go_further() { return ++questions <= most; }
  std::size_t begun = 0, questions = 0, most = (std::numeric_limits<std::size_t>::max)();
};

// At any time when the visitor cancels, the sites are those of the iteration before.
void visitors_cancel()
{
  const test_support::Scope scope("visitors");
  const Mesh tm = to_face_graph(rough_terrain(12, 1., 4));
  const auto parameters = np::first_curves(SMG::border_curves(tm));
  const Sites sites{vertex_descriptor(28), vertex_descriptor(29), vertex_descriptor(43)};
  std::vector<Sites> after{sites};
  while(after.size() < 4)
    after.push_back(relaxed(tm, sites, parameters.number_of_iterations(after.size())));
  Canceling_visitor whole;
  relaxed(tm, sites, parameters.number_of_iterations(3).visitor(std::ref(whole)));
  CHECK_EQUAL(whole.begun, std::size_t(3));
  for(std::size_t most = 0; most < whole.questions; most += 1 + whole.questions / 40)
  {
    Canceling_visitor visitor;
    visitor.most = most;
    const Sites moved = relaxed(tm, sites, parameters.number_of_iterations(3).visitor(std::ref(visitor)));
    CHECK(visitor.begun >= 1 && visitor.begun <= 3 && moved == after[visitor.begun - 1]);
    CHECK_EQUAL(visitor.questions, most + 1);
  }
}

void bad_input()
{
  const test_support::Scope scope("bad input");
  const Mesh tm = to_face_graph(flat_patch(6, 6, .15, true, 1)), large = to_face_graph(flat_patch(30, 30, 0, true, 1));
  const std::vector<Curve> border = SMG::border_curves(tm), other = SMG::border_curves(large);
  Sites moved;
  const auto relax = [&](const Sites& sites, const auto& parameters)
  { SMG::geodesic_Lloyd_relaxation(tm, sites, std::back_inserter(moved), parameters); };
  const Sites sites{nearest_vertex(tm, Point(3, 3))};
  CHECK(throws_reason(Reason::INVALID_DESCRIPTOR, [&] { relax(sites, np::first_curves(other)); }));
  const std::vector<face_descriptor> at_border{border[0].segments()[0].face};
  CHECK(throws_reason(Reason::INVALID_LOCATION, [&]
  { relax(sites, np::first_curves(border).faces_to_avoid(at_border)); }));
  CHECK(throws_reason(Reason::INVALID_DESCRIPTOR, [&] { relax({vertex_descriptor(7777)}, np::first_curves(border)); }));
  CHECK(moved.empty());
  relax({}, np::first_curves(border));
  CHECK(moved.empty());
  // Segments that nearly coincide: the curves are rejected, or they are right for all functions.
  test_support::Random random(116);
  Mesh hostile;
  CHECK(hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), hostile));
  const std::vector<Curve> curves = curve_cases::random_curves(hostile, random);
  std::map<vertex_descriptor, double> distance;
  CHECK_EQUAL(throws_reason(Reason::INVALID_CURVE, [&]
              { relaxed(hostile, {*vertices(hostile).begin()}, np::first_curves(curves)); }),
              throws_reason(Reason::INVALID_CURVE, [&]
              { SMG::geodesic_distances(hostile, boost::make_assoc_property_map(distance), curves); }));
}

} // namespace

int main()
{
  one_site_in_a_square();
  sites_in_a_strip();
  sites_in_a_disk();
  steps_on_surfaces();
  curves_cover_sites();
  no_curves();
  obstacles();
  threads_do_not_matter();
  visitors_cancel();
  bad_input();
  return test_result();
}
