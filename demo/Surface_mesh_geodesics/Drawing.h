#ifndef SURFACE_MESH_GEODESICS_APP_DRAWING_H
#define SURFACE_MESH_GEODESICS_APP_DRAWING_H

#include "Color_ramp.h"
#include "Program_mesh.h"

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace geodesics_app {

// Numbers for the points or the lines of a drawing.
struct Drawing_column
{
  std::string name;
  bool is_integer;
  std::vector<double> values;
};

// What is written to files for viewers: points, triangles and polylines with colors and numbers.
struct Drawing
{
  std::vector<Point> points;
  std::vector<Color> colors; // one for each point, or none
  std::vector<Drawing_column> point_columns;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::vector<std::size_t>> lines;
  std::vector<Drawing_column> line_columns;

  // adds all vertices, so that they have the numbers of the mesh, and all faces. To be called first.
  void add_mesh(const Mesh& mesh);

  // adds points and a line through them. The columns are those of the caller.
  void add_line(const std::vector<Point>& line);
};

// Formats: "ply" (binary, with the elements vertex, face and edge), "vtk" (legacy, text) and "obj" (with colors behind
// the coordinates, as many programs read them, but without the numbers). A number that is not finite is -1.
void write_drawing(std::ostream& os, const std::string& format, const Drawing& drawing);

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_DRAWING_H
