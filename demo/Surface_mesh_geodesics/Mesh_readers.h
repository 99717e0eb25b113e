#ifndef SURFACE_MESH_GEODESICS_DEMO_MESH_READERS_H
#define SURFACE_MESH_GEODESICS_DEMO_MESH_READERS_H

#include "Console.h"
#include "Polygon_soup.h"

#include <string>
#include <string_view>

namespace geodesics_demo {

// One function for each format of files; the name of the file is for messages only. They throw a Command_error with
// the line and the word at which a text is wrong, and never allocate more than the size of the file justifies.

// OFF with normals, colors, textures or homogeneous coordinates; text or binary.
Polygon_soup read_OFF(const std::string& file_name, std::string_view bytes);

// OBJ: the statements v and f. Remarks on statements that are not known.
Polygon_soup read_OBJ(const std::string& file_name, std::string_view bytes, const Console& console);

// PLY, text or binary with either order of bytes: faces and strips of triangles. Faces are marked where their property
// with the name `mark` is not 0; none are if the name is empty.
Polygon_soup read_PLY(const std::string& file_name, std::string_view bytes, const std::string& mark);

// STL, text or binary. Corners with equal coordinates are one vertex.
Polygon_soup read_STL(const std::string& file_name, std::string_view bytes);

// TS of GOCAD: the triangles of all its objects.
Polygon_soup read_TS(const std::string& file_name, std::string_view bytes);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_MESH_READERS_H
