#ifndef SURFACE_MESH_GEODESICS_APP_NUMBER_ARGUMENTS_H
#define SURFACE_MESH_GEODESICS_APP_NUMBER_ARGUMENTS_H

#include "Command.h"

#include <cstddef>
#include <string>
#include <vector>

namespace geodesics_app {

// Numbers in arguments and in files: the whole text has to be one, and finite.
bool parse_index(const std::string& text, std::size_t& value);
bool parse_number(const std::string& text, double& value);

// the parts of `text` between the separators.
std::vector<std::string> split(const std::string& text, char separator);

// For the value of an option; a Command_error names the option if the text is not such a number.
std::size_t count_argument(const std::string& option, const std::string& text, std::size_t minimum);
double positive_argument(const std::string& option, const std::string& text);
double number_argument(const std::string& option, const std::string& text);

// the value of an option that may be left out.
double positive_argument_or(const Arguments& arguments, const std::string& option, double otherwise);

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_NUMBER_ARGUMENTS_H
