// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_PROPAGATE_DIAGRAM_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_PROPAGATE_DIAGRAM_H

// How a diagram is made of the sources of a Path_solver: by a keeper that divides faces behind the wavefront, or, with
// curves among the sites, of all windows and strips at the end of a run.
//
// How sites are known: usually by their vertices. A curve has many vertices, and a site on a wall has one on each side;
// the parts of its cell on the sides are one cell. Then all sites are known by their numbers.
//
// Why runs from curves keep everything: faces become inactive by bounds that come from windows, and the text of the
// propagation with strips is compiled for one keeper only, that of paths. Distances inside of faces are known without
// another run then.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Diagram_window_keeper.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/equal_sources.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The largest number of windows that the diagram has kept at one time, and the number without the removal.
using Numbers_of_kept_windows = std::pair<std::size_t, std::size_t>;

// Makes the complex of a solver with curves among its sources. The run keeps all windows and strips, which stay in the
// solver; then one thread divides the faces.
template <typename Solver, typename Run>
bool propagate_diagram_of_curves(Solver& solver, Voronoi_complex<double>& complex, double largest_weight, Run run,
                                 Numbers_of_kept_windows& kept_windows)
{
  const bool is_complete = run([&](auto go_on)
  {
    return solver.run(true, [&](std::size_t number_of_visits, double reached)
    { return go_on(number_of_visits, reached - largest_weight); });
  });
  if(!is_complete)
    return false;
  Diagram_propagation<double, false> building(complex);
  building.start(solver.mesh(), solver.field(), true);
  building.removal().take(solver.windows(), solver.curve_arrivals());
  building.finish();
  kept_windows = {building.removal().windows().maximum_size(), building.removal().number_of_kept_windows()};
  return true;
}

// Calls visit(v, u) for each vertex v of a source that ties everywhere with an earlier one, at u.
template <typename Solver, typename Visit>
void for_each_equal_site(const Solver& solver, Visit visit)
{
  for_each_equal_source(solver.mesh(), solver.sources().vertices, solver.sources().offsets, visit);
}

// Returns the number of the site to which the cell of a source at a vertex belongs, null_id for other vertices. On each
// side of a wall for itself, a source may give its cell to one with which it ties.
template <typename Solver>
std::vector<Vertex_id> numbers_of_sites(const Solver& solver)
{
  std::vector<Vertex_id> result(solver.mesh().number_of_vertices(), null_id);
  for(const Vertex_id v : solver.sources().vertices)
    result[v] = static_cast<Vertex_id>(solver.source_at(v));
  for_each_equal_site(solver, [&](Vertex_id v, Vertex_id u)
  { result[v] = static_cast<Vertex_id>(solver.source_at(u)); });
  return result;
}

// Propagates from all sites at once; faces that arcs cross are divided behind the wavefront. The removal has to start
// when the solver has made vertices of the sites, but before the first window: run_with_keeper() calls start() then.
// `run(propagate)` calls propagate(go_on) and returns its result. Returns false if the run is not complete.
// `Building` is a Diagram_propagation.
template <typename Building, typename Solver, typename Run>
bool propagate_diagram(Solver& solver, Voronoi_complex<double>& complex, double largest_weight, Run run,
                       Numbers_of_kept_windows& kept_windows)
{
  if(solver.has_curves())
    return propagate_diagram_of_curves(solver, complex, largest_weight, run, kept_windows);
  Building building(complex);
  const auto start = [&]
  {
    const bool is_any_at_wall = !solver.sources().behind_walls.empty();
    building.start(solver.mesh(), solver.field(), is_any_at_wall);
    if(is_any_at_wall)
      building.removal().set_sites(numbers_of_sites(solver));
    else
      for_each_equal_site(solver, [&](Vertex_id v, Vertex_id first) { building.removal().unite(v, first); });
    return building.keeper();
  };
  const bool is_complete = run([&](auto go_on)
  {
    return solver.run_with_keeper(start, [&](std::size_t number_of_visits, double reached)
    { return go_on(number_of_visits, reached - largest_weight); });
  });
  if(!is_complete)
    return false;
  building.finish();
  kept_windows = {building.removal().windows().maximum_size(), building.removal().number_of_kept_windows()};
  return true;
}

// Returns the sites at the point of site i that have its weight, i among them, in ascending order. `cell` is its cell.
// A site with the same weight whose vertex is in that cell is at that point, up to rounding: anywhere else, it would
// be nearer to itself. Linear in the number of sites. Requires: all sites are points, and are inserted.
template <typename Solver>
std::vector<std::size_t> sites_at_point_of(const Solver& solver, const Voronoi_complex<double>& complex, std::size_t i,
                                           Vertex_id cell)
{
  const auto& sources = solver.sources();
  std::vector<std::size_t> result;
  for(std::size_t j = 0; j < sources.size(); ++j) // on a wall, a site is listed once for each side
    if(sources.offset(j) == sources.offset(i) && complex.owner(sources.vertices[j]) == cell)
      result.push_back(sources.number(j));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Returns the sites that have the point where a path ends, with the weight that counts there, in ascending order:
// several if curves have a common end or a common edge, none if there is no path. Requires: there are curves among the
// sites.
template <typename Solver>
std::vector<std::size_t> sites_at_end_of_path(const Solver& solver, const typename Solver::Arrival& a)
{
  if(!a.is_reached())
    return {};
  const auto place = solver.curve_place(a);
  double extent = 1; // not needed at a vertex
  if(place.edge != nullptr)
    extent = solver.mesh().extent_around(face_of((std::min)(place.edge->left, place.edge->right)));
  const std::vector<std::uint32_t> numbers = curves_at(solver.curve_arrivals().curves, place, extent);
  return std::vector<std::size_t>(numbers.begin(), numbers.end());
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_PROPAGATE_DIAGRAM_H
