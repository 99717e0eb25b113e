// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_INDEX_TABLE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_INDEX_TABLE_H

// A hash table from indices to values, for data of a few of the many faces or halfedges of a mesh. It probes linearly
// in arrays that are at most half full, and never allocates single entries. All operations take expected constant time,
// insertions amortized. There is no removal of single entries, so probing needs no marks of removed ones.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariants: at most half of the positions are used, so that position() ends; no free position lies between an entry
// and the position that its hash gives.
template <typename Value>
class Index_table
{
public:
  // Removes all entries and keeps the memory.
  void clear()
  {
    if(m_size == 0)
      return;
    std::fill(m_keys.begin(), m_keys.end(), null_id);
    m_size = 0;
  }

  // The value of a key, or null. The pointer is valid until the next insertion. Requires: key != null_id.
  const Value* find(std::uint32_t key) const
  {
    if(m_size == 0)
      return nullptr;
    const std::size_t i = position(key);
    return m_keys[i] == key ? &m_values[i] : nullptr;
  }

  // Inserts a value unless the key has one. Returns whether it has inserted the value. Nothing has changed if it
  // throws. Requires: key != null_id.
  bool insert(std::uint32_t key, const Value& value)
  {
    if(2 * (m_size + 1) > m_keys.size())
      grow();
    const std::size_t i = position(key);
    if(m_keys[i] == key)
      return false;
    m_keys[i] = key;
    m_values[i] = value;
    ++m_size;
    return true;
  }

  // Calls visit(key, value) for all entries, in no particular order.
  template <typename Visit>
  void for_each(Visit visit) const
  {
    for(std::size_t i = 0; m_size > 0 && i < m_keys.size(); ++i)
      if(m_keys[i] != null_id)
        visit(m_keys[i], m_values[i]);
  }

private:
  // The position of the key, or the free position where it belongs. Requires: a position is free;
  // key != null_id.
  std::size_t position(std::uint32_t key) const
  {
    CGAL_assertion(key != null_id && m_size < m_keys.size());
    // (Fibonacci hashing: the constant is 2^64 over the golden ratio. Keys that follow each other are spread evenly.
    // The middle bits of the product are taken, as the lowest ones depend on the lowest bits of the key alone.)
    const std::size_t mask = m_keys.size() - 1;
    std::size_t i = static_cast<std::size_t>((key * std::uint64_t(0x9E3779B97F4A7C15)) >> 32) & mask;
    while(m_keys[i] != key && m_keys[i] != null_id)
      i = (i + 1) & mask;
    return i;
  }

  // Doubles the arrays and inserts all entries anew. Nothing has changed if it throws: both arrays are allocated first.
  void grow()
  {
    const std::size_t n = (std::max)(std::size_t(16), 2 * m_keys.size());
    std::vector<std::uint32_t> keys(n, null_id);
    std::vector<Value> values(n);
    keys.swap(m_keys);
    values.swap(m_values);
    for(std::size_t j = 0; j < keys.size(); ++j)
      if(keys[j] != null_id)
      {
        const std::size_t i = position(keys[j]);
        m_keys[i] = keys[j];
        m_values[i] = values[j];
      }
  }

  std::vector<std::uint32_t> m_keys; // null_id at free positions; the size is 0 or a power of two
  std::vector<Value> m_values;
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_INDEX_TABLE_H
