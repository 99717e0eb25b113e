// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_COMPLETION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_COMPLETION_H

// Leads a front to the point where it is known to end: the start of another front, or a vertex.
//
// Traces end close to that point, up to rounding. Where they do not (two sites tie in a region, or many images tie),
// the rest is drawn as segments, each of them with images that really are the nearest ones along it.
//
// In the order in which Face_partition calls them: end_at() after a trace that was to arrive at p; lead_to() if no
// piece leads through the end; then, while arcs are made, is_taken_over_before(), lead_back() and
// add_straight_pieces().

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Cell_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Face_images.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Refers to the images of a face, which must not change meanwhile. Functions that lead f elsewhere leave its pieces so
// that each one starts where the one before ends; Face_partition::finish() makes arcs of them. f.stop tells it whether
// the last piece may be drawn on to the end (OUTSIDE) or segments have to be added (LOST).
template <typename FT_>
class Front_completion
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Front = Cell_front<FT>;
  using Piece = Front_piece<FT>;

  explicit Front_completion(const Face_images<FT>& images) : m_images(images) {}

  // Lets f end at the end of the first piece that touches p, if there is one: a curve along the border may have passed
  // its end. Drops the pieces behind it.
  void end_at(Front& f, const Point& p) const
  {
    const auto piece = std::find_if(f.pieces.begin(), f.pieces.end(),
                                    [&](const Piece& q) { return distance(q.end, p) <= m_images.touching(); });
    if(piece == f.pieces.end())
      return;
    f.pieces.erase(piece + 1, f.pieces.end());
    f.end = piece->end;
    f.stop = Front_stop::OUTSIDE;
  }

  // Ends the front at v if a piece leads to v or through it and its images are still the nearest ones there; returns
  // whether that is so. (Where two sites nearly tie, a trace may have met a third cell behind the vertex v. Two images
  // that nearly coincide are equally far from points at some distance from their curve, too, which other paths may
  // reach first.) Drops the pieces behind that one.
  bool cut_at(Front& f, const Point& v) const
  {
    std::size_t i = f.piece_through(v);
    if(i == Front::none) // no bisector leads through v, but a piece may end there, or a ray lead through it
      i = f.piece_to(v, m_images.width());
    if(i == Front::none || !(is_nearest_at(f, f.pieces[i].left, v) && is_nearest_at(f, f.pieces[i].right, v)))
      return false;
    end_in_piece(f, i, v);
    return true;
  }

  // Ends the front at v, a point of piece i. Drops the pieces behind that one.
  void end_in_piece(Front& f, std::size_t i, const Point& v) const
  {
    f.pieces.resize(i + 1);
    f.pieces.back().end = v;
    f.stop = Front_stop::OUTSIDE; // the way is known up to v, so that the front is not lost
  }

  // Lets a front that has not found its way to v go straight to it, from where it has been closest: drops the pieces
  // behind that point. If the point touches v, the last piece may be drawn on to v; otherwise segments have to be
  // added.
  void lead_to(Front& f, const Point& v) const
  {
    const std::pair<std::size_t, FT> nearest = f.nearest_end(v);
    f.pieces.resize(nearest.first);
    if(!(nearest.second <= m_images.touching()))
      f.stop = Front_stop::LOST;
  }

  // Returns whether other paths become the shortest ones between the end of the last piece and p. The last piece of a
  // front is drawn on to p though it may end at some distance: points are known up to the square root of rounding only.
  // False for a front without pieces.
  bool is_taken_over_before(const Front& f, const Point& p) const
  {
    if(f.pieces.empty())
      return false;
    const Piece& last = f.pieces.back();
    return distance(last.end, p) > m_images.width()
        && !(is_nearest_at(f, last.left, p) && is_nearest_at(f, last.right, p));
  }

  // Lets a front that ends close to p go straight from where it is closest. Changes nothing if no piece comes close.
  // Unlike lead_to(), it asks for segments because the last piece must not be drawn on (is_taken_over_before()).
  void lead_back(Front& f, const Point& p) const
  {
    const std::pair<std::size_t, FT> nearest = f.nearest_end(p);
    if(!(nearest.second <= m_images.touching()))
      return;
    f.pieces.resize(nearest.first);
    f.stop = Front_stop::LOST;
  }

  // Appends the segment pq to f, divided where other paths become the shortest ones: it is halved until the images of
  // each part are nearest at both of its ends, then adjacent parts with the same images are joined. Parts not longer
  // than width() are not halved. Pieces that f has already are not joined with new ones: they are bisectors, the new
  // ones are segments. Takes at most quadratic time in the number of images.
  // Requires: the pieces of f end at p; f starts there if it has none.
  void add_straight_pieces(Front& f, const Point& p, const Point& q) const
  {
    std::size_t halvings = 8 * m_images.number() + 64; // a bound, in case rounding never lets the ends agree
    std::vector<Point> ends{q}; // of the parts that are still to be added, the next one last
    const std::size_t number_traced = f.pieces.size();
    for(Point from = p; !ends.empty();)
    {
      const Point to = ends.back();
      const Piece piece = straight_piece(f, from, to);
      if(halvings > 0 && distance(from, to) > m_images.width()
         && !(is_nearest_at(f, piece.left, from) && is_nearest_at(f, piece.left, to)))
      {
        --halvings;
        ends.push_back(midpoint(from, to));
        continue;
      }
      ends.pop_back();
      from = to;
      if(f.pieces.size() > number_traced && are_same(f.pieces.back(), piece))
        f.pieces.back().end = to;
      else
        f.pieces.push_back(piece);
    }
  }

private:
  // Returns whether the distance of x by an image is that of the nearer one of the two cells, up to rounding. The cone
  // of the image is not looked at: behind the end of the cone, the distance along the straight line belongs to no path
  // and may be smaller than the nearest one. Then the result is false.
  bool is_nearest_at(const Front& f, const Additively_weighted_point<FT>& point, const Point& x) const
  {
    using std::abs;
    const FT nearest = (std::min)(m_images.distance_from(f.left, x), m_images.distance_from(f.right, x));
    return abs(FT(point.distance_to(x) - nearest)) <= Tolerance<FT>::tie() * nearest + m_images.width();
  }

  // Returns whether two pieces have the same images.
  static bool are_same(const Piece& a, const Piece& b)
  {
    const auto same = [](const Additively_weighted_point<FT>& v, const Additively_weighted_point<FT>& w)
    { return v.x == w.x && v.y == w.y && v.weight == w.weight; };
    return same(a.left, b.left) && same(a.right, b.right);
  }

  // Returns the segment pq as a piece of f, with the images that are nearest at its middle. Where two cells meet along
  // an edge, the paths of one of them may come from the other face only; then the nearer image stands for both.
  // Where rounding parts points that are one, both may: then the nearest image of any cell stands for them.
  // Requires: the face has an image.
  Piece straight_piece(const Front& f, const Point& p, const Point& q) const
  {
    const Point middle = midpoint(p, q);
    const std::size_t none = Front::none;
    std::size_t l = m_images.nearest_of(f.left, middle), r = m_images.nearest_of(f.right, middle);
    if(l == none)
      l = r != none ? r : m_images.nearest(middle);
    if(r == none)
      r = l;
    Piece piece;
    piece.end = q;
    piece.left = m_images.point_toward(m_images[l], middle);
    piece.right = m_images.point_toward(m_images[r], middle);
    const FT at_left = piece.left.distance_to(middle), at_right = piece.right.distance_to(middle);
    if(is_clearly_less(at_left, at_right))
      piece.right = piece.left;
    else if(is_clearly_less(at_right, at_left))
      piece.left = piece.right;
    return piece;
  }

  const Face_images<FT>& m_images;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_COMPLETION_H
