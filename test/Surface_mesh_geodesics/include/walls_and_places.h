#ifndef SURFACE_MESH_GEODESICS_TEST_WALLS_AND_PLACES_H
#define SURFACE_MESH_GEODESICS_TEST_WALLS_AND_PLACES_H

// Walls of all shapes, places on both sides of them and on them, and the distances that a mesh has which has really
// been cut along them.

#include "cut_mesh.h"
#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

using Faces = std::set<face_descriptor>;

constexpr double not_reached = std::numeric_limits<double>::infinity();

// --- shapes of walls ---

inline Walls random_walls(const Mesh& tm, double part, test_support::Random& random)
{
  Walls walls;
  for(const edge_descriptor e : edges(tm))
    if(random.uniform() < part)
      walls.insert(e);
  return walls;
}

inline Walls tree(const Mesh& tm, test_support::Random& random)
{
  Walls walls;
  std::set<vertex_descriptor> reached{*vertices(tm).begin()};
  std::vector<edge_descriptor> all(edges(tm).begin(), edges(tm).end());
  for(std::size_t i = 0; i < 8 * all.size(); ++i)
  {
    const edge_descriptor e = all[random.index(all.size())];
    if(reached.count(source(e, tm)) + reached.count(target(e, tm)) != 1)
      continue;
    reached.insert({source(e, tm), target(e, tm)});
    walls.insert(e);
  }
  return walls;
}

// The edges between the faces on both sides of a plane: closed, or from border to border.
inline Walls separating(const Mesh& tm)
{
  const auto is_left = [&](face_descriptor f)
  {
    double x = 0;
    for(const vertex_descriptor v : vertices_around_face(halfedge(f, tm), tm))
      x += tm.point(v).x() + .1 * tm.point(v).y();
    return x < 3 * tm.point(vertex_descriptor(0)).x() + .01;
  };
  Walls walls;
  for(const edge_descriptor e : edges(tm))
  {
    const auto h = halfedge(e, tm), o = opposite(h, tm);
    if(!is_border(h, tm) && !is_border(o, tm) && is_left(face(h, tm)) != is_left(face(o, tm)))
      walls.insert(e);
  }
  return walls;
}

inline std::vector<Walls> all_walls(const Mesh& tm, test_support::Random& random)
{
  std::vector<Walls> result{random_walls(tm, .05, random), random_walls(tm, .2, random), random_walls(tm, .4, random),
                            tree(tm, random), separating(tm)};
  Walls all(edges(tm).begin(), edges(tm).end()), star, around_face;
  result.push_back(all);
  const face_descriptor f = *std::next(faces(tm).begin(), static_cast<std::ptrdiff_t>(num_faces(tm) / 2));
  for(const halfedge_descriptor h : halfedges_around_target(halfedge(f, tm), tm))
    star.insert(edge(h, tm));
  for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, tm), tm))
    around_face.insert(edge(h, tm));
  result.push_back(star);
  result.push_back(around_face);
  star.erase(star.begin());
  result.push_back(star);
  return result;
}

// --- the cut mesh ---

// A vertex, or a location that may be on the edge of a wall.
struct Place
{
  vertex_descriptor vertex;
  Face_location location;
  bool is_vertex;
};

// The sources of a place in the cut mesh: one for each side.
inline std::vector<Face_location> sides(const Mesh& tm, const Cut_mesh& cut, const Faces& removed, const Place& p)
{
  std::vector<Face_location> result;
  if(p.is_vertex)
  {
    for(const halfedge_descriptor h : halfedges_around_source(p.vertex, tm))
      if(!is_border(h, tm) && removed.count(face(h, tm)) == 0)
      {
        std::array<double, 3> b{};
        std::size_t k = 0;
        for(auto g = halfedge(face(h, tm), tm); g != h; g = next(g, tm))
          ++k;
        b[k] = 1;
        result.push_back(cut.location(face(h, tm), b));
      }
    return result;
  }
  result.push_back(cut.location(p.location.first, p.location.second));
  auto h = halfedge(p.location.first, tm);
  for(std::size_t k = 0; k < 3; ++k, h = next(h, tm))
    if(p.location.second[(k + 2) % 3] == 0 && !is_border(opposite(h, tm), tm)
       && removed.count(face(opposite(h, tm), tm)) == 0)
    {
      const auto o = opposite(h, tm);
      std::array<double, 3> b{};
      std::size_t i = 0;
      for(auto g = halfedge(face(o, tm), tm); g != o; g = next(g, tm))
        ++i;
      b[i] = p.location.second[(k + 1) % 3];
      b[(i + 1) % 3] = p.location.second[k];
      result.push_back(cut.location(face(o, tm), b));
    }
  return result;
}

inline Place random_place(const Mesh& tm, const Faces& removed, test_support::Random& random)
{
  face_descriptor f;
  do
    f = *std::next(faces(tm).begin(), static_cast<std::ptrdiff_t>(random.index(num_faces(tm))));
  while(removed.count(f) != 0);
  const std::size_t kind = random.index(3), k = random.index(3);
  Place p{target(halfedge(f, tm), tm), {f, {.2, .3, .5}}, kind == 0};
  if(kind == 1)
  {
    p.location.second = {0, 0, 0};
    p.location.second[k] = .375;
    p.location.second[(k + 1) % 3] = .625;
  }
  return p;
}

// --- distances in the cut mesh ---

inline double least(const std::map<vertex_descriptor, double>& distance, const std::vector<vertex_descriptor>& copies)
{
  double result = not_reached;
  for(const vertex_descriptor c : copies)
    result = (std::min)(result, distance.at(c));
  return result;
}

// The distances of the vertices of the mesh from several places, and the nearest of these, in the cut mesh.
inline std::map<vertex_descriptor, double> expected_distances(const Mesh& tm, const Cut_mesh& cut, const Faces& removed,
                                                       const std::vector<Place>& places)
{
  std::vector<Face_location> sources;
  for(const Place& p : places)
    for(const Face_location& s : sides(tm, cut, removed, p))
      sources.push_back(s);
  std::map<vertex_descriptor, double> in_cut, result;
  CGAL::Surface_mesh_geodesics::geodesic_distances(cut.mesh, boost::make_assoc_property_map(in_cut), sources);
  for(const vertex_descriptor v : vertices(tm))
    result[v] = least(in_cut, cut.copies[v]);
  return result;
}

// The objects of one test: a mesh, obstacles, and what they leave.
struct Case
{
  const Mesh& tm;
  const Walls& walls;
  const Faces& removed;
  Cut_mesh cut{tm, walls, removed};
  std::vector<face_descriptor> avoided{removed.begin(), removed.end()};
  std::vector<edge_descriptor> range{walls.begin(), walls.end()};

  std::map<vertex_descriptor, double> expected(const std::vector<Place>& places) const
  {
    return expected_distances(tm, cut, removed, places);
  }
};

// The faces around a vertex, to be avoided as well. None of a small mesh, of which too little would be left.
inline Faces star_to_avoid(const Mesh& tm)
{
  Faces star;
  if(num_faces(tm) > 40)
    for(const face_descriptor f : faces_around_target(halfedge(*std::next(vertices(tm).begin(), 3), tm), tm))
      if(f != Mesh::null_face())
        star.insert(f);
  return star;
}

// Calls check(c, i) for a few meshes, each with all walls, where i counts the walls of a mesh. Every second time faces
// are avoided as well.
template <typename Check>
void for_each_case(test_support::Random& random, const Check& check)
{
  for(const Indexed_mesh& indexed : {noisy_sphere(1, .2, 3), torus(2, .7, 8, 6), flat_patch(5, 5, .15, true, 2),
                                     two_components_and_an_isolated_vertex()})
  {
    const Mesh tm = to_face_graph(indexed);
    const Faces star = star_to_avoid(tm);
    std::size_t i = 0;
    for(const Walls& walls : all_walls(tm, random))
    {
      const test_support::Scope scope(indexed.name + ", walls " + std::to_string(i));
      check(Case{tm, walls, i % 2 == 1 ? star : Faces()}, i);
      ++i;
    }
  }
}

// Calls use() with the vertex of a place, or with its location.
template <typename Use>
auto with_place(const Place& p, const Use& use)
{
  return p.is_vertex ? use(p.vertex) : use(p.location);
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_TEST_WALLS_AND_PLACES_H
