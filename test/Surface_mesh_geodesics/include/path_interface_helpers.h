#ifndef SURFACE_MESH_GEODESICS_PATH_INTERFACE_HELPERS_H
#define SURFACE_MESH_GEODESICS_PATH_INTERFACE_HELPERS_H

// The tree of faces for the tests of the interface of Surface_mesh_geodesic_paths.

#include "expected_exceptions.h"
#include "path_test_helpers.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

namespace test_meshes {

using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
using AABB_traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
using AABB_traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif
using Tree = CGAL::AABB_tree<AABB_traits>;

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_PATH_INTERFACE_HELPERS_H
