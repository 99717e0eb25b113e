// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FACE_IMAGES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FACE_IMAGES_H

// The site images of a face together with the shape of the face: which image of a site is nearest to a point, and how
// far lengths in this face are uncertain.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/fronts/Site_image.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Frame: the layout of the face. Queries take time proportional to the number of images. An index of an image is its
// position in the order of add(), valid until start().
//
// Invariant: cones() has one cone for each image, in the same order. Lengths that are uncertain come in three sizes:
// width() for what rounding alone does, touching() for points where curves touch a line or each other (the square root
// of rounding), joining_distance() for a first guess that a closer look has to confirm.
template <typename FT_>
class Face_images
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Image = Site_image<FT>;
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Starts a face, given its corners in counterclockwise order. Removes the images of the face before; their memory is
  // kept. Then images are added.
  void start(const std::array<Point, 3>& corner)
  {
    m_images.clear();
    m_cones.clear();
    for(unsigned int k = 0; k < 3; ++k)
      m_side[k] = Half_plane<FT>::left_of(corner[k], corner[(k + 1) % 3]);
    m_size = (std::max)({distance(corner[0], corner[1]), distance(corner[1], corner[2]),
                         distance(corner[2], corner[0])});
    // (A side is a unit vector, so that this is the height above side 0 times its length: twice the area.)
    m_has_rays = false;
    m_has_no_height = is_without_height<FT>(m_side[0](corner[2]) * distance(corner[0], corner[1]), m_size);
  }

  void add(const Image& image)
  {
    m_images.push_back(image);
    m_cones.add(image);
    m_has_rays = m_has_rays || image.point.is_at_infinity();
  }

  std::size_t number() const { return m_images.size(); }
  const Image& operator[](std::size_t i) const { return m_images[i]; }
  const std::vector<Image>& all() const { return m_images; }
  const Cone_columns<FT>& cones() const { return m_cones; }

  // The three half-planes whose intersection is the face: side k leads from corner k to the next one. Their values are
  // signed distances, positive inside.
  const std::array<Half_plane<FT>, 3>& sides() const { return m_side; }

  // The longest side.
  const FT& size() const { return m_size; }

  // Whether the corners are on one line up to rounding. Then curves are known on the border only.
  bool has_no_height() const { return m_has_no_height; }

  // Shorter distances in the face come from rounding.
  FT width() const { return Tolerance<FT>::interval() * m_size; }

  // The precision of a point where a curve touches a line.
  FT touching() const { return Tolerance<FT>::touching() * m_size; }

  // Images tie if their distances differ by no more. Beside a site that is a curve, distances are as small as the
  // rounding of coordinates. (A site that is a point has one image only where it is so near.)
  FT margin_of_tie(const FT& distance) const
  {
    return distance * Tolerance<FT>::tie() + (m_has_rays ? width() : FT(0));
  }

  // Ends of curves that are closer to each other may be meant to be one point.
  FT joining_distance() const { return Tolerance<FT>::near_end() * m_size; }

  // Returns whether p is in the face, or outside of a side by not more than width().
  bool is_in_face(const Point& p) const
  {
    return std::all_of(m_side.begin(), m_side.end(), [&](const Half_plane<FT>& h) { return h(p) >= -width(); });
  }

  // Returns the image of a site that is nearest to p, `none` if the site has no image. If images tie, one that sees p
  // is preferred, because a trace can start with it as it is; of these the nearest one, and of equal ones the lowest
  // index. If the best image does not see p, its paths bend on the way to p.
  std::size_t nearest_of(Vertex_id site, const Point& p) const
  {
    std::size_t best = none, best_seeing = none;
    FT best_distance = std::numeric_limits<FT>::infinity(), best_seen = best_distance;
    for(std::size_t i = 0; i < m_images.size(); ++i)
    {
      const Image& image = m_images[i];
      // No path by an image is shorter than the straight one.
      if(image.site != site || image.point.distance_to(p) > best_distance + margin_of_tie(best_distance))
        continue;
      const bool sees = image.sees(p, width());
      const FT d = sees ? image.point.distance_to(p) : image.distance_to(p);
      if(d < best_distance)
      {
        best = i;
        best_distance = d;
      }
      if(sees && d < best_seen)
      {
        best_seeing = i;
        best_seen = d;
      }
    }
    const bool is_tie = best_seen <= best_distance + margin_of_tie(best_distance);
    return best_seeing != none && is_tie ? best_seeing : best;
  }

  // Returns the nearest image of all sites, the lowest index in a tie. Requires: there is an image.
  std::size_t nearest(const Point& p) const
  {
    CGAL_assertion(!m_images.empty());
    const auto is_less = [&](const Image& a, const Image& b) { return a.distance_to(p) < b.distance_to(p); };
    return static_cast<std::size_t>(std::min_element(m_images.begin(), m_images.end(), is_less) - m_images.begin());
  }

  // Returns the images of a site that tie with its nearest one at p, up to the error of images (Tolerance::tie()), in
  // ascending order, whether they see p or bend. None if the site has no image.
  std::vector<std::size_t> tied_images(Vertex_id site, const Point& p) const
  {
    std::vector<std::size_t> result;
    FT smallest = std::numeric_limits<FT>::infinity();
    for(const Image& image : m_images)
      if(image.site == site)
        smallest = (std::min)(smallest, image.distance_to(p));
    for(std::size_t i = 0; i < m_images.size(); ++i)
      if(m_images[i].site == site && m_images[i].distance_to(p) <= smallest + margin_of_tie(smallest))
        result.push_back(i);
    return result;
  }

  // Returns the distance of p from a site by its images, infinity if it has none.
  FT distance_from(Vertex_id site, const Point& p) const
  {
    const std::size_t i = nearest_of(site, p);
    return i != none ? m_images[i].distance_to(p) : std::numeric_limits<FT>::infinity();
  }

  // Returns the point that the shortest paths by an image to p come from straight: the image, or the end of its
  // interval.
  Additively_weighted_point<FT> point_toward(const Image& image, const Point& p) const
  {
    return image.sees(p, width()) ? image.point : bend(image, p).point;
  }

  // Returns the image of paths that bend at the end of the interval toward p: a weighted point at that end, without a
  // cone, whose weight is the distance of the end from the site. Requires: image.has_cone.
  static Image bend(const Image& image, const Point& p)
  {
    CGAL_assertion(image.has_cone);
    Image result;
    const Point& q = image.end_toward(p);
    result.point = Additively_weighted_point<FT>{q.x, q.y, image.point.distance_to(q)};
    result.site = image.site;
    return result;
  }

private:
  std::array<Half_plane<FT>, 3> m_side;
  FT m_size = 0;
  bool m_has_no_height = false, m_has_rays = false; // (rays: an image at infinity)
  std::vector<Image> m_images;
  Cone_columns<FT> m_cones; // of m_images
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_FRONTS_FACE_IMAGES_H
