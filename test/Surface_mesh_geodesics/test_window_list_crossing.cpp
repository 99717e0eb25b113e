// One list of windows across one face, for each number of lanes: which windows are pruned, where the shortest path to
// the apex runs, and how the list is split there.

#include "test_support.h"
#include "window_test_helpers.h"

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_crossing.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

using namespace window_test;

// --- a list across a face --------------------------------------------------------------------------------------------

// One equilateral triangle with sides of length 1, and the list on its first side.
struct One_face
{
  internal::Intrinsic_mesh<double> mesh;
  std::vector<double> distance; // distances of the vertices that are the roots of the windows
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

// Windows side by side, each with its own image, so that no window affects its neighbors. The root is the first vertex.
std::vector<Window> windows_side_by_side(std::size_t n, test_support::Random& random)
{
  std::vector<Window> windows;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double begin = static_cast<double>(i) / static_cast<double>(n),
                 end = static_cast<double>(i + 1) / static_cast<double>(n);
    windows.push_back(window(begin, end, random.uniform(0., 1.), random.uniform(.05, 1.), random.uniform(0., 1.)));
    windows.back().steps = 0; // lists are pruned on their first edge and on every fourth one after it
    windows.back().key += i; // in order
  }
  return windows;
}

// Prunes a list and checks that exactly the expected windows remain.
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

void windows_beaten_by_vertices_are_removed(Lane_choice choice, test_support::Random& random)
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
void stale_windows_are_removed(Lane_choice choice, test_support::Random& random)
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
void windows_that_have_crossed_too_many_faces_are_removed(Lane_choice choice, test_support::Random& random)
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

// One of several windows is dominated. The others stay.
void one_window_of_a_pair_is_removed(Lane_choice choice)
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

// Two windows have the same key, and one of them is marked: their order is unknown, and both stay as they are.
void windows_of_unknown_order_are_kept(Lane_choice choice)
{
  One_face face(choice);
  std::vector<Window> windows{window(.25, .75, .5, .25, 1), window(.25, .75, .5, .25, 0)};
  windows[0].steps = 2;
  windows[1].steps = 3;
  check_pruned(face, windows, {true, true});
  CHECK_EQUAL(face.statistics.ambiguous_pairs, std::size_t(1));
}

// The bent path through one of two windows of the same image is as long, up to rounding, as the straight path through
// the other one: the straight path is found.
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

// The line from the image to the apex misses the interval: the shortest path bends at the nearer end of the interval,
// and the list is split there.
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

// The children on both sides, each by the key of its parent.
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
  // a window that sees both sides gets a child on its own side only
  {
    const Window wide = window(0, 1, .25, .25, 1);
    const Children children = children_of(face, {numbered(wide, 1), numbered(middle, 2), numbered(wide, 3)});
    CHECK(children.left == keys({1, 2}));
    CHECK(children.right == keys({2, 3}));
  }
  // unless its position relative to the nearest window is unknown
  {
    const Window wide = window(0, 1, .25, .25, 1);
    std::vector<Window> windows{numbered(middle, 2), numbered(wide, 2)};
    windows[1].mark();
    const Children children = children_of(face, windows);
    CHECK(children.left == keys({2, 2}));
    CHECK(children.right == keys({2, 2}));
  }
  // or its interval lies on the other side than its key says
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
  for(const Lane_choice choice : {Lane_choice::ONE, Lane_choice::TWO, Lane_choice::FOUR, Lane_choice::BEST})
  {
    windows_beaten_by_vertices_are_removed(choice, random);
    stale_windows_are_removed(choice, random);
    windows_that_have_crossed_too_many_faces_are_removed(choice, random);
    one_window_of_a_pair_is_removed(choice);
    windows_of_unknown_order_are_kept(choice);
    the_straighter_of_two_paths_is_taken(choice);
    paths_bend_at_the_end_of_an_interval(choice);
    lists_are_split_at_their_shortest_path(choice);
  }
  return test_support::test_result();
}
