#include "Program_mesh.h"

#include "Command_error.h"
#include "Input_file.h"
#include "PLY_check.h"
#include "Polygon_soup.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <system_error>
#include <vector>

namespace geodesics_demo {

namespace {

[[noreturn]] void complain(const std::string& file_name, const std::string& what)
{
  throw Command_error(Exit_code::BAD_INPUT, file_name + ": " + what);
}

// The ending of a name, in lower case.
std::string ending_of(const std::string& file_name)
{
  std::string ending = std::filesystem::path(file_name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return ending;
}

// Readers report failure without a reason. These checks name the reasons that can be found beforehand.
void check_file(const std::string& file_name)
{
  namespace fs = std::filesystem;
  check_is_readable(file_name);
  std::error_code error;
  if(fs::is_regular_file(file_name, error) && fs::file_size(file_name, error) == 0)
    complain(file_name, "the file is empty");
  const std::string ending = ending_of(file_name);
  static const std::vector<std::string> known{".off", ".obj", ".ply", ".stl", ".ts"};
  if(std::find(known.begin(), known.end(), ending) == known.end())
    complain(file_name, "the name must end with one of .off, .obj, .ply, .stl, .ts");
}

Polygon_soup read_soup(const std::string& file_name)
{
  Polygon_soup soup;
  bool is_read = false;
  try
  {
    const std::string ending = ending_of(file_name);
    if(ending == ".off")
      is_read = read_OFF(file_name, soup);
    else
      is_read = (ending != ".ply" || may_read_PLY(file_name))
             && CGAL::IO::read_polygon_soup(file_name, soup.points, soup.faces);
  }
  catch(const std::bad_alloc&)
  {
    throw;
  }
  catch(const std::exception&) // some readers throw for invalid numbers
  {}
  if(!is_read)
    complain(file_name, "the file is damaged, incomplete, or not in the format of its name");
  if(soup.faces.empty())
    complain(file_name, "the file contains no faces");
  return soup;
}

void check_points(const std::string& file_name, const Polygon_soup& soup)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v)
  {
    const Point& p = soup.points[v];
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      complain(file_name, "a coordinate of vertex " + std::to_string(v) + " is not a finite number");
  }
}

void check_face(const std::string& file_name, const Polygon_soup& soup, std::size_t f)
{
  const std::string face = "face " + std::to_string(f);
  std::vector<std::size_t> polygon = soup.faces[f];
  if(polygon.size() < 3)
    complain(file_name, face + " has fewer than three vertices");
  std::sort(polygon.begin(), polygon.end());
  if(polygon.back() >= soup.points.size())
    complain(file_name, face + " has the vertex " + std::to_string(polygon.back()) + ", but there are only "
                          + std::to_string(soup.points.size()) + " vertices");
  if(std::adjacent_find(polygon.begin(), polygon.end()) != polygon.end())
    complain(file_name, face + " has a vertex twice");
}

Mesh connect(const std::string& file_name, const Polygon_soup& soup)
{
  Mesh mesh;
  mesh.reserve(static_cast<Mesh::size_type>(soup.points.size()), static_cast<Mesh::size_type>(3 * soup.faces.size()),
               static_cast<Mesh::size_type>(soup.faces.size()));
  for(const Point& p : soup.points)
    mesh.add_vertex(p);
  std::vector<Vertex> corners;
  for(std::size_t f = 0; f < soup.faces.size(); ++f)
  {
    check_face(file_name, soup, f);
    corners.clear();
    for(const std::size_t v : soup.faces[f])
      corners.push_back(Vertex(static_cast<Mesh::size_type>(v)));
    const Face face = mesh.add_face(corners);
    if(face == Mesh::null_face())
      complain(file_name, "face " + std::to_string(f)
                            + " does not fit the faces before it: an edge has more than two faces, or two faces of "
                              "opposite orientation, or too many parts of the surface meet at a vertex");
    // Barycentric coordinates belong to the corners in the order of the file.
    while(mesh.source(mesh.halfedge(face)) != corners[0])
      mesh.set_halfedge(face, mesh.next(mesh.halfedge(face)));
  }
  return mesh;
}

void triangulate(const std::string& file_name, Mesh& mesh, const Console& console)
{
  if(CGAL::is_triangle_mesh(mesh))
    return;
  const std::size_t before = mesh.number_of_faces();
  if(!CGAL::Polygon_mesh_processing::triangulate_faces(mesh) || !CGAL::is_triangle_mesh(mesh))
    complain(file_name, "a face with more than three edges cannot be cut into triangles");
  if(mesh.has_garbage())
    mesh.collect_garbage();
  console.note(file_name + ": not all faces are triangles; cut " + counted_faces(before) + " into "
               + std::to_string(mesh.number_of_faces()) + " triangles");
}

} // namespace

std::string counted_faces(std::size_t n)
{
  return std::to_string(n) + (n == 1 ? " face" : " faces");
}

Mesh read_mesh(const std::string& file_name, const Console& console)
{
  check_file(file_name);
  const Polygon_soup soup = read_soup(file_name);
  check_points(file_name, soup);
  Mesh mesh = connect(file_name, soup);
  triangulate(file_name, mesh, console);
  return mesh;
}

double extent(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

} // namespace geodesics_demo
