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
// are not greater than a threshold. Also which of two neighbors with the same key is visited.
//
// A batch should be large enough to share, and small beside the wavefront: a vertex that is visited long before its
// turn propagates windows that a nearer one would have pruned. And of two neighbors in a batch, one has to wait.
// The aim is a sixth of the wavefront, or a third of a long one. A third makes a few windows in ten thousand more than
// one visit at a time does, and more neighbors wait. Where the wavefront is short, that costs more than it saves.
//
// The threshold advances by a step that grows or shrinks with the last batch. If most of a batch had to wait, it goes
// back to the nearest ones: where edges are short beside those elsewhere on the wavefront, a step that takes in a third
// of the wavefront reaches over many edges, and each vertex waits for the one before it.
//
// Ties. Of neighbors with the same key, that with the smaller number is visited first, as in the sequential
// propagation. Among many, such as sources, each would wait for the one before it, as vertices are numbered breadth
// first. Then their numbers are multiplied, modulo 2^32: that spreads numbers in a row evenly, and makes no two equal.
//
// All depends on the numbers of vertices and on their keys only, hence neither on the number of threads nor on their
// speed.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// What the threshold needs to know of a batch that has been visited.
template <typename FT>
struct Batch_measures
{
  std::size_t size;           // greater than 0
  FT nearest, farthest;       // of its keys
  FT middle;                  // where to go back to if most of the batch had to wait for a neighbor, else infinity
  std::size_t wavefront_size; // with the batch
};

// Life cycle: start() begins a run. Each round reads limit(), and then calls go_on() with what has been visited, or
// go_on_from() if no vertex had a key up to the limit. All functions take constant time.
//
// Progress: the nearest vertex of a batch is always visited, and after a batch without vertices the next limit reaches
// the nearest one.
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
    m_factor_of_ties = 1;
  }

  const FT& limit() const { return m_limit; }

  // Of neighbors with the same key, that with the smallest product of this factor and its number is visited first.
  std::uint32_t factor_of_ties() const { return m_factor_of_ties; }

  // Goes on from the nearest vertex, after a batch without vertices.
  void go_on_from(const FT& nearest) { m_limit = nearest + m_step; }

  // Goes on after a batch with vertices.
  void go_on(const Batch_measures<FT>& b)
  {
    CGAL_assertion(b.size > 0);
    m_factor_of_ties = b.size >= smallest_large_tie && !(b.nearest < b.middle) ? factor_of_large_tie : 1;
    if(b.middle < Vertex_distance_field<FT>::infinity())
    {
      go_back(b);
      return;
    }
    const std::size_t aim = (std::max)(m_smallest_aim, part_of(b.wavefront_size));
    const FT wanted = FT(aim) / FT(b.size);
    if(wanted < 1 || b.size < b.wavefront_size) // a step that takes in the whole wavefront is long enough
      m_step *= (std::max)(FT(1) / 2, (std::min)(wanted, FT(2)));
    m_step = (std::max)(m_step, smallest_step());
    m_limit = (std::min)(m_limit, b.farthest) + m_step;
  }

private:
  // If all keys up to the middle are the same, the step stays: a smaller one would change nothing.
  void go_back(const Batch_measures<FT>& b)
  {
    if(b.nearest < b.middle)
      m_step = (std::max)((std::min)(m_step, FT(b.middle - b.nearest)), smallest_step());
    m_limit = b.middle;
  }

  // How many vertices of a wavefront a batch should have.
  static std::size_t part_of(std::size_t wavefront_size)
  {
    constexpr std::size_t long_wavefront = 512;
    return wavefront_size < long_wavefront ? wavefront_size / 6 : wavefront_size / 3;
  }

  // Keeps the step from vanishing among many vertices with the same key.
  static FT smallest_step() { return FT(1) / (std::int64_t(1) << 40); }

  static constexpr std::size_t smallest_large_tie = 256;
  static constexpr std::uint32_t factor_of_large_tie = 0x9e3779b1; // 2^32 divided by the golden ratio, an odd number

  std::size_t m_smallest_aim;
  FT m_limit = 0, m_step = 0;
  std::uint32_t m_factor_of_ties = 1;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_BATCH_THRESHOLD_H
