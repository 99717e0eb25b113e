#ifndef SURFACE_MESH_GEODESICS_CURVE_CASES_H
#define SURFACE_MESH_GEODESICS_CURVE_CASES_H

// Random curves on surfaces, and distances by another way: for a vertex v, the smallest distance from v to a point
// of a segment, with v as the source. Queries of the class for paths give the distances to points of a segment; samples
// and sections around the best ones give the smallest distance.

#include "hostile_meshes.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace curve_cases {

using namespace test_meshes;

using Curve = CGAL::Surface_mesh_geodesics::Surface_curve<Mesh>;
using Location = Curve::Face_location;
using Distances = std::map<vertex_descriptor, double>;
using Paths = CGAL::Surface_mesh_geodesic_paths<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;


// --- random curves ---

inline std::array<double, 3> random_coordinates(test_support::Random& random)
{
  std::array<double, 3> b{1, 0, 0};
  switch(random.index(5))
  {
  case 0:
    break; // a corner
  case 1:
    b[1] = random.index(2) == 0 ? .5 : random.uniform(); // on an edge
    break;
  case 2:
    b[1] = hostile_meshes::of_any_scale(-17., -1., random);
    b[2] = hostile_meshes::of_any_scale(-17., -1., random);
    break;
  case 3:
    b[1] = .25;
    b[2] = .5;
    break;
  default:
    b[1] = random.uniform() / 2;
    b[2] = random.uniform() / 2;
  }
  b[0] = 1 - b[1] - b[2];
  std::rotate(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(random.index(3)), b.end());
  return b;
}

// The same point of the edge opposite to corner k of a face, in the face across.
inline bool to_neighbor(const Mesh& tm, Location& l, std::size_t k)
{
  auto h = halfedge(l.first, tm);
  for(std::size_t i = 0; i != (k + 1) % 3; ++i)
    h = next(h, tm);
  const auto o = opposite(h, tm);
  if(is_border(o, tm))
    return false;
  const double source_weight = l.second[(k + 1) % 3], target_weight = l.second[(k + 2) % 3];
  Location other(face(o, tm), {0, 0, 0});
  auto g = halfedge(other.first, tm);
  for(std::size_t i = 0; i < 3; ++i, g = next(g, tm))
  {
    if(g == o)
      other.second[i] = target_weight;
    if(prev(g, tm) == o)
      other.second[i] = source_weight;
  }
  l = other;
  return true;
}

// A walk through faces: points in one face, then on through an edge.
inline std::vector<Location> random_locations(const Mesh& tm, std::size_t n, test_support::Random& random)
{
  Location at(random_location(tm, random).first, random_coordinates(random));
  std::vector<Location> locations{at};
  while(locations.size() < n)
  {
    at.second = random_coordinates(random);
    locations.push_back(at);
    if(random.index(8) == 0)
      locations.push_back(locations[random.index(locations.size())].first == at.first ? locations.back() : at);
    const std::size_t k = random.index(3);
    if(at.second[k] == 0 && random.index(4) != 0)
      to_neighbor(tm, at, k);
  }
  return locations;
}

inline std::vector<vertex_descriptor> random_vertices_along_edges(const Mesh& tm, std::size_t n,
                                                                  test_support::Random& random)
{
  auto h = halfedge(random_location(tm, random).first, tm);
  std::vector<vertex_descriptor> result{source(h, tm)};
  while(result.size() < n)
  {
    result.push_back(target(h, tm));
    for(std::size_t i = random.index(8); i > 0; --i)
      h = opposite(next(h, tm), tm);
    h = next(h, tm);
  }
  return result;
}

inline Curve random_curve(const Mesh& tm, test_support::Random& random)
{
  const std::size_t n = 1 + random.index(6), kind = random.index(6);
  if(kind == 0)
    return Curve(tm, random_vertices_along_edges(tm, n, random));
  std::vector<Location> locations = random_locations(tm, n, random);
  if(kind == 1) // there and back
    locations.insert(locations.end(), locations.rbegin(), locations.rend());
  if(kind == 2)
    for(Location& l : locations) // closed, in one face
      l.first = locations[0].first;
  return Curve(tm, locations, kind == 2);
}

inline std::vector<Curve> random_curves(const Mesh& tm, test_support::Random& random)
{
  std::vector<Curve> curves;
  for(std::size_t i = 1 + random.index(3); i > 0; --i)
    curves.push_back(random_curve(tm, random));
  return curves;
}

// --- distances by another way ---

// The distances from one vertex to the points of a mesh.
class Distance_from_vertex
{
public:
  Distance_from_vertex(const Mesh& tm, vertex_descriptor v) : m_paths(tm) { m_paths.add_source_point(v); }

  double to(const Location& l)
  {
    return clean(
      m_paths.shortest_distance_to_source_points(l.first, {{l.second[0], l.second[1], l.second[2]}}).first);
  }
  double to(vertex_descriptor v) { return clean(m_paths.shortest_distance_to_source_points(v).first); }

  // The smallest distance to a point of the curve, by n samples on each segment.
  double to(const Curve& curve, std::size_t n)
  {
    double best = curve.segments().empty() ? to(curve.vertex()) : infinity;
    for(std::size_t i = 0; i < curve.segments().size(); ++i)
    {
      const auto at = [&](double t) { return to(curve.location(i, (std::min)(1., (std::max)(0., t)))); };
      std::vector<std::pair<double, double>> samples;
      for(std::size_t j = 0; j <= n; ++j)
        samples.emplace_back(at(static_cast<double>(j) / static_cast<double>(n)),
                             static_cast<double>(j) / static_cast<double>(n));
      std::sort(samples.begin(), samples.end());
      for(std::size_t j = 0; j < (std::min)(samples.size(), std::size_t(4)); ++j)
        best = (std::min)(best, smallest_around(at, samples[j].second, 1. / static_cast<double>(n)));
    }
    return best;
  }

private:
  static double clean(double d) { return d < 0 ? infinity : d; }

  template <typename At>
  static double smallest_around(const At& at, double t, double width)
  {
    double best = at(t);
    for(; width > 1e-17; width /= 2)
      for(const double u : {t - width / 2, t + width / 2})
        if(at(u) < best)
        {
          best = at(u);
          t = u;
        }
    return best;
  }

  Paths m_paths;
};

inline Distances distances(const Mesh& tm, const std::vector<Curve>& curves)
{
  Distances result;
  CGAL::Surface_mesh_geodesics::geodesic_distances(tm, boost::make_assoc_property_map(result), curves);
  return result;
}

inline double extent(const Mesh& tm)
{
  double size = 0;
  for(const auto e : edges(tm))
    size = (std::max)(size, std::sqrt(CGAL::to_double(CGAL::squared_distance(
                              tm.point(source(e, tm)), tm.point(target(e, tm))))));
  return size;
}

// The relative error of the distance of a vertex, beyond the rounding of the extent.
inline double error_at(const Mesh& tm, const std::vector<Curve>& curves, vertex_descriptor v, double found)
{
  Distance_from_vertex from(tm, v);
  double error = infinity;
  for(const std::size_t n : {8u, 64u, 512u})
  {
    double best = infinity;
    for(const Curve& c : curves)
      best = (std::min)(best, from.to(c, n));
    if(!(best < infinity) || !(found < infinity))
      return best < found || found < best ? infinity : 0;
    error = (std::max)(0., std::abs(best - found) - 64 * std::numeric_limits<double>::epsilon() * extent(tm))
          / (std::max)(best, found);
    if(!(error > 1e-12) || found > best)
      break; // samples may miss the nearest point, so that more of them are needed
  }
  return error == error ? error : 0;
}

// Calls check(tm, curves, random) for 60 hostile meshes, each within a scope with random curves on it.
template <typename Check>
void for_each_hostile_case(const Check& check)
{
  for(std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    const test_support::Scope scope("hostile " + std::to_string(seed));
    test_support::Random random(seed);
    Mesh tm;
    if(hostile_meshes::is_surface(hostile_meshes::hostile_mesh(random), tm))
    {
      const std::vector<Curve> curves = random_curves(tm, random);
      check(tm, curves, random);
    }
  }
}

} // namespace curve_cases

#endif // SURFACE_MESH_GEODESICS_CURVE_CASES_H
