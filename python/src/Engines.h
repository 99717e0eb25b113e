// The classes of the package that compute on a surface.

#ifndef SURFACE_MESH_GEODESICS_PYTHON_ENGINES_H
#define SURFACE_MESH_GEODESICS_PYTHON_ENGINES_H

#include "Surface.h"

#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>

namespace geodesics_python {

#ifdef CGAL_LINKED_WITH_TBB
using Threads = CGAL::Parallel_tag;
constexpr bool has_threads = true;
#else // each call uses one thread
using Threads = CGAL::Sequential_tag;
constexpr bool has_threads = false;
#endif

namespace geodesics = CGAL::Surface_mesh_geodesics;

using Sequential_solver = geodesics::Geodesic_distance_solver<Mesh>;
using Parallel_solver = geodesics::Geodesic_distance_solver<Mesh, Threads>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits, CGAL::Default, CGAL::Default, CGAL::Default, CGAL::Default,
                                                Threads>;

} // namespace geodesics_python

#endif // SURFACE_MESH_GEODESICS_PYTHON_ENGINES_H
