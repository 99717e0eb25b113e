// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_CONSECUTIVE_ELEMENTS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_CONSECUTIVE_ELEMENTS_H

// Which meshes and maps several threads may read at the same time. The concepts promise nothing about that: a model of
// FaceListGraph may count its elements when it is asked, and a map of the user may compute what it returns. So one
// thread reads them. A CGAL::Surface_mesh and its own maps are arrays, and reading an array changes nothing.

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Is the element with index i also the one at position i of its range, for the maps of these types? Then no index needs
// a check, and several threads may read the connectivity. If is_possible, has_no_gaps(tm) tells whether this holds for
// a mesh, and face(i) and vertex(i) are its elements.
//
// The types have to be exactly these: a class that is derived from Surface_mesh, or an adaptor such as
// Face_filtered_graph, may have another connectivity, and another index map may give other numbers.
template <typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
struct Consecutive_elements
{
  static constexpr bool is_possible = false;
};

template <typename Point>
struct Consecutive_elements<Surface_mesh<Point>,
                            typename boost::property_map<Surface_mesh<Point>, boost::vertex_index_t>::const_type,
                            typename boost::property_map<Surface_mesh<Point>, boost::face_index_t>::const_type>
{
  using Graph_traits = boost::graph_traits<Surface_mesh<Point>>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

  static constexpr bool is_possible = true;

  // Elements that have been removed are gaps until the user collects the garbage.
  static bool has_no_gaps(const Surface_mesh<Point>& tm) { return !tm.has_garbage(); }

  static vertex_descriptor vertex(std::size_t i)
  {
    return vertex_descriptor(static_cast<typename vertex_descriptor::size_type>(i));
  }
  static face_descriptor face(std::size_t i)
  {
    return face_descriptor(static_cast<typename face_descriptor::size_type>(i));
  }
};

// May several threads read the points of a map? The coordinates have to be built-in floating point numbers, as others
// may change when they are converted: those of lazy kernels do. (All maps of points that a Surface_mesh stores are of
// this type. As in the standard library, a constant object is taken to be one that threads may read.)
template <typename TriangleMesh, typename VertexPointMap>
struct Has_shared_points : std::false_type
{};

template <typename Point>
struct Has_shared_points<Surface_mesh<Point>,
                         typename boost::property_map<Surface_mesh<Point>, CGAL::vertex_point_t>::const_type>
  : std::is_floating_point<typename std::decay<decltype(std::declval<const Point&>().x())>::type>
{};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_CONSECUTIVE_ELEMENTS_H
