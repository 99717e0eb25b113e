// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_BLOCK_TEAM_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_BLOCK_TEAM_H

// The threads of a team work on blocks of numbers (numeric/One_block.h), a block each.

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Worker_team.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Team` is a team of threads: see Worker_team.h. The blocks depend on the size of the team, so work() must have the
// same result for any blocks.
template <typename Team>
class Block_team
{
public:
  explicit Block_team(Team team = Team()) : m_team(team) {}

  // Calls work(first, last) for blocks of nearly the same size, the first one in this thread. A short loop stays in
  // this thread, as one block, which is empty if n is 0. Each thread writes an entry of `faults` of its own: a team
  // must not see an exception, and the fault of the first block is thrown, whichever came first in time.
  template <typename Work>
  void operator()(std::size_t n, const Work& work) const
  {
    const std::size_t blocks = (std::max)((std::min)(m_team.size(), n / least_block), std::size_t(1));
    std::vector<std::exception_ptr> faults(blocks);
    m_team.run(blocks, [&](std::size_t i)
    { faults[i] = fault_of([&]() { work(n * i / blocks, n * (i + 1) / blocks); }); });
    for(const std::exception_ptr& fault : faults)
      if(fault != nullptr)
        std::rethrow_exception(fault);
  }

private:
  // Starting a thread takes as long as the work on a few hundred faces.
  static constexpr std::size_t least_block = 1024;

  Team m_team;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_BLOCK_TEAM_H
