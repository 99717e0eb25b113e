#ifndef SURFACE_MESH_GEODESICS_DEMO_LOCATION_TABLE_H
#define SURFACE_MESH_GEODESICS_DEMO_LOCATION_TABLE_H

#include <cstddef>
#include <string>
#include <vector>

namespace geodesics_demo {

// Finds the locations in the lines of a file: plain lines of numbers, or a table with the names of its columns in the
// first line, such as the subcommand `sample` writes. In a table, a row stands for its vertex (the column ROLE_vertex
// or vertex), or for a point of a face (face, b0, b1, b2, with or without the role), or for a point (x, y, z).
class Location_table
{
public:
  explicit Location_table(const std::string& role) : m_role(role) {}

  // The numbers that stand for a location: one, three or four of them, as in a plain file. Empty for a line without a
  // location: a comment, or the names of the columns. `where` begins messages.
  std::vector<std::string> words_of(const std::string& line, const std::string& where);

  // The cell of that line in the column `weight`; empty if there is none.
  const std::string& weight() const { return m_weight; }

private:
  bool read_names(const std::string& line, const std::string& where);
  std::vector<std::size_t> columns_with(const std::vector<std::string>& cells,
                                        const std::vector<std::string>& names) const;

  std::string m_role, m_weight;
  bool m_is_first = true, m_is_table = false;
  std::vector<std::vector<std::size_t>> m_choices; // columns of a vertex, of a face location, of a point
  std::vector<std::size_t> m_column_of_weight;            // none or one
};

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_LOCATION_TABLE_H
