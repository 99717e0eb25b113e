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

// The windows that the diagram needs, kept while distances are propagated: window-VTP with redundant window
// removal (thesis, 5.1 and 5.2).
//
// The distance at a point of a face is the smallest one of the windows that entered the face, and of the
// paths from its corners. So windows are kept for the face that they enter, and a face is by itself what the
// thesis asks of a face and its neighbours: if all windows that entered it and its three corners have the
// same source, it is redundant, and its windows are given back (definition 5.1, for the two sides of an edge
// one by one).
//
// A face is inactive (proposition 5.1) when all points of its border have distances below the distance reached
// by the wavefront: no window that comes later can matter in it. A bound of these distances is the smallest
// distance of the windows that enter first, which is taken at some point, plus the longest edge. Another one, often
// smaller, is found edge by edge: a point of the edge AB of length l is not farther than (d(A) + d(B) + l) / 2, and
// where windows cross the edge, it is not farther than by them. Faces wait in a queue by a first guess, and again by
// the bound that is known then (5.2.2).
//
// When the faces on both sides of an edge are inactive, the intervals where its windows are nearest are found (the
// trimming rule of 5.2, for all windows of an edge at once), and those that are so nowhere are removed; the others
// keep their intervals whole. That tells where cells begin and end on the edge.
// Far more faces become redundant then: those that windows of another source
// have entered, but nowhere as the nearest ones. A face that does lie in several cells is given to a consumer
// when all of its edges have been trimmed, and its windows are removed after that.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Radix_heap.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Edge_partition.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Face_windows.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_table.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/site_images_of_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/single_precision.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Breakpoints of an edge: their numbers are first, first + 1, ...
struct Breakpoint_range
{
  std::uint32_t first, size;
};

// The consumer has a member add_divided_face(f), during which the windows of f and the breakpoints of its edges
// are there.
template <typename FT_, typename Consumer_>
class Redundant_window_removal
{
public:
  using FT = FT_;
  using Consumer = Consumer_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // All are referred to. If `is_early` is false, redundant windows are removed in finish() only.
  void reset(const Mesh& mesh, const Field& field, Consumer& consumer, bool is_early = true)
  {
    m_consumer = &consumer;
    m_mesh = &mesh;
    m_field = &field;
    m_is_early = is_early;
    const float unknown = std::numeric_limits<float>::infinity();
    m_faces.assign(mesh.number_of_faces(), Face_record{null_id, UNTOUCHED, 3, {unknown, unknown, unknown}});
    m_source.assign(mesh.number_of_vertices(), Known_source{FT(-1), null_id});
    m_first_of_equal.clear();
    m_windows.reset(mesh.number_of_faces());
    m_breakpoints.clear();
    m_range_of_edge.clear();
    m_queue.clear();
    m_number_of_kept = 0;
  }

  // Two sources that tie everywhere, as far as numbers tell, have one cell: that of `first`, unless it is nowhere the
  // nearest one itself. (Which of them is nearer along an edge would be told by rounding, for each edge anew.)
  void unite(Vertex_id source, Vertex_id first) { m_first_of_equal[source] = first; }

  // is called by the propagation with each list that it carries across h.
  void keep(Halfedge_id h, const Window_list<FT>& list)
  {
    const Face_id f = face_of(h);
    if(is_inactive(f)) // these windows come too late
      return;
    Face_record& record = m_faces[f];
    const auto& columns = list.columns;
    Vertex_id last = null_id; // (neighbours often have the same root)
    m_windows.add(h, list.size, [&](std::size_t i)
    {
      const Vertex_id root = static_cast<Vertex_id>(columns.history()[i]);
      if(root != last)
        add_source_of(root, record);
      last = root;
      return Face_window<FT>{columns.begin()[i], columns.end()[i], columns.image_x()[i], columns.image_depth()[i],
                             root};
    });
    m_number_of_kept += list.size;
    bound_by_windows(h, list);
    if(record.state == ACTIVE)
      return;
    record.state = ACTIVE;
    if(m_is_early)
      wait(f, list);
  }

  // The wavefront has reached a distance: the inactive region grows (thesis, algorithm 4, step 4). A face whose bound
  // is far away is looked at again half-way, as bounds shrink.
  void advance(const FT& reached)
  {
    const FT below = reached * (1 - 16 * Tolerance<FT>::distance());
    m_queue.advance(below, [&](Face_id f, const FT& limit)
    {
      const FT last = (std::min)(limit, bound(f));
      if(last < below)
        deactivate(f);
      else
        m_queue.push(f, last - below < longest_side(m_mesh->face(f)) / 4 ? last : FT(below + (last - below) / 2), last);
    });
  }

  // The propagation has ended: all faces are inactive.
  void finish()
  {
    m_queue.clear();
    for(Face_id f = 0; f < m_faces.size(); ++f)
      if(!is_inactive(f))
        deactivate(f);
  }

  // The nearest source of a vertex whose distance is final; null_id if none reaches it.
  Vertex_id owner(Vertex_id v)
  {
    const Vertex_id source = source_of(v), first = first_of_equal(source);
    return first != source && m_field->is_source(first) ? first : source;
  }

  // where cells begin and end on the edge of h, in the order of the one of its halfedges that has the smaller
  // number.
  Breakpoint_range breakpoints(Halfedge_id h) const
  {
    const Halfedge_id o = m_mesh->opposite(h);
    const Breakpoint_range* const range = m_range_of_edge.find(o != null_id && o < h ? o : h);
    return range == nullptr ? Breakpoint_range{0, 0} : *range;
  }

  const Edge_breakpoint<FT>& breakpoint(std::uint32_t i) const { return m_breakpoints[i]; }

  const Face_windows<FT>& windows() const { return m_windows; }
  std::size_t number_of_kept_windows() const { return m_number_of_kept; }

  std::size_t memory() const
  {
    return m_windows.memory() + m_queue.memory() + m_faces.capacity() * sizeof(Face_record)
         + m_source.capacity() * sizeof(Known_source);
  }

private:
  Vertex_id first_of_equal(Vertex_id source) const
  {
    if(m_first_of_equal.empty())
      return source;
    const auto it = m_first_of_equal.find(source);
    return it != m_first_of_equal.end() ? it->second : source;
  }

  // The source from which a vertex is reached by the distance that it has now.
  struct Known_source
  {
    FT distance;
    Vertex_id vertex;
  };

  bool is_source_known(Vertex_id v) const { return m_source[v].distance == m_field->distance[v]; }

  // null_id if there is none. It is remembered, as the way to it may be long, until the distance shrinks.
  Vertex_id source_of(Vertex_id v)
  {
    Vertex_id last = v;
    while(!is_source_known(last))
    {
      const Vertex_id root = m_field->arrival[last].root;
      if(root == null_id)
        return null_id;
      if(root == last)
        m_source[last] = Known_source{m_field->distance[last], last};
      last = root;
    }
    const Vertex_id source = m_source[last].vertex;
    for(; !is_source_known(v); v = m_field->arrival[v].root)
      m_source[v] = Known_source{m_field->distance[v], source};
    return source;
  }

  static constexpr Vertex_id several_sources = null_id - 1;

  // An INACTIVE face waits for its neighbours, a DONE one has no windows any more.
  enum State : unsigned char { UNTOUCHED, ACTIVE, INACTIVE, DONE };

  // Of equal sources the first one stands for all of them.
  struct Face_record
  {
    Vertex_id source; // of all windows that have entered the face, if it is one
    State state;
    unsigned char open_edges; // whose other side is not inactive
    std::array<float, 3> bound; // of the distances on each edge, by the windows that have crossed it
  };

  // Windows of a pseudo-source have entered a face. (Should it be reached from another source later, by a distance that
  // is clearly less, its windows are made once more, and those that still matter come again.)
  void add_source_of(Vertex_id root, Face_record& record)
  {
    if(record.source == several_sources)
      return;
    const Vertex_id source = first_of_equal(source_of(root));
    record.source = record.source == null_id || record.source == source ? source : several_sources;
  }

  // The first list has entered a face.
  void wait(Face_id f, const Window_list<FT>& list)
  {
    const FT *const at_begin = list.columns.begin_distance(), *const at_end = list.columns.end_distance();
    FT nearest = (std::min)(at_begin[0], at_end[0]);
    for(std::size_t i = 1; i < list.size; ++i)
      nearest = (std::min)({nearest, at_begin[i], at_end[i]});
    const FT longest = longest_side(m_mesh->face(f));
    m_queue.push(f, FT(nearest + longest / 2), FT(nearest + longest));
  }

  // No point of the border of a face has a larger distance.
  FT bound(Face_id f) const
  {
    const typename Mesh::Face& face = m_mesh->face(f);
    FT largest = 0;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const FT by_ends = bound_between(m_field->distance[face.vertex[k]],
                                       m_field->distance[face.vertex[next_corner(k)]], face.length[k]);
      largest = (std::max)(largest, (std::min)(by_ends, FT(m_faces[f].bound[k])));
    }
    return largest;
  }

  // No point between two points on an edge has a larger distance.
  static FT bound_between(const FT& at_first, const FT& at_last, const FT& length)
  {
    return FT((at_first + at_last + length) / 2);
  }

  // takes over what a list tells of the distances on its edge. That of a window is convex: it is nowhere larger than at
  // both ends of the interval.
  void bound_by_windows(Halfedge_id h, const Window_list<FT>& list)
  {
    const auto& columns = list.columns;
    FT bound = 0, x = 0, at_x = m_field->distance[m_mesh->source(h)]; // x is as far as windows have come
    for(std::size_t i = 0; i < list.size; ++i)
    {
      const FT &begin = columns.begin()[i], &end = columns.end()[i];
      const FT &at_begin = columns.begin_distance()[i], &at_end = columns.end_distance()[i];
      if(x < begin)
        bound = (std::max)(bound, bound_between(at_x, at_begin, FT(begin - x)));
      bound = (std::max)({bound, at_begin, at_end});
      if(x < end)
      {
        x = end;
        at_x = at_end;
      }
    }
    const FT& length = m_mesh->length(h);
    if(x < length)
      bound = (std::max)(bound, bound_between(at_x, m_field->distance[m_mesh->target(h)], FT(length - x)));
    float& known = m_faces[face_of(h)].bound[index_in_face(h)];
    known = (std::min)(known, Single_precision::not_less(bound));
    const Halfedge_id o = m_mesh->opposite(h);
    if(o != null_id)
      m_faces[face_of(o)].bound[index_in_face(o)] = known;
  }

  bool is_inactive(Face_id f) const { return m_faces[f].state == INACTIVE || m_faces[f].state == DONE; }

  // procedure 3 of the thesis, for a face that has become inactive.
  void deactivate(Face_id f)
  {
    m_faces[f].state = INACTIVE;
    if(has_one_source(f))
      remove_windows(f);
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k), o = m_mesh->opposite(h);
      if(o == null_id || face_of(o) == f)
        close_edge(h, o);
      else if(is_inactive(face_of(o)))
        close_edge((std::min)(h, o), (std::max)(h, o));
    }
  }

  bool has_one_source(Face_id f)
  {
    const auto& corner = m_mesh->face(f).vertex;
    const Vertex_id source = owner(corner[0]);
    return owner(corner[1]) == source && owner(corner[2]) == source
        && (m_faces[f].source == null_id || m_faces[f].source == first_of_equal(source));
  }

  void remove_windows(Face_id f)
  {
    m_faces[f].state = DONE;
    for(unsigned int k = 0; k < 3; ++k)
      m_windows.release(halfedge_of(f, k));
  }

  // No face at the edge of h, whose opposite is o or null_id, will get windows any more.
  void close_edge(Halfedge_id h, Halfedge_id o)
  {
    if(o != null_id && o < h) // of a face that has this edge twice
      return;
    const Face_id f = face_of(h), g = o == null_id ? f : face_of(o);
    if(m_faces[f].state == INACTIVE && m_faces[g].state == INACTIVE) // else the edge is in one cell
      trim_edge(h, o);
    close_side(f);
    if(o != null_id)
      close_side(g);
  }

  void close_side(Face_id f)
  {
    if(--m_faces[f].open_edges != 0 || m_faces[f].state != INACTIVE)
      return;
    if(is_divided(f))
      m_consumer->add_divided_face(f);
    remove_windows(f);
  }

  bool is_divided(Face_id f) const
  {
    for(unsigned int k = 0; k < 3; ++k)
      if(breakpoints(halfedge_of(f, k)).size != 0)
        return true;
    return false;
  }

  // removes windows of both sides that are nearest nowhere, and finds the breakpoints of the edge.
  void trim_edge(Halfedge_id h, Halfedge_id o)
  {
    const Vertex_id a = m_mesh->source(h), b = m_mesh->target(h);
    const FT length = m_mesh->length(h);
    const Vertex_id first = owner(a), last = owner(b);
    if(first == null_id || !(length > 0)) // (an edge without length has no inner point)
    {
      if(first != last)
        add_breakpoints(h, {Edge_breakpoint<FT>{FT(0), first, last}});
      return;
    }
    m_edge.start(length, first, m_field->distance[a], last, m_field->distance[b]);
    m_candidates.clear();
    m_windows.for_each(h, [&](const Face_window<FT>& w)
    {
      m_candidates.emplace_back(h, w);
      m_edge.add(Edge_image<FT>{w.begin, w.end, w.image_x, w.image_depth,
                                    m_field->distance[w.root], owner(w.root)});
    });
    if(o != null_id)
      m_windows.for_each(o, [&](const Face_window<FT>& w)
      {
        m_candidates.emplace_back(o, w);
        m_edge.add(Edge_image<FT>{FT(length - w.end), FT(length - w.begin),
                                      FT(length - w.image_x), w.image_depth,
                                      m_field->distance[w.root], owner(w.root)});
      });
    if(o == null_id)
      add_paths_to_border(h);
    m_edge.build();
    add_breakpoints(h, m_edge.breakpoints());
    replace_windows(h, o, length);
  }

  void add_breakpoints(Halfedge_id h, const std::vector<Edge_breakpoint<FT>>& found)
  {
    if(found.empty())
      return;
    m_range_of_edge.insert(h, Breakpoint_range{static_cast<std::uint32_t>(m_breakpoints.size()),
                                               static_cast<std::uint32_t>(found.size())});
    m_breakpoints.insert(m_breakpoints.end(), found.begin(), found.end());
  }

  // No window leaves the face at the border: the paths through the face are added as they arrive.
  void add_paths_to_border(Halfedge_id h)
  {
    const auto owner_of = [&](Vertex_id v) { return owner(v); };
    for_each_site_image(*m_mesh, *m_field, m_windows, owner_of, face_of(h), [&](const Site_image<FT>& g)
    {
      Edge_image<FT> e;
      if(image_on_edge(*m_mesh, h, g, e))
        m_edge.add(e);
    });
  }

  // Keeps the windows that are nearest somewhere. All of their intervals are kept: the places where others take over
  // are known up to rounding only, and differ from those on the other edges of a face.
  void replace_windows(Halfedge_id h, Halfedge_id o, const FT& length)
  {
    m_windows.release(h);
    if(o != null_id)
      m_windows.release(o);
    for(std::size_t i = 0; i < m_candidates.size(); ++i)
      if(is_nearest_somewhere(i + 2, length))
        m_windows.add(m_candidates[i].first, m_candidates[i].second);
  }

  // Is a window nearest on a part of its edge? If its image is on the edge itself, it may be so there only.
  bool is_nearest_somewhere(std::size_t window, const FT& length) const
  {
    const Edge_image<FT>& g = m_edge.image(window);
    const FT foot = (std::min)((std::max)(g.image_x, g.begin), g.end);
    const bool is_on_edge = g.depth <= Tolerance<FT>::closeness() * length;
    const std::vector<Edge_interval<FT>>& intervals = m_edge.intervals();
    const auto ends_before = [](const Edge_interval<FT>& i, const FT& x) { return i.end < x; };
    for(auto it = std::lower_bound(intervals.begin(), intervals.end(), g.begin, ends_before);
        it != intervals.end() && it->begin <= g.end; ++it)
    {
      const Edge_interval<FT>& i = *it;
      const FT first = (std::max)(g.begin, i.begin), last = (std::min)(g.end, i.end);
      if((first < last && is_nearest(window, i.image, first + (last - first) / 2))
         || (is_on_edge && i.begin <= foot && foot <= i.end && ties(window, i.image, foot)))
        return true;
    }
    return false;
  }

  // Is a window nearest at x? `nearest` is the image that is so.
  //
  // A path that runs along the edge may cross it or not, as far as numbers tell, so that a window ties with one that
  // leaves its face. Each of them is kept for the face that it enters: the other one comes to that face by another
  // edge, where it may have been removed because of this one. Of the windows of one side that tie one is enough.
  bool is_nearest(std::size_t window, std::size_t nearest, const FT& x) const
  {
    if(window == nearest)
      return true;
    if(nearest < 2) // a corner of both faces
      return false;
    if(nearest - 2 < m_candidates.size() && m_candidates[nearest - 2].first == m_candidates[window - 2].first)
      return false;
    return ties(window, nearest, x);
  }

  bool ties(std::size_t window, std::size_t nearest, const FT& x) const
  {
    const FT d = m_edge.image(nearest).distance_at(x);
    return m_edge.image(window).distance_at(x) <= d + Tolerance<FT>::tie() * d;
  }

  const Mesh* m_mesh = nullptr;
  const Field* m_field = nullptr;
  Consumer* m_consumer = nullptr;
  bool m_is_early = true;
  std::vector<Face_record> m_faces;
  std::vector<Known_source> m_source; // by vertex
  std::unordered_map<Vertex_id, Vertex_id> m_first_of_equal;
  Face_windows<FT> m_windows;
  std::vector<Edge_breakpoint<FT>> m_breakpoints;
  Index_table<Breakpoint_range> m_range_of_edge;
  Radix_heap m_queue;
  std::size_t m_number_of_kept = 0;
  Edge_partition<FT> m_edge;
  std::vector<std::pair<Halfedge_id, Face_window<FT>>> m_candidates;
};

// A keeper for Distance_propagation.
template <typename Removal>
class Redundant_window_remover
{
public:
  using FT = typename Removal::FT;

  explicit Redundant_window_remover(Removal& removal) : m_removal(&removal) {}

  void keep(Halfedge_id h, const Window_list<FT>& list) { m_removal->keep(h, list); }
  void advance(const FT& reached) { m_removal->advance(reached); }

private:
  Removal* m_removal;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_REDUNDANT_WINDOW_REMOVAL_H
