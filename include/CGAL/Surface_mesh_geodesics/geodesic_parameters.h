// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_PARAMETERS_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_PARAMETERS_H

// The functions in CGAL::parameters for the named parameters of this package, such as maximum_distance() and targets().
// All headers whose functions take them include this one. The reference page of each function lists the parameters that
// it takes; the user manual, section Named Parameters, says how to write a sequence.
//
// A sequence starts with a parameter of this package, as CGAL's class has no members for them. This header is not
// needed any more, and is not laid out in CGAL's tree, when the parameters are among CGAL's own.

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/Parameter_sequence.h>

#include <CGAL/Named_function_parameters.h>

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_PARAMETERS_H
