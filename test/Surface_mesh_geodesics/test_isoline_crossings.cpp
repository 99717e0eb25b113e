// Where isolines cross edges: with the bounds of convex functions the same crossings are found as by halving alone, in
// far fewer steps, and they are those of points along the edge.

#include "curve_cases.h"
#include "run_from_curves.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Face_distances.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/isoline_crossings.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace curve_cases;

namespace {

namespace internal = CGAL::Surface_mesh_geodesics::internal;
using Face_distances = internal::Face_distances<double, internal::Edge_strip_field<double>>;
using Tolerance = internal::Tolerance<double>;

// Counts the points that are asked for; without bounds, only the Lipschitz bound saves points.
template <bool With_bounds>
struct Counted_distances : Face_distances
{
  double at(double t, double width)
  {
    ++number;
    return Face_distances::at(t, width);
  }

  bool may_cross(double s, double t, bool are_nearer, double value) const
  {
    return !With_bounds || Face_distances::may_cross(s, t, are_nearer, value);
  }

  std::size_t number = 0;
};

// The crossings of one edge.
template <typename Distances>
std::vector<double> crossings(const Run_from_curves& run, internal::Halfedge_id h, double value, Distances& distances)
{
  const auto& mesh = run.surface.mesh();
  distances.start(mesh, run.field, run.windows, run.arrivals.strips, internal::face_of(h));
  distances.start_edge(h);
  std::vector<double> result;
  const auto add = [&](double t) { result.push_back(t); };
  internal::Isoline_crossings<double, Distances>(mesh.length(h), internal::dividing_value(value), Tolerance::isoline(),
                                                 distances)
    .find(0., run.field.distance[mesh.source(h)], 1., run.field.distance[mesh.target(h)], add);
  return result;
}

// The distances at points along an edge.
std::vector<double> samples(const Run_from_curves& run, internal::Halfedge_id h, int n)
{
  Face_distances distances;
  distances.start(run.surface.mesh(), run.field, run.windows, run.arrivals.strips, internal::face_of(h));
  std::vector<double> result;
  for(int i = 0; i <= n; ++i)
    result.push_back(distances.at(internal::coordinates_on_halfedge(h, i / double(n))));
  return result;
}

// Values at random, and such that a line only just touches the edge, from the near side or from the far side.
std::vector<double> values_near(const std::vector<double>& samples, test_support::Random& random)
{
  const auto [least, largest] = std::minmax_element(samples.begin(), samples.end());
  std::vector<double> values;
  for(double part : {-.1, .1, random.uniform(), .9, 1.1})
    values.push_back(*least + part * (*largest - *least));
  for(double distance : {*least, *largest})
    for(double relative : {-1e-6, 1e-9, 1e-4})
      values.push_back(distance * (1 + relative));
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return !(v > 0); }), values.end());
  return values;
}

void same_crossings(const Indexed_mesh& indexed, std::uint64_t seed)
{
  const test_support::Scope scope(indexed.name);
  test_support::Random random(seed);
  const Mesh tm = to_face_graph(indexed);
  const Run_from_curves run(tm, {Curve(tm, random_locations(tm, 4, random)),
                                 Curve(tm, random_vertices_along_edges(tm, 3, random))});
  const auto& mesh = run.surface.mesh();
  std::size_t pairs = 0, points_with = 0, points_without = 0;
  constexpr int n = 256;
  for(internal::Face_id f = 0; f < mesh.number_of_faces(); ++f)
    for(unsigned int k = 0; k < 3; ++k)
    {
      const internal::Halfedge_id h = internal::halfedge_of(f, k);
      const std::vector<double> distances = samples(run, h, n);
      for(const double value : values_near(distances, random))
      {
        Counted_distances<true> with;
        Counted_distances<false> without;
        const std::vector<double> found = crossings(run, h, value, with);
        CHECK(found == crossings(run, h, value, without));
        points_with += with.number;
        points_without += without.number;
        pairs += found.size() > 1 ? 1 : 0;
        // Between two samples on different sides there is a crossing.
        for(int i = 0; i < n; ++i)
        {
          const auto at = distances.begin() + i;
          const double a = at[0] - value, b = at[1] - value;
          if(std::abs(a) < 1e-11 * value || std::abs(b) < 1e-11 * value || (a < 0) == (b < 0))
            continue;
          const auto next = std::lower_bound(found.begin(), found.end(), i / double(n) - 1e-12);
          CHECK(next != found.end() && *next <= (i + 1) / double(n) + 1e-12);
        }
      }
    }
  CHECK(pairs > 20);
  CHECK(points_with <= points_without);
}

// Squares around a border of straight lines, along edges of the mesh.
void lines_along_edges()
{
  const test_support::Scope scope("along edges");
  constexpr std::size_t n = 8;
  const Mesh tm = to_face_graph(flat_patch(n, n, 0., false, 1));
  const Run_from_curves run(tm, CGAL::Surface_mesh_geodesics::border_curves(tm));
  const auto& mesh = run.surface.mesh();
  std::size_t along = 0;
  for(internal::Face_id f = 0; f < mesh.number_of_faces(); ++f)
    for(unsigned int k = 0; k < 3; ++k)
    {
      const internal::Halfedge_id h = internal::halfedge_of(f, k);
      const double d = run.field.distance[mesh.source(h)], e = run.field.distance[mesh.target(h)];
      if(!(d > 0) || std::abs(d - e) > 1e-12 * d)
        continue;
      Counted_distances<true> with;
      Counted_distances<false> without;
      CHECK(crossings(run, h, d, with).empty());
      CHECK(crossings(run, h, d, without).empty());
      CHECK(with.number <= 300);
      along += without.number > 10000 ? 1 : 0;
    }
  CHECK(along > 4 * n);
}

} // namespace

int main()
{
  same_crossings(saddle_patch(4), 1);
  same_crossings(icosphere(1), 2);
  same_crossings(flat_patch(5, 5, .3, true, 3), 4);
  same_crossings(needle_sphere(6, 5), 5);
  same_crossings(rough_terrain(5, 1., 6), 7);
  lines_along_edges();
  return test_result();
}
