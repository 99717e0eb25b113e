#ifndef SURFACE_MESH_GEODESICS_DEMO_PATH_FINDER_H
#define SURFACE_MESH_GEODESICS_DEMO_PATH_FINDER_H

#include "Curve_options.h"
#include "Distance_field.h"
#include "Location_options.h"
#include "Program_mesh.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>

#include <vector>

namespace geodesics_demo {

using Path_finder = CGAL::Surface_mesh_geodesic_paths<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

struct Distance_run::Paths
{
  explicit Paths(const Mesh& mesh) : finder(mesh) {}

  Path_finder finder;
};

inline void add_sources(Path_finder& paths, const std::vector<Location>& sources)
{
  for(const Location& s : sources)
  {
    if(s.is_vertex())
      paths.add_source_point(s.vertex);
    else
      paths.add_source_point(s.face_location);
  }
}

inline void add_sources(Path_finder& paths, const std::vector<Curve>& sources)
{
  for(const Curve& c : sources)
    paths.add_source_curve(c);
}

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_PATH_FINDER_H
