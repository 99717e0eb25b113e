#ifndef SURFACE_MESH_GEODESICS_INTRINSIC_MESH_HELPERS_H
#define SURFACE_MESH_GEODESICS_INTRINSIC_MESH_HELPERS_H

// The intrinsic mesh of a test mesh, for tests of the propagation itself.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <type_traits>

namespace test_meshes {

inline CGAL::Surface_mesh_geodesics::internal::Intrinsic_mesh<double> intrinsic_mesh(const Mesh& tm)
{
  namespace internal = CGAL::Surface_mesh_geodesics::internal;
  const auto vim = get(boost::vertex_index, tm);
  const auto fim = get(boost::face_index, tm);
  const auto vpm = get(CGAL::vertex_point, tm);
  const internal::Intrinsic_surface<double, Mesh, std::decay_t<decltype(vim)>, std::decay_t<decltype(fim)>> surface(
    tm, vim, fim, internal::Shape_from_points<double, Mesh, std::decay_t<decltype(vpm)>>(tm, vpm));
  return surface.mesh();
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_INTRINSIC_MESH_HELPERS_H
