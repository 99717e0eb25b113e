// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors


#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_CELL_COLORS_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_CELL_COLORS_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/IO/Color.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

namespace internal {

// Twelve colors that are as far apart as can be, also for eyes that do not tell red from green, or yellow from blue.
inline const std::array<IO::Color, 12>& colors_of_cells()
{
  static const std::array<IO::Color, 12> colors{
    {IO::Color(230, 159, 0), IO::Color(86, 180, 233), IO::Color(0, 158, 115), IO::Color(240, 228, 66),
     IO::Color(0, 114, 178), IO::Color(213, 94, 0), IO::Color(204, 121, 167), IO::Color(0, 0, 240),
     IO::Color(150, 0, 60), IO::Color(150, 240, 240), IO::Color(120, 0, 150), IO::Color(150, 120, 240)}};
  return colors;
}

using Neighbors_of_cells = std::vector<std::vector<std::size_t>>;

// Takes away, again and again, a cell with the fewest neighbours that are left; the order in which they go, from the
// last one on. A cell has few neighbours before it then: at most five where the surface has no handles.
inline std::vector<std::size_t> coloring_order(const Neighbors_of_cells& neighbors)
{
  std::set<std::pair<std::size_t, std::size_t>> left; // the number of neighbors that are left, and the cell
  std::vector<std::size_t> number_left;
  for(std::size_t i = 0; i < neighbors.size(); ++i)
  {
    number_left.push_back(neighbors[i].size());
    left.emplace(number_left[i], i);
  }
  std::vector<std::size_t> order;
  while(!left.empty())
  {
    const std::size_t i = left.begin()->second;
    left.erase(left.begin());
    order.push_back(i);
    for(const std::size_t j : neighbors[i])
      if(left.erase({number_left[j], j}) == 1)
        left.emplace(--number_left[j], j);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

// For each cell the number of a color: of those that no neighbor has, one that has been used least.
inline std::vector<std::size_t> coloring(const Neighbors_of_cells& neighbors, std::size_t number_of_colors)
{
  const std::size_t none = number_of_colors;
  std::vector<std::size_t> color(neighbors.size(), none), number_of_uses(number_of_colors, 0);
  for(const std::size_t i : coloring_order(neighbors))
  {
    std::vector<std::size_t> number_of_conflicts(number_of_colors, 0);
    for(const std::size_t j : neighbors[i])
      if(color[j] != none)
        ++number_of_conflicts[color[j]];
    const auto is_better = [&](std::size_t c, std::size_t d)
    {
      return std::make_pair(number_of_conflicts[c], number_of_uses[c])
           < std::make_pair(number_of_conflicts[d], number_of_uses[d]);
    };
    color[i] = 0;
    for(std::size_t c = 1; c < number_of_colors; ++c)
      if(is_better(c, color[i]))
        color[i] = c;
    ++number_of_uses[color[i]];
  }
  return color;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

returns a color for the cell of each site of a geodesic Voronoi diagram, for pictures. There are twelve colors, which
eyes that do not tell red from green, or yellow from blue, tell apart as well. Cells with a common edge have different
colors on every orientable surface with up to six handles, and cells share a color only if there are more than twelve.
The colors do not depend on anything but the numbers of the sites and which cells are neighbors.

Takes \cgalBigO{k \log n} time for \f$ n \f$ sites and \f$ k \f$ pairs of neighbors, besides building the diagram. The
function may be called by several threads at once, on the same diagram as well.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param diagram the diagram, which is computed if that has not been done

\return the colors, by the numbers of the sites; also for those with an empty cell

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid

\sa `write_geodesic_Voronoi_diagram_PLY()`
*/
template <typename Diagram>
std::vector<IO::Color> geodesic_Voronoi_cell_colors(const Diagram& diagram)
{
  internal::Neighbors_of_cells neighbors;
  for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
    neighbors.push_back(diagram.adjacent_sites(i));
  std::vector<IO::Color> result;
  for(const std::size_t c : internal::coloring(neighbors, internal::colors_of_cells().size()))
    result.push_back(internal::colors_of_cells()[c]);
  return result;
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_CELL_COLORS_H
