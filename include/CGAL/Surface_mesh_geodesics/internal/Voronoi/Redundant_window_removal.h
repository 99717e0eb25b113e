// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_REDUNDANT_WINDOW_REMOVAL_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_REDUNDANT_WINDOW_REMOVAL_H

// Keeps the windows that a diagram needs while distances are propagated, and releases the others as early as
// possible: window-VTP with redundant window removal (thesis, 5.1 and 5.2). Decides when edges and faces are divided;
// Edge_partition decides which site owns each part of an edge.
//
// *Redundant faces.* The shortest path to a point of a face comes from a corner of the face or through a window that
// has entered the face. So windows are kept for the face that they enter. If all of these windows and the three
// corners have the same site, the face is redundant and releases its windows. (Definition 5.1 of the thesis looks at
// a face and its neighbors, as it keeps windows on edges.)
//
// *Inactive faces.* A face becomes inactive (proposition 5.1) when the wavefront has passed the distances of all points
// of its border: no later window can change anything in it (window/passing/Passed_faces.h).
//
// *Edges.* When the faces on both sides of an edge are inactive, the edge is divided (Edge_partition.h) into the
// intervals where its windows are nearest: the trimming rule of 5.2, for all windows of an edge at once. Windows that
// are nearest nowhere are removed; the others keep their whole intervals. Afterwards far more faces are redundant:
// those that windows of another site have entered, but nowhere as the nearest ones.
//
// *Divided faces.* A face that lies in several cells is handed over as a Divided_face when all of its edges have been
// divided. After that its windows are released.
//
// *Several threads.* Dividing an edge needs its windows only. So other threads may divide edges, in the batch of visits
// after the one that has found them (Work_in_batches.h); the removal takes them back in the next batch.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Divided_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Edge_division.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Edge_partition.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Site_strips.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Vertex_owners.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/site_images_of_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_table.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Face_windows.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Kept_window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/Passed_faces.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/Work_in_batches.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/entering_windows.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Consumer` has a member add(const Divided_face<FT>&), which is called once for each face that lies in several cells.
//
// In the propagation, keep() and advance() are called in turn, then finish(). All faces have been handed over when
// finish() returns, and no windows are left; owners() may be called then. Time: linear in the number of windows that
// enter faces, plus for each divided edge what Edge_partition takes.
//
// One thread at a time may call an object, except for do_unit(), which any threads may call meanwhile. An object reads
// the mesh and the distances, and writes neither.
//
// Invariants:
// - The state of a face only grows (State). m_windows has windows of ACTIVE and INACTIVE faces only; keep() rejects
//   those that come later, and remove_windows() releases those of a face that is DONE.
// - Each edge is closed once, after the last of its faces has become inactive (deactivate()); open_edges counts the
//   sides that are still to come. So a face is handed over after all of its edges, and both faces at an edge get the
//   same breakpoints.
template <typename FT_, typename Consumer_>
class Redundant_window_removal
{
public:
  using FT = FT_;
  using Consumer = Consumer_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // Starts anew. The arguments are referred to, not copied: the mesh, refined by the sites, and the field into which
  // the propagation writes. If `is_early` is false, redundant windows are removed by finish() only (to measure what
  // early removal saves). Takes time linear in the size of the mesh.
  void reset(const Mesh& mesh, const Field& field, Consumer& consumer, bool is_early = true)
  {
    m_consumer = &consumer;
    m_mesh = &mesh;
    m_field = &field;
    m_is_early = is_early;
    m_faces.reset(mesh, field, Face_record());
    m_owner.reset(mesh.number_of_vertices(), field);
    m_strips.clear();
    m_windows.reset(mesh.number_of_faces());
    m_breakpoints.clear();
    m_range_of_edge.clear();
    m_number_of_kept = m_lists_since_advance = 0;
    m_due_faces.clear();
    m_due_edges.clear();
    m_closed_faces.clear();
    m_are_edges_deferred = false;
    m_waiting_edges.clear();
  }

  // Gives the cell of one source to another one: see Vertex_owners::unite(). Call it after reset() and before the first
  // keep().
  void unite(Vertex_id source, Vertex_id first) { m_owner.unite(source, first); }

  // Knows sites by numbers from now on, those of the vertices of sources: see Vertex_owners::set_sites(). Call it after
  // reset() and before the first keep().
  void set_sites(std::vector<Vertex_id> site_of_source) { m_owner.set_sites(std::move(site_of_source)); }

  // Keeps the windows of a list that the propagation carries across h into the face of h, unless that face is inactive.
  // The list is copied. Requires: it is not empty.
  void keep(Halfedge_id h, const Window_list<FT>& list)
  {
    CGAL_expensive_assertion(are_on_edge(list, m_mesh->length(h)));
    keep(h, list.size, [&](std::size_t i) { return kept_window(list, i); },
         [&] { return bound_by_windows(*m_mesh, *m_field, h, list); }, [&] { return smallest_distance(list); });
  }

  // The same for a list of n windows that is known by window(i), by bound(), which is bound_by_windows(), and by
  // smallest(), which is smallest_distance(). Each is called only if it is needed.
  template <typename Window_at, typename Bound, typename Smallest>
  void keep(Halfedge_id h, std::size_t n, Window_at window, Bound bound, Smallest smallest)
  {
    const Face_id f = face_of(h);
    if(is_inactive(f)) // the face has been divided: its windows are not needed any more
      return;
    Face_record& record = m_faces[f];
    Vertex_id last = null_id; // (adjacent windows often have the same root)
    m_windows.add(h, n, [&](std::size_t i)
    {
      const Kept_window<FT> w = window(i);
      if(w.root != last)
        add_source_of(w.root, record);
      last = w.root;
      return w;
    });
    m_number_of_kept += n;
    ++m_lists_since_advance;
    m_faces.set_bound(h, bound());
    if(record.state == ACTIVE)
      return;
    record.state = ACTIVE;
    if(m_is_early)
      m_faces.wait(f, smallest());
  }

  // Takes all windows and strips of a complete run with curves among its sources, in place of keep() and advance().
  // Sites are numbers from now on (Site_strips.h). Both fields are those of the mesh; the second one is referred to.
  // (Such a run keeps everything: strips and windows do not prune each other, and the bounds by which faces become
  // inactive know windows only.)
  void take(const Edge_window_field<FT>& windows, const Curve_arrivals<FT>& arrivals)
  {
    m_strips.reset(arrivals);
    m_owner.set_sites(m_strips.sites_of_roots(*m_field));
    for(Face_id f = 0; f < m_faces.size(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
      {
        const Halfedge_id h = halfedge_of(f, k);
        windows.for_each_window(h, [&](const Kept_window<FT>& w)
        {
          add_source_of(w.root, m_faces[f]);
          m_windows.add(h, w);
          ++m_number_of_kept;
        });
        m_strips.for_each(h, [&](std::size_t, const Strip<FT>&, Vertex_id site) { add_site(site, m_faces[f]); });
      }
  }

  // Tells which distances are final: those up to `reached`. keep() may then come before the distances of the roots are
  // final, and remembers no source of a vertex whose path may still change. At first, all distances count as final.
  void set_final_distance(const FT& reached) { m_owner.set_final_distance(reached); }

  // Lets the inactive region grow, as the wavefront has reached a distance (thesis, algorithm 4, step 4).
  // Requires: distances below `reached` are final, and windows with paths that short have been kept.
  //
  // No face becomes inactive before enough lists have been kept: some faces at once need the caches once, and the
  // propagation has them for itself meanwhile. A face of these keeps the few windows that come later than they need to,
  // which are nearest nowhere.
  void advance(const FT& reached)
  {
    if(m_waiting_edges.has_done())
    {
      m_waiting_edges.take_back([this](const Edge_division<FT>& edge) { finish_edge(edge); });
      finish_closed_faces();
    }
    if(m_lists_since_advance < lists_per_batch)
      return;
    m_lists_since_advance = 0;
    m_faces.advance(reached, [&](Face_id f) { m_due_faces.push_back(f); });
    deactivate_due_faces();
  }

  // --- edges that several threads divide (Work_in_batches.h) ---

  // Lets this number of threads divide the edges, from now on until finish(): in the units of each batch. Edges that
  // wait from an earlier run are forgotten.
  void defer_edges(std::size_t number_of_threads)
  {
    m_are_edges_deferred = true;
    m_waiting_edges.clear();
    m_partition.resize((std::max)(number_of_threads, std::size_t(1)));
  }

  // Begins a batch, and returns the number of its units. Requires: advance() was called since the last batch, if that
  // batch had units.
  std::size_t begin_batch() { return m_waiting_edges.begin_batch(); }

  // Does a unit, with the partition of a thread. Any thread may call it, each with its own number.
  void do_unit(std::size_t unit, std::size_t thread)
  {
    m_waiting_edges.do_unit(unit, dividing_by(m_partition[thread]));
  }

  // The memory of the edges that wait, in bytes.
  std::size_t memory_of_edges() const
  {
    std::size_t n = 0;
    m_waiting_edges.for_each_item([&](const Edge_division<FT>& edge) { n += edge.memory(); });
    return n;
  }

  // Divides all edges, in this thread, and makes all faces inactive, as the propagation has ended. That includes those
  // around sources, which no window may have entered, and those that no site reaches; these have no owner, and count as
  // redundant.
  void finish()
  {
    m_owner.set_final_distance(Field::infinity());
    m_waiting_edges.finish(dividing_by(m_partition.front()),
                           [this](const Edge_division<FT>& edge) { finish_edge(edge); });
    m_are_edges_deferred = false;
    m_faces.forget_waiting();
    for(Face_id f = 0; f < m_faces.size(); ++f)
    {
      if(!is_inactive(f))
        m_due_faces.push_back(f);
      if(m_due_faces.size() == lists_per_batch)
        deactivate_due_faces();
    }
    deactivate_due_faces();
  }

  // Returns the nearest source of each vertex after the end of the propagation, null_id where none arrives.
  std::vector<Vertex_id> owners() { return m_owner.all(); }

  const Mesh& mesh() const { return *m_mesh; }
  Consumer& consumer() { return *m_consumer; }
  const Field& field() const { return *m_field; }
  const Face_windows<FT>& windows() const { return m_windows; }
  std::size_t number_of_kept_windows() const { return m_number_of_kept; }

  // Returns the memory of the windows, of the queue, and of the tables by face and by vertex, in bytes. (Breakpoints
  // and buffers are small beside these, and are not counted.)
  std::size_t memory() const
  {
    return m_windows.memory() + m_faces.memory() + m_owner.memory();
  }

private:
  static constexpr Vertex_id several_sources = null_id - 1;

  // UNTOUCHED: no window has entered. ACTIVE: windows may still enter. INACTIVE: waits for its neighbors and edges.
  // DONE: has released its windows. A face in the queue is ACTIVE. Faces around a source may stay UNTOUCHED until
  // finish().
  enum State : unsigned char { UNTOUCHED, ACTIVE, INACTIVE, DONE };

  struct Face_record : Side_bounds
  {
    // The source of all windows that have entered: null_id before the first one, then one source (the first one of
    // equal ones), or several_sources.
    Vertex_id source = null_id;
    State state = UNTOUCHED;
    unsigned char open_edges = 3; // the number of sides that are not closed yet (close_edge())
  };

  // Notes that windows of a pseudo-source have entered a face. The source known now is the final one: the pseudo-source
  // has emitted, so its distance is final up to rounding, and the propagation rejects improvements within rounding at
  // vertices that may emit. owner() is asked for vertices with final distances only.
  //
  // The parallel propagation emits windows from pseudo-sources whose distance is not final. If it shrinks, they emit
  // again, and their new windows bring the final source to all faces where they are nearest.
  void add_source_of(Vertex_id root, Face_record& record)
  {
    if(record.source == several_sources)
      return;
    add_site(m_owner.first_of_equal(m_owner.source_of(root)), record);
  }

  static void add_site(Vertex_id source, Face_record& record)
  {
    record.source = record.source == null_id || record.source == source ? source : several_sources;
  }

  bool is_inactive(Face_id f) const { return m_faces[f].state == INACTIVE || m_faces[f].state == DONE; }

  static constexpr std::size_t lists_per_batch = 32;

  // Makes the faces of a batch inactive, closes their edges to inactive neighbors, and hands over the faces whose edges
  // are all closed. Each step is a loop of its own: their code does not fit into the instruction cache together.
  void deactivate_due_faces()
  {
    for(const Face_id f : m_due_faces)
      prefetch_neighbors(f);
    for(const Face_id f : m_due_faces)
      deactivate(f);
    m_due_faces.clear();
    for(const std::pair<Halfedge_id, Halfedge_id>& e : m_due_edges)
      close_edge(e.first, e.second);
    m_due_edges.clear();
    finish_closed_faces();
  }

  void finish_closed_faces()
  {
    for(const Face_id f : m_closed_faces)
      finish_face(f);
    m_closed_faces.clear();
  }

  // Fetches what deactivate(f) reads.
  void prefetch_neighbors(Face_id f) const
  {
    const typename Mesh::Face& face = m_mesh->face(f);
    m_windows.prefetch(halfedge_of(f, 0));
    for(unsigned int k = 0; k < 3; ++k)
    {
      m_owner.prefetch(face.vertex[k]);
      if(face.opposite[k] != null_id)
        m_faces.prefetch(face_of(face.opposite[k]));
    }
  }

  // Makes a face inactive (procedure 3 of the thesis), and lets its edges to inactive neighbors be closed. A redundant
  // face releases its windows at once. Its edges are closed all the same, since the neighbors count them. The state
  // comes first: close_edge() reads from it that an edge of a redundant face (DONE) is in one cell.
  void deactivate(Face_id f)
  {
    m_faces[f].state = INACTIVE;
    if(has_one_source(f))
      remove_windows(f);
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k), o = m_mesh->opposite(h);
      if(o == null_id || face_of(o) == f)
        m_due_edges.emplace_back(h, o);
      else if(is_inactive(face_of(o)))
        m_due_edges.emplace_back((std::min)(h, o), (std::max)(h, o));
    }
  }

  Vertex_id owner(Vertex_id v) { return m_owner(v); }

  // Returns whether a face is redundant (definition 5.1): its corners and all windows that have entered have one
  // source. Then all of the face is in one cell, its border too: no shortest path to it comes from elsewhere. (owner()
  // may say the second one of two equal sources, the record always has the first one.)
  bool has_one_source(Face_id f)
  {
    const auto& corner = m_mesh->face(f).vertex;
    const Vertex_id source = owner(corner[0]);
    return owner(corner[1]) == source && owner(corner[2]) == source
        && (m_faces[f].source == null_id || m_faces[f].source == m_owner.first_of_equal(source));
  }

  // Releases the windows of a face.
  void remove_windows(Face_id f)
  {
    m_faces[f].state = DONE;
    for(unsigned int k = 0; k < 3; ++k)
      m_windows.release(halfedge_of(f, k));
  }

  // Closes the edge of h, whose opposite is o or null_id: no face at it will get windows any more. If it may lie in
  // several cells, it is divided first.
  void close_edge(Halfedge_id h, Halfedge_id o)
  {
    if(!m_mesh->is_first_of_edge(h)) // a face that has this edge twice comes here for both halfedges
      return;
    const Face_id f = face_of(h), g = o == null_id ? f : face_of(o);
    if(m_faces[f].state == INACTIVE && m_faces[g].state == INACTIVE) // otherwise the edge is in one cell
      divide_edge(h, o);
    else
      close_sides(h, o);
  }

  void close_sides(Halfedge_id h, Halfedge_id o)
  {
    close_side(face_of(h));
    if(o != null_id)
      close_side(face_of(o));
  }

  // Notes that one more side of a face is closed.
  void close_side(Face_id f)
  {
    if(--m_faces[f].open_edges == 0 && m_faces[f].state == INACTIVE)
      m_closed_faces.push_back(f);
  }

  // Hands a face over if it lies in several cells, and releases its windows. In this order: hand_over() makes images of
  // the windows. Requires: all three edges are closed.
  void finish_face(Face_id f)
  {
    if(is_divided(f))
      hand_over(f);
    remove_windows(f);
  }

  // Returns whether a cell begins or ends on a side of the face. Otherwise all of the face is in one cell, as each
  // piece of a cell touches the border (Face_partition.h). Requires: all three edges are closed.
  bool is_divided(Face_id f) const
  {
    for(unsigned int k = 0; k < 3; ++k)
      if(range_of_edge(halfedge_of(f, k)).size != 0)
        return true;
    return false;
  }

  // Gives a face in several cells to the consumer, with the breakpoints on its sides and its site images.
  // Requires: all three edges are closed, and the windows have not been released.
  void hand_over(Face_id f)
  {
    m_divided_face.face = f;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Index_range range = range_of_edge(halfedge_of(f, k));
      const Edge_breakpoint<FT>* const first = m_breakpoints.data() + range.first;
      m_divided_face.breakpoints[k].assign(first, first + range.size);
    }
    m_divided_face.images.clear();
    for_each_site_image(*m_mesh, *m_field, m_windows, m_strips, [this](Vertex_id v) { return owner(v); }, f,
                        [this](const Site_image<FT>& image) { m_divided_face.images.push_back(image); });
    m_consumer->add(m_divided_face);
  }

  // Returns where the breakpoints of the edge of h are, in the order of its halfedge with the smaller index.
  Index_range range_of_edge(Halfedge_id h) const
  {
    const Index_range* const range = m_range_of_edge.find(m_mesh->is_first_of_edge(h) ? h : m_mesh->opposite(h));
    return range == nullptr ? Index_range{0, 0} : *range;
  }

  static auto dividing_by(Edge_partition<FT>& partition)
  {
    return [&partition](Edge_division<FT>& edge) { edge.divide(partition); };
  }

  // Divides the edge of h, now or by another thread. An edge whose ends have no site, or that has no length, gets a
  // breakpoint only if its ends have different sites: at its source.
  // Requires: h < o, or o is null_id; both faces at the edge are INACTIVE.
  void divide_edge(Halfedge_id h, Halfedge_id o)
  {
    const Vertex_id a = m_mesh->source(h), b = m_mesh->target(h);
    const FT length = m_mesh->length(h);
    const Vertex_id first = owner(a), last = owner(b);
    if(first == null_id || !(length > 0)) // (an edge without length has no inner point)
    {
      if(first != last)
        add_breakpoints(h, {Edge_breakpoint<FT>{FT(0), first, last}});
      return close_sides(h, o);
    }
    Edge_division<FT>& edge = m_are_edges_deferred ? m_waiting_edges.add() : m_edge;
    edge.start(h, o, length, {first, m_field->distance[a]}, {last, m_field->distance[b]});
    add_windows(edge);
    if(m_strips.exist())
      add_strips(edge);
    if(o == null_id)
      add_paths_to_border(edge);
    if(m_are_edges_deferred)
      return;
    edge.divide(m_partition.front());
    finish_edge(edge);
  }

  void add_windows(Edge_division<FT>& edge)
  {
    for_each_side(edge, [&](Halfedge_id h)
    {
      m_windows.for_each_window(h, [&](const Kept_window<FT>& w)
      { edge.add(h, w, m_field->distance[w.root], owner(w.root)); });
    });
  }

  void add_strips(Edge_division<FT>& edge)
  {
    for_each_side(edge, [&](Halfedge_id h)
    {
      m_strips.for_each(h, [&](std::size_t i, const Strip<FT>& s, Vertex_id site) { edge.add(h, i, s, site); });
    });
  }

  // Adds the paths that arrive at a border edge through its face.
  void add_paths_to_border(Edge_division<FT>& edge)
  {
    const Halfedge_id h = edge.halfedge();
    const auto owner_of = [&](Vertex_id v) { return owner(v); };
    for_each_site_image(*m_mesh, *m_field, m_windows, m_strips, owner_of, face_of(h), [&](const Site_image<FT>& g)
    {
      Edge_image<FT> e;
      if(image_on_edge(*m_mesh, h, g, e))
        edge.add(e);
    });
  }

  // Calls visit(h) for the halfedges of an edge that have a face, the one with the smaller index first.
  template <typename Visit>
  static void for_each_side(const Edge_division<FT>& edge, Visit visit)
  {
    visit(edge.halfedge());
    if(edge.opposite() != null_id)
      visit(edge.opposite());
  }

  // Takes over the breakpoints of an edge that has been divided, and removes the windows of both sides that are nearest
  // nowhere.
  void finish_edge(const Edge_division<FT>& edge)
  {
    add_breakpoints(edge.halfedge(), edge.breakpoints());
    for_each_side(edge, [&](Halfedge_id h) { m_windows.release(h); });
    edge.for_each_needed_window([&](Halfedge_id h, const Kept_window<FT>& w) { m_windows.add(h, w); });
    edge.for_each_strip_not_needed([&](std::size_t i) { m_strips.remove(i); });
    close_sides(edge.halfedge(), edge.opposite());
  }

  // Stores the breakpoints of the edge of h.
  void add_breakpoints(Halfedge_id h, const std::vector<Edge_breakpoint<FT>>& found)
  {
    if(found.empty())
      return;
    m_range_of_edge.insert(h, Index_range{static_cast<std::uint32_t>(m_breakpoints.size()),
                                          static_cast<std::uint32_t>(found.size())});
    m_breakpoints.insert(m_breakpoints.end(), found.begin(), found.end());
  }

  const Mesh* m_mesh = nullptr;
  const Field* m_field = nullptr;
  Consumer* m_consumer = nullptr;
  bool m_is_early = true;
  Passed_faces<FT, Face_record> m_faces;
  Vertex_owners<FT> m_owner;
  Face_windows<FT> m_windows; // by the halfedge across which they have entered
  Site_strips<FT> m_strips;
  std::vector<Edge_breakpoint<FT>> m_breakpoints; // of all divided edges, one after the other, until reset()
  Index_table<Index_range> m_range_of_edge; // in m_breakpoints, by the halfedge with the smaller index
  std::size_t m_number_of_kept = 0; // in all, also of those that have been released
  std::size_t m_lists_since_advance = 0; // the number of lists that keep() has got
  // The faces that become inactive in this batch, the edges that they close, and the faces whose edges are all closed.
  std::vector<Face_id> m_due_faces;
  std::vector<std::pair<Halfedge_id, Halfedge_id>> m_due_edges;
  std::vector<Face_id> m_closed_faces;
  bool m_are_edges_deferred = false; // do other threads divide edges?
  Edge_division<FT> m_edge; // the edge that is divided, if this thread does it
  std::vector<Edge_partition<FT>> m_partition = std::vector<Edge_partition<FT>>(1); // by thread
  Work_in_batches<Edge_division<FT>> m_waiting_edges; // those that other threads divide
  Divided_face<FT> m_divided_face;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_REDUNDANT_WINDOW_REMOVAL_H
