// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_FACE_LAYOUT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_FACE_LAYOUT_H

// Single faces of the user's mesh, laid out in the plane. A traced geodesic reads only the faces that it crosses, so
// each face is read from the user's maps when it is needed, and checked then. Its lengths are divided by a power of two
// of its own: positions on edges are kept as fractions, which need no common unit.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/face_shape.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A face has its own unit, as neighbors may be of any sizes, and the products of lengths must neither overflow nor
// vanish. What crosses an edge is a fraction and a unit vector, which have no unit.
//
// A face ABC in the frame of its halfedge AB: A is the origin, B lies on the positive x axis, C above. Lengths are
// multiples of `unit`, a power of two.
class Face_layout
{
public:
  using Vector = Planar_point<double>;

  // A layout of nothing, to be assigned to.
  Face_layout() = default;

  // `shift` is the side that has become side 0 of the face, as set_shape_from_sides() returns it; side 0 of the caller
  // is AB.
  Face_layout(const Intrinsic_face<double>& face, unsigned int shift, double unit)
    : m_face(face), m_first(corners_to_first(shift)), m_unit(unit)
  {
    Face_frame<double> c;
    c.length = face.length[m_first];
    set_apex(face, m_first, c);
    m_side = {Vector{c.length, 0}, Vector{-c.apex_rest, c.apex_y}, Vector{-c.apex_x, -c.apex_y}};
  }

  double unit() const { return m_unit; }

  // The vector from corner k to the next one. The corners 0, 1 and 2 are A, B and C. The three vectors add up to zero,
  // up to rounding: each is accurate relative to its own length.
  const Vector& side(unsigned int k) const { return m_side[k]; }

  // The angle at corner k, in [0, pi]; 0 if one of its sides has no length. Errs by a few epsilon of itself, as the
  // layout rests on the shortest side.
  double angle(unsigned int k) const
  {
    const auto direction = angle_direction(m_face, corner_after(m_first, k));
    return std::atan2(direction.second, direction.first);
  }

  // Do the angles mean something: has each side a length?
  bool has_angles() const { return m_face.length[0] > 0; }

  // Does the face have an inside in which a direction means something?
  bool has_area() const { return m_face.length[0] > 0 && m_face.apex_y > 0; }

  // The vector from the point with the coordinates b to corner k. (As a sum of sides, it is accurate relative to its
  // length near the corner.)
  Vector to_corner(const Barycentric<double>& b, unsigned int k) const
  {
    const unsigned int k1 = next_corner(k), k2 = previous_corner(k);
    return {b[k2] * m_side[k2].x - b[k1] * m_side[k].x, b[k2] * m_side[k2].y - b[k1] * m_side[k].y};
  }

private:
  Intrinsic_face<double> m_face;
  unsigned int m_first = 0; // the corner of the face that is A
  double m_unit = 1;
  std::array<Vector, 3> m_side;
};

// Throws unless h is a halfedge of a triangle. The functions below call it first, as they would read other faces than
// they should: a mesh need not be triangulated where no geodesic comes.
template <typename TriangleMesh>
void check_triangle(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, const TriangleMesh& tm)
{
  if(next(next(next(h, tm), tm), tm) != h || next(h, tm) == h)
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::NOT_A_TRIANGLE,
                                 "a face of the geodesic is not a triangle");
}

// Layouts from the points of the vertices: operator() lays out the face of a halfedge. Refers to the mesh and copies
// the map; get() may return points by value or by reference.
//
// The differences of coordinates are scaled, not the coordinates: the difference of two doubles has one rounding, which
// a scaling by a power of two does not change. So a face has the same bits in all units, also far from the origin.
template <typename TriangleMesh, typename VertexPointMap>
class Layouts_from_points
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using Numbers = std::array<double, 3>;

public:
  static constexpr bool has_points = true;

  // There are no obstacles (Layouts_with_walls.h, Layouts_with_avoided_faces.h).
  static constexpr bool is_wall(halfedge_descriptor) { return false; }
  static constexpr bool is_avoided(face_descriptor) { return false; }

  Layouts_from_points(const TriangleMesh& tm, VertexPointMap vpm) : m_tm(tm), m_vpm(vpm) {}

  // Throws Invalid_geodesic_input if the face is not a triangle, or if a coordinate is not finite or too far from the
  // others. (The comparison is false for NaN.)
  Face_layout operator()(halfedge_descriptor h) const
  {
    const std::array<Numbers, 3> p = corners(h);
    double extent = 0;
    for(unsigned int k = 0; k < 3; ++k)
      for(std::size_t i = 0; i < 3; ++i)
      {
        const double e = std::abs(p[next_corner(k)][i] - p[k][i]);
        if(!(e <= largest_extent()))
          throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::NON_FINITE_POINT,
                                       "a face of the geodesic has a coordinate that is not finite, or too large");
        extent = (std::max)(extent, e);
      }
    const int exponent = scaling_exponent(extent);
    const double factor = std::ldexp(1., -exponent);
    std::array<Space_vector<double>, 3> side;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Numbers &a = p[k], &b = p[next_corner(k)];
      side[k] = {factor * (b[0] - a[0]), factor * (b[1] - a[1]), factor * (b[2] - a[2])};
    }
    Intrinsic_face<double> face;
    const unsigned int shift = set_shape_from_sides(side, face);
    return Face_layout(face, shift, std::ldexp(1., exponent));
  }

  // The points of the source and the target of h, and of the third corner of its face.
  std::array<Numbers, 3> corners(halfedge_descriptor h) const
  {
    check_triangle(h, m_tm);
    const halfedge_descriptor h1 = next(h, m_tm);
    return {numbers(target(next(h1, m_tm), m_tm)), numbers(target(h, m_tm)), numbers(target(h1, m_tm))};
  }

  // The point of space with the coordinates b in the corners of the face of h. At a corner it has the bits of the
  // vertex: the other coordinates are zeros.
  Numbers point(halfedge_descriptor h, const Barycentric<double>& b) const { return combination(corners(h), b); }

private:
  template <typename Vertex>
  Numbers numbers(Vertex v) const
  {
    const auto& p = get(m_vpm, v);
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  const TriangleMesh& m_tm;
  VertexPointMap m_vpm;
};

// Layouts from a map of edge lengths. Both faces of an edge ask for the same edge descriptor, so they get the same
// length.
template <typename TriangleMesh, typename EdgeLengthMap>
class Layouts_from_edge_lengths
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using Reason = Invalid_geodesic_input::Reason;

  static_assert(Is_map_of_numbers<EdgeLengthMap, typename boost::graph_traits<TriangleMesh>::edge_descriptor>::value,
                "the lengths are not a property map from the edges of the mesh to numbers");

public:
  static constexpr bool has_points = false;

  // There are no obstacles (Layouts_with_walls.h, Layouts_with_avoided_faces.h).
  static constexpr bool is_wall(halfedge_descriptor) { return false; }
  static constexpr bool is_avoided(face_descriptor) { return false; }

  Layouts_from_edge_lengths(const TriangleMesh& tm, EdgeLengthMap elm) : m_tm(tm), m_elm(elm) {}

  // Throws Invalid_geodesic_input also if a length is negative or not finite, or too long for the two others.
  Face_layout operator()(halfedge_descriptor h) const
  {
    check_triangle(h, m_tm);
    std::array<double, 3> length;
    for(double& l : length)
    {
      l = CGAL::to_double(get(m_elm, edge(h, m_tm)));
      if(!(std::abs(l) <= largest_extent()))
        throw Invalid_geodesic_input(Reason::NON_FINITE_LENGTH, "a length on the geodesic is not finite, or too large");
      if(l < 0)
        throw Invalid_geodesic_input(Reason::NEGATIVE_LENGTH, "a length on the geodesic is negative");
      h = next(h, m_tm);
    }
    const int exponent = scaling_exponent(*std::max_element(length.begin(), length.end()));
    for(double& l : length)
      l *= std::ldexp(1., -exponent);
    Intrinsic_face<double> face;
    const unsigned int shift = set_shape_from_lengths(length, face);
    if(violates_triangle_inequality(face))
      throw Invalid_geodesic_input(Reason::TRIANGLE_INEQUALITY,
                                   "an edge of a face of the geodesic is longer than the two others together");
    return Face_layout(face, shift, std::ldexp(1., exponent));
  }

private:
  const TriangleMesh& m_tm;
  EdgeLengthMap m_elm;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_FACE_LAYOUT_H
