#ifndef SURFACE_MESH_GEODESICS_APP_INPUT_FILE_H
#define SURFACE_MESH_GEODESICS_APP_INPUT_FILE_H

#include "Command.h"

#include <fstream>
#include <string>

namespace geodesics_app {

// throws a Command_error that tells why a file cannot be read: it is not there, is a folder, or is protected. Nothing
// is opened: that would take a pipe from its reader.
void check_is_readable(const std::string& file_name);

// opens a file that is not the mesh. Throws a Command_error if that is impossible.
std::ifstream opened_text_file(const std::string& file_name);

// throws a Command_error if a file that the command reads is one that it is to write: a mistake would destroy it.
void check_inputs_are_kept(const Arguments& arguments);

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_INPUT_FILE_H
