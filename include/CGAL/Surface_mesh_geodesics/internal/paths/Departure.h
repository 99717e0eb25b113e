// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_DEPARTURE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_DEPARTURE_H

// The direction in which a path leaves its source, as an angle around the source in the mesh that has the sources as
// vertices. With the distance it is the logarithmic map. All angles count counterclockwise.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Straight_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A path leaves the source of `halfedge` through its face, at an angle from the halfedge. A path of no length has none.
template <typename FT>
struct Departure
{
  Halfedge_id halfedge = null_id;
  FT angle = 0;
};

// A direction in the tangent frame of a source. At a vertex of the border it is the angle from the first halfedge,
// which may exceed a full circle; elsewhere full circles do not matter.
struct Direction_at_source
{
  double angle = 0;
  bool is_at_border = false;
};

// The angle of the face of h at the source of h, in [0, pi].
template <typename FT>
FT corner_angle(const Intrinsic_mesh<FT>& mesh, Halfedge_id h)
{
  using std::atan2;
  const auto direction = angle_direction(mesh.face(face_of(h)), index_in_face(h));
  return atan2(direction.second, direction.first);
}

// Returns the halfedge of face f that leaves v. Requires: v is a corner of f.
template <typename FT>
Halfedge_id halfedge_from(const Intrinsic_mesh<FT>& mesh, Face_id f, Vertex_id v)
{
  unsigned int k = 0;
  while(mesh.face(f).vertex[k] != v)
  {
    ++k;
    CGAL_assertion(k < 3);
  }
  return halfedge_of(f, k);
}

// A frame in the plane of another one: its origin and the direction of its axis.
template <typename FT>
struct Unfolded_frame
{
  FT x = 0, y = 0, cosine = 1, sine = 0;

  Planar_point<FT> point(const FT& px, const FT& py) const
  {
    return {FT(x + cosine * px - sine * py), FT(y + sine * px + cosine * py)};
  }

  // Moves it to a side that begins at a point of the frame and leads in a direction there, which is given by its cosine
  // and sine. Neither is divided by anything, so a short side turns the frame as exactly as a long one.
  void move(const FT& px, const FT& py, const FT& c, const FT& s)
  {
    const Planar_point<FT> origin = point(px, py);
    *this = {origin.x, origin.y, FT(cosine * c - sine * s), FT(sine * c + cosine * s)};
  }
};

// The first edge that a path crosses may be so near the source that rounding of the point there turns the direction by
// any angle: a source beside an edge has thin faces around it. So the faces are unfolded as far as the path is
// straight, and the last point counts. Turning from face to face adds a few epsilon to the direction, whatever their
// shape.
//
// A path that rounding leads through a vertex may bend there by as much, so it is followed no farther.
//
// Returns the angle of a path from h, which leaves the source in the first face of the path. Requires: the path crosses
// the edge of that face that is opposite to the source. Linear in the number of faces of the straight piece.
template <typename FT>
FT angle_of_straight_piece(const Intrinsic_mesh<FT>& mesh, const Path_steps<FT>& steps, Halfedge_id h)
{
  using std::atan2;
  const FT corner = corner_angle(mesh, h);
  Unfolded_frame<FT> frame; // of h
  Planar_point<FT> last{FT(1), FT(0)};
  for(std::size_t i = steps.size() - 1; i-- > 0 && h != null_id && steps[i + 1].face == face_of(h);)
  {
    const Path_step<FT>& step = steps[i];
    const Face_frame<FT> c = mesh.face_frame(h);
    if(step.vertex != null_id)
    {
      if(step.vertex == c.apex)
        last = frame.point(c.apex_x, c.apex_y);
      break;
    }
    const Halfedge_id left = previous_halfedge(h), right = next_halfedge(h);
    // On a surface that is glued to itself, both sides may have the same neighbor.
    const bool is_right = step.halfedge == right || (step.halfedge != left && step.halfedge == c.right);
    const FT& length = is_right ? c.right_length : c.left_length;
    if((!is_right && step.halfedge != left && step.halfedge != c.left) || !(length > 0))
      break;
    if(is_right) // from the apex to the target
      frame.move(c.apex_x, c.apex_y, FT(c.apex_rest / length), FT(-c.apex_y / length));
    else // from the origin to the apex
      frame.move(FT(0), FT(0), FT(c.apex_x / length), FT(c.apex_y / length));
    // The step may name either halfedge of the edge; the frame is now that of the outer one.
    const bool is_inner = step.halfedge == (is_right ? right : left);
    last = frame.point(is_inner ? FT(length - step.x) : step.x, FT(0));
    h = is_right ? c.right : c.left;
  }
  return (std::min)((std::max)(FT(atan2(last.y, last.x)), FT(0)), corner);
}

// Returns the departure of a path from the vertex at its end. Requires: the last step of the path is a vertex. The
// point before it is another corner of the last face, or on an edge of that face.
template <typename FT>
Departure<FT> departure(const Intrinsic_mesh<FT>& mesh, const Path_steps<FT>& steps)
{
  Departure<FT> result;
  if(steps.size() < 2)
    return result;
  const Path_step<FT>&last = steps.back(), &before = steps[steps.size() - 2];
  result.halfedge = halfedge_from(mesh, last.face, last.vertex);
  if(before.vertex != null_id)
  {
    result.angle = before.vertex == mesh.target(result.halfedge) ? FT(0) : corner_angle(mesh, result.halfedge);
    return result;
  }
  const Halfedge_id h
    = face_of(before.halfedge) == last.face ? before.halfedge : mesh.opposite(before.halfedge);
  if(h == next_halfedge(result.halfedge))
    result.angle = angle_of_straight_piece(mesh, steps, result.halfedge);
  else if(h != result.halfedge) // along the other side
    result.angle = corner_angle(mesh, result.halfedge);
  return result;
}

// Returns the departure of the straight path from corner v of face f to the point b of the face.
template <typename FT>
Departure<FT> departure_to_point(const Intrinsic_mesh<FT>& mesh, Vertex_id v, Face_id f, const Barycentric<FT>& b)
{
  using std::atan2;
  Departure<FT> result;
  result.halfedge = halfedge_from(mesh, f, v);
  const Face_frame<FT> c = mesh.face_frame(result.halfedge);
  const unsigned int k = index_in_face(result.halfedge);
  result.angle = atan2(FT(b[previous_corner(k)] * c.apex_y),
                       FT(b[next_corner(k)] * c.length + b[previous_corner(k)] * c.apex_x));
  return result;
}

// The angle around a vertex from a reference to a departure, and the angle of all faces around it.
template <typename FT>
struct Angle_around
{
  FT angle = 0;       // from the reference, or from the first halfedge if the umbrella has a border
  FT total = 0;       // of a closed umbrella
  bool is_closed = false;
  bool has_reference = false; // whether it is in the umbrella
};

// Returns the angle of a departure from a reference: is_reference(h) says whether the halfedge h, which leaves the same
// vertex, is it. At a border without a reference, and in an umbrella without it, angles count from the first halfedge.
// Linear in the number of faces of the umbrella.
template <typename FT, typename IsReference>
Angle_around<FT> angle_around(const Intrinsic_mesh<FT>& mesh, const Departure<FT>& d, IsReference is_reference)
{
  Angle_around<FT> result;
  // Clockwise from the departure, to the border or once around.
  FT angle = d.angle;
  Halfedge_id h = d.halfedge;
  do
  {
    if(!result.has_reference && is_reference(h))
    {
      result.angle = angle;
      result.has_reference = true;
    }
    const Halfedge_id g = mesh.previous_around_source(h);
    if(g == null_id)
      break;
    const FT corner = corner_angle(mesh, g);
    angle += corner;
    result.total += corner;
    h = g;
  } while(h != d.halfedge);
  result.is_closed = mesh.previous_around_source(h) != null_id;
  if(result.has_reference)
    return result;
  result.angle = result.is_closed ? d.angle : angle;
  if(result.is_closed)
    return result;
  // Counterclockwise, for a reference that comes later.
  angle = d.angle;
  for(h = d.halfedge; h != null_id; h = mesh.next_around_source(h))
  {
    if(is_reference(h))
    {
      result.angle = angle;
      result.has_reference = true;
      return result;
    }
    angle -= corner_angle(mesh, h);
  }
  return result;
}

// Returns the angle from a side of a face to side k of one of its parts, and the area of the part as a measure of how
// well it is known. `corner` are the corners of the part in the face, as coordinates; the side of the face leads from
// its corner `first` to the next one.
//
// The part is laid out in the plane. The side of the face is a combination of two sides of the part, with the factors
// that its coordinates have.
template <typename FT>
std::array<FT, 2> angle_to_side_of_part(const Intrinsic_face<FT>& part, const std::array<Barycentric<FT>, 3>& corner,
                                        unsigned int k, unsigned int first)
{
  using std::abs;
  using std::atan2;
  const std::array<Planar_point<FT>, 3> p = layout_of_face(part);
  const unsigned int k1 = next_corner(k), k2 = previous_corner(k);
  const unsigned int i = first, j = next_corner(first);
  // In the coordinates i and j, the side of the face is (-1, 1).
  const FT ui = corner[k1][i] - corner[k][i], uj = corner[k1][j] - corner[k][j];
  const FT vi = corner[k2][i] - corner[k][i], vj = corner[k2][j] - corner[k][j];
  const FT area = ui * vj - uj * vi;
  if(!(area > 0) && !(area < 0))
    return {FT(0), FT(0)};
  const FT s = (-vj - vi) / area, t = (ui + uj) / area;
  const FT ux = p[k1].x - p[k].x, uy = p[k1].y - p[k].y, vx = p[k2].x - p[k].x, vy = p[k2].y - p[k].y;
  const FT x = s * ux + t * vx, y = s * uy + t * vy;
  return {FT(atan2(FT(x * uy - y * ux), FT(x * ux + y * uy))), FT(abs(area))};
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_DEPARTURE_H
