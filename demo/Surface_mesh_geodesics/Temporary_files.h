#ifndef SURFACE_MESH_GEODESICS_DEMO_TEMPORARY_FILES_H
#define SURFACE_MESH_GEODESICS_DEMO_TEMPORARY_FILES_H

#include <string>

namespace geodesics_demo {

// Files that are removed if a signal ends the program (Ctrl-C, a closed terminal, kill).
void remove_if_interrupted(const std::string& file_name);

// Call it when the file has its final name or was removed.
void keep_if_interrupted(const std::string& file_name);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_TEMPORARY_FILES_H
