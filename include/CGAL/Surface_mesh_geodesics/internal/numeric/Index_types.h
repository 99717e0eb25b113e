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

// The integers that address the elements of an intrinsic mesh.
//
// All of them have 32 bits: half the memory traffic of pointers, and the same values on every platform. A halfedge has
// the number 4 * face + k, where k in {0, 1, 2} is the corner of its face at which it starts, so that a shift and a
// mask give the face and the corner. The numbers with k == 3 are not used.

#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

using Vertex_id = std::uint32_t;
using Face_id = std::uint32_t;
using Halfedge_id = std::uint32_t;

// The value for "no such element" in each of these types.
constexpr std::uint32_t null_id = (std::numeric_limits<std::uint32_t>::max)();

// The largest number of faces whose halfedges have numbers.
constexpr std::uint32_t maximum_number_of_faces = (std::uint32_t(1) << 30) - 1;

// The elements first, first + 1, ..., first + size - 1 of an array.
struct Index_range
{
  std::uint32_t first, size;
};

constexpr Halfedge_id halfedge_of(Face_id f, unsigned int k) { return 4 * f + k; }
constexpr Face_id face_of(Halfedge_id h) { return h >> 2; }
constexpr unsigned int index_in_face(Halfedge_id h) { return h & 3u; }

// The position of h in an array with one entry for each of the three halfedges of all faces.
constexpr std::size_t dense_index(Halfedge_id h) { return 3 * std::size_t(face_of(h)) + index_in_face(h); }

// The corner after corner k of a triangle, and the one before it. The constants are tables of two bits for each corner:
// corners arrive in any order, and a branch would be mispredicted for every other one.
constexpr unsigned int next_corner(unsigned int k) { return 0x9u >> 2 * k & 3u; }
constexpr unsigned int previous_corner(unsigned int k) { return 0x12u >> 2 * k & 3u; }

// The corner n steps after corner k, and the number of steps from corner k to corner 0.
// Requires: n <= 2.
constexpr unsigned int corner_after(unsigned int k, unsigned int n) { return 0x124u >> 2 * (k + n) & 3u; }
constexpr unsigned int corners_to_first(unsigned int k) { return 0x18u >> 2 * k & 3u; }

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
