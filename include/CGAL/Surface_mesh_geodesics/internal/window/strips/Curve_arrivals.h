// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_CURVE_ARRIVALS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_CURVE_ARRIVALS_H

// Where paths from curves begin: what is known of them besides the field of distances. A path ends, seen from its
// other end, at a vertex of a curve, as from any source; or it runs along a ray of a strip to the foot of that ray, a
// point inside of a source edge.

#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Edge_strip_field.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The foot of a ray: on a side of a source edge (Strip::side), at an abscissa in the frame of the halfedge on that
// side.
template <typename FT>
struct Strip_foot
{
  std::uint32_t side;
  FT abscissa;
};

// The edge of which this is a side.
template <typename FT>
const Source_edge<FT>& edge_of_side(const Source_curves<FT>& curves, std::uint32_t side)
{
  return curves.edges[side / 2];
}

// The halfedge on a side of a source edge; its face is the one that the rays enter first.
template <typename FT>
Halfedge_id halfedge_of_side(const Source_curves<FT>& curves, std::uint32_t side)
{
  const Source_edge<FT>& e = edge_of_side(curves, side);
  return side % 2 == 0 ? e.left : e.right;
}

// The point of a curve at a vertex on curves: of the first of those with the smallest offset. Requires: v is a source.
template <typename FT>
const Curve_point<FT>& curve_point_at(const Source_curves<FT>& curves, Vertex_id v)
{
  const auto it = std::lower_bound(curves.vertices.begin(), curves.vertices.end(), v,
                                   [](const Source_vertex<FT>& a, Vertex_id b) { return a.vertex < b; });
  CGAL_assertion(it != curves.vertices.end() && it->vertex == v);
  return it->point;
}

// Why a place is more than a point of a curve: results name one curve, that of the edge or of the vertex that counts
// there. All curves that have the point are found by the edge or the vertex itself (curves_at()).
//
// Where a path from curves begins: at a vertex on a curve, at a point inside of a source edge, or at an end of the edge
// from which its last ray comes.
template <typename FT>
struct Curve_place
{
  Vertex_id vertex;            // or null_id
  const Source_edge<FT>* edge; // or null
  FT t;                        // the part of the edge before the point
};

// The place of a foot. Rounding may have moved the foot past an end of its edge.
template <typename FT>
Curve_place<FT> place_of_foot(const Source_curves<FT>& curves, const Strip_foot<FT>& foot)
{
  const Source_edge<FT>& e = edge_of_side(curves, foot.side);
  const FT along = (std::min)(FT(1), (std::max)(FT(0), FT(foot.abscissa / e.length)));
  const FT t = foot.side % 2 == 0 ? along : FT(1 - along);
  const bool is_end = (std::min)(t, FT(1 - t)) <= Tolerance<FT>::interval();
  return {!is_end ? null_id : t < FT(1) / 2 ? e.first : e.last, &e, t};
}

// The place from which the shortest path to v comes. A vertex that a strip has reached is its own root, but no source;
// foot_of(vertex) is where that path begins. Takes time linear in the number of vertices at which the path bends, and
// logarithmic in that of vertices on curves. Requires: v is reached.
template <typename FT, typename FootOf>
Curve_place<FT> place_of_vertex(const Source_curves<FT>& curves, const Vertex_distance_field<FT>& field, FootOf foot_of,
                                Vertex_id v)
{
  const Vertex_id root = field.source_of(v);
  CGAL_assertion(root != null_id);
  return field.is_source(root) ? Curve_place<FT>{root, nullptr, FT(0)} : place_of_foot(curves, foot_of(root));
}

// The point of a curve at a place: of the curve of its edge, unless another curve counts at the end of the edge (of
// those with the smallest offset, the first).
template <typename FT>
Curve_point<FT> curve_point_at(const Source_curves<FT>& curves, const Curve_place<FT>& place)
{
  if(place.vertex != null_id)
  {
    const Curve_point<FT>& at_vertex = curve_point_at(curves, place.vertex);
    if(place.edge == nullptr || at_vertex.curve != place.edge->curve)
      return at_vertex;
  }
  const Source_edge<FT>& e = *place.edge;
  return {e.curve, e.segment, FT(e.first_parameter + place.t * (e.last_parameter - e.first_parameter))};
}

// The point of a curve from which the shortest path to v comes, as for place_of_vertex().
template <typename FT, typename FootOf>
Curve_point<FT> curve_point_of_vertex(const Source_curves<FT>& curves, const Vertex_distance_field<FT>& field,
                                      FootOf foot_of, Vertex_id v)
{
  return curve_point_at(curves, place_of_vertex(curves, field, foot_of, v));
}

// The curves that have a place, of those with the smallest offset there, in ascending order. An inner point of an edge
// that is its end up to rounding counts for the end: it may be the end of a strip, which rounding has moved. `extent`
// is that of the component of the place. Takes time logarithmic in the number of elements on several curves, plus that
// of sorting the result.
template <typename FT>
std::vector<std::uint32_t> curves_at(const Source_curves<FT>& curves, Curve_place<FT> place, const FT& extent)
{
  if(place.edge != nullptr)
  {
    const bool is_nearer_to_first = place.t < FT(1) / 2;
    const FT to_end = place.edge->length * (is_nearer_to_first ? place.t : FT(1 - place.t));
    if(to_end <= Tolerance<FT>::end_of_strip() * extent)
      place.vertex = is_nearer_to_first ? place.edge->first : place.edge->last;
  }
  const bool is_vertex = place.vertex != null_id;
  const std::uint32_t element = is_vertex ? place.vertex : (std::min)(place.edge->left, place.edge->right);
  const std::vector<Further_curve>& further
    = is_vertex ? curves.further_curves_of_vertices : curves.further_curves_of_edges;
  std::vector<std::uint32_t> result(1, is_vertex ? curve_point_at(curves, place.vertex).curve : place.edge->curve);
  auto it = std::lower_bound(further.begin(), further.end(), element,
                             [](const Further_curve& a, std::uint32_t b) { return a.element < b; });
  for(; it != further.end() && it->element == element; ++it)
    result.push_back(it->curve);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// What queries of paths read. The curves are inserted into the mesh as long as they are known here.
//
// Invariant: m_side has the halfedges on all sides of `curves.edges`.
template <typename FT>
struct Curve_arrivals
{
  Source_curves<FT> curves;
  Edge_strip_field<FT> strips;
  std::vector<Strip_foot<FT>> foot; // by vertex; counts for those that are their own roots, but no sources

  // Replaces the curves and forgets what is known of paths. Linear in the number of source edges.
  void set_curves(Source_curves<FT> inserted)
  {
    clear();
    curves = std::move(inserted);
    for(std::uint32_t side = 0; side < 2 * curves.edges.size(); ++side)
      if(halfedge_of_side(curves, side) != null_id)
        m_side.emplace(halfedge_of_side(curves, side), side);
  }

  void clear()
  {
    curves = Source_curves<FT>();
    m_side.clear();
    forget_paths();
  }

  // Forgets the result of a run, but not the curves, which stay inserted.
  void forget_paths()
  {
    strips.clear();
    foot = std::vector<Strip_foot<FT>>();
  }

  // Returns the side of a source edge that a halfedge is, or null_id.
  std::uint32_t side_of(Halfedge_id h) const
  {
    const auto it = m_side.find(h);
    return it == m_side.end() ? null_id : it->second;
  }

  const Source_edge<FT>& edge_of_side(std::uint32_t side) const { return internal::edge_of_side(curves, side); }

  // The place from which the shortest path to v comes. Requires: v is reached.
  Curve_place<FT> place_of(const Vertex_distance_field<FT>& field, Vertex_id v) const
  {
    return place_of_vertex(curves, field, [this](Vertex_id u) { return foot[u]; }, v);
  }

  Curve_point<FT> point_of(const Vertex_distance_field<FT>& field, Vertex_id v) const
  {
    return curve_point_at(curves, place_of(field, v));
  }

  // An estimate: nodes of the table are larger than their contents.
  std::size_t memory() const
  {
    return strips.memory() + foot.capacity() * sizeof(Strip_foot<FT>)
         + curves.edges.capacity() * sizeof(Source_edge<FT>) + curves.vertices.capacity() * sizeof(Source_vertex<FT>)
         + (curves.further_curves_of_edges.capacity() + curves.further_curves_of_vertices.capacity())
             * sizeof(Further_curve)
         + m_side.size() * (sizeof(Halfedge_id) + sizeof(std::uint32_t));
  }

private:
  std::unordered_map<Halfedge_id, std::uint32_t> m_side;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_WINDOW_STRIPS_CURVE_ARRIVALS_H
