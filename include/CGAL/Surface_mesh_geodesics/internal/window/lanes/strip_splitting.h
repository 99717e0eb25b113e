// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// How strips are trimmed and cross a face. The manual has the proofs (Theory, Curves as Sources).
//
// Included once for each number of lanes; see README.md.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {
namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE {

// Several strips, one in each lane (strips/Strip.h).
template <typename FT>
struct Strip_lanes
{
  typename Lanes<FT>::Number begin, end, direction_x, direction_y, distance, foot;
  typename Lanes<FT>::Word history;
};

template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
Strip_lanes<FT> load_strips(Strip_columns<FT>& columns, std::size_t i)
{
  using L = Lanes<FT>;
  return Strip_lanes<FT>{L::load(columns.begin() + i), L::load(columns.end() + i), L::load(columns.direction_x() + i),
                         L::load(columns.direction_y() + i), L::load(columns.distance() + i),
                         L::load(columns.foot() + i), L::load(columns.history() + i)};
}

template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
void store_strips(Strip_columns<FT>& columns, std::size_t i, const Strip_lanes<FT>& s)
{
  using L = Lanes<FT>;
  L::store(columns.begin() + i, s.begin);
  L::store(columns.end() + i, s.end);
  L::store(columns.direction_x() + i, s.direction_x);
  L::store(columns.direction_y() + i, s.direction_y);
  L::store(columns.distance() + i, s.distance);
  L::store(columns.foot() + i, s.foot);
  L::store(columns.history() + i, s.history);
}

// Takes those rays away that an end of the edge beats, and returns the lanes that have any left.
//
// Proof. Let P be a point of the ray through x, at the distance s beyond the edge. By way of A it is reached within
// d(A) + x + s, the ray has the length D(x) + s. So A beats the ray where d(A) + x < D(x). As D grows by at most 1,
// this holds up to some x, and from there on no more; the formula solves the equation, with the factor of Vertex_rival
// on D. B is the mirror image. The order of visits does not matter: d(A) is the length of a path at any time.
template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
typename Lanes<FT>::Mask trim_strips(Strip_lanes<FT>& s, const FT& length, const Vertex_rival<FT>& left,
                                     const Vertex_rival<FT>& right)
{
  using L = Lanes<FT>;
  using Number = typename L::Number;
  using Mask = typename L::Mask;
  const Number one = L::all(FT(1));
  const Number from_left = L::rounded_product(s.distance, left.factor) - L::all(left.distance);
  const Number slope_left = one - L::rounded_product(s.direction_x, left.factor);
  const Mask is_beaten_by_left = L::less(slope_left * s.begin, from_left);
  const Mask no_ray_is_left = is_beaten_by_left & L::less(slope_left * s.end, from_left);
  s.begin = L::select(is_beaten_by_left, L::maximum(s.begin, from_left / slope_left), s.begin);
  const Number from_right = L::all(FT(right.distance + length)) - L::rounded_product(s.distance, right.factor);
  const Number slope_right = one + L::rounded_product(s.direction_x, right.factor);
  const Mask is_beaten_by_right = L::less(from_right, slope_right * s.end);
  const Mask no_ray_is_right = is_beaten_by_right & L::less(from_right, slope_right * s.begin);
  s.end = L::select(is_beaten_by_right, L::minimum(s.end, from_right / slope_right), s.end);
  return L::except(L::less(s.begin, s.end), no_ray_is_left | no_ray_is_right);
}

// The least distance of the rays of each strip on its edge.
template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
typename Lanes<FT>::Number least_distance(const Strip_lanes<FT>& s)
{
  using L = Lanes<FT>;
  return s.distance
       + L::rounded_product(s.direction_x,
                            L::select(L::less(s.direction_x, L::all(FT(0))), s.end, s.begin));
}

// The shortest path to the apex through each strip, as arrival_of_ray() finds it (Strip.h), up to products that the
// compiler fuses there. `crossing` is where the ray through the apex crosses AB, `along_ray` the value of the linear
// function at the apex.
template <typename FT>
CGAL_SURFACE_MESH_GEODESICS_INLINE
typename Lanes<FT>::Number path_to_apex(const Strip_lanes<FT>& s, const Face_frame<FT>& c,
                                        const typename Lanes<FT>::Number& crossing,
                                        const typename Lanes<FT>::Number& along_ray)
{
  using L = Lanes<FT>;
  using Number = typename L::Number;
  const Number zero = L::all(FT(0));
  const Number bend = L::minimum(s.end, L::maximum(s.begin, crossing));
  const Number up_to_edge = L::maximum(zero, s.distance + L::rounded_product(s.direction_x, bend));
  const Number x = L::all(c.apex_x) - bend, y = L::all(c.apex_y);
  const Number beyond = L::square_root(L::rounded_product(x, x) + L::rounded_product(y, y));
  return L::select(L::less_equal(s.begin, crossing) & L::less_equal(crossing, s.end), L::maximum(zero, along_ray),
                   up_to_edge + beyond);
}

// Turns strips into the parts of them that cross AB up to `last` and then AC. Returns the lanes with such parts. `apex`
// is the abscissa of the ray through C. Requires: last <= apex. Then apex > 0 tells that rays cross AC at all.
//
// Formulas. The direction turns by the angle of AC. Abscissas on AC are those on AB times |AC| / apex (parallel
// projection). That factor is also the inverse ratio of the heights of the directions, which is right to the last
// digits beside sides that are much shorter than AB; there the difference of two abscissas on AB is not.
template <typename FT>
struct Left_turn
{
  using L = Lanes<FT>;
  using Number = typename L::Number;
  using Mask = typename L::Mask;

  CGAL_SURFACE_MESH_GEODESICS_INLINE
  static Mask turn(Strip_lanes<FT>& s, const Strip_side<FT>& side, const Number& apex, const Mask& is_longer)
  {
    const Number last = L::select(is_longer, L::minimum(apex, L::all(side.cut)), apex);
    const Number begin = s.begin, end = L::minimum(s.end, last);
    const Number height = L::rounded_product(s.direction_y, side.angle.cosine)
                        - L::rounded_product(s.direction_x, side.angle.sine);
    const Number zero = L::all(FT(0)), length = L::all(side.length), ratio = s.direction_y / height;
    s.begin = L::minimum(length, begin * ratio);
    s.end = L::select(L::less_equal(apex, end), length, L::minimum(length, end * ratio));
    s.direction_x = L::rounded_product(s.direction_x, side.angle.cosine)
                  + L::rounded_product(s.direction_y, side.angle.sine);
    s.direction_y = height;
    return L::less(zero, apex) & L::less(begin, end) & L::less(zero, height) & L::less(s.begin, s.end);
  }
};

// The mirror image: the parts that cross AB from `first` on, and then CB. Requires: first >= apex.
template <typename FT>
struct Right_turn
{
  using L = Lanes<FT>;
  using Number = typename L::Number;
  using Mask = typename L::Mask;

  CGAL_SURFACE_MESH_GEODESICS_INLINE
  static Mask turn(Strip_lanes<FT>& s, const Strip_side<FT>& side, const Number& apex, const Mask& is_longer)
  {
    const Number first = L::select(is_longer, L::maximum(apex, L::all(side.cut)), apex);
    const Number begin = L::maximum(s.begin, first), end = s.end;
    const Number height = L::rounded_product(s.direction_y, side.angle.cosine)
                        + L::rounded_product(s.direction_x, side.angle.sine);
    const Number zero = L::all(FT(0)), length = L::all(side.length), edge_length = L::all(side.edge_length);
    const Number ratio = s.direction_y / height;
    const Number at_target = s.distance + L::rounded_product(s.direction_x, side.edge_length);
    const Number foot_of_target = s.foot + L::rounded_product(s.direction_y, side.edge_length);
    s.begin = L::select(L::less_equal(begin, apex), zero,
                        L::maximum(zero, length - L::rounded_product(edge_length - begin, ratio)));
    s.end = L::maximum(zero, length - L::rounded_product(edge_length - end, ratio));
    s.direction_x = L::rounded_product(s.direction_x, side.angle.cosine)
                  - L::rounded_product(s.direction_y, side.angle.sine);
    s.direction_y = height;
    s.distance = at_target - L::rounded_product(s.direction_x, side.length);
    s.foot = foot_of_target - L::rounded_product(height, side.length);
    return L::less(apex, edge_length) & L::less(begin, end) & L::less(zero, height) & L::less(s.begin, s.end);
  }
};

} // namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_LANES
