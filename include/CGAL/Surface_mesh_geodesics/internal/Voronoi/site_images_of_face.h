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

// Finds the site images of a face (Site_image.h): its corners, and the images behind the windows that entered it. All
// coordinates are those of the layout of the face: corners 0, 1 and 2 at (0,0), (length[0],0) and (apex_x,apex_y).
//
// for_each_site_image() serves a face that is divided; image_on_edge() turns a site image into one of an edge
// (Edge_image), for edges of the border, which no window crosses outward.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Edge_image.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/edges/Site_strips.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Site_image.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Face_windows.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The frame of one side of a face in the layout of the face: x runs along the side, y points into the face. It is the
// frame of the windows that enter across that side (Window.h), so that their images have y = -image_depth.
template <typename FT>
struct Side_frame
{
  Planar_point<FT> origin;
  FT tx, ty; // the unit vector along the side

  // Requires: length > 0, which is the distance from a to b.
  Side_frame(const Planar_point<FT>& a, const Planar_point<FT>& b, const FT& length)
    : origin(a), tx((b.x - a.x) / length), ty((b.y - a.y) / length)
  {
    CGAL_assertion(length > 0);
  }

  Planar_point<FT> point(const FT& x, const FT& y) const
  {
    return {FT(origin.x + x * tx - y * ty), FT(origin.y + x * ty + y * tx)};
  }

  // Returns the points on the left of the line through p in the direction (x, y) of the frame; p is in the layout.
  // Values are signed distances.
  Half_plane<FT> half_plane(const FT& x, const FT& y, const Planar_point<FT>& p) const
  {
    return Half_plane<FT>::along(FT(x * tx - y * ty), FT(x * ty + y * tx), p);
  }
};

// Returns the image of a window across the side of `frame`. The weight is the distance of the window's root.
//
// The sides of the cone come from the coordinates in the frame of the side: there, an image that is very close to an
// end of its window keeps its direction, while in the layout of the face both may round to one point. Each side leads
// through an end of the interval and the image, which is below: the left one down to the image, the right one up from
// it. So the cone is on the left of both.
template <typename FT>
Site_image<FT> image_of_window(const Kept_window<FT>& w, const Side_frame<FT>& frame, const FT& weight, Vertex_id site)
{
  Site_image<FT> image;
  const Planar_point<FT> p = frame.point(w.image_x, -w.image_depth);
  image.point = Additively_weighted_point<FT>{p.x, p.y, weight};
  image.site = site;
  image.has_cone = true;
  image.left_end = frame.point(w.begin, 0);
  image.right_end = frame.point(w.end, 0);
  image.left = frame.half_plane(w.image_x - w.begin, -w.image_depth, image.left_end);
  image.right = frame.half_plane(w.end - w.image_x, w.image_depth, image.right_end);
  return image;
}

// Returns the image of a strip of parallel rays (Strip.h) across the side of `frame`, which is a point at infinity. The
// sides of the cone are the first and the last ray: the left one runs down, the right one up. `size` is that of the
// face.
template <typename FT>
Site_image<FT> image_of_strip(const Strip<FT>& s, const Side_frame<FT>& frame, const FT& size, Vertex_id site)
{
  using std::abs;
  Site_image<FT> image;
  const FT x = s.direction_x * frame.tx - s.direction_y * frame.ty;
  const FT y = s.direction_x * frame.ty + s.direction_y * frame.tx;
  image.point = Additively_weighted_point<FT>{x, y, FT(s.distance - (x * frame.origin.x + y * frame.origin.y)),
                                              FT(abs(s.distance) + size)};
  image.site = site;
  image.has_cone = true;
  image.left_end = frame.point(s.begin, 0);
  image.right_end = frame.point(s.end, 0);
  image.left = frame.half_plane(-s.direction_x, -s.direction_y, image.left_end);
  image.right = frame.half_plane(s.direction_x, s.direction_y, image.right_end);
  return image;
}

// Calls visit(image) for the site images of face f: the corners, then the windows and strips of each side in the order
// in which they came. owner_of(v) is the site nearest to vertex v, null_id if none reaches it. Linear in the number of
// images.
// The weights are the distances of the field at the time of the call: those that matter in the face have to be final.
// (A side without length has no windows, since their intervals have a length.)
template <typename FT, typename OwnerOf, typename Visit>
void for_each_site_image(const Intrinsic_mesh<FT>& mesh, const Vertex_distance_field<FT>& field,
                         const Face_windows<FT>& windows, const Site_strips<FT>& strips, OwnerOf owner_of, Face_id f,
                         Visit visit)
{
  const Intrinsic_face<FT>& face = mesh.face(f);
  const std::array<Planar_point<FT>, 3> corner = layout_of_face(face);
  for(unsigned int k = 0; k < 3; ++k)
  {
    Site_image<FT> image;
    image.point = Additively_weighted_point<FT>{corner[k].x, corner[k].y, field.distance[face.vertex[k]]};
    image.site = owner_of(face.vertex[k]);
    if(image.site != null_id)
      visit(image);
  }
  for(unsigned int k = 0; k < 3; ++k)
  {
    if(!(face.length[k] > 0))
      continue;
    const Side_frame<FT> frame(corner[k], corner[next_corner(k)], face.length[k]);
    windows.for_each_window(halfedge_of(f, k), [&](const Kept_window<FT>& w)
    { visit(image_of_window(w, frame, field.distance[w.root], owner_of(w.root))); });
    strips.for_each(halfedge_of(f, k), [&](std::size_t, const Strip<FT>& s, Vertex_id site)
    { visit(image_of_strip(s, frame, longest_side(face), site)); });
  }
}

// Shortens the interval from `first` to `last` of the edge from a to b to the part that is in the cone of an image.
// Returns false if no point of the edge is in one of the two half-planes. If it returns true, the interval may still be
// empty, with last < first. The abscissa where a side of the cone crosses the edge is length * at_a / (at_a - at_b), as
// the signed distance from that side is linear along the edge.
// Requires: image.has_cone; `length` is the distance from a to b.
template <typename FT>
bool clip_to_cone(const Site_image<FT>& image, const Planar_point<FT>& a, const Planar_point<FT>& b, const FT& length,
                  FT& first, FT& last)
{
  CGAL_assertion(image.has_cone && length > 0);
  for(const Half_plane<FT>* side : {&image.left, &image.right})
  {
    const FT at_a = (*side)(a), at_b = (*side)(b);
    if(at_a < 0 && at_b < 0)
      return false;
    if(at_a < 0)
      first = (std::max)(first, FT(length * (at_a / (at_a - at_b))));
    else if(at_b < 0)
      last = (std::min)(last, FT(length * (at_a / (at_a - at_b))));
  }
  return true;
}

// Finds what an image of the face of h is to the points of the edge of h, in the frame of h: the paths from inside the
// face, which matter on the border of the mesh. Returns false if it sees none of them. The depth is then the distance
// from the line of the edge on the inner side, where the windows across h have their images on the outer one; distances
// on the edge are the same for both.
// Requires: the edge has a length.
template <typename FT>
bool image_on_edge(const Intrinsic_mesh<FT>& mesh, Halfedge_id h, const Site_image<FT>& image, Edge_image<FT>& result)
{
  const std::array<Planar_point<FT>, 3> corner = layout_of_face(mesh.face(face_of(h)));
  const Planar_point<FT> a = corner[index_in_face(h)], b = corner[next_corner(index_in_face(h))];
  const FT length = mesh.length(h);
  const Side_frame<FT> frame(a, b, length);
  FT first = 0, last = length;
  if(image.has_cone && has_no_height(mesh.face(face_of(h))))
  {
    // In a face without height all points are on one line and a cone has no meaning: the paths lead to the interval.
    const auto abscissa = [&](const Planar_point<FT>& p)
    { return (std::min)((std::max)(FT((p.x - a.x) * frame.tx + (p.y - a.y) * frame.ty), FT(0)), length); };
    first = (std::min)(abscissa(image.left_end), abscissa(image.right_end));
    last = (std::max)(abscissa(image.left_end), abscissa(image.right_end));
  }
  else if(image.has_cone && !clip_to_cone(image, a, b, length, first, last))
    return false;
  if(image.point.is_at_infinity())
  {
    const FT slope = image.point.x * frame.tx + image.point.y * frame.ty;
    const FT at_a = image.point.weight + image.point.way_to(a);
    result = Edge_image<FT>{first, last, slope, FT(0), at_a, image.site, true};
    return first < last;
  }
  const FT dx = image.point.x - a.x, dy = image.point.y - a.y;
  result = Edge_image<FT>{first, last, FT(dx * frame.tx + dy * frame.ty), FT(dy * frame.tx - dx * frame.ty),
                          image.point.weight, image.site};
  return first < last;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_SITE_IMAGES_OF_FACE_H
