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

#include <CGAL/Surface_mesh_geodesics/internal/certificate/Checked_conditions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Private_access.h>

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

A violation is a relative number without a unit: the amount by which a number is too large or too small, divided by
the sum of the right number and the longest edge of the faces around the vertex. It is infinite if a number that must
be finite is not. An amount of less than \f$ 8 \epsilon \approx 1.8 \cdot 10^{-15} \f$ times the longest edge of the
component is not a violation, as points so close to each other are not distinguished.

\code
const auto certificate = certify_geodesic_distances(mesh, distances, source);
if(!certificate.is_certified())
  std::cerr << "violation: " << certificate.worst_violation() << std::endl;
\endcode

Only the functions that check distances construct certificates, so there is none without a check. (An empty mesh has
nothing to check, and is certified.) Certificates can be copied and assigned.

An object holds numbers and vertex descriptors; it is valid as long as the mesh does not change. All functions take
constant time, throw nothing, and may be called by several threads at once.

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
    REACH,          ///< Distances are numbers, not negative, and infinite exactly where no faces lead to a source.
    SOURCES,        ///< The distance of a source vertex, or of a vertex on a curve, is not greater than the offset.
    EDGES,          ///< Along an edge, the distance grows by at most the length of the edge.
    PAIRS_OF_FACES, ///< Along a segment through two faces, from vertex to vertex, it grows by at most its length.
    PATHS,          ///< A path of this length leads from the vertex to a source: the distance is not too short.
    LOWER_BOUNDS,   ///< The distance is not greater than a lower bound: it is not too long.
    PROOF,          ///< The lower bounds are proved.
    REVERSE         ///< The distances from some vertices to the sources are the same in reverse.
  };

  /// the number of conditions; their values are `0` to `number_of_conditions - 1`.
  static constexpr std::size_t number_of_conditions = internal::NUMBER_OF_CHECKED_CONDITIONS;

  /// the default tolerance of `is_certified()`, \f$ 2^{-40} = 4096 \epsilon \f$.
  static constexpr double default_tolerance = 0x1p-40;

  /// returns whether no condition is violated by more than the tolerance.
  ///
  /// \param tolerance the largest violation that is accepted, a relative number; 0 accepts no violation at all
  /// \return `true` exactly if `worst_violation()` is not greater than the tolerance
  bool is_certified(double tolerance = default_tolerance) const { return worst_violation() <= tolerance; }

  /// returns the largest violation of all conditions, or 0 if no condition is violated.
  double worst_violation() const
  {
    double worst = 0;
    for(const Entry& e : m_entries)
      worst = (std::max)(worst, e.violation);
    return worst;
  }

  /// returns the largest violation of one condition, or 0 if it is not violated.
  ///
  /// \param c the condition
  double worst_violation(Condition c) const { return entry(c).violation; }

  /// returns the vertex where a condition is violated most. For `EDGES` and `PAIRS_OF_FACES` this is the vertex whose
  /// distance is too long compared with that of another vertex; for `PROOF` it is a vertex of the face.
  ///
  /// \param c the condition
  /// \return the vertex; the null vertex if the condition is not violated, or is violated at a source that is not a
  ///         vertex
  vertex_descriptor worst_vertex(Condition c) const { return entry(c).vertex; }

  /// returns how many times a condition has been checked.
  ///
  /// \param c the condition
  /// \return how often the condition was checked: for a vertex, for an edge (in each direction and for each of its
  ///         faces), for a pair of faces (in each direction), for a path; 0 if the condition was not
  std::size_t number_of_checks(Condition c) const { return entry(c).number_of_checks; }

  /// returns the name of a condition, such as "PATHS".
  ///
  /// \param c the condition
  /// \return the name of the enumerator, a static string
  static const char* name(Condition c)
  {
    constexpr const char* names[number_of_conditions]
      = {"REACH", "SOURCES", "EDGES", "PAIRS_OF_FACES", "PATHS", "LOWER_BOUNDS", "PROOF", "REVERSE"};
    return names[static_cast<std::size_t>(c)];
  }

private:
  friend internal::Private_access;

  template <typename FT, typename Descriptor>
  Geodesic_distance_certificate(const internal::Checked_conditions<FT>& conditions, Descriptor descriptor)
  {
    for(std::size_t i = 0; i < number_of_conditions; ++i)
    {
      const internal::Worst_violation<FT>& worst = conditions[i];
      m_entries[i] = {static_cast<double>(worst.size), descriptor(worst.vertex), worst.number_of_checks};
    }
  }

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
