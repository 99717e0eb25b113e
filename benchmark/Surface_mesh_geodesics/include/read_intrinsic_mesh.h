// The surface that a propagation sees, for benchmark programs that call a propagation themselves.

#ifndef READ_INTRINSIC_MESH_H
#define READ_INTRINSIC_MESH_H

#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>

#include <type_traits>
#include <utility>

// The intrinsic mesh of a mesh in space, and its vertex 0.
inline std::pair<CGAL::Surface_mesh_geodesics::internal::Intrinsic_mesh<double>,
                 CGAL::Surface_mesh_geodesics::internal::Vertex_id>
read_intrinsic_mesh(const Benchmark_mesh& mesh)
{
  namespace geodesics = CGAL::Surface_mesh_geodesics::internal;
  const auto vim = get(boost::vertex_index, mesh);
  const auto fim = get(boost::face_index, mesh);
  const auto vpm = get(CGAL::vertex_point, mesh);
  using Shape = geodesics::Shape_from_points<double, Benchmark_mesh, std::decay_t<decltype(vpm)>>;
  const geodesics::Intrinsic_surface<double, Benchmark_mesh, std::decay_t<decltype(vim)>, std::decay_t<decltype(fim)>>
    surface(mesh, vim, fim, Shape(mesh, vpm));
  return {surface.mesh(), surface.id(*mesh.vertices().begin())};
}

#endif // READ_INTRINSIC_MESH_H
