// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_ONE_BLOCK_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_ONE_BLOCK_H

// Loops over 0 .. n-1 that may be divided into blocks of consecutive numbers. Such a loop is a template of how the
// blocks are worked on: a function object that gets n and work(first, last). It calls `work` for blocks that together
// are 0 .. n-1, in this thread or in several (propagation/Block_team.h), and returns when all calls have returned. If
// calls throw, it throws the exception of the first block. So a loop that stops at its first fault finds the same fault
// in any number of blocks.

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// All numbers in one block, in this thread.
struct One_block
{
  template <typename Work>
  void operator()(std::size_t n, const Work& work) const
  {
    work(std::size_t(0), n);
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_ONE_BLOCK_H
