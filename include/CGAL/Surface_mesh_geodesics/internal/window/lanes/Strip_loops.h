// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// The loops over the strips that cross a face together.
//
// Included once for each number of lanes, behind the text of the loops over windows; see README.md.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES

#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/strip_splitting.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {
namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE {

// strips/Strip_list_loops.h says what each loop does.
template <typename FT>
class Strip_loops
{
  using L = Lanes<FT>;
  using Number = typename L::Number;
  using Mask = typename L::Mask;
  using Columns = Strip_columns<FT>;
  static_assert(L::size <= Columns::padding, "the rows behind the strips take the lanes of a last step");

public:
  static Strip_list_loops<FT> table()
  {
    return Strip_list_loops<FT>{enter, cross<Left_turn<FT>>, cross<Right_turn<FT>>};
  }

private:
  // (The rows of a step are read before those in front of them, or they themselves, are written.)
  static Entered_strips<FT> enter(Columns& strips, std::size_t n, const Face_frame<FT>& c, const Vertex_rival<FT>& a,
                                  const Vertex_rival<FT>& b)
  {
    const Number infinity = L::all(std::numeric_limits<FT>::infinity());
    Number least = infinity;
    std::size_t end = 0;
    for(std::size_t i = 0; i < n; i += L::size)
    {
      Strip_lanes<FT> s = load_strips(strips, i);
      const Mask is_useful = L::first(n - i) & trim_strips(s, c.length, a, b);
      const Number apex_distance = (s.distance + L::rounded_product(s.direction_x, c.apex_x))
                                 + L::rounded_product(s.direction_y, c.apex_y);
      const Number crossing = L::all(c.apex_x) - L::rounded_product(s.direction_x / s.direction_y, c.apex_y);
      const Number path = path_to_apex(s, c, crossing, apex_distance);
      least = L::minimum(least, L::select(is_useful, path, infinity));
      store_strips(strips, end, s);
      L::store(strips.apex_crossing() + end, crossing);
      L::store(strips.apex_distance() + end, apex_distance);
      L::store(strips.path_to_apex() + end, path);
      end = keep_rows(strips, end, L::bits(is_useful));
    }
    return {end, L::least(least)};
  }

  // Slivers have no children: strips so narrow that rounding makes up their width. Their rays graze the edge, or a
  // vertex. No path is lost: each strip improves the apex of the face, also by a path that bends at its end.
  template <typename Turn>
  static Strip_children<FT> cross(Columns& strips, std::size_t n, const Strip_side<FT>& side, Columns& children)
  {
    const Number infinity = L::all(std::numeric_limits<FT>::infinity());
    const Number sliver = L::all(FT(Tolerance<FT>::interval() * side.edge_length));
    Number least = infinity;
    std::size_t end = 0;
    for(std::size_t i = 0; i < n; i += L::size)
    {
      Strip_lanes<FT> s = load_strips(strips, i);
      const Mask is_wide = L::first(n - i) & L::less(sliver, (s.end - s.begin) * s.direction_y);
      const Mask is_longer = L::less(L::all(side.known), L::load(strips.apex_distance() + i));
      // One after the other, in statements of their own: both change the strips.
      const Mask crosses = Turn::turn(s, side, L::load(strips.apex_crossing() + i), is_longer);
      const Mask has_rays = is_wide & crosses & trim_strips(s, side.length, side.left, side.right);
      s.history = s.history + Columns::one_face;
      const Number distance = least_distance(s);
      const Mask is_useful = has_rays & L::less_equal(distance, L::all(side.maximum_distance));
      least = L::minimum(least, L::select(is_useful, distance, infinity));
      store_strips(children, end, s);
      end = keep_rows(children, end, L::bits(is_useful));
    }
    return {end, L::least(least)};
  }
};

} // namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_LANES
