#ifndef SURFACE_MESH_GEODESICS_DEMO_REACHABILITY_H
#define SURFACE_MESH_GEODESICS_DEMO_REACHABILITY_H

#include "Distance_field.h"
#include "Program_mesh.h"

#include <cstddef>
#include <string>

namespace geodesics_demo {

// The number of connected components of a surface; vertices without faces do not count.
std::size_t number_of_components(const Mesh& mesh);

// "; the mesh has 45 components and 2 vertices without faces", or a part of it: why something is not reached. Faces to
// avoid are named as another reason.
std::string reason_for_unreached(const Mesh& mesh, bool has_obstacles = false);

// Remarks on vertices that no source reaches, if there are any.
void remark_on_unreached(const Mesh& mesh, const Distance_field& field, bool has_obstacles, const Console& console);
void remark_on_unreached(const Mesh& mesh, std::size_t number_of_vertices, bool has_obstacles,
                         const Console& console);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_REACHABILITY_H
