// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_CHECK_STORED_MATRIX_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_CHECK_STORED_MATRIX_H

// Checks samples of a stored matrix: some rows are computed anew, and compared with each other.
//
// Checksums show that files are what was written. These checks show that what was written is right: by the bits of a
// new run, which must be equal, and by what every metric satisfies, which needs no run and compares rows with each
// other. A wrong mesh, or a program with another order of operations, shows in the first; wrong positions of rows in
// both.

#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_status.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Stored_matrix.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/rows/Distance_matrix.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Different rows that are stored, at random, in ascending order; all of them if there are not more than `number`.
// The first steps of a shuffle. The same rows each time, so that a check can be repeated.
//
// If a square matrix is sparse, rows come in pairs: a random one, and that of one of its targets. Rows of random
// sources seldom have a target in common, so there would be nothing to compare.
inline std::vector<std::size_t> sampled_rows(const Stored_matrix& matrix, bool is_square, std::size_t number)
{
  std::vector<std::size_t> rows;
  for(std::size_t i = 0; i < matrix.layout().rows; ++i)
    if(matrix.is_done(i))
      rows.push_back(i);
  std::mt19937_64 random(0);
  // (The remainder of a random number is not evenly spread, by less than one in 2^30.)
  const auto position = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  number = (std::min)(number, rows.size());
  std::set<std::size_t> chosen;
  for(std::size_t k = 0; chosen.size() < number; ++k)
  {
    std::swap(rows[k], rows[k + position(rows.size() - k)]);
    chosen.insert(rows[k]);
    if(is_square && matrix.layout().kind == Store_kind::WITHIN_RADIUS)
    {
      const Stored_matrix::Sparse_row row = matrix.sparse_row(rows[k]); // not empty: it has the source itself
      const std::size_t partner = row.empty() ? rows[k] : row[position(row.size())].first;
      if(chosen.size() < number && matrix.is_done(partner))
        chosen.insert(partner);
    }
  }
  return std::vector<std::size_t>(chosen.begin(), chosen.end());
}

// By how much is a greater than b, relative to the larger one or to `scale`, if that is larger? 0 if it is not. An
// infinite a is infinitely greater.
inline double relative_excess(double a, double b, double scale)
{
  if(!(a > b))
    return 0;
  return a < std::numeric_limits<double>::infinity() ? (a - b) / (std::max)(a, scale) : a;
}

// The length of the longest edge. A window is rounded where its triangles are unfolded, in parts of their edges: on a
// needle, that is much more than a rounding of the distance between vertices of its short edge.
template <typename TriangleMesh, typename VertexPointMap>
double longest_edge_of_mesh(const TriangleMesh& tm, VertexPointMap vpm)
{
  // (A FaceListGraph has no list of edges; an edge between two faces is measured twice.)
  double longest = 0;
  for(const auto f : faces(tm))
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, tm), tm))
    {
      const auto& p = get(vpm, source(h, tm));
      const auto& q = get(vpm, target(h, tm));
      longest = (std::max)(longest, std::hypot(CGAL::to_double(p.x()) - CGAL::to_double(q.x()),
                                               CGAL::to_double(p.y()) - CGAL::to_double(q.y()),
                                               CGAL::to_double(p.z()) - CGAL::to_double(q.z())));
    }
  return longest;
}

// A column of a row that is not stored in a sparse matrix.
constexpr double unknown_distance = -1;

// The rows `d` of square matrices with the same vertices as sources and targets, compared with each other; `rows` are
// their numbers. What is unknown is greater than the radius. The triangle inequality does not hold over a vertex that
// walls divide (Vertex_copies.h): is_divided[b] tells whether the source of row b is one.
// Symmetry holds up to rounding only: the runs from both ends compute a distance by different windows. Violations are
// relative to `longest_edge` where that is larger, and to the smallest number that the type of the shards has with all
// digits.
inline void compare_rows(const Store_layout& layout, const std::vector<std::size_t>& rows,
                         const std::vector<std::vector<double>>& d, const std::vector<char>& is_divided,
                         double longest_edge, Geodesic_matrix_store_check& check)
{
  const double unknown = unknown_distance;
  // A float below it has lost digits when it was stored.
  const double smallest
    = layout.is_float32 ? double((std::numeric_limits<float>::min)()) : (std::numeric_limits<double>::min)();
  const double scale = (std::max)(longest_edge, smallest);
  // A missing entry of a sparse row is greater than the radius; of other rows, it is not known at all.
  const double radius = layout.kind == Store_kind::WITHIN_RADIUS ? layout.radius : 0;
  for(std::size_t a = 0; a < rows.size(); ++a)
    for(std::size_t b = 0; b < rows.size(); ++b)
    {
      const double there = d[a][rows[b]], back = d[b][rows[a]];
      if(a < b && (there != unknown || back != unknown))
      {
        // One that is not stored is at least the radius, and the other one at most.
        const double x = there == unknown ? radius : there, y = back == unknown ? radius : back;
        check.worst_asymmetry = (std::max)(
          {check.worst_asymmetry, relative_excess(x, y, scale), relative_excess(y, x, scale)});
        ++check.pairs_compared;
      }
      if(a == b || there == unknown || is_divided[b] != 0)
        continue;
      // All columns count, not only the samples: three sources of which two are samples.
      for(std::size_t k = 0; k < layout.columns; ++k) // from a to k is not farther than over b
        if(d[b][k] != unknown && (d[a][k] != unknown || radius > 0))
        {
          const double direct = d[a][k] == unknown ? radius : d[a][k];
          check.worst_triangle_violation
            = (std::max)(check.worst_triangle_violation, relative_excess(direct, there + d[b][k], scale));
          ++check.triangles_checked;
        }
    }
}

// Computes one row anew, and returns whether it has the bits that are stored. `position` is the number of the row among
// the samples, which are the sources of `matrix`; i is its number in the folder. Nothing but the same computation gives
// the same bits: a row that another version of the package has stored may differ in the last ones.
//
// Sets `whole` to the row for comparisons with others, with all columns. The first ones of an upper triangle are not
// stored: they are those that were computed now. So each pair is compared with the run from its other end.
inline bool is_row_equal(const Stored_matrix& stored, std::size_t i, const Distance_matrix<double>& matrix,
                         Distance_matrix<double>::Worker& worker, std::size_t position,
                         const std::vector<Vertex_id>& targets,
                         const Distance_matrix<double>::Target_positions& positions, std::vector<double>& whole)
{
  const auto go_further = []() { return true; };
  const auto rounded = [&](double x)
  { return stored.layout().is_float32 ? static_cast<double>(static_cast<float>(x)) : x; };
  if(stored.layout().kind == Store_kind::WITHIN_RADIUS)
  {
    Distance_matrix<double>::Sparse_row row;
    // Rounding comes after the run, as in the writer.
    matrix.fill_sparse_row(worker, position, positions, stored.layout().radius, row, go_further);
    for(auto& entry : row)
      entry.second = rounded(entry.second);
    const Stored_matrix::Sparse_row stored_row = stored.sparse_row(i);
    whole.assign(stored.layout().columns, unknown_distance);
    for(const std::pair<std::size_t, double>& entry : stored_row)
      whole[entry.first] = entry.second;
    return row == stored_row;
  }
  matrix.fill_dense_row(worker, position, targets.data(), targets.data() + targets.size(), whole, go_further);
  for(double& x : whole)
    x = rounded(x);
  const std::vector<double> row = stored.dense_row(i);
  const auto first = whole.end() - static_cast<std::ptrdiff_t>(row.size());
  const bool is_equal = std::equal(row.begin(), row.end(), first);
  std::copy(row.begin(), row.end(), first); // what is stored is what is compared
  return is_equal;
}

// Returns the targets of a manifest as vertices of a mesh. They are needed for the rows that are computed anew;
// comparisons of rows know columns by their positions. Targets that are the sources, or all vertices, are words in the
// manifest.
template <typename TriangleMesh, typename Vertices, typename Faces>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
stored_targets(const Stored_matrix& stored, const Vertices& vertex_of_index, const Faces& face_of_index)
{
  const Store_description& d = stored.description();
  Stored_sources<TriangleMesh> targets;
  for(std::size_t j = 0; j < d.layout.columns; ++j)
    targets.add(d.targets.is_text("sources") ? d.sources : d.targets, j, vertex_of_index, face_of_index);
  return targets.vertices;
}

// Returns a flag for each face, set for those that the paths of the matrix avoid; none if there are no such faces.
// Throws if the manifest names a face that the mesh does not have.
inline std::vector<char> stored_faces_to_avoid(const Store_description& description, std::size_t number_of_faces)
{
  std::vector<char> is_avoided;
  for(const std::size_t f : description.faces_to_avoid)
  {
    if(f >= number_of_faces)
      Json_value::complain("a face to avoid is not in the mesh");
    is_avoided.resize(number_of_faces, 0);
    is_avoided[f] = 1;
  }
  return is_avoided;
}

// Throws if the checksums of the manifest and of the mesh differ.
inline void check_same_mesh(const std::string& path, const std::string& stored, const std::string& hash)
{
  if(hash != stored)
    throw Geodesic_matrix_store_error(Geodesic_matrix_store_error::Reason::DIFFERENT_MESH,
                                      path + ": the folder has the matrix of a mesh with the hash " + stored
                                        + ", and this mesh has the hash " + hash);
}

// Returns the element with each index of a map, for n indices. Those that no element has get a default element: where
// elements have been removed from a mesh, indices have gaps. The reader of the mesh rejects such elements later.
template <typename Element, typename Range, typename IndexMap>
std::vector<Element> elements_by_index(const Range& range, const IndexMap& indices, std::size_t n)
{
  std::vector<Element> result(n);
  for(const Element e : range)
    result[static_cast<std::size_t>(get(indices, e))] = e;
  return result;
}

// The mesh must be that of the manifest: checksums are compared first. The new rows are computed by one thread, on one
// reading of the mesh. The manifest tells the faces and edges to avoid, so the caller need not. (Locations are not
// compared with each other, so the flags of divided vertices are read for vertices only.)
template <typename TriangleMesh, typename NamedParameters>
Geodesic_matrix_store_check check_stored_matrix(const TriangleMesh& tm, const std::string& path, std::size_t samples,
                                                const NamedParameters& np)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  check_parameters<Mesh_parameters>(tm, np);
  const Stored_matrix stored(path);
  const Store_description& d = stored.description();
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto fim = CGAL::get_initialized_face_index_map(tm, np);
  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, tm));
  check_same_mesh(path, d.mesh_hash, hash_of_mesh(tm, vim, fim, vpm));
  // The manifest has indices; descriptors are found by two tables.
  const auto vertex_of_index = elements_by_index<typename Graph_traits::vertex_descriptor>(vertices(tm), vim,
                                                                                           num_vertices(tm));
  const auto face_of_index = elements_by_index<typename Graph_traits::face_descriptor>(faces(tm), fim, num_faces(tm));

  Geodesic_matrix_store_check check;
  // Only a square matrix, with the same vertices in the same order, has entries there and back.
  const bool is_square = d.targets.is_text("sources") || (d.targets.is_text("all") && d.sources.is_text("all"));
  const std::vector<std::size_t> rows = sampled_rows(stored, is_square, samples);
  std::vector<std::vector<double>> whole_rows(rows.size());
  Stored_sources<TriangleMesh> sources;
  for(const std::size_t i : rows)
    sources.add(d.sources, i, vertex_of_index, face_of_index);
  std::vector<char> is_divided;
  const auto obstacles_of = [&](const auto&)
  {
    return Obstacles{stored_faces_to_avoid(d, num_faces(tm)), named_walls(tm, fim, face_of_index, d.edges_to_avoid)};
  };
  with_surface_without<Sequential_tag>(tm, np, obstacles_of, [&](const auto& surface)
  {
    const Distance_matrix<double> matrix(surface.mesh(), sources.vertices.empty()
                                                           ? surface.source_set(sources.locations)
                                                           : surface.source_set(sources.vertices), surface.copies());
    const std::vector<Vertex_id> targets
      = surface.checked_ids(stored_targets<TriangleMesh>(stored, vertex_of_index, face_of_index), "target");
    const Distance_matrix<double>::Target_positions positions(targets, surface.mesh().number_of_vertices(),
                                                              surface.copies());
    const auto worker = matrix.make_worker();
    for(std::size_t k = 0; k < rows.size(); ++k, ++check.rows_compared)
    {
      check.rows_different
        += is_row_equal(stored, rows[k], matrix, *worker, k, targets, positions, whole_rows[k]) ? 0 : 1;
      is_divided.push_back(surface.copies().is_divided(matrix.sources().vertices[k]) ? 1 : 0);
    }
    return true;
  });
  if(is_square && sources.locations.empty())
    compare_rows(stored.layout(), rows, whole_rows, is_divided, longest_edge_of_mesh(tm, vpm), check);
  return check;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_CHECK_STORED_MATRIX_H
