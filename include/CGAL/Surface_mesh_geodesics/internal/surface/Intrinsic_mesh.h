// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_INTRINSIC_MESH_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_INTRINSIC_MESH_H

// A triangulated surface known by its lengths alone: the only surface that the propagation sees.
//
// Each vertex is surrounded by one umbrella of faces or by several (a pinched vertex); an umbrella is closed, or starts
// and ends at the border.
//
// All lengths are divided by a power of two, the unit, when the mesh is built, such that the longest is about 1. The
// squares of lengths then stay far from the ends of the range of numbers, and a surface scaled by a power of two gives
// the same bits.
//
// Life cycle: the builder (Intrinsic_mesh_builder.h) calls reset() and finish(); Source_insertion.h then adds vertices
// and faces for sources that are not vertices, and removes them. The invariants hold between these steps, not within
// one: see mesh_invariants.h. Queries take constant time unless they say otherwise, and may run in several threads.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Angle_sum.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/One_block.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_face.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Invariants, from finish() on: those of mesh_invariants.h. Vertices and faces that are added later have numbers behind
// those of the mesh as it was built. A copy is a mesh of its own.
template <typename FT_>
class Intrinsic_mesh
{
public:
  using FT = FT_;
  using Face = Intrinsic_face<FT>;

  // What a vertex is to a shortest path.
  enum Vertex_kind : unsigned char
  {
    PSEUDO_SOURCE = 1, // shortest paths may bend here: a saddle, a reflex border vertex, a pinch
    PINCHED = 2,       // surrounded by several umbrellas; also a PSEUDO_SOURCE
    DEGENERATE = 4,    // of an edge that rounding nearly erases, or a face so narrow that paths tie with those through
                       // its corners; also a PSEUDO_SOURCE
    REFINED = 8        // its faces have changed since the mesh was built
  };

  // The faces from `first` on, up to the first one of the next edge component, are connected across edges.
  struct Edge_component
  {
    Face_id first;
    FT longest_edge;
  };

  // --- faces and halfedges ---

  std::size_t number_of_vertices() const { return m_vertex_halfedge.size(); }
  std::size_t number_of_faces() const { return m_faces.size(); }

  const Face& face(Face_id f) const { return m_faces[f]; }

  // The ends of h, which has its face on the left; the halfedge between them in the face across, or null_id at the
  // border; the length, in the unit of this mesh. Requires: h is a halfedge of a face.
  Vertex_id source(Halfedge_id h) const { return m_faces[face_of(h)].vertex[index_in_face(h)]; }
  Vertex_id target(Halfedge_id h) const { return source(next_halfedge(h)); }
  Halfedge_id opposite(Halfedge_id h) const { return m_faces[face_of(h)].opposite[index_in_face(h)]; }
  const FT& length(Halfedge_id h) const { return m_faces[face_of(h)].length[index_in_face(h)]; }

  // Returns whether h is the halfedge of its edge with the smaller index, or the only one. Data of an edge is stored
  // along that one, so that both faces share it. (null_id is the largest index.)
  bool is_first_of_edge(Halfedge_id h) const { return h < opposite(h); }

  // Returns the halfedge that leaves the same vertex one face further, counterclockwise or clockwise; null_id beyond
  // the border.
  Halfedge_id next_around_source(Halfedge_id h) const { return opposite(previous_halfedge(h)); }
  Halfedge_id previous_around_source(Halfedge_id h) const
  {
    const Halfedge_id o = opposite(h);
    return o == null_id ? null_id : next_halfedge(o);
  }

  // Returns the border halfedge that follows h, with the mesh on the left: the first one of the umbrella around the
  // target of h. Takes time linear in the number of faces there. Requires: h is at the border.
  Halfedge_id next_on_border(Halfedge_id h) const
  {
    h = next_halfedge(h);
    while(opposite(h) != null_id)
      h = previous_around_source(h);
    return h;
  }

  // Returns the face of h in the frame of h. The halfedges of the neighbors run from A to C and from C to B, so that an
  // observer who looks across AB sees both edges from left to right.
  Face_frame<FT> face_frame(Halfedge_id h) const
  {
    const Face& f = m_faces[face_of(h)];
    const unsigned int k = index_in_face(h), k1 = next_corner(k), k2 = previous_corner(k);
    Face_frame<FT> c;
    c.length = f.length[k];
    c.right_length = f.length[k1];
    c.left_length = f.length[k2];
    c.origin = f.vertex[k];
    c.target = f.vertex[k1];
    c.apex = f.vertex[k2];
    c.right = f.opposite[k1];
    c.left = f.opposite[k2];
    set_apex(f, k, c);
    return c;
  }

  // --- vertices and what surrounds them ---

  // Returns a halfedge that leaves v, the first one counterclockwise if its umbrella has a border; null_id for an
  // isolated vertex.
  Halfedge_id halfedge(Vertex_id v) const { return m_vertex_halfedge[v]; }

  bool has(Vertex_id v, Vertex_kind kind) const { return (m_vertex_kind[v] & kind) != 0; }

  // The halfedges with a face that leave v, counterclockwise. Requires: has_star(v), that is, v is neither pinched nor
  // refined. (They are stored in a row, as a walk from face to face would wait for the memory at each step.)
  const Halfedge_id* star_begin(Vertex_id v) const
  {
    CGAL_expensive_assertion(has_star(v));
    return m_star.data() + m_star_begin[v];
  }
  const Halfedge_id* star_end(Vertex_id v) const
  {
    CGAL_expensive_assertion(has_star(v));
    return m_star.data() + m_star_begin[v + 1];
  }
  bool has_star(Vertex_id v) const { return (m_vertex_kind[v] & (PINCHED | REFINED)) == 0; }

  // The number of faces around v if it has a star, else 0. With few of them, what a visit reads around v fits into the
  // fastest cache, and is worth asking for in advance.
  std::size_t size_of_star(Vertex_id v) const
  {
    return has_star(v) ? static_cast<std::size_t>(star_end(v) - star_begin(v)) : 0;
  }
  bool has_small_star(Vertex_id v) const { return has_star(v) && size_of_star(v) <= few_faces; }

  // Ask the processor for the memory of these halfedges and, once it has arrived, for that of their faces.
  void prefetch_star(Vertex_id v) const
  {
    if(has_star(v))
      prefetch(star_begin(v));
  }
  void prefetch_faces_of_star(Vertex_id v) const
  {
    if(has_small_star(v))
      for(const Halfedge_id* h = star_begin(v); h != star_end(v); ++h)
        prefetch(&face(face_of(*h)));
  }

  // Calls visit(h) for one halfedge h of each umbrella of v, the first one if it has a border. Takes time linear in
  // the number of umbrellas, and logarithmic in the number of pinched vertices.
  template <typename Visit>
  void for_each_umbrella(Vertex_id v, Visit visit) const
  {
    if(m_vertex_halfedge[v] == null_id)
      return;
    visit(m_vertex_halfedge[v]);
    if(!has(v, PINCHED))
      return;
    auto it = std::lower_bound(m_other_umbrellas.begin(), m_other_umbrellas.end(),
                               std::make_pair(v, Halfedge_id(0)));
    for(; it != m_other_umbrellas.end() && it->first == v; ++it)
      visit(it->second);
  }

  // Calls visit(h) for each halfedge h with a face that leaves v.
  template <typename Visit>
  void for_each_halfedge_around(Vertex_id v, Visit visit) const
  {
    for_each_umbrella(v, [&](Halfedge_id first)
    {
      Halfedge_id h = first;
      do
      {
        visit(h);
        h = next_around_source(h);
      } while(h != first && h != null_id);
    });
  }

  // --- sizes and bounds ---

  // Returns the factor from the lengths of this mesh to those of the user: a power of two, so that multiplying by it is
  // exact.
  const FT& unit() const { return m_unit; }

  std::size_t memory() const
  {
    return m_faces.capacity() * sizeof(Face) + m_vertex_halfedge.capacity() * sizeof(Halfedge_id)
         + m_vertex_kind.capacity() + m_other_umbrellas.capacity() * sizeof(m_other_umbrellas[0])
         + m_star_begin.capacity() * sizeof(std::uint32_t) + m_star.capacity() * sizeof(Halfedge_id)
         + m_extents_of_added_faces.capacity() * sizeof(FT) + m_edge_components.capacity() * sizeof(Edge_component);
  }

  // Returns a number of faces that no shortest path exceeds.
  //
  // On a surface with points no shortest path crosses a face twice (thesis, lemma 3.2): the segment between two points
  // of a face is the shortest way in space. If lengths are given, the detour through other faces may be shorter. Then
  // let h be the least height of a face. Between two crossings of an edge e a shortest path does not turn around one
  // vertex only, as going straight around a vertex is longer than following e. So it crosses three edges in a row
  // without a common vertex, xv, vw, wy, the middle one at the fraction t. From the first to the middle one it is at
  // least t times the height of w above xv long, from there to the last one at least 1-t times that of v above wy;
  // together at least h. All crossings of e are on a part of the path that is not longer than e, so there are at most
  // 1 + |e|/h of them.
  //
  // The bound ends computations that would never end: where faces have no area, paths may run around without growing.
  std::size_t most_faces_crossed() const { return m_most_faces_crossed; }

  // Returns the extent that tolerances around a face are relative to: 1 if the mesh has one edge component, else the
  // longest edge of that component as it was built, as the others may be far larger. Takes time logarithmic in their
  // number.
  FT extent_around(Face_id f) const
  {
    CGAL_assertion(f < number_of_faces());
    if(m_edge_components.empty())
      return 1;
    if(f >= m_number_of_faces_built)
      return m_extents_of_added_faces[f - m_number_of_faces_built];
    const auto next = std::upper_bound(m_edge_components.begin(), m_edge_components.end(), f,
                                       [](Face_id g, const Edge_component& c) { return g < c.first; });
    return (next - 1)->longest_edge;
  }

  // --- building: reset(), set_unit(), all members of all faces, set_edge_components(), finish(); and, for lengths
  // without points, bound_faces_crossed_by_lengths() ---

  // Reserves memory for the faces that a few sources inside faces need: else the first source would double the memory.
  // New faces hold anything until the builder has set all their members; vertices are the former ones until finish().
  void reset(std::size_t number_of_faces)
  {
    reserve_large(m_faces, number_of_faces + room_for_sources);
    m_faces.resize(number_of_faces);
    m_number_of_faces_built = number_of_faces;
    m_edge_components.clear();
    m_extents_of_added_faces.clear();
  }

  // See unit(). Requires: a power of two.
  void set_unit(const FT& unit) { m_unit = unit; }

  // Requires: there are several components, sorted by face.
  void set_edge_components(const std::vector<Edge_component>& components)
  {
    CGAL_assertion(components.size() > 1 && components.front().first == 0);
    CGAL_expensive_assertion(std::is_sorted(
      components.begin(), components.end(),
      [](const Edge_component& a, const Edge_component& b) { return a.first < b.first; }));
    m_edge_components = components;
  }

  // Whoever changes a face keeps the invariants.
  Face& face(Face_id f) { return m_faces[f]; }

  // Finds the umbrellas and the kinds of the vertices 0 .. n-1. Requires: all faces are set.
  //
  // The order of the steps: the star of a vertex is filled from its first umbrella, and find_bends() looks into the
  // stars for the faces of a block. Takes linear time. Each umbrella beyond the first one of a vertex takes time linear
  // in the number of all such umbrellas.
  template <typename Blocks = One_block>
  void finish(std::size_t number_of_vertices, const Blocks& blocks = Blocks())
  {
    m_vertex_halfedge.assign(number_of_vertices, null_id);
    m_vertex_kind.assign(number_of_vertices, 0);
    m_other_umbrellas.clear();
    find_umbrellas();
    fill_stars(blocks);
    find_bends(blocks);
    find_degenerate(blocks);
    m_faces_crossed_by_lengths = 0;
    count_most_faces_crossed();
  }

  // Lets shortest paths cross faces more than once; see most_faces_crossed(). If some face is flatter than
  // Tolerance::lost_face(), no bound from its height would end the computation in practice; the bound then ignores
  // faces that are flatter than Tolerance::thick_face().
  //
  // Formula: the sum of 1 + |e| / h over the three sides e of all faces, where h is the least height. The least height
  // of a face is twice its area over its longest side. If no face counts, h is infinite.
  void bound_faces_crossed_by_lengths()
  {
    double height = std::numeric_limits<double>::infinity(), height_of_thick = height, sum = 0;
    bool is_lost = false;
    for(const Face& f : m_faces)
    {
      const double longest = static_cast<double>(longest_side(f));
      const double least_height = longest > 0 ? static_cast<double>(FT(f.apex_y * f.length[0])) / longest : 0.;
      is_lost = is_lost || !(least_height > Tolerance<FT>::lost_face() * longest);
      height = (std::min)(height, least_height);
      if(least_height > Tolerance<FT>::thick_face() * longest)
        height_of_thick = (std::min)(height_of_thick, least_height);
      sum += static_cast<double>(FT(f.length[0] + f.length[1] + f.length[2]));
    }
    m_faces_crossed_by_lengths
      = 3. * static_cast<double>(number_of_faces()) + sum / (is_lost ? height_of_thick : height);
    count_most_faces_crossed();
  }

  // --- refinement and its reversal, for sources inside faces and on edges (Source_insertion.h) ---

  // Adds a vertex with a total angle of 2 pi, or pi on the border, which h leaves. h may be null_id if set_halfedge()
  // follows.
  Vertex_id add_flat_vertex(Halfedge_id h)
  {
    m_vertex_halfedge.push_back(h);
    m_vertex_kind.push_back(REFINED);
    return static_cast<Vertex_id>(m_vertex_halfedge.size() - 1);
  }

  // Adds a face, a part of the face `whole`, and returns its index. The opposites of its neighbors are the caller's
  // task. All references to faces become invalid. If it throws, truncate() has to follow.
  Face_id add_face(const Face& f, Face_id whole)
  {
    m_extents_of_added_faces.push_back(extent_around(whole));
    m_faces.push_back(f);
    count_most_faces_crossed();
    return static_cast<Face_id>(m_faces.size() - 1);
  }

  // Removes the last vertices and faces. Requires: they have been added since finish(), and none of those that stay
  // refers to them.
  void truncate(std::size_t number_of_vertices, std::size_t number_of_faces)
  {
    CGAL_assertion(number_of_vertices <= this->number_of_vertices() && number_of_faces <= this->number_of_faces());
    m_vertex_halfedge.resize(number_of_vertices);
    m_vertex_kind.resize(number_of_vertices);
    m_extents_of_added_faces.resize(number_of_faces - m_number_of_faces_built);
    m_faces.resize(number_of_faces);
    count_most_faces_crossed();
  }

  // Sets the halfedge that leaves v. Requires: it is the first one of its umbrella if that has a border.
  void set_halfedge(Vertex_id v, Halfedge_id h) { m_vertex_halfedge[v] = h; }

  unsigned char kind(Vertex_id v) const { return m_vertex_kind[v]; }
  void set_kind(Vertex_id v, unsigned char kind) { m_vertex_kind[v] = kind; }

  // Replaces each halfedge h that is stored for v by new_name(h).
  template <typename NewName>
  void rename_halfedges(Vertex_id v, NewName new_name)
  {
    m_vertex_halfedge[v] = new_name(m_vertex_halfedge[v]);
    if(has(v, PINCHED))
      for(std::pair<Vertex_id, Halfedge_id>& entry : m_other_umbrellas)
        if(entry.first == v)
          entry.second = new_name(entry.second);
  }

private:
  // Finds the first umbrella of each vertex and all those with a border, and reserves memory for the stars.
  //
  // A vertex at the border starts with its first halfedge at the border, any other one with its first halfedge. The
  // umbrellas that are still missing are closed; fill_stars() notices them. m_star_begin[v + 1] first counts the
  // halfedges that leave v, and then is the end of their row in m_star.
  void find_umbrellas()
  {
    reserve_large(m_star_begin, number_of_vertices() + 1);
    m_star_begin.assign(number_of_vertices() + 1, 0);
    std::vector<Halfedge_id> at_border; // an umbrella with a border begins where there is no face on the right
    const Face_id n = static_cast<Face_id>(number_of_faces());
    for(Face_id f = 0; f < n; ++f)
      for(unsigned int k = 0; k < 3; ++k)
      {
        const Vertex_id v = m_faces[f].vertex[k];
        const Halfedge_id h = halfedge_of(f, k);
        ++m_star_begin[v + 1];
        m_vertex_halfedge[v] = (std::min)(m_vertex_halfedge[v], h); // (null_id is the largest number)
        if(m_faces[f].opposite[k] == null_id)
          at_border.push_back(h);
      }
    for(const Halfedge_id h : at_border)
      if(opposite(m_vertex_halfedge[source(h)]) != null_id)
        m_vertex_halfedge[source(h)] = h;
      else if(m_vertex_halfedge[source(h)] != h)
        add_umbrella(source(h), h);
    for(Vertex_id v = 0; v < number_of_vertices(); ++v)
      m_star_begin[v + 1] += m_star_begin[v];
    reserve_large(m_star, m_star_begin.back());
    m_star.assign(m_star_begin.back(), 0); // an entry that is not filled is some halfedge
  }

  // Umbrellas beyond the first are rare; they are stored sorted by vertex.
  void add_umbrella(Vertex_id v, Halfedge_id h)
  {
    m_vertex_kind[v] |= PINCHED | PSEUDO_SOURCE;
    const std::pair<Vertex_id, Halfedge_id> entry(v, h);
    m_other_umbrellas.insert(
      std::lower_bound(m_other_umbrellas.begin(), m_other_umbrellas.end(), entry), entry);
  }

  // Adds the closed umbrellas of vertices that have more faces than their known umbrellas.
  void complete_closed_umbrellas(const std::vector<Vertex_id>& incomplete)
  {
    std::vector<char> is_incomplete(number_of_vertices(), 0);
    for(Vertex_id v : incomplete)
      is_incomplete[v] = 1;
    std::vector<char> is_covered(4 * number_of_faces(), 0);
    auto cover = [&](Halfedge_id first)
    {
      Halfedge_id h = first;
      do
      {
        is_covered[h] = 1;
        h = next_around_source(h);
      } while(h != first && h != null_id);
    };
    for(Vertex_id v : incomplete)
      for_each_umbrella(v, cover);
    for(Face_id f = 0; f < number_of_faces(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
        if(is_incomplete[m_faces[f].vertex[k]] && !is_covered[halfedge_of(f, k)])
        {
          add_umbrella(m_faces[f].vertex[k], halfedge_of(f, k));
          cover(halfedge_of(f, k));
        }
  }

  // Fills the stars, and finds umbrellas that are not known yet. (A walk around a vertex waits for the memory at each
  // step, so it does nothing else.) The star of a pinched vertex may lack halfedges. Each vertex has a row of its own
  // in m_star, so blocks do not disturb each other.
  template <typename Blocks>
  void fill_stars(const Blocks& blocks)
  {
    std::vector<Vertex_id> incomplete;
    std::mutex mutex; // of `incomplete`, which is empty for most meshes
    blocks(number_of_vertices(), [&](std::size_t first, std::size_t last)
    {
      for(Vertex_id v = static_cast<Vertex_id>(first); v < last; ++v)
      {
        std::uint32_t end = m_star_begin[v];
        for_each_halfedge_around(v, [&](Halfedge_id h) { m_star[end++] = h; });
        if(end != m_star_begin[v + 1])
        {
          const std::lock_guard<std::mutex> lock(mutex);
          incomplete.push_back(v);
        }
      }
    });
    if(!incomplete.empty())
      complete_closed_umbrellas(incomplete);
  }

  // Marks the vertices where shortest paths may bend: the total angle exceeds 2 pi, or pi on the border, by more than
  // Tolerance::angle(). The angles are added face by face, as faces lie in a row and vertices close to each other. So
  // the sum of a vertex does not depend on the blocks. (Pinched vertices are marked already, whatever their angles
  // are.)
  template <typename Blocks>
  void find_bends(const Blocks& blocks)
  {
    const std::size_t n = number_of_vertices();
    blocks(n, [&](std::size_t first, std::size_t last)
    {
      const std::pair<Face_id, Face_id> range = last - first < n
                                                  ? faces_around(first, last)
                                                  : std::make_pair(Face_id(0), static_cast<Face_id>(m_faces.size()));
      find_bends(first, last, range.first, range.second);
    });
  }

  // Does so for the vertices [first, last). Requires: all their faces, but for pinched vertices, are among the faces
  // [first_face, last_face).
  void find_bends(std::size_t first, std::size_t last, Face_id first_face, Face_id last_face)
  {
    std::vector<Angle_sum<FT>> angle(last - first);
    for(Face_id f = first_face; f < last_face; ++f)
      for(unsigned int k = 0; k < 3; ++k)
      {
        const std::size_t i = m_faces[f].vertex[k] - first; // a large number if the vertex is before `first`
        if(i >= angle.size())
          continue;
        const std::pair<FT, FT> direction = angle_direction(m_faces[f], k);
        angle[i].add(direction.first, direction.second);
      }
    for(std::size_t v = first; v < last; ++v)
    {
      const bool is_on_border = m_vertex_halfedge[v] != null_id && opposite(m_vertex_halfedge[v]) == null_id;
      if(is_on_border ? angle[v - first].is_more_than_half() : angle[v - first].is_more_than_full())
        m_vertex_kind[v] |= PSEUDO_SOURCE;
    }
  }

  // Returns a range that contains the faces in the stars of the vertices [first, last). It is short, as vertices and
  // faces are numbered together.
  std::pair<Face_id, Face_id> faces_around(std::size_t first, std::size_t last) const
  {
    const auto begin = m_star.begin() + m_star_begin[first], end = m_star.begin() + m_star_begin[last];
    if(begin == end)
      return {0, 0};
    const auto extremes = std::minmax_element(begin, end);
    return {face_of(*extremes.first), face_of(*extremes.second) + 1};
  }

  // Marks the ends of an edge that rounding nearly erases, and the corners of a narrow face, as pseudo-sources,
  // whatever their angles are: no bound on these helps, as a path that misses the vertex ties with the one through it.
  void mark_degenerate(const Face& f)
  {
    const bool has_narrow_corners = is_narrow(f);
    for(unsigned int k = 0; k < 3; ++k)
      if(has_narrow_corners || f.length[k] <= Tolerance<FT>::length())
      {
        m_vertex_kind[f.vertex[k]] |= DEGENERATE | PSEUDO_SOURCE;
        m_vertex_kind[f.vertex[next_corner(k)]] |= DEGENERATE | PSEUDO_SOURCE;
      }
  }

  // Does so for all faces. Each block lists such faces. Their corners are marked when all blocks have ended, as faces
  // of different blocks have common vertices. Marks do not depend on the order of the faces.
  template <typename Blocks>
  void find_degenerate(const Blocks& blocks)
  {
    std::vector<std::size_t> degenerate;
    std::mutex mutex; // of `degenerate`
    blocks(m_faces.size(), [&](std::size_t first, std::size_t last)
    {
      std::vector<std::size_t> of_block;
      for(std::size_t f = first; f < last; ++f)
        if(m_faces[f].length[0] <= Tolerance<FT>::length() || is_narrow(m_faces[f]))
          of_block.push_back(f);
      const std::lock_guard<std::mutex> lock(mutex);
      degenerate.insert(degenerate.end(), of_block.begin(), of_block.end());
    });
    for(const std::size_t f : degenerate)
      mark_degenerate(m_faces[f]);
  }

  // If sources have divided a face into n+1 faces, a path that crosses the face once crosses at most n+1 of them. On a
  // surface with points no face is crossed twice, so their number is the bound.
  void count_most_faces_crossed()
  {
    m_most_faces_crossed = number_of_faces();
    if(m_faces_crossed_by_lengths > 0)
    {
      const double parts = static_cast<double>(number_of_faces() - m_number_of_faces_built + 1);
      m_most_faces_crossed
        = static_cast<std::size_t>((std::min)(parts * m_faces_crossed_by_lengths, largest_faces_crossed));
    }
  }

  static constexpr double largest_faces_crossed = 1 << 30; // windows count faces in 31 bits

  static constexpr std::size_t room_for_sources = 64; // faces; a source needs two or three
  static constexpr std::size_t few_faces = 32;        // of a star

  std::vector<Face> m_faces;
  std::vector<Halfedge_id> m_vertex_halfedge;
  std::vector<unsigned char> m_vertex_kind;
  std::vector<std::pair<Vertex_id, Halfedge_id>> m_other_umbrellas; // sorted
  std::vector<std::uint32_t> m_star_begin; // of the vertices of the mesh as it was built
  std::vector<Halfedge_id> m_star;
  std::vector<Edge_component> m_edge_components; // empty if there is one
  std::vector<FT> m_extents_of_added_faces;      // see extent_around()
  FT m_unit = 1;
  std::size_t m_most_faces_crossed = 0, m_number_of_faces_built = 0; // before sources divided them
  double m_faces_crossed_by_lengths = 0;                             // 0 for a surface with points
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_INTRINSIC_MESH_H
