// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_EDGE_DIVISION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_EDGE_DIVISION_H

// An edge that is divided: the windows and strips of its two faces, and then where cells begin and end on it, and which
// windows and strips the faces still need. It has copies of all that it needs, so that any thread may divide it.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Edge_partition.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Kept_window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Use: start(); the windows across the edge's halfedge, then those across its opposite; strips alike; paths to the
// border; divide(); the results. Many edges may wait to be divided, so an object is small: the images are made when it
// is divided, in a partition of the thread.
//
// Frame: that of halfedge(). Error, ties: those of Edge_partition.
template <typename FT_>
class Edge_division
{
public:
  using FT = FT_;
  using Breakpoint = Edge_breakpoint<FT>;

  // An end of the edge: its site and its distance.
  struct End
  {
    Vertex_id site;
    FT distance;
  };

  // Starts the edge of h, whose opposite is o or null_id. Requires: h < o; length > 0; both ends are reached.
  void start(Halfedge_id h, Halfedge_id o, const FT& length, const End& first, const End& last)
  {
    CGAL_assertion(h < o); // (null_id is the largest index)
    m_halfedge = h;
    m_opposite = o;
    m_length = length;
    m_first = first;
    m_last = last;
    m_windows.clear();
    m_strips.clear();
    m_paths.clear();
  }

  // Adds a window across h, which is halfedge() or opposite(), given its site and the distance of its root.
  void add(Halfedge_id h, const Kept_window<FT>& w, const FT& distance, Vertex_id site)
  {
    m_windows.push_back({w, distance, site, h == m_halfedge});
  }

  // Adds the strip with a number, across one of these halfedges.
  void add(Halfedge_id h, std::size_t number, const Strip<FT>& s, Vertex_id site)
  {
    m_strips.push_back({s, number, site, h == m_halfedge});
  }

  // Adds a path that arrives at a border edge through its face, as no window leaves the face there.
  void add(const Edge_image<FT>& path) { m_paths.push_back(path); }

  // Divides the edge, by a partition that may have divided others. Takes the time of Edge_partition::build(), which is
  // nearly linear in the number of windows, as those of one side hardly overlap.
  void divide(Edge_partition<FT>& partition)
  {
    partition.start(m_length, m_first.site, m_first.distance, m_last.site, m_last.distance);
    for(const Window_on_edge& w : m_windows)
      partition.add(image_of(w));
    for(const Strip_on_edge& s : m_strips)
      partition.add(image_of(s));
    for(const Image& path : m_paths)
      partition.add(path);
    partition.build();
    m_breakpoints = partition.breakpoints();
    find_needed(partition);
  }

  Halfedge_id halfedge() const { return m_halfedge; }
  Halfedge_id opposite() const { return m_opposite; }

  // Where cells begin and end, in ascending order. Requires: divide() was called.
  const std::vector<Breakpoint>& breakpoints() const { return m_breakpoints; }

  // Calls visit(halfedge, window) for the windows that are nearest somewhere, in the order in which they were added.
  // They have their whole intervals: the points where others take over are known up to rounding only, and do not match
  // those on the other edges of a face.
  template <typename Visit>
  void for_each_needed_window(Visit visit) const
  {
    for(std::size_t i = 0; i < m_windows.size(); ++i)
      if(m_is_needed[i])
        visit(m_windows[i].is_across_halfedge ? m_halfedge : m_opposite, m_windows[i].window);
  }

  // Calls visit(number) for the strips that are nearest nowhere.
  template <typename Visit>
  void for_each_strip_not_needed(Visit visit) const
  {
    for(std::size_t i = 0; i < m_strips.size(); ++i)
      if(!m_is_needed[m_windows.size() + i])
        visit(m_strips[i].number);
  }

  std::size_t memory() const
  {
    return sizeof(*this) + m_windows.capacity() * sizeof(Window_on_edge) + m_strips.capacity() * sizeof(Strip_on_edge)
         + m_paths.capacity() * sizeof(Image) + m_breakpoints.capacity() * sizeof(Breakpoint)
         + m_is_needed.capacity();
  }

private:
  using Image = Edge_image<FT>;

  // Each with its site, and whether it has come across halfedge() or opposite().
  struct Window_on_edge
  {
    Kept_window<FT> window;
    FT distance; // of its root
    Vertex_id site;
    bool is_across_halfedge;
  };

  struct Strip_on_edge
  {
    Strip<FT> strip;
    std::size_t number;
    Vertex_id site;
    bool is_across_halfedge;
  };

  Image image_of(const Window_on_edge& g) const
  {
    const Kept_window<FT>& w = g.window;
    return g.is_across_halfedge ? Image{w.begin, w.end, w.image_x, w.image_depth, g.distance, g.site}
                                : Image{FT(m_length - w.end), FT(m_length - w.begin), FT(m_length - w.image_x),
                                        w.image_depth, g.distance, g.site};
  }

  Image image_of(const Strip_on_edge& g) const
  {
    const Strip<FT>& s = g.strip;
    return g.is_across_halfedge ? Image{s.begin, s.end, s.direction_x, FT(0), s.distance, g.site, true}
                                : Image{FT(m_length - s.end), FT(m_length - s.begin), FT(-s.direction_x), FT(0),
                                        s.distance_at(m_length), g.site, true};
  }

  // The images 0 and 1 of the partition are the ends of the edge; then come the windows, the strips, and the paths.
  void find_needed(const Edge_partition<FT>& partition)
  {
    m_is_needed.assign(number_of_windows_and_strips(), false);
    for(const Edge_interval<FT>& i : partition.intervals())
      if(i.image >= 2 && i.image - 2 < m_is_needed.size() && i.begin < i.end)
        m_is_needed[i.image - 2] = true;
    for(std::size_t i = 0; i < m_is_needed.size(); ++i)
      m_is_needed[i] = m_is_needed[i] || is_nearest_somewhere(partition, i);
  }

  std::size_t number_of_windows_and_strips() const { return m_windows.size() + m_strips.size(); }

  // Has window or strip i come across halfedge()? Windows count first, then strips.
  bool is_across_halfedge(std::size_t i) const
  {
    return i < m_windows.size() ? m_windows[i].is_across_halfedge : m_strips[i - m_windows.size()].is_across_halfedge;
  }

  // Returns whether a window or strip that has no interval of its own ties with the nearest one on a part of its edge.
  // If its image is on the edge itself, it may be nearest at the image only.
  bool is_nearest_somewhere(const Edge_partition<FT>& partition, std::size_t i) const
  {
    const Image& g = partition.image(i + 2);
    const FT foot = (std::min)((std::max)(g.image_x, g.begin), g.end);
    const bool is_on_edge = !g.is_at_infinity && g.depth <= Tolerance<FT>::closeness() * m_length;
    const std::vector<Edge_interval<FT>>& intervals = partition.intervals();
    const auto ends_before = [](const Edge_interval<FT>& other, const FT& x) { return other.end < x; };
    for(auto it = std::lower_bound(intervals.begin(), intervals.end(), g.begin, ends_before);
        it != intervals.end() && it->begin <= g.end; ++it)
    {
      const FT first = (std::max)(g.begin, it->begin), last = (std::min)(g.end, it->end);
      if((first < last && is_needed_for_tie(partition, i, it->image, first + (last - first) / 2))
         || (is_on_edge && it->begin <= foot && foot <= it->end && ties(partition, i, it->image, foot)))
        return true;
    }
    return false;
  }

  // Returns whether a window or strip ties at x with the image `nearest`, which the partition has found, and has to be
  // kept for that.
  //
  // A path along the edge may cross it or not, up to rounding, so that a window ties with one that leaves its face.
  // Each of the two is kept for the face that it enters: the other one comes to that face across another edge, where
  // it may have been removed because of this one. Of the windows of one side that tie, one is enough.
  bool is_needed_for_tie(const Edge_partition<FT>& partition, std::size_t i, std::size_t nearest, const FT& x) const
  {
    if(nearest < 2) // a corner of both faces
      return false;
    if(nearest - 2 < number_of_windows_and_strips() && is_across_halfedge(nearest - 2) == is_across_halfedge(i))
      return false;
    return ties(partition, i, nearest, x);
  }

  // Returns whether a window or strip is as near at x as the nearest image, up to the error of images.
  static bool ties(const Edge_partition<FT>& partition, std::size_t i, std::size_t nearest, const FT& x)
  {
    const FT d = partition.image(nearest).distance_at(x);
    return partition.image(i + 2).distance_at(x) <= d + partition.margin_of_tie(d);
  }

  Halfedge_id m_halfedge = null_id, m_opposite = null_id;
  FT m_length = 0;
  End m_first{}, m_last{};
  std::vector<Window_on_edge> m_windows;
  std::vector<Strip_on_edge> m_strips;
  std::vector<Image> m_paths; // to a border edge
  std::vector<Breakpoint> m_breakpoints;
  std::vector<char> m_is_needed; // by window, then by strip
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_EDGE_DIVISION_H
