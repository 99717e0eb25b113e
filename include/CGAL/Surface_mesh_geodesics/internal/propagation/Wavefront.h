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

// The wavefront (thesis, 3.3.2 and 4.3): the window lists that wait on edges, the distances found so far, and the
// vertices that must still emit windows. It owns all state between visits of vertices but the queue of vertices, which
// belongs to the propagation: wherever a vertex must be queued, the wavefront calls push(vertex, key).
//
// A visit has three steps. The wavefront moves the lists around a vertex into a star (take), the windows are propagated
// through the star (Star_propagation.h), and the wavefront takes over what leaves the star (put_lists and improve). The
// sequential and the parallel propagation differ only in when, and in which thread, they call these steps.
//
// What two visits may do at the same time. Let no two of the vertices be neighbors. Then their stars share no face, and
// take() and put_lists() of one visit use lists that no other visit uses: a list is taken by a visit of an end of its
// edge, and put by a visit of the vertex opposite to its edge. improve() changes distances that other visits read, so
// it must wait until all visits are over.
//
// Deviation from the thesis: lists that turn back into the area already traversed wait like all others. The thesis
// propagates them at once (4.3.1, Geodesic Update). Waiting merges them with other windows that reach the same edge,
// and needs no separate code.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Bitset.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Star_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariants, while no star is taken out and each vertex is queued that was pushed:
// - Each list that waits on a halfedge has an end of that edge in the queue, with a key that is not greater than the
//   distance of any of its windows.
// - Each pseudo-source that must emit windows is in the queue, with a key that is not greater than its distance.
// - Hence, when the queue is empty, nothing waits.
// The converse does not hold: a vertex may stay in the queue after the visit of a neighbor has taken its lists.
//
// Distances of vertices never grow. A window is never nearer than its parent, so the keys of successive visits ascend,
// up to rounding, unless a source is added or a visit is skipped; and a distance that is not greater than the top key
// is final.
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
    : m_mesh(mesh), m_field(field), m_lists(mesh.number_of_faces()),
      m_emission(mesh.number_of_vertices(), 0)
  {
    m_field.reset(mesh.number_of_vertices());
  }

  Wavefront(const Wavefront&) = delete;
  Wavefront& operator=(const Wavefront&) = delete;

  // Removes all sources, distances and windows, in time proportional to what has been reached. The mesh may have
  // changed since. `slots` are those of all threads; `pool` may be the pool of any. Requires: no star is taken out.
  template <typename RangeOfSlots>
  void restart(Window_pool<FT>& pool, const RangeOfSlots& own_slots)
  {
    for(const Vertex_id v : m_field.reached)
      m_emission[v] = 0;
    m_emission.resize(m_mesh.number_of_vertices(), 0);
    m_field.restart(m_mesh.number_of_vertices());
    m_lists.restart(m_mesh.number_of_faces(), pool, own_slots);
    m_stale_up_to = -1;
    m_reached_at_last_start = 0;
  }

  // Adds a source. Ignores a source that is not nearer to its vertex than earlier ones: of equal sources the first one
  // stays. Requires: v is a vertex of the mesh; offset >= 0 and finite.
  template <typename Push>
  void add_source(Vertex_id v, const FT& offset, Push push)
  {
    CGAL_assertion(v < m_field.distance.size() && offset >= 0 && offset < Field::infinity());
    if(!(offset < m_field.distance[v]))
      return;
    if((m_emission[v] & HAS_EMITTED) != 0)
      m_stale_up_to = Field::infinity();
    m_field.set_distance(v, offset);
    m_field.arrival[v].abscissa = 0;
    m_field.arrival[v].halfedge = null_id;
    m_field.arrival[v].root = v;
    m_emission[v] |= MUST_EMIT;
    push(v, offset);
  }

  const FT& distance(Vertex_id v) const { return m_field.distance[v]; }
  const std::vector<FT>& distances() const { return m_field.distance; }

  // Moves what waits around a vertex into its star, and copies distances there. `key` is the queue key of the vertex.
  // Linear in the degree of the vertex. Requires: star.surround() was called; the vertex has left the queue; no star
  // of a neighbor is taken out.
  void take(Star& star, const FT& key, Window_list_slots& own_slots)
  {
    copy_distances(star);
    star.has_stale_windows = key <= m_stale_up_to;
    take_lists(star, own_slots);
  }

  // Takes over the lists that leave a star. Linear in the degree of the vertex, plus the windows of lists that have to
  // be merged. Requires: the star was taken and propagated.
  //
  // A list is queued at the nearer end of its edge, as the star knows the ends; of ends at the same distance, at the
  // target of its halfedge.
  template <typename Push>
  void put_lists(Star& star, Window_pool<FT>& pool, Window_list_slots& own_slots, Push push)
  {
    CGAL_expensive_assertion(star.nothing_waits());
    for_each_marked(star.marks, star.faces, [](const Star_face<FT>& f) { return f.outward.size > 0; },
                    [&](Star_face<FT>& f)
    {
      const Link_vertex<FT>&a = star.links[f.first], &b = star.links[f.second];
      const Halfedge_id h = m_mesh.opposite(next_halfedge(f.halfedge));
      CGAL_expensive_assertion(h != null_id && f.outward_distance < Field::infinity());
      prefetch(&m_mesh.face(face_of(h))); // not visited before, so in no cache
      m_lists.put(h, f.outward, pool, own_slots);
      push(b.distance < a.distance ? b.vertex : a.vertex, f.outward_distance);
    });
  }

  // Calls visit(link) for each link that the star has improved.
  template <typename Visit>
  static void for_each_improved_link(Star& star, Visit visit)
  {
    for_each_marked(star.marks, star.links, [](const Link_vertex<FT>& link) { return link.is_improved; }, visit);
  }

  // Takes over the distance of a link that a star has improved, and pushes the vertex if it must emit windows. Appends
  // the vertex to `reached` if it had no distance. Returns whether the vertex had emitted windows, which are stale now.
  // Changes nothing if the vertex is as near already: where faces are glued to each other, it may be two links of one
  // star.
  // Requires: of several improvements of a vertex in stars that are out together, only the best one is taken over.
  template <typename Push>
  bool improve(Vertex_id v, const FT& distance, const Vertex_arrival<FT>& arrival, const Arrival_image<FT>& image,
               std::vector<Vertex_id>& reached, Push push)
  {
    if(!is_improvement(distance, m_field.distance[v], may_emit(v)))
      return false;
    CGAL_expensive_assertion(distance < m_field.distance[v]);
    if(!(m_field.distance[v] < Field::infinity()))
      reached.push_back(v);
    m_field.distance[v] = distance;
    m_field.arrival[v] = arrival;
    if(m_field.keeps_images)
      m_field.image[v] = image;
    m_emission[v] &= HAS_EMITTED;
    if(m_mesh.has(v, Mesh::PSEUDO_SOURCE))
    {
      m_emission[v] |= MUST_EMIT;
      push(v, distance);
    }
    return (m_emission[v] & HAS_EMITTED) != 0;
  }

  // Lets stars expect stale windows, if improve() has returned true: those of vertices with keys up to `largest_key`.
  // Requires: this is not smaller than any key in the queue.
  //
  // All lists that wait now are taken by visits with such keys, and these visits remove stale windows. (One that is
  // missed costs time, no digit: it is part of a path on the surface.)
  void expect_stale_windows(const FT& largest_key) { m_stale_up_to = (std::max)(m_stale_up_to, largest_key); }

  // Is everything that waits next to the vertex of a star queued? That is the part of the invariants that a visit of
  // the vertex could break. Requires: no star is taken out.
  template <typename Queue>
  bool is_queued_around(const Star& star, const Queue& queue) const
  {
    for(const Link_vertex<FT>& link : star.links)
      if((m_emission[link.vertex] & MUST_EMIT) != 0 && !queue.contains(link.vertex))
        return false;
    for(const Star_face<FT>& f : star.faces)
    {
      const Halfedge_id h = m_mesh.opposite(next_halfedge(f.halfedge));
      if(h != null_id && m_lists.has(h) && !queue.contains(star.links[f.first].vertex)
         && !queue.contains(star.links[f.second].vertex))
        return false;
    }
    return true;
  }

  // Lets windows start at vertices with a distance that share a face with a vertex without one, as if paths could bend
  // there, and returns whether there are any. Requires: nothing waits. Linear in the area reached since the last call.
  //
  // In exact arithmetic no such vertex exists. In faces thinner than rounding each of two paths may have been pruned
  // because of the other. Only the area reached is searched: with many components all other faces would cost more than
  // the propagation. Within a run, vertices are appended to those reached. What was there at the last call has been
  // searched then: it has no new neighbor without a distance, and windows have started there.
  template <typename Push>
  bool start_beside_unreached_vertices(Push push)
  {
    const std::size_t reached = m_field.reached.size();
    const std::size_t first = std::exchange(m_reached_at_last_start, reached);
    bool is_any = false;
    for(std::size_t i = first; i < reached && reached < m_mesh.number_of_vertices(); ++i)
    {
      const Vertex_id v = m_field.reached[i];
      if(!is_beside_unreached_vertex(v))
        continue;
      m_emission[v] |= MUST_EMIT;
      push(v, m_field.distance[v]);
      is_any = true;
    }
    return is_any;
  }

  Window_lists<FT>& lists() { return m_lists; }
  std::vector<Vertex_id>& reached() { return m_field.reached; }
  std::size_t memory() const { return m_lists.memory(); }

  // Bytes of the tables that have an entry for each vertex or halfedge of the mesh.
  std::size_t table_memory() const
  {
    return m_lists.table_memory() + m_emission.capacity();
  }

private:
  // Flags of a vertex. HAS_EMITTED stays until restart(); MUST_EMIT is cleared by the visit that emits, and by an
  // improvement, which sets it again if the vertex is a pseudo-source.
  enum Emission : unsigned char { MUST_EMIT = 1, HAS_EMITTED = 2 };

  // Do windows start at v now or later? (Without a branch, as none could be predicted.)
  bool may_emit(Vertex_id v) const { return ((m_mesh.kind(v) & Mesh::PSEUDO_SOURCE) | m_emission[v]) != 0; }

  void copy_distances(Star& star)
  {
    const Vertex_id v = star.vertex;
    star.distance = m_field.distance[v];
    star.arrival = m_field.arrival[v];
    star.is_degenerate = m_mesh.has(v, Mesh::DEGENERATE);
    star.emits = (m_emission[v] & MUST_EMIT) != 0;
    star.has_emitted = (m_emission[v] & HAS_EMITTED) != 0;
    if(star.emits)
      m_emission[v] = HAS_EMITTED;
    for(Link_vertex<FT>& link : star.links)
    {
      link.distance = m_field.distance[link.vertex];
      link.is_degenerate = m_mesh.has(link.vertex, Mesh::DEGENERATE);
      link.may_emit = may_emit(link.vertex);
    }
  }

  // Moves the lists of all halfedges that lead into the star, and marks the faces that they wait to enter. The flags of
  // all faces are read first, without a branch; then only the lists that exist are visited.
  void take_lists(Star& star, Window_list_slots& own_slots)
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
      [&](std::size_t i) { m_lists.take(star.faces[i].halfedge, star.faces[i].counterclockwise, own_slots); });
    star.waiting_from_last.for_each([&](std::size_t i)
    {
      Star_face<FT>& f = star.faces[n - 1 - i];
      m_lists.take(previous_halfedge(f.halfedge), f.clockwise, own_slots);
    });
  }

  // Calls visit() for the elements that satisfy a condition. All are tested first, without a branch; then only those
  // that satisfy it are visited. `marks` is a buffer.
  template <typename T, typename Condition, typename Visit>
  static void for_each_marked(Bitset& marks, std::vector<T>& elements, Condition condition, Visit visit)
  {
    marks.reset(elements.size());
    for(std::size_t i = 0; i < elements.size(); ++i)
      marks.insert(i, condition(elements[i]));
    marks.for_each([&](std::size_t i) { visit(elements[i]); });
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

  const Mesh& m_mesh;
  Field& m_field;
  Window_lists<FT> m_lists;
  std::vector<unsigned char> m_emission; // flags of Emission, by vertex
  FT m_stale_up_to = -1; // visits with larger keys meet no window of a vertex that was improved after it emitted
  std::size_t m_reached_at_last_start = 0; // vertices reached at the last start_beside_unreached_vertices()
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WAVEFRONT_H
