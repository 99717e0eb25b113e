// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INVALID_GEODESIC_INPUT_H
#define CGAL_SURFACE_MESH_GEODESICS_INVALID_GEODESIC_INPUT_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Invalid_geodesic_input` is the exception that reports input for which geodesic distances are not
defined. Functions throw it whether assertions are enabled or not, before they write to a property map of
the user. (There is one exception: with assertions, \cgal itself checks an index map that is a named parameter, before
the function does, and throws its `Assertion_exception`.)

`reason()` tells programs what is wrong, `element()` where, and `what()` tells it to the user, in one sentence. If the
input has several faults, one of them is reported, which need not be the first one in its range.

\code
try
{
  CGAL::Surface_mesh_geodesics::geodesic_distances(mesh, distance, source);
}
catch(const CGAL::Surface_mesh_geodesics::Invalid_geodesic_input& error)
{
  std::cerr << "element " << error.element() << ": " << error.what() << std::endl;
}
\endcode

\sa `geodesic_distances()`
\sa `Surface_mesh_geodesic_paths`
*/
class Invalid_geodesic_input
  : public std::invalid_argument
{
public:
  /// what is wrong.
  enum class Reason
  {
    NOT_A_TRIANGLE,      ///< a face does not have three edges
    NON_FINITE_POINT,    ///< a coordinate of a vertex, a point or a ray is infinite, not a number or too large, or the
                         ///< mesh is too small to locate points in space
    NON_FINITE_LENGTH,   ///< an edge length is infinite or not a number
    NEGATIVE_LENGTH,     ///< an edge length is negative
    TRIANGLE_INEQUALITY, ///< an edge is longer than the two others of a face, beyond rounding
    INVALID_LOCATION,    ///< a location has a null face, or lies outside its face; or a vertex, a location or a curve
                         ///< is inside of the faces to avoid
    INVALID_DESCRIPTOR,  ///< a vertex, a face or an edge is null, or does not belong to the mesh
    INVALID_OFFSET,      ///< an offset is negative, not finite, far larger than the mesh, or not 0 for signed
                         ///< isolines; a weight is not finite or differs too much from the largest one; or there is
                         ///< not one per source or site
    INVALID_RADIUS,      ///< a maximum distance or a covering radius is negative or not a number
    INVALID_INDEX_MAP,   ///< an index map has values out of range, or equal values
    NON_MANIFOLD,        ///< a face has a vertex twice, or two faces disagree about the ends of their edge
    TOO_LARGE,           ///< the mesh has more than 2<sup>30</sup> - 2 faces, or walls divide it into too many
                         ///< vertices
    TOO_SMALL,           ///< one component is smaller than the mesh by a factor of more than 10<sup>60</sup>
    INVALID_DIRECTION,   ///< the direction or the length of a traced geodesic is not finite, the length is negative,
                         ///< or a vector or a face tells no direction
    INVALID_CURVE        ///< a curve has no location, or two in a row without a common face; segments nearly coincide,
                         ///< so that rounding hides where they run; or the curves do not separate the surface
  };

  /// the value of `element()` if the fault is not that of a single element.
  static constexpr std::size_t no_element = (std::numeric_limits<std::size_t>::max)();

  /// creates an exception.
  ///
  /// \param reason what is wrong
  /// \param message what `what()` returns: a sentence for the user
  /// \param element the position of the element at fault in the range that `element()` names; `no_element` if the fault
  ///        is not that of a single element
  Invalid_geodesic_input(Reason reason, const std::string& message, std::size_t element = no_element)
    : std::invalid_argument(message), m_reason(reason), m_element(element)
  {}

  /// returns what is wrong. Programs compare this value; the words of `what()` may change.
  ///
  /// \return the reason that the constructor has been given
  Reason reason() const { return m_reason; }

  /// returns the element at fault: the position of a vertex, a face or an edge in the range `vertices(tm)`,
  /// `faces(tm)` or `edges(tm)`, or that of a source, an offset, a target, a sample, a site, a curve, a location of a
  /// curve, or a face or an edge to avoid in its range, counted from 0; `no_element` if no single element is at fault.
  std::size_t element() const { return m_element; }

private:
  Reason m_reason;
  std::size_t m_element;
};

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INVALID_GEODESIC_INPUT_H
