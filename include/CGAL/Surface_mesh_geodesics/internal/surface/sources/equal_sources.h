// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_EQUAL_SOURCES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_EQUAL_SOURCES_H

// Sources that are nowhere nearer than another one by more than rounding: all paths from them tie with paths from that
// one, or are longer. The bisector of two such sources cannot be computed, so one of them gets the whole cell.

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

// Which sources give their cells to which others, each one once at most, and to one that still has its cell then. So
// they form no circles.
class Given_cells
{
public:
  void give(Vertex_id from, Vertex_id to)
  {
    m_receiver.emplace(from, to);
    m_givers.push_back(from);
  }

  // Calls visit(v, u) in the order of the calls of give(): u is the one that has the cell of v in the end.
  template <typename Visit>
  void for_each(Visit visit) const
  {
    for(const Vertex_id v : m_givers)
    {
      Vertex_id u = v;
      for(auto it = m_receiver.find(u); it != m_receiver.end(); it = m_receiver.find(u))
        u = it->second;
      visit(v, u);
    }
  }

private:
  std::unordered_map<Vertex_id, Vertex_id> m_receiver;
  std::vector<Vertex_id> m_givers;
};

// Calls visit(v, u) for each source at a vertex v that gives its cell to the one at u.
//
// Formula: let l be the length of an edge from v to u, and o(v), o(u) the offsets. Each point x has d(u, x) + o(u) <=
// d(v, x) + o(v) + e, where e = l + o(u) - o(v): if e is at most Tolerance::equal_sources(), relative to the extent of
// their component (Intrinsic_mesh::extent_around()), the source at v is nowhere nearer than that at u, up to rounding.
// (The sources of a small component may be nearer to each other than the rounding of the distances in a large one. If
// -e is larger than the tolerance, v has no cell in any case.) Ties: if both sources are nowhere nearer than the other
// one, they are at one point up to rounding, and the earlier one gets the cell. Of several vertices u that get the cell
// of v, the last one around v counts.
//
// No vertex occurs both as a v and as a u: a source that gives its cell away gives those that it has got to the same
// one. Of several sources at one vertex, the smallest offset counts: the others are the nearest source nowhere. Takes
// time linear in the number of faces around the sources, times the logarithm of the number of components.
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
  std::unordered_map<Vertex_id, FT> offset_of; // of the vertices so far that keep their cells
  Given_cells cells;
  for(const Vertex_id v : vertex)
  {
    const auto found = least_offset.find(v);
    if(found == least_offset.end())
      continue;
    const FT own_offset = found->second;
    least_offset.erase(found);
    // Whether a source with the first offset, at one end of e, is nowhere nearer than that at the other end.
    const auto is_superfluous = [&](Halfedge_id e, const FT& its_offset, const FT& other_offset)
    {
      return abs(FT(mesh.length(e) + (other_offset - its_offset)))
             <= Tolerance<FT>::equal_sources() * mesh.extent_around(face_of(e));
    };
    Vertex_id equal = null_id;
    std::vector<Vertex_id> around; // that give their cells to v, unless v gives its cell away
    mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
    {
      for(const Halfedge_id e : {h, previous_halfedge(h)})
      {
        const Vertex_id u = e == h ? mesh.target(e) : mesh.source(e);
        const auto it = offset_of.find(u);
        if(it == offset_of.end())
          continue;
        if(is_superfluous(e, own_offset, it->second))
          equal = u;
        else if(is_superfluous(e, it->second, own_offset))
          around.push_back(u);
      }
    });
    if(equal != null_id)
    {
      cells.give(v, equal);
      continue;
    }
    offset_of.emplace(v, own_offset);
    for(const Vertex_id u : around)
      if(offset_of.erase(u) != 0) // both faces at an edge find its end
        cells.give(u, v);
  }
  cells.for_each(visit);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_EQUAL_SOURCES_H
