// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_FACE_PARTS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_FACE_PARTS_H

// The parts into which sources divide faces of the first mesh: which part holds a point, and where a point of a part is
// in the whole face.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Location_in_part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A part of a face of the first mesh, with the coordinates of its corners there.
template <typename FT>
struct Face_part
{
  Face_id whole;
  std::array<Barycentric<FT>, 3> corner;
};

// A face that is not in the tables has not been divided: it is its own only part. Queries take expected constant time.
// part_with() looks at all parts of a face if these are few. Else it begins at a part near the point, and walks from
// part to part across the edge that has the point farthest beyond it (Devillers, Pion and Teillaud, 2002). Where parts
// are those of a Delaunay triangulation (Source_insertion::flip_around()), that is O(n^(1/3)) steps for n parts that
// lie evenly; where rounding stops the walk, it looks at all parts.
//
// Invariants, between splits (Source_insertion.h fills the tables): the parts of a face cover it and do not overlap, up
// to the rounding of the coordinates of their corners; one of them has the index of the whole face. A corner on an edge
// of the whole face has an exact zero there, which find_on_whole_edge() relies on.
template <typename FT>
class Face_parts
{
public:
  // Returns the part of face f of the first mesh that contains the point b; b become its coordinates there, snapped to
  // the edges and corners of that part (snap_coordinates()). If f has not been divided, b stay as they are.
  // Requires: the mesh is the refined one.
  Face_id part_with(const Intrinsic_mesh<FT>& mesh, Face_id f, Barycentric<FT>& b) const
  {
    const auto parts = m_parts.find(f);
    if(parts == m_parts.end())
      return f;
    const Barycentric<FT> whole = b;
    Face_id part = null_id;
    if(parts->second.size() > few)
      part = walk_to_part(mesh, parts->second, whole, b);
    if(part == null_id)
      part = find_part(parts->second, whole, b);
    snap_coordinates(b);
    return part;
  }

  // Returns the face of the first mesh of which f is a part.
  Face_id whole(Face_id f) const
  {
    const auto part = m_part_of.find(f);
    return part == m_part_of.end() ? f : part->second.whole;
  }

  // Returns the face of the first mesh of which f is a part; the coordinates b in f become coordinates there.
  Face_id coordinates_in_whole(Face_id f, Barycentric<FT>& b) const
  {
    const auto part = m_part_of.find(f);
    if(part == m_part_of.end())
      return f;
    b = combination(part->second.corner, b);
    return part->second.whole;
  }

  // Returns the parts of a face of the first mesh, null if it has not been divided.
  const std::vector<Face_id>* parts_of(Face_id whole) const
  {
    const auto parts = m_parts.find(whole);
    return parts == m_parts.end() ? nullptr : &parts->second;
  }

  // Returns the corners of f in its whole face, or null if the face has not been divided.
  const Face_part<FT>* find_part_of(Face_id f) const
  {
    const auto part = m_part_of.find(f);
    return part == m_part_of.end() ? nullptr : &part->second;
  }

  // Returns whether the point at fraction t of halfedge h is on an edge of the first mesh; if so, h and t become that
  // halfedge and the fraction there. Decided for the halfedge as a whole: both of its ends are on that edge. (An edge
  // of a part that only ends on an edge of the whole face does not count, even at its end.)
  bool find_on_whole_edge(Halfedge_id& h, FT& t) const
  {
    const auto it = m_part_of.find(face_of(h));
    if(it == m_part_of.end())
      return true;
    const Barycentric<FT>& a = it->second.corner[index_in_face(h)];
    const Barycentric<FT>& b = it->second.corner[next_corner(index_in_face(h))];
    for(unsigned int k = 0; k < 3; ++k)
    {
      const unsigned int opposite = previous_corner(k); // of the edge from corner k
      if(a[opposite] == 0 && b[opposite] == 0)
      {
        h = halfedge_of(it->second.whole, k);
        t = (1 - t) * a[next_corner(k)] + t * b[next_corner(k)];
        return true;
      }
    }
    return false;
  }

  // Returns whether the edge of two opposite halfedges is inside of a face of the first mesh: both sides are parts of
  // it, and agree about the coordinates of the edge. (They do not where the face is glued to itself.)
  bool is_inside_whole(Halfedge_id h, Halfedge_id o) const
  {
    const Face_part<FT>*s = find_part_of(face_of(h)), *t = find_part_of(face_of(o));
    const unsigned int i = index_in_face(h), j = index_in_face(o);
    return s != nullptr && t != nullptr && s->whole == t->whole && s->corner[i] == t->corner[next_corner(j)]
        && s->corner[next_corner(i)] == t->corner[j];
  }

  // Returns the corners of f in its whole face. A face that has not been divided enters the tables.
  const Face_part<FT>& part(Face_id f)
  {
    const auto it = m_part_of.find(f);
    if(it != m_part_of.end())
      return it->second;
    m_parts[f].push_back(f);
    return m_part_of[f]
         = Face_part<FT>{f, {Barycentric<FT>{1, 0, 0}, Barycentric<FT>{0, 1, 0}, Barycentric<FT>{0, 0, 1}}};
  }

  // Replaces the corners of the part f.
  void set(Face_id f, const Face_part<FT>& p) { m_part_of[f] = p; }

  // Adds f to the parts of its whole face.
  void add(Face_id f, const Face_part<FT>& p)
  {
    m_parts[p.whole].push_back(f);
    set(f, p);
  }

  // A face with more parts is crowded: the time of looking at all of them would count.
  static constexpr std::size_t few = 32;

  void clear()
  {
    m_parts.clear();
    m_part_of.clear();
  }

private:
  // Does what find_part() does, by a walk. Returns null_id, with `local` as it was, if the walk ends where nothing is
  // known, or leaves the face by rounding, or turns in a circle. Where the point is on an edge between two parts, the
  // one that knows its coordinates better is returned.
  Face_id walk_to_part(const Intrinsic_mesh<FT>& mesh, const std::vector<Face_id>& parts, const Barycentric<FT>& b,
                       Barycentric<FT>& local) const
  {
    Face_id s = part_near(parts, b);
    for(std::size_t steps = 0; steps < parts.size(); ++steps)
    {
      Location_in_part<FT> location(m_part_of.at(s).corner, b);
      if(!location.is_known())
        return null_id;
      location.snap();
      const Barycentric<FT>& c = location.coordinates();
      const unsigned int k = static_cast<unsigned int>(std::min_element(c.begin(), c.end()) - c.begin());
      const Face_id next = part_across(mesh, halfedge_of(s, next_corner(k)));
      if(!(c[k] < 0))
      {
        if(std::count(c.begin(), c.end(), FT(0)) > 1 && location.rounding() > Tolerance<FT>::location())
          return null_id; // other parts at this corner may know better
        local = c;
        return c[k] == 0 && next != null_id && knows_better(next, b, location.rounding(), local) ? next : s;
      }
      if(next == null_id)
        return null_id;
      s = next;
    }
    return null_id;
  }

  // For points on the edge between two parts. Returns whether a part contains b and knows its coordinates with less
  // rounding than given; if so, sets them.
  bool knows_better(Face_id s, const Barycentric<FT>& b, const FT& rounding, Barycentric<FT>& local) const
  {
    Location_in_part<FT> location(m_part_of.at(s).corner, b);
    if(!location.is_known() || !(location.rounding() < rounding))
      return false;
    location.snap();
    if(location.least_coordinate() < 0)
      return false;
    local = location.coordinates();
    return true;
  }

  // Returns a part for a walk to b to begin at, without a look at all parts: of about n^(1/3) parts, and of the last
  // one, the one whose first corner is nearest in coordinates. (Points are often inserted or asked for near the one
  // before, in a part that is new.)
  Face_id part_near(const std::vector<Face_id>& parts, const Barycentric<FT>& b) const
  {
    const std::size_t stride = static_cast<std::size_t>(std::pow(static_cast<double>(parts.size()), 2. / 3));
    Face_id best = parts.back();
    FT smallest = std::numeric_limits<FT>::infinity();
    const auto try_part = [&](Face_id s)
    {
      const Barycentric<FT>& c = m_part_of.at(s).corner[0];
      const FT x = c[0] - b[0], y = c[1] - b[1], square = x * x + y * y;
      if(square < smallest)
      {
        smallest = square;
        best = s;
      }
    };
    try_part(best);
    for(std::size_t i = 0; i < parts.size(); i += stride)
      try_part(parts[i]);
    return best;
  }

  // Returns the part of the same face on the other side of a halfedge, null_id if there is none: the halfedge is on the
  // border of the whole face, where a walk that leads out has met rounding.
  Face_id part_across(const Intrinsic_mesh<FT>& mesh, Halfedge_id h) const
  {
    const Halfedge_id o = mesh.opposite(h);
    return o != null_id && is_inside_whole(h, o) ? face_of(o) : null_id;
  }

  // Returns the part that contains b, and sets its coordinates there.
  //
  // Between points that are nearly on a line there are parts as narrow as rounding, in which almost any point may seem
  // to be. If such a part is found, another part may know the coordinates better, and have the point outside by
  // rounding only. Then the point moves to the border of that part.
  Face_id find_part(const std::vector<Face_id>& parts, const Barycentric<FT>& b, Barycentric<FT>& local) const
  {
    FT rounding;
    const Face_id part = best_part(parts, b, false, local, rounding);
    if(!(rounding > Tolerance<FT>::narrow_part()))
      return part;
    const Face_id better = best_part(parts, b, true, local, rounding);
    for(FT& c : local)
      c = (std::max)(c, FT(0));
    const FT sum = local[0] + local[1] + local[2];
    for(FT& c : local)
      c /= sum;
    return better;
  }

  // Does so. If several parts contain b up to rounding, the one where no coordinate is negative, or the least one is
  // largest, wins; then the one where the coordinates are known best; then the first one. With `allows_rounding`, no
  // coordinate counts as negative that may be positive by rounding. Sets the error bound of the coordinates.
  //
  // Narrow parts, where nothing is known, are passed over. Some part is wide enough: together they cover the face,
  // whose area in its own coordinates is that of the unit triangle. `local` is set only by such a part.
  Face_id best_part(const std::vector<Face_id>& parts, const Barycentric<FT>& b, bool allows_rounding,
                    Barycentric<FT>& local, FT& best_rounding) const
  {
    Face_id best = parts.front();
    FT best_minimum = -std::numeric_limits<FT>::infinity();
    best_rounding = -best_minimum;
    for(Face_id s : parts)
    {
      Location_in_part<FT> location(m_part_of.at(s).corner, b);
      if(!location.is_known())
        continue;
      location.snap();
      const FT least = location.least_coordinate() + (allows_rounding ? location.rounding() : FT(0));
      const FT minimum = (std::min)(FT(0), least);
      if(!(minimum > best_minimum || (minimum == best_minimum && location.rounding() < best_rounding)))
        continue;
      best_minimum = minimum;
      best_rounding = location.rounding();
      best = s;
      local = location.coordinates();
    }
    return best;
  }

  // For each divided face of the first mesh its parts, the first of which has the index of the face; for each part its
  // corners there.
  std::unordered_map<Face_id, std::vector<Face_id>> m_parts;
  std::unordered_map<Face_id, Face_part<FT>> m_part_of;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_FACE_PARTS_H
