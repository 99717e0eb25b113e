#ifndef SURFACE_MESH_GEODESICS_DEMO_OBSTACLE_OPTION_H
#define SURFACE_MESH_GEODESICS_DEMO_OBSTACLE_OPTION_H

#include "Command.h"
#include "Program_mesh.h"

#include <vector>

namespace geodesics_demo {

// The option --avoid: a file with the numbers of faces through which no path may lead.
void declare_obstacles(Option_descriptions& options);

// The faces of that file; none without the option. Throws a Command_error with the file and the line for what is not a
// face of the mesh.
std::vector<Face> avoided_faces(const Arguments& arguments, const Mesh& mesh);

// Throws a Command_error if --avoid is given with a page: the paths that pages compute would lead through the faces.
void check_no_page_of_obstacles(const Arguments& arguments, bool has_page);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_OBSTACLE_OPTION_H
