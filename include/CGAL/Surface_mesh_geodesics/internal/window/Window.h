// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_H

// A window (thesis, 3.3.1): the straight paths from one pseudo-source that cross one sequence of edges and end in one
// interval of the last of them, AB.
//
// Frame. A window belongs to the halfedge AB of the face ABC that it is about to enter. A is the origin, AB the
// positive x axis, C lies above. The image of the pseudo-source, unfolded into the plane of ABC along the edge
// sequence, lies below, at (image_x, -image_depth). Looking from the image across AB, A is on the left and B on the
// right.
//
// Order. The key tells where the edge sequence of a window runs relative to those of the other windows on AB. It holds
// the last 64 turns (0: the window left the previous face across its left edge, 1: across its right edge), the latest
// turn in the highest bit, followed by a single 1 where the sequence begins at its pseudo-source (if it has fewer than
// 64 turns). Take two windows on AB with different keys. Their edge sequences agree back to some face, which they enter
// across different edges, or in which one of them begins at the vertex that these edges share: the smaller key comes
// from the left. Beyond that face both run through the same triangles, which unfold to a disk. So if a path of the
// window with the smaller key ends on the right of a path of the other window, the two paths really cross, in that
// disk. Every pruning of pairs needs this fact, and only the key tells it: the positions of images or intervals do not.
//
// Two windows with equal keys have edge sequences that agree for 64 faces. Or one of them begins at a vertex where the
// other one turns right, and the other one has only turned left before, more often than the key can hold. Splitting and
// joining lists keeps the order of such windows, so it is still known. It may be lost only where lists are merged that
// came to an edge at different times. The windows that came later are marked then, and so are their children: no rule
// is applied to two windows with equal keys if one of them is marked.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/one_lane.h>

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

using Window_key = std::uint64_t;

enum Turn : unsigned int { LEFT_TURN = 0, RIGHT_TURN = 1 };

// The key of an edge sequence that begins at its pseudo-source.
constexpr Window_key initial_window_key = Window_key(1) << 63;

// The root of a window in the lower half, and its number of steps (Window::steps) in the higher half.
using Window_history = std::uint64_t;

constexpr Window_history one_step = Window_history(1) << 32;

// A window as the functions for single windows see it; Window_columns has the same fields for lists.
//
// begin_distance and end_distance are the distances at the ends of the interval, root_distance is the distance of the
// pseudo-source, root its vertex. Up to rounding, begin_distance == distance_at(begin), and so at the end.
//
// Invariants; is_valid() checks them:
// - 0 <= begin < end <= |AB|. Holds for new windows, in stored lists, and after Window_list_crossing::prune(). Trimming
//   a list against neighbors from both sides may break begin < end; prune() removes such windows before it returns.
// - image_depth >= 0. New windows have a positive depth (Tolerance::depth()). The image of a child may come to lie on
//   its edge by rounding: then the depth is 0. prune_crossed_windows(), the only rule that divides by depths, keeps
//   such a window.
// - 0 <= root_distance <= begin_distance, end_distance < infinity.
// Windows behind the end of a list, which loops over lanes read and write, satisfy none of this.
template <typename FT>
struct Window : one_lane::Window_numbers<FT>
{
  Window_key key;
  Vertex_id root;
  std::uint32_t steps; // twice the number of faces crossed, plus 1 if marked

  std::uint32_t number_of_faces_crossed() const { return steps / 2; }
  bool is_marked() const { return (steps & 1) != 0; }
  void mark() { steps |= 1; }

  Window_history history() const { return root | (steps * one_step); }

  void set_history(Window_history h)
  {
    root = static_cast<Vertex_id>(h);
    steps = static_cast<std::uint32_t>(h >> 32);
  }
};

// The steps of a list from those of two parts: at least the number of faces that each window has crossed, and a mark if
// one of them may be marked.
constexpr std::uint32_t joined_steps(std::uint32_t a, std::uint32_t b)
{
  return (a < b ? b : a) | ((a | b) & 1);
}

// Does a window on an edge of the given length satisfy the invariants of a stored window?
template <typename FT>
bool is_valid(const Window<FT>& w, const FT& length)
{
  const FT infinity = std::numeric_limits<FT>::infinity();
  return 0 <= w.begin && w.begin < w.end && w.end <= length && w.image_depth >= 0 && 0 <= w.root_distance
      && w.root_distance <= w.begin_distance && w.begin_distance < infinity && w.root_distance <= w.end_distance
      && w.end_distance < infinity && w.root != null_id;
}

// Is the image so near to its interval, on an edge of the given length, that rounding of the ends of the interval would
// turn the rays? This happens where a pseudo-source lies on the edge, in front of a flat face.
template <typename FT>
bool is_too_close_to_trim(const Window<FT>& w, const FT& length)
{
  return w.image_depth <= Tolerance<FT>::closeness() * length
      && w.minimum_distance() - w.root_distance <= Tolerance<FT>::closeness() * length;
}

// Is the order of two windows of one edge unknown? The answer does not depend on the order of the arguments.
template <typename FT>
bool is_order_unknown(const Window<FT>& a, const Window<FT>& b)
{
  return a.key == b.key && (a.is_marked() || b.is_marked());
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_WINDOW_H
