// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PROPAGATION_BY_SIZE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PROPAGATION_BY_SIZE_H

// The propagation of the parallel tag: several threads on a mesh that is large enough, else one thread, which computes
// as with the sequential tag. On a small mesh a visit has few windows, so that the marks of a batch and the messages
// between visits cost more.
//
// The choice depends on the number of faces only. So the bits of the result do not depend on the number of threads.

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Parallel_distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Has the members of both propagations that Repeated_propagation uses; they do what they do there.
//
// Invariant: one of the two propagations exists, the one for the size that the mesh had at the last restart().
template <typename FT_, typename Rules_, typename Team>
class Propagation_by_size
{
public:
  using FT = FT_;
  using Rules = Rules_;
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

  // Meshes with fewer faces are small. On larger ones, visits have more windows (benchmark_threads measures both).
  static constexpr std::size_t smallest_shared_mesh = 16384;

  Propagation_by_size(const Mesh& mesh, Field& field) : m_mesh(mesh), m_field(field) { restart(); }

  // The mesh may have changed, and be no longer as small, or as large, as before.
  void restart()
  {
    if(m_mesh.number_of_faces() < smallest_shared_mesh)
      restart(m_alone, m_shared);
    else
      restart(m_shared, m_alone);
  }

  void add_source(Vertex_id v, const FT& offset)
  {
    visit([&](auto& propagation) { propagation.add_source(v, offset); });
  }

  void set_maximum_distance(const FT& d)
  {
    visit([&](auto& propagation) { propagation.set_maximum_distance(d); });
  }

  void set_targets(const Vertex_id* first, const Vertex_id* last)
  {
    visit([&](auto& propagation) { propagation.set_targets(first, last); });
  }

  template <typename GoOn>
  bool run(GoOn go_on)
  {
    return visit([&](auto& propagation) { return propagation.run(go_on); });
  }

  const FT& reached_distance() const
  {
    return m_shared ? m_shared->reached_distance() : m_alone->reached_distance();
  }

  Propagation_statistics statistics() const
  {
    return m_shared ? m_shared->statistics() : m_alone->statistics();
  }

private:
  using Alone = Distance_propagation<FT, Rules>;
  using Shared = Parallel_distance_propagation<FT, Rules, Team>;

  // Restarts one propagation, or makes it in place of the other one. If that throws, the other one is still there, and
  // has forgotten its last run: the new one resets the field, which tells the other one what to forget.
  template <typename Wanted, typename Other>
  void restart(std::unique_ptr<Wanted>& wanted, std::unique_ptr<Other>& other)
  {
    if(wanted)
      return wanted->restart();
    if(other)
      other->restart();
    wanted.reset(new Wanted(m_mesh, m_field));
    other.reset();
  }

  template <typename Use>
  auto visit(Use use)
  {
    return m_shared ? use(*m_shared) : use(*m_alone);
  }

  const Mesh& m_mesh;
  Field& m_field;
  std::unique_ptr<Alone> m_alone;
  std::unique_ptr<Shared> m_shared;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_PARALLEL_PROPAGATION_BY_SIZE_H
