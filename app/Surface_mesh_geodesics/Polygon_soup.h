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

// Files may be damaged. CGAL's readers of OFF and of PLY take the numbers in a file for granted, make room for as many
// points or corners as they tell, and write to nowhere; what follows does not.

// reads an OFF file; false if it is damaged. There is never more memory than what has been read needs.
bool read_OFF(const std::string& file_name, Polygon_soup& soup);

// does each property in the header of a PLY file follow an element? Others are no concern here.
bool is_PLY_header_in_order(const std::string& file_name);

} // namespace geodesics_app

#endif // SURFACE_MESH_GEODESICS_APP_POLYGON_SOUP_H
