#include "Input_file.h"

#include "Command_error.h"
#include "Output_files.h"
#include "System.h"
#include "number_arguments.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <ios>
#include <system_error>
#include <vector>

namespace geodesics_demo {

namespace fs = std::filesystem;

namespace {

// The files that the options name, and the mesh.
std::vector<std::string> names_of_inputs(const Arguments& arguments)
{
  std::vector<std::string> names{mesh_argument(arguments)};
  for(const auto& [option, value] : arguments)
    if(ends_with(option, "-file") || ends_with(option, "-curve"))
      for(const std::string& name : all_values(arguments, option))
        names.push_back(name);
  for(const char* const option : {"distances", "avoid", "walls"})
    if(has(arguments, option))
      names.push_back(arguments[option].as<std::string>());
  return names;
}

} // namespace

void check_is_readable(const std::string& file_name)
{
  if(file_name.empty())
    throw Command_error(Exit_code::BAD_USAGE, "the name of an input file is empty");
  std::error_code error;
  const fs::file_status status = fs::status(file_name, error);
  if(status.type() == fs::file_type::not_found)
    reject_file(file_name, "the file does not exist");
  if(fs::is_directory(status))
    reject_file(file_name, "is a folder, not a file");
  if(!may_read(file_name))
    reject_file(file_name, std::string("cannot be read: ") + std::strerror(errno));
}

std::ifstream opened_text_file(const std::string& file_name)
{
  check_is_readable(file_name);
  std::ifstream is(file_name);
  if(!is)
    reject_file(file_name, "cannot be opened");
  if(is.peek() == 0xef) // perhaps a mark of byte order, of three bytes
  {
    std::array<char, 3> mark{};
    is.read(mark.data(), 3);
    std::streamsize n = is.gcount();
    is.clear();
    if(mark != std::array<char, 3>{'\xef', '\xbb', '\xbf'})
      for(; n > 0; --n)
        is.unget();
  }
  return is;
}

void check_inputs_are_kept(const Arguments& arguments)
{
  const std::vector<std::string> outputs = named_outputs(arguments);
  for(const std::string& input : names_of_inputs(arguments)) // (an empty name is equivalent to no file)
    for(const std::string& output : outputs)
    {
      std::error_code error;
      if(fs::is_regular_file(output, error) && fs::equivalent(input, output, error))
        throw Command_error(Exit_code::BAD_USAGE,
                            output + ": this command reads the file; give the output another name");
    }
}

void check_outputs_differ(const Arguments& arguments)
{
  const auto path_of = [](const std::string& name)
  {
    std::error_code error;
    return fs::weakly_canonical(fs::absolute(name, error), error);
  };
  for(const std::string& lines : all_values(arguments, "lines"))
    for(const char* const option : {"output", "html"})
      for(const std::string& name : all_values(arguments, option))
        if(name == lines || path_of(name) == path_of(lines))
          throw Command_error(Exit_code::BAD_USAGE, name + ": --lines and --" + option + " name the same file");
}

} // namespace geodesics_demo
