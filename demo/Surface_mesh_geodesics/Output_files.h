#ifndef SURFACE_MESH_GEODESICS_APP_OUTPUT_FILES_H
#define SURFACE_MESH_GEODESICS_APP_OUTPUT_FILES_H

#include "Command.h"

#include <fstream>
#include <functional>
#include <list>
#include <ostream>
#include <string>
#include <vector>

namespace geodesics_app {

// whether the name of a file ends with a dot and the format, in small or in capital letters.
bool has_format(const std::string& name, const std::string& format);

// The files that a command writes. Each one is written beside its place, under another name, and gets its name when all
// of them are complete: whoever finds a file with the name finds all of it. What is not complete is removed, also if
// the program is interrupted. Pipes and devices are written directly.
//
// The files are opened by the constructor, before the work begins that might be in vain.
class Output_files
{
public:
  // A format is the end of a name, without the dot; `-` stands for the first format on the standard output. Throws a
  // Command_error if a name has another end, or if a file cannot be written.
  Output_files(const std::vector<std::string>& names, const std::vector<std::string>& formats);
  ~Output_files();

  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;

  // whether a file has one of the formats.
  bool have(const std::vector<std::string>& formats) const;

  // tells that an option is given that matters for these formats only, if no file has one of them.
  void remark_on_unused(const Arguments& arguments, const std::string& option,
                        const std::vector<std::string>& formats, const Console& console) const;

  // calls write(stream, format) for each file, and gives the files their names. Throws a Command_error if a file
  // could not be written.
  void write(const std::function<void(std::ostream&, const std::string&)>& write);

private:
  struct File
  {
    std::string name, temporary_name, format; // no temporary name: written directly
    std::ofstream stream;
  };

  // With another constructor behind it, the destructor removes what was opened before one of the files failed.
  Output_files() = default;

  void open(const std::string& name, const std::string& format);
  void complete(File& file);

  std::list<File> m_files;
};

// The option --output of a command with the given formats, the first of which is the default on the standard output.
void declare_output(Option_descriptions& options, const std::string& formats);

// the files of the option and others; the standard output if there are none.
std::vector<std::string> output_names(const Arguments& arguments, const std::vector<std::string>& others = {});

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_OUTPUT_FILES_H
