// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_LIST_LOOPS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_LIST_LOOPS_H

// The loops over the windows of a list, in which nearly all time is spent, for the processor that runs the program.
//
// They are compiled once for each number of lanes that may pay (simd.h): the files in lanes/ are included several
// times, each time into another namespace and for another instruction set (README.md). An object chooses its loops
// once, not in each call. The choice does not change any bit of the results.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/simd.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_pruning.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The new windows that a list sends across one edge, in the spare capacity behind the list of that edge, and their
// smallest distance. `list` refers to the block; its size does not count the new windows. Window_pool::add() makes them
// part of the list.
template <typename FT>
struct Window_batch
{
  Window_list<FT> list;
  std::size_t size;
  FT minimum_distance;
  std::uint32_t steps; // joined_steps() of the windows

  // Begins an empty batch behind the windows of a list. A list without a block gives a batch that takes no windows.
  void start(const Window_list<FT>& space, std::uint32_t steps_of_windows)
  {
    list = space;
    size = 0;
    minimum_distance = std::numeric_limits<FT>::infinity();
    steps = steps_of_windows;
  }

  bool has_block() const { return list.columns.height != 0; }

  void add(const Window<FT>& w)
  {
    CGAL_expensive_assertion(has_block() && list.size + size < list.capacity());
    list.columns.set(list.size + size, w);
    minimum_distance = (std::min)(minimum_distance, w.minimum_distance());
    ++size;
  }
};

// Which paths of a list go to the edge AC or CB, and the rivals there: A and C, or C and B. The left of the cut goes to
// AC, the right of it to CB; a cut at the far end of AB lets all paths go.
template <typename FT>
struct Edge_cut
{
  Vertex_rival<FT> left, right; // the ends of the edge
  FT cut;                       // abscissa on AB; the paths on one side of it go to this edge
  std::size_t whole_window;     // index of a window that loses no paths at the cut
};

// The window of a list through which the path to C is shortest.
template <typename FT>
struct Nearest_window
{
  std::size_t index; // of the first one if several tie
  FT distance;
  bool has_close_images; // some windows of the list may be too close to trim
};

// Eight windows of a list, with a bit for each one that has to be examined by itself: window i has bit i % 8 of word
// i / 8. Eight is the largest number of lanes.
using Suspects = unsigned char;
constexpr std::size_t suspects_in_word = 8;

// The loops for one number of lanes, as a table of functions: an indirect call for each list, and none for a window.
// The comments say what each of them does; lanes/List_loops.h says how.
template <typename FT>
struct Window_list_loops
{
  using Columns = Window_columns<FT>;
  using Rival = Vertex_rival<FT>;
  using Cross = void (*)(const Columns& columns, std::size_t first, std::size_t last, const Face_frame<FT>& c,
                         const Edge_cut<FT>& edge, const FT* abscissa, Window_batch<FT>& batch,
                         Propagation_statistics& statistics);

  std::size_t lanes; // at most Window_columns::padding

  // Trims the n windows of a list against their original neighbors (Trimmed_pairs). Suspects are the windows that are
  // beaten by a vertex or trimmed to nothing, and the right windows of undecided pairs. Returns whether there are any.
  bool (*trim)(const Columns& columns, std::size_t n, const FT& length, const Rival& left, const Rival& right,
               Suspects* suspects);

  // Finds the shortest path to C, and the apex_abscissa of all windows. Writes up to a full step of lanes into
  // `abscissa`.
  Nearest_window<FT> (*find_nearest)(const Columns& columns, std::size_t n, const Face_frame<FT>& c, FT* abscissa);

  // Does the interval of each window reach the side of s that the order of keys gives it: the left side for windows
  // before the best one, the right side for those after it?
  bool (*is_split_by)(const Columns& columns, std::size_t n, std::size_t best, const FT& s);

  // Appends the children of the windows [first, last) to the batch of one edge, in their order, and counts those that
  // are removed. Uses the apex_abscissa of the windows.
  Cross cross_left, cross_right;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#ifdef CGAL_SURFACE_MESH_GEODESICS_HAS_PAIRS
#include <CGAL/Surface_mesh_geodesics/internal/window/Double_pair.h>
#endif
#define CGAL_SURFACE_MESH_GEODESICS_LANES_TEXT <CGAL/Surface_mesh_geodesics/internal/window/lanes/loops.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/lanes/every_number.h>
#undef CGAL_SURFACE_MESH_GEODESICS_LANES_TEXT

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The loops with the most lanes that pay on this processor, with at most four, with at most two, or with one.
enum class Lane_choice { BEST, FOUR, TWO, ONE };

// How many lanes a choice has on this processor. The same in all files of a program, whatever their flags (simd.h).
inline std::size_t number_of_lanes(Lane_choice choice)
{
#if CGAL_SURFACE_MESH_GEODESICS_MOST_LANES > 2
  // The first processors with AVX-512 lower their clock when they use it. They lack its extension VBMI2.
  if(choice == Lane_choice::BEST && __builtin_cpu_supports("avx512vbmi2"))
    return 8;
  if((choice == Lane_choice::BEST || choice == Lane_choice::FOUR) && __builtin_cpu_supports("avx2"))
    return 4;
#endif
  const std::size_t most = CGAL_SURFACE_MESH_GEODESICS_MOST_LANES;
  return choice == Lane_choice::ONE ? 1 : (std::min)(most, std::size_t(2));
}

// The loops over windows of a choice.
template <typename FT, typename Rules>
Window_list_loops<FT> window_list_loops(Lane_choice choice = Lane_choice::BEST)
{
  if constexpr(std::is_same<FT, double>::value)
    switch(number_of_lanes(choice))
    {
#if CGAL_SURFACE_MESH_GEODESICS_MOST_LANES > 2
    case 8:
      return avx512_lanes::List_loops<FT, Rules>::table();
    case 4:
      return avx2_lanes::List_loops<FT, Rules>::table();
#endif
#if CGAL_SURFACE_MESH_GEODESICS_MOST_LANES > 1
    case 2:
      return two_lanes::List_loops<FT, Rules>::table();
#endif
    default:
      break;
    }
  static_cast<void>(choice);
  return one_lane::List_loops<FT, Rules>::table();
}

// Call the object with the number of windows, or strips, that a loop will process; it returns the table to use.
//
// The loops for lists of any length. Lists of one window pay for vectors and gain nothing; lists of up to four windows
// gain nothing from eight lanes. With many sources, most lists are that short.
template <typename Loops>
class Loops_by_length
{
public:
  // loops(choice) is the table of a choice.
  template <typename LoopsOfChoice>
  Loops_by_length(Lane_choice choice, LoopsOfChoice loops)
    : m_many(loops(choice)), m_few(choice == Lane_choice::BEST ? loops(Lane_choice::FOUR) : m_many),
      m_one(loops(Lane_choice::ONE))
  {}

  const Loops& operator()(std::size_t number) const { return number > 4 ? m_many : number > 1 ? m_few : m_one; }

  // The largest number of lanes of these loops.
  std::size_t lanes() const { return m_many.lanes; }

private:
  const Loops m_many, m_few, m_one;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_LIST_LOOPS_H
