#ifndef SURFACE_MESH_GEODESICS_DEMO_OBSTACLE_OPTION_H
#define SURFACE_MESH_GEODESICS_DEMO_OBSTACLE_OPTION_H

#include "Command.h"
#include "Program_mesh.h"

#include <vector>

namespace geodesics_demo {

// What paths avoid: they lead through none of the faces, and across none of the walls.
struct Obstacles
{
  std::vector<Face> faces;
  std::vector<Mesh::Edge_index> walls;
};

// The option --avoid: a file with the numbers of faces through which no path may lead. And --avoid-property: a property
// that marks such faces (Face_marks.h).
void declare_obstacles(Option_descriptions& options);

// The option --walls: a file with edges that no path may cross, two numbers of vertices on a line.
void declare_walls(Option_descriptions& options);

// The faces of that file and the marked ones of the mesh, which read_mesh() has read; none without the options. A face
// may come twice. Throws a Command_error with the file and the line for what is not a
// face of the mesh.
std::vector<Face> avoided_faces(const Arguments& arguments, const Mesh& mesh);

// The faces of --avoid and the edges of --walls. Throws a Command_error also for what is not an edge of the mesh.
Obstacles obstacles(const Arguments& arguments, const Mesh& mesh);

bool has_obstacles(const Arguments& arguments);

// A flag for each face of the mesh, set for those of a list; no flags if the list is empty.
std::vector<char> flags_of_faces(const Mesh& mesh, const std::vector<Face>& faces);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_OBSTACLE_OPTION_H
