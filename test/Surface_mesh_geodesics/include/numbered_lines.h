#ifndef SURFACE_MESH_GEODESICS_NUMBERED_LINES_H
#define SURFACE_MESH_GEODESICS_NUMBERED_LINES_H

// Isolines as geodesic_isolines() writes them: a polyline with the number of its level. The class for paths traces the
// same lines, for comparison.

#include "test_meshes.h"
#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace numbered_lines {

using Line = std::vector<test_meshes::Mesh::Point>;
using Numbered_lines = std::vector<std::pair<std::size_t, Line>>;

inline bool is_closed(const Line& line) { return line.size() > 2 && line.front() == line.back(); }

template <typename Paths>
Numbered_lines lines_of_class(const Paths& paths, const std::vector<double>& levels)
{
  Numbered_lines result;
  for(std::size_t i = 0; i < levels.size(); ++i)
  {
    std::vector<Line> lines;
    paths.isolines(levels[i], std::back_inserter(lines));
    for(const Line& line : lines)
      result.emplace_back(i, line);
  }
  return result;
}

// Lines come in the same order, and each begins at the same point.
inline void check_same_lines(const Numbered_lines& lines, const Numbered_lines& expected, double tolerance)
{
  CHECK_EQUAL(lines.size(), expected.size());
  for(std::size_t i = 0; i < (std::min)(lines.size(), expected.size()); ++i)
  {
    const Line &line = lines[i].second, &other = expected[i].second;
    CHECK_EQUAL(lines[i].first, expected[i].first);
    CHECK_EQUAL(is_closed(line), is_closed(other));
    CHECK_EQUAL(line.size(), other.size());
    for(std::size_t k = 0; k < (std::min)(line.size(), other.size()); ++k)
      CHECK_NEAR(std::sqrt(CGAL::squared_distance(line[k], other[k])), 0., tolerance);
  }
}

} // namespace numbered_lines

#endif // SURFACE_MESH_GEODESICS_NUMBERED_LINES_H
