// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_STRAIGHTEST_WALK_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_STRAIGHTEST_WALK_H

// The straightest geodesic from a location: straight in each face, straight across an edge when both of its faces are
// laid out in one plane, and with equal angles on both sides at a vertex.
//
// At a vertex inside the surface this is unique, also where the total angle is not 2 pi: half of it is on each side.
// The walk ends where nothing is straight on: at the border, at a vertex whose angles mean nothing, and in faces
// without area that it cannot leave.
//
// In each face the walk is a ray from a point with barycentric coordinates. On which side of the ray a corner lies is
// the sign of a cross product; the ray leaves across the edge from a corner on its right to one on its left. A point
// within Tolerance::barycentric() of a vertex is the vertex, as it is for every location of the package.
//
// Error. The direction is turned from frame to frame, which adds an error of a few epsilon for each face. After n faces
// the end is off by the order of n epsilon of the length. Positions on edges are fractions of the edge from both of its
// ends, so they lose nothing near an end.

#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/Face_layout.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/Layouts_with_walls.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/Vertex_fan.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Formula: from side to side, the direction turns by the exterior angle, pi minus the angle at the corner between them;
// after three sides by a full turn.
//
// Returns the angle from the direction of halfedge(f, tm) to that of the halfedge h of the face f: the first halfedge,
// the second or the third, by the exterior angles between them. `layout` is the face in the frame of h.
template <typename TriangleMesh>
double angle_of_side(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, const Face_layout& layout,
                     const TriangleMesh& tm)
{
  const auto first = halfedge(face(h, tm), tm);
  if(h == first)
    return 0;
  return h == next(first, tm) ? half_turn - layout.angle(0) : half_turn + layout.angle(1);
}

// The order of corners differs by a rotation only, so coordinates are permuted and keep their bits.
//
// Returns the coordinates b of a face, whose first corner is the source of h, in the order of the user's corners, which
// begins at the source of halfedge(f, tm).
template <typename TriangleMesh>
Barycentric<double> users_coordinates(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                                      const Barycentric<double>& b, const TriangleMesh& tm)
{
  const auto first = halfedge(face(h, tm), tm);
  const unsigned int k = h == first ? 0 : h == next(first, tm) ? 1 : 2;
  Barycentric<double> user;
  for(unsigned int i = 0; i < 3; ++i)
    user[corner_after(k, i)] = b[i];
  return user;
}

// Use: construct, then walk() once. The state between two faces is a ray: a point of a face, a direction, and how the
// ray begins. Each step follows the ray to the border of its face, and makes the next ray in the face behind it. A step
// that ends the walk sets the direction and the end of the result, and returns false.
//
// `Result` is the class that the public function returns (Traced_geodesic): the walk appends its locations, and sets
// its length, its direction and its end. An object serves for one walk.
template <typename TriangleMesh, typename Layouts, typename Result>
class Straightest_walk
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Coordinates = Barycentric<double>;
  using Vector = Planar_point<double>;
  using Fan = Vertex_fan<TriangleMesh>;

public:
  Straightest_walk(const TriangleMesh& tm, const Layouts& layouts, Result& result)
    : m_tm(tm), m_layouts(layouts), m_result(result)
  {}

  // Walks from the point b of face f. Requires: b is valid and snapped, `direction` is finite, and `length` is finite
  // and not negative. Linear in the number of faces crossed, and of those around the vertices that are passed; plus one
  // count of the faces of the mesh if rounding leaves no length in one of them.
  void walk(face_descriptor f, const Coordinates& b, double direction, double length)
  {
    m_rest = m_whole = length;
    add_location(halfedge(f, m_tm), b);
    if(!start(f, b, direction))
      return;
    // Each step gets farther, or passes a face in which rounding leaves no length. A walk that gets no farther has run
    // into faces without area, around which it might turn forever. (A filtered graph counts its faces in each call.)
    std::size_t standstills = 0, number_of_faces = 0;
    while(cross_face(standstills))
    {
      if(standstills > 0 && number_of_faces == 0)
        number_of_faces = num_faces(m_tm);
      if(standstills > number_of_faces)
      {
        end_in_face(m_b, Result::AT_SINGULARITY);
        return;
      }
    }
  }

private:
  // Where a ray begins in the face of m_halfedge, so that it cannot leave there at once.
  enum class Start { INSIDE, ON_EDGE_AB, AT_CORNER_A };

  // The vector from the beginning of the ray to that point is in `way`, in the frame and the unit of the face.
  //
  // Where a ray leaves a face: on the edge from corner k, at the fraction u; rest == 1 - u. A corner k has u == 0.
  struct Exit
  {
    unsigned int k;
    double u, rest;
    Vector way;
  };

  // Sets the first ray. Returns false if the walk has ended. How many of the coordinates are zero tells where the
  // location is: none inside, one on an edge, two at a vertex. (They are snapped, so zeros are exact.)
  bool start(face_descriptor f, const Coordinates& b, double direction)
  {
    const std::size_t zeros = static_cast<std::size_t>(std::count(b.begin(), b.end(), 0.));
    halfedge_descriptor h = halfedge(f, m_tm);
    if(zeros == 0)
    {
      const double angle = reduced_angle(direction, full_turn);
      enter(h, b, {std::cos(angle), std::sin(angle)}, Start::INSIDE);
      if(m_layout.has_area())
        return true;
      return end_in_face(b, Result::AT_SINGULARITY);
    }
    // The halfedge at whose source the location is, or on which it lies.
    unsigned int k = 0;
    while(zeros == 2 ? b[k] == 0 : b[previous_corner(k)] != 0)
    {
      h = next(h, m_tm);
      ++k;
    }
    if(zeros == 2)
      return start_at_vertex(h, direction);
    return start_on_edge(h, b[k], b[next_corner(k)], direction);
  }

  // `a` and `b` are the coordinates of the source and the target of h, on which the location lies. The direction counts
  // in the frame of the face of h. A ray to the right of h begins in the face across, where the same edge runs the
  // other way: the vector changes its sign.
  bool start_on_edge(halfedge_descriptor h, double a, double b, double direction)
  {
    const double turn = reduced_angle(reduced_angle(direction, full_turn) - angle_of_side(h, m_layouts(h), m_tm),
                                      full_turn);
    const halfedge_descriptor o = opposite(h, m_tm);
    // Along the border, rounding must not lead out of the surface.
    const bool is_end = is_end_of_surface(o, m_tm, m_layouts);
    const double outward = is_end ? Tolerance<double>::barycentric() : 0.;
    const bool is_inward = turn <= half_turn + outward || full_turn - turn <= outward;
    const Vector d{std::cos(turn), is_inward ? (std::max)(std::sin(turn), 0.) : std::sin(turn)};
    if(is_inward || is_end || !(m_rest > 0))
    {
      enter(h, {a, b, 0}, d, Start::ON_EDGE_AB);
      return is_inward || end_in_face(m_b, Result::AT_BORDER);
    }
    enter(o, {b, a, 0}, {-d.x, -d.y}, Start::ON_EDGE_AB);
    return true;
  }

  // The location is the source of h. At the border, an angle beyond the last face leads out of the surface.
  bool start_at_vertex(halfedge_descriptor h, double direction)
  {
    const Fan fan(h, m_tm, m_layouts);
    if(!fan.has_angles())
      return end_at_vertex(0, Result::AT_SINGULARITY);
    const double angle = fan.unscaled(direction);
    if(!(m_rest > 0))
      return end_at_vertex(fan.scaled(angle), Result::AT_LENGTH);
    if(angle > fan.total_angle())
      return end_at_vertex(angle, Result::AT_BORDER);
    leave_vertex(fan, angle);
    return true;
  }

  // Begins a ray at the point b of the face of h, in the frame of h. The vector d may have any length that is not zero;
  // std::hypot() keeps that of a face that is very thin.
  void enter(halfedge_descriptor h, const Coordinates& b, const Vector& d, Start start)
  {
    m_halfedge = h;
    m_layout = m_layouts(h);
    m_b = b;
    m_start = start;
    const double length = std::hypot(d.x, d.y);
    m_d = {d.x / length, d.y / length};
  }

  // Goes on from a vertex at an angle of its fan. The first location of the next segment is already in the result.
  void leave_vertex(const Fan& fan, double angle)
  {
    const typename Fan::Sector& sector = fan.sector_at(angle);
    const double turn = angle - sector.angle;
    enter(sector.halfedge, {1, 0, 0}, {std::cos(turn), std::sin(turn)}, Start::AT_CORNER_A);
  }

  // Follows the ray through its face. Returns false if the walk has ended. The end of the walk divides the segment of
  // this face in the ratio of lengths, so its coordinates are combinations of those of the ends of the segment: no
  // division by an area, which may be tiny. `standstills` counts the faces in a row in which the walk has got no
  // farther.
  bool cross_face(std::size_t& standstills)
  {
    const Exit exit = find_exit();
    const double way = std::hypot(exit.way.x, exit.way.y) * m_layout.unit();
    Coordinates b{0, 0, 0};
    b[exit.k] = exit.rest;
    b[next_corner(exit.k)] = exit.u;
    if(!(way < m_rest))
    {
      const double part = way > 0 ? m_rest / way : 0.;
      for(std::size_t i = 0; i < 3; ++i)
        b[i] = (1 - part) * m_b[i] + part * b[i];
      m_result.length = m_whole;
      return end_on_way(b);
    }
    const double length = m_result.length + way;
    standstills = length > m_result.length ? 0 : standstills + 1;
    m_result.length = length;
    m_rest -= way;
    add_location(m_halfedge, b);
    return exit.u > 0 ? cross_edge(exit) : pass_vertex(exit.k);
  }

  // On which side of the ray is corner k? Positive on the left. A corner at which the ray begins, and the ends of an
  // edge on which it begins, are on the side where they have to be, also after rounding.
  double side_of(unsigned int k, const Vector& to_corner) const
  {
    const double side = m_d.x * to_corner.y - m_d.y * to_corner.x;
    if(m_start == Start::AT_CORNER_A)
      return k == 0 ? 0 : k == 1 ? (std::min)(side, 0.) : (std::max)(side, 0.);
    if(m_start == Start::ON_EDGE_AB && k < 2)
      return k == 1 ? (std::min)(side, 0.) : (std::max)(side, 0.);
    return side;
  }

  // Where the ray leaves its face. From the inside, exactly one edge has its first corner on the right of the ray and
  // its second one on the left or on the ray: a ray meets the border of a triangle once. From an edge or a corner, the
  // edges at which the ray begins do not count.
  //
  // Formula: with the cross products r < 0 and l >= 0 of the direction and the vectors to the two corners, the ray
  // divides the edge at the fraction -r / (l - r). Law: mirroring the face exchanges the fractions u and rest, bit by
  // bit.
  Exit find_exit() const
  {
    std::array<Vector, 3> to;
    std::array<double, 3> side;
    for(unsigned int k = 0; k < 3; ++k)
    {
      to[k] = m_layout.to_corner(m_b, k);
      side[k] = side_of(k, to[k]);
    }
    unsigned int k = 1;
    if(m_start == Start::ON_EDGE_AB)
      k = side[2] > 0 || (side[2] == 0 && m_d.x > 0) ? 1 : 2;
    else if(m_start == Start::INSIDE)
      for(k = 0; k < 2 && !(side[k] < 0 && side[next_corner(k)] >= 0);)
        ++k;
    const unsigned int k1 = next_corner(k);
    const double width = side[k1] - side[k];
    if(!(width > 0))
      return exit_at_corner(nearest_ahead(to), to);
    const double u = -side[k] / width, rest = side[k1] / width;
    if(u <= Tolerance<double>::barycentric())
      return exit_at_corner(k, to);
    if(rest <= Tolerance<double>::barycentric())
      return exit_at_corner(k1, to);
    return {k, u, rest, {rest * to[k].x + u * to[k1].x, rest * to[k].y + u * to[k1].y}};
  }

  // The ray leaves through corner k: a location of the package that is this near to a vertex is the vertex.
  static Exit exit_at_corner(unsigned int k, const std::array<Vector, 3>& to) { return {k, 0, 1, to[k]}; }

  // All corners are on the line of the ray, as the face has no height: returns the nearest one ahead. If none is ahead,
  // the walk stands still at a corner and goes on there.
  unsigned int nearest_ahead(const std::array<Vector, 3>& to) const
  {
    unsigned int nearest = 0;
    double least = -1;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const double ahead = m_d.x * to[k].x + m_d.y * to[k].y;
      if(ahead > 0 && (least < 0 || ahead < least))
      {
        nearest = k;
        least = ahead;
      }
    }
    return nearest;
  }

  // Goes on in the face across an edge. Its frame is that of the opposite halfedge, which runs from corner k + 1 to
  // corner k. The ray leads away from the edge, so rounding must not turn it back.
  bool cross_edge(const Exit& exit)
  {
    const halfedge_descriptor h = halfedge_at(exit.k), o = opposite(h, m_tm);
    if(is_end_of_surface(o, m_tm, m_layouts))
    {
      Coordinates b{0, 0, 0};
      b[exit.k] = exit.rest;
      b[next_corner(exit.k)] = exit.u;
      m_result.locations.pop_back();
      return end_in_face(b, Result::AT_BORDER);
    }
    const Vector& side = m_layout.side(exit.k);
    const double x = -(m_d.x * side.x + m_d.y * side.y), y = m_d.x * side.y - m_d.y * side.x;
    enter(o, {exit.u, exit.rest, 0}, {x, (std::max)(y, 0.)}, Start::ON_EDGE_AB);
    return true;
  }

  // Goes on behind corner k, straight: the angles on both sides of the walk are equal. Ends at a border. (In a pinched
  // vertex the walk stays in its umbrella.)
  bool pass_vertex(unsigned int k)
  {
    const halfedge_descriptor h = halfedge_at(k);
    const Fan fan(h, m_tm, m_layouts);
    const double back = angle_back(fan, h, k);
    if(!fan.has_angles())
      return end_at_vertex(0, Result::AT_SINGULARITY);
    if(!fan.is_closed())
      return end_at_vertex(reduced_angle(back + half_turn, full_turn), Result::AT_BORDER);
    leave_vertex(fan, reduced_angle(back + fan.total_angle() / 2, fan.total_angle()));
    return true;
  }

  // The angle of the fan of corner k at which the walk has arrived, seen from the vertex. It is measured from the
  // direction of the ray, not from the point where the ray began: that keeps the digits of a short segment. Rounding
  // must not move it out of the face. `h` leaves the vertex in the face of the ray.
  double angle_back(const Fan& fan, halfedge_descriptor h, unsigned int k) const
  {
    const Vector& side = m_layout.side(k);
    const double turn = std::atan2(side.y * m_d.x - side.x * m_d.y, -(side.x * m_d.x + side.y * m_d.y));
    return fan.angle(h) + (std::min)((std::max)(turn, 0.), m_layout.angle(k));
  }

  // The length is walked: ends at the point b of the face of the ray. If that is a vertex, the direction is the one in
  // which the walk would leave it.
  bool end_on_way(Coordinates b)
  {
    snap_coordinates(b);
    if(std::count(b.begin(), b.end(), 0.) < 2)
      return end_in_face(b, Result::AT_LENGTH);
    const unsigned int k = nearest_corner(b);
    add_location(m_halfedge, b);
    const halfedge_descriptor h = halfedge_at(k);
    const Fan fan(h, m_tm, m_layouts);
    if(!fan.has_angles())
      return end_at_vertex(0, Result::AT_LENGTH);
    if(m_start == Start::AT_CORNER_A && k == 0) // it has not left the vertex
      return end_at_vertex(fan.scaled(fan.angle(h) + std::atan2(m_d.y, m_d.x)), Result::AT_LENGTH);
    const double back = angle_back(fan, h, k);
    return end_at_vertex(fan.is_closed() ? fan.scaled(back + fan.total_angle() / 2)
                                         : reduced_angle(back + half_turn, full_turn),
                         Result::AT_LENGTH);
  }

  // Ends at the point b of the face of the ray. A walk of no length keeps the location that the user gave.
  bool end_in_face(const Coordinates& b, typename Result::End end)
  {
    const Coordinates user = users_coordinates(m_halfedge, b, m_tm);
    if(m_result.locations.size() > 1 || m_result.length > 0)
      m_result.locations.emplace_back(face(m_halfedge, m_tm), user);
    m_result.direction = reduced_angle(std::atan2(m_d.y, m_d.x) + angle_of_side(m_halfedge, m_layout, m_tm),
                                       full_turn);
    return set_end(end);
  }

  // Ends at the vertex of the last location, which the caller has appended. (The start is such a location, too.) The
  // direction is that of users, scaled where the umbrella is closed.
  bool end_at_vertex(double direction, typename Result::End end)
  {
    m_result.direction = direction;
    return set_end(end);
  }

  // A walk that has no length left has got there, whatever it meets.
  bool set_end(typename Result::End end)
  {
    m_result.end = m_rest > 0 ? end : Result::AT_LENGTH;
    return false;
  }

  // The halfedge of the face that leaves corner k.
  halfedge_descriptor halfedge_at(unsigned int k) const
  {
    const halfedge_descriptor h1 = next(m_halfedge, m_tm);
    return k == 0 ? m_halfedge : k == 1 ? h1 : next(h1, m_tm);
  }

  // Appends the point b of the face of h.
  void add_location(halfedge_descriptor h, const Coordinates& b)
  {
    m_result.locations.emplace_back(face(h, m_tm), users_coordinates(h, b, m_tm));
  }

  const TriangleMesh& m_tm;
  const Layouts& m_layouts;
  Result& m_result;
  // The ray: it begins at the point m_b of the face of m_halfedge, and has the unit vector m_d in the frame of that
  // halfedge, in which m_layout is the face.
  halfedge_descriptor m_halfedge = Graph_traits::null_halfedge();
  Face_layout m_layout;
  Coordinates m_b{};
  Vector m_d;
  Start m_start = Start::INSIDE;
  double m_whole = 0, m_rest = 0; // the length to walk, and what is left of it, in the user's unit
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_STRAIGHTEST_WALK_H
