// Many sources, or many sites, in one of two flat faces: on a line, next to an edge, on a lattice, on a circle or a
// spiral, in a cluster. The two faces are a convex part of the plane, so all distances are those of the plane.

#include "Voronoi_test_helpers.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace test_meshes;

namespace {

struct Point_2
{
  double x, y;
};

struct Kite
{
  Mesh mesh;
  face_descriptor crowded, other;

  explicit Kite(double height)
  {
    const auto vertex_at = [this](double x, double y) { return mesh.add_vertex(Mesh::Point(x, y, 0)); };
    const vertex_descriptor a = vertex_at(0, 0), b = vertex_at(1, 0), c = vertex_at(.45, -.6),
                            d = vertex_at(.5, height);
    other = mesh.add_face(a, b, d);
    crowded = mesh.add_face(b, a, c);
  }

  std::array<Point_2, 3> corners(face_descriptor f) const
  {
    const auto h = mesh.halfedge(f);
    const auto at = [this](vertex_descriptor v) { return Point_2{mesh.point(v).x(), mesh.point(v).y()}; };
    return {at(mesh.source(h)), at(mesh.target(h)), at(mesh.target(mesh.next(h)))};
  }

  Face_location location(face_descriptor f, const Point_2& p) const
  {
    const std::array<Point_2, 3> c = corners(f);
    const auto cross = [](const Point_2& o, const Point_2& s, const Point_2& t)
    { return (s.x - o.x) * (t.y - o.y) - (t.x - o.x) * (s.y - o.y); };
    const double area = cross(c[0], c[1], c[2]), u = cross(c[0], p, c[2]) / area, v = cross(c[0], c[1], p) / area;
    return Face_location(f, {1 - u - v, u, v});
  }

  Point_2 random_point(face_descriptor f, test_support::Random& random) const
  {
    const std::array<Point_2, 3> c = corners(f);
    const double x = std::sqrt(random.uniform()), y = random.uniform();
    const double w0 = 1 - x, w1 = x * (1 - y), w2 = x * y;
    return Point_2{w0 * c[0].x + w1 * c[1].x + w2 * c[2].x, w0 * c[0].y + w1 * c[1].y + w2 * c[2].y};
  }
};

struct Crowd
{
  std::vector<Point_2> points;
  std::vector<double> weights;

  // Returns the distance of p from a site, or from the nearest site.
  double distance(std::size_t site, const Point_2& p) const
  {
    return std::hypot(p.x - points[site].x, p.y - points[site].y) - weights[site];
  }

  double distance(const Point_2& p) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      smallest = std::min(smallest, distance(i, p));
    }
    return smallest;
  }
};

// A pattern: the k-th of its points, where t = (k + 1) / (n + 1).
struct Pattern
{
  std::string name;
  std::function<Point_2(std::size_t k, double t, test_support::Random& random)> point;
};

const std::vector<Pattern>& patterns()
{
  using test_support::Random;
  static const std::vector<Pattern> all{
    {"line", [](std::size_t, double t, Random&) { return Point_2{.1 + .8 * t, -.02}; }},
    {"line from the middle", [](std::size_t k, double t, Random&)
     { return Point_2{.5 + (k % 2 == 0 ? .4 : -.4) * t, -.05}; }},
    {"next to an edge", [](std::size_t, double t, Random&) { return Point_2{.05 + .9 * t * t, -.001}; }},
    {"near to an edge", [](std::size_t, double t, Random& random)
     { return Point_2{.1 + .8 * t, -.001 - .05 * random.uniform()}; }},
    {"circle", [](std::size_t, double t, Random&)
     { return Point_2{.45 + .1 * std::cos(6.28 * t), -.2 + .1 * std::sin(6.28 * t)}; }},
    {"spiral", [](std::size_t, double t, Random&)
     { return Point_2{.45 + .15 * t * std::cos(9 * t), -.26 + .15 * t * std::sin(9 * t)}; }},
    {"lattice", [](std::size_t k, double, Random&)
     { return Point_2{.3 + .3 * double(k % 8) / 8, -.05 - .25 * double(k / 8) / 20}; }},
    {"shuffled lattice", [](std::size_t k, double, Random&)
     {
       const std::size_t i = 37 * k % 101;
       return Point_2{.25 + .04 * double(i % 10), -.03 - .02 * double(i / 10)};
     }},
    {"cluster", [](std::size_t, double, Random& random)
     { return Point_2{.45 + 1e-6 * random.uniform(-1, 1), -.1 + 1e-6 * random.uniform(-1, 1)}; }}};
  return all;
}

double excess(const Crowd& crowd, const Voronoi& diagram, const Voronoi::Face_location& location,
              const std::vector<std::size_t>& sites)
{
  const auto q = diagram.point(location);
  const Point_2 p{q.x(), q.y()};
  const double nearest = crowd.distance(p);
  double result = 0;
  for(const std::size_t s : sites)
  {
    result = std::max(result, crowd.distance(s, p) - nearest);
  }
  return result;
}

void check_points(const Kite& kite, const Crowd& crowd, Voronoi& diagram, test_support::Random& random)
{
  for(std::size_t k = 0; k < 60; ++k)
  {
    const face_descriptor f = k % 2 == 0 ? kite.crowded : kite.other;
    const Point_2 p = kite.random_point(f, random);
    const Face_location location = kite.location(f, p);
    CHECK_NEAR(diagram.distance_to_nearest_site(location), crowd.distance(p), 1e-12);
    CHECK_NEAR(crowd.distance(diagram.nearest_site(location), p), crowd.distance(p), 1e-10);
  }
}

void check_curves(const Crowd& crowd, const Voronoi& diagram)
{
  for(const Voronoi::Arc& a : diagram.arcs())
  {
    for(const double t : {0., .5, 1.})
    {
      CHECK(excess(crowd, diagram, a.point(t), {a.sites().first, a.sites().second}) <= 1e-10);
    }
  }
  for(const Voronoi::Vertex& v : diagram.vertices())
  {
    CHECK(excess(crowd, diagram, v.location(), {v.sites().begin(), v.sites().end()}) <= 1e-10);
  }
}

void crowded_faces_are_divided(const Pattern& pattern, std::size_t n, double height, double largest_weight,
                               std::uint64_t seed)
{
  test_support::Scope scope(pattern.name + ", " + std::to_string(n) + " sites, height " + std::to_string(height)
                            + ", weights to " + std::to_string(largest_weight));
  test_support::Random random(seed);
  Kite kite(height);
  Crowd crowd;
  Voronoi diagram(kite.mesh);
  for(std::size_t k = 0; k < n; ++k)
  {
    crowd.points.push_back(pattern.point(k, double(k + 1) / double(n + 1), random));
    crowd.weights.push_back(largest_weight * random.uniform());
    diagram.add_site(kite.location(kite.crowded, crowd.points.back()), crowd.weights.back());
  }
  check_points(kite, crowd, diagram, random);
  check_curves(crowd, diagram);
  double area = 0;
  for(std::size_t i = 0; i < n; ++i)
  {
    area += diagram.area(i);
  }
  CHECK_CLOSE(area, (height + .6) / 2, 1e-10);
}

// If two sites coincide up to rounding, the first one owns the cell.
void the_first_of_equal_sites_owns_the_cell()
{
  Kite kite(.9);
  Voronoi diagram(kite.mesh);
  const double x = .4, y = -.1, little = 2e-15;
  for(const Point_2& p : {Point_2{x, y}, Point_2{x + little, y - little}, Point_2{.5, -.2}, Point_2{x, y + little}})
  {
    diagram.add_site(kite.location(kite.crowded, p));
  }
  CHECK(!diagram.is_empty(0));
  CHECK(diagram.is_empty(1));
  CHECK(!diagram.is_empty(2));
  CHECK(diagram.is_empty(3));
  CHECK_EQUAL(diagram.edges().size(), 1u);
  CHECK_EQUAL(diagram.nearest_site(kite.location(kite.crowded, Point_2{.39, -.1})), 0u);
  CHECK_CLOSE(diagram.area(0) + diagram.area(2), .75, 1e-10);
  CHECK(CGAL::Surface_mesh_geodesics::certify_geodesic_Voronoi_diagram(diagram).is_certified());
}

} // namespace

// The number of rounds may be given as an argument.
int main(int argc, char* argv[])
{
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 4;
  the_first_of_equal_sites_owns_the_cell();
  crowded_faces_are_divided(patterns()[6], 31, 3., 0., 0); // once put into parts of a face without width
  crowded_faces_are_divided(patterns()[3], 16, .9, .01, 17); // fronts once passed each other
  crowded_faces_are_divided(patterns()[4], 59, 3., 0., 13); // fronts once returned to the point where they began
  crowded_faces_are_divided(patterns()[5], 104, 3., .01, 17); // a front once left an image for good
  for(std::size_t i = 0; i < number; ++i)
  {
    for(const Pattern& pattern : patterns())
    {
      for(const double height : {.9, .05, 3.})
      {
        for(const double weight : {0., .01, .15})
        {
          test_support::Random random(1000 * i + std::uint64_t(height * 20 + weight * 1000));
          crowded_faces_are_divided(pattern, 5 + random.index(i % 4 == 0 ? 40 : 100), height, weight, i);
        }
      }
    }
  }
  return test_result();
}
