// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_SOURCE_HALFEDGES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_SOURCE_HALFEDGES_H

// Which halfedges are on curves that are sources, and with which offsets: a sorted table, as curves have few edges in
// comparison with the mesh.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Both halfedges of each edge are there, as a vertex of the border may see an edge from the one with a face only. Edges
// without length are left out: they have no normals, and nothing crosses them.
template <typename FT>
class Source_halfedges
{
public:
  // Replaces the table. Takes the time of sorting. Requires: each edge is there once (Source_curves).
  void set(const std::vector<Source_edge<FT>>& edges)
  {
    m_entries.clear();
    for(const Source_edge<FT>& e : edges)
      for(const Halfedge_id h : {e.left, e.right})
        if(h != null_id && e.length > 0)
          m_entries.push_back(Entry{h, e.offset});
    std::sort(m_entries.begin(), m_entries.end());
  }

  // Without curves, no halfedge is there.
  void clear() { m_entries.clear(); }
  bool empty() const { return m_entries.empty(); }

  // Returns the offset of the curve on which a halfedge is, nullptr if it is on none. Takes logarithmic time.
  const FT* offset(Halfedge_id h) const
  {
    const auto found = std::lower_bound(m_entries.begin(), m_entries.end(), Entry{h, FT(0)});
    return found != m_entries.end() && found->halfedge == h ? &found->offset : nullptr;
  }

  // Calls visit(h) for each halfedge, in ascending order.
  template <typename Visit>
  void for_each_halfedge(Visit visit) const
  {
    for(const Entry& e : m_entries)
      visit(e.halfedge);
  }

  std::size_t memory() const { return m_entries.capacity() * sizeof(Entry); }

private:
  // Entries are told apart by their halfedges: each one is there once.
  struct Entry
  {
    Halfedge_id halfedge;
    FT offset;

    friend bool operator<(const Entry& a, const Entry& b) { return a.halfedge < b.halfedge; }
  };

  std::vector<Entry> m_entries; // by halfedge
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_SOURCE_HALFEDGES_H
