// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCE_INSERTION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCE_INSERTION_H

// A source inside a face or on an edge becomes a vertex (thesis, 3.1 and figure 3.1): the intrinsic
// mesh is refined around it, and the refinement can be undone. The surface stays the same, and the
// new vertices are flat.
//
// Why not simply start windows on the edges around the source? The order of windows (Window.h) is
// that of sequences of edges. A window that crosses the face of the source may pass the source on
// either side, and its edge sequence tells on which side only if the source is a vertex.

#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Place_in_part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

template <typename FT_>
class Source_insertion
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Face = Intrinsic_face<FT>;
  using Barycentric = std::array<FT, 3>;

  explicit Source_insertion(Mesh& mesh)
    : m_mesh(mesh), m_number_of_vertices(mesh.number_of_vertices()),
      m_number_of_faces(mesh.number_of_faces())
  {}

  // are b the coordinates of a point of a triangle, up to rounding?
  static bool is_valid(const Barycentric& b)
  {
    using std::abs;
    const FT tolerance = Tolerance<FT>::location();
    for(const FT& x : b)
      if(!(x >= -tolerance) || !(x <= 1 + tolerance))
        return false;
    return abs(FT(b[0] + b[1] + b[2] - 1)) <= tolerance;
  }

  // sets coordinates that are nearly zero to zero, and their sum to one.
  static void snap(Barycentric& b)
  {
    FT sum = 0;
    for(FT& x : b)
    {
      if(x <= Tolerance<FT>::barycentric())
        x = 0;
      sum = sum + x;
    }
    for(FT& x : b)
      x = x / sum;
  }

  // the part of face f (of the mesh as it was at first) with the point that has the coordinates b,
  // which become those in the part.
  Face_id part_with(Face_id f, Barycentric& b) const
  {
    const auto parts = m_parts.find(f);
    if(parts == m_parts.end())
      return f;
    const Barycentric whole = b;
    const Face_id part = find_part(parts->second, whole, b);
    snap(b);
    return part;
  }

  // the face of the first mesh of which f is a part.
  Face_id whole(Face_id f) const
  {
    const auto part = m_part_of.find(f);
    return part == m_part_of.end() ? f : part->second.whole;
  }

  // turns the coordinates of a point of f into those in the face of the first mesh of which f is a part,
  // which is returned.
  Face_id coordinates_in_whole(Face_id f, Barycentric& b) const
  {
    const auto part = m_part_of.find(f);
    if(part == m_part_of.end())
      return f;
    b = combination(part->second.corner, b);
    return part->second.whole;
  }

  // The point at t (from 0 to 1) of a halfedge of the mesh as it is: if it is on an edge of the first
  // mesh, h and t become the halfedge and the place there. Returns whether it is.
  bool find_on_whole_edge(Halfedge_id& h, FT& t) const
  {
    const auto it = m_part_of.find(face_of(h));
    if(it == m_part_of.end())
      return true;
    const Barycentric& a = it->second.corner[index_in_face(h)];
    const Barycentric& b = it->second.corner[next_corner(index_in_face(h))];
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

  // returns the vertex at the point of face f (of the mesh as it was at first) with the coordinates b,
  // which are valid; makes it if there is none. Coordinates that are nearly zero are taken for zero.
  Vertex_id insert(Face_id f, Barycentric b)
  {
    snap(b);
    Barycentric local = b;
    const Face_id s = part_with(f, local);
    unsigned int number_of_zeros = 0, zero = 0;
    for(unsigned int k = 0; k < 3; ++k)
      if(local[k] == 0)
      {
        ++number_of_zeros;
        zero = k;
      }
    if(number_of_zeros == 0)
      return split_face(s, local);
    if(number_of_zeros == 2)
      return m_mesh.face(s).vertex[position_of_one(local)];
    // on the edge opposite to corner `zero`
    const unsigned int k = next_corner(zero);
    if(!(m_mesh.face(s).length[k] > 0))
      return m_mesh.face(s).vertex[k];
    return split_edge(halfedge_of(s, k), local[k], local[next_corner(k)]);
  }

  // takes the mesh as it is for the first one.
  void restart()
  {
    m_number_of_vertices = m_mesh.number_of_vertices();
    m_number_of_faces = m_mesh.number_of_faces();
  }

  // makes the mesh what it was.
  void undo()
  {
    for(; !m_renamed.empty(); m_renamed.pop_back())
      rename(m_renamed.back().vertices, m_renamed.back().to, m_renamed.back().from);
    for(; !m_saved.empty(); m_saved.pop_back())
      m_mesh.face(m_saved.back().first) = m_saved.back().second;
    for(; !m_saved_kinds.empty(); m_saved_kinds.pop_back())
      m_mesh.set_kind(m_saved_kinds.back().first, m_saved_kinds.back().second);
    m_mesh.truncate(m_number_of_vertices, m_number_of_faces);
    m_parts.clear();
    m_part_of.clear();
  }

private:
  struct Vector_2
  {
    FT x, y;
  };

  // A part of a face of the first mesh, with the coordinates of its corners there.
  struct Part
  {
    Face_id whole;
    std::array<Barycentric, 3> corner;
  };

  // What halfedges that leave some vertices were called, and what they are called now.
  struct Renaming
  {
    std::vector<Vertex_id> vertices;
    std::vector<Halfedge_id> from, to;
  };

  // A new face before its edges are ordered: side k leads from vertex k to vertex k+1.
  struct Draft
  {
    std::array<Vertex_id, 3> vertex;
    std::array<Vector_2, 3> side;
    std::array<FT, 3> length;
    std::array<Barycentric, 3> corner;
  };

  static unsigned int position_of_one(const Barycentric& b)
  {
    return static_cast<unsigned int>(std::max_element(b.begin(), b.end()) - b.begin());
  }

  // the part that holds the point b, and the coordinates of b in it. A point that lies in several parts, as far as one
  // can tell, is put into the one where it is known best.
  Face_id find_part(const std::vector<Face_id>& parts, const Barycentric& b, Barycentric& local) const
  {
    Face_id best = parts.front();
    FT best_minimum = -std::numeric_limits<FT>::infinity(), best_rounding = -best_minimum;
    for(Face_id s : parts)
    {
      Place_in_part<FT> place(m_part_of.at(s).corner, b);
      if(!place.is_known())
        continue;
      place.snap();
      const FT minimum = (std::min)(FT(0), place.least_coordinate());
      if(!(minimum > best_minimum || (minimum == best_minimum && place.rounding() < best_rounding)))
        continue;
      best_minimum = minimum;
      best_rounding = place.rounding();
      best = s;
      local = place.coordinates();
    }
    return best;
  }

  // The corners of face f with respect to the whole of which it is a part.
  const Part& part(Face_id f)
  {
    const auto it = m_part_of.find(f);
    if(it != m_part_of.end())
      return it->second;
    m_parts[f].push_back(f);
    return m_part_of[f] = Part{f, {Barycentric{1, 0, 0}, Barycentric{0, 1, 0}, Barycentric{0, 0, 1}}};
  }

  // where the corners of a face are in its layout.
  static std::array<Vector_2, 3> layout(const Face& f)
  {
    return {Vector_2{0, 0}, Vector_2{f.length[0], 0}, Vector_2{f.apex_x, f.apex_y}};
  }

  static Vector_2 difference(const Vector_2& b, const Vector_2& a)
  {
    return Vector_2{FT(b.x - a.x), FT(b.y - a.y)};
  }

  static Vector_2 negated(const Vector_2& a) { return Vector_2{FT(-a.x), FT(-a.y)}; }

  // from corner k to the point with the coordinates b: accurate also where the point is near to it.
  static Vector_2 from_corner(const std::array<Vector_2, 3>& p, const Barycentric& b, unsigned int k)
  {
    const unsigned int i = next_corner(k), j = previous_corner(k);
    const Vector_2 u = difference(p[i], p[k]), v = difference(p[j], p[k]);
    return Vector_2{FT(b[i] * u.x + b[j] * v.x), FT(b[i] * u.y + b[j] * v.y)};
  }

  static Barycentric combination(const std::array<Barycentric, 3>& c, const Barycentric& b)
  {
    Barycentric r;
    for(std::size_t i = 0; i < 3; ++i)
      r[i] = b[0] * c[0][i] + b[1] * c[1][i] + b[2] * c[2][i];
    return r;
  }

  // makes a face of a draft, in place of `f` or at the end if f is null_id; returns the halfedge that
  // is side 0. Its opposites are not set.
  Halfedge_id make_face(const Draft& draft, Face_id whole, Face_id f)
  {
    const unsigned int shift = static_cast<unsigned int>(
      std::min_element(draft.length.begin(), draft.length.end()) - draft.length.begin());
    Face face;
    Part p;
    p.whole = whole;
    for(unsigned int k = 0; k < 3; ++k)
    {
      face.vertex[k] = draft.vertex[(k + shift) % 3];
      face.length[k] = draft.length[(k + shift) % 3];
      p.corner[k] = draft.corner[(k + shift) % 3];
      face.opposite[k] = null_id;
    }
    const Vector_2& base = draft.side[shift];
    const Vector_2 apex = negated(draft.side[(shift + 2) % 3]);
    const FT base_length = norm(base.x, base.y); // length[0] but for rounding, which would rescale the apex
    if(base_length > 0)
    {
      face.apex_x = (base.x * apex.x + base.y * apex.y) / base_length;
      face.apex_y = (std::max)(FT(0), FT((base.x * apex.y - base.y * apex.x) / base_length));
    }
    else
    {
      face.apex_x = face.length[2];
      face.apex_y = 0;
    }
    if(f == null_id)
    {
      f = m_mesh.add_face(face);
      m_parts[whole].push_back(f);
    }
    else
      m_mesh.face(f) = face;
    m_part_of[f] = p;
    return halfedge_of(f, (3 - shift) % 3);
  }

  void save(Face_id f) { m_saved.emplace_back(f, m_mesh.face(f)); }

  void link(Halfedge_id a, Halfedge_id b)
  {
    if(a != null_id)
      m_mesh.face(face_of(a)).opposite[index_in_face(a)] = b;
    if(b != null_id)
      m_mesh.face(face_of(b)).opposite[index_in_face(b)] = a;
  }

  // An edge of a face that is replaced: what it was called, what it is called now.
  struct Kept_edge
  {
    Halfedge_id from, opposite, to;
    Vertex_id source;
  };

  // links the edges that the new faces have from the old ones, and settles the new vertex. Both of two
  // opposite edges are among the kept ones if the faces of both have been replaced.
  void finish_split(Vertex_id v, Halfedge_id leaving, const std::vector<Kept_edge>& kept,
                    Renaming renaming)
  {
    for(const Kept_edge& e : kept)
    {
      Halfedge_id o = e.opposite;
      for(const Kept_edge& other : kept)
        if(other.from == e.opposite)
          o = other.to;
      link(e.to, o);
      renaming.from.push_back(e.from);
      renaming.to.push_back(e.to);
      renaming.vertices.push_back(e.source);
    }
    std::sort(renaming.vertices.begin(), renaming.vertices.end());
    renaming.vertices.erase(std::unique(renaming.vertices.begin(), renaming.vertices.end()),
                            renaming.vertices.end());
    rename(renaming.vertices, renaming.from, renaming.to);
    for(const Vertex_id u : renaming.vertices)
      mark(u, Mesh::REFINED);
    m_renamed.push_back(std::move(renaming));
    m_mesh.set_halfedge(v, leaving);
    mark_near_vertices(v);
  }

  // The vertices around a source become pseudo-sources. Paths that graze them run through a gap between the
  // windows on both sides, whose directions are known with the rounding of the edges around, relative to the
  // distance of the source. A point very near to a vertex makes both degenerate, as an edge of the mesh would.
  void mark_near_vertices(Vertex_id v)
  {
    m_mesh.for_each_halfedge_around(v, [this, v](Halfedge_id h)
    {
      for(const Halfedge_id e : {h, previous_halfedge(h)})
      {
        const Vertex_id u = e == h ? m_mesh.target(e) : m_mesh.source(e);
        mark(u, Mesh::PSEUDO_SOURCE);
        if(m_mesh.length(e) <= Tolerance<FT>::length())
        {
          mark(u, Mesh::DEGENERATE);
          mark(v, Mesh::PSEUDO_SOURCE);
          mark(v, Mesh::DEGENERATE);
        }
      }
    });
  }

  void mark(Vertex_id v, unsigned char kind)
  {
    m_saved_kinds.emplace_back(v, m_mesh.kind(v));
    m_mesh.set_kind(v, static_cast<unsigned char>(m_mesh.kind(v) | kind));
  }

  // The halfedges in `from` are called like those in `to` at the same places.
  void rename(const std::vector<Vertex_id>& vertices, const std::vector<Halfedge_id>& from,
              const std::vector<Halfedge_id>& to)
  {
    for(Vertex_id v : vertices)
      m_mesh.rename_halfedges(v, [&](Halfedge_id h)
      {
        const auto it = std::find(from.begin(), from.end(), h);
        return it == from.end() ? h : to[static_cast<std::size_t>(it - from.begin())];
      });
  }

  // splits a face at an inner point into three.
  Vertex_id split_face(Face_id s, const Barycentric& b)
  {
    const Part whole = part(s);
    const Face old = m_mesh.face(s);
    const Barycentric where = combination(whole.corner, b);
    const std::array<Vector_2, 3> p = layout(old);
    std::array<Vector_2, 3> spoke; // from corner to point
    std::array<FT, 3> spoke_length;
    for(unsigned int k = 0; k < 3; ++k)
    {
      spoke[k] = from_corner(p, b, k);
      spoke_length[k] = norm(spoke[k].x, spoke[k].y);
    }
    save_with_neighbours(s);
    const Vertex_id v = m_mesh.add_flat_vertex(null_id);
    std::array<Halfedge_id, 3> made; // made[k] is the old edge k
    std::vector<Kept_edge> kept;
    for(unsigned int k = 0; k < 3; ++k)
    {
      const unsigned int k1 = next_corner(k);
      Draft d;
      d.vertex = {old.vertex[k], old.vertex[k1], v};
      d.side = {difference(p[k1], p[k]), spoke[k1], negated(spoke[k])};
      d.length = {old.length[k], spoke_length[k1], spoke_length[k]};
      d.corner = {whole.corner[k], whole.corner[k1], where};
      made[k] = make_face(d, whole.whole, k == 0 ? s : null_id);
      kept.push_back(Kept_edge{halfedge_of(s, k), old.opposite[k], made[k], old.vertex[k]});
    }
    for(unsigned int k = 0; k < 3; ++k)
      link(next_halfedge(made[k]), previous_halfedge(made[next_corner(k)]));
    finish_split(v, previous_halfedge(made[0]), kept, Renaming());
    return v;
  }

  // splits the edge h = (a, b) at wa a + wb b, and the faces on both sides. Both weights are given, as the
  // smaller one has digits that its difference from 1 has not.
  Vertex_id split_edge(Halfedge_id h, const FT& wa, const FT& wb)
  {
    const Halfedge_id o = m_mesh.opposite(h);
    if(o != null_id && face_of(o) == face_of(h))
      return split_glued_edge(h, wa, wb);
    save_with_neighbours(face_of(h));
    if(o != null_id)
      save_with_neighbours(face_of(o));
    const FT length = m_mesh.length(h);
    const Vertex_id v = m_mesh.add_flat_vertex(null_id);
    std::vector<Kept_edge> kept;
    // the halfedges that leave a and b along the split edge now lead to v
    Renaming renaming;
    renaming.vertices = {m_mesh.source(h), m_mesh.target(h)};
    const std::pair<Halfedge_id, Halfedge_id> first
      = split_side(h, wa, wb, length, v, kept);
    if(o != null_id)
    {
      const std::pair<Halfedge_id, Halfedge_id> second
        = split_side(o, wb, wa, length, v, kept);
      link(first.first, second.second);
      link(first.second, second.first);
      renaming.from.push_back(o);
      renaming.to.push_back(second.first);
    }
    renaming.from.push_back(h);
    renaming.to.push_back(first.first);
    finish_split(v, first.second, kept, renaming);
    return v;
  }

  // splits an edge that has the same face on both sides: that face is split into three first.
  Vertex_id split_glued_edge(Halfedge_id h, const FT& wa, const FT& wb)
  {
    const Part whole = part(face_of(h));
    const unsigned int k = index_in_face(h);
    Barycentric b;
    b[k] = wa;
    b[next_corner(k)] = wb;
    b[previous_corner(k)] = 0;
    const FT third = FT(1) / 3;
    split_face(face_of(h), Barycentric{third, third, third});
    return insert(whole.whole, combination(whole.corner, b));
  }

  // splits the face of h = (a, b), with the third vertex c, at the point v = wa a + wb b; returns the
  // halfedges (a, v) and (v, b). The edge (a, b) itself is not kept.
  std::pair<Halfedge_id, Halfedge_id> split_side(Halfedge_id h, const FT& wa, const FT& wb,
                                                 const FT& length, Vertex_id v,
                                                 std::vector<Kept_edge>& kept)
  {
    const Face_id s = face_of(h);
    const unsigned int ka = index_in_face(h), kb = next_corner(ka), kc = previous_corner(ka);
    const Part whole = part(s);
    const Face old = m_mesh.face(s);
    const std::array<Vector_2, 3> p = layout(old);
    Barycentric b;
    b[ka] = wa;
    b[kb] = wb;
    b[kc] = 0;
    const Barycentric where = combination(whole.corner, b);
    const Vector_2 ab = difference(p[kb], p[ka]), to_c = negated(from_corner(p, b, kc));
    const FT to_c_length = norm(to_c.x, to_c.y);

    Draft d;
    d.vertex = {old.vertex[ka], v, old.vertex[kc]};
    d.side = {Vector_2{FT(wb * ab.x), FT(wb * ab.y)}, to_c, difference(p[ka], p[kc])};
    d.length = {FT(wb * length), to_c_length, old.length[kc]};
    d.corner = {whole.corner[ka], where, whole.corner[kc]};
    const Halfedge_id av = make_face(d, whole.whole, s);

    d.vertex = {v, old.vertex[kb], old.vertex[kc]};
    d.side = {Vector_2{FT(wa * ab.x), FT(wa * ab.y)}, difference(p[kc], p[kb]),
              negated(to_c)};
    d.length = {FT(wa * length), old.length[kb], to_c_length};
    d.corner = {where, whole.corner[kb], whole.corner[kc]};
    const Halfedge_id vb = make_face(d, whole.whole, null_id);

    link(next_halfedge(av), previous_halfedge(vb));
    kept.push_back(Kept_edge{halfedge_of(s, kc), old.opposite[kc], previous_halfedge(av),
                             old.vertex[kc]});
    kept.push_back(Kept_edge{halfedge_of(s, kb), old.opposite[kb], next_halfedge(vb),
                             old.vertex[kb]});
    return {av, vb};
  }

  void save_with_neighbours(Face_id s)
  {
    save(s);
    for(const Halfedge_id o : m_mesh.face(s).opposite)
      if(o != null_id)
        save(face_of(o));
  }

  Mesh& m_mesh;
  std::size_t m_number_of_vertices, m_number_of_faces; // at first
  std::unordered_map<Face_id, std::vector<Face_id>> m_parts;
  std::unordered_map<Face_id, Part> m_part_of;
  std::vector<std::pair<Face_id, Face>> m_saved; // in the order of the changes
  std::vector<Renaming> m_renamed;
  std::vector<std::pair<Vertex_id, unsigned char>> m_saved_kinds;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCE_INSERTION_H
