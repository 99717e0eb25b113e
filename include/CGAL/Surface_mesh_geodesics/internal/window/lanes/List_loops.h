// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// The loops of Window_list_loops.h, for one number of lanes: what the functions do is said there. The results are the
// same bits for any number of lanes, since lanes are independent, and the few operations across lanes are minima and
// counts.
//
// Included once for each number of lanes; see README.md.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LANES

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {
namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE {

// Each loop processes L::size rows at a time. The last step may run past the end of the list into the padding of the
// block. Masks of the first n lanes keep these rows out of the results; values stored there are never read.
//
// Requires, of all loops: the first n rows of `columns` are the windows of a list that satisfies the invariants of a
// stored list (Window_lists.h), and Window_columns::padding more rows can be read and written. L::size divides
// suspects_in_word, so that a step never spans two words. The loops allocate nothing and throw nothing; each takes time
// linear in the number of windows.
template <typename FT, typename Rules>
class List_loops
{
  using L = Lanes<FT>;
  using Number = typename L::Number;
  using Mask = typename L::Mask;
  using Columns = Window_columns<FT>;
  using Rival = Vertex_rival<FT>;

public:
  static Window_list_loops<FT> table()
  {
    return Window_list_loops<FT>{L::size, trim,
                                 find_nearest, is_split_by,
                                 cross<Left_child<FT>>, cross<Right_child<FT>>};
  }

private:
  // Trims pairs of neighbors. Lane k of a step has window i + k and the pair that it makes with window i + k + 1. So
  // the last pair of a step reaches one window into the next step, and the loop carries from step to step what belongs
  // there:
  // - `begin` and `begin_distance`: the beginnings that the pairs have computed for their right windows. They belong
  //   one row further, so they are shifted by one lane; the one that falls out of the last lane enters the first lane
  //   of the next step. They must not be stored before that step has loaded its windows: each pair is trimmed with the
  //   original neighbors. Window 0 is in no pair as the right one and keeps its beginning.
  // - `bits`: the suspects of the current word. An undecided pair makes its right window a suspect, which may be the
  //   first window of the next word: the bit above the word, kept when the word is full.
  // The pair of the last window and the row behind it does not exist; `is_pair` masks it out.
  //
  // Afterwards a suspect may have end <= begin: the caller removes it or restores the invariants of the list.
  // Requires: no window of the list is marked; `suspects` has n / suspects_in_word words, rounded up.
  static bool trim(const Columns& columns, std::size_t n, const FT& length, const Rival& left, const Rival& right,
                   Suspects* suspects)
  {
    Number begin = L::all(columns.begin()[0]), begin_distance = L::all(columns.begin_distance()[0]);
    const FT close_depth = Tolerance<FT>::closeness() * length;
    unsigned int bits = 0, all_bits = 0;
    for(std::size_t i = 0; i < n; i += L::size)
    {
      const unsigned int position = i % suspects_in_word;
      const Window_lanes<FT> w = load_windows(columns, i);
      Mask is_suspect = L::first(0);
      if(Rules::vertex_rule)
        is_suspect = is_suspect | are_beaten_by_vertices(w, length, left, right);
      if(Rules::pair_rules)
      {
        const Trimmed_pairs<FT> pairs(w, load_windows(columns, i + 1), close_depth);
        const Mask is_pair = L::first(n - 1 - i);
        const Number end = L::select(is_pair, pairs.left_end, w.end);
        L::store(columns.end() + i, end);
        L::store(columns.end_distance() + i,
                 L::select(is_pair, pairs.left_end_distance, w.end_distance));
        begin = L::shift_in(begin, pairs.right_begin);
        begin_distance = L::shift_in(begin_distance, pairs.right_begin_distance);
        L::store(columns.begin() + i, begin);
        L::store(columns.begin_distance() + i, begin_distance);
        is_suspect = is_suspect | L::less_equal(end, begin);
        begin = pairs.right_begin;
        begin_distance = pairs.right_begin_distance;
        bits |= L::bits(is_pair & pairs.is_undecided) << (position + 1);
      }
      bits |= L::bits(L::first(n - i) & is_suspect) << position;
      suspects[i / suspects_in_word] = static_cast<Suspects>(bits);
      all_bits |= bits;
      if(position + L::size == suspects_in_word)
        bits >>= suspects_in_word;
    }
    return all_bits != 0;
  }

  // Finds the nearest window. Each lane remembers its nearest one, the first one of several that tie. At the end, the
  // lanes are compared: of those that tie, the one with the smallest index wins. So the result does not depend on the
  // number of lanes.
  // Requires: n > 0; `abscissa` has n + L::size entries.
  static Nearest_window<FT> find_nearest(const Columns& columns, std::size_t n, const Face_frame<FT>& c, FT* abscissa)
  {
    using Word = typename L::Word;
    Number distance = L::all(std::numeric_limits<FT>::infinity());
    Word index = L::count_from(0);
    const Number close_depth = L::all(FT(Tolerance<FT>::closeness() * c.length));
    Mask is_close = L::first(0);
    for(std::size_t i = 0; i < n; i += L::size)
    {
      const Window_lanes<FT> w = load_windows(columns, i);
      const Number t = apex_abscissa(w, c);
      L::store(abscissa + i, t);
      const Number d = distance_to_apex(w, c, t);
      const Mask is_window = L::first(n - i);
      is_close = is_close | (is_window & L::less_equal(w.image_depth, close_depth));
      const Mask is_better = is_window & L::less(d, distance);
      distance = L::select(is_better, d, distance);
      index = L::select_word(is_better, L::count_from(i), index);
    }
    Nearest_window<FT> nearest;
    nearest.distance = L::least(distance);
    const unsigned int ties = L::bits(L::less_equal(distance, L::all(nearest.distance)));
    nearest.index = static_cast<std::size_t>(L::least(index, ties));
    nearest.has_close_images = L::bits(is_close) != 0;
    return nearest;
  }

  // Looks for windows on the wrong side of s. `best` itself counts for neither side. For the lanes before it, best - i
  // is positive; read as signed numbers, the differences become negative behind it, and L::first() of them is empty.
  // A window that touches s is on neither side. Requires: best < n.
  static bool is_split_by(const Columns& columns, std::size_t n, std::size_t best, const FT& s)
  {
    const Number point = L::all(s);
    Mask wrong = L::first(0);
    for(std::size_t i = 0; i < n; i += L::size)
    {
      const Mask is_left = L::first(best - i), is_right = L::except(L::first(n - i), L::first(best + 1 - i));
      wrong = wrong | (is_left & L::less(point, L::load(columns.begin() + i)))
            | (is_right & L::less(L::load(columns.end() + i), point));
    }
    return L::bits(wrong) == 0;
  }

  // Makes the children of one step, stores all of them, and compacts them if some are not useful: they have no paths,
  // are slivers (narrower than Tolerance::interval()), or are beaten by a vertex. In most steps all children are
  // useful, and storing them costs no branch.
  // Requires: first <= last <= n; `abscissa` is the result of find_nearest() for the same list; the block of `batch` is
  // another one than that of `from`, and has capacity for last - first more windows.
  template <typename Child>
  static void cross(const Columns& from, std::size_t first, std::size_t last, const Face_frame<FT>& c,
                    const Edge_cut<FT>& edge, const FT* abscissa, Window_batch<FT>& batch,
                    Propagation_statistics& statistics)
  {
    const Columns to = batch.list.columns;
    const Child child(c);
    const FT length = child.length();
    const Number tolerance = L::all(FT(Tolerance<FT>::interval() * length));
    const Number infinity = L::all(std::numeric_limits<FT>::infinity());
    Number minimum_distance = infinity;
    std::size_t end = batch.list.size + batch.size;
    for(std::size_t i = first; i < last; i += L::size)
    {
      Window_lanes<FT> w = load_windows(from, i);
      const Mask is_window = L::first(last - i);
      const Mask has_paths = is_window & child(w, L::load(abscissa + i), edge.cut);
      const Mask is_wide = has_paths & L::less(tolerance, w.end - w.begin);
      w.begin_distance = w.distance_at(w.begin);
      w.end_distance = w.distance_at(w.end);
      Mask is_useful = is_wide;
      if(Rules::vertex_rule)
        is_useful = L::except(is_wide, are_beaten_by_vertices(w, length, edge.left, edge.right));
      minimum_distance = L::minimum(minimum_distance,
                                    L::select(is_useful, w.minimum_distance(), infinity));
      store_windows(to, end, w);
      const std::size_t n = (std::min)(L::size, last - i);
      const unsigned int useful = L::bits(is_useful);
      if(useful == (1u << n) - 1)
        end += n;
      else
      {
        count_removed(n, edge.whole_window - i, L::bits(has_paths), L::bits(is_wide), useful, statistics);
        end = keep_rows(to, end, useful);
      }
    }
    batch.size = end - batch.list.size;
    batch.minimum_distance = (std::min)(batch.minimum_distance, L::least(minimum_distance));
  }

  // Counts the n windows of one step that have no useful child, by reason. `whole` is the lane of the window that loses
  // no paths at the cut: Rule 1 does not remove it.
  static void count_removed(std::size_t n, std::size_t whole, unsigned int paths, unsigned int wide,
                            unsigned int useful, Propagation_statistics& statistics)
  {
    for(std::size_t k = 0; k < n; ++k)
    {
      statistics.windows_removed_by_rule_1 += k != whole && !(paths >> k & 1);
      statistics.windows_removed_as_slivers += (paths & ~wide) >> k & 1;
      statistics.windows_removed_by_vertices += (wide & ~useful) >> k & 1;
    }
  }
};

} // namespace CGAL_SURFACE_MESH_GEODESICS_LANES_NAMESPACE
} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_LANES
