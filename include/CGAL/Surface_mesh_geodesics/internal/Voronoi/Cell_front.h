// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_CELL_FRONT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_CELL_FRONT_H

// The curves between cells in a face while they are traced: where they begin on the border, and how far they have come.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
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

// A breakpoint of the border, where the cell of `right` begins and that of `left` ends if the border is
// followed counterclockwise.
template <typename FT>
struct Border_breakpoint
{
  Planar_point<FT> p;
  Vertex_id left, right;
};

// A piece of the way of a front.
template <typename FT>
struct Front_piece
{
  Additively_weighted_point<FT> left, right;
  Planar_point<FT> end;
};

// Why a front ends: at the cell of a third site, where it leaves what it is traced in, or because numbers do not tell
// how it goes on.
enum class Front_stop { NOT_TRACED, SITE, OUTSIDE, LOST };

// The way of the curve between two cells from a point of the face on, as far as it has been traced.
template <typename FT>
struct Cell_front
{
  using Point = Planar_point<FT>;
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  Vertex_id left, right; // the sites
  Point p;               // where it begins, which is a node of the partition
  std::size_t node;
  // how it goes on, if it has been traced
  Front_stop stop = Front_stop::NOT_TRACED;
  std::vector<Front_piece<FT>> pieces;
  Point end;
  Vertex_id third = null_id;                       // which it meets
  std::size_t left_image = none, right_image = none; // the images at the end
  std::size_t third_image = none;

  Cell_front(Vertex_id left_site, Vertex_id right_site, const Point& start, std::size_t start_node)
    : left(left_site), right(right_site), p(start), node(start_node)
  {}

  // how many pieces lead to the end of a piece that is nearest to q, and how far that is from q.
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

  // how far q is from the nearest end of a piece, zero if the front leads through q.
  FT distance_from(const Point& q) const
  {
    return piece_through(q) != none ? FT(0) : nearest_end(q).second;
  }

  // the piece of the way that leads through v, `none` if there is none.
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

  // Where two sources nearly tie, a front may have met a third cell behind the vertex v: it ends where it passes v.
  // Returns whether it does.
  bool cut_at(const Point& v)
  {
    const std::size_t i = piece_through(v);
    if(i == none)
      return false;
    pieces.resize(i + 1);
    pieces.back().end = v;
    stop = Front_stop::OUTSIDE; // and is not lost
    return true;
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_CELL_FRONT_H
