// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_VERTEX_DISTANCE_FIELD_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_VERTEX_DISTANCE_FIELD_H

// The result of a propagation at the vertices: the distance, and how the shortest path arrives. A path to a vertex can
// be traced back from that; no windows are needed.
//
// The field lists the vertices that have been reached. The results of a propagation that ended early can therefore
// be read and removed in time proportional to the area that it reached.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The last straight piece of the shortest path to a vertex: it comes from the vertex `root`, crosses `halfedge`, which
// is opposite to the vertex in a face, at `abscissa` (measured from the source of the halfedge), and enters the vertex
// through that face. For a source, `halfedge` is null_id and `root` is the vertex itself. If the piece is an edge of
// the mesh, it "crosses" the halfedge at its end, which is the root.
template <typename FT>
struct Vertex_arrival
{
  FT abscissa;
  Halfedge_id halfedge = null_id;
  Vertex_id root = null_id;
};

// The image of the root in the frame of the halfedge of arrival: the point (x, -depth). It means nothing if the last
// piece is an edge of the mesh, which ends in its first face.
template <typename FT>
struct Arrival_image
{
  FT x = 0, depth = 0;
};

// Invariants between the steps of a run: `reached` has exactly the vertices whose distance is finite, and these have a
// root in `arrival`. All lengths are in the unit of the mesh. Distances shrink during a run; which of them are final is
// known to the propagation that fills the field (reached_distance()).
//
// Threads: several may read the field while no run changes it. Wavefront.h says who changes it during a run.
template <typename FT>
struct Vertex_distance_field
{
  std::vector<FT> distance;
  std::vector<Vertex_arrival<FT>> arrival;
  std::vector<Vertex_id> reached; // the vertices with a finite distance, each once
  // By vertex, if keeps_images; needed to trace paths only. A path that grazes a vertex may bend where it crosses the
  // edge, by an angle that changes no digit of the distance. So the abscissa does not determine the image.
  std::vector<Arrival_image<FT>> image;
  bool keeps_images = false;
  // Distances up to this one are final. A larger one may be too large, or infinite, but it is not really smaller than
  // this. Who ends a run early and still asks for paths sets it.
  FT final_distance = infinity();

  // Sets all distances to infinity. Takes time linear in the number of vertices.
  void reset(std::size_t number_of_vertices)
  {
    reserve_large(image, keeps_images ? number_of_vertices : 0);
    image.assign(keeps_images ? number_of_vertices : 0, Arrival_image<FT>());
    reserve_large(distance, number_of_vertices);
    distance.assign(number_of_vertices, infinity());
    reserve_large(arrival, number_of_vertices);
    arrival.assign(number_of_vertices, Vertex_arrival<FT>());
    reached.clear();
    final_distance = infinity();
  }

  // Does the same in time proportional to the number of vertices that were reached.
  void restart(std::size_t number_of_vertices)
  {
    for(const Vertex_id v : reached)
    {
      distance[v] = infinity();
      arrival[v] = Vertex_arrival<FT>();
      if(keeps_images)
        image[v] = Arrival_image<FT>();
    }
    reached.clear();
    final_distance = infinity();
    image.resize(keeps_images ? number_of_vertices : 0);
    distance.resize(number_of_vertices, infinity());
    arrival.resize(number_of_vertices);
  }

  // Requires: d is finite.
  void set_distance(Vertex_id v, const FT& d)
  {
    CGAL_assertion(d < infinity());
    if(!(distance[v] < infinity()))
      reached.push_back(v);
    distance[v] = d;
  }

  static FT infinity() { return std::numeric_limits<FT>::infinity(); }

  // Returns a lower bound of the length of all paths to v, also if the run has ended early.
  FT least_distance(Vertex_id v) const { return (std::min)(distance[v], final_distance); }

  // Returns whether the shortest path to v begins at v. A source that is nearer to another one, because of its offset,
  // is not a source in this sense.
  bool is_source(Vertex_id v) const
  {
    return arrival[v].root == v && arrival[v].halfedge == null_id;
  }

  // Returns the vertex of the source from which the shortest path to v comes, or null_id if v is not reached. Takes
  // time linear in the number of vertices where the path bends.
  Vertex_id source_of(Vertex_id v) const
  {
    while(arrival[v].root != null_id && arrival[v].root != v)
      v = arrival[v].root;
    return arrival[v].root;
  }

  std::size_t memory() const
  {
    return distance.capacity() * sizeof(FT) + arrival.capacity() * sizeof(arrival[0])
         + image.capacity() * sizeof(image[0]) + reached.capacity() * sizeof(Vertex_id);
  }
};

// Follows the path to v back, from bend to bend, up to the first vertex for which is_last() holds, and returns it.
// `last_of` has the results that are known, null_id for other vertices. All vertices on the way get the same one, so
// that no later path runs through them again: n calls take linear time, where each path alone may have n bends.
// Requires: is_last() holds for sources and for vertices that are not reached.
template <typename FT, typename IsLast>
Vertex_id follow_path_back(const Vertex_distance_field<FT>& field, Vertex_id v, std::vector<Vertex_id>& last_of,
                           IsLast is_last)
{
  Vertex_id last = v;
  while(last_of[last] == null_id && !is_last(last))
    last = field.arrival[last].root;
  const Vertex_id result = last_of[last] == null_id ? last : last_of[last];
  for(last_of[last] = result; v != last; v = field.arrival[v].root)
    last_of[v] = result;
  return result;
}

// The same as source_of(), for many vertices of one field, in linear time.
template <typename FT>
class Sources_of_vertices
{
public:
  // The field must outlive this object and not change.
  explicit Sources_of_vertices(const Vertex_distance_field<FT>& field)
    : m_field(field), m_first(field.distance.size(), null_id)
  {}

  // Returns the source of v; null_id if v is not reached.
  Vertex_id operator()(Vertex_id v)
  {
    const auto root = [this](Vertex_id u) { return m_field.arrival[u].root; };
    return root(follow_path_back(m_field, v, m_first,
                                 [&](Vertex_id u) { return root(u) == null_id || root(u) == u; }));
  }

private:
  const Vertex_distance_field<FT>& m_field;
  std::vector<Vertex_id> m_first; // by vertex: where its path begins; null_id as long as that is unknown
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_VERTEX_DISTANCE_FIELD_H
