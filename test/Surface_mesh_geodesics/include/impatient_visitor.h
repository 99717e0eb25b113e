#ifndef SURFACE_MESH_GEODESICS_IMPATIENT_VISITOR_H
#define SURFACE_MESH_GEODESICS_IMPATIENT_VISITOR_H

// A visitor that ends a run after some steps.

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>

#include <cstddef>
#include <stdexcept>

namespace test_meshes {

// Goes on for this number of steps. Then it cancels the run, or throws.
struct Impatient_visitor : CGAL::Surface_mesh_geodesics::Geodesic_default_visitor
{
  std::size_t steps_left = 0;
  bool throws = false;

  bool go_further()
  {
    if(steps_left == 0 && throws)
    {
      throw std::range_error("thrown by the visitor");
    }
    return steps_left == 0 ? false : (--steps_left, true);
  }
};

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_IMPATIENT_VISITOR_H
