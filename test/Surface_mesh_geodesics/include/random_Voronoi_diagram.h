#ifndef SURFACE_MESH_GEODESICS_RANDOM_VORONOI_DIAGRAM_H
#define SURFACE_MESH_GEODESICS_RANDOM_VORONOI_DIAGRAM_H

// All checks of one small random diagram, with a random mesh, random sites and random weights.

#include "Voronoi_test_helpers.h"

#include <cstdint>
#include <string>

namespace test_meshes {

inline Indexed_mesh random_mesh(test_support::Random& random)
{
  const std::uint64_t seed = random.index(1000000);
  switch(random.index(16))
  {
  case 0: return irregular_tetrahedron();
  case 1: return midpoint_subdivision(regular_tetrahedron());
  case 2: return octahedron();
  case 3: return cube_grid(1 + random.index(3));
  case 4: return noisy_sphere(1, .2, seed);
  case 5: return jittered(torus(1., .4, 8, 5), .1, seed);
  case 6: return torus(1., .5, 6, 4);
  case 7: return jittered(genus_2_polycube(), .15, seed);
  case 8: return rough_terrain(5, random.uniform(.2, 4.), seed);
  case 9: return flat_patch(5, 4, .3, true, seed);
  case 10: return square_with_holes(1);
  case 11: return random_cuts(noisy_sphere(1, .2, seed), .2, seed + 1);
  case 12: return tetrahedral_ogre(5 + random.index(15), seed);
  case 13: return needle_sphere(9 + random.index(9), 3);
  case 14: return saddle_fan(8);
  default: return prism_tube(3 + random.index(4), 3, 1., 4., random.uniform(0., 2.));
  }
}

inline double longest_edge(const Mesh& tm)
{
  double size = 0.;
  for(const Mesh::Edge_index e : edges(tm))
  {
    const auto h = halfedge(e, tm);
    size = (std::max)(size, length(coordinates(source(h, tm), tm) - coordinates(target(h, tm), tm)));
  }
  return size;
}

inline void check_random_diagram(std::uint64_t seed)
{
  test_support::Random random(seed);
  const Indexed_mesh indexed = random_mesh(random);
  test_support::Scope scope("case " + std::to_string(seed) + ": " + indexed.name);
  const Mesh tm = to_face_graph(indexed);
  const std::size_t number = 1 + random.index(random.index(4) == 0 ? 16 : 6);
  const double weight = random.index(2) == 0 ? 0. : random.uniform(.05, 1.) * longest_edge(tm);
  const Weighted_sites sites = random_sites(tm, number, weight, random);
  Voronoi diagram(tm);
  add_sites(diagram, sites);
  Voronoi_validator(tm, diagram, sites).check_all(random, 10);
}

} // namespace test_meshes

#endif // SURFACE_MESH_GEODESICS_RANDOM_VORONOI_DIAGRAM_H
