// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_SAMPLE_PLACEMENT_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_SAMPLE_PLACEMENT_H

// Where further samples make the dual of a diagram manifold: in the cells, on the edges and at the vertices of the
// diagram that violate the closed-ball property. The new sample is a point far from all samples, so it takes a good
// part of the offending cells, and samples do not crowd (the argument of Edelsbrunner and Shah, Triangulating
// topological spaces, 1997).

#include <CGAL/Surface_mesh_geodesics/internal/numeric/distance_in_space.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The samples of a remeshing. As sites of a diagram, the vertices come first.
template <typename Diagram>
struct Remeshing_samples
{
  std::vector<typename Diagram::vertex_descriptor> vertices;
  std::vector<typename Diagram::Face_location> points;
};

// A class for one round: its tables are those of one diagram. Far means far from the nearest sample, as the diagram
// measures it along the surface, so no distance is computed here except around tips.
//
// Collects new samples for the findings of a report. Vertices of the mesh come first; a point of a face becomes a
// sample only where all vertices nearby are samples already.
//
// A cell gets at most one new sample, which often mends its other findings as well. So a finding waits for the next
// round if one of its cells has got a sample in this round.
//
// The diagram and the samples are referred to. Diagram is the public class, and its mesh that of Remeshing_input.
template <typename Diagram>
class Sample_placement
{
  using Mesh = typename Diagram::Triangle_mesh;
  using vertex_descriptor = typename Diagram::vertex_descriptor;
  using halfedge_descriptor = typename Diagram::halfedge_descriptor;
  using Face_location = typename Diagram::Face_location;
  using Edge = typename Diagram::Edge;
  using Pair = std::pair<std::size_t, std::size_t>;

public:
  // Requires: the samples are the sites of the diagram, which is built. Takes time linear in the size of the mesh: each
  // vertex is compared with the farthest one of its cell so far.
  Sample_placement(const Diagram& diagram, const Remeshing_samples<Diagram>& samples)
    : m_diagram(diagram), m_samples(samples), m_mesh(diagram.triangle_mesh()), m_is_sample(num_vertices(m_mesh), false),
      m_has_new_sample(diagram.number_of_sites(), false), m_far_vertex(diagram.number_of_sites()),
      m_far_border_vertex(diagram.number_of_sites())
  {
    for(const vertex_descriptor v : samples.vertices)
      m_is_sample[v] = true;
    for(const vertex_descriptor v : vertices(m_mesh))
    {
      const std::size_t i = diagram.nearest_site(v);
      if(i == Diagram::null_site() || m_is_sample[v])
        continue;
      const Far_vertex farthest{CGAL::to_double(diagram.distance_to_nearest_site(v)), v};
      replace_by_farther(m_far_vertex[i], farthest);
      if(is_border(v, m_mesh))
        replace_by_farther(m_far_border_vertex[i], farthest);
    }
  }

  // The order decides which finding of a cell gets the sample. Tips come first, as the samples for other findings would
  // not mend them. Cells that are not disks come before edges: several common edges are often a consequence.
  //
  // Adds samples for all findings of a report except vertices of many cells, whose polygons have been divided.
  template <typename Report>
  void add(const Report& report)
  {
    for(const Pair& p : report.pairs_without_triangle)
      add_around_tip(p);
    for(const std::size_t i : report.cells_that_are_not_disks)
      add_in_cell(i);
    for(const std::size_t i : report.cells_with_several_boundaries)
      add_in_cell(i);
    add_on_edges(report.pairs_with_several_edges);
    add_on_edges(report.pairs_without_triangle);
    for(const std::array<std::size_t, 3>& triple : report.triples_with_several_vertices)
      add_at_vertex(triple);
    for(const std::size_t i : report.cells_without_triangle)
      add_in_cell(i);
  }

  // Adds a sample in a cell: the farthest vertex of the border of the mesh, as a hole in a cell needs samples around
  // it; otherwise the farthest vertex; otherwise the farthest point of its boundary.
  //
  // A hole needs three samples around it, which a cell gets one by one, in as many rounds.
  void add_in_cell(std::size_t i)
  {
    if(m_has_new_sample[i])
      return;
    if(m_far_border_vertex[i].distance > 0)
      return add_vertex(m_far_border_vertex[i].vertex, {i});
    Far_point farthest;
    for(const auto& part : m_diagram.boundary(i))
      for(const auto& e : part.edges)
        add_points(e.first, farthest);
    if(m_far_vertex[i].distance > 0 && m_far_vertex[i].distance >= farthest.distance / 2)
      add_vertex(m_far_vertex[i].vertex, {i});
    else
      add_near(farthest, {i});
  }

  // Adds a sample near the farthest vertex of the diagram in which three cells meet.
  void add_at_vertex(const std::array<std::size_t, 3>& triple)
  {
    if(have_new_sample(triple))
      return;
    Far_point farthest;
    for(const auto& v : m_diagram.vertices())
      if(std::all_of(triple.begin(), triple.end(), [&](std::size_t i)
         { return std::binary_search(v.sites().begin(), v.sites().end(), i); }))
        farthest.add(v.location(), CGAL::to_double(v.distance()));
    add_near(farthest, {triple[0], triple[1], triple[2]});
  }

  const Remeshing_samples<Diagram>& new_samples() const { return m_new; }

private:
  // The farthest vertex so far, and its distance from the nearest sample.
  struct Far_vertex
  {
    double distance = 0;
    vertex_descriptor vertex = vertex_descriptor();
  };

  // The farthest point so far of the boundary of a cell. It may be in a face, where no vertex is near enough; the new
  // mesh then has a vertex on the surface that is not one of the given mesh.
  struct Far_point
  {
    double distance = 0;
    Face_location location = Face_location();

    void add(const Face_location& its_location, double its_distance)
    {
      if(its_distance > distance)
      {
        distance = its_distance;
        location = its_location;
      }
    }
  };

  static void replace_by_farther(Far_vertex& a, const Far_vertex& b)
  {
    if(b.distance > a.distance)
      a = b;
  }

  // Whether a cell has got a sample in this round, so that the finding may be out of date.
  template <typename Cells>
  bool have_new_sample(const Cells& cells) const
  {
    return std::any_of(cells.begin(), cells.end(), [this](std::size_t i) { return bool(m_has_new_sample[i]); });
  }

  // The cell of a sample at a tip, where the faces around a vertex make a small angle, has a neighbor that reaches
  // around it: the edge between the two cells runs from border to border, or is closed. A further sample anywhere
  // between the two would take the place of that neighbor, and so on without an end. Samples on all edges at the tip,
  // at the same distance, are neighbors side by side.
  //
  // Adds them if the cell of one of the two samples has no further vertex.
  void add_around_tip(const Pair& pair)
  {
    for(const std::size_t i : {pair.first, pair.second})
      if(!have_new_sample(std::array<std::size_t, 2>{pair.first, pair.second}) && i < m_samples.vertices.size()
         && m_far_vertex[i].distance == 0 && is_tip(m_samples.vertices[i]))
      {
        double distance = std::numeric_limits<double>::infinity();
        for(const auto& part : m_diagram.boundary(i))
          for(const auto& e : part.edges)
            for(const auto& a : e.first.arcs())
              distance = (std::min)(distance, CGAL::to_double(a.first.distance(.5)));
        add_around(m_samples.vertices[i], distance);
        mark({pair.first, pair.second});
      }
  }

  // An approximation is enough: both answers lead to samples, and an angle near the bound is no obstacle to either.
  //
  // Returns whether the angles of the faces at a vertex sum up to less than a half circle, at the border to less than a
  // quarter.
  bool is_tip(vertex_descriptor v) const
  {
    double sum = 0;
    for(const auto h : CGAL::halfedges_around_target(v, m_mesh))
      if(!CGAL::is_border(h, m_mesh))
        sum += CGAL::approximate_angle(point(source(h, m_mesh)), point(v), point(target(next(h, m_mesh), m_mesh)));
    return sum < (is_border(v, m_mesh) ? 90 : 180);
  }

  // The points are equally far from the vertex along straight edges, so their cells meet side by side in the middle of
  // the faces; half an edge is left for the neighbor, which may be the other end.
  //
  // Adds a point of each edge with a length at a vertex, at the given distance from it, or less if an edge is short.
  void add_around(vertex_descriptor v, double distance)
  {
    for(const auto h : CGAL::halfedges_around_target(v, m_mesh))
      if(length(h) > 0)
        distance = (std::min)(distance, length(h) / 2);
    for(const auto h : CGAL::halfedges_around_target(v, m_mesh))
      if(length(h) > 0)
        add_point(location_on(h, distance / length(h)));
  }

  double length(halfedge_descriptor h) const
  {
    return distance_in_space(point(source(h, m_mesh)), point(target(h, m_mesh)));
  }

  // The point of a halfedge, as a point of a face, at a part t of the way from its target to its source. The coordinate
  // of the third corner is exactly 0, so the point is on the edge, and a sample of both of its faces.
  Face_location location_on(halfedge_descriptor h, double t) const
  {
    const halfedge_descriptor side = is_border(h, m_mesh) ? opposite(h, m_mesh) : h;
    const vertex_descriptor to = target(h, m_mesh);
    typename Diagram::Barycentric_coordinates b{{0, 0, 0}};
    auto g = halfedge(face(side, m_mesh), m_mesh);
    for(std::size_t k = 0; k < 3; ++k, g = next(g, m_mesh))
      b[k] = source(g, m_mesh) == to ? 1 - t : source(g, m_mesh) == source(h, m_mesh) ? t : 0;
    return Face_location(face(side, m_mesh), b);
  }

  const auto& point(vertex_descriptor v) const { return m_mesh.point(v); }

  // Cells with several common edges are around something, such as a handle or a hole; the farthest point of the edges
  // is on its other side, as seen from the samples.
  //
  // For each pair, adds a sample near the farthest point of the edges between the two cells.
  void add_on_edges(const std::vector<Pair>& pairs)
  {
    std::map<Pair, Far_point> far_point;
    for(const Pair& p : pairs)
      far_point[p];
    for(const Edge& e : m_diagram.edges())
    {
      const auto found = far_point.find(std::minmax(e.sites().first, e.sites().second));
      if(found != far_point.end())
        add_points(e, found->second);
    }
    for(const Pair& p : pairs)
      if(!have_new_sample(std::array<std::size_t, 2>{p.first, p.second}))
        add_near(far_point[p], {p.first, p.second});
  }

  // Takes the ends and the middle of each arc: an arc is short beside its distance from the sites, or bends little.
  static void add_points(const Edge& edge, Far_point& farthest)
  {
    for(const auto& a : edge.arcs())
      for(const double t : {0., .5, 1.})
        farthest.add(a.first.point(t), CGAL::to_double(a.first.distance(t)));
  }

  // Adds the vertex of the face that is farthest from all samples, or the point itself if all of them are near samples:
  // nearer than half the distance of the point. Vertices are preferred because they carry the features of the shape.
  void add_near(const Far_point& farthest, const std::vector<std::size_t>& cells)
  {
    if(!(farthest.distance > 0))
      return;
    Far_vertex best;
    for(const vertex_descriptor v : CGAL::vertices_around_face(halfedge(farthest.location.first, m_mesh), m_mesh))
      if(!m_is_sample[v])
        replace_by_farther(best, Far_vertex{CGAL::to_double(m_diagram.distance_to_nearest_site(v)), v});
    if(best.distance >= farthest.distance / 2)
      return add_vertex(best.vertex, cells);
    add_point(farthest.location);
    mark(cells);
  }

  // The cells of the finding and the one that the vertex is in get no further sample in this round.
  void add_vertex(vertex_descriptor v, const std::vector<std::size_t>& cells)
  {
    if(!m_is_sample[v])
      m_new.vertices.push_back(v);
    m_is_sample[v] = true;
    mark(cells);
    mark({m_diagram.nearest_site(v)});
  }

  // Two neighbors may ask for the same point of the edge between them.
  void add_point(const Face_location& location)
  {
    if(m_new_points.insert(coordinates_in_space(m_diagram.point(location))).second)
      m_new.points.push_back(location);
  }

  void mark(const std::vector<std::size_t>& cells)
  {
    for(const std::size_t i : cells)
      m_has_new_sample[i] = true;
  }

  const Diagram& m_diagram;
  const Remeshing_samples<Diagram>& m_samples;
  const Mesh& m_mesh;
  std::vector<bool> m_is_sample, m_has_new_sample; // by vertex, by site
  std::vector<Far_vertex> m_far_vertex, m_far_border_vertex; // by site; the distance 0 stands for "none"
  Remeshing_samples<Diagram> m_new;
  std::set<std::array<double, 3>> m_new_points;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_SAMPLE_PLACEMENT_H
