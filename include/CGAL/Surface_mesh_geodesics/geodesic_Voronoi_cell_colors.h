// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_CELL_COLORS_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_CELL_COLORS_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/internal/applications/drawing/Cell_coloring.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>

#include <CGAL/IO/Color.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsIO

returns a color for the cell of each site of a geodesic Voronoi diagram, for pictures.

There are twelve colors, which remain distinct for eyes that confuse red with green, or yellow with blue. Two cells with
a common edge have different colors on every orientable surface with up to six handles if all cells are connected, as
they are without curves and walls. Otherwise a few pairs of such cells may share a color. If there are at most twelve
sites, all colors are different. The colors depend only on the numbers of the sites and on which cells are adjacent.

Cells are colored one after the other, each with a color that no neighbor has. They are ordered such that few neighbors
of a cell come before it (the smallest-last order of Matula and Beck \cgalCite{matula1983smallest}).

<b>Complexity.</b> Takes \cgalBigO{k \log n} time for \f$ n \f$ sites and \f$ k \f$ pairs of adjacent cells, in
addition to the time of `Surface_mesh_geodesic_Voronoi_diagram::build()` if the diagram is not built yet.

<b>Thread safety.</b> Several threads may call the function at once, on the same diagram as well.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param diagram the diagram

\return one color for each site, in the order of the sites; sites with an empty cell have a color, too

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid

\sa `write_geodesic_Voronoi_diagram_PLY()`
*/
template <typename Diagram>
std::vector<IO::Color> geodesic_Voronoi_cell_colors(const Diagram& diagram)
{
  static_assert(internal::Checked_diagram<Diagram>::value, "always true, if it compiles");
  return internal::cell_colors(diagram);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_CELL_COLORS_H
