// Isolines have the nearer points on their left: in the plane, beside each segment; on curved surfaces, as signed
// distances from the curves of lines tell, which are negative on the left of the first curve.

#include "numbered_lines.h"
#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_isolines.h>
#include <CGAL/Surface_mesh_geodesics/polyline_curve.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

using namespace numbered_lines;
using namespace test_meshes;
namespace SMG = CGAL::Surface_mesh_geodesics;

namespace {

using Point = Kernel::Point_3;
using Vertex = Mesh::Vertex_index;
using Curve = SMG::Surface_curve<Mesh>;

double distance_in_plane(const Mesh& tm, const std::vector<Vertex>& sources, double x, double y)
{
  double result = std::numeric_limits<double>::infinity();
  for(const Vertex s : sources)
    result = (std::min)(result, std::hypot(x - tm.point(s).x(), y - tm.point(s).y()));
  return result;
}

// Several sources: lines are closed, begin at the border, and bend where two sources are equally far.
void lines_in_the_plane(const Mesh& tm, std::uint64_t seed)
{
  test_support::Random random(seed);
  const std::vector<Vertex> sources{random_vertex(tm, random), random_vertex(tm, random), random_vertex(tm, random)};
  const double size = size_of(tm);
  std::vector<double> levels;
  for(std::size_t i = 0; i < 12; ++i)
    levels.push_back(random.uniform(.02, .8) * size);
  Numbered_lines lines;
  SMG::geodesic_isolines(tm, sources, levels, std::back_inserter(lines));
  CHECK(!lines.empty());
  std::size_t number_of_segments = 0;
  for(const auto& line : lines)
    for(std::size_t i = 1; i < line.second.size(); ++i)
    {
      const Point &p = line.second[i - 1], &q = line.second[i];
      const double dx = q.x() - p.x(), dy = q.y() - p.y(), length = std::hypot(dx, dy);
      if(length < 1e-6 * size)
        continue;
      ++number_of_segments;
      const double x = (p.x() + q.x()) / 2, y = (p.y() + q.y()) / 2, ux = -1e-3 * dy, uy = 1e-3 * dx;
      CHECK(distance_in_plane(tm, sources, x + ux, y + uy) < distance_in_plane(tm, sources, x - ux, y - uy));
    }
  CHECK(number_of_segments > 50);
}

// The lines of one level separate the surface. Whichever of their curves comes first, vertices that are nearer than the
// level are on the negative side. (Chords are a little beside the lines, so vertices near the level do not count.)
std::size_t lines_on_a_surface(const Mesh& tm, std::uint64_t seed)
{
  test_support::Random random(seed);
  const std::vector<Vertex> sources{random_vertex(tm, random), random_vertex(tm, random)};
  std::vector<double> distance(tm.number_of_vertices()), signed_distance(distance);
  const auto index = get(boost::vertex_index, tm);
  SMG::geodesic_distances(tm, boost::make_iterator_property_map(distance.begin(), index), sources);
  const double farthest = *std::max_element(distance.begin(), distance.end());
  const double level = random.uniform(.3, .8) * farthest;
  Numbered_lines lines;
  SMG::geodesic_isolines(tm, sources, std::vector<double>{level}, std::back_inserter(lines));
  std::vector<Curve> curves;
  for(const auto& line : lines)
    curves.push_back(SMG::polyline_curve(tm, line.second));
  for(std::size_t first = 0; first < curves.size(); ++first)
  {
    std::rotate(curves.begin(), curves.begin() + 1, curves.end());
    SMG::signed_geodesic_distances(tm, boost::make_iterator_property_map(signed_distance.begin(), index), curves);
    for(std::size_t v = 0; v < distance.size(); ++v)
      if(std::abs(distance[v] - level) > .05 * farthest)
        CHECK_EQUAL(signed_distance[v] < 0, distance[v] < level);
  }
  return curves.size();
}

} // namespace

int main()
{
  const std::uint64_t seed = test_support::announce_seed(20261129);
  for(std::uint64_t i = 0; i < 6; ++i)
  {
    lines_in_the_plane(to_face_graph(flat_patch(14, 14, .3, true, i)), seed + i);
    lines_in_the_plane(to_face_graph(flat_patch(9, 9, 0., false, i)), seed + 10 + i);
  }
  std::size_t number_of_curves = 0;
  for(const Indexed_mesh& indexed : {noisy_sphere(4, .05, seed), icosphere(4), torus(2, .7, 48, 24),
                                     rough_terrain(24, .5, seed), wavy_tube(24, 20)})
    for(std::uint64_t i = 0; i < 3; ++i)
    {
      test_support::Scope scope(indexed.name);
      number_of_curves += lines_on_a_surface(to_face_graph(indexed), seed + i);
    }
  CHECK(number_of_curves > 20);
  return test_result();
}
