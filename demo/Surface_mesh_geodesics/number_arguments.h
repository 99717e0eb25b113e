#ifndef SURFACE_MESH_GEODESICS_DEMO_NUMBER_ARGUMENTS_H
#define SURFACE_MESH_GEODESICS_DEMO_NUMBER_ARGUMENTS_H

#include "Command.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace geodesics_demo {

// Parse a number in an argument or a file. Return false unless the whole text is a finite number.
bool parse_index(const std::string& text, std::size_t& value);
bool parse_number(const std::string& text, double& value);

// The parts of `text` between the separators.
std::vector<std::string> split(const std::string& text, char separator);

// Without blanks and carriage returns (lines of Windows) at both ends.
std::string without_blanks(const std::string& text);

// The cells of a row of a table, without blanks and without quotes around them.
std::vector<std::string> cells_of_row(const std::string& line, char separator);
bool ends_with(const std::string& text, const std::string& ending);

// Declarations of options with numbers. Values are checked when the command line is parsed, before any work begins: a
// Command_error names the option and the expected value.
using Text_value = boost::program_options::typed_value<std::string>;
using Texts_value = boost::program_options::typed_value<std::vector<std::string>>;

Text_value* count_value(const std::string& option, std::size_t minimum,
                        std::size_t maximum = (std::numeric_limits<std::size_t>::max)());
Text_value* positive_value(const std::string& option);

// Numbers separated by commas. The option may be repeated.
Texts_value* numbers_value(const std::string& option);

// The values of such options, which may be missing.
std::size_t count_argument_or(const Arguments& arguments, const std::string& option, std::size_t otherwise);
double positive_argument_or(const Arguments& arguments, const std::string& option, double otherwise);
std::vector<double> number_arguments(const Arguments& arguments, const std::string& option);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_NUMBER_ARGUMENTS_H
