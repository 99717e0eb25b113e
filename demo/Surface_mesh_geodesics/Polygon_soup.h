#ifndef SURFACE_MESH_GEODESICS_APP_POLYGON_SOUP_H
#define SURFACE_MESH_GEODESICS_APP_POLYGON_SOUP_H

#include "Program_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace geodesics_app {

// What is in a file: points, and faces by the numbers of their points. Nothing is checked yet.
struct Polygon_soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
};

// reads an OFF file; false if it is damaged. (CGAL's own reader makes room for as many points and corners as the file
// promises; here there is never more memory than what has been read needs.)
bool read_OFF(const std::string& file_name, Polygon_soup& soup);

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_POLYGON_SOUP_H
