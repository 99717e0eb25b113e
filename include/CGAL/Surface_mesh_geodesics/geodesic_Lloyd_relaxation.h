// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_GEODESIC_LLOYD_RELAXATION_H
#define CGAL_SURFACE_MESH_GEODESICS_GEODESIC_LLOYD_RELAXATION_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/distance_in_space.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

namespace internal {

// A diagram with the maps among the named parameters, the sites of which are vertices.
template <typename TriangleMesh, typename VertexIndexMap, typename HalfedgeIndexMap, typename FaceIndexMap,
          typename VertexPointMap>
class Vertex_site_diagram
{
public:
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Kernel = typename Kernel_traits<typename boost::property_traits<VertexPointMap>::value_type>::Kernel;
  using Diagram = Surface_mesh_geodesic_Voronoi_diagram<Surface_mesh_shortest_path_traits<Kernel, TriangleMesh>,
                                                        VertexIndexMap, HalfedgeIndexMap, FaceIndexMap,
                                                        VertexPointMap>;

  Vertex_site_diagram(const TriangleMesh& tm, VertexIndexMap vim, HalfedgeIndexMap him, FaceIndexMap fim,
                      VertexPointMap vpm)
    : m_tm(tm), m_vpm(vpm), m_diagram(tm, vim, him, fim, vpm)
  {}

  template <typename Sites>
  void set_sites(const Sites& sites)
  {
    m_diagram.remove_all_sites();
    m_diagram.add_sites(sites);
  }

  const Diagram& diagram() const { return m_diagram; }

  // moves each site to the central vertex of its cell; all cells are looked through at once. Returns whether a
  // site has moved.
  bool move_to_centers(std::vector<vertex_descriptor>& sites) const
  {
    using Point = typename boost::property_traits<VertexPointMap>::value_type;
    std::vector<Point> center;
    for(std::size_t i = 0; i < sites.size(); ++i)
      center.push_back(m_diagram.centroid(i));
    std::vector<double> smallest(sites.size(), std::numeric_limits<double>::infinity());
    const std::vector<vertex_descriptor> before = sites;
    for(vertex_descriptor v : vertices(m_tm))
    {
      const std::size_t i = m_diagram.nearest_site(v);
      if(i == Diagram::null_site())
        continue;
      const double d = distance_in_space<Point>(center[i], get(m_vpm, v));
      if(d < smallest[i])
      {
        smallest[i] = d;
        sites[i] = v;
      }
    }
    return sites != before;
  }

private:
  const TriangleMesh& m_tm;
  VertexPointMap m_vpm;
  Diagram m_diagram;
};

template <typename TriangleMesh, typename NamedParameters>
auto make_vertex_site_diagram(const TriangleMesh& tm, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto him = CGAL::get_initialized_halfedge_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                              get_const_property_map(CGAL::vertex_point, tm));
  return Vertex_site_diagram<TriangleMesh, decltype(vim), decltype(him), decltype(fim), decltype(vpm)>(
    tm, vim, him, fim, vpm);
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

moves sites to the centers of their cells, again and again (Lloyd's method), so that the cells become round and similar
in area.

In each iteration the geodesic Voronoi diagram of the sites is computed, and each site moves to the vertex, among
those in its cell, that is nearest in space to the centroid of the cell, see
`Surface_mesh_geodesic_Voronoi_diagram::central_vertex()`; the first one in the order of `vertices(tm)` if several are
equally near. All sites move at once, and stay vertices. A site whose cell is empty, or holds no vertex, stays where it
is, and none leaves its component. The relaxation ends when no site moves, or
after the largest number of iterations. (It need not come to rest by itself: sites may move between few vertices that
are about equally good.)

<b>Complexity.</b> The mesh is read once. Each iteration takes the time and the memory of one diagram, and time linear in
the size of the mesh.

<b>Thread safety.</b> The function uses one thread, and may be called by several threads at once, on the same mesh as
well, if each call writes to an output of its own; see `geodesic_distances()`.

The use for remeshing is that of the thesis, section 5.4.4.

\tparam TriangleMesh a model of `FaceListGraph`; its points are those of a kernel of `double`
\tparam VertexRange a range of vertex descriptors of `TriangleMesh`
\tparam OutputIterator a model of `OutputIterator` that holds vertex descriptors of `TriangleMesh`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the triangle mesh
\param sites the sites to begin with
\param number_of_iterations the largest number of iterations
\param output gets the sites, in the order of `sites`, when the relaxation has ended
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
    \cgalParamDescription{a visitor that follows one propagation for each iteration. If it cancels one, the relaxation
                          ends with the sites of the iterations before.}
    \cgalParamType{a class model of `GeodesicPropagationVisitor`}
    \cgalParamDefault{`Geodesic_default_visitor`}
    \cgalParamExtra{The visitor is not copied if it is passed with `std::ref()`.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the number of iterations that moved a site; fewer than `number_of_iterations` if all sites are where they
        belong, or if the visitor has cancelled

\throws Invalid_geodesic_input if the mesh or a site is invalid, unless `number_of_iterations` is 0: then nothing is
        looked at. Nothing has been written then.
*/
template <typename TriangleMesh, typename VertexRange, typename OutputIterator, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t geodesic_Lloyd_relaxation(const TriangleMesh& tm, const VertexRange& sites,
                                      std::size_t number_of_iterations, OutputIterator output,
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter_reference;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  Geodesic_default_visitor default_visitor;
  auto& visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  auto diagram = internal::make_vertex_site_diagram(tm, np);
  std::vector<vertex_descriptor> moved(sites.begin(), sites.end());
  std::size_t i = 0;
  for(; i < number_of_iterations; ++i)
  {
    diagram.set_sites(moved);
    if(!diagram.diagram().build(visitor) || !diagram.move_to_centers(moved))
      break;
  }
  for(vertex_descriptor v : moved)
    *output++ = v;
  return i;
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_GEODESIC_LLOYD_RELAXATION_H
