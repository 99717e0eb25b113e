// One iteration of a scheduler: the face that joins the traversed area, or the vertex that is visited.

#ifndef STEP_H
#define STEP_H

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

namespace schedulers {

using CGAL::Surface_mesh_geodesics::internal::Face_id;
using CGAL::Surface_mesh_geodesics::internal::Vertex_id;

// Exactly one of the two is not null_id.
struct Step
{
  Vertex_id vertex = CGAL::Surface_mesh_geodesics::internal::null_id;
  Face_id face = CGAL::Surface_mesh_geodesics::internal::null_id;

  bool is_face() const { return face != CGAL::Surface_mesh_geodesics::internal::null_id; }
};

} // namespace schedulers

#endif // STEP_H
