// The laws and error bounds of the frames of faces, and of the predicates of diagrams: is_nearer(), and which image
// takes over along an edge (Edge_partition). Random cases, some of them degenerate, are compared with the definitions
// in a hundred digits, with their mirror images, and with scaled cases.

#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Edge_partition.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/face_shape.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <utility>
#include <vector>

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using Exact = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;
using Face = internal::Intrinsic_face<double>;
using Point = internal::Planar_point<double>;
using Weighted_point = internal::Additively_weighted_point<double>;
using Image = internal::Edge_image<double>;
using Partition = internal::Edge_partition<double>;

const double epsilon = std::numeric_limits<double>::epsilon();

// --- frames of faces -------------------------------------------------------------------------------------------------

// The three sides of a triangle, the shortest one first; many are needles and caps.
std::array<double, 3> random_sides(test_support::Random& random)
{
  const double x = random.uniform(0., 1.), y = std::ldexp(random.uniform(.5, 1.), -static_cast<int>(random.index(20)));
  std::array<double, 3> sides{1., std::hypot(1 - x, y), std::hypot(x, y)};
  while(!(sides[0] <= sides[1] && sides[0] <= sides[2]))
  {
    std::rotate(sides.begin(), sides.begin() + 1, sides.end());
  }
  return sides;
}

void triangles_satisfy_their_error_bounds(test_support::Random& random)
{
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const std::array<double, 3> s = random_sides(random);
    const auto found = internal::planar_triangle_from_lengths(s[0], s[1], s[2]);
    const auto exact = internal::planar_triangle_from_lengths<Exact>(s[0], s[1], s[2]);
    CHECK(abs(Exact(found.apex_y) - exact.apex_y) <= 6 * epsilon * exact.apex_y);
    CHECK(abs(Exact(found.apex_x) - exact.apex_x) <= 3 * epsilon * (std::max)(s[1], s[2]));
    const double factor = 0x1p80;
    const auto large = internal::planar_triangle_from_lengths(factor * s[0], factor * s[1], factor * s[2]);
    CHECK(large.apex_x == factor * found.apex_x && large.apex_y == factor * found.apex_y);
  }
}

template <typename FT>
internal::Face_frame<FT> frame_of(internal::Intrinsic_face<FT> face, unsigned int k)
{
  face.vertex = {0, 1, 2};
  face.opposite = {internal::null_id, internal::null_id, internal::null_id};
  internal::Intrinsic_mesh<FT> mesh;
  mesh.reset(1);
  mesh.face(0) = face;
  return mesh.face_frame(internal::halfedge_of(0, k));
}

// The error of the apex in the frame of side k, over that of the exact face, relative to either side that ends there.
double error_of_apex(const Face& found, const internal::Intrinsic_face<Exact>& exact, unsigned int k, unsigned int l)
{
  const internal::Face_frame<double> c = frame_of(found, k);
  const internal::Face_frame<Exact> e = frame_of(exact, l);
  const Exact dx = c.apex_x - e.apex_x, dr = c.apex_rest - e.apex_rest, dy = c.apex_y - e.apex_y;
  const Exact from_left = sqrt(dx * dx + dy * dy) / e.left_length,
              from_right = sqrt(dr * dr + dy * dy) / e.right_length;
  return static_cast<double>((std::max)(from_left, from_right)) / epsilon;
}

void frames_from_lengths_satisfy_their_error_bound(test_support::Random& random)
{
  double worst = 0;
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const std::array<double, 3> s = random_sides(random);
    Face found;
    internal::Intrinsic_face<Exact> exact;
    internal::set_shape_from_lengths<double>(s, found);
    internal::set_shape_from_lengths<Exact>({s[0], s[1], s[2]}, exact);
    for(unsigned int k = 0; k < 3; ++k)
      worst = (std::max)(worst, error_of_apex(found, exact, k, k));
  }
  std::cout << "error of frames from lengths, over epsilon: " << worst << std::endl;
  CHECK(worst < 8);
}

// Returns the sides of a triangle whose corners are multiples of 2^-50, so that the sides are exact; many triangles are
// needles and caps.
std::array<internal::Space_vector<double>, 3> random_sides_in_space(test_support::Random& random)
{
  std::array<std::array<double, 3>, 3> p;
  const double near = std::ldexp(1., -static_cast<int>(random.index(25)));
  const std::size_t kind = random.index(4); // any triangle, a needle, a cap, a small cap
  const double t = random.uniform(0., 1.);
  const double height = kind == 3 ? std::ldexp(near, -static_cast<int>(random.index(12))) : near;
  for(std::size_t c = 0; c < 3; ++c)
  {
    p[0][c] = random.uniform(-.5, .5);
    p[1][c] = kind % 2 == 1 ? p[0][c] + near * random.uniform(-.5, .5) : random.uniform(-.5, .5);
    p[2][c] = random.uniform(-.5, .5);
    if(kind >= 2)
      p[2][c] = p[0][c] + t * (p[1][c] - p[0][c]) + height * p[2][c];
    for(std::size_t k = 0; k < 3; ++k)
      p[k][c] = std::ldexp(std::nearbyint(std::ldexp(p[k][c], 50)), -50);
  }
  std::array<internal::Space_vector<double>, 3> side;
  for(std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t n = (k + 1) % 3;
    side[k] = {p[n][0] - p[k][0], p[n][1] - p[k][1], p[n][2] - p[k][2]};
  }
  return side;
}

void frames_from_points_satisfy_their_error_bound(test_support::Random& random)
{
  double worst = 0;
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const std::array<internal::Space_vector<double>, 3> s = random_sides_in_space(random);
    std::array<internal::Space_vector<Exact>, 3> sides;
    for(std::size_t k = 0; k < 3; ++k)
      sides[k] = {Exact(s[k].x), Exact(s[k].y), Exact(s[k].z)};
    Face found;
    internal::Intrinsic_face<Exact> exact;
    const unsigned int shift = internal::set_shape_from_sides(s, found);
    const unsigned int exact_shift = internal::set_shape_from_sides(sides, exact);
    if(!(exact.length[0] > 0))
      continue;
    for(unsigned int k = 0; k < 3; ++k)
      worst = (std::max)(worst, error_of_apex(found, exact, (k + 3 - shift) % 3, (k + 3 - exact_shift) % 3));
    std::array<internal::Space_vector<double>, 3> large_sides = s;
    for(internal::Space_vector<double>& v : large_sides)
      v = {0x1p90 * v.x, 0x1p90 * v.y, 0x1p90 * v.z};
    Face large;
    internal::set_shape_from_sides(large_sides, large);
    CHECK(large.apex_x == 0x1p90 * found.apex_x && large.apex_y == 0x1p90 * found.apex_y);
  }
  std::cout << "error of frames from points, over epsilon: " << worst << std::endl;
  CHECK(worst < 10);
}

// --- nearer points ---------------------------------------------------------------------------------------------------

Exact exact_distance(const Weighted_point& a, const Point& p)
{
  const Exact dx = Exact(p.x) - a.x, dy = Exact(p.y) - a.y;
  return a.weight + sqrt(dx * dx + dy * dy);
}

Weighted_point random_weighted_point(test_support::Random& random)
{
  return {random.uniform(-1., 1.), random.uniform(-1., 1.), random.index(2) == 0 ? 0. : random.uniform(0., 1.)};
}

Weighted_point scaled(const Weighted_point& a, double factor)
{
  return {factor * a.x, factor * a.y, factor * a.weight};
}

Weighted_point mirrored(const Weighted_point& a)
{
  return {-a.x, a.y, a.weight};
}

// One point is nearer than another one by less than 40 epsilon.
void nearer_points_satisfy_bound_and_laws(test_support::Random& random)
{
  std::size_t number_nearer = 0;
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const Point p{random.uniform(-1., 1.), random.uniform(-1., 1.)};
    const Weighted_point b = random_weighted_point(random);
    Weighted_point a = random_weighted_point(random);
    a.weight = b.distance_to(p) * (1 - random.uniform(0., 40.) * epsilon) - std::hypot(p.x - a.x, p.y - a.y);
    if(a.weight < 0)
      continue;
    const bool is_nearer = internal::is_nearer(a, b, p);
    const Exact of_a = exact_distance(a, p), of_b = exact_distance(b, p);
    CHECK(!is_nearer || of_a < of_b * (1 - 11.5 * epsilon));
    CHECK(is_nearer || !(of_a < of_b * (1 - 20.5 * epsilon)));
    CHECK(!is_nearer || !internal::is_nearer(b, a, p));
    CHECK(!internal::is_nearer(a, a, p));
    const double f = 0x1p-70;
    CHECK_EQUAL(internal::is_nearer(scaled(a, f), scaled(b, f), Point{f * p.x, f * p.y}), is_nearer);
    CHECK_EQUAL(internal::is_nearer(mirrored(a), mirrored(b), Point{-p.x, p.y}), is_nearer);
    number_nearer += is_nearer ? 1 : 0;
  }
  CHECK(number_nearer > 1000);
}

void nearer_distances_are_in_a_strict_order(test_support::Random& random)
{
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const double x = random.uniform(0., 4.), y = x * (1 + epsilon * double(random.index(40))),
                 z = x * (1 + epsilon * double(random.index(40)));
    CHECK(!internal::is_nearer(x, x));
    CHECK(!internal::is_nearer(x, y) || (internal::is_clearly_less(x, y) && !internal::is_nearer(y, x)));
    CHECK(!internal::is_nearer(x, y) || !internal::is_nearer(y, z) || internal::is_nearer(x, z));
    CHECK_EQUAL(internal::is_nearer(0x1p80 * x, 0x1p80 * y), internal::is_nearer(x, y));
  }
}

// --- images that take over along an edge -----------------------------------------------------------------------------

struct Edge
{
  double first_distance, last_distance;
  std::vector<Image> images;
};

// An edge of the length 1. Some images lie on it; some are close to each other.
Edge random_edge(test_support::Random& random, bool have_intervals)
{
  Edge e{random.uniform(.5, 1.), random.uniform(.5, 1.), {}};
  for(std::size_t i = 0; i < 6; ++i)
  {
    Image g{0, 1, random.uniform(-.5, 1.5), random.index(4) == 0 ? 0. : random.uniform(0., 1.),
            random.uniform(0., .5), static_cast<internal::Vertex_id>(2 + i)};
    if(i > 0 && random.index(4) == 0)
    {
      g.image_x = e.images[0].image_x + std::ldexp(random.uniform(-1., 1.), -static_cast<int>(random.index(30)));
      g.depth = e.images[0].depth;
    }
    if(have_intervals)
    {
      g.begin = random.uniform(0., .9);
      g.end = random.uniform(g.begin, 1.);
    }
    e.images.push_back(g);
  }
  return e;
}

Partition partition_of(const Edge& e, double factor = 1)
{
  Partition p;
  p.start(factor, 0, factor * e.first_distance, 1, factor * e.last_distance);
  for(Image g : e.images)
  {
    for(double* x : {&g.begin, &g.end, &g.image_x, &g.depth, &g.weight})
      *x *= factor;
    p.add(g);
  }
  p.build();
  return p;
}

Edge mirrored(const Edge& e)
{
  Edge m{e.last_distance, e.first_distance, e.images};
  for(Image& g : m.images)
  {
    g.image_x = 1 - g.image_x;
    g.begin = 1 - std::exchange(g.end, 1 - g.begin);
  }
  return m;
}

double partition_distance(const Partition& p, double x)
{
  for(const auto& i : p.intervals())
    if(x <= i.end)
      return p.image(i.image).distance_at(x);
  return std::numeric_limits<double>::infinity();
}

// The distance by an image, whose paths bend at the ends of its interval.
double bent_distance(const Image& g, double x)
{
  const double in_interval = (std::min)((std::max)(x, g.begin), g.end);
  return g.distance_at(in_interval) + std::abs(x - in_interval);
}

// No image that sees a point of the edge is nearer than the one that has it, and no path that bends at the end of an
// interval is shorter, up to the error of images that tie. (The intervals leave gaps, in front of images and behind.)
void the_nearest_image_takes_over(test_support::Random& random)
{
  double worst = 0, worst_bent = 0;
  std::size_t number_of_intervals = 0;
  for(std::size_t i = 0; i < 4000; ++i)
  {
    const Edge e = random_edge(random, i % 2 == 0);
    const Partition p = partition_of(e);
    number_of_intervals += p.intervals().size();
    for(std::size_t j = 0; j < 8; ++j)
    {
      const double x = random.uniform(0., 1.), found = partition_distance(p, x);
      for(const Image& g : e.images)
      {
        worst_bent = (std::max)(worst_bent, (found - bent_distance(g, x)) / (epsilon * (1 + found)));
        if(g.begin <= x && x <= g.end)
          worst = (std::max)(worst, (found - g.distance_at(x)) / (epsilon * (1 + found)));
      }
    }
  }
  std::cout << "excess of the image that has a point, over epsilon: " << worst << std::endl;
  CHECK(worst <= 32);
  std::cout << "excess over a path that bends, over epsilon: " << worst_bent << std::endl;
  CHECK(worst_bent <= 2 * internal::Tolerance<double>::tie() / epsilon);
  CHECK(number_of_intervals > 10000);
}

// Two images that are much nearer to each other and to the edge than the edge is long, and whose weights differ by the
// distance between them: they tie along most of the edge, but not beside them.
void images_that_nearly_touch_the_edge(test_support::Random& random)
{
  double worst = 0;
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const double size = std::pow(10., random.uniform(-11., -7.));
    const auto length = [&](double smallest) { return size * std::pow(10., random.uniform(smallest, 1.)); };
    const double d = length(-1), foot = random.uniform(.05, .9);
    const Image c{0., 1., foot, length(-2), 1 + d, 2};
    const Image g{foot - random.uniform(1e-4, 9e-4), 1., foot + d, length(-2), 1., 3};
    const Edge e{c.distance_at(0), (std::min)(c.distance_at(1), g.distance_at(1)), {c, g}};
    const Partition p = partition_of(e);
    CHECK(p.intervals().size() <= 8); // else they have taken turns
    for(const double x : {.95, random.uniform(foot, 1.)})
      worst = (std::max)(worst, partition_distance(p, x) - (std::min)(c.distance_at(x), g.distance_at(x)));
  }
  CHECK(worst <= 64 * epsilon);
}

// Divides an edge of length 1 between two sites, which own its ends. Returns the abscissa where the first cell ends.
double end_of_first_cell(const Image& c, const Image& g)
{
  Partition p;
  p.start(1., c.site, c.distance_at(0.), g.site, g.distance_at(1.));
  p.add(c);
  p.add(g);
  p.build();
  CHECK_EQUAL(p.breakpoints().size(), std::size_t(1));
  return p.breakpoints().front().x;
}

// The path from site 3 leads through site 2 if it runs along one ray, which meets the edge in its first end. That point
// belongs to site 2, which has no other point of the edge.
void a_cell_that_is_a_point_ends_there(test_support::Random& random)
{
  for(std::size_t i = 0; i < 2000; ++i)
  {
    const double angle = random.uniform(.2, 2.9), r = random.uniform(.01, 1.), s = r + random.uniform(.01, 1.);
    const Image c{0., 1., r * std::cos(angle), r * std::sin(angle), s - r, 2};
    const Image g{0., 1., s * std::cos(angle), s * std::sin(angle), 0., 3};
    CHECK(end_of_first_cell(c, g) <= 512 * epsilon);
  }
}

// Images on one ray whose weights differ by their distance, up to rounding: where two of them nearly touch, rounding
// may call either one the nearer one. They do not take turns.
void two_images_that_nearly_touch_do_not_take_turns()
{
  const std::array<std::vector<Image>, 3> cases{
    std::vector<Image>{{0, 1, 0, .00013372917987374689, 0, 2},
                       {0, 1, .012504554974713611, .00012704028434792834, .012504556763713566, 5}},
    std::vector<Image>{{0, 1, -.29340662897505709, .0012308573862355073, 2.2099727648542666, 2},
                       {0, 1, .31505033466373866, .0004884590405622221, 2.8184301814051969, 4}},
    std::vector<Image>{{0, 1, .25, .00068756808647515717, .83579722515393362, 2},
                       {0, 1, .25000238173935246, .00068756481125921908, .83579960689553801, 3},
                       {0, 1, .80842470967819224, .0001602920335329182, 1.3942221837644913, 5}}};
  for(const std::vector<Image>& images : cases)
  {
    const auto nearest = [&](double x)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for(const Image& g : images)
        smallest = (std::min)(smallest, g.distance_at(x));
      return smallest;
    };
    const Partition p = partition_of(Edge{nearest(0), nearest(1), images});
    CHECK(p.intervals().size() <= 8);
    for(double x = 0; x <= 1; x += 1. / 64)
      CHECK_NEAR(partition_distance(p, x), nearest(x), 64 * epsilon);
  }
}

// Two sites tie where the interval of one of them begins, and once more a bit farther on; the other one is nearer in
// between.
void a_short_part_between_two_ties(test_support::Random& random)
{
  for(std::size_t i = 0; i < 2000; ++i)
  {
    const double angle = random.uniform(.3, 1.2), r = random.uniform(.1, .5), s = r + random.uniform(.1, .5);
    const double middle = random.uniform(.2, .8), half = random.uniform(1e-4, 4e-4);
    const auto image = [&](double way, double weight, internal::Vertex_id site)
    { return Image{0., 1., middle + way * std::cos(angle), way * std::sin(angle), weight, site}; };
    const Image c = image(r, s, 2);
    Image g = image(s, 0., 3);
    g.weight = c.distance_at(middle + half) - g.distance_at(middle + half);
    double nearer = middle - 2 * half;
    g.begin = middle;
    for(int step = 0; step < 60; ++step)
    {
      const double x = (nearer + g.begin) / 2;
      (g.distance_at(x) < c.distance_at(x) ? nearer : g.begin) = x;
    }
    CHECK_NEAR(end_of_first_cell(c, g), middle + half, 1e-9);
  }
}

// The bisector of two sites that nearly coincide crosses the edge. Their distances tie from the beginning to the
// crossing, up to rounding, but one cell does not end in a point.
void two_sites_that_nearly_coincide(test_support::Random& random)
{
  for(std::size_t i = 0; i < 2000; ++i)
  {
    const double crossing = random.uniform(7e-4, 9e-4), depth = random.uniform(.3, .6), shift = 2e-13;
    const Image c{0., 1., crossing - shift, depth, 0., 2}, g{0., 1., crossing + shift, depth, 0., 3};
    CHECK_NEAR(end_of_first_cell(c, g), crossing, 4e-4);
  }
}

void an_image_that_ties_does_not_take_over(test_support::Random& random)
{
  for(std::size_t i = 0; i < 2000; ++i)
  {
    Edge e = random_edge(random, i % 2 == 0);
    const std::size_t n = e.images.size();
    for(std::size_t k = 0; k < n; ++k)
    {
      e.images.push_back(e.images[k]);
      e.images.back().site += 100;
    }
    const Partition p = partition_of(e);
    for(const auto& b : p.breakpoints())
      CHECK(b.before < 100 && b.after < 100);
    for(const auto& j : p.intervals())
      CHECK(j.image < 2 + n || j.image >= 2 + 2 * n);
  }
}

void edges_obey_symmetries(test_support::Random& random)
{
  for(std::size_t i = 0; i < 4000; ++i)
  {
    const Edge e = random_edge(random, i % 2 == 0);
    const Partition p = partition_of(e), small = partition_of(e, 0x1p-40);
    CHECK_EQUAL(small.breakpoints().size(), p.breakpoints().size());
    for(std::size_t b = 0; b < p.breakpoints().size(); ++b)
    {
      const auto &found = small.breakpoints()[b], &expected = p.breakpoints()[b];
      CHECK(found.x == 0x1p-40 * expected.x && found.before == expected.before && found.after == expected.after);
    }
    if(i % 2 == 0)
      continue; // paths that bend at the end of an interval go on to the right only
    const Partition m = partition_of(mirrored(e));
    for(std::size_t j = 0; j < 8; ++j)
    {
      const double x = random.uniform(0., 1.);
      CHECK_NEAR(partition_distance(m, 1 - x), partition_distance(p, x), 1e-12);
    }
  }
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20261123));
  triangles_satisfy_their_error_bounds(random);
  frames_from_lengths_satisfy_their_error_bound(random);
  frames_from_points_satisfy_their_error_bound(random);
  nearer_points_satisfy_bound_and_laws(random);
  nearer_distances_are_in_a_strict_order(random);
  the_nearest_image_takes_over(random);
  images_that_nearly_touch_the_edge(random);
  a_cell_that_is_a_point_ends_there(random);
  two_images_that_nearly_touch_do_not_take_turns();
  a_short_part_between_two_ties(random);
  two_sites_that_nearly_coincide(random);
  an_image_that_ties_does_not_take_over(random);
  edges_obey_symmetries(random);
  return test_support::test_result();
}
