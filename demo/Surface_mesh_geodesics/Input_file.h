#ifndef SURFACE_MESH_GEODESICS_DEMO_INPUT_FILE_H
#define SURFACE_MESH_GEODESICS_DEMO_INPUT_FILE_H

#include "Command.h"

#include <fstream>
#include <string>

namespace geodesics_demo {

// Throws a Command_error with the reason if a file cannot be read: it does not exist, is a folder, or is protected.
// Does not open the file, because that would disturb a pipe.
void check_is_readable(const std::string& file_name);

// Opens a file other than the mesh. Throws a Command_error on failure.
std::ifstream opened_text_file(const std::string& file_name);

// Throws a Command_error if an output file is also an input file, which would be overwritten.
void check_inputs_are_kept(const Arguments& arguments);

// Throws if --lines names a file that another option names for another result.
void check_outputs_differ(const Arguments& arguments);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_INPUT_FILE_H
