// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CHUNK_TEAM_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CHUNK_TEAM_H

// Loops whose steps differ much in time, and which a visitor may end: the threads of a team take chunks of consecutive
// numbers, one after the other. Chunks do not depend on the number of threads. So a loop that keeps a result for each
// chunk, and puts these together in the order of the chunks, has the same result with any number of threads.
//
// Block_team.h is for short loops: it has one block for each thread, and no visitor.

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Worker_team.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Team` is a team of threads: see Worker_team.h. It is copied into the object, which has no other state, so several
// threads may use one object for different loops.
template <typename Team>
class Chunk_team
{
public:
  // Faces with many windows take milliseconds each, others less than a microsecond, and such faces lie together. Chunks
  // are large enough that taking one costs nothing beside working on it, and small enough that no thread waits
  // long for the others at the end.
  static constexpr std::size_t chunk_size = 64;

  explicit Chunk_team(Team team = Team()) : m_team(team) {}

  // The number of chunks of n numbers.
  static std::size_t number_of_chunks(std::size_t n) { return (n + chunk_size - 1) / chunk_size; }

  // Calls work(c, first, last, ask) for each chunk c of 0 .. n-1, which has the numbers first .. last-1, until go_on()
  // returns false; returns false then. A call of work() asks before each of its steps whether to go on, and returns at
  // once if ask() is false. Only the calling thread calls go_on(), which is the user's. If calls throw, throws one of
  // their exceptions, that of the calling thread first.
  template <typename GoOn, typename Work>
  bool operator()(std::size_t n, GoOn go_on, const Work& work) const
  {
    // A thread takes the chunk `next`. Neither variable needs an order with other memory: what work() writes is read
    // after the team has returned, which orders it.
    std::atomic<std::size_t> next{0};
    std::atomic<bool> is_ended{false};
    std::vector<std::exception_ptr> faults(
      (std::max)((std::min)(m_team.size(), number_of_chunks(n)), std::size_t(1)));
    m_team.run(faults.size(), [&](std::size_t worker)
    {
      const auto ask = [&]()
      {
        if(worker == 0 && !is_ended.load(std::memory_order_relaxed) && !m_team.isolate([&]() { return bool(go_on()); }))
          is_ended = true;
        return !is_ended.load(std::memory_order_relaxed);
      };
      faults[worker] = fault_of([&]()
      {
        for(std::size_t c = next++; c < number_of_chunks(n) && !is_ended; c = next++)
          work(c, c * chunk_size, (std::min)(n, (c + 1) * chunk_size), ask);
      });
      if(faults[worker] != nullptr) // the other threads need not finish what nobody will read
        is_ended = true;
    });
    for(const std::exception_ptr& fault : faults)
      if(fault != nullptr)
        std::rethrow_exception(fault);
    return !is_ended;
  }

private:
  Team m_team;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CHUNK_TEAM_H
