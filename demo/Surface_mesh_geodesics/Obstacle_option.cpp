#include "Obstacle_option.h"

#include "Command_error.h"
#include "Face_marks.h"
#include "Input_file.h"
#include "number_arguments.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace geodesics_demo {

void declare_obstacles(Option_descriptions& options)
{
  options.add_options()
    ("avoid", boost::program_options::value<std::string>()->value_name("FILE"),
     "paths lead around the faces whose indices are in the file, and may run along their rim");
  declare_face_marks(options);
}

void declare_walls(Option_descriptions& options)
{
  options.add_options()
    ("walls", boost::program_options::value<std::string>()->value_name("FILE"),
     "paths do not cross the edges in the file, two vertices on a line, and may run along them");
}

namespace {

// Calls take(words, number) for each line of a file, without its comment. The number counts from 1.
template <typename Take>
void for_each_line(const std::string& file_name, const Take& take)
{
  std::ifstream file = opened_text_file(file_name);
  std::string line;
  for(std::size_t number = 1; std::getline(file, line); ++number)
  {
    line.erase((std::min)(line.find('#'), line.size()));
    std::replace_if(line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
    std::istringstream words(line);
    take(std::vector<std::string>(std::istream_iterator<std::string>(words), {}), number);
  }
  if(file.bad())
    reject_file(file_name, "cannot be read");
}

// Reads the file of an option for an index below a number. `what` and `counted` name in messages what it is the index
// of, and how many of them there are.
std::size_t index_of(const std::string& word, std::size_t end, const std::string& what, const std::string& counted,
                     const std::string& file_name, std::size_t line)
{
  std::size_t i = 0;
  if(!parse_index(word, i))
    reject_line(file_name, line, "'" + word + "' is not the index of a " + what);
  if(i >= end)
    reject_line(file_name, line, "there is no " + what + " " + word + ", but " + counted + ", counted from 0");
  return i;
}

std::vector<Mesh::Edge_index> walls(const Arguments& arguments, const Mesh& mesh)
{
  std::vector<Mesh::Edge_index> edges;
  if(!has(arguments, "walls"))
    return edges;
  const std::string& file_name = arguments["walls"].as<std::string>();
  for_each_line(file_name, [&](const std::vector<std::string>& words, std::size_t number)
  {
    if(words.empty())
      return;
    if(words.size() != 2)
      reject_line(file_name, number, "an edge is given by two vertices");
    std::array<Vertex, 2> end;
    for(std::size_t i = 0; i < 2; ++i)
      end[i] = Vertex(static_cast<Mesh::size_type>(
        index_of(words[i], mesh.number_of_vertices(), "vertex", counted_vertices(mesh.number_of_vertices()), file_name,
                 number)));
    const Mesh::Halfedge_index h = mesh.halfedge(end[0], end[1]);
    if(h == Mesh::null_halfedge())
      reject_line(file_name, number, "no edge joins the vertices " + words[0] + " and " + words[1]);
    edges.push_back(mesh.edge(h));
  });
  return edges;
}

} // namespace

std::vector<Face> avoided_faces(const Arguments& arguments, const Mesh& mesh)
{
  std::vector<Face> faces = marked_faces(mesh);
  if(!has(arguments, "avoid") || has_file_of_marks(arguments))
    return faces;
  const std::string& file_name = arguments["avoid"].as<std::string>();
  const std::vector<Polygon_soup::Index> face_of_file = faces_of_file(mesh);
  const std::size_t end = *std::max_element(face_of_file.begin(), face_of_file.end()) + std::size_t(1);
  std::vector<char> is_listed(end, 0);
  for_each_line(file_name, [&](const std::vector<std::string>& words, std::size_t number)
  {
    for(const std::string& word : words)
      is_listed[index_of(word, end, "face", counted_faces(end), file_name, number)] = 1;
  });
  std::copy_if(mesh.faces().begin(), mesh.faces().end(), std::back_inserter(faces),
               [&](Face f) { return is_listed[face_of_file[f.idx()]] != 0; });
  return faces;
}

Obstacles obstacles(const Arguments& arguments, const Mesh& mesh)
{
  return {avoided_faces(arguments, mesh), walls(arguments, mesh)};
}

bool has_obstacles(const Arguments& arguments)
{
  return has(arguments, "avoid") || are_faces_marked(arguments) || has(arguments, "walls");
}

std::vector<char> flags_of_faces(const Mesh& mesh, const std::vector<Face>& faces)
{
  std::vector<char> flags(faces.empty() ? 0 : mesh.number_of_faces(), 0);
  for(const Face f : faces)
    flags[f] = 1;
  return flags;
}

} // namespace geodesics_demo
