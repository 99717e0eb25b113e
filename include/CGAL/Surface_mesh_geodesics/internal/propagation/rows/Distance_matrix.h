// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_DISTANCE_MATRIX_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_DISTANCE_MATRIX_H

// Distances from many sources, one by one: a run of the propagation for each row, all on one intrinsic mesh. Threads
// compute rows at the same time; Ordered_rows.h passes them on in order.
//
// A run takes time for the area that it reaches, not for the mesh: the worker of a thread keeps its tables from row to
// row (Repeated_propagation.h). Rows have the same bits for any number of threads, as each of them is a
// sequential run.

#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Repeated_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/rows/Landmark_distances.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/rows/Ordered_rows.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/rows/Target_region.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/walls/Vertex_copies.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The data of one thread. A source in a face changes the mesh during a run; if there are such sources, the thread works
// on a copy of the mesh. Otherwise all threads read one mesh, which must outlive the worker.
template <typename FT>
class Matrix_worker
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Runner = Repeated_propagation<Distance_propagation<FT, All_pruning_rules>>;

  // The insertion refers to the copy, and the runner to both: members are made in this order, and destroyed in reverse.
  Matrix_worker(const Mesh& mesh, bool needs_copy)
  {
    if(needs_copy)
    {
      m_mesh = std::make_unique<Mesh>(mesh);
      m_insertion = std::make_unique<Source_insertion<FT>>(*m_mesh);
      m_runner = std::make_unique<Runner>(*m_mesh, *m_insertion);
    }
    else
      m_runner = std::make_unique<Runner>(mesh);
  }

  // Sets the source of the next run: it is `location` unless that is null, else `vertex`.
  // Requires: `location` is null unless the worker has a copy of the mesh.
  void set_source(Vertex_id vertex, const Located_source<FT>* location)
  {
    m_source.vertices.clear();
    m_source.located.clear();
    add_source(vertex, location);
  }

  // Adds another place of the source, behind a wall. Requires what set_source() does, which comes first.
  void add_source(Vertex_id vertex, const Located_source<FT>* location)
  {
    if(location != nullptr)
      m_source.located.push_back(
        Located_source<FT>{location->face, location->coordinates, m_source.vertices.size()});
    m_source.vertices.push_back(vertex);
  }

  // Runs from the source that is set, and returns the result, which is valid until the next run. If go_further()
  // returns false meanwhile, the run ends early and no distances are known; the row is not output then.
  template <typename GoFurther>
  const Runner& run(const Run_limits<FT>& limits, const GoFurther& go_further)
  {
    m_runner->run(m_source, limits, [&](std::size_t, const FT&) { return go_further(); });
    return *m_runner;
  }

  // A buffer for the targets of a run, with all of their copies.
  std::vector<Vertex_id>& targets() { return m_targets; }

  // Runs from source i to the sources behind it, and prunes what leads away from them. `sources` are those of the
  // landmarks, which outlive the worker. The distances of these targets are final, of those in the same component.
  template <typename GoFurther>
  const Runner& run_to_sources_behind(const std::vector<Vertex_id>& sources, std::size_t i,
                                      const Landmark_distances<FT>& landmarks, const Run_limits<FT>& limits,
                                      const GoFurther& go_further)
  {
    if(m_region == nullptr)
      m_region = std::make_unique<Target_region<FT>>(landmarks);
    m_region->begin(sources, i);
    set_source(sources[i], nullptr);
    m_runner->run(m_source, limits, [&](std::size_t, const FT&) { return go_further(); },
                  [this](Vertex_id v, const FT& key, const std::vector<FT>& distance)
                  { return m_region->is_needed(v, key, distance); });
    return *m_runner;
  }

private:
  std::unique_ptr<Mesh> m_mesh;
  std::unique_ptr<Source_insertion<FT>> m_insertion;
  std::unique_ptr<Runner> m_runner;
  std::unique_ptr<Target_region<FT>> m_region; // null before it is needed
  Source_set<FT> m_source; // one source without an offset, on all sides of walls; a buffer between runs
  std::vector<Vertex_id> m_targets;
};

// True for a function object of the user that can end rows that have begun.
template <typename Output, typename = void>
struct Ends_rows
  : std::false_type
{};

template <typename Output>
struct Ends_rows<Output, std::void_t<decltype(std::declval<Output&>().go_further())>>
  : std::true_type
{};

// Asks the function object of the user whether to go on with rows that have begun. Several threads may call it.
template <typename Output>
bool wants_more(Output& output)
{
  if constexpr(Ends_rows<Output>::value)
    return static_cast<bool>(output.go_further());
  else
  {
    static_cast<void>(output);
    return true;
  }
}

// Passes a row to the function of the user; returns whether to go on. A function that returns void never stops; the
// result of any other is converted to bool. A row that has ended early is not passed on: go_further() returns false
// again.
template <typename Output, typename Row>
bool put_row(Output& output, std::size_t i, const Row& row)
{
  constexpr bool is_row_output = std::is_invocable<Output&, std::size_t&, const Row&>::value;
  static_assert(is_row_output, "a row is passed to a function of the position of its source and of its distances");
  if(!wants_more(output))
    return false;
  if constexpr(!is_row_output)
    return false;
  else if constexpr(std::is_void<decltype(output(i, row))>::value)
  {
    output(i, row);
    return true;
  }
  else
    return static_cast<bool>(output(i, row));
}

// Sources and targets are numbered by their positions in the ranges of the user. Distances are those of the user's
// unit, infinity for targets in components without the source.
//
// Walls divide vertices into copies: a source has a place on each side, its row has the distances from the nearest one,
// and the distance of a target is the least of its copies. That is no metric (Vertex_copies.h), so no landmarks are
// used then.
//
// The functions are const and share no state, except what `output` does. A row exists for a short time only: `output`
// has to copy what it wants to keep.
template <typename FT>
class Distance_matrix
{
public:
  using Mesh = Intrinsic_mesh<FT>;
  using Worker = Matrix_worker<FT>;
  using Runner = typename Worker::Runner;
  using Landmarks = Landmark_distances<FT>;
  using Dense_row = std::vector<double>;
  using Sparse_row = std::vector<std::pair<std::size_t, double>>; // positions of targets, and their distances

  // Mesh and copies are referred to. Offsets of the sources are ignored. Requires: a source that is not a vertex is
  // located.
  Distance_matrix(const Mesh& mesh, Source_set<FT> sources, const Vertex_copies& copies)
    : m_mesh(mesh), m_copies(copies), m_sources(std::move(sources)), m_location(m_sources.vertices.size(), nullptr)
  {
    for(const Located_source<FT>& s : m_sources.located)
      m_location[s.position] = &s;
    for(std::size_t j = number_of_rows(); j < m_sources.size(); ++j)
      m_behind_walls.emplace_back(m_sources.number(j), j);
    std::sort(m_behind_walls.begin(), m_behind_walls.end());
  }

  // A row for each source of the user.
  std::size_t number_of_rows() const { return m_sources.number_of_sources(); }

  Distance_matrix(const Distance_matrix&) = delete;
  Distance_matrix& operator=(const Distance_matrix&) = delete;

  // The positions of each vertex in a range of targets, which may contain it several times: a list for each vertex,
  // linked by position. All threads read one object, which is made once for a matrix, in time linear in the numbers of
  // targets and of vertices.
  class Target_positions
  {
  public:
    Target_positions(const std::vector<Vertex_id>& targets, std::size_t number_of_vertices,
                     const Vertex_copies& copies)
      : m_first(number_of_vertices, none), m_next(targets.size())
    {
      m_targets.reserve(targets.size());
      for(std::size_t j = 0; j < targets.size(); ++j)
      {
        m_next[j] = m_first[targets[j]];
        m_first[targets[j]] = j;
        copies.for_each(targets[j], [this](Vertex_id c) { m_targets.push_back(c); });
      }
    }

    // All copies of the targets.
    const std::vector<Vertex_id>& targets() const { return m_targets; }

    // Calls visit(position) for all positions of v. An inserted source has none.
    template <typename Visit>
    void for_each(Vertex_id v, Visit visit) const
    {
      if(v < m_first.size())
        for(std::size_t j = m_first[v]; j != none; j = m_next[j])
          visit(j);
    }

  private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<Vertex_id> m_targets;
    std::vector<std::size_t> m_first, m_next;
  };

  // The functions below pass the rows to output(i, row), in the order of the sources, and return false if `output` ends
  // the computation. `tag` is Sequential_tag, or a tag or a team of threads that Ordered_rows.h knows. An exception of
  // `output` ends all threads and is thrown on.

  // Row i has the distances of all targets from source i, in the order of the targets. Each run ends when all of them
  // are known.
  template <typename Tag, typename Output>
  bool put_dense_rows(Tag tag, const std::vector<Vertex_id>& targets, Output& output) const
  {
    return put_rows<Dense_row>(tag, output, [&](Worker& worker, std::size_t i, Dense_row& row, const auto& go_further)
    {
      fill_dense_row(worker, i, targets.data(), targets.data() + targets.size(), row, go_further);
    });
  }

  // Row i has the distances of the sources i, i+1, ... from source i: the rest is symmetric. Requires: all sources are
  // vertices.
  template <typename Tag, typename Output>
  bool put_triangular_rows(Tag tag, Output& output,
                           std::size_t least_sources_for_landmarks = default_least_sources_for_landmarks) const
  {
    std::unique_ptr<const Landmarks> landmarks;
    if(!find_landmarks(landmarks, [&]() { return wants_more(output); }, least_sources_for_landmarks))
      return false;
    return put_rows<Dense_row>(tag, output, [&](Worker& worker, std::size_t i, Dense_row& row, const auto& go_further)
    {
      fill_triangular_row(worker, i, i, landmarks.get(), row, go_further);
    });
  }

  // Row i has the targets whose distance from source i is at most the maximum (in the user's unit), in the order of
  // their positions. A run ends at the maximum, or when all targets are final if that is earlier. A row takes time for
  // the vertices that the run reaches, not for all targets.
  // Requires: maximum_distance >= 0; the targets are vertices of the mesh.
  template <typename Tag, typename Output>
  bool put_sparse_rows(Tag tag, const std::vector<Vertex_id>& targets, double maximum_distance,
                       Output& output) const
  {
    const Target_positions positions(targets, m_mesh.number_of_vertices(), m_copies);
    return put_rows<Sparse_row>(tag, output, [&](Worker& worker, std::size_t i, Sparse_row& row, const auto& go_further)
    {
      fill_sparse_row(worker, i, positions, maximum_distance, row, go_further);
    });
  }

  // --- single rows, in any order, for a caller that has threads of its own; each thread needs a worker of its own.
  // go_further() is asked meanwhile; if it returns false, the row is not complete. ---

  const Source_set<FT>& sources() const { return m_sources; }
  const Vertex_copies& copies() const { return m_copies; }

  // Only located sources change the mesh, so without them no worker needs a copy.
  std::unique_ptr<Worker> make_worker() const
  {
    return std::make_unique<Worker>(m_mesh, !m_sources.located.empty());
  }

  // Fills a row with the distances of [first, last) from source i. The range must not change during the run. (Without
  // targets nothing is run: a run without targets would have no limit.)
  template <typename GoFurther>
  void fill_dense_row(Worker& worker, std::size_t i, const Vertex_id* first, const Vertex_id* last, Dense_row& row,
                      const GoFurther& go_further) const
  {
    row.clear();
    if(first == last)
      return;
    const Runner& runner = run(worker, i, limits_at_copies(worker, first, last), go_further);
    for(; first != last; ++first)
      row.push_back(distance(runner, *first));
  }

  // Makes landmarks for triangular rows, if there are enough sources to repay them: they cost some rows. Between walls
  // there are none. Returns false if go_further() does.
  template <typename GoFurther>
  bool find_landmarks(std::unique_ptr<const Landmarks>& landmarks, const GoFurther& go_further,
                      std::size_t least_sources = default_least_sources_for_landmarks) const
  {
    if(number_of_rows() < least_sources || !m_copies.empty())
      return true;
    auto found = std::make_unique<Landmarks>();
    if(!found->compute(m_mesh, m_sources.vertices, go_further))
      return false;
    landmarks = std::move(found);
    return true;
  }

  // Fills a row with the distances of the sources `first`, first + 1, ... from source i <= first. The landmarks, or
  // null, come from find_landmarks(). Requires: all sources are vertices.
  template <typename GoFurther>
  void fill_triangular_row(Worker& worker, std::size_t i, std::size_t first, const Landmarks* landmarks, Dense_row& row,
                           const GoFurther& go_further) const
  {
    const std::vector<Vertex_id>& v = m_sources.vertices;
    const Vertex_id *const begin = v.data() + first, *const end = v.data() + number_of_rows();
    if(landmarks == nullptr || begin == end || !fill_pruned_row(worker, i, begin, end, *landmarks, row, go_further))
      fill_dense_row(worker, i, begin, end, row, go_further);
  }

  // Fills a row with the targets within the maximum distance, as put_sparse_rows() says.
  template <typename GoFurther>
  void fill_sparse_row(Worker& worker, std::size_t i, const Target_positions& positions, double maximum_distance,
                       Sparse_row& row, const GoFurther& go_further) const
  {
    row.clear();
    const std::vector<Vertex_id>& targets = positions.targets();
    if(targets.empty())
      return;
    Run_limits<FT> limits;
    limits.maximum_distance = FT(maximum_distance) / m_mesh.unit();
    limits.first_target = targets.data();
    limits.last_target = targets.data() + targets.size();
    const Runner& runner = run(worker, i, limits, go_further);
    for(const Vertex_id v : runner.vertices_reached())
      if(runner.distance(v) <= limits.maximum_distance)
        m_copies.for_each(v, [&](Vertex_id c)
        { positions.for_each(c, [&](std::size_t j) { row.emplace_back(j, distance(runner, v)); }); });
    std::sort(row.begin(), row.end());
    if(!m_copies.empty()) // a target comes once for each copy that has been reached
      row.erase(std::unique(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
                row.end());
  }

private:
  // Runs from source i, on all sides of walls.
  template <typename GoFurther>
  const Runner& run(Worker& worker, std::size_t i, const Run_limits<FT>& limits, const GoFurther& go_further) const
  {
    worker.set_source(m_sources.vertices[i], m_location[i]);
    auto it = std::lower_bound(m_behind_walls.begin(), m_behind_walls.end(), std::make_pair(i, std::size_t(0)));
    for(; it != m_behind_walls.end() && it->first == i; ++it)
      worker.add_source(m_sources.vertices[it->second], m_location[it->second]);
    return worker.run(limits, go_further);
  }

  // A run to the targets first .. last - 1. Any copy of a target may be the nearest one, so all have to be final; the
  // worker keeps their list during the run.
  Run_limits<FT> limits_at_copies(Worker& worker, const Vertex_id* first, const Vertex_id* last) const
  {
    Run_limits<FT> limits;
    limits.first_target = first;
    limits.last_target = last;
    if(m_copies.empty())
      return limits;
    worker.targets().clear();
    for(; first != last; ++first)
      m_copies.for_each(*first, [&](Vertex_id c) { worker.targets().push_back(c); });
    limits.first_target = worker.targets().data();
    limits.last_target = limits.first_target + worker.targets().size();
    return limits;
  }

  // 32 times the runs of the landmarks.
  static constexpr std::size_t default_least_sources_for_landmarks = 512;

  // Fills a row of a triangle by a run that leaves out what the landmarks prove to be useless. Returns false if
  // rounding has left a target without a distance, as it may in faces thinner than rounding: a run without pruning goes
  // on beside it. (A row that has been ended early is no row either way.)
  template <typename GoFurther>
  bool fill_pruned_row(Worker& worker, std::size_t i, const Vertex_id* first, const Vertex_id* last,
                       const Landmarks& landmarks, Dense_row& row, const GoFurther& go_further) const
  {
    Run_limits<FT> limits;
    limits.first_target = first;
    limits.last_target = last;
    const Runner& runner = worker.run_to_sources_behind(m_sources.vertices, i, landmarks, limits, go_further);
    const std::size_t first_position = static_cast<std::size_t>(first - m_sources.vertices.data());
    const std::vector<std::size_t>& connected = landmarks.component_of(i);
    auto left = std::count_if(connected.begin(), connected.end(), [&](std::size_t k) { return k >= first_position; });
    row.clear();
    for(; first != last; ++first)
    {
      row.push_back(distance(runner, *first));
      if(row.back() < std::numeric_limits<double>::infinity())
        --left;
    }
    return left == 0;
  }

  // Returns the distance of a vertex in the user's unit, the least one of its copies.
  double distance(const Runner& runner, Vertex_id v) const
  {
    const auto distance_of = [&runner](Vertex_id c) { return runner.distance(c); };
    return static_cast<double>(FT(distance_of(m_copies.nearest(v, distance_of)) * m_mesh.unit()));
  }

  // Calls compute(worker, i, row, go_further) for each row, in the threads of `tag`, and passes the rows on in order.
  // (The flag of Ordered_rows guards no other memory, so its order relative to other reads does not matter.)
  template <typename Row, typename Tag, typename Output, typename Compute>
  bool put_rows(Tag tag, Output& output, Compute compute) const
  {
    return for_each_ordered_row<Row>(
      tag, number_of_rows(), [this]() { return make_worker(); },
      [&](Worker& worker, std::size_t i, Row& row, const Stop_flag& stop)
      { compute(worker, i, row, [&]() { return !stop.load(std::memory_order_relaxed) && wants_more(output); }); },
      [&](std::size_t i, const Row& row) { return put_row(output, i, row); });
  }

  const Mesh& m_mesh;
  const Vertex_copies& m_copies;
  Source_set<FT> m_sources;
  std::vector<const Located_source<FT>*> m_location; // by position, in m_sources; null for a vertex
  // Sources at walls: the number of each, with a position behind all sources where it is listed once more. Sorted.
  std::vector<std::pair<std::size_t, std::size_t>> m_behind_walls;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_ROWS_DISTANCE_MATRIX_H
