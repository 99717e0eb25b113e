// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_LABELS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_LABELS_H

// The nearest site of each vertex without a diagram: one propagation of distances, which keeps no windows and makes no
// arcs. The nearest site is found along the shortest path: each vertex knows the vertex where its path bends last.
//
// Formula: as for a diagram (Weighted_site_list.h), a propagation starts at each site with the difference W - w from
// the largest weight W, and W is subtracted from all distances at the end.

#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Weighted_site_list.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A map of distances that nobody has asked for: put() does nothing.
template <typename Key>
struct No_distance_map
{
  using key_type = Key;
  using value_type = double;
  using reference = double;
  using category = boost::writable_property_map_tag;

  friend void put(const No_distance_map&, const Key&, double) {}
};

// Writes distances less the largest weight to the map of the user. Infinity stays infinity. A smaller type of the user
// is rounded to after the subtraction.
template <typename Map>
struct Distance_map_less_weight
{
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = double;
  using reference = double;
  using category = boost::writable_property_map_tag;

  Map map;
  double largest_weight;

  friend void put(const Distance_map_less_weight& m, const key_type& key, double distance)
  {
    put(m.map, key, static_cast<typename boost::property_traits<Map>::value_type>(distance - m.largest_weight));
  }
};

// The weights of sites as offsets. Both functions take linear time. The list of sites is used without its places, for
// its checks and its messages.
class Offsets_of_weights
{
public:
  // Throws Invalid_geodesic_input if a weight, or its difference from the largest one, is not finite.
  explicit Offsets_of_weights(const std::vector<double>& weights)
  {
    for(const double w : weights)
      m_sites.add({false, No_place(), No_place(), w});
    const double no_limit = std::numeric_limits<double>::infinity(); // the solver has one, in the unit of the mesh
    m_sites.for_each_offset(no_limit, [this](const auto&, double offset) { m_offsets.push_back(offset); });
  }

  const std::vector<double>& offsets() const { return m_offsets; }
  double largest_weight() const { return m_sites.largest_weight(); }

private:
  struct No_place
  {};

  Weighted_site_list<No_place, No_place, double> m_sites;
  std::vector<double> m_offsets;
};

// Writes the number of the nearest site of each vertex, and its distance if a map for it is among the parameters, as
// geodesic_Voronoi_labels() documents. Throws, and returns false, before a map has changed. The map of sites takes the
// place of the map of nearest sources: the sites are sources, numbered in the same way.
template <typename ConcurrencyTag, typename TriangleMesh, typename SiteMap, typename Sites, typename NamedParameters>
bool compute_Voronoi_labels(const TriangleMesh& tm, SiteMap site_map, const Sites& sites, const NamedParameters& np)
{
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Label = typename Value_of_map<SiteMap, Vertex>::type;
  static_assert(std::is_integral<Label>::value,
                "labels cannot be written to this argument; it is a property map from the vertices of the mesh to "
                "integers, and comes before the sites");
  if constexpr(std::is_integral<Label>::value)
    static_assert(holds_numbers_of_sources<Label>, "the labels are not integers of at least 32 bits");
  auto distance_map = map_parameter<Vertex, double, No_distance_map<Vertex>>(np, internal_np::vertex_distance_map);
  const Offsets_of_weights from_weights(range_parameter<double>(np, internal_np::site_weights));
  const Distance_options<TriangleMesh, SiteMap> options{
    std::numeric_limits<double>::infinity(), {}, from_weights.offsets(), site_map, statistics_parameter(np)};
  Visitor_parameter<NamedParameters> visitor_parameter(np);
  auto& visitor = visitor_parameter.visitor();
  return compute_geodesic_distances<ConcurrencyTag>(
    tm, Distance_map_less_weight<decltype(distance_map)>{distance_map, from_weights.largest_weight()}, sites, options,
    shape_from_points<double>(tm, np), visitor, np);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_VORONOI_LABELS_H
