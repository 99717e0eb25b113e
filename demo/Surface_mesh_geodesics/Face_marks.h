#ifndef SURFACE_MESH_GEODESICS_DEMO_FACE_MARKS_H
#define SURFACE_MESH_GEODESICS_DEMO_FACE_MARKS_H

#include "Command.h"
#include "Console.h"
#include "Polygon_soup.h"
#include "Program_mesh.h"

#include <vector>

namespace geodesics_demo {

// Faces of a file, and what became of them: triangles of the mesh, if they were cut.
//
// Faces may be marked by a property of a PLY file, the one that --avoid-property names: those where it is not 0. The
// marks follow their faces from the file to the mesh, wherever a face is left out or cut into triangles on the way.

// Declares the option --avoid-property.
void declare_face_marks(Option_descriptions& options);

bool are_faces_marked(const Arguments& arguments);

// Is the file of --avoid the one that has the property?
bool has_file_of_marks(const Arguments& arguments);

// Reads the file of the mesh. With the option, faces are marked by their property in this file, or in that of --avoid
// if its name ends with .ply; this one must have the same faces. Throws a Command_error if the property is missing.
Polygon_soup read_marked_polygons(const Arguments& arguments, const Console& console);

// Gives the marks of a soup to the mesh of its faces, one for each. Does nothing if the soup has no marks.
void give_marks(const Polygon_soup& soup, Mesh& mesh);

// Cuts all faces into triangles, which get the marks of their faces. Returns whether CGAL could do it.
bool cut_into_triangles(Mesh& mesh);

// For each triangle of the mesh, the index that it, or the face that it is a part of, had before faces were cut.
std::vector<Polygon_soup::Index> faces_of_file(const Mesh& mesh);

// The marked faces, in ascending order.
std::vector<Face> marked_faces(const Mesh& mesh);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_FACE_MARKS_H
