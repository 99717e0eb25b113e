// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_CGAL_COMPATIBILITY_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_CGAL_COMPATIBILITY_H

// The differences between the versions 5.5 and 6 of CGAL that the package meets. No other file asks for the version.

#include <CGAL/config.h>

#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <variant>
#else
#  include <boost/variant/get.hpp>
#endif

// The traits of a tree of faces, and their header.
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#define CGAL_SURFACE_MESH_GEODESICS_TREE_TRAITS AABB_traits_3
#define CGAL_SURFACE_MESH_GEODESICS_TREE_TRAITS_HEADER <CGAL/AABB_traits_3.h>
#else
#define CGAL_SURFACE_MESH_GEODESICS_TREE_TRAITS AABB_traits
#define CGAL_SURFACE_MESH_GEODESICS_TREE_TRAITS_HEADER <CGAL/AABB_traits.h>
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A pointer to the value of a variant if its type is T, else null.
template <typename T, typename Variant>
const T* held_value(const Variant& v)
{
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  return std::get_if<T>(&v);
#else
  return boost::get<T>(&v);
#endif
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_CGAL_COMPATIBILITY_H
