#ifndef SURFACE_MESH_GEODESICS_DEMO_DRAWING_H
#define SURFACE_MESH_GEODESICS_DEMO_DRAWING_H

#include "Color_ramp.h"
#include "Program_mesh.h"

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace geodesics_demo {

// A number for each point or each line of a drawing.
struct Drawing_column
{
  std::string name;
  bool is_integer;
  std::vector<double> values;
};

// The contents of files for viewers: points, triangles and polylines, with colors and numbers.
struct Drawing
{
  std::vector<Point> points;
  std::vector<Color> colors; // one for each point, or none
  std::vector<Drawing_column> point_columns;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::vector<std::size_t>> lines;
  std::vector<Drawing_column> line_columns;

  // Adds all vertices and faces. Call it first, so that vertices keep their indices.
  void add_mesh(const Mesh& mesh);

  // Adds a column `quality` to the points, the name under which MeshLab expects the numbers to show.
  void add_quality(const std::vector<double>& values);

  // Adds points and a line through them. The caller adds the columns.
  void add_line(const std::vector<Point>& line);
};

// Formats: "ply" (binary, with the elements vertex, face and edge), "vtk" (legacy, binary), "vtu" (XML, binary) and
// "obj" (with colors after the coordinates, as many programs read them, but without numbers). Infinite numbers are
// written as NaN: viewers show them in a color of their own, and do not count them as the smallest number.
void write_drawing(std::ostream& os, const std::string& format, const Drawing& drawing);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_DRAWING_H
