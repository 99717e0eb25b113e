// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONT_TRACER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONT_TRACER_H

// A front between two cells of a face, followed into the face until it meets a third cell or leaves the face.
//
// Along a front the distance is ruled by the image of one window for each of the two sources. The piece of a
// hyperbola ends where another window takes over: where it is nearer, or where the cone of straight
// paths through the window ends.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Cell_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Site_image.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Newton_refinement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT_>
class Front_tracer
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Image = Site_image<FT>;
  using Front = Cell_front<FT>;
  using Breakpoint = Border_breakpoint<FT>;
  static constexpr std::size_t none = Front::none;

  // Images and breakpoints (counterclockwise) are added after a call of start().
  void start(const std::array<Point, 3>& corner)
  {
    m_images.clear();
    m_cones.clear();
    m_breakpoints.clear();
    m_number_of_traces = 0;
    for(unsigned int k = 0; k < 3; ++k)
      m_side[k] = Half_plane<FT>::left_of(corner[k], corner[(k + 1) % 3]);
    m_size = (std::max)({distance(corner[0], corner[1]), distance(corner[1], corner[2]),
                         distance(corner[2], corner[0])});
    m_has_no_height = is_without_height<FT>(m_side[0](corner[2]) * distance(corner[0], corner[1]), m_size);
  }

  void add(const Image& g)
  {
    m_images.push_back(g);
    m_cones.add(g);
  }

  void add(const Breakpoint& b) { m_breakpoints.push_back(b); }

  // Fronts are traced until they meet the cell of one of these sites that is not theirs. They have to be sorted.
  std::vector<Vertex_id>& sites() { return m_sites; }
  const std::vector<Vertex_id>& sites() const { return m_sites; }

  bool has_front(Vertex_id site) const
  {
    if(m_sites.size() == 2)
      return site == m_sites[0] || site == m_sites[1];
    return std::binary_search(m_sites.begin(), m_sites.end(), site);
  }

  const std::vector<Image>& images() const { return m_images; }
  const std::vector<Breakpoint>& breakpoints() const { return m_breakpoints; }
  bool has_no_height() const { return m_has_no_height; }
  const FT& size() const { return m_size; }

  // how often a front has been traced.
  std::size_t number_of_traces() const { return m_number_of_traces; }

  // the image of a source that is nearest to p, `none` if there is none. Of several that tie one that sees
  // p is preferred.
  std::size_t nearest_of(Vertex_id site, const Point& p) const
  {
    std::size_t best = none, best_seeing = none;
    FT best_distance = std::numeric_limits<FT>::infinity(), best_seen = best_distance;
    for(std::size_t i = 0; i < m_images.size(); ++i)
    {
      const Image& g = m_images[i];
      if(g.site != site)
        continue;
      const bool sees = g.sees(p, width());
      const FT d = sees ? g.point.distance_to(p) : g.distance_to(p);
      if(d < best_distance)
      {
        best = i;
        best_distance = d;
      }
      if(sees && d < best_seen)
      {
        best_seeing = i;
        best_seen = d;
      }
    }
    const bool is_tie = best_seen <= best_distance + best_distance * Tolerance<FT>::tie();
    return best_seeing != none && is_tie ? best_seeing : best;
  }

  // Ends of curves that are nearer to each other may be meant to be one.
  FT joining_distance() const { return m_size / 1024; }

  FT touching() const { return Tolerance<FT>::touching() * m_size; }

  // Distances in the face that rounding makes.
  FT width() const { return Tolerance<FT>::interval() * m_size; }

  // the image of the shortest paths from an image to p.
  Additively_weighted_point<FT> image_towards(const Image& g, const Point& p) const
  {
    return g.sees(p, width()) ? g.point : bend(g, p).point;
  }

  bool is_in_face(const Point& p) const
  {
    return std::all_of(m_side.begin(), m_side.end(), [&](const Half_plane<FT>& h) { return h(p) >= -width(); });
  }

  // the half-plane into which g goes.
  bool line_in_front_of(const Front& g, Half_plane<FT>& h) const
  {
    const std::size_t l = nearest_of(g.left, g.p), r = nearest_of(g.right, g.p);
    if(l == none || r == none)
      return false;
    const Weighted_bisector<FT> curve(image_towards(m_images[l], g.p), image_towards(m_images[r], g.p), g.p);
    if(!curve.is_valid() && !curve.is_ray())
      return false;
    const Point t = curve.tangent();
    h = Half_plane<FT>{t.x, t.y, FT(-(t.x * g.p.x + t.y * g.p.y))};
    return true;
  }

  // follows f until it meets a third cell, leaves the face, or leaves the half-plane given.
  void trace(Front& f, const Half_plane<FT>* until)
  {
    ++m_number_of_traces;
    f.pieces.clear();
    f.pieces.reserve(32);
    f.end = f.p;
    f.third = null_id;
    f.stop = m_has_no_height ? Front_stop::OUTSIDE : Front_stop::LOST;
    if(m_has_no_height) // where curves cross it is known from its border only
      return;
    f.left_image = nearest_of(f.left, f.p);
    f.right_image = nearest_of(f.right, f.p);
    if(f.left_image == none || f.right_image == none)
      return;
    m_bends.clear();
    for(std::size_t* last : {&f.left_image, &f.right_image})
      if(!m_images[*last].sees(f.p, width()))
        *last = add_bend(*last, f.p);
    m_slack = width();
    m_left_here.clear();
    std::size_t steps = 4 * m_images.size() + 64, steps_here = 0;
    while(f.stop == Front_stop::LOST && steps-- > 0)
    {
      const Point from = f.end;
      const std::size_t left_before = m_left_here.size();
      if(!step(f, until))
      {
        if(steps_here > m_images.size() || !find_way_ahead(f))
          return;
        steps_here = m_images.size() + 1; // once at a place
        continue;
      }
      m_slack = width();
      if(distance(from, f.end) > 16 * Tolerance<FT>::unit_roundoff() * m_size)
      {
        steps_here = 0;
        m_left_here.erase(m_left_here.begin(), m_left_here.begin() + static_cast<std::ptrdiff_t>(left_before));
      }
      else if(++steps_here > m_images.size() + 8) // rounding goes round in circles
        return;
      // the curve may touch the border only
      if(f.stop == Front_stop::OUTSIDE && !ends_at_breakpoint(f, joining_distance()) && find_way_ahead(f))
        f.stop = Front_stop::LOST;
      else if(f.stop == Front_stop::LOST && ends_at_breakpoint(f, width())) // it runs along the border from here on
        f.stop = Front_stop::OUTSIDE;
    }
  }

private:
  bool ends_at_breakpoint(const Front& f, const FT& tolerance) const
  {
    for(const Breakpoint& l : m_breakpoints)
      if(l.left == f.right && l.right == f.left && distance(l.p, f.end) <= tolerance)
        return true;
    return false;
  }

  // Where several images of a source tie, rounding may have led to one that is not the nearest ahead. Is there a
  // pair of them, of both sources, with a curve into the face that does not turn back? The one that leads farthest is
  // taken. It has to lead somewhere else, but where the front begins any way is one.
  bool find_way_ahead(Front& f)
  {
    m_slack = touching();
    const std::vector<std::size_t> left = tied_images(f.left, f.end), right = tied_images(f.right, f.end);
    FT farthest = distance(f.p, f.end) <= width() ? width() : joining_distance();
    bool is_found = false;
    const std::size_t left_image = f.left_image, right_image = f.right_image;
    for(std::size_t l : left)
      for(std::size_t r : right)
      {
        if(l == left_image && r == right_image)
          continue;
        const FT reach = way_ahead(f.end, l, r, left, right);
        if(!(reach > farthest) || turns_back(f, l, r))
          continue;
        farthest = reach;
        is_found = true;
        f.left_image = l;
        f.right_image = r;
      }
    return is_found;
  }

  // Does the curve of two images at the end of f lead to where f comes from?
  bool turns_back(const Front& f, std::size_t l, std::size_t r) const
  {
    if(f.pieces.empty())
      return false;
    const Point& from = f.pieces.size() > 1 ? f.pieces[f.pieces.size() - 2].end : f.p;
    const Point u = Weighted_bisector<FT>(m_images[l].point, m_images[r].point, f.end).tangent();
    return (f.end.x - from.x) * u.x + (f.end.y - from.y) * u.y < 0;
  }

  // the images of a source that are as near to p as the nearest one.
  std::vector<std::size_t> tied_images(Vertex_id site, const Point& p) const
  {
    std::vector<std::size_t> result;
    FT smallest = std::numeric_limits<FT>::infinity();
    for(const Image& g : m_images)
      if(g.site == site)
        smallest = (std::min)(smallest, g.distance_to(p));
    for(std::size_t i = 0; i < m_images.size(); ++i)
      if(m_images[i].site == site
         && m_images[i].distance_to(p) <= smallest + Tolerance<FT>::tie() * smallest)
        result.push_back(i);
    return result;
  }

  // How far does the curve of two images lead from p into the face, as long as none of the others is nearer?
  FT way_ahead(const Point& p, std::size_t l, std::size_t r, const std::vector<std::size_t>& left,
               const std::vector<std::size_t>& right) const
  {
    const Image &gl = m_images[l], &gr = m_images[r];
    const Weighted_bisector<FT> curve(gl.point, gr.point, p);
    if(!leads_on(curve, gl, gr))
      return 0;
    Event event;
    event.t = curve.end();
    for(const Half_plane<FT>& side : m_side)
      leave(curve, side, Event::BORDER, 0, event);
    for(const Image* g : {&gl, &gr})
      if(g->has_cone)
      {
        leave(curve, g->left, Event::LEFT_CONE, 0, event);
        leave(curve, g->right, Event::RIGHT_CONE, 0, event);
      }
    if(event.kind == Event::NOTHING)
      return 0;
    const Point ahead = curve.point((std::min)(FT(event.t / 2), FT(1) / 1024));
    const auto is_nearest = [&](const Image& g, const std::vector<std::size_t>& others)
    {
      return std::none_of(others.begin(), others.end(), [&](std::size_t i)
      { return m_images[i].sees(ahead) && is_nearer(m_images[i], g, ahead); });
    };
    return is_nearest(gl, left) && is_nearest(gr, right) ? distance(curve.point(event.t), p) : FT(0);
  }

  // What ends a piece.
  struct Event
  {
    enum Kind { NOTHING, BORDER, UNTIL, LEFT_CONE, RIGHT_CONE, NEARER, IMPRECISE } kind = NOTHING;
    FT t = std::numeric_limits<FT>::infinity();
    std::size_t index = 0; // of the side or of the image
    Half_plane<FT> line{};
    FT extent = std::numeric_limits<FT>::infinity(); // see Weighted_bisector
  };

  // Is there a curve with the cells on the sides where they should be? A ray has the image that does not bend
  // on the side that it sees; else the front comes towards the vertex where the ray begins.
  bool leads_on(const Weighted_bisector<FT>& curve, const Image& left, const Image& right) const
  {
    if(!curve.is_ray())
      return curve.is_valid();
    const Point u = curve.tangent(), &p = curve.start();
    const bool is_on_left = !curve.is_left_focus();
    const FT ahead = touching(), aside = is_on_left ? ahead : FT(-ahead);
    const Point q{FT(p.x + ahead * u.x - aside * u.y), FT(p.y + ahead * u.y + aside * u.x)};
    return (is_on_left ? left : right).sees(q);
  }

  // follows one piece; false if that is impossible.
  bool step(Front& f, const Half_plane<FT>* until)
  {
    const Image &left = image(f.left_image), &right = image(f.right_image);
    const Weighted_bisector<FT> curve(left.point, right.point, f.end);
    if(!leads_on(curve, left, right))
      return false;
    Event event;
    event.t = (std::min)(curve.end(), curve.end_of_precision());
    if(event.t < curve.end())
      event.kind = Event::IMPRECISE;
    for(unsigned int k = 0; k < 3; ++k)
      leave(curve, m_side[k], Event::BORDER, k, event);
    const Event at_border = event;
    if(until != nullptr)
      leave_again(curve, *until, event);
    if(left.has_cone)
    {
      leave(curve, left.left, Event::LEFT_CONE, 0, event);
      leave(curve, left.right, Event::LEFT_CONE, 1, event);
    }
    if(right.has_cone)
    {
      leave(curve, right.left, Event::RIGHT_CONE, 0, event);
      leave(curve, right.right, Event::RIGHT_CONE, 1, event);
    }
    // neighbours of the windows first: what they end need not be looked at any farther
    if(event.t < std::numeric_limits<FT>::infinity())
      event.extent = curve.extent(event.t);
    const std::size_t n = m_images.size();
    const FT at_start = left.point.distance_to(f.end);
    const std::array<std::size_t, 4> beside{f.left_image - 1, f.left_image + 1, f.right_image - 1, f.right_image + 1};
    for(std::size_t i : beside)
      if(i < n && may_take_over(f, i))
        be_taken_over(curve, left, at_start, m_images[i], i, event);
    m_cones.find_margins(f.end, m_margins);
    for(std::size_t i = 0; i < n; ++i)
      if(m_margins[i] >= -event.extent && !is_beside(i, f.left_image) && !is_beside(i, f.right_image)
         && may_take_over(f, i))
        be_taken_over(curve, left, at_start, m_images[i], i, event);
    // the paths around the end of the last cone: what goes on may only seem to tie with them there
    if(!m_bends.empty() && may_take_over(f, n + m_bends.size() - 1))
    {
      const Image last = m_bends.back();
      be_taken_over(curve, left, at_start, last, n + m_bends.size() - 1, event);
    }
    if(event.kind == Event::NOTHING)
      return false;
    if(at_border.kind == Event::BORDER && distance(curve.point(at_border.t), curve.point(event.t)) <= width())
      event = at_border;
    Point p = curve.point(event.t);
    if(!(event.t > 0))
      p = f.end;
    else if(event.kind == Event::NEARER && is_third_site(f, event.index))
    {
      const Point q = polished_vertex(left.point, right.point, image(event.index).point, p, m_size);
      p = is_in_face(q) ? q : curve.point((std::min)(event.t, at_border.t));
    }
    else if(event.kind == Event::NEARER || event.kind == Event::IMPRECISE)
      // across the curve only: images of one source may be so near that the place is not well known
      p = polished_crossing(left.point, right.point, line_across(left.point, right.point, p), p, m_size);
    else
      p = polished_crossing(left.point, right.point, event.line, p, m_size);
    f.pieces.push_back(Front_piece<FT>{left.point, right.point, p});
    f.end = p;
    switch(event.kind)
    {
    case Event::LEFT_CONE:
      f.left_image = successor(f.left_image, f.right_image, p);
      break;
    case Event::RIGHT_CONE:
      f.right_image = successor(f.right_image, f.left_image, p);
      break;
    case Event::NEARER:
      meet(f, event.index);
      break;
    case Event::IMPRECISE:
      break;
    default:
      f.stop = Front_stop::OUTSIDE;
    }
    return true;
  }

  bool is_third_site(const Front& f, std::size_t index) const
  {
    const Vertex_id site = image(index).site;
    return site != f.left && site != f.right;
  }

  void meet(Front& f, std::size_t index)
  {
    const Vertex_id site = image(index).site;
    if(!is_third_site(f, index))
    {
      std::size_t& last = site == f.left ? f.left_image : f.right_image;
      m_left_here.push_back(last);
      last = index;
    }
    else
    {
      f.stop = Front_stop::SITE;
      f.third = site;
      f.third_image = index;
    }
  }

  // The curve leaves a half-plane at the first parameter behind which it is outside.
  void leave(const Weighted_bisector<FT>& curve, const Half_plane<FT>& h, typename Event::Kind kind,
             std::size_t index, Event& event) const
  {
    const Quadratic<FT> q = curve.side(h);
    if(event.t < std::numeric_limits<FT>::infinity() && q.is_positive_until(event.t))
      return;
    const std::array<FT, 2> root = q.positive_roots();
    FT from = 0;
    for(unsigned int i = 0; i < 3; ++i)
    {
      const FT to = i < 2 ? (std::min)(root[i], event.t) : event.t;
      if(from < to)
      {
        const FT middle = to < std::numeric_limits<FT>::infinity() ? FT(from + (to - from) / 2)
                                                                    : FT(2 * from + 1);
        // a front that starts on the line may be outside by rounding, and so may one that touches it
        const bool may_be_rounding = !(from > 0) || (i == 1 && to < event.t);
        if(q(middle) < 0 && (!may_be_rounding || h(curve.point(middle)) < -(from > 0 ? width() : m_slack)))
        {
          if(from < event.t)
          {
            event.kind = kind;
            event.t = from;
            event.index = index;
            event.line = h;
          }
          return;
        }
      }
      if(!(to < event.t))
        return;
      from = to;
    }
  }

  static bool is_beside(std::size_t i, std::size_t j) { return i + 1 - j <= 2; } // or the same

  bool may_take_over(const Front& f, std::size_t i) const
  {
    return i != f.left_image && i != f.right_image && has_front(image(i).site);
  }

  // The same for the half-plane in front of the end: a front that starts outside enters it first.
  void leave_again(const Weighted_bisector<FT>& curve, const Half_plane<FT>& until, Event& event) const
  {
    if(until(curve.start()) >= -width())
      return leave(curve, until, Event::UNTIL, 0, event);
    const FT t = curve.side(until).positive_roots()[1];
    if(!(t < event.t))
      return;
    event.kind = Event::UNTIL;
    event.t = t;
    event.line = until;
  }

  // Is g nearer somewhere ahead, where it sees the curve? `at_start` is the distance by `left` at the start.
  void be_taken_over(const Weighted_bisector<FT>& curve, const Image& left, const FT& at_start, const Image& g,
                     std::size_t index, Event& event)
  {
    // first what can be told from the start p of the curve
    const Point& p = curve.start();
    const FT to_g = norm<FT>(p.x - g.point.x, p.y - g.point.y);
    if(g.point.weight + to_g > at_start + 2 * event.extent)
      return;
    Quadratic<FT> in_left{}, in_right{};
    const bool is_bounded = event.t < std::numeric_limits<FT>::infinity();
    if(g.has_cone)
    {
      in_left = curve.side(g.left);
      if(is_bounded && in_left.is_negative_until(event.t))
        return;
      in_right = curve.side(g.right);
      if(is_bounded && in_right.is_negative_until(event.t))
        return;
    }
    const Quadratic<FT> nearer = curve.nearer(g.point, to_g);
    if(is_bounded && nearer.is_negative_until(event.t))
      return;
    m_roots.clear();
    add_roots(nearer, event.t);
    if(m_roots.empty() && !(nearer((std::min)(FT(1), FT(event.t / 2))) > 0))
      return;
    if(g.has_cone)
    {
      add_roots(in_left, event.t);
      add_roots(in_right, event.t);
    }
    std::sort(m_roots.begin(), m_roots.end());
    const FT last = event.t < std::numeric_limits<FT>::infinity()
                      ? event.t
                      : FT(m_roots.empty() ? FT(1) : FT(2 * m_roots.back() + 1));
    m_roots.push_back(last);
    // at the start rounding may lead away from an image, and once back
    const bool has_been_left = std::count(m_left_here.begin(), m_left_here.end(), index) > 1;
    FT from = 0;
    for(const FT& to : m_roots)
    {
      if(from < to)
      {
        const FT middle = from + (to - from) / 2;
        if((from > 0 || !has_been_left) && nearer(middle) > 0
           && (!g.has_cone || (in_left(middle) > 0 && in_right(middle) > 0))
           && is_nearer(g, left, curve.point(middle)) && distance(curve.point(from), curve.point(to)) > width())
        {
          if(from < event.t)
          {
            event.kind = Event::NEARER;
            event.t = from;
            event.index = index;
            event.extent = curve.extent(from);
          }
          return;
        }
        from = to;
      }
    }
  }

  void add_roots(const Quadratic<FT>& q, const FT& before)
  {
    if(before < std::numeric_limits<FT>::infinity() && q.is_positive_until(before))
      return;
    for(const FT& r : q.positive_roots())
      if(r < before)
        m_roots.push_back(r);
  }

  static bool is_nearer(const Image& g, const Image& c, const Point& p)
  {
    return g.point.distance_to(p) < c.point.distance_to(p) * (1 - 4 * Tolerance<FT>::distance());
  }

  bool has_been_left_here(std::size_t i) const
  {
    return std::find(m_left_here.begin(), m_left_here.end(), i) != m_left_here.end();
  }

  // The image of the same source that goes on where the cone of image i ends: one that is as near, or,
  // where rounding has left a gap between the cones, the end of the interval.
  std::size_t successor(std::size_t i, std::size_t other, const Point& p)
  {
    m_left_here.push_back(i);
    const Image g = image(i);
    const FT at_p = g.point.distance_to(p);
    const FT tolerance = width();
    std::size_t best = none;
    FT best_distance = at_p + at_p * Tolerance<FT>::tie();
    for(std::size_t j = 0; j < m_images.size(); ++j)
    {
      const Image& next = m_images[j];
      if(j == i || j == other || next.site != g.site || !next.sees(p, tolerance))
        continue;
      const FT d = next.point.distance_to(p);
      if(d < best_distance && !has_been_left_here(j))
      {
        best = j;
        best_distance = d;
      }
    }
    const std::size_t at_end = add_bend(i, p);
    return best != none ? best : at_end;
  }

  // Paths from an image to points beyond its cone bend at the end of the interval that is nearer to p.
  static Image bend(const Image& g, const Point& p)
  {
    Image result;
    const Point& q = g.left(p) < g.right(p) ? g.left_end : g.right_end;
    result.point = Additively_weighted_point<FT>{q.x, q.y, g.point.distance_to(q)};
    result.site = g.site;
    return result;
  }

  std::size_t add_bend(std::size_t i, const Point& p)
  {
    m_bends.push_back(bend(image(i), p));
    return m_images.size() + m_bends.size() - 1;
  }

  const Image& image(std::size_t i) const
  {
    return i < m_images.size() ? m_images[i] : m_bends[i - m_images.size()];
  }

  std::array<Half_plane<FT>, 3> m_side;
  FT m_size = 0;
  bool m_has_no_height = false;
  FT m_slack = 0; // how far a front may start outside the half-planes that it is to leave
  std::vector<Image> m_images, m_bends;
  std::vector<Breakpoint> m_breakpoints;
  std::vector<Vertex_id> m_sites; // that the fronts have, sorted
  Cone_columns<FT> m_cones;
  std::vector<FT> m_margins; // of the images at the beginning of a piece
  std::vector<std::size_t> m_left_here; // images that a front went over from, so that it does not go round
  std::vector<FT> m_roots;
  std::size_t m_number_of_traces = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONT_TRACER_H
