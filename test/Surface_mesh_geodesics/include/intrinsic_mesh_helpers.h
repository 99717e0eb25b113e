#ifndef SURFACE_MESH_GEODESICS_INTRINSIC_MESH_HELPERS_H
#define SURFACE_MESH_GEODESICS_INTRINSIC_MESH_HELPERS_H

// The intrinsic mesh of a test mesh, for tests of the propagation itself.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/One_block.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace test_meshes {

template <typename Blocks = CGAL::Surface_mesh_geodesics::internal::One_block>
CGAL::Surface_mesh_geodesics::internal::Intrinsic_mesh<double> intrinsic_mesh(const Mesh& tm, Blocks blocks = Blocks())
{
  namespace internal = CGAL::Surface_mesh_geodesics::internal;
  const auto vim = get(boost::vertex_index, tm);
  const auto fim = get(boost::face_index, tm);
  const auto vpm = get(CGAL::vertex_point, tm);
  const internal::Intrinsic_surface<double, Mesh, std::decay_t<decltype(vim)>, std::decay_t<decltype(fim)>> surface(
    tm, vim, fim, internal::Shape_from_points<double, Mesh, std::decay_t<decltype(vpm)>>(tm, vpm), blocks);
  return surface.mesh();
}

// A copy of a mesh that counts the halfedges around vertices that are visited.
struct Counting_intrinsic_mesh : CGAL::Surface_mesh_geodesics::internal::Intrinsic_mesh<double>
{
  using Base = CGAL::Surface_mesh_geodesics::internal::Intrinsic_mesh<double>;
  explicit Counting_intrinsic_mesh(const Base& mesh) : Base(mesh) {}

  template <typename Visit>
  void for_each_halfedge_around(CGAL::Surface_mesh_geodesics::internal::Vertex_id v, Visit visit) const
  {
    Base::for_each_halfedge_around(v, [&](CGAL::Surface_mesh_geodesics::internal::Halfedge_id h)
    {
      ++visits;
      visit(h);
    });
  }

  mutable std::size_t visits = 0;
};

// Are two faces equal, bit by bit?
inline bool is_same_face(const CGAL::Surface_mesh_geodesics::internal::Intrinsic_face<double>& a,
                         const CGAL::Surface_mesh_geodesics::internal::Intrinsic_face<double>& b)
{
  return a.length == b.length && a.apex_x == b.apex_x && a.apex_y == b.apex_y && a.vertex == b.vertex
      && a.opposite == b.opposite;
}

// Are two meshes equal, bit by bit?
inline bool is_same_mesh(const CGAL::Surface_mesh_geodesics::internal::Intrinsic_mesh<double>& a,
                         const CGAL::Surface_mesh_geodesics::internal::Intrinsic_mesh<double>& b)
{
  namespace internal = CGAL::Surface_mesh_geodesics::internal;
  if(a.number_of_faces() != b.number_of_faces() || a.number_of_vertices() != b.number_of_vertices())
  {
    return false;
  }
  bool result = true;
  for(internal::Face_id f = 0; f < a.number_of_faces(); ++f)
  {
    result = result && is_same_face(a.face(f), b.face(f));
  }
  for(internal::Vertex_id v = 0; v < a.number_of_vertices(); ++v)
  {
    result = result && a.halfedge(v) == b.halfedge(v) && a.kind(v) == b.kind(v) && a.has_star(v) == b.has_star(v);
    result = result && (!a.has_star(v) || std::equal(a.star_begin(v), a.star_end(v), b.star_begin(v), b.star_end(v)));
  }
  return result;
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_INTRINSIC_MESH_HELPERS_H
