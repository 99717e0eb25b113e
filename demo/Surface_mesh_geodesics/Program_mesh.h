#ifndef SURFACE_MESH_GEODESICS_DEMO_PROGRAM_MESH_H
#define SURFACE_MESH_GEODESICS_DEMO_PROGRAM_MESH_H

#include "Command.h"
#include "Console.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace geodesics_demo {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Face_location = std::pair<Face, std::array<double, 3>>; // with barycentric coordinates

// Reads the surface of a command from a file, or from the standard input if the name is `-`, and cuts faces with more
// than three edges into triangles. The option --repair mends what is not a surface. Vertices keep the indices of the
// file unless --repair changes them; so do faces if all of them are triangles. Throws a Command_error with the reason
// if the file is not a surface.
Mesh read_mesh(const Arguments& arguments, const Console& console);

// The same for the file with this name, without --repair.
Mesh read_mesh(const std::string& file_name, const Console& console);

// The option --repair, which all commands have.
void declare_repair(Option_descriptions& options);

// "1 face", "2 faces"; "1 vertex", "2 vertices".
std::string counted_vertices(std::size_t n);

std::string counted_faces(std::size_t n);

// The length of the diagonal of the bounding box.
double diagonal(const Mesh& mesh);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_PROGRAM_MESH_H
