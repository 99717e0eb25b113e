// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_TRACING_FUNCTIONS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_TRACING_FUNCTIONS_H

// What the functions of trace_geodesic.h do: check the input, walk, and convert directions.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/Face_layout.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/Layouts_with_avoided_faces.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/Layouts_with_walls.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/Straightest_walk.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/Vertex_fan.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/face_shape.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A face and snapped coordinates in the user's order: zeros are exact, and the sum is 1 up to rounding. A vertex has
// the coordinates of a corner.
template <typename TriangleMesh>
using Snapped_location
  = std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, Barycentric<double>>;

// A vertex gets the location in the face of halfedge(v, tm), or at the border in the first face around it. Descriptors
// are checked as far as the mesh can tell: no index map is needed here, and making one would take linear time.
//
// Returns a location of the user, which is a vertex or a location in a face, checked and snapped. Throws
// Invalid_geodesic_input if it is not on the mesh.
template <typename TriangleMesh, typename Location>
Snapped_location<TriangleMesh> location_on_mesh(const TriangleMesh& tm, const Location& location)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  static_assert(Is_vertex<TriangleMesh, Location>::value || Is_face_location<TriangleMesh, Location>::value,
                "a location is a vertex descriptor or a pair of a face descriptor and three barycentric coordinates");
  constexpr std::size_t none = Invalid_geodesic_input::no_element;
  const char* const what = "the location";
  if constexpr(Is_vertex<TriangleMesh, Location>::value)
  {
    const typename Graph_traits::vertex_descriptor v = location;
    if(v == Graph_traits::null_vertex() || Removed_elements<TriangleMesh>::contain(v, tm))
      reject_vertex(what, none);
    // The location is in the face of a halfedge that enters the vertex: there the vertex is the corner behind it.
    const auto h = halfedge_in_face(v, tm);
    if(h == Graph_traits::null_halfedge())
      reject_vertex_without_face(what, none);
    Barycentric<double> corner{0, 0, 0};
    unsigned int k = 1; // that of the target of the first halfedge
    for(auto g = halfedge(face(h, tm), tm); g != h; g = next(g, tm))
      k = next_corner(k);
    corner[k] = 1;
    return {face(h, tm), corner};
  }
  else if constexpr(Is_face_location<TriangleMesh, Location>::value)
  {
    const typename Graph_traits::face_descriptor f = location.first;
    if(f == Graph_traits::null_face())
      reject_null_face(what, none);
    if(Removed_elements<TriangleMesh>::contain(f, tm))
      reject_face_of_location(what, none);
    return {f, snapped_coordinates<double>(location.second, what, none)};
  }
}

// The same beside the faces to avoid, among which a location at their rim may be given. Throws also if it is inside of
// them. A walk never sees a face to avoid then: it begins in another one, and ends where it would enter one.
template <typename TriangleMesh, typename Layouts, typename Location>
Snapped_location<TriangleMesh> snapped_location(const TriangleMesh& tm, const Layouts& layouts,
                                                const Location& location)
{
  const Snapped_location<TriangleMesh> l = location_on_mesh(tm, location);
  return layouts.is_avoided(l.first) ? location_beside_avoided_faces(l.first, l.second, tm, layouts) : l;
}

// Throws unless the direction is finite. Full turns do not matter.
inline void check_direction(double direction)
{
  if(!std::isfinite(direction))
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_DIRECTION,
                                 "the direction of a geodesic is not finite");
}

// Traces a geodesic into `result`, which is new, and adds the points of space if there are any. Throws
// Invalid_geodesic_input: for the direction and the length first, then for the location, then for the faces in the
// order in which they are visited.
template <typename TriangleMesh, typename Layouts, typename Location, typename Result>
void trace(const TriangleMesh& tm, const Layouts& layouts, const Location& location, double direction, double length,
           Result& result)
{
  check_direction(direction);
  if(!(length >= 0) || !std::isfinite(length))
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_DIRECTION,
                                 "the length of a geodesic is negative or not finite");
  const Snapped_location<TriangleMesh> start = snapped_location(tm, layouts, location);
  Straightest_walk<TriangleMesh, Layouts, Result>(tm, layouts, result).walk(start.first, start.second, direction,
                                                                              length);
  if constexpr(Layouts::has_points)
    for(const auto& l : result.locations)
      result.points.push_back(layouts.point(halfedge(l.first, tm), l.second));
}

// Without a parameter, layouts answer the questions for obstacles at compile time: a walk costs what it cost before.
//
// Returns the layouts with the faces to avoid among the named parameters, if there are any. Takes constant time, or
// that of sorting a range. Throws Invalid_geodesic_input for a face that is not in the mesh. The layouts are moved on;
// a map of the user is copied.
template <typename TriangleMesh, typename Layouts, typename NamedParameters>
auto with_avoided_faces(const TriangleMesh& tm, Layouts layouts, const NamedParameters& np)
{
  if constexpr(Has_parameter<NamedParameters, internal_np::faces_to_avoid_t>::value)
  {
    const auto& avoided = parameters::get_parameter_reference(np, internal_np::faces_to_avoid);
    using Value = std::remove_const_t<std::remove_reference_t<decltype(avoided)>>;
    constexpr bool is_map = Is_property_map<Value>::value;
    static_assert(Checked_faces_to_avoid<Value, typename boost::graph_traits<TriangleMesh>::face_descriptor>::value,
                  "always true, if it compiles");
    using Avoided = std::conditional_t<is_map, Face_map_set<Value>, Face_set<TriangleMesh>>;
    return Layouts_with_avoided_faces<TriangleMesh, Layouts, Avoided>(tm, std::move(layouts), avoided);
  }
  else
    return layouts;
}

// The same with the walls among the named parameters. Throws for an edge that is not in the mesh. Both kinds of
// obstacles may be given at once, in any order: each class adds one answer to those of its base.
template <typename TriangleMesh, typename Layouts, typename NamedParameters>
auto with_walls(const TriangleMesh& tm, Layouts layouts, const NamedParameters& np)
{
  if constexpr(Has_parameter<NamedParameters, internal_np::edges_to_avoid_t>::value)
  {
    const auto& avoided = parameters::get_parameter_reference(np, internal_np::edges_to_avoid);
    using Value = std::remove_const_t<std::remove_reference_t<decltype(avoided)>>;
    constexpr bool is_map = Is_property_map<Value>::value;
    static_assert(Checked_edges_to_avoid<Value, typename boost::graph_traits<TriangleMesh>::edge_descriptor>::value,
                  "always true, if it compiles");
    using Walls = std::conditional_t<is_map, Edge_map_set<Value>, Edge_set<TriangleMesh>>;
    return Layouts_with_walls<TriangleMesh, Layouts, Walls>(tm, std::move(layouts), avoided);
  }
  else
    return layouts;
}

// Returns the layouts by the point map among the named parameters, or by the points of the mesh, with the obstacles
// among the parameters. The parameters are checked first, so that one that is not taken does not compile.
template <typename TriangleMesh, typename NamedParameters>
auto layouts_from_points(const TriangleMesh& tm, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  check_parameters_of_face_graph<Tracing_parameters>(tm, np);
  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                              get_const_property_map(CGAL::vertex_point, tm));
  const Layouts_from_points<TriangleMesh, decltype(vpm)> layouts(tm, vpm);
  return with_walls(tm, with_avoided_faces(tm, layouts, np), np);
}

// The same by a map of edge lengths.
template <typename TriangleMesh, typename EdgeLengthMap, typename NamedParameters>
auto layouts_from_edge_lengths(const TriangleMesh& tm, EdgeLengthMap edge_length_map, const NamedParameters& np)
{
  check_parameters_of_face_graph<Edge_length_tracing_parameters>(tm, np);
  const Layouts_from_edge_lengths<TriangleMesh, EdgeLengthMap> layouts(tm, edge_length_map);
  return with_walls(tm, with_avoided_faces(tm, layouts, np), np);
}

// The differences of coordinates are divided by the unit of the layout, so that squares neither overflow nor vanish.
//
// Returns the sides AB and AC of the face of h in space, A being the source of h, divided by a power of two.
template <typename Halfedge, typename Layouts>
std::pair<Space_vector<double>, Space_vector<double>> sides_in_space(Halfedge h, const Layouts& layouts)
{
  const auto p = layouts.corners(h);
  const double factor = 1 / layouts(h).unit();
  const auto side = [&](std::size_t k)
  {
    return Space_vector<double>{factor * (p[k][0] - p[0][0]), factor * (p[k][1] - p[0][1]),
                                factor * (p[k][2] - p[0][2])};
  };
  return {side(1), side(2)};
}

// Returns the vector divided by its length. Divides by the largest coordinate first, as the squares of a vector of a
// user may overflow. Requires: it is not null, and finite.
inline Space_vector<double> normalized(const Space_vector<double>& v)
{
  const double largest = (std::max)(std::abs(v.x), (std::max)(std::abs(v.y), std::abs(v.z)));
  const Space_vector<double> w{v.x / largest, v.y / largest, v.z / largest};
  const double length = w.length();
  return {w.x / length, w.y / length, w.z / length};
}

// A direction in a face as a point of the unit circle: cos x + sin y, with the axes x and y of the face in space. The
// second one is the normal times the first one, so that angles count counterclockwise.
//
// The unit vectors of a face in space: along its halfedge, and at a right angle to the left of it.
struct Face_axes
{
  Space_vector<double> x, y;
};

// Throws if the face of h has no area, or so little that the normal vector vanishes.
template <typename Halfedge, typename Layouts>
Face_axes axes_of_face(Halfedge h, const Layouts& layouts)
{
  const auto sides = sides_in_space(h, layouts);
  const Space_vector<double> normal = cross(sides.first, sides.second);
  if(!layouts(h).has_area() || !(normal.length() > 0))
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_DIRECTION,
                                 "the face of a direction has no area");
  const Space_vector<double> x = normalized(sides.first);
  return {x, cross(normalized(normal), x)};
}

// Returns the halfedge of face f at whose source the snapped location b is, or the first halfedge, halfedge(f, tm),
// from which directions count if the location is not a vertex.
template <typename TriangleMesh>
auto halfedge_at_location(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const Barycentric<double>& b,
                          const TriangleMesh& tm)
{
  auto h = halfedge(f, tm);
  if(std::count(b.begin(), b.end(), 0.) == 2)
    for(unsigned int k = 0; b[k] == 0; ++k)
      h = next(h, tm);
  return h;
}

// Returns the direction of a vector of space at a location. Throws Invalid_geodesic_input. The vector is projected to
// the plane of the face: its products with the axes of the face are the cosine and the sine of the angle, up to a
// factor. A vector at a right angle to the face, up to rounding, is rejected.
template <typename TriangleMesh, typename Layouts, typename Location, typename Vector>
double direction_of_vector(const TriangleMesh& tm, const Layouts& layouts, const Location& location, const Vector& v)
{
  // (A vector of the plane has an operator[], too.)
  static_assert(Is_triple<Vector>::value, "the vector of a direction has three coordinates, which operator[] returns");
  const Snapped_location<TriangleMesh> start = snapped_location(tm, layouts, location);
  const auto h = halfedge_at_location(start.first, start.second, tm);
  const Face_axes axes = axes_of_face(h, layouts);
  const Space_vector<double> given{CGAL::to_double(v[0]), CGAL::to_double(v[1]), CGAL::to_double(v[2])};
  const double largest = (std::max)(std::abs(given.x), (std::max)(std::abs(given.y), std::abs(given.z)));
  if(!std::isfinite(given.x + given.y + given.z) || !(largest > 0))
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_DIRECTION,
                                 "the vector of a direction is not finite, or null");
  const Space_vector<double> unit = normalized(given);
  const double x = dot(unit, axes.x), y = dot(unit, axes.y);
  if(!(std::hypot(x, y) > Tolerance<double>::direction()))
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_DIRECTION,
                                 "the vector of a direction is at a right angle to the face");
  const double angle = std::atan2(y, x);
  if(std::count(start.second.begin(), start.second.end(), 0.) < 2)
    return reduced_angle(angle, full_turn);
  const Vertex_fan<TriangleMesh> fan(h, tm, layouts);
  const double at_vertex = fan.angle(h) + angle;
  if(fan.is_closed() && fan.has_angles())
    return fan.scaled(at_vertex);
  // (The faces of an open fan may fill more than a full turn.)
  return 0 <= at_vertex && at_vertex <= fan.total_angle() ? at_vertex : reduced_angle(at_vertex, full_turn);
}

// The inverse of direction_of_vector() for vectors in the plane of the face.
//
// Returns the unit vector of a direction at a location, and the face in which it lies. Throws Invalid_geodesic_input.
template <typename TriangleMesh, typename Layouts, typename Location>
std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3>>
vector_of_direction(const TriangleMesh& tm, const Layouts& layouts, const Location& location, double direction)
{
  check_direction(direction);
  const Snapped_location<TriangleMesh> start = snapped_location(tm, layouts, location);
  auto h = halfedge_at_location(start.first, start.second, tm);
  double angle = reduced_angle(direction, full_turn);
  if(std::count(start.second.begin(), start.second.end(), 0.) == 2)
  {
    const Vertex_fan<TriangleMesh> fan(h, tm, layouts);
    angle = fan.has_angles() ? fan.unscaled(direction) : 0.;
    const auto& sector = fan.sector_at(angle);
    h = sector.halfedge;
    angle -= sector.angle;
  }
  const Face_axes axes = axes_of_face(h, layouts);
  const double c = std::cos(angle), s = std::sin(angle);
  return {face(h, tm),
          {c * axes.x.x + s * axes.y.x, c * axes.x.y + s * axes.y.y, c * axes.x.z + s * axes.y.z}};
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_TRACING_TRACING_FUNCTIONS_H
