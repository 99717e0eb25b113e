// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_WRITE_GEODESIC_VORONOI_DIAGRAM_H
#define CGAL_SURFACE_MESH_GEODESICS_WRITE_GEODESIC_VORONOI_DIAGRAM_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/drawing/diagram_writers.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

writes the edges of a geodesic Voronoi diagram as polylines in the OBJ format. The edge between the cells of the sites
`i` and `j` is a group with the name `edge_i_j` that holds one line. Neighboring edges do not share vertices.

<b>Complexity.</b> Takes time and memory linear in the number of points that are written, in addition to the time of
`Surface_mesh_geodesic_Voronoi_diagram::build()` if the diagram is not built yet.

<b>Thread safety.</b> Several threads may call the function at once, on the same diagram as well, if each has a stream
of its own.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param os the stream. Coordinates are written with its precision; 17 digits reproduce them exactly.
\param diagram the diagram
\param tolerance the largest distance of the polylines from the arcs, in the unit of the mesh

\return `true` if everything has been written; otherwise the stream may hold a part of the file

\pre `tolerance` is positive and finite.

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid. Nothing has been
        written then.
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram_OBJ(std::ostream& os, const Diagram& diagram, double tolerance)
{
  static_assert(internal::Checked_diagram<Diagram>::value, "always true, if it compiles");
  return internal::write_diagram_OBJ(os, diagram, tolerance);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

calls `write_geodesic_Voronoi_diagram_OBJ()` with the default tolerance,
`Surface_mesh_geodesic_Voronoi_diagram::default_tolerance()`.

\param os the stream
\param diagram the diagram

\return as the function with a tolerance

\throws Invalid_geodesic_input as the function with a tolerance
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram_OBJ(std::ostream& os, const Diagram& diagram)
{
  static_assert(internal::Checked_diagram<Diagram>::value, "always true, if it compiles");
  return write_geodesic_Voronoi_diagram_OBJ(os, diagram, diagram.default_tolerance());
}

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

writes a geodesic Voronoi diagram in the PLY format, in binary if the mode of the stream is `CGAL::IO::BINARY`, and else
as text. The file holds

- the mesh, cut along the arcs as by `Surface_mesh_geodesic_Voronoi_diagram::cut()`. Each face has a color and the
  property `site`, which is the number of its site, or -1 if no site reaches it;
- the boundaries of the cells as elements `edge`, one for each edge between two faces of different cells, with the
  properties `left_site` and `right_site`. They share the vertices of the faces;
- a comment with the color of each site.

The colors are those of `geodesic_Voronoi_cell_colors()`; faces that no site reaches are gray.

The complexity is that of `Surface_mesh_geodesic_Voronoi_diagram::cut()`. Thread safety and exceptions are those of
`write_geodesic_Voronoi_diagram_OBJ()`.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param os the stream. A stream of a file needs `std::ios::binary` for the binary mode. In text, coordinates are written
       with its precision; 17 digits reproduce them exactly.
\param diagram the diagram
\param tolerance the largest distance of the polylines from the arcs, in the unit of the mesh

\return `true` if everything has been written; otherwise the stream may hold a part of the file. A file
        has fewer than 2<sup>31</sup> points.

\pre `tolerance` is positive and finite.

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram_PLY(std::ostream& os, const Diagram& diagram, double tolerance)
{
  static_assert(internal::Checked_diagram<Diagram>::value, "always true, if it compiles");
  return internal::write_diagram_PLY(os, diagram, tolerance);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

calls `write_geodesic_Voronoi_diagram_PLY()` with the default tolerance,
`Surface_mesh_geodesic_Voronoi_diagram::default_tolerance()`.

\param os the stream
\param diagram the diagram

\return as the function with a tolerance

\throws Invalid_geodesic_input as the function with a tolerance
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram_PLY(std::ostream& os, const Diagram& diagram)
{
  static_assert(internal::Checked_diagram<Diagram>::value, "always true, if it compiles");
  return write_geodesic_Voronoi_diagram_PLY(os, diagram, diagram.default_tolerance());
}

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

writes a geodesic Voronoi diagram as polygonal data in the legacy VTK format, in binary if the mode of the stream is
`CGAL::IO::BINARY`, and else as text: first the edges as polylines, then the faces of the mesh, cut along the arcs as by
`Surface_mesh_geodesic_Voronoi_diagram::cut()`.

The cell data consist of three numbers. `site` is the site of a face, and -1 for an edge. `left_site` and `right_site`
are the sites on both sides of an edge; for a face, both are its site. Faces that no site reaches have -1.

The complexity is that of `Surface_mesh_geodesic_Voronoi_diagram::cut()`. Thread safety and exceptions are those of
`write_geodesic_Voronoi_diagram_OBJ()`.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param os the stream. A stream of a file needs `std::ios::binary` for the binary mode. In text, coordinates are written
       with its precision; 17 digits reproduce them exactly.
\param diagram the diagram
\param tolerance the largest distance of the polylines from the arcs, in the unit of the mesh

\return `true` if everything has been written; otherwise the stream may hold a part of the file. A file
        has fewer than 2<sup>31</sup> points.

\pre `tolerance` is positive and finite.

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram_VTK(std::ostream& os, const Diagram& diagram, double tolerance)
{
  static_assert(internal::Checked_diagram<Diagram>::value, "always true, if it compiles");
  return internal::write_diagram_VTK(os, diagram, tolerance);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

calls `write_geodesic_Voronoi_diagram_VTK()` with the default tolerance,
`Surface_mesh_geodesic_Voronoi_diagram::default_tolerance()`.

\param os the stream
\param diagram the diagram

\return as the function with a tolerance

\throws Invalid_geodesic_input as the function with a tolerance
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram_VTK(std::ostream& os, const Diagram& diagram)
{
  static_assert(internal::Checked_diagram<Diagram>::value, "always true, if it compiles");
  return write_geodesic_Voronoi_diagram_VTK(os, diagram, diagram.default_tolerance());
}

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

writes a geodesic Voronoi diagram to a file. The extension of the name, in lower case, selects the format: `.obj` (text,
with 17 digits), `.ply` or `.vtk` (binary). The functions for streams also write PLY and VTK as text.

Complexity and thread safety are those of the function for the format.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param filename the name of the file. An existing file is overwritten.
\param diagram the diagram
\param tolerance the largest distance of the polylines from the arcs, in the unit of the mesh

\return `true` if everything has been written. For another extension the function returns `false` and does not touch the
        file.

\pre `tolerance` is positive and finite.

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid. The file has not
        been touched then.

\sa `write_geodesic_Voronoi_diagram_OBJ()`, `write_geodesic_Voronoi_diagram_PLY()`,
    `write_geodesic_Voronoi_diagram_VTK()`
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram(const std::string& filename, const Diagram& diagram, double tolerance)
{
  static_assert(internal::Checked_diagram<Diagram>::value, "always true, if it compiles");
  return internal::write_diagram_file(filename, diagram, tolerance);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

calls `write_geodesic_Voronoi_diagram()` with the default tolerance,
`Surface_mesh_geodesic_Voronoi_diagram::default_tolerance()`.

\param filename the name of the file
\param diagram the diagram

\return as the function with a tolerance

\throws Invalid_geodesic_input as the function with a tolerance
*/
template <typename Diagram>
bool write_geodesic_Voronoi_diagram(const std::string& filename, const Diagram& diagram)
{
  static_assert(internal::Checked_diagram<Diagram>::value, "always true, if it compiles");
  return write_geodesic_Voronoi_diagram(filename, diagram, diagram.default_tolerance());
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_WRITE_GEODESIC_VORONOI_DIAGRAM_H
