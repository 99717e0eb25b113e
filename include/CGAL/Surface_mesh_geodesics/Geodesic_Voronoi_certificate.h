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

#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_conditions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Private_access.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_Voronoi_certificate` is the result of `certify_geodesic_Voronoi_diagram()`: how far a geodesic
Voronoi diagram violates each of several conditions, and by the cell of which site.

Violations are relative numbers without a unit. Let \f$ e \f$ be the longest edge of the component of the mesh:

- A distance that is wrong by \f$ x \f$ is a violation of \f$ x / (d + e) \f$, where \f$ d \f$ is the right distance.
- Two locations that should be one, and are \f$ x \f$ apart, are a violation of \f$ x / e \f$.
- An area that is wrong by \f$ x \f$ is a violation of \f$ x / (a + e^2) \f$, where \f$ a \f$ is the expected area.
- A violation is infinite if something is missing or contradicts itself.

Only the functions that check diagrams construct certificates, so there is none without a check. (A diagram of an empty
mesh has nothing to check, and is certified.) Certificates can be copied and assigned.

An object holds numbers only; it stays valid when the diagram or the mesh changes. All functions take constant time,
throw nothing, and may be called by several threads at once.

\sa `certify_geodesic_Voronoi_diagram()`
*/
class Geodesic_Voronoi_certificate
{
public:
  /// what is checked.
  enum class Condition
  {
    ARCS,       ///< Points of an arc have the stated distance from both of its sites.
    VERTICES,   ///< Vertices of the diagram have the stated distance from all of their sites.
    OWNERS,     ///< Vertices of the mesh and points of faces have the stated distance from their nearest site.
    NEAREST,    ///< No other site is nearer to any of these points, to a site, or to points of a curve.
    BOUNDARIES, ///< Boundaries of cells are closed or end at the border of the mesh, and each edge has two sides.
    AREAS,      ///< Areas of cells are not negative, and add up to that of the faces that a site reaches.
    DISTANCES,  ///< `certify_geodesic_distances()` accepts the distances of the vertices of the mesh.
    CURVES      ///< Between the points of an arc, both sites are equally far as well, and no other site is nearer.
  };

  /// the number of conditions; their values are `0` to `number_of_conditions - 1`.
  static constexpr std::size_t number_of_conditions = internal::NUMBER_OF_DIAGRAM_CONDITIONS;

  /// the default tolerance of `is_certified()`, \f$ 2^{-36} \f$. It is larger than that of distances, as positions of
  /// points on a curve are more sensitive to rounding than distances are.
  static constexpr double default_tolerance = 0x1p-36;

  /// returns the number that stands for "no site".
  static constexpr std::size_t null_site() { return internal::Diagram_violation::no_site(); }

  /// returns whether no condition is violated by more than the tolerance.
  ///
  /// \param tolerance the largest violation that is accepted, a relative number
  bool is_certified(double tolerance = default_tolerance) const { return worst_violation() <= tolerance; }

  /// returns the largest violation of all conditions, or 0 if no condition is violated.
  double worst_violation() const
  {
    double worst = 0;
    for(const internal::Diagram_violation& v : m_violations)
      worst = (std::max)(worst, v.size);
    return worst;
  }

  /// returns the largest violation of one condition, or 0 if it is not violated.
  ///
  /// \param c the condition
  double worst_violation(Condition c) const { return violation(c).size; }

  /// returns the site that is involved in the largest violation of a condition: the site whose distance is wrong, or
  /// the site whose cell has a wrong boundary or area.
  ///
  /// \param c the condition
  /// \return the number of the site, or `null_site()` if the condition is not violated or no single site is to blame
  std::size_t worst_site(Condition c) const { return violation(c).site; }

  /// returns how many times a condition has been checked.
  ///
  /// \param c the condition
  std::size_t number_of_checks(Condition c) const { return violation(c).number_of_checks; }

  /// returns the name of a condition, such as "ARCS".
  ///
  /// \param c the condition
  static const char* name(Condition c)
  {
    constexpr const char* names[number_of_conditions]
      = {"ARCS", "VERTICES", "OWNERS", "NEAREST", "BOUNDARIES", "AREAS", "DISTANCES", "CURVES"};
    return names[static_cast<std::size_t>(c)];
  }

private:
  friend internal::Private_access;
  explicit Geodesic_Voronoi_certificate(const internal::Diagram_violations& violations) : m_violations(violations) {}

  const internal::Diagram_violation& violation(Condition c) const
  {
    return m_violations[static_cast<std::size_t>(c)];
  }

  internal::Diagram_violations m_violations;
};

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_VORONOI_CERTIFICATE_H
