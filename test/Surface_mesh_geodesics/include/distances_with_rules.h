#ifndef SURFACE_MESH_GEODESICS_DISTANCES_WITH_RULES_H
#define SURFACE_MESH_GEODESICS_DISTANCES_WITH_RULES_H

// geodesic_distances() with a choice of pruning rules and of the number type of the computation.

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

namespace test_meshes {

template <class Rules, class NumberType = double, class TriangleMesh, class VertexDistanceMap, class Sources,
          class Options, class NamedParameters = CGAL::parameters::Default_named_parameters>
bool distances_with_rules(const TriangleMesh& tm, VertexDistanceMap map, const Sources& sources, const Options& options,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  namespace internal = CGAL::Surface_mesh_geodesics::internal;
  CGAL::Surface_mesh_geodesics::Geodesic_default_visitor visitor;
  return internal::compute_geodesic_distances<CGAL::Sequential_tag, Rules, NumberType>(
    tm, map, sources, options, internal::shape_from_points<NumberType>(tm, np), visitor, np);
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_DISTANCES_WITH_RULES_H
