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

// The faces around a vertex, and all that a visit of the vertex reads and writes: the window lists that are
// carried through these faces, and the distances of the vertices around. While the vertex is
// visited nothing else is touched, so that the visit of a vertex is a function of its star.
//
// Each face (v, a, b) has three lists. Those that turn around v counterclockwise enter it across va, those
// that turn clockwise enter it across bv, and all leave it across ab, or go on around v.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Bitset.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Window_lists.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/window_pruning.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A vertex next to that which is visited. The visit works on a copy of its distance.
template <typename FT>
struct Link_vertex
{
  Vertex_id vertex;
  bool is_degenerate;
  bool may_emit; // windows start here now or then: improvements that rounding could have made are ignored
  bool is_improved = false;
  FT distance;
  Vertex_arrival<FT> arrival; // if it is improved
  Arrival_image<FT> image;

  explicit Link_vertex(Vertex_id v) : vertex(v) {}

  Vertex_rival<FT> rival() const { return Vertex_rival<FT>(distance, is_degenerate); }
};

template <typename FT>
struct Star_face
{
  Halfedge_id halfedge;         // va
  std::uint32_t first, second;  // a and b, in the links of the star
  std::uint32_t next, previous; // the faces counterclockwise and clockwise, null_id beyond the border
  Window_list<FT> counterclockwise, clockwise, outward;
  FT outward_distance; // the smallest one of the list `outward`

  // (A constructor of its own: without one, all would be set to zero before it is set.)
  Star_face(Halfedge_id h, std::uint32_t a, std::uint32_t b, std::uint32_t next_face, std::uint32_t previous_face)
    : halfedge(h), first(a), second(b), next(next_face), previous(previous_face),
      outward_distance(Vertex_distance_field<FT>::infinity())
  {}
};

template <typename FT>
struct Vertex_star
{
  Vertex_id vertex = null_id;
  FT distance;
  bool is_degenerate;
  bool emits;                 // windows have to start at the vertex,
  bool has_emitted;           // and they have before
  bool has_stale_windows;     // there may be windows of a pseudo-source that has been improved since
  Vertex_arrival<FT> arrival; // at the vertex
  std::vector<Star_face<FT>> faces;
  std::vector<Link_vertex<FT>> links;
  // The faces that counterclockwise lists wait to enter; and those that clockwise ones do, counted from the last one.
  Bitset waiting, waiting_from_last;

  // finds the faces and links of v; what is known of v and its links is left to the caller.
  void surround(const Intrinsic_mesh<FT>& mesh, Vertex_id v)
  {
    vertex = v;
    faces.clear();
    links.clear();
    if(mesh.has_star(v))
      add_star(mesh, mesh.star_begin(v), mesh.star_end(v));
    else
      mesh.for_each_umbrella(v, [&](Halfedge_id first) { add_umbrella(mesh, first); });
  }

private:
  // a whole star, whose halfedges are known.
  void add_star(const Intrinsic_mesh<FT>& mesh, const Halfedge_id* begin, const Halfedge_id* end)
  {
    if(begin == end)
      return;
    for(const Halfedge_id* h = begin; h != end; ++h)
      add_face(mesh, *h);
    close(mesh, 0, mesh.opposite(begin[0]) == null_id);
  }

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

  // with the link before it; that behind it is the next one to be added.
  void add_face(const Intrinsic_mesh<FT>& mesh, Halfedge_id h)
  {
    const std::uint32_t f = static_cast<std::uint32_t>(faces.size());
    const std::uint32_t a = static_cast<std::uint32_t>(links.size());
    faces.emplace_back(h, a, a + 1, f + 1, f - 1);
    links.emplace_back(mesh.target(h));
  }

  // joins the last face of an umbrella to its first one, unless there is a border between them.
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
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_PROPAGATION_VERTEX_STAR_H
