// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_WALLS_WALL_CUT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_WALLS_WALL_CUT_H

// Cuts a mesh along walls: edges that no path may cross, but along which it may run. It works on bare connectivity,
// before the builder numbers faces and vertices, so that everything behind it sees a mesh with more border.
//
// Why the cut surface is right. A path crosses no wall exactly if it is a path of the surface in which each wall edge
// has been replaced by two edges of the border, one for each side. So the shortest paths of that surface are those that
// are wanted, and their lengths are those on the mesh, as the faces stay as they are. Only the vertices remain to be
// told apart. The faces around a vertex of a wall fall into *sectors*, which are connected across edges that are no
// walls. A path that touches the vertex may go on in its own sector only: it would pass to the other side of the wall
// otherwise. So each sector gets a vertex of its own. At the free end of a wall there is one sector, hence one vertex,
// and paths bend around it.
//
// What is divided. A vertex gets *copies* exactly if walls divide its faces: if there are more sectors with the walls
// than without them. Then each sector gets its own one; the first sector, in the order of the faces, keeps the vertex.
// A pinched vertex without walls has several sectors already and stays one vertex, which paths may pass. If a wall
// divides one of its umbrellas, all of its sectors are told apart, as the border belongs to the walls then.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh_builder.h>

#include <CGAL/assertions.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The edges of a face that are walls: bit j stands for edge j, which leads from corner j to corner j+1.
using Wall_bits = unsigned char;

inline bool is_wall(Wall_bits bits, unsigned int edge) { return ((bits >> edge) & 1u) != 0; }

// Use: construct, which cuts the faces. Neighbors across walls become null_id, and corners at copies get new indices.
//
// Takes time linear in the number of faces, and n log n for the n corners at vertices of walls.
class Wall_cut
{
public:
  // `faces` are given by position, with the positions of their neighbors, and `walls` by position as well. Corners are
  // indices below `number_of_indices`. Both faces of a wall know it. Throws Invalid_geodesic_input if there are too
  // many copies to be numbered.
  Wall_cut(std::vector<Connected_face>& faces, const std::vector<Wall_bits>& walls, std::size_t number_of_indices)
    : m_faces(faces), m_walls(walls), m_number_of_indices(number_of_indices)
  {
    CGAL_assertion(faces.size() == walls.size());
    collect_corners();
    for(std::size_t first = 0; first < m_corners.size();)
    {
      std::size_t last = first;
      while(last < m_corners.size() && m_corners[last].first == m_corners[first].first)
        ++last;
      divide_vertex(first, last);
      first = last;
    }
    for(std::uint32_t f = 0; f < m_faces.size(); ++f)
      for(unsigned int j = 0; j < 3; ++j)
        if(is_cut(f, j))
          m_ends.emplace_back(f, j);
    for(const auto& e : m_ends)
      m_faces[e.first].neighbor[e.second] = null_id;
    if(m_number_of_indices + m_copied.size() >= null_id)
      throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::TOO_LARGE,
                                   "the walls divide the mesh into too many vertices");
  }

  // The index of the vertex of which number_of_indices + i is a copy. The copies of one vertex are neighbors.
  std::vector<std::uint32_t> take_copied() { return std::move(m_copied); }

private:
  using Corner = std::pair<std::uint32_t, std::uint32_t>; // the index of a vertex; 3 times a position plus a corner

  // Is edge j of face f a wall between two faces? A wall at the border, or beside a face that is left out, cuts
  // nothing.
  bool is_cut(std::uint32_t f, unsigned int j) const
  {
    return is_wall(m_walls[f], j) && m_faces[f].neighbor[j] < m_faces.size();
  }

  // The order by face makes copies, and with them all results, independent of the order in which edges were given.
  //
  // Lists the corners of all faces at the ends of walls, sorted by vertex, then by face.
  void collect_corners()
  {
    std::vector<char> is_at_wall(m_number_of_indices, 0);
    for(std::uint32_t f = 0; f < m_faces.size(); ++f)
      for(unsigned int j = 0; j < 3; ++j)
        if(is_cut(f, j))
          is_at_wall[m_faces[f].corner[j]] = is_at_wall[m_faces[f].corner[next_corner(j)]] = 1;
    for(std::uint32_t f = 0; f < m_faces.size(); ++f)
      for(unsigned int k = 0; k < 3; ++k)
        if(is_at_wall[m_faces[f].corner[k]] != 0)
          m_corners.emplace_back(m_faces[f].corner[k], 3 * f + k);
    std::sort(m_corners.begin(), m_corners.end());
  }

  // The number of umbrellas tells what the vertex was before: several of them, in a pinched vertex, are no reason to
  // divide it.
  //
  // Gives the corners first .. last - 1, which are those of one vertex, to its copies, if walls divide it.
  void divide_vertex(std::size_t first, std::size_t last)
  {
    const std::size_t n = last - first;
    boost::disjoint_sets_with_storage<> umbrellas(n), sectors(n);
    std::size_t number_of_umbrellas = n, number_of_sectors = n;
    const auto unite = [](boost::disjoint_sets_with_storage<>& sets, std::size_t& number, std::size_t a, std::size_t b)
    {
      if(sets.find_set(a) == sets.find_set(b))
        return;
      sets.union_set(a, b);
      --number;
    };
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::uint32_t f = m_corners[first + i].second / 3;
      const unsigned int k = m_corners[first + i].second % 3;
      for(const unsigned int j : {k, previous_corner(k)}) // the two edges of the face at the vertex
      {
        const std::size_t across = corner_across(f, j, first, last);
        if(across == last)
          continue;
        unite(umbrellas, number_of_umbrellas, i, across - first);
        if(!is_cut(f, j))
          unite(sectors, number_of_sectors, i, across - first);
      }
    }
    if(number_of_sectors > number_of_umbrellas)
      give_copies(first, last, sectors);
  }

  // The number among first .. last - 1 of the corner of the same vertex in the face across edge j of f, `last` if there
  // is none.
  std::size_t corner_across(std::uint32_t f, unsigned int j, std::size_t first, std::size_t last) const
  {
    const std::uint32_t v = m_corners[first].first, g = m_faces[f].neighbor[j];
    if(g >= m_faces.size())
      return last;
    for(unsigned int k = 0; k < 3; ++k)
      if(m_faces[g].corner[k] == v)
      {
        const auto begin = m_corners.begin();
        return static_cast<std::size_t>(
          std::lower_bound(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last),
                           Corner(v, 3 * g + k)) - begin);
      }
    return last;
  }

  // The first sector keeps the index of the vertex, so that a mesh with walls has few new indices, and none where a
  // wall ends.
  template <typename Sets>
  void give_copies(std::size_t first, std::size_t last, Sets& sectors)
  {
    const std::uint32_t v = m_corners[first].first;
    std::vector<std::uint32_t> index_of_sector(last - first, null_id);
    index_of_sector[sectors.find_set(std::size_t(0))] = v;
    for(std::size_t i = first; i < last; ++i)
    {
      std::uint32_t& index = index_of_sector[sectors.find_set(i - first)];
      if(index == null_id)
      {
        index = static_cast<std::uint32_t>(m_number_of_indices + m_copied.size());
        m_copied.push_back(v);
      }
      m_faces[m_corners[i].second / 3].corner[m_corners[i].second % 3] = index;
    }
  }

  std::vector<Connected_face>& m_faces;
  const std::vector<Wall_bits>& m_walls;
  std::size_t m_number_of_indices;
  std::vector<Corner> m_corners;
  std::vector<std::pair<std::uint32_t, unsigned int>> m_ends; // faces and edges at walls
  std::vector<std::uint32_t> m_copied;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_WALLS_WALL_CUT_H
