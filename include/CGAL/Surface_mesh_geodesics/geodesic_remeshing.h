// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_REMESHING_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_REMESHING_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Geodesic_dual_report` tells why the triangles of the dual of a geodesic Voronoi diagram make a manifold mesh
of the topology of the surface, or why they do not. Sites are told by their numbers. More
sites where the report points to make the cells smaller and help. Lists of single cells are in ascending order.

\sa `check_geodesic_dual()`
*/
struct Geodesic_dual_report
{
  /// the cells, not empty, that are not topological disks.
  std::vector<std::size_t> cells_that_are_not_disks;

  /// the cells that are disks, with a boundary (without the border of the mesh) of several parts: in the dual, the
  /// triangles around such a site would be several fans.
  std::vector<std::size_t> cells_with_several_boundaries;

  /// the cells, not empty, that are part of no triangle.
  std::vector<std::size_t> cells_without_triangle;

  /// the pairs of cells that have several edges in common, the smaller number first.
  std::vector<std::pair<std::size_t, std::size_t>> pairs_with_several_edges;

  /// the pairs of cells with an edge in common that has no vertex, from border to border.
  std::vector<std::pair<std::size_t, std::size_t>> pairs_without_triangle;

  /// the triples of cells, in ascending order, that meet in several vertices.
  std::vector<std::array<std::size_t, 3>> triples_with_several_vertices;

  /// whether the triangles, as a set, make a polygon mesh. There may be reasons not to that are not among those above.
  bool is_polygon_mesh = false;

  /// returns whether nothing is against a manifold mesh.
  bool is_manifold() const
  {
    return is_polygon_mesh && cells_that_are_not_disks.empty() && cells_with_several_boundaries.empty()
        && cells_without_triangle.empty() && pairs_with_several_edges.empty() && pairs_without_triangle.empty()
        && triples_with_several_vertices.empty();
  }
};

namespace internal {

template <typename Diagram>
class Geodesic_dual_check
{
  using Pair = std::pair<std::size_t, std::size_t>;
  using Triple = std::array<std::size_t, 3>;

public:
  explicit Geodesic_dual_check(const Diagram& diagram) : m_diagram(diagram)
  {
    diagram.dual(std::back_inserter(m_triangles));
  }

  const std::vector<Triple>& triangles() const { return m_triangles; }

  Geodesic_dual_report report()
  {
    Geodesic_dual_report r;
    check_triangles(r);
    check_cells(r);
    check_edges(r);
    r.is_polygon_mesh = !m_triangles.empty() && Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(m_triangles);
    return r;
  }

private:
  void check_triangles(Geodesic_dual_report& r)
  {
    std::map<Triple, int> number_of_triangles;
    for(Triple t : m_triangles)
    {
      for(std::size_t k = 0; k < 3; ++k)
      {
        m_is_in_triangle.insert(t[k]);
        if(++m_halfedges[Pair(t[k], t[(k + 1) % 3])] == 2)
          m_pairs_with_several_edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
      }
      std::sort(t.begin(), t.end());
      if(++number_of_triangles[t] == 2)
        r.triples_with_several_vertices.push_back(t);
    }
  }

  void check_cells(Geodesic_dual_report& r)
  {
    for(std::size_t i = 0; i < m_diagram.number_of_sites(); ++i)
    {
      if(m_diagram.is_empty(i))
        continue;
      if(!m_diagram.is_disk(i))
        r.cells_that_are_not_disks.push_back(i);
      else if(m_diagram.boundary(i).size() > 1)
        r.cells_with_several_boundaries.push_back(i);
      if(m_is_in_triangle.count(i) == 0)
        r.cells_without_triangle.push_back(i);
    }
  }

  void check_edges(Geodesic_dual_report& r)
  {
    std::map<Pair, int> number_of_edges;
    for(const auto& e : m_diagram.edges())
    {
      const Pair s = e.sites(), pair = std::minmax(s.first, s.second);
      const int n = ++number_of_edges[pair];
      if(n == 2)
        m_pairs_with_several_edges.insert(pair);
      if(n == 1 && m_halfedges.count(s) == 0 && m_halfedges.count(Pair(s.second, s.first)) == 0)
        r.pairs_without_triangle.push_back(pair);
    }
    r.pairs_with_several_edges.assign(m_pairs_with_several_edges.begin(), m_pairs_with_several_edges.end());
  }

  const Diagram& m_diagram;
  std::vector<Triple> m_triangles;
  std::set<std::size_t> m_is_in_triangle;
  std::map<Pair, int> m_halfedges;
  std::set<Pair> m_pairs_with_several_edges;
};

// adds the mesh with a vertex at each site of a triangle.
template <typename OutputMesh, typename Diagram>
void add_dual_mesh(const Diagram& diagram, const std::vector<std::array<std::size_t, 3>>& triangles, OutputMesh& output)
{
  using Point = typename boost::property_traits<
    typename boost::property_map<OutputMesh, CGAL::vertex_point_t>::type>::value_type;
  std::vector<Point> points;
  std::vector<std::size_t> position(diagram.number_of_sites(), Diagram::null_site());
  std::vector<std::array<std::size_t, 3>> faces = triangles;
  for(std::array<std::size_t, 3>& f : faces)
    for(std::size_t& i : f)
    {
      if(position[i] == Diagram::null_site())
      {
        const auto p = diagram.point(diagram.site(i));
        position[i] = points.size();
        points.push_back(Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
      }
      i = position[i];
    }
  Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, output);
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

checks whether the triangles of the dual of a diagram make a manifold mesh, and tells what is in the way: cells that
are not disks, pairs of cells with several edges in common, and so on. Where the surface has a border, so has the
dual, farther inside.

Takes time proportional to the number of arcs and edges of the diagram, times a logarithm, and that of the diagram if it
has not been computed. The function may be called by several threads at once, on the same diagram as well.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`

\param diagram the diagram

\return what has been found

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid
*/
template <typename Diagram>
Geodesic_dual_report check_geodesic_dual(const Diagram& diagram)
{
  return internal::Geodesic_dual_check<Diagram>(diagram).report();
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

adds the dual of a diagram, triangles with the sites as vertices, to a mesh if it is manifold. Sites that are in no
triangle get no vertex. Time and thread safety are those of `check_geodesic_dual()`; each call needs an output of its
own.

\tparam Diagram a specialization of `Surface_mesh_geodesic_Voronoi_diagram`
\tparam OutputMesh a model of `MutableFaceGraph` with an internal property for `CGAL::vertex_point_t`, whose points are
        constructible from three coordinates of type `double`

\param diagram the diagram
\param output the mesh to which the triangles are added

\throws Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is invalid

\return what `check_geodesic_dual()` returns. If it is not manifold, `output` is not changed.
*/
template <typename Diagram, typename OutputMesh>
Geodesic_dual_report geodesic_dual_mesh(const Diagram& diagram, OutputMesh& output)
{
  internal::Geodesic_dual_check<Diagram> check(diagram);
  const Geodesic_dual_report report = check.report();
  if(report.is_manifold())
    internal::add_dual_mesh(diagram, check.triangles(), output);
  return report;
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

approximates a triangle mesh by one with `n` vertices: the dual of the geodesic Voronoi diagram of vertices that are
chosen with `geodesic_farthest_point_sampling()` and moved with `geodesic_Lloyd_relaxation()`
(thesis, section 5.4.4).

<b>Complexity.</b> The time is that of the sampling, of the relaxation, and of one more diagram.

<b>Thread safety.</b> The function uses one thread, and may be called by several threads at once, on the same mesh as
well, if each call writes to an output of its own; see `geodesic_distances()`.

\tparam TriangleMesh a model of `FaceListGraph`; its points are those of a kernel of `double`
\tparam OutputMesh a model of `MutableFaceGraph` with an internal property for `CGAL::vertex_point_t`, whose points are
        constructible from three coordinates of type `double`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param n the number of sites, and so the largest number of vertices of the result
\param output the mesh to which the result is added
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh`
                   as key type and the 3D point type of a kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of `tm` a unique index between `0`
                          and `num_vertices(tm) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of `TriangleMesh`
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{a property map associating to each face of `tm` a unique index between `0`
                          and `num_faces(tm) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the face descriptor of `TriangleMesh`
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{a visitor that follows one propagation for each sample, for each iteration, and for the last
                          diagram. If it cancels one, nothing is added to `output`.}
    \cgalParamType{a class model of `GeodesicPropagationVisitor`}
    \cgalParamDefault{`Geodesic_default_visitor`}
    \cgalParamExtra{The visitor is not copied if it is passed with `std::ref()`.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the largest number of iterations of the relaxation}
    \cgalParamType{unsigned int}
    \cgalParamDefault{`5`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what `check_geodesic_dual()` returns. If the dual is not manifold, nothing is added to `output`; a larger `n`
        helps. If the visitor cancelled, nothing is added either, and the report is that of no triangles.

\throws Invalid_geodesic_input if the mesh is invalid; nothing has been added to `output` then
*/
template <typename TriangleMesh, typename OutputMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Geodesic_dual_report geodesic_remeshing(const TriangleMesh& tm, std::size_t n, OutputMesh& output,
                                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  const std::size_t number_of_iterations = static_cast<std::size_t>(
    choose_parameter(get_parameter(np, internal_np::number_of_iterations), 5u));
  Geodesic_default_visitor default_visitor;
  auto& users_visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  internal::Visitor_of_several_runs<std::remove_reference_t<decltype(users_visitor)>> visitor(users_visitor);
  const auto np_with_visitor = np.visitor(std::ref(visitor));
  std::vector<vertex_descriptor> samples, sites;
  geodesic_farthest_point_sampling(tm, n, std::back_inserter(samples), np_with_visitor);
  if(visitor.is_cancelled())
    return Geodesic_dual_report();
  geodesic_Lloyd_relaxation(tm, samples, number_of_iterations, std::back_inserter(sites), np_with_visitor);
  auto diagram = internal::make_vertex_site_diagram(tm, np);
  diagram.set_sites(sites);
  if(visitor.is_cancelled() || !diagram.diagram().build(visitor))
    return Geodesic_dual_report();
  return geodesic_dual_mesh(diagram.diagram(), output);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_REMESHING_H
