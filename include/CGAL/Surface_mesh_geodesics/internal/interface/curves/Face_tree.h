// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_FACE_TREE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_FACE_TREE_H

// CGAL's tree of the faces of a mesh. (Classes of the package take the traits of a tree from the user; functions choose
// them.)

#include <CGAL/Surface_mesh_geodesics/internal/numeric/cgal_compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include CGAL_SURFACE_MESH_GEODESICS_TREE_TRAITS_HEADER
#include <CGAL/AABB_tree.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename Kernel, typename TriangleMesh, typename VertexPointMap>
using Face_tree = AABB_tree<CGAL_SURFACE_MESH_GEODESICS_TREE_TRAITS<
  Kernel, AABB_face_graph_triangle_primitive<TriangleMesh, VertexPointMap>>>;

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_FACE_TREE_H
