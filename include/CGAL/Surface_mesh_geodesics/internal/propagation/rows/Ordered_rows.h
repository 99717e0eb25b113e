// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_ORDERED_ROWS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_ORDERED_ROWS_H

// Rows of a table, computed by several threads and output one at a time, in ascending order. The number of rows in
// memory is bounded, and their memory is reused.
//
// for_each_ordered_row() is the function to call; it has a sequential and a parallel version.

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Worker_team.h>

#include <CGAL/assertions.h>
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

// Tells a thread that computes a row that the row is not wanted any more. A row that is filled nevertheless is not
// output.
using Stop_flag = std::atomic<bool>;

// The rows 0 .. n-1. Any number of threads call work(); when all have returned, one calls finish().
//
// Invariants, while the mutex is held: rows below m_first_inside have been output; m_first_inside <= m_next <=
// m_first_inside + number of rows in memory; row i is in slot i % number of rows. Only one thread outputs at a time,
// and only that thread changes m_first_inside.
//
// The contents of a row need no lock. They belong to the thread that has claimed the row; when it marks the row as
// filled, under the mutex, they pass to the thread that outputs, and with m_first_inside to the next claim of the slot.
template <typename Row, typename Compute, typename Output>
class Ordered_rows
{
public:
  // compute(worker, i, row, stop) fills row i; output(i, row) receives it, and returns whether to go on. At most
  // `number_of_rows` rows exist at a time. Both functions must outlive this object. Requires: number_of_rows > 0.
  Ordered_rows(std::size_t n, std::size_t number_of_rows, const Compute& compute, const Output& output)
    : m_compute(compute), m_output(output), m_number(n), m_rows(number_of_rows), m_is_filled(number_of_rows, false)
  {
    CGAL_assertion(number_of_rows > 0);
  }

  Ordered_rows(const Ordered_rows&) = delete;
  Ordered_rows& operator=(const Ordered_rows&) = delete;

  // Computes and outputs rows until there are no more. Does not throw: finish() does. A thread that finds no row makes
  // no worker, which may have to copy a mesh.
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

  // Returns whether all rows have been output. Rethrows the first exception of any thread. Requires: no thread is in
  // work().
  bool finish() const
  {
    if(m_failure != nullptr)
      std::rethrow_exception(m_failure);
    return !m_stop;
  }

private:
  Row& row(std::size_t i) { return m_rows[i % m_rows.size()]; }

  // Waits until a buffer is free for another row. Returns the row to be computed next, or n if there is none. No thread
  // waits forever: row m_first_inside has been claimed by a thread that is computing it or handing it out, or the
  // condition holds.
  std::size_t claim()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    m_buffer_is_free.wait(lock, [this]()
                    { return m_stop || m_next == m_number || m_next < m_first_inside + m_rows.size(); });
    CGAL_assertion(m_first_inside <= m_next && m_next <= m_first_inside + m_rows.size());
    return m_stop || m_next == m_number ? m_number : m_next++;
  }

  // Marks row i as filled, and outputs the rows that are filled and whose turn has come, unless another thread does:
  // that thread sees the mark before it stops handing out, as both happen under the mutex. The mutex is free during an
  // output, so that the other threads go on computing.
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
      const bool goes_on = m_output(m_first_inside, row(m_first_inside)); // only this thread changes the number
      lock.lock();
      m_is_filled[m_first_inside % m_rows.size()] = false;
      ++m_first_inside;
      if(!goes_on)
        m_stop = true;
      m_buffer_is_free.notify_all();
    }
    m_is_handing_out = false;
  }

  // Keeps the exception that is being handled, if it is the first one, and stops all threads.
  void fail()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_failure == nullptr)
      m_failure = std::current_exception();
    m_stop = true;
    m_buffer_is_free.notify_all();
  }

  const Compute& m_compute;
  const Output& m_output;
  const std::size_t m_number;
  std::vector<Row> m_rows;
  Stop_flag m_stop{false};
  std::mutex m_mutex; // guards all members below
  std::condition_variable m_buffer_is_free;
  std::vector<bool> m_is_filled;
  bool m_is_handing_out = false; // stays true if the output throws
  std::size_t m_next = 0;         // row to be computed next
  std::size_t m_first_inside = 0; // row to be output next
  std::exception_ptr m_failure;
};

// Computes and outputs the rows 0 .. n-1. compute(worker, i, row, stop) fills row i; output(i, row) is called for one
// row at a time, in ascending order. Returns false as soon as output() does, else true. make_worker() returns a
// pointer; each thread that computes rows calls it once, and is the only one that uses the worker. If a call throws,
// the others stop, and the first exception is thrown when all threads have returned.
//
// There are four rows in memory for each thread, so that the others may run ahead of a row that takes long.
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

// The same in the calling thread alone.
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

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_ORDERED_ROWS_H
