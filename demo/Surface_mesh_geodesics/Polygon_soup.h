#ifndef SURFACE_MESH_GEODESICS_DEMO_POLYGON_SOUP_H
#define SURFACE_MESH_GEODESICS_DEMO_POLYGON_SOUP_H

#include "Program_mesh.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace geodesics_demo {

// The contents of a file: points, and faces as indices of points. The readers check that the points exist; nothing
// else is checked yet. The corners of all faces are in one array: a vector for each face takes longer than reading it.
struct Polygon_soup
{
  using Index = std::uint32_t; // as in Surface_mesh

  std::vector<Point> points;
  std::vector<Index> corners;      // of all faces, one after the other
  std::vector<std::size_t> ends;   // of each face in `corners`
  std::vector<std::uint32_t> lines; // of each face in the file, counted from 1; empty for binary files
  std::vector<char> is_marked;     // of each face, by a property (Face_marks.h); empty if none was asked for

  std::size_t number_of_faces() const { return ends.size(); }
  std::size_t begin_of(std::size_t f) const { return f == 0 ? 0 : ends[f - 1]; }
  std::size_t size_of(std::size_t f) const { return ends[f] - begin_of(f); }

  void end_face() { ends.push_back(corners.size()); }
  void add_triangle(Index u, Index v, Index w)
  {
    corners.insert(corners.end(), {u, v, w});
    end_face();
  }

  // "face 7", or "face 7 (line 30)" for text.
  std::string name_of_face(std::size_t f) const
  {
    return "face " + std::to_string(f) + (lines.empty() ? "" : " (line " + std::to_string(lines[f]) + ")");
  }
};

// Reads a file in any of the formats. Throws a Command_error unless there are faces, and all points are finite. Faces
// are marked where their property with the name `mark` is not 0, and the file has to be a PLY file with this property;
// an empty name marks none.
Polygon_soup read_polygons(const std::string& file_name, const Console& console, const std::string& mark = "");

// The format that the name of a file tells: its ending, in lower case.
std::string format_by_name(const std::string& file_name);

// Connects the faces, and cuts those with more than three edges, as read_mesh() says. Messages name the file. Marked
// faces are marked in the mesh.
Mesh mesh_of_polygons(const std::string& file_name, const Polygon_soup& soup, const Console& console);

// The most points of a file: the indices of edges and halfedges in Surface_mesh have 32 bits.
constexpr std::int64_t most_points = 0x7fffffff;

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_POLYGON_SOUP_H
