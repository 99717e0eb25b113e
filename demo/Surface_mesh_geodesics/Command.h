#ifndef SURFACE_MESH_GEODESICS_DEMO_COMMAND_H
#define SURFACE_MESH_GEODESICS_DEMO_COMMAND_H

#include "Console.h"

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <string>
#include <vector>

namespace geodesics_demo {

using Option_descriptions = boost::program_options::options_description;
using Arguments = boost::program_options::variables_map;

// A subcommand: its name, its texts of help, its options and its work. Each subcommand has its own file; a new one is
// also added to the list in main.cpp.
struct Command
{
  const char* name;
  const char* summary;     // one line, for the list of subcommands
  const char* description; // --help prints it above the options
  const char* examples;    // --help prints them below the options
  void (*declare)(Option_descriptions& options);
  void (*run)(const Arguments& arguments, const Console& console); // throws a Command_error on failure
  bool (*needs_mesh)(const Arguments& arguments) = nullptr; // null: always
};

extern const Command distances_command, path_command, voronoi_command, sample_command, remesh_command, matrix_command,
  check_command, info_command;

// Common to all subcommands. The name of the mesh is the only argument that is not an option; empty if there is none.
inline std::string mesh_argument(const Arguments& arguments)
{
  return arguments.count("mesh") > 0 ? arguments["mesh"].as<std::string>() : std::string();
}

inline bool has(const Arguments& arguments, const std::string& option)
{
  return arguments.count(option) > 0;
}

// The values of an option that may be repeated.
inline std::vector<std::string> all_values(const Arguments& arguments, const std::string& option)
{
  return has(arguments, option) ? arguments[option].as<std::vector<std::string>>() : std::vector<std::string>();
}

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_COMMAND_H
