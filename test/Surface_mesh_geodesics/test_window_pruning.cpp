// Tests the pruning rules against their definitions in the manual, for single windows and for lists: what remains of
// two windows of one edge, and whether a vertex removes a window. Also tests that merged lists are sorted.

#include "test_support.h"
#include "window_test_helpers.h"

#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Star_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_loops.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_pruning.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace {

using namespace window_test;

// --- two windows of one edge -----------------------------------------------------------------------------------------

// What remains of a pair: the left window ends here, the right one begins here.
struct Pair_by_definition
{
  double left_end, right_begin;
  bool is_decided; // no two distances tie up to rounding
};

// At a point K of both intervals, the left window loses its part on the right of K if it is farther there. Otherwise
// the right window loses its part on the left of K. K is each end of the shared interval.
Pair_by_definition pair_by_definition(const Window& left, const Window& right)
{
  Pair_by_definition pair{left.end, right.begin, true};
  const double first = (std::max)(left.begin, right.begin), last = (std::min)(left.end, right.end);
  for(const double k : {first, last})
  {
    const double of_left = left.distance_at(k), of_right = right.distance_at(k);
    pair.is_decided = pair.is_decided && are_different(of_left, of_right);
    if(of_right < of_left)
    {
      pair.left_end = (std::min)(pair.left_end, k);
    }
    else
    {
      pair.right_begin = (std::max)(pair.right_begin, k);
    }
    if((std::min)(pair.left_end, right.end) <= (std::max)(left.begin, pair.right_begin)) // no overlap remains
    {
      break;
    }
  }
  return pair;
}

void check_trimmed(const Window& found, double begin, double end)
{
  CHECK_EQUAL(found.begin, begin);
  CHECK_EQUAL(found.end, end);
  CHECK_CLOSE(found.begin_distance, found.distance_at(begin), 1e-14);
  CHECK_CLOSE(found.end_distance, found.distance_at(end), 1e-14);
}

void check_pair(const Window& left, const Window& right, std::size_t& number_trimmed)
{
  const Pair_by_definition expected = pair_by_definition(left, right);
  if(!expected.is_decided)
  {
    return;
  }
  Window l = left, r = right;
  const Pair_outcome outcome = internal::prune_pair(l, r);
  const bool is_left_gone = expected.left_end <= left.begin, is_right_gone = expected.right_begin >= right.end;
  CHECK_EQUAL(outcome == Pair_outcome::LEFT_IS_DOMINATED, is_left_gone);
  CHECK_EQUAL(outcome == Pair_outcome::RIGHT_IS_DOMINATED, is_right_gone);
  if(outcome == Pair_outcome::KEEP_BOTH)
  {
    check_trimmed(l, left.begin, expected.left_end);
    check_trimmed(r, expected.right_begin, right.end);
    ++number_trimmed;
  }
}

// If the paths to the innermost points cross, the point where they cross tells which window is dominated.
bool find_intersection(const Window& left, const Window& right, double& x, double& y)
{
  const double ux = left.begin - left.image_x, uy = left.image_depth;
  const double vx = right.end - right.image_x, vy = right.image_depth;
  const double wx = right.image_x - left.image_x, wy = left.image_depth - right.image_depth;
  const double det = ux * vy - uy * vx;
  if(std::abs(det) < 1e-6)
  {
    return false;
  }
  const double s = (wx * vy - wy * vx) / det, t = (wx * uy - wy * ux) / det;
  x = left.image_x + s * ux;
  y = -left.image_depth + s * uy;
  return s > 0 && s < .999 && t > 0 && t < .999; // not on the edge itself
}

bool check_crossed_pair(const Window& left, const Window& right)
{
  double x = 0, y = 0;
  if(!find_intersection(left, right, x, y))
  {
    return false;
  }
  const double of_left = left.root_distance + std::hypot(x - left.image_x, y + left.image_depth);
  const double of_right = right.root_distance + std::hypot(x - right.image_x, y + right.image_depth);
  if(!are_different(of_left, of_right))
  {
    return false;
  }
  Window l = left, r = right;
  const Pair_outcome outcome = internal::prune_pair(l, r);
  CHECK(outcome == (of_left < of_right ? Pair_outcome::RIGHT_IS_DOMINATED : Pair_outcome::LEFT_IS_DOMINATED));
  return true;
}

void pairs_are_pruned_by_definition(test_support::Random& random)
{
  std::size_t number_trimmed = 0, number_crossed = 0, number_apart = 0;
  for(std::size_t i = 0; i < 20000; ++i)
  {
    const Window left = random_window(random), right = random_window(random);
    if(left.end <= right.begin)
    {
      Window l = left, r = right;
      CHECK(internal::prune_pair(l, r) == Pair_outcome::KEEP_BOTH);
      check_trimmed(l, left.begin, left.end);
      check_trimmed(r, right.begin, right.end);
      ++number_apart;
    }
    else if(right.end <= left.begin)
    {
      number_crossed += check_crossed_pair(left, right) ? 1 : 0;
    }
    else
    {
      check_pair(left, right, number_trimmed);
    }
  }
  CHECK(number_trimmed > 1000 && number_crossed > 100 && number_apart > 1000);
}

void ties_keep_both_windows()
{
  // Two windows with the same image: no rule may remove one of them.
  Window left = window(0, .75, .5, .25, .125), right = window(.25, 1, .5, .25, .125);
  CHECK(internal::prune_pair(left, right) == Pair_outcome::KEEP_BOTH);
  check_trimmed(left, 0, .75);
  check_trimmed(right, .25, 1);
}

// --- many windows at a time ------------------------------------------------------------------------------------------

bool is_suspect(internal::Suspects suspects, unsigned int i)
{
  return (suspects >> i & 1) != 0;
}

struct Pair_rules_only : internal::No_pruning_rules
{
  static constexpr bool pair_rules = true;
};

void lists_are_trimmed_like_pairs(Lane_choice choice, test_support::Random& random)
{
  const auto loops = internal::window_list_loops<double, Pair_rules_only>(choice);
  std::size_t number_trimmed = 0, number_undecided = 0;
  for(std::size_t i = 0; i < 5000; ++i)
  {
    const Window left = random_window(random), right = random_window(random);
    Pool pool;
    const List list = list_of(pool, {left, right});
    internal::Suspects suspects = 0;
    const bool has_suspects = loops.trim(list.columns, list.size, edge_length, no_rival, no_rival, &suspects);
    CHECK_EQUAL(has_suspects, suspects != 0);
    Window l = left, r = right;
    const bool are_crossed = right.end <= left.begin;
    const bool is_undecided = are_crossed || internal::prune_pair(l, r) != Pair_outcome::KEEP_BOTH;
    CHECK_EQUAL(is_suspect(suspects, 0), false);
    CHECK_EQUAL(is_suspect(suspects, 1), is_undecided);
    const Window trimmed_left = list.columns.get(0), trimmed_right = list.columns.get(1);
    check_trimmed(trimmed_left, left.begin, is_undecided ? left.end : l.end);
    check_trimmed(trimmed_right, is_undecided ? right.begin : r.begin, right.end);
    number_undecided += is_undecided ? 1 : 0;
    number_trimmed += !is_undecided && (l.end != left.end || r.begin != right.begin) ? 1 : 0;
  }
  CHECK(number_trimmed > 100 && number_undecided > 100);
}

void ties_in_lists_keep_all_windows(Lane_choice choice)
{
  const auto loops = internal::window_list_loops<double, internal::All_pruning_rules>(choice);
  for(const double begin : {0., .25, .375})
  {
    Pool pool;
    const List list = list_of(pool, {window(.25, .75, .5, .25, .125), window(begin, .875, .5, .25, .125)});
    internal::Suspects suspects = 0;
    CHECK(!loops.trim(list.columns, list.size, edge_length, no_rival, no_rival, &suspects));
    check_trimmed(list.columns.get(0), .25, .75);
    check_trimmed(list.columns.get(1), begin, .875);
  }
}

// Three windows on nearly the same interval: each outer window is trimmed from one side, the middle one is trimmed to
// nothing from both sides and becomes a suspect.
void windows_trimmed_from_both_sides_are_suspects(Lane_choice choice)
{
  const auto loops = internal::window_list_loops<double, internal::All_pruning_rules>(choice);
  Pool pool;
  const Window left = window(0, .75, .25, .25, 0), middle = window(.25, .875, .5, .25, .75),
               right = window(.375, 1, .75, .25, 0);
  const List list = list_of(pool, {left, middle, right});
  internal::Suspects suspects = 0;
  CHECK(loops.trim(list.columns, list.size, edge_length, no_rival, no_rival, &suspects));
  CHECK(list.columns.get(1).end <= list.columns.get(1).begin);
  CHECK(is_suspect(suspects, 1));
}

void close_images_are_not_trimmed(Lane_choice choice)
{
  const auto loops = internal::window_list_loops<double, internal::All_pruning_rules>(choice);
  const double depth = internal::Tolerance<double>::closeness() * edge_length / 2;
  Pool pool;
  const Window left = window(0, .75, .25, depth, 0), right = window(.25, 1, .75, .25, 0);
  CHECK(internal::is_too_close_to_trim(left, edge_length));
  CHECK(!internal::is_too_close_to_trim(right, edge_length));
  CHECK(!internal::is_too_close_to_trim(window(.5, 1, .25, depth, 0), edge_length)); // outside its interval
  const List list = list_of(pool, {left, right});
  internal::Suspects suspects = 0;
  CHECK(loops.trim(list.columns, list.size, edge_length, no_rival, no_rival, &suspects));
  CHECK(is_suspect(suspects, 1));
  check_trimmed(list.columns.get(0), 0, .75);
  check_trimmed(list.columns.get(1), .25, 1);
}

// --- vertices --------------------------------------------------------------------------------------------------------

struct Vertex_rule_only : internal::No_pruning_rules
{
  static constexpr bool vertex_rule = true;
};

// A window is dominated if the path through an end of the edge, and along it to the far end of the interval, is
// shorter.
void vertices_remove_windows_by_definition(Lane_choice choice, test_support::Random& random)
{
  const auto loops = internal::window_list_loops<double, Vertex_rule_only>(choice);
  std::size_t number_beaten = 0, number_left = 0;
  for(std::size_t i = 0; i < 5000; ++i)
  {
    const Window w = random_window(random);
    const double at_left = random.uniform(0., 2.), at_right = random.uniform(0., 2.);
    const double by_left = at_left + w.end, by_right = at_right + (edge_length - w.begin);
    if(!are_different(by_left, w.end_distance) || !are_different(by_right, w.begin_distance))
    {
      continue;
    }
    const bool is_beaten = by_left < w.end_distance || by_right < w.begin_distance;
    const Rival left(at_left, false), right(at_right, false);
    CHECK_EQUAL(internal::is_beaten_by_vertices(w, edge_length, left, right), is_beaten);
    Pool pool;
    const List list = list_of(pool, {w});
    internal::Suspects suspects = 0;
    CHECK_EQUAL(loops.trim(list.columns, list.size, edge_length, left, right, &suspects), is_beaten);
    CHECK_EQUAL(is_suspect(suspects, 0), is_beaten);
    (is_beaten ? number_beaten : number_left) += 1;
  }
  CHECK(number_beaten > 500 && number_left > 500);
}

// In a tie the window remains, unless windows start at the vertex in all directions.
void windows_survive_ties_with_vertices_that_emit_none()
{
  const Window w = window(.25, .75, .5, .25, .5);
  const double tie = w.end_distance - w.end;
  CHECK(!internal::is_beaten_by_vertices(w, edge_length, Rival(tie, false), no_rival));
  CHECK(internal::is_beaten_by_vertices(w, edge_length, Rival(tie, true), no_rival));
  CHECK(internal::is_beaten_by_vertices(w, edge_length, Rival(tie - 1e-9, false), no_rival));
  CHECK(!internal::is_beaten_by_vertices(w, edge_length, Rival(tie + 1e-9, true), no_rival));
}

// --- the order of windows --------------------------------------------------------------------------------------------

// The root of each window is its number, so that it can be found again.
std::vector<Window> random_sorted_windows(std::size_t n, internal::Vertex_id first_number, test_support::Random& random)
{
  std::vector<Window> windows;
  for(std::size_t i = 0; i < n; ++i)
  {
    windows.push_back(random_window(random));
    windows.back().key = random.index(12);
    windows.back().steps = 2;
  }
  std::sort(windows.begin(), windows.end(), [](const Window& a, const Window& b) { return a.key < b.key; });
  for(Window& w : windows)
  {
    w.root = first_number++;
  }
  return windows;
}

// Later windows follow those with the same key and are marked, because their order is unknown.
void lists_are_merged_in_order(test_support::Random& random)
{
  for(std::size_t i = 0; i < 500; ++i)
  {
    const std::vector<Window> old = random_sorted_windows(1 + random.index(9), 0, random);
    const std::vector<Window> late = random_sorted_windows(1 + random.index(9), 100, random);
    std::vector<Window> expected = old;
    bool has_marks = false;
    for(const Window& w : late)
    {
      expected.push_back(w);
      const auto is_same = [&w](const Window& o) { return o.key == w.key; };
      if(std::any_of(old.begin(), old.end(), is_same))
      {
        expected.back().mark();
        has_marks = true;
      }
    }
    std::stable_sort(expected.begin(), expected.end(), [](const Window& a, const Window& b) { return a.key < b.key; });
    Pool pool;
    List list = list_of(pool, old), other = list_of(pool, late);
    pool.join(list, other);
    CHECK_EQUAL(list.size, expected.size());
    CHECK_EQUAL(list.may_be_marked(), has_marks);
    for(std::size_t k = 0; k < expected.size() && k < list.size; ++k)
    {
      const Window w = list.columns.get(k);
      CHECK_EQUAL(w.root, expected[k].root);
      CHECK_EQUAL(w.is_marked(), expected[k].is_marked());
      CHECK_EQUAL(w.begin, expected[k].begin);
    }
  }
}

void the_order_is_unknown_for_marked_windows_of_one_key()
{
  Window a = window(0, .5, .5, .25, 0), b = window(.25, 1, .5, .25, 0);
  CHECK(!internal::is_order_unknown(a, b));
  b.mark();
  CHECK(internal::is_order_unknown(a, b));
  CHECK(internal::is_order_unknown(b, a));
  b.key = a.key / 2;
  CHECK(!internal::is_order_unknown(a, b));
}

void the_smallest_distance_is_that_of_a_point(test_support::Random& random)
{
  for(std::size_t i = 0; i < 1000; ++i)
  {
    const Window w = random_window(random);
    double smallest = (std::min)(w.begin_distance, w.end_distance);
    if(w.begin < w.image_x && w.image_x < w.end)
    {
      smallest = (std::min)(smallest, w.distance_at(w.image_x));
    }
    CHECK_CLOSE(w.minimum_distance(), smallest, 1e-14);
  }
}

// An improvement of the order of rounding does not start new windows.
void improvements_by_rounding_are_ignored_where_windows_start()
{
  const double infinity = std::numeric_limits<double>::infinity(), rounded = std::nextafter(.75, 0.);
  for(const bool may_emit : {true, false})
  {
    CHECK_EQUAL(internal::is_improvement(rounded, .75, may_emit), !may_emit);
    CHECK(internal::is_improvement(.75 - 1e-12, .75, may_emit));
    CHECK(internal::is_improvement(.75, infinity, may_emit));
    CHECK(!internal::is_improvement(.75, .75, may_emit));
    CHECK(!internal::is_improvement(.75, rounded, may_emit));
  }
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20261121));
  pairs_are_pruned_by_definition(random);
  ties_keep_both_windows();
  for(const Lane_choice choice : {Lane_choice::ONE, Lane_choice::TWO, Lane_choice::FOUR, Lane_choice::BEST})
  {
    lists_are_trimmed_like_pairs(choice, random);
    ties_in_lists_keep_all_windows(choice);
    windows_trimmed_from_both_sides_are_suspects(choice);
    close_images_are_not_trimmed(choice);
    vertices_remove_windows_by_definition(choice, random);
  }
  windows_survive_ties_with_vertices_that_emit_none();
  lists_are_merged_in_order(random);
  the_order_is_unknown_for_marked_windows_of_one_key();
  the_smallest_distance_is_that_of_a_point(random);
  improvements_by_rounding_are_ignored_where_windows_start();
  return test_support::test_result();
}
