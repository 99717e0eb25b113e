// Edges with thousands of windows, as in a mesh that is stretched in one direction: an edge is divided in nearly linear
// time, also if there are gaps between the windows, and the diagram is right.

#include "Voronoi_test_helpers.h"
#include "mesh_operations.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Edge_partition.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Interval_sweep.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace test_meshes;

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using Image = internal::Edge_image<double>;
using Partition = internal::Edge_partition<double>;

struct Interval
{
  double begin, end;
};

// Random intervals, some of them equal or empty. After each step, a sweep knows which of them meet the part up to
// `last`, also of those that were added.
void a_sweep_finds_what_meets_a_part(test_support::Random& random)
{
  for(std::size_t i = 0; i < 200; ++i)
  {
    std::vector<Interval> intervals;
    const auto abscissa = [&] { return static_cast<double>(random.index(20)); };
    for(std::size_t n = random.index(30); n > 0; --n)
    {
      const double begin = abscissa();
      intervals.push_back({begin, (std::max)(begin, abscissa())});
    }
    internal::Interval_sweep<double> sweep;
    sweep.start(intervals);
    for(double x = 0; x < 20; x += static_cast<double>(random.index(3)) / 2)
    {
      sweep.advance(x, intervals);
      if(random.index(4) == 0)
      {
        sweep.add_open(intervals.size());
        intervals.push_back({x, 20});
      }
      std::vector<std::size_t> found = sweep.open(), expected;
      const double last = x + static_cast<double>(random.index(5));
      sweep.for_each_ahead(last, [&](std::size_t j) { found.push_back(j); });
      for(std::size_t j = 0; j < intervals.size(); ++j)
        if(intervals[j].begin <= x ? intervals[j].end > x : intervals[j].begin <= last)
          expected.push_back(j);
      std::sort(found.begin(), found.end());
      CHECK(found == expected);
    }
  }
}

// Windows ahead that begin behind `last` are not visited, although `last` decreases during the visits.
void a_visit_may_end_a_sweep()
{
  internal::Interval_sweep<double> sweep;
  sweep.start(std::vector<Interval>{{3, 4}, {1, 2}, {2, 3}});
  double last = 5;
  std::vector<std::size_t> found;
  sweep.for_each_ahead(last, [&](std::size_t j)
  {
    found.push_back(j);
    last = 2;
  });
  CHECK((found == std::vector<std::size_t>{1, 2}));
}

// An edge of length 1 with n windows from each side. Those of one site come through many faces; at 1/2, the site of the
// other side becomes the nearest one. Gaps are left at the ends of intervals, as rounding does: in front of the windows
// of the first site, behind those of the second one, which come in descending order.
Partition partition_with_windows(std::size_t n, double gap)
{
  const Image first{0, 1, -.25, .5, 1, 2}, second{0, 1, 1.25, .5, 1, 3};
  Partition p;
  p.start(1., 2, first.distance_at(0), 3, second.distance_at(1));
  const double width = 1 / static_cast<double>(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    Image g = first;
    g.begin = (static_cast<double>(i) + gap) * width;
    g.end = static_cast<double>(i + 1) * width;
    p.add(g);
  }
  for(std::size_t i = n; i-- > 0;)
  {
    Image g = second;
    g.begin = static_cast<double>(i) * width;
    g.end = (static_cast<double>(i + 1) - gap) * width;
    p.add(g);
  }
  p.build();
  return p;
}

void an_edge_is_divided_in_linear_time()
{
  for(const double gap : {0., .125})
  {
    const Partition small = partition_with_windows(500, gap), large = partition_with_windows(4000, gap);
    CHECK(large.intervals().size() >= 4000);
    CHECK(small.number_of_trials() <= 16 * 1000);
    CHECK(large.number_of_trials() <= 9 * small.number_of_trials());
    CHECK(large.breakpoints().size() == 1);
    CHECK_NEAR(large.breakpoints()[0].x, .5, gap == 0 ? 1e-15 : 1. / 4000);
  }
}

// Faces that are long in one direction: windows cross many of them side by side.
void a_diagram_of_a_stretched_mesh(test_support::Random& random)
{
  const test_support::Scope scope("stretched mesh");
  const auto stretch = [](const Coordinates& c) { return Coordinates{256 * c[0], c[1], c[2]}; };
  const Mesh tm = to_face_graph(transformed(rough_terrain(24, .1, 7), "stretched terrain", stretch));
  Voronoi diagram(tm);
  for(std::size_t i = 0; i < 6; ++i)
    diagram.add_site(vertex_descriptor(static_cast<Mesh::size_type>(random.index(num_vertices(tm)))));
  CHECK(CGAL::Surface_mesh_geodesics::certify_geodesic_Voronoi_diagram(diagram).is_certified());
}

} // namespace

int main()
{
  test_support::Random random(20261129);
  a_sweep_finds_what_meets_a_part(random);
  a_visit_may_end_a_sweep();
  an_edge_is_divided_in_linear_time();
  a_diagram_of_a_stretched_mesh(random);
  return test_result();
}
