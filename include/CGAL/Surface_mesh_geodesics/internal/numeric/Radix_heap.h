// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_RADIX_HEAP_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_RADIX_HEAP_H

// Numbers, of faces, that wait until the wavefront has reached a distance: a radix heap (Ahuja, Mehlhorn, Orlin and
// Tarjan, Faster algorithms for the shortest path problem, J. ACM 37, 1990). The distance reached only grows, and
// nobody asks in which order those leave that may leave: so an entry moves a few times from one bucket to another, and
// nothing is compared on the way. (A binary heap took a tenth of the time of a diagram.)
//
// Distances are kept in single precision, rounded so that no entry leaves too early; it may leave too late, by a
// millionth of its distance. Distances that are too large for that wait until clear().

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/bit_counting.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/single_precision.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

class Radix_heap
{
public:
  void clear()
  {
    for(std::vector<Entry>& bucket : m_bucket)
      bucket.clear();
    m_reached = 0;
  }

  // lets f wait for a distance. `limit`, not less than that, is remembered.
  template <typename FT>
  void push(Face_id f, const FT& distance, const FT& limit)
  {
    insert(Entry{bits(Single_precision::not_less(distance)), Single_precision::not_less(limit), f});
  }

  // calls leave(f, limit) for all that wait for less than the distance that is reached; it may let f wait again, but
  // not for less than that.
  template <typename FT, typename Leave>
  void advance(const FT& distance, Leave leave)
  {
    const std::uint32_t reached = bits(Single_precision::not_more(distance));
    if(reached <= m_reached)
      return;
    const std::size_t last = bucket_of(reached);
    m_reached = reached;
    // All that wait in the buckets before the last one are below what is reached; of the last one, some are.
    for(std::size_t i = 0; i <= last; ++i)
    {
      if(m_bucket[i].empty())
        continue;
      m_moved.clear();
      m_moved.swap(m_bucket[i]);
      for(const Entry& e : m_moved)
        if(e.key < reached)
          leave(e.face, FT(e.limit));
        else
          insert(e);
    }
  }

  std::size_t memory() const
  {
    std::size_t n = m_moved.capacity();
    for(const std::vector<Entry>& bucket : m_bucket)
      n += bucket.capacity();
    return n * sizeof(Entry);
  }

private:
  // Of non-negative numbers, so that keys are ordered as the numbers are.
  struct Entry
  {
    std::uint32_t key;
    float limit;
    Face_id face;
  };

  static std::uint32_t bits(float x)
  {
    static_assert(sizeof(float) == sizeof(std::uint32_t) && std::numeric_limits<float>::is_iec559,
                  "single precision is expected to be that of IEEE 754");
    std::uint32_t b;
    std::memcpy(&b, &x, sizeof(b));
    return b;
  }

  // The number of the highest bit in which a key differs from what is reached, counted from 1; 0 for those that do not,
  // or are below.
  std::size_t bucket_of(std::uint32_t key) const
  {
    return key <= m_reached ? 0 : number_of_bits(key ^ m_reached);
  }

  void insert(const Entry& e) { m_bucket[bucket_of(e.key)].push_back(e); }

  std::array<std::vector<Entry>, 33> m_bucket;
  std::vector<Entry> m_moved;
  std::uint32_t m_reached = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_RADIX_HEAP_H
