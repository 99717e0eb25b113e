#ifndef SURFACE_MESH_GEODESICS_EXACT_DISTANCES_H
#define SURFACE_MESH_GEODESICS_EXACT_DISTANCES_H

// Comparison with distances that are known for any two points of a surface.

#include "distance_test_helpers.h"
#include "test_meshes.h"
#include "test_support.h"

#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace test_meshes {

using Exact_distance = std::function<double(const Coordinates&, const Coordinates&)>;

// Returns the distances of all vertices from a point.
inline std::vector<double> expected_field(const Mesh& tm, const Coordinates& source, const Exact_distance& exact)
{
  std::vector<double> result;
  for(const vertex_descriptor v : vertices(tm))
  {
    result.push_back(exact(source, coordinates(v, tm)));
  }
  return result;
}

// Checks random sources at vertices, in faces and on edges; those on edges as locations in both faces.
inline void sources_agree_with(const Mesh& tm, const Exact_distance& exact, std::size_t number, double tolerance,
                               test_support::Random& random)
{
  std::vector<Mesh::Halfedge_index> all_halfedges(halfedges(tm).begin(), halfedges(tm).end());
  for(std::size_t i = 0; i < number; ++i)
  {
    const vertex_descriptor v = random_vertex(tm, random);
    CHECK_FIELDS_CLOSE(distances(tm, v), expected_field(tm, coordinates(v, tm), exact), tolerance);

    const Face_location location = random_location(tm, random);
    CHECK_FIELDS_CLOSE(distances(tm, location), expected_field(tm, coordinates(location, tm), exact), tolerance);

    const auto h = all_halfedges[random.index(all_halfedges.size())];
    const double t = i % 2 == 0 ? random.uniform(.01, .99) : std::array<double, 3>{.25, .5, .75}[i / 2 % 3];
    for(const auto& side : {std::make_pair(h, t), std::make_pair(opposite(h, tm), 1. - t)})
    {
      if(!is_border(side.first, tm))
      {
        const Face_location edge_location = location_on_halfedge(side.first, side.second, tm);
        CHECK_FIELDS_CLOSE(distances(tm, edge_location), expected_field(tm, coordinates(edge_location, tm), exact),
                           tolerance);
      }
    }
  }
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_EXACT_DISTANCES_H
