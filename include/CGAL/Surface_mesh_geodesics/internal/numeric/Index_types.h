// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_INDEX_TYPES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_INDEX_TYPES_H

// The integers that address the elements of an intrinsic mesh. All of them have 32 bits: half the
// memory traffic of pointers, and the same values on every platform.
//
// A halfedge is numbered 4 * face + k with k in {0, 1, 2}, so that its face and its place in the
// face are a shift and a mask. The slot k == 3 is never used.

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

using Vertex_id = std::uint32_t;
using Face_id = std::uint32_t;
using Halfedge_id = std::uint32_t;

// The value that stands for "no such element" in each of the types above.
constexpr std::uint32_t null_id = (std::numeric_limits<std::uint32_t>::max)();

// The largest number of faces that the numbering of halfedges leaves room for.
constexpr std::uint32_t maximum_number_of_faces = (std::uint32_t(1) << 30) - 1;

// The elements first, first + 1, ..., first + size - 1 of an array.
struct Index_range
{
  std::uint32_t first, size;
};

constexpr Halfedge_id halfedge_of(Face_id f, unsigned int k) { return 4 * f + k; }
constexpr Face_id face_of(Halfedge_id h) { return h >> 2; }
constexpr unsigned int index_in_face(Halfedge_id h) { return h & 3u; }

// The place that follows, or precedes, the place k of a triangle. (From tables of two bits each: places are
// arbitrary, and a branch would be predicted wrong for every other one.)
constexpr unsigned int next_corner(unsigned int k) { return 0x9u >> 2 * k & 3u; }
constexpr unsigned int previous_corner(unsigned int k) { return 0x12u >> 2 * k & 3u; }

// The place that is n places after the place k; n is 0, 1 or 2. And the number of places from the place k to 0.
constexpr unsigned int place_after(unsigned int k, unsigned int n) { return 0x124u >> 2 * (k + n) & 3u; }
constexpr unsigned int places_to_first(unsigned int k) { return 0x18u >> 2 * k & 3u; }

constexpr Halfedge_id next_halfedge(Halfedge_id h)
{
  return halfedge_of(face_of(h), next_corner(index_in_face(h)));
}

constexpr Halfedge_id previous_halfedge(Halfedge_id h)
{
  return halfedge_of(face_of(h), previous_corner(index_in_face(h)));
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_NUMERIC_INDEX_TYPES_H
