#ifndef SURFACE_MESH_GEODESICS_APP_COMMAND_H
#define SURFACE_MESH_GEODESICS_APP_COMMAND_H

#include "Console.h"

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <string>
#include <vector>

namespace geodesics_app {

using Option_descriptions = boost::program_options::options_description;
using Arguments = boost::program_options::variables_map;

// A subcommand: what it is called, how it explains itself, and what it does. Each one has a file of its own; a new one
// is added there and to the list in main.cpp.
struct Command
{
  const char* name;
  const char* summary;     // one line, for the list of subcommands
  const char* description; // what --help says above the options
  const char* examples;    // what --help says below them
  void (*declare)(Option_descriptions& options);
  void (*run)(const Arguments& arguments, const Console& console); // throws a Command_error if it fails
};

extern const Command distances_command, path_command, voronoi_command, sample_command, remesh_command, matrix_command,
  check_command, info_command;

// All subcommands have these options. The name of the mesh is the only argument that is not an option.
inline std::string mesh_argument(const Arguments& arguments)
{
  return arguments["mesh"].as<std::string>();
}

inline bool has(const Arguments& arguments, const std::string& option)
{
  return arguments.count(option) > 0;
}

// the values of an option that may be given several times.
inline std::vector<std::string> all_values(const Arguments& arguments, const std::string& option)
{
  return has(arguments, option) ? arguments[option].as<std::vector<std::string>>() : std::vector<std::string>();
}

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_COMMAND_H
