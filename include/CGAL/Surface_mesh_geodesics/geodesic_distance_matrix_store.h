// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_MATRIX_STORE_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_MATRIX_STORE_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_status.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Stored_matrix.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/check_stored_matrix.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/store_matrix.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

computes the exact geodesic distances from each of several sources to each of several targets, and stores them in a
folder. A call that ends early, for whatever reason, leaves a folder with which the next call goes on.

<b>The folder.</b> The rows are in shards: blocks of consecutive rows, in files of NumPy's format (`.npy`, version 1.0,
little endian, C order) whose names sort in the order of the rows. `manifest.json` names the mesh, with a checksum of
its connectivity and coordinates, the sources, the targets, the faces to avoid, the kind of the matrix, and the shards
that are done, with the checksums of their elements (CRC-64/XZ). \ref Surface_mesh_geodesics_plan_bigger explains how
to read it.

<b>Interruption.</b> A shard is written under a temporary name, synced, and renamed; the manifest is, too. A process
that is killed loses the shards in work and nothing else. The next call removes its temporary files, computes shards
that are missing, and those whose files are not what their checksums say.

<b>Several processes</b>, also on several machines, may work on one folder: a lock file for each shard in work has the
host and the process of its owner. The lock of a process that is dead is taken over at once on its own host, and on
others after ten minutes without a sign of life.

<b>Bits.</b> The stored numbers are those of `geodesic_distance_matrix()`, whatever the numbers of threads, processes
and interruptions are, if the processes run the same program.

<b>Complexity.</b> That of `geodesic_distance_matrix()`, plus a linear time for each row. Memory: the mesh, and what
`memory_limit` allows. Calls look at each shard of their range, and read the files of those
that are done.

<b>Thread safety.</b> As for `geodesic_distances()`. Several threads may call the function for one folder.

\tparam ConcurrencyTag as for `geodesic_distance_matrix()`. Each thread computes a shard alone.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam Sources as for `geodesic_distance_matrix()`
\tparam Targets as for `geodesic_distance_matrix()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param sources the sources
\param targets the targets
\param folder the name of the folder, which is made if it does not exist
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh`
                   as key type and a 3D point type with the members `x()`, `y()`, `z()` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of `tm` a unique index between `0`
                          and `num_vertices(tm) - 1`; the manifest names vertices by these indices}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh`
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{a property map associating to each face of `tm` a unique index between `0`
                          and `num_faces(tm) - 1`; the manifest names faces by these indices}
    \cgalParamType{a class model of `ReadablePropertyMap` with the face descriptor of `TriangleMesh`
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{use_float32}
    \cgalParamDescription{whether distances are stored in 32 bits, which saves half of the space. They are rounded to
                          the nearest number of type `float`, to the even one in a tie: the relative error is at most
                          2<sup>-24</sup> for distances above 2<sup>-126</sup>.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
    \cgalParamExtra{All calls for one folder need the same value.}
  \cgalParamNEnd
  \cgalParamNBegin{use_symmetry}
    \cgalParamDescription{whether only distances between different sources are stored, each once: row `i` has those to
                          the sources `i + 1`, `i + 2`, ... Sources and targets must be the same vertices, and the
                          radius infinite. The order of `geodesic_peeling_order()` saves time.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
    \cgalParamExtra{All calls for one folder need the same value.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_distance}
    \cgalParamDescription{the radius, in the unit of the mesh: only distances up to it are stored, as a sparse matrix,
                          unless it is infinite}
    \cgalParamType{`double`}
    \cgalParamDefault{infinity}
    \cgalParamExtra{All calls for one folder need the same value.}
  \cgalParamNEnd
  \cgalParamNBegin{faces_to_avoid}
    \cgalParamDescription{the faces through which no path may lead, as for `geodesic_distances()`; the manifest names
                          them by their indices}
    \cgalParamType{a range of face descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   face descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
    \cgalParamExtra{All calls for one folder need the same faces.}
  \cgalParamNEnd
  \cgalParamNBegin{edges_to_avoid}
    \cgalParamDescription{the edges that no path may cross, as for `geodesic_distances()`; the manifest names each by
                          the index of a face and a number}
    \cgalParamType{a range of edge descriptors of `TriangleMesh`, or a class model of `ReadablePropertyMap` with the
                   edge descriptor as key type and `bool` as value type}
    \cgalParamDefault{an empty range: none}
    \cgalParamExtra{All calls for one folder need the same edges.}
  \cgalParamNEnd
  \cgalParamNBegin{rows_per_shard}
    \cgalParamDescription{the number of rows of a shard; 0 lets the function choose it. A folder that has a manifest
                          keeps its own number.}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{`0`}
  \cgalParamNEnd
  \cgalParamNBegin{first_row}
    \cgalParamDescription{the first row that this call computes. A call computes the shards whose first row is in
                          [`first_row`, `end_row`). There may be none: an array job may have more tasks than the matrix
                          has rows, and the status returned then counts no row.}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{`0`}
  \cgalParamNEnd
  \cgalParamNBegin{end_row}
    \cgalParamDescription{the row behind the last one}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{the number of sources}
  \cgalParamNEnd
  \cgalParamNBegin{memory_limit}
    \cgalParamDescription{the number of bytes for rows that are not written yet, of all threads together. There are
                          never more threads than rows of `double` that fit, but at least one. The mesh and the
                          wavefronts are not counted.}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{2<sup>26</sup>}
  \cgalParamNEnd
  \cgalParamNBegin{mesh_name}
    \cgalParamDescription{the name of the mesh in the manifest, such as that of its file}
    \cgalParamType{`std::string`}
    \cgalParamDefault{an empty name}
  \cgalParamNEnd
  \cgalParamNBegin{compare_checksums}
    \cgalParamDescription{whether the files of shards that are done are read and compared with their checksums. Without,
                          a call starts sooner, and does not see damage.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{a visitor that is told of rows, and can cancel: `on_propagation_begin(n)` with the number of
                          rows of the range, `on_progress(k, 0)` when `k` of them are done, and every now and
                          then during a row, `go_further()` after that, and `on_propagation_end()`. If it has the
                          function `on_rows(computed, found, n)`, that one is called, too, with the numbers of rows that
                          this call has computed and that were stored before. Calls may come from different threads,
                          but never two at a time.}
    \cgalParamType{a model of `GeodesicPropagationVisitor`}
    \cgalParamDefault{`Geodesic_default_visitor`}
    \cgalParamExtra{The parameter is copied; `std::ref()` passes a reference.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return how much of the range is stored. It is not complete if the visitor has canceled, or if other processes are still
        at work on some shards.

\throws Invalid_geodesic_input for a mesh, a source, a target, a radius, faces or edges to avoid that
        `sparse_geodesic_distance_matrix()` rejects
\throws Geodesic_matrix_store_error if the folder belongs to another mesh, or to other sources, targets or parameters
        (the message has both checksums), if a file cannot be written, and for numbers of 32 bits if a distance is too
        large, or so small that it would become zero; with the reason `INVALID_OPTION` if `use_symmetry` meets a finite
        radius or sources that are not the targets, or if `first_row` is greater than `end_row`
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Sources, typename Targets,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Geodesic_matrix_store_status
store_geodesic_distance_matrix(const TriangleMesh& tm, const Sources& sources, const Targets& targets,
                               const std::string& folder,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::store_matrix<ConcurrencyTag>(tm, sources, targets, folder, np);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_distance_matrix_store` reads a folder that `store_geodesic_distance_matrix()` has made. It needs no
mesh.

Other processes may add shards meanwhile. All functions that read files throw `Geodesic_matrix_store_error`.

<b>Thread safety.</b> Several threads may call the functions of one object at once.
*/
class Geodesic_distance_matrix_store
{
public:
  /// a row of a sparse matrix: columns in ascending order, with their distances.
  using Sparse_row = std::vector<std::pair<std::size_t, double>>;

  /// reads the manifest of a folder.
  ///
  /// \param folder the name of the folder
  explicit Geodesic_distance_matrix_store(const std::string& folder) : m_matrix(folder) {}

  /// \name The Manifest
  /// @{

  /// returns the name of the mesh.
  const std::string& mesh_name() const { return m_matrix.description().mesh_name; }
  /// returns the checksum of the mesh.
  const std::string& mesh_hash() const { return m_matrix.description().mesh_hash; }
  /// returns the number of sources.
  std::size_t number_of_rows() const { return m_matrix.layout().rows; }
  /// returns the number of targets.
  std::size_t number_of_columns() const { return m_matrix.layout().columns; }
  /// returns whether the distances are stored in 32 bits.
  bool uses_float32() const { return m_matrix.layout().is_float32; }
  /// returns whether each pair of sources is stored once.
  bool uses_symmetry() const { return m_matrix.layout().kind == internal::Store_kind::UPPER_TRIANGLE; }
  /// returns the radius of a sparse matrix, in the unit of the mesh; infinity for another one.
  double maximum_distance() const
  {
    return m_matrix.layout().kind == internal::Store_kind::WITHIN_RADIUS ? m_matrix.layout().radius
                                                                         : std::numeric_limits<double>::infinity();
  }
  /// returns the indices of the faces to avoid, in ascending order.
  const std::vector<std::size_t>& faces_to_avoid() const { return m_matrix.description().faces_to_avoid; }
  /// returns the edges to avoid that are between two faces, each once, in ascending order: the index of a face, and the
  /// number k of its edge, which leads from corner k of the face to the next one. Corners are counted as for locations,
  /// from the source of `halfedge(f, tm)`.
  const std::vector<std::array<std::size_t, 2>>& edges_to_avoid() const
  {
    return m_matrix.description().edges_to_avoid;
  }
  /// returns the number of rows of a shard; the last one may have fewer.
  std::size_t rows_per_shard() const { return m_matrix.layout().rows_per_shard; }

  /// @}
  /// \name Rows
  /// @{

  /// returns how much of the matrix is stored. Looks at each shard, but does not read them.
  Geodesic_matrix_store_status status() const { return m_matrix.status(); }

  /// returns a row: all targets, or with `use_symmetry` the sources behind source `i`.
  ///
  /// \param i the number of the row
  ///
  /// \pre the matrix is not sparse, and `i` is less than the number of rows
  std::vector<double> row(std::size_t i) const { return m_matrix.dense_row(i); }

  /// returns a row of a sparse matrix.
  ///
  /// \param i the number of the row
  ///
  /// \pre the matrix is sparse, and `i` is less than the number of rows
  Sparse_row sparse_row(std::size_t i) const { return m_matrix.sparse_row(i); }

  /// compares each shard that is done with its checksum.
  ///
  /// \return the first row, and the one behind the last one, of each damaged shard
  std::vector<std::pair<std::size_t, std::size_t>> damaged_shards() const { return m_matrix.damaged_shards(); }

  /// @}

private:
  internal::Stored_matrix m_matrix;
};

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

checks stored distances on samples: computes some rows anew, and compares these rows with each other by symmetry and by
the triangle inequality, if sources and targets are the same vertices. The folder tells which faces and edges paths
avoid. The triangle inequality is left out over a vertex that edges to avoid divide: it does not hold there.
Checksums are checked by `Geodesic_distance_matrix_store::damaged_shards()`.

<b>Complexity.</b> `samples` rows are computed; the inequalities take time for the square of `samples`, times the number
of columns. Memory: the rows of the samples.

<b>Thread safety.</b> As for `geodesic_distances()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh of the matrix
\param folder the name of the folder
\param samples the number of rows, which are chosen at random, the same ones in each call; of a sparse matrix, half of
       them are those of targets of others
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": the maps of
       `store_geodesic_distance_matrix()`

\return the worst violations

\throws Geodesic_matrix_store_error if the folder has the matrix of another mesh, or cannot be read
\throws Invalid_geodesic_input for a mesh that `geodesic_distances()` rejects
*/
template <typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Geodesic_matrix_store_check
check_geodesic_distance_matrix(const TriangleMesh& tm, const std::string& folder, std::size_t samples = 10,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::check_stored_matrix(tm, folder, samples, np);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_DISTANCE_MATRIX_STORE_H
