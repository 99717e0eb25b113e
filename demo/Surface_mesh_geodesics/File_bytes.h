#ifndef SURFACE_MESH_GEODESICS_DEMO_FILE_BYTES_H
#define SURFACE_MESH_GEODESICS_DEMO_FILE_BYTES_H

#include <string>

namespace geodesics_demo {

// The contents of a file, or of the standard input if the name is `-`. Throws a Command_error if it cannot be read, or
// if it is empty. All readers of meshes work on bytes in memory: a stream decides anew at each number where its bytes
// come from, which takes longer than converting the number.
std::string bytes_of(const std::string& file_name);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_FILE_BYTES_H
