#include "Output_files.h"

#include "Command_error.h"
#include "System.h"
#include "Temporary_files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <system_error>

namespace geodesics_demo {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

[[noreturn]] void complain(const std::string& name, const std::string& reason)
{
  throw Command_error(Exit_code::BAD_OUTPUT, name + ": cannot be written: " + reason);
}

char small_letter(char c)
{
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

std::string list_of(const std::vector<std::string>& formats)
{
  std::string list;
  for(const std::string& format : formats)
    list += (list.empty() ? "." : ", .") + format;
  return list;
}

std::string format_of(const std::string& name, const std::vector<std::string>& formats)
{
  for(const std::string& format : formats)
    if(has_format(name, format))
      return format;
  std::error_code error;
  if(fs::is_other(name, error)) // a device or a pipe, such as /dev/null: as the standard output
    return formats.front();
  throw Command_error(Exit_code::BAD_USAGE, name + ": the name must end with one of " + list_of(formats));
}

// Numbers have all their digits: reading them again gives the same numbers.
constexpr int number_of_digits = 17;

} // namespace

bool has_format(const std::string& name, const std::string& format)
{
  if(format == "html" && has_format(name, "htm"))
    return true;
  const std::string ending = "." + format;
  return name.size() > ending.size()
      && std::equal(ending.rbegin(), ending.rend(), name.rbegin(),
                    [](char a, char b) { return small_letter(a) == small_letter(b); });
}

Output_files::Output_files(const std::vector<std::string>& names, const std::vector<std::string>& formats)
  : Output_files()
{
  std::vector<fs::path> paths; // a file that is named twice is written once
  for(const std::string& name : names)
  {
    if(name.empty())
      throw Command_error(Exit_code::BAD_USAGE, "the name of an output file is empty");
    std::error_code error;
    const fs::path path = name == "-" ? fs::path(name) : fs::weakly_canonical(fs::absolute(name, error), error);
    if(!error && std::find(paths.begin(), paths.end(), path) != paths.end())
      continue;
    paths.push_back(path);
    open(name, name == "-" ? formats.front() : format_of(name, formats));
  }
}

Output_files::~Output_files()
{
  for(File& file : m_files)
    if(!file.temporary_name.empty())
    {
      file.stream.close();
      std::error_code error;
      fs::remove(file.temporary_name, error);
      keep_if_interrupted(file.temporary_name);
    }
}

void Output_files::open(const std::string& name, const std::string& format)
{
  m_files.emplace_back();
  File& file = m_files.back();
  file.name = name;
  file.format = format;
  if(name == "-")
    return;
  std::error_code error;
  const fs::file_status status = fs::status(name, error);
  if(fs::is_directory(status))
    complain(name, "it is a folder");
  if(fs::exists(status) && !may_overwrite(name)) // renaming would overwrite a protected file
    complain(name, std::strerror(errno));
  if(!fs::exists(status) || fs::is_regular_file(status))
  {
    // a link stays a link; the file that it leads to is replaced
    const fs::path path = fs::exists(status) ? fs::canonical(name) : fs::path(name);
    file.name = path.string();
    const std::string hidden_name = "." + std::to_string(process_number()) + "." + path.filename().string();
    file.temporary_name = (path.parent_path() / hidden_name).string();
    remove_if_interrupted(file.temporary_name);
  }
  errno = 0;
  file.stream.open(file.temporary_name.empty() ? name : file.temporary_name, std::ios::binary | std::ios::trunc);
  if(!file.stream)
  {
    const int reason = errno;
    keep_if_interrupted(file.temporary_name);
    file.temporary_name.clear();
    complain(name, std::strerror(reason));
  }
}

bool Output_files::have(const std::vector<std::string>& formats) const
{
  return std::any_of(m_files.begin(), m_files.end(), [&](const File& file)
                     { return std::find(formats.begin(), formats.end(), file.format) != formats.end(); });
}

void Output_files::remark_on_unused(const Arguments& arguments, const std::string& option,
                                    const std::vector<std::string>& formats, const Console& console) const
{
  if(has(arguments, option) && !have(formats))
    console.note("--" + option + " has no effect without an output " + list_of(formats));
}

void Output_files::write(const std::function<void(std::ostream&, const std::string&)>& write)
{
  for(File& file : m_files)
  {
    std::ostream& os = file.name == "-" ? std::cout : file.stream;
    os.precision(number_of_digits);
    errno = 0;
    write(os, file.format);
    os.flush();
    if(file.stream.is_open())
      file.stream.close();
    if(!os)
      complain(file.name == "-" ? "standard output" : file.name,
               errno != 0 ? std::strerror(errno) : "the stream is broken");
  }
  for(File& file : m_files)
    if(!file.temporary_name.empty())
      complete(file);
}

void Output_files::complete(File& file)
{
  std::error_code error;
  const fs::file_status old = fs::status(file.name, error);
  if(fs::exists(old))
    fs::permissions(file.temporary_name, old.permissions(), error);
  fs::rename(file.temporary_name, file.name, error);
  if(error)
    complain(file.name, error.message());
  keep_if_interrupted(file.temporary_name);
  file.temporary_name.clear();
}

void declare_output(Option_descriptions& options, const std::string& formats)
{
  const std::string text = "an output file: " + formats + "; may be repeated";
  options.add_options()("output,o", po::value<std::vector<std::string>>()->value_name("FILE")->composing(),
                        text.c_str());
}

std::vector<std::string> named_outputs(const Arguments& arguments)
{
  std::vector<std::string> result;
  for(const char* option : {"output", "html", "lines"})
  {
    const std::vector<std::string> names = all_values(arguments, option);
    result.insert(result.end(), names.begin(), names.end());
  }
  return result;
}

void tell_written_files(const Arguments& arguments, double seconds, const Console& console)
{
  if(!console.shows_progress())
    return;
  std::ostringstream text;
  text.precision(3);
  const char* separator = "wrote ";
  for(const std::string& name : named_outputs(arguments))
  {
    std::error_code error;
    if(!fs::is_regular_file(name, error))
      continue;
    const double bytes = static_cast<double>(fs::file_size(name, error));
    text << separator << name << " (" << (bytes < 1e6 ? bytes / 1e3 : bytes / 1e6) << (bytes < 1e6 ? " kB)" : " MB)");
    separator = ", ";
  }
  if(!text.str().empty())
  {
    text << " in " << seconds << " s";
    console.note(text.str());
  }
}

std::vector<std::string> output_names(const Arguments& arguments, const std::vector<std::string>& others)
{
  std::vector<std::string> names = all_values(arguments, "output");
  names.insert(names.end(), others.begin(), others.end());
  return names.empty() ? std::vector<std::string>{"-"} : names;
}

} // namespace geodesics_demo
