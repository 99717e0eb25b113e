#ifndef SURFACE_MESH_GEODESICS_APP_PATH_FINDER_H
#define SURFACE_MESH_GEODESICS_APP_PATH_FINDER_H

#include "Place_options.h"
#include "Program_mesh.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>

#include <vector>

namespace geodesics_app {

using Path_finder = CGAL::Surface_mesh_geodesic_paths<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

inline void add_sources(Path_finder& paths, const std::vector<Place>& sources)
{
  for(const Place& s : sources)
  {
    if(s.is_vertex())
      paths.add_source_point(s.vertex);
    else
      paths.add_source_point(s.location);
  }
}

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_PATH_FINDER_H
