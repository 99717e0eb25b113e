#ifndef SURFACE_MESH_GEODESICS_PATH_INTERFACE_HELPERS_H
#define SURFACE_MESH_GEODESICS_PATH_INTERFACE_HELPERS_H

// Shared by the tests of the interface of Surface_mesh_geodesic_paths: trees of faces, and checks of exceptions.

#include "path_test_helpers.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>

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
using Invalid_input = CGAL::Surface_mesh_geodesics::Invalid_geodesic_input;
using Reason = Invalid_input::Reason;

// Returns whether a call throws an exception of this type.
template <class Exception, class Function>
bool throws(Function function)
{
  try
  {
    function();
  }
  catch(const Exception&)
  {
    return true;
  }
  return false;
}

// Returns whether a call throws Invalid_geodesic_input with this reason.
template <class Function>
bool throws_reason(Reason reason, Function function)
{
  try
  {
    function();
  }
  catch(const Invalid_input& e)
  {
    return e.reason() == reason;
  }
  return false;
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_PATH_INTERFACE_HELPERS_H
