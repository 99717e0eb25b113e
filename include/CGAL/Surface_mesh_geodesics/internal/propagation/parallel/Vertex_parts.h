// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_VERTEX_PARTS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_VERTEX_PARTS_H

// The part of the wavefront to which each vertex belongs. A vertex belongs to none until the wavefront comes near; then
// it belongs to the part that asks for it first. So each part has a region of the surface, which grows with the
// wavefront.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// An entry has the number of the run (24 bits) and the part (8 bits): entries of earlier runs are void, so restart()
// need not clear them.
//
// Threads: any number may call part_of() at the same time. The other functions are for the conductor alone.
class Vertex_parts
{
public:
  static constexpr std::size_t maximum_number_of_parts = 64;

  // Takes all vertices from their parts. Constant, but linear in the number of vertices if there are more of them than
  // ever before, and every 16 million runs.
  void restart(std::size_t number_of_vertices)
  {
    if(number_of_vertices > m_capacity || m_run == last_run)
    {
      m_entries.reset(new std::atomic<std::uint32_t>[number_of_vertices]);
      for(std::size_t v = 0; v < number_of_vertices; ++v)
        m_entries[v].store(0, std::memory_order_relaxed);
      m_capacity = number_of_vertices;
      m_run = 0;
    }
    ++m_run;
  }

  // The part of a vertex; if it belongs to none, it belongs to the given part from now on. The order of memory does not
  // matter: the entry is all that threads tell each other here.
  std::size_t part_of(Vertex_id v, std::size_t part)
  {
    std::uint32_t entry = m_entries[v].load(std::memory_order_relaxed);
    if(entry >> part_bits == m_run)
      return entry & part_mask;
    if(m_entries[v].compare_exchange_strong(entry, entry_of(part), std::memory_order_relaxed))
      return part;
    return entry & part_mask; // another thread was faster
  }

  // Gives a vertex to a part.
  void set_part(Vertex_id v, std::size_t part) { m_entries[v].store(entry_of(part), std::memory_order_relaxed); }

  std::size_t memory() const { return m_capacity * sizeof(m_entries[0]); }

private:
  static constexpr unsigned int part_bits = 8;
  static constexpr std::uint32_t part_mask = 0xff;
  static constexpr std::uint32_t last_run = 0xffffff;

  std::uint32_t entry_of(std::size_t part) const
  {
    return (m_run << part_bits) | static_cast<std::uint32_t>(part);
  }

  std::unique_ptr<std::atomic<std::uint32_t>[]> m_entries; // by vertex
  std::size_t m_capacity = 0;
  std::uint32_t m_run = 0; // 0 before the first restart()
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_VERTEX_PARTS_H
