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
// removal of redundant windows (Deferred_window_keeper.h). If several threads propagate, the faces that the removal
// hands over wait for the next batch of visits, in which all threads divide them (Deferred_division).

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Divided_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Face_partition.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Redundant_window_removal.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/passing/Deferred_window_keeper.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Threads log windows, and one at a time gives them to the removal.
template <typename Removal>
using Diagram_window_keeper = Deferred_window_keeper<Removal>;

// The consumer of a removal whose faces several threads divide. Batch n divides the faces that batch n-1 has handed
// over. Those that batch n-1 has divided join the complex, in the order in which they were handed over. So the complex
// does not depend on the threads.
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
    for(Faces* faces : {&m_handed_over, &m_in_work, &m_divided})
      faces->size = 0;
    m_partition.resize(number_of_threads);
  }

  // Takes a face over from the removal. It is copied.
  void add(const Divided_face<FT>& divided)
  {
    if(m_handed_over.size == m_handed_over.items.size())
      m_handed_over.items.emplace_back();
    m_handed_over.items[m_handed_over.size++].divided = divided;
  }

  // Begins a batch. Returns the number of its units. Requires: the units of the batch before are done.
  std::size_t begin_batch()
  {
    CGAL_precondition(m_divided.size == 0);
    std::swap(m_divided, m_in_work);
    std::swap(m_in_work, m_handed_over);
    m_joins = m_divided.size == 0 ? 0 : 1;
    return m_joins + (m_in_work.size + faces_per_unit() - 1) / faces_per_unit();
  }

  // Does a unit: divides some faces, or lets those of the batch before join the complex, which is one unit.
  void do_unit(std::size_t unit, std::size_t thread)
  {
    if(unit < m_joins)
      return add_divided();
    const std::size_t first = (unit - m_joins) * faces_per_unit();
    divide(m_in_work, first, (std::min)(first + faces_per_unit(), m_in_work.size), m_partition[thread]);
  }

  // Divides all faces that wait, in this thread, and lets them join the complex. Requires: no unit has been done since
  // begin_batch().
  void finish()
  {
    m_partition.resize((std::max)(m_partition.size(), std::size_t(1)));
    add_divided();
    for(int i = 0; i < 2; ++i) // those in work, then those handed over since
    {
      divide(m_in_work, 0, m_in_work.size, m_partition.front());
      begin_batch();
      add_divided();
    }
  }

  // The memory of the faces that wait, in bytes, without their breakpoints, which are few.
  std::size_t memory() const
  {
    std::size_t n = 0;
    for(const Faces* faces : {&m_handed_over, &m_in_work, &m_divided})
      for(const Waiting_face& f : faces->items)
        n += sizeof(Waiting_face) + f.divided.images.capacity() * sizeof(Site_image<FT>)
           + f.division.nodes.capacity() * sizeof(Face_node<FT>) + f.division.arcs.capacity() * sizeof(Face_arc<FT>);
    return n;
  }

private:
  struct Waiting_face
  {
    Divided_face<FT> divided;
    Face_division<FT> division; // valid once it has been divided
  };

  // The first `size` items are faces; the others keep their memory for later ones.
  struct Faces
  {
    std::vector<Waiting_face> items;
    std::size_t size = 0;
  };

  // At most a thousand units, with that of the faces that join, however many faces there are.
  std::size_t faces_per_unit() const { return 1 + m_in_work.size / 900; }

  void add_divided()
  {
    for(std::size_t i = 0; i < m_divided.size; ++i)
      m_complex->add(m_divided.items[i].divided, m_divided.items[i].division);
    m_divided.size = 0;
  }

  void divide(Faces& faces, std::size_t first, std::size_t last, Face_partition<FT>& partition) const
  {
    for(std::size_t i = first; i < last; ++i)
    {
      m_complex->divide(faces.items[i].divided, partition);
      faces.items[i].division = partition.division();
    }
  }

  Voronoi_complex<FT>* m_complex;
  Faces m_handed_over, m_in_work, m_divided; // between two batches the faces move on to the next one of these
  std::size_t m_joins = 0; // 1 or 0: the number of units in which faces join the complex
  std::vector<Face_partition<FT>> m_partition; // by thread
};

// The keeper of a parallel propagation whose faces the threads divide. `Removal` has a Deferred_division as consumer.
template <typename Removal>
class Dividing_window_keeper : public Diagram_window_keeper<Removal>
{
public:
  using Base = Diagram_window_keeper<Removal>;
  using FT = typename Base::FT;
  using Thread_keeper = typename Base::Thread_keeper;

  explicit Dividing_window_keeper(Removal& removal) : Base(removal), m_division(&removal.consumer()) {}

  void restart(std::size_t number_of_threads) { m_division->restart(number_of_threads); }
  std::size_t begin_batch() { return m_division->begin_batch(); }
  void do_unit(std::size_t unit, std::size_t thread) { m_division->do_unit(unit, thread); }
  std::size_t memory() const { return m_division->memory(); }

private:
  Deferred_division<FT>* m_division;
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

  // Divides the last faces. Then the owners, whose distances are final now, let the complex count elements and link
  // arcs to chains.
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
