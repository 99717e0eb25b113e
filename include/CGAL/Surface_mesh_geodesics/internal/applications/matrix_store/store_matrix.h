// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_MATRIX_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_MATRIX_H

// What the public functions that store matrices do: check the options, describe the matrix, and compute its shards.
//
// All input is checked before the folder is touched, in this order: the options, the mesh, the sources and targets, and
// at last whether they fit the manifest. So a call that is rejected changes nothing.

#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_status.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Shard_list.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_computation.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_folder.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_options.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Stored_matrix.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Available_tag.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// True for a visitor that is told how many rows were computed and found.
// (The functions of GeodesicPropagationVisitor count rows too, but not how many of them cost nothing.)
template <typename Visitor, typename = void>
struct Follows_rows
  : std::false_type
{};

template <typename Visitor>
struct Follows_rows<Visitor, std::void_t<decltype(std::declval<Visitor&>().on_rows(std::size_t(), std::size_t(),
                                                                                   std::size_t()))>>
  : std::true_type
{};

// The description of a matrix on a surface that has been read: all sources and targets are valid. The targets of an
// upper triangle must be the sources, which must be vertices. The size of shards is that of a new folder; the manifest
// of an old one counts instead. The manifest names the faces of the obstacles by their indices, as it names vertices.
template <typename TriangleMesh, typename Sources, typename Targets, typename NamedParameters>
Store_description describe(const TriangleMesh& tm, const Sources& sources, const Targets& targets,
                           const Source_set<double>& source_set, const std::vector<Vertex_id>& target_ids,
                           const Obstacles& obstacles, const Store_options& options, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  // Sources on walls are listed once more behind all sources of the user, on their other sides; these are no rows, and
  // such a matrix may be symmetric as well.
  const std::size_t number = source_set.number_of_sources();
  if(options.use_symmetry && (!source_set.located.empty() || number != target_ids.size()
                              || !std::equal(target_ids.begin(), target_ids.end(), source_set.vertices.begin())))
    throw Geodesic_matrix_store_error(Geodesic_matrix_store_error::Reason::INVALID_OPTION,
                                      "only a matrix whose sources and targets are the same vertices is symmetric");
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto fim = CGAL::get_initialized_face_index_map(tm, np);
  Store_description d;
  d.mesh_name = options.mesh_name;
  d.mesh_hash = hash_of_mesh(tm, vim, fim, choose_parameter(get_parameter(np, internal_np::vertex_point),
                                                            get_const_property_map(CGAL::vertex_point, tm)));
  d.vertices = num_vertices(tm);
  d.faces = num_faces(tm);
  d.sources = sources_to_json(tm, sources, vim, fim);
  d.targets = sources_to_json(tm, targets, vim, fim);
  // a list that is the same twice is stored once
  if(!d.targets.is_text("all") && d.targets.written() == d.sources.written())
    d.targets = Json_value("sources");
  for(std::size_t f = 0; f < obstacles.is_avoided.size(); ++f)
    if(obstacles.is_avoided[f] != 0)
      d.faces_to_avoid.push_back(f);
  d.edges_to_avoid = names_of_walls(tm, fim, obstacles.walls);
  Store_layout& layout = d.layout;
  layout.kind = options.use_symmetry ? Store_kind::UPPER_TRIANGLE
              : options.maximum_distance < std::numeric_limits<double>::infinity() ? Store_kind::WITHIN_RADIUS
                                                                                   : Store_kind::FULL;
  layout.is_float32 = options.use_float32;
  layout.rows = number;
  layout.columns = target_ids.size();
  layout.radius = options.maximum_distance;
  // too large a number is no error: it means "all rows in one file"
  layout.rows_per_shard = (std::min)(layout.largest_rows_per_shard(), options.rows_per_shard != 0
                                                                        ? options.rows_per_shard
                                                                        : layout.default_rows_per_shard());
  return d;
}

// Reads the mesh, opens the folder by open(folder, description), and computes the shards of the rows of the options.
// compute(tag, computation, shards, left, rows_reported) hands them out to the computation; `left` gets those that are
// left to other processes, and `rows_reported` counts rows meanwhile. Returns how much of the range is stored.
template <typename ConcurrencyTag, typename TriangleMesh, typename Sources, typename Targets, typename NamedParameters,
          typename Open, typename Compute>
Geodesic_matrix_store_status store_matrix_with(const TriangleMesh& tm, const Sources& sources, const Targets& targets,
                                               const std::string& path, const NamedParameters& np, Open open,
                                               Compute compute)
{
  check_parameters<Store_parameters>(tm, np);
  const Store_options options = store_options(np);
  // a copy of the user's visitor, or a reference to it
  Visitor_parameter<NamedParameters> parameter(np);
  auto& visitor = parameter.visitor();
  using Visitor = std::remove_reference_t<decltype(visitor)>;
  Geodesic_matrix_store_status status;
  with_surface<ConcurrencyTag>(tm, np, [&](const auto& surface)
  {
    const Distance_matrix<double> matrix(surface.mesh(), surface.source_set(sources), surface.copies());
    const std::vector<Vertex_id> target_ids = surface.checked_ids(targets, "target");
    Store_folder folder(path);
    open(folder, describe(tm, sources, targets, matrix.sources(), target_ids, surface.obstacles(), options, np));
    // Remains of processes that were killed: they would otherwise stay until somebody wonders what they are.
    folder.remove_stale_files();
    // Shards that are done are among them: their files may be damaged.
    const std::vector<std::size_t> shards = shards_of_rows(folder.layout(), options.first_row, options.end_row);
    std::vector<std::size_t> left;
    std::size_t rows = 0, rows_computed = 0, rows_found = 0;
    std::atomic<std::size_t> rows_reported{0};
    for(const std::size_t s : shards)
      rows += folder.layout().rows_of(s);
    run_with_visitor(visitor, rows, [&](const auto& go_on)
    {
      // The numbers need no lock: calls come one at a time (Store_computation::report()).
      const auto report = [&](std::size_t computed, std::size_t found)
      {
        rows_computed += computed;
        rows_found += found;
        rows_reported += computed + found;
        if constexpr(Follows_rows<Visitor>::value)
          visitor.on_rows(rows_computed, rows_found, rows);
        return go_on(rows_computed + rows_found, 0.);
      };
      Store_computation<decltype(report)> computation(folder, matrix, target_ids, surface.mesh().number_of_vertices(),
                                                      options, report);
      return compute(typename Available_tag<ConcurrencyTag>::type(), computation, shards, left, rows_reported);
    });
    // Records of this call, and of others that were killed before they moved theirs.
    if(folder.is_merging())
      folder.merge();
    // What counts is what the folder says at the end, not what this call has done. Others may be about to replace a
    // damaged shard; its entry in the manifest still says that it is done, so its files are read.
    status = status_of_shards(folder, shards, left);
    return true;
  });
  return status;
}

// One process alone, or several that know each other by their locks only.
template <typename ConcurrencyTag, typename TriangleMesh, typename Sources, typename Targets, typename NamedParameters>
Geodesic_matrix_store_status store_matrix(const TriangleMesh& tm, const Sources& sources, const Targets& targets,
                                          const std::string& path, const NamedParameters& np)
{
  return store_matrix_with<ConcurrencyTag>(
    tm, sources, targets, path, np,
    [](Store_folder& folder, const Store_description& description) { folder.open_or_create(description); },
    [](auto tag, auto& computation, const std::vector<std::size_t>& shards, std::vector<std::size_t>& left, const auto&)
    {
      Shard_list list(shards);
      const bool is_complete = computation.run(tag, list);
      left = list.left();
      return is_complete;
    });
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_MATRIX_H
