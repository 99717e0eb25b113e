// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_CERTIFICATE_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_CERTIFICATE_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_Voronoi_certificate` is the result of `certify_geodesic_Voronoi_diagram()`: how far a geodesic
Voronoi diagram violates each of several conditions, and by the cell of which site.

A violation is relative: for distances, what a number is too large or too small by, divided by the sum of the distance
and the longest edge of the mesh; for places, to the longest edge; for areas, to the sum of the expected area and the
square of the longest edge. It is infinite where something is missing or does not fit together at all.

All functions take constant time, throw nothing, and may be called by several threads at once.

\sa `certify_geodesic_Voronoi_diagram()`
*/
class Geodesic_Voronoi_certificate
{
public:
  /// what is checked.
  enum class Condition
  {
    ARCS,       ///< points of arcs have the distance that the arc tells from both sites
    VERTICES,   ///< vertices of the diagram have the distance that they tell from all of their sites
    OWNERS,     ///< vertices of the mesh and points of faces have the distance that is told from their nearest site
    NEAREST,    ///< no site is nearer than that to any of these points
    BOUNDARIES, ///< boundaries of cells are closed or end at the border of the mesh, and each edge has two sides
    AREAS       ///< areas of cells are not negative, and sum up to that of the faces that are reached
  };

  /// the number of conditions; their values are `0` to `number_of_conditions - 1`.
  static constexpr std::size_t number_of_conditions = 6;

  /// the default tolerance of `is_certified()`, \f$ 2^{-36} \f$: places are more sensitive to rounding than distances.
  static constexpr double default_tolerance = 0x1p-36;

  /// returns the number that stands for "no site".
  static constexpr std::size_t null_site() { return (std::numeric_limits<std::size_t>::max)(); }

  /// returns whether no condition is violated by more than the tolerance.
  ///
  /// \param tolerance a relative one, as a violation is
  bool is_certified(double tolerance = default_tolerance) const { return worst_violation() <= tolerance; }

  /// returns the largest violation of all conditions, 0 if none is violated.
  double worst_violation() const
  {
    double worst = 0;
    for(const Entry& e : m_entries)
      worst = (std::max)(worst, e.violation);
    return worst;
  }

  /// returns the largest violation of a condition, 0 if it is not violated.
  ///
  /// \param c the condition
  double worst_violation(Condition c) const { return entry(c).violation; }

  /// returns the site that is involved where a condition is violated most: the one whose distance is not as told, or
  /// whose cell has the boundary or the area. It is `null_site()` if the condition is not violated, or by no site
  /// alone.
  ///
  /// \param c the condition
  std::size_t worst_site(Condition c) const { return entry(c).site; }

  /// returns how many times a condition has been checked.
  ///
  /// \param c the condition
  std::size_t number_of_checks(Condition c) const { return entry(c).number_of_checks; }

  /// returns the name of a condition, such as "ARCS".
  ///
  /// \param c the condition
  static const char* name(Condition c)
  {
    constexpr const char* names[number_of_conditions]
      = {"ARCS", "VERTICES", "OWNERS", "NEAREST", "BOUNDARIES", "AREAS"};
    return names[static_cast<std::size_t>(c)];
  }

#ifndef DOXYGEN_RUNNING
  // notes that a condition is violated by `violation` if that is positive, or not a number.
  void look_at(Condition c, double violation, std::size_t site)
  {
    Entry& e = m_entries[static_cast<std::size_t>(c)];
    ++e.number_of_checks;
    if(violation <= e.violation)
      return;
    const double infinity = std::numeric_limits<double>::infinity();
    e.violation = violation < infinity ? violation : infinity;
    e.site = site;
  }
#endif

private:
  struct Entry
  {
    double violation = 0;
    std::size_t site = null_site(), number_of_checks = 0;
  };

  const Entry& entry(Condition c) const { return m_entries[static_cast<std::size_t>(c)]; }

  std::array<Entry, number_of_conditions> m_entries;
};

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_CERTIFICATE_H
