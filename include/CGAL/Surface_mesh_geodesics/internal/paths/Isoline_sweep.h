// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_SWEEP_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_SWEEP_H

// Traces the isolines of given distances, the levels, while distances are propagated. Windows are kept in a band along
// the wavefront only: as soon as the wavefront has passed a face, its part of the lines is found, and its windows are
// released. So the lines take little more memory than distances alone.
//
// *Which windows are kept.* Those of a list that enters a face may matter for the levels that are not nearer than the
// list and not farther than the face: without such a level the list is not kept. At the levels that are looked at later
// the distances that are found without it are on the same side of the level as the right ones, so that the lines are
// the same.
//
// *Strips.* From curves, distances come through strips as well. They are kept and released like windows; their smallest
// distance is at an end, so what is said of lists of windows holds for each of them alone. `Strips` is the field that
// keeps them, Edge_strip_field, or No_strip_field for sources that are points.
//
// *Passed faces.* When the wavefront has passed a face, no later window can change anything in it (Passed_faces.h).
// Then the points on those of its edges are found whose first halfedge it has. When the points on all of its edges are
// known, they are connected in it. Faces without windows that matter do not wait for the wavefront. They are few of
// those that lines cross, such as faces around sources, and are looked at in the end.
//
// *Bits.* Windows that come after a face has been passed are nearest nowhere in it, up to rounding. So the distances
// that decide about points are those that all windows give, up to the last digits, and the lines are those of
// Isoline_tracer.
//
// *Corners.* Whether an edge is crossed must be decided alike in both of its faces, but they are passed at different
// times. The distance of a vertex is read once, when the first face around it is passed, and does not change for the
// lines then, whatever rounding does to it.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Face_distances.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Isoline_graph.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/isoline_crossings.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Face_windows.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/Passed_faces.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/entering_windows.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// What a Deferred_window_keeper calls. In the propagation, keep() and advance() are called in turn, then finish(), then
// for_each_line(). One thread at a time may call an object. It reads the mesh and the distances, and writes neither.
//
// Invariants:
// - The state of a face only grows (State). Windows are kept for ACTIVE and PASSED faces only.
// - open_edges of a PASSED face counts the sides that may have points which have not been looked for, because the face
//   of the first halfedge of the edge has not been passed. It is connected when it has no open edges.
template <typename FT_, typename Strips = No_strip_field>
class Isoline_sweep
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;
  using Point = Isoline_point<FT>;

  // Starts anew. Mesh and field are referred to: the mesh, refined by the sources, and the field into which the
  // propagation writes. The levels are in the unit of the mesh. A point of a line errs by at most `resolution` times
  // the length of its edge, beyond the error of distances. Takes time linear in the size of the mesh.
  // Requires: the levels ascend and are positive and finite; resolution > 0.
  void reset(const Mesh& mesh, const Field& field, std::vector<FT> levels, const FT& resolution)
  {
    CGAL_assertion(std::is_sorted(levels.begin(), levels.end()));
    m_mesh = &mesh;
    m_field = &field;
    m_levels = std::move(levels);
    std::transform(m_levels.begin(), m_levels.end(), m_levels.begin(), dividing_value<FT>);
    m_resolution = resolution;
    m_faces.reset(mesh, field, Face_record());
    m_windows.reset(mesh.number_of_faces());
    m_strips.reset(mesh.number_of_faces());
    m_corner_distance.assign(mesh.number_of_vertices(), Field::infinity());
    m_graph.reset(mesh);
    m_lists_since_advance = 0;
    m_due_faces.clear();
    m_closed_faces.clear();
  }

  const Mesh& mesh() const { return *m_mesh; }
  const Field& field() const { return *m_field; }

  // Keeps the windows of a list that the propagation carries across h into the face of h, if they may matter for a
  // line. The list is copied. Requires: it is not empty.
  void keep(Halfedge_id h, const Window_list<FT>& list)
  {
    CGAL_expensive_assertion(are_on_edge(list, m_mesh->length(h)));
    keep(h, list.size, [&](std::size_t i) { return kept_window(list, i); },
         [] { return Field::infinity(); }, [&] { return smallest_distance(list); });
  }

  // The same for a list of n windows that is known by window(i) and by smallest(), which is smallest_distance(). A
  // bound for the edge is not needed.
  template <typename Window_at, typename Bound, typename Smallest>
  void keep(Halfedge_id h, std::size_t n, Window_at window, Bound, Smallest smallest)
  {
    const Face_id f = face_of(h);
    Face_record& record = m_faces[f];
    if(record.state >= PASSED)
      return;
    const FT nearest = smallest();
    if(!may_matter(f, nearest))
      return;
    m_windows.add(h, n, window);
    activate(f, nearest);
  }

  // The same for a strip that is carried across h. Requires: Strips::exist.
  void keep(Halfedge_id h, const Strip<FT>& s)
  {
    const Face_id f = face_of(h);
    const FT nearest = s.minimum_distance();
    if(m_faces[f].state >= PASSED || !may_matter(f, nearest))
      return;
    m_strips.keep(h, s);
    activate(f, nearest);
  }

  // Nothing here depends on distances that are not final: a face is passed when those around it are.
  void set_final_distance(const FT&) {}

  // Finds the points of lines in the faces that the wavefront has passed, as it has reached a distance. Nothing happens
  // before enough lists have been kept, so that the caches serve a batch of faces.
  // Requires: distances below `reached` are final, and windows with paths that short have been kept.
  //
  // A corner that has no final distance then is one that rounding has hidden from the wavefront; finish() looks at its
  // faces.
  void advance(const FT& reached)
  {
    if(m_lists_since_advance < lists_per_batch)
      return;
    m_lists_since_advance = 0;
    m_faces.advance(reached, [&](Face_id f)
    {
      const std::array<Vertex_id, 3>& corner = m_mesh->face(f).vertex;
      if(std::all_of(corner.begin(), corner.end(), [&](Vertex_id v) { return m_field->distance[v] < reached; }))
        m_due_faces.push_back(f);
    });
    pass_due_faces();
  }

  // Looks at all other faces, as the propagation has ended. Only the lines, which are complete, have memory then.
  void finish()
  {
    m_faces.forget_waiting();
    for(Face_id f = 0; f < m_faces.size(); ++f)
      if(m_faces[f].state == ACTIVE || (m_faces[f].state == UNTOUCHED && may_hold_level(f)))
        m_due_faces.push_back(f);
    pass_due_faces();
    m_windows.clear();
    m_strips.clear();
    m_faces.clear();
    m_corner_distance = std::vector<FT>();
    m_graph.sort();
  }

  // Calls line(points, is_closed) for each line of a level, as Isoline_graph does. Requires: finish() was called.
  template <typename Line>
  void for_each_line(std::size_t level, Line& line) const
  {
    m_graph.for_each_line(static_cast<std::uint32_t>(level), line);
  }

  // The memory of windows and strips, of points, and of the tables by face and by vertex, in bytes.
  std::size_t memory() const
  {
    return m_windows.memory() + m_strips.memory() + m_faces.memory() + m_graph.memory()
         + m_corner_distance.capacity() * sizeof(FT);
  }

  // The number of windows that are kept now, and its maximum since reset().
  const Face_windows<FT>& windows() const { return m_windows; }

private:
  // UNTOUCHED: no window that matters has entered. ACTIVE: waits for the wavefront to pass. PASSED: waits for points on
  // its edges. DONE: has released its windows.
  enum State : unsigned char { UNTOUCHED, ACTIVE, PASSED, DONE };

  struct Face_record
  {
    State state = UNTOUCHED;
    unsigned char open_edges = 0;
  };

  static constexpr std::size_t lists_per_batch = 32;

  // Lets a face wait for the wavefront when the first list enters it, whose nearest point is at this distance.
  void activate(Face_id f, const FT& nearest)
  {
    ++m_lists_since_advance;
    if(m_faces[f].state == ACTIVE)
      return;
    m_faces[f].state = ACTIVE;
    m_faces.wait(f, nearest);
  }

  // May a list matter whose windows have at least this distance at their ends? Between the ends it is smaller by at
  // most half of the edge. No corner of the face is farther than `nearest` plus the longest side, by the path through
  // the list, and no point of an edge farther than its ends by more than half of it: may_hold_isoline() looks for no
  // level beyond. An eighth of the longest side, and the error of images, are for rounding.
  bool may_matter(Face_id f, const FT& nearest) const
  {
    const FT longest = longest_side(m_mesh->face(f)), margin = longest / 8 + nearest * Tolerance<FT>::succession();
    const auto level = std::lower_bound(m_levels.begin(), m_levels.end(), FT(nearest - longest / 2 - margin));
    return level != m_levels.end() && *level <= nearest + longest + longest / 2 + margin;
  }

  // May an edge of a face hold a level? On an edge no distance differs by more than half of its length from one of its
  // ends.
  bool may_hold_level(Face_id f) const
  {
    const typename Mesh::Face& face = m_mesh->face(f);
    const auto [nearest, farthest] = std::minmax({m_field->distance[face.vertex[0]], m_field->distance[face.vertex[1]],
                                                  m_field->distance[face.vertex[2]]});
    const FT longest = longest_side(face);
    const auto level = std::lower_bound(m_levels.begin(), m_levels.end(), FT(nearest - longest));
    return level != m_levels.end() && *level <= farthest + longest;
  }

  // The distance of a vertex as all faces around it see it.
  const FT& corner_distance(Vertex_id v)
  {
    FT& d = m_corner_distance[v];
    if(!(d < Field::infinity()))
      d = m_field->distance[v];
    return d;
  }

  // Calls visit(number, level) for the levels that the edge of h may hold. These follow each other.
  template <typename Visit>
  void for_each_level(Halfedge_id h, Visit visit)
  {
    const FT length = m_mesh->length(h), d = corner_distance(m_mesh->source(h)),
             e = corner_distance(m_mesh->target(h));
    const FT nearest = (std::min)({d, e, FT((d + e - length) / 2)});
    for(auto it = std::upper_bound(m_levels.begin(), m_levels.end(), nearest);
        it != m_levels.end() && may_hold_isoline(length, d, e, *it); ++it)
      visit(static_cast<std::uint32_t>(it - m_levels.begin()), *it);
  }

  bool may_hold_level_on_edge(Halfedge_id h)
  {
    bool holds = false;
    for_each_level(h, [&](std::uint32_t, const FT&) { holds = true; });
    return holds;
  }

  // Finds the points on the edges of faces that have been passed, and connects the faces whose edges are all closed.
  void pass_due_faces()
  {
    for(const Face_id f : m_due_faces)
      pass(f);
    m_due_faces.clear();
    for(const Face_id f : m_closed_faces)
      connect(f);
    m_closed_faces.clear();
  }

  // A face without lines needs its windows no more. One with lines keeps them until the points on all of its edges are
  // known: connect() may ask for a distance.
  void pass(Face_id f)
  {
    Face_record& record = m_faces[f];
    record.state = PASSED;
    m_has_started = false;
    bool has_lines = false;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k), o = m_mesh->opposite(h);
      const bool is_first = m_mesh->is_first_of_edge(h);
      if(!may_hold_level_on_edge(is_first ? h : o))
        continue;
      has_lines |= !is_first || find_points(h);
      if(o != null_id && face_of(o) != f)
        is_first ? close_side(face_of(o)) : wait_for_side(f, face_of(o));
    }
    if(!has_lines)
      release(f);
    else if(record.open_edges == 0)
      m_closed_faces.push_back(f);
  }

  // Lets a face that is passed wait for its neighbor, whose edge it is, unless that has been passed.
  void wait_for_side(Face_id f, Face_id neighbor)
  {
    if(m_faces[neighbor].state < PASSED)
      ++m_faces[f].open_edges;
  }

  // Notes that the neighbor of a face has found the points on one of its sides. A face that is not passed has counted
  // nothing.
  void close_side(Face_id f)
  {
    if(m_faces[f].state == PASSED && --m_faces[f].open_edges == 0)
      m_closed_faces.push_back(f);
  }

  // Finds the points on the edge of h, whose first halfedge it is. Returns whether there are any.
  bool find_points(Halfedge_id h)
  {
    m_graph.begin_edge(h);
    for_each_level(h, [&](std::uint32_t level, const FT& value)
    {
      start(face_of(h));
      m_distances.start_edge(h);
      const auto add = [&](const FT& t) { m_graph.add(level, t); };
      Isoline_crossings<FT, Face_distances<FT, Strips>>(m_mesh->length(h), value, m_resolution, m_distances)
        .find(FT(0), corner_distance(m_mesh->source(h)), FT(1), corner_distance(m_mesh->target(h)), add);
    });
    return m_graph.end_edge();
  }

  // Joins the points around a face in all levels that its edges may hold. Requires: all edges are closed.
  void connect(Face_id f)
  {
    m_has_started = false;
    std::size_t first = m_levels.size(), last = 0;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k);
      for_each_level(m_mesh->is_first_of_edge(h) ? h : m_mesh->opposite(h), [&](std::uint32_t level, const FT&)
      {
        first = (std::min)(first, std::size_t(level));
        last = (std::max)(last, std::size_t(level));
      });
    }
    for(std::size_t i = first; i <= last; ++i)
      m_graph.connect(f, static_cast<std::uint32_t>(i), corner_distance(m_mesh->face(f).vertex[0]) < m_levels[i],
                      [&](const std::array<FT, 3>& b)
      {
        start(f);
        return m_distances.at(b) < m_levels[i];
      });
    release(f);
  }

  // Reads what the distances in a face are made of, unless pass() or connect() has done so for this face.
  void start(Face_id f)
  {
    if(!m_has_started)
      m_distances.start(*m_mesh, *m_field, m_windows, m_strips, f);
    m_has_started = true;
  }

  // No windows and strips of the face are needed any more, and keep() rejects those that come.
  void release(Face_id f)
  {
    m_faces[f].state = DONE;
    for(unsigned int k = 0; k < 3; ++k)
    {
      m_windows.release(halfedge_of(f, k));
      m_strips.release(halfedge_of(f, k));
    }
  }

  const Mesh* m_mesh = nullptr;
  const Field* m_field = nullptr;
  std::vector<FT> m_levels; // the dividing_value() of each
  FT m_resolution = 0;
  Passed_faces<FT, Face_record> m_faces;
  Face_windows<FT> m_windows; // by the halfedge across which they have entered
  Strips m_strips;            // the same
  std::vector<FT> m_corner_distance; // by vertex; infinity as long as no face around it has been passed
  Isoline_graph<FT> m_graph;
  std::size_t m_lists_since_advance = 0;
  std::vector<Face_id> m_due_faces, m_closed_faces; // of this batch: those to be passed, and to be connected
  Face_distances<FT, Strips> m_distances; // of the face that is passed or connected, once it is needed
  bool m_has_started = false;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_ISOLINE_SWEEP_H
