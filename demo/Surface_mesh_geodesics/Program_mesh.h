#ifndef SURFACE_MESH_GEODESICS_DEMO_PROGRAM_MESH_H
#define SURFACE_MESH_GEODESICS_DEMO_PROGRAM_MESH_H

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

// Reads a surface in any format that CGAL reads, and cuts faces with more than three edges into triangles. Vertices
// keep the indices of the file; so do faces if all of them are triangles. Throws a Command_error with the reason if the
// file is not a surface.
Mesh read_mesh(const std::string& file_name, const Console& console);

// "1 face", "2 faces", and so on.
std::string counted_faces(std::size_t n);

// The length of the diagonal of the bounding box.
double extent(const Mesh& mesh);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_PROGRAM_MESH_H
