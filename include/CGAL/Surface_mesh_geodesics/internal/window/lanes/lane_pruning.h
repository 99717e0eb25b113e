// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// The rules that prune windows by vertices and by each other, for any number of lanes. The manual (page Theory) proves
// them; window_pruning.h applies them to single windows.
//
// All rules work in the frame of Window.h, in which AB is the x axis. They compare distances beyond rounding. A tie
// removes nothing, except by a vertex that wins ties (Vertex_rival). Scaling all lengths by a power of two changes no
// decision. test_predicate_laws tests the bounds and laws that stand below.
//
// Rules for lanes cannot ask is_order_unknown(). So Window_list_crossing::prune() diverts lists that may hold marked
// windows to suspect_all(), and applies the pair rule to single windows, for which it can ask. The rule for vertices
// does not need the order.
//
// Included once for each number of lanes; see README.md.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {
namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE {

// Which windows are beaten by an end of their edge (thesis, case 12: checking with vertices; Xin and Wang 2009)? The
// path from the end A along the edge to the far end of the interval crosses every path of the window. If it is shorter
// there,
//   left.distance + end < left.factor * end_distance,
// it is shorter where the two intersect. The formula for B is the mirror image of this one.
//
// Ties: those of Vertex_rival. Error bound: a rival that does not win ties never removes a window that is not farther,
// and removes each one that is farther by 6 epsilon() of its distance. Law: the mirror image gives the same
// answer if the mirror images of the ends of the interval are exact.
template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
typename Lanes<FT>::Mask are_beaten_by_vertices(const Window_numbers<FT>& w, const FT& length,
                                                const Vertex_rival<FT>& left, const Vertex_rival<FT>& right)
{
  using L = Lanes<FT>;
  return L::less(left.distance + w.end, w.end_distance * left.factor)
       | L::less(right.distance + (length - w.begin), w.begin_distance * right.factor);
}

// The distances of two windows at one point x of their edge, one of which is known.
template <typename FT>
struct Compared_distances
{
  using L = Lanes<FT>;
  typename L::Number computed;
  typename L::Mask left_is_nearer, right_is_nearer; // clearly

  // Computes the distance of `right` at x where the mask is set, and that of `left` elsewhere. The distance of the
  // other window is known.
  CGAL_SURFACE_MESH_GEODESICS_INLINE
  Compared_distances(const typename L::Mask& is_right, const Window_numbers<FT>& left, const Window_numbers<FT>& right,
                     const typename L::Number& x, const typename L::Number& known_of_left,
                     const typename L::Number& known_of_right)
  {
    using Number = typename L::Number;
    const Number dx = x - L::select(is_right, right.image_x, left.image_x);
    const Number depth = L::select(is_right, right.image_depth, left.image_depth);
    computed = L::select(is_right, right.root_distance, left.root_distance)
             + L::square_root(L::rounded_product(dx, dx) + L::rounded_product(depth, depth));
    const Number of_left = L::select(is_right, known_of_left, computed);
    const Number of_right = L::select(is_right, computed, known_of_right);
    const Number margin = L::all(FT(1 - Tolerance<FT>::distance())); // is_clearly_less()
    right_is_nearer = L::less(of_right, of_left * margin);
    left_is_nearer = L::less(of_left, of_right * margin);
  }
};

// The rule of pairs (thesis, 4.2.1, cases 1-6) for pairs of windows of one edge, one pair in each lane.
// Requires, of each pair: left.key <= right.key, and not is_order_unknown(left, right). Lists keep the order of windows
// with equal keys, and lists that may hold marked windows are not trimmed by lanes.
//
// Formula. At a point K of both intervals, let `right` be nearer. A path of `left` that ends on the right of K crosses
// the path of `right` to K and is not the shorter one there: that part of `left` is dominated. The mirror image holds
// if `left` is nearer. K is put at both ends, `first` and `last`, of what the intervals share. There, one of the
// windows begins or ends, and its distance is known. A window that loses its whole interval is dominated, else it is
// trimmed. Two windows that still overlap afterward have a point of equal distance inside, up to rounding.
//
// Ties remove nothing. Error bound: a part is removed only if it is farther than its rival or ties up to
// epsilon(), and is removed wherever it is farther by 9 epsilon(), for exact images (see
// Tolerance::distance() for their errors). Laws: never are both windows dominated; trimming leaves valid intervals; the
// mirror image of a pair gives the mirror image of the result, if the order of the keys is true. (Were `right` nearer
// at `first` and `left` nearer at `last`, which contradicts the order, then `first` would decide.)
template <typename FT>
struct Trimmed_pairs
{
  using L = Lanes<FT>;
  typename L::Number left_end, left_end_distance, right_begin, right_begin_distance;
  typename L::Mask left_is_dominated, right_is_dominated; // never both
  typename L::Mask is_undecided; // one is dominated, or the pair is not decided here; both windows stay as they are

  // Does not decide pairs of intervals in the wrong order (see prune_crossed_windows()), nor those with an image that
  // is not deeper than close_depth: such a window may be too close to trim. A negative depth excludes none.
  Trimmed_pairs(const Window_numbers<FT>& left, const Window_numbers<FT>& right, const FT& close_depth);
};

template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
Trimmed_pairs<FT>::Trimmed_pairs(const Window_numbers<FT>& left, const Window_numbers<FT>& right,
                                 const FT& close_depth)
{
  using Number = typename L::Number;
  using Mask = typename L::Mask;
  const Mask starts_with_left = L::less_equal(right.begin, left.begin);
  const Number first = L::maximum(left.begin, right.begin);
  const Compared_distances<FT> at_first(starts_with_left, left, right, first, left.begin_distance,
                                        right.begin_distance);

  const Mask ends_with_right = L::less_equal(right.end, left.end);
  const Number last = L::minimum(left.end, right.end);
  const Compared_distances<FT> at_last(L::less(left.end, right.end), left, right, last, left.end_distance,
                                       right.end_distance);

  const Mask overlap = L::less(right.begin, left.end);
  const Mask goes_on = L::except(overlap, at_first.right_is_nearer);
  const Number depth = L::minimum(left.image_depth, right.image_depth);
  left_is_dominated = overlap & at_first.right_is_nearer & starts_with_left;
  right_is_dominated = goes_on & at_last.left_is_nearer & ends_with_right;
  is_undecided = (overlap & L::less_equal(depth, L::all(close_depth)))
               | (overlap & L::less_equal(right.end, left.begin)) | left_is_dominated | right_is_dominated;

  const Mask ends_at_first = L::except(overlap & at_first.right_is_nearer, is_undecided);
  const Mask ends_at_last = L::except(goes_on & ends_with_right & at_last.right_is_nearer, is_undecided);
  left_end = L::select(ends_at_first, first, L::select(ends_at_last, last, left.end));
  left_end_distance = L::select(ends_at_first, at_first.computed,
                                L::select(ends_at_last, at_last.computed, left.end_distance));
  const Mask begins_at_last = L::except(goes_on & at_last.left_is_nearer, is_undecided);
  const Mask begins_at_first = L::except(goes_on & starts_with_left & at_first.left_is_nearer, is_undecided);
  right_begin = L::select(begins_at_last, last, L::select(begins_at_first, first, right.begin));
  right_begin_distance = L::select(begins_at_last, at_last.computed,
                                   L::select(begins_at_first, at_first.computed, right.begin_distance));
}

} // namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_LANES
