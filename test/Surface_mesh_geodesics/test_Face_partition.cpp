// The partition of a face in which many cells meet: the number of traced fronts stays linear, and fronts find their
// partners.

#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Face_partition.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using Partition = internal::Face_partition<double>;
using Point = Partition::Point;
using Site = internal::Vertex_id;

const std::array<Point, 3> corner{Point{0., 0.}, Point{1., 0.}, Point{.5, 1.}};

Partition::Image image(double x, double y, Site site)
{
  Partition::Image g;
  g.point = internal::Additively_weighted_point<double>{x, y, 0.};
  g.site = site;
  return g;
}

// The images lie in a row below the first side, so the curves are parallel: each leads from the first side to another.
void parallel_curves_lead_to_another_side(std::size_t n)
{
  test_support::Scope scope(std::to_string(n) + " parallel curves");
  Partition partition;
  partition.start(corner);
  const double step = 1. / static_cast<double>(n + 1);
  for(std::size_t i = 0; i <= n; ++i)
  {
    partition.add(image((static_cast<double>(i) + .5) * step, -.5, static_cast<Site>(i)));
  }
  const auto abscissa = [&](std::size_t i) { return static_cast<double>(i) * step; };
  for(std::size_t i = 1; i <= n; ++i)
  {
    partition.add(Partition::Breakpoint{Point{abscissa(i), 0.}, static_cast<Site>(i - 1), static_cast<Site>(i)});
  }
  for(std::size_t i = n; i > 0; --i)
  {
    const double y = 2. * (std::min)(abscissa(i), 1. - abscissa(i));
    partition.add(Partition::Breakpoint{Point{abscissa(i), y}, static_cast<Site>(i), static_cast<Site>(i - 1)});
  }
  partition.build();
  CHECK_EQUAL(partition.arcs().size(), n);
  CHECK_EQUAL(partition.nodes().size(), 2 * n);
  CHECK_EQUAL(partition.number_of_joints(), 0u);
  CHECK(partition.number_of_traces() <= 3 * n);
}

// Adds n images in a row below the first side, with indices from 0 on, and the breakpoints between them on that side.
void add_row(Partition& partition, std::size_t n, double depth)
{
  const double step = 1. / static_cast<double>(n);
  const auto abscissa = [&](std::size_t i) { return static_cast<double>(i) * step; };
  for(std::size_t i = 0; i < n; ++i)
  {
    partition.add(image(abscissa(i) + step / 2, -depth, static_cast<Site>(i)));
  }
  for(std::size_t i = 1; i < n; ++i)
  {
    partition.add(Partition::Breakpoint{Point{abscissa(i), 0.}, static_cast<Site>(i - 1), static_cast<Site>(i)});
  }
}

Site nearest_site(const Partition& partition, const Point& p)
{
  Site best = 0;
  double smallest = 1e300;
  for(const Partition::Image& g : partition.images())
  {
    const double d = g.point.distance_to(p);
    if(d < smallest)
    {
      best = g.site;
      smallest = d;
    }
  }
  return best;
}

// Adds the breakpoints on a side. Finds them by small steps along the side and bisection.
void add_breakpoints(Partition& partition, unsigned int side, std::size_t steps)
{
  const auto on_side = [&](double t)
  {
    const Point &a = corner[side], &b = corner[(side + 1) % 3];
    return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
  };
  for(std::size_t i = 0; i < steps; ++i)
  {
    double from = static_cast<double>(i) / static_cast<double>(steps);
    double to = static_cast<double>(i + 1) / static_cast<double>(steps);
    const Site before = nearest_site(partition, on_side(from)), after = nearest_site(partition, on_side(to));
    if(before == after)
    {
      continue;
    }
    for(int k = 0; k < 60; ++k)
    {
      const double middle = (from + to) / 2.;
      (nearest_site(partition, on_side(middle)) == before ? from : to) = middle;
    }
    partition.add(Partition::Breakpoint{on_side(to), before, after});
  }
}

// The image above the face has its cell behind a row of small cells. The curves between these end at its boundary.
void curves_end_at_the_cell_behind_them(std::size_t n)
{
  test_support::Scope scope("a row of " + std::to_string(n) + " cells");
  Partition partition;
  partition.start(corner);
  const double depth = .125, height = 1.125;
  add_row(partition, n, depth);
  partition.add(image(.5, height, static_cast<Site>(n)));
  for(unsigned int side = 1; side < 3; ++side)
  {
    add_breakpoints(partition, side, 64 * n);
  }
  partition.build();
  const std::size_t vertices = static_cast<std::size_t>(
    std::count_if(partition.nodes().begin(), partition.nodes().end(), [](const auto& node) { return node.is_vertex; }));
  CHECK(2 * vertices >= n / 2);
  CHECK_EQUAL(partition.number_of_joints(), 0u);
  CHECK(partition.number_of_traces() <= 8 * n);
}

// Searches in lists that are short, long, and long with few sites give what comparing all fronts gives.
void partners_are_found()
{
  using Front = internal::Cell_front<double>;
  test_support::Random random(20261129);
  internal::Front_partners<double> partners;
  std::size_t found = 0;
  for(std::size_t k = 0; k < 200; ++k)
  {
    std::vector<Front> fronts;
    const std::size_t n = 1 + random.index(60), number_of_sites = 2 + random.index(12);
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t left = random.index(number_of_sites);
      const std::size_t right = (left + 1 + random.index(number_of_sites - 1)) % number_of_sites;
      fronts.emplace_back(static_cast<Site>(left), static_cast<Site>(right), Point{0., 0.}, i);
    }
    partners.restart();
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t from = random.index(2) == 0 ? 0 : i + 1, divisor = 1 + random.index(3);
      std::size_t expected = from;
      while(expected < n && (fronts[expected].left != fronts[i].right || fronts[expected].right != fronts[i].left
                             || expected % divisor != 0))
        ++expected;
      const std::size_t first = partners.first(fronts, i, from, [&](std::size_t j) { return j % divisor == 0; });
      CHECK_EQUAL(first, expected);
      found += first < n;
    }
  }
  CHECK(found > 500);
}

} // namespace

int main()
{
  partners_are_found();
  for(std::size_t n : {4u, 32u, 256u, 1000u})
  {
    parallel_curves_lead_to_another_side(n);
    curves_end_at_the_cell_behind_them(n);
  }
  return test_result();
}
