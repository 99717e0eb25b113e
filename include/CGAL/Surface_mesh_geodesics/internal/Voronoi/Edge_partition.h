// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGE_PARTITION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGE_PARTITION_H

// Which source is nearest along an edge: the lower envelope of the distances by the windows of both sides and
// by the two ends. It is found by walking from one end to the other, from each image to the one that
// takes over first. An image takes over only where it is nearer beyond rounding; so where two sources
// tie along a stretch, the one that came first keeps it, and both faces at the edge are told the same.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

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

// The distances weight + |(x - image_x, depth)| at the points x of an interval.
template <typename FT>
struct Edge_image
{
  FT begin, end;
  FT image_x, depth, weight;
  Vertex_id site;

  FT distance_at(const FT& x) const { return weight + norm<FT>(x - image_x, depth); }

  // the derivative of the distance.
  FT slope_at(const FT& x) const
  {
    const FT n = norm<FT>(x - image_x, depth);
    return n > 0 ? FT((x - image_x) / n) : FT(0);
  }
};

// A point of an edge where one cell ends and the next one begins.
template <typename FT>
struct Edge_breakpoint
{
  FT x;
  Vertex_id before, after;
};

// The interval where an image is nearest. Images are numbered as they were added; the first two are the
// ends of the edge.
template <typename FT>
struct Edge_interval
{
  FT begin, end;
  std::size_t image;
};

template <typename FT>
class Edge_partition
{
public:
  using Image = Edge_image<FT>;
  using Breakpoint = Edge_breakpoint<FT>;

  // Images are added after a call of start(), which is told the sites and distances of the ends.
  void start(const FT& length, Vertex_id first_site, const FT& first_distance, Vertex_id last_site,
             const FT& last_distance)
  {
    m_length = length;
    m_last_site = last_site;
    m_images.clear();
    m_images.push_back(Image{FT(0), length, FT(0), FT(0), first_distance, first_site});
    m_images.push_back(Image{FT(0), length, length, FT(0), last_distance, last_site});
  }

  void add(const Image& g) { m_images.push_back(g); }

  void build()
  {
    m_breakpoints.clear();
    m_intervals.clear();
    m_x = 0;
    m_current = 0;
    m_left_here.clear();
    std::size_t steps = 8 * m_images.size() + 64; // rounding must not let it walk for ever
    while(steps-- > 0 && take_over())
    {
    }
    m_intervals.push_back(Edge_interval<FT>{m_x, m_length, m_current});
    change_site(m_length, m_last_site);
  }

  // Both are in ascending order, and valid until the next call of start().
  const std::vector<Breakpoint>& breakpoints() const { return m_breakpoints; }
  const std::vector<Edge_interval<FT>>& intervals() const { return m_intervals; }

  const Image& image(std::size_t i) const { return m_images[i]; }

private:
  static bool is_nearer(const FT& a, const FT& b) { return a < b * (1 - 4 * Tolerance<FT>::distance()); }

  // goes on to the next image; false at the end of the edge.
  bool take_over()
  {
    FT x = m_images[m_current].end;
    std::size_t next = m_current;
    FT next_slope = 0;
    for(std::size_t j = 0; j < m_images.size(); ++j)
    {
      const Image& g = m_images[j];
      FT start;
      const FT from = has_been_left_here(j) ? FT(m_x + width()) : m_x;
      if(j == m_current || g.begin > x || g.end <= from || !takes_over(g, m_images[m_current], from, x, start))
        continue;
      const FT slope = g.slope_at(start);
      if(start < x || (start == x && next != m_current && slope < next_slope))
      {
        x = start;
        next = j;
        next_slope = slope;
      }
    }
    if(next == m_current)
    {
      if(!(x < m_length))
        return false;
      next = successor(x);
    }
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

  // Near to a source, distances are smaller than the rounding of places: two images may each seem to be nearer
  // than the other one where they take over. One that has been left comes back a bit farther on at the earliest.
  bool has_been_left_here(std::size_t image) const
  {
    return std::find(m_left_here.begin(), m_left_here.end(), image) != m_left_here.end();
  }

  // Parts of the edge that are not longer are products of rounding.
  FT width() const { return Tolerance<FT>::interval() * m_length; }

  // Is g nearer than c somewhere from `x` on, before c ends, and not only behind `until`? Then `start` is where that
  // begins.
  bool takes_over(const Image& g, const Image& c, const FT& x, const FT& until, FT& start) const
  {
    const FT first = (std::max)(x, g.begin), last = (std::min)(c.end, g.end);
    if(!(first < last))
      return false;
    // both distances grow and shrink with x at most
    if(g.distance_at(first) > c.distance_at(first) + 2 * ((std::min)(until, last) - first))
      return false;
    const std::array<FT, 2> root = equal_points(g, c);
    std::array<FT, 4> place{root[0], root[1], last, last};
    // Where both images are on the line of the edge, one may be on all paths from the other one to a part of the edge.
    // They tie there, up to one of the images, and the equation tells nothing.
    if(g.depth + c.depth <= Tolerance<FT>::closeness() * m_length)
    {
      place[2] = g.image_x;
      place[3] = c.image_x;
      std::sort(place.begin(), place.end());
    }
    FT from = first;
    for(unsigned int i = 0; i < 5; ++i)
    {
      const FT to = i < 4 ? (std::min)((std::max)(place[i], from), last) : last;
      if(from < to)
      {
        const FT middle = from + (to - from) / 2;
        if(is_nearer(g.distance_at(middle), c.distance_at(middle)))
        {
          start = from;
          if(from > first || g.distance_at(from) > c.distance_at(from)) // (else it is nearer from the beginning)
          {
            const FT equal = polished(g, c, from);
            if(equal >= first && equal <= last)
              start = equal;
          }
          return true;
        }
      }
      from = to;
    }
    // Roots that are near to each other are known to the square root of rounding: g may be nearer between them only.
    const FT foot = (std::min)((std::max)(g.image_x, first), last);
    if(!is_nearer(g.distance_at(foot), c.distance_at(foot)))
      return false;
    start = equidistant_abscissa(g, c, first, foot);
    return true;
  }

  // where g becomes nearer than c between two places, at the second of which it is so.
  static FT equidistant_abscissa(const Image& g, const Image& c, FT from, FT to)
  {
    if(!(c.distance_at(from) < g.distance_at(from)))
      return from;
    for(int i = 0; i < 64; ++i)
    {
      const FT middle = from + (to - from) / 2;
      (c.distance_at(middle) < g.distance_at(middle) ? from : to) = middle;
    }
    return to;
  }

  // where the distances of two images are the same, in ascending order; infinity for what is not there.
  static std::array<FT, 2> equal_points(const Image& g, const Image& c)
  {
    using std::sqrt;
    const FT infinity = std::numeric_limits<FT>::infinity();
    std::array<FT, 2> r{infinity, infinity};
    // With y measured from the image of c and s the weight of c less that of g: squared, the equation
    // |(y - d, depth of g)| = |(y, depth of c)| + s is a y + b = s |(y, depth of c)|, once more squared
    // a quadratic one.
    const FT s = c.weight - g.weight, d = g.image_x - c.image_x;
    const FT a = -d;
    const FT b = ((d - s) * (d + s) + (g.depth - c.depth) * (g.depth + c.depth)) / 2;
    const FT qa = (a - s) * (a + s), qb = a * b, qc = (b - s * c.depth) * (b + s * c.depth);
    // qa y^2 + 2 qb y + qc = 0
    const FT square = b * b + qa * c.depth * c.depth;
    const FT root = square > 0 ? FT(sqrt(square) * (s < 0 ? FT(-s) : s)) : FT(0);
    const FT q = -(qb + (qb < 0 ? FT(-root) : root));
    if(qa != 0)
      r[0] = c.image_x + q / qa;
    if(q != 0)
      r[1] = c.image_x + qc / q;
    if(r[1] < r[0])
      std::swap(r[0], r[1]);
    return r;
  }

  // Newton's method; where it does not help, x is what it was. (A root of the squared equation that is none
  // of the equation divides the edge at one place more, which does no harm.)
  static FT polished(const Image& g, const Image& c, FT x)
  {
    using std::abs;
    for(int i = 0; i < 2; ++i)
    {
      const FT slope = g.slope_at(x) - c.slope_at(x), f = g.distance_at(x) - c.distance_at(x);
      const FT next = slope != 0 ? FT(x - f / slope) : x;
      if(!(abs(g.distance_at(next) - c.distance_at(next)) < abs(f)))
        return x;
      x = next;
    }
    return x;
  }

  // The image that goes on where the current one ends. Rounding may leave a gap there, through which paths
  // bend at the end of the interval.
  std::size_t successor(const FT& x)
  {
    const Image c = m_images[m_current];
    std::size_t best = m_images.size();
    FT best_distance = c.distance_at(x);
    best_distance = best_distance + 16 * Tolerance<FT>::distance() * best_distance;
    for(std::size_t j = 0; j < m_images.size(); ++j)
      if(j != m_current && m_images[j].begin <= x && x < m_images[j].end
         && m_images[j].distance_at(x) < best_distance)
      {
        best = j;
        best_distance = m_images[j].distance_at(x);
      }
    if(best == m_images.size())
      m_images.push_back(Image{x, m_length, x, FT(0), c.distance_at(x), c.site});
    return best;
  }

  // The cell of another site begins at x. A cell without width is left out.
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
  std::vector<Image> m_images;
  std::vector<Breakpoint> m_breakpoints;
  std::vector<Edge_interval<FT>> m_intervals;
  FT m_x = 0;
  std::size_t m_current = 0;
  std::vector<std::size_t> m_left_here; // the images that ended at m_x
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGE_PARTITION_H
