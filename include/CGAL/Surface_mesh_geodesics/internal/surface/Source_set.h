// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCE_SET_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCE_SET_H

// The sources of a propagation in terms of the intrinsic mesh: vertices, and locations in faces, which become
// vertices before the propagation starts.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Source_insertion.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A source in a face of the intrinsic mesh, and its position in the range of sources.
template <typename FT>
struct Located_source
{
  Face_id face;
  std::array<FT, 3> coordinates;
  std::size_t position;
};

// Sources as vertices and places of the intrinsic mesh.
template <typename FT>
struct Source_set
{
  std::vector<Vertex_id> vertices;         // by position; null_id for those in faces
  std::vector<Located_source<FT>> located; // those in faces
  std::vector<FT> offsets;                 // none, or one for each source
};

// makes vertices of all located sources, in the order of their places, and sets vertices[position].
template <typename FT>
void insert_located_sources(std::vector<Located_source<FT>>& sources, Source_insertion<FT>& insertion,
                            std::vector<Vertex_id>& vertices)
{
  std::sort(sources.begin(), sources.end(),
            [](const Located_source<FT>& a, const Located_source<FT>& b)
            { return std::tie(a.face, a.coordinates) < std::tie(b.face, b.coordinates); });
  for(const Located_source<FT>& s : sources)
    vertices[s.position] = insertion.insert(s.face, s.coordinates);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCE_SET_H
