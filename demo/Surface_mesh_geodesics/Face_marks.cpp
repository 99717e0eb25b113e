#include "Face_marks.h"

#include "Command_error.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

namespace geodesics_demo {

namespace {

namespace Processing = CGAL::Polygon_mesh_processing;

using Marks = Mesh::Property_map<Face, char>;
using Faces_of_file = Mesh::Property_map<Face, Polygon_soup::Index>;

const char* const name_of_marks = "f:marked";
const char* const name_of_faces_of_file = "f:face_of_file"; // of meshes whose faces were cut

// Tells the triangles of a face its index in the file. CGAL copies its visitors, so this one keeps the index elsewhere.
struct Numbering_visitor
  : public Processing::Triangulate_faces::Default_visitor<Mesh>
{
  Numbering_visitor(const Faces_of_file& faces, Polygon_soup::Index& face_of_whole)
    : faces_of_file(faces), face(&face_of_whole)
  {}

  void before_subface_creations(Face f) { *face = faces_of_file[f]; }
  void after_subface_created(Face f) { faces_of_file[f] = *face; }

  Faces_of_file faces_of_file;
  Polygon_soup::Index* face;
};

// The files must have the same faces, in the same order: a mark that moves to another face would be a silent error.
void check_same_faces(const std::string& mesh_name, const Polygon_soup& mesh, const std::string& marks_name,
                      const Polygon_soup& marks)
{
  if(marks.number_of_faces() != mesh.number_of_faces())
    reject_file(marks_name, "the file has " + counted_faces(marks.number_of_faces()) + ", but " + mesh_name + " has "
                              + std::to_string(mesh.number_of_faces()));
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    if(marks.ends[f] != mesh.ends[f]
       || !std::equal(mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.begin_of(f)),
                      mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.ends[f]),
                      marks.corners.begin() + static_cast<std::ptrdiff_t>(marks.begin_of(f))))
      reject_file(marks_name, marks.name_of_face(f) + " has other vertices than in " + mesh_name);
}

} // namespace

void declare_face_marks(Option_descriptions& options)
{
  options.add_options()
    ("avoid-property", boost::program_options::value<std::string>()->value_name("NAME"),
     "avoid the faces where a property of this name is not 0: one of the mesh, which is a .ply then, or of the file of "
     "--avoid if that is a .ply with the same faces");
}

bool are_faces_marked(const Arguments& arguments)
{
  return has(arguments, "avoid-property");
}

bool has_file_of_marks(const Arguments& arguments)
{
  return has(arguments, "avoid") && format_by_name(arguments["avoid"].as<std::string>()) == ".ply";
}

Polygon_soup read_marked_polygons(const Arguments& arguments, const Console& console)
{
  const std::string mesh_name = mesh_argument(arguments);
  if(!are_faces_marked(arguments))
  {
    if(has_file_of_marks(arguments))
      throw Command_error(Exit_code::BAD_USAGE, "--avoid " + arguments["avoid"].as<std::string>()
                                                  + ": --avoid-property has to name a property of the faces");
    return read_polygons(mesh_name, console);
  }
  const std::string property = arguments["avoid-property"].as<std::string>();
  if(property.empty())
    throw Command_error(Exit_code::BAD_USAGE, "--avoid-property needs the name of a property");
  if(!has_file_of_marks(arguments))
    return read_polygons(mesh_name, console, property);
  const std::string marks_name = arguments["avoid"].as<std::string>();
  Polygon_soup soup = read_polygons(mesh_name, console), marks = read_polygons(marks_name, console, property);
  check_same_faces(mesh_name, soup, marks_name, marks);
  soup.is_marked = std::move(marks.is_marked);
  return soup;
}

void give_marks(const Polygon_soup& soup, Mesh& mesh)
{
  if(soup.is_marked.empty())
    return;
  const Marks marks = mesh.add_property_map<Face, char>(name_of_marks, 0).first;
  for(const Face f : mesh.faces())
    marks[f] = soup.is_marked[f];
}

bool cut_into_triangles(Mesh& mesh)
{
  const Faces_of_file faces = mesh.add_property_map<Face, Polygon_soup::Index>(name_of_faces_of_file, 0).first;
  for(const Face f : mesh.faces())
    faces[f] = f;
  const std::pair<Marks, bool> marks = mesh.property_map<Face, char>(name_of_marks);
  std::vector<char> marks_of_file;
  if(marks.second)
    for(const Face f : mesh.faces())
      marks_of_file.push_back(marks.first[f]);
  Polygon_soup::Index face = 0;
  if(!Processing::triangulate_faces(mesh, CGAL::parameters::visitor(Numbering_visitor(faces, face))))
    return false;
  if(marks.second)
    for(const Face f : mesh.faces())
      marks.first[f] = marks_of_file[faces[f]];
  return true;
}

std::vector<Polygon_soup::Index> faces_of_file(const Mesh& mesh)
{
  const std::pair<Faces_of_file, bool> faces = mesh.property_map<Face, Polygon_soup::Index>(name_of_faces_of_file);
  std::vector<Polygon_soup::Index> result;
  for(const Face f : mesh.faces())
    result.push_back(faces.second ? faces.first[f] : Polygon_soup::Index(f));
  return result;
}

std::vector<Face> marked_faces(const Mesh& mesh)
{
  std::vector<Face> faces;
  const std::pair<Marks, bool> marks = mesh.property_map<Face, char>(name_of_marks);
  if(marks.second)
    std::copy_if(mesh.faces().begin(), mesh.faces().end(), std::back_inserter(faces),
                 [&](Face f) { return marks.first[f] != 0; });
  return faces;
}

} // namespace geodesics_demo
