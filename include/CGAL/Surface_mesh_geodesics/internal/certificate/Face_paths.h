// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_FACE_PATHS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_FACE_PATHS_H

// The paths that lead to the points of one face: families of them, each straight from one image through an interval of
// a side, or around an end of the interval. The image of a curve is at infinity. They come from windows and strips,
// which exist as paths, or from the function on the edges that proves lower bounds (Lower_bound_function.h).
//
// Frame: the layout of the face (corners 0, 1 and 2 at (0,0), (length[0],0) and (apex_x,apex_y)).

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/site_images_of_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Arc_piece.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Edge_distance_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Lower_bound_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Weighted_bisector.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The paths of one family. A corner, and an image on the line of its side, is a single point from which paths lead
// straight to all points of the face.
template <typename FT_>
class Path_family
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Image = Additively_weighted_point<FT>;

  // A family from one point of the face.
  explicit Path_family(const Image& point)
    : m_piece{FT(0), FT(0), FT(0), FT(0), point.weight}, m_frame(Point{}, Point{FT(1), FT(0)}, FT(1)), m_image(point),
      m_begin(point), m_end(point)
  {}

  // A family through an interval of the side of a frame; the image lies on the other side, at (x, -depth), or its rays
  // have the direction (x, depth). `size` is that of the face.
  Path_family(const Distance_piece<FT>& piece, const Side_frame<FT>& frame, const FT& size)
    : m_piece(piece), m_frame(frame), m_begin(image_on_side(piece.begin)), m_end(image_on_side(piece.end))
  {
    if(is_point())
      m_image = image_on_side(piece.nearest());
    else if(piece.is_linear)
      m_image = image_at_infinity(size);
    else
    {
      const Point p = frame.point(piece.x, -piece.depth);
      m_image = Image{p.x, p.y, piece.offset};
    }
  }

  bool is_point() const { return !(m_piece.depth > 0); }

  // The image of straight paths; the ends of the interval, with the distances there.
  const Image& image() const { return m_image; }
  const Image& begin() const { return m_begin; }
  const Image& end() const { return m_end; }
  const Distance_piece<FT>& piece() const { return m_piece; }

  // Returns the point from which the last straight piece of the path to p comes.
  const Image& image_at(const Point& p) const
  {
    if(is_point())
      return m_image;
    const FT t = crossing(p);
    return t < m_piece.begin ? m_begin : t > m_piece.end ? m_end : m_image;
  }

  // Returns the length of the path to p. The function is continuous in the face.
  FT at(const Point& p) const { return image_at(p).distance_to(p); }

  // Returns another point on the ray that leads through a point of the side, in front of it.
  Point behind(const Image& on_side) const
  {
    return m_image.is_at_infinity() ? Point{FT(on_side.x - m_image.x), FT(on_side.y - m_image.y)}
                                    : Point{m_image.x, m_image.y};
  }

  // Returns the abscissa at which the line from the image to p crosses the side. A point beyond the side, by rounding,
  // counts as one on it. Requires: !is_point().
  FT crossing(const Point& p) const
  {
    const FT dx = p.x - m_frame.origin.x, dy = p.y - m_frame.origin.y;
    const FT x = dx * m_frame.tx + dy * m_frame.ty, y = (std::max)(FT(dy * m_frame.tx - dx * m_frame.ty), FT(0));
    if(m_piece.is_linear)
      return x - y * (m_piece.x / m_piece.depth);
    return (m_piece.x * y + x * m_piece.depth) / (y + m_piece.depth);
  }

  // Returns how far two families are from having the same image, in the same frame: no distance in the face differs by
  // more. (The scale of an image at infinity is larger than the coordinates there.)
  FT difference(const Path_family& other) const
  {
    using std::abs;
    if(m_image.is_at_infinity() != other.m_image.is_at_infinity())
      return std::numeric_limits<FT>::infinity();
    if(m_image.is_at_infinity())
      return norm<FT>(m_image.x - other.m_image.x, m_image.y - other.m_image.y) * m_image.scale
           + abs(m_image.weight - other.m_image.weight);
    return distance(Point{m_image.x, m_image.y}, Point{other.m_image.x, other.m_image.y})
         + abs(m_image.weight - other.m_image.weight);
  }

private:
  Image image_at_infinity(const FT& size) const
  {
    using std::abs;
    const FT x = m_piece.x * m_frame.tx - m_piece.depth * m_frame.ty;
    const FT y = m_piece.x * m_frame.ty + m_piece.depth * m_frame.tx;
    const Point& o = m_frame.origin;
    return Image{x, y, FT(m_piece.offset - (x * o.x + y * o.y)),
                 FT(abs(m_piece.offset) + 2 * size)};
  }

  Image image_on_side(const FT& t) const
  {
    const Point p = m_frame.point(t, FT(0));
    return Image{p.x, p.y, m_piece.at(t)};
  }

  Distance_piece<FT> m_piece;
  Side_frame<FT> m_frame;
  Image m_image, m_begin, m_end;
};

// Use: start_windows() or start_function() for a face, then the queries. The families are copied. A start takes time
// linear in their number, and so does each query.
template <typename FT_>
class Face_paths
{
public:
  using FT = FT_;
  using Point = Planar_point<FT>;
  using Family = Path_family<FT>;
  using Image = Additively_weighted_point<FT>;

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Reads the paths that a propagation has found. `site_of(v)` is a number for the source of a vertex, and
  // `site_of_strip(strip)` for that of a strip.
  template <typename SiteOf, typename SiteOfStrip>
  void start_windows(const Intrinsic_mesh<FT>& mesh, const Vertex_distance_field<FT>& field,
                     const Edge_window_field<FT>& windows, const Edge_strip_field<FT>& strips, SiteOf site_of,
                     SiteOfStrip site_of_strip, Face_id f)
  {
    start(mesh, f);
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Vertex_id v = mesh.face(f).vertex[k];
      if(field.distance[v] < infinity())
        add(Family(Image{m_corner[k].x, m_corner[k].y, field.distance[v]}), 3 + k, site_of(v));
    }
    for_each_side(mesh, f, [&](unsigned int k, const Side_frame<FT>& frame)
    {
      windows.for_each_window(halfedge_of(f, k), [&](const Kept_window<FT>& w)
      {
        add(Family({w.begin, w.end, w.image_x, w.image_depth, field.distance[w.root]}, frame, m_size), k,
            site_of(w.root));
      });
      strips.for_each_strip(halfedge_of(f, k), [&](const Strip<FT>& s)
      { add(Family(piece_of_strip(s), frame, m_size), k, site_of_strip(s)); });
    });
  }

  // Reads the function on the edges. Its least value plus the length of the way from there, over all points of the
  // border of a face, is a lower bound of the distance of each point in the face, if the function is one on the border.
  // Sites are unknown. Requires: the function has been made; no source is inside the face.
  void start_function(const Lower_bound_function<FT>& function, Face_id f)
  {
    start(function.mesh(), f);
    for_each_side(function.mesh(), f, [&](unsigned int k, const Side_frame<FT>& frame)
    {
      function.read(halfedge_of(f, k), false, m_pieces);
      for(const Distance_piece<FT>& piece : m_pieces)
        add(Family(piece, frame, m_size), k, none);
    });
  }

  const std::vector<Family>& families() const { return m_families; }
  std::size_t site(std::size_t i) const { return m_sites[i]; }

  // Returns the family with the shortest path to p of those from a site, or of all if the site is `none`; the first of
  // equal ones. Returns `none` if there is none.
  std::size_t nearest(const Point& p, std::size_t site = none) const
  {
    std::size_t best = none;
    FT least = infinity();
    for(std::size_t i = 0; i < m_families.size(); ++i)
    {
      if(site != none && m_sites[i] != site)
        continue;
      const FT d = m_families[i].at(p);
      if(d < least)
      {
        best = i;
        least = d;
      }
    }
    return best;
  }

  // Returns the length of the shortest path to p, infinity if there is none.
  FT at(const Point& p) const
  {
    const std::size_t i = nearest(p);
    return i == none ? infinity() : m_families[i].at(p);
  }

  // Returns an upper bound of how much longer than straight from image i the paths to the points of an arc are, between
  // two points of it. The directions from a focus turn in one sense along a bisector, and along a segment. So the
  // points of the side through which straight paths lead form an interval. It has to be covered by intervals of
  // families with this image; a path around the end of a gap is longer by at most twice the width of the gap.
  FT detour(std::size_t i, const Point& first, const Point& last) const
  {
    const Family& family = m_families[i];
    if(family.is_point())
      return FT(0);
    FT begin = family.crossing(first), end = family.crossing(last), error = 0;
    if(end < begin)
      std::swap(begin, end);
    if(begin >= family.piece().begin && end <= family.piece().end)
      return FT(0);
    m_cover.clear();
    for(std::size_t j = 0; j < m_families.size(); ++j)
      if(m_sides[j] == m_sides[i] && m_sites[j] == m_sites[i] && !m_families[j].is_point())
        if(m_families[j].difference(family)
           <= Tolerance<FT>::tie() * (family.image().distance_to(first) + family.image().scale))
        {
          error = (std::max)(error, m_families[j].difference(family));
          m_cover.emplace_back(m_families[j].piece().begin, m_families[j].piece().end);
        }
    std::sort(m_cover.begin(), m_cover.end());
    FT gap = 0;
    for(const std::pair<FT, FT>& interval : m_cover)
      if(interval.second > begin && begin < end)
      {
        gap = (std::max)(gap, (std::min)(interval.first, end) - begin);
        begin = interval.second;
      }
    return error + 2 * (std::max)(gap, end - begin);
  }

  // Returns by how much the distance that is claimed for the points of an arc exceeds the length of a path, at worst; a
  // negative number if it does nowhere. Between the points where the arc crosses the lines of sight through the ends of
  // an interval, a family has one image, which is compared where Arc_piece says.
  FT excess_along(const Arc_piece<FT>& arc) const
  {
    FT excess = -infinity();
    for(const Family& family : m_families)
    {
      const auto compare = [&](const Point& p) { excess = (std::max)(excess, FT(arc.value(p) - family.at(p))); };
      compare(arc.first());
      compare(arc.last());
      arc.for_each_extremum(family.image(), compare);
      if(family.is_point())
        continue;
      for(const Image& end : {family.begin(), family.end()})
      {
        arc.for_each_extremum(end, compare);
        arc.for_each_crossing(family.behind(end), Point{end.x, end.y}, compare);
      }
    }
    return excess;
  }

  // Returns how far an arc leaves the face; not positive if it does not.
  FT leaving(const Arc_piece<FT>& arc) const
  {
    FT leaving = -infinity();
    for(unsigned int k = 0; k < 3; ++k)
    {
      const Point a = m_corner[k], b = m_corner[next_corner(k)];
      const FT length = distance(a, b);
      if(length > 0)
        arc.for_each_extremum_from_line(a, b, [&](const Point& p)
        {
          leaving = (std::max)(leaving, FT(((b.y - a.y) * (p.x - a.x) - (b.x - a.x) * (p.y - a.y)) / length));
        });
    }
    return leaving;
  }

private:
  static FT infinity() { return std::numeric_limits<FT>::infinity(); }

  void start(const Intrinsic_mesh<FT>& mesh, Face_id f)
  {
    m_families.clear();
    m_sides.clear();
    m_sites.clear();
    m_corner = layout_of_face(mesh.face(f));
    m_size = longest_side(mesh.face(f));
  }

  void add(const Family& family, unsigned int side, std::size_t site)
  {
    m_families.push_back(family);
    m_sides.push_back(side);
    m_sites.push_back(site);
  }

  // A side without length has no windows, and the function has no pieces there.
  template <typename Visit>
  void for_each_side(const Intrinsic_mesh<FT>& mesh, Face_id f, Visit visit) const
  {
    for(unsigned int k = 0; k < 3; ++k)
      if(mesh.face(f).length[k] > 0)
        visit(k, Side_frame<FT>(m_corner[k], m_corner[next_corner(k)], mesh.face(f).length[k]));
  }

  std::array<Point, 3> m_corner;
  FT m_size = 0; // of the face
  std::vector<Family> m_families;
  std::vector<unsigned int> m_sides; // of the families; from 3 on the corners
  std::vector<std::size_t> m_sites;  // of the families
  std::vector<Distance_piece<FT>> m_pieces;            // reused memory
  mutable std::vector<std::pair<FT, FT>> m_cover;      // the same
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_CERTIFICATE_FACE_PATHS_H
