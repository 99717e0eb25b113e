// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_BOUNDARY_POLYLINES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_BOUNDARY_POLYLINES_H

// The loops around a cell as polylines of locations, ready to draw or to cut, with the vertices of the diagram on them.
//
// Users see no arcs without length. Where one is left out, its neighbors differ by rounding; the first of the two
// points is written. The same holds for parts of border edges that are no longer than rounding: where a curve ends at a
// vertex of the mesh, the polyline has one point there.

#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Arc_curve.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/coordinates_in_layout.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Cell_loops.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Diagram` is Lazy_Voronoi_diagram, which is built. `Polyline` is the public struct. The diagram is referred to.
template <typename Diagram, typename Polyline>
class Boundary_polylines
{
  using Point = Planar_point<double>;

public:
  // The tolerance is in the user's unit. Requires: tolerance > 0.
  Boundary_polylines(const Diagram& diagram, double tolerance)
    : m_diagram(diagram), m_tolerance(tolerance / diagram.unit())
  {
    CGAL_assertion(tolerance > 0);
  }

  // Returns the polylines around the cell of the site at a vertex of the refined mesh, closed along the border of the
  // mesh or interrupted by it. Takes the time of Cell_loops, and time linear in the number of points.
  std::vector<Polyline> around(Vertex_id site, bool closes_at_border) const
  {
    const Cell_loops loops(m_diagram.refined_mesh(), m_diagram.complex());
    std::vector<Polyline> result;
    if(!closes_at_border)
      add(loops.without_border(site), result);
    else
    {
      add(loops.with_arcs(site), result);
      add(loops.of_border(site), result);
    }
    return result;
  }

private:
  // A polyline that grows, and the vertex of the diagram that is waiting for the first point.
  struct Growing
  {
    Polyline polyline;
    std::size_t first_vertex = Diagram::no_site;

    void add(const typename Diagram::Face_location& location)
    {
      polyline.locations.push_back(location);
      polyline.vertices.push_back(Diagram::no_site);
    }

    // Notes that the last point is a vertex. A point between two arcs is noted twice, with the same vertex.
    void set_vertex(std::size_t v)
    {
      if(v == Diagram::no_site)
        return;
      std::size_t& last = polyline.vertices.empty() ? first_vertex : polyline.vertices.back();
      last = v;
    }
  };

  // Appends a polyline for each loop that has a length. A loop that rounding has shrunk has fewer points than a curve
  // needs: three if it is closed, as the first one counts twice, else two.
  void add(const std::vector<Cell_loop>& loops, std::vector<Polyline>& result) const
  {
    for(const Cell_loop& loop : loops)
    {
      Growing g;
      for(const Cell_loop_piece& piece : loop.pieces)
        if(piece.is_arc)
          add_arc(piece.arc, g);
        else
          add_border(piece, g);
      const std::size_t least_number = loop.is_closed ? 3 : 2;
      if(g.polyline.locations.size() < least_number)
        continue;
      g.polyline.is_closed = loop.is_closed;
      if(g.first_vertex != Diagram::no_site)
        g.polyline.vertices.front() = g.first_vertex;
      if(loop.is_closed)
        close(g.polyline);
      result.push_back(g.polyline);
    }
  }

  // Makes the two ends equal, which rounding may have kept apart. The last one stays as it is: its face holds the last
  // segment, as the face of the second point holds the first one.
  static void close(Polyline& p)
  {
    p.locations.front() = p.locations.back();
    if(p.vertices.front() == Diagram::no_site)
      p.vertices.front() = p.vertices.back();
    p.vertices.back() = p.vertices.front();
  }

  // Appends the samples of an arc. Its first point is that of the piece before. The samples run as the arc does, which
  // may be against the loop. An arc without length adds no point, but its ends may be vertices of the diagram.
  void add_arc(const Oriented_index& a, Growing& g) const
  {
    const auto& complex = m_diagram.complex();
    const auto& arc = complex.arcs()[a.first];
    g.set_vertex(m_diagram.elements().vertex_of_node(a.second ? arc.last_node : arc.first_node));
    if(complex.has_length(arc))
    {
      std::vector<Point> samples{arc.first};
      Arc_curve(arc).sample(m_tolerance, [&](const Point& p) { samples.push_back(p); });
      if(a.second)
        std::reverse(samples.begin(), samples.end());
      for(std::size_t i = g.polyline.locations.empty() ? 0 : 1; i < samples.size(); ++i)
        g.add(m_diagram.location(arc.face, samples[i]));
    }
    g.set_vertex(m_diagram.elements().vertex_of_node(a.second ? arc.first_node : arc.last_node));
  }

  // Appends the end of a part of a border edge, and its beginning if the polyline has no point yet. A piece without
  // nodes is a whole edge.
  void add_border(const Cell_loop_piece& piece, Growing& g) const
  {
    const double length = m_diagram.refined_mesh().length(piece.border);
    const double from = piece.first_node == null_id ? 0. : abscissa(piece.first_node),
                 to = piece.last_node == null_id ? length : abscissa(piece.last_node);
    if(!(to - from > rounding(piece, length)))
      return;
    if(g.polyline.locations.empty())
      g.add(location_on(piece.border, from / length));
    g.add(location_on(piece.border, to / length));
  }

  double abscissa(std::uint32_t node) const { return m_diagram.complex().nodes()[node].abscissa; }

  // Returns the length below which a piece of the border is rounding: 0 for a whole edge.
  double rounding(const Cell_loop_piece& piece, double length) const
  {
    double result = 0;
    for(const std::uint32_t node : {piece.first_node, piece.last_node})
      if(node != null_id)
        result = (std::max)(result, m_diagram.complex().rounding_at(node, length));
    return result;
  }

  // Returns the location on h at a fraction of its length, from its source.
  typename Diagram::Face_location location_on(Halfedge_id h, double t) const
  {
    return m_diagram.location(face_of(h),
                              point_on_side(m_diagram.complex().layout(face_of(h)), index_in_face(h), t));
  }

  const Diagram& m_diagram;
  const double m_tolerance; // in the unit of the intrinsic mesh
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_BOUNDARY_POLYLINES_H
