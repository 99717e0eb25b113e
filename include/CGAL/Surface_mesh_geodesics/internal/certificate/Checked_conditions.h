// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_CHECKED_CONDITIONS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_CHECKED_CONDITIONS_H

// The conditions that are checked for distances, and the result of checking all of them. The certifier fills these
// records; the public certificate reads them.

#include <CGAL/Surface_mesh_geodesics/internal/certificate/Worst_violation.h>

#include <array>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// In the order of Geodesic_distance_certificate::Condition, where they are explained: the public certificate takes
// entry i of the records for its condition i.
//
// REACH to PAIRS_OF_FACES need only the mesh, the sources and the values. The next three need a witness: PATHS shows
// that no distance is too short, LOWER_BOUNDS and PROOF show that none is too long. These three prove the distances of
// the vertices that the witness reaches; REACH decides about the others. REVERSE repeats a part of the result in
// another way.
enum Checked_condition : unsigned int
{
  CHECKED_REACH,
  CHECKED_SOURCES,
  CHECKED_EDGES,
  CHECKED_PAIRS_OF_FACES,
  CHECKED_PATHS,
  CHECKED_LOWER_BOUNDS,
  CHECKED_PROOF,
  CHECKED_REVERSE,
  NUMBER_OF_CHECKED_CONDITIONS
};

// Indexed by Checked_condition. A record without checks belongs to a condition that was not checked.
template <typename FT>
using Checked_conditions = std::array<Worst_violation<FT>, NUMBER_OF_CHECKED_CONDITIONS>;

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_CHECKED_CONDITIONS_H
