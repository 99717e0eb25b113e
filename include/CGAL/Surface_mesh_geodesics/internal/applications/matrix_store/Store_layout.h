// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_LAYOUT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_LAYOUT_H

// What a store holds, independent of where it is: which rows are in which shard, and which arrays a shard consists of.
//
// A shard is a block of consecutive rows. Names of files have the first row and the row behind the last one, with
// leading zeros, so they sort in the order of rows:
//
//   full           rows_A_B.npy          two extents: rows and columns
//   upper triangle rows_A_B.npy          one extent: the rows behind each other; row i has the columns i+1, i+2, ...
//   within radius  rows_A_B.indptr.npy   where each row begins in the two other arrays, and where the last one ends
//                  rows_A_B.indices.npy  the columns of the entries, ascending in each row
//                  rows_A_B.data.npy     their distances

#include <CGAL/Surface_mesh_geodesics/Geodesic_matrix_store_error.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/files/Json_value.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

enum class Store_kind { FULL, UPPER_TRIANGLE, WITHIN_RADIUS };

// A file of a shard: the end of its name, the type of its elements, and its size, which follows from the rows unless
// the matrix is sparse.
struct Shard_array
{
  std::string ending, element;
};

// Everything follows from a few numbers, which the manifest has: no list of rows is stored, and the place of an entry
// in its file is computed. Functions take constant time. Requires, for all of them: `shard` is less than the number of
// shards, and `row` is in the shard.
struct Store_layout
{
  Store_kind kind = Store_kind::FULL;
  bool is_float32 = false;
  std::size_t rows = 0, columns = 0;
  std::size_t rows_per_shard = 1;
  double radius = 0; // of a sparse matrix

  // --- shards ---

  // The last shard may have fewer rows than the others. A matrix without rows has no shards.
  std::size_t number_of_shards() const { return rows == 0 ? 0 : (rows - 1) / rows_per_shard + 1; }
  std::size_t first_row(std::size_t shard) const { return shard * rows_per_shard; }
  std::size_t end_row(std::size_t shard) const { return (std::min)(rows, first_row(shard) + rows_per_shard); }
  std::size_t rows_of(std::size_t shard) const { return end_row(shard) - first_row(shard); }

  // A name begins with a letter, so that no tool takes it for an option or a number.
  // "rows_A_B".
  std::string name(std::size_t shard) const
  {
    return "rows_" + digits(first_row(shard)) + '_' + digits(end_row(shard));
  }

  // Is it such a name, of any layout?
  static bool is_name(const std::string& text)
  {
    return text.compare(0, 5, "rows_") == 0 && text.find_first_not_of("0123456789_", 5) == std::string::npos;
  }

  // --- elements ---

  // As in the names "<f4" and "<f8" of NumPy.
  std::size_t bytes_per_distance() const { return is_float32 ? 4 : 8; }

  // The number of entries of a row; for a sparse matrix, the largest possible.
  // The columns of a row are the last ones of the matrix, so many as this number.
  std::size_t length_of_row(std::size_t row) const
  {
    return kind == Store_kind::UPPER_TRIANGLE ? columns - row - 1 : columns;
  }

  // The number of entries of the rows of a shard that come before `row`. Requires: the matrix is not sparse.
  // Of an upper triangle, rows become shorter by one entry from row to row; the sum of their lengths is that of a
  // trapezoid.
  std::size_t entries_before(std::size_t shard, std::size_t row) const
  {
    CGAL_assertion(kind != Store_kind::WITHIN_RADIUS);
    const std::size_t first = first_row(shard), number = row - first;
    if(kind == Store_kind::FULL)
      return number * columns;
    return number * (columns - 1) - (number * (first + row - 1)) / 2; // row i has columns - 1 - i entries
  }

  // The arrays of a shard, in the order in which they get their names, the largest last.
  std::vector<Shard_array> arrays() const
  {
    const std::string distance = is_float32 ? "<f4" : "<f8";
    if(kind != Store_kind::WITHIN_RADIUS)
      return {{".npy", distance}};
    return {{".indptr.npy", "<i4"}, {".indices.npy", "<i4"}, {".data.npy", distance}};
  }

  // The extents of an array with a number of elements.
  std::vector<std::size_t> extents(std::size_t shard, std::size_t elements) const
  {
    if(kind == Store_kind::FULL)
      return {rows_of(shard), columns};
    return {elements};
  }

  // May the arrays of a shard have these numbers of elements? Of a dense matrix, the layout tells it.
  bool may_have(std::size_t shard, const std::vector<std::size_t>& elements) const
  {
    if(kind != Store_kind::WITHIN_RADIUS)
      return elements.size() == 1 && elements[0] == entries_before(shard, end_row(shard));
    return elements.size() == 3 && elements[0] == rows_of(shard) + 1 && elements[1] == elements[2];
  }

  // --- in a manifest ---

  // Everything but the sources and targets; Store_description::hash() covers it.
  Json_value to_json() const
  {
    Json_value value;
    value.add("kind", name_of_kind(kind));
    value.add("element", is_float32 ? "float32" : "float64");
    value.add("rows", rows);
    value.add("columns", columns);
    if(kind == Store_kind::WITHIN_RADIUS)
      value.add("radius", radius);
    value.add("rows_per_shard", rows_per_shard);
    return value;
  }

  // Throws a Geodesic_matrix_store_error unless the description is one that to_json() may have written.
  static Store_layout from_json(const Json_value& value)
  {
    Store_layout layout;
    const std::string& kind = value.at("kind").text();
    const std::string& element = value.at("element").text();
    for(const Store_kind k : {Store_kind::FULL, Store_kind::UPPER_TRIANGLE, Store_kind::WITHIN_RADIUS})
      if(kind == name_of_kind(k))
        layout.kind = k;
    layout.is_float32 = element == "float32";
    layout.rows = value.at("rows").count();
    layout.columns = value.at("columns").count();
    layout.rows_per_shard = value.at("rows_per_shard").count();
    if(layout.kind == Store_kind::WITHIN_RADIUS)
      layout.radius = value.at("radius").number();
    if(kind != name_of_kind(layout.kind) || (!layout.is_float32 && element != "float64") || layout.rows_per_shard == 0
       || (layout.kind == Store_kind::UPPER_TRIANGLE && layout.rows != layout.columns))
      Json_value::complain("the description of the matrix is not valid");
    return layout;
  }

  // The size of shards if the user does not choose it: about 16 MB, at most 1024 rows, and small enough for 64 shards
  // of 16 rows or more, so that many processes find work. No more than 10,000 shards, as the manifest lists them.
  // A shard that is lost costs its rows once more, and each shard costs some syncs: seconds of work are a good size.
  std::size_t default_rows_per_shard() const
  {
    const std::size_t by_size = (std::size_t(1) << 24) / (std::max)(std::size_t(1), columns * bytes_per_distance());
    // few rows have few shards; many rows have many, up to those of the size
    const std::size_t by_number = (std::max)(std::size_t(16), (rows + 63) / 64);
    return (std::max)((std::min)({by_size, by_number, std::size_t(1024)}), rows / 10000 + 1);
  }

  // The indices of SciPy's sparse matrices have 32 bits here, so a shard has fewer than 2^31 entries.
  std::size_t largest_rows_per_shard() const
  {
    if(kind != Store_kind::WITHIN_RADIUS)
      return (std::max)(std::size_t(1), rows);
    return (std::max)(std::size_t(1), ((std::size_t(1) << 31) - 1) / (std::max)(std::size_t(1), columns));
  }

private:
  // The words of manifests; other programs may read them.
  static const char* name_of_kind(Store_kind kind)
  {
    return kind == Store_kind::FULL ? "full" : kind == Store_kind::UPPER_TRIANGLE ? "upper_triangle" : "within_radius";
  }

  // A row in as many digits as the last one has, at least 6: all names of a folder have the same length.
  std::string digits(std::size_t row) const
  {
    const std::string text = std::to_string(row);
    const std::size_t width = (std::max)(std::size_t(6), std::to_string(rows).size());
    return std::string(width - text.size(), '0') + text;
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_MATRIX_STORE_STORE_LAYOUT_H
