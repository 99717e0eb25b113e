// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_EQUAL_SOURCES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_EQUAL_SOURCES_H

// Sources at different points that are so near to each other that all distances from them tie up to rounding. The
// bisector of two such sources cannot be computed, so one of them gets the whole cell.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Calls visit(v, u) for each source at a vertex v with an edge to the vertex u of an earlier source such that the two
// tie: the length of the edge plus the difference of the offsets is at most Tolerance::equal_sources(), relative to the
// extent of their component (Intrinsic_mesh::extent_around()): the sources of a small component may be nearer to each
// other than the rounding of the distances in a large one. No vertex occurs both as a v and as a u, so ties do not form
// chains. Of several vertices u that tie with v, the last one around v counts. Of several sources at one vertex, the
// smallest offset counts: the others are the nearest source nowhere. Takes time linear in the number of faces around
// the sources, times the logarithm of the number of components.
//
// vertex[i] and offset[i] are those of source i, in the unit of the mesh. Requires: both ranges have the same size, and
// all sources are vertices of the mesh.
template <typename FT, typename Visit>
void for_each_equal_source(const Intrinsic_mesh<FT>& mesh, const std::vector<Vertex_id>& vertex,
                           const std::vector<FT>& offset, Visit visit)
{
  using std::abs;
  std::unordered_map<Vertex_id, FT> least_offset; // of the sources at a vertex whose turn has not come
  for(std::size_t i = 0; i < vertex.size(); ++i)
  {
    FT& least = least_offset.emplace(vertex[i], offset[i]).first->second;
    least = (std::min)(least, offset[i]);
  }
  std::unordered_map<Vertex_id, FT> offset_of; // of the vertices u so far
  for(const Vertex_id v : vertex)
  {
    const auto found = least_offset.find(v);
    if(found == least_offset.end())
      continue;
    const FT own_offset = found->second;
    least_offset.erase(found);
    const auto tie = [&](Halfedge_id e, const FT& other_offset)
    {
      return mesh.length(e) + abs(FT(other_offset - own_offset))
             <= Tolerance<FT>::equal_sources() * mesh.extent_around(face_of(e));
    };
    Vertex_id equal = null_id;
    mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
    {
      for(const Halfedge_id e : {h, previous_halfedge(h)})
      {
        const Vertex_id u = e == h ? mesh.target(e) : mesh.source(e);
        const auto it = offset_of.find(u);
        if(it != offset_of.end() && tie(e, it->second))
          equal = u;
      }
    });
    if(equal == null_id)
      offset_of.emplace(v, own_offset);
    else
      visit(v, equal);
  }
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_EQUAL_SOURCES_H
