// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_STAR_PROPAGATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_STAR_PROPAGATION_H

// The visit of a vertex (thesis, 4.3.2 and algorithm 2, lines 8-28): the vertex emits windows if it is a pseudo-source,
// and all lists that wait to enter the faces around it are propagated through these faces until they leave the star.
//
// A visit reads the mesh; it reads and writes the star (Vertex_star.h), its own pool of windows and its own statistics.
// Stars that share no window list can therefore be visited by several threads at the same time.
//
// Order of the three steps. Lists that turn around the vertex clockwise leave a face on the left, lists that turn
// counterclockwise on the right, and windows of the vertex itself in between. Appended in this order, the lists that
// leave are sorted by key (Window.h). The thesis merges them spatially (prime merger, Rule 3); here the pair rules are
// applied to the merged list when it is propagated the next time (Window_list_crossing.h).
//
// Complexity: linear in the number of windows that are propagated (thesis, propositions 4.6 and 4.7).

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Emission_sector.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_crossing.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_loops.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_of_pseudo_source.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Does d replace the distance of a vertex? It does if it is smaller. At a vertex that may emit windows it must be
// clearly smaller: for an improvement within rounding all windows would have to be emitted again. Ties keep the old
// distance.
template <typename FT>
bool is_improvement(const FT& d, const FT& distance, bool may_emit)
{
  return d < distance
      && (!may_emit || is_clearly_less(d, distance) || !(distance < Vertex_distance_field<FT>::infinity()));
}

// `Rules` switches pruning rules off, for measurements. `Keeper` is a policy: keep(h, list) receives each list that is
// propagated across h, after pruning.
//
// Invariants, between visits: the pool owns the blocks of all lists; m_statistics counts all visits since restart().
//
// Threads: an object is used by one thread at a time. Objects of several threads may share the mesh and the distances,
// which no visit changes.
template <typename FT, typename Rules, typename Keeper = No_window_keeper>
class Star_propagation
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Star = Vertex_star<FT>;
  using Face = Star_face<FT>;
  using Link = Link_vertex<FT>;
  using List = Window_list<FT>;
  using List_crossing = Window_list_crossing<FT, Rules>;

  // Of `distance`, only the entries of pseudo-sources that have emitted windows are read: they tell which windows are
  // stale. The vector must outlive this object.
  Star_propagation(const Mesh& mesh, const std::vector<FT>& distance, Keeper keeper = Keeper(),
                   Lane_choice lanes = Lane_choice::BEST)
    : m_mesh(mesh), m_keeper(keeper),
      m_crossing(mesh, distance, m_statistics, lanes), m_sector(mesh),
      m_maximum_distance(Vertex_distance_field<FT>::infinity())
  {}

  Star_propagation(const Star_propagation&) = delete;
  Star_propagation& operator=(const Star_propagation&) = delete;

  // Resets the statistics. The pool keeps its memory for the next run.
  void restart() { m_statistics = Propagation_statistics(); }

  // Tells the edges of the curves that are sources; their vertices emit between the normals of the curves only. The
  // last call counts, also after restart(): without curves the range is empty.
  template <typename Edges>
  void set_source_edges(const Edges& edges)
  {
    m_sector.between_normals().set_source_edges(edges);
  }

  // Drops each list whose windows are all farther away than d. Requires: d >= 0.
  void set_maximum_distance(const FT& d)
  {
    CGAL_assertion(d >= 0);
    m_maximum_distance = d;
  }

  // Visits the vertex of a star. Requires: the star has been filled by Wavefront::take().
  // Afterwards no window waits inside the star: see the invariants of Vertex_star.
  //
  // The edges come first, so that all windows are compared with distances of the link that count the paths along the
  // edges. All distances are in the unit of the mesh.
  void propagate(Star& star)
  {
    CGAL_expensive_assertion(star.waiting_lists_are_marked());
    ++m_statistics.vertices_visited;
    m_crossing.expect_stale_windows(star.has_stale_windows);
    if(star.emits)
    {
      walk_along_edges(star);
      m_sector.find(star);
    }
    turn_clockwise(star);
    if(star.emits)
      emit_windows(star);
    turn_counterclockwise(star);
    CGAL_expensive_assertion(star.nothing_waits());
  }

  Window_pool<FT>& pool() { return m_pool; }
  Keeper& keeper() { return m_keeper; }
  const Propagation_statistics& statistics() const { return m_statistics; }
  std::size_t memory() const { return m_pool.memory(); }

private:
  // Improves the vertices of the link by the paths from the vertex along its edges. A window improves only the apex of
  // the face that it enters, not the ends of its own edge. Each edge is tried from both of its faces, the second time
  // without effect.
  void walk_along_edges(Star& star) const
  {
    for(const Face& f : star.faces)
    {
      const Halfedge_id va = f.halfedge, bv = previous_halfedge(va);
      const FT& to_a = m_mesh.length(va);
      const FT& to_b = m_mesh.length(bv);
      improve(star.links[f.first], FT(star.distance + to_a), bv, to_b, star.vertex);
      improve(star.links[f.second], FT(star.distance + to_b), va, FT(0), star.vertex);
    }
  }

  // Emits a window from the vertex onto the opposite edge of each face, as far as the sector reaches, unless the edge
  // is a border, has no length, or the window is beaten by the vertex a or b at once (rule of Xin and Wang 2009).
  //
  // The window is in the frame of the halfedge ba, which belongs to the face beyond: seen from v, b is on the left. The
  // distances of its ends are those along the edges vb and va.
  void emit_windows(Star& star)
  {
    for(std::size_t i = 0; i < star.faces.size(); ++i)
    {
      Face& f = star.faces[i];
      const Face_frame<FT> c = m_mesh.face_frame(next_halfedge(f.halfedge)); // of the edge ab; the apex is the vertex
      if(!m_sector.contains(i) || m_mesh.opposite(next_halfedge(f.halfedge)) == null_id || !(c.length > 0))
        continue;
      Window<FT> w;
      window_of_pseudo_source<FT>(c, star.distance, star.distance + c.right_length,
                                  star.distance + c.left_length, w);
      if(!m_sector.trim(i, c.length, w))
        continue;
      if(Rules::vertex_rule
         && is_beaten_by_vertices(w, c.length, star.links[f.second].rival(), star.links[f.first].rival()))
      {
        ++m_statistics.windows_removed_by_vertices;
        continue;
      }
      m_pool.reserve(f.outward, 1);
      Window_batch<FT> batch;
      batch.start(f.outward, 0);
      batch.add(w);
      put_outward(f, batch);
    }
  }

  // Propagates the lists that turn counterclockwise, face by face. A list that has turned around the whole vertex
  // reaches the first face again, so the sweep is repeated until no list is left.
  void turn_counterclockwise(Star& star)
  {
    Bitset& waiting = star.waiting;
    while(!waiting.empty())
      waiting.for_each([&](std::size_t i)
      {
        waiting.remove(i);
        Face& f = star.faces[i];
        cross_counterclockwise(star, f);
        if(f.next != null_id)
          waiting.insert(f.next, star.faces[f.next].counterclockwise.size > 0);
      });
  }

  // The mirror image: faces are numbered from the last one on, so that the sweep runs against their order. (A set
  // visits its elements in ascending order, and also those that are inserted behind the current one.)
  void turn_clockwise(Star& star)
  {
    Bitset& waiting = star.waiting_from_last;
    const std::size_t last = star.faces.size() - 1;
    while(!waiting.empty())
      waiting.for_each([&](std::size_t i)
      {
        waiting.remove(i);
        Face& f = star.faces[last - i];
        cross_clockwise(star, f);
        if(f.previous != null_id)
          waiting.insert(last - f.previous, star.faces[f.previous].clockwise.size > 0);
      });
  }

  // Propagates a list across va: its left part goes on around v, its right part leaves the star. The list is taken out
  // of the face first, since the part that goes on around v may wait for the same face (a star of one face).
  //
  // Frame: that of va. The corners A, B and C are v, a and b; the left edge AC is that to the next face around v, the
  // right edge CB is that of the link.
  void cross_counterclockwise(Star& star, Face& f)
  {
    const Face_frame<FT> c = m_mesh.face_frame(f.halfedge);
    Corner_rivals<FT> corners{rival(star), star.links[f.first].rival(), star.links[f.second].rival()};
    typename List_crossing::Apex_path path;
    List list = f.counterclockwise;
    f.counterclockwise = List();
    if(enter(f.halfedge, c, corners, list, star.links[f.second], path))
    {
      List* const around = f.next == null_id ? nullptr : &star.faces[f.next].counterclockwise;
      List* const outward = c.right == null_id ? nullptr : &f.outward;
      m_crossing.split(list, c, corners, path, reserve(around, list.size, c.left_length),
                       reserve(outward, list.size, c.right_length));
      put_around(around, m_crossing.left());
      put_outward(f, m_crossing.right());
    }
    m_pool.release(list);
  }

  // Propagates a list across bv: its right part goes on around v, its left part leaves the star. Frame: that of bv, so
  // the corners A, B and C are b, v and a.
  void cross_clockwise(Star& star, Face& f)
  {
    const Halfedge_id bv = previous_halfedge(f.halfedge);
    const Face_frame<FT> c = m_mesh.face_frame(bv);
    Corner_rivals<FT> corners{star.links[f.second].rival(), rival(star), star.links[f.first].rival()};
    typename List_crossing::Apex_path path;
    List list = f.clockwise;
    f.clockwise = List();
    if(enter(bv, c, corners, list, star.links[f.first], path))
    {
      List* const around = f.previous == null_id ? nullptr : &star.faces[f.previous].clockwise;
      List* const outward = c.left == null_id ? nullptr : &f.outward;
      m_crossing.split(list, c, corners, path, reserve(outward, list.size, c.left_length),
                       reserve(around, list.size, c.right_length));
      put_outward(f, m_crossing.left());
      put_around(around, m_crossing.right());
    }
    m_pool.release(list);
  }

  // Prunes the list that is about to enter a face across h, finds its shortest path to the third vertex of the face,
  // and improves that vertex. Returns whether anything of the list is left. The keeper sees what pruning has left,
  // before the list is split. An improved apex becomes the rival of the children: split() uses `corners` next.
  bool enter(Halfedge_id h, const Face_frame<FT>& c, Corner_rivals<FT>& corners, List& list, Link& apex,
             typename List_crossing::Apex_path& path)
  {
    ++m_statistics.window_lists;
    m_crossing.prune(list, c, corners);
    if(list.size == 0)
      return false;
    m_statistics.windows_propagated += list.size;
    m_keeper.keep(h, list);
    path = m_crossing.find_apex_path(list, c);
    if(!comes_from_corner(path, c, corners)
       && improve(apex, path.distance, h, path.separating_point, path.root))
    {
      apex.image = Arrival_image<FT>{path.image_x, path.image_depth};
      corners.apex = apex.rival();
    }
    return true;
  }

  // Does the path to the apex run through a corner of the edge that is a pseudo-source, and along a side of the face?
  // That corner emits the same path, and wins the tie: what lies behind a vertex belongs to the source of the vertex.
  bool comes_from_corner(const typename List_crossing::Apex_path& path, const Face_frame<FT>& c,
                         const Corner_rivals<FT>& corners) const
  {
    const auto emits = [&](Vertex_id corner, const FT& d)
    { return m_mesh.has(corner, Mesh::PSEUDO_SOURCE) && !is_clearly_less(path.distance, d); };
    if(path.separating_point <= 0)
      return emits(c.origin, corners.origin.distance + c.left_length);
    return path.separating_point >= c.length && emits(c.target, corners.target.distance + c.right_length);
  }

  // Improves a vertex of the link by a path of length d, if it is shorter. The last straight piece of the path leads
  // from the vertex `root` through the point `abscissa` of the halfedge h opposite to the vertex. Returns whether it
  // did. The image is set by enter() only: a path along an edge needs none.
  static bool improve(Link& link, const FT& d, Halfedge_id h, const FT& abscissa, Vertex_id root)
  {
    if(!is_improvement(d, link.distance, link.may_emit))
      return false;
    CGAL_expensive_assertion(d < link.distance && root != null_id);
    link.is_improved = true;
    link.distance = d;
    link.arrival.abscissa = abscissa;
    link.arrival.halfedge = h;
    link.arrival.root = root;
    return true;
  }

  static Vertex_rival<FT> rival(const Star& star) { return Vertex_rival<FT>(star.distance, star.is_degenerate); }

  // Reserves capacity for n more windows in a list. Returns a list without a block if there is no list (at the border),
  // or if its edge has no length. The result refers to the block of the list: split() writes there, and put() makes the
  // windows part of the list. In between, nothing else may be added to the list.
  List reserve(List* list, std::size_t n, const FT& length)
  {
    if(list == nullptr || !(length > 0))
      return List();
    m_pool.reserve(*list, n);
    return *list;
  }

  // Appends windows that go on around the vertex, if there is a face there.
  void put_around(List* list, const Window_batch<FT>& batch)
  {
    if(batch.has_block())
      put(*list, batch);
  }

  // Appends windows that leave the star, if there is a face beyond.
  void put_outward(Face& f, const Window_batch<FT>& batch)
  {
    if(!batch.has_block())
      return;
    put(f.outward, batch);
    f.outward_distance = (std::min)(f.outward_distance, batch.minimum_distance);
  }

  // Appends to a list a batch that was written into the spare capacity of the list; drops a batch that is too far away.
  // (A window at the maximum distance stays: it may reach a vertex there.) A list that stays empty gives its block
  // back.
  void put(List& list, const Window_batch<FT>& batch)
  {
    const bool is_too_far = batch.size > 0 && batch.minimum_distance > m_maximum_distance;
    const std::size_t n = is_too_far ? 0 : batch.size;
    m_pool.add(list, n, batch.steps);
    m_statistics.windows_created += n;
  }

  const Mesh& m_mesh;
  Keeper m_keeper;
  Window_pool<FT> m_pool;
  Propagation_statistics m_statistics;
  List_crossing m_crossing;
  Emission_sector<FT> m_sector;
  FT m_maximum_distance;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_STAR_PROPAGATION_H
