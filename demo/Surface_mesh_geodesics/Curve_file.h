#ifndef SURFACE_MESH_GEODESICS_DEMO_CURVE_FILE_H
#define SURFACE_MESH_GEODESICS_DEMO_CURVE_FILE_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace geodesics_demo {

// A polyline in space, as a file has it. A closed one does not repeat its first point at the end.
struct Polyline
{
  std::vector<std::array<double, 3>> points; // at least one
  std::vector<std::size_t> lines;            // of each point in the file, counted from 1
  bool is_closed = false;
};

// Reads the polylines of a file: the statements v and l of a file .obj, or a file .polylines.txt of CGAL, whose lines
// have a number of points and the points. A polyline is closed if it ends at its first point. Throws a Command_error,
// with the line where the file is wrong, or if it has no polyline.
std::vector<Polyline> read_polylines(const std::string& file_name);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_CURVE_FILE_H
