// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_MATRIX_MPI_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_MATRIX_MPI_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_status.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/store_matrix_mpi.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <string>
#include <vector>

#if defined(CGAL_SURFACE_MESH_GEODESICS_LINKED_WITH_MPI) || defined(DOXYGEN_RUNNING)

#include <boost/mpi/communicator.hpp>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

stores a matrix of distances as `store_geodesic_distance_matrix()` does, with all processes of an MPI job.

The function exists if the macro `CGAL_SURFACE_MESH_GEODESICS_LINKED_WITH_MPI` is defined. The target
`CGAL::Surface_mesh_geodesics_MPI` defines it, and links Boost.MPI. MPI must have been initialized with the level
`boost::mpi::threading::funneled` at least, in the thread that calls the function.

All processes call the function with the same mesh, sources, targets, folder and parameters. Rank 0 hands out the
shards, one by one, and keeps the manifest; each rank, rank 0 too, computes shards and writes their files. The folder
must be one that all ranks share. It is that of `store_geodesic_distance_matrix()`: if a rank dies, which ends the job,
another job with any number of ranks goes on with it, or a process without MPI.

The bits of the files do not depend on the number of ranks, if the ranks run the same program.

<b>Complexity.</b> Each row takes the time of a propagation up to the farthest target, on one of the ranks.

\tparam ConcurrencyTag whether each rank uses several threads. Their number is that of \tbb, which may be limited with
        `tbb::global_control`.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam Sources as for `geodesic_distance_matrix()`
\tparam Targets as for `geodesic_distance_matrix()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param world the communicator, in which no other messages may be under way during the call
\param tm the triangle mesh
\param sources the sources
\param targets the targets
\param folder the name of the folder
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
       `store_geodesic_distance_matrix()`. The visitor of rank 0 is told of the rows of all ranks, with those of others
       as computed ones. A rank whose visitor cancels computes no more; the others go on.

\return how much of the range is stored, the same on each rank

\throws Invalid_geodesic_input as `store_geodesic_distance_matrix()`
\throws Geodesic_matrix_store_error as `store_geodesic_distance_matrix()`. If the folder does not fit, each rank throws.
        If one rank alone throws, the others wait for it: the program has to abort the job.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Sources, typename Targets,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Geodesic_matrix_store_status
store_geodesic_distance_matrix_mpi(const boost::mpi::communicator& world, const TriangleMesh& tm,
                                   const Sources& sources, const Targets& targets, const std::string& folder,
                                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::store_matrix_mpi<ConcurrencyTag>(world, tm, sources, targets, folder, np);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_LINKED_WITH_MPI

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_MATRIX_MPI_H
