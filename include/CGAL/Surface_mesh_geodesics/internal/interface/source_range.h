// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SOURCE_RANGE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SOURCE_RANGE_H

// The sources as the user gives them: one vertex or face location, or a range of either; and as the
// propagation needs them: vertices of the intrinsic mesh.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Source_set.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/intrinsic_mesh_from_face_graph.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename TriangleMesh, typename Source>
struct Is_vertex
  : std::is_convertible<Source, typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
{};

// A pair of a face descriptor and three numbers.
template <typename TriangleMesh, typename Source, typename = void>
struct Is_face_location
  : std::false_type
{};

template <typename TriangleMesh, typename Source>
struct Is_face_location<TriangleMesh, Source,
                        std::void_t<decltype(std::declval<const Source&>().first),
                                    decltype(std::declval<const Source&>().second[0])>>
  : std::is_convertible<decltype(std::declval<const Source&>().first),
                        typename boost::graph_traits<TriangleMesh>::face_descriptor>
{};

template <typename TriangleMesh, typename Source>
struct Is_source
  : std::integral_constant<bool, Is_vertex<TriangleMesh, Source>::value
                                   || Is_face_location<TriangleMesh, Source>::value>
{};

// calls visit(position, source) for a source or for each source of a range.
template <typename TriangleMesh, typename Sources, typename Visitor>
void for_each_source(const Sources& sources, Visitor visit)
{
  if constexpr(Is_source<TriangleMesh, Sources>::value)
    visit(std::size_t(0), sources);
  else
  {
    std::size_t position = 0;
    for(const auto& source : sources)
    {
      static_assert(Is_source<TriangleMesh, std::decay_t<decltype(source)>>::value,
                    "a source is a vertex descriptor or a pair of a face descriptor and three "
                    "barycentric coordinates");
      visit(position, source);
      ++position;
    }
  }
}

// Removed elements keep their index: only the mesh can tell, and not every mesh can.
template <typename TriangleMesh>
struct Removed_elements
{
  template <typename Descriptor>
  static bool contain(const Descriptor&, const TriangleMesh&)
  {
    return false;
  }
};

template <typename Point>
struct Removed_elements<CGAL::Surface_mesh<Point>>
{
  template <typename Descriptor>
  static bool contain(const Descriptor& d, const CGAL::Surface_mesh<Point>& tm)
  {
    return !tm.has_valid_index(d) || tm.is_removed(d);
  }
};

// is v, as far as can be told without going around in the mesh, a vertex of it?
template <typename TriangleMesh, typename VertexIndexMap>
bool is_vertex_of(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v, const TriangleMesh& tm,
                  const VertexIndexMap& vim)
{
  return v != boost::graph_traits<TriangleMesh>::null_vertex()
      && static_cast<std::size_t>(get(vim, v)) < num_vertices(tm)
      && !Removed_elements<TriangleMesh>::contain(v, tm);
}

// What is thrown for descriptors; `what` and `position` name the culprit.
[[noreturn]] inline void refuse_descriptor(Invalid_geodesic_input::Reason reason, const char* what,
                                           std::size_t position, const char* fault)
{
  throw Invalid_geodesic_input(reason, std::string(what) + " " + std::to_string(position) + fault, position);
}

[[noreturn]] inline void refuse_vertex(const char* what, std::size_t position)
{
  refuse_descriptor(Invalid_geodesic_input::Reason::INVALID_DESCRIPTOR, what, position,
                    " is not a vertex of the mesh");
}

[[noreturn]] inline void refuse_face(const char* what, std::size_t position)
{
  refuse_descriptor(Invalid_geodesic_input::Reason::INVALID_DESCRIPTOR, what, position,
                    " is not in a face of the mesh");
}

[[noreturn]] inline void refuse_null_face(const char* what, std::size_t position)
{
  refuse_descriptor(Invalid_geodesic_input::Reason::INVALID_LOCATION, what, position, " has a null face");
}

// Finds the elements of an intrinsic mesh that the user's descriptors mean.
template <typename FT, typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Element_finder
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

public:
  Element_finder(const Face_graph_correspondence<TriangleMesh>& table, VertexIndexMap vim,
                 FaceIndexMap fim)
    : m_table(table), m_vim(vim), m_fim(fim)
  {}

  // `what` and `position` name the culprit in the exception.
  Vertex_id vertex(vertex_descriptor v, const char* what, std::size_t position) const
  {
    if(v != Graph_traits::null_vertex())
    {
      const std::size_t index = static_cast<std::size_t>(get(m_vim, v));
      if(index < m_table.vertex_of_index.size())
      {
        const Vertex_id id = m_table.vertex_of_index[index];
        if(id != null_id && m_table.vertices[id] == v)
          return id;
      }
    }
    refuse_vertex(what, position);
  }

  // the halfedge of the intrinsic mesh that is halfedge(f, tm).
  Halfedge_id halfedge(face_descriptor f, const char* what, std::size_t position) const
  {
    if(f == Graph_traits::null_face())
      refuse_null_face(what, position);
    const std::size_t index = static_cast<std::size_t>(get(m_fim, f));
    if(index < m_table.halfedge_of_face_index.size())
    {
      const Halfedge_id h = m_table.halfedge_of_face_index[index];
      if(h != null_id && m_table.faces[face_of(h)] == f)
        return h;
    }
    refuse_face(what, position);
  }

private:
  const Face_graph_correspondence<TriangleMesh>& m_table;
  VertexIndexMap m_vim;
  FaceIndexMap m_fim;
};

// The barycentric coordinates of a location, in the order of the corners of the intrinsic face, where
// h is halfedge(f, tm).
template <typename FT, typename Coordinates>
std::array<FT, 3> intrinsic_coordinates(Halfedge_id h, const Coordinates& b, const char* what,
                                        std::size_t position)
{
  std::array<FT, 3> r;
  for(unsigned int j = 0; j < 3; ++j)
    r[(index_in_face(h) + j) % 3] = FT(CGAL::to_double(b[j]));
  if(!Source_insertion<FT>::is_valid(r))
    refuse_descriptor(Invalid_geodesic_input::Reason::INVALID_LOCATION, what, position, " is not in its face");
  return r;
}

template <typename FT, typename Finder, typename Location>
Located_source<FT> locate_source(const Finder& finder, const Location& location, std::size_t position)
{
  const Halfedge_id h = finder.halfedge(location.first, "source", position);
  return Located_source<FT>{
    face_of(h), intrinsic_coordinates<FT>(h, location.second, "source", position), position};
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SOURCE_RANGE_H
