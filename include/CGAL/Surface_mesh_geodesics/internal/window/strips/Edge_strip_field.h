// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_EDGE_STRIP_FIELD_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_EDGE_STRIP_FIELD_H

// The strips that a propagation has carried across each halfedge, kept for queries at any point of the surface. They
// are to a propagation from curves what the windows of Edge_window_field.h are to any propagation.
//
// A kept strip has been trimmed by the vertices that were known when it crossed its edge. What vertices have beaten
// since costs memory only: each ray is a path on the surface, and its length is right.
//
// Isolines of given distances need the strips of a face until the wavefront has passed it, and release them then.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The strips of all halfedges in one vector, in the order in which they were kept. Those of a halfedge form a chain,
// the latest first. Strips cross the faces in one thread, so nothing is guarded. The places of strips that have been
// released form one more chain, and are taken first.
//
// Invariant: the chain of a halfedge leads from later strips to earlier ones, and so it ends. Each place is in one
// chain.
template <typename FT>
class Edge_strip_field
{
public:
  static constexpr bool exist = true;

  // Removes all strips, and prepares for a mesh with this number of faces. Linear in that number.
  void reset(std::size_t number_of_faces)
  {
    m_last.assign(3 * number_of_faces, null_id);
    m_strips.clear();
    m_first_free = null_id;
  }

  // Removes all strips and frees the memory.
  void clear()
  {
    m_last = std::vector<std::uint32_t>();
    m_strips = std::vector<Kept>();
    m_first_free = null_id;
  }

  // Keeps a strip that crosses h. Takes constant time, amortized. Requires: reset() for a mesh with h.
  void keep(Halfedge_id h, const Strip<FT>& s)
  {
    std::uint32_t& last = m_last[dense_index(h)];
    std::uint32_t place = m_first_free;
    if(place == null_id)
    {
      place = static_cast<std::uint32_t>(m_strips.size());
      m_strips.push_back(Kept{s, last});
    }
    else
    {
      m_first_free = m_strips[place].previous;
      m_strips[place] = Kept{s, last};
    }
    last = place;
  }

  // Releases the strips of h, whose places later ones take. Linear in their number. Does nothing before reset().
  void release(Halfedge_id h)
  {
    if(m_strips.empty())
      return;
    for(std::uint32_t i = std::exchange(m_last[dense_index(h)], null_id); i != null_id;)
    {
      const std::uint32_t previous = std::exchange(m_strips[i].previous, m_first_free);
      m_first_free = i;
      i = previous;
    }
  }

  // Calls visit(strip) for all strips of h, the latest first. Linear in their number; none if nothing has been kept.
  template <typename Visit>
  void for_each_strip(Halfedge_id h, Visit visit) const
  {
    for_each_numbered_strip(h, [&](std::size_t, const Strip<FT>& s) { visit(s); });
  }

  // The same with visit(number, strip): strips are numbered in the order in which they were kept, as long as none has
  // been released.
  template <typename Visit>
  void for_each_numbered_strip(Halfedge_id h, Visit visit) const
  {
    if(!m_strips.empty())
      for(std::uint32_t i = m_last[dense_index(h)]; i != null_id; i = m_strips[i].previous)
        visit(std::size_t(i), m_strips[i].strip);
  }

  // The number of places. Without releases, that of strips.
  std::size_t size() const { return m_strips.size(); }

  std::size_t memory() const
  {
    return m_strips.capacity() * sizeof(Kept) + m_last.capacity() * sizeof(std::uint32_t);
  }

private:
  struct Kept
  {
    Strip<FT> strip;
    std::uint32_t previous; // on the same halfedge, or null_id
  };

  std::vector<std::uint32_t> m_last; // by halfedge
  std::vector<Kept> m_strips;
  std::uint32_t m_first_free = null_id; // the place of a strip that has been released
};

// What a computation has in place of strips that knows of no curves: nothing, at no cost.
struct No_strip_field
{
  static constexpr bool exist = false;

  void reset(std::size_t) {}
  void clear() {}
  void release(Halfedge_id) {}
  template <typename Visit>
  void for_each_strip(Halfedge_id, Visit) const {}
  std::size_t memory() const { return 0; }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_EDGE_STRIP_FIELD_H
