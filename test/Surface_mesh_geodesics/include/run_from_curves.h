#ifndef SURFACE_MESH_GEODESICS_RUN_FROM_CURVES_H
#define SURFACE_MESH_GEODESICS_RUN_FROM_CURVES_H

// A propagation from curves, with all that it finds: the refined mesh, distances, windows and strips.

#include "curve_cases.h"

#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/curves/Path_run_from_curves.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace curve_cases {

struct Run_from_curves
{
  using Vertex_index_map = std::decay_t<decltype(get(boost::vertex_index, std::declval<const Mesh&>()))>;
  using Face_index_map = std::decay_t<decltype(get(boost::face_index, std::declval<const Mesh&>()))>;
  using Point_map = std::decay_t<decltype(get(CGAL::vertex_point, std::declval<const Mesh&>()))>;
  using Shape = CGAL::Surface_mesh_geodesics::internal::Shape_from_points<double, Mesh, Point_map>;

  Run_from_curves(const Mesh& tm, const std::vector<Curve>& curves)
    : surface(tm, get(boost::vertex_index, tm), get(boost::face_index, tm), Shape(tm, get(CGAL::vertex_point, tm)),
              CGAL::Surface_mesh_geodesics::internal::One_block(),
              CGAL::Surface_mesh_geodesics::internal::Obstacles()),
      insertion(surface.mesh())
  {
    namespace internal = CGAL::Surface_mesh_geodesics::internal;
    const internal::Strip_path_run<double> path_run;
    path_run.insert(surface.mesh(), insertion, surface.located_curves(curves, {}), arrivals);
    windows.reset(surface.mesh().number_of_faces());
    field.keeps_images = true;
    CGAL::Surface_mesh_geodesics::Propagation_statistics statistics;
    path_run.run(surface.mesh(), field, internal::Window_keeper<double>(windows), arrivals, false,
                 [](std::size_t, double) { return true; }, statistics);
  }

  CGAL::Surface_mesh_geodesics::internal::Intrinsic_surface<double, Mesh, Vertex_index_map, Face_index_map> surface;
  CGAL::Surface_mesh_geodesics::internal::Source_insertion<double> insertion;
  CGAL::Surface_mesh_geodesics::internal::Curve_arrivals<double> arrivals;
  CGAL::Surface_mesh_geodesics::internal::Vertex_distance_field<double> field;
  CGAL::Surface_mesh_geodesics::internal::Edge_window_field<double> windows;
};

} // namespace curve_cases

#endif // SURFACE_MESH_GEODESICS_RUN_FROM_CURVES_H
