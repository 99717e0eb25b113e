// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_SAMPLES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_SAMPLES_H

// The points of the surface at which the certifier compares a geodesic Voronoi diagram with distances from each site,
// and what the diagram says of them: points of arcs, vertices of the diagram, vertices of the mesh, points of all
// faces, and the sites: of curves, the ends and the middle of each segment, and the points that add_point_of_curve()
// adds.
//
// A point of a wall has a distance on each of its sides, and queries tell the least one. The diagram says the same of
// vertices of the mesh. An arc is on one side, so its points on walls are left out. Both of its ends may be such
// points; those in between still tell the curve.
//
// `Diagram` is a type with the members of Surface_mesh_geodesic_Voronoi_diagram; tests pass one with wrong answers.

#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_conditions.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Location_separation.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The constructor asks the diagram all questions; then the samples are plain values. They are the same in each run, so
// a certificate can be repeated.
//
// There are seven samples for each arc, fewer if it ends at a wall, one for each vertex of the diagram and of the mesh,
// one or eight for each face, and one for each point or three for each segment of a curve, in this order. Points of
// faces that are not vertices make the diagram propagate a second time, to keep its windows.
//
// The diagram is referred to.
template <typename Diagram>
class Diagram_samples
{
  using Triangle_mesh = typename Diagram::Triangle_mesh;
  using Graph_traits = boost::graph_traits<Triangle_mesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Face_location = typename Diagram::Face_location;
  using FT = typename Diagram::FT;

public:
  // A point of the surface. The diagram says that the sites are equally near, that no other site is nearer, and how far
  // they are, less their weights. If no site reaches the point, its only site is Diagram_violation::no_site(), and the
  // distance is -1.
  struct Sample
  {
    vertex_descriptor vertex;                   // the null vertex if the sample is a location
    Face_location location;
    std::size_t first_site, number_of_sites;    // in sites()
    double distance;
    Diagram_condition condition;                // which is violated if a site has another distance
  };

  // Requires: the diagram has a site. Builds the diagram if that is not done; then takes the time of the queries.
  explicit Diagram_samples(const Diagram& diagram) : m_diagram(diagram), m_tm(diagram.triangle_mesh())
  {
    CGAL_assertion(diagram.number_of_sites() > 0);
    add_arcs();
    for(const auto& v : m_diagram.vertices())
      if(!is_on_wall(v.location()))
        add(v.location(), v.sites(), CGAL::to_double(v.distance()), DIAGRAM_VERTICES);
    for(const vertex_descriptor v : vertices(m_tm))
      if(!is_isolated(v))
        add_vertex_of_mesh(v);
    for(const face_descriptor f : faces(m_tm))
      if(!m_diagram.avoids_face(f))
        add_points_of_face(f);
    for(std::size_t i = 0; i < m_diagram.number_of_sites(); ++i)
      if(m_diagram.site_curve(i) != nullptr)
      {
        // A curve of one vertex has no segments; the vertex is a sample already.
        for(std::size_t s = 0; s < m_diagram.site_curve(i)->segments().size(); ++s)
          for(const double t : {0., 0.5, 1.})
            add_point_of_curve(i, s, t);
      }
      else if(m_diagram.site(i).first != Graph_traits::null_face())
        add_location(m_diagram.site(i));
  }

  // Adds a point of the curve of site i, as Surface_curve::location() names it, unless it is on a wall or in a face to
  // avoid.
  void add_point_of_curve(std::size_t i, std::size_t segment, double t)
  {
    const auto l = m_diagram.site_curve(i)->location(segment, t);
    const Face_location location(l.first, typename Diagram::Barycentric_coordinates{
                                            FT(l.second[0]), FT(l.second[1]), FT(l.second[2])});
    if(!m_diagram.avoids_face(l.first) && !is_on_wall(location))
      add_location(location);
  }

  const std::vector<Sample>& samples() const { return m_samples; }

  // The sites of all samples, one after the other.
  const std::vector<std::size_t>& sites() const { return m_sites; }

private:
  // Both ends, the middle and points in between; an arc is a piece of a conic, which these determine.
  void add_arcs()
  {
    for(const auto& arc : m_diagram.arcs())
      for(const double t : {0., 0.125, 0.375, 0.5, 0.625, 0.875, 1.})
        if(!is_on_wall(arc.point(t)))
          add(arc.point(t), {arc.sites().first, arc.sites().second}, CGAL::to_double(arc.distance(t)), DIAGRAM_ARCS);
  }

  // Adds a vertex of the mesh, with the one site that the diagram names for it. Paths are asked for the vertex itself
  // then, not for a location.
  void add_vertex_of_mesh(vertex_descriptor v)
  {
    add(Face_location(), {m_diagram.nearest_site(v)}, CGAL::to_double(m_diagram.distance_to_nearest_site(v)),
        DIAGRAM_OWNERS);
    m_samples.back().vertex = v;
  }

  // One point in a face that no arc crosses, and eight in one that arcs cross. No two faces get the same coordinates.
  // Where no arc runs, one point tells the cell of the whole face.
  void add_points_of_face(face_descriptor f)
  {
    const std::size_t number = m_diagram.arcs(f).empty() ? 1 : 8;
    for(std::size_t i = 0; i < number; ++i)
    {
      const std::array<double, 2> p = next_point_of_triangle();
      const Face_location l(f, typename Diagram::Barycentric_coordinates{FT(1 - p[0] - p[1]), FT(p[0]), FT(p[1])});
      add_location(l);
    }
  }

  // Adds a location, with the one site that the diagram names for it.
  void add_location(const Face_location& l)
  {
    add(l, {m_diagram.nearest_site(l)}, CGAL::to_double(m_diagram.distance_to_nearest_site(l)), DIAGRAM_OWNERS);
  }

  // The next one of a sequence of points that fill the unit square evenly, folded to the triangle x + y <= 1. The steps
  // are the powers of 0.7548..., the inverse of the real root of x^3 = x + 1 (an additive recurrence of low
  // discrepancy). Folding keeps the points evenly spread, as it maps both halves of the square to the triangle without
  // distortion.
  std::array<double, 2> next_point_of_triangle()
  {
    m_sequence[0] = std::fmod(m_sequence[0] + 0.7548776662466927, 1.);
    m_sequence[1] = std::fmod(m_sequence[1] + 0.5698402909980532, 1.);
    double x = m_sequence[0], y = m_sequence[1];
    if(x + y > 1)
    {
      x = 1 - x;
      y = 1 - y;
    }
    return {x, y};
  }

  // Adds a sample at a location.
  void add(const Face_location& l, const std::vector<std::size_t>& sites, double distance, Diagram_condition condition)
  {
    m_samples.push_back({Graph_traits::null_vertex(), l, m_sites.size(), sites.size(), distance, condition});
    m_sites.insert(m_sites.end(), sites.begin(), sites.end());
  }

  // Is a location on a wall, or nearly, so that a query may take it for a point of the wall? Linear in the degrees of
  // the corners of its face.
  bool is_on_wall(const Face_location& l) const
  {
    const double tolerance = Tolerance<double>::location();
    halfedge_descriptor h = halfedge(l.first, m_tm);
    for(std::size_t k = 0; k < 3; ++k, h = next(h, m_tm))
    {
      if(std::abs(CGAL::to_double(l.second[(k + 2) % 3])) <= tolerance && m_diagram.avoids_edge(edge(h, m_tm)))
        return true;
      if(std::abs(1 - CGAL::to_double(l.second[k])) <= tolerance && is_at_wall(h, m_diagram))
        return true;
    }
    return false;
  }

  // Is the vertex in no face that the diagram has? (It may have edges.) Such a vertex has no location, and no path of
  // other sites leads to it; so it is not a sample.
  bool is_isolated(vertex_descriptor v) const
  {
    if(CGAL::halfedges_around_target(v, m_tm).empty())
      return true;
    for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, m_tm))
      if(!is_border(h, m_tm) && !m_diagram.avoids_face(face(h, m_tm)))
        return false;
    return true;
  }

  const Diagram& m_diagram;
  const Triangle_mesh& m_tm;
  // The last point of the sequence before it was folded.
  std::array<double, 2> m_sequence{{0.5, 0.5}};
  std::vector<Sample> m_samples;
  std::vector<std::size_t> m_sites;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_SAMPLES_H
