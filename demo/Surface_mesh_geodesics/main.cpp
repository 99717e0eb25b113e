// surface_mesh_geodesics: the package as a command line program.

#include "Command.h"
#include "Command_error.h"
#include "Html_page.h"
#include "Input_file.h"
#include "Location_options.h"
#include "Output_files.h"
#include "Program_mesh.h"
#include "System.h"
#include "similar_words.h"

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/version.h>

#include <boost/program_options/parsers.hpp>
#include <boost/program_options/positional_options.hpp>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstddef>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#ifndef SURFACE_MESH_GEODESICS_VERSION
#define SURFACE_MESH_GEODESICS_VERSION "unknown"
#endif

namespace po = boost::program_options;

namespace geodesics_demo {
namespace {

const std::vector<const Command*>& commands()
{
  static const std::vector<const Command*> all{&distances_command, &path_command, &voronoi_command, &sample_command,
                                               &remesh_command, &matrix_command, &check_command, &info_command};
  return all;
}

void print_help(std::ostream& os)
{
  os << "Exact geodesic distances, shortest paths and Voronoi diagrams on triangle meshes.\n\n"
        "usage: surface_mesh_geodesics SUBCOMMAND MESH [options]\n"
        "       surface_mesh_geodesics SUBCOMMAND --help\n\nsubcommands:\n";
  for(const Command* command : commands())
    os << "  " << command->name << std::string(11 - std::string(command->name).size(), ' ') << command->summary << '\n';
  os << "\nMESH is a file with a surface, in the format .off, .obj, .ply, .stl or .ts; - is the standard input.\n\n"
        "examples:\n"
        "  surface_mesh_geodesics info bunny.off\n"
        "  surface_mesh_geodesics distances bunny.off --source 0 -o distances.csv -o colors.ply\n"
        "  surface_mesh_geodesics path bunny.off --source 0 --target 100 -o path.obj\n";
}

Option_descriptions all_options(const Command& command)
{
  Option_descriptions options("options", 100, 60);
  command.declare(options);
  declare_repair(options);
  options.add_options()
    ("quiet,q", "no remarks and no progress on the error stream")
    ("help,h", "print this text");
  return options;
}

void print_help(const Command& command, std::ostream& os)
{
  os << command.summary << "\n\nusage: surface_mesh_geodesics " << command.name << " MESH [options]\n\n"
     << command.description << "\n\n" << all_options(command) << "\nexamples:\n" << command.examples
     << "\nexit status: 0 success, 1 no result, 2 wrong command line, 3 bad input, 4 output cannot be written\n";
}

// Joins an option and its negative value, as in `--source-point -1,0,0`: the parser would take the value for an option.
std::vector<std::string> joined_values(const std::vector<std::string>& arguments)
{
  std::vector<std::string> result;
  for(const std::string& a : arguments)
  {
    const bool is_negative
      = a.size() > 1 && a[0] == '-' && (std::isdigit(static_cast<unsigned char>(a[1])) != 0 || a[1] == '.');
    const bool follows_option = !result.empty() && result.back().compare(0, 2, "--") == 0
                             && result.back().find('=') == std::string::npos;
    if(is_negative && follows_option)
      result.back() += "=" + a;
    else
      result.push_back(a);
  }
  return result;
}

Arguments parse(const Command& command, const std::vector<std::string>& words)
{
  Option_descriptions options = all_options(command);
  options.add_options()("mesh", po::value<std::string>());
  po::positional_options_description position;
  position.add("mesh", 1);
  namespace style = po::command_line_style;
  Arguments arguments;
  try
  {
    po::store(po::command_line_parser(joined_values(words))
                .options(options)
                .positional(position)
                .style(style::default_style & ~style::allow_guessing)
                .run(),
              arguments);
  }
  catch(const po::unknown_option& error)
  {
    std::vector<std::string> names;
    for(const auto& option : options.options())
      names.push_back("--" + option->long_name());
    throw Command_error(Exit_code::BAD_USAGE, error.what() + hint_at_similar_word(error.get_option_name(), names)
                                                + "; see surface_mesh_geodesics " + command.name + " --help");
  }
  if(!has(arguments, "help"))
    po::notify(arguments); // reports missing options
  return arguments;
}

void run(const Command& command, const std::vector<std::string>& words)
{
  const Arguments arguments = parse(command, words);
  std::vector<std::string> line = words;
  line.insert(line.begin(), command.name);
  set_command_line(line);
  if(has(arguments, "help"))
  {
    print_help(command, std::cout);
    return;
  }
  const bool needs_mesh = command.needs_mesh == nullptr || command.needs_mesh(arguments);
  if(needs_mesh && !has(arguments, "mesh"))
    throw Command_error(Exit_code::BAD_USAGE, "no mesh is given");
  check_inputs_are_kept(arguments);
  check_outputs_differ(arguments);
  const Console console(has(arguments, "quiet"));
  const auto start = std::chrono::steady_clock::now();
  if(is_seed_unused(arguments))
    console.note("--seed has no effect: no random locations are requested");
  try
  {
    command.run(arguments, console);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    tell_written_files(arguments, time.count(), console);
  }
  catch(const CGAL::Surface_mesh_geodesics::Invalid_geodesic_input& error)
  {
    const std::string mesh = mesh_argument(arguments);
    throw Command_error(Exit_code::BAD_INPUT, (mesh.empty() ? "a mesh" : mesh) + ": " + error.what());
  }
}

const Command& command_with_name(const std::string& name)
{
  const auto found = std::find_if(commands().begin(), commands().end(),
                                  [&](const Command* c) { return c->name == name; });
  if(found == commands().end())
  {
    std::vector<std::string> names;
    for(const Command* command : commands())
      names.push_back(command->name);
    throw Command_error(Exit_code::BAD_USAGE, "there is no subcommand '" + name + "'"
                                                + hint_at_similar_word(name, names)
                                                + "; see surface_mesh_geodesics --help");
  }
  return **found;
}

void run(std::vector<std::string> words)
{
  if(words.empty())
  {
    print_help(std::cerr);
    throw Command_error(Exit_code::BAD_USAGE, "no subcommand is given");
  }
  const std::string first = words.front();
  words.erase(words.begin());
  const bool is_help = first == "--help" || first == "-h";
  const std::size_t most_words = first == "help" ? 1 : 0;
  if((is_help || first == "help" || first == "--version") && words.size() > most_words)
    throw Command_error(Exit_code::BAD_USAGE, "'" + words.back() + "' after " + first
                                                + " is superfluous; see surface_mesh_geodesics --help");
  if(first == "--version")
    std::cout << "surface_mesh_geodesics " SURFACE_MESH_GEODESICS_VERSION " with CGAL " CGAL_VERSION_STR << '\n';
  else if(is_help || (first == "help" && words.empty()))
    print_help(std::cout);
  else if(first == "help")
    print_help(command_with_name(words.front()), std::cout);
  else
    run(command_with_name(first), words);
  if(!std::cout.flush())
    throw Command_error(Exit_code::BAD_OUTPUT, "standard output: cannot be written");
}

int fail(Exit_code code, const std::string& message)
{
  std::string line = message; // the message of a failed assertion has several lines
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::cerr << "surface_mesh_geodesics: error: " << line << std::endl;
  return static_cast<int>(code);
}

int checked_run(const std::vector<std::string>& words)
{
  try
  {
    run(words);
    return static_cast<int>(Exit_code::SUCCESS);
  }
  catch(const Command_error& error)
  {
    return fail(error.code(), error.what());
  }
  catch(const po::too_many_positional_options_error&)
  {
    return fail(Exit_code::BAD_USAGE, "more than one mesh is given; options begin with two dashes, lists have commas "
                                      "and no blanks (0,1,2), and names with blanks need quotes");
  }
  catch(const po::error& error)
  {
    return fail(Exit_code::BAD_USAGE, error.what());
  }
  catch(const std::bad_alloc&)
  {
    return fail(Exit_code::NO_RESULT, "not enough memory");
  }
  catch(const std::exception& error)
  {
    return fail(Exit_code::NO_RESULT, error.what());
  }
}

} // namespace
} // namespace geodesics_demo

int main(int argc, char* argv[])
{
  geodesics_demo::prepare_standard_streams();
  std::ios_base::sync_with_stdio(false);
  return geodesics_demo::checked_run(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
}
