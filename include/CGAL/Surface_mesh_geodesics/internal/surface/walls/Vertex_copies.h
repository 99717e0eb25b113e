// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_WALLS_VERTEX_COPIES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_WALLS_VERTEX_COPIES_H

// Which vertices of the intrinsic mesh are one vertex of the user: its copies, one for each sector between walls
// (Wall_cut.h).
//
// The distance of the user's vertex is the least of its copies. It is no metric any more: a wall separates the copies
// of its vertex, so the way to the one and the way on from the other make no path. What rests on the triangle
// inequality (landmarks of matrices, checks of stored rows) leaves such vertices out.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Each vertex knows the next copy in a ring. Without walls there is no table, and each vertex is alone; so are vertices
// that were inserted later, behind those in the table. Queries take time linear in the number of copies of one vertex.
class Vertex_copies
{
public:
  // Have no vertices copies at all?
  bool empty() const { return m_next.empty(); }

  // Makes a table of n vertices, each of which is alone. Vertices that are connected later stay so.
  void reset(std::size_t n)
  {
    m_next.resize(n);
    std::iota(m_next.begin(), m_next.end(), Vertex_id(0));
  }

  // Makes `copy` a copy of v. Requires: both are in the table, and `copy` is alone.
  void connect(Vertex_id v, Vertex_id copy)
  {
    CGAL_assertion(v < m_next.size() && copy < m_next.size() && m_next[copy] == copy && v != copy);
    m_next[copy] = m_next[v];
    m_next[v] = copy;
  }

  // Has a vertex other copies?
  bool is_divided(Vertex_id v) const { return v < m_next.size() && m_next[v] != v; }

  // Calls visit(c) for v and for all other copies of the same vertex, v first.
  template <typename Visit>
  void for_each(Vertex_id v, Visit&& visit) const
  {
    visit(v);
    if(v < m_next.size())
      for(Vertex_id c = m_next[v]; c != v; c = m_next[c])
        visit(c);
  }

  // Returns the copy with the least distance(copy); of equal ones the first, counted from v.
  template <typename Distance>
  Vertex_id nearest(Vertex_id v, const Distance& distance) const
  {
    Vertex_id result = v;
    if(v < m_next.size())
      for(Vertex_id c = m_next[v]; c != v; c = m_next[c])
        if(distance(c) < distance(result))
          result = c;
    return result;
  }

  std::size_t memory() const { return m_next.capacity() * sizeof(Vertex_id); }

private:
  std::vector<Vertex_id> m_next; // or empty
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_WALLS_VERTEX_COPIES_H
