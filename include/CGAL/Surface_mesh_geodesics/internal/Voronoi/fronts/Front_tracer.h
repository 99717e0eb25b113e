// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_TRACER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_TRACER_H

// Traces a front: follows the curve between two cells into a face until it meets a third cell or leaves the face.
//
// Along a front, one image of each of the two sites is nearest. The curve of equal distance from these two images is a
// piece of a hyperbola or a line (Weighted_bisector.h). The piece ends at the first event (Front_event.h): another
// image of one of the two sites takes over, which begins the next piece, or an image of a third site does, which ends
// the trace.
//
// How trace() proceeds:
// - start_trace() finds the images of both sites at the start of the front.
// - step() follows one piece: find_event() tries the border, the cones and the other images, end_of_piece() refines the
//   point of the event, go_over() changes the image or ends the trace. update_stop_at_border() then decides whether a
//   front that has come to the border has left the face.
// - Where no curve leads on, find_way_ahead() looks for two other images that tie here.
//
// Rounding may lead into circles where many images tie. Three rules end them: an image that has been left at a point
// follows no other one there and takes over there once at most, the number of pieces is bounded, and a front that
// cannot go on looks once for a pair of tied images whose curve leads on.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Cell_front.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Face_images.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Front_event.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Newton_refinement.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Frame: the layout of the face. Ties: an image takes over only where it is nearer beyond rounding, is_nearer(); of
// events at the same parameter the one tried first stays: the border, cones, images beside the current ones, other
// images by their index. Error: ends of pieces are refined until both conditions of the event hold up to the rounding
// of distances; no bound is known for their position, as curves may touch.
//
// State of a trace, between two pieces: f.end is on the bisector of image(f.left_image) and image(f.right_image), which
// are the nearest ones of the sites f.left and f.right there, up to rounding. An index from images().number() on means
// a bend (add_bend()): paths around the end of an interval, which are not straight at the image. f.stop is LOST while
// the trace goes on; go_over() and update_stop_at_border() change it where the trace ends.
template <typename FT_>
class Front_tracer
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Image = Site_image<FT>;
  using Front = Cell_front<FT>;
  using Breakpoint = Border_breakpoint<FT>;
  using Images = Face_images<FT>;
  static constexpr std::size_t none = Front::none;

  // Starts a face, given its corners. Then images are added, and breakpoints in counterclockwise order.
  void start(const std::array<Point, 3>& corner)
  {
    m_images.start(corner);
    m_breakpoints.clear();
    m_number_of_traces = 0;
  }

  void add(const Image& image) { m_images.add(image); }
  void add(const Breakpoint& b) { m_breakpoints.push_back(b); }

  const Images& images() const { return m_images; }
  const std::vector<Breakpoint>& breakpoints() const { return m_breakpoints; }

  // The sites whose cells end a trace, in ascending order: those that a front may meet at all. Images of other sites
  // are ignored. The caller sets them before each trace: they are those of one part of the face (Face_partition.h).
  std::vector<Vertex_id>& sites() { return m_sites; }

  // Returns whether a site is one of sites(). Mostly there are two.
  bool has_site(Vertex_id site) const
  {
    if(m_sites.size() == 2)
      return site == m_sites[0] || site == m_sites[1];
    return std::binary_search(m_sites.begin(), m_sites.end(), site);
  }

  // Returns how many traces have been made since start(): the cost of a partition.
  std::size_t number_of_traces() const { return m_number_of_traces; }

  // Sets h to the half-plane into which a front starts: ahead of the line through its start across its curve. Returns
  // false if that is not known. The values of h are signed distances.
  bool find_half_plane_ahead(const Front& f, Half_plane<FT>& h) const
  {
    const std::size_t l = m_images.nearest_of(f.left, f.p), r = m_images.nearest_of(f.right, f.p);
    if(l == none || r == none)
      return false;
    const Weighted_bisector<FT> curve(m_images.point_toward(m_images[l], f.p),
                                      m_images.point_toward(m_images[r], f.p), f.p);
    if(!curve.is_valid() && !curve.is_ray())
      return false;
    const Point t = curve.tangent();
    h = Half_plane<FT>{t.x, t.y, FT(-(t.x * f.p.x + t.y * f.p.y))};
    return true;
  }

  // Follows f until it meets the cell of a third one of sites(), leaves the face, or leaves the half-plane `until`,
  // unless that is nullptr. Replaces the result of an earlier trace of f; f.stop tells why this one has ended. It is
  // LOST where no curve leads on, and if the bound of the number of pieces has ended the trace. In a face without
  // height the front stops at its start. Takes time proportional to the number of images for each piece; where images
  // tie, the search for a way ahead takes a time quadratic in the number of those that do.
  // Requires: sites() are set; the two sites of f are equally far from its start, up to rounding.
  void trace(Front& f, const Half_plane<FT>* until)
  {
    CGAL_expensive_assertion(std::is_sorted(m_sites.begin(), m_sites.end()));
    ++m_number_of_traces;
    if(!start_trace(f))
      return;
    std::size_t steps = 4 * m_images.number() + 64, steps_here = 0;
    while(f.stop == Front_stop::LOST && steps-- > 0)
    {
      const Point from = f.end;
      const std::size_t left_before = m_left_here.size();
      if(!step(f, until))
      {
        if(steps_here > m_images.number() || !find_way_ahead(f))
          return;
        steps_here = m_images.number() + 1; // only once at each point
        continue;
      }
      m_slack = m_images.width(); // find_way_ahead() may have widened it, for one piece
      // After a real step, only the images that it has left at its end count as left here.
      if(distance(from, f.end) > Tolerance<FT>::standstill() * m_images.size())
      {
        steps_here = 0;
        m_left_here.erase(m_left_here.begin(), m_left_here.begin() + static_cast<std::ptrdiff_t>(left_before));
      }
      else if(++steps_here > m_images.number() + 8) // rounding leads round in a circle
        return;
      update_stop_at_border(f);
    }
  }

private:
  using Event = Front_event<FT>;
  using Bisector = Weighted_bisector<FT>;

  // Prepares a trace from the start of f. Returns false if nothing can be traced: the face has no height, or one of the
  // sites has no image in this face (f.stop is LOST then). An image that does not see the start is replaced by a bend.
  bool start_trace(Front& f)
  {
    f.pieces.clear();
    f.pieces.reserve(32);
    f.end = f.p;
    f.third = null_id;
    f.stop = m_images.has_no_height() ? Front_stop::OUTSIDE : Front_stop::LOST;
    if(m_images.has_no_height()) // curves across such a face are known from its border only
      return false;
    f.left_image = m_images.nearest_of(f.left, f.p);
    f.right_image = m_images.nearest_of(f.right, f.p);
    if(f.left_image == none || f.right_image == none)
      return false;
    m_bends.clear();
    for(std::size_t* index : {&f.left_image, &f.right_image})
      if(!m_images[*index].sees(f.p, m_images.width()))
        *index = add_bend(*index, f.p);
    m_slack = m_images.width();
    m_left_here.clear();
    return true;
  }

  // Decides at the border whether f has left the face: a curve that only touches the border goes on, and a curve that
  // runs along the border ends at the breakpoint of its two cells.
  void update_stop_at_border(Front& f)
  {
    if(f.stop == Front_stop::OUTSIDE && !ends_at_breakpoint(f, m_images.joining_distance()) && find_way_ahead(f))
      f.stop = Front_stop::LOST;
    else if(f.stop == Front_stop::LOST && ends_at_breakpoint(f, m_images.width()))
      f.stop = Front_stop::OUTSIDE;
  }

  // Returns whether f ends at a breakpoint of its two cells, within a tolerance. A curve that ends there has its cells
  // on the other sides than one that starts there.
  bool ends_at_breakpoint(const Front& f, const FT& tolerance) const
  {
    for(const Breakpoint& b : m_breakpoints)
      if(b.left == f.right && b.right == f.left && distance(b.p, f.end) <= tolerance)
        return true;
    return false;
  }

  // --- one piece ---

  // Follows f along one piece. Returns false if no curve leads on, or if it has no end. If the curve leaves the face at
  // the event, up to rounding, the border decides: whatever else happens there belongs to the adjacent face. (The
  // references to images are used before go_over(), which may add a bend and so move them.)
  bool step(Front& f, const Half_plane<FT>* until)
  {
    const Image &left = image(f.left_image), &right = image(f.right_image);
    const Bisector curve(left.point, right.point, f.end);
    if(!leads_on(curve, left, right))
      return false;
    Event at_border;
    Event event = find_event(f, curve, until, at_border);
    if(event.kind == Event::NOTHING)
      return false;
    if(at_border.kind == Event::BORDER
       && distance(curve.point(at_border.t), curve.point(event.t)) <= m_images.width())
      event = at_border;
    const Point p = end_of_piece(f, curve, event, at_border.t);
    f.pieces.push_back(Front_piece<FT>{left.point, right.point, p});
    f.end = p;
    go_over(f, event);
    return true;
  }

  // Returns whether a curve exists that has the two cells on the sides where they should be. A ray leads on if the
  // image whose paths do not bend sees it on its side: it sees a point a bit ahead of the start, and as far aside.
  // Otherwise the front would come toward the vertex where the ray begins.
  bool leads_on(const Bisector& curve, const Image& left, const Image& right) const
  {
    if(!curve.is_ray())
      return curve.is_valid();
    const Point u = curve.tangent(), &p = curve.start();
    const bool is_on_left = !curve.is_left_focus();
    const FT ahead = m_images.touching(), aside = is_on_left ? ahead : FT(-ahead);
    const Point q{FT(p.x + ahead * u.x - aside * u.y), FT(p.y + ahead * u.y + aside * u.x)};
    return (is_on_left ? left : right).sees(q);
  }

  // Returns the first event along the curve of f, NOTHING if there is none. Sets at_border to the first event without
  // the half-plane `until`, cones and other images. The order of the candidates decides ties; see the class.
  Event find_event(const Front& f, const Bisector& curve, const Half_plane<FT>* until, Event& at_border)
  {
    m_first.start(curve, m_images.width(), m_slack);
    leave_face(curve);
    at_border = m_first.event();
    if(until != nullptr)
      m_first.enter_and_leave(*until);
    m_first.leave_cone(image(f.left_image), Event::LEFT_CONE);
    m_first.leave_cone(image(f.right_image), Event::RIGHT_CONE);
    m_first.find_reach();
    try_images(f);
    return m_first.event();
  }

  // Finds where a curve leaves the face. The sides that it starts on come last, as it may run along one of them: then
  // rounding would decide where it leaves that side, unless another one bounds it first (First_event::leave()).
  void leave_face(const Bisector& curve)
  {
    const std::array<Half_plane<FT>, 3>& side = m_images.sides();
    for(const bool starts_on_side : {false, true})
      for(unsigned int k = 0; k < 3; ++k)
        if((side[k](curve.start()) <= m_images.width()) == starts_on_side)
          m_first.leave(side[k], Event::BORDER, k);
  }

  // Tries which images take over. The images next to the current two come first: windows come nearly in the order of
  // their intervals, so that a neighbor is likely to end the piece; what is behind that end is not looked at. Of the
  // others, an image can take over only if the curve enters its cone before the event, so its cone must not be farther
  // from the start than the event reaches. (An index of -1 or beyond wraps around and is not less than n.)
  void try_images(const Front& f)
  {
    const std::size_t n = m_images.number();
    const FT at_start = image(f.left_image).point.distance_to(f.end);
    const std::array<std::size_t, 4> beside{f.left_image - 1, f.left_image + 1, f.right_image - 1, f.right_image + 1};
    for(std::size_t i : beside)
      if(i < n)
        try_image(f, i, at_start);
    m_images.cones().find_margins(f.end, m_margins);
    for(std::size_t i = 0; i < n; ++i)
      if(m_margins[i] >= -m_first.event().reach && !is_beside(i, f.left_image) && !is_beside(i, f.right_image))
        try_image(f, i, at_start);
    // The paths around the end of the last cone: the image that follows may only seem to tie with them at that end.
    if(!m_bends.empty())
      try_image(f, n + m_bends.size() - 1, at_start);
  }

  // Tries whether image i takes over, unless it is one of the current two or belongs to a site that f cannot meet. An
  // image may be left once and come back at the same point, as rounding may make two images seem nearer in turn; the
  // second time it has to be nearer farther on.
  void try_image(const Front& f, std::size_t i, const FT& at_start)
  {
    if(i == f.left_image || i == f.right_image || !has_site(image(i).site))
      return;
    const bool has_been_left = std::count(m_left_here.begin(), m_left_here.end(), i) > 1;
    m_first.take_over(image(f.left_image), at_start, image(i), i, has_been_left);
  }

  // Whether |i - j| <= 1, for unsigned numbers.
  static bool is_beside(std::size_t i, std::size_t j) { return i + 1 - j <= 2; }

  // Returns where a piece ends, refined by Newton's method: equally far from both images and from a third site, or on
  // the line that the curve leaves. `at_border` is the parameter where the curve leaves the face; a vertex that comes
  // to lie outside by refinement is taken from the curve instead. An event at the start of the curve (t = 0) moves
  // nothing.
  Point end_of_piece(const Front& f, const Bisector& curve, const Event& event, const FT& at_border) const
  {
    if(!(event.t > 0))
      return f.end;
    const Additively_weighted_point<FT> &left = image(f.left_image).point, &right = image(f.right_image).point;
    const Point p = curve.point(event.t);
    if(event.kind == Event::NEARER && is_third_site(f, event.index))
    {
      const Point q = polished_vertex(left, right, image(event.index).point, p, m_images.size());
      return m_images.is_in_face(q) ? q : curve.point((std::min)(event.t, at_border));
    }
    // Two images of one site may be so close to each other that the position along the curve is not well known: then
    // the point moves only across the curve.
    if(event.kind == Event::IMPRECISE)
      return polished_intersection(left, right, line_across(left, right, p), p, m_images.size());
    if(event.kind == Event::NEARER)
      return equidistant_point(left, right, image(event.index).point, p);
    return polished_intersection(left, right, event.line, p, m_images.size());
  }

  // Returns where another image g of one of the two sites takes over, close to p: on the curve of `left` and `right`.
  // If these two are close to each other, rounding may move the point across the curve so far that g is not as near as
  // they are; then the point is refined once more, along the curve.
  Point equidistant_point(const Additively_weighted_point<FT>& left, const Additively_weighted_point<FT>& right,
                          const Additively_weighted_point<FT>& g, const Point& p) const
  {
    using std::abs;
    const Point q = polished_intersection(left, right, line_across(left, right, p), p, m_images.size());
    const auto gap = [&](const Point& x) { return FT(abs(FT(g.distance_to(x) - left.distance_to(x)))); };
    if(!(gap(q) > Tolerance<FT>::bisector() * left.distance_to(q)))
      return q;
    const Point v = polished_vertex(left, right, g, q, m_images.size());
    return m_images.is_in_face(v) && gap(v) < gap(q) ? v : q;
  }

  // Changes f to what follows the event at its end: another image of one of its sites, or the end of the trace.
  void go_over(Front& f, const Event& event)
  {
    switch(event.kind)
    {
    case Event::LEFT_CONE:
      leave_cone(f, f.left_image, f.right_image);
      break;
    case Event::RIGHT_CONE:
      leave_cone(f, f.right_image, f.left_image);
      break;
    case Event::NEARER:
      meet(f, event.index);
      break;
    case Event::IMPRECISE:
      break;
    default:
      f.stop = Front_stop::OUTSIDE;
    }
  }

  // Lets f go over from image `current`, whose cone it leaves, to its successor. If there is none, and a third site is
  // as near, f stops: sites that share a point tie behind it, where only one of them has kept its windows.
  void leave_cone(Front& f, std::size_t& current, std::size_t other)
  {
    const std::size_t next = successor(current, other, f.end);
    const std::size_t third = next < m_images.number() ? none : tied_third(f, image(next).point.distance_to(f.end));
    if(third == none)
      current = next;
    else
      meet(f, third);
  }

  // Returns the first image of a third site that sees the end of f at the distance `at_end`, up to ties; `none` if no
  // image does.
  std::size_t tied_third(const Front& f, const FT& at_end) const
  {
    using std::abs;
    for(std::size_t i = 0; i < m_images.number(); ++i)
    {
      const Image& g = m_images[i];
      if(has_site(g.site) && is_third_site(f, i) && g.sees(f.end, m_images.width())
         && abs(FT(g.point.distance_to(f.end) - at_end)) <= m_images.margin_of_tie(at_end))
        return i;
    }
    return none;
  }

  // Returns whether an image belongs to neither of the two sites of f.
  bool is_third_site(const Front& f, std::size_t index) const
  {
    const Vertex_id site = image(index).site;
    return site != f.left && site != f.right;
  }

  // Lets f go over to an image that has become nearer, or stop if it belongs to a third site. Only images of sites()
  // get here (try_image()).
  void meet(Front& f, std::size_t index)
  {
    const Vertex_id site = image(index).site;
    if(!is_third_site(f, index))
    {
      std::size_t& current = site == f.left ? f.left_image : f.right_image;
      m_left_here.push_back(current);
      current = index;
    }
    else
    {
      f.stop = Front_stop::SITE;
      f.third = site;
      f.third_image = index;
    }
  }

  // Returns the image of the same site that follows at p, where the cone of image i ends: the nearest one that sees p
  // and is as near as image i, the lowest index in a tie. Where rounding has left a gap between the cones, paths bend
  // at the end of the interval. The bend is made in any case, since try_images() compares it with the image that
  // follows. `other` is the current image of the other site. Requires: image i has a cone.
  std::size_t successor(std::size_t i, std::size_t other, const Point& p)
  {
    m_left_here.push_back(i);
    const Image current = image(i); // a copy, as add_bend() may move it
    const FT at_p = current.point.distance_to(p);
    const FT tolerance = m_images.width();
    std::size_t best = none;
    FT best_distance = at_p + m_images.margin_of_tie(at_p);
    for(std::size_t j = 0; j < m_images.number(); ++j)
    {
      const Image& next = m_images[j];
      if(j == i || j == other || next.site != current.site || !next.sees(p, tolerance))
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

  // Returns whether f has left image i at its current end.
  bool has_been_left_here(std::size_t i) const
  {
    return std::find(m_left_here.begin(), m_left_here.end(), i) != m_left_here.end();
  }

  // --- ties ---

  // Where several images of a site tie, rounding may have led to one that is not the nearest ahead. Changes f to the
  // pair of tied images, one of each site, whose curve leads farthest into the face without turning back. Returns false
  // if no curve leads away from here. (At the start of f any curve that is longer than rounding will do.) Widens
  // m_slack for the next piece, as a point where curves touch is known less exactly (Face_images::touching()).
  bool find_way_ahead(Front& f)
  {
    m_slack = m_images.touching();
    const std::vector<std::size_t> left = m_images.tied_images(f.left, f.end);
    const std::vector<std::size_t> right = m_images.tied_images(f.right, f.end);
    FT farthest = distance(f.p, f.end) <= m_images.width() ? m_images.width() : m_images.joining_distance();
    bool is_found = false;
    const std::size_t current_left = f.left_image, current_right = f.right_image;
    for(std::size_t l : left)
      for(std::size_t r : right)
      {
        if(l == current_left && r == current_right)
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

  // Returns whether the curve of two images at the end of f leads back along the last piece. (A cell that ends in a
  // point may turn a front by nearly half a turn there.)
  bool turns_back(const Front& f, std::size_t l, std::size_t r) const
  {
    using std::abs;
    if(f.pieces.empty())
      return false;
    const Point t = Bisector(f.pieces.back().left, f.pieces.back().right, f.end).tangent();
    const Point u = Bisector(m_images[l].point, m_images[r].point, f.end).tangent();
    return t.x * u.x + t.y * u.y < 0 && abs(FT(t.x * u.y - t.y * u.x)) <= Tolerance<FT>::touching();
  }

  // Returns how far the curve of two images leads from p into the face and their cones, 0 if another one of the tied
  // images `left` and `right` is nearer ahead. "Ahead" is half-way to the end, but at most at the parameter
  // look_ahead(). Uses m_first, so the event of the last search is lost.
  FT way_ahead(const Point& p, std::size_t l, std::size_t r, const std::vector<std::size_t>& left,
               const std::vector<std::size_t>& right)
  {
    const Image &image_l = m_images[l], &image_r = m_images[r];
    const Bisector curve(image_l.point, image_r.point, p);
    if(!leads_on(curve, image_l, image_r))
      return 0;
    m_first.start(curve, curve.end(), m_images.width(), m_slack);
    leave_face(curve);
    m_first.leave_cone(image_l, Event::LEFT_CONE);
    m_first.leave_cone(image_r, Event::LEFT_CONE);
    const Event& event = m_first.event();
    if(event.kind == Event::NOTHING)
      return 0;
    const Point ahead = curve.point((std::min)(FT(event.t / 2), Tolerance<FT>::look_ahead()));
    const auto is_nearest = [&](const Image& g, const std::vector<std::size_t>& others)
    {
      return std::none_of(others.begin(), others.end(), [&](std::size_t i)
      { return m_images[i].sees(ahead) && is_nearer(m_images[i].point, g.point, ahead); });
    };
    return is_nearest(image_l, left) && is_nearest(image_r, right) ? distance(curve.point(event.t), p) : FT(0);
  }

  // --- images and bends ---

  // Adds the paths around the end of image i that is nearer to p, and returns their index. Bends live until the next
  // trace; a reference to one is valid until the next one is added. A bend of a bend has no cone; it is not made, since
  // only images with a cone are left or do not see p.
  std::size_t add_bend(std::size_t i, const Point& p)
  {
    m_bends.push_back(Images::bend(image(i), p));
    return m_images.number() + m_bends.size() - 1;
  }

  // Returns an image of the face, or for larger indices a bend of the current trace.
  const Image& image(std::size_t i) const
  {
    return i < m_images.number() ? m_images[i] : m_bends[i - m_images.number()];
  }

  Images m_images;
  std::vector<Image> m_bends; // the ends of intervals where the paths of the current trace bend
  std::vector<Breakpoint> m_breakpoints; // of the face, all of them, whatever part of it is traced
  std::vector<Vertex_id> m_sites;        // see sites()
  FT m_slack = 0; // how far a piece may start outside of the half-planes that it is to leave
  std::vector<FT> m_margins; // of the cones from the start of a piece
  std::vector<std::size_t> m_left_here; // the images that the front has left at its end
  First_event<FT> m_first; // of the piece that is followed; reused, so that its buffer is not allocated anew
  std::size_t m_number_of_traces = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FRONT_TRACER_H
