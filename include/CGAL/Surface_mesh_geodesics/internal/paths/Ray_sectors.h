// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_RAY_SECTORS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_RAY_SECTORS_H

// The directions in which straight paths leave their source, for all vertices: with the work of a few faces for each
// path, although a path may cross many. Where the surface is flat, paths are long, and their neighbors run through the
// same faces. So what one path has found out about an edge serves those that cross the edge later.
//
// A sector is a part of an edge that rays from one source reach through the same unfolded faces. It has the image of
// the source in the frame of the edge, and how this frame is turned against the faces at the source. A ray to a point
// of the sector leaves the source in the direction from the image to the point, turned by that.
//
// A path is followed back from edge to edge, as Straight_piece does, until it meets a sector with its image, or the
// source. On the way back each edge that it has crossed gets a sector: the part that the sector of the edge before
// shows. At a flat vertex, sectors on both sides with the same image are one.
//
// Why this is right. Between two rays of a sector, rays run through the same faces, and no vertex lies between them but
// flat ones. A path that crosses an edge at a point of a sector, towards the image of the sector, is the ray to that
// point: a straight line is determined by a point and its direction there. Sectors are joined at a vertex only if its
// angle is a full turn; then the last ray on its left and the last one on its right arrive at it in the same direction,
// as their images agree, and are one ray. So curvature enclosed by two rays cannot be overlooked, wherever it lies.
//
// A ray that passes within rounding of a vertex that is not flat is left to Straight_piece, which lets the path run
// through the vertex. There may be a second shortest path to it, and the direction should be that of the path that
// users get.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Angle_sum.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// All lengths are in the unit of the mesh. An object is used by one thread; mesh and field are referred to, and do not
// change. Memory: at most eight sectors for each face; further paths are followed to their ends.
template <typename FT>
class Ray_sectors
{
  using Mesh = Intrinsic_mesh<FT>;
  using Field = Vertex_distance_field<FT>;

public:
  // A ray leaves the source of `halfedge` at an angle from it, counterclockwise, which may be negative. If the halfedge
  // is null_id, nothing was found, and the path has to be traced.
  struct Ray
  {
    Halfedge_id halfedge = null_id;
    FT angle = 0;
  };

  // Requires: the field has images, and its run is complete.
  Ray_sectors(const Mesh& mesh, const Field& field)
    : m_mesh(mesh), m_field(field), m_first(4 * mesh.number_of_faces(), none), m_is_flat(mesh.number_of_vertices(), 2)
  {}

  // Returns how the path to v leaves its source. Requires: v is reached, and its path is straight: its root is a
  // source. Takes constant time where other paths have crossed the same edges; otherwise time linear in the number of
  // faces that the path crosses.
  Ray ray_to(Vertex_id v)
  {
    const Vertex_arrival<FT>& arrival = m_field.arrival[v];
    // A piece along an edge has no image; it is short.
    if(arrival.halfedge == null_id || m_mesh.source(arrival.halfedge) == arrival.root
       || m_mesh.target(arrival.halfedge) == arrival.root || m_mesh.opposite(arrival.halfedge) == null_id)
      return {};
    const FT& length = m_mesh.length(arrival.halfedge);
    const Arrival_image<FT>& image = m_field.image[v];
    Crossing first{m_mesh.opposite(arrival.halfedge), length - arrival.abscissa, length - image.x, image.depth};
    const FT reach = reach_of(first);
    if((first.x <= reach && !is_flat(m_mesh.source(first.halfedge)))
       || (length - first.x <= reach && !is_flat(m_mesh.target(first.halfedge))))
      return {};
    std::uint32_t found = sector_of(first, arrival.root);
    if(found == none)
      found = follow(first, arrival.root);
    if(found == none)
      return {};
    const Sector& s = m_sectors[found];
    using std::atan2;
    // From the image to the vertex, not to the edge, which may be next to the source. (The frame of the sector is that
    // of the opposite halfedge, turned by half a turn.)
    const Face_frame<FT> c = m_mesh.face_frame(arrival.halfedge);
    const FT x = image.x - c.apex_x, y = -(image.depth + c.apex_y);
    return {s.halfedge, FT(atan2(FT(s.sine * x + s.cosine * y), FT(s.cosine * x - s.sine * y)))};
  }

private:
  static constexpr std::uint32_t none = null_id;

  // A ray crosses the edge of a halfedge at x; its face lies beyond, towards the image of the source. Invariant:
  // image_y >= 0.
  struct Crossing
  {
    Halfedge_id halfedge;
    FT x, image_x, image_y;
  };

  // The part [low, high] of a halfedge, whose face lies towards the source. (cosine, sine) is the direction of this
  // halfedge, in a frame whose axis is the direction of the halfedge `halfedge` at the source. `next` is another sector
  // of the same halfedge.
  struct Sector
  {
    FT image_x, image_y, cosine, sine, low, high;
    Halfedge_id halfedge;
    Vertex_id root;
    std::uint32_t next;
  };

  // The frame of a side of a face, seen from the neighbor, in the frame of the face: the origin, and the axis. The left
  // side leads from the origin of the face to its apex, the right one from the apex to the target.
  struct Side
  {
    Halfedge_id halfedge;
    FT length, x, y, cosine, sine;
  };

  static Side left_side(const Face_frame<FT>& c)
  {
    return {c.left, c.left_length, FT(0), FT(0), FT(c.apex_x / c.left_length), FT(c.apex_y / c.left_length)};
  }

  static Side right_side(const Face_frame<FT>& c)
  {
    return {c.right, c.right_length, c.apex_x, c.apex_y, FT(c.apex_rest / c.right_length),
            FT(-c.apex_y / c.right_length)};
  }

  // Moves a point from the frame of the face to that of a side. The image has a positive y there as long as it lies
  // beyond the side, and points of the face have a negative one.
  static void to_side(const Side& s, FT& x, FT& y)
  {
    const FT dx = x - s.x, dy = y - s.y;
    x = dx * s.cosine + dy * s.sine;
    y = dy * s.cosine - dx * s.sine;
  }

  // Is a number within rounding of another one, on the scale of a ray? The tolerance is that of angles at vertices:
  // what counts as flat there may turn an image by so much.
  static bool is_near(const FT& a, const FT& b, const FT& scale)
  {
    using std::abs;
    return abs(FT(a - b)) <= 4 * Tolerance<FT>::angle() * scale;
  }

  // How near a ray may come to a vertex that is not flat: farther than Straight_piece asks for, as a vertex near the
  // source moves the end of a sector by many times its own distance from the ray.
  FT reach_of(const Crossing& c) const
  {
    using std::abs;
    return 256 * Tolerance<FT>::sideways() * (FT(abs(FT(c.image_x - c.x))) + c.image_y + m_mesh.length(c.halfedge));
  }

  // Returns a sector of the crossing, with its image and around its point; none if there is no such sector. A ray near
  // the end of a sector passes a vertex that is not flat, unless the edge ends there.
  std::uint32_t sector_of(const Crossing& c, Vertex_id root) const
  {
    const FT reach = reach_of(c);
    for(std::uint32_t i = m_first[c.halfedge]; i != none; i = m_sectors[i].next)
    {
      const Sector& s = m_sectors[i];
      if((s.low <= 0 || s.low + reach <= c.x) && (c.x + reach <= s.high || s.high >= m_mesh.length(c.halfedge))
         && has_image(s, c, root))
        return i;
    }
    return none;
  }

  // Images of other sources, and of the same source behind other vertices, lie elsewhere.
  bool has_image(const Sector& s, const Crossing& c, Vertex_id root) const
  {
    using std::abs;
    const FT scale = FT(abs(c.image_x)) + c.image_y + m_mesh.length(c.halfedge);
    return s.root == root && is_near(s.image_x, c.image_x, scale) && is_near(s.image_y, c.image_y, scale);
  }

  // Follows a ray to a sector or to its source, and makes sectors of all edges that it crosses. Returns that of the
  // first one; none if rounding hides the way.
  std::uint32_t follow(const Crossing& first, Vertex_id root)
  {
    m_way.assign(1, first);
    std::uint32_t sector = none;
    for(std::size_t i = 0; i <= m_mesh.most_faces_crossed() && sector == none; ++i)
    {
      const Face_frame<FT> c = m_mesh.face_frame(m_way.back().halfedge);
      Crossing next;
      if(c.apex == root)
      {
        sector = first_sector(m_way.back(), c, root);
        break;
      }
      if(!cross(m_way.back(), c, next))
        return none;
      m_way.push_back(next);
      sector = sector_of(next, root);
    }
    for(std::size_t i = m_way.size() - 1; i-- > 0 && sector != none;)
      sector = further_sector(m_way[i], m_way[i + 1].halfedge, sector, root);
    return sector;
  }

  // Moves through the face of a halfedge, to the side on which the ray leaves it. Returns false at a border, next to a
  // vertex that is not flat, and if rounding has moved the image to this side of that edge.
  bool cross(const Crossing& here, const Face_frame<FT>& c, Crossing& next)
  {
    using std::abs;
    const FT ray_x = here.image_x - here.x;
    const FT area = (c.apex_x - here.x) * here.image_y - c.apex_y * ray_x;
    const bool is_left = area > 0;
    if(FT(abs(area)) <= reach_of(here) * (FT(abs(ray_x)) + here.image_y) && !is_flat(c.apex))
      return false;
    if((is_left ? c.left : c.right) == null_id || !(c.left_length > 0) || !(c.right_length > 0))
      return false;
    const Side side = is_left ? left_side(c) : right_side(c);
    next = {side.halfedge, here.x, here.image_x, here.image_y};
    FT y = 0;
    to_side(side, next.x, y);
    to_side(side, next.image_x, next.image_y);
    if(!(next.image_y > 0) || !(y <= 0))
      return false;
    const FT x = next.x - y * ((next.image_x - next.x) / (next.image_y - y));
    next.x = (std::min)((std::max)(x, FT(0)), m_mesh.length(next.halfedge));
    return true;
  }

  // The sector of an edge whose face has the source as its apex: the whole edge. None if the image lies elsewhere: the
  // ray passes the source, or rounding hides the way.
  std::uint32_t first_sector(const Crossing& here, const Face_frame<FT>& c, Vertex_id root)
  {
    const FT scale = c.length + c.left_length;
    if(!(c.left_length > 0) || !is_near(here.image_x, c.apex_x, scale) || !is_near(here.image_y, c.apex_y, scale))
      return none;
    return put(here, {here.image_x, here.image_y, FT(-c.apex_x / c.left_length), FT(c.apex_y / c.left_length), FT(0),
                      c.length, previous_halfedge(here.halfedge), root, none});
  }

  // The sector of an edge that rays reach through another edge of its face, of which a sector is known; at a flat apex,
  // through the third edge, too, if its sector ends there and has the same image. None if rounding hides it.
  std::uint32_t further_sector(const Crossing& here, Halfedge_id through, std::uint32_t known, Vertex_id root)
  {
    const Face_frame<FT> c = m_mesh.face_frame(here.halfedge);
    const bool is_left = through == c.left;
    const Side side = is_left ? left_side(c) : right_side(c), other = is_left ? right_side(c) : left_side(c);
    const Sector s = m_sectors[known];
    FT low = shadow(here, side, s.low), high = shadow(here, side, s.high);
    // The last ray on one side of the apex meets the first one on its other side.
    const bool ends_at_apex = is_left ? s.high >= m_mesh.length(through) : s.low <= 0;
    const std::uint32_t joined = ends_at_apex && other.halfedge != null_id && is_flat(c.apex)
                                   ? sector_from_apex(here, other, is_left, root)
                                   : std::uint32_t(none);
    if(joined != none)
      (is_left ? high : low) = shadow(here, other, is_left ? m_sectors[joined].high : m_sectors[joined].low);
    low = (std::max)((std::min)(low, here.x), FT(0));
    high = (std::min)((std::max)(high, here.x), m_mesh.length(here.halfedge));
    if(!(low <= high))
      return none;
    return put(here, {here.image_x, here.image_y, FT(s.cosine * side.cosine + s.sine * side.sine),
                      FT(s.sine * side.cosine - s.cosine * side.sine), low, high, s.halfedge, root, none});
  }

  // Where the ray through the point t of a side meets the edge of the crossing. At an end that both have in common, it
  // is that end exactly, so that sectors reach as far as the edge does. (Only then they can be joined at a vertex.)
  FT shadow(const Crossing& here, const Side& side, const FT& t) const
  {
    const bool is_left = side.x == 0 && side.y == 0;
    if(is_left && t <= 0)
      return 0;
    if(!is_left && t >= m_mesh.length(side.halfedge))
      return m_mesh.length(here.halfedge);
    const FT x = side.x + side.cosine * t, y = side.y + side.sine * t;
    return here.image_y > y ? FT(here.image_x + (x - here.image_x) * (here.image_y / (here.image_y - y))) : here.x;
  }

  // Returns the sector of a side that begins at the apex, which is the origin of the right side and the end of the left
  // one, with the image of the crossing; none if there is none.
  std::uint32_t sector_from_apex(const Crossing& here, const Side& side, bool is_right_side, Vertex_id root) const
  {
    Crossing c{side.halfedge, 0, here.image_x, here.image_y};
    to_side(side, c.image_x, c.image_y);
    c.x = is_right_side ? FT(0) : m_mesh.length(side.halfedge);
    return c.image_y > 0 ? sector_of(c, root) : none;
  }

  // Is the angle of a vertex a full turn, so that rays run past it on both sides as if it were not there?
  bool is_flat(Vertex_id v)
  {
    if(m_is_flat[v] == 2)
    {
      Angle_sum<FT> sum;
      bool is_on_border = false;
      m_mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
      {
        const auto direction = angle_direction(m_mesh.face(face_of(h)), index_in_face(h));
        sum.add(direction.first, direction.second);
        is_on_border = is_on_border || m_mesh.opposite(h) == null_id
                    || m_mesh.opposite(previous_halfedge(h)) == null_id;
      });
      m_is_flat[v] = !is_on_border && !m_mesh.has(v, Mesh::PSEUDO_SOURCE) && sum.is_full() ? 1 : 0;
    }
    return m_is_flat[v] == 1;
  }

  // Adds a sector to those of an edge, or joins it with one that it overlaps by more than a point: at a point there may
  // be a vertex that is not flat between them, and on symmetric surfaces their images may agree nevertheless. If there
  // is no more room, it replaces the last one, which serves this path only.
  std::uint32_t put(const Crossing& here, const Sector& s)
  {
    const FT reach = reach_of(here);
    for(std::uint32_t i = m_first[here.halfedge]; i != none; i = m_sectors[i].next)
    {
      Sector& known = m_sectors[i];
      if(known.low + reach < s.high && s.low + reach < known.high && has_image(known, here, s.root))
      {
        known.low = (std::min)(known.low, s.low);
        known.high = (std::max)(known.high, s.high);
        return i;
      }
    }
    const std::size_t most = 2 * m_first.size();
    if(m_sectors.size() > most)
      m_sectors.back() = s;
    else
      m_sectors.push_back(s);
    const std::uint32_t place = static_cast<std::uint32_t>(m_sectors.size() - 1);
    if(m_sectors.size() <= most)
    {
      m_sectors[place].next = m_first[here.halfedge];
      m_first[here.halfedge] = place;
    }
    return place;
  }

  const Mesh& m_mesh;
  const Field& m_field;
  std::vector<std::uint32_t> m_first; // by halfedge
  std::vector<char> m_is_flat;        // by vertex; 2: not known yet
  std::vector<Sector> m_sectors;
  std::vector<Crossing> m_way;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PATHS_RAY_SECTORS_H
