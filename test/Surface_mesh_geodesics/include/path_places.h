#ifndef SURFACE_MESH_GEODESICS_PATH_PLACES_H
#define SURFACE_MESH_GEODESICS_PATH_PLACES_H

// Points of a mesh in all the ways in which a user may give them: vertices, locations in each face around an edge or a
// vertex, and such locations with noise.

#include "path_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <array>
#include <cstddef>
#include <vector>

namespace test_meshes {

inline Mesh::Halfedge_index halfedge_between(std::size_t a, std::size_t b, const Mesh& tm)
{
  return halfedge(vertex(a), vertex(b), tm).first;
}

// Returns the point a + t (b - a) of an edge, as a location in each of its faces.
inline std::vector<Place> on_edge(std::size_t a, std::size_t b, double t, const Mesh& tm)
{
  std::vector<Place> places;
  const auto h = halfedge_between(a, b, tm);
  if(!is_border(h, tm))
  {
    places.push_back(location_on_halfedge(h, t, tm));
  }
  if(!is_border(opposite(h, tm), tm))
  {
    places.push_back(location_on_halfedge(opposite(h, tm), 1. - t, tm));
  }
  return places;
}

// Returns a vertex, its location in each of its faces, and these locations with noise.
inline std::vector<Place> at_vertex(std::size_t i, const Mesh& tm)
{
  const vertex_descriptor v = vertex(i);
  std::vector<Place> places{v};
  for(const face_descriptor f : faces_around(v, tm))
  {
    const Face_location exact = location_of_vertex(v, f, tm);
    places.push_back(exact);
    std::size_t k = 0;
    while(exact.second[k] != 1.)
    {
      ++k;
    }
    const double noises[4][3] = {
      {1., 0., 5.6e-17}, {1. - 1e-16, 0., 1.1e-16}, {1., 0., -5.6e-17}, {1., 5.6e-17, -5.6e-17}};
    for(const auto& noise : noises)
    {
      for(const std::size_t shift : {1u, 2u})
      {
        Face_location noisy = exact;
        noisy.second[k] = noise[0];
        noisy.second[(k + shift) % 3] = noise[1];
        noisy.second[(k + 3 - shift) % 3] = noise[2];
        places.push_back(noisy);
      }
    }
  }
  return places;
}

// Returns the locations, and the same with noise instead of zeros.
inline std::vector<Place> with_noise(std::vector<Place> places)
{
  const std::size_t n = places.size();
  for(std::size_t i = 0; i < n; ++i)
  {
    for(const double noise : {1.1e-16, -5.6e-17})
    {
      Face_location location = places[i].location;
      for(double& b : location.second)
      {
        if(b == 0.)
        {
          b = noise;
        }
      }
      places.push_back(location);
    }
  }
  return places;
}

inline Coordinates position(const Place& p, const Mesh& tm)
{
  return p.is_vertex() ? coordinates(p.vertex, tm) : coordinates(p.location, tm);
}

// Returns the location of a point of the plane z = 0.
inline Place in_plane(double x, double y, const Mesh& tm)
{
  for(const face_descriptor f : faces(tm))
  {
    const auto corners = corners_of_face(f, tm);
    std::array<Coordinates, 3> p;
    for(std::size_t k = 0; k < 3; ++k)
    {
      p[k] = coordinates(corners[k], tm);
    }
    const double area = cross(p[1] - p[0], p[2] - p[0])[2];
    std::array<double, 3> weights{};
    bool is_inside = area != 0.;
    for(std::size_t k = 0; k < 3 && is_inside; ++k)
    {
      const Coordinates& a = p[(k + 1) % 3];
      const Coordinates& b = p[(k + 2) % 3];
      weights[k] = cross(b - a, Coordinates{x, y, 0.} - a)[2] / area;
      is_inside = weights[k] >= -1e-14;
    }
    if(is_inside)
    {
      return Place(Face_location(f, weights));
    }
  }
  CHECK(false);
  return Place(Face_location());
}

// Returns all ways to give one random point: a vertex, a point of an edge, or a point inside a face.
inline std::vector<Place> random_spot(const Mesh& tm, test_support::Random& random)
{
  const std::size_t kind = random.index(4);
  if(kind == 0)
  {
    return at_vertex(std::size_t(random_vertex(tm, random)), tm);
  }
  if(kind == 1)
  {
    return {Place(random_location(tm, random, random.index(3) == 0 ? 1e-6 : 1e-2))};
  }
  std::vector<Mesh::Edge_index> all_edges(edges(tm).begin(), edges(tm).end());
  const auto e = all_edges[random.index(all_edges.size())];
  const auto h = halfedge(e, tm);
  const double special[8] = {.5, .25, 1. / 3., .75, .9, 1e-3, 1e-7, 1. - 1e-7};
  const double t = random.index(2) == 0 ? random.uniform(.01, .99) : special[random.index(8)];
  return with_noise(on_edge(std::size_t(source(h, tm)), std::size_t(target(h, tm)), t, tm));
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_PATH_PLACES_H
