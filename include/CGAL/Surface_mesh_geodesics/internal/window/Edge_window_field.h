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
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
class Window_keeper;

// Bundles of windows, and for each halfedge the chain of its bundles, the latest first. Windows are never removed, and
// never move. Window_keeper fills the field. Each keeper has a chunk and a block of bundles of its own, so several
// threads may keep windows at once, each with its keeper, if no two of them are concerned with the same halfedge.
//
// Invariants: a bundle lies in one chunk and is not empty; its `previous` is older, or null_id, so chains end; bundles
// are numbered through all blocks; there are fewer than 2^32 - 1 bundles.
//
// Threads: several may call for_each_window() at once if no thread calls reset(), and none keeps windows.
template <typename FT_>
class Edge_window_field
{
public:
  using FT = FT_;
  using Kept = Kept_window<FT>;

  Edge_window_field() = default;
  Edge_window_field(const Edge_window_field&) = delete;
  Edge_window_field& operator=(const Edge_window_field&) = delete;

  // Removes all windows, and prepares for a mesh with this number of faces. Takes time linear in that number. Keepers
  // that have kept windows in the field must not keep more.
  void reset(std::size_t number_of_faces)
  {
    m_last_bundle.assign(3 * number_of_faces, null_id);
    m_blocks.clear();
    m_chunks.clear();
    m_windows_in_chunks = 0;
  }

  // Removes all windows and frees all memory.
  void clear()
  {
    m_last_bundle = std::vector<std::uint32_t>();
    m_blocks = std::vector<std::unique_ptr<Bundle[]>>();
    m_chunks = std::vector<std::unique_ptr<Kept[]>>();
    m_windows_in_chunks = 0;
  }

  // Calls visit(window) for all windows of h, the latest bundle first, and by key within a bundle. The winner of a tie
  // in a query depends on this order. Takes time linear in the number of windows.
  // Requires: reset() has been called for a mesh with h. `visit` keeps no windows.
  template <typename Visit>
  void for_each_window(Halfedge_id h, Visit visit) const
  {
    for(std::uint32_t b = m_last_bundle[dense_index(h)]; b != null_id;)
    {
      const Bundle& bundle = m_blocks[b / bundles_in_block][b % bundles_in_block];
      for(std::uint32_t i = 0; i < bundle.size; ++i)
        visit(bundle.first[i]);
      b = bundle.previous;
    }
  }

  std::size_t memory() const
  {
    return m_windows_in_chunks * sizeof(Kept) + m_blocks.size() * bundles_in_block * sizeof(Bundle)
         + m_last_bundle.capacity() * sizeof(std::uint32_t);
  }

private:
  friend class Window_keeper<FT>;

  static constexpr std::size_t windows_in_chunk = 4096;
  static constexpr std::size_t bundles_in_block = 1024;

  // The windows of one list, or a part of them, and the bundle of the same halfedge before it.
  struct Bundle
  {
    const Kept* first;
    std::uint32_t size;
    std::uint32_t previous;
  };

  // Return a chunk of n windows, and a block of bundles with the number of the first one. Any thread may call them.
  Kept* new_chunk(std::size_t n)
  {
    std::unique_ptr<Kept[]> chunk(new Kept[n]);
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_chunks.push_back(std::move(chunk));
    m_windows_in_chunks += n;
    return m_chunks.back().get();
  }

  std::pair<Bundle*, std::uint32_t> new_block()
  {
    std::unique_ptr<Bundle[]> block(new Bundle[bundles_in_block]);
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_blocks.push_back(std::move(block));
    return {m_blocks.back().get(), static_cast<std::uint32_t>((m_blocks.size() - 1) * bundles_in_block)};
  }

  std::vector<std::uint32_t> m_last_bundle; // by halfedge
  std::mutex m_mutex;                      // guards the members below while windows are kept
  std::vector<std::unique_ptr<Kept[]>> m_chunks;
  std::size_t m_windows_in_chunks = 0;
  std::vector<std::unique_ptr<Bundle[]>> m_blocks;
};

// The keeper of a propagation whose windows go into a field. The distance that is reached does not matter to it.
//
// A copy keeps windows in the same field, in memory of its own. The parallel propagation gives each thread a keeper:
// visits that take place at the same time share no face, hence no halfedge. So the order of the lists of a halfedge
// does not depend on the threads. Neither does the order of windows, as the keepers of threads keep each list as one
// bundle. The keeper of a single thread fills each chunk, and divides a list that does not fit into several bundles.
template <typename FT>
class Window_keeper
{
public:
  using Thread_keeper = Window_keeper;
  static constexpr bool is_deferred = false;

  // Keeps nothing. (A run that may or may not keep windows has one keeper type, so that the text of the propagation is
  // compiled once. One that never keeps any has No_window_keeper.)
  Window_keeper() = default;

  // The field must be reset before the first keep(), and not after it, and must outlive the keeper. With
  // divides_lists = false, each list is one bundle.
  explicit Window_keeper(Edge_window_field<FT>& field, bool divides_lists = true)
    : m_field(&field), m_divides_lists(divides_lists)
  {}
  Window_keeper(const Window_keeper& other) : m_field(other.m_field), m_divides_lists(other.m_divides_lists) {}
  Window_keeper& operator=(const Window_keeper&) = delete;

  Thread_keeper thread_keeper() const
  {
    Window_keeper keeper(*this);
    keeper.m_divides_lists = false;
    return keeper;
  }

  bool keeps_windows() const { return m_field != nullptr; }

  // Keeps the windows of a list that a propagation carries across h, in the frame of h: copies what Kept_window has.
  // Takes constant time for each window, amortized. The new bundle becomes the head of the chain of h; entries of other
  // halfedges are not touched.
  // Requires: the field has been reset for the mesh, refined by its sources; the list satisfies the invariants of a
  // stored list (Window_lists.h), it may be empty.
  void keep(Halfedge_id h, const Window_list<FT>& list)
  {
    if(keeps_windows())
      append(h, list);
  }

  void advance(const FT&) const {}

private:
  using Bundle = typename Edge_window_field<FT>::Bundle;

  void append(Halfedge_id h, const Window_list<FT>& list)
  {
    std::size_t done = 0;
    while(done < list.size)
    {
      get_memory(m_divides_lists ? 1 : list.size);
      const std::size_t n = (std::min)(m_free_windows, list.size - done);
      for(std::size_t i = 0; i < n; ++i)
        m_window[i] = kept_window(list, done + i);
      std::uint32_t& last = m_field->m_last_bundle[dense_index(h)];
      *m_bundle = Bundle{m_window, static_cast<std::uint32_t>(n), last};
      last = m_bundle_number++;
      ++m_bundle;
      --m_free_bundles;
      m_window += n;
      m_free_windows -= n;
      done += n;
    }
  }

  // Reserves memory for n windows and a bundle. If that throws, nothing has changed but the memory of the field. What
  // is left of the former chunk stays unused, so a list that is not divided may waste some.
  void get_memory(std::size_t n)
  {
    if(m_free_windows < n)
    {
      const std::size_t size = (std::max)(n, std::size_t(Edge_window_field<FT>::windows_in_chunk));
      m_window = m_field->new_chunk(size);
      m_free_windows = size;
    }
    if(m_free_bundles == 0)
    {
      std::tie(m_bundle, m_bundle_number) = m_field->new_block();
      m_free_bundles = Edge_window_field<FT>::bundles_in_block;
    }
  }

  Edge_window_field<FT>* m_field = nullptr;
  bool m_divides_lists = true;
  Kept_window<FT>* m_window = nullptr; // where the next window goes, and how many windows fit from there on
  std::size_t m_free_windows = 0;
  Bundle* m_bundle = nullptr; // the same for bundles
  std::size_t m_free_bundles = 0;
  std::uint32_t m_bundle_number = 0;
};

// The keeper of a propagation that keeps no windows.
struct No_window_keeper
{
  using Thread_keeper = No_window_keeper;
  static constexpr bool is_deferred = false;

  Thread_keeper thread_keeper() const { return {}; }

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
