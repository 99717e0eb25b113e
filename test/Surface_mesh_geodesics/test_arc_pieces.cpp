// Pieces of bisectors and segments: where a third image is nearer anywhere, one of few points shows it; lines are met
// where they are met. Compared with many points of random pieces.

#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/certificate/Arc_piece.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_geodesics::internal;
using Point = Planar_point<double>;
using Image = Additively_weighted_point<double>;
using Piece = Arc_piece<double>;

Image random_image(test_support::Random& random)
{
  return {random.uniform(-1., 1.), random.uniform(-2., -.1), random.uniform(0., .5)};
}

// Points of the bisector in directions from the left image, none if it has no points in a direction.
std::vector<Point> points_of_bisector(const Image& left, const Image& right, double from, double to)
{
  std::vector<Point> points;
  const double dx = right.x - left.x, dy = right.y - left.y, s = left.weight - right.weight;
  for(int i = 0; i <= 400; ++i)
  {
    const double angle = from + (to - from) * i / 400, ex = std::cos(angle), ey = std::sin(angle);
    const double divisor = s + ex * dx + ey * dy, r = (dx * dx + dy * dy - s * s) / 2 / divisor;
    if(!(divisor > .05) || !(r > 0))
      return {};
    points.push_back({left.x + r * ex, left.y + r * ey});
  }
  return points;
}

struct Counts
{
  std::size_t pieces = 0, nearer_between = 0, crossings = 0, leaving = 0;
};

// The least distance from q, less the distance from the images of the piece, over points.
template <typename Points>
double least_lead(const Piece& piece, const Image& q, const Points& points)
{
  double least = std::numeric_limits<double>::infinity();
  for(const Point& p : points)
  {
    least = (std::min)(least, q.distance_to(p) - piece.value(p));
  }
  return least;
}

void check_third_image(const Piece& piece, const Image& q, const std::vector<Point>& points, Counts& counts)
{
  std::vector<Point> looked_at{piece.first(), piece.last()};
  const double at_ends = least_lead(piece, q, looked_at);
  piece.for_each_extremum(q, [&](const Point& p) { looked_at.push_back(p); });
  const double found = least_lead(piece, q, looked_at), right = least_lead(piece, q, points);
  // The points that are looked at are points of the piece.
  CHECK(found >= right - 1e-3);
  if(right < -1e-6)
  {
    CHECK(found < 0);
    counts.nearer_between += at_ends > 0 ? 1 : 0;
  }
}

// On the right of the line, seen from a to b, distances are positive.
double distance_to_the_right(const Point& a, const Point& b, const Point& p)
{
  return ((b.y - a.y) * (p.x - a.x) - (b.x - a.x) * (p.y - a.y)) / distance(a, b);
}

// Any line near the middle of the piece.
void check_line(const Piece& piece, const std::vector<Point>& points, const Point& a, const Point& b, Counts& counts)
{
  std::size_t expected = 0, found = 0;
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    expected += (distance_to_the_right(a, b, points[i]) < 0) != (distance_to_the_right(a, b, points[i + 1]) < 0);
  }
  piece.for_each_crossing(a, b, [&](const Point& p)
  {
    ++found;
    CHECK(std::abs(distance_to_the_right(a, b, p)) < 1e-9);
  });
  CHECK(found >= expected); // two crossings may lie between two of the points
  counts.crossings += expected;

  double right = 0, at_extremum = (std::max)(distance_to_the_right(a, b, piece.first()),
                                             distance_to_the_right(a, b, piece.last()));
  for(const Point& p : points)
  {
    right = (std::max)(right, distance_to_the_right(a, b, p));
  }
  const double at_ends = at_extremum;
  piece.for_each_extremum_from_line(a, b, [&](const Point& p)
  { at_extremum = (std::max)(at_extremum, distance_to_the_right(a, b, p)); });
  if(right > 1e-6)
  {
    CHECK(at_extremum > 0);
    counts.leaving += at_ends < 0 ? 1 : 0;
  }
}

void random_pieces(std::uint64_t seed, bool is_segment)
{
  test_support::Scope scope(is_segment ? "segments" : "bisectors");
  test_support::Random random(seed);
  Counts counts;
  for(int i = 0; i < 20000; ++i)
  {
    const Image left = random_image(random);
    Image right = random_image(random);
    if(is_segment) // the bisector is a line
    {
      right.weight = left.weight;
    }
    const double from = random.uniform(0., 3.), to = from + random.uniform(-1.5, 1.5);
    const std::vector<Point> points = points_of_bisector(left, right, from, to);
    if(points.empty() || distance(points.front(), points.back()) < 1e-3)
    {
      continue;
    }
    const Piece piece(points.front(), points.back(), left, right, is_segment);
    CHECK(piece.difference(points[200]) < 1e-12);
    // A third image that is about as far as the others, somewhere in the middle.
    Image q = random_image(random);
    q.weight += piece.value(points[200]) - q.distance_to(points[200]) + random.uniform(-1e-3, 1e-3);
    check_third_image(piece, q, points, counts);
    const Point a = {points[200].x + random.uniform(-.1, .1), points[200].y + random.uniform(-.1, .1)};
    check_line(piece, points, a, {a.x + random.uniform(-1., 1.), a.y + random.uniform(-1., 1.)}, counts);
    // A line that is almost a tangent.
    const double width = random.uniform(-1e-3, 1e-3), dx = points[201].x - points[199].x,
                 dy = points[201].y - points[199].y, length = std::hypot(dx, dy);
    const Point c = {points[200].x - dy / length * width, points[200].y + dx / length * width},
                d = {c.x + dx / length, c.y + dy / length};
    check_line(piece, points, c, d, counts);
    check_line(piece, points, d, c, counts);
    ++counts.pieces;
  }
  std::cout << counts.pieces << " pieces, " << counts.nearer_between << " with a third image between the ends, "
            << counts.crossings << " crossings, " << counts.leaving << " on both sides of a line\n";
  CHECK(counts.pieces > 1000);
  CHECK(counts.nearer_between > 20);
  CHECK(counts.crossings > 500);
  CHECK(is_segment || counts.leaving > 20);
}

// An end so near to the image that rounding hides its direction, on a bisector that is nearly a ray: the points that
// are looked at are on the piece, though the direction of that end says otherwise.
void end_at_the_image()
{
  test_support::Scope scope("end at the image");
  const Image left{0, 0, 0.0012082998812528618}, right{-0.00058562496233311215, -0.0010568973492350836, 0};
  const Point first{0.030731126520395908, 0.055463380678179158}, last{-1.166825509660739e-13, 3.7018273814886433e-13};
  const Piece piece(first, last, left, right, false);
  std::size_t number = 0;
  for(int i = 0; i < 48; ++i)
  {
    // An image in a direction between those of the ends, at no distance from the left one if weights count: the
    // extremum is in this direction.
    const double angle = std::atan2(first.y, first.x) + std::ldexp(.8, -i);
    const double x = 1e-3 * std::cos(angle), y = 1e-3 * std::sin(angle);
    piece.for_each_extremum(Image{x, y, left.weight - norm<double>(x, y)}, [&](const Point& p)
    {
      ++number;
      CHECK(distance(p, Point{0, 0}) <= distance(first, Point{0, 0}) * (1 + 1e-12));
      CHECK(piece.difference(p) < 1e-12);
    });
  }
  CHECK(number > 0);
}

// Pieces of parabolas, between a point and parallel rays: the points that are visited for a third image, near or at
// infinity, lie on the piece. If the third image is nearer anywhere, it is so at one of them or at an end.
void parabolas_are_compared_with_third_images()
{
  test_support::Random random(7);
  std::size_t number_between_ends = 0;
  const auto direction = [](double t) { return Point{std::cos(t), std::sin(t)}; };
  for(int i = 0; i < 12000; ++i)
  {
    const Image focus{random.uniform(-1., 1.), random.uniform(-1., 1.), random.uniform(0., 1.)};
    const Point n = direction(random.uniform(0., 6.28));
    // The value of the linear function at the focus, less the weight, is A.
    const double size = random.uniform(.1, 1.);
    const Image rays{n.x, n.y, focus.weight + size - (n.x * focus.x + n.y * focus.y), 1.};
    const double first = std::atan2(n.y, n.x) + random.uniform(.5, 2.5), last = first + random.uniform(.2, 2.8);
    const auto point = [&](double t)
    {
      const Point e = direction(t);
      const double r = size / (1 - n.x * e.x - n.y * e.y);
      return Point{focus.x + r * e.x, focus.y + r * e.y};
    };
    const Piece piece = i % 2 == 0 ? Piece(point(first), point(last), focus, rays, false)
                                   : Piece(point(first), point(last), rays, focus, false);
    const Point middle = point((first + last) / 2), m = direction(random.uniform(0., 6.28));
    const double value = piece.value(middle) + random.uniform(-.05, .05);
    const Point other{random.uniform(-2., 2.), random.uniform(-2., 2.)};
    const Image third = i % 3 == 0
                          ? Image{m.x, m.y, value - (m.x * middle.x + m.y * middle.y), 1.}
                          : Image{other.x, other.y, value - std::hypot(other.x - middle.x, other.y - middle.y)};
    const auto excess = [&](const Point& p) { return third.weight + third.way_to(p) - piece.value(p); };
    double at_ends = (std::min)(excess(point(first)), excess(point(last))), visited = at_ends, sampled = at_ends;
    piece.for_each_extremum(third, [&](const Point& p)
    {
      CHECK(piece.difference(p) < 1e-12);
      visited = (std::min)(visited, excess(p));
    });
    for(int k = 0; k <= 200; ++k)
      sampled = (std::min)(sampled, excess(point(first + (last - first) * k / 200)));
    CHECK(!(sampled < -1e-12) || visited < 0);
    number_between_ends += sampled < -1e-12 && !(at_ends < 0) ? 1 : 0;
  }
  CHECK(number_between_ends > 10);
}

} // namespace

int main()
{
  parabolas_are_compared_with_third_images();
  const std::uint64_t seed = test_support::announce_seed(20261126);
  random_pieces(seed, false);
  random_pieces(seed + 1, true);
  end_at_the_image();
  return test_result();
}
