// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_SHARD_WRITER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_SHARD_WRITER_H

// Writes the arrays of one shard, row by row, with few rows in memory.
//
// All arrays grow at the same time, each under a temporary name. They get their names one after the other at the end;
// if the process dies between two of them, there is no record of the shard, and it is computed again.

#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/matrix_store/Store_folder.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Checksum.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Npy_file.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The rows of a shard are put in their order. Without finish(), no file of the shard is left. For one thread. Functions
// throw a Geodesic_matrix_store_error if a file cannot be written; the object is of no use then.
class Shard_writer
{
public:
  // `memory` is the number of bytes for entries that are not written yet.
  Shard_writer(Store_folder& folder, std::size_t shard, std::size_t memory) : m_folder(folder), m_shard(shard)
  {
    const std::vector<Shard_array> arrays = folder.layout().arrays();
    for(const Shard_array& array : arrays)
      m_writers.push_back(
        std::make_unique<Npy_writer>(folder.file(shard, array.ending), array.element, memory / arrays.size()));
    if(is_sparse())
      // the first row begins at the first entry
      m_writers[0]->put(std::uint32_t(0));
  }

  Shard_writer(const Shard_writer&) = delete;
  Shard_writer& operator=(const Shard_writer&) = delete;

  // A row of a dense matrix: all its columns, or those behind the diagonal.
  void put_row(const std::vector<double>& row)
  {
    for(const double distance : row)
      put_distance(*m_writers[0], distance);
  }

  // A row of a sparse matrix. Requires: positions ascend. A shard has fewer than 2^31 entries
  // (Store_layout::largest_rows_per_shard()), so the numbers fit.
  void put_row(const std::vector<std::pair<std::size_t, double>>& row)
  {
    for(const std::pair<std::size_t, double>& entry : row)
    {
      m_writers[1]->put(static_cast<std::uint32_t>(entry.first));
      put_distance(*m_writers[2], entry.second);
    }
    m_writers[0]->put(static_cast<std::uint32_t>(m_writers[1]->number_of_elements()));
  }

  // Gives the files their names when all are on the disk, and returns the entry of the shard, which the caller adds to
  // the folder.
  Shard_entry finish()
  {
    Shard_entry entry;
    // All files are complete and synced before the first one gets its name.
    for(const auto& writer : m_writers)
    {
      writer->finish(m_folder.layout().extents(m_shard, writer->number_of_elements()));
      entry.arrays.emplace_back(writer->number_of_elements(), writer->checksum());
    }
    for(const auto& writer : m_writers)
      writer->rename();
    sync_folder(m_folder.path());
    return entry;
  }

private:
  // Then the arrays are: where rows begin, columns, distances.
  bool is_sparse() const { return m_folder.layout().kind == Store_kind::WITHIN_RADIUS; }

  // In single precision, a distance is rounded to the nearest number, to the even one in a tie. (The rounding mode of
  // the processor is that of CGAL, to nearest, outside of interval arithmetic.)
  void put_distance(Npy_writer& writer, double distance) const
  {
    if(!m_folder.layout().is_float32)
    {
      writer.put(bits_of(distance));
      return;
    }
    // Distances that are not reached are infinite in both types. A distance that would become zero is nothing any more.
    const float rounded = static_cast<float>(distance);
    const bool is_too_large = std::isinf(rounded) && !std::isinf(distance);
    if(is_too_large || (rounded == 0 && distance > 0))
      throw Geodesic_matrix_store_error(Geodesic_matrix_store_error::Reason::NOT_REPRESENTABLE,
                                        std::string("a distance is too ") + (is_too_large ? "large" : "small")
                                          + " for a number of 32 bits: store 64 bits, or scale the mesh");
    writer.put(bits_of(rounded));
  }

  // The folder tells the names, the types and the extents of the files.
  Store_folder& m_folder;
  std::size_t m_shard;
  // In the order of Store_layout::arrays().
  std::vector<std::unique_ptr<Npy_writer>> m_writers;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_SHARD_WRITER_H
