#ifndef SURFACE_MESH_GEODESICS_DISTANCE_TEST_HELPERS_H
#define SURFACE_MESH_GEODESICS_DISTANCE_TEST_HELPERS_H

// Functions that compute distances and return them in the order of vertices(tm), the meshes of the folder data/, and
// locations at vertices, on edges and in faces.

#include "distance_options.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

namespace SMG = CGAL::Surface_mesh_geodesics;

const double infinity = std::numeric_limits<double>::infinity();
const std::size_t no_source = (std::numeric_limits<std::size_t>::max)();

inline vertex_descriptor vertex(std::size_t i)
{
  return vertex_descriptor(static_cast<Mesh::size_type>(i));
}

inline face_descriptor face(std::size_t i)
{
  return face_descriptor(static_cast<Mesh::size_type>(i));
}

// Reads data/<name>.off. Returns false if the file is missing or does not contain a valid mesh.
inline bool read_data(const std::string& name, Mesh& tm)
{
  std::ifstream in("data/" + name + ".off");
  return static_cast<bool>(in) && CGAL::IO::read_OFF(in, tm);
}

inline Mesh load_data(const std::string& name)
{
  Mesh tm;
  CHECK(read_data(name, tm));
  return tm;
}

template <class TriangleMesh, class VertexMap>
std::vector<double> values_at_vertices(const TriangleMesh& tm, const VertexMap& map)
{
  std::vector<double> values;
  for(const auto v : vertices(tm))
  {
    values.push_back(get(map, v));
  }
  return values;
}

template <class TriangleMesh, class Sources>
std::vector<double> distances(const TriangleMesh& tm, const Sources& sources)
{
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances(tm, map, sources));
  return values_at_vertices(tm, map);
}

template <class TriangleMesh, class Sources, class NamedParameters>
std::vector<double> distances_with_parameters(const TriangleMesh& tm, const Sources& sources,
                                              const NamedParameters& np)
{
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances(tm, map, sources, np));
  return values_at_vertices(tm, map);
}

template <class TriangleMesh, class Sources, class Options>
std::vector<double> distances_with_options(const TriangleMesh& tm, const Sources& sources, const Options& options)
{
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances(tm, map, sources, parameters_of(options)));
  return values_at_vertices(tm, map);
}

template <class TriangleMesh, class EdgeLengthMap, class Sources>
std::vector<double> distances_from_edge_lengths(const TriangleMesh& tm, const EdgeLengthMap& lengths,
                                                const Sources& sources)
{
  auto map = get(CGAL::dynamic_vertex_property_t<double>(), tm);
  CHECK(SMG::geodesic_distances_from_edge_lengths(tm, lengths, map, sources));
  return values_at_vertices(tm, map);
}

// Adds a property map with the Euclidean edge lengths.
inline Mesh::Property_map<Mesh::Edge_index, double> add_edge_lengths(Mesh& tm)
{
  auto lengths = tm.add_property_map<Mesh::Edge_index, double>("e:test_length", 0.).first;
  for(const auto e : edges(tm))
  {
    const auto h = halfedge(e, tm);
    const auto d = tm.point(source(h, tm)) - tm.point(target(h, tm));
    lengths[e] = std::sqrt(d.squared_length());
  }
  return lengths;
}

// Returns the corners of a face, in the order of the barycentric coordinates of a location.
template <class TriangleMesh>
std::array<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, 3>
corners_of_face(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh& tm)
{
  const auto h = halfedge(f, tm);
  return {source(h, tm), target(h, tm), target(next(h, tm), tm)};
}

// Returns the point source(h) + t (target(h) - source(h)), as a location in the face of h.
inline Face_location location_on_halfedge(Mesh::Halfedge_index h, double t, const Mesh& tm)
{
  const face_descriptor f = face(h, tm);
  const auto corners = corners_of_face(f, tm);
  Face_location location(f, {0., 0., 0.});
  for(std::size_t k = 0; k < 3; ++k)
  {
    if(corners[k] == source(h, tm))
    {
      location.second[k] = 1. - t;
    }
    else if(corners[k] == target(h, tm))
    {
      location.second[k] = t;
    }
  }
  return location;
}

// Returns the point a + t (b - a) of an edge, as a location in each of its faces.
inline std::vector<Face_location> on_edge(std::size_t a, std::size_t b, double t, const Mesh& tm)
{
  std::vector<Face_location> locations;
  const Mesh::Halfedge_index h = halfedge(vertex(a), vertex(b), tm).first;
  if(!is_border(h, tm))
  {
    locations.push_back(location_on_halfedge(h, t, tm));
  }
  if(!is_border(opposite(h, tm), tm))
  {
    locations.push_back(location_on_halfedge(opposite(h, tm), 1. - t, tm));
  }
  return locations;
}

inline Face_location location_of_vertex(vertex_descriptor v, face_descriptor f, const Mesh& tm)
{
  const auto corners = corners_of_face(f, tm);
  Face_location location(f, {0., 0., 0.});
  for(std::size_t k = 0; k < 3; ++k)
  {
    if(corners[k] == v)
    {
      location.second[k] = 1.;
    }
  }
  return location;
}

// Returns the location of a vertex in one of its faces, with noise in its barycentric coordinates.
inline std::vector<Face_location> noisy_locations_of_vertex(vertex_descriptor v, face_descriptor f, const Mesh& tm)
{
  const auto corners = corners_of_face(f, tm);
  const double noises[4][3] = {
    {1., 0., 5.6e-17}, {1. - 1e-16, 0., 1.1e-16}, {1., 0., -5.6e-17}, {1., 5.6e-17, -5.6e-17}};
  std::vector<Face_location> locations;
  for(std::size_t k = 0; k < 3; ++k)
  {
    for(std::size_t i = 0; i < 8 && corners[k] == v; ++i)
    {
      const auto& noise = noises[i / 2];
      const std::size_t shift = 1 + i % 2;
      Face_location location(f, {0., 0., 0.});
      location.second[k] = noise[0];
      location.second[(k + shift) % 3] = noise[1];
      location.second[(k + 3 - shift) % 3] = noise[2];
      locations.push_back(location);
    }
  }
  return locations;
}

// Returns the faces around a vertex.
inline std::vector<face_descriptor> faces_around(vertex_descriptor v, const Mesh& tm)
{
  std::vector<face_descriptor> result;
  if(tm.is_isolated(v))
  {
    return result;
  }
  for(const auto f : CGAL::faces_around_target(halfedge(v, tm), tm))
  {
    if(f != boost::graph_traits<Mesh>::null_face())
    {
      result.push_back(f);
    }
  }
  return result;
}

inline Coordinates coordinates(vertex_descriptor v, const Mesh& tm)
{
  const auto& p = tm.point(v);
  return {p.x(), p.y(), p.z()};
}

inline Coordinates coordinates(const Face_location& location, const Mesh& tm)
{
  const auto corners = corners_of_face(location.first, tm);
  Coordinates p{0., 0., 0.};
  for(std::size_t k = 0; k < 3; ++k)
  {
    p = p + location.second[k] * coordinates(corners[k], tm);
  }
  return p;
}

// Returns the location of a point of the plane z = 0, in the first face that contains it up to rounding.
inline Face_location location_in_plane(double x, double y, const Mesh& tm)
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
      return {f, weights};
    }
  }
  CHECK(false);
  return {};
}

inline Face_location random_location(const Mesh& tm, test_support::Random& random, double least_weight = 1e-3)
{
  std::vector<face_descriptor> all_faces(faces(tm).begin(), faces(tm).end());
  const face_descriptor f = all_faces[random.index(all_faces.size())];
  double a = random.uniform(least_weight, 1.);
  double b = random.uniform(least_weight, 1.);
  double c = random.uniform(least_weight, 1.);
  const double sum = a + b + c;
  a /= sum;
  b /= sum;
  c = 1. - a - b;
  return {f, {a, b, c}};
}

inline vertex_descriptor random_vertex(const Mesh& tm, test_support::Random& random)
{
  std::vector<vertex_descriptor> all_vertices(vertices(tm).begin(), vertices(tm).end());
  for(;;)
  {
    const vertex_descriptor v = all_vertices[random.index(all_vertices.size())];
    if(!tm.is_isolated(v))
    {
      return v;
    }
  }
}

// Meshes of many kinds: closed and with borders, rough and smooth, with handles, holes and thin parts.
inline std::vector<Indexed_mesh> meshes_of_many_kinds(std::uint64_t seed)
{
  return {icosphere(2),
          rough_terrain(10, 2., seed),
          wavy_tube(20, 24),
          tetrahedral_ogre(60, seed + 1),
          square_with_holes(2),
          spiral_corridor(),
          midpoint_subdivision(genus_2_polycube()),
          random_cuts(noisy_sphere(2, .1, seed + 2), .15, seed + 3),
          two_components_and_an_isolated_vertex(),
          irregular_tetrahedron()};
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_DISTANCE_TEST_HELPERS_H
