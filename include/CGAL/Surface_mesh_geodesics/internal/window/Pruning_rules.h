// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PRUNING_RULES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PRUNING_RULES_H

// Which pruning rules a propagation applies. Tests switch them off.

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// No rules: the base of sets that switch single rules on, so that a new rule does not join them.
struct No_pruning_rules
{
  static constexpr bool rule_1 = false;
  static constexpr bool pair_rules = false;
  static constexpr bool vertex_rule = false;
};

// All rules: the policy of every propagation except those of tests and measurements. Each rule only saves work: without
// it the distances are the same. Without any rule, the number of windows can grow exponentially (thesis, 2.1.1.1). Two
// removals have no switch: stale windows, and windows that have crossed too many faces.
struct All_pruning_rules
{
  static constexpr bool rule_1 = true;      // one angle, two sides (thesis, 4.2.3.1)
  static constexpr bool pair_rules = true;  // Rules 2 and 3 (thesis, 4.2.3.2 and 4.2.3.3)
  static constexpr bool vertex_rule = true; // checking with vertices (thesis, case 12)
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_PRUNING_RULES_H
