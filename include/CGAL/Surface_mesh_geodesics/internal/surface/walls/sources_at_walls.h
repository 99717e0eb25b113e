// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_WALLS_SOURCES_AT_WALLS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_WALLS_SOURCES_AT_WALLS_H

// Sources at walls: a point of a wall belongs to all of its sides, so it is a source on each of them.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The set grows behind its end, as the numbers of the sources of the user are their positions. A location at a corner
// is a vertex, and has copies as one; a location on an edge has one other side.
//
// The other sides of a vertex come from the table of copies, those of a point of an edge from the user's mesh.
//
// Lists each source at a wall once more for each other side (Source_set::behind_walls). for_each_copy(v, visit) calls
// visit(c) for all copies of a vertex, and location_behind_wall(f, c) returns the same point on the other side of a
// wall: a halfedge of the face there and the coordinates; null_id if it is on no wall. Takes linear time.
//
// Requires: the set is complete, no source is inserted, and none is listed behind walls yet.
template <typename FT, typename ForEachCopy, typename LocationBehindWall>
void list_sources_behind_walls(const Intrinsic_mesh<FT>& mesh, Source_set<FT>& set, const ForEachCopy& for_each_copy,
                               const LocationBehindWall& location_behind_wall)
{
  const std::size_t number = set.size(), number_located = set.located.size();
  const auto add_copies = [&](std::size_t i, Vertex_id v)
  {
    for_each_copy(v, [&](Vertex_id c)
    {
      if(c != v)
        set.add_behind_wall(i, c);
    });
  };
  for(std::size_t i = 0; i < number; ++i)
    if(set.vertices[i] != null_id)
      add_copies(i, set.vertices[i]);
  for(std::size_t j = 0; j < number_located; ++j)
  {
    const Located_source<FT> s = set.located[j];
    Barycentric<FT> c = s.coordinates;
    snap_coordinates(c);
    for(unsigned int k = 0; k < 3; ++k)
      if(c[k] == 1)
        add_copies(s.position, mesh.face(s.face).vertex[k]);
    const auto behind = location_behind_wall(s.face, c);
    if(behind.first == null_id)
      continue;
    set.located.push_back({face_of(behind.first), behind.second, set.size()});
    set.add_behind_wall(s.position, null_id);
  }
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_WALLS_SOURCES_AT_WALLS_H
