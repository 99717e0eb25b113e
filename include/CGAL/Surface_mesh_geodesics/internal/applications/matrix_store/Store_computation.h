// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_COMPUTATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_COMPUTATION_H

// Computes shards in one or several threads. A thread computes a shard alone, from its lock to its record: threads meet
// only where they ask for a shard and where they report a row. So they neither wait for each other at the ends of
// shards, nor does a row wait in memory for the rows before it.

#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Shard_writer.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_folder.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_options.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Lock_file.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/rows/Distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Worker_team.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// --- threads ---

// The tag decides at compile time, so that programs without TBB need none. Parallel_tag is derived from Sequential_tag;
// the better match is chosen.
inline std::size_t number_of_threads(Sequential_tag)
{
  return 1;
}

// Calls work() in each of n threads, and returns when all have returned. Requires: work() does not throw.
template <typename Work>
void run_in_threads(Sequential_tag, std::size_t, const Work& work)
{
  work();
}

// Calls a function of the user, which may use TBB, while a mutex is held: the thread must not start work() once more
// when it waits in there.
template <typename Function>
void isolate_from_threads(Sequential_tag, const Function& function)
{
  function();
}

#ifdef CGAL_LINKED_WITH_TBB
inline std::size_t number_of_threads(Parallel_tag)
{
  return Tbb_team::size();
}

template <typename Work>
void run_in_threads(Parallel_tag, std::size_t n, const Work& work)
{
  Tbb_team::run(n, [&work](std::size_t) { work(); });
}

template <typename Function>
void isolate_from_threads(Parallel_tag, const Function& function)
{
  Tbb_team::isolate(function);
}
#endif

// --- shards ---

// Report(computed, found) is called for rows, one call at a time: those computed by this call, and those that were done
// before; it returns whether to go on.
//
// A thread's memory is that of one run and of one row, and its part of the buffers. Nothing else grows with the number
// of columns except for the row; with the number of rows, only the list of shards and the manifest grow.
//
// The matrix, the targets and the folder are shared and only read, apart from the folder's entries, which have a mutex.
// A worker is that of one thread. If sources are in faces, it has a copy of the mesh, so memory grows with the threads.
//
// If a thread fails, the others stop before their next row; their incomplete shards are removed, and what is done
// stays.
template <typename Report>
class Store_computation
{
  using Matrix = Distance_matrix<double>;
  using Worker = Matrix::Worker;
  using Landmarks = Matrix::Landmarks;

public:
  // All arguments but the options are referred to.
  Store_computation(Store_folder& folder, const Matrix& matrix, const std::vector<Vertex_id>& targets,
                    std::size_t number_of_vertices, const Store_options& options, Report& report)
    : m_folder(folder), m_matrix(matrix), m_targets(targets), m_memory(options.memory_limit),
      m_compares_checksums(options.compare_checksums), m_report(report)
  {
    if(folder.layout().kind == Store_kind::WITHIN_RADIUS)
      m_positions = std::make_unique<Matrix::Target_positions>(targets, number_of_vertices, matrix.copies());
  }

  // Computes the shards that `shards` hands out (Shard_list.h). The calling thread works as well, and returns when all
  // have ended. Returns false if `report` has ended the work. Throws the first exception of any thread when all threads
  // have stopped.
  template <typename Tag, typename Shards>
  bool run(Tag tag, Shards& shards)
  {
    const std::size_t n = (std::min)(number_of_threads(tag), most_threads());
    // What a thread has for bytes that are not written: its part of the memory, without the row itself.
    const std::size_t memory = (std::max)(m_memory / n, bytes_of_row()) - bytes_of_row();
    run_in_threads(tag, n, [&]() { work(tag, shards, memory); });
    if(m_failure != nullptr)
      std::rethrow_exception(m_failure);
    return !m_stop;
  }

  // Reports rows of others, from any thread.
  template <typename Tag>
  void report(Tag tag, std::size_t computed, std::size_t found)
  {
    const std::lock_guard<std::mutex> guard(m_mutex);
    isolate_from_threads(tag, [&]()
    {
      if(!m_stop && !m_report(computed, found))
        m_stop = true;
    });
  }

private:
  // The bytes of the largest row there can be. A row is in memory in double precision; an entry of a sparse row has its
  // position, too.
  std::size_t bytes_of_row() const
  {
    const std::size_t entry = m_positions == nullptr ? sizeof(double) : sizeof(std::pair<std::size_t, double>);
    return m_folder.layout().columns * entry;
  }

  // So many threads that each has room for a row, and at least one.
  std::size_t most_threads() const
  {
    return (std::max)(std::size_t(1), m_memory / (std::max)(bytes_of_row(), std::size_t(1)));
  }

  // What one thread does until there is no shard left. A shard that is done and intact needs no lock. One that is not
  // is locked first and then looked at again: between the first look and the lock, another process may have finished
  // it.
  template <typename Tag, typename Shards>
  void work(Tag tag, Shards& shards, std::size_t memory)
  {
    try
    {
      std::unique_ptr<Worker> worker; // which may copy a mesh: only a thread that computes needs one
      // The lock ends with each turn of the loop, when the record is there.
      for(std::size_t shard = 0; !m_stop && shards.next(shard);)
        if(!is_finished(tag, shard))
        {
          Lock_file lock(m_folder.lock_of(shard));
          if(!lock.is_held())
            shards.set_aside(shard);
          else if(!is_finished(tag, shard)) // another process may have finished it before it unlocked
          {
            if(worker == nullptr)
            {
              worker = m_matrix.make_worker();
              if(m_folder.layout().kind == Store_kind::UPPER_TRIANGLE)
                std::call_once(m_landmarks_once, [&]() { find_landmarks(tag, lock); });
            }
            compute(tag, *worker, shard, memory, lock);
          }
        }
    }
    catch(...)
    {
      const std::lock_guard<std::mutex> guard(m_mutex);
      if(m_failure == nullptr)
        m_failure = std::current_exception();
      m_stop = true;
    }
  }

  // Returns whether a shard is done, with files that are what their checksums say if these are to be compared, and
  // reports its rows.
  template <typename Tag>
  bool is_finished(Tag tag, std::size_t shard)
  {
    Shard_entry entry;
    if(!m_folder.find(shard, entry) || (m_compares_checksums && !m_folder.is_intact(shard, entry)))
      return false;
    report(tag, 0, m_folder.layout().rows_of(shard));
    return true;
  }

  // Returns whether a run is to go on, after each of its visits. A row may take minutes: every now and then, the report
  // is asked, and the lock shows others that its owner lives. `visits` counts those of one thread.
  template <typename Tag>
  bool goes_on(Tag tag, Lock_file& lock, std::size_t& visits)
  {
    if(++visits % 4096 == 0)
    {
      lock.refresh();
      report(tag, 0, 0);
    }
    return !m_stop;
  }

  // Makes the landmarks of the rows of a triangle, once for all threads, which wait. This takes as long as some rows;
  // if it is ended, no row is computed. A process that finds all shards done does not get here.
  template <typename Tag>
  void find_landmarks(Tag tag, Lock_file& lock)
  {
    std::size_t visits = 0;
    m_matrix.find_landmarks(m_landmarks, [&]() { return goes_on(tag, lock, visits); });
  }

  // Computes one shard, and notes that it is done. Returns without doing so if all have to stop. Requires: the lock is
  // held.
  //
  // Rows are computed one by one, so that a thread has one of them in memory.
  template <typename Tag>
  void compute(Tag tag, Worker& worker, std::size_t shard, std::size_t memory, Lock_file& lock)
  {
    // Without finish(), its destructor removes the files.
    Shard_writer writer(m_folder, shard, memory);
    const Store_layout& layout = m_folder.layout();
    Matrix::Dense_row row;
    Matrix::Sparse_row sparse_row;
    std::size_t visits = 0;
    const auto go_further = [&]() { return goes_on(tag, lock, visits); };
    for(std::size_t i = layout.first_row(shard); i < layout.end_row(shard); ++i)
    {
      // Each row is a run of its own, with the bits that it has anywhere else.
      if(m_positions != nullptr)
        m_matrix.fill_sparse_row(worker, i, *m_positions, layout.radius, sparse_row, go_further);
      else if(layout.kind == Store_kind::UPPER_TRIANGLE) // the diagonal is not stored
        m_matrix.fill_triangular_row(worker, i, i + 1, m_landmarks.get(), row, go_further);
      else
        m_matrix.fill_dense_row(worker, i, m_targets.data(), m_targets.data() + m_targets.size(), row, go_further);
      if(m_stop) // the row may be incomplete
        return;
      if(m_positions != nullptr)
        writer.put_row(sparse_row);
      else
        writer.put_row(row);
      lock.refresh();
      report(tag, 1, 0);
    }
    m_folder.add(shard, writer.finish()); // it has all rows, even if the last report has ended the work
  }

  Store_folder& m_folder;
  const Matrix& m_matrix;
  const std::vector<Vertex_id>& m_targets;
  std::unique_ptr<Matrix::Target_positions> m_positions; // null if the matrix is not sparse
  // Set under the flag by the first thread that computes a row, and only read afterwards.
  std::once_flag m_landmarks_once;
  std::unique_ptr<const Landmarks> m_landmarks; // of a triangle with many rows, when a row is computed
  std::size_t m_memory; // for rows that are not written yet, of all threads, in bytes
  bool m_compares_checksums; // of shards that are done
  Report& m_report;
  // Set once, by the report or by a failure; each thread looks at it after each row, and its run after each visit.
  Stop_flag m_stop{false};
  std::mutex m_mutex; // guards the calls of m_report, and m_failure
  std::exception_ptr m_failure;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_COMPUTATION_H
