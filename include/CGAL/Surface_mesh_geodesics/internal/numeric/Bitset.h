// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_BITSET_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_BITSET_H

// A set of small numbers, with one bit for each, visited in ascending order. A visit takes time per element, not per
// number, and has no branch that depends on membership: such branches cannot be predicted, and would take longer than
// the work on the elements.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/bit_counting.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariant: m_first has the numbers 0 .. 63, m_others[j] those from 64 (j + 1) on. Nearly all sets here are smaller
// than 64, as they belong to the star of a vertex; these allocate no memory.
//
// insert() and remove() require a number below the n of the last reset().
class Bitset
{
public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Empties the set and prepares it for the numbers 0 .. n-1.
  void reset(std::size_t n)
  {
    m_first = 0;
    if(n > bits)
      m_others.assign((n - 1) / bits, 0);
    else if(!m_others.empty())
      m_others.clear();
  }

  // Inserts i if the condition holds, without a branch.
  void insert(std::size_t i, bool condition = true)
  {
    word(i) |= static_cast<std::uint64_t>(condition) << i % bits;
  }

  void remove(std::size_t i) { word(i) &= ~(std::uint64_t(1) << i % bits); }

  bool empty() const { return next(0) == none; }

  // The smallest element that is not less than i, or `none`.
  std::size_t next(std::size_t i) const
  {
    if(i < bits)
    {
      const std::uint64_t rest = m_first >> i;
      if(rest != 0)
        return i + trailing_zeros(rest);
      i = bits;
    }
    for(; i / bits <= m_others.size(); i = (i / bits + 1) * bits)
    {
      const std::uint64_t rest = m_others[i / bits - 1] >> i % bits;
      if(rest != 0)
        return i + trailing_zeros(rest);
    }
    return none;
  }

  // Calls visit(i) for all elements in ascending order. visit() may insert elements; those greater than i are visited
  // as well.
  template <typename Visit>
  void for_each(Visit visit) const
  {
    for(std::size_t i = next(0); i != none; i = next(i + 1))
      visit(i);
  }

private:
  static constexpr std::size_t bits = 64;

  std::uint64_t& word(std::size_t i)
  {
    CGAL_expensive_assertion(i / bits <= m_others.size());
    return i < bits ? m_first : m_others[i / bits - 1];
  }

  std::uint64_t m_first = 0;
  std::vector<std::uint64_t> m_others; // empty if n <= 64
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_BITSET_H
