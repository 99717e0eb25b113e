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

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
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
  // The walls in ascending order, each once: a face and the number of its edge (Store_input.h).
  std::vector<std::array<std::size_t, 2>> edges_to_avoid;

  // The checksum of all that decides about the numbers, except the mesh. The size of shards does not.
  // Paths that lead around other obstacles are other numbers. Without faces or edges to avoid, the checksum is that of
  // folders that were made before manifests knew these.
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
    if(!edges_to_avoid.empty())
      sum.add(edges_to_json().written()); // the brackets tell them from faces
    return sum.text();
  }

  // The faces and edges to avoid as a manifest lists them, and back. Whether the mesh has them is not known here; the
  // check of a matrix, which reads the mesh, asks.
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

  // A list of pairs. Two edges may have the same two vertices, so vertices would not do as names.
  Json_value edges_to_json() const
  {
    std::vector<Json_value> list;
    for(const std::array<std::size_t, 2>& e : edges_to_avoid)
      list.push_back(Json_value(std::vector<Json_value>(e.begin(), e.end())));
    return Json_value(std::move(list));
  }

  // Throws if an element is no pair of numbers.
  void set_edges_to_avoid(const Json_value& list)
  {
    edges_to_avoid.clear();
    for(const Json_value& e : list.elements())
    {
      if(e.elements().size() != 2)
        Json_value::complain("an edge to avoid is not given by a face and a number");
      edges_to_avoid.push_back({e.elements()[0].count(), e.elements()[1].count()});
    }
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_DESCRIPTION_H
