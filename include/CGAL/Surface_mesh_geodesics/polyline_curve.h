// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_POLYLINE_CURVE_H
#define CGAL_SURFACE_MESH_GEODESICS_POLYLINE_CURVE_H

#include <CGAL/license/Surface_mesh_geodesics.h>

// Curves from polylines in space: isolines, intersections, lines that a user has drawn.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/curves/Nearest_places.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/shortest_path_curve.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

returns the curve on a triangle mesh that follows a polyline in space: each point of the polyline moves to the nearest
point of the surface, and shortest paths join neighbors, as in `shortest_path_curve()`.

The curve is closed if the last point of the polyline is the first one. That is how polylines of \cgal tell it, those of
`geodesic_isolines()` among them. So an isoline becomes a source of distances, a site of a diagram, or the curve of
signed distances, which are negative where the source of the isoline is. (Arcs and boundaries of Voronoi diagrams have
locations, of which `Surface_curve` makes curves.)

Neighbors in one face are joined by a straight segment, so the curve of a polyline on the surface is that polyline. Its
length is then that of the polyline. A point beside an edge or a vertex, up to the rounding of its coordinates, counts
as a point of it. (The straight segments of an isoline are chords: inside a face, points of them are a little nearer to
the source of the isoline than its ends are.)

Points are moved by \cgal's tree and kernel, which lose digits where coordinates are a million times as large as faces:
move such a mesh to the origin first.

The function does not tell how far points have moved. A polyline far from the surface may give a curve that nobody
expects: where the surface is folded, two neighbors may come to lie on different folds.

\code
std::vector<std::pair<std::size_t, std::vector<Point>>> lines;
geodesic_isolines(mesh, source, std::vector<double>{1.}, std::back_inserter(lines));
signed_geodesic_distances(mesh, distance, polyline_curve(mesh, lines.front().second));
\endcode

<b>Complexity.</b> O(n log n) for the faces of the mesh, of which it makes an `AABB_tree`, and in practice O(log n) for
each point; plus the time of `shortest_path_curve()`. Where the polyline is much finer than the mesh, the curve has many
locations in one face. As a source it takes time quadratic in their number then, see `Surface_curve`.

<b>Thread safety.</b> As for `geodesic_distances()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Points a range of `Kernel::Point_3`, the value type of the point map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param points the polyline. A single point, or two equal ones, make an open curve that is a point.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_index_map`,
       `face_index_map`, `faces_to_avoid`, `edges_to_avoid` and `statistics`, with the types and defaults of
       `geodesic_distance()`. Points move to the nearest face that is not to be avoided. The statistics count all
       propagations.

\pre the value type of the point map is `Kernel::Point_3` for a kernel of \cgal

\return the curve

\throws Invalid_geodesic_input as `shortest_path_curve()`; with the reason `INVALID_CURVE` if the mesh has no face, or
        none that is not avoided, with `NOT_A_TRIANGLE` if a face has not three edges, and with `NON_FINITE_POINT` if a
        coordinate is not a finite number, or too large or too small for points to be located.

\sa `shortest_path_curve()`
\sa `geodesic_isolines()`
\sa `signed_geodesic_distances()`
*/
template <typename TriangleMesh, typename Points, typename CGAL_NP_TEMPLATE_PARAMETERS>
Surface_curve<TriangleMesh> polyline_curve(const TriangleMesh& tm, const Points& points,
                                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Pair_parameters>(tm, np);
  const auto vpm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                get_const_property_map(CGAL::vertex_point, tm));
  using Vertex_point_map = std::decay_t<decltype(vpm)>;
  using Point = typename boost::property_traits<Vertex_point_map>::value_type;
  using Location = typename Surface_curve<TriangleMesh>::Face_location;
  constexpr bool are_points = internal::Is_range_of<Points, Point>::value;
  static_assert(are_points, "the points of the polyline are a range of the points of the mesh");
  if constexpr(!are_points) // else the errors of the loops would follow the message
    return internal::Private_access::make<Surface_curve<TriangleMesh>>(
      std::vector<typename Surface_curve<TriangleMesh>::Segment>(), false);
  else
  {
    const std::vector<Point> polyline(std::begin(points), std::end(points));
    const auto fim = CGAL::get_initialized_face_index_map(tm, np);
    const internal::Obstacles obstacles = internal::obstacles(tm, fim, np);
    const internal::Nearest_places<TriangleMesh, Vertex_point_map> nearest(tm, vpm, obstacles, fim);
    const bool is_closed = polyline.size() > 2 && polyline.front() == polyline.back();
    std::vector<Location> places;
    for(std::size_t i = 0; i < polyline.size() - (is_closed ? 1 : 0); ++i)
      places.push_back(nearest.location(polyline[i]));
    return shortest_path_curve(tm, places, is_closed, np);
  }
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_POLYLINE_CURVE_H
