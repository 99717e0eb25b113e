// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_VERTEX_STAR_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_VERTEX_STAR_H

// The star of a vertex v: the faces around v, and everything that a visit of v reads and writes. These are the window
// lists that enter the faces, and copies of the distances of v and of the vertices around it.
//
// A visit touches nothing else. It is therefore a function of the star, and the sequential and the parallel propagation
// share it: the wavefront fills the star (Wavefront::take), Star_propagation carries the windows through it, and the
// wavefront takes the result over (Wavefront::put_lists).
//
// Each face (v, a, b), counterclockwise, has three lists. Windows that turn around v counterclockwise enter the face
// across va. Windows that turn clockwise enter it across bv. Both leave it across ab, the edge of the link of v, or go
// on to the next face around v.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Bitset.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_pruning.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A vertex of the link. The visit improves this copy of its distance; the field is updated afterward. So a visit sees
// its own improvements at once, and those of visits at the same time never.
template <typename FT>
struct Link_vertex
{
  Vertex_id vertex;
  bool is_degenerate;
  bool may_emit; // windows start here now or later: improvements within rounding are ignored
  bool is_improved = false;
  FT distance;
  Vertex_arrival<FT> arrival; // set if is_improved
  Arrival_image<FT> image;    // set if is_improved by a window

  explicit Link_vertex(Vertex_id v) : vertex(v) {}

  Vertex_rival<FT> rival() const { return Vertex_rival<FT>(distance, is_degenerate); }
};

// A face (v, a, b) of the star. It owns the blocks of its lists from Wavefront::take() to Wavefront::put_lists(); then
// the wavefront does.
template <typename FT>
struct Star_face
{
  Halfedge_id halfedge;         // va
  std::uint32_t first, second;  // indices of a and b in the links of the star
  std::uint32_t next, previous; // indices of the faces counterclockwise and clockwise; null_id at the border
  Window_list<FT> counterclockwise, clockwise, outward; // entering across va, entering across bv, leaving across ab
  FT outward_distance;          // not greater than the distance of any window of `outward`

  // This constructor exists because aggregate initialization would clear the lists twice.
  Star_face(Halfedge_id h, std::uint32_t a, std::uint32_t b, std::uint32_t next_face, std::uint32_t previous_face)
    : halfedge(h), first(a), second(b), next(next_face), previous(previous_face),
      outward_distance(Vertex_distance_field<FT>::infinity())
  {}
};

// Invariants:
// - After surround(): faces and links describe the star. The faces of an umbrella stand next to each other in
//   counterclockwise order; an umbrella of n faces has n links, or n + 1 if it has a border. Other members are not set.
// - After Wavefront::take(): all members are set, no link is improved and the `outward` lists are empty. Face i is in
//   `waiting` exactly if its counterclockwise list has windows, and face n - 1 - i is counted in `waiting_from_last` as
//   i exactly if its clockwise list has.
// - After Star_propagation::propagate(): nothing waits to enter a face; windows are in `outward` lists only.
// - After Wavefront::put_lists(): all lists are empty.
template <typename FT>
struct Vertex_star
{
  Vertex_id vertex = null_id;
  FT distance;
  bool is_degenerate;
  bool emits;                 // windows must start at the vertex during this visit
  bool has_emitted;           // windows started at the vertex during an earlier visit
  bool has_stale_windows;     // windows of a pseudo-source may exist whose distance has shrunk since
  Vertex_arrival<FT> arrival; // at the vertex
  std::vector<Star_face<FT>> faces;
  std::vector<Link_vertex<FT>> links;
  // The faces that counterclockwise lists wait to enter, and those that clockwise lists wait to enter. The latter are
  // counted from the last face, so that both sweeps visit ascending numbers.
  Bitset waiting, waiting_from_last;
  Bitset marks; // a buffer of Wavefront

  // Finds the faces and links of v. The caller fills in the rest. Linear in the degree of v. If a list of the former
  // star still has a block, as after an exception, the pool does not get it back.
  void surround(const Intrinsic_mesh<FT>& mesh, Vertex_id v)
  {
    vertex = v;
    faces.clear();
    links.clear();
    if(mesh.has_star(v))
      add_star(mesh, mesh.star_begin(v), mesh.star_end(v));
    else
      mesh.for_each_umbrella(v, [&](Halfedge_id first) { add_umbrella(mesh, first); });
    CGAL_expensive_assertion(is_connected_around_vertex(mesh));
  }

  // Do the two bitsets tell which lists have windows?
  bool waiting_lists_are_marked() const
  {
    Bitset counterclockwise, clockwise;
    for(Bitset* set : {&counterclockwise, &clockwise})
      set->reset(faces.size());
    waiting.for_each([&](std::size_t i) { counterclockwise.insert(i); });
    waiting_from_last.for_each([&](std::size_t i) { clockwise.insert(faces.size() - 1 - i); });
    for(std::size_t i = 0; i < faces.size(); ++i)
      if((counterclockwise.next(i) == i) != (faces[i].counterclockwise.size > 0)
         || (clockwise.next(i) == i) != (faces[i].clockwise.size > 0))
        return false;
    return true;
  }

  // Has every window left the star, or been removed?
  bool nothing_waits() const
  {
    for(const Star_face<FT>& f : faces)
      if(f.counterclockwise.size > 0 || f.clockwise.size > 0)
        return false;
    return waiting.empty() && waiting_from_last.empty();
  }

private:
  // Adds the only umbrella of a vertex whose halfedges the mesh stores.
  void add_star(const Intrinsic_mesh<FT>& mesh, const Halfedge_id* begin, const Halfedge_id* end)
  {
    if(begin == end)
      return;
    for(const Halfedge_id* h = begin; h != end; ++h)
      add_face(mesh, *h);
    close(mesh, 0, mesh.opposite(begin[0]) == null_id);
  }

  // Adds the umbrella that begins at a halfedge, counterclockwise.
  void add_umbrella(const Intrinsic_mesh<FT>& mesh, Halfedge_id first)
  {
    const std::uint32_t first_face = static_cast<std::uint32_t>(faces.size());
    Halfedge_id h = first;
    do
    {
      add_face(mesh, h);
      h = mesh.next_around_source(h);
    } while(h != first && h != null_id);
    close(mesh, first_face, h == null_id);
  }

  // Adds the face of h and the link a before it. The next call, or close(), adds the link b behind it. The neighbors
  // are set as if the umbrella had neither a beginning nor an end; close() corrects its first and its last face.
  void add_face(const Intrinsic_mesh<FT>& mesh, Halfedge_id h)
  {
    const std::uint32_t f = static_cast<std::uint32_t>(faces.size());
    const std::uint32_t a = static_cast<std::uint32_t>(links.size());
    faces.emplace_back(h, a, a + 1, f + 1, f - 1);
    links.emplace_back(mesh.target(h));
  }

  // Joins the last face of an umbrella to its first one, unless a border separates them. In a closed umbrella the last
  // link is the first one; at a border it has a place of its own.
  void close(const Intrinsic_mesh<FT>& mesh, std::uint32_t first_face, bool has_border)
  {
    if(has_border)
    {
      faces[first_face].previous = null_id;
      faces.back().next = null_id;
      links.emplace_back(mesh.source(previous_halfedge(faces.back().halfedge)));
      return;
    }
    faces[first_face].previous = static_cast<std::uint32_t>(faces.size() - 1);
    faces.back().next = first_face;
    faces.back().second = faces[first_face].first;
  }

  // Do `first`, `second`, `next` and `previous` of each face tell what the mesh says?
  bool is_connected_around_vertex(const Intrinsic_mesh<FT>& mesh) const
  {
    for(std::uint32_t i = 0; i < faces.size(); ++i)
    {
      const Star_face<FT>& f = faces[i];
      const Halfedge_id bv = previous_halfedge(f.halfedge);
      if(mesh.source(f.halfedge) != vertex || links[f.first].vertex != mesh.target(f.halfedge)
         || links[f.second].vertex != mesh.source(bv))
        return false;
      const Halfedge_id around = mesh.opposite(bv);
      if(f.next == null_id ? around != null_id : faces[f.next].halfedge != around || faces[f.next].previous != i)
        return false;
    }
    return true;
  }
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_VERTEX_STAR_H
