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

#include <algorithm>

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
// Ties keep both windows, and so do paths that do not approach each other below the edge, which contradicts the order
// of the keys. So does an image on the edge: its paths run along the edge and have no slope.
//
// Error bound, to first order in u = epsilon() / 2, for exact images. Let M be the larger one of left.begin_distance
// and right.end_distance, and k = h / image_depth. The rounding errors stem from the distances on the edge. So they are
// small in comparison with M, but not with the distances at U if U is near the images.
// - Given h, at_left errs by 4 u |1 - k| of left.begin_distance, 3 u k of its straight part, and u of itself.
// - A slope errs by 2 u of itself, and so h by 2 u (|left_slope| + |right_slope|) / approach + 3 u of itself. This may
//   be much if the paths are nearly parallel. But when U moves by dh, both distances change nearly alike: their
//   difference changes by dh |sqrt(1 + left_slope^2) - sqrt(1 + right_slope^2)| <= dh * approach at most. As the slope
//   times h is at most k times the straight part, this adds 5 u k of both straight parts.
// If U is between the images and the edge (k <= 1), the sums are at most 8 u M for each window: the difference of the
// two distances errs by 16 u M = 8 epsilon() M. So a window is removed only if it is nearer by 8 epsilon() M at most,
// and, with the margin of is_clearly_less(), is removed wherever it is farther by 25 u M, less than 13 epsilon() M.
//
// U beyond an image keeps both windows. Exact paths cross between their images and the edge: they are straight only
// there. By the errors of images, the stored lines may cross beyond a stored image. The rule has no proof there.
template <typename FT>
Pair_outcome prune_crossed_windows(const Window<FT>& left, const Window<FT>& right)
{
  CGAL_expensive_assertion(right.end <= left.begin);
  if(!(left.image_depth > 0 && right.image_depth > 0))
    return Pair_outcome::KEEP_BOTH;
  const FT left_slope = (left.image_x - left.begin) / left.image_depth;
  const FT right_slope = (right.image_x - right.end) / right.image_depth;
  const FT approach = right_slope - left_slope;
  if(!(approach > 0))
    return Pair_outcome::KEEP_BOTH;
  const FT h = (left.begin - right.end) / approach;
  if(h > left.image_depth || h > right.image_depth)
    return Pair_outcome::KEEP_BOTH;
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
// first in the list. Neither window is_too_close_to_trim() on the edge.
template <typename FT>
Pair_outcome prune_pair(Window<FT>& left, Window<FT>& right)
{
  CGAL_expensive_assertion(left.key <= right.key && !is_order_unknown(left, right));
  // (The edge is not shorter than this part of it, and an image too close on a short edge is too close on a longer
  // one.)
  CGAL_expensive_assertion(!is_too_close_to_trim(left, FT((std::max)(left.end, right.end))));
  CGAL_expensive_assertion(!is_too_close_to_trim(right, FT((std::max)(left.end, right.end))));
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
