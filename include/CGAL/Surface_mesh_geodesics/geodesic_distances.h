// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCES_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCES_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_parameters.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

computes the exact geodesic distance from a source, or from the nearest of several sources, to each
vertex of a triangle mesh.

The function writes to `vertex_distance_map`, for each vertex of `tm`, the length of a shortest path on
the surface from a source to the vertex, in the unit of the points. The distance is exact up to
rounding: the function computes with `double`, and the relative error is in general a few
\f$ 10^{-15} \f$. A vertex that no source reaches gets infinity; so do all vertices if the range of
sources is empty. The distance of a source vertex is its offset, which is 0 by default.

Shortest paths cross edges, run along them and pass vertices, also pinched ones. Edges without
length, faces without area, duplicate points, borders, several components and isolated vertices are
allowed. Of several components, only those are processed that a source can reach. In the others, neither their sizes
nor the agreement of neighbors about their edge is checked.

The algorithm is VTP (vertex-oriented triangle propagation), by Qin et al. \cgalCite{qin2016fast}. A wavefront of
vertices, nearest first, moves lists of windows from edge to edge, and prunes them in each triangle. In the worst case
it takes \cgalBigO{n^2} time and memory for \f$ n \f$ vertices (thesis, section 4.4). The memory holds the mesh, the
distances and the windows on the wavefront. Usual meshes take far less of both: see \ref
Surface_mesh_geodesics_performance. With a radius or with targets, the propagation takes time proportional to the
number of windows in the area that it reaches. Each call still reads the whole mesh, in linear time; a
`Geodesic_distance_solver` reads it once for many computations.

With `Parallel_tag`, several threads prepare the mesh, and visit vertices of the wavefront at the same time. (If the
sources reach fewer than 16384 faces, one thread visits all: there, several gain little or nothing.) The distances do
not depend on the number of threads; they may differ from those of `Sequential_tag` in the last digits. The calling
thread alone calls the functions of the visitor, less often than with `Sequential_tag`. It alone reads the mesh and the
property maps, with two exceptions. Several threads read the elements of a `CGAL::Surface_mesh` without garbage, if the
index maps are its own and nothing is avoided. And they read points that a `CGAL::Surface_mesh` stores, in any
`Property_map`, if the coordinates are built-in floating point numbers.

<b>Thread safety.</b> Several threads may call the function at once, also on the same mesh, if each call writes to maps
of its own and no thread changes the mesh or its points. Indices that are stored in the elements of the mesh (such as
those of `Polyhedron_items_with_id_3`) must be set before, as the first call would set them otherwise.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. The number of threads is that of
        \tbb, which may be limited with `tbb::task_arena` or `tbb::global_control`.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexDistanceMap a model of `WritablePropertyMap` with the vertex descriptor of
        `TriangleMesh` as key type and a floating point type as value type
\tparam Sources a source or a range of sources. A source is a vertex descriptor, or a location in a
        face: a `std::pair` of a face descriptor and three barycentric coordinates (anything with an
        `operator[]` for 0, 1, 2, such as `std::array`) of a number type that `CGAL::to_double()`
        takes. This is the type `Face_location` of `Surface_mesh_shortest_path`. Or a source is a `Surface_curve`: the
        distance of a vertex is then the smallest distance from a point of the curve. With curves as sources, a single
        thread computes, whatever the tag.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param vertex_distance_map receives the distance of each vertex; infinity beyond the radius, and for vertices whose
       distances are not final when the computation stops at the targets
\param sources the source or sources. Barycentric coordinates are those of
       `source(halfedge(f,tm),tm)`, `target(halfedge(f,tm),tm)` and
       `target(next(halfedge(f,tm),tm),tm)`, in this order, for a face `f`. Coordinates up to
       \f$ 64 \epsilon \approx 1.4 \cdot 10^{-14} \f$ count as zero, and their sum as one. So
       a location at a vertex or on an edge may be rounded, and may be given in any face around it.
       A location is in its face if no coordinate is less than \f$ -\delta \f$, and their sum
       is one up to \f$ \delta = \sqrt\epsilon / 16 \approx 9.3 \cdot 10^{-10} \f$. For
       coordinates of type `float`, \f$ \epsilon \f$ is that of `float`, and
       \f$ \delta \approx 2.2 \cdot 10^{-5} \f$
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh`
                   as key type and a 3D point type with the members `x()`, `y()`, `z()` as value type}
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
    \cgalParamDescription{a visitor that follows the progress and may cancel the computation}
    \cgalParamType{a class model of `GeodesicPropagationVisitor`}
    \cgalParamDefault{`Geodesic_default_visitor`}
    \cgalParamExtra{The visitor is not copied if it is passed with `std::ref()`.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_distance}
    \cgalParamDescription{the radius, in the unit of the mesh; not negative. Vertices that are farther away get
                          infinity. Faces that are farther away cost nothing in the propagation.}
    \cgalParamType{a number that converts to `double`}
    \cgalParamDefault{infinity}
  \cgalParamNEnd
  \cgalParamNBegin{targets}
    \cgalParamDescription{if not empty, the computation stops as soon as the distances of all these vertices are final.
                          Vertices whose distances are not final then get infinity. If no source reaches one of the
                          targets, all distances are computed.}
    \cgalParamType{a range of vertex descriptors of `TriangleMesh`}
    \cgalParamDefault{an empty range: all vertices}
  \cgalParamNEnd
  \cgalParamNBegin{source_offsets}
    \cgalParamDescription{empty, or one number for each source, which is added to all distances from that source. In
                          the unit of the mesh, not negative, and finite, also as a multiple of the extent of the mesh.
                          A source that another source reaches with a smaller distance than its offset is the nearest
                          source of no vertex.}
    \cgalParamType{a range of numbers that convert to `double`}
    \cgalParamDefault{an empty range: all offsets are 0}
  \cgalParamNEnd
  \cgalParamNBegin{nearest_source_map}
    \cgalParamDescription{a property map that receives, for each vertex, the position in the range of sources, counted
                          from 0, of a source from which its distance is measured, or the largest `std::size_t` where
                          no source reaches. If several sources have this distance, it is the position of one of them;
                          of those at the same point with the same offset, the first. The map is unchanged if the
                          visitor cancels or the input is invalid.}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertex descriptor of `TriangleMesh` as key type and
                   `std::size_t` as value type, passed by value}
    \cgalParamDefault{none: the nearest sources are not computed}
  \cgalParamNEnd
  \cgalParamNBegin{statistics}
    \cgalParamDescription{if not null, the computation <em>adds</em> its counts to the object, also if the visitor
                          canceled it. Computations that run at the same time must not share an object.}
    \cgalParamType{a pointer to `Propagation_statistics`}
    \cgalParamDefault{`nullptr`}
  \cgalParamNEnd
  \cgalParamNBegin{faces_to_avoid}
    \cgalParamDescription{the faces through which no path may lead, as if they were not in the mesh. Paths may run along
                          their rim. Vertices that no way around reaches get infinity. Sources may be at the rim, also
                          if their location is given in a face to avoid; a source inside is rejected.}
    \cgalParamType{a range of face descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   face descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
    \cgalParamExtra{Where `Invalid_geodesic_input::element()` is a face, faces to avoid do not count.}
  \cgalParamNEnd
  \cgalParamNBegin{edges_to_avoid}
    \cgalParamDescription{the edges that no path may cross. Paths may run along them and around the free end of a chain
                          of them, but do not pass from one side to the other at a vertex inside of the chain. A source
                          on such an edge is on both sides; a vertex has the least distance of its sides.}
    \cgalParamType{a range of edge descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   edge descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
    \cgalParamExtra{A curve may cross such edges, and is a source on all sides of those on which it is. With `targets`
                    on such edges, the computation waits for all of their sides that are connected to a source.}
  \cgalParamNEnd
\cgalNamedParamsEnd

How to write sequences of parameters, and which one comes first: \ref Surface_mesh_geodesics_named_parameters.

\return `true`, or `false` if the visitor canceled the computation; only the statistics have changed then.

\throws Invalid_geodesic_input if a face is not a triangle or has a vertex twice, if two faces disagree about the ends
        of their edge, if a coordinate is not finite or the extent of the points exceeds \f$ 2^{960} \f$, if one of
        several components that sources can reach is smaller than the others by a factor of more than \f$ 10^{60} \f$,
        if a location is not in its face or has a null face, if a descriptor is not one of `tm` according to the index
        maps, if an index map has values that are out of range or equal, or if the mesh has too many faces; also if a
        source is inside of the faces to avoid, if an edge to avoid is not in `tm`, if a target is not a vertex of `tm`,
        if the radius is negative or not a number, if an offset is negative, not finite, or more than about
        \f$ 10^{12} \f$ times the extent of the mesh, or if there is not one offset for each source; with the reason
        `INVALID_CURVE` if segments of curves nearly coincide, so that rounding hides where they run. The maps are
        unchanged then.
\throws std::bad_alloc if there is not enough memory. The maps are unchanged then, and also if the visitor throws; its
        exception is passed on.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename VertexDistanceMap,
          typename Sources, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool geodesic_distances(const TriangleMesh& tm, VertexDistanceMap vertex_distance_map,
                        const Sources& sources,
                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Distance_parameters>(tm, np);
  return internal::compute_distances_with_parameters<ConcurrencyTag>(
    tm, vertex_distance_map, sources, internal::shape_from_points<double>(tm, np), np);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

computes geodesic distances on a surface that is given by the lengths of its edges. The surface need
not be embedded in space. Complexity and thread safety are those of `geodesic_distances()`.

\tparam ConcurrencyTag as for `geodesic_distances()`
\tparam TriangleMesh a model of `FaceListGraph` and `EdgeListGraph`
\tparam VertexDistanceMap as for `geodesic_distances()`
\tparam Sources as for `geodesic_distances()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam EdgeLengthMap a model of `ReadablePropertyMap` with the edge descriptor of `TriangleMesh` as key
        type and a number type that `CGAL::to_double()` takes as value type

\param tm the triangle mesh
\param edge_length_map the lengths: finite, not negative, and such that no edge is longer than the two
       others of a face (beyond rounding)
\param vertex_distance_map receives the distance of each vertex, in the unit of the lengths
\param sources the source or sources, as for `geodesic_distances()`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
       `geodesic_distances()`, except `vertex_point_map`

\return `true`, or `false` if the visitor canceled the computation; only the statistics have changed then.

\throws Invalid_geodesic_input also if a length is negative or not finite, or if a face violates the
        triangle inequality by more than \f$ 64 \epsilon \approx 1.4 \cdot 10^{-14} \f$ of its longest
        edge
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename EdgeLengthMap,
          typename VertexDistanceMap, typename Sources, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool geodesic_distances_from_edge_lengths(const TriangleMesh& tm, EdgeLengthMap edge_length_map,
                                          VertexDistanceMap vertex_distance_map, const Sources& sources,
                                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::check_parameters<internal::Edge_length_distance_parameters>(tm, np);
  return internal::compute_distances_with_parameters<ConcurrencyTag>(
    tm, vertex_distance_map, sources,
    internal::Shape_from_edge_lengths<double, TriangleMesh, EdgeLengthMap>(tm, edge_length_map), np);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCES_H
