#ifndef SURFACE_MESH_GEODESICS_DEMO_POLYGON_SOUP_H
#define SURFACE_MESH_GEODESICS_DEMO_POLYGON_SOUP_H

#include "Program_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace geodesics_demo {

// The contents of a file: points, and faces as indices of points. Nothing is checked yet.
struct Polygon_soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
};

// Reads an OFF file; returns false if it is damaged. CGAL's own reader allocates as many points and corners as the file
// announces; this one never allocates more than what it has read.
bool read_OFF(const std::string& file_name, Polygon_soup& soup);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_POLYGON_SOUP_H
