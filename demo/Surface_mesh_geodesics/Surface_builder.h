#ifndef SURFACE_MESH_GEODESICS_DEMO_SURFACE_BUILDER_H
#define SURFACE_MESH_GEODESICS_DEMO_SURFACE_BUILDER_H

#include "Polygon_soup.h"
#include "Program_mesh.h"

#include <string>

namespace geodesics_demo {

// Connects the faces of a soup to a mesh. Vertices and faces keep their indices, and the first corner of a face stays
// the first one. Edges and halfedges have the indices that they would get from Surface_mesh::add_face(), which searches
// the surroundings of three vertices for each face; this function builds all connections at once.
//
// Throws a Command_error that names the faces, the edge or the vertex if the faces do not form a surface.
Mesh connected(const std::string& file_name, const Polygon_soup& soup);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_SURFACE_BUILDER_H
