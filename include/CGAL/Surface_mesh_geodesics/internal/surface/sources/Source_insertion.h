// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_SOURCE_INSERTION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_SOURCE_INSERTION_H

// Makes a vertex of a source inside a face or on an edge (thesis, section 3.1 and figure 3.1): refines the intrinsic
// mesh around it, and can undo all refinements. The surface stays the same, and the new vertices are flat.
//
// Windows could start on the edges around the source instead. But the order of windows (Window.h) is that of sequences
// of edges: a window that crosses the face of the source may pass the source on either side, and its edge sequence
// tells the side only if the source is a vertex.
//
// The invariants of the mesh (mesh_invariants.h) hold before and after each public function.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/mesh_invariants.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Edge_flip.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Face_parts.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A *split* replaces one face by three, or the faces on both sides of an edge by two each. The first new face takes the
// index of the old one, the others are appended; so the mesh has no gaps, and undo() only truncates it. An edge of the
// old face that survives as a whole gets a new halfedge (Kept_edge), and vertices that store the old one are told
// (Renaming).
//
// How a split loses no digits. Positions are never subtracted near the new vertex: its distances from the corners come
// from its coordinates (from_corner()), lengths of surviving edges are copied, and the halves of an edge are its length
// times the two weights. Each new face gets its own layout from these vectors, with its shortest edge as the base.
//
// The *first mesh* is the mesh without inserted sources, as it was at the construction or the last restart().
//
// Invariants, between public functions: m_saved has each changed face of the first mesh as it was before each change,
// in that order, m_saved_kinds each changed kind of its vertices; parts() knows all faces that are parts of a face of
// the first mesh.
template <typename FT_>
class Source_insertion
{
public:
  using FT = FT_;
  using Mesh = Intrinsic_mesh<FT>;
  using Face = Intrinsic_face<FT>;
  using Coordinates = Barycentric<FT>;

  // Takes the mesh as it is for the first one. The mesh has to outlive this object and must not move.
  explicit Source_insertion(Mesh& mesh) : m_mesh(mesh) { restart(); }

  // Which part of a face of the first mesh contains a point, and where points of parts are in the first mesh.
  const Face_parts<FT>& parts() const { return m_parts; }

  // Returns the vertex at the point b of face f of the first mesh, and makes it if there is none. A point that is up to
  // rounding on an edge or at a vertex is there; see snap_coordinates(). On an edge without length, the vertex is an
  // end of the edge. A second source at the same point gets the same vertex, unless rounding hides that one between
  // narrow parts: callers compare locations. Takes time linear in the number of parts of f, unless a vertex around is
  // pinched.
  // Requires: are_valid_coordinates(b).
  Vertex_id insert(Face_id f, Coordinates b)
  {
    CGAL_assertion(f < m_number_of_faces && are_valid_coordinates(b));
    snap_coordinates(b);
    Coordinates local = b;
    const Face_id s = m_parts.part_with(m_mesh, f, local);
    // Coordinates that are exactly zero tell where the point is: none inside the part, one on an edge, two at a corner.
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
      return m_mesh.face(s).vertex[nearest_corner(local)];
    // on the edge opposite to corner `zero`
    const unsigned int k = next_corner(zero);
    if(!(m_mesh.face(s).length[k] > 0))
      return m_mesh.face(s).vertex[k];
    return split_edge(halfedge_of(s, k), local[k], local[next_corner(k)]);
  }

  // Returns the vertex at the point wa a + wb b of the edge h = (a, b) of the refined mesh, which it makes. The two
  // weights are given as they are, since 1 minus the larger one would lose digits of the smaller one.
  // Requires: both are positive, and their sum is 1; the edge has a length.
  Vertex_id insert_on_edge(Halfedge_id h, const FT& wa, const FT& wb)
  {
    CGAL_assertion(wa > 0 && wb > 0 && m_mesh.length(h) > 0);
    return split_edge(h, wa, wb);
  }

  // Makes the parts of crowded faces around v those of a Delaunay triangulation, by flips of their edges (Lawson,
  // 1977). Else parts become long and narrow, so that windows and arcs cross many of them; with few parts that costs
  // less than flips. Takes time proportional to the number of flips, the first time to that of parts.
  //
  // Flips lose no digits: the new edge is not much shorter than two sides that it is the sum of, and an edge that is
  // Delaunay up to a margin stays.
  // Requires: insert() has returned v; no edge inside of a face of the first mesh has to stay, as those along curves.
  void flip_around(Vertex_id v)
  {
    m_suspects.clear();
    m_mesh.for_each_halfedge_around(v, [&](Halfedge_id h) { add_suspects(h); });
    while(!m_suspects.empty())
    {
      const Halfedge_id h = m_suspects.back();
      m_suspects.pop_back();
      const Halfedge_id o = m_mesh.opposite(h);
      if(o == null_id || face_of(o) == face_of(h) || !m_parts.is_inside_whole(h, o))
        continue;
      const Edge_flip<FT> edge(m_mesh, h);
      if(edge.is_wanted())
        flip(h, edge);
    }
  }

  // Takes the mesh as it is for the first one, and forgets what has been inserted into another one.
  void restart()
  {
    m_saved.clear();
    m_renamed.clear();
    m_saved_kinds.clear();
    m_parts.clear();
    m_crowded.clear();
    CGAL_assertion(m_saved.empty() && m_renamed.empty());
    m_number_of_vertices = m_mesh.number_of_vertices();
    m_number_of_faces = m_mesh.number_of_faces();
  }

  // Removes all inserted vertices: restores each face, vertex and kind to the same bits. Takes time for what the
  // insertions have changed. Changes are taken back in reverse order, since a face may have been saved several times.
  // The mesh is truncated last, which removes the faces and vertices that were added: their changes are not saved.
  //
  // Does so after insert() or flip_around() has thrown, too, wherever memory ended: each change is remembered before it
  // is made. (The tables of parts may then know a face although no face has been saved.)
  void undo()
  {
    m_parts.clear();
    m_crowded.clear();
    if(m_saved.empty())
      return;
    for(; !m_renamed.empty(); m_renamed.pop_back())
      rename(m_renamed.back().vertices, m_renamed.back().to, m_renamed.back().from);
    for(; !m_saved.empty(); m_saved.pop_back())
      m_mesh.face(m_saved.back().first) = m_saved.back().second;
    for(; !m_saved_kinds.empty(); m_saved_kinds.pop_back())
      m_mesh.set_kind(m_saved_kinds.back().first, m_saved_kinds.back().second);
    m_mesh.truncate(m_number_of_vertices, m_number_of_faces);
    CGAL_expensive_assertion(are_invariants_kept(m_mesh));
  }

private:
  using Vector = Planar_point<FT>; // in the layout of the face that is split

  // The old and the new names of halfedges that leave some vertices.
  struct Renaming
  {
    std::vector<Vertex_id> vertices;
    std::vector<Halfedge_id> from, to;
  };

  // A new face before its edges are ordered: side k leads from vertex k to vertex k+1. `side` is in the layout of the
  // old face; `corner` has the coordinates of the vertices in the whole face of the first mesh.
  struct Draft
  {
    std::array<Vertex_id, 3> vertex;
    std::array<Vector, 3> side;
    std::array<FT, 3> length;
    std::array<Coordinates, 3> corner;
  };

  static Vector negated(const Vector& a) { return Vector{FT(-a.x), FT(-a.y)}; }

  // Returns the vector from corner k to the point b: b_i (p_i - p_k) + b_j (p_j - p_k), where i and j are the other
  // corners. Its relative error stays small if the point is near the corner, as the position of b is not rounded first.
  static Vector from_corner(const std::array<Vector, 3>& p, const Coordinates& b, unsigned int k)
  {
    const unsigned int i = next_corner(k), j = previous_corner(k);
    const Vector u = difference(p[i], p[k]), v = difference(p[j], p[k]);
    return Vector{FT(b[i] * u.x + b[j] * v.x), FT(b[i] * u.y + b[j] * v.y)};
  }

  // Makes a face of a draft, instead of face f, or at the end if f is null_id; returns the halfedge that is side 0
  // of the draft. The opposites are not set. The shortest side becomes halfedge 0, the first one in a tie. `whole` is
  // the face of the first mesh of which the new face is a part. (Not inline: compilers would copy this long text into
  // each of its calls.)
  BOOST_NOINLINE
  Halfedge_id make_face(const Draft& draft, Face_id whole, Face_id f)
  {
    const unsigned int shift = static_cast<unsigned int>(
      std::min_element(draft.length.begin(), draft.length.end()) - draft.length.begin());
    Face face;
    Face_part<FT> p;
    p.whole = whole;
    for(unsigned int k = 0; k < 3; ++k)
    {
      face.vertex[k] = draft.vertex[(k + shift) % 3];
      face.length[k] = draft.length[(k + shift) % 3];
      p.corner[k] = draft.corner[(k + shift) % 3];
      face.opposite[k] = null_id;
    }
    set_apex_of(draft, shift, face);
    if(f == null_id)
    {
      f = m_mesh.add_face(face, whole);
      m_parts.add(f, p);
    }
    else
    {
      m_mesh.face(f) = face;
      m_parts.set(f, p);
    }
    return halfedge_of(f, (3 - shift) % 3);
  }

  // Sets the apex by the projection of the third side on the base, side `shift` of the draft. A height that rounding
  // makes negative is zero: the invariant of a layout. Formula: with b the base and a the vector from its beginning to
  // the apex, (a b / |b|, b x a / |b|). A base without length has no direction; the apex is then on the x axis.
  static void set_apex_of(const Draft& draft, unsigned int shift, Face& face)
  {
    const Vector& base = draft.side[shift];
    const Vector apex = negated(draft.side[(shift + 2) % 3]);
    // Equal to length[0] up to rounding. length[0] itself would rescale the apex by the difference.
    const FT base_length = norm(base.x, base.y);
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
  }

  // Remembers a face of the first mesh before it changes; undo() removes the others.
  void save(Face_id f)
  {
    if(f < m_number_of_faces)
      m_saved.emplace_back(f, m_mesh.face(f));
  }

  // Makes a and b opposite to each other; null_id stands for the border.
  void link(Halfedge_id a, Halfedge_id b)
  {
    if(a != null_id)
      m_mesh.face(face_of(a)).opposite[index_in_face(a)] = b;
    if(b != null_id)
      m_mesh.face(face_of(b)).opposite[index_in_face(b)] = a;
  }

  // An edge that survives the replacement of its face: its old and new name, its opposite before the split, and its
  // source.
  struct Kept_edge
  {
    Halfedge_id from, opposite, to;
    Vertex_id source;
  };

  // Links the kept edges of the new faces, and completes the new vertex v, which `leaving` leaves. `renaming` has the
  // halves of a split edge already. The vertices around v come last: a walk around v needs all links.
  void finish_split(Vertex_id v, Halfedge_id leaving, const std::vector<Kept_edge>& kept, const Renaming& renaming)
  {
    keep_edges(kept, renaming);
    m_mesh.set_halfedge(v, leaving);
    mark_near_vertices(v);
  }

  // Links the kept edges of the new faces, and tells the vertices that store them. If the faces of two opposite edges
  // have both been replaced, both edges are among the kept ones. `gone` has the new names of edges that are not kept.
  // These come last: where two old names get one new name, undo() goes back to the first one, that of the kept edge.
  void keep_edges(const std::vector<Kept_edge>& kept, const Renaming& gone)
  {
    Renaming renaming;
    renaming.vertices = gone.vertices;
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
    renaming.from.insert(renaming.from.end(), gone.from.begin(), gone.from.end());
    renaming.to.insert(renaming.to.end(), gone.to.begin(), gone.to.end());
    std::sort(renaming.vertices.begin(), renaming.vertices.end());
    renaming.vertices.erase(std::unique(renaming.vertices.begin(), renaming.vertices.end()),
                            renaming.vertices.end());
    if(renaming.vertices.front() < m_number_of_vertices) // one of the first mesh
      m_renamed.push_back(renaming); // before the change, for undo()
    rename(renaming.vertices, renaming.from, renaming.to);
    for(const Vertex_id u : renaming.vertices)
      mark(u, Mesh::REFINED);
  }

  // Makes pseudo-sources of the vertices around a source. Paths that graze them run through a gap between the windows
  // on both sides, whose directions err by the rounding of the edges around, relative to the distance of the source. A
  // source very near to a vertex makes both degenerate, as an edge of the mesh with that length would. (Each face
  // around v gives both of its edges at v: the last edge before a border is that of one face only.)
  void mark_near_vertices(Vertex_id v)
  {
    m_mesh.for_each_halfedge_around(v, [this, v](Halfedge_id h)
    {
      mark_near_vertex(v, m_mesh.target(h), m_mesh.length(h));
      mark_near_vertex(v, m_mesh.source(previous_halfedge(h)), m_mesh.length(previous_halfedge(h)));
    });
  }

  // The same for the edge from v to u, given its length. Either vertex, or both, may be a source.
  void mark_near_vertex(Vertex_id v, Vertex_id u, const FT& length)
  {
    mark(u, Mesh::PSEUDO_SOURCE);
    if(length <= Tolerance<FT>::length())
    {
      mark(u, Mesh::DEGENERATE);
      mark(v, Mesh::PSEUDO_SOURCE);
      mark(v, Mesh::DEGENERATE);
    }
  }

  // Adds flags to the kind of a vertex, and remembers what it was, if the vertex is one of the first mesh.
  void mark(Vertex_id v, unsigned char kind)
  {
    if(v < m_number_of_vertices)
      m_saved_kinds.emplace_back(v, m_mesh.kind(v));
    m_mesh.set_kind(v, static_cast<unsigned char>(m_mesh.kind(v) | kind));
  }

  // Replaces each halfedge from[i] that is stored for one of the vertices by to[i]. All at once, as a new name may
  // equal the old name of another halfedge: the first new face has the index of the old one.
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

  // Splits face s at the inner point b into three; returns the new vertex. Face k of the three has the old edge k and
  // the new vertex.
  Vertex_id split_face(Face_id s, const Coordinates& b)
  {
    const Face_part<FT> whole = m_parts.part(s);
    const Face old = m_mesh.face(s);
    const Coordinates where = combination(whole.corner, b);
    const std::array<Vector, 3> p = layout_of_face(old);
    std::array<Vector, 3> spoke; // from corner to point
    std::array<FT, 3> spoke_length;
    for(unsigned int k = 0; k < 3; ++k)
    {
      spoke[k] = from_corner(p, b, k);
      spoke_length[k] = norm(spoke[k].x, spoke[k].y);
    }
    save_with_neighbors(s);
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
    // Each spoke is between two neighbors: next_halfedge(made[k]) leads from corner k+1 to v, and the halfedge before
    // made[k+1] back.
    for(unsigned int k = 0; k < 3; ++k)
      link(next_halfedge(made[k]), previous_halfedge(made[next_corner(k)]));
    finish_split(v, previous_halfedge(made[0]), kept, Renaming());
    return v;
  }

  // Splits the edge h = (a, b) at wa a + wb b, and the faces on both sides; returns the new vertex. Both weights are
  // given, as 1 minus the larger one would lose digits of the smaller one. Requires: both are positive, and the edge
  // has a length. If h is at the border, so is (v, b), which therefore begins the umbrella of v.
  Vertex_id split_edge(Halfedge_id h, const FT& wa, const FT& wb)
  {
    const Halfedge_id o = m_mesh.opposite(h);
    if(o != null_id && face_of(o) == face_of(h))
      return split_glued_edge(h, wa, wb);
    save_with_neighbors(face_of(h));
    if(o != null_id)
      save_with_neighbors(face_of(o));
    const FT length = m_mesh.length(h);
    const Vertex_id v = m_mesh.add_flat_vertex(null_id);
    std::vector<Kept_edge> kept;
    // The halfedges that leave a and b along the split edge now lead to v.
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

  // Splits an edge with the same face on both sides. First splits that face into three, so that the sides differ; the
  // additional vertex in the middle of the face is flat, and undo() removes it with the others.
  Vertex_id split_glued_edge(Halfedge_id h, const FT& wa, const FT& wb)
  {
    const Face_part<FT> whole = m_parts.part(face_of(h));
    const unsigned int k = index_in_face(h);
    Coordinates b;
    b[k] = wa;
    b[next_corner(k)] = wb;
    b[previous_corner(k)] = 0;
    const FT third = FT(1) / 3;
    split_face(face_of(h), Coordinates{third, third, third});
    return insert(whole.whole, combination(whole.corner, b));
  }

  // Splits the face of h = (a, b), with the third vertex c, at the point v = wa a + wb b; returns the halfedges (a, v)
  // and (v, b). The edge (a, b) is not among the kept ones. The face of a, v and c takes the index of the old one,
  // that of v, b and c is appended. Both sides get the same `length`, so that the halves have the same bits on both.
  std::pair<Halfedge_id, Halfedge_id> split_side(Halfedge_id h, const FT& wa, const FT& wb,
                                                 const FT& length, Vertex_id v,
                                                 std::vector<Kept_edge>& kept)
  {
    const Face_id s = face_of(h);
    const unsigned int ka = index_in_face(h), kb = next_corner(ka), kc = previous_corner(ka);
    const Face_part<FT> whole = m_parts.part(s);
    const Face old = m_mesh.face(s);
    const std::array<Vector, 3> p = layout_of_face(old);
    Coordinates b;
    b[ka] = wa;
    b[kb] = wb;
    b[kc] = 0;
    const Coordinates where = combination(whole.corner, b);
    const Vector ab = difference(p[kb], p[ka]), to_c = negated(from_corner(p, b, kc));
    const FT to_c_length = norm(to_c.x, to_c.y);

    Draft d;
    d.vertex = {old.vertex[ka], v, old.vertex[kc]};
    d.side = {Vector{FT(wb * ab.x), FT(wb * ab.y)}, to_c, difference(p[ka], p[kc])};
    d.length = {FT(wb * length), to_c_length, old.length[kc]};
    d.corner = {whole.corner[ka], where, whole.corner[kc]};
    const Halfedge_id av = make_face(d, whole.whole, s);

    d.vertex = {v, old.vertex[kb], old.vertex[kc]};
    d.side = {Vector{FT(wa * ab.x), FT(wa * ab.y)}, difference(p[kc], p[kb]),
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

  // Adds the edge opposite to the source of h, in its face, to the suspects if the whole face is crowded. The first
  // time, all edges of its parts are suspects.
  void add_suspects(Halfedge_id h)
  {
    const Face_id whole = m_parts.whole(face_of(h));
    const std::vector<Face_id>* const parts = m_parts.parts_of(whole);
    if(parts == nullptr || parts->size() <= m_parts.few)
      return;
    m_suspects.push_back(next_halfedge(h));
    if(m_crowded.insert(whole).second)
      for(const Face_id f : *parts)
        for(unsigned int k = 0; k < 3; ++k)
          m_suspects.push_back(halfedge_of(f, k));
  }

  // Replaces the edge h by the other diagonal. The names are those of Edge_flip. The four sides become suspects: in the
  // new faces, the angles opposite to them are others.
  //
  // Vertices of the first mesh store edges on the border of the whole face only: parts of edges of the first mesh.
  // These are kept, so undo() finds them again.
  void flip(Halfedge_id h, const Edge_flip<FT>& edge)
  {
    const Halfedge_id o = m_mesh.opposite(h);
    const Halfedge_id bv = next_halfedge(h), va = previous_halfedge(h);
    const Halfedge_id ad = next_halfedge(o), db = previous_halfedge(o);
    const Vertex_id a = m_mesh.source(h), b = m_mesh.target(h), v = m_mesh.target(bv), d = m_mesh.target(ad);
    const Face_part<FT> s = m_parts.part(face_of(h)), t = m_parts.part(face_of(o));
    const Coordinates &at_a = s.corner[index_in_face(h)], &at_b = s.corner[index_in_face(bv)],
                      &at_v = s.corner[index_in_face(va)], &at_d = t.corner[index_in_face(db)];
    const Draft of_a{{v, a, d}, {edge.va, edge.ad, negated(edge.vd)},
                     {m_mesh.length(va), m_mesh.length(ad), edge.vd_length}, {at_v, at_a, at_d}};
    const Draft of_b{{d, b, v}, {edge.db, edge.bv, edge.vd},
                     {m_mesh.length(db), m_mesh.length(bv), edge.vd_length}, {at_d, at_b, at_v}};
    std::vector<Kept_edge> kept;
    for(const Halfedge_id e : {va, ad, db, bv})
      kept.push_back(Kept_edge{e, m_mesh.opposite(e), null_id, m_mesh.source(e)});
    save_with_neighbors(face_of(h));
    save_with_neighbors(face_of(o));
    kept[0].to = make_face(of_a, s.whole, face_of(h));
    kept[2].to = make_face(of_b, s.whole, face_of(o));
    kept[1].to = next_halfedge(kept[0].to);
    kept[3].to = next_halfedge(kept[2].to);
    link(previous_halfedge(kept[0].to), previous_halfedge(kept[2].to));
    keep_edges(kept, Renaming{{a, b}, {h, o}, {kept[1].to, kept[3].to}});
    mark_near_vertex(v, d, edge.vd_length);
    mark_near_vertex(d, v, edge.vd_length);
    for(const Kept_edge& e : kept)
      m_suspects.push_back(e.to);
  }

  // Remembers a face and those across its edges, whose opposites will change.
  void save_with_neighbors(Face_id s)
  {
    save(s);
    for(const Halfedge_id o : m_mesh.face(s).opposite)
      if(o != null_id)
        save(face_of(o));
  }

  Mesh& m_mesh;
  std::size_t m_number_of_vertices, m_number_of_faces; // of the first mesh
  Face_parts<FT> m_parts;
  std::vector<std::pair<Face_id, Face>> m_saved; // in the order of the changes
  std::vector<Renaming> m_renamed;
  std::vector<std::pair<Vertex_id, unsigned char>> m_saved_kinds;
  std::vector<Halfedge_id> m_suspects; // edges that flip_around() has to look at; a buffer
  std::unordered_set<Face_id> m_crowded; // faces of the first mesh all of whose parts flip_around() has looked at
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_SOURCE_INSERTION_H
