// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_VERTEX_OWNERS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_VERTEX_OWNERS_H

// The nearest source of each vertex, while distances are propagated. A shortest path to a vertex comes from its root,
// the last pseudo-source on it; so the roots lead back to the source.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Queries take constant time, amortized. One thread at a time may call an object, as queries remember what they find.
template <typename FT_>
class Vertex_owners
{
public:
  using FT = FT_;
  using Field = Vertex_distance_field<FT>;

  // Starts anew. The field, into which the propagation writes, is referred to, not copied. Takes time linear in the
  // number of vertices.
  void reset(std::size_t number_of_vertices, const Field& field)
  {
    m_field = &field;
    m_source.assign(number_of_vertices, Known_source{FT(-1), null_id});
    m_first_of_equal.clear();
    m_site_of_root.clear();
    m_final_distance = Field::infinity();
  }

  // Tells the site of each vertex that may be its own root: of a source, or with curves, when distances are final, of
  // what Site_strips::sites_of_roots() finds. All answers are these sites then, and not vertices. Call it before the
  // first query, and unite no sources.
  void set_sites(std::vector<Vertex_id> site_of_root) { m_site_of_root = std::move(site_of_root); }

  // Gives the cell of `source` to `first`, as the two tie everywhere up to rounding. (Otherwise rounding would decide
  // for each edge anew which of them is nearer.) If another source is nearer to `first`, so that it has no cell itself,
  // `source` keeps its cell. Call it after reset() and before the first query. `first` is not united with a third one:
  // pairs do not form chains (for_each_equal_source()).
  void unite(Vertex_id source, Vertex_id first) { m_first_of_equal[source] = first; }

  // Tells which distances are final: those up to `reached`. Queries remember no source of a vertex whose path may still
  // change. At first, all distances count as final.
  void set_final_distance(const FT& reached) { m_final_distance = reached; }

  // Returns the nearest source of a vertex whose distance is final, null_id if none reaches it. Of two sources that
  // have been united it is the first one, unless that has no cell.
  Vertex_id operator()(Vertex_id v)
  {
    const Vertex_id source = source_of(v);
    if(m_first_of_equal.empty())
      return source;
    const Vertex_id first = first_of_equal(source);
    return first != source && m_field->is_source(first) ? first : source;
  }

  // Returns the nearest source of each vertex after the end of the propagation, null_id where none arrives.
  std::vector<Vertex_id> all()
  {
    std::vector<Vertex_id> result(m_source.size());
    for(Vertex_id v = 0; v < result.size(); ++v)
    {
      CGAL_expensive_assertion(!m_site_of_root.empty() || source_of(v) == m_field->source_of(v));
      result[v] = (*this)(v);
    }
    return result;
  }

  // Returns the source whose cell `source` shares: another one after unite(), otherwise itself. (null_id stays.)
  Vertex_id first_of_equal(Vertex_id source) const
  {
    if(m_first_of_equal.empty())
      return source;
    const auto it = m_first_of_equal.find(source);
    return it != m_first_of_equal.end() ? it->second : source;
  }

  // Returns the source from which the shortest path to v known so far starts, null_id if there is none. Follows the
  // roots back and remembers the answer for each of them whose distance is final, as that chain may be long. Amortized:
  // each vertex is asked for its root once for each distance that it takes, if distances are final (see
  // set_final_distance()).
  Vertex_id source_of(Vertex_id v)
  {
    Vertex_id last = v;
    while(!is_source_known(last))
    {
      const Vertex_id root = m_field->arrival[last].root;
      if(root == null_id)
        return null_id;
      if(root == last)
        m_source[last] = Known_source{m_field->distance[last], m_site_of_root.empty() ? last : m_site_of_root[last]};
      last = root;
    }
    const Vertex_id source = m_source[last].vertex;
    for(; !is_source_known(v); v = m_field->arrival[v].root)
      if(!(m_final_distance < m_field->distance[v]))
        m_source[v] = Known_source{m_field->distance[v], source};
    return source;
  }

  // Asks the processor to fetch what a query about v reads first.
  void prefetch(Vertex_id v) const { internal::prefetch(&m_source[v]); }

  std::size_t memory() const { return m_source.capacity() * sizeof(Known_source); }

private:
  // The source from which a vertex is reached, valid as long as the vertex has this distance.
  struct Known_source
  {
    FT distance;
    Vertex_id vertex;
  };

  // (The distance of the entry is -1 before v is asked for the first time, which no vertex has.)
  bool is_source_known(Vertex_id v) const { return m_source[v].distance == m_field->distance[v]; }

  const Field* m_field = nullptr;
  std::vector<Known_source> m_source; // by vertex
  std::unordered_map<Vertex_id, Vertex_id> m_first_of_equal;
  std::vector<Vertex_id> m_site_of_root; // by vertex; empty where sources are sites
  FT m_final_distance = Field::infinity(); // see set_final_distance()
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_VORONOI_EDGES_VERTEX_OWNERS_H
