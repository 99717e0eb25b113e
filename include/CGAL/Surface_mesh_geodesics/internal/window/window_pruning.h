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

// The rules that prune single windows. A window, or a part of its interval, is dominated if no shortest path runs
// through it, or if a path of the same length runs elsewhere. The manual (page Theory) has the proofs.
//
// The rules that also run over whole lists are written in lanes/lane_pruning.h, for any number of lanes; the functions
// here call their one-lane instances.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Vertex_rival.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/one_lane.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Is a window beaten by an end of its edge? See one_lane::are_beaten_by_vertices().
template <typename FT>
bool is_beaten_by_vertices(const Window<FT>& w, const FT& length, const Vertex_rival<FT>& left,
                           const Vertex_rival<FT>& right)
{
  return one_lane::are_beaten_by_vertices<FT>(w, length, left, right) != 0;
}

enum class Pair_outcome { KEEP_BOTH, LEFT_IS_DOMINATED, RIGHT_IS_DOMINATED };

// The rule for crossed windows (thesis, cases 3 and 6): the interval of `left`, whose key is smaller, lies wholly on
// the right of that of `right`. Then each path of one meets each path of the other, and the window that is nearer at
// the point U where the two innermost paths meet is nearer everywhere.
//
// Formula. At the height -h below AB, the path to left.begin is at left.begin + h * left_slope and the path to
// right.end at right.end + h * right_slope. They meet at h = (left.begin - right.end) / (right_slope - left_slope).
// From the edge back to U, a distance shrinks by its straight part in proportion to h. This rule has no text for lanes:
// pairs of this kind are rare, and lists leave them undecided.
//
// Ties, and paths that do not cross below the edge (which contradicts the order, by rounding), keep both windows. So
// does an image on the edge: its paths run along the edge and have no slope. Error bound, with u = epsilon() / 2:
// rounding of the slopes makes the two points differ by 5 u of the straight parts, and each distance there errs by 8 u,
// so that the decision is right if the distances differ by 26 u = 13 epsilon() of the longer one.
template <typename FT>
Pair_outcome prune_crossed_windows(const Window<FT>& left, const Window<FT>& right)
{
  if(!(left.image_depth > 0 && right.image_depth > 0))
    return Pair_outcome::KEEP_BOTH;
  const FT left_slope = (left.image_x - left.begin) / left.image_depth;
  const FT right_slope = (right.image_x - right.end) / right.image_depth;
  const FT approach = right_slope - left_slope;
  if(!(approach > 0))
    return Pair_outcome::KEEP_BOTH;
  const FT h = (left.begin - right.end) / approach;
  const FT at_left = left.begin_distance
                   - (left.begin_distance - left.root_distance) * h / left.image_depth;
  const FT at_right = right.end_distance
                    - (right.end_distance - right.root_distance) * h / right.image_depth;
  if(is_clearly_less(at_left, at_right))
    return Pair_outcome::RIGHT_IS_DOMINATED;
  if(is_clearly_less(at_right, at_left))
    return Pair_outcome::LEFT_IS_DOMINATED;
  return Pair_outcome::KEEP_BOTH;
}

// Applies the pair rules (thesis, 4.2.1, cases 1-6) to two windows of one edge: trims them, or finds one dominated,
// which stays as it is. See one_lane::Trimmed_pairs for the rule and one_lane for its only text.
// Requires: left.key <= right.key, and not is_order_unknown(left, right): of two windows with equal keys, `left` comes
// first in the list. Neither window is_too_close_to_trim().
template <typename FT>
Pair_outcome prune_pair(Window<FT>& left, Window<FT>& right)
{
  CGAL_expensive_assertion(left.key <= right.key && !is_order_unknown(left, right));
  if(left.end <= right.begin)
    return Pair_outcome::KEEP_BOTH;
  if(right.end <= left.begin)
    return prune_crossed_windows(left, right);
  const one_lane::Trimmed_pairs<FT> pair(left, right, FT(-1)); // no image is that close
  if(pair.left_is_dominated)
    return Pair_outcome::LEFT_IS_DOMINATED;
  if(pair.right_is_dominated)
    return Pair_outcome::RIGHT_IS_DOMINATED;
  left.end = pair.left_end;
  left.end_distance = pair.left_end_distance;
  right.begin = pair.right_begin;
  right.begin_distance = pair.right_begin_distance;
  return Pair_outcome::KEEP_BOTH;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_PRUNING_H
