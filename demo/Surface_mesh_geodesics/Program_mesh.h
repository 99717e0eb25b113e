#ifndef SURFACE_MESH_GEODESICS_APP_PROGRAM_MESH_H
#define SURFACE_MESH_GEODESICS_APP_PROGRAM_MESH_H

#include "Console.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace geodesics_app {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Face_location = std::pair<Face, std::array<double, 3>>; // with barycentric coordinates

// Reads a surface in any format that CGAL reads, and cuts faces with more than three edges into triangles. Vertices and
// faces keep the numbers that they have in the file (faces as long as all are triangles). A Command_error tells what is
// wrong with a file that does not hold a surface.
Mesh read_mesh(const std::string& file_name, const Console& console);

// "1 face", "2 faces", and so on.
std::string counted_faces(std::size_t n);

// the length of the diagonal of the bounding box.
double extent(const Mesh& mesh);

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_PROGRAM_MESH_H
