// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_WORK_IN_BATCHES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_WORK_IN_BATCHES_H

// Work that a keeper leaves to the threads of a parallel propagation. An item is added in one batch of visits, done in
// the next one, by any thread, and taken back in the one after that. So nobody waits for anybody during a batch, and
// the order of the items does not depend on the threads.

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Item` has a default constructor; items are reused, so that they keep their memory.
//
// Threads: within a batch, one thread at a time adds, one takes back, and any threads do units. Nothing else runs
// beside begin_batch(), finish() and clear().
template <typename Item>
class Work_in_batches
{
public:
  // Forgets all items.
  void clear()
  {
    for(Items* items : {&m_added, &m_in_work, &m_done})
      items->size = 0;
  }

  // Adds an item, whose content is that of some earlier one. The reference is valid until the next call.
  Item& add()
  {
    if(m_added.size == m_added.items.size())
      m_added.items.emplace_back();
    return m_added.items[m_added.size++];
  }

  // Begins a batch, and returns the number of its units, at most maximum_number_of_units. Requires: the units of the
  // last batch have been done, and take_back() was called since it began, if it had items to take back.
  std::size_t begin_batch()
  {
    CGAL_precondition(m_done.size == 0);
    std::swap(m_done, m_in_work);
    std::swap(m_in_work, m_added);
    return (m_in_work.size + items_per_unit() - 1) / items_per_unit();
  }

  // (A keeper may have a thousand units in a batch, for edges, faces, and a few more: Window_relay.h.)
  static constexpr std::size_t maximum_number_of_units = 450;

  // Calls work(item) for the items of a unit.
  template <typename Work>
  void do_unit(std::size_t unit, Work work)
  {
    const std::size_t first = unit * items_per_unit(), last = (std::min)(first + items_per_unit(), m_in_work.size);
    Item* const items = m_in_work.items.data(); // (read once: other threads write to memory beside m_in_work)
    for(std::size_t i = first; i < last; ++i)
      work(items[i]);
  }

  // Are there items to take back?
  bool has_done() const { return m_done.size != 0; }

  // Calls take(item) for the items that the batch before has done, in the order in which they were added.
  template <typename Take>
  void take_back(Take take)
  {
    for(std::size_t i = 0; i < m_done.size; ++i)
      take(m_done.items[i]);
    m_done.size = 0;
  }

  // Does and takes back all items, in this thread. Requires: no unit has been done since begin_batch(); take() adds no
  // item.
  template <typename Work, typename Take>
  void finish(Work work, Take take)
  {
    take_back(take);
    for(int i = 0; i < 2; ++i) // those in work, then those added since
    {
      std::for_each(m_in_work.items.begin(), m_in_work.items.begin() + static_cast<std::ptrdiff_t>(m_in_work.size),
                    work);
      begin_batch();
      take_back(take);
    }
  }

  // Calls visit(item) for all items that there have been since this object was made: they keep their memory.
  template <typename Visit>
  void for_each_item(Visit visit) const
  {
    for(const Items* items : {&m_added, &m_in_work, &m_done})
      std::for_each(items->items.begin(), items->items.end(), visit);
  }

private:
  // The first `size` items count; the others keep their memory for later ones.
  struct Items
  {
    std::vector<Item> items;
    std::size_t size = 0;
  };

  std::size_t items_per_unit() const { return 1 + m_in_work.size / maximum_number_of_units; }

  Items m_added, m_in_work, m_done; // between two batches the items move on to the next one of these
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PASSING_WORK_IN_BATCHES_H
