// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_BORDER_CYCLES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_BORDER_CYCLES_H

// The border of a mesh, or of the part of it that is not avoided.

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A halfedge is open if it has a face that is not avoided. The border consists of the halfedges that are not open, with
// an open one on the other side: faces to avoid are as if they were not in the mesh, and edges without an open face
// belong to no border.
//
// Behind a halfedge of the border comes the next one around its target, past faces to avoid and edges without faces.
// The walk around the target ends at the latest where it would come back: the edge before the open halfedge from which
// it began is open on its other side. Where no face is avoided, this is the order of the mesh.
//
// Calls visit(cycle) for each cycle of the border, in the order of first halfedges in the mesh. Linear, and the time of
// a set of border halfedges.
template <typename TriangleMesh, typename IsOpen, typename Visit>
void for_each_border_cycle(const TriangleMesh& tm, const IsOpen& is_open, Visit visit)
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  std::set<halfedge_descriptor> done;
  for(const halfedge_descriptor first : halfedges(tm))
  {
    if(is_open(first) || !is_open(opposite(first, tm)) || done.count(first) != 0)
      continue;
    std::vector<halfedge_descriptor> cycle;
    for(halfedge_descriptor h = first; done.insert(h).second;)
    {
      cycle.push_back(h);
      h = next(h, tm);
      while(!is_open(opposite(h, tm)))
        h = next(opposite(h, tm), tm);
    }
    visit(cycle);
  }
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_CURVES_BORDER_CYCLES_H
