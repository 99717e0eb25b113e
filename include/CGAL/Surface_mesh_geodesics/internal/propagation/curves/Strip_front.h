// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_STRIP_FRONT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_STRIP_FRONT_H

// All strips that wait, and how they cross the star of a vertex. Strips wait on halfedges, in lists, as windows do.
// When a vertex is visited (Distance_propagation.h), all strips that wait around it turn around it: they cross one face
// after the other, are trimmed by the ends of each edge, improve the apex of each face, and leave the star in the end.
// They wait on the edges of the link then, and the nearer end of each edge is queued. So strips need no queue of their
// own, and those that reach an edge from several sides cross it together.
//
// Why these lists are not those of windows: strips have no order by keys, and no rule for pairs needs one. Of two
// strips on one edge, both are kept until vertices trim them.
//
// Splitting at the apex. Let the best path to C that is known come straight through the point S of AB, with the length
// d(C), and let D(C) be the value of the linear function of a strip at C. If D(C) >= d(C), no ray that crosses the
// segment SC is needed beyond it: at the crossing Q, D(Q) >= D(C) - |QC| >= d(C) - |QC| = d(Q), as D grows by at most
// |QC|. So only rays on the left of S go on to the left edge, and only rays on its right to the right edge. This
// compares a strip with a path of any kind, and needs no order. Ties keep the strip.
//
// Source edges stop strips. Where a ray meets a source edge, the curve there is as near by its own offset. A strip that
// is nowhere nearer than that, up to the rounding of two distances, goes no farther. So it stops in a tie, too: of two
// curves at just the distance by which their offsets differ, all rays would tie in an area, and the edges of a diagram
// would choose among them one by one.
//
// Time goes into memory, not into arithmetic: a list has been put long before it crosses, and is in no cache then. So
// lists lie in a pool (Strip_pool.h), all those around a vertex are fetched before the first one crosses, and strips
// that go on around the vertex stay where they are, in columns (Strip_columns.h).

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Vertex_star.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_halfedges.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Vertex_rival.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_list_loops.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip_columns.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip_list_loops.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip_pool.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The bound on the faces that a shortest path crosses (Intrinsic_mesh::most_faces_crossed()) holds for strips as well:
// a shortest path from a curve is a shortest path from its foot.
//
// The policy of a propagation with curves among its sources; No_strips (Distance_propagation.h) is that without.
//
// Invariants, between calls: of each halfedge on which strips wait, an end is in the queue of the propagation, with a
// key that is not greater than the distance of any of them. m_slot tells their lists, m_free the other places of
// m_lists. m_halfedge has at least as many places as m_lists.
//
// `Kept` is what keeps the strips that cross faces: keep(halfedge, strip) is called for each.
template <typename FT, typename Kept = Edge_strip_field<FT>>
class Strip_front
{
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

public:
  static constexpr bool exist = true;

  // Both must outlive this object.
  Strip_front(const Mesh& mesh, const Field& field, Lane_choice lanes = Lane_choice::BEST)
    : m_mesh(mesh), m_field(field), m_loops(lanes, strip_list_loops<FT>)
  {
    restart();
  }

  // Removes all strips. The mesh may have changed since. Linear in the number of source edges, in that of halfedges on
  // which strips have waited at the same time, and in that of vertices and faces that are new.
  void restart()
  {
    // (Lists know their halfedges, so only the slots of these are cleared.)
    m_free.clear();
    for(std::uint32_t i = 0; i < m_lists.size(); ++i)
    {
      if(m_halfedge[i] != null_id)
        slot(m_halfedge[i]) = null_id;
      m_halfedge[i] = null_id;
      m_pool.release(m_lists[i]);
      m_free.push_back(i);
    }
    m_slot.resize(3 * m_mesh.number_of_faces(), null_id);
    m_source_halfedges.for_each_halfedge([&](Halfedge_id h) { m_is_source[dense_index(h)] = false; });
    m_source_halfedges.clear();
    m_is_source.resize(3 * m_mesh.number_of_faces(), false);
    m_foot.resize(m_mesh.number_of_vertices());
    m_maximum_distance = Field::infinity();
    m_number_crossed = m_number_created = 0;
  }

  // Distances of vertices need no strip any more when it has crossed its face; distances of other points do.
  //
  // Keeps the strips that cross faces from now on, for queries or for isolines; `kept` must be reset for the mesh, and
  // outlive the run. Null keeps none.
  void keep_in(Kept* kept) { m_kept = kept; }

  // Drops strips that are farther away. Requires: d >= 0.
  void set_maximum_distance(const FT& d) { m_maximum_distance = d; }

  // Lets strips start at all edges. Vertices of curves are sources; when they are visited, they emit windows between
  // the normals of the curves (Sector_between_normals.h). All of them have their distances before any strip starts, so
  // that strips know them as rivals at once.
  template <typename Wave, typename Push>
  void start(const Source_curves<FT>& curves, Wave& wavefront, Push push)
  {
    for(const Source_vertex<FT>& v : curves.vertices)
      wavefront.add_source(v.vertex, v.offset, push);
    for(std::uint32_t i = 0; i < curves.edges.size(); ++i)
    {
      const Source_edge<FT>& e = curves.edges[i];
      add_first_strip(e.left, e.offset, 2 * i, push);
      add_first_strip(e.right, e.offset, 2 * i + 1, push);
    }
    m_source_halfedges.set(curves.edges);
    m_source_halfedges.for_each_halfedge([&](Halfedge_id h) { m_is_source[dense_index(h)] = true; });
  }

  // Does no strip wait? With points among the sources, or curves that reach little, most of a run goes on without any.
  bool empty() const { return m_free.size() == m_lists.size(); }

  // Lets all strips that wait around the vertex of a star cross its faces, until they leave it. Improves the distances
  // of the field at once: the star takes them over afterward (Wavefront::take()). Returns whether a strip has improved
  // a vertex that had emitted windows. Takes time linear in the degree of the vertex and in the number of crossings.
  // Requires: star.surround() was called.
  template <typename Wave, typename Push>
  bool cross_star(const Vertex_star<FT>& star, Wave& wavefront, Push push)
  {
    if(empty())
      return false;
    prefetch_lists(star);
    bool are_windows_stale = false;
    for(const Star_face<FT>& f : star.faces)
      if(slot(f.halfedge) != null_id)
        are_windows_stale |= turn<true>(f.halfedge, wavefront, push);
    for(auto f = star.faces.rbegin(); f != star.faces.rend(); ++f)
      if(slot(previous_halfedge(f->halfedge)) != null_id)
        are_windows_stale |= turn<false>(previous_halfedge(f->halfedge), wavefront, push);
    return are_windows_stale;
  }

  // Fetches what tells where the lists around a vertex are; useful before a visit of the vertex.
  void prefetch_star(Vertex_id v) const
  {
    if(!empty() && m_mesh.has_star(v))
      for(const Halfedge_id* h = m_mesh.star_begin(v); h != m_mesh.star_end(v); ++h)
        prefetch(&slot(*h));
  }

  // Where a strip last improved a vertex: the foot of that path. It counts for vertices that are their own roots, but
  // no sources: only then a strip has reached them last.
  // (The field of distances has no room for it: propagations from points would pay for that.)
  const Strip_foot<FT>& foot(Vertex_id v) const { return m_foot[v]; }

  // The same of all vertices, for results that outlive the run: paths are traced when the propagation is gone.
  const std::vector<Strip_foot<FT>>& feet() const { return m_foot; }

  std::size_t number_crossed() const { return m_number_crossed; }
  std::size_t number_created() const { return m_number_created; }

  std::size_t memory() const
  {
    return m_pool.memory() + m_lists.capacity() * (sizeof(List) + sizeof(Halfedge_id) + sizeof(std::uint32_t))
         + m_crossing.memory() + m_children.memory();
  }

  // Bytes of the tables that have an entry for each vertex or halfedge of the mesh, or for each source edge.
  std::size_t table_memory() const
  {
    return m_foot.capacity() * sizeof(Strip_foot<FT>) + m_slot.capacity() * sizeof(std::uint32_t)
         + m_is_source.capacity() / 8 + m_source_halfedges.memory();
  }

private:
  using List = Strip_list<FT>;
  using Cross = Strip_children<FT> (*)(Strip_columns<FT>&, std::size_t, const Strip_side<FT>&, Strip_columns<FT>&);

  // Fetches the lists that wait around the vertex of a star.
  void prefetch_lists(const Vertex_star<FT>& star) const
  {
    const auto for_each_slot = [&](auto visit)
    {
      for(const Star_face<FT>& f : star.faces)
        for(const Halfedge_id h : {f.halfedge, previous_halfedge(f.halfedge)})
          if(slot(h) != null_id)
            visit(slot(h));
    };
    for_each_slot([&](std::uint32_t i) { prefetch(&m_lists[i]); });
    for_each_slot([&](std::uint32_t i)
    {
      for(std::size_t k = 0; k < (std::min)(most_strips_to_fetch, std::size_t(m_lists[i].size)); ++k)
        prefetch(m_lists[i].strips + k);
    });
  }

  std::uint32_t& slot(Halfedge_id h) { return m_slot[dense_index(h)]; }
  const std::uint32_t& slot(Halfedge_id h) const { return m_slot[dense_index(h)]; }

  // The path to a vertex as a rival of strips. Degenerate vertices win ties, as against windows: in faces without
  // extent strips would go around forever.
  Vertex_rival<FT> rival(Vertex_id v) const
  {
    return Vertex_rival<FT>(m_field.distance[v], m_mesh.has(v, Mesh::DEGENERATE));
  }

  // Adds the strip of a whole source edge, on one side of it. Its rays are perpendicular to the edge, and its function
  // is constant. Does nothing at the border, and for an edge without length, whose ends are sources anyway.
  template <typename Push>
  void add_first_strip(Halfedge_id h, const FT& offset, std::uint32_t side, Push push)
  {
    if(h == null_id || !(m_mesh.length(h) > 0) || offset > m_maximum_distance)
      return;
    List& strips = list(h);
    m_pool.reserve(strips, 1);
    strips.strips[strips.size++] = Strip<FT>{FT(0), m_mesh.length(h), FT(0), FT(1), offset, FT(0), side, 0};
    ++m_number_created;
    push_nearer(m_mesh.source(h), m_mesh.target(h), offset, push);
  }

  // Lets the strips of a halfedge turn around a vertex, its origin (counterclockwise) or its target (clockwise): the
  // strips cross one face after the other, and those of each halfedge on the way join them. Others leave the star and
  // wait there. Ends when no strip goes on. Requires: strips wait on h.
  template <bool is_counterclockwise, typename Wave, typename Push>
  bool turn(Halfedge_id h, Wave& wavefront, Push push)
  {
    bool are_windows_stale = false;
    m_most_faces_crossed = 0;
    for(std::size_t n = take(h, 0); n != 0;)
    {
      const Face_frame<FT> c = m_mesh.face_frame(h);
      are_windows_stale |= enter(h, c, n, wavefront, push);
      const FT known = known_path_to_apex(h, c);
      if(is_counterclockwise)
      {
        leave(c.right, children_on_right(n, c, known), c.apex, c.target, push);
        n = children_on_left(n, c, known).number;
      }
      else
      {
        leave(c.left, children_on_left(n, c, known), c.origin, c.apex, push);
        n = children_on_right(n, c, known).number;
      }
      std::swap(m_crossing, m_children);
      h = is_counterclockwise ? c.left : c.right;
      ++m_most_faces_crossed;
      if(h != null_id && slot(h) != null_id)
        n += take(h, n);
    }
    return are_windows_stale;
  }

  // Lets n strips enter the face of h: trims them, keeps them for queries, and improves the apex. Sets n to the number
  // of those that are left. Returns whether the apex had emitted windows before it was improved.
  template <typename Wave, typename Push>
  bool enter(Halfedge_id h, const Face_frame<FT>& c, std::size_t& n, Wave& wavefront, Push push)
  {
    // Vertices may have become nearer since the strips were added.
    const Entered_strips<FT> entered = m_loops(n).enter(m_crossing, n, c, rival(c.origin), rival(c.target));
    m_number_crossed += entered.number;
    keep_for_queries(h, entered.number);
    const bool are_windows_stale = entered.shortest_path_to_apex < m_field.distance[c.apex]
                                && improve_apex(nearest_strip(entered), h, c, wavefront, push);
    n = leave_out_oldest(entered.number);
    return are_windows_stale;
  }

  // The list of a halfedge, which is made if there is none. The reference is valid until the next list is made.
  List& list(Halfedge_id h)
  {
    if(slot(h) == null_id)
    {
      if(m_free.empty())
      {
        m_halfedge.push_back(null_id);
        m_lists.emplace_back();
        m_free.push_back(static_cast<std::uint32_t>(m_lists.size() - 1));
      }
      slot(h) = m_free.back();
      m_halfedge[m_free.back()] = h;
      m_free.pop_back();
    }
    return m_lists[slot(h)];
  }

  // Moves the strips of a halfedge to m_crossing, behind n strips that are there, and returns their number. Their list
  // is free then: a child of one of them may need it, on a face that is glued to itself. Requires: strips wait on h.
  std::size_t take(Halfedge_id h, std::size_t n)
  {
    List& list_of_h = m_lists[slot(h)];
    const Strip<FT>* const strips = list_of_h.strips;
    const std::size_t size = list_of_h.size;
    m_crossing.reserve(n + size, n);
    for(std::size_t i = 0; i < size; ++i)
    {
      m_crossing.set(n + i, strips[i]);
      m_most_faces_crossed = (std::max)(m_most_faces_crossed, strips[i].faces_crossed);
    }
    m_pool.release(list_of_h);
    m_free.push_back(slot(h));
    m_halfedge[slot(h)] = null_id;
    slot(h) = null_id;
    return size;
  }

  // Also keeps slivers, which go no farther: points of this face may lie on their rays.
  void keep_for_queries(Halfedge_id h, std::size_t n)
  {
    if(m_kept != nullptr)
      for(std::size_t i = 0; i < n; ++i)
        m_kept->keep(h, m_crossing.get(i));
  }

  // Leaves those of n strips out that have crossed as many faces as a shortest path may. Returns how many are left.
  std::size_t leave_out_oldest(std::size_t n)
  {
    const std::size_t most_faces = m_mesh.most_faces_crossed();
    if(m_most_faces_crossed < most_faces)
      return n;
    std::size_t end = 0;
    for(std::size_t i = 0; i < n; ++i)
      if(m_crossing.get(i).faces_crossed < most_faces)
        m_crossing.copy_row(i, end++);
    return end;
  }

  // What is known of the apex when all strips have improved it: the length of the path, if it enters the face across h;
  // a path across another edge decides nothing. It is enlarged by the error of distances, so that ties keep the strip.
  FT known_path_to_apex(Halfedge_id h, const Face_frame<FT>& c) const
  {
    return m_field.arrival[c.apex].halfedge == h ? FT(m_field.distance[c.apex] / (1 - Tolerance<FT>::distance()))
                                                 : Field::infinity();
  }

  // Make the children of n strips beyond a side of the face, in m_children; none at the border, and none beyond a side
  // without length.
  Strip_children<FT> children_on_left(std::size_t n, const Face_frame<FT>& c, const FT& known)
  {
    if(c.left == null_id || !(c.left_length > 0))
      return {0, Field::infinity()};
    return make_children(n, c.left, {c.left_length, left_angle(c), rival(c.origin), rival(c.apex), c.length,
                                     m_field.arrival[c.apex].abscissa, known, m_maximum_distance},
                         &Strip_list_loops<FT>::cross_left);
  }

  Strip_children<FT> children_on_right(std::size_t n, const Face_frame<FT>& c, const FT& known)
  {
    if(c.right == null_id || !(c.right_length > 0))
      return {0, Field::infinity()};
    return make_children(n, c.right, {c.right_length, right_angle(c), rival(c.apex), rival(c.target), c.length,
                                      m_field.arrival[c.apex].abscissa, known, m_maximum_distance},
                         &Strip_list_loops<FT>::cross_right);
  }

  Strip_children<FT> make_children(std::size_t n, Halfedge_id h, const Strip_side<FT>& side,
                                   Cross Strip_list_loops<FT>::*loop)
  {
    if(n == 0)
      return {0, Field::infinity()};
    m_children.reserve(n, 0);
    Strip_children<FT> children = (m_loops(n).*loop)(m_crossing, n, side, m_children);
    if(m_is_source[dense_index(h)])
      children = nearer_than(*m_source_halfedges.offset(h), children);
    m_number_created += children.number;
    return children;
  }

  // Leaves those children out that are nowhere nearer than the source edge on which they wait, which has this offset.
  Strip_children<FT> nearer_than(const FT& offset, const Strip_children<FT>& children)
  {
    Strip_children<FT> result{0, Field::infinity()};
    for(std::size_t i = 0; i < children.number; ++i)
    {
      const FT least = m_children.get(i).minimum_distance();
      if(!is_clearly_less(least, offset))
        continue;
      m_children.copy_row(i, result.number++);
      result.least_distance = (std::min)(result.least_distance, least);
    }
    return result;
  }

  // Lets the children beyond a side from a to b wait there.
  template <typename Push>
  void leave(Halfedge_id h, const Strip_children<FT>& children, Vertex_id a, Vertex_id b, Push push)
  {
    if(children.number == 0)
      return;
    List& strips = list(h);
    m_pool.reserve(strips, children.number);
    for(std::size_t i = 0; i < children.number; ++i)
      strips.strips[strips.size++] = m_children.get(i);
    push_nearer(a, b, children.least_distance, push);
  }

  // Queues the nearer end of an edge on which strips wait. Of ends at the same distance, the first one.
  template <typename Push>
  void push_nearer(Vertex_id a, Vertex_id b, const FT& key, Push push) const
  {
    push(m_field.distance[b] < m_field.distance[a] ? b : a, key);
  }

  // The strip with the shortest path to the apex, the first one if several tie. Requires: there is one.
  Strip<FT> nearest_strip(const Entered_strips<FT>& entered)
  {
    const FT* const path = m_crossing.path_to_apex();
    const FT* const nearest = std::find(path, path + entered.number, entered.shortest_path_to_apex);
    CGAL_assertion(nearest != path + entered.number);
    return m_crossing.get(static_cast<std::size_t>(nearest - path));
  }

  // Improves the apex by a path along a ray. Paths run back to the image of its foot as to that of a root: as in
  // Straight_piece, a line to this point crosses the source edge at the foot.
  template <typename Wave, typename Push>
  bool improve_apex(const Strip<FT>& s, Halfedge_id h, const Face_frame<FT>& c, Wave& wavefront, Push push)
  {
    const Ray_arrival<FT> ray = arrival_of_ray(s, c.apex_x, c.apex_y);
    if(!(ray.distance < m_field.distance[c.apex]))
      return false;
    Vertex_arrival<FT> arrival;
    arrival.abscissa = ray.abscissa;
    arrival.halfedge = h;
    arrival.root = c.apex;
    Arrival_image<FT> image;
    image.x = ray.image_x;
    image.depth = ray.image_depth;
    const bool are_windows_stale = wavefront.improve(c.apex, ray.distance, arrival, image, wavefront.reached(), push);
    // At a vertex that emits windows, the wavefront refuses an improvement within rounding. The former foot stays then.
    if(m_field.distance[c.apex] == ray.distance)
      m_foot[c.apex] = Strip_foot<FT>{s.side, s.foot_at(ray.abscissa)};
    return are_windows_stale;
  }

  static constexpr std::size_t most_strips_to_fetch = 16; // of a list; the processor finds the others itself

  const Mesh& m_mesh;
  const Field& m_field;
  std::vector<std::uint32_t> m_slot; // by halfedge: the place of its list, or null_id
  Strip_pool<FT> m_pool;
  std::vector<List> m_lists;
  std::vector<Halfedge_id> m_halfedge; // by place in m_lists: on which it waits; null_id if the place is free
  std::vector<std::uint32_t> m_free;
  Source_halfedges<FT> m_source_halfedges;
  std::vector<bool> m_is_source; // by halfedge: is it one of these? (Nearly all crossings ask for nothing else.)
  Strip_columns<FT> m_crossing, m_children; // strips that cross a face, and their children; buffers between calls
  std::uint32_t m_most_faces_crossed = 0; // by one of m_crossing, or a bound of it
  Loops_by_length<Strip_list_loops<FT>> m_loops;
  std::vector<Strip_foot<FT>> m_foot; // by vertex
  Kept* m_kept = nullptr;
  FT m_maximum_distance = Field::infinity();
  std::size_t m_number_crossed = 0, m_number_created = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_STRIP_FRONT_H
