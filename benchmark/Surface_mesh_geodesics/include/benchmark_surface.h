// The surface that a propagation sees, for benchmark programs that call a propagation themselves.

#ifndef BENCHMARK_SURFACE_H
#define BENCHMARK_SURFACE_H

#include "runs_in_process.h"

#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>

#include <boost/property_map/property_map.hpp>

using Benchmark_surface = CGAL::Surface_mesh_geodesics::internal::Intrinsic_surface<
  double, Benchmark_mesh, boost::property_map<Benchmark_mesh, boost::vertex_index_t>::const_type,
  boost::property_map<Benchmark_mesh, boost::face_index_t>::const_type>;

// Reads a mesh, which must outlive the surface.
inline Benchmark_surface surface_of(const Benchmark_mesh& mesh)
{
  return Benchmark_surface(
    mesh, get(boost::vertex_index, mesh), get(boost::face_index, mesh),
    CGAL::Surface_mesh_geodesics::internal::shape_from_points<double>(mesh, CGAL::parameters::default_values()));
}

#endif // BENCHMARK_SURFACE_H
