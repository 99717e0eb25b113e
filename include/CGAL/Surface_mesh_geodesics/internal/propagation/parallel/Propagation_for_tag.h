// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PROPAGATION_FOR_TAG_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PROPAGATION_FOR_TAG_H

// The propagation and the loops that a concurrency tag stands for. All propagations have the same members, and a
// constructor from mesh and field, and a keeper if there is one.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/One_block.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Block_team.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Chunk_team.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Worker_team.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Parallel_distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Propagation_by_size.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Tag` is the type of an Available_tag: Sequential_tag, or Parallel_tag where TBB is linked. The primary templates
// serve Sequential_tag.
template <typename Tag, typename FT, typename Rules, typename Keeper = No_window_keeper>
struct Propagation_for_tag
{
  using type = Distance_propagation<FT, Rules, Keeper>;
};

// How loops over the elements of a mesh are divided: a function object as in One_block.h. Only the reading of a mesh
// uses it; a propagation shares its work in its own way (Work_sharing.h).
template <typename Tag>
struct Blocks_for_tag
{
  using type = One_block;
};

// The same for loops that a visitor may end (Chunk_team.h).
template <typename Tag>
struct Chunks_for_tag
{
  using type = Chunk_team<Calling_thread>;
};

#ifdef CGAL_LINKED_WITH_TBB
template <>
struct Blocks_for_tag<Parallel_tag>
{
  using type = Block_team<Tbb_team>;
};

template <>
struct Chunks_for_tag<Parallel_tag>
{
  using type = Chunk_team<Tbb_team>;
};

template <typename FT, typename Rules, typename Keeper>
struct Propagation_for_tag<Parallel_tag, FT, Rules, Keeper>
{
  using type = Parallel_distance_propagation<FT, Rules, Tbb_team, Keeper>;
};

// Without a keeper, a small mesh is left to one thread. (What a keeper does with the windows is worth sharing on any.)
template <typename FT, typename Rules>
struct Propagation_for_tag<Parallel_tag, FT, Rules, No_window_keeper>
{
  using type = Propagation_by_size<FT, Rules, Tbb_team>;
};
#endif

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PROPAGATION_FOR_TAG_H
