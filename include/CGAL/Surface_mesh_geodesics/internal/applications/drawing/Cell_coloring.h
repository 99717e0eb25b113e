// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_CELL_COLORING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_CELL_COLORING_H

// Colors for the cells of a diagram: neighbors get different ones, and all are used about equally often. The coloring
// itself knows cells by their numbers and neighbors only.
//
// cell_colors() is for the public function and for the writers. It asks the diagram for neighbors; coloring_order() and
// coloring() do the rest.

#include <CGAL/IO/Color.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Twelve colors that differ as much as possible, also for eyes that confuse red with green, or yellow with blue. The
// first seven are those of Okabe and Ito (Color universal design, 2008) without black.
inline const std::array<IO::Color, 12>& colors_of_cells()
{
  static const std::array<IO::Color, 12> colors{
    {IO::Color(230, 159, 0), IO::Color(86, 180, 233), IO::Color(0, 158, 115), IO::Color(240, 228, 66),
     IO::Color(0, 114, 178), IO::Color(213, 94, 0), IO::Color(204, 121, 167), IO::Color(0, 0, 240),
     IO::Color(150, 0, 60), IO::Color(150, 240, 240), IO::Color(120, 0, 150), IO::Color(150, 120, 240)}};
  return colors;
}

// The numbers of the neighbors of each cell, which is the number of its site. The relation is symmetric, each neighbor
// is named once, and no cell is its own neighbor. A cell that is empty has none.
using Neighbors_of_cells = std::vector<std::vector<std::size_t>>;

// The cells in the order in which they are colored, the smallest-last order of Matula and Beck (1983): removes a cell
// with the fewest remaining neighbors again and again, and reverses the order of removal. Then few neighbors precede a
// cell: at most five on a surface without handles, as a planar graph has a vertex with five neighbors or fewer. In a
// tie, the cell with the smallest number is removed first.
//
// On a surface with g handles, n connected cells have at most 6 + 12 (g - 1) / n neighbors on average. For g = 6 that
// is less than 11 if n > 12, and fewer cells have no more than 11 neighbors anyway. So at most eleven neighbors precede
// a cell on surfaces with up to six handles, and twelve colors are enough.
//
// Takes O(k log n) time for n cells and k pairs of neighbors.
inline std::vector<std::size_t> coloring_order(const Neighbors_of_cells& neighbors)
{
  std::set<std::pair<std::size_t, std::size_t>> remaining; // the number of remaining neighbors, and the cell
  std::vector<std::size_t> number_remaining;
  for(std::size_t i = 0; i < neighbors.size(); ++i)
  {
    number_remaining.push_back(neighbors[i].size());
    remaining.emplace(number_remaining[i], i);
  }
  std::vector<std::size_t> order;
  while(!remaining.empty())
  {
    const std::size_t i = remaining.begin()->second;
    remaining.erase(remaining.begin());
    order.push_back(i);
    for(const std::size_t j : neighbors[i])
      // A neighbor that has been removed is not found, and does not change.
      if(remaining.erase({number_remaining[j], j}) == 1)
        remaining.emplace(--number_remaining[j], j);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

// The number of a color for each cell. Each cell takes a color that the fewest of its colored neighbors have, which is
// none of them if there are enough colors; among these the one that is used least; among these the first.
// Requires: number_of_colors > 0. Takes O(k + n c) time for n cells, k pairs of neighbors and c colors.
inline std::vector<std::size_t> coloring(const Neighbors_of_cells& neighbors, std::size_t number_of_colors)
{
  CGAL_assertion(number_of_colors > 0);
  const std::size_t no_color = number_of_colors;
  std::vector<std::size_t> color(neighbors.size(), no_color), number_of_uses(number_of_colors, 0);
  for(const std::size_t i : coloring_order(neighbors))
  {
    std::vector<std::size_t> number_of_conflicts(number_of_colors, 0);
    for(const std::size_t j : neighbors[i])
      if(color[j] != no_color)
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

// The colors of all cells of a diagram, by the numbers of their sites. Builds the diagram if that is not done. Empty
// cells get a color, too.
template <typename Diagram>
std::vector<IO::Color> cell_colors(const Diagram& diagram)
{
  Neighbors_of_cells neighbors;
  for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
    neighbors.push_back(diagram.adjacent_sites(i));
  std::vector<IO::Color> result;
  for(const std::size_t c : coloring(neighbors, colors_of_cells().size()))
    result.push_back(colors_of_cells()[c]);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DRAWING_CELL_COLORING_H
