// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// Several windows of a list, one in each lane.
//
// Included once for each number of lanes; see README.md.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {
namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE {

// Several windows, one in each lane (see simd.h).
template <typename FT>
struct Window_lanes : Window_numbers<FT>
{
  typename Lanes<FT>::Word key, history;
};

// The windows of a block from row i on, as many as there are lanes. Requires: i is at most the capacity of the block;
// the rows of the padding may be read, and hold numbers.
template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
Window_lanes<FT> load_windows(const Window_columns<FT>& columns, std::size_t i)
{
  using L = Lanes<FT>;
  return Window_lanes<FT>{{L::load(columns.begin() + i), L::load(columns.end() + i), L::load(columns.image_x() + i),
                           L::load(columns.image_depth() + i), L::load(columns.begin_distance() + i),
                           L::load(columns.end_distance() + i), L::load(columns.root_distance() + i)},
                          L::load(columns.key() + i), L::load(columns.history() + i)};
}

// Writes all lanes, also those without a window, to the rows from i on. Requires: as for load_windows(), and the rows
// behind the windows are not in use.
template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
void store_windows(const Window_columns<FT>& columns, std::size_t i, const Window_lanes<FT>& w)
{
  using L = Lanes<FT>;
  L::store(columns.begin() + i, w.begin);
  L::store(columns.end() + i, w.end);
  L::store(columns.image_x() + i, w.image_x);
  L::store(columns.image_depth() + i, w.image_depth);
  L::store(columns.begin_distance() + i, w.begin_distance);
  L::store(columns.end_distance() + i, w.end_distance);
  L::store(columns.root_distance() + i, w.root_distance);
  L::store(columns.key() + i, w.key);
  L::store(columns.history() + i, w.history);
}

} // namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_LANES
