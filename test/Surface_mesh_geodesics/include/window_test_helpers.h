#ifndef SURFACE_MESH_GEODESICS_WINDOW_TEST_HELPERS_H
#define SURFACE_MESH_GEODESICS_WINDOW_TEST_HELPERS_H

// Windows on an edge of the length 1, made by hand or at random, for the tests of pruning.

#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_loops.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace window_test {

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

// The window of an image with a straight line to the ends of its interval.
inline Window window(double begin, double end, double image_x, double image_depth, double root_distance)
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

inline Window random_window(test_support::Random& random)
{
  // Uses only a few abscissas, so that some intervals share ends.
  const double a = .125 * static_cast<double>(random.index(8)), b = .125 * static_cast<double>(random.index(8));
  return window((std::min)(a, b), (std::max)(a, b) + .125, random.uniform(-1., 2.), random.uniform(.05, 1.5),
                random.uniform(0., .5));
}

// Returns whether two distances differ so much that rounding does not decide which one is smaller.
inline bool are_different(double a, double b)
{
  return !test_support::is_close(a, b, 1e-9);
}

// Makes a list of these windows, in this order.
inline List list_of(Pool& pool, const std::vector<Window>& windows)
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

} // namespace window_test

#endif // SURFACE_MESH_GEODESICS_WINDOW_TEST_HELPERS_H
