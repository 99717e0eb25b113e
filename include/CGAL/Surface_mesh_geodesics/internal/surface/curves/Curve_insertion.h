// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_CURVE_INSERTION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_CURVE_INSERTION_H

// Makes edges of the refined mesh of the curves that are sources: inserts the locations of each curve as vertices
// (Source_insertion.h), and wherever a segment crosses an edge of a part of its face, a vertex at the crossing. The
// segment is a chain of edges then. Curves that cross, touch or overlap share vertices and edges.
//
// All curves are walked twice. An insertion may divide an edge of a curve that was walked before, so the edges are
// collected in a walk that inserts nothing.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Positions in a face are compared by barycentric coordinates, in which all faces are alike: a segment that is a point
// up to Tolerance::barycentric() has no direction, and a vertex that is nearer to a segment is on it. That moves a
// curve by this part of the longest side of the face, as it moves sources.
template <typename FT>
class Curve_insertion
{
  using Mesh = Intrinsic_mesh<FT>;
  using Coordinates = Barycentric<FT>;
  using Curves = std::vector<Located_curve<FT>>;

public:
  // Both have to outlive this object. `insertion` refines `mesh`.
  Curve_insertion(const Mesh& mesh, Source_insertion<FT>& insertion) : m_mesh(mesh), m_insertion(insertion) {}

  // Inserts the curves and returns their edges and vertices. Takes the time of sorting the locations and of the
  // insertions, plus the degrees of the vertices on the curves. An insertion looks at all parts of its face: the time
  // is quadratic in the number of locations in one face. The refined mesh does not depend on the order of the curves.
  // Throws Invalid_geodesic_input where segments of one face nearly coincide, so that rounding hides in which order
  // they cross the parts of the face; they were found at distances of 1e-12 of the face only. Requires: nothing is
  // inserted yet; the faces are those of the mesh without insertions.
  Source_curves<FT> insert(const Curves& curves)
  {
    m_first_faces = m_mesh.number_of_faces();
    insert_locations(curves);
    // Each walk ends, and the number of insertions is finite: a crossing that is a vertex is met as one the next time.
    std::size_t walks = 0;
    do
    {
      m_result = Source_curves<FT>();
      m_has_inserted = false;
      for(std::size_t i = 0; i < curves.size(); ++i)
        add_curve(curves[i], m_vertices[i]);
    } while(m_has_inserted && ++walks < most_walks);
    if(m_has_inserted)
      reject();
    remove_copies();
    Source_curves<FT> result;
    std::swap(result, m_result);
    return result;
  }

private:
  // Two walks in most cases; a few more where rounding lets a second walk see another crossing.
  static constexpr std::size_t most_walks = 64;

  // A vertex of the refined mesh, and its coordinates in the face that a segment runs through.
  struct Place
  {
    Vertex_id vertex;
    Coordinates at;
  };

  // The edge to a neighbor of a place in the same face: the halfedges there and back, or null_id.
  struct Step
  {
    Place to{null_id, Coordinates{}};
    Halfedge_id there = null_id, back = null_id;
    FT progress = 0; // along the segment
  };

  // A part of the face around a place: the segment leaves it across the edge of `halfedge`, between its ends. The
  // weights are those of the ends of the edge at the crossing; they are positive and add up to 1. The crossing gets its
  // coordinates from them, so that both parts of the edge see the same point.
  struct Exit
  {
    Halfedge_id halfedge = null_id;
    FT source_weight = 0, target_weight = 0;
    Coordinates at{}, source{}; // of the crossing, and of the source of the halfedge
  };

  // The direction of what is left of a segment, in the plane of the last two coordinates of its face.
  struct Line
  {
    Coordinates from;
    FT x, y, length;

    // In these coordinates the corners of the face are counterclockwise, as they are on the surface; angles and lengths
    // differ, but no answer depends on them beyond rounding.
    Line(const Coordinates& a, const Coordinates& b)
      : from(a), x(b[1] - a[1]), y(b[2] - a[2]), length(norm<FT>(x, y))
    {}

    // The signed distance of a point from the line, positive on the left, and its position along the line.
    FT side(const Coordinates& p) const { return (x * (p[2] - from[2]) - y * (p[1] - from[1])) / length; }
    FT position(const Coordinates& p) const { return (x * (p[1] - from[1]) + y * (p[2] - from[2])) / length; }
  };

  // Each segment begins at the vertex where the one before ends, although that one may be in another face: their
  // coordinates agree up to rounding only. So only the beginnings, and the ends of open curves, are inserted.
  void insert_locations(const Curves& curves)
  {
    struct Location
    {
      Face_id face;
      Coordinates at;
      std::size_t curve, position;
    };
    std::vector<Location> locations;
    m_vertices.assign(curves.size(), std::vector<Vertex_id>());
    for(std::size_t i = 0; i < curves.size(); ++i)
    {
      const auto& segments = curves[i].segments;
      const auto add = [&](Face_id f, Coordinates at, std::size_t position)
      {
        f = to_first_face(f, at);
        locations.push_back(Location{f, at, i, position});
      };
      for(const Curve_segment<FT>& s : segments)
        add(s.face, s.from, static_cast<std::size_t>(&s - segments.data()));
      if(!segments.empty() && !curves[i].is_closed)
        add(segments.back().face, segments.back().to, segments.size());
      m_vertices[i].resize(segments.size() + 1, curves[i].vertex);
    }
    std::sort(locations.begin(), locations.end(), [](const Location& a, const Location& b)
              { return std::tie(a.face, a.at) < std::tie(b.face, b.at); });
    // Equal locations are next to each other, and are one vertex, whatever rounding lets the insertion find.
    const Location* last = nullptr;
    for(const Location& l : locations)
    {
      const bool is_new = last == nullptr || last->face != l.face || last->at != l.at;
      m_vertices[l.curve][l.position]
        = is_new ? m_insertion.insert(l.face, l.at) : m_vertices[last->curve][last->position];
      last = &l;
    }
    for(std::size_t i = 0; i < curves.size(); ++i)
      if(curves[i].is_closed && !curves[i].segments.empty())
        m_vertices[i].back() = m_vertices[i].front();
  }

  // Why: near a vertex, parts of a face may be as narrow as rounding. A point that is inserted from both sides of an
  // edge would become two vertices there, and curves that are one would be two.
  //
  // Returns the first face that has a point of the face f, and changes the coordinates to those there: a point
  // of an edge gets the same ones from both faces. Requires: nothing is inserted yet.
  Face_id to_first_face(Face_id f, Coordinates& at) const
  {
    Coordinates snapped = at;
    snap_coordinates(snapped);
    for(unsigned int k = 0; k < 3; ++k)
    {
      if(snapped[k] == 0 || snapped[next_corner(k)] == 0 || snapped[previous_corner(k)] != 0)
        continue;
      const Halfedge_id h = halfedge_of(f, k);
      const Halfedge_id first = m_mesh.is_first_of_edge(h) ? h : m_mesh.opposite(h);
      const std::array<FT, 2> weight{at[k], at[next_corner(k)]}; // of the source and the target of h
      at = Coordinates{};
      at[index_in_face(first)] = weight[first == h ? 0 : 1];
      at[next_corner(index_in_face(first))] = weight[first == h ? 1 : 0];
      return face_of(first);
    }
    return f;
  }

  // Ends the insertion: if a part of a curve got lost in silence, distances would be wrong.
  [[noreturn]] static void reject()
  {
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_CURVE,
                                 "rounding hides where the segments of the curves run: some of them nearly coincide");
  }

  // Walks along all segments of a curve. Its points are added here, and what the walks cross on the way by them; a
  // curve without a segment of any length is only that point.
  void add_curve(const Located_curve<FT>& curve, const std::vector<Vertex_id>& vertex)
  {
    Curve_point<FT> first{curve.number, 0, FT(0)};
    if(!curve.segments.empty())
      first = {curve.number, curve.segments[0].number, curve.segments[0].parameter};
    m_result.vertices.push_back(Source_vertex<FT>{vertex[0], curve.offset, first});
    for(std::size_t i = 0; i < curve.segments.size(); ++i)
    {
      const Curve_segment<FT>& s = curve.segments[i];
      Coordinates from = s.from, to = s.to;
      snap_coordinates(from);
      snap_coordinates(to);
      walk(place(vertex[i], from, s.face), place(vertex[i + 1], to, s.face), s.face,
           Curve_point<FT>{curve.number, s.number, s.parameter}, curve.offset);
      // Also where a segment is too short to be walked along: the next one begins there.
      m_result.vertices.push_back(
        Source_vertex<FT>{vertex[i + 1], curve.offset, Curve_point<FT>{curve.number, s.number, FT(1)}});
    }
  }

  // Returns a vertex with its coordinates in a face: those given, or the nearest ones that it has there. They differ on
  // an edge without length, which has no vertices but its ends. Otherwise the walk would look for the vertex where it
  // is not.
  Place place(Vertex_id v, const Coordinates& at, Face_id whole) const
  {
    Place result{v, at};
    FT least = std::numeric_limits<FT>::infinity();
    m_mesh.for_each_halfedge_around(v, [&](Halfedge_id h)
    {
      const Coordinates corner = corners_in_whole(face_of(h))[index_in_face(h)];
      if(m_insertion.parts().whole(face_of(h)) != whole || !(difference(corner, at) < least))
        return;
      least = difference(corner, at);
      result.at = least < Tolerance<FT>::location() ? at : corner;
    });
    return result;
  }

  // Walks along a segment from vertex to vertex, and adds each edge and its end to the result. Inserts a vertex where
  // the segment crosses an edge, and goes on from there. A straight segment crosses each part of its face once at most:
  // a walk that takes more steps than there were parts is lost among crossings that rounding keeps at one place.
  void walk(Place place, const Place& end, Face_id whole, Curve_point<FT> point, const FT& offset)
  {
    const Line segment(place.at, end.at);
    m_visited.assign(1, place.vertex);
    const std::size_t most_steps = 2 * (m_mesh.number_of_faces() - m_first_faces) + 16;
    for(std::size_t steps = 0; place.vertex != end.vertex; ++steps)
    {
      if(steps > most_steps)
        reject();
      const Line line(place.at, end.at);
      if(!(line.length > Tolerance<FT>::barycentric()))
        return; // what is left is rounding
      Step step;
      Exit exit;
      look_around(place, end, whole, line, step, exit);
      if(step.to.vertex == null_id && exit.halfedge != null_id && !(m_mesh.length(exit.halfedge) > 0))
        step = Step{Place{m_mesh.source(exit.halfedge), exit.source}, previous_halfedge(exit.halfedge),
                    m_mesh.opposite(previous_halfedge(exit.halfedge)), FT(0)}; // both ends are at one point
      else if(step.to.vertex == null_id && exit.halfedge != null_id)
      {
        m_has_inserted = true;
        place = Place{m_insertion.insert_on_edge(exit.halfedge, exit.source_weight, exit.target_weight), exit.at};
        continue; // the next walk meets this vertex
      }
      if(step.to.vertex == null_id)
        reject();
      const FT first = point.parameter;
      point.parameter = step.to.vertex == end.vertex
                          ? FT(1)
                          : (std::min)(FT(1), (std::max)(first, FT(segment.position(step.to.at) / segment.length)));
      m_result.edges.push_back(
        Source_edge<FT>{step.there, step.back, place.vertex, step.to.vertex,
                        m_mesh.length((std::min)(step.there, step.back)), offset, point.curve, point.segment, first,
                        point.parameter, 1});
      m_result.vertices.push_back(Source_vertex<FT>{step.to.vertex, offset, point});
      place = step.to;
      m_visited.push_back(place.vertex);
    }
  }

  // Looks at the parts of the face around a place. Finds the next vertex on the segment, if there is one; and the part
  // that the segment enters, if it leaves that one across the edge opposite to the place.
  void look_around(const Place& place, const Place& end, Face_id whole, const Line& line, Step& step, Exit& exit) const
  {
    FT widest = -std::numeric_limits<FT>::infinity();
    Step aside;
    m_mesh.for_each_halfedge_around(place.vertex, [&](Halfedge_id h)
    {
      const std::array<Coordinates, 3> corner = corners_in_whole(face_of(h));
      const unsigned int k = index_in_face(h), ka = next_corner(k), kb = previous_corner(k);
      if(m_insertion.parts().whole(face_of(h)) != whole || !is_same_point(corner[k], place.at))
        return;
      const Halfedge_id bv = previous_halfedge(h);
      try_step(Step{Place{m_mesh.target(h), corner[ka]}, h, m_mesh.opposite(h), FT(0)}, end, line, step, aside);
      try_step(Step{Place{m_mesh.source(bv), corner[kb]}, m_mesh.opposite(bv), bv, FT(0)}, end, line, step, aside);
      // The segment enters the part if a is on its right and b on its left.
      const FT right = -line.side(corner[ka]), left = line.side(corner[kb]);
      const FT width = (std::min)(right, left);
      if(!(width > 0) || !(width > widest))
        return;
      widest = width;
      exit.halfedge = next_halfedge(h);
      exit.source_weight = left / (left + right);
      exit.target_weight = right / (left + right);
      for(unsigned int i = 0; i < 3; ++i)
        exit.at[i] = exit.source_weight * corner[ka][i] + exit.target_weight * corner[kb][i];
      exit.source = corner[ka];
    });
    if(step.to.vertex == null_id && exit.halfedge == null_id)
      step = aside;
  }

  // Has the walk along this segment been at a vertex? Only a step aside could lead back: all other steps come nearer to
  // the end of the segment.
  bool is_visited(Vertex_id v) const { return std::find(m_visited.begin(), m_visited.end(), v) != m_visited.end(); }

  // Takes a neighbor as the next vertex if it is on the segment, up to rounding, and nearer than the one found so far.
  // The end of the segment is on it. `aside` is a neighbor at the same point as the place, up to rounding: where
  // nothing else leads on, the walk goes on from there.
  void try_step(Step candidate, const Place& end, const Line& line, Step& best, Step& aside) const
  {
    using std::abs;
    candidate.progress = line.position(candidate.to.at);
    const bool is_end = candidate.to.vertex == end.vertex && is_same_point(candidate.to.at, end.at);
    if(!is_end
       && (!(candidate.progress > 0) || candidate.progress > line.length + Tolerance<FT>::barycentric()
           || abs(line.side(candidate.to.at)) > Tolerance<FT>::barycentric()))
    {
      if(abs(line.side(candidate.to.at)) <= Tolerance<FT>::barycentric()
         && abs(candidate.progress) <= Tolerance<FT>::barycentric() && !is_visited(candidate.to.vertex))
        aside = candidate;
      return;
    }
    if(is_end)
      candidate.progress = line.length;
    if(best.to.vertex == null_id || candidate.progress < best.progress)
      best = candidate;
  }

  // Are two points of a face the same vertex, if they are known to be vertices that are equal? (Where a face is glued
  // to itself, one vertex may be at several points of it.)
  static bool is_same_point(const Coordinates& a, const Coordinates& b)
  {
    return difference(a, b) < Tolerance<FT>::location();
  }

  static FT difference(const Coordinates& a, const Coordinates& b)
  {
    using std::abs;
    return abs(FT(a[0] - b[0])) + abs(FT(a[1] - b[1])) + abs(FT(a[2] - b[2]));
  }

  // The corners of a face of the refined mesh in its face of the first mesh.
  std::array<Coordinates, 3> corners_in_whole(Face_id f) const
  {
    const Face_part<FT>* const part = m_insertion.parts().find_part_of(f);
    return part != nullptr ? part->corner : std::array<Coordinates, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  }

  // Keeps one of several copies of an edge or a vertex: that with the smallest offset, of these the first one. (Sorting
  // keeps the order of the curves where all else is equal.) For edges, the first one is that of the first segment of
  // the user: its direction decides which side is negative, but walls may have put later pieces of a curve before it.
  void remove_copies()
  {
    keep_one_of_each(m_result.edges, m_result.further_curves_of_edges,
                     [](const Source_edge<FT>& e) { return (std::min)(e.left, e.right); },
                     [](const Source_edge<FT>& e) { return e.curve; },
                     [](const Source_edge<FT>& e) { return std::tie(e.offset, e.curve, e.segment); },
                     [](Source_edge<FT>& kept, const Source_edge<FT>& e) { kept.copies += e.copies; });
    keep_one_of_each(m_result.vertices, m_result.further_curves_of_vertices,
                     [](const Source_vertex<FT>& v) { return v.vertex; },
                     [](const Source_vertex<FT>& v) { return v.point.curve; },
                     [](const Source_vertex<FT>& v) { return std::tie(v.offset); },
                     [](Source_vertex<FT>&, const Source_vertex<FT>&) {});
  }

  // The copy with the smallest rank stays, of equal ones the first. A rank begins with the offset and, unless all
  // items are in the order of the curves, goes on with the curve. Notes the other curves that have the same element and
  // the same offset. add_copy(kept, copy) gets each copy.
  template <typename Item, typename NameOf, typename CurveOf, typename RankOf, typename AddCopy>
  static void keep_one_of_each(std::vector<Item>& items, std::vector<Further_curve>& further, NameOf name_of,
                               CurveOf curve_of, RankOf rank_of, AddCopy add_copy)
  {
    std::stable_sort(items.begin(), items.end(), [&](const Item& a, const Item& b)
    { return name_of(a) < name_of(b) || (name_of(a) == name_of(b) && rank_of(a) < rank_of(b)); });
    std::size_t n = 0;
    std::uint32_t last_curve = 0; // with the smallest offset
    for(const Item& item : items)
    {
      if(n == 0 || name_of(items[n - 1]) != name_of(item))
      {
        last_curve = curve_of(item);
        items[n++] = item;
        continue;
      }
      const Item& kept = items[n - 1];
      if(item.offset == kept.offset && curve_of(item) != last_curve)
      {
        last_curve = curve_of(item);
        further.push_back(Further_curve{name_of(item), last_curve});
      }
      add_copy(items[n - 1], item);
    }
    items.erase(items.begin() + static_cast<std::ptrdiff_t>(n), items.end());
  }

  const Mesh& m_mesh;
  Source_insertion<FT>& m_insertion;
  std::vector<std::vector<Vertex_id>> m_vertices; // of each curve, in its order
  Source_curves<FT> m_result;
  std::vector<Vertex_id> m_visited; // on the segment that is walked along
  std::size_t m_first_faces = 0; // of the mesh without insertions
  bool m_has_inserted = false;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_SURFACE_CURVES_CURVE_INSERTION_H
