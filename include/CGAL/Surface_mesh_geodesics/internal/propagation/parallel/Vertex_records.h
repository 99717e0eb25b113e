// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_VERTEX_RECORDS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_VERTEX_RECORDS_H

// What the parallel propagation knows of each vertex, beside what every propagation knows: its part of the wavefront,
// its place in the queue of that part, the last batch to which it belonged, and the best improvement in the messages.
//
// A visit asks for one of these after the other, about the same few vertices. On large meshes each first question waits
// for the memory. So all answers are in one record, and a record does not lie on two cache lines.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>

#include <CGAL/assertions.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

// Visual C++ warns of structs that are padded. They are, on purpose: see above.
#ifdef _MSC_VER
#pragma warning(push)
#pragma warning(disable : 4324)
#endif

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT>
struct Vertex_improvement; // Wavefront_part.h

// The batch to which a vertex belonged last, and its key there, rounded. Rounding makes ties but no other order, and
// neighbors see the same marks: of two neighbors in a batch, both agree which one is nearer. Round 0 is none.
struct Batch_mark
{
  std::uint32_t round = 0;
  float key = 0;
};

template <typename FT>
struct alignas(32) Vertex_record
{
  Vertex_record() = default;

  // A std::vector asks for it. No record is copied, as the table is made in its full size.
  Vertex_record(const Vertex_record& other)
    : best(other.best), mark(other.mark), position(other.position), part_in_run(other.part_in_run.load())
  {}

  const Vertex_improvement<FT>* best = nullptr; // null between updates
  Batch_mark mark;
  std::uint32_t position = null_id;             // in the queue of its part
  std::atomic<std::uint32_t> part_in_run{0};    // the number of the run (24 bits) and the part (8 bits)
};

// A vertex belongs to no part until the wavefront comes near; then it belongs to the part that asks for it first. So
// each part has a region of the surface, which grows with the wavefront. Parts of earlier runs are void, so that
// restart() need not clear them.
//
// Threads: any number may call part_of() at the same time. `best` and `position` are for the part of the vertex, which
// one thread updates at a time, and so is `mark`, which all threads read between updates. The other functions are for
// the conductor alone.
template <typename FT>
class Vertex_records
{
public:
  using Record = Vertex_record<FT>;

  static constexpr std::size_t maximum_number_of_parts = 64;

  // Takes all vertices from their parts. Constant, but linear in the number of vertices if there are more of them than
  // ever before, and every 16 million runs. Requires: no vertex is in a queue, and no record has a best improvement.
  void restart(std::size_t number_of_vertices)
  {
    if(number_of_vertices > size() || m_run == last_run)
    {
      m_records = std::vector<Record>();
      reserve_large(m_records, number_of_vertices);
      m_records.resize(number_of_vertices);
      m_run = 0;
    }
    ++m_run;
  }

  std::size_t size() const { return m_records.size(); }
  Record& operator[](Vertex_id v) { return m_records[v]; }
  const Record& operator[](Vertex_id v) const { return m_records[v]; }

  // The part of a vertex; if it belongs to none, it belongs to the given part from now on. The order of memory does not
  // matter: the entry is all that threads tell each other here.
  std::size_t part_of(Vertex_id v, std::size_t part)
  {
    std::atomic<std::uint32_t>& part_in_run = m_records[v].part_in_run;
    std::uint32_t entry = part_in_run.load(std::memory_order_relaxed);
    if(entry >> part_bits == m_run)
      return entry & part_mask;
    if(part_in_run.compare_exchange_strong(entry, entry_of(part), std::memory_order_relaxed))
      return part;
    return entry & part_mask; // another thread was faster
  }

  // Gives a vertex to a part.
  void set_part(Vertex_id v, std::size_t part)
  {
    m_records[v].part_in_run.store(entry_of(part), std::memory_order_relaxed);
  }

  // Forgets the best improvements, or the batches, of all vertices.
  void clear_best()
  {
    for(Record& record : m_records)
      record.best = nullptr;
  }
  void clear_marks()
  {
    for(Record& record : m_records)
      record.mark = Batch_mark();
  }

  std::size_t memory() const { return m_records.capacity() * sizeof(Record); }

private:
  static constexpr unsigned int part_bits = 8;
  static constexpr std::uint32_t part_mask = 0xff;
  static constexpr std::uint32_t last_run = 0xffffff;

  std::uint32_t entry_of(std::size_t part) const
  {
    return (m_run << part_bits) | static_cast<std::uint32_t>(part);
  }

  std::vector<Record> m_records; // by vertex
  std::uint32_t m_run = 0; // 0 before the first restart()
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#ifdef _MSC_VER
#pragma warning(pop)
#endif

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_VERTEX_RECORDS_H
