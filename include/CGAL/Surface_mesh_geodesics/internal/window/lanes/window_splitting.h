// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// Windows across one triangle, several at a time: where they separate at the opposite vertex (thesis,
// 4.2.1), and their children on the left edge AC and the right edge CB, neither of which is without
// length. The formulas follow from the projection of AB on the other edges from the image; they are
// written as sums and products of numbers that are not negative wherever a sign matters, so that no
// rounding turns an image to the wrong side of an edge.
//
// An interval that ends at the line to C, as far as rounding lets one see, is carried over to C. In front of an
// image that is near to AB, the rounding of its end would otherwise become a gap next to C. (The paths that are
// added miss an end of AB by the rounding of its length, and are too short by the square of that.)
//
// Lanes without a window, or whose child has no interval, may come to hold anything.
//
// Nothing by itself: Window_list_loops.h includes this file once for each number of lanes.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {
namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE {

// The abscissa at which the line from the image to C meets the line AB.
template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
typename Lanes<FT>::Number apex_abscissa(const Window_lanes<FT>& w, const Face_frame<FT>& c)
{
  return (w.image_x * c.apex_y + c.apex_x * w.image_depth) / (c.apex_y + w.image_depth);
}

// The distance to C through the window. The path crosses AB at the separating point, the point of the
// interval nearest to t, its apex_abscissa (thesis, 4.2.3.1), and bends there if this is not t.
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
  return distance + L::square_root(dx * dx + dy * dy);
}

// The keys of the children.
template <typename FT>
typename Lanes<FT>::Word turned(const typename Lanes<FT>::Word& key, Turn turn)
{
  return (key >> 1) | (static_cast<Window_key>(turn) << 63);
}

// Makes the children of the windows of a list on the left edge AC, which are seen from A. Paths are
// taken through AB from begin to end <= t, the apex_abscissa.
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

  // makes the children by the paths through AB on the left of `cut`. They have to be set to the
  // windows themselves. Returns where there are such paths.
  CGAL_SURFACE_MESH_GEODESICS_INLINE
  typename L::Mask operator()(Window_lanes<FT>& w, const Number& t, const FT& cut) const
  {
    // (A minimum is its second number if one of them is none: an image on a flat face has no abscissa t,
    // and no child.)
    const Number end = L::minimum(L::all(cut), L::minimum(w.end, t)), begin = w.begin;
    const Number length = L::all(m_length), zero = L::all(FT(0));
    const Number b = t * w.image_depth, a = m_length * w.image_depth;
    const Number image_x = w.image_x * m_cosine - w.image_depth * m_sine;
    w.begin = L::select(L::less(zero, begin),
                        L::minimum(a * begin / (b + m_apex_y * (t - begin)), length), zero);
    w.end = L::select(L::less(end, t - L::all(m_rounding)),
                      L::minimum(a * end / (b + m_apex_y * (t - end)), length), length);
    w.image_depth = (t * m_apex_y + b) * m_inverse;
    w.image_x = image_x;
    w.key = turned<FT>(w.key, LEFT_TURN);
    w.history = w.history + 2 * one_step;
    return L::less(begin, end);
  }

private:
  FT m_length, m_apex_y, m_cosine, m_sine, m_inverse, m_rounding;
};

// Makes the children of the windows of a list on the right edge CB, which are seen from C.
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

  // makes the children by the paths through AB on the right of `cut`, see Left_child.
  CGAL_SURFACE_MESH_GEODESICS_INLINE
  typename L::Mask operator()(Window_lanes<FT>& w, const Number& t, const FT& cut) const
  {
    const Number begin = L::maximum(L::maximum(t, w.begin), L::all(cut)), end = w.end;
    const Number length = L::all(m_length), zero = L::all(FT(0));
    const Number height = m_apex_y + w.image_depth;
    // length - t, without the cancellation where C is near to B
    const Number rest_height = (m_edge_length - w.image_x) * m_apex_y + m_apex_rest * w.image_depth;
    const Number rest = rest_height / height;
    const Number b = rest * w.image_depth, a = m_length * height;
    const Number to_begin = begin - t, to_end = end - t;
    w.begin = L::select(L::less(t + L::all(m_rounding), begin),
                        L::minimum(a * to_begin / (b + m_apex_y * to_begin), length), zero);
    w.end = L::select(L::less(end, L::all(m_edge_length)),
                      L::minimum(a * to_end / (b + m_apex_y * to_end), length), length);
    w.image_x = (w.image_x - m_apex_x) * m_cosine + height * m_sine;
    w.image_depth = L::maximum(rest_height * m_inverse, zero);
    w.key = turned<FT>(w.key, RIGHT_TURN);
    w.history = w.history + 2 * one_step;
    // Of an edge that is much shorter than AB the line of CB may pass the image on the wrong side where t, which is
    // rounded to the length of AB, still leaves a part of AB: then the window does not see CB.
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
