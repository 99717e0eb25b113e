// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_SITE_IMAGES_OF_FACE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_SITE_IMAGES_OF_FACE_H

// The images of a face (Site_image.h) from its corners and the windows that entered it, in the layout
// of the face: corners 0, 1 and 2 at (0,0), (length[0],0) and (apex_x, apex_y).

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Edge_partition.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Site_image.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Face_windows.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// owner_of(v) is the source of a vertex, null_id if none reaches it.
template <typename FT, typename OwnerOf, typename Visitor>
void for_each_site_image(const Intrinsic_mesh<FT>& mesh, const Vertex_distance_field<FT>& field,
                             const Face_windows<FT>& windows, OwnerOf owner_of, Face_id f, Visitor visit)
{
  using Point = Planar_point<FT>;
  const Intrinsic_face<FT>& face = mesh.face(f);
  const std::array<Point, 3> corner = layout_of_face(face);
  for(unsigned int k = 0; k < 3; ++k)
  {
    Site_image<FT> g;
    g.point = Additively_weighted_point<FT>{corner[k].x, corner[k].y, field.distance[face.vertex[k]]};
    g.site = owner_of(face.vertex[k]);
    if(g.site != null_id)
      visit(g);
  }
  for(unsigned int k = 0; k < 3; ++k)
  {
    const FT length = face.length[k];
    if(!(length > 0))
      continue;
    const Point a = corner[k], b = corner[next_corner(k)];
    const FT tx = (b.x - a.x) / length, ty = (b.y - a.y) / length;
    windows.for_each(halfedge_of(f, k), [&](const Face_window<FT>& w)
    {
      const auto place = [&](const FT& x, const FT& y)
      { return Point{FT(a.x + x * tx - y * ty), FT(a.y + x * ty + y * tx)}; };
      Site_image<FT> g;
      const Point image = place(w.image_x, -w.image_depth);
      g.point = Additively_weighted_point<FT>{image.x, image.y, field.distance[w.root]};
      g.site = owner_of(w.root);
      g.has_cone = true;
      g.left_end = place(w.begin, 0);
      g.right_end = place(w.end, 0);
      // The directions as seen from the edge: an image that is very near to an end is not there in the layout.
      const auto side = [&](const FT& x, const FT& y, const Point& end)
      { return Half_plane<FT>::along(FT(x * tx - y * ty), FT(x * ty + y * tx), end); };
      g.left = side(w.image_x - w.begin, -w.image_depth, g.left_end);
      g.right = side(w.end - w.image_x, w.image_depth, g.right_end);
      visit(g);
    });
  }
}

// what an image of the face of h is to the points of the edge of h; false if it sees none of them.
template <typename FT>
bool image_on_edge(const Intrinsic_mesh<FT>& mesh, Halfedge_id h, const Site_image<FT>& g,
                       Edge_image<FT>& e)
{
  const std::array<Planar_point<FT>, 3> corner = layout_of_face(mesh.face(face_of(h)));
  const Planar_point<FT> a = corner[index_in_face(h)], b = corner[next_corner(index_in_face(h))];
  const FT length = mesh.length(h), tx = (b.x - a.x) / length, ty = (b.y - a.y) / length;
  FT first = 0, last = length;
  if(g.has_cone && has_no_height(mesh.face(face_of(h))))
  {
    // all is on one line, where cones mean nothing: the paths lead to the places of the interval
    const auto place = [&](const Planar_point<FT>& p)
    { return (std::min)((std::max)(FT((p.x - a.x) * tx + (p.y - a.y) * ty), FT(0)), length); };
    first = (std::min)(place(g.left_end), place(g.right_end));
    last = (std::max)(place(g.left_end), place(g.right_end));
  }
  else if(g.has_cone)
    for(const Half_plane<FT>* side : {&g.left, &g.right})
    {
      // the part of the edge in the half-plane
      const FT at_a = (*side)(a), at_b = (*side)(b);
      if(at_a < 0 && at_b < 0)
        return false;
      if(at_a < 0)
        first = (std::max)(first, FT(length * (at_a / (at_a - at_b))));
      else if(at_b < 0)
        last = (std::min)(last, FT(length * (at_a / (at_a - at_b))));
    }
  const FT dx = g.point.x - a.x, dy = g.point.y - a.y;
  e = Edge_image<FT>{first, last, FT(dx * tx + dy * ty), FT(dy * tx - dx * ty), g.point.weight, g.site};
  return first < last;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_SITE_IMAGES_OF_FACE_H
