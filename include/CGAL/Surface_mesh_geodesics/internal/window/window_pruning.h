// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_PRUNING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_PRUNING_H

// What makes a window, or a part of its interval, redundant: no shortest path runs through it, or one
// of the same length runs elsewhere. See the manual, Implementation Details, for the proofs.

#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A vertex as a rival of windows.
//
// A tie is left alone, unless windows start at the vertex in all directions: these carry all that goes
// on from a tie. It has to be decided there, because the neighbourhood of such a vertex may be so small
// that all distances tie, and no path would ever end.
template <typename FT>
struct Vertex_rival
{
  FT distance;
  FT factor; // of the distance of the window

  Vertex_rival(const FT& d, bool wins_ties)
    : distance(d),
      factor(wins_ties ? 1 + Tolerance<FT>::distance() : 1 - Tolerance<FT>::distance())
  {}

  // is the path through the vertex and along the edge to a point at distance l the shorter one?
  bool beats(const FT& l, const FT& window_distance) const { return distance + l < window_distance * factor; }
};

// Checking with vertices (thesis, case 12; Xin and Wang 2009): the path from the left end A of the
// edge, or from its right end, along the edge to the far end of the interval crosses every path of
// the window. If it is shorter there, it is shorter at each crossing.
template <typename FT>
bool is_beaten_by_vertices(const Window<FT>& w, const FT& length, const Vertex_rival<FT>& left,
                           const Vertex_rival<FT>& right)
{
  return left.beats(w.end, w.end_distance) || right.beats(length - w.begin, w.begin_distance);
}

enum class Pair_outcome { KEEP_BOTH, LEFT_IS_REDUNDANT, RIGHT_IS_REDUNDANT };

// Rule 3 of the pairs (thesis, cases 3 and 6): the window `left`, whose key is smaller, has its whole
// interval on the right of that of `right`. Then each path of one crosses each path of the other, and
// whichever is nearer at the crossing u of the two innermost ones is nearer at all.
template <typename FT>
Pair_outcome prune_crossed_windows(const Window<FT>& left, const Window<FT>& right)
{
  // Where the paths are at height -h: left.begin + h * left_slope and right.end + h * right_slope.
  const FT left_slope = (left.image_x - left.begin) / left.image_depth;
  const FT right_slope = (right.image_x - right.end) / right.image_depth;
  const FT approach = right_slope - left_slope;
  if(!(approach > 0)) // contradicts the order: rounding, so nothing is known
    return Pair_outcome::KEEP_BOTH;
  const FT h = (left.begin - right.end) / approach;
  const FT at_left = left.begin_distance
                   - (left.begin_distance - left.root_distance) * h / left.image_depth;
  const FT at_right = right.end_distance
                    - (right.end_distance - right.root_distance) * h / right.image_depth;
  if(is_clearly_less(at_left, at_right))
    return Pair_outcome::RIGHT_IS_REDUNDANT;
  if(is_clearly_less(at_right, at_left))
    return Pair_outcome::LEFT_IS_REDUNDANT;
  return Pair_outcome::KEEP_BOTH;
}

// The pair rules (thesis, 4.2.1, cases 1-6) for two windows of one edge, where the key of `left` is
// less than that of `right`. At a point K that both intervals hold, let `left` be nearer. A path of
// `right` that ends on the left of K crosses the path of `left` to K, and is not the shorter one
// there: that part of `right` is redundant. The mirror image holds if `right` is nearer. K is put at
// both ends of what the intervals share; intervals are trimmed, or removed where nothing is left.
// Two windows that still overlap afterwards have their point of equal distance inside.
template <typename FT>
Pair_outcome prune_pair(Window<FT>& left, Window<FT>& right)
{
  if(left.end <= right.begin)
    return Pair_outcome::KEEP_BOTH;
  if(right.end <= left.begin)
    return prune_crossed_windows(left, right);

  // the left end of the shared part
  {
    const bool starts_with_left = left.begin >= right.begin;
    const FT k = starts_with_left ? left.begin : right.begin;
    const FT of_left = starts_with_left ? left.begin_distance : left.distance_at(k);
    const FT of_right = starts_with_left ? right.distance_at(k) : right.begin_distance;
    if(is_clearly_less(of_right, of_left))
    {
      if(starts_with_left)
        return Pair_outcome::LEFT_IS_REDUNDANT;
      left.end = k;
      left.end_distance = of_left;
      return Pair_outcome::KEEP_BOTH;
    }
    if(starts_with_left && is_clearly_less(of_left, of_right))
    {
      right.begin = k;
      right.begin_distance = of_right;
    }
  }
  // the right end of the shared part
  const bool ends_with_right = right.end <= left.end;
  const FT k = ends_with_right ? right.end : left.end;
  const FT of_left = ends_with_right ? left.distance_at(k) : left.end_distance;
  const FT of_right = ends_with_right ? right.end_distance : right.distance_at(k);
  if(is_clearly_less(of_left, of_right))
  {
    if(ends_with_right)
      return Pair_outcome::RIGHT_IS_REDUNDANT;
    right.begin = k;
    right.begin_distance = of_right;
  }
  else if(ends_with_right && is_clearly_less(of_right, of_left))
  {
    left.end = k;
    left.end_distance = of_left;
  }
  return Pair_outcome::KEEP_BOTH;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_PRUNING_H
