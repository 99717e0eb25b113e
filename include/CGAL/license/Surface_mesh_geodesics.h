// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_LICENSE_SURFACE_MESH_GEODESICS_H
#define CGAL_LICENSE_SURFACE_MESH_GEODESICS_H

// Every public header of the package includes this file first. It is silent unless the user defines one of CGAL's two
// macros that ask for the license of each package in use. There is no other license than the GPL for this package, so,
// unlike in CGAL's own files of this kind, no macro states that a commercial one was bought.

#include <CGAL/config.h>
#include <CGAL/license.h>

#if defined(CGAL_LICENSE_ERROR)
#error "Surface_mesh_geodesics is used under the terms of the GPL, version 3 or later (CGAL_LICENSE_ERROR is defined)."
#elif defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("Surface_mesh_geodesics is used under the terms of the GPL, version 3 or later.")
#endif

#endif // CGAL_LICENSE_SURFACE_MESH_GEODESICS_H
