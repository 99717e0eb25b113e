// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_DISTANCE_AT_LOCATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_DISTANCE_AT_LOCATION_H

// The distance at any point of a face: the shortest path comes straight from a corner of the face, or
// through one of its edges with a window that has been kept there.

#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>

#include <array>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// How the shortest path arrives at a point of a face: straight from the vertex `root` which is a
// corner of the face (then halfedge is null_id), or from the image of `root` through the point
// `abscissa` of `halfedge`, in the frame of that halfedge, where the point is at (x, y). `inside` is the
// length of the path in the face. `root` is null_id if there is no path.
template <typename FT>
struct Location_arrival
{
  FT distance;
  Vertex_id root = null_id;
  Halfedge_id halfedge = null_id;
  FT abscissa = 0, image_x = 0, image_depth = 0;
  FT inside = 0;
  FT x = 0, y = 0;
};

// The point of face f with the barycentric coordinates b, in the frame of its halfedge k.
template <typename FT>
std::array<FT, 2> point_in_frame(const Face_frame<FT>& c, const std::array<FT, 3>& b, unsigned int k)
{
  const unsigned int apex = previous_corner(k);
  return {FT(b[next_corner(k)] * c.length + b[apex] * c.apex_x), FT(b[apex] * c.apex_y)};
}

// The shortest path from the image of a window's pseudo-source to the point (x, y) above the edge:
// straight, or bent at an end of the interval.
template <typename FT>
void improve_arrival(Location_arrival<FT>& arrival, const Kept_window<FT>& w, const FT& root_distance,
                     Halfedge_id h, const FT& x, const FT& y)
{
  const FT height = y + w.image_depth;
  // the abscissa at which the straight path crosses the edge; it may run along the edge
  const FT t = height > 0 ? FT((w.image_x * y + x * w.image_depth) / height) : x;
  FT abscissa = t, distance;
  if(t < w.begin || t > w.end)
  {
    abscissa = t < w.begin ? w.begin : w.end;
    distance = root_distance + norm<FT>(abscissa - w.image_x, w.image_depth)
             + norm<FT>(x - abscissa, y);
  }
  else
    distance = root_distance + norm<FT>(x - w.image_x, height);
  if(distance < arrival.distance)
    arrival = Location_arrival<FT>{distance, w.root, h, abscissa, w.image_x, w.image_depth,
                                   norm<FT>(x - abscissa, y), x, y};
}

// The arrival at the point of face f with the barycentric coordinates b. Takes time linear in the
// number of windows kept on the three edges.
template <typename FT>
Location_arrival<FT> arrival_at_location(const Intrinsic_mesh<FT>& mesh,
                                         const Vertex_distance_field<FT>& field,
                                         const Edge_window_field<FT>& windows, Face_id f,
                                         const std::array<FT, 3>& b)
{
  Location_arrival<FT> arrival;
  arrival.distance = Vertex_distance_field<FT>::infinity();
  for(unsigned int k = 0; k < 3; ++k)
  {
    const Halfedge_id h = halfedge_of(f, k);
    const Face_frame<FT> c = mesh.face_frame(h);
    const std::array<FT, 2> p = point_in_frame(c, b, k);
    const FT inside = norm(p[0], p[1]), from_corner = field.distance[c.origin] + inside;
    if(from_corner < arrival.distance)
    {
      arrival = Location_arrival<FT>();
      arrival.distance = from_corner;
      arrival.root = c.origin;
      arrival.inside = inside;
    }
    windows.for_each_window(h, [&](const Kept_window<FT>& w)
    { improve_arrival(arrival, w, field.distance[w.root], h, p[0], p[1]); });
  }
  return arrival;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_DISTANCE_AT_LOCATION_H
