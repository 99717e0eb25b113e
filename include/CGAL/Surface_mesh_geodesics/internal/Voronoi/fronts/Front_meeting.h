// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_MEETING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_MEETING_H

// The point where the fronts of three cells meet: a vertex of the diagram.
//
// Two adjacent fronts f and g have a cell in common, that of f.right = g.left, which ends where they meet; f.left and
// g.right are the other two sites.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Cell_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Face_images.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Newton_refinement.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Answers two questions: whether the traces of f and g meet (agree(), is_vertex()), and where (common_end(), and
// best_vertex() if they do not meet). Whether f and g may be joined at all is a matter of their sites alone
// (Face_partition.h).
//
// Refers to the images of a face, which must not change meanwhile. All functions require that both fronts have been
// traced in that face, and that g follows f counterclockwise: f.right == g.left.
template <typename FT_>
class Front_meeting
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Front = Cell_front<FT>;

  explicit Front_meeting(const Face_images<FT>& images) : m_images(images) {}

  // Returns whether the trace of each of two adjacent fronts ends at the cell on the other side of the other one.
  static bool agree(const Front& f, const Front& g)
  {
    return f.stop == Front_stop::SITE && g.stop == Front_stop::SITE && f.third == g.right && g.third == f.left;
  }

  // Returns the point where two fronts that agree meet: equally far from the three images at the end of f, refined from
  // the middle between both ends. It is that middle if paths bend at the end of f.
  //
  // Where curves run along the border of the face or touch it, the refined point is not well known and may be outside.
  // Then it is the one of the four start and end points in the face at which the three distances differ least.
  // Requires: agree(f, g).
  Point common_end(const Front& f, const Front& g) const
  {
    const Point middle = midpoint(f.end, g.end);
    std::array<Additively_weighted_point<FT>, 3> point;
    if(!find_points_at_end(f, point))
      return middle;
    Point best = polished_vertex(point[0], point[1], point[2], middle, m_images.size());
    if(m_images.is_in_face(best))
      return best;
    FT smallest = std::numeric_limits<FT>::infinity();
    for(const Point* p : {&f.end, &g.end, &f.p, &g.p})
    {
      const FT a = point[0].distance_to(*p), b = point[1].distance_to(*p), c = point[2].distance_to(*p);
      const FT difference = (std::max)({a, b, c}) - (std::min)({a, b, c});
      if(m_images.is_in_face(*p) && difference < smallest)
      {
        best = *p;
        smallest = difference;
      }
    }
    return best;
  }

  // Returns whether the three cells of two fronts tie at v, up to rounding, and no other site is nearer.
  bool is_vertex(const Front& f, const Front& g, const Point& v) const
  {
    const FT rounding = m_images.width() + Tolerance<FT>::tie() * m_images.distance_from(f.right, v);
    return excess_at(v, {f.left, f.right, g.right}) <= rounding;
  }

  // Returns the best vertex for two fronts that do not meet, of all points where their pieces start and end. The cost
  // of a point is the amount by which the farthest of the three sites is farther than the nearest of all, plus the
  // distances of the point from both fronts: zero, up to rounding, for a true vertex that both traces reach. The first
  // point of the smallest cost is taken. Takes time linear in the number of these points, times that of images and
  // pieces.
  Point best_vertex(const Front& f, const Front& g) const
  {
    Point best = f.p;
    FT smallest = std::numeric_limits<FT>::infinity();
    const auto try_point = [&](const Point& p)
    {
      const FT cost = excess_at(p, {f.left, f.right, g.right}) + f.distance_from(p) + g.distance_from(p);
      if(!(cost < smallest))
        return;
      best = p;
      smallest = cost;
    };
    for(const Front* front : {&f, &g})
    {
      try_point(front->end);
      for(const Front_piece<FT>& piece : front->pieces)
        try_point(piece.end);
      try_point(front->p);
    }
    return best;
  }

private:
  // Returns how much farther the farthest of some sites is from p than the nearest of all sites. Not negative
  // beyond rounding. A site without an image tells nothing: its paths come from other faces only, and its cell has no
  // width here.
  FT excess_at(const Point& p, const std::array<Vertex_id, 3>& sites) const
  {
    FT nearest = std::numeric_limits<FT>::infinity();
    for(const Site_image<FT>& image : m_images.all())
      nearest = (std::min)(nearest, image.distance_to(p));
    FT farthest = nearest;
    for(const Vertex_id site : sites)
    {
      const FT d = m_images.distance_from(site, p);
      if(d < std::numeric_limits<FT>::infinity())
        farthest = (std::max)(farthest, d);
    }
    return farthest - nearest;
  }

  // Finds the images of the three sites at the end of a front that meets a third site: of its left, its right and the
  // third one. Returns false if the paths of one of them bend there (its index is that of a bend, which lives in the
  // tracer).
  bool find_points_at_end(const Front& f, std::array<Additively_weighted_point<FT>, 3>& point) const
  {
    const std::array<std::size_t, 3> index{f.left_image, f.right_image, f.third_image};
    for(std::size_t i = 0; i < 3; ++i)
    {
      if(index[i] >= m_images.number())
        return false;
      point[i] = m_images[index[i]].point;
    }
    return true;
  }

  const Face_images<FT>& m_images;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_MEETING_H
