// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_INPUT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_INPUT_H

// The input of a store as its manifest tells it: the checksum of the mesh, and sources and targets as numbers; and back
// to descriptors, for checks.
//
// Indices are those of the user's index maps. For most meshes they are the positions in the file, so other programs can
// read the lists, too.

#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Checksum.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Json_value.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/walls/Wall_cut.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The checksum of connectivity and coordinates. The order of vertices, of faces and of the corners of a face counts,
// and so do the indices: sources are named by them, and the last digits of distances may depend on the order. Takes
// linear time. Coordinates count with all their bits, as numbers of type double: a mesh that was written with fewer
// digits is another one. Requires: coordinates are finite and faces are triangles, which reading the mesh has checked.
template <typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap, typename VertexPointMap>
std::string hash_of_mesh(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim, VertexPointMap vpm)
{
  Checksum sum;
  sum.add(static_cast<std::uint64_t>(num_vertices(tm)));
  for(const auto v : vertices(tm))
  {
    const auto& p = get(vpm, v);
    sum.add(static_cast<std::uint64_t>(get(vim, v)));
    sum.add(CGAL::to_double(p.x()));
    sum.add(CGAL::to_double(p.y()));
    sum.add(CGAL::to_double(p.z()));
  }
  sum.add(static_cast<std::uint64_t>(num_faces(tm)));
  // The corners begin at the halfedge of the face, whose corner is the first one of locations.
  for(const auto f : faces(tm))
  {
    sum.add(static_cast<std::uint64_t>(get(fim, f)));
    for(const auto v : CGAL::vertices_around_face(halfedge(f, tm), tm))
      sum.add(static_cast<std::uint64_t>(get(vim, v)));
  }
  return sum.text();
}

// Are the sources the vertices with the indices 0, 1, ..., n - 1? It is the usual case, for which a manifest has one
// word instead of a list that is as long as the matrix is high. Takes linear time and no memory.
template <typename TriangleMesh, typename Sources, typename VertexIndexMap>
bool are_all_vertices(const TriangleMesh& tm, const Sources& sources, VertexIndexMap vim)
{
  std::size_t number = 0;
  bool is_in_order = true;
  for_each_source<TriangleMesh>(sources, [&](const auto& source)
  {
    if constexpr(Is_vertex<TriangleMesh, std::decay_t<decltype(source)>>::value)
    {
      const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v = source;
      is_in_order = is_in_order && static_cast<std::size_t>(get(vim, v)) == number;
    }
    else
      is_in_order = false;
    ++number;
  });
  return is_in_order && number == num_vertices(tm);
}

// What is written tells the order, too: rows and columns of the matrix are in the order of the user's ranges.
//
// Returns "all", or a list with the index of each vertex, and with the index of the face and the three coordinates of
// each location in a face. Requires: the sources are valid.
template <typename TriangleMesh, typename Sources, typename VertexIndexMap, typename FaceIndexMap>
Json_value sources_to_json(const TriangleMesh& tm, const Sources& sources, VertexIndexMap vim, FaceIndexMap fim)
{
  if(are_all_vertices(tm, sources, vim))
    return Json_value("all");
  std::vector<Json_value> values;
  for_each_source<TriangleMesh>(sources, [&](const auto& source)
  {
    if constexpr(Is_vertex<TriangleMesh, std::decay_t<decltype(source)>>::value)
    {
      const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v = source;
      // indices are less than 2^32, which a number of JSON keeps
      values.push_back(static_cast<std::size_t>(get(vim, v)));
    }
    else
    {
      std::vector<Json_value> location{static_cast<std::size_t>(get(fim, source.first))};
      const auto& b = source.second;
      for(const double x : coordinates_in_double(b[0], b[1], b[2]))
        location.push_back(x + 0.); // a zero has no sign
      values.push_back(Json_value(std::move(location)));
    }
  });
  return Json_value(std::move(values));
}

// Edges have no index among the maps of the user, so a wall is named by the index of a face and the number of its edge
// there. Both faces know it; the smaller pair is its name. An edge at the border cuts nothing and is left out.
//
// Returns the walls in ascending order, each once. Takes linear time, and none without walls.
template <typename TriangleMesh, typename FaceIndexMap>
std::vector<std::array<std::size_t, 2>> names_of_walls(const TriangleMesh& tm, FaceIndexMap fim,
                                                       const std::vector<Wall_bits>& walls)
{
  std::vector<std::array<std::size_t, 2>> names;
  if(walls.empty())
    return names;
  for(const auto f : faces(tm))
  {
    auto h = halfedge(f, tm);
    for(unsigned int k = 0; k < 3; ++k, h = next(h, tm))
    {
      const std::array<std::size_t, 2> name{static_cast<std::size_t>(get(fim, f)), k};
      const auto o = opposite(h, tm);
      if(!is_wall(walls[name[0]], k) || is_border(o, tm))
        continue;
      const std::array<std::size_t, 2> other{static_cast<std::size_t>(get(fim, face(o, tm))), number_in_face(o, tm)};
      if(name < other)
        names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Returns the walls that have the names, for the reader of the mesh. The table has the face of each index. Throws if
// the manifest names an edge that the mesh does not have.
template <typename TriangleMesh, typename FaceIndexMap, typename Faces>
std::vector<Wall_bits> named_walls(const TriangleMesh& tm, FaceIndexMap fim, const Faces& face_of_index,
                                   const std::vector<std::array<std::size_t, 2>>& names)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor> edges;
  for(const std::array<std::size_t, 2>& name : names)
  {
    if(name[0] >= face_of_index.size() || name[1] >= 3)
      Json_value::complain("an edge to avoid is not in the mesh");
    auto h = halfedge(face_of_index[name[0]], tm);
    for(std::size_t k = 0; k < name[1]; ++k)
      h = next(h, tm);
    edges.push_back(edge(h, tm));
  }
  return walls_of_edges(tm, fim, edges);
}

// Sources of a manifest as descriptors of a mesh: either all are vertices, or all are locations.
// Only one of the two lists has elements, since the type of a range decides about all of its sources.
template <typename TriangleMesh>
struct Stored_sources
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Location = std::pair<typename Graph_traits::face_descriptor, std::array<double, 3>>;

  std::vector<typename Graph_traits::vertex_descriptor> vertices;
  std::vector<Location> locations;

  // Adds source i of a list or of "all". The tables have the descriptor of each index. Throws if the manifest names an
  // element that the mesh does not have. Requires: i is less than the number of sources.
  void add(const Json_value& sources, std::size_t i,
           const std::vector<typename Graph_traits::vertex_descriptor>& vertex_of_index,
           const std::vector<typename Graph_traits::face_descriptor>& face_of_index)
  {
    if(sources.is_text("all"))
    {
      vertices.push_back(vertex_of_index[i]);
      return;
    }
    // A number is a vertex, and four numbers are a location.
    const Json_value& source = sources.elements()[i];
    if(source.type() == Json_value::Type::NUMBER)
    {
      if(source.count() >= vertex_of_index.size())
        Json_value::complain("a vertex is not in the mesh");
      vertices.push_back(vertex_of_index[source.count()]);
      return;
    }
    const std::vector<Json_value>& numbers = source.elements();
    if(numbers.size() != 4 || numbers[0].count() >= face_of_index.size())
      Json_value::complain("a location is not in the mesh");
    locations.push_back(Location{face_of_index[numbers[0].count()],
                                 {numbers[1].number(), numbers[2].number(), numbers[3].number()}});
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_INPUT_H
