// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIRECTIONS_PATH_DIRECTIONS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIRECTIONS_PATH_DIRECTIONS_H

// The directions in which shortest paths leave their sources, from what a Path_solver knows: with the distances, the
// logarithmic map. The solver computes the direction of one path (Departure.h); here is which path to look at.
//
// Solver is Path_solver, and `face_of_source(number)` is the face in which the user gave a source. Curves have no
// tangent frame, so paths from them have no direction: not a number. (The angle to the curve would be one, but at the
// inside of a segment it is always a right angle, and at its corners it says little.)
//
// The functions only read the solver, so several threads may call them at once, as they may ask for paths.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Returns the direction of the path to a point, in [0, 2 pi); not a number if no source reaches it, or if there are
// curves among the sources. Throws what Path_solver::path() throws.
//
// Traces the first straight piece of the path only, the one at the source. Its end is a vertex, whose own path is this
// piece. A location whose path is straight has no such vertex, and is traced by itself.
template <typename Solver, typename FaceOfSource>
double direction_of_path(const Solver& solver, typename Solver::Query q, FaceOfSource face_of_source)
{
  constexpr double full_circle = 6.283185307179586;
  if(!solver.has_run() || solver.has_curves())
    return std::numeric_limits<double>::quiet_NaN();
  typename Solver::Arrival a = solver.arrival(q);
  if(!a.is_reached())
    return std::numeric_limits<double>::quiet_NaN();
  if(q.vertex != null_id || !solver.field().is_source(a.root))
  {
    q = typename Solver::Query();
    q.vertex = solver.end_of_first_piece(a.root);
    a = solver.arrival(q);
  }
  const auto f = face_of_source(solver.source_number(a));
  const double direction = std::remainder(solver.direction_at_source(q, solver.path(q, a), f), full_circle);
  return direction < 0 ? direction + full_circle : direction;
}

// Writes the directions of all vertices. All vertices behind a bend have the direction of the path to the bend, which
// is traced once: that is what makes this cheap.
template <typename TriangleMesh, typename Solver, typename FaceOfSource, typename VertexDirectionMap>
void put_directions(const TriangleMesh& tm, const Solver& solver, FaceOfSource face_of_source, VertexDirectionMap map)
{
  using Value = typename boost::property_traits<VertexDirectionMap>::value_type;
  const bool has_directions = solver.has_run() && !solver.has_curves();
  std::vector<double> known(has_directions ? solver.mesh().number_of_vertices() : 0, -1.);
  for(const auto v : vertices(tm))
  {
    double direction = std::numeric_limits<double>::quiet_NaN();
    if(has_directions)
    {
      const auto q = solver.query(v);
      if(solver.arrival(q).is_reached())
      {
        double& d = known[solver.end_of_first_piece(q.vertex)];
        d = d < 0 ? direction_of_path(solver, q, face_of_source) : d;
        direction = d;
      }
    }
    put(map, v, static_cast<Value>(direction));
  }
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIRECTIONS_PATH_DIRECTIONS_H
