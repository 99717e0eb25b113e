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

// A radix heap for faces that wait until the wavefront has reached a distance (Ahuja, Mehlhorn, Orlin and Tarjan,
// Faster algorithms for the shortest path problem, J. ACM 37, 1990). The reached distance only grows, and due entries
// may leave in any order. So an entry moves to a lower bucket at most 32 times, in practice a few times, and entries
// are not compared with each other. (A binary heap took a tenth of the time of a diagram.)
//
// Distances are stored in single precision and rounded up: no entry leaves too early, but it may leave too late by a
// millionth of its distance. Distances beyond single precision wait until clear().

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/bit_counting.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/single_precision.h>

#include <CGAL/assertions.h>

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

// Invariant: each entry is in bucket_of(its key). Bucket 0 has those that are due when the reached distance grows.
class Radix_heap
{
public:
  void clear()
  {
    for(std::vector<Entry>& bucket : m_bucket)
      bucket.clear();
    m_reached = 0;
  }

  // Lets f wait for a distance, and stores `limit` with it. If the distance is reached already, f is due as soon as the
  // reached distance grows.
  // Requires: 0 <= distance <= limit.
  template <typename FT>
  void push(Face_id f, const FT& distance, const FT& limit)
  {
    CGAL_assertion(distance >= 0 && distance <= limit);
    insert(Entry{bits(Single_precision::not_less(distance)), Single_precision::not_less(limit), f});
  }

  // Raises the reached distance; a smaller one than before changes nothing. Calls leave(f, limit), with a limit rounded
  // up, for the faces that wait for less. leave() may push f again. Of several such faces, approach(f, 0) and then
  // approach(f, 1) is called for all of them before, so that the caller can fetch what leave() reads.
  template <typename FT, typename Approach, typename Leave>
  void advance(const FT& distance, Approach approach, Leave leave)
  {
    const std::uint32_t reached = bits(Single_precision::not_more(distance));
    if(reached <= m_reached)
      return;
    const std::size_t last = bucket_of(reached);
    m_reached = reached;
    // `last` is the highest bit in which the reached distance changes. Entries in the buckets before the last one agree
    // with the former distance in this bit, so they are due; some of the last one are. Those behind it stay where they
    // are, as their first difference is above this bit.
    for(std::size_t i = 0; i <= last; ++i)
    {
      if(m_bucket[i].empty())
        continue;
      m_moved.clear();
      m_moved.swap(m_bucket[i]);
      for(const std::size_t round : {std::size_t(0), std::size_t(1)})
        for(const Entry& e : m_moved)
          if(e.key < reached)
            approach(e.face, round);
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
  // The key is the bits of a non-negative number: keys have the order of the numbers.
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

  // The highest bit in which a key differs from the reached one, counted from 1; 0 if the key is not greater.
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
