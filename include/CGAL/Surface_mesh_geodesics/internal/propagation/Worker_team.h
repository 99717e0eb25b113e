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

// Threads that work together. This is all that is asked of TBB; algorithms are templates of a team, so
// that they can be checked with threads that a race detector understands.

#ifdef CGAL_LINKED_WITH_TBB

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The threads of the task arena of the calling thread.
class Tbb_team
{
public:
  static std::size_t size() { return (std::max)(std::size_t(1), std::size_t(tbb::this_task_arena::max_concurrency())); }

  // calls work(0) in this thread and work(1) ... work(n-1) in others; returns when all have returned. Other
  // threads may come late, even after work(0) has returned. None of the calls may throw.
  template <typename Work>
  static void run(std::size_t n, Work work)
  {
    tbb::task_group others;
    for(std::size_t i = 1; i < n; ++i)
      others.run([&work, i]() { work(i); });
    work(0);
    others.wait();
  }

  // calls a function of the user, which may use TBB: its waiting must not begin other work of the team.
  template <typename Function>
  static auto isolate(Function function)
  {
    return tbb::this_task_arena::isolate(function);
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_LINKED_WITH_TBB

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WORKER_TEAM_H
