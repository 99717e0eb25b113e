// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_LLOYD_RELAXATION_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_LLOYD_RELAXATION_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

moves sites to the centers of their cells again and again (Lloyd's method), so that the cells become round and similar
in area.

Each iteration computes the geodesic Voronoi diagram of the sites. Then each site moves to the vertex in its cell that
is nearest in space to the centroid of the cell; of equally near vertices to the first one in the order of
`vertices(tm)`. This is `Surface_mesh_geodesic_Voronoi_diagram::central_vertex()`. All sites move at once. A site stays
where it is if its cell is empty or holds no vertex. No site leaves its component.

<b>Curves.</b> Curves from which sites keep away, such as the border of the mesh, are sites that do not move: the cells
of the other sites end where a curve is nearer. So a site rests about as far from a curve as from its neighbors, while
without curves it is only half as far from a border. A site on a curve has an empty cell and stays. A curve of one
location is a point that stays.

The relaxation ends when no site moves, or no site moves farther than a given distance, and at the latest after the
given number of iterations. Without such a distance it may not end by itself: a site may go back and forth between
vertices that are about equally good.

<b>Energy.</b> The method lowers the sum over all cells of the integral of \f$ |p - s|^2 \f$ over the points
\f$ p \f$ of the cell of the site \f$ s \f$, with distances in space
(`Surface_mesh_geodesic_Voronoi_diagram::energy()`). For the cells of an iteration, the move of the sites never raises
it: no vertex of a cell has a smaller integral than the one that is nearest to the centroid. The next cells minimize
geodesic distances instead, so they may raise it by a little. A visitor that is a model of `GeodesicRelaxationVisitor`
receives the energy of each iteration. Cells of curves add nothing to it, but for curves of one location, which are
points. The move of the sites never raises this sum either. But the next cells may be much larger, where a site has
moved away from a curve, and then the energy rises from iteration to iteration; `threshold_distance` still tells when
sites are at rest.

<b>Complexity.</b> The mesh is read once. Each iteration takes the time and the memory of one diagram, and time linear
in the size of the mesh. With curves, diagrams keep all windows.

<b>Parallelism.</b> With `Parallel_tag`, threads share the work on each diagram, as in
`Surface_mesh_geodesic_Voronoi_diagram`; with curves, one thread divides the faces. The result does not depend on the
number of threads. It may differ from that of `Sequential_tag` where two vertices of a cell are about equally near to
its centroid. The calling thread alone calls the functions of the visitor.

<b>Thread safety.</b> Several threads may call the function at once, on the same mesh as well, if each call writes to an
output of its own; see `geodesic_distances()`.

The method serves remeshing (thesis, section 5.4.4), see `geodesic_remeshing()`.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`, as for `geodesic_distances()`
\tparam TriangleMesh a model of `FaceListGraph`; its points are converted to `double`
\tparam VertexRange a range of vertex descriptors of `TriangleMesh`
\tparam OutputIterator a model of `OutputIterator` that holds vertex descriptors of `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param sites the initial sites
\param output receives the final sites, in the order of `sites`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh`
                   as key type and the 3D point type of a kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of `tm` a unique index between `0`
                          and `num_vertices(tm) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh`
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{a property map associating to each face of `tm` a unique index between `0`
                          and `num_faces(tm) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the face descriptor of `TriangleMesh`
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{a visitor that follows one propagation for each iteration. If it cancels one, the relaxation
                          ends with the sites of the previous iteration.}
    \cgalParamType{a class model of `GeodesicPropagationVisitor`. If it is also a model of
                   `GeodesicRelaxationVisitor`, it is told of each iteration.}
    \cgalParamDefault{`Geodesic_default_visitor`}
    \cgalParamExtra{The visitor is not copied if it is passed with `std::ref()`.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the largest number of iterations; not negative}
    \cgalParamType{unsigned int}
    \cgalParamDefault{`10`}
  \cgalParamNEnd
  \cgalParamNBegin{threshold_distance}
    \cgalParamDescription{the relaxation ends after an iteration that moves no site farther in space than this
                          distance, in the unit of the mesh; not negative}
    \cgalParamType{double}
    \cgalParamDefault{`0`: it ends when no site moves}
  \cgalParamNEnd
  \cgalParamNBegin{first_curves}
    \cgalParamDescription{curves from which the sites keep away, see above. They are sites that do not move, and are not
                          written. `Surface_curve` makes curves, `border_curves()` returns borders.}
    \cgalParamType{a `Surface_curve` on `tm`, or a range of these}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{faces_to_avoid}
    \cgalParamDescription{the faces through which no path may lead, as for `geodesic_distances()`: cells end at their
                          rim. Sites inside are invalid.}
    \cgalParamType{a range of face descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   face descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
  \cgalParamNBegin{edges_to_avoid}
    \cgalParamDescription{walls: edges that no path may cross, as for `geodesic_distances()`. Cells end there
                          (`Surface_mesh_geodesic_Voronoi_diagram::avoid_edges()`). A site that moves to a vertex of a
                          wall is a site on all of its sides from then on.}
    \cgalParamType{a range of edge descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   edge descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre `number_of_iterations` and `threshold_distance` are numbers that are not negative.

\return the number of iterations that moved a site. It is less than `number_of_iterations` if no site moves any more, if
        an iteration before the last one moves none farther than `threshold_distance`, or if the visitor cancels.

\throws Invalid_geodesic_input if the mesh, a site or a curve is invalid, as for `geodesic_distances()`: with the reason
        `INVALID_CURVE` if rounding hides where segments of curves run. Nothing has been written then. (If
        `number_of_iterations` is 0, nothing is checked, and the sites are written as they are.)
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename VertexRange,
          typename OutputIterator, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t geodesic_Lloyd_relaxation(const TriangleMesh& tm, const VertexRange& sites,
                                      OutputIterator output, const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Relaxation_parameters>(tm, np);
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  constexpr bool are_vertices = internal::Is_range_of<VertexRange, vertex_descriptor>::value;
  static_assert(are_vertices, "the sites are not a range of vertices of the mesh");
  static_assert(internal::Checked_output_iterator<OutputIterator, vertex_descriptor&>::value,
                "always true, if it compiles");
  internal::Visitor_parameter<CGAL_NP_CLASS> visitor_parameter(np);
  auto& visitor = visitor_parameter.visitor();
  std::vector<vertex_descriptor> moved;
  if constexpr(are_vertices) // else the errors of the standard library would follow the message
    moved.assign(std::begin(sites), std::end(sites));
  const std::size_t number_of_iterations
    = internal::value_parameter<std::size_t>(np, internal_np::number_of_iterations, 10);
  const std::size_t n
    = internal::relax_sites<Surface_mesh_geodesic_Voronoi_diagram, ConcurrencyTag>(
      tm, moved, number_of_iterations, visitor, np, [](auto) { return false; });
  if constexpr(internal::Is_output_iterator<OutputIterator, vertex_descriptor&>::value)
    std::copy(moved.begin(), moved.end(), output);
  return n;
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_LLOYD_RELAXATION_H
