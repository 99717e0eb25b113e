#ifndef SURFACE_MESH_GEODESICS_DEMO_CURVE_OPTIONS_H
#define SURFACE_MESH_GEODESICS_DEMO_CURVE_OPTIONS_H

#include "Command.h"
#include "Console.h"
#include "Html_page.h"
#include "Location_options.h"
#include "Obstacle_option.h"
#include "Program_mesh.h"

#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>

#include <string>
#include <vector>

namespace geodesics_demo {

using Curve = CGAL::Surface_mesh_geodesics::Surface_curve<Mesh>;

// The options for curves in a role: --source-border and --source-curve for the role "source". They go with those for
// locations, and with --snap.
void declare_curves(Option_descriptions& options, const std::string& role);

// Is at least one of the options given?
bool are_curves_given(const Arguments& arguments, const std::string& role);

// The locations as curves of one point each, then the borders of the faces that are not avoided, then the curves of
// files: their points move to the faces that are not avoided, and shortest paths around the avoided faces and edges
// join them. Remarks on how far the points were moved.
// Throws a Command_error for a mesh without a border, and for what is wrong in a file, with the line.
std::vector<Curve> curves_of(const std::string& role, const Arguments& arguments, const Mesh& mesh,
                             const std::vector<Location>& locations, const Obstacles& avoided,
                             const Console& console);

// The curves as lines of a page; none for a point.
Html_lines lines_along(const std::vector<Curve>& curves, const Mesh& mesh);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_CURVE_OPTIONS_H
