// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ORDERED_ROWS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ORDERED_ROWS_H

// Rows of a table that are computed by several threads at the same time, and handed out one after the other
// in their order. The number of rows that exist at a time is bounded; their memory is used again.

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Worker_team.h>

#include <CGAL/tags.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// May be asked by whoever computes a row whether it is still wanted.
using Stop_flag = std::atomic<bool>;

// The rows 0 .. n-1: any number of threads call work().
template <typename Row, typename Compute, typename Output>
class Ordered_rows
{
public:
  // compute(worker, i, row, stop) fills row i; output(i, row) takes it, and says whether to go on. At most
  // `number_of_rows` exist at a time.
  Ordered_rows(std::size_t n, std::size_t number_of_rows, const Compute& compute, const Output& output)
    : m_compute(compute), m_output(output), m_number(n), m_rows(number_of_rows), m_is_filled(number_of_rows, false)
  {}

  Ordered_rows(const Ordered_rows&) = delete;
  Ordered_rows& operator=(const Ordered_rows&) = delete;

  // computes rows and hands them out until there are no more. Does not throw: see finish().
  template <typename MakeWorker>
  void work(const MakeWorker& make_worker)
  {
    try
    {
      std::size_t i = claim();
      if(i == m_number)
        return;
      const auto worker = make_worker();
      for(; i != m_number; i = claim())
      {
        m_compute(*worker, i, row(i), m_stop);
        hand_out(i);
      }
    }
    catch(...)
    {
      fail();
    }
  }

  // Returns whether all rows have been handed out; throws what was thrown on the way. No thread is at work.
  bool finish() const
  {
    if(m_failure != nullptr)
      std::rethrow_exception(m_failure);
    return !m_stop;
  }

private:
  Row& row(std::size_t i) { return m_rows[i % m_rows.size()]; }

  // the next row to be computed, when there is room for it; or the number of rows.
  std::size_t claim()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    m_has_room.wait(lock, [this]()
                    { return m_stop || m_next == m_number || m_next < m_first_inside + m_rows.size(); });
    return m_stop || m_next == m_number ? m_number : m_next++;
  }

  // Row i is filled. Rows are handed out as far as they are filled, unless another thread is at it.
  void hand_out(std::size_t i)
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    m_is_filled[i % m_rows.size()] = true;
    if(m_is_handing_out)
      return;
    m_is_handing_out = true;
    while(!m_stop && m_is_filled[m_first_inside % m_rows.size()])
    {
      lock.unlock();
      const bool goes_on = m_output(m_first_inside, row(m_first_inside)); // this thread only changes the number
      lock.lock();
      m_is_filled[m_first_inside % m_rows.size()] = false;
      ++m_first_inside;
      if(!goes_on)
        m_stop = true;
      m_has_room.notify_all();
    }
    m_is_handing_out = false;
  }

  void fail()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_failure == nullptr)
      m_failure = std::current_exception();
    m_stop = true;
    m_has_room.notify_all();
  }

  const Compute& m_compute;
  const Output& m_output;
  const std::size_t m_number;
  std::vector<Row> m_rows;
  Stop_flag m_stop{false};
  std::mutex m_mutex; // of all that follows
  std::condition_variable m_has_room;
  std::vector<bool> m_is_filled;
  bool m_is_handing_out = false; // a thread is at it, or has failed
  std::size_t m_next = 0;         // to be computed
  std::size_t m_first_inside = 0; // to be handed out
  std::exception_ptr m_failure;
};

// For the rows 0 .. n-1: compute(worker, i, row, stop) fills the row i, where no worker is used by two threads; then
// output(i, row) is called, for one row after the other and in ascending order of i. Returns false as soon as output()
// does. make_worker() returns a pointer; it is called once by each thread.
template <typename Row, typename Team, typename MakeWorker, typename Compute, typename Output>
bool for_each_ordered_row(const Team& team, std::size_t n, const MakeWorker& make_worker, const Compute& compute,
                          const Output& output)
{
  const std::size_t number_of_threads = team.size();
  const auto isolated = [&](std::size_t i, const Row& row) { return team.isolate([&]() { return output(i, row); }); };
  Ordered_rows<Row, Compute, decltype(isolated)> rows(n, 4 * number_of_threads, compute, isolated);
  team.run(number_of_threads, [&](std::size_t) { rows.work(make_worker); });
  return rows.finish();
}

// The same by the calling thread.
template <typename Row, typename MakeWorker, typename Compute, typename Output>
bool for_each_ordered_row(Sequential_tag, std::size_t n, const MakeWorker& make_worker, const Compute& compute,
                          const Output& output)
{
  const Stop_flag stop(false);
  const auto worker = make_worker();
  Row row;
  for(std::size_t i = 0; i < n; ++i)
  {
    compute(*worker, i, row, stop);
    if(!output(i, row))
      return false;
  }
  return true;
}

#ifdef CGAL_LINKED_WITH_TBB
template <typename Row, typename MakeWorker, typename Compute, typename Output>
bool for_each_ordered_row(Parallel_tag, std::size_t n, const MakeWorker& make_worker, const Compute& compute,
                          const Output& output)
{
  return for_each_ordered_row<Row>(Tbb_team(), n, make_worker, compute, output);
}
#endif

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ORDERED_ROWS_H
