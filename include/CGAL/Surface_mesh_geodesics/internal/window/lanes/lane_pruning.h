// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// The rules of window_pruning.h for several windows at a time.
//
// Nothing by itself: Window_list_loops.h includes this file once for each number of lanes.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {
namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE {

// is_beaten_by_vertices() for each lane.
template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
typename Lanes<FT>::Mask are_beaten_by_vertices(const Window_numbers<FT>& w, const FT& length,
                                                const Vertex_rival<FT>& left, const Vertex_rival<FT>& right)
{
  using L = Lanes<FT>;
  return L::less(left.distance + w.end, w.end_distance * left.factor)
       | L::less(right.distance + (length - w.begin), w.begin_distance * right.factor);
}

// What prune_pair() does to pairs of windows, one in each lane, where it trims one window or both: the
// new end of the left window and the new beginning of the right one. Pairs with an image that is not
// deeper than close_depth are left undecided: such a window may be too close to trim.
template <typename FT>
struct Trimmed_pairs
{
  using L = Lanes<FT>;
  typename L::Number left_end, left_end_distance, right_begin, right_begin_distance;
  typename L::Mask left_is_redundant, right_is_redundant; // never both
  typename L::Mask is_undecided; // one of them is redundant, or the pair is not decided here: both stay as they are

  Trimmed_pairs(const Window_numbers<FT>& left, const Window_numbers<FT>& right, const FT& close_depth);
};

// The distance that the window of `right`, or that of `left`, has at the point (x,0).
template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
typename Lanes<FT>::Number distance_of_one(const typename Lanes<FT>::Mask& is_right, const Window_numbers<FT>& left,
                                           const Window_numbers<FT>& right, const typename Lanes<FT>::Number& x)
{
  using L = Lanes<FT>;
  using Number = typename L::Number;
  const Number dx = x - L::select(is_right, right.image_x, left.image_x);
  const Number depth = L::select(is_right, right.image_depth, left.image_depth);
  return L::select(is_right, right.root_distance, left.root_distance)
       + L::square_root(dx * dx + depth * depth);
}

template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
Trimmed_pairs<FT>::Trimmed_pairs(const Window_numbers<FT>& left, const Window_numbers<FT>& right,
                                 const FT& close_depth)
{
  using Number = typename L::Number;
  using Mask = typename L::Mask;
  // One of the two windows begins at the left end k of the shared part, where its distance is known;
  // the distance of the other one is computed. So it is at the right end of the shared part.
  const Number margin = L::all(FT(1 - Tolerance<FT>::distance())); // see is_clearly_less()

  const Mask starts_with_left = L::less_equal(right.begin, left.begin);
  const Number first = L::maximum(left.begin, right.begin);
  const Number at_first = distance_of_one(starts_with_left, left, right, first);
  const Number left_first = L::select(starts_with_left, left.begin_distance, at_first);
  const Number right_first = L::select(starts_with_left, at_first, right.begin_distance);
  const Mask right_is_nearer_first = L::less(right_first, left_first * margin);
  const Mask left_is_nearer_first = L::less(left_first, right_first * margin);

  const Mask ends_with_right = L::less_equal(right.end, left.end);
  const Number last = L::minimum(left.end, right.end);
  const Number at_last = distance_of_one(L::except(L::less_equal(left.end, left.end), ends_with_right),
                                         left, right, last);
  const Number left_last = L::select(ends_with_right, at_last, left.end_distance);
  const Number right_last = L::select(ends_with_right, right.end_distance, at_last);
  const Mask right_is_nearer_last = L::less(right_last, left_last * margin);
  const Mask left_is_nearer_last = L::less(left_last, right_last * margin);

  const Mask overlap = L::less(right.begin, left.end);
  const Mask goes_on = L::except(overlap, right_is_nearer_first);
  const Number depth = L::minimum(left.image_depth, right.image_depth);
  left_is_redundant = overlap & right_is_nearer_first & starts_with_left;
  right_is_redundant = goes_on & left_is_nearer_last & ends_with_right;
  is_undecided = (overlap & L::less_equal(depth, L::all(close_depth)))
               | (overlap & L::less_equal(right.end, left.begin)) | left_is_redundant | right_is_redundant;
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

} // namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_LANES
