#ifndef SURFACE_MESH_GEODESICS_DEMO_OBJ_INDICES_H
#define SURFACE_MESH_GEODESICS_DEMO_OBJ_INDICES_H

#include "Text_scanner.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace geodesics_demo {

// The indices of vertices in the faces and lines of an OBJ file. A statement may precede its vertices, so the largest
// index is checked at the end.
class OBJ_indices
{
public:
  // Reads V, V/T, V//N or V/T/N. Indices count from 1, negative ones from the last vertex back. Returns the index
  // counted from 0. `what` says what the word should be: "a corner of a face, such as 7, 7/7 or 7/7/7".
  std::size_t read(Text_scanner& in, std::size_t number_of_vertices, const char* what);

  // Throws a Command_error with the line if an index is larger than the number of vertices in the whole file.
  void check_largest(const std::string& file_name, std::size_t number_of_vertices) const;

private:
  std::int64_t m_largest = 0;
  std::uint32_t m_line_of_largest = 0;
};

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_OBJ_INDICES_H
