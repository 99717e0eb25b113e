// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_POOL_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_POOL_H

// The memory of the lists of strips that wait. A list is a block of a pool, of 4, 8, 16, ... strips, and released
// blocks are used again, the last one first: it is still in the caches. So the memory is that of the strips that wait
// at the same time, in one piece for each list. (Window_pool does the same for windows, in columns.)

#include <CGAL/Surface_mesh_geodesics/internal/numeric/bit_counting.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <CGAL/assertions.h>

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

// A list in a block of the pool, or an empty list without a block. A copy refers to the same block; only one of the two
// may go back to the pool.
template <typename FT>
struct Strip_list
{
  Strip<FT>* strips = nullptr;
  std::uint32_t size = 0;
  std::uint32_t size_class = 0;

  std::size_t capacity() const { return strips == nullptr ? 0 : std::size_t(4) << size_class; }
};

// Invariant: each block has one owner, a list or the pool. After an exception for want of memory it may have none; it
// is freed with its slab then.
template <typename FT>
class Strip_pool
{
public:
  using List = Strip_list<FT>;

  // Reserves capacity for n more strips behind those of a list. The list moves to a larger block if it has to.
  // Requires: n > 0.
  void reserve(List& list, std::size_t n)
  {
    if(list.size + n <= list.capacity())
      return;
    List larger;
    // The smallest class with that capacity: the number less 1 has at most class + 2 bits.
    larger.size_class = static_cast<std::uint32_t>(number_of_bits((list.size + n - 1) | 3) - 2);
    larger.strips = block(larger.size_class);
    larger.size = list.size;
    std::copy(list.strips, list.strips + list.size, larger.strips);
    release(list);
    list = larger;
    CGAL_expensive_assertion(list.size + n <= list.capacity());
  }

  // Releases the block of a list. The list is empty afterward.
  void release(List& list)
  {
    if(list.strips != nullptr)
      m_free_blocks[list.size_class].push_back(list.strips);
    list = List();
  }

  std::size_t memory() const { return m_number_of_strips * sizeof(Strip<FT>); }

private:
  Strip<FT>* block(std::size_t size_class)
  {
    std::vector<Strip<FT>*>& free_blocks = m_free_blocks[size_class];
    if(!free_blocks.empty())
    {
      Strip<FT>* const b = free_blocks.back();
      free_blocks.pop_back();
      return b;
    }
    const std::size_t n = std::size_t(4) << size_class;
    if(m_slab_rest < n)
    {
      // What is left of the last slab becomes free blocks; slabs grow with what has been needed so far.
      for(std::size_t c = size_class; c-- > 0;)
        while(m_slab_rest >= std::size_t(4) << c)
          m_free_blocks[c].push_back(cut(std::size_t(4) << c));
      const std::size_t size = (std::max)({n, least_slab, m_number_of_strips / 4});
      std::unique_ptr<Strip<FT>[]> slab(new Strip<FT>[size]);
      m_slabs.push_back(std::move(slab));
      m_slab = m_slabs.back().get();
      m_slab_rest = size;
      m_number_of_strips += size;
    }
    return cut(n);
  }

  // Cuts a block of n strips off the slab.
  Strip<FT>* cut(std::size_t n)
  {
    Strip<FT>* const b = m_slab;
    m_slab += n;
    m_slab_rest -= n;
    return b;
  }

  static constexpr std::size_t least_slab = 512; // strips

  std::vector<std::unique_ptr<Strip<FT>[]>> m_slabs;
  std::array<std::vector<Strip<FT>*>, 32> m_free_blocks; // by size class
  Strip<FT>* m_slab = nullptr; // what is left of the last slab
  std::size_t m_slab_rest = 0, m_number_of_strips = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_STRIP_POOL_H
