// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_SITE_IMAGE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_SITE_IMAGE_H

// Where the shortest paths to points of a face come from: its corners, and the images of pseudo-sources behind the
// windows that have entered it.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A point from which straight paths come into the face: a corner, or the image of a pseudo-source behind
// a window, whose paths are those through the interval from `left_end` to `right_end` as the image sees
// it. Paths to other points bend at the nearer end.
template <typename FT>
struct Site_image
{
  Additively_weighted_point<FT> point;
  Vertex_id site = null_id;
  bool has_cone = false;
  Half_plane<FT> left, right; // of the cone
  Planar_point<FT> left_end, right_end;

  bool sees(const Planar_point<FT>& p, const FT& tolerance = 0) const
  {
    return !has_cone || (left(p) >= -tolerance && right(p) >= -tolerance);
  }

  // the length of the shortest path through the interval.
  FT distance_to(const Planar_point<FT>& p) const
  {
    if(sees(p))
      return point.distance_to(p);
    const Planar_point<FT>& q = left(p) < 0 ? left_end : right_end;
    return point.distance_to(q) + distance(p, q);
  }
};

// The sides of the cones of images, column by column.
template <typename FT>
class Cone_columns
{
public:
  void clear()
  {
    for(std::vector<FT>& c : m_column)
      c.clear();
  }

  void add(const Site_image<FT>& g)
  {
    const FT far_away = std::numeric_limits<FT>::infinity();
    const Half_plane<FT> everything{FT(0), FT(0), far_away};
    const Half_plane<FT> &l = g.has_cone ? g.left : everything, &r = g.has_cone ? g.right : everything;
    const std::array<FT, 6> row{l.a, l.b, l.c, r.a, r.b, r.c};
    for(std::size_t k = 0; k < 6; ++k)
      m_column[k].push_back(row[k]);
  }

  // How far each cone is from p at least, as a negative number; not negative if p is in it.
  void find_margins(const Planar_point<FT>& p, std::vector<FT>& margins) const
  {
    const std::size_t n = m_column[0].size();
    margins.resize(n);
    const FT *la = m_column[0].data(), *lb = m_column[1].data(), *lc = m_column[2].data();
    const FT *ra = m_column[3].data(), *rb = m_column[4].data(), *rc = m_column[5].data();
    FT* const m = margins.data();
    for(std::size_t i = 0; i < n; ++i)
    {
      const FT l = la[i] * p.x + lb[i] * p.y + lc[i], r = ra[i] * p.x + rb[i] * p.y + rc[i];
      m[i] = l < r ? l : r;
    }
  }

private:
  std::array<std::vector<FT>, 6> m_column;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_SITE_IMAGE_H
