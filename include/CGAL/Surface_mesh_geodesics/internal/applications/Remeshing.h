// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_REMESHING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_REMESHING_H

// Approximates a mesh by the dual of the geodesic Voronoi diagram of some of its vertices: sampling, relaxation, dual.
// (The thesis, section 5.4.4, takes the dual of random sites.)
//
// One visitor follows all propagations; once it cancels one, no further one starts.

#include <CGAL/Surface_mesh_geodesics/internal/applications/Dual_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `sample(output, np)` writes the samples to an output iterator and tells the visitor among the named parameters of its
// progress: it is geodesic_farthest_point_sampling(), which this room does not include. The visitor in
// `np.visitor(...)` replaces the one that `np` may have. Returns a report without findings, which is not manifold, if
// the visitor cancels.
//
// The output changes in the last step only, and only if the dual is manifold. Throws Invalid_geodesic_input, before
// that. Takes the time of the three parts. Each of them reads the mesh for itself, and has freed that memory before the
// next one begins.
template <template <typename...> class Diagram, typename Report, typename TriangleMesh, typename OutputMesh,
          typename Visitor, typename NamedParameters, typename Sample>
Report remesh(const TriangleMesh& tm, std::size_t number_of_iterations, OutputMesh& output, Visitor& users_visitor,
              const NamedParameters& np, Sample sample)
{
  Visitor_of_several_runs<Visitor> visitor(users_visitor);
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> sites;
  sample(std::back_inserter(sites), np.visitor(std::ref(visitor)));
  if(visitor.is_canceled())
    return Report();
  // A relaxation that the visitor cancels returns like any other; is_canceled() tells below.
  relax_sites<Diagram>(tm, sites, number_of_iterations, visitor, np);
  auto diagram = make_vertex_site_diagram<Diagram>(tm, np);
  diagram.set_sites(sites);
  if(visitor.is_canceled() || !diagram.diagram().build(visitor))
    return Report();
  return add_dual_mesh<Report>(diagram.diagram(), output);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_REMESHING_H
