// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_MATRIX_STORE_ERROR_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_MATRIX_STORE_ERROR_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_matrix_store_error` is the exception of the functions for stored matrices of distances: it reports a
folder that does not fit the call, and files that cannot be read or written. Faults of the mesh, of sources and of
targets throw `Invalid_geodesic_input`.

`reason()` tells programs what is wrong, and `what()` tells it to the user in one sentence; where it is about a file or
a folder, it begins with that name. A folder is unchanged if it does not fit the call. If a file cannot be written, the
shards that are done stay, and a later call goes on.

\code
try
{
  CGAL::Surface_mesh_geodesics::store_geodesic_distance_matrix(mesh, vertices(mesh), vertices(mesh), "distances");
}
catch(const CGAL::Surface_mesh_geodesics::Geodesic_matrix_store_error& error)
{
  std::cerr << error.what() << std::endl;
}
\endcode

\sa `store_geodesic_distance_matrix()`
\sa `Geodesic_distance_matrix_store`
*/
class Geodesic_matrix_store_error
  : public std::runtime_error
{
public:
  /// what is wrong.
  enum class Reason
  {
    DIFFERENT_MESH,    ///< the folder has the matrix of another mesh
    DIFFERENT_MATRIX, ///< the folder has a matrix with other sources, targets or options
    NOT_A_STORE,      ///< the folder has no manifest, or one that cannot be understood
    INVALID_OPTION,   ///< an option is out of its range, or does not fit the others
    NOT_STORED,       ///< a row is asked for that has not been stored yet
    DAMAGED,          ///< a shard is not what its checksum says
    NOT_REPRESENTABLE, ///< a finite distance is too large for the type of the stored numbers, or would become zero
    FILE_ERROR        ///< a file or a folder cannot be read or written
  };

  /// creates an exception.
  ///
  /// \param reason what is wrong
  /// \param message what `what()` returns: a sentence for the user
  Geodesic_matrix_store_error(Reason reason, const std::string& message)
    : std::runtime_error(message), m_reason(reason)
  {}

  /// returns what is wrong. Programs compare this value; the words of `what()` may change.
  Reason reason() const { return m_reason; }

private:
  Reason m_reason;
};

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_MATRIX_STORE_ERROR_H
