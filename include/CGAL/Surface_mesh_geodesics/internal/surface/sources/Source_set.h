// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_SOURCE_SET_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_SOURCE_SET_H

// The sources of a propagation in terms of the intrinsic mesh: vertices, and locations in faces, which become vertices
// before the propagation starts. Sources are numbered by their positions in the range of the user, from 0.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Face_parts.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A source in a face of the intrinsic mesh, and its number `position`. The coordinates are in the order of the corners
// of that face; they are valid (are_valid_coordinates()) and may be exactly those of a corner or of a point of an edge.
template <typename FT>
struct Located_source
{
  Face_id face;
  Barycentric<FT> coordinates;
  std::size_t position;
};

// All sources of a propagation. Intrinsic_surface makes a set from the user's sources, once all of them are checked.
//
// A source at a wall is on several sides of it, which have vertices of their own. Its first one has the number of the
// user; the others are listed behind all sources, and number() tells to which of them they belong.
//
// Invariants: `offsets` is empty or has size() entries, all finite and not negative. Each number i has a vertex of the
// mesh in vertices[i], or null_id there and one entry in `located` with the position i. After insert_located_sources()
// no vertex is null_id; it stays valid until the insertion is undone. Several sources may be at one vertex.
template <typename FT>
struct Source_set
{
  std::vector<Vertex_id> vertices;         // by number; null_id for located ones that are not inserted
  std::vector<Located_source<FT>> located; // those in faces
  std::vector<FT> offsets;                 // by number; or empty: all are 0. In the unit of the intrinsic mesh.
  std::vector<std::size_t> behind_walls;   // the numbers of the sources that the last entries repeat

  std::size_t size() const { return vertices.size(); }

  // The sources of the user, without those that are repeated.
  std::size_t number_of_sources() const { return vertices.size() - behind_walls.size(); }

  // The number of the source of the user that entry i is. Requires: i < size().
  std::size_t number(std::size_t i) const
  {
    return i < number_of_sources() ? i : behind_walls[i - number_of_sources()];
  }

  // Lists source i once more, at v; null_id if it is located.
  void add_behind_wall(std::size_t i, Vertex_id v)
  {
    vertices.push_back(v);
    behind_walls.push_back(i);
    if(!offsets.empty())
      offsets.push_back(FT(offsets[i]));
  }

  // Requires: i < size().
  FT offset(std::size_t i) const { return offsets.empty() ? FT(0) : offsets[i]; }
};

// Makes vertices of n sources in one face, which are in the order of their coordinates.
//
// If these are many, one in the middle of those that are still missing comes next: rank r follows the ranks whose bits,
// read backward, are a smaller number. So the parts of the face shrink evenly, and each insertion flips few edges. (In
// order of coordinates, each source would be beside all others, and have long and narrow parts beyond.)
template <typename FT>
void insert_sources_of_face(const Located_source<FT>* sources, std::size_t n, Source_insertion<FT>& insertion,
                            std::vector<Vertex_id>& vertices)
{
  std::vector<std::size_t> first; // of each run of equal locations
  for(std::size_t i = 0; i < n; ++i)
    if(i == 0 || sources[i].coordinates != sources[i - 1].coordinates)
      first.push_back(i);
  first.push_back(n);
  const std::size_t number = first.size() - 1;
  // Equal locations get one vertex without a search, since rounding may hide it between narrow parts.
  const auto insert = [&](std::size_t k)
  {
    const Located_source<FT>& s = sources[first[k]];
    const Vertex_id v = insertion.insert(s.face, s.coordinates);
    for(std::size_t i = first[k]; i < first[k + 1]; ++i)
      vertices[sources[i].position] = v;
    return v;
  };
  if(number <= Face_parts<FT>::few / 2)
  {
    for(std::size_t k = 0; k < number; ++k)
      insert(k);
    return;
  }
  // k runs through the mirror images of the numbers with as many bits as `limit` has zeros.
  std::size_t limit = 1;
  while(limit < number)
    limit *= 2;
  for(std::size_t i = 0, k = 0; i < limit; ++i)
  {
    if(k < number)
      insertion.flip_around(insert(k));
    // Adds 1 to the mirror image: the carry goes downward.
    std::size_t bit = limit / 2;
    for(; (k & bit) != 0; bit /= 2)
      k &= ~bit;
    k |= bit;
  }
}

// Makes vertices of all located sources and sets vertices[position]. Sorts `sources` and inserts in the order of faces
// and coordinates, so that the refined mesh does not depend on the order in which the user gave the sources. A source
// at a vertex gets that vertex; equal locations get the same vertex.
// Requires: `insertion` refines the mesh of the faces, and the faces are those of the mesh without sources; `vertices`
// has an entry for each position. Takes the time of sorting and of the insertions.
template <typename FT>
void insert_located_sources(std::vector<Located_source<FT>>& sources, Source_insertion<FT>& insertion,
                            std::vector<Vertex_id>& vertices)
{
  std::sort(sources.begin(), sources.end(),
            [](const Located_source<FT>& a, const Located_source<FT>& b)
            { return std::tie(a.face, a.coordinates) < std::tie(b.face, b.coordinates); });
  for(std::size_t begin = 0, end; begin < sources.size(); begin = end)
  {
    for(end = begin + 1; end < sources.size() && sources[end].face == sources[begin].face; ++end)
    {
    }
    insert_sources_of_face(&sources[begin], end - begin, insertion, vertices);
  }
}

// Which source counts at a vertex: of several, the one with the smallest offset; in a tie, the one with the smallest
// number. A default object knows no source.
class Source_numbers
{
public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Numbers the sources of a set and forgets those of the set before. Requires: all of them are vertices, the located
  // ones inserted. Takes the time of sorting them.
  template <typename FT>
  void assign(const Source_set<FT>& set)
  {
    m_numbers.clear();
    for(std::size_t i = 0; i < set.size(); ++i)
    {
      CGAL_assertion(set.vertices[i] != null_id);
      m_numbers.emplace_back(set.vertices[i], set.number(i));
    }
    std::sort(m_numbers.begin(), m_numbers.end(), [&](const Entry& a, const Entry& b)
              {
                const FT offset_a = set.offset(a.second), offset_b = set.offset(b.second);
                return std::tie(a.first, offset_a, a.second) < std::tie(b.first, offset_b, b.second);
              });
    m_numbers.erase(std::unique(m_numbers.begin(), m_numbers.end(),
                                [](const Entry& a, const Entry& b) { return a.first == b.first; }),
                    m_numbers.end());
  }

  // Returns the number of the source that counts at v, or `none`. Takes time logarithmic in the number of sources.
  std::size_t number_at(Vertex_id v) const
  {
    const auto first = std::lower_bound(m_numbers.begin(), m_numbers.end(), Entry(v, 0));
    return first != m_numbers.end() && first->first == v ? first->second : none;
  }

private:
  using Entry = std::pair<Vertex_id, std::size_t>;

  std::vector<Entry> m_numbers; // sorted by vertex
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCES_SOURCE_SET_H
