// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIRECTIONS_PATH_DIRECTIONS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIRECTIONS_PATH_DIRECTIONS_H

// The directions in which shortest paths leave their sources, from what a Path_solver knows: with the distances, the
// logarithmic map. The solver computes the direction of one path (Departure.h); here is which path to look at.
//
// Solver is Path_solver, and `face_of_source(number)` is the face in which the user gave a source. Curves have no
// tangent frame, so paths from them have no direction: not a number. (The angle to the curve would be one, but at the
// inside of a segment it is always a right angle, and at its corners it says little.)
//
// The functions only read the solver, so several threads may call them at once, as they may ask for paths.

#include <CGAL/Surface_mesh_geodesics/internal/interface/directions/full_turns.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Departure.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Ray_sectors.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Returns a direction as users get it.
inline double direction_for_user(const Direction_at_source& d)
{
  return d.is_at_border ? (std::max)(d.angle, 0.) : reduced_angle(d.angle, full_turn);
}

// Returns the direction of the path to a point; not a number if no source reaches it, or if there are curves among the
// sources. Throws what Path_solver::path() throws.
//
// Traces the first straight piece of the path only, the one at the source. Its end is a vertex, whose own path is this
// piece. A location whose path is straight has no such vertex, and is traced by itself.
template <typename Solver, typename FaceOfSource>
double direction_of_path(const Solver& solver, typename Solver::Query q, FaceOfSource face_of_source)
{
  if(!solver.has_run() || solver.has_curves())
    return std::numeric_limits<double>::quiet_NaN();
  typename Solver::Arrival a = solver.arrival(q);
  if(!a.is_reached())
    return std::numeric_limits<double>::quiet_NaN();
  if(q.vertex != null_id || !solver.field().is_source(a.root))
  {
    q = typename Solver::Query();
    q.vertex = solver.end_of_first_piece(a.root);
    a = solver.arrival(q);
  }
  // (A path from a location in a face begins behind the location.)
  const auto steps = solver.path(q, a);
  const Departure<double> d = steps.size() == 1 && q.vertex == null_id
                                ? departure_to_point(solver.mesh(), steps.back().vertex, q.face, q.coordinates)
                                : departure(solver.mesh(), steps);
  return direction_for_user(solver.direction_of_departure(d, face_of_source(solver.source_number(a))));
}

// The directions of straight paths from sources to vertices. Requires: the solver has run, and has no curves. Objects
// are made for one call: their tables have some numbers for each edge, which is more than all results together. No
// other thread sees them, so several threads may ask for directions at once. What is asked of the solver does not
// change it.
// The tangent frame of a source is asked once for each face through which paths leave it: in a face, the direction is
// linear in the angle.
template <typename Solver, typename FaceOfSource>
class Straight_directions
{
public:
  Straight_directions(const Solver& solver, FaceOfSource face_of_source)
    : m_solver(solver), m_face_of_source(face_of_source), m_sectors(solver.mesh(), solver.field())
  {}

  // Requires: v is reached, and is a source or has one as its root. A path is traced as for a single query near the
  // source, where it is short, and where rounding hides the way. Both give the same direction, up to the rounding of
  // images: both are measured at the end of the straight piece, not at the first edge, which may be next to the source.
  double operator()(Vertex_id v)
  {
    const auto ray = m_sectors.ray_to(v);
    if(ray.halfedge == null_id)
    {
      typename Solver::Query q;
      q.vertex = v;
      return direction_of_path(m_solver, q, m_face_of_source);
    }
    const auto inserted = m_frames.emplace(ray.halfedge, Frame());
    Frame& frame = inserted.first->second;
    if(inserted.second)
    {
      const auto f = m_face_of_source(m_solver.source_at(m_solver.mesh().source(ray.halfedge)));
      frame.begin = m_solver.direction_of_departure(Departure<double>{ray.halfedge, 0.}, f);
      frame.growth = m_solver.direction_of_departure(Departure<double>{ray.halfedge, 1.}, f).angle - frame.begin.angle;
    }
    return direction_for_user({frame.begin.angle + frame.growth * ray.angle, frame.begin.is_at_border});
  }

private:
  // Of the directions in one face: that of its first halfedge, and how they grow with the angle from there.
  struct Frame
  {
    Direction_at_source begin;
    double growth = 0;
  };

  const Solver& m_solver;
  FaceOfSource m_face_of_source;
  Ray_sectors<double> m_sectors;
  std::unordered_map<Halfedge_id, Frame> m_frames;
};

// Returns the first vertex behind the source at which the path to v bends, as Path_solver::end_of_first_piece() does;
// `end` has those that are known (follow_path_back()). Requires: v is reached.
inline Vertex_id end_of_first_piece(const Vertex_distance_field<double>& field, Vertex_id v,
                                    std::vector<Vertex_id>& end)
{
  return follow_path_back(field, v, end, [&](Vertex_id u)
  { return field.is_source(u) || field.is_source(field.arrival[u].root); });
}

// Writes the directions of all vertices. All vertices behind a bend have the direction of the path to the bend. Nearer
// vertices come first, roughly: then the sectors of edges are complete before farther paths ask for them.
template <typename TriangleMesh, typename Solver, typename FaceOfSource, typename VertexDirectionMap>
void put_directions(const TriangleMesh& tm, const Solver& solver, FaceOfSource face_of_source, VertexDirectionMap map)
{
  using Value = typename boost::property_traits<VertexDirectionMap>::value_type;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const bool has_directions = solver.has_run() && !solver.has_curves();
  // By vertex of the refined mesh, which has the user's vertices first.
  std::vector<double> direction;
  std::vector<Vertex_id> end;
  if(has_directions)
  {
    direction.assign(solver.mesh().number_of_vertices(), unknown);
    end.assign(direction.size(), null_id);
    Straight_directions<Solver, FaceOfSource> straight(solver, face_of_source);
    for(const Vertex_id v : solver.field().reached)
      if(end_of_first_piece(solver.field(), v, end) == v)
        direction[v] = straight(v);
  }
  for(const auto v : vertices(tm))
  {
    double d = unknown;
    if(has_directions)
    {
      const auto q = solver.query(v);
      if(solver.arrival(q).is_reached())
        d = direction[end[q.vertex]];
    }
    put(map, v, static_cast<Value>(d));
  }
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIRECTIONS_PATH_DIRECTIONS_H
