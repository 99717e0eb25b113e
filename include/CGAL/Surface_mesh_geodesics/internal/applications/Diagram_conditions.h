// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_CONDITIONS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_CONDITIONS_H

// The conditions that a geodesic Voronoi diagram has to satisfy, and what a check of one of them finds. The certifier
// of diagrams fills these records; the public certificate reads them.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// In the order of Geodesic_Voronoi_certificate::Condition, where they are explained. A condition is an index of
// Diagram_violations.
enum Diagram_condition : unsigned int
{
  DIAGRAM_ARCS,
  DIAGRAM_VERTICES,
  DIAGRAM_OWNERS,
  DIAGRAM_NEAREST,
  DIAGRAM_BOUNDARIES,
  DIAGRAM_AREAS,
  DIAGRAM_DISTANCES,
  DIAGRAM_CURVES,
  NUMBER_OF_DIAGRAM_CONDITIONS
};

// How often a condition was checked, how far it is violated at worst, and by the cell of which site.
struct Diagram_violation
{
  double size = 0; // relative to a scale that the check chooses; infinite if something is missing
  std::size_t site = no_site();
  std::size_t number_of_checks = 0;

  // Stands for "no single site".
  static constexpr std::size_t no_site() { return (std::numeric_limits<std::size_t>::max)(); }

  // Counts one check, and keeps its violation if it is larger than all before. A violation that is not positive does
  // not count; NaN counts as infinite. Of equal violations the first one is kept. So a condition that always holds has
  // the size 0 and no site, and a certificate can tell "checked" from "never checked" by the number of checks.
  void record(double violation, std::size_t violating_site)
  {
    ++number_of_checks;
    // Also false if the violation is NaN, which goes on to become infinite.
    if(violation <= size)
      return;
    const double infinity = std::numeric_limits<double>::infinity();
    size = violation < infinity ? violation : infinity;
    site = violating_site;
  }
};

// By condition. The public certificate holds a copy.
using Diagram_violations = std::array<Diagram_violation, NUMBER_OF_DIAGRAM_CONDITIONS>;

// --- distances ---

// Returns the largest weight of a site, in absolute value.
template <typename Diagram>
double largest_weight_of(const Diagram& diagram)
{
  double largest = 0;
  for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
    largest = (std::max)(largest, std::abs(CGAL::to_double(diagram.weight(i))));
  return largest;
}

// Makes a violation of a difference of two lengths, at a point with this distance from a site; `extent` is the longest
// edge of its component. The difference of a distance and a weight is rounded to the size of the larger one; where the
// weight is the larger one, that is more than the rounding of lengths, and is allowed. The result is NaN if the
// difference is. Any positive difference is infinite on a component all of whose edges have length 0.
inline double violation_of_distance(double difference, double distance, double extent, double largest_weight)
{
  const double excess = difference - Tolerance<double>::gap() * (distance + largest_weight);
  return excess <= 0 ? excess : excess / (distance + extent);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_CONDITIONS_H
