// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_TRACE_GEODESIC_H
#define CGAL_SURFACE_MESH_GEODESICS_TRACE_GEODESIC_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/tracing/tracing_functions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Traced_geodesic` holds a geodesic that `trace_geodesic()` has traced: its points, where it ends, and in which
direction.

\tparam TriangleMesh a model of `FaceGraph`

\sa `trace_geodesic()`
*/
template <typename TriangleMesh>
struct Traced_geodesic
{
  /// the face descriptor of the mesh.
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  /// a face and three barycentric coordinates. It is the type
  /// `CGAL::Polygon_mesh_processing::Face_location<TriangleMesh, double>`.
  using Face_location = std::pair<face_descriptor, std::array<double, 3>>;

  /// why a geodesic ends.
  enum End
  {
    AT_LENGTH,     ///< it has the length that was asked for
    AT_BORDER,     ///< it has reached the border or what is to be avoided, or a vertex of it
    AT_SINGULARITY ///< nothing is straight on: at a vertex with an edge without length, or in faces without area
  };

  /// the points at which the geodesic begins, crosses edges, passes vertices and ends, in this order. The face of each
  /// one but the first is that through which the geodesic arrives. So the segment between two of them lies in the face
  /// of the second one.
  std::vector<Face_location> locations;

  /// the points of space at `locations`; none if the surface is given by lengths.
  std::vector<std::array<double, 3>> points;

  /// the length of the geodesic, in the unit of the mesh: less than the length that was asked for unless `end` is
  /// `AT_LENGTH`.
  double length = 0;

  /// the direction in which the geodesic would go on from its last location. (Where it ends at a vertex of the border,
  /// it is opposite to the direction from which it comes.)
  double direction = 0;

  /// why it ends.
  End end = AT_LENGTH;
};

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

traces the straightest geodesic from a location in a direction. With the direction and the distance of a shortest path
it is the exponential map: it leads back along that path, up to the first vertex at which the path bends.

In a face the geodesic is straight; across an edge it goes on straight when both faces are laid out in one plane. At a
vertex inside the surface, both sides of it have the same angle, half of the total angle of the faces around the vertex.
It ends at the border, also where it touches a vertex of the border. A point whose distance from a vertex rounding hides
(see the parameter `sources` of `geodesic_distances()`) is the vertex.

<b>Directions.</b> A direction is an angle in radians, counterclockwise as seen from the side from which faces are
counterclockwise. Full turns do not matter, except where the faces at a vertex of the border fill more than one. A
direction is counted

- in a face or on an edge, from the direction of `halfedge(f,tm)`, for the face `f` of the location. A direction that
  leads from an edge into the face across it is counted as if both faces were laid out in one plane;
- at a vertex `v` inside the surface, from the direction of `opposite(halfedge(v,tm),tm)`, which leaves `v`, and scaled
  so that the angles of all faces around `v` add up to \f$ 2\pi \f$.
  At a pinched vertex this holds in the umbrella of that halfedge; in the others, directions count from the halfedge
  that leaves `v` in the face of the location;
- at a vertex of the border, from the first halfedge that leaves it, counterclockwise, in the faces of the location.
  It is not scaled: it is the angle between the edges, from 0 to the total angle of these faces.

\cgal's pull request 8679 (<em>Vector Graphics on Surfaces</em>) has functions for similar tasks. Its type
`Face_location` is the one here, so the locations of both can be used together.

The function reads and checks only the faces that it visits. It takes time linear in the number of faces that the
geodesic crosses, plus the degrees of the vertices that it passes. It asks for `num_faces(tm)` at most once, where
rounding leaves the geodesic no length in a face; `CGAL::Face_filtered_graph` takes linear time for that.

<b>Thread safety.</b> That of all functions of this header: as for `geodesic_distances()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Location a vertex descriptor, or a face descriptor with three barycentric coordinates: what
        `geodesic_distances()` takes as a source
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param location where the geodesic begins
\param direction the direction in which it begins
\param length its length, in the unit of the points
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh`
                   as key type and a 3D point type with the members `x()`, `y()`, `z()` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{faces_to_avoid}
    \cgalParamDescription{faces that the geodesic does not enter, as if they were not in the mesh: it ends where it
                          meets one of them, or a vertex of one. Directions at such a vertex are those at a vertex of
                          the border, in the faces that are left. A location at the rim of these faces may be given in
                          one of them, or as a vertex. It is moved then to the face across its edge, or, at a vertex,
                          to one that is left; directions count from there. A location inside is rejected.}
    \cgalParamType{a range of face descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   face descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
    \cgalParamExtra{A range is sorted, whereas a map is read only where the geodesic is. A face of a range that is not
                    one of the mesh is rejected by `Invalid_geodesic_input`.}
  \cgalParamNEnd
  \cgalParamNBegin{edges_to_avoid}
    \cgalParamDescription{edges that count as border: the geodesic ends where it meets one of them, or a vertex of one.
                          At such a vertex, directions are counted as at the border, from the first halfedge of the
                          faces between two of these edges. A geodesic that begins on one of them stays on the side of
                          the face of its location.}
    \cgalParamType{a range of edge descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   edge descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
    \cgalParamExtra{A range is sorted, whereas a map is read only where the geodesic is. An edge of a range that is not
                    one of the mesh is rejected by `Invalid_geodesic_input`.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the geodesic. Its first location is `location`, unless that is given in a face to avoid.

\throws Invalid_geodesic_input if the location is not in its face, has no face or a null face, is inside of the faces to
        avoid, or is a null vertex or one without faces; if the direction or the length is not finite or the length is
        negative; or if a face that is visited is not a triangle, or has a coordinate that is not finite or too large

\sa `geodesic_direction()`
*/
template <typename TriangleMesh, typename Location, typename CGAL_NP_TEMPLATE_PARAMETERS>
Traced_geodesic<TriangleMesh> trace_geodesic(const TriangleMesh& tm, const Location& location, double direction,
                                             double length, const CGAL_NP_CLASS& np = parameters::default_values())
{
  Traced_geodesic<TriangleMesh> result;
  internal::trace(tm, internal::layouts_from_points(tm, np), location, direction, length, result);
  return result;
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

traces the straightest geodesic from a location in a direction on a surface that is given by the lengths of its edges.
All else is as for `trace_geodesic()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam EdgeLengthMap a model of `ReadablePropertyMap` with the edge descriptor of `TriangleMesh` as key type and a
        number type that `CGAL::to_double()` takes as value type
\tparam Location as for `trace_geodesic()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param edge_length_map the lengths, as for `geodesic_distances_from_edge_lengths()`
\param location where the geodesic begins
\param direction the direction in which it begins
\param length its length, in the unit of the lengths
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of `trace_geodesic()`, except
       `vertex_point_map`

\return the geodesic, without points

\throws Invalid_geodesic_input also if a length of a face that is visited is negative or not finite, or violates the
        triangle inequality
*/
template <typename TriangleMesh, typename EdgeLengthMap, typename Location, typename CGAL_NP_TEMPLATE_PARAMETERS>
Traced_geodesic<TriangleMesh>
trace_geodesic_from_edge_lengths(const TriangleMesh& tm, EdgeLengthMap edge_length_map, const Location& location,
                                 double direction, double length,
                                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  Traced_geodesic<TriangleMesh> result;
  internal::trace(tm, internal::layouts_from_edge_lengths(tm, edge_length_map, np), location, direction, length,
                  result);
  return result;
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

returns the direction of a vector of space at a location, in the form that `trace_geodesic()` takes.

The vector is projected to the plane of the face of the location. At a vertex this is the face of the location, or one
of the faces around it if the location is a vertex descriptor; the angle is that between the edges of this face and the
vector, also where the vector leads out of the face. Takes time linear in the degree of a vertex, else constant.

\tparam TriangleMesh a model of `FaceGraph`
\tparam Location as for `trace_geodesic()`
\tparam Vector a type with an `operator[]` for 0, 1 and 2, such as `std::array` or `Kernel::Vector_3`, of a number type
        that `CGAL::to_double()` takes
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param location the location
\param vector the vector, of any length
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", as for `trace_geodesic()`

\return the angle, in \f$ [0, 2\pi) \f$; at a vertex of the border whose faces fill more than a full turn, up to their
        total angle

\throws Invalid_geodesic_input as `trace_geodesic()`, and if the vector is null, not finite or, up to rounding, at a
        right angle to the face, or if the face has no area
*/
template <typename TriangleMesh, typename Location, typename Vector, typename CGAL_NP_TEMPLATE_PARAMETERS>
double geodesic_direction(const TriangleMesh& tm, const Location& location, const Vector& vector,
                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::direction_of_vector(tm, internal::layouts_from_points(tm, np), location, vector);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

returns the unit vector of space that has a direction at a location, and the face in whose plane it lies: the face of
the location, or, at a vertex, the face into which the direction leads (at a border vertex the last one if it leads
across the border). It is the inverse of `geodesic_direction()`, and takes the same time.

\tparam TriangleMesh a model of `FaceGraph`
\tparam Location as for `trace_geodesic()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param location the location
\param direction the direction
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", as for `trace_geodesic()`

\return the face and the vector

\throws Invalid_geodesic_input as `trace_geodesic()`, and if the face has no area
*/
template <typename TriangleMesh, typename Location, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3>>
geodesic_direction_vector(const TriangleMesh& tm, const Location& location, double direction,
                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::vector_of_direction(tm, internal::layouts_from_points(tm, np), location, direction);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_TRACE_GEODESIC_H
