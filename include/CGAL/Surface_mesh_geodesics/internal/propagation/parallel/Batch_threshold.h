// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_BATCH_THRESHOLD_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_BATCH_THRESHOLD_H

// How far the next batch of the parallel propagation reaches: the batch has all vertices of the wavefront whose keys
// are not greater than a threshold.
//
// A batch should be large enough to share, and small beside the wavefront: a vertex that is visited long before its
// turn propagates windows that a nearer one would have pruned. And of two neighbors in a batch, one has to wait.
// The aim is a sixth of the wavefront, or a third of a long one. A third makes a few windows in ten thousand more than
// one visit at a time does, and more neighbors wait. Where the wavefront is short, that costs more than it saves.
//
// The threshold advances by a step that grows or shrinks with the last batch. All depends on the numbers of vertices
// only, hence neither on the number of threads nor on their speed.

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
class Batch_threshold
{
public:
  // Requires: smallest_aim > 0.
  explicit Batch_threshold(std::size_t smallest_aim) : m_smallest_aim(smallest_aim)
  {
    CGAL_assertion(smallest_aim > 0);
  }

  // Begins a run. The first step is small beside the longest edge of the mesh, which is about 1.
  void start()
  {
    m_limit = 0;
    m_step = FT(1) / 64;
  }

  const FT& limit() const { return m_limit; }

  // Goes on from the nearest vertex, after a batch without vertices.
  void go_on_from(const FT& nearest) { m_limit = nearest + m_step; }

  // Goes on after a batch of `size` vertices, the farthest of which had the key `farthest`, when the wavefront had
  // `wavefront_size` vertices with them. Requires: size > 0.
  void go_on(std::size_t size, const FT& farthest, std::size_t wavefront_size)
  {
    const std::size_t aim = (std::max)(m_smallest_aim, part_of(wavefront_size));
    const FT wanted = FT(aim) / FT(size);
    if(wanted < 1 || size < wavefront_size) // a step that takes in the whole wavefront is long enough
      m_step *= (std::max)(FT(1) / 2, (std::min)(wanted, FT(2)));
    m_step = (std::max)(m_step, smallest_step());
    m_limit = (std::min)(m_limit, farthest) + m_step;
  }

private:
  // How many vertices of a wavefront a batch should have.
  static std::size_t part_of(std::size_t wavefront_size)
  {
    constexpr std::size_t long_wavefront = 512;
    return wavefront_size < long_wavefront ? wavefront_size / 6 : wavefront_size / 3;
  }

  // Keeps the step from vanishing among many vertices with the same key.
  static FT smallest_step() { return FT(1) / (1 << 20); }

  std::size_t m_smallest_aim;
  FT m_limit = 0, m_step = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_BATCH_THRESHOLD_H
