#ifndef SURFACE_MESH_GEODESICS_APP_TEMPORARY_FILES_H
#define SURFACE_MESH_GEODESICS_APP_TEMPORARY_FILES_H

#include <string>

namespace geodesics_app {

// Files that are removed if a signal ends the program (Ctrl-C, a closed terminal, kill).
void remove_if_interrupted(const std::string& file_name);

// The file has got its name, or has been removed.
void keep_if_interrupted(const std::string& file_name);

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_TEMPORARY_FILES_H
