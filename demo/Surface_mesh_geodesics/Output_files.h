#ifndef SURFACE_MESH_GEODESICS_DEMO_OUTPUT_FILES_H
#define SURFACE_MESH_GEODESICS_DEMO_OUTPUT_FILES_H

#include "Command.h"

#include <fstream>
#include <functional>
#include <list>
#include <ostream>
#include <string>
#include <vector>

namespace geodesics_demo {

// Does the name of a file end with a dot and the format, in lower or upper case?
bool has_format(const std::string& name, const std::string& format);

// The files that a command writes. Each file is written under a temporary name in its folder, and renamed when all
// files are complete: a file with the final name is always complete. Incomplete files are removed, also if the program
// is interrupted. Pipes and devices are written directly.
//
// The constructor opens the files, so that a wrong name is found before the work begins.
class Output_files
{
public:
  // A format is the ending of a name, without the dot; `-` means the first format on the standard output. A device or a
  // pipe without such an ending gets the first format, too. Throws a Command_error if a name has another ending, or if
  // a file cannot be written.
  Output_files(const std::vector<std::string>& names, const std::vector<std::string>& formats);
  ~Output_files();

  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;

  // Does a file have one of the formats?
  bool have(const std::vector<std::string>& formats) const;

  // Prints a remark if an option is given that affects these formats only, and no file has one of them.
  void remark_on_unused(const Arguments& arguments, const std::string& option,
                        const std::vector<std::string>& formats, const Console& console) const;

  // Calls write(stream, format) for each file, and renames the files. Throws a Command_error if a file could not be
  // written.
  void write(const std::function<void(std::ostream&, const std::string&)>& write);

private:
  struct File
  {
    std::string name, temporary_name, format; // an empty temporary name: written directly
    std::ofstream stream;
  };

  // A delegated constructor: if one of the files fails, the destructor removes the files opened before.
  Output_files() = default;

  void open(const std::string& name, const std::string& format);
  void complete(File& file);

  std::list<File> m_files;
};

// The option --output of a command. The first format is the default on the standard output.
void declare_output(Option_descriptions& options, const std::string& formats);

// The files that --output, --html and --lines name.
std::vector<std::string> named_outputs(const Arguments& arguments);

// On a terminal, a remark that names these files, their sizes, and the time since the program began.
void tell_written_files(const Arguments& arguments, double seconds, const Console& console);

// The files of the option, and others; the standard output if there are none.
std::vector<std::string> output_names(const Arguments& arguments, const std::vector<std::string>& others = {});

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_OUTPUT_FILES_H
