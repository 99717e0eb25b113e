// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_LIST_CROSSING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_LIST_CROSSING_H

// One window list across one face (thesis, 4.2.3). prune() removes dominated windows, find_apex_path() finds the
// nearest window for the apex C (Rule 1), and split() propagates the list to the two other edges.
//
// Frame: that of the halfedge AB across which the list enters the face ABC (Window.h, Face_frame); lists on the two
// other edges are in the frames of AC and CB.
//
// Neighbors in a sorted list are pruned against each other on every fourth edge that the list crosses, when it is about
// to be propagated and all lists that reach the edge have been merged into it. So Rule 2 (one list) and Rule 3 (merged
// lists) are one pass.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_loops.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/bit_counting.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_pruning.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The corners A, B and C of a face as rivals of the windows that enter it across AB.
template <typename FT>
struct Corner_rivals
{
  Vertex_rival<FT> origin, target, apex;
};

// Use, for each list: prune(); if a window is left, find_apex_path(); then split(). left() and right() are the results
// until the next split(). The object keeps buffers between lists, and nothing about one list that the next one sees.
// Linear in the number of windows: trimming and splitting look at each window a few times, and an examination of
// suspects that goes back removes a window at each step.
template <typename FT, typename Rules>
class Window_list_crossing
{
  using Loops = Loops_by_length<Window_list_loops<FT>>;

public:
  // The shortest path to C through the list.
  struct Apex_path
  {
    std::size_t index; // of the window in the list
    FT distance;
    FT separating_point; // the abscissa where the path crosses AB, within the interval of the window (thesis, 4.2.3.1)
    FT image_x, image_depth; // of the window, in the frame of AB
    Vertex_id root;
  };

  Window_list_crossing(const Intrinsic_mesh<FT>& mesh, const std::vector<FT>& distance,
                       Propagation_statistics& statistics, Lane_choice lanes = Lane_choice::BEST)
    : m_mesh(mesh), m_distance(distance), m_statistics(statistics),
      m_loops(lanes, window_list_loops<FT, Rules>)
  {}

  // Tells this object whether distances of pseudo-sources may have shrunk after their windows were made.
  void expect_stale_windows(bool are_expected) { m_has_stale_windows = are_expected; }

  // Removes windows that are dominated on the edge itself: windows of a pseudo-source that has been improved since,
  // windows beaten by a vertex or by a neighbor, and windows that have crossed more faces than any shortest path does
  // (Intrinsic_mesh.h).
  //
  // First, all windows are trimmed against their original neighbors. Those that may be dominated become suspects, which
  // are then examined one by one. The order of pruning does not matter: each removed path is longer than some path on
  // the surface. Lists are pruned on every fourth edge only. To remove a window later costs less than to look for it on
  // each edge.
  // Requires: the list is valid. It is so afterward; in between, trimming may leave empty intervals.
  void prune(Window_list<FT>& list, const Face_frame<FT>& c, const Corner_rivals<FT>& corners)
  {
    CGAL_expensive_assertion(internal::is_valid(list, c.length));
    const bool is_unusual = list.may_be_marked() || list.number_of_faces_crossed() > m_mesh.most_faces_crossed();
    const bool is_suspicious = is_unusual || (m_has_stale_windows && has_stale_windows(list));
    if(list.number_of_faces_crossed() % edges_for_pruning != 0 && !is_suspicious)
      return;
    const bool has_suspects = is_suspicious ? suspect_all(list) : trim(list, c, corners);
    if(has_suspects)
      remove_dominated_suspects(list, c, corners);
    CGAL_expensive_assertion(internal::is_valid(list, c.length));
  }

  // Finds the shortest path to C through a list; the first one if several tie. Requires: the list is not empty.
  Apex_path find_apex_path(const Window_list<FT>& list, const Face_frame<FT>& c)
  {
    CGAL_assertion(list.size > 0);
    if(m_abscissa.size() < list.size + m_loops.lanes())
      m_abscissa.resize(2 * list.size + m_loops.lanes());
    const Nearest_window<FT> nearest = m_loops(list.size).find_nearest(list.columns, list.size, c, m_abscissa.data());
    m_has_close_images = nearest.has_close_images;
    Apex_path best;
    best.index = nearest.index;
    best.distance = nearest.distance;
    straighten(list, c, best);
    const Window<FT> w = list.columns.get(best.index);
    best.separating_point = (std::min)((std::max)(m_abscissa[best.index], w.begin), w.end);
    best.image_x = w.image_x;
    best.image_depth = w.image_depth;
    best.root = w.root;
    return best;
  }

  // Splits a list at its separating point (Rule 1; thesis, 4.2.3.1) and propagates it to the two other edges, into the
  // spare capacity behind the given lists; a list without a block gets nothing.
  //
  // Windows before the nearest one send their paths to the left edge only, those after it to the right edge: by the
  // order of the keys, their other paths cross the shortest path to C, and are longer beyond. The nearest window itself
  // loses no paths. Where that proof fails, the list is split window by window: if the order of windows is unknown, an
  // image may be too close to its edge, or an interval contradicts the order.
  //
  // The new windows have crossed one more face, which is two steps more; the lists get them by Window_pool::add().
  // Requires: `path` is the result of the last call of find_apex_path(), for the same list; a list with a block has
  // spare capacity for list.size more windows.
  void split(const Window_list<FT>& list, const Face_frame<FT>& c, const Corner_rivals<FT>& corners,
             const Apex_path& path, const Window_list<FT>& left_space, const Window_list<FT>& right_space)
  {
    m_left.start(left_space, list.steps + 2);
    m_right.start(right_space, list.steps + 2);
    CGAL_assertion(path.index < list.size);
    const FT& s = path.separating_point;
    Edge_cut<FT> to_left{corners.origin, corners.apex, s, path.index};
    Edge_cut<FT> to_right{corners.apex, corners.target, s, path.index};
    if(Rules::rule_1 && !list.may_be_marked() && !m_has_close_images
       && m_loops(list.size).is_split_by(list.columns, list.size, path.index, s))
    {
      cross(&Window_list_loops<FT>::cross_left, list, 0, path.index + 1, c, to_left, m_left);
      cross(&Window_list_loops<FT>::cross_right, list, path.index, list.size, c, to_right, m_right);
    }
    else
      split_one_by_one(list, c, path, to_left, to_right);
    CGAL_expensive_assertion(is_valid(m_left, c.left_length) && is_valid(m_right, c.right_length));
  }

  const Window_batch<FT>& left() const { return m_left; }
  const Window_batch<FT>& right() const { return m_right; }

private:
  static constexpr std::uint32_t edges_for_pruning = 4;

  // Returns whether a window of the list has a pseudo-source that has been improved since the window was made.
  bool has_stale_windows(const Window_list<FT>& list) const
  {
    for(std::size_t i = 0; i < list.size; ++i)
      if(list.columns.root_distance()[i] > m_distance[static_cast<Vertex_id>(list.columns.history()[i])])
        return true;
    return false;
  }

  // Replaces a path that bends at the end of its interval by a straighter one through the next window if that is not
  // clearly longer. The bend costs only the square of the shift, which rounding may hide. But the list is split where
  // the path crosses it, and the whole shift would become a gap between the children.
  void straighten(const Window_list<FT>& list, const Face_frame<FT>& c, Apex_path& best) const
  {
    const bool is_to_right = m_abscissa[best.index] > list.columns.end()[best.index];
    const bool is_to_left = m_abscissa[best.index] < list.columns.begin()[best.index];
    while(is_to_right ? best.index + 1 < list.size : is_to_left && best.index > 0)
    {
      const std::size_t next = is_to_right ? best.index + 1 : best.index - 1;
      const Window<FT> w = list.columns.get(next);
      const FT t = m_abscissa[next], s = (std::min)((std::max)(t, w.begin), w.end);
      const bool is_straighter = is_to_right ? t >= w.begin && s > list.columns.end()[best.index]
                                             : t <= w.end && s < list.columns.begin()[best.index];
      if(!is_straighter
         || is_clearly_less(best.distance, FT(w.distance_at(s) + norm<FT>(c.apex_x - s, c.apex_y))))
        return;
      best.index = next;
    }
  }

  // Makes all windows of a list suspects: marked neighbors must not be trimmed all at once. Recomputes the steps, as
  // windows that made the list unusual may be gone. Returns true.
  bool suspect_all(Window_list<FT>& list)
  {
    list.steps = 0;
    for(std::size_t i = 0; i < list.size; ++i)
      list.steps = joined_steps(list.steps, list.columns.get(i).steps);
    m_suspects.assign(list.size / suspects_in_word + 1, static_cast<Suspects>(~0u));
    return true;
  }

  // Trims the windows of a list against their neighbors. Returns whether there are suspects.
  bool trim(const Window_list<FT>& list, const Face_frame<FT>& c, const Corner_rivals<FT>& corners)
  {
    if(m_suspects.size() < list.size / suspects_in_word + 1)
      m_suspects.resize(2 * list.size / suspects_in_word + 1);
    return m_loops(list.size).trim(list.columns, list.size, c.length, corners.origin, corners.target,
                                   m_suspects.data());
  }

  // The first suspect from i on among the first n windows, or n.
  std::size_t next_suspect(std::size_t i, std::size_t n) const
  {
    while(i < n)
    {
      const unsigned int rest = unsigned(m_suspects[i / suspects_in_word]) >> i % suspects_in_word;
      if(rest != 0)
        return (std::min)(i + trailing_zeros(rest), n);
      i = (i / suspects_in_word + 1) * suspects_in_word;
    }
    return n;
  }

  // Examines the suspects, and the windows whose left neighbor has been removed or trimmed. The windows [0, last) are
  // done and stay; those from i on are still to come; the rows in between are free. Runs of windows that need no look
  // are moved as a whole.
  void remove_dominated_suspects(Window_list<FT>& list, const Face_frame<FT>& c,
                                 const Corner_rivals<FT>& corners)
  {
    const Vertex_rival<FT> left = corners.origin, right = corners.target;
    std::size_t last = 0; // the end of the windows that are done
    bool is_changed = false; // whether the left neighbor of window i is not what trim() has compared it with
    for(std::size_t i = 0; i < list.size;)
    {
      const std::size_t first = i;
      if(!is_changed)
        i = next_suspect(i, list.size);
      if(last != first)
        list.columns.move_down(first, i, last);
      last += i - first;
      if(i == list.size)
        break;
      Window<FT> w = list.columns.get(i++);
      const FT begin = w.begin;
      is_changed = true;
      if(!is_dominated(w, c.length, left, right) && survives_neighbors(list, last, w, c.length))
      {
        is_changed = w.begin != begin;
        list.columns.set(last++, w);
      }
    }
    list.size = static_cast<std::uint32_t>(last);
  }

  // Is w dominated by itself, whatever its neighbors are? Stale windows, and those that have crossed too many faces,
  // are counted with those that a vertex beats.
  bool is_dominated(const Window<FT>& w, const FT& length, const Vertex_rival<FT>& left,
                    const Vertex_rival<FT>& right)
  {
    if(!(w.begin < w.end)) // trimmed from both sides
    {
      ++m_statistics.windows_removed_by_rules_2_and_3;
      return true;
    }
    if(w.root_distance > m_distance[w.root] || w.number_of_faces_crossed() > m_mesh.most_faces_crossed()
       || (Rules::vertex_rule && is_beaten_by_vertices(w, length, left, right)))
    {
      ++m_statistics.windows_removed_by_vertices;
      return true;
    }
    return false;
  }

  // Prunes w against the first `last` windows, from the nearest one on, until one of them stays (thesis, 4.2.3.2:
  // linear time in all). Returns false if w itself is dominated.
  bool survives_neighbors(Window_list<FT>& list, std::size_t& last, Window<FT>& w,
                           const FT& length)
  {
    while(Rules::pair_rules && last != 0)
    {
      if(list.columns.end()[last - 1] <= w.begin)
        return true;
      Window<FT> neighbor = list.columns.get(last - 1);
      if(is_too_close_to_trim(neighbor, length) || is_too_close_to_trim(w, length))
        return true;
      if(is_order_unknown(neighbor, w))
      {
        ++m_statistics.ambiguous_pairs;
        return true;
      }
      switch(prune_pair(neighbor, w))
      {
      case Pair_outcome::KEEP_BOTH:
        list.columns.set(last - 1, neighbor);
        return true;
      case Pair_outcome::RIGHT_IS_DOMINATED:
        ++m_statistics.windows_removed_by_rules_2_and_3;
        return false;
      case Pair_outcome::LEFT_IS_DOMINATED:
        ++m_statistics.windows_removed_by_rules_2_and_3;
        --last;
      }
    }
    return true;
  }

  // Splits a list window by window. A window keeps both sides if its position relative to the nearest one is unknown,
  // or if it lies wholly on the other side of the separating point than its key says: then nothing can be proved. The
  // cuts at the ends of AB let all of its paths go to both edges.
  void split_one_by_one(const Window_list<FT>& list, const Face_frame<FT>& c, const Apex_path& path,
                        Edge_cut<FT> to_left, Edge_cut<FT> to_right)
  {
    const FT& s = path.separating_point;
    const Window<FT> best = list.columns.get(path.index);
    for(std::size_t i = 0; i < list.size; ++i)
    {
      const Window<FT> w = list.columns.get(i);
      const bool keeps_both = !Rules::rule_1 || i == path.index || is_order_unknown(w, best)
                           || is_too_close_to_trim(w, c.length)
                           || (i < path.index ? w.begin > s : w.end < s);
      to_left.whole_window = to_right.whole_window = keeps_both ? i : path.index;
      to_left.cut = keeps_both ? c.length : s;
      to_right.cut = keeps_both ? FT(0) : s;
      if(keeps_both || i < path.index)
        cross(&Window_list_loops<FT>::cross_left, list, i, i + 1, c, to_left, m_left);
      if(keeps_both || i > path.index)
        cross(&Window_list_loops<FT>::cross_right, list, i, i + 1, c, to_right, m_right);
    }
  }

  // Are the new windows of a batch valid on an edge of the given length?
  static bool is_valid(const Window_batch<FT>& batch, const FT& length)
  {
    for(std::size_t i = 0; i < batch.size; ++i)
      if(!internal::is_valid(batch.list.columns.get(batch.list.size + i), length))
        return false;
    return true;
  }

  // Appends the children of the windows [first, last) to the batch of one edge, if it has a block. The loop is chosen
  // by the number of these windows, not by that of the list.
  void cross(typename Window_list_loops<FT>::Cross Window_list_loops<FT>::*loop, const Window_list<FT>& list,
             std::size_t first, std::size_t last, const Face_frame<FT>& c, const Edge_cut<FT>& edge,
             Window_batch<FT>& batch)
  {
    if(batch.has_block())
      (m_loops(last - first).*loop)(list.columns, first, last, c, edge, m_abscissa.data(), batch, m_statistics);
  }

  const Intrinsic_mesh<FT>& m_mesh;
  const std::vector<FT>& m_distance; // of the vertices
  Propagation_statistics& m_statistics;
  const Loops m_loops;
  bool m_has_stale_windows = false; // there may be windows of a pseudo-source that has been improved since
  bool m_has_close_images = false;  // some windows of the list may be too close to trim
  Window_batch<FT> m_left, m_right;
  // The apex_abscissa of each window of the list, from find_apex_path() to split(). There is room for a full step of
  // lanes behind the last one.
  std::vector<FT> m_abscissa;
  std::vector<Suspects> m_suspects; // among the windows of the list, while it is pruned
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_LIST_CROSSING_H
