// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_THINNING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_THINNING_H

// From the points of a path on the refined mesh to those that are told: the vertices of the path, and its
// points on edges of the mesh as it was before sources were inserted. Of several points at the same place the
// last one is told, as it is nearest to the source, but the first point of the path always is. A point is
// left out only where the points before and after it are in one face: so consecutive points always are.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Face_parts.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Straight_piece.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A vertex; or, if that is null_id, the point at t (from 0 to 1) of a halfedge of the first mesh, which lies on
// `local_halfedge` of the refined mesh. The path comes to the point in `face` of the refined mesh, which is null_id
// for the first point. Only the first point may be neither a vertex nor on an edge: then it is inside `face`.
template <typename FT>
struct Path_item
{
  Vertex_id vertex = null_id;
  Halfedge_id halfedge = null_id, local_halfedge = null_id;
  FT t = 0;
  Face_id face = null_id;
};

// Tell is called with each item that is told.
template <typename FT, typename Tell>
class Path_thinning
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Item = Path_item<FT>;

  // `extent` is that of the component (Intrinsic_mesh.h): points that are nearer to each other than it tells are one.
  Path_thinning(const Mesh& mesh, const Face_parts<FT>& parts, const FT& extent, Tell tell)
    : m_mesh(mesh), m_parts(parts), m_tell(tell), m_place(Tolerance<FT>::gap() * extent)
  {}

  // begins with a point that need not be told: a vertex, or a point of local_halfedge, or one inside a face.
  void begin_behind(const Item& first)
  {
    m_last = first;
    m_has_last = m_last_is_first = true;
  }

  void add(const Path_step<FT>& step)
  {
    if(m_entered == null_id) // else the point before was on no edge of the first mesh
      m_entered = step.face;
    m_gap = m_gap + step.gap;
    Item item;
    item.vertex = step.vertex;
    if(step.vertex == null_id)
    {
      item.halfedge = item.local_halfedge = step.halfedge;
      item.t = step.x / m_mesh.length(step.halfedge);
      if(!m_parts.find_on_whole_edge(item.halfedge, item.t))
        return;
    }
    item.face = m_entered;
    put(item, m_gap);
    m_entered = null_id;
    m_gap = 0;
  }

  // tells the last item, unless it is the first one.
  void finish()
  {
    if(m_has_pending && !(m_last_is_first && m_to_pending <= m_place))
      m_tell(m_pending);
    m_has_pending = false;
  }

private:
  // is the item on the face of the first mesh of which `part` is a part?
  bool touches(const Item& item, Face_id part) const
  {
    const Face_id f = m_parts.whole(part);
    if(item.vertex == null_id)
    {
      if(item.local_halfedge == null_id)
        return m_parts.whole(item.face) == f;
      const Halfedge_id o = m_mesh.opposite(item.local_halfedge);
      return m_parts.whole(face_of(item.local_halfedge)) == f
          || (o != null_id && m_parts.whole(face_of(o)) == f);
    }
    bool result = false;
    m_mesh.for_each_halfedge_around(item.vertex, [&](Halfedge_id h)
    { result = result || m_parts.whole(face_of(h)) == f; });
    return result;
  }

  // the item is told when it is known that the next one is not at the same place.
  void put(Item item, const FT& gap)
  {
    if(!m_has_last)
    {
      m_tell(item);
      begin_behind(item);
      return;
    }
    FT to_item = gap, at_place = 0;
    if(m_has_pending)
    {
      if(m_at_place + gap <= m_place && touches(item, m_pending.face))
      {
        item.face = m_pending.face;
        to_item = m_to_pending + gap;
        at_place = m_at_place + gap;
      }
      else if(m_to_pending <= m_place && touches(m_last, item.face))
        to_item = m_to_pending + gap;
      else
      {
        m_tell(m_pending);
        m_last = m_pending;
        m_last_is_first = false;
      }
    }
    m_pending = item;
    m_has_pending = true;
    m_to_pending = to_item;
    m_at_place = at_place;
  }

  const Mesh& m_mesh;
  const Face_parts<FT>& m_parts;
  Tell m_tell;
  FT m_place; // how far a place reaches
  Item m_last, m_pending; // the last one that has been told, and the next one
  bool m_has_last = false, m_last_is_first = false, m_has_pending = false;
  FT m_to_pending = 0; // the length from the last item that has been told
  FT m_at_place = 0;   // the length of the part that the pending item stands for
  FT m_gap = 0;        // from the last item that has been put
  Face_id m_entered = null_id;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_THINNING_H
