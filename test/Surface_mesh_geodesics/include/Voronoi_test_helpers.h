#ifndef SURFACE_MESH_GEODESICS_VORONOI_TEST_HELPERS_H
#define SURFACE_MESH_GEODESICS_VORONOI_TEST_HELPERS_H

// All checks of a geodesic Voronoi diagram: against distances from one site at a time, and of its combinatorics.

#include "Voronoi_distance_checks.h"
#include "Voronoi_sites.h"
#include "Voronoi_structure_checks.h"
#include "test_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_meshes {

class Voronoi_validator
{
public:
  // `diagram` has the given sites, and uses `lengths` unless that is nullptr.
  Voronoi_validator(const Mesh& tm, const Voronoi& diagram, const Weighted_sites& sites,
                    const Edge_lengths* lengths = nullptr, bool compares_with_shortest_path = false)
    : m_distance_checks(tm, diagram, sites, lengths, compares_with_shortest_path),
      m_structure_checks(tm, diagram, sites)
  {}

  void check_all(test_support::Random& random, std::size_t number_of_points)
  {
    m_distance_checks.check_sites();
    m_distance_checks.check_points(random, number_of_points);
    m_distance_checks.check_arcs();
    m_distance_checks.check_vertices();
    m_distance_checks.check_areas();
    m_structure_checks.check_locations_of_vertices();
    m_structure_checks.check_edges();
    m_structure_checks.check_boundaries();
    m_structure_checks.check_joints();
    m_structure_checks.check_connected_cells();
    m_structure_checks.check_Euler();
  }

  Distances_of_sites& distances() { return m_distance_checks.distances(); }

private:
  Voronoi_distance_checks m_distance_checks;
  Voronoi_structure_checks m_structure_checks;
};

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_VORONOI_TEST_HELPERS_H
