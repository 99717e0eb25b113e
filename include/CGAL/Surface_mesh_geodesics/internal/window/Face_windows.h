// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_FACE_WINDOWS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_FACE_WINDOWS_H

// Windows that are kept for the face that they have entered, by the halfedge across which they came. The windows of a
// halfedge can be released, and their memory is used again.
//
// Windows lie in chunks of a few. The links between chunks are stored apart from them and are small enough for the
// caches: on large meshes, a chunk that is reused is rarely cached. Chunks come in blocks, which never move and are not
// initialized: fresh memory costs more than what is written there.
//
// Adding a window takes constant time, amortized; releasing all windows of a halfedge does, too, as the ring of its
// chunks becomes part of the free list by one exchange. Memory is that of the largest number of windows at a time, and
// of unused space in the last chunk of each halfedge.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Kept_window.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariants: all chunks of a halfedge but the last one are full, and the last one is not empty; each chunk is in the
// ring of one halfedge or in the free list; size() is the number of windows in all rings. `number` of a link is that of
// the windows in the ring up to this chunk, so the last link has the number of windows of the halfedge.
//
// All functions with a halfedge require that reset() has been called for a mesh with that halfedge; reset() keeps the
// blocks. An object is used by one thread at a time.
template <typename FT>
class Face_windows
{
public:
  // Removes all windows, and prepares for a mesh with this number of faces. Takes time linear in that number.
  void reset(std::size_t number_of_faces)
  {
    m_last_chunk.assign(3 * number_of_faces, null_id);
    m_links.clear();
    m_first_free = null_id;
    m_size = m_maximum_size = 0;
  }

  // Frees all memory. reset() has to follow before windows are added.
  void clear()
  {
    m_blocks = std::vector<std::unique_ptr<Block>>();
    m_links = std::vector<Link>();
    reset(0);
    m_last_chunk.shrink_to_fit();
  }

  // Adds a window, behind those that h has.
  void add(Halfedge_id h, const Kept_window<FT>& w)
  {
    add(h, 1, [&](std::size_t) { return w; });
  }

  // Adds window(i) for i = 0 .. n-1, called once each and in this order, behind the windows that h has. `window` does
  // not access this object. n may be 0. Fewer than 2^32 windows of one halfedge can be kept.
  //
  // A number of windows that is a multiple of the capacity means that the last chunk is full: it is never empty. The
  // chunk is looked up after add_chunk(), which may move all chunks.
  template <typename Window_at>
  void add(Halfedge_id h, std::size_t n, Window_at window)
  {
    std::uint32_t& last = m_last_chunk[dense_index(h)];
    for(std::size_t i = 0; i < n;)
    {
      if(last == null_id || m_links[last].number % Chunk::capacity == 0)
        add_chunk(last);
      std::uint32_t position = m_links[last].number % Chunk::capacity;
      const std::size_t end = (std::min)(n, i + (Chunk::capacity - position));
      m_links[last].number += static_cast<std::uint32_t>(end - i);
      for(Chunk& c = chunk(last); i < end; ++i)
        c.put(position++, window(i));
    }
    m_size += n;
    m_maximum_size = (std::max)(m_maximum_size, m_size);
  }

  // Releases the windows of h, in constant time. Afterwards h has none, and add() may begin anew.
  void release(Halfedge_id h)
  {
    std::uint32_t& last = m_last_chunk[dense_index(h)];
    if(last == null_id)
      return;
    m_size -= m_links[last].number;
    // The first chunk becomes the head of the free list, and the old head follows the last chunk.
    std::swap(m_links[last].next, m_first_free);
    last = null_id;
  }

  // Calls visit(window) for the windows of h, in the order in which they were added. `visit` adds and releases none.
  template <typename Visit>
  void for_each_window(Halfedge_id h, Visit visit) const
  {
    const std::uint32_t last = m_last_chunk[dense_index(h)];
    if(last == null_id)
      return;
    for(std::uint32_t c = m_links[last].next;; c = m_links[c].next)
    {
      const std::uint32_t size = c == last ? (m_links[c].number - 1) % Chunk::capacity + 1 : Chunk::capacity;
      for(std::uint32_t i = 0; i < size; ++i)
        visit(chunk(c).get(i));
      if(c == last)
        return;
    }
  }

  // Asks the processor to fetch what the first call about a halfedge of the same face reads.
  void prefetch(Halfedge_id h) const { internal::prefetch(&m_last_chunk[dense_index(h)]); }

  // The number of windows, and its maximum since reset().
  std::size_t size() const { return m_size; }
  std::size_t maximum_size() const { return m_maximum_size; }

  std::size_t memory() const
  {
    return m_blocks.size() * sizeof(Block) + m_links.capacity() * sizeof(Link)
         + m_last_chunk.capacity() * sizeof(std::uint32_t);
  }

private:
  // A few windows of one halfedge: with double, 216 bytes. (Roots lie together, as an array of Kept_window would spend
  // four bytes of padding on each.)
  struct Chunk
  {
    static constexpr std::uint32_t capacity = 6;
    std::array<Vertex_id, capacity> root;
    std::array<std::array<FT, 4>, capacity> numbers;

    Kept_window<FT> get(std::uint32_t i) const
    {
      return Kept_window<FT>{numbers[i][0], numbers[i][1], numbers[i][2], numbers[i][3], root[i]};
    }

    void put(std::uint32_t i, const Kept_window<FT>& w)
    {
      root[i] = w.root;
      numbers[i] = {w.begin, w.end, w.image_x, w.image_depth};
    }
  };

  struct Block
  {
    static constexpr std::uint32_t capacity = 64;
    std::array<Chunk, capacity> chunk;
  };

  // The chunks of a halfedge form a ring: the last one, which may have spare capacity, is followed by the first one.
  struct Link
  {
    std::uint32_t number; // of windows in this chunk and in those before it
    std::uint32_t next;
  };

  Chunk& chunk(std::uint32_t c) { return m_blocks[c / Block::capacity]->chunk[c % Block::capacity]; }
  const Chunk& chunk(std::uint32_t c) const { return m_blocks[c / Block::capacity]->chunk[c % Block::capacity]; }

  // Puts an empty chunk behind the last one, or makes it the only one. It becomes the last chunk, and takes over the
  // number of windows in those before it.
  void add_chunk(std::uint32_t& last)
  {
    const std::uint32_t c = new_chunk();
    m_links[c] = Link{0, c};
    if(last != null_id)
    {
      m_links[c].number = m_links[last].number;
      std::swap(m_links[c].next, m_links[last].next);
    }
    last = c;
  }

  // Returns a chunk of the free list, otherwise a new one. Its link is not set.
  std::uint32_t new_chunk()
  {
    if(m_first_free == null_id)
    {
      if(m_links.size() == m_blocks.size() * Block::capacity)
        m_blocks.push_back(std::unique_ptr<Block>(new Block)); // (not initialized, as std::make_unique() would do)
      m_links.emplace_back();
      return static_cast<std::uint32_t>(m_links.size() - 1);
    }
    const std::uint32_t c = m_first_free;
    m_first_free = m_links[c].next;
    return c;
  }

  std::vector<std::uint32_t> m_last_chunk; // by halfedge
  std::vector<std::unique_ptr<Block>> m_blocks;
  std::vector<Link> m_links; // by chunk
  std::uint32_t m_first_free = null_id; // the free chunks form a list along their links
  std::size_t m_size = 0, m_maximum_size = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_FACE_WINDOWS_H
