// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PRUNING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PRUNING_H

// level: 2 (window)
//
// What makes a window, or a part of its interval, redundant: no shortest path runs through it, or one
// of the same length runs elsewhere. See the manual, Implementation Details, for the proofs.

#include <CGAL/Surface_mesh_geodesics/internal/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/simd.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// is a < b beyond doubt, for two distances?
template <typename FT>
bool is_clearly_less(const FT& a, const FT& b)
{
  return a < b * (1 - Tolerance<FT>::distance());
}

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
  template <typename L>
  typename L::Mask beats(const typename L::Number& l, const typename L::Number& window_distance) const
  {
    return L::less(distance + l, window_distance * factor);
  }
};

// Checking with vertices (thesis, case 12; Xin and Wang 2009): the path from the left end A of the
// edge, or from its right end, along the edge to the far end of the interval crosses every path of
// the window. If it is shorter there, it is shorter at each crossing. L says how many windows w is.
template <typename L, typename Windows, typename FT>
typename L::Mask is_beaten_by_vertices(const Windows& w, const FT& length,
                                       const Vertex_rival<FT>& left, const Vertex_rival<FT>& right)
{
  return left.template beats<L>(w.end, w.end_distance)
       | right.template beats<L>(length - w.begin, w.begin_distance);
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

// What prune_pair() does to pairs of windows, one in each lane, where it trims one window or both: the
// new end of the left window and the new beginning of the right one. Pairs with an image that is not
// deeper than close_depth are left undecided: such a window may be too close to trim.
template <typename FT>
struct Trimmed_pairs
{
  using L = Lanes<FT>;
  typename L::Number left_end, left_end_distance, right_begin, right_begin_distance;
  typename L::Mask is_undecided; // a window is redundant, or may be: left as it is

  Trimmed_pairs(const Window_lanes<FT>& left, const Window_lanes<FT>& right, const FT& close_depth);
};

template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
Trimmed_pairs<FT>::Trimmed_pairs(const Window_lanes<FT>& left, const Window_lanes<FT>& right,
                                 const FT& close_depth)
{
  using Number = typename L::Number;
  using Mask = typename L::Mask;
  // One of the two windows begins at the left end k of the shared part, where its distance is known;
  // the distance of the other one is computed. So it is at the right end of the shared part.
  const auto distance_at = [](Mask of_right, const Window_lanes<FT>& l, const Window_lanes<FT>& r,
                              const Number& x) -> Number
  {
    const Number dx = x - L::select(of_right, r.image_x, l.image_x);
    const Number depth = L::select(of_right, r.image_depth, l.image_depth);
    return L::select(of_right, r.root_distance, l.root_distance)
         + L::square_root(dx * dx + depth * depth);
  };
  const Number margin = L::all(FT(1 - Tolerance<FT>::distance())); // see is_clearly_less()

  const Mask starts_with_left = L::less_equal(right.begin, left.begin);
  const Number first = L::maximum(left.begin, right.begin);
  const Number at_first = distance_at(starts_with_left, left, right, first);
  const Number left_first = L::select(starts_with_left, left.begin_distance, at_first);
  const Number right_first = L::select(starts_with_left, at_first, right.begin_distance);
  const Mask right_is_nearer_first = L::less(right_first, left_first * margin);
  const Mask left_is_nearer_first = L::less(left_first, right_first * margin);

  const Mask ends_with_right = L::less_equal(right.end, left.end);
  const Number last = L::minimum(left.end, right.end);
  const Number at_last = distance_at(L::except(L::less_equal(left.end, left.end), ends_with_right),
                                     left, right, last);
  const Number left_last = L::select(ends_with_right, at_last, left.end_distance);
  const Number right_last = L::select(ends_with_right, right.end_distance, at_last);
  const Mask right_is_nearer_last = L::less(right_last, left_last * margin);
  const Mask left_is_nearer_last = L::less(left_last, right_last * margin);

  const Mask overlap = L::less(right.begin, left.end);
  const Mask goes_on = L::except(overlap, right_is_nearer_first);
  const Number depth = L::minimum(left.image_depth, right.image_depth);
  is_undecided = (overlap & L::less_equal(depth, L::all(close_depth)))
               | (overlap & L::less_equal(right.end, left.begin))
               | (overlap & right_is_nearer_first & starts_with_left)
               | (goes_on & left_is_nearer_last & ends_with_right);
  const Mask ends_at_first = L::except(overlap & right_is_nearer_first, is_undecided);
  const Mask ends_at_last = L::except(goes_on & ends_with_right & right_is_nearer_last, is_undecided);
  left_end = L::select(ends_at_first, first, L::select(ends_at_last, last, left.end));
  left_end_distance = L::select(ends_at_first, at_first,
                                L::select(ends_at_last, at_last, left.end_distance));
  const Mask begins_at_last = L::except(goes_on & left_is_nearer_last, is_undecided);
  const Mask begins_at_first = L::except(goes_on & starts_with_left & left_is_nearer_first,
                                         is_undecided);
  right_begin = L::select(begins_at_last, last, L::select(begins_at_first, first, right.begin));
  right_begin_distance = L::select(begins_at_last, at_last,
                                   L::select(begins_at_first, at_first, right.begin_distance));
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PRUNING_H
