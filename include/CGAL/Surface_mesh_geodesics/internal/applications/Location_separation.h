// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_LOCATION_SEPARATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_LOCATION_SEPARATION_H

// How far two locations on the surface are apart, and how far a location is from the border of the mesh. The certifier
// of diagrams asks this where arcs of a boundary have to meet. One class measures in space, the other works on a
// surface that is given by the lengths of its edges.
//
// Both are models of the same concept:
//   separation(a, b)           the distance of two locations, 0 up to rounding if they are equal
//   separation.from_border(a)  the distance of a location from the border; infinity if there is no border nearby
// Distances are in the unit of the mesh. The rim of faces that the diagram avoids is a border, and so are walls.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Returns the length of the longest edge of a triangle. `length(h)` gives the length of a halfedge.
template <typename TriangleMesh, typename Length>
double longest_edge(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh& tm,
                    const Length& length)
{
  const auto h = halfedge(f, tm), g = next(h, tm);
  return (std::max)(length(h), (std::max)(length(g), length(next(g, tm))));
}

// Has a halfedge a face that the diagram does not avoid?
template <typename Diagram>
bool is_inside(typename boost::graph_traits<typename Diagram::Triangle_mesh>::halfedge_descriptor h,
               const Diagram& diagram)
{
  const auto& tm = diagram.triangle_mesh();
  return !is_border(h, tm) && !diagram.avoids_face(face(h, tm));
}

// Is the source of a halfedge on a wall? Takes time linear in its degree.
template <typename Diagram>
bool is_at_wall(typename boost::graph_traits<typename Diagram::Triangle_mesh>::halfedge_descriptor h,
                const Diagram& diagram)
{
  const auto& tm = diagram.triangle_mesh();
  for(const auto g : CGAL::halfedges_around_source(h, tm))
    if(diagram.avoids_edge(edge(g, tm)))
      return true;
  return false;
}

// Does the surface of the diagram end at a halfedge that has a face inside: is there no face on the other side, or a
// wall between?
template <typename Diagram>
bool is_at_border(typename boost::graph_traits<typename Diagram::Triangle_mesh>::halfedge_descriptor h,
                  const Diagram& diagram)
{
  const auto& tm = diagram.triangle_mesh();
  return !is_inside(opposite(h, tm), diagram) || diagram.avoids_edge(edge(h, tm));
}

// Measures straight through space, between the points of the locations. A distance in space is not greater than that on
// the surface: two locations may be near each other in space only, so a fault may go unnoticed, but no two locations of
// one point are taken for different ones.
template <typename Diagram, typename VertexPointMap>
class Separation_in_space
{
  using Face_location = typename Diagram::Face_location;
  using Vector = std::array<double, 3>;

public:
  // Collects the border edges in time linear in the size of the mesh. The diagram is referred to; the map is read here
  // only.
  Separation_in_space(const Diagram& diagram, VertexPointMap vpm) : m_diagram(diagram)
  {
    const auto& tm = diagram.triangle_mesh();
    for(const auto h : halfedges(tm))
      if(is_inside(h, diagram) && is_at_border(h, diagram))
        m_border.push_back({vector(get(vpm, source(h, tm))), vector(get(vpm, target(h, tm)))});
  }

  double operator()(const Face_location& a, const Face_location& b) const
  {
    const Vector p = vector(m_diagram.point(a)), q = vector(m_diagram.point(b));
    return (std::max)(norm(difference(p, q)) - rounding_of(p, q), 0.);
  }

  // Takes time linear in the number of border edges.
  double from_border(const Face_location& l) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    const Vector p = vector(m_diagram.point(l));
    for(const std::array<Vector, 2>& edge : m_border)
    {
      const Vector along = difference(edge[1], edge[0]), to_p = difference(p, edge[0]);
      const double t = fraction_along(along, to_p);
      const double d = norm(difference(to_p, {t * along[0], t * along[1], t * along[2]}));
      smallest = (std::min)(smallest, (std::max)(d - rounding_of(p, edge[0]), 0.));
    }
    return smallest;
  }

private:
  template <typename Point>
  static Vector vector(const Point& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  // Two locations of one point get coordinates that differ in their last digits, which matters far from the origin.
  static double rounding_of(const Vector& a, const Vector& b)
  {
    return Tolerance<double>::points_in_space() * (std::max)(norm(a), norm(b));
  }

  // Returns the fraction of an edge at which it is nearest to a point; both are given from the source of the edge, and
  // divided by a power of two as large as the edge, as the squares of very small or large lengths underflow or
  // overflow.
  static double fraction_along(const Vector& along, const Vector& to_p)
  {
    const double length = norm(along);
    if(!(length > 0))
      return 0;
    int exponent = 0;
    std::frexp(length, &exponent);
    const auto scaled = [exponent](const Vector& v)
    { return Vector{std::ldexp(v[0], -exponent), std::ldexp(v[1], -exponent), std::ldexp(v[2], -exponent)}; };
    const Vector edge = scaled(along);
    return (std::min)((std::max)(product(edge, scaled(to_p)) / product(edge, edge), 0.), 1.);
  }

  static Vector difference(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static double product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static double norm(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }

  const Diagram& m_diagram;
  std::vector<std::array<Vector, 2>> m_border; // both ends of each border edge
};

// Compares barycentric coordinates, as there are no points. A location is the sum of its corners, weighted with its
// coordinates. If the two faces have a corner in common, each corner's share moves over at most the longest edge of the
// two faces. So the sum of the differences, times that edge, is an upper bound of the distance. If they have none, the
// result is two such edges, which tells only that the locations differ. Two locations of one point are in faces with a
// common corner, so the result is 0 for them, up to rounding.
template <typename Diagram, typename Length>
class Separation_by_coordinates
{
  using Face_location = typename Diagram::Face_location;
  using Triangle_mesh = typename Diagram::Triangle_mesh;
  using Graph_traits = boost::graph_traits<Triangle_mesh>;
  using Corners = std::array<typename Graph_traits::vertex_descriptor, 3>;

public:
  // `length(h)` gives the length of a halfedge. It is copied, the diagram is referred to.
  Separation_by_coordinates(const Diagram& diagram, Length length)
    : m_diagram(diagram), m_tm(diagram.triangle_mesh()), m_length(length)
  {}

  double operator()(const Face_location& a, const Face_location& b) const
  {
    const Corners of_a = corners(a.first), of_b = corners(b.first);
    double sum = 0;
    for(std::size_t k = 0; k < 3; ++k)
      sum += std::abs(CGAL::to_double(a.second[k]) - coordinate(b, of_b, of_a[k]))
           + std::abs(CGAL::to_double(b.second[k]) - coordinate(a, of_a, of_b[k]));
    return sum * (std::max)(longest_edge(a.first, m_tm, m_length), longest_edge(b.first, m_tm, m_length));
  }

  // Looks at the border edges and border vertices of the face only. A location is on an edge if the coordinate of the
  // opposite corner is 0, and at a corner if its coordinate is 1. With another coordinate b, it is at most b times the
  // longest edge away from that edge, or 1 - b times the longest edge from that corner. Takes time linear in the
  // degrees of the corners.
  double from_border(const Face_location& l) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    auto h = halfedge(l.first, m_tm);
    for(std::size_t k = 0; k < 3; ++k, h = next(h, m_tm))
    {
      if(is_at_border(h, m_diagram))
        smallest = (std::min)(smallest, std::abs(CGAL::to_double(l.second[(k + 2) % 3])));
      for(const auto g : CGAL::halfedges_around_source(h, m_tm))
        if(!is_inside(g, m_diagram) || m_diagram.avoids_edge(edge(g, m_tm)))
          smallest = (std::min)(smallest, std::abs(1 - CGAL::to_double(l.second[k])));
    }
    return smallest * longest_edge(l.first, m_tm, m_length);
  }

private:
  // Returns the vertices of a face in the order of its coordinates.
  Corners corners(typename Graph_traits::face_descriptor f) const
  {
    const auto h = halfedge(f, m_tm);
    return {source(h, m_tm), target(h, m_tm), target(next(h, m_tm), m_tm)};
  }

  // Returns the weight of a vertex in a location: 0 if it is not a corner of the face, a sum if it is several corners.
  static double coordinate(const Face_location& l, const Corners& of_l, typename Graph_traits::vertex_descriptor v)
  {
    double sum = 0;
    for(std::size_t k = 0; k < 3; ++k)
      sum += of_l[k] == v ? CGAL::to_double(l.second[k]) : 0.;
    return sum;
  }

  const Diagram& m_diagram;
  const Triangle_mesh& m_tm;
  Length m_length;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_LOCATION_SEPARATION_H
