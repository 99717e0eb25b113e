// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCE_SET_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCE_SET_H

// The sources of a propagation in terms of the intrinsic mesh: vertices, and locations in faces, which become vertices
// before the propagation starts. Sources are numbered by their positions in the range of the user, from 0.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>

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

// A source in a face of the intrinsic mesh, and its number.
template <typename FT>
struct Located_source
{
  Face_id face;
  Barycentric<FT> coordinates;
  std::size_t position;
};

// All sources of a propagation.
template <typename FT>
struct Source_set
{
  std::vector<Vertex_id> vertices;         // by number; null_id for located ones that are not inserted
  std::vector<Located_source<FT>> located; // those in faces
  std::vector<FT> offsets;                 // by number; or empty: all are 0. In the unit of the intrinsic mesh.

  std::size_t size() const { return vertices.size(); }
  FT offset(std::size_t i) const { return offsets.empty() ? FT(0) : offsets[i]; }
};

// Makes vertices of all located sources and sets vertices[position]. Inserts in the order of faces and coordinates, so
// that the result does not depend on the order of the sources.
template <typename FT>
void insert_located_sources(std::vector<Located_source<FT>>& sources, Source_insertion<FT>& insertion,
                            std::vector<Vertex_id>& vertices)
{
  std::sort(sources.begin(), sources.end(),
            [](const Located_source<FT>& a, const Located_source<FT>& b)
            { return std::tie(a.face, a.coordinates) < std::tie(b.face, b.coordinates); });
  for(const Located_source<FT>& s : sources)
    vertices[s.position] = insertion.insert(s.face, s.coordinates);
}

// Which source counts at a vertex: of several, the first one of those with the smallest offset.
class Source_numbers
{
public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Numbers the sources of a set. Requires: all are vertices. Takes time linear in their number, but for sorting.
  template <typename FT>
  void assign(const Source_set<FT>& set)
  {
    m_numbers.clear();
    for(std::size_t i = 0; i < set.size(); ++i)
    {
      CGAL_assertion(set.vertices[i] != null_id);
      m_numbers.emplace_back(set.vertices[i], i);
    }
    std::stable_sort(m_numbers.begin(), m_numbers.end(), [&](const Entry& a, const Entry& b)
                     { return a.first < b.first
                           || (a.first == b.first && set.offset(a.second) < set.offset(b.second)); });
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

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_SOURCE_SET_H
