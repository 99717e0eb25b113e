// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_FACE_DISTANCES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_FACE_DISTANCES_H

// The distances of many points of one face: those that arrival_at_location() finds, bit by bit, without the arrivals.
// The frames of the face, its windows and its strips are read once, and lie one after the other then.
//
// Along an edge, points are asked for in narrower and narrower parts. Each candidate, a corner, a window or a strip, is
// the length of a path, so that it changes by no more than the length walked. One that is farther than the nearest one
// by more than twice the width of a part is nowhere the nearest there, and is not looked at.
//
// *Convexity.* A path of a candidate leads to a point a of an interval and on to the point p of the face; the candidate
// is the minimum over a. The length is the sum of a norm or a linear function of a, and of the norm of p - a: convex in
// a and p together. So its minimum over a, an interval, is convex in p. Three values of a convex function bound it from
// below between them. On an edge along a line all candidates are constant: the bound tells at once that the line does
// not cross it, where Lipschitz bounds would halve it to the end.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/distance_at_location.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Kept_window.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Use: start() for a face, then at() for points of it; or start_edge() for one of its edges, then at() with fractions
// of that edge, as Isoline_crossings wants it. What the distances are made of is copied, so that windows and strips may
// be released meanwhile.
//
// `Strips` is Edge_strip_field<FT> if curves may be among the sources, else No_strip_field.
//
// Invariant: the first m_active of m_candidates may be nearest in the part that is looked at.
template <typename FT, typename Strips = No_strip_field>
class Face_distances
{
public:
  // Reads a face. `windows` is a Face_windows<FT> or an Edge_window_field<FT>. Takes time linear in the number of the
  // windows and strips of the face.
  template <typename Windows>
  void start(const Intrinsic_mesh<FT>& mesh, const Vertex_distance_field<FT>& field, const Windows& windows,
             const Strips& strips, Face_id f)
  {
    m_candidates.clear();
    for(unsigned int k = 0; k < 3; ++k)
    {
      m_frame[k] = mesh.face_frame(halfedge_of(f, k));
      m_candidates.push_back(Candidate{Kept_window<FT>(), field.distance[m_frame[k].origin], k, CORNER});
      windows.for_each_window(halfedge_of(f, k), [&](const Kept_window<FT>& w)
      { m_candidates.push_back(Candidate{w, field.distance[w.root], k, WINDOW}); });
      strips.for_each_strip(halfedge_of(f, k), [&](const Strip<FT>& s)
      {
        const Kept_window<FT> interval{s.begin, s.end, s.direction_x, s.direction_y, null_id};
        m_candidates.push_back(Candidate{interval, s.distance, k, STRIP});
      });
    }
    m_active = m_candidates.size();
  }

  // Returns the distance of the point with the barycentric coordinates b; infinity if no source reaches it.
  // Requires: b >= 0.
  FT at(const std::array<FT, 3>& b) const
  {
    const std::array<std::array<FT, 2>, 3> p = points_in_frames(b);
    FT distance = Vertex_distance_field<FT>::infinity();
    for(const Candidate& c : m_candidates)
      distance = (std::min)(distance, distance_by(c, p[c.side]));
    return distance;
  }

  // --- along an edge ---

  // Begins with an edge of the face. Requires: h is a halfedge of the face.
  void start_edge(Halfedge_id h)
  {
    m_halfedge = h;
    m_active = m_candidates.size();
  }

  using Mark = std::size_t;
  Mark mark() const { return m_active; }
  void go_back(Mark mark) { m_active = mark; }

  // Returns the distance at t of the edge, and forgets candidates that are nowhere the nearest within `width` of t,
  // both as fractions of the edge. go_back() with an earlier mark knows them again. A margin covers rounding.
  FT at(const FT& t, const FT& width)
  {
    const auto p = points_on_edge(t);
    FT distance = Vertex_distance_field<FT>::infinity();
    for(std::size_t i = 0; i < m_active; ++i)
    {
      Candidate& c = m_candidates[i];
      c.distance = distance_by(c, p[c.side]);
      distance = (std::min)(distance, c.distance);
    }
    const FT farthest
      = distance + 2 * width * m_frame[index_in_face(m_halfedge)].length + distance * Tolerance<FT>::tie();
    const auto end = m_candidates.begin() + static_cast<std::ptrdiff_t>(m_active);
    m_active = static_cast<std::size_t>(
      std::partition(m_candidates.begin(), end, [&](const Candidate& c) { return c.distance <= farthest; })
      - m_candidates.begin());
    return distance;
  }

  // May distances between the positions s < t be on the other side of the value than those at s and at t, which are
  // nearer, or farther? They are nearer if one path to both is. They are farther if all candidates are, by their values
  // at s, at t and in the middle: between the middle and one of these, a convex function is above the line through the
  // middle and the other one. The bound errs by the errors of three distances.
  // Requires: candidates that are the nearest between s and t have not been forgotten.
  bool may_cross(const FT& s, const FT& t, bool are_nearer, const FT& value) const
  {
    const auto first = points_on_edge(s), middle = points_on_edge(FT((s + t) / 2)), last = points_on_edge(t);
    for(std::size_t i = 0; i < m_active; ++i)
    {
      const Candidate& c = m_candidates[i];
      const FT farther = (std::max)(distance_by(c, first[c.side]), distance_by(c, last[c.side]));
      if(are_nearer && farther < value)
        return false;
      if(!are_nearer)
      {
        const FT in_middle = distance_by(c, middle[c.side]);
        if((std::min)(in_middle, FT(2 * in_middle - farther)) < value)
          return true;
      }
    }
    return are_nearer;
  }

private:
  enum Kind : unsigned char { CORNER, WINDOW, STRIP };

  // A window or a strip that has entered across a side, or the corner at the origin of the side. A strip has its
  // direction in place of the image.
  struct Candidate
  {
    Kept_window<FT> window;
    FT root_distance; // or that of the corner, or of the ray of a strip through the origin of the side
    unsigned int side;
    Kind kind;
    FT distance = 0; // at the last point
  };

  // Returns a point in the frames of the three sides.
  std::array<std::array<FT, 2>, 3> points_in_frames(const std::array<FT, 3>& b) const
  {
    return {{point_in_frame(m_frame[0], b, 0), point_in_frame(m_frame[1], b, 1), point_in_frame(m_frame[2], b, 2)}};
  }

  std::array<std::array<FT, 2>, 3> points_on_edge(const FT& t) const
  {
    return points_in_frames(coordinates_on_halfedge(m_halfedge, t));
  }

  // Returns the length of the path through a candidate to a point in the frame of its side.
  static FT distance_by(const Candidate& c, const std::array<FT, 2>& p)
  {
    const Kept_window<FT>& w = c.window;
    if constexpr(Strips::exist)
      if(c.kind == STRIP)
        return arrival_of_ray(Strip<FT>{w.begin, w.end, w.image_x, w.image_depth, c.root_distance, FT(0), 0, 0}, p[0],
                              p[1]).distance;
    FT abscissa;
    return c.kind == CORNER ? FT(c.root_distance + norm(p[0], p[1]))
                            : distance_through_window(w, c.root_distance, p[0], p[1], abscissa);
  }

  std::array<Face_frame<FT>, 3> m_frame; // of the sides
  std::vector<Candidate> m_candidates;
  std::size_t m_active = 0;
  Halfedge_id m_halfedge = null_id; // of the edge that was started
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_FACE_DISTANCES_H
