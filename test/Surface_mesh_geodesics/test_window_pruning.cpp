// The rules that prune windows, window by window: what is left of two windows of one edge, and whether a vertex takes
// one away, is what the definitions in the manual say, for one window at a time and for many; and lists of windows are
// merged in order.

#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Star_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_crossing.h>
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

namespace SMG = CGAL::Surface_mesh_geodesics;
namespace internal = SMG::internal;
using Window = internal::Window<double>;
using Rival = internal::Vertex_rival<double>;
using Pool = internal::Window_pool<double>;
using List = internal::Window_list<double>;
using internal::Lane_choice;
using internal::Pair_outcome;

const double edge_length = 1;
const Rival no_rival(std::numeric_limits<double>::infinity(), false);

Window window(double begin, double end, double image_x, double image_depth, double root_distance)
{
  Window w;
  w.begin = begin;
  w.end = end;
  w.image_x = image_x;
  w.image_depth = image_depth;
  w.root_distance = root_distance;
  w.begin_distance = w.distance_at(begin);
  w.end_distance = w.distance_at(end);
  w.key = internal::initial_window_key;
  w.root = 0;
  w.steps = 0;
  return w;
}

Window random_window(test_support::Random& random)
{
  // a few places only, so that intervals share ends as well
  const double a = .125 * static_cast<double>(random.index(8)), b = .125 * static_cast<double>(random.index(8));
  return window((std::min)(a, b), (std::max)(a, b) + .125, random.uniform(-1., 2.), random.uniform(.05, 1.5),
                random.uniform(0., .5));
}

// are two distances so different that rounding does not decide which one is less?
bool are_different(double a, double b)
{
  return !test_support::is_close(a, b, 1e-9);
}

// --- two windows of one edge -----------------------------------------------------------------------------------------

// What the rule of pairs leaves: the left window ends here, and the right one begins here.
struct Pair_by_definition
{
  double left_end, right_begin;
  bool is_decided; // no two distances nearly tie
};

// At a point K of both windows, the left one loses what is on the right of K if it is farther there, else the right one
// what is on the left of K. K is put at both ends of what the intervals share.
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
    if((std::min)(pair.left_end, right.end) <= (std::max)(left.begin, pair.right_begin)) // nothing is shared any more
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
  CHECK_EQUAL(outcome == Pair_outcome::LEFT_IS_REDUNDANT, is_left_gone);
  CHECK_EQUAL(outcome == Pair_outcome::RIGHT_IS_REDUNDANT, is_right_gone);
  if(outcome == Pair_outcome::KEEP_BOTH)
  {
    check_trimmed(l, left.begin, expected.left_end);
    check_trimmed(r, expected.right_begin, right.end);
    ++number_trimmed;
  }
}

// The point where the paths to the innermost points cross, if they do, tells which window is redundant.
bool find_crossing(const Window& left, const Window& right, double& x, double& y)
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
  if(!find_crossing(left, right, x, y))
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
  CHECK(outcome == (of_left < of_right ? Pair_outcome::RIGHT_IS_REDUNDANT : Pair_outcome::LEFT_IS_REDUNDANT));
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

void ties_are_left_alone()
{
  // the same image twice: no rule may give one of the windows up
  Window left = window(0, .75, .5, .25, .125), right = window(.25, 1, .5, .25, .125);
  CHECK(internal::prune_pair(left, right) == Pair_outcome::KEEP_BOTH);
  check_trimmed(left, 0, .75);
  check_trimmed(right, .25, 1);
}

// --- many windows at a time ------------------------------------------------------------------------------------------

List list_of(Pool& pool, const std::vector<Window>& windows)
{
  List list = pool.allocate(windows.size());
  for(std::size_t i = 0; i < windows.size(); ++i)
  {
    list.columns.set(i, windows[i]);
    list.steps = internal::joined_steps(list.steps, windows[i].steps);
  }
  list.size = static_cast<std::uint32_t>(windows.size());
  return list;
}

// The window that follows is redundant, or may be, or has to be looked at for itself.
bool is_suspect(internal::Suspects suspects, unsigned int i)
{
  return (suspects >> i & 1) != 0;
}

void lists_are_trimmed_like_pairs(Lane_choice choice, test_support::Random& random)
{
  const auto loops = internal::window_list_loops<double, internal::All_pruning_rules>(choice);
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

void ties_in_lists_are_left_alone(Lane_choice choice)
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

// Three windows on the same interval: those at the sides are trimmed from one side each, the middle one is trimmed to
// nothing by both, and is a suspect for that.
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
  CHECK(!internal::is_too_close_to_trim(window(.5, 1, .25, depth, 0), edge_length)); // beside its interval
  const List list = list_of(pool, {left, right});
  internal::Suspects suspects = 0;
  CHECK(loops.trim(list.columns, list.size, edge_length, no_rival, no_rival, &suspects));
  CHECK(is_suspect(suspects, 1));
  check_trimmed(list.columns.get(0), 0, .75);
  check_trimmed(list.columns.get(1), .25, 1);
}

// --- vertices --------------------------------------------------------------------------------------------------------

// A window is redundant if the way through an end of the edge, and along it to the far end of the interval, is shorter.
void vertices_take_windows_away_by_definition(Lane_choice choice, test_support::Random& random)
{
  const auto loops = internal::window_list_loops<double, internal::All_pruning_rules>(choice);
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

// Of a tie the window remains, unless windows start at the vertex in all directions.
void ties_with_vertices()
{
  const Window w = window(.25, .75, .5, .25, .5);
  const double tie = w.end_distance - w.end;
  CHECK(!internal::is_beaten_by_vertices(w, edge_length, Rival(tie, false), no_rival));
  CHECK(internal::is_beaten_by_vertices(w, edge_length, Rival(tie, true), no_rival));
  CHECK(internal::is_beaten_by_vertices(w, edge_length, Rival(tie - 1e-9, false), no_rival));
  CHECK(!internal::is_beaten_by_vertices(w, edge_length, Rival(tie + 1e-9, true), no_rival));
}

// --- the order of windows --------------------------------------------------------------------------------------------

// `number` of the window goes into the root, so that it can be found again.
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

// Windows that come later are put behind those with the same key, and marked, for their order is not known.
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

// Windows do not start once more for what rounding may have made of a distance.
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

// --- a list across a face --------------------------------------------------------------------------------------------

// One equilateral triangle with sides of the length 1, and the list that comes to its first side.
struct One_face
{
  internal::Intrinsic_mesh<double> mesh;
  std::vector<double> distance; // of the vertices, from which all windows come
  SMG::Propagation_statistics statistics;
  internal::Window_list_crossing<double, internal::All_pruning_rules> crossing;
  internal::Face_frame<double> across;
  internal::Corner_rivals<double> corners{no_rival, no_rival, no_rival};
  Pool pool;

  explicit One_face(Lane_choice choice)
    : distance(3, std::numeric_limits<double>::infinity()),
      crossing(mesh, distance, statistics, choice)
  {
    mesh.reset(1);
    internal::Intrinsic_face<double>& face = mesh.face(0);
    face.length = {1., 1., 1.};
    face.apex_x = .5;
    face.apex_y = std::sqrt(.75);
    face.vertex = {0, 1, 2};
    face.opposite = {internal::null_id, internal::null_id, internal::null_id};
    mesh.finish(3);
    across = mesh.face_frame(internal::halfedge_of(0, 0));
  }
};

// Windows side by side, each with an image of its own, so that none has to do with its neighbours. The root is the
// first vertex.
std::vector<Window> windows_side_by_side(std::size_t n, test_support::Random& random)
{
  std::vector<Window> windows;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double begin = static_cast<double>(i) / static_cast<double>(n),
                 end = static_cast<double>(i + 1) / static_cast<double>(n);
    windows.push_back(window(begin, end, random.uniform(0., 1.), random.uniform(.05, 1.), random.uniform(0., 1.)));
    windows.back().steps = 0; // on the first edge lists are pruned, and on every fourth one after it
    windows.back().key += i; // in order
  }
  return windows;
}

// prunes a list, and checks that just the windows are left that are expected.
void check_pruned(One_face& face, const std::vector<Window>& windows, const std::vector<bool>& remains)
{
  List list = list_of(face.pool, windows);
  face.crossing.prune(list, face.across, face.corners);
  std::vector<std::uint64_t> found, expected;
  for(std::size_t i = 0; i < list.size; ++i)
  {
    found.push_back(list.columns.get(i).key);
  }
  for(std::size_t i = 0; i < windows.size(); ++i)
  {
    if(remains[i])
    {
      expected.push_back(windows[i].key);
    }
  }
  CHECK(found == expected);
  face.pool.release(list);
}

void lists_lose_what_vertices_take(Lane_choice choice, test_support::Random& random)
{
  for(std::size_t n = 1; n < 70; n += 1 + n / 3)
  {
    One_face face(choice);
    for(const double range : {.9, 1.5, 3.}) // from most windows to few
    {
      const Rival left(random.uniform(0., range), false), right(random.uniform(0., range), false);
      face.corners.origin = left;
      face.corners.target = right;
      const std::vector<Window> windows = windows_side_by_side(n, random);
      std::vector<bool> remains;
      for(const Window& w : windows)
      {
        remains.push_back(!(left.distance + w.end < w.end_distance) &&
                          !(right.distance + (edge_length - w.begin) < w.begin_distance));
      }
      check_pruned(face, windows, remains);
    }
  }
}

// The distance of a pseudo-source has shrunk since its windows were made.
void lists_lose_stale_windows(Lane_choice choice, test_support::Random& random)
{
  for(std::size_t n = 1; n < 70; n += 1 + n / 3)
  {
    One_face face(choice);
    face.distance[0] = .5;
    const std::vector<Window> windows = windows_side_by_side(n, random);
    std::vector<bool> remains;
    for(const Window& w : windows)
    {
      remains.push_back(w.root_distance <= .5);
    }
    face.crossing.expect_stale_windows(true);
    check_pruned(face, windows, remains);
  }
}

// On a surface with points no shortest path crosses a face twice.
void lists_lose_windows_that_have_crossed_too_many_faces(Lane_choice choice, test_support::Random& random)
{
  One_face face(choice);
  std::vector<Window> windows = windows_side_by_side(20, random);
  std::vector<bool> remains;
  for(std::size_t i = 0; i < windows.size(); ++i)
  {
    const bool has_crossed_two = random.index(3) == 0;
    windows[i].steps = has_crossed_two ? 4 : 2;
    remains.push_back(!has_crossed_two);
  }
  check_pruned(face, windows, remains);
}

// One window among others is redundant, and the others stay.
void one_window_of_a_pair_is_lost(Lane_choice choice)
{
  for(const bool left_is_farther : {true, false})
  {
    One_face face(choice);
    std::vector<Window> windows{window(0, .125, .125, .25, 0), window(.125, .25, .25, .25, 0),
                                window(.375, .625, .5, .25, left_is_farther ? 1 : 0),
                                window(.375, .625, .5, .25, left_is_farther ? 0 : 1), window(.75, 1, .75, .25, 0)};
    for(std::size_t i = 0; i < windows.size(); ++i)
    {
      windows[i].key += i;
    }
    check_pruned(face, windows, {true, true, !left_is_farther, left_is_farther, true});
    CHECK_EQUAL(face.statistics.windows_removed_by_rules_2_and_3, std::size_t(1));
  }
}

// Windows of one key of which one is marked: nothing is known, and both stay as they are.
void windows_of_unknown_order_are_kept(Lane_choice choice)
{
  One_face face(choice);
  std::vector<Window> windows{window(.25, .75, .5, .25, 1), window(.25, .75, .5, .25, 0)};
  windows[0].steps = 2;
  windows[1].steps = 3;
  check_pruned(face, windows, {true, true});
  CHECK_EQUAL(face.statistics.ambiguous_pairs, std::size_t(1));
}

// The shortest path through one of two windows of the same image is as long as the straight one beside it, as far as
// one can see: the straight one is found.
void the_straighter_of_two_paths_is_taken(Lane_choice choice)
{
  One_face face(choice);
  const double x = .5, shift = 1e-9;
  for(const bool is_first : {true, false})
  {
    const double border = is_first ? x + shift : x - shift; // between the two windows
    std::vector<Window> windows{window(0, border, x, .25, .25), window(border, 1, x, .25, .25)};
    windows[1].key += 1;
    const List list = list_of(face.pool, windows);
    const auto path = face.crossing.find_apex_path(list, face.across);
    CHECK_EQUAL(path.index, std::size_t(is_first ? 0 : 1));
    CHECK_CLOSE(path.separating_point, x, 1e-15);
    CHECK_CLOSE(path.distance, .5 + face.across.apex_y, 1e-15);
  }
}

// The line from the image to the next vertex misses the interval: the shortest path bends at the nearer end of it, and
// the list is split there.
void paths_bend_at_the_end_of_an_interval(Lane_choice choice)
{
  One_face face(choice);
  for(const bool is_right : {true, false})
  {
    Window w = is_right ? window(.75, 1, .5625, .0625, .25) : window(0, .25, .4375, .0625, .25);
    w.steps = 2;
    const double end = is_right ? w.begin : w.end;
    const List list = list_of(face.pool, {w});
    const auto path = face.crossing.find_apex_path(list, face.across);
    CHECK_EQUAL(path.separating_point, end);
    const double to_apex = std::hypot(face.across.apex_x - end, face.across.apex_y);
    CHECK_CLOSE(path.distance, (is_right ? w.begin_distance : w.end_distance) + to_apex, 1e-14);
  }
}

// The children on both sides: which windows they come from is told by their images.
struct Children
{
  std::vector<std::uint64_t> left, right; // keys of the windows
};

Children children_of(One_face& face, const std::vector<Window>& windows)
{
  const List list = list_of(face.pool, windows);
  const auto path = face.crossing.find_apex_path(list, face.across);
  List left = face.pool.allocate(windows.size()), right = face.pool.allocate(windows.size());
  face.crossing.split(list, face.across, face.corners, path, left, right);
  Children children;
  for(std::size_t i = 0; i < face.crossing.left().size; ++i)
  {
    children.left.push_back(face.crossing.left().list.columns.get(i).key << 1);
  }
  for(std::size_t i = 0; i < face.crossing.right().size; ++i)
  {
    children.right.push_back(face.crossing.right().list.columns.get(i).key << 1);
  }
  return children;
}

void lists_are_split_at_their_shortest_path(Lane_choice choice)
{
  const auto numbered = [](Window w, std::uint64_t number) {
    w.key = number << 8; // not lost when the key is shifted
    w.steps = 2;
    return w;
  };
  One_face face(choice);
  const auto keys = [](std::vector<std::uint64_t> numbers) {
    for(std::uint64_t& n : numbers)
    {
      n <<= 8;
    }
    return numbers;
  };
  // the middle one is nearest, and has children on both sides
  const Window far_left = window(0, .25, .375, .25, 1), middle = window(.25, .75, .5, .25, 0),
               far_right = window(.75, 1, .625, .25, 1);
  {
    const Children children = children_of(face, {numbered(far_left, 1), numbered(middle, 2), numbered(far_right, 3)});
    CHECK(children.left == keys({1, 2}));
    CHECK(children.right == keys({2, 3}));
  }
  // a window that could see both sides keeps its own only
  {
    const Window wide = window(0, 1, .25, .25, 1);
    const Children children = children_of(face, {numbered(wide, 1), numbered(middle, 2), numbered(wide, 3)});
    CHECK(children.left == keys({1, 2}));
    CHECK(children.right == keys({2, 3}));
  }
  // unless its place beside the nearest one is not known
  {
    const Window wide = window(0, 1, .25, .25, 1);
    std::vector<Window> windows{numbered(middle, 2), numbered(wide, 2)};
    windows[1].mark();
    const Children children = children_of(face, windows);
    CHECK(children.left == keys({2, 2}));
    CHECK(children.right == keys({2, 2}));
  }
  // or it is wholly on the other side than its key says
  {
    const Window wrong = window(.5625, 1, .25, .25, 1), nearest = window(.25, .5, .5, .25, 0);
    const Children children = children_of(face, {numbered(wrong, 1), numbered(nearest, 2)});
    CHECK(children.left == keys({2}));
    CHECK(children.right == keys({1}));
  }
}

} // namespace

int main()
{
  test_support::Random random(test_support::announce_seed(20261121));
  pairs_are_pruned_by_definition(random);
  ties_are_left_alone();
  for(const Lane_choice choice : {Lane_choice::ONE, Lane_choice::COMPILED, Lane_choice::FOUR, Lane_choice::BEST})
  {
    lists_are_trimmed_like_pairs(choice, random);
    ties_in_lists_are_left_alone(choice);
    windows_trimmed_from_both_sides_are_suspects(choice);
    close_images_are_not_trimmed(choice);
    vertices_take_windows_away_by_definition(choice, random);
    lists_lose_what_vertices_take(choice, random);
    lists_lose_stale_windows(choice, random);
    lists_lose_windows_that_have_crossed_too_many_faces(choice, random);
    one_window_of_a_pair_is_lost(choice);
    windows_of_unknown_order_are_kept(choice);
    the_straighter_of_two_paths_is_taken(choice);
    paths_bend_at_the_end_of_an_interval(choice);
    lists_are_split_at_their_shortest_path(choice);
  }
  ties_with_vertices();
  lists_are_merged_in_order(random);
  the_order_is_unknown_for_marked_windows_of_one_key();
  the_smallest_distance_is_that_of_a_point(random);
  improvements_by_rounding_are_ignored_where_windows_start();
  return test_support::test_result();
}
