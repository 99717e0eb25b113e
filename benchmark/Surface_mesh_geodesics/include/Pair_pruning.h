// What is done with pairs of windows of one list when the list is about to cross a face: the variants of VTP that the
// thesis compares in section 4.2.4, as policies of Scheduled_propagation.
//
// A policy has
// - Rules: the switches of the package (Pruning_rules.h);
// - prune(list, length): what it does to the windows of a list on an edge of this length after Rules have been applied;
// - separate(list, c, nearest): what it does to the windows of a list once the window is known through which the path
//   to the apex C is shortest, before the list is split.
//
// As in the package, pairs are pruned on every fourth edge that a list crosses; the thesis prunes them on every edge.

#ifndef PAIR_PRUNING_H
#define PAIR_PRUNING_H

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_pruning.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace schedulers {

namespace geodesics = CGAL::Surface_mesh_geodesics::internal;

// Does nothing beyond its rules: the base of the policies.
template <class Rules_>
struct Rules_alone
{
  using Rules = Rules_;

  template <class List, class FT>
  void prune(List&, const FT&)
  {}

  template <class List, class Frame>
  void separate(const List&, const Frame&, std::size_t)
  {}
};

struct Rules_without_pairs : geodesics::All_pruning_rules
{
  static constexpr bool pair_rules = false;
};

struct Vertex_rule_alone : geodesics::No_pruning_rules
{
  static constexpr bool vertex_rule = true;
};

// With trimming: neighbors are pruned and trimmed by Rules 2 and 3, as everywhere in the package. This is VTP.
using Neighbor_pruning = Rules_alone<geodesics::All_pruning_rules>;

// Without trimming: no two windows are compared (thesis, figure 4.15).
using Without_pairs = Rules_alone<Rules_without_pairs>;

template <class FT>
bool are_pairs_pruned_on_this_edge(const geodesics::Window_list<FT>& list)
{
  return list.number_of_faces_crossed() % 4 == 0;
}

// Prunes the windows of a list one after the other, on every fourth edge. survives(last, w) prunes the next window w
// against the first `last` windows, which are left of those before it. It may change and remove these. It returns false
// if w is dominated.
template <class FT, class Survives>
void prune_in_order(geodesics::Window_list<FT>& list, const Survives& survives)
{
  if(!are_pairs_pruned_on_this_edge(list))
  {
    return;
  }
  std::size_t last = 0;
  for(std::size_t i = 0; i < list.size; ++i)
  {
    geodesics::Window<FT> w = list.columns.get(i);
    if(survives(last, w))
    {
      list.columns.set(last++, w);
    }
  }
  list.size = static_cast<std::uint32_t>(last);
}

// May the rules for pairs be applied to two windows of an edge? (See Window_list_crossing::survives_neighbors().)
template <class FT>
bool is_pair_decidable(const geodesics::Window<FT>& left, const geodesics::Window<FT>& right, const FT& length)
{
  return !geodesics::is_too_close_to_trim(left, length) && !geodesics::is_too_close_to_trim(right, length) &&
         !geodesics::is_order_unknown(left, right);
}

// VTP-Exhaustive (table 4.1): Rules 2 and 3 for all pairs of windows of a list. Quadratic in the size of the list.
struct Exhaustive_pruning : Rules_alone<geodesics::All_pruning_rules>
{
  template <class FT>
  void prune(geodesics::Window_list<FT>& list, const FT& length)
  {
    prune_in_order(list, [&](std::size_t& last, geodesics::Window<FT>& w)
                   { return prune_against_all(list, last, w, length); });
  }

private:
  // Prunes w against each of the first `last` windows, and closes the gaps of those that are removed. Returns false if
  // w is dominated.
  template <class FT>
  static bool prune_against_all(geodesics::Window_list<FT>& list, std::size_t& last, geodesics::Window<FT>& w,
                                const FT& length)
  {
    bool survives = true;
    std::size_t kept = 0;
    for(std::size_t i = 0; i < last; ++i)
    {
      geodesics::Window<FT> other = list.columns.get(i);
      if(survives && is_pair_decidable(other, w, length))
      {
        const geodesics::Pair_outcome outcome = geodesics::prune_pair(other, w);
        survives = outcome != geodesics::Pair_outcome::RIGHT_IS_DOMINATED;
        if(outcome == geodesics::Pair_outcome::LEFT_IS_DOMINATED)
        {
          continue;
        }
      }
      list.columns.set(kept++, other);
    }
    last = kept;
    return survives;
  }
};

// VTP-Trimming (table 4.2): neighbors that overlap are cut at the point where both are at the same distance, which is a
// root of a quadratic equation (Surazhsky et al. 2005). One that is farther on the whole overlap loses it, or is
// removed.
struct Bisector_trimming : Rules_alone<Rules_without_pairs>
{
  template <class FT>
  void prune(geodesics::Window_list<FT>& list, const FT& length)
  {
    prune_in_order(list, [&](std::size_t& last, geodesics::Window<FT>& w)
                   { return trim_against_neighbors(list, last, w, length); });
  }

private:
  // Trims w against the first `last` windows, from the nearest one on, until one of them stays. Returns false if w is
  // dominated.
  template <class FT>
  static bool trim_against_neighbors(geodesics::Window_list<FT>& list, std::size_t& last, geodesics::Window<FT>& w,
                                     const FT& length)
  {
    while(last != 0)
    {
      geodesics::Window<FT> neighbor = list.columns.get(last - 1);
      if(neighbor.end <= w.begin || !is_pair_decidable(neighbor, w, length))
      {
        return true;
      }
      const geodesics::Pair_outcome outcome = geodesics::prune_pair(neighbor, w);
      if(outcome == geodesics::Pair_outcome::RIGHT_IS_DOMINATED)
      {
        return false;
      }
      if(outcome == geodesics::Pair_outcome::KEEP_BOTH)
      {
        cut_at_bisector(neighbor, w);
        list.columns.set(last - 1, neighbor);
        return true;
      }
      --last;
    }
    return true;
  }

  // Cuts two windows where they are at the same distance, if the left one is nearer at the beginning of their overlap
  // and the right one at its end. Does nothing if rounding hides the point.
  template <class FT>
  static void cut_at_bisector(geodesics::Window<FT>& left, geodesics::Window<FT>& right)
  {
    const FT first = right.begin, last = left.end;
    if(!(left.begin < first && first < last && last < right.end))
    {
      return;
    }
    const auto difference = [&](const FT& x) { return left.distance_at(x) - right.distance_at(x); };
    if(!(difference(first) < 0 && difference(last) > 0))
    {
      return;
    }
    FT x = 0;
    if(!find_equal_distance(left, right, first, last, x))
    {
      return;
    }
    left.end = right.begin = x;
    left.end_distance = left.distance_at(x);
    right.begin_distance = right.distance_at(x);
  }

  // Finds the x between `first` and `last` with s1 + |x - p1| = s2 + |x - p2| on the edge: with u = x - p2.x,
  // d = p2.x - p1.x and D = s2 - s1, squaring twice gives ((u + d)^2 + y1^2 - u^2 - y2^2 - D^2)^2 = 4 D^2 (u^2 + y2^2).
  // Returns false unless both distances agree up to rounding there.
  template <class FT>
  static bool find_equal_distance(const geodesics::Window<FT>& left, const geodesics::Window<FT>& right,
                                  const FT& first, const FT& last, FT& x)
  {
    using std::sqrt;
    const FT d = right.image_x - left.image_x, difference = right.root_distance - left.root_distance;
    const FT square = 4 * difference * difference;
    const FT k = d * d + left.image_depth * left.image_depth - right.image_depth * right.image_depth -
                 difference * difference;
    // a u^2 + 2 b u + c = 0
    const FT a = 4 * d * d - square, b = 2 * d * k, c = k * k - square * right.image_depth * right.image_depth;
    const FT discriminant = b * b - a * c;
    if(!(discriminant >= 0))
    {
      return false;
    }
    const FT q = -(b + (b < 0 ? -sqrt(discriminant) : sqrt(discriminant)));
    for(const FT& u : {FT(q / a), FT(c / q)})
    {
      x = right.image_x + u;
      if(!(first < x && x < last))
      {
        continue;
      }
      const FT of_left = left.distance_at(x), of_right = right.distance_at(x);
      if(!geodesics::is_clearly_less(of_left, of_right) && !geodesics::is_clearly_less(of_right, of_left))
      {
        return true;
      }
    }
    return false;
  }
};

// VTP-CH (table 4.3): the rules of Chen and Han (1990) and of Xin and Wang (2009). Windows are checked with vertices.
// Of those that cover C, only the nearest one has children on both edges ("one angle, one split"); each of the others
// has one child, on the side that its order gives it.
struct One_split_for_each_angle : Rules_alone<Vertex_rule_alone>
{
  template <class FT>
  void separate(const geodesics::Window_list<FT>& list, const geodesics::Face_frame<FT>& c, std::size_t nearest)
  {
    const geodesics::Window<FT> best = list.columns.get(nearest);
    if(!covers_apex(best, c))
    {
      return;
    }
    for(std::size_t i = 0; i < list.size; ++i)
    {
      geodesics::Window<FT> w = list.columns.get(i);
      if(i == nearest || !covers_apex(w, c) || !is_pair_decidable(w, best, c.length))
      {
        continue;
      }
      const FT t = apex_abscissa(w, c);
      (i < nearest ? w.end : w.begin) = t;
      (i < nearest ? w.end_distance : w.begin_distance) = w.distance_at(t);
      list.columns.set(i, w);
    }
  }

private:
  // The abscissa at which the line from the image to C meets the edge.
  template <class FT>
  static FT apex_abscissa(const geodesics::Window<FT>& w, const geodesics::Face_frame<FT>& c)
  {
    return (w.image_x * c.apex_y + c.apex_x * w.image_depth) / (c.apex_y + w.image_depth);
  }

  template <class FT>
  static bool covers_apex(const geodesics::Window<FT>& w, const geodesics::Face_frame<FT>& c)
  {
    const FT t = apex_abscissa(w, c);
    return w.begin < t && t < w.end;
  }
};

} // namespace schedulers

#endif // PAIR_PRUNING_H
