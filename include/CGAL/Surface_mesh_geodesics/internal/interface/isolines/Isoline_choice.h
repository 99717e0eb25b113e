// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_ISOLINES_ISOLINE_CHOICE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_ISOLINES_ISOLINE_CHOICE_H

// Which isolines of a Path_solver are wanted: all of them, or those on one side of curves.
//
// No number decides the side. The curves are chains of edges of the refined mesh, so a face of that mesh is wholly on
// one side, and Curve_sides has its color. A line of a distance d > 0 has no point of a curve, since these have the
// distance 0: it leaves a face across an edge of no curve, behind which the color is the same. So each line is on one
// side, and any face that has a point of it on its boundary tells which, however near to the curve the line is.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Isoline_graph.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Curve_sides.h>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A choice is called with the solver when it has its windows, and returns a function that tells of a point of a line
// whether this line is wanted.
struct All_isolines
{
  template <typename Solver>
  auto operator()(const Solver&) const
  {
    return [](const Isoline_point<double>&) { return true; };
  }
};

// Those on the negative side of the curves, or on the other one. Throws Invalid_geodesic_input if there is no curve
// among the sources, if a source has an offset (with one, a line may cross a curve), and if the curves do not separate
// the surface. Takes linear time.
struct Isolines_on_side
{
  bool is_negative;

  template <typename Solver>
  auto operator()(const Solver& solver) const
  {
    using Reason = Invalid_geodesic_input::Reason;
    if(!solver.has_curves())
      throw Invalid_geodesic_input(Reason::INVALID_CURVE, "only curves have sides, but there is none");
    const auto& curves = solver.curve_arrivals().curves;
    for(const auto& v : curves.vertices)
      if(v.offset != 0)
        throw Invalid_geodesic_input(Reason::INVALID_OFFSET,
                                     "lines on the sides of curves need sources without offsets", v.point.curve);
    return [sides = Curve_sides<double>(solver.mesh(), curves), wanted = is_negative ? -1 : 1](
             const Isoline_point<double>& p) { return sides.sign_of_face(face_of(p.halfedge)) == wanted; };
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_ISOLINES_ISOLINE_CHOICE_H
