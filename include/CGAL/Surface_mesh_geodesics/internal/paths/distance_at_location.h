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

// The distance at any point of a face. The shortest path to it comes straight from a corner of the face, or through one
// of the edges with a window that has been kept there (Edge_window_field.h), or with a strip (Edge_strip_field.h).

#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstdint>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// How the shortest path arrives at a point of a face. There are four cases:
// - `root` and `side` are null_id: no source reaches the point, and `distance` is infinite.
// - `halfedge` is null_id: the path comes straight from `root`, which is a corner of the face.
// - `side` is null_id: the path comes from the image of `root` at (image_x, -image_depth), through the point `abscissa`
//   of `halfedge`, to the point at (x, y), all in the frame of that halfedge.
// - else it comes in the same way from the foot of a ray, on this side of a source edge (Strip.h).
// `inside` is the length of the path in the face.
template <typename FT>
struct Location_arrival
{
  FT distance;
  Vertex_id root = null_id;
  Halfedge_id halfedge = null_id;
  FT abscissa = 0, image_x = 0, image_depth = 0;
  FT inside = 0;
  FT x = 0, y = 0;
  std::uint32_t side = null_id;
  FT foot = 0; // the abscissa of the foot in the frame of the halfedge on that side

  bool is_reached() const { return root != null_id || side != null_id; }
};

// Returns the point with the barycentric coordinates b in the frame of halfedge k of its face.
// Formula: b_k A + b_next B + b_apex C with A = (0,0), B = (length,0).
// Requires: b >= 0; then y >= 0.
// Error: three epsilon of the longest side, beyond that of the apex.
template <typename FT>
std::array<FT, 2> point_in_frame(const Face_frame<FT>& c, const std::array<FT, 3>& b, unsigned int k)
{
  const unsigned int apex = previous_corner(k);
  return {FT(b[next_corner(k)] * c.length + b[apex] * c.apex_x), FT(b[apex] * c.apex_y)};
}

// Returns the length of the path through window w to the point (x, y) above its edge, and sets where it crosses the
// edge: straight from the image, or, if the straight line passes beside the window, bent at the nearer end of it.
// `root_distance` is the distance of the root of w.
//
// The straight line crosses the edge at (image_x y + x depth) / (y + depth); on the line of the edge itself, where that
// is 0/0, at x.
// Error of the distance: the root distance and the norm round once each, and a sum once or twice, so three epsilon
// beyond the errors of the point and of the image, for which Tolerance::distance() derives a bound.
// Requires: y >= 0.
template <typename FT>
FT distance_through_window(const Kept_window<FT>& w, const FT& root_distance, const FT& x, const FT& y, FT& abscissa)
{
  const FT height = y + w.image_depth;
  const FT t = height > 0 ? FT((w.image_x * y + x * w.image_depth) / height) : x;
  abscissa = t;
  if(t < w.begin || t > w.end)
  {
    abscissa = t < w.begin ? w.begin : w.end;
    return root_distance + norm<FT>(abscissa - w.image_x, w.image_depth) + norm<FT>(x - abscissa, y);
  }
  return root_distance + norm<FT>(x - w.image_x, height);
}

// Replaces the arrival at the point (x, y) above the edge of h if a path through window w is shorter. A tie keeps the
// arrival. Requires: y >= 0.
template <typename FT>
void improve_arrival(Location_arrival<FT>& arrival, const Kept_window<FT>& w, const FT& root_distance,
                     Halfedge_id h, const FT& x, const FT& y)
{
  FT abscissa;
  const FT distance = distance_through_window(w, root_distance, x, y, abscissa);
  if(distance < arrival.distance)
    arrival = Location_arrival<FT>{distance, w.root, h, abscissa, w.image_x, w.image_depth,
                                   norm<FT>(x - abscissa, y), x, y};
}

// The same for a strip. It has no root: its rays come from the points of a source edge. What a path needs to run back
// is the same as for a window, an image and the abscissa where it crosses the edge. The side and the foot tell where on
// the curve the path begins.
// Requires: y >= 0.
template <typename FT>
void improve_arrival(Location_arrival<FT>& arrival, const Strip<FT>& s, Halfedge_id h, const FT& x, const FT& y)
{
  const Ray_arrival<FT> ray = arrival_of_ray(s, x, y);
  if(!(ray.distance < arrival.distance))
    return;
  arrival = Location_arrival<FT>();
  arrival.distance = ray.distance;
  arrival.halfedge = h;
  arrival.abscissa = ray.abscissa;
  arrival.image_x = ray.image_x;
  arrival.image_depth = ray.image_depth;
  arrival.inside = norm<FT>(x - ray.abscissa, y);
  arrival.x = x;
  arrival.y = y;
  arrival.side = s.side;
  arrival.foot = s.foot_at(ray.abscissa);
}

// Returns the arrival at the point of face f with the barycentric coordinates b: the minimum over the three corners and
// the windows kept on the three edges. Ties go to the candidate that comes first: edges in the order of their index,
// the corner at the source of an edge before its windows, windows of later lists before those of earlier ones, windows
// before strips.
// Requires: `windows` holds those of the propagation that has filled `field`, and `strips`, unless it is null, its
// strips; b >= 0.
// Complexity: linear in the number of windows and strips kept on the three edges.
// Law: at corner k the distance is at most that of the vertex.
template <typename FT>
Location_arrival<FT> arrival_at_location(const Intrinsic_mesh<FT>& mesh,
                                         const Vertex_distance_field<FT>& field,
                                         const Edge_window_field<FT>& windows, Face_id f,
                                         const std::array<FT, 3>& b, const Edge_strip_field<FT>* strips = nullptr)
{
  CGAL_assertion(f < mesh.number_of_faces());
  CGAL_expensive_assertion(b[0] >= 0 && b[1] >= 0 && b[2] >= 0);
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
    if(strips != nullptr)
      strips->for_each_strip(h, [&](const Strip<FT>& s) { improve_arrival(arrival, s, h, p[0], p[1]); });
  }
  return arrival;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_DISTANCE_AT_LOCATION_H
