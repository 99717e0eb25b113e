// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_CELL_FRONT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_CELL_FRONT_H

// A front: the growing end of the curve between two cells in a face. It starts at a breakpoint of the border, or at a
// vertex of the diagram inside, and advances into the face until it meets the cell of a third site or another front.
//
// Life of a front: Face_partition makes it at a node. Front_tracer::trace() fills in the result, and does so again if
// the cell that the front has met does not count any more. When it is known where the front ends,
// Front_completion shortens or extends the pieces to that point, and Face_partition::finish() makes arcs of them.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A breakpoint as one face sees it, in the layout of the face: walking counterclockwise along the border of the face,
// the cell of `left` ends at p and that of `right` begins. (So `left` is on the left of a front that starts here.)
template <typename FT>
struct Border_breakpoint
{
  Planar_point<FT> p;
  Vertex_id left, right;
};

// A part of the way of a front along which one image of each of the two sites is nearest. It starts where the piece
// before ends, the first one at the start of the front. `left` and `right` are copies of the images, or bends.
template <typename FT>
struct Front_piece
{
  Additively_weighted_point<FT> left, right;
  Planar_point<FT> end;
};

// Why a trace ends: SITE, it meets the cell of a third site; OUTSIDE, it leaves the face or the half-plane that it is
// traced in; LOST, rounding hides how it goes on. NOT_TRACED: there is no result, or it does not count any more, and
// the front has to be traced (again).
enum class Front_stop { NOT_TRACED, SITE, OUTSIDE, LOST };

// The curve between two cells from a node of the partition to where it has been traced.
//
// Invariant: left != right. After a trace, `end` is the end of the last piece, or p if there are no pieces. Functions
// that change the pieces later leave `end` and the images as they were (but Front_completion::end_at() sets `end`).
template <typename FT>
struct Cell_front
{
  using Point = Planar_point<FT>;
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  Vertex_id left, right; // the sites on its two sides
  Point p;               // where it starts
  std::size_t node;      // the node of the partition at p

  // The result of the last trace. With NOT_TRACED, it is that of a trace that does not count any more, or of none: then
  // there are no pieces.
  Front_stop stop = Front_stop::NOT_TRACED;
  std::vector<Front_piece<FT>> pieces;
  Point end;
  Vertex_id third = null_id; // the site whose cell it meets, if stop is SITE; third_image is valid then only
  // The indices of the images at the end; larger than all images where the path bends at the end of an interval.
  std::size_t left_image = none, right_image = none, third_image = none;

  Cell_front(Vertex_id left_site, Vertex_id right_site, const Point& start, std::size_t start_node)
    : left(left_site), right(right_site), p(start), node(start_node)
  {}

  // Returns the number of pieces up to the end of a piece (or the start) that is nearest to q, and its distance from q.
  // So 0 stands for the start; the earliest one counts in a tie. Takes time linear in the number of pieces, like all
  // functions here.
  std::pair<std::size_t, FT> nearest_end(const Point& q) const
  {
    std::pair<std::size_t, FT> nearest(0, distance(p, q));
    for(std::size_t i = 0; i < pieces.size(); ++i)
    {
      const FT d = distance(pieces[i].end, q);
      if(d < nearest.second)
        nearest = std::make_pair(i + 1, d);
    }
    return nearest;
  }

  // Returns the index of the first piece that ends at q or, along a ray, leads past q, within a tolerance; `none` if no
  // piece does.
  std::size_t piece_to(const Point& q, const FT& tolerance) const
  {
    Point from = p;
    for(std::size_t i = 0; i < pieces.size(); ++i)
    {
      const Front_piece<FT>& piece = pieces[i];
      const bool is_ray = Weighted_bisector<FT>(piece.left, piece.right, from).is_ray();
      if((is_ray ? distance_from_segment(q, from, piece.end) : distance(q, piece.end)) <= tolerance)
        return i;
      from = piece.end;
    }
    return none;
  }

  // Returns the distance of q from the nearest end of a piece, zero if a piece leads through q.
  FT distance_from(const Point& q) const
  {
    return piece_through(q) != none ? FT(0) : nearest_end(q).second;
  }

  // Returns the index of the piece that leads through v, up to rounding; `none` if no piece does. A piece leads through
  // v if v is equally far from both of its images, and lies between the ends of the piece as measured along the tangent
  // of the bisector at v. (A ray has no valid bisector: no piece along one counts.)
  std::size_t piece_through(const Point& v) const
  {
    using std::abs;
    Point from = p;
    for(std::size_t i = 0; i < pieces.size(); ++i)
    {
      const Front_piece<FT>& piece = pieces[i];
      const Weighted_bisector<FT> curve(piece.left, piece.right, v);
      const FT at_left = piece.left.distance_to(v), at_right = piece.right.distance_to(v);
      const Point u = curve.tangent();
      const auto along = [&](const Point& q) { return (q.x - v.x) * u.x + (q.y - v.y) * u.y; };
      if(curve.is_valid() && abs(FT(at_left - at_right)) <= Tolerance<FT>::tie() * at_left
         && along(from) <= 0 && along(piece.end) > 0)
        return i;
      from = piece.end;
    }
    return none;
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_CELL_FRONT_H
