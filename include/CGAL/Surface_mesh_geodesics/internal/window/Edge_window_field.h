// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_EDGE_WINDOW_FIELD_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_EDGE_WINDOW_FIELD_H

// The windows that a propagation has carried across each halfedge, kept for queries at any point of the surface.
//
// No rule had found these windows dominated when they were propagated. Windows that have become dominated since cost
// memory only. A kept window does not store the distance of its pseudo-source, which may have shrunk since: the final
// distance belongs to a path that exists as well and is not longer.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Kept_window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Batches of windows, and for each halfedge the chain of its batches, the latest first. Windows are never removed, and
// never move: chunks have a fixed size, and a list that does not fit into the rest of a chunk becomes several batches.
// Keeping a window takes constant time, amortized, and the memory of one Kept_window.
//
// Invariants: all chunks but the last one are full, and m_chunk_size windows of the last one are in use; a batch lies
// in one chunk and is not empty; `previous` of a batch is smaller than its own index, or null_id, so chains end; there
// are fewer than 2^32 - 1 batches.
//
// Threads: several may call for_each_window() at once if no thread calls reset() or keep().
template <typename FT_>
class Edge_window_field
{
public:
  using FT = FT_;
  using Kept = Kept_window<FT>;

  // Removes all windows, and prepares for a mesh with this number of faces. Takes time linear in that number.
  void reset(std::size_t number_of_faces)
  {
    m_last_batch.assign(3 * number_of_faces, null_id);
    m_batches.clear();
    m_chunks.clear();
    m_chunk_size = 0;
  }

  // Keeps the windows of a list that a propagation carries across h, in the frame of h: copies what Kept_window has.
  // Requires: reset() has been called for the mesh, refined by its sources; the list satisfies the invariants of a
  // stored list (Window_lists.h), it may be empty.
  void keep(Halfedge_id h, const Window_list<FT>& list)
  {
    std::size_t done = 0;
    while(done < list.size)
    {
      if(m_chunk_size == chunk_capacity || m_chunks.empty())
      {
        m_chunks.emplace_back(new Kept[chunk_capacity]);
        m_chunk_size = 0;
      }
      const std::size_t n = (std::min)(chunk_capacity - m_chunk_size, list.size - done);
      Kept* const first = m_chunks.back().get() + m_chunk_size;
      for(std::size_t i = 0; i < n; ++i)
      {
        const Window<FT> w = list.columns.get(done + i);
        first[i] = Kept{w.begin, w.end, w.image_x, w.image_depth, w.root};
      }
      std::uint32_t& last = m_last_batch[dense_index(h)];
      m_batches.push_back(Batch{first, static_cast<std::uint32_t>(n), last});
      last = static_cast<std::uint32_t>(m_batches.size() - 1);
      m_chunk_size += n;
      done += n;
    }
  }

  // Calls visit(window) for all windows of h, the latest batch first, and by key within a batch. The winner of a tie
  // in a query depends on this order. Takes time linear in the number of windows.
  // Requires: reset() has been called for a mesh with h. `visit` does not call keep().
  template <typename Visit>
  void for_each_window(Halfedge_id h, Visit visit) const
  {
    for(std::uint32_t b = m_last_batch[dense_index(h)]; b != null_id; b = m_batches[b].previous)
      for(std::uint32_t i = 0; i < m_batches[b].size; ++i)
        visit(m_batches[b].first[i]);
  }

  std::size_t memory() const
  {
    return m_chunks.size() * chunk_capacity * sizeof(Kept) + m_batches.capacity() * sizeof(Batch)
         + m_last_batch.capacity() * sizeof(std::uint32_t);
  }

private:
  static constexpr std::size_t chunk_capacity = 4096;

  // The windows of one list, or a part of them, and the batch of the same halfedge before it.
  struct Batch
  {
    const Kept* first;
    std::uint32_t size;
    std::uint32_t previous;
  };

  std::vector<std::unique_ptr<Kept[]>> m_chunks;
  std::size_t m_chunk_size = 0; // of the last chunk
  std::vector<Batch> m_batches;
  std::vector<std::uint32_t> m_last_batch;
};

// The keeper of a propagation whose windows go into a field. The distance that is reached does not matter to it.
template <typename FT>
class Window_keeper
{
public:
  explicit Window_keeper(Edge_window_field<FT>& field) : m_field(&field) {}

  void keep(Halfedge_id h, const Window_list<FT>& list) { m_field->keep(h, list); }
  void advance(const FT&) const {}

private:
  Edge_window_field<FT>* m_field;
};

// The keeper of a propagation that keeps no windows.
struct No_window_keeper
{
  template <typename List>
  void keep(Halfedge_id, const List&) const
  {}

  template <typename FT>
  void advance(const FT&) const
  {}
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_EDGE_WINDOW_FIELD_H
