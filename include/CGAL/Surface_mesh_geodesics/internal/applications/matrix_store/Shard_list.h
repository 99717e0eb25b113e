// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_SHARD_LIST_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_SHARD_LIST_H

// Which shard a thread computes next, in one process. (store_matrix_mpi.h hands shards out to several.)
//
// A type that hands out shards has two functions, which several threads may call at once: next(shard) returns false if
// there is nothing more to do, and set_aside(shard) takes back a shard that another process is computing.
//
// Nothing is divided in advance: a thread that is slow, or a shard that takes long, delays nobody. The list has all
// shards of a range, also those that are done, whose files a thread compares with their checksums.

#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_layout.h>

#include <cstddef>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The shards whose first row is in a range, in this order. So ranges that cover all rows without overlap have each
// shard once, wherever they begin.
inline std::vector<std::size_t> shards_of_rows(const Store_layout& layout, std::size_t first_row, std::size_t end_row)
{
  std::vector<std::size_t> shards;
  for(std::size_t s = 0; s < layout.number_of_shards(); ++s)
    if(layout.first_row(s) >= first_row && layout.first_row(s) < end_row)
      shards.push_back(s);
  return shards;
}

// Two calls in one process, or in two, have a list each. They begin with the same shards, so the locks of the one that
// is first send the other one on: it sets them aside, and finds them done in the second round.
//
// Hands out each shard of a list once, and then those that were set aside once more: their owner may have died.
// The first round is in the order of rows, so that files appear in their order.
class Shard_list
{
public:
  // The shards are handed out in the order of the list.
  explicit Shard_list(const std::vector<std::size_t>& shards) : m_shards(shards) {}

  // The second round begins when the first one has been handed out, though other threads may still compute shards of
  // it: whoever is set aside later than that stays so, and another call has to come.
  bool next(std::size_t& shard)
  {
    const std::lock_guard<std::mutex> guard(m_mutex);
    if(m_next == m_shards.size() && !m_is_last_round)
    {
      m_is_last_round = true;
      m_next = 0;
      m_shards.swap(m_set_aside);
      m_set_aside.clear();
    }
    if(m_next == m_shards.size())
      return false;
    shard = m_shards[m_next++];
    return true;
  }

  // Without waiting: the other process will finish the shard, or a later call.
  void set_aside(std::size_t shard)
  {
    const std::lock_guard<std::mutex> guard(m_mutex);
    m_set_aside.push_back(shard);
  }

  // When all threads have ended: the shards that are left to others, at most once each. They may be done meanwhile; who
  // wants to know looks them up in the folder.
  const std::vector<std::size_t>& left() const { return m_set_aside; }

private:
  std::mutex m_mutex;
  std::vector<std::size_t> m_shards, m_set_aside;
  std::size_t m_next = 0;
  // A list ends after two rounds, whatever other processes do.
  bool m_is_last_round = false;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_SHARD_LIST_H
