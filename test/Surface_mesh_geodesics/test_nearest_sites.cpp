// All sites that have the nearest point: curves with a common end, edges on several curves, several sites at one point.
// In the plane they are known; on bumpy spheres the paths from one site at a time tell them by their ends.

#include "Voronoi_test_helpers.h"
#include "curve_cases.h"
#include "curves_in_plane.h"
#include "expected_exceptions.h"

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

using namespace curve_cases;

namespace {

using Sites = std::vector<std::size_t>;
using Point = Voronoi::Point_3;

template <typename Place>
Sites sites_at(const Voronoi& diagram, const Place& place)
{
  Sites result;
  diagram.nearest_sites(place, std::back_inserter(result));
  CHECK(std::is_sorted(result.begin(), result.end()));
  return result;
}

// Compares the sites at the inner point of a face in each cell of the square with a function of the coordinates.
template <typename Expected>
void check_square(const Square& s, const Voronoi& diagram, Expected expected)
{
  for(const face_descriptor f : faces(s.tm))
  {
    const Location l(f, {.25, .35, .4});
    const Point p = diagram.point(l);
    CHECK(sites_at(diagram, l) == expected(p.x(), p.y()));
  }
}

void curves_in_the_plane()
{
  const Square s(4);
  {
    const test_support::Scope scope("a common corner");
    Voronoi diagram(s.tm);
    diagram.add_sites(std::vector<Curve>{s.line({{1, 2}, {2, 2}}), s.line({{2, 2}, {2, 3}})});
    check_square(s, diagram, [](double x, double y)
    { return x > 2 && y < 2 ? Sites{0, 1} : x > 2 || x + y > 4 ? Sites{1} : Sites{0}; });
    CHECK(sites_at(diagram, s.at(2, 2)) == (Sites{0, 1}));
    CHECK(sites_at(diagram, s.at(4, 0)) == (Sites{0, 1}));
    CHECK(sites_at(diagram, s.at(1, 1)) == Sites{0});
  }
  {
    const test_support::Scope scope("with weights the larger one counts");
    Voronoi diagram(s.tm);
    diagram.add_site(s.line({{1, 2}, {2, 2}}), .25);
    diagram.add_site(s.line({{2, 2}, {2, 3}}), .25 + 1e-9);
    CHECK(sites_at(diagram, s.at(4, 0)) == Sites{1});
    CHECK(sites_at(diagram, s.at(1, 1)) == Sites{0});
  }
  {
    const test_support::Scope scope("curves that overlap, one of them twice, and a point on them");
    Voronoi diagram(s.tm);
    diagram.add_site(s.line({{0, 2}, {1, 2}, {2, 2}}));
    diagram.add_site(s.line({{3, 2}, {2, 2}, {1, 2}, {2, 2}}));
    diagram.add_site(s.at(2, 2));
    diagram.add_site(s.at(3, 2));
    check_square(s, diagram, [](double x, double)
    { return x < 1 ? Sites{0} : x < 2 ? Sites{0, 1} : x < 3 ? Sites{1} : Sites{1, 3}; });
    CHECK(sites_at(diagram, s.at(2, 0)) == (Sites{0, 1, 2}));
    CHECK(sites_at(diagram, s.at(3, 4)) == (Sites{1, 3}));
  }
}

// --- where points are equally near ---

struct Segment
{
  std::size_t site;
  Point_2 from, to;
};

// Is `found` the set of all sites with one of the points that are nearest to (x, y)?
bool is_set_of_one_point(const std::vector<Segment>& segments, const Point_2& p, const Sites& found)
{
  constexpr double rounding = 1e-12;
  double least = infinity;
  for(const Segment& s : segments)
    least = (std::min)(least, distance_to_segment(p, s.from, s.to));
  for(const Segment& s : segments)
  {
    if(distance_to_segment(p, s.from, s.to) > least + rounding)
      continue;
    const Point_2 foot = foot_on_segment(p, s.from, s.to);
    Sites sites;
    for(const Segment& other : segments)
      if(distance_to_segment(foot, other.from, other.to) <= rounding)
        sites.push_back(other.site);
    sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    if(sites == found)
      return true;
  }
  return false;
}

// Curves along edges of a grid, and points on the lines and diagonals between them.
void ties_in_the_plane()
{
  const Square s(6);
  for(std::uint64_t seed = 0; seed < 40; ++seed)
  {
    const test_support::Scope scope("ties, seed " + std::to_string(seed));
    test_support::Random random(seed);
    Voronoi diagram(s.tm);
    std::vector<Segment> segments;
    for(std::size_t i = 0; i < 6; ++i)
    {
      std::vector<Point_2> points{{double(random.index(7)), double(random.index(7))}};
      segments.push_back({i, points[0], points[0]});
      for(std::size_t n = random.index(4); n > 0; --n)
      {
        Point_2 p = points.back();
        double& coordinate = p[random.index(2)];
        coordinate += coordinate == 0 || (coordinate < 6 && random.index(2) == 0) ? 1 : -1;
        segments.push_back({i, points.back(), p});
        points.push_back(p);
      }
      diagram.add_site(s.line(points));
    }
    for(const face_descriptor f : faces(s.tm))
      for(const std::array<double, 3>& b : {std::array<double, 3>{{.5, .5, 0}}, {{.5, .25, .25}}, {{0, 0, 1}}})
      {
        const Location l(f, b);
        const Point p = diagram.point(l);
        CHECK(is_set_of_one_point(segments, {p.x(), p.y()}, sites_at(diagram, l)));
      }
  }
}

void points_in_the_plane()
{
  const Square s(4);
  const test_support::Scope scope("points");
  Voronoi diagram(s.tm);
  CHECK(sites_at(diagram, s.at(1, 1)).empty());
  const halfedge_descriptor h = CGAL::halfedge(s.at(1, 1), s.at(2, 1), s.tm).first;
  // The middle of the edge in both of its faces.
  std::vector<Location> both;
  for(const halfedge_descriptor g : {h, opposite(h, s.tm)})
  {
    Location l(face(g, s.tm), {0, 0, 0});
    halfedge_descriptor k = CGAL::halfedge(l.first, s.tm);
    for(std::size_t i = 0; i < 3; ++i, k = next(k, s.tm))
      if(target(k, s.tm) != target(next(g, s.tm), s.tm))
        l.second[(i + 1) % 3] = .5;
    both.push_back(l);
  }
  diagram.add_site(s.at(4, 4));
  diagram.add_site(both[0]);
  diagram.add_site(both[1]);
  diagram.add_site(s.at(4, 4), -1.);
  diagram.add_site(s.at(4, 4));
  const auto check = [&]
  {
    const Point p = diagram.point(diagram.site(1)), q = diagram.point(diagram.site(2));
    CHECK_NEAR(CGAL::squared_distance(p, q), 0., 1e-30);
    CHECK(sites_at(diagram, s.at(0, 0)) == (Sites{1, 2}));
    CHECK(sites_at(diagram, s.at(2, 0)) == (Sites{1, 2}));
    CHECK(sites_at(diagram, s.at(1, 2)) == (Sites{1, 2}));
    CHECK(sites_at(diagram, s.at(4, 4)) == (Sites{0, 4}));
    CHECK(sites_at(diagram, s.at(4, 3)) == (Sites{0, 4}));
  };
  check();
  diagram.avoid_edges(std::vector<Mesh::Edge_index>{edge(h, s.tm)}); // the two are given on different sides
  check();
}

void places_without_sites()
{
  const test_support::Scope scope("places that no site reaches, or that do not exist");
  Mesh tm = to_face_graph(flat_patch(2, 2, 0., true, 1));
  const auto n = num_vertices(tm), m = num_faces(tm);
  tm += Mesh(tm);
  Voronoi diagram(tm);
  for(const bool has_curve : {false, true})
  {
    diagram.remove_all_sites();
    diagram.add_site(vertex_descriptor(0));
    if(has_curve)
      diagram.add_site(Curve(tm, std::vector<vertex_descriptor>{vertex_descriptor(0),
                                                                target(halfedge(vertex_descriptor(0), tm), tm),
                                                                source(halfedge(vertex_descriptor(0), tm), tm)}));
    CHECK(sites_at(diagram, vertex_descriptor(n)).empty());
    CHECK(sites_at(diagram, Location(face_descriptor(m), {.2, .3, .5})).empty());
    CHECK(sites_at(diagram, vertex_descriptor(0)) == (has_curve ? Sites{0, 1} : Sites{0}));
    CHECK(throws<Invalid_input>([&] { sites_at(diagram, vertex_descriptor(2 * n)); }));
    CHECK(throws<Invalid_input>([&] { sites_at(diagram, Location(face_descriptor(0), {.2, .3, 1.5})); }));
  }
}

// A corner near a vertex, where edges of the refined mesh are as short as 1e-12, and a curve that is the same point. A
// third site with another weight changes the rounding of all distances.
void corner_between_short_edges()
{
  const test_support::Scope scope("a corner between short edges");
  const Mesh tm = to_face_graph(flat_patch(4, 4, .15, true, 4016));
  const face_descriptor f(21);
  const double first = 0x1.5bca8a8a7984fp-17, second = 0x1.fffe39ecb52b5p-1;
  const double a = 0x1.ffffbecb11c89p-1, b = 0x1.04d3b8dda6708p-19;
  const Location corner(f, {a, b, 1 - a - b});
  const Curve curve(tm, std::vector<Location>{{f, {.25, .5, .25}}, corner, {f, {first, second, 1 - first - second}}});
  std::vector<face_descriptor> avoided;
  for(const unsigned int i : {0u, 7u, 13u, 22u, 23u, 30u, 31u})
    avoided.emplace_back(i);
  const Location query(face_descriptor(15), {.5, .25, .25});
  for(const unsigned int i : {2u, 7u, 12u, 17u, 22u})
  {
    const vertex_descriptor v(i);
    Voronoi diagram(tm);
    diagram.avoid_faces(avoided);
    diagram.add_site(curve);
    diagram.add_site(Curve(tm, std::vector<Location>{corner}));
    CHECK(sites_at(diagram, query) == (Sites{0, 1}));
    diagram.add_site(v, .25);
    const Sites found = sites_at(diagram, query);
    CHECK(found == (Sites{0, 1}) || found == Sites{2});
  }
}

// --- against paths from one site at a time ---

// Curves of which many begin at the same vertex, curves anywhere, and a part of an earlier one.
std::vector<Curve> curves_that_touch(const Mesh& tm, test_support::Random& random)
{
  std::vector<Curve> curves;
  const std::vector<vertex_descriptor> first = random_vertices_along_edges(tm, 5, random);
  curves.emplace_back(tm, first);
  curves.push_back(random_curve(tm, random));
  for(std::size_t i = 0; i < 3; ++i)
  {
    std::vector<vertex_descriptor> further{first[random.index(first.size())]};
    for(std::size_t n = random.index(4); n > 0; --n)
    {
      halfedge_descriptor h = CGAL::halfedge(further.back(), tm);
      for(std::size_t k = random.index(6); k > 0; --k)
        h = opposite(next(h, tm), tm);
      further.push_back(source(h, tm));
    }
    curves.emplace_back(tm, further);
  }
  // A corner beside a vertex, where edges of the curve are as short as rounding, and the same point.
  const face_descriptor f = random_location(tm, random).first;
  const double beside = hostile_meshes::of_any_scale(-8., -5., random);
  const Location corner(f, {1 - beside, beside, 0});
  curves.emplace_back(tm, std::vector<Location>{{f, {.25, .5, .25}}, corner, {f, {beside, 1 - beside, 0}}});
  curves.emplace_back(tm, std::vector<Location>{corner});
  return curves;
}

// The sites whose path ends where the shortest of all paths ends. None if another path is nearly as short.
class Ends_of_paths
{
public:
  Ends_of_paths(const Mesh& tm, const std::vector<Curve>& curves, const std::vector<double>& weights)
    : m_weights(weights)
  {
    for(const Curve& c : curves)
    {
      m_paths.emplace_back(new Paths(tm));
      m_paths.back()->add_source_curve(c);
    }
  }

  Sites operator()(const Location& l) const
  {
    std::vector<double> distance;
    std::vector<Point> end;
    for(std::size_t i = 0; i < m_paths.size(); ++i)
    {
      const Location foot = m_paths[i]->nearest_location_of_sources(l.first, l.second);
      end.push_back(m_paths[i]->point(foot.first, foot.second));
      distance.push_back(m_paths[i]->shortest_distance_to_source_points(l.first, l.second).first - m_weights[i]);
    }
    const auto nearest = std::min_element(distance.begin(), distance.end());
    const Point& foot = end[static_cast<std::size_t>(nearest - distance.begin())];
    Sites result;
    for(std::size_t i = 0; i < distance.size(); ++i)
    {
      if(distance[i] > *nearest + 1e-6)
        continue;
      if(CGAL::squared_distance(end[i], foot) > 1e-12 || distance[i] > *nearest + 1e-12)
        return {};
      result.push_back(i);
    }
    return result;
  }

private:
  std::vector<std::unique_ptr<Paths>> m_paths;
  std::vector<double> m_weights;
};

void bumpy_spheres()
{
  std::size_t alone = 0, together = 0;
  for(std::uint64_t seed = 0; seed < 30; ++seed)
  {
    const test_support::Scope scope("bumpy sphere " + std::to_string(seed));
    test_support::Random random(seed);
    const Mesh tm = to_face_graph(noisy_sphere(1 + seed % 2, .2, seed));
    const std::vector<Curve> curves = curves_that_touch(tm, random);
    std::vector<double> weights(curves.size(), 0.);
    for(std::size_t i = 0; i < (seed % 3) * curves.size() / 3; ++i)
      weights[i] = .125;
    Voronoi diagram(tm);
    for(std::size_t i = 0; i < curves.size(); ++i)
      diagram.add_site(curves[i], weights[i]);
    const Ends_of_paths expected(tm, curves, weights);
    for(std::size_t k = 0; k < 200; ++k)
    {
      const Location l = random_location(tm, random);
      const Sites sites = expected(l);
      if(sites.empty())
        continue;
      CHECK(sites_at(diagram, l) == sites);
      ++(sites.size() > 1 ? together : alone);
    }
  }
  CHECK(alone > 3000 && together > 300);
}

// Two sites at one point up to rounding have one cell. Queries at it name both.
void points_that_tie()
{
  Mesh tm;
  const vertex_descriptor v = tm.add_vertex(Point(0, 0, 0));
  const face_descriptor f = tm.add_face(v, tm.add_vertex(Point(1, 0, 0)), tm.add_vertex(Point(.4, 1, 0)));
  Location beside(f, {2e-14, 2e-14, 2e-14});
  auto h = halfedge(f, tm);
  for(std::size_t k = 0; k < 3; ++k, h = next(h, tm))
    if(source(h, tm) == v)
      beside.second[k] = 1 - 4e-14;
  for(const double weight : {0., -1e-3})
  {
    Voronoi diagram(tm);
    diagram.add_site(v);
    diagram.add_site(beside, weight);
    CHECK(diagram.is_empty(1));
    const Sites expected = weight < 0 ? Sites{0} : Sites{0, 1};
    CHECK(sites_at(diagram, v) == expected);
    CHECK(sites_at(diagram, beside) == expected);
    CHECK(sites_at(diagram, Location(f, {.4, .3, .3})) == expected);
  }
}

// In a component much smaller than the mesh, a point of a curve far from its ends is not taken for an end.
void curves_in_small_component()
{
  for(const double size : {1., 1e-12, 1e-14, 1e-30})
  {
    const test_support::Scope scope("size " + std::to_string(std::log10(size)));
    Mesh tm;
    const vertex_descriptor o = tm.add_vertex(Point(0, 0, 0)), x = tm.add_vertex(Point(2 * size, 0, 0));
    const vertex_descriptor y = tm.add_vertex(Point(0, 2 * size, 0)), z = tm.add_vertex(Point(2 * size, 2 * size, 0));
    const face_descriptor f = tm.add_face(o, x, z);
    tm.add_face(o, z, y);
    tm.add_face(tm.add_vertex(Point(-1, 0, 0)), tm.add_vertex(Point(-2, 0, 0)), tm.add_vertex(Point(-1, -1, 0)));
    Voronoi diagram(tm);
    diagram.add_site(Curve(tm, std::vector<vertex_descriptor>{o, x}));
    diagram.add_site(Curve(tm, std::vector<vertex_descriptor>{o, y}));
    Location l(f, {.025, .025, .025});
    auto h = halfedge(f, tm);
    for(std::size_t k = 0; k < 3; ++k, h = next(h, tm))
      if(source(h, tm) == o)
        l.second[k] = .95;
    CHECK(sites_at(diagram, l) == Sites{0});
    CHECK(sites_at(diagram, o) == (Sites{0, 1}));
  }
}

} // namespace

int main()
{
  points_that_tie();
  curves_in_small_component();
  curves_in_the_plane();
  ties_in_the_plane();
  corner_between_short_edges();
  points_in_the_plane();
  places_without_sites();
  bumpy_spheres();
  return test_result();
}
