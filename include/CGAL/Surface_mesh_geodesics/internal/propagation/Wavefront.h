// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WAVEFRONT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WAVEFRONT_H

// The wavefront (thesis, 3.3.2 and 4.3): the window lists that wait on edges, and the vertices that must be visited,
// nearest first. It owns all state between visits of vertices.
//
// A visit has three steps. The wavefront moves the lists around a vertex into a star (take), the windows are propagated
// through the star (Star_propagation.h), and the wavefront takes over what leaves the star (put_back). The sequential
// and the parallel propagation differ only in when they call these steps.
//
// Deviation from the thesis: lists that turn back into the area already traversed wait like all others. The thesis
// propagates them at once (4.3.1, Geodesic Update). Waiting merges them with other windows that reach the same edge,
// and needs no separate code.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Bitset.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/prefetch.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Star_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront_queue.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariants, while no star is taken out:
// - Each list that waits on a halfedge has an end of that edge in the queue, with a key that is not greater than the
//   distance of any of its windows.
// - Each pseudo-source that must emit windows is in the queue, with a key that is not greater than its distance.
// - Hence, when the queue is empty, nothing waits.
// The converse does not hold: a vertex may stay in the queue after the visit of a neighbor has taken its lists.
//
// Distances of vertices never grow. A window is never nearer than its parent, so the keys of successive visits ascend,
// up to rounding, unless a source is added; and a distance that is not greater than the top key is final.
//
// The parallel propagation removes a vertex from the queue while the star of a neighbor is taken out, and reinserts it
// afterwards with its key. The first two invariants then hold for the queue and these vertices together.
template <typename FT_>
class Wavefront
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;
  using Star = Vertex_star<FT>;

  // Resets the field, which receives the result. Mesh and field must outlive this object.
  Wavefront(const Mesh& mesh, Field& field)
    : m_mesh(mesh), m_field(field), m_lists(mesh.number_of_faces()), m_queue(mesh.number_of_vertices()),
      m_emission(mesh.number_of_vertices(), 0)
  {
    m_field.reset(mesh.number_of_vertices());
  }

  Wavefront(const Wavefront&) = delete;
  Wavefront& operator=(const Wavefront&) = delete;

  // Removes all sources, distances and windows, in time proportional to what has been reached. The mesh may have
  // changed since. Requires: no star is taken out; `pool` may be any pool of the propagation.
  void restart(Window_pool<FT>& pool)
  {
    for(const Vertex_id v : m_field.reached)
      m_emission[v] = 0;
    m_emission.resize(m_mesh.number_of_vertices(), 0);
    m_field.restart(m_mesh.number_of_vertices());
    m_queue.restart(m_mesh.number_of_vertices());
    m_lists.restart(m_mesh.number_of_faces(), pool);
    m_has_stale_windows = false;
    m_maximum_windows_alive = 0;
    m_reached_at_last_start = 0;
  }

  // Adds a source. Ignores a source that is not nearer to its vertex than earlier ones: of equal sources the first one
  // stays. Requires: v is a vertex of the mesh; offset >= 0 and finite.
  void add_source(Vertex_id v, const FT& offset)
  {
    CGAL_assertion(v < m_field.distance.size() && offset >= 0 && offset < Field::infinity());
    if(!(offset < m_field.distance[v]))
      return;
    if((m_emission[v] & HAS_EMITTED) != 0)
      m_has_stale_windows = true;
    m_field.set_distance(v, offset);
    m_field.arrival[v].abscissa = 0;
    m_field.arrival[v].halfedge = null_id;
    m_field.arrival[v].root = v;
    m_emission[v] |= MUST_EMIT;
    m_queue.push_or_decrease(v, offset);
  }

  Wavefront_queue<FT>& queue() { return m_queue; }
  const FT& distance(Vertex_id v) const { return m_field.distance[v]; }
  const std::vector<FT>& distances() const { return m_field.distance; }

  // Does nothing wait?
  bool empty() const { return m_queue.empty() && m_lists.number_of_windows() == 0; }

  // Moves what waits around a vertex into its star, and copies distances there. Linear in the degree of the vertex.
  // Requires: star.surround() was called; the vertex is not in the queue; no star of a neighbor is taken out.
  void take(Star& star)
  {
    CGAL_expensive_assertion(!m_queue.contains(star.vertex));
    copy_distances(star);
    take_lists(star);
  }

  // Does the star improve the distance of a vertex that has emitted windows?
  bool makes_windows_stale(const Star& star) const
  {
    return std::any_of(star.links.begin(), star.links.end(), [this](const Link_vertex<FT>& link)
                       { return link.is_improved && (m_emission[link.vertex] & HAS_EMITTED) != 0; });
  }

  // Takes over the lists that leave a star and the distances of its links. Linear in the degree of the vertex, plus the
  // windows of lists that have to be merged. Requires: the star was taken and propagated.
  //
  // A list is queued at the nearer end of its edge; of ends at the same distance, at the target of its halfedge.
  void put_back(Star& star, Window_pool<FT>& pool)
  {
    CGAL_expensive_assertion(star.nothing_waits());
    put_distances(star);
    put_lists(star, pool);
    m_maximum_windows_alive = (std::max)(m_maximum_windows_alive, m_lists.number_of_windows());
  }

  // Is everything that waits next to the vertex of a star queued? That is the part of the invariants that a visit of
  // the vertex could break. Requires: no star is taken out.
  bool is_queued_around(const Star& star) const
  {
    for(const Link_vertex<FT>& link : star.links)
      if((m_emission[link.vertex] & MUST_EMIT) != 0 && !m_queue.contains(link.vertex))
        return false;
    for(const Star_face<FT>& f : star.faces)
    {
      const Halfedge_id h = m_mesh.opposite(next_halfedge(f.halfedge));
      if(h != null_id && m_lists.has(h) && !m_queue.contains(star.links[f.first].vertex)
         && !m_queue.contains(star.links[f.second].vertex))
        return false;
    }
    return true;
  }

  // Lets windows start at vertices with a distance that share a face with a vertex without one, as if paths could bend
  // there. Returns whether there are any. Requires: nothing waits. Linear in the area reached, and constant if no
  // vertex was reached since the last call.
  //
  // In exact arithmetic no such vertex exists. In faces thinner than rounding each of two paths may have been pruned
  // because of the other. Only the area reached is searched: with many components all other faces would cost more than
  // the propagation.
  bool start_beside_unreached_vertices()
  {
    CGAL_assertion(empty());
    const std::size_t reached = m_field.reached.size();
    if(reached == m_mesh.number_of_vertices() || reached == m_reached_at_last_start)
      return false;
    m_reached_at_last_start = reached;
    for(const Vertex_id v : m_field.reached)
      if(is_beside_unreached_vertex(v))
      {
        m_emission[v] |= MUST_EMIT;
        m_queue.push_or_decrease(v, m_field.distance[v]);
      }
    return !m_queue.empty();
  }

  std::size_t maximum_windows_alive() const { return m_maximum_windows_alive; }
  std::size_t memory() const { return m_lists.memory(); }

  // Bytes of the tables that have an entry for each vertex or halfedge of the mesh.
  std::size_t table_memory() const
  {
    return m_lists.table_memory() + m_queue.table_memory() + m_emission.capacity();
  }

private:
  // Flags of a vertex. HAS_EMITTED stays until restart(); MUST_EMIT is cleared by the visit that emits, and by an
  // improvement, which sets it again if the vertex is a pseudo-source.
  enum Emission : unsigned char { MUST_EMIT = 1, HAS_EMITTED = 2 };

  void copy_distances(Star& star)
  {
    const Vertex_id v = star.vertex;
    star.distance = m_field.distance[v];
    star.arrival = m_field.arrival[v];
    star.is_degenerate = m_mesh.has(v, Mesh::DEGENERATE);
    star.has_stale_windows = m_has_stale_windows;
    star.emits = (m_emission[v] & MUST_EMIT) != 0;
    star.has_emitted = (m_emission[v] & HAS_EMITTED) != 0;
    if(star.emits)
      m_emission[v] = HAS_EMITTED;
    for(Link_vertex<FT>& link : star.links)
    {
      link.distance = m_field.distance[link.vertex];
      link.is_degenerate = m_mesh.has(link.vertex, Mesh::DEGENERATE);
      link.may_emit = ((m_mesh.kind(link.vertex) & Mesh::PSEUDO_SOURCE) | m_emission[link.vertex]) != 0;
    }
  }

  // Moves the lists of all halfedges that lead into the star, and marks the faces that they wait to enter. The flags of
  // all faces are read first, without a branch; then only the lists that exist are visited.
  void take_lists(Star& star)
  {
    const std::size_t n = star.faces.size();
    star.waiting.reset(n);
    star.waiting_from_last.reset(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      const Halfedge_id h = star.faces[i].halfedge;
      star.waiting.insert(i, m_lists.has(h));
      star.waiting_from_last.insert(n - 1 - i, m_lists.has(previous_halfedge(h)));
    }
    star.waiting.for_each(
      [&](std::size_t i) { m_lists.take(star.faces[i].halfedge, star.faces[i].counterclockwise); });
    star.waiting_from_last.for_each([&](std::size_t i)
    {
      Star_face<FT>& f = star.faces[n - 1 - i];
      m_lists.take(previous_halfedge(f.halfedge), f.clockwise);
    });
  }

  void put_distances(Star& star)
  {
    m_set.reset(star.links.size());
    for(std::size_t i = 0; i < star.links.size(); ++i)
      m_set.insert(i, star.links[i].is_improved);
    m_set.for_each([&](std::size_t i) { improve(star.links[i]); });
  }

  void put_lists(Star& star, Window_pool<FT>& pool)
  {
    m_set.reset(star.faces.size());
    for(std::size_t i = 0; i < star.faces.size(); ++i)
      m_set.insert(i, star.faces[i].outward.size > 0);
    m_set.for_each([&](std::size_t i)
    {
      Star_face<FT>& f = star.faces[i];
      const Vertex_id a = star.links[f.first].vertex, b = star.links[f.second].vertex;
      const Halfedge_id h = m_mesh.opposite(next_halfedge(f.halfedge));
      CGAL_expensive_assertion(h != null_id && f.outward_distance < Field::infinity());
      prefetch(&m_mesh.face(face_of(h))); // not visited before, so in no cache
      m_lists.put(h, f.outward, pool);
      m_queue.push_or_decrease(m_field.distance[b] < m_field.distance[a] ? b : a, f.outward_distance);
    });
  }

  bool is_beside_unreached_vertex(Vertex_id v) const
  {
    bool is_beside = false;
    m_mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
    {
      for(const Vertex_id corner : m_mesh.face(face_of(h)).vertex)
        is_beside = is_beside || !(m_field.distance[corner] < Field::infinity());
    });
    return is_beside;
  }

  // Takes over the distance of a link, unless it is no improvement any more: in the parallel propagation another star
  // may have improved the vertex in the meantime.
  void improve(const Link_vertex<FT>& link)
  {
    const Vertex_id v = link.vertex;
    if(!is_improvement(link.distance, m_field.distance[v], link.may_emit))
      return;
    CGAL_expensive_assertion(link.distance < m_field.distance[v]);
    m_field.set_distance(v, link.distance);
    m_field.arrival[v] = link.arrival;
    if(m_field.keeps_images)
      m_field.image[v] = link.image;
    if((m_emission[v] & HAS_EMITTED) != 0)
      m_has_stale_windows = true;
    m_emission[v] &= HAS_EMITTED;
    if(m_mesh.has(v, Mesh::PSEUDO_SOURCE))
    {
      m_emission[v] |= MUST_EMIT;
      m_queue.push_or_decrease(v, link.distance);
    }
  }

  const Mesh& m_mesh;
  Field& m_field;
  Window_lists<FT> m_lists;
  Wavefront_queue<FT> m_queue;
  std::vector<unsigned char> m_emission; // flags of Emission, by vertex
  Bitset m_set;                          // buffer of put_back(): the links, then the faces that have changed
  bool m_has_stale_windows = false;      // a vertex that has emitted windows has been improved
  std::size_t m_maximum_windows_alive = 0;
  std::size_t m_reached_at_last_start = 0; // vertices reached at the last start_beside_unreached_vertices()
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WAVEFRONT_H
