#include "Obstacle_option.h"

#include "Command_error.h"
#include "Input_file.h"
#include "number_arguments.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <sstream>

namespace geodesics_demo {

void declare_obstacles(Option_descriptions& options)
{
  options.add_options()
    ("avoid", boost::program_options::value<std::string>()->value_name("FILE"),
     "paths lead around the faces whose indices are in the file, and may run along their rim; not for pages");
}

std::vector<Face> avoided_faces(const Arguments& arguments, const Mesh& mesh)
{
  std::vector<Face> faces;
  if(!has(arguments, "avoid"))
    return faces;
  const std::string& file_name = arguments["avoid"].as<std::string>();
  std::ifstream file = opened_text_file(file_name);
  std::string line;
  for(std::size_t number = 1; std::getline(file, line); ++number)
  {
    line.erase((std::min)(line.find('#'), line.size()));
    std::replace_if(line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
    std::istringstream words(line);
    for(std::string word; words >> word;)
    {
      std::size_t f = 0;
      if(!parse_index(word, f))
        reject_line(file_name, number, "'" + word + "' is not the index of a face");
      if(f >= mesh.number_of_faces())
        reject_line(file_name, number, "there is no face " + word + ", but " + counted_faces(mesh.number_of_faces())
                                         + ", counted from 0");
      faces.push_back(Face(static_cast<Mesh::size_type>(f)));
    }
  }
  if(file.bad())
    reject_file(file_name, "cannot be read");
  return faces;
}

void check_no_page_of_obstacles(const Arguments& arguments, bool has_page)
{
  if(has(arguments, "avoid") && has_page)
    throw Command_error(Exit_code::BAD_USAGE, "--avoid cannot be combined with a page .html");
}

} // namespace geodesics_demo
