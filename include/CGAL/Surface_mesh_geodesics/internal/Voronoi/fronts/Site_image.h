// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_SITE_IMAGE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_SITE_IMAGE_H

// The images of sites as one face sees them. Every shortest path that ends in a face has a last straight piece. It
// starts at a corner of the face, or at a pseudo-source outside; then it enters through the interval of a window.
// Unfolded into the plane of the face, that pseudo-source is a point: a site image. The cells in the face are the
// additively weighted Voronoi diagram of its site images, each restricted to its cone.
//
// site_images_of_face.h makes the images; here is only what they answer. All lengths are in the unit of the intrinsic
// mesh.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A point from which straight paths come into a face, in the layout of the face. The image of the inside of a segment
// of a curve is a point at infinity, as its paths are parallel. Its cone is the strip of these paths.
//
// The point of a window sees the part of the face in its cone: the points whose straight path to it passes the interval
// of the window, from `left_end` to `right_end` as seen from the point. Paths to other points of the face bend at the
// nearer end of the interval. A corner of the face has no cone and sees all of the face; a bend (Face_images::bend())
// has none either, and stands for paths to one side of a cone only.
template <typename FT>
struct Site_image
{
  // The weight is the distance of the pseudo-source from the site, with the offset of the site.
  Additively_weighted_point<FT> point;
  Vertex_id site = null_id; // the vertex of the site whose cell the paths belong to
  bool has_cone = false;
  // Valid if has_cone. The two sides of the cone: both are positive inside, and their values are signed distances.
  Half_plane<FT> left, right;
  Planar_point<FT> left_end, right_end; // each lies on its side of the cone

  // Returns whether p is in the cone, or outside by not more than `tolerance` (a length).
  bool sees(const Planar_point<FT>& p, const FT& tolerance = 0) const
  {
    return !has_cone || (left(p) >= -tolerance && right(p) >= -tolerance);
  }

  // Returns the length of the shortest path from the site to p through the interval: straight from the point if it sees
  // p, else around the end of the interval toward p. Requires: p is in the face, up to rounding.
  FT distance_to(const Planar_point<FT>& p) const
  {
    return sees(p) ? point.distance_to(p) : (std::min)(distance_around(left_end, p), distance_around(right_end, p));
  }

  // Returns the end of the interval around which paths to p are shorter: the end on the side of the cone beyond which p
  // is, or to which it is nearer. The lengths decide first: where the point lies on the line of the interval, both
  // sides of the cone are that line, and rounding puts p beyond either of them. Requires: has_cone.
  const Planar_point<FT>& end_toward(const Planar_point<FT>& p) const
  {
    const FT around_left = distance_around(left_end, p), around_right = distance_around(right_end, p);
    if(is_clearly_less(around_left, around_right))
      return left_end;
    if(is_clearly_less(around_right, around_left))
      return right_end;
    return left(p) < right(p) ? left_end : right_end;
  }

private:
  FT distance_around(const Planar_point<FT>& end, const Planar_point<FT>& p) const
  {
    return point.distance_to(end) + distance(p, end);
  }
};

// The sides of the cones of many images as a structure of arrays, so that the compiler tests several cones at a time.
// Cone i is that of the i-th image that was added.
template <typename FT>
class Cone_columns
{
public:
  void clear()
  {
    for(std::vector<FT>& c : m_column)
      c.clear();
  }

  // Appends a cone; an image without a cone gets one that contains everything: its margin is infinite at each point.
  void add(const Site_image<FT>& image)
  {
    const FT unbounded = std::numeric_limits<FT>::infinity();
    const Half_plane<FT> everything{FT(0), FT(0), unbounded};
    const Half_plane<FT> &l = image.has_cone ? image.left : everything, &r = image.has_cone ? image.right : everything;
    const std::array<FT, 6> row{l.a, l.b, l.c, r.a, r.b, r.c};
    for(std::size_t k = 0; k < 6; ++k)
      m_column[k].push_back(row[k]);
  }

  // Sets margins[i] for the i-th cone: the smaller one of the signed distances of p from its two sides. It is not
  // negative if p is in the cone; else p is at least -margins[i] away from it.
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
  std::array<std::vector<FT>, 6> m_column; // a, b, c of the left sides, then of the right ones (Half_plane)
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_SITE_IMAGE_H
