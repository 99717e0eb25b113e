#ifndef SURFACE_MESH_GEODESICS_DEMO_LOCATION_COLUMNS_H
#define SURFACE_MESH_GEODESICS_DEMO_LOCATION_COLUMNS_H

#include "Location_options.h"

#include <cstddef>
#include <string>
#include <vector>

namespace geodesics_demo {

// The columns of a table that say which vertices its rows are about, so that a row can be traced without the command
// that made it. For the role "source" they are source_vertex and, if one of the locations is a point of a face,
// source_face, source_b0, source_b1 and source_b2 with its barycentric coordinates. Location files may be such tables.
class Location_columns
{
public:
  // `prefix` is the role and an underscore, or empty.
  Location_columns(const std::string& prefix, const std::vector<Location>& locations);

  // With a comma before each name: ",source_vertex".
  const std::string& names() const { return m_names; }

  // The cells of location i, with a comma before each; empty cells if there is no such location or it is nowhere.
  const std::string& cells(std::size_t i) const { return i < m_cells.size() ? m_cells[i] : m_empty_cells; }

private:
  std::string m_names, m_empty_cells;
  std::vector<std::string> m_cells;
};

// A location as in a location file: "7", or "12 0.5 0.25 0.25" for a point of a face.
std::string name_of(const Location& location);

// "vertex 7", or "the point 0.5 0.25 0.25 of face 12".
std::string description_of(const Location& location);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_LOCATION_COLUMNS_H
