// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_SHORTEST_PATH_CURVE_H
#define CGAL_SURFACE_MESH_GEODESICS_SHORTEST_PATH_CURVE_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Private_access.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/curves/Curve_path_writer.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/curves/curve_segments.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

returns the curve that joins points of a triangle mesh by shortest paths, one after the other.

A `Surface_curve` that is made from points needs a common face for two in a row. Here the points may be far apart: those
of a polyline in space, for instance, that `Surface_mesh_geodesic_paths::locate()` has moved to the surface. Where two
points do have a common face, the curve runs straight through that face, unless there are faces to avoid. A point may be
repeated, and paths may cross and overlap.

The curve has a segment for each face that it crosses, and is as long as the paths. Where several shortest paths lead
from a point to the next one, it follows one of them.

\code
const std::vector<Face_location> corners{a, b, c};
const Surface_curve<Mesh> triangle = shortest_path_curve(mesh, corners, true);
signed_geodesic_distances(mesh, distance, triangle);
\endcode

<b>Complexity.</b> If all neighbors have common faces, the time is that of the constructor of `Surface_curve`.
Otherwise the function reads the mesh once, and each pair without a common face takes a propagation that ends where the
other point is reached. With faces to avoid, all pairs do so.

<b>Thread safety.</b> As for `geodesic_distances()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Points a range of vertex descriptors, or of pairs of a face descriptor and three barycentric coordinates, as for
        `geodesic_distances()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param points the points, in the order in which the curve passes them. A single one makes a curve that is a point.
\param is_closed whether the curve is closed, that is, whether a last path leads from the last point to the first one
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_index_map`,
       `face_index_map`, `faces_to_avoid`, `edges_to_avoid` and `statistics`, with the types and defaults of
       `geodesic_distance()`. The statistics count all propagations.

\pre the value type of the point map is `Kernel::Point_3` for a kernel of \cgal

\return the curve

\throws Invalid_geodesic_input with the reason `INVALID_CURVE` if there is no point, if a point is not on the mesh (as
        far as the mesh can tell: a `Surface_mesh` knows its elements), if a point is inside of the faces to avoid (it
        may be at their rim), or if no path leads from a point to the next one; the element is the position of that
        point in the range. Nothing is computed if a point is rejected. Also if the mesh is one that
        `geodesic_distances()` rejects. It is read unless all points that follow each other share a face, and no faces
        are to be avoided.
\throws std::runtime_error if rounding hides a path

\sa `geodesic_path()`
\sa `polyline_curve()`
\sa `border_curves()`
\sa `signed_geodesic_distances()`
*/
template <typename TriangleMesh, typename Points, typename CGAL_NP_TEMPLATE_PARAMETERS>
Surface_curve<TriangleMesh> shortest_path_curve(const TriangleMesh& tm, const Points& points, bool is_closed = false,
                                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Curve = Surface_curve<TriangleMesh>;
  internal::check_parameters<internal::Pair_parameters>(tm, np);
  // Where the argument is something else, the errors of the loops would follow the message, so they are left out. (A
  // single point is no range: such a curve is made by the constructor.)
  constexpr bool are_places = internal::Kind_of_places<TriangleMesh, Points>::are_places;
  static_assert(are_places, "the points are not a range of vertex descriptors, or of pairs of a face descriptor and "
                            "three barycentric coordinates");
  if constexpr(!are_places)
    return internal::Private_access::make<Curve>(std::vector<typename Curve::Segment>(), is_closed);
  else
  {
    using Place = std::decay_t<decltype(*std::begin(points))>;
    const std::vector<Place> places(std::begin(points), std::end(points));
    std::vector<internal::Point_of_faces<TriangleMesh>> ends;
    for(const Place& p : places)
      ends.emplace_back(tm, p, ends.size());
    // The common face may be one to avoid.
    constexpr bool avoids_faces = internal::Has_parameter<CGAL_NP_CLASS, internal_np::faces_to_avoid_t>::value;
    if(places.size() < 2 && !avoids_faces)
      return Curve(tm, places);
    std::vector<typename Curve::Segment> segments;
    internal::with_path_structure(tm, np, [&](auto& paths)
    {
      if constexpr(avoids_faces)
        internal::reject_points_inside(tm, ends, [&](auto f) { return paths.avoids_face(f); });
      const std::size_t number_of_paths = places.size() < 2 ? 0 : places.size() - (is_closed ? 0 : 1);
      for(std::size_t i = 0; i < number_of_paths; ++i)
      {
        const std::size_t j = (i + 1) % places.size();
        if(avoids_faces || !internal::find_segment(tm, ends[i], ends[j], segments))
        {
          using Paths = std::decay_t<decltype(paths)>;
          internal::append_path(paths, internal::place_of<Paths, TriangleMesh>(places[i]),
                                internal::place_of<Paths, TriangleMesh>(places[j]), i, segments);
          if(Propagation_statistics* const statistics = internal::statistics_parameter(np))
            statistics->add(paths.statistics());
        }
      }
    });
    if(segments.empty()) // all places are one point, or there is none
      return Curve(tm, std::vector<Place>(places.begin(), places.begin() + (places.empty() ? 0 : 1)));
    return internal::Private_access::make<Curve>(std::move(segments), is_closed);
  }
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_SHORTEST_PATH_CURVE_H
