// Points along a curve as sources: their distances are bounds from above of those from the curve, with an error that is
// quadratic in the way from one point to the next.

#include "curves_in_plane.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <CGAL/Polygon_mesh_processing/locate.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

using namespace curve_cases;
namespace SMG = CGAL::Surface_mesh_geodesics;

namespace {

double mean_excess(const Mesh& tm, const std::vector<Curve>& curves, const Distances& d, std::size_t n)
{
  std::vector<Location> points;
  for(const Curve& c : curves)
    for(std::size_t i = 0; i < c.segments().size(); ++i)
      for(std::size_t j = 0; j <= n; ++j)
        points.push_back(c.location(i, static_cast<double>(j) / static_cast<double>(n)));
  Distances from_points;
  SMG::geodesic_distances(tm, boost::make_assoc_property_map(from_points), points);
  double excess = 0;
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK(from_points.at(v) >= d.at(v) * (1 - 1e-12) - 1e-14);
    // The error is quadratic at vertices that are farther away than the points are from each other.
    if(d.at(v) > extent(tm) / 2)
      excess += from_points.at(v) - d.at(v);
  }
  return excess / static_cast<double>(num_vertices(tm));
}

void test_points_along_curves()
{
  test_support::Random random(5);
  double sum[3] = {0, 0, 0}; // of all meshes, as the error is linear in front of a vertex where paths bend
  for(const Indexed_mesh& indexed : small_collection(3))
  {
    const test_support::Scope scope(indexed.name);
    const Mesh tm = to_face_graph(indexed);
    const std::vector<Curve> curves{Curve(tm, random_vertices_along_edges(tm, 4, random)), random_curve(tm, random)};
    if(curves[1].segments().empty())
      continue;
    const Distances d = distances(tm, curves);
    double excess[3] = {0, 0, 0};
    bool is_connected = true;
    for(const auto& entry : d)
      is_connected = is_connected && entry.second < infinity;
    if(!is_connected)
      continue;
    for(std::size_t i = 0; i < 3; ++i)
      excess[i] = mean_excess(tm, curves, d, std::size_t(4) << 2 * i);
    CHECK(excess[0] <= extent(tm) / 8);
    for(std::size_t i = 0; i < 3; ++i)
      sum[i] += excess[i] / extent(tm);
  }
  CHECK(sum[0] > .001);
  std::cout << "mean excess with 4, 16 and 64 points a segment: " << sum[0] << ' ' << sum[1] << ' ' << sum[2] << "\n";
  CHECK(sum[1] < .15 * sum[0] && sum[2] < .15 * sum[1]); // an error that is linear would shrink to a quarter
}

// Takes at least ten thousand points along a curve, at most h apart, as sources. The distances from them are at least
// those from the curve, and at most bound(distance from the curve, h).
template <typename Bound>
void check_many_points(const Mesh& tm, const Curve& curve, Bound bound)
{
  const Distances d = distances(tm, {curve});
  const std::size_t number_of_segments = curve.segments().size(), n = 1 + 10000 / number_of_segments;
  std::vector<Location> points;
  double h = 0;
  for(std::size_t i = 0; i < number_of_segments; ++i)
  {
    for(std::size_t j = 0; j <= n; ++j)
      points.push_back(curve.location(i, static_cast<double>(j) / static_cast<double>(n)));
    const auto first = CGAL::Polygon_mesh_processing::construct_point(curve.location(i, 0.), tm);
    const auto last = CGAL::Polygon_mesh_processing::construct_point(curve.location(i, 1.), tm);
    h = std::max(h, std::sqrt(CGAL::squared_distance(first, last)) / static_cast<double>(n));
  }
  CHECK(points.size() >= 10000);
  Distances from_points;
  SMG::geodesic_distances(tm, boost::make_assoc_property_map(from_points), points);
  for(const vertex_descriptor v : vertices(tm))
  {
    CHECK(from_points.at(v) >= d.at(v) * (1 - 1e-12));
    CHECK(from_points.at(v) <= bound(d.at(v), h) + 1e-12);
  }
}

// Along a polygon in the plane. The nearest point of a side is at most h / 2 from one of the points.
void test_many_points_in_plane()
{
  const test_support::Scope scope("many points in the plane");
  const Mesh tm = to_face_graph(flat_patch(6, 6, .3, true, 4));
  const std::vector<Point_2> corners{{.7, 1.1}, {5.2, .4}, {4.9, 5.6}, {2.3, 2.2}, {.9, 5.1}};
  std::vector<Location> locations;
  for(std::size_t i = 0; i < corners.size(); ++i)
    append_crossings(tm, corners[i], corners[(i + 1) % corners.size()], locations);
  check_many_points(tm, Curve(tm, locations, true), [](double d, double h) { return std::hypot(d, h / 2); });
}

// On surfaces that are not flat, a path may lead along the curve from its nearest point to the next one.
void test_many_points_on_surfaces()
{
  test_support::Random random(7);
  for(const Indexed_mesh& indexed : {noisy_sphere(2, .1, 5), rough_terrain(12, 1.5, 6), genus_2_polycube()})
  {
    const test_support::Scope scope("many points on " + indexed.name);
    const Mesh tm = to_face_graph(indexed);
    check_many_points(tm, Curve(tm, random_vertices_along_edges(tm, 20, random)),
                      [](double d, double h) { return d + h / 2; });
  }
}

} // namespace

int main()
{
  test_points_along_curves();
  test_many_points_in_plane();
  test_many_points_on_surfaces();
  return test_result();
}
