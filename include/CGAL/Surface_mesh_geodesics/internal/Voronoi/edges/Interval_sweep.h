// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_INTERVAL_SWEEP_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_INTERVAL_SWEEP_H

// Which intervals of an edge meet a part of it, for parts that advance along the edge. A walk along an edge with
// thousands of windows asks this in each step; a look at all windows would make it quadratic. At a point of the edge
// few intervals are open, as the windows of one side hardly overlap.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Intervals are given by their index in a range of objects with the members `begin` and `end`. Use: start() with the
// range; then for ascending x, advance(), open(), for_each_ahead(). A sweep over n intervals takes time O(n log n),
// plus for each step the number of intervals that are open, and what the visits take.
//
// Invariant: open() has the indices of the intervals with begin <= x < end, for the x of the last advance(), and those
// of intervals that were added since; m_order from m_next on has those of the intervals that begin behind x.
template <typename FT_>
class Interval_sweep
{
public:
  using FT = FT_;

  template <typename Intervals>
  void start(const Intervals& intervals)
  {
    m_open.clear();
    m_next = 0;
    m_order.clear();
    for(std::size_t i = 0; i < intervals.size(); ++i)
      m_order.push_back(Begin{intervals[i].begin, i});
    std::sort(m_order.begin(), m_order.end(), [](const Begin& a, const Begin& b)
    { return a.x < b.x || (a.x == b.x && a.index < b.index); });
  }

  // Opens the intervals that begin at x or before, and closes those that end there or before. Requires: x is not less
  // than in earlier calls.
  template <typename Intervals>
  void advance(const FT& x, const Intervals& intervals)
  {
    for(; m_next < m_order.size() && m_order[m_next].x <= x; ++m_next)
      m_open.push_back(m_order[m_next].index);
    const auto is_closed = [&](std::size_t i) { return !(intervals[i].end > x); };
    m_open.erase(std::remove_if(m_open.begin(), m_open.end(), is_closed), m_open.end());
  }

  // Adds an interval that begins at the x of the last advance().
  void add_open(std::size_t index) { m_open.push_back(index); }

  const std::vector<std::size_t>& open() const { return m_open; }

  // Calls visit(index) for the intervals that begin behind the x of the last advance() but not behind `last`, in the
  // order in which they begin. `last` is read again before each visit, which may lower it.
  template <typename Visit>
  void for_each_ahead(const FT& last, Visit visit) const
  {
    for(std::size_t i = m_next; i < m_order.size() && !(m_order[i].x > last); ++i)
      visit(m_order[i].index);
  }

private:
  // Where the interval with an index begins.
  struct Begin
  {
    FT x;
    std::size_t index;
  };

  std::vector<Begin> m_order; // ascending
  std::size_t m_next = 0;     // the first of m_order that begins behind x
  std::vector<std::size_t> m_open;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_INTERVAL_SWEEP_H
