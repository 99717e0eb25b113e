// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_DIAGRAM_WINDOW_KEEPER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_DIAGRAM_WINDOW_KEEPER_H

// What a propagation calls a keeper, for a diagram: it passes lists of windows and the distance reached on to the
// removal of redundant windows (Deferred_window_keeper.h). If several threads propagate, the edges and faces that the
// removal has found wait for the next batch of visits, in which all threads divide them (Work_in_batches.h).

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Divided_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Face_partition.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Redundant_window_removal.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/Deferred_window_keeper.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/Work_in_batches.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Threads log windows, and one at a time gives them to the removal.
template <typename Removal>
using Diagram_window_keeper = Deferred_window_keeper<Removal>;

// The consumer of a removal whose faces several threads divide (Work_in_batches.h). They join the complex in the order
// in which they were handed over, so the complex does not depend on the threads.
//
// Threads: the units of a batch may be done in several threads at once, each thread with its own number, and beside
// add(), which one thread at a time calls. Nothing else runs beside the other functions.
template <typename FT>
class Deferred_division
{
public:
  // Refers to the complex, which has been started.
  explicit Deferred_division(Voronoi_complex<FT>& complex) : m_complex(&complex) {}

  // Forgets all faces, for a run with this number of threads.
  void restart(std::size_t number_of_threads)
  {
    m_faces.clear();
    m_partition.resize(number_of_threads);
  }

  // Takes a face over from the removal. It is copied.
  void add(const Divided_face<FT>& divided) { m_faces.add().divided = divided; }

  // Begins a batch. Returns the number of its units. Requires: the units of the batch before are done.
  std::size_t begin_batch()
  {
    const std::size_t n = m_faces.begin_batch();
    m_joins = m_faces.has_done() ? 1 : 0;
    return m_joins + n;
  }

  // Does a unit: lets the faces that were divided in the batch before join the complex, or divides some faces.
  void do_unit(std::size_t unit, std::size_t thread)
  {
    if(unit < m_joins)
      m_faces.take_back(joining());
    else
      m_faces.do_unit(unit - m_joins, dividing_by(m_partition[thread]));
  }

  // Divides all faces that wait, in this thread, and lets them join the complex. Requires: no unit has been done since
  // begin_batch().
  void finish()
  {
    m_partition.resize((std::max)(m_partition.size(), std::size_t(1)));
    m_faces.finish(dividing_by(m_partition.front()), joining());
  }

  // The memory of the faces that wait, in bytes, without their breakpoints, which are few.
  std::size_t memory() const
  {
    std::size_t n = 0;
    m_faces.for_each_item([&](const Waiting_face& f)
    {
      n += sizeof(Waiting_face) + f.divided.images.capacity() * sizeof(Site_image<FT>)
         + f.division.nodes.capacity() * sizeof(Face_node<FT>) + f.division.arcs.capacity() * sizeof(Face_arc<FT>);
    });
    return n;
  }

private:
  struct Waiting_face
  {
    Divided_face<FT> divided;
    Face_division<FT> division; // valid once it has been divided
  };

  auto dividing_by(Face_partition<FT>& partition) const
  {
    return [this, &partition](Waiting_face& f)
    {
      m_complex->divide(f.divided, partition);
      f.division = partition.division();
    };
  }

  auto joining()
  {
    return [this](const Waiting_face& f) { m_complex->add(f.divided, f.division); };
  }

  Voronoi_complex<FT>* m_complex;
  Work_in_batches<Waiting_face> m_faces;
  std::size_t m_joins = 0; // 1 or 0: the number of units in which faces join the complex
  std::vector<Face_partition<FT>> m_partition; // by thread
};

// The keeper of a parallel propagation whose edges and faces the threads divide. `Removal` has a Deferred_division as
// consumer. The units of a batch are those of the faces, then those of the edges.
template <typename Removal>
class Dividing_window_keeper : public Diagram_window_keeper<Removal>
{
public:
  using Base = Diagram_window_keeper<Removal>;
  using FT = typename Base::FT;
  using Thread_keeper = typename Base::Thread_keeper;

  explicit Dividing_window_keeper(Removal& removal) : Base(removal), m_removal(&removal) {}

  void restart(std::size_t number_of_threads)
  {
    m_removal->consumer().restart(number_of_threads);
    m_removal->defer_edges(number_of_threads);
  }

  std::size_t begin_batch()
  {
    m_number_of_face_units = m_removal->consumer().begin_batch();
    return m_number_of_face_units + m_removal->begin_batch();
  }

  void do_unit(std::size_t unit, std::size_t thread)
  {
    if(unit < m_number_of_face_units)
      m_removal->consumer().do_unit(unit, thread);
    else
      m_removal->do_unit(unit - m_number_of_face_units, thread);
  }

  std::size_t memory() const { return m_removal->consumer().memory() + m_removal->memory_of_edges(); }

private:
  Removal* m_removal;
  std::size_t m_number_of_face_units = 0; // of the batch
};

// The consumer of a removal in one thread: divides each face when it is handed over.
template <typename FT>
class Immediate_division
{
public:
  explicit Immediate_division(Voronoi_complex<FT>& complex) : m_complex(&complex) {}

  void add(const Divided_face<FT>& divided) { m_complex->add(divided); }
  void finish() {}

private:
  Voronoi_complex<FT>* m_complex;
};

// What makes a complex while distances are propagated: the removal, and what divides the faces that it hands over. Use:
// start(), the propagation with keeper(), finish().
template <typename FT, bool has_several_threads>
class Diagram_propagation
{
public:
  using Complex = Voronoi_complex<FT>;
  using Division = std::conditional_t<has_several_threads, Deferred_division<FT>, Immediate_division<FT>>;
  using Removal = Redundant_window_removal<FT, Division>;
  using Keeper
    = std::conditional_t<has_several_threads, Dividing_window_keeper<Removal>, Diagram_window_keeper<Removal>>;

  explicit Diagram_propagation(Complex& complex) : m_complex(complex), m_division(complex) {}

  // Requires: the mesh is refined by the sites; the propagation is restarted, or made, after this. If sites have
  // numbers, the removal is told these next.
  void start(const Intrinsic_mesh<FT>& mesh, const Vertex_distance_field<FT>& field, bool has_numbers_of_sites = false)
  {
    m_complex.start(mesh, has_numbers_of_sites);
    m_removal.reset(mesh, field, m_division);
  }

  Removal& removal() { return m_removal; }
  Keeper keeper() { return Keeper(m_removal); }

  // Divides the last edges and faces. Then the owners, whose distances are final now, let the complex count elements
  // and link arcs to chains.
  void finish()
  {
    m_removal.finish();
    m_division.finish();
    m_complex.finish(m_removal.owners());
  }

private:
  Complex& m_complex;
  Division m_division;
  Removal m_removal;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_DIAGRAM_WINDOW_KEEPER_H
