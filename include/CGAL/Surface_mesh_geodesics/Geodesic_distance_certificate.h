// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_CERTIFICATE_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_CERTIFICATE_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/internal/interface/Distance_certifier.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_distance_certificate` is the result of `certify_geodesic_distances()`: how far given distances
violate each of several conditions, and where.

A violation is relative: what a number is too large or too small by, divided by the sum of the right number and the
longest edge of the faces around. It is infinite where a number is missing, infinite or not a number and must not be.
What is too large or too small by less than \f$ 8 \epsilon \approx 1.8 \cdot 10^{-15} \f$ of the longest edge of the
component is no violation, as points so near to each other are not told apart.

An object holds numbers and descriptors; it is valid as long as the mesh does not change. All functions take constant
time, throw nothing, and may be called by several threads at once.

\tparam TriangleMesh a model of `FaceListGraph`

\sa `certify_geodesic_distances()`
*/
template <typename TriangleMesh>
class Geodesic_distance_certificate
{
public:
  /// the type of the vertices of the mesh.
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// what is checked.
  enum class Condition
  {
    REACH,          ///< distances are numbers, not negative, and infinite exactly where no faces lead to a source
    SOURCES,        ///< the distance of a source vertex is not greater than its offset
    EDGES,          ///< along an edge, the distance grows by no more than the length of the edge
    PAIRS_OF_FACES, ///< so it does along a straight line through two faces, from vertex to vertex
    PATHS,          ///< a path of this length leads from the vertex to a source: the distance is not too short
    LOWER_BOUNDS,   ///< the distance is not greater than a lower bound: it is not too long
    PROOF,          ///< the lower bounds are lower bounds
    REVERSE         ///< from some vertices, distances to the sources are the same in reverse
  };

  /// the number of conditions; their values are `0` to `number_of_conditions - 1`.
  static constexpr std::size_t number_of_conditions = internal::NUMBER_OF_CHECKED_CONDITIONS;

  /// the default tolerance of `is_certified()`, \f$ 2^{-40} \f$: some thousand times the rounding error of a `double`.
  static constexpr double default_tolerance = 0x1p-40;

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

  /// returns the vertex where a condition is violated most: for `EDGES` and `PAIRS_OF_FACES` the vertex whose distance
  /// is too long compared with that of another one, for `PROOF` a vertex of the face. It is the null vertex if the
  /// condition is not violated, or if it is at a source that is not a vertex.
  ///
  /// \param c the condition
  vertex_descriptor worst_vertex(Condition c) const { return entry(c).vertex; }

  /// returns how many times a condition has been checked.
  ///
  /// \param c the condition
  std::size_t number_of_checks(Condition c) const { return entry(c).number_of_checks; }

  /// returns the name of a condition, such as "PATHS".
  ///
  /// \param c the condition
  static const char* name(Condition c)
  {
    constexpr const char* names[number_of_conditions]
      = {"REACH", "SOURCES", "EDGES", "PAIRS_OF_FACES", "PATHS", "LOWER_BOUNDS", "PROOF", "REVERSE"};
    return names[static_cast<std::size_t>(c)];
  }

#ifndef DOXYGEN_RUNNING
  template <typename FT, typename Descriptor>
  Geodesic_distance_certificate(const internal::Checked_conditions<FT>& conditions, Descriptor descriptor)
  {
    for(std::size_t i = 0; i < number_of_conditions; ++i)
    {
      const internal::Worst_violation<FT>& worst = conditions[i];
      m_entries[i] = {static_cast<double>(worst.size), descriptor(worst.vertex), worst.number_of_checks};
    }
  }
#endif

private:
  struct Entry
  {
    double violation;
    vertex_descriptor vertex;
    std::size_t number_of_checks;
  };

  const Entry& entry(Condition c) const { return m_entries[static_cast<std::size_t>(c)]; }

  std::array<Entry, number_of_conditions> m_entries;
};

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_CERTIFICATE_H
