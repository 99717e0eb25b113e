// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_HALFEDGE_IN_FACE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_HALFEDGE_IN_FACE_H

// A face of a vertex of the user's mesh.

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Returns a halfedge with a face and the target v; the null halfedge if v has no face in the umbrella of halfedge(v).
// Edges without faces may be linked into the border at v, so several steps may be needed. Linear in the degree of v.
template <typename TriangleMesh>
typename boost::graph_traits<TriangleMesh>::halfedge_descriptor
halfedge_in_face(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v, const TriangleMesh& tm)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  const typename Graph_traits::halfedge_descriptor first = halfedge(v, tm);
  typename Graph_traits::halfedge_descriptor h = first;
  while(h != Graph_traits::null_halfedge() && is_border(h, tm))
  {
    h = opposite(next(h, tm), tm);
    if(h == first) // the edges around v have no face on either side
      return Graph_traits::null_halfedge();
  }
  return h;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_HALFEDGE_IN_FACE_H
