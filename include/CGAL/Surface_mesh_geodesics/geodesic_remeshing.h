// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_REMESHING_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_REMESHING_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Remeshing.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_dual_report` tells whether the triangles of the dual of a geodesic Voronoi diagram form a manifold
mesh of the topology of the surface, and what prevents it. Cells are given by the numbers of their sites. A finding
disappears if there are more sites nearby, as the cells become smaller. Lists of single cells are in ascending order.

<b>The closed-ball property.</b> The dual is the intrinsic Delaunay triangulation of the sites if each part of the
diagram is a ball of its dimension, and meets the border of the mesh in one piece at most: each cell is a disk, any two
cells have one edge in common at most, any three one vertex, and at each vertex exactly three cells meet.
`is_triangulation()` tells whether that is so, and each list has the parts that violate one of the conditions.

\sa `check_geodesic_dual()`
*/
struct Geodesic_dual_report
{
  /// the nonempty cells that are not topological disks.
  std::vector<std::size_t> cells_that_are_not_disks;

  /// the cells that are disks, but meet the border of the mesh in several pieces: their boundary without the border of
  /// the mesh has several curves. The triangles around such a site would form several fans.
  std::vector<std::size_t> cells_with_several_boundaries;

  /// the nonempty cells whose sites are in no triangle.
  std::vector<std::size_t> cells_without_triangle;

  /// the pairs of cells that have several edges in common, the smaller number first.
  std::vector<std::pair<std::size_t, std::size_t>> pairs_with_several_edges;

  /// the pairs of cells whose common edge has no vertex, because it runs from border to border.
  std::vector<std::pair<std::size_t, std::size_t>> pairs_without_triangle;

  /// the triples of cells, in ascending order, that meet at several vertices of the diagram.
  std::vector<std::array<std::size_t, 3>> triples_with_several_vertices;

  /// the sites of each vertex of the diagram where more than three cells meet, in ascending order, as in symmetric
  /// diagrams. The dual has a polygon there, which is divided into triangles in one of several ways. So the triangles
  /// may form a manifold mesh nevertheless.
  std::vector<std::vector<std::size_t>> vertices_of_many_cells;

  /// whether the triangles form a polygon mesh at all, as
  /// `Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh()` tells. This may fail for a reason that no list shows.
  bool is_polygon_mesh = false;

  /// returns whether the triangles form a manifold mesh: there are no findings except vertices of many cells. Takes
  /// constant time.
  bool is_manifold() const
  {
    return is_polygon_mesh && cells_that_are_not_disks.empty() && cells_with_several_boundaries.empty()
        && cells_without_triangle.empty() && pairs_with_several_edges.empty() && pairs_without_triangle.empty()
        && triples_with_several_vertices.empty();
  }

  /// returns whether the diagram has the closed-ball property, so that its dual is the intrinsic Delaunay triangulation
  /// of the sites, and the only one: there are no findings. Takes constant time.
  bool is_triangulation() const { return is_manifold() && vertices_of_many_cells.empty(); }
};

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_remeshing_report` tells how `geodesic_remeshing()` came to its result: how many samples it added,
and which components of the mesh it left as they are.
*/
struct Geodesic_remeshing_report
{
#ifndef DOXYGEN_RUNNING
  using Dual_report = Geodesic_dual_report;
#endif

  /// A component of the mesh that kept its faces.
  struct Kept_component
  {
    /// the coordinates of one of its vertices.
    std::array<double, 3> point;

    /// the number of its vertices.
    std::size_t number_of_vertices;

    /// the number of its faces.
    std::size_t number_of_faces;
  };

  /// whether the new mesh was added to the output. It is `false` only if the visitor canceled.
  bool is_complete = false;

  /// the number of samples that `geodesic_farthest_point_sampling()` chose: at most what was asked for.
  std::size_t number_of_samples = 0;

  /// the number of samples that were added so that the dual is manifold.
  std::size_t number_of_added_samples = 0;

  /// the number of vertices of the new mesh.
  std::size_t number_of_vertices = 0;

  /// the number of vertices that the new mesh has more because the given one is pinched: a vertex with several
  /// umbrellas of faces counts as several vertices.
  std::size_t number_of_split_vertices = 0;

  /// the number of components of the mesh.
  std::size_t number_of_components = 0;

  /// the number of components that stay as they are because each of their vertices became a sample at once.
  std::size_t number_of_components_of_samples = 0;

  /// the components that stay as they are because their dual would need as many samples as they have vertices, or
  /// because they have none: all their points are equal, or on a line.
  std::vector<Kept_component> kept_components;

  /// the number of diagrams that were computed after the relaxation.
  std::size_t number_of_rounds = 0;

  /// returns whether the output received a manifold mesh; the same as `is_complete`.
  bool is_manifold() const { return is_complete; }
};

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

checks whether the triangles of the dual of a diagram form a manifold mesh, and finds what prevents it: cells that are
not disks, pairs of cells with several common edges, and so on. Where the surface has a border, the dual has one as
well, farther inside.

<b>Complexity.</b> Takes \cgalBigO{k \log k} time for \f$ k \f$ arcs and edges of the diagram, the time of
`Surface_mesh_geodesic_Voronoi_diagram::is_disk()` for each cell, and that of
`Surface_mesh_geodesic_Voronoi_diagram::build()` if the diagram is not built yet.

<b>Thread safety.</b> Several threads may call the function at once, on the same diagram as well.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param diagram the diagram

\return the findings

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid
*/
template <typename Diagram>
Geodesic_dual_report check_geodesic_dual(const Diagram& diagram)
{
  static_assert(internal::Checked_diagram<Diagram>::value, "always true, if it compiles");
  return internal::Dual_check<Diagram, Geodesic_dual_report>(diagram).report();
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

adds the dual of a diagram to a mesh if it is manifold: the vertices are the sites, and each vertex of the diagram makes
a triangle. Sites that are in no triangle get no vertex.

Complexity and thread safety are those of `check_geodesic_dual()`; each call needs an output of its own.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`
\tparam OutputMesh a model of `MutableFaceGraph` with an internal property for `CGAL::vertex_point_t`, whose points are
        constructible from three coordinates of type `double`

\param diagram the diagram
\param output the mesh to which the triangles are added. It is not changed if the dual is not manifold.

\return the findings of `check_geodesic_dual()`

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid
*/
template <typename Diagram, typename OutputMesh>
Geodesic_dual_report geodesic_dual_mesh(const Diagram& diagram, OutputMesh& output)
{
  static_assert(internal::Checked_diagram<Diagram>::value, "always true, if it compiles");
  static_assert(internal::Checked_output_mesh<OutputMesh>::value, "always true, if it compiles");
  return internal::add_dual_mesh<Geodesic_dual_report>(diagram, output);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

approximates a triangle mesh by a mesh with about `n` vertices (thesis, section 5.4.4).

The function chooses `n` vertices with `geodesic_farthest_point_sampling()`, and moves them with
`geodesic_Lloyd_relaxation()`. Samples on the border of the mesh stay where they are. The dual of their geodesic Voronoi
diagram is the new mesh.

<b>Added samples.</b> Where the dual is not manifold (`Geodesic_dual_report`), or has a triangle without area, the
function adds samples: in a cell that is not a disk the vertex farthest from its sample, along a hole first; between two
cells with several common edges a vertex near the farthest point of these edges. Where no vertex is left, a point of a
face becomes a sample. Then it checks the diagram of all samples again, until the dual of each component is manifold.

<b>Topology.</b> Each component of the new mesh is manifold and has the Euler characteristic and the number of borders
of a component of `tm`. It has no triangle without area, unless the component stays as it is. (If `tm` has vertices with
several umbrellas of faces, it counts as a mesh with a vertex for each umbrella.)

<b>Components that stay as they are.</b> If each vertex of a component would be a sample, its faces are copied. That
holds for components with few vertices, and for each mesh if `n` is at least the number of its vertices. The faces are
also copied if all points of a component are equal, or on a line, as it has no dual then. The report tells where a
component stays as it is although fewer samples were asked for.

<b>Faces to avoid</b> are left out, as if `tm` did not have them: the new mesh has a border along their rim. Without
them, `tm` may have more components, and more vertices with several umbrellas.

<b>Complexity.</b> Takes the time of the sampling, of the relaxation, and of a diagram for each round; the report has
the number of rounds. No component gets more samples than vertices, and there are at most 100 rounds. Often one to ten
are enough. The memory is that of one diagram and of a copy of the mesh.

<b>Parallelism.</b> With `Parallel_tag`, threads share the work on each diagram; one thread chooses the first samples.
See `geodesic_Lloyd_relaxation()`.

<b>Thread safety.</b> Several threads may call the function at once, on the same mesh as well, if each call writes to an
output of its own; see `geodesic_distances()`.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`, as for `geodesic_distances()`
\tparam TriangleMesh a model of `FaceListGraph`; its points are converted to `double`
\tparam OutputMesh a model of `MutableFaceGraph` with an internal property for `CGAL::vertex_point_t`, whose points are
        constructible from three coordinates of type `double`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param n the number of samples before others are added. A component gets as many as it needs, whatever `n` is.
\param output the mesh to which the result is added
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
    \cgalParamDescription{a visitor that follows one propagation for each of the `n` samples, one for each iteration,
    and one for each round. If it cancels one, nothing is added to `output`.}
    \cgalParamType{a class model of `GeodesicPropagationVisitor`. If it is also a model of
                   `GeodesicRelaxationVisitor`, it is told of each iteration.}
    \cgalParamDefault{`Geodesic_default_visitor`}
    \cgalParamExtra{The visitor is not copied if it is passed with `std::ref()`.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the largest number of iterations of the relaxation; not negative}
    \cgalParamType{unsigned int}
    \cgalParamDefault{`5`}
  \cgalParamNEnd
  \cgalParamNBegin{threshold_distance}
    \cgalParamDescription{the relaxation ends after an iteration that moves no site farther in space than this
                          distance, in the unit of the mesh; not negative}
    \cgalParamType{double}
    \cgalParamDefault{`0`: it ends when no site moves}
  \cgalParamNEnd
  \cgalParamNBegin{faces_to_avoid}
    \cgalParamDescription{the faces that are left out, as for `geodesic_distances()`. (There are no edges to avoid: the
                          new surface has none of the edges. \ref Surface_mesh_geodesics_obstacles tells the way.)}
    \cgalParamType{a range of face descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   face descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre `number_of_iterations` and `threshold_distance` are numbers that are not negative.

\return the numbers of samples and of rounds, and the components that stay as they are. If the visitor cancels, the
result is a `Geodesic_remeshing_report()`, which is not complete.

\throws Invalid_geodesic_input if the mesh or a face to avoid is invalid; nothing has been added to `output` then
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename OutputMesh,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Geodesic_remeshing_report geodesic_remeshing(const TriangleMesh& tm, std::size_t n, OutputMesh& output,
                                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Remeshing_parameters>(tm, np);
  static_assert(internal::Checked_output_mesh<OutputMesh>::value, "always true, if it compiles");
  internal::Visitor_parameter<CGAL_NP_CLASS> visitor(np);
  return internal::remesh<Surface_mesh_geodesic_Voronoi_diagram, ConcurrencyTag, Geodesic_remeshing_report>(
    tm, n, output, visitor.visitor(), np);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_REMESHING_H
