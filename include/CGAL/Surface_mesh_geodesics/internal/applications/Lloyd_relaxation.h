// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_LLOYD_RELAXATION_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_LLOYD_RELAXATION_H

// Lloyd's method on a mesh: sites are vertices, and each moves to the vertex of its cell that is nearest to the
// centroid of the cell. (Remeshing is an application of the thesis, section 5.4.4, which leaves the sites where they
// are.) The mesh is read once for all iterations.
//
// Curves may be sites, too, which do not move. Cells end where a curve is nearer, so centers keep away from it.
//
// relax_sites() is the loop. Vertex_site_diagram holds the diagram, which all iterations share.

#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/distance_in_space.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A diagram of the type Diagram<Traits, maps..., ConcurrencyTag>, which is Surface_mesh_geodesic_Voronoi_diagram, whose
// sites are vertices, behind curves if there are any. The mesh is referred to, not copied. An object cannot be copied
// or moved, like its diagram; make_vertex_site_diagram() returns it nevertheless, as C++17 constructs a returned
// temporary in place.
//
// The points are those of a kernel of double, from which the traits are made. All maps are copied.
template <template <typename...> class Diagram_, typename ConcurrencyTag, typename TriangleMesh,
          typename VertexIndexMap, typename HalfedgeIndexMap, typename FaceIndexMap, typename VertexPointMap>
class Vertex_site_diagram
{
public:
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Kernel = typename Kernel_traits<Point>::Kernel;
  using Diagram = Diagram_<Surface_mesh_shortest_path_traits<Kernel, TriangleMesh>, VertexIndexMap, HalfedgeIndexMap,
                           FaceIndexMap, VertexPointMap, ConcurrencyTag>;

  Vertex_site_diagram(const TriangleMesh& tm, VertexIndexMap vim, HalfedgeIndexMap him, FaceIndexMap fim,
                      VertexPointMap vpm)
    : m_tm(tm), m_vpm(vpm), m_diagram(tm, vim, him, fim, vpm)
  {}

  // Replaces all sites; the mesh is not read again. The diagram is not built here; its next query or build() rejects a
  // site that is not a vertex.
  template <typename Sites>
  void set_sites(const Sites& sites)
  {
    m_diagram.remove_all_sites();
    m_number_of_curves = 0;
    m_diagram.add_sites(sites);
  }

  // The same with a curve, or a range of curves, which the next build() checks. Curves have the first numbers: of sites
  // at one place the first one owns the cell, so the cell of a vertex on a curve is empty, at corners, too.
  template <typename Curves, typename Sites>
  void set_sites(const Curves& curves, const Sites& sites)
  {
    m_diagram.remove_all_sites();
    if constexpr(Is_curve<Curves>::value)
      m_diagram.add_site(curves);
    else
      m_diagram.add_sites(curves);
    m_number_of_curves = m_diagram.number_of_sites();
    m_diagram.add_sites(sites);
  }

  // Adds points of faces to the sites. Only diagrams that are not relaxed have such sites.
  template <typename Locations>
  void add_points(const Locations& locations)
  {
    m_diagram.add_sites(locations);
  }

  // Leaves faces out; they are those of Surface_mesh_geodesic_Voronoi_diagram::avoid_faces().
  template <typename Faces>
  void avoid_faces(const Faces& avoided)
  {
    m_diagram.avoid_faces(avoided);
  }

  // Makes walls of edges; they are those of Surface_mesh_geodesic_Voronoi_diagram::avoid_edges().
  template <typename Edges>
  void avoid_edges(const Edges& avoided)
  {
    m_diagram.avoid_edges(avoided);
  }

  const Diagram& diagram() const { return m_diagram; }

  // Moves each site to the vertex in its cell that is nearest in space to the centroid of the cell; of equally near
  // ones to the first vertex of the mesh. A site whose cell has no vertex stays. Returns whether a site has moved.
  //
  // The result is that of central_vertex() for each site, in one pass over the mesh instead of one for each site.
  // Sites with is_fixed(v) stay. A vertex on a wall is in the cell of its nearest side. Requires: `sites` are the sites
  // of the diagram but for the curves, whose cells do not matter.
  //
  // All sites move at once: the cells are those of the sites before, whatever is written to `sites` meanwhile. Builds
  // the diagram if that is not done. Takes time linear in the size of the mesh and of the diagram.
  template <typename IsFixed>
  bool move_to_centers(std::vector<vertex_descriptor>& sites, IsFixed is_fixed) const
  {
    CGAL_assertion(m_number_of_curves + sites.size() == m_diagram.number_of_sites());
    std::vector<Point> center;
    for(std::size_t i = 0; i < sites.size(); ++i)
      center.push_back(m_diagram.centroid(m_number_of_curves + i));
    std::vector<double> smallest(sites.size(), std::numeric_limits<double>::infinity());
    const std::vector<vertex_descriptor> before = sites;
    for(vertex_descriptor v : vertices(m_tm))
    {
      const std::size_t number = m_diagram.nearest_site(v);
      if(number == Diagram::null_site() || number < m_number_of_curves)
        continue;
      const std::size_t i = number - m_number_of_curves;
      if(is_fixed(before[i]))
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

  // Returns the largest distance in space between a vertex and the one at the same position of the other range.
  double largest_move(const std::vector<vertex_descriptor>& before, const std::vector<vertex_descriptor>& after) const
  {
    double largest = 0;
    for(std::size_t i = 0; i < before.size(); ++i)
      if(before[i] != after[i])
        largest = (std::max)(largest, distance_in_space<Point>(get(m_vpm, before[i]), get(m_vpm, after[i])));
    return largest;
  }

private:
  const TriangleMesh& m_tm;
  VertexPointMap m_vpm;
  Diagram m_diagram;
  std::size_t m_number_of_curves = 0;
};

// A diagram without sites, with the maps among the named parameters. Reads nothing yet: the first build reads the mesh.
template <template <typename...> class Diagram, typename ConcurrencyTag, typename TriangleMesh,
          typename NamedParameters>
auto make_vertex_site_diagram(const TriangleMesh& tm, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto him = CGAL::get_initialized_halfedge_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                              get_const_property_map(CGAL::vertex_point, tm));
  return Vertex_site_diagram<Diagram, ConcurrencyTag, TriangleMesh, decltype(vim), decltype(him), decltype(fim),
                             decltype(vpm)>(tm, vim, him, fim, vpm);
}

// Moves sites to the centers of their cells until no site moves farther than a threshold, the visitor cancels, or the
// largest number of iterations is reached. Returns the number of iterations that moved a site. If the visitor cancels,
// the sites are those of the iteration before. Throws Invalid_geodesic_input from the first iteration, before a site
// has moved.
//
// With the threshold 0 the loop need not end by itself, as a site may go back and forth between two vertices; so the
// number of iterations is bounded. Each one takes the time of a diagram. The step never raises the energy for the cells
// that it starts from: among the vertices of a cell, the nearest one to the centroid has the smallest integral of
// squared distances, because that is the integral for the centroid plus the area times the squared distance from the
// centroid. The next cells may raise it, as they are those of geodesic distances, and as cells may grow at the expense
// of those of curves, which are not counted.
//
// Sites with is_fixed(v) do not move, as if they were central. The visitor is asked between the steps of an iteration,
// too: centroids and the energy of large meshes take long.
template <template <typename...> class Diagram, typename ConcurrencyTag, typename TriangleMesh,
          typename vertex_descriptor, typename Visitor, typename NamedParameters, typename IsFixed>
std::size_t relax_sites(const TriangleMesh& tm, std::vector<vertex_descriptor>& sites,
                        std::size_t number_of_iterations, Visitor& visitor, const NamedParameters& np, IsFixed is_fixed)
{
  const double threshold = number_parameter(np, internal_np::threshold_distance, 0.);
  CGAL_precondition_msg(threshold >= 0, "the threshold of a distance is negative, or no number");
  auto diagram = make_vertex_site_diagram<Diagram, ConcurrencyTag>(tm, np);
  if constexpr(Has_parameter<NamedParameters, internal_np::faces_to_avoid_t>::value)
    diagram.avoid_faces(parameters::get_parameter_reference(np, internal_np::faces_to_avoid));
  if constexpr(Has_parameter<NamedParameters, internal_np::edges_to_avoid_t>::value)
    diagram.avoid_edges(parameters::get_parameter_reference(np, internal_np::edges_to_avoid));
  std::size_t i = 0;
  for(; i < number_of_iterations; ++i)
  {
    if constexpr(Has_parameter<NamedParameters, internal_np::first_curves_t>::value)
      diagram.set_sites(curves_parameter(np), sites);
    else
      diagram.set_sites(sites);
    if(!diagram.diagram().build(visitor) || !visitor.go_further())
      break;
    const std::vector<vertex_descriptor> before = sites;
    const bool has_moved = diagram.move_to_centers(sites, is_fixed);
    const double largest_move = diagram.largest_move(before, sites);
    if(!visitor.go_further()) // the energy of large meshes takes as long as the centroids
    {
      sites = before;
      break;
    }
    if constexpr(Follows_iterations<Visitor>::value)
      visitor.on_iteration(i + 1, largest_move, diagram.diagram().energy());
    if(!has_moved)
      break;
    if(largest_move <= threshold && threshold > 0)
      return i + 1;
  }
  return i;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_LLOYD_RELAXATION_H
