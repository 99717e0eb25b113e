// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_AVAILABLE_TAG_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_AVAILABLE_TAG_H

// Maps a concurrency tag of the user to what this compilation offers: Parallel_tag needs TBB.

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Parallel_tag or Sequential_tag. The test asks for Parallel_tag: in CGAL it is derived from Sequential_tag, so both
// convert to the latter. Without TBB, Parallel_tag is an error, as elsewhere in CGAL; Parallel_if_available_tag is
// Sequential_tag then.
template <typename ConcurrencyTag>
struct Available_tag
{
  static_assert(std::is_convertible<ConcurrencyTag, Sequential_tag>::value,
                "the concurrency tag is Sequential_tag, Parallel_tag or Parallel_if_available_tag");
#ifdef CGAL_LINKED_WITH_TBB
  using type = std::conditional_t<std::is_convertible<ConcurrencyTag, Parallel_tag>::value, Parallel_tag,
                                  Sequential_tag>;
#else
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
  using type = Sequential_tag;
#endif
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_AVAILABLE_TAG_H
