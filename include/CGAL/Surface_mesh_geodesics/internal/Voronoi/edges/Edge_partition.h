// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_EDGE_PARTITION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_EDGE_PARTITION_H

// Divides an edge into the intervals where one image is nearest: the lower envelope of the distances through the
// windows of both sides and through the two ends (thesis, 5.2, the trimming rule). This decides which site owns each
// part of the edge; both faces at the edge use the result.
//
// The envelope is found by walking from the first end to the last one, from each image to the one that takes over
// first: build() repeats take_over(), which asks takes_over() about each image, and successor() where the interval of
// the current image ends. change_site() notes where the walk comes to another cell.
//
// Formula: the distance by an image is weight + |(x - image_x, depth)| in the frame of a halfedge, where x is the
// abscissa. Two of them are equal at the roots of a quadratic equation (equal_points()), refined by Newton's method.
// Ties: an image takes over only where it is nearer beyond rounding, is_nearer(). So where two sites tie along a part
// of the edge, the one whose interval comes first keeps it, unless it ends in a point there (does_touch()). Of two
// candidates at the same abscissa, the one whose distance grows more slowly takes over; if their slopes are equal, the
// one added first.
// Error: the distances at a breakpoint are equal up to their rounding. No bound is known for its abscissa, as the two
// distances may touch; cells narrower than Tolerance::interval() times the length are dropped.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Edge_image.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Interval_sweep.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A breakpoint: the abscissa where the cell of `before` ends and that of `after` begins.
template <typename FT>
struct Edge_breakpoint
{
  FT x;
  Vertex_id before, after;
};

// An interval where an image is nearest, given by its index: 0 and 1 are the ends of the edge, then come the images in
// the order in which they were added. The partition may append images of its own, for paths that bend.
template <typename FT>
struct Edge_interval
{
  FT begin, end;
  std::size_t image;
};

// Frame: that of a halfedge of the edge; images of the other face are given in it, too. Depths are not negative, up to
// rounding: on which side of the edge an image lies makes no difference to distances on it.
//
// Invariants after build(), regardless of rounding (is_partition() checks them): the intervals cover the edge without
// overlap; the breakpoints ascend, lead from the site of the first end to that of the last one, and each one changes
// the site. Edge_division relies on the order of the images: 0 and 1 are the ends, 2 is the first that is
// added.
template <typename FT>
class Edge_partition
{
public:
  using Image = Edge_image<FT>;
  using Breakpoint = Edge_breakpoint<FT>;

  // Starts an edge, given the sites and the distances of its ends. Then images are added, and build() is called.
  // Requires: length > 0; both ends are reached.
  void start(const FT& length, Vertex_id first_site, const FT& first_distance, Vertex_id last_site,
             const FT& last_distance)
  {
    CGAL_assertion(length > 0);
    m_length = length;
    m_last_site = last_site;
    m_has_rays = false;
    m_images.clear();
    m_images.push_back(Image{FT(0), length, FT(0), FT(0), first_distance, first_site});
    m_images.push_back(Image{FT(0), length, length, FT(0), last_distance, last_site});
  }

  void add(const Image& g)
  {
    CGAL_assertion((g.weight >= 0 || g.is_at_infinity) && g.site != null_id);
    m_images.push_back(g);
    m_has_rays = m_has_rays || g.is_at_infinity;
  }

  // Images tie if their distances differ by no more (Face_images::margin_of_tie()).
  FT margin_of_tie(const FT& distance) const
  {
    return distance * Tolerance<FT>::tie() + (m_has_rays ? width() : FT(0));
  }

  // Finds the intervals and breakpoints. Takes time O(n log n) for n images, if few of them share an abscissa; that is
  // so for windows, as those of one side hardly overlap. Gaps between intervals take further walks, mostly one, and
  // time quadratic in their number; in general there are few.
  void build()
  {
    const std::size_t number_given = m_images.size();
    m_bends.clear();
    m_number_of_trials = 0;
    while(!walk()) // has added bends, which are finitely many: one for each begin of an interval
    {
      m_images.resize(number_given);
      m_images.insert(m_images.end(), m_bends.begin(), m_bends.end());
    }
    m_intervals.push_back(Edge_interval<FT>{m_x, m_length, m_current});
    // If rounding has led the walk to another site than that of the last end, the end decides: it is a vertex, whose
    // site is the same for all edges there.
    change_site(m_length, m_last_site);
    CGAL_expensive_assertion(is_partition());
  }

  // Both are in ascending order, and valid until the next call of build(). The intervals cover the edge.
  const std::vector<Breakpoint>& breakpoints() const { return m_breakpoints; }
  const std::vector<Edge_interval<FT>>& intervals() const { return m_intervals; }

  const Image& image(std::size_t i) const { return m_images[i]; }

  // Returns how often the last call of build() has asked whether an image takes over: the cost of the partition.
  std::size_t number_of_trials() const { return m_number_of_trials; }

private:
  // Goes from the first end of the edge to the last one. Returns false if it has met gaps: another walk is to be made
  // with the new images of m_bends (note_gap()).
  bool walk()
  {
    m_breakpoints.clear();
    m_intervals.clear();
    m_x = 0;
    m_current = 0;
    m_left_here.clear();
    m_bend_ahead = m_images.size();
    m_sweep.start(m_images);
    const std::size_t number_of_bends = m_bends.size();
    std::size_t steps = 8 * m_images.size() + 64; // a bound, in case rounding leads around in a circle
    while(steps-- > 0 && take_over()) {}
    return m_bends.size() == number_of_bends;
  }

  // Returns whether the intervals cover the edge without overlap, and the breakpoints ascend from site to site.
  bool is_partition() const
  {
    FT x = 0;
    for(const Edge_interval<FT>& i : m_intervals)
    {
      if(i.begin != x || i.end < x)
        return false;
      x = i.end;
    }
    Vertex_id site = m_images[0].site;
    FT last = 0;
    for(const Breakpoint& b : m_breakpoints)
    {
      if(b.before != site || b.after == site || b.x < last)
        return false;
      site = b.after;
      last = b.x;
    }
    return x == m_length && site == m_last_site;
  }

  // Goes on to the image that takes over first. Returns false if the current image is nearest up to the end of the
  // edge. Where the interval of the current image ends before, successor() says what follows.
  //
  // Windows come nearly in the order of their intervals, in ascending order from one face and in descending order from
  // the other one. So an image beside the current one is likely to take over: these are tried first, and bound the part
  // of the edge in which the others have to be nearer. Ties do not depend on the order of the trials.
  bool take_over()
  {
    m_sweep.advance(m_x, m_images);
    FT x = m_images[m_current].end;
    std::size_t next = m_current;
    FT next_slope = 0;
    Chord chord(m_images[m_current], m_x, x);
    const auto try_image = [&](std::size_t j)
    {
      ++m_number_of_trials;
      FT start;
      if(!does_take_over(j, chord, start) || start > x || (start == x && next == m_current))
        return;
      const FT slope = m_images[j].slope_at(start);
      if(start == x && !(slope < next_slope || (slope == next_slope && j < next)))
        return;
      x = start;
      next = j;
      next_slope = slope;
      chord = Chord(m_images[m_current], m_x, x);
    };
    const auto shares_abscissas = [&](const Image& g) { return !(g.begin > chord.last) && g.end > m_x; };
    for(std::size_t j : {m_current - 1, m_current + 1}) // (-1 wraps around)
      if(j < m_images.size() && shares_abscissas(m_images[j]))
        try_image(j);
    const auto try_other = [&](std::size_t j)
    {
      if(j + 1 != m_current && j != m_current && j != m_current + 1)
        try_image(j);
    };
    for(std::size_t j : m_sweep.open())
      try_other(j);
    m_sweep.for_each_ahead(chord.last, try_other);
    if(next == m_current)
    {
      if(!(x < m_length))
        return false;
      next = successor(x);
    }
    else
      note_gap(next, x);
    if(m_x < x)
    {
      m_intervals.push_back(Edge_interval<FT>{m_x, x, m_current});
      m_left_here.clear();
    }
    m_left_here.push_back(m_current);
    change_site(x, m_images[next].site);
    m_x = x;
    m_current = next;
    return true;
  }

  // The chord of the distances by an image between two abscissas. These are convex, so that the chord is nowhere below.
  struct Chord
  {
    FT first, last, at_first, slope;

    // Requires: first <= last.
    Chord(const Image& c, const FT& from, const FT& to)
      : first(from), last(to), at_first(c.distance_at(from)),
        slope(from < to ? FT((c.distance_at(to) - at_first) / (to - from)) : FT(0))
    {
      CGAL_assertion(first <= last);
    }

    FT operator()(const FT& x) const { return at_first + slope * (x - first); }
  };

  // Returns whether image j takes over from the current one, and where, `start`. It need not be found if it does so
  // behind the chord, which is that of the current image from m_x on.
  bool does_take_over(std::size_t j, const Chord& chord, FT& start) const
  {
    const Image& g = m_images[j];
    const FT from = has_been_left_here(j) ? FT(m_x + width()) : m_x;
    return g.end > from && !is_above(g, chord, from) && takes_over(g, m_images[m_current], from, start);
  }

  // Returns true only if the distances by g from x on are above the chord, as far as both go: a tangent of g is. The
  // distances by g are convex and not below it. The slopes of g lie between -1 and 1.
  static bool is_above(const Image& g, const Chord& chord, const FT& x)
  {
    const FT first = (std::max)(x, g.begin), last = (std::max)(first, (std::min)(chord.last, g.end));
    const FT margin = 1 - Tolerance<FT>::nearer();
    if(g.is_at_infinity)
      return g.distance_at(first) * margin > chord(first) && g.distance_at(last) * margin > chord(last);
    const FT half = (last - first) / 2, middle = first + half;
    const FT along = middle - g.image_x, n = norm<FT>(along, g.depth);
    const FT rise = n > 0 ? FT(half * (along / n)) : FT(0);
    return (g.weight + n - rise) * margin > chord(first) && (g.weight + n + rise) * margin > chord(last);
  }

  // Returns whether an image has been left at the current abscissa. It comes back a bit farther on at the earliest:
  // close to a site, distances are smaller than the rounding of abscissas, and each of two images may seem to be nearer
  // than the other one where it takes over.
  bool has_been_left_here(std::size_t image) const
  {
    return std::find(m_left_here.begin(), m_left_here.end(), image) != m_left_here.end();
  }

  // The error of distances beside a curve, where they are smaller than the rounding of lengths; 0 without curves.
  FT rounding_of_rays() const { return m_has_rays ? FT(Tolerance<FT>::nearer() * m_length) : FT(0); }

  // Parts of the edge that are not longer come from rounding.
  FT width() const { return Tolerance<FT>::interval() * m_length; }

  // Returns whether g is nearer than c somewhere from `x` on, before c ends; `start` is then the abscissa where that
  // begins.
  //
  // Formula: the points of equal distance divide what both intervals share behind x. On each part, is_nearer() compares
  // both distances at the middle, and at last at the foot of g. Ties: an image that ties does not take over.
  //
  // Error: if the result is true, g is nearer than c at some abscissa by 23 u of the distance of c, as is_nearer()
  // says; u = epsilon() / 2. `start` is a root after two steps of Newton's method, the result of a bisection, or where
  // both intervals begin (does_touch()); no bound is known for it where both distances touch. An interval in which g is
  // nearer may be missed if the roots at both ends of it are close: they are known up to the square root of rounding,
  // and so the distances differ by little there.
  //
  // Laws: no image takes over from itself. Scaling all lengths by a power of two scales `start` exactly. The mirror
  // image divides the edge at the mirror images, up to rounding. (g and c may each take over from the other,
  // elsewhere.)
  bool takes_over(const Image& g, const Image& c, const FT& x, FT& start) const
  {
    const FT first = (std::max)(x, g.begin), last = (std::min)(c.end, g.end);
    if(!(first < last))
      return false;
    FT from = first;
    for(const FT& abscissa : points_of_change(g, c, last))
    {
      const FT to = (std::min)((std::max)(abscissa, from), last);
      if(from < to)
      {
        const FT middle = from + (to - from) / 2;
        if(is_nearer<FT>(g.distance_at(middle) + rounding_of_rays(), c.distance_at(middle)))
        {
          start = refined_start(g, c, first, from, last);
          return true;
        }
      }
      from = to;
    }
    // Roots that are close to each other are known up to the square root of rounding: g may be nearer only between
    // them.
    const FT foot = foot_of(g, first, last);
    if(!is_nearer<FT>(g.distance_at(foot) + rounding_of_rays(), c.distance_at(foot)))
      return false;
    start = equidistant_abscissa(g, c, first, foot);
    return true;
  }

  // Returns the abscissas between which one of two images stays nearer, in ascending order; the last one is `last`.
  //
  // Where both images are on the line of the edge, all paths from one to a part of the edge may lead through the other.
  // They tie there, up to one of the images, and the equation tells nothing: then the images themselves divide the
  // edge.
  std::array<FT, 5> points_of_change(const Image& g, const Image& c, const FT& last) const
  {
    const std::array<FT, 2> root = equal_points(g, c);
    std::array<FT, 5> result{root[0], root[1], last, last, last};
    if(g.depth + c.depth <= Tolerance<FT>::closeness() * m_length && !g.is_at_infinity && !c.is_at_infinity)
    {
      result[2] = g.image_x;
      result[3] = c.image_x;
      std::sort(result.begin(), result.begin() + 4);
    }
    return result;
  }

  // Refines the abscissa `from` where g becomes nearer than c, within [first, last]. If g is nearer from `first` on,
  // its interval begins there, and there is nothing to refine.
  FT refined_start(const Image& g, const Image& c, const FT& first, const FT& from, const FT& last) const
  {
    if(!(from > first) && !(g.distance_at(from) > c.distance_at(from)))
      return from;
    const FT equal = polished_abscissa(g, c, from), start = equal >= first && equal <= last ? equal : from;
    return does_touch(g, c, first, start) ? first : start;
  }

  // Do the distances by g and c tie from one abscissa to another, where g is known to become nearer? Distances that
  // touch are equal at a double root, which is known up to the square root of rounding, or less if they part slowly.
  //
  // - Beside curves, a strip takes over from paths around its end, whose distances touch its own on the last ray.
  // - If the weights of two sites differ by their distance, they tie on one ray, and one of them has no other point
  //   there. Then it is not nearer farther away on the line of the edge. (A way that is not longer than width() is left
  //   alone: a simple root is known that exactly, and g may have been left less than width() before, and would
  //   alternate with c. Images of one site may tie along a ray: each has a cone of its own.)
  //
  // Formula: c is nearer than g by most at one of the two abscissas, next to one of the images, or where the slopes of
  // both distances are equal. Half the margin of is_nearer() counts there: else rounding might let g take over here,
  // and c from g at another abscissa, in turns.
  bool does_touch(const Image& g, const Image& c, const FT& from, const FT& to) const
  {
    const FT way = to - from;
    const bool is_last_ray = m_has_rays && way <= Tolerance<FT>::touching() * m_length;
    if(!is_last_ray && (g.site == c.site || way <= width() || way > Tolerance<FT>::tied_part() * m_length))
      return false;
    const FT margin = Tolerance<FT>::nearer() / 2;
    const auto is_before = [&](const FT& x)
    { return is_nearer<FT>(c.distance_at(x) + rounding_of_rays(), g.distance_at(x), margin); };
    const std::array<FT, 4> places{from, foot_of(g, from, to), foot_of(c, from, to),
                                   (std::min)((std::max)(from, equal_slopes(g, c, from)), to)};
    return std::none_of(places.begin(), places.end(), is_before) && (is_last_ray || !is_before(from - m_length));
  }

  // Returns the abscissa where g becomes nearer than c, by bisection; `from` if c is not nearer there.
  // Requires: from <= to; g is nearer at `to`.
  static FT equidistant_abscissa(const Image& g, const Image& c, FT from, FT to)
  {
    CGAL_assertion(from <= to);
    CGAL_expensive_assertion(g.distance_at(to) < c.distance_at(to));
    if(!(c.distance_at(from) < g.distance_at(from)))
      return from;
    for(int i = 0; i < 64; ++i)
    {
      const FT middle = from + (to - from) / 2;
      (c.distance_at(middle) < g.distance_at(middle) ? from : to) = middle;
    }
    return to;
  }

  // Returns the image that follows where the current one ends: the nearest one there, the lowest index in a tie.
  // Rounding may leave a gap between intervals. Paths through the gap bend at the end of the interval; an image is
  // added for them.
  std::size_t successor(const FT& x)
  {
    const Image c = m_images[m_current];
    std::size_t best = m_images.size();
    FT best_distance = c.distance_at(x);
    best_distance = best_distance + Tolerance<FT>::succession() * best_distance + rounding_of_rays();
    m_sweep.advance(x, m_images);
    for(std::size_t j : m_sweep.open())
    {
      const FT d = m_images[j].distance_at(x);
      if(j != m_current && (d < best_distance || (d == best_distance && j < best && best < m_images.size())))
      {
        best = j;
        best_distance = d;
      }
    }
    if(best == m_images.size())
      add_bend_ahead(Image{x, m_length, x, FT(0), c.distance_at(x), c.site});
    return best;
  }

  // Adds paths that bend at their begin and lead ahead. They end the ones before, which are not nearer there, as
  // successor() would have gone over to them, and so are not from there on: all lead along the edge.
  void add_bend_ahead(const Image& bend)
  {
    if(m_bend_ahead < m_images.size())
    {
      CGAL_expensive_assertion(!(m_images[m_bend_ahead].distance_at(bend.begin) < bend.weight));
      m_images[m_bend_ahead].end = bend.begin;
    }
    m_bend_ahead = m_images.size();
    m_sweep.add_open(m_bend_ahead);
    m_images.push_back(bend);
  }

  // If image j takes over at x, where its interval begins, and is nearer by a jump, there is a gap before the interval:
  // distances do not jump. Paths to the gap bend at x; notes an image for them, for another walk, unless it is known.
  // This walk goes on as if there were no gap: the image does not reach behind x. (It also does where rounding keeps a
  // known image from taking over.) successor() closes gaps behind an interval, which the walk meets in time.
  void note_gap(std::size_t j, const FT& x)
  {
    const Image& g = m_images[j];
    if(!(x > 0) || x != g.begin)
      return;
    const FT at_x = g.distance_at(x);
    const auto is_known = [&](const Image& bend) { return bend.end == x && !(at_x < bend.weight); };
    const bool is_gap = at_x + rounding_of_rays() < m_images[m_current].distance_at(x) * (1 - Tolerance<FT>::tie());
    if(!is_gap || std::any_of(m_bends.begin(), m_bends.end(), is_known))
      return;
    FT begin = 0; // a bend before x that is not farther there is not farther anywhere before it, along the edge
    for(const Image& bend : m_bends)
      if(bend.end < x && !(at_x + (x - bend.end) < bend.weight))
        begin = (std::max)(begin, bend.end);
    m_bends.push_back(Image{begin, x, x, FT(0), at_x, g.site});
  }

  // Notes that the cell of another site begins at x. A cell without width is dropped: the new site takes its place in
  // the last breakpoint, which goes, too, if the cell before it has the same site.
  void change_site(const FT& x, Vertex_id site)
  {
    const Vertex_id before = m_breakpoints.empty() ? m_images[0].site : m_breakpoints.back().after;
    if(site == before)
      return;
    if(!m_breakpoints.empty() && x - m_breakpoints.back().x <= width())
    {
      m_breakpoints.back().after = site;
      if(m_breakpoints.back().before == site)
        m_breakpoints.pop_back();
      return;
    }
    m_breakpoints.push_back(Breakpoint{x, before, site});
  }

  FT m_length = 0;
  Vertex_id m_last_site = null_id;
  bool m_has_rays = false; // is an image at infinity?
  std::vector<Image> m_images;
  std::vector<Breakpoint> m_breakpoints;
  std::vector<Edge_interval<FT>> m_intervals;
  FT m_x = 0;                // how far the walk has come
  std::size_t m_current = 0; // the image that is nearest from there on
  std::vector<std::size_t> m_left_here; // the images that have been left at m_x
  std::vector<Image> m_bends; // at the begins of intervals behind gaps
  std::size_t m_bend_ahead = 0; // the last image that leads ahead from the end of an interval; none if there is no such
  std::size_t m_number_of_trials = 0;
  Interval_sweep<FT> m_sweep; // over m_images, up to m_x or the end of the current interval
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_EDGE_PARTITION_H
