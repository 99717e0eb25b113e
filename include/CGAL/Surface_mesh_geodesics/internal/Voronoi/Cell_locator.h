// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_CELL_LOCATOR_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_CELL_LOCATOR_H

// Finds the cell of a point of a face, from the arcs in the face alone: when a diagram has been built, no windows are
// left.
//
// If the point is on an arc up to rounding, the images of the arc are the nearest ones and are compared. Any other
// point is joined to an anchor by a segment; anchors are points of the border, whose cells are known, and points of
// arcs. The arc that the segment meets first, as seen from the point, tells the cell.
//
// On symmetric surfaces, arcs run along edges and meet in corners and in the middles of faces, where rounding decides
// what a segment meets. So of several anchors the one with the largest clearance is taken: the distance of the segment
// from the ends of arcs, and of the anchor from other arcs.
//
// The cases in the order of cell(): a face without arcs has one cell; in a face without height cell_on_border()
// decides; cell_on_arcs() looks for arcs at the point; else best_anchor() and cell_on_the_way() do the rest.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Locates one point. No bound is known for the distance from an arc within which the result may be the cell on the
// other side; it is about resolution(), and both sites are equally far there up to rounding.
template <typename FT_>
class Cell_locator
{
public:
  using FT = FT_;
  using Complex = Voronoi_complex<FT>;
  using Point = Planar_point<FT>;
  using Arc = Voronoi_arc<FT>;

  // Prepares to locate a point p in the layout of face f. The complex is referred to.
  // Requires: the complex is finished, and p is in the face up to rounding.
  Cell_locator(const Complex& complex, Face_id f, const Point& p)
    : m_complex(complex), m_face(f), m_p(p), m_range(complex.arcs_of_face(f))
  {}

  // Returns the site of a cell that the point is in, null_id if the face is not reached. A point of an arc is in
  // several cells: the nearer site of its images is returned, the left one in a tie. Takes quadratic time in the number
  // of arcs in the face at most, linear time for most points.
  Vertex_id cell() const
  {
    if(m_range.first == m_range.second)
      return m_complex.owner_of_undivided(m_face);
    const std::array<Point, 3> corner = m_complex.layout(m_face);
    if(corner[2].y <= resolution()) // in a face without height all segments are on one line
      return cell_on_border();
    const Vertex_id site = cell_on_arcs();
    return site == null_id ? cell_on_the_way(best_anchor()) : site;
  }

private:
  // A point, and the cell in which the segment from it to p starts. The clearance is -1 as long as there is none: any
  // anchor is better, since clearances are not negative.
  struct Anchor
  {
    Point point;
    Vertex_id site = null_id;
    FT clearance = -1;
  };

  // The nearest one of some sites; the first one in a tie.
  struct Nearest_site
  {
    Vertex_id site = null_id;
    FT distance = std::numeric_limits<FT>::infinity();

    void add(Vertex_id s, const FT& d)
    {
      if(d < distance)
      {
        site = s;
        distance = d;
      }
    }
  };

  // Returns the cell of the nearest part of the border.
  Vertex_id cell_on_border() const
  {
    Nearest_site nearest;
    m_complex.for_each_border_interval(m_face, [&](Vertex_id site, const Point& from, const Point& to)
    { nearest.add(site, distance_from_segment(m_p, from, to)); });
    return nearest.site;
  }

  // Returns the nearest site of the arcs that p is on up to rounding, null_id if p is on none.
  Vertex_id cell_on_arcs() const
  {
    Nearest_site nearest;
    for_each_arc([&](const Arc& a)
    {
      if(!(distance_from_arc(m_p, a) <= resolution()))
        return;
      nearest.add(a.left_site, a.left.distance_to(m_p));
      nearest.add(a.right_site, a.right.distance_to(m_p));
    });
    return nearest.site;
  }

  // Returns the distance of x from a point of an arc, which is the nearest one if x is close to the arc: an end, or the
  // point that Weighted_bisector::angle_near() finds. So the result is never too small: a clearance may be overrated,
  // but no point is taken for one of an arc that it is not on.
  FT distance_from_arc(const Point& x, const Arc& a) const
  {
    const FT to_ends = (std::min)(distance(x, a.first), distance(x, a.last));
    const Weighted_bisector<FT> curve(a.left, a.right, a.first);
    if(!is_curved(a, curve))
      return (std::min)(to_ends, distance_from_segment(x, a.first, a.last));
    const FT t = curve.angle_near(x);
    return t > 0 && t < curve.angle_near(a.last) ? (std::min)(to_ends, distance(x, curve.point_at_angle(t))) : to_ends;
  }

  // Returns the best anchor of the first kind in which one has a clearance: corners, points of the border, points of
  // arcs. If none has, the best of all; its result may be wrong where rounding decides what the segment meets. (At
  // parameter 0 the breakpoints are tried with the corners; arcs end there, so their clearance is 0.)
  Anchor best_anchor() const
  {
    Anchor best;
    const std::array<FT, 4> parameters{FT(0), FT(1) / 2, FT(3) / 8, FT(11) / 16};
    for(std::size_t i = 0; i < parameters.size() && !(best.clearance > resolution()); ++i)
      add_anchors_on_border(parameters[i], best);
    for(std::size_t i = 1; i < parameters.size() && !(best.clearance > resolution()); ++i)
      for_each_arc([&](const Arc& a) { add_anchor_on_arc(a, parameters[i], best); });
    return best;
  }

  // Tries the points at parameter t of all parts of the border as anchors.
  void add_anchors_on_border(const FT& t, Anchor& best) const
  {
    m_complex.for_each_border_interval(m_face, [&](Vertex_id site, const Point& from, const Point& to)
    {
      const Point q{FT(from.x + t * (to.x - from.x)), FT(from.y + t * (to.y - from.y))};
      add_anchor(q, site, nullptr, best);
    });
  }

  // Tries the point at parameter t of an arc as an anchor. The segment starts there in the cell on the side of p.
  void add_anchor_on_arc(const Arc& a, const FT& t, Anchor& best) const
  {
    using std::tan;
    const Weighted_bisector<FT> curve(a.left, a.right, a.first);
    if(is_curved(a, curve))
    {
      const FT parameter = tan(t * curve.angle_near(a.last));
      add_anchor(curve.point(parameter), site_beside_curve(a, curve, parameter), &a, best);
      return;
    }
    const Point q{FT(a.first.x + t * (a.last.x - a.first.x)), FT(a.first.y + t * (a.last.y - a.first.y))};
    add_anchor(q, site_beside_segment(a), &a, best);
  }

  // Keeps the anchor q if its clearance is larger than that of the best one.
  void add_anchor(const Point& q, Vertex_id site, const Arc* own, Anchor& best) const
  {
    const FT clearance = clearance_of(q, own, best.clearance);
    if(clearance > best.clearance)
      best = Anchor{q, site, clearance};
  }

  // Returns the clearance of an anchor q: the smallest distance of the end of an arc from the segment to q, and of q
  // from an arc other than its own (null for an anchor on the border). Stops with a larger value as soon as the
  // clearance is known to be at most `bound`, so that most anchors look at few arcs.
  FT clearance_of(const Point& q, const Arc* own, const FT& bound) const
  {
    FT smallest = std::numeric_limits<FT>::infinity();
    for(std::uint32_t a = m_range.first; a < m_range.second && smallest > bound; ++a)
    {
      const Arc& arc = m_complex.arcs()[a];
      smallest
        = (std::min)({smallest, distance_from_segment(arc.first, m_p, q), distance_from_segment(arc.last, m_p, q)});
    }
    for(std::uint32_t a = m_range.first; a < m_range.second && smallest > bound; ++a)
      if(&m_complex.arcs()[a] != own)
        smallest = (std::min)(smallest, distance_from_arc(q, m_complex.arcs()[a]));
    return smallest;
  }

  // Where the segment from p to the anchor meets an arc: how far from p, and the cell on the side of p with its image.
  // The anchor itself has no image.
  struct Crossing
  {
    FT way;
    Vertex_id site;
    const Additively_weighted_point<FT>* image = nullptr;
  };

  // Returns the cell of p, given an anchor: of the arc that the segment meets nearest to p, the cell on the side of p;
  // the cell of the anchor if the segment meets no arc.
  Vertex_id cell_on_the_way(const Anchor& anchor) const
  {
    Crossing nearest{distance(m_p, anchor.point), anchor.site};
    for_each_arc([&](const Arc& a) { meet_arc(a, anchor.point, nearest); });
    return nearest.site;
  }

  // Replaces `nearest` by where the segment from p to q meets the arc, if that comes first (is_before()). An arc meets
  // the line of the segment where way() is 0: once if it is a segment, at most twice if it is a piece of a hyperbola.
  // (way.b, -way.a) is the unit vector from p to q.
  void meet_arc(const Arc& a, const Point& q, Crossing& nearest) const
  {
    const Half_plane<FT> way = Half_plane<FT>::left_of(m_p, q);
    const Weighted_bisector<FT> curve(a.left, a.right, a.first);
    const auto meet = [&](const Point& x, bool is_on_left)
    {
      const Crossing c{FT((x.x - m_p.x) * way.b - (x.y - m_p.y) * way.a), is_on_left ? a.left_site : a.right_site,
                       is_on_left ? &a.left : &a.right};
      if(c.way >= 0 && is_before(c, nearest, way))
        nearest = c;
    };
    if(!is_curved(a, curve))
    {
      const FT from = way(a.first), to = way(a.last);
      if((from < 0) == (to < 0))
        return;
      const FT t = from / (from - to);
      meet(Point{FT(a.first.x + t * (a.last.x - a.first.x)), FT(a.first.y + t * (a.last.y - a.first.y))},
           is_left_of_segment(a));
      return;
    }
    using std::atan;
    const FT end = curve.angle_near(a.last);
    for(const FT& t : curve.side(way).positive_roots())
      if(t < std::numeric_limits<FT>::infinity() && atan(t) <= end && crosses(curve, t, way))
        meet(curve.point(t), is_left_of_curve(curve, t));
  }

  // Returns whether the curve crosses the line that it meets at parameter t. A curve that only touches the line stays
  // on one side of it.
  bool crosses(const Weighted_bisector<FT>& curve, const FT& t, const Half_plane<FT>& line) const
  {
    using std::abs;
    const Point u = curve.derivative(t);
    return abs(FT(u.x * line.a + u.y * line.b)) > Tolerance<FT>::closeness() * norm(u.x, u.y);
  }

  // Returns whether the crossing c comes before d on the way from p. The two arcs beside a cell without width are in
  // one place: of their cells, the one comes first whose image is nearer to a point a bit closer to p. (A tie keeps d.)
  bool is_before(const Crossing& c, const Crossing& d, const Half_plane<FT>& way) const
  {
    using std::abs;
    if(d.image == nullptr || abs(FT(c.way - d.way)) > resolution())
      return c.way < d.way;
    const FT t = d.way * (1 - Tolerance<FT>::look_ahead());
    const Point beside{FT(m_p.x + t * way.b), FT(m_p.y - t * way.a)};
    return c.image->distance_to(beside) < d.image->distance_to(beside);
  }

  // Return the cell of an arc on the side of p, as seen from its point at parameter t. Ties go to the right site.
  //
  // The tangent tells the side. (Distances at a point between the two do not: where one image lies almost on the way
  // from the other one, the curve is a hyperbola thinner than any step, and behind it the wrong image is nearer.)
  Vertex_id site_beside_curve(const Arc& a, const Weighted_bisector<FT>& curve, const FT& t) const
  {
    return is_left_of_curve(curve, t) ? a.left_site : a.right_site;
  }

  Vertex_id site_beside_segment(const Arc& a) const { return is_left_of_segment(a) ? a.left_site : a.right_site; }

  bool is_left_of_curve(const Weighted_bisector<FT>& curve, const FT& t) const
  {
    const Point x = curve.point(t), u = curve.derivative(t);
    return u.x * (m_p.y - x.y) - u.y * (m_p.x - x.x) > 0;
  }

  bool is_left_of_segment(const Arc& a) const { return Half_plane<FT>::left_of(a.first, a.last)(m_p) > 0; }

  // Returns the distance below which two points count as one, in the unit of the layout.
  FT resolution() const
  {
    const std::array<Point, 3> corner = m_complex.layout(m_face);
    return Tolerance<FT>::closeness()
         * (std::max)({distance(corner[0], corner[1]), distance(corner[1], corner[2]), distance(corner[2], corner[0])});
  }

  // Returns whether an arc differs from the segment between its ends. If its images are nearly one point, rounding
  // moves the hyperbola away from its ends.
  bool is_curved(const Arc& a, const Weighted_bisector<FT>& curve) const
  {
    using std::abs;
    if(!a.is_bisector || !curve.is_curved())
      return false;
    const FT end = curve.angle_near(a.last), chord = distance(a.first, a.last);
    if(!(distance(curve.point_at_angle(end), a.last) <= Tolerance<FT>::touching() * chord))
      return false;
    const Point middle = curve.point_at_angle(end / 2);
    return abs(Half_plane<FT>::left_of(a.first, a.last)(middle)) > resolution() || !(chord > resolution());
  }

  // Calls visit(arc) for the arcs in the face.
  template <typename Visit>
  void for_each_arc(Visit visit) const
  {
    for(std::uint32_t a = m_range.first; a < m_range.second; ++a)
      visit(m_complex.arcs()[a]);
  }

  const Complex& m_complex;
  const Face_id m_face;
  const Point m_p;
  const std::pair<std::uint32_t, std::uint32_t> m_range; // of the arcs in the face
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_CELL_LOCATOR_H
