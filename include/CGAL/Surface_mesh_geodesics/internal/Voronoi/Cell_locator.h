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

// The cell in which a point of a face is, by the arcs in the face alone: no windows are left when the diagram has
// been built.
//
// At a point that is nearly on an arc, the images of the arc are the nearest ones, and are compared. Any
// other point is joined to a target: a point of the border of the face, whose cell is known, or a point of an
// arc, whose cells are. The arc that this way meets first tells the cell. On symmetric surfaces arcs run along
// edges and meet in corners and in the middles of faces, and rounding decides what a way meets there: of
// several ways the one is taken that is farthest from the ends of arcs, and whose target is farthest from arcs.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
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

template <typename FT_>
class Cell_locator
{
public:
  using FT = FT_;
  using Complex = Voronoi_complex<FT>;
  using Point = Planar_point<FT>;
  using Arc = Voronoi_arc<FT>;

  // for a point in the layout of a face.
  Cell_locator(const Complex& complex, Face_id f, const Point& p)
    : m_complex(complex), m_face(f), m_p(p), m_range(complex.arcs_of_face(f))
  {}

  // a site whose cell the point is in, null_id if there is none. Points of arcs are in several cells.
  Vertex_id cell() const
  {
    if(m_range.first == m_range.second)
      return m_complex.owner_of_undivided(m_face);
    const std::array<Point, 3> corner = m_complex.layout(m_face);
    if(corner[2].y <= resolution()) // all ways are on one line
      return cell_on_border();
    const Vertex_id site = cell_on_arcs();
    return site == null_id ? cell_on_the_way(best_target()) : site;
  }

private:
  // A point and the cell that the way from it to p begins in.
  struct Target
  {
    Point point;
    Vertex_id site = null_id;
    FT clearance = -1;
  };

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

  // the cell of the nearest piece of the border.
  Vertex_id cell_on_border() const
  {
    Nearest_site nearest;
    m_complex.for_each_border_interval(m_face, [&](Vertex_id site, const Point& from, const Point& to)
    { nearest.add(site, distance_from_segment(m_p, from, to)); });
    return nearest.site;
  }

  // the nearest site of the arcs that p is on, but for rounding; null_id if it is on none.
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

  // from a point of the arc that is the nearest one if x is near to the arc.
  FT distance_from_arc(const Point& x, const Arc& a) const
  {
    const FT to_ends = (std::min)(distance(x, a.first), distance(x, a.last));
    const Weighted_bisector<FT> curve(a.left, a.right, a.first);
    if(!is_curved(a, curve))
      return (std::min)(to_ends, distance_from_segment(x, a.first, a.last));
    const FT t = curve.angle(x);
    return t > 0 && t < curve.angle(a.last) ? (std::min)(to_ends, distance(x, curve.point_at_angle(t))) : to_ends;
  }

  // the first kind of target that has a clear one: corners, points of the border, points of arcs.
  Target best_target() const
  {
    Target best;
    const std::array<FT, 4> parameters{FT(0), FT(1) / 2, FT(3) / 8, FT(11) / 16};
    for(std::size_t i = 0; i < parameters.size() && !(best.clearance > resolution()); ++i)
      add_targets_on_border(parameters[i], best);
    for(std::size_t i = 1; i < parameters.size() && !(best.clearance > resolution()); ++i)
      for_each_arc([&](const Arc& a) { add_target_on_arc(a, parameters[i], best); });
    return best;
  }

  void add_targets_on_border(const FT& t, Target& best) const
  {
    m_complex.for_each_border_interval(m_face, [&](Vertex_id site, const Point& from, const Point& to)
    {
      const Point q{FT(from.x + t * (to.x - from.x)), FT(from.y + t * (to.y - from.y))};
      add_target(q, site, nullptr, best);
    });
  }

  void add_target_on_arc(const Arc& a, const FT& t, Target& best) const
  {
    const Weighted_bisector<FT> curve(a.left, a.right, a.first);
    const Point q = is_curved(a, curve) ? curve.point_at_angle(t * curve.angle(a.last))
                                        : Point{FT(a.first.x + t * (a.last.x - a.first.x)),
                                                FT(a.first.y + t * (a.last.y - a.first.y))};
    add_target(q, site_towards_p(a, curve, q), &a, best);
  }

  void add_target(const Point& q, Vertex_id site, const Arc* own, Target& best) const
  {
    const FT clearance = clearance_of(q, own, best.clearance);
    if(clearance > best.clearance)
      best = Target{q, site, clearance};
  }

  // the smallest distance of an end of an arc from the way to q, or of q from an arc that it is not meant to be on; or
  // less, as soon as it is known to be not larger than `bound`: most targets need a look at few arcs only.
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

  Vertex_id cell_on_the_way(const Target& target) const
  {
    Vertex_id site = target.site;
    FT first = distance(m_p, target.point);
    for_each_arc([&](const Arc& a) { meet_arc(a, target.point, site, first); });
    return site;
  }

  // If the way from p to q meets the arc before `first`, p is in the cell on that side, unless it meets another arc
  // before.
  void meet_arc(const Arc& a, const Point& q, Vertex_id& site, FT& first) const
  {
    const Half_plane<FT> way = Half_plane<FT>::left_of(m_p, q);
    const Weighted_bisector<FT> curve(a.left, a.right, a.first);
    const auto meet = [&](const Point& x)
    {
      const FT along = (x.x - m_p.x) * way.b - (x.y - m_p.y) * way.a;
      if(!(along >= 0 && along < first))
        return;
      first = along;
      site = site_towards_p(a, curve, x);
    };
    if(!is_curved(a, curve))
    {
      const FT from = way(a.first), to = way(a.last);
      if((from < 0) == (to < 0))
        return;
      const FT t = from / (from - to);
      const Point x{FT(a.first.x + t * (a.last.x - a.first.x)), FT(a.first.y + t * (a.last.y - a.first.y))};
      meet(x);
      return;
    }
    using std::atan;
    const FT end = curve.angle(a.last);
    for(const FT& t : curve.side(way).positive_roots())
      if(t < std::numeric_limits<FT>::infinity() && atan(t) <= end)
        meet(curve.point(t));
  }

  // the cell on the side of p of a point x of an arc.
  Vertex_id site_towards_p(const Arc& a, const Weighted_bisector<FT>& curve, const Point& x) const
  {
    if(!is_curved(a, curve))
      return Half_plane<FT>::left_of(a.first, a.last)(m_p) > 0 ? a.left_site : a.right_site;
    const Point y{FT(x.x + (m_p.x - x.x) / 1024), FT(x.y + (m_p.y - x.y) / 1024)};
    return a.left.distance_to(y) < a.right.distance_to(y) ? a.left_site : a.right_site;
  }

  // what is nearer is not told apart.
  FT resolution() const
  {
    const std::array<Point, 3> corner = m_complex.layout(m_face);
    return Tolerance<FT>::closeness()
         * (std::max)({distance(corner[0], corner[1]), distance(corner[1], corner[2]), distance(corner[2], corner[0])});
  }

  // Else the arc is the segment between its ends, or cannot be told from it; the parameters of a hyperbola that is
  // nearly a ray are too small to tell its ends, and if its images are nearly one, rounding moves it away from
  // them.
  bool is_curved(const Arc& a, const Weighted_bisector<FT>& curve) const
  {
    using std::abs;
    if(!a.is_bisector || !curve.is_curved())
      return false;
    const FT end = curve.angle(a.last), chord = distance(a.first, a.last);
    if(!(distance(curve.point_at_angle(end), a.last) <= Tolerance<FT>::touching() * chord))
      return false;
    const Point middle = curve.point_at_angle(end / 2);
    return abs(Half_plane<FT>::left_of(a.first, a.last)(middle)) > resolution() || !(chord > resolution());
  }

  static FT distance_from_segment(const Point& x, const Point& p, const Point& q)
  {
    const FT dx = q.x - p.x, dy = q.y - p.y, square = dx * dx + dy * dy;
    FT t = square > 0 ? FT(((x.x - p.x) * dx + (x.y - p.y) * dy) / square) : FT(0);
    t = (std::min)((std::max)(t, FT(0)), FT(1));
    return distance(x, Point{FT(p.x + t * dx), FT(p.y + t * dy)});
  }

  template <typename Visitor>
  void for_each_arc(Visitor visit) const
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
