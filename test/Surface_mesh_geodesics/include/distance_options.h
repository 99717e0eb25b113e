#ifndef SURFACE_MESH_GEODESICS_DISTANCE_OPTIONS_H
#define SURFACE_MESH_GEODESICS_DISTANCE_OPTIONS_H

// The named parameters of a computation of distances as data, which tests change one after the other. They reach the
// functions as named parameters all the same.

#include <CGAL/Surface_mesh_geodesics/geodesic_parameters.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace test_meshes {

template <class TriangleMesh, class NearestSourceMap = CGAL::Surface_mesh_geodesics::internal::No_nearest_source_map>
using Distance_options = CGAL::Surface_mesh_geodesics::internal::Distance_options<TriangleMesh, NearestSourceMap>;

// Options with a map of nearest sources.
template <class TriangleMesh, class NearestSourceMap>
Distance_options<TriangleMesh, NearestSourceMap> options_with_map(NearestSourceMap map)
{
  return {std::numeric_limits<double>::infinity(), {}, {}, map, nullptr};
}

// Returns the parameters of geodesic_distances().
template <class TriangleMesh, class NearestSourceMap>
auto parameters_of(const Distance_options<TriangleMesh, NearestSourceMap>& options)
{
  const auto np = CGAL::parameters::maximum_distance(options.maximum_distance)
                    .targets(options.targets)
                    .source_offsets(options.source_offsets)
                    .statistics(options.statistics);
  if constexpr(std::is_same<NearestSourceMap, CGAL::Surface_mesh_geodesics::internal::No_nearest_source_map>::value)
    return np;
  else
    return np.nearest_source_map(options.nearest_source_map);
}

// Returns the parameters of certify_geodesic_distances().
template <class TriangleMesh, class NearestSourceMap>
auto certificate_parameters_of(const Distance_options<TriangleMesh, NearestSourceMap>& options)
{
  return CGAL::parameters::maximum_distance(options.maximum_distance).source_offsets(options.source_offsets);
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_DISTANCE_OPTIONS_H
