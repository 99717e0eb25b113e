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

// Turns the points of a path on the refined mesh into those that the user gets: the vertices of the path, and its
// points on edges of the mesh as it was before sources were inserted.
//
// Points that are nearer to each other along the path than the merge distance count as one. Of those the last one is
// reported, as it is nearest to the source; but the first point of the path always is. A point is left out only if the
// points before and after it lie in one face. So points that follow each other always share a face.

#include <CGAL/Surface_mesh_geodesics/internal/paths/Straight_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Face_parts.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A point that is reported: a vertex, or, if `vertex` is null_id, the point at t of a halfedge of the first mesh, 0 at
// its source and 1 at its target. In the refined mesh this point lies on `local_halfedge`. The path arrives through
// `face` of the refined mesh, which is null_id for the first point. Only the first point may be neither a vertex nor on
// an edge; then it is inside `face`.
template <typename FT>
struct Path_item
{
  Vertex_id vertex = null_id;
  Halfedge_id halfedge = null_id, local_halfedge = null_id;
  FT t = 0;
  Face_id face = null_id;
};

// Calls `report` with each item, in the order of the path. Call begin_behind() first if the path begins at a point that
// is reported elsewhere, then add() for each step, then finish(). An object serves one path.
//
// Invariants between calls: all items before m_pending are reported or left out; m_last is the last one that was
// reported, or the point of begin_behind(). Two items at most are remembered, so paths of any length take no memory.
template <typename FT, typename Report>
class Path_thinning
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Item = Path_item<FT>;

  // `extent` is that of the component in which the path runs (Intrinsic_mesh.h); the merge distance is relative to it.
  Path_thinning(const Mesh& mesh, const Face_parts<FT>& parts, const FT& extent, Report report)
    : m_mesh(mesh), m_parts(parts), m_report(report),
      m_merge_distance(Tolerance<FT>::gap() * extent)
  {}

  // Begins at a point that is not reported: a vertex, or a point of local_halfedge, or one inside a face.
  void begin_behind(const Item& first)
  {
    m_last = first;
    m_has_last = m_last_is_first = true;
  }

  // Takes the next step. A step on an edge that is not part of an edge of the first mesh is passed over; its gap and
  // face count for the next step. (An edge with a step inside has a length: see Path_step.)
  void add(const Path_step<FT>& step)
  {
    CGAL_expensive_assertion(step.gap >= 0);
    if(m_entered == null_id)
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

  // Reports the last item, unless it coincides with the first point.
  void finish()
  {
    if(m_has_pending && !(m_last_is_first && m_to_pending <= m_merge_distance))
      m_report(m_pending);
    m_has_pending = false;
  }

private:
  // Returns whether the item lies on the face of the first mesh of which `part` is a part. Takes time linear in the
  // degree of a vertex. A point on an edge touches the faces on both sides, a point inside a face only its own.
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

  // Takes the next item, at the length `gap` from the one before. An item stays pending until the next one shows
  // whether they count as one. There are three cases:
  // - The new item and all that the pending one stands for are within the merge distance: the new item replaces it.
  // - The pending item is within the merge distance of the last one that was reported: it is left out.
  // - Else the pending item is reported.
  // The first two need a face that both neighbors touch.
  void put(Item item, const FT& gap)
  {
    if(!m_has_last)
    {
      m_report(item);
      begin_behind(item);
      return;
    }
    FT to_item = gap, merged = 0;
    if(m_has_pending)
    {
      if(m_merged + gap <= m_merge_distance && touches(item, m_pending.face))
      {
        item.face = m_pending.face;
        to_item = m_to_pending + gap;
        merged = m_merged + gap;
      }
      else if(m_to_pending <= m_merge_distance && touches(m_last, item.face))
        to_item = m_to_pending + gap;
      else
      {
        m_report(m_pending);
        m_last = m_pending;
        m_last_is_first = false;
      }
    }
    m_pending = item;
    m_has_pending = true;
    m_to_pending = to_item;
    m_merged = merged;
  }

  const Mesh& m_mesh;
  const Face_parts<FT>& m_parts;
  Report m_report;
  FT m_merge_distance;
  Item m_last, m_pending; // the last item that was reported, and the next one
  bool m_has_last = false, m_last_is_first = false, m_has_pending = false;
  FT m_to_pending = 0;         // the length of the path from m_last to m_pending
  FT m_merged = 0;             // the length of the part for which m_pending stands
  FT m_gap = 0;                // the length from the last item that was put
  Face_id m_entered = null_id; // through which the path has left that item; null_id if it has not left it
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_THINNING_H
