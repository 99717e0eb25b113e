// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_LIST_LOOPS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_LIST_LOOPS_H

// The loops over the strips that cross a face together, as a table of functions for one number of lanes, and which
// table is used (Window_list_loops.h does the same for windows). lanes/Strip_loops.h has their text.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Vertex_rival.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_loops.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/simd.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip_columns.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The strips that are left of those that cross AB.
template <typename FT>
struct Entered_strips
{
  std::size_t number;
  FT shortest_path_to_apex; // infinity if there are none
};

// One of the edges AC and CB, and which rays go there.
template <typename FT>
struct Strip_side
{
  FT length;
  Side_angle<FT> angle;         // with AB
  Vertex_rival<FT> left, right; // its ends, as seen from the face
  FT edge_length;               // of AB
  // Rays on the other side of the point S of AB, at the abscissa `cut`, do not go there if D(C) > known for their
  // strip.
  FT cut, known;
  FT maximum_distance; // strips that are farther away are dropped
};

// The children of strips beyond a side.
template <typename FT>
struct Strip_children
{
  std::size_t number;
  FT least_distance; // infinity if there are none
};

template <typename FT>
struct Strip_list_loops
{
  // Trims n strips by A and B, removes those that nothing is left of, and finds what each one knows of the apex. The
  // others keep their order.
  Entered_strips<FT> (*enter)(Strip_columns<FT>& strips, std::size_t n, const Face_frame<FT>& c,
                              const Vertex_rival<FT>& a, const Vertex_rival<FT>& b);

  // Writes the children of n strips beyond AC, or beyond CB, to the rows of `children` from 0 on. Slivers have none.
  // Requires: `children` has room for n strips.
  Strip_children<FT> (*cross_left)(Strip_columns<FT>& strips, std::size_t n, const Strip_side<FT>& side,
                                   Strip_columns<FT>& children);
  Strip_children<FT> (*cross_right)(Strip_columns<FT>& strips, std::size_t n, const Strip_side<FT>& side,
                                    Strip_columns<FT>& children);
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#define CGAL_SURFACE_MESH_GEODESICS_LANES_TEXT <CGAL/Surface_mesh_geodesics/internal/window/lanes/Strip_loops.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/every_number.h>
#undef CGAL_SURFACE_MESH_GEODESICS_LANES_TEXT

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The loops over strips of a choice.
template <typename FT>
Strip_list_loops<FT> strip_list_loops(Lane_choice choice = Lane_choice::BEST)
{
  if constexpr(std::is_same<FT, double>::value)
    switch(number_of_lanes(choice))
    {
#if CGAL_SURFACE_MESH_GEODESICS_MOST_LANES > 2
    case 8:
      return avx512_lanes::Strip_loops<FT>::table();
    case 4:
      return avx2_lanes::Strip_loops<FT>::table();
#endif
#if CGAL_SURFACE_MESH_GEODESICS_MOST_LANES > 1
    case 2:
      return two_lanes::Strip_loops<FT>::table();
#endif
    default:
      break;
    }
  static_cast<void>(choice);
  return one_lane::Strip_loops<FT>::table();
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_LIST_LOOPS_H
