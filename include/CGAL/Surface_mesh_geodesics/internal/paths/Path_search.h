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

// A shortest path found without knowing where it goes: the distances of the vertices are enough. What is seen
// along straight lines from the beginning of the path is looked through, cone by cone, from face to face. A vertex
// is on the path if the way to it and its distance make up the distance of the beginning; from there the search
// goes on. A cone whose points are all too far from the source is left: the distance of a point of an edge is known
// from those of the ends, but for the length of the edge. So a strip around the path is searched.
//
// Rounding. A vertex next to a cone is reached by a path that bends at the border of the cone. Every path that is
// looked at is a path on the surface, with the length that is told; whether it is short enough is all that is asked,
// and no decision about sides is needed.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Straight_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/distance_at_location.h>

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

template <typename FT>
class Path_search
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;
  using Steps = Path_steps<FT>;

  Path_search(const Mesh& mesh, const Field& field) : m_mesh(mesh), m_field(field) {}

  // appends the path from v, which itself has been appended. Its length is the distance but for `tolerance`.
  // Returns false if none has been found.
  bool from_vertex(Vertex_id v, const FT& tolerance, Steps& path)
  {
    begin(v, m_field.distance[v], tolerance);
    if(m_field.is_source(v))
      return true;
    m_seen.insert(v);
    m_shortest[v] = 0;
    look_around(v);
    return go_on(path);
  }

  // the same from the point of face f with the coordinates b. `root` is on the path.
  bool from_location(Face_id f, const std::array<FT, 3>& b, Vertex_id root, const FT& distance, const FT& tolerance,
                     Steps& path)
  {
    begin(root, distance, tolerance);
    look_around(f, b);
    return go_on(path);
  }

private:
  using Index = std::uint32_t;

  // What is seen through a part of an edge, in the frame of the halfedge of the face behind it: the lines from
  // the image (image_x, -image_depth) to the points from begin to end.
  struct Cone
  {
    Halfedge_id halfedge;
    FT begin, end, image_x, image_depth;
    Index parent; // the cone in which it is, or null_id
    Index stop;   // from which it is seen
    Index other;  // another cone through the same edge, or null_id
  };

  // A vertex on the path. It has been reached through a cone, or directly in a face; then `cone` is null_id.
  struct Stop
  {
    Vertex_id vertex;
    FT length; // of the path so far
    FT gap;    // the last part of it
    Face_id face;
    Index cone, previous;
  };

  void begin(Vertex_id root, const FT& distance, const FT& tolerance)
  {
    m_source = m_field.source_of(root);
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

  // A search for longer would rather fill the memory than find something. (Cones and comparisons of cones count.)
  static constexpr std::size_t maximum_effort = 1 << 22;

  // Vertices come before cones; of these the one that has been found last, so that the search goes straight on.
  bool go_on(Steps& path)
  {
    std::size_t next_stop = 0;
    while(m_effort < maximum_effort)
    {
      if(next_stop < m_stops.size())
      {
        m_stop = static_cast<Index>(next_stop++);
        const Stop stop = m_stops[m_stop];
        if(m_field.is_source(stop.vertex))
          return tell(path);
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

  // looks from a vertex at what is around.
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

  // looks from a point of a face.
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

  // what is seen across h from the point (x, y) in its face.
  void add_whole_edge(Halfedge_id h, const FT& x, const FT& y)
  {
    const FT length = m_mesh.length(h);
    add(Cone{m_mesh.opposite(h), FT(0), length, FT(length - x), y, null_id, m_stop, null_id});
  }

  void add(Cone cone)
  {
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

  // a lower bound of the length of paths from the image through a cone.
  FT least_rest(const Cone& cone) const
  {
    const FT length = m_mesh.length(cone.halfedge);
    const FT a = m_field.distance[m_mesh.source(cone.halfedge)], b = m_field.distance[m_mesh.target(cone.halfedge)];
    const FT behind = (std::max)((a + b - length) / 2, (std::max)(a - cone.end, b - (length - cone.begin)));
    const FT x = (std::min)((std::max)(cone.image_x, cone.begin), cone.end);
    return norm<FT>(x - cone.image_x, cone.image_depth) + (std::max)(behind, FT(0));
  }

  // Is the path through an end of the edge not longer, for all points of the cone? It is for all if it is for the
  // farthest one.
  bool is_beaten(const Cone& cone) const
  {
    const FT rest = m_mesh.length(cone.halfedge) - cone.begin;
    return is_beaten(m_mesh.source(cone.halfedge), cone.end, norm<FT>(cone.end - cone.image_x, cone.image_depth))
        || is_beaten(m_mesh.target(cone.halfedge), rest, norm<FT>(cone.begin - cone.image_x, cone.image_depth));
  }

  // Is another cone seen from the same stop behind which this one lies, with the farther image? The points that are
  // nearer to one of two images are a half-plane, so that the ends tell.
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

  static FT squared_distance(const Cone& cone, const FT& x)
  {
    return (x - cone.image_x) * (x - cone.image_x) + cone.image_depth * cone.image_depth;
  }

  bool is_beaten(Vertex_id v, const FT& from_vertex, const FT& from_image) const
  {
    const auto known = m_shortest.find(v);
    return known != m_shortest.end() && known->second + from_vertex <= m_length + from_image
        && m_field.source_of(v) == m_source;
  }

  // A vertex is at the length `gap` from where one looks: is it on the path?
  void reach(Vertex_id v, const FT& gap, Face_id f, Index cone)
  {
    using std::abs;
    const FT length = m_length + gap;
    const auto known = m_shortest.emplace(v, length);
    known.first->second = (std::min)(known.first->second, length);
    if(!(abs(FT(length + m_field.distance[v] - m_distance)) <= m_tolerance) || m_field.source_of(v) != m_source
       || !m_seen.insert(v).second)
      return;
    m_stops.push_back(Stop{v, length, gap, f, cone, m_stop});
  }

  // the abscissa at which the line from (x, y) to the image crosses the edge, in the cone.
  static FT abscissa_of(const Cone& cone, const FT& x, const FT& y)
  {
    const FT height = y + cone.image_depth;
    const FT t = height > 0 ? FT((cone.image_x * y + x * cone.image_depth) / height) : x;
    return (std::min)((std::max)(t, cone.begin), cone.end);
  }

  // looks at the third corner of the face behind a cone, and through the two other edges.
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
      add(left_part(cone, c, i, t));
    if(c.right_length > 0)
      add(right_part(cone, c, i, t));
  }

  // the part on the edge from A to C, through the edge from begin to t
  static Cone left_part(const Cone& cone, const Face_frame<FT>& c, Index i, const FT& t)
  {
    const FT cosine = c.apex_x / c.left_length, sine = c.apex_y / c.left_length;
    const FT image_x = cone.image_x * cosine - cone.image_depth * sine;
    const FT depth = cone.image_x * sine + cone.image_depth * cosine;
    const FT first = along_side(cone.begin, cone.image_x, cone.image_depth, cosine, sine, c.left_length);
    const FT last = t < cone.end ? c.left_length
                                 : along_side(cone.end, cone.image_x, cone.image_depth, cosine, sine, c.left_length);
    return Cone{c.left, first, (std::max)(first, last), image_x, depth, i, cone.stop, null_id};
  }

  // the part on the edge from C to B, through the edge from t to end
  static Cone right_part(const Cone& cone, const Face_frame<FT>& c, Index i, const FT& t)
  {
    // seen from B
    const FT cosine = c.apex_rest / c.right_length, sine = c.apex_y / c.right_length, x = c.length - cone.image_x;
    const FT image_x = x * cosine - cone.image_depth * sine;
    const FT depth = x * sine + cone.image_depth * cosine;
    const FT last = along_side(c.length - cone.end, x, cone.image_depth, cosine, sine, c.right_length);
    const FT first = t > cone.begin ? c.right_length
                                    : along_side(c.length - cone.begin, x, cone.image_depth, cosine, sine,
                                                 c.right_length);
    return Cone{c.right, FT(c.right_length - (std::max)(first, last)), FT(c.right_length - last),
                FT(c.right_length - image_x), depth, i, cone.stop, null_id};
  }

  // where the ray from the image through x on the edge meets the side that leaves the origin in the given direction
  static FT along_side(const FT& x, const FT& image_x, const FT& depth, const FT& cosine, const FT& sine,
                       const FT& length)
  {
    if(!(x > 0))
      return FT(0);
    const FT divisor = depth * cosine - (x - image_x) * sine;
    return divisor > 0 ? (std::min)(FT(x * depth / divisor), length) : length;
  }

  // appends the path to the last stop, if it is long enough.
  bool tell(Steps& path) const
  {
    using std::abs;
    Steps reversed;
    for(Index i = m_stop; i != null_id; i = m_stops[i].previous)
      add_piece(m_stops[i], reversed);
    FT length = m_field.distance[m_stops[m_stop].vertex]; // the offset of the source
    for(const Path_step<FT>& step : reversed)
      length = length + step.gap;
    if(!(abs(FT(length - m_distance)) <= 2 * m_tolerance))
      return false;
    path.insert(path.end(), reversed.rbegin(), reversed.rend());
    return true;
  }

  // appends the points of a piece from its end on.
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
    FT x = last.apex_x, y = last.apex_y;
    for(Index i = stop.cone; i != null_id; i = m_cones[i].parent)
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
      // in the frame of the edge before
      const Halfedge_id before = m_cones[cone.parent].halfedge;
      const Face_frame<FT> c = m_mesh.face_frame(before);
      const bool is_left = h == previous_halfedge(before);
      const FT part = is_left ? FT(t / c.left_length) : FT(1 - t / c.right_length);
      x = is_left ? FT(part * c.apex_x) : FT(c.length - part * c.apex_rest);
      y = part * c.apex_y;
    }
  }

  const Mesh& m_mesh;
  const Field& m_field;
  Vertex_id m_source = null_id;
  FT m_distance = 0, m_tolerance = 0;
  Index m_stop = null_id; // from which one looks; null_id for the beginning
  FT m_length = 0;        // of the path to it
  std::size_t m_effort = 0;
  std::vector<Cone> m_cones;
  std::vector<Stop> m_stops;
  std::vector<Index> m_waiting; // the cones that have not been looked through
  std::unordered_set<Vertex_id> m_seen;
  std::unordered_map<Halfedge_id, Index> m_last_cone; // through an edge
  std::unordered_map<Vertex_id, FT> m_shortest; // the shortest path to a vertex that has been looked at
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_PATH_SEARCH_H
