// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_MATRIX_MPI_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_MATRIX_MPI_H

// Stored matrices by the processes of an MPI job: rank 0 has the list of shards, and the others ask it. Empty without
// MPI.
//
// Only the thread that calls serve() talks to MPI (level "funneled"). It does so while other threads compute: it looks
// for messages and sleeps for a millisecond in turn, as waiting in MPI would occupy a core.
//
//   rank r                                    rank 0
//   question: 0 rows done              -->    hands out shard 7, and computes others itself
//                                      <--    answer: 7
//   question: 119 rows done            -->    reports 119 rows; the list is empty
//                                      <--    answer: -1
//   returned: 7                        -->    another job has locked shard 7: hands it out once more, at the end
//   finished: 0 rows done              -->    ends when all ranks have said so, and merges the records
//
// A rank asks with the number of rows that it has done since it asked last, for the progress of rank 0, and gets a
// shard or -1. A rank whose threads have ended says so in the same way, with another tag, and asks no more.

#ifdef CGAL_SURFACE_MESH_GEODESICS_LINKED_WITH_MPI

#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_status.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Shard_list.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_folder.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/store_matrix.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The functions of Shard_list.h for the threads that compute, and serve() for the one that talks.
// Rank 0 computes as well: its threads take from the list directly, and its talking costs a message for each shard. The
// list is short, and a shard takes seconds, so one rank serves thousands.
class Mpi_shards
{
public:
  // The list counts on rank 0 only.
  Mpi_shards(const boost::mpi::communicator& world, const std::vector<std::size_t>& shards)
    : m_world(world), m_list(shards)
  {}

  Mpi_shards(const Mpi_shards&) = delete;
  Mpi_shards& operator=(const Mpi_shards&) = delete;

  // Rank 0 never waits. On other ranks, a thread waits until the talking thread has an answer for it.
  bool next(std::size_t& shard)
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    if(m_world.rank() == 0)
      return !m_is_over && m_list.next(shard);
    ++m_number_waiting;
    m_has_answer.wait(lock, [this]() { return !m_shards.empty() || m_is_over; });
    --m_number_waiting;
    if(m_shards.empty())
      return false;
    shard = m_shards.front();
    m_shards.pop_front();
    return true;
  }

  // Another job has the shard. Rank 0 hands it out once more, at the end: that job may have died meanwhile. A rank
  // that has been told that the list is empty asks no more, so it is rank 0 itself that looks at the last ones.
  void set_aside(std::size_t shard)
  {
    const std::lock_guard<std::mutex> guard(m_mutex);
    if(m_world.rank() == 0)
      m_list.set_aside(shard);
    else
      m_returned.push_back(shard);
  }

  // When serve() has returned, on rank 0: the shards that are left to other jobs.
  const std::vector<std::size_t>& left() const { return m_list.left(); }

  // Nothing more is handed out: a thread has failed. Threads that wait on other ranks learn it from their next
  // question.
  void stop()
  {
    const std::lock_guard<std::mutex> guard(m_mutex);
    m_shards.clear();
    m_is_over = true;
    m_has_answer.notify_all();
  }

  // Rank 0 goes on until the last rank has finished, even if its own threads have nothing to do any more.
  // Talks to the other ranks until the threads of this rank have ended (`is_finished`) and, on rank 0, those of all.
  // `rows_done` counts the rows of this rank; on rank 0, report(rows) is told of those of others.
  template <typename Report>
  void serve(const std::atomic<bool>& is_finished, const std::atomic<std::size_t>& rows_done, const Report& report)
  {
    if(m_world.rank() == 0)
      for(int others = m_world.size() - 1; others > 0 || !is_finished; pause())
        answer_all(others, report);
    else
    {
      for(; !is_finished; pause())
        ask(rows_done);
      // The answers to questions that no thread waits for any more.
      for(; m_number_asked > 0; pause())
        receive();
      send_returned();
      m_world.send(0, finished_tag, news(rows_done));
    }
  }

private:
  enum : int { question_tag = 1, answer_tag = 2, finished_tag = 3, returned_tag = 4 };

  // Short beside a row, long beside a look for messages.
  static void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

  // --- rank 0 ---

  // Answers all questions that have come. A rank that has finished is counted down.
  template <typename Report>
  void answer_all(int& others, const Report& report)
  {
    while(const auto message = m_world.iprobe(boost::mpi::any_source, boost::mpi::any_tag))
    {
      std::size_t number = 0; // of rows, or of the shard that is returned
      m_world.recv(message->source(), message->tag(), number);
      if(message->tag() == returned_tag)
      {
        set_aside(number);
        continue;
      }
      if(number > 0)
        report(number);
      if(message->tag() == finished_tag)
        --others;
      else
        m_world.send(message->source(), answer_tag, take());
    }
  }

  // The next shard of the list; -1 if there is none. Threads of rank 0 take from the same list at the same time.
  long long take()
  {
    std::size_t shard = 0;
    return next(shard) ? static_cast<long long>(shard) : -1;
  }

  // --- the other ranks ---

  // Tells rank 0 of shards that other jobs have locked. Before the next question: messages of one rank stay in order,
  // so rank 0 knows what is left when it answers.
  void send_returned()
  {
    std::vector<std::size_t> returned;
    {
      const std::lock_guard<std::mutex> guard(m_mutex);
      returned.swap(m_returned);
    }
    for(const std::size_t shard : returned)
      m_world.send(0, returned_tag, shard);
  }

  // Asks for a shard for each thread that waits.
  void ask(const std::atomic<std::size_t>& rows_done)
  {
    send_returned();
    std::size_t wanted = 0;
    {
      const std::lock_guard<std::mutex> guard(m_mutex);
      const std::size_t coming = m_number_asked + m_shards.size();
      wanted = m_is_over || m_number_waiting <= coming ? 0 : m_number_waiting - coming;
    }
    // One question for each thread, so that no answer lies about while another rank could work.
    for(; wanted > 0; --wanted, ++m_number_asked)
      m_world.send(0, question_tag, news(rows_done));
    receive();
  }

  // Takes what has come, without waiting.
  void receive()
  {
    while(m_number_asked > 0 && m_world.iprobe(0, answer_tag))
    {
      long long shard = -1;
      m_world.recv(0, answer_tag, shard);
      --m_number_asked;
      const std::lock_guard<std::mutex> guard(m_mutex);
      if(shard < 0)
        m_is_over = true;
      else
        m_shards.push_back(static_cast<std::size_t>(shard));
      m_has_answer.notify_all();
    }
  }

  // The rows since the last message.
  // The sum over all messages is the number of rows of the rank.
  std::size_t news(const std::atomic<std::size_t>& rows_done)
  {
    const std::size_t now = rows_done, news = now - m_rows_told;
    m_rows_told = now;
    return news;
  }

  const boost::mpi::communicator& m_world;
  std::size_t m_number_asked = 0, m_rows_told = 0; // of the thread that talks
  std::mutex m_mutex; // guards the members below
  std::condition_variable m_has_answer;
  Shard_list m_list; // on rank 0
  std::deque<std::size_t> m_shards; // on other ranks those that no thread has taken yet
  std::vector<std::size_t> m_returned; // on other ranks those of other jobs that rank 0 does not know of yet
  std::size_t m_number_waiting = 0;
  // Set when rank 0 has no more shards, and after a failure.
  bool m_is_over = false;
};

// Lets a computation work in a thread of its own while this one talks. Returns what the computation returns. On rank 0,
// `left` gets the shards that are left to other jobs.
//
// The computation runs in a thread of its own because the thread that has initialized MPI is the one that may talk. If
// it fails on this rank, the rank still answers its questions and says that it has finished, so that the others can
// end; then the exception passes on, and the program decides about the job.
template <typename Tag, typename Computation>
bool run_with_mpi(const boost::mpi::communicator& world, Tag tag, Computation& computation,
                  const std::vector<std::size_t>& shards, std::vector<std::size_t>& left,
                  const std::atomic<std::size_t>& rows_done)
{
  Mpi_shards list(world, shards);
  std::atomic<bool> is_finished{false};
  bool is_complete = false;
  std::exception_ptr failure, failure_of_talk;
  std::thread thread([&]()
  {
    try
    {
      is_complete = computation.run(tag, list);
    }
    catch(...)
    {
      failure = std::current_exception();
      list.stop();
    }
    is_finished = true;
  });
  // A thread that is not joined would end the program before anybody sees the exception.
  try
  {
    list.serve(is_finished, rows_done, [&](std::size_t rows) { computation.report(tag, rows, 0); });
  }
  catch(...) // of the visitor, or of MPI
  {
    failure_of_talk = std::current_exception();
    list.stop();
  }
  thread.join();
  for(const std::exception_ptr& each : {failure, failure_of_talk})
    if(each != nullptr)
      std::rethrow_exception(each);
  left = list.left();
  return is_complete;
}

// Rank 0 opens or makes the folder before the others do. If it does not fit, all throw.
inline void open_with_mpi(const boost::mpi::communicator& world, Store_folder& folder,
                          const Store_description& description)
{
  using Reason = Geodesic_matrix_store_error::Reason;
  std::string message;
  int reason = -1;
  if(world.rank() == 0)
    try
    {
      folder.open_or_create(description);
    }
    catch(const Geodesic_matrix_store_error& error)
    {
      message = error.what();
      reason = static_cast<int>(error.reason());
    }
  boost::mpi::broadcast(world, reason, 0);
  boost::mpi::broadcast(world, message, 0);
  if(reason >= 0)
    throw Geodesic_matrix_store_error(static_cast<Reason>(reason), message);
  if(world.rank() != 0)
    folder.open_or_create(description);
  folder.set_merging(world.rank() == 0);
}

// All ranks read their copies of the mesh. Records are written by each rank, and moved into the manifest by rank 0.
template <typename ConcurrencyTag, typename TriangleMesh, typename Sources, typename Targets, typename NamedParameters>
Geodesic_matrix_store_status store_matrix_mpi(const boost::mpi::communicator& world, const TriangleMesh& tm,
                                              const Sources& sources, const Targets& targets, const std::string& path,
                                              const NamedParameters& np)
{
  Geodesic_matrix_store_status status = store_matrix_with<ConcurrencyTag>(
    tm, sources, targets, path, np,
    [&](Store_folder& folder, const Store_description& description) { open_with_mpi(world, folder, description); },
    [&](auto tag, auto& computation, const std::vector<std::size_t>& shards, std::vector<std::size_t>& left,
        const std::atomic<std::size_t>& rows_done)
    { return run_with_mpi(world, tag, computation, shards, left, rows_done); });
  // That of rank 0, which has waited for all others.
  for(std::size_t* const number :
      {&status.rows, &status.rows_done, &status.shards, &status.shards_done, &status.shards_in_work})
    boost::mpi::broadcast(world, *number, 0);
  return status;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_LINKED_WITH_MPI

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_MATRIX_MPI_H
