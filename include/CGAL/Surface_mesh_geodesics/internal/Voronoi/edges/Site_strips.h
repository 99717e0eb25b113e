// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_SITE_STRIPS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_SITE_STRIPS_H

// Sites that are curves: the strips of parallel rays from the insides of their segments, by the halfedge across which
// they enter a face, and the site of each vertex at which paths begin.
//
// With curves among the sites, a site is known by its number: a curve has many vertices, and may share all of them with
// other curves. (With points only, it is known by its vertex.) The rules for ties are those of Source_curves: a vertex
// or an edge of several curves belongs to the nearest one by offset, of these to the first.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariant: m_is_removed has an entry for each strip of the field. Without curves there are neither.
template <typename FT>
class Site_strips
{
public:
  using Field = Vertex_distance_field<FT>;

  // Forgets all strips: no site is a curve.
  void clear()
  {
    m_arrivals = nullptr;
    m_is_removed.clear();
  }

  // Takes the strips and the curves of a complete run, which are referred to. Linear in the number of strips.
  void reset(const Curve_arrivals<FT>& arrivals)
  {
    m_arrivals = &arrivals;
    m_is_removed.assign(arrivals.strips.size(), false);
  }

  bool exist() const { return m_arrivals != nullptr; }

  // Calls visit(number, strip, site) for the strips of a halfedge that have not been removed.
  template <typename Visit>
  void for_each(Halfedge_id h, Visit visit) const
  {
    if(!exist())
      return;
    m_arrivals->strips.for_each_numbered_strip(h, [&](std::size_t i, const Strip<FT>& s)
    {
      if(!m_is_removed[i])
        visit(i, s, Vertex_id(m_arrivals->edge_of_side(s.side).curve));
    });
  }

  // Removes the strip with a number.
  void remove(std::size_t i) { m_is_removed[i] = true; }

  // Returns, for each vertex that is its own root, the site at which the path to it begins: it is a vertex of a curve,
  // or a strip has reached it last. Other vertices have null_id. Requires: exist(). Takes time linear in the number of
  // vertices, times the logarithm of that of vertices on curves.
  std::vector<Vertex_id> sites_of_roots(const Field& field) const
  {
    CGAL_assertion(exist());
    std::vector<Vertex_id> result(field.distance.size(), null_id);
    for(Vertex_id v = 0; v < result.size(); ++v)
      if(field.arrival[v].root == v)
        result[v] = m_arrivals->point_of(field, v).curve;
    return result;
  }

private:
  const Curve_arrivals<FT>* m_arrivals = nullptr;
  std::vector<bool> m_is_removed; // by the number of the strip
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_SITE_STRIPS_H
