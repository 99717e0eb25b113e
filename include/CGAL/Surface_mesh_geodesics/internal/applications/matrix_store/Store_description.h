// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_DESCRIPTION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_DESCRIPTION_H

// Which matrix a folder holds: the mesh, the rows and columns, and all that decides about their numbers. Two calls may
// work on one folder if their descriptions have the same checksums.

#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_layout.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Checksum.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Json_value.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// What is stored, as the manifest tells it. `sources` and `targets` are "all", "sources" or a list of vertices and
// locations (Store_input.h). Vertices and faces are named by their indices, as mesh files do. `mesh_name` is for people
// and for --verify: it decides nothing, so a folder stays valid if the mesh moves.
struct Store_description
{
  std::string mesh_name, mesh_hash;
  std::size_t vertices = 0, faces = 0;
  Store_layout layout;
  Json_value sources, targets;
  // In ascending order, as they are a set: calls that name them in another order go on with the same matrix.
  std::vector<std::size_t> faces_to_avoid;

  // The checksum of all that decides about the numbers, except the mesh. The size of shards does not.
  // Paths that lead around other faces are other numbers. Without faces to avoid, the checksum is that of folders that
  // were made before manifests knew such faces.
  std::string hash() const
  {
    Store_layout without_shards = layout;
    without_shards.rows_per_shard = 1;
    Checksum sum;
    sum.add(without_shards.to_json().written());
    sum.add(sources.written());
    sum.add(targets.written());
    for(const std::size_t f : faces_to_avoid)
      sum.add(static_cast<std::uint64_t>(f));
    return sum.text();
  }

  // The faces to avoid as a manifest lists them, and back. Whether the mesh has the faces is not known here; the check
  // of a matrix, which reads the mesh, asks.
  Json_value faces_to_json() const
  {
    return Json_value(std::vector<Json_value>(faces_to_avoid.begin(), faces_to_avoid.end()));
  }

  void set_faces_to_avoid(const Json_value& list)
  {
    faces_to_avoid.clear();
    for(const Json_value& f : list.elements())
      faces_to_avoid.push_back(f.count());
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_DESCRIPTION_H
