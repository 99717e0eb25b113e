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

// The wavefront (thesis, 3.3.2 and 4.3): the window lists that wait on its edges, and the vertices that have to be
// visited, nearest first. Each list that waits has an end of its edge in the queue, with the smallest distance
// of a window of the list; so has each pseudo-source whose windows have not been made. A child is
// never nearer than its parent: what comes out of the queue is monotone, and a distance that is not
// greater than the first key is final. Lists that enter the part already traversed wait in the same
// way, instead of being carried on at once as in the thesis (4.3.1, geodesic update): they are merged
// with what else comes that way, and no case needs code of its own.
//
// A visit has three parts: the star of the vertex is taken out of the wavefront, windows are carried through
// it (Star_propagation.h), and what has come of that is put back.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Bitset.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Star_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_front_queue.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/prefetch.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT_>
class Wavefront
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;
  using Star = Vertex_star<FT>;

  // The field is reset; it holds the result.
  Wavefront(const Mesh& mesh, Field& field)
    : m_mesh(mesh), m_field(field), m_lists(mesh.number_of_faces()), m_queue(mesh.number_of_vertices()),
      m_emission(mesh.number_of_vertices(), 0)
  {
    m_field.reset(mesh.number_of_vertices());
  }

  Wavefront(const Wavefront&) = delete;
  Wavefront& operator=(const Wavefront&) = delete;

  // forgets all, in time proportional to what has been reached. The mesh may have been changed.
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

  // adds a source; one that is not nearer to its vertex than those before is ignored.
  void add_source(Vertex_id v, const FT& offset)
  {
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

  Vertex_front_queue<FT>& queue() { return m_queue; }
  const FT& distance(Vertex_id v) const { return m_field.distance[v]; }
  const std::vector<FT>& distances() const { return m_field.distance; }

  // takes a star, whose faces and links are known, out of the wavefront.
  void take(Star& star)
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

  // Does the star hold a better distance of a vertex from which windows have started?
  bool makes_windows_stale(const Star& star) const
  {
    return std::any_of(star.links.begin(), star.links.end(), [this](const Link_vertex<FT>& link)
                       { return link.is_improved && (m_emission[link.vertex] & HAS_EMITTED) != 0; });
  }

  // puts the lists that leave a star where they wait, and takes over the distances of its links.
  void put_back(Star& star, Window_pool<FT>& pool)
  {
    m_set.reset(star.links.size());
    for(std::size_t i = 0; i < star.links.size(); ++i)
      m_set.insert(i, star.links[i].is_improved);
    m_set.for_each([&](std::size_t i) { improve(star.links[i]); });
    m_set.reset(star.faces.size());
    for(std::size_t i = 0; i < star.faces.size(); ++i)
      m_set.insert(i, star.faces[i].outward.size > 0);
    m_set.for_each([&](std::size_t i)
    {
      Star_face<FT>& f = star.faces[i];
      const Vertex_id a = star.links[f.first].vertex, b = star.links[f.second].vertex;
      const Halfedge_id h = m_mesh.opposite(next_halfedge(f.halfedge));
      prefetch(&m_mesh.face(face_of(h))); // new ground, which is not in any cache
      m_lists.put(h, f.outward, pool);
      m_queue.push_or_decrease(m_field.distance[b] < m_field.distance[a] ? b : a, f.outward_distance);
    });
    m_maximum_windows_alive = (std::max)(m_maximum_windows_alive, m_lists.number_of_windows());
  }

  // To be called when nothing waits any more. A vertex without a distance next to one that has one cannot be: in
  // faces thinner than rounding, each of two paths may have been taken for the longer one. Windows start at such
  // reached neighbours, as if paths could bend there. Returns whether there are any. (They are looked for where the run
  // has been: with many components, all other faces would cost more than the run.)
  bool start_beside_unreached_vertices()
  {
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

  // of what there is for each vertex and halfedge of the mesh.
  std::size_t table_memory() const
  {
    return m_lists.table_memory() + m_queue.table_memory() + m_emission.capacity();
  }

private:
  // Windows have to start at a vertex when it is visited; they have started there before.
  enum Emission : unsigned char { MUST_EMIT = 1, HAS_EMITTED = 2 };

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

  void improve(const Link_vertex<FT>& link)
  {
    const Vertex_id v = link.vertex;
    if(!is_improvement(link.distance, m_field.distance[v], link.may_emit))
      return;
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
  Vertex_front_queue<FT> m_queue;
  std::vector<unsigned char> m_emission; // of Emission flags
  Bitset m_set; // of what has to be put back
  bool m_has_stale_windows = false;
  std::size_t m_maximum_windows_alive = 0;
  std::size_t m_reached_at_last_start = 0; // of start_beside_unreached_vertices()
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_WAVEFRONT_H
