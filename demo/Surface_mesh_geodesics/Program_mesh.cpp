#include "Program_mesh.h"

#include "Command_error.h"
#include "Face_marks.h"
#include "File_bytes.h"
#include "Input_file.h"
#include "Mesh_readers.h"
#include "Polygon_soup.h"
#include "Surface_builder.h"
#include "Surface_repair.h"
#include "Text_scanner.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <vector>

namespace geodesics_demo {

namespace {

// Throws unless the file can be read, and has one of the formats by its name.
void check_name(const std::string& file_name)
{
  if(file_name != "-")
    check_is_readable(file_name);
  const std::string ending = format_by_name(file_name);
  static const std::vector<std::string> known{".off", ".obj", ".ply", ".stl", ".ts"};
  if(file_name != "-" && std::find(known.begin(), known.end(), ending) == known.end())
    reject_file(file_name, "the name must end with one of .off, .obj, .ply, .stl, .ts");
}

// The first word that is not in a comment, as OFF and OBJ have them: from # to the end of the line.
std::string_view first_word(std::string_view text)
{
  for(;;)
  {
    text.remove_prefix((std::min)(text.find_first_not_of(" \t\r\n"), text.size()));
    if(text.empty() || text.front() != '#')
      return text.substr(0, text.find_first_of(" \t\r\n#"));
    text.remove_prefix((std::min)(text.find_first_of("\r\n"), text.size()));
  }
}

// The format of bytes without a name, by their first word: that of OBJ may be any.
std::string format_of(const std::string& file_name, std::string_view bytes)
{
  const std::string_view text = without_mark_of_byte_order(file_name, bytes), word = first_word(text);
  if(word == "ply")
    return ".ply";
  if(word == "GOCAD")
    return ".ts";
  if(word.size() >= 3 && (word.substr(word.size() - 3) == "OFF" || word == "SKEL"))
    return ".off";
  const bool is_binary = text.substr(0, 1000).find('\0') != std::string_view::npos;
  return is_binary || word == "solid" ? ".stl" : ".obj";
}

Polygon_soup read_soup(const std::string& file_name, const Console& console, const std::string& mark)
{
  const Work_sign sign(console, "reading");
  const std::string bytes = bytes_of(file_name);
  const std::string format = file_name == "-" ? format_of(file_name, bytes) : format_by_name(file_name);
  if(!mark.empty() && format != ".ply")
    reject_file(file_name, "this is not a PLY file, and only these have a property '" + mark + "' of faces");
  if(format == ".off")
    return read_OFF(file_name, bytes);
  if(format == ".obj")
    return read_OBJ(file_name, bytes, console);
  if(format == ".ply")
    return read_PLY(file_name, bytes, mark);
  return format == ".stl" ? read_STL(file_name, bytes) : read_TS(file_name, bytes);
}

void check_points(const std::string& file_name, const Polygon_soup& soup)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v)
  {
    const Point& p = soup.points[v];
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      reject_file(file_name, "a coordinate of vertex " + std::to_string(v) + " is not a finite number");
  }
}

void triangulate(const std::string& file_name, Mesh& mesh, const Console& console)
{
  if(CGAL::is_triangle_mesh(mesh))
    return;
  const std::size_t before = mesh.number_of_faces();
  if(!cut_into_triangles(mesh) || !CGAL::is_triangle_mesh(mesh))
    reject_file(file_name, "a face with more than three edges cannot be cut into triangles");
  if(mesh.has_garbage())
    mesh.collect_garbage();
  console.note(file_name + ": not all faces are triangles; cut " + counted_faces(before) + " into "
               + std::to_string(mesh.number_of_faces()) + " triangles");
}

} // namespace

std::string format_by_name(const std::string& file_name)
{
  std::string ending = std::filesystem::path(file_name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return ending;
}

std::string counted_faces(std::size_t n)
{
  return std::to_string(n) + (n == 1 ? " face" : " faces");
}

std::string counted_vertices(std::size_t n)
{
  return std::to_string(n) + (n == 1 ? " vertex" : " vertices");
}

void declare_repair(Option_descriptions& options)
{
  options.add_options()("repair",
                        "mend a mesh that is not a surface: merge vertices at one place, leave out degenerate and "
                        "repeated faces, orient the others, and split edges and vertices");
}

Polygon_soup read_polygons(const std::string& file_name, const Console& console, const std::string& mark)
{
  check_name(file_name);
  Polygon_soup soup = read_soup(file_name, console, mark);
  if(soup.ends.empty())
    reject_file(file_name, "the file contains no faces");
  check_points(file_name, soup);
  return soup;
}

Mesh mesh_of_polygons(const std::string& file_name, const Polygon_soup& soup, const Console& console)
{
  Mesh mesh = connected(file_name, soup);
  give_marks(soup, mesh);
  triangulate(file_name, mesh, console);
  return mesh;
}

Mesh read_mesh(const std::string& file_name, const Console& console)
{
  return mesh_of_polygons(file_name, read_polygons(file_name, console), console);
}

Mesh read_mesh(const Arguments& arguments, const Console& console)
{
  const std::string file_name = mesh_argument(arguments);
  Polygon_soup soup = read_marked_polygons(arguments, console);
  if(has(arguments, "repair"))
  {
    const Repair_report report = repair(soup);
    const std::string changes = report.text();
    console.note(file_name + ": " + (changes.empty() ? "there is nothing to repair"
                                                     : changes + "; vertices and faces may have new indices"));
    if(soup.ends.empty())
      reject_file(file_name, "the repaired mesh contains no faces");
    if(are_faces_marked(arguments) && report.repeated_faces > 0)
      reject_file(file_name, "--repair leaves out repeated faces, so that it is not known which copy of a face "
                             "--avoid-property means");
  }
  return mesh_of_polygons(file_name, soup, console);
}

double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

} // namespace geodesics_demo
