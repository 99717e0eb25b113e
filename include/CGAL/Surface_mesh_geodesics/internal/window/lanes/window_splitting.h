// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// Carries windows across one triangle, one in each lane: finds where they separate at the apex C (thesis, 4.2.1), and
// makes their children on the left edge AC and the right edge CB. Requires: no edge of the triangle has the length 0.
//
// Formulas. They project AB from the image onto the other edges. Where a sign matters, they add and multiply only
// numbers that are not negative, so that rounding moves no image to the wrong side of an edge. The image is turned as
// in surface/unfolding.h, but by other operations and so with other bits: the depth is computed from the abscissa below
// C, which is needed anyway.
//
// An interval that ends at the line from the image to C, up to rounding, is extended to C. Otherwise, if the image is
// near AB, the rounding of the end would become a gap next to C. (The added paths miss the end of the interval on AB by
// the rounding of the length of AB, and their lengths are too short by the square of that.)
//
// Error bound of an image, to first order in u = epsilon() / 2, for an exact frame: on the left, image_x errs by
// 3 u and the depth by 8 u of the distance from the image to A; on the right, they err by 4 u and 5 u of its distance
// to C and B. Together this is less than 9 u of the distance r to the farthest corner. Tolerance::distance() adds the
// frames up.
// Laws: scaling by a power of two scales the child exactly; the mirror image gives the mirror image up to rounding.
//
// Afterwards, lanes without a window, and lanes whose child has no interval, may hold anything.
//
// Included once for each number of lanes; see README.md.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {
namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE {

// The abscissa at which the line from the image to C meets the line AB. Requires: the apex and the image are not both
// on AB; otherwise the result is not a number, and the window has no child.
template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
typename Lanes<FT>::Number apex_abscissa(const Window_lanes<FT>& w, const Face_frame<FT>& c)
{
  using L = Lanes<FT>;
  return (L::rounded_product(w.image_x, c.apex_y) + L::rounded_product(w.image_depth, c.apex_x))
       / (c.apex_y + w.image_depth);
}

// The distance to C through the window. The path crosses AB at the separating point, which is the point of the interval
// nearest to t = apex_abscissa(w, c) (thesis, 4.2.3.1), and bends there if this is not t.
template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
typename Lanes<FT>::Number distance_to_apex(const Window_lanes<FT>& w, const Face_frame<FT>& c,
                                            const typename Lanes<FT>::Number& t)
{
  using L = Lanes<FT>;
  using Number = typename L::Number;
  using Mask = typename L::Mask;
  const Mask bends_at_begin = L::less_equal(t, w.begin), bends_at_end = L::less_equal(w.end, t);
  const Number x = L::select(bends_at_begin, w.begin, L::select(bends_at_end, w.end, w.image_x));
  const Number distance = L::select(bends_at_begin, w.begin_distance,
                                    L::select(bends_at_end, w.end_distance, w.root_distance));
  const Number depth = L::select(bends_at_begin | bends_at_end, L::all(FT(0)), w.image_depth);
  const Number dx = c.apex_x - x, dy = c.apex_y + depth;
  return distance + L::square_root(L::rounded_product(dx, dx) + L::rounded_product(dy, dy));
}

// The keys of children after a turn.
template <typename FT>
typename Lanes<FT>::Word turned(const typename Lanes<FT>::Word& key, Turn turn)
{
  return (key >> 1) | (static_cast<Window_key>(turn) << 63);
}

// Makes the children on the left edge AC, in the frame whose origin is A. They consist of the paths that cross AB
// between `begin` and the apex_abscissa t.
template <typename FT>
class Left_child
{
  using L = Lanes<FT>;
  using Number = typename L::Number;

public:
  explicit Left_child(const Face_frame<FT>& c)
    : m_length(c.left_length), m_apex_y(c.apex_y), m_cosine(c.apex_x / c.left_length),
      m_sine(c.apex_y / c.left_length), m_inverse(1 / c.left_length), m_rounding(Tolerance<FT>::distance() * c.length)
  {}

  const FT& length() const { return m_length; }

  // Turns windows into their children by the paths through AB on the left of `cut`. Returns the lanes with such paths.
  CGAL_SURFACE_MESH_GEODESICS_INLINE
  typename L::Mask operator()(Window_lanes<FT>& w, const Number& t, const FT& cut) const
  {
    // L::minimum() returns its second argument if one of the two is not a number. So `end` is not a number if t is not:
    // an image on the edge of a face without height has no child.
    const Number end = L::minimum(L::all(cut), L::minimum(w.end, t)), begin = w.begin;
    const Number length = L::all(m_length), zero = L::all(FT(0));
    const Number b = L::rounded_product(t, w.image_depth), a = m_length * w.image_depth;
    const Number image_x = L::rounded_product(w.image_x, m_cosine) - L::rounded_product(w.image_depth, m_sine);
    w.begin = L::select(L::less(zero, begin),
                        L::minimum(a * begin / (b + L::rounded_product(t - begin, m_apex_y)), length), zero);
    w.end = L::select(L::less(end, t - L::all(m_rounding)),
                      L::minimum(a * end / (b + L::rounded_product(t - end, m_apex_y)), length), length);
    w.image_depth = L::rounded_product(L::rounded_product(t, m_apex_y) + b, m_inverse);
    w.image_x = image_x;
    w.key = turned<FT>(w.key, LEFT_TURN);
    w.history = w.history + 2 * one_step;
    return L::less(begin, end);
  }

private:
  FT m_length, m_apex_y, m_cosine, m_sine, m_inverse, m_rounding;
};

// Makes the children on the right edge CB, in the frame whose origin is C.
template <typename FT>
class Right_child
{
  using L = Lanes<FT>;
  using Number = typename L::Number;

public:
  explicit Right_child(const Face_frame<FT>& c)
    : m_length(c.right_length), m_edge_length(c.length), m_apex_x(c.apex_x),
      m_apex_rest(c.apex_rest), m_apex_y(c.apex_y), m_cosine(c.apex_rest / c.right_length),
      m_sine(c.apex_y / c.right_length), m_inverse(1 / c.right_length), m_rounding(Tolerance<FT>::distance() * c.length)
  {}

  const FT& length() const { return m_length; }

  // Turns windows into their children by the paths through AB on the right of `cut`; see Left_child.
  CGAL_SURFACE_MESH_GEODESICS_INLINE
  typename L::Mask operator()(Window_lanes<FT>& w, const Number& t, const FT& cut) const
  {
    const Number begin = L::maximum(L::maximum(t, w.begin), L::all(cut)), end = w.end;
    const Number length = L::all(m_length), zero = L::all(FT(0));
    const Number height = m_apex_y + w.image_depth;
    // The height of the triangle of image, B and C above CB, without cancellation where C is near B.
    const Number rest_height = L::rounded_product(m_edge_length - w.image_x, m_apex_y)
                             + L::rounded_product(w.image_depth, m_apex_rest);
    const Number rest = rest_height / height;
    const Number b = L::rounded_product(rest, w.image_depth), a = m_length * height;
    const Number to_begin = begin - t, to_end = end - t;
    w.begin = L::select(L::less(t + L::all(m_rounding), begin),
                        L::minimum(a * to_begin / (b + L::rounded_product(to_begin, m_apex_y)), length), zero);
    w.end = L::select(L::less(end, L::all(m_edge_length)),
                      L::minimum(a * to_end / (b + L::rounded_product(to_end, m_apex_y)), length), length);
    w.image_x = L::rounded_product(w.image_x - m_apex_x, m_cosine) + L::rounded_product(height, m_sine);
    w.image_depth = L::maximum(L::rounded_product(rest_height, m_inverse), zero);
    w.key = turned<FT>(w.key, RIGHT_TURN);
    w.history = w.history + 2 * one_step;
    // If CB is much shorter than AB, its line may pass the image on the wrong side although t, which is rounded
    // relative to AB, still leaves a part of AB. Then the window does not see CB.
    return L::less(begin, end) & L::less_equal(zero, rest_height);
  }

private:
  FT m_length, m_edge_length, m_apex_x, m_apex_rest, m_apex_y, m_cosine, m_sine, m_inverse, m_rounding;
};

} // namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_LANES
