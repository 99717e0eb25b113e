// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_SHARED_COMPUTATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_SHARED_COMPUTATION_H

// Steps of an object that several threads may ask for at once, and that one of them computes.

#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>

#include <CGAL/assertions.h>

#include <atomic>
#include <mutex>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// One object guards all steps of its owner, so no two of them are computed at the same time. A step that is done costs
// its readers one atomic flag.
class Shared_computation
{
public:
  // Calls compute() unless the flag is set, and sets it unless compute() returns false or throws. Of several threads
  // one computes; the others wait. The thread is asked for before it locks: a visitor runs under the mutex, and would
  // wait for itself.
  template <typename Compute>
  bool run_once(std::atomic<bool>& is_done, Compute compute)
  {
    if(is_done.load(std::memory_order_acquire))
      return true;
    CGAL_precondition_msg(!m_computing_thread.is_this(), "a visitor has called the object that is being built");
    const std::lock_guard<std::mutex> lock(m_mutex);
    const Computing_thread::Scope scope(m_computing_thread);
    if(is_done.load(std::memory_order_relaxed)) // another thread has computed meanwhile
      return true;
    if(!compute())
      return false;
    is_done.store(true, std::memory_order_release);
    return true;
  }

private:
  std::mutex m_mutex; // held by the thread that computes
  Computing_thread m_computing_thread;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_SHARED_COMPUTATION_H
