// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_COLUMNS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_COLUMNS_H

// A column for each member of strips, so that loops process several strips at a time (simd.h). Strips wait as they are,
// in lists, which are often short; those that cross a face together are moved to columns.

#include <CGAL/Surface_mesh_geodesics/internal/window/Vertex_rival.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A buffer of rows; row i of all columns together is strip i. There are three more columns for what a strip knows of
// the apex of its face. Loops read and write all lanes of their last step, so there are `padding` more rows than
// strips.
//
// Invariant: all rows hold numbers, whatever they mean.
template <typename FT>
class Strip_columns
{
public:
  static constexpr std::size_t padding = 8; // the largest number of lanes

  // Makes room for n strips. Of what the rows held before, the first `used` ones are kept. Requires: used <= n.
  void reserve(std::size_t n, std::size_t used)
  {
    if(n + padding <= m_height)
      return;
    Strip_columns larger;
    larger.m_height = 2 * n + padding;
    larger.m_numbers.assign(9 * larger.m_height, FT(0));
    larger.m_histories.assign(larger.m_height, 0);
    for(std::size_t i = 0; i < used; ++i)
      larger.set(i, get(i));
    *this = std::move(larger);
  }

  FT* begin() { return column(0); }
  FT* end() { return column(1); }
  FT* direction_x() { return column(2); }
  FT* direction_y() { return column(3); }
  FT* distance() { return column(4); }
  FT* foot() { return column(5); }
  FT* apex_crossing() { return column(6); } // where the ray through the apex crosses AB
  FT* apex_distance() { return column(7); } // the value of the linear function at the apex
  FT* path_to_apex() { return column(8); }  // the length of the shortest path (Ray_arrival::distance)
  std::uint64_t* history() { return m_histories.data(); } // the side, and the number of faces in the higher half

  static constexpr std::uint64_t one_face = std::uint64_t(1) << 32;

  Strip<FT> get(std::size_t i)
  {
    const std::uint64_t h = history()[i];
    return Strip<FT>{begin()[i], end()[i], direction_x()[i], direction_y()[i], distance()[i], foot()[i],
                     static_cast<std::uint32_t>(h), static_cast<std::uint32_t>(h / one_face)};
  }

  // Sets a strip. What it knows of the apex is not changed.
  void set(std::size_t i, const Strip<FT>& s)
  {
    begin()[i] = s.begin;
    end()[i] = s.end;
    direction_x()[i] = s.direction_x;
    direction_y()[i] = s.direction_y;
    distance()[i] = s.distance;
    foot()[i] = s.foot;
    history()[i] = s.side + s.faces_crossed * one_face;
  }

  // Copies a row with all that it holds.
  void copy_row(std::size_t from, std::size_t to)
  {
    set(to, get(from));
    apex_crossing()[to] = apex_crossing()[from];
    apex_distance()[to] = apex_distance()[from];
    path_to_apex()[to] = path_to_apex()[from];
  }

  std::size_t memory() const { return m_height * (9 * sizeof(FT) + sizeof(std::uint64_t)); }

private:
  FT* column(std::size_t k) { return m_numbers.data() + k * m_height; }

  std::size_t m_height = 0;
  std::vector<FT> m_numbers; // one column behind the other
  std::vector<std::uint64_t> m_histories;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_COLUMNS_H
