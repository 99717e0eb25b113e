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

// All strips that wait, and what they do when their turn comes. Strips wait on halfedges, in lists. Those of the
// halfedge with the nearest strip are trimmed by the ends of their edge, cross one face, improve the apex, and leave up
// to two children each. Distance_propagation takes turns between these lists and its vertices.
//
// Why these lists are not those of windows: strips have no order by keys, and no rule for pairs needs one. Of two
// strips on one edge, both are kept until vertices trim them.
//
// Splitting at the apex. Let the best path to C that is known come straight through the point S of AB, with the length
// d(C), and let D(C) be the value of the linear function of a strip at C. If D(C) >= d(C), no ray that crosses the
// segment SC is needed beyond it: at the crossing Q, D(Q) >= D(C) - |QC| >= d(C) - |QC| = d(Q), as D grows by at most
// |QC|. So only rays on the left of S go on to the left edge, and only rays on its right to the right edge. This
// compares a strip with a path of any kind, and needs no order. Ties keep the strip.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Wavefront_queue.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Vertex_rival.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The bound on the faces that a shortest path crosses (Intrinsic_mesh::most_faces_crossed()) holds for strips as well:
// a shortest path from a curve is a shortest path from its foot.
//
// The policy of a propagation with curves among its sources; No_strips (Distance_propagation.h) is that without.
//
// Invariants, between calls: the queue has the halfedges on which strips wait, each with a key that is not greater than
// the distance of any of them. m_slot tells their lists, m_free the other places of m_lists.
template <typename FT>
class Strip_front
{
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

public:
  static constexpr bool exist = true;

  // Both must outlive this object.
  Strip_front(const Mesh& mesh, const Field& field) : m_mesh(mesh), m_field(field), m_queue(0) {}

  // Removes all strips. The mesh may have changed since. Linear in the number of halfedges on which strips have waited
  // at the same time, and in that of vertices and faces that are new.
  void restart()
  {
    while(!m_queue.empty())
    {
      m_slot[m_queue.top()] = null_id;
      m_queue.pop();
    }
    m_free.clear();
    for(std::uint32_t i = 0; i < m_lists.size(); ++i)
    {
      m_lists[i].clear();
      m_free.push_back(i);
    }
    m_queue.restart(4 * m_mesh.number_of_faces()); // halfedges take the place of vertices
    m_slot.resize(4 * m_mesh.number_of_faces(), null_id);
    m_foot.resize(m_mesh.number_of_vertices());
    m_maximum_distance = Field::infinity();
    m_number_crossed = m_number_created = 0;
  }

  // Distances of vertices need no strip any more when it has crossed its face; distances of other points do.
  //
  // Keeps the strips that cross faces from now on, for queries; the field must be reset for the mesh, and outlive the
  // run. Null keeps none.
  void keep_in(Edge_strip_field<FT>* kept) { m_kept = kept; }

  // Drops strips that are farther away. Requires: d >= 0.
  void set_maximum_distance(const FT& d) { m_maximum_distance = d; }

  // Lets strips start at all edges. Vertices of curves are sources that emit windows into all faces when they are
  // visited. All of them have their distances before any strip starts, so that strips know them as rivals at once.
  template <typename Wave, typename Push>
  void start(const Source_curves<FT>& curves, Wave& wavefront, Push push)
  {
    for(const Source_vertex<FT>& v : curves.vertices)
      wavefront.add_source(v.vertex, v.offset, push);
    for(std::uint32_t i = 0; i < curves.edges.size(); ++i)
    {
      const Source_edge<FT>& e = curves.edges[i];
      add_first_strip(e.left, e.offset, 2 * i);
      add_first_strip(e.right, e.offset, 2 * i + 1);
    }
  }

  bool empty() const { return m_queue.empty(); }

  // No strip that waits is nearer. Requires: !empty().
  const FT& top_key() const { return m_queue.top_key(); }

  // Lets the strips of the nearest halfedge cross its face. Returns whether they have improved a vertex that had
  // emitted windows. Requires: !empty().
  template <typename Wave, typename Push>
  bool cross_nearest(Wave& wavefront, Push push)
  {
    CGAL_expensive_assertion(!empty());
    const Halfedge_id h = m_queue.top();
    m_queue.pop();
    take(h);
    const Face_frame<FT> c = m_mesh.face_frame(h);
    const bool are_windows_stale = enter(h, c, wavefront, push);
    // All strips have improved the apex by now. What is known of the path to it decides which of their rays go on; a
    // path that enters the face across another edge decides nothing.
    const Vertex_arrival<FT>& arrival = m_field.arrival[c.apex];
    const bool comes_across = arrival.halfedge == h;
    // Enlarged by the error of distances, so that ties keep the strip.
    const FT known = m_field.distance[c.apex] / (1 - Tolerance<FT>::distance());
    List* const left = c.left != null_id && c.left_length > 0 ? &list(c.left) : nullptr;
    List* const right = c.right != null_id && c.right_length > 0 ? &list(c.right) : nullptr;
    const Side_angle<FT> at_left = left != nullptr ? left_angle(c) : Side_angle<FT>();
    const Side_angle<FT> at_right = right != nullptr ? right_angle(c) : Side_angle<FT>();
    const Vertex_rival<FT> a = rival(c.origin), b = rival(c.target), top = rival(c.apex);
    FT left_key = Field::infinity(), right_key = left_key;
    for(const Strip<FT>& s : m_crossing)
    {
      const FT apex = crossing_of_ray(s, c.apex_x, c.apex_y);
      const bool is_longer = comes_across && known < distance_of_ray(s, c.apex_x, c.apex_y);
      Strip<FT> child = s;
      if(left != nullptr
         && turn_left(child, c, at_left, apex, is_longer ? (std::min)(apex, arrival.abscissa) : apex))
        put(child, c.left_length, a, top, *left, left_key);
      child = s;
      if(right != nullptr
         && turn_right(child, c, at_right, apex, is_longer ? (std::max)(apex, arrival.abscissa) : apex))
        put(child, c.right_length, top, b, *right, right_key);
    }
    let_wait(c.left, left, left_key);
    let_wait(c.right, right, right_key);
    return are_windows_stale;
  }

  // Where a strip last improved a vertex: the foot of that path. It counts for vertices that are their own roots, but
  // no sources: only then a strip has reached them last.
  // (The field of distances has no room for it: propagations from points would pay for that.)
  const Strip_foot<FT>& foot(Vertex_id v) const { return m_foot[v]; }

  // The same of all vertices, for results that outlive the run: paths are traced when the propagation is gone.
  const std::vector<Strip_foot<FT>>& feet() const { return m_foot; }

  std::size_t number_crossed() const { return m_number_crossed; }
  std::size_t number_created() const { return m_number_created; }

  // Linear in the number of lists.
  std::size_t memory() const
  {
    std::size_t n = m_crossing.capacity();
    for(const List& l : m_lists)
      n += l.capacity();
    return n * sizeof(Strip<FT>) + m_foot.capacity() * sizeof(Strip_foot<FT>)
         + 2 * m_slot.capacity() * sizeof(std::uint32_t);
  }

private:
  using List = std::vector<Strip<FT>>;

  // The path to a vertex as a rival of strips. Degenerate vertices win ties, as against windows: in faces without
  // extent strips would go around forever.
  Vertex_rival<FT> rival(Vertex_id v) const
  {
    return Vertex_rival<FT>(m_field.distance[v], m_mesh.has(v, Mesh::DEGENERATE));
  }

  // Adds the strip of a whole source edge, on one side of it. Its rays are perpendicular to the edge, and its function
  // is constant. Does nothing at the border, and for an edge without length, whose ends are sources anyway.
  void add_first_strip(Halfedge_id h, const FT& offset, std::uint32_t side)
  {
    if(h == null_id || !(m_mesh.length(h) > 0))
      return;
    FT key = Field::infinity();
    const FT& length = m_mesh.length(h);
    put(Strip<FT>{FT(0), length, FT(0), FT(1), offset, FT(0), side, 0}, length, rival(m_mesh.source(h)),
        rival(m_mesh.target(h)), list(h), key);
    let_wait(h, &list(h), key);
  }

  // The list of a halfedge, which is made if there is none. Addresses stay valid: m_lists is a deque.
  List& list(Halfedge_id h)
  {
    if(m_slot[h] == null_id)
    {
      if(m_free.empty())
      {
        m_lists.emplace_back();
        m_free.push_back(static_cast<std::uint32_t>(m_lists.size() - 1));
      }
      m_slot[h] = m_free.back();
      m_free.pop_back();
    }
    return m_lists[m_slot[h]];
  }

  // Moves the strips of a halfedge to m_crossing. Its place is free then: a child of one of them may need it, on a face
  // that is glued to itself.
  void take(Halfedge_id h)
  {
    m_crossing.clear();
    m_crossing.swap(list(h));
    release(h);
  }

  // Gives the place of a list back. Requires: the list is empty.
  void release(Halfedge_id h)
  {
    m_free.push_back(m_slot[h]);
    m_slot[h] = null_id;
  }

  // Trimming before a strip waits saves the memory of those that vertices beat at once: most of them.
  // Adds a strip to a list, unless the ends of its edge, A and B, beat it at once. Lowers `key` to its distance.
  void put(Strip<FT> s, const FT& length, const Vertex_rival<FT>& a, const Vertex_rival<FT>& b, List& strips, FT& key)
  {
    if(!trim(s, length, a, b))
      return;
    const FT d = s.minimum_distance();
    if(d > m_maximum_distance)
      return;
    strips.push_back(s);
    key = (std::min)(key, d);
    ++m_number_created;
  }

  // Lets the list of a halfedge wait, if it has any strips. `key` is the least distance of those that are new.
  void let_wait(Halfedge_id h, List* strips, const FT& key)
  {
    if(strips == nullptr)
      return;
    if(strips->empty())
      release(h);
    else if(key < Field::infinity())
      m_queue.push_or_decrease(h, key);
  }

  // Trims the strips that cross h: vertices may have become nearer since they were added. Then lets all of them improve
  // the apex, and removes those that go no farther.
  template <typename Wave, typename Push>
  bool enter(Halfedge_id h, const Face_frame<FT>& c, Wave& wavefront, Push push)
  {
    const Vertex_rival<FT> a = rival(c.origin), b = rival(c.target);
    const std::size_t most_faces = m_mesh.most_faces_crossed();
    bool are_windows_stale = false;
    std::size_t n = 0;
    for(Strip<FT>& s : m_crossing)
    {
      if(!trim(s, c.length, a, b))
        continue;
      ++m_number_crossed;
      // Also a sliver, which goes no farther: points of this face may lie on its rays.
      if(m_kept != nullptr)
        m_kept->keep(h, s);
      // No path along a ray is shorter than the linear function, so most strips need no division to find the crossing.
      if(distance_of_ray(s, c.apex_x, c.apex_y) < m_field.distance[c.apex])
        are_windows_stale |= improve_apex(s, h, c, wavefront, push);
      if(!s.is_sliver(c.length) && s.faces_crossed < most_faces)
        m_crossing[n++] = s;
    }
    m_crossing.resize(n);
    return are_windows_stale;
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

  const Mesh& m_mesh;
  const Field& m_field;
  Wavefront_queue<FT> m_queue;       // of halfedges
  std::vector<std::uint32_t> m_slot; // by halfedge: the place of its list, or null_id
  std::deque<List> m_lists;
  std::vector<std::uint32_t> m_free;
  List m_crossing; // the strips that cross a face; a buffer between calls
  std::vector<Strip_foot<FT>> m_foot; // by vertex
  Edge_strip_field<FT>* m_kept = nullptr;
  FT m_maximum_distance = Field::infinity();
  std::size_t m_number_crossed = 0, m_number_created = 0;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_CURVES_STRIP_FRONT_H
