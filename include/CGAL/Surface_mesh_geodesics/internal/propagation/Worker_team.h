// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WORKER_TEAM_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WORKER_TEAM_H

// A team of threads: the only file that knows TBB. Parallel algorithms are templates of the team, so that tests can
// run them with plain threads, which a race detector understands.
//
// A team has three members: size(), run(n, work) and isolate(function), with the contracts of Tbb_team.

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <algorithm>
#include <cstddef>
#include <exception>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Calls a function, and returns the exception that ends it, if there is one. The work of a team must not throw.
template <typename Function>
std::exception_ptr fault_of(const Function& function)
{
  try
  {
    function();
  }
  catch(...)
  {
    return std::current_exception();
  }
  return nullptr;
}

// The calling thread alone.
struct Calling_thread
{
  static std::size_t size() { return 1; }

  template <typename Work>
  static void run(std::size_t, Work work)
  {
    work(0);
  }

  template <typename Function>
  static auto isolate(Function function)
  {
    return function();
  }
};

#ifdef CGAL_LINKED_WITH_TBB

// The threads of the task arena of the calling thread. An empty class: copies are the same team.
class Tbb_team
{
public:
  // The number of threads that may work at the same time; at least 1.
  static std::size_t size() { return (std::max)(std::size_t(1), std::size_t(tbb::this_task_arena::max_concurrency())); }

  // Calls work(0) in this thread and work(1) .. work(n-1) in others, and returns when all calls have returned. Other
  // threads may start late, even after work(0) has returned. Requires: n > 0; the calls do not throw.
  //
  // While this thread waits, it does not start other work of its arena, which might ask for a mutex that the caller
  // holds.
  //
  // If TBB finds no memory for a task, it may wait forever: its task_group counts a task before it allocates it.
  template <typename Work>
  static void run(std::size_t n, Work work)
  {
    tbb::this_task_arena::isolate([n, &work]()
    {
      tbb::task_group others;
      for(std::size_t i = 1; i < n; ++i)
        others.run([&work, i]() { work(i); });
      work(0);
      others.wait();
    });
  }

  // Calls a function of the user, and returns its result. The function may use TBB: while it waits, it does not start
  // other work of the team.
  template <typename Function>
  static auto isolate(Function function)
  {
    return tbb::this_task_arena::isolate(function);
  }
};

#endif // CGAL_LINKED_WITH_TBB

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WORKER_TEAM_H
