// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_H
#define CGAL_SURFACE_MESH_GEODESICS_H

// Convenience header: all public headers of the package, and nothing else.

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_Voronoi_certificate.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_certificate.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_status.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_cell_colors.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_mpi.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_isolines.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_parameters.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>
#include <CGAL/Surface_mesh_geodesics/polyline_curve.h>
#include <CGAL/Surface_mesh_geodesics/shortest_path_curve.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>
#include <CGAL/Surface_mesh_geodesics/write_geodesic_Voronoi_diagram.h>

#endif // CGAL_SURFACE_MESH_GEODESICS_H
