// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_SURFACE_CURVE_H
#define CGAL_SURFACE_MESH_GEODESICS_SURFACE_CURVE_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Private_access.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/curves/border_cycles.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/curves/curve_segments.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Surface_curve` is a curve on a triangle mesh that may be a source of geodesic distances: straight segments,
one after the other, each of which lies in one face, or along an edge. It is open or closed, or a single point.

A curve may cross, touch or repeat itself, and may have segments without length. A range of curves may mix curves with
points, as a point is a curve of one location.

<b>Curves as sources.</b> The distance of a vertex from a curve is the smallest of its distances from all points of
the curve, not only from its vertices, and it is exact: nothing is sampled. Shortest paths leave the inside of a segment
at a right angle, on both sides, and corners and ends of the curve in the directions between.
\ref Surface_mesh_geodesics_curves shows how to use them.

<b>Many locations in one face.</b> A function that takes the curve as a source divides each face at the locations inside
of it and on its edges. This takes time quadratic in the number of locations in one face, and distances are slow in the
narrow parts that they leave. So where a curve has thousands of locations in one face, first leave out those that are
nearly on a line, or refine the mesh. A few locations in each of many faces, as along an isoline, cost little.

<b>Validity.</b> A curve stores descriptors of the mesh and barycentric coordinates, no points: it is a curve on
any surface with these faces, also on one that is given by its lengths. The mesh must keep its faces and edges as long
as the curve is in use, but its points may move. Copies are independent of each other, and several threads may use one
curve.

\code
std::vector<Surface_curve<Mesh>> curves = border_curves(mesh);
curves.emplace_back(mesh, std::array<Mesh::Vertex_index, 3>{u, v, w}); // along two edges
curves.emplace_back(mesh, locations, true);                            // a closed curve across faces
geodesic_distances(mesh, distance, curves);
\endcode

\tparam TriangleMesh a model of `FaceListGraph`

\sa `geodesic_distances()`
\sa `signed_geodesic_distances()`
\sa `border_curves()`
\sa `shortest_path_curve()`
\sa `polyline_curve()`
*/
template <typename TriangleMesh>
class Surface_curve
{
public:
  /// \name Types
  /// @{

  /// the triangle mesh type.
  using Triangle_mesh = TriangleMesh;

  /// the vertex descriptor type.
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// the halfedge descriptor type.
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// the face descriptor type.
  /// A location is given in a face.
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  /// three barycentric coordinates, in the order of `geodesic_distances()`.
  using Barycentric_coordinates = std::array<double, 3>;

  /// a face and three barycentric coordinates.
  using Face_location = std::pair<face_descriptor, Barycentric_coordinates>;

  /// a straight segment in a face: the face, and where the segment begins and ends.
  struct Segment
  {
    /// the face.
    face_descriptor face;

    /// the coordinates of the points at which the segment begins and ends.
    Barycentric_coordinates source, target;
  };

  /// @}

#ifndef DOXYGEN_RUNNING
  using Surface_curve_tag = void; // see internal/interface/source_range.h
#endif

  /// \name Creation
  /// Each of them takes time linear in the number of locations or halfedges, and in the number of faces around the
  /// vertices among them.
  ///
  /// \throws Invalid_geodesic_input with the reason `INVALID_CURVE`, and with the position of the location or halfedge
  ///         in the range, if the range is empty; if a vertex, face or halfedge is null or not one of the mesh (as far
  ///         as the mesh can tell: a `Surface_mesh` knows its elements); if a location is not in its face; if no face
  ///         has both of two locations in a row; if a halfedge does not begin where the one before ends, or has no face
  ///         on either side. With the reason `NOT_A_TRIANGLE` if the face of a halfedge does not have three edges.
  /// @{

  /// makes the curve through a range of vertices or of locations in faces. Two in a row are in one face; coordinates
  /// are rounded as for `geodesic_distances()`, so that a location on an edge or at a vertex may be given in any face
  /// around. A single one makes a point.
  ///
  /// \tparam Locations a range of vertex descriptors, or of pairs of a face descriptor and three barycentric
  /// coordinates
  ///
  /// \param tm the triangle mesh
  /// \param locations the vertices or locations
  /// \param is_closed whether the curve is closed, that is, whether a last segment leads from the last location to the
  /// first one
  template <typename Locations>
  Surface_curve(const TriangleMesh& tm, const Locations& locations, bool is_closed = false)
  {
    using Point = internal::Point_of_faces<TriangleMesh>;
    std::vector<Point> points;
    using Source = internal::Kind_of_places<TriangleMesh, Locations>;
    static_assert(Source::is_place || Source::are_places,
                  "the argument is not what a curve is made of: a range of vertex descriptors, or of pairs of a face "
                  "descriptor and three barycentric coordinates");
    if constexpr(Source::is_place)
      points.push_back(Point(tm, locations, 0));
    else if constexpr(Source::are_places)
      for(const auto& location : locations)
        points.push_back(Point(tm, location, points.size()));
    if(points.empty())
      internal::reject_curve(0, "is missing: a curve needs one location");
    m_is_closed = is_closed && points.size() > 1;
    for(std::size_t i = 0; i + 1 < points.size() + (m_is_closed ? 1 : 0); ++i)
      internal::append_segment(tm, points[i], points[(i + 1) % points.size()], i, m_segments);
    if(points.size() > 1)
      return;
    m_vertex = points[0].vertex();
    if(m_vertex == boost::graph_traits<TriangleMesh>::null_vertex())
      internal::append_segment(tm, points[0], points[0], 0, m_segments);
  }

  /// makes the curve along a range of halfedges, each of which begins where the one before ends. (Where two vertices
  /// are joined by several edges, this tells which one.)
  ///
  /// \tparam Halfedges a range of halfedge descriptors
  ///
  /// \param tm the triangle mesh
  /// \param halfedges the halfedges
  /// \return the curve; it is closed if the last halfedge ends where the first one begins
  template <typename Halfedges>
  static Surface_curve along_halfedges(const TriangleMesh& tm, const Halfedges& halfedges)
  {
    Surface_curve curve;
    vertex_descriptor first = boost::graph_traits<TriangleMesh>::null_vertex(), last = first;
    constexpr bool are_halfedges = internal::Is_range_of<Halfedges, halfedge_descriptor>::value;
    static_assert(are_halfedges, "the argument is not a range of halfedges of the mesh");
    if constexpr(are_halfedges) // else the errors of the loop would follow the message
      for(const halfedge_descriptor h : halfedges)
      {
        const std::size_t i = curve.m_segments.size();
        if(h == boost::graph_traits<TriangleMesh>::null_halfedge())
          internal::reject_curve(i, "is a null halfedge");
        if(internal::Removed_elements<TriangleMesh>::contain(h, tm))
          internal::reject_curve(i, "is not a halfedge of the mesh");
        if(i == 0)
          first = source(h, tm);
        else if(source(h, tm) != last)
          internal::reject_curve(i, "is a halfedge that does not begin where the one before ends");
        last = target(h, tm);
        curve.append_halfedge(tm, h, i);
      }
    if(curve.m_segments.empty())
      internal::reject_curve(0, "is missing: a curve needs one location");
    curve.m_is_closed = first == last;
    return curve;
  }

  /// @}

  /// \name Access
  /// @{

  /// returns the segments in their order. A point inside a face or an edge has one segment without length; the point at
  /// a vertex has none.
  const std::vector<Segment>& segments() const { return m_segments; }

  /// returns whether the curve is closed. A curve along halfedges is closed if it ends where it begins. One that was
  /// made of two locations or more is closed if that was asked for; else it is open, even if its last location is the
  /// first one. One of a single location is open.
  bool is_closed() const { return m_is_closed; }

  /// returns the vertex of a curve that is a single vertex; else the null vertex.
  /// The vertex may be isolated: then the curve is in no face.
  vertex_descriptor vertex() const { return m_vertex; }

  /// returns a point of a segment as a location in the face of that segment.
  ///
  /// \param segment the number of the segment, from 0
  /// \param parameter the part of the segment that lies before the point, from 0 to 1
  /// \return the face of the segment, and the coordinates of the point there: a weighted mean of those of its ends
  /// \pre the curve has a segment of that number: `segment < segments().size()`
  /// \pre `0 <= parameter <= 1`
  Face_location location(std::size_t segment, double parameter) const
  {
    CGAL_precondition_msg(segment < m_segments.size(), "the curve has no segment of this number");
    CGAL_precondition_msg(parameter >= 0 && parameter <= 1, "the parameter is not from 0 to 1");
    const Segment& s = m_segments[segment];
    Face_location result(s.face, Barycentric_coordinates{});
    for(std::size_t k = 0; k < 3; ++k)
      result.second[k] = (1 - parameter) * s.source[k] + parameter * s.target[k];
    return result;
  }

  /// returns the length of the curve, in the unit of the points.
  /// A segment that is run along several times counts each time.
  ///
  /// \tparam VertexPointMap as for `geodesic_distances()`
  ///
  /// \param tm the triangle mesh of the curve
  /// \param vertex_point_map gives the point of each vertex
  /// \return the sum of the lengths of the segments; 0 for a point. Takes linear time.
  template <typename VertexPointMap>
  double length(const TriangleMesh& tm, VertexPointMap vertex_point_map) const
  {
    using Point = typename internal::Value_of_map<VertexPointMap, vertex_descriptor>::type;
    static_assert(internal::Is_point<Point>::value,
                  "the argument is not a property map from the vertices of the mesh to points");
    double sum = 0;
    for(const Segment& s : m_segments)
    {
      std::array<double, 3> vector{};
      halfedge_descriptor h = halfedge(s.face, tm);
      for(std::size_t k = 0; k < 3; ++k, h = next(h, tm))
      {
        const auto& p = get(vertex_point_map, source(h, tm));
        const double weight = s.target[k] - s.source[k];
        vector[0] += weight * CGAL::to_double(p.x());
        vector[1] += weight * CGAL::to_double(p.y());
        vector[2] += weight * CGAL::to_double(p.z());
      }
      sum += std::hypot(vector[0], vector[1], vector[2]);
    }
    return sum;
  }

  /// returns the same, with the default points of the mesh.
  ///
  /// \param tm the triangle mesh of the curve
  double length(const TriangleMesh& tm) const { return length(tm, get_const_property_map(CGAL::vertex_point, tm)); }

  /// @}

private:
  friend internal::Private_access;

  Surface_curve() = default;

  // Requires: each segment begins at the point where the one before ends; there is at least one.
  Surface_curve(std::vector<Segment> segments, bool is_closed)
    : m_segments(std::move(segments)), m_is_closed(is_closed)
  {}

  void append_halfedge(const TriangleMesh& tm, halfedge_descriptor h, std::size_t position)
  {
    const bool is_reversed = is_border(h, tm);
    const halfedge_descriptor inner = is_reversed ? opposite(h, tm) : h;
    if(is_border(inner, tm))
      internal::reject_curve(position, "is a halfedge without a face on either side");
    m_segments.push_back(internal::segment_of_halfedge<Segment>(tm, inner, is_reversed, position));
  }

  std::vector<Segment> m_segments;
  vertex_descriptor m_vertex = boost::graph_traits<TriangleMesh>::null_vertex();
  bool m_is_closed = false;
};

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Surface_curve_point` is a point of a range of curves.

\sa `Geodesic_distance_solver::nearest_curve_point()`
*/
struct Surface_curve_point
{
  /// the position of the curve in its range, from 0.
  std::size_t curve;

  /// the number of the segment of the curve, from 0.
  std::size_t segment;

  /// the part of the segment that lies before the point, from 0 to 1.
  double parameter;
};

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

returns the cycles of border edges of a triangle mesh as closed curves, the surface on their right: their halfedges have
no face on the left. Takes linear time, and that of a set of border halfedges. Several threads may call the function
at once.

With faces to avoid, these are the borders of the other faces, as if the faces to avoid were not in the mesh: the rim of
these faces is a border, and an edge of the border whose face is avoided is none. So they are the curves for a
computation that avoids the same faces; it would reject a curve along edges all of whose faces are avoided. An edge
without a face is in no curve.

\code
geodesic_distances(mesh, distance, border_curves(mesh, CGAL::parameters::faces_to_avoid(water)),
                   CGAL::parameters::faces_to_avoid(water)); // from the coast, and from the border of the land
\endcode

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `face_index_map` and `faces_to_avoid`,
       with the types and defaults of `geodesic_distances()`

\return the curves in the order of their first halfedges in `halfedges(tm)`; none if there is no border

\throws Invalid_geodesic_input with the reason `INVALID_DESCRIPTOR`, and with the position of the face in its range, if
        a face to avoid is not one of the mesh; with the reason `NOT_A_TRIANGLE`, and with the position of the edge in
        its cycle, if a face at the border does not have three edges

\sa `Surface_curve`
*/
template <typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::vector<Surface_curve<TriangleMesh>> border_curves(const TriangleMesh& tm,
                                                       const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Curve = Surface_curve<TriangleMesh>;
  using halfedge_descriptor = typename Curve::halfedge_descriptor;
  internal::check_parameters<internal::Border_parameters>(tm, np);
  std::vector<Curve> curves;
  // A halfedge of the border is run along in the face on its other side.
  const auto append = [&](const std::vector<halfedge_descriptor>& cycle)
  {
    std::vector<typename Curve::Segment> segments;
    for(const halfedge_descriptor h : cycle)
      segments.push_back(
        internal::segment_of_halfedge<typename Curve::Segment>(tm, opposite(h, tm), true, segments.size()));
    curves.push_back(internal::Private_access::make<Curve>(std::move(segments), true));
  };
  if constexpr(internal::Has_parameter<CGAL_NP_CLASS, internal_np::faces_to_avoid_t>::value)
  {
    const auto fim = CGAL::get_initialized_face_index_map(tm, np);
    const internal::Obstacles obstacles{internal::avoided_faces(tm, fim, np), {}};
    internal::for_each_border_cycle(tm, [&](halfedge_descriptor h) {
      return !is_border(h, tm) && !obstacles.avoids(static_cast<std::size_t>(get(fim, face(h, tm))));
    }, append);
  }
  else
    internal::for_each_border_cycle(tm, [&](halfedge_descriptor h) { return !is_border(h, tm); }, append);
  return curves;
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_SURFACE_CURVE_H
