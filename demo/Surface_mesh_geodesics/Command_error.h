#ifndef SURFACE_MESH_GEODESICS_DEMO_COMMAND_ERROR_H
#define SURFACE_MESH_GEODESICS_DEMO_COMMAND_ERROR_H

#include <cstddef>
#include <stdexcept>
#include <string>

namespace geodesics_demo {

// The exit status. The numbers are part of the interface: the man page lists them.
enum class Exit_code
{
  SUCCESS = 0,
  NO_RESULT = 1,  // the computation has no result, or not enough memory
  BAD_USAGE = 2,  // the command line is wrong
  BAD_INPUT = 3,  // a file cannot be read or has invalid contents
  BAD_OUTPUT = 4  // a file cannot be written
};

// An error that ends the program with a message for the user.
class Command_error
  : public std::runtime_error
{
public:
  Command_error(Exit_code code, const std::string& message) : std::runtime_error(message), m_code(code) {}

  Exit_code code() const { return m_code; }

private:
  Exit_code m_code;
};

// Ends the program because of a file, or of a line of a file.
[[noreturn]] inline void reject_file(const std::string& file_name, const std::string& what)
{
  throw Command_error(Exit_code::BAD_INPUT, (file_name == "-" ? "standard input" : file_name) + ": " + what);
}

[[noreturn]] inline void reject_line(const std::string& file_name, std::size_t line, const std::string& what)
{
  throw Command_error(Exit_code::BAD_INPUT, (file_name == "-" ? "standard input" : file_name) + ", line "
                                              + std::to_string(line) + ": " + what);
}

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_COMMAND_ERROR_H
