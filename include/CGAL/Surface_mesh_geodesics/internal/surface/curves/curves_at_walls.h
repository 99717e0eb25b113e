// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_CURVES_AT_WALLS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_CURVES_AT_WALLS_H

// Curves that are sources, beside walls. A curve is a set of points, and a point of a wall belongs to all of its sides;
// so the curve is a source on each of them. In the surface that is cut along the walls, it becomes several pieces:
//
// - where it crosses a wall, it ends on one side, and begins anew on the other;
// - where it runs along a wall, a second piece runs along the other side;
// - where a point of it touches a wall, or is a vertex that walls divide, there is a point on each other side.
//
// All pieces have the number and the segments of the curve that they are parts of, so the foot of a path is a point of
// that one, whichever side it is on.
//
// Why this is right: the distance from a curve is the least one from its points. Each point of the curve is, on each
// side of the walls there, in some piece; and each piece consists of such points. Pieces that meet in a vertex of the
// cut mesh share it, as they would if they were one; where a piece ends, paths leave it in all directions.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Divides curves of one surface. copies.for_each(v, visit) calls visit(c) for all copies of a vertex, as Vertex_copies
// does, and location_behind_wall(f, c) returns the same point on the other side of a wall: a halfedge of the face there
// and the coordinates; null_id if it is on no wall, or at a vertex. The mesh is the one that is cut, without inserted
// sources. All three are referred to.
template <typename FT, typename Copies, typename LocationBehindWall>
class Curve_division
{
  using Mesh = Intrinsic_mesh<FT>;
  using Segment = Curve_segment<FT>;
  using Curve = Located_curve<FT>;

public:
  Curve_division(const Mesh& mesh, const Copies& copies, const LocationBehindWall& location_behind_wall)
    : m_mesh(mesh), m_copies(copies), m_location_behind_wall(location_behind_wall)
  {}

  // Appends the pieces of a curve. Takes time linear in the number of segments and of copies.
  void append_pieces(const Curve& curve, std::vector<Curve>& pieces) const
  {
    if(curve.segments.empty())
    {
      m_copies.for_each(curve.vertex, [&](Vertex_id c)
      {
        pieces.push_back(curve);
        pieces.back().vertex = c;
      });
      return;
    }
    // As the insertion will snap them: what is up to rounding on an edge is on the wall there.
    Curve snapped = curve;
    for(Segment& s : snapped.segments)
    {
      snap_coordinates(s.from);
      snap_coordinates(s.to);
    }
    append_chains(snapped, pieces);
    append_other_sides(snapped, pieces);
    append_points(snapped, pieces);
  }

private:
  // A new piece of a curve, open and without segments yet. It has the number of the curve, and distances from it begin
  // with the same offset.
  static Curve& begin_piece(const Curve& curve, std::vector<Curve>& pieces)
  {
    pieces.emplace_back();
    pieces.back().number = curve.number;
    pieces.back().offset = curve.offset;
    return pieces.back();
  }

  // The curve itself, divided where it crosses a wall. A closed curve that crosses one begins behind a crossing, so
  // that its first point does not divide it once more.
  void append_chains(const Curve& curve, std::vector<Curve>& pieces) const
  {
    const std::vector<Segment>& segments = curve.segments;
    const std::size_t n = segments.size();
    std::size_t first = 0;
    if(curve.is_closed)
    {
      while(first < n && is_joined(segments[(first + n - 1) % n], segments[first]))
        ++first;
      if(first == n)
      {
        pieces.push_back(curve);
        return;
      }
    }
    for(std::size_t i = 0; i < n; ++i)
    {
      const Segment& s = segments[(first + i) % n];
      if(i == 0 || !is_joined(segments[(first + i - 1) % n], s))
        begin_piece(curve, pieces);
      pieces.back().segments.push_back(s);
    }
  }

  // The segments along walls on the other side. Neighbors are one piece where they meet in one vertex there. In a
  // closed curve, the last one and the first one may be two pieces that meet: they share the vertex.
  void append_other_sides(const Curve& curve, std::vector<Curve>& pieces) const
  {
    Segment last{}; // on the other side, the segment before
    bool has_last = false;
    for(const Segment& s : curve.segments)
    {
      Segment other = s;
      if(!is_behind_wall(s, other))
        continue;
      if(!has_last || last.number + 1 != s.number || !is_joined(last, other))
        begin_piece(curve, pieces);
      pieces.back().segments.push_back(other);
      last = other;
      has_last = true;
    }
  }

  // The points of the curve on all other sides. A curve that crosses a wall is on both of its sides already: another
  // point there would be a second vertex beside the first, if rounding tells them apart. A point that a piece has
  // already does no harm at a vertex, as the insertion keeps one of equal sources.
  void append_points(const Curve& curve, std::vector<Curve>& pieces) const
  {
    const std::vector<Segment>& segments = curve.segments;
    for(std::size_t i = 0; i < segments.size(); ++i)
    {
      const Segment& s = segments[i];
      const bool has_neighbor = i > 0 || curve.is_closed;
      const Segment& before = segments[(i + segments.size() - 1) % segments.size()];
      append_point(curve, s, s.from, s.parameter, has_neighbor && before.face != s.face, pieces);
    }
    if(!curve.is_closed)
      append_point(curve, segments.back(), segments.back().to, FT(1), false, pieces);
  }

  // A point is a segment without length, as sources in faces beside curves are. Its parameter is that of the point in
  // the segment of the user.
  void append_point(const Curve& curve, const Segment& s, const Barycentric<FT>& at, const FT& parameter,
                    bool is_on_both_sides, std::vector<Curve>& pieces) const
  {
    const auto append = [&](Face_id f, const Barycentric<FT>& c)
    { begin_piece(curve, pieces).segments.push_back(Segment{f, c, c, s.number, parameter}); };
    const Vertex_id v = vertex_at(s.face, at);
    if(v != null_id)
      m_copies.for_each(v, [&](Vertex_id c)
      {
        const Halfedge_id h = m_mesh.halfedge(c);
        if(c == v || h == null_id)
          return;
        Barycentric<FT> corner{};
        corner[index_in_face(h)] = 1;
        append(face_of(h), corner);
      });
    else if(!is_on_both_sides)
    {
      const auto behind = m_location_behind_wall(s.face, at);
      if(behind.first != null_id)
        append(face_of(behind.first), behind.second);
    }
  }

  // Is the end of a segment the beginning of the next one in the surface that is cut? Where rounding leaves doubt, it
  // is not: two pieces that nearly meet are right, one piece across a wall is not.
  bool is_joined(const Segment& a, const Segment& b) const
  {
    using std::abs;
    if(a.face == b.face && abs(a.to[0] - b.from[0]) + abs(a.to[1] - b.from[1]) < Tolerance<FT>::location())
      return true;
    const Vertex_id v = vertex_at(a.face, a.to), w = vertex_at(b.face, b.from);
    if(v != null_id || w != null_id)
      return v == w;
    return m_location_behind_wall(a.face, a.to).first == null_id;
  }

  // The vertex at a corner, which is the copy that has the sector of the face; null_id for other points.
  // Requires: the coordinates are snapped.
  Vertex_id vertex_at(Face_id f, const Barycentric<FT>& at) const
  {
    for(unsigned int k = 0; k < 3; ++k)
      if(at[k] == 1)
        return m_mesh.face(f).vertex[k];
    return null_id;
  }

  // A segment along an edge has two ends with the same zero. (One without length at a vertex has its point as middle,
  // which is on no wall.)
  //
  // Is a segment on a wall? Sets `other` to the same segment on its other side. The point in the middle tells the face
  // there; the two coordinates on the edge change places, as its halfedges run against each other.
  bool is_behind_wall(const Segment& s, Segment& other) const
  {
    for(unsigned int k = 0; k < 3; ++k)
    {
      const unsigned int l = next_corner(k), apex = previous_corner(k);
      if(s.from[apex] != 0 || s.to[apex] != 0)
        continue;
      Barycentric<FT> middle{};
      middle[k] = (s.from[k] + s.to[k]) / 2;
      middle[l] = (s.from[l] + s.to[l]) / 2;
      const auto behind = m_location_behind_wall(s.face, middle);
      if(behind.first == null_id)
        continue;
      unsigned int j = 0; // the edge there; its apex has the coordinate 0
      while(behind.second[previous_corner(j)] != 0)
        ++j;
      other.face = face_of(behind.first);
      for(const auto& ends : {std::make_pair(&s.from, &other.from), std::make_pair(&s.to, &other.to)})
      {
        *ends.second = Barycentric<FT>{};
        (*ends.second)[j] = (*ends.first)[l];
        (*ends.second)[next_corner(j)] = (*ends.first)[k];
      }
      return true;
    }
    return false;
  }

  const Mesh& m_mesh; // without inserted sources: its faces are those of the segments
  const Copies& m_copies;
  const LocationBehindWall& m_location_behind_wall;
};

// Replaces curves by their pieces, in the order of the curves; those of a curve begin with the curve itself, then come
// its other sides, then single points. So of several pieces that are equally near to a vertex, the curve itself counts.
// Takes time linear in the number of segments and of copies.
template <typename FT, typename Copies, typename LocationBehindWall>
void divide_curves_at_walls(const Intrinsic_mesh<FT>& mesh, const Copies& copies,
                            const LocationBehindWall& location_behind_wall, std::vector<Located_curve<FT>>& curves)
{
  const Curve_division<FT, Copies, LocationBehindWall> division(mesh, copies, location_behind_wall);
  std::vector<Located_curve<FT>> pieces;
  for(const Located_curve<FT>& curve : curves)
    division.append_pieces(curve, pieces);
  curves = std::move(pieces);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_CURVES_AT_WALLS_H
