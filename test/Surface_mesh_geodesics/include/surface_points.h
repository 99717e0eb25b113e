#ifndef SURFACE_MESH_GEODESICS_SURFACE_POINTS_H
#define SURFACE_MESH_GEODESICS_SURFACE_POINTS_H

// Points of a mesh in all representations that a user may pass: vertices, locations in each face around an edge or a
// vertex, and such locations with noise.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <cstddef>
#include <vector>

namespace test_meshes {

// Returns a vertex, its location in each of its faces, and these locations with noise.
inline std::vector<Surface_point> at_vertex(std::size_t i, const Mesh& tm)
{
  const vertex_descriptor v = vertex(i);
  std::vector<Surface_point> points{v};
  for(const face_descriptor f : faces_around(v, tm))
  {
    points.push_back(location_of_vertex(v, f, tm));
    const std::vector<Face_location> noisy = noisy_locations_of_vertex(v, f, tm);
    points.insert(points.end(), noisy.begin(), noisy.end());
  }
  return points;
}

// Returns the locations, and the same with noise instead of zeros.
inline std::vector<Surface_point> with_noise(const std::vector<Face_location>& locations)
{
  std::vector<Surface_point> points(locations.begin(), locations.end());
  for(const Face_location& exact : locations)
  {
    for(const double noise : {1.1e-16, -5.6e-17})
    {
      Face_location location = exact;
      for(double& b : location.second)
      {
        if(b == 0.)
        {
          b = noise;
        }
      }
      points.push_back(location);
    }
  }
  return points;
}

inline Coordinates position(const Surface_point& p, const Mesh& tm)
{
  return p.is_vertex() ? coordinates(p.vertex, tm) : coordinates(p.location, tm);
}

inline Surface_point in_plane(double x, double y, const Mesh& tm)
{
  return location_in_plane(x, y, tm);
}

// Returns all representations of one random point: a vertex, a point of an edge, or a point inside a face.
inline std::vector<Surface_point> random_spot(const Mesh& tm, test_support::Random& random)
{
  const std::size_t kind = random.index(4);
  if(kind == 0)
  {
    return at_vertex(std::size_t(random_vertex(tm, random)), tm);
  }
  if(kind == 1)
  {
    return {Surface_point(random_location(tm, random, random.index(3) == 0 ? 1e-6 : 1e-2))};
  }
  std::vector<Mesh::Edge_index> all_edges(edges(tm).begin(), edges(tm).end());
  const auto e = all_edges[random.index(all_edges.size())];
  const auto h = halfedge(e, tm);
  const double special[8] = {.5, .25, 1. / 3., .75, .9, 1e-3, 1e-7, 1. - 1e-7};
  const double t = random.index(2) == 0 ? random.uniform(.01, .99) : special[random.index(8)];
  return with_noise(on_edge(std::size_t(source(h, tm)), std::size_t(target(h, tm)), t, tm));
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_SURFACE_POINTS_H
