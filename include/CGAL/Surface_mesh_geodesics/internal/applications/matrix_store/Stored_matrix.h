// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORED_MATRIX_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORED_MATRIX_H

// Reads the shards of a folder.
//
// Rows are found by computing their place in a file. Nothing is kept in memory but the manifest, and no row is compared
// with its checksum, which is one for the whole shard: damaged_shards() does that.

#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_status.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Shard_list.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_folder.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Npy_file.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Counts what is done of some shards. Locks are looked at only where something is missing, and compared with the clock
// of the folder. Takes time for the number of shards. Shards that are done in the meantime may be counted as missing,
// never the other way round. The files of `doubtful` shards are read, as they may be damaged.
inline Geodesic_matrix_store_status status_of_shards(Store_folder& folder, const std::vector<std::size_t>& shards,
                                                     const std::vector<std::size_t>& doubtful = {})
{
  Geodesic_matrix_store_status status;
  std::vector<std::size_t> missing;
  for(const std::size_t s : shards)
  {
    Shard_entry entry;
    // (Doubtful shards are few: one for each other process at most.)
    const bool is_done = folder.find(s, entry)
                      && (std::find(doubtful.begin(), doubtful.end(), s) == doubtful.end()
                          || folder.is_intact(s, entry));
    status.rows += folder.layout().rows_of(s);
    status.rows_done += is_done ? folder.layout().rows_of(s) : 0;
    status.shards_done += is_done ? 1 : 0;
    if(!is_done)
      missing.push_back(s);
  }
  status.shards = shards.size();
  if(!missing.empty())
  {
    // one look at the clock for all locks
    const Folder_clock clock(folder.path());
    for(const std::size_t s : missing)
      status.shards_in_work += folder.is_locked(s, clock) ? 1 : 0;
  }
  return status;
}

// Const functions may be called by several threads at once: the folder has a mutex.
// The folder may grow while the object lives: each function sees what is done when it is called.
class Stored_matrix
{
public:
  using Sparse_row = std::vector<std::pair<std::size_t, double>>;

  // Opens the folder for reading. Throws Geodesic_matrix_store_error if it has no manifest, or not one of this version.
  explicit Stored_matrix(const std::filesystem::path& path) : m_folder(path) { m_folder.open(); }

  const Store_description& description() const { return m_folder.description(); }
  const Store_layout& layout() const { return m_folder.layout(); }

  // The numbers of all shards, done or not.
  std::vector<std::size_t> all_shards() const { return shards_of_rows(layout(), 0, layout().rows); }
  Geodesic_matrix_store_status status() const { return status_of_shards(m_folder, all_shards()); }

  // Returns whether the shard of a row is done. Requires: row is less than the number of rows.
  bool is_done(std::size_t row) const
  {
    Shard_entry entry;
    return m_folder.find(row / layout().rows_per_shard, entry);
  }

  // Returns the rows of shards whose files do not have their checksums, from the first row to the one behind the last.
  // Shards that are missing do not count. Reads all files.
  std::vector<std::pair<std::size_t, std::size_t>> damaged_shards() const
  {
    std::vector<std::pair<std::size_t, std::size_t>> damaged;
    for(const std::size_t s : all_shards())
    {
      Shard_entry entry;
      if(m_folder.find(s, entry) && !m_folder.is_intact(s, entry))
        damaged.emplace_back(layout().first_row(s), layout().end_row(s));
    }
    return damaged;
  }

  // Returns the entries of row i that are stored: all columns or, of an upper triangle, those behind the diagonal.
  // Throws if the row is not stored yet, or if its file cannot be read. Requires: the matrix is not sparse.
  std::vector<double> dense_row(std::size_t i) const
  {
    CGAL_precondition(i < layout().rows && layout().kind != Store_kind::WITHIN_RADIUS);
    // One part of one file is read, wherever the row is in it.
    const std::size_t shard = shard_with(i);
    return distances(m_folder.file(shard, ".npy"), layout().entries_before(shard, i), layout().length_of_row(i));
  }

  // Returns the entries of row i, with their columns. Throws as dense_row() does. Indices of a damaged file lead to an
  // exception, not behind the end of a file or of a row. Requires: the matrix is sparse.
  Sparse_row sparse_row(std::size_t i) const
  {
    CGAL_precondition(i < layout().rows && layout().kind == Store_kind::WITHIN_RADIUS);
    const std::size_t shard = shard_with(i);
    const std::vector<std::uint32_t> begins = read_npy_elements<std::uint32_t>(
      m_folder.file(shard, ".indptr.npy"), i - layout().first_row(shard), 2);
    if(begins[1] < begins[0] || begins[1] - begins[0] > layout().columns)
      complain_of_damage(m_folder.file(shard, ".indptr.npy"));
    // Rows may be empty; not that of a source that is a target itself.
    const std::size_t number = begins[1] - begins[0];
    const std::vector<std::uint32_t> columns
      = read_npy_elements<std::uint32_t>(m_folder.file(shard, ".indices.npy"), begins[0], number);
    for(const std::uint32_t column : columns)
      if(column >= layout().columns)
        complain_of_damage(m_folder.file(shard, ".indices.npy"));
    const std::vector<double> values = distances(m_folder.file(shard, ".data.npy"), begins[0], number);
    Sparse_row row;
    for(std::size_t k = 0; k < number; ++k)
      row.emplace_back(columns[k], values[k]);
    return row;
  }

private:
  // What is read is not what the package has written. The checksum of the shard would tell, but a row is read without
  // it: a shard may have gigabytes.
  [[noreturn]] static void complain_of_damage(const std::filesystem::path& path)
  {
    throw Geodesic_matrix_store_error(Geodesic_matrix_store_error::Reason::DAMAGED,
                                      path.string() + ": the file is damaged");
  }

  // Returns the shard of a row. Throws if it is not done: a row is read from a complete file only.
  std::size_t shard_with(std::size_t i) const
  {
    if(!is_done(i))
      throw Geodesic_matrix_store_error(Geodesic_matrix_store_error::Reason::NOT_STORED,
                                        m_folder.path().string() + ": row " + std::to_string(i)
                                          + " is not stored yet");
    return i / layout().rows_per_shard;
  }

  // Numbers of 32 bits become numbers of 64 bits, which is exact.
  std::vector<double> distances(const std::filesystem::path& path, std::size_t first, std::size_t number) const
  {
    return layout().is_float32 ? numbers<float, std::uint32_t>(path, first, number)
                               : numbers<double, std::uint64_t>(path, first, number);
  }

  // Reads so many numbers from the element `first` on. `Unsigned` has the size of `Number`, and is what the file reader
  // returns: it knows the order of bytes, not what they mean.
  template <typename Number, typename Unsigned>
  static std::vector<double> numbers(const std::filesystem::path& path, std::size_t first, std::size_t number)
  {
    std::vector<double> result;
    for(const Unsigned bits : read_npy_elements<Unsigned>(path, first, number))
    {
      Number x = 0;
      std::memcpy(&x, &bits, sizeof x);
      result.push_back(static_cast<double>(x));
    }
    return result;
  }

  // It reads the manifest again when that changes, which users need not see.
  mutable Store_folder m_folder;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORED_MATRIX_H
