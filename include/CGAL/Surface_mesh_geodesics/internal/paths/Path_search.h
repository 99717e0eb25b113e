// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_SEARCH_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_SEARCH_H

// The last resort of path_tracing.h: finds a shortest path from the distances of the vertices alone, without knowing
// where it goes. The search looks along straight lines from the beginning of the path, cone by cone, from face to face.
// A vertex is on the path if the length of the way to it and its distance add up to the distance of the beginning; from
// there the search goes on. A cone is dropped if all of its points are too far from the source: the distance of a point
// of an edge follows from those of the ends, up to the length of the edge. So the search stays in a strip around the
// path.
//
// Rounding. A vertex beside a cone is reached by a path that bends at the border of the cone. So every path that the
// search considers is a path on the surface, of the length that the search computes. The only question is whether it is
// short enough, and no decision about sides is needed.

#include <CGAL/Surface_mesh_geodesics/internal/paths/Straight_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/distance_at_location.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/unfolding.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariants, during a search: m_stop and m_length belong to the vertex that is looked from; each cone leads, by
// `parent`, back to the first cone of its stop, and each stop, by `previous`, back to the beginning; the cones of an
// edge form a list, from m_last_cone on, along `other`. Cones and stops are never removed, so their indices stay valid.
//
// Frame: a cone is in the frame of the halfedge behind the edge that it crosses; see Cone. An object serves many
// searches.
template <typename FT>
class Path_search
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;
  using Steps = Path_steps<FT>;

  // `curves` is null if all sources are points.
  Path_search(const Mesh& mesh, const Field& field, const Curve_arrivals<FT>* curves = nullptr)
    : m_mesh(mesh), m_field(field), m_curves(curves)
  {}

  // Appends the path from v; the caller has appended v itself. The length of the path is the distance of v up to
  // `tolerance`, and up to twice that for the rounding of the sum. Returns false, and appends nothing, if no such path
  // is found or the search gives up.
  // Requires: v is reached.
  bool from_vertex(Vertex_id v, const FT& tolerance, Steps& path)
  {
    CGAL_assertion(m_field.distance[v] < Field::infinity());
    begin(source_of_path(m_field, m_curves, v), m_field.distance[v], tolerance);
    if(m_field.is_source(v))
      return true;
    m_seen.insert(v);
    m_shortest[v] = 0;
    look_around(v);
    return go_on(path);
  }

  // The same from the point of face f with the barycentric coordinates b, which is at `distance`. The path leads to
  // `source`, as source_of_path() names it. Requires: b >= 0.
  bool from_location(Face_id f, const std::array<FT, 3>& b, std::uint32_t source, const FT& distance,
                     const FT& tolerance, Steps& path)
  {
    begin(source, distance, tolerance);
    look_around(f, b);
    return go_on(path);
  }

private:
  using Index = std::uint32_t;

  // The lines from the image (image_x, -image_depth) of a stop to the points from `begin` to `end` of an edge, in the
  // frame of `halfedge`, which belongs to the face behind the edge.
  // Invariants of cones that add() takes: begin < end, image_depth >= 0. Rounding may move begin and end out of [0,
  // length] by some epsilon of the length.
  struct Cone
  {
    Halfedge_id halfedge;
    FT begin, end, image_x, image_depth;
    Index parent; // the cone through the edge before, or null_id
    Index stop;   // where the lines begin
    Index other;  // the next cone in the list of this edge, or null_id
  };

  // A vertex on the path. It is reached through a cone, or directly in a face; then `cone` is null_id.
  struct Stop
  {
    Vertex_id vertex;
    FT length; // of the path so far
    FT gap;    // the length of the path from `previous`, or of its part behind the last cone
    Face_id face;
    Index cone, previous;
  };

  // A foot on a source edge that ends the path: the point of the edge of `halfedge` at which a line leaves the face of
  // that halfedge. The cone of the line is as add() gets it: in the frame of the halfedge behind the edge, if there is
  // one.
  struct Foot
  {
    Halfedge_id halfedge = null_id;
    FT behind_abscissa = 0;
    Cone cone{};
  };

  // Starts a search for a path of length `distance` to a source. The memory of earlier searches is kept.
  void begin(std::uint32_t source, const FT& distance, const FT& tolerance)
  {
    m_source = source;
    m_foot = Foot();
    m_distance = distance;
    m_tolerance = tolerance;
    m_stop = null_id;
    m_length = 0;
    m_effort = 0;
    m_cones.clear();
    m_stops.clear();
    m_waiting.clear();
    m_seen.clear();
    m_shortest.clear();
    m_last_cone.clear();
  }

  // The search gives up after this number of cones and comparisons of cones. It bounds the memory: a cone takes about
  // 50 bytes, so the limit is some 200 MB. A longer search would fill the memory rather than find a path.
  static constexpr std::size_t maximum_effort = 1 << 22;

  // Searches until a source is reached. New stops come before cones, and the youngest cone before older ones, so the
  // search goes straight on.
  bool go_on(Steps& path)
  {
    std::size_t next_stop = 0;
    while(m_effort < maximum_effort)
    {
      if(m_foot.halfedge != null_id && append_path_to_foot(path))
        return true;
      m_foot = Foot();
      if(next_stop < m_stops.size())
      {
        m_stop = static_cast<Index>(next_stop++);
        const Stop stop = m_stops[m_stop];
        if(m_field.is_source(stop.vertex))
          return append_path(path);
        m_length = stop.length;
        look_around(stop.vertex);
      }
      else if(!m_waiting.empty())
      {
        const Index i = m_waiting.back();
        m_waiting.pop_back();
        look_through(i);
      }
      else
        return false;
    }
    return false;
  }

  // Looks from a vertex into the faces around it: at their other corners, and across their opposite edges. All faces
  // are tried, also those on the way back: what is too far from the source falls out in add().
  void look_around(Vertex_id v)
  {
    m_mesh.for_each_halfedge_around(v, [this](Halfedge_id h)
    {
      const Halfedge_id across = next_halfedge(h);
      const Face_frame<FT> c = m_mesh.face_frame(across);
      reach(c.origin, c.left_length, face_of(h), null_id);
      reach(c.target, c.right_length, face_of(h), null_id);
      add_whole_edge(across, c.apex_x, c.apex_y);
    });
  }

  // Looks from a point of a face at its corners and across its edges.
  void look_around(Face_id f, const std::array<FT, 3>& b)
  {
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Halfedge_id h = halfedge_of(f, k);
      const Face_frame<FT> c = m_mesh.face_frame(h);
      const std::array<FT, 2> p = point_in_frame(c, b, k);
      reach(c.origin, norm<FT>(p[0], p[1]), f, null_id);
      add_whole_edge(h, p[0], p[1]);
    }
  }

  // Adds the cone from the point (x, y) of the face of h through the whole edge of h.
  void add_whole_edge(Halfedge_id h, const FT& x, const FT& y)
  {
    const FT length = m_mesh.length(h);
    add(Cone{m_mesh.opposite(h), FT(0), length, FT(length - x), y, null_id, m_stop, null_id}, h);
  }

  // Looks for the end of the path on a source edge that a cone meets. The nearest point of the edge is the foot of a
  // ray at a right angle, or an end of the cone. `h` is the halfedge through which the cone leaves its face.
  void look_for_foot(const Cone& cone, Halfedge_id h)
  {
    using std::abs;
    const std::uint32_t side = m_curves->side_of(h);
    if(side == null_id || m_curves->edge_of_side(side).curve != m_source || !(cone.begin < cone.end)
       || cone.image_depth < 0)
      return;
    const FT x = (std::min)((std::max)(cone.image_x, cone.begin), cone.end);
    const FT rest = norm<FT>(x - cone.image_x, cone.image_depth) + m_curves->edge_of_side(side).offset;
    if(abs(FT(m_length + rest - m_distance)) <= m_tolerance)
      m_foot = Foot{h, x, cone};
  }

  // Adds a cone unless it is empty, too far from the source, or dominated by a known cone or a vertex. `h` is the
  // halfedge through which it leaves its face; behind it is that of the cone.
  void add(Cone cone, Halfedge_id h)
  {
    if(m_curves != nullptr && m_foot.halfedge == null_id)
      look_for_foot(cone, h);
    if(cone.halfedge == null_id || !(cone.begin < cone.end) || cone.image_depth < 0
       || m_length + least_rest(cone) > m_distance + m_tolerance || is_beaten(cone) || is_hidden(cone))
      return;
    const Index i = static_cast<Index>(m_cones.size());
    m_waiting.push_back(i);
    const auto known = m_last_cone.emplace(cone.halfedge, i);
    if(!known.second)
      cone.other = known.first->second;
    known.first->second = i;
    ++m_effort;
    m_cones.push_back(cone);
  }

  // Returns a lower bound of the length of paths from the image through a cone to the source: the distance from the
  // image to the nearest point of the cone, and the smallest distance that a point of the cone can have. The latter
  // follows from the distances a and b of the ends, as the distance is 1-Lipschitz along the edge: at abscissa x it is
  // at least a - x and b - (length - x). (An end may be farther from the source than the beginning of the path. If the
  // run has ended early, its distance is not final.)
  // Error: four epsilon of the sum; the caller adds its tolerance.
  FT least_rest(const Cone& cone) const
  {
    const FT length = m_mesh.length(cone.halfedge);
    const FT a = m_field.least_distance(m_mesh.source(cone.halfedge));
    const FT b = m_field.least_distance(m_mesh.target(cone.halfedge));
    const FT behind = (std::max)((a + b - length) / 2, (std::max)(a - cone.end, b - (length - cone.begin)));
    const FT x = (std::min)((std::max)(cone.image_x, cone.begin), cone.end);
    return norm<FT>(x - cone.image_x, cone.image_depth) + (std::max)(behind, FT(0));
  }

  // Returns whether the path through one end of the edge is not longer, for all points of the cone. It is for all if it
  // is for the one farthest from that end. A tie beats the cone.
  bool is_beaten(const Cone& cone) const
  {
    const FT rest = m_mesh.length(cone.halfedge) - cone.begin;
    return is_beaten(m_mesh.source(cone.halfedge), cone.end, norm<FT>(cone.end - cone.image_x, cone.image_depth))
        || is_beaten(m_mesh.target(cone.halfedge), rest, norm<FT>(cone.begin - cone.image_x, cone.image_depth));
  }

  // Returns whether a known cone from the same stop covers this one with a nearer image. The points that are nearer to
  // one of two images form a half-plane, so the comparison at the two ends decides for all points between them. A tie
  // hides the new cone.
  bool is_hidden(const Cone& cone)
  {
    const auto known = m_last_cone.find(cone.halfedge);
    if(known == m_last_cone.end())
      return false;
    const FT at_begin = squared_distance(cone, cone.begin), at_end = squared_distance(cone, cone.end);
    for(Index i = known->second; i != null_id; i = m_cones[i].other)
    {
      ++m_effort;
      const Cone& other = m_cones[i];
      if(other.stop == cone.stop && other.begin <= cone.begin && cone.end <= other.end
         && squared_distance(other, cone.begin) <= at_begin && squared_distance(other, cone.end) <= at_end)
        return true;
    }
    return false;
  }

  // Returns the squared distance from the image of a cone to the point x of its edge.
  static FT squared_distance(const Cone& cone, const FT& x)
  {
    return (x - cone.image_x) * (x - cone.image_x) + cone.image_depth * cone.image_depth;
  }

  // Returns whether the path through v, an end of the edge of a cone, is not longer at the point of the cone farthest
  // from v. That point is at `from_vertex` from v and at `from_image` from the image. A vertex with another source than
  // that of the search beats nothing: its paths lead to the wrong source.
  bool is_beaten(Vertex_id v, const FT& from_vertex, const FT& from_image) const
  {
    const auto known = m_shortest.find(v);
    return known != m_shortest.end() && known->second + from_vertex <= m_length + from_image
        && source_of_path(m_field, m_curves, v) == m_source;
  }

  // Notes that v can be reached by a way of length `gap` from the current stop. Makes v a stop if it is on the path:
  // the length so far and its distance add up to the distance of the beginning, up to the tolerance, and its source is
  // the right one.
  void reach(Vertex_id v, const FT& gap, Face_id f, Index cone)
  {
    using std::abs;
    const FT length = m_length + gap;
    const auto known = m_shortest.emplace(v, length);
    known.first->second = (std::min)(known.first->second, length);
    if(!(abs(FT(length + m_field.distance[v] - m_distance)) <= m_tolerance)
       || source_of_path(m_field, m_curves, v) != m_source || !m_seen.insert(v).second)
      return;
    m_stops.push_back(Stop{v, length, gap, f, cone, m_stop});
  }

  // Returns the abscissa at which the line from (x, y) to the image crosses the edge, moved into the cone.
  // Requires: y >= 0. On the line of the edge itself (height 0) the result is x, moved into the cone.
  static FT abscissa_of(const Cone& cone, const FT& x, const FT& y)
  {
    const FT height = y + cone.image_depth;
    const FT t = height > 0 ? FT((cone.image_x * y + x * cone.image_depth) / height) : x;
    return (std::min)((std::max)(t, cone.begin), cone.end);
  }

  // Looks at the apex of the face behind a cone, and through the two other sides of the face. The line from the image
  // to the apex crosses the edge at t, moved into the cone; there the cone is divided between the two sides. The search
  // goes back to the stop of the cone, which need not be the last one.
  void look_through(Index i)
  {
    const Cone cone = m_cones[i];
    m_stop = cone.stop;
    m_length = m_stop == null_id ? FT(0) : m_stops[m_stop].length;
    const Face_frame<FT> c = m_mesh.face_frame(cone.halfedge);
    const FT t = abscissa_of(cone, c.apex_x, c.apex_y);
    reach(c.apex, norm<FT>(t - cone.image_x, cone.image_depth) + norm<FT>(c.apex_x - t, c.apex_y),
          face_of(cone.halfedge), i);
    if(c.left_length > 0)
      add(left_part(cone, c, i, t), previous_halfedge(cone.halfedge));
    if(c.right_length > 0)
      add(right_part(cone, c, i, t), next_halfedge(cone.halfedge));
  }

  // Returns the part of a cone on the side AC, through the points of AB from begin to t. Frame: that of the halfedge
  // behind AC, which runs from A to C. If t is before the end of the cone, the part reaches C. It may be empty; add()
  // drops it then.
  static Cone left_part(const Cone& cone, const Face_frame<FT>& c, Index i, const FT& t)
  {
    const Side_angle<FT> angle = left_angle(c);
    const Image_below_edge<FT> image = image_below_side(angle, cone.image_x, cone.image_depth);
    const FT first = along_side(cone.begin, cone.image_x, cone.image_depth, angle, c.left_length);
    const FT last
      = t < cone.end ? c.left_length : along_side(cone.end, cone.image_x, cone.image_depth, angle, c.left_length);
    return Cone{c.left, first, (std::max)(first, last), image.x, image.depth, i, cone.stop, null_id};
  }

  // Returns the part of a cone on the side CB, through the points of AB from t to end. Computes as left_part() does in
  // the mirror image, from B, and mirrors the result back.
  static Cone right_part(const Cone& cone, const Face_frame<FT>& c, Index i, const FT& t)
  {
    const Side_angle<FT> angle = right_angle(c);
    const FT x = c.length - cone.image_x;
    const Image_below_edge<FT> image = image_below_side(angle, x, cone.image_depth);
    const FT last = along_side(c.length - cone.end, x, cone.image_depth, angle, c.right_length);
    const FT first = t > cone.begin
                       ? c.right_length
                       : along_side(c.length - cone.begin, x, cone.image_depth, angle, c.right_length);
    return Cone{c.right, FT(c.right_length - (std::max)(first, last)), FT(c.right_length - last),
                FT(c.right_length - image.x), image.depth, i, cone.stop, null_id};
  }

  // Returns the abscissa, along a side that leaves the origin at the given angle, at which the ray from the image
  // through x on the edge meets the side: s = x depth / (depth cos - (x - image_x) sin), at most the length of the
  // side. A ray that does not meet the side gives its length, a ray through the origin gives 0.
  static FT along_side(const FT& x, const FT& image_x, const FT& depth, const Side_angle<FT>& angle, const FT& length)
  {
    if(!(x > 0))
      return FT(0);
    const FT divisor = depth * angle.cosine - (x - image_x) * angle.sine;
    return divisor > 0 ? (std::min)(FT(x * depth / divisor), length) : length;
  }

  // Appends the path to the current stop, which is a source, if its length is the distance. Each stop has been accepted
  // with an error of up to the tolerance; the sum over the gaps is rounded differently, so it may err by twice that.
  bool append_path(Steps& path) const
  {
    Steps reversed;
    return append_pieces(m_stop, m_field.distance[m_stops[m_stop].vertex], reversed, path);
  }

  // The same for the path to the foot. The last stop is that of its cone.
  bool append_path_to_foot(Steps& path) const
  {
    const Cone& cone = m_foot.cone;
    const FT length = m_mesh.length(m_foot.halfedge), t = m_foot.behind_abscissa;
    Path_step<FT> step = step_on_edge<FT>(m_mesh, m_foot.halfedge, FT(length - t));
    Steps reversed;
    if(cone.parent == null_id)
    {
      step.gap = norm<FT>(t - cone.image_x, cone.image_depth);
      reversed.push_back(step);
    }
    else
    {
      const std::array<FT, 2> p = point_behind(m_foot.halfedge, t, m_cones[cone.parent].halfedge);
      add_crossings(cone.parent, p[0], p[1], step, reversed);
    }
    const std::uint32_t side = m_curves->side_of(m_foot.halfedge);
    return append_pieces(cone.stop, m_curves->edge_of_side(side).offset, reversed, path);
  }

  // Both ends of a path, a vertex and a foot, come here: the length is that of the steps which the user gets, not that
  // of the search, so that no path is accepted with a wrong one.
  //
  // Appends the pieces up to a stop in front of `reversed`, which holds what follows, and then both to the path, in
  // order, if the sum of the gaps and the offset of the source is the distance.
  bool append_pieces(Index stop, const FT& offset, Steps& reversed, Steps& path) const
  {
    using std::abs;
    for(Index i = stop; i != null_id; i = m_stops[i].previous)
      add_piece(m_stops[i], reversed);
    FT length = offset;
    for(const Path_step<FT>& step : reversed)
      length = length + step.gap;
    if(!(abs(FT(length - m_distance)) <= 2 * m_tolerance))
      return false;
    path.insert(path.end(), reversed.rbegin(), reversed.rend());
    return true;
  }

  // Appends the points of the piece that ends at a stop, from its end to its beginning, which is not appended.
  void add_piece(const Stop& stop, Steps& reversed) const
  {
    Path_step<FT> step;
    step.vertex = stop.vertex;
    step.face = stop.face;
    step.gap = stop.gap;
    if(stop.cone == null_id)
    {
      reversed.push_back(step);
      return;
    }
    const Face_frame<FT> last = m_mesh.face_frame(m_cones[stop.cone].halfedge);
    add_crossings(stop.cone, last.apex_x, last.apex_y, step, reversed);
  }

  // Appends a step and the crossings before it, back to the beginning of its piece. The step is at (x, y) in the frame
  // of cone i; its gap is set here.
  void add_crossings(Index i, FT x, FT y, Path_step<FT> step, Steps& reversed) const
  {
    for(; i != null_id; i = m_cones[i].parent)
    {
      const Cone& cone = m_cones[i];
      const FT t = abscissa_of(cone, x, y);
      step.gap = norm<FT>(x - t, y);
      reversed.push_back(step);
      const Halfedge_id h = m_mesh.opposite(cone.halfedge);
      step = step_on_edge<FT>(m_mesh, h, FT(m_mesh.length(h) - t));
      if(cone.parent == null_id)
      {
        step.gap = norm<FT>(t - cone.image_x, cone.image_depth);
        reversed.push_back(step);
        return;
      }
      const std::array<FT, 2> p = point_behind(h, t, m_cones[cone.parent].halfedge);
      x = p[0];
      y = p[1];
    }
  }

  // Returns the point at the abscissa t of the halfedge behind h, in the frame of `before`, a side of the face of h.
  // `part` is the fraction of the way from A to C, or from B to C: the halfedge behind AC runs from A to C, and that
  // behind CB from C to B.
  std::array<FT, 2> point_behind(Halfedge_id h, const FT& t, Halfedge_id before) const
  {
    const Face_frame<FT> c = m_mesh.face_frame(before);
    const bool is_left = h == previous_halfedge(before);
    const FT part = is_left ? FT(t / c.left_length) : FT(1 - t / c.right_length);
    return {is_left ? FT(part * c.apex_x) : FT(c.length - part * c.apex_rest), FT(part * c.apex_y)};
  }

  const Mesh& m_mesh;
  const Field& m_field;
  const Curve_arrivals<FT>* m_curves;
  std::uint32_t m_source = null_id;   // where the path has to end, as source_of_path() names it
  Foot m_foot;                        // the end of the path, if it has been seen
  FT m_distance = 0, m_tolerance = 0; // the length that it has to have
  Index m_stop = null_id; // the current stop; null_id for the beginning
  FT m_length = 0;        // of the path to the current stop
  std::size_t m_effort = 0;
  std::vector<Cone> m_cones;
  std::vector<Stop> m_stops;
  std::vector<Index> m_waiting;                       // cones through which the search has not looked yet
  std::unordered_set<Vertex_id> m_seen;               // vertices that are stops, and the beginning
  std::unordered_map<Halfedge_id, Index> m_last_cone; // the first cone in the list of an edge
  std::unordered_map<Vertex_id, FT> m_shortest;       // the shortest way found to each vertex that has been looked at
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_SEARCH_H
